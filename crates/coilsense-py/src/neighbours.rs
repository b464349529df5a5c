//! `coilsense.torsional_frequency`, `lateral_frequency` and `buckling_force`: the motions that the axial model leaves out.
//!
//! Next door: the coil that they are of (`geometry`), the surge itself (`modes`).

use coilsense::neighbours;
use coilsense_lab::quantity::Dimension::{Force, Length, Mass};
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::geometry::PyGeometry;
use crate::noun::Noun;
use crate::quantity::Quantity;

/// First frequency at which the windings turn about the spring's axis, both ends held.
///
/// Parameters
/// ----------
/// geometry : Geometry
///     The coil.
/// mass : float or str
///     m of the active windings [kg], measured or ``geometry.active_mass``.
///
/// Returns
/// -------
/// float
///     [Hz].
///
/// Raises
/// ------
/// Error
///     For a mass that is not above zero.
///
/// Notes
/// -----
/// f = sqrt(k_t / I) / 2, k_t = E d^4 / (64 D n), I = m D^2 / 4. An estimate: coupling with the axial motion and pitch move it by some per
/// cent. Source: [Shigley2011] chapter 10.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> wire = coilsense.Material(shear_modulus=81.5e9, youngs_modulus=206e9, density=7850)
/// >>> coil = coilsense.Geometry(wire_diameter=2e-3, coil_diameter=16e-3, active_windings=52, end_type="hooks", material=wire, rest_length=0.104)
/// >>> round(coilsense.torsional_frequency(coil, 0.065), 1)
/// 61.0
#[pyfunction]
pub fn torsional_frequency(geometry: Noun<'_, PyGeometry>, mass: Quantity) -> PyResult<f64> {
    let geometry = geometry.named("geometry")?;
    neighbours::torsional_frequency(&geometry.0, mass.si("mass", Mass)?).python()
}

/// First frequency at which a spring swings sideways, ends held in place but free to tilt.
///
/// Parameters
/// ----------
/// geometry : Geometry
///     The coil.
/// mass : float or str
///     m of the active windings [kg].
/// length : float or str
///     l [m].
/// force : float or str
///     F at that length [N], tension positive: compression lowers it.
///
/// Returns
/// -------
/// float
///     [Hz].
///
/// Raises
/// ------
/// Error
///     For a mass or a length that is not above zero, and for a force that is not between buckling and the shear stiffness.
///
/// Notes
/// -----
/// The coil as a column that bends and shears, under the axial force. An estimate: ends that may tilt, no coupling with the axial motion.
/// Source: [Haringx1948].
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> coil = coilsense.Geometry.of_spring(coilsense.Spring.of_paper("S_T"), "hooks", coilsense.Material.named("steel EN 10270-1"))
/// >>> round(coilsense.lateral_frequency(coil, "65 g", "230 mm", "95.8 N"), 1)
/// 40.5
#[pyfunction]
pub fn lateral_frequency(
    geometry: Noun<'_, PyGeometry>,
    mass: Quantity,
    length: Quantity,
    force: Quantity,
) -> PyResult<f64> {
    let geometry = geometry.named("geometry")?;
    let (mass, length) = (mass.si("mass", Mass)?, length.si("length", Length)?);
    neighbours::lateral_frequency(&geometry.0, mass, length, force.si("force", Force)?).python()
}

/// Force at which a spring buckles at a length, ends free to tilt.
///
/// Parameters
/// ----------
/// geometry : Geometry
///     The coil.
/// length : float or str
///     l under that force [m].
///
/// Returns
/// -------
/// float
///     [N]; above zero, the push that does it.
///
/// Raises
/// ------
/// Error
///     For a length that is not above zero.
///
/// Notes
/// -----
/// P (1 + P/S) = B pi^2 / l^2, with the bending and shear stiffness B and S of `lateral_frequency`, which is zero there. Source: [Haringx1948].
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> coil = coilsense.Geometry.of_spring(coilsense.Spring.of_paper("S_T"), "hooks", coilsense.Material.named("steel EN 10270-1"))
/// >>> round(coilsense.buckling_force(coil, "104 mm"), 1)
/// 5.1
#[pyfunction]
pub fn buckling_force(geometry: Noun<'_, PyGeometry>, length: Quantity) -> PyResult<f64> {
    let geometry = geometry.named("geometry")?;
    neighbours::buckling_force(&geometry.0, length.si("length", Length)?).python()
}
