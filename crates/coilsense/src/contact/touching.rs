//! A spring whose windings may meet: the linear motion up to there, the chain from event to event from there on.
//!
//! Next door: the linear motion (`crate::motion`), the chain (`follow`), whether windings meet at all (`crate::measures::Clash`).

use super::begin::{start, unloaded};
use super::chain::Chain;
use super::course::{Course, Touch};
use super::damper::Damper;
use super::drive::Drive;
use super::follow::follow_damped;
use super::law::Contact;
use super::path::Path;
use super::start::Watch;
use crate::error::{Error, check};
use crate::excitation::{End, EndInput};
use crate::measures::Clash;
use crate::motion::{Motion, Windings};
use crate::mount::FarEnd;
use crate::signals::{Channel, Signals};

/// What a motion becomes where windings meet.
#[derive(Debug, Clone)]
pub struct Touching {
    /// u1, u2, F_i, F_o and F_x: those of the motion, bit by bit, until something meets. Ends early where the course was given up.
    pub signals: Signals,
    /// What the chain did; `None` where nothing meets.
    pub course: Option<Course>,
    /// Positions of both ends and all masses, where they were asked for.
    pub windings: Option<Windings>,
    /// The forces once more, from an input that is larger by [`CHANGE`]; `None` where nothing meets.
    changed: Option<[Vec<f64>; 2]>,
}

/// By how much the input of the second run is larger \[1\].
pub const CHANGE: f64 = 1e-6;

/// A pair is looked at closely from where this share \[1\] of its mean distance is left.
const NEAR: f64 = 0.1;

/// Samples whose positions are held at once while a first contact is looked for: so many at first, twice as many each time, since a motion begins
/// anew with each; and at most so many positions.
const AT_FIRST: usize = 2048;
const MOST_AT_ONCE: usize = 1 << 22;

/// How far apart in angle \[rad\] of the chain's fastest mode it is looked for.
const WATCH: f64 = 1.0;

impl Touching {
    /// Of a motion of the paper's chain, at `times` \[s\], ascending.
    ///
    /// Until the first contact the motion holds. From there on [`super::follow()`] goes on from its state, twice: the second run, with an input larger
    /// by [`CHANGE`], tells for how long the first means anything ([`Self::holds_until`]). A recorded input stays straight from sample to
    /// sample, as in the motion: an end that windings lie on is struck at each of its samples.
    ///
    /// Source:   [`Motion`] and [`super::follow()`].
    /// Valid:    as there; ends and windings that are not asked about in `contact` pass through one another, as in the motion.
    /// Accuracy: as there. The first contact is looked for in steps of a radian of the fastest mode, and closely where a tenth of a gap is left.
    ///
    /// # Errors
    /// Those of [`Chain::of`]; [`Error::Value`] for times, for a motion whose modes are not those of a chain, and for windings that overlap at
    /// the start.
    pub fn of(motion: &Motion, contact: &Contact, times: &[f64], with_windings: bool) -> Result<Self, Error> {
        Self::found(motion, contact, times, with_windings, true)
    }

    /// The same by one run only: nothing is known of how long it holds, and [`Self::holds_until`] refuses. Without windings the course's balance
    /// holds no work and no damping.
    ///
    /// # Errors
    /// As [`Self::of`].
    pub fn once(motion: &Motion, contact: &Contact, times: &[f64], with_windings: bool) -> Result<Self, Error> {
        Self::found(motion, contact, times, with_windings, false)
    }

