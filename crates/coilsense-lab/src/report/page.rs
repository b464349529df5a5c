//! A page from its layout and what stands in it: text is escaped, numbers are set as they are printed.
//!
//! Next door: the layouts (`*/page.html`), sentences (`prose`).

use std::fmt::Write as _;

use coilsense_figure::{Figure, Theme};
use minijinja::{AutoEscape, Environment, Error, Value, context, escape_formatter};

use super::{Drawn, ReportError};

/// A page's layout with its values; `version` and `style` are the same for all. Numbers in values have true minus signs and powers of ten;
/// `|verbatim` leaves text as it was written.
pub(super) fn page(layout: &str, values: Value) -> Result<String, Error> {
    let mut environment = Environment::new();
    environment.set_auto_escape_callback(|_| AutoEscape::Html);
    environment.add_global("version", env!("CARGO_PKG_VERSION"));
    environment.add_global("style", include_str!("style.css"));
    environment.add_filter("verbatim", |text: &str| Value::from_object(Verbatim(text.to_owned())));
    environment.set_formatter(|out, state, value| {
        let text = match value.as_str() {
            Some(text) if !value.is_safe() => Some(text.to_owned()),
            _ => value.is_number().then(|| value.to_string()),
        };
        match text {
            Some(text) => escape_formatter(out, state, &Value::from(typeset(&text))),
            None => escape_formatter(out, state, value),
        }
    });
    environment.add_template("page", layout)?;
    environment.get_template("page")?.render(values)
}

/// A figure that also lies beside the page, as layouts have it.
pub(super) fn shown(figure: &Drawn) -> Value {
    context! { name => &figure.name, caption => &figure.caption, light => &figure.light, dark => &figure.dark }
}

/// A figure that is on the page only.
pub(super) fn drawn(name: &str, figure: &Figure) -> Result<Value, ReportError> {
    let refuse = |source| ReportError::Figure { name: name.to_owned(), source };
    let (light, dark) = (figure.to_svg(Theme::Light).map_err(refuse)?, figure.to_svg(Theme::Dark).map_err(refuse)?);
    Ok(context! { light, dark })
}

/// Text that no typesetter touches: a spec that a reader copies.
#[derive(Debug)]
struct Verbatim(String);

impl minijinja::value::Object for Verbatim {
    fn repr(self: &std::sync::Arc<Self>) -> minijinja::value::ObjectRepr {
        minijinja::value::ObjectRepr::Plain
    }

    fn render(self: &std::sync::Arc<Self>, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        out.write_str(&self.0)
    }
}

/// Text whose numbers have true minus signs (`-3` is `−3`, `-0.00` is `0.00`) and powers of ten (`2.1e-5` is `2.1 × 10⁻⁵`); ranges, dates and
/// names stay as they are.
pub(super) fn typeset(text: &str) -> String {
    let mut set = String::with_capacity(text.len() + 8);
    let mut rest = text;
    let mut before = ' ';
    while let Some(letter) = rest.chars().next() {
        let begins = before.is_whitespace() || "([/…±−".contains(before);
        match Number::at_start_of(rest).filter(|_| begins) {
            Some(number) => {
                number.set_in(&mut set);
                rest = &rest[number.length..];
                before = '0';
            }
            None => {
                set.push(letter);
                rest = &rest[letter.len_utf8()..];
                before = letter;
            }
        }
    }
    set
}

/// A number as a program writes it, and how long it is \[bytes\].
struct Number<'a> {
    negative: bool,
    mantissa: &'a str,
    exponent: Option<i32>,
    length: usize,
}

impl<'a> Number<'a> {
    fn at_start_of(text: &'a str) -> Option<Self> {
        let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
        let sign = text.chars().next().filter(|sign| matches!(sign, '-' | '\u{2212}')).map_or(0, char::len_utf8);
        let unsigned = &text[sign..];
        let mut whole = digits(unsigned);
        if whole == 0 {
            return None;
        }
        if let Some(fraction) = unsigned[whole..].strip_prefix('.').map(digits).filter(|count| *count > 0) {
            whole += 1 + fraction;
        }
        let (mantissa, behind) = unsigned.split_at(whole);
        let power = behind.strip_prefix('e').and_then(|power| {
            let minus = usize::from(power.starts_with('-'));
            let length = minus + digits(&power[minus..]);
            Some((power[..length].parse::<i32>().ok()?, 1 + length))
        });
        let (exponent, more) = power.map_or((None, 0), |(exponent, length)| (Some(exponent), length));
        // `2e-5m`, `10.1109/TMECH` and a date are names, not numbers.
        let ends = |letter: char| !letter.is_alphanumeric() && !matches!(letter, '-' | '_');
        let is_whole = behind[more..].chars().next().is_none_or(ends);
        let length = sign + whole + more;
        is_whole.then_some(Self { negative: sign > 0, mantissa, exponent, length })
    }

    fn set_in(&self, set: &mut String) {
        let is_zero = self.mantissa.bytes().all(|byte| matches!(byte, b'0' | b'.'));
        if self.negative && !is_zero {
            set.push('\u{2212}');
        }
        match self.exponent.filter(|_| !is_zero) {
            Some(exponent) => {
                if self.mantissa != "1" {
                    let _ = write!(set, "{}\u{a0}×\u{a0}", self.mantissa);
                }
                set.push_str("10");
                set.extend(exponent.to_string().chars().map(raised));
            }
            None => set.push_str(self.mantissa),
        }
    }
}

fn raised(letter: char) -> char {
    match letter {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32(u32::from('⁰') + u32::from(digit) - u32::from('0')).unwrap_or(digit),
    }
}

#[cfg(test)]
mod tests {
    use minijinja::context;

    use super::{page, typeset};

    #[test]
    fn numbers_have_true_signs_and_powers_and_no_zero_is_negative() {
        let cases = [
            ("k +10 %, m -10 %", "k +10 %, m \u{2212}10 %"),
            ("-0.000", "0.000"),
            ("\u{2212}0.00", "0.00"),
            ("-0", "0"),
            ("-0.001", "\u{2212}0.001"),
            ("bias -7.03e-5 N", "bias \u{2212}7.03\u{a0}×\u{a0}10⁻⁵ N"),
            ("1e-12", "10⁻¹²"),
            ("0e0", "0"),
            ("2.5e10 (-3e-1)", "2.5\u{a0}×\u{a0}10¹⁰ (\u{2212}3\u{a0}×\u{a0}10⁻¹)"),
            ("-1 … -3", "\u{2212}1 … \u{2212}3"),
        ];
        for (plain, set) in cases {
            assert_eq!(typeset(plain), set, "{plain}");
        }
    }

    #[test]
    fn names_dates_ranges_and_codes_stay_as_they_are() {
        for text in [
            "2026-11-28",
            "run-1.csv",
            "run1e5.csv",
            "1e5m",
            "0.75-1 s",
            "--over -x",
            "F_o - F_x",
            "10.1109/x",
            "EN 10270-1",
            "3-4-5-6",
        ] {
            assert_eq!(typeset(text), text);
        }
    }

    #[test]
    fn a_page_escapes_sets_and_leaves_what_is_verbatim() {
        let layout = "<p>{{ text }} {{ number }} {{ text|verbatim }} {{ mark|safe }}</p>";
        let shown = page(layout, context! { text => "<-3>, -3", number => -2.5, mark => "<b>-1</b>" }).unwrap();
        assert_eq!(shown, "<p>&lt;-3&gt;, \u{2212}3 \u{2212}2.5 &lt;-3&gt;, -3 <b>-1</b></p>");
    }
}
