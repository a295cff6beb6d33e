#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| cloudwright_fuzz::arrives("cryengine", bytes));
