//! Answers that hold for real springs: over tolerances, over the model's doubt, with masses enough.
//!
//! Numbers of `tests/golden/specimens.csv` come from a Monte Carlo in Python that shares no code with this one; three hundred random specs
//! are compared by `reference/specimens.py`.

use coilsense_lab::analysis::{Analysis, Check, Subject, answer};
use coilsense_lab::spec::Spec;

use super::{HEEL_STRIKE, S_T, STILL, close, line, run, undamped, verdict};

const GOLDEN: &str = include_str!("../golden/specimens.csv");

/// S_T under a sine near its first surge, and a load cell at its far end.
fn driven(frequency: f64, spring: &str) -> Analysis {
    let condition = format!(
        "[mount]\ndamping_ratio = 0.005\n[uncertainty]\ntrials = 1000\n\
         [[condition]]\nname = \"sine\"\nkind = \"harmonic\"\nfrequency = \"{frequency} f1\"\namplitude = \"0.5 %\"\nstart = \"massless\"\n\
         duration = \"4 s\"\nwindow = [\"3 s\", \"4 s\"]\n"
    );
    let cell =
        "[[sensor]]\nkind = \"load-cell\"\nname = \"cell\"\naccuracy_full_scale = \"0.1 %\"\n[goal]\nerror = \"5 %\"\n";
    run(&format!("{S_T}{spring}\n{condition}{cell}"))
}

#[test]
fn a_load_cell_near_resonance_is_judged_over_the_springs_that_the_tolerance_allows() {
    for row in GOLDEN.lines().skip(2) {
        let values: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        let [frequency, tolerance, rms, share, worst, nominal] = values[..] else { panic!("{row}") };
        let analysis = driven(frequency, &format!("stiffness_tolerance = \"{} %\"\n", 100.0 * tolerance));
        let found = verdict(&analysis, "cell");
        let assessment = found.at_worst();
        // Standard error of the reference 0.5 %, and as much for what is drawn out between samples.
        close(found.combined(), rms, 0.015);
        close(assessment.oscillation, nominal, 1e-4);
        assert!((assessment.inside.unwrap() - share).abs() < 0.02, "{row}: {assessment:?}");
        // The largest of finitely many.
        close(assessment.worst, worst, 0.08);
        assert_eq!(found.meets_always(), Some(rms < 6.08), "{row}");
    }
}

#[test]
fn a_line_inside_the_band_of_a_mode_is_in_the_headline_and_one_outside_is_not() {
    let warns = |analysis: &Analysis| analysis.warnings.iter().any(|warning| warning.subject == Subject::Resonance);
    let near = driven(0.97, "stiffness_tolerance = \"10 %\"\n");
    assert!(warns(&near));
    let words = answer(&near).join("\n");
    assert!(words.contains("a natural frequency of the real spring may coincide with the input's"), "{words}");
    // The second mode counts as well; half of the first frequency is far from any.
    assert!(warns(&driven(1.97, "stiffness_tolerance = \"10 %\"\n")));
    assert!(!warns(&driven(0.5, "stiffness_tolerance = \"10 %\"\n")));
    // Without any tolerance the chain itself is in doubt, by half a percent of S_T.
    assert!(warns(&driven(0.998, "stiffness_tolerance = \"0 %\"\n")));
    assert!(!warns(&driven(0.98, "stiffness_tolerance = \"0 %\"\n")));
}

#[test]
fn the_chain_has_a_line_of_its_own_where_its_doubt_counts() {
    let near = driven(0.98, "stiffness_tolerance = \"0 %\"\n");
    assert!(line(verdict(&near, "cell"), "the coil as a chain") > 0.5);
    let far = driven(0.5, "stiffness_tolerance = \"0 %\"\n");
    assert!(line(verdict(&far, "cell"), "the coil as a chain") < 0.01);
}

#[test]
fn damping_is_never_averaged() {
    // The verdict is that of the worst ζ of the list.
    let of = |ratios: &str| {
        let text = format!(
            "{S_T}\n[mount]\ndamping_ratio = {ratios}\n{HEEL_STRIKE}[[sensor]]\nkind = \"load-cell\"\nname = \"cell\"\n"
        );
        verdict(&run(&text), "cell").combined()
    };
    close(of("[0.001, 0.02]"), of("0.001"), 1e-12);
}

