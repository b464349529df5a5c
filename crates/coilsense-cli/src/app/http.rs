//! HTTP/1.1 for the few readers on this machine, each with bounds: on connections, on the size of a request, on the time that it may take.
//!
//! Next door: what is answered to whom (`server`).

use std::borrow::Cow;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Connections at a time. One more takes the place of that which has waited longest without asking.
const CONNECTIONS: usize = 64;
/// Bytes of a request's head, and headers in it.
const HEAD: usize = 16 << 10;
const HEADERS: usize = 64;
/// From the beginning of a connection, or from its last answer, to the end of a request's head.
const PATIENCE: Duration = Duration::from_secs(10);
/// For an answer to be taken.
const TAKING: Duration = Duration::from_secs(60);

/// What is asked.
pub struct Request {
    /// Such as GET.
    pub method: String,
    /// The path and what follows it.
    pub target: String,
    /// Whom the reader thinks to ask; none where that is not said once.
    pub host: Option<String>,
    /// Whether the connection ends with the answer.
    closes: bool,
}

/// What is answered.
pub struct Answer {
    /// Such as 200.
    pub status: u16,
    /// Beside its length.
    pub headers: Vec<(&'static str, &'static str)>,
    /// The bytes.
    pub body: Cow<'static, [u8]>,
}

/// A connection, and since when it has been waited for its next request; none while one is answered.
struct Slot {
    number: u64,
    stream: TcpStream,
    waits: Option<Instant>,
}

/// All connections.
#[derive(Default)]
struct Slots(Mutex<Vec<Slot>>);

impl Slots {
    fn all(&self) -> MutexGuard<'_, Vec<Slot>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Room for one more; whether there is any.
    fn enter(&self, number: u64, stream: &TcpStream) -> io::Result<bool> {
        let mut slots = self.all();
        if slots.len() >= CONNECTIONS {
            let waiting = slots.iter().enumerate().filter_map(|(place, slot)| Some((slot.waits?, place)));
            let Some((_, place)) = waiting.min() else { return Ok(false) };
            // Its thread then reads the end of it.
            let _ = slots.swap_remove(place).stream.shutdown(Shutdown::Both);
        }
        slots.push(Slot { number, stream: stream.try_clone()?, waits: Some(Instant::now()) });
        Ok(true)
    }

    fn set(&self, number: u64, waits: Option<Instant>) {
        if let Some(slot) = self.all().iter_mut().find(|slot| slot.number == number) {
            slot.waits = waits;
        }
    }

    fn leave(&self, number: u64) {
        self.all().retain(|slot| slot.number != number);
    }
}

/// Answers until it is stopped and one more connection comes.
pub fn serve(
    listener: &TcpListener,
    stopped: &AtomicBool,
    answer: impl Fn(&Request) -> Answer + Send + Sync + 'static,
) {
    let (slots, answer) = (Arc::new(Slots::default()), Arc::new(answer));
    for number in 0_u64.. {
        let accepted = listener.accept();
        if stopped.load(Ordering::SeqCst) {
            return;
        }
        let Ok((mut stream, _)) = accepted else {
            // The system has no more of something; it may have again.
            std::thread::sleep(Duration::from_millis(20));
            continue;
        };
        match slots.enter(number, &stream) {
            Ok(true) => (),
            Ok(false) => {
                let _ = stream.set_write_timeout(Some(Duration::from_millis(100)));
                let _ = send(&mut stream, &refusal(503, "too many connections"), false, true);
                continue;
            }
            Err(_) => continue,
        }
        let (theirs, answer) = (Arc::clone(&slots), Arc::clone(&answer));
        let begun = std::thread::Builder::new().spawn(move || {
            let _ = converse(&mut stream, |waits| theirs.set(number, waits), &*answer);
            theirs.leave(number);
        });
        if begun.is_err() {
            slots.leave(number);
        }
    }
}

/// Requests and answers over a connection, one after the other.
fn converse(
    stream: &mut TcpStream,
    waits: impl Fn(Option<Instant>),
    answer: &impl Fn(&Request) -> Answer,
) -> io::Result<()> {
    stream.set_nodelay(true)?;
    let mut read = Vec::new();
    loop {
        let begun = Instant::now();
        waits(Some(begun));
        let asked = next(stream, &mut read, begun)?;
        waits(None);
        stream.set_write_timeout(Some(PATIENCE))?;
        match asked {
            Ok(request) => {
                let closes = request.closes;
                send(stream, &answer(&request), request.method == "HEAD", closes)?;
                if closes {
                    return end(stream);
                }
            }
            Err(refused) => {
                send(stream, &refused, false, true)?;
                return end(stream);
            }
        }
    }
}

