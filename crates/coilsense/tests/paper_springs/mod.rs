//! The two springs of the paper's Table I, for tests.

use coilsense::SpringParameters;

#[allow(unused_imports, reason = "each test file uses what it needs")]
pub use coilsense::paper::{s_a, s_t};

/// S_T with some parameters changed.
#[allow(dead_code, reason = "each test file uses what it needs")]
pub fn s_t_with(change: impl FnOnce(&mut SpringParameters)) -> SpringParameters {
    let mut parameters = coilsense::paper::S_T;
    change(&mut parameters);
    parameters
}
