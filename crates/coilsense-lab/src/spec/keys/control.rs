//! Keys of `[control]`.

use super::{Table, needed, optional, told};

const FORCE: &[&str] = &["force"];

pub(super) const CONTROL: Table = Table {
    name: "control",
    repeats: false,
    meaning: told(
        "The force loop of `coilsense placement`: a drive that pulls at end 1, a controller K (1 + 1/(T_I s) + T_D s/(1 + T_D s/10)) from force \
              error to the drive's command, and what end 2 meets.",
    ),
    keys: &[
        needed(
            "drive",
            "\"velocity\"",
            "`\"velocity\"` (the command is a velocity) or `\"force\"` (a force on the motor's mass)",
        ),
        optional("drive_bandwidth", "\"80 Hz\"", "−3 dB of the drive's own first-order loop", "ideal"),
        needed("motor_mass", "\"2 kg\"", "motor mass seen at end 1: rotor inertia times the square of the gear ratio")
            .of(FORCE),
        optional("motor_friction", "\"30 N s/m\"", "viscous friction seen at end 1", "none").of(FORCE),
        optional(
            "controller",
            "\"PI\"",
            "`\"P\"`, `\"PI\"` or `\"PID\"`",
            "`\"P\"` of a velocity drive, where it is integral force control; `\"PI\"` of a force drive",
        ),
        optional("integral_time", "\"0.1 s\"", "T_I of PI and PID", "0.1 s"),
        optional("derivative_time", "\"10 ms\"", "T_D of PID", "10 ms"),
        optional("feed_forward", "1", "share of the reference that goes to the command directly", "none").of(FORCE),
        optional(
            "observer_bandwidth",
            "\"2 Hz\"",
            "−6 dB of a disturbance observer's second-order filter",
            "no observer",
        ),
        optional(
            "crossover",
            "\"5 Hz\"",
            "the crossover wanted, with a spring without mass",
            "the fastest with a sensitivity of at most 2 and no end force above 3 times its static response; where there is none, the fastest with that sensitivity",
        ),
        optional(
            "delay",
            "\"1 ms\"",
            "of controller and drive, from a force that is read to the command; what the sensors of the spec lag is added. With a sample time a whole number of them",
            "none",
        ),
        optional("sample_time", "\"0.5 ms\"", "of a controller that holds its command in between", "continuous"),
        optional("load_mass", "\"1 kg\"", "mass on end 2", "as `[mount]` has it"),
        optional("load_damping", "\"5 N s/m\"", "damper from end 2 to the ground", "none"),
        optional("load_stiffness", "\"500 N/m\"", "spring from end 2 to the ground", "none"),
        optional(
            "passive_up_to",
            "\"50 Hz\"",
            "up to where the rendered impedance is looked at",
            "the first surge frequency",
        ),
    ],
};
