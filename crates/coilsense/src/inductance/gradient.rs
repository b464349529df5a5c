//! How L answers to where each winding is: gradient, Hessian, and the matrix of mutual inductances that L is the sum of.
//!
//! Next door: one pair (`derivatives`), L itself (`maxwell`), the form that uses them (`second_order`).

use super::derivatives::replace;
use super::maxwell::MaxwellSum;
use super::mutual::MU_0;
use crate::error::{Error, all_finite, check, count, entry, finite};

impl MaxwellSum {
    /// ∂L/∂x of the chain's nodes \[H/m\]: end 1, the windings' masses 1…N, end 2; shape `N + 2`.
    ///
    /// g_t = ∂L/∂x_t = 2 Σ_{s≠t} M′(|x_t − x_s|) sgn(x_t − x_s) by the turns, ∂L/∂X_n = Σ_t W_tn g_t by the nodes
    ///
    /// - `ends`: u1, u2 \[m\]; `masses`: x_1…x_N \[m\], shape `N`
    ///
    /// Source:   derivative of `[Weijde2017]` eq. 11; W is the linear carry of [`MaxwellSum`]'s rule of fractions.
    /// Valid:    as [`MaxwellSum`], turns apart. With as many turns as masses W is the identity and the ends count zero.
    /// Accuracy: 5e-15 relative for two turns, against 40 digits; over N turns 1e-13 of the largest entry. The entries sum to zero.
    ///
    /// # Errors
    /// [`Error::Count`] for another number of masses; [`Error::Value`] for the first position that is not finite, or that
    /// coincides with another.
    ///
    /// ```
    /// # let spring = coilsense::Spring::new(coilsense::SpringParameters { windings: 2.0, ..coilsense::paper::S_T })?;
    /// use coilsense::inductance::{MaxwellSum, SelfDistance, mutual_inductance_derivatives};
    /// let coil = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
    /// let gradient = coil.gradient([0.0, 0.02], &[0.005, 0.015])?;
    /// let slope = mutual_inductance_derivatives(0.008, 0.01).first;
    /// assert!((gradient[2] / (2.0 * slope) - 1.0).abs() < 1e-14);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn gradient(&self, ends: [f64; 2], masses: &[f64]) -> Result<Vec<f64>, Error> {
        let turns = self.checked_turns(ends, masses)?;
        let mut by_turn = vec![0.0; turns.len()];
        // Twice 2 μ₀: each pair counts in both orders.
        let scale = 4.0 * MU_0;
        self.for_each_row::<1>(&turns, |first, later| {
            for (offset, (derivative, distance)) in later.iter().enumerate() {
                let pull = scale * derivative * distance.signum();
                by_turn[first] -= pull;
                by_turn[first + 1 + offset] += pull;
            }
        })?;
        let carry = self.carry(masses.len());
        let mut by_node = vec![0.0; carry.nodes()];
        for (turn, value) in by_turn.iter().enumerate() {
            for (node, weight) in carry.of_turn(turn) {
                by_node[node] += weight * value;
            }
        }
        Ok(by_node)
    }

    /// ∂²L/∂x∂x of the chain's nodes \[H/m²\]: end 1, the masses 1…N, end 2; shape `(N + 2) × (N + 2)`, row-major, symmetric.
    ///
    /// H_ts = −2 M″(|x_t − x_s|), H_tt = 2 Σ_{s≠t} M″(|x_t − x_s|) by the turns, Wᵀ H W by the nodes
    ///
    /// - `ends`, `masses`: as [`Self::gradient`]
    ///
    /// Source:   as [`Self::gradient`].
    /// Valid:    as [`Self::gradient`].
    /// Accuracy: 5e-15 relative for two turns, against 40 digits; over N turns 1e-13 of the largest entry. Each row sums to zero.
    ///
    /// # Errors
    /// As [`Self::gradient`].
    ///
    /// ```
    /// # let spring = coilsense::Spring::new(coilsense::SpringParameters { windings: 2.0, ..coilsense::paper::S_T })?;
    /// use coilsense::inductance::{MaxwellSum, SelfDistance, mutual_inductance_derivatives};
    /// let coil = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
    /// let hessian = coil.hessian([0.0, 0.02], &[0.005, 0.015])?; // 4 nodes: end 1, two masses, end 2
    /// let curvature = mutual_inductance_derivatives(0.008, 0.01).second;
    /// assert!((hessian[4 + 2] / (-2.0 * curvature) - 1.0).abs() < 1e-14);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn hessian(&self, ends: [f64; 2], masses: &[f64]) -> Result<Vec<f64>, Error> {
        let turns = self.checked_turns(ends, masses)?;
        let carry = self.carry(masses.len());
        let nodes = carry.nodes();
        let mut by_node = vec![0.0; nodes * nodes];
        let scale = 4.0 * MU_0 / self.coil_radius();
        self.for_each_row::<2>(&turns, |first, later| {
            for (offset, (derivative, _)) in later.iter().enumerate() {
                // A pair's part of L depends on the difference of its turns only: M″ times the outer product of that difference.
                let [left, right] = [carry.of_turn(first), carry.of_turn(first + 1 + offset)];
                let difference = [(left[0], -1.0), (left[1], -1.0), (right[0], 1.0), (right[1], 1.0)];
                for ((row, row_weight), row_sign) in difference {
                    for ((column, weight), sign) in difference {
                        by_node[row * nodes + column] += scale * derivative * (row_sign * row_weight) * (sign * weight);
                    }
                }
            }
        })?;
        Ok(by_node)
    }

    /// M_ts \[H\] of all turns; shape `turns × turns`, row-major, symmetric, turns from end 1 to end 2.
    ///
    /// M_ts = M(|x_t − x_s|), M_tt = M(h_self) N_L / round(N_L), so that the entries sum to L
    ///
    /// - `ends`, `masses`: as [`Self::gradient`]
    ///
    /// Source:   `[Weijde2017]` eqs. 8–11.
    /// Valid:    as [`MaxwellSum`].
    /// Accuracy: 2e-15 relative.
    /// Differs:  N_L fractional windings are round(N_L) turns whose own part is scaled, by the rule of [`MaxwellSum`].
    ///
    /// # Errors
    /// As [`Self::gradient`].
    ///
    /// ```
    /// # let spring = coilsense::Spring::new(coilsense::SpringParameters { windings: 2.0, ..coilsense::paper::S_T })?;
    /// use coilsense::inductance::{MaxwellSum, SelfDistance, mutual_inductance};
    /// let coil = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
    /// let matrix = coil.matrix([0.0, 0.02], &[0.005, 0.015])?;
    /// assert!((matrix[1] / mutual_inductance(0.008, 0.01) - 1.0).abs() < 2e-15);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn matrix(&self, ends: [f64; 2], masses: &[f64]) -> Result<Vec<f64>, Error> {
        let turns = self.checked_turns(ends, masses)?;
        let count = turns.len();
        let mut matrix = vec![0.0; count * count];
        let scale = 2.0 * MU_0 * self.coil_radius();
        self.for_each_row::<0>(&turns, |first, later| {
            for (offset, (mutual, _)) in later.iter().enumerate() {
                let second = first + 1 + offset;
                matrix[first * count + second] = scale * mutual;
                matrix[second * count + first] = scale * mutual;
            }
        })?;
        for turn in 0..count {
            matrix[turn * count + turn] = self.self_part() / count as f64;
        }
        Ok(matrix)
    }

    /// The turns of a chain, checked.
    fn checked_turns(&self, ends: [f64; 2], masses: &[f64]) -> Result<Vec<f64>, Error> {
        self.check_even()?;
        count("masses", masses.len(), self.chain_masses())?;
        finite("u1", ends[0], "m")?;
        finite("u2", ends[1], "m")?;
        all_finite("masses", masses, "m")?;
        let mut turns = Vec::new();
        Ok(self.carry(masses.len()).turns(ends, masses, &mut turns).to_vec())
    }

    /// Hands out, for each turn, the derivative of order `ORDER` of F at each later turn beside the signed distance to it.
    fn for_each_row<const ORDER: usize>(
        &self,
        turns: &[f64],
        mut take: impl FnMut(usize, &[(f64, f64)]),
    ) -> Result<(), Error> {
        let (mut derivatives, mut row) = (Vec::with_capacity(turns.len()), Vec::with_capacity(turns.len()));
        for (first, &from) in turns.iter().enumerate() {
            let later = &turns[first + 1..];
            derivatives.clear();
            derivatives.extend(later.iter().map(|&to| (to - from) / self.coil_radius()));
            replace::<ORDER>(&mut derivatives);
            if let Some(offset) = derivatives.iter().position(|value| !value.is_finite()) {
                let allowed = format!("apart from turns[{first}]");
                check(false, entry("turns", first + 1 + offset), later[offset], "m", allowed)?;
            }
            row.clear();
            row.extend(derivatives.iter().copied().zip(later.iter().map(|&to| to - from)));
            take(first, &row);
        }
        Ok(())
    }
}
