// surge_mean: mean, for 2500 Hz. Made by coilsense 0.1.0.

use coilsense_rt::*;

/// Samples that the state's ring holds.
pub const SURGE_MEAN_RING: usize = 47;

/// For 2500 Hz.
pub const SURGE_MEAN: Boxcar<f32> = Boxcar {
    whole: 46,
    fraction: 0.24021944,
    scale: 0.021626195,
};
