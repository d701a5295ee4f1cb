//! Still pictures: models, boundary matrices.

use crate::chain_complex::ChainComplex;
use crate::complex::simplex_set;
use crate::errors::invalid;
use crate::given::source_of;
use crate::json::from_python;
use crate::view::{Member, add_members};
use crate::work::run;
use coface::Error;
use coface::answers::{GeometryCheck, Neighborhood, Report, ReportRequest};
use coface::pictures::{
    Camera, FlatPicture, Picture, PictureStyle, Scene, matrix_picture, spin_gif, spin_png, spin_webp,
};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// Points in a pixel.
const POINTS: f64 = 0.75;

/// A still picture of a model, hidden lines removed, or an animation.
///
/// Parameters
/// ----------
/// model : Model, Complex or ChainComplex
///     What is shown.
/// format : {"svg", "png", "pdf", "gif", "webp"}
///     The format; PDF has vectors, a pixel is 0.75 points; GIF is an animation.
/// results : sequence of dict
///     Answers to be shown over it, as ``to_dict()`` gives them.
/// size : (int, int)
///     Width and height in pixels.
/// camera : (float, float, float), optional
///     The direction from which it is seen.
/// up : (float, float, float), optional
///     What is up.
/// perspective : float, optional
///     The angle of view in degrees; parallel if left out.
/// edges : bool, optional
///     Whether edges are drawn; if left out, where they can be distinguished.
/// dark : bool
///     Whether the background is dark.
/// transparent : bool
///     Whether what lies behind the picture shows through, in place of a background.
/// line_width, edge_width : float, optional
///     The widths of the lines of answers and of edges, in points; 2.25 and 0.45 if left out.
/// label : sequence of {"vertices", "edges", "faces"}
///     Cells whose numbers are written beside them.
/// star, closure, link : simplices, optional
///     Simplices; what they have around them is drawn over the pale complex.
/// legend : bool
///     Whether the names of what is drawn over the model stand above it.
/// spin : int, optional
///     So many frames, in which the model turns once about what is up: an animated GIF, PNG or WebP, 24 frames a second.
/// witness : bool
///     Whether what is wrong is marked.
/// title : str
///     What it is called.
/// members : sequence of (str, int, int, (int, int, int) or None)
///     Of several models that stand in one: the name of each, its first vertex, the one behind its last, its color as red, green and blue.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// bytes
///     The content of the file.
#[pyfunction]
#[pyo3(signature = (model, format="svg", *, results=Vec::new(), size=(1200, 900), camera=None, up=None, perspective=None, edges=None, dark=false, transparent=false, line_width=None, edge_width=None, label=Vec::new(), star=None, closure=None, link=None, legend=false, spin=None, witness=false, title="model", members=Vec::new(), progress=None))]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn render<'py>(
    py: Python<'py>,
    model: &Bound<'py, PyAny>,
    format: &str,
    results: Vec<Bound<'py, PyAny>>,
    size: (usize, usize),
    camera: Option<[f64; 3]>,
    up: Option<[f64; 3]>,
    perspective: Option<f64>,
    edges: Option<bool>,
    dark: bool,
    transparent: bool,
    line_width: Option<f64>,
    edge_width: Option<f64>,
    label: Vec<String>,
    star: Option<Bound<'py, PyAny>>,
    closure: Option<Bound<'py, PyAny>>,
    link: Option<Bound<'py, PyAny>>,
    legend: bool,
    spin: Option<u32>,
    witness: bool,
    title: &str,
    members: Vec<Member>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyBytes>> {
    match spin {
        Some(_) if !matches!(format, "gif" | "png" | "webp") => {
            let cure = "give format=\"gif\", format=\"png\" or format=\"webp\"";
            return Err(invalid(py, "an animation is a GIF, a PNG or a WebP", cure));
        }
        Some(_) => {}
        None => check_format(py, format)?,
    }
    let dimensions = label
        .iter()
        .map(|cells| match cells.as_str() {
            "vertices" => Ok(0),
            "edges" => Ok(1),
            "faces" => Ok(2),
            _ => Err(invalid(
                py,
                format!("no cells are called {cells:?}"),
                "give \"vertices\", \"edges\" or \"faces\"",
            )),
        })
        .collect::<PyResult<Vec<usize>>>()?;
    if perspective.is_some_and(|angle| !(1.0..=170.0).contains(&angle)) {
        return Err(invalid(py, "an angle of view is between 1 and 170 degrees", "give such an angle"));
    }
    let source = source_of(model)?;
    let asked = [(Neighborhood::Star, star), (Neighborhood::Closure, closure), (Neighborhood::Link, link)];
    let asked = asked
        .iter()
        .filter_map(|(neighborhood, simplices)| Some((*neighborhood, simplices.as_ref()?)))
        .map(|(neighborhood, simplices)| Ok((neighborhood, simplex_set(py, simplices)?)))
        .collect::<PyResult<Vec<_>>>()?;
    let results = results.iter().map(from_python).collect::<PyResult<Vec<_>>>()?;
    let bytes = run(py, progress, || {
        let mut scene = Scene::of(title, &source.model)?;
        add_members(&mut scene, &members);
        for result in &results {
            scene.add_result("the answer", result)?;
        }
        if witness {
            let request = ReportRequest::new().geometry(GeometryCheck::Never);
            scene = scene.with_report(&Report::answering(source.model.clone(), &request)?.answer(100));
        }
        if !asked.is_empty() {
            scene.add_neighborhoods(&source.model, &asked)?;
        }
        let mut style = PictureStyle::default();
        style.size = [size.0, size.1];
        style.has_legend = legend || !asked.is_empty();
        style.is_dark = dark;
        style.edges = edges;
        style.is_transparent = transparent;
        style.line_width = line_width.map_or(style.line_width, |points| points / POINTS);
        style.edge_width = edge_width.map_or(style.edge_width, |points| points / POINTS);
        if camera.is_some() || up.is_some() || perspective.is_some() {
            let mut eye = Camera::usual(&scene);
            eye.from = camera.unwrap_or(eye.from);
            eye.up = up.unwrap_or(eye.up);
            eye.field_of_view = perspective;
            style.camera = Some(eye);
        }
        for dimension in dimensions {
            scene.label_cells(dimension)?;
        }
        if let Some(frames) = spin {
            let write = match format {
                "gif" => spin_gif,
                "webp" => spin_webp,
                _ => spin_png,
            };
            return write(&scene, &style, frames, 1000 / 24);
        }
        let picture = Picture::new(&scene, &style)?;
        match format {
            "png" => picture.png(),
            "pdf" => Ok(picture.pdf()),
            _ => Ok(picture.svg().into_bytes()),
        }
    })?;
    Ok(PyBytes::new(py, &bytes))
}

