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
    let input = EndInput::Harmonics(vec![Harmonic { amplitude: 40e-6, frequency, phase: -std::f64::consts::FRAC_PI_2 }]);
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
    // 10 mm · 64 x³(1 − x)³ while the cam lifts, once in 20 ms.
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
    let drives = [Drive::Path(Path::new(knots, pieces).unwrap()), Drive::Input(EndInput::Held, 0.0)];
    let times: Vec<f64> = (0..=(seconds * rate).round() as usize).map(|sample| sample as f64 / rate).collect();
    let start = Start { time: 0.0, places: vec![0.0; lumps], speeds: vec![0.0; lumps] };
    follow(&chain, contact, &Damping::None, drives, &start, &times).unwrap()
}

fn at(values: &[f64], rate: f64, time: f64) -> f64 {
    values[(time * rate).round() as usize]
}

fn rms(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + value * value, count + 1.0));
    (sum / count as f64).sqrt()
}

#[test]
fn s_a_touches_where_and_when_two_other_schemes_say() {
    let course = s_a(&Contact::default(), 1.0, 10_000.0);
    for touch in course.touches.iter().skip(30).filter(|t| t.time > 9.5965).take(40) { println!("{touch:?}"); }
    println!("{} events {} touches {:?} {:e}", course.events, course.touches.len(), course.balance, course.balance.open());
    for time in [0.53, 0.54, 0.55, 0.56, 0.6] { println!("{time} {} {}", at(&course.input, 1e4, time), at(&course.output, 1e4, time)); }
}

#[test]
fn the_valve_spring_does_what_two_other_schemes_say() {
    let course = valve(&Contact::default(), 6, 0.3, 10_000.0);
    for touch in course.touches.iter().take(4) { println!("{touch:?}"); }
    println!("{} events {} touches {:?} {:e}", course.events, course.touches.len(), course.balance, course.balance.open());
    for time in [0.09, 0.12, 0.2, 0.25, 0.3] { println!("{time} {} {}", at(&course.input, 1e4, time), at(&course.output, 1e4, time)); }
}
