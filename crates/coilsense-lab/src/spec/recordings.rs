//! Recorded files that many designs share: each is read and parsed once, whichever design asks first.
//!
//! Next door: what is in one (`recorded`).

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use coilsense::FarEnd;

use super::Files;
use super::recorded::Recorded;

/// What a file says, or why it cannot be read.
type Read = Arc<OnceLock<Result<Recorded, String>>>;

/// Recorded files by name, and by whether end 2 has a position in them or a force.
#[derive(Debug, Default)]
pub struct Recordings {
    known: Mutex<BTreeMap<(String, bool), Read>>,
}

impl Recordings {
    /// A file by the name that a spec has for it.
    pub(super) fn of(&self, name: &str, far_end: FarEnd, files: &Files<'_>) -> Result<Recorded, String> {
        let key = (name.to_owned(), far_end == FarEnd::Position);
        // A thread that panicked while it held the lock left the map whole.
        let read = Arc::clone(self.known.lock().unwrap_or_else(PoisonError::into_inner).entry(key).or_default());
        // Others who want the same file wait for it; those who want another one do not.
        read.get_or_init(|| Recorded::parse(&files(name)?, far_end)).clone()
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use coilsense::FarEnd;

    use super::Recordings;

    #[test]
    fn a_file_is_read_once_for_each_thing_that_end_2_can_be() {
        let reads = Cell::new(0);
        let files = |name: &str| {
            reads.set(reads.get() + 1);
            match name {
                "motion.csv" => Ok("time [s],u1 [mm]\n0,0\n0.5,2\n".to_owned()),
                _ => Err(format!("{name} is not there")),
            }
        };
        let recordings = Recordings::default();
        for _ in 0..3 {
            let recorded = recordings.of("motion.csv", FarEnd::Position, &files).unwrap();
            assert_eq!((recorded.duration(), recorded.shortest), (0.5, -0.002));
            assert_eq!(recordings.of("other.csv", FarEnd::Position, &files).unwrap_err(), "other.csv is not there");
        }
        assert_eq!(reads.get(), 2);
        // Under a prescribed force a column u2 would be another thing, so the file is parsed for itself.
        recordings.of("motion.csv", FarEnd::Force, &files).unwrap();
        assert_eq!(reads.get(), 3);
    }
}
