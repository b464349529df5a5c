//! Results as people and machines read them: terminal text, HTML, JSON.
//!
//! Next door: what is computed (`reproduce`, `analysis`, `data_sheet`, `calibration`, `identification`, `experiment`), how files come to disk
//! whole (`output`).

mod analysis;
mod calibration;
mod data_sheet;
mod experiment;
mod export;
mod files;
mod identification;
mod mitigation;
mod outcome;
mod overview;
mod page;
#[cfg(feature = "parquet")]
mod pareto;
mod placement;
mod prose;
mod record;
#[cfg(feature = "reference")]
mod reference;
mod reproduction;
#[cfg(feature = "reference")]
mod schemas;
#[cfg(feature = "parquet")]
mod sensitivity;
mod spectrogram;
mod speed;
#[cfg(feature = "reference")]
pub mod verbs;

pub use analysis::{AnalysisOutcome, add_analysis, analysis_json, analysis_text, analysis_warnings};
pub use calibration::{CalibrationOutcome, add_calibration, calibration_json, calibration_text};
pub use data_sheet::{DataSheetOutcome, data_sheet_json, data_sheet_text};
pub use experiment::{ExperimentOutcome, add_experiment, experiment_json, experiment_text};
pub use export::{StateSpaceFile, export_file, write_export};
pub use files::{ExportOutcome, ImportOutcome, InitOutcome, RigOutcome, SimulationOutcome};
#[cfg(feature = "parquet")]
pub use files::{ReasonRow, RecomputedRow, SweepOutcome};
pub use identification::{IdentificationOutcome, add_identification, identification_json, identification_text};
pub use mitigation::{MitigationOutcome, add_mitigation, mitigation_json, mitigation_text};
pub use outcome::{Headed, Outcome, to_json};
pub use overview::{OverviewOutcome, add_overview, overview_json, overview_text};
#[cfg(feature = "parquet")]
pub use pareto::{ParetoOutcome, add_pareto, pareto_json, pareto_text};
pub use placement::{PlacementOutcome, add_placement, placement_json, placement_text};
pub use record::{CheckRow, RecordOutcome, record_json, record_text};
#[cfg(feature = "reference")]
pub use reference::options_markdown;
pub use reproduction::{add_reproduction, reproduction_json, reproduction_text};
#[cfg(feature = "reference")]
pub use schemas::schemas;
pub use speed::{SpeedOutcome, add_speed, speed_columns, speed_json, speed_text};

#[cfg(feature = "parquet")]
pub use sensitivity::{SensitivityOutcome, add_sensitivity, sensitivity_json, sensitivity_text};

use coilsense_figure::{Figure, PlotError, Theme};

use crate::output::OutputError;

/// What can go wrong while a report is made.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A figure cannot be drawn.
    #[error("figure {name}")]
    Figure {
        /// Its file name.
        name: String,
        /// Why.
        source: PlotError,
    },
    /// The page cannot be filled in.
    #[error("report.html: {0}")]
    Page(#[from] minijinja::Error),
    /// The science refuses.
    #[error(transparent)]
    Science(#[from] coilsense::Error),
    /// JSON cannot be written.
    #[error("JSON: {0}")]
    Json(#[from] serde_json::Error),
    /// A spec has no plant that could be written.
    #[error(transparent)]
    Plant(#[from] crate::plant::PlantError),
    /// Settings cannot be exported.
    #[error("export: {0}")]
    Export(#[from] crate::mitigation::export::ExportError),
    /// It would lie where a sweep's rows are.
    #[cfg(feature = "parquet")]
    #[error(transparent)]
    Sweep(#[from] crate::sweep::SweepError),
    /// A table cannot be written.
    #[error("{0}")]
    Table(String),
    /// A file cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
}

/// A figure drawn in every way that is needed.
struct Drawn {
    name: String,
    caption: String,
    light: String,
    dark: String,
    png: Vec<u8>,
}

fn draw(name: String, caption: String, figure: &Figure) -> Result<Drawn, ReportError> {
    let drawing = || Ok((figure.to_svg(Theme::Light)?, figure.to_svg(Theme::Dark)?, figure.to_png(Theme::Light)?));
    match drawing() {
        Ok((light, dark, png)) => Ok(Drawn { name, caption, light, dark, png }),
        Err(source) => Err(ReportError::Figure { name, source }),
    }
}
