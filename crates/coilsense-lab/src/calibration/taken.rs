//! What the calibration that was asked for makes of the points, and what others would make of them.
//!
//! Next door: a relation (`curve`), the words (`answer`).

use coilsense::calibrate::{FitMethod, SteelDoubts};
use coilsense::inductance::SteelCoil;

use super::{CalibrationError, Curve, Measured, Plan, Relation, steel};

/// A relation, fitted to some of the points and judged on the others, or on all where there are no others.
#[derive(Debug, Clone, PartialEq)]
pub struct Taken {
    /// The relation.
    pub curve: Curve,
    /// What is taken from an inductance before it is read, of a spring that was mounted anew \[H\].
    pub shift: f64,
    /// Indices of the points that it was fitted to.
    pub fitted: Vec<usize>,
    /// Indices of those on which it is judged.
    pub judged: Vec<usize>,
    /// What it reads from each point's inductance \[m\], before the spring was mounted anew; NaN where nothing.
    pub read: Vec<f64>,
    /// Root mean square of read less given lengths over the judged points, as a share of the range of all.
    pub rms_share: f64,
    /// Of the steel coil, what is taken as not known.
    pub doubts: Option<SteelDoubts>,
}

/// Another relation on the same points.
#[derive(Debug, Clone, PartialEq)]
pub struct Rival {
    /// Which one.
    pub relation: Relation,
    /// Root mean square on the points that it was not fitted to, as a share of the range: those left over, or each left out in turn; or why it cannot be said.
    pub share: Result<f64, String>,
}

/// How far relations are off on the other points where they are fitted to so many.
#[derive(Debug, Clone, PartialEq)]
pub struct ByNumber {
    /// How many.
    pub fitted: usize,
    /// Root mean square on the others as a share of the range, where it can be fitted to so many.
    pub shares: Vec<(Relation, f64)>,
}

/// What relations make of points that they were not fitted to.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Contest {
    /// On the points left over, or each left out in turn.
    pub rivals: Vec<Rival>,
    /// Over the number of points.
    pub by_number: Vec<ByNumber>,
}

/// Most points of which it is told how many are enough.
const ENOUGH: usize = 6;

/// Most points that are left out in turn.
const LEFT_OUT: usize = 40;

impl Taken {
    /// Whether any point is left that it was not fitted to.
    pub fn has_others(&self) -> bool {
        self.judged.len() + self.fitted.len() == self.read.len() && !self.judged.is_empty()
    }

    /// The length \[m\] read from an inductance \[H\].
    ///
    /// # Errors
    /// [`coilsense::Error`] where there is none.
    pub fn length(&self, inductance: f64) -> Result<f64, coilsense::Error> {
        self.curve.length(inductance - self.shift)
    }

    /// Its standard uncertainty \[m\].
    pub fn length_u(&self, inductance: f64) -> Option<f64> {
        self.curve.length_u(inductance - self.shift)
    }

    /// L \[H\] at a length \[m\].
    pub fn inductance(&self, length: f64) -> f64 {
        self.curve.inductance(length) + self.shift
    }

    /// Read less given length of each point \[m\].
    pub fn residuals(&self, measured: &Measured) -> Vec<f64> {
        self.read.iter().zip(measured.points.lengths()).map(|(read, given)| read - given).collect()
    }

    /// Root mean square of that over all points \[m\].
    pub fn rmse(&self, measured: &Measured) -> f64 {
        share(measured, self.read.iter().copied().enumerate()) * measured.points.range()
    }

