//! Models made by rule: the families of `coface generate`.

use crate::arrays;
use crate::errors::invalid;
use crate::model::Model;
use crate::work::run;
use coface::algebra::RaggedArray;
use coface::complexes::grids::CuboidGrid;
use coface::complexes::known_spaces;
use coface::complexes::known_spaces::{FlatManifold, Solid};
use coface::complexes::shapes;
use coface::complexes::shapes::{CellKind, PlacedCells};
use coface::complexes::shapes::{DiskGrid, SphereGrid};
use coface::complexes::simplicial::{Simplex, SimplexSet, SimplicialComplex, SimplicialGrid};
use coface::geometry::Positions;
use coface::io;
use coface::io::Structure;
use coface::{Error, ErrorKind};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

/// All families, in the order of the documentation.
const FAMILIES: &[&str] = &[
    "grid",
    "cuboids",
    "simplex",
    "circle",
    "helix",
    "disk",
    "ring",
    "helicoid",
    "cylinder",
    "cone",
    "sphere",
    "torus",
    "crown",
    "moebius",
    "klein",
    "csaszar",
    "box",
    "ball",
    "rod",
    "solid-torus",
    "hollow-cylinder",
    "hollow-ball",
    "genus",
    "simplex-boundary",
    "cross-polytope",
    "cyclic-torus",
    "torus-grid",
    "klein-grid",
    "small-klein",
    "pinched-torus",
    "strip",
    "rp2",
    "rp",
    "cp2",
    "hp2",
    "k3",
    "lens",
    "poincare",
    "weber-seifert",
    "glued-solid",
    "prism-manifold",
    "truncated-cube",
    "flat",
    "torus-bundle",
    "sphere-bundle",
    "moore",
    "presentation",
    "dunce-hat",
    "house",
    "book",
    "chessboard",
    "matching",
    "sum-complex",
    "barnette",
    "bruckner",
    "rudin-ball",
    "ziegler-ball",
];

/// What a rule makes.
enum Made {
    Cells(PlacedCells),
    Complex(SimplicialComplex),
}

impl Made {
    fn boundary(self) -> Result<Self, Error> {
        let none = || {
            Error::invalid("the model has no boundary: every facet lies in two cells")
                .with_cure("leave boundary out")
        };
        match self {
            Self::Cells(cells) => {
                let boundary = cells.boundary()?.compacted();
                if boundary.cell_count() == 0 { Err(none()) } else { Ok(Self::Cells(boundary)) }
            }
            Self::Complex(complex) => {
                let boundary = SimplexSet::from(&complex).boundary_complex()?;
                if boundary.is_empty() { Err(none()) } else { Ok(Self::Complex(boundary)) }
            }
        }
    }

    fn skeleton(self, dimension: usize) -> Result<Self, Error> {
        match self {
            Self::Cells(cells) => Ok(Self::Cells(cells.skeleton(dimension)?)),
            Self::Complex(complex) => Ok(Self::Complex(complex.skeleton(dimension)?)),
        }
    }

    fn model(self) -> Result<io::Model, Error> {
        match self {
            Self::Cells(cells) => io::Model::from_placed_cells(cells),
            Self::Complex(complex) => {
                let facets = complex.facets();
                let lists = RaggedArray::from_lists(facets.iter().map(Simplex::numbers));
                Ok(io::Model::from_structure(Structure::Facets(lists)))
            }
        }
    }
}

/// The parameters of a family: each is asked for once, and none may be left.
struct Parameters<'py> {
    py: Python<'py>,
    family: String,
    given: Vec<(String, Bound<'py, PyAny>)>,
    known: Vec<&'static str>,
}

