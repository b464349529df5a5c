//! Budget and Monte Carlo against the worked examples of the GUM and its Supplement 1.
//!
//! | ours | theirs |
//! |---|---|
//! | `Budget::of`, `expanded` | JCGM 100 H.1 (end gauge); JCGM 101 9.2–9.4, columns "GUF" |
//! | `MonteCarlo::run`, `symmetric`, `shortest` | JCGM 101 9.2–9.4, columns "MCM" |
//! | `MonteCarlo::agrees_with` | JCGM 101 9.2, "GUF validated?" |
//! | `coverage_factor` | mpmath 1.3, 25 digits: the incomplete beta function, bisected |

use coilsense::uncertainty::{Budget, Distribution, Input, MonteCarlo, coverage_factor};
use proptest::prelude::*;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

fn normal(name: &'static str, estimate: f64, standard: f64) -> Input {
    Input::new(name, estimate, Distribution::Normal { standard })
}

fn rectangular(name: &'static str, estimate: f64, half_width: f64) -> Input {
    Input::new(name, estimate, Distribution::Rectangular { half_width })
}

/// Asserts that two numbers are within `tolerance`, naming them.
fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} is not {expected} ± {tolerance}");
}

#[test]
fn the_end_gauge_of_h1() {
    // Lengths in nm, l_S = 50 mm + 623 nm, d in its three parts (H.1.3.2).
    let inputs = [
        normal("l_S", 50_000_623.0, 25.0).with_degrees_of_freedom(18.0),
        normal("d, repeated", 215.0, 5.8).with_degrees_of_freedom(24.0),
        normal("d, comparator at random", 0.0, 3.9).with_degrees_of_freedom(5.0),
        normal("d, comparator systematic", 0.0, 6.7).with_degrees_of_freedom(8.0),
        rectangular("alpha_S", 11.5e-6, 2e-6),
        normal("theta, mean", -0.1, 0.2),
        Input::new("theta, cyclic", 0.0, Distribution::Arcsine { half_width: 0.5 }),
        rectangular("delta alpha", 0.0, 1e-6).with_degrees_of_freedom(50.0),
        rectangular("delta theta", 0.0, 0.05).with_degrees_of_freedom(2.0),
    ];
    let gauge = |x: &[f64]| x[0] + x[1] + x[2] + x[3] - x[0] * (x[7] * (x[5] + x[6]) + x[4] * x[8]);
    let budget = Budget::of(gauge, &inputs).unwrap();
    near(budget.estimate(), 50_000_838.0, 1e-6);
    let contribution: Vec<f64> = budget.contributions().iter().map(|c| c.contribution).collect();
    // Table H.1, to its digits.
    for (index, printed) in [(0, 25.0), (4, 0.0), (5, 0.0), (6, 0.0), (7, 2.9), (8, 16.6)] {
        near(contribution[index], printed, 0.05);
    }
    near(contribution[1].hypot(contribution[2]).hypot(contribution[3]), 9.7, 0.05);
    near(budget.combined(), 32.0, 0.5);
    assert_eq!(budget.degrees_of_freedom().floor(), 16.0);
    near(budget.coverage_factor(0.99).unwrap(), 2.92, 0.005);
    // The GUM multiplies with u_c rounded up to 32 nm; unrounded it is 31.7 nm and U 92.5 nm.
    near(budget.coverage_factor(0.99).unwrap() * 32.0, 93.0, 0.5);
    near(budget.expanded(0.99).unwrap(), 92.48, 0.01);
    near(budget.contributions().iter().map(|c| c.share).sum(), 1.0, 1e-14);
}

