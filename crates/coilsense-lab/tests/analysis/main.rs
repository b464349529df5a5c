//! An analysis from a spec's text to its verdicts.
//!
//! | ours | held against |
//! |---|---|
//! | ideal channels under ζ = 0 | Table II, by `reproduce` (`paper`) |
//! | readings of perfect and filtering sensors | the channels themselves, the detuning of the modes (`readings`) |
//! | lines of a budget | their closed forms; the Monte Carlo (`budget`) |
//! | what would fix a sensor | the same change written into the spec (`fixes`) |
//! | a coil whose force is no straight line | an inextensible wire in closed form, the helix that moves (`bent`) |
//! | a helix that moves | the chain of a long flat spring, its static curve, its own reactions (`helix`) |
//! | windings that meet | two other programs, themselves without contact (`contact`) |
//! | magnetic wire | its windings solved about another pitch (`magnetisation`) |
//! | several springs | each alone, their sum (`springs`) |
//! | what a late window leaves out | the same part asked for by a window; its first mode in closed form (`sooner`) |
//! | warnings, data sheet | figures of the book (theory) on S_T and S_A (`warnings`, `data_sheet`) |
//! | the whole run | itself on other threads, and when stopped (`runs`), case by case with what is known (`under_way`) |

mod band;
mod bent;
mod budget;
mod contact;
mod data_sheet;
mod fixes;
mod helix;
mod magnetisation;
mod paper;
mod readings;
mod runs;
mod sections;
mod small;
mod sooner;
mod specimens;
mod springs;
mod under_way;
mod verdicts;
mod warnings;

use coilsense_lab::analysis::{Analysis, Verdict};
use coilsense_lab::spec::Spec;

const S_T: &str = include_str!("../../data/springs/S_T.toml");
const S_A: &str = include_str!("../../data/springs/S_A.toml");

/// Undamped, and a Monte Carlo that is long enough where nobody looks at it.
const UNDAMPED: &str = "[mount]\ndamping_ratio = 0\n[uncertainty]\ntrials = 1000\n";

/// A spring that hangs still at the middle of its range.
const STILL: &str =
    "[[condition]]\nkind = \"impact\"\nvelocity = \"0 m/s\"\nduration = \"10 ms\"\nsample_rate = \"1 kHz\"\n";

/// The paper's heel strike.
const HEEL_STRIKE: &str = "[[condition]]\nname = \"heel strike\"\nkind = \"impact\"\nvelocity = \"0.25 m/s\"\nwindow = [\"0.75 s\", \"1 s\"]\n";

fn spec(text: &str) -> Spec {
    Spec::parse("test.toml", text, &|name| Err(format!("{name}: no files here")))
        .unwrap_or_else(|e| panic!("{e}\n{text}"))
}

fn run(text: &str) -> Analysis {
    Analysis::run(spec(text), &|_, _| true).unwrap()
}

/// Of a spring, undamped, and more text.
fn undamped(spring: &str, more: &str) -> Analysis {
    run(&format!("{spring}\n{UNDAMPED}{more}"))
}

fn verdict<'a>(analysis: &'a Analysis, sensor: &str) -> &'a Verdict {
    let named = |verdict: &&Verdict| analysis.sensors[verdict.sensor].name == sensor;
    analysis.verdicts.iter().find(named).unwrap_or_else(|| panic!("no sensor {sensor}"))
}

/// A line of the budget of the worst case \[N\]; zero where there is none.
fn line(verdict: &Verdict, name: &str) -> f64 {
    let lines = verdict.budget.budget.contributions();
    lines.iter().find(|line| line.name == name).map_or(0.0, |line| line.contribution)
}

#[track_caller]
fn close(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * expected.abs(), "{found} instead of {expected}");
}
