//! How the spring rings with both ends held: frequencies, shapes and how each end drives each mode, in closed form.
//!
//! Next door: the response over time (`motion`) and over frequency (`transmittance`).

use std::f64::consts::PI;

use crate::error::{Error, check};
use crate::spring::Spring;

/// Surge frequency of mode `mode` of the continuous coil with both ends held \[rad/s\].
///
/// ω_j = j π √(k/m) = j π / τ
///
/// - `transit_time`: τ \[s\], above zero; `mode`: j, at least 1
///
/// Source:   `[Weijde2017]` eq. 3.
/// Valid:    a uniform undamped coil; the limit N → ∞ of [`ChainModes`].
/// Accuracy: 3e-16 relative.
///
/// ```
/// let tau = (0.065_f64 / 760.0).sqrt();
/// let hertz = coilsense::modes::continuous_frequency(tau, 1) / std::f64::consts::TAU;
/// assert!((hertz - 54.065).abs() < 1e-3);
/// ```
pub fn continuous_frequency(transit_time: f64, mode: usize) -> f64 {
    mode as f64 * PI / transit_time
}

/// The modes of the paper's chain of N winding masses with both ends held, j = 1…N.
///
/// φ_j(i) = sin(jπ(i−½)/N), ω_j = 2 N √(k/m) sin(jπ/2N)
///
/// Source:   eigenvectors and eigenvalues of `[Weijde2017]` eqs. 5–6, a DST-II chain (`[Strang1999]`).
/// Valid:    no damping, windings that never touch.
/// Accuracy: 4e-16 relative, against an eigen-solver in the tests (to the solver's 1e-13).
/// Differs:  eq. 3 of the paper is the limit N → ∞, 0.015 % above for S_T.
///
/// ```
/// # let spring = coilsense::Spring::new(coilsense::SpringParameters { rest_length: 0.104, windings: 52.0,
/// #     coil_radius: 0.008, wire_radius: 0.001, mass: 0.065, stiffness: 760.0, min_length: 0.196,
/// #     max_length: 0.264, nominal_force: None, inductance_windings: None })?;
/// let modes = coilsense::modes::ChainModes::of(&spring);
/// let mode1 = modes.frequencies()[0] / std::f64::consts::TAU;
/// assert!((mode1 - 54.057).abs() < 1e-3);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ChainModes {
    masses: usize,
    frequencies: Vec<f64>,
    end_shapes: Vec<f64>,
    participations: Vec<f64>,
    /// sin(kπ/2N) for k = 0…4N−1: every shape is one of these.
    sines: Vec<f64>,
}

impl ChainModes {
    /// The modes of a spring's chain.
    pub fn of(spring: &Spring) -> Self {
        Self::new(spring.chain_masses(), spring.transit_time())
    }

    fn new(masses: usize, transit_time: f64) -> Self {
        let sines = sine_table(masses);
        let end_shapes: Vec<f64> = (1..=masses).map(|j| sines[j]).collect();
        let scale = 2.0 * masses as f64 / transit_time;
        Self {
            masses,
            frequencies: end_shapes.iter().map(|shape| scale * shape).collect(),
            participations: end_shapes
                .iter()
                .enumerate()
                .map(|(index, shape)| 0.5 / (norm(masses, index + 1) * shape))
                .collect(),
            end_shapes,
            sines,
        }
    }

    /// N: how many masses, and so modes, there are.
    pub fn count(&self) -> usize {
        self.masses
    }

    /// ω_j \[rad/s\], shape `N`, mode 1 first.
    pub fn frequencies(&self) -> &[f64] {
        &self.frequencies
    }

    /// φ_j(i), shape of mode `mode` (1…N) at winding `winding` (1…N) \[1\].
    ///
    /// # Errors
    /// [`Error::Value`] where the mode or the winding is outside of 1…N.
    pub fn shape(&self, mode: usize, winding: usize) -> Result<f64, Error> {
        for (quantity, number) in [("mode", mode), ("winding", winding)] {
            let holds = (1..=self.masses).contains(&number);
            check(holds, quantity, number as f64, "", format!("from 1 to {}", self.masses))?;
        }
        Ok(self.shape_at(mode, winding))
    }

    /// As [`Self::shape`], numbers trusted.
    pub(crate) fn shape_at(&self, mode: usize, winding: usize) -> f64 {
        self.sines[(mode * (2 * winding - 1)) % (4 * self.masses)]
    }

    /// |φ_j| at the first and last winding, sin(jπ/2N); shape `N`. At winding N the sign is [`end_sign`].
    pub(crate) fn end_shapes(&self) -> &[f64] {
        &self.end_shapes
    }

    /// c_j = 1 / (2 n_j sin(jπ/2N)): how strongly a straight line of ends (a, b) projects on mode j, as `c_j (a + σ_j b)`; shape `N`.
    pub(crate) fn participations(&self) -> &[f64] {
        &self.participations
    }

    /// Modal coordinates of a winding pattern: (1/n_j) Σ_i φ_j(i) v_i; shape `N` to shape `N`.
    pub(crate) fn project(&self, pattern: &[f64]) -> Vec<f64> {
        (1..=self.masses)
            .map(|mode| {
                let sum: f64 = pattern
                    .iter()
                    .enumerate()
                    .map(|(index, value)| self.shape_at(mode, index + 1) * value)
                    .sum();
                sum / norm(self.masses, mode)
            })
            .collect()
    }
}

/// σ_j = (−1)^(j+1): +1 where mode j looks the same from both ends (odd j), −1 where it is mirrored.
pub(crate) fn end_sign(mode: usize) -> f64 {
    if mode % 2 == 1 { 1.0 } else { -1.0 }
}

/// n_j = Σ_i φ_j(i)²: N/2, and N for the last mode.
fn norm(masses: usize, mode: usize) -> f64 {
    if mode == masses {
        masses as f64
    } else {
        0.5 * masses as f64
    }
}

/// sin(kπ/2N) for k = 0…4N−1, each from an angle of at most π/4 so that symmetric entries are equal to the bit.
fn sine_table(masses: usize) -> Vec<f64> {
    let quarter: Vec<f64> = (0..=masses)
        .map(|k| {
            if 2 * k <= masses {
                (PI * k as f64 / (2 * masses) as f64).sin()
            } else {
                (PI * (masses - k) as f64 / (2 * masses) as f64).cos()
            }
        })
        .collect();
    (0..4 * masses)
        .map(|k| match k / masses {
            0 => quarter[k],
            1 => quarter[2 * masses - k],
            2 => -quarter[k - 2 * masses],
            _ => -quarter[4 * masses - k],
        })
        .collect()
}
