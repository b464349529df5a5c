//! `model = "helix"`: all modes of the coil in place of a chain, from a spec to its verdicts; and what it does not take.

use coilsense::Channel;
use coilsense::helix::Helix;
use coilsense_lab::analysis::{Analysis, answer, simulate};
use coilsense_lab::mitigation::{Request, Study};
use coilsense_lab::placement::Placement;
use coilsense_lab::request::Given;
use coilsense_lab::rig::Rig;
use coilsense_lab::spec::Spec;
use coilsense_lab::sweep::{Plan, PlanParameters};

use super::{HEEL_STRIKE, line, run, spec, verdict};

/// S_T with seats that hold its ends, or else with what `ends` says, by a model.
fn s_t(model: &str, ends: &str, more: &str) -> String {
    let spring = super::S_T.replace("model = \"chain\"", &format!("model = \"{model}\""));
    let spring = spring.replace("masses_per_winding = 1", "");
    assert!(spring.contains(&format!("model = \"{model}\"")), "{spring}");
    format!("{spring}\n[mount]\ndamping_ratio = 0.005\n{ends}\n[uncertainty]\ntrials = 1000\n{more}")
}

const HELD: &str = "ends_tilt = \"held\"";

/// 200 windings of thin wire that nearly touch, hardly stretched.
fn long_flat(model: &str) -> String {
    format!(
        "[spring]\nname = \"long\"\nmodel = \"{model}\"\nwire_diameter = \"0.4 mm\"\ncoil_diameter = \"20 mm\"\nwindings = 200\n\
         rest_length = \"84 mm\"\nmin_length = \"84.2 mm\"\nmax_length = \"86 mm\"\nend_type = \"hooks\"\n\
         [mount]\ndamping_ratio = 0.01\nends_tilt = \"held\"\n[uncertainty]\ntrials = 1000\n\
         [[condition]]\nkind = \"harmonic\"\nfrequency = \"1.2 Hz\"\namplitude = \"0.1 mm\"\nend = 1\nlength = \"85 mm\"\n\
         start = \"massless\"\nduration = \"2 s\"\nsample_rate = \"400 Hz\"\n"
    )
}

fn forces(analysis: &Analysis, case: usize, channel: Channel) -> &[f64] {
    analysis.cases[case].signals.channel(channel).unwrap()
}

fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt()
}

fn apart(one: &[f64], other: &[f64]) -> Vec<f64> {
    one.iter().zip(other).map(|(one, other)| one - other).collect()
}

#[test]
fn a_long_flat_spring_moves_as_its_chain_does() {
    let [helix, coil] = ["helix", "coil"].map(|model| run(&long_flat(model)));
    for channel in [Channel::InputForce, Channel::OutputForce] {
        let [one, other] = [&helix, &coil].map(|analysis| {
            let force = forces(analysis, 0, channel);
            apart(force, forces(analysis, 0, Channel::DeflectionForce))
        });
        // The chain has the first frequency of the helix by construction; of a flat spring the others follow, and couplings are (pitch/D)².
        assert!(rms(&apart(&one, &other)) < 2e-3 * rms(&other), "{} of {}", rms(&apart(&one, &other)), rms(&other));
    }
}

#[test]
fn a_hit_on_s_t_rings_in_torsion_which_the_coil_does_not_know() {
    let [helix, coil] = ["helix", "coil"].map(|model| run(&s_t(model, HELD, HEEL_STRIKE)));
    // As much force as the chain's, and beside it a couple that beats at 60.8 Hz (science: 1.13 % of the axial line).
    let of = |analysis: &Analysis| {
        rms(&apart(forces(analysis, 0, Channel::OutputForce), forces(analysis, 0, Channel::DeflectionForce)))
    };
    assert!((of(&helix) / of(&coil) - 1.0).abs() < 0.03, "{} {}", of(&helix), of(&coil));
    assert!(coil.cases[0].loads.is_none() && coil.as_chain.is_none());
    let loads = helix.cases[0].loads.as_ref().expect("a helix loads its ends");
    assert!(loads.iter().all(|loads| rms(&loads.couple) > 0.0 && rms(&loads.side_force) > 0.0));
    let run = helix.cases[0].series(&helix.spec, &helix.sensors);
    for name in ["side force 1", "couple 1", "side force 2", "couple 2"] {
        let column = run.columns.iter().find(|column| column.name == name).unwrap_or_else(|| panic!("no {name}"));
        assert_eq!(column.unit, if name.starts_with("side") { "N" } else { "N m" });
    }
    let said = answer(&helix).join("\n");
    assert!(said.contains("Every mode of the helix moves here. Beside it"), "{said}");
}

