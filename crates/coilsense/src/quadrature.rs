//! Gauss's rule, for what has no elementary integral.
//!
//! Next door: who integrates: a motion under a chirp (`motion`), Neumann's integral of a helix (`inductance::theories`).

/// Gauss–Legendre abscissae and weights on (−1, 1), the positive half; n = 12, `[DLMF]` 3.5.
pub(crate) const GAUSS_12: [(f64, f64); 6] = [
    (0.125_233_408_511_468_9, 0.249_147_045_813_402_8),
    (0.367_831_498_998_180_2, 0.233_492_536_538_354_8),
    (0.587_317_954_286_617_4, 0.203_167_426_723_065_93),
    (0.769_902_674_194_304_7, 0.160_078_328_543_346_24),
    (0.904_117_256_370_474_8, 0.106_939_325_995_318_43),
    (0.981_560_634_246_719_2, 0.047_175_336_386_511_83),
];

/// Points and weights on (0, 1), in panels of [`GAUSS_12`].
pub(crate) fn unit_points(panels: usize) -> impl Iterator<Item = (f64, f64)> {
    let width = 1.0 / panels as f64;
    let both = || GAUSS_12.iter().flat_map(|&(x, weight)| [(-x, weight), (x, weight)]);
    let of_panel = move |panel: usize| {
        both().map(move |(x, weight)| (width * (panel as f64 + 0.5 + 0.5 * x), 0.5 * width * weight))
    };
    (0..panels).flat_map(of_panel)
}

/// ∫ f from `from` to `to` by one panel of [`GAUSS_12`].
pub(crate) fn panel(from: f64, to: f64, mut function: impl FnMut(f64) -> f64) -> f64 {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let pairs =
        GAUSS_12.iter().map(|&(x, weight)| weight * (function(middle - half * x) + function(middle + half * x)));
    half * pairs.sum::<f64>()
}
