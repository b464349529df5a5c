//! Motion, positions of the windings, inductance and the forces that follow, over a series of times.
//!
//! Next door: how many masses stand for a winding (`masses`), the judgement of sensors (`crate::analysis`).

use coilsense::contact::{Contact, GivenUp, Touching};
use coilsense::inductance::{BoundedSeries, MaxwellSum, SteelWindings};
use coilsense::motion::Windings;
use coilsense::{Calibration, Channel, Error, Excitation, InductanceSensor, Motion, Mount, Signals, Spring};

use super::contacts::{Between, Contacts, MEET};
use super::helical::{self, EndLoads, Helical};
use super::seen::Seen;
use crate::spec::{Magnetised, SpringInductance};

/// What is simulated.
#[derive(Debug, Clone, Copy)]
pub struct Setup<'a> {
    /// The spring, with as many masses as its chain is to have.
    pub spring: &'a Spring,
    /// What end 2 is tied to, and what damps the windings.
    pub mount: &'a Mount,
    /// How the ends move and how the windings start.
    pub excitation: &'a Excitation,
    /// The coil whose inductance is wanted; without it there is no L and no F_L.
    pub coil: Option<Coil<'a>>,
    /// Whether the positions of the windings are wanted.
    pub positions: bool,
    /// The helix that moves in place of the spring's chain, its stiffness and its frequencies multiplied.
    pub helix: Option<(&'a Helical, [f64; 2])>,
    /// What windings of the chain do when they meet; without it they pass through one another.
    pub contact: Option<Meets<'a>>,
}

/// How windings meet, and what is asked of it.
#[derive(Debug, Clone, Copy)]
pub struct Meets<'a> {
    /// The law.
    pub contact: &'a Contact,
    /// The force \[N\] by which it is judged for how long the answer holds, which takes a second run; `None` where nobody asks.
    pub apart: Option<f64>,
}

/// The spring as an inductance, with what its meter is told.
#[derive(Debug, Clone, Copy)]
pub struct Coil<'a> {
    /// Maxwell's sum over its windings.
    pub sum: &'a MaxwellSum,
    /// The same of magnetic wire, which L is then by, whatever the method.
    pub steel: Option<&'a SteelWindings>,
    /// α and β of eq. (13).
    pub calibration: Calibration,
    /// How L is found.
    pub method: Method,
}

/// How L is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// By the exact sum.
    Exact,
    /// To second order where that is within this share of L, by the exact sum elsewhere.
    Within(f64),
}

/// A spring, simulated.
#[derive(Debug, Clone)]
pub struct Simulation {
    /// The motion, for more times.
    pub motion: Motion,
    /// u1, u2, F_i, F_o, F_x, and of a coil L and F_L; shape `times`.
    pub signals: Signals,
    /// Where the masses of the chain are, where that was wanted.
    pub windings: Option<Windings>,
    /// L with its bounds, where it was found within a tolerance.
    pub bounded: Option<BoundedSeries>,
    /// L with its doubts, where the wire is magnetic.
    pub magnetised: Option<Magnetised>,
    /// Of a helix: what holds end 1 and end 2 feels beside the axial force.
    pub loads: Option<[EndLoads; 2]>,
    /// The signals as sensors see them.
    pub seen: Seen,
    /// What met, where windings were asked to.
    pub contacts: Option<Contacts>,
}

impl<'a> Coil<'a> {
    /// A coil whose meter is calibrated by theory over the operating range and set to zero at `mean_length` \[m\].
    ///
    /// # Errors
    /// [`Error::Value`] for a coil whose eq. (13) cannot be fitted, such as a single winding.
    pub fn of(
        spring: &Spring,
        inductance: &'a SpringInductance,
        mean_length: f64,
        method: Method,
    ) -> Result<Self, Error> {
        let calibration = Calibration::theoretical(spring, inductance, mean_length)?;
        Ok(Self { sum: inductance.in_air(), steel: inductance.steel(), calibration, method })
    }
}

/// Simulates a setup at `times` \[s\], strictly increasing, none below zero.
///
/// # Errors
/// Those of [`Motion::mounted`], [`Helical::simulate`], [`Motion::signals`], [`Motion::windings`], [`Touching::of`] and
/// [`MaxwellSum::series_within`]; [`Error::Value`] for windings that could not be followed to the last of the times.
pub fn simulate(setup: &Setup<'_>, times: &[f64]) -> Result<Simulation, Error> {
    // Turns of unequal radii are summed one by one.
    let by_place = setup.coil.is_some_and(|coil| coil.steel.is_some() || coil.method == Method::Exact)
        || setup.spring.sections().is_some();
    let moved = moved(setup, times, by_place || setup.positions)?;
    let Moved { motion, mut signals, windings, loads, read, struck, contacts } = moved;
    let (mut bounded, mut magnetised) = (None, None);
    if let Some(coil) = &setup.coil {
        let inductance = match (&windings, coil.steel, coil.method) {
            (Some(windings), Some(steel), _) if cfg!(feature = "steel") => {
                magnetised.insert(Magnetised::of(steel, windings)).inductances.clone()
            }
            (Some(windings), _, Method::Exact) => coil.sum.series(windings),
            (Some(windings), _, Method::Within(share)) => {
                values(coil.sum.series_within(windings, share)?, &mut bounded)
            }
            (None, _, Method::Within(share)) => values(coil.sum.along(&motion, times, share)?, &mut bounded),
            (None, _, Method::Exact) => values(coil.sum.along(&motion, times, 0.0)?, &mut bounded),
        };
        let force = InductanceSensor::new(setup.spring, coil.calibration).force(&inductance);
        signals.insert(Channel::InductanceForce, force)?;
        signals.insert(Channel::Inductance, inductance)?;
    }
    let other = |forces: Option<[Vec<f64>; 2]>| forces.map(|forces| seen_by(&signals, forces)).transpose();
    let seen = Seen { by_cells: other(read)?, with_blows: other(struck)? };
    Ok(Simulation { motion, signals, windings, bounded, magnetised, loads, seen, contacts })
}

