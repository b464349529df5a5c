//! How many masses stand for a winding, and what twice as many say of the runs that make the answer.
//!
//! Next door: the map (the parent), what is said of it (`answer`), masses under conditions (`crate::study::Masses`).

use coilsense::modes::ModalModel;
use coilsense::{Error, FarEnd};

use super::point::{self, Asked};
use super::{SpeedMap, SpeedPoint};
use crate::spec::Spec;

/// Most by which the first surge frequency may move when the masses are doubled: a resonance lies at that share of another speed.
const FIRST_ENOUGH: f64 = 3e-3;
/// Most masses for a winding that are taken unasked: the time of a run grows with their square.
const MOST: usize = 4;
/// Most of which twice as many are tried.
const MOST_TRIED: usize = 8;
/// The same of a coil of sections, whose end turns roll on their seats: with twice as many they chatter for minutes.
const MOST_OF_SECTIONS: usize = 2;

/// Why a spec with one mass for a winding is not run with two.
const ONE_ONLY: &str =
    "windings that meet their seat on a mass take one mass per winding; set ends = false in [contact] for more";

/// What twice as many masses for a winding say.
#[derive(Debug, Clone, PartialEq)]
pub struct Finer {
    /// So many.
    pub per_winding: usize,
    /// Runs of the map, by their number in it, once more: that of the most surge, and the slowest ones in which the follower floats and windings
    /// meet. One at a resonance is run where the finer chain has it.
    pub runs: Vec<(usize, SpeedPoint)>,
    /// Why there is none, or not every one.
    pub untried: Option<String>,
}

/// Gives the chain of a spec that asks for no number of masses as many as its first surge frequency takes.
pub(super) fn enough_masses(spec: &mut Spec) -> Result<(), Error> {
    if spec.spring.masses_per_winding.is_some() {
        return Ok(());
    }
    let most = most(spec, MOST);
    while 2 * spec.spring.spring.masses_per_winding() <= most {
        let twice = doubled(spec)?;
        if (first(&twice) / first(spec) - 1.0).abs() <= FIRST_ENOUGH {
            break;
        }
        *spec = twice;
    }
    Ok(())
}

/// With twice the masses for a winding.
fn doubled(spec: &Spec) -> Result<Spec, Error> {
    let mut twice = spec.clone();
    let spring = &spec.spring.spring;
    twice.spring.spring = spring.clone().with_masses_per_winding(2 * spring.masses_per_winding())?;
    Ok(twice)
}

/// The first surge frequency of the chain \[rad/s\].
fn first(spec: &Spec) -> f64 {
    ModalModel::chain(&spec.spring.spring, spec.mount.far_end()).frequencies()[0]
}

/// Whether windings meet a seat on what stands at an end: there a chain has one mass for a winding.
fn takes_one(spec: &Spec) -> bool {
    let is_mass = matches!(spec.mount.far_end(), FarEnd::Mass(_));
    let mut contacts = spec.mount.cases.iter().filter_map(|way| way.contact.as_ref()).map(|way| &way.contact);
    is_mass && contacts.any(coilsense::contact::Contact::ends)
}

fn most(spec: &Spec, of_a_coil: usize) -> usize {
    if spec.spring.spring.sections().is_some() { of_a_coil.min(MOST_OF_SECTIONS) } else { of_a_coil }
}

/// Runs of the map that its answer begins with, each once: the most surge, the slowest that floats, the slowest in which windings meet.
fn decisive(points: &[SpeedPoint]) -> Vec<usize> {
    let number_of = |chosen: Option<(usize, &SpeedPoint)>| chosen.map(|(number, _)| number);
    let slowest = |holds: fn(&SpeedPoint) -> bool| {
        let those = points.iter().enumerate().filter(|(_, point)| holds(point));
        number_of(those.min_by(|a, b| a.1.speed.total_cmp(&b.1.speed)))
    };
    let surge = number_of(points.iter().enumerate().max_by(|a, b| a.1.surge.total_cmp(&b.1.surge)));
    let mut runs: Vec<usize> =
        [surge, slowest(SpeedPoint::is_aloft), slowest(SpeedPoint::meets)].into_iter().flatten().collect();
    runs.sort_unstable();
    runs.dedup();
    runs
}

impl Finer {
    /// Tries them; `go_on` is asked before each run, with how many are done and of how many.
    pub(super) fn of<E>(
        asked: &Asked<'_>,
        points: &[SpeedPoint],
        crossings: &[super::Crossing],
        mut go_on: impl FnMut(usize, usize) -> Result<(), E>,
    ) -> Result<Self, E> {
        let now = asked.spec.spring.spring.masses_per_winding();
        let mut finer = Self { per_winding: 2 * now, runs: Vec::new(), untried: None };
        let twice = match doubled(asked.spec) {
            _ if takes_one(asked.spec) => Err(ONE_ONLY.to_owned()),
            _ if now > most(asked.spec, MOST_TRIED) => Err("that would take minutes".to_owned()),
            twice => twice.map_err(|error| error.to_string()),
        };
        let spec = match twice {
            Ok(spec) => spec,
            Err(why) => return Ok(Self { untried: Some(why), ..finer }),
        };
        let higher = first(&spec) / first(asked.spec);
        let is_resonance = |speed: f64| {
            crossings.iter().any(|crossing| (speed / crossing.speed - 1.0).abs() < (higher - 1.0).abs().max(1e-3))
        };
        let runs = decisive(points);
        for (done, number) in runs.iter().enumerate() {
            go_on(done, runs.len())?;
            let here = &points[*number];
            let speed = here.speed * if is_resonance(here.speed) { higher } else { 1.0 };
            match point::of(&Asked { spec: &spec, ..*asked }, speed, here.way) {
                Ok(run) => finer.runs.push((*number, run)),
                // What there is was run all the same.
                Err(error) => finer.untried = Some(error.to_string()),
            }
        }
        go_on(runs.len(), runs.len())?;
        Ok(finer)
    }

    /// The finer run of one of the map.
    pub fn run_of<'a>(&'a self, map: &SpeedMap, point: &SpeedPoint) -> Option<&'a SpeedPoint> {
        let key = |point: &SpeedPoint| (point.speed.to_bits(), point.way);
        self.runs.iter().find(|(number, _)| key(&map.points[*number]) == key(point)).map(|(_, run)| run)
    }
}
