//! coilsense on the jobs of the benchmark: `cargo bench --bench jobs -- FOLDER` prints one JSON object per measurement.
//!
//! The jobs and what is measured are described in `bench/README.md`; `cargo xtask bench` runs this beside the peers.

mod contact;
mod helix;
mod job;
mod measure;

use std::path::Path;

use coilsense::inductance::{MaxwellSum, SelfDistance, mutual_inductances};
use coilsense::motion::Windings;
use coilsense::simd::SimdPath;
use coilsense::{Motion, Spring};
use job::{Job, Kind, doubles};
use measure::{Measurement, alternately, measure};

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    // Cargo adds `--bench`; without a folder (`cargo test --benches`) there is nothing to measure.
    let Some(folder) = std::env::args().skip(1).find(|argument| !argument.starts_with('-')) else {
        return Ok(());
    };
    let folder = Path::new(&folder);
    let path = SimdPath::selected()?.name();
    let jobs = Job::read_all(folder)?;
    for job in &jobs {
        let measurements = match &job.kind {
            Kind::Motion { .. } => motion(folder, job)?,
            Kind::Inductance { .. } => vec![inductance(folder, job)?],
            Kind::Mutual { .. } => vec![mutual(folder, job)?],
        };
        for measurement in measurements {
            println!("{}", measurement.json(&job.name, path)?);
        }
    }
    for measurement in streams(folder, &jobs)? {
        println!("{}", measurement.json("stream", path)?);
    }
    for measurement in helix::rows()? {
        println!("{}", measurement.json("helix", path)?);
    }
    for (job, measurement) in contact::rows()? {
        println!("{}", measurement.json(job, path)?);
    }
    Ok(())
}

/// A stream with held ends and one under a sine, turn by turn: what one takes over the other is then the same machine's answer.
fn streams(folder: &Path, jobs: &[Job]) -> Result<Vec<Measurement>, Failure> {
    let motion = |name: &str| -> Result<(Motion, f64), Failure> {
        let job = jobs.iter().find(|job| job.name == name).ok_or_else(|| format!("no job {name}"))?;
        Ok((Motion::new(&job.spring()?, &job.excitation(folder)?)?, 1.0 / job.rate()))
    };
    let motions = [motion("impact")?, motion("resonance")?];
    let stream = |(motion, step): &(Motion, f64)| -> Result<f64, coilsense::Error> {
        Ok(motion.stream(*step)?.take(10_001).map(|sample| sample.input + sample.output).sum())
    };
    let elapsed = alternately(|which| stream(&motions[which]))?;
    let settings = ["held ends", "a sine"];
    Ok(settings.into_iter().zip(elapsed).map(|(setting, elapsed)| Measurement::timed(setting, elapsed)).collect())
}

/// Both end forces at all samples: all together, and step by step.
fn motion(folder: &Path, job: &Job) -> Result<Vec<Measurement>, Failure> {
    let spring = job.spring()?;
    let excitation = job.excitation(folder)?;
    let times = job.times();
    let reference = doubles(&folder.join(&job.reference))?;
    let peak_of = |_: &Spring| -> Result<[Vec<f64>; 2], Failure> {
        let motion = Motion::new(&spring, &excitation)?;
        let ends = motion.ends(&times)?;
        let massless: Vec<f64> = ends.iter().map(|[u1, u2]| spring.static_force(u2 - u1)).collect();
        let (input, output) = reference.split_at(times.len());
        let departure = |forces: &[f64]| forces.iter().zip(&massless).map(|(force, x)| force - x).collect();
        Ok([departure(input), departure(output)])
    };
    let departures = peak_of(&spring)?;
    let error = |input: &[f64], output: &[f64]| -> f64 {
        let (of_input, of_output) = reference.split_at(times.len());
        let worse = |ours: &[f64], theirs: &[f64], departure: &[f64]| {
            let off = ours.iter().zip(theirs).fold(0.0_f64, |off, (a, b)| off.max((a - b).abs()));
            off / departure.iter().fold(0.0_f64, |peak, value| peak.max(value.abs()))
        };
        worse(input, of_input, &departures[0]).max(worse(output, of_output, &departures[1]))
    };
    let (together, forces) = measure(|| Motion::new(&spring, &excitation)?.end_forces(&times));
    let forces = forces?;
    let mut measurements = vec![Measurement::new("all times together", together, error(&forces.input, &forces.output))];
    // Step by step the highest mode needs its place in memory, not time: shown where it says something.
    if spring.chain_masses() <= 5000 {
        let (stepwise, samples) = measure(|| -> Result<Vec<_>, coilsense::Error> {
            Ok(Motion::new(&spring, &excitation)?.stream(1.0 / job.rate())?.take(times.len()).collect())
        });
        let samples = samples?;
        let force = |of: fn(&coilsense::motion::ForceSample) -> f64| samples.iter().map(of).collect::<Vec<f64>>();
        let error = error(&force(|sample| sample.input), &force(|sample| sample.output));
        measurements.push(Measurement::new("step by step", stepwise, error));
    }
    Ok(measurements)
}

/// L of every row of winding positions.
fn inductance(folder: &Path, job: &Job) -> Result<Measurement, Failure> {
    let Kind::Inductance { steps, positions, reference_stride } = &job.kind else {
        return Err("not an inductance job".into());
    };
    let spring = job.spring()?;
    let windings = Windings::new(vec![[0.0, spring.mid_length()]; *steps], doubles(&folder.join(positions))?)?;
    let reference = doubles(&folder.join(&job.reference))?;
    let (elapsed, inductances) = measure(|| Ok(MaxwellSum::new(&spring, SelfDistance::AsPrinted).series(&windings)));
    let inductances: Vec<f64> = inductances?.into_iter().step_by(*reference_stride).collect();
    Ok(Measurement::new("exact sum", elapsed, largest_relative(&inductances, &reference)))
}

/// M of two rings at many distances.
fn mutual(folder: &Path, job: &Job) -> Result<Measurement, Failure> {
    let Kind::Mutual { coil_radius, distances, reference_stride } = &job.kind else {
        return Err("not a mutual-inductance job".into());
    };
    let distances = doubles(&folder.join(distances))?;
    let reference = doubles(&folder.join(&job.reference))?;
    let (elapsed, inductances) = measure(|| {
        let mut inductances = vec![0.0; distances.len()];
        mutual_inductances(*coil_radius, &distances, &mut inductances)?;
        Ok(inductances)
    });
    let scale = coilsense::inductance::MU_0 * coil_radius;
    let reduced: Vec<f64> = inductances?.iter().step_by(*reference_stride).map(|m| m / scale).collect();
    Ok(Measurement::new("slices", elapsed, largest_relative(&reduced, &reference)))
}

fn largest_relative(ours: &[f64], theirs: &[f64]) -> f64 {
    assert_eq!(ours.len(), theirs.len(), "as many values as references");
    ours.iter().zip(theirs).fold(0.0, |worst, (ours, theirs)| worst.max((ours / theirs - 1.0).abs()))
}
