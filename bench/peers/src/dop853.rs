//! `differential-equations`: Dormand and Prince's explicit method of order 8(5,3).

use differential_equations::prelude::*;

use crate::chain::MotionJob;
use crate::measure::{Bench, Label};

impl ODE<f64, Vec<f64>> for MotionJob {
    fn diff(&self, t: f64, y: &Vec<f64>, rate: &mut Vec<f64>) {
        self.rates(t, y, rate);
    }
}

pub fn run(job: &MotionJob, bench: &mut Bench) {
    let label = Label { job: &job.name, system: "differential-equations", setting: "dop853, rtol 1e-9" };
    // Steps as N, work per step as N.
    bench.row(label, (job.windings, 2), || solve(job, 1e-9), |forces| job.error(forces), "");
}

fn solve(job: &MotionJob, rtol: f64) -> anyhow::Result<[Vec<f64>; 2]> {
    let mut state = vec![0.0; 2 * job.windings];
    job.start_state(&mut state);
    let method = ExplicitRungeKutta::dop853().rtol(rtol).atol(rtol * 1e-3).max_steps(100_000_000);
    let solution = IVP::ode(job, 0.0, job.times[job.times.len() - 1], state)
        .t_eval(&job.times)
        .method(method)
        .solve()
        .map_err(|failure| anyhow::anyhow!("{failure:?}"))?;
    let mut forces = [Vec::new(), Vec::new()];
    for (t, y) in solution.iter() {
        let [first, last] = job.end_forces(*t, y);
        forces[0].push(first);
        forces[1].push(last);
    }
    Ok(forces)
}
