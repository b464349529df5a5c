//! The channels of a file as columns of a table: which of them share a clock, which have none, and what cannot be taken.
//!
//! Next door: clocks (`clock`), scaled numbers (`scaling`), groups on one clock (`super::grouped`).

use std::collections::HashMap;
use std::path::Path;

use super::super::super::error::{RecordingError, shortened};
use super::super::super::order::MOST_NUMBERS;
use super::super::super::selection::TIMES;
use super::super::super::table::Table;
use super::super::super::title::Title;
use super::super::apart::Apart;
use super::super::grouped::{Group, one_table, titled};
use super::Contained;
use super::clock::{Wave, seconds};
use super::kind::Kind;
use super::properties::Properties;
use super::scaling::Scaling;
use crate::quantity::{Dimension, Scale};

/// A channel with its numbers.
struct Series {
    group: String,
    title: Title,
    values: Vec<f64>,
    wave: Option<Wave>,
    /// The first of its stamps.
    origin: Option<i128>,
}

/// Channels of one clock.
struct Clocked {
    group: Group,
    /// The instant of its time zero, where that is told.
    start: Option<i128>,
}

/// The table of a file.
pub(super) fn table(path: &Path, contained: Contained) -> Result<Table, RecordingError> {
    let cut = if contained.cut { ", cut off in its last segment" } else { "" };
    let mut remarks: Vec<String> = Vec::new();
    let described = contained.metadata.properties("/").and_then(|root| root.text("description")).unwrap_or("");
    remarks.extend(described.lines().map(|line| shortened(line.trim())).filter(|line| !line.is_empty()));
    if contained.cut {
        remarks.push("the file is cut off in its last segment".to_owned());
    }
    let (cut_off, mut apart) = (contained.cut, Apart::default());
    let channels = series(contained, &mut apart);
    let (groups, alone) = clocks(channels, &mut apart);
    let groups = aligned(groups, &mut apart);
    if groups.is_empty() {
        let (columns, rows) = without_clock(alone, cut_off, &mut apart);
        if columns.len().saturating_mul(rows) > MOST_NUMBERS {
            return Err(RecordingError::of_file(path, "is too large to be held in memory"));
        }
        let filled = columns.into_iter().map(|(title, mut values)| {
            values.resize(rows, f64::NAN);
            (title, values)
        });
        let (titles, columns): (Vec<Title>, Vec<Vec<f64>>) = filled.unzip();
        if rows == 0 {
            return Err(RecordingError::of_file(path, format!("has no channel of numbers{}", apart.told())));
        }
        let description = format!("NI TDMS, {} channels without a clock{cut}{}", titles.len(), apart.told());
        let lines = (1..=rows as u64).collect();
        return Ok(Table { file: path.to_owned(), description, remarks, titles, columns, lines });
    }
    for series in &alone {
        apart.leave(&series.title.name, "without a clock");
    }
    let count: usize = groups.iter().map(|group| group.columns.len()).sum();
    let clocks = if groups.len() == 1 { "one clock".to_owned() } else { format!("{} clocks", groups.len()) };
    let description = format!("NI TDMS, {count} channels on {clocks}{cut}{}", apart.told());
    one_table(path, description, remarks, groups)
}

/// The channels of numbers and stamps.
fn series(contained: Contained, apart: &mut Apart) -> Vec<Series> {
    let Contained { metadata, channels, .. } = contained;
    let named: Vec<Option<[String; 2]>> = metadata.objects.iter().map(|object| names(&object.path)).collect();
    let mut often: HashMap<&str, usize> = HashMap::new();
    for [_, name] in named.iter().flatten() {
        *often.entry(name).or_default() += 1;
    }
    let mut all = Vec::new();
    for ((object, raw), names) in metadata.objects.iter().zip(channels).zip(&named) {
        let Some([group, name]) = names else { continue };
        match raw.kind {
            Some(Kind::Text) => apart.leave(name, "texts"),
            Some(Kind::Complex(_)) => apart.leave(name, "complex numbers"),
            _ => {}
        }
        if raw.len() == 0 {
            continue;
        }
        let group_path = format!("/'{}'", group.replace('\'', "''"));
        let above = [metadata.properties(&group_path), metadata.properties("/")];
        let name = if often[name.as_str()] > 1 { format!("{group}/{name}") } else { name.clone() };
        let origin = raw.origin;
        let scaled = Scaling::of(std::iter::once(&object.properties).chain(above.into_iter().flatten()));
        let values = scaled.and_then(|scaling| match scaling {
            _ if raw.is_stamps() => Ok(raw.values),
            Some(scaling) => scaling.apply(&raw),
            None if raw.scalers.is_empty() => Ok(raw.values),
            None => Err("of DAQmx without its scales".to_owned()),
        });
        let wave = Wave::of(&object.properties);
        match values.and_then(|values| wave.map(|wave| (values, wave))) {
            Ok((values, wave)) => {
                let title = title(&name, &object.properties, origin.is_some());
                all.push(Series { group: group.clone(), title, values, wave, origin });
            }
            Err(why) => apart.leave(&name, &why),
        }
    }
    all
}

/// Group and channel of a path.
fn names(path: &str) -> Option<[String; 2]> {
    let inner = path.strip_prefix("/'")?.strip_suffix('\'')?;
    let (group, channel) = inner.split_once("'/'")?;
    Some([group, channel].map(|name| name.replace("''", "'")))
}

