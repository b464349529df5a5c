//! The command as started by somebody who does not ignore Ctrl-C.

use std::process::Command;

/// The command with its usual answers to signals: who runs the tests in the background of a script ignores Ctrl-C, and children inherit it.
pub fn answering() -> Command {
    if cfg!(target_os = "linux") {
        let mut command = Command::new("env");
        command.args(["--default-signal=INT,HUP,TERM", env!("CARGO_BIN_EXE_coilsense")]);
        return command;
    }
    Command::new(env!("CARGO_BIN_EXE_coilsense"))
}
