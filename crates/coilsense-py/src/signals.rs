//! `coilsense.Signals`: time and one series per channel, and the times of a sampled window.
//!
//! Next door: who makes them (`motion`, `sensors`), who judges them (`measures`). The arrays are Python's own, moved there from Rust, and cannot
//! be written to; what Rust is to judge is handed back by name. Data frames and plots of them are Python code (`coilsense/_frames.py`).

mod frames;

use coilsense::signals::sampled_window;
use coilsense::{Channel, Signals};
use coilsense_lab::quantity::Dimension;
use numpy::{IntoPyArray, PyArray1, PyUntypedArrayMethods};
use pyo3::exceptions::{PyKeyError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyMapping};

pub use frames::told;

use crate::errors::{IntoPython, unknown};
use crate::quantity::Quantity;
use crate::series::{Series, described, frozen, numbers};
use crate::value::Arguments;

/// Time and one series per channel, all of one length: a read-only mapping from a channel's name to its values.
///
/// Parameters
/// ----------
/// time : array_like of float, shape (samples,)
///     [s], strictly increasing.
/// channels : mapping of str to array_like, optional
///     Values by channel: "u1", "u2" [m], "F_i", "F_o", "F_x", "F_L" [N], "L" [H].
///
/// Raises
/// ------
/// Error
///     For a time that is not after its predecessor, an unknown channel, a channel of another length, or a value that is not finite.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> signals = coilsense.Signals([0.0, 0.1, 0.2], {"F_o": [1.0, 2.0, 4.0]})
/// >>> signals["F_o"].max()
/// np.float64(4.0)
/// >>> list(signals), len(signals), signals.unit("F_o")
/// (['F_o'], 1, 'N')
#[pyclass(name = "Signals", module = "coilsense", frozen, mapping)]
pub struct PySignals {
    time: Py<PyArray1<f64>>,
    channels: Vec<(Channel, Py<PyArray1<f64>>)>,
}

impl PySignals {
    /// Signals moved to Python.
    pub fn of(py: Python<'_>, signals: Signals) -> Self {
        let (time, channels) = signals.into_parts();
        let channels = channels.into_iter().map(|(channel, values)| (channel, frozen(py, values))).collect();
        Self { time: frozen(py, time), channels }
    }

    /// The same for Rust, copied.
    pub fn to_rust(&self, py: Python<'_>) -> PyResult<Signals> {
        let mut signals = Signals::new(numbers(self.time.bind(py))).python()?;
        for (channel, values) in &self.channels {
            signals.insert(*channel, numbers(values.bind(py))).python()?;
        }
        Ok(signals)
    }

    /// How many samples there are.
    pub fn samples(&self, py: Python<'_>) -> usize {
        self.time.bind(py).shape()[0]
    }

    fn find(&self, channel: Channel) -> Option<&Py<PyArray1<f64>>> {
        self.channels.iter().find(|(present, _)| *present == channel).map(|(_, values)| values)
    }

    fn series<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let dict = PyDict::new(py);
        for (channel, values) in &self.channels {
            dict.set_item(channel.name(), values)?;
        }
        Ok(dict)
    }
}

/// A channel by its name.
pub fn channel(name: &str) -> PyResult<Channel> {
    Channel::named(name).ok_or_else(|| unknown("channel", &Channel::ALL.map(Channel::name), name))
}

