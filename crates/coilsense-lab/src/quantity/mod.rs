//! Numbers with units as people write them, `"104 mm"`, and their SI values: the one place where units are converted; and numbers as people read
//! them.
//!
//! Next door: the units themselves (`units`), the numbers of a column in the units in which people think of them (`shown`), the files that hold such strings (`spec`).

#[cfg(feature = "parquet")]
mod shown;
mod units;

#[cfg(feature = "parquet")]
pub(crate) use shown::{Shown, unit_of, without_unit};
use units::Factor::{Over, Ten, Times};

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
    /// Seconds.
    Time,
    /// Hertz.
    Frequency,
    /// A multiple of the spring's surge frequency f1.
    SurgeMultiple,
    /// Metres per second.
    Velocity,
    /// Radians.
    Angle,
    /// Henry.
    Inductance,
    /// A difference of temperatures: kelvins.
    Temperature,
    /// A share of something: 1 is all of it.
    Share,
    /// Pascals.
    Modulus,
    /// Kilograms per cubic metre.
    Density,
    /// Ohms.
    Resistance,
    /// Ohm metres.
    Resistivity,
    /// Metres per newton.
    Compliance,
    /// Per kelvin.
    PerKelvin,
    /// Per second.
    Rate,
    /// Force over velocity.
    Friction,
}

impl Dimension {
    /// All dimensions; no two share a unit.
    pub const ALL: [Self; 20] = [
        Self::Length,
        Self::Mass,
        Self::Stiffness,
        Self::Force,
        Self::Time,
        Self::Frequency,
        Self::SurgeMultiple,
        Self::Velocity,
        Self::Angle,
        Self::Inductance,
        Self::Temperature,
        Self::Share,
        Self::Modulus,
        Self::Density,
        Self::Resistance,
        Self::Resistivity,
        Self::Compliance,
        Self::PerKelvin,
        Self::Rate,
        Self::Friction,
    ];

    /// The dimension in words, with its article.
    pub fn name(self) -> &'static str {
        match self {
            Self::Length => "a length",
            Self::Mass => "a mass",
            Self::Stiffness => "a stiffness",
            Self::Force => "a force",
            Self::Time => "a time",
            Self::Frequency => "a frequency",
            Self::SurgeMultiple => "a multiple of the surge frequency",
            Self::Velocity => "a velocity",
            Self::Angle => "an angle",
            Self::Inductance => "an inductance",
            Self::Temperature => "a temperature difference",
            Self::Share => "a share",
            Self::Modulus => "a modulus",
            Self::Density => "a density",
            Self::Resistance => "a resistance",
            Self::Resistivity => "a resistivity",
            Self::Compliance => "a compliance",
            Self::PerKelvin => "a temperature coefficient",
            Self::Rate => "a rate",
            Self::Friction => "a viscous friction",
        }
    }

    /// What stands for it in a line of help.
    pub fn placeholder(self) -> &'static str {
        match self {
            Self::Length => "LENGTH",
            Self::Mass => "MASS",
            Self::Stiffness => "STIFFNESS",
            Self::Force => "FORCE",
            Self::Time => "TIME",
            Self::Frequency | Self::SurgeMultiple => "FREQUENCY",
            Self::Velocity => "VELOCITY",
            Self::Angle => "ANGLE",
            Self::Share => "SHARE",
            Self::Inductance => "INDUCTANCE",
            Self::Temperature => "TEMPERATURE",
            _ => "QUANTITY",
        }
    }

    /// The symbol of its SI unit; a share's is that of all.
    pub fn si_unit(self) -> &'static str {
        match self {
            Self::Share => "",
            _ => self.units().first().map_or("", |(symbol, _)| symbol),
        }
    }

    /// What a value of this dimension looks like, for error texts: `a length with its unit (m, cm, mm, um, µm, nm)`.
    pub fn expectation(self) -> String {
        format!("{} with its unit ({})", self.name(), self.symbols())
    }

    /// Why `text` is none of this dimension: what is allowed, and how to write what was probably meant.
    ///
    /// ```
    /// use coilsense_lab::quantity::Dimension;
    /// assert!(Dimension::Length.refusal("4,5 mm").ends_with("; write 4.5 mm with a point"));
    /// assert!(Dimension::Length.refusal("4,5\n mm\n").ends_with("; write 4.5 mm with a point"));
    /// ```
    pub fn refusal(self, text: &str) -> String {
        format!("must be {}{}", self.expectation(), pointed(text, |text| self.parse(text).is_some()))
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
        let (number, factor) = self
            .units()
            .iter()
            .filter_map(|(symbol, factor)| Some((text.strip_suffix(symbol)?.trim_end(), *factor)))
            .find(|(number, _)| number.parse::<f64>().is_ok())?;
        match factor {
            Ten(exponent) => scaled(number, exponent),
            Times(factor) => Some(number.parse::<f64>().ok()? * factor),
            Over(divisor) => Some(number.parse::<f64>().ok()? / divisor),
        }
    }

    /// What takes numbers of a unit to SI; `None` where the unit is not of this dimension.
    pub(crate) fn scale(self, unit: &str) -> Option<Scale> {
        let (_, factor) = self.units().iter().find(|(symbol, _)| *symbol == unit)?;
        Some(match *factor {
            Ten(exponent) if exponent < 0 => Scale::Over(10f64.powi(-exponent)),
            Ten(exponent) => Scale::Times(10f64.powi(exponent)),
            Times(factor) => Scale::Times(factor),
            Over(divisor) => Scale::Over(divisor),
        })
    }

    /// Its units, for error texts.
    pub(crate) fn symbols(self) -> String {
        let symbols: Vec<&str> = self.units().iter().map(|(symbol, _)| *symbol).collect();
        symbols.join(", ")
    }
}

