// kalman: modal Kalman filter, for 2500 Hz. Made by coilsense 0.1.0.

use coilsense_rt::*;

/// For 2500 Hz.
pub const KALMAN: ModalKalman<f32, 3> = ModalKalman {
    stiffness: 760.0,
    rest_length: 0.104,
    rate: 2500.0,
    bias_gain: 0.03818161,
    modes: [
        Mode {
            turn: [
                [
                    0.9907893,
                    0.1353512,
                ],
                [
                    -0.1353512,
                    0.9894358,
                ],
            ],
            kick: [
                -4.475171,
                -4.475171,
            ],
            input: 1.0,
            output: -1.0,
            gain: [
                0.08407543,
                0.056614324,
            ],
        },
        Mode {
            turn: [
                [
                    0.9633767,
                    0.26790673,
                ],
                [
                    -0.26790673,
                    0.96069765,
                ],
            ],
            kick: [
                -2.238607,
                2.238607,
            ],
            input: 1.0,
            output: 1.0,
            gain: [
                0.007420182,
                0.004130557,
            ],
        },
        Mode {
            turn: [
                [
                    0.9183888,
                    0.39513075,
                ],
                [
                    -0.39513075,
                    0.9144375,
                ],
            ],
            kick: [
                -1.4935403,
                -1.4935403,
            ],
            input: 1.0,
            output: -1.0,
            gain: [
                0.030609688,
                0.010080258,
            ],
        },
    ],
};
