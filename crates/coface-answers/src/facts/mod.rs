//! The report on a model: what `coface info` says, as data.
//!
//! * [`GeometryFacts`] are the faults of faces in space; [`GeometryCheck`] says which surfaces are looked at.
//! * [`DrawnPolygons`] are the faults of polygons with rings of a drawing in the plane.
//! * A [`Report`] is what [`Report::of`] finds out about a model. A [`Problem`] is one sort of fault in it, with all its
//!   places; a [`Witness`] shows why a model is no manifold; a [`Moment`] is an integral over it.
//! * The **top cells** are those of the highest degree: the faces of a surface, the cells of a volume. A **ridge** is a
//!   cell one degree below: an edge of a surface, a face of a volume.
//! * `examination` chooses by the kind of the model: `polygons`, `cells`, `simplicial`, `gluings`, `halfedges`, `volume`
//!   and `chains` each report on one kind.

mod cells;
mod certificate;
mod chains;
mod drawn;
mod examination;
mod geometry;
mod gluings;
mod halfedges;
mod moments;
mod polygons;
mod problem;
mod report;
mod simplicial;
mod volume;

pub use drawn::{DrawnFault, DrawnPlace, DrawnPolygons};
pub use examination::ReportRequest;
pub(crate) use geometry::sentence as geometry_sentence;
pub use geometry::{GeometryCheck, GeometryFacts, GeometryUnchecked};
pub use gluings::group_of_space;
pub(crate) use gluings::{orientations_open, space_of};
pub use moments::Moment;
pub(crate) use polygons::witness;
pub use problem::{Problem, ProblemKind};
pub use report::{Answer, BoundaryPart, DataSummary, GroupSummary, Kind, Report, Skin, Witness};
pub(crate) use volume::VolumeCells;
pub use volume::homology_of_volume;
