//! The Python module `coilsense._coilsense`: a thin door to the science and to the lab, one file a noun, the same names.
//!
//! Documentation comments of what Python sees are its docstrings, in NumPy's style. What is Python's own business (pandas, xarray, matplotlib,
//! Dask) is Python code in `python/coilsense`; its type stubs are written from here by `cargo xtask stubs`.
//!
//! Rules of this door: arguments are named as in Rust; arrays come in borrowed and go out moved; the interpreter's lock is let go while
//! something is computed; a value can be compared, printed, turned into a dict and pickled ([`value`]); errors have Rust's text ([`errors`]).

// Docstrings are laid out as NumPy's are.
#![allow(clippy::doc_lazy_continuation, clippy::doc_overindented_list_items)]

mod analysis;
mod calibration;
mod count;
mod errors;
mod estimate;
mod excitation;
mod experiment;
mod geometry;
mod hertz;
mod html;
mod identification;
mod inductance_sensor;
mod json;
mod live;
mod live_batch;
mod log_options;
mod long_work;
mod maxwell_sum;
mod measures;
mod mitigation;
mod modes;
mod motion;
mod mount;
mod names;
mod neighbours;
mod noun;
mod placement;
mod plant;
mod quantity;
mod readout;
mod recording;
mod results;
mod samples;
mod second_order;
mod series;
mod signals;
mod spec;
mod spec_argument;
mod speed;
mod spring;
mod spring_argument;
mod stream;
mod sweep;
mod threads;
mod two_encoder;
mod two_port;
mod value;
mod windings;

use pyo3::prelude::*;

use errors::IntoPython;

/// The compiled part of coilsense; import ``coilsense`` instead.
#[pymodule]
mod _coilsense {
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::{
        analysis::{PyAnalysis, PyCase, PyTogether, py_analyze, py_simulate, py_simulate_together},
        calibration::{PyCalibration, PyStoredCalibration, calibrate, open_calibration},
        errors::{AnalysisError, Error, LogError, OutputError, SpecError, SweepError},
        estimate::PyEstimate,
        excitation::{PyEndInput, PyExcitation, PyStart, py_traverse_velocity},
        experiment::{PyExperiment, experiment, rig},
        geometry::{PyGeometry, PyMaterial, material::materials},
        identification::{PyIdentification, identify},
        inductance_sensor::{PyInductanceSensor, theories},
        live::PyLive,
        live_batch::PyLiveBatch,
        maxwell_sum::PyMaxwellSum,
        measures::{PyClash, PyDeviation, spectrum::PySpectrum, spectrum::py_alias_of},
        mitigation::{PyMitigation, PyRemedy, mitigate},
        modes::{
            PyChainModes, py_continuous_frequencies, py_continuous_frequency, py_third_rule_error,
            py_third_rule_frequency,
        },
        motion::PyMotion,
        mount::{PyDamping, PyFarEnd, PyMount},
        neighbours::{buckling_force, lateral_frequency, torsional_frequency},
        placement::{PyPlacement, placement},
        plant::{PyPlant, plant},
        readout::PyReadout,
        recording::{PyRecording, open_log},
        second_order::{PySecondOrder, py_mutual_inductances},
        signals::{PySignals, py_sampled_window},
        simd_path,
        spec::{PyCondition, PySpec},
        speed::{PySpeedMap, speed},
        spring::PySpring,
        stream::PyStream,
        sweep::{
            dataset::PySweepDataset, pareto::PyPareto, pareto::pareto, plan::PySweepPlan, sensitivity::PySensitivity,
            sensitivity::sensitivity,
        },
        two_encoder::PyTwoEncoder,
        two_port::{PyCascade, PyLoad, PyTwoPort},
        windings::PyWindings,
    };

    /// What is no class and no function.
    #[pymodule_init]
    fn complete(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        // What is public is said once, by the package beside this module.
        module.delattr("__all__")
    }
}

/// The vector instructions that the kernels of this process use.
///
/// Results are equal byte for byte on one path, and to 1e-12 of the peak across paths. The environment variable ``COILSENSE_SIMD`` forces one.
///
/// Returns
/// -------
/// {"scalar", "avx2", "avx512"}
///
/// Raises
/// ------
/// Error
///     Where the variable names an unknown path or one that this processor lacks.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> coilsense.simd_path() in ("scalar", "avx2", "avx512")
/// True
#[pyfunction]
fn simd_path() -> PyResult<&'static str> {
    coilsense::simd::SimdPath::selected().python().map(|path| path.name())
}
