//! What the system says of a file that cannot be read or written, in its own words.
//!
//! Next door: who says of which file (`output`, the doors).

use std::error::Error;
use std::io;

/// What the system says, whoever passed it on: `no space left on device`. Without the system's number, and without the paths of temporary
/// files that some put into it; where the system said nothing, the kind of the error.
pub fn said(error: &io::Error) -> String {
    match number(error) {
        Some(number) => words(number),
        None => error.kind().to_string(),
    }
}

/// The system's number, however deep an error has been wrapped.
fn number(error: &io::Error) -> Option<i32> {
    if let Some(number) = error.raw_os_error() {
        return Some(number);
    }
    let mut inner: Option<&(dyn Error + 'static)> = error.get_ref().map(|inner| inner as &(dyn Error + 'static));
    while let Some(error) = inner {
        if let Some(error) = error.downcast_ref::<io::Error>() {
            return number(error);
        }
        // It does not say what it wraps.
        if let Some(csv::ErrorKind::Io(error)) = error.downcast_ref::<csv::Error>().map(csv::Error::kind) {
            return number(error);
        }
        inner = error.source();
    }
    None
}

/// `No space left on device (os error 28)` as a part of a sentence.
fn words(number: i32) -> String {
    let text = io::Error::from_raw_os_error(number).to_string();
    let text = text.rsplit_once(" (os error").map_or(text.as_str(), |(words, _)| words);
    let mut signs = text.chars();
    match (signs.next(), signs.clone().next()) {
        // Unless it begins with an abbreviation.
        (Some(first), Some(second)) if second.is_lowercase() => first.to_lowercase().chain(signs).collect(),
        _ => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::said;
    use std::io::{self, ErrorKind};

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_told_in_plain_words_through_whatever_wraps_it() {
        let full = || io::Error::from_raw_os_error(28);
        let twice = io::Error::other(io::Error::other(full()));
        let of_csv = io::Error::other(csv::Error::from(full()));
        for error in [full(), io::Error::other(full()), twice, of_csv] {
            assert_eq!(said(&error), "no space left on device");
        }
        assert_eq!(said(&io::Error::from_raw_os_error(5)), "input/output error");
    }

    #[test]
    fn what_no_system_said_is_told_by_its_kind() {
        assert_eq!(said(&ErrorKind::UnexpectedEof.into()), "unexpected end of file");
        assert_eq!(said(&io::Error::new(ErrorKind::WriteZero, "/tmp/.coilsense-a1/x")), "write zero");
    }
}
