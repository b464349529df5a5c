//! `cargo xtask fuzz`: random bytes, guided by the code that they reach, against all that reads what strangers may send. The targets lie in
//! `fuzz/`, as `cargo fuzz` wants them; it is not needed.
//!
//! Who adds a target writes its line in `fuzz/fuzz_targets`, its `[[bin]]` in `fuzz/Cargo.toml` and a row of [`SEEDS`].
//!
//! Next door: the other checks (`test`).

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, bail, ensure};

use crate::{root, target_folder};

/// What to fuzz, and for how long.
#[derive(clap::Args)]
pub struct Arguments {
    /// Targets by their name in fuzz/fuzz_targets; without any, all
    targets: Vec<String>,
    /// Seconds for each
    #[arg(long, default_value_t = 60)]
    seconds: u64,
}

impl Arguments {
    /// Every target for so many seconds.
    pub fn all(seconds: u64) -> Self {
        Self { targets: Vec::new(), seconds }
    }
}

/// Seconds for each target in the checks.
pub const SECONDS: u64 = 600;

/// What a target begins with.
enum Seeds {
    /// Files of the repository by how their names end.
    Files(&'static [&'static str]),
    /// Quoted values of the examples.
    Values,
}

/// What each target begins with, and words that it may put together.
const SEEDS: [(&str, Seeds, Words); 11] = [
    ("spec", Seeds::Files(&["toml"]), Words::OfSeeds),
    ("text_log", Seeds::Files(&["csv"]), Words::These(&LOG_WORDS)),
    ("mat", Seeds::Files(&["mat"]), Words::None),
    ("mdf", Seeds::Files(&["mf4", "mdf"]), Words::None),
    ("tdms", Seeds::Files(&["tdms"]), Words::None),
    ("workbook", Seeds::Files(&["xlsx", "ods"]), Words::None),
    ("arrow", Seeds::Files(&["feather"]), Words::None),
    ("hdf5", Seeds::Files(&["h5"]), Words::None),
    ("mcap", Seeds::Files(&["mcap"]), Words::None),
    ("parquet", Seeds::Files(&["parquet"]), Words::None),
    ("quantity", Seeds::Values, Words::OfSeeds),
];

/// Words that a target may put together.
enum Words {
    None,
    OfSeeds,
    These(&'static [&'static str]),
}

const LOG_WORDS: [&str; 20] = [
    "time [s]",
    "u1 [mm]",
    "u2 [m]",
    "F_i [N]",
    "F_o [kN]",
    "L [uH]",
    "[ms]",
    ";",
    "\t",
    ",",
    "\r\n",
    "# ",
    "nan",
    "1e-9",
    "-inf",
    "12:00:00.000",
    "2026-01-31T23:59:59Z",
    "\u{feff}",
    "\"",
    "±",
];

/// Folders of the repository that hold seeds.
const FOLDERS: [&str; 2] = ["examples", "crates/coilsense-lab/tests/golden/logs"];
/// Most bytes of a seed: a target is as quick as its seeds are small.
const MOST_SEED: u64 = 1 << 16;

/// Most seconds and megabytes for what one input asks for.
const MOST_SECONDS: &str = "-timeout=60";
const MOST_MEMORY: &str = "-rss_limit_mb=4096";

/// The machine that is fuzzed on.
const MACHINE: &str = "x86_64-unknown-linux-gnu";
/// Which code is reached, which numbers are compared, and what is read that should not be: as `cargo fuzz` tells the compiler.
const FLAGS: &str = "-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table \
    -Cllvm-args=-sanitizer-coverage-trace-compares -Cllvm-args=-simplifycfg-branch-fold-threshold=0 --cfg=fuzzing \
    -Zsanitizer=address -Ccodegen-units=1";

/// The cargo of a nightly compiler, which `rustup` finds by this word; sanitizers are not in others.
fn nightly() -> Command {
    let mut command = Command::new("cargo");
    // What the workspace's own compiler has set is not this one's.
    command.arg("+nightly").current_dir(root().join("fuzz"));
    for name in ["CARGO", "RUSTC", "RUSTUP_TOOLCHAIN", "LD_LIBRARY_PATH"] {
        command.env_remove(name);
    }
    command
}

/// What is missing to fuzz here, and how to get it.
pub fn missing() -> Option<String> {
    if !cfg!(all(target_arch = "x86_64", target_os = "linux")) {
        return Some(format!("the fuzzers are built for {MACHINE}"));
    }
    let found = nightly().arg("--version").output().is_ok_and(|output| output.status.success());
    (!found).then(|| "no nightly compiler; get one with: rustup toolchain install nightly --profile minimal".to_owned())
}

/// Runs targets; what one finds is an error, and lies in `target/fuzz/artifacts`.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    if let Some(missing) = missing() {
        bail!(missing);
    }
    let names: Vec<&str> = SEEDS.iter().map(|(name, ..)| *name).collect();
    if let Some(unknown) = arguments.targets.iter().find(|target| !names.contains(&target.as_str())) {
        bail!("{unknown}: must be one of {}", names.join(", "));
    }
    let wanted = |name: &str| arguments.targets.is_empty() || arguments.targets.iter().any(|target| target == name);
    let mut found = Vec::new();
    for (name, seeds, words) in SEEDS.iter().filter(|(name, ..)| wanted(name)) {
        if !fuzzed(name, seeds, words, arguments.seconds)? {
            found.push(*name);
        }
    }
    ensure!(found.is_empty(), "inputs that make {} fail lie in target/fuzz/artifacts", found.join(", "));
    Ok(())
}

