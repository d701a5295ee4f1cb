//! Models as surfaces, for the verbs that cut and cover them.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{is_json, write_json};
use crate::progress::Progress;
use crate::target::write_model;
use coface::VertexId;
use coface::algebra::RaggedArray;
use coface::answers::{Producer, SurfaceModel};
use coface::io::{Format, GroupKind, Model, Structure};
use coface::{Error, ErrorKind, Fault};
use serde::Serialize;
use std::path::Path;

/// What a model has beside faces, and with it how its boundary is taken.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Solid {
    /// No 3-cells.
    None,
    /// 3-cells with positions in space.
    Placed,
    /// Simplices without positions.
    Abstract,
    /// Cells that have no boundary complex in a file, such as those of a gluing table.
    Glued,
}

impl Solid {
    /// What these cells are.
    pub(crate) fn of(producer: &Producer) -> Self {
        let dimension = producer.chain_complex().ok().and_then(|complex| complex.dimension());
        match (dimension, producer.positions().dimension()) {
            (None | Some(0..=2), _) => Self::None,
            (_, 3) => Self::Placed,
            (Some(top), _) if producer.names_cells_by_vertices() && has_boundary(producer, top) => {
                Self::Abstract
            }
            _ => Self::Glued,
        }
    }

    fn of_model(model: &Model) -> Self {
        match model.structure() {
            Some(Structure::Facets(facets)) if facets.iter().any(|facet| facet.len() > 3) => {
                if facets_have_boundary(facets) {
                    Self::Abstract
                } else {
                    Self::Glued
                }
            }
            Some(Structure::Gluings(table)) if table.dimension() > 2 => Self::Glued,
            _ if model.cells().is_empty() => Self::None,
            _ => Self::Placed,
        }
    }
}

/// Whether a cell of one dimension less lies in one top cell alone.
fn has_boundary(producer: &Producer, top: usize) -> bool {
    let Ok(complex) = producer.chain_complex() else { return false };
    complex.boundary_matrix(top).is_some_and(|boundary| {
        let mut counts = vec![0; boundary.row_count()];
        boundary.rows().iter().for_each(|&row| counts[row as usize] += 1);
        counts.contains(&1)
    })
}

/// The same of facets, of which the largest count.
fn facets_have_boundary(facets: &RaggedArray) -> bool {
    let largest = facets.iter().map(<[u32]>::len).max().unwrap_or(0);
    let mut faces: Vec<Vec<u32>> = Vec::new();
    for facet in facets.iter().filter(|facet| facet.len() == largest) {
        for left in 0..largest {
            let mut face: Vec<u32> = facet
                .iter()
                .copied()
                .enumerate()
                .filter(|&(at, _)| at != left)
                .map(|(_, vertex)| vertex)
                .collect();
            face.sort_unstable();
            faces.push(face);
        }
    }
    faces.sort_unstable();
    faces.chunk_by(|a, b| a == b).any(|same| same.len() == 1)
}

/// What makes a surface of a model that is none, in the words of the command line.
pub(crate) fn cure(error: &Error, solid: Solid) -> &'static str {
    let is_loose = matches!(error.fault(), Some(Fault::EdgeInFaces { faces, .. }) if faces.is_empty());
    match solid {
        Solid::Placed => "take its boundary first: coface boolean union INPUT --pinches split -o OUT.off",
        Solid::Abstract => "take its boundary first: coface boundary INPUT -o OUT.json",
        Solid::Glued => "give a surface",
        Solid::None if is_loose => {
            "leave out what lies in no face first: coface convert INPUT --repair -o OUT"
        }
        Solid::None => "split it first: coface convert INPUT --split-edges pairs --split-vertices -o OUT",
    }
}

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
    let solid = Solid::of_model(&loaded.model);
    let surface = if boundary && is_volume {
        SurfaceModel::boundary_of(loaded.model)
    } else {
        SurfaceModel::of(loaded.model)
    };
    let explained = |error: Error| match error.kind() {
        ErrorKind::NonManifold => {
            let what = if boundary && is_volume { "the boundary is no surface" } else { "no surface" };
            let cure = cure(&error, solid);
            Error::new(error.kind(), format!("{what}: {}", error.message())).with_cure(cure)
        }
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
    /// Texture coordinates of each vertex.
    #[serde(skip_serializing_if = "Option::is_none")]
    uv: Option<Vec<[f64; 2]>>,
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
        let uv = model.texture_coordinates().map(|pair| {
            let rows = 0..model.vertex_count();
            rows.map(|row| pair.map(|data| data.real_row(row)[0])).collect()
        });
        Self {
            answer,
            uv,
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
    write_model(path, model)?;
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
