//! Reports: everything that `coface info` says.

use crate::arrays;
use crate::cures::in_python;
use crate::errors::{invalid, whole};
use crate::model::Model;
use crate::objects::{text_of, to_python};
use crate::source::Source;
use crate::work::run;
use coface::answers as report;
use coface::answers::text;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use std::sync::Arc;

/// How many places of a problem are listed.
const PLACES: usize = 100;

/// What a report is asked for.
pub(crate) fn report_request(
    py: Python<'_>,
    moments: &[[u32; 3]],
    check: &str,
    flatness: Option<f64>,
) -> PyResult<report::ReportRequest> {
    let check = match check {
        "usual" => report::GeometryCheck::Usual,
        "geometry" => report::GeometryCheck::Always,
        "topology" => report::GeometryCheck::Never,
        other => {
            return Err(invalid(
                py,
                format!("check={other:?} is not known"),
                "say usual, geometry or topology",
            ));
        }
    };
    if flatness.is_some_and(|flatness| !flatness.is_finite() || flatness < 0.0) {
        return Err(invalid(py, "flatness is negative or not finite", "give a length from 0"));
    }
    Ok(report::ReportRequest::new().moments(moments.to_vec()).geometry(check).flatness(flatness))
}

/// Everything that ``coface info`` says about a model.
///
/// Made by :meth:`Model.report`. A notion that does not apply is ``None``.
///
/// Examples
/// --------
/// >>> import coface
/// >>> report = coface.Model.from_facets([[0, 1], [1, 2], [0, 2], [2, 3]]).report()
/// >>> report.manifold, report.witness["cells"]
/// ('no', [[2]])
/// >>> report.homology
/// Homology(Z, Z)
#[pyclass(frozen, module = "coface", name = "Report")]
pub(crate) struct Report {
    report: report::Report,
    source: Arc<Source>,
    asked: Asked,
}

/// What a report was asked for: moments, the check of geometry, flatness.
pub(crate) type Asked = (Vec<[u32; 3]>, String, Option<f64>);

impl Report {
    pub(crate) fn of(report: report::Report, source: Arc<Source>, asked: Asked) -> Self {
        Self { report, source, asked }
    }

    fn format(&self) -> &'static str {
        self.source.model.format().map_or("made in Python", coface::io::Format::title)
    }
}

