//! Models as surfaces, for the verbs that cut and cover them.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{is_json, write_json};
use crate::progress::Progress;
use coface::VertexId;
use coface::answers::SurfaceModel;
use coface::io::{Format, GroupKind, Model, write_path};
use coface::{Error, ErrorKind};
use serde::Serialize;
use std::path::Path;

/// Reads a model as a surface: its name for people, and the surface. With `boundary` it is the boundary of a volume mesh.
pub(crate) fn read(
    path: &Path,
    boundary: bool,
    common: &Common,
    progress: &Progress,
) -> Result<(String, SurfaceModel), Failure> {
    let loaded = input::read(path, common.reading(), progress)?;
    progress.stage("identifying cells");
    let is_volume = !loaded.model.cells().is_empty();
    let surface = if boundary && is_volume {
        SurfaceModel::boundary_of(loaded.model)
    } else {
        SurfaceModel::of(loaded.model)
    };
    let explained = |error: Error| match error.kind() {
        // A volume mesh cannot be repaired by splitting.
        ErrorKind::NonManifold if is_volume => {
            Error::new(error.kind(), format!("the boundary is no surface: {}", error.message()))
                .with_cure("see coface info; cells must not touch along single edges or vertices")
        }
        ErrorKind::NonManifold => Error::new(error.kind(), format!("no surface: {}", error.message()))
            .with_cure(
                "see coface info; coface convert --split-edges pairs --split-vertices can make it one",
            ),
        ErrorKind::UnsupportedFormat if is_volume && !boundary => {
            error.with_cure("add --boundary to take its boundary")
        }
        _ => error,
    };
    let surface = surface.map_err(|error| Failure::from(explained(error).in_file(loaded.name.clone())))?;
    Ok((loaded.name, surface))
}

/// The answer of a verb with the mesh that it made.
#[derive(Serialize)]
struct WithMesh<'a, A> {
    #[serde(flatten)]
    answer: &'a A,
    /// Triangles are a facet list that can be read again.
    #[serde(skip_serializing_if = "Option::is_none")]
    facets: Option<Vec<&'a [u32]>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    polygons: Option<Vec<&'a [u32]>>,
    /// For each vertex its number in the file.
    source: Vec<Option<i64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    positions: Option<Vec<&'a [f64]>>,
    /// For each face the copy that it is in.
    #[serde(skip_serializing_if = "Option::is_none")]
    copy: Option<Vec<i64>>,
}

impl<'a, A> WithMesh<'a, A> {
    fn new(answer: &'a A, model: &'a Model) -> Self {
        let source = model.data_named("source", GroupKind::Vertices);
        let sources =
            (0..model.vertex_count()).map(|vertex| source.and_then(|data| data.integer_row(vertex)));
        let faces: Vec<&[u32]> = model.polygons().iter().collect();
        let (facets, polygons) = match faces.iter().all(|face| face.len() == 3) {
            true => (Some(faces), None),
            false => (None, Some(faces)),
        };
        let point = |vertex| model.positions().point(VertexId::new(vertex));
        let copy = model.data_named("copy", GroupKind::Polygons).map(|copy| {
            let rows = (0..model.polygons().len()).filter_map(|face| copy.integer_row(face));
            rows.map(|row| row[0]).collect()
        });
        Self {
            answer,
            facets,
            polygons,
            source: sources.map(|row| row.map(|row| row[0])).collect(),
            // JSON has no words for NaN and infinity.
            positions: (!model.positions().is_empty())
                .then(|| (0..model.vertex_count()).map(point).collect()),
            copy,
        }
    }
}

/// Writes the model that a verb made: in the format of the extension; as .json the answer of the verb with the faces by their
/// vertices and the numbers in the file of the vertices; with "positions" and the "copy" of each face where there are any.
pub(crate) fn save(
    path: &Path,
    model: &Model,
    answer: &impl Serialize,
    common: &Common,
) -> Result<(), Failure> {
    if is_json(path) {
        return write_json(path, &WithMesh::new(answer, model));
    }
    if model.coordinate_count() == 0 && model.vertex_count() > 0 {
        return Err(Failure::new(format!("{}: the model has no positions; write .json", path.display())));
    }
    write_path(model, path, None)?;
    if let Some(format) = Format::from_path(path).filter(|format| !format.keeps_data() && !common.quiet) {
        crate::output::remark(&format!(
            "{} does not keep data on cells, such as what each vertex is a copy of; .ply and .vtk do",
            format.title()
        ));
    }
    Ok(())
}

/// A count of rows of a page that is not too long: the rows to show, and how many more there are.
pub(crate) fn few(count: usize) -> (usize, usize) {
    const FEW: usize = 12;
    if count <= FEW { (count, 0) } else { (FEW, count - FEW) }
}
