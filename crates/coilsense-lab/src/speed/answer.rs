//! A speed map in a few lines: from when on windings meet and the follower floats, where surge is worst, and what that hangs on.
//!
//! Next door: the map (the parent), the report (`crate::report`).

use super::{SpeedMap, SpeedPoint, Stress, doubts};
use crate::quantity::digits;

/// Extremes that differ by more than this share of F_nom from turns to turns have not settled.
pub(crate) const SETTLED: f64 = 0.02;

/// Speeds that are farther apart than this share of theirs do not say what is between them: a resonance with ζ = 0.005 is a hundredth wide.
const FAR: f64 = 0.03;

/// Bands of speeds that a sentence names one by one.
const MOST_BANDS: usize = 3;

/// The answer, a sentence or two per line.
pub fn answer(map: &SpeedMap) -> Vec<String> {
    // How far the largest figure can be trusted stands with it.
    let surge = [surge(map), finer(map).unwrap_or_default()].join(" ").trim_end().to_owned();
    let mut lines: Vec<String> = pressed_through(map).into_iter().collect();
    lines.extend([floats(map), meets(map), surge, seats(map), fatigue(map), rebound(map)]);
    lines.extend(doubts::of(map).into_iter().map(|doubt| format!("Warning: {doubt}")));
    lines.extend(unsettled(map));
    lines.extend(given_up(map));
    lines.extend(refined(map));
    lines.extend(aside(map));
    lines.push(format!(
        "{} of a camshaft that turns {} times a turn of the engine; {} per winding. Left out: what else gives between cam and spring, friction, how \
         windings rebound in fact.",
        map.cam.words, map.range.ratio, masses(map.masses_per_winding)
    ));
    lines.into_iter().filter(|line| !line.is_empty()).collect()
}

fn masses(count: usize) -> String {
    format!("{count} mass{}", if count == 1 { "" } else { "es" })
}

pub(crate) fn rpm(speed: f64) -> String {
    format!("{:.0} rpm", 60.0 * speed)
}

/// The speeds that were run, for what holds at all of them.
fn run(map: &SpeedMap) -> String {
    format!("at all speeds run, {} to {}", rpm(map.range.from), rpm(map.range.to))
}

/// The lowest speed of those of which something holds in some way, and in how many ways it holds there.
fn lowest(map: &SpeedMap, holds: impl Fn(&SpeedPoint) -> bool) -> Option<&SpeedPoint> {
    map.points.iter().filter(|point| holds(point)).min_by(|a, b| a.speed.total_cmp(&b.speed))
}

/// At which of the speeds that were run something holds, in the way in which it does at the lowest; from a speed on, where it holds at all above.
fn spans(map: &SpeedMap, first: &SpeedPoint, holds: impl Fn(&SpeedPoint) -> bool) -> String {
    let mut points: Vec<&SpeedPoint> = map.points.iter().filter(|point| point.way == first.way).collect();
    points.sort_by(|a, b| a.speed.total_cmp(&b.speed));
    let last = points.len() - 1;
    let mut bands: Vec<(usize, usize)> = Vec::new();
    for (index, _) in points.iter().enumerate().filter(|(_, point)| holds(point)) {
        match bands.last_mut() {
            Some((_, end)) if *end + 1 == index => *end = index,
            _ => bands.push((index, index)),
        }
    }
    let words = |&(from, to): &(usize, usize)| match (rpm(points[from].speed), rpm(points[to].speed)) {
        (from, _) if to == last => format!("from {from} on"),
        (from, to) if from == to => format!("at {from}"),
        (from, to) => format!("from {from} to {to}"),
    };
    let (shown, more) = bands.split_at(bands.len().min(MOST_BANDS));
    // Between two speeds that were run it begins somewhere.
    let before = bands.first().and_then(|(from, _)| from.checked_sub(1));
    let before = before.map_or_else(String::new, |before| format!(", and not up to {}", rpm(points[before].speed)));
    let shown: Vec<String> = shown.iter().map(words).collect();
    let gap = |&(from, to): &(usize, usize)| {
        let each = points[from..=to].windows(2).map(|pair| pair[1].speed - pair[0].speed);
        each.zip(&points[from..=to])
            .filter(|(gap, point)| *gap > FAR * point.speed)
            .map(|(gap, _)| gap)
            .fold(0.0, f64::max)
    };
    let widest = bands.iter().map(gap).fold(0.0, f64::max);
    let before = match widest > 0.0 {
        true => format!("{before}, at speeds up to {} apart, between which it is not known", rpm(widest)),
        false => before,
    };
    match more.last() {
        None => format!("{}{before}", shown.join(", ")),
        Some(end) => {
            let many = if more.len() == 1 { "band" } else { "bands" };
            format!("{}, in {} more {many}, the last {}{before}", shown.join(", "), more.len(), words(end))
        }
    }
}

