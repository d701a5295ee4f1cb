//! Regions laid over each other, and what a condition on their winding numbers selects.

use super::super::crossings::{Crossing, Meetings};
use super::super::faces::{Faces, NONE, Orbits};
use super::super::nesting::Ray;
use super::super::segment_tree::SegmentTree;
use super::super::tour::{Step, tour};
use super::super::windings::Windings;
use super::super::{PlanarOptions, VertexSource};
use super::chains::{Chain, Chains, Rings};
use super::clear_rounding::rounds_clearly;
use super::ring_cells::{ChainEdges, RingCells};
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind};
use coface_geometry::Positions;
use coface_geometry::predicates::{PlanarLine, PlanarPoint, orientation};
use rayon::prelude::*;
use std::cmp::Ordering;

/// So many nodes are worth a task of their own.
const AT_ONCE: usize = 1 << 14;

/// Regions with closed rings, laid over each other exactly: any Boolean combination of them is ready to be read off.
///
/// A ring winds once around what it has on its left. Rings may cross and touch themselves and each other, overlap, and
/// be there several times. Nothing is decided with a tolerance.
///
/// # Examples
/// Two squares that overlap in a quarter.
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::boolean::{BooleanFormula, InsideRule};
/// use coface_arrange::planar::PlanarOverlay;
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
/// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
/// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
/// let select = |text| overlay.boolean(&BooleanFormula::parse(text, &[])?, InsideRule::Nonzero);
/// assert_eq!(select("a | b")?.exact_area().to_string(), "7");
/// assert_eq!(select("a ^ b")?.polygons().len(), 2);
/// let both = select("a & b")?;
/// assert_eq!(both.f_vector(), [4, 4, 1]);
/// assert!(both.ring_positions(0).any(|corner| corner == [1.0, 1.0]));
/// # Ok(()) }
/// ```
pub struct PlanarOverlay {
    pub(super) rings: Rings,
    region_count: usize,
    pub(super) crossings: Vec<Crossing>,
    pub(super) chains: Chains,
    pub(super) cells: RingCells,
    /// The region of each ring.
    pub(super) regions: Vec<u32>,
    /// The lexicographically lowest corner of each edge between its ends.
    pub(super) lowest_corners: Vec<u32>,
    /// Whether each side is there to close a ring only; nothing if none is.
    chords: Vec<bool>,
    rounds_clearly: bool,
}

impl std::fmt::Debug for PlanarOverlay {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PlanarOverlay")
            .field("region_count", &self.region_count)
            .field("crossings", &self.crossings.len())
            .finish_non_exhaustive()
    }
}

impl PlanarOverlay {
    /// The overlay of rings. Each ring runs through its points and back to the first; `regions[i]` is the region that
    /// ring i belongs to.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless positions have two coordinates and there is one region for each ring;
    /// [`ErrorKind::NotInComplex`] naming a ring with a point that is not there; [`ErrorKind::TooLarge`] beyond 2^31
    /// pieces.
    ///
    /// # Complexity
    /// $O(n + k \log k)$, and the search for pairs of sides that come near each other, for n sides that meet k times;
    /// in parallel, with the same result whatever the number of threads. Corners between meetings are not sorted.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// assert_eq!(overlay.f_vector(), [10, 12, 3]);
    /// # Ok(()) }
    /// ```
    pub fn new(positions: &Positions, rings: &RaggedArray, regions: &[u32]) -> Result<Self, Error> {
        Self::with_options(positions, rings, regions, &PlanarOptions::default())
    }

    /// The same, with a bound on the number of cells.
    ///
    /// # Errors
    /// As [`Self::new`], and [`ErrorKind::TooLarge`] for more cells than [`PlanarOptions::max_cells`], as soon as that
    /// is certain.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::{PlanarOptions, PlanarOverlay};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 1., 0., 0., 1.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2]]);
    /// let lay = |most| {
    ///     PlanarOverlay::with_options(&corners, &rings, &[0], &PlanarOptions::new().max_cells(most))
    /// };
    /// // A triangle has seven cells.
    /// assert!(lay(7).is_ok() && lay(6).is_err());
    /// # Ok(()) }
    /// ```
    pub fn with_options(
        positions: &Positions,
        rings: &RaggedArray,
        regions: &[u32],
        options: &PlanarOptions,
    ) -> Result<Self, Error> {
        let mut found = Self::without_windings(positions, rings, regions, options)?;
        let step = |halfedge: u32, list: &mut Vec<(u32, i32)>| {
            found.across(halfedge, |region, by| list.push((region, by)));
        };
        found.cells.windings = Windings::new(&found.cells.orbits, &found.cells.faces, step)?;
        Ok(found)
    }

