//! Geometry, neighbours and the continuous coil: laws, limits, and the springs of the paper from their dimensions.
//!
//! | ours | theirs |
//! |---|---|
//! | `modes::continuous_frequencies` | mpmath, bisection at 80 digits (`tests/golden/continuous_modes.csv`) |
//! | `modes::continuous_frequencies` | `ChainModes` as N grows |
//! | `Geometry` | Table I of the paper; the wave impedance; Castigliano's integral; finite differences |
//! | `neighbours` | the limits string and beam; Haringx's buckling |

mod any_number;
mod continuous;
mod neighbours;
#[path = "../paper_springs/mod.rs"]
mod paper_springs;
mod wire;

use coilsense::Spring;
use coilsense::geometry::{EndType, Geometry, GeometryParameters, Material, MaterialParameters};
use paper_springs::s_t;

fn steel() -> Material {
    Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0)).unwrap()
}

fn of(spring: &Spring) -> Geometry {
    Geometry::of_spring(spring, EndType::Hooks, steel()).unwrap()
}

/// S_T's dimensions with some changed.
fn with(change: impl FnOnce(&mut GeometryParameters)) -> Result<Geometry, coilsense::Error> {
    let mut parameters = *of(&s_t()).parameters();
    change(&mut parameters);
    Geometry::new(parameters)
}

fn relative(ours: f64, theirs: f64) -> f64 {
    (ours / theirs - 1.0).abs()
}
