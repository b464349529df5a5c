//! A progress bar on work of over a second, which stops at its next step where somebody wants it to end.
//!
//! Next door: who wants that (`signals`).

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::{signals, terminal};

/// The bar appears after this long.
const PATIENCE: Duration = Duration::from_secs(1);

/// Watches over long work.
pub struct Watch {
    bar: ProgressBar,
    begun: Instant,
}

impl Watch {
    /// Begins.
    pub fn begin(what: &'static str) -> anyhow::Result<Self> {
        Self::with_template(what, "{msg} [{bar:40}] {pos}/{len}, {eta} left")
    }

    /// The same for designs, of which many a second are done: see [`Self::tell_rate`].
    #[cfg(feature = "files")]
    pub fn begin_designs() -> anyhow::Result<Self> {
        Self::with_template("", "sweeping [{bar:40}] {pos}/{len}, {msg} left")
    }

    fn with_template(message: &'static str, template: &str) -> anyhow::Result<Self> {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        bar.set_style(ProgressStyle::with_template(template)?.progress_chars("=> "));
        bar.set_message(message);
        Ok(Self { bar, begun: Instant::now() })
    }

    /// Shows how much is done; whether to go on.
    pub fn tell(&self, done: usize, of: usize) -> bool {
        self.bar.set_length(of as u64);
        if self.begun.elapsed() > PATIENCE && self.bar.is_hidden() && !terminal::is_quiet() {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.set_position(done as u64);
        !self.is_stopped()
    }

    /// Shows how many designs are done, how many a second since `begun` (when `before` were), and the time left; whether to go on.
    #[cfg(feature = "files")]
    pub fn tell_rate(&self, before: u64, done: u64, of: u64, begun: Instant) -> bool {
        let rate = (done - before) as f64 / begun.elapsed().as_secs_f64().max(1e-9);
        if rate > 0.0 && !self.bar.is_hidden() {
            let left = indicatif::HumanDuration(Duration::from_secs_f64((of - done) as f64 / rate));
            self.bar.set_message(format!("{rate:.0} designs/s, {left:#}"));
        }
        self.tell(done as usize, of as usize)
    }

    /// Removes the bar.
    pub fn end(&self) {
        self.bar.finish_and_clear();
    }

    /// Whether somebody pressed Ctrl-C.
    pub fn is_stopped(&self) -> bool {
        signals::came()
    }
}
