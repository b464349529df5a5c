//! What is wrong with a log, said in one line that names file, line and column; and bytes that nobody meant as a log.

use std::fs::File;
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use coilsense_lab::recording::{Cleaning, Mapping, Points, Recording, Table};
use proptest::prelude::*;
use rayon::prelude::*;
use tempfile::TempDir;

use super::fixtures::{mapping, read_with};

const GOOD: &str = "time [s],F_o [N],L [uH]\n0,1,3.1\n0.1,2,3.2\n0.2,3,3.3\n";

/// A text, the columns that are told, and what must be said of it.
type Fault = (&'static str, &'static [&'static str], &'static str);

const FAULTS: [Fault; 38] = [
    // Empty and the like
    ("", &[], "run.csv: is empty"),
    ("\n\n", &[], "run.csv: has no rows: it is empty, or holds comments only"),
    ("# only\n# remarks\n", &[], "run.csv: has no rows: it is empty, or holds comments only"),
    (
        "time [s],F_o [N]\n",
        &[],
        "run.csv: no row of numbers is in its first 2 lines; the first begins with \"time [s],F_o [N]\"",
    ),
    (
        "lorem ipsum\ndolor sit\n",
        &[],
        "run.csv: no row of numbers is in its first 3 lines; the first begins with \"lorem ipsum\"",
    ),
    ("\0\0\0\0", &[], "run.csv: is no text: it holds zero bytes"),
    // Rows that are too short, too long, or not of numbers
    (
        "time [s],F_o [N]\n0,1\n1,2\n2\n3,4\n",
        &[],
        "run.csv:4: it has 1 column where line 1 has 2; --drop-incomplete leaves such rows out",
    ),
    (
        "time [s],F_o [N]\n0,1\n1,2,3\n2,3\n",
        &[],
        "run.csv:3: it has 3 columns where line 1 has 2; --drop-incomplete leaves such rows out",
    ),
    (
        "time [s],F_o [N]\n0,1\n1,abc\n",
        &[],
        "run.csv:3: column 2 \"F_o [N]\": \"abc\" is not a number; --drop-incomplete leaves such rows out",
    ),
    (
        "time [s],F_o [N]\n0,1\n1,2 N\n",
        &[],
        "run.csv:3: column 2 \"F_o [N]\": \"2 N\" is not a number; --drop-incomplete leaves such rows out",
    ),
    (
        "time [s];F_o [N]\n0.0;1.5\n0.1;1,6\n",
        &[],
        "run.csv:3: column 2 \"F_o [N]\": \"1,6\" is not a number; --drop-incomplete leaves such rows out",
    ),
    (
        "time [s],F_o [N]\n0,1\n1,inf\n",
        &[],
        "run.csv:3: F_o = inf N: must be from -1e9 to 1e9 N; --drop-incomplete leaves such rows out",
    ),
    (
        "time [s],F_o [N]\n0,1\n1,1e400\n",
        &[],
        "run.csv:3: F_o = inf N: must be from -1e9 to 1e9 N; --drop-incomplete leaves such rows out",
    ),
    (
        "time [s],F_o [kN]\n0,1\n1,-1e7\n",
        &[],
        "run.csv:3: F_o = -1e10 N: must be from -1e9 to 1e9 N; --drop-incomplete leaves such rows out",
    ),
    ("time [s],F_o [N]\n0,1\n,2\n", &[], "run.csv:3: time has no value; --drop-incomplete leaves such rows out"),
    (
        "clock,F_o [N]\n12:00:00,1\n7,2\n",
        &["time=clock"],
        "run.csv:3: column 1 \"clock\": \"7\" is not a time stamp as in the first row; --drop-incomplete leaves such rows out",
    ),
    // Values that are missing
    (
        "time [s],F_o [N]\n0,1\n1,NaN\n2,3\n",
        &[],
        "run.csv:3: F_o has no value; --drop-incomplete leaves such rows out, --fill-gaps TIME fills them along straight lines, and so does --resample RATE where channels have different rates",
    ),
    (
        "time [s],F_o [N]\n0,nan\n1,NaN\n",
        &[],
        "run.csv:2: F_o has no value; --drop-incomplete leaves such rows out, --fill-gaps TIME fills them along straight lines, and so does --resample RATE where channels have different rates",
    ),
    // Times that do not rise
    (
        "time [s],F_o [N]\n0,1\n1,2\n0.5,3\n",
        &[],
        "run.csv:4: time goes back from 1 s to 0.5 s; --sort puts the rows in order",
    ),
    (
        "time [s],F_o [N]\n0,1\n0,2\n",
        &[],
        "run.csv:3: time 0 s is there again; --merge-repeated takes the mean of such rows",
    ),
    // Units
    (
        "time [s],F_o\n0,1\n1,2\n",
        &[],
        "run.csv: column 2 \"F_o\": its unit is not told; add these options, corrected where the guess is wrong: --column F_o=\"F_o [N]\"",
    ),
    (
        "time [s],F_o [mm]\n0,1\n1,2\n",
        &[],
        "run.csv: column 2 \"F_o [mm]\": \"mm\" is not a unit of a force; F_o may have N, kN, mN, lbf, kgf, gf",
    ),
    (
        "time [N],F_o [N]\n0,1\n1,2\n",
        &[],
        "run.csv: column 1 \"time [N]\": \"N\" is not a unit of a time; time may have s, ms, us, µs, ns, min, h, d",
    ),
    (
        "time [s],LC [V]\n0,1\n1,2\n",
        &["F_o=LC"],
        "run.csv: column 2 \"LC [V]\": V is no unit of a force, it needs a gain; add this option, with your sensor's gain in place of 1: --gain F_o=\"1 N/V\"",
    ),
    (
        "time [s],LC [kN]\n0,1\n1,2\n",
        &["F_o=LC [N]"],
        "run.csv: column 2 \"LC [kN]\": its title says \"kN\", the mapping of F_o says \"N\"",
    ),
    // Columns
    (
        "a,b\n0,1\n1,2\n",
        &[],
        "run.csv: no column is recognised as the time; no column is recognised as a channel: it has column 1 \"a\", column 2 \"b\"; add these options, corrected where the guess is wrong: --column time=\"a [s]\" --column F_o=\"b [N]\"; if the log has no time column, --sample-rate says how often it was sampled",
    ),
    (
        "0,1\n1,2\n",
        &[],
        "run.csv: no column is recognised as the time; no column is recognised as a channel: it has column 1, column 2; add these options, corrected where the guess is wrong: --column time=\"#1 [s]\" --column F_o=\"#2 [N]\"; if the log has no time column, --sample-rate says how often it was sampled",
    ),
    (
        "a,F_o [N]\n0,1\n1,2\n",
        &[],
        "run.csv: no column is recognised as the time; add these options, corrected where the guess is wrong: --column time=\"a [s]\"; if the log has no time column, --sample-rate says how often it was sampled",
    ),
    (
        "t_ms,pos_um,force_in\n0,1,2\n1,2,3\n",
        &[],
        "run.csv: no column is recognised as the time; no column is recognised as a channel: it has column 1 \"t_ms\", column 2 \"pos_um\", column 3 \"force_in\"; add these options, corrected where the guess is wrong: --column time=\"t_ms [ms]\" --column u1=\"pos_um [um]\" --column F_o=\"force_in [N]\"; if the log has no time column, --sample-rate says how often it was sampled",
    ),
    (
        "time [s],force [N]\n0,1\n1,2\n",
        &["F_o=forse"],
        "run.csv: F_o = \"forse\": no column has this title; did you mean \"force\"?",
    ),
    (
        "0,1\n1,2\n",
        &["F_o=force [N]"],
        "run.csv: F_o = \"force\": the file has no header; name the column by its number, such as #2",
    ),
    (
        "time [s],F [N],F [N]\n0,1,2\n1,2,3\n",
        &["F_o=F"],
        "run.csv: F_o = \"F\": columns 2 and 3 both have this title; name one by its number, such as #2",
    ),
    ("0,1\n1,2\n", &["F_o=#3 [N]"], "run.csv: F_o = #3: must be from #1 to #2"),
    // Other kinds of files
    (
        "\u{1f}\u{8b}",
        &[],
        "run.csv: no row of numbers is in its first 1 lines; the first begins with \"\\u{1f}\\u{8b}\"",
    ),
    ("PK\u{3}\u{4}", &[], "run.csv: is a ZIP archive that is cut off or damaged"),
    ("TDSm", &[], "run.csv: has no channel of numbers"),
    ("TDSh", &[], "run.csv: is the index of an NI TDMS file, which holds no data; read the .tdms beside it"),
    ("\u{89}HDF", &[], "run.csv: no row of numbers is in its first 1 lines; the first begins with \"\\u{89}HDF\""),
];

#[test]
fn each_fault_is_one_line_with_file_line_and_column() {
    for (text, columns, expected) in FAULTS {
        let message = read_with(text, &mapping(columns), &Cleaning::default()).unwrap_err();
        assert_eq!(message, expected, "{text:?}");
        assert!(!message.contains('\n'));
    }
}

#[test]
fn what_cannot_be_opened_is_said() {
    let place = tempfile::tempdir().unwrap();
    for (path, words) in [(place.path().join("none.csv"), "No such file"), (place.path().to_owned(), "directory")] {
        let message = Recording::read(&path, &Mapping::default(), &Cleaning::default()).unwrap_err().to_string();
        assert!(
            message.starts_with(&format!("{}: cannot be read: ", path.display())) && message.contains(words),
            "{message}"
        );
    }
    if Path::new("/dev/zero").exists() {
        let message = Recording::read(Path::new("/dev/zero"), &Mapping::default(), &Cleaning::default()).unwrap_err();
        assert_eq!(message.to_string(), "/dev/zero: is no text: it holds zero bytes");
    }
}

#[test]
fn a_mapping_that_is_wrong_is_said() {
    let cases = [
        ("[log", "map.toml:1: not TOML: "),
        ("[logs]", "map.toml: unknown table [logs]; allowed: [log], [columns]"),
        (
            "[log]\nseparator = \";\"",
            "map.toml: [log] unknown key \"separator\"; allowed: delimiter, decimal, header, comment, skip, sample_rate",
        ),
        ("[log]\ndelimiter = \"ab\"", "map.toml: [log] delimiter = \"ab\": must be one character, or \"space\""),
        (
            "[log]\nsample_rate = 2500",
            "map.toml: [log] sample_rate = 2500: must be a frequency with its unit (Hz, kHz, MHz, rpm)",
        ),
        ("[log]\nskip = -1", "map.toml: [log] skip = -1: must be a whole number from 0 up"),
        ("[columns]\nforce = \"LC\"", "map.toml: [columns] force: must be one of time, u1, u2, F_i, F_o, F_x, F_L, L"),
        ("[columns]\nF_o = 3", "map.toml: [columns] F_o: must be a title in quotes or a table { column = …, … }"),
        ("[columns]\nF_o = { unit = \"N\" }", "map.toml: [columns] F_o: needs one of column, columns and constant"),
        (
            "[columns]\nF_o = { column = \"a\", unit = \"mm\" }",
            "map.toml: [columns] F_o: unit = \"mm\": must be a force with its unit (N, kN, mN, lbf, kgf, gf)",
        ),
        (
            "[columns]\nF_o = { column = \"a\", factor = 0 }",
            "map.toml: [columns] F_o: factor = 0: must be a number that is not zero",
        ),
    ];
    for (text, expected) in cases {
        let message = Mapping::parse("map.toml", text).unwrap_err().to_string();
        assert!(message.starts_with(expected), "{message}");
        assert!(!message.contains('\n'), "{message}");
    }
    for (column, words) in
        [("F_o", "must be NAME="), ("x=1", "must be one of time, u1"), ("F_o= ", "title behind = is missing")]
    {
        let message = Mapping::default().set(column).unwrap_err().to_string();
        assert!(message.contains(words), "{message}");
    }
    assert!(Mapping::preset("rig").unwrap_err().to_string().ends_with("there are: lab-data"));
}

#[test]
fn a_file_cut_off_anywhere_is_read_or_refused_in_one_line() {
    for length in 0..GOOD.len() {
        match read_with(&GOOD.as_bytes()[..length], &Mapping::default(), &Cleaning::default()) {
            Ok(recording) => assert_eq!(recording.account().read, recording.account().rows),
            Err(message) => assert!(message.starts_with("run.csv") && !message.contains('\n'), "{message}"),
        }
    }
}

/// Everything that a user may ask for at once.
const ALL: Cleaning = Cleaning {
    drop_incomplete: true,
    sort: true,
    merge_repeated: true,
    unwrap: true,
    repair_up_to: Some(1.0),
    fill_gaps: Some(10.0),
    resample: None,
    from: None,
    to: None,
};

/// Reads bytes in every way; whatever comes, it comes soon, on one line, and with every row counted.
fn survives(bytes: &[u8]) {
    let begun = Instant::now();
    let place = tempfile::tempdir().expect("a temporary folder");
    let path = place.path().join("run");
    std::fs::write(&path, bytes).expect("written");
    for columns in [&[][..], &["time=#1 [s]", "F_o=#2 [N]"], &["F_o=#2 [N]", "time=time [s]", "L=L [H]"]] {
        for cleaning in [Cleaning::default(), ALL, Cleaning { resample: Some(100.0), to: Some(100.0), ..ALL }] {
            match Recording::read(&path, &mapping(columns), &cleaning) {
                Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
                Ok(recording) => {
                    let account = recording.account();
                    assert_eq!(account.rows as usize, recording.signals().time().len());
                    let balance = account.read + account.filled_rows - account.left_out();
                    assert!(account.resampled.is_some() || balance == account.rows, "{account}");
                }
            }
        }
        let _ = Points::read(&path, &mapping(columns), &ALL);
    }
    let _ = Table::read(&path, &Mapping::default().format);
    assert!(begun.elapsed() < Duration::from_secs(5), "{:?}", begun.elapsed());
}

/// Good files, and the bytes that make a text one.
fn good() -> Vec<Vec<u8>> {
    let names = [
        "motion.parquet",
        "narrow.parquet",
        "motion-v5.mat",
        "motion-v7.mat",
        "motion.mf4",
        "motion-packed.mf4",
        "motion.feather",
        "motion.arrows",
        "motion.xlsx",
        "motion.ods",
    ];
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/logs");
    let read = |name: &str| std::fs::read(folder.join(name)).expect("a reference log");
    [GOOD.as_bytes().to_vec(), GOOD.replace(',', ";").replace('.', ",").into_bytes()]
        .into_iter()
        .chain(names.map(read))
        .collect()
}

/// A good file of which one byte at a time is made wrong, in its place: a file that is written anew each time waits for the disk.
struct Spoilt {
    path: PathBuf,
    file: File,
    _place: TempDir,
}

impl Spoilt {
    fn new(good: &[u8]) -> Self {
        let place = tempfile::tempdir().expect("a temporary folder");
        let path = place.path().join("run");
        std::fs::write(&path, good).expect("written");
        let file = File::options().write(true).open(&path).expect("opened");
        Self { path, file, _place: place }
    }

    fn set(&mut self, index: usize, byte: u8) {
        self.file.seek(SeekFrom::Start(index as u64)).expect("a place in the file");
        self.file.write_all(&[byte]).expect("written");
    }
}

#[test]
fn any_one_byte_of_a_binary_file_may_be_wrong() {
    for (which, good) in good().into_iter().enumerate().skip(2) {
        (0..good.len()).into_par_iter().for_each_init(
            || Spoilt::new(&good),
            |spoilt, index| {
                for wrong in [0x80, 0x0f] {
                    spoilt.set(index, good[index] ^ wrong);
                    if let Err(error) = Recording::read(&spoilt.path, &Mapping::default(), &Cleaning::default()) {
                        assert!(!error.to_string().contains('\n'), "file {which}, byte {index}: {error}");
                    }
                }
                spoilt.set(index, good[index]);
            },
        );
    }
}

/// How many of each kind; PROPTEST_CASES says more.
fn cases() -> u32 {
    std::env::var("PROPTEST_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(96)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(), ..ProptestConfig::default() })]

    #[test]
    fn random_bytes_do_no_harm(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        survives(&bytes);
    }

    #[test]
    fn random_texts_do_no_harm(text in "[0-9.,;\\-+eE \t\n#\"naN:TZ]{0,200}") {
        survives(text.as_bytes());
    }

    #[test]
    fn random_edits_of_good_files_do_no_harm(
        which in 0..12_usize,
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
        cut in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let mut bytes = good().swap_remove(which);
        for (place, byte) in edits {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()));
        }
        survives(&bytes);
    }
}
