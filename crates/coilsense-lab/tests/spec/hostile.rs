//! Specs that nobody would write: whatever is sent, the reader answers in one line or takes it, and what it takes can be simulated.

use coilsense_lab::analysis::simulate;
use coilsense_lab::spec::{Spec, TABLES};
use proptest::prelude::*;

use super::fixtures::{BY_GEOMETRY, BY_VALUES, read};

/// A spec with everything in it: each kind of condition and of sensor.
pub fn full(good: &str) -> String {
    let start = good.find("[[condition]]").expect("a condition");
    // As many masses as are needed take time, for thousands of specs too much of it.
    let spring = good[..start].replacen("\nmax_length", "\nmasses_per_winding = 1\nmax_length", 1);
    format!("{spring}{EVERYTHING}")
}

const EVERYTHING: &str = r#"[[condition]]
kind = "impact"
velocity = "0.25 m/s"
length = "25 %"
[[condition]]
kind = "end-stop"
at = "max"
profile = "uniform"
[[condition]]
kind = "harmonic"
frequency = "0.5 f1"
amplitude = "1 %"
phase = "-90 deg"
start = "massless"
[[condition]]
kind = "sweep"
frequency = ["5 Hz", "1.2 f1"]
amplitude = "1 %"
[[condition]]
kind = "step"
amplitude = "1 %"
begin = "1 ms"
end = 2
[[condition]]
kind = "ramp"
amplitude = "1 mm"
rise_time = "2 ms"
[[condition]]
kind = "pulse"
amplitude = "1 mm"
width = "2 ms"
[[condition]]
kind = "recorded"
file = "road.csv"
duration = "0.3 s"
window = ["0.1 s", "0.2 s"]
sample_rate = "1 kHz"
[[sensor]]
kind = "load-cell"
end = 1
bandwidth = "1 kHz"
order = 3
delay = "1 ms"
noise = "0.1 %"
accuracy_full_scale = "1 N"
[[sensor]]
kind = "deflection"
class = "optical linear encoder"
averaging = "1 ms"
resolution = "10 um"
temperature_coefficient = "0.01 %/K"
[[sensor]]
kind = "two-encoder"
compliance = "2 um/N"
backlash = "20 um"
sample_rate = "1 kHz"
[[sensor]]
kind = "inductance"
calibration = "theory"
calibration_form = "2 %"
range = "1 uH"
accuracy_reading = "0.1 %"
[goal]
error = "1 %"
force = "F_i"
bandwidth = "20 Hz"
[uncertainty]
coverage = "95 %"
trials = 1000
seed = 3
temperature_change = "5 K"
[control]
drive = "force"
motor_mass = "2 kg"
controller = "PID"
delay = "1 ms"
sample_time = "0.5 ms"
load_mass = "1 kg"
"#;

/// Values that make trouble.
const VALUES: &[&str] = &[
    "true",
    "0",
    "-1",
    "1e308",
    "-1e308",
    "nan",
    "inf",
    "9223372036854775807",
    "0x7fff",
    "52.5",
    "1.5",
    "99999",
    "[]",
    "[[]]",
    "[0.0, 10]",
    "{}",
    "{ a = 1 }",
    "\"\"",
    "\"held\"",
    "\"mass\"",
    "\"force\"",
    "\"min\"",
    "\"linear\"",
    "\"0 mm\"",
    "\"nan m\"",
    "\"1e9 m\"",
    "\"1e-9 m\"",
    "\"-1 mm\"",
    "\"1e400 m\"",
    "\"1e-400 m\"",
    "\"1e99999999999 m\"",
    "\"1 mm\"",
    "\"2 m\"",
    "\"10 %\"",
    "\"-1e9 %\"",
    "\"100 %\"",
    "\"1e9 Hz\"",
    "\"1e-9 Hz\"",
    "\"1 kHz\"",
    "\"1e5 f1\"",
    "\"1e-5 f1\"",
    "\"1e9 N\"",
    "\"1e-9 N\"",
    "\"1e9 m/s\"",
    "\"1e-9 kg\"",
    "\"1e9 kg\"",
    "\"1e9 N/m\"",
    "\"1e-9 N/m\"",
    "\"1e9 s\"",
    "\"1e-9 s\"",
    "\"5 ms\"",
    "\"1e-7 s\"",
    "\"1e9 1/s\"",
    "\"100 1/s\"",
    "\"1e9 m/N\"",
    "\"1e300 rad\"",
    "\"1e-300 H\"",
    "\"1 nH\"",
    "\"1e13 Pa\"",
    "\"1 Pa\"",
    "[\"0 s\", \"1 s\"]",
    "[\"0 Hz\", \"1e9 Hz\"]",
    "[\"1e-9 f1\", \"0 Hz\"]",
    "[\"nan s\", \"inf s\"]",
    "\"é\u{202e}漢\u{1F980}\"",
    "\"..\"",
    "\"/\"",
    "\"\\u0000\"",
    "1979-05-27",
    "'''a\nb'''",
    "\"\"\"a\nb\"\"\"",
    "\"holds \"",
    "\"holds time [s],u1 [m];0,1;1,2\"",
    "\"holds time [s],u1 [mm],u2 [mm];0,1,1;1e-9,2,2;1e9,0,0\"",
];

