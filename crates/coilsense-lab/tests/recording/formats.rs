//! Files of other programs: the same log from pyarrow, SciPy and asammdf, compared to the last bit.

use std::path::{Path, PathBuf};

use coilsense::Channel;
use coilsense_lab::recording::{Cleaning, Mapping, Recording, Table};

use super::fixtures::mapping;

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/logs").join(name)
}

fn read(name: &str, mapping: &Mapping, cleaning: &Cleaning) -> Result<Recording, String> {
    Recording::read(&path(name), mapping, cleaning).map_err(|error| error.to_string())
}

/// The log as text, 17 digits a number.
fn text() -> Recording {
    read("motion.csv", &mapping(&["F_i=counts [N]", "F_x=converted [mN]"]), &Cleaning::default()).unwrap()
}

/// Time and channels of a file are those of the text, bit by bit.
#[track_caller]
fn same(found: &Recording, channels: &[Channel]) {
    let text = text();
    assert_eq!(found.signals().time(), text.signals().time());
    for &channel in channels {
        assert_eq!(found.channel(channel).unwrap(), text.channel(channel).unwrap(), "{channel:?}");
    }
    assert_eq!((found.account().read, found.account().rows, found.account().left_out()), (50, 50, 0));
}

#[cfg(feature = "parquet")]
#[test]
fn parquet_of_pyarrow_in_row_groups_pages_and_dictionaries() {
    for name in ["motion.parquet", "motion-plain.parquet"] {
        let counts = mapping(&["F_i=counts [N]"]);
        let found = read(name, &counts, &Cleaning::default()).unwrap();
        same(&found, &[Channel::OutputForce, Channel::Inductance, Channel::InputForce]);
    }
}

#[cfg(feature = "parquet")]
#[test]
fn parquet_with_stamps_nulls_and_narrow_numbers() {
    let stamped = mapping(&["time=when"]);
    let message = read("narrow.parquet", &stamped, &Cleaning::default()).unwrap_err();
    assert!(message.contains("narrow.parquet:4: F_o has no value"), "{message}");
    let found = read(
        "narrow.parquet",
        &stamped,
        &Cleaning { drop_incomplete: true, repair_up_to: Some(0.9), ..Cleaning::default() },
    )
    .unwrap();
    let text = text();
    let kept: Vec<usize> = (0..50).filter(|row| row % 7 != 3).collect();
    let pick = |values: &[f64]| kept.iter().map(|&row| values[row]).collect::<Vec<f64>>();
    assert_eq!(found.channel(Channel::OutputForce).unwrap(), pick(text.channel(Channel::OutputForce).unwrap()));
    let narrow = pick(text.channel(Channel::OutputForce).unwrap())
        .iter()
        .map(|force| f64::from(*force as f32))
        .collect::<Vec<f64>>();
    assert_eq!(found.channel(Channel::InputForce).unwrap(), narrow);
    // Whole microseconds, so that k / 2500 s is rounded where 1e6 k / 2500 is none.
    let off = found.signals().time().iter().zip(pick(text.signals().time())).map(|(a, b)| (a - b).abs());
    assert!(off.fold(0.0, f64::max) <= 1e-18);
    assert_eq!((found.account().read, found.account().left_out(), found.account().rows), (50, 7, 43));
    let message = read("narrow.parquet", &mapping(&["time=when", "u1=note [m]"]), &Cleaning::default()).unwrap_err();
    assert!(message.ends_with("column 4 \"note\": it holds texts, no numbers"), "{message}");
}

