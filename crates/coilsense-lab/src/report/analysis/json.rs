//! An analysis for machines: `results.json`, and what `analyze --json` prints.
//!
//! Next door: the same for people (`text`, `html`), its cases (`json_cases`).

use serde::Serialize;

use super::json_cases::CaseRow;
use crate::analysis::{
    Analysis, Fix, GoalFilter, IfUsual, SensorBudget, Sooner, USUAL_TOLERANCE, Verdict, Warning, answer,
};
use crate::report::data_sheet::DataSheetOutcome;
use crate::report::outcome::{Headed, Outcome, to_json};
use crate::spec::Goal;
use crate::study::Masses;

/// How well each sensor of a spec knows the force, best first; what was not computed is null.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct AnalysisOutcome<'a> {
    date: &'a str,
    spec_file: &'a str,
    /// What to choose, a sentence each.
    answer: Vec<String>,
    goal: GoalPart,
    /// F_nom.
    nominal_force_n: f64,
    masses: MassesPart<'a>,
    /// The answer were the stiffness uncertain as it usually is; null where the spec says how uncertain it is.
    if_stiffness_tolerance_were_usual: Option<UsualPart<'a>>,
    /// Every sensor judged, best first: those that meet the goal, of those the ones with a limit of error, of those the least uncertain.
    ranking: Vec<VerdictRow<'a>>,
    /// Each condition at each damping.
    cases: Vec<CaseRow<'a>>,
    warnings: Vec<WarningRow<'a>>,
    spring: Headed<DataSheetOutcome<'a>>,
    /// The spec's own text.
    spec: &'a str,
}

impl Outcome for AnalysisOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/analysis/1";
}

/// What the sensors are held against.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct GoalPart {
    /// The largest rms error; null without a goal.
    error_n: Option<f64>,
    /// Up to which frequency errors count; null where all do.
    bandwidth_hz: Option<f64>,
    /// The true force.
    force: &'static str,
}

/// How many masses stand for a winding, and whether they are enough.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct MassesPart<'a> {
    per_winding: usize,
    /// Whether the spec says how many.
    given: bool,
    /// By what share an rms moves when they are doubled; null where that was not tried.
    change_when_doubled: Option<f64>,
    enough: bool,
    /// Conditions whose rms rises with every mass that is added.
    conditions_without_limit: &'a [String],
}

/// The answer were the stiffness uncertain as it usually is.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct UsualPart<'a> {
    /// As a share.
    stiffness_tolerance: f64,
    best: &'a str,
    sensors: Vec<UsualRow<'a>>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct UsualRow<'a> {
    sensor: &'a str,
    combined_n: f64,
}

/// A sensor judged over every spring that the tolerances allow.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct VerdictRow<'a> {
    sensor: &'a str,
    kind: &'static str,
    /// Rms error in the worst condition at the worst damping.
    combined_n: f64,
    /// In percent of F_nom.
    combined_percent: f64,
    worst_condition: &'a str,
    worst_damping: &'a str,
    /// Whether the spec gives a limit of error; without one `combined_n` is the least that the sensor errs by.
    limit_of_error_given: bool,
    /// False also of a load cell that is overloaded.
    meets_goal: Option<bool>,
    meets_goal_by_damping: Vec<MeetsRow<'a>>,
    /// What a load cell sees at most where that is beyond its full scale.
    overload_n: Option<f64>,
    /// What the window leaves out of a stop, step, ramp, pulse, sweep or recording, where that is louder than all that is judged.
    before_window: Option<BeforePart<'a>>,
    /// The sensor's own −3 dB point; null for one without limits.
    bandwidth_hz: Option<f64>,
    lag_s: f64,
    /// The low-pass without which the goal's bandwidth is not true; null without one.
    goal_filter: Option<FilterPart>,
    /// Share of the springs whose rms error is inside the goal; null without a goal.
    share_inside_goal: Option<f64>,
    worst_specimen_n: f64,
    nominal_n: f64,
    fixes: &'a [Fix],
    budget: BudgetPart<'a>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct MeetsRow<'a> {
    damping: &'a str,
    meets: bool,
}

/// A part that the window leaves out.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct BeforePart<'a> {
    condition: &'a str,
    damping: &'a str,
    from_s: f64,
    to_s: f64,
    /// Rms error there on the nominal spring.
    error_n: f64,
}

/// A low-pass filter.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct FilterPart {
    kind: &'static str,
    order: usize,
    bandwidth_hz: f64,
    lag_s: f64,
    error_without_n: f64,
}

/// What a sensor errs by at one force, line by line.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct BudgetPart<'a> {
    force_n: f64,
    lines: Vec<BudgetRow<'a>>,
    bias_n: f64,
    combined_n: f64,
    coverage_factor: f64,
    expanded_n: f64,
    monte_carlo: MonteCarloPart,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct BudgetRow<'a> {
    name: &'a str,
    /// In the line's own unit.
    standard_uncertainty: f64,
    /// Newton over that unit.
    sensitivity: f64,
    contribution_n: f64,
    /// Of the variance.
    share: f64,
}

/// The same budget by drawing from its lines.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct MonteCarloPart {
    mean_n: f64,
    standard_n: f64,
    interval_n: [f64; 2],
    agrees: bool,
    /// Whether enough was drawn to tell.
    decided: bool,
    difference_n: [f64; 2],
    tolerance_n: f64,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct WarningRow<'a> {
    subject: &'static str,
    text: &'a str,
}