/// A motion at all times.
struct Moved {
    motion: Motion,
    signals: Signals,
    windings: Option<Windings>,
    loads: Option<[EndLoads; 2]>,
    /// F_i and F_o as load cells out of line read them.
    read: Option<[Vec<f64>; 2]>,
    /// F_i and F_o with what seats got in an instant.
    struck: Option<[Vec<f64>; 2]>,
    contacts: Option<Contacts>,
}

fn moved(setup: &Setup<'_>, times: &[f64], with_windings: bool) -> Result<Moved, Error> {
    if let Some((helix, change)) = setup.helix {
        let helical::Moved { motion, signals, loads, read } =
            helix.simulate(change, setup.mount, setup.excitation, times)?;
        let windings = with_windings.then(|| motion.windings(times)).transpose()?;
        return Ok(Moved { motion, signals, windings, loads: Some(loads), read, struck: None, contacts: None });
    }
    let motion = Motion::mounted(setup.spring, setup.mount, setup.excitation)?;
    let Some(meets) = setup.contact else {
        let signals = motion.signals(times)?;
        let windings = with_windings.then(|| motion.windings(times)).transpose()?;
        return Ok(Moved { motion, signals, windings, loads: None, read: None, struck: None, contacts: None });
    };
    MEET?;
    // Without the windings L would be that of the motion without contact.
    let with_windings = with_windings || setup.coil.is_some();
    let touching = match meets.apart {
        Some(_) => Touching::of(&motion, meets.contact, times, with_windings)?,
        None => Touching::once(&motion, meets.contact, times, with_windings)?,
    };
    reached(&touching, times)?;
    let masses = [setup.spring.chain_masses(), setup.spring.masses_per_winding()];
    let contacts = Contacts::of(&touching, masses, times[times.len() - 1], meets.apart)?;
    let Touching { signals, windings, .. } = touching;
    let struck = struck(&signals, &contacts)?;
    Ok(Moved { motion, signals, windings, loads: None, read: None, struck, contacts: Some(contacts) })
}

/// That windings were followed to the last of the times.
fn reached(touching: &Touching, times: &[f64]) -> Result<(), Error> {
    let Some(course) = &touching.course else { return Ok(()) };
    let Some(why) = course.given_up else { return Ok(()) };
    let why = match why {
        GivenUp::Solid => "then all windings lie on one another between ends that go on closing".to_owned(),
        GivenUp::TooManyEvents => format!("by then {} things had met or parted: a stack that chatters", course.events),
    };
    Err(Error::Value {
        field: None,
        quantity: "time up to which windings that meet could be followed".into(),
        value: course.until,
        unit: "s",
        allowed: format!("at least the {} s that are asked for ({why})", times[times.len() - 1]).into(),
    })
}

/// F_i and F_o with what their seats got in an instant, spread over the sample in which it came: what a sensor shows that is slower than the
/// samples. `None` where no seat was struck.
fn struck(signals: &Signals, contacts: &Contacts) -> Result<Option<[Vec<f64>; 2]>, Error> {
    let times = signals.time();
    let mut forces = [signals.channel(Channel::InputForce)?.to_vec(), signals.channel(Channel::OutputForce)?.to_vec()];
    let mut is_struck = false;
    for (seat, force) in Between::SEATS.into_iter().zip(&mut forces) {
        for (time, impulse) in contacts.seat_impulses(seat) {
            let sample = times.partition_point(|known| *known < time);
            if sample == 0 || sample == times.len() {
                continue;
            }
            is_struck = true;
            force[sample] -= impulse / (times[sample] - times[sample - 1]);
        }
    }
    Ok(is_struck.then_some(forces))
}

/// Signals with another F_i and F_o.
fn seen_by(signals: &Signals, [input, output]: [Vec<f64>; 2]) -> Result<Signals, Error> {
    let mut seen = signals.clone();
    seen.insert(Channel::InputForce, input)?;
    seen.insert(Channel::OutputForce, output)?;
    Ok(seen)
}

/// L of a series, which is kept with its bounds.
fn values(series: BoundedSeries, kept: &mut Option<BoundedSeries>) -> Vec<f64> {
    let values = series.samples.iter().map(|sample| sample.inductance).collect();
    *kept = Some(series);
    values
}
