//! Sines, sweeps, steps, ramps and pulses of a `[[condition]]`.
//!
//! Next door: the rest of a condition (`condition`).

use coilsense::{EndInput, FarEnd};

use super::SpecError;
use super::section::Section;
use super::setting::Setting;
use crate::quantity::Dimension;

/// What drives an end, from its table.
pub(super) type Read = fn(&Drive<'_>) -> Result<EndInput, SpecError>;

/// Parameters of an [`EndInput`] and the keys that set them, where these are called otherwise.
pub(super) type Keys = &'static [(&'static str, &'static str)];

/// Every kind of condition that drives an end, by its word in a spec.
pub(super) const DRIVES: [(&str, Read, Keys); 5] = [
    ("harmonic", |drive| drive.harmonic(), &[]),
    ("sweep", |drive| drive.sweep(), &[("from", "frequency"), ("to", "frequency")]),
    ("step", |drive| drive.step(), &[("height", "amplitude"), ("at", "begin")]),
    ("ramp", |drive| drive.ramp(), &[("height", "amplitude"), ("from", "begin"), ("duration", "rise_time")]),
    ("pulse", |drive| drive.pulse(), &[("height", "amplitude"), ("from", "begin"), ("duration", "width")]),
];

/// What reads the drive of a kind, and its keys; `None` of a kind that is no drive.
pub(super) fn named(kind: &str) -> Option<(Read, Keys)> {
    DRIVES.iter().find(|(word, ..)| *word == kind).map(|(_, read, keys)| (*read, *keys))
}

/// A driven end.
pub(super) struct Drive<'a> {
    section: &'a Section<'a>,
    setting: &'a Setting<'a>,
    duration: f64,
    /// 1 or 2.
    end: u64,
}

/// The inputs of both ends, for as long as the condition lasts \[s\].
pub(super) fn inputs(
    section: &Section<'_>,
    setting: &Setting<'_>,
    duration: f64,
    read: Read,
) -> Result<[EndInput; 2], SpecError> {
    let end = section.optional_whole("end", 1, 2)?.unwrap_or(1);
    let input = read(&Drive { section, setting, duration, end })?;
    Ok(if end == 1 { [input, EndInput::Held] } else { [EndInput::Held, input] })
}

impl Drive<'_> {
    fn harmonic(&self) -> Result<EndInput, SpecError> {
        Ok(EndInput::harmonic(self.amplitude()?, self.frequency()?, self.phase()?))
    }

    fn sweep(&self) -> Result<EndInput, SpecError> {
        let [from, to] = self.frequencies()?;
        let (amplitude, phase) = (self.amplitude()?, self.phase()?);
        Ok(EndInput::Chirp { amplitude, from, to, duration: self.duration, phase })
    }

    fn step(&self) -> Result<EndInput, SpecError> {
        Ok(EndInput::Step { height: self.amplitude()?, at: self.begin()? })
    }

    fn ramp(&self) -> Result<EndInput, SpecError> {
        let (height, from) = (self.amplitude()?, self.begin()?);
        Ok(EndInput::Ramp { height, from, duration: self.lasting("rise_time")? })
    }

    fn pulse(&self) -> Result<EndInput, SpecError> {
        let (height, from) = (self.amplitude()?, self.begin()?);
        Ok(EndInput::HalfSine { height, from, duration: self.lasting("width")? })
    }

    /// How far the end moves \[m\], or how far its force changes \[N\].
    fn amplitude(&self) -> Result<f64, SpecError> {
        let spring = self.setting.spring;
        let is_force = self.end == 2 && self.setting.mount.far_end() != FarEnd::Position;
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
pub(super) fn least([one, two]: &[EndInput; 2]) -> f64 {
    -one.bounds().1 + two.bounds().0
}

#[cfg(test)]
mod tests {
    use super::super::document::Document;
    use super::super::mount::MountSpec;
    use super::super::recordings::Recordings;
    use super::*;

    /// A toy: the end steps back by twice the amplitude.
    fn toy(drive: &Drive<'_>) -> Result<EndInput, SpecError> {
        Ok(EndInput::Step { height: -2.0 * drive.amplitude()?, at: drive.begin()? })
    }

    #[test]
    fn what_a_row_names_is_all_that_a_drive_takes() {
        let spring = coilsense::paper::s_t();
        let read = |keys: &str| {
            let text = format!("[[condition]]\nkind = \"step\"\nend = 2\n{keys}");
            let document = Document::parse("toy.toml", &text)?;
            let mount = MountSpec::parse(&document, &spring, coilsense::geometry::EndType::Hooks)?;
            let (files, recordings) = (|_: &str| Err("no files".to_owned()), Recordings::default());
            let setting = Setting { spring: &spring, mount: &mount, files: &files, recordings: &recordings };
            document.sections("condition")?.iter().map(|section| inputs(section, &setting, 1.0, toy)).collect()
        };
        let found: Result<Vec<[EndInput; 2]>, SpecError> = read("amplitude = \"1 mm\"\nbegin = \"10 ms\"\n");
        assert_eq!(found.unwrap(), [[EndInput::Held, EndInput::Step { height: -2e-3, at: 0.01 }]]);
        let refused = read("amplitude = \"1 mm\"\nbegin = \"-1 s\"\n").unwrap_err().to_string();
        assert!(refused.starts_with("toy.toml:5: begin = \"-1 s\": "), "{refused}");
    }
}
