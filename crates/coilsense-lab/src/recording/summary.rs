//! A column at a glance, row by row in little memory: its range, its mean, how often it changes, its course.
//!
//! Next door: all columns (`overview`).

/// What the values of a column are like.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Summary {
    /// How many values there are.
    pub count: u64,
    /// Rows without one.
    pub missing: u64,
    /// How many values differ from the one before.
    pub changes: u64,
    /// The smallest and the largest; `None` without values.
    pub range: Option<[f64; 2]>,
    mean: f64,
    last: Option<f64>,
    /// Smallest and largest value of so many rows each.
    bins: Vec<[f64; 2]>,
    per_bin: u64,
    filled: u64,
}

/// Most bins that are kept; two become one where they do not suffice.
const MOST_BINS: usize = 1024;
/// Heights of a sparkline.
const HEIGHTS: [char; 8] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];
/// A value that is not there.
const NOTHING: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

impl Summary {
    /// Takes the next row's value; NaN where there is none.
    pub fn push(&mut self, value: f64) {
        if self.bins.is_empty() || self.filled == self.per_bin {
            self.next_bin();
        }
        self.filled += 1;
        if value.is_nan() {
            self.missing += 1;
            return;
        }
        self.count += 1;
        self.changes += u64::from(self.last.replace(value).is_some_and(|last| last != value));
        self.mean += (value - self.mean) / self.count as f64;
        let [least, most] = self.range.unwrap_or([value; 2]);
        self.range = Some([least.min(value), most.max(value)]);
        if let Some([least, most]) = self.bins.last_mut() {
            (*least, *most) = (least.min(value), most.max(value));
        }
    }

    fn next_bin(&mut self) {
        self.per_bin = self.per_bin.max(1);
        if self.bins.len() == MOST_BINS {
            let both =
                |pair: &[[f64; 2]]| pair.iter().fold(NOTHING, |all, bin| [all[0].min(bin[0]), all[1].max(bin[1])]);
            self.bins = self.bins.chunks(2).map(both).collect();
            self.per_bin *= 2;
        }
        self.bins.push(NOTHING);
        self.filled = 0;
    }

    /// The mean; `None` without values.
    pub fn mean(&self) -> Option<f64> {
        let [least, most] = self.range?;
        // What is left of a mean of zero is rounding.
        Some(if self.mean.abs() < 1e-12 * least.abs().max(most.abs()) { 0.0 } else { self.mean })
    }

    /// Its course in so many signs at most: the middle of what each stands for, between the smallest and the largest value.
    pub fn sparkline(&self, width: usize) -> String {
        let Some([least, most]) = self.range.filter(|[least, most]| (most - least).is_finite()) else {
            return String::new();
        };
        let each = self.bins.len().div_ceil(width.max(1)).max(1);
        let sign = |bins: &[[f64; 2]]| {
            let [low, high] = bins.iter().fold(NOTHING, |all, bin| [all[0].min(bin[0]), all[1].max(bin[1])]);
            if low > high {
                return ' ';
            }
            let share = if most > least { (0.5 * (low + high) - least) / (most - least) } else { 0.5 };
            HEIGHTS[((share * HEIGHTS.len() as f64) as usize).min(HEIGHTS.len() - 1)]
        };
        self.bins.chunks(each).map(sign).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Summary;

    #[test]
    fn a_column_at_a_glance_is_its_range_mean_and_course() {
        let mut summary = Summary::default();
        (0..100_000).for_each(|row| summary.push(f64::from(row / 10)));
        assert_eq!((summary.count, summary.missing, summary.changes), (100_000, 0, 9_999));
        assert_eq!(summary.range, Some([0.0, 9_999.0]));
        assert!((summary.mean().unwrap() - 4999.5).abs() < 1e-6);
        let line = summary.sparkline(8);
        assert_eq!(line, "▁▂▃▄▅▆▇█");
    }

    #[test]
    fn nothing_one_value_and_gaps_have_a_course_too() {
        assert_eq!((Summary::default().sparkline(8), Summary::default().mean()), (String::new(), None));
        let mut one = Summary::default();
        one.push(7.0);
        assert_eq!((one.sparkline(8).as_str(), one.mean()), ("▅", Some(7.0)));
        let mut gap = Summary::default();
        [1.0, f64::NAN, 3.0].into_iter().for_each(|value| gap.push(value));
        assert_eq!((gap.sparkline(8).as_str(), gap.missing), ("▁ █", 1));
    }
}
