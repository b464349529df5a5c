//! What makes a record usable, looked at one thing after the other.
//!
//! Next door: what `record.toml` holds (`file`), what a log says (`coilsense::identify`).

use coilsense::Channel;
use coilsense::identify::{ChannelCheck, Settings};

use super::file::{Kind, LogEntry};
use super::{FILE, Record};
use crate::identification::Identified;
use crate::quantity::{Dimension, digits};
use crate::recording::{Cleaning, Mapping, Recording};
use crate::spec::SpringSpec;

/// How often a period of the first mode is sampled, at least.
const LEAST_RATE: f64 = 20.0;
/// Hits of all logs of that kind together, at least.
const FEWEST_HITS: usize = 8;
/// How long nothing is recorded, at least \[s\].
const SILENCE: f64 = 10.0;
/// How far two lengths at which it is hit are apart, at least \[1\].
const OTHER_LENGTH: f64 = 0.1;
/// Licences, and what they let be done.
const LICENCES: [&str; 2] = ["CC-BY-4.0", "check only"];

/// How something is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// As it should be.
    Fine,
    /// It may be sent so, and is worth less.
    Doubtful,
    /// It cannot be sent so.
    Missing,
}

impl State {
    /// In a word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fine => "ok",
            Self::Doubtful => "doubtful",
            Self::Missing => "missing",
        }
    }
}

/// Something that was looked at.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// What.
    pub of: String,
    /// How it is.
    pub state: State,
    /// What was found, or what to do.
    pub says: String,
}

/// Looks at everything.
pub(super) fn all(record: &mut Record) {
    words(record);
    let settings = spring(record);
    for index in 0..record.file.log.len() {
        log(record, index, &settings);
    }
    together(record);
}

impl Record {
    fn add(&mut self, of: impl Into<String>, state: State, says: impl Into<String>) {
        self.checks.push(Check { of: of.into(), state, says: says.into() });
    }
}

/// Who, when, what may be done with it, and with which instruments.
fn words(record: &mut Record) {
    let file = &record.file;
    let told: [(&str, &str, &str); 4] = [
        ("who.name", &file.who.name, "say who recorded it"),
        ("who.date", &file.who.date, "say when, such as 2026-11-28"),
        ("spring.described", &file.spring.described, "say material, ends and article number"),
        ("spring.mount", &file.spring.mount, "say what each end is fixed to, with its mass"),
    ];
    let told = told.map(|(key, text, ask)| match text.trim() {
        "" => (key.to_owned(), State::Missing, ask.to_owned()),
        text => (key.to_owned(), State::Fine, text.to_owned()),
    });
    let licence = match file.who.licence.trim() {
        known if LICENCES.contains(&known) => (State::Fine, known.to_owned()),
        other => {
            (State::Missing, format!("must be {}, got {other:?}", LICENCES.map(|one| format!("{one:?}")).join(" or ")))
        }
    };
    let instruments: Vec<(String, State, String)> = file
        .instrument
        .iter()
        .map(|instrument| {
            let of = format!("instrument of {}", instrument.channel);
            let empty: Vec<&str> =
                [("is", &instrument.is), ("range", &instrument.range), ("filter", &instrument.filter)]
                    .into_iter()
                    .filter(|(_, text)| text.trim().is_empty())
                    .map(|(key, _)| key)
                    .collect();
            match empty.as_slice() {
                [] => {
                    (of, State::Fine, format!("{}, {}, filter: {}", instrument.is, instrument.range, instrument.filter))
                }
                keys => (of, State::Doubtful, format!("fill in {}", keys.join(" and "))),
            }
        })
        .collect();
    let place = file.who.place.trim();
    let place = (!place.is_empty()).then(|| ("who.place".to_owned(), State::Fine, place.to_owned()));
    let licence = [("who.licence".to_owned(), licence.0, licence.1)];
    for (of, state, says) in told.into_iter().chain(place).chain(licence).chain(instruments) {
        record.add(of, state, says);
    }
}

