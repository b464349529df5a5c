//! Against `tests/golden/contact_steps.csv` and `contact_steps_rms.csv`: small steps with impulses on the gaps ahead, in another language
//! (`reference/contact_steps.py`). It knows a contact to a step, the engine to rounding: they must come together as the step does.

use coilsense::contact::{Contact, Course};

use super::reference::{PRELOAD, s_a, valve};

/// Samples a second of every row.
const RATE: f64 = 5000.0;
/// The scheme's steps \[µs\], as the table's columns have them.
const STEPS: [f64; 8] = [20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1];

/// Rows of a golden file as text. A missing file fails.
fn golden(file: &str) -> Vec<Vec<String>> {
    let path = format!("{}/tests/golden/{file}", env!("CARGO_MANIFEST_DIR"));
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
    reader.records().map(|record| record.unwrap().iter().map(str::to_owned).collect()).collect()
}

/// Time and then F_i and F_o at each step of the scheme, of one spring and restitution.
fn rows(spring: &str, restitution: f64) -> Vec<(f64, Vec<[f64; 2]>)> {
    let number = |text: &String| text.parse::<f64>().unwrap();
    let rows = golden("contact_steps.csv").into_iter();
    let rows = rows.filter(|row| row[0] == spring && number(&row[1]) == restitution);
    let forces = |row: &[String]| row.chunks(2).map(|pair| [number(&pair[0]), number(&pair[1])]).collect();
    rows.map(|row| (number(&row[2]), forces(&row[3..]))).collect()
}

/// F_i and F_o of a course at a time.
fn at(course: &Course, time: f64) -> [f64; 2] {
    let sample = (time * RATE).round() as usize;
    [course.input[sample], course.output[sample]]
}

/// RMS over the rows in a window of how far the scheme is from the engine at each step \[N\], the worse of F_i and F_o. `preload`: what the course's
/// forces leave out, for its valve spring counts from its mean length.
fn apart(rows: &[(f64, Vec<[f64; 2]>)], course: &Course, preload: f64, window: (f64, f64)) -> Vec<f64> {
    let inside: Vec<_> = rows.iter().filter(|(time, _)| window.0 <= *time && *time <= window.1).collect();
    assert!(inside.len() > 100, "a table of {} rows there", inside.len());
    let of = |step: usize, end: usize| {
        let squares =
            inside.iter().map(|(time, forces)| (forces[step][end] - at(course, *time)[end] + preload).powi(2));
        (squares.sum::<f64>() / inside.len() as f64).sqrt()
    };
    (0..STEPS.len()).map(|step| of(step, 0).max(of(step, 1))).collect()
}

/// Slope of ln(apart) over ln(step), by least squares.
fn order(apart: &[f64]) -> f64 {
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let [x, y] = [&STEPS[..], apart].map(|values| values.iter().map(|value| value.ln()).collect::<Vec<f64>>());
    let (about_x, about_y) = (mean(&x), mean(&y));
    let both: f64 = x.iter().zip(&y).map(|(x, y)| (x - about_x) * (y - about_y)).sum();
    both / x.iter().map(|x| (x - about_x).powi(2)).sum::<f64>()
}

/// Over the windows of a spring at the scheme's smallest step: from, to \[s\], RMS of F_i, F_o and F_o − F_i \[N\].
fn squares(spring: &str, restitution: f64) -> Vec<[f64; 5]> {
    let rows = golden("contact_steps_rms.csv").into_iter().map(|row| {
        let numbers: Vec<f64> = row[1..].iter().map(|text| text.parse().unwrap()).collect();
        (row[0].clone(), numbers)
    });
    let rows = rows.filter(|(name, row)| name == spring && row[0] == restitution && row[1] == STEPS[7]);
    rows.map(|(_, row)| std::array::from_fn(|column| row[column + 2])).collect()
}

