//! What a chain whose windings meet has done.
//!
//! Next door: how it is followed (`follow`), who asks (the parent).

/// A chain's course over time.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// F_i at the samples that were reached \[N\], tension positive; what a seat gets in an instant is in [`Self::touches`].
    pub input: Vec<f64>,
    /// F_o, likewise \[N\].
    pub output: Vec<f64>,
    /// Displacements of end 1 at the same samples \[m\]: what is prescribed, or where a follower is.
    pub end1: Vec<f64>,
    /// What a cam pushes its follower with \[N\]; empty without one.
    pub cam_force: Vec<f64>,
    /// Displacements of end 2 from the unloaded spring at the same samples \[m\]: what is prescribed, or what follows.
    pub end2: Vec<f64>,
    /// Displacements of the lumps from the unloaded spring \[m\], shape `samples, N`; empty where they were not asked for.
    pub places: Vec<f64>,
    /// Least and largest tension in the wire of each segment at these samples \[N\], its stiffness times its stretch, from end 1 on; what touching windings
    /// press on each other with goes past the wire. Empty where it was not asked for.
    pub tensions: Vec<[f64; 2]>,
    /// What met, in the order in which it did.
    pub touches: Vec<Touch>,
    /// When an end that is not held left its seat, and when it came back.
    pub lifts: Vec<Lift>,
    /// When a follower left its cam, and when it came back.
    pub floats: Vec<Float>,
    /// The energy of all of it.
    pub balance: Balance,
    /// Up to when it was followed \[s\].
    pub until: f64,
    /// Why not to the end.
    pub given_up: Option<GivenUp>,
    /// The smallest distance of a hard pair at a sample's step or an event \[m\]: how far rounding lets windings overlap, below zero.
    pub deepest: f64,
    /// How many times something met, parted, left or came back.
    pub events: usize,
}

/// Two points that met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// Their numbers: 0 is end 1, i lump i, N + 1 end 2.
    pub points: [usize; 2],
    /// When \[s\].
    pub time: f64,
    /// How fast they came together \[m/s\].
    pub closing_speed: f64,
    /// When they parted \[s\]; `None` where they had not by the end.
    pub parted: Option<f64>,
    /// What they gave each other in no time \[N s\], when they met and when others met beside them; zero of what gives way.
    pub impulse: f64,
    /// What they gave each other while they were together \[N s\].
    pub pressed: f64,
    /// The largest force between them at a sample, a meeting or a parting \[N\]. Of hard windings without the meeting itself; of those that give way it grows with
    /// the root of their stiffness.
    pub peak: f64,
    /// Energy that went there \[J\]; what is lost where end turns settle on a follower, some 1e-9 J each time, is in the balance alone.
    pub lost: f64,
}

/// An end that left its seat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lift {
    /// Whether that is end 2.
    pub is_end2: bool,
    /// When it left \[s\].
    pub time: f64,
    /// When it was back \[s\]; `None` where it was not by the end.
    pub back: Option<f64>,
}

/// A follower that left its cam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Float {
    /// When \[s\].
    pub time: f64,
    /// When it was back \[s\]; `None` where it was not by the end.
    pub back: Option<f64>,
    /// How fast it came down on the cam \[m/s\].
    pub closing_speed: f64,
    /// What the cam gave it then \[N s\].
    pub impulse: f64,
}

/// Where energy came from and went \[J\].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Balance {
    /// What the ends put in, less what they took.
    pub work: f64,
    /// The same, all of it counted up: what the rest is measured by.
    pub moved: f64,
    /// What meeting windings lost.
    pub lost: f64,
    /// What damping took.
    pub damped: f64,
    /// What the chain holds more at the end than at the begin, moving and strained.
    pub gained: f64,
}

impl Balance {
    /// What does not add up \[J\].
    pub fn open(&self) -> f64 {
        self.work - self.lost - self.damped - self.gained
    }
}

/// Why a course was not followed to its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GivenUp {
    /// More happened than was allowed.
    TooManyEvents,
    /// All windings lie on one another between two ends that go on closing: no force would stop them.
    Solid,
}
