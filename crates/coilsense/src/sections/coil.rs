//! A coil of sections at rest: its static curve by closed forms.
//!
//! Next door: the curve as a table (`curve`), masses and springs (`lumps`), stress (`stress`).

use std::f64::consts::PI;

use super::curve::Curve;
use super::polynomial::{Polynomial, at, difference, integral, product, rate, roots, value};
use crate::error::{Error, above_zero, at_least_one, check, entry, from_zero};
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
/// use coilsense::sections::{Section, Sections};
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
    pub(super) sections: Vec<Section>,
    pub(super) shear_modulus: f64,
    density: f64,
    curve: Curve,
    /// ω_1 of the open coil with both ends held \[rad/s\].
    pub(super) first: f64,
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
        let mut coil = Self { sections, shear_modulus, density, curve: Curve::default(), first: 0.0 };
        let solid = coil.solid_force();
        check(solid > 0.0, "pitch", coil.span(), "m", "above the wire's diameter somewhere: this coil is solid")?;
        let [solid, stiffness] = [coil.solid_force(), coil.stiffness()];
        coil.curve = Curve::of(coil.knees(), solid, stiffness, |force| coil.compressed(force));
        coil.first = coil.first_frequency_at(-1.0).unwrap_or(f64::INFINITY);
        Ok(coil)
    }

    /// The sections, from end 1 on.
    pub fn sections(&self) -> &[Section] {
        &self.sections
    }

    /// G \[Pa\].
    pub fn shear_modulus(&self) -> f64 {
        self.shear_modulus
    }

    /// \[kg/m³\].
    pub fn density(&self) -> f64 {
        self.density
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

    fn closing(&self, of: fn(f64, f64) -> f64, start: f64) -> f64 {
        self.closings().fold(start, of)
    }

    /// Forces at which a section begins to close, has closed, or turns from one to the other, ascending \[N\]: between them the static curve is
    /// smooth.
    pub fn knees(&self) -> Vec<f64> {
        let mut knees: Vec<f64> = self.closings().collect();
        knees.sort_by(f64::total_cmp);
        let solid = knees.last().copied().unwrap_or(0.0);
        knees.dedup_by(|a, b| (*a - *b).abs() <= 1e-12 * solid);
        knees
    }

    /// Closing forces at an end of each section, and where gap over compliance turns.
    fn closings(&self) -> impl Iterator<Item = f64> {
        self.sections.iter().flat_map(|section| {
            let (gap, compliance) = (section.gap(), section.compliance(self.shear_modulus));
            // (g/c)' = 0 where g' c = g c'.
            let turns = roots(&difference(&product(&rate(&gap), &compliance), &product(&gap, &rate(&compliance))));
            let places = turns.into_iter().chain([0.0, 1.0]);
            places.map(move |place| value(&gap, place) / value(&compliance, place)).collect::<Vec<f64>>()
        })
    }

    /// The force \[N\] with which a coil at rest pushes when it is `compression` \[m\] shorter than unloaded, and how it grows \[N/m\], from a table;
    /// below zero where it is pulled. Shorter than solid, where no spring goes, it goes on as the open coil does.
    ///
    /// Source:   [`Self::compression`], turned round.
    /// Valid:    as there.
    /// Accuracy: 1e-7 of the force (test).
    pub fn pushes(&self, compression: f64) -> [f64; 2] {
        self.curve.at(compression, self.stiffness())
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
    pub(super) fn compressed(&self, force: f64) -> [f64; 2] {
        self.sections.iter().fold([0.0; 2], |[x, softness], section| {
            let [more, soft] = section.compression(force, self.shear_modulus);
            [x + more, softness + soft]
        })
    }

    /// Radii of coil and wire at a place along the wire, `windings` from end 1 \[m\].
    pub fn radii_at(&self, windings: f64) -> [f64; 2] {
        let mut begin = 0.0;
        let last = self.sections.len() - 1;
        for (number, section) in self.sections.iter().enumerate() {
            let place = (windings - begin) / section.windings;
            if place <= 1.0 || number == last {
                return [0.5 * at(section.coil_diameter, place.clamp(0.0, 1.0)), 0.5 * section.wire_diameter];
            }
            begin += section.windings;
        }
        [0.0; 2]
    }

    pub(super) fn compliance_between(&self, from: f64, to: f64) -> f64 {
        self.between(from, to, |section, from, to| integral(&section.compliance(self.shear_modulus), from, to))
    }

    pub(super) fn mass_between(&self, from: f64, to: f64) -> f64 {
        self.between(from, to, |section, from, to| {
            let area = 0.25 * PI * section.wire_diameter * section.wire_diameter;
            let wire = |place: f64| (PI * at(section.coil_diameter, place)).hypot(at(section.pitch, place));
            self.density * area * panel(from, to, wire)
        })
    }

    /// A sum over windings `from` to `to` of what a section has between two of its places, 0 to 1, times its windings.
    pub(super) fn between(&self, from: f64, to: f64, of: impl Fn(&Section, f64, f64) -> f64) -> f64 {
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
    pub(super) fn compliance(&self, shear_modulus: f64) -> Polynomial {
        let [first, last] = self.coil_diameter;
        let line = [first, last - first, 0.0, 0.0, 0.0];
        let factor = 8.0 / (shear_modulus * self.wire_diameter.powi(4));
        product(&product(&line, &line), &line).map(|value| factor * value)
    }

    /// How far a winding is from closing \[m\].
    pub(super) fn gap(&self) -> Polynomial {
        let closed = if self.telescopes { 0.0 } else { self.wire_diameter };
        [self.pitch[0] - closed, self.pitch[1] - self.pitch[0], 0.0, 0.0, 0.0]
    }

    /// p over a section's place \[m\].
    pub(super) fn pitch_over_place(&self) -> Polynomial {
        [self.pitch[0], self.pitch[1] - self.pitch[0], 0.0, 0.0, 0.0]
    }

    /// Stretches between places at which windings are just closed, and whether they are open.
    fn parts(&self, force: f64, shear_modulus: f64) -> Vec<([f64; 2], bool)> {
        let (gap, compliance) = (self.gap(), self.compliance(shear_modulus));
        let pressed = compliance.map(|value| force * value);
        let mut places = roots(&difference(&pressed, &gap));
        places.insert(0, 0.0);
        places.push(1.0);
        let part = |pair: &[f64]| {
            let middle = 0.5 * (pair[0] + pair[1]);
            ([pair[0], pair[1]], force <= 0.0 || value(&pressed, middle) < value(&gap, middle))
        };
        places.windows(2).map(part).collect()
    }

    /// Stretches that are open under a force, by places.
    pub(super) fn open_parts(&self, force: f64, shear_modulus: f64) -> Vec<[f64; 2]> {
        self.parts(force, shear_modulus).into_iter().filter(|(_, is_open)| *is_open).map(|(part, _)| part).collect()
    }

    /// Under a force: compression \[m\], and its growth with the force \[m/N\].
    fn compression(&self, force: f64, shear_modulus: f64) -> [f64; 2] {
        let compliance = self.compliance(shear_modulus);
        let open = self.open_parts(force, shear_modulus);
        let soft = open.iter().map(|[from, to]| self.windings * integral(&compliance, *from, *to)).sum();
        [self.pressed_between(force, shear_modulus, [0.0, 1.0]), soft]
    }

    /// Compression of the stretch between two places under a force \[m\].
    pub(super) fn pressed_between(&self, force: f64, shear_modulus: f64, [low, high]: [f64; 2]) -> f64 {
        let (gap, compliance) = (self.gap(), self.compliance(shear_modulus));
        let of_part = |([from, to], is_open): ([f64; 2], bool)| {
            let (from, to) = (from.max(low), to.min(high));
            if to <= from {
                0.0
            } else if is_open {
                force * integral(&compliance, from, to)
            } else {
                integral(&gap, from, to)
            }
        };
        self.windings * self.parts(force, shear_modulus).into_iter().map(of_part).sum::<f64>()
    }
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
