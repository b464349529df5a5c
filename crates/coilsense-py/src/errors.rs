//! Exceptions: `coilsense.Error` is a `ValueError`, and each kind of input has a subclass; the text is Rust's, with options as
//! arguments.
//!
//! Next door: `TypeError`, which PyO3 raises by itself with the argument's name, and `series` for arrays.

use coilsense_lab::message::{Door, Message};
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
    "Why a spec cannot be processed.\n\nThe text names the spec's file, the condition and the damping, and says what the science says."
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
            coilsense_lab::report::ReportError::Output(error) => OutputError::new_err(in_python(error)),
            other => Error::new_err(other.to_string()),
        })
    }
}

impl<T> IntoPython<T> for Result<T, coilsense_lab::recording::RecordingError> {
    fn python(self) -> PyResult<T> {
        self.map_err(|error| LogError::new_err(in_python(error)))
    }
}

impl<T> IntoPython<T> for Result<T, coilsense_lab::stored::StoredError> {
    fn python(self) -> PyResult<T> {
        self.map_err(|error| Error::new_err(error.to_string()))
    }
}

impl<T> IntoPython<T> for Result<T, coilsense_lab::calibration::CalibrationError> {
    fn python(self) -> PyResult<T> {
        self.map_err(|error| Error::new_err(in_python(error)))
    }
}

impl<T> IntoPython<T> for Result<T, coilsense_lab::identification::IdentificationError> {
    fn python(self) -> PyResult<T> {
        self.map_err(|error| Error::new_err(in_python(error)))
    }
}

impl<T> IntoPython<T> for Result<T, coilsense_lab::experiment::ExperimentError> {
    fn python(self) -> PyResult<T> {
        self.map_err(|error| Error::new_err(in_python(error)))
    }
}

impl<T> IntoPython<T> for Result<T, coilsense_lab::sweep::SweepError> {
    fn python(self) -> PyResult<T> {
        self.map_err(|error| SweepError::new_err(in_python(error)))
    }
}

/// The text of an error, with options as arguments.
pub fn in_python(error: impl Into<Message>) -> String {
    error.into().told(Door::Python)
}

/// An exception with the text of an error that has no subclass of its own and advises no option.
pub fn refused(error: impl std::fmt::Display) -> PyErr {
    Error::new_err(error.to_string())
}

/// An exception for a word that is none of those that are known.
pub fn unknown(quantity: &str, known: &[&str], word: &str) -> PyErr {
    Error::new_err(format!("{quantity} must be one of {}, got {word:?}", known.join(", ")))
}
