//! `coilsense app`: the page out of this binary, in the user's browser.
//!
//! Next door: what is answered to whom (`server`).

#[cfg(page_is_built)]
mod server;

/// What builds a command that has the page.
#[cfg(not(page_is_built))]
const BUILD: &str = "cargo xtask page && cargo build --release --package coilsense-cli --features app";

/// Options of `coilsense app`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Port of 127.0.0.1 on which the page is; without it, a free one
    #[arg(long, value_name = "PORT", default_value_t = 0)]
    port: u16,
    /// Only say where the page is
    #[arg(long)]
    no_open: bool,
}

/// Serves the page until Ctrl-C.
#[cfg(page_is_built)]
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    use std::io::Write;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering};

    use anyhow::Context;

    let server = Arc::new(server::Server::begin(arguments.port)?);
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
    if !arguments.no_open && open::that_detached(&address).is_err() {
        anstream::eprintln!("no browser was found; open that address in one");
    }
    server.serve(&stopped)
}

/// Says how to get a command that has the page.
#[cfg(not(page_is_built))]
pub fn run(_: &Arguments) -> anyhow::Result<()> {
    let why = if cfg!(feature = "app") { "web/dist was not there when it was built" } else { "it is built without" };
    anyhow::bail!("this command has no page in it: {why}; from a checkout of coilsense: {BUILD}")
}