#[test]
fn student_s_factor_is_that_of_25_digits() {
    for (coverage, freedom, factor) in STUDENT {
        let relative = if freedom <= 1000.0 { 2e-12 } else { 1e-9 };
        // Near full coverage p itself has but 16 digits: 1e-16/(1 − p) of the tail.
        let relative = relative + 1e-15 / (1.0 - coverage);
        near(coverage_factor(coverage, freedom).unwrap() / factor, 1.0, relative);
    }
    // The whole part counts, also where it has rounded to just below.
    assert_eq!(coverage_factor(0.95, 16.7).unwrap(), coverage_factor(0.95, 16.0).unwrap());
    assert_eq!(coverage_factor(0.95, 15.999_999_999_999).unwrap(), coverage_factor(0.95, 16.0).unwrap());
}

/// Four inputs, added (JCGM 101 9.2).
fn sum(x: &[f64]) -> f64 {
    x.iter().sum()
}

#[test]
fn normal_inputs_added_agree() {
    let inputs = ["1", "2", "3", "4"].map(|name| normal(name, 0.0, 1.0));
    let (budget, run) = (Budget::of(sum, &inputs).unwrap(), MonteCarlo::run(sum, &inputs, 1_000_000, 1).unwrap());
    near(budget.expanded(0.95).unwrap(), 3.92, 0.005);
    // Four standard deviations of chance over 1e6 trials.
    near(run.mean(), 0.0, 0.008);
    near(run.standard(), 2.0, 0.006);
    near(run.symmetric(0.95).unwrap().1, 3.92, 0.025);
    let agreement = run.agrees_with(&budget, 2).unwrap();
    assert_eq!(agreement.tolerance, 0.05);
    assert!(agreement.holds(), "{agreement:?}");
}

#[test]
fn rectangles_added_are_narrower_at_95_percent() {
    let inputs = ["1", "2", "3", "4"].map(|name| rectangular(name, 0.0, 3.0_f64.sqrt()));
    let (budget, run) = (Budget::of(sum, &inputs).unwrap(), MonteCarlo::run(sum, &inputs, 1_000_000, 2).unwrap());
    near(budget.combined(), 2.0, 1e-12);
    near(budget.expanded(0.95).unwrap(), 3.92, 0.005);
    near(run.standard(), 2.0, 0.006);
    // 9.2.3.4: the exact end is 2√3 (2 − (3/5)^(1/4)) = 3.88.
    let exact = 2.0 * 3.0_f64.sqrt() * (2.0 - 0.6_f64.powf(0.25));
    near(exact, 3.88, 0.005);
    for (low, high) in [run.symmetric(0.95).unwrap(), run.shortest(0.95).unwrap()] {
        near(high - low, 2.0 * exact, 0.02);
    }
    near(run.symmetric(0.95).unwrap().0, -exact, 0.02);
    // Table 3: two digits let 0.04 pass, three do not.
    assert!(run.agrees_with(&budget, 2).unwrap().holds());
    assert!(!run.agrees_with(&budget, 3).unwrap().holds());
}

#[test]
fn one_wide_rectangle_among_narrow_ones_is_no_normal_distribution() {
    let mut inputs = ["1", "2", "3", "4"].map(|name| rectangular(name, 0.0, 3.0_f64.sqrt()));
    inputs[3].distribution = Distribution::Rectangular { half_width: 10.0 * 3.0_f64.sqrt() };
    let (budget, run) = (Budget::of(sum, &inputs).unwrap(), MonteCarlo::run(sum, &inputs, 1_000_000, 3).unwrap());
    // 9.2.4, table 4.
    near(budget.combined(), 10.1, 0.05);
    near(budget.expanded(0.95).unwrap(), 19.9, 0.05);
    near(run.symmetric(0.95).unwrap().1, 17.0, 0.06);
    let agreement = run.agrees_with(&budget, 2).unwrap();
    assert_eq!(agreement.tolerance, 0.5);
    assert!(!agreement.holds() && agreement.decided(), "{agreement:?}");
}

