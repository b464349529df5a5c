//! A few of many points, drawn by lot: which ones, the rows' numbers decide, not their order.
//!
//! Next door: who draws them (`study`).

use std::collections::BTreeSet;

use crate::sweep::mixed;

/// Most points that are kept.
const MOST: usize = 2500;

/// Points with the lowest lots.
#[derive(Debug, Clone, Default)]
pub(super) struct Cloud {
    lots: BTreeSet<(u64, u64)>,
    points: std::collections::BTreeMap<u64, Vec<f64>>,
}

impl Cloud {
    /// Takes a point, or not.
    pub fn offer(&mut self, row: u64, point: &[f64]) {
        let lot = (mixed(row), row);
        if self.lots.len() >= MOST && self.lots.last().is_some_and(|last| *last < lot) {
            return;
        }
        self.lots.insert(lot);
        self.points.insert(row, point.to_vec());
        if self.lots.len() > MOST
            && let Some((_, row)) = self.lots.pop_last()
        {
            self.points.remove(&row);
        }
    }

    /// The points, by their rows.
    pub fn points(self) -> Vec<Vec<f64>> {
        self.points.into_values().collect()
    }
}
