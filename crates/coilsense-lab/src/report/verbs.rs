//! All verbs and what may be asked of each: of it are made the command's arguments and `book/src/reference/options.md`.
//!
//! Next door: the tables of those verbs that Python or the page ask, too (`recording::request`, `identification::request`,
//! `calibration::request`, `mitigation::request`, `sweep::request`, `speed::request`), what a row says (`crate::request`), the page of the book (`reference`).

mod folders;
mod sweeps;

use crate::request::{
    Allowed, CHECK, DATE, DATE_OF_OUT, Door, IfAbsent, JSON, OVERWRITE, OVERWRITE_OUT, Row, SPEC, Takes, Verb, out,
};
use crate::{calibration, identification, mitigation, plant, recording, speed, sweep};
pub use folders::{BEGIN, FOLDER, RECORD_FOLDER};
use folders::{EXPERIMENT, RECORD};
pub use sweeps::{CSV, DATASET, DRAWS_SEED, MAXIMIZE, MINIMIZE, OF, RESAMPLES, SPEC_ROW, WHERE};
use sweeps::{PARETO, SENSITIVITY, SWEEP, VARIED};

/// The verbs, in the order of the command's help.
pub const VERBS: [Verb; 19] = [
    Verb { name: "init", about: "Write a commented spec to start from", groups: &[&INIT], more: "" },
    Verb {
        name: "spring",
        about: "The data sheet of a spec's spring: rate, mass, stress, lengths, surge, lateral and torsional frequencies",
        groups: &[&SPRING],
        more: "",
    },
    Verb {
        name: "simulate",
        about: "Simulate a spec's conditions and write all signals and readings",
        groups: &[&SIMULATE],
        more: "",
    },
    Verb {
        name: "analyze",
        about: "How far off is each force signal, why, and what to choose: simulate, judge, report",
        groups: &[&ANALYZE],
        more: "",
    },
    Verb {
        name: "calibrate",
        about: "From inductance to length and force: fit a measured log, say how far to trust it, and set the theories beside it",
        groups: &[
            &recording::request::LAYOUT,
            &recording::request::CLEANING,
            &recording::request::WINDOW,
            &recording::request::SECOND,
            &calibration::request::OPTIONS,
            &[JSON, FIGURES, OVERWRITE_OUT, DATE],
        ],
        more: "",
    },
    Verb {
        name: "identify",
        about: "Is it the spring that rings, how stiff, heavy and damped is it, and up to where can its forces be trusted: ask a measured log",
        groups: &[
            &recording::request::LAYOUT,
            &recording::request::CLEANING,
            &recording::request::WINDOW,
            &recording::request::SECOND,
            &identification::request::OPTIONS,
            &[JSON, SPRING_RINGS, FIGURES, OVERWRITE, DATE],
        ],
        more: "",
    },
    Verb {
        name: "import",
        about: "Read a log, clean it up as allowed, write it in SI units on one rising clock, and account for every row",
        groups: &[
            &recording::request::LAYOUT,
            &recording::request::CLEANING,
            &recording::request::WINDOW,
            &recording::request::SECOND,
            &IMPORT,
        ],
        more: "",
    },
    Verb {
        name: "rig",
        about: "The paper's experiment on a virtual rig: write the files that a real one would, with every instrument's errors",
        groups: &[&RIG],
        more: "",
    },
    Verb {
        name: "mitigate",
        about: "What to do about ringing: every filter and observer on the spec's conditions, ranked, and settings to paste",
        groups: &[
            &[SPEC],
            &mitigation::request::BASIS,
            &mitigation::request::OPTIONS,
            &mitigation::request::OF_LOG,
            &mitigation::request::READING,
            &MITIGATE,
        ],
        more: "",
    },
    Verb {
        name: "export",
        about: "The spring as a part of your simulation: modes, stepped exactly, as a C header, a Rust constant or matrices",
        groups: &[&[MODELLED], &plant::request::OPTIONS, &[EXPORTED_OVER, JSON]],
        more: "",
    },
    Verb {
        name: "placement",
        about: "Which force to feed back, and how fast the loop may then be: limits, margins, rendered impedance",
        groups: &[&PLACEMENT],
        more: "",
    },
    Verb {
        name: "speed",
        about: "A spring under a cam from speed to speed: forces, surge, windings that meet, a follower that floats",
        groups: &[&[TURNED], &speed::request::OPTIONS, &SPEED],
        more: "",
    },
    Verb {
        name: "sweep",
        about: "Which of a million springs and sensors: vary a spec's values, judge every design, write rows as Parquet; a killed run is continued",
        groups: &[&[VARIED], &sweep::request::OPTIONS, &SWEEP],
        more: sweep::request::GRAMMAR,
    },
    Verb {
        name: "sensitivity",
        about: "What the columns of a sweep depend on: first-order and total sensitivity indices of its variables",
        groups: &[&SENSITIVITY],
        more: "",
    },
    Verb {
        name: "pareto",
        about: "The Pareto front of a sweep: designs that cannot be improved in one objective without a loss in another",
        groups: &[&PARETO],
        more: "",
    },
    Verb {
        name: "experiment",
        about: "Process an experiment: how load cell, position and inductance differ, what is biased, what drifts",
        groups: &[&[FOLDER], &recording::request::CLEANING, &EXPERIMENT],
        more: "",
    },
    Verb {
        name: "record",
        about: "A record of a real spring that rings, to be sent: say what is missing in a folder of logs, and pack it",
        groups: &[&RECORD],
        more: "",
    },
    Verb {
        name: "app",
        about: "The page: hit a spring in the browser and see its two ends disagree; needs a command built with the feature app",
        groups: &[&APP],
        more: "",
    },
    Verb {
        name: "reproduce",
        about: "Reproduce the tables and figures of \"Influence of Internal Oscillations on Force Sensing in Coil Springs\"",
        groups: &[&REPRODUCE],
        more: "",
    },
];

