//! What sensors read of a motion.

use std::f64::consts::{PI, TAU};

use coilsense::{Channel, Deviation};
use coilsense_lab::analysis::Analysis;

use super::{HEEL_STRIKE, S_T, line, run, undamped, verdict};

const PERFECT: &str = "[[sensor]]\nkind = \"load-cell\"\nname = \"one\"\nend = 1\n[[sensor]]\nkind = \"load-cell\"\nname = \"two\"\n\
                       [[sensor]]\nkind = \"deflection\"\nname = \"laser\"\n";

fn deviation(analysis: &Analysis, sensor: &str) -> Deviation {
    let index = analysis.sensors.iter().position(|other| other.name == sensor).unwrap();
    analysis.cases[0].readings[index].deviation
}

fn ideal(analysis: &Analysis, force: Channel) -> Deviation {
    analysis.cases[0].ideal.iter().find(|(channel, _)| *channel == force).unwrap().1
}

#[test]
fn a_perfect_sensor_reads_its_channel() {
    let analysis = undamped(S_T, &format!("{HEEL_STRIKE}{PERFECT}"));
    assert_eq!(deviation(&analysis, "one"), ideal(&analysis, Channel::InputForce));
    assert_eq!(deviation(&analysis, "two"), ideal(&analysis, Channel::OutputForce));
    // F_x is the force of the length itself: a perfect gauge of length cannot be off, whatever the windings do.
    assert_eq!(deviation(&analysis, "laser").maximum_absolute, 0.0);
}

#[test]
fn the_roles_change_with_the_force_that_counts_as_true() {
    let against_f_x = undamped(S_T, &format!("{HEEL_STRIKE}{PERFECT}"));
    let against_f_o = undamped(S_T, &format!("{HEEL_STRIKE}{PERFECT}[goal]\nerror = \"1 %\"\nforce = \"F_o\"\n"));
    assert_eq!(deviation(&against_f_o, "two").maximum_absolute, 0.0);
    assert_eq!(deviation(&against_f_o, "laser").rmsd, ideal(&against_f_x, Channel::OutputForce).rmsd);
    assert_eq!(against_f_o.sensors[against_f_o.verdicts[0].sensor].name, "two", "what is true is least uncertain");
    // An impact is antisymmetric about the middle: both ends are off by the same, the other way round.
    let (one, two) = (deviation(&against_f_x, "one").rmsd, deviation(&against_f_o, "one").rmsd);
    assert!((two / one - 2.0).abs() < 1e-9, "{one} {two}");
}

#[test]
fn a_mean_over_one_surge_period_leaves_only_what_the_modes_are_out_of_tune() {
    let condition = HEEL_STRIKE.to_owned() + "sample_rate = \"40 kHz\"\n";
    let window = (0.065_f64 / 760.0).sqrt() * 2.0;
    let sensors = format!(
        "[[sensor]]\nkind = \"load-cell\"\nname = \"raw\"\n[[sensor]]\nkind = \"load-cell\"\nname = \"mean\"\naveraging = \"{window} s\"\n"
    );
    let analysis = undamped(S_T, &format!("{condition}{sensors}"));
    // An impact at v sets mode j swinging with the force 4kv/ω_j where j is odd; a mean over W leaves sinc(f_j W) of it, W f_1 = 1.
    let angular = |j: f64| 104.0 * (760.0_f64 / 0.065).sqrt() * (j * PI / 104.0).sin();
    let odd = || (1..52).step_by(2).map(f64::from);
    let amplitude = |j: f64| 4.0 * 760.0 * 0.25 / angular(j);
    let sinc = |x: f64| (PI * x).sin() / (PI * x);
    let raw = odd().map(|j| 0.5 * amplitude(j).powi(2)).sum::<f64>().sqrt();
    let left = odd().map(|j| 0.5 * (amplitude(j) * sinc(angular(j) / TAU * window)).powi(2)).sum::<f64>().sqrt();
    // A quarter of a second holds 27 beats of neighbouring odd modes: their cross terms average out to about 1/27.
    assert!((deviation(&analysis, "raw").rmsd / raw - 1.0).abs() < 0.04);
    assert!((deviation(&analysis, "mean").rmsd / left - 1.0).abs() < 0.04, "{left} {:?}", deviation(&analysis, "mean"));
    assert!(left < 0.1 * raw, "nearly harmonic: {left} of {raw} is left");
}

#[test]
fn a_late_reading_of_a_moving_force_is_an_error() {
    // 2 Hz, far below the surge: F = F_mid + k a sin ωt, and 5 ms late it is off by k a ω T_d cos ωt.
    let text = format!(
        "{S_T}[mount]\ndamping_ratio = 0.02\n[uncertainty]\ntemperature_change = \"0 K\"\n[[condition]]\nkind = \"harmonic\"\nfrequency = \"2 Hz\"\n\
         amplitude = \"10 mm\"\nstart = \"massless\"\nduration = \"2 s\"\nwindow = [\"1 s\", \"2 s\"]\n[[sensor]]\nkind = \"deflection\"\nname = \"late\"\n\
         delay = \"5 ms\"\n[goal]\nerror = \"1 %\"\nbandwidth = \"20 Hz\"\n"
    );
    let analysis = run(&text);
    let late = verdict(&analysis, "late");
    let expected = 7.6 * 2.0 * (0.5 * 0.005 * TAU * 2.0).sin() / 2.0_f64.sqrt();
    // The band of 20 Hz lets 2 Hz pass to 1e-8; the judged second holds two whole periods.
    assert!((late.combined() / expected - 1.0).abs() < 1e-3, "{} {expected}", late.combined());
    assert!((line(late, "oscillation") / expected - 1.0).abs() < 1e-3);
    assert_eq!(late.lag, 0.005);
}
