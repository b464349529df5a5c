//! What a folder of chunks was made by: written once, before the first chunk, and never changed. A digest in it tells where somebody did.
//!
//! Next door: the folder (`dataset`), the plan in it (`plan`), what makes two plans one sweep (`identity`).

use coilsense::simd::{SimdPath, VARIABLE};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::SweepError;
use super::identity::{canonical, hexadecimal};
use super::plan::{Plan, PlanParameters};
use crate::message::{Hint, Message};

/// The file's name: readers of folders of Parquet files pass over names that begin so.
pub(super) const NAME: &str = "_manifest.json";

const SCHEMA: &str = "coilsense/sweep/2";

/// The manifest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Manifest {
    schema: String,
    /// Of coilsense.
    version: String,
    /// The path of vector instructions: results are equal byte for byte on one only.
    simd: String,
    /// Of the plan, as [`Plan::digest`] has it.
    pub digest: String,
    rows: u64,
    chunks: u64,
    /// Titles of all columns.
    columns: Vec<String>,
    pub plan: PlanParameters,
    /// SHA-256 of this file with nothing in place of it.
    sha256: String,
}

impl Manifest {
    /// Of a plan on this processor.
    pub fn of(plan: &Plan) -> Result<Self, SweepError> {
        let simd = SimdPath::selected().map_err(|error| SweepError::new(error.to_string()))?;
        let manifest = Self {
            schema: SCHEMA.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            simd: simd.name().to_owned(),
            digest: plan.digest(),
            rows: plan.rows(),
            chunks: plan.chunks(),
            columns: plan.titles(),
            plan: plan.parameters().clone(),
            sha256: String::new(),
        };
        Ok(Self { sha256: manifest.seal(), ..manifest })
    }

    /// SHA-256 of its text without this digest.
    fn seal(&self) -> String {
        hexadecimal(Sha256::digest(Self { sha256: String::new(), ..self.clone() }.to_json()))
    }

    /// The plan in it, which is the one that it was written with.
    pub fn plan(&self) -> Result<Plan, SweepError> {
        let plan = Plan::new(self.plan.clone())?;
        let holds = plan.digest_of(&self.version) == self.digest;
        let counts = (plan.rows(), plan.chunks(), plan.titles());
        match holds && counts == (self.rows, self.chunks, self.columns.clone()) {
            true => Ok(plan),
            false => Err(SweepError::new(format!(
                "was made by coilsense {}, whose plans this one, {}, does not understand: read it with that version",
                self.version,
                env!("CARGO_PKG_VERSION")
            ))),
        }
    }

    /// As a file has it.
    pub fn to_json(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// Of a file's text.
    pub fn from_json(text: &str) -> Result<Self, String> {
        let manifest: Self =
            serde_json::from_str(text).map_err(|error| format!("is no manifest of a sweep: {error}"))?;
        if manifest.schema != SCHEMA {
            return Err(format!("its schema is {:?}; this version reads {SCHEMA:?}", manifest.schema));
        }
        match manifest.seal() == manifest.sha256 {
            true => Ok(manifest),
            false => Err("has been changed since it was written, so that its rows are no longer those of its plan; put the old one back, or sweep into another folder".to_owned()),
        }
    }

    /// Whether rows of `other` may stand beside those of this one, or what differs.
    pub fn check(&self, other: &Self) -> Result<(), Message> {
        let (old, new) = (&self.plan, &other.plan);
        let shown = |rows: Option<u64>| rows.unwrap_or_default().to_string();
        let changed = match old.spec_file == new.spec_file {
            true => format!("the spec {} has changed", new.spec_file),
            false => format!("the spec {} says other than {} did", new.spec_file, old.spec_file),
        };
        let option = |name, text: String| Message::from(Hint::Option(name, "")) + text;
        let differences = [
            (canonical(&old.spec) != canonical(&new.spec), changed.into()),
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
