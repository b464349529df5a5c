//! The modal coordinates followed from time to time: any input, constant memory.
//!
//! Next door: the closed solution, where there is one (`closed`), the vector kernel of one step (`stride`).

use std::sync::Arc;

use super::closed::ModalState;
use super::oscillator::Oscillator;
use super::stride::{Stride, Sums};
use crate::excitation::{EndInput, Kick};
use crate::modes::ModalModel;
use crate::quadrature::GAUSS_12;
use crate::simd::dispatch;

/// Largest angle that a mode and a drive may run through within one panel of [`GAUSS_12`]: the rule is then exact to
/// 1e-16, as its error term (n!)⁴ x²ⁿ / ((2n+1) (2n)!³) says for n = 12, x = 8.
const PANEL_ANGLE: f64 = 8.0;

/// State and settings of a march.
#[derive(Debug, Clone)]
pub(super) struct March {
    /// Shared by copies.
    oscillators: Arc<[Oscillator]>,
    stride: Stride,
    /// Jumps still to come, the next one last.
    kicks: Vec<(usize, Kick)>,
    inputs: [EndInput; 2],
    /// Largest angular frequency, or rate of decay, of modes and drives together \[rad/s\]; zero where no input is curved between its jumps.
    curved: f64,
    time: f64,
    /// The step that most steps are meant to have; what differs from it by the rounding of times only is taken for it …
    nominal: f64,
    /// … and the difference is made up for in the next step, so that it never adds up.
    lag: f64,
    transition: Option<Transition>,
}

/// What a step of one length does.
#[derive(Debug, Clone)]
struct Transition {
    step: f64,
    /// For each Gauss point: its place in the step, its weight, and what a unit kick there leaves of q and q̇ per mode.
    nodes: Vec<Node>,
}

#[derive(Debug, Clone)]
struct Node {
    place: f64,
    weight: f64,
    coordinates: Vec<f64>,
    rates: Vec<f64>,
}

impl March {
    pub(super) fn new(
        modes: &ModalModel,
        ratios: &[f64],
        start: ModalState,
        inputs: [&EndInput; 2],
        nominal: f64,
    ) -> Self {
        let each = modes.frequencies().iter().zip(ratios);
        let oscillators: Arc<[Oscillator]> = each.map(|(&natural, &ratio)| Oscillator { natural, ratio }).collect();
        let mut kicks = EndInput::kicks_of_both(inputs);
        kicks.reverse();
        let fastest_mode = oscillators.iter().fold(0.0, |fastest: f64, mode| fastest.max(mode.fastest()));
        let highest_drive = inputs.iter().fold(0.0, |a: f64, input| a.max(input.highest_angular()));
        Self {
            oscillators,
            stride: Stride::new(modes, start),
            kicks,
            // Straight inputs are all in their kicks.
            inputs: if highest_drive > 0.0 { inputs.map(Clone::clone) } else { [EndInput::Held, EndInput::Held] },
            curved: if highest_drive > 0.0 { fastest_mode + highest_drive } else { 0.0 },
            time: 0.0,
            nominal,
            lag: 0.0,
            transition: None,
        }
    }

    /// Goes on to a time, not before the present one.
    pub(super) fn advance_to(&mut self, time: f64) {
        while let Some(&(end, kick)) = self.kicks.last().filter(|(_, kick)| kick.time <= time) {
            self.kicks.pop();
            self.move_by(kick.time - self.time);
            self.time = kick.time;
            self.jump(end, kick.displacement);
            self.kick(end, kick.velocity);
        }
        self.move_by(time - self.time);
        self.time = time;
    }

    /// A jump of an input's rate now.
    pub(super) fn kick(&mut self, end: usize, velocity: f64) {
        self.stride.kick(end, velocity);
    }

    /// A jump of an input now: the windings stay, the straight line jumps under them, and damping gives each mode its impulse.
    fn jump(&mut self, end: usize, displacement: f64) {
        if displacement != 0.0 {
            let impulses: Vec<f64> = self.oscillators.iter().map(|mode| -mode.impulse()).collect();
            self.stride.push(end, displacement, &vec![1.0; impulses.len()], &impulses);
        }
    }

    /// Moves by a step in which no input jumps.
    pub(super) fn move_by(&mut self, step: f64) {
        let wanted = step + self.lag;
        let rounding = f64::EPSILON * (self.time + step);
        let step = match wanted {
            wanted if wanted <= rounding => 0.0,
            wanted if (wanted - self.nominal).abs() <= rounding => self.nominal,
            wanted => wanted,
        };
        self.lag = wanted - step;
        if step == 0.0 {
            return;
        }
        let panels = (self.curved * step / PANEL_ANGLE).ceil().max(1.0);
        let panel = step / panels;
        self.prepare(panel);
        for index in 0..panels as usize {
            dispatch(&mut self.stride);
            if self.curved > 0.0 {
                self.push_inputs(self.time + index as f64 * panel);
            }
        }
    }

    /// Σ a_j q_j, Σ b_j q_j and the same of q̇.
    pub(super) fn sums(&mut self) -> Sums {
        self.stride.sums()
    }

    /// q_j, shape `count`.
    pub(super) fn coordinates(&self) -> &[f64] {
        self.stride.coordinates()
    }

    /// q_j and q̇_j now.
    pub(super) fn state(&self) -> ModalState {
        self.stride.state()
    }

    /// q_j and q̇_j at a sample, shape `count` each; what no step has taken up yet is not in them.
    pub(super) fn at_sample(&self) -> [&[f64]; 2] {
        self.stride.at_sample()
    }

    /// Goes on from q_j and q̇_j, shape `count` each.
    pub(super) fn begin_at(&mut self, coordinates: &[f64], rates: &[f64]) {
        self.stride.begin_at(coordinates, rates);
    }

    /// What the inputs' accelerations within a panel that begins at `from` leave at its end.
    fn push_inputs(&mut self, from: f64) {
        let Some(transition) = &self.transition else {
            return;
        };
        for node in &transition.nodes {
            let time = from + node.place;
            for (end, input) in self.inputs.iter().enumerate() {
                let kick = node.weight * input.acceleration(time);
                if kick != 0.0 {
                    self.stride.push(end, kick, &node.coordinates, &node.rates);
                }
            }
        }
    }

    /// Finds the transition of a step, unless it is that of the step before.
    pub(super) fn prepare(&mut self, step: f64) {
        if self.transition.as_ref().is_some_and(|transition| transition.step == step) {
            return;
        }
        let step_of = |oscillator: &Oscillator| oscillator.increment(step);
        self.stride.set(self.oscillators.iter().map(step_of));
        let both = GAUSS_12.into_iter().flat_map(|(x, weight)| [(x, weight), (-x, weight)]);
        let node = |(x, weight): (f64, f64)| {
            let place = 0.5 * step * (1.0 + x);
            let left: Vec<[f64; 4]> = self.oscillators.iter().map(|mode| mode.increment(step - place)).collect();
            let coordinates = left.iter().map(|row| row[1]).collect();
            let rates = left.iter().map(|row| 1.0 + row[3]).collect();
            Node { place, weight: 0.5 * step * weight, coordinates, rates }
        };
        let nodes = if self.curved > 0.0 { both.map(node).collect() } else { Vec::new() };
        self.transition = Some(Transition { step, nodes });
    }
}
