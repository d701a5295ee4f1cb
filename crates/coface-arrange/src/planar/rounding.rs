//! What rounding the coordinates does to an arrangement, and arrangements that are drawn with rounded ones.

use super::faces::NONE;
use super::snap_rounding::HotPixels;
use super::{PlanarArrangement, StackedSegments, VertexSource};
use crate::near::JoinedFeatures;
use coface_algebra::RaggedArray;
use coface_algebra::{EdgeId, Error, VertexId};
use coface_geometry::Positions;
use std::collections::BTreeMap;

/// After so many rounds the rest is rounded to a grid, which ends at once.
const MOST_ROUNDS: usize = 8;
/// A grid of given steps is rounded to its numbers at most so often.
const MOST_ROUNDS_ON_GRID: usize = 20;
/// Coordinates may be so many steps of a given grid from zero.
const MOST_STEPS: f64 = (1u64 << 50) as f64;

/// Where the drawing with rounded coordinates and straight edges is not the arrangement any more.
///
/// With all lists empty the drawing has the same vertices, edges, orders around vertices, faces and holes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct RoundingCertificate {
    /// Vertices that have become equal: each with the first one at that place.
    pub merged_vertices: Vec<[VertexId; 2]>,
    /// Edges that have no length any more, cross or overlap other edges, or have a vertex on their inside.
    pub broken_edges: Vec<EdgeId>,
    /// Vertices around which whole edges are in another order.
    pub turned_vertices: Vec<VertexId>,
    /// Components that are turned inside out or lie in another face; looked for when nothing else is wrong.
    pub moved_components: Vec<usize>,
}

impl RoundingCertificate {
    /// Whether rounding has changed nothing.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two segments that cross in (1, 1).
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// assert!(cross.rounding_certificate()?.is_valid());
    /// # Ok(()) }
    /// ```
    pub fn is_valid(&self) -> bool {
        self.merged_vertices.is_empty()
            && self.broken_edges.is_empty()
            && self.turned_vertices.is_empty()
            && self.moved_components.is_empty()
    }
}

/// An arrangement whose vertices are exactly where their floating-point coordinates say, with what each part comes
/// from.
#[derive(Clone, Debug)]
pub struct SnappedArrangement {
    pub(super) arrangement: PlanarArrangement,
    pub(super) sources: Vec<VertexSource>,
    pub(super) segments_of_edge: RaggedArray,
    /// The vertex that each vertex of the input became.
    pub(super) places: Vec<u32>,
    /// The vertex that each point of the input became.
    pub(super) place_of_point: Vec<u32>,
    /// Whether segments run from the lower end of an edge to the upper, for each entry of their lists; none where pieces go
    /// the way of their segments on both axes.
    pub(super) runs_up: Option<Vec<bool>>,
    pub(super) round_count: usize,
    pub(super) joined: Option<JoinedFeatures>,
    pub(super) stacked: Option<StackedSegments>,
}

impl SnappedArrangement {
    /// The arrangement. The segments that it is made of are edges of the last round, not those of the input.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let flat = vec![0., 0., 1., 1., 0., 0.5, 1., 0.];
    /// let crossed = PlanarArrangement::new(&Positions::from_flat(2, flat)?, &[[0, 1], [2, 3]])?;
    /// // The crossing at one third is no floating-point number.
    /// let snapped = crossed.snapped()?;
    /// assert_eq!(snapped.arrangement().f_vector(), [5, 4, 0]);
    /// # Ok(()) }
    /// ```
    pub fn arrangement(&self) -> &PlanarArrangement {
        &self.arrangement
    }

    /// Where a vertex comes from in the input. After the first round a crossing is one of edges along these two
    /// segments.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_arrange::planar::{PlanarArrangement, VertexSource};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let flat = vec![0., 0., 1., 1., 0., 0.5, 1., 0.];
    /// let crossed = PlanarArrangement::new(&Positions::from_flat(2, flat)?, &[[0, 1], [2, 3]])?;
    /// // The crossing at one third is no floating-point number.
    /// let snapped = crossed.snapped()?;
    /// assert_eq!(snapped.source(VertexId::new(2)), VertexSource::Crossing([0, 1]));
    /// # Ok(()) }
    /// ```
    pub fn source(&self, vertex: VertexId) -> VertexSource {
        self.sources[vertex.index()]
    }

