//! Fourier's transform of a real series of any length.
//!
//! Next door: what is made of it (`spectrum`).

use num_complex::Complex;

use crate::error::Error;
#[cfg(not(target_family = "wasm"))]
use crate::error::number_of;

/// X_k = Σ x_n e^(−2πikn/N) for k = 0…⌊N/2⌋, N at least 1.
///
/// By the planner, which has a way of its own for many lengths.
#[cfg(not(target_family = "wasm"))]
pub(super) fn forward(mut values: Vec<f64>) -> Result<Vec<Complex<f64>>, Error> {
    let samples = values.len();
    let transform = realfft::RealFftPlanner::<f64>::new().plan_fft_forward(samples);
    let mut lines = transform.make_output_vec();
    let refused = |_| number_of("values", samples, "as many as its plan");
    transform.process(&mut values, &mut lines).map_err(refused)?;
    Ok(lines)
}

/// The same by one way for all lengths, Bluestein's: the planner's many ways are a seventh of what a page would have to load.
#[cfg(target_family = "wasm")]
pub(super) fn forward(values: Vec<f64>) -> Result<Vec<Complex<f64>>, Error> {
    use std::cell::RefCell;
    use std::sync::Arc;

    thread_local! {
        // Forces of one case are as long as each other, and so is what a slider gives next.
        static LAST: RefCell<Option<Arc<dyn rustfft::Fft<f64>>>> = const { RefCell::new(None) };
    }
    let mut lines: Vec<Complex<f64>> = values.into_iter().map(|value| Complex::new(value, 0.0)).collect();
    let plan = LAST.with_borrow_mut(|last| match last {
        Some(plan) if plan.len() == lines.len() => Arc::clone(plan),
        _ => Arc::clone(last.insert(bluestein(lines.len()))),
    });
    plan.process(&mut lines);
    lines.truncate(lines.len() / 2 + 1);
    Ok(lines)
}

/// Of any length of at least 1.
#[cfg(any(test, target_family = "wasm"))]
fn bluestein(length: usize) -> std::sync::Arc<dyn rustfft::Fft<f64>> {
    use std::sync::Arc;

    use rustfft::algorithm::butterflies::{Butterfly4, Butterfly8};
    use rustfft::algorithm::{BluesteinsAlgorithm, Radix4};
    use rustfft::{Fft, FftDirection};

    let size = (2 * length).next_power_of_two().max(4);
    let exponent = size.trailing_zeros();
    let base: Arc<dyn Fft<f64>> = match exponent % 2 {
        0 => Arc::new(Butterfly4::new(FftDirection::Forward)),
        _ => Arc::new(Butterfly8::new(FftDirection::Forward)),
    };
    let inner = Radix4::new_with_base(exponent / 2 - 1, base);
    Arc::new(BluesteinsAlgorithm::new(length, Arc::new(inner)))
}

#[cfg(test)]
mod tests {
    use num_complex::Complex;

    /// Rounding of a transform grows with the logarithm of its length: 1e-13 of the largest line leaves two digits for 20 011 samples.
    #[test]
    fn one_way_for_all_lengths_gives_what_the_planner_gives() {
        for samples in [1, 2, 3, 4, 5, 7, 8, 64, 1000, 2000, 2501, 20_011] {
            let value = |n: usize| (0.7 * n as f64).sin() + 0.3 * (2.9 * n as f64).cos() + (n % 5) as f64;
            let values: Vec<f64> = (0..samples).map(value).collect();
            let mut lines: Vec<Complex<f64>> = values.iter().map(|value| Complex::new(*value, 0.0)).collect();
            super::bluestein(samples).process(&mut lines);
            let planned = super::forward(values).unwrap();
            let most = planned.iter().map(|line| line.norm()).fold(0.0, f64::max);
            for (line, (one, other)) in planned.iter().zip(&lines).enumerate() {
                assert!((one - other).norm() < 1e-13 * most, "{samples} samples, line {line}: {one} against {other}");
            }
        }
    }
}
