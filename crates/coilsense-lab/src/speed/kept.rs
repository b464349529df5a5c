//! Points of a map on disk: a run that was stopped goes on from there, and several machines make one map.
//!
//! Next door: the map (the parent), a point (`judged`), all of a command's output or none (`crate::output`).

use std::collections::HashMap;
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use sha2::{Digest, Sha256};

use super::{Range, SpeedError, SpeedPoint};
use crate::spec::{CamSpec, Spec};

/// Which share of the points is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Part {
    /// From 1 on.
    pub number: usize,
    /// Of so many.
    pub of: usize,
}

impl Part {
    /// `2/5` is the second of five.
    ///
    /// # Errors
    /// [`SpeedError::Spec`] in a line.
    pub fn parse(text: &str) -> Result<Self, SpeedError> {
        let numbers = text.split_once('/').map(|(number, of)| (number.trim().parse(), of.trim().parse()));
        match numbers {
            Some((Ok(number), Ok(of))) if (1..=of).contains(&number) && of <= MOST_PARTS => Ok(Self { number, of }),
            _ => Err(SpeedError::Spec(format!("part must be K/N with K from 1 to N, such as 2/5, got {text:?}"))),
        }
    }

    /// Whether it holds a job of this number, from zero on. Jobs lie in the order of how long they take: each part has as much of every kind.
    pub(super) fn holds(self, job: usize) -> bool {
        job % self.of == self.number - 1
    }
}

/// Most parts.
const MOST_PARTS: usize = 100_000;
/// Digits of the name of what was asked.
const DIGITS: usize = 16;

/// A folder with points of one map. Each run writes a file of its own; points of another map or version are left alone.
pub(super) struct Kept {
    folder: PathBuf,
    name: String,
    found: HashMap<(u64, usize), SpeedPoint>,
    file: Mutex<Option<File>>,
}

impl Kept {
    /// Points of what these ask; none are read yet.
    pub fn new(folder: &Path, spec: &Spec, cam: &CamSpec, range: &Range) -> Self {
        // What forces follow from as it is now, be it from a file or not: names, words and comments make no other map.
        let Spec { spring, mount, strength, .. } = spec;
        let version = env!("CARGO_PKG_VERSION");
        let asked = format!("{version} {spring:?} {mount:?} {strength:?} {cam:?} {range:?}");
        let name: String = Sha256::digest(asked).iter().map(|byte| format!("{byte:02x}")).collect();
        Self {
            folder: folder.to_owned(),
            name: name[..DIGITS].to_owned(),
            found: HashMap::new(),
            file: Mutex::new(None),
        }
    }

    /// With the points that are there.
    pub fn open(mut self) -> Result<Self, SpeedError> {
        for path in self.files()? {
            let bytes = fs::read(&path).map_err(|error| self.fault(&error))?;
            self.take(&bytes);
        }
        Ok(self)
    }

    /// Its files, of which each run has made one.
    fn files(&self) -> Result<Vec<PathBuf>, SpeedError> {
        let files = match fs::read_dir(&self.folder) {
            Ok(files) => files,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
            Err(error) => return Err(self.fault(&error)),
        };
        let paths = files.map(|file| file.map(|file| file.path())).collect::<Result<Vec<_>, _>>();
        let mut paths = paths.map_err(|error| self.fault(&error))?;
        let own = format!("{}-", self.name);
        paths.retain(|path| path.file_name().is_some_and(|file| file.to_string_lossy().starts_with(&own)));
        Ok(paths)
    }

    /// Removes them, and the folder if nothing else is in it.
    pub fn remove(&self) -> Result<(), SpeedError> {
        for path in self.files()? {
            fs::remove_file(&path).map_err(|error| self.fault(&error))?;
        }
        // What is not empty, or not there, stays as it is.
        let _ = fs::remove_dir(&self.folder);
        Ok(())
    }

    /// Points one after another, up to one that a killed run wrote a part of.
    fn take(&mut self, mut bytes: &[u8]) {
        while let Ok((point, rest)) = postcard::take_from_bytes::<SpeedPoint>(bytes) {
            self.found.insert((point.speed.to_bits(), point.way), point);
            bytes = rest;
        }
    }

    /// The point of a speed and a way, where it is there.
    pub fn find(&self, speed: f64, way: usize) -> Option<&SpeedPoint> {
        self.found.get(&(speed.to_bits(), way))
    }

    /// Writes one down.
    pub fn keep(&self, point: &SpeedPoint) -> Result<(), SpeedError> {
        let bytes = postcard::to_stdvec(point).map_err(|error| self.fault(&error))?;
        let mut file = self.file.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if file.is_none() {
            *file = Some(self.begin().map_err(|error| self.unwritten(&error))?);
        }
        let written = file.as_mut().map_or(Ok(()), |file| file.write_all(&bytes));
        written.map_err(|error| self.unwritten(&error))
    }

    /// A file that no other run has.
    fn begin(&self) -> std::io::Result<File> {
        fs::create_dir_all(&self.folder)?;
        let mut number = 1;
        loop {
            match File::create_new(self.folder.join(format!("{}-{number}.points", self.name))) {
                Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists => number += 1,
                made => return made,
            }
        }
    }

    /// Where it is.
    pub fn place(&self) -> String {
        self.folder.display().to_string()
    }

    fn unwritten(&self, error: &std::io::Error) -> SpeedError {
        self.fault(&format!("cannot be written: {}", crate::system::said(error)))
    }

    fn fault(&self, reason: &dyn std::fmt::Display) -> SpeedError {
        SpeedError::Spec(format!("{}: {reason}", self.folder.display()))
    }
}

/// Why a run ended early, as a number.
pub(super) mod given_up {
    use coilsense::contact::GivenUp;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    const EACH: [Option<GivenUp>; 3] = [None, Some(GivenUp::TooManyEvents), Some(GivenUp::Solid)];

    pub fn serialize<S: Serializer>(value: &Option<GivenUp>, serializer: S) -> Result<S::Ok, S::Error> {
        EACH.iter().position(|each| each == value).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<GivenUp>, D::Error> {
        let number = Option::<usize>::deserialize(deserializer)?;
        let found = number.and_then(|number| EACH.get(number)).copied();
        found.ok_or_else(|| serde::de::Error::custom("no such reason"))
    }
}
