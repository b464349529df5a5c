//! Follows a chain from event to event: who may ask, and what for.
//!
//! Next door: the run itself (`run`), one step of it (`series`).

use super::chain::Chain;
use super::course::Course;
use super::damper::Damper;
use super::drive::Drive;
use super::law::{Contact, Law};
use super::run::Run;
use super::series::System;
use super::start::{Start, Watch};
use crate::damping::Damping;
use crate::error::{Error, all_bounded, check, count, finite};

/// Follows a chain and tells what it does at `times` \[s\], ascending, none before its start.
///
/// m_i ÿ_i = k_i (y_(i+1) − y_i) − k_(i−1) (y_i − y_(i−1)) + damping + λ_(c) − λ_(c+1), 0 ≤ λ ⟂ gap ≥ 0, gap = y_2 − y_1 + g; where points meet
/// a Newton impulse, v⁺ = −e v⁻
///
/// - `drives`: the displacement of end 1 and, counted from where end 2 of the unloaded spring is, that of end 2 \[m\]; where end 2 is under a
///   force or has a mass, the force \[N\]
///
/// Source:   Taylor series of the linear chain between events; impulses and forces as linear complementarity problems.
/// Valid:    what meets are points; friction, rolling and the shock inside a wire are left out. No value of e for windings was found.
/// Accuracy: energy adds up to 1e-10 of what moves; what follows from a motion that a small change turns round is only good in its mean squares.
///
/// # Errors
/// [`Error::Count`] for a start of other than N lumps; [`Error::Value`] for times before the start or out of order, numbers that are not
/// finite, a pair that overlaps at the start, and for damping by ratios, which asks for modes.
pub fn follow(
    chain: &Chain,
    contact: &Contact,
    damping: &Damping,
    drives: [Drive; 2],
    start: &Start,
    times: &[f64],
) -> Result<Course, Error> {
    follow_damped(chain, contact, &Damper::without_modes(damping)?, &drives, start, times, Watch::Forces)
}

/// The same where damping may need the chain's modes.
pub(super) fn follow_damped(
    chain: &Chain,
    contact: &Contact,
    damper: &Damper,
    drives: &[Drive; 2],
    start: &Start,
    times: &[f64],
    watch: Watch,
) -> Result<Course, Error> {
    crate::signals::increasing(times)?;
    finite("time", start.time, "s")?;
    if let Some(&first) = times.first() {
        check(first >= start.time, "time[0]", first, "s", format!("from the start at {} s on", start.time))?;
    }
    count("places", start.places.len(), chain.lumps())?;
    count("speeds", start.speeds.len(), chain.lumps())?;
    all_bounded("places", &start.places, "m")?;
    all_bounded("speeds", &start.speeds, "m/s")?;
    let system = System { chain, damper, drives, elastic: elastic(chain, contact) };
    let mut run = Run::new(&system, contact, start, times, watch);
    run.check_start()?;
    let given_up = run.follow().err();
    Ok(run.finish(given_up))
}

/// Stiffness and dashpots of windings that give way.
fn elastic(chain: &Chain, contact: &Contact) -> Option<(f64, Vec<f64>)> {
    let Law::Elastic { stiffness, damping_ratio } = contact.law() else { return None };
    let inverse = chain.inverse_masses();
    let dashpot = |mass: f64| 2.0 * damping_ratio * (stiffness * mass).sqrt();
    let each = chain.pairs().iter().map(|pair| dashpot(1.0 / (inverse[pair.first] + inverse[pair.second])));
    Some((stiffness, each.collect()))
}
