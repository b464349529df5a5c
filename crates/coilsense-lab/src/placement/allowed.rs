//! Springs that a spec allows: those within its tolerances, with surge frequencies as its model leaves them open.
//!
//! Next door: the tolerances (`spec::Tolerances`), the loops that are judged on all of them (`judged`, `calm`).

use std::f64::consts::TAU;

use coilsense::mitigation::ToleranceBox;
use coilsense::{Error, Spring};

use super::PlacementError;
use crate::spec::SpringSpec;

/// A spring that is allowed.
#[derive(Debug, Clone, PartialEq)]
pub struct Varied {
    /// It.
    pub spring: Spring,
    /// By which share its k is off \[1\].
    pub stiffness: f64,
    /// By which share its surge frequencies are off \[1\].
    pub frequency: f64,
}

/// Springs all around what is allowed, after the one of the spec.
#[derive(Debug, Clone, PartialEq)]
pub struct Allowed {
    /// The spec's own first.
    pub each: Vec<Varied>,
    /// How far k may be off, either way \[1\].
    pub stiffness: f64,
    /// How far surge frequencies may be off, either way \[1\].
    pub frequency: f64,
}

/// Springs around what is allowed.
const AROUND: u32 = 16;
/// Springs this near each other count as one \[1\].
const SAME: f64 = 1e-9;

impl Allowed {
    /// Those whose independent tolerances, each over its limit, add up to 1 as their squares do: an ellipse of k and surge frequency.
    ///
    /// Δk/k = a cos θ, f/f_spec = (1 + Δk/k)^e exp(b sin θ), with a, e and b such that to first order the ellipse is Σ v vᵀ over what each tolerance moves
    ///
    /// Source:   independent limits added up as their squares do, as [`crate::spec::Tolerances::of_stiffness`] has it. At given surge
    ///           frequencies every force of a velocity drive is in proportion to k, so that the rim has the least limit.
    /// Valid:    tolerances of k below 100 %; beside those of k alone to first order, some 20 %.
    /// Accuracy: limits of stability 1 % above the least of many springs inside (test).
    ///
    /// # Errors
    /// [`Error::Value`] where a changed spring is none.
    pub fn of(spec: &SpringSpec) -> Result<Self, Error> {
        let model = spec.open_frequency();
        let mut moves = spec.tolerances.moves();
        moves.push([0.0, model]);
        let sum =
            |one: usize, other: usize| moves.iter().map(|shares: &[f64; 2]| shares[one] * shares[other]).sum::<f64>();
        let (stiffness, frequency) = (sum(0, 0).sqrt(), sum(1, 1).sqrt());
        // f ∝ k^e, and the rest of what moves f beside it.
        let by_stiffness = if stiffness > 0.0 { sum(0, 1) / sum(0, 0) } else { 0.0 };
        let alone = (frequency * frequency - (by_stiffness * stiffness).powi(2)).max(0.0).sqrt();
        let mut each = vec![Varied { spring: spec.spring.clone(), stiffness: 0.0, frequency: 0.0 }];
        for step in 0..AROUND {
            let (sine, cosine) = (TAU * f64::from(step) / f64::from(AROUND)).sin_cos();
            let (k, f) =
                (stiffness * cosine, (1.0 + stiffness * cosine).powf(by_stiffness) * (alone * sine).exp() - 1.0);
            if each.iter().any(|other| (other.stiffness - k).abs() + (other.frequency - f).abs() < SAME) {
                continue;
            }
            let mass = (1.0 + k) / (1.0 + f).powi(2) - 1.0;
            each.push(Varied { spring: ToleranceBox::changed(&spec.spring, [k, mass])?, stiffness: k, frequency: f });
        }
        Ok(Self { each, stiffness, frequency })
    }

    /// Refuses samples that are too slow for the fastest of them.
    ///
    /// # Errors
    /// [`PlacementError::Spec`].
    pub(super) fn check_samples(&self, file: &str, sample_time: Option<f64>) -> Result<(), PlacementError> {
        let fastest = self.each.iter().map(|varied| varied.spring.surge_frequency()).fold(0.0, f64::max);
        match sample_time.filter(|step| step * fastest >= 0.5) {
            None => Ok(()),
            Some(step) => Err(PlacementError::Spec(format!(
                "{file}: [control] sample_time = {step} s: must be below {:.4e} s, half a period of a first surge frequency that within the spec's \
                 tolerances is up to {fastest:.2} Hz",
                0.5 / fastest
            ))),
        }
    }

    /// The spec's own spring alone.
    pub fn nominal(&self) -> &[Varied] {
        &self.each[..1]
    }
}

#[cfg(test)]
mod tests {
    use coilsense::control::{Controller, Drive, Environment, ForceLoop, Plant, SampledLoop};
    use coilsense::{Channel, Damping, Spring};

    use super::Allowed;
    use crate::placement::Placement;
    use crate::spec::{Spec, template};

    /// The loop of one force with a proportional gain of 1: the gain up to which it is stable.
    fn limit(spring: &Spring, ratio: f64, feedback: Channel, gain: f64, late: f64) -> f64 {
        let plant = Plant::new(spring, Damping::Modal(ratio), Drive::IDEAL_VELOCITY, Environment::Held).unwrap();
        let looped = ForceLoop::new(plant, Controller::proportional(gain).unwrap(), feedback, late).unwrap();
        SampledLoop::new(&looped, 8e-4).unwrap().margins().unwrap().gain_limit
    }

