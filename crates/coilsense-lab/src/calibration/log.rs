//! Points from a log of any layout: positions and inductances, row by row.
//!
//! Next door: how a log is read (`crate::recording`), the layout of the measured runs (`lab_data`).

use coilsense::Channel;

use super::{CalibrationError, Measured};
use crate::message::{Hint, Message};
use crate::recording::Points;

impl Measured {
    /// Takes u1, u2 or both, and L, of a log.
    ///
    /// - `zero_length`: length of the coil where positions read zero \[m\]; without it u2 − u1 is the length itself
    ///
    /// # Errors
    /// [`CalibrationError`] where the log has no position or no L, or for fewer than two rows, lengths that are not above zero, or values that
    /// are all the same.
    pub fn of_log(log: &Points, zero_length: Option<f64>) -> Result<Self, CalibrationError> {
        let channel = |channel: Channel| log.channel(channel).map_err(CalibrationError::new);
        let displacements: Vec<f64> = match (log.channel(Channel::U1), log.channel(Channel::U2)) {
            (Ok(u1), Ok(u2)) => u2.iter().zip(u1).map(|(u2, u1)| u2 - u1).collect(),
            (Err(_), Ok(u2)) => u2.to_vec(),
            (_, Err(_)) => channel(Channel::U1)?.iter().map(|u1| -u1).collect(),
        };
        let lengths: Vec<f64> = displacements.iter().map(|x| zero_length.unwrap_or(0.0) + x).collect();
        let file = log.account().file.display().to_string();
        let inductances = channel(Channel::Inductance)?;
        if zero_length.is_none() && lengths.iter().any(|length| *length <= 0.0) {
            let message = Message::from("holds positions that are no lengths, as some are not above zero; ")
                + "give the length of the coil where they read zero ("
                + Hint::Open("length_at_zero")
                + ")";
            return Err(CalibrationError::of(&file, message));
        }
        let points = Self::pairs(&file, &lengths, inductances)?;
        let mut account: Vec<String> = log.account().lines().iter().map(|line| line.trim().to_owned()).collect();
        if zero_length.is_none() {
            account.push("Positions are taken as the length of the coil itself.".to_owned());
        }
        let rows = log.lines().iter().map(|&line| line as usize).collect();
        let simulated = log.simulated().is_some();
        Ok(Self {
            file,
            points,
            standard_errors: Vec::new(),
            resistances: log.channel(Channel::Resistance).map(<[f64]>::to_vec).unwrap_or_default(),
            unused: Vec::new(),
            rows,
            zero_length,
            account,
            simulated,
        })
    }
}
