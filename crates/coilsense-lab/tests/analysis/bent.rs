//! A chain of masses has a straight line for its force, and the coil that it stands for has none: what that costs a sensor of length.
//!
//! Next door: the same where the helix itself moves (`helix`).

use coilsense::helix::{Helix, Turning};
use coilsense_lab::analysis::{Analysis, Verdict, answer};
use coilsense_lab::study::Bent;

use super::{line, run, spec, verdict};

const STRAIGHT: &str = "the force as a straight line";

/// A pressed spring by its geometry: D/d = 7.3 and windings that rise by 7 degrees at rest.
const PRESSED: &str = "name = \"pressed\"\nrest_length = \"60 mm\"\nwindings = 6.5\ncoil_diameter = \"22 mm\"\nwire_diameter = \"3 mm\"\n\
                       material = \"steel EN 10270-1\"\nend_type = \"closed-ground\"\nmin_length = \"35 mm\"\nmax_length = \"55 mm\"\n\
                       stiffness_tolerance = \"0.5 %\"\n";

const SENSORS: &str = "[[sensor]]\nname = \"encoder\"\nkind = \"deflection\"\n[[sensor]]\nname = \"coil\"\nkind = \"inductance\"\n\
                       [[sensor]]\nname = \"cell\"\nkind = \"load-cell\"\nend = 1\n";

const WALK: &str = "[[condition]]\nname = \"walk\"\nkind = \"harmonic\"\nfrequency = \"0.1 Hz\"\namplitude = \"40 %\"\nstart = \"massless\"\n\
                    duration = \"10 s\"\nsample_rate = \"100 Hz\"\n";

const GOAL: &str = "[goal]\nerror = \"0.6 %\"\n";

fn pressed(more_of_spring: &str, more: &str) -> Analysis {
    run(&format!(
        "[spring]\n{PRESSED}{more_of_spring}\n[mount]\ndamping_ratio = 0.005\nends_tilt = \"held\"\n[uncertainty]\ntrials = 20000\n{SENSORS}{more}"
    ))
}

/// What an inextensible wire pulls with at the span s of its windings, its ends held against turning \[N\]; the wire of [`PRESSED`].
///
/// U/L = ½ EI (κ − κ_0)² + ½ GJ (τ − τ_0)², κ = ψ cos α/L, τ = ψ sin α/L, s = L sin α: F = dU/ds.
fn wire(span: f64) -> f64 {
    let (windings, radius, d, modulus_e, modulus_g) = (6.5_f64, 11e-3_f64, 3e-3_f64, 206e9, 81.5e9);
    let turn = std::f64::consts::TAU * windings;
    let rest = 60e-3 - DEAD;
    let wire = (turn * radius).hypot(rest);
    let second = std::f64::consts::PI * d.powi(4) / 64.0;
    let (sine, sine0) = (span / wire, rest / wire);
    let (cosine, cosine0) = ((1.0 - sine * sine).sqrt(), (1.0 - sine0 * sine0).sqrt());
    let bend = modulus_e * second * (cosine - cosine0) * (-sine / cosine);
    let twist = modulus_g * 2.0 * second * (sine - sine0);
    (turn / wire).powi(2) * (bend + twist)
}

/// What closed and ground ends are long beside the active windings: a wire each.
const DEAD: f64 = 6e-3;

fn of<'a>(analysis: &'a Analysis, name: &str) -> &'a Verdict {
    verdict(analysis, name)
}

fn mean_error(verdict: &Verdict) -> f64 {
    verdict.budget.budget.bias()
}