#[pymethods]
impl PySignals {
    #[new]
    #[pyo3(signature = (time, channels=None))]
    fn new(py: Python<'_>, time: Series<'_>, channels: Option<Bound<'_, PyMapping>>) -> PyResult<Self> {
        let mut signals = Signals::new(time.to_vec("time")?).python()?;
        for pair in channels.map(|channels| channels.items()).transpose()?.into_iter().flatten() {
            let (name, values): (Bound<'_, PyAny>, Bound<'_, PyAny>) = pair.extract()?;
            let (name, values): (String, Series<'_>) = (named(&name)?, values.extract()?);
            signals.insert(channel(&name)?, values.to_vec(&name)?).python()?;
        }
        Ok(Self::of(py, signals))
    }

    /// Time [s], shape (samples,); read-only.
    #[getter]
    fn time<'py>(&self, py: Python<'py>) -> &Bound<'py, PyArray1<f64>> {
        self.time.bind(py)
    }

    /// The names of the channels that are there, in the order in which files hold them.
    ///
    /// Returns
    /// -------
    /// list of str
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> signals = coilsense.Signals([0.0, 0.1, 0.2], {"F_o": [1.0, 2.0, 4.0]})
    /// >>> signals.keys()
    /// ['F_o']
    fn keys(&self) -> Vec<&'static str> {
        self.channels.iter().map(|(channel, _)| channel.name()).collect()
    }

    /// The series of the channels, in the order of `keys`.
    ///
    /// Returns
    /// -------
    /// list of numpy.ndarray
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> signals = coilsense.Signals([0.0, 0.1, 0.2], {"F_o": [1.0, 2.0, 4.0]})
    /// >>> signals.values()
    /// [array([1., 2., 4.])]
    fn values(&self, py: Python<'_>) -> Vec<Py<PyArray1<f64>>> {
        self.channels.iter().map(|(_, values)| values.clone_ref(py)).collect()
    }

    /// Name and series of each channel.
    ///
    /// Returns
    /// -------
    /// list of (str, numpy.ndarray)
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> signals = coilsense.Signals([0.0, 0.1, 0.2], {"F_o": [1.0, 2.0, 4.0]})
    /// >>> signals.items()
    /// [('F_o', array([1., 2., 4.]))]
    fn items(&self, py: Python<'_>) -> Vec<(&'static str, Py<PyArray1<f64>>)> {
        self.channels.iter().map(|(channel, values)| (channel.name(), values.clone_ref(py))).collect()
    }

    /// One channel, or `default` where it is not there.
    ///
    /// Parameters
    /// ----------
    /// name : str
    /// default : object, optional
    ///
    /// Returns
    /// -------
    /// numpy.ndarray or object
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> signals = coilsense.Signals([0.0, 0.1, 0.2], {"F_o": [1.0, 2.0, 4.0]})
    /// >>> signals.get("F_i") is None
    /// True
    #[pyo3(signature = (name, default=None))]
    fn get<'py>(&self, py: Python<'py>, name: &str, default: Option<Bound<'py, PyAny>>) -> Option<Bound<'py, PyAny>> {
        let there = Channel::named(name).and_then(|channel| self.find(channel));
        there.map(|values| values.bind(py).clone().into_any()).or(default)
    }

    /// The SI unit of a channel.
    ///
    /// Parameters
    /// ----------
    /// name : str
    ///
    /// Returns
    /// -------
    /// str
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Signals.unit("F_o"), coilsense.Signals.unit("L")
    /// ('N', 'H')
    #[staticmethod]
    fn unit(name: &str) -> PyResult<&'static str> {
        Ok(channel(name)?.unit())
    }

    /// The same signals with a channel added, or replaced.
    ///
    /// Parameters
    /// ----------
    /// name : str
    ///     The channel.
    /// values : array_like of float, shape (samples,)
    ///     In its SI unit.
    ///
    /// Returns
    /// -------
    /// Signals
    ///
    /// Raises
    /// ------
    /// Error
    ///     For an unknown channel, another number of values than of times, or the first that is not finite.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> signals = coilsense.Signals([0.0, 0.1, 0.2], {"F_o": [1.0, 2.0, 4.0]})
    /// >>> list(signals.inserted("F_i", [1.0, 1.0, 2.0]))
    /// ['F_i', 'F_o']
    fn inserted(&self, py: Python<'_>, name: &str, values: Series<'_>) -> PyResult<Self> {
        let mut signals = self.to_rust(py)?;
        signals.insert(channel(name)?, values.to_vec("values")?).python()?;
        Ok(Self::of(py, signals))
    }

    fn __getitem__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyArray1<f64>>> {
        match self.find(channel(name).map_err(|error| PyKeyError::new_err(error.value(py).to_string()))?) {
            Some(values) => Ok(values.bind(py).clone()),
            None => Err(PyKeyError::new_err(format!("signal {name} is missing"))),
        }
    }

    fn __contains__(&self, name: &str) -> bool {
        Channel::named(name).is_some_and(|channel| self.find(channel).is_some())
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        Ok(PyList::new(py, self.keys())?.try_iter()?.into_any())
    }

    fn __len__(&self) -> usize {
        self.channels.len()
    }

    fn __eq__(&self, py: Python<'_>, other: &Bound<'_, PyAny>) -> PyResult<bool> {
        let Ok(other) = other.cast::<Self>() else { return Ok(false) };
        Ok(self.to_rust(py)? == other.get().to_rust(py)?)
    }

    fn __getnewargs__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyArray1<f64>>, Arguments<'py>)> {
        Ok((self.time.bind(py).clone(), self.series(py)?))
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        crate::html::shown(slf.as_any(), "signals")
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        let time = numbers(self.time.bind(py));
        let window = match (time.first(), time.last()) {
            (Some(first), Some(last)) => format!("{} samples from {first} s to {last} s", time.len()),
            _ => "no samples".to_owned(),
        };
        format!("<Signals {}: {window}>", self.keys().join(", "))
    }
}

/// A channel's name as a text.
fn named(name: &Bound<'_, PyAny>) -> PyResult<String> {
    let wrong =
        |_| PyTypeError::new_err(format!("channels must have texts as names, got {}", described(&name.as_borrowed())));
    name.extract().map_err(wrong)
}

/// Times of a window sampled at a constant rate, both ends included: k / rate for whole numbers k.
///
/// Parameters
/// ----------
/// rate : float or str
///     Samples per second [Hz].
/// start, stop : float or str
///     The window [s].
///
/// Returns
/// -------
/// numpy.ndarray, shape (samples,)
///     [s].
///
/// Raises
/// ------
/// Error
///     For a rate that is not above zero, a window that starts below zero or ends before it starts, or more than 1e9 samples.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> coilsense.sampled_window(10_000, 0.75, 1.0).shape
/// (2501,)
#[pyfunction(name = "sampled_window")]
pub fn py_sampled_window(
    py: Python<'_>,
    rate: Quantity,
    start: Quantity,
    stop: Quantity,
) -> PyResult<Bound<'_, PyArray1<f64>>> {
    let rate = rate.si("rate", Dimension::Frequency)?;
    let (start, stop) = (start.si("start", Dimension::Time)?, stop.si("stop", Dimension::Time)?);
    Ok(py.detach(|| sampled_window(rate, start, stop)).python()?.into_pyarray(py))
}
