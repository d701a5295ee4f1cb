//! From a model to its report.

use super::facts::{Kind, Report};
use super::producer::{Cells, Producer};
use super::{cells, chains, halfedges, polygons, simplicial};
use crate::Error;
use crate::io::{Model, Structure};

impl Report {
    /// Examines a model. The model is taken along, so that its arrays become those of the structures made from it.
    ///
    /// # Errors
    /// Those of [`Producer::of`].
    ///
    /// # Complexity
    /// That of integral homology, near-linear on meshes; everything else is near-linear.
    ///
    /// # Examples
    /// ```
    /// use coface::algebra::RaggedArray;
    /// use coface::io::{Model, Structure};
    /// use coface::report::Report;
    /// # fn main() -> Result<(), coface::Error> {
    /// // The Moebius band of five triangles.
    /// let band = RaggedArray::from_lists([[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]]);
    /// let report = Report::of(Model::from_structure(Structure::Facets(band)))?;
    /// assert_eq!(report.name(), Some("Moebius band"));
    /// assert_eq!(report.is_orientable(), Some(false));
    /// assert_eq!(report.homology()[1].to_string(), "Z");
    /// # Ok(()) }
    /// ```
    pub fn of(mut model: Model) -> Result<Self, Error> {
        let kind = kind_of(&model);
        let mut warnings = std::mem::take(&mut model.warnings);
        let Producer { cells, labels, positions } = Producer::of(model)?;
        let mut report = match cells {
            Cells::Polygons(mesh) => polygons::report(mesh, positions, &labels, kind),
            Cells::Solids(mesh) => cells::report(*mesh, &positions),
            Cells::Simplices(complex) => simplicial::report(&complex)?,
            Cells::Halfedges(mesh) => halfedges::report(&mesh),
            Cells::Chains(complex) => chains::report(&complex),
        };
        if kind == Kind::Complex {
            // The vertices of a facet have an order, but it orients nothing.
            report.coherently_oriented = None;
            report.problems.retain(|problem| problem.kind() != super::ProblemKind::OrientationConflict);
        }
        warnings.extend(report.problems.iter().map(|problem| problem.message().to_owned()));
        report.warnings = warnings;
        Ok(report)
    }
}

/// What sort of thing a model is.
fn kind_of(model: &Model) -> Kind {
    match &model.structure {
        Some(Structure::Halfedges { .. }) => Kind::Surface,
        Some(_) => Kind::Complex,
        None if !model.cells.is_empty() => Kind::Volume,
        None if !model.polygons.is_empty() => Kind::Surface,
        None if !model.lines.is_empty() && is_planar(model) => Kind::Planar,
        None => Kind::Complex,
    }
}

/// Whether all positions have two coordinates, or a third that is zero.
fn is_planar(model: &Model) -> bool {
    match model.positions.dimension() {
        2 => true,
        3 => model.positions.as_flat().iter().skip(2).step_by(3).all(|&z| z == 0.0),
        _ => false,
    }
}