    /// Works a plan off; `line` is eq. (13) as the plan has it.
    ///
    /// # Errors
    /// [`CalibrationError`] for too few points, windings that touch, or what the fit refuses.
    pub(super) fn new(measured: &Measured, plan: &Plan, line: Curve) -> Result<(Self, Contest), CalibrationError> {
        let fitted = fitted(measured, plan)?;
        let coil = plan.coil.map(|coil| steel::coil(measured, &coil, &plan.steel));
        let (curve, doubts) = match (plan.relation, &coil, plan.coil) {
            (Relation::InverseLength, ..) => (line, None),
            (Relation::Steel, Some(steel), Some(coil)) => {
                let doubts = steel::doubts(measured, &coil, &plan.steel);
                let steel = steel.as_ref().map_err(CalibrationError::clone)?;
                (fit(measured, &fitted, plan, Some(steel), &doubts)?, Some(doubts))
            }
            (Relation::Steel, ..) => {
                return Err(CalibrationError::new(
                    "theory: needs the coil: --wire, --radius and --windings, or --spec",
                ));
            }
            (Relation::Cubic, ..) => (fit(measured, &fitted, plan, None, &SteelDoubts::default())?, None),
        };
        let shift = shift(measured, plan, &curve)?;
        let (fitted, judged) = judged(measured, plan, fitted)?;
        let read = |&henry: &f64| curve.length(henry).unwrap_or(f64::NAN);
        let read: Vec<f64> = measured.points.inductances().iter().map(read).collect();
        let rms_share = share(measured, judged.iter().map(|&index| (index, read[index])));
        let taken = Self { curve, shift, fitted, judged, read, rms_share, doubts };
        let judge = Judge { measured, plan, coil: coil.as_ref().map(Result::as_ref) };
        let contest = Contest { rivals: judge.rivals(&taken), by_number: judge.by_number() };
        Ok((taken, contest))
    }
}

/// Which points a plan fits.
fn fitted(measured: &Measured, plan: &Plan) -> Result<Vec<usize>, CalibrationError> {
    let all = measured.points.lengths().len();
    let fitted = match plan.points {
        Some(count) if count > all => {
            let message = format!("holds {all} points that can be used, fewer than --points {count}");
            return Err(CalibrationError::of(&measured.file, message));
        }
        Some(count) => measured.some(count),
        None => (0..all).collect(),
    };
    let relation = plan.relation;
    if fitted.len() < relation.fewest() {
        let (count, fewest) = (fitted.len(), relation.fewest());
        let message = format!(
            "{count} points are fewer than the {fewest} that {} needs ({})",
            relation.words(),
            relation.option()
        );
        return Err(CalibrationError::of(&measured.file, message));
    }
    Ok(fitted)
}

fn fit(
    measured: &Measured,
    fitted: &[usize],
    plan: &Plan,
    coil: Option<&SteelCoil>,
    doubts: &SteelDoubts,
) -> Result<Curve, CalibrationError> {
    let curve = Curve::fit(plan.relation, &measured.pick(fitted)?, coil, plan, doubts);
    curve.map_err(|error| CalibrationError::of(&measured.file, error))
}

/// By how much a spring that was mounted anew has more L than the curve \[H\].
fn shift(measured: &Measured, plan: &Plan, curve: &Curve) -> Result<f64, CalibrationError> {
    let Some((length, inductance)) = plan.re_zero else { return Ok(0.0) };
    let now = curve.inductance(length);
    if !now.is_finite() {
        let message = format!("re_zero: {} mm is no length of the calibration", 1e3 * length);
        return Err(CalibrationError::of(&measured.file, message));
    }
    Ok(inductance - now)
}

/// The points that a plan fits in the end, and those on which it is judged: where all are fitted, all.
fn judged(measured: &Measured, plan: &Plan, fitted: Vec<usize>) -> Result<(Vec<usize>, Vec<usize>), CalibrationError> {
    let all = measured.points.lengths().len();
    let method = plan.method.fit(&measured.points, plan.preload)?;
    let fitted = match method {
        FitMethod::TwoPoints { first, last } if plan.relation == Relation::InverseLength && plan.points.is_none() => {
            vec![first, last]
        }
        _ => fitted,
    };
    let mut is_other = vec![true; all];
    fitted.iter().for_each(|&index| is_other[index] = false);
    let others: Vec<usize> = (0..all).filter(|&index| is_other[index]).collect();
    let judged = if others.is_empty() { (0..all).collect() } else { others };
    Ok((fitted, judged))
}

