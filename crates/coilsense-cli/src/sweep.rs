//! `coilsense sweep`.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

use anyhow::Context;
use coilsense_lab::report::{ReasonRow, SweepOutcome, to_json};
use coilsense_lab::sweep::{Catalogue, Dataset, Plan, PlanParameters, Sampling, Tally, column_words};

use crate::progress::Watch;

/// Options of `coilsense sweep`.
#[derive(clap::Args)]
#[command(after_long_help = GRAMMAR)]
pub struct Arguments {
    /// The spec whose values are varied
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    /// What is varied, may be given several times: spring.stiffness="600..900 N/m", mount.damping_ratio="log 1e-3..5e-2"; see below
    #[arg(long, value_name = "KEY=VALUES")]
    over: Vec<String>,
    /// A table whose titles are keys, such as "spring.stiffness [N/m]", and whose rows are designs: CSV or Parquet. With --over, every row of it
    /// meets every row of the sampling
    #[arg(long, value_name = "FILE")]
    catalogue: Option<PathBuf>,
    /// How rows are laid: grid, lhs (Latin hypercube), monte-carlo or sobol; without it a grid where all variables have points, else lhs
    #[arg(long, value_name = "WORD", value_parser = sampling)]
    sampling: Option<Sampling>,
    /// How many rows; a grid has its own number
    #[arg(long, value_name = "COUNT")]
    rows: Option<u64>,
    /// Of all randomness: row k is a function of this seed and k alone
    #[arg(long, value_name = "NUMBER", default_value_t = 0)]
    seed: u64,
    /// What is recorded, with commas between: mass, F_o.rmsd, F_o.max[heel strike], F_L.bias, worst, clearance, laser.combined; see book/src/guide/sweep.md
    #[arg(long, value_name = "WORDS")]
    columns: Option<String>,
    /// Rows of a file; without it by how long a row takes
    #[arg(long, value_name = "COUNT")]
    chunk: Option<u64>,
    /// Threads; without it as many as there are cores
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u64).range(1..=1024))]
    jobs: Option<u64>,
    /// Print the summary as JSON
    #[arg(long)]
    json: bool,
    /// Folder for the manifest and one Parquet file a chunk; a folder of the same sweep is continued
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

const GRAMMAR: &str = "\
KEY is a key of the spec: spring.mass, condition.\"heel strike\".velocity or condition.1.velocity, sensor.laser.delay, goal.error.

VALUES are one of
  600..900 N/m               a range, uniform
  600..900 N/m : 11          eleven points of it, as a grid needs
  log 1e-3..5e-2             a range, uniform in the logarithm
  600, 700, 800 N/m          a list; \"hooks\", \"open\" of texts
  normal(760 N/m, 5 %)       mean and standard deviation, in its unit or in % of the mean
  lognormal(760 N/m, 5 %)    median and standard deviation of the logarithm
  triangular(600, 760, 900 N/m), uniform(600, 900 N/m)
with the units that the spec takes for the key.";

fn sampling(text: &str) -> Result<Sampling, String> {
    let words = Sampling::ALL.map(|(word, _)| word).join(", ");
    Sampling::named(text).ok_or_else(|| format!("must be one of {words}"))
}

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
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let plan = plan(arguments)?;
    let threads = arguments.jobs.unwrap_or(0) as usize;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().context("cannot start threads")?;
    let watch = Watch::begin_designs()?;
    let dataset = Dataset::create_or_open(&arguments.out, &plan)?;
    let missing = dataset.missing();
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
    let tally = dataset.tally()?;
    let made = plan.rows() - before;
    // A reader that closes the pipe early has all it wants.
    let told = Told { folder: &arguments.out, plan: &plan, tally: &tally, made, seconds };
    let text = if arguments.json { to_json(told.outcome())? } else { told.text() };
    let _ = write!(anstream::stdout().lock(), "{text}");
    Ok(())
}

/// Rows from one look at the bar to the next.
const TOLD: u64 = 16;

fn plan(arguments: &Arguments) -> anyhow::Result<Plan> {
    let catalogue = arguments.catalogue.as_deref().map(Catalogue::read).transpose()?;
    let parameters = PlanParameters {
        over: arguments.over.clone(),
        catalogue,
        sampling: arguments.sampling,
        rows: arguments.rows,
        seed: arguments.seed,
        columns: arguments.columns.as_deref().map_or_else(Vec::new, column_words),
        chunk_rows: arguments.chunk,
        ..PlanParameters::default()
    };
    Ok(Plan::new(parameters.with_spec(&arguments.spec)?)?)
}

/// Most reasons that are shown.
const SHOWN: usize = 3;

/// What a run tells at its end.
struct Told<'a> {
    folder: &'a Path,
    plan: &'a Plan,
    tally: &'a Tally,
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
            chunks: self.plan.chunks(),
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
