//! What the paper's Fig. 6 shows, on the rig's data with the paper's instruments, processed as its section IV-C says.

use coilsense::calibrate::{CalibrationPoints, FitMethod, InverseLengthFit};

use super::{Kind, PAPER, ends, log, mean, rig, spec, spread};

/// A run in shares of F_nom \[%\]: RMSD and maximum of F_o − F_x, means of F_x, F_o, F_L, and standard error of the last.
struct Row {
    rmsd: f64,
    most: f64,
    means: [f64; 3],
    error: f64,
}

/// The straight line through points: slope and value at zero.
fn line(x: &[f64], y: &[f64]) -> (f64, f64) {
    let (a, b) = (mean(x), mean(y));
    let slope =
        x.iter().zip(y).map(|(x, y)| (x - a) * (y - b)).sum::<f64>() / x.iter().map(|x| (x - a).powi(2)).sum::<f64>();
    (slope, b - slope * a)
}

fn rows(tables: &str, names: &[&str]) -> Vec<Row> {
    let (rig, spring) = (rig(tables, 2), spec(tables).spring.spring);
    let log_of = |name: &str| log(&rig, name);
    let calibration = log_of("calibration");
    let [u1, force, inductance] = ["u1", "F_o", "L"].map(|name| calibration.slow.values(name).unwrap());
    let (slope, preload) = line(u1, force);
    let lengths: Vec<f64> = u1.iter().map(|u1| spring.rest_length() + (preload + slope * u1) / -slope).collect();
    let points = CalibrationPoints::new(&lengths, inductance).unwrap();
    let fit = InverseLengthFit::new(&points, FitMethod::AllPoints).unwrap().calibration();
    let share = 100.0 / spring.nominal_force();
    let row = |name: &str| {
        let log = log_of(name);
        let (force, u1) = ends(&log);
        let by_length: Vec<f64> = u1.iter().map(|u1| preload + slope * u1).collect();
        let off: Vec<f64> = force.iter().zip(&by_length).map(|(a, b)| a - b).collect();
        let inductance = log.slow.values("L").unwrap();
        let by_coil: Vec<f64> = inductance.iter().map(|l| -slope * (fit.length(*l) - spring.rest_length())).collect();
        Row {
            rmsd: share * (off.iter().map(|off| off * off).sum::<f64>() / off.len() as f64).sqrt(),
            most: share * off.iter().fold(0.0_f64, |most, off| most.max(off.abs())),
            means: [&by_length, force, &by_coil].map(|series| share * mean(series)),
            error: share * spread(&by_coil) / (by_coil.len() as f64).sqrt(),
        }
    };
    names.iter().map(|name| row(name)).collect()
}

const NEAR: [&str; 5] = ["preload-first", "harmonic-04", "harmonic-11", "harmonic-12", "harmonic-13"];

#[test]
fn deviations_rise_towards_the_twelfth_frequency_and_only_the_coils_mean_is_biased() {
    let rows = rows(PAPER, &NEAR);
    let [still, slow, below, half, above] = rows.as_slice() else { panic!("five rows") };
    // The two-port says 1.62 % for ζ = 0.005 and 2 % of second harmonic; other rows have 0.02 % of noise and less than 0.35 %.
    assert!((half.rmsd - 1.62).abs() < 0.01, "{}", half.rmsd);
    assert!(half.most > 2.5 && half.most < 2.8, "{}", half.most);
    assert!(still.rmsd < 0.02 && slow.rmsd < 0.03 && below.rmsd < 0.25 && above.rmsd < 0.35);
    assert!(still.most < below.most && below.most < half.most && above.most < half.most);
    for force in 0..2 {
        // Against its neighbours, which relaxation drifts past. 1e5 samples with 22 mN: 6e-5 % of F_nom, and runs that are not whole
        // periods long.
        let bias = half.means[force] - 0.5 * (below.means[force] + above.means[force]);
        assert!(bias.abs() < 1e-3, "{force}: {bias}");
    }
    // −0.0157 %, of which −0.0023 % are every sine's (`perfect`); each mean is known to its standard error, and the preload's to its own.
    let against_still = |row: &Row| (row.means[2] - still.means[2], row.error.hypot(still.error));
    let (bias, error) = against_still(half);
    assert!(error < 0.0025 && (bias + 0.0157).abs() < 4.0 * error && bias < -4.0 * error, "{bias} ± {error}");
    for row in [slow, below, above] {
        let (bias, error) = against_still(row);
        assert!((bias + 0.0026).abs() < 4.0 * error, "{bias} ± {error}");
    }
}

#[test]
fn without_a_second_harmonic_half_of_the_surge_frequency_is_quiet() {
    let rows = rows(&format!("{PAPER}distortion = \"0 %\"\n"), &["harmonic-11", "harmonic-12", "harmonic-13"]);
    let [below, half, above] = rows.as_slice() else { panic!("three rows") };
    // 12th between 11th and 13th, as the force of a mass that is shaken grows.
    assert!(
        below.rmsd < half.rmsd && half.rmsd < above.rmsd && half.rmsd < 0.3,
        "{} {} {}",
        below.rmsd,
        half.rmsd,
        above.rmsd
    );
}

#[test]
fn the_first_and_the_last_preload_tell_how_much_was_lost() {
    let rows = rows(PAPER, &["preload-first", "preload-last"]);
    let rig = rig(PAPER, 2);
    let runs: Vec<f64> =
        rig.runs().iter().filter(|run| run.kind == Kind::Preload).map(|run| run.begin + 20.0).collect();
    let lost = 2e-4 * ((120.0 + runs[1]) / (120.0 + runs[0])).log10() * 26.0 / 121.6 * 100.0;
    // Mean of a logarithm over 40 s against its middle, and noise of 6e-5 %.
    assert!(
        (rows[0].means[1] - rows[1].means[1] - lost).abs() < 4e-4,
        "{} and {lost}",
        rows[0].means[1] - rows[1].means[1]
    );
    assert!((rows[0].means[0] - rows[1].means[0]).abs() < 4e-4, "length does not relax");
}