    /// The vertex that a vertex of the arrangement that was snapped became.
    ///
    /// # Panics
    /// If there was no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Three lines that nearly meet in (1, 1).
    /// let flat = vec![0., 0., 2., 2., 0., 2., 2., 0., 0., 1., 4., 1. + f64::EPSILON];
    /// let arrangement = PlanarArrangement::new(&Positions::from_flat(2, flat)?, &[[0, 1], [2, 3], [4, 5]])?;
    /// let snapped = arrangement.snapped()?;
    /// let places: Vec<usize> = (0..9).map(|v| snapped.place(VertexId::new(v)).index()).collect();
    /// assert_eq!(places, [0, 1, 2, 3, 3, 3, 4, 5, 6]);
    /// # Ok(()) }
    /// ```
    pub fn place(&self, vertex: VertexId) -> VertexId {
        VertexId::from_u32(self.places[vertex.index()])
    }

    /// The vertex that a point of the input became; none for one that was pruned before.
    ///
    /// # Panics
    /// If there was no such point.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let flat = vec![2., 2., 0., 0., 0., 2., 2., 0.];
    /// let crossed = PlanarArrangement::new(&Positions::from_flat(2, flat)?, &[[0, 1], [2, 3]])?;
    /// // Vertices are in lexicographic order.
    /// assert_eq!(crossed.snapped()?.place_of_point(0), Some(VertexId::new(4)));
    /// # Ok(()) }
    /// ```
    pub fn place_of_point(&self, point: usize) -> Option<VertexId> {
        let place = self.place_of_point[point];
        (place != NONE).then(|| VertexId::from_u32(place))
    }

    /// Whether segments run from the lower end of an edge to the upper, for each entry of
    /// [`Self::segments_of_edges`], one list after the other. None where all pieces go the way of their segments on both
    /// axes, or stand still on one, as they do after rounding; what was put together within a tolerance may go back a
    /// little.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let flat = vec![1., 0., 0., 0.];
    /// let one = PlanarArrangement::new(&Positions::from_flat(2, flat)?, &[[0, 1]])?;
    /// assert_eq!(one.snapped()?.runs_up(), None);
    /// assert_eq!(one.within(0.1)?.runs_up(), Some(&[false][..]));
    /// # Ok(()) }
    /// ```
    pub fn runs_up(&self) -> Option<&[bool]> {
        self.runs_up.as_deref()
    }

    /// The segments of the input that each edge is a piece of, moved by rounding: list e is edge e, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let flat = vec![0., 0., 1., 1., 0., 0.5, 1., 0.];
    /// let crossed = PlanarArrangement::new(&Positions::from_flat(2, flat)?, &[[0, 1], [2, 3]])?;
    /// // The crossing at one third is no floating-point number.
    /// let snapped = crossed.snapped()?;
    /// assert_eq!(snapped.segments_of_edges().list(0), [0]);
    /// # Ok(()) }
    /// ```
    pub fn segments_of_edges(&self) -> &RaggedArray {
        &self.segments_of_edge
    }

    /// How many times coordinates were rounded; 0 if they were exact from the beginning.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let flat = vec![0., 0., 1., 1., 0., 0.5, 1., 0.];
    /// let crossed = PlanarArrangement::new(&Positions::from_flat(2, flat)?, &[[0, 1], [2, 3]])?;
    /// // The crossing at one third is no floating-point number.
    /// let snapped = crossed.snapped()?;
    /// assert!(snapped.round_count() > 0);
    /// # Ok(()) }
    /// ```
    pub fn round_count(&self) -> usize {
        self.round_count
    }

    /// What was put together [within a tolerance](PlanarArrangement::within). Points are those of the input.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A segment that ends a hundredth above another one.
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 0., 1., 0.01, 1., 1.])?;
    /// let joined = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?.within(0.1)?;
    /// assert_eq!(joined.joined().map(|joined| joined.counts.edges), Some(1));
    /// assert_eq!(joined.arrangement().f_vector(), [4, 3, 0]);
    /// # Ok(()) }
    /// ```
    pub fn joined(&self) -> Option<&JoinedFeatures> {
        self.joined.as_ref()
    }

    /// What was stacked and glued, if this is an arrangement by congruence.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// assert!(cross.within(0.1)?.stacked().is_none());
    /// // Four points, and three on each of the two segments; two pieces of each.
    /// assert_eq!(cross.by_congruence(0.1)?.stacked().map(|stacked| stacked.f_vector), Some([10, 4]));
    /// # Ok(()) }
    /// ```
    pub fn stacked(&self) -> Option<&StackedSegments> {
        self.stacked.as_ref()
    }
}

