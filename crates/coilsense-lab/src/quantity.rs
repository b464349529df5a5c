//! Numbers with units as people write them, `"104 mm"`, and their SI values: the one place where units are converted.
//!
//! Next door: the files that hold such strings (`spec`).

/// A physical dimension and the units in which people may write it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// Metres.
    Length,
    /// Kilograms.
    Mass,
    /// Newtons per metre.
    Stiffness,
    /// Newtons.
    Force,
}

/// A unit: its symbol and the power of ten that takes it to SI.
type Unit = (&'static str, i32);

impl Dimension {
    /// The dimension in words, with its article.
    pub fn name(self) -> &'static str {
        match self {
            Self::Length => "a length",
            Self::Mass => "a mass",
            Self::Stiffness => "a stiffness",
            Self::Force => "a force",
        }
    }

    /// The units it may be written in, the SI unit first.
    fn units(self) -> &'static [Unit] {
        match self {
            Self::Length => &[("m", 0), ("cm", -2), ("mm", -3), ("um", -6), ("µm", -6)],
            Self::Mass => &[("kg", 0), ("g", -3), ("mg", -6)],
            Self::Stiffness => &[("N/m", 0), ("kN/m", 3), ("N/mm", 3)],
            Self::Force => &[("N", 0), ("kN", 3), ("mN", -3)],
        }
    }

    /// What a value of this dimension looks like, for error texts: `a length with its unit (m, cm, mm, um, µm)`.
    pub fn expectation(self) -> String {
        let symbols: Vec<&str> = self.units().iter().map(|(symbol, _)| *symbol).collect();
        format!("{} with its unit ({})", self.name(), symbols.join(", "))
    }

    /// The SI value of `text`, such as `"104 mm"`; `None` where it is not a number followed by a unit of this dimension.
    ///
    /// The number is read together with the unit's power of ten, so `"104 mm"` is the double nearest to 0.104.
    ///
    /// ```
    /// use coilsense_lab::quantity::Dimension;
    /// assert_eq!(Dimension::Length.parse("104 mm"), Some(0.104));
    /// assert_eq!(Dimension::Length.parse("104 g"), None);
    /// ```
    pub fn parse(self, text: &str) -> Option<f64> {
        let text = text.trim();
        let (number, exponent) = self
            .units()
            .iter()
            .filter_map(|(symbol, exponent)| Some((text.strip_suffix(symbol)?.trim_end(), *exponent)))
            .find(|(number, _)| number.parse::<f64>().is_ok())?;
        scaled(number, exponent)
    }
}

/// The decimal number `text` times ten to the `exponent`, correctly rounded.
fn scaled(text: &str, exponent: i32) -> Option<f64> {
    let value: f64 = text.parse().ok()?;
    if !value.is_finite() {
        return Some(value);
    }
    let (mantissa, own) = match text.split_once(['e', 'E']) {
        Some((mantissa, own)) => (mantissa, own.parse::<i32>().ok()?),
        None => (text, 0),
    };
    format!("{mantissa}e{}", own.saturating_add(exponent)).parse().ok()
}

#[cfg(test)]
mod tests {
    use super::Dimension;

    #[test]
    fn units_scale_to_the_nearest_double() {
        assert_eq!(Dimension::Length.parse("1.6 mm"), Some(0.0016));
        assert_eq!(Dimension::Length.parse("1.6e3um"), Some(0.0016));
        assert_eq!(Dimension::Mass.parse(" 65 g "), Some(0.065));
        assert_eq!(Dimension::Stiffness.parse("9.1 N/mm"), Some(9100.0));
        assert_eq!(Dimension::Stiffness.parse("0.76kN/m"), Some(760.0));
        assert_eq!(Dimension::Force.parse("-121.6 N"), Some(-121.6));
    }

    #[test]
    fn a_number_without_its_unit_or_with_another_is_not_a_quantity() {
        for text in ["104", "104 kg", "mm", "", "1,6 mm", "104 mm mm", "m", "1e mm"] {
            assert_eq!(Dimension::Length.parse(text), None, "{text}");
        }
    }
}
