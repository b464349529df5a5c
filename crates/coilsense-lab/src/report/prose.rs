//! Small matters of text that all pages share.
//!
//! Next door: the pages.

/// A sentence whose numbers stay with their units, and `ζ = 0.02` in one piece, where a line ends.
pub(super) fn unbroken(text: &str) -> String {
    let mut together = text.replace("ζ = ", "ζ\u{a0}=\u{a0}").replace(" e = ", " e\u{a0}=\u{a0}");
    for unit in ["N", "%", "Hz", "ms", "mm"] {
        for digit in '0'..='9' {
            together = together.replace(&format!("{digit} {unit}"), &format!("{digit}\u{a0}{unit}"));
        }
    }
    together
}

/// A file's own name: where it lay is the reader's matter, and would differ from machine to machine.
pub(super) fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

/// A name that the figures' lettering prints as it is.
pub(super) fn plain(name: &str) -> String {
    name.replace('_', "\\_").replace('^', "\\^")
}
