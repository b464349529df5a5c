//! diffsol: Tsitouras' explicit 5(4) method, and the implicit BDF with a sparse factorisation.

use diffsol::{
    DefaultDenseMatrix, DenseMatrix, DiffsolError, FaerSparseLU, FaerSparseMat, Matrix, MatrixCommon, NalgebraMat,
    OdeBuilder, OdeEquations, OdeEquationsImplicit, OdeSolverMethod, OdeSolverProblem,
};

use crate::chain::MotionJob;
use crate::measure::{Bench, Label};

const SYSTEM: &str = "diffsol";

/// The problem of a job with matrices of type `M`.
fn problem<M>(
    job: &MotionJob,
    rtol: f64,
) -> Result<OdeSolverProblem<impl OdeEquationsImplicit<M = M, V = M::V, T = f64, C = M::C>>, DiffsolError>
where
    M: Matrix<T = f64>,
{
    OdeBuilder::<M>::new()
        .rtol(rtol)
        .atol([rtol * 1e-3])
        .rhs_implicit(
            |x: &[f64], _: &[f64], t: f64, y: &mut [f64]| job.rates(t, x, y),
            |_: &[f64], _: &[f64], _: f64, v: &[f64], y: &mut [f64]| job.jacobian_times(v, y),
        )
        .init(|_: &[f64], _: f64, y: &mut [f64]| job.start_state(y), 2 * job.windings)
        .out_implicit(
            |x: &[f64], _: &[f64], t: f64, y: &mut [f64]| y.copy_from_slice(&job.end_forces(t, x)),
            |_: &[f64], _: &[f64], _: f64, _: &[f64], y: &mut [f64]| y.fill(0.0),
            2,
        )
        .build()
}

pub fn run(job: &MotionJob, bench: &mut Bench) {
    let label = |setting| Label { job: &job.name, system: SYSTEM, setting };
    // Explicit steps go as N and the work of one as N; BDF's steps and factorisations the same at a fixed tolerance.
    let size = (job.windings, 2);
    let judge = |forces: &[Vec<f64>; 2]| job.error(forces);
    bench.row(label("tsit45, rtol 1e-9"), size, || tsit45(job, 1e-9), judge, "");
    bench.row(label("bdf, rtol 1e-6"), size, || bdf(job, 1e-6), judge, "sparse LU (faer)");
}

fn tsit45(job: &MotionJob, rtol: f64) -> anyhow::Result<[Vec<f64>; 2]> {
    let problem = problem::<NalgebraMat<f64>>(job, rtol)?;
    Ok(forces(problem.tsit45()?, job)?)
}

fn bdf(job: &MotionJob, rtol: f64) -> anyhow::Result<[Vec<f64>; 2]> {
    let problem = problem::<FaerSparseMat<f64>>(job, rtol)?;
    Ok(forces(problem.bdf::<FaerSparseLU<f64>>()?, job)?)
}

fn forces<'a, Eqn, S>(mut solver: S, job: &MotionJob) -> Result<[Vec<f64>; 2], DiffsolError>
where
    Eqn: OdeEquations<T = f64> + 'a,
    Eqn::V: DefaultDenseMatrix,
    S: OdeSolverMethod<'a, Eqn>,
{
    let (outputs, _) = solver.solve_dense(&job.times)?;
    let row = |index: usize| (0..outputs.ncols()).map(|sample| outputs.get_index(index, sample)).collect();
    Ok([row(0), row(1)])
}
