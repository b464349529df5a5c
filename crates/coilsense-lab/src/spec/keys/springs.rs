//! Keys of `[spring]` and `[mount]`.

use super::{Table, needed, optional, told};

/// The ways to describe a spring.
const BY_VALUES: &str = "by values";
/// By wire, coil and material.
pub(crate) const BY_GEOMETRY: &str = "by geometry";
/// By sections of a coil that is not uniform.
pub(crate) const BY_SECTIONS: &str = "by sections";
/// The key under which these stand.
pub(crate) const SECTIONS: &str = "section";
/// Of several springs, all but the first.
pub(crate) const BESIDE: &str = "beside the first";
const TABLE_I: &[&str] = &[BY_VALUES];
const GEOMETRY: &[&str] = &[BY_GEOMETRY];
const OTHERS: &[&str] = &[BESIDE];
/// Of a coil that is the same all along.
const UNIFORM: &[&str] = &[BY_VALUES, BY_GEOMETRY];

/// The way by which the keys that a table `has` describe a spring.
pub(crate) fn way(has: impl Fn(&str) -> bool) -> &'static str {
    if has(SECTIONS) {
        BY_SECTIONS
    } else if has("wire_diameter") || has("coil_diameter") {
        BY_GEOMETRY
    } else {
        BY_VALUES
    }
}

