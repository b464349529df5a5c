//! How the spring rings: frequencies, shapes, how each end drives each mode and how each mode pulls at each end, in closed form.
//!
//! Next door: the roots for an end mass (`end_mass`), the continuous coil (`continuous`), the response over time (`motion`) and over frequency (`transmittance`).

mod continuous;
mod end_mass;
mod model;

use std::f64::consts::PI;

use crate::error::{Error, check};
use crate::mount::FarEnd;
use crate::spring::Spring;
pub(crate) use continuous::end_mass_root;
pub use continuous::{continuous_frequencies, third_rule_error, third_rule_frequency};
use end_mass::Angle;
pub(crate) use model::{LeftOut, SlowInertia, Tied, WireModes};
pub use model::{ModalModel, ModalParameters};

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

/// The modes of the paper's chain of N winding masses on its mount, lowest first.
///
/// φ_j(i) = sin(θ_j(i−½)), ω_j = 2 N √(k/m) sin(θ_j/2) with
/// θ_j = jπ/N (both positions prescribed), (j−½)π/N (force at end 2), or the roots of `N sin θ tan(Nθ) = m/M` (mass M at end 2,
/// N + 1 modes, the last above cut-off).
///
/// Modal coordinates q_j count from the straight line between the ends of a spring without mass under the same inputs w1 = u1 and
/// w2 = u2 (or the force at end 2), so that `q̈_j + ω_j² q_j = −(c1_j ẅ1 + c2_j ẅ2)`.
///
/// Source:   eigenvectors and eigenvalues of `[Weijde2017]` eqs. 5–6, a DST-II chain (`[Strang1999]`); end mass derived in this module.
/// Valid:    no damping, windings that never touch.
/// Accuracy: 4e-16 relative, against an eigen-solver in the tests (to the solver's 1e-12).
/// Differs:  eq. 3 of the paper is the limit N → ∞, 0.015 % above for S_T.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// let modes = coilsense::modes::ChainModes::of(&spring);
/// let mode1 = modes.frequencies()[0] / std::f64::consts::TAU;
/// assert!((mode1 - 54.057).abs() < 1e-3);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ChainModes {
    shapes: ChainShapes,
    /// Mass of end 2 in winding masses, MN/m; zero but for an end mass.
    relative_end_mass: f64,
    frequencies: Vec<f64>,
    norms: Vec<f64>,
    input_weights: Vec<f64>,
    output_weights: Vec<f64>,
    end_shapes: Vec<f64>,
    /// Projections of a rigid translation, and of the straight line from 0 at end 1 to 1 at end 2.
    rigid: Vec<f64>,
    second: Vec<f64>,
    /// c1_j, c2_j.
    participations: [Vec<f64>; 2],
}

/// How the masses move in each mode.
#[derive(Debug, Clone, PartialEq)]
struct ChainShapes {
    masses: usize,
    far_end: FarEnd,
    angles: Angles,
}

/// The angles of the modes, in the form that gives shapes without rounding where there is one.
#[derive(Debug, Clone, PartialEq)]
enum Angles {
    /// θ_j = (jπ − offset)/N as a whole number of steps of π/4N; sin of every step of a full turn.
    Steps(Vec<f64>),
    /// Roots of a characteristic equation.
    Roots(Vec<Angle>),
}

impl ChainModes {
    /// The modes of a spring's chain with both positions prescribed: the paper's.
    pub fn of(spring: &Spring) -> Self {
        Self::mounted(spring, FarEnd::Position)
    }

    /// The modes of a spring's chain with end 2 tied to `far_end`; an end mass counts as above zero.
    pub fn mounted(spring: &Spring, far_end: FarEnd) -> Self {
        let masses = spring.chain_masses();
        let relative_end_mass = match far_end {
            FarEnd::Mass(mass) => mass * masses as f64 / spring.mass(),
            _ => 0.0,
        };
        let angles = match far_end {
            FarEnd::Mass(mass) => Angles::Roots(end_mass::angles(masses, spring.mass() / mass)),
            _ => Angles::Steps(sine_steps(masses)),
        };
        let count = masses + usize::from(relative_end_mass > 0.0);
        let mut modes = Self {
            shapes: ChainShapes { masses, far_end, angles },
            relative_end_mass,
            frequencies: Vec::with_capacity(count),
            norms: Vec::with_capacity(count),
            input_weights: Vec::with_capacity(count),
            output_weights: Vec::with_capacity(count),
            end_shapes: Vec::with_capacity(count),
            rigid: Vec::with_capacity(count),
            second: Vec::with_capacity(count),
            participations: [Vec::with_capacity(count), Vec::with_capacity(count)],
        };
        for mode in 1..=count {
            modes.push(mode, spring.transit_time(), spring.stiffness());
        }
        modes
    }