impl PlanarArrangement {
    /// Whether the drawing with rounded coordinates is this arrangement still, and if not, where it is not.
    ///
    /// The drawing is arranged again and compared, so nothing is taken for granted. All vertices exact: nothing to do.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if a coordinate is beyond the range.
    ///
    /// # Complexity
    /// That of an arrangement of the edges.
    ///
    /// # Examples
    /// Three lines that nearly meet in (1, 1) make a triangle that is too small for numbers of this size.
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let flat = vec![0., 0., 2., 2., 0., 2., 2., 0., 0., 1., 4., 1. + f64::EPSILON];
    /// let arrangement = PlanarArrangement::new(&Positions::from_flat(2, flat)?, &[[0, 1], [2, 3], [4, 5]])?;
    /// assert_eq!(arrangement.f_vector(), [9, 9, 1]);
    /// let certificate = arrangement.rounding_certificate()?;
    /// assert!(!certificate.is_valid());
    /// assert_eq!((certificate.merged_vertices.len(), certificate.broken_edges.len()), (2, 3));
    /// assert_eq!(arrangement.snapped()?.arrangement().f_vector(), [7, 6, 0]);
    /// # Ok(()) }
    /// ```
    pub fn rounding_certificate(&self) -> Result<RoundingCertificate, Error> {
        if self.is_exactly_rounded() {
            return Ok(RoundingCertificate::default());
        }
        let drawn = Self::new(&self.positions, &self.ends)?;
        let mut certificate = RoundingCertificate::default();
        let image = |vertex: u32| drawn.vertex_of_point[vertex as usize];
        let mut first_at = vec![NONE; drawn.vertex_count()];
        for vertex in 0..self.vertex_count() as u32 {
            let first = &mut first_at[image(vertex) as usize];
            if *first == NONE {
                *first = vertex;
            } else {
                certificate.merged_vertices.push([*first, vertex].map(VertexId::from_u32));
            }
        }
        // The image of each edge, if it is whole and has none besides it.
        let whole = |edge: usize| match drawn.edges_of_segment.list(edge) {
            &[image] if drawn.segments_of_edge.list(image as usize).len() == 1 => image,
            _ => NONE,
        };
        let images: Vec<u32> = (0..self.edge_count()).map(whole).collect();
        let broken = images.iter().enumerate().filter(|(_, image)| **image == NONE);
        certificate.broken_edges = broken.map(|(edge, _)| EdgeId::new(edge)).collect();
        let halfedge_image = |halfedge: u32| {
            let edge = halfedge / 2;
            let [a, b] = self.ends[edge as usize];
            2 * images[edge as usize] + ((halfedge % 2) ^ u32::from(image(a) > image(b)))
        };
        for vertex in 0..self.vertex_count() {
            let leaving = self.orbits.rotation.list(vertex);
            if leaving.iter().any(|&h| images[h as usize / 2] == NONE) {
                continue;
            }
            let there = drawn.orbits.rotation.list(image(vertex as u32) as usize);
            if leaving.len() != there.len() {
                // Another vertex has come here, or a broken edge ends here.
                continue;
            }
            let mapped = leaving.iter().map(|&h| halfedge_image(h));
            let start = mapped.clone().next().and_then(|h| there.iter().position(|&other| other == h));
            let turned = start.unwrap_or(0);
            let cycle = there[turned..].iter().chain(&there[..turned]).copied();
            if !mapped.eq(cycle) {
                certificate.turned_vertices.push(VertexId::new(vertex));
            }
        }
        if certificate.is_valid() {
            // Vertices, edges and orbits correspond; is each component seen from outside, and in the same face?
            for (component, &lowest) in self.orbits.lowest_vertices.iter().enumerate() {
                let there = drawn.orbits.component_of[image(lowest) as usize] as usize;
                let orbit_image = |orbit: u32| {
                    let halfedge = self.orbits.orbits.list(orbit as usize)[0];
                    drawn.orbits.orbit_of[halfedge_image(halfedge) as usize]
                };
                let outer = self.orbits.outer_orbits[component];
                let is_outer = outer == NONE || orbit_image(outer) == drawn.orbits.outer_orbits[there];
                let around = match self.faces.around_component[component] {
                    NONE => NONE,
                    face => {
                        let orbit = self.faces.orbits.list(face as usize)[0];
                        drawn.faces.of_orbit[orbit_image(orbit) as usize]
                    }
                };
                if !is_outer || around != drawn.faces.around_component[there] {
                    certificate.moved_components.push(component);
                }
            }
        }
        Ok(certificate)
    }

