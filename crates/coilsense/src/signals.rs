//! Signals over time, simulated or measured: the one door through which measures see them.
//!
//! Next door: who makes them (`motion`, `sensors`), who judges them (`measures`).

use crate::error::{Error, all_finite, called, check, count, entry};

/// Name of a signal; the same word everywhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Channel {
    /// `u1`: position of end 1 \[m\].
    U1,
    /// `u2`: position of end 2 \[m\].
    U2,
    /// `F_i`: force at end 1 \[N\].
    InputForce,
    /// `F_o`: force at end 2 \[N\].
    OutputForce,
    /// `F_x`: force by the ends' positions \[N\].
    DeflectionForce,
    /// `F_L`: force by the inductance \[N\].
    InductanceForce,
    /// `L`: inductance \[H\].
    Inductance,
    /// `R`: resistance of the coil by the same meter \[Ohm\].
    Resistance,
}

impl Channel {
    /// All channels, in the order in which files hold them.
    pub const ALL: [Self; 8] = [
        Self::U1,
        Self::U2,
        Self::InputForce,
        Self::OutputForce,
        Self::DeflectionForce,
        Self::InductanceForce,
        Self::Inductance,
        Self::Resistance,
    ];

    /// The four forces of the paper: F_i, F_o, F_x, F_L.
    pub const FORCES: [Self; 4] = [Self::InputForce, Self::OutputForce, Self::DeflectionForce, Self::InductanceForce];

    /// Its name in files, tables and figures.
    pub fn name(self) -> &'static str {
        match self {
            Self::U1 => "u1",
            Self::U2 => "u2",
            Self::InputForce => "F_i",
            Self::OutputForce => "F_o",
            Self::DeflectionForce => "F_x",
            Self::InductanceForce => "F_L",
            Self::Inductance => "L",
            Self::Resistance => "R",
        }
    }

    /// The channel of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|channel| channel.name() == name)
    }

    /// Its SI unit.
    pub fn unit(self) -> &'static str {
        match self {
            Self::U1 | Self::U2 => "m",
            Self::Inductance => "H",
            Self::Resistance => "Ohm",
            Self::InputForce | Self::OutputForce | Self::DeflectionForce | Self::InductanceForce => "N",
        }
    }
}

/// Time and one series per channel, all of the same length, all finite.
#[derive(Debug, Clone, PartialEq)]
pub struct Signals {
    time: Vec<f64>,
    channels: Vec<(Channel, Vec<f64>)>,
}

impl Signals {
    /// Signals over `time` \[s\], shape `samples`, without a channel yet.
    ///
    /// # Errors
    /// [`Error::Value`] for the first time that is not finite or not after its predecessor.
    pub fn new(time: Vec<f64>) -> Result<Self, Error> {
        increasing(&time)?;
        Ok(Self { time, channels: Vec::new() })
    }

    /// Adds a channel, or replaces it.
    ///
    /// # Errors
    /// [`Error::Count`] where `values` has not one value per time; [`Error::Value`] for the first that is not finite.
    pub fn insert(&mut self, channel: Channel, values: Vec<f64>) -> Result<(), Error> {
        count(called("values", channel.name()), values.len(), self.time.len())?;
        all_finite(called("values", channel.name()), &values, channel.unit())?;
        self.channels.retain(|(present, _)| *present != channel);
        let at = self.channels.partition_point(|(present, _)| *present < channel);
        self.channels.insert(at, (channel, values));
        Ok(())
    }

    /// Time \[s\], shape `samples`.
    pub fn time(&self) -> &[f64] {
        &self.time
    }

    /// The channels that are there, in the order of [`Channel::ALL`].
    pub fn channels(&self) -> impl Iterator<Item = (Channel, &[f64])> {
        self.channels.iter().map(|(channel, values)| (*channel, values.as_slice()))
    }

    /// Time and channels, moved out.
    pub fn into_parts(self) -> (Vec<f64>, Vec<(Channel, Vec<f64>)>) {
        (self.time, self.channels)
    }

    /// One channel, shape `samples`.
    ///
    /// # Errors
    /// [`Error::MissingSignal`] where it is not there.
    pub fn channel(&self, channel: Channel) -> Result<&[f64], Error> {
        self.channels()
            .find(|(present, _)| *present == channel)
            .map(|(_, values)| values)
            .ok_or(Error::MissingSignal(channel.name()))
    }
}

/// Lets through finite times of which each is above its predecessor.
pub(crate) fn increasing(times: &[f64]) -> Result<&[f64], Error> {
    all_finite("time", times, "s")?;
    let rising = |pairs: &[f64]| pairs.windows(2).fold(true, |so_far, pair| so_far & (pair[0] < pair[1]));
    // In overlapping chunks, without leaving one early: so the compiler takes several at once.
    if (0..times.len().saturating_sub(1)).step_by(256).all(|from| rising(&times[from..times.len().min(from + 257)])) {
        return Ok(times);
    }
    match (1..times.len()).find(|&index| times[index] <= times[index - 1]) {
        None => Ok(times),
        Some(index) => {
            let allowed = format!("above its predecessor of {} s", times[index - 1]);
            check(false, entry("time", index), times[index], "s", allowed).map(|_| times)
        }
    }
}

/// Times \[s\] of a window sampled at a constant rate, both ends included: k / rate for whole numbers k.
///
/// - `rate`: samples per second \[Hz\]; `from`, `to`: the window \[s\]
///
/// # Errors
/// [`Error::Value`] for a rate that is not above zero, a window that starts below zero or ends before it starts, or more than 1e9 samples.
///
/// ```
/// let times = coilsense::signals::sampled_window(10_000.0, 0.75, 1.0)?;
/// assert_eq!(times.len(), 2501);
/// assert_eq!((times[0], times[2500]), (0.75, 1.0));
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn sampled_window(rate: f64, from: f64, to: f64) -> Result<Vec<f64>, Error> {
    crate::error::above_zero(called("rate", "sample rate"), rate, "Hz")?;
    let starts = from.is_finite() && from >= 0.0;
    check(starts, called("from", "window start"), from, "s", "finite and not below zero")?;
    check(
        to.is_finite() && to >= from,
        called("to", "window end"),
        to,
        "s",
        format!("not before its start of {from} s"),
    )?;
    // A bound that rounds just past a sample still means that sample.
    let first = (from * rate - 1e-6).ceil();
    let last = (to * rate + 1e-6).floor();
    let samples = last - first + 1.0;
    check(samples <= 1e9, "samples", samples, "", "at most 1e9")?;
    Ok((0..samples as usize).map(|index| (first + index as f64) / rate).collect())
}
