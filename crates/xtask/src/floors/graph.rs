//! Which top-level module of a crate names which: its files, followed from `lib.rs`, and the loops among the arrows between them.
//!
//! Next door: what a single file says (`source`).

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::path::{Path, PathBuf};

use super::source::{Module, Source};

/// An arrow: who names whom.
pub type Arrow = [String; 2];

/// A crate's top-level modules and the arrows between them, each with the places that draw it, as `file:line`.
#[derive(Debug, Default)]
pub struct Graph {
    /// As `lib.rs` lists them.
    pub modules: Vec<Module>,
    /// Number of files read.
    pub files: usize,
    /// Who names whom, and where.
    pub arrows: BTreeMap<Arrow, Vec<String>>,
}

impl Graph {
    /// Of the crate whose `lib.rs` lies in this folder.
    pub fn of(folder: &Path) -> Result<Self, String> {
        Self::within(folder, &[])
    }

    /// Of the files that a module consists of, itself above them all.
    pub fn within(folder: &Path, module: &[String]) -> Result<Self, String> {
        let file = if module.is_empty() { folder.join("lib.rs") } else { file_of(folder, module)? };
        let root = read(&file, module)?;
        let mut graph = Self { modules: root.modules.clone(), files: 1, ..Self::default() };
        for child in root.modules.iter().filter(|child| child.in_own_file) {
            graph.follow(folder, &root, &[module, std::slice::from_ref(&child.name)].concat(), module.len())?;
        }
        Ok(graph)
    }

    /// Takes a module's file and those of the modules in it; modules are told apart by the name at a depth of their paths.
    fn follow(&mut self, folder: &Path, root: &Source, path: &[String], depth: usize) -> Result<(), String> {
        let file = file_of(folder, path)?;
        let source = read(&file, path)?;
        self.files += 1;
        for mention in &source.mentions {
            let place = format!("{}:{}", file.strip_prefix(folder).unwrap_or(&file).display(), mention.line);
            let Some(below) = mention.path.strip_prefix(&path[..depth]).filter(|below| !below.is_empty()) else {
                continue;
            };
            let target = match target(root, below, depth) {
                // What a module's own file holds stands above its children.
                Err(_) if depth > 0 => continue,
                target => target.map_err(|unknown| format!("{place}: {unknown}"))?,
            };
            if let Some(target) = target.filter(|target| *target != path[depth]) {
                self.arrows.entry([path[depth].clone(), target]).or_default().push(place);
            }
        }
        for module in source.modules.iter().filter(|module| module.in_own_file) {
            self.follow(folder, root, &[path, std::slice::from_ref(&module.name)].concat(), depth)?;
        }
        Ok(())
    }

    /// A loop of every tangle, the shortest first, and what is left of a tangle once the arrow of that loop with the fewest places is
    /// gone: with these arrows cut there is none.
    pub fn loops(&self) -> Vec<Vec<Arrow>> {
        let mut left: BTreeSet<&Arrow> = self.arrows.keys().collect();
        let mut loops = Vec::new();
        while let Some(found) = left.iter().filter_map(|arrow| closed(&left, arrow)).min_by_key(Vec::len) {
            if let Some(thinnest) = found.iter().min_by_key(|arrow| self.arrows[*arrow].len()) {
                left.remove(thinnest);
            }
            loops.push(found);
        }
        loops
    }

    /// A loop in words: its arrows, each with where it is drawn.
    pub fn described(&self, arrows: &[Arrow]) -> String {
        let line = |arrow: &Arrow| {
            let places = &self.arrows[arrow];
            let more = if places.len() > 3 { format!(" and {} more", places.len() - 3) } else { String::new() };
            format!("    {} -> {}  at {}{more}", arrow[0], arrow[1], places[..places.len().min(3)].join(", "))
        };
        arrows.iter().map(line).collect::<Vec<_>>().join("\n")
    }
}

/// The shortest loop that an arrow begins, where there is one.
fn closed(arrows: &BTreeSet<&Arrow>, first: &Arrow) -> Option<Vec<Arrow>> {
    let mut ways = VecDeque::from([vec![first.clone()]]);
    let mut seen = BTreeSet::from([first[1].clone()]);
    while let Some(way) = ways.pop_front() {
        let end = &way[way.len() - 1][1];
        if *end == first[0] {
            return Some(way);
        }
        for arrow in arrows.iter().filter(|arrow| arrow[0] == *end) {
            if seen.insert(arrow[1].clone()) {
                ways.push_back([way.as_slice(), &[(*arrow).clone()]].concat());
            }
        }
    }
    None
}

/// The top-level module that a path from the root leads to, also by a name that `lib.rs` exports; none for what `lib.rs` has from elsewhere.
fn target(root: &Source, path: &[String], depth: usize) -> Result<Option<String>, String> {
    let is_module = |name: &str| root.modules.iter().any(|module| module.name == name);
    if is_module(&path[0]) {
        return Ok(Some(path[0].clone()));
    }
    match root.exports.iter().find(|(name, _)| *name == path[0]) {
        Some((_, origin)) => Ok(origin.get(depth).cloned().filter(|origin| is_module(origin))),
        None => Err(format!("lib.rs has neither a module nor an export `{}`", path[0])),
    }
}

fn file_of(folder: &Path, path: &[String]) -> Result<PathBuf, String> {
    let stem: PathBuf = folder.join(path.iter().collect::<PathBuf>());
    let candidates = [stem.with_extension("rs"), stem.join("mod.rs")];
    let found = candidates.into_iter().find(|file| file.is_file());
    found.ok_or_else(|| format!("{}: no such module", stem.display()))
}

fn read(file: &Path, path: &[String]) -> Result<Source, String> {
    let text = std::fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))?;
    Source::read(&text, path).map_err(|error| format!("{}: {error}", file.display()))
}
