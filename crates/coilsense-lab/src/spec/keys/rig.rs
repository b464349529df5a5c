//! Keys of `[rig]`.

use super::{Table, optional, told};

pub(super) const RIG: Table = Table {
    name: "rig",
    repeats: false,
    meaning: told(
        "The rig that `coilsense rig` lets run: end 2 at a load cell, end 1 at a linear actuator watched by a laser, the spring's ends at an \
              LCR meter. What is left out is as in the paper's experiment. The instruments are the first `[[sensor]]` of kind `load-cell` at \
              end 2, `deflection` and `inductance`; for a kind that is not there, the paper's device. `[mount]` must give one damping.",
    ),
    keys: &[
        optional("preload", "\"26 N\"", "static force about which the actuator moves", "`\"26 N\"`"),
        optional("sample_rate", "\"2.5 kHz\"", "at which load cell and laser are recorded", "`\"2.5 kHz\"`"),
        optional("duration", "\"40 s\"", "of each recorded run", "`\"40 s\"`"),
        optional("readings", "59", "of the LCR meter in a run, one every `duration`/`readings`", "`59`"),
        optional("pause", "\"10 s\"", "between two recorded runs, while the spring settles", "`\"10 s\"`"),
        optional(
            "frequencies",
            "13",
            "how many runs with a sine; the n-th has n periods in the LCR meter's averaging window",
            "`13`",
        ),
        optional("amplitude", "\"1 mm\"", "of the sines", "`\"1 mm\"`"),
        optional("distortion", "\"2 %\"", "the actuator's second harmonic, as a share of the amplitude", "`\"2 %\"`"),
        optional(
            "calibration_travel",
            "\"9 mm\"",
            "from the first to the last position of the calibration, about the preload",
            "`\"9 mm\"`",
        ),
        optional("calibration_positions", "11", "at which the calibration rests", "`11`"),
        optional(
            "settling",
            "\"120 s\"",
            "how long the spring has been stretched and shaken before the first run",
            "`\"120 s\"`",
        ),
        optional(
            "relaxation",
            "\"0.02 %\"",
            "of the force, lost with each decade of time since the spring was stretched",
            "`\"0.02 %\"`",
        ),
        optional("hits", "5", "how many runs in which end 1 is hit and then rests", "`5`"),
        optional("hits_per_run", "5", "hits in each of them, at random times; at most 7", "`5`"),
        optional("hit_height", "\"0.5 mm\"", "how far a hit moves end 1, within 30 % either way", "`\"0.5 mm\"`"),
        optional("hit_duration", "\"5 ms\"", "how long a hit lasts, within 20 % either way", "`\"5 ms\"`"),
    ],
};