    fn found(
        motion: &Motion,
        contact: &Contact,
        times: &[f64],
        with_windings: bool,
        twice: bool,
    ) -> Result<Self, Error> {
        crate::error::at_least_one("times", times.len())?;
        // Which lets through ascending times only.
        let signals = motion.signals(times)?;
        let pitch = contact.pitch().unwrap_or(motion.spring().wire_diameter());
        let is_chain = motion.modes().is_chain() || motion.spring().sections().is_some();
        check(
            is_chain,
            "modes",
            motion.modes().count() as f64,
            "",
            "those of a chain of equal masses where windings may meet",
        )?;
        let until = times[times.len() - 1];
        let all = || with_windings.then(|| motion.windings(times)).transpose();
        let only_windings = !contact.ends() && !contact.lifts() && contact.follower().is_none();
        if only_windings {
            // Refuses what the chain would, which is not made where a bound keeps all windings apart.
            Chain::gap(motion.spring(), motion.mount().far_end(), pitch, false)?;
            if Clash::excluded(motion, until, pitch) {
                return Ok(Self { signals, course: None, windings: all()?, changed: None });
            }
        }
        let chain = chain_of(motion, contact, pitch)?;
        let Some(begin) = first_near(motion, contact, &chain, times)? else {
            return Ok(Self { signals, course: None, windings: all()?, changed: None });
        };
        let damper = Damper::of(motion.mount().damping(), &chain, motion.modes())?;
        let later = times.partition_point(|time| *time < begin);
        let watch = match (with_windings, twice) {
            (true, _) => Watch::Places,
            (false, true) => Watch::Forces,
            (false, false) => Watch::Ends,
        };
        let run = |larger: f64, watch: Watch| {
            let drives = drives(motion, contact, larger)?;
            let start = start(motion, contact, &chain, &drives, (begin, larger))?;
            follow_damped(&chain, contact, &damper, &drives, &start, &times[later..], watch)
        };
        let course = run(1.0, watch)?;
        if first_change(&course).is_none() && course.given_up.is_none() {
            return Ok(Self { signals, course: None, windings: all()?, changed: None });
        }
        let allowed = "one at which windings are not solid between ends that close on them";
        check(later > 0 || !course.input.is_empty(), "start", begin, "s", allowed)?;
        let second = if twice { Some(run(1.0 + CHANGE, Watch::Ends)?) } else { None };
        // A course that was given up may end before anything in it has met.
        let reached = later + course.input.len();
        let from =
            first_change(&course).map_or(reached, |first| times.partition_point(|time| *time < first)).min(reached);
        let windings = with_windings.then(|| merged_windings(motion, &course, times, later, from)).transpose()?;
        let signals = merged(motion, signals, &course, later, from)?;
        let changed = second.map(|second| [second.input, second.output]);
        Ok(Self { signals, windings, changed, course: Some(course) })
    }

    /// The chain alone, from t = 0 on, whatever may meet: what stands for the motion where nothing does.
    ///
    /// # Errors
    /// As [`Self::of`].
    pub fn followed(motion: &Motion, contact: &Contact, times: &[f64]) -> Result<Course, Error> {
        let pitch = contact.pitch().unwrap_or(motion.spring().wire_diameter());
        let chain = chain_of(motion, contact, pitch)?;
        let damper = Damper::of(motion.mount().damping(), &chain, motion.modes())?;
        let drives = drives(motion, contact, 1.0)?;
        let start = start(motion, contact, &chain, &drives, (0.0, 1.0))?;
        follow_damped(&chain, contact, &damper, &drives, &start, times, Watch::Forces)
    }

    /// The chain alone, from rest at t = 0 on, its end 1 driven along a path in place of the motion's input; with the wire's tensions.
    ///
    /// # Errors
    /// As [`Self::of`].
    pub fn driven(motion: &Motion, contact: &Contact, path: Path, times: &[f64]) -> Result<Course, Error> {
        let pitch = contact.pitch().unwrap_or(motion.spring().wire_diameter());
        let chain = chain_of(motion, contact, pitch)?;
        let damper = Damper::of(motion.mount().damping(), &chain, motion.modes())?;
        let [_, second] = drives(motion, contact, 1.0)?;
        let drives = [Drive::Path(path), second];
        let start = start(motion, contact, &chain, &drives, (0.0, 1.0))?;
        follow_damped(&chain, contact, &damper, &drives, &start, times, Watch::Tensions)
    }

    /// When something first meets, an end first leaves its seat, or a follower its cam \[s\].
    pub fn first_contact(&self) -> Option<f64> {
        self.course.as_ref().and_then(first_change)
    }

