//! The folder: what is there is whole, what is missing is made again, and what does not belong there is refused.

use std::collections::BTreeMap;
use std::path::Path;

use coilsense_lab::sweep::{Data, Dataset, Plan, PlanParameters};

use super::{QUICK, of};

pub fn quick(seed: u64) -> Plan {
    let parameters = of(QUICK, &["spring.mass=-5..80 g"], &["F_o.rmsd"]);
    Plan::new(PlanParameters { rows: Some(50), chunk_rows: Some(8), seed, ..parameters }).unwrap()
}

pub fn fill(folder: &Path, plan: &Plan) {
    let dataset = Dataset::create_or_open(folder, plan).unwrap();
    for chunk in dataset.missing().unwrap() {
        dataset.write(chunk, &plan.chunk_bytes(chunk, &|| true).unwrap().unwrap()).unwrap();
    }
}

pub fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let file = |entry: std::io::Result<std::fs::DirEntry>| {
        let entry = entry.unwrap();
        (entry.file_name().into_string().unwrap(), std::fs::read(entry.path()).unwrap())
    };
    std::fs::read_dir(folder).unwrap().map(file).collect()
}

#[test]
fn a_folder_with_chunks_missing_is_filled_to_the_same_bytes() {
    let place = tempfile::tempdir().unwrap();
    fill(place.path(), &quick(1));
    let whole = files(place.path());
    assert_eq!(whole.len(), 7 + 2);
    for chunk in ["chunk-000000.parquet", "chunk-000003.parquet"] {
        std::fs::remove_file(place.path().join(chunk)).unwrap();
    }
    // What a killed run leaves is neither read nor kept.
    std::fs::write(place.path().join(".unfinished-chunk-000003.parquet"), "torn").unwrap();
    fill(place.path(), &quick(1));
    assert_eq!(files(place.path()), whole);
}

#[test]
fn columns_come_back_as_they_were_computed() {
    let place = tempfile::tempdir().unwrap();
    let plan = quick(2);
    fill(place.path(), &plan);
    let dataset = Dataset::open(place.path()).unwrap();
    let titles = ["row", "spring.mass [kg]", "F_o.rmsd [%]", "status"];
    let read = dataset.read(&titles).unwrap();
    assert_eq!(read[0], Data::Whole((0..50).collect()));
    let of =
        |title: &str| super::whole(&plan).iter().flat_map(|chunk| super::numbers(chunk, title)).collect::<Vec<_>>();
    let bits = |data: &Data| match data {
        Data::Numbers(values) => values.iter().map(|value| value.to_bits()).collect::<Vec<_>>(),
        other => panic!("{other:?}"),
    };
    assert_eq!(bits(&read[1]), bits(&Data::Numbers(of("spring.mass [kg]"))));
    assert_eq!(bits(&read[2]), bits(&Data::Numbers(of("F_o.rmsd [%]"))));
    let tally = dataset.tally().unwrap();
    // Three of 50 masses spread evenly from −5 to 80 g are not above zero, or just below a thousand millionths.
    assert_eq!((tally.rows, tally.ok + tally.refused), (50, 50));
    assert!((2..=4).contains(&tally.refused), "{tally:?}");
    // Masses of different sizes are one reason.
    assert_eq!(tally.reasons.len(), 1, "{tally:?}");
}

#[test]
fn another_sweep_another_processor_and_a_second_run_are_refused() {
    let place = tempfile::tempdir().unwrap();
    fill(place.path(), &quick(1));
    let refusal = |plan: &Plan| Dataset::create_or_open(place.path(), plan).unwrap_err().to_string();
    assert!(refusal(&quick(3)).contains("holds another sweep: --seed is 3, not 1"), "{}", refusal(&quick(3)));
    let other = Plan::new(PlanParameters { spec: QUICK.replace("65 g", "64 g"), ..quick(1).parameters().clone() });
    assert!(refusal(&other.unwrap()).contains("the spec spec.toml has changed"));
    let held = Dataset::create_or_open(place.path(), &quick(1)).unwrap();
    assert!(refusal(&quick(1)).contains("another run is writing"));
    drop(held);
    let manifest = place.path().join("_manifest.json");
    let text = std::fs::read_to_string(&manifest).unwrap();
    let path = coilsense::simd::SimdPath::selected().unwrap().name();
    let other = text.replace(&format!("\"simd\": \"{path}\""), "\"simd\": \"neon\"");
    std::fs::write(&manifest, super::damaged::sealed_anew(&other)).unwrap();
    assert!(refusal(&quick(1)).ends_with("set COILSENSE_SIMD=neon"), "{}", refusal(&quick(1)));
    std::fs::write(&manifest, &text[..text.len() / 2]).unwrap();
    assert!(refusal(&quick(1)).contains("is no manifest of a sweep"));
    std::fs::remove_file(&manifest).unwrap();
    assert!(refusal(&quick(1)).contains("has chunks but no _manifest.json"));
    let error = Dataset::open(place.path()).unwrap_err().to_string();
    assert!(error.contains("holds no sweep"), "{error}");
}

#[test]
fn a_folder_that_is_only_read_is_not_written_to() {
    let place = tempfile::tempdir().unwrap();
    fill(place.path(), &quick(1));
    let error = Dataset::open(place.path()).unwrap().write(0, b"").unwrap_err().to_string();
    assert!(error.ends_with("was opened to be read"), "{error}");
}
