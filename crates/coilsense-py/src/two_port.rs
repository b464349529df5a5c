//! `coilsense.TwoPort` and `Load`: the spring over frequency, for whole arrays of frequencies.
//!
//! Next door: several in series (`cascade`), the motion over time (`motion`).

mod cascade;
mod load;

use coilsense::two_port::{DynamicStiffness, TwoPort};
use coilsense::{Damping, Error as ScienceError};
use num_complex::Complex64;
use numpy::{IntoPyArray, PyArray1, PyArray3, PyArrayMethods};
use pyo3::prelude::*;

use crate::errors::{IntoPython, unknown};
use crate::hertz::angular;
use crate::long_work::each;
use crate::mount::PyDamping;
use crate::results::laid_out;
use crate::series::Series;
use crate::spring::PySpring;
use crate::value::{getters, named_value};
use cascade::Joined;
pub use cascade::PyCascade;
pub use load::PyLoad;

const MODELS: [&str; 2] = ["chain", "wave"];

/// One complex number per frequency.
type Response<'py> = PyResult<Bound<'py, PyArray1<Complex64>>>;

/// One complex 2 x 2 matrix per frequency.
type Matrices<'py> = PyResult<Bound<'py, PyArray3<Complex64>>>;

/// The spring over frequency: two ends, two forces, exact for the chain and for the wave.
///
/// Frequencies are in Hz; time factor e^(j 2 pi f t); displacements about the mean, forces about theirs, tension-positive.
///
/// Parameters
/// ----------
/// spring : Spring
///     The spring.
/// damping : Damping, optional
///     None without it.
/// model : {"chain", "wave"}, optional
///     The paper's chain of N masses, or the continuous coil.
///
/// Raises
/// ------
/// Error
///     Where a number of the damping is above 1e12, or modal ratios are not exactly one for each mass.
///
/// Notes
/// -----
/// Source: [Weijde2017] eqs. 5-7 with harmonic ends. Accurate to 2e-15 (30 + kappa) relative with kappa the logarithmic slope, against
/// 25-digit direct solves.
///
/// Examples
/// --------
/// >>> from coilsense import Damping, Load, Spring, TwoPort
/// >>> ends = TwoPort(Spring.of_paper("S_T"), Damping.modal(0.005))
/// >>> ends.transmittance([10], Load.mass(1.0)).real.round(3)
/// array([1.114])
/// >>> (ends @ ends).drive_point([0]).real  # two in series, a `Cascade`
/// array([380.])
#[pyclass(name = "TwoPort", module = "coilsense", frozen)]
#[derive(Clone, PartialEq)]
pub struct PyTwoPort {
    two_port: TwoPort,
    spring: coilsense::Spring,
    damping: Damping,
    model: &'static str,
}

impl PyTwoPort {
    /// Something at each frequency.
    fn each<T: Send>(
        &self,
        py: Python<'_>,
        frequencies: &Series<'_>,
        part: impl Fn(&DynamicStiffness) -> T + Sync,
    ) -> PyResult<Vec<T>> {
        let frequencies = frequencies.values("frequencies")?;
        let at = |frequency: f64| Ok(part(&self.two_port.at(angular(frequency))?));
        each(py, &frequencies, at)?.into_iter().collect::<Result<_, ScienceError>>().python()
    }

    fn matrices<'py>(
        &self,
        py: Python<'py>,
        frequencies: &Series<'_>,
        part: impl Fn(&DynamicStiffness) -> [[Complex64; 2]; 2] + Sync,
    ) -> Matrices<'py> {
        matrices(py, self.each(py, frequencies, part)?)
    }
}