#[test]
fn a_rate_without_a_tolerance_is_said_to_be_taken_as_exact_and_what_five_percent_make_of_it() {
    // 4.5 × 28 × 90 mm, landing at 0.4 m/s: a bought spring, whose rate somebody measured in use.
    let spring = |tolerance: &str| {
        format!(
            "[spring]\nname = \"bought\"\nstiffness_at = \"range\"\nrest_length = \"90 mm\"\nmin_length = \"50 mm\"\nmax_length = \"80 mm\"\nwindings = 8\n\
             wire_diameter = \"4.5 mm\"\ncoil_diameter = \"28 mm\"\nend_type = \"closed-ground\"\n{tolerance}\n[mount]\ndamping_ratio = 0.005\n\
             [uncertainty]\ntrials = 1000\n[[condition]]\nname = \"landing\"\nkind = \"impact\"\nvelocity = \"-0.4 m/s\"\n\
             window = [\"0.2 s\", \"1 s\"]\n[[sensor]]\nkind = \"deflection\"\nname = \"encoders\"\naccuracy_full_scale = \"0.1 %\"\n\
             [[sensor]]\nkind = \"load-cell\"\nname = \"load cell\"\naccuracy_full_scale = \"0.5 %\"\n[goal]\nerror = \"1 %\"\n"
        )
    };
    let silent = run(&spring(""));
    let usual = silent.if_usual.as_ref().expect("the spec is silent");
    assert_eq!(silent.sensors[silent.verdicts[0].sensor].name, "encoders");
    assert_eq!(silent.sensors[usual.order[0]].name, "load cell");
    let words = answer(&silent).join("\n");
    assert!(words.contains("rate is taken as exact") && words.contains("the order is another"), "{words}");
    // The same answer with the tolerance written down.
    let told = run(&spring("stiffness_tolerance = \"5 %\""));
    for (sensor, combined) in usual.combined.iter().enumerate() {
        close(*combined, verdict(&told, &told.sensors[sensor].name.clone()).combined(), 5e-3);
    }
    assert!(told.if_usual.is_none());
    // Zero is a tolerance, too, and so is one of the wire.
    for given in ["stiffness_tolerance = \"0 %\"", "wire_diameter_tolerance = \"0.5 %\""] {
        let told = run(&spring(given));
        assert!(told.if_usual.is_none() && !answer(&told).join("\n").contains("taken as exact"), "{given}");
    }
}

#[test]
fn a_goal_with_a_bandwidth_names_its_filter_counts_its_lag_and_shows_what_it_hides() {
    // What `coilsense init` writes: the load cell is 11 N off at every frequency, and 0.07 N below 20 Hz.
    let text = coilsense_lab::spec::template(Some("S_T")).unwrap();
    let analysis = run(&format!("{text}[uncertainty]\ntrials = 1000\n"));
    let found = verdict(&analysis, "load cell, load side");
    let filter = found.filter.expect("it needs one");
    assert_eq!((filter.order, filter.bandwidth), (8, 20.0));
    assert!(filter.raw > 10.0, "{filter:?}");
    // Σ 2 sin((2k−1)π/16)/ω_c: 41 ms.
    assert!((filter.lag - 0.0408).abs() < 1e-4, "{filter:?}");
    assert!(found.lag > filter.lag);
    let words = answer(&analysis).join("\n");
    assert!(words.contains("low-pass of order 8 at 20 Hz") && words.contains("without it"), "{words}");
    // A sensor that meets the goal at every frequency needs none.
    assert!(verdict(&analysis, "laser").filter.is_none());
}