    /// The same for callers that follow winding numbers on a [tour](Self::tour): there is no list for each face, so
    /// nothing can be selected by a condition on it.
    ///
    /// # Errors
    /// As [`Self::with_options`].
    #[doc(hidden)]
    pub fn without_windings(
        positions: &Positions,
        rings: &RaggedArray,
        regions: &[u32],
        options: &PlanarOptions,
    ) -> Result<Self, Error> {
        Self::with_chords(positions, rings, regions, options, &[])
    }

    /// The same with sides that are there to close rings only, by their places in the lists of all rings together: no
    /// selection comes from them.
    pub(super) fn with_chords(
        positions: &Positions,
        rings: &RaggedArray,
        regions: &[u32],
        options: &PlanarOptions,
        is_chord: &[bool],
    ) -> Result<Self, Error> {
        check(positions, rings, regions)?;
        let rings = Rings::new(positions, rings);
        let tree = rings.soup.tree();
        let mut meetings = Meetings::of(&rings.soup, &tree, options)?;
        let is_chord = |&place: &u32| is_chord.get(place as usize).copied().unwrap_or(false);
        let mut chords: Vec<bool> = rings.places.iter().map(is_chord).collect();
        if chords.contains(&true) {
            // Of crossings at one place the first is what the place comes from.
            meetings.crossings.sort_by_key(|own| own.segments.iter().any(|&side| chords[side as usize]));
        } else {
            chords = Vec::new();
        }
        if meetings.crossings.len() + rings.points.len() >= 1 << 31 {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^31 corners and crossings")
                .with_cure("lay the regions over each other in parts"));
        }
        let chains = Chains::new(&rings, &meetings);
        let rounds_clearly = rounds_clearly(&rings, &chains, &meetings.crossings, &meetings.close);
        let edges = ChainEdges::new(&rings, &chains, &meetings.collinear);
        let crossings = meetings.crossings;
        let parts = Parts { rings: &rings, crossings: &crossings, chains: &chains, edges: &edges };
        let mut orbits = Orbits::new(chains.nodes.len(), &edges.ends, |halfedge| parts.departure(halfedge));
        let lowest_corners: Vec<u32> = (0..edges.ends.len() as u32)
            .into_par_iter()
            .map(|edge| parts.first_chain(edge).lowest_corner(&rings).unwrap_or(NONE))
            .collect();
        let lowest = parts.lowest_points(&mut orbits, &lowest_corners);
        let mut rising: Vec<usize> = (0..lowest.len()).collect();
        rising.par_sort_by(|&a, &b| lowest[a].compare(&lowest[b]));
        // There is nothing to the left of the lowest point of all. Near components are asked one after the other.
        let first = rising.first().copied();
        let below: Vec<Option<u32>> =
            (0..lowest.len())
                .into_par_iter()
                .with_min_len(16)
                .map(|component| {
                    if first == Some(component) {
                        None
                    } else {
                        parts.halfedge_below(&tree, lowest[component])
                    }
                })
                .collect();
        drop(tree);
        let faces = Faces::new(&orbits, &below, rising.into_iter());
        let regions: Vec<u32> = rings.numbers.iter().map(|&ring| regions[ring as usize]).collect();
        let region_count = regions.iter().max().map_or(0, |&last| last as usize + 1);
        let cells = RingCells { edges, orbits, faces, windings: Windings::default() };
        let found = Self {
            rings,
            region_count,
            crossings,
            chains,
            cells,
            regions,
            lowest_corners,
            chords,
            rounds_clearly,
        };
        if options.max_cells.is_some() {
            options.check(found.f_vector().iter().sum(), "in all")?;
        }
        Ok(found)
    }

    /// The numbers of vertices, edges and bounded faces that the rings cut the plane into: those of the arrangement of
    /// their sides.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// assert_eq!(overlay.f_vector(), [10, 12, 3]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> [usize; 3] {
        // Corners between nodes are a vertex and an edge more each.
        let parts = self.parts();
        let edge_count = self.cells.edges.ends.len();
        let corner_counts = (0..edge_count as u32).map(|edge| parts.first_chain(edge).corner_count as usize);
        let corner_count: usize = corner_counts.sum();
        [self.chains.nodes.len() + corner_count, edge_count + corner_count, self.face_count()]
    }

    /// One more than the highest region that a ring with sides belongs to.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// assert_eq!(overlay.region_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn region_count(&self) -> usize {
        self.region_count
    }

    /// The number of bounded faces that the rings cut the plane into.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// assert_eq!(overlay.face_count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn face_count(&self) -> usize {
        self.cells.faces.orbits.len()
    }

    /// The places where rings meet each other or themselves.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// // In (2, 1) and (1, 2).
    /// assert_eq!(overlay.meeting_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn meeting_count(&self) -> usize {
        self.chains.meeting_count
    }

    /// Whether it is clear that polygons of any selection stay valid, with rings that run as they do, when their vertices are
    /// rounded; `false` says nothing.
    #[doc(hidden)]
    pub fn rounds_clearly(&self) -> bool {
        self.rounds_clearly
    }

    /// Goes through all faces.
    #[doc(hidden)]
    pub fn tour(&self, step: impl FnMut(Step)) {
        tour(&self.cells.orbits, &self.cells.faces, step);
    }

    /// How much more each region winds around what is left of a halfedge than around what is right of it. A region
    /// comes several times where several of its rings run along the edge.
    #[doc(hidden)]
    pub fn across(&self, halfedge: u32, mut wind: impl FnMut(u32, i32)) {
        for (at, &chain) in self.cells.edges.chains.list(halfedge as usize / 2).iter().enumerate() {
            // The edge has the direction of its first chain.
            let is_along = match at {
                0 => halfedge.is_multiple_of(2),
                _ => self.cells.edges.halfedge_of_chain[chain as usize] == halfedge,
            };
            let ring = self.chains.ring_of(&self.rings, chain);
            wind(self.regions[ring as usize], if is_along { 1 } else { -1 });
        }
    }

    /// Whether a side, by its number among those with a length, is there to close a ring only.
    pub(super) fn is_chord(&self, side: u32) -> bool {
        self.chords.get(side as usize).copied().unwrap_or(false)
    }

    /// Points where rings of a region meet each other or themselves, at most so many: those where two of their sides
    /// cross before the others, the lowest first.
    #[doc(hidden)]
    pub fn meetings_of(&self, region: u32, most: usize) -> Vec<PlanarPoint> {
        let is_own = |ring: u32| self.regions[ring as usize] == region;
        let mut degrees = vec![0u8; self.chains.nodes.len()];
        for (chains, ends) in self.cells.edges.chains.iter().zip(&self.cells.edges.ends) {
            if chains.iter().any(|&chain| is_own(self.chains.ring_of(&self.rings, chain))) {
                for &end in ends {
                    degrees[end as usize] = degrees[end as usize].saturating_add(1);
                }
            }
        }
        let is_crossing = |node: usize| {
            let crossing = (self.chains.nodes[node] as usize).checked_sub(self.rings.points.len());
            let sides = crossing.map(|crossing| self.crossings[crossing].segments);
            sides.is_some_and(|sides| sides.iter().all(|&side| is_own(self.rings.ring_of(side) as u32)))
        };
        let mut meetings: Vec<usize> = (0..degrees.len()).filter(|&node| degrees[node] > 2).collect();
        let parts = self.parts();
        meetings.sort_by(|&a, &b| {
            let order = is_crossing(b).cmp(&is_crossing(a));
            order.then_with(|| parts.compare_nodes(a as u32, b as u32))
        });
        meetings.into_iter().take(most).map(|node| parts.node_point(node as u32)).collect()
    }

    pub(super) fn parts(&self) -> Parts<'_> {
        Parts {
            rings: &self.rings,
            crossings: &self.crossings,
            chains: &self.chains,
            edges: &self.cells.edges,
        }
    }

    /// Where a node or corner comes from; a crossing names places of sides in the lists of all rings together.
    pub(super) fn source(&self, event: u32) -> VertexSource {
        match (event as usize).checked_sub(self.rings.points.len()) {
            None => VertexSource::Given(self.rings.points[event as usize] as usize),
            Some(crossing) => VertexSource::Crossing(
                self.crossings[crossing].segments.map(|side| self.rings.places[side as usize] as usize),
            ),
        }
    }
}

