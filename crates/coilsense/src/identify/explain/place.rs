//! A law laid on lines: which line is which mode, the parameters that fit, and how much better than chance that is.
//!
//! Next door: the laws (`law`), which are tried (`search`), what else speaks for or against (`ends`, `decays`).

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};

use super::heard::Heard;
use crate::identify::phase_law::{Law, Seat};

/// How far a line may lie off its place because no spring is exactly its model \[1\], relative: each is tried, all are as likely.
const OFF: [f64; 4] = [3e-7, 3e-6, 3e-5, 3e-4];
/// From where on that is more than noise \[1\].
const ROUGH: f64 = 1e-5;
/// By how much more the square of that may be for the faintest lines \[1\].
const FAINTEST: f64 = 30.0;
/// The same while a place is sought.
const OFF_SEARCH: f64 = 1e-4;
/// Highest mode that is looked for.
const HIGHEST: usize = 120;
/// Degrees of freedom of Student's t by which misfits are judged: a line that is off costs, and does not rule.
const FREEDOM: f64 = 4.0;
/// Parameters of a law, at most.
const MOST_KNOBS: usize = 6;
/// Steps of a fit, at most.
const STEPS: usize = 12;

/// A parameter that lines decide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Knob {
    /// ln of the base frequency.
    Base,
    /// 1/N².
    Chain,
    /// ln κ of a seat.
    Kappa(usize),
    /// ln μ of a seat.
    Mu(usize),
    /// ln B.
    Bending,
}

impl Knob {
    /// Bounds.
    fn bounds(self) -> (f64, f64) {
        match self {
            Self::Base => (-3.0, 12.0),
            Self::Chain => (0.0, 0.0625),
            Self::Kappa(_) => (2e-5_f64.ln(), 0.15_f64.ln()),
            Self::Mu(_) => (1e-4_f64.ln(), 1e3_f64.ln()),
            // Below, a belt is a string, whose lines are those of a coil.
            Self::Bending => (1e-4_f64.ln(), 0.3_f64.ln()),
        }
    }

    /// ln of the prior's density at a value: N, κ, μ, B are as likely in every octave of what rigs have.
    fn prior(self, value: f64) -> f64 {
        match self {
            Self::Base => -(5.0_f64.ln()),
            // N from 4 to 300.
            Self::Chain => -(2.0 * value.max(1e-5) * 75.0_f64.ln()).ln(),
            Self::Kappa(_) => -((0.15_f64 / 1e-4).ln().ln()),
            Self::Mu(_) => -((200.0_f64 / 3e-3).ln().ln()),
            Self::Bending => -((0.1_f64 / 1e-4).ln().ln()),
        }
    }

    /// Its value in a law.
    fn of(self, law: Law, base: f64) -> f64 {
        match (self, law) {
            (Self::Base, _) => base.ln(),
            (Self::Chain, Law::Coil { windings, .. }) => {
                if windings.is_finite() {
                    windings.powi(-2)
                } else {
                    0.0
                }
            }
            (Self::Kappa(end), Law::Coil { seats, .. }) => match seats[end] {
                Seat::Gives(kappa, _) => kappa.ln(),
                _ => f64::NAN,
            },
            (Self::Mu(end), Law::Coil { seats, .. }) => match seats[end] {
                Seat::Gives(_, mu) | Seat::Mass(mu) => mu.ln(),
                _ => f64::NAN,
            },
            (Self::Bending, Law::String(bending)) => bending.ln(),
            _ => f64::NAN,
        }
    }

    /// The law with another value, within bounds.
    fn put(self, mut law: Law, mut base: f64, value: f64) -> (Law, f64) {
        let (low, high) = self.bounds();
        let value = value.clamp(low, high);
        match (self, &mut law) {
            (Self::Base, _) => base = value.exp(),
            (Self::Chain, Law::Coil { windings, .. }) => {
                *windings = if value < 1e-8 { f64::INFINITY } else { value.powf(-0.5) };
            }
            (Self::Kappa(end), Law::Coil { seats, .. }) => {
                if let Seat::Gives(kappa, _) = &mut seats[end] {
                    *kappa = value.exp();
                }
            }
            (Self::Mu(end), Law::Coil { seats, .. }) => {
                if let Seat::Gives(_, mu) | Seat::Mass(mu) = &mut seats[end] {
                    *mu = value.exp();
                }
            }
            (Self::Bending, Law::String(bending)) => *bending = value.exp(),
            _ => {}
        }
        (law, base)
    }

