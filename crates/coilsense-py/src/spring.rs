//! `coilsense.Spring`.
//!
//! Next door: from wire and coil (`geometry`), what is done to it (`excitation`).

use std::sync::Arc;

use coilsense::sections::{Section, Sections};
use coilsense::{Spring, SpringParameters};
use coilsense_lab::quantity::Dimension::{Force, Length, Mass, Stiffness};
use coilsense_lab::spec::{Spec, template};
use pyo3::prelude::*;
use pyo3::types::IntoPyDict;

use crate::errors::{IntoPython, refused, unknown};
use crate::names::Word;
use crate::quantity::{Quantity, si};
use crate::samples::Samples;
use crate::value::{Arguments, getters, named_value};

/// Springs of the paper's Table I.
const OF_PAPER: [&str; 2] = ["S_T", "S_A"];

/// A spring whose every value has been checked.
///
/// Parameters
/// ----------
/// rest_length : float or str
///     l0, length without force [m].
/// windings : float
///     N, active windings [1]; may be fractional.
/// coil_radius : float or str
///     r, from the coil's axis to the centre of the wire [m].
/// wire_radius : float or str
///     Radius of the wire [m].
/// mass : float or str
///     m, mass of the active coil [kg].
/// stiffness : float or str
///     k [N/m].
/// min_length, max_length : float or str
///     Shortest and longest length in use [m].
/// nominal_force : float or str, optional
///     F_nom [N]; without it k max(\|min_length - l0\|, \|max_length - l0\|).
/// inductance_windings : float, optional
///     Windings that carry the current [1]; without it the active ones.
///
/// Raises
/// ------
/// Error
///     For the first value that is not finite, not above zero, a wire that is not thinner than the coil, an operating range that
///     is empty or reversed, or a mass that no wire of these dimensions has (250 to 250,000 kg/m^3 are taken): grams for kilograms, or
///     millimetres for metres.
///
/// Notes
/// -----
/// Source: Table I of van der Weijde, van Ostayen and Vallery [Weijde2017].
///
/// Examples
/// --------
/// >>> from coilsense import Spring
/// >>> spring = Spring(rest_length=0.104, windings=52, coil_radius=0.008, wire_radius=0.001, mass=0.065, stiffness=760,
/// ...                 min_length=0.196, max_length=0.264)
/// >>> spring == Spring.of_paper("S_T")
/// True
/// >>> round(spring.surge_frequency, 3)
/// 54.065
#[pyclass(name = "Spring", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PySpring(pub Spring);

getters! {
    PySpring, self;
    /// l0: length without force [m].
    rest_length: f64 = self.0.rest_length();
    /// N: active windings [1], may be fractional.
    windings: f64 = self.0.windings();
    /// r: radius of the coil to the centre of the wire [m].
    coil_radius: f64 = self.0.coil_radius();
    /// Radius of the wire [m].
    wire_radius: f64 = self.0.wire_radius();
    /// Diameter of the wire [m].
    wire_diameter: f64 = self.0.wire_diameter();
    /// m: mass of the active coil [kg].
    mass: f64 = self.0.mass();
    /// k: stiffness [N/m].
    stiffness: f64 = self.0.stiffness();
    /// Windings that carry the current [1].
    inductance_windings: f64 = self.0.inductance_windings();
    /// Masses of the chain that stands for the spring: the active windings rounded, at least 1.
    chain_masses: usize = self.0.chain_masses();
    /// Shortest length in use [m].
    min_length: f64 = self.0.operating_range().0;
    /// Longest length in use [m].
    max_length: f64 = self.0.operating_range().1;
    /// Shortest and longest length in use [m], as a tuple.
    operating_range: (f64, f64) = self.0.operating_range();
    /// Half way through the operating range [m].
    mid_length: f64 = self.0.mid_length();
    /// Time in which a surge wave runs through the coil once [s]: tau = sqrt(m/k). Source: [Weijde2017] eq. 2.
    transit_time: f64 = self.0.transit_time();
    /// f1: first surge frequency of the continuous coil with both ends held [Hz]: 1/(2 tau). Source: [Weijde2017] eq. 3.
    surge_frequency: f64 = self.0.surge_frequency();
    /// F_nom: largest static force in use [N]. Source: [Weijde2017] eq. 14.
    nominal_force: f64 = self.0.nominal_force();
    /// Wave impedance [N s/m]: sqrt(k m), what an impact adds to an end force per m/s.
    wave_impedance: f64 = self.0.wave_impedance();
    /// Length with all active windings touching [m].
    solid_length: f64 = self.0.solid_length();
}

