//! Simplicial complexes that grow: each simplex enters at a value, no sooner than its faces.
//!
//! # Words and conventions
//! * A [`FilteredComplex`] is a simplicial complex with the values of its simplices.
//! * The **flag complex** of a [`WeightedGraph`] has a simplex for each set of vertices of which each two are joined; it enters with the last of its edges.
//!   That of a graph of points within a distance of each other is a **Vietoris-Rips complex**, whose values are diameters.
//! * The **directed flag complex** of a [`WeightedDigraph`] has a simplex for each list of vertices with an edge from each to each later one: a
//!   [`DirectedFlagComplex`], whose simplices may have the same vertices.
//! * The **Čech complex** of points is the nerve of balls around them: [`FilteredComplex::cech`], whose values are radii.
//! * The **witness complex** of landmarks has the sets of landmarks that points are witnesses of: [`FilteredComplex::witness`].
//! * The **Mapper complex** of a function has the clusters of points over overlapping intervals of its range: [`MapperComplex`].
//! * [`Distances`] are those of points, or of pairs of points that are known.

mod cech;
mod complex;
mod directed;
mod distances;
mod flag;
mod graph;
mod mapper;
mod witness;

pub use cech::enclosing_ball_radius;
pub use complex::FilteredComplex;
pub use directed::DirectedFlagComplex;
pub use distances::Distances;
pub use graph::{WeightedDigraph, WeightedGraph};
pub use mapper::{IntervalCover, MapperComplex};
pub use witness::{WitnessRule, farthest_points};
