//! One explanation of the lines: what rings, its place on them, and all that speaks for it.
//!
//! Next door: the parts of its evidence (`place`, `ends`, `decays`), how a coil's is added up from what is known (`known`).

use super::ends::Told;
use super::place::Place;
use super::room::Room;
use super::trial::Knob;
use super::{decays, ends};
use crate::identify::mode_series::ModeSeries;
use crate::identify::phase_law::{Law, Seat, Support};

/// Compliance of a seat over the coil's that is as likely by its amount as by its logarithm \[1\].
pub(super) const USUAL: f64 = 0.01;

/// What may be the cause of lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Cause {
    /// A coil; what its mount is stands in the place.
    Coil,
    Harmonics,
    Mains,
    String,
    Beam(Support),
}

/// One explanation.
#[derive(Debug, Clone)]
pub(super) struct Explanation {
    pub(super) cause: Cause,
    pub(super) place: Place,
    pub(super) told: Told,
    /// ln of evidence and prior \[nats\].
    pub(super) total: f64,
    /// ln of how likely its mount is beforehand \[nats\].
    pub(super) prior: f64,
}

impl Explanation {
    pub(super) fn rival(room: &Room, cause: Cause, place: Place) -> Self {
        let total = place.evidence + ends::of_rival(&place, room.heard) + decays::of(&place, room.heard) - 1.6;
        Self { cause, place, told: Told { evidence: 0.0, turned: false }, total, prior: 0.0 }
    }

    /// f1 \[Hz\] of the coil between held ends, and its relative standard uncertainty \[1\].
    pub(super) fn first(&self) -> (f64, f64) {
        (self.place.trial.base, self.place.standard(Knob::Base))
    }

    /// Compliance of both seats over \[1\] what makes a mount that gives as likely by its amount as by the amount's logarithm; none where
    /// nothing gives.
    pub(super) fn gives(&self) -> Option<f64> {
        let Law::Coil { seats, .. } = self.place.trial.law else { return None };
        let each = seats.iter().filter_map(|seat| match seat {
            Seat::Gives(kappa, _) => Some(kappa),
            _ => None,
        });
        each.copied().reduce(|one, other| one + other).map(|kappa| kappa / USUAL)
    }

    /// In words.
    pub(super) fn name(&self) -> String {
        match self.cause {
            Cause::Coil => self.mode_series().name().to_owned(),
            Cause::Harmonics => "multiples of one motion".to_owned(),
            Cause::Mains => "multiples of the mains' frequency".to_owned(),
            Cause::String => "a string or belt".to_owned(),
            Cause::Beam(support) => support.name().to_owned(),
        }
    }

    /// The mount of a coil, for people.
    pub(super) fn mode_series(&self) -> ModeSeries {
        match self.place.trial.law {
            Law::Coil { seats: [Seat::Rigid, Seat::Rigid], .. } => ModeSeries::HeldHeld,
            Law::Coil { seats: [_, Seat::Free], .. } => ModeSeries::HeldFree,
            Law::Coil { seats: [_, Seat::Mass(mu)], .. } => ModeSeries::EndMass { mass_ratio: 1.0 / mu },
            Law::Coil { seats, .. } => {
                let compliance = seats.map(|seat| if let Seat::Gives(kappa, _) = seat { kappa } else { 0.0 });
                let mass = seats.map(|seat| if let Seat::Gives(_, mu) = seat { mu } else { 0.0 });
                ModeSeries::Gives { compliance, mass }
            }
            _ => ModeSeries::HeldHeld,
        }
    }

    /// N; infinite for the continuous coil.
    pub(super) fn windings(&self) -> f64 {
        match self.place.trial.law {
            Law::Coil { windings, .. } => windings,
            _ => f64::INFINITY,
        }
    }
}