    /// Up to when both forces are within `goal` \[N\] of those under an input larger by [`CHANGE`] \[s\]: what comes after that is good in its mean
    /// squares and extremes at best. The last time, where they are throughout.
    ///
    /// # Errors
    /// [`Error::Value`] for a goal that is not above zero; [`Error::MissingSignal`] of [`Self::once`], where something met.
    pub fn holds_until(&self, goal: f64) -> Result<f64, Error> {
        crate::error::above_zero("goal", goal, "N")?;
        let time = self.signals.time();
        let last = time[time.len() - 1];
        if self.course.is_none() {
            return Ok(last);
        }
        let [input, output] = self.changed.as_ref().ok_or(Error::MissingSignal("of a second run"))?;
        let reached = self.course.as_ref().map_or(0, |course| course.input.len());
        let later = time.len() - reached;
        let pairs = [(Channel::InputForce, input), (Channel::OutputForce, output)];
        let mut until = last;
        for (channel, changed) in pairs {
            let here = &self.signals.channel(channel)?[later..];
            let apart = here.iter().zip(changed).position(|(force, changed)| (force - changed).abs() > goal);
            let apart = apart.or((changed.len() < here.len()).then_some(changed.len()));
            if let Some(apart) = apart {
                until = until.min(time[(later + apart).saturating_sub(1)]);
            }
        }
        Ok(until)
    }

    /// What met, in the order in which it did.
    pub fn touches(&self) -> &[Touch] {
        self.course.as_ref().map_or(&[], |course| &course.touches)
    }
}

fn first_change(course: &Course) -> Option<f64> {
    let touches = course.touches.iter().map(|touch| touch.time);
    let lifts = course.lifts.iter().map(|lift| lift.time);
    touches.chain(lifts).chain(course.floats.iter().map(|float| float.time)).reduce(f64::min)
}

/// The chain of a motion's spring, on its follower where it has one.
fn chain_of(motion: &Motion, contact: &Contact, pitch: f64) -> Result<Chain, Error> {
    let chain = Chain::of(motion.spring(), motion.mount().far_end(), pitch, contact.ends())?;
    match contact.follower() {
        Some(mass) => chain.on_follower(mass),
        None => Ok(chain),
    }
}

/// The time from which the chain is followed \[s\]: just before something may meet. `None` where all stays clear.
fn first_near(motion: &Motion, contact: &Contact, chain: &Chain, times: &[f64]) -> Result<Option<f64>, Error> {
    let fastest = motion.modes().frequencies().last().copied().unwrap_or(1.0);
    let until = times[times.len() - 1];
    // In whole parts of the distance of samples, on which those of a recording mostly lie too: a motion goes over such a grid without looking up
    // each of its steps.
    let apart = times.get(1).map_or(until, |second| second - times[0]);
    let step = apart / (apart * fastest / WATCH).ceil().max(1.0);
    let count = if step > 0.0 { (until / step).ceil() as usize } else { 0 };
    let all: Vec<f64> = (0..=count).map(|sample| (sample as f64 * step).min(until)).collect();
    let spring = motion.spring();
    let rest = spring.rest_length();
    let mean = motion.excitation().mean_length();
    let unloaded: Vec<f64> = unloaded(motion);
    let slow = chain.shares().iter().map(|share| share * (mean - rest)).collect::<Vec<f64>>();
    let base = chain.base();
    let pairs = &chain.pairs()[base..];
    let near: Vec<f64> =
        pairs.iter().map(|pair| NEAR * (slow[pair.second] - slow[pair.first] + pair.gap).max(0.0)).collect();
    let cam = drives(motion, contact, 1.0)?;
    let mut before = 0.0;
    let (mut rest_of_all, mut at_once) = (all.as_slice(), AT_FIRST);
    while !rest_of_all.is_empty() {
        let (block, later) = rest_of_all.split_at(at_once.min(rest_of_all.len()));
        rest_of_all = later;
        at_once = (2 * at_once).min((MOST_AT_ONCE / chain.lumps()).max(AT_FIRST));
        let windings = motion.windings(block)?;
        let asks = contact.lifts() || contact.follower().is_some();
        let forces = if asks { Some(motion.end_forces(block)?) } else { None };
        for (sample, &time) in block.iter().enumerate() {
            let row = windings.row(sample);
            let [u1, u2] = windings.ends(sample);
            let place = |point: usize| match point - base {
                0 => u1,
                point if point <= row.len() => row[point - 1] - unloaded[point - 1],
                _ => u2 - rest,
            };
            let meets = pairs.iter().zip(&near);
            let meets = meets.clone().any(|(pair, near)| place(pair.second) - place(pair.first) + pair.gap <= *near);
            let scale = NEAR * spring.static_force(mean).abs();
            let floats = contact.follower().zip(forces.as_ref()).is_some_and(|(mass, forces)| {
                // Its acceleration is twice the second coefficient over a second.
                2.0 * mass * cam[0].series(time, 1.0)[2] - forces.input[sample] < scale
            });
            let lifts = forces.as_ref().filter(|_| contact.lifts()).is_some_and(|forces| {
                forces.input[sample] > -scale
                    || motion.mount().far_end() != FarEnd::Force && forces.output[sample] > -scale
            });
            if meets || lifts || floats {
                return Ok(Some(before));
            }
            before = time;
        }
    }
    Ok(None)
}

