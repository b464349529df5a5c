//! What is done to the spring: how its ends move and how its windings start. The conditions of use of the paper's section III-B, and any like them.
//!
//! Next door: one end's drive (`input`, `sampled`), what the spring does then (`motion`).

mod derivatives;
mod event;
mod input;
mod sampled;

pub(crate) use event::{Kick, Sine};
pub use input::{Content, EndInput, Harmonic};
pub use sampled::Sampled;

use crate::error::{Error, above_zero, all_bounded, called, check, count, finite};
use crate::spring::Spring;

/// One of the two ends of the spring.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// End 1: position u1, force F_i.
    One,
    /// End 2: position u2, force F_o; positions grow from end 1 to end 2.
    Two,
}

/// Where the windings are, and how fast, at t = 0; a step there comes right after, but for a massless start.
#[derive(Debug, Clone, PartialEq)]
pub enum Start {
    /// Uniform for the mean length, velocity zero, wherever the ends are.
    Rest,
    /// As a spring without mass: uniform between the ends' positions, velocities linear between the ends' velocities; after a step at t = 0.
    Massless,
    /// As the sines of both ends have left it after a long time: the motion repeats from the first period on. Ends held or driven by sines
    /// only; without damping, the answer that a vanishing damping would leave.
    Steady,
    /// Uniform for the mean length, winding i at the velocity `profile` gives it.
    Moving {
        /// v \[m/s\], positive from end 1 to end 2.
        velocity: f64,
        /// How v is shared out.
        profile: VelocityProfile,
    },
    /// Given winding by winding, winding 1 first.
    Windings {
        /// Positions \[m\] measured from the mean position of end 1; shape `N`.
        positions: Vec<f64>,
        /// Velocities \[m/s\]; shape `N`.
        velocities: Vec<f64>,
    },
}

/// How the velocity of an impact is shared out over the windings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum VelocityProfile {
    /// v for every winding.
    Uniform,
    /// v (i−½)/N for winding i: zero at end 1, v at end 2.
    Linear,
}

/// How the ends move and how the windings start, checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Excitation {
    mean_length: f64,
    ends: [EndInput; 2],
    start: Start,
}

impl Excitation {
    /// Any mean length \[m\], input at each end, and start.
    ///
    /// # Errors
    /// [`Error::Value`] for a length or frequency that is not above zero, or any value that is not finite;
    /// for a steady start also for an input that is neither held nor made of sines;
    /// [`Error::Count`] where a start by windings has unlike numbers of positions and velocities.
    pub fn new(mean_length: f64, end1: EndInput, end2: EndInput, start: Start) -> Result<Self, Error> {
        above_zero("mean_length", mean_length, "m")?;
        match &start {
            Start::Rest | Start::Massless => {}
            Start::Steady => {
                let swings = |input: &EndInput| matches!(input, EndInput::Held | EndInput::Harmonics(_));
                let others = [&end1, &end2].into_iter().filter(|input| !swings(input)).count();
                check(others == 0, "inputs of a steady start that are no sines", others as f64, "", "0")?;
            }
            Start::Moving { velocity, .. } => {
                finite("velocity", *velocity, "m/s")?;
            }
            Start::Windings { positions, velocities } => {
                all_bounded(called("positions", "start positions"), positions, "m")?;
                all_bounded(called("velocities", "start velocities"), velocities, "m/s")?;
                count(called("velocities", "start velocities"), velocities.len(), positions.len())?;
            }
        }
        Ok(Self { mean_length, ends: [end1.checked()?, end2.checked()?], start })
    }

    /// Impact ("heel strike"): both ends stop dead at t = 0 while every winding still moves at `velocity`.
    ///
    /// - `length`: l \[m\]; `velocity`: v \[m/s\], positive from end 1 to end 2
    ///
    /// Source: `[Weijde2017]` section III-B, first condition (0.25 m/s at mid range).
    ///
    /// # Errors
    /// [`Error::Value`] as for [`Self::new`].
    pub fn impact(length: f64, velocity: f64) -> Result<Self, Error> {
        let profile = VelocityProfile::Uniform;
        let start = Start::Moving { velocity, profile };
        Self::new(length, EndInput::Held, EndInput::Held, start)
    }

