//! Other mounts, other rates, records that say little.

use coilsense::identify::{Answer, Estimate, Identification, Meaning, ModeSeries, Settings, Trust};
use coilsense::{Channel, Damping, Excitation, FarEnd, Motion, Mount, Signals};

use crate::paper_springs::s_t;
use crate::records::{bumped, hit, own};

/// f1 of S_T's chain with both ends held \[Hz\].
const FIRST: f64 = 54.057_265;

fn of(signals: &Signals, settings: &Settings) -> Identification {
    Identification::of(signals, settings).unwrap()
}

/// What S_T's maker says of it.
fn known() -> Settings {
    Settings { mass: Some(0.065), windings: Some(52.0), ..Settings::default() }
}

#[test]
fn a_free_end_rings_on_odd_multiples_of_half_the_held_frequency() {
    let found = of(&bumped(FarEnd::Force, 2500.0), &Settings::default());
    assert_eq!(found.mode_series, Some(ModeSeries::HeldFree));
    assert_eq!(found.verdict.answer, Answer::Spring);
    // The chain's own N is fitted from the series; what is left of its misfit is 1e-5.
    assert!((found.first_frequency.unwrap().value - FIRST).abs() < 2e-5 * FIRST);
}

#[test]
fn an_end_mass_is_weighed_by_its_own_motion() {
    for mass in [0.05, 0.5] {
        let found = of(&bumped(FarEnd::Mass(mass), 2500.0), &Settings::default());
        assert_eq!(found.verdict.answer, Answer::Spring, "{mass} kg");
        assert!(matches!(found.mode_series, Some(ModeSeries::EndMass { .. })), "{mass} kg");
        // F_o over acceleration at one line, noise of 0.02 N and 5 µm: 0.1 %.
        assert!((found.end_mass.unwrap() / mass - 1.0).abs() < 1e-3, "{mass} kg is taken for {:?}", found.end_mass);
        // The continuous coil's β tan β = m/M is that of 52 windings to 0.02 %.
        assert!((found.first_frequency.unwrap().value / FIRST - 1.0).abs() < 4e-4);
    }
}

#[test]
fn lines_above_half_the_rate_are_known_as_folded() {
    let found = of(&bumped(FarEnd::Position, 250.0), &known());
    assert_eq!(found.verdict.answer, Answer::Spring);
    let folded = |mode: usize| {
        found.lines.iter().any(|line| matches!(line.meaning, Meaning::Alias { mode: of, .. } if of == mode))
    };
    assert!((3..=5).all(folded), "modes 3 to 5 lie above 125 Hz and fold below it");
}

#[test]
fn a_first_mode_that_folds_leaves_it_undecided_and_asks_for_a_higher_rate() {
    let signals = bumped(FarEnd::Position, 100.0);
    for settings in [Settings::default(), known()] {
        let found = of(&signals, &settings);
        assert_eq!(found.verdict.answer, Answer::Undecided, "{:?}", found.verdict);
        assert!(found.verdict.next.iter().any(|next| next.contains("sample at")), "{:?}", found.verdict.next);
    }
    assert!(of(&signals, &known()).first_frequency.is_none(), "a folded line is no f1");
}

#[test]
fn what_was_said_of_the_spring_is_held_against_the_record() {
    let signals = hit(&s_t(), 0.004, 7, [0.0; 3]).signals;
    assert!((of(&signals, &known()).predicted.unwrap() - FIRST).abs() < 1e-3 * FIRST);
    // A series that is not the predicted one: the record speaks against what was said, and not against the spring.
    let wrong = of(&signals, &Settings { mass: Some(0.1), ..Settings::default() });
    assert_eq!(wrong.verdict.answer, Answer::Undecided);
    assert!(wrong.verdict.evidence[0].contains("Hz"), "{:?}", wrong.verdict.evidence);
}

