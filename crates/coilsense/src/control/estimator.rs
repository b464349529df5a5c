//! What stands between a measured force and the controller: notches, or an estimate of the load-end force.
//!
//! Next door: the sampled loop that it stands in (`sampled`), its settings (`crate::mitigation`), its steps (`coilsense_rt`).

use coilsense_rt::{Cascade, Measured, ModalKalman, Mode};
use num_complex::Complex64;

/// What makes a force to feed back from F_i and the ends' positions.
#[derive(Debug, Clone, PartialEq)]
pub enum Estimator {
    /// F_i behind three biquads, such as notches at n f1.
    Cascade(Cascade<f64, 3>),
    /// F_o by a Kalman filter of three modes and a force bias, from F_i, u1 and u2.
    Kalman(Box<ModalKalman<f64, 3>>),
}

/// Its state over time.
#[derive(Debug, Clone)]
pub(super) enum Running<'a> {
    Cascade(&'a Cascade<f64, 3>, coilsense_rt::CascadeState<f64, 3>),
    Kalman(&'a ModalKalman<f64, 3>, coilsense_rt::KalmanState<f64, 3>),
}

impl Estimator {
    /// How it answers F_i \[1\] and y = −u1 \[N/m\], with end 2 held.
    ///
    /// Cascade: ΠH(z), 0. Kalman, D = z⁻¹, R_j = (1 − Φ_j D)⁻¹, J = −rate (1 − D)² y:
    /// e = (F_i − k y − Σ h_j (R_j Φ_j κ_j)_1 J) / (1 + D K_b/(1 − D) + Σ h_j ((R_j K_j)_1 − K_j1)), F_o = k y + K_b e/(1 − D) + Σ g_j ((R_j Φ_j κ_j)_1 J + (R_j K_j)_1 e)
    ///
    /// - `delay`: D = z⁻¹ = e^(−jωT)
    ///
    /// Source:   the steps of [`ModalKalman`] and [`coilsense_rt::Biquad`], transformed.
    /// Valid:    D ≠ 1; end 2 at rest.
    /// Accuracy: 1e-9 of its largest value, against the steps themselves (test).
    pub fn response(&self, delay: Complex64) -> [Complex64; 2] {
        match self {
            Self::Cascade(cascade) => {
                let one = |section: &coilsense_rt::Biquad<f64>| {
                    let above = section.b0 + delay * (section.b1 + delay * section.b2);
                    above / (1.0 + delay * (section.a1 + delay * section.a2))
                };
                [cascade.sections.iter().map(one).product(), Complex64::ZERO]
            }
            Self::Kalman(filter) => {
                // Linear in both inputs: one at a time.
                [
                    kalman(filter, delay, [Complex64::ONE, Complex64::ZERO]),
                    kalman(filter, delay, [Complex64::ZERO, Complex64::ONE]),
                ]
            }
        }
    }

    /// At rest on a force, end 2 `length` from end 1.
    pub(super) fn running(&self, force: f64, length: f64) -> Running<'_> {
        match self {
            Self::Cascade(cascade) => Running::Cascade(cascade, cascade.settled(force)),
            Self::Kalman(filter) => Running::Kalman(filter, filter.settled(&Measured { force, ends: [0.0, length] })),
        }
    }
}

impl Running<'_> {
    /// The force to feed back \[N\].
    pub fn step(&mut self, force: f64, ends: [f64; 2]) -> f64 {
        match self {
            Self::Cascade(cascade, state) => cascade.step(state, force),
            Self::Kalman(filter, state) => filter.step(state, &Measured { force, ends }).output,
        }
    }
}

fn kalman(filter: &ModalKalman<f64, 3>, delay: Complex64, [force, stroke]: [Complex64; 2]) -> Complex64 {
    let rest = 1.0 - delay;
    let jump = -filter.rate * rest * rest * stroke;
    let modes = filter.modes.map(|mode| answers(&mode, delay));
    let each = || filter.modes.iter().zip(&modes);
    let kicked: Complex64 = each().map(|(mode, [kick, _])| mode.input * kick * jump).sum();
    let fed: Complex64 = each().map(|(mode, [_, gain])| mode.input * (gain - mode.gain[0])).sum();
    let bias = filter.bias_gain / rest;
    let surprise = (force - filter.stiffness * stroke - kicked) / (1.0 + delay * bias + fed);
    let ringing: Complex64 = each().map(|(mode, [kick, gain])| mode.output * (kick * jump + gain * surprise)).sum();
    filter.stiffness * stroke + bias * surprise + ringing
}

/// First components of (1 − ΦD)⁻¹ Φ κ for end 1, and of (1 − ΦD)⁻¹ K.
fn answers(mode: &Mode<f64>, delay: Complex64) -> [Complex64; 2] {
    let [[a, b], [c, d]] = mode.turn;
    let determinant = (1.0 - a * delay) * (1.0 - d * delay) - b * c * delay * delay;
    let solved = |first: f64, second: f64| ((1.0 - d * delay) * first + b * delay * second) / determinant;
    [solved(b * mode.kick[0], d * mode.kick[0]), solved(mode.gain[0], mode.gain[1])]
}