/// What takes many numbers of a unit to SI. A number of millimetres is divided by 1000, which is right to the last bit more often than
/// a product with 0.001.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Scale {
    /// Multiply.
    Times(f64),
    /// Divide.
    Over(f64),
}

impl Scale {
    /// The SI value of a number.
    pub fn apply(self, value: f64) -> f64 {
        match self {
            Self::Times(factor) => value * factor,
            Self::Over(divisor) => value / divisor,
        }
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

/// `text` with a decimal point where it has one decimal comma and no point; `None` for any other.
///
/// ```
/// use coilsense_lab::quantity::with_point;
/// assert_eq!(with_point("4,5 mm").as_deref(), Some("4.5 mm"));
/// assert_eq!(with_point("1,234.5 mm"), None);
/// ```
pub fn with_point(text: &str) -> Option<String> {
    let (whole, behind) = text.split_once(',')?;
    let is_decimal = whole.ends_with(|c: char| c.is_ascii_digit()) && behind.starts_with(|c: char| c.is_ascii_digit());
    (is_decimal && !behind.contains(',') && !text.contains('.')).then(|| format!("{whole}.{behind}"))
}

/// What to write in place of a decimal comma, where that is all that keeps `text` from being taken; else nothing.
pub(crate) fn pointed(text: &str, is_taken: impl Fn(&str) -> bool) -> String {
    let point = with_point(text).filter(|text| is_taken(text));
    // On one line, whatever space the text has.
    let plain = |text: String| text.split_whitespace().collect::<Vec<_>>().join(" ");
    point.map_or_else(String::new, |text| format!("; write {} with a point", plain(text)))
}

/// Below this a number is written with a power of ten: its zeros would be counted, not read.
const SMALLEST_PLAIN: f64 = 1e-4;

/// Three significant digits, as people write them.
pub(crate) fn digits(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    if value.abs() < SMALLEST_PLAIN {
        return format!("{value:.2e}");
    }
    let decimals = (2 - value.abs().log10().floor() as i32).max(0) as usize;
    format!("{value:.decimals$}")
}

/// The same without zeros behind: for what a person has set.
pub fn plainly(value: f64) -> String {
    let text = digits(value);
    let (mantissa, exponent) = text.find('e').map_or((text.as_str(), ""), |place| text.split_at(place));
    match mantissa.contains('.') {
        true => format!("{}{exponent}", mantissa.trim_end_matches('0').trim_end_matches('.')),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::{Dimension, digits, plainly};

    #[test]
    fn customary_units_are_what_treaties_make_them() {
        // Inch and pound by the agreement of 1959, gravity by that of 1901; a product of two doubles is off by 2e-16 of it.
        let near = |dimension: Dimension, text: &str, expected: f64| {
            let found = dimension.parse(text).unwrap_or_else(|| panic!("{text}"));
            assert!((found / expected - 1.0).abs() < 3e-16, "{text}: {found}");
        };
        near(Dimension::Length, "1.5 in", 0.0381);
        near(Dimension::Length, "1.5\"", 0.0381);
        near(Dimension::Length, "1.5 inch", 0.0381);
        near(Dimension::Length, "2 ft", 0.6096);
        near(Dimension::Length, "63 mil", 1.6002e-3);
        near(Dimension::Mass, "2 lb", 0.907_184_74);
        near(Dimension::Mass, "16 oz", 0.453_592_37);
        near(Dimension::Force, "1 lbf", 4.448_221_615_260_5);
        near(Dimension::Force, "1 kgf", 9.806_65);
        near(Dimension::Force, "500 gf", 4.903_325);
        near(Dimension::Stiffness, "1 lbf/in", 175.126_835_246_476_4);
        near(Dimension::Stiffness, "0.1 kgf/mm", 980.665);
        near(Dimension::Velocity, "36 km/h", 10.0);
        assert_eq!(Dimension::Time.parse("1 ns"), Some(1e-9));
    }

    #[test]
    fn what_is_tiny_is_written_with_a_power_of_ten() {
        assert_eq!((digits(2.12e-6).as_str(), digits(-2.1249e-11).as_str()), ("2.12e-6", "-2.12e-11"));
        assert_eq!((digits(0.000_123_4).as_str(), digits(0.0).as_str()), ("0.000123", "0"));
        assert_eq!(
            (plainly(1e-10).as_str(), plainly(2.5e-7).as_str(), plainly(100.0).as_str()),
            ("1e-10", "2.5e-7", "100")
        );
    }

    #[test]
    fn units_scale_to_the_nearest_double() {
        assert_eq!(Dimension::Length.parse("1.6 mm"), Some(0.0016));
        assert_eq!(Dimension::Length.parse("1.6e3um"), Some(0.0016));
        assert_eq!(Dimension::Mass.parse(" 65 g "), Some(0.065));
        assert_eq!(Dimension::Stiffness.parse("9.1 N/mm"), Some(9100.0));
        assert_eq!(Dimension::Stiffness.parse("0.76kN/m"), Some(760.0));
        assert_eq!(Dimension::Force.parse("-121.6 N"), Some(-121.6));
        assert_eq!(Dimension::Share.parse("1.3 %"), Some(0.013));
        assert_eq!(Dimension::Angle.parse("-90 deg"), Some(-std::f64::consts::FRAC_PI_2));
        assert_eq!(Dimension::SurgeMultiple.parse("0.5 f1"), Some(0.5));
        assert_eq!(Dimension::PerKelvin.parse("-0.025 %/K"), Some(-0.00025));
        assert_eq!(Dimension::Density.parse("7850 kg/m³"), Some(7850.0));
    }

    #[test]
    fn a_number_without_its_unit_or_with_another_is_not_a_quantity() {
        for text in ["104", "104 kg", "mm", "", "1,6 mm", "104 mm mm", "m", "1e mm"] {
            assert_eq!(Dimension::Length.parse(text), None, "{text}");
        }
        assert_eq!(Dimension::Share.parse("0.01"), None);
        assert_eq!(Dimension::Time.parse("5 1/s"), None);
    }
}
