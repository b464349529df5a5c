//! Sweeps: rows against `analyze`, rows that depend on nothing but plan and number, folders that are continued, and what is refused.
//!
//! Next door: the command with its kills (`coilsense-cli/tests/sweep.rs`).

mod asked;
mod damaged;
mod dataset;
mod refusals;
mod rows;
mod sensors;
mod springs;
mod wound;

use std::path::Path;

use coilsense_lab::sweep::{Chunk, Data, Plan, PlanParameters, SweepError};

/// Two conditions of a few samples, so that a thousand rows take a moment.
const QUICK: &str = r#"
[spring]
name = "S_T"
rest_length = "104 mm"
windings = 12
coil_radius = "8 mm"
wire_radius = "1 mm"
mass = "65 g"
stiffness = "760 N/m"
min_length = "196 mm"
max_length = "264 mm"
masses_per_winding = 1
model = "chain"

[mount]
damping_ratio = 0

[[condition]]
name = "heel strike"
kind = "impact"
velocity = "0.25 m/s"
window = ["0.75 s", "0.76 s"]

[[condition]]
name = "resonance"
kind = "harmonic"
frequency = "1 f1"
amplitude = "0.1 %"
phase = "-90 deg"
start = "massless"
window = ["0.75 s", "0.76 s"]

[[sensor]]
name = "laser"
kind = "deflection"
noise = "10 um"

[goal]
error = "1 %"
"#;

/// Parameters of a plan on a spec's text.
fn of(spec: &str, over: &[&str], columns: &[&str]) -> PlanParameters {
    let texts = |texts: &[&str]| texts.iter().map(|text| (*text).to_owned()).collect();
    PlanParameters {
        spec_file: "spec.toml".to_owned(),
        spec: spec.to_owned(),
        over: texts(over),
        columns: texts(columns),
        ..PlanParameters::default()
    }
}

fn plan(over: &[&str], columns: &[&str], rows: Option<u64>) -> Result<Plan, SweepError> {
    Plan::new(PlanParameters { rows, ..of(QUICK, over, columns) })
}

fn whole(plan: &Plan) -> Vec<Chunk> {
    (0..plan.chunks()).map(|chunk| plan.chunk(chunk, &|| true).unwrap().unwrap()).collect()
}

fn numbers(chunk: &Chunk, title: &str) -> Vec<f64> {
    match &chunk.columns.iter().find(|(known, _)| known == title).unwrap_or_else(|| panic!("{title}")).1 {
        Data::Numbers(values) => values.clone(),
        other => panic!("{title}: {other:?}"),
    }
}

fn texts(chunk: &Chunk, title: &str) -> Vec<String> {
    match &chunk.columns.iter().find(|(known, _)| known == title).unwrap_or_else(|| panic!("{title}")).1 {
        Data::Texts(values) => values.clone(),
        other => panic!("{title}: {other:?}"),
    }
}

fn example(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    std::fs::read_to_string(path).unwrap()
}
