//! Exceptions: `coilsense.Error` is a `ValueError`, and each kind of input has a subclass; the text is Rust's.
//!
//! Next door: `TypeError`, which PyO3 raises by itself with the argument's name, and `series` for arrays.

use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

create_exception!(
    coilsense,
    Error,
    PyValueError,
    "An input that coilsense cannot take.\n\n\
     The text names the quantity, its value and unit, and what is allowed. Every other exception of coilsense is a subclass."
);
create_exception!(
    coilsense,
    SpecError,
    Error,
    "A spec that cannot be used.\n\nThe text is one line that names file, line, key, value and what is allowed."
);
create_exception!(
    coilsense,
    LogError,
    Error,
    "A log that cannot be used.\n\nThe text is one line that names file, line, column, what is there and what would do."
);
create_exception!(
    coilsense,
    SweepError,
    Error,
    "A sweep that cannot be.\n\nThe text is one line that names the key, the file or the folder, the value and what is allowed."
);

create_exception!(
    coilsense,
    AnalysisError,
    Error,
    "Why a spec cannot be worked off.\n\nThe text names the spec's file, the condition and the damping, and says what the science says."
);
create_exception!(
    coilsense,
    OutputError,
    Error,
    "Files that cannot be written.\n\nThe text names the path; what was there before is still there."
);

/// What of Rust's errors becomes which exception.
pub trait IntoPython<T> {
    /// The value, or the exception with the error's text.
    fn python(self) -> PyResult<T>;
}

impl<T> IntoPython<T> for Result<T, coilsense::Error> {
    fn python(self) -> PyResult<T> {
        self.map_err(|error| Error::new_err(error.to_string()))
    }
}

impl<T> IntoPython<T> for Result<T, coilsense_lab::spec::SpecError> {
    fn python(self) -> PyResult<T> {
        self.map_err(|error| SpecError::new_err(error.to_string()))
    }
}

impl<T> IntoPython<T> for Result<T, coilsense_lab::analysis::AnalysisError> {
    fn python(self) -> PyResult<T> {
        self.map_err(|error| AnalysisError::new_err(error.to_string()))
    }
}

impl<T> IntoPython<T> for Result<T, coilsense_lab::report::ReportError> {
    fn python(self) -> PyResult<T> {
        self.map_err(|error| match error {
            coilsense_lab::report::ReportError::Output(error) => OutputError::new_err(error.to_string()),
            other => Error::new_err(other.to_string()),
        })
    }
}

impl<T> IntoPython<T> for Result<T, coilsense_lab::recording::RecordingError> {
    fn python(self) -> PyResult<T> {
        self.map_err(|error| LogError::new_err(in_python(&error.to_string())))
    }
}

/// An exception with the text of an error that has no subclass of its own.
pub fn refused(error: impl std::fmt::Display) -> PyErr {
    Error::new_err(in_python(&error.to_string()))
}

/// What the command calls an option, and what it is here.
const OPTIONS: [(&str, &str); 20] = [
    ("--mass, --spec", "mass=, spring="),
    ("--drop-incomplete", "drop_incomplete=True"),
    ("--merge-repeated", "merge_repeated=True"),
    ("--sort", "sort=True"),
    ("--fill-gaps ", "fill_gaps="),
    ("--resample ", "resample="),
    ("--sample-rate", "sample_rate="),
    ("--length-at-zero", "length_at_zero="),
    ("--preset ", "preset="),
    ("--clock ", "clock="),
    ("--from", "from_="),
    ("--to", "to="),
    ("--over KEY=VALUES", "over"),
    ("--over", "over"),
    ("--catalogue FILE", "catalogue"),
    ("--sampling", "sampling"),
    ("--rows", "rows"),
    ("--seed", "seed"),
    ("--columns", "columns"),
    ("--chunk", "chunk"),
];

/// A text with an option replaced where it stands by itself: what only looks like it, as in the name of a file `run--torque.csv`, stays.
fn replaced(text: &str, option: &str, argument: &str) -> String {
    let of_a_word = |c: char| c.is_alphanumeric() || ['-', '_', '/', '\\'].contains(&c);
    let goes_on = |after: &str| {
        let after = after.strip_prefix('.').unwrap_or(after);
        after.starts_with(of_a_word)
    };
    let (mut made, mut rest) = (String::with_capacity(text.len()), text);
    while let Some(place) = rest.find(option) {
        let (before, after) = (&rest[..place], &rest[place + option.len()..]);
        // Before it may stand what was looked at already.
        let begins = !before.chars().next_back().or_else(|| made.chars().next_back()).is_some_and(of_a_word);
        let ends = option.ends_with(' ') || !goes_on(after);
        made.push_str(before);
        made.push_str(if begins && ends { argument } else { option });
        rest = after;
    }
    made + rest
}

/// A message that names options of the command, with the arguments of Python in their place.
pub fn in_python(message: &str) -> String {
    let named = OPTIONS.iter().fold(message.to_owned(), |text, (option, argument)| replaced(&text, option, argument));
    // `--column F_o="title [N]"` is an entry of a dict.
    match named.split_once("--column ") {
        Some((before, rest)) => match rest.split_once('=') {
            Some((channel, title)) if !channel.contains(['"', ' ']) => {
                format!("{before}columns={{{channel:?}: {title}}}")
            }
            _ => format!("{before}columns: {rest}"),
        },
        None => named,
    }
}

impl<T> IntoPython<T> for Result<T, coilsense_lab::sweep::SweepError> {
    fn python(self) -> PyResult<T> {
        self.map_err(|error| SweepError::new_err(in_python(&error.to_string())))
    }
}

/// An exception for a word that is none of those that are known.
pub fn unknown(quantity: &str, known: &[&str], word: &str) -> PyErr {
    Error::new_err(format!("{quantity} must be one of {}, got {word:?}", known.join(", ")))
}
