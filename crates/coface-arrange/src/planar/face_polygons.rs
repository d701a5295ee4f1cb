//! Faces of an arrangement as polygons with holes.

use super::PlanarArrangement;
use super::faces::NONE;
use super::simple_rings::simple_rings;
use super::tour::{Step, tour};
use coface_algebra::RaggedArray;

impl PlanarArrangement {
    /// The bounded faces as polygons with holes: rings by their vertices, and for each face its rings.
    ///
    /// Rings are simple and have the face on their left: of each face the outer one comes first, counterclockwise, then
    /// the holes. A ring begins with its lowest vertex. Bridges are in no ring.
    ///
    /// # Complexity
    /// Linear in the halfedges.
    ///
    /// # Examples
    /// A square with a smaller one in it and a bridge between them: the walk around the outer face passes the bridge
    /// twice.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = Positions::from_flat(2, vec![0., 0., 3., 0., 3., 3., 0., 3., 1., 1., 2., 1., 2., 2., 1., 2.])?;
    /// let lines = RaggedArray::from_lists([&[0, 1, 2, 3, 0][..], &[4, 5, 6, 7, 4], &[0, 4]]);
    /// let arrangement = PlanarArrangement::from_polylines(&points, &lines)?;
    /// let [rings, polygons] = arrangement.face_polygons();
    /// // Vertices are in lexicographic order.
    /// assert_eq!(rings, RaggedArray::from_lists([[0, 6, 7, 1], [2, 3, 5, 4], [2, 4, 5, 3]]));
    /// assert_eq!(polygons, RaggedArray::from_lists([&[0, 1][..], &[2]]));
    /// # Ok(()) }
    /// ```
    pub fn face_polygons(&self) -> [RaggedArray; 2] {
        let face = |halfedge: u32| self.faces.of_orbit[self.orbits.orbit_of[halfedge as usize] as usize];
        let is_boundary: Vec<bool> = (0..2 * self.edge_count() as u32)
            .map(|halfedge| face(halfedge) != NONE && face(halfedge) != face(halfedge ^ 1))
            .collect();
        let (rings, starts) = simple_rings(&self.orbits, &self.ends, &is_boundary);
        let ring = |number: u32| &rings[starts[number as usize]..starts[number as usize + 1]];
        let mut keys: Vec<(u32, bool, u32)> = (0..starts.len() as u32 - 1)
            .map(|number| (face(ring(number)[0]), !self.is_outer(ring(number)), number))
            .collect();
        keys.sort_unstable();
        let polygons = RaggedArray::grouped(self.face_count(), keys.iter().map(|&(face, _, _)| face));
        let by_vertices = RaggedArray::from_lists(keys.iter().map(|&(_, _, number)| {
            let mut vertices: Vec<u32> = ring(number).iter().map(|&halfedge| self.tail(halfedge)).collect();
            let lowest = (0..vertices.len()).min_by_key(|&i| vertices[i]).unwrap_or(0);
            vertices.rotate_left(lowest);
            vertices
        }));
        [by_vertices, polygons]
    }

    /// Whether a simple ring of halfedges runs counterclockwise.
    pub(super) fn is_outer(&self, ring: &[u32]) -> bool {
        let lowest = (0..ring.len()).min_by_key(|&i| self.tail(ring[i])).unwrap_or(0);
        let (out, back) = (ring[lowest], ring[(lowest + ring.len() - 1) % ring.len()] ^ 1);
        // Everything at the lowest vertex goes up, from straight down on counterclockwise.
        let around = self.orbits.rotation.list(self.tail(out) as usize);
        around.iter().find(|&&halfedge| halfedge == out || halfedge == back) == Some(&out)
    }

    /// Goes through all faces.
    #[doc(hidden)]
    pub fn tour(&self, step: impl FnMut(Step)) {
        tour(&self.orbits, &self.faces, step);
    }
}
