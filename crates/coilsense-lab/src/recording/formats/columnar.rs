//! What the numbers of a column mean in files that type their columns, and the `f64` that is nearest to each.
//!
//! Next door: the readers of such files (`parquet`, `arrow`).

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// Numbers as they are.
    Plain,
    /// Whole numbers without a sign.
    Unsigned,
    /// Whole numbers of 10^-scale each.
    Decimal(i32),
    /// Floating-point numbers of 16 bits.
    Half,
    /// Instants in units of 10^-digits s; they count from the first one.
    Stamp(i32),
    /// Days, which count from the first one.
    Day,
    /// Stretches of time in units of 10^-digits s.
    Duration(i32),
}

impl Kind {
    /// Whether it holds dates or times of day.
    pub fn stamps(self) -> bool {
        matches!(self, Self::Stamp(_) | Self::Day)
    }

    /// The number that a stored whole number means; `first` is the column's first instant.
    pub fn number(self, value: i128, first: &mut Option<i128>) -> f64 {
        match self {
            // Whole numbers are to be read with their sign, or without, before they come here.
            Self::Plain | Self::Unsigned | Self::Half => value as f64,
            Self::Decimal(scale) => decimal(value, scale),
            Self::Stamp(digits) => decimal(value - *first.get_or_insert(value), digits),
            Self::Day => (value - *first.get_or_insert(value)) as f64 * 86_400.0,
            Self::Duration(digits) => decimal(value, digits),
        }
    }
}

/// The `f64` nearest to value · 10^-scale.
fn decimal(value: i128, scale: i32) -> f64 {
    // Both are exact, so the quotient is rounded once.
    const EXACT: u128 = 1 << 53;
    if value.unsigned_abs() <= EXACT && (0..=22).contains(&scale) {
        return value as f64 / 10_f64.powi(scale);
    }
    format!("{value}e{}", -i64::from(scale)).parse().unwrap_or(f64::NAN)
}

/// A whole number of any length, its highest byte first; `None` where it does not fit.
pub(super) fn whole(bytes: &[u8]) -> Option<i128> {
    let (above, low) = bytes.split_at(bytes.len().saturating_sub(16));
    let sign = if bytes.first().is_some_and(|byte| *byte >= 0x80) { 0xff } else { 0 };
    let mut all = [sign; 16];
    all[16 - low.len()..].copy_from_slice(low);
    let fits = above.iter().all(|byte| *byte == sign) && (above.is_empty() || (all[0] >= 0x80) == (sign == 0xff));
    fits.then_some(i128::from_be_bytes(all))
}

/// The number of 16 bits of IEEE 754.
pub(super) fn half(bits: u16) -> f64 {
    let sign = if bits >> 15 == 1 { -1.0 } else { 1.0 };
    let (exponent, fraction) = (i32::from(bits >> 10 & 0x1f), f64::from(bits & 0x3ff));
    sign * match exponent {
        0 => fraction * 2_f64.powi(-24),
        31 if fraction == 0.0 => f64::INFINITY,
        31 => f64::NAN,
        _ => (1024.0 + fraction) * 2_f64.powi(exponent - 25),
    }
}

#[cfg(test)]
mod tests {
    use super::{Kind, half, whole};

    #[test]
    fn decimals_are_the_numbers_nearest_to_what_is_written() {
        let number = |value, scale| Kind::Decimal(scale).number(value, &mut None);
        assert_eq!(number(1_234_567, 3), 1234.567);
        assert_eq!(number(-1, 1), -0.1);
        assert_eq!(number(12_345_678_901_234_567_890_123_456_789, 20), 123_456_789.012_345_67);
        assert_eq!(number(9_007_199_254_740_993, 2), 90_071_992_547_409.93);
        assert_eq!(number(7, -3), 7000.0);
        assert_eq!(number(i128::MAX, 0), 1.701_411_834_604_692_3e38);
    }

    #[test]
    fn whole_numbers_of_any_length_keep_their_sign() {
        assert_eq!(whole(&[0xff]), Some(-1));
        assert_eq!(whole(&[0x00, 0xff]), Some(255));
        assert_eq!(whole(&[]), Some(0));
        assert_eq!(whole(&[[0xff; 20].as_slice(), &[0x80, 0]].concat()), Some(-32768));
        assert_eq!(whole(&[[0; 20].as_slice(), &[0x80, 0]].concat()), Some(32768));
        assert_eq!(whole(&[[0; 1].as_slice(), &[0xff; 16]].concat()), None);
        assert_eq!(whole(&[1; 17]), None);
    }

    #[test]
    fn halves_are_those_of_ieee_754() {
        let known =
            [(0x0000, 0.0), (0x3c00, 1.0), (0xc000, -2.0), (0x7bff, 65504.0), (0x0001, 5.960_464_477_539_063e-8)];
        assert!(known.iter().all(|(bits, value)| half(*bits) == *value));
        assert!(half(0x7c00) == f64::INFINITY && half(0xfe00).is_nan());
        assert!(half(0x8000).is_sign_negative());
    }

    #[test]
    fn instants_count_from_the_first_and_no_sign_is_none() {
        let mut first = None;
        let stamps = [i128::from(i64::MAX), i128::from(i64::MIN)].map(|value| Kind::Stamp(9).number(value, &mut first));
        assert_eq!(stamps, [0.0, -18_446_744_073.709_553]);
        assert_eq!(Kind::Unsigned.number(i128::from(u64::MAX), &mut None), 18_446_744_073_709_551_615.0);
        let mut first = Some(20_000);
        assert_eq!(Kind::Day.number(20_002, &mut first), 172_800.0);
    }
}
