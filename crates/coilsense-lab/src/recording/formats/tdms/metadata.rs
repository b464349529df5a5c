//! The segments of a file, one after the other: each adds to what the ones before it have told of the channels.
//!
//! Next door: where a channel lies in a chunk (`index`), a segment's chunks (`layout`), reading them (`data`).

use std::collections::HashMap;
use std::rc::Rc;

use super::super::super::error::shortened;
use super::bytes::Bytes;
use super::index::Index;
use super::layout::{Entry, Layout};
use super::properties::Properties;

/// What is known of a file, a group or a channel.
#[derive(Debug, Default)]
pub(super) struct Object {
    pub path: String,
    pub properties: Properties,
    /// The index that it had last.
    index: Option<Rc<Index>>,
}

/// What the segments so far have told.
#[derive(Debug, Default)]
pub(super) struct Metadata {
    pub objects: Vec<Object>,
    places: HashMap<String, usize>,
    list: Vec<Entry>,
    layout: Option<Rc<Layout>>,
    /// Entries of lists that were gone through, over all segments.
    work: usize,
}

/// What a segment says of itself.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contents {
    mask: u32,
}

/// Most objects of a file, and most entries that its segments may repeat.
const MOST_OBJECTS: usize = 100_000;
const MOST_WORK: usize = 200_000_000;
/// Headers of an index that is none.
const AS_BEFORE: u32 = 0;
const NO_DATA: u32 = u32::MAX;

impl Contents {
    pub fn of(mask: u32) -> Self {
        Self { mask }
    }

    pub fn has_metadata(self) -> bool {
        self.mask & 1 << 1 != 0
    }

    fn has_new_list(self) -> bool {
        self.mask & 1 << 2 != 0
    }

    pub fn is_interleaved(self) -> bool {
        self.mask & 1 << 5 != 0
    }

    pub fn is_big_endian(self) -> bool {
        self.mask & 1 << 6 != 0
    }
}

impl Metadata {
    /// How a segment's chunks are laid out, by its metadata and what came before.
    pub fn segment(&mut self, contents: Contents, bytes: &[u8]) -> Result<Rc<Layout>, String> {
        if contents.has_metadata() {
            self.read(contents, &mut Bytes::of(bytes, contents.is_big_endian()))?;
        }
        match &self.layout {
            Some(layout) => Ok(Rc::clone(layout)),
            None => Err("its first segment has no metadata".to_owned()),
        }
    }

    fn read(&mut self, contents: Contents, bytes: &mut Bytes<'_>) -> Result<(), String> {
        if contents.has_new_list() || self.layout.is_none() {
            self.list.clear();
        }
        let count = bytes.word()?;
        if count > 0 || contents.has_new_list() {
            self.layout = None;
        }
        // The list is gone through at most three times: its places, its layout, what was last.
        self.work += 3 * (self.list.len() + count as usize) * usize::from(self.layout.is_none());
        if self.work > MOST_WORK {
            return Err("it repeats its channels too often".to_owned());
        }
        let mut listed: HashMap<usize, usize> = HashMap::new();
        if count > 0 {
            listed = self.list.iter().enumerate().map(|(place, entry)| (entry.object, place)).collect();
        }
        for _ in 0..count {
            let object = self.object(bytes.text()?)?;
            let header = bytes.word()?;
            let place = listed.get(&object).copied();
            let known = match place {
                Some(place) => self.list[place].index.clone(),
                None => self.objects[object].index.clone(),
            };
            let named = |message: String| format!("{}: {message}", shortened(&self.objects[object].path));
            let entry = match header {
                NO_DATA => Entry { object, index: known, has_data: false },
                AS_BEFORE if known.is_none() => {
                    return Err(named("its layout is that of a segment before, and there is none".to_owned()));
                }
                AS_BEFORE => Entry { object, index: known, has_data: true },
                _ => Entry { object, index: Some(Rc::new(Index::read(header, bytes).map_err(named)?)), has_data: true },
            };
            match place {
                Some(place) => self.list[place] = entry,
                None => self.list.push(entry),
            }
            self.objects[object].properties.read(bytes)?;
        }
        if self.layout.is_none() {
            for entry in &self.list {
                self.objects[entry.object].index.clone_from(&entry.index);
            }
            self.layout = Some(Rc::new(Layout::of(&self.list)?));
        }
        Ok(())
    }

    /// The place of the object of a path.
    fn object(&mut self, path: &[u8]) -> Result<usize, String> {
        let path = String::from_utf8_lossy(path);
        if let Some(place) = self.places.get(path.as_ref()) {
            return Ok(*place);
        }
        let place = self.objects.len();
        if place >= MOST_OBJECTS {
            return Err(format!("it has more than {MOST_OBJECTS} channels"));
        }
        self.places.insert(path.clone().into_owned(), place);
        self.objects.push(Object { path: path.into_owned(), ..Object::default() });
        Ok(place)
    }

    /// The properties of the object of a path.
    pub fn properties(&self, path: &str) -> Option<&Properties> {
        self.places.get(path).map(|place| &self.objects[*place].properties)
    }
}
