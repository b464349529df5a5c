//! A plant's windings: how near they are to each other, and what their inductance makes of the force.
//!
//! Next door: the plant (the parent), a sample of these (`coilsense_rt::{PlantWindings, PlantCoil}`), the form (`crate::inductance::SecondOrder`).

use std::f64::consts::TAU;

use coilsense_rt::{PlantCoil, PlantWindings, Real};
use num_complex::Complex64;

use super::{LOOKS, ModalPlant, Order};
use crate::calibrate::Calibration;
use crate::error::{Error, above_zero, check, count};
use crate::inductance::{ByPitch, MaxwellSum};
use crate::mount::FarEnd;

/// How far neighbouring windings of a plant are from each other; [`ModalPlant::windings`].
#[derive(Debug, Clone, PartialEq)]
pub struct ModalWindings {
    mean_length: f64,
    share: f64,
    contact_pitch: f64,
    gaps: Vec<Vec<f64>>,
}

/// The inductance of a plant to second order, and the force by it; [`ModalPlant::coil`].
#[derive(Debug, Clone, PartialEq)]
pub struct ModalCoil {
    mean_length: f64,
    windings: f64,
    calibration: Calibration,
    by_pitch: ByPitch,
    gaps: Vec<Vec<f64>>,
    /// F_L per q of each mode off the line between the ends, at the mean length \[N/m\].
    weights: Vec<f64>,
    /// F_L per distance between the ends there \[N/m\]: k, but for what the calibration's form leaves.
    slope: f64,
}

impl ModalPlant {
    /// The distances between neighbouring windings: between a point and that one turn further.
    ///
    /// g_ij = φ_j(i + n) − φ_j(i) − (n/N) ψ_j, n masses a winding
    ///
    /// Modes that stand for others have the shape of those in which these follow an input's acceleration.
    ///
    /// - `contact_pitch`: at which distance windings touch \[m\], centre to centre, above zero
    ///
    /// Source:   geometry, as [`crate::Clash`].
    /// Valid:    as [`ModalPlant`].
    /// Accuracy: with all modes the smallest pitch is that of a motion to 1e-9 of its range (test).
    ///
    /// # Errors
    /// [`Error::Value`] for a spring of one winding, and for a contact pitch that is not above zero.
    pub fn windings(&self, contact_pitch: f64) -> Result<ModalWindings, Error> {
        above_zero("contact_pitch", contact_pitch, "m")?;
        let (masses, apart) = (self.model.masses(), self.spring.masses_per_winding());
        check(masses > apart, "windings", self.spring.windings(), "", "at least 2: one winding has no neighbour")?;
        let nodes = self.nodes();
        let gap = |mass: usize| nodes.iter().map(|shape| shape[mass + apart] - shape[mass]).collect();
        Ok(ModalWindings {
            mean_length: self.mean_length,
            share: apart as f64 / masses as f64,
            contact_pitch,
            gaps: (1..=masses - apart).map(gap).collect(),
        })
    }

    /// The inductance to second order about windings evenly spaced over each instant's length, and the force by it.
    ///
    /// - `coil`: Maxwell's sum over the spring's windings; `calibration`: of the meter
    /// - `lengths`: the shortest and the longest distance of the ends for which it is good \[m\]
    ///
    /// Source:   [`crate::inductance::SecondOrder`]; polynomials in the pitch leave 1e-11 of L.
    /// Valid:    as [`ModalPlant`] and [`MaxwellSum`]; wire that is not magnetic.
    /// Accuracy: its bound, sample by sample ([`coilsense_rt::CoilReading`]).
    ///
    /// # Errors
    /// [`Error::Value`] for a coil of one turn, for lengths that are not above zero, not rising or too far apart, and for a mean length that is
    /// not between them.
    pub fn coil(&self, coil: &MaxwellSum, calibration: Calibration, lengths: [f64; 2]) -> Result<ModalCoil, Error> {
        let [shortest, longest] = lengths;
        let carriers = coil.carriers(self.model.masses());
        check(carriers.len() > 1, "turns", carriers.len() as f64, "", "at least 2: one turn has no neighbour")?;
        let by_pitch = coil.by_pitch(lengths)?;
        let within = (shortest..=longest).contains(&self.mean_length);
        check(within, "mean_length", self.mean_length, "m", format!("from {shortest} to {longest} m"))?;
        let nodes = self.nodes();
        let place =
            |shape: &[f64], turn: &[(usize, f64)]| turn.iter().map(|(node, part)| shape[*node] * part).sum::<f64>();
        let gap = |turns: &[[(usize, f64); 2]]| {
            nodes.iter().map(|shape| place(shape, &turns[1]) - place(shape, &turns[0])).collect()
        };
        let gaps = carriers.windows(2).map(gap).collect();
        let (weights, slope) = self.coil_slopes(coil, &calibration, &nodes)?;
        let (mean_length, windings) = (self.mean_length, coil.turns());
        Ok(ModalCoil { mean_length, windings, calibration, by_pitch, gaps, weights, slope })
    }