/// The folder of a report with figures.
const FIGURES: Row =
    out("Folder for report.html, results.json and figures; its other files are left alone", IfAbsent::Nothing);

/// A spring of the paper.
pub const FROM: Row = Row {
    name: "from",
    takes: Takes::Text("NAME"),
    if_absent: IfAbsent::Found("from an extension spring by geometry"),
    meaning: "Start from a spring of the paper, S_T or S_A, or from a compression spring: pressed",
    ..Row::PLAIN
};
/// The catalogue.
pub const SENSORS: Row = Row {
    name: "sensors",
    meaning: "List the sensor catalogue in place of a spec",
    conflicts: &["from", "out"],
    ..Row::PLAIN
};
const INIT: [Row; 5] = [
    FROM,
    Row {
        takes: Takes::File("FILE"),
        ..out(
            "Write to this file, which must not be there yet without --overwrite, in place of the terminal",
            IfAbsent::Nothing,
        )
    },
    OVERWRITE_OUT,
    SENSORS,
    JSON,
];

/// The material table.
pub const MATERIALS: Row = Row {
    name: "materials",
    meaning: "List the material table in place of a data sheet",
    conflicts: &["spec", "json"],
    ..Row::PLAIN
};
const SPRING: [Row; 3] = [
    Row {
        if_absent: IfAbsent::RefusedWithout("materials"),
        meaning: "The spec; its [spring] and [mount] make the sheet, its conditions say how many masses its chain needs",
        ..SPEC
    },
    JSON,
    MATERIALS,
];

/// All runs in one file.
pub const ONE_FILE: Row = Row {
    name: "one_file",
    meaning: "Put everything into one CSV, with the columns condition and damping in front where there are several",
    ..Row::PLAIN
};
const SIMULATE: [Row; 5] = [
    SPEC,
    Row {
        takes: Takes::File("FILE"),
        ..out(
            "File for time, u1, u2, F_i, F_o, F_x, F_L, L and what each sensor reads; its ending says the format: csv, json or parquet. Several conditions or dampings make one CSV each, named FILE-<condition>-<damping>.csv",
            IfAbsent::Refused,
        )
    },
    OVERWRITE,
    ONE_FILE,
    JSON,
];
const ANALYZE: [Row; 6] = [
    SPEC,
    out(
        "Folder for report.html, results.json and signals.parquet; its other files are left alone",
        IfAbsent::Value("out/analysis"),
    ),
    OVERWRITE,
    Row { meaning: "Print JSON, as it stands in results.json", ..JSON },
    Row {
        meaning: "Exit with code 3 where no sensor meets the goal, or that is not decided; all files are written",
        ..CHECK
    },
    DATE,
];
const SPRING_RINGS: Row = Row {
    meaning: "Exit with code 3 where it is not the spring that rings, or that stays undecided; all files are written",
    elsewhere: &[(Door::Python, "the result's `verdict`"), (Door::Page, "the verdict")],
    ..CHECK
};
/// The page of a log.
pub const REPORT: Row = Row {
    name: "report",
    takes: Takes::File("DIR"),
    conflicts: &["out", "with", "calibration"],
    meaning: "Folder for report.html: the course and the spectrogram of each channel, and what is in the log; its other files are left alone",
    elsewhere: &[(Door::Python, "`Signals.plot`"), (Door::Page, "the log's own page")],
    ..Row::PLAIN
};
const IMPORT: [Row; 7] = [
    calibration::request::CALIBRATION,
    Row { requires: &["calibration"], ..calibration::request::RE_ZERO },
    Row {
        takes: Takes::File("FILE"),
        ..out(
            "File for time and channels in SI units; its ending says the format: csv, json or parquet. Without it nothing is written, and what is in the log is shown: columns, ranges, rates, and what is to be told",
            IfAbsent::Nothing,
        )
    },
    OVERWRITE,
    REPORT,
    Row { requires: &["report"], ..DATE },
    JSON,
];

