//! Direct current in a round wire that is wound: densest inside, where its way round is shortest.
//!
//! Next door: the field of a thin ring (`field`), what the wire's surface adds (`surface`).

use std::f64::consts::{PI, TAU};

use super::field::{Point, field, potential};
use crate::quadrature::unit_points;

/// A turn of wire: a disc that is turned about the axis. Its own place along the axis is zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Disc {
    /// From the axis to the wire's middle \[m\].
    pub coil: f64,
    /// \[m\].
    pub wire: f64,
    /// What a turn goes on by along the axis \[m\].
    pub pitch: f64,
    /// What makes the current one ampere.
    scale: f64,
}

/// A point with the current about it.
pub(super) type Part = (Point, f64);

/// Directions about the middle.
const ROUND: usize = 16;
/// Directions above the plane of symmetry.
const ABOVE: usize = 4;
/// Directions about a point inside.
const ABOUT: usize = 32;

/// Diameters of the wire from which a turn is coarse.
const FINE: f64 = 2.5;
/// Diameters up to which it takes two panels of rays and of points along each.
const NEXT: f64 = 2.0;

impl Disc {
    pub fn new(coil: f64, wire: f64, pitch: f64) -> Self {
        let bare = Self { coil, wire, pitch, scale: 1.0 };
        let current: f64 = bare.parts().map(|(_, current)| current).sum();
        Self { scale: 1.0 / current, ..bare }
    }

    /// Current density \[1/m²\] for one ampere: the same voltage a turn over a turn's way.
    fn density(&self, r: f64) -> f64 {
        self.scale / (TAU * r).hypot(self.pitch)
    }

    /// A point of it by its place from the middle.
    pub fn point(&self, (sine, cosine): (f64, f64), from_middle: f64) -> Point {
        Point { r: self.coil + from_middle * cosine, z: from_middle * sine }
    }

    /// All of it, fine enough for what is no wire's diameter away.
    fn parts(&self) -> impl Iterator<Item = Part> {
        unit_points(1).flat_map(move |(place, weight)| {
            let from_middle = place * self.wire;
            (0..ROUND).map(move |direction| {
                let point = self.point((TAU * direction as f64 / ROUND as f64).sin_cos(), from_middle);
                let area = weight * self.wire * from_middle * TAU / ROUND as f64;
                (point, area * self.density(point.r))
            })
        })
    }

    /// The same for what is several diameters away: exact for polynomials of degree 5, `[Abramowitz1964]` 25.4.61.
    fn coarse_parts(&self) -> [Part; 7] {
        let area = PI * self.wire * self.wire;
        let around = (2.0_f64 / 3.0).sqrt() * self.wire;
        let parts: [Part; 7] = std::array::from_fn(|number| match number {
            0 => (self.point((0.0, 1.0), 0.0), 0.25 * area),
            _ => (self.point((PI / 3.0 * number as f64).sin_cos(), around), 0.125 * area),
        });
        parts.map(|(point, area)| (point, area * self.density(point.r)))
    }

    /// A/μ₀ and B/μ₀ at a point on its edge or outside, by rays from there: along each the distance cancels what grows as its inverse.
    fn seen_from(&self, at: Point, panels: usize) -> (f64, [f64; 2]) {
        let (across, along) = (self.coil - at.r, -at.z);
        let distance = across.hypot(along).max(self.wire);
        let towards = along.atan2(across);
        let share = self.wire / distance;
        let (mut potentials, mut fields) = (0.0, [0.0; 2]);
        for (place, weight) in unit_points(panels) {
            let (sine, cosine) = ((place - 0.5) * PI).sin_cos();
            // On the edge the angle off the middle is that angle itself.
            let off = (share * sine).asin();
            let width = if share < 1.0 { share * cosine / (1.0 - (share * sine).powi(2)).sqrt() } else { 1.0 };
            let (middle, half) = (distance * off.cos(), self.wire * cosine);
            let (up, out) = (towards + off).sin_cos();
            for (place, of_ray) in unit_points(panels) {
                let away = middle + half * (2.0 * place - 1.0);
                let source = Point { r: at.r + away * out, z: at.z + away * up };
                let current = PI * weight * width * 2.0 * half * of_ray * away * self.density(source.r);
                potentials += current * potential(source, at);
                let [r, z] = field(source, at);
                fields = [fields[0] + current * r, fields[1] + current * z];
            }
        }
        (potentials, fields)
    }

