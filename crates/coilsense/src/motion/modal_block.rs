//! The modal coordinates of many samples at once, block by block.
//!
//! Next door: blocks of equidistant samples (`stretch`), where they put the windings (`placing`), end forces, which need no
//! coordinates (`phasor_sum`).

use aligned_vec::{AVec, avec};

use super::closed::ModalState;
use super::forces::is_equidistant;
use super::modal_rows::{WIDTH, row_of};
use super::stretch::Stretch;
use super::{Motion, check_times, in_order, step_of};
use crate::error::Error;

/// Some samples' modal coordinates.
pub(super) struct ModalBlock<'a> {
    /// The samples' numbers, at most [`WIDTH`].
    pub samples: &'a [usize],
    /// q_j, shape `count × WIDTH`: modes 1, 3, 5 … first, then modes 2, 4, 6 … (see [`row_of`]).
    pub coordinates: &'a [f64],
}

impl Motion {
    /// Calls `visit` with all samples of `times`, in blocks. Equidistant times come in order, those that a march visits in the order of time.
    pub(super) fn for_each_block(&self, times: &[f64], mut visit: impl FnMut(ModalBlock<'_>)) -> Result<(), Error> {
        if let Some(closed) = self.closed.as_ref().filter(|_| is_equidistant(times)) {
            for (segment, samples) in closed.stretches(times) {
                let mut stretch = Stretch::new(closed, segment, step_of(times));
                for begin in samples.clone().step_by(WIDTH) {
                    stretch.begin(times[begin]);
                    let ids: Vec<usize> = (begin..samples.end.min(begin + WIDTH)).collect();
                    visit(ModalBlock { samples: &ids, coordinates: &stretch.coordinates });
                }
            }
            return Ok(());
        }
        check_times(times)?;
        let mut gathered = Gathered::new(self.modes.count());
        if let Some(closed) = &self.closed {
            let mut state = ModalState::zero(self.modes.count());
            for (sample, &time) in times.iter().enumerate() {
                closed.state_into(time, &mut state);
                gathered.push(sample, &state.coordinates, &mut visit);
            }
        } else {
            let mut march = self.march(step_of(times));
            for sample in in_order(times) {
                march.advance_to(times[sample]);
                gathered.push(sample, march.coordinates(), &mut visit);
            }
        }
        gathered.flush(&mut visit);
        Ok(())
    }
}

/// Samples that come one by one, gathered to blocks.
struct Gathered {
    modes: usize,
    samples: Vec<usize>,
    coordinates: AVec<f64>,
}

impl Gathered {
    fn new(modes: usize) -> Self {
        Self { modes, samples: Vec::with_capacity(WIDTH), coordinates: avec![0.0; modes * WIDTH] }
    }

    fn push(&mut self, sample: usize, coordinates: &[f64], visit: &mut impl FnMut(ModalBlock<'_>)) {
        let column = self.samples.len();
        for (mode, value) in coordinates.iter().enumerate() {
            self.coordinates[row_of(mode, self.modes) * WIDTH + column] = *value;
        }
        self.samples.push(sample);
        if self.samples.len() == WIDTH {
            self.flush(visit);
        }
    }

    fn flush(&mut self, visit: &mut impl FnMut(ModalBlock<'_>)) {
        if !self.samples.is_empty() {
            visit(ModalBlock { samples: &self.samples, coordinates: &self.coordinates });
            self.samples.clear();
        }
    }
}
