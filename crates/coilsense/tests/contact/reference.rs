//! Reference figures: S_A at its first resonance and a valve spring under its cam, each found by two schemes that share no code with this.

use coilsense::contact::{Chain, Contact, Course, Drive, Path, Start, follow};
use coilsense::excitation::Harmonic;
use coilsense::modes::continuous_frequency;
use coilsense::{Damping, EndInput, paper};

/// S_A about 102 mm, 40 µm at the first resonance of eq. (3), from a massless start: 1.9 mm above its unloaded length.
pub fn s_a(contact: &Contact, seconds: f64, rate: f64) -> Course {
    let spring = paper::s_a();
    let lumps = spring.whole_windings();
    let stretch = 0.102 - spring.rest_length();
    let frequency = continuous_frequency(spring.transit_time(), 1) / std::f64::consts::TAU;
    let input =
        EndInput::Harmonics(vec![Harmonic { amplitude: 40e-6, frequency, phase: -std::f64::consts::FRAC_PI_2 }]);
    let chain = Chain::of(&spring, coilsense::FarEnd::Position, spring.wire_diameter(), false).unwrap();
    let (u1, v1) = (input.displacement(0.0), input.velocity(0.0));
    let line = |share: f64| u1 + share * (stretch - u1);
    let places: Vec<f64> = (0..lumps).map(|lump| line((lump as f64 + 0.5) / lumps as f64)).collect();
    let speeds: Vec<f64> = (0..lumps).map(|lump| v1 * (1.0 - (lump as f64 + 0.5) / lumps as f64)).collect();
    let drives = [Drive::Input(input, 0.0), Drive::Input(EndInput::Held, stretch)];
    let times: Vec<f64> = (0..=(seconds * rate).round() as usize).map(|sample| sample as f64 / rate).collect();
    let start = Start { time: 0.0, places, speeds };
    follow(&chain, contact, &Damping::None, drives, &start, &times).unwrap()
}

/// A valve spring of six lumps, k = 29028 N/m, m = 44.549 g, about 48 mm, solid at 31 mm, under a cam of 10 mm and 130° at 50 Hz.
pub fn valve(contact: &Contact, lumps: usize, seconds: f64, rate: f64) -> Course {
    let (k, m) = (29028.0, 44.549e-3);
    let count = lumps as f64;
    let mut stiffnesses = vec![count * k; lumps + 1];
    (stiffnesses[0], stiffnesses[lumps]) = (2.0 * count * k, 2.0 * count * k);
    let gap = (0.048 - 0.031) / count;
    let mut gaps = vec![gap; lumps + 1];
    (gaps[0], gaps[lumps]) = (f64::INFINITY, f64::INFINITY);
    let chain = Chain::new(vec![m / count; lumps], stiffnesses, gaps).unwrap();
    let drives = [cam(seconds), Drive::Input(EndInput::Held, 0.0)];
    let times: Vec<f64> = (0..=(seconds * rate).round() as usize).map(|sample| sample as f64 / rate).collect();
    let start = Start { time: 0.0, places: vec![0.0; lumps], speeds: vec![0.0; lumps] };
    follow(&chain, contact, &Damping::None, drives, &start, &times).unwrap()
}

/// 10 mm · 64 x³(1 − x)³ while the cam lifts, over 130° of a turn in 20 ms.
fn cam(seconds: f64) -> Drive {
    let lift: f64 = 130.0 / 360.0 * 0.02;
    let cam: Vec<f64> = [0.0, 0.0, 0.0, 1.0, -3.0, 3.0, -1.0].iter().map(|c| 0.01 * 64.0 * c).collect();
    let cam: Vec<f64> = cam.iter().zip(0..).map(|(c, power)| c / lift.powi(power)).collect();
    let (mut knots, mut pieces) = (Vec::new(), Vec::new());
    for turn in 0..(seconds / 0.02).ceil() as usize {
        let begin = (turn as f64 + 0.25) * 0.02;
        knots.extend([begin, begin + lift]);
        pieces.extend([cam.clone(), vec![0.0]]);
    }
    pieces.pop();
    Drive::Path(Path::new(knots, pieces).unwrap())
}