fn label<'a>(map: &'a SpeedMap, point: &SpeedPoint) -> &'a str {
    &map.spec.mount.cases[point.way].label
}

fn floats(map: &SpeedMap) -> String {
    if map.points.iter().all(|point| point.floating.is_none()) {
        return "No follower_mass under [mount]: whether the valve leaves its cam is not asked.".to_owned();
    }
    let Some(first) = lowest(map, SpeedPoint::is_aloft) else {
        let each = map.points.iter().filter_map(|point| Some((point, point.floating?)));
        let least = each.min_by(|a, b| a.1.least_cam_force.total_cmp(&b.1.least_cam_force));
        return least.map_or_else(String::new, |(point, floating)| {
            format!(
                "The follower stays on its cam {}; the cam presses least, with {} N, at {} ({}).",
                run(map),
                digits(floating.least_cam_force),
                rpm(point.speed),
                label(map, point)
            )
        });
    };
    let share = |point: &SpeedPoint| point.floating.map_or(0.0, |floating| floating.share);
    let worst = map.points.iter().max_by(|a, b| share(a).total_cmp(&share(b)));
    let worst = worst.map_or_else(String::new, |point| {
        let fastest = point.floating.map_or(0.0, |floating| floating.fastest);
        format!(
            ", and most at {}: {} % of the time, coming down at up to {} m/s",
            rpm(point.speed),
            digits(100.0 * share(point)),
            digits(fastest)
        )
    });
    format!("The follower floats {} ({}){worst}.", spans(map, first, SpeedPoint::is_aloft), label(map, first))
}

fn meets(map: &SpeedMap) -> String {
    let Some(first) = lowest(map, SpeedPoint::meets) else {
        let seats = if has_seats(map) { " and of their seats" } else { "" };
        return format!("Windings stay clear of each other{seats} {}.", run(map));
    };
    let most = map.points.iter().max_by(|a, b| a.fastest.total_cmp(&b.fastest));
    let most = most.map_or_else(String::new, |point| {
        format!("; hardest at {}, at {} m/s ({})", rpm(point.speed), digits(point.fastest), label(map, point))
    });
    let longest = map.points.iter().filter(|point| point.closed > 0.0).max_by(|a, b| a.closed.total_cmp(&b.closed));
    let longest = longest.map_or_else(String::new, |point| {
        format!("; longest at {}, for {} % of a turn", rpm(point.speed), digits(100.0 * point.closed))
    });
    format!("Windings meet {} ({}){most}{longest}.", spans(map, first, SpeedPoint::meets), label(map, first))
}

fn surge(map: &SpeedMap) -> String {
    let Some(worst) = map.points.iter().max_by(|a, b| a.surge.total_cmp(&b.surge)) else { return String::new() };
    let nearest = map
        .campbell
        .crossings
        .iter()
        .min_by(|a, b| (a.speed - worst.speed).abs().total_cmp(&(b.speed - worst.speed).abs()));
    let by = nearest.filter(|crossing| (crossing.speed / worst.speed - 1.0).abs() < 0.02).map_or_else(
        String::new,
        |crossing| {
            let place = match (rpm(crossing.speed), rpm(worst.speed)) {
                (there, here) if there == here => "where".to_owned(),
                (there, _) => format!("beside {there}, where"),
            };
            format!(", {place} harmonic {} of the cam has the first surge frequency", crossing.harmonic)
        },
    );
    format!(
        "Surge carries an end force {} N ({:.0} % of F_nom) from the static one at {}{by} ({}); F_i and F_o then differ by {} N rms.",
        digits(worst.surge),
        100.0 * worst.surge / map.spec.spring.spring.nominal_force(),
        rpm(worst.speed),
        label(map, worst),
        digits(worst.apart)
    )
}

/// Whether end turns meet their seats in every way that is run; where windings do not meet, neither do they.
fn has_seats(map: &SpeedMap) -> bool {
    map.spec.mount.cases.iter().all(|way| way.contact.as_ref().is_none_or(|way| way.contact.ends()))
}

/// The force at which all windings lie on each other \[N\], and by what share a push may be above it \[1\]: blows of windings on each other are beside that.
fn solid_force(map: &SpeedMap) -> f64 {
    let spring = &map.spec.spring.spring;
    spring.stiffness() * (spring.rest_length() - map.spec.spring.solid_length())
}

const ABOVE: f64 = 0.02;

