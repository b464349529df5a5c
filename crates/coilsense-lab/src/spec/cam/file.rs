//! A cam from a file: lift over angle, row by row.
//!
//! Next door: by a law (the parent), as harmonics (`harmonics`).

use std::f64::consts::TAU;

use super::{CamSpec, Rows};
use crate::quantity::{Dimension, digits};
use crate::spec::heading;
use crate::spec::section::Section;
use crate::spec::spline::{periodic_spline, shifted};
use crate::spec::{Files, SpecError};

/// Most rows of a file.
const MOST_ROWS: usize = 100_000;
/// Share of the lift by which a base circle may lie below zero: rounding, and noise of a measured one.
const BELOW: f64 = 0.02;

/// Rows of a turn \[1\] and a lift \[m\], and what the last digit of a lift is worth \[m\], zero where it is not told.
fn read(file: &str, text: &str) -> Result<(Vec<(f64, f64)>, f64), String> {
    let mut rows: Vec<(f64, f64)> = Vec::new();
    let (mut radian, mut metre) = (1f64.to_radians(), 1e-3);
    let mut decimals = Some(0);
    for (number, line) in (1..).zip(text.lines()) {
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let mut cells = line.split([',', ';', '\t']).map(str::trim);
        let (angle, lift) = (cells.next().unwrap_or_default(), cells.next().unwrap_or_default());
        match (angle.parse::<f64>().ok(), lift.parse::<f64>().ok()) {
            (Some(angle), Some(value)) => {
                rows.push((angle * radian / TAU, value * metre));
                decimals = decimals.zip(decimals_of(lift)).map(|(most, own)| most.max(own));
            }
            // A heading, which says the units where they are others.
            _ if rows.is_empty() => {
                let of = |title, dimension: Dimension, usual| {
                    let Some(unit) = heading::unit(title) else { return Ok(usual) };
                    heading::scale(unit, dimension).ok_or_else(|| {
                        format!("{file}:{number}: the unit {unit:?} must be one of {}", dimension.symbols())
                    })
                };
                (radian, metre) = (of(angle, Dimension::Angle, radian)?, of(lift, Dimension::Length, metre)?);
            }
            _ => return Err(format!("{file}:{number}: must be an angle in degrees and a lift in millimetres")),
        }
    }
    if !(8..=MOST_ROWS).contains(&rows.len()) {
        return Err(format!("must hold 8 to {MOST_ROWS} rows of angle and lift, got {}", rows.len()));
    }
    Ok((rows, decimals.map_or(0.0, |decimals| 10f64.powi(-decimals) * metre)))
}

/// Lift over angle from a file: a smooth curve that comes back to where it began.
pub(super) fn of_file(section: &Section<'_>, file: &str, files: &Files<'_>, length: f64) -> Result<CamSpec, SpecError> {
    let refuse = |why: String| section.refuse("file", why);
    let text = files(file).map_err(refuse)?;
    let (rows, digit) = read(file, &text).map_err(refuse)?;
    if let Some(wrong) = rows.windows(2).find(|pair| pair[1].0 <= pair[0].0) {
        return Err(refuse(format!("angles must rise, got {} after {} deg", 360.0 * wrong[1].0, 360.0 * wrong[0].0)));
    }
    let (first, last) = (rows[0], rows[rows.len() - 1]);
    if first.0 < 0.0 || last.0 > 1.0 + 1e-9 || rows.iter().any(|row| !row.1.is_finite()) {
        return Err(refuse("angles must be from 0 to 360 deg, and lifts finite".to_owned()));
    }
    let lift = rows.iter().map(|row| row.1).fold(f64::NEG_INFINITY, f64::max);
    let least = rows.iter().map(|row| row.1).fold(f64::INFINITY, f64::min);
    if least < -BELOW * lift.abs().max(-least) {
        return Err(refuse(format!(
            "lifts must be zero or above, got {} mm: a lift presses the spring from its length on the base circle",
            digits(1e3 * least)
        )));
    }
    let apart = (first.1 - last.1).abs();
    if apart > 1e-3 * (lift - least) {
        return Err(refuse(format!(
            "must end where it begins, got lifts of {} and {} mm",
            1e3 * first.1,
            1e3 * last.1
        )));
    }
    let mut begins: Vec<f64> = rows.iter().map(|row| row.0).collect();
    let mut lifts: Vec<f64> = rows.iter().map(|row| row.1).collect();
    // The turn goes on where it began.
    if last.0 > 1.0 - 1e-9 {
        begins.pop();
        lifts.pop();
    }
    let fine = fine(&rows, digit);
    let words = format!("lift of {file}, {} mm", digits(1e3 * (lift - least)));
    let mut pieces = periodic_spline(&begins, &lifts);
    // On the base circle already, else at its lowest row.
    let lowest = (0..lifts.len()).min_by(|a, b| lifts[*a].total_cmp(&lifts[*b])).unwrap_or(0);
    let is_low = begins[0] == 0.0 && lifts[0] - least <= 1e-9 * (lift - least);
    let least_at = if is_low { 0.0 } else { begins[lowest] };
    if begins[0] > 0.0 {
        // What lies before the first row is the end of the last piece.
        let count = begins.len();
        let before = shifted(&pieces[count - 1], 1.0 - begins[count - 1]);
        begins.insert(0, 0.0);
        pieces.insert(0, before);
    }
    Ok(CamSpec { begins, pieces, lift, length, least_at, words, rows: Some(fine) })
}

/// Decimals that a number is written with, without zeros behind; `None` of one with an exponent.
fn decimals_of(text: &str) -> Option<i32> {
    if text.contains(['e', 'E']) {
        return None;
    }
    Some(text.split_once('.').map_or(0, |(_, decimals)| decimals.trim_end_matches('0').len() as i32))
}

/// Share of the lift above which the cam lifts.
const LIFTS: f64 = 0.01;

fn fine(rows: &[(f64, f64)], digit: f64) -> Rows {
    let least = rows.iter().map(|row| row.1).fold(f64::INFINITY, f64::min);
    let most = rows.iter().map(|row| row.1).fold(f64::NEG_INFINITY, f64::max);
    let lifts = |row: &(f64, f64)| row.1 - least > LIFTS * (most - least);
    let steps = rows.windows(2).filter(|pair| pair.iter().any(lifts)).map(|pair| pair[1].0 - pair[0].0);
    let bends = rows.windows(3).filter(|three| lifts(&three[1])).map(|three| {
        let slope = |from: usize| (three[from + 1].1 - three[from].1) / (three[from + 1].0 - three[from].0);
        2.0 * (slope(1) - slope(0)) / (three[2].0 - three[0].0)
    });
    let (sum, count) = bends.fold((0.0, 0), |(sum, count), bend| (sum + bend * bend, count + 1));
    Rows { step: steps.fold(0.0, f64::max), digit, bend: (sum / f64::from(count.max(1))).sqrt() }
}
