//! Ctrl-C and other wishes that the command end: within a second, whatever it is doing, and nothing half-made stays.
//!
//! Next door: who looks whether one came (`progress`), what is removed (`coilsense_lab::output`), the code that the command ends with (`main`).

use std::sync::atomic::{AtomicBool, AtomicI32, Ordering};
use std::sync::{Mutex, PoisonError, mpsc};
use std::time::Duration;

use coilsense_lab::output;

use crate::terminal;

/// How long the work may take to stop at its next step and say by itself how far it came.
const GRACE: Duration = Duration::from_millis(400);
/// How long it may take to say that the command was interrupted, to whom does not read.
const LAST_WORDS: Duration = Duration::from_millis(100);

/// The signal that came first; 0 before one has.
static CAME: AtomicI32 = AtomicI32::new(0);

/// Whether somebody says how the command ended.
static SAID: AtomicBool = AtomicBool::new(false);

/// Who ends by himself, such as a server; told once.
static STOP: Mutex<Option<Box<dyn Fn() + Send>>> = Mutex::new(None);

/// Whether somebody wants the command to end.
pub fn came() -> bool {
    CAME.load(Ordering::SeqCst) != 0
}

/// The exit code that shells have for a command that the signal ended; none where none came.
pub fn code() -> Option<u8> {
    match CAME.load(Ordering::SeqCst) {
        0 => None,
        signal => u8::try_from(128 + signal).ok(),
    }
}

/// From here on the caller says how the command ended. Where the process is being ended already, this does not return.
pub fn last_word() {
    while SAID.swap(true, Ordering::SeqCst) {
        std::thread::park();
    }
}

/// Calls `stop` when a signal comes, for work that then ends by itself.
#[cfg_attr(not(page_is_built), expect(dead_code, reason = "the page's server is the one that does"))]
pub fn on_stop(stop: impl Fn() + Send + 'static) {
    *STOP.lock().unwrap_or_else(PoisonError::into_inner) = Some(Box::new(stop));
}

/// A signal came. The first leaves the work a moment, the second none.
fn arrived(signal: i32) {
    if CAME.compare_exchange(0, signal, Ordering::SeqCst, Ordering::SeqCst).is_err() {
        leave();
    }
    if let Some(stop) = STOP.lock().unwrap_or_else(PoisonError::into_inner).take() {
        stop();
    }
    std::thread::spawn(|| {
        std::thread::sleep(GRACE);
        leave();
    });
}

/// Ends the process where the work did not end by itself: it may wait for a pipe that nobody fills. Files that are taking their places do so first.
fn leave() -> ! {
    output::abandon();
    let (told, heard) = mpsc::channel();
    std::thread::spawn(move || {
        // Unless the work is just saying it.
        if !SAID.swap(true, Ordering::SeqCst) {
            terminal::refuse_undone();
            let _ = told.send(());
        } else {
            std::thread::sleep(LAST_WORDS);
        }
    });
    let _ = heard.recv_timeout(LAST_WORDS);
    std::process::exit(code().map_or(1, i32::from))
}

/// From here on signals are answered. Those that are ignored when the command starts stay so, as `nohup` and shells' background jobs want it.
///
/// # Errors
/// What the system says.
#[cfg(unix)]
pub fn watch() -> std::io::Result<()> {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;

    let ignored = ignored();
    let mut signals = Signals::new([SIGINT, SIGTERM, SIGHUP].into_iter().filter(|signal| !ignored(*signal)))?;
    std::thread::Builder::new().name("signals".to_owned()).spawn(move || signals.forever().for_each(arrived))?;
    Ok(())
}

/// Which signals are ignored, where the system says it.
#[cfg(unix)]
fn ignored() -> impl Fn(i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or_default();
    move |signal| mask >> (signal - 1) & 1 == 1
}

/// From here on Ctrl-C is answered.
///
/// # Errors
/// What the system says.
#[cfg(not(unix))]
pub fn watch() -> std::io::Result<()> {
    const INTERRUPT: i32 = 2;
    ctrlc::set_handler(|| arrived(INTERRUPT)).map_err(std::io::Error::other)
}
