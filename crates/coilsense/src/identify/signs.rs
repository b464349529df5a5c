//! Which channel's sign is turned: a spring pulls alike at both ends when it moves slowly, and harder the longer it is.
//!
//! Next door: what rings (`explain`), the stiffness (`quasi_static`).

use super::quasi_static::{block_means, length};
use super::sampling::Sampling;
use crate::signals::{Channel, Signals};

/// Correlation above which slow parts decide.
const SURE: f64 = 0.9;
/// Blocks \[s\] over which ringing averages out.
const BLOCK: f64 = 0.2;

/// What slow motion says of the signs.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Signs {
    /// Whether F_o goes against F_i; none where nothing tells.
    pub(super) opposed: Option<bool>,
    /// The channel whose sign is turned, where slow motion tells which.
    pub(super) turned: Option<Channel>,
}

/// The signs of a record's forces, by its slow parts.
pub(super) fn of(signals: &Signals, sampling: &Sampling) -> Signs {
    let block = ((BLOCK * sampling.rate) as usize).clamp(4, sampling.samples.max(48) / 12);
    let force = |channel: Channel| signals.channel(channel).ok().map(|values| block_means(values, block));
    let (input, output) = (force(Channel::InputForce), force(Channel::OutputForce));
    let slope = |force: &Option<Vec<f64>>| {
        let length = block_means(&length(signals)?.0, block);
        let one = correlation(&length, force.as_ref()?, true);
        (one.abs() > SURE).then_some(one)
    };
    let falls = [slope(&input), slope(&output)].map(|slope| slope.map(|slope| slope < 0.0));
    let turned = match falls {
        [Some(true), Some(true)] | [Some(true), None] | [None, Some(true)] => Some(Channel::U1),
        [Some(true), Some(false)] => Some(Channel::InputForce),
        [Some(false), Some(true)] => Some(Channel::OutputForce),
        _ => None,
    };
    let opposed = match (falls, &input, &output) {
        ([Some(input), Some(output)], ..) => Some(input != output),
        // Without a slow motion, what both hold still against; ringing alone goes either way.
        (_, Some(input), Some(output)) if stands(input) && stands(output) => {
            let one = correlation(input, output, false);
            (one.abs() > SURE).then_some(one < 0.0)
        }
        _ => None,
    };
    Signs { opposed, turned }
}

/// Whether a force's mean is far larger than what it does about it.
fn stands(blocks: &[f64]) -> bool {
    let count = blocks.len().max(1) as f64;
    let mean = blocks.iter().sum::<f64>() / count;
    let square = blocks.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / count;
    mean.abs() > 3.0 * square.sqrt()
}

/// A record with one channel's sign turned; none where the record lacks it.
pub(super) fn with_turned(signals: &Signals, channel: Channel) -> Option<Signals> {
    let values = signals.channel(channel).ok()?.iter().map(|value| -value).collect();
    let mut turned = signals.clone();
    turned.insert(channel, values).ok()?;
    Some(turned)
}

/// Σ ab/√(Σa² Σb²), with the means taken out or not.
fn correlation(a: &[f64], b: &[f64], centred: bool) -> f64 {
    let mean = |values: &[f64]| if centred { values.iter().sum::<f64>() / values.len().max(1) as f64 } else { 0.0 };
    let (of_a, of_b) = (mean(a), mean(b));
    let sum = |f: &dyn Fn(f64, f64) -> f64| a.iter().zip(b).map(|(a, b)| f(a - of_a, b - of_b)).sum::<f64>();
    let power = (sum(&|a, _| a * a) * sum(&|_, b| b * b)).sqrt();
    if power > 0.0 { sum(&|a, b| a * b) / power } else { 0.0 }
}
