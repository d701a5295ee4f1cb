//! Certificates: proofs of answers about files, and their check by a program that shares no code with what computed them.

use crate::arrangement::{formula, rule_of};
use crate::chain_complex::ring;
use crate::congruence::checked_tolerance;
use crate::errors::{OrRaise, invalid, raised};
use crate::work::run;
use coface::Error;
use coface::algebra::ErrorKind;
use coface::answers::{
    ArrangementRequest, BooleanRequest, CocyclesRequest, CongruenceRequest, CutRequest, DrawingArrangement,
    GivenWalks, GivenZigzag, GreyImage, GroupsRequest, Growth, HomologyRequest, ImageRequest,
    ModelCongruence, PersistenceRequest, PlanarDrawing, PointFiltration, Producer, RegionBoolean,
    RegionSource, RelativeTo, Report, ReportRequest, RipsRequest, SceneArrangement, SolidBoolean,
    SolidRequest, SpatialRequest, SurfaceLoops, SurfaceModel, VertexFunction, are_planar, named_groups,
};
use coface::arrange::congruence::ClassRule;
use coface::io::{
    AlphaReading, CechReading, Format, Model, ReadOptions, RipsReading, read_path, volume_of_path,
};
use coface::topology::CoverExtent;
use pyo3::prelude::*;
use std::path::{Path, PathBuf};

/// Covers in certificates have at most so many cells.
const MOST_CELLS: usize = 100_000_000;

/// The report in a certificate lists so many places of a kind.
const PLACES: usize = 100;

/// The certificate of an answer about a file, as text.
#[pyfunction]
#[pyo3(signature = (path, of, coefficients, cohomology, reduced, relative, generators, progress=None))]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn _certificate(
    py: Python<'_>,
    path: PathBuf,
    of: &str,
    coefficients: &Bound<'_, PyAny>,
    cohomology: bool,
    reduced: bool,
    relative: Option<PathBuf>,
    generators: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<String> {
    let coefficients = ring(coefficients)?;
    let is_report = match of {
        "homology" => false,
        "info" => true,
        _ => {
            let message = format!("no answer is called {of:?}");
            return Err(invalid(
                py,
                message,
                "give of=\"homology\", \"info\", \"persistence\", \"arrange\", \"boolean\", \"congruence\", \"cut\", \"cover\", \"cocycles\", \"pi1\" or \"homotopic\"",
            ));
        }
    };
    run(py, progress, || {
        let name = path.display().to_string();
        let model = read_path(&path, None)?;
        let bytes = content(&path)?;
        if is_report {
            let report =
                Report::answering(model, &ReportRequest::new()).map_err(|error| error.in_file(&name))?;
            let format = Format::from_path(&path).map_or("", Format::name);
            return report.answer(PLACES).of_file(&name, format).certificate(&[(&name, &bytes)]);
        }
        let is_boundary = relative.as_deref() == Some(Path::new("boundary"));
        let part = match relative.as_deref().filter(|_| !is_boundary) {
            Some(part) => Some((part.display().to_string(), content(part)?, read_path(part, None)?)),
            None => None,
        };
        let mut inputs: Vec<(&str, &[u8])> = vec![(&name, &bytes)];
        let relative = match &part {
            Some((name, bytes, model)) => {
                inputs.push((name, bytes));
                Some(RelativeTo::Part { name: name.clone(), model: Box::new(model.clone()) })
            }
            None => is_boundary.then_some(RelativeTo::Boundary),
        };
        let request = HomologyRequest::new()
            .coefficients(coefficients)
            .cohomology(cohomology)
            .reduced(reduced)
            .relative(relative)
            .generators(generators)
            .certified(true);
        request.found(&name, model)?.certificate(&inputs)
    })
}

