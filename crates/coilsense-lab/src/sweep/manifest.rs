//! What a folder of chunks was made by: written once, before the first chunk, and never changed.
//!
//! Next door: the folder (`dataset`), the plan in it (`plan`).

use coilsense::simd::{SimdPath, VARIABLE};
use serde::{Deserialize, Serialize};

use super::SweepError;
use super::plan::{Plan, PlanParameters};
use crate::message::{Hint, Message};

/// The file's name: readers of folders of Parquet files pass over names that begin so.
pub(super) const NAME: &str = "_manifest.json";

const SCHEMA: &str = "coilsense/sweep/1";

/// The manifest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Manifest {
    schema: String,
    /// Of coilsense.
    version: String,
    /// The path of vector instructions: results are equal byte for byte on one only.
    simd: String,
    /// Of the plan.
    digest: String,
    rows: u64,
    chunks: u64,
    /// Titles of all columns.
    columns: Vec<String>,
    pub plan: PlanParameters,
}

impl Manifest {
    /// Of a plan on this processor.
    pub fn of(plan: &Plan) -> Result<Self, SweepError> {
        let simd = SimdPath::selected().map_err(|error| SweepError::new(error.to_string()))?;
        Ok(Self {
            schema: SCHEMA.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            simd: simd.name().to_owned(),
            digest: plan.digest(),
            rows: plan.rows(),
            chunks: plan.chunks(),
            columns: plan.titles(),
            plan: plan.parameters().clone(),
        })
    }

    /// As a file has it.
    pub fn to_json(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// Of a file's text.
    pub fn from_json(text: &str) -> Result<Self, String> {
        let manifest: Self =
            serde_json::from_str(text).map_err(|error| format!("is no manifest of a sweep: {error}"))?;
        match manifest.schema == SCHEMA {
            true => Ok(manifest),
            false => Err(format!("its schema is {:?}; this version reads {SCHEMA:?}", manifest.schema)),
        }
    }

    /// Whether rows of `other` may stand beside those of this one, or what differs.
    pub fn check(&self, other: &Self) -> Result<(), Message> {
        let (old, new) = (&self.plan, &other.plan);
        let shown = |rows: Option<u64>| rows.unwrap_or_default().to_string();
        let option = |name, text: String| Message::from(Hint::Option(name, "")) + text;
        let differences = [
            (old.spec != new.spec, format!("the spec {} has changed", new.spec_file).into()),
            (old.spec_file != new.spec_file, format!("the spec is {}, not {}", new.spec_file, old.spec_file).into()),
            (old.files != new.files, "a file that the spec names has changed".into()),
            (old.over != new.over, option("over", format!(" is {:?}, not {:?}", new.over, old.over))),
            (old.catalogue != new.catalogue, "the catalogue is another one".into()),
            (old.sampling != new.sampling, option("sampling", " is another one".to_owned())),
            (old.rows != new.rows, option("rows", format!(" is {}, not {}", shown(new.rows), shown(old.rows)))),
            (old.seed != new.seed, option("seed", format!(" is {}, not {}", new.seed, old.seed))),
            (old.columns != new.columns, option("columns", format!(" is {:?}, not {:?}", new.columns, old.columns))),
            (
                old.chunk_rows != new.chunk_rows,
                option("chunk", format!(" is {}, not {}", shown(new.chunk_rows), shown(old.chunk_rows))),
            ),
            (old != new, "the plan is another one".into()),
        ];
        if let Some((_, difference)) = differences.into_iter().find(|(differs, _)| *differs) {
            let message = Message::from("holds another sweep: ") + difference;
            return Err(message + "; take the same options, or another folder");
        }
        if self.version != other.version {
            return Err(format!(
                "was begun by coilsense {}, this is {}, whose last digits may differ; take another folder",
                self.version, other.version
            )
            .into());
        }
        if self.simd != other.simd {
            return Err(format!(
                "was begun with the vector instructions {}, this run has {}, whose last digits differ; set {VARIABLE}={}",
                self.simd, other.simd, self.simd
            )
            .into());
        }
        Ok(())
    }
}
