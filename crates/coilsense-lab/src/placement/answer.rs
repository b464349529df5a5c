//! The answer of a placement, in a few sentences.
//!
//! Next door: its numbers (`super`), what comes first (`head`), the runs over time (`told`).

use coilsense::Channel;

use super::words::{place, upto};
use super::{CLEAR, Candidate, Placement, Reading, TIE, TOLERANCE, head, told};
use crate::quantity::digits;

/// The answer, a sentence or two each.
pub fn answer(placement: &Placement) -> Vec<String> {
    answered(placement).concat()
}

/// What to feed back, how fast, what then holds and on what; then what the others do, the runs over time, and what is left out.
pub(crate) fn answered(placement: &Placement) -> [Vec<String>; 2] {
    let best = &placement.candidates[placement.best];
    let mut first = vec![head::head(placement, best)];
    first.extend(head::limits(placement, best));
    first.extend(head::set(placement, best));
    first.extend(head::faster(placement, best));
    first.extend(tie_line(placement).filter(|_| best.robust_crossover() > 0.0 && best.is_stable()));
    first.push(springs_line(placement));
    first.push(sensors_line(placement));
    let others = placement.candidates.iter().filter(|other| other.channel != best.channel);
    let mut lines: Vec<String> = others.map(|other| other_line(placement, other)).collect();
    lines.extend(placement.estimates.iter().map(|estimate| {
        let robust = shortly(estimate.robust_from, estimate.robust_crossover);
        let reach = (robust, upto("stable", 0.0, estimate.stable_crossover));
        format!(
            "{}, on all springs and with k and m off by up to {:.0} %: {}, {}.",
            estimate.name,
            100.0 * TOLERANCE,
            reach.0,
            reach.1
        )
    }));
    if let Some(line) = passivity_line(placement, best).filter(|_| best.is_stable()) {
        lines.push(line);
    }
    let (warnings, runs): (Vec<String>, Vec<String>) =
        told::lines(placement).into_iter().partition(|line| line.starts_with(told::WARNING));
    first.extend(placement.spec.mount.doubt().map(|doubt| format!("{}: {doubt}", told::WARNING)));
    first.extend(warnings);
    lines.extend(runs);
    if placement.undamped_left_out {
        lines.push("A spring without damping (ζ = 0) is left out: no loop on F_o is stable with it, and the others ring for ever.".to_owned());
    }
    [first, lines]
}

/// On which springs all this holds, and what the nominal one alone would allow.
fn springs_line(placement: &Placement) -> String {
    let allowed = &placement.allowed;
    let within = |share: f64| format!("±{} %", digits(100.0 * share));
    let shifted = format!("all surge frequencies shifted together by up to {}", within(allowed.frequency));
    let tolerances = &placement.spec.spring.tolerances;
    let worst = if tolerances.is_silent_on_stiffness() && tolerances.moves().is_empty() {
        format!(
            "All figures are worst cases over springs with {shifted}, the model's own uncertainty. The spec gives no tolerance of the rate, so k \
             counts as exact."
        )
    } else {
        let rate = if allowed.stiffness > 0.0 {
            format!("k within {} and ", within(allowed.stiffness))
        } else {
            String::new()
        };
        format!(
            "All figures are worst cases over springs with {rate}{shifted}: the spec's tolerances and the model's own uncertainty."
        )
    };
    let fed = placement.candidates[placement.best].channel;
    let is_read = matches!(fed, Channel::DeflectionForce | Channel::InductanceForce);
    let read = if is_read && allowed.stiffness > 0.0 {
        let (name, off) = (fed.name(), within(allowed.stiffness));
        format!(" {name} is computed with the nominal k, so the true force is within {off} of it.")
    } else {
        String::new()
    };
    format!("{worst}{read}{}", nominal(placement).unwrap_or_default())
}

/// What the nominal spring alone would allow, where that is something else.
fn nominal(placement: &Placement) -> Option<String> {
    let (one, all) = (&placement.nominal[placement.nominal_best], &placement.candidates[placement.nominal_best]);
    let (on_one, on_all) = match one.calm_crossover {
        0.0 => (one.robust_crossover(), all.robust_crossover()),
        calm => (calm, all.calm_crossover),
    };
    let upto =
        |hertz: f64| if hertz.is_finite() { format!("{} Hz", digits(hertz)) } else { "any crossover".to_owned() };
    if placement.nominal_best == placement.best {
        let differs = on_one.is_finite() && (on_all / on_one - 1.0).abs() > TIE;
        return differs.then(|| format!(" For the nominal spring alone the crossover could be {}.", upto(on_one)));
    }
    let left = match (on_all, all.robust_crossover(), all.stable_crossover()) {
        (0.0, _, 0.0) => "some of the others are unstable even in the slowest loop".to_owned(),
        (0.0, 0.0, _) => "no gain keeps the sensitivity at most 2 on all of them".to_owned(),
        (0.0, ..) => "on some of the others an end rings at every crossover".to_owned(),
        (hertz, ..) => format!("over all of them it reaches {}", upto(hertz)),
    };
    let (name, words) = (one.channel.name(), place(one.channel));
    Some(format!(" For the nominal spring alone the choice would be {name} ({words}), up to {}; {left}.", upto(on_one)))
}