#[test]
fn one_force_alone_still_shows_the_mode_series() {
    let truth = hit(&own(), 0.006, 11, [0.0; 3]);
    let mut signals = Signals::new(truth.signals.time().to_vec()).unwrap();
    signals.insert(Channel::OutputForce, truth.signals.channel(Channel::OutputForce).unwrap().to_vec()).unwrap();
    let found = of(&signals, &Settings::default());
    assert_eq!(found.verdict.answer, Answer::Spring);
    assert!(
        found.stiffness.unwrap_err().contains("position"),
        "without a position there is no stiffness, and it says so"
    );
    assert!(found.mass.is_none());
    assert!((found.first_frequency.unwrap().value / truth.frequency - 1.0).abs() < 1e-4);
}

#[test]
fn half_power_agrees_with_the_ring_down_where_it_is_given_and_says_why_where_not() {
    // Broad enough to be resolved, narrow enough to stand alone.
    let found = of(&hit(&s_t(), 0.01, 5, [0.0; 3]).signals, &Settings::default());
    let first = found.lines.iter().find(|line| line.mode() == Some(1)).unwrap();
    let (ring_down, half_power): (Estimate, Estimate) = (first.ratio.unwrap(), *first.half_power.as_ref().unwrap());
    assert!((ring_down.value - half_power.value).abs() <= ring_down.expanded + half_power.expanded);
    // A width of 0.1 Hz takes 24 s of quiet after each hit.
    let sharp = of(&hit(&s_t(), 0.001, 5, [0.0; 3]).signals, &Settings::default());
    let first = sharp.lines.iter().find(|line| line.mode() == Some(1)).unwrap();
    assert!(first.half_power.as_ref().unwrap_err().contains("quiet"));
}

#[test]
fn trusted_frequencies_are_where_the_wave_equation_reaches_the_tolerance() {
    let (tau, tolerance) = (9.25e-3, 0.02);
    let trust = Trust::of(tau, tolerance).unwrap();
    let angle = |frequency: f64| std::f64::consts::TAU * frequency * tau;
    let (x, y, z) =
        (angle(trust.output_for_input), angle(trust.deflection_for_input), angle(trust.deflection_for_output));
    // Each is the root of its own equation, to rounding of the equation.
    assert!((1.0 / x.cos() - 1.0 - tolerance).abs() < 1e-13);
    assert!((y.tan() / y - 1.0 - tolerance).abs() < 1e-13);
    assert!((1.0 - z.sin() / z - tolerance).abs() < 1e-13);
}

#[test]
fn records_that_say_nothing_are_undecided_and_say_so() {
    let times: Vec<f64> = (0..2000).map(|n| f64::from(n) / 1000.0).collect();
    let constant = |value: f64| {
        let mut signals = Signals::new(times.clone()).unwrap();
        for channel in [Channel::InputForce, Channel::OutputForce, Channel::U1, Channel::U2] {
            signals.insert(channel, vec![value; 2000]).unwrap();
        }
        signals
    };
    for value in [0.0, 3.25, 1e9, -1e-9] {
        let found = of(&constant(value), &Settings::default());
        assert_eq!(found.verdict.answer, Answer::Undecided, "all {value}");
        assert!(!found.verdict.next.is_empty(), "all {value}");
    }
    // A single jump is no ringing.
    let mut step = Signals::new(times.clone()).unwrap();
    step.insert(Channel::OutputForce, (0..2000).map(|n| if n < 1000 { 0.0 } else { 10.0 }).collect()).unwrap();
    assert_ne!(of(&step, &Settings::default()).verdict.answer, Answer::Spring);
    let mut short = Signals::new(times[..3].to_vec()).unwrap();
    short.insert(Channel::OutputForce, vec![1.0, 2.0, 3.0]).unwrap();
    let error = Identification::of(&short, &Settings::default()).unwrap_err().to_string();
    assert_eq!(error, "samples of the record must hold at least 64 values, got 3");
    let forceless = Signals::new(times).unwrap();
    let error = Identification::of(&forceless, &Settings::default()).unwrap_err().to_string();
    assert_eq!(error, "signal F_i, F_o or F_L is missing");
}

