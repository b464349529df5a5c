#![no_main]

libfuzzer_sys::fuzz_target!(|text: &[u8]| coilsense_fuzz::text_log(text));
