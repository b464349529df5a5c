//! Every mode of the coil for a page: its lines against length, and one mode as the wire moves in it.
//!
//! Next door: the modes (`coilsense_lab::helix`), the rest of a case (`exact`).

use coilsense_lab::analysis::{driven, is_broad};
use coilsense_lab::helix::{Coil, ModeShape};
use coilsense_lab::spec::{Model, Spec};
use serde_json::{Value, json};

use crate::answer::Answer;

/// Most lengths that are asked for at once.
pub const MOST_LENGTHS: usize = 200;
/// Most points of the wire for each winding.
pub const MOST_POINTS: usize = 64;
/// Most modes of which one is asked for.
const MOST_MODES: usize = 100;

/// Lines of the modes at so many lengths over those in use, and what drives them.
///
/// Series: `length`; `curve W NUMBER KIND` \[Hz\] of each mode with the ends in way W (0: as held, 1: as loose as may be) while it is of a kind;
/// `buckles W`, 1 where the spring has buckled; `lower KIND ORDER` and `upper KIND ORDER` \[Hz\], between both ways.
///
/// # Errors
/// One line: why the coil is no helix.
pub fn lines(spec: &Spec, lengths: usize) -> Result<Answer, String> {
    if !(2..=MOST_LENGTHS).contains(&lengths) {
        return Err(format!("lengths must be from 2 to {MOST_LENGTHS}, got {lengths}"));
    }
    let lines = coil(spec)?.lines(lengths).map_err(|error| error.to_string())?;
    let mut series = vec![("length".to_owned(), lines.lengths)];
    let mut ends = Vec::new();
    for (number, way) in lines.ways.into_iter().enumerate() {
        ends.push(Value::from(way.ends));
        series.push((format!("buckles {number}"), way.buckles.into_iter().map(f64::from).collect()));
        for curve in way.curves {
            series.push((format!("curve {number} {} {}", curve.number, curve.kind), curve.frequency));
        }
    }
    for (order, band) in lines.bands.into_iter().enumerate() {
        series.push((format!("lower {} {order}", band.kind), band.lower));
        series.push((format!("upper {} {order}", band.kind), band.upper));
    }
    let meta = json!({
        "ends": ends,
        "top": lines.top,
        "driven": driven(spec).into_iter().map(|(condition, hertz)| json!([condition, hertz])).collect::<Vec<_>>(),
        "broad": (0..spec.conditions.len()).map(|condition| Value::Bool(is_broad(spec, condition))).collect::<Vec<_>>(),
        "isChain": spec.spring.model == Model::Chain,
        "modelFrequency": spec.spring.spring.chain_frequency(),
    });
    Ok(Answer::new(&meta, series))
}

/// Which mode is asked for.
#[derive(Debug, Clone, Copy)]
pub struct Asked {
    /// Length of the spring \[m\].
    pub length: f64,
    /// Whether its ends are as loose as they may be.
    pub loosest: bool,
    /// Number of the mode, from 1.
    pub number: usize,
    /// Points of the wire for each winding.
    pub points: usize,
}

/// All modes at a length with the ends held in one way, as the data sheet has them, and one with its reactions. Positions: x, y, z of each point of the wire \[m\], and how far
/// it moves along these, the farthest by 1.
///
/// # Errors
/// One line: why the coil is no helix, or what of the question is out of range.
pub fn shape(spec: &Spec, asked: Asked) -> Result<Answer, String> {
    let Asked { length, loosest, number, points } = asked;
    for (what, value, most) in [("number", number, MOST_MODES), ("points", points, MOST_POINTS)] {
        if !(1..=most).contains(&value) {
            return Err(format!("{what} must be from 1 to {most}, got {value}"));
        }
    }
    let coil = coil(spec)?;
    let science = |error: coilsense::Error| error.to_string();
    let ModeShape { line, under, ends, wire, moved } = coil.shape(length, loosest, number, points).map_err(science)?;
    let mut positions = Vec::with_capacity(6 * wire.len());
    for (rest, moved) in wire.iter().zip(&moved) {
        positions.extend(rest.iter().chain(moved).map(|value| *value as f32));
    }
    let rod = coil.rod.parameters();
    let meta = json!({
        "length": length,
        "under": under,
        "mode": line,
        "ends": ends,
        "windings": rod.windings,
        "wireDiameter": rod.wire_diameter,
    });
    Ok(Answer::new(&meta, Vec::new()).with_positions(positions))
}

fn coil(spec: &Spec) -> Result<Coil, String> {
    spec.spring.helix(&spec.mount.ends).map_err(|error| error.to_string())
}
