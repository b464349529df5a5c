//! The steps from signals to an identification.
//!
//! Next door: each step in its own file.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::channel_check::{self, Conditions};
use super::end_motion::receptance;
use super::explain::{Coil, Heard, Known, Weighed, weigh};
use super::line::{Line, Meaning};
use super::lines::{Peak, steady};
use super::mode_series::{Observation, folded};
use super::record_lines::{RecordLines, seen};
use super::ringing::{Part, Rings, Series, rings};
use super::whitening::Surprise;
use super::{Answer, Estimate, Hit, Identification, ModeSeries, Sampling, Settings, Stiffness, Trust, Verdict, Welch};
use super::{beginning, half_power, hits, naming, prediction, ring_down, satellites, signs, verdict, weak_lines};
use crate::error::Error;
use crate::measures::alias_of;
use crate::mount::FarEnd;
use crate::signals::{Channel, Signals};

/// Up to this share of its corner a low-pass leaves amplitudes as they are.
const PASSED: f64 = 0.5;
/// End 2 counts as moving where k times its motion is this share of the force that rings.
const MOVES: f64 = 0.2;

impl Identification {
    /// Of a record with at least one force (F_i, F_o, F_L), sampled evenly; everything else helps.
    ///
    /// f1, ζ_j: several hits' ring-downs fitted together, λ = −ζω + iω√(1−ζ²); k, l0: least squares of slow parts; τ = 1/2f1 (for N given:
    /// 2N sin(π/2N)/(2π f1)); m = kτ². Intervals are of 95 %.
    ///
    /// Source:   see each step; the modes are those of [`crate::modes::ChainModes`].
    /// Valid:    linear ringing of light damping (ζ up to 0.1), hits shorter than 4 ms or their echo, ends held or with a free mass.
    /// Accuracy: 600 records of a minute (ζ 0.001 to 0.05, three springs): see `tests/identify`, which holds the figures.
    ///
    /// # Errors
    /// [`Error::MissingSignal`] without a force; [`Error::Count`] for fewer than 64 samples; [`Error::Value`] for uneven times or
    /// settings outside of their range.
    pub fn of(signals: &Signals, settings: &Settings) -> Result<Self, Error> {
        let settings = settings.checked()?.clone();
        let turned = match settings.turned {
            Some(channel) => Some(signs::with_turned(signals, channel).ok_or(Error::MissingSignal(channel.name()))?),
            None => None,
        };
        let signals = turned.as_ref().unwrap_or(signals);
        let recorded = Sampling::of(signals)?;
        let channels = channel_check::check(signals, &recorded);
        let left_out = channel_check::without_slow_motion(&channels);
        let stiffness = Stiffness::of(signals, &left_out, &channel_check::limits(&channels), &recorded, &settings);
        let paced = channel_check::at_own_pace(signals, &channels);
        let signals = paced.as_ref().unwrap_or(signals);
        let sampling = Sampling::of(signals)?;
        let conditions = Conditions::of(signals, &channels);
        let Rings { series, quick, slow } = rings(signals, &sampling, stiffness.as_ref().ok(), &conditions)?;
        let hits = hits_of(&series, [quick, slow], &sampling, &conditions);
        let (steady_peaks, spectra) = spectra_of(&series, &sampling);
        let spacing = spectra.first().map_or(1.0, |(_, welch)| welch.spacing);
        let RecordLines { lines, foldings, mut heard } =
            RecordLines::of(&series, &hits, &sampling, &steady_peaks, spacing);
        if let Some(corner) = conditions.low_pass {
            heard.iter_mut().for_each(|one| one.sized = one.frequency() < PASSED * corner);
        }
        let mut found = Self {
            channels,
            sampling,
            settings,
            has_both_forces: series.len() > 1,
            stiffness,
            hits,
            lines,
            mode_series: None,
            explanations: Vec::new(),
            first_range: None,
            mass_range: None,
            ratio_mode: None,
            turned: None,
            opposed: false,
            fitted_windings: None,
            windings_left_out: false,
            end_mass: None,
            first_frequency: None,
            ratio: None,
            transit_time: None,
            mass: None,
            predicted: None,
            trust: None,
            spectra,
            noise: series.iter().map(|one| (one.part, one.noise)).collect(),
            ring_down: None,
            verdict: Verdict { answer: Answer::Undecided, evidence: Vec::new(), next: Vec::new() },
        };
        let weighed = found.explain(signals, &foldings, &heard);
        Ok(found.concluded(weighed, &series))
    }

