//! A plant against the motion that it is a step of, on every mount, damping and straight input.
//!
//! | ours | beside |
//! |---|---|
//! | steps of `coilsense_rt::Plant`, both precisions | `Motion` of recordings, which shares modes but no step |
//! | the same, in double precision | exponential of the masses' equations in mpmath, 20 digits, no modes |
//! | `ModalPlant::response` | `TwoPort`, in closed form |
//! | `coilsense_rt::{PlantWindings, PlantCoil}`, both precisions | `Clash` and Maxwell's sum over the motion's positions |
//! | `StateSpace`, `Sampled` | the modal sums, the steps |

mod coil;
mod forms;
mod steps;

use coilsense::{Damping, FarEnd, Mount, Spring, SpringParameters};

fn s_t(windings: f64) -> Spring {
    Spring::new(SpringParameters { windings, ..coilsense::paper::S_T }).unwrap()
}

const FAR_ENDS: [FarEnd; 3] = [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.1)];

fn dampings() -> [Damping; 7] {
    [
        Damping::None,
        Damping::Modal(0.005),
        Damping::StiffnessProportional { time: 3e-4 },
        Damping::MassProportional { rate: 20.0 },
        Damping::Modal(1.0),
        Damping::Modal(3.0),
        Damping::StiffnessProportional { time: 1e-6 },
    ]
}

fn mounts() -> Vec<Mount> {
    let each = FAR_ENDS.into_iter().flat_map(|far_end| dampings().map(|damping| (far_end, damping)));
    each.map(|(far_end, damping)| Mount::new(far_end, damping).unwrap()).collect()
}

/// Both inputs of a sample k, some rough and some slow; one begins late, one comes to rest.
#[derive(Clone, Copy, Debug)]
enum Course {
    Rough,
    Ramps,
    Slow,
}

impl Course {
    fn at(self, k: usize, count: usize) -> [f64; 2] {
        let t = k as f64;
        match self {
            // Of a congruential series: every mode is hit.
            Self::Rough => {
                let noise = |seed: u64| {
                    let mixed = (k as u64 + seed).wrapping_mul(0x9E37_79B9_7F4A_7C15);
                    (mixed ^ (mixed >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9) as f64 / u64::MAX as f64 - 0.5
                };
                if k == 0 { [0.0; 2] } else { [1e-4 * noise(1), 2e-4 * noise(77)] }
            }
            Self::Ramps => {
                let ramp = |from: f64, until: f64| ((t - from) / (until - from)).clamp(0.0, 1.0);
                [2e-3 * ramp(10.0, 14.0), -1e-3 * ramp(20.0, 0.3 * count as f64)]
            }
            Self::Slow => [1e-3 * (0.013 * t).sin(), 1e-3 * ((0.002 * t).cos() - 1.0)],
        }
    }
}
