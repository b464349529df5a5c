//! Text with sub- and superscripts: its markup, its width, and its outlines.
//!
//! The face is DejaVu Sans Condensed, about as wide as the Arial and Helvetica that browsers
//! show, so that one layout serves both writers. Where a text stands is `layout`'s matter.

use std::sync::LazyLock;

use ttf_parser::{Face, OutlineBuilder};

/// Letter size of a script against its base.
pub(crate) const SCRIPT_SIZE: f64 = 0.74;

/// Width of a letter that the face does not know, in letter sizes.
const UNKNOWN_ADVANCE: f64 = 0.6;

static FACE: LazyLock<Option<Face<'static>>> = LazyLock::new(|| Face::parse(dejavu::sans_condensed::regular(), 0).ok());

/// The line on which letters stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Level {
    Base,
    Below,
    Above,
}

impl Level {
    /// How far the level lies below the baseline, in letter sizes of the base.
    pub fn drop(self) -> f64 {
        match self {
            Self::Base => 0.0,
            Self::Below => 0.2,
            Self::Above => -0.36,
        }
    }

    /// Letter size against the base.
    pub fn size(self) -> f64 {
        if self == Self::Base { 1.0 } else { SCRIPT_SIZE }
    }
}

/// Splits markup into pieces of one level: `_` and `^` take the next letter or `{…}`, and a
/// backslash takes their meaning away.
pub(crate) fn pieces(markup: &str) -> Vec<(Level, String)> {
    let mut pieces: Vec<(Level, String)> = Vec::new();
    let mut letters = markup.chars().peekable();
    while let Some(letter) = letters.next() {
        let level = match letter {
            '_' => Level::Below,
            '^' => Level::Above,
            _ => Level::Base,
        };
        let text: String = if level != Level::Base && letters.next_if_eq(&'{').is_some() {
            letters.by_ref().take_while(|inner| *inner != '}').collect()
        } else if level != Level::Base {
            letters.next().into_iter().collect()
        } else if letter == '\\' {
            letters.next_if(|next| "_^\\".contains(*next)).unwrap_or(letter).into()
        } else {
            letter.into()
        };
        match pieces.last_mut() {
            Some((last, run)) if *last == level => run.push_str(&text),
            _ => pieces.push((level, text)),
        }
    }
    pieces
}

/// The text without its markup, for those who hear it.
pub(crate) fn plain(markup: &str) -> String {
    pieces(markup).into_iter().map(|(_, text)| text).collect()
}

/// Width of a text \[px\] at a letter size \[px\].
pub(crate) fn width(markup: &str, size: f64) -> f64 {
    pieces(markup).iter().map(|(level, text)| text.chars().map(advance).sum::<f64>() * level.size() * size).sum()
}

/// A text in lines no wider than `room` \[px\] at a letter size \[px\], as far as its words
/// allow; a no-break space holds words together.
pub(crate) fn wrapped(text: &str, room: f64, size: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let breaks = |letter: char| letter.is_whitespace() && letter != '\u{a0}';
    for word in text.split(breaks).filter(|word| !word.is_empty()) {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), size) <= room => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Traces the letters from the origin to the right, y upwards, in font units.
///
/// Before each letter `place` learns where it stands, in letter sizes, and what one font unit
/// is, in the same.
pub(crate) fn outline<B: OutlineBuilder>(markup: &str, builder: &mut B, place: impl Fn(&mut B, [f64; 2], f64)) {
    let Some(face) = FACE.as_ref() else { return };
    let mut across = 0.0;
    for (level, text) in pieces(markup) {
        for letter in text.chars() {
            place(builder, [across, -level.drop()], level.size() / f64::from(face.units_per_em()));
            if let Some(glyph) = face.glyph_index(letter) {
                face.outline_glyph(glyph, builder);
            }
            across += advance(letter) * level.size();
        }
    }
}

/// Width of one letter, in letter sizes.
fn advance(letter: char) -> f64 {
    let known = FACE.as_ref().and_then(|face| {
        let units = face.glyph_hor_advance(face.glyph_index(letter)?)?;
        Some(f64::from(units) / f64::from(face.units_per_em()))
    });
    known.unwrap_or(UNKNOWN_ADVANCE)
}
