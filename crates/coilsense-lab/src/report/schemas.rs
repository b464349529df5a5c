//! Every JSON Schema: `schemas/` in the repository.
//!
//! Next door: the outcomes (`outcome`), what a spec may hold (`crate::spec`).

use serde_json::Value;

use super::analysis::AnalysisOutcome;
use super::calibration::CalibrationOutcome;
use super::data_sheet::DataSheetOutcome;
use super::experiment::ExperimentOutcome;
use super::export::StateSpaceFile;
use super::files::{ExportOutcome, ImportOutcome, InitOutcome, RigOutcome, SimulationOutcome};
use super::identification::IdentificationOutcome;
use super::mitigation::MitigationOutcome;
use super::outcome::schema_of;
use super::overview::OverviewOutcome;
use super::placement::PlacementOutcome;
use super::record::RecordOutcome;
use super::reproduction::ReproductionOutcome;
use super::speed::SpeedOutcome;
use crate::spec::{experiment_file_schema, spec_schema};

/// Each outcome's name and schema, and those of the files that a user writes; a schema's file is called by the name.
pub fn schemas() -> Vec<(&'static str, Value)> {
    #[allow(unused_mut, reason = "what needs Parquet comes on top")]
    let mut all = vec![
        ("spec", spec_schema()),
        ("experiment-file", experiment_file_schema()),
        schema_of::<AnalysisOutcome<'static>>(),
        schema_of::<CalibrationOutcome<'static>>(),
        schema_of::<DataSheetOutcome<'static>>(),
        schema_of::<ExperimentOutcome<'static>>(),
        schema_of::<ExportOutcome<'static>>(),
        schema_of::<IdentificationOutcome<'static>>(),
        schema_of::<ImportOutcome<'static>>(),
        schema_of::<OverviewOutcome<'static>>(),
        schema_of::<InitOutcome<'static>>(),
        schema_of::<MitigationOutcome>(),
        schema_of::<PlacementOutcome<'static>>(),
        schema_of::<RecordOutcome<'static>>(),
        schema_of::<ReproductionOutcome<'static>>(),
        schema_of::<RigOutcome<'static>>(),
        schema_of::<SimulationOutcome<'static>>(),
        schema_of::<SpeedOutcome<'static>>(),
        schema_of::<StateSpaceFile<'static>>(),
    ];
    #[cfg(feature = "parquet")]
    all.extend([
        schema_of::<super::pareto::ParetoOutcome<'static>>(),
        schema_of::<super::sensitivity::SensitivityOutcome<'static>>(),
        schema_of::<super::files::SweepOutcome<'static>>(),
    ]);
    all
}
