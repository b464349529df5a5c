//! One step: the points' motion as power series in time, exact to rounding while no pair meets or parts.
//!
//! Next door: how the ends move (`drive`), where a series falls through zero (`polynomial`), what happens then (`follow`).

use super::chain::Chain;
use super::damper::Damper;
use super::drive::Drive;
use super::polynomial::{ORDER, Polynomial};
use super::tridiagonal::Runs;

/// What is the same throughout a run.
pub(super) struct System<'a> {
    pub chain: &'a Chain,
    pub damper: &'a Damper,
    /// Displacement of end 1 \[m\]; that of end 2 beside the unloaded spring \[m\], or the force on it \[N\].
    pub drives: &'a [Drive; 2],
    /// Where windings that touch give way: stiffness \[N/m\], and each pair's dashpot \[N s/m\].
    pub elastic: Option<(f64, Vec<f64>)>,
}

impl System<'_> {
    /// Whether springs alone act on the lumps: nothing damps, pushes or is pulled, and no end is loose.
    pub fn is_plain(&self, now: &Now) -> bool {
        let pushed = !now.bonds.is_empty() || self.elastic.is_some() && now.closed.contains(&true);
        self.damper.is_none() && !pushed && !self.chain.is_open() && now.attached == [true; 2]
    }

    /// Subtracts from the forces on the lumps what damping takes; what dashpots in the first and the last segment pull at their ends with \[N\].
    pub fn brake(&self, attached: [bool; 2], relative: &[f64], forces: &mut [f64]) -> [f64; 2] {
        self.damper.brake(self.chain, relative, forces);
        let time = self.damper.dashpot_time();
        let (base, last) = (self.chain.base(), self.chain.last_segment());
        let mut pulls = [base, last]
            .map(|segment| time * self.chain.stiffnesses()[segment] * (relative[segment + 1] - relative[segment]));
        // A segment that hangs loose has no dashpot either.
        if !attached[0] {
            forces[base] += pulls[0];
            if base > 0 {
                forces[base - 1] -= pulls[0];
            }
            pulls[0] = 0.0;
        }
        if !attached[1] {
            forces[last - 1] -= pulls[1];
            if let Some(mass) = forces.get_mut(last) {
                *mass += pulls[1];
            }
            pulls[1] = 0.0;
        }
        pulls
    }
}

/// What the series of a step depends on beside the system.
#[derive(Debug, Clone)]
pub(super) struct Now {
    /// \[s\].
    pub time: f64,
    /// Displacement of each point from the unloaded spring with end 1 at zero \[m\], shape `N + 2`.
    pub places: Vec<f64>,
    /// \[m/s\], shape `N + 2`.
    pub speeds: Vec<f64>,
    /// Pairs that are held together, or that push elastically.
    pub closed: Vec<bool>,
    /// The same, factorized, where they are hard.
    pub bonds: Runs,
    /// Whether the first and the last segment hang on their ends.
    pub attached: [bool; 2],
}

impl Now {
    /// How far a pair is from touching \[m\].
    pub fn gap(&self, chain: &Chain, number: usize) -> f64 {
        let pair = chain.pairs()[number];
        self.places[pair.second] - self.places[pair.first] + pair.gap
    }
}

/// The series of one step, in τ = (t − t0)/h.
pub(super) struct Series {
    /// h \[s\].
    pub step: f64,
    points: usize,
    pairs: usize,
    /// Coefficients of all points, order by order: shape `ORDER + 1, N + 2`.
    places: Vec<f64>,
    /// Of speeds beside the massless line \[m/s\], as far as something is damped: shape `ORDER + 1, N + 2`.
    relative: Vec<f64>,
    /// Coefficients of what closed pairs push \[N\], order by order.
    pushes: Vec<f64>,
    forces: Vec<f64>,
    free: Vec<f64>,
    /// The force on end 2 \[N\], where that is what is prescribed.
    pub force: Polynomial,
}

/// Orders of which the acceleration is known.
pub(super) const LAST: usize = ORDER - 2;

impl Series {
    pub fn new(chain: &Chain) -> Self {
        let (points, pairs) = (chain.points(), chain.pairs().len());
        Self {
            step: 0.0,
            points,
            pairs,
            places: vec![0.0; (ORDER + 1) * points],
            relative: vec![0.0; (ORDER + 1) * points],
            pushes: vec![0.0; (ORDER + 1) * pairs],
            forces: vec![0.0; points - 2],
            free: vec![0.0; pairs],
            force: [0.0; ORDER + 1],
        }
    }