/// The certificate of a persistence diagram of a complex in a file, as text.
#[pyfunction]
#[pyo3(signature = (path, coefficients, function, upper_star, min_persistence, extended=false, relative=None, image_of=None, progress=None))]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn _persistence_certificate(
    py: Python<'_>,
    path: PathBuf,
    coefficients: &Bound<'_, PyAny>,
    function: Option<Function>,
    upper_star: bool,
    min_persistence: f64,
    extended: bool,
    relative: Option<PathBuf>,
    image_of: Option<PathBuf>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<String> {
    let coefficients = ring(coefficients)?;
    let function = match function {
        None => None,
        Some(Function::Values(values)) => {
            Some(VertexFunction::Values { place: "function".to_owned(), values })
        }
        Some(Function::Coordinate(name)) => match ["x", "y", "z"].iter().position(|axis| *axis == name) {
            Some(axis) => Some(VertexFunction::Coordinate(axis)),
            None => {
                let message = format!("no coordinate is called {name:?}");
                return Err(invalid(
                    py,
                    message,
                    "give function=\"x\", \"y\" or \"z\", or a number for each vertex",
                ));
            }
        },
    };
    let growth = if upper_star { Growth::Upper(function) } else { Growth::Lower(function) };
    run(py, progress, || {
        let name = path.display().to_string();
        let model = read_path(&path, None)?;
        let bytes = content(&path)?;
        let [relative, image_of] =
            [relative, image_of].map(|word| word.map(|word| named_part(&model, &word)));
        let (relative, image_of) = (relative.transpose()?, image_of.transpose()?);
        let mut inputs: Vec<(&str, &[u8])> = vec![(&name, &bytes)];
        for (part, bytes) in [&relative, &image_of].into_iter().flatten() {
            if let (RelativeTo::Part { name, .. }, Some(bytes)) = (part, bytes) {
                inputs.push((name, bytes));
            }
        }
        let request = PersistenceRequest::new()
            .coefficients(coefficients)
            .growth(growth)
            .min_persistence(min_persistence)
            .relative(relative.as_ref().map(|part| part.0.clone()))
            .image_of(image_of.as_ref().map(|part| part.0.clone()));
        let producer = Producer::of(model.clone())?;
        match extended {
            true => request.extended_certificate(&name, &producer, &inputs),
            false => request.found_in(&name, &producer, Some(&model))?.certificate(&inputs),
        }
    })
}

/// The part of a model that a word names: its boundary, a group of it, or the cells of a file, with the bytes of the file.
fn named_part(model: &Model, word: &Path) -> Result<(RelativeTo, Option<Vec<u8>>), Error> {
    let name = word.display().to_string();
    if name == "boundary" {
        return Ok((RelativeTo::Boundary, None));
    }
    let words = vec![name.clone()];
    if named_groups(model, &words).is_ok() {
        return Ok((RelativeTo::Groups(words), None));
    }
    let part = read_path(word, None)?;
    Ok((RelativeTo::Part { name, model: Box::new(part) }, Some(content(word)?)))
}

