//! Prints the JSON schema of all answers: `cargo run -p coface-answers --features schema --example schema > docs/answers.schema.json`.

use std::io::Write;

fn main() -> std::io::Result<()> {
    std::io::stdout().write_all(coface_answers::answer::schema().as_bytes())
}