/// # Errors
/// If the input of an overlay does not fit together.
fn check(positions: &Positions, rings: &RaggedArray, regions: &[u32]) -> Result<(), Error> {
    if positions.dimension() != 2 && !positions.is_empty() {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("points of dimension {} do not lie in the plane", positions.dimension()),
        )
        .with_cure("give two coordinates for each point"));
    }
    if rings.len() != regions.len() {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("{} regions are named for {} rings", regions.len(), rings.len()),
        )
        .with_cure("name the region of each ring"));
    }
    let count = positions.len();
    if rings.items().iter().any(|&point| point as usize >= count) {
        let (ring, point) = rings
            .iter()
            .enumerate()
            .find_map(|(i, ring)| Some((i, *ring.iter().find(|&&point| point as usize >= count)?)))
            .expect("one of the rings has such a point");
        return Err(Error::new(
            ErrorKind::NotInComplex,
            format!("ring {ring} runs through point {point}; there are {count} points"),
        ));
    }
    if rings.item_count() >= 1 << 31 {
        return Err(Error::new(ErrorKind::TooLarge, "more than 2^31 sides"));
    }
    Ok(())
}

/// What decisions about nodes and edges are made from.
#[derive(Clone, Copy)]
pub(super) struct Parts<'a> {
    rings: &'a Rings,
    crossings: &'a [Crossing],
    pub(super) chains: &'a Chains,
    edges: &'a ChainEdges,
}

