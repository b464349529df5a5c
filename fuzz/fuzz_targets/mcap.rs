#![no_main]

use coilsense_fuzz::log_file;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| log_file(b"\x89MCAP", bytes));
