//! Turns carried along by a chain of masses that need not be as many.
//!
//! Next door: what the turns do to each other (`pairs`), the coil they make (`maxwell`).

/// Each turn sits on the straight line between two neighbouring nodes of the chain: `turn = (1 − w) left + w right`.
///
/// Nodes are end 1, the masses 1…N, end 2. Uniform nodes carry uniform turns, and whatever is a derivative by the turns becomes one by
/// the nodes through the transposed weights.
pub(super) struct Carry {
    /// Left node and w of each turn; none where the turns are the masses themselves.
    weights: Option<Vec<(usize, f64)>>,
    masses: usize,
}

impl Carry {
    /// - `places`: where the turns sit along the coil, 0 at end 1 and 1 at end 2
    /// - `masses`: N of the chain; `are_masses`: whether the turns are its masses
    pub(super) fn new(places: &[f64], masses: usize, are_masses: bool) -> Self {
        let weights = (!are_masses).then(|| places.iter().map(|&place| weight(place, masses)).collect());
        Self { weights, masses }
    }

    /// Positions of the turns \[m\], those of the masses themselves where they are the same.
    pub(super) fn turns<'a>(&self, ends: [f64; 2], masses: &'a [f64], buffer: &'a mut Vec<f64>) -> &'a [f64] {
        let Some(weights) = &self.weights else { return masses };
        let [u1, u2] = ends;
        let position = |node: usize| match node {
            0 => u1,
            node => masses.get(node - 1).copied().unwrap_or(u2),
        };
        buffer.clear();
        buffer.extend(weights.iter().map(|&(node, weight)| {
            let (left, right) = (position(node), position(node + 1));
            left + (right - left) * weight
        }));
        buffer
    }

    /// How many nodes there are: the masses and both ends.
    pub(super) fn nodes(&self) -> usize {
        self.masses + 2
    }

    /// The two nodes that carry a turn, with their weights.
    pub(super) fn of_turn(&self, turn: usize) -> [(usize, f64); 2] {
        match &self.weights {
            None => [(turn + 1, 1.0), (turn + 2, 0.0)],
            Some(weights) => {
                let (node, weight) = weights[turn];
                [(node, 1.0 - weight), (node + 1, weight)]
            }
        }
    }
}

/// Left node and weight of the right one for a place along the coil.
fn weight(place: f64, masses: usize) -> (usize, f64) {
    // In units of the chain's pitch: end 1 at 0, mass i at i − ½, end 2 at N.
    let along = place * masses as f64;
    let place_of = |node: usize| match node {
        0 => 0.0,
        node if node > masses => masses as f64,
        node => node as f64 - 0.5,
    };
    let node = ((along + 0.5).floor() as usize).min(masses);
    let (from, to) = (place_of(node), place_of(node + 1));
    (node, (along - from) / (to - from))
}
