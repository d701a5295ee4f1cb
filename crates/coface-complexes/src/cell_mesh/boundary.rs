//! The boundary of a cell mesh as a surface of its own, and the orientation of the cells.

use crate::cell_mesh::mesh::CellMesh;
use crate::coherence::Coherence;
use crate::surface::PolygonMesh;
use crate::surface::dual_graph::DualGraph;
use crate::surface::dual_graph::coherence;
use coface_algebra::RaggedArray;
use coface_algebra::{CellId, FaceId, VertexId};

/// The faces in exactly one cell, as a polygon mesh with vertices of its own.
///
/// Each face runs as the boundary of its cell does: outward for positive cells.
#[derive(Clone, Debug)]
pub struct BoundarySurface {
    mesh: PolygonMesh,
    vertices: Vec<VertexId>,
    faces: Vec<FaceId>,
}

impl BoundarySurface {
    /// The surface; its vertices are those of boundary faces only, in the order of the cell mesh.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// let boundary = mesh.boundary_surface();
    /// assert_eq!(boundary.mesh().face_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn mesh(&self) -> &PolygonMesh {
        &self.mesh
    }

    /// The vertex of the cell mesh that each vertex of the surface is.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// let boundary = mesh.boundary_surface();
    /// assert_eq!(boundary.vertices().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn vertices(&self) -> &[VertexId] {
        &self.vertices
    }

    /// The face of the cell mesh that each face of the surface is.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// let boundary = mesh.boundary_surface();
    /// assert_eq!(boundary.faces().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn faces(&self) -> &[FaceId] {
        &self.faces
    }
}

/// How the cells of a mesh are oriented and whether they can be oriented coherently, across the faces with two cells.
pub type VolumeOrientation = Coherence<CellId, FaceId>;

impl DualGraph for CellMesh {
    fn node_count(&self) -> usize {
        self.cell_count()
    }

    fn facet_count(&self) -> usize {
        self.face_count()
    }

    fn facets_of(&self, cell: u32) -> impl Iterator<Item = u32> {
        self.packed_faces(cell as usize).iter().map(|packed| packed >> 1)
    }

    fn nodes_at(&self, face: usize) -> &[u32] {
        self.packed_cells(face)
    }
}

impl CellMesh {
    /// Whether the cells agree, whether they can be made to, and a closed chain of cells that cannot if not.
    ///
    /// # Complexity
    /// Linear when the cells agree as listed; else nearly linear, by union-find with signs.
    ///
    /// # Examples
    /// Two tetrahedra on a common face, the second listed in mirror order:
    /// ```
    /// use coface_algebra::{RaggedArray, Sign};
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// use coface_algebra::CellId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let cells = RaggedArray::from_lists([[0, 1, 2, 3], [0, 1, 2, 4]]);
    /// let mesh = CellMesh::new(5, vec![CellShape::Tetrahedron; 2], cells, &RaggedArray::new(), &[])?;
    /// let orientation = mesh.orientation();
    /// assert_eq!((orientation.is_coherent(), orientation.is_orientable()), (Some(false), Some(true)));
    /// assert_eq!(orientation.sign(CellId::new(1)), Sign::Minus);
    /// # Ok(()) }
    /// ```
    pub fn orientation(&self) -> VolumeOrientation {
        coherence(self)
    }

