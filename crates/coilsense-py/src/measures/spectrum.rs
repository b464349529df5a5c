//! `coilsense.Spectrum`: amplitudes of a signal's lines, and where sampling folds a line to.
//!
//! Next door: forces that are off (`deviation`).

use coilsense::measures::{Spectrum, alias_of};
use coilsense_lab::quantity::Dimension;
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::IntoPython;
use crate::long_work::{MANY, interruptible};
use crate::quantity::Quantity;
use crate::results::table_and_figure;
use crate::samples::Samples;
use crate::series::Series;
use crate::value::{Arguments, getters};

/// One-sided spectrum of a uniformly sampled series, tapered after Hann.
///
/// Parameters
/// ----------
/// times : array_like of float, shape (samples,)
///     [s], uniform, at least three.
/// values : array_like of float, shape (samples,)
///     Of any unit.
///
/// Raises
/// ------
/// Error
///     For fewer than three samples, series of different lengths, a value beyond 1e9 either way, or a time more than 1e-6 of the interval
///     off its place.
///
/// Notes
/// -----
/// Source: [Harris1978] table I. Amplitude of a sine on a line to 1e-12 relative, half way between two lines 1.42 dB low.
///
/// Examples
/// --------
/// >>> import numpy, coilsense
/// >>> times = numpy.arange(1000) / 1000
/// >>> spectrum = coilsense.Spectrum(times, 2 + 3 * numpy.sin(2 * numpy.pi * 54 * times))
/// >>> spectrum.frequencies[54].round(9), spectrum.amplitudes[54].round(9)
/// (np.float64(54.0), np.float64(3.0))
#[pyclass(name = "Spectrum", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PySpectrum(Spectrum);

getters! {
    PySpectrum, self;
    /// Frequencies of the lines [Hz], shape (lines,).
    frequencies<'py>(py): Bound<'py, PyArray1<f64>> = self.0.frequencies().into_pyarray(py);
    /// Peak amplitude of the sine that each line stands for, in the unit of the values, shape (lines,); the mean's size at 0 Hz.
    amplitudes<'py>(py): Bound<'py, PyArray1<f64>> = PyArray1::from_slice(py, self.0.amplitudes());
}

table_and_figure! {
    PySpectrum;
    /// The lines as a data frame of pandas: frequency [Hz] and amplitude; ``pip install coilsense[pandas]``.
    to_pandas = "spectrum_frame";
    /// Draws amplitudes over frequency with matplotlib; ``pip install coilsense[plot]``.
    plot = "spectrum_plot";
}

#[pymethods]
impl PySpectrum {
    #[new]
    fn new(py: Python<'_>, times: Series<'_>, values: Series<'_>) -> PyResult<Self> {
        let (times, values) = (times.values("times")?, values.values("values")?);
        // A Fourier transform takes some ten nanoseconds a sample, more where their number has large factors.
        let steps = times.len().saturating_mul(20);
        if steps < MANY {
            return py.detach(|| Spectrum::of(&times, &values)).python().map(Self);
        }
        let (times, values) = (times.into_owned(), values.into_owned());
        interruptible(py, move || Spectrum::of(&times, &values))?.python().map(Self)
    }

    /// Rms of what lies within a band.
    ///
    /// Parameters
    /// ----------
    /// lowest, highest : float or str
    ///     The band [Hz], its ends included.
    ///
    /// Returns
    /// -------
    /// float
    ///     In the unit of the values; zero for a band without a line.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense, numpy
    /// >>> times = numpy.arange(1000) / 1000
    /// >>> spectrum = coilsense.Spectrum(times, 3 * numpy.sin(2 * numpy.pi * 54 * times))
    /// >>> round(spectrum.rms_within("50 Hz", "58 Hz"), 3)
    /// 2.121
    fn rms_within(&self, lowest: Quantity, highest: Quantity) -> PyResult<f64> {
        let lowest = lowest.si("lowest", Dimension::Frequency)?;
        Ok(self.0.rms_within(lowest, highest.si("highest", Dimension::Frequency)?))
    }

    /// Frequencies and amplitudes as lists.
    ///
    /// Returns
    /// -------
    /// dict
    ///
    /// Examples
    /// --------
    /// >>> import coilsense, numpy
    /// >>> times = numpy.arange(1000) / 1000
    /// >>> spectrum = coilsense.Spectrum(times, 3 * numpy.sin(2 * numpy.pi * 54 * times))
    /// >>> sorted(spectrum.to_dict())
    /// ['amplitudes', 'frequencies']
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let dict = PyDict::new(py);
        dict.set_item("frequencies", self.0.frequencies())?;
        dict.set_item("amplitudes", self.0.amplitudes())?;
        Ok(dict)
    }

    fn __len__(&self) -> usize {
        self.0.amplitudes().len()
    }

    fn __repr__(&self) -> String {
        let frequencies = self.0.frequencies();
        let highest = frequencies.last().copied().unwrap_or_default();
        format!("<Spectrum: {} lines from 0 to {highest} Hz>", frequencies.len())
    }
}

/// Where a line shows after sampling: folded into 0 to half of the rate.
///
/// Parameters
/// ----------
/// frequency : float, str or array_like of float
///     Of the line [Hz].
/// sample_rate : float or str
///     Above zero [Hz].
///
/// Returns
/// -------
/// float or numpy.ndarray, of the shape of the frequency
///     [Hz].
///
/// Notes
/// -----
/// Source: [Oppenheim2010] section 4.2.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> coilsense.alias_of([54.0, 162.0], 100.0)  # surge lines at 54 and 162 Hz, sampled at 100 Hz
/// array([46., 38.])
#[pyfunction(name = "alias_of")]
pub fn py_alias_of<'py>(
    py: Python<'py>,
    frequency: Samples<'py>,
    sample_rate: Quantity,
) -> PyResult<Bound<'py, PyAny>> {
    let sample_rate = sample_rate.si("sample_rate", Dimension::Frequency)?;
    frequency.each(py, "frequency", Dimension::Frequency, |hertz| alias_of(hertz, sample_rate))
}
