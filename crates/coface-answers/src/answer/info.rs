//! The answer of `info`: the report on a model.

use super::{HalfedgePointers, HomologyGroup, MapRepairAnswer, Remark};
use crate::{DrawnFault, DrawnPlace, DrawnPolygons, GeometryFacts, Problem, Report};
use coface_arrange::spatial::checks::{Fault, FaultPlace, FaultScope, GeometryFaults};
use coface_complexes::surface::{SurfaceComponent, SurfaceType};
use serde::{Deserialize, Serialize};

/// The report on one model. A notion that does not apply is `null`. Lengths, areas and volumes are in the unit of the file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct InfoAnswer {
    /// The name of the input; absent for a model that was made in memory.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub file: Option<String>,
    /// The format of the input, such as `off`; absent for a model that was made in memory.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub format: Option<String>,
    /// What sort of thing the model is: `complex`, `surface`, `volume` or `planar`.
    pub kind: String,
    /// The highest degree of a cell; `null` for the empty complex.
    pub dimension: Option<usize>,
    /// The numbers of cells of degrees 0, 1, ... up to the dimension.
    pub f_vector: Vec<usize>,
    /// How many cells of the highest degree have which shape.
    pub top_cells: Vec<CellsOfShape>,
    /// Whether every cell is a face of a cell of the highest degree; `null` for a chain complex.
    pub pure: Option<bool>,
    /// The number of connected components; an isolated vertex is one.
    pub components: usize,
    /// The alternating sum of the numbers of cells.
    pub euler_characteristic: i64,
    /// Whether the model without its isolated vertices is a manifold.
    pub manifold: ManifoldAnswer,
    /// The number of connected components of the graph of edges with one face; `null` unless the dimension is 2.
    pub boundary_loops: Option<usize>,
    /// The boundary of a volume; `null` for everything else and where there is none.
    pub boundary_surface: Option<BoundarySurface>,
    /// Whether the top cells can be oriented so that neighbors agree; `null` where one of their facets lies in three.
    pub orientable: Option<bool>,
    /// Whether neighboring top cells agree as the file gives them.
    pub coherently_oriented: Option<bool>,
    /// The genus of a connected surface; of a non-orientable one the number of cross-caps.
    pub genus: Option<usize>,
    /// The surface in words, such as `torus`, or the 3-manifold, such as `L(8,3)`, where it is proved which one it is, up to orientation (in a sum each summand up to one of its own); else `null`.
    pub name: Option<String>,
    /// What the name of a 3-manifold rests on: `layered_solid_tori`, `folded_tetrahedron`, `seifert_fibration`, `fibered_pieces`, `normal_spheres` or `fundamental_group`; absent without such a name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name_proof: Option<String>,
    /// The components of a model of polygons, isolated vertices left out.
    pub surfaces: Vec<SurfaceAnswer>,
    /// The integral homology of degrees 0, 1, ... up to the dimension.
    pub homology: Vec<HomologyGroup>,
    /// The area of a surface, in the square of the unit of the file; `null` without positions.
    pub area: Option<f64>,
    /// The enclosed volume, in the cube of the unit of the file, positive when faces run counterclockwise seen from outside.
    pub signed_volume: Option<f64>,
    /// The center of the area of a surface in space.
    pub surface_centroid: Option<[f64; 3]>,
    /// Volume, center and inertia of the solid of density 1 that the model encloses.
    pub mass: Option<MassAnswer>,
    /// The integrals of monomials that were asked for.
    pub moments: Vec<MomentAnswer>,
    /// The named numbers on vertices, lines, polygons and cells.
    pub data: Vec<DataAnswer>,
    /// The named sets of vertices, lines, polygons and cells.
    #[serde(default)]
    pub groups: Vec<NamedGroup>,
    /// Of a surface given by at most 60 halfedges: what each one points to; absent for other models.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub halfedges: Vec<HalfedgePointers>,
    /// What is wrong, and where: with the cells, with the faces in space (more of it under `geometry`), with the polygons of a drawing (more of it
    /// under `polygons`).
    pub problems: Vec<ProblemAnswer>,
    /// Whether the faces are sound in space; `null` for what has no faces with coordinates.
    #[serde(default)]
    pub geometry: Option<GeometryAnswer>,
    /// Whether the polygons with rings of a drawing are valid; `null` for what has none, and where they were not checked.
    #[serde(default)]
    pub polygons: Option<DrawnPolygonsAnswer>,
    /// What a repair of the polygons of a drawing would do; absent unless that was asked for.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub repair: Option<MapRepairAnswer>,
    /// The reference system of the coordinates of a map; absent where the file names none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reference_system: Option<ReferenceAnswer>,
    /// What was odd, one sentence each: the reader's remarks, then the first sentence of each problem.
    pub warnings: Vec<String>,
    /// The warnings with their codes, counts and first places.
    pub remarks: Vec<Remark>,
}

