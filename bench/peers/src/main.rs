//! The Rust peers of coilsense's benchmark: `peers FOLDER [--only WORD]`. The contract is in `bench/README.md`.

mod chain;
mod diffsol_peer;
mod dop853;
mod jobs;
mod measure;
mod rings;

use std::path::PathBuf;

use anyhow::{Context, bail};

use jobs::Job;
use measure::Bench;

fn main() -> anyhow::Result<()> {
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(arguments.next().context("usage: peers FOLDER [--only WORD]")?);
    let only = match (arguments.next().as_deref(), arguments.next()) {
        (None, None) => None,
        (Some("--only"), Some(word)) => Some(word),
        _ => bail!("usage: peers FOLDER [--only WORD]"),
    };
    let mut bench = Bench::new(only);
    for job in jobs::read(&folder)? {
        match job {
            Job::Motion(job) => {
                let motion = chain::MotionJob::read(&folder, job)?;
                diffsol_peer::run(&motion, &mut bench);
                dop853::run(&motion, &mut bench);
            }
            Job::Inductance(job) => rings::inductance(&folder, &job, &mut bench)?,
            Job::Mutual(job) => rings::mutual(&folder, &job, &mut bench)?,
        }
    }
    Ok(())
}
