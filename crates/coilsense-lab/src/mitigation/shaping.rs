//! Shaping the command instead: where a motion of u1 makes the spring ring, what each shaper leaves of it over the tolerance box, and what it costs.
//!
//! Next door: the shapers (`coilsense::mitigation`), what is done about ringing once it is there (`candidates`), the answer (`ranking`).

use coilsense::Error;
use coilsense::excitation::{End, EndInput};
use coilsense::mitigation::{SampledSpring, ToleranceBox, surge_mean, zero_vibration, zero_vibration_derivative};
use coilsense::modes::ChainModes;

use super::candidate::LeftOut;
use super::export::Settings;
use super::residual::{last, residual_vibration};
use super::sources::corner_label;
use super::start::RING;
use super::study::Study;

/// Modes above the first that are looked at.
const MODES: usize = 5;

/// A shaper of the command of u1, and what it leaves.
pub struct Shaped {
    /// In words.
    pub name: &'static str,
    /// Share of the first mode's ringing that is left on the nominal spring under the nominal damping \[1\].
    pub first: f64,
    /// The most that is left of it on a spring of the box.
    pub first_worst: f64,
    /// On which spring that is.
    pub worst_case: String,
    /// The most that is left of a mode from the second to the fifth on a spring of the box \[1\]; zero where none of them is sampled.
    pub higher_worst: f64,
    /// How late the shaped command is on the mean \[s\].
    pub delay: f64,
    /// How long after the command the shaped one has arrived \[s\].
    pub length: f64,
    settings: Option<Box<dyn Settings>>,
}

impl Shaped {
    /// What a controller takes of it; nothing for the command as it is.
    pub fn settings(&self) -> Option<&dyn Settings> {
        self.settings.as_deref()
    }

    /// The most that is left of any mode up to the fifth \[1\].
    pub fn most(&self) -> f64 {
        self.first_worst.max(self.higher_worst)
    }
}

/// In words, what a controller takes of it, and its step.
type Made<'a> = (&'static str, Option<Box<dyn Settings>>, &'a mut dyn FnMut(f64) -> f64);

/// What shaping the command would do.
pub struct Shaping {
    /// Names of the conditions in which u1 moves by a command.
    pub conditions: Vec<String>,
    /// The command as it is, then every shaper.
    pub shapers: Vec<Shaped>,
    /// Which shapers cannot be at this rate.
    pub left_out: Vec<LeftOut>,
}

impl Shaping {
    /// For a study; nothing where no condition moves u1 by a command, as on a log.
    ///
    /// # Errors
    /// Those of the science for a spring of the box.
    pub(super) fn of(study: &Study, sampled: &SampledSpring) -> Result<Option<Self>, Error> {
        let moved = study.conditions.iter().filter(|(_, excitation, _)| *excitation.input(End::One) != EndInput::Held);
        let conditions: Vec<String> = moved.map(|(name, ..)| name.clone()).collect();
        if conditions.is_empty() {
            return Ok(None);
        }
        let (zv, zvd, ramp) = (zero_vibration(sampled), zero_vibration_derivative(sampled), surge_mean(sampled));
        let (mut a, mut b, mut c) = (zv.settled::<RING>(0.0), zvd.settled::<RING>(0.0), ramp.settled::<RING>(0.0));
        let shapers: [Made<'_>; 4] = [
            ("the command, unshaped", None, &mut |x| x),
            ("ZV, two impulses", Some(Box::new(zv)), &mut |x| zv.step(&mut a, x)),
            ("ZVD, three impulses", Some(Box::new(zvd)), &mut |x| zvd.step(&mut b, x)),
            ("mean over 2τ, a ramp in place of a step", Some(Box::new(ramp)), &mut |x| ramp.step(&mut c, x)),
        ];
        let springs = springs(study)?;
        let mut found = Self { conditions, shapers: Vec::new(), left_out: Vec::new() };
        for (name, settings, step) in shapers {
            let ring = settings.as_ref().and_then(|settings| settings.ring()).unwrap_or(1);
            if ring > RING {
                let reason = format!("its ring must be at most {RING} samples");
                found.left_out.push(LeftOut { name: name.to_owned(), reason });
                continue;
            }
            let taps: Vec<f64> = (0..=ring).map(|index| step(if index == 0 { 1.0 } else { 0.0 })).collect();
            found.shapers.push(shaped(name, settings, &taps, study, &springs));
        }
        Ok(Some(found))
    }

    /// The shaper that leaves least of the modes up to the fifth.
    pub fn best(&self) -> Option<&Shaped> {
        let those = self.shapers.iter().filter(|shaped| shaped.settings.is_some());
        those.min_by(|a, b| a.most().total_cmp(&b.most()))
    }
}

/// A spring of the box under a damping: in words, and ω \[rad/s\] and ζ of its modes that are sampled.
struct Ringing {
    label: String,
    modes: Vec<(f64, f64)>,
}

/// Every spring of the box under every damping; the first is the nominal one under the nominal damping.
fn springs(study: &Study) -> Result<Vec<Ringing>, Error> {
    let highest = std::f64::consts::PI * study.rate;
    let mut all = Vec::new();
    for corner in study.tolerances.corners() {
        let spring = ToleranceBox::changed(&study.spring, corner)?;
        let modes = ChainModes::mounted(&spring, study.far_end);
        for (label, damping) in &study.dampings {
            let ratios = damping.ratios(modes.frequencies())?;
            let each = modes.frequencies().iter().copied().zip(ratios);
            let label = format!("{}, {label}", corner_label(corner));
            let rings = |(omega, ratio): &(f64, f64)| *omega < highest && *ratio < 1.0;
            all.push(Ringing { label, modes: each.take(MODES).filter(rings).collect() });
        }
    }
    all.swap(0, study.nominal_damping.min(study.dampings.len() - 1));
    Ok(all)
}

fn shaped(
    name: &'static str,
    settings: Option<Box<dyn Settings>>,
    taps: &[f64],
    study: &Study,
    springs: &[Ringing],
) -> Shaped {
    let left = |(omega, ratio): &(f64, f64)| residual_vibration(taps, study.rate, *omega, *ratio);
    let first = |ringing: &Ringing| ringing.modes.first().map_or(0.0, left);
    let worst = springs.iter().max_by(|a, b| first(a).total_cmp(&first(b)));
    let higher = springs.iter().flat_map(|ringing| ringing.modes.iter().skip(1)).map(left).fold(0.0, f64::max);
    let delay: f64 = taps.iter().enumerate().map(|(at, tap)| tap * at as f64).sum();
    Shaped {
        name,
        first: springs.first().map_or(0.0, first),
        first_worst: worst.map_or(0.0, first),
        worst_case: worst.map_or(String::new(), |worst| worst.label.clone()),
        higher_worst: higher,
        delay: delay / study.rate,
        length: last(taps) as f64 / study.rate,
        settings,
    }
}
