//! Keys of `experiment.toml`, and the page that lists them.
//!
//! Next door: the keys of a spec (`mod`), reading these (`crate::spec::experiment`).

#[cfg(feature = "reference")]
use super::sections;
use super::{Table, needed, optional, told};

/// The tables of `experiment.toml`; the first holds the keys at its top.
pub const EXPERIMENT_TABLES: [&Table; 3] = [&EXPERIMENT, &INVERSE_LENGTH, &RUN];

const EXPERIMENT: Table = Table {
    name: "",
    repeats: false,
    meaning: told("What holds for all runs."),
    keys: &[
        optional(
            "simulated",
            "true",
            "whether no rig made the files; every figure then says so. A file's own comment line that begins with \
                  `simulated` does the same",
            "`false`",
        ),
        optional(
            "name",
            "\"S_T between actuator and load cell\"",
            "what people call the experiment",
            "the folder's name",
        ),
        needed("nominal_force", "\"121.6 N\"", "F_nom, of which deviations are a share"),
        needed(
            "length_at_zero_force",
            "\"104 mm\"",
            "l0 of F = k(l − l0); of a spring with initial tension, where its straight line meets zero",
        ),
        optional(
            "averaging",
            "\"445 ms\"",
            "over which the LCR meter takes each mean; only to see whether it holds whole periods",
            "not looked at",
        ),
        optional("stiffness", "\"760 N/m\"", "k", "from F_o and the position in the calibration run"),
        optional(
            "length_at_zero",
            "\"138.2 mm\"",
            "length of the coil where u1 and u2 read zero",
            "from F_o in the calibration run: l0 + F_0/k",
        ),
        optional(
            "fast_mapping",
            "\"daq.toml\"",
            "which column of the `fast` files is which channel, as [Logs](logs.md) says",
            "columns carry the channels' names",
        ),
        optional(
            "calibration",
            "\"calibration.toml\"",
            "the file of `coilsense calibrate --out`, by which L becomes a length, in place of [inverse_length]",
            "fitted to the calibration run",
        ),
        optional("slow_mapping", "\"lcr.toml\"", "the same of the `slow` files", "columns carry the channels' names"),
    ],
};

const INVERSE_LENGTH: Table = Table {
    name: "inverse_length",
    repeats: false,
    meaning: told(
        "The curve 1/l = αL + β by which L becomes a length, as `coilsense calibrate` prints it; the figures are an example of a \
              measured coil with its leads, not of S_T in the model. Without it, it is fitted to the calibration run, \
              through the first preload run.",
    ),
    keys: &[needed("alpha", "2.1573e6", "α in 1/(H m)"), needed("beta", "-0.2056", "β in 1/m")],
};

const RUN: Table = Table {
    name: "run",
    repeats: true,
    meaning: told(
        "One recorded run; in the order in which they were recorded, since drift is looked for along it. At least one \
              `preload` is needed, and one `calibration` unless stiffness and length_at_zero are given.",
    ),
    keys: &[
        needed(
            "kind",
            "\"harmonic\"",
            "`calibration` (at rest at position after position), `preload` (at rest), `harmonic` (a sine), or `hit` (hits: counted, and \
                left to `coilsense identify`)",
        ),
        optional("name", "\"27 Hz\"", "what people call it", "from the names of its files"),
        needed("frequency", "\"26.966 Hz\"", "of the sine; held against the log, where another is refused")
            .of(&["harmonic"]),
        optional("amplitude", "\"1 mm\"", "of the sine; shown only", "not shown").of(&["harmonic"]),
        optional(
            "fast",
            "\"harmonic-12-fast.csv\"",
            "the log of load cell and position, beside this file: time, F_o, and F_x or u1 or u2. A preload and a sine need it",
            "none",
        ),
        optional(
            "slow",
            "\"harmonic-12-slow.csv\"",
            "the log of the LCR meter: a row per mean of L. A calibration needs it, there with u1 or u2, and F_o",
            "none",
        ),
    ],
};

/// The reference of all keys, as Markdown: `book/src/guide/experiment.md`.
#[cfg(feature = "reference")]
pub fn experiment_markdown() -> String {
    sections(INTRODUCTION, &EXPERIMENT_TABLES)
}

#[cfg(feature = "reference")]
const INTRODUCTION: &str = "# The experiment file

`coilsense experiment DIR` reads `DIR/experiment.toml`, which lists the logs of an experiment like that of the paper's section IV: a spring between
an actuator and a load cell, shaken by sines about a preload, its position watched by a laser and its inductance by a slow LCR meter.
`coilsense rig` writes such a folder; with a real rig you write this file by hand:

```toml
nominal_force = \"121.6 N\"
length_at_zero_force = \"104 mm\"
averaging = \"445 ms\"

[[run]]
kind = \"calibration\"
slow = \"calibration.csv\"

[[run]]
kind = \"preload\"
fast = \"preload-1-fast.csv\"
slow = \"preload-1-slow.csv\"

[[run]]
kind = \"harmonic\"
frequency = \"26.966 Hz\"
fast = \"sine-27-fast.csv\"
slow = \"sine-27-slow.csv\"
```

Positions grow from end 1 to end 2: with u1 or u2 alone, the spring is longer by u2 or by −u1 than where they read zero. Force is tension-positive.
Quantities are texts of a number and a unit; the logs themselves are described in [Logs](logs.md). This page is made from the table that the
reader itself uses (`crates/coilsense-lab/src/spec/keys/experiment.rs`); a test keeps the two equal.
";