#[test]
fn a_length_that_stands_still_has_no_stiffness() {
    let mount = Mount::new(FarEnd::Position, Damping::Modal(0.005)).unwrap();
    let hit = Excitation::impact(0.23, 0.25).unwrap();
    let times: Vec<f64> = (0..50_000).map(|n| f64::from(n) / 2500.0).collect();
    let signals = Motion::mounted(&s_t(), &mount, &hit).unwrap().signals(&times).unwrap();
    let found = of(&signals, &Settings::default());
    // u1 = 0 and u2 = 0.23 m at every sample: what rounding leaves of them is no motion.
    let reason = found.stiffness.unwrap_err();
    assert!(reason.contains("too little for a stiffness"), "{reason}");
    assert!((found.first_frequency.unwrap().value - FIRST).abs() < 1e-5);
}

#[test]
fn a_spring_that_is_only_shaken_shows_its_dynamic_stiffness_and_gets_none() {
    let shaken = |hertz: f64| {
        let input = coilsense::EndInput::harmonic(1e-3, hertz, 0.0);
        let shake = Excitation::harmonic(0.23, coilsense::End::One, input, coilsense::Start::Steady).unwrap();
        let mount = Mount::new(FarEnd::Position, Damping::Modal(0.005)).unwrap();
        let times: Vec<f64> = (0..50_000).map(|n| f64::from(n) / 2500.0).collect();
        let signals = Motion::mounted(&s_t(), &mount, &shake).unwrap().signals(&times).unwrap();
        of(&signals, &known()).stiffness
    };
    // At 11 Hz a block mean holds a thirtieth of the motion, and its force 7 % more than k of it.
    let reason = shaken(11.236).unwrap_err();
    assert!(reason.contains("move too fast"), "{reason}");
    let slow = shaken(0.1).unwrap();
    assert!((slow.value() / 760.0 - 1.0).abs() < 1e-4, "{}", slow.value());
}

/// S_T, ζ 0.005, end 1 moved by 5 mm at a frequency \[Hz\] for 20 s, from rest or hit at the beginning, a little noise.
fn shaken(hertz: f64, hit: bool) -> coilsense::identify::Identification {
    let input = coilsense::EndInput::harmonic(5e-3, hertz, 0.0);
    let start = match hit {
        true => coilsense::Start::Moving { velocity: 0.25, profile: coilsense::VelocityProfile::Uniform },
        false => coilsense::Start::Steady,
    };
    let excitation = Excitation::new(0.23, input, coilsense::EndInput::Held, start).unwrap();
    let mount = Mount::new(FarEnd::Position, Damping::Modal(0.005)).unwrap();
    let times: Vec<f64> = (0..50_000).map(|n| f64::from(n) / 2500.0).collect();
    let exact = Motion::mounted(&s_t(), &mount, &excitation).unwrap().signals(&times).unwrap();
    let mut random = rand_pcg::rand_core::SeedableRng::seed_from_u64(3);
    let mut signals = Signals::new(times).unwrap();
    for (channel, noise) in
        [(Channel::U1, 5e-6), (Channel::U2, 5e-6), (Channel::InputForce, 0.02), (Channel::OutputForce, 0.02)]
    {
        let values = exact.channel(channel).unwrap().to_vec();
        signals.insert(channel, crate::records::noisy(values, 0.0, noise, &mut random)).unwrap();
    }
    of(&signals, &Settings::default())
}

#[test]
fn a_stiffness_from_a_quick_motion_carries_the_coils_mass_in_its_interval() {
    for hertz in [0.7, 2.2, 4.1] {
        let stiffness = shaken(hertz, true).stiffness.unwrap();
        // Mean of both end forces: k (1 − (ωτ)²/12), up to 0.5 % low, under noise that alone would give an interval of 0.01 %.
        assert!(
            stiffness.stiffness.expanded > (stiffness.value() - 760.0).abs(),
            "{hertz} Hz: {:?}",
            stiffness.stiffness
        );
        let slow = stiffness.angular_frequency / std::f64::consts::TAU;
        assert!((slow / hertz - 1.0).abs() < 0.01, "{hertz} Hz: {slow}"); // the Hann mean's own attenuation falls out; noise is left
        let reason = shaken(hertz, false).stiffness.unwrap_err();
        assert!(reason.contains("no ring-down tells"), "{reason}");
    }
    assert!((shaken(0.2, false).stiffness.unwrap().value() / 760.0 - 1.0).abs() < 5e-5);
}
