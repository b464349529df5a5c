//! What a log's force channels can show, found before anything is fitted: how often they have a new value, what their last digit is worth,
//! where they are clipped and what was filtered away.
//!
//! Next door: when a held channel has its values (`update_clock`), limits (`clipping`), filters (`filtering`, `slow_motion`), what is then fitted (`run`).

use std::ops::Range;

use super::clipping::Clipping;
use super::sampling::Sampling;
use super::update_clock::UpdateClock;
use super::whitening::ORDER;
use super::{clipping, filtering, last_digit, slow_motion};
use crate::signals::{Channel, Signals};

/// A coarse last digit: this share of neighbouring readings, at least, is the same.
const COARSE: f64 = 0.25;
/// A clipped value after so long without one \[s\] may begin a hit.
pub(super) const QUIET: f64 = 0.2;
/// How much the rates of two forces may differ and still count as one.
const SAME_RATE: f64 = 1.1;

/// What one force channel of a record can show.
#[derive(Debug, Clone, PartialEq)]
pub struct ChannelCheck {
    /// Which.
    pub channel: Channel,
    /// How often it has a new value \[Hz\]; none where every sample is one.
    pub update_rate: Option<f64>,
    /// What its last digit is worth \[N\]; none where no step shows.
    pub last_digit: Option<f64>,
    /// Share of neighbouring values that are the same \[1\]: a quarter and more where the last digit is coarser than the noise.
    pub repeated: f64,
    /// Where it is clipped; none where it is not.
    pub clipping: Option<Clipping>,
    /// Corner of a low-pass \[Hz\], roughly; none where its noise reaches to half the rate, or nearly so.
    pub low_pass: Option<f64>,
    /// Frequency of the ends' slow motion \[Hz\], where the force misses it: a high-pass lies above; none where it shows, or nothing moves.
    pub high_pass: Option<f64>,
    /// When it has new values.
    pub(super) clock: Option<UpdateClock>,
}

/// Checks every force that was recorded.
pub(super) fn check(signals: &Signals, sampling: &Sampling) -> Vec<ChannelCheck> {
    let forces = [Channel::InputForce, Channel::OutputForce, Channel::InductanceForce];
    let present = forces.into_iter().filter_map(|channel| Some((channel, signals.channel(channel).ok()?)));
    present.map(|(channel, values)| of(channel, values, signals, sampling)).collect()
}

/// The forces that are clipped, and where.
pub(super) fn limits(checks: &[ChannelCheck]) -> Vec<(Channel, Clipping)> {
    checks.iter().filter_map(|check| Some((check.channel, check.clipping?))).collect()
}

fn of(channel: Channel, recorded: &[f64], signals: &Signals, sampling: &Sampling) -> ChannelCheck {
    let last_digit = last_digit::of(recorded);
    let clock = UpdateClock::of(recorded, last_digit);
    let own: Option<Vec<f64>> = clock.map(|clock| clock.samples(recorded.len()).map(|at| recorded[at]).collect());
    let (values, ratio) = (own.as_deref().unwrap_or(recorded), clock.map_or(1.0, |clock| clock.ratio));
    let rate = sampling.rate / ratio;
    let repeated = values.windows(2).filter(|pair| pair[0] == pair[1]).count() as f64 / values.len().max(2) as f64;
    let clipping = clipping::of(values, last_digit.unwrap_or(0.0));
    // A digit coarser than the noise leaves no floor to judge by.
    let low_pass = (repeated < COARSE).then(|| filtering::low_pass(values, rate)).flatten();
    let high_pass = slow_motion::missing(signals, channel, sampling);
    let update_rate = clock.map(|_| rate);
    ChannelCheck { channel, update_rate, last_digit, repeated, clipping, low_pass, high_pass, clock }
}

/// The record at the pace of its forces: as it is, where a force has a new value at every sample; else at the update rate of the fastest
/// force, without forces that are slower. None where it is as it is.
pub(super) fn at_own_pace(signals: &Signals, checks: &[ChannelCheck]) -> Option<Signals> {
    let ratio = |check: &ChannelCheck| check.clock.map_or(1.0, |clock| clock.ratio);
    let ends = checks.iter().filter(|check| check.channel != Channel::InductanceForce);
    let fastest = ends.chain(checks).min_by(|a, b| ratio(a).total_cmp(&ratio(b)))?;
    let slower: Vec<Channel> =
        checks.iter().filter(|check| ratio(check) > SAME_RATE * ratio(fastest)).map(|check| check.channel).collect();
    if fastest.clock.is_none() && slower.is_empty() {
        return None;
    }
    let time = signals.time();
    let (times, at): (Vec<f64>, Vec<usize>) = match fastest.clock {
        Some(clock) => {
            let at: Vec<usize> = clock.samples(time.len()).collect();
            let step = (time[time.len() - 1] - time[0]) / (time.len() - 1) as f64 * clock.ratio;
            ((0..at.len()).map(|tick| time[at[0]] + step * tick as f64).collect(), at)
        }
        None => (time.to_vec(), (0..time.len()).collect()),
    };
    let mut paced = Signals::new(times).ok()?;
    for (channel, values) in signals.channels().filter(|(channel, _)| !slower.contains(channel)) {
        paced.insert(channel, at.iter().map(|&index| values[index]).collect()).ok()?;
    }
    Some(paced)
}

