//! From wire and coil to a spring: its stiffness, its mass, its stress, its solid length, and what tolerances do to them.
//!
//! Next door: the spring as Table I of the paper gives it, stiffness and mass measured (`spring`); how it could swing sideways or
//! twist (`neighbours`).

mod end_type;
mod material;
mod stiffness;
mod stress;
mod surge;
mod tolerance;
mod wire;

pub use end_type::EndType;
pub use material::{Material, MaterialParameters};
pub use tolerance::Sensitivities;

use crate::error::{Error, above_zero, check, not_negative};
use crate::spring::Spring;

/// What describes wire and coil, by name and in SI units; [`Geometry::new`] checks it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GeometryParameters {
    /// d: diameter of the wire \[m\].
    pub wire_diameter: f64,
    /// D: mean diameter of the coil, to the centre of the wire \[m\].
    pub coil_diameter: f64,
    /// n: active windings \[1\], may be fractional.
    pub active_windings: f64,
    /// n_t: all windings \[1\]; `None` adds to the active ones what the ends take, see [`EndType::inactive_windings`].
    pub total_windings: Option<f64>,
    /// How the wire ends.
    pub end_type: EndType,
    /// What the wire is made of.
    pub material: Material,
    /// l0: length without force \[m\]; of an extension spring, closed, measured where the force is applied.
    pub rest_length: f64,
    /// F_0: force at which an extension spring begins to open \[N\]; zero for compression.
    pub initial_tension: f64,
}

/// Wire and coil, every value checked.
///
/// ```
/// use coilsense::geometry::{EndType, Geometry, GeometryParameters, Material, MaterialParameters};
///
/// // S_T of the paper, from its dimensions and steel.
/// let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0))?;
/// let s_t = Geometry::new(GeometryParameters {
///     wire_diameter: 0.002,
///     coil_diameter: 0.016,
///     active_windings: 52.0,
///     total_windings: None,
///     end_type: EndType::Hooks,
///     material: steel,
///     rest_length: 0.104,
///     initial_tension: 0.0,
/// })?;
/// assert!((s_t.stiffness() - 765.3).abs() < 0.1); // Table I: 760 N/m
/// assert!((s_t.active_mass() - 0.0645).abs() < 1e-4); // Table I: 65 g
/// assert!((s_t.active_mass_at(0.104) / s_t.active_mass() - 1.0008).abs() < 1e-4); // wire as a helix
/// assert!((s_t.wire_length_at(0.104) - 2.6159).abs() < 1e-4);
/// assert!((s_t.solid_length() - 0.104).abs() < 1e-12);
/// assert_eq!((s_t.index(), s_t.total_mass()), (8.0, s_t.active_mass()));
///
/// // Close-wound, it begins to open at 10 N, say: as if it were 13 mm shorter.
/// let wound = Geometry::new(GeometryParameters { initial_tension: 10.0, ..*s_t.parameters() })?;
/// assert!((wound.effective_rest_length() - 0.0909).abs() < 1e-4);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Geometry {
    parameters: GeometryParameters,
    total_windings: f64,
    effective_rest_length: f64,
}

impl Geometry {
    /// Checks the parameters.
    ///
    /// # Errors
    /// [`Error::Value`] for the first value that is not finite or not above zero; a wire that is not thinner than the coil; fewer
    /// windings in total than active; a spring shorter than its solid length (one with hooks by more than 1 % and a quarter of a wire); a
    /// compression spring with initial tension; an initial tension so high that the effective rest length is not above zero.
    pub fn new(parameters: GeometryParameters) -> Result<Self, Error> {
        let p = &parameters;
        above_zero("wire_diameter", p.wire_diameter, "m")?;
        above_zero("coil_diameter", p.coil_diameter, "m")?;
        let thinner = format!("below the coil diameter of {} m", p.coil_diameter);
        check(p.wire_diameter < p.coil_diameter, "wire_diameter", p.wire_diameter, "m", thinner)?;
        let active = above_zero("active_windings", p.active_windings, "")?;
        let total = p.total_windings.unwrap_or(active + p.end_type.inactive_windings());
        above_zero("total_windings", total, "")?;
        check(total >= active, "total_windings", total, "", format!("at least the {active} active ones"))?;
        above_zero("rest_length", p.rest_length, "m")?;
        not_negative("initial_tension", p.initial_tension, "N")?;
        let mut geometry = Self { parameters, total_windings: total, effective_rest_length: p.rest_length };
        geometry.check_ends()?;
        geometry.effective_rest_length = stiffness::effective_rest_length(&geometry)?;
        Ok(geometry)
    }