/// What drives the ends, by a factor larger about the mean. A recording that pushes a follower is a smooth curve through its samples: straight from
/// sample to sample, each would strike it.
fn drives(motion: &Motion, contact: &Contact, larger: f64) -> Result<[Drive; 2], Error> {
    let (spring, mean) = (motion.spring(), motion.excitation().mean_length());
    let about = match motion.mount().far_end() {
        FarEnd::Position => mean - spring.rest_length(),
        FarEnd::Force | FarEnd::Mass(_) => spring.static_force(mean),
    };
    let input = |end: End| motion.excitation().input(end).scaled(larger);
    let first = match (input(End::One), contact.follower()) {
        (EndInput::Sampled(samples), Some(_)) => Drive::Path(Path::spline(samples.times(), samples.values())?),
        (first, _) => Drive::Input(first, 0.0),
    };
    Ok([first, Drive::Input(input(End::Two), about)])
}

/// The motion's signals up to sample `from`, the course's from there on; those that it did not reach are cut off.
fn merged(motion: &Motion, signals: Signals, course: &Course, later: usize, from: usize) -> Result<Signals, Error> {
    let reached = later + course.input.len();
    let (time, channels) = signals.into_parts();
    let mut merged = Signals::new(time[..reached].to_vec())?;
    let rest = motion.spring().rest_length();
    let is_prescribed = motion.mount().far_end() == FarEnd::Position;
    for (channel, mut values) in channels {
        values.truncate(reached);
        let with = |values: &mut Vec<f64>, of: &[f64], more: f64| {
            for (value, of) in values[from..reached].iter_mut().zip(&of[from - later..]) {
                *value = of + more;
            }
        };
        match channel {
            Channel::InputForce => with(&mut values, &course.input, 0.0),
            Channel::OutputForce => with(&mut values, &course.output, 0.0),
            Channel::U1 if !course.cam_force.is_empty() => with(&mut values, &course.end1, 0.0),
            Channel::U2 if !is_prescribed => with(&mut values, &course.end2, rest),
            Channel::DeflectionForce if !is_prescribed || !course.cam_force.is_empty() => {
                let ends = course.end1[from - later..].iter().zip(&course.end2[from - later..]);
                for (value, (first, second)) in values[from..reached].iter_mut().zip(ends) {
                    *value = motion.spring().static_force(second + rest - first);
                }
            }
            _ => {}
        }
        merged.insert(channel, values)?;
    }
    Ok(merged)
}

/// The same of positions.
fn merged_windings(
    motion: &Motion,
    course: &Course,
    times: &[f64],
    later: usize,
    from: usize,
) -> Result<Windings, Error> {
    let reached = later + course.input.len();
    let (mut ends, mut positions) = motion.windings(&times[..reached])?.into_parts();
    let (masses, lumps) = (motion.spring().chain_masses(), course.places.len() / course.input.len().max(1));
    let (unloaded, rest) = (unloaded(motion), motion.spring().rest_length());
    let base = usize::from(!course.cam_force.is_empty());
    for sample in from..reached {
        let row = &course.places[(sample - later) * lumps + base..][..masses];
        let places = positions[sample * masses..].iter_mut().zip(row).zip(&unloaded);
        places.for_each(|((position, place), unloaded)| *position = place + unloaded);
        ends[sample] = [course.end1[sample - later], course.end2[sample - later] + rest];
    }
    Windings::new(ends, positions)
}
