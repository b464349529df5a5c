//! `coilsense sweep`.

use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

use anyhow::Context;
use coilsense_lab::report::verbs::CSV;
use coilsense_lab::report::{ReasonRow, RecomputedRow, SweepOutcome, to_json};
use coilsense_lab::request::{Given, JSON, OUT, SPEC};
use coilsense_lab::sweep::request::{CATALOGUE, CHUNK, COLUMNS, JOBS, OVER, ROWS, SAMPLING, SEED};
use coilsense_lab::sweep::{Catalogue, Dataset, Plan, PlanParameters, Sampling, Tally, column_words};

use crate::progress::Watch;
use crate::{files, terminal};

/// Ctrl-C came; the chunks that are there stay.
#[derive(Debug)]
pub struct Interrupted {
    whole: u64,
    of: u64,
}

impl std::fmt::Display for Interrupted {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "interrupted; {} of {} chunks are whole, the same command goes on from there", self.whole, self.of)
    }
}

impl std::error::Error for Interrupted {}

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let (asked, folder) = (plan(given)?, given.needed(&OUT)?);
    let threads = given.count(&JOBS).unwrap_or(0) as usize;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().context("cannot start threads")?;
    let watch = Watch::begin_designs()?;
    terminal::keeps("interrupted; whole chunks stay, the same command goes on from there");
    // Refused before the work where it must not be written.
    let csv = given.file(&CSV);
    csv.map_or(Ok(()), |path| Dataset::check_outside(folder, path))?;
    let table = csv.map(|path| files::one(given, path)).transpose()?;
    let dataset = Dataset::create_or_open(folder, &asked)?;
    // The folder's own, which may call the same spec otherwise: rows are those of an unbroken run.
    let plan = dataset.plan();
    let (missing, damaged) = (dataset.missing()?, dataset.damaged());
    let length = |chunk: &u64| {
        let rows = plan.rows_of(*chunk);
        rows.end - rows.start
    };
    let before = plan.rows() - missing.iter().map(length).sum::<u64>();
    let (done, begun) = (AtomicU64::new(before), Instant::now());
    let go_on = || {
        let done = done.fetch_add(1, Ordering::Relaxed);
        // A bar need not know of every row.
        if done.is_multiple_of(TOLD) { watch.tell_rate(before, done, plan.rows(), begun) } else { !watch.is_stopped() }
    };
    for (index, chunk) in missing.iter().enumerate() {
        let Some(bytes) = pool.install(|| plan.chunk_bytes(*chunk, &go_on))? else {
            watch.end();
            let whole = plan.chunks() - (missing.len() - index) as u64;
            return Err(Interrupted { whole, of: plan.chunks() }.into());
        };
        dataset.write(*chunk, &bytes)?;
    }
    let seconds = begun.elapsed().as_secs_f64();
    watch.end();
    if let Some((mut table, name)) = table {
        table.write(&name, |file| dataset.write_csv(file))?;
        table.commit()?;
    }
    let tally = dataset.tally()?;
    let made = plan.rows() - before;
    let recomputed = damaged
        .into_iter()
        .map(|(chunk, why)| RecomputedRow { file: dataset.path(chunk), because: format!("it {why}") })
        .collect();
    let told = Told { folder, csv, plan, tally: &tally, recomputed, made, seconds };
    let text = if given.holds(&JSON) { to_json(told.outcome())? } else { told.text() };
    Ok(terminal::answer(given, &text)?)
}

/// Rows from one look at the bar to the next.
const TOLD: u64 = 16;

fn plan(given: &Given) -> anyhow::Result<Plan> {
    let catalogue = given.file(&CATALOGUE).map(Catalogue::read).transpose()?;
    let parameters = PlanParameters {
        over: given.texts(&OVER),
        catalogue,
        sampling: given.text(&SAMPLING).and_then(|word| Sampling::named(&word)),
        rows: given.count(&ROWS),
        seed: given.count(&SEED).unwrap_or_default(),
        columns: given.text(&COLUMNS).map_or_else(Vec::new, |words| column_words(&words)),
        chunk_rows: given.count(&CHUNK),
        ..PlanParameters::default()
    };
    Ok(Plan::new(parameters.with_spec(given.needed(&SPEC)?)?)?)
}

