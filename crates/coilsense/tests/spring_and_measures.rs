//! Small definitions, each against numbers worked out by hand.

mod paper_springs;

use approx::assert_relative_eq;
use coilsense::inductance::{MaxwellSum, SelfDistance, mutual_inductance};
use coilsense::{Calibration, Clash, Deviation, Excitation, InductanceSensor, Motion, Spring};
use paper_springs::{s_a, s_t, s_t_with};

#[test]
fn what_follows_from_table_i() {
    let spring = s_t();
    assert_relative_eq!(spring.transit_time(), (0.065_f64 / 760.0).sqrt(), max_relative = 1e-15);
    assert_relative_eq!(spring.surge_frequency(), 54.065_487_356_3, max_relative = 1e-11);
    assert_relative_eq!(spring.wave_impedance(), (0.065_f64 * 760.0).sqrt(), max_relative = 1e-15);
    assert_relative_eq!(spring.nominal_force(), 121.6, max_relative = 1e-14);
    assert_relative_eq!(spring.solid_length(), 0.104, max_relative = 1e-15);
    assert_relative_eq!(spring.pitch_at(0.26), 0.005, max_relative = 1e-15);
    assert_relative_eq!(spring.static_force(0.204), 76.0, max_relative = 1e-14);
    assert_eq!(s_a().mid_length(), 0.5 * (0.082 + 0.122));
}

#[test]
fn the_nominal_force_is_the_largest_either_way_unless_given() {
    // A compression spring: longest at rest, so that the shortest length counts.
    let squeezed = Spring::new(s_t_with(|p| (p.min_length, p.max_length) = (0.05, 0.11))).unwrap();
    assert_relative_eq!(squeezed.nominal_force(), 760.0 * 0.054, max_relative = 1e-14);
    let only_squeezed = Spring::new(s_t_with(|p| (p.min_length, p.max_length) = (0.05, 0.09))).unwrap();
    assert_relative_eq!(only_squeezed.nominal_force(), 760.0 * 0.054, max_relative = 1e-14);
    let given = Spring::new(s_t_with(|p| p.nominal_force = Some(50.0))).unwrap();
    assert_eq!(given.nominal_force(), 50.0);
}

#[test]
fn the_operating_range_holds_its_ends_and_nothing_beyond() {
    let spring = s_t();
    for (length, inside) in [(0.1959, false), (0.196, true), (0.23, true), (0.264, true), (0.2641, false)] {
        assert_eq!(spring.in_operating_range(length), inside, "{length}");
    }
}

#[test]
fn the_chain_has_the_windings_rounded_and_at_least_one() {
    for (windings, masses) in [(0.3, 1), (1.0, 1), (24.4, 24), (24.5, 25), (24.6, 25)] {
        assert_eq!(Spring::new(s_t_with(|p| p.windings = windings)).unwrap().chain_masses(), masses, "{windings}");
    }
}

#[test]
fn each_parameter_is_refused_by_name() {
    type Change = fn(&mut coilsense::SpringParameters);
    let cases: [(Change, &str); 8] = [
        (|p| p.rest_length = 0.0, "rest length must be above zero and finite, got 0 m"),
        (|p| p.coil_radius = f64::NAN, "coil radius must be above zero and finite, got NaN m"),
        (|p| p.wire_radius = 0.008, "wire radius must be below the coil radius of 0.008 m, got 0.008 m"),
        (|p| p.stiffness = -1.0, "stiffness must be above zero and finite, got -1 N/m"),
        (|p| p.max_length = 0.1, "max length must be above the min length of 0.196 m, got 0.1 m"),
        (|p| p.nominal_force = Some(0.0), "nominal force must be above zero and finite, got 0 N"),
        (|p| p.inductance_windings = Some(0.2), "inductance windings must be from 0.5 to 100000, got 0.2"),
        (|p| p.mass = 1e-12, "mass must be from 1e-9 to 1e9 kg, got 0.000000000001 kg"),
    ];
    for (change, expected) in cases {
        assert_eq!(Spring::new(s_t_with(change)).unwrap_err().to_string(), expected);
    }
}

