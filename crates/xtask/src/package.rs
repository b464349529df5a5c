//! Checks of the Python package: its wheel, its tests, its types, what README, book and the examples say to run.
//!
//! Next door: environments (`python`), the types that are compared (`stubs`), the other checks (`test`).

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, bail};

use crate::python::{self, Environment};
use crate::{as_cargo, root, side_by_side, stubs};

/// What a wheel that is released may weigh \[MB\].
const LARGEST_WHEEL: f64 = 10.0;
/// How wheels are packed, here and where they are released.
const PACKED_HARDER: [&str; 2] = ["--compression-level", "9"];

/// What the tests run with.
pub const REQUIREMENTS: &str = "python/requirements-test.txt";

/// The page whose blocks hang together and use every extra: the package's own tests run it.
const TOUR: &str = "book/src/guide/python.md";

/// What is missing to run them, and what installs it.
pub fn missing() -> Option<String> {
    let wanted = "import ensurepip, sys, venv; sys.exit(sys.version_info < (3, 11))";
    let found = Command::new("python3").args(["-c", wanted]).output();
    if found.is_ok_and(|output| output.status.success()) {
        return None;
    }
    Some("no Python 3.11 or later with venv; install it with: apt-get install python3 python3-venv".to_owned())
}

/// How a wheel is compiled.
#[derive(Clone, Copy)]
pub enum Built {
    /// As pip does it for whoever installs it: optimised, which takes minutes; its size is held to [`LARGEST_WHEEL`].
    AsReleased,
    /// As the tests are, which takes two thirds of that: what is slow to optimise and spends no time in tests stays as it is.
    AsTested,
}

impl Built {
    /// The cargo profile.
    pub fn profile(self) -> &'static str {
        match self {
            Self::AsReleased => "release",
            Self::AsTested => "dev",
        }
    }

    /// The folder that it is built into. Cargo gives crates of an unpacked source the names of the workspace's own: in one folder with the tests each
    /// would have the other's compiled anew.
    pub fn folder(self) -> PathBuf {
        match self {
            Self::AsReleased => crate::target_folder(),
            Self::AsTested => crate::target_folder().join("wheel"),
        }
    }
}

/// Packs the source, builds the wheel from that through pip, installs it, and runs everything; whether all succeed.
pub fn steps(built: Built) -> anyhow::Result<bool> {
    let tests = python::environment("target/python", REQUIREMENTS)?;
    let source = unpacked(&packed(&tests)?)?;
    let wheel = from(source.path(), &tests, built)?;
    install(&wheel, &tests, built)?;
    // What is written for simulators, they read; the command writes it.
    let mut pytest = tests.python();
    pytest.env("COILSENSE_COMMAND", crate::commands::as_tested()?);
    // Two files at a time: most of them keep one core busy, and threads of NumPy's that spin until the other one is free take eight times as long.
    pytest.args(["-m", "pytest", "-q", "-n", "2", "--dist", "loadfile"]).env("OPENBLAS_NUM_THREADS", "1");
    let run = |arguments: &&[&str]| succeeds(tests.python().args(*arguments));
    Ok(succeeds(&mut pytest)?
        && stubs::agree(&tests, source.path(), built)?
        && side_by_side(
            || Ok(every(&PYRIGHT, run)? && readme(&wheel)?),
            || Ok(every(&MYPY, run)? && examples(&tests)?),
        )?)
}

/// Checks of types, of which each keeps one core busy.
const PYRIGHT: [&[&str]; 2] = [
    &["-m", "pyright", "--pythonpath", "target/python/bin/python"],
    &["-m", "pyright", "--verifytypes", "coilsense", "--ignoreexternal"],
];
const MYPY: [&[&str]; 2] = [
    &["-m", "mypy", "python/coilsense", "python/tests", "python/examples", "python/stubs"],
    &["-m", "mypy.stubtest", "coilsense", "--mypy-config-file", "pyproject.toml"],
];

/// The tests' environment with the wheel of this source in it.
pub fn installed() -> anyhow::Result<Environment> {
    let environment = python::environment("target/python", REQUIREMENTS)?;
    install(&build(&environment)?, &environment, Built::AsReleased)?;
    Ok(environment)
}

/// Installs a wheel; one that is released is no larger than it may be.
fn install(wheel: &Path, environment: &Environment, built: Built) -> anyhow::Result<()> {
    let megabytes = 1e-6 * wheel.metadata()?.len() as f64;
    match built {
        Built::AsTested => println!("{}: {megabytes:.1} MB, compiled as the tests are", name(wheel)),
        Built::AsReleased => println!("{}: {megabytes:.1} MB (at most {LARGEST_WHEEL:.0})", name(wheel)),
    }
    if matches!(built, Built::AsReleased) && megabytes > LARGEST_WHEEL {
        bail!("the wheel is too large");
    }
    if !succeeds(environment.pip().args(["--force-reinstall", "--no-deps"]).arg(wheel))? {
        bail!("the wheel cannot be installed");
    }
    Ok(())
}

