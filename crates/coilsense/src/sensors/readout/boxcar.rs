//! The mean over a preceding window: an LCR meter, an integrating converter.
//!
//! Next door: a plain delay (`delay`).

/// Mean of `values` over the `window` W \[s\] before each of `times` \[s\], shape `samples`.
///
/// y(t) = (1/W) ∫ x dt from t − W to t
///
/// Source:   definition; the integral of straight lines is the trapezoidal rule.
/// Valid:    x straight between samples, constant before the first.
/// Accuracy: 1e-13 of x's range, or the last digit of t over W where that is more (3e-12 at 200 s with W = 10 ms), against plain
///           sums; the integral is that of x less its first value, summed after Kahan, so a long log does not wear it out.
pub(super) fn mean_over(window: f64, times: &[f64], values: &[f64]) -> Vec<f64> {
    let origin = values.first().copied().unwrap_or(0.0);
    let integral = running_integral(times, values, origin);
    let mut left = 0;
    let mut means = Vec::with_capacity(values.len());
    for (sample, &end) in times.iter().enumerate() {
        let start = end - window;
        // The window as the times' digits know it; one below their last digit shows the value itself.
        let known = end - start;
        if sample == 0 || known <= 0.0 {
            means.push(values[sample]);
            continue;
        }
        while left + 1 < sample && times[left + 1] <= start {
            left += 1;
        }
        let mut area = integral[sample] - integral[left];
        if start > times[left] {
            let share = (start - times[left]) / (times[left + 1] - times[left]);
            let first = values[left] + share * (values[left + 1] - values[left]) - origin;
            let last = values[left + 1] - origin;
            // From the window's start to the next sample, and whole intervals from there: no difference of nearly equal areas.
            area = integral[sample] - integral[left + 1] + 0.5 * (times[left + 1] - start) * (first + last);
        }
        means.push(origin + area / known);
    }
    means
}

/// ∫ (x − origin) dt from the first time to each, shape `samples`.
fn running_integral(times: &[f64], values: &[f64], origin: f64) -> Vec<f64> {
    let mut integral = Vec::with_capacity(values.len());
    let (mut sum, mut lost) = (0.0, 0.0);
    integral.extend(values.first().map(|_| 0.0));
    for (time, value) in times.windows(2).zip(values.windows(2)) {
        let area = 0.5 * (time[1] - time[0]) * ((value[0] - origin) + (value[1] - origin)) - lost;
        let next = sum + area;
        lost = (next - sum) - area;
        sum = next;
        integral.push(sum);
    }
    integral
}
