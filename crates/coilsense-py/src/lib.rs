//! The Python module `coilsense._coilsense`: a thin door to the science and to the lab, one file a noun, the same names.
//!
//! Documentation comments of what Python sees are its docstrings, in NumPy's style. What is Python's own business (pandas, xarray, matplotlib,
//! Dask) is Python code in `python/coilsense`; type stubs are `python/coilsense/_coilsense.pyi`.
//!
//! Rules of this door: arguments are named as in Rust; arrays come in borrowed and go out moved; the interpreter's lock is let go while
//! something is computed; a value can be compared, printed, turned into a dict and pickled ([`value`]); errors have Rust's text ([`errors`]).

// Docstrings are laid out as NumPy's are.
#![allow(clippy::doc_lazy_continuation, clippy::doc_overindented_list_items)]

mod analysis;
mod calibration;
mod errors;
mod estimate;
mod excitation;
mod experiment;
mod geometry;
mod html;
mod identification;
mod inductance_sensor;
mod json;
mod log_options;
mod long_work;
mod maxwell_sum;
mod measures;
mod mitigation;
mod modes;
mod motion;
mod mount;
mod neighbours;
mod placement;
mod quantity;
mod readout;
mod recording;
mod results;
mod second_order;
mod series;
mod signals;
mod spec;
mod spec_argument;
mod spring;
mod spring_argument;
mod stream;
mod sweep;
mod two_encoder;
mod two_port;
mod value;
mod windings;

use pyo3::prelude::*;

use errors::IntoPython;

/// The compiled part of coilsense; import ``coilsense`` instead.
#[pymodule]
fn _coilsense(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_function(wrap_pyfunction!(simd_path, module)?)?;
    errors::register(module)?;
    spring::register(module)?;
    excitation::register(module)?;
    geometry::register(module)?;
    neighbours::register(module)?;
    mount::register(module)?;
    modes::register(module)?;
    motion::register(module)?;
    stream::register(module)?;
    windings::register(module)?;
    signals::register(module)?;
    two_port::register(module)?;
    readout::register(module)?;
    two_encoder::register(module)?;
    measures::register(module)?;
    spec::register(module)?;
    analysis::register(module)?;
    maxwell_sum::register(module)?;
    second_order::register(module)?;
    inductance_sensor::register(module)?;
    estimate::register(module)?;
    recording::register(module)?;
    calibration::register(module)?;
    identification::register(module)?;
    experiment::register(module)?;
    mitigation::register(module)?;
    placement::register(module)?;
    sweep::register(module)?;
    // What is public is said once, by the package beside this module.
    module.delattr("__all__")
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
#[pyfunction]
fn simd_path() -> PyResult<&'static str> {
    coilsense::simd::SimdPath::selected().python().map(|path| path.name())
}
