//! Faces refined until each is a disk.

use super::PlanarArrangement;
use crate::face_cells::{FaceCells, bridges, connected, has_simple_rim, low_matrices};
use coface_algebra::chains::{ChainComplex, ChainRefinement};
use coface_algebra::{Error, FaceId, RaggedArray, Rational, VertexId};
use coface_geometry::predicates::{PlanarPoint, orientation};
use coface_geometry::triangulation::triangulate_sides;
use std::cmp::Ordering;

impl PlanarArrangement {
    /// The complex of [`Self::chain_complex`], with the edge and the face that each edge and face is a piece of.
    ///
    /// # Errors
    /// [`TooLarge`](coface_algebra::ErrorKind::TooLarge) beyond 2^32 - 1 entries in a matrix.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n edges.
    pub fn ball_complex(&self) -> Result<(ChainComplex, ChainRefinement), Error> {
        let mut ends = self.ends.clone();
        let mut cells = FaceCells { ends: &mut ends, of_face: Vec::new(), sides: RaggedArray::new() };
        let mut groups = vec![Vec::new(); self.face_count()];
        let islands = self.islands();
        for (face, islands) in (0u32..).zip(islands.iter()) {
            let halfedges = || self.walks(Some(FaceId::from_u32(face))).flatten();
            let sides: Vec<([u32; 2], u32)> = halfedges().map(|&h| (self.halfedge_ends(h), h)).collect();
            if islands.is_empty() && has_simple_rim(&sides) {
                cells.add_whole(face, &sides);
                continue;
            }
            let is_cut = !has_simple_rim(&sides) && {
                let lists: Vec<[u32; 2]> = sides.iter().map(|side| side.0).collect();
                let point = |vertex: u32| &self.vertices[vertex as usize];
                let compare = |a: u32, b: u32| point(a).compare(point(b));
                let turn = |a: u32, b: u32, c: u32| self.turn(a, b, c);
                let triangles = triangulate_sides(&lists, compare, turn)?;
                cells.add_triangles(face, &sides, &triangles)
            };
            if !is_cut {
                cells.add_whole(face, &sides);
            }
            let lists: Vec<[u32; 2]> = sides.iter().map(|side| side.0).collect();
            let lone: Vec<u32> = islands.iter().copied().filter(|&v| self.is_lone(v)).collect();
            let own = &mut groups[face as usize];
            *own = connected(if is_cut { &[] } else { &lists }, &lone);
            if is_cut {
                own.insert(0, lists.iter().map(|ends| ends[0]).collect());
            }
        }
        let FaceCells { of_face, sides, .. } = cells;
        groups.iter().for_each(|own| ends.extend(bridges(&self.positions, own)));
        let pieces =
            |count: usize, all: usize| (0..all as u32).map(move |e| ((e as usize) < count).then_some(e));
        let edges = pieces(self.edge_count(), ends.len()).collect();
        let vertices = pieces(self.vertex_count(), self.vertex_count()).collect();
        let refinement = ChainRefinement::new(vec![vertices, edges, of_face.into_iter().map(Some).collect()]);
        let complex = ChainComplex::new(low_matrices(self.vertex_count(), &ends, &sides)?.into())?;
        Ok((complex, refinement))
    }

    /// For each face the lowest vertices of the components of edges inside of it.
    fn islands(&self) -> RaggedArray {
        let mut islands = vec![Vec::new(); self.face_count()];
        for (component, &lowest) in self.orbits.lowest_vertices.iter().enumerate() {
            if let Some(face) = self.face_around_component(component) {
                islands[face.index()].push(lowest);
            }
        }
        RaggedArray::from_lists(islands)
    }

    fn is_lone(&self, vertex: u32) -> bool {
        self.halfedges_around(VertexId::from_u32(vertex)).next().is_none()
    }

    /// Where a halfedge begins and ends.
    fn halfedge_ends(&self, halfedge: u32) -> [u32; 2] {
        let [low, high] = self.ends[(halfedge >> 1) as usize];
        if halfedge & 1 == 0 { [low, high] } else { [high, low] }
    }

    /// On which side of the line from one vertex to a second a third one is: `Greater` for left.
    fn turn(&self, a: u32, b: u32, c: u32) -> Ordering {
        exact_turn([a, b, c].map(|vertex| &self.vertices[vertex as usize]))
    }
}

/// On which side of the line from one point to a second a third one is: `Greater` for left.
#[doc(hidden)]
pub fn exact_turn(points: [&PlanarPoint; 3]) -> Ordering {
    let [a, b, c] = points.map(PlanarPoint::rounded);
    if points.iter().all(|point| point.residues() == [Some(Ordering::Equal); 2]) {
        return orientation(a, b, c);
    }
    // Coordinates are off by half a unit in the last place each.
    let ([dx, dy], [ex, ey]) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let largest = |numbers: &[f64]| numbers.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let bound = 32.0 * f64::EPSILON * largest(&[a, b, c].concat()) * largest(&[dx, dy, ex, ey]);
    let turn = dx * ey - dy * ex;
    if turn.abs() > bound && bound > 1e-280 && turn.is_finite() {
        return turn.total_cmp(&0.0);
    }
    let [a, b, c] = points.map(PlanarPoint::to_rational);
    let from_a = |point: &[Rational; 2], axis: usize| &point[axis] - &a[axis];
    let product = |x: &[Rational; 2], y: &[Rational; 2]| &from_a(x, 0) * &from_a(y, 1);
    product(&b, &c).cmp(&product(&c, &b))
}