impl<'a> AnalysisOutcome<'a> {
    /// Of an analysis that was run.
    pub fn of(analysis: &'a Analysis, date: &'a str) -> Self {
        let spec = &analysis.spec;
        Self {
            date,
            spec_file: &spec.file,
            answer: answer(analysis),
            goal: GoalPart::of(&spec.goal),
            nominal_force_n: spec.spring.spring.nominal_force(),
            masses: MassesPart::of(&analysis.masses),
            if_stiffness_tolerance_were_usual: analysis.if_usual.as_ref().map(|usual| UsualPart::of(analysis, usual)),
            ranking: analysis.verdicts.iter().map(|verdict| VerdictRow::of(analysis, verdict)).collect(),
            cases: analysis.cases.iter().map(|case| CaseRow::of(analysis, case)).collect(),
            warnings: analysis.warnings.iter().map(WarningRow::of).collect(),
            spring: Headed::of(DataSheetOutcome::of(&analysis.data_sheet)),
            spec: &spec.text,
        }
    }
}

impl GoalPart {
    fn of(goal: &Goal) -> Self {
        Self { error_n: goal.error, bandwidth_hz: goal.bandwidth, force: goal.force.name() }
    }
}

impl<'a> MassesPart<'a> {
    fn of(masses: &'a Masses) -> Self {
        Self {
            per_winding: masses.per_winding,
            given: masses.is_given,
            change_when_doubled: masses.change,
            enough: masses.are_enough(),
            conditions_without_limit: &masses.without_limit,
        }
    }
}

impl<'a> UsualPart<'a> {
    fn of(analysis: &'a Analysis, usual: &IfUsual) -> Self {
        let sensors = analysis.sensors.iter().zip(&usual.combined);
        Self {
            stiffness_tolerance: USUAL_TOLERANCE,
            best: usual.order.first().map_or("", |best| &analysis.sensors[*best].name),
            sensors: sensors.map(|(sensor, &combined_n)| UsualRow { sensor: &sensor.name, combined_n }).collect(),
        }
    }
}

impl<'a> VerdictRow<'a> {
    fn of(analysis: &'a Analysis, verdict: &'a Verdict) -> Self {
        let spec = &analysis.spec;
        let sensor = &analysis.sensors[verdict.sensor];
        let worst = &analysis.cases[verdict.worst];
        let dampings = spec.mount.cases.iter().zip(&verdict.meets);
        Self {
            sensor: &sensor.name,
            kind: sensor.quantity.kind(),
            combined_n: verdict.combined(),
            combined_percent: 100.0 * verdict.combined() / spec.spring.spring.nominal_force(),
            worst_condition: &spec.conditions[worst.condition].name,
            worst_damping: &spec.mount.cases[worst.damping].label,
            limit_of_error_given: verdict.has_limits,
            meets_goal: verdict.meets_always(),
            meets_goal_by_damping: dampings.map(|(case, &meets)| MeetsRow { damping: &case.label, meets }).collect(),
            overload_n: verdict.overload,
            before_window: verdict.sooner.as_ref().map(|sooner| BeforePart::of(analysis, sooner)),
            bandwidth_hz: Some(verdict.bandwidth).filter(|bandwidth| bandwidth.is_finite()),
            lag_s: verdict.lag,
            goal_filter: verdict.filter.as_ref().map(FilterPart::of),
            share_inside_goal: verdict.least_inside(),
            worst_specimen_n: verdict.at_worst().worst,
            nominal_n: verdict.at_worst().nominal,
            fixes: &verdict.fixes,
            budget: BudgetPart::of(&verdict.budget),
        }
    }
}

impl<'a> BeforePart<'a> {
    fn of(analysis: &'a Analysis, sooner: &Sooner) -> Self {
        let case = &analysis.cases[sooner.case];
        Self {
            condition: &analysis.spec.conditions[case.condition].name,
            damping: &analysis.spec.mount.cases[case.damping].label,
            from_s: sooner.window.0,
            to_s: sooner.window.1,
            error_n: sooner.error,
        }
    }
}

impl FilterPart {
    fn of(filter: &GoalFilter) -> Self {
        Self {
            kind: "Butterworth low-pass",
            order: filter.order,
            bandwidth_hz: filter.bandwidth,
            lag_s: filter.lag,
            error_without_n: filter.raw,
        }
    }
}

impl<'a> BudgetPart<'a> {
    fn of(budget: &'a SensorBudget) -> Self {
        let lines = budget.budget.contributions().iter().map(|line| BudgetRow {
            name: &line.name,
            standard_uncertainty: line.standard_uncertainty,
            sensitivity: line.sensitivity,
            contribution_n: line.contribution,
            share: line.share,
        });
        Self {
            force_n: budget.force,
            lines: lines.collect(),
            bias_n: budget.budget.bias(),
            combined_n: budget.budget.combined(),
            coverage_factor: budget.coverage_factor,
            expanded_n: budget.expanded,
            monte_carlo: MonteCarloPart {
                mean_n: budget.mean,
                standard_n: budget.standard,
                interval_n: [budget.interval.0, budget.interval.1],
                agrees: budget.agreement.holds(),
                decided: budget.agreement.decided(),
                difference_n: [budget.agreement.low, budget.agreement.high],
                tolerance_n: budget.agreement.tolerance,
            },
        }
    }
}

impl<'a> WarningRow<'a> {
    fn of(warning: &'a Warning) -> Self {
        Self { subject: warning.subject.name(), text: &warning.text }
    }
}

/// The whole analysis as text.
///
/// # Errors
/// What `serde_json` says.
pub fn analysis_json(analysis: &Analysis, date: &str) -> Result<String, serde_json::Error> {
    to_json(AnalysisOutcome::of(analysis, date))
}
