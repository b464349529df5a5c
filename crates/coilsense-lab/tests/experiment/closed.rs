//! Measures of known series are their closed forms.

use coilsense::Channel;
use coilsense_lab::experiment::{Curve, Findings, answer};
use coilsense_lab::output::Output;
use coilsense_lab::report::{add_experiment, experiment_json, experiment_text};

use super::*;

/// A sum of 8000 forces of 26 N rounds by at most n ε F, 4.6e-11 N of its mean.
const ROUNDING: f64 = 5e-11;

#[test]
fn deviations_and_means_of_known_sines_are_their_closed_forms() {
    let mut runs = usual();
    runs[3].output_offset = 0.25;
    let place = folder(&format!("{TOP}{GIVEN}"), &runs);
    let experiment = read(&place).unwrap();
    assert!((experiment.reference - preload()).abs() < ROUNDING && experiment.runs.len() == 6);
    for (run, sines) in experiment.runs.iter().zip(&runs) {
        let (deviation, apart) = (&run.fast.deviation, sines.at_load_cell - sines.by_position);
        // F_o − F_x is a sine and an offset, over whole periods; a quarter of a period is a whole number of samples.
        let rmsd = (0.5 * apart * apart + sines.output_offset * sines.output_offset).sqrt();
        assert!((deviation.rmsd - rmsd).abs() < ROUNDING, "{} for {rmsd}", deviation.rmsd);
        assert!((run.fast.oscillation - apart / 2.0_f64.sqrt()).abs() < 1e-6); // a root of a difference
        assert!((deviation.maximum_absolute - apart - sines.output_offset).abs() < ROUNDING);
        assert_eq!(run.fast.left_out, 0);
        let difference = |force| experiment.difference(run, force).unwrap();
        assert!((difference(Channel::OutputForce) - sines.output_offset).abs() < ROUNDING);
        assert!(difference(Channel::DeflectionForce).abs() < ROUNDING);
        // 1/l over its conditioning: 26 N of 105.
        assert!(difference(Channel::InductanceForce).abs() < 1e-11);
        // Eq. (15): σ of n samples of a sine; over blocks of whole periods nothing scatters.
        let samples = SAMPLES as f64;
        let expected = sines.at_load_cell * (0.5 / (samples - 1.0)).sqrt();
        assert!((run.fast.output.standard_error - expected).abs() < ROUNDING);
        assert!(run.fast.output.block_error.is_none_or(|error| error < ROUNDING), "{:?}", run.fast.output);
        // Sixteen readings ±1 mN.
        let inductance = run.inductance.unwrap();
        assert!((inductance.standard_error - 1e-3 / 15.0_f64.sqrt()).abs() < 1e-11 && inductance.samples == 16);
    }
    let findings = Findings::of(&experiment);
    let peak = findings.peak.unwrap();
    assert!(
        peak.run == 3
            && (peak.rmsd_ratio * 0.3 / 2.0_f64.sqrt() / (0.5 * 2.4 * 2.4 + 0.0625_f64).sqrt() - 1.0).abs() < 1e-9
    );
}

#[test]
fn a_steady_drift_is_no_bias_and_a_bias_is_no_drift() {
    let mut runs = usual();
    for (index, run) in runs.iter_mut().enumerate() {
        run.output_offset = -0.01 * index as f64;
    }
    runs[3].inductance_offset = -0.05;
    let place = folder(&format!("{TOP}{GIVEN}"), &runs);
    let experiment = read(&place).unwrap();
    let findings = Findings::of(&experiment);
    for run in 1..=4 {
        let offset = findings.offset(run, Channel::OutputForce).unwrap();
        // Rounding is no bias, though nothing scatters here.
        assert!(offset.value.abs() < ROUNDING && !offset.is_seen(), "{offset:?}");
    }
    let biased = findings.offset(3, Channel::InductanceForce).unwrap();
    assert!((biased.value + 0.05).abs() < 1e-10 && biased.is_seen());
    // √(1 + ½) of the error of a mean, and what sums round, 3e-10 N.
    assert!((biased.error - 1.5_f64.sqrt() * 1e-3 / 15.0_f64.sqrt()).abs() < 1e-9);
    let drift = |force| findings.drifts.iter().find(|drift| drift.force == force).unwrap();
    let output = drift(Channel::OutputForce);
    let trend = output.trend.unwrap();
    assert!((output.preloads.unwrap().value + 0.05).abs() < ROUNDING && (trend.slope + 0.01).abs() < ROUNDING);
    assert!(trend.rises == -15 && (trend.p - 2.0 / 720.0).abs() < 1e-12);
    assert!(drift(Channel::InductanceForce).trend.unwrap().slope.abs() < 1e-9);
    let said = answer(&experiment, &findings);
    assert!(said[0].contains("differ most at 20.0 Hz") && !said[0].contains("imulated"), "{said:?}");
    assert!(said[1].contains("F_L is biased low by 0.0500 % of F_nom"), "{said:?}");
    assert!(said[2].contains("F_o −50"), "{said:?}");
}

