//! One condition under one damping of a spec, by itself: what a page shows while somebody looks at it.
//!
//! Next door: all of them, and the judgement over them (the parent).

use super::case::Case;
use super::judge::Judge;
use super::specimen::Springs;
use super::warnings::{self, Warning};
use super::{AnalysisError, judged_sensors};
use crate::data_sheet::DataSheet;
use crate::spec::{SensorSpec, Spec, SpringInductance};

/// A case of a spec, with what a reader must know of it. Its numbers are those of [`super::Analysis::run`], noise included.
#[derive(Debug, Clone)]
pub struct Single {
    /// The spec, its spring with as many masses as its figures need.
    pub spec: Spec,
    /// The case.
    pub case: Case,
    /// The sensors that were judged: the spec's, or perfect ones where it has none.
    pub sensors: Vec<SensorSpec>,
    /// What a reader must know before using the numbers of this case.
    pub warnings: Vec<Warning>,
    /// What follows from the spring alone.
    pub data_sheet: DataSheet,
}

impl Single {
    /// Processes the condition and the damping of these numbers in the spec.
    ///
    /// # Errors
    /// [`AnalysisError::NoCondition`] for a spec without conditions, [`AnalysisError::NoSuchCase`] for a number that is too high,
    /// [`AnalysisError::Case`] for what the science refuses.
    pub fn run(spec: &Spec, condition: usize, damping: usize) -> Result<Self, AnalysisError> {
        super::check_case(spec, condition, damping)?;
        let mut prepared = spec.clone();
        super::prepare(&mut prepared)?;
        let spec = &prepared;
        let coil = SpringInductance::of(&spec.spring)?;
        let sensors = judged_sensors(spec);
        let helices = super::helices(spec)?;
        let case = super::run_case(spec, &sensors, &coil, &helices, (condition, damping))?;
        let data_sheet = DataSheet::of(spec)?;
        let cases = [case];
        let springs = Springs::of(spec, &spec.spring.tolerances, 1);
        let judge = Judge { spec, coil: &coil, helices: &helices, cases: &cases, springs: &springs };
        let warnings = warnings::of(&judge, &sensors, &data_sheet)?;
        let [case] = cases;
        Ok(Self { case, sensors, warnings, data_sheet, spec: prepared })
    }
}
