//! The jobs of the benchmark, as `bench/README.md` describes them.

use std::path::Path;

use coilsense::excitation::Sampled;
use coilsense::{EndInput, Excitation, Spring, SpringParameters, Start, VelocityProfile};
use serde::Deserialize;

use crate::Failure;

/// A job and the file with its reference values.
#[derive(Deserialize)]
pub struct Job {
    #[serde(rename = "job")]
    pub name: String,
    #[serde(flatten)]
    pub kind: Kind,
    spring: Option<JobSpring>,
    pub reference: String,
}

#[derive(Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Kind {
    Motion { mean_length: f64, u1: Input, start: Lines, rate: f64, samples: usize },
    Inductance { steps: usize, positions: String, reference_stride: usize },
    Mutual { coil_radius: f64, distances: String, reference_stride: usize },
}

#[derive(Deserialize)]
struct JobSpring {
    rest_length: f64,
    windings: f64,
    mass: f64,
    stiffness: f64,
    coil_radius: f64,
    wire_radius: f64,
}

#[derive(Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Input {
    Held,
    Harmonic { amplitude: f64, frequency: f64, phase: f64 },
    Sampled { file: String },
}

/// Positions and velocities of the windings at t = 0, straight lines between two values.
#[derive(Deserialize)]
pub struct Lines {
    position: [f64; 2],
    velocity: [f64; 2],
}

impl Job {
    pub fn read_all(folder: &Path) -> Result<Vec<Self>, Failure> {
        let path = folder.join("jobs.json");
        let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        Ok(serde_json::from_str(&text)?)
    }

    pub fn spring(&self) -> Result<Spring, Failure> {
        let spring = self.spring.as_ref().ok_or("a job without a spring")?;
        Ok(Spring::new(SpringParameters {
            rest_length: spring.rest_length,
            windings: spring.windings,
            coil_radius: spring.coil_radius,
            wire_radius: spring.wire_radius,
            mass: spring.mass,
            stiffness: spring.stiffness,
            // S_T's operating range; the jobs do not depend on it.
            min_length: 0.196,
            max_length: 0.264,
            nominal_force: None,
            inductance_windings: None,
            sections: None,
        })?)
    }

    pub fn rate(&self) -> f64 {
        match self.kind {
            Kind::Motion { rate, .. } => rate,
            _ => 1.0,
        }
    }

    pub fn times(&self) -> Vec<f64> {
        match self.kind {
            Kind::Motion { rate, samples, .. } => (0..samples).map(|sample| sample as f64 / rate).collect(),
            _ => Vec::new(),
        }
    }

    pub fn excitation(&self, folder: &Path) -> Result<Excitation, Failure> {
        let Kind::Motion { mean_length, u1, start, .. } = &self.kind else {
            return Err("not a motion job".into());
        };
        let input = match u1 {
            Input::Held => EndInput::Held,
            Input::Harmonic { amplitude, frequency, phase } => EndInput::harmonic(*amplitude, *frequency, *phase),
            Input::Sampled { file } => EndInput::Sampled(Sampled::new(self.times(), doubles(&folder.join(file))?)?),
        };
        let start = match (start.position, start.velocity) {
            ([0.0, end], [0.0, velocity]) if end == *mean_length => {
                Start::Moving { velocity, profile: VelocityProfile::Linear }
            }
            ([0.0, end], [first, second]) if end == *mean_length && first == second => {
                Start::Moving { velocity: first, profile: VelocityProfile::Uniform }
            }
            ([first, end], [0.0, 0.0]) if end == *mean_length && first == input.displacement(0.0) => Start::Massless,
            _ => return Err("a start that is none of coilsense's straight ones".into()),
        };
        Ok(Excitation::new(*mean_length, input, EndInput::Held, start)?)
    }
}

/// A file of raw little-endian doubles.
pub fn doubles(path: &Path) -> Result<Vec<f64>, Failure> {
    let bytes = std::fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(bytes.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect())
}
