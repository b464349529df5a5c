//! The page of all keys is what the reader knows.

use coilsense_lab::spec::experiment_markdown;

#[test]
fn the_reference_of_all_keys_is_up_to_date() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/src/guide/experiment.md");
    if std::env::var_os("COILSENSE_WRITE_DOCS").is_some() {
        std::fs::write(path, experiment_markdown()).expect("book/src/guide/experiment.md can be written");
    }
    let written = std::fs::read_to_string(path).unwrap_or_default();
    let refresh = "COILSENSE_WRITE_DOCS=1 cargo test -p coilsense-lab --test experiment";
    assert!(
        written == experiment_markdown(),
        "book/src/guide/experiment.md is not what the reader's own table says; refresh it: {refresh}"
    );
}
