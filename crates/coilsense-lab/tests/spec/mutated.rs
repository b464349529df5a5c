//! Every example with a few bytes or words of it changed at random, some thousands of times: what comes of it is read or refused in one line, soon.
//!
//! Next door: changes of one spec that is made for it, simulated as well (`hostile`), changes that a fuzzer finds (`fuzz/`).

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use coilsense_lab::spec::{Spec, TABLES};

/// What a spec may take: most take a thousandth of it, a spring of many masses far more than others.
const MOST: Duration = Duration::from_secs(30);

/// Numbers that follow from a seed.
struct Random(u64);

impl Random {
    fn below(&mut self, most: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % most.max(1)
    }

    fn one_of<'a, T: ?Sized>(&mut self, all: &[&'a T]) -> &'a T {
        all[self.below(all.len())]
    }
}

/// Every example's folder, file and text.
fn examples() -> (PathBuf, Vec<(String, String)>) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let paths = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path());
    let mut specs: Vec<PathBuf> = paths.filter(|path| path.extension().is_some_and(|end| end == "toml")).collect();
    specs.sort();
    assert!(specs.len() >= 9, "{specs:?}");
    let read = |path: &PathBuf| {
        (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read_to_string(path).unwrap())
    };
    let specs = specs.iter().map(read).collect();
    (folder, specs)
}

/// A text in words, numbers, spaces and signs, which put together are the text.
fn words(text: &str) -> Vec<&str> {
    let kind = |c: char| match c {
        c if c.is_alphanumeric() || c == '_' || c == '.' => 0,
        ' ' => 1,
        _ => 2 + c as u32,
    };
    let mut words = Vec::new();
    let mut start = 0;
    let mut before = None;
    for (at, c) in text.char_indices() {
        if before.is_some_and(|before| before != kind(c) || kind(c) > 1) {
            words.push(&text[start..at]);
            start = at;
        }
        before = Some(kind(c));
    }
    words.push(&text[start..]);
    words
}

const STRANGE: [&str; 22] = [
    "",
    "0",
    "-1",
    "-",
    "1e308",
    "1e-308",
    "nan",
    "inf",
    "0x7f",
    "9223372036854775807",
    "\"",
    "\"\"\"",
    "[",
    "[[",
    "]",
    "{",
    "=",
    ".",
    "\n",
    "#",
    "\u{0}",
    "é\u{202e}\u{1F980}",
];

/// A few words of a text replaced, doubled, left out or put elsewhere.
fn of_words(text: &str, random: &mut Random) -> String {
    let mut words = words(text);
    let keys: Vec<&str> = TABLES.iter().flat_map(|table| table.keys.iter().map(|key| key.name)).collect();
    for _ in 0..=random.below(4) {
        let (one, other) = (random.below(words.len()), random.below(words.len()));
        match random.below(6) {
            0 => words[one] = random.one_of(&STRANGE),
            1 => words[one] = random.one_of(&keys),
            2 => words[one] = words[other],
            3 => words.insert(one, words[other]),
            4 => drop(words.remove(one)),
            _ => words.swap(one, other),
        }
    }
    words.concat()
}

/// A few bytes of a text flipped, replaced, left out, or the rest of it cut off.
fn of_bytes(text: &str, random: &mut Random) -> String {
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len());
        match random.below(8) {
            0 => bytes.truncate(at.max(1)),
            1 => drop(bytes.remove(at)),
            2 => bytes.insert(at, random.below(256) as u8),
            3 => bytes[at] = random.below(256) as u8,
            _ => bytes[at] ^= 1 << random.below(8),
        }
        if bytes.is_empty() {
            bytes.push(b'\n');
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn mutations(count: usize, seed: u64) {
    let (folder, examples) = examples();
    let beside = |name: &str| -> Result<String, String> {
        std::fs::read_to_string(folder.join(name)).map_err(|error| format!("cannot be read: {}", error.kind()))
    };
    for (file, text) in &examples {
        Spec::parse(file, text, &beside).unwrap_or_else(|error| panic!("{error}"));
    }
    let mut random = Random(seed);
    let mut refused = 0;
    for turn in 0..count {
        let (file, text) = &examples[turn % examples.len()];
        let changed = if turn % 2 == 0 { of_words(text, &mut random) } else { of_bytes(text, &mut random) };
        let begun = Instant::now();
        if let Err(error) = Spec::parse(file, &changed, &beside) {
            refused += 1;
            let line = error.to_string();
            assert!(line.starts_with(file.as_str()) && !line.contains('\n'), "{line}\n{changed}");
        }
        assert!(begun.elapsed() < MOST, "{:?}\n{changed}", begun.elapsed());
    }
    // Some changes only another number or a comment, many leave no spec.
    assert!((count / 4..count).contains(&refused), "{refused} of {count}");
}

#[test]
fn an_example_of_which_a_little_is_changed_is_read_or_refused_in_one_line() {
    mutations(400, 1);
}

/// Minutes.
#[test]
#[ignore = "thousands of specs"]
fn four_thousand_changed_examples_are_read_or_refused_in_one_line() {
    mutations(4000, 2);
}
