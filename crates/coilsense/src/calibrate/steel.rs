//! A coil of magnetic wire fitted to points: the permeability of its wire and a constant.
//!
//! Next door: what it takes for granted (`steel_doubts`), the coil (`crate::inductance::SteelCoil`), eq. (13), which needs no coil (`inverse_length`), and the form with one term more (`cubic`).

use super::inversion::Inversion;
use super::misfit::Misfit;
use super::points::CalibrationPoints;
use super::steel_doubts::SteelDoubts;
use crate::error::{Error, called, check};
use crate::inductance::{Changes, LEAST_FITTED, Leads, MOST_PERMEABLE, SteelCoil, SteelCurve};

/// Whether the wire's permeability is asked of the points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Permeability {
    /// It is.
    Fitted,
    /// It is known, 1 to 20.
    Known(f64),
}

/// A steel coil's permeability and constant with what is known of them.
#[derive(Debug, Clone, PartialEq)]
pub struct SteelFit {
    /// μ_r \[1\]; noise may take that of wire which is not magnetic below 1.
    pub permeability: f64,
    /// Its standard uncertainty \[1\]; none where it was given.
    pub permeability_u: Option<f64>,
    /// The same from the meter's noise alone.
    pub permeability_noise: Option<f64>,
    /// L_0 \[H\], what hooks, leads and errors of windings and radius add.
    pub offset: f64,
    /// Its standard uncertainty \[H\].
    pub offset_u: f64,
    /// Root mean square of the measured less the fitted L \[H\] of the points of the fit.
    pub rms: f64,
    curve: SteelCurve,
    /// The same coil of wire that is not magnetic.
    air: SteelCurve,
    /// What the doubts make of L over 1/l, and how far the fit follows: see [`Self::length_u`].
    doubts: Doubted,
}

/// What is not known of L.
#[derive(Debug, Clone, PartialEq)]
struct Doubted {
    stated: SteelDoubts,
    /// ∂L/∂μ_r over length, as a curve either side.
    either: [SteelCurve; 2],
    step: f64,
    /// Covariance of μ_r and L_0 for readings of variance 1 each: [μμ, μ0, 00].
    covariance: [f64; 3],
    causes: Causes,
    /// By how much the fit gives way to each of them in μ_r and L_0.
    gives_way: [[f64; 2]; CAUSES],
    /// u(μ_r) of a permeability that was told, else zero; and the mean of ∂L/∂μ_r over the points, by which L_0 follows it.
    told: [f64; 2],
}

/// One standard uncertainty each of windings, radius, wire and leads as changes of L over length.
#[derive(Debug, Clone, PartialEq)]
struct Causes {
    changes: Changes,
    /// Shares of N, r and a.
    shares: [f64; 3],
    /// Radius over length, and both ways of the current.
    own: SteelCurve,
    other: Leads,
}

/// How many they are.
const CAUSES: usize = 4;

impl Causes {
    /// \[H\] at a length.
    fn at(&self, length: f64) -> [f64; CAUSES] {
        let [n, r, a] = self.shares;
        let [windings, radius, wire] = self.changes.at(length);
        [n * windings, r * radius, a * wire, self.own.by_leads(length, self.other)]
    }
}

/// Permeabilities at which the search begins.
const STARTS: usize = 25;
/// Most steps of the search, which takes some five.
const STEPS: usize = 60;

