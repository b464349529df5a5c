//! Whether a force shows the slow motion of the ends: behind a high-pass it does not.
//!
//! Next door: the stiffness that follows where it does (`quasi_static`), what else a channel can show (`channel_check`).

use super::quasi_static::{BLOCK, block_means, length, noise_variance};
use super::sampling::Sampling;
use crate::signals::{Channel, Signals};

/// Fewest blocks.
const LEAST_BLOCKS: usize = 24;
/// The fastest motion that blocks still follow \[Hz\].
const FASTEST: f64 = 1.0;
/// How many times the noise of its blocks the length's motion is, at least.
const CLEAR: f64 = 30.0;
/// The least part of a force out of phase with the length that only a filter makes: sin 20°. A damper, friction or a late channel make less.
const LEAD: f64 = 0.35;
/// Share of the force's swing that slow motion must show to be there.
const SHOWS: f64 = 0.01;
/// How many times its standard error a part of the force is, to be there.
const SURE: f64 = 6.0;

/// Frequency of the ends' slow motion \[Hz\], where the force misses it or runs ahead of it; none where it follows, or nothing moves.
///
/// Least squares of F = a + k l + c l̇ over Hann means of blocks; a high-pass below its corner leaves k l small, or turns it by up to 90° per
/// order.
pub(super) fn missing(signals: &Signals, channel: Channel, sampling: &Sampling) -> Option<f64> {
    let (length, _) = length(signals)?;
    let force = signals.channel(channel).ok()?;
    let block = ((BLOCK * sampling.rate) as usize).max(4);
    if length.len() < LEAST_BLOCKS * block {
        return None;
    }
    let noise = 1.5 / block as f64 * noise_variance(&length);
    let (lengths, forces) = (block_means(&length, block), block_means(force, block));
    let spacing = block as f64 / sampling.rate;
    let inner = 1..lengths.len() - 1;
    let count = inner.len() as f64;
    let rates: Vec<f64> = inner.clone().map(|n| (lengths[n + 1] - lengths[n - 1]) / (2.0 * spacing)).collect();
    let centred = |values: &[f64]| {
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        values.iter().map(|value| value - mean).collect::<Vec<f64>>()
    };
    let (l, v, f) = (centred(&lengths[inner.clone()]), centred(&rates), centred(&forces[inner]));
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let (ll, lv, vv) = (dot(&l, &l), dot(&l, &v), dot(&v, &v));
    let angular = (vv / ll.max(f64::MIN_POSITIVE)).sqrt();
    let determinant = ll * vv - lv * lv;
    let rounding = 1e-9 * lengths.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let moves = ll > CLEAR * CLEAR * count * noise.max(rounding * rounding);
    if !moves || angular > std::f64::consts::TAU * FASTEST || determinant <= 1e-3 * ll * vv {
        return None;
    }
    let (fl, fv) = (dot(&f, &l), dot(&f, &v));
    let (k, c) = ((vv * fl - lv * fv) / determinant, (ll * fv - lv * fl) / determinant);
    let left = l.iter().zip(&v).zip(&f).map(|((l, v), f)| (f - k * l - c * v).powi(2)).sum::<f64>() / (count - 3.0);
    // Neighbouring blocks' errors are alike where ringing or drift is left in them: four times the variance of independent ones.
    let sure = |estimate: f64, other: f64| estimate.abs() > SURE * (4.0 * left * other / determinant).sqrt();
    // Amplitudes of a sine of the same power.
    let (along, ahead) = (k * (2.0 * ll / count).sqrt(), c * (2.0 * vv / count).sqrt());
    let (low, high) =
        force.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), f| (low.min(*f), high.max(*f)));
    // A soft spring's force moves little too, but along with its length.
    let small = along.hypot(ahead) < SHOWS * 0.5 * (high - low);
    let none = small && !(k > 0.0 && sure(k, vv));
    // What blocks leave of strong ringing near 15 Hz is a slow beat.
    let turned = !small && sure(c, ll) && ahead.abs() > LEAD * along.hypot(ahead);
    (none || turned).then_some(angular / std::f64::consts::TAU)
}
