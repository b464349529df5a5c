// plant: the spring "S_T", ζ = 0.005, 8 modes. Made by coilsense 0.1.0.

use coilsense_rt::{FarEnd, PlantMode, PlantSettings};

/// How many modes there are.
pub const PLANT_MODES: usize = 8;

/// Inputs: u1, and u2 [m]. `PLANT.plant::<f32>(step)` is ready to be stepped.
pub const PLANT: PlantSettings<PLANT_MODES> = PlantSettings {
    stiffness: 760.0,
    mass: 0.065,
    damping_ratio: 0.005,
    damped_frequency: 339.6518148798703,
    dashpots: false,
    stretch: 0.126,
    far_end: FarEnd::Position,
    modes: [
        PlantMode {
            frequency: 339.6518148798703,
            damping: 1.0,
            participations: [0.6367166019760208, 0.6367166019760208],
            weights: [2387.247317382254, -2387.247317382254],
            end: 0.0,
        },
        PlantMode {
            frequency: 678.9937209075279,
            damping: 1.0,
            participations: [0.3185036072737882, -0.3185036072737882],
            weights: [4772.316436257489, 4772.316436257489],
            end: 0.0,
        },
        PlantMode {
            frequency: 1017.7160920012108,
            damping: 1.0,
            participations: [0.21249732722614958, 0.21249732722614958],
            weights: [7153.031145574575, -7153.031145574575],
            end: 0.0,
        },
        PlantMode {
            frequency: 1355.5098673620485,
            damping: 1.0,
            participations: [0.15954288097228375, -0.15954288097228375],
            weights: [9527.219207380735, 9527.219207380735],
            end: 0.0,
        },
        PlantMode {
            frequency: 1692.0668334707239,
            damping: 1.0,
            participations: [0.12780934248424955, 0.12780934248424955],
            weights: [11892.714338838849, -11892.714338838849],
            end: 0.0,
        },
        PlantMode {
            frequency: 2027.0799053110488,
            damping: 1.0,
            participations: [0.10668644529437765, -0.10668644529437765],
            weights: [14247.358188811111, 14247.358188811111],
            end: 0.0,
        },
        PlantMode {
            frequency: 3679.616258800886,
            damping: 0.9108696639632884,
            participations: [1.0, 0.0],
            weights: [27029.743647763346, -2102.0852936034084],
            end: 0.0,
        },
        PlantMode {
            frequency: 3679.616258800886,
            damping: 0.9108696639632884,
            participations: [0.0, 1.0],
            weights: [2102.0852936034084, -27029.743647763346],
            end: 0.0,
        },
    ],
};
