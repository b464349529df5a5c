//! What flows on the surface of magnetised wires: each turn's by the field of all.
//!
//! Next door: the field of thin rings (`field`), the current in the wires (`disc`).

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};

use super::disc::Disc;
use super::field::{Point, field, logarithmic_part};

/// Points on the edge of a turn's wire.
pub(super) const NODES: usize = 24;
/// Half of them.
const HALF: usize = NODES / 2;
/// How finely the edges of the next two turns are cut, and of those after them.
const REFINED: [usize; 2] = [8, 2];
/// How far aside \[rad\] a smooth part is looked at where its own point would be divided by zero.
const ASIDE: f64 = 2e-3;

/// Angle of a point on the edge.
fn angle(node: usize, of: usize) -> f64 {
    TAU * node as f64 / of as f64
}

/// A point on the edge of a turn at zero.
fn on_edge(disc: &Disc, angle: f64) -> Point {
    disc.point(angle.sin_cos(), disc.wire)
}

/// Along the edge, anticlockwise with r to the right and z up.
fn along_edge(angle: f64, [r, z]: [f64; 2]) -> f64 {
    let (sine, cosine) = angle.sin_cos();
    cosine * z - sine * r
}

/// The node that a mirror between both ends shows in place of one.
fn mirrored(node: usize) -> usize {
    (NODES - node) % NODES
}

/// Weights of ∫ ln(4 sin²((t − t_j)/2)) f(t_j) by the distance of nodes: exact for trigonometric polynomials, `[Kress2014]` 12.3.
fn logarithmic_weights() -> [f64; NODES] {
    std::array::from_fn(|node| {
        let angle = angle(node, NODES);
        let waves: f64 = (1..HALF).map(|wave| (wave as f64 * angle).cos() / wave as f64).sum();
        -TAU / HALF as f64 * waves - 0.5 * TAU / (HALF * HALF) as f64 * (HALF as f64 * angle).cos()
    })
}

/// Turns side by side that are all alike: what they do to each other by how many turns they are apart.
pub(super) struct Row(Vec<Felt>);

impl Row {
    pub fn new(disc: &Disc, turns: usize) -> Self {
        let of = |lag: usize| if lag == 0 { Felt::own(disc) } else { Felt::of(disc, lag, lag as f64 * disc.pitch) };
        Self((0..turns).map(of).collect())
    }

    /// ∬ j M j of so many of the turns over μ₀ \[m\].
    pub fn of_currents(&self, turns: usize) -> f64 {
        let of_lag = |lag: usize| if lag == 0 { turns as f64 } else { 2.0 * (turns - lag) as f64 };
        (0..turns).map(|lag| of_lag(lag) * self.0[lag].link).sum()
    }

    /// What the currents of so many turns do at a node of one.
    fn sum(&self, each: impl Fn(&Felt) -> &DVector<f64>, turns: usize, turn: usize, node: usize) -> f64 {
        let of = |other: usize| {
            let values = each(&self.0[other.abs_diff(turn)]);
            if other <= turn { values[node] } else { values[mirrored(node)] }
        };
        (0..turns).map(of).sum()
    }

    /// B(K)/μ₀ along the edges of the first half of the turns, of so many of them, by currents there \[1/m\]; those of the other half are their mirror.
    pub fn felt(&self, turns: usize) -> DMatrix<f64> {
        let half = turns.div_ceil(2);
        let mut matrix = DMatrix::zeros(half * NODES, half * NODES);
        for turn in 0..half {
            for other in 0..turns {
                // Whose unknowns they are: its own, or those of its mirror.
                let (of, is_mirrored) = if other < half { (other, false) } else { (turns - 1 - other, true) };
                let block = &self.0[turn.abs_diff(other)].block;
                for source in 0..NODES {
                    let column = of * NODES + if is_mirrored { mirrored(source) } else { source };
                    for node in 0..NODES {
                        let at = if other <= turn { (node, source) } else { (mirrored(node), mirrored(source)) };
                        matrix[(turn * NODES + node, column)] += block[at];
                    }
                }
            }
        }
        matrix
    }

    /// B(j)/μ₀ along the same edges for one ampere in the wires \[A/m\].
    pub fn field(&self, turns: usize) -> DVector<f64> {
        let half = turns.div_ceil(2);
        DVector::from_fn(half * NODES, |row, _| self.sum(|felt| &felt.field, turns, row / NODES, row % NODES))
    }

    /// What currents there \[A/m\] make of ∬ j M K of the wires' currents with those on all surfaces over μ₀ \[m\].
    pub fn seen(&self, turns: usize) -> DVector<f64> {
        let half = turns.div_ceil(2);
        DVector::from_fn(half * NODES, |row, _| {
            let (turn, node) = (row / NODES, row % NODES);
            // The middle turn of an odd number is its own mirror.
            let times = if 2 * turn + 1 == turns { 1.0 } else { 2.0 };
            times * self.sum(|felt| &felt.seen, turns, turn, node)
        })
    }
}

/// What a turn feels of another: along its edge of a current there and of the other's own, what it sees of the other's own, and how they are linked.
#[derive(Debug, Clone)]
pub(super) struct Felt {
    /// B along the edge over μ₀ by nodes of the other's edge.
    pub block: DMatrix<f64>,
    /// B along the edge over μ₀ of one ampere in the other \[A/m\].
    pub field: DVector<f64>,
    /// What a current along the edge links with that ampere, by nodes.
    pub seen: DVector<f64>,
    /// ∬ j M j over μ₀ \[m\].
    pub link: f64,
}