#[test]
fn a_spring_by_its_geometry_errs_by_what_the_flat_coil_leaves_out() {
    let coil = pressed("", &format!("{WALK}{GOAL}"));
    let spring = &coil.spec.spring;
    assert!((-spring.geometry.active_span(0.0) - DEAD).abs() < 1e-12, "{}", spring.geometry.active_span(0.0));
    let signals = &coil.cases[0].signals;
    let of_ends = [coilsense::Channel::U1, coilsense::Channel::U2].map(|of| signals.channel(of).unwrap());
    let errors: Vec<f64> = of_ends[0]
        .iter()
        .zip(of_ends[1])
        .map(|(u1, u2)| spring.spring.static_force(u2 - u1) - wire(u2 - u1 - DEAD))
        .collect();
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    let variance = errors.iter().map(|error| (error - mean).powi(2)).sum::<f64>() / errors.len() as f64;
    // The flat coil is stiffer than the wire in use: by 1.1 % of the force.
    assert!(mean < -1.9 && variance.sqrt() > 0.5, "{mean} {variance}");
    for name in ["encoder", "coil"] {
        let told = of(&coil, name);
        assert!((told.budget.bend / mean - 1.0).abs() < 1e-6, "{name}: {} {mean}", told.budget.bend);
        assert!(
            (line(told, STRAIGHT) / variance.sqrt() - 1.0).abs() < 1e-6,
            "{name}: {} {variance}",
            line(told, STRAIGHT)
        );
    }
    let (told, whole) = (of(&coil, "encoder"), mean.hypot(variance.sqrt()));
    assert!((mean_error(told) - mean).abs() < 1e-3 * mean.abs(), "{}", mean_error(told));
    assert!(told.combined() >= whole && told.meets_always() == Some(false), "{}", told.combined());
    let worst = told.at_worst();
    // Beside it the warmth of 10 K makes 0.5 N.
    let about = |value: f64| value >= whole && value < 1.03 * whole;
    assert!(about(worst.nominal) && about(worst.raw), "{worst:?} {whole}");
    assert!(worst.inside.unwrap() < 0.5, "{worst:?}");
    // The Monte Carlo has it as well.
    assert!((told.budget.mean - told.budget.force - mean).abs() < 0.05 * mean.abs(), "{:?}", told.budget);
    let cell = of(&coil, "cell");
    assert_eq!((line(cell, STRAIGHT), cell.budget.bend), (0.0, 0.0));
    assert_eq!(cell.meets_always(), Some(true));
    let text = answer(&coil).join("\n");
    assert!(text.contains(" N since the coil's force is no straight line"), "{text}");
    // What the helix says of itself when it moves.
    let helix = pressed("model = \"helix\"", &format!("{WALK}{GOAL}"));
    let [one, other] = [&coil, &helix].map(|analysis| of(analysis, "encoder").combined());
    assert!((one / other - 1.0).abs() < 0.02, "{one} {other}");
    let [one, other] = [&coil, &helix].map(|analysis| of(analysis, "encoder").at_worst().inside.unwrap());
    assert!((one - other).abs() < 0.05, "{one} {other}");
}

#[test]
fn the_curve_is_that_of_a_wire_that_shears_and_extends_once_both_have_the_same_slope() {
    let springs = [
        PRESSED,
        "name = \"S_T\"\nrest_length = \"104 mm\"\nwindings = 52\ncoil_diameter = \"16 mm\"\nwire_diameter = \"2 mm\"\n\
                             material = \"steel EN 10270-1\"\nend_type = \"hooks\"\nmin_length = \"196 mm\"\nmax_length = \"264 mm\"\n",
    ];
    for spring in springs {
        let spec = spec(&format!("[spring]\n{spring}stiffness_at = \"range\"\n"));
        let spring = &spec.spring;
        let (rod, (low, high)) = (spring.rod().unwrap(), spring.spring.operating_range());
        let helix = |length: f64| Helix::new(&rod, spring.geometry.active_span(length), Turning::Held).unwrap();
        let (bent, middle) = (Bent::of(spring, Turning::Held).unwrap(), spring.spring.mid_length());
        let line = |length: f64| spring.spring.static_force(length);
        let (mut apart, mut bend) = (0.0_f64, 0.0_f64);
        for step in 0..=20 {
            let length = low + (high - low) * f64::from(step) / 20.0;
            // The solved rod shares no code with the closed form; it is moved to the same force in the middle.
            let solved = helix(length).force() - helix(middle).force() + line(middle);
            apart = apart.max((bent.force(length).unwrap() - solved).abs());
            bend = bend.max((solved - line(length)).abs());
        }
        assert!(bend > 0.02 && apart < 0.02 * bend, "{}: {apart} of {bend} N", spring.name);
    }
}

#[test]
fn what_helps_is_to_measure_the_spring_where_it_is_used() {
    let coil = pressed("", &format!("{WALK}{GOAL}"));
    let told = of(&coil, "encoder");
    let fix = told
        .fixes
        .iter()
        .find(|fix| fix.change.contains("middle of the range"))
        .expect("measured in use it meets the goal");
    // The same written into the spec.
    let measured = pressed("stiffness_at = \"range\"", &format!("{WALK}{GOAL}"));
    let meets = of(&measured, "encoder");
    assert_eq!(meets.meets_always(), Some(true));
    assert!((meets.combined() / fix.combined - 1.0).abs() < 1e-3, "{} {}", meets.combined(), fix.combined);
    // What is left is how far the force bends within the range, which no straight line has.
    assert!(
        line(meets, STRAIGHT) > 0.05 && meets.budget.bend.abs() < 0.5,
        "{} {}",
        line(meets, STRAIGHT),
        meets.budget.bend
    );
    // Where something else is wrong, it is no help, and is not named.
    let rough =
        "[[sensor]]\nname = \"rough\"\nkind = \"deflection\"\naccuracy_full_scale = \"4 %\"\nrange = \"20 mm\"\n";
    let coil = pressed("", &format!("{rough}{WALK}{GOAL}"));
    assert!(of(&coil, "rough").fixes.iter().all(|fix| !fix.change.contains("middle of the range")));
    // Nor of a spring that was measured there, nor of a load cell.
    let measured = pressed("stiffness_at = \"range\"", &format!("{rough}{WALK}[goal]\nerror = \"0.02 %\"\n"));
    let fixes = measured.verdicts.iter().flat_map(|verdict| &verdict.fixes);
    assert!(fixes.clone().all(|fix| !fix.change.contains("middle of the range")), "{:?}", fixes.collect::<Vec<_>>());
}

