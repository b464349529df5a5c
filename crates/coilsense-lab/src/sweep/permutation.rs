//! An order of the numbers below n that is known at any place without holding the others: a million rows need no memory.
//!
//! Next door: the Latin hypercube that needs one per variable (`sampling`).

/// A keyed permutation of 0…n−1.
///
/// A Feistel network of four rounds permutes the numbers of 2b bits, the least such range that holds n; what falls outside of it is
/// permuted again until it does not, which keeps the order one to one.
///
/// Source:   `[Black2002]`: ciphers with arbitrary finite domains, the generalised Feistel and cycle-walking constructions.
/// Valid:    n up to 2⁶²; at most four walks on average, since the range is below 4n.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Permutation {
    count: u64,
    half_bits: u32,
    keys: [u64; ROUNDS],
}

/// Four rounds make a Feistel network of random functions a strong pseudorandom permutation (Luby and Rackoff).
const ROUNDS: usize = 4;

impl Permutation {
    /// Another one for each seed and stream.
    pub fn new(count: u64, seed: u64, stream: u64) -> Self {
        let bits = u64::BITS - count.saturating_sub(1).leading_zeros();
        let key = |round: usize| mixed(mixed(mixed(seed) ^ stream).wrapping_add(round as u64));
        Self { count, half_bits: bits.div_ceil(2).max(1), keys: std::array::from_fn(key) }
    }

    /// The number at a place below n.
    pub fn at(&self, place: u64) -> u64 {
        let mut value = self.rounds(place);
        while value >= self.count {
            value = self.rounds(value);
        }
        value
    }

    fn rounds(&self, value: u64) -> u64 {
        let mask = (1 << self.half_bits) - 1;
        let (mut left, mut right) = (value >> self.half_bits, value & mask);
        for key in self.keys {
            (left, right) = (right, left ^ (mixed(right ^ key) & mask));
        }
        (left << self.half_bits) | right
    }
}

/// Spreads every bit over all others: the finaliser of SplitMix64 (Steele, Lea and Flood 2014).
pub(crate) fn mixed(value: u64) -> u64 {
    let value = value.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let value = (value ^ (value >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let value = (value ^ (value >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    value ^ (value >> 31)
}

#[cfg(test)]
mod tests {
    use super::Permutation;

    #[test]
    fn every_number_stands_at_one_place() {
        for count in [1, 2, 3, 5, 64, 1000, 65_537] {
            let order = Permutation::new(count, 7, 3);
            let mut all: Vec<u64> = (0..count).map(|place| order.at(place)).collect();
            assert!(count < 1000 || !all.is_sorted());
            all.sort_unstable();
            assert_eq!(all, (0..count).collect::<Vec<_>>());
        }
    }
}