    /// Step of a derivative.
    fn step(self, value: f64) -> f64 {
        match self {
            Self::Chain => (1e-4 * value).max(2e-7),
            _ => 1e-5,
        }
    }
}

/// A law with numbers, and which of them are free.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Trial {
    pub(super) law: Law,
    /// Base frequency \[Hz\].
    pub(super) base: f64,
    pub(super) knobs: Vec<Knob>,
}

impl Trial {
    pub(super) fn get(&self, knob: Knob) -> f64 {
        knob.of(self.law, self.base)
    }

    pub(super) fn set(&mut self, knob: Knob, value: f64) {
        (self.law, self.base) = knob.put(self.law, self.base, value);
    }

    /// ln f_j; none where the law has no such mode.
    fn line(&self, mode: usize) -> Option<f64> {
        Some(self.base.ln() + self.law.multiple(mode)?.ln())
    }

    /// ln f_j and its derivatives by the knobs.
    fn slopes(&self, mode: usize) -> Option<(f64, [f64; MOST_KNOBS])> {
        let own = self.law.multiple(mode)?.ln();
        let mut slopes = [0.0; MOST_KNOBS];
        for (slope, knob) in slopes.iter_mut().zip(&self.knobs) {
            if *knob == Knob::Base {
                *slope = 1.0;
                continue;
            }
            let value = self.get(*knob);
            let (law, base) = knob.put(self.law, self.base, value + knob.step(value));
            let moved = knob.of(law, base) - value;
            if moved != 0.0 {
                *slope = (law.multiple(mode)?.ln() - own) / moved;
            }
        }
        Some((self.base.ln() + own, slopes))
    }

    /// Variance of ln f_j by that of the knobs.
    fn variance(&self, slopes: &[f64; MOST_KNOBS], covariance: &DMatrix<f64>) -> f64 {
        let count = self.knobs.len();
        let each = (0..count * count).map(|n| (n / count, n % count));
        each.map(|(row, column)| slopes[row] * covariance[(row, column)] * slopes[column]).sum::<f64>().max(0.0)
    }
}

/// What is heard, and where lines can be.
pub(super) struct Room<'a> {
    /// Lowest frequency first.
    pub(super) heard: &'a [Heard],
    /// Highest frequency that is looked at \[Hz\].
    pub(super) top: f64,
}

impl Room<'_> {
    /// ln of the density of lines per unit of ln f that have nothing to do with one another, at a frequency: as many as were heard, half of
    /// them spread evenly over ln f (five octaves and more), half over f.
    fn chance(&self, frequency: f64) -> f64 {
        let count = self.heard.len().max(2) as f64;
        (count * 0.5 * (1.0 / 5.0 + frequency / self.top)).ln()
    }

    /// ln (density of a line off its place by `off` under the law, over that by chance).
    fn gain(&self, heard: &Heard, off: f64, spread: f64) -> f64 {
        let z = off / spread;
        let student = 0.375_f64.ln() - spread.ln() - 0.5 * (FREEDOM + 1.0) * (1.0 + z * z / FREEDOM).ln();
        student - self.chance(heard.frequency)
    }
}

/// A law laid.
#[derive(Debug, Clone)]
pub(super) struct Place {
    pub(super) trial: Trial,
    /// (index of what is heard, mode), the lowest mode first.
    pub(super) modes: Vec<(usize, usize)>,
    /// By how much it fits better where lines scatter by more than noise \[nats\].
    pub(super) misfit: f64,
    /// Covariance of the knobs.
    pub(super) covariance: DMatrix<f64>,
    /// ln of the evidence over that of lines by chance.
    pub(super) evidence: f64,
}

