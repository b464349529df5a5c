//! Where two models meet: chain and wave, rest, eq. (1), poles and far above cut-off.

use std::f64::consts::PI;

use coilsense::two_port::{Load, TwoPort};
use coilsense::{Damping, transmittance};
use num_complex::Complex64;

use super::paper_springs::{s_a, s_t};
use super::{answers, chain, dampings, distance, unit_spring, wave, with_windings};

#[test]
fn the_wave_is_the_limit_of_the_chain_at_second_order() {
    // An S_T of ever more windings at 20, 70 and 130 Hz; ratios alike in all modes, so that both mean the same spring.
    let kinds = [
        Damping::None,
        Damping::Modal(0.01),
        Damping::ModalEach(vec![0.01; 1]),
        Damping::MassProportional { rate: 12.5 },
        Damping::StiffnessProportional { time: 3e-5 },
        Damping::Hysteretic { loss_factor: 0.04 },
    ];
    for kind in kinds {
        for hertz in [20.0, 70.0, 130.0] {
            let omega = 2.0 * PI * hertz;
            let limit = wave(&s_t(), kind.clone(), omega);
            let gap = |windings: usize| {
                let kind = match &kind {
                    Damping::ModalEach(ratios) => Damping::ModalEach(vec![ratios[0]; windings]),
                    other => other.clone(),
                };
                let near = chain(&with_windings(windings), kind, omega);
                [distance(near.drive_point(), limit.drive_point()), distance(near.transfer(), limit.transfer())]
            };
            for (coarse, fine) in gap(400).into_iter().zip(gap(800)) {
                let order = (coarse / fine).log2();
                // The next term of the series is 1e-3 of the first here. With one ratio for all modes the damping of the high
                // ones sums to ln(N)/N², not 1/N²: up to 1/ln 400 less.
                let modal = matches!(kind, Damping::Modal(_) | Damping::ModalEach(_));
                let least = if modal { 1.8 } else { 1.995 };
                assert!((least..2.005).contains(&order), "{kind:?} at {hertz} Hz: order {order}");
            }
        }
    }
}

#[test]
fn at_rest_it_is_the_static_spring_and_first_feels_a_third_of_its_mass() {
    for spring in [s_t(), s_a(), with_windings(1), with_windings(2)] {
        let (masses, k) = (spring.chain_masses(), spring.stiffness());
        for damping in dampings(masses) {
            let count = masses as f64;
            let media = [
                (TwoPort::chain(&spring, damping.clone()).unwrap(), (count * count).recip()),
                (TwoPort::wave(&spring, damping.clone()).unwrap(), 0.0),
            ];
            for (two_port, spread) in media {
                let rest = two_port.at(0.0).unwrap();
                assert_eq!((rest.drive_point(), rest.transfer()), (k.into(), k.into()));
                assert_eq!(rest.transmittance(&Load::HELD), Complex64::ONE);
                let end_mass = rest.transmittance(&Load::mass(0.1).unwrap());
                assert!(distance(end_mass, (0.1 / (0.1 + spring.mass())).into()) < 1e-15);
                for omega in [1e-9, 1e-100] {
                    let slow = two_port.at(omega).unwrap();
                    let unit = spring.mass() * omega * omega;
                    let (drive, transfer) = (slow.drive_point_inertia() / unit, slow.transfer_inertia() / unit);
                    // Next terms: ζω/ω_1 and α ω τ², below 1e-10 here.
                    assert!(distance(drive, Complex64::from(-1.0 / 3.0 + spread / 12.0)) < 1e-10, "{damping:?}");
                    assert!(distance(transfer, Complex64::from(1.0 / 6.0 + spread / 12.0)) < 1e-10, "{damping:?}");
                }
            }
        }
    }
}

#[test]
fn transmittance_is_that_of_eq_1_and_of_its_chain() {
    for spring in [s_t(), s_a(), with_windings(1), with_windings(3)] {
        let (masses, tau) = (spring.chain_masses(), spring.transit_time());
        for step in 1..400 {
            let omega = step as f64 * 0.0071 * 2.0 * masses as f64 / tau;
            let pairs = [
                (chain(&spring, Damping::None, omega), transmittance::chain(masses, tau, omega)),
                (wave(&spring, Damping::None, omega), transmittance::continuous(tau, omega)),
            ];
            for (ends, plain) in pairs {
                let ours = ends.transmittance(&Load::HELD).re;
                // Both round a phase of up to 300: 1e-14 of it, more beside a pole (|T| large).
                let tolerance = 1e-12 * (1.0 + plain.abs());
                assert!((ours / plain - 1.0).abs() < tolerance, "{masses} {omega}: {ours} {plain}");
            }
        }
    }
}

#[test]
fn a_pole_hit_exactly_is_infinite_and_its_ratios_are_not() {
    for windings in [1, 2, 3, 52] {
        // τ = 1 s, so 2N rad/s is the last mode and the cut-off, to the bit.
        let ends = chain(&unit_spring(windings), Damping::None, 2.0 * windings as f64);
        assert_eq!(ends.drive_point().re.abs(), f64::INFINITY);
        let sign = if windings % 2 == 0 { 1.0 } else { -1.0 };
        assert_eq!(ends.transmittance(&Load::HELD), Complex64::from(sign));
        let (load, mass) = (Load::stiffness(2.0.into()).unwrap(), Load::mass(0.5).unwrap());
        let beside = chain(&unit_spring(windings), Damping::None, 2.0 * windings as f64 * (1.0 - 1e-12));
        let pairs = [
            (ends.transmittance(&load), beside.transmittance(&load)),
            (ends.transmittance(&mass), beside.transmittance(&mass)),
            (ends.motion_ratio(&load), beside.motion_ratio(&load)),
            (ends.loaded(&load), beside.loaded(&load)),
            (ends.receptance()[0][1], beside.receptance()[0][1]),
            (ends.transmission()[1][0], beside.transmission()[1][0]),
        ];
        for (at, near) in pairs {
            // 1e-12 of ω, times the slope of up to N² there.
            assert!(distance(near, at) < 1e-7, "{windings}: {at} {near}");
        }
    }
}

#[test]
fn many_windings_far_above_cut_off_do_not_overflow() {
    let spring = with_windings(100_000);
    let cut_off = 2e5 / spring.transit_time();
    for damping in dampings(100_000) {
        for factor in [1e-9, 0.3, 0.999, 1.0, 1.001, 3.0, 1e5] {
            let ends = chain(&spring, damping.clone(), factor * cut_off);
            let shown = answers(&ends);
            assert!(shown.iter().all(|answer| !answer.is_nan()), "{damping:?} {factor}: {shown:?}");
        }
    }
    let still = chain(&spring, Damping::None, 3.0 * cut_off);
    assert_eq!(still.transfer(), Complex64::ZERO);
    // Only the end segments yield: k_d = 2Nk s/√(s² − 1), s = ω / cut-off.
    let end_segments = 2e5 * spring.stiffness() * 3.0 / 8.0_f64.sqrt();
    assert!((still.drive_point().re / end_segments - 1.0).abs() < 1e-12);
}
