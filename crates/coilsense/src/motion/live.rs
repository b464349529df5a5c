//! The motion step by step for inputs as they come, and its state.
//!
//! Next door: the same for inputs known beforehand (`stream`), what makes a step (`march`).

use std::sync::Arc;

use super::march::March;
use super::{ForceSample, Motion};
use crate::error::{Error, above_zero, all_finite, check, count, entry, finite};
use crate::excitation::{EndInput, Excitation, Start};
use crate::mount::{FarEnd, Mount};
use crate::spring::Spring;

/// A spring whose inputs come one sample at a time, straight from sample to sample (first-order hold).
///
/// A clone goes on by itself, with the same bits, and shares what does not move: it costs the modes' coordinates and rates.
#[derive(Debug, Clone)]
pub struct Live {
    motion: Arc<Motion>,
    march: March,
    step: f64,
    sample: u64,
    inputs: [f64; 2],
    slopes: [f64; 2],
}

/// Steps that a state can count: whole numbers of an `f64`.
const MOST_STEPS: f64 = 9_007_199_254_740_992.0;

impl Live {
    /// What a state holds beside the modes: both inputs, their rates, and the steps taken.
    const BESIDE_MODES: usize = 5;

    /// A spring at rest at a mean length \[m\], with inputs at steps of h \[s\].
    ///
    /// # Errors
    /// [`Error::Value`] for a length or step that is not above zero; those of [`crate::Damping::ratios`].
    pub fn new(spring: &Spring, mount: &Mount, mean_length: f64, step: f64) -> Result<Self, Error> {
        above_zero("step", step, "s")?;
        let held = EndInput::Held;
        let excitation = Excitation::new(mean_length, held.clone(), held, Start::Rest)?;
        let motion = Motion::mounted(spring, mount, &excitation)?;
        let mut march = motion.march(step);
        // At once, so that clones share it.
        march.prepare(step);
        Ok(Self { motion: Arc::new(motion), march, step, sample: 0, inputs: [0.0; 2], slopes: [0.0; 2] })
    }

    /// The spring.
    pub fn spring(&self) -> &Spring {
        self.motion.spring()
    }

    /// What its end 2 is tied to, and its damping.
    pub fn mount(&self) -> &Mount {
        self.motion.mount()
    }

    /// The length that inputs count from \[m\].
    pub fn mean_length(&self) -> f64 {
        self.motion.excitation().mean_length()
    }

    /// h \[s\].
    pub fn step(&self) -> f64 {
        self.step
    }

    /// t \[s\]: h for each step since the spring was made or [`Self::reset`].
    pub fn time(&self) -> f64 {
        self.sample as f64 * self.step
    }

    /// Goes on by one step, to ends as [`crate::Signals`] has them: u1 and u2 \[m\], or the force on end 2 \[N\], tension positive.
    ///
    /// At first they are 0 and the mean length l, or k (l − l0).
    ///
    /// # Errors
    /// [`Error::Value`] for a number that is not finite, or ends that have passed each other; the spring then stays where it is.
    pub fn advance_to(&mut self, ends: [f64; 2]) -> Result<ForceSample, Error> {
        let inputs = self.inputs_of(ends)?;
        self.advance(inputs)
    }

    /// Inputs from their means, of ends as [`Self::advance_to`] takes them.
    ///
    /// # Errors
    /// As [`Self::advance_to`].
    pub fn inputs_of(&self, [first, second]: [f64; 2]) -> Result<[f64; 2], Error> {
        finite("u1", first, "m")?;
        if self.mount().far_end() == FarEnd::Position {
            finite("u2", second, "m")?;
            above_zero("u2 - u1, the spring's length,", second - first, "m")?;
            return self.checked([first, second - self.mean_length()]);
        }
        finite("force on end 2", second, "N")?;
        self.checked([first, second - self.motion.static_force_of([0.0; 2])])
    }

    /// Lets through inputs that a step takes.
    fn checked(&self, inputs: [f64; 2]) -> Result<[f64; 2], Error> {
        let unit = if self.mount().far_end() == FarEnd::Position { "m" } else { "N" };
        Ok([finite("input 1", inputs[0], "m")?, finite("input 2", inputs[1], unit)?])
    }

