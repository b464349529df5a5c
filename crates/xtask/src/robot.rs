//! `coilsense-rt` on a Cortex-M4F: built for the bare metal, run under QEMU, counted in instructions.
//!
//! Next door: the other checks (`test`), what runs there (`crates/coilsense-rt/robot`).

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context, bail};

use crate::{cargo, root};

/// A Cortex-M4F without an operating system.
const TARGET: &str = "thumbv7em-none-eabihf";
/// What gets the core library for it.
const ADD_TARGET: &str = "rustup target add thumbv7em-none-eabihf";
/// What installs the machine on Debian.
const INSTALL: &str = "apt-get install --yes --no-install-recommends qemu-system-arm";
const MACHINE: &str = "qemu-system-arm";
/// Far more than it takes.
const PATIENCE: Duration = Duration::from_secs(120);

/// What is missing and how to get it, after installing what may be installed.
pub fn missing(may_install: bool) -> Option<String> {
    let target = has_target() || may_install && typed(ADD_TARGET) && has_target();
    if !target {
        return Some(format!("no core library for {TARGET}; install it with: {ADD_TARGET}"));
    }
    let machine = has_machine() || may_install && typed("apt-get update") && typed(INSTALL) && has_machine();
    if !machine {
        return Some(format!("no {MACHINE}; install it with: {INSTALL}"));
    }
    None
}

fn typed(line: &str) -> bool {
    let mut words = line.split(' ');
    println!("{line}");
    let program = words.next().unwrap_or_default();
    Command::new(program)
        .args(words)
        .current_dir(root())
        .stdin(Stdio::null())
        .status()
        .is_ok_and(|status| status.success())
}

/// Whether the compiler of this workspace has a core library for the target.
fn has_target() -> bool {
    let asked =
        Command::new("rustc").args(["--print", "target-libdir", "--target", TARGET]).current_dir(root()).output();
    asked.is_ok_and(|output| {
        let path = String::from_utf8_lossy(&output.stdout).trim().to_owned();
        output.status.success() && std::fs::read_dir(path).is_ok_and(|mut files| files.next().is_some())
    })
}

fn has_machine() -> bool {
    Command::new(MACHINE).arg("--version").output().is_ok_and(|output| output.status.success())
}

/// Builds the firmware, looks for code that could panic, runs it; whether all of it went well.
pub fn steps() -> anyhow::Result<bool> {
    let folder = root().join("crates/coilsense-rt/robot");
    let target = root().join("target/robot");
    let mut build = cargo(&["build", "--release", "--locked", "--quiet"]);
    build.arg("--target-dir").arg(&target).current_dir(&folder);
    if !build.status()?.success() {
        return Ok(false);
    }
    let firmware = target.join(TARGET).join("release/coilsense-robot");
    Ok(cannot_panic(&firmware)? && run(&firmware)?)
}

/// Whether no function of `core::panicking` was linked in, by the names of the file's symbols.
fn cannot_panic(firmware: &Path) -> anyhow::Result<bool> {
    let bytes = std::fs::read(firmware).with_context(|| format!("{} cannot be read", firmware.display()))?;
    let holds = |name: &[u8]| bytes.windows(name.len()).any(|window| window == name);
    if !holds(b"HardFault") {
        bail!("{} has no symbols to judge by", firmware.display());
    }
    let panics = holds(b"9panicking");
    println!(
        "{}",
        if panics { "a step can panic" } else { "no step can panic: nothing of core::panicking is linked in" }
    );
    Ok(!panics)
}

fn run(firmware: &PathBuf) -> anyhow::Result<bool> {
    let mut machine = Command::new(MACHINE);
    machine.args(["-machine", "mps2-an386", "-nographic", "-monitor", "none", "-serial", "none", "-icount", "shift=0"]);
    machine.args(["-semihosting-config", "enable=on,target=native", "-kernel"]).arg(firmware);
    let mut child = machine.stdin(Stdio::null()).spawn().with_context(|| format!("cannot start {MACHINE}"))?;
    let begun = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(status.success());
        }
        if begun.elapsed() > PATIENCE {
            child.kill()?;
            bail!("the firmware did not end within {} s", PATIENCE.as_secs());
        }
        std::thread::sleep(Duration::from_millis(50));
    }
}
