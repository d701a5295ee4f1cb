//! `coface arrange`: what drawings cut the plane into, and surfaces space.

mod planar;
mod spatial;

pub(crate) use spatial::{
    SpaceOptions, asks_for_exact_cells, in_space, is_stl, larger_polygons, refuse_certificate, rounding,
    scene_of, stacked, written_as_triangles,
};

use crate::arguments::{Common, length};
use crate::certified;
use crate::failure::Failure;
use crate::input::{self, Loaded};

use crate::progress::Progress;
use crate::target::{Target, written_format};
use clap::{Args, ValueEnum};
use coface::answers::{ArrangementMethod, RegionSource, are_planar, welded};
use coface::arrange::boolean::InsideRule;
use coface::io::{Format, Model};
use std::path::{Path, PathBuf};

/// Cut the plane or space into cells: the arrangement of segments, polylines and polygons.
///
/// Inputs are any mix of drawings: segments (.lines), OBJ with lines or polygons, GeoJSON, WKT, WKB, SVG. All that name a reference
/// system (SRID, crs) must name the same; it is written again. They are planar when all points
/// have two coordinates or lie at height 0; otherwise polygons cut space. Maps (WKT, WKB, GeoJSON) with heights lie in the plane too: heights
/// decide nothing and are written again; a crossing has the mean of the heights along its two sides. Everything is exact: nothing is decided with a tolerance, but
/// for --tolerance. Where rounded coordinates would make faces in space cross, what is so near is put together, and a remark says so;
/// --exact keeps them, and .json written with it, in the plane and in space, loses nothing: arrange and boolean take its points as they are.
///
/// With -o the complex is written: GeoJSON, WKT, WKB (.wkb, digits as .hex) and SVG have faces as polygons with holes; OBJ, PLY and VTK as polygons of a mesh;
/// .lines has the edges; .json the chain complex with positions. .glb, .gltf and .png, in space .svg too, are to be looked at.
///
/// A face in GeoJSON has the properties "face", "area" and "inside", and the properties of all features of GeoJSON or
/// TopoJSON that contain it: a key with equal values keeps its value, a key with different values has the list of
/// them in the order of the inputs. A property of a feature that is called "face", "area" or "inside" is left out
/// where the face has its own.
///
/// With --attributes FILE the faces that inputs contain are written as a table that GIS reads: each has the properties of all features that contain it
/// and nothing else. All faces have the same keys. A key that several inputs have is one for each, "key_1" of the first input, "key_2" of the second;
/// the value is null where the input does not contain the face.
///
/// With --json: "dimension", "f_vector", "measures" (areas of the bounded faces, volumes of the bounded cells), "inside" (for each
/// the inputs that contain it, numbered from 0), "products_zero" (the boundary of every boundary, found by multiplying),
/// "holes"; in the plane also "components", "bridges" (edges with one face on both sides), "dangling_edges" (those that hang on
/// the rest by one end), "rounding" (whether coordinates are exact, and whether the drawing with rounded ones is the same
/// complex), "snap_rounds", "joined" (what --tolerance put together).
///
/// In space also "voids", "components", "dangling_faces", "files" (whether each is closed, how many edges its rim has, around how many
/// cells it winds less than zero times, or more than once), "degenerate_polygons", "split_polygons", "rounding", "joined". OBJ has a group for each
/// cell; VTK and PLY have the cells on both sides of each polygon and where it is from.
///
/// With --method congruence, segments, in space polygons in their own planes, are cut one by one in rounded numbers, and vertices, edges
/// and faces that are within --tolerance of each other become one: for drawings and surfaces that meet only nearly. Without --tolerance it is
/// 1e-9 of the extent, with a remark. "congruence" says how many
/// cells were stacked, the largest distance of two vertices that became one, and what collapsed; "joined" has the classes of points, and in
/// space --provenance the polygons of each vertex, edge and face. In space --snap, --exact and --merge-coplanar are of the exact
/// arrangement of what is glued, on the points where it is.
///
/// With --inputs each object, group or component of a file is an input, so that a building may be one
/// file: "regions" has their
/// names, "inputs_of_faces" the inputs of each face in space, and OBJ a group for each.
///
/// With --graph in space: "nodes", the bounded cells with volume, centroid, bounds, the inputs that contain them and
/// the area of their faces on
/// the exterior; "edges", pairs of cells with the area and number of the faces between them and the inputs that these
/// are of; "inputs", the names.
///
/// A file contains what its polygons contain. Lines of WKT, WKB and GeoJSON contain nothing, unless --close takes those that end where they
/// begin as rings. Another file of lines alone (.lines, OBJ) contains what they enclose an odd number of times, whatever --rule says, if they are
/// closed: if an even number of them ends at every point.
#[derive(Args)]
pub(crate) struct Arrange {
    /// The drawings or surfaces; - is standard input
    #[arg(required = true, value_name = "INPUT")]
    inputs: Vec<PathBuf>,
    #[command(flatten)]
    cells: CellOptions,
    /// What an input is, then named in "regions" [default: files]
    #[arg(long = "inputs", value_name = "WHAT")]
    source: Option<Inputs>,
    /// Leave out edges with one face on both sides: bridges and dangling edges
    #[arg(long, conflicts_with = "certificate")]
    prune: bool,
    /// Write where each vertex, edge and face comes from: .json
    #[arg(long, value_name = "FILE")]
    provenance: Option<PathBuf>,
    /// In the plane, write the faces that inputs contain, each with the properties of all inputs that contain it: .geojson
    #[arg(long, value_name = "FILE")]
    attributes: Option<PathBuf>,
    /// In space, write the graph of the cells, which are adjacent across how much area: .json or .graphml
    #[arg(long, value_name = "FILE")]
    graph: Option<PathBuf>,
    #[command(flatten)]
    space: SpaceOptions,
}

