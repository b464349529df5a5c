//! The runs over time in a few sentences: of which drive and estimator they are, what they confirm, what they leave out.
//!
//! Next door: the runs (`over_time`), the rest of the answer (`answer`).

use coilsense::control::Drive;

use super::Placement;
use super::over_time::{BESIDE, LoopRun, Verdict};
use crate::quantity::digits;

/// How a line begins that must be seen.
pub(super) const WARNING: &str = "Warning";

/// By less than this a spring is not said to be off \[1\].
const LEAST_OFF: f64 = 5e-5;

/// A drive in words.
pub fn drive_words(drive: &Drive) -> String {
    let lag = |bandwidth: &Option<f64>, none: &str, some: &str| {
        bandwidth.map_or_else(|| none.to_owned(), |hertz| format!("{some} of {} Hz", digits(hertz)))
    };
    match drive {
        Drive::Velocity { bandwidth } => {
            lag(bandwidth, "an ideal velocity source", "a velocity source with a bandwidth")
        }
        Drive::Force { mass, friction, bandwidth } => {
            let friction = match friction {
                0.0 => "no friction".to_owned(),
                friction => format!("{} N s/m of friction", digits(*friction)),
            };
            let lag = lag(bandwidth, "an ideal current loop", "a current loop");
            format!("a motor of {} kg with {friction} and {lag}", digits(*mass))
        }
    }
}

impl LoopRun {
    /// At which damping and on which spring it is run.
    pub fn case(&self) -> String {
        let off = |name: &str, share: f64| {
            let percent = digits(100.0 * share.abs());
            let sign = if share < 0.0 { '−' } else { '+' };
            if share.abs() < LEAST_OFF { String::new() } else { format!(", {name} {sign}{percent} %") }
        };
        let [stiffness, frequency] = self.off;
        format!("{}{}{}", self.damping, off("k", stiffness), off("f1", frequency))
    }

    /// Whether it is stable as it is set, in a word or two.
    pub fn state(&self) -> String {
        match &self.shown {
            Err(why) => format!("not run: {why}"),
            Ok(run) => match (run.ran_away_at, self.stable) {
                (Some(time), _) => format!("ran away after {} s", digits(time)),
                (None, true) => "stable".to_owned(),
                (None, false) => "unstable".to_owned(),
            },
        }
    }

    /// What became of the shown run: never a number that looks settled for one that is not.
    pub fn outcome(&self) -> String {
        let run = match &self.shown {
            Err(why) => return format!("not run: {why}"),
            Ok(run) => run,
        };
        if let Some(time) = run.ran_away_at {
            return format!("runs away, past 1e8 N after {} s", digits(time));
        }
        let seconds = digits(run.time.last().copied().unwrap_or_default());
        let [place, swing] = self.last.unwrap_or_default().map(|share| digits(100.0 * share));
        match self.stable {
            true => format!("F_o is at {place} % of it at the end of the run, {seconds} s, and moves by ±{swing} %"),
            false => format!("unstable, F_o moves by ±{swing} % of it after {seconds} s"),
        }
    }
}

/// The sentences.
pub(super) fn lines(placement: &Placement) -> Vec<String> {
    let drive = drive_words(&placement.control.drive);
    let how = placement
        .control
        .sample_time
        .map_or_else(|| "continuous".to_owned(), |step| format!("in samples of {} ms", digits(1e3 * step)));
    let named = |wanted: Verdict| {
        let runs = placement.runs.iter().filter(|run| run.verdict == wanted);
        runs.map(|run| run.fed_back).collect::<Vec<_>>().join("; ")
    };
    let (below, above) = (1.0 - BESIDE, 1.0 + BESIDE);
    let mut lines = Vec::new();
    let held = named(Verdict::Holds);
    if !held.is_empty() {
        lines.push(format!(
            "Run over time, {how}, with {drive}, a loop is stable at {below} and unstable at {above} times its predicted limit when fed back is: {held}."
        ));
    }
    let broken = named(Verdict::Fails);
    if !broken.is_empty() {
        lines.push(format!(
            "{WARNING}: run over time, {how}, with {drive}, a loop does not turn unstable where predicted when fed back is: {broken}."
        ));
    }
    let short = named(Verdict::TooSlow);
    if !short.is_empty() {
        lines.push(format!("Too slow at its limit to be told by a run over time is a loop on: {short}."));
    }
    let best = placement.best_run();
    match &best.shown {
        Err(why) => lines.push(format!("Not run over time: {why}.")),
        Ok(_) => lines.push(format!(
            "A step of 1 % of F_nom over {}, {how}, with {drive}, {}: {}; the command reaches {} {}.",
            best.fed_back,
            best.case(),
            best.outcome(),
            digits(best.largest_command),
            placement.control.drive.command_unit(),
        )),
    }
    if placement.runs.iter().any(|run| run.shown.is_ok()) {
        lines.push(doubt(placement));
    }
    lines
}

/// What the linear model leaves out.
fn doubt(placement: &Placement) -> String {
    let coil = placement.runs.iter().find_map(|run| run.coil_error).map_or_else(String::new, |error| {
        let size = if error < 1e-6 { "less than 0.0001".to_owned() } else { digits(100.0 * error) };
        format!("; F_L read off the whole inductance differs by {size} % of that step")
    });
    format!(
        "These runs are linear: they know no limit of command, speed or travel, no dry friction or backlash, no noise or coarse reading, and \
         no windings that touch{coil}."
    )
}
