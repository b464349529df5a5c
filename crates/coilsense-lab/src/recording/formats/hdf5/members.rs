//! The numbers among the bytes of a row: one of a plain dataset, those of the fields of a compound one.
//!
//! Next door: where the bytes come from (`datasets`).

use hdf5_pure::{Datatype, DatatypeByteOrder, FloatingPointLayout};

/// A number within a row of bytes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Member {
    /// Name of the field; empty of a plain dataset.
    pub name: String,
    offset: usize,
    size: usize,
    kind: Kind,
    big_endian: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Signed,
    Unsigned,
    Half,
    Float,
    Double,
}

/// Most fields of a compound, with those of the arrays in it.
const MOST: usize = 1000;

impl Member {
    /// The numbers of a row of this type; none of texts, references and the like.
    pub fn all(datatype: &Datatype) -> Vec<Self> {
        let mut all = Vec::new();
        add(datatype, 0, "", &mut all);
        let size = datatype.type_size() as usize;
        all.retain(|member| member.offset.checked_add(member.size).is_some_and(|end| end <= size));
        all
    }

    /// Its number in a row; NaN where the row is too short.
    pub fn number(&self, row: &[u8]) -> f64 {
        let Some(bytes) = row.get(self.offset..self.offset + self.size) else { return f64::NAN };
        let join = |all: u64, byte: &u8| all << 8 | u64::from(*byte);
        let bits = if self.big_endian { bytes.iter().fold(0, join) } else { bytes.iter().rev().fold(0, join) };
        match self.kind {
            Kind::Unsigned => bits as f64,
            Kind::Signed => {
                let free = 64 - 8 * self.size as u32;
                ((bits << free) as i64 >> free) as f64
            }
            Kind::Half => half(bits as u16),
            Kind::Float => f64::from(f32::from_bits(bits as u32)),
            Kind::Double => f64::from_bits(bits),
        }
    }
}

fn add(datatype: &Datatype, offset: usize, name: &str, all: &mut Vec<Member>) {
    if all.len() >= MOST {
        return;
    }
    let order = |order: &DatatypeByteOrder| match order {
        DatatypeByteOrder::LittleEndian => Some(false),
        DatatypeByteOrder::BigEndian => Some(true),
        DatatypeByteOrder::Vax => None,
    };
    let mut push = |size: u32, kind: Kind, big_endian: Option<bool>| {
        let size = size as usize;
        if let Some(big_endian) = big_endian.filter(|_| (1..=8).contains(&size)) {
            all.push(Member { name: name.to_owned(), offset, size, kind, big_endian });
        }
    };
    match datatype {
        Datatype::FixedPoint { size, byte_order, layout }
            if layout.bit_offset == 0 && u32::from(layout.bit_precision) == 8 * size =>
        {
            push(*size, if layout.signed { Kind::Signed } else { Kind::Unsigned }, order(byte_order));
        }
        Datatype::FloatingPoint { size, byte_order, layout } => {
            let kind = match *layout {
                FloatingPointLayout::IEEE754_BINARY64 => Some(Kind::Double),
                FloatingPointLayout::IEEE754_BINARY32 => Some(Kind::Float),
                other => (*size == 2 && other.exponent_size == 5 && other.mantissa_size == 10).then_some(Kind::Half),
            };
            if let Some(kind) = kind {
                push(*size, kind, order(byte_order));
            }
        }
        Datatype::Enumeration { base_type, .. } => add(base_type, offset, name, all),
        Datatype::Compound { members, .. } if name.is_empty() => {
            for member in members {
                let Ok(place) = usize::try_from(member.byte_offset) else { continue };
                add(&member.datatype, offset.saturating_add(place), &member.name, all);
            }
        }
        Datatype::Array { base_type, dimensions } if !name.is_empty() => {
            let count = dimensions.iter().fold(1_usize, |count, size| count.saturating_mul(*size as usize));
            let size = base_type.type_size() as usize;
            for place in 0..count.min(MOST) {
                let offset = offset.saturating_add(place.saturating_mul(size));
                add(base_type, offset, &format!("{name}({})", place + 1), all);
            }
        }
        _ => {}
    }
}

/// The number of sixteen bits.
fn half(bits: u16) -> f64 {
    let (sign, exponent, fraction) = (bits >> 15, bits >> 10 & 0x1f, f64::from(bits & 0x3ff));
    let size = match exponent {
        0 => fraction * 2f64.powi(-24),
        0x1f if fraction == 0.0 => f64::INFINITY,
        0x1f => f64::NAN,
        _ => (1.0 + fraction / 1024.0) * 2f64.powi(i32::from(exponent) - 15),
    };
    if sign == 1 { -size } else { size }
}