/// The sections of a coil: windings, pitches, coil diameters [m], wire diameter [m] and whether it telescopes, of each; shear modulus [Pa] and density [kg/m³].
type Wound = (Vec<(f64, [f64; 2], [f64; 2], f64, bool)>, f64, f64);

fn wound((sections, shear_modulus, density): Wound) -> PyResult<Arc<Sections>> {
    let each = sections.into_iter().map(|(windings, pitch, coil_diameter, wire_diameter, telescopes)| Section {
        windings,
        pitch,
        coil_diameter,
        wire_diameter,
        telescopes,
    });
    Sections::new(each.collect(), shear_modulus, density).map(Arc::new).python()
}

fn unwound(coil: &Sections) -> Wound {
    let each = coil.sections().iter().map(|section| {
        let Section { windings, pitch, coil_diameter, wire_diameter, telescopes } = *section;
        (windings, pitch, coil_diameter, wire_diameter, telescopes)
    });
    (each.collect(), coil.shear_modulus(), coil.density())
}

named_value! {
    /// The parameters by name, as the constructor takes them.
    PySpring, self, made = |slf| {
        let (py, class, spring) = (slf.py(), slf.get_type().into_any(), &slf.get().0);
        if spring.sections().is_some() {
            let told = "a spring of a spec's [[spring.section]] tables is made of these: change them there";
            return Err(refused(told));
        }
        let masses = spring.masses_per_winding();
        if masses == 1 && spring.check_wire().is_ok() {
            return Ok(class);
        }
        // One of a spec whose mass is that of no wire may go on having it, and its chain is as fine.
        let partial = py.import("functools")?.getattr("partial")?;
        partial.call((class.getattr("_kept")?,), Some(&[("masses_per_winding", masses)].into_py_dict(py)?))
    };
    rest_length, windings, coil_radius, wire_radius, mass, stiffness, min_length, max_length,
    nominal_force = self.0.parameters().nominal_force,
    inductance_windings = self.0.parameters().inductance_windings,
}

