//! Which of some known names a person probably meant.
//!
//! Next door: what is said of it (`spec`, `recording`, `sweep`).

/// From so large a share of letters on that stay where they are two words are alike; one letter of three, two of five may be wrong.
const ALIKE: f64 = 0.6;
/// A word may be cut down to so many letters.
const SHORTEST: usize = 3;

/// The known name most like `text`; none where nothing is like it.
///
/// Words that both share, such as the `diameter` of `outer_diameter` and `wire_diameter`, make no likeness: the others must be alike.
pub(crate) fn nearest<'a>(text: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let likeness = |name: &str| strsim::jaro_winkler(text, name);
    let alike = known.into_iter().filter(|name| alike(text, name));
    alike.max_by(|a, b| likeness(a).total_cmp(&likeness(b)))
}

/// Whether one name may be meant by the other: all words of one stand in the other, or those that do not are alike.
pub(crate) fn alike(one: &str, other: &str) -> bool {
    let (mut ours, mut theirs) = (words(one), words(other));
    ours.retain(|word| match theirs.iter().position(|other| other == word) {
        Some(place) => {
            theirs.remove(place);
            false
        }
        None => true,
    });
    if ours.is_empty() || theirs.is_empty() {
        return words(one).len() + words(other).len() > ours.len() + theirs.len();
    }
    let (ours, theirs) = (ours.join("_"), theirs.join("_"));
    let cut = ours.len().min(theirs.len()) >= SHORTEST && (ours.starts_with(&theirs) || theirs.starts_with(&ours));
    let longest = ours.chars().count().max(theirs.chars().count()) as f64;
    cut || 1.0 - strsim::osa_distance(&ours, &theirs) as f64 / longest >= ALIKE
}

fn words(name: &str) -> Vec<String> {
    let each = name.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    each.map(str::to_lowercase).collect()
}

#[cfg(test)]
mod tests {
    use super::{alike, nearest};

    #[test]
    fn slips_cuts_and_missing_words_are_alike() {
        for (text, name) in [
            ("stifness", "stiffness"),
            ("resolutoin", "resolution"),
            ("damping", "damping_ratio"),
            ("spring_stiffness", "stiffness"),
            ("CoilDiameter", "coil_diameter"),
            ("sample-rate", "sample_rate"),
            ("freq", "frequency"),
            ("mas", "mass"),
            ("mounting", "mount"),
            ("F_o.rms", "F_o.rmsd"),
        ] {
            assert!(alike(text, name), "{text}, {name}");
        }
    }

    #[test]
    fn a_shared_word_or_a_shared_letter_is_no_likeness() {
        for (text, name) in [
            ("outer_diameter", "wire_diameter"),
            ("zeta", "end_mass"),
            ("speed", "sample_rate"),
            ("pitch", "resistivity"),
            ("pitch", "width"),
            ("nix", "time"),
            ("x", "force"),
            ("", "force"),
        ] {
            assert!(!alike(text, name), "{text}, {name}");
        }
        assert_eq!(nearest("nix", ["time", "u1", "F_o"]), None);
        assert_eq!(nearest("forse", ["time", "force", "F_o"]), Some("force"));
    }
}
