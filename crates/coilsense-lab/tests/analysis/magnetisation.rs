//! Wire that the spec says is magnetic: L of its windings as they move, and what is not told of it.

use coilsense::Channel;
use coilsense::inductance::{SelfDistance, SteelWindings};
use coilsense_lab::analysis::{Analysis, Subject};
use coilsense_lab::data_sheet::DataSheet;
use coilsense_lab::spec::SpringInductance;
use coilsense_lab::study::{self, Coil, Method, Setup};

use super::{HEEL_STRIKE, S_T, STILL, UNDAMPED, run, spec};

const BY_INDUCTANCE: &str = "[[sensor]]\nkind = \"inductance\"\ncalibration_form = \"0 %\"\n";

fn of_wire(relative_permeability: &str, more: &str) -> Analysis {
    let spring = S_T.replacen("[spring]", &format!("[spring]\n{relative_permeability}"), 1);
    run(&format!("{spring}\n{UNDAMPED}{BY_INDUCTANCE}{more}"))
}

fn magnetic(analysis: &Analysis) -> Vec<&str> {
    let of = analysis.warnings.iter().filter(|warning| warning.subject == Subject::Magnetisation);
    of.map(|warning| warning.text.as_str()).collect()
}

fn line(analysis: &Analysis, name: &str) -> Option<f64> {
    let lines = analysis.verdicts[0].budget.budget.contributions();
    lines.iter().find(|line| line.name == name).map(|line| line.contribution)
}

/// Mean error of F_L over the judged samples, as a share of F_nom.
fn bias(analysis: &Analysis) -> f64 {
    let case = &analysis.cases[0];
    let [by_coil, truth] = [Channel::InductanceForce, Channel::DeflectionForce]
        .map(|of| &case.signals.channel(of).unwrap()[case.judged.clone()]);
    let errors = by_coil.iter().zip(truth).map(|(force, truth)| force - truth);
    errors.sum::<f64>() / truth.len() as f64 / analysis.spec.spring.spring.nominal_force()
}

#[test]
fn magnetic_windings_err_a_little_more_and_their_doubt_is_in_the_budget() {
    let [air, steel] = ["", "relative_permeability = 2.5"].map(|wire| of_wire(wire, HEEL_STRIKE));
    let more = steel.cases[0].signals.channel(Channel::Inductance).unwrap()[0]
        / air.cases[0].signals.channel(Channel::Inductance).unwrap()[0];
    assert!((1.05..1.2).contains(&more), "{more}");
    // As the bias of its first mode does: -0.1047 % in air, -0.1090 % at 2.5.
    let worse = bias(&steel) / bias(&air);
    assert!((1.02..1.07).contains(&worse), "{} and {}", bias(&air), bias(&steel));
    let doubt = line(&steel, "magnetisation of uneven windings").unwrap() / steel.spec.spring.spring.nominal_force();
    assert!((1e-8..2e-4).contains(&doubt), "{doubt}");
    assert_eq!(line(&air, "magnetisation of uneven windings"), None);
    assert!(magnetic(&steel).is_empty() && magnetic(&air).is_empty());
}

#[test]
fn wire_that_is_told_not_to_be_magnetic_is_air() {
    let [untold, one] = ["", "relative_permeability = 1"].map(|wire| of_wire(wire, STILL));
    let of = |analysis: &Analysis| analysis.cases[0].signals.channel(Channel::Inductance).unwrap().to_vec();
    assert_eq!(of(&untold), of(&one));
}

#[test]
fn inductance_of_windings_that_ring_is_that_of_windings_solved_about_their_mean_pitch() {
    let spring =
        S_T.replacen("[spring]", "[spring]\nrelative_permeability = 2.5\nself_distance = \"geometric-mean\"", 1);
    let spec = spec(&format!("{spring}\n{UNDAMPED}{HEEL_STRIKE}"));
    assert_eq!(spec.spring.self_distance, SelfDistance::GeometricMean);
    let inductance = SpringInductance::of(&spec.spring);
    let (spring, asked) = (&spec.spring.spring, &spec.conditions[0]);
    let length = asked.excitation.mean_length();
    let coil = Some(Coil::of(spring, &inductance, length, Method::Exact).unwrap());
    let (mount, excitation) = (&spec.mount.cases[0].mount, &asked.excitation);
    let setup = Setup { spring, mount, excitation, coil, positions: true, helix: None, contact: None };
    let times: Vec<f64> = (0..40).map(|sample| 7e-3 * f64::from(sample)).collect();
    let found = study::simulate(&setup, &times).unwrap();
    let magnetised = found.magnetised.unwrap();
    let turns = 52;
    let about =
        SteelWindings::about(turns, spring.coil_radius(), spring.wire_radius(), 2.5, length / turns as f64).unwrap();
    let by_turns = found.windings.unwrap().turns(spring.masses_per_winding()).unwrap();
    let mut largest = 0.0_f64;
    for sample in 0..times.len() {
        let [own, other] =
            [magnetised.inductances[sample], about.at_positions(by_turns.row(sample)).unwrap().inductance];
        let off = (own - other).abs();
        largest = largest.max(off / own);
        let bound = magnetised.doubts[sample] + about.at_positions(by_turns.row(sample)).unwrap().bound;
        assert!(off <= bound, "{sample}: {off:e} of {bound:e}");
    }
    println!("at most {largest:e} apart");
    assert!(largest < 2e-5, "{largest:e}");
}

#[test]
fn wire_beyond_the_theory_is_said_to_be_taken_as_air() {
    let analysis = of_wire("relative_permeability = 60", STILL);
    let told = magnetic(&analysis);
    assert_eq!(told.len(), 1);
    assert!(
        told[0].contains("permeability must be 1 to 20, got 60") && told[0].contains("not magnetic"),
        "{}",
        told[0]
    );
}

#[test]
fn windings_that_nearly_touch_are_said_to_be_too_uneven() {
    let fast = HEEL_STRIKE.replace("0.25 m/s", "3 m/s");
    let analysis = of_wire("relative_permeability = 2.5", &fast);
    let told = magnetic(&analysis);
    assert!(told.len() == 1 && told[0].contains("more than a third off"), "{told:?}");
    let slow = of_wire("relative_permeability = 2.5", HEEL_STRIKE);
    let name = "magnetisation of uneven windings";
    assert!(line(&analysis, name).unwrap() > 10.0 * line(&slow, name).unwrap());
}

#[test]
fn the_data_sheet_has_the_inductance_of_the_wire_that_is_told() {
    let of = |wire: &str| {
        let spring = S_T.replacen("[spring]", &format!("[spring]\n{wire}"), 1);
        let sheet = DataSheet::of(&spec(&format!("{spring}\n{UNDAMPED}"))).unwrap();
        let row = sheet.groups.iter().flat_map(|(_, rows)| rows).find(|row| row.key == "inductance_at_min_h");
        row.unwrap().value.unwrap()
    };
    let more = of("relative_permeability = 2.5") / of("");
    assert!((1.05..1.2).contains(&more), "{more}");
}