#[test]
fn the_tolerance_of_the_rate_does_not_act_on_the_initial_tension() {
    let spring = |more: &str| {
        format!(
            "[spring]\nname = \"tensed\"\nrest_length = \"60 mm\"\nmin_length = \"80 mm\"\nmax_length = \"130 mm\"\nwindings = 40\n\
             stiffness = \"750 N/m\"\nmass = \"21 g\"\ncoil_radius = \"6 mm\"\nwire_radius = \"0.75 mm\"\ninitial_tension = \"8 N\"\n\
             stiffness_tolerance = \"4 %\"\n{more}\n[mount]\ndamping_ratio = 0.01\n"
        )
    };
    let still = STILL.replace("kind = \"impact\"", "kind = \"impact\"\nlength = \"85 mm\"");
    let laser = "[[sensor]]\nkind = \"deflection\"\nname = \"laser\"\n[uncertainty]\ntemperature_change = \"0 K\"\ntrials = 1000\n";
    let of = |more: &str| run(&format!("{}{still}{laser}", spring(more)));
    let silent = of("");
    // 4 %/√3 of k (l − l_closed), not of the whole force.
    close(line(verdict(&silent, "laser"), "tolerance of the stiffness"), 0.04 / 3.0_f64.sqrt() * 750.0 * 0.025, 1e-6);
    assert_eq!(line(verdict(&silent, "laser"), "tolerance of the initial tension"), 0.0);
    let told = of("initial_tension_tolerance = \"10 %\"");
    close(line(verdict(&told, "laser"), "tolerance of the initial tension"), 0.8 / 3.0_f64.sqrt(), 1e-6);
    // Without a tension there is nothing to tolerate.
    let none = run(&format!(
        "{}{still}{laser}",
        spring("").replace("\"8 N\"", "\"0 N\"\ninitial_tension_tolerance = \"10 %\"")
    ));
    assert_eq!(line(verdict(&none, "laser"), "tolerance of the initial tension"), 0.0);
}

const VALVE: &str = include_str!("../../../../examples/valve-spring.toml");
const CAM: &str = include_str!("../../../../examples/cam-6000rpm.csv");

fn valve(masses: &str) -> Analysis {
    let text = VALVE.replace("windings = 5.75\n", &format!("model = \"chain\"\nwindings = 5.75\n{masses}"));
    let spec = Spec::parse("valve.toml", &text, &|_| Ok(CAM.to_owned())).unwrap();
    Analysis::run(spec, &|_, _| true).unwrap()
}

