//! A spring under a cam, from speed to speed: forces at both ends, surge, windings that meet, a follower that floats.
//!
//! ```text
//! Spec ([cam], [contact]) ─► SpeedMap: each speed × each way to damp and rebound, run until it repeats ─► answer ─► report
//!                            Campbell: harmonics of the cam across the lines of the spring and its neighbours
//! ```
//!
//! Next door: the cam (`crate::spec`), one run (`coilsense::contact`), how a map is shown (`crate::report`).

mod answer;
mod campbell;
mod doubts;
mod fatigue;
mod finer;
mod judged;
mod kept;
mod point;
pub mod request;
mod speeds;

pub(crate) use answer::SETTLED;
pub use answer::answer;
pub use campbell::{Campbell, Crossing, Line};
pub use fatigue::Stress;
pub use finer::Finer;
pub use judged::{Floating, HARMONICS, SpeedPoint};
pub use kept::Part;

use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use coilsense::Error;
use rayon::prelude::*;

use self::kept::Kept;
use self::point::{Asked, Waves};
use self::speeds::Speeds;
use crate::spec::{CamSpec, Spec};

/// Why a map was not made.
#[derive(Debug, thiserror::Error)]
pub enum SpeedError {
    /// The spec lacks something, or the range is none.
    #[error("{0}")]
    Spec(String),
    /// The science refuses.
    #[error("{file}: at {rpm} rpm, {way}: {reason}")]
    Point {
        /// The spec's file.
        file: String,
        /// Of the engine.
        rpm: f64,
        /// Damping and rebound.
        way: String,
        /// What the science says.
        reason: Box<Error>,
    },
    /// The science refuses outside of any run.
    #[error("{0}")]
    Science(#[from] Error),
    /// Somebody stopped it.
    #[error("interrupted; nothing was written")]
    Interrupted,
    /// The same, and points are kept.
    #[error("interrupted; what was computed is in {0}, the same command goes on from there")]
    Paused(String),
}

/// From which speed to which.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// The lowest speed of the engine \[Hz\].
    pub from: f64,
    /// The highest \[Hz\].
    pub to: f64,
    /// In steps of \[Hz\].
    pub step: f64,
    /// Turns of the camshaft for one of the engine \[1\].
    pub ratio: f64,
}

/// What a spring does at each speed.
#[derive(Debug, Clone, PartialEq)]
pub struct SpeedMap {
    /// What was asked.
    pub spec: Spec,
    /// The cam.
    pub cam: CamSpec,
    /// From where to where.
    pub range: Range,
    /// Each speed in each way (damping and rebound), speed by speed.
    pub points: Vec<SpeedPoint>,
    /// Harmonics of the cam across the lines of the spring.
    pub campbell: Campbell,
    /// Speeds of each way beside the steps: about where a harmonic of the cam has the first surge frequency.
    pub added: Vec<usize>,
    /// Masses for a winding of the chain.
    pub masses_per_winding: usize,
    /// What twice as many say of the runs that the answer begins with.
    pub finer: Finer,
}

/// What a part of a map has done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Share {
    /// Points of this part.
    pub points: usize,
    /// Points of the map.
    pub of: usize,
    /// Those of the map that are there now.
    pub there: usize,
}

/// A spec that turns a camshaft, and which runs that takes.
struct Planned {
    spec: Spec,
    cam: CamSpec,
    range: Range,
    campbell: Campbell,
    added: Vec<usize>,
    /// Speed and way of each run.
    jobs: Vec<(f64, usize)>,
    waves: Waves,
}

/// Most speeds of a map.
const MOST_SPEEDS: usize = 2000;

/// Told how much is done, and of how much; whether to go on.
pub type Progress<'a> = dyn Fn(usize, usize) -> bool + Sync + 'a;

impl Range {
    fn check(&self) -> Result<(), SpeedError> {
        let refuse = |what: &str, hertz: f64, allowed: &str| {
            Err(SpeedError::Spec(format!("{what} must be {allowed}, got {} rpm", rounded(60.0 * hertz))))
        };
        if !(self.from > 0.0 && self.from <= 1e4) {
            return refuse("from", self.from, "above 0 and at most 600000 rpm");
        }
        if !(self.to >= self.from && self.to <= 1e4) {
            return refuse("to", self.to, &format!("from {} to 600000 rpm", rounded(60.0 * self.from)));
        }
        if !(self.step > 0.0 && (self.to - self.from) / self.step <= MOST_SPEEDS as f64) {
            return refuse("step", self.step, &format!("above 0, for {MOST_SPEEDS} speeds at most"));
        }
        if !(self.ratio > 0.0 && self.ratio <= 100.0) {
            return Err(SpeedError::Spec(format!("cam_ratio must be above 0 and at most 100, got {}", self.ratio)));
        }
        Ok(())
    }

