//! A plant as an FMU: one file that simulators import (fmi-standard.org).
//!
//! Next door: what it says of itself (`description`), its binary (`compile`), the spring in it (`super::header`), its step (`unit.h`), what the
//! standard calls that (`fmi2.c`).

mod compile;
mod description;

use std::io::{Cursor, Write};

use minijinja::{AutoEscape, Environment, context};
use sha2::{Digest, Sha256};
use zip::CompressionMethod;
use zip::write::{SimpleFileOptions, ZipWriter};

use super::{Made, Plant, PlantError, header};
use crate::mitigation::export::{ExportError, Precision};

/// The files of an FMU but its binary.
struct Source {
    description: String,
    /// By name, that which is compiled first.
    files: [(String, String); 3],
}

/// The FMU, with a binary where this machine's compiler makes one.
///
/// - `step`: that of the default experiment \[s\]
pub(super) fn archive(made: &Plant, name: &str, step: f64) -> Result<Made, PlantError> {
    let source = source(made, name, step)?;
    let binary = compile::binary(name, &source.files);
    let mut files = vec![("modelDescription.xml".to_owned(), source.description.into_bytes())];
    files.extend(source.files.map(|(name, text)| (format!("sources/{name}"), text.into_bytes())));
    let left_out = match binary {
        Ok(binary) => {
            files.push((binary.path, binary.bytes));
            None
        }
        Err(why) => Some(format!("{why}: sources only, no binary for this machine")),
    };
    let bytes = packed(&files).map_err(|error| PlantError::Spec(format!("{}: {error}", made.spec_file)))?;
    Ok(Made { bytes, left_out })
}

/// All text, under an identity that is its hash.
fn source(made: &Plant, name: &str, step: f64) -> Result<Source, PlantError> {
    let spring = header::text(made, name, Precision::Double, &[])?;
    let told = description::Told::of(made, name, step);
    let render = |id: &str| -> Result<[String; 3], minijinja::Error> {
        let mut environment = Environment::new();
        environment
            .set_auto_escape_callback(|name| if name.ends_with(".xml") { AutoEscape::Html } else { AutoEscape::None });
        environment.add_template("fmi2.xml", include_str!("fmi2.xml"))?;
        environment.add_template("fmi2.c", include_str!("fmi2.c"))?;
        environment.add_template("unit.h", include_str!("unit.h"))?;
        let text = |template: &str| environment.get_template(template)?.render(context! { id => id, ..told.context() });
        Ok([text("fmi2.xml")?, text("fmi2.c")?, text("unit.h")?])
    };
    let all = render("").map_err(ExportError::from)?;
    let id = identity(all.iter().chain([&spring]));
    let [description, glue, unit] = render(&id).map_err(ExportError::from)?;
    let files = [("fmi2.c".to_owned(), glue), ("unit.h".to_owned(), unit), (format!("{name}.h"), spring)];
    Ok(Source { description, files: files.map(|(name, text)| (name, text + "\n")) })
}

/// A hash in the form of a GUID.
fn identity<'a>(texts: impl Iterator<Item = &'a String>) -> String {
    let mut hash = Sha256::new();
    for text in texts {
        hash.update((text.len() as u64).to_le_bytes());
        hash.update(text.as_bytes());
    }
    let mut id = String::from("{");
    for (place, byte) in hash.finalize().iter().take(16).enumerate() {
        let dash = if matches!(place, 4 | 6 | 8 | 10) { "-" } else { "" };
        id += &format!("{dash}{byte:02x}");
    }
    id + "}"
}

/// A zip file of these; the same bytes for the same files, whenever it is made.
fn packed(files: &[(String, Vec<u8>)]) -> zip::result::ZipResult<Vec<u8>> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Stored).unix_permissions(0o644);
    for (name, bytes) in files {
        archive.start_file(name.as_str(), options)?;
        archive.write_all(bytes)?;
    }
    Ok(archive.finish()?.into_inner())
}
