//! The wire of a spring whose stiffness and mass are known: which of its constants are brought to them.
//!
//! Next door: the wire by its own constants (`rod`).

use super::rod::{Hand, Rod, RodParameters};
use super::state::{Helix, Turning};
use crate::error::Error;
use crate::geometry::Geometry;
use crate::spring::Spring;

/// What a spring's stiffness k and mass m say about its wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum StiffnessAt {
    /// k is the slope of the force at the middle of the range of use, ends held against turning, and m the mass of the helix's wire: as
    /// a measurement of the spring in use gives them.
    #[default]
    Range,
    /// k and m are those of the flat coil, G d⁴/(64 R³ N) and ρ (π d²/4) 2π R N, as a catalogue's formulas give them. The coil rolled flat
    /// has this k, its shear included: a formula without shear is nearer to a curved wire than a rod with shear is.
    Flat,
}

impl Rod {
    /// The wire of a spring, with E and G scaled alike to its stiffness, and the density to its mass.
    ///
    /// Dimensions, stiffness, mass and rest length are the spring's; ends and the ratio of the moduli the geometry's. The wire starts where
    /// the active windings do, see [`Geometry::active_span`].
    ///
    /// Source:   F is proportional to E and G together at every length, so that one factor brings its slope to k.
    /// Valid:    springs whose k and m are of the active windings.
    /// Accuracy: the slope at mid range is k to 1e-12, that of the flat coil but for rounding (`tests/helix`). A curved wire is stiffer than the formula of
    ///           the flat coil by 3/16 (d/2R)², 0.3 % for D = 8 d (Ancker and Goodier, quoted from memory).
    ///
    /// # Errors
    /// [`Error::Value`] where the active windings have no span at rest or at mid range, and as [`Rod::new`] and [`Helix::new`].
    ///
    /// ```
    /// use coilsense::geometry::{EndType, Geometry, Material, MaterialParameters};
    /// use coilsense::helix::{Hand, Helix, Rod, StiffnessAt, Turning};
    ///
    /// let spring = coilsense::paper::s_t();
    /// let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0))?;
    /// let geometry = Geometry::of_spring(&spring, EndType::Hooks, steel)?;
    /// let rod = Rod::of_spring(&spring, &geometry, StiffnessAt::Range, Hand::Right)?;
    /// let helix = Helix::new(&rod, spring.mid_length(), Turning::Held)?;
    /// assert!((helix.stiffness() - 760.0).abs() < 1e-9);
    /// assert!((rod.mass() - 0.065).abs() < 1e-15);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn of_spring(
        spring: &Spring,
        geometry: &Geometry,
        stiffness_at: StiffnessAt,
        hand: Hand,
    ) -> Result<Self, Error> {
        spring.check_uniform("a helix")?;
        let material = geometry.material();
        let nominal = RodParameters {
            wire_diameter: spring.wire_diameter(),
            coil_radius: spring.coil_radius(),
            windings: spring.windings(),
            rest_span: geometry.active_span(spring.rest_length()),
            youngs_modulus: material.youngs_modulus(),
            shear_modulus: material.shear_modulus(),
            density: material.density(),
            hand,
        };
        let rod = Self::new(nominal)?;
        let (stiffness, mass) = match stiffness_at {
            StiffnessAt::Range => {
                let mid = Helix::new(&rod, geometry.active_span(spring.mid_length()), Turning::Held)?;
                (mid.stiffness(), rod.mass())
            }
            StiffnessAt::Flat => {
                (rod.flat_stiffness() / (1.0 + rod.flat_shear()), rod.mass() * rod.pitch_angle().cos())
            }
        };
        let factor = spring.stiffness() / stiffness;
        Self::new(RodParameters {
            youngs_modulus: factor * nominal.youngs_modulus,
            shear_modulus: factor * nominal.shear_modulus,
            density: spring.mass() / mass * nominal.density,
            ..nominal
        })
    }
}