    /// The wire and coil of a spring whose stiffness and mass are known from elsewhere, for what depends on dimensions and material.
    ///
    /// All windings count as active and as all there are; no initial tension. Stiffness and mass of the result are the formulas', not
    /// the spring's.
    ///
    /// # Errors
    /// [`Error::Value`] as [`Geometry::new`].
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// use coilsense::geometry::{EndType, Geometry, Material, MaterialParameters};
    ///
    /// let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0))?;
    /// let geometry = Geometry::of_spring(&spring, EndType::Hooks, steel)?;
    /// assert!((geometry.shear_stress(spring.nominal_force()) - 619e6).abs() < 1e6);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn of_spring(spring: &Spring, end_type: EndType, material: Material) -> Result<Self, Error> {
        Self::new(GeometryParameters {
            wire_diameter: spring.wire_diameter(),
            coil_diameter: 2.0 * spring.coil_radius(),
            active_windings: spring.windings(),
            total_windings: Some(spring.windings()),
            end_type,
            material,
            rest_length: spring.rest_length(),
            initial_tension: 0.0,
        })
    }

    /// What only some ends allow.
    fn check_ends(&self) -> Result<(), Error> {
        let p = &self.parameters;
        let solid = p.end_type.solid_length(self.total_windings, p.wire_diameter);
        // Rounding of the product must not refuse a spring that is given as wound solid; and of a close-wound body the windings are seldom
        // counted to better than a quarter, nor is the wire measured to better than 1 %.
        let slack = if p.end_type.is_extension() { 0.25 * p.wire_diameter + 0.01 * solid } else { 1e-12 * solid };
        let fits = p.rest_length >= solid - slack;
        let shown = (1e9 * solid).round() / 1e9;
        check(fits, "rest_length", p.rest_length, "m", format!("at least the solid length of {shown} m"))?;
        if p.end_type.is_extension() {
            return Ok(());
        }
        let none = p.initial_tension == 0.0;
        check(none, "initial_tension", p.initial_tension, "N", "zero for a compression spring").map(|_| ())
    }

    /// The parameters it was made from.
    pub fn parameters(&self) -> &GeometryParameters {
        &self.parameters
    }

    /// What the wire is made of.
    pub fn material(&self) -> &Material {
        &self.parameters.material
    }

    /// n_t: all windings \[1\].
    pub fn total_windings(&self) -> f64 {
        self.total_windings
    }

    /// C: spring index \[1\], how much wider the coil is than the wire.
    ///
    /// C = D / d
    ///
    /// Source:   definition, `[Shigley2011]` chapter 10; the w of `[EN13906-1]`.
    /// Valid:    always; springs are wound from about 4 to 20.
    /// Accuracy: 1e-16 relative.
    pub fn index(&self) -> f64 {
        self.parameters.coil_diameter / self.parameters.wire_diameter
    }

    /// Length with all windings touching \[m\], inactive ones included.
    ///
    /// With initial tension, the rest length: windings pull on each other only where they touch, however the ends are counted. Else
    /// [`EndType::solid_length`].
    pub fn solid_length(&self) -> f64 {
        let p = &self.parameters;
        match p.initial_tension > 0.0 {
            true => p.rest_length,
            false => p.end_type.solid_length(self.total_windings, p.wire_diameter),
        }
    }

    /// Length at which the straight line of force over length crosses zero \[m\].
    ///
    /// l0' = l0 − F_0/k
    ///
    /// Above its closed length an extension spring pulls F_0 + k (l − l0) = k (l − l0'): with l0' every formula of a spring without
    /// initial tension holds.
    ///
    /// Source:   Hooke's law, shifted.
    /// Valid:    an open spring, l above l0; below, the windings rest on each other.
    /// Accuracy: rounding of the difference.
    pub fn effective_rest_length(&self) -> f64 {
        self.effective_rest_length
    }
}