/// Five positions at rest, three readings each.
fn calibration() -> String {
    let row = |index: usize| {
        let u1 = 1e-3 * ((index / 3) as f64 * 2.0 - 4.0);
        let force = preload() - STIFFNESS * u1;
        format!("{},{},{}\n", 1e3 * u1, force, 1e6 * inductance(force))
    };
    "u1 [mm],F_o [N],L [uH]\n".to_owned() + &(0..15).map(row).collect::<String>()
}

#[test]
fn stiffness_offset_and_curve_come_from_the_calibration_run_where_they_are_not_given() {
    let of_calibration = format!("{TOP}\n[[run]]\nkind = \"calibration\"\nslow = \"calibration.csv\"\n");
    let place = folder(&of_calibration, &usual());
    write(place.path(), "calibration.csv", &calibration());
    let experiment = read(&place).unwrap();
    let relative = |ours: f64, theirs: f64| (ours / theirs - 1.0).abs();
    assert!(relative(experiment.line.stiffness, STIFFNESS) < 1e-11);
    assert!(relative(experiment.line.length_at_zero, LENGTH) < 1e-12);
    let Some(Curve::InverseLength { calibration: curve, through, .. }) = &experiment.curve else { panic!("no curve") };
    // The preload's mean of L scatters, and the square of ±1 mN makes it 2e-13 H too large.
    assert!(relative(curve.alpha(), ALPHA) < 1e-6 && relative(curve.beta(), BETA) < 1e-5);
    assert!(relative(through.unwrap().0, LENGTH) < 1e-12);
    // What is given comes first.
    let given = of_calibration.replace("\n[[run]]", "stiffness = \"800 N/m\"\n\n[[run]]");
    let place = folder(&given, &usual());
    write(place.path(), "calibration.csv", &calibration());
    let experiment = read(&place).unwrap();
    assert_eq!(experiment.line.stiffness, 800.0);
    // The line still goes through the middle of the measured points.
    assert!((experiment.line.force(experiment.line.length_at_zero) - preload()).abs() < 1e-10);
}

#[test]
fn a_sine_is_cut_behind_its_last_whole_period_and_what_is_left_out_is_counted() {
    let mut runs = usual();
    // 4 s hold 27 periods of 6.8 Hz and a fifth.
    runs[2].frequency = 6.8;
    let experiment = read(&folder(&format!("{TOP}{GIVEN}"), &runs)).unwrap();
    let run = &experiment.runs[2];
    let kept = (27.0 * RATE / 6.8).round() as usize;
    assert_eq!((run.fast.output.samples, run.fast.left_out), (kept, SAMPLES - kept));
    // What a period that is not a whole number of samples leaves: half a sample of 0.8 N in 4 s.
    assert!(experiment.difference(run, Channel::OutputForce).unwrap().abs() < 0.8 * 0.5 / kept as f64);
    assert!(experiment.account()[0].contains(&format!("{} after the last whole period", SAMPLES - kept)));
    // Uncut, the mean would be off by A (1 − cos 2π·0.2)/(2π·27.2), which is more.
    assert!(0.8 * (1.0 - (TAU * 0.2).cos()) / (TAU * 27.2) > 10.0 * 0.8 * 0.5 / kept as f64);
}