    #[test]
    fn no_spring_within_the_tolerances_has_a_lower_limit_than_is_told() {
        let control = "[control]\ndrive = \"velocity\"\nsample_time = \"0.8 ms\"\ndelay = \"0.8 ms\"\n";
        let text = template(Some("pressed")).unwrap().replace("# [control]\n", control);
        let text = text.replace("# damping_ratio = 0.005", "damping_ratio = 0.005");
        // Without sensors, so that each force is read at once.
        let (head, rest) = text.split_once("[[sensor]]").unwrap();
        let text = format!("{head}{}", &rest[rest.find("[goal]").unwrap()..]);
        let spec = Spec::parse("pressed", &text, &|_| unreachable!()).unwrap();
        let own = spec.spring.spring.clone();
        let placement = Placement::of(spec).unwrap();
        let ratio = placement.dampings[0].ratio.unwrap();
        // Tolerances of d, D, n and G in every direction, to the power laws themselves, and the model's frequency with them: points of a
        // sphere of five dimensions, on it and inside.
        let limits = [0.01, 0.01, 0.005, 0.02];
        let (low, high) = placement.spec.spring.first_frequency_band();
        let model = (low / own.chain_frequency()).ln().abs().max((high / own.chain_frequency()).ln().abs());
        let mut state = 7_u64;
        let mut unit = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
        };
        let mut drawn = Vec::new();
        while drawn.len() < 400 {
            let point = [(); 5].map(|()| unit());
            let size = point.iter().map(|x| x * x).sum::<f64>().sqrt();
            if size > 1.0 || size == 0.0 {
                continue;
            }
            // Half of them on the sphere.
            let onto = if drawn.len() % 2 == 0 { 1.0 / size } else { 1.0 };
            let off = |index: usize| 1.0 + limits[index] * onto * point[index];
            let stiffness = off(0).powi(4) * off(3) / (off(1).powi(3) * off(2));
            let mass = off(0).powi(2) * off(1) * off(2) / (2.0 * model * onto * point[4]).exp();
            let mut parameters = own.parameters().clone();
            parameters.stiffness *= stiffness;
            parameters.mass *= mass;
            let spring = Spring::new(parameters).unwrap().with_masses_per_winding(own.masses_per_winding()).unwrap();
            drawn.push((spring, stiffness));
        }
        for candidate in &placement.candidates {
            let told = candidate.judged[0].limit;
            // Deflection is read by the k that is believed.
            let reads = |stiffness: f64| match candidate.channel {
                Channel::DeflectionForce | Channel::InductanceForce => 1.0 / stiffness,
                _ => 1.0,
            };
            let gain = |stiffness: f64| reads(stiffness) / own.stiffness();
            let found = drawn.iter().map(|(spring, stiffness)| {
                limit(spring, ratio, candidate.channel, gain(*stiffness), 8e-4) / own.stiffness()
            });
            let least = found.fold(f64::INFINITY, f64::min);
            let share = told / least;
            // Power laws beside straight lines 0.3 %; what is drawn comes to within some per cent of the rim.
            assert!((0.9..1.01).contains(&share), "{:?}: {told} told, {least} found", candidate.channel);
        }
        let nominal = &placement.nominal[0].judged[0];
        assert!(placement.candidates[0].judged[0].limit < 0.97 * nominal.limit, "the tolerances matter");
    }

    #[test]
    fn springs_lie_all_around_what_is_allowed() {
        let spec = |tolerances: &str| {
            let text = template(Some("S_T")).unwrap().replace("[spring]", &format!("[spring]\n{tolerances}"));
            Spec::parse("S_T", &text, &|_| unreachable!()).unwrap().spring
        };
        // k alone moves the frequency by half: a line, but for what the model leaves open.
        let both = Allowed::of(&spec("stiffness_tolerance = \"10 %\"\nmass_tolerance = \"6 %\"")).unwrap();
        assert!((both.stiffness - 0.1).abs() < 1e-12 && both.frequency > 0.05_f64.hypot(0.03));
        let edge = |of: fn(&super::Varied) -> f64| {
            both.each
                .iter()
                .map(of)
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        };
        let [softest, stiffest] = edge(|varied| varied.stiffness);
        assert!((softest + 0.1).abs() < 1e-9 && (stiffest - 0.1).abs() < 1e-9, "{softest} {stiffest}");
        let [slowest, fastest] = edge(|varied| varied.frequency);
        assert!((fastest / both.frequency - 1.0).abs() < 0.05 && (slowest / both.frequency + 1.0).abs() < 0.05);
        for varied in &both.each {
            let own = &both.each[0].spring;
            let frequency = varied.spring.surge_frequency() / own.surge_frequency() - 1.0;
            assert!((frequency - varied.frequency).abs() < 1e-12);
            assert!((varied.spring.stiffness() / own.stiffness() - 1.0 - varied.stiffness).abs() < 1e-12);
            assert_eq!(varied.spring.masses_per_winding(), own.masses_per_winding());
        }
        // Without a tolerance k stays what it is, and each frequency is there once.
        let silent = Allowed::of(&spec("")).unwrap();
        assert!(silent.each.iter().all(|varied| varied.stiffness == 0.0) && silent.stiffness == 0.0);
        assert!(silent.frequency > 1e-3 && silent.each.len() == 9, "{}", silent.each.len());
    }
}