/// The reference system that the file of a map names.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ReferenceAnswer {
    /// Its number, such as 25832 of EPSG; `null` if it has none.
    pub srid: Option<u32>,
    /// The text of its member `crs` in GeoJSON.
    pub crs: String,
}

/// How many cells have a shape.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CellsOfShape {
    /// The shape, such as `triangle`.
    pub shape: String,
    /// How many cells have it.
    pub count: usize,
}

/// Whether a model is a manifold, with or without boundary.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ManifoldAnswer {
    /// `yes`, `no` or `unknown`.
    pub verdict: String,
    /// Whether there is no boundary.
    pub closed: Option<bool>,
    /// Why the model is no manifold.
    pub witness: Option<WitnessAnswer>,
}

/// Cells that show why a model is no manifold.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct WitnessAnswer {
    /// What sort of witness this is.
    pub kind: String,
    /// The cells, each by its vertices.
    pub cells: Vec<Vec<u32>>,
    /// One sentence for people.
    pub message: String,
}

/// The boundary of a volume.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct BoundarySurface {
    /// The number of its faces.
    pub faces: usize,
    /// The number of its connected components.
    pub components: usize,
    /// Its vertices minus its edges plus its faces.
    pub euler_characteristic: i64,
    /// Whether it is a surface.
    pub manifold: bool,
    /// The surface in words: `sphere`, `2 tori`; `null` where it is none.
    pub name: Option<String>,
}

/// A connected component of a model of polygons.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SurfaceAnswer {
    /// The numbers of its vertices, edges and faces.
    pub f_vector: Vec<usize>,
    /// Its vertices minus its edges plus its faces.
    pub euler_characteristic: i64,
    /// The number of its boundary loops.
    pub boundary_loops: usize,
    /// Whether it is orientable; `null` if it is no surface.
    pub orientable: Option<bool>,
    /// Its genus, or the number of cross-caps; `null` if it is no surface.
    pub genus: Option<usize>,
    /// The surface in words; `null` if it is none.
    pub name: Option<String>,
}

/// Mass properties of a solid of density 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct MassAnswer {
    /// The volume; `null` beyond the range of floating point.
    pub volume: Option<f64>,
    /// The center of mass.
    pub centroid: [Option<f64>; 3],
    /// The inertia about the center, by rows; a number is `null` beyond the range of floating point.
    pub inertia: [[Option<f64>; 3]; 3],
}

/// The integrals of a monomial x^a y^b z^c.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct MomentAnswer {
    /// The exponents a, b, c.
    pub exponents: [u32; 3],
    /// The integral over the enclosed solid.
    pub volume: Option<f64>,
    /// The integral over the surface, with respect to area.
    pub surface: Option<f64>,
}

/// Named numbers on the cells of a model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DataAnswer {
    /// The name.
    pub name: String,
    /// What the numbers are on.
    pub on: String,
    /// How many numbers each of these has.
    pub components: usize,
    /// `integer` or `real`.
    #[serde(rename = "type")]
    pub number_type: String,
    /// The least and the largest number; `null` if there are none.
    pub range: Option<[Option<f64>; 2]>,
}

/// A named set of vertices, lines, polygons or cells of a model: an object of an OBJ, a solid of an STL, a physical group of Gmsh.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct NamedGroup {
    /// The name, or the number, that the file gives it; one of polygons is read alone as `FILE#name`.
    pub name: String,
    /// What the members are.
    pub of: String,
    /// How many members it has.
    pub count: usize,
}

/// One sort of fault with its places.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ProblemAnswer {
    /// What sort of fault it is, such as `nonmanifold_edge`.
    pub kind: String,
    /// In how many places it is.
    pub count: usize,
    /// One sentence that says how many places have it and what it means.
    pub message: String,
    /// The first cells that have it, each by its vertices.
    pub cells: Vec<Vec<u32>>,
    /// For each of the cells the top cells that meet there; empty when that says nothing.
    pub top_cells: Vec<Vec<u32>>,
    /// The first places as points, of two or three rounded coordinates each; empty where the cells are the places.
    #[serde(default)]
    pub points: Vec<Vec<f64>>,
}

