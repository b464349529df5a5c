//! Spring, not the spring, or undecided: from the evidence, with what to record next.
//!
//! Next door: the evidence (the parent).

use super::Identification;
use super::explain::{Coil, Weighed};
use super::line::Meaning;
use super::phase_law::{Seat, mode_of};
use super::reasons;

/// The answer to "is it the spring that rings?".
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Answer {
    /// The spring's own modes ring.
    Spring,
    /// Something else does.
    NotTheSpring,
    /// The record does not tell.
    Undecided,
}

impl Answer {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Spring => "spring",
            Self::NotTheSpring => "not the spring",
            Self::Undecided => "undecided",
        }
    }
}

/// The answer with its reasons.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// The answer.
    pub answer: Answer,
    /// Why, the weightiest first; at least one.
    pub evidence: Vec<String>,
    /// What to record next; empty where nothing is missing.
    pub next: Vec<String>,
}

/// Amplitude below which a line decides nothing, relative to the largest.
pub(super) const SMALL: f64 = 0.05;
/// How much more the coil explains than any other cause, at least \[nats\]: the chance of its coming about otherwise is 1 in 1100.
const LEAD: f64 = 7.0;
/// How much of that the places of the lines alone have to say \[nats\].
const PLACES: f64 = 4.0;
/// Share of the ringing's power that the coil's modes hold, and of the loud lines that are its modes, at least \[1\].
pub(super) const EXPLAINED: f64 = 0.6;
const EXPLAINED_LOUD: f64 = 0.7;
/// Steady lines between a coil's modes that make another coil of it, at least; which modes are looked at; how near they have to lie, in the
/// finer coil's f1 \[1\].
const FEWEST_BETWEEN: usize = 3;
const MOST_BETWEEN: usize = 60;
const CHANCE: f64 = 0.03;
/// Probability that f1 is off by more than 1 %, at most.
const MOVED: f64 = 0.12;

pub(super) fn verdict(found: &Identification, weighed: &Weighed) -> Verdict {
    let (answer, mut evidence) = answer(found, weighed);
    evidence.extend(reasons::turned(found));
    Verdict { answer, evidence, next: next(found, answer) }
}

fn answer(found: &Identification, weighed: &Weighed) -> (Answer, Vec<String>) {
    let decaying = found.lines.iter().filter(|line| line.decays).count();
    let agrees = match (found.predicted, found.first_frequency) {
        (Some(predicted), Some(first)) => {
            Some((first.value / predicted - 1.0).abs() <= found.settings.prediction_tolerance)
        }
        _ => None,
    };
    if let Some(line) = found.lines.iter().find(|line| matches!(line.meaning, Meaning::Alias { mode: 1, .. })) {
        let evidence = format!("a line at {:.2} Hz is {}: it may be the spring's", line.frequency.value, line.reason);
        return (Answer::Undecided, vec![evidence]);
    }
    if let Some(doubt) = &weighed.doubt {
        return (Answer::Undecided, vec![doubt.clone()]);
    }
    let Some(coil) = weighed.coil.as_ref().filter(|_| found.first_frequency.is_some()) else {
        return without_series(found, decaying, 0);
    };
    let modes = coil.modes.len();
    let leads = coil.lead >= LEAD && coil.by_places >= PLACES;
    if agrees == Some(false) {
        let predicted = found.predicted.unwrap_or(f64::NAN);
        let line = format!(
            "what rings has f1 = {:.2} Hz, the spring would have {predicted:.2} Hz ({:+.1} %)",
            coil.first,
            100.0 * (coil.first / predicted - 1.0)
        );
        // A series of its own may be this spring with another mass than was said.
        return (if leads { Answer::Undecided } else { Answer::NotTheSpring }, vec![line]);
    }
    if agrees == Some(true) && coil.lead > 0.0 || agrees == Some(true) && modes < 3 {
        let mut evidence = reasons::series(found, coil);
        let (first, predicted) = (coil.first, found.predicted.unwrap_or(f64::NAN));
        evidence.push(format!("f1 = {first:.2} Hz agrees with the {predicted:.2} Hz predicted"));
        return (Answer::Spring, evidence);
    }
    if !leads {
        return if modes < 3 || decaying < 3 {
            without_series(found, decaying, modes)
        } else {
            (Answer::Undecided, vec![reasons::no_lead(decaying, coil, &weighed.rival)])
        };
    }
    let mut evidence = reasons::series(found, coil);
    if 2.0 * coil.first > 0.5 * found.sampling.rate {
        evidence.push(format!(
            "sampled at {:.0} Hz it may as well be a line above {:.0} Hz, folded",
            found.sampling.rate,
            0.5 * found.sampling.rate
        ));
        return (Answer::Undecided, evidence);
    }
    if coil.share < EXPLAINED || coil.loud < EXPLAINED_LOUD {
        return (Answer::Undecided, vec![reasons::unexplained(coil)]);
    }
    if let Some((divisor, steady)) = steady_between(found, coil) {
        return (Answer::Undecided, vec![reasons::steady_between(coil, divisor, steady)]);
    }
    if coil.moved > MOVED {
        return (Answer::Undecided, vec![reasons::moved(coil)]);
    }
    (Answer::Spring, evidence)
}

