#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let _ = cloudwright_core::formats::model_glb::read(bytes);
});
