//! `jobs.json` and the raw files beside it, as they are. Next door: what a chain does with a motion job (`chain`).

use std::path::Path;

use anyhow::Context;
use serde::Deserialize;

#[derive(Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Job {
    Motion(Motion),
    Inductance(Inductance),
    Mutual(Mutual),
}

#[derive(Deserialize)]
pub struct Spring {
    pub rest_length: f64,
    pub windings: usize,
    pub mass: f64,
    pub stiffness: f64,
    pub coil_radius: f64,
}

#[derive(Deserialize)]
pub struct Motion {
    pub job: String,
    pub spring: Spring,
    pub mean_length: f64,
    pub u1: Drive,
    pub start: Start,
    pub rate: f64,
    pub samples: usize,
    pub reference: String,
}

#[derive(Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Drive {
    Held,
    Harmonic { amplitude: f64, frequency: f64, phase: f64 },
    Sampled { file: String },
}

/// Straight lines over the windings, by their values at both ends.
#[derive(Deserialize)]
pub struct Start {
    pub position: [f64; 2],
    pub velocity: [f64; 2],
}

#[derive(Deserialize)]
pub struct Inductance {
    pub job: String,
    pub spring: Spring,
    pub self_distance: f64,
    pub steps: usize,
    pub positions: String,
    pub reference: String,
    pub reference_stride: usize,
}

#[derive(Deserialize)]
pub struct Mutual {
    pub job: String,
    pub coil_radius: f64,
    pub count: usize,
    pub distances: String,
    pub reference: String,
    pub reference_stride: usize,
}

pub fn read(folder: &Path) -> anyhow::Result<Vec<Job>> {
    let path = folder.join("jobs.json");
    let text = std::fs::read_to_string(&path).with_context(|| format!("{} cannot be read", path.display()))?;
    serde_json::from_str(&text).with_context(|| format!("{} is not a list of jobs", path.display()))
}

/// All doubles of a raw file, of which there must be `count`.
pub fn doubles(folder: &Path, name: &str, count: usize) -> anyhow::Result<Vec<f64>> {
    let path = folder.join(name);
    let bytes = std::fs::read(&path).with_context(|| format!("{} cannot be read", path.display()))?;
    let (whole, rest) = bytes.as_chunks::<8>();
    anyhow::ensure!(
        rest.is_empty() && whole.len() == count,
        "{}: {} bytes where {count} doubles are due",
        path.display(),
        bytes.len()
    );
    Ok(whole.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect())
}