/// Steady lines between the modes of a coil, where those of one with half or a third of its f1 would lie: (divisor, how many).
fn steady_between(found: &Identification, coil: &Coil) -> Option<(usize, usize)> {
    let between = |divisor: usize| {
        let base = coil.first / divisor as f64;
        let places: Vec<f64> = (1..MOST_BETWEEN)
            .filter(|mode| mode % divisor != 0)
            .map_while(|mode| mode_of(coil.windings * divisor as f64, [Seat::Rigid; 2], mode))
            .map(|mode| base * mode.multiple)
            .take_while(|place| *place < 0.5 * found.sampling.rate)
            .collect();
        // Between neighbours, this share of all frequencies would count by chance.
        let near = |frequency: f64| places.iter().any(|place| (frequency - place).abs() < CHANCE * base);
        let unnamed = found.lines.iter().filter(|line| !line.decays && line.meaning == Meaning::Unknown);
        let (there, elsewhere): (Vec<_>, Vec<_>) = unnamed.partition(|line| near(line.frequency.value));
        (there.len() >= FEWEST_BETWEEN && there.len() > elsewhere.len()).then_some((divisor, there.len()))
    };
    [2, 3].into_iter().find_map(between)
}

fn without_series(found: &Identification, decaying: usize, modes: usize) -> (Answer, Vec<String>) {
    let total = found.lines.len();
    if total == 0 {
        return (Answer::Undecided, vec!["nothing rings above the noise".to_owned()]);
    }
    // Small lines beside large ones decide nothing.
    let largest = found.lines.iter().map(|line| line.amplitude).fold(0.0, f64::max);
    let weighty: Vec<_> = found.lines.iter().filter(|line| line.amplitude >= SMALL * largest).collect();
    let all = |holds: fn(&Meaning) -> bool| weighty.iter().all(|line| holds(&line.meaning));
    let any = |holds: fn(&Meaning) -> bool| weighty.iter().any(|line| holds(&line.meaning));
    let follows = |meaning: &Meaning| matches!(meaning, Meaning::Follows);
    let count = weighty.len();
    if any(follows) && all(|meaning| matches!(meaning, Meaning::Follows | Meaning::Mains { .. })) {
        let line = format!(
            "the force follows the ends' own motion ({}): something moves them, a controller or a drive",
            lines(count)
        );
        return (Answer::NotTheSpring, vec![line]);
    }
    if all(|meaning| matches!(meaning, Meaning::Mains { .. })) {
        let line = format!("what rings is steady and a multiple of the mains' frequency ({})", lines(count));
        return (Answer::NotTheSpring, vec![line]);
    }
    if let Some((line, mode)) = driven_mode(found) {
        let predicted = found.predicted.unwrap_or(f64::NAN);
        let evidence = format!(
            "a steady line at {line:.2} Hz lies near mode {mode} of the predicted spring (f1 {predicted:.2} Hz): driven there, it would ring like this"
        );
        return (Answer::Undecided, vec![evidence]);
    }
    let line = match (decaying, modes) {
        (0, _) => format!(
            "{total} steady line{}, no ring-down: a spring that is driven and a resonance elsewhere look alike",
            if total == 1 { "" } else { "s" }
        ),
        (1, _) => "only one line rings: one mode of a spring and a resonance elsewhere look alike".to_owned(),
        (count, 2) => {
            format!("{count} lines ring, two of them in one mode series: too few to tell a spring from chance")
        }
        (count, _) => format!("{count} lines ring, but they are not the mode series of a spring"),
    };
    (Answer::Undecided, vec![line])
}

