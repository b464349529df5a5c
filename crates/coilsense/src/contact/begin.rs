//! The state in which a chain takes over from a motion.
//!
//! Next door: the motion up to there and the chain from there on (`touching`), the state of rest (`at_rest`).

use super::chain::Chain;
use super::drive::Drive;
use super::law::Contact;
use super::meet::MARGIN;
use super::start::Start;
use crate::error::{Error, check};
use crate::excitation;
use crate::motion::Motion;
use crate::mount::FarEnd;

/// Where the masses of the unloaded spring are \[m\], end 1 at zero.
pub(super) fn unloaded(motion: &Motion) -> Vec<f64> {
    let (modes, rest) = (motion.modes(), motion.spring().rest_length());
    (1..=modes.masses()).map(|mass| rest * modes.place_at(mass) + modes.offset_at(mass)).collect()
}

/// The motion's state at a time, by a factor larger about its mean.
pub(super) fn start(
    motion: &Motion,
    contact: &Contact,
    chain: &Chain,
    drives: &[Drive; 2],
    (time, larger): (f64, f64),
) -> Result<Start, Error> {
    let spring = motion.spring();
    let stretch = motion.excitation().mean_length() - spring.rest_length();
    let windings = motion.windings(&[time])?;
    let about = |mass: usize| stretch * motion.modes().place_at(mass + 1);
    let beside = windings.row(0).iter().zip(unloaded(motion)).map(|(position, unloaded)| position - unloaded);
    let mut places: Vec<f64> =
        beside.enumerate().map(|(mass, place)| about(mass) + larger * (place - about(mass))).collect();
    let mut speeds = motion.velocities(time)?;
    if let FarEnd::Mass(_) = motion.mount().far_end() {
        let [_, u2] = windings.ends(0);
        places.push(stretch + larger * (u2 - spring.rest_length() - stretch));
        speeds.push(motion.end_velocity(time));
    }
    if time == 0.0 && spring.sections().is_some() && overlaps(chain, &places, drives) {
        places = closed(motion, contact, chain, drives)?;
    }
    speeds.iter_mut().for_each(|speed| *speed *= larger);
    if chain.base() > 0 {
        // On the cam, and as fast.
        let cam = drives[0].series(time, 1.0);
        places.insert(0, cam[0]);
        speeds.insert(0, cam[1]);
    }
    Ok(Start { time, places, speeds })
}

/// Whether pairs of the spring overlap where its lumps are at `places` \[m\] and its ends as they are driven: its windings close at rest.
fn overlaps(chain: &Chain, places: &[f64], drives: &[Drive; 2]) -> bool {
    let base = chain.base();
    let ends = [0, 1].map(|end| drives[end].series(0.0, 1.0)[0]);
    let place = |point: usize| match point - base {
        0 => ends[0],
        number => places.get(number - 1).copied().unwrap_or(ends[1]),
    };
    chain.pairs()[base..].iter().any(|pair| place(pair.second) - place(pair.first) + pair.gap < -MARGIN)
}

/// Where the lumps of the spring are at rest with what is closed there: between its ends as they are driven, or at the mean length.
///
/// # Errors
/// [`Error::Value`] for a motion that begins in a steady state or with windings of its own, which no one knows of windings that are closed.
fn closed(motion: &Motion, contact: &Contact, chain: &Chain, drives: &[Drive; 2]) -> Result<Vec<f64>, Error> {
    let stretch = motion.excitation().mean_length() - motion.spring().rest_length();
    let at_mean = [0.0, stretch];
    let ends = match motion.excitation().start() {
        excitation::Start::Massless if !chain.is_open() => [0, 1].map(|end| drives[end].series(0.0, 1.0)[0]),
        excitation::Start::Massless | excitation::Start::Rest | excitation::Start::Moving { .. } => at_mean,
        excitation::Start::Steady | excitation::Start::Windings { .. } => {
            let allowed = "one from rest, or as a spring without mass: windings are closed at the mean length, and no steady state of \
                           theirs is known";
            check(false, "start", 0.0, "s", allowed)?;
            at_mean
        }
    };
    let places = chain.at_rest(contact, ends)?;
    // A follower is put on its cam by who asked.
    Ok(places[chain.base()..].to_vec())
}
