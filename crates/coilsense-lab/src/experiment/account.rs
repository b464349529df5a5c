//! What is to be said of an experiment's processing: what was left out, what is missing, what does not fit.
//!
//! Next door: the processing itself (`outcome`).

use super::{Experiment, Run};

impl Experiment {
    /// What is to be said of the processing, a sentence each.
    pub fn account(&self) -> Vec<String> {
        let mut lines = Vec::new();
        let left_out: usize = self.runs.iter().map(|run| run.fast.left_out).sum();
        let samples: usize = self.runs.iter().map(|run| run.fast.output.samples).sum();
        lines.push(format!(
            "{samples} samples of {} run{}; {left_out} after the last whole period of a sine are left out.",
            self.runs.len(),
            if self.runs.len() == 1 { "" } else { "s" }
        ));
        match self.hits {
            0 => {}
            1 => lines.push(
                "One run of hits is not evaluated here: `coilsense identify` estimates the damping from it.".to_owned(),
            ),
            hits => lines.push(format!(
                "{hits} runs of hits are not evaluated here: `coilsense identify` estimates the damping from them."
            )),
        }
        if self.curve.is_none() {
            lines.push("No curve from inductance to length is given or measured: there is no F_L.".to_owned());
        }
        lines.extend(self.spec.notes.iter().map(|note| format!("{}: {note}.", self.spec.file)));
        lines.extend(self.frequencies());
        lines.extend(self.averaging());
        lines.extend(self.cleaned.iter().filter_map(|account| account.cleaning()));
        lines
    }

    /// Sines of which a mean of the LCR meter does not hold whole periods.
    fn averaging(&self) -> Option<String> {
        let window = self.spec.averaging?;
        let off = |run: &&Run| {
            let periods = window * run.spec.frequency;
            (periods - periods.round()).abs() > 0.02
        };
        let names: Vec<&str> =
            self.harmonics().map(|(_, run)| run).filter(off).map(|run| run.spec.name.as_str()).collect();
        (!names.is_empty()).then(|| {
            format!(
                "The LCR meter's {} ms do not hold whole periods in {}: F_L holds a part of a sine there.",
                1e3 * window,
                names.join(", ")
            )
        })
    }
}
