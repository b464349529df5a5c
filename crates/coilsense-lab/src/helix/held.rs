//! One way in which both ends are held.
//!
//! Next door: what it makes of the coil (`modes`).

use coilsense::helix::{Ends, Holding, Turning};

/// One way in which both ends are held against tilting and turning.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Held {
    ends: Ends,
    turning: Turning,
    spins: bool,
}

impl Held {
    /// Ends 1 and 2, and whether each is free to turn about the spring's axis.
    pub fn new([end1, end2]: [Holding; 2], turns: [bool; 2]) -> Self {
        let turning = if turns.contains(&true) { Turning::Free } else { Turning::Held };
        Self { ends: Ends::new(end1, end2), turning, spins: turns == [true; 2] }
    }

    /// What holds the ends of the wire.
    pub fn ends(&self) -> Ends {
        self.ends
    }

    /// Whether the spring turns as it is stretched.
    pub fn turning(&self) -> Turning {
        self.turning
    }

    /// Whether nothing keeps the coil from spinning about its axis.
    pub fn spins(&self) -> bool {
        self.spins
    }

    /// In words: `ends held`, `ends free to tilt`, `end 1 held, end 2 free to turn`.
    pub fn words(&self) -> String {
        let of = |holding: Holding| {
            let known = [
                (Holding::clamped(), "held"),
                (Holding::pinned(), "free to tilt"),
                (Holding::swivel(), "free to turn"),
                (Holding::ball(), "free to tilt and to turn"),
            ];
            known.into_iter().find(|(other, _)| *other == holding).map_or("held", |(_, words)| words)
        };
        let (one, two) = (of(self.ends.end1), of(self.ends.end2));
        if one == two { format!("ends {one}") } else { format!("end 1 {one}, end 2 {two}") }
    }
}