/// Pushes that no spring has: beyond the force at which it is solid, where end turns are pressed through seats that are not there.
fn pressed_through(map: &SpeedMap) -> Option<String> {
    let solid = solid_force(map);
    let push = |point: &SpeedPoint| -point.input[0].min(point.output[0]);
    let is_beyond = |point: &SpeedPoint| push(point) > (1.0 + ABOVE) * solid;
    if has_seats(map) || map.spec.spring.spring.sections().is_some() {
        return None;
    }
    let first = lowest(map, is_beyond)?;
    let worst = map.points.iter().max_by(|a, b| push(a).total_cmp(&push(b)))?;
    Some(format!(
        "Not to be trusted where an end pushes with more than {} N, the force at which the spring is solid. It does so {}, with up to {} N at {}: end turns pass \
         through their seats, which are left out ([contact] ends = false).",
        digits(solid),
        spans(map, first, is_beyond),
        digits(push(worst)),
        rpm(worst.speed)
    ))
}

/// Change of the most surge by twice the masses below which they are enough, as `analyze` has it where windings meet.
const ENOUGH: f64 = crate::study::ENOUGH_WITH_CONTACT;

/// A change below this share of F_nom counts for nothing.
const FELT: f64 = 0.005;

/// Whether the figures have converged in the number of masses.
fn finer(map: &SpeedMap) -> Option<String> {
    let finer = &map.finer;
    let untried = finer
        .untried
        .as_ref()
        .map(|why| format!("Convergence in the number of masses is not checked at every decisive speed: {why}."));
    let worst = map.points.iter().max_by(|a, b| a.surge.total_cmp(&b.surge))?;
    let mut off = Vec::new();
    let mut settled = None;
    let twice = masses(finer.per_winding);
    if let Some(run) = finer.run_of(map, worst) {
        let (change, nominal) = ((run.surge - worst.surge).abs(), map.spec.spring.spring.nominal_force());
        let (now, then, at) = (digits(worst.surge), digits(run.surge), rpm(run.speed));
        match change > ENOUGH * worst.surge && change > FELT * nominal {
            true => off.push(format!("the largest surge is {then} N, not {now} N, at {at}")),
            false => settled = Some(format!("the largest surge is {then} N")),
        }
        if let [Some(stress), Some(now)] = [run.stress, worst.stress].map(|stress| stress.map(|stress| stress.largest))
            && (stress - now).abs() > ENOUGH * now
        {
            off.push(format!("the largest stress there is {:.0} MPa, not {:.0} MPa", 1e-6 * stress, 1e-6 * now));
        }
    }
    let of = [
        (SpeedPoint::is_aloft as fn(&SpeedPoint) -> bool, "the follower does not float"),
        (SpeedPoint::meets, "windings do not meet"),
    ];
    for (holds, not) in of {
        let there = lowest(map, holds).and_then(|first| finer.run_of(map, first));
        if let Some(run) = there.filter(|run| !holds(run)) {
            off.push(format!("{not} at {} yet", rpm(run.speed)));
        }
    }
    let said = match (off.is_empty(), settled) {
        (false, _) => Some(format!(
            "Not converged: with {twice} per winding in place of {}, {}.",
            map.masses_per_winding,
            off.join("; ")
        )),
        (true, Some(settled)) => Some(format!(
            "Converged: with {twice} per winding in place of {}, {settled}, and what floats or meets first is the same.",
            map.masses_per_winding
        )),
        (true, None) => None,
    };
    match (said, untried) {
        (None, None) => None,
        (said, untried) => Some([said, untried].into_iter().flatten().collect::<Vec<_>>().join(" ")),
    }
}

/// What of the spec is not asked here.
fn aside(map: &SpeedMap) -> Option<String> {
    let names: Vec<&str> = map.spec.sensors.iter().map(|sensor| sensor.name.as_str()).collect();
    (!names.is_empty())
        .then(|| format!("speed judges no sensors; analyze does, under conditions: {}.", names.join(", ")))
}

/// How near an end is to leaving its seat.
fn seats(map: &SpeedMap) -> String {
    let least = |point: &SpeedPoint| point.least_push().into_iter().fold(f64::INFINITY, f64::min);
    let Some(worst) = map.points.iter().min_by(|a, b| least(a).total_cmp(&least(b))) else { return String::new() };
    let at = format!("{} ({})", rpm(worst.speed), label(map, worst));
    let lifts = |point: &SpeedPoint| point.lifts.is_some_and(|lifts| lifts > 0.0);
    let blow = |point: &SpeedPoint| point.blow.unwrap_or(0.0);
    let hardest = map.points.iter().max_by(|a, b| blow(a).total_cmp(&blow(b))).filter(|point| blow(point) > 0.0);
    let blows = hardest.map_or_else(String::new, |point| {
        format!(
            " Blows on a seat, up to {} mN s at {} ({}), are not included in these forces: a stiff load cell shows them as peaks. More masses per winding make them smaller and more frequent.",
            digits(1e3 * blow(point)),
            rpm(point.speed),
            label(map, point)
        )
    });
    match lowest(map, lifts) {
        Some(first) => format!("An end leaves its seat {} ({}).{blows}", spans(map, first, lifts), label(map, first)),
        None if least(worst) < 0.0 => {
            format!("A seat would have to pull with {} N at {at}: lift_off is off.", digits(-least(worst)))
        }
        None => format!("Seats are pressed with {} N at least, at {at}.{blows}", digits(least(worst))),
    }
}

