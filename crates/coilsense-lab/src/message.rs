//! What is said to a user: text, and hints at what he may give, which every door calls by its own name.
//!
//! Next door: the options themselves (`request`, the doors), who advises (`recording`, `calibration`, `sweep`, `sensitivity`).

use std::fmt;
use std::ops::Add;

/// Who shows a message.
#[derive(Clone, Copy)]
pub enum Door<'a> {
    /// The command: `--drop-incomplete`.
    Command,
    /// Python: `drop_incomplete=True`; the browser has none.
    #[cfg(not(target_family = "wasm"))]
    Python,
    /// The page, by what it calls an option of the command's name (`drop-incomplete`), where it has that option.
    Page(&'a dyn Fn(&str) -> Option<String>),
}

/// What a user may give, by the option's name with underscores.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Hint {
    /// An option, and what the command's help puts for its value, if anything: `--catalogue FILE`; `catalogue`.
    Option(&'static str, &'static str),
    /// An option that is to be given: `--to`; `to=`.
    Open(&'static str),
    /// A yes: `--sort`; `sort=True`.
    Flag(&'static str),
    /// An option with a value: `--resample "500 Hz"`; `resample="500 Hz"`.
    Value(&'static str, String),
    /// An option with a channel of each of two devices: `--clock F_o=F_x`; `clock=("F_o", "F_x")`.
    Pair(&'static str, [&'static str; 2]),
    /// An option with a value for a channel: `--gain F_o="12.5 N/V"`; `gain={"F_o": "12.5 N/V"}`.
    Named(&'static str, &'static str, String),
    /// Several at once, which are given together.
    All(Vec<Hint>),
    /// Which column is a channel: `--column F_o="LC [N]"`; `columns={"F_o": "LC [N]"}`.
    Column(&'static str, String),
}

impl Hint {
    fn name(&self) -> &'static str {
        match self {
            Self::Option(name, _) | Self::Open(name) | Self::Flag(name) => name,
            Self::Value(name, _) | Self::Pair(name, _) | Self::Named(name, ..) => name,
            Self::Column(..) => "column",
            Self::All(hints) => hints.first().map_or("", Self::name),
        }
    }

    fn told(&self, door: Door<'_>) -> String {
        let between = match door {
            #[cfg(not(target_family = "wasm"))]
            Door::Python => return Self::in_python(std::slice::from_ref(self)),
            Door::Command => " ",
            Door::Page(_) => "; ",
        };
        if let Self::All(hints) = self {
            return hints.iter().map(|hint| hint.told(door)).collect::<Vec<_>>().join(between);
        }
        let flag = self.name().replace('_', "-");
        let Door::Page(label) = door else { return self.with_value(format!("--{flag}")) };
        let label = label(&flag).unwrap_or_else(|| flag.replace('-', " "));
        match self {
            Self::Option(..) => label,
            Self::Column(channel, text) | Self::Named(_, channel, text) => format!("{channel}={text:?} in {label}"),
            _ => self.with_value(label),
        }
    }

    /// The option, and behind it its value as the command takes it.
    fn with_value(&self, option: String) -> String {
        match self {
            Self::Option(_, "") | Self::Open(_) | Self::Flag(_) => option,
            Self::Option(_, value) => format!("{option} {value}"),
            // As a shell takes it for one word.
            Self::Value(_, value) if value.contains(' ') => format!("{option} {}", quoted(value)),
            Self::Value(_, value) => format!("{option} {value}"),
            Self::Pair(_, [mine, theirs]) => format!("{option} {mine}={theirs}"),
            Self::Column(channel, text) | Self::Named(_, channel, text) => {
                format!("{option} {channel}={}", quoted(text))
            }
            Self::All(_) => option,
        }
    }

    /// Arguments, those of one name as one dictionary.
    #[cfg(not(target_family = "wasm"))]
    fn in_python(hints: &[Self]) -> String {
        let mut told: Vec<(&'static str, String)> = Vec::new();
        for hint in hints {
            let argument = python_name(hint.name());
            let text = match hint {
                Self::All(hints) => Self::in_python(hints),
                Self::Option(..) => argument.to_owned(),
                Self::Open(_) => format!("{argument}="),
                Self::Flag(_) => format!("{argument}=True"),
                Self::Value(_, value) => format!("{argument}={value:?}"),
                Self::Pair(_, [mine, theirs]) => format!("{argument}=({mine:?}, {theirs:?})"),
                Self::Column(channel, text) | Self::Named(_, channel, text) => {
                    let item = format!("{channel:?}: {text:?}}}");
                    match told.iter_mut().find(|(other, _)| *other == argument) {
                        Some((_, items)) => {
                            items.pop();
                            items.push_str(", ");
                            items.push_str(&item);
                            continue;
                        }
                        None => format!("{argument}={{{item}"),
                    }
                }
            };
            told.push((argument, text));
        }
        told.into_iter().map(|(_, text)| text).collect::<Vec<_>>().join(", ")
    }
}

/// A text as a shell takes it for one word, whatever stands in it.
fn quoted(text: &str) -> String {
    let is_plain = !text.contains(['"', '$', '`', '\\', '!']);
    if is_plain { format!("\"{text}\"") } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

/// The argument that Python has for an option.
pub fn python_name(option: &'static str) -> &'static str {
    match option {
        // A word of the language.
        "from" => "from_",
        "column" => "columns",
        // Python's `points` are the points themselves.
        "points" => "fit_points",
        name => name,
    }
}

/// A part of a message.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Piece {
    /// The same at every door, whatever a file's name in it looks like.
    Text(String),
    Hint(Hint),
}

/// What is said, put together by `+` of texts and hints; its plain text is the command's.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Message(Vec<Piece>);

impl Message {
    /// Without the text that it begins with.
    pub(crate) fn without(mut self, beginning: &str) -> Self {
        if let Some(Piece::Text(text)) = self.0.first_mut() {
            *text = text.strip_prefix(beginning).unwrap_or(text).to_owned();
        }
        self
    }

    /// In the words of a door.
    pub fn told(&self, door: Door<'_>) -> String {
        let piece = |piece: &Piece| match piece {
            Piece::Text(text) => text.clone(),
            Piece::Hint(hint) => hint.told(door),
        };
        self.0.iter().map(piece).collect()
    }
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.told(Door::Command))
    }
}

impl From<String> for Message {
    fn from(text: String) -> Self {
        Self(vec![Piece::Text(text)])
    }
}

impl From<&str> for Message {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

impl From<Hint> for Message {
    fn from(hint: Hint) -> Self {
        Self(vec![Piece::Hint(hint)])
    }
}

impl From<coilsense::Error> for Message {
    fn from(error: coilsense::Error) -> Self {
        error.to_string().into()
    }
}

impl<M: Into<Message>> Add<M> for Message {
    type Output = Self;

    fn add(mut self, more: M) -> Self {
        self.0.extend(more.into().0);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Labels of a page that has no second clock.
    fn label(name: &str) -> Option<String> {
        let labels = [("sort", "“put in order”"), ("to", "“and after”"), ("resample", "“Resample to”")];
        let found = labels.iter().find(|(known, _)| *known == name).map(|(_, label)| (*label).to_owned());
        found.or_else(|| (name == "column").then(|| "the table of columns".to_owned()))
    }

    #[test]
    fn every_door_calls_an_option_by_its_own_name() {
        for (hint, command, python, page) in [
            (Hint::Option("rows", ""), "--rows", "rows", "rows"),
            (Hint::Option("over", "KEY=VALUES"), "--over KEY=VALUES", "over", "over"),
            (Hint::Open("to"), "--to", "to=", "“and after”"),
            (Hint::Open("from"), "--from", "from_=", "from"),
            (Hint::Flag("sort"), "--sort", "sort=True", "“put in order”"),
            (Hint::Flag("drop_incomplete"), "--drop-incomplete", "drop_incomplete=True", "drop incomplete"),
            (
                Hint::Value("resample", "500 Hz".into()),
                "--resample \"500 Hz\"",
                "resample=\"500 Hz\"",
                "“Resample to” \"500 Hz\"",
            ),
            (
                Hint::Value("sampling", "saltelli".into()),
                "--sampling saltelli",
                "sampling=\"saltelli\"",
                "sampling saltelli",
            ),
            // What a door does not have it calls by its words, never as another door does.
            (Hint::Pair("clock", ["F_o", "F_x"]), "--clock F_o=F_x", "clock=(\"F_o\", \"F_x\")", "clock F_o=F_x"),
            (
                Hint::Column("F_o", "LC [N]".into()),
                "--column F_o=\"LC [N]\"",
                "columns={\"F_o\": \"LC [N]\"}",
                "F_o=\"LC [N]\" in the table of columns",
            ),
        ] {
            let message = Message::from("as in ") + hint;
            let told = [Door::Command, Door::Python, Door::Page(&label)].map(|door| message.told(door));
            assert_eq!(told, [command, python, page].map(|text| format!("as in {text}")));
            assert_eq!(message.to_string(), told[0]);
        }
    }

    #[test]
    fn a_text_that_looks_like_an_option_is_the_same_at_every_door() {
        for file in ["run--torque-2.csv", "--sort.csv", "a --to b.csv", "--column F_o=x.csv", "--sort"] {
            let message = Message::from(format!("{file}:3: ")) + Hint::Flag("sort") + " mends it";
            assert_eq!(message.told(Door::Python), format!("{file}:3: sort=True mends it"));
            assert_eq!(message.told(Door::Page(&label)), format!("{file}:3: “put in order” mends it"));
        }
    }
}
