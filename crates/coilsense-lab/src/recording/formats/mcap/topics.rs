//! The numbers of each topic's messages: one column for each field.
//!
//! Next door: the records that bring messages (`records`), numbers in a text (`json`).

use std::collections::HashMap;
use std::path::Path;

use super::super::super::error::shortened;
use super::super::super::order::MOST_NUMBERS;
use super::super::super::title::Title;
use super::super::apart::Apart;
use super::super::grouped::{Group, titled};
use super::json::numbers;

/// A topic with its messages.
#[derive(Debug, Default)]
struct Topic {
    name: String,
    encoding: String,
    times: Vec<u64>,
    fields: Vec<(String, Vec<f64>)>,
    places: HashMap<String, usize>,
}

/// All topics of a file.
#[derive(Debug, Default)]
pub(super) struct Topics {
    all: Vec<Topic>,
    /// Topics by the numbers of their channels.
    channels: HashMap<u16, usize>,
    /// Topics by name and encoding.
    named: HashMap<(String, String), usize>,
    numbers: usize,
}

/// Most fields of a topic.
const MOST_FIELDS: usize = 1000;

impl Topics {
    /// A channel; several of one topic and encoding are one.
    pub fn add(&mut self, number: u16, name: &str, encoding: &str) -> Result<(), String> {
        let key = (name.to_owned(), encoding.to_owned());
        let place = *self.named.entry(key).or_insert_with_key(|(name, encoding)| {
            self.all.push(Topic { name: name.clone(), encoding: encoding.clone(), ..Topic::default() });
            self.all.len() - 1
        });
        match self.channels.insert(number, place) {
            Some(before) if before != place => Err(format!("its channel {number} is two")),
            _ => Ok(()),
        }
    }

    /// A message; of another encoding than JSON it is only counted.
    pub fn message(&mut self, channel: u16, time: u64, data: &[u8]) -> Result<(), String> {
        let place = *self
            .channels
            .get(&channel)
            .ok_or_else(|| format!("a message is of channel {channel}, which is not told"))?;
        let topic = &mut self.all[place];
        topic.times.push(time);
        if topic.encoding != "json" {
            return Ok(());
        }
        let before = topic.fields.len();
        if numbers(data, &mut |name, number| topic.put(name, number)).is_none() {
            return Err(format!("{}: message {} is no JSON", shortened(&topic.name), topic.times.len()));
        }
        // A field that is new has no number in all messages before.
        let new = (topic.fields.len() - before).saturating_mul(topic.times.len());
        self.numbers = self.numbers.saturating_add(new + topic.fields.len() + 1);
        if self.numbers > MOST_NUMBERS {
            return Err("it is too large to be held in memory".to_owned());
        }
        Ok(())
    }

    /// What to do where there are messages, but none of JSON.
    pub fn advice(&self, file: &Path) -> Option<String> {
        if self.all.iter().any(|topic| topic.encoding == "json" && !topic.times.is_empty()) {
            return None;
        }
        let topic = self.all.iter().find(|topic| !topic.times.is_empty())?;
        let (import, messages) = match topic.encoding.as_str() {
            "protobuf" => (
                "from mcap_protobuf.reader import read_protobuf_messages as read; \
                 from google.protobuf.json_format import MessageToDict as fields",
                "fields(m.proto_msg, preserving_proto_field_name=True, always_print_fields_with_no_presence=True)",
            ),
            "cdr" => (
                "from mcap_ros2.reader import read_ros2_messages as read; \
                 fields = lambda m: {k: fields(getattr(m, k)) for k in m.__slots__} if hasattr(m, \"__slots__\") else m",
                "fields(m.ros_msg)",
            ),
            other => {
                let (name, encoding) = (shortened(&topic.name), shortened(other));
                return Some(format!(
                    "holds messages in {encoding} (topic {name}), which is not read; save them as JSON or CSV"
                ));
            }
        };
        let plain = |text: String, other: &str| {
            if text.contains(['"', '\'', '\\']) { other.to_owned() } else { text }
        };
        let (file, name) = (plain(file.display().to_string(), "FILE"), plain(shortened(&topic.name), "TOPIC"));
        Some(format!(
            "holds messages in {}, which is not read; write them as CSV: python -c 'import pandas; {import}; \
             f = pandas.json_normalize([{{\"ns\": m.log_time_ns, **{messages}}} for m in read(\"{file}\", \
             topics=[\"{name}\"])]); n = f.pop(\"ns\"); f.insert(0, \"time [s]\", (n - n[0]) / 1e9); \
             f.to_csv(\"log.csv\", index=False)'",
            topic.encoding
        ))
    }

    /// Topics of numbers, each on its clock from the first message of them on.
    pub fn groups(self) -> (Vec<Group>, Apart) {
        let mut apart = Apart::default();
        let first = self.all.iter().filter_map(|topic| topic.times.iter().min()).min().copied().unwrap_or(0);
        let mut often: HashMap<String, usize> = HashMap::new();
        for (name, _) in self.all.iter().flat_map(|topic| &topic.fields) {
            *often.entry(name.clone()).or_default() += 1;
        }
        let mut groups = Vec::new();
        for topic in self.all.into_iter().filter(|topic| !topic.times.is_empty()) {
            if topic.fields.is_empty() {
                let why = if topic.encoding == "json" { "no numbers" } else { &topic.encoding };
                apart.leave(&topic.name, why);
                continue;
            }
            let rows = topic.times.len();
            let columns = topic.fields.into_iter().map(|(name, mut values)| {
                values.resize(rows, f64::NAN);
                let full = if often[&name] > 1 { format!("{}.{name}", topic.name) } else { name };
                (Title::parse(&full), values)
            });
            let times = topic.times.iter().map(|time| (time - first) as f64 / 1e9).collect();
            groups.push(Group { clock: titled("time", "s"), times, columns: columns.collect() });
        }
        (groups, apart)
    }
}

impl Topic {
    /// A number of the last message.
    fn put(&mut self, name: &str, number: f64) {
        let place = match self.places.get(name) {
            Some(place) => *place,
            None if name.is_empty() || self.fields.len() >= MOST_FIELDS => return,
            None => {
                self.places.insert(name.to_owned(), self.fields.len());
                self.fields.push((name.to_owned(), Vec::new()));
                self.fields.len() - 1
            }
        };
        let values = &mut self.fields[place].1;
        values.resize(self.times.len() - 1, f64::NAN);
        values.push(number);
    }
}