#[test]
fn small_steps_of_s_a_come_together_with_the_events_as_the_step_does() {
    let (course, table) = (s_a(&Contact::default(), 0.6, RATE), rows("S_A", 0.0));
    // From the first contact over 36 contacts, 0.05 to 0.08 N per µs at every step: a contact is known to a step, and its time enters the
    // forces linearly. A slope over eight steps of that scatter is good to a tenth.
    let early = apart(&table, &course, 0.0, (0.53, 0.56));
    assert!((0.9..1.15).contains(&order(&early)), "{early:?}: of order {}", order(&early));
    assert!(early.iter().zip(STEPS).all(|(apart, step)| *apart < 0.1 * step), "{early:?}");
    // Later on some windings meet at a speed that tends to nothing, or miss each other, and a step more or less counts for more: 0.77.
    let late = apart(&table, &course, 0.0, (0.53, 0.6));
    assert!((0.65..1.15).contains(&order(&late)) && late[7] < 0.06, "{late:?}: of order {}", order(&late));
}

#[test]
fn small_steps_of_the_valve_spring_come_together_with_the_events_as_the_step_does() {
    // 0.40 to 0.67, 0.29 to 0.54 and 0.53 to 0.98 N per µs; the slope as good as above.
    for (restitution, per_step) in [(0.0, 0.8), (0.2, 0.7), (0.5, 1.2)] {
        let course = valve(&Contact::hard(restitution).unwrap(), 6, 0.12, RATE);
        let apart = apart(&rows("valve", restitution), &course, PRELOAD, (0.08, 0.12));
        let order = order(&apart);
        assert!((0.85..1.15).contains(&order), "{restitution}: {apart:?}, of order {order}");
        assert!(apart.iter().zip(STEPS).all(|(apart, step)| *apart < per_step * step), "{restitution}: {apart:?}");
    }
}

#[test]
fn small_steps_do_not_come_together_with_another_restitution() {
    let course = valve(&Contact::hard(0.2).unwrap(), 6, 0.12, RATE);
    let apart = apart(&rows("valve", 0.0), &course, PRELOAD, (0.08, 0.12));
    assert!(apart.iter().all(|apart| *apart > 3.0), "{apart:?}");
    assert!(order(&apart).abs() < 0.3, "{apart:?}: of order {}", order(&apart));
}

/// Within 0.3 %, as the reference figures of two other schemes; found: 7e-4 or better, but 2e-3 of restitution 0.5 after 0.24 s, where the scheme's own
/// figure still moves by 9e-4 from a step of 0.2 to one of 0.1 µs.
#[test]
fn the_smallest_steps_have_the_same_mean_squares() {
    let rate = 50_000.0;
    let mut courses = vec![("S_A", 0.0, 0.0, s_a(&Contact::default(), 0.75, rate))];
    for restitution in [0.0, 0.2, 0.5] {
        courses.push(("valve", restitution, PRELOAD, valve(&Contact::hard(restitution).unwrap(), 6, 0.3, rate)));
    }
    for (spring, restitution, preload, course) in courses {
        let windows = squares(spring, restitution);
        assert_eq!(windows.len(), 2, "windows of {spring} at {restitution}");
        for [from, to, expected @ ..] in windows {
            let [from, to] = [from, to].map(|time| (time * rate).round() as usize);
            let forces = course.input[from..to].iter().zip(&course.output[from..to]);
            let forces: Vec<[f64; 2]> = forces.map(|(input, output)| [input - preload, output - preload]).collect();
            let rms = |of: fn(&[f64; 2]) -> f64| {
                (forces.iter().map(|pair| of(pair).powi(2)).sum::<f64>() / forces.len() as f64).sqrt()
            };
            let found = [rms(|pair| pair[0]), rms(|pair| pair[1]), rms(|pair| pair[1] - pair[0])];
            for (found, expected) in found.into_iter().zip(expected) {
                assert!(
                    (found / expected - 1.0).abs() < 3e-3,
                    "{spring}, {restitution}, from {from}: {found} for {expected}"
                );
            }
        }
    }
}