impl<'a> Parts<'a> {
    /// The chain that an edge has its direction from.
    pub(super) fn first_chain(&self, edge: u32) -> Chain {
        self.chains.chain(self.rings, self.edges.first_chain(edge))
    }

    /// The side along which a chain leaves its first node, or with `is_against` the one along which it comes to its
    /// last.
    pub(super) fn end_side(&self, chain: u32, is_against: bool) -> u32 {
        self.chains.end_side(self.rings, chain, is_against)
    }

    /// A corner, or after the corners a crossing.
    pub(super) fn event_point(&self, event: u32) -> PlanarPoint {
        match (event as usize).checked_sub(self.rings.points.len()) {
            None => PlanarPoint::given(self.rings.soup.points[event as usize]),
            Some(crossing) => self.crossings[crossing].point(&self.rings.soup),
        }
    }

    pub(super) fn node_point(&self, node: u32) -> PlanarPoint {
        self.event_point(self.chains.nodes[node as usize])
    }

    pub(super) fn rounded_node(&self, node: u32) -> [f64; 2] {
        let event = self.chains.nodes[node as usize] as usize;
        match event.checked_sub(self.rings.points.len()) {
            None => self.rings.soup.points[event],
            Some(crossing) => self.crossings[crossing].rounded,
        }
    }

    /// The lexicographic order of two nodes.
    pub(super) fn compare_nodes(&self, a: u32, b: u32) -> Ordering {
        let [[ax, ay], [bx, by]] = [a, b].map(|node| self.rounded_node(node));
        // Rounding is monotone, so different values are in order.
        if ax != bx {
            return if ax < bx { Ordering::Less } else { Ordering::Greater };
        }
        match self.node_point(a).compare_coordinate(&self.node_point(b), 0) {
            Ordering::Equal if ay != by => {
                if ay < by {
                    Ordering::Less
                } else {
                    Ordering::Greater
                }
            }
            Ordering::Equal => self.node_point(a).compare_coordinate(&self.node_point(b), 1),
            order => order,
        }
    }