fn at(values: &[f64], rate: f64, time: f64) -> f64 {
    values[(time * rate).round() as usize]
}

fn rms(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + value * value, count + 1.0));
    (sum / count).sqrt()
}

#[test]
fn s_a_touches_where_and_when_two_other_schemes_say() {
    let course = s_a(&Contact::default(), 1.0, 10_000.0);
    let expected = [
        (0.529_332_790_9, 1, 0.096_971),
        (0.532_252_658, 24, 0.138_554),
        (0.532_353_538, 24, 0.037_236),
        (0.535_172_500, 1, 0.214_309),
        (0.535_264_156, 1, 0.046_657),
        (0.538_111_057, 24, 0.252_665),
        (0.538_143_507, 24, 0.008_087),
        (0.538_223_556, 23, 0.099_306),
    ];
    assert!((course.touches[0].time - expected[0].0).abs() < 1e-10);
    for (touch, (time, segment, closing_speed)) in course.touches.iter().zip(expected) {
        assert!((touch.time - time).abs() < 1e-9 && touch.points[0] == segment, "{touch:?}");
        assert!((touch.closing_speed - closing_speed).abs() < 1e-6, "{touch:?}");
    }
    let forces = [
        (0.53, 25.3323, 357.9524, 1e-3),
        (0.54, 148.9881, 233.6546, 1e-3),
        (0.55, 396.0102, -39.3308, 1e-3),
        (0.56, 61.6941, 315.5825, 1e-3),
        (0.6, 64.713, 380.842, 2e-3),
    ];
    for (time, input, output, within) in forces {
        assert!((at(&course.input, 1e4, time) - input).abs() < within, "F_i at {time}");
        assert!((at(&course.output, 1e4, time) - output).abs() < within, "F_o at {time}");
    }
    let windows = [((5500, 6000), [248.8, 243.2, 307.9]), ((6000, 7500), [251.6, 255.4, 317.0])];
    for ((from, to), expected) in windows {
        let (input, output) = (&course.input[from..to], &course.output[from..to]);
        let found = [
            rms(input.iter().copied()),
            rms(output.iter().copied()),
            rms(output.iter().zip(input).map(|(output, input)| output - input)),
        ];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 3e-3, "{found} for {expected}");
        }
    }
    assert!(course.given_up.is_none());
    assert!(course.balance.open().abs() < 1e-10 * course.balance.moved, "{:?}", course.balance);
}

#[test]
fn s_a_on_windings_that_give_way_does_what_two_other_schemes_say() {
    let stiffness = 100.0 * 25.0 * paper::s_a().stiffness();
    let course = s_a(&Contact::elastic(stiffness, 0.0).unwrap(), 0.56, 10_000.0);
    let closings =
        [0.529_332_790_9, 0.532_248_446_9, 0.532_428_013_1, 0.535_162_511_5, 0.535_266_486_5, 0.535_330_361_1];
    for (touch, time) in course.touches.iter().zip(closings) {
        assert!((touch.time - time).abs() < 1e-9, "{touch:?} {time}");
    }
    let forces = [
        (0.53, 26.051_771_59, 357.952_442_57),
        (0.54, 147.495_705, 232.262_892),
        (0.55, 396.186_203, -33.796_395),
        (0.56, 69.019_67, 310.687_76),
    ];
    for (time, input, output) in forces {
        assert!((at(&course.input, 1e4, time) - input).abs() < 1e-4, "F_i at {time}");
        assert!((at(&course.output, 1e4, time) - output).abs() < 1e-4, "F_o at {time}");
    }
    assert!(course.balance.open().abs() < 1e-10 * course.balance.moved, "{:?}", course.balance);
}

/// The spring is 9 mm shorter than unloaded in the middle of its use; the chain of these tests counts from there.
pub const PRELOAD: f64 = 29028.0 * 0.009;

