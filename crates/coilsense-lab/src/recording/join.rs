//! Two devices that recorded the same motion, on one clock.
//!
//! Next door: offset and drift between the clocks (`coilsense::measures::ClockOffset`), each device's own log (`mod`).

use coilsense::measures::ClockOffset;
use coilsense::{Channel, Signals};

use super::Recording;
use super::account::{Joined, Reason};
use super::error::{RecordingError, window};
use super::row::between;
use super::telling::seconds;
use crate::message::{Hint, Message};
use crate::quantity::Dimension;

/// What is known about the second device's clock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Clock {
    /// Seconds to add to its times \[s\].
    Offset(f64),
    /// It is found where both recorded the same motion: by these channels of the first and the second device, or one that both have.
    Found(Option<[Channel; 2]>),
}

impl Clock {
    /// From an offset such as `-0.2 s`, `auto`, or two channels as in `F_o=F_x`.
    ///
    /// # Errors
    /// What is allowed.
    pub fn parse(text: &str) -> Result<Self, String> {
        let channel = |name: &str| Channel::ALL.into_iter().find(|channel| channel.name() == name.trim());
        if text == "auto" {
            return Ok(Self::Found(None));
        }
        if let Some((mine, theirs)) = text.split_once('=') {
            let pair = channel(mine).zip(channel(theirs)).map(|(mine, theirs)| [mine, theirs]);
            let names = Channel::ALL.map(Channel::name).join(", ");
            return pair
                .map(|pair| Self::Found(Some(pair)))
                .ok_or_else(|| format!("must name two of {names}, as in F_o=F_x"));
        }
        let offset = Dimension::Time.parse(text).filter(|time| time.is_finite()).map(Self::Offset);
        let allowed = Dimension::Time.expectation();
        offset.ok_or_else(|| format!("must be {allowed}, as in \"10 ms\", or auto, or two channels as in F_o=F_x"))
    }
}

/// Most samples of an even clock on which two devices are compared.
const MOST_SAMPLES: f64 = 4e6;

/// How far an offset is off without any noise, in the second device's steps \[1\].
const CLOCK_OFF: f64 = 1e-3;

impl Recording {
    /// Adds the channels of a second device that this one has not, on this one's times; rows where the second has no values are left out.
    ///
    /// # Errors
    /// [`RecordingError`] where the offset cannot be found, or no times are in common.
    pub fn joined(mut self, other: &Self, clock: Clock) -> Result<Self, RecordingError> {
        let joined = self.offset_of(other, clock)?;
        let wrong = |message: String| RecordingError::of_file(&other.account.file, message);
        let (time, theirs) = (self.signals.time(), other.signals.time());
        let (Some(first), Some(last)) = (theirs.first(), theirs.last()) else { return Ok(self) };
        // An offset that is off by less than it can be found must not cost a row.
        let slack = CLOCK_OFF * (last - first) / (theirs.len() as f64 - 1.0).max(1.0);
        let shared = |time: f64| (first - slack..=last + slack).contains(&joined.own(time));
        let kept: Vec<usize> = (0..time.len()).filter(|&row| shared(time[row])).collect();
        if kept.is_empty() {
            let (from, to) = (joined.of_first(*first), joined.of_first(*last));
            return Err(wrong(format!(
                "covers {from} s to {to} s on the first device's clock, where that has no rows"
            )));
        }
        let lost = (time.len() - kept.len()) as u64;
        let times: Vec<f64> = kept.iter().map(|&row| time[row]).collect();
        let pick = |values: &[f64]| kept.iter().map(|&row| values[row]).collect::<Vec<f64>>();
        let science = |error: coilsense::Error| wrong(error.to_string());
        let mut signals = Signals::new(times.clone()).map_err(science)?;
        for (channel, values) in self.signals.channels() {
            signals.insert(channel, pick(values)).map_err(science)?;
        }
        for (channel, values) in other.signals.channels() {
            if self.signals.channel(channel).is_err() {
                let own: Vec<f64> = times.iter().map(|time| joined.own(*time)).collect();
                signals.insert(channel, interpolated(theirs, values, &own)).map_err(science)?;
            }
        }
        if lost > 0 {
            let line = 0;
            self.account.left_out.insert(Reason::OtherDevice, super::Tally { count: lost, line });
        }
        self.account.rows = times.len() as u64;
        self.account.span = times.first().zip(times.last()).map(|(from, to)| [*from, *to]);
        self.account.joined = Some(Box::new(joined));
        self.remarks.extend(other.remarks.iter().cloned());
        Ok(Self { signals, ..self })
    }

