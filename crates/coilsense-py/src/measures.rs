//! `coilsense.Deviation`, `Clash` and `Spectrum`: how far off, whether windings touch, a signal over frequency.
//!
//! Next door: the signals (`signals`), the motion (`motion`).

mod clash;
mod deviation;
mod spectrum;

pub use clash::PyClash;
pub use deviation::PyDeviation;
use pyo3::prelude::*;

/// Adds the classes and the function to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PyDeviation>()?;
    module.add_class::<PyClash>()?;
    module.add_class::<spectrum::PySpectrum>()?;
    module.add_function(wrap_pyfunction!(spectrum::py_alias_of, module)?)
}
