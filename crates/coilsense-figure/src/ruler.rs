//! From a value to its share of the axis: the range in force and its scale.
//!
//! Where to put ticks on a ruler is said in `ticks`.

use crate::{Axis, PlotError, Scale};

/// Least extent of a range against its greater end: ticks stay apart in double precision.
const RESOLUTION: f64 = 1e-12;
/// Least extent of a range about zero: a step of it is not yet subnormal.
const LEAST_SPAN: f64 = 1e-290;

/// An axis whose range is settled.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ruler {
    /// Lower end, as a logarithm on a logarithmic axis.
    pub lower: f64,
    /// Upper end, likewise.
    pub upper: f64,
    pub scale: Scale,
}

impl Ruler {
    /// The axis' own range, or the extent of `values` widened by `slack` of itself at each end.
    pub fn new(axis: &Axis, values: impl Iterator<Item = f64>, slack: f64) -> Result<Self, PlotError> {
        let scale = axis.scale;
        let (lower, upper) = match axis.range {
            Some(range) => own(axis, range)?,
            None => extent(values.map(|value| scaled(scale, value)), slack)
                .ok_or_else(|| PlotError::NoData { label: axis.label.clone() })?,
        };
        let span = upper - lower;
        let least = LEAST_SPAN.max(RESOLUTION * lower.abs().max(upper.abs()));
        if span.is_finite() && span > least {
            return Ok(Self { lower, upper, scale });
        }
        let label = axis.label.clone();
        let (lower, upper) = axis.range.unwrap_or((lower, upper));
        Err(PlotError::Range { label, lower, upper })
    }

    /// Share of the axis at which a value stands, 0 to 1 within the range; NaN where the scale
    /// has no place for it.
    pub fn share(&self, value: f64) -> f64 {
        (scaled(self.scale, value) - self.lower) / (self.upper - self.lower)
    }

    /// The value that stands at a share of the axis.
    pub fn value(&self, share: f64) -> f64 {
        let place = self.lower + share * (self.upper - self.lower);
        if self.scale == Scale::Log10 { 10f64.powf(place) } else { place }
    }

    /// Widens the range about its middle to an extent.
    pub fn widen_to(&mut self, extent: f64) {
        let room = 0.5 * (extent - (self.upper - self.lower)).max(0.0);
        (self.lower, self.upper) = (self.lower - room, self.upper + room);
    }

    /// Whether a share lies on the axis, forgiving the rounding of its ends.
    pub fn holds(share: f64) -> bool {
        (-1e-9..=1.0 + 1e-9).contains(&share)
    }
}

/// The value, or its logarithm; NaN for what has none.
fn scaled(scale: Scale, value: f64) -> f64 {
    match scale {
        Scale::Linear => value,
        Scale::Log10 if value > 0.0 => value.log10(),
        Scale::Log10 => f64::NAN,
    }
}

/// The range asked for, scaled.
fn own(axis: &Axis, (lower, upper): (f64, f64)) -> Result<(f64, f64), PlotError> {
    if axis.scale == Scale::Log10 && (lower <= 0.0 || upper <= 0.0) {
        let label = axis.label.clone();
        return Err(PlotError::LogRange { label, lower, upper });
    }
    Ok((scaled(axis.scale, lower), scaled(axis.scale, upper)))
}

/// Least and greatest finite value, widened; a single value gets room on both sides.
fn extent(values: impl Iterator<Item = f64>, slack: f64) -> Option<(f64, f64)> {
    let (lower, upper) = values
        .filter(|value| value.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    if lower > upper {
        return None;
    }
    let size = lower.abs().max(upper.abs());
    // Below this the extent is the rounding of a constant, and ticks would need ten digits.
    if upper - lower <= 1e-9 * size || size == 0.0 {
        let room = if size == 0.0 { 1.0 } else { 0.05 * size };
        return Some((lower - room, upper + room));
    }
    let room = slack * (upper - lower);
    Some((lower - room, upper + room))
}
