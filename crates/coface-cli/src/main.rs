//! The `coface` program.
fn main() {}
