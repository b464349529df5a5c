//! The options of all verbs as a page of the book.
//!
//! Next door: the options themselves (`verbs`).

use super::verbs::VERBS;
use crate::request::{Door, IfAbsent, Row, Takes, Verb};

const HEAD: &str = "\
# Options

What may be asked of each verb. The command takes an option as `--name VALUE`, Python as `name=`, with `_` for each `-`; a quantity is a number with its
unit, as in `\"2.5 kHz\"`, and in Python a number in SI units, too. Made from the tables in the code:
`COILSENSE_WRITE_DOCS=1 cargo nextest run -p coilsense-lab -E 'binary(requests)'`.
";

/// The page.
pub fn options_markdown() -> String {
    let mut verbs = VERBS.to_vec();
    verbs.sort_by_key(|verb| verb.name);
    let sections = verbs.iter().map(section);
    std::iter::once(HEAD.to_owned()).chain(sections).collect::<Vec<_>>().join("\n")
}

fn section(verb: &Verb) -> String {
    let mut text = format!("## {}\n\n{}.\n", verb.name, verb.about.trim_end_matches('.'));
    let mut headings: Vec<&str> = Vec::new();
    verb.rows().for_each(|row| {
        if !headings.contains(&row.heading) {
            headings.push(row.heading);
        }
    });
    for heading in headings {
        if !heading.is_empty() {
            text.push_str(&format!("\n### {heading}\n"));
        }
        text.push_str("\n| option | takes | allowed | default | meaning |\n|---|---|---|---|---|\n");
        let rows = verb.rows().filter(|row| row.heading == heading);
        rows.for_each(|row| text.push_str(&line(row)));
    }
    if !verb.more.is_empty() {
        text.push_str(&format!("\n```text\n{}\n```\n", verb.more));
    }
    text
}

fn line(row: &Row) -> String {
    let name = match (row.elsewhere(Door::Command), row.by_place) {
        (Some(_), _) => format!("`{}`", row.flag()),
        (None, true) => format!("`{}`", row.value_name()),
        (None, false) => format!("`--{}`", row.flag()),
    };
    let doors = row.elsewhere.iter().map(|(door, what)| match door {
        Door::Command => format!("; command: {what}"),
        Door::Python => format!("; Python: {what}"),
        Door::Page => format!("; page: {what}"),
    });
    let meaning = format!("{}{}", row.meaning, doors.collect::<String>());
    let default = match row.if_absent {
        IfAbsent::Nothing => String::new(),
        IfAbsent::Value(text) => format!("`{text}`"),
        IfAbsent::Found(words) => words.to_owned(),
        IfAbsent::Refused => "must be given".to_owned(),
        IfAbsent::RefusedWithout(other) => format!("must be given without `--{other}`"),
    };
    let cells = [name, takes(row), allowed(row), default, meaning];
    format!("| {} |\n", cells.map(|cell| escaped(&cell)).join(" | "))
}

/// A cell as Markdown has it: no bar ends it, and outside of code no tag begins.
fn escaped(cell: &str) -> String {
    let parts = cell.split('`').enumerate();
    let parts = parts.map(|(place, part)| if place % 2 == 0 { part.replace('<', "\\<") } else { part.to_owned() });
    parts.collect::<Vec<_>>().join("`").replace('|', "\\|")
}

fn takes(row: &Row) -> String {
    let what = match row.takes {
        Takes::Quantity(dimension) => dimension.name().to_owned(),
        Takes::Number => "a number".to_owned(),
        Takes::Count => "a whole number".to_owned(),
        Takes::Flag => "nothing".to_owned(),
        Takes::Word(_) => "a word".to_owned(),
        Takes::Date => "a day".to_owned(),
        Takes::Text(name) | Takes::Form(name, _) | Takes::File(name) => format!("`{name}`"),
    };
    if row.repeated { format!("{what}, repeatedly") } else { what }
}

fn allowed(row: &Row) -> String {
    let words = match row.takes {
        Takes::Word(words) => words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", "),
        _ => row.allowed_in_words(),
    };
    let others = |what: &str, names: &[&str]| {
        let names: Vec<String> = names.iter().map(|name| format!("`{}`", name.replace('_', "-"))).collect();
        if names.is_empty() { String::new() } else { format!("{what} {}", names.join(", ")) }
    };
    let parts = [words, others("not beside", row.conflicts), others("only beside", row.requires)];
    parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join("; ")
}
