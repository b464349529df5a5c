//! A coil wound in sections: pitch and diameter may change along each, so that it gets stiffer as windings close.
//!
//! Next door: the chain that stands for it (`chain`), what happens when windings close fast (`follow`).

use std::f64::consts::PI;

use super::chain::{Chain, Pair};
use crate::error::{Error, above_zero, at_least_one, check, entry, from_zero};
use crate::mount::FarEnd;
use crate::quadrature::panel;

/// One stretch of a coil; what has two values changes evenly from its end towards end 1 to its end towards end 2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// How many windings \[1\]; a part of one counts.
    pub windings: f64,
    /// Unloaded, centre to centre \[m\].
    pub pitch: [f64; 2],
    /// Mean diameter of the coil \[m\].
    pub coil_diameter: [f64; 2],
    /// \[m\].
    pub wire_diameter: f64,
    /// Whether a winding goes inside the next: it then closes where its pitch is used up, else where wires meet.
    pub telescopes: bool,
}

/// A coil of sections, from end 1 on, checked.
///
/// ```
/// use coilsense::contact::{Section, Sections};
/// // A cone whose windings go into one another: gets stiffer from 317.2 N on.
/// let cone = Section { windings: 5.0, pitch: [8e-3; 2], coil_diameter: [40e-3, 20e-3], wire_diameter: 4e-3, telescopes: true };
/// let coil = Sections::new(vec![cone], 79.3e9, 7850.0)?;
/// assert!((coil.stiffness() - 16917.33).abs() < 0.01);
/// assert!((coil.first_closing() - 317.2).abs() < 1e-9);
/// assert!((coil.compression(600.0)? - 29.120279e-3).abs() < 1e-9);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Sections {
    sections: Vec<Section>,
    shear_modulus: f64,
    density: f64,
}

/// Rounding of a compression, relative.
const ROUNDING: f64 = 1e-15;

impl Sections {
    /// - `shear_modulus`: G \[Pa\]; `density`: \[kg/m³\]
    ///
    /// # Errors
    /// [`Error::Count`] for no section; [`Error::Value`] for what is not above zero, and for a pitch below the wire of a section whose windings
    /// do not go inside one another.
    pub fn new(sections: Vec<Section>, shear_modulus: f64, density: f64) -> Result<Self, Error> {
        at_least_one("sections", sections.len())?;
        let is_stiff = shear_modulus.is_finite() && shear_modulus > 0.0;
        check(is_stiff, "shear_modulus", shear_modulus, "Pa", "above zero and finite")?;
        above_zero("density", density, "kg/m³")?;
        for (index, section) in sections.iter().enumerate() {
            above_zero(entry("windings", index), section.windings, "")?;
            above_zero(entry("wire_diameter", index), section.wire_diameter, "m")?;
            for end in 0..2 {
                from_zero(entry("pitch", index), section.pitch[end], "m")?;
                let wide = section.coil_diameter[end] > section.wire_diameter;
                let allowed = format!("above the wire's {} m", section.wire_diameter);
                check(wide, entry("coil_diameter", index), section.coil_diameter[end], "m", allowed)?;
                let allowed =
                    format!("at least the wire's {} m, where windings do not telescope", section.wire_diameter);
                let fits = section.telescopes || section.pitch[end] >= section.wire_diameter * (1.0 - 1e-12);
                check(fits, entry("pitch", index), section.pitch[end], "m", allowed)?;
            }
        }
        Ok(Self { sections, shear_modulus, density })
    }

    /// All windings \[1\].
    pub fn windings(&self) -> f64 {
        self.sections.iter().map(|section| section.windings).sum()
    }

    /// Length of the unloaded coil from the wire's centre at one end to that at the other \[m\].
    pub fn span(&self) -> f64 {
        self.sections.iter().map(|section| section.windings * 0.5 * (section.pitch[0] + section.pitch[1])).sum()
    }

    /// Mass of the wire \[kg\].
    pub fn mass(&self) -> f64 {
        self.mass_between(0.0, self.windings())
    }

    /// Stiffness while all windings are open \[N/m\].
    pub fn stiffness(&self) -> f64 {
        1.0 / self.compliance_between(0.0, self.windings())
    }

    /// Force at which the first winding closes \[N\]; zero where some are closed already.
    pub fn first_closing(&self) -> f64 {
        self.closing(f64::min, f64::INFINITY)
    }

    /// Force at which all are closed \[N\].
    pub fn solid_force(&self) -> f64 {
        self.closing(f64::max, 0.0)
    }

    /// The same of an end of each section, or of the place where gap over compliance turns.
    fn closing(&self, of: fn(f64, f64) -> f64, start: f64) -> f64 {
        let each = self.sections.iter().flat_map(|section| {
            let (gap, compliance) = (section.gap(), section.compliance(self.shear_modulus));
            // (g/c)' = 0 where g' c = g c'.
            let turns = roots(&difference(&product(&rate(&gap), &compliance), &product(&gap, &rate(&compliance))));
            let places = turns.into_iter().chain([0.0, 1.0]);
            places.map(move |place| value(&gap, place) / value(&compliance, place)).collect::<Vec<f64>>()
        });
        each.fold(start, of)
    }

