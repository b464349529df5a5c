//! Tables of README and book that are made of measurements: `cargo xtask bench --keep` and `--sweep --keep` leave their rows in `book/measured`, with
//! the day, the machine and the compiler, and write the tables; a test holds each table to its record, so that none of their figures is typed.
//!
//! Next door: the measurements (`bench`, `sweep`), what they are judged by (`goals`).

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, bail};
use serde::{Deserialize, Serialize, de::DeserializeOwned};

use crate::bench::{ANALYZE, IDENTIFY, Row, WHOLE};
use crate::sweep::Designs;
use crate::{goals, root};

/// Rows that were measured together.
#[derive(Deserialize)]
struct Record<T> {
    /// The day, as ISO 8601 has it.
    date: String,
    /// The processor and how many threads it runs at a time.
    machine: String,
    compiler: String,
    rows: Vec<T>,
}

/// What `cargo xtask bench` leaves.
pub const BENCH: &str = "bench.json";
/// What `cargo xtask bench --sweep` leaves.
pub const DESIGNS: &str = "designs.json";

/// The peers' jobs, and what a table calls them.
const JOBS: [(&str, &str); 4] =
    [("impact", "heel strike"), ("end-stop", "end stop"), ("resonance", "resonance"), ("recorded", "recorded input")];
/// The peer that README names.
const BESIDE: (&str, &str) = ("SciPy", "signal.lsim");

/// Keeps rows as measured here and now, and writes what is made of them.
pub fn keep<T: Serialize>(name: &str, rows: &[T]) -> anyhow::Result<()> {
    let date = time::OffsetDateTime::now_utc().date().to_string();
    let record = serde_json::json!({ "date": date, "machine": machine(), "compiler": compiler()?, "rows": rows });
    let path = folder().join(name);
    std::fs::create_dir_all(folder())?;
    std::fs::write(&path, serde_json::to_string_pretty(&record)? + "\n")
        .with_context(|| format!("{} cannot be written", path.display()))?;
    write()
}

/// Writes every table into its page.
pub fn write() -> anyhow::Result<()> {
    for (page, text) in pages()? {
        std::fs::write(root().join(page), text).with_context(|| format!("{page} cannot be written"))?;
        println!("{page}");
    }
    Ok(())
}

/// The pages that have such tables, as they should be.
fn pages() -> anyhow::Result<Vec<(&'static str, String)>> {
    let (bench, designs) = (record::<Row>(BENCH)?, record::<Designs>(DESIGNS)?);
    let accuracy = [
        ("peers", peers(&bench)),
        ("inductance", beside(&bench, &["inductance", "mutual"], "error")),
        ("contact", beside(&bench, &["valve", "valve-48", "contact"], "error of rms(F_o − F_i)")),
        ("helix", of_ours(&bench, |row| row.job == "helix")),
        ("commands", of_ours(&bench, |row| row.setting.starts_with(WHOLE))),
        ("goals", judged(&bench)),
        ("designs", designed(&designs)),
    ];
    let readme = [("fast", fast(&bench, &designs)?)];
    Ok(vec![with(ACCURACY, &accuracy)?, with("README.md", &readme)?])
}

const ACCURACY: &str = "book/src/accuracy.md";

/// A page with tables put in between their marks.
fn with(page: &'static str, tables: &[(&str, String)]) -> anyhow::Result<(&'static str, String)> {
    let mut text = std::fs::read_to_string(root().join(page)).with_context(|| format!("{page} cannot be read"))?;
    for (name, table) in tables {
        let (begin, end) = (format!("<!-- made: {name} -->\n"), format!("\n<!-- end: {name} -->\n"));
        let parts = text.split_once(&begin).and_then(|(before, rest)| Some((before, rest.split_once(&end)?.1)));
        let Some((before, after)) = parts else { bail!("{page} has no place for the table {name}") };
        text = format!("{before}{begin}{table}{end}{after}");
    }
    Ok((page, text))
}

fn folder() -> PathBuf {
    root().join("book/measured")
}

