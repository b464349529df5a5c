//! Stiffness and length without force, from the parts of a record in which the spring moves slowly.
//!
//! Next door: the same of a record by itself (`record_stiffness`), what is left of the forces then (`ringing`).

use super::clipping::Clipping;
use super::median::median;
use super::sampling::Sampling;
use super::settings::Settings;
use super::value::Estimate;
use crate::signals::{Channel, Signals};
use crate::uncertainty::coverage_factor;

/// Length of a block over which force and length are averaged \[s\]: a Hann mean over it lets no surge line above 20 Hz through.
pub(super) const BLOCK: f64 = 0.2;
/// Fewest blocks of a fit.
const LEAST_BLOCKS: usize = 12;
/// The least share of the length's power that must be slow. Half the power of a record of an end mass is its swing, faster than a block;
/// a twentieth still leaves such records their stiffness, while a shaken length, of which a block mean holds a thousandth, gets none.
const SLOW_SHARE: f64 = 0.05;
/// The fastest motion of the blocks of which a stiffness is given where no mode is known \[Hz\]: a coil of f1 = 10 Hz then adds up to 0.4 %.
const SLOW_ENOUGH: f64 = 0.5;
/// Largest relative standard error of a stiffness that is worth stating.
const LARGEST_ERROR: f64 = 0.03;
/// Second differences that tell the noise, about.
const LOOKED_AT: usize = 1_000_000;
/// What rounding makes of a length that stands still \[1\].
const ROUNDING: f64 = 1e-9;

/// The straight line of force over length.
#[derive(Debug, Clone, PartialEq)]
pub struct Stiffness {
    /// k \[N/m\], sensor accuracy included in its interval where it was given.
    pub stiffness: Estimate,
    /// l0 \[m\]: where the line meets zero force; of the recorded position where only one end's was recorded.
    pub length_at_zero: Estimate,
    /// Whether both ends' positions were recorded, so that l0 is a length.
    pub both_positions: bool,
    /// Shortest and longest length of the blocks \[m\].
    pub range: (f64, f64),
    /// Mean length of each block \[m\], shape `blocks`.
    pub lengths: Vec<f64>,
    /// Mean force of each block \[N\], shape `blocks`.
    pub forces: Vec<f64>,
    /// Rms of the blocks' forces about the line \[N\].
    pub scatter: f64,
    /// √(−Σ l l̈ / Σ l²) of the blocks' means \[rad/s\]: how slow "slow" was.
    pub angular_frequency: f64,
}

/// Length over time, as far as it was recorded: u2 − u1, u2, or −u1; and whether it is a length.
pub(super) fn length(signals: &Signals) -> Option<(Vec<f64>, bool)> {
    let (first, second) = (signals.channel(Channel::U1).ok(), signals.channel(Channel::U2).ok());
    match (first, second) {
        (Some(first), Some(second)) => Some((second.iter().zip(first).map(|(b, a)| b - a).collect(), true)),
        (None, Some(second)) => Some((second.to_vec(), false)),
        (Some(first), None) => Some((first.iter().map(|a| -a).collect(), false)),
        (None, None) => None,
    }
}

/// Mean of the end forces that were recorded and are not left out; F_L where there is none.
fn force(signals: &Signals, left_out: &[Channel]) -> Option<Vec<f64>> {
    let taken = |channel: Channel| signals.channel(channel).ok().filter(|_| !left_out.contains(&channel));
    let ends = [Channel::InputForce, Channel::OutputForce].map(taken);
    match ends {
        [Some(first), Some(second)] => Some(first.iter().zip(second).map(|(a, b)| 0.5 * (a + b)).collect()),
        [Some(one), None] | [None, Some(one)] => Some(one.to_vec()),
        [None, None] => taken(Channel::InductanceForce).map(<[f64]>::to_vec),
    }
}

