use crate::cases::{car, helix, s_a, s_t, standard, valve, valve_of};
use coilsense::End;
use coilsense::helix::*;

#[test]
fn print_response() {
    let st = Helix::new(&standard(), standard().parameters().rest_span, Turning::Held).unwrap();
    for (name, h) in [
        ("S_T", helix(&s_t(), 0.23)),
        ("S_A", helix(&s_a(), 0.102)),
        ("valve", helix(&valve(), 0.043)),
        ("car", helix(&car(), 0.2233)),
        ("test", st),
        ("v5.5", helix(&valve_of(5.5), 0.043)),
        ("v6", helix(&valve_of(6.0), 0.043)),
    ] {
        let r = Response::new(&h, Ends::clamped(), 0.0).unwrap();
        let s = r.reaction(0.0, End::One, End::Two).unwrap();
        let k = r.stiffness(0.0).unwrap();
        println!(
            "{name} {:e} {:e} {:.5} {:.5} {:.5}",
            k[2][2].re / h.stiffness() - 1.0,
            -k[2][8].re / h.stiffness() - 1.0,
            s.side_force(),
            1e3 * s.tilting_couple(),
            1e3 * s.axis_couple()
        );
        println!("   dC/dF {:e}", s.axis_couple() / h.couple_per_force() - 1.0);
        for eta in [0.0, 0.004, 0.02] {
            let m = Modes::new(&h, Ends::clamped()).unwrap();
            for i in 1..=4 {
                let m = m.mode(i).unwrap();
                if m.kind() == Kind::Axial {
                    let r = Response::new(&h, Ends::clamped(), eta).unwrap();
                    let s = r.reaction(m.frequency() * (1.0 - 1e-6), End::One, End::Two).unwrap();
                    println!(
                        "   {eta} {:.5} {:.5} {:.5}  peak {:.5}",
                        s.side_force(),
                        1e3 * s.tilting_couple(),
                        1e3 * s.axis_couple(),
                        s.force()[2].norm() * eta / h.stiffness() / 2.0
                    );
                }
            }
        }
    }
    for (d, ld) in [(0.1, 6.0), (0.1, 8.0), (0.05, 8.0), (0.1, 4.0)] {
        for ends in [Ends::clamped(), Ends::pinned()] {
            for n in [10.0, 20.0, 20.25, 30.0] {
                let rod = Rod::new(RodParameters {
                    wire_diameter: d * 0.02,
                    coil_radius: 0.01,
                    windings: n,
                    rest_span: ld * 0.02,
                    youngs_modulus: 206e9,
                    shear_modulus: 81.5e9,
                    density: 7850.0,
                    hand: Hand::Right,
                })
                .unwrap();
                let b = buckling_length(&rod, ends, Turning::Held);
                println!("d/D {d} l/D {ld} N {n} {:?}", b.map(|b| b.map(|b| 1.0 - b / (ld * 0.02))));
            }
        }
    }
}
