//! Long work: done on a thread of its own, while the caller's thread tells how far it is and lets Ctrl-C through.
//!
//! Python handles signals on its main thread only, so that thread must not be the one that computes.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

use pyo3::prelude::*;

/// How often the caller's thread looks up.
const LOOK: Duration = Duration::from_millis(50);

/// Told how much is done, and of how much; whether to go on.
pub type Progress<'a> = dyn Fn(usize, usize) -> bool + Sync + 'a;

/// How far the work is.
#[derive(Default)]
struct Watch {
    done: AtomicUsize,
    of: AtomicUsize,
    stopped: AtomicBool,
}

/// Does `work`, which is told by its argument whether to go on; `tell` is Python's `progress(done, of)`.
///
/// An exception, be it of `tell` or a keyboard interrupt, stops the work at its next step and is what comes out.
pub fn watched<T: Send>(
    py: Python<'_>,
    tell: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Progress<'_>) -> T + Send,
) -> PyResult<T> {
    let watch = Watch::default();
    std::thread::scope(|scope| {
        let (sender, mut receiver) = channel();
        let worker = scope.spawn(|| {
            let sender = sender;
            let result = work(&|done, of| watch.heard(done, of));
            // Nobody hangs up before the work has ended.
            let _ = sender.send(());
            result
        });
        let mut raised = None;
        let mut told = None;
        while let Some(waiting) = still_working(py, receiver) {
            receiver = waiting;
            if raised.is_none() {
                raised = py.check_signals().and_then(|()| watch.tell(tell, &mut told)).err();
                watch.stopped.store(raised.is_some(), Ordering::Relaxed);
            }
        }
        let result = py.detach(|| worker.join()).unwrap_or_else(|panic| resume_unwind(panic));
        if raised.is_none() {
            raised = py.check_signals().and_then(|()| watch.tell(tell, &mut told)).err();
        }
        raised.map_or(Ok(result), Err)
    })
}

/// Waits a moment; nothing once the work has ended.
fn still_working(py: Python<'_>, receiver: Receiver<()>) -> Option<Receiver<()>> {
    let (receiver, news) = py.detach(move || {
        let news = receiver.recv_timeout(LOOK);
        (receiver, news)
    });
    (news == Err(RecvTimeoutError::Timeout)).then_some(receiver)
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
