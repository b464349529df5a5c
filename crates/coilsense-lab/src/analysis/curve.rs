//! A smooth curve through samples of an error's mean and variance.
//!
//! Next door: where samples are taken (`refinement`), what the curves are for (`response`).

use super::moments::Moments;

/// Mean and variance of an error over a coordinate, through samples in order; the nominal spring is at zero.
#[derive(Debug, Clone)]
pub(super) struct Curve {
    places: Vec<f64>,
    means: Smooth,
    /// ln of the variance.
    variances: Smooth,
    nominal: Moments,
}

/// Variance \[N²\] that stands for none, which has no logarithm.
const NONE: f64 = 1e-300;

/// Values with slopes, cubic in between, without overshooting.
#[derive(Debug, Clone)]
struct Smooth {
    values: Vec<f64>,
    slopes: Vec<f64>,
}

impl Curve {
    /// - `samples`: coordinate, ascending, and moments; one of them at zero
    pub fn new(samples: Vec<(f64, Moments)>) -> Self {
        let places: Vec<f64> = samples.iter().map(|(place, _)| *place).collect();
        let of =
            |value: &dyn Fn(&Moments) -> f64| Smooth::new(&places, samples.iter().map(|(_, m)| value(m)).collect());
        let nominal = samples.iter().min_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        let nominal = nominal.map_or(Moments { mean: 0.0, variance: 0.0 }, |(_, moments)| *moments);
        let means = of(&|moments| moments.mean);
        let variances = of(&|moments| moments.variance.max(NONE).ln());
        Self { means, variances, nominal, places }
    }

    /// Of the nominal spring.
    pub fn nominal(&self) -> Moments {
        self.nominal
    }

    /// At a coordinate; beyond the samples as at the last of them.
    pub fn at(&self, place: f64) -> Moments {
        let next = self.places.partition_point(|known| *known <= place);
        if next == 0 || next == self.places.len() {
            let last = next.saturating_sub(1);
            return Moments { mean: self.means.values[last], variance: variance(self.variances.values[last]) };
        }
        let (before, width) = (next - 1, self.places[next] - self.places[next - 1]);
        let share = (place - self.places[before]) / width;
        let variance = variance(self.variances.between(before, width, share));
        Moments { mean: self.means.between(before, width, share), variance }
    }

    /// Where the mean square is largest among the samples.
    pub fn loudest(&self) -> f64 {
        self.largest().0
    }

    /// The largest mean square among the samples.
    pub fn peak(&self) -> f64 {
        self.largest().1
    }

    fn largest(&self) -> (f64, f64) {
        let size = |index: usize| variance(self.variances.values[index]) + self.means.values[index].powi(2);
        let each = self.places.iter().enumerate().map(|(index, place)| (*place, size(index)));
        each.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0.0, 0.0))
    }
}

/// Of its logarithm; what stands for none is none.
fn variance(logarithm: f64) -> f64 {
    let variance = logarithm.exp();
    if variance > 2.0 * NONE { variance } else { 0.0 }
}

impl Smooth {
    /// Slopes as the harmonic mean of those to both sides, none at a turning point.
    ///
    /// Source:   `[Fritsch1984]`, monotone piecewise cubic interpolation.
    /// Valid:    ascending places.
    /// Accuracy: third order where the values are monotone, second at turning points.
    fn new(places: &[f64], values: Vec<f64>) -> Self {
        let count = values.len();
        let rise = |index: usize| (values[index + 1] - values[index]) / (places[index + 1] - places[index]);
        let slope = |index: usize| {
            if count < 2 {
                return 0.0;
            }
            let (before, after) = (rise(index.max(1) - 1), rise(index.min(count - 2)));
            if index == 0 || index == count - 1 {
                return if index == 0 { after } else { before };
            }
            if before * after <= 0.0 {
                return 0.0;
            }
            let (left, right) = (places[index] - places[index - 1], places[index + 1] - places[index]);
            let (w1, w2) = (2.0 * right + left, right + 2.0 * left);
            (w1 + w2) / (w1 / before + w2 / after)
        };
        let slopes = (0..count).map(slope).collect();
        Self { values, slopes }
    }

    fn between(&self, before: usize, width: f64, t: f64) -> f64 {
        let (a, b) = (self.values[before], self.values[before + 1]);
        let (left, right) = (width * self.slopes[before], width * self.slopes[before + 1]);
        let s = 1.0 - t;
        s * s * ((1.0 + 2.0 * t) * a + t * left) + t * t * ((1.0 + 2.0 * s) * b - s * right)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_resonance_is_drawn_out_between_samples_a_half_width_apart() {
        let peak = |x: f64| Moments { mean: 0.1 * x, variance: 1.0 / (1.0 + x * x) };
        let samples = (-8..=8).map(|index| 0.75 * f64::from(index)).map(|x| (x, peak(x))).collect();
        let curve = Curve::new(samples);
        for index in -60..=60 {
            let x = 0.1 * f64::from(index);
            let (at, true_value) = (curve.at(x), peak(x));
            // Second order at the top: 3 % where samples are three quarters of a half width apart.
            assert!((at.variance / true_value.variance - 1.0).abs() < 0.03, "{x}: {at:?} {true_value:?}");
            assert!((at.mean - true_value.mean).abs() < 1e-12);
        }
        assert_eq!(curve.loudest(), 0.0);
    }

    #[test]
    fn no_error_stays_none() {
        let none = Moments { mean: 0.0, variance: 0.0 };
        let curve = Curve::new(vec![(-1.0, none), (0.0, none), (1.0, none)]);
        for place in [-2.0, -1.0, -0.3, 0.0, 0.7, 1.0] {
            assert_eq!(curve.at(place), none, "{place}");
        }
        assert_eq!(curve.peak(), 0.0);
    }
}