impl SteelFit {
    /// Fits L = L(l, μ_r) + L_0, squares of L, all points with the same weight.
    ///
    /// Standard uncertainties come from what is stated, as two points leave no residual to tell: with J = (∂L/∂μ_r, 1) of the points, noise of σ gives the
    /// covariance σ² (JᵀJ)⁻¹, and a cause that changes the coil's L by δ(l) moves the fit by −(JᵀJ)⁻¹ Jᵀδ.
    ///
    /// - `coil`: at every length of the points and of those to be read; `points`: two at least
    ///
    /// Source:   `[JCGM100]` 5.1.2, and of the linear least squares H.3; L of [`SteelCoil`].
    /// Valid:    as [`SteelCoil`]. μ_r and a common factor of L can hardly be told apart: 1 % of L is some 0.1 of μ_r.
    /// Accuracy: μ_r and L_0 to 1e-9 from exact points; on measured springs see the book.
    ///
    /// # Errors
    /// [`Error::Value`] for points that no permeability from 0.5 to 20 explains, points outside of the coil's range, a known permeability that is not 1 to
    /// 20, doubts that are not zero or above, or a lead inside the coil.
    ///
    /// ```
    /// use coilsense::calibrate::{CalibrationPoints, Permeability, SteelDoubts, SteelFit};
    /// use coilsense::inductance::theories::Coil;
    /// use coilsense::inductance::{Leads, SteelCoil};
    /// let coil = SteelCoil::new(&Coil::new(10.0, 8e-3, 1e-3)?, 0.021, Leads::Open, [0.022, 0.04])?;
    /// let wire = coil.of(2.3)?;
    /// let lengths = [0.024, 0.036];
    /// let points = CalibrationPoints::new(&lengths, &lengths.map(|l| wire.inductance(l) + 2e-8))?;
    /// let fit = SteelFit::new(&coil, &points, Permeability::Fitted, &SteelDoubts::default())?;
    /// assert!((fit.permeability - 2.3).abs() < 1e-8 && (fit.offset - 2e-8).abs() < 1e-15);
    /// assert!((fit.length(fit.inductance(0.03))? - 0.03).abs() < 1e-12);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn new(
        coil: &SteelCoil,
        points: &CalibrationPoints,
        permeability: Permeability,
        doubts: &SteelDoubts,
    ) -> Result<Self, Error> {
        doubts.check()?;
        doubts.leads.outside(coil.coil().coil_radius())?;
        let search = Search::new(coil, points)?;
        let found = match permeability {
            Permeability::Fitted => search.best()?,
            Permeability::Known(known) => {
                coil.of(known)?;
                known
            }
        };
        let rest = search.rest(found);
        let (offset, rms) = (mean(&rest), scatter(&rest));
        let is_known = matches!(permeability, Permeability::Known(_));
        let doubted = Doubted::new(coil, &search, found, is_known, doubts);
        let [noise, meter_offset] = [doubted.covariance[0], doubted.covariance[2]].map(|c| doubts.meter * c.sqrt());
        let of_causes = |which: usize| doubted.gives_way.iter().map(|moved| moved[which].powi(2)).sum::<f64>().sqrt();
        Ok(Self {
            permeability: found,
            permeability_u: (!is_known).then(|| noise.hypot(of_causes(0))),
            permeability_noise: (!is_known).then_some(noise),
            offset,
            offset_u: meter_offset.hypot(of_causes(1)).hypot(doubted.told[0] * doubted.told[1]),
            rms,
            curve: coil.fitted(found),
            air: coil.fitted(1.0),
            doubts: doubted,
        })
    }

    /// The same with another constant, so that it passes a point: a spring that was mounted anew.
    ///
    /// # Errors
    /// [`Error::Value`] for a length outside of the coil's range, or an inductance that is not finite.
    pub fn re_zeroed(&self, length: f64, inductance: f64) -> Result<Self, Error> {
        let now = self.inductance(length);
        let [shortest, longest] = self.curve.range();
        let allowed = format!("from {shortest} to {longest} m");
        check(now.is_finite(), called("length", "length to zero at"), length, "m", allowed)?;
        check(inductance.is_finite(), "inductance", inductance, "H", "finite")?;
        Ok(Self { offset: self.offset + inductance - now, ..self.clone() })
    }

    /// L \[H\] at a length \[m\]; NaN outside of the coil's range.
    pub fn inductance(&self, length: f64) -> f64 {
        self.curve.inductance(length) + self.offset
    }

    /// L \[H\] at a length \[m\] if the wire were not magnetic and all else the same; NaN outside of the coil's range.
    pub fn not_magnetic(&self, length: f64) -> f64 {
        self.air.inductance(length) + self.offset
    }

    /// The length \[m\] at which the coil has an inductance \[H\].
    ///
    /// # Errors
    /// [`Error::Value`] for an inductance that it has at no length of its range.
    pub fn length(&self, inductance: f64) -> Result<f64, Error> {
        let [shortest, longest] = self.curve.range();
        let [most, least] = [shortest, longest].map(|length| self.inductance(length));
        let allowed = format!("from {least:.4e} to {most:.4e} H, which it has at {longest:.6} and {shortest:.6} m");
        check((least..=most).contains(&inductance), "inductance", inductance, "H", allowed)?;
        let near = shortest + (most - inductance) / (most - least) * (longest - shortest);
        // Beyond its range there is no answer: the search must not step over its ends.
        let held = |length: f64| match length {
            beyond if beyond < shortest => most + (shortest - beyond),
            beyond if beyond > longest => least - (beyond - longest),
            within => self.inductance(within),
        };
        Inversion::Exact.length(held, inductance, near)
    }

    /// Standard uncertainty \[m\] of the length that is read from an inductance; NaN where none is read.
    ///
    /// u(l)² = (σ² (1 + j Σ j) + (θ L)² + Σ (δ(l) + j·m)²)/(∂L/∂l)²; of a permeability that was told, Σ is that of the constant alone, and
    /// u(μ_r)² (∂L/∂μ_r − its mean over the points)² stands beside it
    ///
    /// with j = (∂L/∂μ_r, 1), Σ = (JᵀJ)⁻¹, θ what the theory leaves, δ each cause of error and m how far the fit gives way to it.
    pub fn length_u(&self, inductance: f64) -> f64 {
        let Ok(length) = self.length(inductance) else { return f64::NAN };
        let of = &self.doubts;
        let by_permeability = of.by_permeability(length);
        let [mm, m0, oo] = of.covariance;
        let fitted = mm * by_permeability * by_permeability + 2.0 * m0 * by_permeability + oo;
        let causes = of.causes.at(length).into_iter().zip(&of.gives_way);
        let causes = causes.map(|(error, [by, offset])| error + by * by_permeability + offset);
        let squares = of.stated.meter.powi(2) * (1.0 + fitted)
            + (of.stated.theory * inductance).powi(2)
            + (of.told[0] * (by_permeability - of.told[1])).powi(2)
            + causes.map(|error| error * error).sum::<f64>();
        squares.sqrt() / self.slope(length).abs()
    }

    /// ∂L/∂l \[H/m\].
    pub fn slope(&self, length: f64) -> f64 {
        let [shortest, longest] = self.curve.range();
        let step = 1e-5 * length;
        let (before, after) = ((length - step).max(shortest), (length + step).min(longest));
        (self.inductance(after) - self.inductance(before)) / (after - before)
    }

    /// How it does on points, those of the fit or others.
    ///
    /// # Errors
    /// As [`Self::length`] and [`Misfit::of`].
    pub fn misfit(&self, points: &CalibrationPoints) -> Result<Misfit, Error> {
        let predicted: Vec<f64> = points.lengths().iter().map(|&length| self.inductance(length)).collect();
        let read: Result<Vec<f64>, Error> = points.inductances().iter().map(|&henry| self.length(henry)).collect();
        Misfit::of(points, &predicted, &read?)
    }

    /// Whether the wire is magnetic beyond three standard uncertainties.
    pub fn is_magnetic(&self) -> bool {
        self.permeability - 1.0 > 3.0 * self.permeability_u.unwrap_or(0.0)
    }
}