/// The certificate of the persistence of a zigzag in a file, as text.
#[pyfunction]
#[pyo3(signature = (path, coefficients, min_persistence, progress=None))]
pub(crate) fn _zigzag_certificate(
    py: Python<'_>,
    path: PathBuf,
    coefficients: &Bound<'_, PyAny>,
    min_persistence: f64,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<String> {
    let coefficients = ring(coefficients)?;
    run(py, progress, || {
        let name = path.display().to_string();
        let bytes = content(&path)?;
        let zigzag = GivenZigzag::read(&name, &bytes)?;
        let request = PersistenceRequest::new().coefficients(coefficients).min_persistence(min_persistence);
        request.zigzag_certificate(&zigzag, &[(&name, &bytes)])
    })
}

/// The certificate of the persistence diagram of points in a file, as text.
#[pyfunction]
#[pyo3(signature = (path, kind, coefficients, dimension, threshold, superlevel, min_persistence, progress=None))]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn _points_certificate(
    py: Python<'_>,
    path: PathBuf,
    kind: &str,
    coefficients: &Bound<'_, PyAny>,
    dimension: usize,
    threshold: Option<f64>,
    superlevel: bool,
    min_persistence: f64,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<String> {
    let coefficients = ring(coefficients)?;
    if !["rips", "alpha", "cech", "image"].contains(&kind) {
        let message = format!("no complex of points is called {kind:?}");
        return Err(invalid(py, message, "give points=\"rips\", \"alpha\", \"cech\" or \"image\""));
    }
    run(py, progress, || {
        let (name, options) = (path.display().to_string(), ReadOptions::new());
        let bytes = content(&path)?;
        let inputs: [(&str, &[u8]); 1] = [(&name, &bytes)];
        if kind == "image" {
            let Some((stream, _)) = volume_of_path(&path, &options)? else {
                return Err(Error::invalid("this is no volume").in_file(&name));
            };
            let (image, _) = GreyImage::read(stream).map_err(|error| error.in_file(&name))?;
            let request = ImageRequest::new().coefficients(coefficients).min_persistence(min_persistence);
            return request.superlevel(superlevel).found(&name, image)?.certificate(&inputs);
        }
        if kind == "rips" {
            let reading = RipsReading { threshold, dimension: Some(dimension), ..RipsReading::default() };
            let points = reading.distances_of_path(&path, &options)?;
            let request = RipsRequest::new().coefficients(coefficients).dimension(dimension);
            let request = request.threshold(threshold).min_persistence(min_persistence);
            return request.found(&name, points.distances())?.certificate(&inputs);
        }
        let request = PersistenceRequest::new().coefficients(coefficients).min_persistence(min_persistence);
        let (points, request) = if kind == "alpha" {
            let reading = AlphaReading { bound: threshold, ..AlphaReading::default() };
            (PointFiltration::of_alpha(reading.points_of_path(&path, &options)?, false), request)
        } else {
            let reading = CechReading { radius: threshold, dimension: Some(dimension + 1) };
            let points = PointFiltration::of_cech(reading.points_of_path(&path, &options)?);
            (points, request.up_to_degree(dimension))
        };
        request.growth(points.growth()).found(&name, points.producer())?.certificate_of_points(&inputs)
    })
}

/// The certificate of a surface cut open, of a cover, of cocycles or of the fundamental groups of a file, as text.
#[pyfunction]
#[pyo3(signature = (path, of, simplify, along, radius, copies, orientation, component, progress=None))]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn _surface_certificate(
    py: Python<'_>,
    path: PathBuf,
    of: &str,
    simplify: bool,
    along: Option<Vec<u32>>,
    radius: Option<usize>,
    copies: Option<usize>,
    orientation: bool,
    component: usize,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<String> {
    let extent = match (radius, copies) {
        (Some(radius), None) => CoverExtent::Radius(radius),
        (None, Some(copies)) => CoverExtent::Copies(copies),
        _ if of != "cover" || orientation => CoverExtent::Copies(1),
        _ => {
            let message = "a cover has a radius or a number of copies, one of the two";
            return Err(invalid(py, message, "give radius=2, copies=20 or orientation=True"));
        }
    };
    run(py, progress, || {
        let name = path.display().to_string();
        let model = read_path(&path, None)?;
        let bytes = content(&path)?;
        let inputs: [(&str, &[u8]); 1] = [(&name, &bytes)];
        if of == "pi1" {
            let producer = Producer::of(model)?;
            let request = GroupsRequest::new().simplified(simplify);
            return request.certificate(&request.found(&producer)?, &producer, &inputs);
        }
        if of == "cocycles" {
            return CocyclesRequest::new().found(&Producer::of(model)?)?.certificate(&inputs);
        }
        let surface = SurfaceModel::of(model).map_err(|error| error.in_file(&name))?;
        match (of, along) {
            ("cover", _) if orientation => surface.double_cover(&name)?.0.certificate(&inputs),
            ("cover", _) => surface.cover(component, extent, MOST_CELLS)?.certificate(&inputs),
            (_, Some(path)) => surface.cut_along(&path)?.certificate(&inputs),
            _ => surface.cut_open(&CutRequest { simplify, ..CutRequest::default() })?.certificate(&inputs),
        }
    })
}

/// The certificate of closed walks on a surface in a file that are compared, as text.
#[pyfunction]
#[pyo3(signature = (path, walks, base, progress=None))]
pub(crate) fn _walks_certificate(
    py: Python<'_>,
    path: PathBuf,
    walks: Vec<Vec<u32>>,
    base: Option<u32>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<String> {
    run(py, progress, || {
        let name = path.display().to_string();
        let producer = Producer::of(read_path(&path, None)?)?;
        let bytes = content(&path)?;
        let request = GroupsRequest::new()
            .base(base)
            .surface_loops(SurfaceLoops::Canonical)
            .walks(Some(GivenWalks { place: "walks".to_owned(), walks }));
        let found = request.found(&producer).map_err(|error| error.in_file(&name))?;
        request.certificate(&found, &producer, &[(&name, &bytes)])
    })
}

/// A function on vertices.
#[derive(FromPyObject)]
pub(crate) enum Function {
    Coordinate(String),
    Values(Vec<f64>),
}

/// Files with what they hold.
struct Files {
    names: Vec<String>,
    models: Vec<Model>,
    bytes: Vec<Vec<u8>>,
}

impl Files {
    fn read(paths: &[PathBuf]) -> Result<Self, Error> {
        Ok(Self {
            names: paths.iter().map(|path| path.display().to_string()).collect(),
            models: paths.iter().map(|path| read_path(path, None)).collect::<Result<_, Error>>()?,
            bytes: paths.iter().map(|path| content(path)).collect::<Result<_, Error>>()?,
        })
    }

    fn named_models(&self) -> impl Iterator<Item = (&str, &Model)> {
        self.names.iter().map(String::as_str).zip(&self.models)
    }

    /// What a certificate is of.
    fn inputs(&self) -> Vec<(&str, &[u8])> {
        self.names.iter().map(String::as_str).zip(self.bytes.iter().map(Vec::as_slice)).collect()
    }
}

/// The certificate of an arrangement of drawings in files, or with an operation of a Boolean of drawings or solids, as text.
#[pyfunction]
#[pyo3(signature = (paths, operation, rule, exact, progress=None))]
pub(crate) fn _drawing_certificate(
    py: Python<'_>,
    paths: Vec<PathBuf>,
    operation: Option<&str>,
    rule: Option<&str>,
    exact: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<String> {
    let rule = rule_of(py, rule)?;
    run(py, progress, || {
        let files = Files::read(&paths)?;
        let inputs = files.inputs();
        if !are_planar(&files.models) {
            let arrangement = SceneArrangement::of(files.named_models(), &SpatialRequest::default())?;
            let Some(operation) = operation else {
                return arrangement.certificate(rule.unwrap_or_default(), &inputs);
            };
            let mut request = SolidRequest::of(formula(operation, paths.len())?);
            request.rule = rule.unwrap_or_default();
            return SolidBoolean::of(&arrangement, &request)?.certificate(&inputs);
        }
        let drawing = PlanarDrawing::new(files.named_models(), RegionSource::Models)?;
        let Some(operation) = operation else {
            let mut request = ArrangementRequest::default();
            (request.rule, request.exact) = (rule, exact);
            return DrawingArrangement::new(drawing, &request)?.certificate(&inputs);
        };
        let mut request = BooleanRequest::default();
        (request.rule, request.exact) = (rule, exact);
        let formula = formula(operation, paths.len())?;
        RegionBoolean::new(drawing, &formula, &request)?.certificate(&inputs)
    })
}

/// The certificate of a congruence of models in files, as text.
#[pyfunction]
#[pyo3(signature = (paths, tolerance, greedy, progress=None))]
pub(crate) fn _congruence_certificate(
    py: Python<'_>,
    paths: Vec<PathBuf>,
    tolerance: f64,
    greedy: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<String> {
    let mut request = CongruenceRequest::within(checked_tolerance(py, tolerance)?);
    request.rule = if greedy { ClassRule::Greedy } else { ClassRule::Transitive };
    run(py, progress, || {
        let mut files = Files::read(&paths)?;
        let models = std::mem::take(&mut files.models);
        let congruence = ModelCongruence::of(files.names.iter().cloned().zip(models).collect(), &request)?;
        congruence.certificate(&files.inputs())
    })
}

/// What a certificate proves of these files, or of those that it names: their names, the claims that are proved, and the keys of the answer
/// that were not checked.
#[pyfunction]
#[pyo3(signature = (certificate, inputs, progress=None))]
pub(crate) fn _check(
    py: Python<'_>,
    certificate: Vec<u8>,
    inputs: Vec<PathBuf>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<(Vec<String>, Vec<String>, Vec<String>)> {
    let refused = |fault: coface_check::Fault| Error::invalid(format!("not verified: {fault}"));
    let named = || coface_check_binary::input_names(&certificate).map_err(refused).or_raise(py);
    let inputs: Vec<PathBuf> = match inputs.is_empty() {
        true => named()?.into_iter().map(PathBuf::from).collect(),
        false => inputs,
    };
    if inputs.is_empty() {
        let error = Error::invalid("the certificate names no input");
        return Err(raised(py, &error.with_cure("give its file: coface.check(certificate, path)")));
    }
    run(py, progress, || {
        let read = inputs.iter().map(|input| content(input)).collect::<Result<Vec<_>, Error>>()?;
        let read: Vec<&[u8]> = read.iter().map(Vec::as_slice).collect();
        let verdict = coface_check_binary::check(&certificate, &read).map_err(refused)?;
        let names = inputs.iter().map(|input| input.display().to_string()).collect();
        Ok((names, verdict.proved().to_vec(), verdict.unchecked().to_vec()))
    })
}

/// The bytes of a file. A certificate of a stranger may name a device, which never ends.
fn content(path: &Path) -> Result<Vec<u8>, Error> {
    let failed = |message: String| Error::new(ErrorKind::Io, message).in_file(path.display().to_string());
    if !path.is_file() {
        return Err(failed("there is no such regular file".to_owned()).with_cure("check the path"));
    }
    std::fs::read(path).map_err(|error| failed(format!("cannot be read: {error}")))
}
