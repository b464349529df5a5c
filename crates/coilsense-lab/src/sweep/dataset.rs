//! A sweep on disk: a folder with a manifest and one Parquet file a chunk. What exists under its final name is whole; a run that was killed
//! is continued, and leaves the same files as one that was not.
//!
//! Next door: the manifest (`manifest`), a chunk's bytes (`encoded`).

use std::collections::BTreeMap;
use std::fs::{self, File, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{PoisonError, RwLock};

use super::SweepError;
use super::chunk::Data;
use super::encoded;
use super::manifest::{self, Manifest};
use super::plan::Plan;

/// Held while a run writes; the system lets go of it with the process, however that ends. Readers pass over names that begin so.
const LOCK: &str = "_lock";

/// Files in the making begin so.
const UNFINISHED: &str = ".unfinished-";

/// A folder of chunks.
#[derive(Debug)]
pub struct Dataset {
    folder: PathBuf,
    plan: Plan,
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
    /// Begins a folder, or goes on with one of the same plan; one writer at a time.
    ///
    /// # Errors
    /// [`SweepError`] where the folder cannot be written, is held by another run, or holds another sweep: then it says what differs.
    pub fn create_or_open(folder: &Path, plan: &Plan) -> Result<Self, SweepError> {
        let wanted = Manifest::of(plan)?;
        fs::create_dir_all(folder).map_err(|error| unwritable(folder, &error))?;
        let lock = lock(folder)?;
        let path = folder.join(manifest::NAME);
        let dataset = Self { folder: folder.to_owned(), plan: plan.clone(), lock: RwLock::new(Some(lock)) };
        dataset.remove_unfinished()?;
        match fs::read_to_string(&path) {
            Ok(text) => {
                let found = Manifest::from_json(&text).map_err(|message| SweepError::of(&shown(&path), message))?;
                found.check(&wanted).map_err(|message| SweepError::of(&shown(folder), message))?;
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                dataset.check_empty()?;
                dataset.put(manifest::NAME, wanted.to_json().as_bytes())?;
            }
            Err(error) => return Err(SweepError::new(format!("{}: cannot be read: {error}", path.display()))),
        }
        Ok(dataset)
    }

    /// Opens a folder to read from it; a run may be writing to it.
    ///
    /// # Errors
    /// [`SweepError`] where it holds no sweep.
    pub fn open(folder: &Path) -> Result<Self, SweepError> {
        let path = folder.join(manifest::NAME);
        let text = fs::read_to_string(&path);
        let text = text.map_err(|error| SweepError::new(format!("{}: holds no sweep: {error}", path.display())))?;
        let manifest = Manifest::from_json(&text).map_err(|message| SweepError::of(&shown(&path), message))?;
        Ok(Self { folder: folder.to_owned(), plan: Plan::new(manifest.plan)?, lock: RwLock::new(None) })
    }

    /// What its rows were made by.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Numbers of the chunks that are not there yet, in order.
    pub fn missing(&self) -> Vec<u64> {
        (0..self.plan.chunks()).filter(|chunk| !self.path(*chunk).is_file()).collect()
    }

    /// Where a chunk's file is, or will be.
    pub fn path(&self, chunk: u64) -> PathBuf {
        self.folder.join(name(chunk))
    }

    /// Writes a chunk's bytes (see [`Plan::chunk_bytes`]) under another name, lets them come to rest, and gives them their name.
    ///
    /// # Errors
    /// [`SweepError`] where that fails; nothing is left of the chunk then. A folder that was opened to be read is not written to.
    pub fn write(&self, chunk: u64, bytes: &[u8]) -> Result<(), SweepError> {
        let lock = self.lock.read().unwrap_or_else(PoisonError::into_inner);
        if lock.is_none() {
            return Err(SweepError::of(&shown(&self.folder), "was opened to be read"));
        }
        self.put(&name(chunk), bytes)
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

    /// Shows some columns of each chunk that is there, one chunk in memory at a time.
    pub(crate) fn for_each_chunk(&self, titles: &[&str], mut visit: impl FnMut(Vec<Data>)) -> Result<(), SweepError> {
        for chunk in 0..self.plan.chunks() {
            let path = self.path(chunk);
            if !path.is_file() {
                continue;
            }
            let columns = encoded::read(&path, titles)?.into_iter().zip(titles);
            let there = columns.map(|(data, title)| {
                data.ok_or_else(|| SweepError::new(format!("{}: has no column {title:?}", path.display())))
            });
            visit(there.collect::<Result<_, _>>()?);
        }
        Ok(())
    }

    /// Writes a file under another name, waits until it rests on the disk, and renames it.
    fn put(&self, name: &str, bytes: &[u8]) -> Result<(), SweepError> {
        let (unfinished, path) = (self.folder.join(format!("{UNFINISHED}{name}")), self.folder.join(name));
        let write = || -> io::Result<()> {
            let mut file = File::create(&unfinished)?;
            file.write_all(bytes)?;
            file.sync_all()?;
            fs::rename(&unfinished, &path)?;
            rest(&self.folder)
        };
        write().map_err(|error| {
            // Nothing better can be done where that fails, too: the next run removes it.
            let _ = fs::remove_file(&unfinished);
            unwritable(&path, &error)
        })
    }

    /// Removes what killed runs left.
    fn remove_unfinished(&self) -> Result<(), SweepError> {
        let unreadable =
            |error: io::Error| SweepError::new(format!("{}: cannot be read: {error}", self.folder.display()));
        for entry in fs::read_dir(&self.folder).map_err(unreadable)? {
            let path = entry.map_err(unreadable)?.path();
            let name = path.file_name().and_then(std::ffi::OsStr::to_str);
            if name.is_some_and(|name| name.starts_with(UNFINISHED)) {
                fs::remove_file(&path).map_err(|error| unwritable(&path, &error))?;
            }
        }
        Ok(())
    }

    /// A folder without a manifest holds no chunks, which would be of some other sweep.
    fn check_empty(&self) -> Result<(), SweepError> {
        match self.missing().len() as u64 == self.plan.chunks() {
            true => Ok(()),
            false => Err(SweepError::of(
                &shown(&self.folder),
                format!("has chunks but no {}: of what sweep, cannot be told; take another folder", manifest::NAME),
            )),
        }
    }
}

/// Lets a folder's names come to rest, where the system can.
fn rest(folder: &Path) -> io::Result<()> {
    if cfg!(unix) { File::open(folder)?.sync_all() } else { Ok(()) }
}

fn lock(folder: &Path) -> Result<File, SweepError> {
    let path = folder.join(LOCK);
    let file = File::options().create(true).truncate(false).write(true).open(&path);
    let file = file.map_err(|error| unwritable(&path, &error))?;
    match file.try_lock() {
        Ok(()) => Ok(file),
        Err(TryLockError::WouldBlock) => Err(SweepError::of(
            &shown(folder),
            "another run is writing to it; wait for its end, or take another folder",
        )),
        Err(TryLockError::Error(error)) => {
            Err(SweepError::new(format!("{}: cannot be locked: {error}", path.display())))
        }
    }
}

fn name(chunk: u64) -> String {
    format!("chunk-{chunk:06}.parquet")
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}

fn unwritable(path: &Path, error: &io::Error) -> SweepError {
    SweepError::new(format!("{}: cannot be written: {}", path.display(), error.kind()))
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
