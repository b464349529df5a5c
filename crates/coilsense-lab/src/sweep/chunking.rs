//! How many rows a chunk has, and so how many files a sweep.
//!
//! Next door: the plan that is cut so (`plan`).

use super::SweepError;
use super::column::Needs;
use crate::message::{Hint, Message};

/// Most rows of a chunk, all of which lie in memory.
const MOST_ROWS: u64 = 1_000_000;
/// Most files of a folder: one more makes each look at it slower.
const MOST_CHUNKS: u64 = 100_000;

/// Rows of a chunk: as many as are asked for, else seconds of one core's work, or more where the folder would have too many files.
pub(super) fn rows_of_chunk(asked: Option<u64>, needs: &Needs, rows: u64) -> Result<u64, SweepError> {
    let least = rows.div_ceil(MOST_CHUNKS);
    let Some(asked) = asked else { return Ok(usual(needs).max(least)) };
    if !(1..=MOST_ROWS).contains(&asked) {
        return Err(SweepError::new(format!("a chunk must have from 1 to {MOST_ROWS} rows, got {asked}")));
    }
    if asked < least {
        let chunks = rows.div_ceil(asked);
        let message =
            format!("{rows} rows in chunks of {asked} are {chunks} files, at most {MOST_CHUNKS} are taken; give ");
        let chunk = Hint::Option("chunk", "");
        return Err(SweepError::new(
            Message::from(message) + chunk + format!(" from {least} to {MOST_ROWS}, or leave it out"),
        ));
    }
    Ok(asked)
}

fn usual(needs: &Needs) -> u64 {
    match needs {
        Needs { sensors, .. } if !sensors.is_empty() => 64,
        Needs { pitch: true, .. } => 512,
        Needs { forces: [.., true], .. } => 1024,
        _ => 8192,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chunk_is_what_is_asked_for_or_as_large_as_keeps_files_few() {
        let needs = Needs::default();
        assert_eq!(rows_of_chunk(None, &needs, 5).unwrap(), 8192);
        assert_eq!(rows_of_chunk(None, &needs, 1_000_000_000).unwrap(), 10_000);
        assert_eq!(rows_of_chunk(Some(10_000), &needs, 1_000_000_000).unwrap(), 10_000);
        assert_eq!(rows_of_chunk(Some(1), &needs, 100_000).unwrap(), 1);
        let refused = |asked, rows| rows_of_chunk(Some(asked), &needs, rows).unwrap_err().to_string();
        assert!(refused(0, 1).contains("from 1 to 1000000 rows, got 0"));
        assert!(refused(1_000_001, 1).contains("got 1000001"));
        assert_eq!(
            refused(1, 1_000_000_000),
            "1000000000 rows in chunks of 1 are 1000000000 files, at most 100000 are taken; give --chunk from 10000 to 1000000, or leave it out"
        );
    }
}