/// Matrices as an array of shape `count × 2 × 2`.
fn matrices(py: Python<'_>, matrices: Vec<[[Complex64; 2]; 2]>) -> Matrices<'_> {
    let count = matrices.len();
    matrices.into_flattened().into_flattened().into_pyarray(py).reshape([count, 2, 2])
}

getters! {
    PyTwoPort, self;
    /// The spring.
    spring: PySpring = PySpring(self.spring.clone());
    /// What damps it.
    damping: PyDamping = PyDamping(self.damping.clone());
    /// "chain" or "wave".
    model: &'static str = self.model;
}

named_value! {
    /// The arguments by name, nouns as dicts of their own.
    PyTwoPort, self;
    spring, damping, model,
}

#[pymethods]
impl PyTwoPort {
    #[new]
    #[pyo3(signature = (spring, damping=None, model="chain"))]
    fn new(spring: &PySpring, damping: Option<PyRef<'_, PyDamping>>, model: &str) -> PyResult<Self> {
        let damping = damping.map_or(Damping::None, |damping| damping.0.clone());
        let (two_port, model) = match model {
            "chain" => (TwoPort::chain(&spring.0, damping.clone()), MODELS[0]),
            "wave" => (TwoPort::wave(&spring.0, damping.clone()), MODELS[1]),
            _ => return Err(unknown("model", &MODELS, model)),
        };
        Ok(Self { two_port: two_port.python()?, spring: spring.0.clone(), damping, model })
    }

    /// Drive-point stiffness: -F_i/U1 with end 2 held, and F_o/U2 with end 1 held.
    ///
    /// Parameters
    /// ----------
    /// frequencies : array_like of float, shape (samples,)
    ///     f [Hz], of either sign.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray of complex, shape (samples,)
    ///     k_d [N/m].
    fn drive_point<'py>(&self, py: Python<'py>, frequencies: Series<'_>) -> Response<'py> {
        Ok(self.each(py, &frequencies, DynamicStiffness::drive_point)?.into_pyarray(py))
    }

    /// Transfer stiffness: F_i/U2 with end 1 held, and -F_o/U1 with end 2 held.
    ///
    /// Parameters
    /// ----------
    /// frequencies : array_like of float, shape (samples,)
    ///     f [Hz].
    ///
    /// Returns
    /// -------
    /// numpy.ndarray of complex, shape (samples,)
    ///     k_t [N/m].
    fn transfer<'py>(&self, py: Python<'py>, frequencies: Series<'_>) -> Response<'py> {
        Ok(self.each(py, &frequencies, DynamicStiffness::transfer)?.into_pyarray(py))
    }

    /// Force out over force in: F_o/F_i with a load on end 2.
    ///
    /// Parameters
    /// ----------
    /// frequencies : array_like of float, shape (samples,)
    ///     f [Hz].
    /// load : Load, optional
    ///     On end 2; held without it.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray of complex, shape (samples,)
    ///     [1].
    ///
    /// Notes
    /// -----
    /// Source: [Weijde2017] eq. 1 with chain, damping and load.
    #[pyo3(signature = (frequencies, load=None))]
    fn transmittance<'py>(
        &self,
        py: Python<'py>,
        frequencies: Series<'_>,
        load: Option<PyRef<'_, PyLoad>>,
    ) -> Response<'py> {
        let load = load::given(load);
        Ok(self.each(py, &frequencies, |at| at.transmittance(&load))?.into_pyarray(py))
    }

    /// How far end 2 follows end 1: U2/U1 with a load on end 2.
    ///
    /// Parameters
    /// ----------
    /// frequencies : array_like of float, shape (samples,)
    ///     f [Hz].
    /// load : Load, optional
    ///     On end 2; held without it.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray of complex, shape (samples,)
    ///     [1].
    #[pyo3(signature = (frequencies, load=None))]
    fn motion_ratio<'py>(
        &self,
        py: Python<'py>,
        frequencies: Series<'_>,
        load: Option<PyRef<'_, PyLoad>>,
    ) -> Response<'py> {
        let load = load::given(load);
        Ok(self.each(py, &frequencies, |at| at.motion_ratio(&load))?.into_pyarray(py))
    }

    /// Stiffness at end 1 with a load on end 2: -F_i/U1.
    ///
    /// Parameters
    /// ----------
    /// frequencies : array_like of float, shape (samples,)
    ///     f [Hz].
    /// load : Load, optional
    ///     On end 2; held without it.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray of complex, shape (samples,)
    ///     [N/m].
    #[pyo3(signature = (frequencies, load=None))]
    fn loaded<'py>(&self, py: Python<'py>, frequencies: Series<'_>, load: Option<PyRef<'_, PyLoad>>) -> Response<'py> {
        let load = load::given(load);
        Ok(self.each(py, &frequencies, |at| at.loaded(&load))?.into_pyarray(py))
    }

    /// Dynamic stiffness matrices D: [F_i; F_o] = D [U1; U2].
    ///
    /// Parameters
    /// ----------
    /// frequencies : array_like of float, shape (samples,)
    ///     f [Hz].
    ///
    /// Returns
    /// -------
    /// numpy.ndarray of complex, shape (samples, 2, 2)
    ///     [N/m].
    fn matrix<'py>(&self, py: Python<'py>, frequencies: Series<'_>) -> Matrices<'py> {
        self.matrices(py, &frequencies, DynamicStiffness::matrix)
    }

    /// Receptances, the inverse of `matrix`: [U1; U2] = R [F_i; F_o].
    ///
    /// Parameters
    /// ----------
    /// frequencies : array_like of float, shape (samples,)
    ///     f [Hz]; infinite at zero, where a free spring floats away.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray of complex, shape (samples, 2, 2)
    ///     [m/N].
    fn receptance<'py>(&self, py: Python<'py>, frequencies: Series<'_>) -> Matrices<'py> {
        self.matrices(py, &frequencies, DynamicStiffness::receptance)
    }

    /// Transmission (ABCD) matrices: [U2; F_o] = T [U1; F_i]; springs in series multiply, T of end 1's last.
    ///
    /// Parameters
    /// ----------
    /// frequencies : array_like of float, shape (samples,)
    ///     f [Hz].
    ///
    /// Returns
    /// -------
    /// numpy.ndarray of complex, shape (samples, 2, 2)
    ///     [1, m/N; N/m, 1].
    fn transmission<'py>(&self, py: Python<'py>, frequencies: Series<'_>) -> Matrices<'py> {
        self.matrices(py, &frequencies, DynamicStiffness::transmission)
    }

    fn __matmul__(slf: PyRef<'_, Self>, other: Joined<'_>) -> PyResult<PyCascade> {
        PyCascade::joined(&Joined::Spring(slf), &other)
    }

    /// Draws drive-point and transfer stiffness over frequency with matplotlib; ``pip install coilsense[plot]``.
    ///
    /// Parameters
    /// ----------
    /// frequencies : array_like of float, shape (samples,)
    ///     f [Hz].
    /// ax : matplotlib.axes.Axes, optional
    ///     Where; without it, in a new figure.
    ///
    /// Returns
    /// -------
    /// matplotlib.axes.Axes
    #[pyo3(signature = (frequencies, ax=None))]
    fn plot<'py>(
        slf: &Bound<'py, Self>,
        frequencies: Series<'py>,
        ax: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let frequencies = frequencies.to_vec("frequencies")?.into_pyarray(slf.py());
        laid_out(slf.py(), "two_port_plot", (slf, frequencies, ax))
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| self == other.get())
    }
}
