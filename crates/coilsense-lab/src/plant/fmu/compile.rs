//! The binary of an FMU, made by this machine's C compiler.
//!
//! Next door: what is compiled (the parent).

use std::io::ErrorKind;
use std::process::{Command, Stdio};

use super::Fmi;
use crate::output::Staging;
use crate::system;

/// A shared library and where it lies in an FMU.
pub(super) struct Binary {
    pub path: String,
    pub bytes: Vec<u8>,
}

impl Fmi {
    /// What the standard calls this machine, and how its shared libraries end; none where it has no name, or where a compiler is not called `cc`.
    const fn machine(self) -> Option<(&'static str, &'static str)> {
        let is_two = matches!(self, Self::Two);
        if cfg!(all(target_os = "linux", target_arch = "x86_64")) {
            Some((if is_two { "linux64" } else { "x86_64-linux" }, "so"))
        } else if cfg!(all(target_os = "linux", target_arch = "x86")) {
            Some((if is_two { "linux32" } else { "x86-linux" }, "so"))
        } else if cfg!(all(target_os = "linux", target_arch = "aarch64")) && !is_two {
            Some(("aarch64-linux", "so"))
        } else if cfg!(all(target_os = "macos", target_arch = "x86_64")) {
            Some((if is_two { "darwin64" } else { "x86_64-darwin" }, "dylib"))
        } else if cfg!(all(target_os = "macos", target_arch = "aarch64")) && !is_two {
            Some(("aarch64-darwin", "dylib"))
        } else {
            None
        }
    }
}

/// `-ffp-contract=off` keeps the bits of `coilsense-rt`.
const OPTIONS: [&str; 6] = ["-O2", "-shared", "-fPIC", "-std=c99", "-ffp-contract=off", "-fvisibility=hidden"];

/// Compiles the first of the files beside the others.
///
/// # Errors
/// One line that says why there is no binary.
pub(super) fn binary(name: &str, version: Fmi, files: &[(String, String)]) -> Result<Binary, String> {
    let Some((machine, ending)) = version.machine() else {
        return Err(format!("FMI {version} has no name for this machine, or a compiler is not at hand on it"));
    };
    let folder = Staging::within(&std::env::temp_dir())
        .map_err(|error| format!("no temporary folder: {}", system::said(&error)))?;
    for (file, text) in files {
        let written = std::fs::write(folder.path().join(file), text);
        written.map_err(|error| format!("no temporary file: {}", system::said(&error)))?;
    }
    let library = format!("{name}.{ending}");
    let mut compiler = Command::new("cc");
    compiler.args(OPTIONS).args(["-o", &library]).args(files.first().map(|(file, _)| file));
    let ran = compiler.current_dir(folder.path()).stdin(Stdio::null()).output();
    let ended = ran.map_err(|error| match error.kind() {
        ErrorKind::NotFound => "no C compiler: cc is not found".to_owned(),
        kind => format!("the C compiler cc cannot be started: {kind}"),
    })?;
    if !ended.status.success() {
        let words = String::from_utf8_lossy(&ended.stderr);
        let said = first_error(&words);
        return Err(format!("the C compiler cc failed{}", said.map(|said| format!(": {said}")).unwrap_or_default()));
    }
    let bytes = std::fs::read(folder.path().join(&library));
    let bytes = bytes.map_err(|_| "the C compiler cc left no library".to_owned())?;
    Ok(Binary { path: format!("binaries/{machine}/{library}"), bytes })
}

/// The line of a compiler's words that says most.
fn first_error(words: &str) -> Option<&str> {
    let lines = || words.lines().map(str::trim).filter(|line| !line.is_empty());
    lines().find(|line| line.contains("error")).or_else(|| lines().next())
}
