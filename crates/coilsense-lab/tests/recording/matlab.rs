//! Files of MATLAB 4 to 7 by SciPy, and of 7.3 and HDF5 by h5py, compared to the last bit; and what only MATLAB reads.

use coilsense::Channel;
use coilsense_lab::recording::{Cleaning, Mapping, Recording};

use super::fixtures::mapping;
use super::golden::{path, read, same, text};

#[cfg(feature = "matlab")]
#[test]
fn matlab_of_scipy_plain_and_compressed() {
    let told = mapping(&["time=time [s]", "F_o=F_o [N]", "L=L [H]", "F_i=counts [N]"]);
    for name in ["motion-v5.mat", "motion-v7.mat"] {
        let found = read(name, &told, &Cleaning::default()).unwrap();
        same(&found, &[Channel::OutputForce, Channel::Inductance, Channel::InputForce]);
        let columns = mapping(&["time=time [s]", "F_o=both(:,1) [N]", "L=both(:,2) [H]"]);
        same(&read(name, &columns, &Cleaning::default()).unwrap(), &[Channel::OutputForce, Channel::Inductance]);
        let message = read(name, &Mapping::default(), &Cleaning::default()).unwrap_err();
        assert!(message.contains("guess is wrong: --column time=\"time [s]\" --column F_o=\"F_o [N]\""), "{message}");
    }
}

#[cfg(feature = "matlab")]
#[test]
fn matlab_of_version_4_is_told_by_its_chain_of_headers() {
    let told = mapping(&["time=time [s]", "F_o=F_o [N]", "L=L [H]", "F_i=counts [N]"]);
    let found = read("motion-v4.mat", &told, &Cleaning::default()).unwrap();
    same(&found, &[Channel::OutputForce, Channel::Inductance, Channel::InputForce]);
    let told = "MATLAB 4, vectors of 50; of another length: rate of 1; not read: who (a text)";
    assert_eq!(found.account().description, told);
    // Neither zeros nor a chain that is too short or too long is one.
    let place = tempfile::tempdir().unwrap();
    let good = std::fs::read(path("motion-v4.mat")).unwrap();
    let longer: Vec<u8> = good.iter().copied().chain([0]).collect();
    for bytes in [&[0; 20][..], &[0; 4000], &good[..good.len() - 1], &longer] {
        let file = place.path().join("run.mat");
        std::fs::write(&file, bytes).unwrap();
        let message = Recording::read(&file, &Mapping::default(), &Cleaning::default()).unwrap_err().to_string();
        assert!(message.ends_with("is no text: it holds zero bytes"), "{message}");
    }
}

#[cfg(feature = "matlab")]
#[test]
fn fields_of_matlabs_structs_have_their_full_names() {
    let told = mapping(&["time=run.time [s]", "F_o=run.F_o [N]", "L=L [H]", "F_i=run.cell.counts [N]"]);
    let found = read("motion-struct.mat", &told, &Cleaning::default()).unwrap();
    same(&found, &[Channel::OutputForce, Channel::Inductance, Channel::InputForce]);
    assert_eq!(found.account().description, "MATLAB 5 to 7, vectors of 50; of another length: run.cell.offset of 1");
}

/// A MATLAB file of version 5 with one element of these bytes.
#[cfg(feature = "matlab")]
fn level5(kind: u32, bytes: &[u8]) -> Vec<u8> {
    let mut file = b"MATLAB 5.0 MAT-file".to_vec();
    file.resize(124, b' ');
    file.extend(b"\x00\x01IM");
    file.extend([kind.to_le_bytes(), (bytes.len() as u32).to_le_bytes()].concat());
    file.extend(bytes);
    file
}

/// An element of type and bytes, padded to eight.
#[cfg(feature = "matlab")]
fn element(kind: u32, bytes: &[u8]) -> Vec<u8> {
    let mut all = [kind.to_le_bytes(), (bytes.len() as u32).to_le_bytes()].concat();
    all.extend(bytes);
    all.resize(all.len().next_multiple_of(8), 0);
    all
}

