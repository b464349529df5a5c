//! Long work: done on a thread of its own, while the caller's thread looks up every so often and lets Ctrl-C through.
//!
//! Python handles signals on its main thread only, so that thread must not be the one that computes. Work with steps of its own tells how far it
//! is and stops at the next one ([`watched`]); work without is left alone on Ctrl-C ([`interruptible`], [`of_series`]), or done value by value ([`each`]). Either spreads over the threads of
//! `threads`.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use pyo3::PyClass;
use pyo3::exceptions::{PyRuntimeError, PyTypeError};
use pyo3::prelude::*;
use pyo3::pyclass::boolean_struct::True;
use rayon::ThreadPool;

use crate::threads;

/// How often the caller's thread looks up, and so how long Ctrl-C may wait.
const LOOK: Duration = Duration::from_millis(50);

/// Told how much is done, and of how much; whether to go on.
pub type Progress<'a> = dyn Fn(usize, usize) -> bool + Sync + 'a;

/// What a thread sends, while `look` is called every so often; `None` where it ended without sending.
///
/// # Errors
/// What `look` raises: then nobody waits any longer.
fn awaited<T: Send>(
    py: Python<'_>,
    mut receiver: Receiver<T>,
    mut look: impl FnMut() -> PyResult<()>,
) -> PyResult<Option<T>> {
    loop {
        let (back, news) = py.detach(move || {
            let news = receiver.recv_timeout(LOOK);
            (receiver, news)
        });
        receiver = back;
        match news {
            Ok(sent) => return Ok(Some(sent)),
            Err(RecvTimeoutError::Timeout) => look()?,
            Err(RecvTimeoutError::Disconnected) => return Ok(None),
        }
    }
}

/// What the work gives. On Ctrl-C it is left alone: it ends by itself, nobody takes what it gives, and nothing of it is on disk.
///
/// # Errors
/// `KeyboardInterrupt` and what else a handler of signals raises.
pub fn interruptible<T: Send + 'static>(py: Python<'_>, work: impl FnOnce() -> T + Send + 'static) -> PyResult<T> {
    let (give, take) = channel();
    let pool = threads::pool(py)?;
    // Where nobody takes it any more there is nothing to be done.
    let work = move || give.send(pool.install(work)).unwrap_or(());
    let worker = thread::Builder::new().name("coilsense".to_owned()).spawn(work);
    worker.map_err(|error| PyRuntimeError::new_err(format!("no thread can be started: {error}")))?;
    let given = awaited(py, take, || py.check_signals().inspect_err(|_| threads::left_behind(py)))?;
    given.ok_or_else(|| PyRuntimeError::new_err("coilsense: a computation broke off; please report it"))
}

/// From so many steps of some nanoseconds on, a call is worth a thread and a copy of what it takes.
pub const MANY: usize = 4_000_000;

/// What a noun gives for a series: at once where that is little work, and else on a thread that Ctrl-C leaves behind.
///
/// # Errors
/// As [`interruptible`].
pub fn of_series<C, T>(
    noun: &Bound<'_, C>,
    steps: usize,
    series: &[f64],
    work: impl FnOnce(&C, &[f64]) -> T + Send + 'static,
) -> PyResult<T>
where
    C: PyClass<Frozen = True> + Sync,
    T: Send + 'static,
{
    let py = noun.py();
    if steps < MANY {
        let noun = noun.get();
        return Ok(py.detach(|| work(noun, series)));
    }
    let (noun, series) = (noun.clone().unbind(), series.to_vec());
    interruptible(py, move || work(noun.get(), &series))
}

/// What each value of a series gives, one after the other, as [`taken`].
///
/// # Errors
/// As [`taken`].
pub fn each<T: Send>(py: Python<'_>, series: &[f64], of: impl Fn(f64) -> T + Sync) -> PyResult<Vec<T>> {
    taken(py, &mut series.iter().map(|value| of(*value)), series.len())
}

/// The next values of an iterator, as many as there are up to `count`, with a look for signals every so often.
///
/// # Errors
/// `KeyboardInterrupt` and what else a handler of signals raises; what was taken is lost then.
pub fn taken<T: Send>(py: Python<'_>, from: &mut (impl Iterator<Item = T> + Send), count: usize) -> PyResult<Vec<T>> {
    // Who asks for a number that no memory holds is told so by Ctrl-C, not by an abort.
    let mut given = Vec::with_capacity(count.min(MANY));
    loop {
        let before = given.len();
        py.detach(|| {
            let begun = Instant::now();
            while given.len() < count && begun.elapsed() < LOOK {
                given.extend(from.by_ref().take(64.min(count - given.len())));
            }
        });
        py.check_signals()?;
        if given.len() == count || given.len() == before {
            return Ok(given);
        }
    }
}

/// Does `work`, which is told by its argument whether to go on; `tell` is Python's `progress(done, of)`.
///
/// An exception, be it of `tell` or a keyboard interrupt, stops the work at its next step and is what comes out.
pub fn watched<T: Send>(
    py: Python<'_>,
    tell: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Progress<'_>) -> T + Send,
) -> PyResult<T> {
    let pool = threads::pool(py)?;
    watched_in(&pool, py, tell, work)
}

/// The same on the threads of a pool.
pub fn watched_in<T: Send>(
    pool: &ThreadPool,
    py: Python<'_>,
    tell: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Progress<'_>) -> T + Send,
) -> PyResult<T> {
    if let Some(tell) = tell.filter(|tell| !tell.is_callable()) {
        let class = tell.get_type().name()?;
        return Err(PyTypeError::new_err(format!("progress must be a function of (done, of), got {class}")));
    }
    let watch = Watch::default();
    let (mut raised, mut told) = (None, None);
    let mut look = |raised: &mut Option<PyErr>| {
        if raised.is_none() {
            *raised = py.check_signals().and_then(|()| watch.tell(tell, &mut told)).err();
            watch.stopped.store(raised.is_some(), Ordering::Relaxed);
        }
    };
    let result = thread::scope(|scope| {
        let (sender, receiver) = channel();
        let worker = scope.spawn(|| {
            let sender = sender;
            let result = pool.install(|| work(&|done, of| watch.heard(done, of)));
            // Nobody hangs up before the work has ended.
            let _ = sender.send(());
            result
        });
        // The work is waited for whatever is raised: it stops at its next step, and nothing happens after this function.
        awaited(py, receiver, || {
            look(&mut raised);
            Ok(())
        })?;
        Ok::<_, PyErr>(py.detach(|| worker.join()).unwrap_or_else(|panic| resume_unwind(panic)))
    })?;
    look(&mut raised);
    raised.map_or(Ok(result), Err)
}

/// How far the work is.
#[derive(Default)]
struct Watch {
    done: AtomicUsize,
    of: AtomicUsize,
    stopped: AtomicBool,
}

impl Watch {
    fn heard(&self, done: usize, of: usize) -> bool {
        self.done.store(done, Ordering::Relaxed);
        self.of.store(of, Ordering::Relaxed);
        !self.stopped.load(Ordering::Relaxed)
    }

    /// Tells Python where that has changed.
    fn tell(&self, tell: Option<&Bound<'_, PyAny>>, told: &mut Option<(usize, usize)>) -> PyResult<()> {
        let now = (self.done.load(Ordering::Relaxed), self.of.load(Ordering::Relaxed));
        if let Some(tell) = tell.filter(|_| now.1 > 0 && *told != Some(now)) {
            *told = Some(now);
            tell.call1(now)?;
        }
        Ok(())
    }
}
