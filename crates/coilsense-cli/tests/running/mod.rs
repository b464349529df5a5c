//! The command run in a folder.

use std::path::Path;
use std::process::{Command, Output};

/// Runs the command there.
pub fn coilsense(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_coilsense"));
    command.args(arguments).current_dir(folder).output().expect("the command starts")
}
