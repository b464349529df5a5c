//! A relation between length and inductance that was fitted, whichever it is.
//!
//! Next door: how each is fitted (`coilsense::calibrate`), what one makes of the points (`taken`).

use coilsense::Error;
use coilsense::calibrate::{
    CalibrationPoints, CubicFit, FitMethod, InverseLengthFit, ReadingUncertainty, SteelDoubts, SteelFit,
};
use coilsense::inductance::SteelCoil;

use super::{Plan, Relation};

/// One of them.
#[derive(Debug, Clone, PartialEq)]
pub enum Curve {
    /// Eq. (13), and what a length read by it is worth where a point is left to tell.
    InverseLength(InverseLengthFit, Option<ReadingUncertainty>),
    /// With one term more.
    Cubic(CubicFit),
    /// Magnetic wire.
    Steel(Box<SteelFit>),
}

impl Curve {
    /// Fits a relation to all of some points.
    ///
    /// # Errors
    /// [`Error`] of the fit.
    pub(super) fn fit(
        relation: Relation,
        points: &CalibrationPoints,
        coil: Option<&SteelCoil>,
        plan: &Plan,
        doubts: &SteelDoubts,
    ) -> Result<Self, Error> {
        Ok(match (relation, coil) {
            (Relation::Steel, Some(coil)) => {
                Self::Steel(Box::new(SteelFit::new(coil, points, plan.steel.permeability, doubts)?))
            }
            (Relation::Cubic, _) => Self::Cubic(CubicFit::new(points)?),
            _ => Self::InverseLength(
                InverseLengthFit::new(points, FitMethod::AllPoints)?,
                ReadingUncertainty::new(points, FitMethod::AllPoints)?,
            ),
        })
    }

    /// Which one it is.
    pub fn relation(&self) -> Relation {
        match self {
            Self::InverseLength(..) => Relation::InverseLength,
            Self::Cubic(_) => Relation::Cubic,
            Self::Steel(_) => Relation::Steel,
        }
    }

    /// L \[H\] at a length \[m\]; NaN where the relation does not reach.
    pub fn inductance(&self, length: f64) -> f64 {
        match self {
            Self::InverseLength(fit, _) => fit.calibration().inductance(length),
            Self::Cubic(fit) => fit.inductance(length),
            Self::Steel(fit) => fit.inductance(length),
        }
    }

    /// The length \[m\] that it reads from an inductance \[H\].
    ///
    /// # Errors
    /// [`Error::Value`] where there is none.
    pub fn length(&self, inductance: f64) -> Result<f64, Error> {
        let length = match self {
            Self::InverseLength(fit, _) => fit.calibration().length(inductance),
            Self::Cubic(fit) => fit.length(inductance),
            Self::Steel(fit) => return fit.length(inductance),
        };
        if length.is_finite() && length > 0.0 {
            return Ok(length);
        }
        Err(Error::Value {
            field: Some("inductance"),
            quantity: "inductance".into(),
            value: inductance,
            unit: "H",
            allowed: "one that the curve has at some length".into(),
        })
    }

    /// Standard uncertainty \[m\] of that length; none where no point is left to tell, or no length is read.
    pub fn length_u(&self, inductance: f64) -> Option<f64> {
        let found = match self {
            Self::InverseLength(_, reading) => reading.map(|reading| reading.length(inductance)),
            Self::Cubic(fit) => fit.length_u(inductance),
            Self::Steel(fit) => Some(fit.length_u(inductance)),
        };
        found.filter(|found| found.is_finite())
    }
}
