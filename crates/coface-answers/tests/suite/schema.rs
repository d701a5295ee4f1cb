//! The committed schema of the answers is that of their types.

#[test]
fn the_committed_schema_is_that_of_the_types() {
    let committed = include_str!("../../../../docs/answers.schema.json");
    assert!(
        committed == coface_answers::answer::schema(),
        "docs/answers.schema.json is not up to date: \
         cargo run -p coface-answers --features schema --example schema > docs/answers.schema.json"
    );
}
