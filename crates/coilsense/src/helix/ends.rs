//! What holds the ends of the wire: freedoms at the points of the axis that the ends are tied to.
//!
//! Next door: the wire between them (`chain`).

use super::block::{Number, Square, eliminate};
use super::segment::cross;
use super::state::Helix;
use crate::error::{Error, check};

/// How one end is held, at the point of the spring's axis beside it: which of three displacements and three rotations are free.
///
/// The end of the wire is tied to that point by a rigid arm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Holding {
    /// Along three axes, then about them: two across the spring, the first at `direction`; the third is the spring's own.
    free: [bool; 6],
    /// Angle of the first axis about the spring's from the point where the wire begins at end 1 \[rad\].
    direction: f64,
}

impl Holding {
    /// Nothing moves: held at the angle of the stretched helix.
    pub fn clamped() -> Self {
        Self { free: [false; 6], direction: 0.0 }
    }

    /// Free to tilt both ways, held against turning about the spring's axis.
    pub fn pinned() -> Self {
        Self { free: [false, false, false, true, true, false], direction: 0.0 }
    }

    /// Free to turn about the spring's axis, held against tilting.
    pub fn swivel() -> Self {
        Self { free: [false, false, false, false, false, true], direction: 0.0 }
    }

    /// Free to tilt and to turn.
    pub fn ball() -> Self {
        Self { free: [false, false, false, true, true, true], direction: 0.0 }
    }

    /// Free to tilt about one line across the spring.
    ///
    /// - `direction`: angle of that line about the spring's axis \[rad\], from the point where the wire begins at end 1
    ///
    /// # Errors
    /// [`Error::Value`] for a direction that is not finite.
    pub fn hinged(direction: f64) -> Result<Self, Error> {
        check(direction.is_finite(), "direction", direction, "rad", "finite")?;
        Ok(Self { free: [false, false, false, true, false, false], direction })
    }

    /// Nothing holds it.
    pub fn free() -> Self {
        Self { free: [true; 6], direction: 0.0 }
    }

    /// The same, and free to move along the spring's axis.
    #[must_use]
    pub fn sliding(mut self) -> Self {
        self.free[2] = true;
        self
    }

    /// Whether one of its six freedoms is free.
    pub(super) fn is_free(&self, freedom: usize) -> bool {
        self.free[freedom]
    }

    /// Angle of the first axis across the spring \[rad\].
    pub(super) fn direction(&self) -> f64 {
        self.direction
    }

    /// Whether nothing moves.
    pub(super) fn is_clamped(&self) -> bool {
        !self.free.contains(&true)
    }

    /// Which freedoms are free, from the first of the end in a matrix on.
    pub(super) fn freedoms(&self, first: usize) -> impl Iterator<Item = usize> {
        let free = self.free;
        (0..6).filter(move |at| free[*at]).map(move |at| first + at)
    }
}

/// How both ends are held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ends {
    /// End 1, where the wire begins.
    pub end1: Holding,
    /// End 2.
    pub end2: Holding,
}

impl Ends {
    /// Each end in its own way.
    pub fn new(end1: Holding, end2: Holding) -> Self {
        Self { end1, end2 }
    }

    /// Both ends alike.
    pub fn both(holding: Holding) -> Self {
        Self::new(holding, holding)
    }

    /// Both ends clamped.
    pub fn clamped() -> Self {
        Self::both(Holding::clamped())
    }

    /// Both ends free to tilt.
    pub fn pinned() -> Self {
        Self::both(Holding::pinned())
    }

    /// One end clamped, the other free to turn about the spring's axis.
    pub fn swivel() -> Self {
        Self::new(Holding::clamped(), Holding::swivel())
    }
}

/// An end of the wire in the axes of what holds it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Arm {
    /// Motion of the wire's end, in the section's axes, per freedom of the point on the axis.
    pub motion: Square<f64, 6>,
    /// What the force in the wire adds to the stiffness against rotation, for the arm turns with it: (f rᵀ + r fᵀ)/2 − f·r.
    geometric: Square<f64, 3>,
}

impl Arm {
    /// - `sweep`: angle of the wire's end about the axis from its beginning \[rad\]
    /// - `pull`: the force on the end along the axis, in scaled units
    /// - `direction`: of the first of the axes that are used \[rad\]
    pub fn new(helix: &Helix, sweep: f64, pull: f64, direction: f64) -> Self {
        let state = &helix.scaled;
        let (s, c) = state.angle.sin_cos();
        let (sine, cosine) = (sweep - direction).sin_cos();
        // Section's axes in those of the holding: 1 along the wire, 2 to the axis, 3 across both.
        let (radial, around) = ([cosine, sine, 0.0], [-sine, cosine, 0.0]);
        let axes =
            [[c * around[0], c * around[1], s], [-radial[0], -radial[1], 0.0], [-s * around[0], -s * around[1], c]];
        let arm = radial.map(|x| state.radius * x);
        // θ × r = −r × θ
        let turned = cross(arm);
        let mut motion = [[0.0; 6]; 6];
        for i in 0..3 {
            for j in 0..3 {
                motion[i][j] = axes[i][j];
                motion[3 + i][3 + j] = axes[i][j];
                motion[i][3 + j] = -(0..3).map(|k| axes[i][k] * turned[k][j]).sum::<f64>();
            }
        }
        let force = [0.0, 0.0, pull];
        let geometric = std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (force[i] * arm[j] + arm[i] * force[j])));
        Self { motion, geometric }
    }

    /// Brings six freedoms of a stiffness, from `first` on, to the point on the axis.
    pub fn apply<T: Number>(&self, stiffness: &mut Square<T, 12>, first: usize) {
        let before = *stiffness;
        for row in 0..12 {
            for j in 0..6 {
                stiffness[row][first + j] =
                    (0..6).fold(T::zero(), |sum, k| sum + before[row][first + k] * T::real(self.motion[k][j]));
            }
        }
        let before = *stiffness;
        for column in 0..12 {
            for i in 0..6 {
                stiffness[first + i][column] =
                    (0..6).fold(T::zero(), |sum, k| sum + before[first + k][column] * T::real(self.motion[k][i]));
            }
        }
        for i in 0..3 {
            for j in 0..3 {
                let at = &mut stiffness[first + 3 + i][first + 3 + j];
                *at = *at + T::real(self.geometric[i][j]);
            }
        }
    }
}

/// Frees what a holding leaves free of the six freedoms from `first` on, and returns how many modes that adds below the frequency.
pub(super) fn release<T: Number>(stiffness: &mut Square<T, 12>, holding: &Holding, first: usize) -> usize {
    let mut list = [0; 6];
    let mut found = 0;
    for at in holding.freedoms(first) {
        list[found] = at;
        found += 1;
    }
    eliminate(stiffness, &list[..found])
}