    /// Of a step of `step` \[s\] from now on.
    pub fn find(&mut self, system: &System<'_>, now: &Now, step: f64) {
        let line = self.begin(system, now, step);
        if system.is_plain(now) {
            self.follow_springs(system.chain);
            return;
        }
        self.accelerate(system, now, 0);
        for order in 1..=LAST {
            self.forces_of(system, now, order, &line);
            self.accelerate(system, now, order);
        }
        if !system.damper.is_none() {
            for order in LAST + 1..ORDER {
                self.relative_of(system.chain, order, &line);
            }
        }
    }

    /// All orders of lumps on which nothing acts but their springs, each from the last but one.
    fn follow_springs(&mut self, chain: &Chain) {
        let points = self.points;
        let inverse_masses = &chain.inverse_masses()[1..points - 1];
        let (before, after) = (&chain.stiffnesses()[..points - 2], &chain.stiffnesses()[1..points - 1]);
        for order in 0..=LAST {
            let factor = self.step * self.step / ((order + 2) * (order + 1)) as f64;
            let (found, next) = self.places.split_at_mut((order + 2) * points);
            let row = &found[order * points..][..points];
            let next = &mut next[1..points - 1];
            for lump in 0..next.len() {
                let force = after[lump] * (row[lump + 2] - row[lump + 1]) - before[lump] * (row[lump + 1] - row[lump]);
                next[lump] = factor * force * inverse_masses[lump];
            }
        }
    }

    /// Orders zero and one, and the forces at order zero.
    fn begin(&mut self, system: &System<'_>, now: &Now, step: f64) -> [Polynomial; 2] {
        self.step = step;
        let points = self.points;
        self.places[..points].copy_from_slice(&now.places);
        for (coefficient, speed) in self.places[points..2 * points].iter_mut().zip(&now.speeds) {
            *coefficient = speed * step;
        }
        let line = self.drive(system, now.time, step);
        self.forces_of(system, now, 0, &line);
        line
    }

    /// Sets the ends' series; what the ends of the massless line do.
    fn drive(&mut self, system: &System<'_>, time: f64, step: f64) -> [Polynomial; 2] {
        let [first, second] = system.drives;
        let (first, second) = (first.series(time, step), second.series(time, step));
        let last = self.points - 1;
        let mut line = [first, second];
        for order in 0..=ORDER {
            self.places[order * self.points] = first[order];
            if system.chain.is_open() {
                line[1][order] = first[order] + second[order] / system.chain.stiffness();
                self.force[order] = second[order];
                // Point of no consequence: it goes with the last lump.
                self.places[order * self.points + last] = 0.0;
            } else {
                self.places[order * self.points + last] = second[order];
            }
        }
        line
    }

    /// Forces on the lumps at an order but for those of hard contact.
    fn forces_of(&mut self, system: &System<'_>, now: &Now, order: usize, line: &[Polynomial; 2]) {
        let chain = system.chain;
        let row = &self.places[order * self.points..(order + 1) * self.points];
        let segments = chain.stiffnesses();
        let around = segments.windows(2).zip(row.windows(3));
        for (force, (stiffness, place)) in self.forces.iter_mut().zip(around) {
            *force = stiffness[1] * (place[2] - place[1]) - stiffness[0] * (place[1] - place[0]);
        }
        if !now.attached[0] {
            let base = chain.base();
            let tension = segments[base] * (row[base + 1] - row[base]);
            self.forces[base] += tension;
            if base > 0 {
                self.forces[base - 1] -= tension;
            }
        }
        if !now.attached[1] {
            let last = chain.last_segment();
            let tension = segments[last] * (row[last + 1] - row[last]);
            self.forces[last - 1] -= tension;
            if let Some(mass) = self.forces.get_mut(last) {
                *mass += tension;
            }
        }
        if chain.is_open()
            && let Some(force) = self.forces.last_mut()
        {
            *force += self.force[order];
        }
        if !system.damper.is_none() {
            self.relative_of(chain, order, line);
            let relative = &self.relative[order * self.points..(order + 1) * self.points];
            system.brake(now.attached, relative, &mut self.forces);
        }
        if let Some((stiffness, dashpots)) = &system.elastic {
            let (here, next) = self.places[order * self.points..].split_at(self.points);
            for (number, pair) in chain.pairs().iter().enumerate().filter(|(number, _)| now.closed[*number]) {
                let gap = here[pair.second] - here[pair.first] + if order == 0 { pair.gap } else { 0.0 };
                let rate = (order + 1) as f64 * (next[pair.second] - next[pair.first]) / self.step;
                let push = -stiffness * gap - dashpots[number] * rate;
                self.pushes[order * self.pairs + number] = push;
                add_push(&mut self.forces, [pair.first, pair.second], push);
            }
        }
    }

