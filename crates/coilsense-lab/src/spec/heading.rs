//! Units in the headings of the files that a spec names.
//!
//! Next door: recordings (`recorded`), cams (`cam`).

use crate::quantity::Dimension;

/// What 1 of a column is in SI, by the unit in its title's brackets, such as `u1 [mm]` or `u1 (mm)`; `None` without brackets, an error of a unit that is not of
/// the dimension.
pub(super) fn scale(title: &str, dimension: Dimension) -> Option<Result<f64, String>> {
    let within = |open, close| title.split_once(open).and_then(|(_, rest)| rest.split_once(close));
    let unit = within('[', ']').or_else(|| within('(', ')'))?.0.trim();
    let known = dimension.parse(&format!("1 {unit}"));
    Some(known.ok_or_else(|| format!("the unit {unit:?} must be one of {}", dimension.symbols())))
}