#[test]
fn a_mass_weighed_in_air_hides_what_is_of_second_order() {
    // 9.3, in mg and kg/m³; deviation from 100 g.
    let inputs = [
        normal("m_R", 100_000.0, 0.050),
        normal("delta m_R", 1.234, 0.020),
        rectangular("rho_a", 1.2, 0.1),
        rectangular("rho_W", 8000.0, 1000.0),
        rectangular("rho_R", 8000.0, 50.0),
    ];
    let mass = |x: &[f64]| (x[0] + x[1]) * (1.0 + (x[2] - 1.2) * (1.0 / x[3] - 1.0 / x[4])) - 100_000.0;
    let (budget, run) = (Budget::of(mass, &inputs).unwrap(), MonteCarlo::run(mass, &inputs, 1_000_000, 4).unwrap());
    // Table 5: GUF1 and MCM.
    near(budget.corrected(), 1.2340, 1e-9);
    near(budget.combined(), 0.0539, 5e-5);
    near(budget.expanded(0.95).unwrap(), (1.3395 - 1.1285) / 2.0, 1e-4);
    near(run.mean(), 1.2341, 4e-4);
    near(run.standard(), 0.0754, 3e-4);
    let (low, high) = run.shortest(0.95).unwrap();
    near(high - low, 1.3825 - 1.0834, 1.5e-3);
    assert!(!run.agrees_with(&budget, 2).unwrap().holds());
}

#[test]
fn at_the_apex_of_a_square_the_budget_sees_nothing() {
    let loss = |x: &[f64]| x[0] * x[0] + x[1] * x[1];
    // 9.4, table 6, in units of 1e-6: where, GUF's y and u, MCM's y, u and shortest interval.
    for (at, y, u, mean, standard, (low, high)) in [
        (0.0, 0.0, 0.0, 50.0, 50.0, (0.0, 150.0)),
        (0.010, 100.0, 100.0, 150.0, 112.0, (0.0, 367.0)),
        (0.050, 2500.0, 500.0, 2551.0, 502.0, (1590.0, 3543.0)),
    ] {
        let inputs = [normal("x1", at, 0.005), normal("x2", 0.0, 0.005)];
        let (budget, run) = (Budget::of(loss, &inputs).unwrap(), MonteCarlo::run(loss, &inputs, 1_000_000, 5).unwrap());
        near(1e6 * budget.corrected(), y, 1e-9);
        near(1e6 * budget.combined(), u, 1e-9);
        near(1e6 * run.mean(), mean, 2.5);
        near(1e6 * run.standard(), standard, 2.5);
        let (first, last) = run.shortest(0.95).unwrap();
        // The ends of a shortest interval are the least sure of all.
        near(1e6 * first, low, 0.02 * high);
        near(1e6 * last, high, 0.02 * high);
        assert!(!run.agrees_with(&budget, 2).unwrap().holds(), "{at}");
    }
}

#[test]
fn each_distribution_is_drawn_with_the_spread_it_states() {
    let seen = Distribution::Empirical(vec![1.0, 2.0, 2.0, 5.0]);
    for distribution in [
        Distribution::Normal { standard: 2.0 },
        Distribution::Rectangular { half_width: 2.0 },
        Distribution::Triangular { half_width: 2.0 },
        Distribution::Arcsine { half_width: 2.0 },
        seen.clone(),
    ] {
        let mut generator = Pcg64::seed_from_u64(6);
        let draws: Vec<f64> = (0..1_000_000).map(|_| distribution.sample(&mut generator)).collect();
        let mean = draws.iter().sum::<f64>() / 1e6;
        let variance = draws.iter().map(|d| (d - mean) * (d - mean)).sum::<f64>() / 1e6;
        // Drawn from n seen deviations, their variance is that over n; the uncertainty is stated over n − 1.
        let population = if distribution == seen { 0.75_f64.sqrt() } else { 1.0 };
        let standard = distribution.standard_uncertainty() * population;
        near(mean, distribution.mean(), 4e-3 * standard);
        near(variance.sqrt() / standard, 1.0, 4e-3);
    }
    assert_eq!(seen.mean(), 2.5);
    near(seen.standard_uncertainty(), 3.0_f64.sqrt(), 1e-15);
}

