//! The two springs of the paper's Table I, for tests.

use coilsense::{Spring, SpringParameters};

/// S_T: ankle spring of the humanoid TUlip.
pub fn s_t() -> Spring {
    spring(SpringParameters {
        rest_length: 0.104,
        windings: 52.0,
        coil_radius: 0.008,
        wire_radius: 0.001,
        mass: 0.065,
        stiffness: 760.0,
        min_length: 0.196,
        max_length: 0.264,
        nominal_force: None,
        inductance_windings: None,
    })
}

/// S_A: parallel spring of the prosthetic ankle ANGELAA.
#[allow(dead_code, reason = "each test file uses what it needs")]
pub fn s_a() -> Spring {
    spring(SpringParameters {
        rest_length: 0.081,
        windings: 25.0,
        coil_radius: 0.008,
        wire_radius: 0.0016,
        mass: 0.080,
        stiffness: 9100.0,
        min_length: 0.082,
        max_length: 0.122,
        nominal_force: None,
        inductance_windings: None,
    })
}

/// S_T with some parameters changed.
#[allow(dead_code, reason = "each test file uses what it needs")]
pub fn s_t_with(change: impl FnOnce(&mut SpringParameters)) -> SpringParameters {
    let mut parameters = s_t().parameters().clone();
    change(&mut parameters);
    parameters
}

fn spring(parameters: SpringParameters) -> Spring {
    Spring::new(parameters).expect("Table I is valid")
}
