//! Logs whose lengths a stored calibration reads off the coil's inductance.
//!
//! Next door: logs with both ends (`log`), the calibration itself (`calibrate`'s tests).

use coilsense::Channel::{self, Inductance, InputForce, OutputForce, U1, U2};
use coilsense_lab::calibration::{Applied, StoredCalibration};
use coilsense_lab::mitigation::request::Request;
use coilsense_lab::recording::RecordingError;

use super::log::{LENGTH, changed, errors, notes, times};
use super::*;

/// L = α/l, and by how much a reading of it scatters \[H\]: 4 µm of length.
const ALPHA: f64 = 6.6e-7;
const NOISE: f64 = 5e-11;

fn calibration() -> StoredCalibration {
    let row = |index: usize| {
        let length = 0.2 + 0.06 * index as f64 / 24.0;
        format!("[{:?}, {length:?}, 3e-5]", ALPHA / length)
    };
    let rows: Vec<String> = (0..25).map(row).collect();
    let text = format!(
        "schema = \"coilsense/stored-calibration/1\"\nrelation = \"inverse-length\"\nremounting = 0.0\nrows = [{}]\n",
        rows.join(", ")
    );
    StoredCalibration::of_text("calibration.toml", &text).unwrap()
}

/// The log with L by its ends' `sign`, of only the channels that are kept, F_i off by some newtons.
fn with_inductance(keep: &[Channel], sign: f64, offset: f64) -> Recording {
    let whole = changed(1e-3, |_, values| values);
    let of = |channel: Channel| whole.signals().channel(channel).unwrap();
    let each = of(U1).iter().zip(of(U2)).enumerate();
    let inductance: Vec<f64> = each
        .map(|(index, (first, second))| ALPHA / (LENGTH + sign * (second - first)) + NOISE * (1.7 * index as f64).sin())
        .collect();
    let mut signals = coilsense::Signals::new(whole.signals().time().to_vec()).unwrap();
    for &channel in keep {
        let values = match channel {
            Inductance => inductance.clone(),
            InputForce => of(channel).iter().map(|force| force + offset).collect(),
            _ => of(channel).to_vec(),
        };
        signals.insert(channel, values).unwrap();
    }
    Recording::of_signals("rig.csv", signals)
}

fn study(log: &Recording, held: bool) -> Result<Study, RecordingError> {
    let applied = Applied::new(&calibration(), log.signals(), "rig.csv").unwrap();
    Study::on_lengths(&spec(""), &Request { end2_held: Some(held), ..asked() }, log, &applied)
}

fn refused(log: &Recording, held: bool) -> String {
    let told = study(log, held).err().unwrap().to_string();
    assert!(told.lines().count() == 1, "{told}");
    told
}

#[test]
fn a_log_of_force_and_inductance_alone_is_ranked_as_one_with_both_ends() {
    let whole = Study::on(&spec(""), &asked(), &changed(1e-3, |_, values| values)).unwrap().run().unwrap();
    let best = |answer: &Ranking| answer.best(Truth::Static).unwrap().0.name.clone();
    for (keep, held, told) in [
        (&[InputForce, Inductance][..], true, "u1 is the length by L, end 2 is held"),
        (&[InputForce, U1, Inductance], false, "u2 is u1 and the length by L"),
        (&[InputForce, U2, Inductance], false, "u1 is u2 less the length by L"),
    ] {
        let answer = study(&with_inductance(keep, 1.0, 0.0), held).unwrap().run().unwrap();
        let recorded = answer.study.recorded.as_ref().unwrap();
        // 30 µm of length are 22.8 mN.
        assert!(
            notes(&answer).contains(&format!("{told}: standard uncertainty at most 0.0300 mm, 0.0228 N")),
            "{}",
            notes(&answer)
        );
        assert!(notes(&answer).contains("windings at rest"));
        let of_whole = &whole.study.recorded.as_ref().unwrap().measured;
        for (by_inductance, by_ends) in recorded.measured.iter().zip(of_whole) {
            let length = |ends: [f64; 2]| ends[1] - ends[0];
            // NOISE is 4 µm; where the mean of F_i puts zero, 20 µm.
            assert!((length(by_inductance.ends) - length(by_ends.ends)).abs() < 4e-5);
        }
        assert_eq!(best(&answer), best(&whole));
        // A tenth of the error more by the noise of L, 3 mN of the 0.3 N that nothing done leaves.
        let ([raw, filtered], [raw_whole, filtered_whole]) = (errors(&answer), errors(&whole));
        assert!((raw / raw_whole - 1.0).abs() < 0.02, "{raw} {raw_whole}");
        assert!((filtered / filtered_whole - 1.0).abs() < 0.1, "{filtered} {filtered_whole}");
    }
}

