//! The unstressed wire: round, wound to a uniform helix.
//!
//! Next door: where its constants come from when a spring's stiffness and mass are known (`of_spring`), its stretched state (`state`).

use std::f64::consts::{PI, TAU};

use crate::error::{Error, above_zero, check};

/// The sense of a helix.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Hand {
    /// Turns as a common screw does: to the right when it goes away.
    #[default]
    Right,
    /// The mirror image: the same frequencies, couples about the axis negated.
    Left,
}

impl Hand {
    /// 1 for right, −1 for left.
    pub(super) fn sign(self) -> f64 {
        match self {
            Self::Right => 1.0,
            Self::Left => -1.0,
        }
    }
}

/// What describes the unstressed wire, by name and in SI units; [`Rod::new`] checks it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RodParameters {
    /// d: diameter of the wire \[m\].
    pub wire_diameter: f64,
    /// R_0: radius of the helix of the wire's centre, without load \[m\].
    pub coil_radius: f64,
    /// N: active windings \[1\], may be fractional.
    pub windings: f64,
    /// l_0: what the active windings span along the axis without load \[m\]; zero is a flat coil.
    pub rest_span: f64,
    /// E: Young's modulus \[Pa\].
    pub youngs_modulus: f64,
    /// G: shear modulus \[Pa\].
    pub shear_modulus: f64,
    /// Density \[kg/m³\].
    pub density: f64,
    /// The sense in which it is wound.
    pub hand: Hand,
}

/// The unstressed wire, every value checked: a rod of round section along a uniform helix.
///
/// ```
/// use coilsense::helix::{Hand, Rod, RodParameters};
///
/// // The spring on which helices are commonly compared: angle 8.5744°.
/// let rod = Rod::new(RodParameters {
///     wire_diameter: 0.001, coil_radius: 0.005, windings: 7.6, rest_span: 0.036,
///     youngs_modulus: 206e9, shear_modulus: 206e9 / 2.6, density: 7900.0, hand: Hand::Right,
/// })?;
/// assert!((rod.pitch_angle().to_degrees() - 8.574).abs() < 1e-3);
/// assert!((rod.wire_length() - 0.24145).abs() < 1e-5);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rod {
    parameters: RodParameters,
    thin: bool,
}

/// Most windings that are taken; each doubling of them costs one more join.
const MOST_WINDINGS: f64 = 1e4;

impl Rod {
    /// Checks the parameters.
    ///
    /// # Errors
    /// [`Error::Value`] for the first value that is not finite or not above zero (`rest_span` may be zero), a wire that is not thinner
    /// than the coil, and moduli that no isotropic solid has: E/2G − 1 must lie above −1 and not above 0.5.
    pub fn new(parameters: RodParameters) -> Result<Self, Error> {
        let p = &parameters;
        above_zero("wire_diameter", p.wire_diameter, "m")?;
        above_zero("coil_radius", p.coil_radius, "m")?;
        let thinner = format!("below the coil diameter of {} m", 2.0 * p.coil_radius);
        check(p.wire_diameter < 2.0 * p.coil_radius, "wire_diameter", p.wire_diameter, "m", thinner)?;
        above_zero("windings", p.windings, "")?;
        check(p.windings <= MOST_WINDINGS, "windings", p.windings, "", format!("at most {MOST_WINDINGS}"))?;
        let span = p.rest_span;
        check(span.is_finite() && (0.0..1e9).contains(&span), "rest_span", span, "m", "finite and not below zero")?;
        modulus("youngs_modulus", p.youngs_modulus)?;
        modulus("shear_modulus", p.shear_modulus)?;
        let most = 3.0 * p.shear_modulus;
        // A Poisson ratio of exactly one half is let through whatever way E was rounded.
        let isotropic = p.youngs_modulus <= most * (1.0 + 1e-12);
        check(isotropic, "youngs_modulus", p.youngs_modulus, "Pa", format!("at most three shear moduli, {most} Pa"))?;
        above_zero("density", p.density, "kg/m3")?;
        Ok(Self { parameters, thin: false })
    }