/// What the channels leave to hits and lines.
#[derive(Debug, Clone, Default)]
pub(super) struct Conditions {
    /// The lowest corner of a low-pass \[Hz\].
    pub(super) low_pass: Option<f64>,
    /// Standard deviation of what last digits add to a sample of a series \[N\].
    pub(super) rounding: f64,
    /// Samples at which a force is clipped, first to last.
    pub(super) clipped: Vec<usize>,
}

impl Conditions {
    /// Of the forces that a record (at its own pace) holds.
    pub(super) fn of(signals: &Signals, checks: &[ChannelCheck]) -> Self {
        let ends = |channel: &Channel| *channel != Channel::InductanceForce;
        let any = checks.iter().any(|check| ends(&check.channel) && signals.channel(check.channel).is_ok());
        let used = checks.iter().filter(|check| ends(&check.channel) == any);
        let used: Vec<(&ChannelCheck, &[f64])> =
            used.filter_map(|check| Some((check, signals.channel(check.channel).ok()?))).collect();
        let corners = used.iter().filter_map(|(check, _)| check.low_pass);
        let digits = used.iter().filter_map(|(check, _)| check.last_digit).map(|digit| digit * digit).sum::<f64>();
        let mut clipped: Vec<usize> = Vec::new();
        for (check, values) in &used {
            if let Some(clipping) = check.clipping {
                clipped.extend((0..values.len()).filter(|&index| clipping.holds(values[index])));
            }
        }
        clipped.sort_unstable();
        clipped.dedup();
        // Difference and sum are halved.
        let rounding = (digits / 12.0).sqrt() / used.len().max(1) as f64;
        Self { low_pass: corners.reduce(f64::min), rounding, clipped }
    }

    /// Whether any sample of a range is clipped.
    pub(super) fn any_clipped(&self, range: Range<usize>) -> bool {
        self.clipped.get(self.clipped.partition_point(|&at| at < range.start)).is_some_and(|&at| at < range.end)
    }

    /// The last clipped sample of a range.
    pub(super) fn last_clipped(&self, range: Range<usize>) -> Option<usize> {
        let last = self.clipped[..self.clipped.partition_point(|&at| at < range.end)].last();
        last.copied().filter(|at| *at >= range.start)
    }

    /// Zeroes what clipped samples make of every `step`th sample's surprise, which takes `ORDER` past ones; the first one after quiet stays,
    /// for a hit may begin with it.
    pub(super) fn leave_out_clipped(&self, squares: &mut [f64], step: usize, rate: f64) {
        if self.clipped.is_empty() {
            return;
        }
        let quiet = (QUIET * rate) as usize;
        for (index, square) in squares.iter_mut().enumerate() {
            let at = index * step;
            let begin =
                if self.any_clipped(at..at + 1) { at.saturating_sub(quiet) } else { at.saturating_sub(ORDER * step) };
            if self.any_clipped(begin..at) {
                *square = 0.0;
            }
        }
    }
}

/// The forces that do not follow the slow motion, of which no stiffness follows.
pub(super) fn without_slow_motion(checks: &[ChannelCheck]) -> Vec<Channel> {
    checks.iter().filter(|check| check.high_pass.is_some()).map(|check| check.channel).collect()
}

/// What of the checks a reader should know, a sentence each.
pub(super) fn sentences(checks: &[ChannelCheck]) -> Vec<String> {
    let fastest = checks.iter().map(|check| check.clock.map_or(1.0, |clock| clock.ratio)).fold(f64::INFINITY, f64::min);
    checks.iter().flat_map(|check| of_channel(check, fastest)).collect()
}

fn of_channel(check: &ChannelCheck, fastest: f64) -> Vec<String> {
    let name = check.channel.name();
    let mut said = Vec::new();
    if let (Some(rate), Some(clock)) = (check.update_rate, check.clock) {
        let (apart, half) = (1e3 / rate, 0.5 * rate);
        let left_out = if clock.ratio > SAME_RATE * fastest { "; it is left out of what rings" } else { "" };
        said.push(format!(
            "{name} has a new value only every {} ms ({} Hz): lines above {} Hz are folded in it{left_out}",
            short(apart),
            short(rate),
            short(half)
        ));
    }
    if let Some(clipping) = check.clipping {
        let limits: Vec<String> =
            [clipping.low, clipping.high].into_iter().flatten().map(|at| format!("{at:.4} N")).collect();
        said.push(format!(
            "{name} is clipped at {} ({} % of its values): only what comes after the last clipped value of a hit is fitted",
            limits.join(" and "),
            short(100.0 * clipping.share)
        ));
    }
    if let Some(corner) = check.low_pass {
        said.push(format!(
            "{name} is low-passed at about {} Hz: modes above that are weak in it, or missing",
            short(corner)
        ));
    }
    if let Some(corner) = check.high_pass {
        said.push(format!(
            "{name} does not follow the ends' slow motion at {} Hz, as behind a high-pass: no stiffness follows from it, and modes below the filter's \
             corner are missing",
            short(corner)
        ));
    }
    if let Some(digit) = check.last_digit.filter(|_| check.repeated >= COARSE) {
        said.push(format!("the last digit of {name} is worth {} N, more than its noise", short(digit)));
    }
    said
}

/// Three significant digits.
fn short(value: f64) -> String {
    let digits = (2 - value.abs().max(1e-12).log10().floor() as i32).clamp(0, 9) as usize;
    let text = format!("{value:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
