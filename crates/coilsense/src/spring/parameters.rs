//! What describes a spring, before it is checked.
//!
//! Next door: the checked spring (the parent).

use std::sync::Arc;

use crate::sections::Sections;

/// What describes a spring, by name and in SI units; [`super::Spring::new`] checks it.
#[derive(Debug, Clone, PartialEq)]
pub struct SpringParameters {
    /// l0: length without force \[m\]; catalogues call it the free length.
    pub rest_length: f64,
    /// N: active windings \[1\], may be fractional.
    pub windings: f64,
    /// r: radius of the coil, from its axis to the centre of the wire \[m\].
    pub coil_radius: f64,
    /// ρ: radius of the wire \[m\].
    pub wire_radius: f64,
    /// m: mass of the active coil \[kg\].
    pub mass: f64,
    /// k: stiffness \[N/m\].
    pub stiffness: f64,
    /// Shortest length in use \[m\].
    pub min_length: f64,
    /// Longest length in use \[m\].
    pub max_length: f64,
    /// F_nom \[N\] where it is known otherwise; `None` takes eq. (14), see [`super::Spring::nominal_force`].
    pub nominal_force: Option<f64>,
    /// Windings that carry the current \[1\]; `None` takes `windings`. See [`crate::inductance::MaxwellSum`] for the rule of fractions.
    pub inductance_windings: Option<f64>,
    /// Of a coil that is not uniform, its sections: the static curve, the masses of the chain, and where windings close are then theirs, and
    /// `stiffness` and `mass` are those of the coil with all windings open, which they scale. `None` for a uniform coil.
    pub sections: Option<Arc<Sections>>,
}