/// The next request, or what is answered to what is none.
fn next(stream: &mut TcpStream, read: &mut Vec<u8>, begun: Instant) -> io::Result<Result<Request, Answer>> {
    loop {
        let mut headers = [httparse::EMPTY_HEADER; HEADERS];
        let mut head = httparse::Request::new(&mut headers);
        match head.parse(read) {
            Ok(httparse::Status::Complete(length)) => {
                let request = request(&head);
                read.drain(..length);
                return Ok(Ok(request));
            }
            Ok(httparse::Status::Partial) if read.len() < HEAD => (),
            Ok(httparse::Status::Partial) | Err(httparse::Error::TooManyHeaders) => {
                return Ok(Err(refusal(431, "the request's head is too large")));
            }
            Err(_) => return Ok(Err(refusal(400, "this is no request"))),
        }
        let left = PATIENCE.saturating_sub(begun.elapsed());
        if left.is_zero() {
            return Err(ErrorKind::TimedOut.into());
        }
        stream.set_read_timeout(Some(left))?;
        let mut some = [0; 4096];
        let most = some.len().min(HEAD - read.len());
        match stream.read(&mut some[..most]) {
            Ok(0) => return Err(ErrorKind::UnexpectedEof.into()),
            Ok(count) => read.extend_from_slice(&some[..count]),
            Err(error) if error.kind() == ErrorKind::Interrupted => (),
            Err(error) => return Err(error),
        }
    }
}

fn request(head: &httparse::Request<'_, '_>) -> Request {
    let all = |name: &'static str| {
        let named = head.headers.iter().filter(move |header| header.name.eq_ignore_ascii_case(name));
        named.map(|header| std::str::from_utf8(header.value).unwrap_or_default())
    };
    let mut hosts = all("host");
    let host = hosts.next().filter(|_| hosts.next().is_none()).map(str::to_owned);
    let method = head.method.unwrap_or_default().to_owned();
    // A body is not read, so nothing that follows can be told from it.
    let has_body =
        all("transfer-encoding").next().is_some() || all("content-length").any(|length| length.trim() != "0");
    let is_last = head.version == Some(0) || all("connection").any(|word| word.to_ascii_lowercase().contains("close"));
    let closes = is_last || has_body || !["GET", "HEAD"].contains(&method.as_str());
    Request { method, target: head.path.unwrap_or_default().to_owned(), host, closes }
}

/// An answer in a few words.
pub fn refusal(status: u16, why: &'static str) -> Answer {
    Answer { status, headers: vec![("Content-Type", "text/plain; charset=utf-8")], body: Cow::Borrowed(why.as_bytes()) }
}

fn send(stream: &mut TcpStream, answer: &Answer, head_only: bool, closes: bool) -> io::Result<()> {
    let reason = match answer.status {
        200 => "OK",
        400 => "Bad Request",
        403 => "Forbidden",
        404 => "Not Found",
        405 => "Method Not Allowed",
        431 => "Request Header Fields Too Large",
        _ => "Service Unavailable",
    };
    let mut head = format!("HTTP/1.1 {} {reason}\r\nContent-Length: {}\r\n", answer.status, answer.body.len());
    answer.headers.iter().for_each(|(name, value)| head.extend([name, ": ", value, "\r\n"]));
    head.push_str(if closes { "Connection: close\r\n\r\n" } else { "\r\n" });
    let begun = Instant::now();
    let body: &[u8] = if head_only { &[] } else { &answer.body };
    for mut left in [head.as_bytes(), body] {
        while !left.is_empty() {
            // A reader that takes a little now and then must not have its answer for ever.
            if begun.elapsed() > TAKING {
                return Err(ErrorKind::TimedOut.into());
            }
            match stream.write(left) {
                Ok(0) => return Err(ErrorKind::WriteZero.into()),
                Ok(count) => left = &left[count..],
                Err(error) if error.kind() == ErrorKind::Interrupted => (),
                Err(error) => return Err(error),
            }
        }
    }
    stream.flush()
}

/// Ends a connection so that what was sent arrives, though more may come that nobody reads.
fn end(stream: &mut TcpStream) -> io::Result<()> {
    stream.shutdown(Shutdown::Write)?;
    stream.set_read_timeout(Some(Duration::from_millis(100)))?;
    let mut rest = [0; 4096];
    for _ in 0..16 {
        if stream.read(&mut rest)? == 0 {
            break;
        }
    }
    Ok(())
}