#[test]
fn the_valve_spring_answers_with_helix_and_coil_beside_each_other() {
    let text =
        include_str!("../../../../examples/valve-spring.toml").replace("[spring]\n", "[spring]\nmodel = \"helix\"\n");
    let cam = |_: &str| Ok(include_str!("../../../../examples/cam-6000rpm.csv").to_owned());
    let analysis = Analysis::run(Spec::parse("valve.toml", &text, &cam).unwrap(), &|_, _| true).unwrap();
    let cell = verdict(&analysis, "load cell under the spring");
    // Lines of 86 and 63 % of a bar's, and torsion between them: about as much as the chain's over the springs, a quarter less on the nominal one.
    let coil = analysis.as_chain.as_ref().unwrap()[cell.sensor];
    assert!((cell.combined() - 126.9).abs() < 1.0 && (coil - 129.2).abs() < 1.0, "{} {coil}", cell.combined());
    assert!(answer(&analysis).iter().any(|line| line.contains("load cell under the spring 129 N")));
}

#[test]
fn the_car_answers_with_helix_and_coil_beside_each_other() {
    let text =
        include_str!("../../../../examples/car-suspension.toml").replace("[spring]\n", "[spring]\nmodel = \"helix\"\n");
    let road = |_: &str| Ok(include_str!("../../../../examples/road-c-20mps.csv").to_owned());
    let analysis = Analysis::run(Spec::parse("car.toml", &text, &road).unwrap(), &|_, _| true).unwrap();
    let coil = analysis.as_chain.clone().unwrap();
    // A weaker line at the wheel, the same at the body; ride height by a straight line misses the bend of the static curve by either.
    for (name, helix, chain) in [
        ("load cell under the top mount", 12.13, 12.21),
        ("load cell in the lower seat", 41.2, 46.0),
        ("ride-height sensor", 101.9, 102.6),
    ] {
        let verdict = verdict(&analysis, name);
        let (own, beside) = (verdict.combined(), coil[verdict.sensor]);
        assert!((own / helix - 1.0).abs() < 0.01 && (beside / chain - 1.0).abs() < 0.01, "{name}: {own} {beside}");
    }
}

#[test]
fn initial_tension_is_in_the_static_force() {
    let text =
        include_str!("../../../../examples/own-geometry.toml").replace("[spring]\n", "[spring]\nmodel = \"helix\"\n");
    let text = text.replace("[mount]\n", "[mount]\nends_tilt = \"held\"\n");
    let still = text.split("[[condition]]").next().unwrap().to_owned() + super::STILL;
    let case = &simulate(&spec(&still), &|_, _| true).unwrap()[0];
    let force = case.signals.channel(Channel::OutputForce).unwrap()[0];
    // 40.46 N by the formula k (l − l0) + F_0; the helix unwinds by a little less.
    assert!((force / 40.458 - 1.0).abs() < 0.01, "{force}");
}

