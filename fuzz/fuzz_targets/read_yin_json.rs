//! Any text given to the reader of curves makes a drawing that is a set or no set, or an error; a set is written so that the same text
//! comes again.
#![no_main]

use coface::answers::{PlanarSet, SetRequest};
use coface::io::{Format, ReadOptions, read_boundary};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let read = |bytes: &[u8]| {
        let drawing = read_boundary(bytes, Format::Json, &ReadOptions::default()).ok()?;
        PlanarSet::of(&drawing, &SetRequest::default()).ok()
    };
    let Some(set) = read(bytes) else { return };
    let mut written = Vec::new();
    set.write(&mut written, Format::Json, None).expect("every set is written");
    let again = read(&written).expect("what is written is read");
    let mut twice = Vec::new();
    again.write(&mut twice, Format::Json, None).expect("every set is written");
    assert_eq!(written, twice);
});
