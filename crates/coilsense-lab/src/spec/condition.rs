//! The tables `[[condition]]`: what is done to the spring.
//!
//! Next door: sines, steps and the like (`drive`), recorded files (`recorded`), what they mean (`coilsense::excitation`).

use coilsense::excitation::traverse_velocity;
use coilsense::{EndInput, Error, Excitation, FarEnd, Spring, Start, VelocityProfile};

use super::document::Document;
use super::drive::{self, DRIVES};
use super::recorded::Recorded;
use super::section::Section;
use super::setting::Setting;
use super::{SpecError, size};
use crate::quantity::Dimension;

/// Every kind of condition, by its word in a spec.
pub const KINDS: [&str; DRIVES.len() + 3] = words();

/// Those that stop dead, those that drive an end, and a recording.
const fn words() -> [&'static str; DRIVES.len() + 3] {
    let mut words = ["recorded"; DRIVES.len() + 3];
    (words[0], words[1]) = ("impact", "end-stop");
    let mut index = 0;
    while index < DRIVES.len() {
        words[index + 2] = DRIVES[index].0;
        index += 1;
    }
    words
}

/// What a kind of condition is about.
enum About {
    /// Windings that move on between ends that stand.
    Moving,
    /// An end that is driven.
    Driven(drive::Read, drive::Keys),
    /// Ends that a file drives, so many times as fast as it was recorded.
    Recorded(Recorded, f64),
}

impl About {
    fn read(section: &Section<'_>, setting: &Setting<'_>, kind: &str) -> Result<Self, SpecError> {
        match kind {
            "impact" | "end-stop" => Ok(Self::Moving),
            "recorded" => {
                let file = section.text("file")?;
                let recorded = setting.recordings.of(&file, setting.mount.far_end(), setting.files);
                let recorded = recorded.map_err(|message| section.refuse("file", message))?;
                let Some(speed) = speed(section)? else { return Ok(Self::Recorded(recorded, 1.0)) };
                let played = recorded.played(speed).map_err(|message| section.refuse("playback_speed", message))?;
                Ok(Self::Recorded(played, speed))
            }
            other => match drive::named(other) {
                Some((read, keys)) => Ok(Self::Driven(read, keys)),
                None => Err(section.refuse("kind", "is no kind of condition".to_owned())),
            },
        }
    }
}

/// One thing that is done to the spring.
#[derive(Debug, Clone, PartialEq)]
pub struct ConditionSpec {
    /// Its name.
    pub name: String,
    /// Its kind, one of [`KINDS`].
    pub kind: &'static str,
    /// What the ends do and how the windings start.
    pub excitation: Excitation,
    /// How long is simulated \[s\].
    pub duration: f64,
    /// The part that is judged \[s\].
    pub window: (f64, f64),
    /// Samples per second of the simulation \[Hz\].
    pub sample_rate: f64,
    /// What a recorded file says of itself: its comment lines.
    pub remarks: Vec<String>,
}

impl ConditionSpec {
    pub(super) fn parse_all(document: &Document<'_>, setting: &Setting<'_>) -> Result<Vec<Self>, SpecError> {
        let mut conditions: Vec<Self> = Vec::new();
        for section in document.sections("condition")? {
            let condition = Self::parse(&section, setting)?;
            if let Some(other) = conditions.iter().find(|other| other.stem() == condition.stem()) {
                let text = format!(
                    "{:?} makes the same file names as {:?}; give each condition its own name",
                    condition.name, other.name
                );
                return Err(section.refuse("name", text));
            }
            conditions.push(condition);
            let samples = conditions.iter().map(|condition| condition.duration * condition.sample_rate).sum();
            size::check_total(&section, setting, samples)?;
        }
        Ok(conditions)
    }

    fn parse(section: &Section<'_>, setting: &Setting<'_>) -> Result<Self, SpecError> {
        let kind = section.word("kind", &KINDS)?;
        section.only_of(kind, &format!("kind \"{kind}\""))?;
        let name = section.optional_text("name")?.unwrap_or_else(|| kind.to_owned());
        let about = About::read(section, setting, kind)?;
        let (recorded, speed) = match &about {
            About::Recorded(recorded, speed) => (Some(recorded), *speed),
            About::Moving | About::Driven(..) => (None, 1.0),
        };
        // Both count in the file's time: the same turns are judged at every speed.
        let told = section.above_zero("duration", Dimension::Time)?;
        let in_file = told.or(recorded.map(Recorded::duration)).unwrap_or(1.0);
        let sample_rate = section.above_zero("sample_rate", Dimension::Frequency)?.unwrap_or(10_000.0);
        let duration = in_file / speed;
        size::check(section, setting, duration * sample_rate)?;
        let window = size::window(section, in_file, sample_rate / speed)?;
        let window = (window.0 / speed, window.1 / speed);
        let remarks = recorded.map_or_else(Vec::new, |recorded| recorded.remarks.clone());
        let excitation = match about {
            About::Moving => moving(section, setting, kind)?,
            About::Driven(read, keys) => driven(section, setting, keys, || {
                let inputs = drive::inputs(section, setting, duration, read)?;
                let least = drive::least(&inputs);
                Ok((inputs, least))
            })?,
            About::Recorded(recorded, _) => driven(section, setting, &[], || Ok((recorded.inputs, recorded.shortest)))?,
        };
        Ok(Self { name, kind, excitation, duration, window, sample_rate, remarks })
    }