    fn offset_of(&self, other: &Self, clock: Clock) -> Result<Joined, RecordingError> {
        let account = other.account.clone();
        let pair = match clock {
            Clock::Offset(offset) => return Ok(Joined { account, offset, found: None }),
            Clock::Found(Some(pair)) => pair,
            Clock::Found(None) => self.common(other)?,
        };
        let [mine, theirs] = [self.channel(pair[0])?, other.channel(pair[1])?];
        let wrong = |message: Message| RecordingError::of_file(&other.account.file, message);
        let step = |recording: &Self| recording.account.resampled.map(f64::recip).or(recording.account.interval);
        let interval = step(self).into_iter().chain(step(other)).fold(f64::INFINITY, f64::min);
        let even = |times: &[f64], values: &[f64]| {
            let (first, last) = (times.first().copied().unwrap_or(0.0), times.last().copied().unwrap_or(0.0));
            let samples = ((last - first) / interval).floor();
            let clock: Vec<f64> =
                (0..=samples.min(MOST_SAMPLES) as usize).map(|n| first + n as f64 * interval).collect();
            let most = seconds(MOST_SAMPLES * interval);
            let message = || {
                let text = format!("is too long to find its clock's offset; take up to {most} by ");
                Message::from(text) + window()
            };
            if samples <= MOST_SAMPLES { Ok(interpolated(times, values, &clock)) } else { Err(wrong(message())) }
        };
        let (a, b) = (even(self.signals.time(), mine)?, even(other.signals.time(), theirs)?);
        let starts = [self, other].map(|recording| recording.signals.time().first().copied().unwrap_or(0.0));
        let found = ClockOffset::between(&a, &b, starts, interval).map_err(|error| {
            let [mine, theirs] = pair.map(Channel::name);
            wrong(format!("its clock's offset cannot be found by {mine} and {theirs}: {error}").into())
        })?;
        Ok(Joined { account, offset: found.offset, found: Some((pair.map(Channel::name), found)) })
    }

    /// The first channel that both have.
    fn common(&self, other: &Self) -> Result<[Channel; 2], RecordingError> {
        let names = |recording: &Self| {
            let names: Vec<&str> = recording.signals.channels().map(|(channel, _)| channel.name()).collect();
            names.join(", ")
        };
        let both =
            self.signals.channels().map(|(channel, _)| channel).find(|channel| other.signals.channel(*channel).is_ok());
        let message = || {
            Message::from(format!("it has {}, the first device {}: no channel is in both; ", names(other), names(self)))
                + "name two that saw the same motion, as in "
                + Hint::Pair("clock", ["F_o", "F_x"])
                + ", or give the offset"
        };
        both.map(|channel| [channel; 2]).ok_or_else(|| RecordingError::of_file(&other.account.file, message()))
    }
}

/// Values at rising `at`, on straight lines between rising `times`; beyond the ends, those of the ends.
fn interpolated(times: &[f64], values: &[f64], at: &[f64]) -> Vec<f64> {
    let mut next = 0;
    let one = |&time: &f64| {
        while next < times.len() && times[next] < time {
            next += 1;
        }
        match (next.checked_sub(1), times.get(next)) {
            (Some(before), Some(_)) => between((times[before], values[before]), (times[next], values[next]), time),
            (None, _) => values.first().copied().unwrap_or(0.0),
            (Some(last), None) => values[last],
        }
    };
    at.iter().map(one).collect()
}
