//! Polygons with holes that some faces of an arrangement make up.

use super::PlanarArrangement;
use super::areas::{exact_walks_area, walks_area};
use super::faces::NONE;
use super::simple_rings::simple_rings;
use coface_algebra::{EdgeId, FaceId, RaggedArray, UnionFind, VertexId};
use coface_geometry::predicates::{PlanarLine, PlanarPoint, direction_turn};

/// Polygons with holes around some faces of an arrangement.
///
/// Rings are simple and have their polygon on the left: of each polygon the outer one comes first, counterclockwise, then the holes. A ring
/// begins with its lowest vertex. Polygons and holes are in the order of their rings.
///
/// # Examples
/// Both halves of a square that a segment cuts, which reaches beyond it:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::planar::PlanarArrangement;
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., -1., 1., 3.])?;
/// let segments = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]];
/// let arrangement = PlanarArrangement::new(&points, &segments)?;
/// let whole = arrangement.outline(&[true, true], false);
/// // Where the square was cut it goes straight on.
/// assert_eq!(whole.rings(), &RaggedArray::from_lists([[0, 6, 7, 1]]));
/// assert_eq!(whole.areas(&arrangement), [4.0]);
/// assert_eq!(arrangement.outline(&[true, true], true).areas(&arrangement), [2.0, 2.0]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct FaceOutline {
    rings: RaggedArray,
    polygons: RaggedArray,
    edges_of_sides: RaggedArray,
    polygon_of_face: Vec<u32>,
    component_count: usize,
    pinches: Vec<VertexId>,
}

impl FaceOutline {
    /// The vertices of the arrangement along each ring.
    pub fn rings(&self) -> &RaggedArray {
        &self.rings
    }

    /// The rings of each polygon, the outer one first.
    pub fn polygons(&self) -> &RaggedArray {
        &self.polygons
    }

    /// The edges of the arrangement along each side of the rings, one ring after the other.
    pub fn edges_of_sides(&self) -> &RaggedArray {
        &self.edges_of_sides
    }

    /// The polygon that a face is in, if it was selected.
    ///
    /// # Panics
    /// If there is no such face.
    pub fn polygon_of_face(&self, face: FaceId) -> Option<usize> {
        let polygon = self.polygon_of_face[face.index()];
        (polygon != NONE).then_some(polygon as usize)
    }

    /// The number of parts of the faces, which edges connect.
    pub fn component_count(&self) -> usize {
        self.component_count
    }

    /// The vertices, rising, at which more than two edges around the faces meet.
    pub fn pinches(&self) -> &[VertexId] {
        &self.pinches
    }

    /// The area of each polygon, to within 2^-50 of it.
    ///
    /// # Panics
    /// If the outline is of another arrangement.
    pub fn areas(&self, arrangement: &PlanarArrangement) -> Vec<f64> {
        let point = |vertex: u32| arrangement.vertices[vertex as usize];
        let area = |polygon: &[u32]| {
            let walks = || polygon.iter().map(|&ring| self.rings.list(ring as usize));
            walks_area(walks(), point).unwrap_or_else(|| exact_walks_area(walks(), point).to_f64())
        };
        self.polygons.iter().map(area).collect()
    }
}

