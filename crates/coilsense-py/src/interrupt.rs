//! Long work that Ctrl-C ends: it runs on a thread of its own, and Python looks for signals meanwhile.
//!
//! Next door: work that can be stopped at a step of its own (`rig`).

use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// How long Ctrl-C may wait.
const PATIENCE: Duration = Duration::from_millis(50);

/// What the work gives. On Ctrl-C it is left alone: it ends by itself, nobody takes what it gives, and nothing of it is on disk.
///
/// # Errors
/// `KeyboardInterrupt` and what else a handler of signals raises.
pub fn interruptible<T: Send + 'static>(py: Python<'_>, work: impl FnOnce() -> T + Send + 'static) -> PyResult<T> {
    let (give, take) = channel();
    // Where nobody takes it any more there is nothing to be done.
    let worker = thread::Builder::new().name("coilsense".to_owned()).spawn(move || give.send(work()).unwrap_or(()));
    worker.map_err(|error| PyRuntimeError::new_err(format!("no thread can be started: {error}")))?;
    let take = std::sync::Mutex::new(take);
    loop {
        // The lock is this thread's alone; it only says so to Python, under which threads may change.
        let received =
            py.detach(|| take.lock().map_or(Err(RecvTimeoutError::Disconnected), |take| take.recv_timeout(PATIENCE)));
        match received {
            Ok(given) => return Ok(given),
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("coilsense: a computation broke off; please report it"));
            }
        }
    }
}
