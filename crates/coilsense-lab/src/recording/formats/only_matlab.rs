//! What to do about an object that only MATLAB reads.
//!
//! Next door: the readers of files that hold such objects (`matlab`, `hdf5`).

use super::super::error::shortened;

/// The line of MATLAB that saves what an object holds.
pub(super) fn advice(name: &str, kind: &str) -> String {
    let save = "save(\"log.mat\", \"-struct\", \"S\", \"-v7\")";
    let line = match kind {
        "timetable" => format!(
            "S = table2struct(timetable2table({name}, \"ConvertRowTimes\", false), \"ToScalar\", true); \
             S.time = seconds({name}.Properties.RowTimes - {name}.Properties.RowTimes(1)); {save}"
        ),
        "table" => format!("S = table2struct({name}, \"ToScalar\", true); {save}"),
        "timeseries" => format!("S.time = {name}.Time; S.data = {name}.Data; {save}"),
        "Simulink.SimulationData.Dataset" => format!(
            "for k = 1:{name}.numElements, e = {name}{{k}}; S.(matlab.lang.makeValidName(e.Name)) = e.Values.Data; \
             end, S.time = e.Values.Time; {save}"
        ),
        _ => return format!("{name} is a {}, which only MATLAB reads; save its numbers as vectors", shortened(kind)),
    };
    format!("{name} is a {kind}, which only MATLAB reads; there: {line}")
}
