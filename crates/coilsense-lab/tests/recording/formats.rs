//! Files of tables: the same log from pyarrow, compared to the last bit; and what is refused by name.

use coilsense::Channel;
use coilsense_lab::recording::{Cleaning, Mapping, Recording, Table};

use super::fixtures::mapping;
use super::golden::{path, read, same, text};

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