    /// End stop: end 2, moving at `velocity` until t = 0, stops dead; the windings still move.
    ///
    /// - `length`: l \[m\]; `velocity`: v \[m/s\], positive when the spring was getting longer; `profile`: linear if end 1 stood still
    ///
    /// Source:  `[Weijde2017]` section III-B, second condition, v by [`traverse_velocity`].
    /// Differs: the paper says linear for both; its rows "end stop collision min" are those of a uniform −v.
    ///
    /// # Errors
    /// [`Error::Value`] as for [`Self::new`].
    pub fn end_stop(length: f64, velocity: f64, profile: VelocityProfile) -> Result<Self, Error> {
        let start = Start::Moving { velocity, profile };
        Self::new(length, EndInput::Held, EndInput::Held, start)
    }

    /// Harmonic position input on one end, the other held.
    ///
    /// Source: `[Weijde2017]` section III-B, third condition.
    ///
    /// # Errors
    /// [`Error::Value`] as for [`Self::new`].
    pub fn harmonic(mean_length: f64, end: End, input: EndInput, start: Start) -> Result<Self, Error> {
        match end {
            End::One => Self::new(mean_length, input, EndInput::Held, start),
            End::Two => Self::new(mean_length, EndInput::Held, input, start),
        }
    }

    /// The same about another mean length \[m\]: what a spring of another length undergoes between the same ends. A start by windings is kept as
    /// it is.
    ///
    /// # Errors
    /// [`Error::Value`] for a length that is not above zero.
    pub fn about(&self, mean_length: f64) -> Result<Self, Error> {
        above_zero("mean_length", mean_length, "m")?;
        Ok(Self { mean_length, ..self.clone() })
    }

    /// Its mirror image: all that moves, moves as far and as fast the other way, so that the length is as far above its mean as it was below. What
    /// a spring undergoes that gets shorter where another between the same ends gets longer.
    ///
    /// u1(t) → −u1(t), u2(t) → −u2(t), both from their means; velocities of a start likewise
    ///
    /// # Errors
    /// [`Error::Value`] for a start by windings: where they would be at rest is the spring's to say.
    ///
    /// ```
    /// use coilsense::{End, EndInput, Excitation, Start};
    /// let step = EndInput::Step { height: 2e-3, at: 0.1 };
    /// let mirrored = Excitation::harmonic(0.2, End::Two, step, Start::Rest)?.mirrored()?;
    /// assert_eq!(mirrored.input(End::Two).displacement(0.2), -2e-3);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn mirrored(&self) -> Result<Self, Error> {
        let start = match &self.start {
            Start::Moving { velocity, profile } => Start::Moving { velocity: -velocity, profile: *profile },
            Start::Windings { positions, .. } => {
                check(false, "windings placed by a start that is mirrored", positions.len() as f64, "", "0")?;
                self.start.clone()
            }
            Start::Rest | Start::Massless | Start::Steady => self.start.clone(),
        };
        Ok(Self { mean_length: self.mean_length, ends: [0, 1].map(|end| self.ends[end].scaled(-1.0)), start })
    }

    /// Length about which the ends move \[m\].
    pub fn mean_length(&self) -> f64 {
        self.mean_length
    }

    /// The input of an end.
    pub fn input(&self, end: End) -> &EndInput {
        &self.ends[end as usize]
    }

    /// How the windings start.
    pub fn start(&self) -> &Start {
        &self.start
    }

    /// The shortest and longest length \[m\] that prescribed positions can reach, each end at its own worst moment.
    pub fn length_bounds(&self) -> (f64, f64) {
        let reach: f64 = self.ends.iter().map(EndInput::reach).sum();
        (self.mean_length - reach, self.mean_length + reach)
    }
}

/// Velocity of the paper's end stops \[m/s\]: the operating range traversed in a step time of one second.
///
/// v = (l_max − l_min) / 1 s
///
/// Source:   `[Weijde2017]` eq. 12.
/// Valid:    walking robots with a step time near 1 s.
/// Accuracy: rounding of the difference.
pub fn traverse_velocity(spring: &Spring) -> f64 {
    let (shortest, longest) = spring.operating_range();
    longest - shortest
}