/// Root mean square of read less given lengths over the range of all points.
fn share(measured: &Measured, read: impl Iterator<Item = (usize, f64)>) -> f64 {
    let (mut squares, mut count) = (0.0, 0.0);
    for (index, read) in read {
        squares += (read - measured.points.lengths()[index]).powi(2);
        count += 1.0;
    }
    (squares / count).sqrt() / measured.points.range()
}

/// Fits relations to some points and judges them on others.
struct Judge<'a> {
    measured: &'a Measured,
    plan: &'a Plan,
    coil: Option<Result<&'a SteelCoil, &'a CalibrationError>>,
}

impl Judge<'_> {
    fn fit(&self, relation: Relation, indices: &[usize]) -> Result<Curve, String> {
        let points = self.measured.pick(indices).map_err(|error| error.to_string())?;
        let coil = self.coil.and_then(Result::ok);
        let doubts = steel::without(self.plan.steel.leads);
        Curve::fit(relation, &points, coil, self.plan, &doubts).map_err(|error| error.to_string())
    }

    /// Fitted to some, what it reads at others.
    fn read(&self, relation: Relation, fitted: &[usize], at: &[usize]) -> Result<Vec<(usize, f64)>, String> {
        let curve = self.fit(relation, fitted)?;
        let one = |&index: &usize| {
            let read = curve.length(self.measured.points.inductances()[index]);
            Ok((index, read.map_err(|error| error.to_string())?))
        };
        at.iter().map(one).collect()
    }

    /// Each relation on the points that it was not fitted to.
    fn rivals(&self, taken: &Taken) -> Vec<Rival> {
        let one = |relation: Relation| -> Option<Rival> {
            match (relation, self.coil) {
                (Relation::Steel, None) => return None,
                (Relation::Steel, Some(Err(error))) => return Some(Rival { relation, share: Err(error.to_string()) }),
                _ => (),
            }
            let fewest = relation.fewest();
            let read = if taken.has_others() {
                match taken.fitted.len() < fewest {
                    true => Err(format!("needs {fewest} points")),
                    false => self.read(relation, &taken.fitted, &taken.judged),
                }
            } else {
                let some = self.measured.some(LEFT_OUT);
                if some.len() <= fewest {
                    return None;
                }
                let without = |&left_out: &usize| {
                    let rest: Vec<usize> = some.iter().copied().filter(|&index| index != left_out).collect();
                    self.read(relation, &rest, &[left_out])
                };
                some.iter().map(without).collect::<Result<Vec<_>, String>>().map(|read| read.concat())
            };
            Some(Rival { relation, share: read.map(|read| share(self.measured, read.into_iter())) })
        };
        Relation::ALL.into_iter().filter_map(one).collect()
    }

    /// Each relation fitted to two points and more, on the others.
    fn by_number(&self) -> Vec<ByNumber> {
        let all = self.measured.some(LEFT_OUT);
        let has_coil = matches!(self.coil, Some(Ok(_)));
        // Two at least are left to judge by.
        let one = |fitted: usize| {
            let taken = self.measured.some(fitted);
            let others: Vec<usize> = all.iter().copied().filter(|index| !taken.contains(index)).collect();
            let able = Relation::ALL
                .into_iter()
                .filter(|relation| fitted >= relation.fewest() && (*relation != Relation::Steel || has_coil));
            let judged = able.filter_map(|relation| {
                Some((relation, share(self.measured, self.read(relation, &taken, &others).ok()?.into_iter())))
            });
            ByNumber { fitted, shares: judged.collect() }
        };
        (2..=ENOUGH.min(all.len().saturating_sub(2))).map(one).collect()
    }
}
