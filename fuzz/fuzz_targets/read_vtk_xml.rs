//! Any bytes given to the reader of VTK XML make a sound model or an error.
#![no_main]

use coface::io::{Format, read};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(model) = read(bytes, Format::VtkGrid) {
        model.check().expect("a reader gives sound models");
    }
});
