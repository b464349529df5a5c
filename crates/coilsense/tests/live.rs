//! A spring whose inputs come one by one: its state taken and given back, clones, and rest at any ends.

mod paper_springs;

use coilsense::motion::{ForceSample, Live};
use coilsense::{Damping, FarEnd, Mount, Spring};
use paper_springs::s_t;

const STEP: f64 = 1.7e-4;
const LENGTH: f64 = 0.23;

fn mounts() -> Vec<Mount> {
    let dampings = [
        Damping::None,
        Damping::Modal(0.005),
        Damping::Modal(1.0),
        Damping::MassProportional { rate: 40.0 },
        Damping::StiffnessProportional { time: 4e-5 },
    ];
    let far_ends = [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.1)];
    let each = far_ends.into_iter().flat_map(|far_end| dampings.clone().map(|damping| (far_end, damping)));
    each.map(|(far_end, damping)| Mount::new(far_end, damping).unwrap()).collect()
}

fn made(spring: &Spring, mount: &Mount) -> Live {
    Live::new(spring, mount, LENGTH, STEP).unwrap()
}

/// Ends that move, about those at rest.
fn ends(live: &Live, step: u32) -> [f64; 2] {
    let t = f64::from(step) * STEP;
    let height = if live.mount().far_end() == FarEnd::Position { 2e-3 } else { 1.5 };
    let [first, second] = live.mean_ends();
    [first + 1e-3 * (190.0 * t).sin(), second + height * (310.0 * t + 0.3).cos()]
}

fn go(live: &mut Live, steps: std::ops::Range<u32>) -> Vec<ForceSample> {
    steps.map(|step| live.advance_to(ends(live, step)).unwrap()).collect()
}

#[test]
fn a_state_given_back_goes_on_with_the_same_bits() {
    let spring = s_t();
    for mount in mounts() {
        let mut live = made(&spring, &mount);
        go(&mut live, 0..40);
        let saved = live.state();
        assert_eq!(saved.len(), live.state_count());
        let once = go(&mut live, 40..90);
        live.set_state(&saved).unwrap();
        assert_eq!(live.state(), saved);
        assert_eq!(go(&mut live, 40..90), once, "{mount:?}");
        // In a spring that never moved as well.
        let mut other = made(&spring, &mount);
        other.set_state(&saved).unwrap();
        assert_eq!(go(&mut other, 40..90), once, "{mount:?}");
        assert_eq!(other.time(), 90.0 * STEP);
    }
}

#[test]
fn a_clone_goes_on_by_itself() {
    let spring = s_t();
    for mount in mounts() {
        let mut live = made(&spring, &mount);
        let mut fresh = live.clone();
        let from_rest = go(&mut live, 0..30);
        assert_eq!(go(&mut fresh, 0..30), from_rest);
        let mut clone = live.clone();
        let once = go(&mut live, 30..60);
        assert_eq!(go(&mut clone, 30..60), once);
    }
}

#[test]
fn back_at_rest_it_is_a_new_spring() {
    let spring = s_t();
    for mount in mounts() {
        let mut live = made(&spring, &mount);
        let once = go(&mut live, 0..30);
        live.reset(live.mean_ends()).unwrap();
        assert_eq!(live.time(), 0.0);
        assert_eq!(go(&mut live, 0..30), once);
    }
}

#[test]
fn at_rest_it_pulls_with_its_static_force_and_stays() {
    let spring = s_t();
    for mount in mounts() {
        let mut live = made(&spring, &mount);
        go(&mut live, 0..30);
        let held = mount.far_end() == FarEnd::Position;
        let force = spring.static_force(0.241);
        // 1 cm aside and 11 mm longer, or under the force that makes it so long.
        let rest = [0.01, if held { 0.251 } else { force }];
        live.reset(rest).unwrap();
        for _ in 0..50 {
            let felt = live.advance_to(rest).unwrap();
            // 100 N, and 2Nk of 8e4 N/m times the rounding of a length.
            assert!((felt.input - force).abs() < 1e-10 && (felt.output - force).abs() < 1e-10, "{felt:?}");
        }
        // From there it moves as one that was made there: the spring is linear.
        let mut there = Live::new(&spring, &mount, 0.241, STEP).unwrap();
        live.reset(rest).unwrap();
        for step in 0..200 {
            let [first, second] = ends(&there, step);
            let ours = live.advance_to([first + 0.01, if held { second + 0.01 } else { second }]).unwrap();
            let theirs = there.advance_to([first, second]).unwrap();
            // Ends that differ by a rounding of 0.25 m in a step of 0.17 ms.
            assert!((ours.input - theirs.input).abs() < 1e-9 && (ours.output - theirs.output).abs() < 1e-9);
        }
    }
}

#[test]
fn what_is_no_state_is_refused_by_name_and_changes_nothing() {
    let spring = s_t();
    let mut live = made(&spring, &Mount::default());
    go(&mut live, 0..20);
    let saved = live.state();
    let last = saved.len() - 1;
    let with = |place: usize, value: f64| {
        let mut state = saved.clone();
        state[place] = value;
        state
    };
    let steps = "a whole number of steps taken, not below zero";
    for (state, told) in [
        (saved[..last].to_vec(), "state must hold 109 values, got 108".to_owned()),
        (Vec::new(), "state must hold 109 values, got 0".to_owned()),
        (with(3, f64::NAN), "state[3] must be finite, got NaN".to_owned()),
        (with(106, f64::INFINITY), "state[106] must be finite, got inf".to_owned()),
        // Time does not run backwards, and not by half steps.
        (with(last, -1.0), format!("state[108] must be {steps}, got -1")),
        (with(last, 0.5), format!("state[108] must be {steps}, got 0.5")),
        (with(last, f64::NAN), format!("state[108] must be {steps}, got NaN")),
        (with(105, -0.23 - 1e-3), "u2 - u1 of the state, the spring's length, must be above zero".to_owned()),
    ] {
        let error = live.set_state(&state).unwrap_err().to_string();
        assert!(error.starts_with(&told), "{error}");
        assert_eq!(live.state(), saved);
    }
    for ([first, second], told) in [
        ([f64::NAN, 0.23], "u1 must be finite, got NaN m"),
        ([0.0, f64::INFINITY], "u2 must be finite, got inf m"),
        ([0.3, 0.23], "u2 - u1, the spring's length, must be above zero"),
    ] {
        let error = live.reset([first, second]).unwrap_err().to_string();
        assert!(error.starts_with(told), "{error}");
        assert_eq!(live.state(), saved);
    }
}
