//! A sweep on disk: a folder with a manifest and one Parquet file a chunk. What exists under its final name was whole when it came there; a run
//! that was killed is continued, and leaves the same files as one that was not. What is not as it was written is never read as rows.
//!
//! Next door: the folder's names (`folder`), the manifest (`manifest`), a chunk's bytes (`encoded`), what they say of themselves (`seal`).

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError, RwLock};

use super::SweepError;
use super::chunk::Data;
use super::encoded;
use super::folder::{chunks_in, locked, name, put, remove_unfinished, shown, unwritable};
use super::manifest::{self, Manifest};
use super::plan::Plan;

/// A folder of chunks.
#[derive(Debug)]
pub struct Dataset {
    folder: PathBuf,
    /// As the folder's manifest has it, whatever another plan of the same sweep calls its spec.
    plan: Plan,
    /// Of the plan, as chunks bear it.
    digest: String,
    /// Chunks that are there and not as they were written, and how that shows.
    damaged: Mutex<BTreeMap<u64, String>>,
    /// `None` where it is only read; held as a reader by what writes, so that it is let go of between files.
    lock: RwLock<Option<File>>,
}

/// How the rows of a dataset went.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Tally {
    /// Rows that are there.
    pub rows: u64,
    /// Of them, those that were judged and are free of clashes.
    pub ok: u64,
    /// Those in which windings would touch.
    pub clash: u64,
    /// Those that could not be judged.
    pub refused: u64,
    /// Reasons, those alike but for their numbers counted together and shown by the first of them, the commonest first.
    pub reasons: Vec<(u64, String)>,
}

impl Dataset {
    /// Begins a folder, or goes on with one of the same sweep; one writer at a time. Every chunk that is there is looked through: one that is not
    /// as it was written is among [`Self::damaged`] and [`Self::missing`], to be made anew.
    ///
    /// # Errors
    /// [`SweepError`] where the folder cannot be written, is held by another run, holds another sweep, of which it says what differs, or has a
    /// manifest that was changed.
    pub fn create_or_open(folder: &Path, plan: &Plan) -> Result<Self, SweepError> {
        let wanted = Manifest::of(plan)?;
        fs::create_dir_all(folder).map_err(|error| unwritable(folder, &error))?;
        let lock = locked(folder)?;
        remove_unfinished(folder)?;
        let path = folder.join(manifest::NAME);
        let found = match fs::read_to_string(&path) {
            Ok(text) => {
                let found = Manifest::from_json(&text).map_err(|message| SweepError::of(&shown(&path), message))?;
                found.check(&wanted).map_err(|message| SweepError::of(&shown(folder), message))?;
                found
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                check_empty(folder)?;
                put(folder, manifest::NAME, wanted.to_json().as_bytes())?;
                wanted
            }
            Err(error) => return Err(unreadable_manifest(&path, &error)),
        };
        let dataset = Self::of(folder, &found, Some(lock))?;
        dataset.look_through()?;
        Ok(dataset)
    }

