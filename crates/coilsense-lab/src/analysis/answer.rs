//! The answer in a few lines: which sensor, at which end, meets the goal; which condition breaks it. Beside it, what would meet it.
//!
//! Next door: the whole report (`report`).

use super::budget::OSCILLATION;
use super::verdict::Verdict;
use super::{Analysis, Fix, Subject};
use crate::quantity::{digits, plainly};

/// The answer, one sentence or two per line, at most eight lines.
pub fn answer(analysis: &Analysis) -> Vec<String> {
    let mut lines = vec![best(analysis)];
    lines.extend(failing(analysis));
    lines.extend(untold(analysis));
    lines.extend(exact_rate(analysis));
    lines.extend(masses(analysis));
    lines.extend(as_chain(analysis));
    lines.extend(rebound(analysis));
    lines.push(damping(analysis));
    lines.push(warned(analysis));
    lines
}

pub(super) fn name<'a>(analysis: &'a Analysis, verdict: &Verdict) -> &'a str {
    &analysis.sensors[verdict.sensor].name
}

/// `1.23 N (1.01 % of F_nom)`.
fn force(analysis: &Analysis, newton: f64) -> String {
    let nominal = analysis.spec.spring.spring.nominal_force();
    format!("{} N ({} % of F_nom)", digits(newton), digits(100.0 * newton / nominal))
}

/// `1.22 N (1 % of F_nom)`.
pub(super) fn wish(analysis: &Analysis, newton: f64) -> String {
    let nominal = analysis.spec.spring.spring.nominal_force();
    format!("{} N ({} % of F_nom)", plainly(newton), plainly(100.0 * newton / nominal))
}

/// Which share of the specimens is inside the goal all the same.
fn inside(verdict: &Verdict) -> String {
    match verdict.least_inside() {
        Some(share) if share > 0.0 => format!("{} of the springs meet it", of_specimens(share)),
        _ => "no spring within tolerance meets it".to_owned(),
    }
}

/// A condition, and under which damping where there are several.
fn case_name(analysis: &Analysis, number: usize) -> String {
    let case = &analysis.cases[number];
    let condition = &analysis.spec.conditions[case.condition].name;
    let dampings = &analysis.spec.mount.cases;
    if dampings.len() > 1 { format!("{condition}, {}", dampings[case.damping].label) } else { condition.clone() }
}

/// The same of a sensor's worst case, and whether it lies beyond contact.
fn place(analysis: &Analysis, verdict: &Verdict) -> String {
    let case = &analysis.cases[verdict.worst];
    let place = case_name(analysis, verdict.worst);
    match &case.contacts {
        Some(contacts) if !contacts.floats.is_empty() => format!("{place}, where the follower leaves its cam"),
        Some(contacts) if contacts.touches.is_empty() => place,
        Some(_) => format!("{place}, where windings meet"),
        None if case.clash.happens() => format!("{place}, where windings would touch"),
        None => place,
    }
}