fn record<T: DeserializeOwned>(name: &str) -> anyhow::Result<Record<T>> {
    let path = folder().join(name);
    let text = std::fs::read_to_string(&path).with_context(|| format!("{} cannot be read", path.display()))?;
    serde_json::from_str(&text).with_context(|| format!("{} is no record", path.display()))
}

/// A table of Markdown.
fn table(head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let head: Vec<String> = head.iter().map(|cell| (*cell).to_owned()).collect();
    let rule = format!("|{}\n", "---|".repeat(head.len()));
    std::iter::once(line(&head)).chain([rule]).chain(rows.into_iter().map(|row| line(&row))).collect()
}

/// Whoever was measured on the jobs of S_T, the quickest first, by time, error and ratio.
fn peers(bench: &Record<Row>) -> String {
    let is_asked = |row: &&Row| JOBS.iter().any(|(job, _)| row.job == *job);
    let mut who: Vec<(&str, &str)> = Vec::new();
    for row in bench.rows.iter().filter(is_asked) {
        let one = (row.system.as_str(), row.setting.as_str());
        if !who.contains(&one) {
            who.push(one);
        }
    }
    let found = |(system, setting): (&str, &str), job: &str| {
        bench
            .rows
            .iter()
            .find(|row| (row.job.as_str(), row.system.as_str(), row.setting.as_str()) == (job, system, setting))
    };
    let time = |one| found(one, JOBS[0].0).and_then(|row| row.median_ms).unwrap_or(f64::INFINITY);
    who.sort_by(|a, b| time(*a).total_cmp(&time(*b)));
    let head: Vec<&str> =
        std::iter::once("S_T, 1 s at 10 kHz, both end forces").chain(JOBS.map(|(_, name)| name)).collect();
    let rows = who.into_iter().map(|one| {
        let cells = JOBS.map(|(job, _)| found(one, job).map_or_else(|| "–".to_owned(), cell));
        std::iter::once(named(one.0, one.1)).chain(cells).collect()
    });
    table(&head, rows) + &place(bench)
}

/// A system and how it is set, with units as people write them.
fn named(system: &str, setting: &str) -> String {
    format!("{system}, {setting}").replace(" us", " µs")
}

/// Time, error over the peak, and time over ours, each on a line that does not break; or why there is none.
fn cell(row: &Row) -> String {
    let Some(median) = row.median_ms else { return row.note.clone() };
    let error = row.max_rel_error.map(|error| format!("{error:.0e}").replace('-', "\u{2011}"));
    let ratio = row.ratio.map(|ratio| format!("{}×", three(ratio)));
    let parts = [Some(format!("{}\u{a0}ms", three(median))), error, ratio];
    parts.into_iter().flatten().collect::<Vec<_>>().join("<br>")
}

/// Some jobs, by whoever was measured on them.
fn beside(bench: &Record<Row>, jobs: &[&str], error: &str) -> String {
    let rows = bench.rows.iter().filter(|row| jobs.contains(&row.job.as_str()));
    let rows = rows.map(|row| vec![row.job.clone(), named(&row.system, &row.setting), cell(row)]);
    table(&["job", "by", &format!("time, {error}, time over ours")], rows) + &place(bench)
}

/// Jobs of ours alone.
fn of_ours(bench: &Record<Row>, is_asked: impl Fn(&Row) -> bool) -> String {
    let rows = bench.rows.iter().filter(|row| row.system == "coilsense" && is_asked(row));
    let time = |row: &Row| row.median_ms.map_or_else(|| "–".to_owned(), |median| format!("{} ms", three(median)));
    let rows = rows.map(|row| vec![row.job.clone(), row.setting.clone(), time(row)]);
    table(&["job", "what", "time"], rows) + &place(bench)
}

/// Every goal of the benchmark.
fn judged(bench: &Record<Row>) -> String {
    let rows = goals::judged(&bench.rows);
    let rows = rows.into_iter().map(|goal| vec![goal.what, if goal.met { "met" } else { "**missed**" }.to_owned()]);
    table(&["measured, and the goal", "result"], rows) + &place(bench)
}

