//! The spring over frequency: against 25-digit direct solves, its limits and its laws.
//!
//! | ours | theirs |
//! |---|---|
//! | `TwoPort::chain` | LU of the windings' complex equations in Arb, no dispersion relation, `reference/two_port.py` |
//! | `TwoPort::wave` | boundary-value problem and digamma functions in mpmath, the same script |
//! | `DynamicStiffness::transmittance` | `coilsense::transmittance` |
//! | `Cascade` | LU of all parts' equations at once, assembled in the test |

mod cascades;
mod golden;
mod laws;
mod limits;
#[path = "../paper_springs/mod.rs"]
mod paper_springs;
mod sums;

use coilsense::two_port::{DynamicStiffness, Load, TwoPort};
use coilsense::{Damping, Spring};
use num_complex::Complex64;
use paper_springs::s_t_with;

const EACH: [f64; 6] = [0.01, 0.02, 0.005, 0.03, 0.015, 0.007];

fn with_windings(windings: usize) -> Spring {
    Spring::new(s_t_with(|p| p.windings = windings as f64)).unwrap()
}

/// k = 1 N/m, m = 1 kg: τ = 1 s exactly.
fn unit_spring(windings: usize) -> Spring {
    Spring::new(s_t_with(|p| {
        (p.windings, p.mass, p.stiffness) = (windings as f64, 1.0, 1.0);
    }))
    .unwrap()
}

fn chain(spring: &Spring, damping: Damping, omega: f64) -> DynamicStiffness {
    TwoPort::chain(spring, damping).unwrap().at(omega).unwrap()
}

fn wave(spring: &Spring, damping: Damping, omega: f64) -> DynamicStiffness {
    TwoPort::wave(spring, damping).unwrap().at(omega).unwrap()
}

/// Every kind of damping that fits a chain of N masses.
fn dampings(masses: usize) -> Vec<Damping> {
    vec![
        Damping::None,
        Damping::Modal(0.005),
        Damping::Modal(1.0),
        Damping::ModalEach((0..masses).map(|j| EACH[j % 6]).collect()),
        Damping::MassProportional { rate: 12.5 },
        Damping::StiffnessProportional { time: 3e-5 },
        Damping::Hysteretic { loss_factor: 0.04 },
    ]
}

fn distance(ours: Complex64, theirs: Complex64) -> f64 {
    (ours - theirs).norm() / theirs.norm()
}

/// The answers of a golden row, in its order.
fn answers(at: &DynamicStiffness) -> [Complex64; 8] {
    let mass = Load::mass(0.04).unwrap();
    let load = Load::stiffness(Complex64::new(310.0, 95.0)).unwrap();
    [
        at.drive_point(),
        at.transfer(),
        at.drive_point_inertia(),
        at.transfer_inertia(),
        at.transmittance(&Load::HELD),
        at.transmittance(&mass),
        at.transmittance(&load),
        at.motion_ratio(&mass),
    ]
}