/// Builds a target and runs it; whether it found nothing.
fn fuzzed(name: &str, seeds: &Seeds, words: &Words, seconds: u64) -> anyhow::Result<bool> {
    let place = target_folder().join("fuzz");
    let mut build = nightly();
    build.args(["build", "--locked", "--release", "--target", MACHINE, "--bin", name, "--target-dir"]).arg(&place);
    let built = build.env("RUSTFLAGS", FLAGS).status().with_context(|| format!("cannot start {build:?}"))?;
    ensure!(built.success(), "the fuzz target {name} was not built");
    let [corpus, artifacts] = ["corpus", "artifacts"].map(|folder| place.join(folder).join(name));
    for folder in [&corpus, &artifacts] {
        std::fs::create_dir_all(folder).with_context(|| format!("{} cannot be made", folder.display()))?;
    }
    let seeds = of(seeds)?;
    ensure!(!seeds.is_empty(), "{name}: no seed is there");
    for (number, seed) in seeds.iter().enumerate() {
        std::fs::write(corpus.join(format!("seed-{number}")), seed)?;
    }
    let mut fuzzer = Command::new(place.join(MACHINE).join("release").join(name));
    fuzzer.args([MOST_SECONDS, MOST_MEMORY, "-print_final_stats=1", "-verbosity=0"]);
    fuzzer.arg(format!("-max_total_time={seconds}")).arg(format!("-artifact_prefix={}/", artifacts.display()));
    if let Some(text) = dictionary(words, &seeds) {
        let file = place.join(format!("{name}.dict"));
        std::fs::write(&file, text)?;
        fuzzer.arg(format!("-dict={}", file.display()));
    }
    println!("{name}: {seconds} s from {} seeds", seeds.len());
    Ok(fuzzer.arg(&corpus).current_dir(&place).status().with_context(|| format!("cannot start {fuzzer:?}"))?.success())
}

/// The seeds of a target.
fn of(seeds: &Seeds) -> anyhow::Result<Vec<Vec<u8>>> {
    match seeds {
        Seeds::Files(endings) => files(endings),
        Seeds::Values => {
            let texts = files(&["toml"])?;
            let quoted = |text: &Vec<u8>| {
                let text = String::from_utf8_lossy(text).into_owned();
                text.split('"').skip(1).step_by(2).map(|value| value.as_bytes().to_vec()).collect::<Vec<_>>()
            };
            let values: BTreeSet<Vec<u8>> = texts.iter().flat_map(quoted).filter(|value| value.len() < 40).collect();
            Ok(values.into_iter().collect())
        }
    }
}

/// The repository's small files whose names end so.
fn files(endings: &[&str]) -> anyhow::Result<Vec<Vec<u8>>> {
    let mut paths: Vec<PathBuf> = Vec::new();
    for folder in FOLDERS {
        for entry in std::fs::read_dir(root().join(folder)).with_context(|| format!("{folder} cannot be read"))? {
            let path = entry?.path();
            if endings.iter().any(|&ending| path.extension().is_some_and(|end| end == ending)) {
                paths.push(path);
            }
        }
    }
    paths.sort();
    let read = |path: &PathBuf| std::fs::read(path).with_context(|| format!("{} cannot be read", path.display()));
    let small = |path: &&PathBuf| Path::metadata(path).is_ok_and(|about| about.len() <= MOST_SEED);
    paths.iter().filter(small).map(read).collect()
}

/// Words as libFuzzer reads them, those of seeds of letters and digits.
fn dictionary(words: &Words, seeds: &[Vec<u8>]) -> Option<String> {
    let words: BTreeSet<String> = match words {
        Words::None => return None,
        Words::These(words) => words.iter().map(|&word| word.to_owned()).collect(),
        Words::OfSeeds => {
            let texts = seeds.iter().map(|seed| String::from_utf8_lossy(seed).into_owned());
            let kept = |c: char| c.is_ascii_alphanumeric() || "_-/%.".contains(c);
            texts.flat_map(|text| text.split(|c| !kept(c)).map(str::to_owned).collect::<Vec<_>>()).collect()
        }
    };
    let escaped = |word: &String| word.bytes().map(|byte| format!("\\x{byte:02x}")).collect::<String>();
    let lines =
        words.iter().filter(|word| (1..30).contains(&word.len())).map(|word| format!("\"{}\"\n", escaped(word)));
    Some(lines.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_target_has_its_line_its_binary_and_seeds() {
        let manifest = std::fs::read_to_string(root().join("fuzz/Cargo.toml")).expect("the manifest");
        let entries = std::fs::read_dir(root().join("fuzz/fuzz_targets")).expect("the targets");
        let mut there: Vec<String> = entries
            .map(|entry| entry.expect("an entry").path().file_stem().expect("a name").to_string_lossy().into_owned())
            .collect();
        there.sort();
        let mut told: Vec<&str> = SEEDS.iter().map(|(name, ..)| *name).collect();
        told.sort_unstable();
        assert_eq!(there, told);
        for (name, seeds, words) in &SEEDS {
            assert!(manifest.contains(&format!("path = \"fuzz_targets/{name}.rs\"")), "{name}");
            let seeds = of(seeds).expect("seeds");
            assert!(!seeds.is_empty(), "{name}");
            if let Some(text) = dictionary(words, &seeds) {
                assert!(text.lines().count() >= 10, "{name}");
                assert!(text.lines().all(|line| line.starts_with("\"\\x") && line.ends_with('"')), "{name}");
            }
        }
    }
}