    /// Goes on by one step, to the inputs `next` (u1 \[m\] and u2 \[m\], or the force at end 2 \[N\], from their means).
    ///
    /// # Errors
    /// [`Error::Value`] for an input that is not finite; the spring then stays where it is.
    pub fn advance(&mut self, next: [f64; 2]) -> Result<ForceSample, Error> {
        self.checked(next)?;
        for (end, next) in next.into_iter().enumerate() {
            let slope = (next - self.inputs[end]) / self.step;
            self.march.kick(end, slope - self.slopes[end]);
            (self.inputs[end], self.slopes[end]) = (next, slope);
        }
        self.march.move_by(self.step);
        self.sample += 1;
        let static_force = self.motion.static_force_of(self.inputs);
        let [input, output] = self.motion.surge_forces(self.march.sums());
        Ok(ForceSample { time: self.time(), input: static_force + input, output: static_force + output })
    }

    /// Back to t = 0, at rest at ends as [`Self::advance_to`] takes them: windings evenly between them, nothing moves.
    ///
    /// A load's mass at end 2 then hangs where the force on it holds it.
    ///
    /// # Errors
    /// As [`Self::advance_to`]; the spring then stays where it is.
    pub fn reset(&mut self, ends: [f64; 2]) -> Result<(), Error> {
        self.inputs = self.inputs_of(ends)?;
        let still = vec![0.0; self.motion.modes().count()];
        self.march.begin_at(&still, &still);
        (self.slopes, self.sample) = ([0.0; 2], 0);
        Ok(())
    }

    /// Ends at which it was made at rest, as [`Self::advance_to`] takes them.
    pub fn mean_ends(&self) -> [f64; 2] {
        let held = self.mount().far_end() == FarEnd::Position;
        [0.0, if held { self.mean_length() } else { self.motion.static_force_of([0.0; 2]) }]
    }

    /// How many numbers [`Self::state`] holds: twice the modes and 5.
    pub fn state_count(&self) -> usize {
        2 * self.motion.modes().count() + Self::BESIDE_MODES
    }

    /// All that the next steps depend on, for [`Self::set_state`] of a spring made alike.
    ///
    /// q_j \[m\], q̇_j \[m/s\], then both inputs from their means (u1 \[m\]; u2 \[m\] or the force at end 2 \[N\]), their rates over the last step, and
    /// the steps taken; shape `state_count`.
    ///
    /// ```
    /// use coilsense::{Mount, motion::Live};
    /// # let spring = coilsense::paper::s_t();
    /// let mut live = Live::new(&spring, &Mount::default(), 0.23, 1e-3)?;
    /// live.advance_to([0.0, 0.231])?;
    /// let saved = live.state();
    /// let once = live.advance_to([1e-3, 0.231])?;
    /// live.set_state(&saved)?;
    /// assert_eq!(live.advance_to([1e-3, 0.231])?, once); // to the last bit
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn state(&self) -> Vec<f64> {
        let mut state = Vec::with_capacity(self.state_count());
        for part in self.march.at_sample() {
            state.extend_from_slice(part);
        }
        state.extend(self.inputs.into_iter().chain(self.slopes).chain([self.sample as f64]));
        state
    }

    /// Goes on from a state: the steps after it have the same bits as those after [`Self::state`] gave it.
    ///
    /// # Errors
    /// [`Error::Count`] where it does not hold [`Self::state_count`] numbers; [`Error::Value`] for the first that is not finite, ends that have
    /// passed each other, and steps taken that are no whole number from zero on. The spring then stays where it is.
    pub fn set_state(&mut self, state: &[f64]) -> Result<(), Error> {
        count("state", state.len(), self.state_count())?;
        let modes = self.motion.modes().count();
        let (moving, steps) = state.split_at(state.len() - 1);
        all_finite("state", moving, "")?;
        let whole = steps[0] >= 0.0 && steps[0] <= MOST_STEPS && steps[0].fract() == 0.0;
        let allowed = "a whole number of steps taken, not below zero";
        check(whole, entry("state", state.len() - 1), steps[0], "", allowed)?;
        let (modal, inputs) = moving.split_at(2 * modes);
        if self.mount().far_end() == FarEnd::Position {
            above_zero("u2 - u1 of the state, the spring's length,", self.mean_length() + inputs[1] - inputs[0], "m")?;
        }
        let (coordinates, rates) = modal.split_at(modes);
        self.march.begin_at(coordinates, rates);
        self.inputs = [inputs[0], inputs[1]];
        self.slopes = [inputs[2], inputs[3]];
        self.sample = steps[0] as u64;
        Ok(())
    }
}