#[test]
fn a_recognised_effect_is_a_bias_and_no_uncertainty() {
    let late = Input::new("late", 10.0, Distribution::Empirical(vec![0.9, 1.0, 1.1]));
    let budget = Budget::of(|x| 2.0 * x[0], std::slice::from_ref(&late)).unwrap();
    near(budget.estimate(), 20.0, 1e-14);
    near(budget.corrected(), 22.0, 1e-14);
    near(budget.bias(), 2.0, 1e-14);
    near(budget.combined(), 0.2, 1e-14);
    let run = MonteCarlo::run(|x| 2.0 * x[0], &[late], 100_000, 7).unwrap();
    near(run.mean(), 22.0, 3e-3);
}

#[test]
fn a_normal_input_of_few_degrees_of_freedom_is_drawn_after_student() {
    let reading = [normal("mean of five", 0.0, 1.0).with_degrees_of_freedom(4.0)];
    let (budget, run) =
        (Budget::of(|x| x[0], &reading).unwrap(), MonteCarlo::run(|x| x[0], &reading, 1_000_000, 8).unwrap());
    // The budget's k is t_4 and the run's quantile the same: 2.776 both.
    near(budget.expanded(0.95).unwrap(), 2.776, 5e-4);
    near(run.symmetric(0.95).unwrap().1, 2.776, 0.03);
    // S1 6.4.9.5: the standard deviation of t_ν is √(ν/(ν − 2)).
    near(run.standard(), 2.0_f64.sqrt(), 0.02);
}

#[test]
fn the_tolerance_is_half_a_unit_of_the_last_digit() {
    // JCGM 101 7.9.2 gives 0.00035 g (two digits: 5e-6) and 2 K (one digit: 0.5) as examples.
    let tolerance = |standard, digits| {
        let inputs = [normal("x", 0.0, standard)];
        let run = MonteCarlo::run(|x| x[0], &inputs, 1000, 1).unwrap();
        run.agrees_with(&Budget::of(|x| x[0], &inputs).unwrap(), digits).unwrap().tolerance
    };
    near(tolerance(0.00035, 2), 5e-6, 1e-18);
    near(tolerance(2.0, 1), 0.5, 1e-15);
    near(tolerance(9.96, 2), 0.5, 1e-15);
}

#[test]
fn the_same_seed_gives_the_same_run() {
    let inputs = [normal("a", 1.0, 0.1), rectangular("b", 2.0, 0.1)];
    let run = |seed| MonteCarlo::run(sum, &inputs, 1000, seed).unwrap();
    assert_eq!(run(1), run(1));
    assert_ne!(run(1), run(2));
}

#[test]
fn what_is_wrong_is_named_by_its_input() {
    let message = |input: Input| Budget::of(sum, &[input]).unwrap_err().to_string();
    assert_eq!(
        message(normal("stiffness", 1.0, -1.0)),
        "standard uncertainty of stiffness must be finite and not below zero, got -1"
    );
    assert_eq!(message(normal("k", f64::NAN, 1.0)), "estimate of k must be finite, got NaN");
    assert_eq!(
        message(normal("k", 1.0, 1.0).with_degrees_of_freedom(0.5)),
        "degrees of freedom of k must be 1 or above, got 0.5"
    );
    assert_eq!(
        message(Input::new("k", 1.0, Distribution::Empirical(vec![]))),
        "deviations of k must hold at least 1 values, got 0"
    );
    let broken = Budget::of(|x| 1.0 / (x[0] - 1.0), &[normal("k", 0.0, 1.0)]).unwrap_err().to_string();
    assert!(broken.starts_with("output of the model must be finite"), "{broken}");
}