/// The spring, and what is known beforehand of its logs.
fn spring(record: &mut Record) -> Settings {
    let read = record
        .inside(&record.file.spring.spec)
        .and_then(|path| SpringSpec::read(&path).map_err(|error| error.to_string()));
    match read {
        Ok(spec) => {
            let first = spec.spring.chain_frequency();
            record.add("spring.spec", State::Fine, format!("{}: f1 should be near {} Hz", spec.name, digits(first)));
            Settings {
                windings: Some(spec.spring.whole_windings() as f64),
                predicted: Some(first),
                ..Settings::default()
            }
        }
        Err(reason) => {
            record.add("spring.spec", State::Missing, reason);
            Settings::default()
        }
    }
}

/// One log: it opens, is of a real spring, fast enough, and holds what it is said to hold.
fn log(record: &mut Record, index: usize, settings: &Settings) {
    let LogEntry { file, kind, .. } = &record.file.log[index];
    let (name, kind) = (file.clone(), *kind);
    if record.file.log[..index].iter().any(|before| before.file == name) {
        return record.add(name, State::Missing, "is listed twice: its hits would count twice");
    }
    let found = match read(record, &record.file.log[index], settings) {
        Ok(found) => found,
        Err(reason) => return record.add(name, State::Missing, reason),
    };
    if let Some(simulated) = &found.simulated {
        record.add(
            &name,
            State::Missing,
            format!("is simulated ({simulated}): only a measured log is a record of a real spring"),
        );
    }
    let rate = found.found.sampling.rate;
    if let Some(first) = settings.predicted.filter(|first| rate < LEAST_RATE * first) {
        let least = digits(LEAST_RATE * first);
        record.add(
            &name,
            State::Missing,
            format!("is sampled at {} Hz; {least} Hz or more show the modes above f1", digits(rate)),
        );
    }
    for channel in &found.found.channels {
        let spoilt = spoilt(channel);
        if !spoilt.is_empty() {
            record.add(format!("{name}, {}", channel.channel.name()), State::Doubtful, spoilt.join("; "));
        }
        if !record.file.instrument.iter().any(|instrument| instrument.channel == channel.channel.name()) {
            let ask = format!(
                "say with which instrument: an [[instrument]] of {FILE} whose channel is {}",
                channel.channel.name()
            );
            record.add(format!("{name}, {}", channel.channel.name()), State::Doubtful, ask);
        }
    }
    let (state, says) = holds(kind, &found);
    record.add(&name, state, says);
    record.logs.push((name, kind, found));
}

fn read(record: &Record, entry: &LogEntry, settings: &Settings) -> Result<Identified, String> {
    let path = record.inside(&entry.file)?;
    let mapping = entry.mapping.as_deref().map(|name| record.inside(name)).transpose()?;
    let mapping =
        mapping.map_or(Ok(Mapping::default()), |path| Mapping::read(&path)).map_err(|error| error.to_string())?;
    let recording = Recording::read(&path, &mapping, &Cleaning::default()).map_err(|error| error.to_string())?;
    Identified::of(recording, settings).map_err(|error| error.to_string())
}

/// What an instrument did to its channel.
fn spoilt(channel: &ChannelCheck) -> Vec<String> {
    let mut spoilt = Vec::new();
    if channel.clipping.is_some() {
        spoilt.push("is clipped: hit less hard, or take a wider range".to_owned());
    }
    if channel.repeated > 0.25 && channel.update_rate.is_none() {
        spoilt.push("its last digit is coarser than its noise".to_owned());
    }
    if let Some(rate) = channel.update_rate {
        spoilt.push(format!("has a new value only {} times a second", digits(rate)));
    }
    if let Some(corner) = channel.low_pass {
        spoilt.push(format!("a low-pass near {} Hz damps what is above", digits(corner)));
    }
    if let Some(corner) = channel.high_pass {
        spoilt.push(format!("a high-pass above {} Hz takes the stiffness away", digits(corner)));
    }
    spoilt
}

