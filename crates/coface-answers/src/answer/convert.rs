//! What `convert` answers: the file that was written.

use super::{MapRepairAnswer, Remark};
use crate::{PlanarSet, SurfaceRepair};
use coface_complexes::surface::MeshRepair;
use coface_io::Model;
use serde::{Deserialize, Serialize};

/// A file written from another one.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ConvertAnswer {
    /// The name of the file that was read.
    pub file: String,
    /// Its format; absent for sets of the plane.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub format: Option<String>,
    /// The name of the file that was written.
    pub output: String,
    /// Its format.
    pub output_format: String,
    /// How much was written.
    pub counts: ConvertCounts,
    /// What was repaired; absent if no repair was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub repair: Option<MeshRepairAnswer>,
    /// What was repaired of a drawing; absent if no such repair was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub map_repair: Option<MapRepairAnswer>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// How much a file holds.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum ConvertCounts {
    /// A set of the plane.
    Set(SetCounts),
    /// A model.
    Model(ModelCounts),
}

/// How much of a set of the plane a file holds.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SetCounts {
    /// The number of curves.
    pub curves: usize,
    /// The number of kinks.
    pub kinks: usize,
}

/// How much of a model a file holds.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ModelCounts {
    /// The number of vertices.
    pub vertices: usize,
    /// The number of polylines.
    pub lines: usize,
    /// The number of polygons.
    pub polygons: usize,
    /// The number of cells of dimension 3.
    pub cells: usize,
    /// The number of arrays of data on cells.
    pub data: usize,
}

/// What was repaired, by the vertices and polygons of the input.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct MeshRepairAnswer {
    /// The edges in more than two faces that were split, each by its ends.
    pub edges_split: Vec<[usize; 2]>,
    /// The vertices with several fans of faces that were split.
    pub vertices_split: Vec<usize>,
    /// The polygons whose direction was reversed.
    pub faces_turned: Vec<usize>,
    /// The new vertices, each with the vertex that it is a copy of.
    pub copies: Vec<(usize, usize)>,
    /// What else was done to make a surface; absent unless that was asked for. The other lists are then by the vertices and faces after
    /// merging and cleaning.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub surface: Option<SurfaceRepairAnswer>,
}

/// What was merged, left out and filled to make a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SurfaceRepairAnswer {
    /// How many vertices were merged with another one.
    pub vertices_merged: usize,
    /// How many vertices that were in no face were left out.
    pub vertices_left_out: usize,
    /// How many polygons that collapsed or met themselves were left out.
    pub polygons_collapsed: usize,
    /// How many polygons that repeated an earlier one were left out.
    pub polygons_repeated: usize,
    /// How many lines that were no sides of faces were left out.
    pub lines_left_out: usize,
    /// How many holes were filled.
    pub holes_filled: usize,
    /// How many triangles fill the holes.
    pub triangles_added: usize,
}

impl From<&SurfaceRepair> for MeshRepairAnswer {
    fn from(repair: &SurfaceRepair) -> Self {
        let surface = SurfaceRepairAnswer {
            vertices_merged: repair.merged_count(),
            vertices_left_out: repair.unused_count(),
            polygons_collapsed: repair.collapsed_count(),
            polygons_repeated: repair.duplicate_count(),
            lines_left_out: repair.loose_line_count(),
            holes_filled: repair.hole_count(),
            triangles_added: repair.added_face_count(),
        };
        Self { surface: Some(surface), ..Self::from(repair.mesh()) }
    }
}

impl From<&MeshRepair> for MeshRepairAnswer {
    fn from(repair: &MeshRepair) -> Self {
        let sources = repair.vertex_sources().iter().enumerate();
        Self {
            edges_split: repair.edges_split().iter().map(|edge| edge.map(|end| end.index())).collect(),
            vertices_split: repair.vertices_split().iter().map(|vertex| vertex.index()).collect(),
            faces_turned: repair
                .faces_turned()
                .iter()
                .map(|&face| repair.mesh().polygon_of_face(face))
                .collect(),
            copies: sources
                .filter(|(copy, source)| *copy != source.index())
                .map(|(copy, source)| (copy, source.index()))
                .collect(),
            surface: None,
        }
    }
}

impl ConvertAnswer {
    /// A model written to a file.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::{ConvertAnswer, ConvertCounts};
    /// use coface_io::{Format, read};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = read(&b"v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// let answer = ConvertAnswer::of_model("a.obj", "obj", "b.off", "off", &triangle);
    /// assert!(matches!(answer.counts, ConvertCounts::Model(counts) if counts.vertices == 3 && counts.polygons == 1));
    /// # Ok(()) }
    /// ```
    pub fn of_model(file: &str, format: &str, output: &str, output_format: &str, model: &Model) -> Self {
        let counts = ModelCounts {
            vertices: model.vertex_count(),
            lines: model.lines().len(),
            polygons: model.polygons().len(),
            cells: model.cells().len(),
            data: model.data().len(),
        };
        Self::new(file, Some(format), output, output_format, ConvertCounts::Model(counts))
    }

    /// A set of the plane written to a file.
    pub fn of_set(file: &str, output: &str, output_format: &str, set: &PlanarSet) -> Self {
        let counts = SetCounts { curves: set.set().curve_count(), kinks: set.set().kinks().len() };
        Self::new(file, None, output, output_format, ConvertCounts::Set(counts))
    }

    fn new(
        file: &str,
        format: Option<&str>,
        output: &str,
        output_format: &str,
        counts: ConvertCounts,
    ) -> Self {
        Self {
            file: file.to_owned(),
            format: format.map(str::to_owned),
            output: output.to_owned(),
            output_format: output_format.to_owned(),
            counts,
            repair: None,
            map_repair: None,
            remarks: Vec::new(),
        }
    }

    /// The same with what was repaired of a drawing.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::ConvertAnswer;
    /// use coface_answers::{MapResult, MapTask, RepairMethod};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let tie = coface_io::read(&b"POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let valid = MapResult::new([("tie", &tie)], &MapTask::Repair(RepairMethod::Structure))?;
    /// let answer = ConvertAnswer::of_model("a.wkt", "wkt", "b.wkt", "wkt", valid.model());
    /// let answer = answer.with_map_repair(valid.answer().repair.clone());
    /// assert_eq!(answer.map_repair.map(|repair| repair.features), Some(1));
    /// # Ok(()) }
    /// ```
    pub fn with_map_repair(mut self, repair: Option<MapRepairAnswer>) -> Self {
        self.map_repair = repair;
        self
    }

    /// The same with what was repaired.
    #[must_use]
    pub fn with_repair(mut self, repair: Option<MeshRepairAnswer>) -> Self {
        self.repair = repair;
        self
    }
}

/// The cells that triangles of a subdivision lie in, in the file of `convert --labels`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CarriersAnswer {
    /// For each vertex of the subdivision the cell that it is the middle of: a degree and a number.
    pub carriers: Vec<(usize, usize)>,
}

impl CarriersAnswer {
    /// These carriers.
    ///
    /// # Examples
    /// ```
    /// let answer = coface_answers::answer::CarriersAnswer::new(vec![(0, 3)]);
    /// assert_eq!(answer.carriers, [(0, 3)]);
    /// ```
    pub fn new(carriers: Vec<(usize, usize)>) -> Self {
        Self { carriers }
    }
}
