//! The clock, and one JSON line per measurement. Which peers may be too slow to run is known here as well.

use std::collections::HashMap;
use std::time::Instant;

use serde::Serialize;

/// A run expected to last longer is not made \[s\].
const PATIENCE: f64 = 20.0;
/// Time given to the runs of one row \[s\], and the shortest run of which fewer than five will do.
const SHARE: f64 = 2.0;
const LONG_RUN: f64 = SHARE / 5.0;
const MOST_RUNS: usize = 1000;

/// One line on stdout.
#[derive(Serialize)]
struct Row<'a> {
    job: &'a str,
    system: &'a str,
    setting: &'a str,
    median_ms: Option<f64>,
    max_rel_error: Option<f64>,
    note: String,
}

/// What is measured: the job's name and the peer's.
#[derive(Clone, Copy)]
pub struct Label<'a> {
    pub job: &'a str,
    pub system: &'a str,
    pub setting: &'a str,
}

pub struct Bench {
    only: Option<String>,
    /// Last duration \[s\] and size of a peer in jobs that differ by their size alone, `impact` and `impact-500`.
    seen: HashMap<String, (f64, usize)>,
}

impl Bench {
    pub fn new(only: Option<String>) -> Self {
        Self { only, seen: HashMap::new() }
    }

    /// Times `solve`, judges its last answer by `error`, prints the row.
    ///
    /// `size` is N, in which the peer's time grows with the power `growth`.
    pub fn row<T>(
        &mut self,
        label: Label<'_>,
        (size, growth): (usize, i32),
        mut solve: impl FnMut() -> anyhow::Result<T>,
        error: impl FnOnce(&T) -> f64,
        remark: &str,
    ) {
        if !self.wanted(label) {
            return;
        }
        eprintln!("{} {} {}", label.job, label.system, label.setting);
        let family = label.job.trim_end_matches(|end: char| end == '-' || end.is_ascii_digit());
        let key = format!("{} {} {family}", label.system, label.setting);
        if let Some((seconds, before)) = self.seen.get(&key) {
            let expected = seconds * (size as f64 / *before as f64).powi(growth);
            if expected > PATIENCE {
                let note = format!("skipped: about {expected:.0} s expected, from N = {before} and time as N^{growth}");
                return print(label, None, None, note);
            }
        }
        match timed(&mut solve) {
            Ok((seconds, runs, answer)) => {
                self.seen.insert(key, (seconds, size));
                let plural = if runs == 1 { "run" } else { "runs" };
                let note = format!("{runs} {plural}{}{remark}", if remark.is_empty() { "" } else { "; " });
                print(label, Some(1e3 * seconds), Some(error(&answer)), note);
            }
            Err(failure) => print(label, None, None, format!("failed: {failure:#}")),
        }
    }

    fn wanted(&self, label: Label<'_>) -> bool {
        let matches =
            |word: &String| [label.job, label.system, label.setting].iter().any(|part| part.contains(word.as_str()));
        self.only.as_ref().is_none_or(matches)
    }
}

/// Median duration \[s\], number of runs, last answer.
fn timed<T>(solve: &mut impl FnMut() -> anyhow::Result<T>) -> anyhow::Result<(f64, usize, T)> {
    let mut once = || {
        let begun = Instant::now();
        let answer = solve()?;
        anyhow::Ok((begun.elapsed().as_secs_f64(), answer))
    };
    let (warm_up, mut answer) = once()?;
    if warm_up > SHARE {
        return Ok((warm_up, 1, answer));
    }
    let least = if warm_up > LONG_RUN { 1 } else { 5 };
    let (mut times, mut spent) = (Vec::new(), 0.0);
    while times.len() < least || (spent + warm_up < SHARE && times.len() < MOST_RUNS) {
        let (seconds, latest) = once()?;
        answer = latest;
        spent += seconds;
        times.push(seconds);
    }
    times.sort_by(f64::total_cmp);
    Ok((times[times.len() / 2], times.len(), answer))
}

fn print(label: Label<'_>, median_ms: Option<f64>, max_rel_error: Option<f64>, note: String) {
    let Label { job, system, setting } = label;
    let row = Row { job, system, setting, median_ms, max_rel_error, note };
    println!("{}", serde_json::to_string(&row).expect("a row is plain data"));
}
