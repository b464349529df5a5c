//! The table `[cam]`: lift over the angle of a camshaft, by a law, from a file or as harmonics.
//!
//! Next door: how it turns (`crate::speed`).

mod file;
mod harmonics;

use std::f64::consts::{PI, TAU};

use super::document::Document;
use super::section::Section;
use super::spline::shifted;
use super::spring::SpringSpec;
use super::{Files, SpecError};
use crate::quantity::Dimension;

/// Lift over one turn of a camshaft, as polynomials of the turn.
#[derive(Debug, Clone, PartialEq)]
pub struct CamSpec {
    /// Where pieces begin, as shares of a turn, from 0 to below 1, ascending.
    pub begins: Vec<f64>,
    /// Of each piece the powers of the share of a turn since it began \[m\].
    pub pieces: Vec<Vec<f64>>,
    /// The largest lift \[m\].
    pub lift: f64,
    /// Where the lift is least, as a share of a turn: runs begin there.
    pub least_at: f64,
    /// Length of the spring on the base circle \[m\].
    pub length: f64,
    /// In words.
    pub words: String,
    /// How fine a file is.
    pub rows: Option<Rows>,
}

/// How fine the rows of a file are in which the lift changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rows {
    /// The largest step from row to row, as a share of a turn \[1\].
    pub step: f64,
    /// What the last digit of a lift is worth \[m\]; zero where it is not told.
    pub digit: f64,
    /// Rms of the lift's second derivative by the turn, from row to row \[m\].
    pub bend: f64,
}

/// What describes a cam in place of a law: the key that says so, and what it is then.
const KINDS: [(&str, &str); 2] = [("file", "a cam of a file"), ("harmonics", "a cam of harmonics")];
/// Pieces by which sines are made of polynomials, for each flank: a span of π/32 leaves out 1e-16 of them.
const PIECES: usize = 32;

impl CamSpec {
    /// The table, where there is one.
    pub(super) fn parse(
        document: &Document<'_>,
        spring: &SpringSpec,
        files: &Files<'_>,
    ) -> Result<Option<Self>, SpecError> {
        let Some(section) = document.optional_section("cam")? else { return Ok(None) };
        if !cfg!(feature = "contact") {
            let key = KINDS.into_iter().find(|(key, _)| section.has(key)).map_or("law", |(key, _)| key);
            return Err(section.refuse(key, "is not read in this build; cams are for `coilsense speed`"));
        }
        let (kind, whose) = KINDS.into_iter().find(|(key, _)| section.has(key)).unwrap_or(("law", "a cam by a law"));
        section.only_of(kind, whose)?;
        let length = length(&section, spring)?;
        let (found, key) = match kind {
            "file" => (file::of_file(&section, &section.text("file")?, files, length)?, "file"),
            "harmonics" => (harmonics::of_harmonics(&section, length)?, "harmonics"),
            _ => (by_law(&section, length)?, "lift"),
        };
        let shortest = spring.solid_length();
        let allowed = format!("below {:.4} mm, at which the spring is solid", 1e3 * (length - shortest));
        section.check(key, found.lift < length - shortest, found.lift, &allowed)?;
        Ok(Some(found))
    }

    /// One turn from where the lift is least: where pieces begin, from 0 on, and the powers of each.
    pub(crate) fn begun_at_least(&self) -> (Vec<f64>, Vec<Vec<f64>>) {
        if self.least_at == 0.0 {
            return (self.begins.clone(), self.pieces.clone());
        }
        let first = self.begins.partition_point(|begin| *begin <= self.least_at).max(1) - 1;
        let since = self.least_at - self.begins[first];
        let count = self.begins.len();
        let mut begins = vec![0.0];
        let mut pieces = vec![shifted(&self.pieces[first], since)];
        for next in (1..count).map(|step| (first + step) % count) {
            begins.push((self.begins[next] - self.least_at).rem_euclid(1.0));
            pieces.push(self.pieces[next].clone());
        }
        // What is left of the piece that was cut.
        if since > 0.0 {
            begins.push(1.0 - since);
            pieces.push(self.pieces[first].clone());
        }
        (begins, pieces)
    }

    /// Lift \[m\] at a share of a turn.
    pub fn lift_at(&self, turn: f64) -> f64 {
        let turn = turn.rem_euclid(1.0);
        let piece = self.begins.partition_point(|begin| *begin <= turn).max(1) - 1;
        let since = turn - self.begins[piece];
        self.pieces[piece].iter().rev().fold(0.0, |sum, coefficient| sum * since + coefficient)
    }
}

