//! JSON for the page, with numbers written by the standard library: `serde_json`'s own way of writing them brings ten kilobytes of tables.
//!
//! Next door: what is written (`answer`, `facts`).

use std::io;

use serde::Serialize;
use serde_json::Value;
use serde_json::ser::{Formatter, Serializer};

/// Numbers as the shortest text that reads back as the same double.
struct Shortest;

impl Formatter for Shortest {
    fn write_f64<W: io::Write + ?Sized>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        write!(writer, "{value:e}")
    }
}

/// A value as JSON.
pub(crate) fn text(value: &Value) -> String {
    let mut bytes = Vec::new();
    // Neither writing to memory nor a value's own keys can fail.
    let _ = value.serialize(&mut Serializer::with_formatter(&mut bytes, Shortest));
    String::from_utf8(bytes).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    /// The bits are what counts: each text reads back as the double that it was made from.
    #[test]
    fn numbers_come_back_as_they_were() {
        let numbers = [0.0, -0.0, 1.0, 54.1, 0.1 + 0.2, 1e-9, -7.6e2, 1e300, 5e-324, f64::MAX, 1.0 / 3.0];
        let value = json!({ "numbers": numbers, "none": f64::NAN, "count": 12, "text": "a\n\"b\"" });
        let back: Value = serde_json::from_str(&super::text(&value)).unwrap();
        for (index, number) in numbers.iter().enumerate() {
            assert_eq!(back["numbers"][index].as_f64().unwrap().to_bits(), number.to_bits());
        }
        assert_eq!(back["none"], Value::Null);
        assert_eq!((&back["count"], &back["text"]), (&json!(12), &json!("a\n\"b\"")));
    }
}
