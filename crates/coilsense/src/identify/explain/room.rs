//! What is heard, where lines can be, and how well a place on the scale of frequencies meets a line, against chance.
//!
//! Next door: what was heard of each line (`heard`), a law laid on the lines (`place`).

use super::heard::Heard;
use crate::identify::phase_law::Law;

/// Highest mode that is looked for.
pub(super) const HIGHEST: usize = 120;
/// Degrees of freedom of Student's t by which misfits are judged: a line that is off costs, and does not rule.
pub(super) const FREEDOM: f64 = 4.0;

/// What is heard, and where lines can be.
pub(super) struct Room<'a> {
    /// Lowest frequency first.
    pub(super) heard: &'a [Heard],
    /// Highest frequency that is looked at \[Hz\].
    pub(super) top: f64,
}

impl Room<'_> {
    /// ln of the density of lines per unit of ln f that have nothing to do with one another, at a frequency: as many as were heard, half of
    /// them spread evenly over ln f (five octaves and more), half over f.
    fn chance(&self, frequency: f64) -> f64 {
        let count = self.heard.len().max(2) as f64;
        (count * 0.5 * (1.0 / 5.0 + frequency / self.top)).ln()
    }

    /// ln (density of a line off its place by `off` under the law, over that by chance).
    pub(super) fn gain(&self, heard: &Heard, off: f64, spread: f64) -> f64 {
        let z = off / spread;
        let student = 0.375_f64.ln() - spread.ln() - 0.5 * (FREEDOM + 1.0) * (1.0 + z * z / FREEDOM).ln();
        student - self.chance(heard.frequency)
    }

    /// The line nearest to a place that is not taken, within four standard deviations; `strength`: what e-fold of energy counts against half a
    /// square of a standard deviation.
    pub(super) fn nearest(
        &self,
        place: f64,
        unsure: f64,
        off: f64,
        taken: &[(usize, usize)],
        strength: f64,
    ) -> Option<usize> {
        let variance = unsure * unsure + off * off;
        let reach = 4.0 * variance.sqrt() + 0.01;
        let from = self.heard.partition_point(|heard| heard.log < place - reach);
        let near = self.heard[from..].iter().take_while(|heard| heard.log < place + reach);
        let mut best: Option<(usize, f64)> = None;
        for (index, heard) in near.enumerate() {
            let z = (heard.log - place) / (variance + heard.spread * heard.spread).sqrt();
            let score = strength * heard.energy.max(f64::MIN_POSITIVE).ln() - 0.5 * z * z;
            let free = !taken.iter().any(|entry| entry.0 == from + index);
            if free && z.abs() < 4.0 && best.is_none_or(|(_, old)| score > old) {
                best = Some((from + index, score));
            }
        }
        best.map(|(index, _)| index)
    }

    /// ln of a law's multiples, as many as lie below the top for a base \[Hz\].
    pub(super) fn table(&self, law: Law, base: f64) -> Vec<f64> {
        let most = (self.top / base).ln();
        (1..=HIGHEST).map_while(|mode| law.multiple(mode).map(f64::ln)).take_while(|log| *log < most).collect()
    }

    /// How well multiples lie on the lines before anything is fitted: gains of the nearest lines less a share for what is not heard.
    pub(super) fn rough(&self, table: &[f64], base: f64, within: f64) -> f64 {
        let (log, top) = (base.ln(), self.top.ln());
        let mut from = 0;
        let mut sum = 0.0;
        for place in table.iter().map(|multiple| log + multiple).take_while(|place| *place < top) {
            while from < self.heard.len() && self.heard[from].log < place {
                from += 1;
            }
            let gain = |index: usize| {
                let heard = self.heard.get(index)?;
                let off = heard.log - place;
                (off.abs() < 8.0 * within + 4.0 * heard.spread)
                    .then(|| self.gain(heard, off, (within * within + heard.spread * heard.spread).sqrt()))
            };
            sum += gain(from).into_iter().chain(from.checked_sub(1).and_then(gain)).fold(-0.7, f64::max);
        }
        sum
    }
}
