//! The records of a block of data, and the raw numbers in them.
//!
//! Next door: which channels they have (`blocks`).

use super::blocks::{Channel, Channels, Data, Kind};

/// How many records of each group there are.
pub(super) struct Rows {
    pub counts: Vec<usize>,
    /// Whether the file ends before all that were told.
    pub cut: bool,
}

impl Data {
    /// How many records each group has.
    pub fn rows(&self, bytes: &[u8]) -> Rows {
        let mut counts = vec![0; self.groups.len()];
        let told: usize = self.groups.iter().map(|group| group.count).fold(0, usize::saturating_add);
        let walked = self.walk(bytes, |group, _| counts[group] += 1).unwrap_or(false);
        let found: usize = counts.iter().sum();
        Rows { cut: !walked && found < told, counts }
    }

    /// The raw numbers of each group's channels.
    pub fn read(&self, bytes: &[u8]) -> Result<Vec<Vec<Vec<f64>>>, String> {
        let empty = |group: &Channels| vec![Vec::new(); group.channels.len()];
        let mut all: Vec<Vec<Vec<f64>>> = self.groups.iter().map(empty).collect();
        self.walk(bytes, |place, record| {
            for (channel, values) in self.groups[place].channels.iter().zip(&mut all[place]) {
                values.push(if channel.is_number { channel.number(record) } else { f64::NAN });
            }
        })?;
        Ok(all)
    }

    /// Hands out records and the places of their groups; whether all that were told are there.
    fn walk(&self, bytes: &[u8], mut record: impl FnMut(usize, &[u8])) -> Result<bool, String> {
        let mut rest = bytes.get(self.place..).unwrap_or_default();
        let mut left: Vec<usize> =
            self.groups.iter().map(|group| if group.size > 0 { group.count } else { 0 }).collect();
        let mut all: usize = left.iter().copied().fold(0, usize::saturating_add);
        let mut named = [None; 256];
        for (place, group) in self.groups.iter().enumerate().filter(|(_, group)| group.size > 0).rev() {
            if let Some(named) = named.get_mut(usize::from(group.record)) {
                *named = Some(place);
            }
        }
        let mut place = 0;
        while all > 0 {
            if self.numbered[0] {
                let Some((number, behind)) = rest.split_first() else { return Ok(false) };
                rest = behind;
                place = named[usize::from(*number)].ok_or("a record is of no group")?;
            } else {
                while left[place] == 0 {
                    place += 1;
                }
            }
            let Some((own, behind)) = rest.split_at_checked(self.groups[place].size) else { return Ok(false) };
            rest = if self.numbered[1] { behind.get(1..).unwrap_or_default() } else { behind };
            if let Some(less) = left[place].checked_sub(1) {
                left[place] = less;
                all -= 1;
                record(place, own);
            }
        }
        Ok(true)
    }
}

impl Channel {
    /// Its number in a record.
    fn number(&self, record: &[u8]) -> f64 {
        let count = (self.bit + self.bits).div_ceil(8) as usize;
        let Some(bytes) = record.get(self.byte..self.byte + count) else { return f64::NAN };
        let join = |all: u128, byte: &u8| all << 8 | u128::from(*byte);
        let all = if self.big_endian { bytes.iter().fold(0, join) } else { bytes.iter().rev().fold(0, join) };
        let bits = (all >> self.bit & (u128::MAX >> (128 - self.bits))) as u64;
        match self.kind {
            Kind::Unsigned => bits as f64,
            Kind::Signed => ((bits << (64 - self.bits)) as i64 >> (64 - self.bits)) as f64,
            Kind::Float if self.bits == 32 => f64::from(f32::from_bits(bits as u32)),
            Kind::Float => f64::from_bits(bits),
        }
    }
}