fn best(analysis: &Analysis) -> String {
    let Some(first) = analysis.verdicts.first() else { return String::new() };
    let of = analysis.verdicts.len();
    let at_most =
        |verdict: &Verdict| format!("at most {} in {}", force(analysis, verdict.combined()), place(analysis, verdict));
    let (name_of_first, most) = (name(analysis, first), at_most(first));
    let Some(goal) = analysis.spec.goal.error else {
        let least = if of == 1 { "" } else { "Least uncertain is " };
        return format!(
            "{least}{name_of_first}, with a standard uncertainty of {most}. The spec sets no [goal], so nothing is judged."
        );
    };
    let wanted = match analysis.spec.goal.bandwidth {
        Some(bandwidth) => format!("{} up to {} Hz", wish(analysis, goal), plainly(bandwidth)),
        None => wish(analysis, goal),
    };
    let meeting: Vec<&Verdict> = analysis.verdicts.iter().filter(|v| v.meets_always() == Some(true)).collect();
    let Some(best) = meeting.first() else {
        let none = match of {
            1 => format!("{name_of_first} does not meet the goal of {wanted}"),
            _ => format!("No sensor meets the goal of {wanted}; nearest is {name_of_first}"),
        };
        let yet = if first.overload.is_some() { ", and it is overloaded" } else { "" };
        return format!("{none}: its standard uncertainty is {most}{yet}.");
    };
    let all = match (meeting.len(), of) {
        (1, 1) => "It meets".to_owned(),
        (2, 2) => "Both sensors meet".to_owned(),
        (all, of) if all == of => format!("All {of} sensors meet"),
        (1, of) => format!("One of {of} sensors meets"),
        (some, of) => format!("{some} of {of} sensors meet"),
    };
    let (best_name, most) = (name(analysis, best), at_most(best));
    let (behind, specimens) = (behind(analysis, best), specimens(best));
    format!(
        "Choose {best_name}{behind}. {all} the goal of {wanted}. Standard uncertainty of {best_name}: {most}.{specimens}"
    )
}

/// `, behind a low-pass of order 8 at 20 Hz (41 ms late; without it 11.1 N rms in resonance)`.
fn behind(analysis: &Analysis, verdict: &Verdict) -> String {
    let Some(filter) = verdict.filter else { return String::new() };
    format!(
        ", behind a Butterworth low-pass of order {} at {} Hz (which comes {:.0} ms late; without it {} N rms in {})",
        filter.order,
        plainly(filter.bandwidth),
        1e3 * filter.lag,
        digits(filter.raw),
        case_name(analysis, filter.case),
    )
}

/// ` Of the springs within tolerance 97 % meet the goal; the worst errs by 1.3 N, the nominal one by 0.4 N.`
fn specimens(verdict: &Verdict) -> String {
    let (worst, Some(inside)) = (verdict.at_worst(), verdict.least_inside()) else { return String::new() };
    format!(
        " Of the springs within tolerance {} meet the goal; the worst errs by {} N, the nominal one by {} N.",
        of_specimens(inside),
        digits(worst.worst),
        digits(worst.nominal),
    )
}

/// A share of specimens in words.
fn of_specimens(share: f64) -> String {
    match share {
        all if all >= 1.0 => "all".to_owned(),
        none if none <= 0.0 => "none".to_owned(),
        many if many > 0.99 => "more than 99 %".to_owned(),
        few if few < 0.01 => "less than 1 %".to_owned(),
        share => format!("{:.0} %", 100.0 * share),
    }
}

/// Those that miss the goal, and where; those that miss it alike share the words.
fn failing(analysis: &Analysis) -> Option<String> {
    let mut each: Vec<(Vec<&str>, String)> = Vec::new();
    for verdict in analysis.verdicts.iter().filter(|verdict| verdict.meets_always() == Some(false)) {
        let how = missed(analysis, verdict);
        match each.iter_mut().find(|(_, other)| *other == how) {
            Some((names, _)) => names.push(name(analysis, verdict)),
            None => each.push((vec![name(analysis, verdict)], how)),
        }
    }
    let each: Vec<String> = each.into_iter().map(|(names, how)| format!("{} ({how})", several(&names))).collect();
    if each.is_empty() { None } else { Some(format!("Missed by: {}.", each.join("; "))) }
}

/// `a`, `a and b`; names that have commas themselves are told apart.
pub(crate) fn several(names: &[&str]) -> String {
    let marked: Vec<String> = match names {
        [one] => vec![(*one).to_owned()],
        many if many.iter().any(|name| name.contains(',')) => many.iter().map(|name| format!("“{name}”")).collect(),
        many => many.iter().map(|name| (*name).to_owned()).collect(),
    };
    match marked.split_last() {
        Some((last, before)) if !before.is_empty() => format!("{} and {last}", before.join(", ")),
        _ => marked.concat(),
    }
}

