//! A plant as an FMU: one file that simulators import (fmi-standard.org).
//!
//! Next door: what it says of itself (`description`), its binary (`compile`), the spring in it (`super::header`), its step (`unit.h`) and its equations
//! (`exchange.h`), what the
//! standard calls that (`fmi2.c`, `fmi3.c`).

mod compile;
mod description;

use std::io::{Cursor, Write};

use minijinja::{AutoEscape, Environment, context};
use sha2::{Digest, Sha256};
use zip::CompressionMethod;
use zip::write::{SimpleFileOptions, ZipWriter};

use super::{Fmi, Made, Plant, PlantError, header};
use crate::mitigation::export::{ExportError, Precision};

/// The files of an FMU but its binary.
struct Source {
    description: String,
    /// By name, that which is compiled first.
    files: Vec<(String, String)>,
}

/// Templates by the names of the files that they make: the description, then that which is compiled, then all others.
type Templates = [(&'static str, &'static str)];

const UNIT: (&str, &str) = ("unit.h", include_str!("unit.h"));

impl Fmi {
    fn templates(self) -> &'static Templates {
        match self {
            Self::Two => &[
                ("fmi2.xml", include_str!("fmi2.xml")),
                ("fmi2.c", include_str!("fmi2.c")),
                UNIT,
                ("exchange.h", include_str!("exchange.h")),
                ("fmi2_exchange.h", include_str!("fmi2_exchange.h")),
            ],
            Self::Three => &[
                ("fmi3.xml", include_str!("fmi3.xml")),
                ("fmi3.c", include_str!("fmi3.c")),
                UNIT,
                ("fmi3_others.h", include_str!("fmi3_others.h")),
                ("buildDescription.xml", include_str!("fmi3_build.xml")),
            ],
        }
    }
}

/// The FMU, with a binary where this machine's compiler makes one.
///
/// - `step`: that of the default experiment \[s\]
pub(super) fn archive(made: &Plant, name: &str, version: Fmi, step: f64) -> Result<Made, PlantError> {
    let source = source(made, name, version, step)?;
    let binary = compile::binary(name, version, &source.files);
    let mut files = vec![("modelDescription.xml".to_owned(), source.description.into_bytes())];
    files.extend(source.files.into_iter().map(|(name, text)| (format!("sources/{name}"), text.into_bytes())));
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
fn source(made: &Plant, name: &str, version: Fmi, step: f64) -> Result<Source, PlantError> {
    let spring = header::text(made, name, Precision::Double, &[])?;
    let told = description::Told::of(made, name, version, step);
    let templates = version.templates();
    let render = |id: &str| -> Result<Vec<(String, String)>, minijinja::Error> {
        let mut environment = Environment::new();
        environment
            .set_auto_escape_callback(|name| if name.ends_with(".xml") { AutoEscape::Html } else { AutoEscape::None });
        for (name, template) in templates {
            environment.add_template(name, template)?;
        }
        let text = |name: &str| environment.get_template(name)?.render(context! { id => id, ..told.context() });
        templates.iter().map(|(name, _)| Ok(((*name).to_owned(), text(name)? + "\n"))).collect()
    };
    let all = render("").map_err(ExportError::from)?;
    let id = identity(all.iter().map(|(_, text)| text).chain([&spring]));
    let mut files = render(&id).map_err(ExportError::from)?;
    let (_, description) = files.remove(0);
    files.push((format!("{name}.h"), spring));
    Ok(Source { description, files })
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
