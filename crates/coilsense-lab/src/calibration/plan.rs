//! What a calibration is asked for.
//!
//! Next door: the pairs (`measured`), what comes of it (`outcome`).

use coilsense::calibrate::{CalibrationPoints, FitMethod, Inversion};
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

/// All that is asked of a calibration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plan {
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