    /// The faces in exactly one cell, as a surface.
    ///
    /// # Examples
    /// The boundary of a hexahedron is a sphere of six quadrangles:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let cells = RaggedArray::from_lists([[0, 1, 2, 3, 4, 5, 6, 7]]);
    /// let mesh = CellMesh::new(8, vec![CellShape::Hexahedron], cells, &RaggedArray::new(), &[])?;
    /// let boundary = mesh.boundary_surface();
    /// assert_eq!(boundary.mesh().f_vector(), [8, 12, 6]);
    /// assert_eq!(boundary.mesh().survey().name().as_deref(), Some("sphere"));
    /// # Ok(()) }
    /// ```
    pub fn boundary_surface(&self) -> BoundarySurface {
        const ABSENT: u32 = u32::MAX;
        let faces: Vec<FaceId> = (0..self.face_count())
            .filter(|&face| self.packed_cells(face).len() == 1)
            .map(FaceId::new)
            .collect();
        let mut local = vec![ABSENT; self.vertex_count()];
        for &face in &faces {
            for &vertex in self.skeleton().face(face) {
                local[vertex as usize] = 0;
            }
        }
        let mut vertices = Vec::new();
        for (vertex, number) in local.iter_mut().enumerate().filter(|(_, number)| **number != ABSENT) {
            *number = vertices.len() as u32;
            vertices.push(VertexId::new(vertex));
        }
        let mut polygons = RaggedArray::new();
        let mut polygon = Vec::new();
        for &face in &faces {
            polygon.clear();
            polygon.extend(self.skeleton().face(face).iter().map(|&vertex| local[vertex as usize]));
            if self.packed_cells(face.index())[0] & 1 == 1 {
                polygon.reverse();
            }
            polygons.push(&polygon);
        }
        let mesh = PolygonMesh::new(vertices.len(), polygons, &[]).expect("faces of a mesh are polygons");
        BoundarySurface { mesh, vertices, faces }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell_mesh::manifold::VolumeDefect;
    use crate::cell_mesh::shape::CellShape;
    use coface_algebra::Sign;
    use proptest::prelude::*;
    use std::collections::{BTreeMap, BTreeSet};

    fn tetrahedra(vertex_count: usize, cells: &[[u32; 4]]) -> CellMesh {
        let shapes = vec![CellShape::Tetrahedron; cells.len()];
        CellMesh::new(vertex_count, shapes, RaggedArray::from_lists(cells), &RaggedArray::new(), &[]).unwrap()
    }

    /// The boundary of the 4-simplex.
    fn three_sphere() -> Vec<[u32; 4]> {
        vec![[1, 2, 3, 4], [0, 2, 3, 4], [0, 1, 3, 4], [0, 1, 2, 4], [0, 1, 2, 3]]
    }

    /// The cone over triangles with a new apex.
    fn cone(triangles: &[[u32; 3]], apex: u32) -> Vec<[u32; 4]> {
        triangles.iter().map(|&[a, b, c]| [a, b, c, apex]).collect()
    }

    fn torus() -> Vec<[u32; 3]> {
        (0..7).flat_map(|i| [[0, 1, 3], [0, 2, 3]].map(|t| t.map(|v: u32| (v + i) % 7))).collect()
    }

    fn projective_plane() -> Vec<[u32; 3]> {
        vec![
            [0, 1, 2],
            [0, 2, 3],
            [0, 3, 4],
            [0, 4, 5],
            [0, 5, 1],
            [1, 2, 4],
            [2, 3, 5],
            [3, 4, 1],
            [4, 5, 2],
            [5, 1, 3],
        ]
    }

    #[test]
    fn spheres_and_balls_are_manifolds() {
        let sphere = tetrahedra(5, &three_sphere());
        let verdict = sphere.manifold_verdict();
        assert!(verdict.is_manifold() && verdict.is_closed());
        assert_eq!(sphere.orientation().is_orientable(), Some(true));
        assert_eq!(sphere.boundary_surface().mesh().f_vector(), [0, 0, 0]);
        let ball = tetrahedra(5, &three_sphere()[1..]);
        let verdict = ball.manifold_verdict();
        assert!(verdict.is_manifold() && !verdict.is_closed());
        assert_eq!(ball.boundary_surface().mesh().survey().name().as_deref(), Some("sphere"));
    }

    #[test]
    fn cones_over_other_surfaces_fail_at_the_apex() {
        for (triangles, apex, euler) in [(torus(), 7, 0), (projective_plane(), 6, 1)] {
            let mesh = tetrahedra(apex as usize + 1, &cone(&triangles, apex));
            let verdict = mesh.manifold_verdict();
            assert_eq!(verdict.non_manifold_vertices(), [VertexId::from_u32(apex)]);
            let Some(&VolumeDefect::VertexLink {
                euler_characteristic, component_count, has_boundary, ..
            }) = verdict.witness()
            else {
                panic!("{verdict:?}")
            };
            assert_eq!((euler_characteristic, component_count, has_boundary), (euler, 1, false));
        }
        // A sphere and a torus as the two parts of a link have the Euler characteristic of one sphere.
        let mut both = cone(&torus(), 11);
        both.extend(cone(&[[7, 8, 9], [7, 8, 10], [7, 9, 10], [8, 9, 10]], 11));
        let verdict = tetrahedra(12, &both).manifold_verdict();
        assert!(matches!(
            verdict.witness(),
            Some(VolumeDefect::VertexLink { euler_characteristic: 2, component_count: 2, .. })
        ));
    }

    #[test]
    fn cones_over_one_sided_surfaces_have_no_orientation() {
        let mesh = tetrahedra(7, &cone(&projective_plane(), 6));
        let orientation = mesh.orientation();
        assert_eq!(orientation.is_orientable(), Some(false));
        let cycle = orientation.odd_cycle().unwrap();
        let n = cycle.cells().len();
        let mut conflicts = 0;
        for (i, &face) in cycle.facets().iter().enumerate() {
            let around: Vec<(CellId, Sign)> = mesh.cells_of_face(face).collect();
            let [(c, s), (d, t)] = around[..] else { panic!("{face}") };
            assert_eq!(
                BTreeSet::from([c, d]),
                BTreeSet::from([cycle.cells()[i], cycle.cells()[(i + 1) % n]])
            );
            conflicts += usize::from(s == t);
        }
        assert_eq!(conflicts % 2, 1);
    }

    #[test]
    fn crowded_and_loose_faces_are_named() {
        let book = tetrahedra(6, &[[0, 1, 2, 3], [0, 1, 2, 4], [0, 1, 2, 5]]);
        let verdict = book.manifold_verdict();
        let face = book.skeleton().polygons().iter().position(|p| p == [0, 1, 2]).map(FaceId::new).unwrap();
        assert_eq!(verdict.non_manifold_faces(), [face]);
        assert_eq!(verdict.witness().unwrap().message(), format!("face {face} lies in 3 cells: c0 c1 c2"));
        assert_eq!(book.orientation().is_orientable(), None);
        let polygons = RaggedArray::from_lists([[0, 1, 4]]);
        let cells = RaggedArray::from_lists([[0, 1, 2, 3]]);
        let finned = CellMesh::new(5, vec![CellShape::Tetrahedron], cells, &polygons, &[]).unwrap();
        assert_eq!(
            finned.manifold_verdict().witness(),
            Some(&VolumeDefect::LooseFace { face: finned.face_of_polygon(0).0 })
        );
    }

    /// The slow test: the link of each vertex as a mesh of triangles, asked whether it is a sphere or a disk.
    fn slow_singular_vertices(vertex_count: u32, cells: &BTreeSet<BTreeSet<u32>>) -> Vec<VertexId> {
        let mut singular = Vec::new();
        for v in 0..vertex_count {
            let link: Vec<Vec<u32>> = cells
                .iter()
                .filter(|cell| cell.contains(&v))
                .map(|cell| cell.iter().copied().filter(|&w| w != v).collect())
                .collect();
            if link.is_empty() {
                continue;
            }
            let names: BTreeMap<u32, u32> =
                link.iter().flatten().copied().collect::<BTreeSet<u32>>().into_iter().zip(0..).collect();
            let polygons =
                RaggedArray::from_lists(link.iter().map(|t| t.iter().map(|w| names[w]).collect::<Vec<_>>()));
            let survey = PolygonMesh::new(names.len(), polygons, &[]).unwrap().survey();
            let name = if survey.verdict().is_manifold() { survey.name() } else { None };
            if !matches!(name.as_deref(), Some("sphere" | "disk")) {
                singular.push(VertexId::from_u32(v));
            }
        }
        singular
    }

    proptest! {
        #[test]
        fn singular_vertices_are_those_whose_link_is_no_sphere_or_disk(
            picked in prop::collection::vec(Just((0u32..7).collect::<Vec<_>>()).prop_shuffle(), 0..9),
            sphere in prop::collection::vec(any::<bool>(), 5),
        ) {
            // Random tetrahedra, and some of those of a sphere, so that manifolds come up as well.
            let mut cells: BTreeSet<BTreeSet<u32>> = picked.iter().map(|v| v[..4].iter().copied().collect()).collect();
            let random = cells.len().is_multiple_of(2);
            if !random {
                cells.clear();
            }
            cells.extend(three_sphere().iter().zip(&sphere).filter(|(_, keep)| **keep).map(|(c, _)| c.iter().copied().collect::<BTreeSet<u32>>()));
            let listed: Vec<[u32; 4]> =
                cells.iter().map(|c| <[u32; 4]>::try_from(c.iter().copied().collect::<Vec<_>>()).unwrap()).collect();
            let verdict = tetrahedra(7, &listed).manifold_verdict();
            let slow = slow_singular_vertices(7, &cells);
            prop_assert_eq!(verdict.non_manifold_vertices(), &slow[..]);
            prop_assert_eq!(verdict.is_manifold(), slow.is_empty());
        }
    }
}