    /// The same wire without shear, without extension and without rotary inertia: the thin rod of the closed forms
    /// ([`super::inextensible`]) and of the oldest papers.
    #[must_use]
    pub fn thin(self) -> Self {
        Self { thin: true, ..self }
    }

    /// The parameters it was made from.
    pub fn parameters(&self) -> &RodParameters {
        &self.parameters
    }

    /// L: length of the wire without load \[m\].
    ///
    /// L = √((2π N R_0)² + l_0²)
    ///
    /// Source:   geometry.
    /// Valid:    a uniform helix.
    /// Accuracy: 4e-16 relative.
    pub fn wire_length(&self) -> f64 {
        let p = &self.parameters;
        (TAU * p.windings * p.coil_radius).hypot(p.rest_span)
    }

    /// α_0: angle of the wire to a plane across the axis, without load \[rad\].
    ///
    /// sin α_0 = l_0 / L
    ///
    /// Source:   geometry.
    /// Valid:    a uniform helix.
    /// Accuracy: 4e-16 relative.
    pub fn pitch_angle(&self) -> f64 {
        let p = &self.parameters;
        p.rest_span.atan2(TAU * p.windings * p.coil_radius)
    }

    /// m: mass of the wire \[kg\].
    ///
    /// m = ρ (π d²/4) L
    ///
    /// Source:   geometry; [`crate::geometry::Geometry::active_mass`] takes the flat coil's length, 2π N R_0.
    /// Valid:    bare wire.
    /// Accuracy: 6e-16 relative.
    pub fn mass(&self) -> f64 {
        self.parameters.density * self.area() * self.wire_length()
    }

    /// Stiffness of the flat coil of this wire \[N/m\].
    ///
    /// k = G d⁴ / (64 R_0³ N)
    ///
    /// Source:   `[EN13906-1]`: torsion of a flat coil; the same as [`crate::geometry::Geometry::stiffness`].
    /// Valid:    small helix angle, thin wire; the helix's own is [`super::Helix::stiffness`].
    /// Accuracy: 5e-16 relative.
    pub fn flat_stiffness(&self) -> f64 {
        let p = &self.parameters;
        p.shear_modulus * p.wire_diameter.powi(4) / (64.0 * p.coil_radius.powi(3) * p.windings)
    }

    /// What shear adds to the compliance of the flat coil, per its twist's: GJ/(κGA R_0²).
    ///
    /// Source:   a force F along the axis twists the flat coil's wire by the couple F R_0 and shears it by F.
    pub(super) fn flat_shear(&self) -> f64 {
        if self.is_thin() {
            return 0.0;
        }
        0.125 * (self.parameters.wire_diameter / self.parameters.coil_radius).powi(2) / self.shear_factor()
    }

    /// κ: the part of a round section that carries shear.
    ///
    /// Source:   `[Hutchinson2001]`.
    pub(super) fn shear_factor(&self) -> f64 {
        let ratio = self.parameters.youngs_modulus / (2.0 * self.parameters.shear_modulus);
        let poisson = ratio - 1.0;
        6.0 * ratio * ratio / (7.0 + 12.0 * poisson + 4.0 * poisson * poisson)
    }

    /// Whether shear, extension and rotary inertia are left out.
    pub(super) fn is_thin(&self) -> bool {
        self.thin
    }

    /// Area of the section \[m²\].
    pub(super) fn area(&self) -> f64 {
        0.25 * PI * self.parameters.wire_diameter.powi(2)
    }

    /// EI \[N m²\].
    pub(super) fn bending(&self) -> f64 {
        self.parameters.youngs_modulus * PI * self.parameters.wire_diameter.powi(4) / 64.0
    }
}

/// Lets through a modulus of a size that solids have.
fn modulus(quantity: &'static str, value: f64) -> Result<f64, Error> {
    check((1.0..=1e13).contains(&value), quantity, value, "Pa", "from 1e0 to 1e13 Pa")
}
