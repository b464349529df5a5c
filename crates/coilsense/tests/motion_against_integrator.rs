//! The exact motion against an independent integration of eq. (6): DOP853 of the crate `differential-equations`.
//!
//! | ours | theirs |
//! |---|---|
//! | `Motion::end_forces` | eqs. 4–7 written out, `ExplicitRungeKutta::dop853`, forces from the integrated positions |

mod paper_springs;

use coilsense::{EndInput, Excitation, Motion, Spring, Start};
use differential_equations::prelude::*;

/// Eqs. (4)–(6) of the paper as they stand.
struct Chain<'a> {
    spring: &'a Spring,
    excitation: &'a Excitation,
}

impl Chain<'_> {
    fn ends(&self, t: f64) -> [f64; 2] {
        use coilsense::End::{One, Two};
        let input = |end| self.excitation.input(end).displacement(t);
        [input(One), self.excitation.mean_length() + input(Two)]
    }

    /// Tensions of the N + 1 segments \[N\].
    fn tensions(&self, t: f64, x: &[f64]) -> Vec<f64> {
        let n = x.len() as f64;
        let [u1, u2] = self.ends(t);
        let (k, rest) = (n * self.spring.stiffness(), self.spring.rest_length() / n);
        let mut tensions = vec![2.0 * k * (x[0] - u1 - 0.5 * rest)];
        tensions.extend(x.windows(2).map(|pair| k * (pair[1] - pair[0] - rest)));
        tensions.push(2.0 * k * (u2 - x[x.len() - 1] - 0.5 * rest));
        tensions
    }
}

impl ODE<f64, Vec<f64>> for Chain<'_> {
    fn diff(&self, t: f64, y: &Vec<f64>, rate: &mut Vec<f64>) {
        let n = y.len() / 2;
        let mass = self.spring.mass() / n as f64;
        let tensions = self.tensions(t, &y[..n]);
        for i in 0..n {
            rate[i] = y[n + i];
            rate[n + i] = (tensions[i + 1] - tensions[i]) / mass;
        }
    }
}

/// Largest difference of either end force over its peak, between ours and DOP853 at a tolerance, over 0.1 s.
fn difference(spring: &Spring, excitation: &Excitation, start: (Vec<f64>, Vec<f64>), rtol: f64) -> f64 {
    let chain = Chain { spring, excitation };
    let (positions, velocities) = start;
    let n = positions.len();
    let state: Vec<f64> = positions.into_iter().chain(velocities).collect();
    let times: Vec<f64> = (0..=100).map(|k| f64::from(k) * 1e-3).collect();
    let method = ExplicitRungeKutta::dop853().rtol(rtol).atol(rtol * 1e-3).max_steps(1_000_000);
    let solution = IVP::ode(&chain, 0.0, 0.1, state)
        .t_eval(times.clone())
        .method(method)
        .solve()
        .expect("the integrator finishes");
    let motion = Motion::new(spring, excitation).expect("valid excitation");
    let ours = motion.end_forces(&times).expect("valid times");
    let (mut worst, mut peak, mut seen) = (0.0_f64, 0.0_f64, 0);
    for (sample, (t, y)) in solution.iter().enumerate() {
        assert_eq!(*t, times[sample]);
        let tensions = chain.tensions(*t, &y[..n]);
        for (theirs, ours) in [(tensions[0], ours.input[sample]), (tensions[n], ours.output[sample])] {
            worst = worst.max((theirs - ours).abs());
            peak = peak.max(theirs.abs());
            seen += 1;
        }
    }
    assert_eq!(seen, 2 * times.len());
    worst / peak
}

/// Positions uniform between two ends, and velocities linear between two values.
fn straight(n: usize, ends: [f64; 2], velocities: [f64; 2]) -> (Vec<f64>, Vec<f64>) {
    let line = |[a, b]: [f64; 2]| (0..n).map(|i| a + (b - a) * (i as f64 + 0.5) / n as f64).collect();
    (line(ends), line(velocities))
}

/// The tighter the integrator, the nearer it comes to ours. Its global error goes as tolerance^(7/8) (order 8 steps, order 7 output
/// between them), a factor 420 for three decades; 30 leaves room for its step control. What remains at 1e-12 is the integrator's.
fn converges(spring: &Spring, excitation: &Excitation, start: (Vec<f64>, Vec<f64>)) {
    let [loose, middle, tight] = [1e-6, 1e-9, 1e-12].map(|rtol| difference(spring, excitation, start.clone(), rtol));
    let shown = format!("{loose:e} {middle:e} {tight:e}");
    assert!(loose > 30.0 * middle && middle > 30.0 * tight, "no convergence: {shown}");
    assert!(tight < 1e-8, "{shown}");
}

#[test]
fn an_impact_agrees_with_the_integrator() {
    for spring in [paper_springs::s_t(), paper_springs::s_a()] {
        let length = spring.mid_length();
        let excitation = Excitation::impact(length, 0.25).unwrap();
        converges(&spring, &excitation, straight(spring.chain_masses(), [0.0, length], [0.25, 0.25]));
    }
}

#[test]
fn a_resonant_drive_on_end_1_agrees_with_the_integrator() {
    let spring = paper_springs::s_t();
    let length = spring.mid_length();
    let (amplitude, frequency) = (68e-6, spring.surge_frequency());
    let input = EndInput::harmonic(amplitude, frequency, 0.3);
    let excitation = Excitation::new(length, input, EndInput::Held, Start::Rest).unwrap();
    converges(&spring, &excitation, straight(spring.chain_masses(), [0.0, length], [0.0, 0.0]));
}

#[test]
fn both_ends_driven_from_a_massless_start_agree_with_the_integrator() {
    let spring = paper_springs::s_a();
    let length = spring.mid_length();
    let one = EndInput::harmonic(1e-4, 31.0, 0.4);
    let two = EndInput::harmonic(-2e-4, 340.0, 2.0);
    let excitation = Excitation::new(length, one.clone(), two.clone(), Start::Massless).unwrap();
    let ends = [one.displacement(0.0), length + two.displacement(0.0)];
    let velocities = [one.velocity(0.0), two.velocity(0.0)];
    converges(&spring, &excitation, straight(spring.chain_masses(), ends, velocities));
}

#[test]
fn windings_started_one_by_one_agree_with_the_integrator() {
    let spring = paper_springs::s_t();
    let length = 0.25;
    let n = spring.chain_masses();
    let (mut positions, mut velocities) = straight(n, [0.0, length], [0.0, 0.0]);
    for i in 0..n {
        positions[i] += 3e-4 * (3.1 * i as f64).sin();
        velocities[i] = 0.2 * (1.7 * i as f64).cos();
    }
    let start = Start::Windings { positions: positions.clone(), velocities: velocities.clone() };
    let excitation = Excitation::new(length, EndInput::Held, EndInput::Held, start).unwrap();
    converges(&spring, &excitation, (positions, velocities));
}
