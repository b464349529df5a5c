//! The theories by name, side by side.
//!
//! Next door: the formulas, one a file.

use super::{Coil, HelixSelf, ReturnPath, helix, ideal_solenoid, lundin, nagaoka, nagaoka_rosa};
use super::{wheeler_1928, wheeler_1982};
use crate::inductance::{Leads, MaxwellSum, SelfDistance, SteelCoil};

/// A formula for the inductance of a coil at a length.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Theory {
    /// [`ideal_solenoid`].
    IdealSolenoid,
    /// [`nagaoka()`].
    Nagaoka,
    /// [`nagaoka_rosa`].
    NagaokaRosa,
    /// [`lundin()`].
    Lundin,
    /// [`wheeler_1928`], for long coils.
    Wheeler1928,
    /// [`wheeler_1982`], for any length.
    Wheeler1982,
    /// [`MaxwellSum`] with [`SelfDistance::GeometricMean`].
    MaxwellSum,
    /// [`helix()`] with its ends open.
    NeumannHelix,
    /// [`helix()`] with the current going back on the axis.
    NeumannHelixReturn,
    /// Turns of magnetic wire and the current along the coil, its ends open: [`SteelCoil::at_length`], the radius as it is at that length.
    SteelSpring,
}

impl Theory {
    /// Those of wire that is not magnetic, the simplest first; [`Self::SteelSpring`] needs a permeability, which is in no data sheet, and solves
    /// some hundred equations for a length.
    pub const ALL: [Self; 9] = [
        Self::IdealSolenoid,
        Self::Nagaoka,
        Self::NagaokaRosa,
        Self::Lundin,
        Self::Wheeler1928,
        Self::Wheeler1982,
        Self::MaxwellSum,
        Self::NeumannHelix,
        Self::NeumannHelixReturn,
    ];

    /// What people call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::IdealSolenoid => "ideal solenoid",
            Self::Nagaoka => "Nagaoka",
            Self::NagaokaRosa => "Nagaoka with Rosa's round-wire correction",
            Self::Lundin => "Lundin",
            Self::Wheeler1928 => "Wheeler 1928, long coils",
            Self::Wheeler1982 => "Wheeler 1982, any length",
            Self::MaxwellSum => "Maxwell sum",
            Self::NeumannHelix => "Neumann helix, open ends",
            Self::NeumannHelixReturn => "Neumann helix, straight return on the axis",
            Self::SteelSpring => "magnetic turns, current along them with open ends",
        }
    }

    /// What it makes of windings that are not a whole number.
    pub fn fractions(self) -> &'static str {
        match self {
            Self::NagaokaRosa => "N as it is; the series of k_m between whole numbers",
            Self::MaxwellSum => "round(N) turns at pitch l/N, self term N times",
            Self::NeumannHelix | Self::NeumannHelixReturn => "the wire ends within a turn",
            Self::SteelSpring => "between ⌊N⌋ and ⌈N⌉ turns of pitch l/N, linearly",
            _ => "N as it is",
        }
    }

    /// L \[H\] of a coil at a length \[m\]; NaN for a length that is not above zero and finite, and where [`Self::SteelSpring`] does not hold: turns nearer than
    /// 1.04 wire diameters, or more than 149 of them.
    ///
    /// ```
    /// use coilsense::inductance::theories::{Coil, Theory};
    /// let coil = Coil::new(52.0, 8e-3, 1e-3)?;
    /// for theory in Theory::ALL {
    ///     let microhenry = 1e6 * theory.inductance(&coil, 0.23);
    ///     assert!((2.7..3.1).contains(&microhenry), "{}: {microhenry} µH", theory.name());
    /// }
    /// let [air, steel] = [1.0, 2.5].map(|relative| coil.with_permeability(relative).map(|coil| Theory::SteelSpring.inductance(&coil, 0.23)));
    /// assert!((steel? / air? - 1.1).abs() < 0.02); // a tenth more than of wire that is not magnetic
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn inductance(self, coil: &Coil, length: f64) -> f64 {
        if !(length > 0.0 && length.is_finite()) {
            return f64::NAN;
        }
        match self {
            Self::IdealSolenoid => ideal_solenoid(coil, length),
            Self::Nagaoka => nagaoka(coil, length),
            Self::NagaokaRosa => nagaoka_rosa(coil, length),
            Self::Lundin => lundin(coil, length),
            Self::Wheeler1928 => wheeler_1928(coil, length),
            Self::Wheeler1982 => wheeler_1982(coil, length),
            Self::MaxwellSum => MaxwellSum::of_coil(coil, SelfDistance::GeometricMean).at_length(length),
            Self::NeumannHelix => helix(coil, length, HelixSelf::GeometricMean, ReturnPath::Open),
            Self::NeumannHelixReturn => helix(coil, length, HelixSelf::GeometricMean, ReturnPath::StraightOnAxis),
            Self::SteelSpring => {
                SteelCoil::at_length(coil, length, Leads::Open, coil.permeability(), length).unwrap_or(f64::NAN)
            }
        }
    }
}