/// Options of arrangements and of what stands on them.
#[derive(Args)]
pub(crate) struct CellOptions {
    /// Whether inputs lie in the plane or in space [default: in the plane if all do]; 2 leaves out the heights of maps
    #[arg(long, value_name = "D", value_parser = clap::value_parser!(u8).range(2..=3))]
    pub(crate) dimension: Option<u8>,
    /// Which winding numbers are inside [default: nonzero, but what an SVG says; holes count against outer rings]
    #[arg(long, value_name = "RULE")]
    pub(crate) rule: Option<Rule>,
    /// In the plane, take lines that end where they begin as rings of polygons
    #[arg(long)]
    pub(crate) close: bool,
    /// Round coordinates and arrange again until all vertices are where their coordinates say
    #[arg(long)]
    pub(crate) snap: bool,
    /// In the plane, put all vertices on the grid with this step, in the unit of the inputs: coordinates are multiples of R
    #[arg(long, value_name = "R", allow_negative_numbers = true, value_parser = length)]
    pub(crate) grid: Option<f64>,
    /// Keep the exact cells, also where rounding their coordinates makes edges or faces cross; .json keeps exact points too
    #[arg(long, conflicts_with_all = ["snap", "grid"])]
    pub(crate) exact: bool,
    /// Before anything else, merge vertices of each input that are at most R apart, in the unit of the inputs; none moves farther
    #[arg(long, value_name = "R", allow_negative_numbers = true, value_parser = length)]
    pub(crate) weld: Option<f64>,
    /// Put vertices, edges, in space faces and planes too, together that are at most R apart, in the unit of the inputs
    #[arg(long, value_name = "R", conflicts_with = "grid", allow_negative_numbers = true, value_parser = length)]
    pub(crate) tolerance: Option<f64>,
    /// How cells are found [default: exact]
    #[arg(long, value_name = "METHOD")]
    pub(crate) method: Option<Method>,
    /// Refuse an arrangement of more than N cells
    #[arg(long, value_name = "N")]
    pub(crate) max_cells: Option<usize>,
    /// A certificate of the exact cells, which coface check verifies: in the plane of WKT and GeoJSON of two coordinates, and .lines; in
    /// space of surfaces as plain OFF and OBJ; in the binary form if OUT ends in .bin
    #[arg(long, value_name = "OUT", conflicts_with_all = ["close", "snap", "grid", "weld", "tolerance"])]
    pub(crate) certificate: Option<PathBuf>,
}

impl CellOptions {
    /// The inputs with their names, vertices merged if that was asked for.
    pub(crate) fn read(
        &self,
        inputs: &[PathBuf],
        common: &Common,
        progress: &Progress,
    ) -> Result<Vec<(String, Model)>, Failure> {
        let mut models = read_all(inputs, common, progress)?;
        if let Some(radius) = self.weld {
            for (name, model) in &mut models {
                let (made, done) = welded(model, radius).map_err(|error| error.in_file(name.clone()))?;
                *model = made.with_remarks(done.remark());
            }
        }
        Ok(models)
    }

    /// How cells are found.
    pub(crate) fn method(&self) -> ArrangementMethod {
        match self.method {
            Some(Method::Congruence) => ArrangementMethod::Congruence,
            Some(Method::Exact) | None => ArrangementMethod::Exact,
        }
    }

    /// Refuses, before the work, a certificate that cannot be made or written.
    pub(crate) fn check_certificate(
        &self,
        inputs: &[PathBuf],
        source: RegionSource,
        common: &Common,
    ) -> Result<(), Failure> {
        let Some(place) = &self.certificate else { return Ok(()) };
        certified::check_other_output(place, inputs, common)?;
        certified::refuse_standard_input(inputs)?;
        match source {
            RegionSource::Models => Ok(()),
            _ => Err(Failure::new(
                "--certificate proves what files contain, not their parts: leave --inputs out",
            )),
        }
    }

