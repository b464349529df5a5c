//! What a plant is made of: a spring's modes and what they pull with, as the host finds them, and how k, m and ζ change them.
//!
//! Next door: a step of it (`plant`), where the modes come from (`coilsense::plant`).

use crate::elementary::square_root;
use crate::oscillator::ModeStep;
use crate::plant::{Plant, Turn};
use crate::real::Real;

/// What end 2 of a plant is tied to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FarEnd {
    /// A prescribed position: input 2 is u2 \[m\].
    Position,
    /// A prescribed force: input 2 is that force \[N\].
    Force,
    /// A mass under a prescribed force: input 2 is that force \[N\].
    Mass,
}

/// One mode of the spring, with k, m and ζ as they were found.
///
/// q̈ + 2ζ_jω q̇ + ω² q = −(c_1 ẅ_1 + c_2 ẅ_2), w the inputs
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlantMode {
    /// ω \[rad/s\].
    pub frequency: f64,
    /// ζ_j over ζ of the plant \[1\].
    pub damping: f64,
    /// c_1 \[1\] and c_2 \[1, or m/N for a force\].
    pub participations: [f64; 2],
    /// F_i and F_o per q \[N/m\].
    pub weights: [f64; 2],
    /// How far end 2 moves per q \[1\]; zero where its position is prescribed.
    pub end: f64,
}

/// A spring on its mount in `MODES` modes: plain numbers that the host finds and that do not move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlantSettings<const MODES: usize> {
    /// k \[N/m\].
    pub stiffness: f64,
    /// m \[kg\].
    pub mass: f64,
    /// ζ of the first mode that is damped \[1\]; zero where none is.
    pub damping_ratio: f64,
    /// ω of the mode of that ζ \[rad/s\].
    pub damped_frequency: f64,
    /// Whether damping is that of dashpots beside every segment, which pull at the ends, too.
    pub dashpots: bool,
    /// How much the mean length is beyond the rest length \[m\].
    pub stretch: f64,
    /// What end 2 is tied to.
    pub far_end: FarEnd,
    /// Lowest first; after those that are kept, those that stand for all others.
    pub modes: [PlantMode; MODES],
}

/// What a plant cannot be started with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refused {
    /// k must be above zero and finite.
    Stiffness,
    /// m must be above zero and finite; with an end mass, to which the modes belong, it must be the spring's.
    Mass,
    /// ζ must be from zero on and no mode's above 1000.
    DampingRatio,
    /// h must be above zero, and ωh of no mode above 10⁹.
    Step,
}

/// A damping ratio beyond which a mode creeps a thousand times slower than it would swing.
const LARGEST_RATIO: f64 = 1e3;
/// An angle of a step beyond which a double number has no digits for where in its turn a mode is.
const LARGEST_ANGLE: f64 = 1e9;

impl<const MODES: usize> PlantSettings<MODES> {
    /// The plant in steps of h, with the spring's own k, m and ζ.
    ///
    /// # Errors
    /// As [`Self::changed`].
    pub fn plant<T: Real>(&self, step: f64) -> Result<Plant<T, MODES>, Refused> {
        self.changed(self.stiffness, self.mass, self.damping_ratio, step)
    }