/// The stress of the wire and, where strengths are given, what is left to Goodman's line.
fn fatigue(map: &SpeedMap) -> String {
    let each = map.points.iter().filter_map(|point| Some((point, point.stress?)));
    let danger = |stress: &Stress| stress.safety.map_or(stress.largest, |safety| 1.0 / safety);
    let Some((point, stress)) = each.max_by(|a, b| danger(&a.1).total_cmp(&danger(&b.1))) else { return String::new() };
    let [mean, amplitude] = [stress.mean(), stress.amplitude()].map(|stress| format!("{:.0}", 1e-6 * stress));
    let at = format!("at {} ({})", rpm(point.speed), label(map, point));
    match stress.safety {
        Some(safety) => format!(
            "The wire is stressed by {mean} \u{b1} {amplitude} MPa where that counts most, {at}: a Goodman factor of {safety:.2}{}. Blows of windings on each other are beside that.",
            if safety < 1.0 { ", so it breaks before long" } else { "" }
        ),
        None => format!(
            "The wire is stressed by {mean} \u{b1} {amplitude} MPa at most, {at}; the spec gives no strengths, so no Goodman factor."
        ),
    }
}

/// How many speeds stand beside the steps.
fn refined(map: &SpeedMap) -> Option<String> {
    let most = map.added.iter().copied().max().filter(|most| *most > 0)?;
    let least = map.added.iter().copied().min().unwrap_or(most);
    let count = if least == most { most.to_string() } else { format!("{least} to {most}") };
    Some(format!(
        "Besides the steps {count} speeds of each case were run: where a harmonic of the cam has the first surge frequency, and half a half-power bandwidth \
         below and above."
    ))
}

/// The largest surge of each way of rebounding.
fn rebound(map: &SpeedMap) -> String {
    let ways = &map.spec.mount.cases;
    let mut laws: Vec<&str> = Vec::new();
    for way in ways.iter().filter_map(|way| way.contact.as_ref()) {
        if !laws.contains(&way.label.as_str()) {
            laws.push(&way.label);
        }
    }
    if laws.len() < 2 || map.points.iter().all(|point| point.touches == 0.0) {
        return String::new();
    }
    let of = |law: &&str| {
        let is_its = |point: &&SpeedPoint| ways[point.way].contact.as_ref().is_some_and(|way| way.label == **law);
        let most = map.points.iter().filter(is_its).map(|point| point.surge).fold(0.0, f64::max);
        format!("{} N at {law}", digits(most))
    };
    let each: Vec<String> = laws.iter().map(of).collect();
    format!("How windings rebound nobody has measured: the largest surge is {}.", each.join(" and "))
}

fn unsettled(map: &SpeedMap) -> Option<String> {
    let wild: Vec<&SpeedPoint> = map.points.iter().filter(|point| point.unsettled > SETTLED).collect();
    let most = wild.iter().max_by(|a, b| a.unsettled.total_cmp(&b.unsettled))?;
    let is_clear = |point: &&&SpeedPoint| !point.meets() && !point.is_aloft() && point.lifts.unwrap_or(0.0) == 0.0;
    let clear = match wild.iter().filter(is_clear).count() {
        0 => String::new(),
        clear => format!(
            " In {clear} of them nothing has met, floated or left its seat yet; it still may, since with so little damping the motion builds up for longer than is run."
        ),
    };
    Some(format!(
        "{} of {} runs do not repeat from turn to turn (most at {}, by {:.0} % of F_nom): extremes there are those of four turns only.{clear}",
        wild.len(),
        map.points.len(),
        rpm(most.speed),
        100.0 * most.unsettled
    ))
}

fn given_up(map: &SpeedMap) -> Option<String> {
    let ended: Vec<&SpeedPoint> = map.points.iter().filter(|point| point.given_up.is_some()).collect();
    let first = ended.iter().min_by(|a, b| a.speed.total_cmp(&b.speed))?;
    Some(format!(
        "{} of {} runs could not be followed to their end, the slowest at {}: a solid stack, or one that chatters. Their figures are of what there is.",
        ended.len(),
        map.points.len(),
        rpm(first.speed)
    ))
}