impl Stiffness {
    /// Least squares of F = k (l − l0) over block means, the lengths' own noise taken off their variance.
    ///
    /// k = Σ(l − l̄)(F − F̄)/(Σ(l − l̄)² − B u_l²); u² = s²/Σ(l − l̄)² · (1 + ρ)/(1 − ρ) + k²(a_F² + a_x²)/3
    ///
    /// ρ: correlation of neighbouring residuals; a_F, a_x: relative limits of error of force and position, rectangular. The mean of both
    /// ends' forces is taken where both were recorded and neither is `left_out`: odd modes cancel in it. Blocks in which a force is at one of its
    /// `limits` are left out. A text says why there is none.
    pub(super) fn of(
        signals: &Signals,
        left_out: &[Channel],
        limits: &[(Channel, Clipping)],
        sampling: &Sampling,
        settings: &Settings,
    ) -> Result<Self, String> {
        let Blocks { lengths, forces, both_positions, means: (l_mean, f_mean), range, spread, angular_frequency } =
            Blocks::of(signals, left_out, limits, sampling)?;
        let count = lengths.len() as f64;
        let product: f64 = lengths.iter().zip(&forces).map(|(l, f)| (l - l_mean) * (f - f_mean)).sum();
        let k = product / spread;
        let residuals: Vec<f64> = lengths.iter().zip(&forces).map(|(l, f)| f - f_mean - k * (l - l_mean)).collect();
        let square: f64 = residuals.iter().map(|r| r * r).sum();
        let lag: f64 = residuals.windows(2).map(|pair| pair[0] * pair[1]).sum();
        let correlation = if square > 0.0 { (lag / square).clamp(0.0, 0.95) } else { 0.0 };
        let longer = (1.0 + correlation) / (1.0 - correlation);
        let variance = square / (count - 2.0) * longer;
        let own = (variance / spread).sqrt();
        if k < 0.0 && own < LARGEST_ERROR * -k {
            return Err(format!(
                "the force falls where the spring gets longer ({k:.4} ± {own:.4} N/m): the sign of a force or a position is turned"
            ));
        }
        if !(k > 0.0 && own < LARGEST_ERROR * k) {
            return Err(format!("{}: {k:.4} ± {own:.4} N/m", moved(range)));
        }
        let accuracy = (settings.accuracy_force.powi(2) + settings.accuracy_position.powi(2)) / 3.0;
        let standard = (own * own + k * k * accuracy).sqrt();
        let freedom = ((count - 2.0) / longer).max(1.0);
        let factor = coverage_factor(0.95, freedom).map_err(|error| error.to_string())?;
        let zero = l_mean - f_mean / k;
        let lever = f_mean / k;
        // The gain of a position sensor acts from its zero, so on l0 itself.
        let zero_variance = variance / count / (k * k)
            + (lever * standard / k).powi(2)
            + (zero * settings.accuracy_position).powi(2) / 3.0;
        let scatter = (square / count).sqrt();
        Ok(Self {
            stiffness: Estimate::new(k, standard, factor),
            length_at_zero: Estimate::new(zero, zero_variance.sqrt(), factor),
            both_positions,
            range,
            lengths,
            forces,
            scatter,
            angular_frequency,
        })
    }

    /// Judged by the coil's own mass: f1 \[Hz\] tells what that adds, where a mode is known.
    pub(super) fn beside_mass(mut self, first_frequency: Option<f64>) -> Result<Self, String> {
        let Some(first_frequency) = first_frequency else { return self.without_mass() };
        self.with_mass(first_frequency);
        Ok(self)
    }

    /// Its interval with what the coil's own mass adds to a stiffness at the frequency of the blocks: up to k (ωτ)²/6, τ = 1/2f1.
    pub(super) fn with_mass(&mut self, first_frequency: f64) {
        let more = self.stiffness.value * (0.5 * self.angular_frequency / first_frequency).powi(2) / 6.0;
        let wider = |estimate: &mut Estimate, more: f64| {
            let standard = estimate.standard.hypot(more);
            if estimate.standard > 0.0 {
                estimate.expanded *= standard / estimate.standard;
            }
            estimate.standard = standard;
        };
        let lever = self.forces.iter().sum::<f64>() / self.forces.len().max(1) as f64 / self.stiffness.value;
        wider(&mut self.length_at_zero, (lever * more / self.stiffness.value).abs());
        wider(&mut self.stiffness, more);
    }

    /// What is left of it where no mode is known, by which the coil's own mass could be judged: a slow one.
    fn without_mass(self) -> Result<Self, String> {
        let hertz = self.angular_frequency / std::f64::consts::TAU;
        if hertz <= SLOW_ENOUGH {
            return Ok(self);
        }
        Err(format!(
            "the ends move at {hertz:.2} Hz, and no ring-down tells what the coil's own mass adds there: no stiffness without a motion \
             slower than {SLOW_ENOUGH} Hz, or a hit"
        ))
    }

    /// k \[N/m\].
    pub fn value(&self) -> f64 {
        self.stiffness.value
    }
}

/// The slow part of a record: means of successive blocks in which no force is at a limit.
struct Blocks {
    lengths: Vec<f64>,
    forces: Vec<f64>,
    both_positions: bool,
    /// Of lengths \[m\] and forces \[N\].
    means: (f64, f64),
    /// Shortest and longest \[m\].
    range: (f64, f64),
    /// Σ (l − l̄)² less what noise adds \[m²\].
    spread: f64,
    /// √(−Σ l l̈ / Σ l²) \[rad/s\].
    angular_frequency: f64,
}

