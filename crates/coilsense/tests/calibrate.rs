//! Fits of length to inductance.
//!
//! | ours | theirs |
//! |---|---|
//! | `InverseLengthFit`, `InductanceFit` | curves that are known exactly; a Monte Carlo run of the noise that the standard errors are for |
//! | `InverseLengthFit` through a preload | `Calibration::through`, itself against mpmath in `golden.rs` |
//! | `Inversion::Exact` | the theory put in again |

use coilsense::Calibration;
use coilsense::calibrate::{
    CalibrationPoints, FitMethod, InductanceFit, InverseLengthFit, Inversion, Misfit, ReadingUncertainty,
};
use coilsense::inductance::theories::{Coil, Theory};
use rand_distr::{Distribution, Normal};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

/// α \[H m\] and β \[H\] near those of a measured spring.
const ALPHA: f64 = 4.6e-7;
const BETA: f64 = 9.5e-8;

fn relative(ours: f64, theirs: f64) -> f64 {
    (ours / theirs - 1.0).abs()
}

/// Eleven lengths from 0.12 to 0.18 m.
fn lengths() -> Vec<f64> {
    (0..11).map(|index| 0.12 + 0.006 * f64::from(index)).collect()
}

/// Their inductances, exactly on a curve.
fn inductances() -> Vec<f64> {
    lengths().iter().map(|length| ALPHA / length + BETA).collect()
}

fn exact() -> CalibrationPoints {
    CalibrationPoints::new(&lengths(), &inductances()).unwrap()
}

fn methods() -> [FitMethod; 4] {
    [
        FitMethod::first_and_last(&exact()),
        FitMethod::TwoPoints { first: 7, last: 2 },
        FitMethod::AllPoints,
        FitMethod::Through { length: 0.15, inductance: ALPHA / 0.15 + BETA },
    ]
}

#[test]
fn every_method_finds_the_curve_that_the_points_lie_on() {
    for method in methods() {
        let fit = InductanceFit::new(&exact(), method).unwrap();
        assert!(relative(fit.alpha, ALPHA) < 1e-12 && relative(fit.beta, BETA) < 1e-12, "{method:?}: {fit:?}");
        let other = InverseLengthFit::new(&exact(), method).unwrap();
        assert!(relative(other.alpha, 1.0 / ALPHA) < 1e-12, "{method:?}: {other:?}");
        assert!(relative(other.beta, -BETA / ALPHA) < 1e-12, "{method:?}: {other:?}");
        for misfit in [&fit.misfit, &other.misfit] {
            assert!(1.0 - misfit.r2 < 1e-14 && misfit.rmse < 1e-15 && misfit.residuals.len() == 11);
        }
        // Both as a sensor sees them.
        for calibration in [fit.calibration(), other.calibration()] {
            assert!(relative(calibration.length(ALPHA / 0.17 + BETA), 0.17) < 1e-13);
            assert!(relative(calibration.inductance(0.17), ALPHA / 0.17 + BETA) < 1e-12);
        }
        let two = matches!(method, FitMethod::TwoPoints { .. });
        assert_eq!(fit.alpha_se.is_none() && fit.beta_se.is_none() && fit.degrees_of_freedom == 0, two);
        assert_eq!(other.alpha_se.is_none() && other.beta_se.is_none() && other.degrees_of_freedom == 0, two);
    }
}

#[test]
fn degrees_of_freedom_are_the_points_beyond_those_that_fix_the_fit() {
    let on = FitMethod::Through { length: lengths()[4], inductance: inductances()[4] };
    let beside = FitMethod::Through { length: lengths()[4], inductance: 1.01 * inductances()[4] };
    for (method, expected) in [(FitMethod::AllPoints, 9), (on, 9), (beside, 10)] {
        assert_eq!(InductanceFit::new(&exact(), method).unwrap().degrees_of_freedom, expected, "{method:?}");
        assert_eq!(InverseLengthFit::new(&exact(), method).unwrap().degrees_of_freedom, expected, "{method:?}");
    }
    let two = CalibrationPoints::new(&lengths()[..2], &inductances()[..2]).unwrap();
    assert_eq!(InductanceFit::new(&two, FitMethod::AllPoints).unwrap().alpha_se, None);
}