    /// What [`ModalCoil`]'s force misses of that with all modes, at most, up to a frequency \[Hz\]: of its response about the mean length to
    /// each input, over k or, of a force, over 1.
    ///
    /// # Errors
    /// [`Error::Value`] for a bandwidth that is not above zero; those of [`Self::coil`].
    pub fn coil_error(&self, coil: &MaxwellSum, calibration: Calibration, bandwidth: f64) -> Result<f64, Error> {
        above_zero("bandwidth", bandwidth, "Hz")?;
        if self.kept == self.available() {
            return Ok(0.0);
        }
        if self.model.frequencies()[self.kept] <= TAU * bandwidth {
            return Ok(f64::INFINITY);
        }
        let lengths = [0.99 * self.mean_length, 1.01 * self.mean_length];
        let all = Self::new(&self.spring, &self.mount, self.mean_length, Order::All)?;
        let ours = self.coil(coil, calibration, lengths)?;
        let theirs = all.coil(coil, calibration, lengths)?;
        let scales = self.of_line()[0].map(|line| if line == 0.0 { self.spring.stiffness() } else { line.abs() });
        let missed = |look: usize| {
            let frequency = bandwidth * look as f64 / LOOKS as f64;
            let (few, many) = (self.coil_response(&ours, frequency)?, all.coil_response(&theirs, frequency)?);
            let each = few.iter().zip(&many).zip(scales);
            Ok(each.map(|((few, many), scale)| (few - many).norm() / scale).fold(0.0, f64::max))
        };
        let each = (1..=LOOKS).map(missed).collect::<Result<Vec<f64>, Error>>()?;
        Ok(each.into_iter().fold(0.0, f64::max))
    }

    /// F_L over each input at one frequency \[Hz\] about the mean length, in \[N/m\] or, of a force, \[1\]: as [`Self::response`].
    ///
    /// # Errors
    /// [`Error::Value`] for a frequency that is not above zero.
    pub fn coil_response(&self, coil: &ModalCoil, frequency: f64) -> Result<[Complex64; 2], Error> {
        above_zero("frequency", frequency, "Hz")?;
        let pulls: Vec<f64> = self.modes.iter().enumerate().map(|(index, mode)| coil.pull(index, mode.end)).collect();
        let [first, second] = self.swings(&pulls, TAU * frequency);
        let straight = coil.straight(self);
        Ok([straight[0] + first, straight[1] + second])
    }

    /// Σ_j w_j c_j Ω²/(ω_j² − Ω² + 2iζ_jω_jΩ) for each input.
    fn swings(&self, weights: &[f64], drive: f64) -> [Complex64; 2] {
        let mut sums = [Complex64::ZERO; 2];
        for ((mode, ratio), weight) in self.modes.iter().zip(self.ratios()).zip(weights) {
            let natural = mode.frequency;
            let detuning = Complex64::new((natural - drive) * (natural + drive), 2.0 * ratio * natural * drive);
            for (sum, participation) in sums.iter_mut().zip(mode.participations) {
                *sum += weight * participation * (drive * drive / detuning);
            }
        }
        sums
    }

    /// F_L about the mean length, per q and per distance between the ends: −k α l² times ∂L/∂x_n φ_n and dL/dl, l the length that is read there.
    fn coil_slopes(
        &self,
        coil: &MaxwellSum,
        calibration: &Calibration,
        nodes: &[Vec<f64>],
    ) -> Result<(Vec<f64>, f64), Error> {
        let masses = self.model.masses();
        let places: Vec<f64> = (1..=masses).map(|mass| self.model.place_at(mass)).collect();
        let even: Vec<f64> = places.iter().map(|place| place * self.mean_length).collect();
        let gradient = coil.gradient([0.0, self.mean_length], &even)?;
        let length = calibration.length(coil.at_length(self.mean_length));
        let scale = -self.spring.stiffness() * calibration.alpha() * length * length;
        let of = |shape: &[f64]| scale * gradient.iter().zip(shape).map(|(slope, way)| slope * way).sum::<f64>();
        let stretched: Vec<f64> = std::iter::once(0.0).chain(places).chain([1.0]).collect();
        Ok((nodes.iter().map(|shape| of(shape)).collect(), of(&stretched)))
    }

    /// How far each node moves off the line between the ends per q of each mode: end 1, masses 1…N, end 2. Shape `modes × (N + 2)`.
    fn nodes(&self) -> Vec<Vec<f64>> {
        let masses = self.model.masses();
        let own = |mode: usize| -> Vec<f64> {
            let end = self.model.end_shapes()[mode];
            let mass = |mass: usize| self.model.shape_at(mode + 1, mass) - self.model.place_at(mass) * end;
            std::iter::once(0.0).chain((1..=masses).map(mass)).chain([0.0]).collect()
        };
        let mut nodes: Vec<Vec<f64>> = (0..self.kept).map(own).collect();
        for (input, standing) in self.modes[self.kept..].iter().enumerate() {
            // q = −c ẅ/ω² of each that is left out, in units of the one that stands for them.
            let mut shape = vec![0.0; masses + 2];
            for mode in (self.kept..self.available()).rev() {
                let slower = standing.frequency / self.model.frequencies()[mode];
                let part = slower * slower * self.model.participations()[input][mode];
                shape.iter_mut().zip(own(mode)).for_each(|(sum, value)| *sum += part * value);
            }
            nodes.push(shape);
        }
        nodes
    }
}

