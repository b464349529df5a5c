//! The golden files, and the log that all of them hold.

use std::path::{Path, PathBuf};

use coilsense::Channel;
use coilsense_lab::recording::{Cleaning, Mapping, Recording};

use super::fixtures::mapping;

pub fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/logs").join(name)
}

pub fn read(name: &str, mapping: &Mapping, cleaning: &Cleaning) -> Result<Recording, String> {
    Recording::read(&path(name), mapping, cleaning).map_err(|error| error.to_string())
}

/// The log as text, 17 digits a number.
pub fn text() -> Recording {
    read("motion.csv", &mapping(&["F_i=counts [N]", "F_x=converted [mN]"]), &Cleaning::default()).unwrap()
}

/// Time and channels of a file are those of the text, bit by bit.
#[track_caller]
pub fn same(found: &Recording, channels: &[Channel]) {
    let text = text();
    assert_eq!(found.signals().time(), text.signals().time());
    for &channel in channels {
        assert_eq!(found.channel(channel).unwrap(), text.channel(channel).unwrap(), "{channel:?}");
    }
    assert_eq!((found.account().read, found.account().rows, found.account().left_out()), (50, 50, 0));
}
