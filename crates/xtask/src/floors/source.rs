//! From Rust text to what it names: modules that it declares, and paths that begin at the crate's root or at a parent.
//!
//! Comments and strings are gone once the text is read as tokens; items that are for tests only are left out here. Next door: the files
//! of a crate and the arrows between its modules (`graph`).

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// A module that a file declares.
#[derive(Debug, Clone, PartialEq)]
pub struct Module {
    /// Its name.
    pub name: String,
    /// Lines of documentation right before it.
    pub documentation: usize,
    /// Whether its text is in a file of its own.
    pub in_own_file: bool,
}

/// A name under the crate's root that a file mentions.
#[derive(Debug, Clone, PartialEq)]
pub struct Mention {
    /// The path from the crate's root, at least one name.
    pub path: Vec<String>,
    /// Line, from 1.
    pub line: usize,
}

/// What a file says.
#[derive(Debug, Default)]
pub struct Source {
    /// Its modules.
    pub modules: Vec<Module>,
    /// What it mentions.
    pub mentions: Vec<Mention>,
    /// What it has under a name of its own by `use`: the name, and the path from the root that it stands for.
    pub exports: Vec<(String, Vec<String>)>,
}

impl Source {
    /// Reads the text of the module of this path.
    pub fn read(text: &str, path: &[String]) -> Result<Self, String> {
        let tokens: TokenStream = text.parse().map_err(|error| format!("{error}"))?;
        let mut source = Self::default();
        source.take(&tokens.into_iter().collect::<Vec<_>>(), path);
        Ok(source)
    }

    /// Takes the tokens of a module or of any block in it.
    fn take(&mut self, tokens: &[TokenTree], path: &[String]) {
        let mut documentation = 0;
        let mut place = 0;
        while place < tokens.len() {
            if let Some(attribute) = attribute(&tokens[place..]) {
                if is_for_tests(&attribute) {
                    place += 2 + length_of_item(&tokens[place + 2..]);
                    documentation = 0;
                    continue;
                }
                documentation += usize::from(is_word(attribute.first(), "doc"));
                self.take(&attribute, path);
                place += 2;
                continue;
            }
            place += self.take_one(&tokens[place..], path, documentation);
            // The visibility and its brackets stand between a module and its documentation.
            let before = &tokens[..place];
            let visible = is_word(before.last(), "pub")
                || (before.len() > 1 && is_word(before.get(before.len() - 2), "pub") && group(before.last()).is_some());
            documentation = if visible { documentation } else { 0 };
        }
    }

    /// Takes a declaration, a path or a token; how many tokens that were.
    fn take_one(&mut self, tokens: &[TokenTree], path: &[String], documentation: usize) -> usize {
        if is_word(tokens.first(), "mod")
            && let Some(name) = word(tokens.get(1))
        {
            let body = group(tokens.get(2));
            self.modules.push(Module { name: name.clone(), documentation, in_own_file: body.is_none() });
            if let Some(body) = body {
                self.take(&body, &[path, &[name]].concat());
            }
            return 3;
        }
        if is_word(tokens.first(), "use") && (path.is_empty() || !begins_at_root(&tokens[1..])) {
            // Without a semicolon it is what a type captures.
            let Some(end) = tokens.iter().position(|token| is_point(Some(token), ';')) else { return 1 };
            let mut leaves = Vec::new();
            walk(&tokens[1..end], path, &mut leaves);
            let named = leaves.into_iter().filter_map(|leaf| Some((leaf.path.last()?.clone(), leaf.path)));
            self.exports.extend(named);
            return end + 1;
        }
        if begins_at_root(tokens) {
            let end = length_of_path(tokens);
            walk(&tokens[..end], path, &mut self.mentions);
            return end;
        }
        if let Some(inner) = tokens.first().and_then(|token| group(Some(token))) {
            self.take(&inner, path);
        }
        1
    }
}

