//! One design: a spec judged, as a row of the result.
//!
//! Next door: its forces (`forces`), many of them (`chunk`), which values it has (`plan`).

use coilsense::Deviation;
use coilsense::calibrate::Theory;
use coilsense::inductance::MaxwellSum;

use super::column::{BY_INDUCTANCE, Column, MOVES, Measure, Needs, OfSensor};
use super::forces::{self, Judged, Windows};
use crate::analysis::{Assessed, assess};
use crate::spec::{Core, Draft, Files, Side};
use crate::study::prepare;

/// What became of a design.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Status {
    /// It is judged.
    Ok,
    /// It is judged, but windings would touch, which the linear model does not know.
    Clash,
    /// It cannot be.
    Refused,
}

impl Status {
    pub fn name(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Clash => "clash",
            Self::Refused => "refused",
        }
    }
}

/// A cell of a row of results.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Result {
    None,
    Number(f64),
    Text(String),
    Flag(bool),
}

/// A row of results.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Row {
    pub status: Status,
    /// Empty where the design is fine.
    pub reason: String,
    /// One for each column; empty where the design is refused.
    pub results: Vec<Result>,
}

/// Judges the design that a draft holds.
///
/// - `masses`: for each winding, of each spring, where the spec leaves that open and it was found for all designs; else empty
pub(super) fn judge(draft: &Draft<'_>, files: &Files<'_>, columns: &[Column], needs: &Needs, masses: &[usize]) -> Row {
    match judged(draft, files, columns, needs, masses) {
        Ok(row) => row,
        Err(reason) => Row { status: Status::Refused, reason, results: Vec::new() },
    }
}

fn judged(
    draft: &Draft<'_>,
    files: &Files<'_>,
    columns: &[Column],
    needs: &Needs,
    masses: &[usize],
) -> std::result::Result<Row, String> {
    let (core, assessed) = if !needs.sensors.is_empty() {
        let mut spec = draft.spec(files).map_err(|error| error.to_string())?;
        spec.spring.needs_axial(&spec.file, MOVES).map_err(|error| error.to_string())?;
        spec.needs_one_spring("a sensor").map_err(|error| error.to_string())?;
        spec.spring.masses_per_winding = spec.spring.masses_per_winding.or(masses.first().copied());
        spec.spring.look_up_surges(&spec.mount.ends);
        prepare(&mut spec.spring, &mut spec.mount, &spec.conditions).map_err(|error| error.to_string())?;
        let assessed = assess(&spec, &needs.sensors).map_err(|error| error.to_string())?;
        let (spring, mount, conditions, goal) = (spec.spring, spec.mount, spec.conditions, spec.goal);
        (Core { spring, mount, conditions, goal, beside: Vec::new() }, assessed)
    } else {
        let core = draft.core(files).map_err(|error| error.to_string())?;
        if needs.motion() {
            core.spring.needs_axial("a design", MOVES).map_err(|error| error.to_string())?;
        }
        (core, Vec::new())
    };
    let nominal = core.nominal_force();
    let mut springs = core.each();
    for (number, (_, core)) in springs.iter_mut().enumerate().filter(|_| needs.sensors.is_empty()) {
        core.spring.masses_per_winding = core.spring.masses_per_winding.or(masses.get(number).copied());
        prepare(&mut core.spring, &mut core.mount, &core.conditions).map_err(|error| error.to_string())?;
    }
    let core = &springs[0].1;
    let coil = needs.forces[BY_INDUCTANCE].then(|| {
        let coil = MaxwellSum::new(&core.spring.spring, core.spring.self_distance);
        let theory = Theory::new(&core.spring.spring, &coil);
        (coil, theory)
    });
    let dampings = core.mount.cases.len();
    let mut windows = Windows::default();
    let mut cases = Vec::with_capacity(core.conditions.len() * dampings);
    for condition in 0..core.conditions.len() {
        for damping in 0..dampings {
            let case = forces::judge(&springs, coil.as_ref(), (condition, damping), needs, &mut windows);
            cases.push(case.map_err(|error| format!("{}: {error}", place(core, condition, damping)))?);
        }
    }
    let reason = touching(&springs, &cases);
    let judged = Design { core, nominal, cases: &cases, assessed: &assessed, needs };
    Ok(Row {
        status: if reason.is_empty() { Status::Ok } else { Status::Clash },
        reason,
        results: columns.iter().map(|column| judged.result(column)).collect(),
    })
}

/// `resonance`, and under which damping where there are several.
fn place(core: &Core, condition: usize, damping: usize) -> String {
    let name = &core.conditions[condition].name;
    match core.mount.cases.len() {
        1 => name.clone(),
        _ => format!("{name}, {}", core.mount.cases[damping].label),
    }
}

