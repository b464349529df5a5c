//! Windings that meet: a valve spring under its cam of 6 and of 48 masses, S_A at its first resonance, and what asking costs where nothing meets.
//!
//! Next door: what is timed how (`measure`), MuJoCo on the same chains (`bench/python/mujoco_contact.py`).

use std::path::Path as File;

use coilsense::contact::{Chain, Contact, Course, Drive, Path, Start as State, Touching, follow};
use coilsense::measures::Clash;
use coilsense::signals::sampled_window;
use coilsense::{Damping, EndInput, Error, Excitation, FarEnd, Motion, Spring, SpringParameters, Start, paper};

use crate::Failure;
use crate::measure::{Measurement, alternately, measure};

/// Samples a second that are timed, as of every job.
const TIMED: f64 = 10_000.0;
/// Samples a second of a run that is judged, as of the reference's mean squares.
const JUDGED: f64 = 50_000.0;

/// Each measurement with its job.
pub fn rows() -> Result<Vec<(&'static str, Measurement)>, Failure> {
    let (reference, of_s_a) = (mean_square("valve", 0.1)?, mean_square("S_A", 0.6)?);
    let (few, course) = measure(|| valve(6, 1, TIMED));
    course?;
    let few_off = off(&valve(6, 1, JUDGED)?, 0, [0.1, 0.12], reference);
    let (neighbours, course) = measure(|| valve(48, 1, TIMED));
    course?;
    let (turns, course) = measure(|| valve(6, 8, TIMED));
    course?;
    let motion = s_a(40e-6)?;
    let touching = |rate: f64| Touching::once(&motion, &Contact::default(), &sampled_window(rate, 0.0, 1.0)?, false);
    let (once, timed) = measure(|| touching(TIMED));
    timed?;
    let course = touching(JUDGED)?.course.ok_or("S_A's windings stay clear")?;
    // The course begins where windings first come near.
    let from = JUDGED as usize + 1 - course.output.len();
    let s_a_off = off(&course, from, [0.6, 0.75], of_s_a);
    let mut rows = vec![
        ("valve", Measurement::new("0.3 s, 6 masses", few, few_off)),
        ("valve-48", Measurement::timed("0.3 s, 48 masses, neighbours", neighbours)),
        ("valve-48", Measurement::timed("0.3 s, 48 masses, a turn apart", turns)),
        ("contact", Measurement::new("S_A, 1 s, one run", once, s_a_off)),
    ];
    rows.extend(asked()?.map(|measurement| ("contact-clear", measurement)));
    Ok(rows)
}

/// A motion whose windings a bound keeps apart, without contact and with it, turn by turn.
fn asked() -> Result<[Measurement; 2], Failure> {
    let motion = s_a(1e-6)?;
    if !Clash::excluded(&motion, 1.0, motion.spring().wire_diameter()) {
        return Err("the bound says nothing of S_A".into());
    }
    let times = sampled_window(TIMED, 0.0, 1.0)?;
    let contact = Contact::default();
    let [without, with] = alternately(|which| match which {
        0 => motion.signals(&times),
        _ => Touching::of(&motion, &contact, &times, false).map(|touching| touching.signals),
    })?;
    Ok([Measurement::timed("S_A, 1 s, not asked", without), Measurement::timed("S_A, 1 s, asked", with)])
}

fn s_a(amplitude: f64) -> Result<Motion, Error> {
    let spring = paper::s_a();
    let input = EndInput::harmonic(amplitude, spring.surge_frequency(), -std::f64::consts::FRAC_PI_2);
    Motion::new(&spring, &Excitation::new(0.102, input, EndInput::Held, Start::Massless)?)
}

/// 29028 N/m, 44.549 g, 57 mm long, about 48 mm, solid at 31 mm, from rest under its cam.
fn valve(windings: usize, masses_per_winding: usize, rate: f64) -> Result<Course, Error> {
    let spring = Spring::new(SpringParameters {
        rest_length: 0.057,
        windings: windings as f64,
        coil_radius: 0.0125,
        // Thin enough for 48 windings; contact is at the pitch of the solid length.
        wire_radius: 0.3e-3,
        mass: 44.549e-3,
        stiffness: 29028.0,
        min_length: 0.035,
        max_length: 0.05,
        nominal_force: None,
        inductance_windings: None,
        sections: None,
    })?
    .with_masses_per_winding(masses_per_winding)?;
    let chain = Chain::of(&spring, FarEnd::Position, 0.031 / windings as f64, false)?;
    let (masses, stretch) = (chain.lumps(), 0.048 - spring.rest_length());
    let places = (0..masses).map(|mass| stretch * (mass as f64 + 0.5) / masses as f64).collect();
    let start = State { time: 0.0, places, speeds: vec![0.0; masses] };
    let drives = [cam()?, Drive::Input(EndInput::Held, stretch)];
    follow(&chain, &Contact::default(), &Damping::None, drives, &start, &sampled_window(rate, 0.0, 0.3)?)
}

/// 10 mm · 64 s³(1 − s)³ over 130° of a turn in 20 ms, from a quarter of a turn on.
fn cam() -> Result<Drive, Error> {
    let lift: f64 = 130.0 / 360.0 * 0.02;
    let law = [0.0, 0.0, 0.0, 1.0, -3.0, 3.0, -1.0].iter().zip(0..);
    let law: Vec<f64> = law.map(|(part, power)| 0.01 * 64.0 * part / lift.powi(power)).collect();
    let turns = (0..15).map(|turn| (f64::from(turn) + 0.25) * 0.02);
    let knots = turns.flat_map(|begin| [begin, begin + lift]).collect();
    let mut pieces: Vec<Vec<f64>> = (0..15).flat_map(|_| [law.clone(), vec![0.0]]).collect();
    pieces.pop();
    Ok(Drive::Path(Path::new(knots, pieces)?))
}

/// How far RMS(F_o − F_i) over a window \[s\] is from another's, relative; the course's first sample is number `first`.
fn off(course: &Course, first: usize, window: [f64; 2], reference: f64) -> f64 {
    let [from, to] = window.map(|time| (time * JUDGED).round() as usize - first);
    let forces = course.input[from..to].iter().zip(&course.output[from..to]);
    let squares: f64 = forces.map(|(input, output)| (output - input).powi(2)).sum();
    ((squares / (to - from) as f64).sqrt() / reference - 1.0).abs()
}

/// RMS(F_o − F_i) \[N\] by small steps of 0.1 µs, without restitution, over the window that begins at `from` \[s\].
fn mean_square(spring: &str, from: f64) -> Result<f64, Failure> {
    let path = File::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/contact_steps_rms.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path)?;
    for row in reader.records() {
        let row = row?;
        if &row[0] == spring && &row[1] == "0.0" && &row[2] == "0.1" && row[3].parse::<f64>()? == from {
            return Ok(row[7].parse()?);
        }
    }
    Err(format!("no window of {spring} from {from} s on").into())
}