#[test]
fn a_drawings_spring_wants_its_rate_measured_in_use_and_how_well_is_told() {
    let drawn = "wire_diameter_tolerance = \"1 %\"\ncoil_diameter_tolerance = \"1 %\"\nwindings_tolerance = \"0.5 %\"\nshear_modulus_tolerance = \"2 %\"\n";
    let of_spring = |more: &str| {
        let spring = PRESSED.replace("stiffness_tolerance = \"0.5 %\"\n", more);
        assert_ne!(spring, PRESSED);
        run(&format!(
            "[spring]\n{spring}\n[mount]\ndamping_ratio = 0.005\nends_tilt = \"held\"\n[uncertainty]\ntrials = 1000\n{SENSORS}{WALK}{GOAL}"
        ))
    };
    let drawing = of_spring(drawn);
    let told = of(&drawing, "encoder");
    assert_eq!(told.meets_always(), Some(false));
    let fix =
        told.fixes.iter().find(|fix| fix.change.starts_with("k and F measured in the middle of the range, k within ±"));
    let fix = fix.unwrap_or_else(|| panic!("{:?}", told.fixes));
    // The same written into the spec; twice as unsure it is not enough.
    let share: f64 = fix.change.split('±').nth(1).unwrap().trim_end_matches(" %").parse().unwrap();
    let measured = |share: f64| of_spring(&format!("stiffness_at = \"range\"\nstiffness_tolerance = \"{share} %\"\n"));
    let (enough, too_little) = (measured(share), measured(2.0 * share));
    assert_eq!(of(&enough, "encoder").meets_always(), Some(true), "{share}");
    assert!((of(&enough, "encoder").combined() / fix.combined - 1.0).abs() < 1e-3, "{fix:?}");
    assert_eq!(of(&too_little, "encoder").meets_always(), Some(false), "{share}");
    // Of a rate that was measured there, a better one is wanted, and no measurement once more.
    let fixes = &of(&too_little, "encoder").fixes;
    assert!(fixes.iter().any(|fix| fix.change.starts_with("a stiffness known within ±")), "{fixes:?}");
    assert!(fixes.iter().all(|fix| !fix.change.contains("middle of the range")), "{fixes:?}");
}

#[test]
fn a_constant_length_in_the_middle_of_a_measured_range_adds_nothing() {
    let shaken =
        "[[condition]]\nkind = \"impact\"\nvelocity = \"0.1 m/s\"\nduration = \"0.5 s\"\nsample_rate = \"1 kHz\"\n";
    let coil = pressed("stiffness_at = \"range\"", &format!("{shaken}{GOAL}"));
    for name in ["encoder", "coil"] {
        let told = of(&coil, name);
        assert_eq!((line(told, STRAIGHT), told.budget.bend), (0.0, 0.0), "{name}");
        assert!(told.budget.budget.contributions().iter().all(|line| line.name != STRAIGHT), "{name}");
    }
}

#[test]
fn a_goal_with_a_bandwidth_keeps_the_mean_error() {
    let all = pressed("", &format!("{WALK}{GOAL}"));
    let slow = pressed("", &format!("{WALK}{GOAL}bandwidth = \"0.02 Hz\"\n"));
    let [all, slow] = [&all, &slow].map(|analysis| of(analysis, "encoder"));
    assert!((slow.budget.bend / all.budget.bend - 1.0).abs() < 0.02, "{} {}", slow.budget.bend, all.budget.bend);
    // What changes with the motion does so at 0.1 Hz and is filtered away.
    assert!(line(slow, STRAIGHT) < 0.3 * line(all, STRAIGHT), "{} {}", line(slow, STRAIGHT), line(all, STRAIGHT));
}

#[test]
fn ends_that_may_turn_count_as_they_are_worst() {
    let of_ends = |turn: &str| {
        let coil = run(&format!(
            "[spring]\n{PRESSED}\n[mount]\ndamping_ratio = 0.005\nends_tilt = \"held\"\nends_turn = \"{turn}\"\n[uncertainty]\ntrials = 1000\n{SENSORS}{WALK}{GOAL}"
        ));
        of(&coil, "encoder").budget.bend
    };
    let [held, free, between] = ["held", "free", "between"].map(of_ends);
    assert!(held != free && between == if held.abs() > free.abs() { held } else { free }, "{held} {free} {between}");
}
