//! How far real springs of one kind are from their spec: stiffness, mass, rest length, initial tension.
//!
//! Next door: the spring (`spring`), what tolerances do to it (`coilsense::geometry::Sensitivities`), springs drawn from them
//! (`crate::analysis`).

use coilsense::geometry::Sensitivities;

use super::SpecError;
use super::section::Section;
use crate::quantity::Dimension;

/// Limits within which real springs lie, all values alike likely; those of wire, coil and material move stiffness and mass together.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Tolerances {
    /// Of k, as a share; `None` where that of wire, coil and material counts, if there is any.
    pub stiffness: Option<f64>,
    /// Of m, as a share; `None` likewise.
    pub mass: Option<f64>,
    /// Of d, D, n, G and ρ, as shares; all zero of a spring by values.
    pub geometry: [f64; 5],
    /// Whether any of those is given.
    pub geometry_is_given: bool,
    /// Of the rest length, either way \[m\].
    pub rest_length: f64,
    /// Of the initial tension, as a share.
    pub initial_tension: f64,
    /// Of the wire's relative permeability, as a share of it.
    pub permeability: f64,
}

/// How a real spring differs from its spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Departure {
    /// Its stiffness over the spec's \[1\].
    pub stiffness: f64,
    /// Its mass over the spec's \[1\].
    pub mass: f64,
    /// Its rest length less the spec's \[m\].
    pub rest_length: f64,
    /// Its initial tension over the spec's \[1\].
    pub initial_tension: f64,
}

/// How many numbers a departure is made of.
pub(crate) const DIMENSIONS: usize = 9;

/// Keys of the tolerances of d, D, n, G, ρ.
const OF_GEOMETRY: [&str; 5] = [
    "wire_diameter_tolerance",
    "coil_diameter_tolerance",
    "windings_tolerance",
    "shear_modulus_tolerance",
    "density_tolerance",
];

/// The exponents of k and of m over d, D, n, G, ρ.
fn exponents() -> [[f64; 5]; 2] {
    [Sensitivities::of_stiffness(), Sensitivities::of_mass()]
        .map(|s| [s.wire_diameter, s.coil_diameter, s.active_windings, s.shear_modulus, s.density])
}

impl Tolerances {
    /// Reads them; `rest_length` is the spring's \[m\].
    pub(super) fn parse(section: &Section<'_>, by_geometry: bool, rest_length: f64) -> Result<Self, SpecError> {
        let share = |key| -> Result<Option<f64>, SpecError> {
            let given = section.not_negative(key, Dimension::Share)?;
            given.map(|value| section.check(key, value < 1.0, value, "below 100 %")).transpose()
        };
        let mut tolerances = Self {
            stiffness: share("stiffness_tolerance")?,
            mass: share("mass_tolerance")?,
            rest_length: rest_length_tolerance(section, rest_length)?,
            initial_tension: share("initial_tension_tolerance")?.unwrap_or(0.0),
            permeability: share("relative_permeability_tolerance")?.unwrap_or(0.0),
            ..Self::default()
        };
        if by_geometry {
            for (key, tolerance) in OF_GEOMETRY.into_iter().zip(&mut tolerances.geometry) {
                let given = share(key)?;
                tolerances.geometry_is_given |= given.is_some();
                *tolerance = given.unwrap_or(0.0);
            }
            if let (Some(key), true) = (section.first_of(&OF_GEOMETRY), tolerances.of_stiffness() >= 1.0) {
                let percent = 100.0 * tolerances.of_stiffness();
                let text =
                    format!("the tolerances leave {percent:.0} % of doubt in the stiffness; must be below 100 %");
                return Err(section.refuse(key, text));
            }
        }
        Ok(tolerances)
    }

    /// Of k, as a share: as it is given, or by those of wire, coil and material, independent limits added up as their squares do.
    pub fn of_stiffness(&self) -> f64 {
        self.stiffness.unwrap_or_else(|| self.by_geometry(0))
    }

    /// Of m, as a share, in the same way.
    pub fn of_mass(&self) -> f64 {
        self.mass.unwrap_or_else(|| self.by_geometry(1))
    }

    /// How far each of them alone, at its limit, moves k and surge frequencies, to first order, as shares \[1\]: f ∝ √(k/m).
    pub fn moves(&self) -> Vec<[f64; 2]> {
        let given = [self.stiffness.map(|limit| [limit, 0.5 * limit]), self.mass.map(|limit| [0.0, -0.5 * limit])];
        let [of_stiffness, of_mass] = exponents();
        let shares = |number: usize| {
            let by = |given: Option<f64>, exponent: f64| {
                if given.is_some() { 0.0 } else { exponent * self.geometry[number] }
            };
            let (stiffness, mass) = (by(self.stiffness, of_stiffness[number]), by(self.mass, of_mass[number]));
            [stiffness, 0.5 * (stiffness - mass)]
        };
        let by_geometry = (0..self.geometry.len()).map(shares);
        given.into_iter().flatten().chain(by_geometry).filter(|moved| *moved != [0.0; 2]).collect()
    }

    fn by_geometry(&self, of: usize) -> f64 {
        let each = exponents()[of].into_iter().zip(self.geometry);
        each.map(|(exponent, tolerance)| (exponent * tolerance).powi(2)).sum::<f64>().sqrt()
    }

    /// Whether the spec says nothing of how far k may be off.
    pub fn is_silent_on_stiffness(&self) -> bool {
        self.stiffness.is_none() && !self.geometry_is_given
    }

    /// The spring at a point of the box: `units` are from −1 to 1, for k, m, d, D, n, G, ρ, l0 and F_0.
    pub fn at(&self, units: &[f64; DIMENSIONS]) -> Departure {
        let by_geometry = |of: usize| -> f64 {
            let each = exponents()[of].into_iter().zip(self.geometry).zip(&units[2..7]);
            each.filter(|((_, tolerance), _)| *tolerance > 0.0)
                .map(|((exponent, tolerance), unit)| (1.0 + tolerance * unit).powf(exponent))
                .product()
        };
        Departure {
            stiffness: self.stiffness.map_or_else(|| by_geometry(0), |tolerance| 1.0 + tolerance * units[0]),
            mass: self.mass.map_or_else(|| by_geometry(1), |tolerance| 1.0 + tolerance * units[1]),
            rest_length: self.rest_length * units[7],
            initial_tension: 1.0 + self.initial_tension * units[8],
        }
    }
}

/// How far the rest length may be off \[m\].
fn rest_length_tolerance(section: &Section<'_>, rest_length: f64) -> Result<f64, SpecError> {
    let tolerance = section.not_negative("rest_length_tolerance", Dimension::Length)?.unwrap_or(0.0);
    section.check("rest_length_tolerance", tolerance < rest_length, tolerance, "below rest_length")
}