impl PlanarArrangement {
    /// The polygons that the selected faces make up. Faces with an edge in common are one polygon, or with `keeps_apart` one each. A
    /// vertex with two edges is left out where a segment of the input goes straight on.
    ///
    /// # Panics
    /// Unless there is an entry for each bounded face.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n halfedges.
    ///
    /// # Examples
    /// [`FaceOutline`] has one.
    pub fn outline(&self, is_selected: &[bool], keeps_apart: bool) -> FaceOutline {
        assert_eq!(is_selected.len(), self.face_count(), "an entry for each face");
        let face = |halfedge: u32| self.faces.of_orbit[self.orbits.orbit_of[halfedge as usize] as usize];
        let is_in = |face: u32| face != NONE && is_selected[face as usize];
        let halfedges = 0..2 * self.edge_count() as u32;
        let is_rim = |&halfedge: &u32| is_in(face(halfedge)) && !is_in(face(halfedge ^ 1));
        let mut parts = UnionFind::new(self.face_count());
        for edge in halfedges.clone().step_by(2).filter(|&edge| is_in(face(edge)) && is_in(face(edge ^ 1))) {
            parts.unite(face(edge), face(edge ^ 1));
        }
        let parts = parts.class_numbers();
        let mut known: Vec<u32> = (0..).zip(&parts).filter(|(f, _)| is_in(*f)).map(|own| *own.1).collect();
        known.sort_unstable();
        known.dedup();
        let pinches = self.pinches(halfedges.clone().filter(is_rim));
        let is_boundary: Vec<bool> = match keeps_apart {
            false => halfedges.map(|halfedge| is_rim(&halfedge)).collect(),
            true => halfedges.map(|h| is_in(face(h)) && face(h) != face(h ^ 1)).collect(),
        };
        let class = |halfedge: u32| match keeps_apart {
            true => face(halfedge),
            false => parts[face(halfedge) as usize],
        };
        let is_kept = self.corners(&is_boundary);
        let (walks, starts) = simple_rings(&self.orbits, &self.ends, &is_boundary);
        let mut traced: Vec<TracedRing> =
            starts.windows(2).map(|own| self.traced(&walks[own[0]..own[1]], &is_kept)).collect();
        // The outer ring of each class first.
        traced.sort_by(|a, b| {
            let key = |ring: &TracedRing| (class(ring.first), !ring.is_outer);
            key(a).cmp(&key(b)).then_with(|| a.vertices.cmp(&b.vertices))
        });
        let mut polygons: Vec<&[TracedRing]> =
            traced.chunk_by(|a, b| class(a.first) == class(b.first)).collect();
        polygons.sort_by(|a, b| a[0].vertices.cmp(&b[0].vertices));
        let mut number_of_class = vec![NONE; self.face_count()];
        for (polygon, rings) in (0..).zip(&polygons) {
            number_of_class[class(rings[0].first) as usize] = polygon;
        }
        let polygon_of_face = (0..self.face_count() as u32).map(|face| match (is_in(face), keeps_apart) {
            (false, _) => NONE,
            (true, true) => number_of_class[face as usize],
            (true, false) => number_of_class[parts[face as usize] as usize],
        });
        let rings = || polygons.iter().copied().flatten();
        let mut numbers = 0u32..;
        let lists = polygons.iter().map(|rings| numbers.by_ref().take(rings.len()).collect::<Vec<u32>>());
        FaceOutline {
            polygons: RaggedArray::from_lists(lists),
            rings: RaggedArray::from_lists(rings().map(|ring| &ring.vertices)),
            edges_of_sides: RaggedArray::from_lists(rings().flat_map(|ring| &ring.edges)),
            polygon_of_face: polygon_of_face.collect(),
            component_count: known.len(),
            pinches,
        }
    }

    /// The vertices at which more than two of these halfedges begin or end.
    fn pinches(&self, rim: impl Iterator<Item = u32>) -> Vec<VertexId> {
        let mut degrees = vec![0u8; self.vertex_count()];
        for end in rim.flat_map(|halfedge| self.ends[halfedge as usize / 2]) {
            degrees[end as usize] = degrees[end as usize].saturating_add(1);
        }
        (0..degrees.len()).filter(|&vertex| degrees[vertex] > 2).map(VertexId::new).collect()
    }

    /// Whether each vertex is a corner of rings along these halfedges.
    fn corners(&self, is_boundary: &[bool]) -> Vec<bool> {
        let mut edges_at = vec![[NONE; 2]; self.vertex_count()];
        let mut is_corner = vec![false; self.vertex_count()];
        let is_on_ring = |edge: &u32| is_boundary[2 * *edge as usize] || is_boundary[2 * *edge as usize + 1];
        for edge in (0..self.edge_count() as u32).filter(is_on_ring) {
            for end in self.ends[edge as usize] {
                match edges_at[end as usize].iter_mut().find(|own| **own == NONE) {
                    Some(own) => *own = edge,
                    None => is_corner[end as usize] = true,
                }
            }
        }
        for (vertex, &edges) in edges_at.iter().enumerate().filter(|(_, edges)| edges[1] != NONE) {
            is_corner[vertex] |= !self.goes_straight_on(vertex, edges);
        }
        is_corner
    }

    /// Whether a segment of the input, or one that a segment is a part of, goes on from one of two edges at a vertex to the other.
    fn goes_straight_on(&self, vertex: usize, edges: [u32; 2]) -> bool {
        let along = |edge: u32| {
            self.segments_of_edge.list(edge as usize).iter().map(|&own| self.support(own as usize))
        };
        let [Some(s), Some(t)] = edges.map(|edge| along(edge).next()) else { return false };
        let goes_on = |line: PlanarLine| {
            let sides = line.map(|end| self.vertices[vertex].compare(&PlanarPoint::given(end)));
            sides[0].is_ne() && sides[1].is_ne() && sides[0] != sides[1]
        };
        direction_turn(s, t).is_eq() && edges.into_iter().flat_map(along).any(goes_on)
    }

