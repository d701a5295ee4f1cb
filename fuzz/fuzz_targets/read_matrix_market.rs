//! Any bytes given to the reader of Matrix Market make a matrix that is written and read again as it is, or an error.
#![no_main]

use coface::io::matrix_market::{MatrixField, read, write};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(matrix) = read(bytes) {
        let mut text = Vec::new();
        write(&matrix, MatrixField::Integer, &mut text).expect("a list of bytes takes all");
        assert_eq!(read(&text[..]).expect("what is written can be read"), matrix);
    }
});
