//! Writing a log, and reading it again.

use coilsense_lab::recording::{Cleaning, Mapping, Recording};

/// A mapping of these columns.
pub fn mapping(columns: &[&str]) -> Mapping {
    let mut mapping = Mapping::default();
    for column in columns {
        mapping.set(column).expect("a column");
    }
    mapping
}

/// Reads a text as a log; errors without the folder's name.
pub fn read_with(text: impl AsRef<[u8]>, mapping: &Mapping, cleaning: &Cleaning) -> Result<Recording, String> {
    let place = tempfile::tempdir().expect("a temporary folder");
    let path = place.path().join("run.csv");
    std::fs::write(&path, text).expect("written");
    let folder = format!("{}/", place.path().display());
    Recording::read(&path, mapping, cleaning).map_err(|error| error.to_string().replace(&folder, ""))
}

/// The same without mapping and cleaning.
pub fn read(text: impl AsRef<[u8]>) -> Result<Recording, String> {
    read_with(text, &Mapping::default(), &Cleaning::default())
}
