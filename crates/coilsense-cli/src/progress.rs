//! A progress bar on work of over a second, and Ctrl-C that lets go cleanly.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use anyhow::Context;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Whether somebody pressed Ctrl-C.
static STOPPED: AtomicBool = AtomicBool::new(false);

/// The bar appears after this long.
const PATIENCE: Duration = Duration::from_secs(1);

/// Watches over long work.
pub struct Watch {
    bar: ProgressBar,
    begun: Instant,
}

impl Watch {
    /// From here on Ctrl-C stops the work at its next step, so that what it had begun to write is removed.
    pub fn begin(what: &'static str) -> anyhow::Result<Self> {
        ctrlc::set_handler(|| STOPPED.store(true, Ordering::SeqCst)).context("cannot watch for Ctrl-C")?;
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        let style = ProgressStyle::with_template("{msg} [{bar:40}] {pos}/{len}, {eta} left")?;
        bar.set_style(style.progress_chars("=> "));
        bar.set_message(what);
        Ok(Self { bar, begun: Instant::now() })
    }

    /// Shows how much is done; whether to go on.
    pub fn tell(&self, done: usize, of: usize) -> bool {
        self.bar.set_length(of as u64);
        if self.begun.elapsed() > PATIENCE && self.bar.is_hidden() {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.set_position(done as u64);
        !self.is_stopped()
    }

    /// Removes the bar.
    pub fn end(&self) {
        self.bar.finish_and_clear();
    }

    /// Whether somebody pressed Ctrl-C.
    pub fn is_stopped(&self) -> bool {
        STOPPED.load(Ordering::SeqCst)
    }
}
