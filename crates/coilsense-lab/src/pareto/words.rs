//! A front in a few sentences: how many are left, where the knee is, what the extremes cost.
//!
//! Next door: the front (`study`), numbers in units that people use (`crate::quantity`).

use super::Study;

/// The answer, the most important line first.
pub fn answer(study: &Study) -> Vec<String> {
    let units = study.shown();
    let of = |place: usize| {
        let values = study.objectives_of(place).iter().zip(&study.question.objectives).zip(&units);
        let said =
            values.map(|((value, objective), shown)| format!("{} {}", objective.name(), shown.with_unit(*value)));
        said.collect::<Vec<_>>().join(", ")
    };
    let wanted: Vec<String> =
        study.question.objectives.iter().map(|own| format!("{} {}", own.best_word(), own.name())).collect();
    let count = study.rows.len();
    let compared = study.counts.compared;
    let mut lines = vec![match count {
        1 => format!("One design of {compared} is best in every respect: row {}, {}.", study.rows[0], of(0)),
        _ => format!(
            "{count} of {compared} designs are Pareto-optimal for {}: none betters one of them in one respect without a loss in another. The knee of \
             the front is row {}: {}.",
            wanted.join(", "),
            study.rows[study.knee],
            of(study.knee)
        ),
    }];
    if count > 1 {
        for (place, objective) in study.extremes.iter().zip(&study.question.objectives) {
            let (word, name) = (objective.best_word(), objective.name());
            lines.push(format!("The {word} {name} has row {}: {}.", study.rows[*place], of(*place)));
        }
    }
    lines.push(format!("{}.", study.counts.account()));
    lines
}