    fn steps(&self) -> Vec<f64> {
        let count = ((self.to - self.from) / self.step + 1e-9).floor() as usize;
        let mut each: Vec<f64> = (0..=count).map(|index| self.from + index as f64 * self.step).collect();
        if each.last().is_some_and(|last| self.to - last > 1e-6 * self.step) {
            each.push(self.to);
        }
        each
    }
}

/// Revolutions a minute without what a unit's factor leaves.
fn rounded(rpm: f64) -> f64 {
    (1e6 * rpm).round() / 1e6
}

impl SpeedMap {
    /// Makes the map of a spec.
    ///
    /// # Errors
    /// [`SpeedError`] for a spec without `[cam]` or `[contact]`, a range that is none, what the science refuses, and where `progress` says stop.
    pub fn of(spec: Spec, range: Range, progress: &Progress<'_>) -> Result<Self, SpeedError> {
        let planned = Planned::of(spec, range)?;
        let points = planned.run(&planned.jobs, None, progress)?;
        planned.with(points, None, progress)
    }

    /// The same, with points in a folder: those that are there are taken, the others are written there as they are made. They are the same bit by bit.
    /// [`Self::forget`] removes them.
    ///
    /// # Errors
    /// As [`Self::of`], and where the folder cannot be read or written.
    pub fn kept(spec: Spec, range: Range, folder: &Path, progress: &Progress<'_>) -> Result<Self, SpeedError> {
        let planned = Planned::of(spec, range)?;
        let kept = planned.open(folder)?;
        let points = planned.run(&planned.jobs, Some(&kept), progress)?;
        planned.with(points, Some(&kept), progress)
    }

    /// Makes a part of the points into that folder, as one of several machines that share it.
    ///
    /// # Errors
    /// As [`Self::kept`].
    pub fn part(
        spec: Spec,
        range: Range,
        folder: &Path,
        part: Part,
        progress: &Progress<'_>,
    ) -> Result<Share, SpeedError> {
        let planned = Planned::of(spec, range)?;
        let kept = planned.open(folder)?;
        let own = planned.jobs.iter().enumerate().filter(|(number, _)| part.holds(*number)).map(|(_, job)| *job);
        let own: Vec<_> = own.collect();
        planned.run(&own, Some(&kept), progress)?;
        let now = planned.open(folder)?;
        let there = planned.jobs.iter().filter(|(speed, way)| now.find(*speed, *way).is_some()).count();
        Ok(Share { points: own.len(), of: planned.jobs.len(), there })
    }

    /// Removes the points of this map from a folder, and the folder if nothing else is in it.
    ///
    /// # Errors
    /// [`SpeedError::Spec`] for a file that cannot be removed.
    pub fn forget(&self, folder: &Path) -> Result<(), SpeedError> {
        Kept::new(folder, &self.spec, &self.cam, &self.range).remove()
    }

    /// The points of one way, by rising speed.
    pub fn of_way(&self, way: usize) -> impl Iterator<Item = &SpeedPoint> {
        self.points.iter().filter(move |point| point.way == way)
    }
}