/// Follows a path, or a tree of them in braces, from where it starts to its ends.
fn walk(tokens: &[TokenTree], at: &[String], leaves: &mut Vec<Mention>) {
    let mut at = at.to_vec();
    let mut line = 0;
    for token in tokens {
        match token {
            TokenTree::Ident(name) if name == "as" => break,
            TokenTree::Ident(name) => {
                line = name.span().start().line;
                match name.to_string().as_str() {
                    "crate" => at.clear(),
                    "super" => drop(at.pop()),
                    "self" => {}
                    other => at.push(other.to_owned()),
                }
            }
            TokenTree::Group(braces) if braces.delimiter() == Delimiter::Brace => {
                let inner: Vec<TokenTree> = braces.stream().into_iter().collect();
                let branches = inner.split(|token| is_point(Some(token), ','));
                branches.filter(|branch| !branch.is_empty()).for_each(|branch| walk(branch, &at, leaves));
                return;
            }
            _ => {}
        }
    }
    if !at.is_empty() {
        leaves.push(Mention { path: at, line });
    }
}

/// Whether a path begins here that leaves the module: at the crate's root or at a parent.
fn begins_at_root(tokens: &[TokenTree]) -> bool {
    (is_word(tokens.first(), "crate") || is_word(tokens.first(), "super")) && has_colons(tokens, 1)
}

/// Tokens of the path that begins here, with the braces at its end.
fn length_of_path(tokens: &[TokenTree]) -> usize {
    let mut end = 1;
    while has_colons(tokens, end) && (word(tokens.get(end + 2)).is_some() || group(tokens.get(end + 2)).is_some()) {
        end += 3;
    }
    end
}

/// Whether `::` stands at a place.
fn has_colons(tokens: &[TokenTree], place: usize) -> bool {
    is_point(tokens.get(place), ':') && is_point(tokens.get(place + 1), ':')
}

/// The tokens of an attribute, where one begins here: `#[…]`.
fn attribute(tokens: &[TokenTree]) -> Option<Vec<TokenTree>> {
    let brackets = is_point(tokens.first(), '#').then(|| tokens.get(1)).flatten();
    group(brackets)
}

/// Whether an attribute leaves an item to tests: `cfg(test)`, with or without other conditions.
fn is_for_tests(attribute: &[TokenTree]) -> bool {
    let Some(conditions) = is_word(attribute.first(), "cfg").then(|| group(attribute.get(1))).flatten() else {
        return false;
    };
    let mut words = Vec::new();
    collect_words(&conditions, &mut words);
    words.iter().any(|word| word == "test") && words.iter().all(|word| word != "not" && word != "any")
}

fn collect_words(tokens: &[TokenTree], words: &mut Vec<String>) {
    for token in tokens {
        words.extend(word(Some(token)));
        collect_words(&group(Some(token)).unwrap_or_default(), words);
    }
}

/// Items that end with their braces.
const BRACED: [&str; 7] = ["fn", "mod", "impl", "struct", "enum", "trait", "macro_rules"];

/// Tokens to the end of an item: a semicolon, or the braces of what needs none.
fn length_of_item(tokens: &[TokenTree]) -> usize {
    let ends_in_braces = tokens.iter().take(6).any(|token| BRACED.iter().any(|own| is_word(Some(token), own)));
    let is_end = |token: &TokenTree| {
        let braces = matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
        is_point(Some(token), ';') || (ends_in_braces && braces)
    };
    tokens.iter().position(is_end).map_or(tokens.len(), |end| end + 1)
}

fn word(token: Option<&TokenTree>) -> Option<String> {
    match token {
        Some(TokenTree::Ident(name)) => Some(name.to_string()),
        _ => None,
    }
}

fn is_word(token: Option<&TokenTree>, own: &str) -> bool {
    matches!(token, Some(TokenTree::Ident(name)) if name == own)
}

fn is_point(token: Option<&TokenTree>, own: char) -> bool {
    matches!(token, Some(TokenTree::Punct(point)) if point.as_char() == own)
}

fn group(token: Option<&TokenTree>) -> Option<Vec<TokenTree>> {
    match token {
        Some(TokenTree::Group(group)) => Some(group.stream().into_iter().collect()),
        _ => None,
    }
}
