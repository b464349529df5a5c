//! `coilsense.ChainModes`, and the frequencies of the continuous coil.
//!
//! Next door: the motion that they make (`motion`), the same over frequency (`two_port`).

use coilsense::modes::{
    ChainModes, continuous_frequencies, continuous_frequency, third_rule_error, third_rule_frequency,
};
use coilsense_lab::quantity::Dimension;
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::count::Count;
use crate::errors::{Error, IntoPython};
use crate::hertz::{all_in_hertz, in_hertz};
use crate::mount::PyFarEnd;
use crate::noun::{Noun, named};
use crate::quantity::Quantity;
use crate::results::table_and_figure;
use crate::spring::PySpring;
use crate::value::{Arguments, getters};

/// The modes of the paper's chain of N winding masses on its mount, lowest first.
///
/// Parameters
/// ----------
/// spring : Spring
///     The spring.
/// far_end : FarEnd, optional
///     What end 2 is tied to; without it a prescribed position.
///
/// Notes
/// -----
/// omega_j = 2 N sqrt(k/m) sin(theta_j / 2), theta_j = j pi / N with both positions prescribed. Source: [Weijde2017] eqs. 5-6, a DST-II
/// chain. Accurate to 4e-16 relative, against an eigen-solver. No damping.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> modes = coilsense.ChainModes(coilsense.Spring.of_paper("S_T"))
/// >>> round(modes.frequencies[0], 3)
/// np.float64(54.057)
#[pyclass(name = "ChainModes", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyChainModes(pub ChainModes);

getters! {
    PyChainModes, self;
    /// How many modes there are: N, and one more with an end mass.
    count: usize = self.0.count();
    /// N: winding masses.
    masses: usize = self.0.masses();
    /// What end 2 is tied to.
    far_end: PyFarEnd = PyFarEnd(self.0.far_end());
    /// f_j [Hz], shape (count,).
    frequencies<'py>(py): Bound<'py, PyArray1<f64>> = all_in_hertz(self.0.frequencies()).into_pyarray(py);
    /// omega_j = 2 pi f_j [rad/s], shape (count,).
    angular_frequencies<'py>(py): Bound<'py, PyArray1<f64>> = PyArray1::from_slice(py, self.0.frequencies());
    /// How far end 2 moves in each mode, in units of its shape, shape (count,); zero where its position is prescribed.
    end_shapes<'py>(py): Bound<'py, PyArray1<f64>> = PyArray1::from_slice(py, self.0.end_shapes());
}

table_and_figure! {
    PyChainModes;
    /// The modes as a data frame of pandas: number, frequency [Hz] and how far end 2 moves; ``pip install coilsense[pandas]``.
    to_pandas = "modes_frame";
    /// Draws frequencies over the number of the mode with matplotlib; ``pip install coilsense[plot]``.
    plot = "modes_plot";
}

#[pymethods]
impl PyChainModes {
    #[new]
    #[pyo3(signature = (spring, far_end=None))]
    fn new(py: Python<'_>, spring: Noun<'_, PySpring>, far_end: Option<Noun<'_, PyFarEnd>>) -> PyResult<Self> {
        let spring = spring.named("spring")?;
        let far_end = named(far_end.as_ref(), "far_end")?;
        let far_end = far_end.map_or_else(Default::default, |far_end| far_end.0);
        Ok(Self(py.detach(|| ChainModes::mounted(&spring.0, far_end))))
    }

    /// Shape of one mode at every winding.
    ///
    /// Parameters
    /// ----------
    /// mode : int
    ///     From 1 to `count`.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray, shape (N,)
    ///     phi_j(i) = sin(theta_j (i - 1/2)) [1].
    ///
    /// Raises
    /// ------
    /// Error
    ///     For a mode that is not there.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> modes = coilsense.ChainModes(coilsense.Spring.of_paper("S_T"))
    /// >>> modes.shape(1).shape, bool((modes.shape(1) > 0).all())
    /// ((52,), True)
    fn shape<'py>(&self, py: Python<'py>, mode: Count) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let mode = mode.size("mode")?;
        let each = (1..=self.0.masses()).map(|winding| self.0.shape(mode, winding));
        Ok(each.collect::<Result<Vec<_>, _>>().python()?.into_pyarray(py))
    }

    /// The frequencies [Hz] by name.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let dict = PyDict::new(py);
        dict.set_item("masses", self.0.masses())?;
        dict.set_item("far_end", self.far_end().into_pyobject(py)?.call_method0("to_dict")?)?;
        dict.set_item("frequencies", all_in_hertz(self.0.frequencies()))?;
        Ok(dict)
    }

    fn __len__(&self) -> usize {
        self.0.count()
    }

    fn __repr__(&self) -> String {
        let lowest = self.0.frequencies().first().map_or(f64::NAN, |omega| in_hertz(*omega));
        format!("<ChainModes: {} of {} masses, the lowest at {lowest:.6} Hz>", self.0.count(), self.0.masses())
    }
}

