//! Mounts, damping and inputs against an independent integration: DOP853 of the crate `differential-equations`.
//!
//! | ours | theirs |
//! |---|---|
//! | `Motion` with an end mass or a force at end 2 | eqs. 4–6 with `M ü2 = −F_o + F`, or with F on the last winding |
//! | mass- and stiffness-proportional damping | dashpots written out winding by winding |
//! | steps, ramps, half sines, chirps, recordings | the inputs themselves, integrated from corner to corner |

mod paper_springs;

use coilsense::excitation::Sampled;
use coilsense::{Damping, EndInput, Excitation, FarEnd, Motion, Mount, Spring, Start, VelocityProfile};
use differential_equations::prelude::*;

/// The chain with everything that a mount may bring, winding by winding.
struct Chain<'a> {
    spring: &'a Spring,
    mount: &'a Mount,
    excitation: &'a Excitation,
    /// End of the present piece: a stage that falls on its corner must still see the value and the slope before it.
    until: f64,
}

/// Tensions of the N + 1 segments, and what their dashpots add \[N\].
struct Tensions {
    elastic: Vec<f64>,
    dashpot: Vec<f64>,
}

impl Chain<'_> {
    fn inputs(&self, t: f64) -> [(f64, f64); 2] {
        use coilsense::End::{One, Two};
        [One, Two].map(|end| {
            let input = self.excitation.input(end);
            (input.displacement(t.min(self.until)), input.velocity(t.min(self.until)))
        })
    }

    fn end_mass(&self) -> Option<f64> {
        match self.mount.far_end() {
            FarEnd::Mass(mass) => Some(mass),
            _ => None,
        }
    }

    /// The straight line from which damping counts velocities: speeds of its ends \[m/s\].
    fn line_velocity(&self, t: f64) -> [f64; 2] {
        let [first, second] = self.inputs(t);
        match self.mount.far_end() {
            FarEnd::Position => [first.1, second.1],
            _ => [first.1, first.1 + second.1 / self.spring.stiffness()],
        }
    }

    /// State: N positions and, with an end mass, its own; then as many velocities.
    fn tensions(&self, t: f64, y: &[f64]) -> Tensions {
        let n = self.spring.chain_masses();
        let half = y.len() / 2;
        let (x, v) = (&y[..n], &y[half..half + n]);
        let k = n as f64 * self.spring.stiffness();
        let rest = self.spring.rest_length() / n as f64;
        let [first, second] = self.inputs(t);
        let mean = self.excitation.mean_length();
        let line = self.line_velocity(t);
        let relative: Vec<f64> =
            (0..n).map(|i| v[i] - line[0] - (line[1] - line[0]) * (i as f64 + 0.5) / n as f64).collect();
        let moving_end = self.end_mass().map_or(0.0, |_| y[half + n] - line[1]);
        let mut elastic = vec![2.0 * k * (x[0] - first.0 - 0.5 * rest)];
        elastic.extend((1..n).map(|i| k * (x[i] - x[i - 1] - rest)));
        elastic.push(match self.mount.far_end() {
            FarEnd::Position => 2.0 * k * (mean + second.0 - x[n - 1] - 0.5 * rest),
            FarEnd::Force => self.spring.static_force(mean) + second.0,
            FarEnd::Mass(_) => 2.0 * k * (y[n] - x[n - 1] - 0.5 * rest),
        });
        Tensions { elastic, dashpot: self.dashpots(&relative, moving_end) }
    }

    /// What the dashpots pull with \[N\] where windings, and an end mass, move relative to the line \[m/s\]; or, where they are moved by so much
    /// at once \[m\], their impulses \[N s\].
    fn dashpots(&self, relative: &[f64], end: f64) -> Vec<f64> {
        let beta = match self.mount.damping() {
            Damping::StiffnessProportional { time } => *time,
            _ => 0.0,
        };
        let n = relative.len();
        let pull = beta * n as f64 * self.spring.stiffness();
        let mut dashpots = vec![2.0 * pull * relative[0]];
        dashpots.extend(relative.windows(2).map(|pair| pull * (pair[1] - pair[0])));
        dashpots.push(if self.mount.far_end() == FarEnd::Force { 0.0 } else { 2.0 * pull * (end - relative[n - 1]) });
        dashpots
    }

    /// α of mass-proportional damping \[1/s\].
    fn alpha(&self) -> f64 {
        match self.mount.damping() {
            Damping::MassProportional { rate } => *rate,
            _ => 0.0,
        }
    }

    /// The line jumps at a time and moves all masses back relative to it: what damps them meets an impulse, by which their velocities jump.
    fn jump(&self, t: f64, state: &mut [f64]) {
        use coilsense::End::{One, Two};
        let [first, second] = [One, Two].map(|end| match self.excitation.input(end) {
            EndInput::Step { height, at } if *at == t => *height,
            _ => 0.0,
        });
        let last = match self.mount.far_end() {
            FarEnd::Position => second,
            _ => first + second / self.spring.stiffness(),
        };
        let (n, half) = (self.spring.chain_masses(), state.len() / 2);
        let relative: Vec<f64> = (0..n).map(|i| -first - (last - first) * (i as f64 + 0.5) / n as f64).collect();
        let moving_end = self.end_mass().map_or(0.0, |_| -last);
        let impulses = self.dashpots(&relative, moving_end);
        let mass = self.spring.mass() / n as f64;
        for i in 0..n {
            state[half + i] += (impulses[i + 1] - impulses[i]) / mass - self.alpha() * relative[i];
        }
        if let Some(end) = self.end_mass() {
            state[half + n] += -impulses[n] / end - self.alpha() * moving_end;
        }
    }
}

