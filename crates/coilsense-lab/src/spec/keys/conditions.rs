//! Keys of `[[condition]]`.

use super::{Table, needed, optional, told};

const MOVING: &[&str] = &["impact", "end-stop"];
const DRIVEN: &[&str] = &["harmonic", "sweep", "step", "ramp", "pulse"];
const SINES: &[&str] = &["harmonic", "sweep"];
const LATE: &[&str] = &["step", "ramp", "pulse"];
const STARTED: &[&str] = &["harmonic", "sweep", "step", "ramp", "pulse", "recorded"];

pub(super) const CONDITION: Table = Table {
    name: "condition",
    repeats: true,
    meaning: told("What is done to the spring; one table for each condition of use."),
    keys: &[
        needed("kind", "\"impact\"", "`impact` (the ends stop dead while the windings still move; an end 2 that is a mass or under a force goes on at its speed), `end-stop` (the spring is stopped at an end of its range), \
               `harmonic`, `sweep` (linear in frequency), `step` (an exact jump, which no real drive makes: every mode is hit; a `ramp` is kinder), `ramp`, `pulse` (half a sine; its velocity jumps where it begins and ends) or `recorded` (a file)"),
        optional("name", "\"heel strike\"", "what people call it; no two alike", "the kind"),
        optional("length", "\"mid\"", "mean length: a length, `min`, `mid`, `max`, or a share of the range (`\"25 %\"` from min to max)", "`mid`; of an end stop, `at`"),
        needed("at", "\"max\"", "which end of the range the spring is stopped at: `min` or `max`").of(&["end-stop"]),
        optional("velocity", "\"0.25 m/s\"", "of the windings at t = 0; of an end stop the speed at which the length changed", "of an end stop, the range in 1 s (eq. 12)").of(MOVING),
        optional("profile", "\"uniform\"", "how the windings share the velocity: `uniform`, or `linear` from zero at end 1", "`uniform`; of an end stop `linear`").of(MOVING),
        optional("end", "1", "which end is driven", "`1`").of(DRIVEN),
        needed("frequency", "\"0.5 f1\"", "of the sine, in Hz or in multiples of the surge frequency f1; of a sweep from and to: `[\"5 Hz\", \"1.2 f1\"]`").of(SINES),
        needed("amplitude", "\"1 %\"", "how far the end moves: a length or a share of the range (at an end 2 under force or with a mass: a force or a share of F_nom)").of(DRIVEN),
        optional("phase", "\"-90 deg\"", "of the sine at t = 0", "`\"0 rad\"`").of(SINES),
        optional("begin", "\"0.1 s\"", "when it happens", "`\"0 s\"`").of(LATE),
        needed("rise_time", "\"20 ms\"", "how long the ramp lasts").of(&["ramp"]),
        needed("width", "\"10 ms\"", "how long the pulse lasts").of(&["pulse"]),
        optional("start", "\"rest\"", "windings at t = 0: at `rest`, or as those of a `massless` spring under the same inputs", "`rest`").of(STARTED),
        needed("file", "\"road.csv\"", "a CSV file beside the spec with the columns `time [s]` and `u1 [mm]`, `u2 [mm]` or `F_2 [N]`, each counted from where it is at `length`: a positive u1, as a negative u2, shortens the spring").of(&["recorded"]),
        optional("playback_speed", "\"120 %\"", "how fast the file's motion is played, of the speed at which it was recorded: a cam that turns, or a road that is driven, faster; \
                 `duration` and `window` stay those of the file's own time, so that the same turns are judged; forces of `F_2` stay what they are", "`\"100 %\"`").of(&["recorded"]),
        optional("duration", "\"1 s\"", "how long is simulated; of a recording in the file's own time", "`\"1 s\"`; the length of a recorded file"),
        optional("window", "[\"0.75 s\", \"1 s\"]", "the part that is judged; of a recording in the file's own time", "all of it"),
        optional("sample_rate", "\"10 kHz\"", "of the simulation", "`\"10 kHz\"`"),
    ],
};