/// A packed source, unpacked elsewhere.
fn unpacked(source: &Path) -> anyhow::Result<tempfile::TempDir> {
    let place = tempfile::tempdir()?;
    // With the date of today: packed files all have one old date, by which what was built of other files before would be taken for theirs.
    let mut unpack = Command::new("tar");
    if !succeeds(unpack.args(["xzmf"]).arg(source).args(["--strip-components", "1", "-C"]).arg(place.path()))? {
        bail!("the packed source cannot be unpacked");
    }
    Ok(place)
}

/// The wheel that pip builds from a source.
fn from(source: &Path, environment: &Environment, built: Built) -> anyhow::Result<PathBuf> {
    let folder = root().join("target/wheels");
    let mut build = environment.python();
    build.args(["-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir"]).arg(&folder).arg(source);
    let profile = ["--profile", built.profile()];
    build.env("MATURIN_PEP517_ARGS", [profile, PACKED_HARDER].concat().join(" "));
    as_cargo(&mut build);
    if !succeeds(build.env("CARGO_TARGET_DIR", built.folder()))? {
        bail!("the packed source cannot be built");
    }
    files(&folder, "whl")?.pop().context("pip left no wheel")
}

/// The wheel, built anew.
fn build(environment: &Environment) -> anyhow::Result<PathBuf> {
    let folder = emptied()?;
    let mut build = environment.python();
    build.args(["-m", "maturin", "build", "--release", "--quiet", "--interpreter", "python3", "--out"]).arg(&folder);
    build.args(PACKED_HARDER);
    if !succeeds(&mut build)? {
        bail!("the wheel cannot be built");
    }
    files(&folder, "whl")?.pop().context("maturin left no wheel")
}

/// Every script in python/examples, in a folder of its own that has the examples' specs.
fn examples(environment: &Environment) -> anyhow::Result<bool> {
    every(&files(&root().join("python/examples"), "py")?, |script| {
        println!("== {}", name(script));
        in_a_place(environment.python().arg(script))
    })
}

/// The folder of wheels, with none in it.
fn emptied() -> anyhow::Result<PathBuf> {
    let folder = root().join("target/wheels");
    if folder.exists() {
        std::fs::remove_dir_all(&folder)?;
    }
    Ok(folder)
}

/// What is published beside wheels: the source, packed.
fn packed(environment: &Environment) -> anyhow::Result<PathBuf> {
    let folder = emptied()?;
    let mut pack = environment.python();
    pack.args(["-m", "maturin", "sdist", "--out"]).arg(&folder);
    if !succeeds(&mut pack)? {
        bail!("the source cannot be packed");
    }
    files(&folder, "gz")?.pop().context("maturin left no packed source")
}

/// The Python code of README and book, each block by itself, in an environment that has nothing but what the wheel brings.
fn readme(wheel: &Path) -> anyhow::Result<bool> {
    let plain = python::fresh("target/python-plain")?;
    if !succeeds(plain.pip().arg(wheel))? {
        return Ok(false);
    }
    let mut run = 0;
    for page in crate::commands::documents()? {
        if page.ends_with(TOUR) {
            continue;
        }
        let text = std::fs::read_to_string(&page).with_context(|| format!("{} cannot be read", page.display()))?;
        let parts = text.split("```python\n").skip(1);
        let blocks: Vec<&str> = parts.filter_map(|rest| rest.split("\n```").next()).collect();
        run += blocks.len();
        if !every(&blocks, |block| in_a_place(plain.python().args(["-c", block])))? {
            return Ok(false);
        }
    }
    println!("{run} Python examples of README and book");
    Ok(run > 0)
}

/// Runs Python in a temporary folder with the examples' specs, without a screen.
fn in_a_place(command: &mut Command) -> anyhow::Result<bool> {
    let place = tempfile::tempdir()?;
    crate::commands::copy_examples(&place.path().join("examples"))?;
    succeeds(command.current_dir(place.path()).env("MPLBACKEND", "Agg"))
}

fn succeeds(command: &mut Command) -> anyhow::Result<bool> {
    Ok(command.status().with_context(|| format!("cannot start {command:?}"))?.success())
}

/// Whether all succeed, up to the first that does not.
fn every<T>(all: &[T], each: impl Fn(&T) -> anyhow::Result<bool>) -> anyhow::Result<bool> {
    for one in all {
        if !each(one)? {
            return Ok(false);
        }
    }
    Ok(true)
}

/// A folder's files of an ending, in order.
fn files(folder: &Path, ending: &str) -> anyhow::Result<Vec<PathBuf>> {
    let all = std::fs::read_dir(folder).with_context(|| format!("{} cannot be read", folder.display()))?;
    let paths = all.map(|file| Ok(file?.path())).collect::<anyhow::Result<Vec<_>>>()?;
    let mut files: Vec<PathBuf> =
        paths.into_iter().filter(|path| path.extension().is_some_and(|e| e == ending)).collect();
    files.sort();
    Ok(files)
}

fn name(path: &Path) -> &str {
    path.file_name().and_then(std::ffi::OsStr::to_str).unwrap_or_default()
}
