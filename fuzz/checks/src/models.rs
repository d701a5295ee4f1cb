//! What holds for every model that was read.

use coface::Model;
use coface::io::{Format, losses, read, write};

/// Checks the invariants of a model.
pub(crate) fn check_model(model: &Model) {
    model.check().expect("a reader gives sound models");
    assert!(model.positions().is_empty() || model.positions().len() == model.vertex_count());
}

/// Writes a model, reads it, and writes that: the two files are the same, and so are the counts of cells.
pub(crate) fn check_round(model: &Model, format: Format) {
    let Some(first) = written(model, format) else { return };
    let again = read(&first[..], format);
    let again =
        again.unwrap_or_else(|error| panic!("what is written in {} is not read: {error}", format.title()));
    check_model(&again);
    let counts = |model: &Model| (model.polygons().len(), model.lines().len(), model.cells().len());
    // Triangles with a corner twice are left out there.
    let is_less = matches!(format, Format::ThreeMf | Format::Amf) && !losses(model, format).is_empty();
    // Meshes become lists of simplices in JSON.
    if !is_less && (format != Format::Json || model.structure().is_some()) {
        assert_eq!(counts(&again), counts(model), "{} does not keep the cells", format.title());
    }
    let second = written(&again, format).expect("what was written once is written again");
    if format == Format::Msh {
        // Groups named by numbers get these numbers, and so others come first.
        assert_eq!(first.len(), second.len(), "{} is written differently after it was read", format.title());
        return;
    }
    assert!(first == second, "{} is written differently after it was read", format.title());
}

fn written(model: &Model, format: Format) -> Option<Vec<u8>> {
    let mut bytes = Vec::new();
    write(model, &mut bytes, format).ok().map(|()| bytes)
}