    /// With all that follows from the lines and what explains them.
    fn concluded(mut self, mut weighed: Weighed, series: &[Series]) -> Self {
        self.stiffness =
            self.stiffness.and_then(|stiffness| stiffness.beside_mass(self.first_frequency.map(|first| first.value)));
        self.predict();
        self.unfold();
        let coil = weighed.coil.as_ref().filter(|_| self.first_frequency.is_some());
        weighed.doubt = coil.and_then(|coil| prediction::doubt(&self, coil));
        if weighed.doubt.is_some() {
            self.forget();
        }
        self.derive();
        self.verdict = verdict::verdict(&self, &weighed);
        self.satellites(&mut weighed, series);
        self.half_powers(series);
        self.ring_down = ring_down::of(&self.lines, series, &self.hits, &self.sampling);
        self.verdict.evidence.extend(channel_check::sentences(&self.channels));
        self
    }

    /// Names lines of a spring that are no axial modes, and adds those that the modes hide.
    fn satellites(&mut self, weighed: &mut Weighed, series: &[Series]) {
        let Some(coil) = weighed.coil.as_mut().filter(|_| self.verdict.answer == Answer::Spring) else { return };
        let weak = weak_lines::beside_modes(&self.lines, series, &self.hits, &self.sampling);
        let (said, no_second) = satellites::name(&mut self.lines, weak, coil);
        if no_second {
            coil.second = None;
            self.verdict = verdict::verdict(self, weighed);
        }
        self.verdict.evidence.extend(said);
    }

    /// Weighs what explains the lines, names them by it, and takes its numbers over.
    fn explain(&mut self, signals: &Signals, foldings: &[f64], heard: &[Heard]) -> Weighed {
        let motions = self.motions(signals, foldings);
        let signs = signs::of(signals, &self.sampling);
        let u2 = signals.channel(Channel::U2).is_ok() && self.stiffness.is_ok();
        let known = Known::of(&self.settings, self.has_both_forces, u2.then_some(motions.end_moves), signs.opposed);
        let weighed = weigh(heard, &known, 0.5 * self.sampling.rate);
        let coil = weighed.coil.as_ref();
        let aliases = coil.map_or_else(Vec::new, |coil| self.aliases(coil));
        naming::name(&mut self.lines, coil, &aliases, self.sampling.rate, &motions.follows);
        self.explanations = weighed.ranked.clone();
        self.turned = signs.turned;
        self.opposed = self.turned.is_none() && (signs.opposed == Some(true) || coil.is_some_and(|coil| coil.turned));
        if let Some(coil) = coil {
            self.adopt(coil);
            if matches!(coil.mode_series, ModeSeries::EndMass { .. }) {
                self.end_mass = self.end_mass_of(signals, foldings).map(|(mass, _)| mass);
            }
        }
        weighed
    }

    /// Lines that modes above half the sampling rate fold to.
    fn aliases(&self, coil: &Coil) -> Vec<(usize, usize, f64)> {
        let seen: Vec<Observation> = self.lines.iter().map(|line| seen(line, self.has_both_forces)).collect();
        let taken: Vec<usize> = coil.modes.iter().map(|entry| entry.0).collect();
        folded(&seen, coil.mode_series, coil.first, coil.windings, self.sampling.rate, &taken)
    }

    /// Takes a coil's numbers over.
    fn adopt(&mut self, coil: &Coil) {
        self.mode_series = Some(coil.mode_series);
        let fitted = self.settings.windings.is_none() || coil.other_windings.is_some();
        self.fitted_windings = (fitted && coil.windings.is_finite()).then_some(coil.windings);
        self.windings_left_out = coil.other_windings.is_some();
        let lowest = coil.modes.iter().find(|(line, _, _)| self.lines[*line].mode().is_some());
        let Some(&(line, mode, _)) = lowest else { return };
        self.first_frequency = Some(Estimate::new(coil.first, coil.first * coil.spread, coil.factor));
        self.first_range = Some(coil.range);
        self.ratio = self.lines[line].ratio;
        self.ratio_mode = self.ratio.map(|_| mode);
    }