/// Whether the faces of a model are sound in space.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct GeometryAnswer {
    /// Whether the faces were checked.
    pub checked: bool,
    /// Why they were not.
    pub reason: Option<String>,
    /// Whether no faces cross, overlap or contradict each other; `null` if that was not checked.
    pub sound_surface: Option<bool>,
    /// Whether the faces bound one valid solid; `null` if that was not checked.
    pub valid_solid: Option<bool>,
    /// How many faces have no area, or rings that cross: where they meet others was not looked at.
    pub faces_left_out: usize,
    /// How many shells touch too many others: how they lie to each other was not looked at.
    pub shells_left_out: usize,
    /// What is wrong, by rising code.
    pub faults: Vec<GeometryFaultAnswer>,
}

/// One code of faults of faces in space.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct GeometryFaultAnswer {
    /// The code of ISO 19107, from 101 to 405.
    pub code: u16,
    /// The word for it, such as `faces_cross`; several words can have one code.
    pub name: String,
    /// `surface` for what is wrong with the surface, `solid` for what only keeps it from bounding one solid.
    pub of: String,
    /// In how many places it is.
    pub count: usize,
    /// Whether all places are counted.
    pub complete: bool,
    /// One sentence that says how many places have it and what it means.
    pub message: String,
    /// The first places.
    pub places: Vec<GeometryPlace>,
}

/// Where a fault of faces in space is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct GeometryPlace {
    /// The faces of the file, from 0.
    pub faces: Vec<u32>,
    /// The vertices that show it.
    pub vertices: Vec<u32>,
    /// A point of the place, rounded.
    pub point: Option<[f64; 3]>,
    /// How far a point is from the plane of its face, for faces that are not flat.
    pub distance: Option<f64>,
}

impl GeometryAnswer {
    fn of(facts: &GeometryFacts, limit: usize) -> Self {
        let found = match facts {
            GeometryFacts::Checked(found) => Some(found),
            GeometryFacts::Unchecked(_) => None,
        };
        let reason = match facts {
            GeometryFacts::Checked(_) => None,
            GeometryFacts::Unchecked(reason) => Some(reason.to_string()),
        };
        let place = |place: &FaultPlace| GeometryPlace {
            faces: place.faces.clone(),
            vertices: place.vertices.clone(),
            point: place.point.filter(|point| point.iter().all(|x| x.is_finite())),
            distance: place.distance.filter(|distance| distance.is_finite()),
        };
        let fault = |fault: &Fault| GeometryFaultAnswer {
            code: fault.code().number(),
            name: fault.code().name().to_owned(),
            of: fault.scope().word().to_owned(),
            count: fault.count(),
            complete: fault.is_complete(),
            message: fault.sentence(),
            places: fault.places().iter().take(limit).map(place).collect(),
        };
        Self {
            checked: found.is_some(),
            reason,
            sound_surface: found.map(GeometryFaults::is_sound_surface),
            valid_solid: found.map(GeometryFaults::is_valid_solid),
            faces_left_out: found.map_or(0, GeometryFaults::faces_left_out),
            shells_left_out: found.map_or(0, GeometryFaults::shells_left_out),
            faults: facts.faults().iter().map(fault).collect(),
        }
    }
}

/// Whether the polygons with rings of a drawing are valid: those of one geometry together, as OGC's Simple feature access says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DrawnPolygonsAnswer {
    /// The number of polygons.
    pub count: usize,
    /// Whether all geometries are valid.
    pub valid: bool,
    /// The first fault with its place in the words of other programs, such as `Self-intersection[1 1]`; `null` if there is none.
    pub reason: Option<String>,
    /// What is wrong.
    pub faults: Vec<DrawnFaultAnswer>,
    /// The outer rings that run clockwise and the holes that run counterclockwise: RFC 7946 has them the other way.
    pub reversed_rings: usize,
}

/// One kind of fault of polygons of a drawing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DrawnFaultAnswer {
    /// The word for it, such as `ring_crosses_itself`.
    pub name: String,
    /// What other programs call it, such as `Self-intersection`; several words can have one.
    pub reason: String,
    /// In how many places it is.
    pub count: usize,
    /// One sentence that says where it is first, and what it means.
    pub message: String,
    /// The first places.
    pub places: Vec<DrawnPlaceAnswer>,
}