    /// The arrangement of the edges drawn with rounded coordinates, rounded and arranged again until all vertices are
    /// exact: then its positions and edges are the same arrangement when they are read again.
    ///
    /// A vertex that is exact stays where it is, but for the rare drawings where eight rounds are not enough: these are
    /// rounded to the grid whose step is four times the last digit of the largest coordinate, which one round ends. A vertex
    /// moves by less than that step there.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if a coordinate is beyond the range.
    ///
    /// # Complexity
    /// That of an arrangement of the edges a round; most need one or two.
    ///
    /// # References
    /// D. Halperin, E. Packer, *Iterated snap rounding* (2002), of which the first rounds are the form with the numbers
    /// of the machine as the grid, and no distance kept between vertices and edges. J. Hobby, *Practical segment
    /// intersection with finite precision output* (1999), for the last round.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let flat = vec![0., 0., 1., 1., 0., 0.5, 1., 0.];
    /// let crossed = PlanarArrangement::new(&Positions::from_flat(2, flat)?, &[[0, 1], [2, 3]])?;
    /// let snapped = crossed.snapped()?;
    /// assert!(!crossed.is_exactly_rounded() && snapped.arrangement().is_exactly_rounded());
    /// assert_eq!(snapped.arrangement().f_vector(), [5, 4, 0]);
    /// assert_eq!(snapped.segments_of_edges().list(0), [0]);
    /// # Ok(()) }
    /// ```
    pub fn snapped(&self) -> Result<SnappedArrangement, Error> {
        let mut snapped = SnappedArrangement::of(self);
        while !snapped.arrangement.is_exactly_rounded() {
            snapped = match snapped.round_count {
                ..MOST_ROUNDS => snapped.next_round()?,
                _ => snapped.on_grid(&Grid::finest(&snapped.arrangement.positions), false)?,
            };
        }
        Ok(snapped)
    }

    /// The arrangement with all vertices on a grid: their coordinates are the multiples of a step, each as the nearest
    /// floating-point number.
    ///
    /// Edges run through the vertices in whose squares of the grid they are, so edges meet in common vertices only, and
    /// stay half a step away from the vertices that they do not end in.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if the step is no positive number, or if a
    /// coordinate is more than $2^{50}$ steps from zero.
    ///
    /// # Complexity
    /// That of an arrangement, and $O(n \log n)$ for n vertices of it where edges are in few squares each.
    ///
    /// # References
    /// J. Hobby, *Practical segment intersection with finite precision output* (1999); D. Halperin, E. Packer,
    /// *Iterated snap rounding* (2002).
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let flat = vec![0., 0., 1., 1., 0., 0.5, 1., 0.];
    /// let crossed = PlanarArrangement::new(&Positions::from_flat(2, flat)?, &[[0, 1], [2, 3]])?;
    /// let snapped = crossed.snapped_to_grid(0.01)?;
    /// assert_eq!(snapped.arrangement().positions().point(VertexId::new(2)), [0.33, 0.33]);
    /// # Ok(()) }
    /// ```
    pub fn snapped_to_grid(&self, step: f64) -> Result<SnappedArrangement, Error> {
        let grid = Grid::with_step(step, &self.positions)?;
        let mut snapped = SnappedArrangement::of(self).on_grid(&grid, true)?;
        // Multiples of a step are rounded once more, which hardly ever makes edges meet anew.
        while !snapped.arrangement.is_exactly_rounded() {
            if snapped.round_count == MOST_ROUNDS_ON_GRID {
                return Err(Error::invalid(format!(
                    "the grid of step {step} is so fine that its own points are rounded"
                ))
                .with_cure("take a larger step"));
            }
            snapped = snapped.on_grid(&grid, true)?;
        }
        Ok(snapped)
    }