impl<'py> Parameters<'py> {
    fn take(&mut self, name: &'static str) -> Option<Bound<'py, PyAny>> {
        self.known.push(name);
        let place = self.given.iter().position(|(given, _)| given == name)?;
        Some(self.given.remove(place).1)
    }

    fn fault(&self, name: &str, value: &Bound<'py, PyAny>, cure: &str) -> PyErr {
        invalid(self.py, format!("{}: {name} is {value}", self.family), cure)
    }

    fn real(&mut self, name: &'static str, usual: f64) -> PyResult<f64> {
        let Some(value) = self.take(name) else { return Ok(usual) };
        value.extract().map_err(|_| self.fault(name, &value, "give a number"))
    }

    fn count(&mut self, name: &'static str, usual: u32) -> PyResult<u32> {
        let Some(value) = self.take(name) else { return Ok(usual) };
        arrays::id(&value, name)
    }

    fn counts(&mut self, name: &'static str, usual: Option<&[u32]>) -> PyResult<Vec<u32>> {
        match (self.take(name), usual) {
            (Some(value), _) => arrays::ids(&value, name),
            (None, Some(usual)) => Ok(usual.to_vec()),
            (None, None) => Err(invalid(
                self.py,
                format!("{} needs {name}", self.family),
                "give one number for each axis",
            )),
        }
    }

    fn flag(&mut self, name: &'static str) -> PyResult<bool> {
        self.take(name).map_or(Ok(false), |value| value.is_truthy())
    }

    fn word(&mut self, name: &'static str) -> PyResult<Option<String>> {
        let Some(value) = self.take(name) else { return Ok(None) };
        match value.cast::<PyString>() {
            Ok(word) => Ok(Some(word.to_str()?.to_ascii_lowercase())),
            Err(_) => Err(self.fault(name, &value, "give a name in quotes")),
        }
    }

    /// One of some words.
    fn choice<T: Copy>(&mut self, name: &'static str, choices: &[(&str, T)]) -> PyResult<Option<T>> {
        let Some(word) = self.word(name)? else { return Ok(None) };
        match choices.iter().find(|(choice, _)| *choice == word) {
            Some((_, value)) => Ok(Some(*value)),
            None => {
                let words: Vec<&str> = choices.iter().map(|(word, _)| *word).collect();
                let message = format!("{}: {name} is {word:?}", self.family);
                Err(invalid(self.py, message, &format!("choose one of {}", words.join(", "))))
            }
        }
    }

    fn cells(&mut self) -> PyResult<CellKind> {
        Ok(if self.flag("cuboids")? { CellKind::Cuboid } else { CellKind::Simplex })
    }

    fn sphere(&mut self, cells: CellKind) -> PyResult<SphereGrid> {
        let usual = if cells == CellKind::Cuboid { 2 } else { 0 };
        let kind = self.choice("kind", &[("ico", 0), ("latitude", 1), ("cube", 2)])?.unwrap_or(usual);
        let subdivisions = self.count("subdivisions", 8)?;
        let (meridians, bands) = (self.count("meridians", 48)?, self.count("bands", 24)?);
        Ok(match kind {
            0 => SphereGrid::Icosahedron { subdivisions },
            1 => SphereGrid::Latitude { meridians, bands },
            _ => SphereGrid::Cube { subdivisions },
        })
    }

    fn done(&self) -> PyResult<()> {
        let Some((name, _)) = self.given.first() else { return Ok(()) };
        let cure = if self.known.is_empty() {
            "it has no parameters".to_owned()
        } else {
            format!("its parameters are {}", self.known.join(", "))
        };
        Err(invalid(self.py, format!("{} has no parameter {name}", self.family), &cure))
    }
}

type Rule = Box<dyn FnOnce() -> Result<Made, Error> + Send>;

fn cells(rule: impl FnOnce() -> Result<PlacedCells, Error> + Send + 'static) -> Rule {
    Box::new(move || rule().map(Made::Cells))
}

fn space(rule: impl FnOnce() -> Result<SimplicialComplex, Error> + Send + 'static) -> Rule {
    Box::new(move || rule().map(Made::Complex))
}

/// Shapes with positions.
fn shape(p: &mut Parameters<'_>) -> PyResult<Option<Rule>> {
    let family = p.family.clone();
    Ok(Some(match &family[..] {
        "grid" => {
            let shape = p.counts("shape", None)?;
            cells(move || {
                let grid = SimplicialGrid::new(&shape)?;
                let lists = grid.simplices()?.to_oriented();
                PlacedCells::new(grid.positions()?, CellKind::Simplex, shape.len(), lists)
            })
        }
        "cuboids" => {
            let lengths: Option<Vec<Vec<f64>>> =
                p.take("lengths").map(|lengths| lengths.extract()).transpose()?;
            let shape = if lengths.is_some() { Vec::new() } else { p.counts("shape", None)? };
            cells(move || {
                let grid = match lengths {
                    Some(lengths) => CuboidGrid::with_lengths(&lengths),
                    None => CuboidGrid::new(&shape),
                }?;
                let Some(dimension) = grid.dimension() else {
                    return Err(Error::invalid("the grid is empty: an axis has no full interval")
                        .with_cure("give each axis an interval"));
                };
                PlacedCells::new(grid.positions()?, CellKind::Cuboid, dimension, grid.cells(dimension)?)
            })
        }
        "simplex" => {
            let dimension = p.count("dimension", 3)?;
            cells(move || simplex(dimension))
        }
        "circle" => {
            let (radius, segments) = (p.real("radius", 1.0)?, p.count("segments", 48)?);
            cells(move || shapes::circle(radius, segments))
        }
        "helix" => {
            let (radius, pitch, turns) =
                (p.real("radius", 1.0)?, p.real("pitch", 1.0)?, p.real("turns", 2.0)?);
            let segments = p.count("segments", 96)?;
            cells(move || shapes::helix(radius, pitch, turns, segments))
        }
        "disk" => {
            let (radius, kind) = (p.real("radius", 1.0)?, p.cells()?);
            let is_square = p.choice("kind", &[("polar", false), ("square", true)])?.unwrap_or(false);
            let (rings, sectors) = (p.count("rings", 8)?, p.count("sectors", 48)?);
            let subdivisions = p.count("subdivisions", 16)?;
            let grid = if is_square {
                DiskGrid::Square { subdivisions }
            } else {
                DiskGrid::Polar { rings, sectors }
            };
            cells(move || shapes::disk(radius, grid, kind))
        }
        "ring" => {
            let (inner, outer) = (p.real("inner_radius", 0.5)?, p.real("outer_radius", 1.0)?);
            let (counts, kind) = ([p.count("rings", 4)?, p.count("sectors", 48)?], p.cells()?);
            cells(move || shapes::ring(inner, outer, counts, kind))
        }
        "helicoid" => {
            let (inner, outer) = (p.real("inner_radius", 0.5)?, p.real("outer_radius", 1.0)?);
            let winding = [p.real("pitch", 1.0)?, p.real("turns", 2.0)?];
            let (counts, kind) = ([p.count("rings", 4)?, p.count("segments", 96)?], p.cells()?);
            cells(move || shapes::helicoid(inner, outer, winding, counts, kind))
        }
        "cylinder" => {
            let (radius, height) = (p.real("radius", 1.0)?, p.real("height", 1.0)?);
            let (counts, kind) = ([p.count("sectors", 48)?, p.count("layers", 8)?], p.cells()?);
            cells(move || shapes::cylinder(radius, height, counts, kind))
        }
        "cone" => {
            let (radius, height) = (p.real("radius", 1.0)?, p.real("height", 1.0)?);
            let counts = [p.count("sectors", 48)?, p.count("layers", 8)?];
            cells(move || shapes::cone(radius, height, counts))
        }
        "sphere" => {
            let (radius, kind) = (p.real("radius", 1.0)?, p.cells()?);
            let grid = p.sphere(kind)?;
            cells(move || shapes::sphere(radius, grid, kind))
        }
        "torus" | "crown" => {
            let (major, minor) = (p.real("major_radius", 2.0)?, p.real("minor_radius", 1.0)?);
            let (counts, kind) = ([p.count("columns", 48)?, p.count("rows", 24)?], p.cells()?);
            let make = if family == "torus" { shapes::torus } else { shapes::crown };
            cells(move || make(major, minor, counts, kind))
        }
        "moebius" => {
            let (radius, width) = (p.real("radius", 2.0)?, p.real("width", 1.0)?);
            let (counts, kind) = ([p.count("columns", 48)?, p.count("rows", 4)?], p.cells()?);
            cells(move || shapes::moebius(radius, width, counts, kind))
        }
        "klein" => {
            let (major, minor) = (p.real("major_radius", 3.0)?, p.real("minor_radius", 1.0)?);
            let (counts, kind) = ([p.count("columns", 48)?, p.count("rows", 24)?], p.cells()?);
            let make = match p.count("space", 3)? {
                3 => shapes::klein_bottle,
                4 => shapes::klein_bottle_in_4d,
                other => return Err(invalid(p.py, format!("klein: space is {other}"), "give 3 or 4")),
            };
            cells(move || make(major, minor, counts, kind))
        }
        "csaszar" => cells(shapes::csaszar_torus),
        "box" => {
            let sizes = p.take("sizes").map_or(Ok(vec![1.0; 3]), |sizes| arrays::finite(&sizes, "sizes"))?;
            let (shape, kind) = (p.counts("shape", Some(&vec![1; sizes.len()]))?, p.cells()?);
            cells(move || shapes::cuboid(&sizes, &shape, kind))
        }
        "ball" => {
            let (radius, subdivisions, kind) =
                (p.real("radius", 1.0)?, p.count("subdivisions", 8)?, p.cells()?);
            cells(move || shapes::ball(radius, subdivisions, kind))
        }
        "rod" => {
            let (radius, height) = (p.real("radius", 1.0)?, p.real("height", 1.0)?);
            let (counts, kind) = ([p.count("subdivisions", 8)?, p.count("layers", 8)?], p.cells()?);
            cells(move || shapes::rod(radius, height, counts, kind))
        }
        "solid-torus" => {
            let (major, minor) = (p.real("major_radius", 2.0)?, p.real("minor_radius", 1.0)?);
            let (counts, kind) = ([p.count("subdivisions", 4)?, p.count("sectors", 48)?], p.cells()?);
            cells(move || shapes::solid_torus(major, minor, counts, kind))
        }
        "hollow-cylinder" => {
            let radii = [p.real("inner_radius", 0.5)?, p.real("outer_radius", 1.0)?];
            let height = p.real("height", 1.0)?;
            let counts = [p.count("shells", 2)?, p.count("sectors", 48)?, p.count("layers", 8)?];
            let kind = p.cells()?;
            cells(move || shapes::hollow_cylinder(radii, height, counts, kind))
        }
        "hollow-ball" => {
            let radii = [p.real("inner_radius", 0.5)?, p.real("outer_radius", 1.0)?];
            let (shells, kind) = (p.count("shells", 2)?, p.cells()?);
            let grid = p.sphere(kind)?;
            cells(move || shapes::hollow_ball(radii, grid, shells, kind))
        }
        "genus" => {
            let (genus, subdivisions) = (p.count("genus", 2)?, p.count("subdivisions", 1)?);
            let (is_solid, kind) = (p.flag("solid")?, p.cells()?);
            cells(move || {
                let plate = shapes::plate_with_holes(genus, subdivisions, kind)?;
                if is_solid { Ok(plate) } else { Ok(plate.boundary()?.compacted()) }
            })
        }
        _ => return Ok(None),
    }))
}

/// Known spaces, as facets without positions.
fn known_space(p: &mut Parameters<'_>) -> PyResult<Option<Rule>> {
    let family = p.family.clone();
    Ok(Some(match &family[..] {
        "simplex-boundary" => {
            let dimension = p.count("dimension", 2)? as usize;
            space(move || known_spaces::simplex_boundary(dimension))
        }
        "cross-polytope" => {
            let dimension = p.count("dimension", 2)? as usize;
            space(move || known_spaces::cross_polytope_boundary(dimension))
        }
        "cyclic-torus" => {
            let dimension = p.count("dimension", 2)? as usize;
            space(move || known_spaces::cyclic_torus(dimension))
        }
        "torus-grid" => {
            let shape = p.counts("shape", Some(&[3, 3]))?;
            space(move || known_spaces::torus_grid(&shape))
        }
        "klein-grid" => {
            let (columns, rows) = (p.count("columns", 5)?, p.count("rows", 5)?);
            space(move || known_spaces::klein_grid(columns, rows))
        }
        "small-klein" => space(known_spaces::small_klein_bottle),
        "pinched-torus" => {
            let (columns, rows) = (p.count("columns", 6)?, p.count("rows", 6)?);
            space(move || known_spaces::pinched_torus_grid(columns, rows))
        }
        "strip" => {
            let vertices = p.count("vertices", 5)?;
            space(move || known_spaces::triangle_strip(vertices))
        }
        "rp2" => space(known_spaces::projective_plane),
        "rp" => {
            let dimension = p.count("dimension", 3)? as usize;
            space(move || known_spaces::real_projective_space(dimension))
        }
        "cp2" => space(known_spaces::complex_projective_plane),
        "hp2" => space(known_spaces::quaternionic_projective_plane),
        "k3" => space(known_spaces::k3_surface),
        "lens" => {
            let (order, twist) = (p.count("p", 5)?, p.count("q", 2)?);
            space(move || known_spaces::lens_space(order, twist))
        }
        "poincare" => space(|| known_spaces::glued_solid(Solid::Dodecahedron, 2)),
        "weber-seifert" => space(|| known_spaces::glued_solid(Solid::Dodecahedron, 1)),
        "glued-solid" => {
            let solids = [
                ("cube", Solid::Cube),
                ("octahedron", Solid::Octahedron),
                ("dodecahedron", Solid::Dodecahedron),
            ];
            let solid = p.choice("solid", &solids)?.unwrap_or(Solid::Cube);
            let steps = p.count("steps", 1)? as usize;
            space(move || known_spaces::glued_solid(solid, steps))
        }
        "prism-manifold" => {
            let n = p.count("n", 2)?;
            space(move || known_spaces::prism_manifold(n))
        }
        "truncated-cube" => space(known_spaces::truncated_cube_space),
        "flat" => {
            let names = ["g1", "g2", "g3", "g4", "g5", "g6", "b1", "b2", "b3", "b4"];
            let all: Vec<(&str, FlatManifold)> = names.into_iter().zip(FlatManifold::ALL).collect();
            let manifold = p.choice("manifold", &all)?.unwrap_or(FlatManifold::G6);
            space(move || known_spaces::flat_manifold(manifold))
        }
        "torus-bundle" => {
            let matrix =
                p.take("matrix").map_or(Ok(vec![2, 1, 1, 1]), |matrix| arrays::numbers(&matrix, "matrix"))?;
            let [a, b, c, d] = matrix[..] else {
                let message = format!("a matrix of {} entries is no monodromy of a torus", matrix.len());
                return Err(invalid(p.py, message, "give [[a, b], [c, d]]"));
            };
            space(move || known_spaces::torus_bundle([[a, b], [c, d]]))
        }
        "sphere-bundle" => {
            let dimension = p.count("dimension", 3)?;
            let vertices = p.count("vertices", dimension.saturating_mul(2).saturating_add(3))?;
            space(move || known_spaces::sphere_bundle_over_circle(dimension, vertices))
        }
        "moore" => {
            let order = p.count("order", 3)?;
            space(move || known_spaces::moore_space(order))
        }
        "presentation" => {
            let generators = p.count("generators", 0)?;
            let relators: Vec<Vec<i32>> =
                p.take("relators").map(|relators| relators.extract()).transpose()?.unwrap_or_default();
            space(move || known_spaces::presentation_complex(generators, &relators))
        }
        "dunce-hat" => space(known_spaces::dunce_hat),
        "house" => space(known_spaces::house_with_two_rooms),
        "book" => {
            let pages = p.count("pages", 3)?;
            space(move || known_spaces::book(pages))
        }
        "chessboard" => {
            let (rows, columns) = (p.count("rows", 3)?, p.count("columns", 4)?);
            space(move || known_spaces::chessboard(rows, columns))
        }
        "matching" => {
            let count = p.count("count", 7)?;
            space(move || known_spaces::matching_complex(count))
        }
        "sum-complex" => {
            let (modulus, sums) = (p.count("modulus", 7)?, p.counts("sums", Some(&[0, 1, 3]))?);
            space(move || known_spaces::sum_complex(modulus, &sums))
        }
        "barnette" => space(known_spaces::barnette_sphere),
        "bruckner" => space(known_spaces::bruckner_sphere),
        "rudin-ball" => space(known_spaces::rudin_ball),
        "ziegler-ball" => space(known_spaces::ziegler_ball),
        _ => return Ok(None),
    }))
}

fn simplex(dimension: u32) -> Result<PlacedCells, Error> {
    if dimension > 20 {
        return Err(Error::new(ErrorKind::TooLarge, format!("a simplex of dimension {dimension}"))
            .with_cure("give a dimension of 20 or less"));
    }
    let width = dimension.max(1) as usize;
    let coordinate = |vertex: u32| (0..width).map(move |axis| f64::from(u8::from(axis as u32 + 1 == vertex)));
    let coordinates = (0..=dimension).flat_map(coordinate).collect();
    let cell: Vec<u32> = (0..=dimension).collect();
    let positions = Positions::from_flat(width, coordinates)?;
    PlacedCells::new(positions, CellKind::Simplex, dimension as usize, RaggedArray::from_lists([cell]))
}

/// A model made by rule: a grid, a shape with positions, or a known space.
///
/// Shapes are oriented coherently where that is possible, closed surfaces with the normal outward, solids positively.
///
/// Parameters
/// ----------
/// family : str
///     The name of the family; :func:`families` lists them. ``_`` and ``-`` are the same.
/// boundary : bool
///     The boundary of the model instead: the facets of exactly one cell.
/// skeleton : int, optional
///     The cells of this dimension instead, after ``boundary``.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
/// **parameters
///     Those of ``coface generate FAMILY``, with ``_`` for ``-``: ``major_radius=3.0``, ``columns=64``, ``shape=(2, 3)``, ``cuboids=True``.
///
/// Returns
/// -------
/// Model
///     The model.
///
/// Examples
/// --------
/// >>> import coface
/// >>> coface.generate("torus", columns=8, rows=6)
/// Model(48 vertices, 96 faces)
/// >>> coface.generate("lens", p=7, q=3).report().homology
/// Homology(Z, Z/7, 0, Z)
#[pyfunction]
#[pyo3(signature = (family, *, boundary=false, skeleton=None, progress=None, **parameters))]
pub(crate) fn generate(
    py: Python<'_>,
    family: &str,
    boundary: bool,
    skeleton: Option<usize>,
    progress: Option<&Bound<'_, PyAny>>,
    parameters: Option<&Bound<'_, PyDict>>,
) -> PyResult<Model> {
    let given = parameters.into_iter().flatten();
    let given: Vec<(String, Bound<'_, PyAny>)> =
        given.map(|(name, value)| Ok((name.extract()?, value))).collect::<PyResult<_>>()?;
    let mut p = Parameters { py, family: family.replace('_', "-"), given, known: Vec::new() };
    let rule = match shape(&mut p)? {
        Some(rule) => rule,
        None => known_space(&mut p)?.ok_or_else(|| {
            let cure = format!("choose one of {}", FAMILIES.join(", "));
            invalid(py, format!("{family:?} is no family known here"), &cure)
        })?,
    };
    p.done()?;
    run(py, progress, || {
        let mut made = rule()?;
        if boundary {
            made = made.boundary()?;
        }
        if let Some(dimension) = skeleton {
            made = made.skeleton(dimension)?;
        }
        made.model()
    })
    .map(Model::of)
}

/// The families that :func:`generate` knows.
///
/// Returns
/// -------
/// list of str
///     Their names.
///
/// Examples
/// --------
/// >>> import coface
/// >>> "torus" in coface.families()
/// True
#[pyfunction]
pub(crate) fn families() -> Vec<&'static str> {
    FAMILIES.to_vec()
}
