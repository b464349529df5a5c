//! What keys and words of a spec were called before: read for one release more, with a note that says the new name.
//!
//! Next door: the file as TOML (`document`), the keys of today (`keys`).

use std::borrow::Cow;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Keys: table, then before, then now.
const KEYS: [(&str, &str, &str); 4] = [
    ("rig", "taps", "hits"),
    ("rig", "taps_per_run", "hits_per_run"),
    ("rig", "tap_height", "hit_height"),
    ("rig", "tap_duration", "hit_duration"),
];

/// Words that stand for values: table, key, then before, then now.
const WORDS: [(&str, &str, &str, &str); 1] = [("run", "kind", "tap", "hit")];

/// Gives what is called as before its name of today; a note for each name. A key that is there under both names stays, and is unknown.
pub(super) fn renamed(root: &mut DeTable<'_>) -> Vec<String> {
    let mut notes = Vec::new();
    for (table, before, now) in KEYS {
        let mut found = false;
        each(root, table, |inner| {
            if inner.contains_key(now) {
                return;
            }
            if let Some((key, value)) = inner.remove_entry(before) {
                inner.insert(Spanned::new(key.span(), now.into()), value);
                found = true;
            }
        });
        if found {
            notes.push(format!("[{table}] {before} is called {now} now; the next release no longer reads {before}"));
        }
    }
    for (table, key, before, now) in WORDS {
        let mut found = false;
        each(root, table, |inner| {
            let Some(value) = inner.get_mut(key) else { return };
            if matches!(value.get_ref(), DeValue::String(word) if word == before) {
                *value = Spanned::new(value.span(), DeValue::String(Cow::Borrowed(now)));
                found = true;
            }
        });
        if found {
            notes.push(format!(
                "{key} = \"{before}\" is called \"{now}\" now; the next release no longer reads \"{before}\""
            ));
        }
    }
    notes
}

/// The table of that name, or each of several.
fn each<'a>(root: &mut DeTable<'a>, name: &str, mut change: impl FnMut(&mut DeTable<'a>)) {
    match root.get_mut(name).map(Spanned::get_mut) {
        Some(DeValue::Table(inner)) => change(inner),
        Some(DeValue::Array(several)) => {
            for one in several.iter_mut() {
                if let DeValue::Table(inner) = one.get_mut() {
                    change(inner);
                }
            }
        }
        _ => {}
    }
}