#[cfg(feature = "parquet")]
#[test]
fn what_is_written_as_parquet_or_csv_is_read_as_the_same() {
    use coilsense_lab::output::Output;
    use coilsense_lab::recording::import;
    use coilsense_lab::series::Format;
    let place = tempfile::tempdir().unwrap();
    let log = place.path().join("log.csv");
    std::fs::write(&log, "# simulated: seed 7\ntime [s],F_o [N]\n0,1.5\n0.1,-0.1\n0.2,1e-300\n").unwrap();
    let first = Recording::read(&log, &Mapping::default(), &Cleaning::default()).unwrap();
    for (name, format) in [("again.parquet", Format::Parquet), ("again.csv", Format::Csv)] {
        let mut output = Output::begin(place.path()).unwrap();
        let mapping = Mapping::default();
        import(&log, &mapping, &Cleaning::default(), &|_, _| true, format, name, &mut output).unwrap();
        output.commit().unwrap();
        let again = Recording::read(&place.path().join(name), &mapping, &Cleaning::default()).unwrap();
        assert_eq!(again.signals(), first.signals());
        assert_eq!(again.simulated(), Some("simulated: seed 7"), "what is simulated says so after each step");
    }
}

/// Bits of a column, all that are no number as one.
fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|value| if value.is_nan() { f64::NAN } else { *value }.to_bits()).collect()
}

#[cfg(all(feature = "parquet", feature = "arrow"))]
#[test]
fn every_type_of_numbers_gives_the_nearest_doubles() {
    let text = Table::read(&path("types.csv"), &Mapping::default().format).unwrap();
    assert_eq!(text.titles().len(), 21);
    for name in ["types.parquet", "types-v2.parquet", "types-old.parquet", "types.feather"] {
        let table = Table::read(&path(name), &Mapping::default().format).unwrap();
        let titles = |table: &Table| table.titles().iter().map(|title| title.text.clone()).collect::<Vec<_>>();
        // Truth values, texts, lists and nothing are no numbers.
        assert_eq!(titles(&table), titles(&text), "{name}");
        for title in titles(&text) {
            let [found, told] = [&table, &text].map(|table| bits(table.column(&title).unwrap()));
            assert_eq!(found, told, "{name}: {title}");
        }
        for (column, what) in [("ok", "true and false"), ("note", "texts"), ("none", "nothing")] {
            let told = mapping(&[&format!("F_o={column} [N]"), "time=stretches"]);
            let message = read(name, &told, &Cleaning::default()).unwrap_err();
            assert!(message.ends_with(&format!("\"{column}\": it holds {what}, no numbers")), "{message}");
        }
        // Stretches of time carry their unit.
        let told = mapping(&["time=stretches", "F_o=uint8 [N]"]);
        assert_eq!(read(name, &told, &Cleaning::default()).unwrap().signals().time()[2], 0.000_800_001);
    }
}

#[cfg(feature = "arrow")]
#[test]
fn arrow_files_and_streams_in_record_batches() {
    for (name, description) in
        [("motion.feather", "Arrow file (Feather), 4 columns"), ("motion.arrows", "Arrow stream, 4 columns")]
    {
        let found = read(name, &mapping(&["F_i=counts [N]"]), &Cleaning::default()).unwrap();
        same(&found, &[Channel::OutputForce, Channel::Inductance, Channel::InputForce]);
        assert_eq!(found.account().description, description);
        let bytes = std::fs::read(path(name)).unwrap();
        let place = tempfile::tempdir().unwrap();
        let cut = place.path().join("cut");
        for length in (8..bytes.len() - 8).step_by(7) {
            std::fs::write(&cut, &bytes[..length]).unwrap();
            let found =
                Recording::read(&cut, &Mapping::default(), &Cleaning::default()).map_err(|error| error.to_string());
            match found {
                // A stream may end behind any of its messages.
                Ok(found) => assert!(name == "motion.arrows" && found.account().rows.is_multiple_of(20)),
                Err(message) => assert!(message.contains(": is ") || message.ends_with("has no rows"), "{message}"),
            }
        }
    }
}

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
        assert!(message.contains("and add --column time=\"time [s]\" --column F_o=\"F_o [N]\""), "{message}");
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

