//! The two readings of the paper: what its text says, and what its printed numbers say.
//!
//! Next door: the conditions' names (`condition`), where the readings part (`reason`).

use std::f64::consts::FRAC_PI_2;

use coilsense::excitation::traverse_velocity;
use coilsense::{Deviation, End, EndInput, Error, Excitation, Spring, Start, VelocityProfile};

use super::Condition;

/// Speed of the heel strike \[m/s\], `[Weijde2017]` section III-B.
const HEEL_STRIKE_VELOCITY: f64 = 0.25;

/// Every printed cell of S_A is smaller than eq. (14)'s by this one factor, as if F_nom were 373.1 N / 0.925 = 403.35 N; cause
/// unknown. Found by fitting the printed Table II.
pub const PAPER_NOMINAL_FORCE_FACTOR: f64 = 0.925;

/// How the paper is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Protocol {
    /// The literal words of its text.
    Text,
    /// What makes the printed tables come out.
    Tables,
}

impl Protocol {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Tables, Self::Text];

    /// Its name on the command line and in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Tables => "tables",
        }
    }

    /// The excitation of a spring in a condition.
    ///
    /// Source: `[Weijde2017]` section III-B and eqs. 3 and 12.
    ///
    /// # Errors
    /// [`Error::Value`] for a spring whose lengths or frequencies cannot carry the condition.
    pub fn excitation(self, condition: Condition, spring: &Spring) -> Result<Excitation, Error> {
        let (shortest, longest) = spring.operating_range();
        let speed = traverse_velocity(spring);
        match condition {
            Condition::HeelStrike => Excitation::impact(spring.mid_length(), HEEL_STRIKE_VELOCITY),
            Condition::EndStopMax => Excitation::end_stop(longest, speed, VelocityProfile::Linear),
            Condition::EndStopMin => Excitation::end_stop(shortest, -speed, self.contraction_profile()),
            Condition::HalfResonance => self.harmonic(spring, 0.5 * spring.surge_frequency(), 0.01),
            Condition::Resonance => self.harmonic(spring, spring.surge_frequency(), 0.001),
        }
    }

    /// How the windings move when the spring is stopped while getting shorter.
    fn contraction_profile(self) -> VelocityProfile {
        match self {
            Self::Text => VelocityProfile::Linear,
            Self::Tables => VelocityProfile::Uniform,
        }
    }

    /// A sinusoid on end 1 with an amplitude given as a share of the operating range.
    fn harmonic(self, spring: &Spring, frequency: f64, share: f64) -> Result<Excitation, Error> {
        let (shortest, longest) = spring.operating_range();
        let (phase, start) = match self {
            Self::Text => (0.0, Start::Rest),
            Self::Tables => (-FRAC_PI_2, Start::Massless),
        };
        let input = EndInput::harmonic(share * (longest - shortest), frequency, phase);
        Excitation::harmonic(spring.mid_length(), End::One, input, start)
    }

    /// F_nom \[N\] of a spring of the paper.
    pub fn nominal_force(self, name: &str, spring: &Spring) -> f64 {
        match self {
            Self::Tables if name == "S_A" => spring.nominal_force() / PAPER_NOMINAL_FORCE_FACTOR,
            _ => spring.nominal_force(),
        }
    }

    /// What Table III calls the maximum deviation.
    pub fn maximum(self, deviation: &Deviation) -> f64 {
        match self {
            Self::Text => deviation.maximum_absolute,
            Self::Tables => deviation.maximum,
        }
    }
}