    /// Speeds beside the massless line at an order.
    fn relative_of(&mut self, chain: &Chain, order: usize, line: &[Polynomial; 2]) {
        let (begin, next) = (order * self.points, (order + 1) * self.points);
        let per_time = (order + 1) as f64 / self.step;
        let [mut first, mut second] = [line[0][order + 1], line[1][order + 1]];
        if chain.base() > 0 {
            // The spring stands on the follower, wherever the cam is.
            let follower = self.places[next + 1];
            if chain.is_open() {
                second += follower - first;
            }
            first = follower;
        }
        for (point, share) in chain.shares().iter().enumerate() {
            let straight = first + share * (second - first);
            self.relative[begin + point] = per_time * (self.places[next + point] - straight);
        }
        let last = self.points - 1;
        (self.relative[begin], self.relative[begin + last]) = (0.0, 0.0);
    }

    /// The next but one order of the lumps' places, and what hard contact pushes to hold pairs together.
    fn accelerate(&mut self, system: &System<'_>, now: &Now, order: usize) {
        let chain = system.chain;
        let factor = self.step * self.step / ((order + 2) * (order + 1)) as f64;
        if !now.bonds.is_empty() {
            for number in now.bonds.numbers() {
                let pair = chain.pairs()[number];
                let of = |point: usize| self.free_acceleration(chain, order, point);
                self.free[number] = of(pair.first) - of(pair.second);
            }
            now.bonds.solve(&mut self.free);
            for number in now.bonds.numbers() {
                let pair = chain.pairs()[number];
                self.pushes[order * self.pairs + number] = self.free[number];
                add_push(&mut self.forces, [pair.first, pair.second], self.free[number]);
            }
        }
        let next = &mut self.places[(order + 2) * self.points..(order + 3) * self.points];
        let lumps = self.forces.len();
        for ((place, force), inverse) in next[1..].iter_mut().zip(&self.forces).zip(&chain.inverse_masses()[1..=lumps])
        {
            *place = factor * force * inverse;
        }
    }

    /// Acceleration of a point without what holds pairs together; of a prescribed end that of its drive.
    fn free_acceleration(&self, chain: &Chain, order: usize, point: usize) -> f64 {
        if point == 0 || point == self.points - 1 {
            let place = self.places[(order + 2) * self.points + point];
            return place * ((order + 2) * (order + 1)) as f64 / (self.step * self.step);
        }
        self.forces[point - 1] * chain.inverse_masses()[point]
    }

    /// How the pairs would open if nothing held them together \[m/s²\], shape `pairs`.
    pub fn opening(&mut self, system: &System<'_>, now: &Now, step: f64) -> Vec<f64> {
        self.begin(system, now, step);
        let chain = system.chain;
        let pairs = chain.pairs().iter();
        pairs
            .map(|pair| self.free_acceleration(chain, 0, pair.second) - self.free_acceleration(chain, 0, pair.first))
            .collect()
    }

