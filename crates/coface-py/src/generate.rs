//! Models made by rule: the families of `coface generate`.

use crate::arrays;
use crate::errors::{invalid, whole_or_none};
use crate::model::Model;
use crate::work::run;
use coface::Error;
use coface::algebra::RaggedArray;
use coface::complexes::families::{Family, FamilyModel, Parameter, ParameterKind, ParameterValue};
use coface::complexes::grids::CuboidGrid;
use coface::complexes::shapes::{CellKind, PlacedCells};
use coface::complexes::simplicial::{Simplex, SimplicialGrid};
use coface::io;
use coface::io::Structure;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

/// What is given for parameters, by their names.
type Given<'py> = Vec<(String, Bound<'py, PyAny>)>;

type Rule = Box<dyn FnOnce() -> Result<FamilyModel, Error> + Send>;

/// The value of a parameter of a family.
fn value_of(
    py: Python<'_>,
    family: &Family,
    parameter: &Parameter,
    value: &Bound<'_, PyAny>,
) -> PyResult<ParameterValue> {
    let name = parameter.name();
    let fault = |cure: &str| invalid(py, format!("{}: {name} is {value}", family.name()), cure);
    Ok(match parameter.kind() {
        ParameterKind::Real { .. } => {
            ParameterValue::Real(value.extract().map_err(|_| fault("give a number"))?)
        }
        ParameterKind::Count { .. } => ParameterValue::Count(
            arrays::id(value, name).map_err(|_| fault("give an integer from 0 on, below 4294967296"))?,
        ),
        ParameterKind::Counts { .. } => ParameterValue::Counts(arrays::ids(value, name)?),
        ParameterKind::Reals { .. } => ParameterValue::Reals(arrays::finite(value, name)?),
        ParameterKind::Integers { .. } => ParameterValue::Integers(arrays::numbers(value, name)?),
        ParameterKind::Flag => ParameterValue::Flag(value.is_truthy()?),
        ParameterKind::Choice { .. } => {
            let word = value.cast::<PyString>().map_err(|_| fault("give a name in quotes"))?;
            ParameterValue::Choice(word.to_str()?.to_ascii_lowercase())
        }
        ParameterKind::Words => ParameterValue::Words(value.extract()?),
    })
}

/// The parameter `cuboids`, whose cells have names of their own in each dimension.
const CUBOIDS: &str = "cuboids";

/// The name of a parameter in the table of families: `quadrangles` and `hexahedra` are `cuboids` there.
fn known_name(py: Python<'_>, family: &Family, name: &str, given: &Given<'_>) -> PyResult<String> {
    let has_cuboids = family.parameters().iter().any(|parameter| parameter.name() == CUBOIDS);
    let is_alias = |name: &str| has_cuboids && matches!(name, CUBOIDS | "quadrangles" | "hexahedra");
    if !is_alias(name) {
        return Ok(name.to_owned());
    }
    if let Some((other, _)) = given.iter().find(|(other, _)| other != name && is_alias(other)) {
        let message = format!("{}: {name} and {other} are one parameter", family.name());
        return Err(invalid(py, message, "give one of them"));
    }
    Ok(CUBOIDS.to_owned())
}

/// The rule of a family with these values.
fn member(py: Python<'_>, family: &'static Family, given: &Given<'_>) -> PyResult<Rule> {
    let mut values = Vec::with_capacity(given.len());
    for (name, value) in given {
        let name = &known_name(py, family, name, given)?;
        let parameter = family.parameters().iter().find(|parameter| parameter.name() == name);
        // What the family does not have is named by it, whatever its value.
        let value =
            parameter.map_or(Ok(ParameterValue::Flag(true)), |known| value_of(py, family, known, value))?;
        values.push((name.clone(), value));
    }
    Ok(Box::new(move || {
        let values: Vec<(&str, ParameterValue)> =
            values.iter().map(|(name, value)| (name.as_str(), value.clone())).collect();
        family.make(&values)
    }))
}

/// The grids, which are made of the numbers of their cells.
const GRIDS: [&str; 2] = ["grid", "cuboids"];

