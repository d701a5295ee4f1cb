//! `coface boolean`: regions of the plane, or solids, combined.

mod dissolve;
mod planar;
mod spatial;

use super::arrange::{CellOptions, Inputs, SpaceOptions, check_json, dimension_of, output_target};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::progress::Progress;
use clap::{Args, ValueEnum, error::ErrorKind};
use coface::answers::RegionSource;
use coface::arrange::boolean::BooleanFormula;
use spatial::SolidOptions;
use std::path::PathBuf;

/// Combine regions of the plane or solids: union, intersection, difference, xor, or any formula.
///
/// The operation comes first, then any number of inputs; a difference is the first without all others, xor is what lies in an odd
/// number. With --formula there is no operation: "(a | b) - c" names the inputs by letters, or by numbers from 0, and has
/// ! for complement, & for intersection, - for difference, ^ for xor, | for union, from the tightest to the loosest.
///
/// Inputs in the plane are polygons (GeoJSON, WKT, WKB, SVG, meshes), or files of closed lines (.lines, OBJ). Lines of WKT, WKB and GeoJSON
/// bound nothing, unless --close takes those that end where they begin as rings. All that name a reference system (SRID, crs) must
/// name the same; it is written again, and so are heights of maps, which decide nothing: a crossing has the mean of those along its sides. The result has polygons with holes: outer
/// rings run counterclockwise, all rings are simple and touch in points only. What a ring winds around is inside of it, also where
/// it crosses itself; holes are subtracted, and an SVG says its own rule. --rule says otherwise, and --strict refuses such rings. As .json the
/// result is a chain complex whose faces are disks; with --exact it loses nothing: arrange and boolean take its points as they are.
///
/// A polygon in GeoJSON has the properties "polygon", "area" and "regions", and the properties of all features of
/// GeoJSON or TopoJSON that contain some of it: a key with equal values keeps its value, a key with different values
/// has the list of them in the order of the inputs. A property of a feature that is called "polygon", "area" or
/// "regions" is left out.
///
/// With --dissolve NAME the union has one feature for each value of the property NAME: it unites the features that have the value, so
/// their common borders vanish. In GeoJSON it has NAME, "features" (how many were united), "area", and the properties that all of them have
/// with one value. Features without NAME, or with null, are a group of their own, the last.
///
/// Inputs in space are closed surfaces, volume meshes (the union of their cells), or chain complexes with positions (the union of
/// their cells of degree 3, or the surface of their faces). The result is a surface that runs counterclockwise seen from outside; as .json
/// a chain complex with solids as cells, or with --keep-walls the cells of the arrangement, cut until each is a ball; .glb, .gltf and
/// .png, in space .svg too, are to be looked at. Triangles in one plane that nothing of the result separates, and faces of one input, are put together and
/// drawn as one polygon is, where coordinates are rounded within that rounding; --keep-coplanar keeps them apart.
///
/// With --json: "measure" (the area or volume), "f_vector", "components", "closed", "manifold" with its witness; in the plane also
/// "polygons", "holes", "measures", "pinches" (vertices where more than two edges of the boundary meet), "rounding"; in space also
/// "area", "genus", "solids", "voids", "walls", "pinches" (edges in more than two polygons, and vertices, with coordinates), "files",
/// "rounding" (whether the rounded surface is valid: faces that cross, parts that are flat or inside out).
#[derive(Args)]
pub(crate) struct Boolean {
    /// union, intersection, difference or xor, unless there is a formula; then the inputs
    #[arg(required = true, value_name = "OPERATION|INPUT")]
    arguments: Vec<PathBuf>,
    /// A formula of the inputs: a, b, c, .. or 0, 1, 2, ..
    #[arg(long, value_name = "FORMULA", allow_hyphen_values = true)]
    formula: Option<String>,
    #[command(flatten)]
    cells: CellOptions,
    /// What an input of the formula is [default: files; objects if the formula names more inputs than there are files]
    #[arg(long, value_name = "WHAT")]
    inputs: Option<Inputs>,
    /// Keep the walls between cells that are selected both
    #[arg(long)]
    keep_walls: bool,
    /// Unite the features of maps that have the same value of this property, each group by itself; given several times, those with
    /// the same values of all
    #[arg(long, value_name = "NAME", conflicts_with_all = ["formula", "inputs", "keep_walls", "provenance", "certificate"])]
    dissolve: Vec<String>,
    /// Write where each vertex, edge and polygon of the result comes from: .json
    #[arg(long, value_name = "FILE")]
    provenance: Option<PathBuf>,
    #[command(flatten)]
    space: SpaceOptions,
    #[command(flatten)]
    solids: SolidOptions,
}

/// An operation by its name.
#[derive(Clone, Copy, ValueEnum)]
enum Operation {
    Union,
    Intersection,
    Difference,
    Xor,
}

/// What to do with the inputs.
enum Task {
    Named(Operation),
    Formula(BooleanFormula),
}

impl Task {
    /// The number of inputs that it needs.
    fn least_inputs(&self) -> usize {
        match self {
            Self::Formula(formula) => formula.input_count(),
            Self::Named(_) => 1,
        }
    }

    /// The formula on so many inputs.
    fn formula(&self, count: usize) -> BooleanFormula {
        match self {
            Self::Formula(formula) => formula.clone(),
            Self::Named(Operation::Union) => BooleanFormula::union(count),
            Self::Named(Operation::Intersection) => BooleanFormula::intersection(count),
            Self::Named(Operation::Difference) => BooleanFormula::difference(count),
            Self::Named(Operation::Xor) => BooleanFormula::xor(count),
        }
    }
}

impl Boolean {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let (task, inputs) = self.task()?;
        dissolve::check(self, &task)?;
        let output = output_target(common)?;
        if let Some(path) = &self.provenance {
            check_json(path)?;
        }
        self.cells.check_certificate(inputs, self.region_source(), common)?;
        let progress = Progress::start(common.quiet);
        let models = self.cells.read(inputs, common, &progress)?;
        match dimension_of(&models, self.cells.dimension) {
            2 => planar::run(self, &task, common, output, inputs, &models, progress),
            _ => {
                self.cells.refuse_planar()?;
                if !self.dissolve.is_empty() {
                    return Err(Failure::new(
                        "--dissolve is for maps in the plane, and the inputs lie in space: leave it out",
                    ));
                }
                spatial::run(self, &task, common, output, inputs, &models, progress)
            }
        }
    }

    /// The operation or formula, and the files.
    fn task(&self) -> Result<(Task, &[PathBuf]), Failure> {
        if let Some(formula) = &self.formula {
            let parsed = BooleanFormula::parse(formula, &[]);
            let formula = parsed.map_err(|error| Failure::new(format!("--formula: {error}")))?;
            return Ok((Task::Formula(formula), &self.arguments));
        }
        let name = self.arguments[0].to_string_lossy();
        let operation = Operation::from_str(&name, false).map_err(|_| {
            let message = format!(
                "\"{name}\" is no operation: begin with union, intersection, difference or xor, or give --formula"
            );
            Failure::Usage(ErrorKind::InvalidValue, message)
        })?;
        if self.arguments.len() < 2 {
            let message = "name the inputs after the operation";
            return Err(Failure::Usage(ErrorKind::MissingRequiredArgument, message.to_owned()));
        }
        Ok((Task::Named(operation), &self.arguments[1..]))
    }

    /// What makes an input of a formula in the plane.
    fn region_source(&self) -> RegionSource {
        self.inputs.map_or_else(RegionSource::default, Inputs::source)
    }
}