/// Most reasons that are shown.
const SHOWN: usize = 3;

/// What a run tells at its end.
struct Told<'a> {
    folder: &'a Path,
    /// All rows as one table, too.
    csv: Option<&'a Path>,
    plan: &'a Plan,
    tally: &'a Tally,
    /// Chunks that were there and not as they had been written.
    recomputed: Vec<RecomputedRow>,
    /// Rows that this run has made.
    made: u64,
    seconds: f64,
}

impl Told<'_> {
    fn text(&self) -> String {
        let Self { plan, tally, made, seconds, .. } = self;
        let folder = self.folder.display();
        let plural = |count: u64, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
        let (rows, files) = (plural(tally.rows, "row"), plural(plan.chunks(), "file"));
        let (ok, clash, refused) = (tally.ok, tally.clash, tally.refused);
        let mut text = format!(
            "{rows} in {folder} ({files}): {ok} ok, {clash} in which windings would touch, {refused} that could not be judged\n"
        );
        if let Some(note) = plan.note() {
            text.push_str(&format!("note: {note}\n"));
        }
        if !self.recomputed.is_empty() {
            let (files, were) =
                (plural(self.recomputed.len() as u64, "file"), if self.recomputed.len() == 1 { "was" } else { "were" });
            text.push_str(&format!("{files} that {were} not as written {were} made anew:\n"));
        }
        for RecomputedRow { file, because } in self.recomputed.iter().take(SHOWN) {
            text.push_str(&format!("  {}: {because}\n", file.display()));
        }
        if self.recomputed.len() > SHOWN {
            text.push_str(&format!("  and {} others\n", self.recomputed.len() - SHOWN));
        }
        for (count, reason) in tally.reasons.iter().take(SHOWN) {
            text.push_str(&format!("  {count} × such as: {reason}\n"));
        }
        if tally.reasons.len() > SHOWN {
            text.push_str(&format!("  and {} other kinds of reasons\n", tally.reasons.len() - SHOWN));
        }
        if *made == 0 {
            text.push_str("all of them were there before\n");
        } else {
            let earlier =
                if *made < tally.rows { format!(", {} from before", tally.rows - made) } else { String::new() };
            let rate = self.rate();
            let peak =
                peak_memory().map_or_else(String::new, |kb| format!(", {} MB of memory at most", kb.div_ceil(1000)));
            text.push_str(&format!(
                "{} in {seconds:.2} s, {rate:.0} a second{peak}{earlier}\n",
                plural(*made, "design")
            ));
        }
        if let Some(csv) = self.csv {
            text.push_str(&format!("all rows as one table: {}\n", csv.display()));
        }
        let quoted = format!("{:?}", self.folder.display().to_string());
        text + &format!("read it: pandas.read_parquet({quoted}), or DuckDB: SELECT * FROM '{folder}/*.parquet'\n")
    }

    fn outcome(&self) -> SweepOutcome<'_> {
        let reasons = self.tally.reasons.iter().map(|(count, reason)| ReasonRow { count: *count, such_as: reason });
        SweepOutcome {
            folder: self.folder,
            digest: self.plan.digest(),
            rows: self.tally.rows,
            ok: self.tally.ok,
            clash: self.tally.clash,
            refused: self.tally.refused,
            reasons: reasons.collect(),
            note: self.plan.note(),
            chunks: self.plan.chunks(),
            recomputed: &self.recomputed,
            made: self.made,
            seconds: self.seconds,
            designs_per_second: self.rate(),
            peak_memory_kb: peak_memory(),
        }
    }

    /// Designs a second.
    fn rate(&self) -> f64 {
        self.made as f64 / self.seconds.max(1e-9)
    }
}

/// The most memory that this process has had \[kB\], where the system says it.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().trim_end_matches("kB").trim().parse().ok()
}
