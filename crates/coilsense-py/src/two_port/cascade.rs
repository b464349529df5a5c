//! `coilsense.Cascade`: springs, links and masses in series, over frequency.
//!
//! Next door: one spring (the parent), what hangs on the last end (`load`).

use coilsense::End;
use coilsense::Error as ScienceError;
use coilsense::two_port::{Cascade, Matrix, Transmission};
use coilsense_lab::quantity::Dimension;
use num_complex::Complex64;
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::{Matrices, PyLoad, PyTwoPort, Response, load, matrices};
use crate::errors::{IntoPython, refused};
use crate::hertz::angular;
use crate::long_work::each;
use crate::quantity::Quantity;
use crate::series::Series;
use crate::value::{Arguments, Kind};

/// What makes it anew, and kind and arguments of each part.
type Reduced<'py> = (Bound<'py, PyAny>, (Vec<(&'static str, Arguments<'py>)>,));

/// Two-ports in series: end 2 of each joined to end 1 of the next, as `left @ right` makes it.
///
/// At a joint both parts have one position and one tension; a rigid mass is a part of its own, over which the tension differs by what accelerates
/// it. Frequencies, signs and loads are those of `TwoPort`.
///
/// Parameters
/// ----------
/// parts : sequence of TwoPort and Cascade
///     From end 1 to end 2, at least one.
///
/// Raises
/// ------
/// Error
///     For no part.
///
/// Notes
/// -----
/// Source: [Weijde2017] eqs. 5-7 for the springs; chain matrices multiply. Two halves of an undamped chain are the whole to 1e-11; damping by
/// ratios, mass or stiffness acts about a straight line between the ends of each part, so that two damped halves are not the whole.
/// A mass that rings undamped between two held ends is a resonance as any other: stiffnesses are infinite there, and so are those of a rigid mass
/// by itself; `transmission` and the ratios keep their limits.
///
/// Examples
/// --------
/// >>> from coilsense import Cascade, Damping, Load, Spring, TwoPort
/// >>> spring = TwoPort(Spring.of_paper("S_T"), Damping.modal(0.005))
/// >>> leg = Cascade.mass(1.0) @ Cascade.link(stiffness=3e4, damping=20.0)
/// >>> ankle = spring @ leg  # the load cell is under the skin
/// >>> abs(ankle.transmittance([1, 10], Load.held())).round(3)
/// array([1.003, 1.393])
#[pyclass(name = "Cascade", module = "coilsense", frozen)]
pub struct PyCascade {
    cascade: Cascade,
    parts: Vec<Part>,
}

/// One of them, as it was made.
#[derive(Clone, PartialEq)]
enum Part {
    Spring(PyTwoPort),
    Link { stiffness: f64, damping: f64 },
    Mass(f64),
}

/// What `@` takes.
#[derive(FromPyObject)]
pub enum Joined<'py> {
    /// A spring.
    Spring(PyRef<'py, PyTwoPort>),
    /// What was joined, or a link, or a mass.
    Cascade(PyRef<'py, PyCascade>),
}

impl Joined<'_> {
    fn parts(&self) -> Vec<Part> {
        match self {
            Self::Spring(spring) => vec![Part::Spring((**spring).clone())],
            Self::Cascade(cascade) => cascade.parts.clone(),
        }
    }
}

impl Part {
    fn science(&self) -> Result<Cascade, ScienceError> {
        match self {
            Self::Spring(spring) => Ok(spring.two_port.clone().into()),
            Self::Link { stiffness, damping } => Cascade::link(*stiffness, *damping),
            Self::Mass(mass) => Cascade::mass(*mass),
        }
    }

    fn as_kind<'py>(&self, py: Python<'py>) -> PyResult<Kind<'py>> {
        match self {
            Self::Spring(spring) => Ok(Kind { name: "spring", arguments: spring.arguments(py)? }),
            Self::Link { stiffness, damping } => {
                Kind::new(py, "link").with("stiffness", *stiffness)?.with("damping", *damping)
            }
            Self::Mass(mass) => Kind::new(py, "mass").with("mass", *mass),
        }
    }

    fn shown(&self, py: Python<'_>) -> PyResult<String> {
        match self {
            Self::Spring(spring) => spring.__repr__(py),
            _ => self.as_kind(py)?.shown("Cascade"),
        }
    }

    /// The noun that it is by itself.
    fn noun<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        match self {
            Self::Spring(spring) => Ok(Bound::new(py, spring.clone())?.into_any()),
            _ => Ok(Bound::new(py, PyCascade::of(vec![self.clone()])?)?.into_any()),
        }
    }
}

impl PyCascade {
    fn of(parts: Vec<Part>) -> PyResult<Self> {
        let mut each = parts.iter().map(Part::science);
        let Some(first) = each.next() else {
            return Err(refused("parts must hold at least 1 two-port, got 0"));
        };
        let cascade = first.and_then(|first| each.try_fold(first, |joined, next| Ok(joined.then(&next?))));
        Ok(Self { cascade: cascade.python()?, parts })
    }

    /// What `left @ right` is.
    pub fn joined(left: &Joined<'_>, right: &Joined<'_>) -> PyResult<Self> {
        Self::of(left.parts().into_iter().chain(right.parts()).collect())
    }

    /// Something at each frequency.
    fn each<T: Send>(
        &self,
        py: Python<'_>,
        frequencies: &Series<'_>,
        part: impl Fn(&Transmission) -> T + Sync,
    ) -> PyResult<Vec<T>> {
        let at = |frequency: f64| Ok(part(&self.cascade.at(angular(frequency))?));
        each(py, &frequencies.values("frequencies")?, at)?.into_iter().collect::<Result<_, ScienceError>>().python()
    }

