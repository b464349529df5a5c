//! A report opened in a real browser: its script runs through, draws its charts, and asks for nothing.
//!
//! Next door: the other checks (`test`).

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, bail};

use crate::{commands, root, typed};

/// A browser of the system's; none is downloaded.
pub struct Browser {
    pub name: &'static str,
    /// The variable that says where it is, for the page's tests, too.
    pub variable: &'static str,
    /// Names under which it is installed.
    names: &'static [&'static str],
    /// What installs it on Debian.
    install: &'static str,
}

pub const CHROMIUM: Browser = Browser {
    name: "Chromium",
    variable: "COILSENSE_CHROMIUM",
    names: &["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"],
    install: "apt-get install --yes chromium",
};

pub const FIREFOX: Browser = Browser {
    name: "Firefox",
    variable: "COILSENSE_FIREFOX_PATH",
    names: &["firefox-esr", "firefox"],
    install: "apt-get install --yes firefox-esr",
};

impl Browser {
    /// The browser, where there is one: the one that its variable names, else the first by its name.
    pub fn find(&self) -> Option<PathBuf> {
        if let Some(named) = self.named() {
            return named.is_file().then_some(named);
        }
        let folders = std::env::var_os("PATH")?;
        let mut places =
            std::env::split_paths(&folders).flat_map(|folder| self.names.iter().map(move |name| folder.join(name)));
        places.find(|path| path.is_file())
    }

    /// What is missing and how to get it, after installing it from the system's packages where that may be done.
    pub fn missing(&self, may_install: bool) -> Option<String> {
        if self.find().is_some() {
            return None;
        }
        if let Some(named) = self.named() {
            return Some(format!("{} names no file: {}", self.variable, named.display()));
        }
        let there = may_install && typed("apt-get update") && typed(self.install) && self.find().is_some();
        (!there).then(|| format!("no {}; install it with: {}", self.name, self.install))
    }

    fn named(&self) -> Option<PathBuf> {
        std::env::var_os(self.variable).filter(|path| !path.is_empty()).map(PathBuf::from)
    }
}

/// Opens the report of an example; whether it draws what it should, without an error.
pub fn report(browser: &Path) -> anyhow::Result<bool> {
    let place = tempfile::tempdir()?;
    let spec = root().join("examples/sea-ankle.toml");
    let out = place.path().join("report");
    let mut analyze = Command::new(commands::as_tested()?);
    analyze.arg("analyze").arg(&spec).arg("--out").arg(&out).stdout(Stdio::null());
    if !analyze.status()?.success() {
        bail!("coilsense analyze failed");
    }
    let page = out.join("report.html");
    let (dom, log) = opened(browser, &page, place.path())?;
    let drawn = ["class=\"uplot", "id=\"coilsense-spring\"", "<canvas"];
    let missing: Vec<&str> = drawn.into_iter().filter(|part| !dom.contains(part)).collect();
    let complaints: Vec<&str> = log.lines().filter(|line| line.contains("CONSOLE")).collect();
    for complaint in &complaints {
        println!("the page's console: {complaint}");
    }
    for part in &missing {
        println!("the page has no {part}");
    }
    Ok(missing.is_empty() && complaints.is_empty() && has_no_address(&page)?)
}

/// The page as its script leaves it, and what the browser says.
fn opened(browser: &Path, page: &Path, profile: &Path) -> anyhow::Result<(String, String)> {
    let mut command = Command::new(browser);
    command.args(["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"]);
    command.args([
        "--disable-component-update",
        "--disable-sync",
        "--enable-logging=stderr",
        "--virtual-time-budget=5000",
    ]);
    command.arg(format!("--user-data-dir={}", profile.join("profile").display()));
    command.arg("--dump-dom").arg(format!("file://{}", page.display())).stdin(Stdio::null());
    let output = command.output().with_context(|| format!("cannot start {}", browser.display()))?;
    let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
    Ok((text(output.stdout), text(output.stderr)))
}

/// Whether the page loads nothing from elsewhere: no source and no style sheet by address.
fn has_no_address(page: &Path) -> anyhow::Result<bool> {
    let text = std::fs::read_to_string(page)?;
    let loaded = ["src=\"http", "src=\"//", "<link", "@import"].into_iter().find(|part| text.contains(part));
    if let Some(part) = loaded {
        println!("the page loads something: {part}");
    }
    Ok(loaded.is_none())
}