impl ODE<f64, Vec<f64>> for Chain<'_> {
    fn diff(&self, t: f64, y: &Vec<f64>, rate: &mut Vec<f64>) {
        let n = self.spring.chain_masses();
        let half = y.len() / 2;
        let mass = self.spring.mass() / n as f64;
        let Tensions { elastic, dashpot } = self.tensions(t, y);
        let line = self.line_velocity(t);
        let alpha = self.alpha();
        for i in 0..n {
            let relative = y[half + i] - line[0] - (line[1] - line[0]) * (i as f64 + 0.5) / n as f64;
            let force = elastic[i + 1] + dashpot[i + 1] - elastic[i] - dashpot[i];
            rate[i] = y[half + i];
            rate[half + i] = force / mass - alpha * relative;
        }
        if let Some(end) = self.end_mass() {
            let pull = self.spring.static_force(self.excitation.mean_length()) + self.inputs(t)[1].0;
            rate[n] = y[half + n];
            rate[half + n] = (pull - elastic[n] - dashpot[n]) / end - alpha * (y[half + n] - line[1]);
        }
    }
}

/// The start that the excitation describes, by hand.
fn start(spring: &Spring, mount: &Mount, excitation: &Excitation) -> Vec<f64> {
    let n = spring.chain_masses();
    let chain = Chain { spring, mount, excitation, until: f64::INFINITY };
    let mean = excitation.mean_length();
    let mut places: Vec<f64> = (0..n).map(|i| (i as f64 + 0.5) / n as f64).collect();
    if chain.end_mass().is_some() {
        places.push(1.0);
    }
    let [first, second] = chain.inputs(0.0);
    let line = chain.line_velocity(0.0);
    let end = match mount.far_end() {
        FarEnd::Position => second.0,
        _ => first.0 + second.0 / spring.stiffness(),
    };
    let position = |s: &f64| match excitation.start() {
        Start::Massless => first.0 + s * (mean + end - first.0),
        _ => s * mean,
    };
    let velocity = |s: &f64| match excitation.start() {
        Start::Massless => line[0] + s * (line[1] - line[0]),
        Start::Moving { velocity, profile: VelocityProfile::Uniform } => *velocity,
        Start::Moving { velocity, profile: VelocityProfile::Linear } => velocity * s,
        _ => 0.0,
    };
    places.iter().map(position).chain(places.iter().map(velocity)).collect()
}

/// Largest difference of either end force over its peak. The integrator is stopped and restarted at each corner of the inputs.
fn difference(spring: &Spring, mount: &Mount, excitation: &Excitation, corners: &[f64]) -> f64 {
    let motion = Motion::mounted(spring, mount, excitation).unwrap();
    let mut state = start(spring, mount, excitation);
    let n = spring.chain_masses();
    let (mut worst, mut peak) = (0.0_f64, 0.0_f64);
    for piece in corners.windows(2) {
        let chain = Chain { spring, mount, excitation, until: piece[1] * (1.0 - 1e-14) };
        chain.jump(piece[0], &mut state);
        let times: Vec<f64> = (1..8).map(|k| piece[0] + (piece[1] - piece[0]) * f64::from(k) / 8.0).collect();
        let method = ExplicitRungeKutta::dop853().rtol(1e-12).atol(1e-15).max_steps(10_000_000);
        let mut output = times.clone();
        output.push(piece[1] - 1e-15 * piece[1]);
        let solution =
            IVP::ode(&chain, piece[0], piece[1], state).t_eval(output).method(method).solve().expect("integrated");
        let forces = motion.end_forces(&times).unwrap();
        for (sample, (t, y)) in solution.iter().take(times.len()).enumerate() {
            let Tensions { elastic, dashpot } = chain.tensions(*t, y);
            let ours = [forces.input[sample], forces.output[sample]];
            for (ours, end) in ours.into_iter().zip([0, n]) {
                let theirs = elastic[end] + dashpot[end];
                worst = worst.max((ours - theirs).abs());
                peak = peak.max(theirs.abs());
            }
        }
        state = solution.last().expect("a last state").1.clone();
    }
    worst / peak
}