/// Whether a log holds what it is said to hold.
fn holds(kind: Kind, found: &Identified) -> (State, String) {
    let identification = &found.found;
    let (hits, time) = (identification.hits.len(), found.signals.time());
    let seconds = time[time.len() - 1] - time[0];
    match kind {
        Kind::Silence if hits > 0 => (
            State::Doubtful,
            format!("{hits} hits where nothing should happen, the first at {:.2} s", identification.hits[0].time),
        ),
        Kind::Silence if seconds < SILENCE => {
            (State::Doubtful, format!("{} s of nothing; {SILENCE} s tell noise and mains apart", digits(seconds)))
        }
        Kind::Silence => (State::Fine, format!("{} s of nothing", digits(seconds))),
        Kind::Stretch => match &identification.stiffness {
            Ok(line) => (
                State::Fine,
                format!("k = {} N/m over {} mm", digits(line.value()), digits(1e3 * (line.range.1 - line.range.0))),
            ),
            Err(reason) => (State::Doubtful, format!("no stiffness: {reason}")),
        },
        Kind::Hits | Kind::Table if hits == 0 => (State::Missing, "no hit is in it".to_owned()),
        // Also a record that says otherwise is one.
        Kind::Hits => (
            State::Fine,
            format!("{hits} hits; {}: {}", identification.verdict.answer.name(), identification.verdict.evidence[0]),
        ),
        Kind::Table => (State::Fine, format!("{hits} hits beside the spring")),
    }
}

/// What no log says alone: that each kind is there, that there are hits enough, and at two lengths.
fn together(record: &mut Record) {
    let count = |record: &Record, kind| record.file.log.iter().filter(|log| log.kind == kind).count();
    if count(record, Kind::Hits) == 0 {
        record.add("hits", State::Missing, "no [[log]] of kind \"hits\"");
    } else {
        let hits: usize = record
            .logs
            .iter()
            .filter(|(_, kind, _)| *kind == Kind::Hits)
            .map(|(.., found)| found.found.hits.len())
            .sum();
        let state = if hits < FEWEST_HITS { State::Doubtful } else { State::Fine };
        record.add("hits", state, format!("{hits} in all, {FEWEST_HITS} or more wanted"));
        lengths(record);
    }
    for (kind, ask) in [
        (Kind::Silence, "ten seconds of nothing tell noise and mains from ringing"),
        (Kind::Stretch, "a slow stretch gives k, and with f1 the mass that rings"),
        (Kind::Table, "hits of table and frame tell what rings beside the coil"),
    ] {
        if count(record, kind) == 0 {
            record.add(kind.name(), State::Doubtful, format!("no [[log]] of this kind: {ask}"));
        }
    }
}

fn lengths(record: &mut Record) {
    let mut lengths = Vec::new();
    for entry in record.file.log.iter().filter(|log| log.kind == Kind::Hits) {
        let recorded =
            record.logs.iter().find(|(name, ..)| *name == entry.file).and_then(|(.., found)| mean_length(found));
        match entry.length.as_deref().map(|text| Dimension::Length.parse(text).ok_or(text)) {
            Some(Ok(length)) => lengths.push(length),
            Some(Err(text)) => {
                let says = format!("length = {text:?} must be a length with its unit, such as \"230 mm\"");
                return record.checks.push(Check { of: entry.file.clone(), state: State::Missing, says });
            }
            None => lengths.extend(recorded),
        }
    }
    let (least, most) =
        lengths.iter().fold((f64::INFINITY, 0.0_f64), |(least, most), at| (least.min(*at), most.max(*at)));
    if lengths.is_empty() {
        record.add("length", State::Doubtful, "no position was recorded: give each [[log]] the length of the spring");
    } else if most - least < OTHER_LENGTH * least {
        let at = digits(1e3 * least);
        record.add(
            "length",
            State::Doubtful,
            format!("all hits are at {at} mm; the same at another length, 20 % away, tell the coil from its mount"),
        );
    } else {
        record.add("length", State::Fine, format!("hits at {} to {} mm", digits(1e3 * least), digits(1e3 * most)));
    }
}

/// Mean of u2 − u1 \[m\], where both were recorded.
fn mean_length(found: &Identified) -> Option<f64> {
    let mean = |channel| {
        let values = found.signals.channel(channel).ok()?;
        Some(values.iter().sum::<f64>() / values.len() as f64)
    };
    Some(mean(Channel::U2)? - mean(Channel::U1)?).filter(|length| *length > 0.0)
}