/// Simulates what was taken, of each condition some tens of samples at the start.
fn run(mut spec: Spec) {
    spec.conditions.truncate(8);
    spec.mount.cases.truncate(2);
    for condition in &mut spec.conditions {
        let most = if spec.spring.spring.inductance_windings() > 2000.0 { 8.0 } else { 40.0 };
        condition.duration = condition.duration.min(most / condition.sample_rate);
        condition.window = (0.0, condition.duration);
    }
    match simulate(&spec, &|_, _| true) {
        Ok(cases) => assert_eq!(cases.len(), spec.conditions.len() * spec.mount.cases.len()),
        Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
    }
}

fn check(text: &str) {
    if let Ok(spec) = read(text) {
        run(spec);
    }
}

#[test]
fn the_full_specs_are_taken() {
    for good in [BY_VALUES, BY_GEOMETRY] {
        run(read(&full(good)).unwrap());
    }
}

/// Every key with one in so many of the values: with another share of them at each key.
fn each_key_with_one_value_in(so_many: usize) {
    for good in [BY_VALUES, BY_GEOMETRY].map(full) {
        let lines: Vec<&str> = good.lines().collect();
        for (place, line) in lines.iter().enumerate() {
            let Some((key, _)) = line.split_once(" = ") else { continue };
            for value in VALUES.iter().skip(place % so_many).step_by(so_many) {
                let changed = format!("{key} = {value}");
                let mut edited = lines.clone();
                edited[place] = &changed;
                check(&edited.join("\n"));
            }
        }
    }
}

#[test]
fn every_key_takes_or_refuses_a_third_of_the_hostile_values() {
    each_key_with_one_value_in(3);
}

#[test]
#[ignore = "some minutes in a test build; `cargo xtask test --long` runs it"]
fn every_key_takes_or_refuses_every_hostile_value() {
    each_key_with_one_value_in(1);
}

/// A line with its number, a quantity or a pure one, times a factor; others as they are.
fn scaled(line: &str, factor: f64) -> String {
    let grown = || {
        let (key, value) = line.split_once(" = ")?;
        let (quote, value) = value.strip_prefix('"').map_or(("", value), |value| ("\"", value));
        let (number, rest) = value.split_at(value.find([' ', '"']).unwrap_or(value.len()));
        Some(format!("{key} = {quote}{}{rest}", number.parse::<f64>().ok()? * factor))
    };
    grown().unwrap_or_else(|| line.to_owned())
}

/// An edit of a text: where, of how much, and what comes there.
fn edited(good: &str, (at, length, with): &(usize, usize, Vec<u8>)) -> Vec<u8> {
    let bytes = good.as_bytes();
    let at = at % bytes.len();
    let end = (at + length).min(bytes.len());
    [&bytes[..at], with, &bytes[end..]].concat()
}

fn any_value() -> impl Strategy<Value = String> {
    let hostile = proptest::sample::select(VALUES).prop_map(str::to_owned);
    const UNITS: &[&str] =
        &["m", "mm", "kg", "N", "s", "Hz", "f1", "%", "N/m", "m/s", "deg", "K", "H", "Pa", "kg/m3", "1/K"];
    let quantity = (any::<f64>(), proptest::sample::select(UNITS)).prop_map(|(v, unit)| format!("\"{v:e} {unit}\""));
    let tame = (1e-3..1e3_f64, proptest::sample::select(UNITS)).prop_map(|(v, unit)| format!("\"{v} {unit}\""));
    prop_oneof![3 => hostile, 2 => quantity, 3 => tame, 1 => (0.1..200.0_f64).prop_map(|v| v.to_string()), 1 => "\"[^\"\\\\]{0,300}\""]
}

