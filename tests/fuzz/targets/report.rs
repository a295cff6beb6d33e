#![no_main]
use cloudwright_core::formats::metar;
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let text = String::from_utf8_lossy(bytes);
    let _ = (metar::read(&text), metar::forecast::read(&text));
});