/// Designs a second.
fn designed(designs: &Record<Designs>) -> String {
    let rows = designs.rows.iter().map(|row| {
        vec![
            row.columns.clone(),
            format!("{:.0}", row.one_core),
            format!("{:.0}{}", row.wanted, if row.one_core < row.wanted { ": missed" } else { "" }),
            format!("{:.2} times", row.two_cores / row.one_core),
        ]
    });
    table(&["columns", "designs a second on one core", "goal", "on two cores"], rows) + &place(designs)
}

/// How fast, as README has it.
fn fast(bench: &Record<Row>, designs: &Record<Designs>) -> anyhow::Result<String> {
    let median = |job: &str, by: &dyn Fn(&Row) -> bool| {
        let row = bench.rows.iter().find(|row| row.job == job && by(row)).and_then(|row| row.median_ms);
        row.with_context(|| format!("{BENCH} has no {job}"))
    };
    let time = |job: &str, by: &dyn Fn(&Row) -> bool| median(job, by).map(three);
    let ours = |row: &Row| row.system == "coilsense";
    let theirs = |row: &Row| (row.system.as_str(), row.setting.as_str()) == BESIDE;
    let [forces, .., with_inductance] = designs.rows.as_slice() else { bail!("{DESIGNS} has no rows") };
    let rows = [
        vec![
            "both end forces of S_T over 1 s at 10 kHz, heel strike".to_owned(),
            format!("{} ms", time("impact", &ours)?),
            format!(
                "{} `{}` {} ms ([peers]({ACCURACY}#speed-beside-other-tools))",
                BESIDE.0,
                BESIDE.1,
                time("impact", &theirs)?
            ),
        ],
        vec![
            "a design in a sweep, five conditions".to_owned(),
            format!("{:.0} a second and core", forces.one_core),
            format!("with the exact F_L {:.0} ([designs]({ACCURACY}#designs-a-second))", with_inductance.one_core),
        ],
        vec![
            "a log of 150 000 rows, five channels, read and identified".to_owned(),
            format!("{:.2} s", 1e-3 * median(IDENTIFY, &ours)?),
            format!(
                "the ankle's analysis, report and all: {:.2} s ([commands]({ACCURACY}#whole-commands))",
                1e-3 * median(&format!("{ANALYZE}sea-ankle"), &ours)?
            ),
        ],
    ];
    Ok(table(&["what", &format!("time ({}, {})", bench.machine, bench.date), "beside"], rows))
}

/// Three digits, as a person writes them.
fn three(value: f64) -> String {
    let decimals = if value > 0.0 { (2.0 - value.log10().floor()).clamp(0.0, 6.0) as usize } else { 0 };
    format!("{value:.decimals$}")
}

/// Where and when.
fn place<T>(record: &Record<T>) -> String {
    format!("\n*{}, {}, {}.*\n", record.date, record.machine, record.compiler)
}

/// This machine, by what Linux tells of it.
fn machine() -> String {
    let told = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = told.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let name = model.map_or(std::env::consts::ARCH, |(_, name)| name).trim().to_owned();
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    format!("{threads} threads of {name}")
}

fn compiler() -> anyhow::Result<String> {
    let output = Command::new("rustc").arg("--version").current_dir(root()).output().context("rustc")?;
    let said = String::from_utf8_lossy(&output.stdout);
    Ok(said.split(' ').take(2).collect::<Vec<_>>().join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_table_is_that_of_its_record() {
        for (page, text) in pages().expect("the records and the pages") {
            let is = std::fs::read_to_string(root().join(page)).expect("a page");
            assert!(is == text, "{page} is not what the records give; write it with: cargo xtask tables");
        }
    }

    #[test]
    fn figures_have_three_digits_as_a_person_writes_them() {
        assert_eq!([0.0351, 12.345, 999.6, 24_735.0].map(three), ["0.0351", "12.3", "1000", "24735"]);
    }
}