#[pymethods]
impl PySpring {
    #[new]
    #[pyo3(signature = (*, rest_length, windings, coil_radius, wire_radius, mass, stiffness, min_length, max_length,
                        nominal_force=None, inductance_windings=None))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python, one per value of Table I")]
    fn new(
        rest_length: Quantity,
        windings: Quantity,
        coil_radius: Quantity,
        wire_radius: Quantity,
        mass: Quantity,
        stiffness: Quantity,
        min_length: Quantity,
        max_length: Quantity,
        nominal_force: Option<Quantity>,
        inductance_windings: Option<Quantity>,
    ) -> PyResult<Self> {
        let spring = Self::_kept(
            rest_length,
            windings,
            coil_radius,
            wire_radius,
            mass,
            stiffness,
            min_length,
            max_length,
            nominal_force,
            inductance_windings,
            1,
            None,
        )?;
        spring.0.check_wire().python()?;
        Ok(spring)
    }

    /// A spring of checked values, whatever its wire would weigh, and with what a spec alone tells of it: what unpickling calls.
    #[staticmethod]
    #[pyo3(signature = (*, rest_length, windings, coil_radius, wire_radius, mass, stiffness, min_length, max_length,
                        nominal_force=None, inductance_windings=None, masses_per_winding=1, sections=None))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python, one per value of Table I")]
    fn _kept(
        rest_length: Quantity,
        windings: Quantity,
        coil_radius: Quantity,
        wire_radius: Quantity,
        mass: Quantity,
        stiffness: Quantity,
        min_length: Quantity,
        max_length: Quantity,
        nominal_force: Option<Quantity>,
        inductance_windings: Option<Quantity>,
        masses_per_winding: usize,
        sections: Option<Wound>,
    ) -> PyResult<Self> {
        let parameters = SpringParameters {
            rest_length: rest_length.si("rest_length", Length)?,
            windings: windings.plain("windings")?,
            coil_radius: coil_radius.si("coil_radius", Length)?,
            wire_radius: wire_radius.si("wire_radius", Length)?,
            mass: mass.si("mass", Mass)?,
            stiffness: stiffness.si("stiffness", Stiffness)?,
            min_length: min_length.si("min_length", Length)?,
            max_length: max_length.si("max_length", Length)?,
            nominal_force: si(nominal_force.as_ref(), "nominal_force", Force)?,
            inductance_windings: inductance_windings.map(|count| count.plain("inductance_windings")).transpose()?,
            sections: sections.map(wound).transpose()?,
        };
        Spring::new(parameters).and_then(|spring| spring.with_masses_per_winding(masses_per_winding)).python().map(Self)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (Arguments<'py>,))> {
        let (py, spring) = (slf.py(), &slf.get().0);
        let arguments = slf.get().arguments(py)?;
        arguments.set_item("masses_per_winding", spring.masses_per_winding())?;
        arguments.set_item("sections", spring.sections().map(unwound))?;
        Ok((py.import("coilsense._pickle")?.getattr("spring")?, (arguments,)))
    }

    /// A spring of the paper's Table I.
    ///
    /// Parameters
    /// ----------
    /// name : {"S_T", "S_A"}
    ///     S_T is the ankle spring of the humanoid TUlip, S_A that of the lower-leg prosthesis ANGELAA.
    ///
    /// Returns
    /// -------
    /// Spring
    ///
    /// Raises
    /// ------
    /// Error
    ///     For another name.
    ///
    /// Notes
    /// -----
    /// Source: [Weijde2017] Table I.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> round(coilsense.Spring.of_paper("S_A").surge_frequency, 2)
    /// 168.63
    #[staticmethod]
    fn of_paper(name: Word) -> PyResult<Self> {
        let name = name.text("name")?;
        if !OF_PAPER.contains(&name) {
            return Err(unknown("spring of the paper", &OF_PAPER, name));
        }
        let spec = Spec::parse(name, &template(Some(name)).python()?, &|_| Err(String::new())).python()?;
        Ok(Self(spec.spring.spring))
    }

    /// Distance from winding to winding when they are spread uniformly over a length.
    ///
    /// Parameters
    /// ----------
    /// length : float, str or array_like of float
    ///     l [m].
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the length
    ///     l/N [m].
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> spring = coilsense.Spring.of_paper("S_T")
    /// >>> print(f"{1e3 * spring.pitch_at('208 mm'):.1f} mm")
    /// 4.0 mm
    fn pitch_at<'py>(&self, py: Python<'py>, length: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        length.each(py, "length", Length, |length| self.0.pitch_at(length))
    }

    /// Whether a length lies in the operating range, its ends included.
    ///
    /// Parameters
    /// ----------
    /// length : float, str or array_like of float
    ///     l [m].
    ///
    /// Returns
    /// -------
    /// bool or numpy.ndarray of bool, of the shape of the length
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> spring = coilsense.Spring.of_paper("S_T")
    /// >>> spring.in_operating_range("230 mm"), spring.in_operating_range([0.1, 0.2])
    /// (True, array([False,  True]))
    fn in_operating_range<'py>(&self, py: Python<'py>, length: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        length.each(py, "length", Length, |length| self.0.in_operating_range(length))
    }

    /// Force of a spring without mass, tension positive.
    ///
    /// Parameters
    /// ----------
    /// length : float, str or array_like of float
    ///     l [m].
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the length
    ///     k (l - l0) [N].
    ///
    /// Notes
    /// -----
    /// Source: Hooke's law; the paper's F_x.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Spring.of_paper("S_T").static_force([0.104, 0.264]).round(6)
    /// array([  0. , 121.6])
    fn static_force<'py>(&self, py: Python<'py>, length: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        length.each(py, "length", Length, |length| self.0.static_force(length))
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        crate::html::shown(slf.as_any(), "spring")
    }
}
