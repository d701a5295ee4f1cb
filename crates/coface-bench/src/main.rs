//! Benches of coface.
fn main() {}
