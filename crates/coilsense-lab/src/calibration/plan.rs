//! What a calibration is asked for.
//!
//! Next door: the pairs (`measured`), what comes of it (`outcome`).

use coilsense::Spring;
use coilsense::calibrate::{CalibrationPoints, FitMethod, Inversion, Permeability};
use coilsense::inductance::Leads;
use coilsense::inductance::theories::Coil;

use super::{CalibrationError, ForceLaw};

/// How the curve is put through the points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Through the first and the last of them.
    TwoPoint,
    /// Least squares over all.
    All,
    /// Least squares over all, exactly through the preload.
    ThroughPreload,
}

/// The pair that [`Method::ThroughPreload`] must meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Preload {
    /// l \[m\].
    pub length: f64,
    /// L \[H\]; without it that of the point at this length.
    pub inductance: Option<f64>,
}

/// The relation between length and inductance that is put through the points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// Eq. (13), 1/l = αL + β.
    InverseLength,
    /// L = α/l + β + γ/l².
    Cubic,
    /// Turns of magnetic wire: its permeability and a constant.
    Steel,
}

impl Relation {
    /// All of them, the simplest first.
    pub const ALL: [Self; 3] = [Self::InverseLength, Self::Cubic, Self::Steel];

    /// What JSON and a stored calibration call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::InverseLength => "inverse-length",
            Self::Cubic => "cubic",
            Self::Steel => "steel",
        }
    }

    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Self::InverseLength => "1/l = αL + β",
            Self::Cubic => "L = α/l + β + γ/l²",
            Self::Steel => "the theory of magnetic wire",
        }
    }

    /// How it is asked of the command.
    pub fn option(self) -> &'static str {
        match self {
            Self::InverseLength => "--form inverse-length",
            Self::Cubic => "--form cubic",
            Self::Steel => "--theory steel",
        }
    }

    /// Numbers that are fitted, and so the fewest points.
    pub fn fewest(self) -> usize {
        match self {
            Self::InverseLength | Self::Steel => 2,
            Self::Cubic => 3,
        }
    }
}

/// What the theory of magnetic wire is told.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteelPlan {
    /// Whether the wire's permeability is known.
    pub permeability: Permeability,
    /// Where the current goes back.
    pub leads: Leads,
    /// u(L) of a reading \[H\]; without it what the points say, else 0.05 % of L.
    pub meter_noise: Option<f64>,
    /// Of the meter \[Hz\].
    pub frequency: Option<f64>,
    /// The length at which the coil's radius is what it is \[m\]; without it the zero of positions, else the shortest of the points.
    pub measured_at: Option<f64>,
}

impl Default for SteelPlan {
    fn default() -> Self {
        Self {
            permeability: Permeability::Fitted,
            leads: Leads::Open,
            meter_noise: None,
            frequency: None,
            measured_at: None,
        }
    }
}

/// All that is asked of a calibration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plan {
    /// Which relation is taken.
    pub relation: Relation,
    /// How many points it is fitted to, spread from the first to the last, and judged on the others; none, all.
    pub points: Option<usize>,
    /// A length and an inductance that it must pass by its constant alone, after it was fitted \[m, H\].
    pub re_zero: Option<(f64, f64)>,
    /// For [`Relation::Steel`].
    pub steel: SteelPlan,
    /// How the curve is found.
    pub method: Method,
    /// What it must meet, for [`Method::ThroughPreload`].
    pub preload: Option<Preload>,
    /// How a theory is turned round.
    pub inversion: Inversion,
    /// The coil for the theories; none, no theories.
    pub coil: Option<Coil>,
    /// From length to force; none, no force.
    pub force: Option<ForceLaw>,
}

impl Plan {
    /// The same with the coil of a known spring, whose radius is that at its rest length, and what goes on to force.
    ///
    /// # Errors
    /// [`coilsense::Error`] for a spring that is no coil.
    pub fn of_spring(self, spring: &Spring, force: Option<ForceLaw>) -> Result<Self, coilsense::Error> {
        let steel = SteelPlan { measured_at: Some(spring.rest_length()), ..self.steel };
        Ok(Self { coil: Some(Coil::of(spring)?), force, steel, ..self })
    }
}

/// How near to a point the preload's length must be, as a share of the points' range.
const NEAR: f64 = 1e-3;

impl Method {
    /// All of them, with what the command calls them.
    pub const ALL: [(&'static str, Self); 3] =
        [("two-point", Self::TwoPoint), ("all", Self::All), ("through-preload", Self::ThroughPreload)];

    /// What the command calls it.
    pub fn name(self) -> &'static str {
        Self::ALL.into_iter().find(|(_, method)| *method == self).map_or("", |(name, _)| name)
    }

    /// In words, for points of a number.
    pub fn words(self, points: usize) -> String {
        match self {
            Self::TwoPoint => format!("through the first and the last of {points} points"),
            Self::All => format!("by least squares over {points} points"),
            Self::ThroughPreload => format!("by least squares over {points} points, through the preload"),
        }
    }

    /// As the science knows it.
    pub(super) fn fit(
        self,
        points: &CalibrationPoints,
        preload: Option<Preload>,
    ) -> Result<FitMethod, CalibrationError> {
        match (self, preload) {
            (Self::TwoPoint, _) => Ok(FitMethod::first_and_last(points)),
            (Self::All, _) => Ok(FitMethod::AllPoints),
            (Self::ThroughPreload, Some(preload)) => preload.fit(points),
            (Self::ThroughPreload, None) => Err(CalibrationError::new(
                "preload: must be given for a fit through it, such as \"141.8 mm\" or \"141.8 mm, 3.35 uH\"",
            )),
        }
    }
}

impl Preload {
    fn fit(self, points: &CalibrationPoints) -> Result<FitMethod, CalibrationError> {
        let Self { length, inductance } = self;
        if let Some(inductance) = inductance {
            return Ok(FitMethod::Through { length, inductance });
        }
        let near: Vec<usize> = (0..points.lengths().len())
            .filter(|&index| (points.lengths()[index] - length).abs() <= NEAR * points.range())
            .collect();
        if near.is_empty() {
            let distance = |at: &&f64| (**at - length).abs();
            let nearest = points.lengths().iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
            return Err(CalibrationError::new(format!(
                "preload: must be the length of a point (the nearest is {} mm) or come with its inductance, as in \"{} mm, 3.35 uH\", \
                 got {} mm",
                1e3 * nearest.copied().unwrap_or(length),
                1e3 * length,
                1e3 * length
            )));
        }
        let mean = |values: &[f64]| near.iter().map(|&index| values[index]).sum::<f64>() / near.len() as f64;
        Ok(FitMethod::Through { length: mean(points.lengths()), inductance: mean(points.inductances()) })
    }
}
