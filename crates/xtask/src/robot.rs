//! `coilsense-rt` on a Cortex-M4F: built for the bare metal, run under QEMU, counted in instructions.
//!
//! Next door: the other checks (`test`), what compiles it (`toolchain`), what runs there (`crates/coilsense-rt/robot`).

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context, bail};

use crate::toolchain::{Build, Target};
use crate::{root, typed};

/// A Cortex-M4F without an operating system. The map of its memory is an argument in the firmware's own `.cargo/config.toml`.
const TARGET: Target =
    Target { name: "thumbv7em-none-eabihf", libraries: "core", linker: ["ld.lld-22", "ld.lld"], flags: &[] };
/// What installs the machine on Debian.
const INSTALL: &str = "apt-get install --yes --no-install-recommends qemu-system-arm";
const MACHINE: &str = "qemu-system-arm";
/// Far more than it takes.
const PATIENCE: Duration = Duration::from_secs(120);

/// What is missing and how to get it, after installing what may be installed.
pub fn missing(may_install: bool) -> Option<String> {
    if let Some(compiler) = TARGET.missing(may_install) {
        return Some(compiler);
    }
    let machine = has_machine() || may_install && typed("apt-get update") && typed(INSTALL) && has_machine();
    if !machine {
        return Some(format!("no {MACHINE}; install it with: {INSTALL}"));
    }
    None
}

fn has_machine() -> bool {
    Command::new(MACHINE).arg("--version").output().is_ok_and(|output| output.status.success())
}

/// Builds the firmware, looks for code that could panic, runs it; whether all of it went well.
pub fn steps() -> anyhow::Result<bool> {
    let Build { mut command, made } = TARGET.build("robot")?;
    command.args(["--release", "--locked", "--quiet"]).current_dir(root().join("crates/coilsense-rt/robot"));
    if !command.status()?.success() {
        return Ok(false);
    }
    let firmware = made.join("release/coilsense-robot");
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
