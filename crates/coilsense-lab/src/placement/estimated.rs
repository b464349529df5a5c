//! Loops on what an estimator makes of F_i, over the tolerances of the spring.
//!
//! Next door: the forces themselves (`judged`), the estimators' settings (`coilsense::mitigation`).

use coilsense::control::{Environment, Estimator, SampledLoop};
use coilsense::mitigation::{KalmanNoise, SampledSpring, ToleranceBox, modal_kalman, surge_notches};
use coilsense::{Channel, Error, Spring};
use coilsense_rt::Cascade;

use super::allowed::Allowed;
use super::loops::{Under, UnitLoops};
use crate::spec::DampingCase;

/// A loop on an estimate, judged over all dampings, on all springs that are allowed, and over k and m, each ±10 % alone, together and opposed.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimated {
    /// What is fed back.
    pub name: &'static str,
    /// The largest crossover at which it is stable on every spring of the box \[Hz\], of the loop with the nominal spring without mass.
    pub stable_crossover: f64,
    /// The same with a sensitivity of at most 2; zero without one.
    pub robust_crossover: f64,
    /// From which crossover on \[Hz\]; zero where it is so in the slowest loop, too.
    pub robust_from: f64,
    /// What makes it of F_i and the ends' positions.
    pub estimator: Estimator,
}

/// Tolerances of k and m, either way \[1\].
pub const TOLERANCE: f64 = 0.1;
/// Quality of the notches, and what the Kalman filter expects: noise of 0.2 % of F_nom, and the rest as multiples of it.
const QUALITY: f64 = 2.0;
const NOISE: f64 = 0.002;
const RINGING: f64 = 8.3;
const DRIFT: f64 = 2.1;

/// Notches and Kalman filter in the loop; none without samples, where end 2 moves, or where three modes lie above half the rate.
pub(super) fn all(
    unit: &UnitLoops<'_>,
    dampings: &[DampingCase],
    gain: f64,
    allowed: &Allowed,
) -> Result<Vec<Estimated>, Error> {
    let (Some(step), Environment::Held) = (unit.control.sample_time, unit.control.environment) else {
        return Ok(Vec::new());
    };
    let (spring, damping) = (&unit.spec.spring.spring, &dampings[dampings.len() / 2]);
    let sampled = SampledSpring::new(spring, damping.mount.damping(), 1.0 / step)?;
    let noise = NOISE * spring.nominal_force();
    let noise = KalmanNoise { force: noise, shock: 0.0, ringing: RINGING * noise, drift: DRIFT * noise };
    let notches = surge_notches(&sampled, 3, QUALITY).ok().and_then(|sections| sections.try_into().ok());
    let kalman = modal_kalman::<3>(&sampled, &noise).ok();
    let each = [
        ("F_i behind notches at f1, 2 f1 and 3 f1", notches.map(|sections| Estimator::Cascade(Cascade { sections }))),
        ("F_o estimated by a Kalman filter of three modes", kalman.map(|filter| Estimator::Kalman(Box::new(filter)))),
    ];
    let there = each.into_iter().filter_map(|(name, estimator)| Some((name, estimator?)));
    let corners = ToleranceBox::new(TOLERANCE, TOLERANCE)?.corners();
    let corners = corners.into_iter().map(|corner| ToleranceBox::changed(spring, corner));
    let mut springs = corners.collect::<Result<Vec<Spring>, Error>>()?;
    springs.extend(allowed.each.iter().map(|varied| varied.spring.clone()));
    let judge = Judge { unit, dampings, springs, gain, step };
    there.map(|(name, estimator)| judge.of(name, &estimator)).collect()
}

/// What is the same of every estimator.
struct Judge<'a> {
    unit: &'a UnitLoops<'a>,
    dampings: &'a [DampingCase],
    springs: Vec<Spring>,
    gain: f64,
    step: f64,
}

impl Judge<'_> {
    fn of(&self, name: &'static str, estimator: &Estimator) -> Result<Estimated, Error> {
        let (mut stable, mut robust, mut from) = (f64::INFINITY, f64::INFINITY, 0.0_f64);
        for damping in self.dampings {
            let cases = self
                .springs
                .iter()
                .flat_map(|spring| self.unit.delays(Channel::InputForce).iter().map(move |&delay| (spring, delay)));
            for (spring, delay) in cases {
                let under = Under { place: 0, spring, delay };
                let changed = self.unit.on(under, damping, Channel::InputForce, self.gain)?;
                let margins = SampledLoop::new(&changed, self.step)?.behind(estimator.clone())?.margins()?;
                stable = stable.min(margins.gain_limit);
                robust = robust.min(margins.robust_gain);
                from = from.max(margins.robust_from);
            }
        }
        let nominal = self.unit.force_loop(&self.dampings[0], Channel::InputForce, self.gain)?;
        let crossover = |factor: f64| UnitLoops::crossover(&nominal, factor);
        if from >= robust {
            (from, robust) = (0.0, 0.0);
        }
        Ok(Estimated {
            name,
            stable_crossover: crossover(stable)?,
            robust_crossover: crossover(robust)?,
            robust_from: crossover(from)?,
            estimator: estimator.clone(),
        })
    }
}
