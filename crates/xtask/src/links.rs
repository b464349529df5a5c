//! What README and book point to is there: files, headings, and every page of the book in its table of contents.
//!
//! Next door: that their commands, Rust and Python run (`test`).

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use crate::book::plain;

/// A page of Markdown: the anchors of its headings, and where its links point to.
#[derive(Debug, Default)]
struct Page {
    anchors: BTreeSet<String>,
    links: Vec<String>,
}

impl Page {
    fn parse(text: &str) -> Self {
        let mut page = Self::default();
        let mut heading: Option<String> = None;
        for event in Parser::new_ext(text, Options::ENABLE_TABLES) {
            match event {
                Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
                Event::End(TagEnd::Heading(_)) => page.anchors.extend(heading.take().map(|words| anchor(&words))),
                Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                    page.links.push(dest_url.to_string());
                }
                Event::Text(words) | Event::Code(words) => {
                    if let Some(heading) = &mut heading {
                        heading.push_str(&words);
                    }
                }
                _ => {}
            }
        }
        page
    }
}

/// The anchor that mdBook and GitHub make of a heading.
fn anchor(heading: &str) -> String {
    let kept = heading.trim().chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c }).flat_map(char::to_lowercase).collect()
}

fn pages_in(folder: &Path, found: &mut BTreeMap<PathBuf, Page>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            pages_in(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "md") {
            found.insert(plain(&path), Page::parse(&std::fs::read_to_string(&path).unwrap()));
        }
    }
}

/// Links of these pages that lead nowhere, each with its page.
fn dead(pages: &BTreeMap<PathBuf, Page>) -> Vec<String> {
    let leads_nowhere = |at: &Path, link: &str| {
        let (file, heading) = link.split_once('#').unwrap_or((link, ""));
        let target = if file.is_empty() { at.to_owned() } else { plain(&at.parent().unwrap_or(at).join(file)) };
        let lacks = |page: &Page| !heading.is_empty() && !page.anchors.contains(heading);
        !target.exists() || pages.get(&target).is_some_and(lacks)
    };
    let of_page = |(path, page): (&PathBuf, &Page)| {
        let near = page.links.iter().filter(|link| !link.contains("://") && !link.starts_with("mailto:"));
        let dead = near.filter(|link| leads_nowhere(path, link));
        dead.map(|link| format!("{}: {link}", path.display())).collect::<Vec<_>>()
    };
    pages.iter().flat_map(of_page).collect()
}

#[test]
fn every_link_of_readme_and_book_leads_somewhere() {
    let root = crate::root();
    let mut pages = BTreeMap::new();
    pages_in(&root.join("book/src"), &mut pages);
    for readme in
        ["README.md", "CONTRIBUTING.md", "SECURITY.md", "reference/README.md", "bench/README.md", "examples/README.md"]
    {
        let path = plain(&root.join(readme));
        pages.insert(path.clone(), Page::parse(&std::fs::read_to_string(path).unwrap()));
    }
    let dead = dead(&pages);
    assert!(dead.is_empty(), "links that lead nowhere:\n{}", dead.join("\n"));
}

#[test]
fn every_page_of_the_book_is_in_its_contents_once() {
    let source = plain(&crate::root().join("book/src"));
    let mut pages = BTreeMap::new();
    pages_in(&source, &mut pages);
    let contents = pages.remove(&source.join("SUMMARY.md")).unwrap();
    let mut listed: Vec<PathBuf> = contents.links.iter().map(|link| plain(&source.join(link))).collect();
    listed.sort();
    assert_eq!(listed, pages.into_keys().collect::<Vec<_>>());
}

#[test]
fn a_link_to_a_file_or_a_heading_that_is_not_there_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let place = plain(folder.path());
    std::fs::write(place.join("a.md"), "# A `b`: c\n[up](#a-b-c) [other](b.md#none) [gone](c.md) [far](https://x.y)")
        .unwrap();
    std::fs::write(place.join("b.md"), "## Here\n").unwrap();
    let mut pages = BTreeMap::new();
    pages_in(&place, &mut pages);
    let a = place.join("a.md");
    assert_eq!(dead(&pages), [format!("{}: b.md#none", a.display()), format!("{}: c.md", a.display())]);
}
