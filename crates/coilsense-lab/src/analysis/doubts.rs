//! What the answer's figures hang on and do not show: what is not judged, not told, not known.
//!
//! Next door: the answer itself (`answer`).

use super::verdict::{Verdict, matters};
use super::words::{case_name, force, name, several};
use super::{Analysis, Case, USUAL_TOLERANCE};
use crate::quantity::{digits, plainly};
use crate::spec::Spec;

/// What the window leaves out, where the goal is not met there: `; before the window of heel strike, ζ = 0.02, from 0 to 0.25 s, it errs by 13.4 N (1.08 % of F_nom) rms, which misses the goal (laser meets it there too)`
pub(super) fn unjudged(analysis: &Analysis, verdict: &Verdict) -> String {
    let goal = analysis.spec.goal.error;
    let is_met = |verdict: &Verdict| goal.is_some_and(|goal| verdict.sooner.is_none_or(|sooner| sooner.error <= goal));
    let Some(sooner) = verdict.sooner.filter(|_| !is_met(verdict) && verdict.meets_always() != Some(false)) else {
        return String::new();
    };
    let mut meeting = analysis.verdicts.iter().filter(|other| other.meets_always() == Some(true) && is_met(other));
    let then = match (goal, meeting.next()) {
        (None, _) => String::new(),
        (Some(_), Some(other)) => format!(", which misses the goal ({} meets it there too)", name(analysis, other)),
        (Some(_), None) => ", which misses the goal".to_owned(),
    };
    format!(
        "; before the window of {}, from {} to {} s, it errs by {} rms{then}",
        case_name(analysis, sooner.case),
        plainly(sooner.window.0),
        plainly(sooner.window.1),
        force(analysis, sooner.error),
    )
}

/// Sensors that meet the goal, or are held against none, by what may be too little: of which no limit of error is told.
pub(super) fn without_limits(analysis: &Analysis) -> Option<String> {
    let counts = |verdict: &&Verdict| !verdict.has_limits && verdict.meets_always() != Some(false);
    let names: Vec<&str> = analysis.verdicts.iter().filter(counts).map(|verdict| name(analysis, verdict)).collect();
    let last = if names.len() < analysis.verdicts.len() { "; sensors with one are preferred" } else { "" };
    (!names.is_empty()).then(|| {
        format!(
            "The spec gives no limit of error for {}: what is said of it is a lower bound of its uncertainty{last}.",
            several(&names)
        )
    })
}

/// From so many times the nominal oscillation on, that of the loudest spring says that the error cannot be told from the spec.
const UNTOLD: f64 = 2.0;

/// Whether how far a sensor is off hangs on a frequency that the spec does not say well enough.
pub(super) fn is_untold(spec: &Spec, verdict: &Verdict) -> bool {
    let worst = verdict.at_worst();
    let by_surge = worst.over_specimens > 0.5 * worst.combined;
    matters(spec, worst.loudest) && by_surge && worst.loudest > UNTOLD * worst.oscillation.min(worst.over_specimens)
}

/// Where how far a sensor is off hangs on such a frequency, and what would tell it.
pub(super) fn untold(analysis: &Analysis) -> Option<String> {
    let each: Vec<String> = analysis
        .verdicts
        .iter()
        .filter(|verdict| is_untold(&analysis.spec, verdict))
        .map(|verdict| {
            let (worst, place) = (verdict.at_worst(), case_name(analysis, verdict.worst));
            let (nominal, most) = (digits(worst.nominal), digits(worst.worst));
            format!("{} in {place} ({nominal} N on the nominal spring, {most} N on the worst)", name(analysis, verdict))
        })
        .collect();
    let spring = &analysis.spec.spring;
    let (low, high) = spring.first_frequency_band();
    let (low, high, chain) = (digits(low), digits(high), digits(spring.spring.chain_frequency()));
    (!each.is_empty()).then(|| {
        format!(
            "How far off cannot be told more closely for {}: it hangs on the first surge frequency, which for this coil may be {low} to {high} Hz \
             by model alone (the chain used has {chain} Hz), and further off by tolerances. Measure it: hit the spring and run `coilsense identify`.",
            each.join("; ")
        )
    })
}