impl Place {
    /// Standard uncertainty of a knob; infinite where it is none.
    pub(super) fn standard(&self, knob: Knob) -> f64 {
        let index = self.trial.knobs.iter().position(|own| *own == knob);
        index.map_or(f64::INFINITY, |index| self.covariance[(index, index)].max(0.0).sqrt())
    }

    /// Share of what is heard that its modes hold \[1\], by the amplitudes' squares.
    pub(super) fn share(&self, heard: &[Heard]) -> f64 {
        let all: f64 = heard.iter().map(|heard| heard.energy).sum();
        self.modes.iter().map(|(index, _)| heard[*index].energy).sum::<f64>() / all.max(f64::MIN_POSITIVE)
    }

    /// Whether both seats resonate under a coil without windings: one of them may stand for those.
    pub(super) fn mimics_windings(&self) -> bool {
        let Law::Coil { windings, .. } = self.trial.law else { return false };
        windings.is_infinite() && (0..2).all(|end| self.trial.knobs.contains(&Knob::Mu(end)))
    }

    /// Of a sketch.
    pub(super) fn of(room: &Room, sketch: Sketch) -> Option<Self> {
        Self::laid(room, sketch.trial, &sketch.modes)
    }

    /// Laid at once on lines near a trial's places \[1, relative\], then fitted.
    pub(super) fn near(room: &Room, trial: &Trial, within: f64) -> Option<Self> {
        let modes = near(room, trial, within);
        if modes.len() < trial.knobs.len().max(2) {
            return None;
        }
        Self::laid(room, trial.clone(), &modes)
    }

    /// Fitted to lines, laid again, and judged.
    pub(super) fn laid(room: &Room, mut trial: Trial, modes: &[(usize, usize)]) -> Option<Self> {
        let mut modes = modes.to_vec();
        for _ in 0..3 {
            let covariance = fit(room, &mut trial, &modes, OFF_SEARCH, None)?;
            let again = cut(relaid(room, &trial, &covariance));
            if again.len() < 2 {
                return None;
            }
            let again: Vec<(usize, usize)> = again.into_iter().map(|(line, mode, _)| (line, mode)).collect();
            let same = again == modes;
            modes = again;
            if same {
                break;
            }
        }
        let mut found: Option<Self> = None;
        let mut levels = Vec::new();
        let mut misfit = [f64::NEG_INFINITY; 2];
        for off in OFF {
            let mut own = trial.clone();
            let Some(covariance) = fit(room, &mut own, &modes, off, None) else { continue };
            let evidence = evidence(room, &own, &modes, off, &covariance);
            levels.push(evidence);
            let side = &mut misfit[usize::from(off > ROUGH)];
            *side = side.max(evidence);
            if found.as_ref().is_none_or(|best| evidence > best.evidence) {
                found = Some(Self { trial: own, modes: modes.clone(), misfit: 0.0, covariance, evidence });
            }
        }
        let mut found = found?;
        found.misfit = misfit[1] - misfit[0];
        found.evidence = sum_of_logs(&levels) - (OFF.len() as f64).ln();
        Some(found)
    }
}

/// A law laid roughly.
#[derive(Debug, Clone)]
pub(super) struct Sketch {
    pub(super) trial: Trial,
    modes: Vec<(usize, usize)>,
    /// Its evidence, roughly.
    pub(super) score: f64,
}

