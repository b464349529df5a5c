//! What to type: at the end of each verb's help.
//!
//! Next door: the options (`options`), the same at length in `book/src/guide`.

use std::fmt::Write as _;

use clap::builder::StyledStr;

/// What a line does, and the line.
type Example = (&'static str, &'static str);

/// Examples of each verb, the most common first.
pub const EXAMPLES: [(&str, &[Example]); 19] = [
    (
        "init",
        &[
            ("a commented spec to change", "coilsense init --out my.toml"),
            ("from a spring of the paper", "coilsense init --from S_T --out my.toml"),
        ],
    ),
    (
        "spring",
        &[
            ("rate, stress, lengths and surge frequencies of a spec's spring", "coilsense spring my.toml"),
            ("which materials a spec may name", "coilsense spring --materials"),
        ],
    ),
    (
        "simulate",
        &[
            ("every condition as CSV, one file for each damping", "coilsense simulate my.toml --out run.csv"),
            ("all of them in one file, for pandas or MATLAB", "coilsense simulate my.toml --out run.parquet"),
        ],
    ),
    (
        "analyze",
        &[
            ("which sensor meets the goal, with a report", "coilsense analyze my.toml --out out/my"),
            (
                "for a script: JSON, and exit code 3 where no sensor meets it",
                "coilsense analyze my.toml --out out/my --json --check",
            ),
        ],
    ),
    (
        "calibrate",
        &[(
            "inductance to length and force, from a slow measured log",
            "coilsense calibrate slow.csv --length-at-zero 138.2mm --out out/calibration",
        )],
    ),
    (
        "identify",
        &[
            ("is it the spring that rings, and how stiff, heavy and damped is it", "coilsense identify hit.csv"),
            (
                "held against the spring of a spec, with a report",
                "coilsense identify hit.csv --spec my.toml --out out/identified",
            ),
        ],
    ),
    (
        "import",
        &[
            ("what is in a log", "coilsense import run.tdms"),
            ("a part of it on one clock in SI units", "coilsense import run.csv --from 1s --to 20s --out part.parquet"),
        ],
    ),
    (
        "rig",
        &[("the logs that a real rig would write", "coilsense rig examples/virtual-rig.toml --out out/virtual-rig")],
    ),
    (
        "mitigate",
        &[
            (
                "filters and observers for a spec's conditions, ranked",
                "coilsense mitigate my.toml --out out/mitigation",
            ),
            ("on a measured log", "coilsense mitigate my.toml --log hit.csv --out out/mitigation"),
        ],
    ),
    (
        "export",
        &[
            ("a C header that is stepped exactly", "coilsense export my.toml --as c --out spring.h"),
            ("a part for Simulink, OpenModelica or FMPy", "coilsense export my.toml --as fmu --out spring.fmu"),
        ],
    ),
    (
        "placement",
        &[("which force to feed back, and how fast the loop may be", "coilsense placement my.toml --out out/loop")],
    ),
    (
        "speed",
        &[(
            "up to which speed a valve follows its cam",
            "coilsense speed valve.toml --from 1000rpm --to 8000rpm --step 100rpm --out out/valve",
        )],
    ),
    (
        "sweep",
        &[
            (
                "two thousand designs, as Parquet",
                "coilsense sweep my.toml --over spring.stiffness=600..900N/m --over spring.mass=50..80g --rows 2000 --out out/sweep",
            ),
            (
                "what a column depends on: see `coilsense sensitivity`",
                "coilsense sweep my.toml --over spring.stiffness=600..900N/m --sampling saltelli --rows 256 --out out/what",
            ),
        ],
    ),
    (
        "sensitivity",
        &[("which variables a sweep's columns depend on", "coilsense sensitivity out/what --out out/sensitivity")],
    ),
    (
        "pareto",
        &[(
            "the best designs of a sweep",
            "coilsense pareto out/sweep --minimize F_o.rmsd --maximize f1 --out out/front",
        )],
    ),
    (
        "experiment",
        &[("an experiment's logs as the paper has them", "coilsense experiment out/virtual-rig --out out/experiment")],
    ),
    (
        "record",
        &[
            ("a record.toml to fill in, beside your logs", "coilsense record my-spring --begin"),
            ("what is missing, and one file to send", "coilsense record my-spring --out my-spring.zip"),
        ],
    ),
    ("app", &[("the page on this machine", "coilsense app")]),
    (
        "reproduce",
        &[("the paper's tables and figures beside the printed numbers", "coilsense reproduce --out out/paper")],
    ),
];

/// The examples of a verb, as its help ends.
pub fn of(verb: &str) -> StyledStr {
    let mut text = String::from("\u{1b}[1m\u{1b}[4mExamples:\u{1b}[0m");
    let known = EXAMPLES.iter().find(|(name, _)| *name == verb);
    for (what, line) in known.into_iter().flat_map(|(_, examples)| examples.iter()) {
        // Writing to a String cannot fail.
        let _ = write!(text, "\n  {line}\n      {what}");
    }
    text.into()
}

#[cfg(test)]
mod tests {
    use coilsense_lab::report::verbs::VERBS;

    use super::EXAMPLES;

    #[test]
    fn every_verb_has_an_example_and_each_is_a_command() {
        assert_eq!(EXAMPLES.map(|(name, _)| name), VERBS.map(|verb| verb.name));
        for (verb, examples) in EXAMPLES {
            assert!(!examples.is_empty(), "{verb}");
            for (_, line) in examples {
                assert!(line.starts_with(&format!("coilsense {verb}")), "{line}");
                let read = crate::command().try_get_matches_from(line.split(' '));
                assert!(read.is_ok(), "{line}: {}", read.unwrap_err());
            }
            let help = crate::command().try_get_matches_from(["coilsense", verb, "-h"]).unwrap_err().to_string();
            let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(words(&help).contains(examples[0].1), "{help}");
        }
    }
}