/// How late the forces are read.
fn sensors_line(placement: &Placement) -> String {
    if placement.spec.sensors.is_empty() {
        return "The spec has no sensors: each force is taken to be read at once, without noise or error.".to_owned();
    }
    let each = Channel::FORCES.into_iter().zip(&placement.readings);
    let (read, at_once): (Vec<_>, Vec<_>) = each.partition(|(_, reading)| reading.sensor.is_some());
    let told = |(channel, reading): &(Channel, &Reading)| {
        let name = reading.sensor.as_deref().unwrap_or_default();
        format!("{} {} ms ({name})", channel.name(), digits(1e3 * reading.lag))
    };
    let named: Vec<String> = read.iter().map(told).collect();
    let ideal: Vec<&str> = at_once.iter().map(|(channel, _)| channel.name()).collect();
    let ideal = match ideal.as_slice() {
        [] => String::new(),
        names => format!(" No sensor of the spec measures {}: taken without lag.", names.join(", ")),
    };
    let whole = if placement.control.sample_time.is_some() { ", in whole samples" } else { "" };
    let coarse = Channel::FORCES.into_iter().zip(&placement.readings);
    let coarse =
        coarse.filter_map(|(channel, reading)| Some(format!("{} at {} Hz", channel.name(), digits(reading.coarse?))));
    let coarse: Vec<String> = coarse.collect();
    let coarse = match coarse.as_slice() {
        [] => String::new(),
        lost => format!(
            " These have lost 3 dB below {CLEAR:.0} f1: {}. Their limits, by a delay alone, are rough, and such a force is chosen only where there is no \
             other.",
            lost.join(", ")
        ),
    };
    format!(
        "Each force comes as late as the quickest sensor of the spec tells it, beside the delay of [control]: {}; the worse of a fresh and an old \
         reading counts{whole}.{ideal}{} What a filter takes off the size of a force is left out, as are noise and errors of the sensors.",
        named.join(", "),
        coarse
    )
}

/// Which forces could be fed back just as well.
fn tie_line(placement: &Placement) -> Option<String> {
    let named = |&index: &usize| {
        let channel = placement.candidates[index].channel;
        format!("{} ({})", channel.name(), place(channel))
    };
    let names: Vec<String> = placement.ties.iter().map(named).collect();
    (!names.is_empty()).then(|| format!("As fast, within {:.0} %: {}.", 100.0 * TIE, names.join(", ")))
}

/// At which crossovers the sensitivity is at most 2, of a force that is not the one to feed back.
fn shortly(from: f64, to: f64) -> String {
    upto(if to == 0.0 { "a sensitivity of at most 2" } else { "sensitivity 2" }, from, to)
}

fn other_line(placement: &Placement, other: &Candidate) -> String {
    let (name, words) = (other.channel.name(), place(other.channel));
    let stable = other.stable_crossover();
    if stable == 0.0 {
        return format!("{name} ({words}): not stable at any gain.");
    }
    let weakest = other
        .judged
        .iter()
        .zip(&placement.dampings)
        .min_by(|a, b| a.0.stable_crossover.total_cmp(&b.0.stable_crossover));
    let place = weakest.filter(|_| stable.is_finite()).map_or(String::new(), |(judged, damping)| {
        format!(", where it rings at {} Hz with {}", digits(judged.oscillates_at), damping.label)
    });
    let robust = shortly(other.robust_from(), other.robust_crossover());
    format!("{name} ({words}): {robust}, {}{place}.", upto("stable", 0.0, stable))
}

fn passivity_line(placement: &Placement, best: &Candidate) -> Option<String> {
    let active = best.judged.iter().filter_map(|judged| judged.passivity.as_ref()?.active.first());
    let first = active.min_by(|a, b| a[0].total_cmp(&b[0]));
    best.judged.first()?.passivity.as_ref()?;
    let up_to = digits(placement.control.passive_up_to);
    Some(match first {
        None => format!(
            "The impedance rendered at end 2 is passive at every damping over the range examined, up to {up_to} Hz."
        ),
        Some(band) => format!(
            "The impedance rendered at end 2 is not passive from {} to {} Hz: some passive environment makes the loop unstable there.",
            digits(band[0]),
            digits(band[1])
        ),
    })
}