/// Surge frequency of a mode of the continuous coil with both ends held.
///
/// Parameters
/// ----------
/// transit_time : float or str
///     tau [s], above zero.
/// mode : int
///     j, at least 1.
///
/// Returns
/// -------
/// float
///     f_j = j / (2 tau) [Hz].
///
/// Notes
/// -----
/// Source: [Weijde2017] eq. 3.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> spring = coilsense.Spring.of_paper("S_T")
/// >>> round(coilsense.continuous_frequency(spring.transit_time, 2), 2)
/// 108.13
#[pyfunction(name = "continuous_frequency")]
pub fn py_continuous_frequency(transit_time: Quantity, mode: Count) -> PyResult<f64> {
    let (transit_time, mode) = (transit_time.si("transit_time", Dimension::Time)?, mode.size("mode")?);
    if mode == 0 || transit_time.is_nan() || transit_time <= 0.0 {
        return Err(Error::new_err(format!(
            "transit time must be above zero and mode at least 1, got {transit_time} s and {mode}"
        )));
    }
    Ok(in_hertz(continuous_frequency(transit_time, mode)))
}

/// Surge frequencies of the continuous coil with end 2 tied to anything.
///
/// Parameters
/// ----------
/// spring : Spring
///     The spring.
/// far_end : FarEnd
///     What end 2 is tied to.
/// count : int
///     How many, lowest first.
///
/// Returns
/// -------
/// numpy.ndarray, shape (count,)
///     f_j [Hz]; with an end mass by the roots of beta tan beta = m/M, beta = 2 pi f tau.
///
/// Raises
/// ------
/// Error
///     For an end mass that is not above zero, or a count that is not from 1 to a million.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> spring = coilsense.Spring.of_paper("S_T")
/// >>> coilsense.continuous_frequencies(spring, coilsense.FarEnd.position(), 3).round(2)
/// array([ 54.07, 108.13, 162.2 ])
#[pyfunction(name = "continuous_frequencies")]
pub fn py_continuous_frequencies<'py>(
    py: Python<'py>,
    spring: Noun<'_, PySpring>,
    far_end: Noun<'_, PyFarEnd>,
    count: Count,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let spring = spring.named("spring")?;
    let far_end = far_end.named("far_end")?;
    let count = count.size("count")?;
    let found = py.detach(|| continuous_frequencies(&spring.0, far_end.0, count)).python()?;
    Ok(all_in_hertz(&found).into_pyarray(py))
}

/// First frequency of a spring with an end mass by the rule that a third of its mass swings along.
///
/// Parameters
/// ----------
/// spring : Spring
///     The spring.
/// end_mass : float or str
///     M [kg].
///
/// Returns
/// -------
/// float
///     sqrt(k / (M + m/3)) / (2 pi) [Hz].
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> spring = coilsense.Spring.of_paper("S_T")
/// >>> round(coilsense.third_rule_frequency(spring, "500 g"), 3)
/// 6.075
#[pyfunction(name = "third_rule_frequency")]
pub fn py_third_rule_frequency(spring: Noun<'_, PySpring>, end_mass: Quantity) -> PyResult<f64> {
    let spring = spring.named("spring")?;
    let end_mass = end_mass.si("end_mass", Dimension::Mass)?;
    third_rule_frequency(&spring.0, end_mass).python().map(in_hertz)
}

/// How far that rule is off against the continuous coil.
///
/// Parameters
/// ----------
/// spring : Spring
///     The spring.
/// end_mass : float or str
///     M [kg].
///
/// Returns
/// -------
/// float
///     As a share of the frequency [1].
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> spring = coilsense.Spring.of_paper("S_T")
/// >>> round(coilsense.third_rule_error(spring, "10 g"), 3)
/// 0.05
#[pyfunction(name = "third_rule_error")]
pub fn py_third_rule_error(spring: Noun<'_, PySpring>, end_mass: Quantity) -> PyResult<f64> {
    let spring = spring.named("spring")?;
    let end_mass = end_mass.si("end_mass", Dimension::Mass)?;
    third_rule_error(&spring.0, end_mass).python()
}
