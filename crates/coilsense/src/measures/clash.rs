//! Windings that touch: where the linear model ends.
//!
//! Next door: forces that are off (`deviation`).

use crate::error::Error;
use crate::motion::{Motion, Windings};
use crate::spring::Spring;

/// How near neighbouring windings come over a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clash {
    /// Smallest distance between neighbouring windings \[m\], centre to centre; infinite for a single winding. Of a coil of sections, whose windings
    /// touch at distances of their own, the contact pitch and the smallest clearance.
    pub smallest_pitch: f64,
    /// When \[s\].
    pub time: f64,
    /// The lower-numbered of the two windings, 1…N−1.
    pub winding: usize,
    /// At this pitch windings touch \[m\]: 2ρ, or what [`Clash::seen`] was told.
    pub contact_pitch: f64,
    /// First time at which they touch \[s\]; `None` where they stay clear.
    pub first_contact: Option<f64>,
}

impl Clash {
    /// Of a motion, watched at `times` \[s\] (increasing, shape `samples`); the first contact is then refined between samples.
    ///
    /// p_i = x_{i+1} − x_i, contact at p_i = 2ρ; with n masses per winding p_i = x_{i+n} − x_i: a point and that one turn further
    ///
    /// Source:   geometry; the paper has no check.
    /// Valid:    neighbouring windings of the model; end turns and seats are not in it.
    /// Accuracy: first contact to 1e-12 s within the sample that shows it; a dip between samples can be missed.
    ///
    /// # Errors
    /// [`Error::Count`] for no times; [`Error::Value`] for a time that is not finite, below zero, or not after its predecessor.
    pub fn of(motion: &Motion, times: &[f64]) -> Result<Self, Error> {
        crate::error::at_least_one("times", times.len())?;
        let times = crate::signals::increasing(times)?;
        Self::seen(motion, times, &motion.windings(times)?, motion.spring().wire_diameter())
    }

    /// The same where the positions at `times` are at hand (`windings` of [`Motion::windings`]) and contact is at another pitch than 2ρ:
    /// a spring whose length counts dead end windings has p = l/N larger than the pitch of its active ones, and touches at
    /// p = l_s/N with l_s its solid length.
    ///
    /// - `contact_pitch`: \[m\], above zero
    ///
    /// # Errors
    /// [`Error::Count`] for no times, or more than there are samples of the positions (later ones are left out); [`Error::Value`] for a pitch that is not above zero.
    pub fn seen(motion: &Motion, times: &[f64], windings: &Windings, contact_pitch: f64) -> Result<Self, Error> {
        crate::error::at_least_one("times", times.len())?;
        crate::error::count("times", times.len(), windings.samples().min(times.len()))?;
        crate::error::above_zero("contact_pitch", contact_pitch, "m")?;
        let clash = Self::met(motion.spring(), times, windings, contact_pitch, None)?;
        let neighbours = Neighbours::of(motion.spring(), contact_pitch);
        let touches = |sample: &usize| neighbours.smallest_pitch(windings.row(*sample)).0 < contact_pitch;
        let first = if clash.clearance() < 0.0 { (0..times.len()).find(touches) } else { None };
        let first_contact = match first {
            None => None,
            Some(0) => Some(times[0]),
            Some(sample) => Some(neighbours.contact_between(motion, times[sample - 1], times[sample])?),
        };
        Ok(Self { first_contact, ..clash })
    }