/// Points and a coil that is to have their L.
struct Search<'a> {
    coil: &'a SteelCoil,
    points: &'a CalibrationPoints,
}

impl<'a> Search<'a> {
    fn new(coil: &'a SteelCoil, points: &'a CalibrationPoints) -> Result<Self, Error> {
        let [shortest, longest] = coil.range();
        for (index, &length) in points.lengths().iter().enumerate() {
            let allowed = format!("from {shortest} to {longest} m, the range of the coil");
            check((shortest..=longest).contains(&length), crate::error::entry("lengths", index), length, "m", allowed)?;
        }
        Ok(Self { coil, points })
    }

    /// Measured less computed L \[H\].
    fn rest(&self, permeability: f64) -> Vec<f64> {
        let curve = self.coil.fitted(permeability);
        let pairs = self.points.lengths().iter().zip(self.points.inductances());
        pairs.map(|(&length, henry)| henry - curve.inductance(length)).collect()
    }

    /// ∂L/∂μ_r \[H\] at the points.
    fn by_permeability(&self, permeability: f64) -> Vec<f64> {
        let step = 1e-4 * permeability;
        let either = [permeability + step, permeability - step].map(|at| self.rest(at));
        either[1].iter().zip(&either[0]).map(|(below, above)| (below - above) / (2.0 * step)).collect()
    }

