//! How near neighbouring windings can come over a motion, bounded without evaluating it: from what each mode can swing at most.
//!
//! Next door: the motion itself (the parent), whether windings touch (`crate::measures::Clash`).

use num_complex::Complex64;

use super::Motion;
use super::oscillator::{Oscillator, Roots};
use crate::excitation::{EndInput, Sine};
use crate::mount::FarEnd;

/// What is allowed for rounding, relative: sums of some hundred positive terms lose far less.
const ROUNDING: f64 = 1e-12;

impl Motion {
    /// A distance \[m\] below which no two neighbouring windings come, centre to centre, for 0 ≤ t ≤ `until`; minus infinity where none
    /// can be stated, as of a coil that is not evenly wound, infinity for a single winding.
    ///
    /// p ≥ min(û2 − u1)/N − Σ_j Q_j min(ω_jτ/N, 2); Q_j bounds |q_j| over the time, and over one turn, n masses,
    /// |φ_j(i+n) − φ_j(i)| ≤ 2n sin(θ_j/2) = ω_jτ/N, and never more than 2
    ///
    /// Q_j sums what start, jumps and sines give: √(q² + (q̇/ω)²) of the start; |c| (|Δu| + |Δu̇|/ω) of a jump (of a step `q = −c Δu ġ`,
    /// g the answer to a unit impulse, |ġ| ≤ 1 whatever the damping); of a sine from rest
    /// `|c a| Ω²/2ω_d Σ min(T, 2/|λ − iΩ|)` over λ = −ζω ± iω_d, T the time that it acts, and √2 as much once it has ended.
    ///
    /// - `until`: \[s\], not below zero
    ///
    /// Source:   Duhamel's integral of each mode's equation ([`Motion`]); the energy of a mode without input does not grow.
    /// Valid:    any input, mount and damping; at a resonance without damping it falls linearly with `until`, under a chirp with its duration.
    /// Accuracy: a bound. Within 0.1 mm of the closest pitch of S_T over 1 s in the paper's five conditions without damping (test).
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// let motion = coilsense::Motion::new(&spring, &coilsense::Excitation::impact(0.23, 0.25)?)?;
    /// let least = motion.least_pitch(1.0);
    /// assert!(least > spring.wire_diameter() && least < 0.23 / 52.0);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn least_pitch(&self, until: f64) -> f64 {
        let turns = self.spring.whole_windings();
        if turns < 2 {
            return f64::INFINITY;
        }
        if !self.modes.is_evenly_wound() {
            return f64::NEG_INFINITY;
        }
        let apart = self.modes.masses() / turns;
        let pushes = self.inputs().map(|input| Push::of(input, until));
        let mut swings = 0.0;
        for (mode, (&natural, &ratio)) in self.modes.frequencies().iter().zip(&self.ratios).enumerate() {
            let oscillator = Oscillator { natural, ratio };
            let mut swing = self.start.coordinates[mode].hypot(self.start.rates[mode] / natural);
            for (push, participations) in pushes.iter().zip(self.modes.participations()) {
                swing += participations[mode].abs() * push.swing(&oscillator, until);
            }
            swings += swing * self.modes.most_between(mode + 1, apart, self.spring.transit_time());
        }
        let pitch = self.shortest_line() * self.modes.least_between(apart) - swings * (1.0 + ROUNDING);
        let least = pitch - ROUNDING * self.excitation.mean_length();
        if least.is_nan() { f64::NEG_INFINITY } else { least }
    }

    /// The straight line's shortest length \[m\], each input at its own worst moment.
    fn shortest_line(&self) -> f64 {
        let [first, second] = self.inputs().map(EndInput::reach);
        let mean = self.excitation.mean_length();
        match self.mount.far_end() {
            FarEnd::Position => mean - first - second,
            _ => mean - second / self.spring.stiffness(),
        }
    }
}

/// What an input can do to a mode.
struct Push {
    /// Sums over its jumps: |Δu| \[m\] and |Δu̇| \[m/s\], a chirp's acceleration all added up among the latter.
    jumps: [f64; 2],
    sines: Vec<Sine>,
}

impl Push {
    fn of(input: &EndInput, until: f64) -> Self {
        let mut jumps = [0.0, input.chirp_impulse()];
        for kick in input.kicks().into_iter().filter(|kick| kick.time <= until) {
            jumps[0] += kick.displacement.abs();
            jumps[1] += kick.velocity.abs();
        }
        Self { jumps, sines: input.sines().collect() }
    }

    /// The largest |q| of a mode at rest with a participation of one.
    fn swing(&self, oscillator: &Oscillator, until: f64) -> f64 {
        let sines: f64 = self.sines.iter().map(|sine| under_sine(sine, oscillator, until)).sum();
        self.jumps[0] + self.jumps[1] / oscillator.natural + sines
    }
}

/// The same under one sine, up to a time.
fn under_sine(sine: &Sine, oscillator: &Oscillator, until: f64) -> f64 {
    let (natural, drive) = (oscillator.natural, sine.angular);
    let lasts = (until.min(sine.until) - sine.since).max(0.0);
    let acceleration = sine.amplitude.abs() * drive * drive;
    // Energy grows by the force at most.
    let pushed = lasts / natural;
    let swing = match oscillator.roots() {
        Roots::Pair(root) => {
            // Not `norm`, whose care for overflow takes time; squares of frequencies are far from it.
            let apart = |root: Complex64| (root - Complex64::new(0.0, drive)).norm_sqr().sqrt();
            let parts = [root, root.conj()].map(|root| lasts.min(2.0 / apart(root)));
            // Of q and of q̇/ω each; both together where the sine has ended and the mode swings on.
            let on = if sine.until < until { std::f64::consts::SQRT_2 } else { 1.0 };
            on * (parts[0] + parts[1]) / (2.0 * root.im)
        }
        // The steady answer and the free motion that makes it begin from rest.
        Roots::Real(..) => 2.0 * oscillator.steady_gain(drive).norm() * (drive / natural).max(1.0),
    };
    acceleration * pushed.min(swing)
}