    /// Finds all there is to know of one mode and appends it.
    fn push(&mut self, mode: usize, transit_time: f64, stiffness: f64) {
        let count = self.shapes.masses as f64;
        let root = match &self.shapes.angles {
            Angles::Steps(_) => None,
            Angles::Roots(roots) => Some(roots[mode - 1]),
        };
        let first = self.shape_at(mode, 1);
        // |2 sin(θ/2)| of the dispersion relation: the tension of a segment over the displacement of its ends.
        let half = match root {
            Some(Angle::AboveCutOff(phi)) => (0.5 * phi).cosh(),
            _ => first,
        };
        let norm = self.norm(mode, root);
        let (end, output) = self.end_two(mode, root);
        let second = match self.shapes.far_end {
            FarEnd::Position => 0.5 * end_sign(mode) / (norm * half),
            _ => end / (4.0 * count * half * half * norm),
        };
        let rigid = match self.shapes.far_end {
            FarEnd::Position => 0.5 * (1.0 + end_sign(mode)) / (norm * half),
            _ => 0.5 * first / (norm * half * half),
        };
        self.frequencies.push(2.0 * count / transit_time * half);
        self.norms.push(norm);
        self.input_weights.push(first);
        self.output_weights.push(output);
        self.end_shapes.push(end);
        self.rigid.push(rigid);
        self.second.push(second);
        // What u1 carries along: where end 2 is free to follow, all of the straight line.
        self.participations[0].push(if self.shapes.far_end == FarEnd::Position { rigid - second } else { rigid });
        self.participations[1].push(if self.shapes.far_end == FarEnd::Position { second } else { second / stiffness });
    }

    /// n_j = Σ_i φ_j(i)² + (MN/m) ψ_j².
    fn norm(&self, mode: usize, root: Option<Angle>) -> f64 {
        let count = self.shapes.masses as f64;
        match root {
            None if self.shapes.far_end == FarEnd::Position && mode == self.shapes.masses => count,
            None => 0.5 * count,
            Some(Angle::Wave { theta, sine, cosine }) => {
                let end = self.end_two(mode, root).0;
                0.5 * count - sine * cosine / (2.0 * theta.sin()) + self.relative_end_mass * end * end
            }
            Some(Angle::AboveCutOff(phi)) => {
                let end = self.end_two(mode, root).0;
                let cosh = (count * phi).min(350.0).cosh();
                0.5 * count / (cosh * cosh)
                    + (count * phi).tanh() / (2.0 * phi.sinh())
                    + self.relative_end_mass * end * end
            }
        }
    }

    /// ψ_j, how far end 2 moves in the mode, and its weight in F_o, both in units of the shape.
    fn end_two(&self, mode: usize, root: Option<Angle>) -> (f64, f64) {
        let count = self.shapes.masses as f64;
        let sign = if self.shapes.masses.is_multiple_of(2) { 1.0 } else { -1.0 };
        match root {
            None if self.shapes.far_end == FarEnd::Position => (0.0, -self.shape_at(mode, self.shapes.masses)),
            None => (self.shape_at(mode, self.shapes.masses), 0.0),
            Some(Angle::Wave { theta, sine, cosine }) => {
                let (half_sin, half_cos) = (0.5 * theta).sin_cos();
                (sine * half_cos, cosine * half_sin)
            }
            Some(Angle::AboveCutOff(phi)) => {
                (sign * (count * phi).tanh() * (0.5 * phi).sinh(), sign * (0.5 * phi).cosh())
            }
        }
    }

    /// The first `count` of these modes, or all where there are no more.
    #[must_use]
    pub fn first(&self, count: usize) -> Self {
        let mut modes = self.clone();
        let Self {
            frequencies, norms, input_weights, output_weights, end_shapes, rigid, second, participations, ..
        } = &mut modes;
        let series = [frequencies, norms, input_weights, output_weights, end_shapes, rigid, second];
        series.into_iter().chain(participations).for_each(|series| series.truncate(count));
        modes
    }