#[test]
fn ends_that_are_between_are_run_in_both_ways() {
    let analysis = run(&s_t("helix", "", HEEL_STRIKE));
    let labels: Vec<&str> = analysis.spec.mount.cases.iter().map(|case| case.label.as_str()).collect();
    assert_eq!(labels, ["ζ = 0.005 (ends held)", "ζ = 0.005 (ends free to tilt)"]);
    let stems: Vec<&str> = analysis.spec.mount.cases.iter().map(|case| case.stem.as_str()).collect();
    assert_eq!(stems, ["zeta-0.005-ends-held", "zeta-0.005-ends-free-to-tilt"]);
    assert_ne!(forces(&analysis, 0, Channel::OutputForce), forces(&analysis, 1, Channel::OutputForce));
    // The chain beside it knows nothing of tilting.
    let chain = analysis.as_chain.clone().unwrap();
    let coil = run(&s_t("coil", "", HEEL_STRIKE));
    for verdict in &coil.verdicts {
        assert_eq!(chain[verdict.sensor], verdict.combined());
    }
}

#[test]
fn the_static_force_is_the_helixs_and_a_straight_line_is_a_line_of_the_budget() {
    let sensors = "[[sensor]]\nname = \"laser\"\nkind = \"deflection\"\n[[sensor]]\nname = \"cell\"\nkind = \"load-cell\"\nend = 2\n";
    let slow = "[[condition]]\nkind = \"harmonic\"\nfrequency = \"0.05 Hz\"\namplitude = \"30 mm\"\nend = 1\nlength = \"230 mm\"\n\
                start = \"massless\"\nduration = \"20 s\"\nsample_rate = \"50 Hz\"\n";
    let analysis = run(&s_t("helix", HELD, &format!("{sensors}{slow}")));
    let case = &analysis.cases[0];
    let spring = &analysis.spec.spring;
    let rod = spring.rod().unwrap();
    let coil = spring.helix(&analysis.spec.mount.ends).unwrap();
    let [u1, u2, by_length] =
        [Channel::U1, Channel::U2, Channel::DeflectionForce].map(|of| case.signals.channel(of).unwrap());
    let at = |length: f64| Helix::new(&rod, length - coil.dead_length, coil.ways.0.turning()).unwrap();
    let (about, line_of) = (at(0.230), |length: f64| spring.spring.static_force(length));
    for index in (0..u1.len()).step_by(37) {
        let length = u2[index] - u1[index];
        // By values the curve touches the line at mid range; ends that are held add a slope of 0.04 %.
        let expected = line_of(0.230) + at(length).force() - about.force();
        assert!(
            (by_length[index] - expected).abs() < 5e-4 * 760.0 * 0.030,
            "{length}: {} {expected}",
            by_length[index]
        );
        let [input, output] =
            [Channel::InputForce, Channel::OutputForce].map(|of| case.signals.channel(of).unwrap()[index]);
        // Slow against 54 Hz: inertia of 65 g.
        assert!((input - by_length[index]).abs() < 1e-3 && (output - by_length[index]).abs() < 1e-3);
    }
    let bent: Vec<f64> = u1.iter().zip(u2).zip(by_length).map(|((u1, u2), force)| line_of(u2 - u1) - force).collect();
    let (laser, cell) = (verdict(&analysis, "laser"), verdict(&analysis, "cell"));
    let straight = line(laser, "the force as a straight line");
    let mean = bent.iter().sum::<f64>() / bent.len() as f64;
    let spread = rms(&bent.iter().map(|value| value - mean).collect::<Vec<_>>());
    assert!(spread > 1e-3 && (straight / spread - 1.0).abs() < 0.02, "{straight} {spread}");
    assert!(laser.combined() >= rms(&bent));
    assert_eq!(line(cell, "the force as a straight line"), 0.0);
    // A chain moves along a straight line, and the coil that it stands for does not.
    let chain = run(&s_t("coil", HELD, &format!("{sensors}{slow}")));
    let of_chain = line(verdict(&chain, "laser"), "the force as a straight line");
    // Ends that are held add a slope of 0.04 % to the helix that moves.
    assert!((of_chain - straight).abs() < 4e-4 * 760.0 * 0.021, "{of_chain} {straight}");
    assert!(of_chain > 0.01, "{of_chain}");
}

