//! The numbers in a text of JSON, each with its place, right to the last bit; `serde_json` rounds some otherwise.
//!
//! Next door: which columns they are (`topics`).

/// What is left of a text, and where in it the next value is.
struct Text<'a> {
    rest: &'a [u8],
    place: String,
    depth: usize,
}

/// How deep objects and lists may lie in one another.
const DEEPEST: usize = 32;

/// Hands out the numbers of a text: fields by their names with points between, places of lists from 0, truth as 1 and 0.
///
/// `None` where it is no JSON.
pub(super) fn numbers(text: &[u8], number: &mut impl FnMut(&str, f64)) -> Option<()> {
    let mut text = Text { rest: text, place: String::new(), depth: 0 };
    text.value(number)?;
    text.blank();
    text.rest.is_empty().then_some(())
}

impl Text<'_> {
    fn value(&mut self, number: &mut impl FnMut(&str, f64)) -> Option<()> {
        self.blank();
        match self.rest.first()? {
            b'{' | b'[' => self.inner(number),
            b'"' => self.string().map(|_| ()),
            b't' => self.word("true").map(|()| number(&self.place, 1.0)),
            b'f' => self.word("false").map(|()| number(&self.place, 0.0)),
            b'n' => self.word("null"),
            // Not of JSON, but what Python writes.
            b'N' => self.word("NaN").map(|()| number(&self.place, f64::NAN)),
            _ => {
                let is_part = |byte: &u8| matches!(byte, b'0'..=b'9' | b'+' | b'-' | b'.' | b'e' | b'E');
                let length = self.rest.iter().take_while(|byte| is_part(byte)).count();
                let (own, rest) = self.rest.split_at(length);
                let value: f64 = std::str::from_utf8(own).ok()?.parse().ok()?;
                self.rest = rest;
                number(&self.place, value);
                Some(())
            }
        }
    }

    /// The values of an object or a list.
    fn inner(&mut self, number: &mut impl FnMut(&str, f64)) -> Option<()> {
        let (is_object, outer) = (self.rest[0] == b'{', self.place.len());
        let end = if is_object { b'}' } else { b']' };
        self.depth += 1;
        if self.depth > DEEPEST {
            return None;
        }
        self.rest = &self.rest[1..];
        self.blank();
        let mut count = 0_usize;
        while *self.rest.first()? != end {
            if count > 0 {
                self.word(",")?;
                self.blank();
            }
            let name = if is_object { self.string()? } else { count.to_string() };
            if is_object {
                self.blank();
                self.word(":")?;
            }
            if outer > 0 {
                self.place.push('.');
            }
            self.place.push_str(&name);
            self.value(number)?;
            self.place.truncate(outer);
            self.blank();
            count += 1;
        }
        self.rest = &self.rest[1..];
        self.depth -= 1;
        Some(())
    }

    /// A string; what stands behind strokes as it is.
    fn string(&mut self) -> Option<String> {
        let inner = self.rest.strip_prefix(b"\"")?;
        let mut end = 0;
        while *inner.get(end)? != b'"' {
            end += if inner[end] == b'\\' { 2 } else { 1 };
        }
        self.rest = inner.get(end + 1..)?;
        Some(String::from_utf8_lossy(&inner[..end]).into_owned())
    }

    fn word(&mut self, word: &str) -> Option<()> {
        self.rest = self.rest.strip_prefix(word.as_bytes())?;
        Some(())
    }

    fn blank(&mut self) {
        self.rest = self.rest.trim_ascii_start();
    }
}

#[cfg(test)]
mod tests {
    use super::numbers;

    fn all(text: &str) -> Option<Vec<(String, f64)>> {
        let mut all = Vec::new();
        numbers(text.as_bytes(), &mut |place, value| all.push((place.to_owned(), value)))?;
        Some(all)
    }

    #[test]
    fn numbers_have_the_names_of_their_fields() {
        let found =
            all(r#" {"F_o": -0.1, "raw": {"x": 1e300, "v": [1, 2.5]}, "who": "a\"}", "ok": true, "no": null} "#)
                .unwrap();
        let names: Vec<&str> = found.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["F_o", "raw.x", "raw.v.0", "raw.v.1", "ok"]);
        assert_eq!(found.iter().map(|(_, value)| *value).collect::<Vec<f64>>(), [-0.1, 1e300, 1.0, 2.5, 1.0]);
        for wrong in ["", "{", "[1,", "{\"a\" 1}", "1 2", "{\"a\":}", "\"\\", "--1", &"[".repeat(1000)] {
            assert_eq!(all(wrong), None, "{wrong}");
        }
    }
}
