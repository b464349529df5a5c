//! Keys of `[cam]`.
//!
//! Next door: reading them (`crate::spec::cam`).

use super::{Table, needed, optional, told};

const LAW: &[&str] = &["law"];
const FILE: &[&str] = &["file"];
const HARMONICS: &[&str] = &["harmonics"];

pub(super) const CAM: Table = Table {
    name: "cam",
    repeats: false,
    meaning: told(
        "What moves end 1 once in each turn of a camshaft, for `coilsense speed`: a standard law of lift over angle, a file of it, or its harmonics. Other commands take their \
              inputs from `[[condition]]`.",
    ),
    keys: &[
        optional(
            "law",
            "\"3-4-5-6\"",
            "`3-4-5-6` (h 64 x³ (1 − x)³ over the whole event), `3-4-5` or `4-5-6-7` (polynomials up to the nose, and back), `cycloid` or `harmonic` (the same \
               with sines)",
            "`3-4-5-6`",
        )
        .of(LAW),
        needed("lift", "\"10 mm\"", "the largest lift, by which the spring gets shorter").of(LAW),
        needed("angle", "\"130 deg\"", "of the camshaft, over which the law lifts").of(LAW),
        optional(
            "file",
            "\"cam.csv\"",
            "a table of angle in degrees (of the camshaft, from 0 to 360 at most) and lift in millimetres, in place of a law: a smooth curve is laid through it",
            "none: the law",
        )
        .of(FILE),
        optional(
            "harmonics",
            "[[1, \"4 mm\", \"180 deg\"], [2, \"1 mm\"]]",
            "number, amplitude and phase (0 where left out) of each harmonic of the camshaft, in place of a law: the sum of the cosines, counted from its least",
            "none: the law",
        )
        .of(HARMONICS),
        optional(
            "length",
            "\"max\"",
            "of the spring at rest on the base circle: a length, or `min`, `mid`, `max` of the range in use",
            "`max`",
        ),
    ],
};
