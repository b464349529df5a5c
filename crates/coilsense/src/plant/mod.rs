//! The spring on its mount as a part of another's model: modes, what drives them and what they pull with, as plain numbers.
//!
//! Next door: how many modes an error needs and what stands for the others (`order`), the same as matrices (`state_space`), how near its windings are
//! and what their inductance tells (`coil`), a step of it
//! (`coilsense_rt::Plant`), a whole force loop (`crate::control`).

mod coil;
mod order;
mod state_space;

use coilsense_rt::{PlantMode, PlantSettings};
use num_complex::Complex64;

use crate::error::{Error, above_zero, check, count};
use crate::modes::ModalModel;
use crate::mount::{FarEnd, Mount};
use crate::spring::Spring;
pub use coil::{ModalCoil, ModalWindings};
pub use order::Order;
pub use state_space::{Sampled, StateSpace};

/// A spring on its mount, linear about a mean length, for a simulation that is someone else's.
///
/// q̈_j + 2ζ_jω_j q̇_j + ω_j² q_j = −(c1_j ẅ1 + c2_j ẅ2), F = F_s + Σ_j p_j (q_j + β q̇_j): [`crate::Motion`] in numbers. Inputs count from
/// their means: u1, and u2 or the force at end 2. With all modes it is that motion exactly, for inputs that move straight between
/// samples; with fewer, two modes more, one for each input, keep the inertia of those left out ([`Order`]).
///
/// Source:   `[Weijde2017]` eqs. 4–7 in the modal coordinates of [`crate::Motion`].
/// Valid:    linear: windings that never touch, ends that stay on their seats, a uniform coil.
/// Accuracy: steps of all modes 1e-10 of the peak over 10⁵ steps (`f32`: 1e-4), any step, mount and damping (`tests/plant.rs`).
///
/// ```
/// use coilsense::plant::{ModalPlant, Order};
/// use coilsense::{Excitation, Motion, Mount};
///
/// let spring = coilsense::paper::s_t();
/// let plant = ModalPlant::new(&spring, &Mount::default(), 0.23, Order::All)?;
/// let steps = plant.settings::<52>()?.plant::<f64>(1e-4).expect("a step above zero");
/// let mut state = steps.settled([0.0; 2]);
/// let forces = steps.step(&mut state, [1e-5, 0.0]);
/// // A wave is on its way: end 2 does not know of it yet.
/// assert!((forces.output - spring.static_force(0.23)).abs() < 1e-9);
/// assert!(forces.input < spring.static_force(0.23) - 0.1);
///
/// // Eight modes and two that stand for the others are within 1 % of k up to 100 Hz.
/// let small = ModalPlant::new(&spring, &Mount::default(), 0.23, Order::Within { error: 0.01, bandwidth: 100.0 })?;
/// assert!(small.count() <= 10 && small.error(100.0)? <= 0.01);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ModalPlant {
    spring: Spring,
    mount: Mount,
    mean_length: f64,
    model: ModalModel,
    ratios: Vec<f64>,
    kept: usize,
    modes: Vec<PlantMode>,
    /// ζ and ω of the first damped mode.
    damped: (f64, f64),
}

/// Frequencies of a band at which an error is looked at.
const LOOKS: usize = 32;
/// Largest damping ratio of a mode, as in a motion.
const LARGEST_RATIO: f64 = 1e3;

impl ModalPlant {
    /// A spring at rest at a mean length \[m\], with as many modes as `order` says.
    ///
    /// # Errors
    /// [`Error::Value`] for a coil of sections, whose force is no straight line, for a mean length, error or bandwidth that is not above zero,
    /// for more modes than there are, and for a mode with a damping ratio above 1000; those of [`crate::Damping::ratios`].
    pub fn new(spring: &Spring, mount: &Mount, mean_length: f64, order: Order) -> Result<Self, Error> {
        spring.check_uniform("a plant")?;
        above_zero("mean_length", mean_length, "m")?;
        let model = ModalModel::chain(spring, mount.far_end());
        let ratios = mount.damping().ratios(model.frequencies())?;
        let first = ratios.iter().position(|ratio| *ratio > 0.0).unwrap_or(0);
        let damped = (ratios[first], model.frequencies()[first]);
        let mut plant = Self {
            spring: spring.clone(),
            mount: mount.clone(),
            mean_length,
            model,
            ratios,
            kept: 0,
            modes: Vec::new(),
            damped,
        };
        plant.kept = plant.modes_for(order)?;
        let others = if plant.kept < plant.model.count() { plant.left_out(plant.kept).stand_ins() } else { Vec::new() };
        plant.modes = (0..plant.kept).map(|mode| plant.own(mode)).chain(others).collect();
        // As a motion: beyond, a mode is no spring.
        if let Some((mode, ratio)) = plant.ratios().enumerate().find(|(_, ratio)| *ratio > LARGEST_RATIO) {
            let allowed = format!("at most {LARGEST_RATIO}");
            check(false, format!("damping ratio of mode {}", mode + 1), ratio, "", allowed)?;
        }
        Ok(plant)
    }

    /// The spring.
    pub fn spring(&self) -> &Spring {
        &self.spring
    }

    /// What its end 2 is tied to, and its damping.
    pub fn mount(&self) -> &Mount {
        &self.mount
    }

    /// Where it is at rest \[m\].
    pub fn mean_length(&self) -> f64 {
        self.mean_length
    }

