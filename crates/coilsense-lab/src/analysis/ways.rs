//! Ways in which a mounted spring's frequencies move when its stiffness and its mass do, each with a coordinate of its own.
//!
//! With a prescribed position or force at end 2 all move together, ∝ √(k/m). With an end mass the first, the swing of the mass, moves by
//! itself: one way along which only it moves, and one along which it alone stays; where all springs lie on a line, that line.
//!
//! Next door: what is found along them (`response`), the springs (`specimen`).

use coilsense::modes::ModalModel;
use coilsense::{Error, FarEnd, Spring, SpringParameters};

use super::specimen::{Change, Specimens};

/// A way in which frequencies move.
#[derive(Debug, Clone)]
pub(super) struct Way {
    /// Change per unit of the coordinate, at the spec's own spring.
    along: Change,
    coordinate: Coordinate,
}

/// What counts as far on a way.
#[derive(Debug, Clone)]
enum Coordinate {
    /// All frequencies together: ln of their factor.
    Together,
    /// As far as a change goes along it: its product with this.
    Straight(Change),
    /// ln of a mode's frequency over the nominal one, to second order in the change: slope, and ½ f″ of both and of their product.
    Frequency { mode: usize, slope: Change, bend: [f64; 3], nominal: f64 },
}

/// Changes by which derivatives are found: about as far as tolerances reach.
const STEP: f64 = 0.03;
/// Springs whose changes lie this close to a line, as a share of the largest, are on it.
const ON_A_LINE: f64 = 1e-9;

/// The ways on which `specimens` of a spring move.
pub(super) fn ways(spring: &Spring, far_end: FarEnd, specimens: &Specimens) -> Vec<Way> {
    let all_together = || vec![Way { along: [0.0, 1.0], coordinate: Coordinate::Together }];
    let FarEnd::Mass(_) = far_end else { return all_together() };
    if let Some(line) = line_of(specimens) {
        return vec![Way { along: line, coordinate: Coordinate::Straight(line) }];
    }
    by_mode(spring, far_end).unwrap_or_else(all_together)
}

/// The direction on which all springs differ from the spec's own, of length one.
fn line_of(specimens: &Specimens) -> Option<Change> {
    let size = |change: &Change| change[0].hypot(change[1]);
    let changes = specimens.each.iter().map(|specimen| specimen.change);
    let largest = changes.clone().max_by(|a, b| size(a).total_cmp(&size(b)))?;
    let length = size(&largest);
    if length == 0.0 {
        return Some([0.0, 1.0]);
    }
    let line = largest.map(|part| part / length);
    let off = |change: Change| (change[0] * line[1] - change[1] * line[0]).abs();
    changes.map(off).all(|off| off <= ON_A_LINE * length).then_some(line)
}

/// A way for the swing of the mass, and one for all other modes.
fn by_mode(spring: &Spring, far_end: FarEnd) -> Option<Vec<Way>> {
    let first_two = |change: Change| -> Option<[f64; 2]> {
        let frequencies = frequencies(spring, far_end, change)?;
        Some([frequencies.first()?.ln(), frequencies.get(1)?.ln()])
    };
    let middle = first_two([0.0; 2])?;
    let [right, left, up, down] = [[STEP, 0.0], [-STEP, 0.0], [0.0, STEP], [0.0, -STEP]].map(first_two);
    let (right, left, up, down) = (right?, left?, up?, down?);
    let [a, b, c, d] = [[STEP, STEP], [STEP, -STEP], [-STEP, STEP], [-STEP, -STEP]].map(first_two);
    let (a, b, c, d) = (a?, b?, c?, d?);
    let slope = |mode: usize| [right[mode] - left[mode], up[mode] - down[mode]].map(|rise| rise / (2.0 * STEP));
    let square = STEP * STEP;
    let coordinate = |mode: usize| Coordinate::Frequency {
        mode,
        slope: slope(mode),
        bend: [
            0.5 * (right[mode] - 2.0 * middle[mode] + left[mode]) / square,
            0.5 * (up[mode] - 2.0 * middle[mode] + down[mode]) / square,
            (a[mode] - b[mode] - c[mode] + d[mode]) / (4.0 * square),
        ],
        nominal: middle[mode],
    };
    let rows = [slope(0), slope(1)];
    let determinant = rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
    let inverse = [[rows[1][1], -rows[0][1]], [-rows[1][0], rows[0][0]]].map(|row| row.map(|part| part / determinant));
    let column = |way: usize| [inverse[0][way], inverse[1][way]];
    Some([0, 1].map(|way| Way { along: column(way), coordinate: coordinate(way) }).into())
}

impl Way {
    /// How far along it a change leads.
    pub fn coordinate(&self, change: Change) -> f64 {
        match &self.coordinate {
            Coordinate::Together => change[1],
            Coordinate::Straight(of) => dot(*of, change),
            Coordinate::Frequency { slope, bend, .. } => {
                let [k, s] = change;
                dot(*slope, change) + bend[0] * k * k + bend[1] * s * s + bend[2] * k * s
            }
        }
    }

    /// The change at a coordinate, on the way itself; of a mode's frequency as exactly as it can be found.
    pub fn change_at(&self, spring: &Spring, far_end: FarEnd, x: f64) -> Change {
        let at = |part: f64| self.along.map(|along| along * part);
        let Coordinate::Frequency { mode, nominal, .. } = &self.coordinate else { return at(x) };
        let off = |part: f64| Some(frequencies(spring, far_end, at(part))?.get(*mode)?.ln() - nominal - x);
        // The coordinate's slope along the way is one: each step leaves a share of the error as small as the way is bent.
        let mut part = x;
        for _ in 0..4 {
            part -= off(part).unwrap_or(0.0);
        }
        at(part)
    }

