//! What builds for another machine than this one: the workspace's own compiler where it has that machine's libraries, else Debian's compiler, which
//! makes them from source.
//!
//! Next door: what is built so, which is the firmware (`robot`) and the page's engine (`page`).

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::{cargo, root, target_folder, typed};

/// What installs Debian's compiler, its cargo, the source of its libraries and a linker; nothing that is there is taken away for it.
const INSTALL: &str =
    "apt-get install --yes --no-install-recommends --no-remove rustc-web cargo-web rust-web-src lld-22";
/// Where those packages put their files. They are named in full: what a shell finds first may be another compiler's.
const DEBIAN: &str = "/usr";
/// The oldest compiler that the workspace is for.
const OLDEST: &str = env!("CARGO_PKG_RUST_VERSION");

/// A machine that is built for.
pub struct Target {
    /// Its name among compilers.
    pub name: &'static str,
    /// Its libraries, where they are made from source.
    pub libraries: &'static str,
    /// What Debian's compiler links with, and the kind of linker that this is.
    pub linker: [&'static str; 2],
    /// What either compiler is told.
    pub flags: &'static [&'static str],
}

/// A build, ready to be told what to build.
pub struct Build {
    /// `cargo build` for the target.
    pub command: Command,
    /// The folder that has one folder for each profile.
    pub made: PathBuf,
}

/// Whose compiler builds.
enum Compiler {
    Own,
    Debian,
}

impl Target {
    /// Which compiler is missing and how to get it, after installing what may be installed.
    pub fn missing(&self, may_install: bool) -> Option<String> {
        let there = self.compiler().is_some() || may_install && self.install();
        let Self { name, .. } = self;
        (!there).then(|| {
            format!("no compiler for {name}; get one with: {}, or on Debian: apt-get update && {INSTALL}", self.add())
        })
    }

    /// How to build for the target: into `target/<folder>`, or beside it where Debian's compiler builds, so that neither throws away what the other
    /// has made.
    pub fn build(&self, folder: &str) -> anyhow::Result<Build> {
        let (mut command, folder, flags) = match self.compiler() {
            Some(Compiler::Own) => (cargo(&["build"]), folder.to_owned(), self.flags().collect()),
            Some(Compiler::Debian) => (self.debian_cargo(), format!("{folder}-debian"), self.debian_flags()),
            None => anyhow::bail!("no compiler for {}", self.name),
        };
        let folder = target_folder().join(folder);
        command.args(["--target", self.name]).arg("--target-dir").arg(&folder);
        // Flags from the environment would replace these, and are meant for this machine.
        command.arg("--config").arg(format!("target.{}.rustflags={flags:?}", self.name));
        command.env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
        Ok(Build { command, made: folder.join(self.name) })
    }

    fn compiler(&self) -> Option<Compiler> {
        if self.is_in_own() {
            return Some(Compiler::Own);
        }
        self.is_in_debian().then_some(Compiler::Debian)
    }

    /// Whether the workspace's compiler has the libraries.
    fn is_in_own(&self) -> bool {
        let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
        let folder = printed(Path::new(&rustc), &["--print", "target-libdir", "--target", self.name]);
        folder.is_some_and(|path| Path::new(&path).read_dir().is_ok_and(|mut files| files.next().is_some()))
    }

    /// Whether Debian's compiler is there with all that it needs to make the libraries.
    fn is_in_debian(&self) -> bool {
        let files = ["bin/cargo", "lib/rustlib/src/rust/library/Cargo.lock"].map(debian);
        let rustc = debian("bin/rustc");
        files.iter().chain([&self.debian_linker()]).all(|file| file.is_file())
            && printed(&rustc, &["--print", "sysroot"]).as_deref() == Some(DEBIAN)
            && printed(&rustc, &["--version"]).is_some_and(|text| version(&text) >= version(OLDEST))
    }

    /// Debian's packages where they can be had, else `rustup`; whether there is a compiler then.
    fn install(&self) -> bool {
        let line = if debian_serves() { INSTALL.to_owned() } else { self.add() };
        typed(&line) && self.compiler().is_some()
    }

    /// What adds the libraries to a compiler of `rustup`.
    fn add(&self) -> String {
        format!("rustup target add {}", self.name)
    }

    fn debian_linker(&self) -> PathBuf {
        debian("bin").join(self.linker[0])
    }

    /// Debian's cargo with Debian's compiler. Making libraries from source is not yet stable in cargo, and has to be allowed.
    fn debian_cargo(&self) -> Command {
        let mut command = Command::new(debian("bin/cargo"));
        command.args(["build", "-Z", &format!("build-std={}", self.libraries)]).current_dir(root());
        command.env("RUSTC", debian("bin/rustc")).env("RUSTC_BOOTSTRAP", "1");
        // `cargo xtask` leaves there where its own compiler has its libraries.
        command.env_remove("LD_LIBRARY_PATH");
        command
    }

    fn debian_flags(&self) -> Vec<String> {
        let [_, kind] = self.linker;
        let linker = [format!("-Clinker={}", self.debian_linker().display()), format!("-Clinker-flavor={kind}")];
        self.flags().chain(linker).collect()
    }

    fn flags(&self) -> impl Iterator<Item = String> {
        self.flags.iter().map(|&flag| flag.to_owned())
    }
}

/// A file of Debian's packages.
fn debian(path: &str) -> PathBuf {
    Path::new(DEBIAN).join(path)
}

/// Whether `apt-get` is there, knows the packages, and could install them without removing others.
fn debian_serves() -> bool {
    if !debian("bin/apt-get").is_file() {
        return false;
    }
    // Whether the list of each source can be had does not matter, but whether the packages are in one.
    typed("apt-get update");
    let mut words = INSTALL.split(' ');
    let mut asked = Command::new(words.next().unwrap_or_default());
    asked.arg("--simulate").args(words).stdin(Stdio::null());
    asked.output().is_ok_and(|output| output.status.success())
}

/// What a program prints on a line, where it succeeds.
fn printed(program: &Path, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).current_dir(root()).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// The first two numbers of a version, also after a name: `rustc 1.96.0 (…)`.
fn version(text: &str) -> Option<(u32, u32)> {
    let word = text.split(' ').find(|word| word.starts_with(|c: char| c.is_ascii_digit()))?;
    let mut numbers = word.split('.').map(|number| number.parse::<u32>().ok());
    Some((numbers.next()??, numbers.next()??))
}
