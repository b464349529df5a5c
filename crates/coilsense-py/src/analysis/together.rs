//! `coilsense.simulate_together`: several springs between the same ends.
//!
//! Next door: one spring (`simulate`, the parent).

use coilsense_lab::analysis::Together;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::PyCase;
use crate::errors::IntoPython;
use crate::long_work::watched;
use crate::results::table_and_figure;
use crate::signals::PySignals;
use crate::spec_argument::SpecArgument;
use crate::value::getters;

/// Simulates every condition of a spec of several springs under every damping, on all cores: the forces of each and of all.
///
/// Springs that rub against one another are not in the model.
///
/// Parameters
/// ----------
/// spec : Spec, str or os.PathLike
///     What to simulate: a spec, its file, or its text; a spec of one spring has its forces as those of all.
/// progress : callable, optional
///     Called as ``progress(done, of)`` now and then; an exception of it stops the work.
///
/// Returns
/// -------
/// list of Together
///     Condition by condition.
///
/// Raises
/// ------
/// AnalysisError
///     As `simulate`.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> text = coilsense.Spec.template("S_T").split("[[sensor]]")[0].replace("[spring]", "[[spring]]", 1)
/// >>> twin = text[text.index("[[spring]]") : text.index("[mount]")].replace('"S_T"', '"twin"')
/// >>> both = coilsense.simulate_together(coilsense.Spec.parse(text.replace("[mount]", twin + "[mount]", 1)))
/// >>> force = both[0].signals["F_o"] / both[0].springs["twin"].signals["F_o"]
/// >>> bool(abs(force - 2).max() < 1e-12)
/// True
#[pyfunction(name = "simulate_together")]
#[pyo3(signature = (spec, progress=None))]
pub fn py_simulate_together(
    py: Python<'_>,
    spec: SpecArgument<'_>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Vec<PyTogether>> {
    let spec = &spec.spec(py)?;
    let Together { springs, all } =
        watched(py, progress.as_ref(), |progress| Together::of(spec, progress))?.python()?;
    let mut each: Vec<_> = springs.into_iter().map(|it| (it.side.sign(), it.spec, it.cases.into_iter())).collect();
    let case = |signals| {
        let (springs, signs) = (PyDict::new(py), PyDict::new(py));
        let mut of = None;
        for (sign, spec, cases) in &mut each {
            let Some(case) = cases.next() else { continue };
            of.get_or_insert((case.condition, case.damping));
            signs.set_item(&spec.spring.name, *sign)?;
            springs.set_item(&spec.spring.name, Py::new(py, PyCase::of(py, spec, &[], case)?)?)?;
        }
        let (condition, damping) = of.unwrap_or_default();
        Ok(PyTogether {
            condition: spec.conditions[condition].name.clone(),
            damping: spec.mount.cases[damping].label.clone(),
            signals: Py::new(py, PySignals::of(py, signals))?,
            springs: springs.unbind(),
            signs: signs.unbind(),
        })
    };
    all.into_iter().map(case).collect()
}

/// A condition of a spec of several springs under one of its dampings, simulated; made by `simulate_together`.
#[pyclass(name = "Together", module = "coilsense", frozen)]
pub struct PyTogether {
    condition: String,
    damping: String,
    signals: Py<PySignals>,
    springs: Py<PyDict>,
    signs: Py<PyDict>,
}

getters! {
    PyTogether, self;
    /// The condition's name.
    condition: &str = &self.condition;
    /// The damping's label.
    damping: &str = &self.damping;
    /// u1, u2, F_i, F_o and F_x of all springs from t = 0 on.
    signals<'py>(py): Py<PySignals> = self.signals.clone_ref(py);
    /// Each spring as it moves, as a dict of `Case` by the spring's name, the first first.
    springs<'py>(py): Py<PyDict> = self.springs.clone_ref(py);
    /// 1.0, or -1.0 of a spring that pulls the other way: with what its forces count, as a dict by the spring's name.
    signs<'py>(py): Py<PyDict> = self.signs.clone_ref(py);
}

table_and_figure! {
    PyTogether;
    /// The channels of all springs as a data frame of pandas over time; ``pip install coilsense[pandas]``.
    to_pandas = "together_frame";
    /// Draws the forces over time with matplotlib; ``pip install coilsense[plot]``.
    plot = "forces_plot";
}

#[pymethods]
impl PyTogether {
    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let (springs, samples) = (self.springs.bind(py).len(), self.signals.bind(py).get().samples(py));
        Ok(format!("<Together {}, {}: {springs} springs, {samples} samples>", self.condition, self.damping))
    }
}
