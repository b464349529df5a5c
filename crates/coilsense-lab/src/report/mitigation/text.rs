//! What to do about ringing as terminal text: advice, a table, what was left out.
//!
//! Next door: the same as JSON (`json`), as a page (`html`).

use std::fmt::Write as _;

use super::shaping::shaping_text;
use crate::mitigation::{Candidate, Judgement, Origin, Ranking, Truth};
use crate::quantity::plainly;

/// The table, what was left out, and the advice.
pub fn mitigation_text(answer: &Ranking) -> String {
    let mut text = advice(answer);
    for note in notes(answer) {
        let _ = write!(text, "\n{note}");
    }
    let _ = write!(
        text,
        "\n\n{:62} {:9} {:>8} {:>8} {:>8} {:>8} {:>7} {:>9}\n",
        "errors in % of F_nom, rms", "", "nominal", "worst", "aligned", "lag [°]", "noise", "settling"
    );
    for truth in judged(answer) {
        let _ = writeln!(text, "against {}", truth.name());
        for (candidate, judgement) in answer.judged.iter().filter(|(candidate, _)| candidate.truth == truth) {
            let _ = writeln!(text, "{}", line(answer, candidate, judgement));
        }
    }
    for left_out in &answer.left_out {
        let _ = writeln!(text, "left out: {}: {}", left_out.name, left_out.reason);
    }
    text + &conditions(answer) + "\n" + &answer.shaping.as_ref().map(shaping_text).unwrap_or_default()
}

/// The forces that candidates were held against.
pub(super) fn judged(answer: &Ranking) -> Vec<Truth> {
    let any = |truth: &Truth| answer.judged.iter().any(|(candidate, _)| candidate.truth == *truth);
    [Truth::Static, Truth::Output].into_iter().filter(any).collect()
}

/// What a log says of its spring, a sentence each.
pub(super) fn notes(answer: &Ranking) -> &[String] {
    answer.study.recorded.as_ref().map_or(&[], |recorded| &recorded.notes)
}

/// What candidates were judged on, and what the columns mean.
pub(super) fn conditions(answer: &Ranking) -> String {
    let (study, sources) = (&answer.study, &answer.study.sources);
    if let Some(recorded) = &study.recorded {
        return format!(
            "On {}, {} samples at {:.3} Hz, as recorded: no noise added and no box, so that worst is what it leaves there;\n\
             designs for {:.3} N rms of noise{}, k ±{} %{}, m ±{} %{}; lag at {:.3} Hz; best: of those with a lag of at most {}°.",
            recorded.name,
            recorded.measured.len(),
            study.rate,
            study.noise,
            sources.noise.told(),
            plainly(100.0 * study.tolerances.stiffness()),
            sources.stiffness.told(),
            plainly(100.0 * study.tolerances.mass()),
            sources.mass.told(),
            study.bandwidth,
            degrees(study.most_lag),
        );
    }
    format!(
        "Conditions: {}, at {} Hz{} with {:.3} N rms of noise{}, seeds: {}; worst of {} runs: k ±{} %{}, m ±{} %{}, each alone and together, {}; lag at {:.3} Hz;\n\
         aligned: the reference shifted by the delay that fits best; settling: time after an impact until the error falls to a tenth; best: the smallest\n\
         worst case of those with a lag of at most {}°.",
        study.conditions.iter().map(|condition| condition.0.as_str()).collect::<Vec<_>>().join(", "),
        (1e6 * study.rate).round() / 1e6,
        sources.rate.told(),
        study.noise,
        sources.noise.told(),
        study.seeds,
        answer.runs,
        plainly(100.0 * study.tolerances.stiffness()),
        sources.stiffness.told(),
        plainly(100.0 * study.tolerances.mass()),
        sources.mass.told(),
        study.dampings.iter().map(|damping| damping.0.as_str()).collect::<Vec<_>>().join(", "),
        study.bandwidth,
        degrees(study.most_lag),
    )
}

/// A lag \[rad\] in degrees to so many decimals, without a sign before a zero.
fn upright(lag: f64, decimals: usize) -> String {
    let text = format!("{:.decimals$}", lag.to_degrees());
    let is_zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
    if is_zero { text.replace('-', "") } else { text }
}

/// An angle \[rad\] in degrees, without what its way there and back leaves behind the ninth decimal.
fn degrees(angle: f64) -> f64 {
    (1e9 * angle.to_degrees()).round() / 1e9
}

/// A force in % of F_nom.
pub(super) fn percent(answer: &Ranking, force: f64) -> f64 {
    100.0 * force / answer.study.spring.nominal_force()
}

fn line(answer: &Ranking, candidate: &Candidate, judgement: &Judgement) -> String {
    let settling = format!("{:.1} ms", 1e3 * judgement.settling);
    format!(
        "  {:60} {:9} {:8.4} {:8.4} {:8.4} {:>8} {:7.3} {settling:>9}",
        candidate.name,
        candidate.origin.name(),
        percent(answer, judgement.nominal),
        percent(answer, judgement.worst),
        percent(answer, judgement.aligned),
        upright(judgement.lag, 2),
        judgement.noise_gain,
    )
}

/// What to do for either force, two sentences each: the best, and what the best textbook filter does.
pub(super) fn advice(answer: &Ranking) -> String {
    let sentence = |truth, opening: &str| {
        let (candidate, judgement) = answer.best(truth)?;
        let mut text = format!(
            "{opening}: {}. Error {:.3} % of F_nom nominal, {:.3} % worst case ({}); lag {}° at {:.3} Hz; passes {:.0} % of the noise.",
            candidate.name,
            percent(answer, judgement.nominal),
            percent(answer, judgement.worst),
            judgement.worst_run,
            upright(judgement.lag, 1),
            answer.study.bandwidth,
            100.0 * judgement.noise_gain,
        );
        if let Some((first, tried)) = answer.best_textbook(truth).filter(|_| candidate.origin == Origin::Fitted) {
            let _ = write!(
                text,
                " Best textbook choice: {}, {:.3} % nominal, {:.3} % worst case.",
                first.name,
                percent(answer, tried.nominal),
                percent(answer, tried.worst),
            );
        }
        Some(text)
    };
    let both = [sentence(Truth::Static, "Best filter of F_i"), sentence(Truth::Output, "Best estimator of F_o")];
    both.into_iter().flatten().collect::<Vec<_>>().join("\n")
}
