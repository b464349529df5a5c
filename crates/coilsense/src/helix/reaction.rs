//! What a moving spring does to what holds one of its ends.
//!
//! Next door: by a mode (`mode`), by a motion of the ends (`response`).

use num_complex::Complex;

/// Force and couples on what holds an end, at the spring's axis.
///
/// Axes are fixed: x through the point where the wire begins at end 1, z the spring's own. Its size is that of what it is the reaction to;
/// the ratios say what a sensor of the axial force sees beside it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reaction {
    pub(super) force: [Complex<f64>; 3],
    pub(super) couple: [Complex<f64>; 3],
}

impl Reaction {
    /// Force along x, y, z \[N per unit\].
    pub fn force(&self) -> [Complex<f64>; 3] {
        self.force
    }

    /// Couple about x, y, z \[N m per unit\].
    pub fn couple(&self) -> [Complex<f64>; 3] {
        self.couple
    }

    /// Side force per newton of axial force \[N/N\].
    pub fn side_force(&self) -> f64 {
        across(&self.force) / self.force[2].norm()
    }

    /// Couple that tilts the holding, per newton of axial force \[m\].
    pub fn tilting_couple(&self) -> f64 {
        across(&self.couple) / self.force[2].norm()
    }

    /// Couple about the axis per newton of axial force \[m\]; where they are not in phase, the part that is.
    pub fn axis_couple(&self) -> f64 {
        (self.couple[2] / self.force[2]).re
    }

    /// From six numbers of an end in axes that are turned by `direction` about the spring's.
    pub(super) fn turned(values: [Complex<f64>; 6], direction: f64) -> Self {
        let (s, c) = direction.sin_cos();
        let turn = |[x, y, z]: [Complex<f64>; 3]| [x * c - y * s, x * s + y * c, z];
        let [x, y, z, about_x, about_y, about_z] = values;
        Self { force: turn([x, y, z]), couple: turn([about_x, about_y, about_z]) }
    }
}

/// Size of the part across the axis.
fn across([x, y, _]: &[Complex<f64>; 3]) -> f64 {
    (x.norm_sqr() + y.norm_sqr()).sqrt()
}
