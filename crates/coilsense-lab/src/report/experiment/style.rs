//! What all figures of an experiment share: their width, and the mark of simulated data.
//!
//! Next door: the figures themselves (`figures`, `means`).

use crate::experiment::Experiment;

/// Width of a figure \[px\].
pub(super) const WIDTH: f64 = 760.0;

/// What every figure of simulated data says on its face.
pub(super) fn marked(experiment: &Experiment, title: &str) -> String {
    match (experiment.simulated, title.is_empty()) {
        (false, _) => title.to_owned(),
        (true, true) => "simulated data".to_owned(),
        (true, false) => format!("{title}, simulated data"),
    }
}
