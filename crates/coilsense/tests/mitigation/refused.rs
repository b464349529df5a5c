//! What cannot be designed is refused in a line that names the quantity, its value and what is allowed.

use coilsense::mitigation::{
    BankDesign, Coefficients, KalmanNoise, Rounding, SampledSpring, ToleranceBox, WindowDesign, delay_line_observer,
    double_mean, inductance_fusion, low_pass, modal_kalman, notch, observer_bank, steady_covariance, surge_comb,
    surge_notches, surge_window,
};
use coilsense::{Damping, Error};
use coilsense_rt::Biquad;
use nalgebra::{DMatrix, DVector};

use super::{paper_springs, sampled};

fn told<T>(result: Result<T, Error>) -> String {
    result.err().map_or_else(|| "taken".to_owned(), |error| error.to_string())
}

const NOISE: KalmanNoise = KalmanNoise { force: 0.24, shock: 0.1, ringing: 0.5, drift: 0.1 };

#[test]
fn a_sampling_rate_below_twice_the_surge_frequency_is_refused() {
    let spring = paper_springs::s_t();
    let with = |rate| told(SampledSpring::new(&spring, &Damping::None, rate));
    let text = "sampling rate must be above twice the first surge frequency of 54.065 Hz, got 100 Hz";
    assert_eq!(with(100.0), text);
    assert_eq!(with(0.0), "sampling rate must be above zero and finite, got 0 Hz");
    assert!(with(f64::NAN).starts_with("sampling rate must be"));
    let overdamped = told(SampledSpring::new(&spring, &Damping::Modal(1.0), 2500.0));
    assert_eq!(overdamped, "damping ratio of mode 1 must be below 1, for there is no ringing to mitigate, got 1");
}

#[test]
fn filters_that_cannot_be_are_refused() {
    let spring = sampled();
    let half = "above zero and below half of the sampling rate of 2500 Hz";
    assert_eq!(told(low_pass(2, 0.0, 2500.0)), format!("cut-off must be {half}, got 0 Hz"));
    assert_eq!(told(low_pass(2, 1250.0, 2500.0)), format!("cut-off must be {half}, got 1250 Hz"));
    assert_eq!(told(low_pass(9, 10.0, 2500.0)), "order must be from 1 to 8, got 9");
    assert_eq!(told(notch(-1.0, 2.0, 2500.0)), format!("notch frequency must be {half}, got -1 Hz"));
    assert!(told(notch(1000.0, 0.5, 2500.0)).starts_with("notch quality must be above 0.8 at this"));
    assert!(told(surge_notches(&spring, 24, 2.0)).starts_with("number of notches must be from 1 to 23"));
    assert!(told(surge_comb(&spring, 60.0)).starts_with("notch width must be above zero and at most"));
    assert!(told(double_mean(&spring, 0.5)).starts_with("spread of the means must be from 0 to below 0.5"));
    let text = "crossover must be above zero and below half of the sampling rate of 1 Hz, got 1 Hz";
    assert_eq!(told(inductance_fusion(1.0, 1.0, 0.0, 2500.0)), text);
}

#[test]
fn unstable_filters_and_riccati_equations_without_an_answer_are_refused() {
    let unstable = [Biquad { b0: 1.0, b1: 0.0, b2: 0.0, a1: -3.0, a2: 2.0 }];
    assert_eq!(
        told(Coefficients::checked(&unstable, Rounding::Double)),
        "pole radius of section 1 as stored must be below 1, got 2"
    );
    // An unstable mode that is not seen.
    let (phi, seen) = (DMatrix::from_diagonal_element(1, 1, 1.5), DVector::from_element(1, 0.0));
    let text = told(steady_covariance(&phi, &seen, &DMatrix::from_element(1, 1, 1.0), 1.0));
    assert!(text.starts_with("covariance of the estimate must be bounded"), "{text}");
    // A bias that nothing moves: its gain is zero, and an offset at the beginning stays for ever.
    let (phi, seen) = (DMatrix::from_element(1, 1, 1.0), DVector::from_element(1, 1.0));
    let text = told(steady_covariance(&phi, &seen, &DMatrix::from_element(1, 1, 0.0), 1.0));
    assert!(text.starts_with("covariance of the estimate must be bounded"), "{text}");
}

#[test]
fn observers_and_boxes_that_cannot_be_are_refused() {
    let spring = sampled();
    assert_eq!(
        told(ToleranceBox::new(0.0, 0.0)),
        "stiffness tolerance plus mass tolerance must be above zero: the box is empty, got 0"
    );
    assert_eq!(told(ToleranceBox::new(0.1, 1.0)), "mass tolerance must be from 0 to below 1, got 1");
    assert_eq!(told(delay_line_observer(&spring, 1.5)), "observer gain must be from 0 to 1, got 1.5");
    let silent = KalmanNoise { force: 0.0, ..NOISE };
    assert_eq!(told(modal_kalman::<3>(&spring, &silent)), "noise of the force must be above zero and finite, got 0 N");
    assert!(told(modal_kalman::<40>(&spring, &NOISE)).starts_with("number of modes must be from 1 to"));
    let tolerances = ToleranceBox::new(0.1, 0.1).unwrap();
    let design = BankDesign { noise: NOISE, stiffnesses: 1, memory: 1e-6, sharpness: 1.0 };
    let text = told(observer_bank::<3, 5>(&spring, &tolerances, &design));
    assert_eq!(text, "memory of the bank must be at least 0.0004 s, got 0.000001 s");
    let uneven = BankDesign { stiffnesses: 2, memory: 0.1, ..design };
    let text = told(observer_bank::<3, 5>(&spring, &tolerances, &uneven));
    let expected =
        "stiffnesses of the bank must be 1 or more, so that 5 members have two frequencies or more at each, got 2";
    assert_eq!(text, expected);
    let window =
        WindowDesign { impact: 0.25, interval: 2.0, bandwidth: 0.0, motion: 1.0, noise: 0.24, tolerances: None };
    assert!(told(surge_window::<64>(&spring, &window)).starts_with("bandwidth must be above zero and below the first"));
}
