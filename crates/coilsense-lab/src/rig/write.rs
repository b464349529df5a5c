//! The files of a rig.
//!
//! Next door: what is in them (`log`, `description`), how they come to disk whole (`crate::output`).

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use super::{Rig, RigError};
use crate::analysis::Progress;
use crate::output::Output;

impl Rig {
    /// Lets every run run and adds its files and `experiment.toml`; returns how many rows they have.
    ///
    /// # Errors
    /// [`RigError`] of the first run that cannot be, where a file cannot be written, or where `progress` says stop.
    pub fn write(&self, output: &mut Output, progress: &Progress<'_>) -> Result<usize, RigError> {
        let (count, done) = (self.runs.len(), AtomicUsize::new(0));
        let numbers: Vec<usize> = (0..count).collect();
        let mut rows = 0;
        // As many at a time as there are threads, so that not all of them lie in memory.
        for together in numbers.chunks(rayon::current_num_threads().max(1)) {
            let files: Vec<_> = together
                .par_iter()
                .map(|&number| {
                    if !progress(done.load(Ordering::Relaxed), count) {
                        return Err(RigError::Interrupted);
                    }
                    let files = self.files(number)?;
                    match progress(done.fetch_add(1, Ordering::Relaxed) + 1, count) {
                        true => Ok(files),
                        false => Err(RigError::Interrupted),
                    }
                })
                .collect();
            // In order, so that of several faults it is always the first run's that is told.
            for run in files {
                let run = run?;
                rows += run.rows;
                for (name, text) in run.texts {
                    output.add(&name, text.as_bytes())?;
                }
            }
        }
        output.add("experiment.toml", self.description().as_bytes())?;
        Ok(rows)
    }

    /// The two files of a run.
    fn files(&self, number: usize) -> Result<Files, RigError> {
        let log = self.log(number)?;
        let run = &self.runs[number];
        let texts = [
            (format!("{}-fast.csv", run.name), log.fast.csv(&self.fast_comments(run))),
            (format!("{}-slow.csv", run.name), log.slow.csv(&self.slow_comments(run))),
        ];
        Ok(Files { rows: log.fast.rows() + log.slow.rows(), texts })
    }
}

/// Names and texts of a run's files.
struct Files {
    rows: usize,
    texts: [(String, String); 2],
}
