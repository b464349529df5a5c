//! Force and stiffness of a helix whose wire neither extends nor shears, in closed form.
//!
//! Next door: the same with shear and extension, solved (`state`).

use super::rod::Rod;
use super::state::Turning;
use crate::error::{Error, check, finite};

/// Force of the helix at a span \[N\], tension positive.
///
/// F = p [GJ (p sin α − p_0 sin α_0) − EI tan α (p cos α − p_0 cos α_0)], sin α = l/L, p_0 = 2π N/L
///
/// with p = p_0 for ends that are held, and p = p_0 (GJ sin α_0 sin α + EI cos α_0 cos α)/(GJ sin²α + EI cos²α) for an end free to turn.
///
/// - `span`: l \[m\] of the active windings
///
/// Source:   derived: the energy of torsion and bending per length, stationary in the radius (and in p), by l/L.
/// Valid:    a thin wire; windings that do not touch. Shear and extension lower the slope by about 0.55 (d/2R)²: 0.9 % for index 8.
/// Accuracy: the slope is [`stiffness`] to 1e-8 by differences; [`super::Helix::force`] of a thin wire to 1e-9 (`tests/helix`).
///
/// # Errors
/// [`Error::Value`] for a span that is not from zero to below the length of the wire.
///
/// ```
/// use coilsense::helix::{Hand, Rod, RodParameters, Turning, inextensible};
///
/// // S_T of the paper: 760 N/m times 126 mm would be 95.8 N.
/// let rod = Rod::new(RodParameters {
///     wire_diameter: 0.002, coil_radius: 0.008, windings: 52.0, rest_span: 0.104,
///     youngs_modulus: 204.6e9, shear_modulus: 80.94e9, density: 7850.0, hand: Hand::Right,
/// })?;
/// let force = inextensible::force(&rod, 0.230, Turning::Held)?;
/// assert!((force - 96.23).abs() < 0.02);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn force(rod: &Rod, span: f64, turning: Turning) -> Result<f64, Error> {
    let shape = Shape::new(rod, span)?;
    Ok(match turning {
        Turning::Held => {
            let Shape { s, c, s0, c0, gj, ei, turn, .. } = shape;
            turn * turn * (gj * (s - s0) - ei * s / c * (c - c0))
        }
        Turning::Free => shape.free().0,
    })
}

/// Stiffness of the helix at a span, dF/dl \[N/m\].
///
/// k = k_flat cos³α_0 [1 + (E/2G) (tan²α + (cos α_0 − cos α)/cos³α)] with ends that are held, k_flat = G d⁴/(64 R_0³ N); with an end
/// free to turn the slope of [`force`] along its own p.
///
/// - `span`: l \[m\] of the active windings
///
/// Source:   derivative of [`force`] by l.
/// Valid:    as [`force`]; a stretched spring grows stiffer (S_T at 230 mm 1.1 %), a compressed one with its ends held softer.
/// Accuracy: 1e-9 against [`super::Helix::stiffness`] of a thin wire (`tests/helix`).
/// Differs:  the textbook's correction for the pitch leaves the change of the radius and the load out, and has the other sign for a
///           spring that is stretched: S_T at 230 mm 0.18 % softer than flat.
///
/// # Errors
/// As [`force`].
///
/// ```
/// # use coilsense::helix::{Hand, Rod, RodParameters, Turning, inextensible};
/// # let rod = Rod::new(RodParameters { wire_diameter: 0.002, coil_radius: 0.008, windings: 52.0, rest_span: 0.104,
/// #     youngs_modulus: 206e9, shear_modulus: 81.5e9, density: 7850.0, hand: Hand::Right })?;
/// let k = inextensible::stiffness(&rod, 0.230, Turning::Held)?;
/// assert!((k / rod.flat_stiffness() - 1.0114).abs() < 1e-4);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn stiffness(rod: &Rod, span: f64, turning: Turning) -> Result<f64, Error> {
    let shape = Shape::new(rod, span)?;
    Ok(match turning {
        Turning::Held => {
            let Shape { s, c, c0, gj, ei, .. } = shape;
            let bracket = 1.0 + ei / gj * ((s / c).powi(2) + (c0 - c) / c.powi(3));
            rod.flat_stiffness() * c0.powi(3) * bracket
        }
        Turning::Free => shape.free().1,
    })
}

/// The angle and the constants that both formulas share.
struct Shape {
    s: f64,
    c: f64,
    s0: f64,
    c0: f64,
    gj: f64,
    ei: f64,
    turn: f64,
    wire: f64,
}

impl Shape {
    fn new(rod: &Rod, span: f64) -> Result<Self, Error> {
        finite("span", span, "m")?;
        let wire = rod.wire_length();
        let (p, s) = (rod.parameters(), span / wire);
        if !(0.0..1.0).contains(&s) {
            check(false, "span", span, "m", format!("from zero to below the wire's length of {wire} m"))?;
        }
        let (s0, c0) = rod.pitch_angle().sin_cos();
        let ei = rod.bending();
        let gj = 2.0 * p.shear_modulus / p.youngs_modulus * ei;
        let turn = std::f64::consts::TAU * p.windings / wire;
        Ok(Self { s, c: (1.0 - s * s).sqrt(), s0, c0, gj, ei, turn, wire })
    }

    /// Force and stiffness with an end free to turn: with a = GJ sin²α + EI cos²α and b = p_0 (GJ sin α_0 sin α + EI cos α_0 cos α) the
    /// energy per length is −b²/2a and a constant.
    fn free(&self) -> (f64, f64) {
        let Self { s, c, s0, c0, gj, ei, turn, wire } = *self;
        let (a, b) = (gj * s * s + ei * c * c, turn * (gj * s0 * s + ei * c0 * c));
        let (a1, b1) = (2.0 * (gj - ei) * s * c, turn * (gj * s0 * c - ei * c0 * s));
        let (a2, b2) = (2.0 * (gj - ei) * (c * c - s * s), -b);
        let p = b / a;
        let slope = -p * b1 + 0.5 * p * p * a1;
        let p1 = (b1 - p * a1) / a;
        let curvature = -p1 * b1 - p * b2 + p * p1 * a1 + 0.5 * p * p * a2;
        (slope / c, (curvature + slope * s / c) / (c * c * wire))
    }
}
