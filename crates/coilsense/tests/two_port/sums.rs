//! Closed forms against sums over modes, and the wave's sum without end.

use coilsense::Damping;
use num_complex::Complex64;

use super::paper_springs::s_t;
use super::{chain, distance, wave};

#[test]
fn proportional_damping_is_modal_damping_with_its_ratios() {
    let spring = s_t();
    let modes = coilsense::modes::ChainModes::of(&spring);
    let (rate, time) = (12.5, 3e-5);
    for omega in [1.0, 150.0, 3000.0, 12000.0] {
        let mass = Damping::MassProportional { rate };
        let ratios = Damping::ModalEach(mass.ratios(modes.frequencies()).unwrap());
        let (closed, summed) = (chain(&spring, mass, omega), chain(&spring, ratios, omega));
        assert!(distance(closed.drive_point(), summed.drive_point()) < 1e-12);

        let stiff = Damping::StiffnessProportional { time };
        let ratios = Damping::ModalEach(stiff.ratios(modes.frequencies()).unwrap());
        let dashpot = Complex64::new(1.0, omega * time);
        let (closed, summed) = (chain(&spring, stiff, omega), chain(&spring, ratios, omega));
        // The end segments' dashpots make the difference.
        let with_dashpot = dashpot * summed.drive_point_inertia();
        assert!(distance(closed.drive_point_inertia(), with_dashpot) < 1e-12, "{omega}");
    }
}

#[test]
fn the_waves_last_ratio_goes_on_for_ever() {
    for omega in [1.0, 150.0, 3000.0, 1e6] {
        for ratio in [0.005, 0.999_999_999, 1.0, 1.000_000_001, 3.0, 1e12] {
            let one = wave(&s_t(), Damping::Modal(ratio), omega);
            for listed in [1, 2, 7, 300] {
                let many = wave(&s_t(), Damping::ModalEach(vec![ratio; listed]), omega);
                // Rounding of 300 terms.
                assert!(distance(many.drive_point(), one.drive_point()) < 1e-12, "{omega} {ratio} {listed}");
            }
        }
    }
}