    fn response<'py>(
        &self,
        py: Python<'py>,
        frequencies: &Series<'_>,
        part: impl Fn(&Transmission) -> Complex64 + Sync,
    ) -> Response<'py> {
        Ok(self.each(py, frequencies, part)?.into_pyarray(py))
    }

    fn matrices<'py>(
        &self,
        py: Python<'py>,
        frequencies: &Series<'_>,
        part: impl Fn(&Transmission) -> Matrix + Sync,
    ) -> Matrices<'py> {
        matrices(py, self.each(py, frequencies, part)?)
    }
}

#[pymethods]
impl PyCascade {
    #[new]
    fn new(parts: Vec<Joined<'_>>) -> PyResult<Self> {
        Self::of(parts.iter().flat_map(Joined::parts).collect())
    }

    /// A rigid mass.
    ///
    /// Parameters
    /// ----------
    /// mass : float or str
    ///     M [kg], from zero on.
    ///
    /// Returns
    /// -------
    /// Cascade
    #[staticmethod]
    fn mass(mass: Quantity) -> PyResult<Self> {
        Self::of(vec![Part::Mass(mass.si("mass", Dimension::Mass)?)])
    }

    /// An ideal spring beside a dashpot, without mass.
    ///
    /// Parameters
    /// ----------
    /// stiffness : float or str
    ///     k [N/m], from zero on.
    /// damping : float
    ///     c [N s/m], from zero on; not both are zero.
    ///
    /// Returns
    /// -------
    /// Cascade
    #[staticmethod]
    #[pyo3(signature = (stiffness, damping=0.0))]
    fn link(stiffness: Quantity, damping: f64) -> PyResult<Self> {
        Self::of(vec![Part::Link { stiffness: stiffness.si("stiffness", Dimension::Stiffness)?, damping }])
    }

    /// Its parts from end 1 to end 2, as a list of `TwoPort` and of `Cascade` with one part.
    #[getter]
    fn parts<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        self.parts.iter().map(|part| part.noun(py)).collect()
    }

    /// Drive-point stiffnesses: -F_i/U1 with end 2 held, and F_o/U2 with end 1 held.
    ///
    /// Parameters
    /// ----------
    /// frequencies : array_like of float, shape (samples,)
    ///     f [Hz], of either sign.
    /// end : int, optional
    ///     Which end moves, 1 or 2; 1 without it.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray of complex, shape (samples,)
    ///     [N/m].
    #[pyo3(signature = (frequencies, end=1))]
    fn drive_point<'py>(&self, py: Python<'py>, frequencies: Series<'_>, end: i64) -> Response<'py> {
        let end = match end {
            1 => End::One,
            2 => End::Two,
            other => return Err(refused(format!("end must be 1 or 2, got {other}"))),
        };
        self.response(py, &frequencies, |at| at.drive_point(end))
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
    ///     [N/m].
    fn transfer<'py>(&self, py: Python<'py>, frequencies: Series<'_>) -> Response<'py> {
        self.response(py, &frequencies, Transmission::transfer)
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
    #[pyo3(signature = (frequencies, load=None))]
    fn transmittance<'py>(
        &self,
        py: Python<'py>,
        frequencies: Series<'_>,
        load: Option<PyRef<'_, PyLoad>>,
    ) -> Response<'py> {
        let load = load::given(load);
        self.response(py, &frequencies, |at| at.transmittance(&load))
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
        self.response(py, &frequencies, |at| at.motion_ratio(&load))
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
        self.response(py, &frequencies, |at| at.loaded(&load))
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
    ///     [N/m]; infinite where the ends cannot move apart.
    fn matrix<'py>(&self, py: Python<'py>, frequencies: Series<'_>) -> Matrices<'py> {
        self.matrices(py, &frequencies, Transmission::matrix)
    }

    /// Receptances, the inverse of `matrix`: [U1; U2] = R [F_i; F_o].
    ///
    /// Parameters
    /// ----------
    /// frequencies : array_like of float, shape (samples,)
    ///     f [Hz]; infinite at zero, where all floats away.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray of complex, shape (samples, 2, 2)
    ///     [m/N].
    fn receptance<'py>(&self, py: Python<'py>, frequencies: Series<'_>) -> Matrices<'py> {
        self.matrices(py, &frequencies, Transmission::receptance)
    }

    /// Transmission (ABCD) matrices: [U2; F_o] = T [U1; F_i]; those of parts in series multiply, T of end 1's last.
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
        self.matrices(py, &frequencies, Transmission::transmission)
    }

    /// The kind and the arguments of each part.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let parts = self.parts.iter().map(|part| part.as_kind(py)?.to_dict()).collect::<PyResult<Vec<_>>>()?;
        let dict = PyDict::new(py);
        dict.set_item("parts", parts)?;
        Ok(dict)
    }

    fn __matmul__(slf: PyRef<'_, Self>, other: Joined<'_>) -> PyResult<Self> {
        Self::joined(&Joined::Cascade(slf), &other)
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| self.parts == other.get().parts)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Reduced<'py>> {
        let (py, parts) = (slf.py(), &slf.get().parts);
        let kind = |part: &Part| part.as_kind(py).map(|kind| (kind.name, kind.arguments));
        let make = py.import("coilsense._pickle")?.getattr("cascade")?;
        Ok((make, (parts.iter().map(kind).collect::<PyResult<_>>()?,)))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let parts = self.parts.iter().map(|part| part.shown(py)).collect::<PyResult<Vec<_>>>()?;
        Ok(parts.join(" @ "))
    }
}