    /// Whether the rounded positions of all vertices are their exact ones.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two segments that cross in (1, 1).
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// assert!(cross.is_exactly_rounded());
    /// # Ok(()) }
    /// ```
    pub fn is_exactly_rounded(&self) -> bool {
        // First what is known without computing.
        let certainly_not = |vertex: &coface_geometry::predicates::PlanarPoint| {
            vertex.residues().iter().any(|side| side.is_some_and(|side| side.is_ne()))
        };
        !self.vertices.iter().any(certainly_not)
            && self.vertices.iter().all(coface_geometry::predicates::PlanarPoint::is_exactly_rounded)
    }
}

/// The points whose coordinates are multiples of a step.
struct Grid {
    /// The step, or its inverse where that is the rounder number of the two.
    number: f64,
    is_inverse: bool,
}

impl Grid {
    /// The grid on which points with such coordinates may be rounded: its step is four times the last digit of the
    /// largest.
    fn finest(positions: &Positions) -> Self {
        let largest = largest(positions);
        let unit = f64::from_bits(largest.to_bits() + 1) - largest;
        Self { number: 4.0 * unit, is_inverse: false }
    }

    /// # Errors
    /// `InvalidInput` if the step is no positive number or too small.
    fn with_step(step: f64, positions: &Positions) -> Result<Self, Error> {
        if !(step.is_finite() && step > 0.0) {
            return Err(Error::invalid(format!("{step} is no step of a grid"))
                .with_cure("give a positive length, like 0.001"));
        }
        let inverse = 1.0 / step;
        let is_inverse = inverse.is_finite()
            && inverse >= 1.0
            && (inverse - inverse.round()).abs() <= inverse * f64::EPSILON;
        let grid = Self { number: if is_inverse { inverse.round() } else { step }, is_inverse };
        let largest = largest(positions);
        if grid.to_steps(largest) > MOST_STEPS {
            return Err(Error::invalid(format!(
                "{step} is too fine a grid for coordinates like {largest}: it has less than 2^-50 of it"
            ))
            .with_cure("take a larger step"));
        }
        Ok(grid)
    }

    fn to_steps(&self, x: f64) -> f64 {
        if self.is_inverse { x * self.number } else { x / self.number }
    }

    fn to_length(&self, steps: f64) -> f64 {
        if self.is_inverse { steps / self.number } else { steps * self.number }
    }
}

fn largest(positions: &Positions) -> f64 {
    positions.as_flat().iter().fold(0.0, |most, x| x.abs().max(most))
}

impl SnappedArrangement {
    pub(super) fn of(arrangement: &PlanarArrangement) -> Self {
        Self {
            arrangement: arrangement.clone(),
            sources: arrangement.sources.clone(),
            segments_of_edge: arrangement.segments_of_edge.clone(),
            places: (0..arrangement.vertex_count() as u32).collect(),
            place_of_point: arrangement.vertex_of_point.clone(),
            runs_up: None,
            round_count: 0,
            joined: None,
            stacked: None,
        }
    }

    fn next_round(&self) -> Result<Self, Error> {
        let from = &self.arrangement;
        let positions: &Positions = &from.positions;
        let arrangement = PlanarArrangement::new(positions, &from.ends)?;
        let sources = arrangement.sources.iter().map(|source| self.source_of(source)).collect();
        let segments_of_edge = RaggedArray::from_lists(
            arrangement.segments_of_edge.iter().map(|edges| self.segments_along(edges.iter().copied())),
        );
        let place = |place: u32| arrangement.vertex_of_point[place as usize];
        let (places, place_of_point) = self.moved(place);
        Ok(Self {
            arrangement,
            sources,
            segments_of_edge,
            places,
            place_of_point,
            runs_up: None,
            round_count: self.round_count + 1,
            joined: None,
            stacked: None,
        })
    }

