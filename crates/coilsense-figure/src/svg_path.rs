//! Polylines in the few characters that SVG's paths allow.
//!
//! What is drawn along them is `svg`'s matter.

use std::fmt::Write;

use crate::drawing::Point;

/// A run as steps in tenths of a pixel, counted from the rounded point before, so that
/// rounding does not add up. Frames stand on half pixels and stay sharp.
pub(crate) fn path(svg: &mut String, run: &[Point]) {
    let mut pen = [0_i64; 2];
    for (index, point) in run.iter().enumerate() {
        let here = point.map(|pixels| (pixels * 10.0).round() as i64);
        svg.push_str(match index {
            0 => "M",
            1 => "l",
            _ => "",
        });
        for axis in 0..2 {
            let step = here[axis] - pen[axis];
            if step >= 0 && (axis == 1 || index > 1) {
                svg.push(' ');
            }
            tenths(svg, step);
        }
        pen = here;
    }
}

/// A count of tenths as a short decimal: 25 is `2.5`, -3 is `-.3`.
fn tenths(svg: &mut String, count: i64) {
    let (whole, tenth) = (count.abs() / 10, count.abs() % 10);
    if count < 0 {
        svg.push('-');
    }
    if whole > 0 || tenth == 0 {
        let _ = write!(svg, "{whole}");
    }
    if tenth > 0 {
        let _ = write!(svg, ".{tenth}");
    }
}