    /// How many modes are the spring's own.
    pub fn kept(&self) -> usize {
        self.kept
    }

    /// How many modes the spring has.
    pub fn available(&self) -> usize {
        self.model.count()
    }

    /// How many modes there are, those that stand for all others among them.
    pub fn count(&self) -> usize {
        self.modes.len()
    }

    /// The modes: those of the spring, lowest first, then those that stand for all others.
    pub fn modes(&self) -> &[PlantMode] {
        &self.modes
    }

    /// ζ_j \[1\] of each mode.
    pub fn ratios(&self) -> impl Iterator<Item = f64> + '_ {
        self.modes.iter().map(|mode| mode.damping * self.damped.0)
    }

    /// β \[s\] of dashpots beside every segment; zero of other damping.
    pub fn dashpot_time(&self) -> f64 {
        self.mount.damping().dashpot_time()
    }

    /// ζ \[1\] and ω \[rad/s\] of the first mode that is damped; ζ is zero where none is.
    pub fn damped(&self) -> (f64, f64) {
        self.damped
    }

    /// How much longer the mean length is than the rest length \[m\].
    pub fn stretch(&self) -> f64 {
        self.mean_length - self.spring.rest_length()
    }

    /// F_i = F_o = F_x \[N\] at the mean length.
    pub fn mean_force(&self) -> f64 {
        self.spring.static_force(self.mean_length)
    }

    /// What a processor is given, for a number of modes that is [`Self::count`].
    ///
    /// # Errors
    /// [`Error::Count`] for another number.
    pub fn settings<const MODES: usize>(&self) -> Result<PlantSettings<MODES>, Error> {
        let modes: [PlantMode; MODES] = match self.modes.as_slice().try_into() {
            Ok(modes) => modes,
            Err(_) => return count("modes", self.modes.len(), MODES).and(Err(Error::MissingSignal("modes"))),
        };
        Ok(PlantSettings {
            stiffness: self.spring.stiffness(),
            mass: self.spring.mass(),
            damping_ratio: self.damped.0,
            damped_frequency: self.damped.1,
            dashpots: self.dashpot_time() > 0.0,
            stretch: self.stretch(),
            far_end: self.far_end(),
            modes,
        })
    }

    /// What end 2 is tied to, as a processor has it.
    pub fn far_end(&self) -> coilsense_rt::FarEnd {
        match self.mount.far_end() {
            FarEnd::Position => coilsense_rt::FarEnd::Position,
            FarEnd::Force => coilsense_rt::FarEnd::Force,
            FarEnd::Mass(_) => coilsense_rt::FarEnd::Mass,
        }
    }

    /// F_i, F_o and F_x over each input at one frequency \[Hz\], in \[N/m\] or, of a force, \[1\].
    ///
    /// H = H_s + Σ_j p_j c_j (1 + iβΩ) Ω² / (ω_j² − Ω² + 2iζ_jω_jΩ)
    ///
    /// Source:   the plant's equation under sines.
    /// Valid:    any frequency but that of an undamped mode.
    /// Accuracy: that of all modes equals `crate::two_port::TwoPort` within 1e-11 of the largest (test).
    ///
    /// # Errors
    /// [`Error::Value`] for a frequency that is not above zero.
    pub fn response(&self, frequency: f64) -> Result<[[Complex64; 2]; 3], Error> {
        above_zero("frequency", frequency, "Hz")?;
        let drive = std::f64::consts::TAU * frequency;
        let mut response = self.of_line().map(|row| row.map(Complex64::from));
        for (mode, ratio) in self.modes.iter().zip(self.ratios()) {
            order::add(&mut response, &self.pulls(mode), mode, ratio, [drive, self.dashpot_time()]);
        }
        Ok(response)
    }

    /// What the other modes are missed by, at most, up to a frequency \[Hz\]: of the response of F_i, F_o and F_x to each input, over k or, of a
    /// force, over 1.
    ///
    /// max |H − H_all|/k at 32 frequencies of the band; infinite where a mode in the band is left out
    ///
    /// # Errors
    /// [`Error::Value`] for a bandwidth that is not above zero.
    pub fn error(&self, bandwidth: f64) -> Result<f64, Error> {
        above_zero("bandwidth", bandwidth, "Hz")?;
        Ok(self.errors(bandwidth)[self.kept - 1])
    }

    /// F_i, F_o, F_x of a spring without mass over each input.
    fn of_line(&self) -> [[f64; 2]; 3] {
        let stiffness = self.spring.stiffness();
        match self.mount.far_end() {
            FarEnd::Position => [[-stiffness, stiffness]; 3],
            _ => [[0.0, 1.0]; 3],
        }
    }

    /// What F_i, F_o and F_x gain per q of a mode.
    fn pulls(&self, mode: &PlantMode) -> [f64; 3] {
        [mode.weights[0], mode.weights[1], self.spring.stiffness() * mode.end]
    }

    /// One of the spring's modes, counted from zero.
    fn own(&self, mode: usize) -> PlantMode {
        let [first, second] = self.model.participations();
        let [input, output] = self.model.weights();
        let scale = self.model.segment();
        PlantMode {
            frequency: self.model.frequencies()[mode],
            damping: if self.damped.0 > 0.0 { self.ratios[mode] / self.damped.0 } else { 1.0 },
            participations: [first[mode], second[mode]],
            weights: [scale * input[mode], scale * output[mode]],
            end: self.model.end_shapes()[mode],
        }
    }
}
