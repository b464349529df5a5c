//! The lines of a budget against their closed forms, and against the Monte Carlo.

use coilsense::Calibration;
use coilsense::inductance::{MaxwellSum, SelfDistance};
use proptest::prelude::*;

use super::{HEEL_STRIKE, S_A, S_T, STILL, close, line, run, undamped, verdict};

const K: f64 = 760.0;
/// Force of S_T at mid range \[N\].
const F: f64 = K * (0.230 - 0.104);
/// Its travel \[m\].
const TRAVEL: f64 = 0.068;

/// The combined uncertainty \[N\] of one sensor on S_T at rest, and the line of a budget; temperature and tolerances only as told.
fn alone(sensor: &str, uncertainty: &str, spring: &str, name: &str) -> (f64, f64) {
    let text = format!(
        "{S_T}\n{spring}\n[mount]\ndamping_ratio = 0\n[uncertainty]\ntrials = 1000\n{uncertainty}\n{STILL}[[sensor]]\nname = \"s\"\n{sensor}\n"
    );
    let analysis = run(&text);
    let verdict = verdict(&analysis, "s");
    (verdict.combined(), line(verdict, name))
}

const COLD: &str = "temperature_change = \"0 K\"";
const NO_FORM: &str = "kind = \"inductance\"\ncalibration_form = \"0 %\"";

#[test]
fn each_limit_alone_contributes_its_closed_form() {
    let root = 3.0_f64.sqrt();
    let load_cell = "kind = \"load-cell\"\n";
    let laser = "kind = \"deflection\"\n";
    // dk/k of steel is −360 ppm/K of the modulus and +12 ppm/K of its length; the rest length of 104 mm grows by those 12 too.
    let drift = (348e-6 * F + 12e-6 * 0.104 * K) * 10.0 / root;
    for (sensor, uncertainty, spring, name, expected) in [
        (laser, "", "", "temperature", drift),
        ("kind = \"two-encoder\"\n", "", "", "temperature", drift),
        ("kind = \"deflection\"\nresolution = \"10 um\"", COLD, "", "sensor: resolution", 1e-5 / 12.0_f64.sqrt() * K),
        ("kind = \"deflection\"\nnoise = \"0.1 %\"", COLD, "", "sensor: noise", 1e-3 * TRAVEL * K),
        (
            "kind = \"deflection\"\naccuracy_full_scale = \"0.1 %\"",
            COLD,
            "",
            "sensor: accuracy of full scale",
            1e-3 * TRAVEL / root * K,
        ),
        (
            "kind = \"deflection\"\naccuracy_reading = \"0.2 %\"",
            COLD,
            "",
            "sensor: accuracy of reading",
            2e-3 / root * F,
        ),
        ("kind = \"deflection\"\ncalibration_uncertainty = \"0.1 %\"", COLD, "", "calibration", 1e-3 * F),
        (laser, COLD, "stiffness_tolerance = \"2 %\"", "tolerance of the stiffness", 0.02 / root * F),
        (laser, COLD, "rest_length_tolerance = \"0.5 mm\"", "tolerance of the rest length", 5e-4 / root * K),
        (
            "kind = \"load-cell\"\nrange = \"200 N\"\naccuracy_full_scale = \"0.1 %\"",
            COLD,
            "",
            "sensor: accuracy of full scale",
            0.2 / root,
        ),
        (
            "kind = \"load-cell\"\naccuracy_reading = \"0.2 %\"",
            COLD,
            "",
            "sensor: accuracy of reading",
            2e-3 / root * F,
        ),
        ("kind = \"load-cell\"\ntemperature_coefficient = \"0.01 %/K\"", "", "", "temperature", 1e-3 / root * F),
        ("kind = \"load-cell\"\nnoise = \"0.5 N\"", COLD, "", "sensor: noise", 0.5),
        (
            "kind = \"inductance\"\ncalibration_form = \"1.3 %\"",
            COLD,
            "",
            "calibration form: measured springs",
            0.013 * TRAVEL * K,
        ),
        (
            "kind = \"inductance\"\ncalibration = \"theory\"",
            COLD,
            "",
            "calibration form: measured springs",
            0.30 * TRAVEL * K,
        ),
    ] {
        let (combined, contribution) = alone(sensor, uncertainty, spring, name);
        // Differences over ±u of a line at rest: rounding of F over u.
        close(contribution, expected, 1e-9);
        close(combined, expected, 1e-9);
    }
    // A load cell sees the force itself: it does not care for the spring.
    let (combined, _) = alone(load_cell, "", "stiffness_tolerance = \"2 %\"\nrest_length_tolerance = \"0.5 mm\"", "");
    assert!(combined < 1e-12, "{combined}");
}

