//! The paper's tables: against the printed numbers and against an independent program.
//!
//! | ours | theirs |
//! |---|---|
//! | tables protocol, Table II | the printed cells of `data/paper/table-2.csv`, 0.02 points |
//! | both protocols, both tables | `reference/tables.csv`: NumPy and SciPy, no code in common |

use coilsense::Channel;
use coilsense_lab::published::Table;
use coilsense_lab::reproduce::{Condition, PaperSprings, Protocol, Reproduction, TOLERANCE_POINTS, reproduce};

fn reproduction() -> Reproduction {
    reproduce(PaperSprings::built_in().unwrap(), &Protocol::ALL).unwrap()
}

#[test]
fn all_30_cells_of_table_ii_come_out_by_the_tables_protocol() {
    let reproduction = reproduction();
    let cells: Vec<_> = reproduction.cells.iter().filter(|cell| cell.table() == Table::Two).collect();
    assert_eq!(cells.len(), 30);
    for cell in cells {
        let ours = cell.by(Protocol::Tables).unwrap();
        assert!((ours.percent - cell.published.percent).abs() <= TOLERANCE_POINTS, "{cell:?}");
        assert!(ours.reasons.is_empty());
    }
}

#[test]
fn every_cell_of_both_protocols_agrees_with_an_independent_program() {
    let reproduction = reproduction();
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../reference/tables.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).expect(path);
    let mut seen = 0;
    for row in reader.deserialize() {
        let (table, spring, condition, force, text, tables): (String, String, String, String, f64, f64) = row.unwrap();
        let condition = Condition::named(&condition).unwrap();
        let cell = reproduction.cells.iter().find(|cell| {
            let (name, of, channel) = cell.place();
            (cell.table().numeral(), name, of, channel.name())
                == (table.as_str(), spring.as_str(), condition, force.as_str())
        });
        let cell = cell.unwrap_or_else(|| panic!("no cell {table} {spring} {condition:?} {force}"));
        for (protocol, theirs) in [(Protocol::Text, text), (Protocol::Tables, tables)] {
            let ours = cell.by(protocol).unwrap().percent;
            // Their doubles are good to 1e-10 points; a tenth of a billionth of F_nom is far below any sensor.
            assert!((ours - theirs).abs() < 1e-8, "{protocol:?} {cell:?} {theirs}");
        }
        seen += 1;
    }
    assert_eq!(seen, 60);
}

#[test]
fn every_difference_has_a_reason_and_every_reason_a_difference() {
    for cell in &reproduction().cells {
        for computed in &cell.computed {
            let differs = (computed.percent - cell.published.percent).abs() > TOLERANCE_POINTS;
            assert_eq!(differs, !computed.reasons.is_empty(), "{cell:?}");
        }
    }
}

#[test]
fn the_sampling_range_of_table_iii_holds_the_value_itself() {
    let reproduction = reproduction();
    let third = reproduction.cells.iter().filter(|cell| cell.table() == Table::Three);
    let mut spread: f64 = 0.0;
    for cell in third {
        let computed = cell.by(Protocol::Tables).unwrap();
        match computed.sampling_range {
            Some((low, high)) => {
                assert!((low..=high).contains(&computed.percent));
                spread = spread.max(high - low);
            }
            None => assert_eq!(cell.place().2, Channel::InductanceForce),
        }
    }
    assert!(spread > 1.0, "S_A's heel strike ranges over more than a point: {spread}");
}

#[test]
fn the_resonance_of_s_a_clashes_and_its_end_stop_stays_just_clear() {
    let reproduction = reproduction();
    let clash = reproduction.case("S_A", Condition::Resonance).unwrap().clash;
    assert!((clash.first_contact.unwrap() - 0.5294).abs() < 1e-3, "{clash:?}");
    assert!((clash.smallest_pitch - 2.437e-3).abs() < 1e-5, "{clash:?}");
    let stop = reproduction.case("S_A", Condition::EndStopMin).unwrap().clash;
    assert!(!stop.happens() && (stop.clearance() - 0.069e-3).abs() < 1e-6, "{stop:?}");
    assert_eq!(reproduction.warnings().len(), 2, "{:?}", reproduction.warnings());
}

#[test]
fn the_built_in_springs_are_table_i() {
    let springs = PaperSprings::built_in().unwrap();
    let all: Vec<_> = springs.each().collect();
    let (_, s_t) = all[0];
    assert_eq!((s_t.rest_length(), s_t.windings(), s_t.coil_radius(), s_t.wire_radius()), (0.104, 52.0, 0.008, 0.001));
    assert_eq!((s_t.mass(), s_t.stiffness(), s_t.operating_range()), (0.065, 760.0, (0.196, 0.264)));
    let (_, s_a) = all[1];
    assert_eq!((s_a.rest_length(), s_a.windings(), s_a.coil_radius(), s_a.wire_radius()), (0.081, 25.0, 0.008, 0.0016));
    assert_eq!((s_a.mass(), s_a.stiffness(), s_a.operating_range()), (0.080, 9100.0, (0.082, 0.122)));
}
