//! Data flows one way: no top-level module of a crate names one that names it back, and `lib.rs` says in a line what each is.
//!
//! Next door: what a file says (`source`), arrows and loops (`graph`).

mod graph;
mod source;

use graph::Graph;
use source::Source;

/// The graph of one of our crates, by its name.
fn graph_of(name: &str) -> Graph {
    let folder = crate::root().join("crates").join(name).join("src");
    let graph = Graph::of(&folder).unwrap_or_else(|error| panic!("{name}: {error}"));
    println!("{name}: {} files, {} modules, {} arrows", graph.files, graph.modules.len(), graph.arrows.len());
    graph
}

/// Line and path of all that a text in module `here` mentions.
fn paths(text: &str, here: &[&str]) -> Vec<String> {
    let here: Vec<String> = here.iter().map(|name| (*name).to_owned()).collect();
    let source = Source::read(text, &here).unwrap();
    source.mentions.iter().map(|mention| format!("{} {}", mention.line, mention.path.join("::"))).collect()
}

#[test]
fn no_module_names_one_that_names_it_back() {
    let mut found = Vec::new();
    for name in ["coilsense", "coilsense-lab", "coilsense-figure"] {
        let graph = graph_of(name);
        found.extend(
            graph.loops().iter().map(|arrows| format!("{name}: modules in a loop:\n{}", graph.described(arrows))),
        );
    }
    assert!(
        found.is_empty(),
        "{}\nMove what both need to the lower one, or hand it over as an argument.",
        found.join("\n")
    );
}

/// Folders with modules in a crate, as paths of names from its root.
fn folders(graph: &Graph, source: &std::path::Path, at: &[String]) -> Vec<Vec<String>> {
    let children = graph.modules.iter().map(|child| [at, std::slice::from_ref(&child.name)].concat());
    let is_folder =
        |path: &Vec<String>| source.join(path.iter().collect::<std::path::PathBuf>()).join("mod.rs").is_file();
    let below = |path: Vec<String>| {
        let inner = Graph::within(source, &path).unwrap_or_else(|error| panic!("{}: {error}", path.join("::")));
        [vec![path.clone()], folders(&inner, source, &path)].concat()
    };
    children.filter(is_folder).flat_map(below).collect()
}

#[test]
fn no_file_names_one_beside_it_that_names_it_back() {
    let mut found = Vec::new();
    for name in ["coilsense", "coilsense-lab", "coilsense-figure"] {
        let source = crate::root().join("crates").join(name).join("src");
        for path in folders(&graph_of(name), &source, &[]) {
            let graph = Graph::within(&source, &path).unwrap();
            let told =
                |arrows: &Vec<graph::Arrow>| format!("{name}::{}:\n{}", path.join("::"), graph.described(arrows));
            found.extend(graph.loops().iter().map(told));
        }
    }
    assert!(found.is_empty(), "{} loops of files:\n{}", found.len(), found.join("\n"));
}

#[test]
fn lib_rs_says_in_a_line_what_each_module_is() {
    for name in ["coilsense", "coilsense-lab", "coilsense-figure"] {
        let graph = graph_of(name);
        let others = graph.modules.iter().filter(|module| module.documentation != 1);
        let others: Vec<&str> = others.map(|module| module.name.as_str()).collect();
        assert!(others.is_empty(), "{name}: lib.rs needs one line of /// right before each of: {}", others.join(", "));
    }
}

#[test]
fn a_path_is_found_in_a_use_in_code_and_in_a_macro() {
    let text = "use crate::spring::Spring;\nuse crate::{modes, motion::{Motion, self}};\nfn f() -> crate::Error {\n\
                println!(\"{}\", crate::simd::level());\nwhere_is::<crate::a::B>() }";
    let found = paths(text, &["sensors"]);
    assert_eq!(
        found,
        ["1 spring::Spring", "2 modes", "2 motion::Motion", "2 motion", "3 Error", "4 simd::level", "5 a::B"]
    );
}

#[test]
fn a_parent_is_followed_to_the_root() {
    let text = "use super::x;\nuse super::super::y;\nmod inner { fn f() { super::super::z::w(); } }";
    assert_eq!(paths(text, &["a", "b"]), ["1 a::x", "2 y", "3 a::z::w"]);
}

#[test]
fn comments_strings_and_tests_draw_no_arrow() {
    let text = "//! [`crate::a`]\n/// [`x`](crate::b)\n// crate::c\nconst D: &str = \"crate::d\";\n#[cfg(test)]\nuse crate::e::{f};\n\
                #[cfg(test)]\nmod tests { use crate::g; }\n#[cfg(test)]\nmod more;\nuse crate::h;";
    let source = Source::read(text, &["here".to_owned()]).unwrap();
    assert!(source.modules.is_empty());
    assert_eq!(paths(text, &["here"]), ["11 h"]);
}

#[test]
fn the_lines_before_a_module_are_counted() {
    let text = "//! All.\n\n/// One.\npub mod a;\n/// One.\n/// Two.\npub(crate) mod b;\nmod c;\n/// One.\n#[cfg(unix)]\nmod d;\n\
                pub use a::{Spring, deep::Coil};";
    let source = Source::read(text, &[]).unwrap();
    let counts: Vec<(&str, usize)> =
        source.modules.iter().map(|module| (module.name.as_str(), module.documentation)).collect();
    assert_eq!(counts, [("a", 1), ("b", 2), ("c", 0), ("d", 1)]);
    assert_eq!(source.exports[1].1, ["a", "deep", "Coil"]);
}

#[test]
fn a_loop_is_named_with_its_arrows_and_their_places() {
    let folder = tempfile::tempdir().unwrap();
    let write = |file: &str, text: &str| std::fs::write(folder.path().join(file), text).unwrap();
    std::fs::create_dir(folder.path().join("spring")).unwrap();
    write("lib.rs", "mod error;\nmod spring;\nmod motion;\npub use motion::Motion;");
    write("error.rs", "");
    write("spring/mod.rs", "mod chain;\n#[cfg(test)]\nmod tests;");
    write("spring/chain.rs", "use super::super::error;\n\nfn f(_: &crate::Motion) {}");
    write("motion.rs", "use super::spring;");
    let graph = Graph::of(folder.path()).unwrap();
    let loops = graph.loops();
    assert_eq!(loops.len(), 1);
    assert_eq!(
        graph.described(&loops[0]),
        "    motion -> spring  at motion.rs:1\n    spring -> motion  at spring/chain.rs:3"
    );
}
