//! What the engine is meant to reach against its peers, judged by the rows of one run.
//!
//! Next door: the rows (`bench`).

use crate::bench::{ANALYZE, Row};

/// At least so many times faster than a peer on a job.
struct Goal {
    job: &'static str,
    system: &'static str,
    setting: &'static str,
    factor: f64,
    /// What limits it where it is missed.
    limit: &'static str,
}

const SMOOTH: &str =
    "the peer's steps grow on a smooth motion, ours costs the same as an impact; and it is right to 1e-7 only";
const CONVOLUTION: &str =
    "one convolution solves a single recorded input; ours carries every mode from block to block, for any two inputs";

const GOALS: [Goal; 15] = [
    goal("impact", "diffsol", "tsit45, rtol 1e-9", 900.0, SMOOTH),
    goal("end-stop", "diffsol", "tsit45, rtol 1e-9", 900.0, SMOOTH),
    goal("resonance", "diffsol", "tsit45, rtol 1e-9", 900.0, SMOOTH),
    goal("impact", "SciPy", "signal.lsim", 200.0, ""),
    goal("end-stop", "SciPy", "signal.lsim", 200.0, ""),
    goal("resonance", "SciPy", "signal.lsim", 200.0, ""),
    goal("recorded", "SciPy", "signal.lsim", 20.0, ""),
    goal("impact", "NumPy", "modal sum, matrix product", 3.0, ""),
    goal("end-stop", "NumPy", "modal sum, matrix product", 3.0, ""),
    goal("resonance", "NumPy", "modal sum, matrix product", 3.0, ""),
    goal("recorded", "NumPy", "modal sum, matrix product", 3.0, CONVOLUTION),
    goal("mutual", "cfsem", "circular filament, scalar", 3.0, ""),
    goal("mutual", "cfsem", "circular filament, slices", 3.0, ""),
    goal("inductance", "cfsem", "circular filament, scalar", 4.0, ""),
    goal("inductance", "ellip", "eq. 8 as printed", 4.0, ""),
];

const fn goal(
    job: &'static str,
    system: &'static str,
    setting: &'static str,
    factor: f64,
    limit: &'static str,
) -> Goal {
    Goal { job, system, setting, factor, limit }
}

/// Largest error over the peak that coilsense may have on the jobs of S_T.
const LARGEST_ERROR: f64 = 1e-12;

/// How a goal was reached.
pub struct Judged {
    pub met: bool,
    /// What was measured, and the goal.
    pub what: String,
}

/// Prints each goal as met or missed; whether all that were measured are met.
#[must_use]
pub fn print(rows: &[Row]) -> bool {
    println!("\ngoals");
    let judged = judged(rows);
    for goal in &judged {
        println!("  {}  {}", if goal.met { "met   " } else { "MISSED" }, goal.what);
    }
    judged.iter().all(|goal| goal.met)
}

/// Each goal that was measured.
pub fn judged(rows: &[Row]) -> Vec<Judged> {
    let mut all = Vec::new();
    let mut judge = |met: bool, what: &str| all.push(Judged { met, what: what.to_owned() });
    for goal in &GOALS {
        let of_goal = |row: &&Row| (&*row.job, &*row.system, &*row.setting) == (goal.job, goal.system, goal.setting);
        let Some(ratio) = rows.iter().find(of_goal).and_then(|row| row.ratio) else {
            continue; // not measured in this run
        };
        let what = format!("{}: {ratio:.1}× {} {} (goal {}×)", goal.job, goal.system, goal.setting, goal.factor);
        let met = ratio >= goal.factor;
        judge(met, &if met || goal.limit.is_empty() { what } else { format!("{what}: {}", goal.limit) });
    }
    for job in ["impact", "end-stop", "resonance", "recorded"] {
        let errors =
            rows.iter().filter(|row| row.job == job && row.system == "coilsense").filter_map(|row| row.max_rel_error);
        let worst = errors.fold(0.0, f64::max);
        judge(worst <= LARGEST_ERROR, &format!("{job}: error {worst:.1e} of the peak (goal {LARGEST_ERROR:e})"));
    }
    streams(rows, &mut judge);
    growth(rows, &mut judge);
    analyses(rows, &mut judge);
    helix(rows, &mut judge);
    contact(rows, &mut judge);
    all
}