    /// M \[kg\] from F_o over the end's acceleration in the lowest line (or as given), and m/M: tan β/β = k/(Mω²).
    fn end_mass_of(&self, signals: &Signals, foldings: &[f64]) -> Option<(f64, f64)> {
        let stiffness = self.stiffness.as_ref().ok()?.value();
        let lowest =
            (0..self.lines.len()).find(|&index| self.lines[index].decays && self.lines[index].strength > 100.0)?;
        let angular = TAU * self.lines[lowest].frequency.value;
        let mass = match self.settings.far_end {
            Some(FarEnd::Mass(mass)) => mass,
            _ => {
                let (force, position) =
                    (signals.channel(Channel::OutputForce).ok()?, signals.channel(Channel::U2).ok()?);
                let per_motion = receptance(
                    force,
                    position,
                    self.lines[lowest].frequency.value,
                    foldings[lowest],
                    &self.hits,
                    &self.sampling,
                );
                per_motion.re / (angular * angular)
            }
        };
        let quotient = stiffness / (mass * angular * angular);
        // A mass that the force does not feel is none.
        if !(mass > 0.0 && quotient > 1.0 && quotient < 1e6) {
            return None;
        }
        let (mut low, mut high) = (0.0, FRAC_PI_2);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if middle.tan() < quotient * middle { low = middle } else { high = middle }
        }
        Some((mass, low * low.tan()))
    }

    /// ω1 τ: π for the continuous coil, 2N sin(π/2N) for a chain, whose first line lies lower.
    fn turns(&self) -> f64 {
        let said = self.settings.windings.filter(|_| !self.windings_left_out);
        let windings = self.fitted_windings.or(said);
        windings.map_or(PI, |windings| 2.0 * windings * (FRAC_PI_2 / windings).sin())
    }

    /// f1 from a spec, or from mass and stiffness.
    fn predict(&mut self) {
        let by_mass = |mass: f64| {
            let stiffness = self.stiffness.as_ref().ok()?.value();
            Some(self.turns() / TAU * (stiffness / mass).sqrt())
        };
        self.predicted = self.settings.predicted.or(self.settings.mass.and_then(by_mass));
    }

    /// Where the predicted f1 lies above half the sampling rate, the line that it folds to is no f1: nothing follows from it.
    fn unfold(&mut self) {
        let rate = self.sampling.rate;
        let Some(predicted) = self.predicted.filter(|predicted| *predicted > 0.5 * rate) else { return };
        let shown = alias_of(predicted, rate);
        let room = self.settings.prediction_tolerance * predicted;
        let near = |line: &&mut Line| line.decays && (line.frequency.value - shown).abs() < room;
        let strongest = self.lines.iter_mut().filter(near).max_by(|a, b| a.strength.total_cmp(&b.strength));
        if let Some(line) = strongest {
            line.meaning = Meaning::Alias { mode: 1, frequency: predicted };
            line.reason = format!("where mode 1, predicted at {predicted:.2} Hz, folds to at {rate:.0} Hz");
            self.forget_numbers();
        }
    }

    /// Takes back what a coil's series said of the lines and of the spring.
    fn forget(&mut self) {
        for line in
            self.lines.iter_mut().filter(|line| matches!(line.meaning, Meaning::Mode(_) | Meaning::Alias { .. }))
        {
            line.meaning = Meaning::Unknown;
            line.reason = "decays after hits; its cause is open".to_owned();
        }
        self.forget_numbers();
    }

    /// The same of the spring alone.
    fn forget_numbers(&mut self) {
        (self.first_frequency, self.ratio, self.mode_series, self.fitted_windings) = (None, None, None, None);
        (self.first_range, self.mass_range, self.ratio_mode, self.end_mass) = (None, None, None, None);
    }

    /// Whether a line is the first mode of the series that fits.
    pub fn has_first_mode(&self) -> bool {
        self.lines.iter().any(|line| line.decays && line.mode() == Some(1))
    }

    /// What follows from f1 and k.
    fn derive(&mut self) {
        let stiffness = self.stiffness.as_ref().ok().map(|found| found.stiffness);
        let turns = self.turns();
        let Some(first) = self.first_frequency else { return };
        let time = turns / (TAU * first.value);
        self.transit_time = Some(first.scaled(time / first.value));
        if let Some(k) = stiffness {
            let mass = k.value * time * time;
            let relative = |of: fn(&Estimate) -> f64| mass * (of(&k) / k.value).hypot(2.0 * of(&first) / first.value);
            self.mass =
                Some(Estimate { value: mass, standard: relative(|e| e.standard), expanded: relative(|e| e.expanded) });
            // m goes with f1 to the power of −2, so the highest f1 makes the least m; k's own share is added.
            self.mass_range = self.first_range.map(|(low, high)| {
                let own = k.expanded / k.value;
                let at = |frequency: f64, share: f64| mass * (first.value / frequency).powi(2) * share;
                (at(high, 1.0 - own), at(low, 1.0 + own))
            });
        }
        self.trust = Trust::of(time, self.settings.tolerance).ok();
    }

    fn half_powers(&mut self, series: &[Series]) {
        for line in &mut self.lines {
            let Some(ratio) = line.ratio.filter(|_| line.decays) else { continue };
            let of = |part: &Part| series.iter().find(|series| series.part == *part);
            let Some(series) = line.part.as_ref().and_then(of).or(series.first()) else { continue };
            let folding = 1.0 / (TAU * line.frequency.value * ratio.value);
            line.half_power = half_power::ratio(series, &self.hits, &self.sampling, line.frequency.value, folding);
        }
    }

    /// Which ends move while lines ring.
    fn motions(&self, signals: &Signals, foldings: &[f64]) -> Motions {
        let mut motions = Motions { follows: vec![None; self.lines.len()], end_moves: false };
        let Ok(stiffness) = &self.stiffness else { return motions };
        let ends = [Channel::InputForce, Channel::OutputForce];
        let Some(force) = ends.iter().find_map(|channel| signals.channel(*channel).ok()) else { return motions };
        let (first, second) = (signals.channel(Channel::U1).ok(), signals.channel(Channel::U2).ok());
        let mut strongest = 0.0;
        for (index, line) in self.lines.iter().enumerate() {
            let of = |position: Option<&[f64]>| {
                let hits: &[Hit] = if line.decays { &self.hits } else { &[] };
                let ratio =
                    position.map(|x| receptance(x, force, line.frequency.value, foldings[index], hits, &self.sampling));
                stiffness.value() * ratio.unwrap_or_default()
            };
            let (first, second) = (of(first), of(second));
            if !line.decays {
                motions.follows[index] = Some((second - first).re);
            }
            if line.decays && line.strength > strongest {
                strongest = line.strength;
                motions.end_moves = second.norm() > MOVES;
            }
        }
        motions
    }
}

/// The hits, or where the record begins to ring.
fn hits_of(series: &[Series], surprises: [Surprise; 2], sampling: &Sampling, conditions: &Conditions) -> Vec<Hit> {
    let mut hits = hits::find(surprises, series.len(), sampling, conditions);
    if hits.is_empty() {
        hits.extend(beginning::of(series, sampling));
    }
    hits::begin_behind(&mut hits, sampling, conditions);
    hits
}

/// Steady lines and the spectrum of each series.
fn spectra_of(series: &[Series], sampling: &Sampling) -> (Vec<Peak>, Vec<(Part, Welch)>) {
    let mut spectra = Vec::new();
    let mut steady_peaks = Vec::new();
    for (index, one) in series.iter().enumerate() {
        let (peaks, welch) = steady(index, one, sampling);
        steady_peaks.extend(peaks);
        spectra.push((one.part, welch));
    }
    (steady_peaks, spectra)
}

/// Which ends move while lines ring.
struct Motions {
    /// k X/F of steady lines.
    follows: Vec<Option<f64>>,
    /// Whether end 2 moves in the strongest line that decays.
    end_moves: bool,
}