    /// The places of vertices and of points after another round.
    fn moved(&self, place: impl Fn(u32) -> u32) -> (Vec<u32>, Vec<u32>) {
        let of_point = |&own: &u32| if own == NONE { NONE } else { place(own) };
        (
            self.places.iter().map(|&own| place(own)).collect(),
            self.place_of_point.iter().map(of_point).collect(),
        )
    }

    /// Where a vertex of an arrangement of the edges comes from.
    fn source_of(&self, source: &VertexSource) -> VertexSource {
        match *source {
            VertexSource::Given(vertex) => self.sources[vertex],
            VertexSource::Crossing(edges) => {
                VertexSource::Crossing(edges.map(|edge| self.segments_of_edge.list(edge)[0] as usize))
            }
        }
    }

    /// The segments of the input along some edges, rising.
    fn segments_along(&self, edges: impl Iterator<Item = u32>) -> Vec<u32> {
        let mut segments: Vec<u32> =
            edges.flat_map(|edge| self.segments_of_edge.list(edge as usize)).copied().collect();
        segments.sort_unstable();
        segments.dedup();
        segments
    }

    /// The edges snap rounded on a grid; `keeps_apart` also bends those that come into squares of vertices by that.
    fn on_grid(&self, grid: &Grid, keeps_apart: bool) -> Result<Self, Error> {
        let from = &self.arrangement;
        let flat = from.positions.as_flat().iter().map(|&x| grid.to_steps(x)).collect();
        let drawn = PlanarArrangement::new(&Positions::from_flat(2, flat)?, &from.ends)?;
        let pixels = HotPixels::new(&drawn);
        let mut sources: Vec<Option<VertexSource>> = vec![None; pixels.middles.len()];
        for (source, &pixel) in drawn.sources.iter().zip(&pixels.of_vertex) {
            let found = sources[pixel as usize].get_or_insert_with(|| self.source_of(source));
            // A vertex of the input before a crossing.
            if let (VertexSource::Crossing(_), VertexSource::Given(_)) = (&*found, source) {
                *found = self.source_of(source);
            }
        }
        let mut chains: Vec<Vec<u32>> =
            (from.ends.iter()).map(|ends| pixels.along(ends.map(|end| drawn.points[end as usize]))).collect();
        let mut grows = keeps_apart;
        while grows {
            let longer: Vec<Vec<u32>> = chains.iter().map(|chain| pixels.along_chain(chain)).collect();
            grows = longer != chains;
            chains = longer;
        }
        let mut edges_of_side: BTreeMap<[u32; 2], Vec<u32>> = BTreeMap::new();
        for (edge, chain) in (0..).zip(&chains) {
            for side in chain.windows(2) {
                let side = [side[0].min(side[1]), side[0].max(side[1])];
                edges_of_side.entry(side).or_default().push(edge);
            }
        }
        let sides: Vec<[u32; 2]> = edges_of_side.keys().copied().collect();
        let edges_of_side: Vec<Vec<u32>> = edges_of_side.into_values().collect();
        let flat = pixels.middles.as_flattened().iter().map(|&x| grid.to_length(x)).collect();
        let arrangement = PlanarArrangement::new(&Positions::from_flat(2, flat)?, &sides)?;
        let edges = |side: usize| edges_of_side[side].iter().copied();
        let first_segment =
            |side: usize| self.segments_of_edge.list(edges_of_side[side][0] as usize)[0] as usize;
        let source = |source: &VertexSource| match *source {
            VertexSource::Given(pixel) => sources[pixel].expect("a vertex is in each hot pixel"),
            VertexSource::Crossing(sides) => VertexSource::Crossing(sides.map(first_segment)),
        };
        let sources = arrangement.sources.iter().map(source).collect();
        let segments_of_edge = RaggedArray::from_lists(
            (arrangement.segments_of_edge.iter())
                .map(|sides| self.segments_along(sides.iter().flat_map(|&side| edges(side as usize)))),
        );
        let pixel = |place: u32| pixels.of_vertex[drawn.vertex_of_point[place as usize] as usize];
        let place = |place: u32| arrangement.vertex_of_point[pixel(place) as usize];
        let (places, place_of_point) = self.moved(place);
        Ok(Self {
            arrangement,
            sources,
            segments_of_edge,
            places,
            place_of_point,
            runs_up: None,
            round_count: self.round_count + 1,
            joined: None,
            stacked: None,
        })
    }
}
