//! What is designed against the ringing does what its formula says, on the exact motion of the chain.
//!
//! | ours | theirs |
//! |---|---|
//! | `low_pass`, `notch` | SciPy's `butter`, `iirnotch`, `reference/mitigation.py` |
//! | `modal_kalman` | NumPy's eigen-solver, SciPy's `expm` and `solve_discrete_are`, the same script |
//! | observers without noise | `coilsense::Motion` |

mod commands;
mod filters;
mod golden;
mod loops;
mod observers;
#[path = "../paper_springs/mod.rs"]
mod paper_springs;
mod refused;

use coilsense::mitigation::SampledSpring;
use coilsense::{Damping, Spring};

/// S_T with ζ = 0.005 in every mode, 2.5 kHz.
fn sampled() -> SampledSpring {
    sampled_at(&paper_springs::s_t(), 0.005, 2500.0)
}

fn sampled_at(spring: &Spring, ratio: f64, rate: f64) -> SampledSpring {
    SampledSpring::new(spring, &Damping::Modal(ratio), rate).unwrap()
}

/// Numbers drawn evenly from −1 to 1.
fn even(seed: u64, count: usize) -> Vec<f64> {
    use rand::RngExt;
    let mut random = rand_pcg::Pcg64::new(u128::from(seed), 5);
    (0..count).map(|_| random.random_range(-1.0..1.0)).collect()
}
