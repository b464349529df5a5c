#![no_main]

libfuzzer_sys::fuzz_target!(|text: &str| coilsense_fuzz::spec(text));
