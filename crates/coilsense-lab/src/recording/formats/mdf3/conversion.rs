//! What a conversion makes of a raw number.
//!
//! Next door: where its parameters stand (`blocks`). As asammdf does it, in double precision throughout.

use super::super::between::between;

/// A conversion.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Conversion {
    None,
    Linear {
        slope: f64,
        offset: f64,
    },
    /// Straight lines between points.
    Interpolated(Vec<[f64; 2]>),
    /// The nearest point.
    Nearest(Vec<[f64; 2]>),
    Polynomial([f64; 6]),
    Rational([f64; 6]),
    /// `exp` where it is told, or else `ln`.
    Exponential(bool, [f64; 7]),
    /// One that is not done, and why.
    Not(&'static str),
}

impl Conversion {
    /// By its number and its parameters.
    pub fn of(kind: u16, parameters: &[f64]) -> Self {
        let points = || parameters.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<[f64; 2]>>();
        let six = || <[f64; 6]>::try_from(parameters).ok();
        let seven = || <[f64; 7]>::try_from(parameters).ok();
        let found = match kind {
            u16::MAX => Some(Self::None),
            0 => parameters.first_chunk().map(|&[offset, slope]| Self::Linear { slope, offset }),
            1 => Some(Self::Interpolated(points())).filter(|_| rises(&points())),
            2 => Some(Self::Nearest(points())).filter(|_| rises(&points())),
            6 => six().map(Self::Polynomial),
            7 => seven().map(|all| Self::Exponential(true, all)),
            8 => seven().map(|all| Self::Exponential(false, all)),
            9 => six().map(Self::Rational),
            10 => Some(Self::Not("converted by a formula in words")),
            11 | 12 => Some(Self::Not("converted to texts")),
            132 | 133 => Some(Self::Not("a date")),
            _ => None,
        };
        found.unwrap_or(Self::Not("of a conversion that is not known"))
    }

    /// The physical value.
    pub fn apply(&self, x: f64) -> f64 {
        match self {
            Self::None => x,
            Self::Linear { slope, offset } => match *offset == 0.0 {
                true => x * slope,
                false => x * slope + offset,
            },
            Self::Interpolated(points) => between(points, x),
            Self::Nearest(points) => nearest(points, x),
            &Self::Polynomial([p1, p2, p3, p4, p5, p6]) if [p2, p3, p5, p6] == [0.0; 4] => {
                if p1 == p4 {
                    x
                } else {
                    p4 * x / p1
                }
            }
            Self::Polynomial([p1, p2, p3, p4, p5, p6]) => (p2 - (p4 * (x - p5 - p6))) / (p3 * (x - p5 - p6) - p1),
            &Self::Rational([p1, p2, p3, p4, p5, p6]) => rational([p1, p2, p3, p4, p5, p6], x),
            &Self::Exponential(exponential, [p1, p2, p3, p4, p5, p6, p7]) => {
                let function = if exponential { f64::exp } else { f64::ln };
                if p4 == 0.0 {
                    function(((x - p7) * p6 - p3) / p1) / p2
                } else if p1 == 0.0 {
                    function((p3 / (x - p7) - p6) / p4) / p5
                } else {
                    f64::NAN
                }
            }
            Self::Not(_) => f64::NAN,
        }
    }
}

fn rational([p1, p2, p3, p4, p5, p6]: [f64; 6], x: f64) -> f64 {
    if [p1, p3, p4, p5] == [0.0; 4] {
        return if p2 == p6 { x } else { x * (p2 / p6) };
    }
    if [p2, p3, p4, p6] == [0.0; 4] {
        return if p1 == p5 { x } else { x * (p1 / p5) };
    }
    (p1 * (x * x) + p2 * x + p3) / (p4 * (x * x) + p5 * x + p6)
}

fn rises(points: &[[f64; 2]]) -> bool {
    !points.is_empty() && points.windows(2).all(|pair| pair[1][0] > pair[0][0])
}

/// The point that is nearest, the lower one of two that are equally near.
fn nearest(points: &[[f64; 2]], x: f64) -> f64 {
    let above = points.partition_point(|point| point[0] < x).min(points.len() - 1);
    let below = above.saturating_sub(1);
    let away = |place: usize| (x - points[place][0]).abs();
    if away(above) >= away(below) { points[below][1] } else { points[above][1] }
}
