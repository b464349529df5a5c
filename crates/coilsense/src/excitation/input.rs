//! How one end is driven over time: what the drive is, and its jumps.
//!
//! Next door: a recorded series (`sampled`), both ends and the start together (the parent).

use std::f64::consts::{PI, TAU};

use super::event::{Kick, Sine};
use super::sampled::Sampled;
use crate::error::{Error, above_zero, called, check, finite, from_zero};

/// One sine: a sin(2πft + phase).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Harmonic {
    /// a \[m, or N at an end under force\].
    pub amplitude: f64,
    /// f \[Hz\], above zero.
    pub frequency: f64,
    /// Phase at t = 0 \[rad\].
    pub phase: f64,
}

/// How an end is driven, counted from its mean: metres where its position is prescribed, newtons where its force is.
#[derive(Debug, Clone, PartialEq)]
pub enum EndInput {
    /// It stays at its mean.
    Held,
    /// A sum of sines.
    Harmonics(Vec<Harmonic>),
    /// A sine whose frequency runs linearly from one value to another, and which then stays where it is.
    Chirp {
        /// a \[m or N\].
        amplitude: f64,
        /// Frequency at t = 0 \[Hz\], not below zero.
        from: f64,
        /// Frequency at the end of the chirp \[Hz\], not below zero.
        to: f64,
        /// How long it lasts \[s\], above zero.
        duration: f64,
        /// Phase at t = 0 \[rad\].
        phase: f64,
    },
    /// A jump: what a ramp becomes as it gets shorter, the impulse that it gives through damping included. One at t = 0 comes right after
    /// the start; a massless start has followed it.
    Step {
        /// How far \[m or N\].
        height: f64,
        /// When \[s\], not below zero.
        at: f64,
    },
    /// A straight rise.
    Ramp {
        /// How far \[m or N\].
        height: f64,
        /// When it begins \[s\], not below zero.
        from: f64,
        /// How long it lasts \[s\], above zero.
        duration: f64,
    },
    /// Half a sine, up and back: a bump.
    HalfSine {
        /// How far \[m or N\].
        height: f64,
        /// When it begins \[s\], not below zero.
        from: f64,
        /// How long it lasts \[s\], above zero.
        duration: f64,
    },
    /// A recorded series, straight from sample to sample (first-order hold).
    Sampled(Sampled),
}

/// What an input holds over frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Content<'a> {
    /// Nothing: the end is held.
    Nothing,
    /// The lines of these sines.
    Lines(&'a [Harmonic]),
    /// Something at every frequency, or at many.
    Broad,
}

/// Most turns of a chirp.
const MOST_TURNS: f64 = 1e6;

impl EndInput {
    /// One sine: a sin(2πft + phase).
    pub fn harmonic(amplitude: f64, frequency: f64, phase: f64) -> Self {
        Self::Harmonics(vec![Harmonic { amplitude, frequency, phase }])
    }

    /// Displacement from the mean at time `time` \[s\], in \[m\] (\[N\] at an end under force).
    pub fn displacement(&self, time: f64) -> f64 {
        match self {
            Self::Held => 0.0,
            Self::Chirp { amplitude, duration, .. } => amplitude * self.chirp_angle(time.min(*duration)).0.sin(),
            Self::Step { height, at } => {
                if time < *at {
                    0.0
                } else {
                    *height
                }
            }
            Self::Ramp { height, from, duration } => height * ((time - from) / duration).clamp(0.0, 1.0),
            Self::Harmonics(_) | Self::HalfSine { .. } => self.sines().map(|sine| sine.displacement(time)).sum(),
            Self::Sampled(sampled) => sampled.value(time),
        }
    }

    /// Displacements at each time, shape `samples`; in order of time, a recording is walked through once.
    pub(crate) fn displacements(&self, times: &[f64]) -> Vec<f64> {
        match self {
            Self::Held => vec![0.0; times.len()],
            Self::Sampled(sampled) if times.is_sorted() => sampled.values_at(times),
            Self::Harmonics(_)
            | Self::Chirp { .. }
            | Self::Step { .. }
            | Self::Ramp { .. }
            | Self::HalfSine { .. }
            | Self::Sampled(_) => times.iter().map(|&time| self.displacement(time)).collect(),
        }
    }

    /// What is straight between its jumps at a time: value and rate; zero for what is made of sines.
    pub(crate) fn straight_part(&self, time: f64) -> (f64, f64) {
        match self {
            Self::Step { .. } | Self::Ramp { .. } | Self::Sampled(_) => (self.displacement(time), self.velocity(time)),
            Self::Held | Self::Harmonics(_) | Self::Chirp { .. } | Self::HalfSine { .. } => (0.0, 0.0),
        }
    }

