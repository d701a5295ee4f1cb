//! Interfaces: sets as phases that share the arcs between them.

use super::YinSet;
use crate::answer::answer;
use crate::congruence::choice;
use crate::errors::invalid;
use crate::model::Model;
use crate::pictures::flat_file;
use crate::work::run;
use coface::Error;
use coface::answers::answer::YinInterfaceAnswer;
use coface::answers::{LabelImage, NamedSet, PlanarInterface, SetRequest};
use coface::io;
use coface::pictures::interface_picture;
use coface::yin::{InterfaceOptions, Overlaps};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// Sets of the plane as phases that share the arcs between them: edges, junctions, areas, lengths and neighbors.
///
/// Made by :func:`interface`.
#[pyclass(frozen, dict, module = "coface", name = "Interface")]
pub(crate) struct Interface {
    interface: PlanarInterface,
    answer: YinInterfaceAnswer,
}

answer! { Interface {
    /// The order of the edges.
    order,
    /// For each phase ``name``, ``area``, ``perimeter``, ``components``, ``holes`` and ``neighbors``.
    phases,
    /// The positions of the vertices, a list of [x, y].
    vertices,
    /// For each edge ``ends``, the phases on its ``left`` and ``right`` (``None`` outside), ``length``, ``pieces``, ``knots`` and ``controls``.
    edges,
    /// For each junction ``vertex``, ``point``, ``degree``, ``smooth_pairs``, ``kind``, and ``edges`` and ``phases`` counterclockwise.
    junctions,
    /// The length of all edges, each once; ``None`` where it overflows.
    length,
    /// What was assumed or left out.
    remarks,
}
    fn _picture<'py>(
        &self,
        py: Python<'py>,
        title: &str,
        format: &str,
        size: (usize, usize),
        transparent: bool,
    ) -> PyResult<Bound<'py, PyBytes>> {
        flat_file(py, format, size, transparent, || interface_picture(title, &self.answer))
    }

    /// The names of the phases.
    #[getter]
    fn names(&self) -> Vec<String> {
        self.answer.phases.iter().map(|phase| phase.name.clone()).collect()
    }

    /// The areas of the phases; ``inf`` for one that is not bounded.
    #[getter]
    fn areas(&self) -> Vec<f64> {
        self.answer.phases.iter().map(|phase| phase.area.unwrap_or(f64::INFINITY)).collect()
    }

    /// The lengths of the edges.
    #[getter]
    fn lengths(&self) -> Vec<f64> {
        self.answer.edges.iter().map(|edge| edge.length.unwrap_or(f64::INFINITY)).collect()
    }

    /// Pairs of phases that have an edge in common, the lower number first, with the length of their common edges.
    ///
    /// Returns
    /// -------
    /// list of (int, int, float)
    ///     What lies outside of all phases is no phase.
    #[getter]
    fn neighbors(&self) -> Vec<(u32, u32, f64)> {
        let of_phase = |(phase, own): (u32, &coface::answers::answer::YinPhaseAnswer)| {
            let others = own.neighbors.iter().filter_map(move |neighbor| {
                let other = neighbor.phase.filter(|&other| other > phase)?;
                Some((phase, other, neighbor.length.unwrap_or(f64::INFINITY)))
            });
            others.collect::<Vec<_>>()
        };
        (0..).zip(&self.answer.phases).flat_map(of_phase).collect()
    }

    /// The phases as sets, in their order; neighbors have the same pieces along their common edges.
    ///
    /// Returns
    /// -------
    /// list of YinSet
    ///     They give the same interface again.
    fn sets(&self, py: Python<'_>) -> PyResult<Vec<YinSet>> {
        run(py, None, || self.interface.phases()?.into_iter().map(YinSet::of).collect::<Result<Vec<_>, Error>>())
    }

    fn __len__(&self) -> usize {
        self.answer.phases.len()
    }

    fn __repr__(&self) -> String {
        format!(
            "Interface({} phases, {} edges, {} junctions)",
            self.answer.phases.len(),
            self.answer.edges.len(),
            self.answer.junctions.len()
        )
    }
}

/// The interface of named sets.
#[pyfunction]
#[pyo3(signature = (names, sets, overlaps, smooth, progress=None))]
pub(crate) fn _interface(
    py: Python<'_>,
    names: Vec<String>,
    sets: Vec<PyRef<'_, YinSet>>,
    overlaps: &str,
    smooth: f64,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Interface> {
    let overlaps = choice(
        py,
        "overlaps",
        overlaps,
        &[("refuse", Overlaps::Refused), ("first", Overlaps::ToTheFirst), ("last", Overlaps::ToTheLast)],
    )?;
    if !(smooth.is_finite() && smooth < 180.0) {
        let cure = "give an angle below 180 degrees; a negative one lets no edges go on smoothly";
        return Err(invalid(py, format!("smooth is {smooth}"), cure));
    }
    let named = names.into_iter().zip(&sets).map(|(name, set)| NamedSet::new(name, set.set.as_ref().clone()));
    let named: Vec<NamedSet> = named.collect();
    drop(sets);
    run(py, progress, || {
        let options =
            InterfaceOptions::new(PlanarInterface::order_for(&named)).smooth_angle(smooth.to_radians());
        let interface = PlanarInterface::of(named, &options, overlaps)?;
        let answer = interface.answer(&[], true)?;
        Ok(Interface { interface, answer })
    })
}

fn as_pairs(sets: Vec<NamedSet>) -> Result<Vec<(String, YinSet)>, Error> {
    sets.into_iter().map(|one| Ok((one.name, YinSet::of(one.set)?))).collect()
}

/// A set for each label but 0 of an image, the highest row first.
#[pyfunction]
pub(crate) fn _label_sets(py: Python<'_>, width: usize, labels: Vec<u32>) -> PyResult<Vec<(String, YinSet)>> {
    run(py, None, || as_pairs(LabelImage::new(width, labels)?.sets()?))
}

/// A set for each feature of a drawing; none for curves that bound one set.
#[pyfunction]
#[pyo3(signature = (model, order=None))]
pub(crate) fn _feature_sets(
    py: Python<'_>,
    model: &Bound<'_, Model>,
    order: Option<usize>,
) -> PyResult<Option<Vec<(String, YinSet)>>> {
    let mut request = SetRequest::default();
    request.order = order.map(|order| super::order_of(py, order)).transpose()?;
    let model = &model.get().source.model;
    run(py, None, || {
        let drawing = io::yin::drawing_of_model(model)?;
        NamedSet::of_features("feature", &drawing, &request)?.map(as_pairs).transpose()
    })
}