/// Most time that a stream under a sine on a mode may take, over one with held ends: as quick, but for the sine itself (a tenth to a quarter)
/// and what a busy machine adds.
const DEAREST_SINE: f64 = 1.4;

fn streams(rows: &[Row], judge: &mut impl FnMut(bool, &str)) {
    let under_sine = rows.iter().find(|row| row.job == "stream" && row.setting.starts_with("a sine"));
    if let Some(ratio) = under_sine.and_then(|row| row.ratio) {
        let what = format!("stream under a sine: {ratio:.2}× that with held ends (goal at most {DEAREST_SINE}×)");
        judge(ratio <= DEAREST_SINE, &what);
    }
}

/// Time that the analysis of an example may take \[ms\].
const LONGEST_ANALYSIS: f64 = 2000.0;

fn analyses(rows: &[Row], judge: &mut impl FnMut(bool, &str)) {
    for row in rows.iter().filter(|row| row.job.starts_with(ANALYZE)) {
        let Some(median) = row.median_ms else { continue };
        let what = format!("{}: {:.2} s (goal {} s)", row.job, 1e-3 * median, 1e-3 * LONGEST_ANALYSIS);
        judge(median <= LONGEST_ANALYSIS, &what);
    }
}

/// What may be asked of the coil as a helix, by how its row begins, and how long that may take \[ms\].
const HELIX: [(&str, f64); 3] =
    [("modes below 100 Hz counted", 0.02), ("ten modes", 5.0), ("ten frequencies at 50 lengths", 300.0)];

fn helix(rows: &[Row], judge: &mut impl FnMut(bool, &str)) {
    for (setting, most) in HELIX {
        let row = rows.iter().find(|row| row.job == "helix" && row.setting.starts_with(setting));
        if let Some(median) = row.and_then(|row| row.median_ms) {
            judge(median <= most, &format!("helix, {setting}: {median:.3} ms (goal {most} ms)"));
        }
    }
}

/// How long a spring whose windings meet may take \[ms\], by job and how its row begins.
const CONTACT: [(&str, &str, f64); 4] = [
    ("valve", "0.3 s, 6 masses", 3.0),
    ("valve-48", "0.3 s, 48 masses, neighbours", 60.0),
    ("valve-48", "0.3 s, 48 masses, a turn apart", 60.0),
    ("contact", "S_A, 1 s, one run", 50.0),
];

/// Most time that asking for contact may take where a bound keeps windings apart, over not asking.
const DEAREST_QUESTION: f64 = 1.02;

fn contact(rows: &[Row], judge: &mut impl FnMut(bool, &str)) {
    for (job, setting, most) in CONTACT {
        let row = rows.iter().find(|row| row.job == job && row.setting.starts_with(setting));
        if let Some(median) = row.and_then(|row| row.median_ms) {
            judge(median <= most, &format!("{job}, {setting}: {median:.2} ms (goal {most} ms)"));
        }
    }
    let asked = rows.iter().find(|row| row.job == "contact-clear" && row.setting.starts_with("S_A, 1 s, asked"));
    if let Some(ratio) = asked.and_then(|row| row.ratio) {
        let what = format!("contact asked where a bound rules it out: {ratio:.3}× (goal at most {DEAREST_QUESTION}×)");
        judge(ratio <= DEAREST_QUESTION, &what);
    }
}

/// Time must not grow faster than windings times samples.
fn growth(rows: &[Row], judge: &mut impl FnMut(bool, &str)) {
    let median = |job: &str| rows.iter().find(|row| row.job == job && row.system == "coilsense")?.median_ms;
    let Some(few) = median("impact") else {
        return;
    };
    for (job, windings) in [("impact-500", 500.0), ("impact-5000", 5000.0), ("impact-50000", 50_000.0)] {
        let Some(many) = median(job) else {
            continue;
        };
        let (time, windings) = (many / few, windings / 52.0);
        let what = format!("{job}: {windings:.0} times the windings of impact take {time:.0} times the time");
        judge(time <= windings, &what);
    }
}
