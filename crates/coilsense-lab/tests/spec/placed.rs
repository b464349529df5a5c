//! Where a refusal stands: at the line of the key whose value cannot be, whichever constructor of the science says so.
//!
//! The keys are the documented ones: one more of them is asked here by itself.

use coilsense_lab::spec::{Key, TABLES, Table};

use super::fixtures::{BY_GEOMETRY, BY_VALUES, read};
use super::hostile::full;

/// Numbers that a key does not take, or takes: below zero, nothing, and beyond every spring, to either side.
const NUMBERS: [&str; 5] = ["-1", "0", "-1e30", "1e30", "1e-30"];

/// A table of a spec: the line of its heading, those of its keys, and which documented one it is, of which kind.
struct Place {
    heading: usize,
    end: usize,
    table: &'static Table,
    kind: Option<String>,
}

fn places(lines: &[&str]) -> Vec<Place> {
    let is_heading = |line: &&str| line.starts_with('[');
    let headings = (0..lines.len()).filter(|&index| is_heading(&lines[index]));
    let place = |heading: usize| {
        let end = (heading + 1..lines.len()).find(|&index| is_heading(&lines[index])).unwrap_or(lines.len());
        let table = TABLES.into_iter().find(|table| table.heading() == lines[heading]).expect("a documented table");
        let kind = lines[heading..end].iter().find_map(|line| line.strip_prefix("kind = \"")?.strip_suffix('"'));
        let by_geometry = lines[heading..end].iter().any(|line| line.starts_with("wire_diameter"));
        let spring = if by_geometry { "by geometry" } else { "by values" };
        let kind = kind.or((table.name == "spring").then_some(spring)).map(str::to_owned);
        Place { heading, end, table, kind }
    };
    headings.map(place).collect()
}

/// The spec with a key of a table set, and the line, from 1, at which it stands.
fn with_key(lines: &[&str], place: &Place, key: &Key, value: &str) -> (String, usize) {
    let mut edited: Vec<String> = lines.iter().map(|line| (*line).to_owned()).collect();
    let written = format!("{} = {value}", key.name);
    let is_there = |index: &usize| lines[*index].split(" = ").next() == Some(key.name);
    let at = (place.heading + 1..place.end).find(is_there);
    match at {
        Some(index) => edited[index] = written,
        None => edited.insert(place.heading + 1, written),
    }
    (edited.join("\n"), at.unwrap_or(place.heading + 1) + 1)
}

/// An example with its first number replaced by another; none where it has no number, or is a name with one in it.
fn with_number(example: &str, number: &str) -> Option<String> {
    let start = example.find(|c: char| c.is_ascii_digit())?;
    let before = example[..start].trim_end_matches(['-', '+']);
    let rest = example[start..].trim_start_matches(|c: char| c.is_ascii_digit() || ['.', 'e'].contains(&c));
    before.trim_matches(['"', '[', ' ']).is_empty().then(|| format!("{before}{number}{rest}"))
}

/// Every documented number of every table of two specs that have each kind: what is refused, and where.
#[test]
fn a_number_that_cannot_be_is_refused_at_the_line_of_its_key() {
    let (mut asked, mut refused, mut astray) = (0, 0, Vec::new());
    for good in [BY_VALUES, BY_GEOMETRY].map(full) {
        let lines: Vec<&str> = good.lines().collect();
        for place in places(&lines) {
            for key in place.table.keys.iter().filter(|key| key.applies_to(place.kind.as_deref())) {
                if read(&with_key(&lines, &place, key, key.example).0).is_err() {
                    continue;
                }
                for value in NUMBERS.iter().filter_map(|number| with_number(key.example, number)) {
                    let (text, line) = with_key(&lines, &place, key, &value);
                    asked += 1;
                    let Err(message) = read(&text) else { continue };
                    refused += 1;
                    if !message.starts_with(&format!("S.toml:{line}: {} = ", key.name)) {
                        astray.push(format!("{} {} = {value} (line {line}): {message}", place.table.name, key.name));
                    }
                }
            }
        }
    }
    assert!(astray.is_empty(), "{} of {asked} astray:\n{}", astray.len(), astray.join("\n"));
    // Two thirds of them were when this was written; a table that nobody finds any more must not pass.
    assert!(3 * refused > 2 * asked && asked > 1000, "{refused} of {asked}");
}

/// What follows from several keys is no key's own; what compares two stands at the one that comes second.
#[test]
fn what_is_no_key_s_own_stands_at_its_table() {
    let wide = BY_GEOMETRY.replacen("coil_diameter = \"16 mm\"", "coil_diameter = \"1e10 mm\"", 1);
    let message = read(&wide).expect_err("a coil as large as a country");
    assert!(message.starts_with("S.toml:1: [spring]: stiffness must be from 1e-9"), "{message}");
    let long = BY_VALUES.replacen("min_length = \"196 mm\"", "min_length = \"300 mm\"", 1);
    let message = read(&long).expect_err("an empty range");
    assert!(
        message.starts_with("S.toml:10: max_length = \"264 mm\": max length must be above the min length"),
        "{message}"
    );
}

/// A parameter's name may be a key of several tables, and of two inputs it may mean two keys: of a chirp, `from` is a frequency, of a ramp
/// a time.
#[test]
fn a_parameter_s_name_means_the_key_of_its_own_table_and_kind() {
    let before = BY_VALUES.find("[[condition]]").expect("a condition");
    let line = BY_VALUES[..before].lines().count() + 3;
    for (kind, key, expected) in [
        ("sweep", "frequency = [\"1 Hz\", \"1e8 Hz\"]", "turns of the chirp must be at most 1e6"),
        ("sweep", "frequency = [\"1e10 Hz\", \"0 Hz\"]", "first frequency must be at most 1e9"),
        ("ramp", "amplitude = \"1e13 mm\"\nrise_time = \"1 s\"", "height must be at most 1e9"),
        ("step", "amplitude = \"1e13 mm\"", "height must be at most 1e9"),
        // `length` is a key of the condition alone, its parameter `mean_length`; a spring's `rest_length` is another one.
        ("impact", "length = \"1e13 mm\"\nvelocity = \"1 m/s\"", "mean length must be from 1e-9 to 1e9 m"),
    ] {
        let amplitude = if kind == "sweep" { "amplitude = \"1 mm\"\n" } else { "" };
        let text = format!("{}[[condition]]\nkind = \"{kind}\"\n{key}\n{amplitude}", &BY_VALUES[..before]);
        let message = read(&text).expect_err(key);
        let first = key.lines().next().expect("a line");
        assert!(message.starts_with(&format!("S.toml:{line}: {first}: {expected}")), "{message}");
    }
}
