//! Several springs from design to design: a key of one of them is varied, by its name, and forces are those of all.

use coilsense::{Channel, Deviation};
use coilsense_lab::analysis::Together;
use coilsense_lab::spec::Spec;
use coilsense_lab::sweep::{Plan, SweepError};

use super::{QUICK, numbers, of, texts, whole};

/// The spring of the other sweeps, a second one beside it of fewer windings, and no sensor.
fn nested() -> String {
    let (outer, rest) = QUICK.trim_start().split_once("\n\n").unwrap();
    let outer = outer.replace("[spring]", "[[spring]]");
    let inner = outer
        .replace("S_T", "in.ner 2")
        .replace("760 N/m", "300 N/m")
        .replace("65 g", "20 g")
        .replace("windings = 12", "windings = 9");
    let (before, after) = rest.split_once("[[sensor]]").unwrap();
    let goal = &after[after.find("[goal]").unwrap()..];
    format!("{outer}\n\n{inner}\n\n{before}{goal}")
}

fn plan(over: &str, columns: &[&str]) -> Result<Plan, SweepError> {
    Plan::new(of(&nested(), &[over], columns))
}

#[test]
fn a_key_of_one_spring_is_varied_and_a_row_is_what_simulate_says() {
    for key in ["spring.\"in.ner 2\".stiffness", "spring.in.ner 2.stiffness", "spring.2.stiffness"] {
        let plan = plan(&format!("{key}=300, 450 N/m"), &[]).unwrap();
        let chunk = &whole(&plan)[0];
        assert_eq!(texts(chunk, "status"), ["ok", "ok"]);
        let found = numbers(chunk, "F_o.rmsd [%]");
        for (row, stiffness) in ["300 N/m", "450 N/m"].into_iter().enumerate() {
            let text = nested().replace("300 N/m", stiffness);
            let spec = Spec::parse("spec.toml", &text, &|name| Err(name.to_owned())).unwrap();
            let both = Together::of(&spec, &|_, _| true).unwrap();
            let rmsd = both.all.iter().zip(&both.springs[0].cases).map(|(all, case)| {
                let [force, truth] = [Channel::OutputForce, Channel::DeflectionForce]
                    .map(|force| &all.channel(force).unwrap()[case.judged.clone()]);
                Deviation::between(force, truth).unwrap().rmsd
            });
            // F_nom of all: the longest length, 160 mm above rest.
            let nominal = (760.0 + 0.1 * stiffness.replace(" N/m", "0").parse::<f64>().unwrap()) * 0.16;
            let expected = 100.0 * rmsd.fold(0.0, f64::max) / nominal;
            assert!((found[row] / expected - 1.0).abs() < 1e-9, "{} {expected}", found[row]);
        }
        assert!((found[0] / found[1] - 1.0).abs() > 1e-3, "{found:?}");
        // Forces only: numbers of a spring would be those of one.
        assert!(!plan.titles().iter().any(|title| title.starts_with("mass")), "{:?}", plan.titles());
        // The row's own spec has the value in the second table.
        let written = plan.spec_of(1).unwrap();
        assert!(written.ends_with(&nested().replace("300 N/m", "450 N/m")), "{written}");
    }
}

#[test]
fn what_is_not_said_of_one_spring_is_asked_for() {
    let refused = |over: &str, columns: &[&str]| plan(over, columns).unwrap_err().to_string();
    let which = refused("spring.stiffness=1, 2 N/m", &[]);
    assert_eq!(which, "spring.stiffness: say which: spring.\"S_T\".stiffness, or by its number: spring.1.stiffness");
    let none = refused("spring.outer.stiffness=1, 2 N/m", &[]);
    assert!(none.contains("no spring \"outer\" is there; there are: 1 \"S_T\", 2 \"in.ner 2\""), "{none}");
    let none = refused("spring.3.stiffness=1, 2 N/m", &[]);
    assert!(none.contains("there are: 1 \"S_T\""), "{none}");
    let key = refused("spring.1.stifness=1, 2 N/m", &[]);
    assert!(key.contains("no key of a spec; did you mean spring.stiffness?"), "{key}");
    for column in ["mass", "clearance", "F_L.rmsd", "F_L.method"] {
        let line = refused("spring.2.stiffness=300, 450 N/m", &[column]);
        let told = format!(
            "column {column}: is of one spring, and the spec has several; allowed: F_i, F_o and F_x of all, worst"
        );
        assert_eq!(line, told);
    }
}

#[test]
fn a_second_spring_that_cannot_be_is_a_row_that_says_so() {
    let plan = plan("spring.2.min_length=196, 200 mm", &["F_o.rmsd"]).unwrap();
    let chunk = &whole(&plan)[0];
    assert_eq!(texts(chunk, "status"), ["ok", "refused"]);
    assert!(texts(chunk, "reason")[1].contains("its own range in use must hold that"), "{:?}", texts(chunk, "reason"));
}

#[test]
fn windings_of_a_spring_beside_the_first_that_touch_are_told_under_its_name() {
    let fast = nested().replace("0.25 m/s", "9 m/s").replace("0.76 s", "0.752 s");
    let plan = Plan::new(of(&fast, &["spring.2.windings=9, 45"], &["F_o.rmsd"])).unwrap();
    let chunk = &whole(&plan)[0];
    assert_eq!(texts(chunk, "status"), ["ok", "clash"], "{:?}", texts(chunk, "reason"));
    assert!(
        texts(chunk, "reason")[1].contains("windings of in.ner 2 touch in heel strike at "),
        "{:?}",
        texts(chunk, "reason")
    );
}
