//! `coilsense app`: the page out of this binary, in the user's browser.
//!
//! Next door: what is answered to whom (`server`), how it is carried (`http`).

#[cfg(page_is_built)]
mod http;
#[cfg(page_is_built)]
mod server;

use coilsense_lab::request::Given;

/// What builds a command that has the page.
#[cfg(not(page_is_built))]
const BUILD: &str = "cargo xtask page && cargo build --release --package coilsense-cli --features app";

/// Serves the page until Ctrl-C.
#[cfg(page_is_built)]
pub fn run(given: &Given) -> anyhow::Result<()> {
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering};

    use coilsense_lab::report::verbs::{NO_OPEN, PORT};

    use crate::{signals, terminal};

    let server =
        Arc::new(server::Server::begin(given.count(&PORT).and_then(|port| u16::try_from(port).ok()).unwrap_or(0))?);
    let stopped = Arc::new(AtomicBool::new(false));
    let (their_server, their_stopped) = (Arc::clone(&server), Arc::clone(&stopped));
    let stop = move || {
        their_stopped.store(true, Ordering::SeqCst);
        their_server.wake();
    };
    signals::on_stop(stop);
    let address = server.address();
    terminal::say(&format!("The page is at {address} until Ctrl-C.\n"))?;
    if !given.holds(&NO_OPEN) && open::that_detached(&address).is_err() {
        terminal::tell("no browser was found; open that address in one");
    }
    server.serve(&stopped);
    Ok(())
}

/// Says how to get a command that has the page.
#[cfg(not(page_is_built))]
pub fn run(_: &Given) -> anyhow::Result<()> {
    let why = if cfg!(feature = "app") { "web/dist was not there when it was built" } else { "it is built without" };
    anyhow::bail!("this command has no page in it: {why}; from a checkout of coilsense: {BUILD}")
}