impl Planned {
    fn of(mut spec: Spec, range: Range) -> Result<Self, SpeedError> {
        range.check()?;
        spec.needs_one_spring("speed").map_err(|refused| SpeedError::Spec(refused.to_string()))?;
        let lacks = |what: &str| SpeedError::Spec(format!("{}: {what}", spec.file));
        // All that is missing at once.
        let meets = spec.mount.cases.iter().all(|way| way.contact.is_some());
        let without_contact = "speed takes a table [contact] (windings = \"hard\"): at some speed windings meet, and without it they would pass through one \
                               another";
        let cam = match (spec.cam.clone(), meets) {
            (Some(cam), true) => cam,
            (Some(_), false) => return Err(lacks(without_contact)),
            (None, meets) => {
                let no_cam = "no table [cam] says what moves end 1; give its law, lift and angle";
                let follower = "; follower_mass under [mount] asks whether a valve leaves its cam, too";
                return Err(lacks(&if meets {
                    no_cam.to_owned()
                } else {
                    format!("{no_cam}; {without_contact}{follower}")
                }));
            }
        };
        if spec.mount.far_end() == coilsense::FarEnd::Force {
            return Err(lacks("speed takes an end 2 that is held or has a mass: no force on it is in the spec"));
        }
        spec.spring.look_up_surges(&spec.mount.ends);
        finer::enough_masses(&mut spec)?;
        let campbell = Campbell::of(&spec, &cam, &range);
        let ways: Vec<Speeds> = (0..spec.mount.cases.len())
            .map(|way| Ok(Speeds::of(&range, &campbell, point::first_ratio(&spec, way)?)))
            .collect::<Result<_, Error>>()?;
        let added = ways.iter().map(|speeds| speeds.added).collect();
        Ok(Self { jobs: jobs(&ways), waves: Waves::of(&cam), cam, range, campbell, added, spec })
    }

    fn open(&self, folder: &Path) -> Result<Kept, SpeedError> {
        Kept::new(folder, &self.spec, &self.cam, &self.range).open()
    }

    fn run(
        &self,
        jobs: &[(f64, usize)],
        kept: Option<&Kept>,
        progress: &Progress<'_>,
    ) -> Result<Vec<SpeedPoint>, SpeedError> {
        run_all(&self.asked(), jobs, kept, progress)
    }

    fn asked(&self) -> Asked<'_> {
        Asked { spec: &self.spec, cam: &self.cam, range: &self.range, waves: &self.waves }
    }

    /// The map of all points, and how far its answer hangs on the masses.
    fn with(
        self,
        points: Vec<SpeedPoint>,
        kept: Option<&Kept>,
        progress: &Progress<'_>,
    ) -> Result<SpeedMap, SpeedError> {
        let jobs = self.jobs.len();
        let tell = |done, of| go_on(progress, kept, jobs + done, jobs + of);
        let finer = Finer::of(&self.asked(), &points, &self.campbell.crossings, tell)?;
        let Self { spec, cam, range, campbell, added, .. } = self;
        let masses_per_winding = spec.spring.spring.masses_per_winding();
        Ok(SpeedMap { cam, range, points, campbell, added, masses_per_winding, finer, spec })
    }
}

/// Every speed of every way, speed by speed: the long runs, those at few turns a second, first.
fn jobs(ways: &[Speeds]) -> Vec<(f64, usize)> {
    let of_way =
        |(way, speeds): (usize, &Speeds)| speeds.each.iter().map(move |speed| (*speed, way)).collect::<Vec<_>>();
    let mut jobs: Vec<(f64, usize)> = ways.iter().enumerate().flat_map(of_way).collect();
    jobs.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    jobs
}

/// Tells how much is done, and whether that is all for now.
fn go_on(progress: &Progress<'_>, kept: Option<&Kept>, done: usize, of: usize) -> Result<(), SpeedError> {
    match (progress(done, of), kept) {
        (true, _) => Ok(()),
        (false, None) => Err(SpeedError::Interrupted),
        (false, Some(kept)) => Err(SpeedError::Paused(kept.place())),
    }
}

/// Runs them on all cores, but for those that are kept.
fn run_all(
    asked: &Asked<'_>,
    jobs: &[(f64, usize)],
    kept: Option<&Kept>,
    progress: &Progress<'_>,
) -> Result<Vec<SpeedPoint>, SpeedError> {
    let spec = asked.spec;
    let done = AtomicUsize::new(0);
    let go_on = |done: usize| go_on(progress, kept, done, jobs.len());
    let one = |&(speed, way): &(f64, usize)| {
        go_on(done.load(Ordering::Relaxed))?;
        let there = kept.and_then(|kept| kept.find(speed, way)).cloned();
        let point = if let Some(point) = there {
            point
        } else {
            let found = point::of(asked, speed, way);
            let point = found.map_err(|reason| SpeedError::Point {
                file: spec.file.clone(),
                rpm: (600.0 * speed).round() / 10.0,
                way: spec.mount.cases[way].label.clone(),
                reason: Box::new(reason),
            })?;
            kept.map_or(Ok(()), |kept| kept.keep(&point))?;
            point
        };
        go_on(done.fetch_add(1, Ordering::Relaxed) + 1)?;
        Ok(point)
    };
    jobs.par_iter().with_max_len(1).map(one).collect()
}