#[test]
fn inductance_tells_where_positions_count_from_and_that_a_force_is_off() {
    let all = [InputForce, OutputForce, U1, U2, Inductance];
    let answer = study(&with_inductance(&all, 1.0, 0.0), true).unwrap().run().unwrap();
    let zero = answer.study.recorded.as_ref().unwrap().length_at_zero;
    assert!((zero - LENGTH).abs() < 2e-5, "{zero}");
    assert!(
        notes(&answer).contains("Where u1 and u2 read zero the coil is 230.000 mm long, by L"),
        "{}",
        notes(&answer)
    );
    assert!(!notes(&answer).contains("Warning"), "{}", notes(&answer));
    // The mean of F_i would take its error for a length.
    let off = study(&with_inductance(&all, 1.0, 15.2), true).unwrap().run().unwrap();
    assert!(
        notes(&off).contains("Warning: the length is by L; F_i is 15.2 N off k·Δl on average")
            && notes(&off).contains("the coil is 20.00"),
        "{}",
        notes(&off)
    );
    assert!((off.study.recorded.as_ref().unwrap().length_at_zero - LENGTH).abs() < 2e-5);
}

#[test]
fn a_log_at_rest_is_no_disagreement_of_length_and_ends() {
    // Nothing moves but the noise of L, of which this calibration does not say how much there may be.
    let text = calibration().to_text("2026-11-27").replace(", 3e-5]", ", nan]");
    let untold = StoredCalibration::of_text("calibration.toml", &text).unwrap();
    assert!(untold.doubts([0.22, 0.24]).is_none());
    let still = changed(0.0, |_, values| values);
    let of = |channel: Channel| still.signals().channel(channel).unwrap().to_vec();
    let mut signals = coilsense::Signals::new(still.signals().time().to_vec()).unwrap();
    for channel in [InputForce, U1, U2] {
        signals.insert(channel, of(channel)).unwrap();
    }
    let count = still.signals().time().len();
    let noise = (0..count).map(|index| ALPHA / LENGTH + 100.0 * NOISE * (1.7 * index as f64).sin()).collect();
    signals.insert(Inductance, noise).unwrap();
    let log = Recording::of_signals("rig.csv", signals);
    let applied = Applied::new(&untold, log.signals(), "rig.csv").unwrap();
    let study = Study::on_lengths(&spec(""), &Request { end2_held: Some(true), ..asked() }, &log, &applied).unwrap();
    let notes = study.recorded.unwrap().notes.join("\n");
    assert!(notes.contains("the coil is 230.0") && notes.contains("its uncertainty unknown"), "{notes}");
}

#[test]
fn lengths_of_other_ends_and_logs_without_any_are_refused_in_a_line() {
    let turned = refused(&with_inductance(&[InputForce, U1, U2, Inductance], -1.0, 0.0), true);
    assert!(turned.starts_with("rig.csv: the length by L leaves 1.39") && turned.contains("a turned sign"), "{turned}");
    let none = refused(&with_inductance(&[InputForce, Inductance], 1.0, 0.0), false);
    assert!(
        none.contains("has no u1")
            && none.contains("--calibration FILE tells the length alone")
            && none.contains("--end2 held"),
        "{none}"
    );
    // A turned force is seen by the length as by the ends.
    let log = with_inductance(&[InputForce, Inductance], 1.0, 0.0);
    let mut signals = coilsense::Signals::new(log.signals().time().to_vec()).unwrap();
    signals.insert(InputForce, times(log.signals().channel(InputForce).unwrap().to_vec(), -1.0)).unwrap();
    signals.insert(Inductance, log.signals().channel(Inductance).unwrap().to_vec()).unwrap();
    assert!(refused(&Recording::of_signals("rig.csv", signals), true).contains("is turned"));
}
