//! What the calibration that was asked for makes of the points, and what others would make of them.
//!
//! Next door: a relation (`curve`), the words (`answer`).

use coilsense::calibrate::{FitMethod, InverseLengthFit, ReadingUncertainty, SteelDoubts};
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

    /// Works a plan off.
    ///
    /// # Errors
    /// [`CalibrationError`] for too few points, windings that touch, or what the fit refuses.
    pub(super) fn new(measured: &Measured, plan: &Plan) -> Result<(Self, Contest), CalibrationError> {
        let all = measured.points.lengths().len();
        let fitted: Vec<usize> = match plan.points {
            Some(count) if count > all => {
                let message = format!("holds {all} points that can be used, fewer than --points {count}");
                return Err(CalibrationError::of(&measured.file, message));
            }
            Some(count) => measured.some(count),
            None => (0..all).collect(),
        };
        if fitted.len() < plan.relation.fewest() {
            let message = format!(
                "{} points are fewer than the {} that {} needs ({})",
                fitted.len(),
                plan.relation.fewest(),
                plan.relation.words(),
                plan.relation.option()
            );
            return Err(CalibrationError::of(&measured.file, message));
        }
        let refuse = |error: coilsense::Error| CalibrationError::of(&measured.file, error);
        let coil = match (plan.relation, plan.coil) {
            (Relation::Steel, None) => {
                return Err(CalibrationError::new(
                    "theory: needs the coil: --wire, --radius and --windings, or --spec",
                ));
            }
            (_, None) => None,
            (_, Some(coil)) => {
                Some((steel::coil(measured, &coil, &plan.steel), steel::doubts(measured, &coil, &plan.steel)))
            }
        };
        let coil = match (plan.relation, coil) {
            (Relation::Steel, Some((coil, doubts))) => Some((Ok(coil?), doubts)),
            (_, coil) => coil,
        };
        let of_steel = coil.as_ref().and_then(|(coil, doubts)| Some((coil.as_ref().ok()?, doubts)));
        let points = measured.pick(&fitted)?;
        let curve = match (plan.relation, plan.points) {
            // As told by the method, which may pass some points exactly.
            (Relation::InverseLength, None) => {
                let method = plan.method.fit(&measured.points, plan.preload)?;
                Curve::InverseLength(
                    InverseLengthFit::new(&points, method).map_err(refuse)?,
                    ReadingUncertainty::new(&points, method).map_err(refuse)?,
                )
            }
            (relation, _) => {
                let doubts = of_steel.map_or_else(SteelDoubts::default, |(_, doubts)| *doubts);
                Curve::fit(relation, &points, of_steel.map(|(coil, _)| coil), plan, &doubts).map_err(refuse)?
            }
        };
        let shift = match plan.re_zero {
            Some((length, inductance)) => {
                let now = curve.inductance(length);
                if !now.is_finite() {
                    let message = format!("re_zero: {} mm is no length of the calibration", 1e3 * length);
                    return Err(CalibrationError::of(&measured.file, message));
                }
                inductance - now
            }
            None => 0.0,
        };
        // Where all points were fitted there is none that was not.
        let mut is_other = vec![true; all];
        fitted.iter().for_each(|&index| is_other[index] = false);
        let others: Vec<usize> = (0..all).filter(|&index| is_other[index]).collect();
        let by_ends = matches!(plan.method.fit(&measured.points, plan.preload)?, FitMethod::TwoPoints { .. });
        let (fitted, judged) = match (plan.relation, plan.points, others.is_empty()) {
            (Relation::InverseLength, None, _) if by_ends && all > 2 => (vec![0, all - 1], (1..all - 1).collect()),
            (_, _, true) => (fitted, (0..all).collect()),
            _ => (fitted, others),
        };
        let mut taken = Self { curve, shift, fitted, judged, read: Vec::new(), rms_share: 0.0, doubts: None };
        taken.read =
            measured.points.inductances().iter().map(|&henry| taken.curve.length(henry).unwrap_or(f64::NAN)).collect();
        taken.rms_share = share(measured, taken.judged.iter().map(|&index| (index, taken.read[index])));
        taken.doubts = of_steel.filter(|_| plan.relation == Relation::Steel).map(|(_, doubts)| *doubts);
        let coil = coil.as_ref().map(|(coil, _)| coil.as_ref());
        let judge = Judge { measured, plan, coil };
        Ok((taken.clone(), Contest { rivals: judge.rivals(&taken), by_number: judge.by_number() }))
    }
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
