//! `coilsense app`: the page out of this binary, in the user's browser.
//!
//! Next door: what is answered to whom (`server`).

#[cfg(page_is_built)]
mod server;

use coilsense_lab::request::Given;

/// What builds a command that has the page.
#[cfg(not(page_is_built))]
const BUILD: &str = "cargo xtask page && cargo build --release --package coilsense-cli --features app";

/// Serves the page until Ctrl-C.
#[cfg(page_is_built)]
pub fn run(given: &Given) -> anyhow::Result<()> {
    use std::io::Write;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering};

    use anyhow::Context;
    use coilsense_lab::report::verbs::{NO_OPEN, PORT};

    let server =
        Arc::new(server::Server::begin(given.count(&PORT).and_then(|port| u16::try_from(port).ok()).unwrap_or(0))?);
    let stopped = Arc::new(AtomicBool::new(false));
    let (their_server, their_stopped) = (Arc::clone(&server), Arc::clone(&stopped));
    let stop = move || {
        their_stopped.store(true, Ordering::SeqCst);
        their_server.wake();
    };
    ctrlc::set_handler(stop).context("cannot watch for Ctrl-C")?;
    let address = server.address();
    // Whoever has closed the pipe does not want to know.
    let _ = writeln!(anstream::stdout(), "The page is at {address} until Ctrl-C.");
    let _ = anstream::stdout().flush();
    if !given.holds(&NO_OPEN) && open::that_detached(&address).is_err() {
        anstream::eprintln!("no browser was found; open that address in one");
    }
    server.serve(&stopped)
}

/// Says how to get a command that has the page.
#[cfg(not(page_is_built))]
pub fn run(_: &Given) -> anyhow::Result<()> {
    let why = if cfg!(feature = "app") { "web/dist was not there when it was built" } else { "it is built without" };
    anyhow::bail!("this command has no page in it: {why}; from a checkout of coilsense: {BUILD}")
}