/// By how much and where a sensor misses the goal, and why.
fn missed(analysis: &Analysis, verdict: &Verdict) -> String {
    if let Some(most) = verdict.overload {
        return format!("overloaded at {} N", digits(most));
    }
    if verdict.too_slow && verdict.meets.iter().all(|meets| *meets) {
        return format!("reaches {} Hz only", digits(verdict.bandwidth));
    }
    format!(
        "{} N in {}, mostly {}; {}",
        digits(verdict.combined()),
        place(analysis, verdict),
        cause(verdict),
        inside(verdict),
    )
}

/// Why a mean error is there, where that is it.
const BENDS: &str = " since the coil's force is no straight line";

/// What the uncertainty of the worst case is mostly made of: a mean error, or the largest line of the budget.
fn cause(verdict: &Verdict) -> String {
    let budget = &verdict.budget.budget;
    let largest = budget.contributions().iter().max_by(|a, b| a.contribution.total_cmp(&b.contribution));
    match largest {
        Some(line) if line.contribution >= budget.bias().abs() => match line.name.as_ref() {
            OSCILLATION if verdict.by_readout => "its own lag".to_owned(),
            name => name.to_owned(),
        },
        _ => {
            let why = if (budget.bias() - verdict.budget.bend).abs() < 0.5 * budget.bias().abs() { BENDS } else { "" };
            format!("a mean error of {} N{why}", digits(budget.bias()).replace('-', "−"))
        }
    }
}

/// From so many times the nominal oscillation on, that of the loudest spring says that the error cannot be told from the spec.
const UNTOLD: f64 = 2.0;

/// Whether how far a sensor is off hangs on a frequency that the spec does not say well enough.
pub(super) fn is_untold(verdict: &Verdict) -> bool {
    let worst = verdict.at_worst();
    let by_surge = worst.over_specimens > 0.5 * worst.combined;
    by_surge && worst.loudest > UNTOLD * worst.oscillation.min(worst.over_specimens)
}

