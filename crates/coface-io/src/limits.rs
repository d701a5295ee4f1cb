//! What a format cannot hold, said before anything is written.

use super::Model;
use coface_algebra::{Error, ErrorKind};

/// Refuses an abstract structure, vertices without positions, and 3-cells, of which a format of surfaces knows nothing;
/// `others` names formats that hold 3-cells.
pub(super) fn require_mesh(model: &Model, format: &str, others: &str) -> Result<(), Error> {
    let refuse = |what: &str, cure: String| {
        Err(Error::new(ErrorKind::UnsupportedFormat, format!("{format} cannot hold {what}")).with_cure(cure))
    };
    if model.structure.is_some() {
        return refuse("an abstract structure", "write JSON".to_owned());
    }
    if !model.cells.is_empty() {
        return refuse(
            &format!("3-cells, and the model has {}", model.cells.len()),
            format!("write {others}"),
        );
    }
    if model.vertex_count > 0 && model.coordinate_count() == 0 {
        return refuse("vertices without positions", "write a JSON facet list".to_owned());
    }
    Ok(())
}

/// Refuses more than `most` coordinates a vertex.
pub(super) fn require_dimension(model: &Model, format: &str, most: usize) -> Result<(), Error> {
    let dimension = model.coordinate_count();
    if dimension <= most {
        return Ok(());
    }
    Err(Error::new(
        ErrorKind::UnsupportedFormat,
        format!("{format} holds at most {most} coordinates a vertex, and the model has {dimension}"),
    )
    .with_cure("write OFF, which holds any dimension"))
}

/// Refuses an abstract structure and vertices without positions, in a format of volume meshes.
pub(super) fn require_volume_mesh(model: &Model, format: &str) -> Result<(), Error> {
    let (what, cure) = if model.structure.is_some() {
        ("an abstract structure", "write JSON")
    } else if model.vertex_count > 0 && model.coordinate_count() == 0 {
        ("vertices without positions", "write a JSON facet list")
    } else {
        return Ok(());
    };
    Err(Error::new(ErrorKind::UnsupportedFormat, format!("{format} cannot hold {what}")).with_cure(cure))
}

/// Refuses polygons of more than four vertices.
pub(super) fn require_small_polygons(model: &Model, format: &str) -> Result<(), Error> {
    let Some(i) = model.polygons.iter().position(|polygon| polygon.len() > 4) else { return Ok(()) };
    Err(Error::new(
        ErrorKind::UnsupportedFormat,
        format!(
            "{format} holds triangles and quadrangles, but polygon {i} has {} vertices",
            model.polygons.list(i).len()
        ),
    )
    .with_cure("write VTK, OFF, OBJ or PLY, which hold any polygon"))
}
