//! The book as readers get it: built by mdBook without a complaint, with no link that leads nowhere.
//!
//! Next door: what its pages say to type (`commands`), links in their source (`links`).

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};
use std::process::Command;

use anyhow::{Context, bail};

use crate::{cargo, root, target_folder};

/// The mdBook that builds it.
const VERSION: &str = "0.5.4";
/// Pages that repeat others.
const NOT_READ: [&str; 3] = ["print.html", "toc.html", "404.html"];

/// mdBook, in the project's own folder; got there from the registry where it is not.
fn builder() -> anyhow::Result<PathBuf> {
    let tools = target_folder().join("tools");
    let there = tools.join("bin/mdbook");
    let is_right = Command::new(&there)
        .arg("--version")
        .output()
        .is_ok_and(|output| String::from_utf8_lossy(&output.stdout).trim().trim_start_matches("mdbook v") == VERSION);
    if !is_right {
        println!("mdbook {VERSION} into {}", tools.display());
        // Built as quickly as may be: the book takes it a second either way.
        let mut install =
            cargo(&["install", "--quiet", "mdbook", "--locked", "--debug", "--no-default-features", "--force"]);
        install.args(["--version", VERSION, "--root"]).arg(&tools);
        if !install.status()?.success() {
            bail!("mdbook {VERSION} cannot be installed");
        }
    }
    Ok(there)
}

/// Builds it into `target/book` and follows every link; whether nothing is wrong.
pub fn steps() -> anyhow::Result<bool> {
    let output = Command::new(builder()?).arg("build").arg(root().join("book")).output().context("mdbook")?;
    let said = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
    let complaints: Vec<&str> = said.lines().filter(|line| line.contains("WARN") || line.contains("ERROR")).collect();
    for complaint in &complaints {
        println!("{}", complaint.trim());
    }
    let built = target_folder().join("book");
    let pages = pages(&built)?;
    let dead = dead(&pages, &built);
    for link in &dead {
        println!("leads nowhere: {link}");
    }
    println!("{} pages in {}", pages.len(), built.display());
    Ok(output.status.success() && complaints.is_empty() && dead.is_empty() && !pages.is_empty())
}

/// A page as built: what can be pointed at, and what it points to.
#[derive(Debug, Default)]
struct Page {
    anchors: BTreeSet<String>,
    links: Vec<String>,
}

impl Page {
    fn parse(text: &str) -> Self {
        let of = |name: &str| -> Vec<String> {
            let mark = format!(" {name}=\"");
            let parts = text.split(&mark).skip(1);
            parts.filter_map(|rest| Some(rest.split_once('"')?.0.replace("&amp;", "&"))).collect()
        };
        Self { anchors: of("id").into_iter().collect(), links: [of("href"), of("src")].concat() }
    }
}

/// Every page below a folder, by its path in it.
fn pages(folder: &Path) -> anyhow::Result<BTreeMap<PathBuf, Page>> {
    let mut folders = vec![folder.to_owned()];
    let mut pages = BTreeMap::new();
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(&next).with_context(|| next.display().to_string())? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "html") {
                let text = std::fs::read_to_string(&path).with_context(|| path.display().to_string())?;
                pages.insert(path.strip_prefix(folder)?.to_owned(), Page::parse(&text));
            }
        }
    }
    Ok(pages)
}

/// Links to files or anchors that are not there, each with its page.
fn dead(pages: &BTreeMap<PathBuf, Page>, folder: &Path) -> Vec<String> {
    let mut dead = Vec::new();
    for (path, page) in pages.iter().filter(|(path, _)| NOT_READ.iter().all(|name| !path.ends_with(name))) {
        let near = page.links.iter().filter(|link| !link.contains("://") && !link.contains(':'));
        for link in near {
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() { path.clone() } else { plain(&path.with_file_name("").join(file)) };
            let lacks = |page: &Page| !anchor.is_empty() && !page.anchors.contains(anchor);
            if !folder.join(&target).exists() || pages.get(&target).is_some_and(lacks) {
                dead.push(format!("{}: {link}", path.display()));
            }
        }
    }
    dead
}

/// A path without `.` and `..`.
pub fn plain(path: &Path) -> PathBuf {
    path.components().fold(PathBuf::new(), |mut plain, part| {
        match part {
            Component::ParentDir => {
                plain.pop();
            }
            Component::CurDir => {}
            part => plain.push(part),
        }
        plain
    })
}

#[cfg(test)]
mod tests {
    use super::{dead, pages};

    #[test]
    fn links_of_a_built_book_that_lead_nowhere_are_found() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path();
        std::fs::create_dir(place.join("guide")).unwrap();
        let links = "<a href=\"../b.html#here\"><a href=\"../b.html#gone\"><a href=\"c.html\"><a href=\"https://x.y\"><img src=\"p.png\">";
        std::fs::write(place.join("guide/a.html"), links).unwrap();
        std::fs::write(place.join("b.html"), "<h1 id=\"here\"></h1>").unwrap();
        let found = dead(&pages(place).unwrap(), place);
        assert_eq!(found, ["guide/a.html: ../b.html#gone", "guide/a.html: c.html", "guide/a.html: p.png"]);
    }
}
