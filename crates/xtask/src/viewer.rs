//! The interactive part of reports: bundled from the page's modules (`cargo xtask viewer`), and compared with the committed files.
//!
//! Next door: the page (`page`), which holds those modules.

use std::path::Path;

use anyhow::{Context, bail, ensure};

use crate::{page, root};

/// Where the files are committed.
const FOLDER: &str = "crates/coilsense-lab/src/report/viewer";
const FILES: [&str; 2] = ["viewer.js", "viewer.css"];

/// Writes the committed files.
pub fn write() -> anyhow::Result<()> {
    if let Some(missing) = page::missing_node(false) {
        bail!(missing);
    }
    bundle(&root().join(FOLDER))?;
    for file in FILES {
        println!("{FOLDER}/{file}");
    }
    Ok(())
}

/// Whether the committed files are what would be written.
pub fn agrees() -> anyhow::Result<bool> {
    let anew = tempfile::tempdir()?;
    bundle(anew.path())?;
    for file in FILES {
        let committed = root().join(FOLDER).join(file);
        let committed = std::fs::read(&committed).with_context(|| format!("{} cannot be read", committed.display()))?;
        if committed != std::fs::read(anew.path().join(file))? {
            eprintln!("{FOLDER}/{file} is not what web/src/report makes; write it with: cargo xtask viewer");
            return Ok(false);
        }
    }
    Ok(true)
}

fn bundle(folder: &Path) -> anyhow::Result<()> {
    let folder = std::path::absolute(folder)?;
    let folder = folder.to_str().context("the folder's name is no text")?;
    ensure!(page::tools()?, "the page's tools were not installed");
    ensure!(page::npm(&["run", "--silent", "viewer", "--", "--outDir", folder])?, "the bundle was not made");
    Ok(())
}
