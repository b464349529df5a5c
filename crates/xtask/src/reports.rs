//! What a reader finds in reports: no number as a program writes it.
//!
//! Next door: who makes them (`commands`), whether one opens (`browser`).

use std::path::Path;

use anyhow::Context;

/// Elements whose text is a program's.
const CODE: [&str; 5] = ["script", "style", "pre", "code", "title"];

/// Whether every `report.html` below a folder has its numbers set as they are printed; what is not is told.
pub fn are_set(folder: &Path) -> anyhow::Result<bool> {
    let mut all = true;
    for entry in std::fs::read_dir(folder).with_context(|| folder.display().to_string())? {
        let path = entry?.path();
        if path.is_dir() {
            all &= are_set(&path)?;
        } else if path.ends_with("report.html") {
            let page = std::fs::read_to_string(&path).with_context(|| path.display().to_string())?;
            for number in unset(&page) {
                println!("{}: {number}", path.display());
                all = false;
            }
        }
    }
    Ok(all)
}

/// Numbers of a page with a hyphen for a minus, with an `e` for a power of ten, or zero with a sign.
fn unset(page: &str) -> Vec<String> {
    let text = shown(page);
    let words = text.split(|letter: char| letter.is_whitespace() || "()[],;/…±".contains(letter));
    words.filter(|word| is_unset(word.trim_end_matches(['.', ':', '%']))).map(str::to_owned).collect()
}

fn is_unset(word: &str) -> bool {
    let unsigned = word.trim_start_matches(['-', '\u{2212}']);
    let Ok(number) = unsigned.parse::<f64>() else { return false };
    let has_digits = unsigned.starts_with(|letter: char| letter.is_ascii_digit());
    has_digits && (word.starts_with('-') || unsigned.contains('e') || (number == 0.0 && word.len() > unsigned.len()))
}

/// The text of a page as it is read, elements apart from each other; without scripts, styles and code.
fn shown(page: &str) -> String {
    let mut text = String::new();
    let mut rest = page;
    while let Some((before, tag)) = rest.split_once('<') {
        text.push_str(before);
        text.push('\n');
        let name: String = tag.chars().take_while(char::is_ascii_alphanumeric).collect();
        let end = if CODE.contains(&name.as_str()) { format!("</{name}") } else { String::new() };
        let behind = tag.split_once(&end).map_or("", |(_, behind)| behind);
        rest = behind.split_once('>').map_or("", |(_, behind)| behind);
    }
    text + rest
}

#[cfg(test)]
mod tests {
    use super::unset;

    #[test]
    fn numbers_as_programs_write_them_are_found_and_code_is_left_alone() {
        let page = "<title>-1</title><p class=\"-2\">m -10 %, \u{2212}3, (-4), 5e-6 N, -0.00 \u{2212}0 2026-11-28 k -x 10²</p><pre>-7</pre>\
            <svg><text x=\"-8\">-9</text></svg><p>8.</p>";
        assert_eq!(unset(page), ["-10", "-4", "5e-6", "-0.00", "\u{2212}0", "-9"]);
    }
}
