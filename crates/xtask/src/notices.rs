//! Licences of all that is shipped beside our own code, with their texts: `web/public/notices.txt` for the page.
//!
//! Next door: who ships it (`page`).

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, bail, ensure};
use serde::Deserialize;

use crate::{cargo, root};

/// How files begin that hold a licence or what it wants to be said.
const TEXTS: [&str; 5] = ["license", "licence", "copying", "notice", "unlicense"];

/// What Cargo knows of the packages, as far as it is read.
#[derive(Deserialize)]
struct Metadata {
    packages: Vec<Package>,
}

#[derive(Deserialize)]
struct Package {
    name: String,
    version: String,
    license: Option<String>,
    repository: Option<String>,
    manifest_path: PathBuf,
    source: Option<String>,
}

/// One work of others, with where it is from and what its licence says.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Work {
    heading: String,
    texts: Vec<String>,
}

/// Writes the notices of the page: the crates of its engines, the packages of its JavaScript.
pub fn of_page() -> anyhow::Result<()> {
    let mut works = crates("coilsense-web", "workshop", "wasm32-unknown-unknown")?;
    works.extend(packages()?);
    works.sort();
    let public = root().join("web/public");
    std::fs::create_dir_all(&public)?;
    std::fs::write(public.join("notices.txt"), written(&works)).context("the notices cannot be written")
}

/// All works, the texts that several share once.
fn written(works: &[Work]) -> String {
    let mut shared: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for work in works {
        for text in &work.texts {
            shared.entry(text).or_default().push(&work.heading);
        }
    }
    let headings: String = works.iter().map(|work| format!("  {}\n", work.heading)).collect();
    let texts: String = shared
        .iter()
        .map(|(text, of)| format!("\n{}\n\nof {}\n\n{}\n", "=".repeat(80), of.join("\n   "), text.trim()))
        .collect();
    format!("coilsense is made with the works of others, under their licences:\n\n{headings}{texts}")
}

/// The crates that are linked into a package with these features, on a target.
fn crates(package: &str, features: &str, target: &str) -> anyhow::Result<Vec<Work>> {
    // Of this package alone: what others of the workspace ask of the same crates is not in it. What only builds or tests is not shipped.
    let tree = ["tree", "--locked", "--package", package, "--features", features, "--target", target];
    let linked = told(cargo(&tree).args(["--edges", "normal", "--prefix", "none", "--format", "{p}"]))?;
    let linked: BTreeSet<(&str, &str)> = linked
        .lines()
        .filter_map(|line| {
            let mut words = line.split(' ');
            Some((words.next()?, words.next()?.strip_prefix('v')?))
        })
        .collect();
    let metadata = told(&mut cargo(&["metadata", "--format-version", "1", "--locked", "--filter-platform", target]))?;
    let metadata: Metadata = serde_json::from_str(&metadata).context("what cargo metadata prints")?;
    let is_linked = |one: &&Package| linked.contains(&(one.name.as_str(), one.version.as_str()));
    metadata.packages.iter().filter(is_linked).filter(|one| one.source.is_some()).map(of_crate).collect()
}

/// What a command prints.
fn told(command: &mut Command) -> anyhow::Result<String> {
    let output = command.output().context("cargo cannot be started")?;
    ensure!(output.status.success(), "cargo failed: {}", String::from_utf8_lossy(&output.stderr).trim());
    String::from_utf8(output.stdout).context("what cargo prints")
}

fn of_crate(package: &Package) -> anyhow::Result<Work> {
    let Package { name, version, license, repository, manifest_path, .. } = package;
    let license = license.as_deref().with_context(|| format!("{name} {version} has no licence"))?;
    let place = repository.as_deref().map_or(String::new(), |repository| format!(", {repository}"));
    let heading = format!("{name} {version}, {license}{place}");
    Ok(Work { heading, texts: texts(manifest_path.parent().unwrap_or(manifest_path))? })
}

/// The packages of JavaScript whose code is in the page.
fn packages() -> anyhow::Result<Vec<Work>> {
    #[derive(Deserialize)]
    struct Manifest {
        dependencies: BTreeMap<String, String>,
    }
    #[derive(Deserialize)]
    struct Installed {
        license: String,
        version: String,
    }
    let read = |path: PathBuf| std::fs::read_to_string(&path).with_context(|| format!("{}", path.display()));
    let manifest: Manifest = serde_json::from_str(&read(root().join("web/package.json"))?)?;
    let of_name = |name: &String| {
        let folder = root().join("web/node_modules").join(name);
        let installed: Installed = serde_json::from_str(&read(folder.join("package.json"))?)?;
        let texts = texts(&folder)?;
        if texts.is_empty() {
            bail!("{name} has no text of its licence");
        }
        Ok(Work { heading: format!("{name} {}, {}", installed.version, installed.license), texts })
    };
    manifest.dependencies.keys().map(of_name).collect()
}

/// The texts of licences in a folder, by the names of their files.
fn texts(folder: &Path) -> anyhow::Result<Vec<String>> {
    let mut found: Vec<PathBuf> = std::fs::read_dir(folder)
        .with_context(|| format!("{}", folder.display()))?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<_, _>>()?;
    found.sort();
    let is_text = |path: &&PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_lowercase();
        path.is_file() && TEXTS.iter().any(|begin| name.starts_with(begin))
    };
    let read = |path: &PathBuf| std::fs::read(path).map(|bytes| String::from_utf8_lossy(&bytes).replace("\r\n", "\n"));
    Ok(found.iter().filter(is_text).map(read).collect::<Result<_, _>>()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_crate_of_the_engines_is_named_with_its_licence() {
        let works = crates("coilsense-web", "workshop", "wasm32-unknown-unknown").expect("the crates");
        for name in ["nalgebra ", "wasm-bindgen ", "serde_json ", "realfft "] {
            let work = works.iter().find(|work| work.heading.starts_with(name)).unwrap_or_else(|| panic!("{name}"));
            assert!(!work.texts.is_empty(), "{name}");
        }
        // Ours are not works of others, and what only tests is not shipped.
        assert!(
            works.iter().all(|work| !work.heading.starts_with("coilsense") && !work.heading.starts_with("proptest"))
        );
    }

    #[test]
    fn a_text_that_two_share_stands_once() {
        let one = |name: &str| Work { heading: name.to_owned(), texts: vec!["the text".to_owned()] };
        let written = written(&[one("a"), one("b")]);
        assert_eq!(written.matches("the text").count(), 1);
        assert!(written.contains("of a\n   b\n"));
    }
}