fn mounts() -> Vec<Mount> {
    let ends = [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.02), FarEnd::Mass(5.0)];
    let dampings = [
        Damping::None,
        Damping::MassProportional { rate: 40.0 },
        Damping::StiffnessProportional { time: 2e-5 },
        Damping::StiffnessProportional { time: 3e-4 },
    ];
    let both = ends.into_iter().flat_map(|end| dampings.clone().map(|damping| Mount::new(end, damping).unwrap()));
    both.collect()
}

#[test]
fn moving_starts_under_moving_ends_agree_on_every_mount() {
    let spring = paper_springs::s_a();
    let first = EndInput::harmonic(3e-4, 90.0, 0.4);
    for mount in mounts() {
        let scale = if mount.far_end() == FarEnd::Position { 1.0 } else { spring.stiffness() };
        let second = EndInput::harmonic(-2e-4 * scale, 170.0, 1.1);
        for start in [
            Start::Moving { velocity: 0.2, profile: VelocityProfile::Uniform },
            Start::Moving { velocity: -0.2, profile: VelocityProfile::Linear },
            Start::Rest,
            Start::Massless,
        ] {
            let excitation = Excitation::new(0.1, first.clone(), second.clone(), start).unwrap();
            let off = difference(&spring, &mount, &excitation, &[0.0, 0.02]);
            // DOP853 at 1e-12 reaches 1e-9 here (its output between steps is of lower order).
            assert!(off < 1e-8, "{off:e} {mount:?} {:?}", excitation.start());
        }
    }
}

#[test]
fn inputs_with_corners_agree_on_every_mount() {
    let spring = paper_springs::s_t();
    let (times, values) = (vec![0.001, 0.004, 0.0055, 0.012], vec![0.0, 1e-3, -5e-4, 2e-4]);
    let inputs: [(EndInput, &[f64]); 5] = [
        (EndInput::Step { height: 1e-3, at: 0.005 }, &[0.0, 0.005, 0.02]),
        (EndInput::Ramp { height: 1e-3, from: 0.003, duration: 0.006 }, &[0.0, 0.003, 0.009, 0.02]),
        (EndInput::HalfSine { height: 1e-3, from: 0.003, duration: 0.007 }, &[0.0, 0.003, 0.01, 0.02]),
        (EndInput::Chirp { amplitude: 1e-3, from: 10.0, to: 300.0, duration: 0.015, phase: 0.3 }, &[0.0, 0.015, 0.02]),
        (EndInput::Sampled(Sampled::new(times, values).unwrap()), &[0.0, 0.001, 0.004, 0.0055, 0.012, 0.02]),
    ];
    for mount in mounts() {
        for (input, corners) in &inputs {
            let excitation = Excitation::new(0.23, input.clone(), EndInput::Held, Start::Rest).unwrap();
            let off = difference(&spring, &mount, &excitation, corners);
            // As above, and a step excites the highest modes as much as the lowest.
            assert!(off < 5e-8, "{off:e} {mount:?} {input:?}");
        }
    }
}

#[test]
fn steps_at_either_end_agree_on_every_mount() {
    let spring = paper_springs::s_t();
    for mount in mounts() {
        let scale = if mount.far_end() == FarEnd::Position { 1.0 } else { spring.stiffness() };
        // At the start and later, one end against the other.
        for [early, late] in [[0.0, 0.004], [0.004, 0.0], [0.003, 0.003]] {
            let first = EndInput::Step { height: 1e-3, at: early };
            let second = EndInput::Step { height: -6e-4 * scale, at: late };
            let excitation = Excitation::new(0.23, first, second, Start::Rest).unwrap();
            let corners = if early == late { vec![0.0, 0.003, 0.02] } else { vec![0.0, 0.004, 0.02] };
            let off = difference(&spring, &mount, &excitation, &corners);
            assert!(off < 5e-8, "{off:e} {mount:?} {early} {late}");
        }
    }
}