    /// The same of all of it but for A only, from a point inside.
    fn potential_inside(&self, (sine, cosine): (f64, f64), from_middle: f64) -> f64 {
        let at = self.point((sine, cosine), from_middle);
        let mut sum = 0.0;
        for direction in 0..ABOUT {
            let (up, out) = (TAU * direction as f64 / ABOUT as f64).sin_cos();
            let along = -from_middle * (out * cosine + up * sine);
            let aside = from_middle * (out * sine - up * cosine);
            let to_edge = along + (self.wire * self.wire - aside * aside).max(0.0).sqrt();
            for (place, weight) in unit_points(1) {
                // Points gather at its begin, where the potential grows without bound.
                let away = to_edge * place * place;
                let source = Point { r: at.r + away * out, z: at.z + away * up };
                let area = to_edge * 2.0 * place * weight * away * TAU / ABOUT as f64;
                sum += area * self.density(source.r) * potential(source, at);
            }
        }
        sum
    }

    /// ∬ j M j of its own current over μ₀ \[m\].
    pub fn own_inductance(&self) -> f64 {
        let mut sum = 0.0;
        for (place, weight) in unit_points(1) {
            let from_middle = place * self.wire;
            for direction in 0..ABOVE {
                // Half a step off the plane of symmetry, above which all is as below.
                let turn = (PI * (direction as f64 + 0.5) / ABOVE as f64).sin_cos();
                let r = self.point(turn, from_middle).r;
                let area = 2.0 * weight * self.wire * from_middle * PI / ABOVE as f64;
                sum += TAU * r * area * self.density(r) * self.potential_inside(turn, from_middle);
            }
        }
        sum
    }

    /// ∬ j M j of two of them, so far apart along the axis, over μ₀ \[m\].
    fn mutual_inductance(&self, apart: f64, near: bool) -> f64 {
        let linked =
            |(at, current): Part, (source, own): Part| TAU * at.r * current * own * potential(source, at.moved(apart));
        if !near {
            let parts = self.coarse_parts();
            return parts.iter().flat_map(|&at| parts.map(|source| linked(at, source))).sum();
        }
        let parts: Vec<Part> = self.parts().collect();
        let mirrored = |part: usize| part / ROUND * ROUND + (ROUND - part % ROUND) % ROUND;
        let mut sum = 0.0;
        for (number, &at) in parts.iter().enumerate() {
            // A mirror between the turns shows each pair once more.
            for (other, &source) in parts.iter().enumerate().filter(|(other, _)| mirrored(*other) >= number) {
                let times = if mirrored(other) == number { 1.0 } else { 2.0 };
                sum += times * linked(at, source);
            }
        }
        sum
    }

    /// ∬ j M j of a turn and one so many turns after it that stands so far along the axis \[m\], over μ₀ \[m\].
    pub fn linked_at(&self, lag: usize, apart: f64) -> f64 {
        self.mutual_inductance(apart, lag as f64 * self.pitch < FINE * 2.0 * self.wire)
    }

    /// A/μ₀ and B/μ₀ at points on the edge of a turn so many turns after it that stands so far along the axis \[m\]. How finely that is taken goes by the turns,
    /// so that it does not change where one moves.
    pub fn seen_along(&self, at: Point, lag: usize, apart: f64) -> (f64, [f64; 2]) {
        let at = at.moved(apart);
        match lag as f64 * self.pitch / (2.0 * self.wire) {
            diameters if diameters < NEXT => self.seen_from(at, 2),
            diameters if diameters < 2.0 * FINE => self.seen_from(at, 1),
            _ => self.coarse_parts().iter().fold((0.0, [0.0; 2]), |(sum, [r, z]), &(source, current)| {
                let own = field(source, at);
                (sum + current * potential(source, at), [r + current * own[0], z + current * own[1]])
            }),
        }
    }
}
