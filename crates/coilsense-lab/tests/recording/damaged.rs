//! Binary files of instruments that are cut off anywhere, or some of whose bytes are wrong: read or refused in one line, soon, and no fall.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use coilsense_lab::recording::{Mapping, Table};
use rand::{RngExt, SeedableRng};

/// Wrong files of each good one.
const FLIPS: usize = 1000;

fn good(name: &str) -> Vec<u8> {
    std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/logs").join(name)).expect("a reference log")
}

fn survives(path: &PathBuf, bytes: &[u8], what: &str) {
    std::fs::write(path, bytes).expect("written");
    let begun = Instant::now();
    if let Err(error) = Table::read(path, &Mapping::default().format) {
        let message = error.to_string();
        assert!(!message.contains('\n') && message.len() < 1000, "{what}: {message}");
    }
    assert!(begun.elapsed() < Duration::from_secs(5), "{what}: {:?}", begun.elapsed());
}

fn no_harm(name: &str) {
    let good = good(name);
    let place = tempfile::tempdir().expect("a temporary folder");
    let path = place.path().join("run");
    for length in (0..good.len()).filter(|length| *length < 600 || length % 7 == 0) {
        survives(&path, &good[..length], &format!("{name} cut off after {length} bytes"));
    }
    let mut random = rand_pcg::Pcg64::seed_from_u64(26);
    for round in 0..FLIPS {
        let mut bytes = good.clone();
        for _ in 0..random.random_range(1..4) {
            // Every other one where sizes and types stand.
            let most = if random.random_bool(0.5) { bytes.len() } else { bytes.len().min(512) };
            let (place, value) = (random.random_range(0..most), random.random_range(0..=255_u8));
            bytes[place] = if random.random_bool(0.3) { 0xff } else { value };
        }
        survives(&path, &bytes, &format!("{name} with wrong bytes, round {round}"));
    }
}

#[cfg(feature = "tdms")]
#[test]
fn damaged_tdms_does_no_harm() {
    for name in ["motion.tdms", "motion-wave.tdms", "motion-card.tdms"] {
        no_harm(name);
    }
}

#[cfg(feature = "matlab")]
#[test]
fn damaged_matlab_does_no_harm() {
    for name in ["motion-v4.mat", "motion-struct.mat", "motion-v5.mat"] {
        no_harm(name);
    }
}

#[cfg(feature = "hdf5")]
#[test]
fn damaged_hdf5_does_no_harm() {
    for name in ["motion.h5", "motion-rows.h5", "motion-v73.mat"] {
        no_harm(name);
    }
}

#[cfg(feature = "mdf")]
#[test]
fn damaged_mdf_3_does_no_harm() {
    no_harm("motion.mdf");
}

#[cfg(feature = "mcap")]
#[test]
fn damaged_mcap_does_no_harm() {
    for name in ["motion.mcap", "motion-lz4.mcap"] {
        no_harm(name);
    }
}
