//! Wall time of one call: the median of many, after one to warm up.

use std::hint::black_box;
use std::time::{Duration, Instant};

use crate::Failure;

/// One row of the table.
pub struct Measurement {
    setting: &'static str,
    elapsed: Elapsed,
    /// None where there is nothing to compare with.
    max_rel_error: Option<f64>,
}

/// Median time of a call, and over how many.
pub struct Elapsed {
    median_ms: f64,
    runs: usize,
}

impl Measurement {
    pub fn new(setting: &'static str, elapsed: Elapsed, max_rel_error: f64) -> Self {
        Self { setting, elapsed, max_rel_error: Some(max_rel_error) }
    }

    /// Of time only.
    pub fn timed(setting: &'static str, elapsed: Elapsed) -> Self {
        Self { setting, elapsed, max_rel_error: None }
    }

    /// The row as JSON.
    pub fn json(&self, job: &str, path: &str) -> Result<String, Failure> {
        let row = serde_json::json!({
            "job": job,
            "system": "coilsense",
            "setting": format!("{}, {path}", self.setting),
            "median_ms": self.elapsed.median_ms,
            "max_rel_error": self.max_rel_error,
            "note": format!("{} runs", self.elapsed.runs),
        });
        Ok(serde_json::to_string(&row)?)
    }
}

/// Calls `work` at least five times and for up to two seconds; gives the median time and the last result.
pub fn measure<T>(mut work: impl FnMut() -> Result<T, coilsense::Error>) -> (Elapsed, Result<T, coilsense::Error>) {
    let mut last = work();
    let mut times = Vec::new();
    let begun = Instant::now();
    while times.len() < 5 || begun.elapsed() < Duration::from_secs(2) && times.len() < 2000 {
        let start = Instant::now();
        last = black_box(work());
        times.push(1e3 * start.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    (Elapsed { median_ms: times[times.len() / 2], runs: times.len() }, last)
}

/// Calls two works in turn, five hundred times after one to warm up; the median time of each. What slows the machine for a while slows both.
pub fn alternately<T>(
    mut work: impl FnMut(usize) -> Result<T, coilsense::Error>,
) -> Result<[Elapsed; 2], coilsense::Error> {
    let mut times = [Vec::new(), Vec::new()];
    for run in 0..501 {
        for (which, times) in times.iter_mut().enumerate() {
            let start = Instant::now();
            black_box(work(which)?);
            if run > 0 {
                times.push(1e3 * start.elapsed().as_secs_f64());
            }
        }
    }
    Ok(times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        Elapsed { median_ms: times[times.len() / 2], runs: times.len() }
    }))
}