    /// Coefficients of all points, order by order.
    fn rows(&self) -> std::slice::ChunksExact<'_, f64> {
        self.places.chunks_exact(self.points)
    }

    /// A pair's distance beside what it is where they meet \[m\].
    pub fn gap(&self, chain: &Chain, number: usize) -> Polynomial {
        let pair = chain.pairs()[number];
        let mut gap = self.difference(pair.first, pair.second);
        gap[0] += pair.gap;
        gap
    }

    /// How far one point is from another beside the unloaded spring \[m\].
    pub fn difference(&self, first: usize, second: usize) -> Polynomial {
        let mut difference = [0.0; ORDER + 1];
        for (order, value) in difference.iter_mut().enumerate() {
            let row = order * self.points;
            *value = self.places[row + second] - self.places[row + first];
        }
        difference
    }

    /// What a closed pair pushes \[N\].
    pub fn push(&self, number: usize) -> Polynomial {
        let mut push = [0.0; ORDER + 1];
        for (order, value) in push.iter_mut().enumerate().take(LAST + 1) {
            *value = self.pushes[order * self.pairs + number];
        }
        push
    }

    /// Of a point's speed beside the massless line \[m/s\].
    pub fn relative(&self, point: usize) -> Polynomial {
        let mut relative = [0.0; ORDER + 1];
        for (order, value) in relative.iter_mut().enumerate().take(ORDER) {
            *value = self.relative[order * self.points + point];
        }
        relative
    }

    /// A point's place \[m\].
    pub fn place(&self, point: usize) -> Polynomial {
        let mut place = [0.0; ORDER + 1];
        for (order, value) in place.iter_mut().enumerate() {
            *value = self.places[order * self.points + point];
        }
        place
    }

    /// Bounds of every pair's distance from below over the whole step, shape `pairs`: the first term less all that is below zero.
    pub fn least_gaps(&self, chain: &Chain, least: &mut [f64]) {
        for (least, pair) in least.iter_mut().zip(chain.pairs()) {
            *least = self.places[pair.second] - self.places[pair.first] + pair.gap;
        }
        let rows = self.rows().skip(1);
        if let Some(ends) = chain.neighbours() {
            let begun = nearing::<8>(&rows, ends, 0, least);
            let begun = nearing::<4>(&rows, ends, begun, least);
            nearing::<1>(&rows, ends, begun, least);
            return;
        }
        for row in rows {
            for (least, pair) in least.iter_mut().zip(chain.pairs()) {
                *least += (row[pair.second] - row[pair.first]).min(0.0);
            }
        }
    }

    /// Places and speeds of all points at τ, written over those of `now`.
    pub fn advance(&self, tau: f64, now: &mut Now) {
        let begun = self.with_rates::<8>(0, tau, now);
        let begun = self.with_rates::<4>(begun, tau, now);
        self.with_rates::<1>(begun, tau, now);
        now.speeds.iter_mut().for_each(|speed| *speed /= self.step);
        now.time += tau * self.step;
    }

    /// Places of points from `first` on at τ and their rates, so many side by side as long as there are; the next point then.
    fn with_rates<const MANY: usize>(&self, mut first: usize, tau: f64, now: &mut Now) -> usize {
        let rows = self.rows();
        while let Some((places, rates)) =
            now.places[first..].first_chunk_mut::<MANY>().zip(now.speeds[first..].first_chunk_mut::<MANY>())
        {
            // Kept here, they need not go through memory from row to row.
            let (mut sums, mut slopes) = ([0.0; MANY], [0.0; MANY]);
            for row in rows.clone().rev() {
                for ((sum, slope), coefficient) in sums.iter_mut().zip(&mut slopes).zip(&row[first..first + MANY]) {
                    *slope = *slope * tau + *sum;
                    *sum = *sum * tau + coefficient;
                }
            }
            (*places, *rates) = (sums, slopes);
            first += MANY;
        }
        first
    }

    /// Places of all points at τ \[m\], shape `N + 2`.
    pub fn places_at(&self, tau: f64, places: &mut [f64]) {
        horner(self.rows().rev(), tau, places);
    }

    /// All points' speeds beside the massless line at τ \[m/s\].
    pub fn relative_at(&self, tau: f64, relative: &mut [f64]) {
        horner(self.relative.chunks_exact(self.points).take(ORDER).rev(), tau, relative);
    }

    /// All points' speeds at τ \[m/s\].
    pub fn speeds_at(&self, tau: f64, speeds: &mut [f64]) {
        speeds.fill(0.0);
        for (order, row) in self.rows().enumerate().skip(1).rev() {
            let per_time = order as f64 / self.step;
            for (speed, coefficient) in speeds.iter_mut().zip(row) {
                *speed = *speed * tau + per_time * coefficient;
            }
        }
    }
}

/// Adds to bounds of pairs from `number` on all by which these can come nearer, so many side by side as long as there are; the next pair then. The
/// first pair is of points `first` and `second`, the next of the next ones.
fn nearing<'a, const MANY: usize>(
    rows: &(impl Iterator<Item = &'a [f64]> + Clone),
    [first, second]: [usize; 2],
    mut number: usize,
    least: &mut [f64],
) -> usize {
    while let Some(least) = least[number..].first_chunk_mut::<MANY>() {
        let mut sums = *least;
        for row in rows.clone() {
            let both = row[first + number..][..MANY].iter().zip(&row[second + number..][..MANY]);
            for (sum, (before, after)) in sums.iter_mut().zip(both) {
                *sum += (after - before).min(0.0);
            }
        }
        *least = sums;
        number += MANY;
    }
    number
}

/// Polynomials of many points at τ, by rows of their coefficients from the highest power on.
fn horner<'a>(rows: impl Iterator<Item = &'a [f64]>, tau: f64, values: &mut [f64]) {
    values.fill(0.0);
    for row in rows {
        for (value, coefficient) in values.iter_mut().zip(row) {
            *value = *value * tau + coefficient;
        }
    }
}

/// Adds a push between two points to the forces on lumps.
fn add_push(forces: &mut [f64], [first, second]: [usize; 2], push: f64) {
    if first > 0 {
        forces[first - 1] -= push;
    }
    if second <= forces.len() {
        forces[second - 1] += push;
    }
}