    /// How near they come where contact is part of the motion ([`crate::contact::Touching`]): `windings` at `times` (shape `samples`), and when anything
    /// first met \[s\].
    ///
    /// # Errors
    /// As [`Clash::seen`].
    pub fn met(
        spring: &Spring,
        times: &[f64],
        windings: &Windings,
        contact_pitch: f64,
        first_contact: Option<f64>,
    ) -> Result<Self, Error> {
        crate::error::at_least_one("times", times.len())?;
        crate::error::count("times", times.len(), windings.samples().min(times.len()))?;
        crate::error::above_zero("contact_pitch", contact_pitch, "m")?;
        let mut clash = Self { smallest_pitch: f64::INFINITY, time: 0.0, winding: 1, contact_pitch, first_contact };
        let neighbours = Neighbours::of(spring, contact_pitch);
        for (sample, &time) in times.iter().enumerate() {
            let (pitch, winding) = neighbours.smallest_pitch(windings.row(sample));
            if pitch < clash.smallest_pitch {
                (clash.smallest_pitch, clash.winding, clash.time) = (pitch, winding, time);
            }
        }
        Ok(clash)
    }

    /// Whether a bound on all modes rules out that neighbouring windings come as near as `contact_pitch` for 0 ≤ t ≤ `until`: some
    /// microseconds instead of a motion's positions. `false` says nothing; ask [`Clash::of`] then.
    ///
    /// - `until`: \[s\], not below zero; `contact_pitch`: \[m\], as in [`Clash::seen`]
    ///
    /// Source:   [`Motion::least_pitch`].
    /// Valid:    as [`Motion::least_pitch`].
    /// Accuracy: never `true` of a motion whose windings touch; `true` of S_T in the paper's five conditions (test).
    pub fn excluded(motion: &Motion, until: f64, contact_pitch: f64) -> bool {
        motion.least_pitch(until) > contact_pitch
    }

    /// Whether windings touch.
    pub fn happens(&self) -> bool {
        self.first_contact.is_some()
    }

    /// Smallest distance between the wires' surfaces \[m\], below zero where they would overlap.
    pub fn clearance(&self) -> f64 {
        self.smallest_pitch - self.contact_pitch
    }
}

/// Masses one turn apart, and where they touch.
struct Neighbours {
    /// How many masses a turn has.
    apart: usize,
    contact_pitch: f64,
    /// Of a coil of sections, how much further apart each pair is than the contact pitch when it touches \[m\]; none of an even coil.
    beyond: Vec<f64>,
}

impl Neighbours {
    fn of(spring: &Spring, contact_pitch: f64) -> Self {
        let apart = spring.masses_per_winding();
        let beyond = spring.sections().map_or_else(Vec::new, |sections| {
            let windings = sections.lumps(apart).windings;
            let inner = &windings[1..windings.len() - 1];
            let touching = |(first, second): (&f64, &f64)| {
                sections.place_at(*second, 0.0) - sections.place_at(*first, 0.0) - sections.gap_between(*first, *second)
            };
            inner.iter().zip(&inner[apart.min(inner.len())..]).map(|pair| touching(pair) - contact_pitch).collect()
        });
        Self { apart, contact_pitch, beyond }
    }

    /// The smallest distance between masses one turn apart, and the number of the winding of the first.
    fn smallest_pitch(&self, row: &[f64]) -> (f64, usize) {
        let apart = self.apart;
        let beyond = |mass: usize| self.beyond.get(mass).copied().unwrap_or(0.0);
        let each = row.iter().zip(&row[apart.min(row.len())..]).zip(0..);
        each.map(|((first, next), mass)| (next - first - beyond(mass), mass)).fold(
            (f64::INFINITY, 1),
            |least, (pitch, mass)| {
                if pitch < least.0 { (pitch, mass / apart + 1) } else { least }
            },
        )
    }

    /// Bisects the moment of contact between a time without and a time with it.
    fn contact_between(&self, motion: &Motion, clear: f64, touching: f64) -> Result<f64, Error> {
        let (mut clear, mut touching) = (clear, touching);
        while touching - clear > 1e-12 {
            let middle = 0.5 * (clear + touching);
            if middle <= clear || middle >= touching {
                break;
            }
            let windings: Windings = motion.windings(&[middle])?;
            if self.smallest_pitch(windings.row(0)).0 < self.contact_pitch {
                touching = middle;
            } else {
                clear = middle;
            }
        }
        Ok(touching)
    }
}