    /// μ_r that leaves the least beside a constant.
    fn best(&self) -> Result<f64, Error> {
        let ends = [LEAST_FITTED, MOST_PERMEABLE];
        let at = |share: f64| ends[0] * (ends[1] / ends[0]).powf(share);
        let tried = (0..STARTS).map(|index| at(index as f64 / (STARTS - 1) as f64));
        let left = tried.map(|permeability| (permeability, scatter(&self.rest(permeability))));
        let mut here = left.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(1.0, |(permeability, _)| permeability);
        for _ in 0..STEPS {
            let (rest, slope) = (self.rest(here), self.by_permeability(here));
            let (mean_rest, mean_slope) = (mean(&rest), mean(&slope));
            let pairs = rest.iter().zip(&slope);
            let above: f64 = pairs.map(|(rest, slope)| (rest - mean_rest) * (slope - mean_slope)).sum();
            let below: f64 = slope.iter().map(|slope| (slope - mean_slope).powi(2)).sum();
            let next = (here + above / below).clamp(ends[0], ends[1]);
            let moved = (next - here).abs();
            here = next;
            if moved <= 1e-12 * here {
                break;
            }
        }
        let within = here > ends[0] && here < ends[1];
        let allowed = format!(
            "{} to {}, which these points do not ask for (is the file of this coil, are windings, radius and wire?)",
            ends[0], ends[1]
        );
        check(within, called("permeability", "relative permeability of the fit"), here, "", allowed)
    }
}

impl Doubted {
    fn new(coil: &SteelCoil, search: &Search, permeability: f64, is_known: bool, stated: &SteelDoubts) -> Self {
        let step = 1e-4 * permeability;
        let either = [permeability - step, permeability + step].map(|at| coil.fitted(at));
        // (JᵀJ)⁻¹ of slopes and ones.
        let slopes = search.by_permeability(permeability);
        let count = slopes.len() as f64;
        let average = mean(&slopes);
        let square: f64 = slopes.iter().map(|slope| (slope - average).powi(2)).sum();
        let covariance = if is_known {
            [0.0, 0.0, 1.0 / count]
        } else {
            [1.0 / square, -average / square, 1.0 / count + average * average / square]
        };
        let shares = [stated.windings, stated.coil_radius, 0.5 * stated.wire_diameter / coil.coil().wire_radius()];
        // A row has to be solved for each of its lengths.
        let is_asked = shares.iter().any(|share| *share > 0.0);
        let causes = Causes {
            changes: if is_asked { coil.changes(permeability) } else { Changes::default() },
            shares,
            own: coil.fitted(permeability),
            other: stated.leads,
        };
        let errors: Vec<[f64; CAUSES]> = search.points.lengths().iter().map(|&length| causes.at(length)).collect();
        let gives_way = std::array::from_fn(|which| {
            let average_error = errors.iter().map(|errors| errors[which]).sum::<f64>() / count;
            if is_known {
                return [0.0, -average_error];
            }
            let centred: f64 =
                errors.iter().zip(&slopes).map(|(errors, slope)| errors[which] * (slope - average)).sum();
            let by = -centred / square;
            [by, -average_error - by * average]
        });
        let told = [if is_known { stated.permeability * permeability } else { 0.0 }, average];
        Self { stated: *stated, either, step, covariance, causes, gives_way, told }
    }

    /// ∂L/∂μ_r \[H\] at a length.
    fn by_permeability(&self, length: f64) -> f64 {
        let [below, above] = &self.either;
        (above.inductance(length) - below.inductance(length)) / (2.0 * self.step)
    }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Root mean square about the mean.
fn scatter(values: &[f64]) -> f64 {
    let middle = mean(values);
    (values.iter().map(|value| (value - middle).powi(2)).sum::<f64>() / values.len() as f64).sqrt()
}
