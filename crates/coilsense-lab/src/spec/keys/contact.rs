//! Keys of `[contact]`.
//!
//! Next door: reading them (`crate::spec::contact`).

use super::{Table, optional, told};

const HARD: &[&str] = &["hard"];
const ELASTIC: &[&str] = &["elastic"];
const MEETS: &[&str] = &["hard", "elastic"];

pub(super) const CONTACT: Table = Table {
    name: "contact",
    repeats: false,
    meaning: told(
        "What windings do when they meet. Without this table they pass through one another, and a warning says from when on. With it the motion is \
              followed from event to event from the first contact on, of a coil whose windings are apart at its length without force (no `initial_tension`, \
              no `helix`); friction, rolling of wires and the loss inside a wire are left out. How windings \
              rebound nobody has measured: unless the table says so, every result is given for the least and the most that can be expected.",
    ),
    keys: &[
        optional(
            "windings",
            "\"hard\"",
            "`hard` (they do not overlap), `elastic` (a spring and a dashpot side by side while they touch) or `off`",
            "`hard`",
        ),
        optional(
            "restitution",
            "[0.0, 0.5]",
            "share of the closing speed with which windings part again, 0 to 1; of a list every result is given for each. With 0 they stay together \
               until pulled apart; with 1 an answer is lost within some 50 ms, and only its rms means anything",
            "`[0.0, 0.5]`",
        )
        .of(HARD),
        optional(
            "stiffness",
            "\"2e9 N/m\"",
            "K_c of a full turn on the next; or `Hertz`: two parallel cylinders on the length of a turn, under F_nom",
            "`Hertz`",
        )
        .of(ELASTIC),
        optional(
            "damping_ratio",
            "[3.0, 0.3]",
            "ζ_c of K_c with the two masses that meet; 0.3, 1 and 3 are restitutions of 0.45, 0.14 and 0.02. Of a list every result is given for each",
            "`[3.0, 0.3]`",
        )
        .of(ELASTIC),
        optional(
            "ends",
            "true",
            "whether the end windings meet their seats, on which they roll over their first turn",
            "`true` for ends that only push (`open`, `closed`, ground); `false` for hooks, and where end 2 is a mass, which takes it with `masses_per_winding = 1` only",
        )
        .of(MEETS),
        optional(
            "lift_off",
            "true",
            "whether an end leaves its seat where it would have to be pulled",
            "`true` for ends that only push, `false` for hooks",
        )
        .of(MEETS),
    ],
};
