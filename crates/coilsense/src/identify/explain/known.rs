//! What is known of a record beside its lines: windings, which ends were recorded, which mounts may be.
//!
//! Next door: one explanation (`explanation`), which are tried by it (`search`).

use super::explanation::{Cause, Explanation};
use super::place::Place;
use super::room::Room;
use super::{decays, ends};
use crate::identify::settings::Settings;
use crate::mount::FarEnd;

/// Mounts that a record may show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Mount {
    Held,
    Gives,
    Mass,
    Free,
}

/// What is known of a record beside its lines.
pub(in crate::identify) struct Known {
    pub(super) windings: Option<f64>,
    /// Whether both forces were recorded.
    pub(super) both: bool,
    /// Whether end 2 was seen to move.
    pub(super) end_moves: bool,
    /// Whether one force is known to have the other's sign, or not to.
    pub(super) turned: Option<bool>,
    pub(super) mounts: Vec<Mount>,
}

impl Known {
    /// `end_moves`: whether end 2 rings along; none where its position was not recorded.
    pub(in crate::identify) fn of(
        settings: &Settings,
        both: bool,
        end_moves: Option<bool>,
        turned: Option<bool>,
    ) -> Self {
        let mounts = match (settings.far_end, end_moves) {
            (Some(FarEnd::Position), _) => vec![Mount::Held],
            (Some(FarEnd::Force), _) => vec![Mount::Free],
            (Some(FarEnd::Mass(_)), _) => vec![Mount::Mass],
            (None, Some(false)) => vec![Mount::Held, Mount::Gives],
            (None, Some(true)) => vec![Mount::Held, Mount::Gives, Mount::Mass, Mount::Free],
            (None, None) => vec![Mount::Held, Mount::Gives, Mount::Mass],
        };
        Self { windings: settings.windings, both, end_moves: end_moves == Some(true), turned, mounts }
    }

    pub(super) fn coil(&self, room: &Room, place: Place, prior: f64) -> Explanation {
        let told = ends::of_coil(&place, room.heard, self.turned);
        let total = place.evidence + told.evidence + decays::of(&place, room.heard) + prior;
        Explanation { cause: Cause::Coil, place, told, total, prior }
    }
}
