//! One motion's end forces, timed, for comparison with the same call from Python: `cargo run --release -p coilsense --example end_forces`.
//!
//! Prints one JSON object, as the jobs of `cargo xtask bench` do.

use std::time::Instant;

use coilsense::signals::sampled_window;
use coilsense::{Excitation, Motion};

fn main() -> Result<(), coilsense::Error> {
    let spring = coilsense::paper::s_t();
    let motion = Motion::new(&spring, &Excitation::impact(spring.mid_length(), 0.25)?)?;
    let times = sampled_window(10_000.0, 0.0, 1.0)?;
    let mut spent = Vec::new();
    for _ in 0..2000 {
        let begun = Instant::now();
        std::hint::black_box(motion.end_forces(std::hint::black_box(&times))?);
        spent.push(1e3 * begun.elapsed().as_secs_f64());
    }
    spent.sort_by(f64::total_cmp);
    let median = spent[spent.len() / 2];
    println!(r#"{{"job":"impact-10001","system":"coilsense","setting":"Motion::end_forces","median_ms":{median}}}"#);
    Ok(())
}
