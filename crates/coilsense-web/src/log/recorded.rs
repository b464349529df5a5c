//! A log's channels over time, as they are drawn.
//!
//! Next door: where they come from (`coilsense_lab::recording`), what they say (`identified`).

use coilsense::Signals;

/// Most rows that are handed out as they are; of longer logs each group of rows gives its smallest and its largest value.
const MOST_ROWS: usize = 200_000;

/// `recorded time` and `recorded u1` … of every channel, and how many rows make a pair of points; 1 where each row is one point.
pub(super) fn curves(signals: &Signals) -> (Vec<(String, Vec<f64>)>, usize) {
    let time = signals.time();
    let group = if time.len() <= MOST_ROWS { 1 } else { (2 * time.len()).div_ceil(MOST_ROWS) };
    let name = |name: &str| format!("recorded {name}");
    let times = match group {
        1 => time.to_vec(),
        _ => time.chunks(group).flat_map(|rows| [rows[0], rows[rows.len() / 2]]).collect(),
    };
    let mut series = vec![(name("time"), times)];
    let envelope = |rows: &[f64]| {
        let extreme = |than: fn(f64, f64) -> bool| {
            (1..rows.len()).fold(0, |best, row| if than(rows[row], rows[best]) { row } else { best })
        };
        let (least, most) = (extreme(|a, b| a < b), extreme(|a, b| a > b));
        [rows[least.min(most)], rows[least.max(most)]]
    };
    series.extend(signals.channels().map(|(channel, values)| match group {
        1 => (name(channel.name()), values.to_vec()),
        _ => (name(channel.name()), values.chunks(group).flat_map(envelope).collect()),
    }));
    (series, group)
}

#[cfg(test)]
mod tests {
    use coilsense::{Channel, Signals};

    use super::{MOST_ROWS, curves};

    #[test]
    fn a_long_log_keeps_its_shortest_peaks() {
        let rows = 3 * MOST_ROWS;
        let mut signals = Signals::new((0..rows).map(|row| row as f64).collect()).unwrap();
        let mut force = vec![0.0; rows];
        (force[123_457], force[400_001]) = (5.0, -7.0);
        signals.insert(Channel::OutputForce, force).unwrap();
        let (series, group) = curves(&signals);
        let (time, force) = (&series[0].1, &series[1].1);
        assert!(group == 6 && time.len() == force.len() && time.len() <= MOST_ROWS);
        assert!(time.windows(2).all(|pair| pair[0] < pair[1]));
        let at = force.iter().position(|value| *value == 5.0).unwrap();
        // Within one group of where it was.
        assert!((time[at] - 123_457.0).abs() <= group as f64 && force.contains(&-7.0));
    }
}
