//! What a column may be, by its unit and the words of its title, in English, German, French, Spanish and Dutch.
//!
//! A unit says more than a word: what is measured in a length is never a force. Next door: what a title tells for certain (`selection`), who
//! proposes a guess (`proposal`), who shows it (`first_look`).

use coilsense::Channel;

use super::title::Title;
use super::unit;
use crate::quantity::Dimension;

/// Words of titles, in lower case: `=` before a word wants a word of the title to be just it, `^` to begin with it; else it may stand anywhere.
type Words = &'static [&'static str];

/// Of columns of time, beside those names that are taken for it.
const TIME: Words = &[
    "zeit", "uhr", "temps", "tiempo", "tempo", "tijd", "clock", "elapsed", "date", "datum", "stamp", "time", "sec",
    "sekunde", "=durée",
];
const FORCE: Words = &[
    "force",
    "kraft",
    "load",
    "cell",
    "fuerza",
    "effort",
    "kracht",
    "carga",
    "celda",
    "belasting",
    "thrust",
    "schub",
    "kräfte",
    "=fx",
    "=fy",
    "=fz",
    "=lc",
    "=last",
];
const INDUCTANCE: Words = &["induct", "indukt", "inducc", "=ls"];
const RESISTANCE: Words = &["resist", "résist", "widerst", "weerst", "=rs"];
const LENGTH: Words = &[
    "pos",
    "disp",
    "weg",
    "laser",
    "stroke",
    "lvdt",
    "^enc",
    "travel",
    "hub",
    "length",
    "defl",
    "distance",
    "motor",
    "joint",
    "länge",
    "laenge",
    "^lage",
    "verschieb",
    "auslenk",
    "abstand",
    "déplac",
    "deplac",
    "^course",
    "longueur",
    "allong",
    "elong",
    "élong",
    "desplaz",
    "recorrido",
    "carrera",
    "longitud",
    "verplaats",
    "^slag",
    "lengte",
    "afstand",
    "uitwijk",
];
/// Of the end that is driven, end 1, and of the one that is held, end 2.
const DRIVEN: Words = &[
    "driven",
    "drive",
    "moving",
    "motor",
    "actuator",
    "input",
    "antrieb",
    "angetrieben",
    "bewegt",
    "aktor",
    "aktuator",
    "eingang",
    "entrée",
    "mobile",
    "moteur",
    "entraîn",
    "entrada",
    "móvil",
    "movil",
    "ingang",
    "aandrijf",
    "aangedreven",
    "bewegend",
];
const HELD: Words = &[
    "fixed",
    "^held",
    "ground",
    "output",
    "^fest",
    "^gehalten",
    "ausgang",
    "abtrieb",
    "lastseit",
    "sortie",
    "=fixe",
    "^fijo",
    "^fija",
    "salida",
    "uitgang",
    "^vast",
    "load side",
    "load-side",
];
/// Where nothing says which end is driven: presses and testing machines drive the upper one.
const UPPER: Words =
    &["=top", "upper", "^oben", "^ober", "=haut", "supérieur", "superieur", "arriba", "superior", "^boven"];
const LOWER: Words =
    &["bottom", "lower", "^unten", "^unter", "=bas", "inférieur", "inferieur", "abajo", "inferior", "^onder"];

/// A title's words, parted where no letter or digit stands; and all of it, for words of two.
fn has(title: &str, words: Words) -> bool {
    let lower = title.to_lowercase();
    let parts = || lower.split(|c: char| !c.is_alphanumeric());
    words.iter().any(|word| match (word.strip_prefix('='), word.strip_prefix('^')) {
        (Some(word), _) => parts().any(|part| part == word),
        (_, Some(word)) => parts().any(|part| part.starts_with(word)),
        (None, None) => lower.contains(word),
    })
}

/// The column of time among those that are free: by its stamps or its unit, else by its name.
pub(super) fn time(titles: &[Title], free: &[usize]) -> Option<usize> {
    let unit = |index: &usize| titles[*index].unit.as_deref();
    let is_time =
        |index: &usize| titles[*index].stamps || unit(index).and_then(unit::dimension) == Some(Dimension::Time);
    let named = |index: &usize| unit(index).is_none_or(|unit| !unit::is_known(unit)) && has(&titles[*index].name, TIME);
    free.iter().copied().find(is_time).or_else(|| free.iter().copied().find(named))
}

/// What a column may be of, by its unit or its name.
pub(super) fn dimension(title: &Title) -> Option<Dimension> {
    if let Some(dimension) = title.unit.as_deref().and_then(unit::dimension) {
        return Some(dimension);
    }
    match () {
        () if has(&title.name, FORCE) => Some(Dimension::Force),
        () if has(&title.name, INDUCTANCE) => Some(Dimension::Inductance),
        () if has(&title.name, RESISTANCE) => Some(Dimension::Resistance),
        () if has(&title.name, LENGTH) => Some(Dimension::Length),
        () => title.unit.as_deref().filter(|unit| unit::is_signal(unit)).map(|_| Dimension::Force),
    }
}

/// Whether a title is that of an instrument's input, such as `CH1`: its number says where a cable is, not at which end.
fn is_input(name: &str) -> bool {
    let lower = name.trim_end_matches(|c: char| c.is_ascii_digit()).to_lowercase();
    let last = lower.split(|c: char| !c.is_alphanumeric()).rfind(|part| !part.is_empty()).unwrap_or("");
    matches!(
        last,
        "" | "ch"
            | "chan"
            | "channel"
            | "kanal"
            | "canal"
            | "kanaal"
            | "ai"
            | "ain"
            | "adc"
            | "analog"
            | "col"
            | "column"
    )
}