#[test]
fn a_deviation_is_what_its_definition_says() {
    // Differences 1, −3, 2, 0: mean 0, squares 14, variance 14/3 over n − 1.
    let deviation = Deviation::between(&[2.0, -2.0, 3.0, 1.0], &[1.0; 4]).unwrap();
    assert_relative_eq!(deviation.rmsd, 3.5_f64.sqrt(), max_relative = 1e-15);
    assert_eq!((deviation.maximum, deviation.maximum_absolute, deviation.mean), (2.0, 3.0, 0.0));
    assert_relative_eq!(deviation.standard_error, (14.0_f64 / 3.0 / 4.0).sqrt(), max_relative = 1e-15);
    let offset = Deviation::between(&[3.0, -1.0, 4.0, 2.0], &[1.0; 4]).unwrap();
    assert_relative_eq!(offset.mean, 1.0, max_relative = 1e-15);
    assert_relative_eq!(offset.standard_error, deviation.standard_error, max_relative = 1e-15);
    let share = offset.relative_to(4.0).unwrap();
    for (part, whole) in [
        (share.rmsd, offset.rmsd),
        (share.maximum, offset.maximum),
        (share.maximum_absolute, offset.maximum_absolute),
        (share.mean, offset.mean),
        (share.standard_error, offset.standard_error),
    ] {
        assert_eq!(part, 0.25 * whole);
    }
}

#[test]
fn series_that_do_not_fit_are_refused() {
    let says = |force: &[f64], reference: &[f64]| Deviation::between(force, reference).unwrap_err().to_string();
    assert_eq!(says(&[], &[]), "force must hold at least 1 values, got 0");
    assert_eq!(says(&[1.0, 2.0], &[1.0]), "reference must hold 2 values, got 1");
    assert_eq!(says(&[1.0, f64::NAN], &[1.0, 1.0]), "force[1] must be finite, got NaN N");
}

#[test]
fn contact_is_found_between_samples() {
    // Uniform windings that all meet at once: the whole coil squeezed by end 2 at 1 m/s, slowly against its waves.
    let spring = Spring::new(s_t_with(|p| p.mass = 1e-6)).unwrap();
    let input = coilsense::EndInput::Ramp { height: -0.1, from: 0.0, duration: 0.1 };
    let start = coilsense::Start::Massless;
    let excitation = Excitation::new(0.15, coilsense::EndInput::Held, input, start).unwrap();
    let motion = Motion::new(&spring, &excitation).unwrap();
    let contact = |step: f64| {
        let times: Vec<f64> = (0..).map(|k| f64::from(k) * step).take_while(|&time| time < 0.09).collect();
        Clash::of(&motion, &times).unwrap()
    };
    let (coarse, fine) = (contact(7e-3), contact(1e-4));
    // Pitch l/N reaches 2ρ at l = 104 mm, 46 ms after the start; the found moment does not hang on the sampling.
    assert_relative_eq!(coarse.first_contact.unwrap(), 0.046, max_relative = 1e-6);
    assert_relative_eq!(fine.first_contact.unwrap(), coarse.first_contact.unwrap(), max_relative = 1e-10);
    assert!(coarse.happens() && coarse.clearance() < 0.0);
}

#[test]
fn the_closest_pair_is_named() {
    let spring = s_t();
    let count = spring.chain_masses();
    let mut positions: Vec<f64> = (0..count).map(|i| (i as f64 + 0.5) * 0.23 / count as f64).collect();
    positions[10] += 1e-3; // winding 11 moves towards winding 12
    let start = coilsense::Start::Windings { positions, velocities: vec![0.0; count] };
    let held = coilsense::EndInput::Held;
    let motion = Motion::new(&spring, &Excitation::new(0.23, held.clone(), held, start).unwrap()).unwrap();
    let clash = Clash::of(&motion, &[0.0]).unwrap();
    assert_eq!((clash.winding, clash.time), (11, 0.0));
    assert_relative_eq!(clash.smallest_pitch, 0.23 / 52.0 - 1e-3, max_relative = 1e-12);
    assert!(!clash.happens());
}

#[test]
fn times_that_cannot_be_watched_are_refused() {
    let motion = Motion::new(&s_t(), &Excitation::impact(0.23, 0.25).unwrap()).unwrap();
    assert!(Clash::of(&motion, &[]).unwrap_err().to_string().starts_with("times must hold at least 1"));
    let message = Clash::of(&motion, &[0.2, 0.1]).unwrap_err().to_string();
    assert_eq!(message, "time[1] must be above its predecessor of 0.2 s, got 0.1 s");
    assert_eq!(
        motion.end_forces(&[0.1, -1.0]).unwrap_err().to_string(),
        "time[1] must be finite and not below zero, got -1 s"
    );
    assert_eq!(motion.end_forces(&[]).unwrap_err().to_string(), "times must hold at least 1 values, got 0");
    assert_eq!(
        motion.signals(&[0.1, 0.1]).unwrap_err().to_string(),
        "time[1] must be above its predecessor of 0.1 s, got 0.1 s"
    );
    // A NaN among many equidistant times, where all are processed together.
    let mut many: Vec<f64> = (0..100).map(|k| f64::from(k) * 1e-3).collect();
    many[57] = f64::NAN;
    assert_eq!(
        motion.end_forces(&many).unwrap_err().to_string(),
        "time[57] must be finite and not below zero, got NaN s"
    );
    assert!(motion.windings(&[f64::NAN]).unwrap_err().to_string().starts_with("time[0] must be finite"));
}

