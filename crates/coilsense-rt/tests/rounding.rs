//! Single precision against double, long runs, settled starts, and delays beyond what a ring holds.
//!
//! Next door: responses (`response`), observers (`observers`).

use coilsense_rt::{Biquad, Boxcar, Cascade, Comb, Delay, Impulse, Ring, Shaper, Window};
use rand::RngExt;
use rand_pcg::Pcg64;

const NOTCH: Biquad<f64> = Biquad { b0: 0.967_1, b1: -1.916_346_2, b2: 0.967_1, a1: -1.916_346_2, a2: 0.934_2 };

fn single(section: &Biquad<f64>) -> Biquad<f32> {
    let Biquad { b0, b1, b2, a1, a2 } = *section;
    Biquad { b0: b0 as f32, b1: b1 as f32, b2: b2 as f32, a1: a1 as f32, a2: a2 as f32 }
}

#[test]
fn a_preload_is_no_step() {
    let preload = 96.0;
    let cascade = Cascade { sections: [NOTCH, Biquad { b0: 0.1, b1: 0.2, b2: 0.1, a1: -0.8, a2: 0.2 }] };
    let mut state = cascade.settled(preload);
    let mean = Boxcar { whole: 46, fraction: 0.24, scale: 1.0 / 46.24 };
    let mut of_mean = mean.settled::<48>(preload);
    let radius = 0.98_f64;
    let feedback = radius.powf(46.24);
    let scale = (1.0 - feedback) / (46.24 * (1.0 - radius));
    let comb = Comb { period: Boxcar { scale, ..mean }, radius, feedback };
    let mut of_comb = comb.settled::<48>(preload);
    for _ in 0..500 {
        // 46 terms of one rounding each; poles a distance of 0.02 from the circle let them grow by 50 at most.
        assert!((cascade.step(&mut state, preload) - preload).abs() < 1e-10);
        assert!((mean.step(&mut of_mean, preload) - preload).abs() < 1e-12);
        assert!((comb.step(&mut of_comb, preload) - preload).abs() < 1e-10);
    }
}

#[test]
fn a_running_sum_forgets_a_spike_that_swallows_what_it_meets() {
    let mean = Boxcar { whole: 46, fraction: 0.24_f32, scale: 1.0 / 46.24 };
    let mut state = mean.settled::<48>(1.0);
    // 1e9 + 1 is 1e9 in single precision: a sum that only adds and subtracts stays wrong for ever.
    mean.step(&mut state, 1e9);
    let last = (0..2 * 46 + 1).map(|_| mean.step(&mut state, 1.0)).last().unwrap();
    // Forty-six additions of whole numbers are exact; then one product.
    assert!((last - 1.0).abs() < 1e-6, "{last}");
}

#[test]
fn single_precision_stays_with_double_over_a_million_samples() {
    let mut random = Pcg64::new(7, 11);
    let double = Cascade { sections: [NOTCH] };
    let short = Cascade { sections: [single(&NOTCH)] };
    let (mut wide, mut narrow) = (double.settled(0.0), short.settled(0.0));
    let worst = (0..1_000_000)
        .map(|_| {
            let x: f64 = random.random_range(-1.0..1.0);
            (double.step(&mut wide, x) - f64::from(short.step(&mut narrow, x as f32))).abs()
        })
        .fold(0.0, f64::max);
    // Poles 0.033 inside the circle, at 0.13 rad: rounding of 6e-8 grows by 1/(0.033 · 2 sin 0.13) at most, about 120, before both states.
    assert!(worst < 2e-5, "{worst}");
    assert!(worst > 0.0);
}

#[test]
fn a_delay_beyond_the_ring_is_cut_to_its_oldest() {
    let mut ring = Ring::<f32, 4>::filled(0.0);
    (1..=6).for_each(|x| ring.push(x as f32));
    assert_eq!([0, 1, 2, 3, 4, 1000].map(|ago| ring.back(ago)), [6.0, 5.0, 4.0, 3.0, 3.0, 3.0]);
    assert_eq!(ring.delayed(&Delay { whole: 1, fraction: 0.25 }), 4.75);
    assert_eq!(ring.delayed(&Delay { whole: usize::MAX, fraction: 0.5 }), 3.0);
}

#[test]
fn nothing_panics_on_rings_of_no_sample_or_numbers_that_are_none() {
    let mut nothing = Ring::<f64, 0>::filled(1.0);
    nothing.push(2.0);
    assert_eq!(nothing.back(0), 0.0);
    let empty = Window::<f64, 0> { taps: [] };
    assert_eq!(empty.step(&mut nothing, 3.0), 0.0);
    let huge = Boxcar { whole: usize::MAX, fraction: f64::NAN, scale: f64::INFINITY };
    let mut state = huge.settled::<2>(f64::NAN);
    assert!(huge.step(&mut state, f64::MAX).is_nan());
    let beyond = Impulse { amplitude: 1.0, delay: Delay { whole: usize::MAX, fraction: 1.0 } };
    assert_eq!(Shaper { impulses: [beyond] }.step(&mut Ring::<f64, 1>::filled(0.0), 5.0), 5.0);
}
