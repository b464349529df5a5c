//! Logs as they come: positions that count from somewhere, a stiffness that the spec does not have, signs, channels that are missing.

use std::f64::consts::TAU;

use coilsense::Channel::{self, InputForce, OutputForce, U1, U2};
use coilsense::Signals;
use coilsense_lab::mitigation::Judgement;
use coilsense_lab::recording::RecordingError;
use rand::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

use super::*;

/// Samples a second; the log's length \[s\].
const RATE: f64 = 1000.0;
const DURATION: f64 = 12.0;
pub const LENGTH: f64 = 0.23;

/// S_T of 760 N/m hit four times while end 1 moves by 1 mm at 0.3 Hz, 10 mN of noise: u1, u2 from where the coil is 230 mm long, F_i, F_o.
fn channels(slow: f64) -> (Vec<f64>, Vec<(Channel, Vec<f64>)>) {
    let spring = s_t();
    let times = sampled_window(RATE, 0.0, DURATION).unwrap();
    let mount = Mount::new(FarEnd::Position, Damping::Modal(0.01)).unwrap();
    let hit = Motion::mounted(&spring, &mount, &Excitation::impact(LENGTH, 0.25).unwrap()).unwrap();
    let still = spring.static_force(LENGTH);
    let hits = hit.end_forces(&times).unwrap();
    let random = &mut rand_pcg::Pcg64::seed_from_u64(1);
    let u1: Vec<f64> = times.iter().map(|time| slow * (TAU * 0.3 * time).sin()).collect();
    let mut force = |series: &[f64]| -> Vec<f64> {
        let at = |index: usize| {
            let hits = [0.5, 3.1, 6.2, 9.4].map(|start| (start * RATE) as usize).into_iter();
            let ringing: f64 = hits.filter(|start| *start <= index).map(|start| series[index - start] - still).sum();
            let chance: f64 = StandardNormal.sample(random);
            spring.static_force(LENGTH - u1[index]) + ringing + 0.01 * chance
        };
        (0..times.len()).map(at).collect()
    };
    let (input, output) = (force(&hits.input), force(&hits.output));
    let zero = vec![0.0; times.len()];
    (times, vec![(U1, u1), (U2, zero), (InputForce, input), (OutputForce, output)])
}

/// The log, each channel changed as asked; those that become empty are not there.
pub fn changed(slow: f64, change: impl Fn(Channel, Vec<f64>) -> Vec<f64>) -> Recording {
    let (times, channels) = channels(slow);
    let mut signals = Signals::new(times).unwrap();
    for (channel, values) in channels {
        let values = change(channel, values);
        if !values.is_empty() {
            signals.insert(channel, values).unwrap();
        }
    }
    Recording::of_signals("rig.csv", signals)
}

pub fn times(values: Vec<f64>, factor: f64) -> Vec<f64> {
    values.into_iter().map(|value| factor * value).collect()
}

fn judged(asked: &Request, log: &Recording) -> Result<Ranking, RecordingError> {
    Ok(Study::on(&spec(""), asked, log)?.run().unwrap())
}

fn refused(log: &Recording) -> String {
    let told = Study::on(&spec(""), &asked(), log).err().unwrap().to_string();
    assert!(told.starts_with("rig.csv: ") && told.lines().count() == 1, "{told}");
    told
}

pub fn notes(answer: &Ranking) -> String {
    answer.study.recorded.as_ref().unwrap().notes.join("\n")
}

/// Errors of nothing done and of the best filter, in % of F_nom.
pub fn errors(answer: &Ranking) -> [f64; 2] {
    let raw = answer.judged.iter().find(|(candidate, _)| candidate.name.starts_with("F_i, unfiltered")).unwrap();
    let of = |judgement: &Judgement| share(answer, judgement.nominal);
    [of(&raw.1), of(&answer.best(Truth::Static).unwrap().1)]
}

#[test]
fn positions_that_count_from_anywhere_give_the_ranking_of_lengths() {
    let lengths = changed(1e-3, |channel, values| match channel {
        U2 => values.into_iter().map(|u2| u2 + LENGTH).collect(),
        _ => values,
    });
    let true_lengths = judged(&asked(), &lengths).unwrap();
    let anywhere = judged(&asked(), &changed(1e-3, |_, values| values)).unwrap();
    let told =
        judged(&Request { length_at_zero: Some(LENGTH), ..asked() }, &changed(1e-3, |_, values| values)).unwrap();
    println!("{}\n{:?}", notes(&anywhere), errors(&anywhere));
    for answer in [&true_lengths, &anywhere, &told] {
        let [raw, best] = errors(answer);
        // Four hits of 1.76 N in 12 s leave 0.3 to 0.4 % unfiltered; no filter is at 50 %.
        assert!(raw < 0.6 && best < 0.5 * raw, "{raw} {best}");
        let order = |answer: &Ranking| answer.best(Truth::Static).unwrap().0.name.clone();
        assert_eq!(order(answer), order(&true_lengths));
    }
    assert!(notes(&anywhere).contains("The coil is 230.0") && notes(&told).contains("as told"), "{}", notes(&told));
    assert!(notes(&anywhere).contains("they agree"), "{}", notes(&anywhere));
    let wrong = judged(&Request { length_at_zero: Some(0.25), ..asked() }, &changed(1e-3, |_, values| values)).unwrap();
    assert!(
        notes(&wrong).contains("Warning: The coil is 250.000 mm") && notes(&wrong).contains("15.2 N off"),
        "{}",
        notes(&wrong)
    );
}

