//! The stretched helix moved at its ends at one frequency: what both ends feel.
//!
//! Next door: the same at a mode (`mode`), the axial chain's response (`crate::two_port`).

use std::borrow::Cow;
use std::f64::consts::TAU;

use num_complex::Complex;

use super::block::{Square, eliminate};
use super::chain::Chain;
use super::ends::Ends;
use super::modes::{PER_WINDING, beyond};
use super::reaction::Reaction;
use super::state::Helix;
use crate::error::{Error, check};
use crate::excitation::End;

/// The response of a helix to small motions of its ends at a frequency.
///
/// K_η(ω) = (1 + iη) K(ω²/(1 + iη))
///
/// with K the dynamic stiffness without damping: every force about the stretched state lags by the same loss η, so that every mode of
/// every kind has the damping ratio ζ = η/2 and keeps its shape.
///
/// Source:   structural damping in its common form; K as [`super::Modes`].
/// Valid:    sines of small amplitude. A loss that follows frequency, or one per family of modes, is the modal model's.
/// Accuracy: at zero frequency it leads from one state to the next, force and couple to 1e-6; symmetric to 1e-9; its residues are the
///           modes' strengths to 1e-4 (`tests/helix`).
///
/// ```
/// use coilsense::End;
/// use coilsense::helix::{Ends, Hand, Helix, Response, Rod, RodParameters, Turning};
///
/// let rod = Rod::new(RodParameters {
///     wire_diameter: 0.001, coil_radius: 0.005, windings: 7.6, rest_span: 0.036,
///     youngs_modulus: 206e9, shear_modulus: 206e9 / 2.6, density: 7900.0, hand: Hand::Right,
/// })?;
/// let response = Response::new(&Helix::new(&rod, 0.036, Turning::Held)?, Ends::clamped(), 0.004)?;
/// // Pulled slowly, the held end is pushed aside by 1.2 % of the axial force.
/// let reaction = response.reaction(0.0, End::One, End::Two)?;
/// assert!((reaction.side_force() - 0.012).abs() < 1e-3);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Response {
    helix: Helix,
    chain: Chain,
    loss: f64,
}

impl Response {
    /// A helix between its ends, with a loss.
    ///
    /// - `loss`: η \[1\], twice the damping ratio of every mode; zero is none
    ///
    /// # Errors
    /// [`Error::Value`] for a loss that is not from 0 to 1, and for a helix that cannot be divided into pieces.
    pub fn new(helix: &Helix, ends: Ends, loss: f64) -> Result<Self, Error> {
        check((0.0..=1.0).contains(&loss), "loss", loss, "", "from 0 to 1")?;
        match Chain::new(helix, &ends, PER_WINDING, 0.0) {
            Some(chain) => Ok(Self { helix: *helix, chain, loss }),
            None => Err(beyond("windings", helix.rod().parameters().windings, "")),
        }
    }

    /// The dynamic stiffness between the points of the axis at both ends, whatever the ends leave free \[N/m, N, N m\].
    ///
    /// Rows are the forces along x, y, z and the couples about them that act on end 1, then on end 2; columns the displacements \[m\] and
    /// the rotations \[rad\] of end 1, then of end 2. Axes are fixed: x through the point where the wire begins, z the spring's.
    /// Symmetric: rotations are vectors of rotation, and the arms from the axis to the wire turn with the ends.
    ///
    /// - `frequency`: \[Hz\]
    ///
    /// # Errors
    /// [`Error::Value`] for a frequency that is not finite, is below zero, or is so high that no piece is short enough for it.
    pub fn stiffness(&self, frequency: f64) -> Result<[[Complex<f64>; 12]; 12], Error> {
        let mut stiffness = self.in_holdings(frequency)?;
        for (first, holding) in [(0, &self.chain.ends.end1), (6, &self.chain.ends.end2)] {
            let (s, c) = holding.direction().sin_cos();
            for at in [first, first + 3] {
                rotate(&mut stiffness, at, s, c);
            }
        }
        Ok(stiffness)
    }

    /// What one end feels when one moves along the axis, per metre; what the ends leave free follows.
    ///
    /// - `frequency`: \[Hz\]; `moved`: the end that moves, held in all else that its holding holds; `at`: the end whose holding feels it
    ///
    /// # Errors
    /// As [`Self::stiffness`].
    pub fn reaction(&self, frequency: f64, moved: End, at: End) -> Result<Reaction, Error> {
        Ok(self.followed(self.in_holdings(frequency)?, moved, at))
    }