impl Sketch {
    /// Grown from one line taken for one mode: neighbours first, parameters fitted as they are learnt. `prior`: standard deviation of each knob.
    pub(super) fn grown(room: &Room, trial: &Trial, line: usize, mode: usize, prior: &[f64]) -> Option<Self> {
        let mut trial = trial.clone();
        trial.base = room.heard[line].frequency / trial.law.multiple(mode)?;
        let start: Vec<f64> = trial.knobs.iter().map(|knob| trial.get(*knob)).collect();
        let mut modes = vec![(line, mode)];
        let mut covariance = fit(room, &mut trial, &modes, OFF_SEARCH, Some((&start, prior)))?;
        let (mut low, mut high) = (mode, mode);
        let (mut missed_low, mut missed_high) = (0, 0);
        loop {
            let up = missed_high <= 6 && high < HIGHEST;
            let down = low > 1 && missed_low <= 20;
            // The nearer one first.
            let next = match (up, down) {
                (false, false) => break,
                (true, false) => high + 1,
                (false, true) => low - 1,
                (true, true) if high - mode <= mode - low => high + 1,
                _ => low - 1,
            };
            let upwards = next > high;
            (if upwards { &mut high } else { &mut low }).clone_from(&next);
            let missed = if upwards { &mut missed_high } else { &mut missed_low };
            let Some((place, slopes)) = trial.slopes(next) else {
                *missed = usize::MAX / 2;
                continue;
            };
            if place.exp() > 1.02 * room.top {
                *missed = usize::MAX / 2;
                continue;
            }
            let unsure = trial.variance(&slopes, &covariance).sqrt();
            match nearest(room, place, unsure.min(0.05), OFF_SEARCH, &modes, 0.5) {
                None => *missed += 1,
                Some(line) => {
                    *missed = 0;
                    modes.push((line, next));
                    if modes.len() < 8 || modes.len().is_multiple_of(4) {
                        covariance = fit(room, &mut trial, &modes, OFF_SEARCH, Some((&start, prior)))?;
                    }
                }
            }
        }
        modes.sort_by_key(|entry| entry.1);
        if modes.len() < 2 {
            return None;
        }
        let score = evidence(room, &trial, &modes, OFF_SEARCH, &covariance);
        Some(Self { trial, modes, score })
    }
}

/// ln Σ exp.
pub(super) fn sum_of_logs(values: &[f64]) -> f64 {
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if most == f64::NEG_INFINITY { most } else { most + values.iter().map(|v| (v - most).exp()).sum::<f64>().ln() }
}

/// The line nearest to a place that is not taken, within four standard deviations; `strength`: what e-fold of energy counts against half a
/// square of a standard deviation.
fn nearest(room: &Room, place: f64, unsure: f64, off: f64, taken: &[(usize, usize)], strength: f64) -> Option<usize> {
    let variance = unsure * unsure + off * off;
    let reach = 4.0 * variance.sqrt() + 0.01;
    let from = room.heard.partition_point(|heard| heard.log < place - reach);
    let near = room.heard[from..].iter().take_while(|heard| heard.log < place + reach);
    let mut best: Option<(usize, f64)> = None;
    for (index, heard) in near.enumerate() {
        let z = (heard.log - place) / (variance + heard.spread * heard.spread).sqrt();
        let score = strength * heard.energy.max(f64::MIN_POSITIVE).ln() - 0.5 * z * z;
        let free = !taken.iter().any(|entry| entry.0 == from + index);
        if free && z.abs() < 4.0 && best.is_none_or(|(_, old)| score > old) {
            best = Some((from + index, score));
        }
    }
    best.map(|(index, _)| index)
}

/// Lines within a relative distance of a trial's places.
fn near(room: &Room, trial: &Trial, within: f64) -> Vec<(usize, usize)> {
    let mut modes: Vec<(usize, usize)> = Vec::new();
    for mode in 1..=HIGHEST {
        let Some(place) = trial.line(mode) else { break };
        if place.exp() > 1.02 * room.top {
            break;
        }
        if let Some(line) = nearest(room, place, 0.25 * within, 0.0, &modes, 0.0) {
            modes.push((line, mode));
        }
    }
    modes
}

/// Without the highest modes where these explain less than all those cost that are not heard below them.
fn cut(mut modes: Vec<(usize, usize, f64)>) -> Vec<(usize, usize, f64)> {
    let mut sum = 0.0;
    let mut best = (f64::NEG_INFINITY, 0);
    for (index, &(_, mode, gain)) in modes.iter().enumerate() {
        sum += gain;
        let total = sum + unheard_cost(index + 1, mode - index - 1);
        if total > best.0 {
            best = (total, index + 1);
        }
    }
    modes.truncate(best.1);
    modes
}