    /// The side along which a halfedge leaves its node, in the direction of leaving.
    pub(super) fn departure(&self, halfedge: u32) -> PlanarLine {
        let is_against = !halfedge.is_multiple_of(2);
        let chain = self.edges.first_chain(halfedge / 2);
        let [a, b] = self.rings.soup.line(self.chains.end_side(self.rings, chain, is_against));
        if is_against { [b, a] } else { [a, b] }
    }

    /// How an edge turns at a corner within it: `Greater` for counterclockwise.
    pub(super) fn turn_at(&self, corner: u32, ring: usize) -> Ordering {
        let [a, b] = self.rings.soup.line(self.rings.side_before(corner, ring));
        orientation(a, b, self.rings.soup.line(corner)[1])
    }

    pub(super) fn ring_of_edge(&self, edge: u32) -> usize {
        self.chains.ring_of(self.rings, self.edges.first_chain(edge)) as usize
    }

    /// The lowest point of each component; the orbits outside are put right where that is no node.
    fn lowest_points(&self, orbits: &mut Orbits, lowest_corners: &[u32]) -> Vec<PlanarPoint> {
        let mut lowest_nodes = orbits.lowest_vertices.clone();
        // The lowest nodes of runs of one component, side by side.
        let runs: Vec<Vec<u32>> = (orbits.component_of.par_chunks(AT_ONCE).enumerate())
            .map(|(chunk, components)| {
                let mut lowest = Vec::new();
                let mut first = (chunk * AT_ONCE) as u32;
                for run in components.chunk_by(|a, b| a == b) {
                    let nodes = first..first + run.len() as u32;
                    first = nodes.end;
                    lowest.extend(nodes.reduce(|a, b| if self.compare_nodes(b, a).is_lt() { b } else { a }));
                }
                lowest
            })
            .collect();
        for node in runs.into_iter().flatten() {
            let lowest = &mut lowest_nodes[orbits.component_of[node as usize] as usize];
            if self.compare_nodes(node, *lowest).is_lt() {
                *lowest = node;
            }
        }
        orbits.outer_orbits = lowest_nodes.iter().map(|&node| orbits.orbit_outside(node)).collect();
        let mut lowest: Vec<PlanarPoint> = lowest_nodes.iter().map(|&node| self.node_point(node)).collect();
        for (edge, &corner) in (0..).zip(lowest_corners).filter(|(_, corner)| **corner != NONE) {
            let component = orbits.component_of[self.edges.ends[edge as usize][0] as usize] as usize;
            let point = PlanarPoint::given(self.rings.soup.points[corner as usize]);
            if point.compare(&lowest[component]).is_lt() {
                lowest[component] = point;
                // At the lowest corner the outside is on the side that the edge does not turn to.
                let turns_left = self.turn_at(corner, self.ring_of_edge(edge)).is_gt();
                orbits.outer_orbits[component] = orbits.orbit_of[(2 * edge + u32::from(turns_left)) as usize];
            }
        }
        lowest
    }

    /// The halfedge directly below a point, with the point on its left.
    pub(super) fn halfedge_below(&self, tree: &SegmentTree, from: PlanarPoint) -> Option<u32> {
        Ray { from }.first_below(tree, |side| {
            let [a, b] = self.rings.soup.line(side);
            let is_right = a[0] < b[0];
            // The nodes on the side that come before the place right of the line down.
            let breaks = &self.chains.breaks;
            let inside = breaks.partition_point(|at| (at.side, at.is_within()) <= (side, false));
            let own = &breaks[inside..];
            let own = &own[..own.partition_point(|at| at.side == side)];
            let passed = own.partition_point(|at| {
                let is_left = self.node_point(at.node()).compare_coordinate(&from, 0).is_le();
                is_left == is_right
            });
            let ring = self.rings.ring_of(side);
            let [first, end] = [self.chains.starts[ring], self.chains.starts[ring + 1]].map(|at| at as usize);
            // Before the first node of a ring its last chain runs.
            let chain = if inside + passed == first { end } else { inside + passed } - 1;
            let along = self.edges.halfedge_of_chain[chain];
            Some(if is_right { along } else { along ^ 1 })
        })
    }
}