    /// Refuses what is for drawings in the plane.
    pub(crate) fn refuse_planar(&self) -> Result<(), Failure> {
        if self.close {
            return Err(Failure::new(
                "--close is for drawings in the plane, and the inputs lie in space: leave it out",
            ));
        }
        match self.grid {
            None => Ok(()),
            Some(_) => Err(Failure::new(
                "--grid is for drawings in the plane, and the inputs lie in space: leave it out",
            )),
        }
    }
}

/// How cells are found.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum Method {
    /// All decisions are exact; --tolerance puts features together before
    Exact,
    /// Each segment, in space each polygon in its own plane, is cut for itself, and pieces within --tolerance of each other become one
    /// [without it: within 1e-9 of the extent]
    Congruence,
}

/// What an input is.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum Inputs {
    /// Each file
    Files,
    /// The polygons of one name, or those of a feature without a name
    Features,
    /// Each object of a file: o of OBJ, a named mesh of glTF, 3MF or COLLADA, an object of CityJSON
    Objects,
    /// Each group of a file: g of OBJ, a physical group of Gmsh, a kind of surface of CityJSON
    Groups,
    /// Polygons or cells that are connected through vertices
    Components,
}

impl Inputs {
    /// What makes an input.
    pub(crate) fn source(self) -> RegionSource {
        match self {
            Self::Files => RegionSource::Models,
            Self::Features => RegionSource::Features,
            Self::Objects => RegionSource::Objects,
            Self::Groups => RegionSource::Groups,
            Self::Components => RegionSource::Components,
        }
    }
}

/// Which winding numbers are inside.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum Rule {
    /// All but zero
    Nonzero,
    /// The odd ones
    #[value(alias = "odd", alias = "even-odd")]
    Evenodd,
    /// Those above zero
    Positive,
}

impl Rule {
    pub(crate) fn inside(self) -> InsideRule {
        match self {
            Self::Nonzero => InsideRule::Nonzero,
            Self::Evenodd => InsideRule::Odd,
            Self::Positive => InsideRule::Positive,
        }
    }
}

impl Arrange {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let output = output_target(common)?;
        if let Some(path) = &self.provenance {
            check_json(path)?;
        }
        if let Some(path) = &self.graph {
            spatial::check_graph(path)?;
        }
        if let Some(path) = &self.attributes
            && Format::from_path(path) != Some(Format::GeoJson)
        {
            return Err(Failure::new(format!(
                "{}: properties are written as GeoJSON: name a .geojson file",
                path.display()
            )));
        }
        let source = self.source.map_or_else(RegionSource::default, Inputs::source);
        self.cells.check_certificate(&self.inputs, source, common)?;
        let progress = Progress::start(common.quiet);
        let models = self.cells.read(&self.inputs, common, &progress)?;
        match dimension_of(&models, self.cells.dimension) {
            2 => planar::run(self, common, output, &models, progress),
            _ => {
                self.cells.refuse_planar()?;
                if self.attributes.is_some() {
                    return Err(Failure::new(
                        "--attributes is for maps in the plane, and the inputs lie in space: leave it out",
                    ));
                }
                spatial::run(self, common, output, &models, progress)
            }
        }
    }
}

/// The inputs with their names.
pub(crate) fn read_all(
    inputs: &[PathBuf],
    common: &Common,
    progress: &Progress,
) -> Result<Vec<(String, Model)>, Failure> {
    let mut models = Vec::new();
    for path in inputs {
        let Loaded { name, model, .. } = input::read(path, common.reading(), progress)?;
        models.push((name, model));
    }
    Ok(models)
}

/// 2 if all models lie in the plane, else 3; or what was asked for.
pub(crate) fn dimension_of(models: &[(String, Model)], asked: Option<u8>) -> u8 {
    asked.unwrap_or_else(|| if are_planar(models.iter().map(|(_, model)| model)) { 2 } else { 3 })
}

/// The file of -o with what it is.
pub(crate) fn output_target(common: &Common) -> Result<Option<(&Path, Target)>, Failure> {
    let Some(path) = common.output.as_deref() else { return Ok(None) };
    Ok(Some((path, Target::of_path(path)?)))
}

/// The file of -o with its format, which may be that of sets in the plane.
pub(crate) fn output_format(common: &Common) -> Result<Option<(&Path, Format)>, Failure> {
    let Some(path) = common.output.as_deref() else { return Ok(None) };
    let format = match Format::from_path(path) {
        Some(Format::Dat) => Format::Dat,
        _ => written_format(path, "")?,
    };
    Ok(Some((path, format)))
}

/// Refuses a file that is not named as JSON.
pub(crate) fn check_json(path: &Path) -> Result<(), Failure> {
    if crate::output::is_json(path) {
        return Ok(());
    }
    Err(Failure::new(format!("{}: provenance is written as JSON: name a .json file", path.display())))
}
