//! What a reader of a sweep must know of all of its rows.
//!
//! Next door: the plan (`plan`), how forces by inductance are found in it (`forces`).

use coilsense::Channel;

use super::column::BY_INDUCTANCE;
use super::plan::Plan;
use crate::spec::{Spec, SpringSpec};

/// Keys by which a wire becomes magnetic.
const OF_WIRE: [&str; 2] = ["relative_permeability", "material"];

impl Plan {
    /// That magnetic wire is taken as not magnetic, where forces by inductance are asked for.
    pub fn note(&self) -> Option<String> {
        let parameters = self.parameters();
        let (file, text) = (&parameters.spec_file, &parameters.spec);
        let varied =
            self.variables.iter().any(|variable| OF_WIRE.iter().any(|key| variable.target.place.is_of_spring(key)));
        let told = SpringSpec::parse(file, text)
            .is_ok_and(|spring| spring.is_magnetic() || spring.permeability_found().is_some());
        (self.asks_for_inductance() && (told || varied)).then(|| {
            "F_L and sensors by inductance are those of non-magnetic wire: a sweep leaves out magnetisation, which analyze includes where relative_permeability is told (for S_T at 2.5 it makes \
             their error while the coil rings 4 % larger)"
                .to_owned()
        })
    }

    /// Whether a column is of F_L, or of a sensor by inductance.
    fn asks_for_inductance(&self) -> bool {
        if self.needs.forces[BY_INDUCTANCE] {
            return true;
        }
        let parameters = self.parameters();
        let spec = Spec::parse(&parameters.spec_file, &parameters.spec, &|name| self.file(name));
        // Of a spec that only its rows make whole, any sensor might be one.
        spec.map_or(!self.needs.sensors.is_empty(), |spec| {
            let asked = self.needs.sensors.iter().filter_map(|&sensor| spec.sensors.get(sensor));
            asked.into_iter().any(|sensor| sensor.quantity.of_kind().watches(Channel::Inductance))
        })
    }
}