fn check_format(py: Python<'_>, format: &str) -> PyResult<()> {
    if matches!(format, "svg" | "png" | "pdf") {
        return Ok(());
    }
    Err(invalid(py, format!("the format is {format:?}"), "give \"svg\", \"png\" or \"pdf\""))
}

/// A flat picture as a file: PNG of the size in pixels, others of the size that the picture has by itself.
pub(crate) fn flat_file<'py>(
    py: Python<'py>,
    format: &str,
    size: (usize, usize),
    transparent: bool,
    picture: impl FnOnce() -> Result<FlatPicture, Error> + Send,
) -> PyResult<Bound<'py, PyBytes>> {
    check_format(py, format)?;
    let bytes = run(py, None, || {
        let picture = picture()?;
        let picture = if transparent { picture.transparent() } else { picture };
        match format {
            "png" => picture.png([size.0, size.1]),
            "pdf" => picture.pdf(None),
            _ => Ok(picture.svg(None)?.into_bytes()),
        }
    })?;
    Ok(PyBytes::new(py, &bytes))
}

/// The boundary matrices of a complex as a file of this format.
#[pyfunction]
pub(crate) fn _matrix_picture<'py>(
    py: Python<'py>,
    complex: &Bound<'_, ChainComplex>,
    format: &str,
    size: (usize, usize),
    transparent: bool,
) -> PyResult<Bound<'py, PyBytes>> {
    let complex = complex.get();
    flat_file(py, format, size, transparent, || Ok(matrix_picture("boundary matrices", &complex.complex)))
}

/// The boundary matrices of a complex as a picture: blue entries are positive, orange ones negative.
///
/// Parameters
/// ----------
/// complex : ChainComplex
///     The complex.
/// title : str
///     What it is called.
///
/// Returns
/// -------
/// str
///     SVG.
#[pyfunction]
#[pyo3(signature = (complex, title="boundary matrices"))]
pub(crate) fn matrix_svg(py: Python<'_>, complex: &Bound<'_, ChainComplex>, title: &str) -> PyResult<String> {
    let complex = complex.get();
    run(py, None, || matrix_picture(title, &complex.complex).svg(None))
}