/// Where windings first touch; empty where they do not.
fn touching(springs: &[(Side, Core)], cases: &[Judged]) -> String {
    let core = &springs[0].1;
    let dampings = core.mount.cases.len();
    let contact = |(case, judged): (usize, &Judged)| {
        let met = judged.clashes.iter().zip(springs);
        met.filter_map(|(clash, (_, spring))| {
            let clash = clash.as_ref()?;
            let time = clash.first_contact?;
            let winding = clash.winding;
            let place = place(core, case / dampings, case % dampings);
            let of = if springs.len() == 1 { String::new() } else { format!(" of {}", spring.spring.name) };
            Some(format!("windings{of} touch in {place} at {time:.6} s; nearest are {winding} and {}", winding + 1))
        })
        .next()
    };
    cases.iter().enumerate().find_map(contact).unwrap_or_default()
}

/// A design with all that was found.
struct Design<'a> {
    core: &'a Core,
    /// F_nom, of several springs that of all \[N\].
    nominal: f64,
    /// Condition by condition, each under every damping.
    cases: &'a [Judged],
    assessed: &'a [(usize, Assessed)],
    needs: &'a Needs,
}

impl Design<'_> {
    fn result(&self, column: &Column) -> Result {
        let nominal = self.nominal;
        match column {
            Column::Spring(number) => Result::Number((number.of)(self.core)),
            Column::Force { force, measure, condition } => {
                let of_cases = self.of(*condition).iter().filter_map(|case| case.deviations[*force].as_ref());
                let largest = of_cases.map(|deviation| measured(deviation, *measure)).max_by(by_size);
                largest.map_or(Result::None, |value| Result::Number(100.0 * value / nominal))
            }
            Column::WorstOf { force } => self.worst(&[*force]),
            Column::Worst => {
                let asked: Vec<usize> = (0..4).filter(|force| self.needs.forces[*force]).collect();
                self.worst(&asked)
            }
            Column::Method { condition } => self.method(*condition),
            Column::Bound { condition } => {
                let of_cases = self.of(*condition).iter().filter(|case| case.methods != [0, 0]);
                of_cases.map(|case| case.bound).max_by(by_size).map_or(Result::None, Result::Number)
            }
            Column::Pitch { clearance } => {
                let clashes = self.cases.iter().filter_map(|case| case.clashes.first()?.as_ref());
                let smallest = clashes.map(|clash| clash.smallest_pitch).fold(f64::INFINITY, f64::min);
                let spring = &self.core.spring;
                let found = if *clearance { spring.gap(smallest) } else { spring.winding_pitch(smallest) };
                if smallest.is_finite() { Result::Number(found) } else { Result::None }
            }
            Column::Sensor { sensor, of } => self.sensor(*sensor, *of, nominal),
        }
    }

    /// The cases of a condition, or all.
    fn of(&self, condition: Option<usize>) -> &[Judged] {
        let dampings = self.core.mount.cases.len();
        condition.map_or(self.cases, |number| self.cases.get(number * dampings..(number + 1) * dampings).unwrap_or(&[]))
    }

    /// The first case in which the RMSD of any of some forces is largest.
    fn worst(&self, forces: &[usize]) -> Result {
        let largest = |case: &Judged| {
            let each = forces.iter().filter_map(|force| case.deviations[*force].as_ref());
            each.map(|deviation| deviation.rmsd).fold(f64::NEG_INFINITY, f64::max)
        };
        let sizes = self.cases.iter().map(largest).enumerate();
        let worst = sizes.rev().max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, size)| size.is_finite());
        let dampings = self.core.mount.cases.len();
        worst.map_or(Result::None, |(case, _)| Result::Text(place(self.core, case / dampings, case % dampings)))
    }

    fn method(&self, condition: Option<usize>) -> Result {
        let counts = self.of(condition).iter().fold([0, 0], |sum, case| [0, 1].map(|i| sum[i] + case.methods[i]));
        match counts {
            [0, 0] => Result::None,
            [_, 0] => Result::Text("second-order".to_owned()),
            [0, _] => Result::Text("exact".to_owned()),
            _ => Result::Text("mixed".to_owned()),
        }
    }

    fn sensor(&self, sensor: usize, of: OfSensor, nominal: f64) -> Result {
        let Some((_, assessed)) = self.assessed.iter().find(|(index, _)| *index == sensor) else { return Result::None };
        match of {
            OfSensor::Combined => Result::Number(100.0 * assessed.combined / nominal),
            OfSensor::Meets => assessed.meets.map_or(Result::None, Result::Flag),
            OfSensor::Lag => Result::Number(assessed.lag),
        }
    }
}

fn measured(deviation: &Deviation, measure: Measure) -> f64 {
    match measure {
        Measure::Rmsd => deviation.rmsd,
        Measure::Maximum => deviation.maximum_absolute,
        Measure::Bias => deviation.mean,
    }
}

fn by_size(a: &f64, b: &f64) -> std::cmp::Ordering {
    a.abs().total_cmp(&b.abs())
}
