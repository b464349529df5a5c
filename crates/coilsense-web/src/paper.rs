//! Tables II and III and Figs. 2 and 4 of the paper, for the page's tab.
//!
//! Next door: how they are computed (`coilsense_lab::reproduce`).

use coilsense::{Channel, transmittance};
use coilsense_lab::condition::Condition;
use coilsense_lab::reproduce::{Cell, PaperSprings, Protocol, Reproduction, reproduce};
use serde_json::{Map, Value, json};

use crate::answer::Answer;

/// Part of the judged window that Fig. 4 shows \[s\], and its conditions.
const SHOWN: f64 = 0.9;
const FIGURE_4: [Condition; 3] = [Condition::HeelStrike, Condition::EndStopMax, Condition::Resonance];
/// Frequencies of Fig. 2 \[Hz\]: from 1 Hz on, in these steps.
const STEP: f64 = 0.2;
const LINES: u32 = 996;

/// Everything the paper simulates. Series: `figure 2 frequency`, `figure 2 chain`, `figure 2 continuous`; `S_T heel strike time`, `S_T heel
/// strike F_i` …
///
/// # Errors
/// One line: what the science says of the paper's springs.
pub fn run() -> Result<Answer, String> {
    let springs = PaperSprings::built_in().map_err(|error| error.to_string())?;
    let mut series = figure_2(&springs);
    let reproduction = reproduce(springs, &Protocol::ALL).map_err(|error| error.to_string())?;
    series.extend(figure_4(&reproduction));
    let meta = json!({
        "cells": reproduction.cells.iter().map(cell).collect::<Vec<_>>(),
        "warnings": reproduction.warnings(),
    });
    Ok(Answer::new(&meta, series))
}

/// A cell: printed, and by each protocol.
fn cell(cell: &Cell) -> Value {
    let (spring, condition, force) = cell.place();
    let computed: Map<String, Value> = cell
        .computed
        .iter()
        .map(|computed| {
            let value = json!({
                "percent": computed.percent,
                "differs": computed.differs_from(cell.published.percent),
                "samplingRange": computed.sampling_range.map(|(low, high)| [low, high]),
            });
            (computed.protocol.name().to_owned(), value)
        })
        .collect();
    json!({
        "table": cell.table().numeral(),
        "spring": spring,
        "condition": condition.name(),
        "force": force.name(),
        "printed": cell.published.percent,
        "computed": computed,
    })
}

fn figure_2(springs: &PaperSprings) -> Vec<(String, Vec<f64>)> {
    let spring = springs.first().1;
    let (masses, tau) = (spring.chain_masses(), spring.transit_time());
    let frequencies: Vec<f64> = (0..LINES).map(|line| 1.0 + STEP * f64::from(line)).collect();
    let over = |of: &dyn Fn(f64) -> f64| frequencies.iter().map(|f| of(std::f64::consts::TAU * f).abs()).collect();
    let chain = over(&|angular| transmittance::chain(masses, tau, angular));
    let continuous = over(&|angular| transmittance::continuous(tau, angular));
    vec![
        ("figure 2 frequency".to_owned(), frequencies),
        ("figure 2 chain".to_owned(), chain),
        ("figure 2 continuous".to_owned(), continuous),
    ]
}

fn figure_4(reproduction: &Reproduction) -> Vec<(String, Vec<f64>)> {
    let mut series = Vec::new();
    for (spring, _) in reproduction.springs.each() {
        for condition in FIGURE_4 {
            let Some(case) = reproduction.case(spring, condition) else { continue };
            let time = case.signals.time();
            let first = time.partition_point(|&t| t < SHOWN);
            let name = |what: &str| format!("{spring} {} {what}", condition.name());
            series.push((name("time"), time[first..].to_vec()));
            let of_force = |(channel, _): &(Channel, &[f64])| Channel::FORCES.contains(channel);
            for (channel, values) in case.signals.channels().filter(of_force) {
                series.push((name(channel.name()), values[first..].to_vec()));
            }
        }
    }
    series
}