#[test]
fn every_way_of_writing_the_position_is_the_same_experiment() {
    let expected = read(&folder(&format!("{TOP}{GIVEN}"), &usual())).unwrap();
    let rewritten = |title: &str, column: &dyn Fn(f64) -> String, more: &str| {
        let place = folder(&format!("{TOP}{GIVEN}{more}"), &usual());
        for index in 0..6 {
            let name = format!("{index}-fast.csv");
            let text = fs::read_to_string(place.path().join(&name)).unwrap();
            let rows = text.lines().skip(1).map(|row| {
                let (head, u1) = row.rsplit_once(',').unwrap();
                format!("{head},{}\n", column(u1.parse().unwrap()))
            });
            write(place.path(), &name, &(format!("time [s],F_o [N],{title}\n") + &rows.collect::<String>()));
        }
        write(place.path(), "daq.toml", "[columns]\nu2 = \"LDM [mm]\"\n");
        read(&place).unwrap()
    };
    let both = rewritten("u1 [mm],u2 [mm]", &|u1| format!("{},{}", u1 + 3.0, 3.0), "");
    let force = rewritten("F_x [N]", &|u1| (preload() - 1e-3 * STIFFNESS * u1).to_string(), "");
    let mapped = rewritten("LDM [mm]", &|u1| (-u1).to_string(), "fast_mapping = \"daq.toml\"\n");
    for other in [both, force, mapped] {
        for (ours, theirs) in other.runs.iter().zip(&expected.runs) {
            assert!((ours.fast.deviation.rmsd - theirs.fast.deviation.rmsd).abs() < 1e-10);
            assert!((ours.fast.deflection.mean - theirs.fast.deflection.mean).abs() < 1e-10);
        }
    }
}

/// Report, results and every figure of an experiment.
fn files(place: &TempDir) -> Vec<(String, String)> {
    let experiment = read(place).unwrap();
    let findings = Findings::of(&experiment);
    let out = tempfile::tempdir().unwrap();
    let mut output = Output::begin(out.path()).unwrap();
    add_experiment(&experiment, &findings, "2026-11-21", &mut output).unwrap();
    output.commit().unwrap();
    let text = |name: &str| (name.to_owned(), fs::read_to_string(out.path().join(name)).unwrap());
    let names =
        ["report.html", "results.json", "figures/figure-5.svg", "figures/figure-6.svg", "figures/means-in-order.svg"];
    let mut files = names.map(text).to_vec();
    files.push(("text".into(), experiment_text(&experiment, &findings)));
    files.push(("json".into(), experiment_json(&experiment, &findings, None).unwrap()));
    files
}

#[test]
fn simulated_data_are_called_so_in_the_report_and_on_every_figure() {
    let runs = usual();
    let measured = folder(&format!("{TOP}{GIVEN}"), &runs);
    assert!(files(&measured).iter().all(|(_, text)| !text.to_lowercase().contains("simulated data")));
    let said = folder(&format!("simulated = true\n{TOP}{GIVEN}"), &runs);
    let logged = folder(&format!("{TOP}{GIVEN}"), &runs);
    let slow = "# simulated by some program\n".to_owned() + &runs[2].slow();
    write(logged.path(), "2-slow.csv", &slow);
    for place in [said, logged] {
        for (name, text) in files(&place) {
            assert!(text.to_lowercase().contains("simulated data"), "{name}");
        }
    }
}

#[test]
fn without_readings_or_neighbours_the_rest_is_still_worked_off() {
    let top = format!("{TOP}{}", GIVEN.replace("inverse_length = { alpha = 1.6e6, beta = 0.3 }\n", ""));
    let experiment = read(&folder(&top, &usual()[..2])).unwrap();
    let findings = Findings::of(&experiment);
    assert!(experiment.curve.is_none() && experiment.runs.iter().all(|run| run.inductance.is_none()));
    assert!(findings.offsets.is_empty() && findings.drifts.len() == 2);
    assert!(answer(&experiment, &findings)[1].contains("no neighbours"));
    assert!(experiment.account().iter().any(|line| line.contains("there is no F_L")));
    // A preload alone has nothing to part in.
    let alone = read(&folder(&top, &usual()[..1])).unwrap();
    let findings = Findings::of(&alone);
    assert!(findings.peak.is_none() && answer(&alone, &findings)[0].starts_with("there is no sine"));
    let off = format!("averaging = \"445 ms\"\n{TOP}{GIVEN}");
    let account = read(&folder(&off, &usual())).unwrap().account();
    // 445 ms hold 2.2 periods of 5 Hz, 4.45 of 10 Hz, 8.9 of 20 Hz, 11.1 of 25 Hz.
    assert!(account.iter().any(|line| line.contains("do not hold whole periods in 1, 2, 3, 4")), "{account:?}");
}