/// What the coil's chain says in place of the helix.
pub(super) fn as_chain(analysis: &Analysis) -> Option<String> {
    let combined = analysis.as_chain.as_ref()?;
    let of = |verdict: &Verdict| format!("{} {} N", name(analysis, verdict), digits(combined[verdict.sensor]));
    let each: Vec<String> = analysis.verdicts.iter().take(MOST_NAMED).map(of).collect();
    Some(format!(
        "Every mode of the helix moves here. Beside it, an axial chain of the same first frequency (model = \"coil\") gives {}.",
        each.join(", ")
    ))
}

/// What the worst figures hang on that nobody has measured: how windings rebound.
pub(super) fn rebound(analysis: &Analysis) -> Option<String> {
    let meets = |case: &&Case| case.contacts.as_ref().is_some_and(|contacts| !contacts.touches.is_empty());
    analysis.cases.iter().find(meets)?;
    let ways = &analysis.spec.mount.cases;
    let mut laws: Vec<&str> = Vec::new();
    for way in ways.iter().filter_map(|way| way.contact.as_ref()) {
        if !laws.contains(&way.label.as_str()) {
            laws.push(&way.label);
        }
    }
    if laws.len() < 2 {
        let [law] = laws[..] else { return None };
        return Some(format!("Windings meet by {law} alone, as the spec says; for other rebounds give a list."));
    }
    let of = |verdict: &Verdict| {
        let worst = |law: &str| {
            let cases = analysis.cases.iter().zip(&verdict.assessments);
            let of_law =
                cases.filter(|(case, _)| ways[case.damping].contact.as_ref().is_some_and(|way| way.label == law));
            of_law.map(|(_, assessment)| assessment.combined).fold(0.0, f64::max)
        };
        let each: Vec<String> = laws.iter().map(|law| digits(worst(law))).collect();
        format!("{} {} N", name(analysis, verdict), each.join(" and "))
    };
    let each: Vec<String> = analysis.verdicts.iter().take(MOST_NAMED).map(of).collect();
    let assumed = ways.iter().any(|way| way.contact.as_ref().is_some_and(|way| way.is_assumed));
    let why = if assumed { ", which nobody has measured and the spec leaves open" } else { ", as the spec lists them" };
    Some(format!("How windings rebound{why}: at {}, {}.", laws.join(" and "), each.join("; ")))
}

/// Most sensors that are named for the usual tolerance.
const MOST_NAMED: usize = 3;

/// What a spec that is silent on its stiffness takes for granted, and what would be so otherwise.
pub(super) fn exact_rate(analysis: &Analysis) -> Option<String> {
    let usual = analysis.if_usual.as_ref()?;
    let goal = analysis.spec.goal.error;
    let of = |sensor: &usize| {
        let combined = usual.combined[*sensor];
        let judged = goal.map_or("", |goal| if combined > goal { ", misses" } else { ", meets" });
        format!("{} {} N{judged}", analysis.sensors[*sensor].name, digits(combined))
    };
    let order = &usual.order;
    let others = order.iter().zip(&analysis.verdicts).any(|(then, now)| *then != now.sensor);
    let words = if others { "the order is another" } else { "the order is the same" };
    let each: Vec<String> = order.iter().take(MOST_NAMED).map(of).collect();
    let more = if order.len() > MOST_NAMED { ", …" } else { "" };
    Some(format!(
        "The spring's rate is taken as exact, for want of a stiffness_tolerance. At ±{} % {words}: {}{more}.",
        plainly(100.0 * USUAL_TOLERANCE),
        each.join("; ")
    ))
}

/// Whether the figures still hang on how many masses stand for a winding.
pub(super) fn masses(analysis: &Analysis) -> Option<String> {
    let masses = &analysis.masses;
    let change = masses.change.filter(|_| !masses.are_enough())?;
    Some(format!(
        "With {} masses per winding, the most that are taken, some rms still moves by {:.1} % when they are doubled.",
        masses.per_winding,
        100.0 * change
    ))
}
