//! What makes two plans one sweep: values count, not how they are written down or what their file is called.
//!
//! A spec counts by its keys and their values: comments, spaces, the order of keys and how a number is written (`1`, `1.0`, `0x1`) do not. A text
//! counts letter by letter, so that "104 mm" and "0.104 m" are two: their last digits may differ. Whatever else a plan says counts as it is given.
//!
//! Next door: the plan (`plan`), the file that holds its digest (`manifest`).

use std::collections::BTreeMap;
use std::fmt::Write;

use serde::Serialize;
use sha2::{Digest, Sha256};
use toml::de::{DeTable, DeValue};

use super::catalogue::Catalogue;
use super::plan::{Plan, PlanParameters};
use super::sampling::Sampling;

/// All that decides the rows of a sweep.
#[derive(Serialize)]
struct Identity<'a> {
    /// Of coilsense: what a plan leaves open may be filled in otherwise by another.
    version: &'a str,
    /// As [`canonical`] has it.
    spec: String,
    files: &'a BTreeMap<String, String>,
    over: &'a [String],
    catalogue: Option<&'a Catalogue>,
    sampling: Option<Sampling>,
    rows: Option<u64>,
    seed: u64,
    columns: &'a [String],
    chunk_rows: Option<u64>,
}

impl Plan {
    /// SHA-256 of all that decides the rows, in hexadecimal digits. A spec counts by its keys and their values, not by its name, its comments or the
    /// order of its keys; the version of coilsense counts, too.
    pub fn digest(&self) -> String {
        self.digest.get_or_init(|| self.digest_of(env!("CARGO_PKG_VERSION"))).clone()
    }

    /// The same as another version of coilsense would have it.
    pub(super) fn digest_of(&self, version: &str) -> String {
        let PlanParameters { spec, files, over, catalogue, sampling, rows, seed, columns, chunk_rows, spec_file: _ } =
            self.parameters();
        let identity = Identity {
            version,
            spec: canonical(spec),
            files,
            over,
            catalogue: catalogue.as_ref(),
            sampling: *sampling,
            rows: *rows,
            seed: *seed,
            columns,
            chunk_rows: *chunk_rows,
        };
        // Texts and whole numbers can always be written.
        hexadecimal(Sha256::digest(serde_json::to_vec(&identity).unwrap_or_default()))
    }
}

/// Bytes in hexadecimal digits.
pub(super) fn hexadecimal(bytes: impl AsRef<[u8]>) -> String {
    bytes.as_ref().iter().fold(String::new(), |mut text, byte| {
        // A text takes whatever is written to it.
        let _ = write!(text, "{byte:02x}");
        text
    })
}

/// A spec's keys and values, keys in the order of their letters; a text that is no TOML as it is.
pub(super) fn canonical(spec: &str) -> String {
    let mut text = String::with_capacity(spec.len());
    match DeTable::parse(spec) {
        Ok(table) => of_table(table.get_ref(), &mut text),
        Err(_) => text.push_str(spec),
    }
    text
}

fn of_table(table: &DeTable<'_>, text: &mut String) {
    let mut entries: Vec<(&str, &DeValue<'_>)> =
        table.iter().map(|(key, value)| (key.get_ref().as_ref(), value.get_ref())).collect();
    entries.sort_by_key(|(key, _)| *key);
    text.push('{');
    for (key, value) in entries {
        text.push_str(&format!("{key:?}:"));
        of_value(value, text);
        text.push(',');
    }
    text.push('}');
}

fn of_value(value: &DeValue<'_>, text: &mut String) {
    match value {
        DeValue::String(word) => text.push_str(&format!("{word:?}")),
        DeValue::Integer(number) => {
            let read = i128::from_str_radix(number.as_str(), number.radix());
            text.push_str(&read.map_or_else(|_| number.as_str().to_owned(), |number| number.to_string()));
        }
        DeValue::Float(number) => text.push_str(&of_number(number.as_str())),
        DeValue::Boolean(truth) => text.push_str(&truth.to_string()),
        DeValue::Datetime(time) => text.push_str(&format!("@{time}")),
        DeValue::Array(values) => {
            text.push('[');
            for value in values.iter() {
                of_value(value.get_ref(), text);
                text.push(',');
            }
            text.push(']');
        }
        DeValue::Table(table) => of_table(table, text),
    }
}

/// A number with a point or an exponent: as a whole number where it is one that no two numbers share.
fn of_number(written: &str) -> String {
    const WHOLE: f64 = 9_007_199_254_740_992.0; // 2⁵³
    match written.parse::<f64>() {
        Ok(number) if number == 0.0 && number.is_sign_negative() => "-0.0".to_owned(),
        Ok(number) if number.fract() == 0.0 && number.abs() < WHOLE => (number as i64).to_string(),
        Ok(number) => format!("{number:?}"),
        Err(_) => written.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::canonical;

    const SPEC: &str = "a = 1\nb = \"104 mm\"\n[t]\nc = [1.5, 2]\n[[s]]\nd = 1\n[[s]]\nd = 2\n";

    #[test]
    fn what_is_only_written_otherwise_is_the_same() {
        for same in [
            "# said\nb = '104 mm' # here\na = 1.0\n[[s]]\nd = 1\n[[s]]\nd = 0x2\n[t]\nc=[ 1.50 , 2.0, ]\n",
            "a = 1_0e-1\nb = \"\\u0031\\u00304 mm\"\ns = [{d = 1}, {d = 2}]\nt = {c = [15e-1, 2]}\r\n",
            "a = 1\nb = \"104 mm\"\nt.c = [1.5, 2]\n[[s]]\nd = 1\n[[s]]\nd = 2",
        ] {
            assert_eq!(canonical(same), canonical(SPEC), "{same}");
        }
    }

    #[test]
    fn what_may_mean_something_else_differs() {
        for (from, to) in [
            ("a = 1", "a = 2"),
            ("a = 1", "a = \"1\""),
            ("a = 1", "a = true"),
            ("a = 1", "a = 1.0000000000000002"),
            ("a = 1", "A = 1"),
            ("a = 1", "a = [1]"),
            ("a = 1\n", ""),
            ("a = 1", "a = 0.0"),
            ("104 mm", "0.104 m"),
            ("104 mm", "104mm"),
            ("[1.5, 2]", "[2, 1.5]"),
            ("[1.5, 2]", "[1.5, 2, 2]"),
            ("d = 1\n[[s]]\nd = 2", "d = 2\n[[s]]\nd = 1"),
            ("[t]", "[u]"),
        ] {
            let other = SPEC.replacen(from, to, 1);
            assert_ne!(other, SPEC);
            assert_ne!(canonical(&other), canonical(SPEC), "{from} and {to}");
        }
        assert_ne!(canonical("a = 0.0"), canonical("a = -0.0"));
        assert_ne!(canonical("a = 9007199254740993"), canonical("a = 9007199254740992.0"));
        assert_ne!(canonical("a = 1979-05-27"), canonical("a = \"1979-05-27\""));
        // What is no TOML counts by its letters.
        assert_ne!(canonical("a = "), canonical("a =  "));
    }
}
