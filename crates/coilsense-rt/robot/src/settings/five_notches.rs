// five_notches: biquad cascade, for 2500 Hz. Made by coilsense 0.1.0.

use coilsense_rt::*;

/// For 2500 Hz.
pub const FIVE_NOTCHES: Cascade<f32, 5> = Cascade {
    sections: [
        Biquad {
            b0: 0.9778509,
            b1: -1.9376748,
            b2: 0.9778509,
            a1: -1.9376748,
            a2: 0.9557018,
        },
        Biquad {
            b0: 0.9566405,
            b1: -1.843062,
            b2: 0.9566405,
            a1: -1.843062,
            a2: 0.9132809,
        },
        Biquad {
            b0: 0.9362898,
            b1: -1.7191354,
            b2: 0.9362898,
            a1: -1.7191354,
            a2: 0.8725795,
        },
        Biquad {
            b0: 0.9167279,
            b1: -1.5692378,
            b2: 0.9167279,
            a1: -1.5692378,
            a2: 0.83345586,
        },
        Biquad {
            b0: 0.897891,
            b1: -1.3970205,
            b2: 0.897891,
            a1: -1.3970205,
            a2: 0.79578197,
        },
    ],
};
