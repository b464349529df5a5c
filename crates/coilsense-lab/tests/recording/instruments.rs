//! Files of MDF, NI TDMS and MCAP by the libraries that people use, compared to the last bit.

use coilsense::Channel;
use coilsense_lab::recording::{Cleaning, Mapping};

use super::fixtures::mapping;
use super::golden::{read, same, text};

#[cfg(feature = "mdf")]
#[test]
fn mdf_of_asammdf_with_groups_of_their_own_rates() {
    for name in ["motion.mf4", "motion-packed.mf4"] {
        let counts = mapping(&["F_x=counts"]);
        let message = read(name, &counts, &Cleaning::default()).unwrap_err();
        assert!(message.contains(":2: L has no value") && message.contains("--resample"), "{message}");
        let kept = Cleaning { drop_incomplete: true, repair_up_to: Some(0.9), ..Cleaning::default() };
        let found = read(name, &counts, &kept).unwrap();
        let text = text();
        for channel in [Channel::OutputForce, Channel::Inductance, Channel::DeflectionForce] {
            let tenth: Vec<f64> = text.channel(channel).unwrap().iter().step_by(10).copied().collect();
            assert_eq!(found.channel(channel).unwrap(), tenth, "{channel:?}");
        }
        assert_eq!((found.account().read, found.account().left_out()), (50, 45));
    }
}

#[cfg(feature = "mdf")]
#[test]
fn mdf_3_of_asammdf_is_read_as_mdf_4_is() {
    let kept = Cleaning { drop_incomplete: true, repair_up_to: Some(0.9), ..Cleaning::default() };
    let found = read("motion.mdf", &mapping(&["F_x=counts"]), &kept).unwrap();
    let text = text();
    for channel in [Channel::OutputForce, Channel::Inductance, Channel::DeflectionForce] {
        let tenth: Vec<f64> = text.channel(channel).unwrap().iter().step_by(10).copied().collect();
        assert_eq!(found.channel(channel).unwrap(), tenth, "{channel:?}");
    }
    assert!(found.account().description.ends_with("; not read: state (converted to texts)"), "{}", found.account());
}

#[cfg(feature = "tdms")]
#[test]
fn tdms_of_nptdms_in_segments_with_scales_and_waveforms() {
    let found = read("motion.tdms", &mapping(&["F_x=counts"]), &Cleaning::default()).unwrap();
    same(&found, &[Channel::OutputForce, Channel::Inductance, Channel::DeflectionForce]);
    assert_eq!(found.account().description, "NI TDMS, 3 channels on one clock");
    let text = text();
    let kept = Cleaning { drop_incomplete: true, repair_up_to: Some(0.9), ..Cleaning::default() };
    let found = read("motion-wave.tdms", &Mapping::default(), &kept).unwrap();
    for channel in [Channel::OutputForce, Channel::Inductance] {
        let tenth: Vec<f64> = text.channel(channel).unwrap().iter().step_by(10).copied().collect();
        assert_eq!(found.channel(channel).unwrap(), tenth, "{channel:?}");
    }
    assert_eq!(found.signals().time(), [0.0, 0.004, 0.008, 0.012, 0.016]);
    assert_eq!(found.account().description, "NI TDMS, 2 channels on 2 clocks; not read: note (texts)");
}

#[cfg(feature = "tdms")]
#[test]
fn tdms_of_a_card_that_was_stopped_in_a_row() {
    let found = read("motion-card.tdms", &Mapping::default(), &Cleaning::default()).unwrap();
    let text = text();
    // Rows 0 to 19 with metadata, 20 to 29 without, 30 to 46 and half of one before it was stopped.
    assert_eq!(found.signals().time(), &text.signals().time()[..47]);
    let counts = text.channel(Channel::InputForce).unwrap();
    let scaled = |sign: f64| counts[..47].iter().map(|count| (sign * count * 0.5 + 3.0) / 1e3).collect::<Vec<f64>>();
    assert_eq!(found.channel(Channel::OutputForce).unwrap(), scaled(1.0));
    assert_eq!(found.channel(Channel::InputForce).unwrap(), scaled(-1.0));
    assert_eq!(found.remarks(), ["the file is cut off in its last segment"]);
}

#[cfg(feature = "mcap")]
#[test]
fn mcap_of_json_in_chunks_of_its_topics() {
    let kept = Cleaning { drop_incomplete: true, repair_up_to: Some(0.9), ..Cleaning::default() };
    for name in ["motion.mcap", "motion-lz4.mcap"] {
        let found = read(name, &mapping(&["F_i=raw.counts [N]"]), &kept).unwrap();
        let text = text();
        for channel in [Channel::OutputForce, Channel::Inductance, Channel::InputForce] {
            let tenth: Vec<f64> = text.channel(channel).unwrap().iter().step_by(10).copied().collect();
            assert_eq!(found.channel(channel).unwrap(), tenth, "{channel:?}");
        }
        assert_eq!(found.signals().time(), [0.0, 0.004, 0.008, 0.012, 0.016]);
    }
    let message = read("proto.mcap", &Mapping::default(), &Cleaning::default()).unwrap_err();
    assert!(
        message.contains("holds messages in protobuf, which is not read; write them as CSV: python -c '"),
        "{message}"
    );
}
