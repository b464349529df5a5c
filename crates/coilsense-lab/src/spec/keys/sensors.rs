//! Keys of `[[sensor]]`, `[goal]` and `[uncertainty]`.

use super::{Table, needed, optional, told};

const ENCODERS: &[&str] = &["two-encoder"];
const COIL: &[&str] = &["inductance"];

pub(super) const SENSOR: Table = Table {
    name: "sensor",
    repeats: true,
    meaning: told("An instrument that watches the spring; one table for each. Its native unit is N for a load cell, m for `deflection` and `two-encoder`, \
              H for `inductance`. The order of its parts: low-pass, delay, averaging window, sampling, noise, resolution."),
    keys: &[
        needed(
            "kind",
            "\"load-cell\"",
            "`load-cell` (F_i or F_o), `deflection` (potentiometer, encoder, laser: u2 − u1), `two-encoder` (a motor-side encoder behind a \
               drive train, and one at end 2) or `inductance` (the spring's own); a `class` says it too",
        ),
        optional("name", "\"laser\"", "what people call it; no two alike", "the kind, or the class"),
        optional(
            "class",
            "\"strain-gauge load cell with bridge converter\"",
            "a name of the sensor catalogue (`coilsense init --sensors` lists it); keys given here replace the catalogue's",
            "none",
        ),
        optional("end", "2", "which end the load cell sits at", "`2`").of(&["load-cell"]),
        optional(
            "range",
            "\"150 N\"",
            "full scale, in the native unit",
            "F_nom; the operating range; the inductance over the operating range",
        ),
        optional("bandwidth", "\"1 kHz\"", "−3 dB, of a Butterworth low-pass", "no low-pass"),
        optional("order", "2", "of the low-pass, 1 to 8", "`2`"),
        optional("delay", "\"1 ms\"", "dead time", "`\"0 s\"`"),
        optional(
            "averaging",
            "\"20 ms\"",
            "it reads the mean over a preceding window, as LCR meters do",
            "no averaging",
        ),
        optional("sample_rate", "\"1 kHz\"", "it holds each reading until the next", "that of the simulation"),
        optional("noise", "\"0.1 %\"", "rms, of every reading: native unit or a share of `range`; of `two-encoder` of the difference of both, √2 times one's where they are alike", "none"),
        optional("resolution", "\"10 um\"", "smallest step: native unit or a share of `range`; of `two-encoder` of the difference, as noise", "none"),
        optional(
            "accuracy_full_scale",
            "\"0.1 %\"",
            "limits of error, the same for every reading: native unit or a share of `range`",
            "none",
        ),
        optional("accuracy_reading", "\"0.2 %\"", "limits of error, as a share of the reading (of a deflection: of the change from the length without force)", "none"),
        optional(
            "calibration_uncertainty",
            "\"0.1 %\"",
            "standard uncertainty of its gain by calibration, as a share of the reading",
            "none",
        ),
        optional("temperature_coefficient", "\"0.01 %/K\"", "of the sensor's gain", "none"),
        optional(
            "compliance",
            "\"2 um/N\"",
            "of the drive train between motor-side encoder and end 1; its static part counts as calibrated, but for `compliance_tolerance`",
            "none",
        )
        .of(ENCODERS),
        optional("compliance_tolerance", "\"10 %\"", "how far that compliance may be off, either way", "`\"10 %\"`").of(ENCODERS),
        optional(
            "backlash",
            "\"20 um\"",
            "of that drive train, as its whole play; without effect as long as the force keeps its sign",
            "none",
        )
        .of(ENCODERS),
        optional(
            "calibration",
            "\"fitted\"",
            "of L over length: eq. (13) `fitted` to measured lengths, or `two-point` (the ends of the range); `steel` (the theory of magnetic wire, from two points on); or \
             `theory` (an uncalibrated Maxwell sum). Or the file `calibration.toml` that `coilsense calibrate --out` wrote, beside the spec: its own uncertainty over the operating range then counts",
            "`fitted`",
        )
        .of(COIL),
        optional(
            "calibration_form",
            "\"1.3 %\"",
            "how far a measured spring departs from that, as standard deviation, a share of the travel",
            "`\"1.3 %\"` of `fitted`, `\"1.4 %\"` of `two-point`, `\"0.3 %\"` of `steel`. Where `relative_permeability` with its tolerance is above 1.01: what eq. (13), fitted or \
             through two points, leaves of such a coil. All but the first with 0.7 % for remounting. Of `theory` `\"30 %\"`, and `\"14 %\"` of a wire whose \
             `relative_permeability` is known to be 1 within 1 %",
        )
        .of(COIL),
        optional(
            "frequency",
            "\"1 kHz\"",
            "at what the meter works: L is that of direct current, and a frequency at which the current crowds in the wire's skin is warned of",
            "none",
        )
        .of(COIL),
        optional(
            "leads",
            "\"50 mm\"",
            "where the meter's current goes back: `open` (far away), the distance of the return lead from the coil's axis, or `none` (what flows along the coil is left out); it counts where what eq. (13) leaves is computed",
            "`open`",
        )
        .of(COIL),
    ],
};

pub(super) const GOAL: Table = Table {
    name: "goal",
    repeats: false,
    meaning: told("What the force signal should achieve."),
    keys: &[
        needed("error", "\"1 %\"", "largest standard uncertainty wanted: a force, or a share of F_nom"),
        optional(
            "bandwidth",
            "\"20 Hz\"",
            "up to which frequency the force is wanted; errors above it do not count, and a sensor must reach it",
            "errors of every frequency count",
        ),
        optional(
            "force",
            "\"F_x\"",
            "the true force: `F_x` (that of a spring without mass, the paper's reference), `F_i` or `F_o`",
            "`F_x`",
        ),
    ],
};

pub(super) const UNCERTAINTY: Table = Table {
    name: "uncertainty",
    repeats: false,
    meaning: told("What the uncertainty budget assumes."),
    keys: &[
        optional("temperature_change", "\"10 K\"", "since the calibration, either way", "`\"10 K\"`"),
        optional("coverage", "\"95 %\"", "of the expanded uncertainty", "`\"95 %\"`"),
        optional("trials", "100000", "of the Monte Carlo", "`100000`"),
        optional("seed", "1", "of the Monte Carlo, of sensor noise and of the rig", "`1`"),
    ],
};
