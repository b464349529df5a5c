//! Case by case, with what an earlier spec left: the same to the bit as the whole run, and nothing computed that is known.

use coilsense_lab::analysis::{Analysis, AnalysisError, Earlier, UnderWay};

use super::{S_T, spec};

/// Two conditions of which one says how fast, and sensors with noise, which a case's number seeds.
const TWO: &str = "[[condition]]\nname = \"hit\"\nkind = \"impact\"\nvelocity = \"0.25 m/s\"\nduration = \"50 ms\"\n\
                   [[condition]]\nname = \"swing\"\nkind = \"harmonic\"\nfrequency = \"20 Hz\"\namplitude = \"1 mm\"\nduration = \"60 ms\"\n";
const SENSORS: &str = "[[sensor]]\nkind = \"load-cell\"\nnoise = \"0.1 %\"\nsample_rate = \"1 kHz\"\nresolution = \"0.1 N\"\n\
                       [[sensor]]\nkind = \"inductance\"\naveraging = \"5 ms\"\nnoise = \"0.01 %\"\n";
const REST: &str = "[mount]\ndamping_ratio = [0.005, 0.02]\n[goal]\nerror = \"0.5 %\"\nbandwidth = \"20 Hz\"\n[uncertainty]\ntrials = 1000\nseed = 1\n";

fn first() -> String {
    format!("{S_T}\n{TWO}{SENSORS}{REST}")
}

/// Everything that an analysis says: a number prints so that it reads back as itself, equal texts are equal bits.
fn told(Analysis { cases, verdicts, warnings, data_sheet, masses, if_usual, .. }: &Analysis) -> String {
    format!("{cases:?} {verdicts:?} {warnings:?} {data_sheet:?} {masses:?} {if_usual:?}")
}

/// How many cases had to be computed; the answer is that of the whole run.
fn judged(text: &str, earlier: Earlier) -> (usize, Earlier) {
    let mut under_way = UnderWay::begin(spec(text), earlier).unwrap();
    let (mut computed, (_, count)) = (0, under_way.progress());
    for done in 1..=count {
        computed += usize::from(under_way.step().unwrap());
        assert_eq!(under_way.progress(), (done, count));
    }
    assert!(!under_way.step().unwrap(), "a case too many");
    let concluded = under_way.conclude().unwrap();
    let whole = Analysis::run(spec(text), &|_, _| true).unwrap();
    assert!(told(&concluded.analysis) == told(&whole), "another answer than the whole run's:\n{text}");
    (computed, concluded.earlier())
}

#[test]
fn what_an_edit_leaves_as_it_was_is_not_computed_again() {
    let swapped = {
        let (hit, swing) = TWO.split_at(TWO.rfind("[[condition]]").unwrap());
        format!("{S_T}\n{swing}{hit}{SENSORS}{REST}")
    };
    let changed = |from: &str, to: &str| {
        assert!(first().contains(from), "{from}");
        first().replace(from, to)
    };
    for (edited, expected) in [
        (first(), 0),
        (format!("# Words alone.\n{}", first()), 0),
        (changed("0.25 m/s", "0.3 m/s"), 2),
        (changed("20 Hz\"\namplitude", "21 Hz\"\namplitude"), 2),
        (changed("\"hit\"", "\"blow\""), 2),
        (changed("[0.005, 0.02]", "[0.005, 0.03]"), 2),
        // What follows has other numbers: its noise is another.
        (changed("[0.005, 0.02]", "[0.001, 0.005, 0.02]"), 6),
        (changed("[0.005, 0.02]", "0.02"), 2),
        (swapped, 4),
        (changed("0.1 N\"", "0.2 N\""), 4),
        (changed("0.5 %", "0.4 %"), 4),
        (changed("bandwidth = \"20 Hz\"", ""), 4),
        (changed("seed = 1", "seed = 2"), 4),
        (changed("averaging = \"5 ms\"\n", ""), 4),
        (changed("[mount]", "[mount]\nend2 = \"force\""), 4),
        (changed("760 N/m", "761 N/m"), 4),
        (changed("stiffness = \"760 N/m\"", "stiffness = \"760 N/m\"\nstiffness_tolerance = \"5 %\""), 4),
    ] {
        let (computed, earlier) = judged(&first(), Earlier::default());
        assert_eq!(computed, 4);
        assert_eq!(judged(&edited, earlier).0, expected, "\n{edited}");
    }
}

#[test]
fn what_was_settled_before_a_spec_was_given_up_or_refused_is_known() {
    let (text, edited) = (first(), first().replace("0.25 m/s", "0.3 m/s"));
    let mut under_way = UnderWay::begin(spec(&text), Earlier::default()).unwrap();
    for _ in 0..3 {
        assert!(under_way.step().unwrap());
    }
    // The two of the hit are others now; one of the swing is known.
    let (computed, earlier) = judged(&edited, under_way.earlier());
    assert_eq!(computed, 3);
    // Back again, half way: what is of the newest spec stays, and what it did not use.
    let mut under_way = UnderWay::begin(spec(&text), earlier).unwrap();
    assert!(under_way.step().unwrap());
    assert_eq!(judged(&edited, under_way.earlier()).0, 0);

    let none = UnderWay::begin(spec(S_T), Earlier::default()).err();
    assert!(matches!(none, Some(AnalysisError::NoCondition(_))));
}