    /// Largest angular frequency \[rad/s\] in [`Self::acceleration`].
    pub(crate) fn highest_angular(&self) -> f64 {
        match self {
            Self::Chirp { from, to, .. } => TAU * from.max(*to),
            Self::Harmonics(_) | Self::HalfSine { .. } => {
                self.sines().fold(0.0, |highest, sine| sine.angular.max(highest))
            }
            Self::Held | Self::Step { .. } | Self::Ramp { .. } | Self::Sampled(_) => 0.0,
        }
    }

    /// Angle \[rad\] and angular frequency \[rad/s\] of a chirp; zero for others.
    pub(super) fn chirp_angle(&self, time: f64) -> (f64, f64) {
        let Self::Chirp { from, to, duration, phase, .. } = self else {
            return (0.0, 0.0);
        };
        let growth = (to - from) / duration;
        (phase + TAU * time * (from + 0.5 * growth * time), TAU * (from + growth * time))
    }

    /// The sines it is made of.
    pub(crate) fn sines(&self) -> impl Iterator<Item = Sine> {
        let (harmonics, bump) = match self {
            Self::Harmonics(harmonics) => (harmonics.as_slice(), None),
            Self::HalfSine { height, from, duration } => {
                let (angular, until) = (PI / duration, from + duration);
                (&[][..], Some(Sine { amplitude: *height, angular, phase: 0.0, since: *from, until }))
            }
            Self::Held | Self::Chirp { .. } | Self::Step { .. } | Self::Ramp { .. } | Self::Sampled(_) => {
                (&[][..], None)
            }
        };
        let whole = |h: &Harmonic| {
            let (amplitude, angular, phase) = (h.amplitude, TAU * h.frequency, h.phase);
            Sine { amplitude, angular, phase, since: 0.0, until: f64::INFINITY }
        };
        harmonics.iter().map(whole).chain(bump)
    }

    /// Whether it can only be followed step by step: a chirp has no elementary solution.
    pub(crate) fn is_chirp(&self) -> bool {
        matches!(self, Self::Chirp { .. })
    }

    /// Of a chirp, the most that its acceleration can add up to: its largest acceleration for all of its duration.
    pub(crate) fn chirp_impulse(&self) -> f64 {
        match self {
            Self::Chirp { amplitude, from, to, duration, .. } => {
                let (highest, growth) = (TAU * from.max(*to), TAU * (to - from).abs() / duration);
                amplitude.abs() * (highest * highest + growth) * duration
            }
            Self::Held
            | Self::Harmonics(_)
            | Self::Step { .. }
            | Self::Ramp { .. }
            | Self::HalfSine { .. }
            | Self::Sampled(_) => 0.0,
        }
    }

    /// How many jumps it has at most.
    pub(crate) fn most_kicks(&self) -> usize {
        match self {
            Self::Held | Self::Harmonics(_) => 0,
            Self::Sampled(sampled) => sampled.count(),
            Self::Chirp { .. } | Self::Step { .. } | Self::Ramp { .. } | Self::HalfSine { .. } => 2,
        }
    }

    /// How far it jumps at t = 0: a step there is seen by the start ([`Self::displacement`]), but for what it does to damping.
    pub(crate) fn step_at_start(&self) -> f64 {
        match self {
            Self::Step { height, at } if *at <= 0.0 => *height,
            Self::Held
            | Self::Harmonics(_)
            | Self::Chirp { .. }
            | Self::Step { .. }
            | Self::Ramp { .. }
            | Self::HalfSine { .. }
            | Self::Sampled(_) => 0.0,
        }
    }

    /// Its jumps after t = 0, in order of time. What happens at t = 0 belongs to the start.
    pub(crate) fn kicks(&self) -> Vec<Kick> {
        let kick = |time, displacement, velocity| Kick { time, displacement, velocity };
        let mut kicks = match self {
            Self::Held | Self::Harmonics(_) => Vec::new(),
            Self::Chirp { amplitude, duration, .. } => {
                let (angle, rate) = self.chirp_angle(*duration);
                vec![kick(*duration, 0.0, -amplitude * rate * angle.cos())]
            }
            Self::Step { height, at } => vec![kick(*at, *height, 0.0)],
            Self::Ramp { height, from, duration } => {
                vec![kick(*from, 0.0, height / duration), kick(from + duration, 0.0, -height / duration)]
            }
            // Up at its begin, and up again where it would go on below zero.
            Self::HalfSine { height, from, duration } => {
                [*from, from + duration].map(|time| kick(time, 0.0, height * PI / duration)).into()
            }
            Self::Sampled(sampled) => sampled.kicks(),
        };
        kicks.retain(|kick| kick.time > 0.0);
        kicks
    }