#[test]
fn the_valve_spring_does_what_two_other_schemes_say() {
    let course = valve(&Contact::default(), 6, 0.3, 10_000.0);
    let first = course.touches[0];
    assert!((first.time - 0.067_901_349_80).abs() < 1e-10 && first.points == [5, 6], "{first:?}");
    assert!((first.closing_speed - 1.805_575).abs() < 1e-6);
    let forces = [
        (0.09, -352.0632, -526.4264),
        (0.12, -126.2098, -360.4168),
        (0.2, 155.526, -707.469),
        (0.25, -135.929, -781.180),
        (0.3, 88.489, -673.306),
    ];
    for (time, input, output) in forces {
        assert!((at(&course.input, 1e4, time) - PRELOAD - input).abs() < 1e-3, "F_i at {time}");
        assert!((at(&course.output, 1e4, time) - PRELOAD - output).abs() < 1e-3, "F_o at {time}");
    }
    assert!((course.balance.lost - 3.19283).abs() < 1e-5 && (course.balance.work - 4.37103).abs() < 1e-5);
}

#[test]
fn what_windings_give_back_changes_the_valve_springs_force_as_another_scheme_says() {
    for (restitution, expected) in [(0.0, 545.5), (0.2, 522.55), (0.5, 502.24)] {
        let course = valve(&Contact::hard(restitution).unwrap(), 6, 0.3, 100_000.0);
        let apart = course.output.iter().zip(&course.input).map(|(output, input)| output - input);
        let found = rms(apart.skip(24_000));
        assert!((found / expected - 1.0).abs() < 3e-3, "{restitution}: {found} for {expected}");
        assert!(course.balance.open().abs() < 1e-10 * course.balance.moved);
    }
}

#[test]
fn stiff_windings_with_much_loss_become_hard_ones() {
    let hard = valve(&Contact::default(), 6, 0.12, 100_000.0);
    let apart = |stiffness: f64, damping_ratio: f64| {
        let contact = Contact::elastic(stiffness * 6.0 * 29028.0, damping_ratio).unwrap();
        let soft = valve(&contact, 6, 0.12, 100_000.0);
        assert!(soft.balance.open().abs() < 1e-10 * soft.balance.moved, "{:?}", soft.balance);
        rms(soft.output.iter().zip(&hard.output).skip(8000).map(|(soft, hard)| soft - hard))
    };
    // The other scheme has 3.88, 0.63 and 0.67 N.
    let [soft, stiff, stiffest] = [1e2, 1e3, 1e4].map(|stiffness| apart(stiffness, 3.0));
    assert!(
        (soft - 3.88).abs() < 0.3 && (stiff - 0.63).abs() < 0.1 && (stiffest - 0.67).abs() < 0.1,
        "{soft} {stiff} {stiffest}"
    );
}

#[test]
fn more_masses_lead_to_one_answer() {
    let of = |course: &Course| {
        rms(course.output.iter().zip(&course.input).map(|(output, input)| output - input).skip(10_000))
    };
    // Each segment meets by itself.
    for (lumps, expected) in [(6, 560.9), (12, 476.5), (24, 439.0), (48, 425.9), (96, 423.5)] {
        let found = of(&valve(&Contact::default(), lumps, 0.12, 100_000.0));
        assert!((found / expected - 1.0).abs() < 1e-3, "{lumps}: {found} for {expected}");
    }
    // A point meets the one a turn further on.
    for (masses, expected) in [(2, 481.8), (4, 444.0), (8, 426.7)] {
        let spring = super::laws::spring(masses);
        let lumps = 6 * masses;
        let chain = Chain::of(&spring, coilsense::FarEnd::Position, super::laws::PITCH, false).unwrap();
        let times: Vec<f64> = (0..=12_000).map(|sample| f64::from(sample) * 1e-5).collect();
        let places = (0..lumps).map(|lump| -0.009 * (lump as f64 + 0.5) / lumps as f64).collect();
        let start = Start { time: 0.0, places, speeds: vec![0.0; lumps] };
        let drives = [cam(0.12), Drive::Input(EndInput::Held, -0.009)];
        let course = follow(&chain, &Contact::default(), &Damping::None, drives, &start, &times).unwrap();
        let found = of(&course);
        assert!((found / expected - 1.0).abs() < 1e-3, "{masses}: {found} for {expected}");
        assert!(course.balance.open().abs() < 1e-10 * course.balance.moved);
    }
}