/// Where how far a sensor is off hangs on such a frequency, and what would tell it.
fn untold(analysis: &Analysis) -> Option<String> {
    let each: Vec<String> = analysis
        .verdicts
        .iter()
        .filter(|verdict| is_untold(verdict))
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
fn as_chain(analysis: &Analysis) -> Option<String> {
    let combined = analysis.as_chain.as_ref()?;
    let of = |verdict: &Verdict| format!("{} {} N", name(analysis, verdict), digits(combined[verdict.sensor]));
    let each: Vec<String> = analysis.verdicts.iter().take(MOST_NAMED).map(of).collect();
    Some(format!(
        "Every mode of the helix moves here. Beside it, an axial chain of the same first frequency (model = \"coil\") gives {}.",
        each.join(", ")
    ))
}

/// What the worst figures hang on that nobody has measured: how windings rebound.
fn rebound(analysis: &Analysis) -> Option<String> {
    let meets = |case: &&super::Case| case.contacts.as_ref().is_some_and(|contacts| !contacts.touches.is_empty());
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
fn exact_rate(analysis: &Analysis) -> Option<String> {
    let usual = analysis.if_usual.as_ref()?;
    let goal = analysis.spec.goal.error;
    let of = |sensor: &usize| {
        let combined = usual.combined[*sensor];
        let judged = goal.map_or("", |goal| if combined > goal { ", misses" } else { ", meets" });
        format!("{} {} N{judged}", analysis.sensors[*sensor].name, digits(combined))
    };
    let mut order: Vec<usize> = (0..usual.combined.len()).collect();
    order.sort_by(|a, b| usual.combined[*a].total_cmp(&usual.combined[*b]));
    let others = order.iter().zip(&analysis.verdicts).any(|(then, now)| *then != now.sensor);
    let words = if others { "the order is another" } else { "the order is the same" };
    let each: Vec<String> = order.iter().take(MOST_NAMED).map(of).collect();
    let more = if order.len() > MOST_NAMED { ", …" } else { "" };
    Some(format!(
        "The spring's rate is taken as exact, for want of a stiffness_tolerance. At ±{} % {words}: {}{more}.",
        plainly(100.0 * super::USUAL_TOLERANCE),
        each.join("; ")
    ))
}

/// Whether the figures still hang on how many masses stand for a winding.
fn masses(analysis: &Analysis) -> Option<String> {
    let masses = &analysis.masses;
    let change = masses.change.filter(|_| !masses.are_enough())?;
    Some(format!(
        "With {} masses per winding, the most that are taken, some rms still moves by {:.1} % when they are doubled.",
        masses.per_winding,
        100.0 * change
    ))
}

/// For each sensor that misses the goal, best first: what would make it meet it, the soonest first and at most two; `None` where no single
/// change that was tried does.
pub fn changes_that_meet(analysis: &Analysis) -> Vec<(&str, Option<&Fix>)> {
    let failing = analysis.verdicts.iter().filter(|verdict| verdict.meets_always() == Some(false));
    let rows = failing.flat_map(|verdict| {
        let fixes: Vec<Option<&Fix>> = match verdict.fixes.as_slice() {
            [] => vec![None],
            some => some.iter().take(2).map(Some).collect(),
        };
        fixes.into_iter().map(|fix| (name(analysis, verdict), fix))
    });
    rows.collect()
}

fn damping(analysis: &Analysis) -> String {
    let dampings = &analysis.spec.mount.cases;
    if !analysis.spec.mount.is_band {
        let labels: Vec<&str> = dampings.iter().map(|case| case.label.as_str()).collect();
        let between = if labels.iter().any(|label| label.contains(',')) { "; " } else { ", " };
        return format!("Damping as the spec says: {}.", labels.join(between));
    }
    let turn: Vec<String> = analysis
        .verdicts
        .iter()
        .filter(|verdict| verdict.meets.iter().any(|m| *m) && verdict.meets.iter().any(|m| !m))
        .map(|verdict| {
            let meeting =
                verdict.meets.iter().zip(dampings).filter(|(meets, _)| **meets).map(|(_, case)| case.label.as_str());
            format!("{} meets it at {} only", name(analysis, verdict), meeting.collect::<Vec<_>>().join(", "))
        })
        .collect();
    let band = "No damping given: results are the worst case over ζ = 0 (the paper's case) to 0.02";
    if turn.is_empty() { format!("{band}.") } else { format!("{band}; {}.", turn.join("; ")) }
}

fn warned(analysis: &Analysis) -> String {
    let count = |subject| analysis.warnings.iter().filter(|warning| warning.subject == subject).count();
    let kinds = [
        (Subject::Resonance, "a natural frequency of the real spring may coincide with the input's"),
        (Subject::NoLimit, "the rms of a step has no limit"),
        (Subject::Clash, "windings touch"),
        (Subject::Contact, "windings meet, ends leave their seats, or a follower its cam"),
        (Subject::Length, "a length leaves the range in use"),
        (Subject::Lift, "an end that only pushes would have to pull"),
        (Subject::Doubt, "values of the spring do not fit together"),
        (Subject::Instrument, "an instrument has no limit of error"),
        (Subject::Alias, "surge lines alias"),
        (Subject::Range, "a load cell is overloaded"),
        (Subject::Magnetisation, "the wire may be more magnetic than what is computed"),
        (Subject::Temperature, "a drift with temperature is not known"),
        (Subject::Neighbour, "the coil rings in other modes too"),
    ];
    let each: Vec<&str> = kinds.into_iter().filter(|(subject, _)| count(*subject) > 0).map(|(_, text)| text).collect();
    if each.is_empty() { "No warnings.".to_owned() } else { format!("See the warnings: {}.", each.join("; ")) }
}