    /// Opens a folder to read from it; a run may be writing to it.
    ///
    /// # Errors
    /// [`SweepError`] where it holds no sweep, or a manifest that was changed.
    pub fn open(folder: &Path) -> Result<Self, SweepError> {
        let path = folder.join(manifest::NAME);
        let text = fs::read_to_string(&path).map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => SweepError::new(format!("{}: holds no sweep: {error}", path.display())),
            _ => unreadable_manifest(&path, &error),
        })?;
        let manifest = Manifest::from_json(&text).map_err(|message| SweepError::of(&shown(&path), message))?;
        Self::of(folder, &manifest, None)
    }

    fn of(folder: &Path, manifest: &Manifest, lock: Option<File>) -> Result<Self, SweepError> {
        let plan = manifest.plan().map_err(|error| SweepError::of(&shown(&folder.join(manifest::NAME)), error))?;
        let digest = manifest.digest.clone();
        Ok(Self { folder: folder.to_owned(), plan, digest, damaged: Mutex::default(), lock: RwLock::new(lock) })
    }

    /// What its rows were made by.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Numbers of the chunks that are not there yet, or are to be made anew, in order.
    ///
    /// # Errors
    /// [`SweepError`] for a folder that cannot be read.
    pub fn missing(&self) -> Result<Vec<u64>, SweepError> {
        let (there, damaged) = (self.there()?, self.damaged.lock().unwrap_or_else(PoisonError::into_inner));
        let whole = |chunk: &u64| there.binary_search(chunk).is_ok() && !damaged.contains_key(chunk);
        Ok((0..self.plan.chunks()).filter(|chunk| !whole(chunk)).collect())
    }

    /// Chunks that were there when the folder was opened to be written and were not as they had been written, and how that shows; one that is
    /// written leaves them.
    pub fn damaged(&self) -> Vec<(u64, String)> {
        let damaged = self.damaged.lock().unwrap_or_else(PoisonError::into_inner);
        damaged.iter().map(|(chunk, why)| (*chunk, why.clone())).collect()
    }

    /// Where a chunk's file is, or will be.
    pub fn path(&self, chunk: u64) -> PathBuf {
        self.folder.join(name(chunk))
    }

    /// Writes a chunk's bytes (see [`Plan::chunk_bytes`]) under another name, lets them come to rest, and gives them their name.
    ///
    /// # Errors
    /// [`SweepError`] where that fails, and for bytes that are not those of this chunk; nothing is left of the chunk then. A folder that was opened
    /// to be read is not written to.
    pub fn write(&self, chunk: u64, bytes: &[u8]) -> Result<(), SweepError> {
        let lock = self.lock.read().unwrap_or_else(PoisonError::into_inner);
        if lock.is_none() {
            return Err(SweepError::of(&shown(&self.folder), "was opened to be read"));
        }
        let path = self.path(chunk);
        let seal = self.plan.seal(chunk, self.digest.clone());
        encoded::check(&path, bytes.to_vec(), &seal)
            .map_err(|why| SweepError::of(&shown(&path), format!("what is to be written there {why}")))?;
        put(&self.folder, &name(chunk), bytes)?;
        self.damaged.lock().unwrap_or_else(PoisonError::into_inner).remove(&chunk);
        Ok(())
    }

    /// Lets go of the folder, so that another run may write to it; from here on it is only read. A file that is being written is waited for.
    pub fn release(&self) {
        self.lock.write().unwrap_or_else(PoisonError::into_inner).take();
    }

    /// Some columns of all chunks that are there, in the order of rows, by their titles.
    ///
    /// # Errors
    /// [`SweepError`] for a file that cannot be read or a title that is not there.
    pub fn read(&self, titles: &[&str]) -> Result<Vec<Data>, SweepError> {
        let mut columns: Vec<Option<Data>> = vec![None; titles.len()];
        self.for_each_chunk(titles, |read| {
            for (column, data) in columns.iter_mut().zip(read) {
                match column {
                    Some(column) => column.append(data),
                    None => *column = Some(data),
                }
            }
        })?;
        let none = || SweepError::of(&shown(&self.folder), "holds no chunk yet");
        columns.into_iter().map(|column| column.ok_or_else(none)).collect()
    }

    /// How the rows that are there went.
    ///
    /// # Errors
    /// [`SweepError`] for a file that cannot be read.
    pub fn tally(&self) -> Result<Tally, SweepError> {
        let mut tally = Tally::default();
        let mut reasons: BTreeMap<String, (u64, String)> = BTreeMap::new();
        self.for_each_chunk(&["status", "reason"], |columns| {
            let [Data::Texts(statuses), Data::Texts(texts)] = columns.as_slice() else { return };
            for (status, reason) in statuses.iter().zip(texts) {
                tally.rows += 1;
                match status.as_str() {
                    "ok" => tally.ok += 1,
                    "clash" => tally.clash += 1,
                    _ => tally.refused += 1,
                }
                if !reason.is_empty() {
                    reasons.entry(alike(reason)).or_insert_with(|| (0, reason.clone())).0 += 1;
                }
            }
        })?;
        tally.reasons = reasons.into_values().collect();
        tally.reasons.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
        Ok(tally)
    }

    /// That none of some files lies in the sweep's folder, or in one below it: readers of Parquet folders take every file in it for rows, but those
    /// below names that begin with `_` or `.`.
    ///
    /// # Errors
    /// [`SweepError`] that names the first of them.
    pub(crate) fn check_apart(&self, files: &[PathBuf]) -> Result<(), SweepError> {
        files.iter().try_for_each(|file| Self::check_outside(&self.folder, file))
    }

    /// That a file, which need not be there yet, does not lie in the folder of a sweep, which need not be there either, nor in one below it: readers of
    /// Parquet folders take every file in it for rows, but those below names that begin with `_` or `.`.
    ///
    /// # Errors
    /// [`SweepError`] where it does.
    pub fn check_outside(folder: &Path, file: &Path) -> Result<(), SweepError> {
        if !spoils(folder, file) {
            return Ok(());
        }
        Err(SweepError::new(format!(
            "{}: lies in the sweep's folder, where readers of Parquet take it for rows; write to another folder, or to {}",
            file.display(),
            folder.join("_asked").display()
        )))
    }

    /// Shows some columns of each chunk that is there, one chunk in memory at a time.
    pub(crate) fn for_each_chunk(&self, titles: &[&str], mut visit: impl FnMut(Vec<Data>)) -> Result<(), SweepError> {
        for chunk in self.there()? {
            visit(self.columns_of(chunk, titles)?);
        }
        Ok(())
    }

    /// Some columns of a chunk, which is as it was written.
    pub(super) fn columns_of(&self, chunk: u64, titles: &[&str]) -> Result<Vec<Data>, SweepError> {
        let path = self.path(chunk);
        let unlike = |why: String| {
            let mended = "sweep with the same options on the same folder makes it anew";
            SweepError::of(&shown(&path), format!("{why}; {mended}"))
        };
        let seal = self.plan.seal(chunk, self.digest.clone());
        crate::input::note(&path);
        let bytes = fs::read(&path).map_err(|error| unlike(format!("cannot be read: {error}")))?;
        let columns = encoded::read(&path, bytes, &seal, titles).map_err(unlike)?.into_iter().zip(titles);
        let there = columns
            .map(|(data, title)| data.ok_or_else(|| SweepError::of(&shown(&path), format!("has no column {title:?}"))));
        there.collect()
    }

    /// Numbers of the chunks of the plan that are there, in order.
    pub(super) fn there(&self) -> Result<Vec<u64>, SweepError> {
        let mut there = chunks_in(&self.folder)?;
        there.retain(|chunk| *chunk < self.plan.chunks());
        Ok(there)
    }

    /// Finds the chunks that are there and not as they were written.
    fn look_through(&self) -> Result<(), SweepError> {
        let mut damaged = BTreeMap::new();
        for chunk in self.there()? {
            let path = self.path(chunk);
            let seal = self.plan.seal(chunk, self.digest.clone());
            let read = fs::read(&path).map_err(|error| format!("cannot be read: {error}"));
            if let Err(why) = read.and_then(|bytes| encoded::check(&path, bytes, &seal)) {
                damaged.insert(chunk, why);
            }
        }
        *self.damaged.lock().unwrap_or_else(PoisonError::into_inner) = damaged;
        Ok(())
    }
}