/// Which end a title speaks of, 1 or 2: by its number, by what is driven and what is held, or by what is above and below.
fn end(title: &Title) -> Option<usize> {
    let number = title.name.chars().last().filter(|last| matches!(last, '1' | '2') && !is_input(&title.name));
    let alone = title.name.chars().rev().nth(1).is_none_or(|before| !before.is_ascii_digit());
    let words = [(DRIVEN, HELD), (UPPER, LOWER)].into_iter().find_map(|(one, two)| {
        match (has(&title.name, one), has(&title.name, two)) {
            (true, false) => Some(1),
            (false, true) => Some(2),
            _ => None,
        }
    });
    number.filter(|_| alone).map(|number| if number == '1' { 1 } else { 2 }).or(words)
}

/// The channels of the columns `free`, as far as their titles say anything: each channel once, in the order of the columns.
pub(super) fn guess(titles: &[Title], free: &[usize]) -> Vec<(usize, Channel)> {
    let of = |wanted: Dimension| {
        free.iter().copied().filter(move |&index| dimension(&titles[index]) == Some(wanted)).collect::<Vec<_>>()
    };
    let mut found = Vec::new();
    // Of ends 1 and 2.
    let both = [
        (Dimension::Force, [Channel::InputForce, Channel::OutputForce]),
        (Dimension::Length, [Channel::U1, Channel::U2]),
    ];
    for (dimension, ends) in both {
        let columns = of(dimension);
        let told = |number: usize| columns.iter().copied().find(|&index| end(&titles[index]) == Some(number));
        let by_word = [told(1), told(2)];
        found.extend(by_word.iter().zip(ends).filter_map(|(column, channel)| Some(((*column)?, channel))));
        // One force alone is one at the held end, where load cells sit; one motion alone that of the driven one.
        let order = if dimension == Dimension::Force { [1, 0] } else { [0, 1] };
        let left = order.into_iter().filter(|&place| by_word[place].is_none()).map(|place| ends[place]);
        let silent = columns.iter().copied().filter(|&index| end(&titles[index]).is_none());
        found.extend(silent.zip(left));
    }
    for (one, channel) in [(Dimension::Inductance, Channel::Inductance), (Dimension::Resistance, Channel::Resistance)] {
        found.extend(of(one).first().map(|&index| (index, channel)));
    }
    found.sort_by_key(|(index, _)| *index);
    found
}

#[cfg(test)]
mod tests {
    use coilsense::Channel::{self, InputForce, OutputForce, U1, U2};

    use super::super::title::Title;
    use super::guess;

    fn guessed(titles: &[&str]) -> Vec<Option<Channel>> {
        let titles: Vec<Title> = titles.iter().map(|title| Title::parse(title)).collect();
        let found = guess(&titles, &(0..titles.len()).collect::<Vec<_>>());
        (0..titles.len()).map(|index| found.iter().find(|(column, _)| *column == index).map(|found| found.1)).collect()
    }

    #[test]
    fn words_of_five_languages_say_which_end_is_meant() {
        for (titles, channels) in [
            (["Zeit/s", "Weg oben (mm)", "Kraft unten [N]"], [None, Some(U1), Some(OutputForce)]),
            (["temps (s)", "Déplacement bas (mm)", "Force haut (N)"], [None, Some(U2), Some(InputForce)]),
            (["tiempo [s]", "Fuerza inferior [N]", "Desplazamiento [mm]"], [None, Some(OutputForce), Some(U1)]),
            (["tijd [s]", "Verplaatsing boven [mm]", "Kracht [kN]"], [None, Some(U1), Some(OutputForce)]),
            (["t", "upper load cell [N]", "lower load cell [N]"], [None, Some(InputForce), Some(OutputForce)]),
            (["t", "Kraft fest [N]", "Kraft Antrieb [N]"], [None, Some(OutputForce), Some(InputForce)]),
            (["t", "Kraft 2 [N]", "Kraft 1 [N]"], [None, Some(OutputForce), Some(InputForce)]),
            // The inputs of an instrument are no ends: of two signals the first is the load cell's at the held end.
            (["t", "CH1 [V]", "CH2 [V]"], [None, Some(OutputForce), Some(InputForce)]),
            (["t", "Kanal 2 [N]", "AI 1 [N]"], [None, Some(OutputForce), Some(InputForce)]),
            // What is driven says more than what is above.
            (["t", "oben fest [N]", "unten Antrieb [N]"], [None, Some(OutputForce), Some(InputForce)]),
            // The first of two that speak of one end; a second column of it is no other end.
            (["t", "Weg oben [mm]", "Weg oben Kontrolle [mm]"], [None, Some(U1), None]),
        ] {
            assert_eq!(guessed(&titles), channels, "{titles:?}");
        }
    }

    #[test]
    fn what_has_the_unit_of_a_length_is_never_a_force_and_the_other_way_round() {
        for word in ["Kraft", "load", "F_o", "cell", "fuerza"] {
            assert_eq!(guessed(&[&format!("{word} [mm]")]), [Some(U1)], "{word}");
        }
        for word in ["Weg", "position", "u1 of", "laser", "desplazamiento"] {
            assert_eq!(guessed(&[&format!("{word} [N]")]), [Some(OutputForce)], "{word}");
        }
        // No words of lengths, though they hold some.
        for title in ["frequency", "reference", "stop", "Temperatur [°C]"] {
            assert_eq!(guessed(&[title]), [None], "{title}");
        }
    }
}