#[pymethods]
impl Report {
    /// ``complex``, ``surface``, ``volume`` or ``planar``.
    #[getter]
    fn kind(&self) -> &'static str {
        self.report.kind().word()
    }

    /// The highest dimension of a cell.
    #[getter]
    fn dimension(&self) -> Option<usize> {
        self.report.dimension()
    }

    /// The numbers of cells of the dimensions 0, 1, ...
    #[getter]
    fn f_vector<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.report.f_vector())
    }

    /// Whether every cell lies in one of the highest dimension.
    #[getter]
    fn pure(&self) -> Option<bool> {
        self.report.is_pure()
    }

    /// The number of connected components.
    #[getter]
    fn components(&self) -> usize {
        self.report.components()
    }

    /// The alternating sum of the numbers of cells.
    #[getter]
    fn euler_characteristic(&self) -> i64 {
        self.report.euler_characteristic()
    }

    /// Whether it is a manifold: ``yes``, ``no`` or ``unknown``.
    #[getter]
    fn manifold(&self) -> &'static str {
        self.report.manifold().word()
    }

    /// Whether it is a manifold without boundary.
    #[getter]
    fn closed(&self) -> Option<bool> {
        self.report.is_closed()
    }

    /// Why it is no manifold: a dictionary with ``kind``, ``cells`` (lists of vertices) and ``message``.
    #[getter]
    fn witness<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(witness) = self.report.witness() else { return Ok(None) };
        let dict = PyDict::new(py);
        dict.set_item("kind", witness.kind())?;
        dict.set_item("cells", witness.cells())?;
        dict.set_item("message", witness.message())?;
        Ok(Some(dict))
    }

    /// The boundary loops of a surface, each an array of its vertices in order.
    #[getter]
    fn boundary_loops<'py>(&self, py: Python<'py>) -> Option<Vec<Bound<'py, PyAny>>> {
        let loops = self.report.boundary_loops()?;
        Some(
            loops
                .iter()
                .map(|part| arrays::id_array(py, part.vertices().iter().copied()).into_any())
                .collect(),
        )
    }

    /// The boundary surface of a volume: a dictionary with ``faces``, ``components``, ``euler_characteristic``, ``manifold``, ``name``.
    #[getter]
    fn boundary_surface<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.report.answer(PLACES).boundary_surface)
    }

    /// Whether it can be oriented.
    #[getter]
    fn orientable(&self) -> Option<bool> {
        self.report.is_orientable()
    }

    /// Whether its cells are oriented coherently as they stand.
    #[getter]
    fn coherently_oriented(&self) -> Option<bool> {
        self.report.is_coherently_oriented()
    }

    /// The genus of a connected surface; of one that cannot be oriented the number of cross-caps.
    #[getter]
    fn genus(&self) -> Option<usize> {
        self.report.surface_type().map(|surface| surface.genus())
    }

    /// What a connected surface is called, such as ``torus``.
    #[getter]
    fn name(&self) -> Option<&str> {
        self.report.name()
    }

    /// The components of a surface: dictionaries with ``f_vector``, ``euler_characteristic``, ``boundary_loops``, ``orientable``, ``genus``, ``name``.
    #[getter]
    fn surfaces<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.report.answer(PLACES).surfaces)
    }

    /// The integral homology.
    #[getter]
    fn homology(&self) -> crate::homology::Homology {
        crate::homology::Homology::of_groups(self.report.homology(), false)
    }

    /// The area, in the unit of the file squared.
    #[getter]
    fn area(&self) -> Option<f64> {
        self.report.area()
    }

    /// The volume, positive where normals point outward.
    #[getter]
    fn signed_volume(&self) -> Option<f64> {
        self.report.signed_volume()
    }

    /// The center of the surface.
    #[getter]
    fn surface_centroid(&self) -> Option<[f64; 3]> {
        self.report.surface_centroid()
    }

    /// What it encloses, at density 1: ``volume``, ``centroid`` and ``inertia`` about the centroid.
    #[getter]
    fn mass<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.report.answer(PLACES).mass)
    }

    /// The moments that were asked for: dictionaries with ``exponents``, ``volume`` and ``surface``.
    #[getter]
    fn moments<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.report.answer(PLACES).moments)
    }

    /// Whether faces in space are sound: a dictionary with ``checked``, ``reason``, ``sound_surface``, ``valid_solid``, and
    /// ``faults``, each with ``code`` (of ISO 19107), ``name``, ``of``, ``count``, ``message`` and ``places``.
    #[getter]
    fn geometry<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.report.answer(PLACES).geometry)
    }

    /// Whether the polygons with rings of a drawing are valid, as OGC's Simple feature access says: a dictionary with ``count``, ``valid``,
    /// ``reason`` (as ``shapely.is_valid_reason``), ``faults``, each with ``name``, ``reason``, ``count``, ``message`` and
    /// ``places``, and ``reversed_rings``; ``None`` for what has no such polygons.
    #[getter]
    fn polygons<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.report.answer(PLACES).polygons)
    }

    /// What is wrong and where: dictionaries with ``kind``, ``count``, ``message``, ``cells`` and ``top_cells`` (lists of vertices), and ``points`` where
    /// cells are not the places: with the cells, with the faces in space, with the polygons of a drawing.
    #[getter]
    fn problems<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.report.answer(usize::MAX).problems)
    }

    /// What was odd about the file.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.report.warnings().iter().map(|warning| in_python(warning)).collect()
    }

    /// The report as ``coface info --json`` prints it, but for ``file``.
    ///
    /// Parameters
    /// ----------
    /// limit : int
    ///     How many places of each problem are listed.
    ///
    /// Returns
    /// -------
    /// dict
    ///     ``kind``, ``dimension``, ``f_vector``, ..., with ``format`` if the model came from a file.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> coface.Model.from_facets([[0, 1]]).report().to_dict()["homology"][0]
    /// {'betti': 1, 'degree': 0, 'torsion': []}
    #[pyo3(signature = (limit=PLACES))]
    fn to_dict<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] limit: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let dict = to_python(py, &self.report.answer(limit))?;
        if let Some(format) = self.source.model.format() {
            dict.set_item("format", format.name())?;
        }
        Ok(dict)
    }

    /// The report for people, at 80 columns.
    ///
    /// Parameters
    /// ----------
    /// title : str
    ///     What it is about.
    /// limit : int
    ///     How many places of each problem are listed.
    ///
    /// Returns
    /// -------
    /// str
    ///     The text that ``coface info`` prints.
    #[pyo3(signature = (title="model", limit=text::FEW))]
    fn to_text(&self, title: &str, #[pyo3(from_py_with = whole)] limit: usize) -> String {
        let styled = text::report(title, self.format(), &self.report, limit);
        let text = anstream::adapter::strip_str(&styled).to_string();
        // Lines keep their ends.
        text.split('\n').map(in_python).collect::<Vec<_>>().join("\n")
    }

    /// The report as a page for browsers: tables of facts, and pictures given as SVG.
    ///
    /// Parameters
    /// ----------
    /// title : str
    ///     What it is about.
    /// figures : sequence of (str, str)
    ///     Pictures as SVG, each with its caption.
    ///
    /// Returns
    /// -------
    /// str
    ///     One page that needs no network.
    #[pyo3(signature = (title="model", figures=Vec::new()))]
    fn to_html(&self, title: &str, figures: Vec<(String, String)>) -> String {
        let items = text::items(title, self.format(), &self.report, text::FEW);
        let figures = figures
            .into_iter()
            .map(|(svg, caption)| (coface::pictures::pages::html::Figure::Svg(svg), caption))
            .collect();
        let object = report::answer::to_pretty_json(&self.report.answer(PLACES));
        coface::pictures::pages::html::page(
            title,
            &[coface::pictures::pages::html::Section { items, figures, object }],
        )
    }

    /// The model that was asked about.
    #[getter]
    fn model(&self) -> Model {
        Model { source: Arc::clone(&self.source) }
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            let other = other.get();
            self.source.model.format() == other.source.model.format()
                && text_of(&self.report.answer(PLACES)) == text_of(&other.report.answer(PLACES))
        })
    }

    fn __hash__(&self) -> isize {
        self.report
            .f_vector()
            .iter()
            .fold(37, |sum, &count| sum.wrapping_mul(1_000_003).wrapping_add(count as isize))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Model, Asked))> {
        Ok((py.import("coface._coface")?.getattr("_report")?, (self.model(), self.asked.clone())))
    }

    fn __str__(&self) -> String {
        self.to_text("model", text::FEW)
    }

    fn __repr__(&self) -> String {
        let name = self.report.name().map_or_else(|| self.report.kind().word().to_owned(), str::to_owned);
        format!(
            "Report({name}, f-vector {:?}, Euler characteristic {})",
            self.report.f_vector(),
            self.report.euler_characteristic()
        )
    }
}

/// Makes a report again, for pickling.
#[pyfunction]
pub(crate) fn _report(py: Python<'_>, model: &Bound<'_, Model>, asked: Asked) -> PyResult<Report> {
    let source = Arc::clone(&model.get().source);
    let request = report_request(py, &asked.0, &asked.1, asked.2)?;
    let report = run(py, None, || report::Report::answering(source.model.clone(), &request))?;
    Ok(Report::of(report, source, asked))
}