#[test]
fn through_a_preload_eq_13_is_the_calibration_that_sensors_use() {
    let henries: Vec<f64> =
        inductances().iter().enumerate().map(|(i, l)| l * (1.0 + 1e-3 * (i as f64).sin())).collect();
    let points = CalibrationPoints::new(&lengths(), &henries).unwrap();
    let (length, inductance) = (0.15, 3.1e-6);
    let fit = InverseLengthFit::new(&points, FitMethod::Through { length, inductance }).unwrap();
    assert_eq!(fit.calibration(), Calibration::through((length, inductance), &lengths(), &henries).unwrap());
    assert!(relative(fit.calibration().length(inductance), length) < 1e-15);
}

#[test]
fn least_squares_leave_less_than_any_other_curve_in_the_quantity_that_they_square() {
    let henries: Vec<f64> =
        inductances().iter().enumerate().map(|(i, l)| l * (1.0 + 1e-2 * (3.0 * i as f64).sin())).collect();
    let points = CalibrationPoints::new(&lengths(), &henries).unwrap();
    let of_l = InductanceFit::new(&points, FitMethod::AllPoints).unwrap();
    let of_inverse = InverseLengthFit::new(&points, FitMethod::AllPoints).unwrap();
    for method in methods() {
        // R² is of L: what fits L best has the largest.
        assert!(of_l.misfit.r2 >= InductanceFit::new(&points, method).unwrap().misfit.r2);
        assert!(of_l.misfit.r2 >= InverseLengthFit::new(&points, method).unwrap().misfit.r2);
    }
    let squares = |calibration: Calibration| -> f64 {
        let pairs = lengths().into_iter().zip(&henries);
        pairs.map(|(l, henry)| (1.0 / l - 1.0 / calibration.length(*henry)).powi(2)).sum()
    };
    assert!(squares(of_inverse.calibration()) < squares(of_l.calibration()));
}

/// Means of u(α)², u(β)² and variances of α, β over many draws of noise: `fit` gives α, u(α), β, u(β) of a draw.
fn monte_carlo(noise: f64, fit: impl Fn(&[f64]) -> [f64; 4]) -> [[f64; 2]; 2] {
    let trials = 20_000;
    let mut generator = Pcg64::seed_from_u64(7);
    let normal = Normal::new(0.0, noise).unwrap();
    let draws: Vec<[f64; 4]> = (0..trials)
        .map(|_| {
            let errors: Vec<f64> = lengths().iter().map(|_| normal.sample(&mut generator)).collect();
            fit(&errors)
        })
        .collect();
    let mean = |value: &dyn Fn(&[f64; 4]) -> f64| draws.iter().map(value).sum::<f64>() / f64::from(trials);
    [0, 2].map(|place| {
        let centre = mean(&|draw| draw[place]);
        [mean(&|draw| draw[place + 1].powi(2)).sqrt(), mean(&|draw| (draw[place] - centre).powi(2)).sqrt()]
    })
}

#[test]
fn standard_errors_are_the_scatter_of_repeated_runs() {
    let through = FitMethod::Through { length: 0.15, inductance: ALPHA / 0.15 + BETA };
    for method in [FitMethod::AllPoints, through] {
        // A meter's noise of 2 nH.
        let of_l = monte_carlo(2e-9, |errors| {
            let henries: Vec<f64> = inductances().iter().zip(errors).map(|(l, error)| l + error).collect();
            let fit = InductanceFit::new(&CalibrationPoints::new(&lengths(), &henries).unwrap(), method).unwrap();
            [fit.alpha, fit.alpha_se.unwrap(), fit.beta, fit.beta_se.unwrap()]
        });
        // Lengths that scatter by 0.1 mm, as 1/l.
        let of_inverse = monte_carlo(4e-3, |errors| {
            let metres: Vec<f64> = lengths().iter().zip(errors).map(|(l, error)| 1.0 / (1.0 / l + error)).collect();
            let fit = InverseLengthFit::new(&CalibrationPoints::new(&metres, &inductances()).unwrap(), method).unwrap();
            [fit.alpha, fit.alpha_se.unwrap(), fit.beta, fit.beta_se.unwrap()]
        });
        for [stated, scatter] in of_l.into_iter().chain(of_inverse) {
            println!("{method:?}: stated {stated:e}, scatter {scatter:e}");
            // The scatter of 20 000 draws is itself known to 0.5 %.
            assert!(relative(stated, scatter) < 0.02);
        }
    }
}