/// Where a polygon of a drawing is not valid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DrawnPlaceAnswer {
    /// A point of the place, rounded.
    pub point: [f64; 2],
    /// The rings that have the fault, one or two, as pairs: a polygon of the drawing, and a ring of it, 0 for the outer one.
    pub rings: Vec<(usize, usize)>,
}

impl DrawnFaultAnswer {
    /// A fault with so many of its places.
    pub(crate) fn of(fault: &DrawnFault, limit: usize) -> Self {
        let place = |place: &DrawnPlace| DrawnPlaceAnswer { point: place.point, rings: place.rings.clone() };
        Self {
            name: fault.kind.name().to_owned(),
            reason: fault.kind.reason().to_owned(),
            count: fault.places.len(),
            message: fault.sentence(),
            places: fault.places.iter().take(limit).map(place).collect(),
        }
    }
}

impl DrawnPolygonsAnswer {
    fn of(found: &DrawnPolygons, limit: usize) -> Self {
        let reason = |fault: &DrawnFault| {
            let [x, y] = fault.places.first()?.point;
            Some(format!("{}[{x} {y}]", fault.kind.reason()))
        };
        Self {
            count: found.polygon_count(),
            valid: found.faults().is_empty(),
            reason: found.faults().first().and_then(reason),
            faults: found.faults().iter().map(|fault| DrawnFaultAnswer::of(fault, limit)).collect(),
            reversed_rings: found.reversed_rings(),
        }
    }
}

/// The reports on several inputs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct InfoReports {
    /// One entry for each input, in their order.
    pub reports: Vec<InfoEntry>,
}

/// The report on one of several inputs, or why there is none.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum InfoEntry {
    /// The report.
    Report(Box<InfoAnswer>),
    /// Why the input cannot be served.
    Failed(FailedInput),
}

/// An input that cannot be served.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FailedInput {
    /// The name of the input.
    pub file: String,
    /// The message: place, fault and cure.
    pub error: String,
}

impl InfoAnswer {
    /// The same answer with the name and the format of the input.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.answer(10).of_file("t.off", "off").format.as_deref(), Some("off"));
    /// # Ok(()) }
    /// ```
    pub fn of_file(mut self, name: &str, format: &str) -> Self {
        self.file = Some(name.to_owned());
        self.format = Some(format.to_owned());
        self
    }
}

impl Report {
    /// The report as plain data. Of each problem up to `limit` places are listed.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_answers::Report;
    /// use coface_io::{Model, Structure};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = RaggedArray::from_lists([[0, 1, 2]]);
    /// let answer = Report::of(Model::from_structure(Structure::Facets(triangle)))?.answer(10);
    /// assert_eq!((answer.f_vector, answer.name.as_deref()), (vec![3, 3, 1], Some("disk")));
    /// # Ok(()) }
    /// ```
    pub fn answer(&self, limit: usize) -> InfoAnswer {
        let finite = |[x, y, z]: [f64; 3]| [Some(x), Some(y), Some(z)];
        let geometry = self.geometry.as_ref().map(|facts| GeometryAnswer::of(facts, limit));
        let polygons = self.drawn.as_ref().map(|found| DrawnPolygonsAnswer::of(found, limit));
        InfoAnswer {
            file: None,
            format: None,
            kind: self.kind.word().to_owned(),
            dimension: self.dimension(),
            f_vector: self.f_vector.clone(),
            top_cells: (self.shapes.iter())
                .map(|&(shape, count)| CellsOfShape { shape: shape.to_owned(), count })
                .collect(),
            pure: self.pure,
            components: self.components,
            euler_characteristic: self.euler_characteristic,
            manifold: ManifoldAnswer {
                verdict: self.manifold.word().to_owned(),
                closed: self.closed,
                witness: self.witness.as_ref().map(|witness| WitnessAnswer {
                    kind: witness.kind.to_owned(),
                    cells: witness.cells.clone(),
                    message: witness.message.clone(),
                }),
            },
            boundary_loops: self.boundary_loops.as_ref().map(Vec::len),
            boundary_surface: self.skin.as_ref().map(|skin| BoundarySurface {
                faces: skin.face_count,
                components: skin.components,
                euler_characteristic: skin.euler_characteristic,
                manifold: skin.is_manifold,
                name: skin.name.clone(),
            }),
            orientable: self.orientable,
            coherently_oriented: self.coherently_oriented,
            genus: self.surface_type.map(|surface| surface.genus()),
            name: self.name.clone(),
            name_proof: self.name_proof.map(|proof| proof.word().to_owned()),
            surfaces: self.surfaces.iter().map(SurfaceAnswer::of).collect(),
            homology: HomologyGroup::list(&self.homology),
            area: self.area,
            signed_volume: self.signed_volume,
            surface_centroid: self.surface_centroid,
            mass: self.mass.as_ref().map(|mass| MassAnswer {
                volume: Some(mass.volume()),
                centroid: finite(mass.centroid()),
                inertia: mass.inertia().map(finite),
            }),
            moments: (self.moments.iter())
                .map(|moment| MomentAnswer {
                    exponents: moment.exponents,
                    volume: moment.volume,
                    surface: moment.surface,
                })
                .collect(),
            data: (self.data.iter())
                .map(|data| DataAnswer {
                    name: data.name().to_owned(),
                    on: data.kind().to_string(),
                    components: data.components(),
                    number_type: if data.is_integral() { "integer" } else { "real" }.to_owned(),
                    range: data.range().map(|range| range.map(Some)),
                })
                .collect(),
            halfedges: self.pointers.clone(),
            groups: (self.groups.iter())
                .map(|group| NamedGroup {
                    name: group.name().to_owned(),
                    of: group.kind().to_string(),
                    count: group.count(),
                })
                .collect(),
            problems: self.problems_of(geometry.as_ref(), polygons.as_ref(), limit),
            geometry,
            polygons,
            repair: None,
            reference_system: self
                .reference
                .as_ref()
                .map(|system| ReferenceAnswer { srid: system.srid(), crs: system.crs().into_owned() }),
            warnings: self.warnings.clone(),
            remarks: self.remarks.clone(),
        }
    }
}

