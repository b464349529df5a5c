//! The motion of a known excitation step by step, in constant memory.
//!
//! Next door: the same for all times at once (`forces`), for inputs as they come (`live`), what makes a step (`march`, `sines`).

use std::borrow::Cow;

use super::Motion;
use super::march::March;
use super::sines::Sines;
use crate::error::{Error, above_zero};
use crate::excitation::EndInput;

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
