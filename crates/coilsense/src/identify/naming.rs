//! What each line is, with the reason in words.
//!
//! Next door: the series that names modes (`mode_series`), whether ends move with a line (`end_motion`).

use super::explain::Coil;
use super::line::{Line, Meaning};

/// How far mains may be off \[1\], relative, and the highest multiple that is thought of.
const MAINS_OFF: f64 = 3e-3;
const MULTIPLES: usize = 20;
/// How near a force is to following motion statically: |k X/F − 1|.
const FOLLOWS: f64 = 0.15;

/// How near a line that does not decay is to a mode's place to be taken for it, too \[1\], relative.
const AT_MODE: f64 = 2e-3;

/// Names the lines: steady ones by mains and motion, those that decay by the coil's modes and `aliases` of them. `static_part` is k X/F of each
/// line, where known.
pub(super) fn name(
    lines: &mut [Line],
    coil: Option<&Coil>,
    aliases: &[(usize, usize, f64)],
    rate: f64,
    static_part: &[Option<f64>],
) {
    for (index, line) in lines.iter_mut().enumerate() {
        (line.meaning, line.reason) = steady(line, static_part.get(index).copied().flatten());
    }
    harmonics(lines);
    let Some(coil) = coil else { return };
    for &(index, mode, expected) in &coil.modes {
        if !lines[index].decays {
            continue;
        }
        let off = 100.0 * (lines[index].frequency.value / expected - 1.0);
        // No sign on what rounds to nothing.
        let off = if off.abs() < 0.005 { "0.00".to_owned() } else { format!("{off:+.2}") };
        lines[index].meaning = Meaning::Mode(mode);
        lines[index].reason = format!("mode {mode}: {expected:.2} Hz expected, {off} % off");
    }
    for line in lines.iter_mut().filter(|line| !line.decays && line.meaning == Meaning::Unknown) {
        if let Some((mode, expected)) = coil.nearest(line.frequency.value, AT_MODE) {
            line.reason = format!(
                "no decay is heard, yet mode {mode} is expected at {expected:.2} Hz: it is too weak after the hits, or driven"
            );
        }
    }
    for &(index, mode, expected) in aliases {
        if lines[index].decays {
            lines[index].meaning = Meaning::Alias { mode, frequency: expected };
            lines[index].reason = format!("alias of mode {mode} at {expected:.1} Hz, folded at {:.0} Hz", 0.5 * rate);
        }
    }
}

/// Steady multiples of a line that follows the ends' motion come with it, even where the motion there is lost in noise; larger ones do not,
/// since a resonance may lift them.
fn harmonics(lines: &mut [Line]) {
    let follows = lines.iter().filter(|line| line.meaning == Meaning::Follows);
    let driven: Vec<(f64, f64)> = follows.map(|line| (line.frequency.value, line.amplitude)).collect();
    for line in lines.iter_mut().filter(|line| !line.decays && line.meaning == Meaning::Unknown) {
        let is_multiple = |base: &&(f64, f64)| {
            let ratio = line.frequency.value / base.0;
            ratio > 1.5 && (ratio - ratio.round()).abs() < MAINS_OFF * ratio && line.amplitude < 0.5 * base.1
        };
        if let Some((base, _)) = driven.iter().find(is_multiple) {
            let multiple = (line.frequency.value / base).round();
            line.reason = format!("steady, {multiple:.0} times the {base:.2} Hz at which the ends move");
            line.meaning = Meaning::Follows;
        }
    }
}

fn steady(line: &Line, static_part: Option<f64>) -> (Meaning, String) {
    let frequency = line.frequency.value;
    if let Some(part) = static_part.filter(|part| (part - 1.0).abs() < FOLLOWS) {
        let reason = format!(
            "the force follows the recorded motion of the ends there (k X/F = {part:.2}): it is driven, not ringing"
        );
        return (Meaning::Follows, reason);
    }
    if line.decays {
        return (Meaning::Unknown, "decays after hits, but is no mode of the series".to_owned());
    }
    for mains in [50.0, 60.0] {
        let multiple = (frequency / mains).round();
        let near =
            (frequency - multiple * mains).abs() < MAINS_OFF * frequency + 2.0 * line.frequency.standard.min(0.5);
        if multiple >= 1.0 && multiple <= MULTIPLES as f64 && near {
            let reason = format!("steady at {multiple} × {mains} Hz: mains");
            return (Meaning::Mains { mains, multiple: multiple as usize }, reason);
        }
    }
    (Meaning::Unknown, "steady: it does not decay".to_owned())
}