    /// A ring from its lowest vertex on, through corners alone.
    fn traced(&self, walk: &[u32], is_kept: &[bool]) -> TracedRing {
        let lowest = (0..walk.len()).min_by_key(|&i| self.tail(walk[i])).unwrap_or(0);
        let first = walk[lowest];
        let (mut vertices, mut edges): (Vec<u32>, Vec<Vec<u32>>) = (Vec::new(), Vec::new());
        for &halfedge in walk[lowest..].iter().chain(&walk[..lowest]) {
            let tail = self.tail(halfedge);
            // At the lowest vertex a ring turns.
            if is_kept[tail as usize] || vertices.is_empty() {
                vertices.push(tail);
                edges.push(Vec::new());
            }
            edges.last_mut().expect("a ring begins with a corner").push(halfedge / 2);
        }
        TracedRing { first, is_outer: self.is_outer(walk), vertices, edges }
    }

    /// The exact place of a vertex is a floating-point number.
    #[doc(hidden)]
    pub fn is_exactly_rounded_at(&self, vertex: VertexId) -> bool {
        self.vertices[vertex.index()].is_exactly_rounded()
    }

    /// The segments along some edges, rising, each once.
    #[doc(hidden)]
    pub fn segments_along(&self, edges: impl IntoIterator<Item = EdgeId>) -> Vec<u32> {
        let lists = edges.into_iter().map(|edge| self.segments_of_edge.list(edge.index()));
        let mut segments: Vec<u32> = lists.flatten().copied().collect();
        segments.sort_unstable();
        segments.dedup();
        segments
    }
}

struct TracedRing {
    /// A halfedge of it.
    first: u32,
    is_outer: bool,
    vertices: Vec<u32>,
    edges: Vec<Vec<u32>>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planar::{PlanarOverlay, Step, are_valid_polygons};
    use coface_geometry::Positions;
    use proptest::prelude::*;

    proptest! {
        /// The polygons of an arrangement are those of an overlay, which has other structures and other code.
        #[test]
        fn outlines_are_those_of_overlays(
            corners in prop::collection::vec(prop::collection::vec(prop::array::uniform2(0i32..7), 3..6), 1..6),
            walls in any::<bool>(),
        ) {
            let flat: Vec<f64> = corners.iter().flatten().flatten().map(|&x| f64::from(x)).collect();
            let positions = Positions::from_flat(2, flat).unwrap();
            let mut numbers = 0u32..;
            let rings: Vec<Vec<u32>> =
                corners.iter().map(|ring| numbers.by_ref().take(ring.len()).collect()).collect();
            let sides: Vec<[u32; 2]> = rings
                .iter()
                .flat_map(|ring| (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]))
                .collect();
            let arrangement = PlanarArrangement::new(&positions, &sides).unwrap();
            let regions: Vec<u32> = (0..rings.len() as u32).collect();
            let overlay = PlanarOverlay::new(&positions, &RaggedArray::from_lists(rings), &regions).unwrap();
            // What an odd number of rings winds around.
            let chosen = overlay.select(|windings| windings.len() % 2 == 1).unwrap();
            let ring_of_side: Vec<usize> =
                corners.iter().enumerate().flat_map(|(ring, own)| vec![ring; own.len()]).collect();
            let mut odd = vec![false; arrangement.face_count()];
            let mut windings = vec![0i32; corners.len()];
            arrangement.tour(|step| {
                let (Step::Into { across, .. } | Step::Back { across, .. }) = step;
                for &side in arrangement.segments_of_edge.list(across as usize / 2) {
                    let up = arrangement.rises(side as usize) == across.is_multiple_of(2);
                    windings[ring_of_side[side as usize]] += if up { 1 } else { -1 };
                }
                if let Step::Into { face, .. } = step {
                    odd[face as usize] = windings.iter().filter(|&&own| own != 0).count() % 2 == 1;
                }
            });
            let outline = arrangement.outline(&odd, walls);
            let total: f64 = outline.areas(&arrangement).iter().sum();
            prop_assert!((total - chosen.area()).abs() <= 1e-12 * total.max(1.0), "{total} {}", chosen.area());
            if !walls {
                let counts = |polygons: &RaggedArray, rings: &RaggedArray| {
                    let mut lists: Vec<Vec<usize>> = polygons
                        .iter()
                        .map(|own| own.iter().map(|&ring| rings.list(ring as usize).len()).collect())
                        .collect();
                    lists.iter_mut().for_each(|list| list[1..].sort_unstable());
                    lists.sort();
                    lists
                };
                prop_assert_eq!(
                    counts(outline.polygons(), outline.rings()),
                    counts(chosen.polygons(), chosen.rings())
                );
                prop_assert_eq!(outline.pinches().len(), chosen.pinch_vertices().len());
                prop_assert_eq!(outline.component_count(), chosen.polygons().len());
            }
            // Rounded crossings may break polygons; exact ones do not.
            if arrangement.is_exactly_rounded() {
                prop_assert!(
                    are_valid_polygons(arrangement.positions(), outline.rings(), outline.polygons(), walls).unwrap()
                );
            }
        }
    }
}
