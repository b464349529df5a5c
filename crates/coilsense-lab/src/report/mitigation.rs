//! What to do about ringing as people and machines read it: a table, advice in two sentences, JSON, the trade-off drawn, settings to paste.
//!
//! Next door: what is computed (`crate::mitigation`).

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::{ReportError, draw};
use crate::mitigation::export::{Export, Precision};
use crate::mitigation::{Answer, Candidate, Judgement, Origin, Truth};
use crate::output::Output;
use crate::plot::{Axis, Colour, Figure, Marker, Panel, Points};

/// The table, what was left out, and the advice.
pub fn mitigation_text(answer: &Answer) -> String {
    let mut text = advice(answer);
    let _ = write!(
        text,
        "\n\n{:62} {:9} {:>8} {:>8} {:>8} {:>8} {:>7} {:>9}\n",
        "errors in % of F_nom, rms", "", "nominal", "worst", "aligned", "lag [°]", "noise", "settling"
    );
    for truth in [Truth::Static, Truth::Output] {
        let _ = writeln!(text, "against {}", truth.name());
        for (candidate, judgement) in answer.judged.iter().filter(|(candidate, _)| candidate.truth == truth) {
            let _ = writeln!(text, "{}", line(answer, candidate, judgement));
        }
    }
    for left_out in &answer.left_out {
        let _ = writeln!(text, "left out: {}: {}", left_out.name, left_out.reason);
    }
    let study = &answer.study;
    if let Some(recorded) = &study.recorded {
        let _ = writeln!(
            text,
            "On {}, {} samples at {:.3} Hz, as recorded: no noise added and no box, so that worst is what it leaves there; k·Δl is of the nominal spring;\n\
             designs for {:.3} N rms of noise, k ±{} %, m ±{} %; lag at {:.3} Hz; advised: at most {}° late.",
            recorded.name,
            recorded.measured.len(),
            study.rate,
            study.noise,
            100.0 * study.tolerances.stiffness(),
            100.0 * study.tolerances.mass(),
            study.bandwidth,
            study.most_lag,
        );
        return text;
    }
    let _ = writeln!(
        text,
        "{} condition(s) at {} Hz, noise {:.3} N rms, {} seed(s); worst of {} runs: k ±{} %, m ±{} %, each alone and together, {}; lag at {:.3} Hz;\n\
         aligned: the truth shifted by the delay that fits best; settling: after an impact, to a tenth of it; advised: the least at worst of those at\n\
         most {}° late.",
        study.conditions.len(),
        study.rate,
        study.noise,
        study.seeds,
        answer.runs,
        100.0 * study.tolerances.stiffness(),
        100.0 * study.tolerances.mass(),
        study.dampings.iter().map(|damping| damping.0.as_str()).collect::<Vec<_>>().join(", "),
        study.bandwidth,
        study.most_lag,
    );
    text
}

fn percent(answer: &Answer, force: f64) -> f64 {
    100.0 * force / answer.study.spring.nominal_force()
}

fn line(answer: &Answer, candidate: &Candidate, judgement: &Judgement) -> String {
    let settling = format!("{:.1} ms", 1e3 * judgement.settling);
    format!(
        "  {:60} {:9} {:8.4} {:8.4} {:8.4} {:8.2} {:7.3} {settling:>9}",
        candidate.name,
        candidate.origin.name(),
        percent(answer, judgement.nominal),
        percent(answer, judgement.worst),
        percent(answer, judgement.aligned),
        judgement.lag,
        judgement.noise_gain,
    )
}

/// Two sentences: what to do for either force.
fn advice(answer: &Answer) -> String {
    let sentence = |truth, opening: &str| {
        let (candidate, judgement) = answer.best(truth)?;
        let mut text = format!(
            "{opening} {}: {:.3} % of F_nom rms, {:.3} % at worst ({}), {:.1}° late at {:.3} Hz, {:.0} % of the noise",
            candidate.name,
            percent(answer, judgement.nominal),
            percent(answer, judgement.worst),
            judgement.worst_run,
            judgement.lag,
            answer.study.bandwidth,
            100.0 * judgement.noise_gain,
        );
        if let Some((first, tried)) = answer.best_first_try(truth).filter(|_| candidate.origin == Origin::Fitted) {
            let against = |ours: f64, theirs: f64| {
                let change = 100.0 * (ours / theirs - 1.0);
                format!("{:.0} % {}", change.abs(), if change < 0.0 { "less" } else { "more" })
            };
            let _ = write!(
                text,
                "; that is {} than the {} leaves, and {} at worst",
                against(judgement.nominal, tried.nominal),
                first.name,
                against(judgement.worst, tried.worst),
            );
        }
        Some(text + ".")
    };
    let both = [
        sentence(Truth::Static, "For F_i without its ringing, take the"),
        sentence(Truth::Output, "For the force at end 2, take the"),
    ];
    both.into_iter().flatten().collect::<Vec<_>>().join("\n")
}

