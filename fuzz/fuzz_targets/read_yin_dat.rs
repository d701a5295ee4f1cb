//! Any bytes given to the reader of binary curves make a drawing that is a set or no set, or an error; a set is written and read again.
#![no_main]

use coface::answers::{PlanarSet, SetRequest};
use coface::io::{Format, ReadOptions, read_boundary};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Ok(drawing) = read_boundary(bytes, Format::Dat, &ReadOptions::default()) else { return };
    if let Ok(set) = PlanarSet::of(&drawing, &SetRequest::default()) {
        let mut written = Vec::new();
        set.write(&mut written, Format::Dat, None).expect("what was read is written");
        let read = read_boundary(&written[..], Format::Dat, &ReadOptions::default());
        assert_eq!(read.map_or(usize::MAX, |read| read.curves().len()), drawing.curves().len());
    }
});