    /// The same at any ω², with an imaginary part or not \[rad²/s²\], as six numbers; the loss is left out.
    ///
    /// # Errors
    /// As [`Self::stiffness`].
    pub(super) fn reaction_at(&self, square: Complex<f64>, moved: End, at: End) -> Result<[Complex<f64>; 6], Error> {
        let lambda = square * self.helix.eigenvalue_unit();
        let chain = self.fine_enough(lambda.norm()).ok_or_else(|| {
            let hertz = square.norm().sqrt() / TAU;
            beyond("frequency", hertz, "Hz")
        })?;
        let stiffness = self.in_si_units(&chain.between_ends(lambda), Complex::ONE);
        let Reaction { force: [x, y, z], couple: [about_x, about_y, about_z] } = self.followed(stiffness, moved, at);
        Ok([x, y, z, about_x, about_y, about_z])
    }

    /// The reaction at one end to a motion of one along the axis, with all else that is free following.
    fn followed(&self, mut stiffness: Square<Complex<f64>, 12>, moved: End, at: End) -> Reaction {
        let Ends { end1, end2 } = self.chain.ends;
        let drive = first_of(moved) + 2;
        let free: Vec<usize> = end1.freedoms(0).chain(end2.freedoms(6)).filter(|freedom| *freedom != drive).collect();
        eliminate(&mut stiffness, &free);
        let (first, holding) = match at {
            End::One => (0, end1),
            End::Two => (6, end2),
        };
        let values = std::array::from_fn(|i| {
            let released = free.contains(&(first + i));
            if released { Complex::ZERO } else { -stiffness[first + i][drive] }
        });
        Reaction::turned(values, holding.direction())
    }

    /// The stiffness in SI units, in the axes of each holding.
    fn in_holdings(&self, frequency: f64) -> Result<Square<Complex<f64>, 12>, Error> {
        check(frequency.is_finite() && frequency >= 0.0, "frequency", frequency, "Hz", "finite and not below zero")?;
        let lambda = (TAU * frequency).powi(2) * self.helix.eigenvalue_unit();
        let lag = Complex::new(1.0, self.loss);
        let chain = self.fine_enough(lambda).ok_or_else(|| beyond("frequency", frequency, "Hz"))?;
        Ok(self.in_si_units(&chain.between_ends(Complex::from(lambda) / lag), lag))
    }

    /// The wire in pieces that are short enough for λ.
    fn fine_enough(&self, lambda: f64) -> Option<Cow<'_, Chain>> {
        if lambda <= self.chain.segment.most() {
            return Some(Cow::Borrowed(&self.chain));
        }
        Chain::new(&self.helix, &self.chain.ends, PER_WINDING, lambda).map(Cow::Owned)
    }

    /// Scaled stiffness times `factor`, in SI units.
    fn in_si_units(&self, scaled: &Square<Complex<f64>, 12>, factor: Complex<f64>) -> Square<Complex<f64>, 12> {
        let state = &self.helix.scaled;
        let unit = |freedom: usize| if freedom % 6 < 3 { 1.0 } else { state.unit };
        let whole = factor * (state.bending / state.unit.powi(3));
        std::array::from_fn(|i| std::array::from_fn(|j| scaled[i][j] * whole * unit(i) * unit(j)))
    }
}

/// Where the freedoms of an end begin.
fn first_of(end: End) -> usize {
    match end {
        End::One => 0,
        End::Two => 6,
    }
}

/// Turns two freedoms from `at` on, along axes that are turned about the spring's, back to x and y.
fn rotate(stiffness: &mut Square<Complex<f64>, 12>, at: usize, s: f64, c: f64) {
    for row in stiffness.iter_mut() {
        let (one, two) = (row[at], row[at + 1]);
        (row[at], row[at + 1]) = (one * c - two * s, one * s + two * c);
    }
    let (one, two) = (stiffness[at], stiffness[at + 1]);
    for j in 0..12 {
        (stiffness[at][j], stiffness[at + 1][j]) = (one[j] * c - two[j] * s, one[j] * s + two[j] * c);
    }
}
