//! Standard output and standard error: all that the command says goes through here, so that nothing is lost without a word, and nothing that
//! stems from a file's name or text moves the terminal.
//!
//! Next door: what is said (`analyze` and others, `coilsense_lab::report`), who ends the command (`main`).

use std::fmt::{Display, Write as _};
use std::io::{self, ErrorKind, Write};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use coilsense_lab::request::{Given, JSON};
use coilsense_lab::system;

/// Standard output took not all that was said.
#[derive(Debug, thiserror::Error)]
#[error("standard output: cannot be written: {}", system::said(.0))]
pub struct Unsaid(io::Error);

/// What is said of work that is ended in the middle.
static UNDONE: Mutex<&str> = Mutex::new("interrupted; nothing was written");

/// What is said from here on, where the work is ended in the middle.
pub fn keeps(what: &'static str) {
    *UNDONE.lock().unwrap_or_else(PoisonError::into_inner) = what;
}

/// Says that the work was ended in the middle.
pub fn refuse_undone() {
    let what = *UNDONE.lock().unwrap_or_else(PoisonError::into_inner);
    refuse(what);
}

/// Whether nothing is said but what goes wrong, and JSON.
static QUIET: AtomicBool = AtomicBool::new(false);

/// Says nothing from here on but what goes wrong, and JSON where it is asked for.
pub fn set_quiet(quiet: bool) {
    QUIET.store(quiet, Ordering::Relaxed);
}

/// Whether that was asked for.
pub fn is_quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// Writes on standard output what was asked for itself, such as a script.
///
/// # Errors
/// As [`say`].
pub fn raw(text: &str) -> Result<(), Unsaid> {
    put(text)
}

/// Says a text for people on standard output.
///
/// # Errors
/// [`Unsaid`]; a reader that closed the pipe early (`| head`) has all it wants.
pub fn say(text: &str) -> Result<(), Unsaid> {
    if is_quiet() { Ok(()) } else { put(&shown(text)) }
}

/// Says JSON, or a text for people, whichever was asked for.
///
/// # Errors
/// As [`say`].
pub fn answer(given: &Given, text: &str) -> Result<(), Unsaid> {
    if given.holds(&JSON) { put(&in_json(text)) } else { say(text) }
}

/// The same of what a file would hold, which is never left out.
///
/// # Errors
/// As [`say`].
pub fn product(given: &Given, text: &str) -> Result<(), Unsaid> {
    if given.holds(&JSON) { put(&in_json(text)) } else { put(&shown(text)) }
}

/// The last line of a command that has written a report's folder; none in JSON.
pub fn where_to_look(given: &Given, files: usize, folder: &Path, took: Option<Duration>) -> String {
    if given.holds(&JSON) {
        return String::new();
    }
    let took = took.map_or_else(String::new, |took| format!(" in {:.2} s", took.as_secs_f64()));
    format!("\n{files} files in {}{took}; open {}\n", folder.display(), folder.join("report.html").display())
}

/// Says in a line that something is doubtful.
pub fn warn(what: impl Display) {
    if !is_quiet() {
        tell(&format!("warning: {what}"));
    }
}

/// Says in a line that nothing came of it, and why.
pub fn refuse(why: impl Display) {
    tell(&format!("error: {why}"));
}

/// A line on standard error. Where that is closed or full, nobody is left to be told.
pub fn tell(line: &str) {
    let _ = writeln!(anstream::stderr().lock(), "{}", shown(&line.replace('\n', "\\n")));
}

/// What clap says: its help and version on standard output, what is wrong on standard error.
///
/// # Errors
/// As [`say`].
pub fn of_clap(error: &clap::Error) -> Result<(), Unsaid> {
    let text = shown(&error.render().ansi().to_string());
    if !error.use_stderr() {
        return put(&text);
    }
    let _ = anstream::stderr().lock().write_all(text.as_bytes());
    Ok(())
}

fn put(text: &str) -> Result<(), Unsaid> {
    // What was to be written is.
    keeps("interrupted");
    let mut out = anstream::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Unsaid(error)),
        _ => Ok(()),
    }
}

/// What switches the colours of our own texts and of clap's: it alone passes.
const OWN: [&str; 9] = [
    "\u{1b}[0m",
    "\u{1b}[1m",
    "\u{1b}[4m",
    "\u{1b}[31m",
    "\u{1b}[32m",
    "\u{1b}[33m",
    "\u{1b}[1m\u{1b}[31m",
    "\u{1b}[1m\u{1b}[32m",
    "\u{1b}[1m\u{1b}[33m",
];

/// The text with every other sign that a terminal obeys shown in place of obeyed: `\u{1b}[2J`.
fn shown(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(sign) = rest.chars().next() {
        let own = OWN.iter().find(|own| sign == '\u{1b}' && rest.starts_with(**own));
        let length = own.map_or(sign.len_utf8(), |own| own.len());
        match sign {
            _ if own.is_some() => safe.push_str(&rest[..length]),
            '\n' | '\t' => safe.push(sign),
            _ if is_obeyed(sign) => safe.extend(sign.escape_default()),
            _ => safe.push(sign),
        }
        rest = &rest[length..];
    }
    safe
}

/// JSON with the signs escaped that its writer lets through: they can stand in its texts only.
fn in_json(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for sign in text.chars() {
        match sign {
            '\n' => safe.push(sign),
            _ if is_obeyed(sign) => {
                // Writing to a String cannot fail; all of these signs are below U+10000.
                let _ = write!(safe, "\\u{:04x}", u32::from(sign));
            }
            _ => safe.push(sign),
        }
    }
    safe
}

/// Controls, and marks that turn the direction of what follows.
fn is_obeyed(sign: char) -> bool {
    sign.is_control() || matches!(sign, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::{in_json, shown};

    #[test]
    fn what_a_name_would_do_to_the_terminal_is_shown_and_our_own_colours_stay() {
        for (said, is_shown) in [
            ("a\u{1b}[2Jb", "a\\u{1b}[2Jb"),
            ("\u{1b}]0;title\u{7}", "\\u{1b}]0;title\\u{7}"),
            ("\u{1b}[8mhidden", "\\u{1b}[8mhidden"),
            ("\u{9b}2J\r\u{8}\u{7f}", "\\u{9b}2J\\r\\u{8}\\u{7f}"),
            ("txt.\u{202e}vsc", "txt.\\u{202e}vsc"),
            ("\u{1b}[1mbold\u{1b}[0m\n\tµ, ζ, 弹簧", "\u{1b}[1mbold\u{1b}[0m\n\tµ, ζ, 弹簧"),
            ("\u{1b}", "\\u{1b}"),
        ] {
            assert_eq!(shown(said), is_shown);
        }
    }

    #[test]
    fn json_stays_what_it_was() {
        let text = serde_json::to_string("a\u{9b}2J \u{7f} \u{202e} \u{1b}[2J ζ").unwrap();
        let safe = in_json(&text);
        assert!(!safe.chars().any(super::is_obeyed), "{safe}");
        assert_eq!(serde_json::from_str::<String>(&safe).unwrap(), "a\u{9b}2J \u{7f} \u{202e} \u{1b}[2J ζ");
    }
}
