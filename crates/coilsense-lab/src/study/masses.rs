//! How many masses stand for a winding: doubled until what is printed no longer hangs on them.
//!
//! Next door: one simulation (`simulation`), how far any chain is a coil (`coilsense::Spring::first_frequency_band`).

use coilsense::signals::sampled_window;
use coilsense::{Channel, Damping, Deviation, Error, FarEnd, Motion, Mount, Spring};
use rayon::prelude::*;

use crate::spec::{ConditionSpec, Model, MountSpec, SpringSpec};

/// How many masses the chain has for a winding, and what says that they are enough.
#[derive(Debug, Clone, PartialEq)]
pub struct Masses {
    /// Masses for a winding.
    pub per_winding: usize,
    /// Whether the spec asks for so many.
    pub is_given: bool,
    /// By how much the rms of an end force still moves when they are doubled, at most, as a share of it; `None` where that was not tried.
    pub change: Option<f64>,
    /// Conditions that jump: the rms of the end forces has no limit there, and did not count.
    pub without_limit: Vec<String>,
}

/// Most by which an rms may move when the masses are doubled.
pub const ENOUGH: f64 = 0.005;
/// Most masses for a winding that are tried.
const MOST: usize = 32;
/// Most masses in all: positions of more take seconds.
const MOST_IN_ALL: usize = 2000;
/// Most positions of masses over all samples of all cases: what a run of a few seconds takes.
const MOST_POSITIONS: f64 = 1e8;
/// An rms below this share of F_nom is not looked at.
const LEAST: f64 = 1e-5;

/// The spring of a spec on its mount under its conditions, with enough masses.
///
/// # Errors
/// Those of [`Motion::mounted`].
pub fn enough_masses(spring: &SpringSpec, mount: &MountSpec, conditions: &[ConditionSpec]) -> Result<Masses, Error> {
    let jumps = |condition: &&ConditionSpec| condition.kind == "step";
    let without_limit: Vec<String> = conditions.iter().filter(jumps).map(|condition| condition.name.clone()).collect();
    if spring.model == Model::Helix {
        // No chain moves; so many places of the wire are followed.
        let per_winding = spring.spring.masses_per_winding();
        return Ok(Masses { per_winding, is_given: false, change: None, without_limit });
    }
    if let Some(per_winding) = spring.masses_per_winding {
        return Ok(Masses { per_winding, is_given: true, change: None, without_limit });
    }
    let judged: Vec<&ConditionSpec> = conditions.iter().filter(|condition| !jumps(condition)).collect();
    let rms_of = |masses| rms(spring, mount, &judged, masses);
    let least = spring.spring.masses_per_winding();
    let mut masses = Masses { per_winding: least, is_given: false, change: None, without_limit };
    if judged.is_empty() || 2 * least * spring.spring.whole_windings() > MOST_IN_ALL {
        return Ok(masses);
    }
    let samples: f64 = judged.iter().map(|condition| condition.duration * condition.sample_rate).sum();
    let most = (MOST_POSITIONS / (samples * mount.cases.len() as f64)).min(MOST_IN_ALL as f64) as usize;
    let mut coarse = rms_of(least)?;
    loop {
        let fine = rms_of(2 * masses.per_winding)?;
        let change = largest_change(&coarse, &fine, LEAST * spring.spring.nominal_force());
        masses.change = Some(change);
        let twice = 2 * masses.per_winding;
        let last = twice > MOST || twice * spring.spring.whole_windings() > most;
        if change <= ENOUGH || last {
            return Ok(masses);
        }
        masses.per_winding *= 2;
        coarse = fine;
    }
}

/// Finds how many masses are enough, and gives spring and mount as many.
///
/// # Errors
/// As [`enough_masses`].
pub fn prepare(spring: &mut SpringSpec, mount: &mut MountSpec, conditions: &[ConditionSpec]) -> Result<Masses, Error> {
    let masses = enough_masses(spring, mount, conditions)?;
    spring.spring = spring.spring.clone().with_masses_per_winding(masses.per_winding)?;
    for case in &mut mount.cases {
        case.mount = mounted(&case.mount, &spring.spring)?;
    }
    Ok(masses)
}

impl Masses {
    /// Whether doubling them moves no rms by more than [`ENOUGH`], as far as that was tried.
    pub fn are_enough(&self) -> bool {
        self.change.is_none_or(|change| change <= ENOUGH)
    }
}

/// Largest |b/a − 1|, values below `least` left out.
fn largest_change(coarse: &[f64], fine: &[f64], least: f64) -> f64 {
    let each = coarse.iter().zip(fine).filter(|(a, b)| a.max(**b) > least);
    each.map(|(a, b)| (b - a).abs() / a.max(least)).fold(0.0, f64::max)
}

/// Rms of F_i and F_o about F_x, and of one about the other \[N\], in each condition under each damping.
fn rms(
    spring: &SpringSpec,
    mount: &MountSpec,
    conditions: &[&ConditionSpec],
    masses: usize,
) -> Result<Vec<f64>, Error> {
    let spring = spring.spring.clone().with_masses_per_winding(masses)?;
    let dampings = mount.cases.len();
    let one = |index: usize| {
        let (condition, damping) = (conditions[index / dampings], index % dampings);
        of_case(&spring, &mounted(&mount.cases[damping].mount, &spring)?, condition)
    };
    let each: Vec<[f64; 3]> = (0..conditions.len() * dampings).into_par_iter().map(one).collect::<Result<_, _>>()?;
    Ok(each.into_iter().flatten().collect())
}

fn of_case(spring: &Spring, mount: &Mount, condition: &ConditionSpec) -> Result<[f64; 3], Error> {
    let motion = Motion::mounted(spring, mount, &condition.excitation)?;
    let times = sampled_window(condition.sample_rate, condition.window.0, condition.window.1)?;
    let signals = motion.signals(&times)?;
    let rms = |a, b| Ok(Deviation::between(signals.channel(a)?, signals.channel(b)?)?.rmsd);
    let [first, last, still] = [Channel::InputForce, Channel::OutputForce, Channel::DeflectionForce];
    Ok([rms(first, still)?, rms(last, still)?, rms(last, first)?])
}

/// The same mount for a chain of another number of masses: a ratio for each mode goes on as that of the highest.
pub fn mounted(mount: &Mount, spring: &Spring) -> Result<Mount, Error> {
    let Damping::ModalEach(ratios) = mount.damping() else { return Ok(mount.clone()) };
    let modes = spring.chain_masses() + usize::from(matches!(mount.far_end(), FarEnd::Mass(_)));
    let mut ratios = ratios.clone();
    ratios.resize(modes, ratios.last().copied().unwrap_or(0.0));
    Mount::new(mount.far_end(), Damping::ModalEach(ratios))
}