impl Blocks {
    fn of(
        signals: &Signals,
        left_out: &[Channel],
        limits: &[(Channel, Clipping)],
        sampling: &Sampling,
    ) -> Result<Self, String> {
        let (length, both_positions) =
            length(signals).ok_or("no position was recorded (u1, u2), so there is no stiffness")?;
        let force =
            force(signals, left_out).ok_or("no force at an end was recorded (F_i, F_o), so there is no stiffness")?;
        let block = ((BLOCK * sampling.rate) as usize).min(length.len() / LEAST_BLOCKS).max(4);
        let kept = unclipped(signals, limits, block);
        let of_kept = |means: Vec<f64>| -> Vec<f64> {
            means.into_iter().enumerate().filter(|(index, _)| kept(*index)).map(|(_, mean)| mean).collect()
        };
        let (lengths, forces) = (of_kept(block_means(&length, block)), of_kept(block_means(&force, block)));
        drop(force);
        if !limits.is_empty() && lengths.len() < LEAST_BLOCKS {
            return Err(
                "the force is at a limit of its range in nearly all of the record, so there is no stiffness".to_owned()
            );
        }
        let count = lengths.len() as f64;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
        let (l_mean, f_mean) = (mean(&lengths), mean(&forces));
        // Of a Hann mean over n samples the noise is √(3/2n) of one sample's.
        let noise = 1.5 / block as f64 * noise_variance(&length);
        let spread: f64 = lengths.iter().map(|l| (l - l_mean).powi(2)).sum::<f64>() - count * noise;
        let extremes = |(low, high): (f64, f64), l: &f64| (low.min(*l), high.max(*l));
        let range = lengths.iter().fold((f64::INFINITY, f64::NEG_INFINITY), extremes);
        let all = length.iter().sum::<f64>() / length.len() as f64;
        let power = length.iter().map(|l| (l - all).powi(2)).sum::<f64>() / length.len() as f64;
        let still = range.1 - range.0 <= ROUNDING * range.0.abs().max(range.1.abs());
        if still || lengths.len() < LEAST_BLOCKS || spread <= 3.0 * count * noise || spread <= 0.0 {
            return Err(moved(range));
        }
        if spread / count < SLOW_SHARE * (power - noise_variance(&length)) {
            return Err("the ends move too fast in most of the record; a stiffness needs a slow motion".to_owned());
        }
        let slow = slowness(&length, block, sampling.rate, &lengths, l_mean, &kept) / spread;
        let angular_frequency = slow.max(0.0).sqrt();
        Ok(Self { lengths, forces, both_positions, means: (l_mean, f_mean), range, spread, angular_frequency })
    }
}

/// Why lengths between these \[m\] tell no stiffness.
fn moved((shortest, longest): (f64, f64)) -> String {
    format!("the length moves by {:.3} mm only, too little for a stiffness", 1e3 * (longest - shortest))
}

/// Whether a block, by its number, has no force at one of its limits.
fn unclipped(signals: &Signals, limits: &[(Channel, Clipping)], block: usize) -> impl Fn(usize) -> bool {
    let mut clipped: Vec<bool> = Vec::new();
    for (channel, clipping) in limits {
        let Ok(values) = signals.channel(*channel) else { continue };
        let each: Vec<bool> =
            values.chunks_exact(block).map(|chunk| chunk.iter().any(|value| clipping.holds(*value))).collect();
        clipped.resize(each.len().max(clipped.len()), false);
        clipped.iter_mut().zip(each).for_each(|(all, own)| *all |= own);
    }
    move |index| !clipped.get(index).copied().unwrap_or(false)
}

/// Hann-weighted means of successive blocks.
pub(super) fn block_means(values: &[f64], block: usize) -> Vec<f64> {
    let turn = std::f64::consts::TAU / block as f64;
    let weights: Vec<f64> = (0..block).map(|n| (1.0 - (turn * (n as f64 + 0.5)).cos()) / block as f64).collect();
    values.chunks_exact(block).map(|chunk| chunk.iter().zip(&weights).map(|(x, w)| x * w).sum()).collect()
}

/// −Σ (l − l̄) l̈ over the blocks' Hann means \[m²/s²\], noise taken off: a Hann mean of l̈ is one of l weighed by the window's second derivative,
/// so that no motion faster than the blocks is mistaken for a slower one.
fn slowness(length: &[f64], block: usize, rate: f64, means: &[f64], mean: f64, kept: &dyn Fn(usize) -> bool) -> f64 {
    let turn = std::f64::consts::TAU / block as f64;
    let square = (turn * rate).powi(2);
    let weights: Vec<f64> = (0..block).map(|n| square * (turn * (n as f64 + 0.5)).cos() / block as f64).collect();
    let curved = |chunk: &[f64]| -> f64 { chunk.iter().zip(&weights).map(|(l, w)| (l - mean) * w).sum() };
    let chunks = length.chunks_exact(block).enumerate().filter(|(index, _)| kept(*index));
    let product: f64 = chunks.zip(means).map(|((_, chunk), l)| (l - mean) * curved(chunk)).sum();
    // The two means share their noise: Σ (1 − cos) cos = −n/2.
    let shared = 0.5 * square * noise_variance(length) / block as f64;
    -product - means.len() as f64 * shared
}

/// Variance of white noise on a smooth series, from its second differences (weights 1, −2, 1: six times the noise's), the median's way:
/// what jumps does not count. Of a long series every so many are looked at.
pub(super) fn noise_variance(values: &[f64]) -> f64 {
    let triples = values.windows(3).step_by((values.len() / LOOKED_AT).max(1));
    let mut squares: Vec<f64> = triples.map(|w| (w[0] - 2.0 * w[1] + w[2]).powi(2) / 6.0).collect();
    // The median of a squared normal number of variance 1.
    median(&mut squares) / 0.454_936
}
