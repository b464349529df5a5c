//! A commented spec to start from: `coilsense init`.
//!
//! Next door: every key (`keys`), the springs that it can start from (`data/springs`).

use super::SpecError;

/// Springs of the paper.
const SPRINGS: [(&str, &str); 2] =
    [("S_T", include_str!("../../data/springs/S_T.toml")), ("S_A", include_str!("../../data/springs/S_A.toml"))];

/// How a spec of one's own begins.
const HEAD: &str = r"# A spec of coilsense. Every key is described in book/src/guide/spec.md. Change what differs, delete what you do not need, then run
#   coilsense spring FILE       the spring's data sheet
#   coilsense analyze FILE --out DIR

";

/// The name of the compression spring.
const PRESSED_NAME: &str = "pressed";

/// A compression spring by geometry, as a beginning of one's own.
const PRESSED: &str = r#"[spring]
name = "my spring"
rest_length = "60 mm"       # length without force
min_length = "36 mm"        # range in use; solid at 24 mm
max_length = "52 mm"        # or from a preload F: rest_length less F/k, k of the data sheet
windings = 6                # active ones; with end turns that lie flat the coil has two more, or give total_windings
wire_diameter = "3 mm"
coil_diameter = "22 mm"     # mean diameter, wire centre to wire centre
end_type = "closed-ground"  # closed-ground, closed, open-ground, open
material = "steel EN 10270-1" # or shear_modulus = "81.5 GPa", density = "7850 kg/m3", …
wire_diameter_tolerance = "1 %" # as a maker gives them; with all four the rate is known within 5.4 %. Or, of a rate that was measured
coil_diameter_tolerance = "1 %" # in use: stiffness_tolerance = "0.5 %" and stiffness_at = "range" in their place
windings_tolerance = "0.5 %"
shear_modulus_tolerance = "2 %"
# Known stiffness and mass? Then give, in place of wire_diameter, coil_diameter and material:
# stiffness = "12.9 kN/m"
# mass = "23 g"
# coil_radius = "11 mm"
# wire_radius = "1.5 mm"

# What windings do when they meet, and ends that can only push: without this table they pass through one another, and a warning says so.
# [contact]
# windings = "hard"
"#;

/// An extension spring by geometry, as a beginning of one's own.
const OWN: &str = r#"[spring]
name = "my spring"
rest_length = "104 mm"      # length without force
min_length = "196 mm"       # range in use
max_length = "264 mm"
windings = 52               # active ones
wire_diameter = "2 mm"
coil_diameter = "16 mm"     # mean diameter, wire centre to wire centre
end_type = "hooks"          # hooks, open, open-ground, closed, closed-ground
material = "steel EN 10270-1" # or shear_modulus = "81.5 GPa", density = "7850 kg/m3", …
wire_diameter_tolerance = "1 %" # as a maker gives them; with all four the rate is known within 5.4 %. Or, of a rate that was measured:
coil_diameter_tolerance = "1 %" # stiffness_tolerance = "0.5 %" in their place
windings_tolerance = "0.5 %"
shear_modulus_tolerance = "2 %"
# initial_tension = "5 N"   # of a close-wound extension spring
# Known stiffness and mass? Then give, in place of wire_diameter, coil_diameter and material:
# stiffness = "760 N/m"
# mass = "65 g"
# coil_radius = "8 mm"
# wire_radius = "1 mm"
"#;

/// What comes after the spring.
const REST: &str = r#"
[mount]
end2 = "held"               # or "force", or "mass" with end_mass = "2 kg"
# damping_ratio = 0.005     # without it: results for 0 (the paper's case), 0.001, 0.005 and 0.02

[[condition]]
name = "heel strike"
kind = "impact"             # both ends stop dead while the windings still move
length = "mid"
velocity = "0.25 m/s"
duration = "1 s"
window = ["0.75 s", "1 s"]  # the part that is judged; with damping take ["0 s", "0.25 s"], or the ringing is over
sample_rate = "10 kHz"

[[condition]]
name = "end stop max"
kind = "end-stop"           # stopped at an end of the range, traversed in 1 s; or give velocity
at = "max"
duration = "1 s"
window = ["0.75 s", "1 s"]

[[condition]]
name = "end stop min"
kind = "end-stop"
at = "min"
profile = "uniform"         # all windings at one speed, as in the paper's tables; its text says "linear", from 0 at end 1
duration = "1 s"
window = ["0.75 s", "1 s"]

[[condition]]
name = "half resonance"
kind = "harmonic"
frequency = "0.5 f1"        # f1 is the first surge frequency
amplitude = "1 %"           # of the range in use
phase = "-90 deg"
start = "massless"
duration = "1 s"
window = ["0.75 s", "1 s"]

[[condition]]
name = "resonance"
kind = "harmonic"
frequency = "1 f1"
amplitude = "0.1 %"
phase = "-90 deg"
start = "massless"
duration = "1 s"
window = ["0.75 s", "1 s"]

[[sensor]]
name = "load cell, motor side"
kind = "load-cell"
end = 1
bandwidth = "1 kHz"
sample_rate = "2.5 kHz"
noise = "0.02 %"            # of its range
accuracy_full_scale = "0.1 %"

[[sensor]]
name = "load cell, load side"
kind = "load-cell"
end = 2
bandwidth = "1 kHz"
sample_rate = "2.5 kHz"
noise = "0.02 %"
accuracy_full_scale = "0.1 %"

[[sensor]]
name = "laser"
kind = "deflection"
sample_rate = "2.5 kHz"
resolution = "10 um"
accuracy_full_scale = "0.1 %"

[[sensor]]
name = "LCR meter"
kind = "inductance"
averaging = "20 ms"
accuracy_reading = "0.05 %"

[goal]
error = "1 %"               # of F_nom, as standard uncertainty
bandwidth = "20 Hz"         # up to where the force is wanted

# Which force may be fed back, and how fast? Take the first # of each line below away, then: coilsense placement
# [control]
# drive = "velocity"          # a motor behind a velocity loop; or "force" with motor_mass
# drive_bandwidth = "60 Hz"   # of that loop; without this line it follows at once
# sample_time = "1 ms"        # of the controller; without this line it is continuous
# delay = "1 ms"              # from a reading to the command that follows from it
"#;

/// A commented spec with a spring of the paper (`S_T`, `S_A`), or with one by geometry: a compression spring (`pressed`), else an extension spring.
///
/// # Errors
/// [`SpecError`] for a name that is not there.
pub fn template(from: Option<&str>) -> Result<String, SpecError> {
    let own = match from {
        None => OWN,
        Some(PRESSED_NAME) => PRESSED,
        Some(from) => {
            let found = SPRINGS.iter().find(|(name, _)| *name == from);
            let names = SPRINGS.map(|(name, _)| name).join(", ");
            let unknown = || SpecError(format!("{from}: no spring of that name; there are {names}, {PRESSED_NAME}"));
            return found.map(|(_, spring)| format!("{spring}{REST}")).ok_or_else(unknown);
        }
    };
    Ok(format!("{HEAD}{own}{REST}"))
}