impl Report {
    /// What is wrong: with the cells, with the faces in space, with polygons of a drawing.
    fn problems_of(
        &self,
        geometry: Option<&GeometryAnswer>,
        polygons: Option<&DrawnPolygonsAnswer>,
        limit: usize,
    ) -> Vec<ProblemAnswer> {
        let of_faces = geometry.map_or(&[][..], |found| &found.faults);
        let of_faces = of_faces.iter().filter(|fault| fault.of == FaultScope::Surface.word());
        let of_drawn = polygons.map_or(&[][..], |found| &found.faults);
        (self.problems.iter().map(|problem| ProblemAnswer::of(problem, limit)))
            .chain(of_faces.map(ProblemAnswer::of_faces))
            .chain(of_drawn.iter().map(ProblemAnswer::of_drawn))
            .collect()
    }
}

impl SurfaceAnswer {
    fn of(component: &SurfaceComponent) -> Self {
        let surface = component.surface();
        Self {
            f_vector: component.f_vector().to_vec(),
            euler_characteristic: component.euler_characteristic(),
            boundary_loops: component.boundary_count(),
            orientable: surface.map(SurfaceType::is_orientable),
            genus: surface.map(SurfaceType::genus),
            name: surface.map(|surface| surface.to_string()),
        }
    }
}

impl ProblemAnswer {
    fn of(problem: &Problem, limit: usize) -> Self {
        Self {
            kind: problem.kind().word().to_owned(),
            count: problem.count(),
            message: problem.message().to_owned(),
            cells: problem.cells().iter().take(limit).map(<[u32]>::to_vec).collect(),
            top_cells: problem.tops().iter().take(limit).map(<[u32]>::to_vec).collect(),
            points: Vec::new(),
        }
    }

    /// A fault of a polygon of a drawing.
    fn of_drawn(fault: &DrawnFaultAnswer) -> Self {
        Self {
            kind: fault.name.clone(),
            count: fault.count,
            message: fault.message.clone(),
            cells: Vec::new(),
            top_cells: Vec::new(),
            points: fault.places.iter().map(|place| place.point.to_vec()).collect(),
        }
    }

    /// A fault of faces in space.
    fn of_faces(fault: &GeometryFaultAnswer) -> Self {
        let cells = fault.places.iter().map(|place| place.vertices.clone());
        let points = fault.places.iter().filter_map(|place| place.point).map(|point| point.to_vec());
        Self {
            kind: fault.name.clone(),
            count: fault.count,
            message: fault.message.clone(),
            cells: cells.filter(|vertices| !vertices.is_empty()).collect(),
            top_cells: Vec::new(),
            points: points.collect(),
        }
    }
}