    /// How many modes there are: N, and N + 1 with an end mass.
    pub fn count(&self) -> usize {
        self.frequencies.len()
    }

    /// N: how many winding masses there are.
    pub fn masses(&self) -> usize {
        self.shapes.masses
    }

    /// What end 2 is tied to.
    pub fn far_end(&self) -> FarEnd {
        self.shapes.far_end
    }

    /// ω_j \[rad/s\], shape `count`, mode 1 first.
    pub fn frequencies(&self) -> &[f64] {
        &self.frequencies
    }

    /// φ_j(i), shape of mode `mode` (1…count) at winding `winding` (1…N) \[1\].
    ///
    /// # Errors
    /// [`Error::Value`] where the mode or the winding is not there.
    pub fn shape(&self, mode: usize, winding: usize) -> Result<f64, Error> {
        for (quantity, number, last) in [("mode", mode, self.count()), ("winding", winding, self.masses())] {
            let holds = (1..=last).contains(&number);
            check(holds, quantity, number as f64, "", format!("from 1 to {last}"))?;
        }
        Ok(self.shape_at(mode, winding))
    }

    /// ψ_j: how far end 2 moves in each mode, in units of its shape; zero where its position is prescribed. Shape `count`.
    pub fn end_shapes(&self) -> &[f64] {
        &self.end_shapes
    }

    /// As [`Self::shape`], numbers trusted.
    pub(crate) fn shape_at(&self, mode: usize, winding: usize) -> f64 {
        self.shapes.at(mode, winding)
    }

    /// Weight of each mode in F_i: `F_i = F_static + 2Nk Σ_j a_j q_j`; shape `count`.
    pub(crate) fn input_weights(&self) -> &[f64] {
        &self.input_weights
    }

    /// Weight of each mode in F_o; shape `count`. Where end 2's position is prescribed it is `−σ_j a_j`.
    pub(crate) fn output_weights(&self) -> &[f64] {
        &self.output_weights
    }

    /// c1_j \[1\] and c2_j (\[1\], or \[m/N\] for a force at end 2): how strongly each input drives each mode; shape `count` each.
    pub(crate) fn participations(&self) -> [&[f64]; 2] {
        [&self.participations[0], &self.participations[1]]
    }
}

impl ChainShapes {
    /// φ_j(i); numbers are trusted.
    fn at(&self, mode: usize, winding: usize) -> f64 {
        let place = winding as f64 - 0.5;
        match &self.angles {
            Angles::Steps(sines) => {
                // θ_j (i−½) in steps of π/4N: 2j (2i−1) or (2j−1)(2i−1).
                let multiple = 2 * mode as u64 - u64::from(self.far_end == FarEnd::Force);
                let step = multiple * (2 * winding as u64 - 1) % (8 * self.masses as u64);
                sines[step as usize]
            }
            Angles::Roots(roots) => match roots[mode - 1] {
                Angle::Wave { theta, .. } => (theta * place).sin(),
                Angle::AboveCutOff(phi) => {
                    let (near, far) = (phi * place, phi * self.masses as f64);
                    let size = ((near - far).exp() + (-near - far).exp()) / (1.0 + (-2.0 * far).exp());
                    if winding.is_multiple_of(2) { -size } else { size }
                }
            },
        }
    }
}

/// σ_j = (−1)^(j+1): +1 where mode j looks the same from both held ends (odd j), −1 where it is mirrored.
pub(crate) fn end_sign(mode: usize) -> f64 {
    if mode % 2 == 1 { 1.0 } else { -1.0 }
}

/// sin(kπ/4N) for k = 0…8N−1, each from an angle of at most π/4 so that symmetric entries are equal to the bit.
fn sine_steps(masses: usize) -> Vec<f64> {
    let quarter_turn = 2 * masses;
    let step = |k: usize| PI * k as f64 / (4 * masses) as f64;
    let quarter: Vec<f64> =
        (0..=quarter_turn).map(|k| if k <= masses { step(k).sin() } else { step(quarter_turn - k).cos() }).collect();
    (0..4 * quarter_turn)
        .map(|k| match k / quarter_turn {
            0 => quarter[k],
            1 => quarter[2 * quarter_turn - k],
            2 => -quarter[k - 2 * quarter_turn],
            _ => -quarter[4 * quarter_turn - k],
        })
        .collect()
}
