//! How values of a variable are spread: uniform, log-uniform, normal, log-normal, triangular; by quantiles, so that any sampling can use them.
//!
//! Next door: how they are written (`values`), which quantiles are taken (`sampling`).

use statrs::distribution::{ContinuousCDF, Normal};

/// A distribution, in the unit in which it is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Spread {
    Uniform { from: f64, to: f64 },
    LogUniform { from: f64, to: f64 },
    Normal { mean: f64, deviation: f64 },
    LogNormal { median: f64, log_deviation: f64 },
    Triangular { from: f64, mode: f64, to: f64 },
}

/// The shares nearest to none and to all that are taken: a normal distribution has no value there.
const LEAST: f64 = f64::EPSILON / 4.0;
const MOST: f64 = 1.0 - f64::EPSILON / 2.0;

impl Spread {
    /// The value below which a share of all values lies.
    ///
    /// Uniform: a + p (b − a); log-uniform: a (b/a)^p; normal: μ + σ Φ⁻¹(p); log-normal: m e^(σ Φ⁻¹(p)); triangular with mode c:
    /// a + √(p (b−a)(c−a)) below the mode, b − √((1−p)(b−a)(b−c)) above
    ///
    /// - `share`: p \[1\], from 0 to 1
    pub fn quantile(&self, share: f64) -> f64 {
        let share = share.clamp(LEAST, MOST);
        match *self {
            Self::Uniform { from, to } => from + share * (to - from),
            Self::LogUniform { from, to } => from * (to / from).powf(share),
            Self::Normal { mean, deviation } => mean + deviation * standard(share),
            Self::LogNormal { median, log_deviation } => median * (log_deviation * standard(share)).exp(),
            Self::Triangular { from, mode, to } => {
                let width = to - from;
                match share * width < mode - from {
                    true => from + (share * width * (mode - from)).sqrt(),
                    false => to - ((1.0 - share) * width * (to - mode)).sqrt(),
                }
            }
        }
    }

    /// The point `index` of `points` on a grid: ranges from end to end, other distributions at the middles of equal shares.
    pub fn grid(&self, index: u64, points: u64) -> f64 {
        let share = index as f64 / (points - 1).max(1) as f64;
        match *self {
            Self::Uniform { to, .. } | Self::LogUniform { to, .. } if index + 1 == points => to,
            Self::Uniform { from, .. } | Self::LogUniform { from, .. } if index == 0 => from,
            Self::Uniform { from, to } => from + share * (to - from),
            Self::LogUniform { from, to } => from * (to / from).powf(share),
            _ => self.quantile((index as f64 + 0.5) / points as f64),
        }
    }
}

/// Φ⁻¹(p), of the normal distribution about 0 with deviation 1.
fn standard(share: f64) -> f64 {
    Normal::standard().inverse_cdf(share)
}

#[cfg(test)]
mod tests {
    use super::Spread;

    #[test]
    fn quantiles_are_those_of_textbooks() {
        let normal = Spread::Normal { mean: 10.0, deviation: 2.0 };
        // Φ⁻¹(0.975) = 1.959963984540054 (tables to 16 digits); 1e-9 is what statrs keeps of it.
        assert!((normal.quantile(0.975) - (10.0 + 2.0 * 1.959963984540054)).abs() < 1e-9);
        assert_eq!(normal.quantile(0.5), 10.0);
        assert!(normal.quantile(0.0).is_finite() && normal.quantile(1.0).is_finite());
        let log = Spread::LogUniform { from: 1e-3, to: 1e-1 };
        assert!((log.quantile(0.5) - 1e-2).abs() < 1e-16);
        let triangle = Spread::Triangular { from: 0.0, mode: 1.0, to: 4.0 };
        // A quarter of the area lies below the mode.
        assert!((triangle.quantile(0.25) - 1.0).abs() < 1e-15);
        let skewed = Spread::LogNormal { median: 3.0, log_deviation: 0.1 };
        assert_eq!(skewed.quantile(0.5), 3.0);
    }

    #[test]
    fn a_range_on_a_grid_holds_both_ends() {
        let range = Spread::Uniform { from: 0.1, to: 0.7 };
        assert_eq!((range.grid(0, 7), range.grid(6, 7)), (0.1, 0.7));
        assert_eq!(range.grid(0, 1), 0.7);
    }
}