#[test]
fn two_encoders_see_the_spring_through_their_drive_train() {
    // As stiff as the spring: k_s = k/2, and a change of k shows by half of its share.
    let sensor = "kind = \"two-encoder\"\ncompliance = \"1.3157894736842105 mm/N\"";
    let (_, tolerance) = alone(sensor, COLD, "stiffness_tolerance = \"2 %\"", "tolerance of the stiffness");
    close(tolerance, 0.5 * 0.02 / 3.0_f64.sqrt() * F, 1e-9);
    let (_, length) = alone(sensor, COLD, "rest_length_tolerance = \"0.5 mm\"", "tolerance of the rest length");
    close(length, 5e-4 / 3.0_f64.sqrt() * 0.5 * K, 1e-9);
}

#[test]
fn noise_counts_as_far_as_the_band_holds_it() {
    let of = |goal: &str| {
        let text = format!(
            "{STILL}[[sensor]]\nkind = \"load-cell\"\nname = \"s\"\nsample_rate = \"2.5 kHz\"\nnoise = \"0.5 N\"\n{goal}"
        );
        line(verdict(&undamped(S_T, &text), "s"), "sensor: noise")
    };
    close(of(""), 0.5, 1e-9);
    // White up to half of the sample rate: 20 of 1250 Hz.
    close(of("[goal]\nerror = \"1 %\"\nbandwidth = \"20 Hz\"\n"), 0.5 * (20.0_f64 / 1250.0).sqrt(), 1e-9);
    close(of("[goal]\nerror = \"1 %\"\nbandwidth = \"2 kHz\"\n"), 0.5, 1e-9);
}

#[test]
fn eq_13_itself_is_the_least_that_a_calibration_can_be_off() {
    // Book: theory, section 3: over the range eq. (13) misfits by at most 0.32 % F_nom (S_T) and 0.44 % (S_A); a budget takes its rms, which for a curve
    // with two zeros is 0.3 to 0.5 of the largest.
    for (spring, largest) in [(S_T, 0.32), (S_A, 0.44)] {
        let text = format!("{STILL}[[sensor]]\n{NO_FORM}\nname = \"s\"\n");
        let analysis = undamped(spring, &text);
        let percent = 100.0 * line(verdict(&analysis, "s"), "calibration form: eq. (13) itself")
            / analysis.spec.spring.spring.nominal_force();
        assert!((0.3..0.5).contains(&(percent / largest)), "{percent} % of {largest} %");
    }
    // What was measured on real springs holds that part: it is not counted twice.
    let (combined, theory) = alone("kind = \"inductance\"", COLD, "", "calibration form: eq. (13) itself");
    assert_eq!(theory, 0.0);
    close(combined, 0.013 * TRAVEL * K, 1e-9);
}

#[test]
fn an_error_of_reading_of_a_meter_goes_by_the_slope_of_eq_13() {
    let (_, reading) =
        alone(&format!("{NO_FORM}\naccuracy_reading = \"0.1 %\""), COLD, "", "sensor: accuracy of reading");
    // F = k (1/(αL + β) − l0), so dF = k l² α dL in size; the calibration is that of the coil's own theory through mid range.
    let spring = &super::spec(&format!("{S_T}\n")).spring.spring;
    let coil = MaxwellSum::new(spring, SelfDistance::AsPrinted);
    let (length, henry) = (0.230, coil.at_length(0.230));
    let alpha = Calibration::theoretical(spring, &coil, length).unwrap().alpha();
    // Second order in u/l: (u/l)² = 1e-6.
    close(reading, K * length * length * alpha.abs() * henry * 1e-3 / 3.0_f64.sqrt(), 1e-5);
}

#[test]
fn what_contributes_adds_up_as_its_squares_do() {
    let spring = "stiffness_tolerance = \"2 %\"\nrest_length_tolerance = \"0.5 mm\"";
    let keys = [
        "noise = \"0.1 %\"",
        "resolution = \"1 mm\"",
        "accuracy_full_scale = \"0.3 %\"",
        "accuracy_reading = \"0.2 %\"",
        "calibration_uncertainty = \"0.1 %\"",
        "temperature_coefficient = \"0.01 %/K\"",
    ];
    let laser = |keys: &[&str]| format!("kind = \"deflection\"\n{}", keys.join("\n"));
    let (all, _) = alone(&laser(&keys), "", spring, "");
    let limits = keys[..5].iter().map(|key| alone(&laser(&[key]), COLD, "", "").0);
    let tolerances = spring.lines().map(|tolerance| alone(&laser(&[]), COLD, tolerance, "").0);
    // Gain, modulus and rest length drift with one temperature: they add up before they are squared.
    let drift = 10.0 / 3.0_f64.sqrt() * (F * (1e-4 - 348e-6) - 12e-6 * 0.104 * K);
    let squares = limits.chain(tolerances).chain([drift]).map(|u| u * u).sum::<f64>();
    close(all, squares.sqrt(), 1e-6);
}

