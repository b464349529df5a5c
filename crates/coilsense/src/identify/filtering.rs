//! Whether a logger took high frequencies away: whether a channel's own noise falls off far below half its rate.
//!
//! Next door: slow motion that is missing (`quasi_static`), what else a channel can show (`channel_check`).

use realfft::RealFftPlanner;

use super::median::median;

/// Segments that are looked at, at most; and their length \[s\], at most.
const SEGMENTS: usize = 64;
const SECONDS: f64 = 1.7;
/// Fewest and most samples of a segment.
const LENGTHS: (usize, usize) = (256, 16_384);
/// From a band of lines to the next, and its fewest lines.
const BAND: f64 = 1.122;
const LINES: usize = 6;
/// What a quarter of all exponentially distributed powers stay below, over their mean.
const QUARTER: f64 = 0.287_682;
/// How far the noise falls at the corner, and beyond twice the corner at least (3 dB and 8 dB).
const CORNER: f64 = 2.0;
const FALL: f64 = 6.3;
/// The highest corner, over the rate: above is what keeps lines from folding, as every good logger has it.
const HIGHEST: f64 = 0.3;
/// How flat the noise is below the corner: this share of the bands lies within a factor 2.5 of the level.
const FLAT: f64 = 0.5;

/// Corner of the low-pass that a channel's noise went through \[Hz\]; none where it was none, or where nothing but ringing shows.
///
/// In each line of the spectrum a quarter of the segments is quieter than the noise's power times 0.29, whatever rings in the others; in a
/// band of lines a quarter of them lies between what rings all the time. What is left is the floor of the channel's noise: flat, where
/// nothing filtered it.
pub(super) fn low_pass(values: &[f64], rate: f64) -> Option<f64> {
    let length = (values.len() / 12).min((SECONDS * rate) as usize).clamp(LENGTHS.0, LENGTHS.1);
    let length = if length.is_power_of_two() { length } else { length.next_power_of_two() / 2 };
    if values.len() < 4 * length {
        return None;
    }
    let segments = (2 * values.len() / length).min(SEGMENTS);
    let powers = powers(values, length, segments);
    let quiet = quarters(&powers);
    let bands = bands(&quiet);
    let spacing = rate / length as f64;
    let corner = (3..bands.len().saturating_sub(2)).find(|&corner| falls(&bands, corner))?;
    let (from, to, _) = bands[corner];
    // The band in which the fall begins is half below the corner.
    let frequency = spacing * ((from * to) as f64).sqrt();
    let noise = rough(&powers, bands[corner / 2].0.max(4), from);
    (frequency < HIGHEST * rate && noise).then_some(frequency)
}

/// Whether the floor is flat below a band and lower from there on.
fn falls(bands: &[(usize, usize, f64)], corner: usize) -> bool {
    let mut below: Vec<f64> = bands[..corner].iter().map(|band| band.2).collect();
    below.sort_by(f64::total_cmp);
    let level = below[below.len() / 4];
    let flat = below.iter().filter(|power| **power < 2.5 * level && **power > level / 2.5).count() as f64;
    let beyond = 2 * bands[corner].0;
    let least = bands.last().is_some_and(|band| band.0 > beyond);
    least
        && flat >= FLAT * corner as f64
        && bands[corner..].iter().all(|band| band.2 * CORNER < level)
        && bands.iter().filter(|band| band.0 >= beyond).all(|band| band.2 * FALL < level)
}

/// Powers of Hann-tapered segments spread over a record, shape `segments` of `lines`.
fn powers(values: &[f64], length: usize, segments: usize) -> Vec<Vec<f64>> {
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(length);
    let turn = std::f64::consts::TAU / length as f64;
    let taper: Vec<f64> = (0..length).map(|n| 0.5 * (1.0 - (turn * n as f64).cos())).collect();
    let (mut input, mut output) = (transform.make_input_vec(), transform.make_output_vec());
    let last = values.len() - length;
    let mut one = |segment: usize| {
        let start = last * segment / (segments - 1).max(1);
        let part = &values[start..start + length];
        // Less the straight line between its ends' means: slow motion would leak over the lines.
        let quarter = length / 4;
        let mean = |part: &[f64]| part.iter().sum::<f64>() / part.len() as f64;
        let (middle, slope) =
            (mean(part), (mean(&part[length - quarter..]) - mean(&part[..quarter])) / (length - quarter) as f64);
        for (n, (y, (x, w))) in input.iter_mut().zip(part.iter().zip(&taper)).enumerate() {
            *y = w * (x - middle - slope * (n as f64 - 0.5 * (length - 1) as f64));
        }
        // Lengths come from the plan itself.
        match transform.process(&mut input, &mut output) {
            Ok(()) => output.iter().map(|line| line.norm_sqr()).collect(),
            Err(_) => vec![0.0; length / 2 + 1],
        }
    };
    (0..segments).map(&mut one).collect()
}

/// Of each line the power that a quarter of the segments stays below, over what that is of noise of mean 1.
fn quarters(powers: &[Vec<f64>]) -> Vec<f64> {
    let mut all = vec![0.0; powers.len()];
    (0..powers[0].len())
        .map(|line| {
            all.iter_mut().zip(powers).for_each(|(one, segment)| *one = segment[line]);
            quarter(&mut all) / QUARTER
        })
        .collect()
}

fn quarter(values: &mut [f64]) -> f64 {
    let place = values.len() / 4;
    *values.select_nth_unstable_by(place, f64::total_cmp).1
}

/// Bands of lines (first, one past the last, floor), lowest first.
fn bands(quiet: &[f64]) -> Vec<(usize, usize, f64)> {
    let end = quiet.len() - 2;
    let mut bands = Vec::new();
    let mut from = 4;
    while from + LINES <= end {
        let to = ((from as f64 * BAND) as usize).max(from + LINES).min(end);
        bands.push((from, to, quarter(&mut quiet[from..to].to_vec())));
        from = to;
    }
    bands
}

/// Whether what is between two lines is as rough as noise: what leaks from strong lines of a record without noise is smooth.
///
/// |ln P_k−3 − 2 ln P_k + ln P_k+3| has the median 1.9 where powers are independent and exponentially distributed.
fn rough(powers: &[Vec<f64>], from: usize, to: usize) -> bool {
    let log = |power: f64| power.max(f64::MIN_POSITIVE).ln();
    let lines = from.max(3)..to.min(powers[0].len() - 3);
    let mut quietest: Vec<(f64, &Vec<f64>)> =
        powers.iter().map(|segment| (segment[lines.clone()].iter().map(|power| log(*power)).sum(), segment)).collect();
    quietest.sort_by(|a, b| a.0.total_cmp(&b.0));
    quietest.truncate((powers.len() / 4).max(1));
    let bend = |segment: &[f64], k: usize| (log(segment[k - 3]) - 2.0 * log(segment[k]) + log(segment[k + 3])).abs();
    let mut bends: Vec<f64> =
        quietest.iter().flat_map(|(_, segment)| lines.clone().map(|k| bend(segment, k))).collect();
    median(&mut bends) > 1.2
}