pub(super) const SPRING: Table = Table {
    name: "spring",
    repeats: false,
    meaning: told(
        "The spring, either *by values* (stiffness, mass, radii, as in Table I of the paper) or *by geometry* (wire, coil and material); \
              the presence of `wire_diameter` or `coil_diameter` means the latter. A coil that is not the same all along is given *by sections*, \
              tables `[[spring.section]]` below. Several springs between the same two ends (nested, side by side, pulling against one another) are tables \
              `[[spring]]`, each with a name of its own: conditions are about the first, and what moves its ends moves those of all. For `simulate` and \
              `sweep`; springs that rub against one another are not in the model.",
    ),
    keys: &[
        needed("name", "\"S_T\"", "what people call it"),
        optional(
            "side",
            "\"same\"",
            "of a spring beside the first: `same`, it gets longer where the first does and pulls the same way, or `opposite`, it gets as much shorter and \
               pulls the other way",
            "`same`",
        )
        .of(OTHERS),
        optional(
            "length_at_mid",
            "\"230 mm\"",
            "of a spring beside the first: its length where the first is at the middle of its range in use, by which it is pretensioned",
            "`same`: as long as the first; `opposite`: the middle of its own range",
        )
        .of(OTHERS),
        needed(
            "rest_length",
            "\"104 mm\"",
            "l0, the length without force (of an extension spring with initial tension: its closed length)",
        )
        .of(UNIFORM),
        needed(
            "min_length",
            "\"196 mm\"",
            "shortest length in use, at least the solid length: of hooks n_t·d from wire centre to wire centre (over the outside a body is \
               one d longer), with initial tension the closed length; of seats (n_t + 1)·d, ground n_t·d",
        ),
        needed(
            "max_length",
            "\"264 mm\"",
            "longest length in use; with ends that can only be pushed (`open`, `closed`, ground) at most `rest_length`",
        ),
        needed("windings", "52", "N, active windings; may be fractional").of(UNIFORM),
        needed("stiffness", "\"760 N/m\"", "k").of(TABLE_I),
        needed("mass", "\"65 g\"", "m, of the active windings").of(TABLE_I),
        needed("coil_radius", "\"8 mm\"", "r, from the axis to the centre of the wire").of(TABLE_I),
        needed("wire_radius", "\"1 mm\"", "rho, half of the wire's diameter").of(TABLE_I),
        needed("wire_diameter", "\"2 mm\"", "d").of(GEOMETRY),
        needed("coil_diameter", "\"16 mm\"", "D, mean diameter, from wire centre to wire centre").of(GEOMETRY),
        optional(
            "total_windings",
            "54",
            "with those that end 1 and end 2 rest on",
            "`windings` and what `end_type` adds: 2 if closed, 1 if open and ground; of a spring by values `windings` alone",
        )
        .of(UNIFORM),
        optional(
            "end_type",
            "\"closed-ground\"",
            "`hooks`, `open`, `open-ground`, `closed` or `closed-ground`; only hooks can be pulled",
            "`hooks`",
        ),
        optional(
            "material",
            "\"steel EN 10270-1\"",
            "a name of the material table (`coilsense spring --materials` lists it)",
            "`steel EN 10270-1`",
        ),
        optional(
            "model",
            "\"coil\"",
            "what stands for the coil in its motion along the axis: `coil`, a chain of masses with the first surge frequency of the coil as a helix \
               (at mid range, with its ends as `[mount]` has them); `chain`, the paper's chain with the spring's own mass; or `helix`, every mode of the \
               coil (axial, torsional, sideways) about the mean length of a condition, for `simulate` and `analyze`",
            "`coil`",
        )
        .of(UNIFORM),
        optional(
            "hand",
            "\"right\"",
            "the sense in which the wire is wound, `right` or `left`: the sign of couples",
            "`right`",
        )
        .of(UNIFORM),
        optional(
            "stiffness_at",
            "\"range\"",
            "what k is to the wire: `range`, the slope of the force at the middle of the range in use, or `flat`, that of the flat coil, \
               G d⁴/8 D³ n. E and G of the helix are brought to it",
            "`range`; of a spring by geometry `flat`",
        )
        .of(UNIFORM),
        optional("shear_modulus", "\"81.5 GPa\"", "G, in place of the material's", "the material's"),
        optional("youngs_modulus", "\"206 GPa\"", "E, in place of the material's", "the material's"),
        optional("density", "\"7850 kg/m3\"", "in place of the material's", "the material's"),
        optional(
            "shear_modulus_temperature",
            "\"-0.025 %/K\"",
            "(dG/dT)/G, in place of the material's",
            "the material's, else 0",
        ),
        optional("resistivity", "\"0.18 uOhm m\"", "of the wire, in place of the material's", "the material's"),
        optional(
            "relative_permeability",
            "2.5",
            "of the wire, in place of the material's; drawn stainless wire was measured at 1 to 3 (`coilsense calibrate --theory steel` finds it)",
            "the material's",
        ),
        optional("relative_permeability_tolerance", "\"15 %\"", "how far that may be off, either way", "none"),
        optional(
            "initial_tension",
            "\"5 N\"",
            "F_0, what a close-wound extension spring pulls before it opens",
            "`\"0 N\"`",
        )
        .of(UNIFORM),
        optional(
            "nominal_force",
            "\"121.6 N\"",
            "F_nom, to which errors are related",
            "eq. (14): the largest static force in use",
        ),
        optional("inductance_windings", "51.5", "windings that carry the current", "`windings`"),
        optional(
            "self_distance",
            "\"as-printed\"",
            "self term of a winding: `as-printed` (eq. 10) or `geometric-mean` (Maxwell)",
            "`as-printed`",
        ),
        optional(
            "stiffness_tolerance",
            "\"5 %\"",
            "how far k may be off, either way",
            "by geometry from the tolerances below, else none: the rate is then taken as exact, and `analyze` says so",
        ),
        optional(
            "mass_tolerance",
            "\"2 %\"",
            "how far m may be off, either way",
            "by geometry from the tolerances below, else none",
        ),
        optional(
            "initial_tension_tolerance",
            "\"10 %\"",
            "how far F_0 may be off, either way; the tolerance of k does not act on it",
            "none",
        )
        .of(UNIFORM),
        optional("rest_length_tolerance", "\"0.5 mm\"", "how far l0 may be off, either way", "none"),
        optional("wire_diameter_tolerance", "\"0.5 %\"", "how far d may be off, either way", "none").of(GEOMETRY),
        optional("coil_diameter_tolerance", "\"1 %\"", "how far D may be off, either way", "none").of(GEOMETRY),
        optional("windings_tolerance", "\"0.5 %\"", "how far n may be off, either way", "none").of(GEOMETRY),
        optional("shear_modulus_tolerance", "\"1 %\"", "how far G may be off, either way", "none").of(GEOMETRY),
        optional("density_tolerance", "\"0.5 %\"", "how far the wire's density may be off, either way", "none")
            .of(GEOMETRY),
        optional(
            "endurance_shear_strength",
            "\"300 MPa\"",
            "amplitude of the shear stress that the wire bears for ever about a mean of zero; with `ultimate_shear_strength`, for the Goodman factor of \
               `coilsense speed`",
            "none: no factor is given",
        ),
        optional(
            "ultimate_shear_strength",
            "\"1100 MPa\"",
            "shear stress at which the wire breaks; with `endurance_shear_strength`",
            "none: no factor is given",
        ),
        optional(
            "masses_per_winding",
            "4",
            "masses of the chain for each winding, 1 (the paper's chain) to 64",
            "as many as it takes for no rms to move by more than 0.5 % when they are doubled, 32 at most",
        ),
    ],
};