#[test]
fn the_uncertainty_of_a_reading_is_the_scatter_of_readings_about_fits() {
    // One more reading, at the edge of the range, where leverage is largest.
    let next = ALPHA / 0.118 + BETA;
    let normal = Normal::new(0.0, 4e-3).unwrap();
    for method in methods() {
        let mut generator = Pcg64::seed_from_u64(11);
        let (mut stated, mut scatter) = (0.0, 0.0);
        for _ in 0..20_000 {
            let mut noisy = |length: f64| 1.0 / (1.0 / length + normal.sample(&mut generator));
            let metres: Vec<f64> = lengths().into_iter().map(&mut noisy).collect();
            let its_length = noisy(0.118);
            let points = CalibrationPoints::new(&metres, &inductances()).unwrap();
            let reading = ReadingUncertainty::new(&points, method).unwrap().unwrap();
            let read = InverseLengthFit::new(&points, method).unwrap().calibration().length(next);
            stated += reading.length(next).powi(2);
            scatter += (read - its_length).powi(2);
            assert_eq!(reading.degrees_of_freedom(), if matches!(method, FitMethod::Through { .. }) { 10 } else { 9 });
        }
        println!("{method:?}: stated {:e}, scatter {:e}", (stated / 2e4).sqrt(), (scatter / 2e4).sqrt());
        // The scatter of 20 000 draws is itself known to 0.5 %.
        assert!(relative(stated.sqrt(), scatter.sqrt()) < 0.02, "{method:?}");
    }
    let two = CalibrationPoints::new(&lengths()[..2], &inductances()[..2]).unwrap();
    assert_eq!(ReadingUncertainty::new(&two, FitMethod::first_and_last(&two)).unwrap(), None);
}

#[test]
fn a_misfit_counts_in_metres_and_in_shares_of_the_range() {
    let points = CalibrationPoints::new(&[0.3, 0.1, 0.2], &[1.0, 3.0, 2.0]).unwrap();
    let misfit = Misfit::of(&points, &[1.0, 3.0, 3.0], &[0.3, 0.1, 0.23]).unwrap();
    assert!((misfit.r2 - 0.5).abs() < 1e-15); // 1 of 2
    assert!(relative(misfit.rmse, 0.03 / 3.0_f64.sqrt()) < 1e-12);
    assert!(relative(misfit.rmse_share_of_range, misfit.rmse / 0.2) < 1e-12);
    assert!(misfit.residuals[0] == 0.0 && relative(misfit.residuals[2], 0.03) < 1e-12);
    assert!(Misfit::of(&points, &[1.0; 2], &[0.3; 3]).is_err());
    assert!(Misfit::of(&points, &[1.0; 3], &[0.3, f64::INFINITY, 0.1]).is_err());
}

#[test]
fn a_theory_turned_round_gives_its_length_back() {
    let coil = Coil::new(41.904, 8.47e-3, 1.41e-3).unwrap();
    for theory in Theory::ALL {
        let relation = |length: f64| theory.inductance(&coil, length);
        for (length, near) in [(0.13, 0.13), (0.13, 0.12), (0.13, 0.2), (0.19, 0.13), (0.13, 0.13 * (1.0 + 1e-12))] {
            let ours = Inversion::Exact.length(relation, relation(length), near).unwrap();
            // L falls about as 1/l, so rounding of L shows as it is; the helix rounds to 1e-15.
            assert!(relative(ours, length) < 2e-14, "{} at {length} from {near}: {ours}", theory.name());
        }
        // Straight lines meet the curve at the 25 lengths and leave it between by (step)²/8 of its curvature.
        let interpolated = Inversion::TwentyFiveLengths { zero_length: 0.118 };
        let knot = 0.118 * (1.0 + 0.55 * 5.0 / 24.0);
        assert!(relative(interpolated.length(relation, relation(knot), 1.0).unwrap(), knot) < 1e-13);
        let between = interpolated.length(relation, relation(knot + 1.35e-3), 1.0).unwrap() - knot - 1.35e-3;
        assert!((1e-6..2e-5).contains(&between), "{}: {between:e}", theory.name());
    }
}

