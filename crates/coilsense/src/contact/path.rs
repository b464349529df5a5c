//! How an end moves as polynomials, one after the other: a cam's law, or a smooth curve through samples.
//!
//! Next door: the inputs that a linear motion knows as well (`crate::excitation`), either as a power series (`drive`).

use crate::error::{Error, all_bounded, at_least_one, check, count, entry};

/// Polynomials of time, one after the other; at rest before the first and after the last.
///
/// ```
/// use coilsense::contact::Path;
/// // Up by 1 mm within 2 ms and stay there.
/// let path = Path::new(vec![0.01, 0.012], vec![vec![0.0, 0.5]])?;
/// assert_eq!((path.value(0.0), path.value(1.0)), (0.0, 1e-3));
/// assert!((path.value(0.011) - 5e-4).abs() < 1e-12);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    knots: Vec<f64>,
    /// Powers of the time since each knot; one before the first and one after the last, which stand still.
    pieces: Vec<Vec<f64>>,
}

impl Path {
    /// Between `knots` \[s\], shape `pieces + 1`, ascending, the polynomial `pieces[i]` of the time since knot i, lowest power first \[m, m/s, …\].
    ///
    /// Nothing is asked of how they join: an end may jump, and a rate may.
    ///
    /// # Errors
    /// [`Error::Count`] for no piece, an empty one, one of more than 9 coefficients, or another number of knots; [`Error::Value`] for the first
    /// number that is not finite or knot that is not after its predecessor.
    pub fn new(knots: Vec<f64>, pieces: Vec<Vec<f64>>) -> Result<Self, Error> {
        at_least_one("pieces", pieces.len())?;
        count("knots", knots.len(), pieces.len() + 1)?;
        all_bounded("knots", &knots, "s")?;
        if let Some(index) = (1..knots.len()).find(|&index| knots[index] <= knots[index - 1]) {
            let allowed = format!("above its predecessor of {} s", knots[index - 1]);
            check(false, entry("knots", index), knots[index], "s", allowed)?;
        }
        for (index, piece) in pieces.iter().enumerate() {
            if !(1..=MOST_COEFFICIENTS).contains(&piece.len()) {
                let allowed = format!("1 to {MOST_COEFFICIENTS}");
                return Err(crate::error::number_of(entry("pieces", index), piece.len(), allowed));
            }
            if let Some(&wrong) = piece.iter().find(|coefficient| !coefficient.is_finite()) {
                check(false, entry("pieces", index), wrong, "", "finite")?;
            }
        }
        let last = pieces.len() - 1;
        let until = polynomial(&pieces[last], knots[last + 1] - knots[last]);
        let mut all = vec![vec![pieces[0][0]]];
        all.extend(pieces);
        all.push(vec![until]);
        Ok(Self { knots, pieces: all })
    }

    /// The natural cubic spline through `values` \[m\] at `times` \[s\], each of shape `samples`: twice differentiable, straight at its ends.
    ///
    /// # Errors
    /// As [`Self::new`]; [`Error::Count`] for fewer than two samples.
    pub fn spline(times: &[f64], values: &[f64]) -> Result<Self, Error> {
        count("values", values.len(), times.len())?;
        if times.len() < 2 {
            return Err(crate::error::number_of("times", times.len(), "at least 2"));
        }
        all_bounded("values", values, "m")?;
        let curvatures = curvatures(times, values);
        let piece = |index: usize| {
            let (step, [here, next]) = (times[index + 1] - times[index], [curvatures[index], curvatures[index + 1]]);
            let slope = (values[index + 1] - values[index]) / step - step * (2.0 * here + next) / 6.0;
            vec![values[index], slope, 0.5 * here, (next - here) / (6.0 * step)]
        };
        Self::new(times.to_vec(), (0..times.len() - 1).map(piece).collect())
    }

    /// Where it is at a time \[m\].
    pub fn value(&self, time: f64) -> f64 {
        let (piece, since) = self.at(time);
        polynomial(piece, since)
    }

    /// The polynomial of a time, and the time since it began \[s\].
    pub(super) fn at(&self, time: f64) -> (&[f64], f64) {
        let number = self.knots.partition_point(|knot| *knot <= time);
        let begin = self.knots[number.saturating_sub(1)];
        (&self.pieces[number], if number == 0 { 0.0 } else { time - begin })
    }

    pub(super) fn knots(&self) -> &[f64] {
        &self.knots
    }
}

/// Powers 0 to 8.
const MOST_COEFFICIENTS: usize = 9;

fn polynomial(coefficients: &[f64], at: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * at + coefficient)
}

/// Second derivatives of the natural spline at each sample: a tridiagonal system, zero at both ends.
fn curvatures(times: &[f64], values: &[f64]) -> Vec<f64> {
    let samples = times.len();
    let (mut diagonal, mut right) = (vec![1.0; samples], vec![0.0; samples]);
    for index in 1..samples - 1 {
        let [before, after] = [times[index] - times[index - 1], times[index + 1] - times[index]];
        let bend = (values[index + 1] - values[index]) / after - (values[index] - values[index - 1]) / before;
        let share = if index > 1 { before / diagonal[index - 1] } else { 0.0 };
        diagonal[index] = 2.0 * (before + after) - share * before;
        right[index] = 6.0 * bend - share * right[index - 1];
    }
    for index in (1..samples - 1).rev() {
        let after = times[index + 1] - times[index];
        right[index] = (right[index] - after * right[index + 1]) / diagonal[index];
    }
    right
}