/// Lines that a fitted trial explains better than chance: (line, mode, by how much).
fn relaid(room: &Room, trial: &Trial, covariance: &DMatrix<f64>) -> Vec<(usize, usize, f64)> {
    let mut modes: Vec<(usize, usize, f64)> = Vec::new();
    for mode in 1..=HIGHEST {
        let Some((place, slopes)) = trial.slopes(mode) else { break };
        if place.exp() > 1.02 * room.top {
            break;
        }
        let unsure = trial.variance(&slopes, covariance).sqrt().min(0.01);
        let from = room.heard.partition_point(|heard| heard.log < place - 0.02);
        let reachable = room.heard[from..].iter().take_while(|heard| heard.log < place + 0.02);
        let variance = unsure * unsure + OFF_SEARCH * OFF_SEARCH;
        let gain = |index: usize, heard: &Heard| {
            let gain = room.gain(heard, heard.log - place, (variance + heard.spread * heard.spread).sqrt());
            let free = !modes.iter().any(|entry| entry.0 == from + index);
            (free && gain > 0.0).then_some((from + index, gain))
        };
        let best =
            reachable.enumerate().filter_map(|(index, heard)| gain(index, heard)).max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((line, gain)) = best {
            modes.push((line, mode, gain));
        }
    }
    modes
}

/// Fits the knobs to lines by Levenberg and Marquardt, misfits weighed after Student; the covariance. `start`: where they are expected and
/// how sure that is.
fn fit(
    room: &Room,
    trial: &mut Trial,
    modes: &[(usize, usize)],
    off: f64,
    start: Option<(&[f64], &[f64])>,
) -> Option<DMatrix<f64>> {
    let count = trial.knobs.len();
    // What lines do to one another moves the faint ones more.
    let loudest = modes.iter().map(|(line, _)| room.heard[*line].energy).fold(f64::MIN_POSITIVE, f64::max);
    let faint = |heard: &Heard| if off > OFF_SEARCH { (loudest / heard.energy).min(FAINTEST) } else { 1.0 };
    let state = |trial: &Trial| -> Option<(f64, DMatrix<f64>, DVector<f64>)> {
        let (mut normal, mut right, mut cost) = (DMatrix::zeros(count, count), DVector::zeros(count), 0.0);
        for &(line, mode) in modes {
            let heard = &room.heard[line];
            let (place, slopes) = trial.slopes(mode)?;
            let (left, variance) = (heard.log - place, heard.spread * heard.spread + off * off * faint(heard));
            let z2 = left * left / variance;
            cost += 0.5 * (FREEDOM + 1.0) * (1.0 + z2 / FREEDOM).ln();
            let weight = (FREEDOM + 1.0) / (FREEDOM + z2) / variance;
            for row in 0..count {
                right[row] += weight * slopes[row] * left;
                for column in 0..count {
                    normal[(row, column)] += weight * slopes[row] * slopes[column];
                }
            }
        }
        if let Some((centre, prior)) = start {
            for (index, knob) in trial.knobs.iter().enumerate().filter(|(_, knob)| **knob != Knob::Base) {
                let left = centre[index] - trial.get(*knob);
                cost += 0.5 * (left / prior[index]).powi(2);
                right[index] += left / prior[index].powi(2);
                normal[(index, index)] += prior[index].powi(-2);
            }
        }
        Some((cost, normal, right))
    };
    let (mut cost, mut normal, mut right) = state(trial)?;
    let mut damping = 1e-6;
    for _ in 0..STEPS {
        let mut damped = normal.clone();
        for index in 0..count {
            damped[(index, index)] = damped[(index, index)] * (1.0 + damping) + 1e-12;
        }
        let step = damped.cholesky()?.solve(&right);
        let mut next = trial.clone();
        for (knob, change) in trial.knobs.iter().zip(step.iter()) {
            let most = if matches!(knob, Knob::Kappa(_) | Knob::Mu(_) | Knob::Bending) { 1.0 } else { f64::INFINITY };
            next.set(*knob, trial.get(*knob) + change.clamp(-most, most));
        }
        match state(&next) {
            Some((lower, of_normal, of_right)) if lower <= cost => {
                let still = cost - lower < 1e-7;
                (cost, normal, right) = (lower, of_normal, of_right);
                *trial = next;
                damping *= 0.1;
                if still {
                    break;
                }
            }
            _ => {
                damping = (10.0 * damping).max(1e-4);
                if damping > 1e8 {
                    break;
                }
            }
        }
    }
    // A knob that the lines do not decide is as unsure as its bounds.
    for (index, knob) in trial.knobs.iter().enumerate() {
        let (low, high) = knob.bounds();
        normal[(index, index)] += ((high - low) / 4.0).powi(-2);
    }
    normal.cholesky().map(|factor| factor.inverse())
}

