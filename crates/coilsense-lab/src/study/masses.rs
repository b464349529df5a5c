//! How many masses stand for a winding: doubled until what is printed no longer hangs on them.
//!
//! Next door: one simulation (`simulation`), how far any chain is a coil (`coilsense::Spring::first_frequency_band`).

use coilsense::contact::Law;
use coilsense::signals::sampled_window;
use coilsense::{Channel, Damping, Deviation, Error, FarEnd, Mount, Spring};
#[cfg(not(target_family = "wasm"))]
use rayon::prelude::*;

use super::simulation::{Meets, Setup, simulate};
use crate::spec::{ConditionSpec, DampingCase, Model, MountSpec, SpringSpec};

/// How many masses the chain has for a winding, and what says that they are enough.
#[derive(Debug, Clone, PartialEq)]
pub struct Masses {
    /// Masses for a winding.
    pub per_winding: usize,
    /// Whether the spec asks for so many.
    pub is_given: bool,
    /// By how much the rms of an end force still moves when they are doubled, at most, as a share of it; `None` where that was not tried.
    pub change: Option<f64>,
    /// Up to which such change they are enough.
    pub enough: f64,
    /// Conditions that jump: the rms of the end forces has no limit there, and did not count.
    pub without_limit: Vec<String>,
}

/// Most by which an rms may move when the masses are doubled.
pub const ENOUGH: f64 = 0.005;
/// The same where windings meet: a shock in a chain is as wide as its masses are apart, and twice as many halve what it is off by.
pub const ENOUGH_WITH_CONTACT: f64 = 0.03;
/// Most masses for a winding that are tried.
const MOST: usize = 32;
/// The same where windings meet: the time it takes grows with their square.
const MOST_WITH_CONTACT: usize = 16;
/// The same of a coil of sections, whose end turns roll on their seats: with twice as many they chatter for minutes.
const MOST_OF_SECTIONS: usize = 4;
/// Most masses in all: positions of more take seconds.
const MOST_IN_ALL: usize = 2000;
/// Most positions of masses over all samples of all cases: what a run of a few seconds takes.
const MOST_POSITIONS: f64 = 1e8;
/// An rms below this share of F_nom is not looked at.
const LEAST: f64 = 1e-5;

/// The spring of a spec on its mount under its conditions, with enough masses.
///
/// # Errors
/// Those of [`simulate`].
pub fn enough_masses(spring: &SpringSpec, mount: &MountSpec, conditions: &[ConditionSpec]) -> Result<Masses, Error> {
    let jumps = |condition: &&ConditionSpec| condition.kind == "step";
    let without_limit: Vec<String> = conditions.iter().filter(jumps).map(|condition| condition.name.clone()).collect();
    if spring.model == Model::Helix {
        // No chain moves; so many places of the wire are followed.
        let per_winding = spring.spring.masses_per_winding();
        return Ok(Masses { per_winding, is_given: false, change: None, enough: ENOUGH, without_limit });
    }
    if let Some(per_winding) = spring.masses_per_winding {
        return Ok(Masses { per_winding, is_given: true, change: None, enough: ENOUGH, without_limit });
    }
    let judged: Vec<&ConditionSpec> = conditions.iter().filter(|condition| !jumps(condition)).collect();
    let ways = calmest(mount);
    let enough = if ways.iter().any(|way| way.contact.is_some()) { ENOUGH_WITH_CONTACT } else { ENOUGH };
    let rms_of = |masses| rms(spring, &ways, &judged, masses);
    let least = spring.spring.masses_per_winding();
    let mut masses = Masses { per_winding: least, is_given: false, change: None, enough, without_limit };
    if judged.is_empty() || 2 * least * spring.spring.whole_windings() > MOST_IN_ALL {
        return Ok(masses);
    }
    let samples: f64 = judged.iter().map(|condition| condition.duration * condition.sample_rate).sum();
    let most = (MOST_POSITIONS / (samples * mount.cases.len() as f64)).min(MOST_IN_ALL as f64) as usize;
    let mut coarse = rms_of(least)?;
    loop {
        let meets = ways.iter().any(|way| way.contact.is_some());
        let fine = match rms_of(2 * masses.per_winding) {
            // A finer chain that chatters without end is no reason to refuse a coarser one that does not.
            Err(_) if meets => return Ok(masses),
            fine => fine?,
        };
        let change = largest_change(&coarse, &fine, LEAST * spring.spring.nominal_force());
        masses.change = Some(change);
        let twice = 2 * masses.per_winding;
        let most_per_winding = match (meets, spring.spring.sections()) {
            (true, Some(_)) => MOST_OF_SECTIONS,
            (true, None) => MOST_WITH_CONTACT,
            (false, _) => MOST,
        };
        let last = twice > most_per_winding || twice * spring.spring.whole_windings() > most;
        if change <= enough || last {
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
    /// Whether doubling them moves no rms by more than that, as far as it was tried.
    pub fn are_enough(&self) -> bool {
        self.change.is_none_or(|change| change <= self.enough)
    }
}

/// Largest |b/a − 1|, values below `least` left out.
fn largest_change(coarse: &[f64], fine: &[f64], least: f64) -> f64 {
    let each = coarse.iter().zip(fine).filter(|(a, b)| a.max(**b) > least);
    each.map(|(a, b)| (b - a).abs() / a.max(least)).fold(0.0, f64::max)
}

/// The mounts of a spec, of windings that meet only those that rebound least: with a rebound the loss in a shock goes into a rattle of the masses
/// that has no limit for many of them.
fn calmest(mount: &MountSpec) -> Vec<&DampingCase> {
    let rebound = |way: &DampingCase| {
        way.contact.as_ref().map_or(0.0, |way| match way.contact.law() {
            Law::Hard { restitution } => restitution,
            Law::Elastic { damping_ratio, .. } => -damping_ratio,
        })
    };
    let least = mount.cases.iter().map(rebound).fold(f64::INFINITY, f64::min);
    mount.cases.iter().filter(|way| rebound(way) <= least).collect()
}

/// Rms of F_i and F_o about F_x, and of one about the other \[N\], in each condition under each damping.
fn rms(
    spring: &SpringSpec,
    ways: &[&DampingCase],
    conditions: &[&ConditionSpec],
    masses: usize,
) -> Result<Vec<f64>, Error> {
    let spring = spring.spring.clone().with_masses_per_winding(masses)?;
    let dampings = ways.len();
    let one = |index: usize| of_case(&spring, ways[index % dampings], conditions[index / dampings]);
    let each = 0..conditions.len() * dampings;
    // In a browser there is one thread, and rayon is 10 kB of what the page loads first.
    #[cfg(not(target_family = "wasm"))]
    let each = each.into_par_iter();
    let each: Vec<[f64; 3]> = each.map(one).collect::<Result<_, _>>()?;
    Ok(each.into_iter().flatten().collect())
}

fn of_case(spring: &Spring, way: &DampingCase, condition: &ConditionSpec) -> Result<[f64; 3], Error> {
    let mount = &mounted(&way.mount, spring)?;
    let times = sampled_window(condition.sample_rate, condition.window.0, condition.window.1)?;
    let contact = way.contact.as_ref().map(|way| Meets { contact: &way.contact, apart: None });
    let excitation = &condition.excitation;
    let setup = Setup { spring, mount, excitation, coil: None, positions: false, helix: None, contact };
    let signals = simulate(&setup, &times)?.signals;
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
