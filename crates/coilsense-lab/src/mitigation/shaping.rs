//! Shaping the command instead: where a motion of u1 makes the spring ring, what each shaper leaves of it over the tolerance box, and what it costs.
//!
//! Next door: the shapers (`coilsense::mitigation`), what is done about ringing once it is there (`candidates`), the answer (`answer`).

use coilsense::Error;
use coilsense::excitation::{End, EndInput};
use coilsense::mitigation::{SampledSpring, ToleranceBox, surge_mean, zero_vibration, zero_vibration_derivative};
use coilsense::modes::ChainModes;

use super::answer::LeftOut;
use super::export::Settings;
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
            ("the command as it is", None, &mut |x| x),
            ("ZV: two impulses", Some(Box::new(zv)), &mut |x| zv.step(&mut a, x)),
            ("ZVD: three impulses", Some(Box::new(zvd)), &mut |x| zvd.step(&mut b, x)),
            ("mean over 2τ: a ramp in place of a step", Some(Box::new(ramp)), &mut |x| ramp.step(&mut c, x)),
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
            let label = format!("k {:+} %, m {:+} %, {label}", 100.0 * corner[0], 100.0 * corner[1]);
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

/// The last sample at which something arrives.
fn last(taps: &[f64]) -> usize {
    taps.iter().rposition(|tap| *tap != 0.0).unwrap_or(0)
}

/// What a shaped command leaves of a mode's ringing, of what the plain one leaves when it ends \[1\].
///
/// V = e^(−ζω t_N) |Σ_j h_j e^((ζω + iω√(1−ζ²)) t_j)|, t_j = j/f_s, t_N the last with a tap
///
/// - `taps`: h_j \[1\], what the shaper makes of a unit impulse; those of a shaper add up to 1
/// - `rate`: f_s \[Hz\], `omega`: ω \[rad/s\], `ratio`: ζ, below 1
///
/// Source:   `[Singer1990]`; their V with the shaper's impulses as they are sampled.
/// Valid:    linear vibration, any command; what the controller's hold does to it is the same for both.
/// Accuracy: 1e-12 against cos(ωΔ/2) of two halves Δ apart without damping.
pub fn residual_vibration(taps: &[f64], rate: f64, omega: f64, ratio: f64) -> f64 {
    let (decay, swing) = (ratio * omega / rate, omega * (1.0 - ratio * ratio).sqrt() / rate);
    let end = last(taps) as f64;
    let sums = taps.iter().enumerate().fold((0.0, 0.0), |(re, im), (index, tap)| {
        let (sine, cosine) = (swing * index as f64).sin_cos();
        // Counted from the end, so that no power overflows.
        let size = tap * (decay * (index as f64 - end)).exp();
        (re + size * cosine, im + size * sine)
    });
    f64::hypot(sums.0, sums.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_halves_leave_the_cosine_of_half_the_angle_between_them() {
        let mut taps = [0.0; 101];
        (taps[0], taps[100]) = (0.5, 0.5);
        for omega in [0.3, 3.0, 31.4, 94.2] {
            let left = residual_vibration(&taps, 1000.0, omega, 0.0);
            // Rounding of an angle up to 10 and of two terms.
            assert!((left - (0.05 * omega).cos().abs()).abs() < 1e-12, "{left}");
        }
        assert!((residual_vibration(&[1.0], 1000.0, 50.0, 0.1) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_damped_mode_rests_after_the_impulses_made_for_it() {
        // κ = e^(−ζπ/√(1−ζ²)), half a damped period of 100 samples.
        let (rate, ratio) = (1000.0, 0.05_f64);
        let omega = std::f64::consts::PI * rate / (100.0 * (1.0 - ratio * ratio).sqrt());
        let decay = (-ratio * std::f64::consts::PI / (1.0 - ratio * ratio).sqrt()).exp();
        let mut taps = [0.0; 101];
        (taps[0], taps[100]) = (1.0 / (1.0 + decay), decay / (1.0 + decay));
        assert!(residual_vibration(&taps, rate, omega, ratio) < 1e-14);
        // One that rings 10 % higher is left with sin(π/20), and a little for the damping.
        assert!((residual_vibration(&taps, rate, 1.1 * omega, ratio) - 0.156).abs() < 0.02);
    }
}