    /// By how much a force \[N\] shortens the coil at rest \[m\].
    ///
    /// x(F) = ∫ min(F c, g) dn, c = 64 R³/(G d⁴) a winding's compliance, g its gap
    ///
    /// Source:   a winding in shear; closed ones give no further.
    /// Valid:    round wire, windings not steep; nothing of the wire's own curvature (`[Wahl1963]`).
    /// Accuracy: rounding: polynomials, integrated between the places where windings are just closed.
    ///
    /// # Errors
    /// [`Error::Value`] for a force below zero.
    pub fn compression(&self, force: f64) -> Result<f64, Error> {
        from_zero("force", force, "N")?;
        Ok(self.sections.iter().map(|section| section.compression(force, self.shear_modulus)[0]).sum())
    }

    /// The force that shortens it by `compression` \[m\], in \[N\].
    ///
    /// # Errors
    /// [`Error::Value`] for a compression below zero or above that at which all windings are closed.
    pub fn force(&self, compression: f64) -> Result<f64, Error> {
        let solid = self.solid_force();
        let most = self.compression(solid)?;
        let fits = (0.0..=most).contains(&compression);
        check(fits, "compression", compression, "m", format!("from 0 to {most} m, where all windings are closed"))?;
        let (mut low, mut high) = (0.0, solid);
        let mut force = (compression * self.stiffness()).min(solid);
        for _ in 0..200 {
            let [x, softness] = self.compressed(force);
            if x < compression {
                low = force
            } else {
                high = force
            }
            let newton = force - (x - compression) / softness;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - force).abs() <= ROUNDING * solid {
                return Ok(next);
            }
            force = next;
        }
        Ok(force)
    }

    /// Stiffness at a force \[N/m\]; infinite where all windings are closed.
    ///
    /// # Errors
    /// [`Error::Value`] for a force below zero.
    pub fn rate(&self, force: f64) -> Result<f64, Error> {
        from_zero("force", force, "N")?;
        Ok(1.0 / self.compressed(force)[1])
    }

    /// Compression \[m\] and its growth with force \[m/N\].
    fn compressed(&self, force: f64) -> [f64; 2] {
        self.sections.iter().fold([0.0; 2], |[x, softness], section| {
            let [more, soft] = section.compression(force, self.shear_modulus);
            [x + more, softness + soft]
        })
    }

    /// The chain that stands for it with both ends' positions prescribed: about `masses_per_winding` equal stretches a winding, a mass in the
    /// middle of each; a mass meets the one a winding further on.
    ///
    /// # Errors
    /// [`Error::Value`] for no mass per winding.
    pub fn chain(&self, masses_per_winding: usize) -> Result<Chain, Error> {
        at_least_one("masses_per_winding", masses_per_winding)?;
        let windings = self.windings();
        let lumps = ((windings * masses_per_winding as f64).round() as usize).max(1);
        let width = windings / lumps as f64;
        let middle = |lump: usize| (lump as f64 + 0.5) * width;
        let masses = (0..lumps).map(|lump| self.mass_between(lump as f64 * width, (lump + 1) as f64 * width)).collect();
        let mut places: Vec<f64> = (0..lumps).map(middle).collect();
        places.insert(0, 0.0);
        places.push(windings);
        let stiffnesses =
            places.windows(2).map(|pair| 1.0 / self.compliance_between(pair[0], pair[1])).collect::<Vec<f64>>();
        let apart = masses_per_winding;
        let of_class = |class: usize| (class..=lumps).step_by(apart).zip((class + apart..=lumps).step_by(apart));
        let pair = |(first, second): (usize, usize)| {
            let gap =
                self.between(places[first], places[second], |section, from, to| integral(&section.gap(), from, to));
            Pair { first, second, gap: gap.max(0.0) }
        };
        let pairs = (1..=apart).flat_map(of_class).map(pair).collect();
        Ok(Chain::trusted(masses, stiffnesses, pairs, FarEnd::Position))
    }

    fn compliance_between(&self, from: f64, to: f64) -> f64 {
        self.between(from, to, |section, from, to| integral(&section.compliance(self.shear_modulus), from, to))
    }

    fn mass_between(&self, from: f64, to: f64) -> f64 {
        self.between(from, to, |section, from, to| {
            let area = 0.25 * PI * section.wire_diameter * section.wire_diameter;
            let wire = |place: f64| (PI * at(section.coil_diameter, place)).hypot(at(section.pitch, place));
            self.density * area * panel(from, to, wire)
        })
    }

    /// A sum over windings `from` to `to` of what a section has between two of its places, 0 to 1, times its windings.
    fn between(&self, from: f64, to: f64, of: impl Fn(&Section, f64, f64) -> f64) -> f64 {
        let mut begin = 0.0;
        let mut sum = 0.0;
        for section in &self.sections {
            let end = begin + section.windings;
            let (low, high) = (from.max(begin), to.min(end));
            if high > low {
                let place = |winding: f64| (winding - begin) / section.windings;
                sum += section.windings * of(section, place(low), place(high));
            }
            begin = end;
        }
        sum
    }
}

