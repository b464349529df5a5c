//! What comes of a calibration.
//!
//! Next door: what was asked (`plan`), what the science does (`coilsense::calibrate`), the words (`answer`).

use coilsense::calibrate::{FitMethod, InductanceFit, InverseLengthFit, Misfit, ReadingUncertainty};
use coilsense::inductance::theories::Theory;

use super::{CalibrationError, Contest, Curve, Measured, Method, Plan, Rival, Taken};
use crate::quantity::digits;

/// Most points on which theories are judged: turning a helix round takes a millisecond a point.
pub const THEORY_POINTS: usize = 500;

/// A calibration with all that is known of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The points.
    pub measured: Measured,
    /// What was asked.
    pub plan: Plan,
    /// The calibration that was asked for.
    pub taken: Taken,
    /// It and others on points that they were not fitted to.
    pub contest: Contest,
    /// Eq. (13), squares of 1/l.
    pub inverse_length: InverseLengthFit,
    /// L = α/l + β, squares of L.
    pub inductance: InductanceFit,
    /// What a length read by eq. (13) is worth; none where no point is left to tell.
    pub reading: Option<ReadingUncertainty>,
    /// The other methods by eq. (13), for comparison: those that need nothing more than what was given.
    pub others: Vec<(Method, Misfit)>,
    /// The theories beside it, in the order of [`Theory::ALL`].
    pub theories: Vec<Assessment>,
}

/// A theory on the points.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessment {
    /// Which one.
    pub theory: Theory,
    /// How far off it is, or why that cannot be said.
    pub misfit: Result<Misfit, String>,
}

impl Outcome {
    /// Carries a plan out.
    ///
    /// # Errors
    /// [`CalibrationError`] for points that no curve can be put through, an inductance that does not fall with length, or a preload that is
    /// not there.
    pub fn new(measured: Measured, plan: Plan) -> Result<Self, CalibrationError> {
        let measured = measured.without_touching()?;
        let points = &measured.points;
        let refuse = |error: coilsense::Error| CalibrationError::of(&measured.file, error);
        let method = plan.method.fit(points, plan.preload)?;
        let fitted = match plan.points {
            Some(count) => measured.pick(&measured.some(count.min(points.lengths().len())))?,
            None => points.clone(),
        };
        let method = if plan.points.is_some() { FitMethod::AllPoints } else { method };
        let mut inverse_length = InverseLengthFit::new(&fitted, method).map_err(refuse)?;
        if inverse_length.alpha <= 0.0 {
            let (length, henry) = (points.lengths(), points.inductances());
            let order = |a: &usize, b: &usize| length[*a].total_cmp(&length[*b]);
            let ends =
                [(0..length.len()).min_by(order), (0..length.len()).max_by(order)].map(Option::unwrap_or_default);
            let [(near, least), (far, most)] = ends.map(|at| (digits(1e3 * length[at]), digits(1e6 * henry[at])));
            return Err(CalibrationError::of(
                &measured.file,
                format!(
                    "the inductance of a coil falls as it gets longer, here it does not: {least} µH at {near} mm, {most} µH at {far} mm; a column \
                     may be another quantity, or its lengths be counted from the other end"
                ),
            ));
        }
        let mut inductance = InductanceFit::new(&fitted, method).map_err(refuse)?;
        let reading = ReadingUncertainty::new(&fitted, method).map_err(refuse)?;
        if plan.points.is_some() {
            // On all points, whichever it was fitted to.
            inverse_length.misfit = inverse_length.calibration().misfit(points).map_err(refuse)?;
            inductance.misfit = inductance.calibration().misfit(points).map_err(refuse)?;
        }
        let others = Method::ALL.into_iter().filter(|(_, other)| *other != plan.method).filter_map(|(_, other)| {
            let fit = other.fit(points, plan.preload).ok()?;
            Some((other, InverseLengthFit::new(points, fit).ok()?.misfit))
        });
        let others = others.collect();
        let some = measured.some(THEORY_POINTS);
        let some = measured.pick(&some)?;
        let theories = plan.coil.iter().flat_map(|coil| Theory::ALL.map(|theory| (coil, theory)));
        let judge = |(coil, theory): (&_, Theory)| {
            let relation = |length: f64| theory.inductance(coil, length);
            let misfit = plan.inversion.judge(&some, relation).map_err(|error| error.to_string());
            Assessment { theory, misfit }
        };
        let theories = theories.map(judge).collect();
        let (taken, contest) = Taken::new(&measured, &plan, Curve::InverseLength(inverse_length.clone(), reading))?;
        Ok(Self { measured, plan, taken, contest, inverse_length, inductance, reading, others, theories })
    }

    /// What the fit goes by.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn fit_method(&self) -> Result<FitMethod, CalibrationError> {
        self.plan.method.fit(&self.measured.points, self.plan.preload)
    }

    /// The largest residual either way \[m\], and its point.
    pub fn worst(&self) -> (f64, usize) {
        let residuals = self.inverse_length.misfit.residuals.iter().copied().enumerate();
        let worst = residuals.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        worst.map_or((0.0, 0), |(index, residual)| (residual, index))
    }

    /// Displacement that the scatter of the readings explains, root mean square over the points \[m\]; none where each point is one reading.
    ///
    /// u(l) = u(L) / |dL/dl|, with dL/dl = −1/(α l²) of eq. (13)
    pub fn noise(&self) -> Option<f64> {
        let errors = &self.measured.standard_errors;
        if errors.is_empty() {
            return None;
        }
        let lengths = self.measured.points.lengths();
        let squares = errors.iter().zip(lengths).map(|(error, l)| (error * self.inverse_length.alpha * l * l).powi(2));
        Some((squares.sum::<f64>() / lengths.len() as f64).sqrt())
    }

    /// The theory that needs no measured point and is nearest to them.
    pub fn best_theory(&self) -> Option<(&'static str, &Misfit)> {
        let judged =
            self.theories.iter().filter_map(|judged| Some((judged.theory.name(), judged.misfit.as_ref().ok()?)));
        judged.min_by(|a, b| a.1.rmse.total_cmp(&b.1.rmse))
    }

    /// The rival that does best on points that it was not fitted to.
    pub fn best(&self) -> Option<(&Rival, f64)> {
        let judged = self.contest.rivals.iter().filter_map(|rival| Some((rival, *rival.share.as_ref().ok()?)));
        judged.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Each point's force by the calibration and its standard uncertainty \[N\], where a stiffness is given.
    pub fn forces(&self) -> Option<Vec<(f64, Option<f64>)>> {
        let law = self.plan.force?;
        let force = |(&henry, &length): (&f64, &f64)| {
            (law.force(length), self.taken.curve.length_u(henry).map(|length_u| law.uncertainty(length, length_u)))
        };
        Some(self.measured.points.inductances().iter().zip(&self.taken.read).map(force).collect())
    }
}
