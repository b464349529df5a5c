//! Which files of a folder coilsense wrote, by the file `.coilsense` in it: a SHA-256 and a name a line, as `sha256sum --check` reads them.
//!
//! Next door: who replaces files (the parent), how they take their places (`commit`).

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::Path;

use sha2::{Digest, Sha256};

/// The file in which it stands.
pub const WRITTEN: &str = ".coilsense";

const HEAD: &str =
    "# What coilsense wrote here and may write again; whatever has changed since is replaced with --overwrite only.\n";

/// Digests by names, relative to the folder, with `/` between folders.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Written(BTreeMap<String, String>);

impl Written {
    /// What stands in a folder; nothing where there is no such file, or none that we can read.
    pub(super) fn of(folder: &Path) -> Self {
        let text = fs::read_to_string(folder.join(WRITTEN)).unwrap_or_default();
        let lines = text.lines().filter(|line| !line.starts_with('#')).filter_map(|line| line.split_once("  "));
        Self(lines.map(|(digest, name)| (name.to_owned(), digest.to_owned())).collect())
    }

    /// What it says of a file.
    pub(super) fn digest(&self, name: &Path) -> Option<&str> {
        self.0.get(&key(name)).map(String::as_str)
    }

    /// Says that a file was written.
    pub(super) fn set(&mut self, name: &Path, digest: String) {
        // A name with a line's end in it cannot stand in a line; it is then as if somebody else had written that file.
        if !key(name).contains(['\n', '\r']) {
            self.0.insert(key(name), digest);
        }
    }

    /// Forgets files that are no more there.
    pub(super) fn keep(&mut self, is_there: impl Fn(&Path) -> bool) {
        self.0.retain(|name, _| is_there(Path::new(name)));
    }

    /// As it stands in the file.
    pub(super) fn text(&self) -> String {
        let lines = self.0.iter().map(|(name, digest)| format!("{digest}  {name}\n"));
        [HEAD.to_owned()].into_iter().chain(lines).collect()
    }
}

fn key(name: &Path) -> String {
    name.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}

/// SHA-256 of a file, in hexadecimal digits; none where there is no file.
pub(super) fn digest(path: &Path) -> io::Result<Option<String>> {
    let mut file = match File::open(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        file => file?,
    };
    let mut digest = Sha256::new();
    io::copy(&mut file, &mut Hashed(&mut digest))?;
    Ok(Some(digest.finalize().iter().map(|byte| format!("{byte:02x}")).collect()))
}

/// What is written into it is digested.
struct Hashed<'a>(&'a mut Sha256);

impl io::Write for Hashed<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.update(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_and_what_is_no_such_file_says_nothing() {
        let place = tempfile::tempdir().unwrap();
        fs::write(place.path().join("a b.csv"), "1\n").unwrap();
        let digest = digest(&place.path().join("a b.csv")).unwrap().unwrap();
        assert_eq!(digest, "4355a46b19d348dc2f57c046f8ef63d4538ebb936000f3c9ee954a27460dd865");
        let mut written = Written::of(place.path());
        assert_eq!(written, Written::default());
        written.set(Path::new("a b.csv"), digest.clone());
        written.set(Path::new("figures/one.svg"), digest.clone());
        written.set(Path::new("two\nlines"), digest.clone());
        fs::write(place.path().join(WRITTEN), written.text()).unwrap();
        let mut read = Written::of(place.path());
        assert_eq!(read, written);
        read.keep(|name| place.path().join(name).exists());
        assert_eq!((read.digest(Path::new("a b.csv")), read.0.len()), (Some(digest.as_str()), 1));
        fs::write(place.path().join(WRITTEN), [0xff, 0xfe]).unwrap();
        assert_eq!(Written::of(place.path()), Written::default());
    }
}
