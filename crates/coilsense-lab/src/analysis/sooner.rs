//! What comes before the judged part: a window that begins after the ringing does not see how far a force is off right after a stop.
//!
//! Next door: the judged part itself (`judge`), how it is said (`answer`).

use coilsense::{End, EndInput, Error, Excitation, Start};

use super::band;
use super::case::Scene;
use super::judge::Judge;
use super::verdict::{Assessment, Sooner, Verdict, matters};
use super::warnings::{Subject, Warning};
use crate::quantity::{digits, plainly};
use crate::spec::{SensorSpec, Spec};

/// From so many times the largest uncertainty on, what is not judged is told: of ringing that lasts, two parts that are alike differ by less.
const LOUDER: f64 = 1.25;

/// Most sensors that a warning names.
const MOST_NAMED: usize = 3;

/// The loudest part that comes before the judged one, where it is louder than all that is judged, or misses a goal that is met there.
///
/// # Errors
/// Those of the science.
pub(super) fn of(
    judge: &Judge<'_>,
    index: usize,
    sensor: &SensorSpec,
    verdict: &Verdict,
) -> Result<Option<Sooner>, Error> {
    let mut loudest: Option<Sooner> = None;
    for (number, case) in judge.cases.iter().enumerate() {
        for window in before(judge.spec, case.condition) {
            let part = band::judged(case.signals.time(), window);
            let scene = Scene { judged: &part, ..case.scene(sensor, &judge.spec.goal) };
            let instrument = judge.instrument(sensor, case.condition)?;
            let counted = judge.counted(scene, &case.readings[index].steady)?;
            let Assessment { nominal: error, .. } = judge.assessment(sensor, &instrument, scene, counted, None)?;
            if loudest.is_none_or(|loudest| error > loudest.error) {
                loudest = Some(Sooner { case: number, window, error });
            }
        }
    }
    let most = verdict.combined();
    let turns = |error: f64| judge.spec.goal.error.is_some_and(|goal| most <= goal && goal < error);
    let louder = |error: f64| error > LOUDER * most && matters(judge.spec, error);
    Ok(loudest.filter(|loudest| louder(loudest.error) || turns(loudest.error)))
}

/// Most parts that are looked at before a window.
const MOST_PARTS: f64 = 40.0;

/// Parts of what is simulated from an event on and not judged, each at most as long as what is \[s\]: half of each lies in the next. None where the
/// judged part begins with the event, and of sines, which are judged once they have settled.
fn before(spec: &Spec, condition: usize) -> Vec<(f64, f64)> {
    let asked = &spec.conditions[condition];
    let (from, to) = asked.window;
    let Some(event) = event(&asked.excitation) else { return Vec::new() };
    // The last sample that is left out.
    let (last, length) = (from - 1.0 / asked.sample_rate, to - from - 1.0 / asked.sample_rate);
    if last <= event {
        return Vec::new();
    }
    let step = (0.5 * length).max((last - event) / MOST_PARTS);
    let count = ((last - event - length) / step).ceil().max(0.0) as usize;
    let begins = (0..=count).map(|part| (event + part as f64 * step).min(last - length).max(event));
    begins.map(|begin| (begin, (begin + length).min(last))).collect()
}

/// From when on there is something to judge \[s\]: the ends stop, or one of them is moved; `None` of sines, which go on for ever.
fn event(excitation: &Excitation) -> Option<f64> {
    if matches!(excitation.start(), Start::Moving { .. }) {
        return Some(0.0);
    }
    let of_end = |end| match excitation.input(end) {
        EndInput::Step { at, .. } => Some(*at),
        EndInput::Ramp { from, .. } | EndInput::HalfSine { from, .. } => Some(*from),
        EndInput::Chirp { .. } | EndInput::Sampled(_) => Some(0.0),
        EndInput::Held | EndInput::Harmonics(_) => None,
    };
    [End::One, End::Two].into_iter().filter_map(of_end).min_by(f64::total_cmp)
}

/// A warning for each case that is louder before its judged part, with the sensors of which that is so.
pub(super) fn warnings(
    spec: &Spec,
    sensors: &[SensorSpec],
    cases: &[super::Case],
    verdicts: &[Verdict],
) -> Vec<Warning> {
    let warning = |(number, case): (usize, &super::Case)| {
        let each = verdicts.iter().filter_map(|verdict| Some((verdict, verdict.sooner?)));
        let each: Vec<_> = each.filter(|(_, sooner)| sooner.case == number).collect();
        let (_, first) = each.first()?;
        let asked = &spec.conditions[case.condition];
        let named = each.iter().take(MOST_NAMED).map(|(verdict, sooner)| {
            let (before, judged) = (digits(sooner.error), digits(verdict.assessments[number].combined));
            format!("{} {before} N instead of {judged} N", sensors[verdict.sensor].name)
        });
        let named: Vec<String> = named.collect();
        let more = if each.len() > MOST_NAMED { "; …" } else { "" };
        let (from, until) = (plainly(first.window.0), plainly(first.window.1));
        let text = format!(
            "{}, {}: the window leaves out what comes before {} s. From {from} to {until} s the rms error is larger: {}{more}. To judge that part, \
             begin the window at {from} s.",
            asked.name,
            spec.mount.cases[case.damping].label,
            plainly(asked.window.0),
            named.join("; "),
        );
        Some(Warning { subject: Subject::Window, text })
    };
    cases.iter().enumerate().filter_map(warning).collect()
}