/// Everything as JSON; errors in N.
///
/// # Errors
/// [`ReportError::Json`].
pub fn mitigation_json(answer: &Answer) -> Result<String, ReportError> {
    let candidates: Vec<Value> = answer
        .judged
        .iter()
        .map(|(candidate, judgement)| {
            json!({
                "name": candidate.name,
                "origin": candidate.origin.name(),
                "against": candidate.truth.name(),
                "rms error [N]": judgement.nominal,
                "worst rms error [N]": judgement.worst,
                "worst run": judgement.worst_run,
                "aligned rms error [N]": judgement.aligned,
                "delay of best fit [s]": judgement.delay,
                "lag at bandwidth [deg]": judgement.lag,
                "noise gain": judgement.noise_gain,
                "settling after an impact [s]": judgement.settling,
                "settings": candidate.settings().map(|settings| settings.numbers()),
            })
        })
        .collect();
    let left_out = answer.left_out.iter().map(|it| json!({ "name": it.name, "reason": it.reason }));
    let study = &answer.study;
    let whole = json!({
        "advice": advice(answer).lines().collect::<Vec<_>>(),
        "F_nom [N]": study.spring.nominal_force(),
        "sampling rate [Hz]": study.rate,
        "noise [N rms]": study.noise,
        "bandwidth [Hz]": study.bandwidth,
        "log": study.recorded.as_ref().map(|recorded| recorded.name.as_str()),
        "seeds": study.seeds,
        "first seed": study.seed,
        "stiffness tolerance": study.tolerances.stiffness(),
        "mass tolerance": study.tolerances.mass(),
        "candidates": candidates,
        "left out": left_out.collect::<Vec<_>>(),
    });
    Ok(serde_json::to_string_pretty(&whole)? + "\n")
}

/// Adds `results.json`, the trade-off as a figure, and the best filter's and estimator's settings as JSON, C and Rust.
///
/// # Errors
/// [`ReportError`] for the first part that fails.
pub fn add_mitigation(answer: &Answer, precision: Precision, output: &mut Output) -> Result<(), ReportError> {
    output.add("results.json", mitigation_json(answer)?.as_bytes())?;
    let drawn = draw("trade-off".to_owned(), String::new(), &trade_off(answer))?;
    output.add("trade-off.svg", drawn.light.as_bytes())?;
    output.add("trade-off.png", &drawn.png)?;
    for (truth, name) in [(Truth::Static, "force_filter"), (Truth::Output, "force_estimator")] {
        let Some(settings) = answer.best(truth).and_then(|(candidate, _)| candidate.settings()) else { continue };
        let export = Export::new(name, answer.study.rate, precision, settings)?;
        output.add(&format!("{name}.json"), (serde_json::to_string_pretty(&export.json())? + "\n").as_bytes())?;
        output.add(&format!("{name}.h"), export.c()?.as_bytes())?;
        output.add(&format!("{name}.rs"), export.rust().as_bytes())?;
    }
    Ok(())
}

/// Worst-case error against lag.
fn trade_off(answer: &Answer) -> Figure {
    let points = |truth, origin, label: &str, colour, marker| {
        let those = answer.judged.iter().filter(|(c, _)| c.truth == truth && c.origin == origin);
        let (x, y) = those.map(|(_, j)| (j.lag, percent(answer, j.worst))).unzip();
        Points { label: label.to_owned(), x, y, errors: Vec::new(), colour, marker }
    };
    let axis = |label: String, range, scale| Axis { label, range, scale };
    // No point stands on the frame.
    let around = |truth| {
        let lags = answer.judged.iter().filter(|(c, _)| c.truth == truth).map(|(_, j)| j.lag);
        let (least, most) = lags.fold((0.0_f64, 0.0_f64), |(least, most), lag| (least.min(lag), most.max(lag)));
        let room = 0.05 * (most - least).max(1.0);
        Some((least - room, most + room))
    };
    let panel = |title: &str, truth| Panel {
        title: title.to_owned(),
        x: axis(format!("Lag at {:.3} Hz [°]", answer.study.bandwidth), around(truth), crate::plot::Scale::Linear),
        y: axis("Worst error [% of F_{nom}]".to_owned(), None, crate::plot::Scale::Log10),
        points: vec![
            points(truth, Origin::Raw, "nothing done", Colour::Ink, Marker::Disc),
            points(truth, Origin::FirstTry, "first tries", Colour::Blue, Marker::Square),
            points(truth, Origin::Fitted, "fitted", Colour::Red, Marker::Diamond),
        ],
        ..Panel::default()
    };
    Figure {
        panels: vec![panel("Filters of F_i", Truth::Static), panel("Estimators of F_o", Truth::Output)],
        columns: 2,
        panel_width: 420.0,
        panel_height: 320.0,
    }
}