#[test]
fn lines_are_prolonged_beyond_the_25_lengths() {
    let line = |length: f64| 5e-6 - 1e-5 * length;
    let inversion = Inversion::TwentyFiveLengths { zero_length: 0.1 };
    for length in [0.05, 0.1, 0.13, 0.155, 0.3] {
        assert!((inversion.length(line, line(length), 1.0).unwrap() - length).abs() < 1e-14);
    }
}

#[test]
fn what_a_theory_does_not_reach_is_said() {
    let text = |result: Result<f64, coilsense::Error>| result.unwrap_err().to_string();
    // Rosa's correction grows with the pitch: L has a minimum, below which there is no length.
    let coil = Coil::new(20.0, 8e-3, 1e-3).unwrap();
    let rosa = |length: f64| Theory::NagaokaRosa.inductance(&coil, length);
    assert_eq!(
        text(Inversion::Exact.length(rosa, 1e-8, 0.1)),
        "inductance must be one that the theory reaches while it falls with length from 0.1 m, got 0.00000001 H"
    );
    let rising = |length: f64| 1e-6 * length;
    assert!(Inversion::Exact.length(rising, 2e-7, 0.1).is_err());
    assert!(text(Inversion::TwentyFiveLengths { zero_length: 0.1 }.length(rising, 2e-7, 0.1)).contains("falling"));
    for near in [0.0, -1.0, f64::NAN] {
        assert!(Inversion::Exact.length(rosa, 1e-6, near).is_err());
        assert!(Inversion::TwentyFiveLengths { zero_length: near }.length(rosa, 1e-6, 0.1).is_err());
    }
    assert!(Inversion::Exact.length(rosa, f64::NAN, 0.1).is_err());
    assert!(Inversion::Exact.length(|_| f64::NAN, 1e-6, 0.1).is_err());
    assert!(Inversion::Exact.length(|length| 1.0 / length, 0.0, 0.1).is_err());
}

#[test]
fn bad_points_are_named() {
    let text = |lengths: &[f64], henries: &[f64]| CalibrationPoints::new(lengths, henries).unwrap_err().to_string();
    assert_eq!(text(&[0.1], &[1e-6]), "calibration points must hold at least 2 values, got 1");
    assert_eq!(text(&[0.1, 0.2], &[1e-6]), "inductances must hold 2 values, got 1");
    assert_eq!(text(&[0.1, 0.0], &[1e-6, 2e-6]), "lengths[1] must be above zero and finite, got 0 m");
    assert_eq!(text(&[0.1, 0.2], &[1e-6, f64::NAN]), "inductances[1] must be finite, got NaN H");
    assert_eq!(text(&[0.1, 0.1], &[1e-6, 2e-6]), "range of the lengths must be above zero, got 0 m");
    assert_eq!(text(&[0.1, 0.2], &[1e-6, 1e-6]), "range of the inductances must be above zero, got 0 H");
}

#[test]
fn bad_methods_are_named() {
    let text = |method| InverseLengthFit::new(&exact(), method).unwrap_err().to_string();
    assert_eq!(text(FitMethod::TwoPoints { first: 0, last: 11 }), "point of the fit must be an index below 11, got 11");
    assert!(text(FitMethod::TwoPoints { first: 3, last: 3 }).contains("another pair than the first point's"));
    let preload = |length, inductance| text(FitMethod::Through { length, inductance });
    assert_eq!(preload(-0.1, 1e-6), "preload length must be above zero and finite, got -0.1 m");
    assert_eq!(preload(0.1, f64::NAN), "preload inductance must be finite, got NaN H");
    // A pole among the points: three that no such curve fits.
    let points = CalibrationPoints::new(&[0.1, 0.2, 0.3], &[2e-6, -2e-6, 2e-6]).unwrap();
    for method in [FitMethod::AllPoints, FitMethod::TwoPoints { first: 0, last: 2 }] {
        let _ = InductanceFit::new(&points, method);
        let _ = InverseLengthFit::new(&points, method);
    }
}