fn length(section: &Section<'_>, spring: &SpringSpec) -> Result<f64, SpecError> {
    let (min, max) = spring.spring.operating_range();
    let word = section.optional_text("length").ok().flatten();
    let length = match word.as_deref() {
        _ if !section.has("length") => max,
        Some("max") => max,
        Some("min") => min,
        Some("mid") => 0.5 * (min + max),
        _ => section.quantity("length", Dimension::Length)?,
    };
    let allowed = format!("from {} to {} mm, the range in use", 1e3 * min, 1e3 * max);
    section.check("length", (min - 1e-9..=max + 1e-9).contains(&length), length, &allowed)
}

fn by_law(section: &Section<'_>, length: f64) -> Result<CamSpec, SpecError> {
    let laws = ["3-4-5-6", "3-4-5", "4-5-6-7", "cycloid", "harmonic"];
    let law = section.optional_word("law", &laws)?.unwrap_or(laws[0]);
    let lift = section.positive("lift", Dimension::Length)?;
    let angle = section.positive("angle", Dimension::Angle)?;
    section.check("angle", angle < TAU * (1.0 - 1e-6), angle, "below 360 deg")?;
    let open = angle / TAU;
    let from = 0.5 - 0.5 * open;
    // Powers of the share of a flank, or of the whole event, up to the nose; and back by the same from the other side.
    let flank = |rise: &[f64]| -> Vec<(f64, f64, Vec<f64>)> {
        let half = 0.5 * open;
        let up = rise.iter().map(|coefficient| lift * coefficient).collect();
        // s(1 − x) by powers of x.
        let mut down = vec![0.0; rise.len()];
        for (power, coefficient) in rise.iter().enumerate() {
            let mut binomial = 1.0;
            for (below, down) in down[..=power].iter_mut().enumerate() {
                let sign = if below % 2 == 0 { 1.0 } else { -1.0 };
                *down += lift * coefficient * binomial * sign;
                binomial *= (power - below) as f64 / (below + 1) as f64;
            }
        }
        vec![(from, half, up), (from + half, half, down)]
    };
    let events: Vec<(f64, f64, Vec<f64>)> = match law {
        "3-4-5" => flank(&[0.0, 0.0, 0.0, 10.0, -15.0, 6.0]),
        "4-5-6-7" => flank(&[0.0, 0.0, 0.0, 0.0, 35.0, -84.0, 70.0, -20.0]),
        "cycloid" | "harmonic" => sines(law == "cycloid", from, open, lift),
        _ => vec![(from, open, [0.0, 0.0, 0.0, 64.0, -192.0, 192.0, -64.0].map(|c| lift * c).to_vec())],
    };
    let mut begins = vec![0.0];
    let mut pieces = vec![vec![0.0]];
    for (begin, span, powers) in events {
        begins.push(begin);
        pieces.push(powers.iter().enumerate().map(|(power, c)| c / span.powi(power as i32)).collect());
    }
    begins.push(from + open);
    pieces.push(vec![0.0]);
    let words = format!("{law} law, {} mm over {} deg", 1e3 * lift, (angle.to_degrees() * 1e6).round() / 1e6);
    Ok(CamSpec { begins, pieces, lift, length, least_at: 0.0, words, rows: None })
}

/// A cycloid or a harmonic law, piece by piece of its Taylor series.
fn sines(is_cycloid: bool, from: f64, open: f64, lift: f64) -> Vec<(f64, f64, Vec<f64>)> {
    let half = 0.5 * open;
    let span = half / PIECES as f64;
    // Derivatives of the rise by the share of the flank.
    let derivative = |order: usize, x: f64| -> f64 {
        let angular = if is_cycloid { TAU } else { PI };
        let turned = angular * x + 0.5 * PI * order as f64;
        let power = angular.powi(order as i32);
        match (is_cycloid, order) {
            (true, 0) => x - (TAU * x).sin() / TAU,
            (true, 1) => 1.0 - (TAU * x).cos(),
            (true, _) => -power * turned.sin() / TAU,
            (false, 0) => 0.5 * (1.0 - (PI * x).cos()),
            (false, _) => -0.5 * power * turned.cos(),
        }
    };
    let piece = |index: usize| {
        let is_rise = index < PIECES;
        let x = if is_rise { index as f64 / PIECES as f64 } else { 2.0 - index as f64 / PIECES as f64 };
        let direction: f64 = if is_rise { 1.0 } else { -1.0 };
        let mut factorial = 1.0;
        let powers = (0..=8).map(|order| {
            factorial *= (order as f64).max(1.0);
            lift * direction.powi(order) * derivative(order as usize, x) / factorial / (PIECES as f64).powi(order)
        });
        (from + index as f64 * span, span, powers.collect())
    };
    (0..2 * PIECES).map(piece).collect()
}