impl Felt {
    /// Of a turn before it, so many turns back, so far along the axis \[m\].
    pub fn of(disc: &Disc, lag: usize, apart: f64) -> Self {
        let edges = block(disc, lag, apart);
        Self::with(disc, edges, disc.linked_at(lag, apart), NODES, |point| disc.seen_along(point, lag, apart))
    }

    /// Of itself.
    pub fn own(disc: &Disc) -> Self {
        let half =
            Self::with(disc, own_block(disc), disc.own_inductance(), HALF + 1, |point| disc.seen_along(point, 0, 0.0));
        // Its own field is above its plane as below.
        let whole = |values: &DVector<f64>| DVector::from_fn(NODES, |node, _| values[node.min(mirrored(node))]);
        Self { field: whole(&half.field), seen: whole(&half.seen), ..half }
    }

    /// With what its first so many nodes see.
    fn with(
        disc: &Disc,
        block: DMatrix<f64>,
        link: f64,
        nodes: usize,
        seen_at: impl Fn(Point) -> (f64, [f64; 2]),
    ) -> Self {
        let step = disc.wire * TAU / NODES as f64;
        let (mut field, mut seen) = (DVector::zeros(NODES), DVector::zeros(NODES));
        for node in 0..nodes {
            let angle = angle(node, NODES);
            let point = on_edge(disc, angle);
            let (potential, along) = seen_at(point);
            (field[node], seen[node]) = (along_edge(angle, along), step * TAU * point.r * potential);
        }
        Self { block, field, seen, link }
    }

    /// The same of a turn behind it.
    pub fn mirrored(&self) -> Self {
        let of = |values: &DVector<f64>| DVector::from_fn(NODES, |node, _| values[mirrored(node)]);
        let block = DMatrix::from_fn(NODES, NODES, |node, source| self.block[(mirrored(node), mirrored(source))]);
        Self { block, field: of(&self.field), seen: of(&self.seen), link: self.link }
    }

    /// Each times a number.
    pub fn scaled(&self, times: f64) -> Self {
        let (block, field, seen) = (times * &self.block, times * &self.field, times * &self.seen);
        Self { block, field, seen, link: times * self.link }
    }

    /// The sum of two.
    pub fn plus(&self, other: &Self) -> Self {
        let (block, field) = (&self.block + &other.block, &self.field + &other.field);
        Self { block, field, seen: &self.seen + &other.seen, link: self.link + other.link }
    }

    /// The difference of two.
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.scaled(-1.0))
    }
}

/// Of the edge that the nodes themselves are on.
fn own_block(disc: &Disc) -> DMatrix<f64> {
    let weights = logarithmic_weights();
    let by_log = |at: f64, from: f64| along_edge(at, logarithmic_part(on_edge(disc, from), on_edge(disc, at)));
    let smooth = |at: f64, from: f64| {
        let whole = along_edge(at, field(on_edge(disc, from), on_edge(disc, at)));
        whole - by_log(at, from) * (4.0 * (0.5 * (at - from)).sin().powi(2)).ln()
    };
    DMatrix::from_fn(NODES, NODES, |node, source| {
        let [at, from] = [node, source].map(|node| angle(node, NODES));
        let rest = if node == source {
            // From both sides at two distances, of which the first power left out is the fourth.
            let about = |aside: f64| 0.5 * (smooth(at, from + aside) + smooth(at, from - aside));
            (4.0 * about(ASIDE) - about(2.0 * ASIDE)) / 3.0
        } else {
            smooth(at, from)
        };
        disc.wire * (weights[node.abs_diff(source)] * by_log(at, from) + TAU / NODES as f64 * rest)
    })
}

/// Of an edge so many turns before, so far along the axis.
fn block(disc: &Disc, lag: usize, apart: f64) -> DMatrix<f64> {
    let times = match lag {
        1 | 2 => REFINED[0],
        3 | 4 => REFINED[1],
        _ => 1,
    };
    let fine = times * NODES;
    let step = disc.wire * TAU / fine as f64;
    let felt = DMatrix::from_fn(NODES, fine, |node, source| {
        let at = angle(node, NODES);
        let here = on_edge(disc, at).moved(apart);
        step * along_edge(at, field(on_edge(disc, angle(source, fine)), here))
    });
    if times == 1 {
        return felt;
    }
    // Between the nodes by the trigonometric polynomial through them.
    let between = DMatrix::from_fn(fine, NODES, |source, node| {
        let apart = angle(source, fine) - angle(node, NODES);
        let waves: f64 = (1..HALF).map(|wave| 2.0 * (wave as f64 * apart).cos()).sum();
        (1.0 + waves + (HALF as f64 * apart).cos()) / NODES as f64
    });
    felt * between
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_surface_takes_back_what_magnetised_wire_adds() {
        // ∮K = −(μ_r − 1) I: seen from far away a wire carries its own current.
        let disc = Disc::new(8.47e-3, 1.41e-3, 1.3 * 2.82e-3);
        let row = Row::new(&disc, 5);
        for permeability in [1.5, 2.5, 10.0] {
            let twice = 2.0 * (permeability - 1.0) / (permeability + 1.0);
            let matrix = DMatrix::identity(3 * NODES, 3 * NODES) - twice * row.felt(5);
            let currents = matrix.lu().solve(&(twice * permeability * row.field(5))).unwrap();
            for turn in 0..3 {
                let round: f64 = currents.rows(turn * NODES, NODES).sum() * disc.wire * TAU / NODES as f64;
                assert!((round / (1.0 - permeability) - 1.0).abs() < 1e-6, "{turn}: {round} at {permeability}");
            }
            // The middle turn is its own mirror.
            for node in 1..HALF {
                let [one, other] = [node, mirrored(node)].map(|node| currents[2 * NODES + node]);
                assert!((one / other - 1.0).abs() < 1e-9, "{one}, {other}");
            }
        }
    }
}
