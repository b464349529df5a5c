//! `coilsense.Readout`: what an instrument makes of a quantity.
//!
//! Next door: the signals that it reads (`signals`).

use coilsense::sensors::{Readout, ReadoutParameters};
use coilsense_lab::quantity::Dimension::{Frequency, Time};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;

use crate::count::Count;
use crate::errors::IntoPython;
use crate::long_work::of_series;
use crate::quantity::{Quantity, si};
use crate::samples::Samples;
use crate::series::Series;
use crate::value::named_value;

/// What an instrument makes of a quantity: low-pass, delay, averaging, sampling, noise, resolution.
///
/// Parameters
/// ----------
/// bandwidth : float or str, optional
///     Where the low-pass, a Butterworth, has lost 3 dB [Hz]; no low-pass without it.
/// order : int, optional
///     Of the low-pass, 1 to 8.
/// delay : float or str, optional
///     Time by which the reading comes late [s].
/// averaging : float or str, optional
///     The reading is the mean over the preceding time of this length [s].
/// sample_rate : float or str, optional
///     Samples per second [Hz], each held until the next.
/// noise : float, optional
///     Rms, in the quantity's unit.
/// resolution : float, optional
///     Step between readings, in the quantity's unit.
///
/// Raises
/// ------
/// Error
///     For the first value that is not finite, below zero or, where it must be, not above.
///
/// Examples
/// --------
/// >>> from coilsense import Readout
/// >>> meter = Readout(averaging=0.01, sample_rate=100.0, resolution=1e-9)  # an LCR meter
/// >>> round(meter.lag(0.0), 12)  # half a window and half a hold [s]
/// 0.01
#[pyclass(name = "Readout", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyReadout(Readout);

named_value! {
    /// The settings by name.
    PyReadout, self;
    bandwidth = self.0.parameters().bandwidth,
    order = self.0.parameters().order,
    delay = self.0.parameters().delay,
    averaging = self.0.parameters().averaging,
    sample_rate = self.0.parameters().sample_rate,
    noise = self.0.parameters().noise,
    resolution = self.0.parameters().resolution,
}

#[pymethods]
impl PyReadout {
    #[new]
    #[pyo3(signature = (*, bandwidth=None, order=Count::Number(1), delay=Quantity::Number(0.0), averaging=None, sample_rate=None,
                        noise=Quantity::Number(0.0), resolution=None),
           text_signature = "(*, bandwidth=None, order=1, delay=0.0, averaging=None, sample_rate=None, noise=0.0, resolution=None)")]
    fn new(
        bandwidth: Option<Quantity>,
        order: Count,
        delay: Quantity,
        averaging: Option<Quantity>,
        sample_rate: Option<Quantity>,
        noise: Quantity,
        resolution: Option<Quantity>,
    ) -> PyResult<Self> {
        let parameters = ReadoutParameters {
            bandwidth: si(bandwidth.as_ref(), "bandwidth", Frequency)?,
            order: order.size("order")?,
            delay: delay.si("delay", Time)?,
            averaging: si(averaging.as_ref(), "averaging", Time)?,
            sample_rate: si(sample_rate.as_ref(), "sample_rate", Frequency)?,
            noise: noise.plain("noise")?,
            resolution: resolution.map(|step| step.plain("resolution")).transpose()?,
        };
        Readout::new(parameters).python().map(Self)
    }

    /// The reading at each time.
    ///
    /// Parameters
    /// ----------
    /// times : array_like of float, shape (samples,)
    ///     [s], strictly increasing.
    /// values : array_like of float, shape (samples,)
    ///     The quantity, in any unit; taken as straight between samples.
    /// seed : int, optional
    ///     Of the noise; the same seed gives the same noise.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray, shape (samples,)
    ///     In the unit of the values.
    ///
    /// Raises
    /// ------
    /// Error
    ///     For a time that is not after its predecessor, a value beyond 1e9 either way, or series of different lengths.
    ///
    /// Examples
    /// --------
    /// >>> from coilsense import Readout
    /// >>> Readout(delay=0.1, resolution=0.5).series([0.0, 0.1, 0.2, 0.3], [1.0, 2.0, 3.1, 3.2])
    /// array([1., 1., 2., 3.])
    #[pyo3(signature = (times, values, seed=Count::Number(1)), text_signature = "($self, times, values, seed=1)")]
    fn series<'py>(
        slf: &Bound<'py, Self>,
        times: Series<'_>,
        values: Series<'_>,
        seed: Count,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let seed = seed.number("seed")?;
        let (times, values) = (times.values("times")?, values.to_vec("values")?);
        // Filter, window, hold and noise are some ten nanoseconds a sample each.
        let steps = times.len().saturating_mul(20);
        let read = of_series(slf, steps, &times, move |readout, times| readout.0.series(times, &values, seed))?;
        Ok(read.python()?.into_pyarray(slf.py()))
    }

    /// How it answers to sines.
    ///
    /// Parameters
    /// ----------
    /// frequencies : float, str or array_like of float
    ///     [Hz].
    ///
    /// Returns
    /// -------
    /// complex or numpy.ndarray of complex, of the shape of the frequencies
    ///     Reading over quantity [1].
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> round(abs(coilsense.Readout(bandwidth="1 kHz").response("1 kHz")), 6)
    /// 0.707107
    fn response<'py>(&self, py: Python<'py>, frequencies: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        frequencies.each(py, "frequencies", Frequency, |hertz| self.0.response(hertz))
    }

    /// How late it is for a sine.
    ///
    /// Parameters
    /// ----------
    /// frequency : float, str or array_like of float
    ///     [Hz].
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the frequency
    ///     [s].
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Readout(delay="2 ms").lag([1.0, 100.0])
    /// array([0.002, 0.002])
    fn lag<'py>(&self, py: Python<'py>, frequency: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        frequency.each(py, "frequency", Frequency, |hertz| self.0.lag(hertz))
    }

    /// Where all of it together has lost 3 dB [Hz]; infinite without limits.
    #[getter]
    fn bandwidth_3db(&self) -> f64 {
        self.0.bandwidth_3db()
    }
}
