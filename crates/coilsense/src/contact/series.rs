//! One step: the points' motion as power series in time, exact to rounding while no pair meets or parts.
//!
//! Next door: how the ends move (`drive`), where a series falls through zero (`polynomial`), what happens then (`follow`).

use super::bonds::Bonds;
use super::chain::Chain;
use super::coefficients::Coefficients;
use super::damper::Damper;
use super::drive::Drive;
use super::polynomial::{ORDER, Polynomial};

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
    pub bonds: Bonds,
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
    places: Coefficients,
    /// Speeds beside the massless line \[m/s\], as far as something is damped.
    relative: Coefficients,
    /// What closed pairs push \[N\].
    pushes: Coefficients,
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
            places: Coefficients::new(points),
            relative: Coefficients::new(points),
            pushes: Coefficients::new(pairs),
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
        for order in 0..=LAST {
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
            let (row, next) = self.places.row_and_next_but_one(order);
            let next = &mut next[1..points - 1];
            for lump in 0..next.len() {
                let force = after[lump] * (row[lump + 2] - row[lump + 1]) - before[lump] * (row[lump + 1] - row[lump]);
                next[lump] = factor * force * inverse_masses[lump];
            }
        }
    }

    /// Orders zero and one; what the ends of the massless line do.
    fn begin(&mut self, system: &System<'_>, now: &Now, step: f64) -> [Polynomial; 2] {
        self.step = step;
        self.places.row_mut(0).copy_from_slice(&now.places);
        for (coefficient, speed) in self.places.row_mut(1).iter_mut().zip(&now.speeds) {
            *coefficient = speed * step;
        }
        self.drive(system, now.time, step)
    }

    /// Sets the ends' series; what the ends of the massless line do.
    fn drive(&mut self, system: &System<'_>, time: f64, step: f64) -> [Polynomial; 2] {
        let [first, second] = system.drives;
        let (first, second) = (first.series(time, step), second.series(time, step));
        let last = self.points - 1;
        let mut line = [first, second];
        for order in 0..=ORDER {
            let row = self.places.row_mut(order);
            row[0] = first[order];
            if system.chain.is_open() {
                line[1][order] = first[order] + second[order] / system.chain.stiffness();
                self.force[order] = second[order];
                // Point of no consequence: it goes with the last lump.
                row[last] = 0.0;
            } else {
                row[last] = second[order];
            }
        }
        line
    }

    /// Forces on the lumps at an order but for those of hard contact.
    fn forces_of(&mut self, system: &System<'_>, now: &Now, order: usize, line: &[Polynomial; 2]) {
        let chain = system.chain;
        let row = self.places.row(order);
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
            system.brake(now.attached, self.relative.row(order), &mut self.forces);
        }
        if let Some((stiffness, dashpots)) = &system.elastic {
            let (here, next) = (self.places.row(order), self.places.row(order + 1));
            for (number, pair) in chain.pairs().iter().enumerate().filter(|(number, _)| now.closed[*number]) {
                let gap = here[pair.second] - here[pair.first] + if order == 0 { pair.gap } else { 0.0 };
                let rate = (order + 1) as f64 * (next[pair.second] - next[pair.first]) / self.step;
                let push = -stiffness * gap - dashpots[number] * rate;
                self.pushes.row_mut(order)[number] = push;
                add_push(&mut self.forces, [pair.first, pair.second], push);
            }
        }
    }

    /// Speeds beside the massless line at an order.
    fn relative_of(&mut self, chain: &Chain, order: usize, line: &[Polynomial; 2]) {
        let (relative, next) = (self.relative.row_mut(order), self.places.row(order + 1));
        let per_time = (order + 1) as f64 / self.step;
        let [mut first, mut second] = [line[0][order + 1], line[1][order + 1]];
        if chain.base() > 0 {
            // The spring stands on the follower, wherever the cam is.
            let follower = next[1];
            if chain.is_open() {
                second += follower - first;
            }
            first = follower;
        }
        for (point, share) in chain.shares().iter().enumerate() {
            let straight = first + share * (second - first);
            relative[point] = per_time * (next[point] - straight);
        }
        let last = self.points - 1;
        (relative[0], relative[last]) = (0.0, 0.0);
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
                self.pushes.row_mut(order)[number] = self.free[number];
                add_push(&mut self.forces, [pair.first, pair.second], self.free[number]);
            }
        }
        let next = self.places.row_mut(order + 2);
        let lumps = self.forces.len();
        for ((place, force), inverse) in next[1..].iter_mut().zip(&self.forces).zip(&chain.inverse_masses()[1..=lumps])
        {
            *place = factor * force * inverse;
        }
    }

    /// Acceleration of a point without what holds pairs together; of a prescribed end that of its drive.
    fn free_acceleration(&self, chain: &Chain, order: usize, point: usize) -> f64 {
        if point == 0 || point == self.points - 1 {
            let place = self.places.row(order + 2)[point];
            return place * ((order + 2) * (order + 1)) as f64 / (self.step * self.step);
        }
        self.forces[point - 1] * chain.inverse_masses()[point]
    }

    /// How the pairs would open if nothing held them together \[m/s²\], shape `pairs`.
    pub fn opening(&mut self, system: &System<'_>, now: &Now, step: f64) -> Vec<f64> {
        let line = self.begin(system, now, step);
        self.forces_of(system, now, 0, &line);
        let chain = system.chain;
        let pairs = chain.pairs().iter();
        pairs
            .map(|pair| self.free_acceleration(chain, 0, pair.second) - self.free_acceleration(chain, 0, pair.first))
            .collect()
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
        self.places.difference(first, second)
    }

    /// What a closed pair pushes \[N\].
    pub fn push(&self, number: usize) -> Polynomial {
        self.pushes.of(number)
    }

    /// Of a point's speed beside the massless line \[m/s\].
    pub fn relative(&self, point: usize) -> Polynomial {
        self.relative.of(point)
    }

    /// A point's place \[m\].
    pub fn place(&self, point: usize) -> Polynomial {
        self.places.of(point)
    }

    /// Bounds of every pair's distance from below over the whole step, shape `pairs`: the first term less all that is below zero.
    pub fn least_gaps(&self, chain: &Chain, least: &mut [f64]) {
        let here = self.places.row(0);
        for (least, pair) in least.iter_mut().zip(chain.pairs()) {
            *least = here[pair.second] - here[pair.first] + pair.gap;
        }
        match chain.neighbours() {
            Some(ends) => self.places.add_falls(ends, least),
            None => self.places.add_falls_between(chain.pairs().iter().map(|pair| [pair.first, pair.second]), least),
        }
    }

    /// Places and speeds of all points at τ, written over those of `now`.
    pub fn advance(&self, tau: f64, now: &mut Now) {
        self.places.with_rates(tau, &mut now.places, &mut now.speeds);
        now.speeds.iter_mut().for_each(|speed| *speed /= self.step);
        now.time += tau * self.step;
    }

    /// Places of all points at τ \[m\], shape `N + 2`.
    pub fn places_at(&self, tau: f64, places: &mut [f64]) {
        self.places.at(tau, places);
    }

    /// All points' speeds beside the massless line at τ \[m/s\].
    pub fn relative_at(&self, tau: f64, relative: &mut [f64]) {
        self.relative.at(tau, relative);
    }

    /// All points' speeds at τ \[m/s\].
    pub fn speeds_at(&self, tau: f64, speeds: &mut [f64]) {
        self.places.rates_at(tau, self.step, speeds);
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