    /// Those of both ends in order of time, each with the number of its end; of two at once that of end 1 comes first.
    pub(crate) fn kicks_of_both(ends: [&Self; 2]) -> Vec<(usize, Kick)> {
        let [first, second] = ends.map(Self::kicks);
        let mut both = Vec::with_capacity(first.len() + second.len());
        let mut second = second.into_iter().peekable();
        for kick in first {
            while let Some(earlier) = second.next_if(|other| other.time < kick.time) {
                both.push((1, earlier));
            }
            both.push((0, kick));
        }
        both.extend(second.map(|kick| (1, kick)));
        both
    }

    /// How far it can be from its mean, as a bound.
    pub(crate) fn reach(&self) -> f64 {
        match self {
            Self::Held => 0.0,
            Self::Harmonics(harmonics) => harmonics.iter().map(|harmonic| harmonic.amplitude.abs()).sum(),
            Self::Chirp { amplitude, .. } => amplitude.abs(),
            Self::Step { height, .. } | Self::Ramp { height, .. } | Self::HalfSine { height, .. } => height.abs(),
            Self::Sampled(sampled) => sampled.reach(),
        }
    }

    /// Between which displacements it stays \[m, or N at an end under force\].
    ///
    /// ±Σ|a| of sines, ±|a| of a chirp, from the mean to the height of a step, ramp or bump, least and largest sample of a recording
    ///
    /// Source:   the definition of each input.
    /// Valid:    all times; sines of several frequencies need not meet the bound.
    /// Accuracy: rounding of the sum.
    ///
    /// ```
    /// let step = coilsense::EndInput::Step { height: -0.01, at: 0.1 };
    /// assert_eq!(step.bounds(), (-0.01, 0.0));
    /// ```
    pub fn bounds(&self) -> (f64, f64) {
        match self {
            Self::Held => (0.0, 0.0),
            Self::Harmonics(_) | Self::Chirp { .. } => (-self.reach(), self.reach()),
            Self::Step { height, .. } | Self::Ramp { height, .. } | Self::HalfSine { height, .. } => {
                (height.min(0.0), height.max(0.0))
            }
            Self::Sampled(sampled) => sampled.bounds(),
        }
    }

    /// What it holds over frequency: where to look for a resonance.
    pub fn content(&self) -> Content<'_> {
        match self {
            Self::Held => Content::Nothing,
            Self::Harmonics(harmonics) => Content::Lines(harmonics),
            Self::Chirp { .. } | Self::Step { .. } | Self::Ramp { .. } | Self::HalfSine { .. } | Self::Sampled(_) => {
                Content::Broad
            }
        }
    }

    /// The same input, all of it `factor` times as far; the factor must be finite.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        let mut scaled = self.clone();
        match &mut scaled {
            Self::Held => {}
            Self::Harmonics(harmonics) => harmonics.iter_mut().for_each(|harmonic| harmonic.amplitude *= factor),
            Self::Chirp { amplitude, .. } => *amplitude *= factor,
            Self::Step { height, .. } | Self::Ramp { height, .. } | Self::HalfSine { height, .. } => *height *= factor,
            Self::Sampled(sampled) => *sampled = sampled.scaled(factor),
        }
        scaled
    }

    /// Lets through an input whose every value is what it must be.
    pub(super) fn checked(self) -> Result<Self, Error> {
        match &self {
            Self::Held | Self::Sampled(_) => {}
            Self::Harmonics(harmonics) => {
                for harmonic in harmonics {
                    finite("amplitude", harmonic.amplitude, "m")?;
                    above_zero("frequency", harmonic.frequency, "Hz")?;
                    finite("phase", harmonic.phase, "rad")?;
                }
            }
            Self::Chirp { amplitude, from, to, duration, phase } => {
                finite("amplitude", *amplitude, "m")?;
                from_zero(called("from", "first frequency"), *from, "Hz")?;
                from_zero(called("to", "last frequency"), *to, "Hz")?;
                // Followed step by step: more turns than this would take minutes.
                let turns = 0.5 * (from + to) * duration;
                let most = format!("at most {MOST_TURNS:e}");
                check(turns <= MOST_TURNS, called("to", "turns of the chirp"), turns, "", most)?;
                above_zero("duration", *duration, "s")?;
                finite("phase", *phase, "rad")?;
            }
            Self::Step { height, at } => {
                finite("height", *height, "m")?;
                from_zero(called("at", "time of the step"), *at, "s")?;
            }
            Self::Ramp { height, from, duration } | Self::HalfSine { height, from, duration } => {
                finite("height", *height, "m")?;
                from_zero(called("from", "begin"), *from, "s")?;
                above_zero("duration", *duration, "s")?;
            }
        }
        Ok(self)
    }
}
