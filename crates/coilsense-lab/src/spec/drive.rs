//! Sines, sweeps, steps, ramps and pulses of a `[[condition]]`.
//!
//! Next door: the rest of a condition (`condition`).

use coilsense::{EndInput, FarEnd};

use super::SpecError;
use super::condition::Setting;
use super::section::Section;
use crate::quantity::Dimension;

/// Quantities of the science and the keys that set them, where the words differ.
pub(super) const ALIASES: [(&str, &str); 6] = [
    ("mean length", "length"),
    ("height", "amplitude"),
    ("first frequency", "frequency"),
    ("last frequency", "frequency"),
    ("turns of the chirp", "frequency"),
    ("time of the step", "begin"),
];

/// A driven end.
pub(super) struct Drive<'a> {
    pub section: &'a Section<'a>,
    pub setting: &'a Setting<'a>,
    pub duration: f64,
}

impl Drive<'_> {
    /// The inputs of both ends.
    pub fn inputs(&self, kind: &str) -> Result<[EndInput; 2], SpecError> {
        let end = self.section.optional_whole("end", 1, 2)?.unwrap_or(1);
        let input = match kind {
            "harmonic" => EndInput::harmonic(self.amplitude(end)?, self.frequency()?, self.phase()?),
            "sweep" => {
                let [from, to] = self.frequencies()?;
                let (amplitude, phase) = (self.amplitude(end)?, self.phase()?);
                EndInput::Chirp { amplitude, from, to, duration: self.duration, phase }
            }
            "step" => EndInput::Step { height: self.amplitude(end)?, at: self.begin()? },
            "ramp" => {
                let (height, from) = (self.amplitude(end)?, self.begin()?);
                EndInput::Ramp { height, from, duration: self.lasting("rise_time")? }
            }
            _ => {
                let (height, from) = (self.amplitude(end)?, self.begin()?);
                EndInput::HalfSine { height, from, duration: self.lasting("width")? }
            }
        };
        Ok(if end == 1 { [input, EndInput::Held] } else { [EndInput::Held, input] })
    }

    /// How far the end moves \[m\], or how far its force changes \[N\].
    fn amplitude(&self, end: u64) -> Result<f64, SpecError> {
        let spring = self.setting.spring;
        let is_force = end == 2 && self.setting.mount.far_end() != FarEnd::Position;
        let native = if is_force { Dimension::Force } else { Dimension::Length };
        let (dimension, value) = self.section.any_quantity("amplitude", &[native, Dimension::Share])?;
        let (shortest, longest) = spring.operating_range();
        let whole = if is_force { spring.nominal_force() } else { longest - shortest };
        let amplitude = if dimension == Dimension::Share { value * whole } else { value };
        self.section.check("amplitude", amplitude.is_finite(), amplitude, "finite")
    }

    fn frequency(&self) -> Result<f64, SpecError> {
        let given = self.section.any_quantity("frequency", &FREQUENCY)?;
        let frequency = self.hertz(given);
        self.section.check("frequency", frequency.is_finite() && frequency > 0.0, frequency, "above zero and finite")
    }

    fn frequencies(&self) -> Result<[f64; 2], SpecError> {
        let [from, to] = self.section.pair("frequency", &FREQUENCY)?.map(|given| self.hertz(given));
        let holds = [from, to].iter().all(|frequency| frequency.is_finite() && *frequency >= 0.0) && from.max(to) > 0.0;
        self.section.check("frequency", holds, from, "zero or above, finite, and not both zero")?;
        Ok([from, to])
    }

    fn hertz(&self, (dimension, value): (Dimension, f64)) -> f64 {
        if dimension == Dimension::SurgeMultiple { value * self.setting.spring.surge_frequency() } else { value }
    }

    fn phase(&self) -> Result<f64, SpecError> {
        let phase = self.section.optional_quantity("phase", Dimension::Angle)?.unwrap_or(0.0);
        self.section.check("phase", phase.is_finite(), phase, "finite")
    }

    fn begin(&self) -> Result<f64, SpecError> {
        Ok(self.section.not_negative("begin", Dimension::Time)?.unwrap_or(0.0))
    }

    fn lasting(&self, key: &str) -> Result<f64, SpecError> {
        self.section.positive(key, Dimension::Time)
    }
}

const FREQUENCY: [Dimension; 2] = [Dimension::Frequency, Dimension::SurgeMultiple];

/// The least that u2 − u1 becomes \[m\], of inputs that are no recordings.
pub(super) fn least(inputs: &[EndInput; 2]) -> f64 {
    let of = |input: &EndInput, sign: f64| match input {
        EndInput::Harmonics(each) => -each.iter().map(|sine| sine.amplitude.abs()).sum::<f64>(),
        EndInput::Chirp { amplitude, .. } => -amplitude.abs(),
        EndInput::Step { height, .. } | EndInput::Ramp { height, .. } | EndInput::HalfSine { height, .. } => {
            (sign * height).min(0.0)
        }
        EndInput::Held | EndInput::Sampled(_) => 0.0,
    };
    of(&inputs[0], -1.0) + of(&inputs[1], 1.0)
}
