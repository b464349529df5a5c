//! Inductance by two libraries: `cfsem`'s flux of a circular filament, and eq. (8) as printed with K and E of `ellip`.

use std::path::Path;

use cfsem::physics::circular_filament::{flux_circular_filament, vector_potential_circular_filament_scalar};

use crate::jobs::{Inductance, Mutual, doubles};
use crate::measure::{Bench, Label};

const MU_0: f64 = 4.0e-7 * std::f64::consts::PI;

/// Eq. (8) with `ellip`; its K and E take m = κ².
fn by_ellip(radius: f64, distance: f64) -> f64 {
    let m = 4.0 * radius * radius / (4.0 * radius * radius + distance * distance);
    let kappa = m.sqrt();
    let (k, e) = (ellip::ellipk(m), ellip::ellipe(m));
    let (k, e) = (k.unwrap_or(f64::NAN), e.unwrap_or(f64::NAN));
    -MU_0 * radius * ((kappa - 2.0 / kappa) * k + 2.0 / kappa * e)
}

/// `cfsem`: the flux 2πr A through one ring of one ampere in the other, scaled from its μ₀ to ours.
fn by_cfsem(radius: f64, distance: f64) -> f64 {
    const SCALE: f64 = MU_0 / cfsem::MU_0 * 2.0 * std::f64::consts::PI;
    SCALE * radius * vector_potential_circular_filament_scalar((radius, 0.0, 1.0), (radius, distance))
}

/// Eq. (8) after a Landen step, which leaves no cancellation, with `ellip`'s R_D:
/// M = 2 μ₀ r y³ R_D(0, c, 1)/3, S = √(4r² + h²), y = 2r/(S + h), c = 4hS/(S + h)².
fn by_carlson(radius: f64, distance: f64) -> f64 {
    let s = (4.0 * radius * radius + distance * distance).sqrt();
    let inverse = 1.0 / (s + distance);
    let y = 2.0 * radius * inverse;
    let c = 4.0 * distance * s * inverse * inverse;
    2.0 / 3.0 * MU_0 * radius * y * y * y * ellip::elliprd(0.0, c, 1.0).unwrap_or(f64::NAN)
}

const CFSEM: &str = "circular filament, scalar";
const CFSEM_SLICES: &str = "circular filament, slices";
const ELLIP: &str = "eq. 8 as printed";
const CARLSON: &str = "elliprd, no cancellation";

pub fn inductance(folder: &Path, job: &Inductance, bench: &mut Bench) -> anyhow::Result<()> {
    let windings = job.spring.windings;
    let positions = doubles(folder, &job.positions, job.steps * windings)?;
    let reference = doubles(folder, &job.reference, job.steps.div_ceil(job.reference_stride))?;
    let judge = |values: &Vec<f64>| relative_error(values, &reference, job.reference_stride);
    let label = |system, setting| Label { job: &job.job, system, setting };
    let radius = job.spring.coil_radius;
    let size = (windings, 2);
    // Generic over the kernel, so that the compiler can put it into the loop.
    let cfsem = || Ok(series(&positions, windings, job.self_distance, |h| by_cfsem(radius, h)));
    bench.row(label("cfsem", CFSEM), size, cfsem, judge, "sum over pairs i < j by hand");
    let ellip = || Ok(series(&positions, windings, job.self_distance, |h| by_ellip(radius, h)));
    bench.row(label("ellip", ELLIP), size, ellip, judge, "sum over pairs i < j by hand");
    let carlson = || Ok(series(&positions, windings, job.self_distance, |h| by_carlson(radius, h)));
    bench.row(label("ellip", CARLSON), size, carlson, judge, "sum over pairs i < j by hand");
    Ok(())
}

/// L \[H\] of every row by Maxwell's sum.
fn series(positions: &[f64], windings: usize, self_distance: f64, mutual: impl Fn(f64) -> f64) -> Vec<f64> {
    let own = windings as f64 * mutual(self_distance);
    let of_row = |row: &[f64]| {
        let pairs = (0..windings).flat_map(|i| row[i + 1..].iter().map(move |x| x - row[i]));
        own + 2.0 * pairs.map(&mutual).sum::<f64>()
    };
    positions.chunks_exact(windings).map(of_row).collect()
}

pub fn mutual(folder: &Path, job: &Mutual, bench: &mut Bench) -> anyhow::Result<()> {
    let distances = doubles(folder, &job.distances, job.count)?;
    let mut reference = doubles(folder, &job.reference, job.count.div_ceil(job.reference_stride))?;
    let radius = job.coil_radius;
    reference.iter_mut().for_each(|value| *value *= MU_0 * radius);
    let judge = |values: &Vec<f64>| relative_error(values, &reference, job.reference_stride);
    let label = |system, setting| Label { job: &job.job, system, setting };
    let size = (job.count, 1);
    let cfsem = || Ok(distances.iter().map(|h| by_cfsem(radius, *h)).collect());
    bench.row(label("cfsem", CFSEM), size, cfsem, judge, "");
    let slices = || flux_of_slices(radius, &distances);
    bench.row(label("cfsem", CFSEM_SLICES), size, slices, judge, "");
    let ellip = || Ok(distances.iter().map(|h| by_ellip(radius, *h)).collect());
    bench.row(label("ellip", ELLIP), size, ellip, judge, "");
    let carlson = || Ok(distances.iter().map(|h| by_carlson(radius, *h)).collect());
    bench.row(label("ellip", CARLSON), size, carlson, judge, "");
    Ok(())
}

/// `cfsem`'s own call for many points: one ring of one ampere, the flux through all the others.
fn flux_of_slices(radius: f64, distances: &[f64]) -> anyhow::Result<Vec<f64>> {
    let radii = vec![radius; distances.len()];
    let mut flux = vec![0.0; distances.len()];
    flux_circular_filament((&[radius], &[0.0], &[1.0]), &[0.0], (&radii, distances), &mut flux)
        .map_err(anyhow::Error::msg)?;
    flux.iter_mut().for_each(|value| *value *= MU_0 / cfsem::MU_0);
    Ok(flux)
}

/// max |value/reference − 1| over every `stride`-th value.
fn relative_error(values: &[f64], reference: &[f64], stride: usize) -> f64 {
    let errors = values.iter().step_by(stride).zip(reference);
    errors.fold(0.0, |worst, (value, truth)| {
        let error = (value / truth - 1.0).abs();
        // Not f64::max, which would let a NaN pass.
        if error <= worst { worst } else { error }
    })
}
