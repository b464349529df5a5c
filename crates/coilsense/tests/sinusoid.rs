//! The frequency at which a record moves: found, with its interval, or said to be none.

use std::f64::consts::TAU;

use coilsense::measures::{Sinusoid, alias_of};
use rand::{RngExt, SeedableRng};
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;

fn found(rate: f64, samples: usize, of: impl FnMut(f64) -> f64) -> Option<Sinusoid> {
    let times: Vec<f64> = (0..samples).map(|index| 3.0 + index as f64 / rate).collect();
    let values: Vec<f64> = times.iter().copied().map(of).collect();
    Sinusoid::of(&times, &values).unwrap()
}

#[test]
fn a_sine_without_noise_is_found_to_rounding_and_a_rounded_clock_does_not_matter() {
    for frequency in [0.7, 5.0, 26.966, 27.5, 199.3] {
        let sine = found(500.0, 4000, |time| 0.2 + 0.01 * time + 3e-3 * (TAU * frequency * time + 1.0).sin()).unwrap();
        assert!((sine.frequency / frequency - 1.0).abs() < 1e-9, "{frequency}: {sine:?}");
        assert!(sine.harmonic == 1 && sine.share > 0.98 && sine.half_width < 1e-6, "{sine:?}");
    }
    let times: Vec<f64> = (0..3000).map(|index| (f64::from(index) / 300.0 * 1e3).round() / 1e3).collect();
    let values: Vec<f64> = times.iter().map(|time| (TAU * 12.0 * time).sin()).collect();
    // Stamps to the millisecond are off by up to 13° of that sine, and by nothing in the long run.
    assert!((Sinusoid::of(&times, &values).unwrap().unwrap().frequency - 12.0).abs() < 1e-3);
}

#[test]
fn the_interval_of_a_frequency_holds_it_as_often_as_it_says() {
    for (noise, samples) in [(0.1, 2000), (0.5, 2000), (1.0, 8000)] {
        const SEEDS: u64 = 100;
        let mut held = 0;
        let mut widest = 0.0_f64;
        for seed in 0..SEEDS {
            let random = &mut Pcg64::seed_from_u64(seed);
            let frequency = random.random_range(3.0..40.0);
            let sine = found(500.0, samples, |time| {
                let chance: f64 = StandardNormal.sample(random);
                (TAU * frequency * time).sin() + 0.2 * (TAU * 2.0 * frequency * time).sin() + noise * chance
            })
            .unwrap();
            held += usize::from((sine.frequency - frequency).abs() <= sine.half_width);
            widest = widest.max(sine.half_width);
        }
        println!("noise {noise}: {held} of {SEEDS}, widest {widest:.1e} Hz");
        // Lower 99 % bound of a share of 95 % in 100 trials: 0.95 − 2.576 √(0.95·0.05/100).
        assert!(held >= 89, "{noise}: {held}");
        // Cramér and Rao: u_f = √6 σ/(π T A √N), and a few of it.
        let bound = 6.0_f64.sqrt() * noise / (std::f64::consts::PI * samples as f64 / 500.0 * (samples as f64).sqrt());
        assert!(widest < 6.0 * bound, "{widest} against {bound}");
    }
}

#[test]
fn a_harmonic_is_told_as_one_and_its_fundamental_with_it() {
    let strong = found(500.0, 4000, |time| 0.3 * (TAU * 10.0 * time).sin() + (TAU * 30.0 * time + 0.4).sin()).unwrap();
    assert!(strong.harmonic == 3 && (strong.fundamental() - 10.0).abs() < 1e-3, "{strong:?}");
    let usual = found(500.0, 4000, |time| (TAU * 10.0 * time).sin() + 0.3 * (TAU * 20.0 * time).sin()).unwrap();
    assert!(usual.harmonic == 1 && (usual.frequency - 10.0).abs() < 1e-3, "{usual:?}");
    let folded = found(40.0, 400, |time| (TAU * 27.0 * time).sin()).unwrap();
    assert!((folded.frequency - alias_of(27.0, 40.0)).abs() < 1e-6, "{folded:?}");
}

#[test]
fn a_record_without_a_line_has_no_frequency() {
    let random = &mut Pcg64::seed_from_u64(5);
    let noise: Vec<Option<Sinusoid>> = (0..20).map(|_| found(500.0, 4000, |_| StandardNormal.sample(random))).collect();
    assert!(noise.iter().all(Option::is_none), "{noise:?}");
    assert!(found(500.0, 4000, |_| 0.1).is_none() && found(500.0, 4000, |time| time).is_none());
    assert!(found(500.0, 20, |time| (TAU * 50.0 * time).sin()).is_none());
    assert!(Sinusoid::of(&[0.0; 3], &[0.0; 2]).is_err());
    let uneven: Vec<f64> = (0..100).map(|index| f64::from(index * index)).collect();
    assert!(Sinusoid::of(&uneven, &uneven).is_err());
}
