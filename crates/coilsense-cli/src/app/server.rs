//! Files of the page over HTTP, to this machine alone.
//!
//! Next door: who starts it (`app`), where the files are made (`cargo xtask page`).

use std::borrow::Cow;
use std::io::Cursor;
use std::net::Ipv4Addr;
use std::sync::atomic::{AtomicBool, Ordering};

use anyhow::{Context, anyhow};
use tiny_http::{Header, Method, Request, Response};

/// The files, as they were when this was compiled. A name that is none of theirs is nothing here: no path of a request ever meets the disk.
#[derive(rust_embed::Embed)]
#[folder = "../../web/dist/"]
struct Page;

/// The page asks nobody but its own origin, and its engine is compiled from there; the browser sees to it.
const POLICY: &str = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; \
    base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// What listens.
pub struct Server {
    http: tiny_http::Server,
    port: u16,
}

impl Server {
    /// Listens on a port of this machine's loopback; 0 is a free one.
    pub fn begin(port: u16) -> anyhow::Result<Self> {
        let http = tiny_http::Server::http((Ipv4Addr::LOCALHOST, port));
        let http = http.map_err(|error| anyhow!("--port {port}: 127.0.0.1:{port} cannot be listened on: {error}"))?;
        let port = http.server_addr().to_ip().context("no port was given")?.port();
        Ok(Self { http, port })
    }

    /// Where the page is.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/", self.port)
    }

    /// Ends the wait for the next request.
    pub fn wake(&self) {
        self.http.unblock();
    }

    /// Answers until it is woken and stopped.
    pub fn serve(&self, stopped: &AtomicBool) -> anyhow::Result<()> {
        loop {
            match self.http.recv() {
                Ok(request) => {
                    let answer = answer(request.method(), request.url(), host(&request), self.port);
                    // A reader that is slow, or gone, must not keep the next one waiting.
                    std::thread::spawn(move || request.respond(answer));
                }
                Err(_) if stopped.load(Ordering::SeqCst) => return Ok(()),
                Err(error) => return Err(error).context("the page is no more served"),
            }
        }
    }
}

type Answer = Response<Cursor<Cow<'static, [u8]>>>;

/// The file that is asked for. A page of another site that has its name point at this machine is told by the Host it sends.
fn answer(method: &Method, url: &str, host: Option<&str>, port: u16) -> Answer {
    let names = ["127.0.0.1", "localhost"].map(|name| format!("{name}:{port}"));
    if !host.is_some_and(|host| names.iter().any(|name| name == host)) {
        return refusal(403, "the page is for this machine only");
    }
    if !matches!(method, Method::Get | Method::Head) {
        return with(refusal(405, "the page is only read"), "Allow", "GET, HEAD");
    }
    let path = url.split(['?', '#']).next().unwrap_or_default();
    let name = path.strip_prefix('/').map(|name| if name.is_empty() { "index.html" } else { name });
    match name.and_then(|name| Page::get(name).map(|file| (name, file))) {
        Some((name, file)) => response(200, content_type(name), file.data),
        None => refusal(404, "no such file in the page"),
    }
}

fn host(request: &Request) -> Option<&str> {
    request.headers().iter().find(|header| header.field.equiv("Host")).map(|header| header.value.as_str())
}

fn refusal(status: u16, why: &'static str) -> Answer {
    response(status, "text/plain; charset=utf-8", Cow::Borrowed(why.as_bytes()))
}

fn response(status: u16, content_type: &str, data: Cow<'static, [u8]>) -> Answer {
    let length = data.len();
    let bare = Response::new(status.into(), Vec::new(), Cursor::new(data), Some(length), None);
    let headers = [
        ("Content-Type", content_type),
        ("X-Content-Type-Options", "nosniff"),
        ("Content-Security-Policy", POLICY),
        ("Cross-Origin-Resource-Policy", "same-origin"),
        // Another version may be on this port tomorrow.
        ("Cache-Control", "no-cache"),
    ];
    headers
        .into_iter()
        .fold(bare.with_chunked_threshold(usize::MAX), |response, (name, value)| with(response, name, value))
}

fn with(response: Answer, name: &str, value: &str) -> Answer {
    match Header::from_bytes(name, value) {
        Ok(header) => response.with_header(header),
        Err(()) => response,
    }
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
