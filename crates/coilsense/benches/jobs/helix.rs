//! Every mode of S_T as a helix at mid range: a count, ten of them, and lines over lengths.
//!
//! Next door: what is timed how (`measure`), the same more closely (`cargo bench --bench kernels -- helix`).

use std::hint::black_box;

use coilsense::Error;
use coilsense::geometry::{EndType, Geometry, Material, MaterialParameters};
use coilsense::helix::{Ends, Hand, Helix, Modes, Rod, StiffnessAt, Turning};

use crate::measure::{Measurement, measure};

/// Lengths of a chart.
const LENGTHS: usize = 50;

/// Rows of the job `helix`.
pub fn rows() -> Result<Vec<Measurement>, Error> {
    let spring = coilsense::paper::s_t();
    let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0))?;
    let geometry = Geometry::of_spring(&spring, EndType::Hooks, steel)?;
    let rod = Rod::of_spring(&spring, &geometry, StiffnessAt::Range, Hand::Right)?;
    let modes = |length: f64| Modes::new(&Helix::new(&rod, length, Turning::Held)?, Ends::clamped());
    let mid = modes(spring.mid_length())?;
    let (shortest, longest) = spring.operating_range();
    let length = |step: usize| shortest + (longest - shortest) * step as f64 / (LENGTHS - 1) as f64;
    let (count, counted) = measure(|| mid.count_below(black_box(100.0)));
    let (frequencies, ten) = measure(|| modes(black_box(spring.mid_length()))?.frequencies(10));
    let (shapes, shaped) = measure(|| modes(black_box(spring.mid_length()))?.lowest(10));
    let (chart, lines) =
        measure(|| (0..LENGTHS).map(|step| modes(length(step))?.frequencies(10)).collect::<Result<Vec<_>, _>>());
    counted?;
    ten?;
    shaped?;
    lines?;
    Ok(vec![
        Measurement::timed("modes below 100 Hz counted", count),
        Measurement::timed("ten frequencies", frequencies),
        Measurement::timed("ten modes with their shapes", shapes),
        Measurement::timed("ten frequencies at 50 lengths", chart),
    ])
}