impl Section {
    /// c of a winding over its place from 0 to 1 \[m/N\]: 8 D³/(G d⁴).
    fn compliance(&self, shear_modulus: f64) -> Polynomial {
        let [first, last] = self.coil_diameter;
        let line = [first, last - first, 0.0, 0.0, 0.0];
        let factor = 8.0 / (shear_modulus * self.wire_diameter.powi(4));
        product(&product(&line, &line), &line).map(|value| factor * value)
    }

    /// How far a winding is from closing \[m\].
    fn gap(&self) -> Polynomial {
        let closed = if self.telescopes { 0.0 } else { self.wire_diameter };
        [self.pitch[0] - closed, self.pitch[1] - self.pitch[0], 0.0, 0.0, 0.0]
    }

    /// Under a force: compression \[m\], and its growth with the force \[m/N\].
    fn compression(&self, force: f64, shear_modulus: f64) -> [f64; 2] {
        let (gap, compliance) = (self.gap(), self.compliance(shear_modulus));
        let pressed = compliance.map(|value| force * value);
        let mut places = roots(&difference(&pressed, &gap));
        places.insert(0, 0.0);
        places.push(1.0);
        places.windows(2).fold([0.0; 2], |[x, softness], pair| {
            let middle = 0.5 * (pair[0] + pair[1]);
            let (is_open, windings) = (value(&pressed, middle) < value(&gap, middle), self.windings);
            if is_open {
                let soft = windings * integral(&compliance, pair[0], pair[1]);
                [x + force * soft, softness + soft]
            } else {
                [x + windings * integral(&gap, pair[0], pair[1]), softness]
            }
        })
    }
}

/// Of a place from 0 to 1, lowest power first.
type Polynomial = [f64; 5];

fn at([first, last]: [f64; 2], place: f64) -> f64 {
    first + place * (last - first)
}

fn value(p: &Polynomial, place: f64) -> f64 {
    p.iter().rev().fold(0.0, |sum, coefficient| sum * place + coefficient)
}

fn rate(p: &Polynomial) -> Polynomial {
    [p[1], 2.0 * p[2], 3.0 * p[3], 4.0 * p[4], 0.0]
}

fn difference(p: &Polynomial, q: &Polynomial) -> Polynomial {
    std::array::from_fn(|power| p[power] - q[power])
}

/// The product, which is of no higher power than the fourth.
fn product(p: &Polynomial, q: &Polynomial) -> Polynomial {
    std::array::from_fn(|power| (0..=power).map(|first| p[first] * q[power - first]).sum())
}

fn integral(p: &Polynomial, from: f64, to: f64) -> f64 {
    let sum = |place: f64| {
        p.iter().enumerate().rev().fold(0.0, |sum, (power, value)| sum * place + value / (power + 1) as f64) * place
    };
    sum(to) - sum(from)
}

/// Where it crosses zero between 0 and 1, ascending: halved between the places at which it turns.
fn roots(p: &Polynomial) -> Vec<f64> {
    if p[1..].iter().all(|coefficient| *coefficient == 0.0) {
        return Vec::new();
    }
    let mut turns = roots(&rate(p));
    turns.insert(0, 0.0);
    turns.push(1.0);
    let crosses = |pair: &&[f64]| (value(p, pair[0]) < 0.0) != (value(p, pair[1]) < 0.0);
    let root = |pair: &[f64]| {
        let (mut low, mut high) = (pair[0], pair[1]);
        let begins_below = value(p, low) < 0.0;
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if (value(p, middle) < 0.0) == begins_below { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    };
    turns.windows(2).filter(crosses).map(root).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_winding_in_shear() {
        // k = G d⁴/(8 D³ n), m = ρ π d²/4 · n √((πD)² + p²).
        let section = Section {
            windings: 4.0,
            pitch: [9e-3; 2],
            coil_diameter: [25e-3; 2],
            wire_diameter: 4e-3,
            telescopes: false,
        };
        let coil = Sections::new(vec![section], 79.3e9, 7850.0).unwrap();
        let stiffness = 79.3e9 * 4e-3_f64.powi(4) / (8.0 * 25e-3_f64.powi(3) * 4.0);
        assert!((coil.stiffness() / stiffness - 1.0).abs() < 1e-14);
        let mass = 7850.0 * 0.25 * PI * 16e-6 * 4.0 * (PI * 25e-3).hypot(9e-3);
        assert!((coil.mass() / mass - 1.0).abs() < 1e-14);
        assert!((coil.solid_force() / (stiffness * 4.0 * 5e-3) - 1.0).abs() < 1e-14);
        assert!((coil.first_closing() / coil.solid_force() - 1.0).abs() < 1e-14);
    }
}