#[test]
fn a_stiffness_that_is_five_per_cent_off_is_taken_from_the_log() {
    let answer = judged(&asked(), &changed(1e-3, |_, values| values)).unwrap();
    let off = judged(
        &asked(),
        &changed(1e-3, |channel, values| match channel {
            InputForce | OutputForce => times(values, 0.93),
            _ => values,
        }),
    )
    .unwrap();
    println!("{}", notes(&off));
    let k = off.study.recorded.as_ref().unwrap().stiffness.unwrap();
    assert!(k.holds(0.93 * 760.0) && k.expanded < 10.0, "{k:?}");
    assert!((off.study.spring.stiffness() - k.value).abs() < 1e-6);
    assert!(notes(&off).contains("ranking and settings take the log's"), "{}", notes(&off));
    // 7 % are more than the 5 % that were asked for.
    assert!(notes(&off).contains("Warning: that is -"), "{}", notes(&off));
    let ([raw, best], [raw_off, best_off]) = (errors(&answer), errors(&off));
    assert!(
        (raw_off / raw - 1.0).abs() < 0.2 && best_off < 0.5 * raw_off && best_off < 2.0 * best,
        "{raw_off} {best_off}"
    );
}

#[test]
fn a_log_of_another_spring_or_with_a_turned_sign_is_refused_in_a_line() {
    let scaled = |which: Channel, factor: f64| {
        changed(1e-3, move |channel, values| if channel == which { times(values, factor) } else { values })
    };
    let three = refused(&changed(1e-3, |channel, values| match channel {
        InputForce | OutputForce => times(values, 3.0),
        _ => values,
    }));
    assert!(three.contains("3.00 times the spec's 760.0 N/m: another spring"), "{three}");
    let turned = refused(&scaled(InputForce, -1.0));
    assert!(turned.contains("F_i falls by 7") && turned.contains("the sign of F_i, u1 or u2 is turned"), "{turned}");
    assert!(refused(&scaled(OutputForce, -1.0)).contains("F_o falls by 7"));
    assert!(refused(&scaled(U1, -1.0)).contains("F_i falls by 7"));
    // A slow force of its own that the length does not explain.
    let other = refused(&changed(1e-3, |channel, values| {
        let own = |index: usize| 1.5 * (TAU * 0.17 * index as f64 / RATE + 0.3).sin();
        match channel {
            InputForce => values.iter().enumerate().map(|(index, value)| value + own(index)).collect(),
            _ => values,
        }
    }));
    assert!(other.contains("another spring, or channels that do not belong together"), "{other}");
}

#[test]
fn a_log_without_a_slow_motion_is_judged_with_the_spec_s_stiffness_and_says_so() {
    let answer = judged(&asked(), &changed(0.0, |_, values| values)).unwrap();
    println!("{}", notes(&answer));
    assert!(
        notes(&answer)
            .contains("No stiffness from the log, the spec's 760.0 N/m is used: the length moves by 0.000 mm")
    );
    assert!(answer.study.recorded.as_ref().unwrap().stiffness.is_none());
    let [raw, best] = errors(&answer);
    assert!(raw < 0.6 && best < 0.5 * raw, "{raw} {best}");
}

#[test]
fn a_log_with_f_i_and_u1_alone_gets_its_page_and_its_figure() {
    let alone = changed(1e-3, |channel, values| if matches!(channel, U2 | OutputForce) { Vec::new() } else { values });
    let answer = judged(&asked(), &alone).unwrap();
    let text = mitigation_text(&answer);
    assert!(text.contains("estimators of F_o cannot be") && !text.contains("against F_o"), "{text}");
    let folder = tempfile::tempdir().unwrap();
    let mut output = Output::begin(&folder.path().join("out")).unwrap();
    add_mitigation(&answer, &spec(""), "2026-11-22", Precision::Single, &mut output).unwrap();
    output.commit().unwrap();
    let page = std::fs::read_to_string(folder.path().join("out/report.html")).unwrap();
    assert!(page.contains("F_o was not recorded") && folder.path().join("out/trade-off.svg").is_file());
    let json: serde_json::Value = serde_json::from_str(&mitigation_json(&answer).unwrap()).unwrap();
    assert!(
        (json["length_at_zero_m"].as_f64().unwrap() - LENGTH).abs() < 1e-4
            && json["notes"].as_array().unwrap().len() > 2
    );
    // Where end 2 is not said to be held, its position is wanted, and only options that there are are advised.
    let free = Request { end2_held: Some(false), ..asked() };
    let told = Study::on(&spec(""), &free, &alone).err().unwrap().to_string();
    assert!(told.contains("has no u2") && told.contains("--column u2=") && told.contains("--end2 held"), "{told}");
}
