//! Signals to and from what other libraries hold: dicts, data frames, datasets, plots.
//!
//! Next door: the signals (the parent), the Python code that does it (`coilsense/_frames.py`).

use coilsense::Signals;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};

use super::PySignals;
use crate::names::Names;
use crate::series::numbers;
use crate::value::Arguments;

#[pymethods]
impl PySignals {
    /// Time and channels by name, as lists.
    ///
    /// Returns
    /// -------
    /// dict
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> signals = coilsense.Signals([0.0, 0.1, 0.2], {"F_o": [1.0, 2.0, 4.0]})
    /// >>> signals.to_dict()
    /// {'time': [0.0, 0.1, 0.2], 'F_o': [1.0, 2.0, 4.0]}
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let dict = PyDict::new(py);
        dict.set_item("time", numbers(self.time.bind(py)))?;
        for (channel, values) in &self.channels {
            dict.set_item(channel.name(), numbers(values.bind(py)))?;
        }
        Ok(dict)
    }

    /// The channels as a data frame of pandas over an index of time; ``pip install coilsense[pandas]``.
    ///
    /// Returns
    /// -------
    /// pandas.DataFrame
    ///     One column per channel; ``attrs["units"]`` holds their units.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> signals = coilsense.Signals([0.0, 0.1, 0.2], {"F_o": [1.0, 2.0, 4.0]})
    /// >>> signals.to_pandas()["F_o"].max()
    /// np.float64(4.0)
    fn to_pandas<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        frames(slf.py())?.call_method1("to_pandas", (slf,))
    }

    /// The way back from `to_dict`.
    ///
    /// Parameters
    /// ----------
    /// dict : dict
    ///     ``time`` [s] and values by channel, in SI.
    ///
    /// Returns
    /// -------
    /// Signals
    ///
    /// Raises
    /// ------
    /// Error
    ///     For a dict without ``time``, and as the constructor.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Signals.from_dict({"time": [0.0, 0.1], "F_o": [1.0, 2.0]})
    /// <Signals F_o: 2 samples from 0 s to 0.1 s>
    #[staticmethod]
    fn from_dict<'py>(dict: &Bound<'py, PyMapping>) -> PyResult<Bound<'py, PyAny>> {
        frames(dict.py())?.call_method1("of_mapping", (dict,))
    }

    /// The way back from `to_pandas`: a data frame whose columns are channels.
    ///
    /// Parameters
    /// ----------
    /// frame : pandas.DataFrame
    ///     Channels in SI by their names; times [s] in a column ``time``, or as the index where that is named so, as `to_pandas` names it, or counts time (``TimedeltaIndex``).
    ///
    /// Returns
    /// -------
    /// Signals
    ///
    /// Raises
    /// ------
    /// Error
    ///     For a frame without times, a column that is no channel, units in ``attrs["units"]`` that are not SI, and as the constructor.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense, pandas
    /// >>> frame = pandas.DataFrame({"time": [0.0, 0.1, 0.2], "F_o": [1.0, 2.0, 4.0]})
    /// >>> coilsense.Signals.from_pandas(frame)["F_o"].max()
    /// np.float64(4.0)
    #[staticmethod]
    fn from_pandas<'py>(frame: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        frames(frame.py())?.call_method1("of_pandas", (frame,))
    }

    /// A mapping is no array: NumPy, and pandas by it, would make one of the channels' names.
    #[pyo3(signature = (dtype=None, copy=None))]
    fn __array__(&self, dtype: Option<Bound<'_, PyAny>>, copy: Option<Bound<'_, PyAny>>) -> PyResult<Py<PyAny>> {
        let _ = (dtype, copy);
        let text = "Signals are a mapping of arrays: take one as signals[\"F_o\"], all as to_pandas(), to_xarray() or dict(signals)";
        Err(PyTypeError::new_err(text))
    }

    /// The channels as a dataset of xarray over the coordinate time; ``pip install coilsense[xarray]``.
    ///
    /// Returns
    /// -------
    /// xarray.Dataset
    ///     One variable per channel, each with its unit.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> signals = coilsense.Signals([0.0, 0.1, 0.2], {"F_o": [1.0, 2.0, 4.0]})
    /// >>> signals.to_xarray()["F_o"].attrs["units"]
    /// 'N'
    fn to_xarray<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        frames(slf.py())?.call_method1("to_xarray", (slf,))
    }

    /// Draws channels over time with matplotlib; ``pip install coilsense[plot]``.
    ///
    /// Parameters
    /// ----------
    /// channels : list of str, optional
    ///     Which, all of one unit; without it, the forces.
    /// ax : matplotlib.axes.Axes, optional
    ///     Where; without it, in a new figure.
    ///
    /// Returns
    /// -------
    /// matplotlib.axes.Axes
    ///
    /// Raises
    /// ------
    /// Error
    ///     For no channels, or channels of several units.
    #[pyo3(signature = (channels=None, ax=None))]
    fn plot<'py>(
        slf: &Bound<'py, Self>,
        channels: Option<Names>,
        ax: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let channels = channels.map(|names| names.listed("channels")).transpose()?;
        frames(slf.py())?.call_method1("plot", (slf, channels, ax))
    }
}

/// Signals from all that tells them: the noun, a data frame, or a mapping with ``time``; `None` for anything else.
pub fn told(object: &Bound<'_, PyAny>) -> PyResult<Option<Signals>> {
    let py = object.py();
    if let Ok(signals) = object.cast::<PySignals>() {
        return signals.get().to_rust(py).map(Some);
    }
    let made = frames(py)?.call_method1("signals_of", (object,))?;
    made.cast::<PySignals>().ok().map(|signals| signals.get().to_rust(py)).transpose()
}

/// The Python code beside this module that knows other libraries.
fn frames(py: Python<'_>) -> PyResult<Bound<'_, PyModule>> {
    py.import("coilsense._frames")
}
