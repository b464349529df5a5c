//! Coils of sections from design to design: a key of one section is varied, what only a uniform coil has is left empty.

use coilsense_lab::analysis::Analysis;
use coilsense_lab::spec::Spec;
use coilsense_lab::sweep::Plan;

use super::{example, numbers, of, texts, whole};

#[test]
fn a_key_of_a_section_is_varied_and_a_row_is_what_analyze_says() {
    let columns = [
        "stiffness",
        "stress",
        "rest_length",
        "buckling",
        "f_lateral",
        "wave_impedance",
        "F_o.rmsd",
        "lift probe.combined",
    ];
    let text = example("progressive-spring.toml");
    let plan = Plan::new(of(&text, &["spring.section.3.windings=4, 5"], &columns)).unwrap();
    let chunk = &whole(&plan)[0];
    assert_eq!(texts(chunk, "status"), ["ok", "ok"]);
    // k = G d⁴/(8 D³ n) of 6.5 and 7.5 windings between the closed ones.
    let stiffness = numbers(chunk, "stiffness [N/m]");
    assert!((stiffness[0] / stiffness[1] / (7.5 / 6.5) - 1.0).abs() < 1e-12, "{stiffness:?}");
    // A winding of 8 mm more.
    let rest = numbers(chunk, "rest_length [m]");
    assert!((rest[1] - rest[0] - 8e-3).abs() < 1e-12, "{rest:?}");
    for title in ["buckling [1]", "f_lateral [Hz]", "wave_impedance [N s/m]"] {
        assert!(numbers(chunk, title).iter().all(|value| value.is_nan()), "{title}: of a uniform coil only");
    }
    for (row, windings) in ["4", "5"].into_iter().enumerate() {
        // The third table with windings: those before it are 1 and 1.5.
        let spec = text.replacen("\nwindings = 4\n", &format!("\nwindings = {windings}\n"), 1);
        let spec = Spec::parse("spec.toml", &spec, &|name| Err(name.to_owned())).unwrap();
        let analysis = Analysis::run(spec, &|_, _| true).unwrap();
        let nominal = analysis.spec.spring.spring.nominal_force();
        let rmsd = analysis.cases.iter().map(|case| case.ideal[1].1.rmsd).fold(0.0, f64::max);
        let found = numbers(chunk, "F_o.rmsd [%]")[row];
        assert!((found - 100.0 * rmsd / nominal).abs() < 1e-10, "{found} {rmsd}");
        let probe = numbers(chunk, "lift probe.combined [%]")[row];
        // The second sensor of the spec; verdicts come best first.
        let verdict = analysis.verdicts.iter().find(|verdict| verdict.sensor == 1).unwrap();
        assert!((probe - 100.0 * verdict.combined() / nominal).abs() < 1e-10, "{probe}");
        let stress = analysis.spec.spring.corrected_shear_stress(nominal);
        assert_eq!(numbers(chunk, "stress [Pa]")[row], stress);
    }
    // The row's own spec has the value where it stood, and its comments.
    let written = plan.spec_of(1).unwrap();
    assert_eq!(written.matches("# rises from it").count(), 1);
    let read = Spec::parse("spec.toml", &written, &|name| Err(name.to_owned())).unwrap();
    assert_eq!(read.spring.spring.windings(), 7.5);
}

#[test]
fn a_design_that_cannot_be_wound_is_a_row_that_says_so() {
    let plan = Plan::new(of(&example("progressive-spring.toml"), &["spring.section.3.pitch=3, 8 mm"], &["stiffness"]))
        .unwrap();
    let chunk = &whole(&plan)[0];
    assert_eq!(texts(chunk, "status"), ["refused", "ok"]);
    assert!(texts(chunk, "reason")[0].contains("pitch"), "{:?}", texts(chunk, "reason"));
}

#[test]
fn a_section_that_is_not_there_is_refused_with_those_that_are() {
    let text = example("progressive-spring.toml");
    let refused = |over: &str| Plan::new(of(&text, &[over], &["stiffness"])).unwrap_err().to_string();
    let line = refused("spring.section.9.windings=1, 2");
    assert!(line.contains("no spring.section \"9\" is there; there are: 1, 2, 3, 4, 5"), "{line}");
    let line = refused("spring.section.windings=1, 2");
    assert!(line.contains("say which: spring.section.1.windings"), "{line}");
    let line = refused("spring.section.1.windngs=1, 2");
    assert!(line.contains("no key of [[spring.section]]; allowed: windings, pitch, gap"), "{line}");
    let line = refused("spring.winding.1.windings=1, 2");
    assert!(line.contains("there is one table [spring]"), "{line}");
}