impl ModalWindings {
    /// The distance between the ends where all inputs are zero \[m\].
    pub fn mean_length(&self) -> f64 {
        self.mean_length
    }

    /// Which share of that is between neighbours of a spring that moves slowly \[1\].
    pub fn share(&self) -> f64 {
        self.share
    }

    /// At which distance windings touch \[m\].
    pub fn contact_pitch(&self) -> f64 {
        self.contact_pitch
    }

    /// How much each distance grows per q of each mode \[1\], shape `gaps × modes`.
    pub fn gaps(&self) -> &[Vec<f64>] {
        &self.gaps
    }

    /// What a processor is given, for as many modes and gaps as there are, in the precision of its steps.
    ///
    /// # Errors
    /// [`Error::Count`] for other numbers.
    pub fn settings<T: Real, const MODES: usize, const GAPS: usize>(
        &self,
    ) -> Result<PlantWindings<T, MODES, GAPS>, Error> {
        let Self { mean_length, share, contact_pitch, .. } = *self;
        Ok(PlantWindings { mean_length, share, contact_pitch, gaps: table("gaps", &self.gaps)? })
    }
}

impl ModalCoil {
    /// The distance between the ends where all inputs are zero \[m\].
    pub fn mean_length(&self) -> f64 {
        self.mean_length
    }

    /// N_L: over how many windings that is divided.
    pub fn windings(&self) -> f64 {
        self.windings
    }

    /// The meter's calibration.
    pub fn calibration(&self) -> Calibration {
        self.calibration
    }

    /// p0 and w \[m\]: the middle and the half of the mean pitches for which it is good.
    pub fn pitches(&self) -> [f64; 2] {
        self.by_pitch.pitches
    }

    /// What its polynomials leave of L, at most \[1\].
    pub fn left(&self) -> f64 {
        self.by_pitch.left
    }

    /// L of evenly spaced turns \[H\], coefficients of 1, z, z² …, shape `terms`.
    pub fn inductance(&self) -> &[f64] {
        &self.by_pitch.inductance
    }

    /// 2M′(ap), M″(ap) and ⅓ |M‴(ap)| ap of turns a apart, shape `gaps × terms` each \[H/m, H/m², H/m²\].
    pub fn by_lag(&self) -> [&[Vec<f64>]; 3] {
        [&self.by_pitch.slopes, &self.by_pitch.curvatures, &self.by_pitch.remainders]
    }

    /// How much the distance of each turn to the next grows per q of each mode \[1\], shape `gaps × modes`.
    pub fn gaps(&self) -> &[Vec<f64>] {
        &self.gaps
    }

    /// F_L over each input of a spring that moves slowly.
    pub(super) fn straight(&self, plant: &ModalPlant) -> [f64; 2] {
        match plant.mount.far_end() {
            FarEnd::Position => [-self.slope, self.slope],
            _ => [0.0, self.slope / plant.spring.stiffness()],
        }
    }

    /// F_L per q of one of the plant's modes, whose end 2 moves by `end`.
    pub(super) fn pull(&self, mode: usize, end: f64) -> f64 {
        self.weights[mode] + self.slope * end
    }

    /// What a processor is given, for as many modes, gaps and coefficients as there are, in the precision of its steps.
    ///
    /// # Errors
    /// [`Error::Count`] for other numbers.
    pub fn settings<T: Real, const MODES: usize, const GAPS: usize, const TERMS: usize>(
        &self,
    ) -> Result<PlantCoil<T, MODES, GAPS, TERMS>, Error> {
        let [slopes, curvatures, remainders] = self.by_lag();
        Ok(PlantCoil {
            mean_length: self.mean_length,
            windings: self.windings,
            pitches: self.pitches(),
            calibration: [self.calibration.alpha(), self.calibration.beta()],
            left: self.left(),
            inductance: row("terms", self.inductance())?,
            slopes: table("slopes", slopes)?,
            curvatures: table("curvatures", curvatures)?,
            remainders: table("remainders", remainders)?,
            gaps: table("gaps", &self.gaps)?,
        })
    }
}

fn row<T: Real, const N: usize>(name: &'static str, values: &[f64]) -> Result<[T; N], Error> {
    count(name, values.len(), N)?;
    let mut row = [T::ZERO; N];
    row.iter_mut().zip(values).for_each(|(out, value)| *out = T::nearest(*value));
    Ok(row)
}

fn table<T: Real, const N: usize, const M: usize>(name: &'static str, rows: &[Vec<f64>]) -> Result<[[T; N]; M], Error> {
    count(name, rows.len(), M)?;
    let mut table = [[T::ZERO; N]; M];
    for (out, values) in table.iter_mut().zip(rows) {
        *out = row(name, values)?;
    }
    Ok(table)
}
