//! The static curve of a coil of sections as a table: a force for each of many lengths.
//!
//! Next door: the curve by closed forms (`coil`).

/// Nodes between two forces at which a section begins or ends to close.
const NODES: usize = 192;

/// Forces over compressions, smooth between nodes.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Curve {
    /// Compression \[m\], force \[N\] and dF/dx \[N/m\], ascending; at a knee twice, from its left and from its right.
    nodes: Vec<[f64; 3]>,
}

/// A rate that stands for that of a coil which is all closed, over that of the open one.
const STEEP: f64 = 1e9;

impl Curve {
    /// - `knees`: forces between which it is smooth \[N\]; `solid`: the last of them; `stiffness`: of the open coil \[N/m\]; `compressed`: compression \[m\]
    ///   under a force, and its growth \[m/N\]
    pub(super) fn of(mut knees: Vec<f64>, solid: f64, stiffness: f64, compressed: impl Fn(f64) -> [f64; 2]) -> Self {
        knees.insert(0, 0.0);
        knees.dedup_by(|a, b| (*a - *b).abs() < 1e-12 * solid);
        let mut nodes = Vec::new();
        for pair in knees.windows(2) {
            let (low, high) = (pair[0], pair[1]);
            for node in 0..=NODES {
                // Denser towards both knees, where the curve may bend like a root.
                let share = 0.5 * (1.0 - (std::f64::consts::PI * node as f64 / NODES as f64).cos());
                let force = low + share * (high - low);
                // From within the stretch.
                let inside = force.clamp(low + 1e-13 * (high - low), high - 1e-13 * (high - low));
                let [x, _] = compressed(force);
                let [_, softness] = compressed(inside);
                nodes.push([x, force, (1.0 / softness).min(STEEP * stiffness)]);
            }
        }
        Self { nodes }
    }

    /// The force at a compression \[N\], and its growth \[N/m\]; beyond the solid coil the line goes on at the open coil's `stiffness` \[N/m\].
    pub(super) fn at(&self, compression: f64, stiffness: f64) -> [f64; 2] {
        let Some(&[most, solid, _]) = self.nodes.last() else { return [stiffness * compression, stiffness] };
        if compression <= 0.0 {
            return [stiffness * compression, stiffness];
        }
        if compression >= most {
            return [solid + stiffness * (compression - most), stiffness];
        }
        let next = self.nodes.partition_point(|node| node[0] <= compression);
        let ([x0, f0, d0], [x1, f1, d1]) = (self.nodes[next - 1], self.nodes[next]);
        let width = x1 - x0;
        let s = (compression - x0) / width;
        let (a, b) = (width * d0, width * d1);
        let (second, third) = (3.0 * (f1 - f0) - 2.0 * a - b, 2.0 * (f0 - f1) + a + b);
        let force = f0 + s * (a + s * (second + s * third));
        [force, (a + s * (2.0 * second + 3.0 * s * third)) / width]
    }
}
