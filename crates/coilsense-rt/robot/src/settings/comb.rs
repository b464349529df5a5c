// comb: comb, for 2500 Hz. Made by coilsense 0.1.0.

use coilsense_rt::*;

/// Samples that the state's ring holds.
pub const COMB_RING: usize = 48;

/// For 2500 Hz.
pub const COMB: Comb<f32> = Comb {
    period: Boxcar {
        whole: 46,
        fraction: 0.24021944,
        scale: 0.59877,
    },
    radius: 0.97518045,
    feedback: 0.31281495,
};