#[test]
fn positions_of_very_many_windings_are_refused_and_their_forces_are_not() {
    let spring = Spring::new(s_t_with(|p| p.windings = 20_000.0)).unwrap();
    let motion = Motion::new(&spring, &Excitation::impact(0.23, 0.25).unwrap()).unwrap();
    let message = motion.windings(&[0.1]).unwrap_err().to_string();
    assert_eq!(message, "windings must be at most 5000 for their positions, got 20000");
    assert!(motion.end_forces(&[0.1]).is_ok());
}

#[test]
fn fractional_windings_follow_the_rule() {
    // 10.4 of them: 10 turns at pitch l/10.4, the self term 10.4 times.
    let spring = Spring::new(s_t_with(|p| p.inductance_windings = Some(10.4))).unwrap();
    let coil = MaxwellSum::new(&spring, SelfDistance::GeometricMean);
    let (radius, length) = (0.008, 0.23);
    let own = SelfDistance::GeometricMean.of_wire(0.001);
    let pairs: f64 =
        (1..10).map(|apart| f64::from(10 - apart) * mutual_inductance(radius, f64::from(apart) * length / 10.4)).sum();
    let expected = 10.4 * mutual_inductance(radius, own) + 2.0 * pairs;
    assert_relative_eq!(coil.at_length(length), expected, max_relative = 1e-14);
    // Carried by the chain: uniform windings give the same, displaced ones another.
    let motion = Motion::new(&spring, &Excitation::impact(length, 0.25).unwrap()).unwrap();
    let series = coil.series(&motion.windings(&[0.0, 3e-3]).unwrap());
    assert_relative_eq!(series[0], expected, max_relative = 1e-13);
    // A wave has run a third of the coil: windings are denser ahead of it, which raises L.
    assert!(series[1] > expected * (1.0 + 1e-6) && series[1] < 1.01 * expected, "{} {expected}", series[1]);
}

#[test]
fn the_calibrated_sensor_is_exact_at_its_preload_and_off_by_the_misfit_elsewhere() {
    let spring = s_t();
    let coil = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
    let fit = Calibration::theoretical(&spring, &coil, 0.23).unwrap();
    let sensor = InductanceSensor::new(&spring, fit);
    let force = sensor.force(&[coil.at_length(0.23)])[0];
    assert_relative_eq!(force, spring.static_force(0.23), max_relative = 1e-12);
    let worst = (0..=100)
        .map(|k| 0.196 + 0.068 * f64::from(k) / 100.0)
        .map(|length| (sensor.force(&[coil.at_length(length)])[0] - spring.static_force(length)).abs())
        .fold(0.0, f64::max);
    // tests/golden/calibration.csv, S_T, as printed, preload 0.23 m: largest |F_L − F_x|.
    assert_relative_eq!(worst, 0.388_959_953_766_290_5, max_relative = 1e-9);
    assert_relative_eq!(worst / spring.nominal_force(), 0.0032, max_relative = 0.01);
}

#[test]
fn a_calibration_that_cannot_be_is_refused() {
    let says = |preload, lengths: &[f64], inductances: &[f64]| {
        Calibration::through(preload, lengths, inductances).unwrap_err().to_string()
    };
    assert_eq!(says((0.2, f64::INFINITY), &[0.2], &[1e-6]), "preload inductance must be finite, got inf H");
    assert_eq!(says((0.2, 1e-6), &[0.2], &[1e-6]), "spread of the inductances must be above zero, got 0 H");
    assert_eq!(says((0.2, 1e-6), &[0.0], &[1e-6]), "calibration length must be above zero and finite, got 0 m");
    assert_eq!(says((0.2, 1e-6), &[0.2, 0.3], &[1e-6]), "inductances must hold 2 values, got 1");
}