#[test]
fn a_load_cell_out_of_line_reads_a_part_of_the_side_force_and_the_truth_stays_axial() {
    let cell = "[[sensor]]\nname = \"cell\"\nkind = \"load-cell\"\nend = 2\n";
    let at = |angle: &str| {
        run(&s_t("helix", &format!("{HELD}\nmisalignment = \"{angle}\""), &format!("{cell}{HEEL_STRIKE}")))
    };
    let (straight, tilted) = (at("0 deg"), at("3 deg"));
    let force = |analysis: &Analysis| forces(analysis, 0, Channel::OutputForce).to_vec();
    assert_eq!(force(&straight), force(&tilted));
    let side = &tilted.cases[0].loads.as_ref().unwrap()[1].side_force;
    let (sine, cosine) = 3.0_f64.to_radians().sin_cos();
    for (index, reading) in tilted.cases[0].readings[0].steady.iter().enumerate() {
        let expected = cosine * force(&tilted)[index] + sine * side[index];
        assert!((reading - expected).abs() < 1e-9 * expected.abs(), "{index}: {reading} {expected}");
    }
    assert!(verdict(&tilted, "cell").combined() > verdict(&straight, "cell").combined());
}

#[test]
fn what_a_helix_does_not_take_is_refused_at_its_model() {
    let read = |text: &str| Spec::parse("t.toml", text, &|name| Err(format!("{name}: no files here")));
    let masses = s_t("helix", "", "").replace("model = \"helix\"", "model = \"helix\"\nmasses_per_winding = 2");
    assert!(read(&masses).unwrap_err().to_string().contains("it has no masses"));
    // One that has left its axis has no small motions about it.
    let car = "[spring]\nname = \"slender\"\nmodel = \"helix\"\nwire_diameter = \"2 mm\"\ncoil_diameter = \"20 mm\"\nwindings = 30\n\
               rest_length = \"250 mm\"\nmin_length = \"90 mm\"\nmax_length = \"240 mm\"\nend_type = \"closed-ground\"\n[mount]\n\
               damping_ratio = 0.01\n[[condition]]\nname = \"pressed\"\nkind = \"impact\"\nvelocity = \"0.1 m/s\"\nlength = \"100 mm\"\n";
    let refused = simulate(&read(car).unwrap(), &|_, _| true).unwrap_err().to_string();
    assert!(refused.starts_with("t.toml: pressed, ζ = 0.01: ") && refused.contains("buckled"), "{refused}");
}

#[test]
fn commands_that_run_a_chain_refuse_a_helix_and_say_what_takes_it() {
    let text = s_t("helix", HELD, &format!("{HEEL_STRIKE}[[sensor]]\nname = \"cell\"\nkind = \"load-cell\"\n"));
    let helix = spec(&text);
    let each = [
        Study::of(&helix, &Request::of(&Given::default()).unwrap()).map(|_| ()).unwrap_err().to_string(),
        Placement::of(helix.clone()).map(|_| ()).unwrap_err().to_string(),
        Rig::new(&helix, 1).map(|_| ()).unwrap_err().to_string(),
    ];
    for refused in each {
        assert!(refused.contains("\"helix\" is for simulate, analyze and spring"), "{refused}");
    }
    let plan = |columns: &[&str]| {
        Plan::new(PlanParameters {
            over: vec!["spring.stiffness=700..800 N/m".to_owned()],
            columns: columns.iter().map(|column| (*column).to_owned()).collect(),
            rows: Some(4),
            spec_file: "t.toml".to_owned(),
            spec: text.clone(),
            ..serde_json::from_str(r#"{"spec_file": "", "spec": ""}"#).unwrap()
        })
    };
    let refused = plan(&["F_o.rmsd"]).map(|_| ()).unwrap_err().to_string();
    assert!(refused.contains("a sweep of forces takes \"coil\""), "{refused}");
    // Frequencies move nothing.
    assert!(plan(&["f1"]).is_ok());
}