    /// Its name as part of a file's.
    pub fn stem(&self) -> String {
        super::stem(&self.name)
    }
}

/// How many times as fast a recorded motion is played \[1\], where it is given.
fn speed(section: &Section<'_>) -> Result<Option<f64>, SpecError> {
    let Some(speed) = section.optional_quantity("playback_speed", Dimension::Share)? else { return Ok(None) };
    section.check("playback_speed", (SPEEDS.0..=SPEEDS.1).contains(&speed), speed, "from 1 to 10000 %").map(Some)
}

/// The slowest and the fastest that a recording is played \[1\].
const SPEEDS: (f64, f64) = (0.01, 100.0);

/// Both ends held while the windings still move.
fn moving(section: &Section<'_>, setting: &Setting<'_>, kind: &str) -> Result<Excitation, SpecError> {
    let spring = setting.spring;
    let profile = match section.optional_word("profile", &["uniform", "linear"])? {
        Some("uniform") => VelocityProfile::Uniform,
        Some(_) => VelocityProfile::Linear,
        None if kind == "impact" => VelocityProfile::Uniform,
        None => VelocityProfile::Linear,
    };
    let (length, velocity) = if kind == "impact" {
        let velocity = section.quantity("velocity", Dimension::Velocity)?;
        (length(section, spring)?.unwrap_or(spring.mid_length()), velocity)
    } else {
        let (shortest, longest) = spring.operating_range();
        let (end, sign) = if section.word("at", &["min", "max"])? == "max" { (longest, 1.0) } else { (shortest, -1.0) };
        let speed = section.above_zero("velocity", Dimension::Velocity)?.unwrap_or(traverse_velocity(spring));
        (length(section, spring)?.unwrap_or(end), sign * speed)
    };
    let start = Start::Moving { velocity, profile };
    Excitation::new(length, EndInput::Held, EndInput::Held, start).map_err(|error| refuse(section, &error, &[]))
}

/// One or both ends driven: by `inputs`, and the least that u2 − u1 becomes \[m\].
fn driven(
    section: &Section<'_>,
    setting: &Setting<'_>,
    keys: drive::Keys,
    inputs: impl FnOnce() -> Result<([EndInput; 2], f64), SpecError>,
) -> Result<Excitation, SpecError> {
    let length = length(section, setting.spring)?.unwrap_or(setting.spring.mid_length());
    let start = match section.optional_word("start", &["rest", "massless"])? {
        Some("massless") => Start::Massless,
        _ => Start::Rest,
    };
    let ([one, two], least) = inputs()?;
    let excitation = Excitation::new(length, one, two, start).map_err(|error| refuse(section, &error, keys))?;
    let shortest = length + least;
    if setting.mount.far_end() == FarEnd::Position && shortest <= 0.0 {
        let key = section.first_of(&["amplitude", "file", "length"]).unwrap_or("length");
        let text = format!(
            "the ends meet: of a mean length of {:.3} mm the ends' motion leaves {:.3} mm; it must stay above zero",
            1e3 * length,
            1e3 * shortest
        );
        return Err(section.refuse(key, text));
    }
    Ok(excitation)
}

/// The mean length \[m\], where it is given.
fn length(section: &Section<'_>, spring: &Spring) -> Result<Option<f64>, SpecError> {
    let (shortest, longest) = spring.operating_range();
    if let Ok(Some(word)) = section.optional_word("length", &["min", "mid", "max"]) {
        return Ok(Some(match word {
            "min" => shortest,
            "max" => longest,
            _ => spring.mid_length(),
        }));
    }
    let given = section.optional_any_quantity("length", &[Dimension::Length, Dimension::Share]);
    let given = given.map_err(|error| error.or_also("\"min\", \"mid\" or \"max\""))?;
    let Some((dimension, value)) = given else { return Ok(None) };
    let length = if dimension == Dimension::Share { shortest + value * (longest - shortest) } else { value };
    section.check("length", length.is_finite() && length > 0.0, length, "above zero and finite").map(Some)
}

/// An error of the science at the key it is about.
fn refuse(section: &Section<'_>, error: &Error, keys: drive::Keys) -> SpecError {
    section.refuse_science(error, &[&[("mean_length", "length")], keys].concat())
}