/// A channel's name and unit, in short where NI has a word for it.
fn title(name: &str, properties: &Properties, stamps: bool) -> Title {
    let named = Title::parse(name);
    let unit = properties.text("unit_string").filter(|unit| !unit.trim().is_empty());
    let unit = unit.or_else(|| properties.text("NI_UnitDescription")).unwrap_or("").trim();
    let short = match unit {
        "Newtons" => "N",
        "Pounds" => "lbf",
        "Kilograms-force" | "KilogramForce" => "kgf",
        "Meters" => "m",
        "Centimeters" => "cm",
        "Millimeters" => "mm",
        "Seconds" => "s",
        "Ohms" => "Ohm",
        "Volts" => "V",
        other => other,
    };
    let title = if named.unit.is_some() || short.is_empty() { named } else { titled(name, short) };
    Title { stamps, ..title }
}

/// Groups of channels with one clock each; the channels that have none.
fn clocks(channels: Vec<Series>, apart: &mut Apart) -> (Vec<Clocked>, Vec<Series>) {
    let mut names: Vec<String> = channels.iter().map(|series| series.group.clone()).collect();
    let mut seen = std::collections::HashSet::new();
    names.retain(|name| seen.insert(name.clone()));
    let mut by_group: HashMap<String, Vec<Series>> = HashMap::new();
    for series in channels {
        by_group.entry(series.group.clone()).or_default().push(series);
    }
    let (mut waves, mut clocked, mut alone) = (Vec::new(), Vec::new(), Vec::new());
    for name in names {
        let mut group = by_group.remove(&name).unwrap_or_default();
        let called = |series: &Series| {
            let name = series.title.name.rsplit('/').next().unwrap_or_default();
            TIMES.contains(&name.to_lowercase().as_str())
        };
        let first_stamps = group.iter().position(|series| series.origin.is_some() && series.wave.is_none());
        match group.iter().position(called).or(first_stamps) {
            Some(place) => {
                let clock = group.remove(place);
                clocked.push(by_channel(clock, group, apart));
            }
            None => by_wave(group, &mut waves, &mut alone),
        }
    }
    clocked.splice(0..0, waves.into_iter().map(|(_, clocked)| clocked));
    (clocked, alone)
}

/// Channels at the times that another one holds.
fn by_channel(clock: Series, others: Vec<Series>, apart: &mut Apart) -> Clocked {
    let mut columns = Vec::new();
    for other in others {
        if other.values.len() > clock.values.len() {
            apart.leave(&other.title.name, "of more values than times");
        } else {
            columns.push((other.title, other.values));
        }
    }
    Clocked { group: Group { clock: clock.title, times: clock.values, columns }, start: clock.origin }
}

/// Channels with even clocks, those of one clock together; one without joins where it fits.
fn by_wave(group: Vec<Series>, waves: &mut Vec<(Wave, Clocked)>, alone: &mut Vec<Series>) {
    let own: Vec<(Wave, usize)> = group.iter().filter_map(|series| Some((series.wave?, series.values.len()))).collect();
    let shared = own.first().copied().filter(|first| own.iter().all(|other| other == first));
    for series in group {
        let joins = shared.filter(|(_, count)| *count == series.values.len()).map(|(wave, _)| wave);
        let Some(wave) = series.wave.or(joins) else {
            alone.push(series);
            continue;
        };
        let place = waves.iter().position(|(other, _)| *other == wave).unwrap_or_else(|| {
            let group = Group { clock: titled("time", "s"), times: Vec::new(), columns: Vec::new() };
            waves.push((wave, Clocked { group, start: wave.start }));
            waves.len() - 1
        });
        let group = &mut waves[place].1.group;
        if group.times.len() < series.values.len() {
            group.times = wave.times(series.values.len());
        }
        group.columns.push((series.title, series.values));
    }
}

/// Several clocks in seconds from the instant when the first began; a single one as it is.
fn aligned(clocked: Vec<Clocked>, apart: &mut Apart) -> Vec<Group> {
    if clocked.len() < 2 {
        return clocked.into_iter().map(|clocked| clocked.group).collect();
    }
    let first = clocked.iter().filter_map(|clocked| clocked.start).min();
    let mut groups = Vec::new();
    for Clocked { mut group, start } in clocked {
        let unit = group.clock.unit.as_deref().and_then(|unit| Dimension::Time.scale(unit));
        let scale = if group.clock.stamps { Some(Scale::Times(1.0)) } else { unit };
        let later = match (first, start) {
            (None, _) => Some(0.0),
            (Some(first), start) => start.map(|start| seconds(first, start)),
        };
        let (Some(scale), Some(later)) = (scale, later) else {
            let why = if scale.is_none() { "on a clock of no known unit" } else { "on a clock of no known start" };
            for (title, _) in &group.columns {
                apart.leave(&title.name, why);
            }
            continue;
        };
        for time in &mut group.times {
            *time = scale.apply(*time) + later;
        }
        groups.push(group);
    }
    groups
}

/// The channels of the longest length, and of a file that was cut those of the same group.
fn without_clock(channels: Vec<Series>, cut: bool, apart: &mut Apart) -> (Vec<(Title, Vec<f64>)>, usize) {
    let rows = channels.iter().map(|series| series.values.len()).max().unwrap_or(0);
    let longest = channels.iter().find(|series| series.values.len() == rows).map(|series| series.group.clone());
    let mut columns = Vec::new();
    for series in channels {
        let count = series.values.len();
        if count == rows || cut && Some(&series.group) == longest.as_ref() {
            columns.push((series.title, series.values));
        } else {
            apart.leave(&series.title.name, &format!("of {count} values where others have {rows}"));
        }
    }
    (columns, rows)
}
