//! Two-ports in series: springs, ideal springs with dashpots and rigid masses, end 2 of each joined to end 1 of the next.
//!
//! Next door: one spring (`super::TwoPort`), what hangs on the last end ([`super::Load`]), the answer at one frequency (`transmission`).

use num_complex::Complex64;

use super::TwoPort;
use super::transmission::Transmission;
use crate::error::{Error, called, check, from_zero};

/// Parts in series, ready for any frequency.
///
/// At a joint end 2 of the left part and end 1 of the right one are one point: one displacement, U2 = U1', and one tension, F_o = F_i', since what
/// joins them has no mass. Forces are tension-positive, positions grow from end 1 to end 2. A rigid mass is a part of its own, both ends of which
/// move as one; there the tension differs by what accelerates it, F_o − F_i = −M ω² U.
///
/// | part | U2 | F_o |
/// |---|---|---|
/// | spring | as [`TwoPort`] | |
/// | link: ideal spring k beside a dashpot c | U1 + F_i / (k + jωc) | F_i |
/// | rigid mass M | U1 | F_i − M ω² U1 |
///
/// Two halves of a chain, undamped or with a loss factor, are the whole. With every other damping they are not: it acts on velocities relative to
/// the straight line between the ends ([`crate::Damping`]), and each half has a line of its own.
///
/// Source:   `[Weijde2017]` eqs. 5–7 for the springs; chain matrices multiply, any text on two-ports.
/// Valid:    as its parts.
/// Accuracy: 1e-13 of the whole chain away from resonances, 1e-11 of a direct solve of all masses' equations.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// use coilsense::Damping;
/// use coilsense::two_port::{Cascade, Load, TwoPort};
///
/// let spring = Cascade::from(TwoPort::chain(&spring, Damping::Modal(0.005))?);
/// // A motor of 0.4 kg, the spring, and a leg whose skin is a soft spring with some loss.
/// let ankle = Cascade::mass(0.4)?.then(&spring).then(&Cascade::mass(0.5)?).then(&Cascade::link(3e4, 20.0)?);
/// let at = ankle.at(std::f64::consts::TAU * 10.0)?;
/// // What is pushed at the motor arrives at a held skin.
/// assert!(at.transmittance(&Load::HELD).norm() > 0.5);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Cascade {
    parts: Vec<Part>,
}

/// One of them.
#[derive(Debug, Clone, PartialEq)]
enum Part {
    Spring(TwoPort),
    /// k \[N/m\] and c \[N s/m\].
    Link(f64, f64),
    /// M \[kg\].
    Mass(f64),
}

/// Largest angular frequency of what has no time of its own \[rad/s\].
const LARGEST: f64 = 1e12;

impl From<TwoPort> for Cascade {
    fn from(spring: TwoPort) -> Self {
        Self { parts: vec![Part::Spring(spring)] }
    }
}

impl Cascade {
    /// A rigid mass M \[kg\].
    ///
    /// By itself it has no stiffness matrix: its ends cannot move apart, and its entries are infinite.
    ///
    /// # Errors
    /// [`Error::Value`] where it is below zero or not finite.
    pub fn mass(mass: f64) -> Result<Self, Error> {
        from_zero("mass", mass, "kg")?;
        Ok(Self { parts: vec![Part::Mass(mass)] })
    }

    /// An ideal spring k \[N/m\] beside a dashpot c \[N s/m\], without mass; either may be zero.
    ///
    /// Where both pull nothing (k = 0 at rest) it is a gap: no force gets through the matrix, and the ratio of nothing to nothing is infinite.
    ///
    /// # Errors
    /// [`Error::Value`] where one is below zero or not finite, or both are zero.
    pub fn link(stiffness: f64, damping: f64) -> Result<Self, Error> {
        from_zero("stiffness", stiffness, "N/m")?;
        from_zero(called("damping", "damping of the link"), damping, "N s/m")?;
        let held = stiffness + damping > 0.0;
        check(held, "stiffness", stiffness, "N/m", "above zero where the link has no damping")?;
        Ok(Self { parts: vec![Part::Link(stiffness, damping)] })
    }

    /// These parts, then those of `next`: end 2 of the one joined to end 1 of the other.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        Self { parts: self.parts.iter().chain(&next.parts).cloned().collect() }
    }

    /// How many parts it has.
    pub fn count(&self) -> usize {
        self.parts.len()
    }

    /// The two-port at one angular frequency.
    ///
    /// - `angular_frequency`: ω \[rad/s\], of either sign (−ω gives the conjugate), zero included
    ///
    /// # Errors
    /// [`Error::Value`] where ω is not finite, or larger than a part takes ([`TwoPort::at`]; 1e12 rad/s for the others).
    pub fn at(&self, angular_frequency: f64) -> Result<Transmission, Error> {
        let holds = angular_frequency.abs() <= LARGEST;
        check(holds, "angular_frequency", angular_frequency, "rad/s", "finite and at most 1e12 in size")?;
        let mut through = Transmission::nothing(angular_frequency);
        for part in &self.parts {
            through = through.then(&match part {
                Part::Spring(spring) => Transmission::spring(&spring.at(angular_frequency)?, angular_frequency),
                Part::Link(stiffness, damping) => {
                    Transmission::link(Complex64::new(*stiffness, angular_frequency * damping), angular_frequency)
                }
                Part::Mass(mass) => Transmission::mass(*mass, angular_frequency),
            });
        }
        Ok(through)
    }
}
