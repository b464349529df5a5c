//! Figures of independent programs.

use coilsense::helix::{Ends, Helix, Turning};

use crate::cases::{Case, car, frequencies, helix, knee, relative, s_a, s_t, standard, valve};

#[test]
fn look() {
    let standard = Helix::new(&standard(), standard().parameters().rest_span, Turning::Held).unwrap();
    println!("{:?}", frequencies(&standard, Ends::clamped(), 10));
    for (case, length) in [(s_t(), 0.196),(s_t(), 0.230),(s_t(), 0.264), (s_a(), 0.102), (valve(), 0.043), (car(), 0.2233), (knee(), 0.105)] {
        let helix = helix(&case, length);
        println!("F {} C {} k {} dC/dF {} turn {}", helix.force(), helix.couple(), helix.stiffness(), helix.couple_per_force(), helix.turn());
        println!("{:.3?}", frequencies(&helix, Ends::clamped(), 10));
    }
}