fn grid(py: Python<'_>, family: &str, given: &Given<'_>) -> PyResult<Rule> {
    let known: &[&str] = if family == "grid" { &["shape"] } else { &["lengths", "shape"] };
    let parameter = |name: &str| given.iter().find(|(given, _)| given == name).map(|(_, value)| value);
    let lengths: Option<Vec<Vec<f64>>> = match family {
        "grid" => None,
        _ => parameter("lengths").map(|lengths| lengths.extract()).transpose()?,
    };
    let shape = match parameter("shape") {
        Some(shape) if lengths.is_none() => arrays::ids(shape, "shape")?,
        _ if lengths.is_some() => Vec::new(),
        _ => {
            return Err(invalid(py, format!("{family} needs shape"), "give one number for each axis"));
        }
    };
    // Lengths say what the shape is.
    let unknown = |name: &str| !known.contains(&name) || (name == "shape" && lengths.is_some());
    if let Some((name, _)) = given.iter().find(|(name, _)| unknown(name)) {
        let cure = format!("its parameters are {}", known.join(", "));
        return Err(invalid(py, format!("{family} has no parameter {name}"), &cure));
    }
    if family == "grid" {
        return Ok(Box::new(move || {
            let grid = SimplicialGrid::new(&shape)?;
            let lists = grid.simplices()?.to_oriented();
            let cells = PlacedCells::new(grid.positions()?, CellKind::Simplex, shape.len(), lists)?;
            Ok(FamilyModel::Cells(cells))
        }));
    }
    Ok(Box::new(move || {
        let grid = match lengths {
            Some(lengths) => CuboidGrid::with_lengths(&lengths),
            None => CuboidGrid::new(&shape),
        }?;
        let Some(dimension) = grid.dimension() else {
            return Err(Error::invalid("the grid is empty: an axis has no full interval")
                .with_cure("give each axis an interval"));
        };
        let lists = grid.cells(dimension)?;
        let cells = PlacedCells::new(grid.positions()?, CellKind::Cuboid, dimension, lists)?;
        Ok(FamilyModel::Cells(cells))
    }))
}

fn model_of(made: FamilyModel) -> Result<io::Model, Error> {
    match made {
        FamilyModel::Cells(cells) => io::Model::from_placed_cells(cells),
        FamilyModel::Complex(complex) => {
            let facets = complex.facets();
            let lists = RaggedArray::from_lists(facets.iter().map(Simplex::numbers));
            Ok(io::Model::from_structure(Structure::Facets(lists)))
        }
    }
}

/// A model made by rule: a grid, a shape with positions, or a known space.
///
/// Shapes are oriented coherently where that is possible, closed surfaces with the normal outward, solids positively.
///
/// Parameters
/// ----------
/// family : str
///     The name of the family, or another name of it such as ``cube``; :func:`families` lists them. ``_`` and ``-`` are the same.
/// boundary : bool
///     The boundary of the model instead: the facets of exactly one cell.
/// skeleton : int, optional
///     The cells of this dimension instead, after ``boundary``.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
/// **parameters
///     Those of ``coface generate FAMILY``, with ``_`` for ``-``: ``major_radius=3.0``, ``columns=64``, ``shape=(2, 3)``, ``cuboids=True``, which
///     is also called ``quadrangles`` and ``hexahedra``.
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
    #[pyo3(from_py_with = whole_or_none)] skeleton: Option<usize>,
    progress: Option<&Bound<'_, PyAny>>,
    parameters: Option<&Bound<'_, PyDict>>,
) -> PyResult<Model> {
    let given = parameters.into_iter().flatten();
    let given: Given<'_> =
        given.map(|(name, value)| Ok((name.extract()?, value))).collect::<PyResult<_>>()?;
    let name = family.replace('_', "-");
    let rule = match Family::named(&name) {
        Some(family) => member(py, family, &given)?,
        None if GRIDS.contains(&&name[..]) => grid(py, &name, &given)?,
        None => {
            let cure = format!("choose one of {}", families().join(", "));
            return Err(invalid(py, format!("{family:?} is no family known here"), &cure));
        }
    };
    run(py, progress, || {
        let mut made = rule()?;
        if boundary {
            made = made.boundary()?.ok_or_else(|| {
                Error::invalid("the model has no boundary: every facet lies in two cells")
                    .with_cure("leave boundary out")
            })?;
        }
        if let Some(dimension) = skeleton {
            made = made.skeleton(dimension)?;
        }
        model_of(made)
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
    GRIDS.into_iter().chain(Family::all().map(Family::name)).collect()
}
