//! The motion step by step, in constant memory: of a known excitation, or of inputs as they come.
//!
//! Next door: the same for all times at once (`forces`), what makes a step (`march`, `sines`).

use std::borrow::Cow;

use super::Motion;
use super::march::March;
use super::sines::Sines;
use crate::error::{Error, above_zero, finite};
use crate::excitation::{EndInput, Excitation};
use crate::mount::{FarEnd, Mount};
use crate::spring::Spring;

/// Both forces at a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceSample {
    /// t \[s\].
    pub time: f64,
    /// F_i \[N\].
    pub input: f64,
    /// F_o \[N\].
    pub output: f64,
}

/// Forces of a motion at t = 0, h, 2h, …, one after the other and without end.
#[derive(Debug, Clone)]
pub struct Stream<'a> {
    motion: Cow<'a, Motion>,
    march: March,
    /// Where there are any: then the march holds all but them.
    sines: Option<Sines>,
    /// Both forces less those of modes and sines \[N\], where nothing else moves.
    still: Option<[f64; 2]>,
    step: f64,
    sample: u64,
}

impl Motion {
    /// Forces at t = 0, h, 2h, … in constant memory.
    ///
    /// - `step`: h \[s\], above zero
    ///
    /// Accuracy: as [`Motion::end_forces`], to 1e-12 of the peak over 10 000 steps.
    ///
    /// # Errors
    /// [`Error::Value`] for a step that is not above zero.
    ///
    /// ```
    /// # use coilsense::{Excitation, Motion};
    /// # let spring = coilsense::paper::s_t();
    /// let motion = Motion::new(&spring, &Excitation::impact(0.23, 0.25)?)?;
    /// let last = motion.stream(1e-4)?.nth(10_000).expect("a stream has no end");
    /// let batch = motion.end_forces(&[1.0])?;
    /// assert!((last.output - batch.output[0]).abs() < 1e-10);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn stream(&self, step: f64) -> Result<Stream<'_>, Error> {
        Stream::new(Cow::Borrowed(self), step)
    }

    /// The same stream, which takes the motion with it.
    ///
    /// # Errors
    /// As [`Self::stream`].
    pub fn into_stream(self, step: f64) -> Result<Stream<'static>, Error> {
        Stream::new(Cow::Owned(self), step)
    }
}

impl<'a> Stream<'a> {
    fn new(motion: Cow<'a, Motion>, step: f64) -> Result<Self, Error> {
        above_zero("step", step, "s")?;
        let (march, sines) = motion.march_and_sines(step);
        let others = motion.inputs_beside(sines.as_ref());
        let is_still = others.into_iter().all(|input| *input == EndInput::Held);
        let still = is_still.then(|| motion.slow_forces_under(others, 0.0));
        Ok(Self { motion, march, sines, still, step, sample: 0 })
    }

    /// Both forces at the present sample \[N\], less those of the modes that the march follows.
    fn forces_beside_march(&mut self, time: f64) -> [f64; 2] {
        let others = || self.motion.slow_forces_under(self.motion.inputs_beside(self.sines.as_ref()), time);
        let [slow_input, slow_output] = self.still.unwrap_or_else(others);
        let Some(sines) = &mut self.sines else {
            return [slow_input, slow_output];
        };
        let [input, output] = sines.step_to(self.sample);
        [slow_input + input, slow_output + output]
    }
}

impl Iterator for Stream<'_> {
    type Item = ForceSample;

    fn next(&mut self) -> Option<ForceSample> {
        let time = self.sample as f64 * self.step;
        self.march.advance_to(time);
        let [input, output] = self.motion.surge_forces(self.march.sums());
        let [slow_input, slow_output] = self.forces_beside_march(time);
        self.sample += 1;
        Some(ForceSample { time, input: slow_input + input, output: slow_output + output })
    }
}

/// A spring whose inputs come one sample at a time, straight from sample to sample (first-order hold).
#[derive(Debug, Clone)]
pub struct Live {
    motion: Motion,
    march: March,
    step: f64,
    sample: u64,
    inputs: [f64; 2],
    slopes: [f64; 2],
}

impl Live {
    /// A spring at rest at a mean length \[m\], with inputs at steps of h \[s\].
    ///
    /// # Errors
    /// [`Error::Value`] for a length or step that is not above zero; those of [`crate::Damping::ratios`].
    pub fn new(spring: &Spring, mount: &Mount, mean_length: f64, step: f64) -> Result<Self, Error> {
        above_zero("step", step, "s")?;
        let (held, start) = (EndInput::Held, crate::excitation::Start::Rest);
        let excitation = Excitation::new(mean_length, held.clone(), held, start)?;
        let motion = Motion::mounted(spring, mount, &excitation)?;
        let march = motion.march(step);
        Ok(Self { motion, march, step, sample: 0, inputs: [0.0; 2], slopes: [0.0; 2] })
    }

    /// Goes on by one step, to ends as [`crate::Signals`] has them: u1 and u2 \[m\], or the force on end 2 \[N\], tension positive.
    ///
    /// At first they are 0 and the mean length l, or k (l − l0).
    ///
    /// # Errors
    /// [`Error::Value`] for a number that is not finite, or ends that have passed each other; the spring then stays where it is.
    pub fn advance_to(&mut self, ends: [f64; 2]) -> Result<ForceSample, Error> {
        let [first, second] = ends;
        finite("u1", first, "m")?;
        let mean = if self.motion.mount().far_end() == FarEnd::Position {
            finite("u2", second, "m")?;
            above_zero("u2 - u1, the spring's length,", second - first, "m")?;
            self.motion.excitation().mean_length()
        } else {
            finite("force on end 2", second, "N")?;
            self.motion.static_force_of([0.0; 2])
        };
        self.advance([first, second - mean])
    }

    /// Goes on by one step, to the inputs `next` (u1 \[m\] and u2 \[m\], or the force at end 2 \[N\], from their means).
    ///
    /// # Errors
    /// [`Error::Value`] for an input that is not finite; the spring then stays where it is.
    pub fn advance(&mut self, next: [f64; 2]) -> Result<ForceSample, Error> {
        finite("input 1", next[0], "m")?;
        finite("input 2", next[1], if self.motion.mount().far_end() == FarEnd::Position { "m" } else { "N" })?;
        for (end, next) in next.into_iter().enumerate() {
            let slope = (next - self.inputs[end]) / self.step;
            self.march.kick(end, slope - self.slopes[end]);
            (self.inputs[end], self.slopes[end]) = (next, slope);
        }
        self.march.move_by(self.step);
        self.sample += 1;
        let static_force = self.motion.static_force_of(self.inputs);
        let [input, output] = self.motion.surge_forces(self.march.sums());
        let time = self.sample as f64 * self.step;
        Ok(ForceSample { time, input: static_force + input, output: static_force + output })
    }
}
