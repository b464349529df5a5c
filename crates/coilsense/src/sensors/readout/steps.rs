//! An instrument for a processor that steps through a quantity: its numbers for steps of one length.
//!
//! Next door: the same over a series (the parent), a step of it (`coilsense_rt::Readout`).

use coilsense_rt::{Delay, ReadoutMean, ReadoutPole, Real};

use super::Readout;
use crate::error::{Error, above_zero, check, count};

/// An instrument in steps of one length; [`Readout::steps`].
#[derive(Debug, Clone, PartialEq)]
pub struct ReadoutSteps {
    step: f64,
    poles: Vec<ReadoutPole<f64>>,
    delay: Delay<f64>,
    mean: Option<ReadoutMean<f64>>,
    samples: Option<f64>,
    noise: f64,
    resolution: Option<f64>,
    seed: u64,
}

/// Most steps that a delay or a mean may have.
const MOST_STEPS: f64 = 1e6;

impl Readout {
    /// The instrument in steps of h \[s\], its noise by a seed.
    ///
    /// Source:   the closed forms of [`Readout::series`] for one interval.
    /// Valid:    steps of that length.
    /// Accuracy: 1e-12 of the largest value beside [`Readout::ideal_series`] at the same times in `f64` (`tests/readout_steps.rs`); noise has other numbers.
    ///
    /// # Errors
    /// [`Error::Value`] for a step that is not above zero, or of which a delay or a mean has more than a million.
    ///
    /// ```
    /// use coilsense::sensors::{Readout, ReadoutParameters};
    ///
    /// let meter = Readout::new(ReadoutParameters { delay: 2e-3, resolution: Some(0.5), ..Default::default() })?;
    /// let steps = meter.steps(1e-3, 0)?;
    /// let instrument = steps.settings::<f64, 0>()?;
    /// let mut state = instrument.settled::<4>(1.0);
    /// let read = [1.0, 2.0, 3.1, 3.2].map(|x| instrument.step(&mut state, x));
    /// assert_eq!((read, steps.slots()), ([1.0, 1.0, 1.0, 2.0], 4));
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn steps(&self, step: f64, seed: u64) -> Result<ReadoutSteps, Error> {
        above_zero("step", step, "s")?;
        let p = &self.parameters;
        for time in [p.delay, p.averaging.unwrap_or(0.0)] {
            let allowed = format!("at least {:.3e} s, a millionth of what it looks back", time / MOST_STEPS);
            check(time / step <= MOST_STEPS, "step", step, "s", allowed)?;
        }
        let split = |time: f64| {
            // A time that rounds to just below a whole number of steps is that number.
            let steps = time / step;
            let whole = (steps + 1e-9).floor();
            (whole as usize, (steps - whole).max(0.0))
        };
        let (whole, fraction) = split(p.delay);
        let mean = p.averaging.map(|window| {
            let (whole, part) = split(window);
            let steps = whole as f64 + part;
            ReadoutMean { whole, weights: [part * (1.0 - 0.5 * part), 0.5 * part * part, 1.0].map(|w| w / steps) }
        });
        Ok(ReadoutSteps {
            step,
            poles: self.low_pass.as_ref().map_or_else(Vec::new, |low_pass| low_pass.steps(step)),
            delay: Delay { whole, fraction },
            mean,
            samples: p.sample_rate.map(|rate| rate * step),
            noise: p.noise,
            resolution: p.resolution,
            seed,
        })
    }
}

impl ReadoutSteps {
    /// h \[s\].
    pub fn step(&self) -> f64 {
        self.step
    }

    /// Of the low-pass, in `f64`.
    pub fn poles(&self) -> &[ReadoutPole<f64>] {
        &self.poles
    }

    /// By how many steps it comes late.
    pub fn delay(&self) -> Delay<f64> {
        self.delay
    }

    /// Over which time it averages; none takes the moment.
    pub fn mean(&self) -> Option<ReadoutMean<f64>> {
        self.mean
    }

    /// How many of its samples a step has; none follows every step.
    pub fn samples(&self) -> Option<f64> {
        self.samples
    }

    /// σ, in the quantity's unit.
    pub fn noise(&self) -> f64 {
        self.noise
    }

    /// q, in the quantity's unit; none does not round.
    pub fn resolution(&self) -> Option<f64> {
        self.resolution
    }

    /// Of its noise.
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// How many past samples a state of it holds.
    pub fn slots(&self) -> usize {
        self.delay.whole.max(self.mean.map_or(0, |mean| mean.whole)) + 2
    }

    /// What a processor is given, for as many poles as there are, in the precision of its steps.
    ///
    /// # Errors
    /// [`Error::Count`] for another number of poles.
    pub fn settings<T: Real, const POLES: usize>(&self) -> Result<coilsense_rt::Readout<T, POLES>, Error> {
        count("poles", self.poles.len(), POLES)?;
        let none = ReadoutPole { decay: [T::ZERO; 2], drag: [T::ZERO; 2], share: [T::ZERO; 2] };
        let mut poles = [none; POLES];
        for (out, ReadoutPole { decay, drag, share }) in poles.iter_mut().zip(&self.poles) {
            let [decay, drag, share] = [decay, drag, share].map(|pair| pair.map(T::nearest));
            *out = ReadoutPole { decay, drag, share };
        }
        Ok(coilsense_rt::Readout {
            poles,
            delay: self.delay.map(T::nearest),
            mean: self
                .mean
                .map(|ReadoutMean { whole, weights }| ReadoutMean { whole, weights: weights.map(T::nearest) }),
            samples: self.samples,
            noise: T::nearest(self.noise),
            resolution: self.resolution.map(T::nearest),
            seed: self.seed,
        })
    }
}
