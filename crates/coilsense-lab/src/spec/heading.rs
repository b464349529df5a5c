//! Units in the headings of the files that a spec names.
//!
//! Next door: recordings (`recorded`), cams (`cam`).

use crate::quantity::Dimension;

/// The unit in a title's brackets, such as `u1 [mm]` or `u1 (mm)`.
pub(super) fn unit(title: &str) -> Option<&str> {
    let within = |open, close| title.split_once(open).and_then(|(_, rest)| rest.split_once(close));
    let (unit, _) = within('[', ']').or_else(|| within('(', ')'))?;
    Some(unit.trim())
}

/// What 1 of a unit is in SI; `None` where it is not of the dimension.
pub(super) fn scale(unit: &str, dimension: Dimension) -> Option<f64> {
    dimension.parse(&format!("1 {unit}"))
}
