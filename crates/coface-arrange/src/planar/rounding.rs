//! What rounding the coordinates does to an arrangement, and arrangements that are drawn with rounded ones.

use super::faces::NONE;
use super::{PlanarArrangement, VertexSource};
use coface_algebra::RaggedArray;
use coface_algebra::{EdgeId, Error, VertexId};
use coface_geometry::Positions;

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
    arrangement: PlanarArrangement,
    sources: Vec<VertexSource>,
    segments_of_edge: RaggedArray,
    round_count: usize,
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
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if a coordinate is beyond the range, or if
    /// rounding does not come to an end within a hundred rounds.
    ///
    /// # Complexity
    /// That of an arrangement of the edges a round; most need one or two.
    ///
    /// # References
    /// D. Halperin, E. Packer, *Iterated snap rounding* (2002), of which this is the form with the numbers of the
    /// machine as the grid, and no distance kept between vertices and edges.
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
        const MOST_ROUNDS: usize = 100;
        let mut snapped = SnappedArrangement {
            arrangement: self.clone(),
            sources: self.sources.clone(),
            segments_of_edge: self.segments_of_edge.clone(),
            round_count: 0,
        };
        while !snapped.arrangement.is_exactly_rounded() {
            if snapped.round_count == MOST_ROUNDS {
                return Err(Error::invalid(format!(
                    "rounding moves edges over vertices again and again: {MOST_ROUNDS} rounds are not enough"
                ))
                .with_cure("scale the drawing up, or remove segments that nearly coincide"));
            }
            snapped = snapped.next_round()?;
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

impl SnappedArrangement {
    fn next_round(&self) -> Result<Self, Error> {
        let from = &self.arrangement;
        let positions: &Positions = &from.positions;
        let arrangement = PlanarArrangement::new(positions, &from.ends)?;
        let first_segment = |edge: usize| self.segments_of_edge.list(edge)[0] as usize;
        let source = |source: &VertexSource| match *source {
            VertexSource::Given(vertex) => self.sources[vertex],
            VertexSource::Crossing(edges) => VertexSource::Crossing(edges.map(first_segment)),
        };
        let sources = arrangement.sources.iter().map(source).collect();
        let segments_of_edge = RaggedArray::from_lists(arrangement.segments_of_edge.iter().map(|edges| {
            let mut segments: Vec<u32> =
                edges.iter().flat_map(|&edge| self.segments_of_edge.list(edge as usize)).copied().collect();
            segments.sort_unstable();
            segments.dedup();
            segments
        }));
        Ok(Self { arrangement, sources, segments_of_edge, round_count: self.round_count + 1 })
    }
}
