// notch: biquad cascade, for 2500 Hz. Made by coilsense 0.1.0.

use coilsense_rt::*;

/// For 2500 Hz.
pub const NOTCH: Cascade<f32, 1> = Cascade {
    sections: [
        Biquad {
            b0: 0.9671335,
            b1: -1.9164375,
            b2: 0.9671335,
            a1: -1.9164375,
            a2: 0.934267,
        },
    ],
};
