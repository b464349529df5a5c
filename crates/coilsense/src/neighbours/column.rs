//! A coil as a column that bends, shears and turns its sections, under an axial force: its first sideways frequency in a microsecond.
//!
//! Next door: the same with ends free to tilt and without rotary inertia (the parent), the helix itself (`crate::helix`).

use std::f64::consts::{FRAC_PI_2, PI};

use crate::error::{Error, above_zero, finite};
use crate::helix::Rod;

/// The column that stands for a coil at a length.
///
/// B = 2 E I l/(L (1 + E/2G)), S = E I l/(π N R³), ι = m R²/2l per length; V = S (y′ − ψ) + F ψ, M = B ψ′,
/// V′ = −μω² y, M′ = F y′ − V − ιω² ψ
///
/// Source:   `[Haringx1948]` for the column and its shear; the sections' inertia that of rings about a diameter.
/// Valid:    a formula: exact only for many windings, and for a pair of modes that the fraction of a turn splits.
/// Accuracy: of the lower mode of the pair, against the helix: 0.03 % (S_T), 0.1 % (40 windings of 1.5 mm), 0.3 % (S_A), 4 % (valve and car
///           springs of 6 windings) (`tests/helix`).
///
/// ```
/// use coilsense::geometry::{EndType, Geometry, Material, MaterialParameters};
/// use coilsense::helix::{Hand, Rod, StiffnessAt};
/// use coilsense::neighbours::Column;
///
/// let spring = coilsense::paper::s_t();
/// let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0))?;
/// let geometry = Geometry::of_spring(&spring, EndType::Hooks, steel)?;
/// let rod = Rod::of_spring(&spring, &geometry, StiffnessAt::Flat, Hand::Right)?;
/// let column = Column::new(&rod, 0.230, spring.static_force(0.230))?;
/// assert!((column.clamped().unwrap() - 44.23).abs() < 0.01 && (column.pinned().unwrap() - 40.37).abs() < 0.01);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Column {
    length: f64,
    force: f64,
    bending: f64,
    shear: f64,
    /// Per length: mass, and inertia of the sections about a diameter.
    mass: f64,
    inertia: f64,
    torsional: f64,
}

/// Halvings of the range of wave numbers that hold the first mode of clamped ends.
const HALVINGS: usize = 60;

impl Column {
    /// Of a wire that spans a length under a force.
    ///
    /// - `span`: l \[m\] of the active windings; `force`: F at that length \[N\], tension positive
    ///
    /// # Errors
    /// [`Error::Value`] for a span that is not above zero and a force that is not finite.
    pub fn new(rod: &Rod, span: f64, force: f64) -> Result<Self, Error> {
        above_zero("span", span, "m")?;
        finite("force", force, "N")?;
        let p = rod.parameters();
        let wire = 2.0 * PI * p.windings * p.coil_radius;
        let section = p.youngs_modulus * PI * p.wire_diameter.powi(4) / 64.0;
        let mass = rod.mass();
        // k_θ = E I/L and I_θ = m R² of the whole coil.
        let torsional = 0.5 * (section / (wire * mass * p.coil_radius.powi(2))).sqrt();
        Ok(Self {
            length: span,
            force,
            bending: 2.0 * section * span / (wire * (1.0 + 0.5 * p.youngs_modulus / p.shear_modulus)),
            shear: section * span / (PI * p.windings * p.coil_radius.powi(3)),
            mass: mass / span,
            inertia: 0.5 * mass * p.coil_radius.powi(2) / span,
            torsional,
        })
    }

    /// First frequency at which it swings sideways with both ends free to tilt \[Hz\]; `None` where it has buckled.
    pub fn pinned(&self) -> Option<f64> {
        self.square_at(PI / self.length).map(|square| square.sqrt() / (2.0 * PI))
    }

    /// The same with both ends held at their angle.
    pub fn clamped(&self) -> Option<f64> {
        // y = cos αx + A cosh βx about the middle: αl/2 lies between that of pinned ends and a half turn.
        let half = 0.5 * self.length;
        let (mut low, mut high) = (FRAC_PI_2 / half, PI / half);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            match self.tilt_of_ends(middle) {
                Some(tilt) if tilt < 0.0 => high = middle,
                // Without a frequency the wave is too long for the force.
                _ => low = middle,
            }
        }
        self.square_at(high).map(|square| square.sqrt() / (2.0 * PI))
    }

    /// First frequency at which the coil turns about its axis, both ends held \[Hz\].
    ///
    /// f = ½ √(k_θ/I), k_θ = E I/L, I = m R²
    ///
    /// Source:   as [`super::torsional_frequency`], with the wire's own E.
    /// Valid:    small helix angle.
    /// Accuracy: S_T 0.1 %, valve spring 1 % of the helix's.
    pub fn torsional(&self) -> f64 {
        self.torsional
    }

    /// ω² of a wave y = cos αx; `None` where it does not swing.
    fn square_at(&self, alpha: f64) -> Option<f64> {
        let (squared, slack) = (alpha * alpha, self.shear - self.force);
        let constant = self.shear * self.bending * squared * squared + squared * slack * self.force;
        let linear = squared * (self.shear * self.inertia + self.mass * self.bending) + self.mass * slack;
        let quadratic = self.mass * self.inertia;
        let root = (linear * linear - 4.0 * quadratic * constant).sqrt();
        let square = 2.0 * constant / (linear + root);
        (slack > 0.0 && square > 0.0).then_some(square)
    }

    /// How far the ends of that wave tilt where its ends do not move, in a scale of its own; falls through zero at the first mode.
    fn tilt_of_ends(&self, alpha: f64) -> Option<f64> {
        let square = self.square_at(alpha)?;
        let slack = self.shear - self.force;
        let beta_squared =
            self.mass * square * (slack - self.inertia * square) / (self.shear * self.bending * alpha * alpha);
        let beta = beta_squared.sqrt();
        let half = 0.5 * self.length;
        let wave = (self.mass * square - self.shear * alpha * alpha) / (slack * alpha);
        let bend = (self.shear * beta_squared + self.mass * square) / (slack * beta);
        let tilt = wave * (alpha * half).tan() - bend * (beta * half).tanh();
        tilt.is_finite().then_some(tilt)
    }
}
