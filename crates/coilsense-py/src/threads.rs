//! Threads that a call spreads over: a pool of this process's own.
//!
//! A process that was forked has the pool of its parent, rayon's global one among them, but none of its threads: who waits for them waits for
//! ever. So each process makes its own on first use, and everything of this door that may compute on several threads does so inside it.
//! Next door: work that tells how far it is and stops on Ctrl-C (`long_work`).

use std::mem::forget;
use std::process;
use std::sync::{Arc, Mutex, PoisonError};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// A pool and the process whose threads it has.
struct Own {
    process: u32,
    pool: Arc<ThreadPool>,
}

/// Only ever locked while the interpreter's lock is held, under which Python forks: no child finds it locked by a thread that it lacks.
static OWN: Mutex<Option<Own>> = Mutex::new(None);

/// The pool of this process, with as many threads as there are cores (or as `RAYON_NUM_THREADS` says).
///
/// # Errors
/// `RuntimeError` where threads cannot be started.
pub fn pool(_py: Python<'_>) -> PyResult<Arc<ThreadPool>> {
    let mut own = OWN.lock().unwrap_or_else(PoisonError::into_inner);
    let process = process::id();
    match own.take() {
        Some(kept) if kept.process == process => Ok(own.insert(kept).pool.clone()),
        parents => {
            // The parent's threads cannot be told to end from here, and telling them would wait for locks that they may hold.
            forget(parents);
            let pool = Arc::new(of(0)?);
            Ok(own.insert(Own { process, pool }).pool.clone())
        }
    }
}

/// A pool of so many threads; of 0, as many as there are cores.
///
/// # Errors
/// `RuntimeError` where threads cannot be started.
pub fn of(threads: usize) -> PyResult<ThreadPool> {
    let made =
        ThreadPoolBuilder::new().num_threads(threads).thread_name(|number| format!("coilsense {number}")).build();
    made.map_err(|error| PyRuntimeError::new_err(format!("no threads can be started: {error}")))
}

/// Leaves the pool to the work that is in it, which nobody waits for any more: what comes next has threads of its own.
pub fn left_behind(_py: Python<'_>) {
    OWN.lock().unwrap_or_else(PoisonError::into_inner).take();
}

/// What work gives that may spread over threads, the interpreter's lock let go.
///
/// # Errors
/// As [`pool`].
pub fn spread<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let pool = pool(py)?;
    Ok(py.detach(|| pool.install(work)))
}
