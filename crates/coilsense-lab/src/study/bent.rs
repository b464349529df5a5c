//! The static force of a coil over its length, which is no straight line, brought to what its spec says of the spring.
//!
//! Next door: the motion about one length (`helical`), the curve of a wire (`coilsense::helix::inextensible`).

use coilsense::Error;
use coilsense::helix::{Rod, StiffnessAt, Turning, inextensible};

use crate::spec::SpringSpec;

/// The static curve of a spring's coil whose ends are held against turning, or free to.
///
/// F(l) = a F_w(l − l_d) + b, with the force F_w of a wire that neither shears nor extends. Of a spring by values a and b make the curve touch the
/// straight line k (l − l0) in the middle of the range; of a flat coil's k, a makes its flat coil have it, and b = 0. The wire's own shear would make
/// a flat coil softer by 0.5 (d/D)², which in a curved wire is more than made up for: the formula k = G d⁴/(8 D³ n) is the better one, so the shear is
/// left out here, and the helix that moves is brought to the formula with its shear ([`Rod::of_spring`]).
///
/// Accuracy: 1 % of the bend against the helix with shear and extension, both brought to one slope (`tests/analysis/bent`). A curved wire is stiffer than
///           the formula by 3/16 (d/D)², 0.3 % for D = 8 d (Ancker and Goodier, quoted from memory); that is left out.
#[derive(Debug, Clone, Copy)]
pub struct Bent {
    rod: Rod,
    turning: Turning,
    /// What the spring is longer than its active windings span \[m\].
    dead_length: f64,
    factor: f64,
    /// \[N\]
    more: f64,
}

impl Bent {
    /// Of a spec's spring.
    ///
    /// # Errors
    /// Those of [`SpringSpec::rod`] and [`inextensible::force`]: no helix.
    pub fn of(spring: &SpringSpec, turning: Turning) -> Result<Self, Error> {
        let (rod, dead_length) = (spring.rod()?, -spring.geometry.active_span(0.0));
        // The wire's rest length is that at which its own force, initial tension included, is none.
        let own = Self { rod, turning, dead_length, factor: 1.0, more: 0.0 };
        if spring.stiffness_at == StiffnessAt::Flat {
            return Ok(Self { factor: spring.spring.stiffness() / rod.flat_stiffness(), ..own });
        }
        let middle = spring.spring.mid_length();
        let stiffness = inextensible::stiffness(&rod, middle - dead_length, Turning::Held)?;
        let scaled = Self { factor: spring.spring.stiffness() / stiffness, ..own };
        Ok(Self { more: spring.spring.static_force(middle) - scaled.force(middle)?, ..scaled })
    }

    /// The static force at a length of the spring \[m\], in newtons.
    ///
    /// # Errors
    /// As [`inextensible::force`].
    pub fn force(&self, length: f64) -> Result<f64, Error> {
        Ok(self.factor * inextensible::force(&self.rod, length - self.dead_length, self.turning)? + self.more)
    }
}
