//! Texts whose head says more than titles do: LabVIEW's measurement files, and oscilloscopes that tell their clock beside the first rows.
//!
//! Instruments whose rows stand below a line of titles need no entry here. Next door: how any other text is written (`trial`), what is found (`layout`).

use super::cell::{Cell, Delimiter, split, words};
use super::layout::{FileClock, Layout, Line};
use super::title::Title;

/// The layout of a text that is known by its first lines.
pub(super) fn known(head: &[Line<'_>]) -> Option<Result<Layout, String>> {
    let first = head.iter().find(|(_, line)| !line.trim_ascii().is_empty())?;
    let begins = |words: &[u8]| first.1.trim_ascii_start().starts_with(words);
    match () {
        () if begins(b"LabVIEW Measurement") => Some(labview(head)),
        () if begins(b"Record Length,") => tektronix(head).map(Ok),
        () if begins(b"X,CH") => rigol(head).map(Ok),
        () => None,
    }
}

fn cells(line: &[u8], delimiter: Delimiter) -> Vec<String> {
    let mut ranges = Vec::new();
    split(line, delimiter, &mut ranges);
    ranges.into_iter().map(|range| words(&line[range])).collect()
}

fn number(text: &str, decimal_comma: bool) -> Option<f64> {
    match Cell::of(text.as_bytes(), decimal_comma) {
        Cell::Number(value) if value.is_finite() => Some(value),
        _ => None,
    }
}

fn titled(name: &str, unit: &str) -> Title {
    let unit = unit.trim();
    Title::parse(&if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") })
}

/// What ends the head of the file and that of each segment.
const END: &[u8] = b"***End_of_Header***";

/// LabVIEW's measurement file (`.lvm`): a head for the file, and one for each segment, with units and the clock.
///
/// Source: National Instruments, "Specification for the LabVIEW Measurement File (.lvm)".
fn labview(head: &[Line<'_>]) -> Result<Layout, String> {
    let value = |key: &str| {
        let lines = head.iter().take_while(|(_, line)| !line.starts_with(END));
        let texts = lines.map(|(_, line)| words(line));
        texts
            .filter_map(|text| text.strip_prefix(key).map(|rest| rest.trim_matches(['\t', ',', ' ']).to_owned()))
            .next()
    };
    let delimiter = if value("Separator").is_some_and(|word| word == "Comma") {
        Delimiter::Sign(b',')
    } else {
        Delimiter::Sign(b'\t')
    };
    let comma = value("Decimal_Separator").is_some_and(|sign| sign.is_empty() && delimiter == Delimiter::Sign(b'\t'))
        || head.iter().any(|(_, line)| line.starts_with(b"Decimal_Separator\t,"));
    let mut ends = head.iter().enumerate().filter(|(_, (_, line))| line.starts_with(END)).map(|(place, _)| place);
    let (Some(_), Some(end)) = (ends.next(), ends.next()) else {
        return Err("is a LabVIEW measurement file without the head of a segment".to_owned());
    };
    let in_segment = |key: &str| -> Vec<String> {
        let found = head[..end].iter().rev().map(|(_, line)| cells(line, delimiter)).find(|cells| cells[0] == key);
        found.map_or(Vec::new(), |cells| cells[1..].to_vec())
    };
    let Some((header, line)) =
        head.get(end + 1..).and_then(|below| below.iter().find(|(_, line)| !line.trim_ascii().is_empty()))
    else {
        return Err("is a LabVIEW measurement file without a row".to_owned());
    };
    let mut names = cells(line, delimiter);
    while names.last().is_some_and(String::is_empty) {
        names.pop();
    }
    let (units, times) = (in_segment("Y_Unit_Label"), in_segment("X_Dimension"));
    let is_time = times.first().is_none_or(|dimension| dimension == "Time");
    let without_x = value("X_Columns").is_some_and(|word| word == "No");
    let mut channel = 0;
    let titles: Vec<Title> = names
        .iter()
        .map(|name| match name.as_str() {
            "X_Value" if without_x => Title::parse(""),
            "X_Value" => titled(name, if is_time { "s" } else { "" }),
            "Comment" => Title::parse(name),
            name => {
                channel += 1;
                titled(name, units.get(channel - 1).map_or("", String::as_str))
            }
        })
        .collect();
    let of_first = |key: &str| in_segment(key).first().and_then(|text| number(text, comma));
    let clock = match (of_first("X0"), of_first("Delta_X")) {
        (start, Some(interval)) if without_x && is_time && interval > 0.0 => {
            Some(FileClock { start: start.unwrap_or(0.0), interval })
        }
        _ => None,
    };
    let optional = usize::from(names.last().is_some_and(|name| name == "Comment"));
    Ok(Layout {
        delimiter,
        decimal_comma: comma,
        shortest: titles.len() - optional,
        titles,
        header: Some(*header),
        first_row: header + 1,
        segments: Some(END),
        clock,
        remarks: above(head, *header),
    })
}

/// Tektronix's TDS and TBS: what is set stands in the first two cells of the first rows, times and values in the fourth and fifth.
///
/// Source: Tektronix, TDS1000B and TDS2000B Series User Manual, "Saving waveforms to a USB flash drive".
fn tektronix(head: &[Line<'_>]) -> Option<Layout> {
    let delimiter = Delimiter::Sign(b',');
    let rows: Vec<Vec<String>> =
        head.iter().filter(|(_, line)| !line.trim_ascii().is_empty()).map(|(_, line)| cells(line, delimiter)).collect();
    let is_row =
        |cells: &Vec<String>| cells.len() >= 5 && [3, 4].iter().all(|&place| number(&cells[place], false).is_some());
    if !rows.iter().all(is_row) {
        return None;
    }
    let value = |key: &str| rows.iter().find(|cells| cells[0] == key).map_or("", |cells| cells[1].as_str());
    let unit = Some(value("Horizontal Units")).filter(|unit| !unit.is_empty()).unwrap_or("s");
    let source = Some(value("Source")).filter(|source| !source.is_empty()).unwrap_or("CH1");
    let mut titles = vec![Title::parse(""); 3];
    titles.extend([titled("time", unit), titled(source, value("Vertical Units"))]);
    let remarks =
        rows.iter().filter(|cells| !cells[0].is_empty()).map(|cells| format!("{}: {}", cells[0], cells[1])).collect();
    Some(Layout {
        delimiter,
        decimal_comma: false,
        shortest: titles.len(),
        titles,
        header: None,
        first_row: head.first()?.0,
        segments: None,
        clock: None,
        remarks,
    })
}

/// Rigol's DS1000 and DS2000: rows are numbered, start and step of the clock stand in the second line.
///
/// Source: Rigol, MSO1000Z/DS1000Z Series User Guide, "Storage", CSV of the screen or the memory.
fn rigol(head: &[Line<'_>]) -> Option<Layout> {
    let delimiter = Delimiter::Sign(b',');
    let mut lines = head.iter().filter(|(_, line)| !line.trim_ascii().is_empty());
    let (header, names) = lines.next()?;
    let (_, units) = lines.next()?;
    let (first_row, _) = lines.next()?;
    let (names, units) = (cells(names, delimiter), cells(units, delimiter));
    let place = |name: &str| names.iter().position(|found| found == name);
    let value = |name: &str| number(units.get(place(name)?)?, false);
    let (start, interval) = (value("Start")?, value("Increment")?);
    if units.first().map(String::as_str) != Some("Sequence") || interval <= 0.0 {
        return None;
    }
    let columns = place("Start")?;
    let mut titles = vec![Title::parse("")];
    titles.extend((1..columns).map(|index| {
        titled(
            &names[index],
            units.get(index).map_or("", |unit| if unit.eq_ignore_ascii_case("volt") { "V" } else { unit }),
        )
    }));
    Some(Layout {
        delimiter,
        decimal_comma: false,
        shortest: titles.len(),
        titles,
        header: Some(*header),
        first_row: *first_row,
        segments: None,
        clock: Some(FileClock { start, interval }),
        remarks: Vec::new(),
    })
}

/// What stands above the titles, line by line.
fn above(head: &[Line<'_>], header: u64) -> Vec<String> {
    let lines = head.iter().filter(|(line, text)| *line < header && !text.starts_with(END));
    let texts = lines.map(|(_, text)| words(text).trim().replace('\t', " "));
    texts.filter(|text| !text.is_empty()).map(|text| text.chars().take(200).collect()).collect()
}
