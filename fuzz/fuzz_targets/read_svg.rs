//! Any bytes given to the reader of SVG make a sound model or an error, with curves refused and with curves flattened.
#![no_main]

use coface::io::{Format, ReadOptions, read_with};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    for flatten in [None, Some(1.0)] {
        let options = ReadOptions::default().format(Format::Svg).flatten(flatten);
        if let Ok(model) = read_with(bytes, &options) {
            model.check().expect("a reader gives sound models");
        }
    }
});