    /// The plant in steps of h, with another k, m and ζ.
    ///
    /// ω ∝ √(k/m), all forces ∝ k; ζ_j ∝ ζ
    ///
    /// - `stiffness`: k \[N/m\]; `mass`: m \[kg\]; `damping_ratio`: ζ \[1\] of the first mode that is damped, of all modes where none was
    /// - `step`: h \[s\]
    ///
    /// Source:   similarity of chains of equal N; with an end mass M as long as m/M stays.
    /// Valid:    any step size.
    /// Accuracy: that of [`Plant::step`].
    ///
    /// # Errors
    /// [`Refused`] with the first number that cannot be.
    pub fn changed<T: Real>(
        &self,
        stiffness: f64,
        mass: f64,
        damping_ratio: f64,
        step: f64,
    ) -> Result<Plant<T, MODES>, Refused> {
        let sound = |value: f64| value > 0.0 && value < f64::INFINITY;
        if !sound(stiffness) {
            return Err(Refused::Stiffness);
        }
        if !sound(mass) || (self.far_end == FarEnd::Mass && mass != self.mass) {
            return Err(Refused::Mass);
        }
        if damping_ratio.is_nan() || damping_ratio < 0.0 {
            return Err(Refused::DampingRatio);
        }
        if !sound(step) {
            return Err(Refused::Step);
        }
        let harder = stiffness / self.stiffness;
        let faster = square_root(harder / (mass / self.mass));
        let dashpot = if self.dashpots { 2.0 * damping_ratio / (self.damped_frequency * faster) } else { 0.0 };
        let softer = if self.far_end == FarEnd::Position { 1.0 } else { 1.0 / harder };
        let mut modes = [Turn::STILL; MODES];
        for (mode, made) in self.modes.iter().zip(&mut modes) {
            *made = mode.turn(step, [harder, faster, softer], damping_ratio, dashpot)?;
        }
        Ok(Plant {
            stiffness: T::nearest(stiffness),
            compliance: T::nearest(1.0 / stiffness),
            preload: T::nearest(stiffness * self.stretch),
            far_end: self.far_end,
            has_dashpots: dashpot > 0.0,
            modes,
        })
    }
}

impl PlantMode {
    /// What a step does to it.
    fn turn<T: Real>(
        &self,
        step: f64,
        [harder, faster, softer]: [f64; 3],
        damping_ratio: f64,
        dashpot: f64,
    ) -> Result<Turn<T>, Refused> {
        let (frequency, ratio) = (self.frequency * faster, self.damping * damping_ratio);
        let angle = frequency * step;
        if ratio.is_nan() || ratio > LARGEST_RATIO {
            return Err(Refused::DampingRatio);
        }
        if !(angle > 0.0 && angle <= LARGEST_ANGLE) {
            return Err(Refused::Step);
        }
        let moves = ModeStep::new(angle, ratio);
        let [first, second] = self.participations;
        let [input, output] = self.weights;
        let (input, output, swing) = (input * harder, output * harder, dashpot * frequency);
        Ok(Turn {
            quarters: moves.quarters.map(T::nearest),
            dragged: T::nearest(1.0 - moves.quarters[0]),
            rest: moves.rest.map(T::nearest),
            mend: mend::<T>(&moves, ratio * angle),
            line: [T::nearest(first / angle), T::nearest(second * softer / angle)],
            weights: [T::nearest(input), T::nearest(output)],
            rates: [T::nearest(input * swing), T::nearest(output * swing)],
            end: T::nearest(self.end),
        })
    }
}

/// What makes up for the rounding of a mode's coefficients after [`Real::STEPS_TO_MEND`] steps: that many times M⁻¹ (M − M'), M' the rounded
/// step. The two turn about the same centre and nearly commute; a mode that dies sooner forgets what rounding does to it.
fn mend<T: Real>(moves: &ModeStep, decay: f64) -> [[T; 2]; 2] {
    let mut mend = [[T::ZERO; 2]; 2];
    if T::STEPS_TO_MEND == 0 || decay > 1.0 / 64.0 {
        return mend;
    }
    let [[m11, m12], [_, m22]] = moves.matrix();
    let [a, b, d] = moves.rest.map(T::leftover);
    let scale = f64::from(T::STEPS_TO_MEND) / (m11 * m22 + m12 * m12);
    mend[0] = [T::nearest(scale * (m22 * a + m12 * b)), T::nearest(scale * (m22 * b - m12 * d))];
    mend[1] = [T::nearest(scale * (m12 * a - m11 * b)), T::nearest(scale * (m12 * b + m11 * d))];
    mend
}
