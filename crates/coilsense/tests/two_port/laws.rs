//! Reciprocity, power, springs in series, resonances, and what a user must not send.

use std::array::from_fn;
use std::f64::consts::{FRAC_PI_2, PI};

use coilsense::two_port::{Load, Matrix, TwoPort};
use coilsense::{Damping, Spring};
use num_complex::Complex64;
use proptest::prelude::*;

use super::paper_springs::{s_a, s_t, s_t_with};
use super::{answers, chain, dampings, distance, unit_spring, wave, with_windings};

#[test]
fn force_runs_through_both_ways_alike() {
    let spring = s_t();
    for damping in dampings(52) {
        for omega in [3.0, 250.0, 2000.0, 12000.0] {
            let ends = chain(&spring, damping.clone(), omega);
            let [[d11, d12], [d21, d22]] = ends.matrix();
            assert_eq!(d12, -d21);
            let load = Complex64::new(500.0, 70.0);
            // End 1 against the load, F_i = K_L U1, and a force in at end 2.
            let backwards = load * d12 / (load * d22 - (d11 * d22 - d12 * d21));
            let forwards = ends.transmittance(&Load::stiffness(load).unwrap());
            // The determinant d11 d22 − d12 d21 cancels around the free–free resonances.
            assert!(distance(forwards, backwards) < 1e-9, "{damping:?} {omega}: {forwards} {backwards}");
        }
    }
}

/// Product of two matrices and, entry by entry, the size of its terms.
fn multiply(a: Matrix, b: Matrix) -> [[(Complex64, f64); 2]; 2] {
    from_fn(|row| {
        from_fn(|column| {
            let terms = [a[row][0] * b[0][column], a[row][1] * b[1][column]];
            (terms[0] + terms[1], terms[0].norm() + terms[1].norm())
        })
    })
}

/// Two matrices are the same but for rounding of the terms they were summed from.
fn assert_same(product: [[(Complex64, f64); 2]; 2], expected: Matrix) {
    for ((product, size), expected) in product.as_flattened().iter().zip(expected.as_flattened()) {
        assert!((product - expected).norm() < 1e-12 * size, "{product} {expected}");
    }
}

#[test]
fn receptance_and_transmission_are_the_same_spring() {
    let unit = [[Complex64::ONE, Complex64::ZERO], [Complex64::ZERO, Complex64::ONE]];
    for damping in dampings(52) {
        for omega in [3.0, 250.0, 2000.0] {
            let ends = chain(&s_t(), damping.clone(), omega);
            let (stiffness, transmission) = (ends.matrix(), ends.transmission());
            assert_same(multiply(stiffness, ends.receptance()), unit);
            // Reciprocity: det T = 1, so T⁻¹ is T with its off-diagonal signs turned.
            let [[a, b], [c, d]] = transmission;
            assert_same(multiply(transmission, [[d, -b], [-c, a]]), unit);
            // U1 = 1, U2 = 0.3: what goes in at end 1 comes out at end 2.
            let [f_i, f_o] = stiffness.map(|row| row[0] + 0.3 * row[1]);
            let ends = [[Complex64::ONE, Complex64::ONE], [f_i, f_i]];
            let out = Complex64::from(0.3);
            assert_same(multiply(transmission, ends), [[out, out], [f_o, f_o]]);
        }
    }
}

#[test]
fn springs_in_series_multiply() {
    // 52 windings are 20 and 32 in series: half a segment on each side of the joint makes a whole one.
    let part = |windings: f64| {
        Spring::new(s_t_with(|p| {
            p.mass *= windings / 52.0;
            p.stiffness *= 52.0 / windings;
            p.windings = windings;
        }))
        .unwrap()
    };
    for damping in [Damping::None, Damping::Hysteretic { loss_factor: 0.04 }] {
        for omega in [3.0, 250.0, 2000.0] {
            let whole = chain(&s_t(), damping.clone(), omega).transmission();
            let first = chain(&part(20.0), damping.clone(), omega).transmission();
            let second = chain(&part(32.0), damping.clone(), omega).transmission();
            assert_same(multiply(second, first), whole);
        }
    }
}

#[test]
fn no_power_comes_out_of_a_spring() {
    for spring in [s_t(), s_a(), with_windings(1), with_windings(2)] {
        let masses = spring.chain_masses();
        for damping in dampings(masses) {
            for step in 0..200 {
                let omega = 0.01 * 1.08_f64.powi(step);
                for ends in [chain(&spring, damping.clone(), omega), wave(&spring, damping.clone(), omega)] {
                    // Im of the eigenvalues of the symmetric form: power of both ends together and apart, times 2/ω|U|².
                    let (drive, transfer) = (ends.drive_point(), ends.transfer());
                    let least = (drive - transfer).im.min((drive + transfer).im);
                    if damping == Damping::None {
                        assert_eq!((drive.im, transfer.im), (0.0, 0.0), "reactive only");
                    }
                    // Rounding of the difference.
                    assert!(least >= -1e-12 * (drive.norm() + transfer.norm()), "{damping:?} {omega}: {least}");
                }
            }
        }
    }
}

