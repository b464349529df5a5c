//! The motions that the axial model leaves out: how near their first frequencies lie to the surge.
//!
//! Both are estimates. Where one lies near a surge line, an excitation that is not purely axial will show up in the forces, and no part
//! of coilsense follows it. Next door: the surge itself (`modes`), every mode of the helix (`helix`).

mod column;

pub use column::Column;

use std::f64::consts::PI;

use crate::error::{Error, above_zero, check};
use crate::geometry::Geometry;

/// First frequency at which the windings turn about the spring's axis, both ends held \[Hz\].
///
/// f = ½ √(k_θ / I), k_θ = E d⁴ / (64 D n), I = m D²/4
///
/// - `mass`: m of the active windings \[kg\], measured or [`Geometry::active_mass`]
///
/// Source:   k_θ: bending of the wire over its length, `[Shigley2011]` chapter 10 (torsion springs); the coil as a uniform shaft, whose first
///           frequency is half of √(k_θ/I), as the surge's is of √(k/m).
/// Valid:    an estimate: small helix angle, no coupling with the axial motion (which shifts both where they lie near each other).
/// Accuracy: 1e-15 relative to the formula; coupling and pitch move it by some per cent. S_T: 61 Hz beside a surge at 54 Hz.
///
/// # Errors
/// [`Error::Value`] for a mass that is not above zero.
///
/// ```
/// # use coilsense::geometry::{EndType, Geometry, GeometryParameters, Material, MaterialParameters};
/// # let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0))?;
/// # let s_t = Geometry::new(GeometryParameters { wire_diameter: 0.002, coil_diameter: 0.016, active_windings: 52.0,
/// #     total_windings: None, end_type: EndType::Hooks, material: steel, rest_length: 0.104, initial_tension: 0.0 })?;
/// let hertz = coilsense::neighbours::torsional_frequency(&s_t, 0.065)?;
/// assert!((hertz - 61.0).abs() < 0.1);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn torsional_frequency(geometry: &Geometry, mass: f64) -> Result<f64, Error> {
    above_zero("mass", mass, "kg")?;
    let p = geometry.parameters();
    let stiffness =
        p.material.youngs_modulus() * p.wire_diameter.powi(4) / (64.0 * p.coil_diameter * p.active_windings);
    let inertia = mass * 0.25 * p.coil_diameter.powi(2);
    Ok(0.5 * (stiffness / inertia).sqrt())
}

/// First frequency at which a spring swings sideways, ends held in place but free to tilt \[Hz\].
///
/// f = (1/2l) √(T/μ), T = (F (S − F) + S B κ²) / (S − F + B κ²), κ = π/l, μ = m/l
///
/// The coil as a column with the bending stiffness B = 2 E I l / (π D n (1 + E/2G)) and the shear stiffness S = E I l / (π n (D/2)³) =
/// k l E/G, where I = π d⁴/64, under the axial force F. Without stiffness it is a string, T = F; without shear T = F + B κ². Sideways
/// force is taken across the tilted section (Haringx), V = S (y′ − ψ) + F ψ with M = B ψ′ and M′ = F y′ − V; y ∝ sin κx, ψ ∝ cos κx
/// give T.
///
/// - `mass`: m of the active windings \[kg\]; `length`: l \[m\]; `force`: F at that length \[N\], tension positive: compression lowers it
///
/// Source:   derived in the lines above; `[Haringx1948]` for the equivalent column, whose buckling P (1 + P/S) = B κ² is T = 0 here.
/// Valid:    an estimate: ends that may tilt (ends held at their angle raise it), no rotary inertia, no coupling with the axial
///           motion, windings that do not touch.
/// Accuracy: 1e-14 relative to the formula; between the limits of string and beam in `tests/geometry`. S_T at 230 mm: 40.5 Hz.
///
/// # Errors
/// [`Error::Value`] for a mass or a length that is not above zero, and for a force that is not between buckling and S.
///
/// ```
/// # use coilsense::geometry::{EndType, Geometry, GeometryParameters, Material, MaterialParameters};
/// # let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0))?;
/// # let s_t = Geometry::new(GeometryParameters { wire_diameter: 0.002, coil_diameter: 0.016, active_windings: 52.0,
/// #     total_windings: None, end_type: EndType::Hooks, material: steel, rest_length: 0.104, initial_tension: 0.0 })?;
/// let hertz = coilsense::neighbours::lateral_frequency(&s_t, 0.065, 0.230, 95.76)?;
/// assert!((hertz - 40.5).abs() < 0.1);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn lateral_frequency(geometry: &Geometry, mass: f64, length: f64, force: f64) -> Result<f64, Error> {
    above_zero("mass", mass, "kg")?;
    let (bending, shear) = column(geometry, above_zero("length", length, "m")?);
    let load = bending * (PI / length).powi(2);
    let lowest = -buckling(load, shear);
    let allowed = || format!("above {lowest} N, where the spring buckles, and below {shear} N");
    if !(force > lowest && force < shear) {
        check(false, "force", force, "N", allowed())?;
    }
    let tension = (force * (shear - force) + shear * load) / (shear - force + load);
    // Within rounding of buckling the sum may come out at or below zero.
    if tension <= 0.0 {
        check(false, "force", force, "N", allowed())?;
    }
    Ok(0.5 * (tension / (mass * length)).sqrt())
}

/// Force at which a spring buckles at a length, ends free to tilt \[N\]; above zero, the push that does it.
///
/// P (1 + P/S) = B π²/l², so P = (S/2) (√(1 + 4 B π²/(S l²)) − 1)
///
/// - `length`: l \[m\] under that force
///
/// Source:   `[Haringx1948]`; B and S as in [`lateral_frequency`].
/// Valid:    as [`lateral_frequency`]; a spring that reaches P at the length l has buckled before.
/// Accuracy: 1e-15 relative to the formula, and the zero of [`lateral_frequency`] to 1e-9.
///
/// # Errors
/// [`Error::Value`] for a length that is not above zero.
///
/// ```
/// # use coilsense::geometry::{EndType, Geometry, GeometryParameters, Material, MaterialParameters};
/// # let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0))?;
/// # let s_t = Geometry::new(GeometryParameters { wire_diameter: 0.002, coil_diameter: 0.016, active_windings: 52.0,
/// #     total_windings: None, end_type: EndType::Hooks, material: steel, rest_length: 0.104, initial_tension: 0.0 })?;
/// let push = coilsense::neighbours::buckling_force(&s_t, 0.230)?;
/// assert!((push - 2.33).abs() < 0.01);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn buckling_force(geometry: &Geometry, length: f64) -> Result<f64, Error> {
    let (bending, shear) = column(geometry, above_zero("length", length, "m")?);
    Ok(buckling(bending * (PI / length).powi(2), shear))
}

/// B \[N m²\] and S \[N\] of the column that stands for the coil at a length.
fn column(geometry: &Geometry, length: f64) -> (f64, f64) {
    let p = geometry.parameters();
    let (e, g) = (p.material.youngs_modulus(), p.material.shear_modulus());
    let section = e * PI * p.wire_diameter.powi(4) / 64.0;
    let bending = 2.0 * section * length / (geometry.wire_length() * (1.0 + 0.5 * e / g));
    let shear = section * length / (PI * p.active_windings * (0.5 * p.coil_diameter).powi(3));
    (bending, shear)
}

/// The positive root P of P (1 + P/S) = load, without cancellation.
fn buckling(load: f64, shear: f64) -> f64 {
    2.0 * load / (1.0 + (1.0 + 4.0 * load / shear).sqrt())
}
