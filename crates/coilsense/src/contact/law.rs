//! What two windings do when they meet.
//!
//! Next door: the chain that they belong to (`chain`), how contacts are followed (`integrate`).

use crate::error::{Error, above_zero, check, not_negative};

/// How contact is treated, checked.
///
/// ```
/// use coilsense::contact::Contact;
/// assert!(Contact::hard(0.2).is_ok());
/// assert_eq!(Contact::hard(1.5).unwrap_err().to_string(), "restitution must be from 0 to 1, got 1.5");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    law: Law,
    pitch: Option<f64>,
    ends: bool,
    lifts: bool,
    follower: Option<f64>,
    most_events: usize,
}

/// The law of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Law {
    /// Windings do not overlap. What meets parts again with a share of the speed; slower than 2 mm/s, and with a share of zero always, it stays
    /// together until it is pulled apart.
    Hard {
        /// e \[1\], 0 to 1.
        restitution: f64,
    },
    /// A spring and a dashpot side by side while closed, which do not pull.
    Elastic {
        /// K_c of a full turn \[N/m\].
        stiffness: f64,
        /// ζ_c \[1\]: C_c = 2ζ_c √(K_c m), m = m_1 m_2/(m_1 + m_2) of the two that meet.
        damping_ratio: f64,
    },
}

impl Default for Contact {
    /// Hard, and what meets stays together.
    fn default() -> Self {
        Self {
            law: Law::Hard { restitution: 0.0 },
            pitch: None,
            ends: false,
            lifts: false,
            follower: None,
            most_events: 1_000_000,
        }
    }
}

impl Contact {
    /// Hard contact with Newton's restitution e \[1\]; [`Contact::default`] has zero.
    ///
    /// No measured value of windings was found. With e = 0 the answer can be followed for seconds; with e = 1 it is lost within some 50 ms, and
    /// only its mean squares mean anything.
    ///
    /// # Errors
    /// [`Error::Value`] for a value outside of 0 to 1.
    pub fn hard(restitution: f64) -> Result<Self, Error> {
        check((0.0..=1.0).contains(&restitution), "restitution", restitution, "", "from 0 to 1")?;
        Ok(Self { law: Law::Hard { restitution }, ..Self::default() })
    }

    /// Elastic contact: K_c of a full turn \[N/m\], and ζ_c \[1\].
    ///
    /// # Errors
    /// [`Error::Value`] for a stiffness that is not above zero or damping below zero.
    pub fn elastic(stiffness: f64, damping_ratio: f64) -> Result<Self, Error> {
        check(stiffness.is_finite() && stiffness > 0.0, "stiffness", stiffness, "N/m", "above zero and finite")?;
        not_negative("damping_ratio", damping_ratio, "")?;
        Ok(Self { law: Law::Elastic { stiffness, damping_ratio }, ..Self::default() })
    }

    /// Windings touch at this pitch \[m\], centre to centre, in place of 2ρ: l_s/N where a spring is solid at l_s.
    ///
    /// # Errors
    /// [`Error::Value`] for a pitch that is not above zero.
    pub fn at_pitch(self, pitch: f64) -> Result<Self, Error> {
        above_zero("contact_pitch", pitch, "m")?;
        Ok(Self { pitch: Some(pitch), ..self })
    }

    /// Whether the first and the last winding meet their seats, at half the gap between windings; they do not unless this says so.
    #[must_use]
    pub fn with_ends(self, ends: bool) -> Self {
        Self { ends, ..self }
    }

    /// Whether an end leaves its seat where the spring would have to pull at it; it does not unless this says so.
    #[must_use]
    pub fn with_lift_off(self, lifts: bool) -> Self {
        Self { lifts, ..self }
    }

    /// With a mass at end 1 \[kg\] that the input pushes as a cam does, and cannot pull: it flies where it would have to be, and comes down on the cam
    /// without a rebound.
    ///
    /// # Errors
    /// [`Error::Value`] for a mass that is not above zero, and for windings that give way, beside which a hard follower is not covered.
    pub fn with_follower(self, mass: f64) -> Result<Self, Error> {
        above_zero("follower_mass", mass, "kg")?;
        let is_hard = matches!(self.law, Law::Hard { .. });
        check(is_hard, "follower_mass", mass, "kg", "none where windings are elastic: take hard ones")?;
        Ok(Self { follower: Some(mass), ..self })
    }

    /// After how many events it gives up \[1\]; a million, unless this says otherwise.
    #[must_use]
    pub fn with_most_events(self, most_events: usize) -> Self {
        Self { most_events, ..self }
    }

    /// What a contact does.
    pub fn law(&self) -> Law {
        self.law
    }

    /// The pitch at which windings touch \[m\], where it is not that of the wire.
    pub fn pitch(&self) -> Option<f64> {
        self.pitch
    }

    /// Whether end windings meet their seats.
    pub fn ends(&self) -> bool {
        self.ends
    }

    /// Whether ends leave their seats.
    pub fn lifts(&self) -> bool {
        self.lifts
    }

    /// The mass that a cam pushes at end 1 \[kg\].
    pub fn follower(&self) -> Option<f64> {
        self.follower
    }

    /// After how many events it gives up.
    pub fn most_events(&self) -> usize {
        self.most_events
    }
}
