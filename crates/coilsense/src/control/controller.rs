//! The controller: PID with feed-forward and, if wanted, a disturbance observer.
//!
//! Next door: the loop it closes (`force_loop`), the same from sample to sample (`sampled`).

use std::f64::consts::TAU;

use super::drive::Drive;
use super::rational::{Rational, product, sum};
use crate::error::{Error, above_zero, called, check, not_negative};

/// Gains from force error \[N\] to command (m/s of a velocity source, N of a force source).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Gains {
    /// K_P \[command/N\].
    pub proportional: f64,
    /// K_I \[command/(N s)\].
    pub integral: f64,
    /// K_D \[command s/N\].
    pub derivative: f64,
    /// Where the derivative's first-order filter has lost 3 dB \[Hz\]; needed where K_D is not zero.
    pub derivative_bandwidth: Option<f64>,
    /// What the reference adds to the command \[command/N\].
    pub feed_forward: f64,
    /// Bandwidth of the disturbance observer's second-order filter \[Hz\]; none where `None`.
    pub observer_bandwidth: Option<f64>,
}

/// A controller whose every number has been checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Controller {
    gains: Gains,
}

impl Controller {
    /// A controller of these gains.
    ///
    /// # Errors
    /// [`Error::Value`] for the first gain below zero or not finite, a bandwidth that is not above zero, a derivative without a bandwidth,
    /// or gains that are all zero without an observer.
    pub fn new(gains: Gains) -> Result<Self, Error> {
        for (quantity, value) in [
            (called("proportional", "proportional gain"), gains.proportional),
            (called("integral", "integral gain"), gains.integral),
            (called("derivative", "derivative gain"), gains.derivative),
            (called("feed_forward", "feed-forward gain"), gains.feed_forward),
        ] {
            not_negative(quantity, value, "")?;
        }
        for (quantity, value) in
            [("derivative_bandwidth", gains.derivative_bandwidth), ("observer_bandwidth", gains.observer_bandwidth)]
        {
            if let Some(value) = value {
                above_zero(quantity, value, "Hz")?;
            }
        }
        let filtered = gains.derivative == 0.0 || gains.derivative_bandwidth.is_some();
        let [integral, derivative] = [called("integral", "integral gain"), called("derivative", "derivative gain")];
        check(filtered, derivative, gains.derivative, "", "zero without a derivative bandwidth")?;
        let acts = gains.proportional + gains.integral + gains.derivative > 0.0 || gains.observer_bandwidth.is_some();
        check(acts, integral, gains.integral, "", "above zero where no other gain closes the loop")?;
        Ok(Self { gains })
    }

    /// Proportional control alone: K_P \[command/N\]. On a velocity source it is what is called integral force control: L = K_P k/s.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn proportional(gain: f64) -> Result<Self, Error> {
        Self::new(Gains { proportional: gain, ..Gains::default() })
    }

    /// Integral control alone: K_I \[command/(N s)\].
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn integral(gain: f64) -> Result<Self, Error> {
        Self::new(Gains { integral: gain, ..Gains::default() })
    }

    /// Its gains.
    pub fn gains(&self) -> &Gains {
        &self.gains
    }

    /// PID: what the force error is multiplied by, K_P + K_I/s + K_D s/(1 + s/ω_D).
    fn pid(&self) -> Rational {
        let Gains { proportional, integral, derivative, derivative_bandwidth, .. } = self.gains;
        let slow = derivative_bandwidth.filter(|_| derivative > 0.0).map_or(0.0, |bandwidth| 1.0 / (TAU * bandwidth));
        let filter = if slow > 0.0 { vec![1.0, slow] } else { vec![1.0] };
        let straight = product(&filter, &[integral, proportional]);
        if integral == 0.0 {
            // Without an integral s cancels: the pole at zero would be one of the loop's that is not there.
            let numerator = sum(&straight, &[0.0, 0.0, derivative])[1..].to_vec();
            return Rational {
                numerator: if numerator.is_empty() { vec![0.0] } else { numerator },
                denominator: filter,
            };
        }
        Rational { numerator: sum(&straight, &[0.0, 0.0, derivative]), denominator: product(&[0.0, 1.0], &filter) }
    }

    /// From measured force to command, the sign of negative feedback left out: (C + Q/P_n)/(1 − Q), and C without an observer.
    ///
    /// Q = 1/(1 + s/ω_Q)², P_n the drive with a spring of stiffness k without mass.
    pub(super) fn feedback(&self, drive: &Drive, stiffness: f64) -> Rational {
        let pid = self.pid();
        let Some(observer) = self.observer() else { return pid };
        let inverse = product(&pid.denominator, &drive.nominal_inverse(stiffness));
        let numerator = sum(&product(&pid.numerator, &observer.filter), &inverse);
        Rational { numerator, denominator: product(&pid.denominator, &observer.rest) }
    }

    /// From reference to command: (C + feed-forward)/(1 − Q).
    pub(super) fn forward(&self) -> Rational {
        let pid = self.pid();
        let fed = self.gains.feed_forward;
        let scaled: Vec<f64> = pid.denominator.iter().map(|value| fed * value).collect();
        let numerator = sum(&pid.numerator, &scaled);
        match self.observer() {
            None => Rational { numerator, denominator: pid.denominator },
            Some(observer) => Rational {
                numerator: product(&numerator, &observer.filter),
                denominator: product(&pid.denominator, &observer.rest),
            },
        }
    }

    fn observer(&self) -> Option<Observer> {
        self.gains.observer_bandwidth.map(|bandwidth| {
            let slow = 1.0 / (TAU * bandwidth);
            Observer { filter: vec![1.0, 2.0 * slow, slow * slow], rest: vec![0.0, 2.0 * slow, slow * slow] }
        })
    }
}

/// 1/Q and 1/Q − 1 as polynomials.
struct Observer {
    filter: Vec<f64>,
    rest: Vec<f64>,
}