/// ln of the evidence of a fitted trial: each mode's line over chance, modes that are not heard, and what its knobs could have been (Laplace).
fn evidence(room: &Room, trial: &Trial, modes: &[(usize, usize)], off: f64, covariance: &DMatrix<f64>) -> f64 {
    let of = |&(line, mode): &(usize, usize)| {
        let heard = &room.heard[line];
        let place = trial.line(mode).unwrap_or(f64::NAN);
        room.gain(heard, heard.log - place, (heard.spread * heard.spread + off * off).sqrt())
    };
    let lines: f64 = modes.iter().map(of).sum();
    let highest = modes.iter().map(|entry| entry.1).max().unwrap_or(0);
    let unheard = highest.saturating_sub(modes.len());
    let knobs = trial.knobs.iter().enumerate().map(|(index, knob)| match (knob, trial.law) {
        (Knob::Base, Law::Mains(_)) => -(4e-3_f64.ln()),
        // 1/N² that the lines do not tell from zero takes no more than all of its prior.
        (Knob::Chain, _) => {
            let standard = covariance[(index, index)].max(1e-300).sqrt();
            knob.prior(trial.get(*knob)).min(-(TAU.sqrt() * standard).ln())
        }
        _ => knob.prior(trial.get(*knob)),
    });
    let volume = 0.5 * (trial.knobs.len() as f64 * TAU.ln() + covariance.determinant().max(1e-300).ln());
    lines + unheard_cost(modes.len(), unheard) + knobs.sum::<f64>() + volume
}

/// ln ∫ p^a (1 − p)^b dp: a modes heard and b not, whatever the share that is heard.
fn unheard_cost(heard: usize, unheard: usize) -> f64 {
    let factorial = |n: usize| (1..=n).map(|k| (k as f64).ln()).sum::<f64>();
    factorial(heard) + factorial(unheard) - factorial(heard + unheard + 1)
}

impl Room<'_> {
    /// ln of a law's multiples, as many as lie below the top for a base \[Hz\].
    pub(super) fn table(&self, law: Law, base: f64) -> Vec<f64> {
        let most = (self.top / base).ln();
        (1..=HIGHEST).map_while(|mode| law.multiple(mode).map(f64::ln)).take_while(|log| *log < most).collect()
    }

    /// How well multiples lie on the lines before anything is fitted: gains of the nearest lines less a share for what is not heard.
    pub(super) fn rough(&self, table: &[f64], base: f64, within: f64) -> f64 {
        let (log, top) = (base.ln(), self.top.ln());
        let mut from = 0;
        let mut sum = 0.0;
        for place in table.iter().map(|multiple| log + multiple).take_while(|place| *place < top) {
            while from < self.heard.len() && self.heard[from].log < place {
                from += 1;
            }
            let gain = |index: usize| {
                let heard = self.heard.get(index)?;
                let off = heard.log - place;
                (off.abs() < 8.0 * within + 4.0 * heard.spread)
                    .then(|| self.gain(heard, off, (within * within + heard.spread * heard.spread).sqrt()))
            };
            sum += gain(from).into_iter().chain(from.checked_sub(1).and_then(gain)).fold(-0.7, f64::max);
        }
        sum
    }
}
