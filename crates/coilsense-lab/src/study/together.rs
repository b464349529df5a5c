//! Springs between the same ends: what all of them do to these, which is the sum of what each does.
//!
//! Next door: one spring (`simulation`), how springs stand beside one another (`crate::spec::Beside`).

use coilsense::{Channel, Error, Signals};

use crate::spec::Side;

/// Forces that add up.
pub const ADD_UP: [Channel; 3] = [Channel::InputForce, Channel::OutputForce, Channel::DeflectionForce];

/// u1 and u2 as the first of the springs has them, and F_i, F_o and F_x of all; one that pulls the other way counts below zero. Nothing acts from
/// spring to spring: their ends are where they are prescribed to be.
///
/// # Errors
/// [`Error::MissingSignal`] where one has not these forces; [`Error::Count`] where one has another number of samples.
pub fn together(each: &[(Side, &Signals)]) -> Result<Signals, Error> {
    let Some((_, first)) = each.first() else { return Err(Error::MissingSignal("of springs")) };
    let mut all = Signals::new(first.time().to_vec())?;
    for end in [Channel::U1, Channel::U2] {
        all.insert(end, first.channel(end)?.to_vec())?;
    }
    for force in ADD_UP {
        let mut sum = vec![0.0; first.time().len()];
        for (side, signals) in each {
            let own = signals.channel(force)?;
            if own.len() != sum.len() {
                let allowed = sum.len().to_string().into();
                return Err(Error::Count { field: None, quantity: force.name().into(), found: own.len(), allowed });
            }
            sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += side.sign() * own);
        }
        all.insert(force, sum)?;
    }
    Ok(all)
}
