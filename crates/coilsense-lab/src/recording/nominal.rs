//! The rate that people set, of one that was measured: 2.5 kHz of 2.503 kHz.
//!
//! Next door: who proposes it (`clock`, `mod`).

/// Rates as devices have them, between 1 and 10 of any power of ten, and how close a measured one must be.
const ROUND: [(&[f64], f64); 3] = [
    (&[1.0, 2.0, 2.5, 5.0, 10.0], 0.01),
    (&[1.2, 1.25, 1.5, 1.6, 3.0, 4.0, 6.0, 7.5, 8.0], 0.005),
    (&[1.024, 1.1025, 1.28, 1.92, 2.048, 2.205, 2.4, 2.56, 3.2, 3.84, 4.096, 4.41, 4.8, 5.12, 6.4, 8.192, 9.6], 0.003),
];

/// The round rate \[Hz\] next to a measured one; where none is close, its first four digits.
pub(super) fn nominal(rate: f64) -> f64 {
    if !(rate.is_finite() && rate > 0.0) {
        return 1.0;
    }
    let power = rate.log10().floor() as i32;
    let scale = 10f64.powi(power.abs());
    let (mantissa, back) = if power < 0 { (rate * scale, 1.0 / scale) } else { (rate / scale, scale) };
    for (rates, close) in ROUND {
        let nearest = rates.iter().copied().min_by(|a, b| (a - mantissa).abs().total_cmp(&(b - mantissa).abs()));
        if let Some(nearest) = nearest.filter(|nearest| (nearest - mantissa).abs() <= close * nearest) {
            return round(nearest * back);
        }
    }
    round((mantissa * 1e3).round() / 1e3 * back)
}

/// Without the last bits of a product.
fn round(rate: f64) -> f64 {
    format!("{rate:.9e}").parse().unwrap_or(rate)
}

#[cfg(test)]
mod tests {
    use super::nominal;

    #[test]
    fn rates_are_those_that_people_set() {
        for (measured, round) in [
            (2503.0, 2500.0),
            (2500.0, 2500.0),
            (996.0, 1000.0),
            (48_010.0, 48_000.0),
            (44_098.0, 44_100.0),
            (2047.9, 2048.0),
            (0.1001, 0.1),
            (10.0, 10.0),
            (1737.26, 1737.0),
            (51_200.0, 51_200.0),
        ] {
            assert_eq!(nominal(measured), round, "{measured}");
        }
    }
}