#[cfg(feature = "mdf")]
#[test]
fn mdf_of_asammdf_with_groups_of_their_own_rates() {
    for name in ["motion.mf4", "motion-packed.mf4"] {
        let counts = mapping(&["F_x=counts"]);
        let message = read(name, &counts, &Cleaning::default()).unwrap_err();
        assert!(message.contains(":2: L has no value") && message.contains("--resample"), "{message}");
        let kept = Cleaning { drop_incomplete: true, repair_up_to: Some(0.9), ..Cleaning::default() };
        let found = read(name, &counts, &kept).unwrap();
        let text = text();
        for channel in [Channel::OutputForce, Channel::Inductance, Channel::DeflectionForce] {
            let tenth: Vec<f64> = text.channel(channel).unwrap().iter().step_by(10).copied().collect();
            assert_eq!(found.channel(channel).unwrap(), tenth, "{channel:?}");
        }
        assert_eq!((found.account().read, found.account().left_out()), (50, 45));
    }
}

#[cfg(feature = "mdf")]
#[test]
fn mdf_3_of_asammdf_is_read_as_mdf_4_is() {
    let kept = Cleaning { drop_incomplete: true, repair_up_to: Some(0.9), ..Cleaning::default() };
    let found = read("motion.mdf", &mapping(&["F_x=counts"]), &kept).unwrap();
    let text = text();
    for channel in [Channel::OutputForce, Channel::Inductance, Channel::DeflectionForce] {
        let tenth: Vec<f64> = text.channel(channel).unwrap().iter().step_by(10).copied().collect();
        assert_eq!(found.channel(channel).unwrap(), tenth, "{channel:?}");
    }
    assert!(found.account().description.ends_with("; not read: state (converted to texts)"), "{}", found.account());
}

#[cfg(feature = "tdms")]
#[test]
fn tdms_of_nptdms_in_segments_with_scales_and_waveforms() {
    let found = read("motion.tdms", &mapping(&["F_x=counts"]), &Cleaning::default()).unwrap();
    same(&found, &[Channel::OutputForce, Channel::Inductance, Channel::DeflectionForce]);
    assert_eq!(found.account().description, "NI TDMS, 3 channels on one clock");
    let text = text();
    let kept = Cleaning { drop_incomplete: true, repair_up_to: Some(0.9), ..Cleaning::default() };
    let found = read("motion-wave.tdms", &Mapping::default(), &kept).unwrap();
    for channel in [Channel::OutputForce, Channel::Inductance] {
        let tenth: Vec<f64> = text.channel(channel).unwrap().iter().step_by(10).copied().collect();
        assert_eq!(found.channel(channel).unwrap(), tenth, "{channel:?}");
    }
    assert_eq!(found.signals().time(), [0.0, 0.004, 0.008, 0.012, 0.016]);
    assert_eq!(found.account().description, "NI TDMS, 2 channels on 2 clocks; not read: note (texts)");
}

#[cfg(feature = "tdms")]
#[test]
fn tdms_of_a_card_that_was_stopped_in_a_row() {
    let found = read("motion-card.tdms", &Mapping::default(), &Cleaning::default()).unwrap();
    let text = text();
    // Rows 0 to 19 with metadata, 20 to 29 without, 30 to 46 and half of one before it was stopped.
    assert_eq!(found.signals().time(), &text.signals().time()[..47]);
    let counts = text.channel(Channel::InputForce).unwrap();
    let scaled = |sign: f64| counts[..47].iter().map(|count| (sign * count * 0.5 + 3.0) / 1e3).collect::<Vec<f64>>();
    assert_eq!(found.channel(Channel::OutputForce).unwrap(), scaled(1.0));
    assert_eq!(found.channel(Channel::InputForce).unwrap(), scaled(-1.0));
    assert_eq!(found.remarks(), ["the file is cut off in its last segment"]);
}

#[test]
fn a_refusal_holds_a_line_to_paste() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("FILE of Bob's.csv.bz2");
    std::fs::write(&path, b"BZh91AY&SY").unwrap();
    let message = Recording::read(&path, &Mapping::default(), &Cleaning::default()).unwrap_err().to_string();
    let quoted = format!("'{}/FILE of Bob'\\''s.csv.bz2'", place.path().display());
    let line = format!("is compressed by bzip2, which is not read; unpack it first: bunzip2 --keep {quoted}");
    assert!(message.ends_with(&line), "{message}");
}

