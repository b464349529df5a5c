//! `coilsense.MaxwellSum`: the inductance of a coil by its windings, pair by pair.
//!
//! Next door: where windings are (`windings`), the curve that is fitted to measurements (`calibration`).

use coilsense::inductance::{MaxwellSum, SelfDistance};
use coilsense_lab::quantity::Dimension;
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;

use crate::errors::{Error, IntoPython, unknown};
use crate::long_work::{each, of_series};
use crate::noun::Noun;
use crate::samples::Samples;
use crate::series::Series;
use crate::spring::PySpring;
use crate::value::{getters, named_value};
use crate::windings::PyWindings;

/// Words for the self distance.
const DISTANCES: [(&str, SelfDistance); 2] =
    [("as-printed", SelfDistance::AsPrinted), ("geometric-mean", SelfDistance::GeometricMean)];

/// Maxwell's summation: the inductance of a coil as that of rings at its windings, each with each.
///
/// Parameters
/// ----------
/// spring : Spring
/// self_distance : {"geometric-mean", "as-printed"}
///     What distance a ring's own inductance takes: ρ exp(-1/4), the geometric mean distance of a round wire from itself, as ``theories`` has it;
///     or ½ ρ exp(-1/4), as the paper prints.
///
/// Notes
/// -----
/// L = Σ_i Σ_j M(|x_i - x_j|), M of two coaxial rings by complete elliptic integrals. Source: [Weijde2017] eqs. 8 to 11. The ½ of eq. 10
/// belongs to a diameter where Table I gives a radius: it raises L by the constant µ0 r N ln 2, 11 to 14 % of S_T's, which a calibration takes up.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> coil = coilsense.MaxwellSum(coilsense.Spring.of_paper("S_T"))
/// >>> bool(coil.at_lengths([0.2])[0] > coil.at_lengths([0.26])[0])
/// True
#[pyclass(name = "MaxwellSum", module = "coilsense", frozen)]
pub struct PyMaxwellSum {
    /// The sum.
    pub sum: MaxwellSum,
    /// Of what.
    pub spring: coilsense::Spring,
    distance: &'static str,
}

getters! {
    PyMaxwellSum, self;
    /// The spring.
    spring: PySpring = PySpring(self.spring.clone());
    /// What distance a ring's own inductance takes.
    self_distance: &'static str = self.distance;
}

named_value! {
    /// Its arguments by name.
    PyMaxwellSum, self;
    spring, self_distance,
}

#[pymethods]
impl PyMaxwellSum {
    #[new]
    #[pyo3(signature = (spring, self_distance="geometric-mean"))]
    fn new(spring: Noun<'_, PySpring>, self_distance: &str) -> PyResult<Self> {
        let spring = spring.named("spring")?;
        let found = DISTANCES.into_iter().find(|(word, _)| *word == self_distance);
        let known = DISTANCES.map(|(word, _)| word);
        let (distance, kind) = found.ok_or_else(|| unknown("self_distance", &known, self_distance))?;
        Ok(Self { sum: MaxwellSum::new(&spring.0, kind), spring: spring.0.clone(), distance })
    }

    /// The inductance of windings spread uniformly over lengths.
    ///
    /// Parameters
    /// ----------
    /// lengths : float, str or array_like of float
    ///     [m], above zero.
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the lengths
    ///     L [H].
    ///
    /// Raises
    /// ------
    /// Error
    ///     For the first length that is not above zero and finite.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coil = coilsense.MaxwellSum(coilsense.Spring.of_paper("S_T"))
    /// >>> print(f"{1e6 * coil.at_lengths('230 mm'):.2f} µH")
    /// 2.84 µH
    fn at_lengths<'py>(&self, py: Python<'py>, lengths: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        let each_length = lengths.si("lengths", Dimension::Length)?;
        if let Some(place) = each_length.iter().position(|length| !(*length > 0.0 && length.is_finite())) {
            let wrong = each_length[place];
            return Err(Error::new_err(format!("lengths[{place}] must be above zero and finite, got {wrong} m")));
        }
        lengths.shaped(py, each(py, &each_length, |length| self.sum.at_length(length))?)
    }

    /// The inductance of windings that stand somewhere.
    ///
    /// Parameters
    /// ----------
    /// positions : array_like of float, shape (turns,)
    ///     Places of the turns that carry the current along the axis [m].
    ///
    /// Returns
    /// -------
    /// float
    ///     L [H]; infinite where two turns coincide.
    ///
    /// Raises
    /// ------
    /// Error
    ///     For another number of turns, or the first position that is not finite.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense, numpy
    /// >>> coil = coilsense.MaxwellSum(coilsense.Spring.of_paper("S_T"))
    /// >>> uniform = 0.23 * (numpy.arange(52) + 0.5) / 52
    /// >>> round(coil.at_positions(uniform) / coil.at_lengths(0.23), 12)
    /// 1.0
    fn at_positions(&self, positions: Series<'_>) -> PyResult<f64> {
        self.sum.at_positions(&positions.values("positions")?).python()
    }

    /// The inductance at every sample of a motion.
    ///
    /// Parameters
    /// ----------
    /// windings : Windings
    ///
    /// Returns
    /// -------
    /// numpy.ndarray, shape (samples,)
    ///     L [H]; infinite where two turns coincide.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25))
    /// >>> coil = coilsense.MaxwellSum(coilsense.Spring.of_paper("S_T"))
    /// >>> coil.series(motion.windings([0.0, 0.01])).shape
    /// (2,)
    fn series<'py>(slf: &Bound<'py, Self>, windings: Noun<'_, PyWindings>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let windings = windings.named("windings")?;
        let (py, windings) = (slf.py(), windings.to_rust(slf.py())?);
        let turns = slf.get().spring.inductance_windings() as usize;
        let pairs = windings.samples().saturating_mul(turns.saturating_mul(turns) / 2);
        Ok(of_series(slf, pairs, &[], move |coil, _| coil.sum.series(&windings))?.into_pyarray(py))
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other
            .cast::<Self>()
            .is_ok_and(|other| (&other.get().spring, other.get().distance) == (&self.spring, self.distance))
    }
}