/// A steady line near a mode of the predicted spring, and which.
fn driven_mode(found: &Identification) -> Option<(f64, f64)> {
    let (predicted, room) = (found.predicted?, found.settings.prediction_tolerance);
    let unnamed = found.lines.iter().filter(|line| !line.decays && line.meaning == Meaning::Unknown);
    let mut near = unnamed.map(|line| (line.frequency.value, (line.frequency.value / predicted).round().max(1.0)));
    near.find(|(frequency, mode)| (frequency / (mode * predicted) - 1.0).abs() < room / mode)
}

/// So many lines.
fn lines(count: usize) -> String {
    format!("{count} line{}", if count == 1 { "" } else { "s" })
}

fn next(found: &Identification, answer: Answer) -> Vec<String> {
    let mut next = Vec::new();
    if let Some(channel) = found.turned {
        next.push(format!("with the sign of {} corrected (here by the option turn), or that of a force that counts compression as positive",
            channel.name()
        ));
    }
    let rate = found.sampling.rate;
    // Where it is open what rings, its loudest line may be the first mode.
    let loudest =
        found.lines.iter().max_by(|a, b| a.amplitude.total_cmp(&b.amplitude)).map(|line| line.frequency.value);
    let certain = found.first_frequency.map(|first| first.value).filter(|_| answer == Answer::Spring);
    let first = certain.or(found.predicted).or(loudest);
    let slowest = found
        .lines
        .iter()
        .filter_map(|line| line.ratio.map(|ratio| ratio.value * line.frequency.value))
        .fold(f64::INFINITY, f64::min);
    if found.hits.len() < 5 && answer != Answer::NotTheSpring {
        let apart = if slowest.is_finite() && slowest > 0.0 {
            (8.0 / (std::f64::consts::TAU * slowest)).clamp(0.5, 10.0)
        } else {
            5.0
        };
        next.push(format!(
            "hits: strike one end at least 5 times, {apart:.1} s apart or more, both ends held ({} found)",
            found.hits.len()
        ));
    }
    let wanted = first.map(|frequency| 10.0 * frequency);
    if let Some(wanted) = wanted.filter(|wanted| *wanted > rate && answer != Answer::NotTheSpring) {
        next.push(format!("sample at {:.0} Hz or faster behind a low-pass below half of that, so that the first five modes show unfolded (now {rate:.0} Hz)", round_up(wanted)));
    }
    if !found.has_both_forces && answer == Answer::Undecided {
        next.push("record the forces at both ends (F_i and F_o): the spring's modes alternate in sign between them, other resonances do not".to_owned());
    }
    if found.stiffness.is_err() {
        next.push("move one end slowly over the range in use and record both positions (u1, u2) and the force: this gives the stiffness and, with f1, the mass that vibrates".to_owned());
    }
    if answer == Answer::Undecided && found.predicted.is_none() {
        next.push("weigh the coil and give its mass, or give its spec: f1 can then be predicted".to_owned());
    }
    if found.sampling.duration() < 20.0 && answer == Answer::Undecided {
        next.push(format!("record for at least 60 s (now {:.1} s)", found.sampling.duration()));
    }
    next
}

/// Up to the next of 1, 2, 2.5 or 5 times a power of ten.
fn round_up(value: f64) -> f64 {
    let power = 10.0_f64.powf(value.log10().floor());
    [1.0, 2.0, 2.5, 5.0, 10.0].into_iter().map(|step| step * power).find(|step| *step >= value).unwrap_or(value)
}