/// A table of a spec with any of its keys set to anything.
fn any_table() -> impl Strategy<Value = String> {
    let table = proptest::sample::select(&TABLES[..]);
    (table, proptest::collection::vec((any::<prop::sample::Index>(), any_value()), 0..8)).prop_map(|(table, keys)| {
        let lines = keys.iter().map(|(index, value)| format!("{} = {value}\n", index.get(table.keys).name));
        format!("{}\n{}", table.heading(), lines.collect::<String>())
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn no_edit_of_a_good_spec_makes_the_reader_panic(
        geometry: bool,
        edits in proptest::collection::vec((any::<usize>(), 0_usize..12, proptest::collection::vec(any::<u8>(), 0..6)), 1..4),
    ) {
        let mut text = full(if geometry { BY_GEOMETRY } else { BY_VALUES });
        for edit in &edits {
            text = String::from_utf8_lossy(&edited(&text, edit)).into_owned();
        }
        check(&text);
    }

    #[test]
    fn no_change_of_digits_makes_the_simulation_panic(
        geometry: bool,
        edits in proptest::collection::vec((any::<usize>(), "[0-9]{0,3}|-|\\.|e[0-9]"), 1..4),
    ) {
        let mut text = full(if geometry { BY_GEOMETRY } else { BY_VALUES });
        for (at, with) in &edits {
            let digits: Vec<usize> = text.char_indices().filter(|(_, c)| c.is_ascii_digit()).map(|(at, _)| at).collect();
            if let Some(&at) = digits.get(at % digits.len().max(1)) {
                text.replace_range(at..at + 1, with);
            }
        }
        check(&text);
    }

    #[test]
    fn no_size_of_a_value_makes_the_simulation_panic(
        geometry: bool,
        grown in proptest::collection::vec((any::<prop::sample::Index>(), -3.0..3.0_f64), 1..8),
    ) {
        let text = full(if geometry { BY_GEOMETRY } else { BY_VALUES });
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        for (place, decades) in &grown {
            let place = place.index(lines.len());
            lines[place] = scaled(&lines[place], 10_f64.powf(*decades));
        }
        check(&lines.join("\n"));
    }

    #[test]
    fn lines_may_be_swapped_doubled_and_left_out(
        geometry: bool,
        moves in proptest::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>(), 0..4), 1..6),
    ) {
        let text = full(if geometry { BY_GEOMETRY } else { BY_VALUES });
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        for (one, other, how) in &moves {
            let (one, other) = (one.index(lines.len()), other.index(lines.len()));
            match how {
                0 => lines.swap(one, other),
                1 => lines.insert(other, lines[one].clone()),
                2 => drop(lines.remove(one)),
                _ => {
                    // The value of one key for another.
                    let value = lines[other].split_once(" = ").map(|(_, value)| value.to_owned());
                    if let (Some((key, _)), Some(value)) = (lines[one].clone().split_once(" = "), value) {
                        lines[one] = format!("{key} = {value}");
                    }
                }
            }
        }
        check(&lines.join("\n"));
    }

    #[test]
    fn no_tree_of_known_keys_makes_the_reader_panic(tables in proptest::collection::vec(any_table(), 0..8), whole: bool) {
        let start = if whole { BY_VALUES.split("\n\n").next().unwrap_or_default() } else { "" };
        check(&format!("{start}\n{}", tables.concat()));
    }

    #[test]
    fn one_more_key_of_any_value_is_taken_or_refused(
        geometry: bool,
        extra in proptest::collection::vec((any::<prop::sample::Index>(), any_value()), 1..3),
    ) {
        let text = full(if geometry { BY_GEOMETRY } else { BY_VALUES });
        let keys: Vec<String> = extra.iter().map(|(key, value)| format!("{} = {value}\n", key.get(TABLES[0].keys).name)).collect();
        let kept = |line: &&str| !keys.iter().any(|key| key.split(" = ").next() == line.split(" = ").next());
        let lines: Vec<&str> = text.lines().filter(kept).collect();
        check(&lines.join("\n").replacen("[spring]\n", &format!("[spring]\n{}", keys.concat()), 1));
    }
}
