//! Any bytes of a format that must be guessed make a sound model or an error.
#![no_main]

use coface::io::read_unknown;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(model) = read_unknown(bytes) {
        model.check().expect("a reader gives sound models");
    }
});