#[test]
fn what_is_not_read_is_refused_by_name() {
    let message = read("old.feather", &Mapping::default(), &Cleaning::default()).unwrap_err();
    let words = "is Feather of version 1, which is not read; convert it by: python3 -c";
    assert!(message.starts_with(&path("old.feather").display().to_string()) && message.contains(words), "{message}");
    assert_eq!(message.lines().count(), 1);
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

#[cfg(feature = "mcap")]
#[test]
fn mcap_of_json_in_chunks_of_its_topics() {
    let kept = Cleaning { drop_incomplete: true, repair_up_to: Some(0.9), ..Cleaning::default() };
    for name in ["motion.mcap", "motion-lz4.mcap"] {
        let found = read(name, &mapping(&["F_i=raw.counts [N]"]), &kept).unwrap();
        let text = text();
        for channel in [Channel::OutputForce, Channel::Inductance, Channel::InputForce] {
            let tenth: Vec<f64> = text.channel(channel).unwrap().iter().step_by(10).copied().collect();
            assert_eq!(found.channel(channel).unwrap(), tenth, "{channel:?}");
        }
        assert_eq!(found.signals().time(), [0.0, 0.004, 0.008, 0.012, 0.016]);
    }
    let message = read("proto.mcap", &Mapping::default(), &Cleaning::default()).unwrap_err();
    assert!(
        message.contains("holds messages in protobuf, which is not read; write them as CSV: python -c '"),
        "{message}"
    );
}

#[cfg(not(all(
    feature = "parquet",
    feature = "arrow",
    feature = "matlab",
    feature = "mdf",
    feature = "tdms",
    feature = "hdf5",
    feature = "mcap"
)))]
#[test]
fn a_format_that_was_left_out_is_named() {
    let out: [(bool, &str, &str); 9] = [
        (cfg!(feature = "parquet"), "motion.parquet", "without the feature parquet"),
        (cfg!(feature = "arrow"), "motion.feather", "without the feature arrow"),
        (cfg!(feature = "matlab"), "motion-v5.mat", "without the feature matlab"),
        (cfg!(feature = "mdf"), "motion.mf4", "without the feature mdf"),
        (cfg!(feature = "tdms"), "motion.tdms", "without the feature tdms"),
        (cfg!(feature = "hdf5"), "motion.h5", "without the feature hdf5"),
        (cfg!(feature = "hdf5"), "motion-v73.mat", "without the feature hdf5"),
        (cfg!(feature = "mdf"), "motion.mdf", "without the feature mdf"),
        (cfg!(feature = "mcap"), "motion.mcap", "without the feature mcap"),
    ];
    for (_, name, words) in out.iter().filter(|(there, ..)| !there) {
        let message = read(name, &Mapping::default(), &Cleaning::default()).unwrap_err();
        assert!(message.ends_with(words), "{message}");
    }
}

#[test]
fn a_table_holds_columns_by_title_and_number() {
    let names = ["motion.csv", "motion.parquet", "motion-v7.mat", "motion.mf4", "motion.tdms"];
    let there =
        [true, cfg!(feature = "parquet"), cfg!(feature = "matlab"), cfg!(feature = "mdf"), cfg!(feature = "tdms")];
    for (name, _) in names.iter().zip(there).filter(|(_, there)| *there) {
        let table = Table::read(&path(name), &Mapping::default().format).unwrap();
        assert_eq!(table.column("F_o").unwrap(), text().channel(Channel::OutputForce).unwrap(), "{name}");
        let place = table.titles().iter().position(|title| title.name == "F_o").unwrap();
        assert_eq!(table.column(&format!("#{}", place + 1)).unwrap(), table.column("F_o").unwrap());
        assert!(table.column("F_q").is_err() && table.column("#0").is_err() && table.column("#99").is_err());
        assert_eq!((table.rows(), table.lines().len()), (50, 50));
    }
}
