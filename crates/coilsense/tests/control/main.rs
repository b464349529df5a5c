//! Force loops through the spring: where the sensor may sit, and how well the samples, the time run and the formulas agree.

#[path = "../paper_springs/mod.rs"]
mod paper_springs;

mod bad_input;
mod estimators;
mod laws;
mod over_time;
mod placement;
mod sampled;

use coilsense::control::{Controller, Drive, Environment, ForceLoop, Plant};
use coilsense::{Channel, Damping};
use paper_springs::s_t;

/// S_T with modal damping, far end held, and a velocity in proportion to the force error: integral force control.
fn integral_loop(ratio: f64, feedback: Channel, delay: f64) -> ForceLoop {
    let plant = Plant::new(&s_t(), Damping::Modal(ratio), Drive::IDEAL_VELOCITY, Environment::Held).unwrap();
    // Without the spring's mass the crossover is 1 rad/s, so that a factor on the gains is one.
    ForceLoop::new(plant, Controller::proportional(1.0 / s_t().stiffness()).unwrap(), feedback, delay).unwrap()
}