/// Of the rig's randomness.
pub const SEED: Row = Row {
    name: "seed",
    takes: Takes::Count,
    if_absent: IfAbsent::Found("that of [uncertainty]"),
    meaning: "Seed of noise, of each instrument's own errors and of hits",
    ..Row::PLAIN
};
const RIG: [Row; 5] = [
    Row {
        meaning: "The spec: its spring, one damping in [mount], and what differs from the paper's rig in [rig]",
        ..SPEC
    },
    Row {
        elsewhere: &[],
        ..out(
            "Folder for experiment.toml and two CSV files per run; its other files are left alone",
            IfAbsent::Value("out/rig"),
        )
    },
    Row { elsewhere: &[], ..OVERWRITE },
    SEED,
    JSON,
];
const MITIGATE: [Row; 5] = [
    out(
        "Folder for report.html, results.json, the trade-off as a figure, and settings as JSON, C header and Rust constant; its other files are left alone",
        IfAbsent::Nothing,
    ),
    OVERWRITE_OUT,
    DATE_OF_OUT,
    mitigation::request::PRECISION,
    JSON,
];
const PLACEMENT: [Row; 5] = [
    Row { meaning: "The spec; its table [control] describes the loop", ..SPEC },
    out("Folder for report.html and results.json; its other files are left alone", IfAbsent::Nothing),
    OVERWRITE_OUT,
    JSON,
    DATE_OF_OUT,
];
const TURNED: Row = Row {
    meaning: "The spec; its table [cam] says what moves end 1, [contact] what windings do when they meet",
    ..SPEC
};
const SPEED: [Row; 4] = [
    out(
        "Folder for report.html, results.json, speed.csv and speed.parquet; its other files are left alone. Until the map is whole, results are kept in DIR.points",
        IfAbsent::Nothing,
    ),
    OVERWRITE_OUT,
    JSON,
    DATE_OF_OUT,
];
const MODELLED: Row = Row {
    meaning: "The spec: its spring, what end 2 is tied to, one damping, and the mean length of its conditions",
    ..SPEC
};
const EXPORTED_OVER: Row = Row { elsewhere: &[(Door::Python, "Plant.save")], ..OVERWRITE };
/// Where the page is served.
pub const PORT: Row = Row {
    name: "port",
    takes: Takes::Count,
    allowed: Allowed::Within(0.0, 65535.0),
    if_absent: IfAbsent::Value("0"),
    meaning: "Port of 127.0.0.1 on which the page is; 0 is a free one",
    ..Row::PLAIN
};
/// Whether the browser stays as it is.
pub const NO_OPEN: Row = Row { name: "no_open", meaning: "Only say where the page is", ..Row::PLAIN };
const APP: [Row; 2] = [PORT, NO_OPEN];

/// How the paper is read.
pub const PROTOCOL: Row = Row {
    name: "protocol",
    takes: Takes::Word(&["text", "tables", "both"]),
    if_absent: IfAbsent::Value("both"),
    meaning: "How to read the paper: by its literal words, by what makes its printed tables come out, or both",
    ..Row::PLAIN
};
/// Other springs.
pub const SPRINGS: Row = Row {
    name: "springs",
    takes: Takes::File("DIR"),
    meaning: "Folder with S_T.toml and S_A.toml to use in place of the built-in springs of Table I",
    ..Row::PLAIN
};
const REPRODUCE: [Row; 5] = [
    out(
        "Folder for report.html, tables.json, figures/ and signals/; its other files are left alone",
        IfAbsent::Value("out/paper"),
    ),
    OVERWRITE,
    PROTOCOL,
    JSON,
    SPRINGS,
];