/// Whether a file, which need not be there yet, is in a folder under names that its readers see.
fn spoils(folder: &Path, file: &Path) -> bool {
    let (Some(folder), Some(file)) = (resolved(folder), resolved(file)) else { return false };
    let seen = |part: &std::ffi::OsStr| !part.to_string_lossy().starts_with(['_', '.']);
    file.strip_prefix(folder).is_ok_and(|below| below.iter().all(seen))
}

/// Where a path leads that need not be there yet: of the folders above it, the last that is there says so.
fn resolved(path: &Path) -> Option<PathBuf> {
    let path = std::path::absolute(path).ok()?;
    let (above, place) = path.ancestors().find_map(|above| Some((above, fs::canonicalize(above).ok()?)))?;
    Some(place.join(path.strip_prefix(above).unwrap_or(&path)))
}

/// A folder without a manifest holds no chunks, which would be of some other sweep.
fn check_empty(folder: &Path) -> Result<(), SweepError> {
    match chunks_in(folder)?.is_empty() {
        true => Ok(()),
        false => Err(SweepError::of(
            &shown(folder),
            format!("has chunks but no {}: of what sweep, cannot be told; take another folder", manifest::NAME),
        )),
    }
}

fn unreadable_manifest(path: &Path, error: &io::Error) -> SweepError {
    SweepError::new(format!("{}: cannot be read: {error}", path.display()))
}

/// A reason without its numbers: those of a million rows fall into few kinds.
fn alike(reason: &str) -> String {
    let mut text = String::with_capacity(reason.len());
    for c in reason.chars() {
        let c = if c.is_ascii_digit() { '0' } else { c };
        if !(c == '0' && text.ends_with(['0', '.'])) {
            text.push(c);
        }
    }
    text
}