#[test]
fn held_transmittance_has_the_fixed_free_poles() {
    let spring = s_t();
    let tau = spring.transit_time();
    for mode in 1..=52 {
        let angle = (mode as f64 - 0.5) * PI;
        let of_wave = wave(&spring, Damping::None, angle / tau);
        let of_chain = chain(&spring, Damping::None, 104.0 / tau * (angle / 104.0).sin());
        for ends in [of_wave, of_chain] {
            // Rounding of ω: the phase of up to 164 to 1e-13, tenfold near the cut-off.
            assert!(ends.transmittance(&Load::HELD).norm() > 1e11, "mode {mode}");
        }
    }
    let hertz = |mode: f64| (mode - 0.5) / (2.0 * tau);
    assert!((hertz(1.0) - 27.03).abs() < 0.01 && (hertz(4.0) - 189.23).abs() < 0.01);
}

/// Zero of a growing function.
fn root(mut low: f64, mut high: f64, function: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if function(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

#[test]
fn an_end_mass_rings_where_the_field_says() {
    let (spring, mass) = (s_t(), 0.2);
    let (tau, ratio) = (spring.transit_time(), spring.mass() / mass);
    let load = Load::mass(mass).unwrap();
    let count = 52.0;
    for mode in 0..20 {
        let start = mode as f64 * PI;
        let beta = root(start, start + FRAC_PI_2, |b| b * b.tan() - ratio);
        let of_wave = wave(&spring, Damping::None, beta / tau).motion_ratio(&load);
        let theta = root(start / count, (start + FRAC_PI_2) / count, |t| count * t.sin() * (count * t).tan() - ratio);
        let omega = 2.0 * count / tau * (0.5 * theta).sin();
        let of_chain = chain(&spring, Damping::None, omega).motion_ratio(&load);
        // 1/|U2/U1| falls to the rounding of a phase of up to 60, times (M/m) phase.
        assert!(of_wave.norm() > 1e9, "mode {mode}: {of_wave}");
        assert!(of_chain.norm() > 1e9, "mode {mode}: {of_chain}");
    }
    // One above cut-off, for an end mass that is lighter than half a winding.
    let light = spring.mass() / count / 8.0;
    let phi = root(1e-6, 20.0, |f| count * f.sinh() * (count * f).tanh() - spring.mass() / light);
    let above = chain(&spring, Damping::None, 2.0 * count / tau * (0.5 * phi).cosh());
    let resonant = above.drive_point() - light * (2.0 * count / tau * (0.5 * phi).cosh()).powi(2);
    assert!(resonant.norm() < 1e-12 * above.drive_point().norm(), "{resonant}");
}

#[test]
fn unsound_input_is_named() {
    let refused = |damping: Damping| TwoPort::chain(&s_t(), damping).unwrap_err().to_string();
    let infinite = Damping::StiffnessProportional { time: f64::INFINITY };
    for (damping, end) in [
        (Damping::Modal(f64::NAN), ", got NaN"),
        (Damping::Modal(2e12), "damping ratio must be at most 1e12, got 2000000000000"),
        (Damping::MassProportional { rate: -2.0 }, ", got -2 1/s"),
        (infinite, ", got inf s"),
        (Damping::Hysteretic { loss_factor: -0.1 }, ", got -0.1"),
        (Damping::ModalEach(vec![0.1; 3]), "damping ratios must hold 52 values, got 3"),
    ] {
        let message = refused(damping);
        assert!(message.ends_with(end), "{message}");
    }
    let none = TwoPort::wave(&s_t(), Damping::ModalEach(Vec::new())).unwrap_err();
    assert_eq!(none.to_string(), "damping ratios must hold at least 1 values, got 0");
    for omega in [f64::NAN, f64::INFINITY, 1e200] {
        let error = TwoPort::wave(&s_t(), Damping::None).unwrap().at(omega).unwrap_err();
        assert!(error.to_string().starts_with("angular frequency must be finite"), "{error}");
    }
    assert!(Load::stiffness(Complex64::new(0.0, f64::NAN)).is_err());
    assert!(Load::mass(f64::INFINITY).is_err());
}

proptest! {
    #[test]
    fn nothing_sound_gives_nan(
        windings in 1_usize..70,
        kind in 0_usize..7,
        scale in -12.0_f64..12.0,
        exponent in -300.0_f64..11.9,
        end_mass in 0.0_f64..10.0,
    ) {
        let value = 10_f64.powf(scale);
        let damping = match kind {
            0 => Damping::None,
            1 => Damping::Modal(value),
            2 => Damping::MassProportional { rate: value },
            3 => Damping::StiffnessProportional { time: value },
            4 => Damping::Hysteretic { loss_factor: value },
            _ => Damping::ModalEach(vec![value; windings]),
        };
        let spring = unit_spring(windings);
        let omega = 10_f64.powf(exponent);
        let mass = Load::mass(end_mass).unwrap();
        for ends in [chain(&spring, damping.clone(), omega), wave(&spring, damping.clone(), omega)] {
            for answer in answers(&ends).into_iter().chain([ends.loaded(&mass), ends.transmittance(&mass)]) {
                prop_assert!(!answer.is_nan(), "{:?} {} {:?}", damping, omega, ends);
            }
        }
        let there = chain(&spring, damping.clone(), omega);
        let mirrored = chain(&spring, damping, -omega);
        prop_assert_eq!(there.drive_point().conj(), mirrored.drive_point());
    }
}