#[test]
fn a_length_that_the_coils_frequency_does_not_move_has_no_line_about_it() {
    // What two sums over the same springs differ by in their last digits, 2e-11 N, stood in the budget of the lift probe.
    let state = [
        (
            "\nstiffness_tolerance = \"2 %\"",
            "\nstiffness_tolerance = \"1.36 %\"\nrest_length_tolerance = \"0.0615 mm\"",
        ),
        ("damping_ratio = [0.002, 0.01]", "damping_ratio = 0.00109"),
        ("error = \"2 %\"", "error = \"0.379 %\"\nbandwidth = \"8.79 Hz\""),
        ("force = \"F_i\"", "force = \"F_x\""),
    ];
    let text = state.into_iter().fold(VALVE.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    let analysis =
        Analysis::run(Spec::parse("valve.toml", &text, &|_| Ok(CAM.to_owned())).unwrap(), &|_, _| true).unwrap();
    let names = |sensor: &str| {
        let lines = verdict(&analysis, sensor).budget.budget.contributions().iter();
        lines.map(|line| line.name.clone()).collect::<Vec<_>>()
    };
    assert!(!names("lift probe").contains(&"the coil as a chain".into()), "{:?}", names("lift probe"));
    assert!(names("load cell under the spring").contains(&"the coil as a chain".into()));
}

#[test]
fn masses_are_doubled_until_no_rms_moves_and_the_valve_says_that_it_cannot_be_told() {
    let analysis = valve("");
    assert!(analysis.masses.per_winding >= 8 && analysis.masses.are_enough(), "{:?}", analysis.masses);
    let twice = valve(&format!("masses_per_winding = {}\n", 2 * analysis.masses.per_winding));
    for (ours, theirs) in analysis.cases.iter().zip(&twice.cases) {
        for ((force, ours), (_, theirs)) in ours.ideal.iter().zip(&theirs.ideal) {
            let least = 1e-4 * analysis.spec.spring.spring.nominal_force();
            let moved = (ours.rmsd - theirs.rmsd).abs();
            assert!(moved <= 0.005 * theirs.rmsd.max(least), "{force:?}: {} {}", ours.rmsd, theirs.rmsd);
        }
    }
    for (ours, theirs) in analysis.verdicts.iter().zip(&twice.verdicts) {
        close(ours.combined(), theirs.combined(), 0.005);
    }
    // Linear, ζ = 0.002, rms(F_o − F_i): 184.6 N at 16 masses for a winding, 183.4 N for very many (an independent integrator).
    let running = analysis.case(1, 0).unwrap();
    let [_, (_, output), ..] = running.ideal[..] else { panic!("no forces") };
    close(output.rmsd, 183.4, 0.01);
    assert!(analysis.cases.iter().all(|case| !case.clash.happens()), "the coil never clashes at ζ = 0.002");
    // With a goal that all meet a script is told so, too: what is chosen hangs on what nobody measured.
    let easy = VALVE.replace("error = \"2 %\"", "error = \"90 %\"").replace("force = \"F_i\"", "force = \"F_x\"");
    let only = &easy[..easy.find("[[sensor]]\nname = \"lift probe\"").unwrap()];
    let goal = &easy[easy.find("[goal]").unwrap()..];
    let text = format!("{only}{goal}").replace("windings = 5.75\n", "model = \"chain\"\nwindings = 5.75\n");
    let one = Analysis::run(Spec::parse("valve.toml", &text, &|_| Ok(CAM.to_owned())).unwrap(), &|_, _| true).unwrap();
    assert_eq!(one.verdicts[0].meets_always(), Some(true), "{:?}", answer(&one));
    assert!(matches!(Check::of(&one), Check::Undecided(why) if why.contains("first surge frequency")));
    let words = answer(&analysis).join("\n");
    for part in ["cannot be told more closely", "load cell under the spring", "Measure it", "coilsense identify"] {
        assert!(words.contains(part), "{part}: {words}");
    }
    // The paper's chain, where it is asked for.
    let coarse = valve("masses_per_winding = 1\n");
    close(coarse.case(1, 0).unwrap().ideal[1].1.rmsd, 695.0, 1e-4);
}

#[test]
fn f1_as_a_unit_stays_that_of_the_continuous_coil_whatever_the_masses() {
    let driven_at = |masses: usize| {
        let text = S_T.replace("masses_per_winding = 1", &format!("masses_per_winding = {masses}"));
        let analysis = undamped(
            &text,
            "[[condition]]\nkind = \"harmonic\"\nfrequency = \"0.5 f1\"\namplitude = \"1 %\"\nduration = \"0.1 s\"\n",
        );
        let rows: Vec<f64> = analysis
            .data_sheet
            .groups
            .iter()
            .flat_map(|(_, rows)| rows)
            .filter(|row| row.key == "model_frequency_hz")
            .filter_map(|row| row.value)
            .collect();
        (format!("{:?}", analysis.spec.conditions[0].excitation), rows[0])
    };
    let ((one, chain), (four, finer)) = (driven_at(1), driven_at(4));
    assert_eq!(one, four);
    assert!((chain - 54.0573).abs() < 1e-4 && (finer - 54.0643).abs() < 1e-3, "{chain} {finer}");
}

#[test]
fn a_step_says_that_its_rms_has_no_limit() {
    let step = "[[condition]]\nname = \"jump\"\nkind = \"step\"\namplitude = \"1 mm\"\nbegin = \"10 ms\"\nduration = \"0.1 s\"\n";
    let has = |text: &str| undamped(S_T, text).warnings.iter().any(|warning| warning.subject == Subject::NoLimit);
    assert!(has(step));
    assert!(!has(&step.replace("kind = \"step\"", "kind = \"ramp\"\nrise_time = \"10 ms\"")));
}

#[test]
fn tolerances_of_wire_and_coil_move_stiffness_and_mass_together() {
    let spring = |tolerances: &str| {
        format!(
            "[spring]\nname = \"wound\"\nrest_length = \"61 mm\"\nmin_length = \"80 mm\"\nmax_length = \"130 mm\"\nwindings = 40\n\
             wire_diameter = \"1.5 mm\"\ncoil_diameter = \"12 mm\"\n{tolerances}\n[mount]\ndamping_ratio = 0.01\n{STILL}"
        )
    };
    let of = |tolerances: &str| run(&spring(tolerances)).spec.spring.tolerances;
    let wire = of("wire_diameter_tolerance = \"1 %\"");
    let mut units = [0.0; 9];
    units[2] = 1.0;
    let thick = wire.at(&units);
    close(thick.stiffness, 1.01_f64.powi(4), 1e-12);
    close(thick.mass, 1.01_f64.powi(2), 1e-12);
    // A rate that was measured is known whatever the wire; the mass is not.
    let measured = of("wire_diameter_tolerance = \"1 %\"\nstiffness_tolerance = \"0.5 %\"");
    let thick = measured.at(&units);
    assert_eq!(thick.stiffness, 1.0);
    close(thick.mass, 1.01_f64.powi(2), 1e-12);
}