proptest! {
    /// Whatever numbers come in, the answer is an error or numbers.
    #[test]
    fn no_input_gives_a_panic_or_a_silent_nan(
        numbers in prop::collection::vec(prop_oneof![prop::num::f64::ANY, -10.0..10.0], 4),
        freedom in prop_oneof![prop::num::f64::ANY, 1.0..30.0],
        coverage in prop_oneof![prop::num::f64::ANY, 0.0..1.0],
        kind in 0..5,
        digits in 0_u32..20,
    ) {
        let distribution = match kind {
            0 => Distribution::Normal { standard: numbers[0] },
            1 => Distribution::Rectangular { half_width: numbers[0] },
            2 => Distribution::Triangular { half_width: numbers[0] },
            3 => Distribution::Arcsine { half_width: numbers[0] },
            _ => Distribution::Empirical(numbers.clone()),
        };
        let inputs = [Input::new("a", numbers[1], distribution).with_degrees_of_freedom(freedom), normal("b", numbers[2], 1.0)];
        let model = |x: &[f64]| x[0] * x[1] + numbers[3];
        let (budget, run) = (Budget::of(model, &inputs), MonteCarlo::run(model, &inputs, 200, 1));
        if let Ok(budget) = &budget {
            prop_assert!(budget.combined().is_finite() && budget.degrees_of_freedom() >= 0.999);
            if let Ok(factor) = budget.coverage_factor(coverage) {
                prop_assert!(factor.is_finite() && factor >= 0.0);
            }
        }
        if let Ok(run) = &run {
            prop_assert!(run.mean().is_finite() && run.standard().is_finite());
            prop_assert!(run.symmetric(coverage).is_ok() == run.shortest(coverage).is_ok());
            if let Ok(budget) = &budget {
                let _ = run.agrees_at(coverage, budget, digits);
            }
        }
    }
}

/// Coverage, degrees of freedom, factor.
#[rustfmt::skip]
const STUDENT: [(f64, f64, f64); 32] = [
    (0.6827, 1.0, 1.837_409_429_490_546_3), (0.6827, 2.0, 1.321_315_462_445_693), (0.6827, 3.0, 1.196_912_559_971_693_2),
    (0.6827, 16.0, 1.032_264_919_261_904_7), (0.6827, 1000.0, 1.000_521_985_116_369),
    (0.6827, 1001.0, 1.000_521_485_094_704_8), (0.6827, f64::INFINITY, 1.000_021_713_322_999_2),
    (0.95, 1.0, 12.706_204_736_174_705), (0.95, 2.0, 4.302_652_729_749_464), (0.95, 3.0, 3.182_446_305_283_709_5),
    (0.95, 4.0, 2.776_445_105_197_794_3), (0.95, 16.0, 2.119_905_299_221_254_6), (0.95, 50.0, 2.008_559_112_100_761),
    (0.95, 999.0, 1.962_341_461_133_45), (0.95, 1000.0, 1.962_339_080_826_408_5), (0.95, 1001.0, 1.962_336_705_280_88),
    (0.95, 5000.0, 1.960_438_551_706_508), (0.95, f64::INFINITY, 1.959_963_984_540_054_3),
    (0.99, 1.0, 63.656_741_162_871_58), (0.99, 4.0, 4.604_094_871_349_993), (0.99, 16.0, 2.920_781_622_425_1),
    (0.99, 50.0, 2.677_793_270_940_844_3), (0.99, 1001.0, 2.580_749_768_750_525), (0.99, f64::INFINITY, 2.575_829_303_548_901),
    (0.999999, 1.0, 636_619.772_367_057_7), (0.999999, 2.0, 999.999_249_999_843_8), (0.999999, 3.0, 130.154_589_558_357_94),
    (0.999999, 16.0, 7.641_511_326_303_425), (0.999999, 999.0, 4.922_320_372_366_549),
    (0.999999, 1001.0, 4.922_258_736_463_622), (0.999999, 5000.0, 4.897_742_071_585_193),
    (0.999999, f64::INFINITY, 4.891_638_475_698_59),
];
