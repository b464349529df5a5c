//! Files of the page over HTTP, to this machine alone.
//!
//! Next door: who starts it (`app`), how requests and answers are carried (`http`), where the files are made (`cargo xtask page`).

use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::sync::atomic::AtomicBool;

use anyhow::{Context, anyhow};
use coilsense_lab::system;

use super::http::{self, Answer, Request, refusal};

/// The files, as they were when this was compiled. A name that is none of theirs is nothing here: no path of a request ever meets the disk.
#[derive(rust_embed::Embed)]
#[folder = "../../web/dist/"]
struct Page;

/// The page asks nobody but its own origin, and its engine is compiled from there; the browser sees to it.
const POLICY: &str = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; \
    base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// What listens.
pub struct Server {
    listener: TcpListener,
    port: u16,
}

impl Server {
    /// Listens on a port of this machine's loopback; 0 is a free one.
    pub fn begin(port: u16) -> anyhow::Result<Self> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port));
        let refused = |error: std::io::Error| {
            anyhow!("--port {port}: 127.0.0.1:{port} cannot be listened on: {}", system::said(&error))
        };
        let listener = listener.map_err(refused)?;
        let port = listener.local_addr().context("no port was given")?.port();
        Ok(Self { listener, port })
    }

    /// Where the page is.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/", self.port)
    }

    /// Ends the wait for the next connection.
    pub fn wake(&self) {
        let _ = TcpStream::connect((Ipv4Addr::LOCALHOST, self.port));
    }

    /// Answers until it is stopped and woken.
    pub fn serve(&self, stopped: &AtomicBool) {
        let port = self.port;
        http::serve(&self.listener, stopped, move |request| answer(request, port));
    }
}

/// The file that is asked for. A page of another site that has its name point at this machine is told by the Host it sends.
fn answer(request: &Request, port: u16) -> Answer {
    let names = ["127.0.0.1", "localhost"].map(|name| format!("{name}:{port}"));
    if !request.host.as_deref().is_some_and(|host| names.iter().any(|name| name == host)) {
        return guarded(refusal(403, "the page is for this machine only"));
    }
    if !["GET", "HEAD"].contains(&request.method.as_str()) {
        let mut answer = guarded(refusal(405, "the page is only read"));
        answer.headers.push(("Allow", "GET, HEAD"));
        return answer;
    }
    let path = request.target.split(['?', '#']).next().unwrap_or_default();
    let name = path.strip_prefix('/').map(|name| if name.is_empty() { "index.html" } else { name });
    guarded(match name.and_then(|name| Page::get(name).map(|file| (name, file))) {
        Some((name, file)) => {
            Answer { status: 200, headers: vec![("Content-Type", content_type(name))], body: file.data }
        }
        None => refusal(404, "no such file in the page"),
    })
}

/// With what browsers keep to.
fn guarded(mut answer: Answer) -> Answer {
    answer.headers.extend([
        ("X-Content-Type-Options", "nosniff"),
        ("Content-Security-Policy", POLICY),
        ("Cross-Origin-Resource-Policy", "same-origin"),
        // Another version may be on this port tomorrow.
        ("Cache-Control", "no-cache"),
    ]);
    answer
}

/// By the name's ending; a browser compiles an engine only of its own type.
fn content_type(name: &str) -> &'static str {
    match name.rsplit_once('.').map_or("", |(_, ending)| ending) {
        "html" => "text/html; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "csv" => "text/csv; charset=utf-8",
        "svg" => "image/svg+xml",
        "wasm" => "application/wasm",
        _ => "application/octet-stream",
    }
}