pub(super) const SECTION: Table = Table {
    name: "spring.section",
    repeats: true,
    meaning: told(
        "A stretch of a coil that is not the same all along, from end 1 on: progressive, barrel-shaped, conical, beehive. What has two values in a \
              list changes evenly along the wire, from the end nearer to end 1 to the other. Closed ends are sections with the pitch of the wire's \
              diameter; those at the ends lie on their seats and do not move. Length, rate, mass and the static curve follow from the sections; \
              windings that close within the range in use take a table `[contact]`. Axial motion only, as a chain. For `spring`, `simulate`, \
              `analyze`, `sweep` and `speed`.",
    ),
    keys: &[
        needed("windings", "4.5", "of this section; may be fractional"),
        needed(
            "pitch",
            "\"8 mm\"",
            "from winding to winding, centre to centre, unloaded; or `[\"4 mm\", \"8 mm\"]`. In its place `gap`",
        ),
        optional(
            "gap",
            "\"4 mm\"",
            "from wire to wire, in place of `pitch`: the wire's diameter less; likewise of two values",
            "by `pitch`",
        ),
        needed("coil_diameter", "\"25 mm\"", "D, mean diameter; or of two values"),
        needed("wire_diameter", "\"4 mm\"", "d"),
        optional(
            "telescopes",
            "true",
            "whether a winding goes inside the next: it then closes where its pitch is used up, not where wires meet",
            "`false`",
        ),
    ],
};

const MASS: &[&str] = &["mass"];

pub(super) const MOUNT: Table = Table {
    name: "mount",
    repeats: false,
    meaning: told(
        "What end 2 is tied to, and what damps the windings. End 1 always has a prescribed position, but for a \
              `follower_mass`. Without any damping key every result is \
              given for ζ = 0 (the paper's case), 0.001, 0.005 and 0.02: no measured range of ζ for coil springs is known.",
    ),
    keys: &[
        optional(
            "end2",
            "\"held\"",
            "`held` (a prescribed position), `force` (a prescribed force) or `mass`",
            "`held`",
        ),
        needed("end_mass", "\"2 kg\"", "the mass at end 2").of(MASS),
        optional(
            "follower_mass",
            "\"110 g\"",
            "a mass at end 1 that the input pushes as a cam does, and cannot pull: a valve with its tappet. Where it would have to be pulled it flies, \
               and comes down without a rebound; a recorded input then is a smooth curve through its samples. Takes a table `[contact]` with hard windings",
            "none: end 1 is where the input has it",
        ),
        optional(
            "ends_tilt",
            "\"between\"",
            "whether the ends may tilt: `held` (flat seats), `free` (pins, balls) or `between` (not known, or something gives: both are looked at). \
               Sideways and torsional modes hang on it, the axial model does not",
            "`held` for ends that are closed and ground, `between` for others",
        ),
        optional(
            "ends_turn",
            "\"held\"",
            "whether the ends may turn about the spring's axis, in the same words",
            "`held`",
        ),
        optional("end1_tilt", "\"held\"", "the same of end 1 alone", "`ends_tilt`"),
        optional("end2_tilt", "\"free\"", "the same of end 2 alone", "`ends_tilt`"),
        optional("end1_turn", "\"held\"", "the same of end 1 alone", "`ends_turn`"),
        optional("end2_turn", "\"free\"", "the same of end 2 alone", "`ends_turn`"),
        optional(
            "misalignment",
            "\"1 deg\"",
            "angle between the spring's axis and that of a load cell: the data sheet then says what the cell reads of each mode with its side force",
            "`\"0 deg\"`",
        ),
        optional(
            "damping_ratio",
            "0.005",
            "ζ of every mode; a list such as `[0.0, 0.01]` gives results for each",
            "`[0.0, 0.001, 0.005, 0.02]`",
        ),
        optional(
            "first_mode_damping_ratio",
            "0.3",
            "ζ of the first mode only, the swing of the end mass on the spring",
            "`damping_ratio`",
        )
        .of(MASS),
        optional(
            "mass_damping",
            "\"2 1/s\"",
            "α of ζ_j = α/2ω_j, in place of `damping_ratio`: a drag on each winding against the speed at which it leaves the straight line between \
               the ends, where a spring without mass would lie. A coil that is carried along, or stretched evenly, feels none: no fluid around a moving coil",
            "none",
        ),
        optional(
            "stiffness_damping",
            "\"20 us\"",
            "β of ζ_j = βω_j/2, in place of `damping_ratio`: a dashpot between neighbouring windings, which acts on the same deviation. A coil that \
               is stretched evenly feels none, so end forces hold no kβ times the speed of the ends",
            "none",
        ),
    ],
};
