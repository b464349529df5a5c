//! Maxwell's sum about uniform turns, for the pitches of several samples at once, one sample to a lane: no vector is ever half full.
//!
//! Next door: the displacements (`quadratic`), the form and its bound (`second_order`), one pair (`reduced`).

use super::maxwell::MaxwellSum;
use super::mutual::MU_0;
use super::reduced;
use crate::simd;

/// Samples that are evaluated together.
pub(super) const LANES: usize = 8;

/// A number of each sample.
pub(super) type Lanes = [f64; LANES];

/// L of uniform turns at pitch p and its derivatives by the turns; entry a − 1 of a series by lag belongs to turns a apart.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Expansion {
    /// p \[m\].
    pub(super) pitches: Lanes,
    /// L0 \[H\].
    pub(super) inductance: Lanes,
    /// ∂L/∂x_t \[H/m\], by turn.
    pub(super) gradient: Vec<Lanes>,
    /// M″(ap) \[H/m²\], by lag.
    pub(super) curvatures: Vec<Lanes>,
    /// ⅓ |M‴(ap)| ap \[H/m²\], by lag.
    pub(super) remainders: Vec<Lanes>,
    /// h/r by lag, then F and its derivatives there.
    ratios: Vec<Lanes>,
    reduced: [Vec<Lanes>; 4],
}

impl Expansion {
    pub(super) fn new(turns: usize) -> Self {
        let by_lag = || vec![[0.0; LANES]; turns.saturating_sub(1)];
        Self {
            pitches: [f64::NAN; LANES],
            inductance: [0.0; LANES],
            gradient: vec![[0.0; LANES]; turns],
            curvatures: by_lag(),
            remainders: by_lag(),
            ratios: by_lag(),
            reduced: [by_lag(), by_lag(), by_lag(), by_lag()],
        }
    }

    /// Expands about pitches \[m\], unless it is there already.
    pub(super) fn expand(&mut self, coil: &MaxwellSum, pitches: Lanes) {
        if self.pitches != pitches {
            self.pitches = pitches;
            simd::dispatch(Expand { expansion: self, coil });
        }
    }

    #[inline(always)]
    fn fill<const FUSED: bool>(&mut self, coil: &MaxwellSum) {
        let radius = coil.coil_radius();
        for (lag, ratios) in self.ratios.iter_mut().enumerate() {
            for (ratio, pitch) in ratios.iter_mut().zip(&self.pitches) {
                *ratio = (lag + 1) as f64 * pitch / radius;
            }
        }
        let [value, first, second, third] = self.reduced.each_mut().map(|order| order.as_flattened_mut().iter_mut());
        let orders = value.zip(first).zip(second).zip(third);
        for (ratio, (((value, first), second), third)) in self.ratios.as_flattened().iter().zip(orders) {
            [*value, *first, *second, *third] = reduced::with_derivatives::<FUSED>(*ratio);
        }
        self.sum_values(coil);
        self.sum_slopes();
        self.scale_curvatures(radius);
    }

    #[inline(always)]
    fn sum_values(&mut self, coil: &MaxwellSum) {
        let mut pairs = [0.0; LANES];
        let lags = self.reduced[0].len();
        for (lag, values) in self.reduced[0].iter().enumerate() {
            for (sum, value) in pairs.iter_mut().zip(values) {
                *sum += (lags - lag) as f64 * value;
            }
        }
        self.inductance = pairs.map(|sum| coil.self_part() + 4.0 * MU_0 * coil.coil_radius() * sum);
    }

    /// g_t = 2 Σ_{a≤t} M′(ap) − 2 Σ_{a≤N−1−t} M′(ap), turns counted from zero: what is behind a turn pushes, what is before it pulls.
    #[inline(always)]
    fn sum_slopes(&mut self) {
        self.gradient.fill([0.0; LANES]);
        let mut sums = [0.0; LANES];
        let last = self.reduced[1].len();
        for (lag, derivatives) in self.reduced[1].iter().enumerate() {
            for (lane, sum) in sums.iter_mut().enumerate() {
                *sum += 4.0 * MU_0 * derivatives[lane];
                self.gradient[lag + 1][lane] += *sum;
                self.gradient[last - 1 - lag][lane] -= *sum;
            }
        }
    }

    #[inline(always)]
    fn scale_curvatures(&mut self, radius: f64) {
        let (curvature, remainder) = (2.0 * MU_0 / radius, 2.0 * MU_0 / (3.0 * radius));
        for lag in 0..self.curvatures.len() {
            for lane in 0..LANES {
                self.curvatures[lag][lane] = curvature * self.reduced[2][lag][lane];
                self.remainders[lag][lane] = -remainder * self.reduced[3][lag][lane] * self.ratios[lag][lane];
            }
        }
    }
}

/// One call of [`Expansion::expand`].
struct Expand<'a> {
    expansion: &'a mut Expansion,
    coil: &'a MaxwellSum,
}

impl pulp::WithSimd for Expand<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        if S::IS_SCALAR {
            self.expansion.fill::<false>(self.coil);
        } else {
            self.expansion.fill::<true>(self.coil);
        }
    }
}