    /// Where on the way a mode (from zero; `natural` on the spec's own spring) has a frequency \[rad/s\]; `None` where it is too far off, or
    /// hardly moves there.
    pub fn meets(
        &self,
        spring: &Spring,
        far_end: FarEnd,
        (mode, natural): (usize, f64),
        frequency: f64,
    ) -> Option<f64> {
        let apart = (frequency / natural).ln();
        if matches!(self.coordinate, Coordinate::Together) {
            return Some(apart);
        }
        if apart.abs() > FAR {
            return None;
        }
        let off = |x: f64| -> Option<f64> {
            let change = self.along.map(|along| along * x);
            Some(frequencies(spring, far_end, change)?.get(mode)?.ln() - frequency.ln())
        };
        let slope = (off(STEP)? - off(-STEP)?) / (2.0 * STEP);
        if slope.abs() < HARDLY {
            return None;
        }
        let mut x = 0.0;
        for _ in 0..4 {
            x -= off(x)? / slope;
        }
        let Coordinate::Frequency { mode, nominal, .. } = &self.coordinate else { return Some(x) };
        let change = self.along.map(|along| along * x);
        Some(frequencies(spring, far_end, change)?.get(*mode)?.ln() - nominal)
    }
}

/// A line further from a mode than this, ln of a factor of two, is out of reach of any tolerance.
const FAR: f64 = std::f64::consts::LN_2;
/// A mode whose frequency follows a way by less than this share stays.
const HARDLY: f64 = 0.2;

pub(super) fn dot(a: Change, b: Change) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Angular frequencies of a changed spring.
fn frequencies(spring: &Spring, far_end: FarEnd, change: Change) -> Option<Vec<f64>> {
    Some(ModalModel::chain(&changed(spring, change).ok()?, far_end).frequencies().to_vec())
}

/// The spring with another stiffness and other surge frequencies; its mass follows.
pub(super) fn changed(spring: &Spring, [stiffness, frequencies]: Change) -> Result<Spring, Error> {
    let parameters = spring.parameters();
    let stiffer = stiffness.exp();
    Spring::new(SpringParameters {
        stiffness: stiffer * parameters.stiffness,
        mass: stiffer * parameters.mass * (-2.0 * frequencies).exp(),
        nominal_force: Some(spring.nominal_force()),
        ..parameters.clone()
    })?
    .with_masses_per_winding(spring.masses_per_winding())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::SpringSpec;

    fn spec() -> SpringSpec {
        let text = "[spring]\nname = \"valve\"\nrest_length = \"41 mm\"\nwindings = 6\ncoil_radius = \"16.9 mm\"\nwire_radius = \"2.5 mm\"\n\
                    mass = \"97 g\"\nstiffness = \"27 kN/m\"\nmin_length = \"36 mm\"\nmax_length = \"40 mm\"\nend_type = \"open-ground\"\n";
        SpringSpec::parse("valve.toml", text).unwrap()
    }

    fn spring() -> Spring {
        spec().spring
    }

    #[test]
    fn a_coordinate_is_the_logarithm_of_the_modes_frequency() {
        let far_end = FarEnd::Mass(0.62);
        let nominal = frequencies(&spring(), far_end, [0.0; 2]).unwrap();
        for (mode, way) in by_mode(&spring(), far_end).unwrap().into_iter().enumerate() {
            for x in [-0.07, -0.01, 0.0, 0.03, 0.08] {
                let change = way.change_at(&spring(), far_end, x);
                let moved = frequencies(&spring(), far_end, change).unwrap();
                assert!(((moved[mode] / nominal[mode]).ln() - x).abs() < 1e-9, "mode {mode} at {x}");
                // Of any change, but for its cube; the other mode stays but for the second order.
                assert!(
                    (way.coordinate(change) - x).abs() < 0.05 * x.abs().powi(3) + 1e-7,
                    "mode {mode} at {x}: {}",
                    way.coordinate(change)
                );
                assert!((moved[1 - mode] / nominal[1 - mode]).ln().abs() < 0.5 * x * x + 1e-9, "mode {mode} at {x}");
            }
            let target = nominal[1] * 1.04;
            let meets = way.meets(&spring(), far_end, (1, nominal[1]), target);
            assert_eq!(meets.is_some(), mode == 1);
            if let Some(x) = meets {
                assert!((x - 1.04_f64.ln()).abs() < 1e-6, "{x}");
            }
        }
    }

    #[test]
    fn springs_on_a_line_go_along_it() {
        let mut specimens = Specimens::of(&spec(), &crate::spec::Tolerances::default(), 3);
        for (specimen, x) in specimens.each.iter_mut().zip([-0.04, 0.0, 0.02]) {
            specimen.change = [0.6 * x, 0.8 * x];
        }
        let ways = ways(&spring(), FarEnd::Mass(0.62), &specimens);
        assert_eq!(ways.len(), 1);
        let change = specimens.each[0].change;
        let x = ways[0].coordinate(change);
        let back = ways[0].change_at(&spring(), FarEnd::Mass(0.62), x);
        assert!((x.abs() - 0.04).abs() < 1e-12 && dot(back, back).sqrt() - 0.04 < 1e-12);
        assert!((back[0] - change[0]).abs() < 1e-12 && (back[1] - change[1]).abs() < 1e-12);
    }
}