/// Whether budget and Monte Carlo agree, and the Monte Carlo's standard deviation over the budget's.
fn agreement(condition: &str, sensor: &str) -> (bool, f64) {
    let text = format!(
        "{S_T}\n[mount]\ndamping_ratio = 0\n{condition}[[sensor]]\nname = \"s\"\n{sensor}\n[uncertainty]\n{COLD}\n"
    );
    let analysis = run(&text);
    let budget = &verdict(&analysis, "s").budget;
    (budget.agreement.holds(), budget.standard / budget.budget.combined())
}

#[test]
fn the_monte_carlo_agrees_where_the_model_is_straight_and_normal_and_says_where_not() {
    // u = 1.2 N: two digits allow 0.05 N, where chance moves an end of 100 000 trials by 0.02 N.
    let (agrees, ratio) = agreement(STILL, "kind = \"load-cell\"\nnoise = \"1.2 N\"");
    assert!(agrees && (ratio - 1.0).abs() < 0.01, "{ratio}");
    let (agrees, ratio) =
        agreement(STILL, "kind = \"deflection\"\nnoise = \"1.5 mm\"\ncalibration_uncertainty = \"0.5 %\"");
    assert!(agrees && (ratio - 1.0).abs() < 0.01, "{ratio}");
    // A sine spends its time at its ends: 95 % of it lie within 1.41 u, not 1.96.
    let swing = "[[condition]]\nkind = \"harmonic\"\nfrequency = \"1 f1\"\namplitude = \"0.1 %\"\nstart = \"massless\"\nwindow = [\"0.75 s\", \"1 s\"]\n";
    let (agrees, ratio) = agreement(swing, "kind = \"load-cell\"");
    assert!(!agrees && (ratio - 1.0).abs() < 0.02, "{ratio}");
    // A limit that may lie anywhere ends at 1.73 u.
    assert!(!agreement(STILL, "kind = \"load-cell\"\naccuracy_full_scale = \"1 %\"").0);
    // Ten per cent of L run into the pole of eq. (13): no straight model any more.
    let (agrees, ratio) = agreement(STILL, &format!("{NO_FORM}\ncalibration_uncertainty = \"10 %\""));
    assert!(!agrees && (ratio - 1.0).abs() > 0.02, "{ratio}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn a_further_limit_never_makes_a_sensor_better(
        spring in prop::sample::select(vec![S_T, S_A]),
        kind in prop::sample::select(vec!["load-cell", "deflection", "two-encoder", "inductance"]),
        ratio in 0.0..0.05_f64,
        velocity in 0.0..0.5_f64,
        averaging in 0.5..30.0_f64,
        band in prop::option::of(2.0..500.0_f64),
        share in 0.001..3.0_f64,
    ) {
        let limits = ["", "noise", "resolution", "accuracy_full_scale", "accuracy_reading", "calibration_uncertainty"];
        let sensors = limits.map(|limit| {
            let limited = if limit.is_empty() { String::new() } else { format!("{limit} = \"{share} %\"\n") };
            format!("[[sensor]]\nname = \"s{limit}\"\nkind = \"{kind}\"\naveraging = \"{averaging} ms\"\nnoise = \"0.05 %\"\n").replace(
                "noise = \"0.05 %\"\n", if limit == "noise" { "" } else { "noise = \"0.0005 %\"\n" }) + &limited
        });
        let goal = band.map_or(String::new(), |band| format!("[goal]\nerror = \"1 %\"\nbandwidth = \"{band} Hz\"\n"));
        let condition = format!("[[condition]]\nkind = \"impact\"\nvelocity = \"{velocity} m/s\"\nduration = \"60 ms\"\n");
        let analysis = run(&format!("{spring}\n[mount]\ndamping_ratio = {ratio}\n[uncertainty]\ntrials = 1000\n{condition}{goal}{}", sensors.concat()));
        let least = verdict(&analysis, "s").combined();
        for limit in &limits[1..] {
            let combined = verdict(&analysis, &format!("s{limit}")).combined();
            prop_assert!(combined >= least * (1.0 - 1e-12), "{limit}: {combined} below {least}");
        }
    }
}

#[test]
fn the_mean_error_counts_as_uncertainty_of_who_does_not_correct_for_it() {
    let text = format!("{HEEL_STRIKE}[[sensor]]\nkind = \"inductance\"\nname = \"s\"\n");
    let analysis = undamped(S_T, &text);
    let verdict = verdict(&analysis, "s");
    let budget = &verdict.budget.budget;
    assert!(
        budget.bias() < 0.0,
        "oscillation makes L, which is bent over the windings' places, look longer or shorter: one way only"
    );
    close(verdict.combined(), budget.combined().hypot(budget.bias()), 1e-12);
}