#[cfg(feature = "matlab")]
#[test]
fn what_only_matlab_reads_is_refused_with_the_line_that_converts() {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("run.mat");
    for (kind, words) in [
        (
            "timetable",
            "S.time = seconds(TT.Properties.RowTimes - TT.Properties.RowTimes(1)); save(\"log.mat\", \"-struct\", \"S\", \"-v7\")",
        ),
        ("timeseries", "S.time = TT.Time; S.data = TT.Data; save(\"log.mat\", \"-struct\", \"S\", \"-v7\")"),
        ("containers.Map", "TT is a containers.Map, which only MATLAB reads; save its numbers as vectors"),
    ] {
        let flags = element(6, &[17, 0, 0, 0, 0, 0, 0, 0]);
        let parts = [flags, element(1, b"TT"), element(1, b"MCOS"), element(1, kind.as_bytes())];
        std::fs::write(&file, level5(14, &parts.concat())).unwrap();
        let message = Recording::read(&file, &Mapping::default(), &Cleaning::default()).unwrap_err().to_string();
        assert!(message.ends_with(words) && message.lines().count() == 1, "{message}");
    }
}

#[cfg(feature = "matlab")]
#[test]
fn a_small_matlab_file_of_very_many_numbers_is_refused_before_they_are_held() {
    use std::io::Write;
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("run.mat");
    // 300 million zeros of a byte each, which MATLAB itself writes so, in 0.3 MB.
    let count = 300_000_000_u32;
    let sizes = [count.to_le_bytes(), 1_u32.to_le_bytes()].concat();
    let parts = [element(6, &[6, 0, 0, 0, 0, 0, 0, 0]), element(5, &sizes), element(1, b"F_o")].concat();
    let mut packer = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::fast());
    let whole = parts.len() as u32 + 8 + count;
    packer.write_all(&[14_u32.to_le_bytes(), whole.to_le_bytes()].concat()).unwrap();
    packer.write_all(&parts).unwrap();
    packer.write_all(&[2_u32.to_le_bytes(), count.to_le_bytes()].concat()).unwrap();
    // Damaged behind its first million bytes, so that who reads on says so.
    packer.write_all(&vec![0; 1_000_000]).unwrap();
    std::fs::write(&file, level5(15, &packer.finish().unwrap())).unwrap();
    let message = Recording::read(&file, &Mapping::default(), &Cleaning::default()).unwrap_err().to_string();
    assert!(message.ends_with("it is too large to be held in memory"), "{message}");
}

#[cfg(feature = "hdf5")]
#[test]
fn hdf5_of_h5py_in_chunks_with_filters_units_and_compound_rows() {
    let found = read("motion.h5", &mapping(&["F_x=counts"]), &Cleaning::default()).unwrap();
    let text = text();
    assert_eq!(found.signals().time(), text.signals().time());
    for channel in [Channel::OutputForce, Channel::Inductance] {
        assert_eq!(found.channel(channel).unwrap(), text.channel(channel).unwrap(), "{channel:?}");
    }
    let told = mapping(&["time=log/time [s]", "F_o=log/F_o [N]", "F_i=log/counts [N]", "L=both(:,2) [H]"]);
    let found = read("motion-rows.h5", &told, &Cleaning::default()).unwrap();
    same(&found, &[Channel::OutputForce, Channel::Inductance, Channel::InputForce]);
}

#[cfg(feature = "hdf5")]
#[test]
fn matlab_7_3_is_hdf5_column_by_column() {
    let told = mapping(&["time=time [s]", "F_o=both(:,1) [N]", "L=run.L [H]", "F_i=run.counts [N]"]);
    let found = read("motion-v73.mat", &told, &Cleaning::default()).unwrap();
    same(&found, &[Channel::OutputForce, Channel::Inductance, Channel::InputForce]);
    assert_eq!(found.account().description, "MATLAB 7.3, vectors of 50");
    let message = read("timetable-v73.mat", &Mapping::default(), &Cleaning::default()).unwrap_err();
    assert!(message.contains("TT is a timetable, which only MATLAB reads; there: S = table2struct("), "{message}");
}
