//! Halfedge meshes from 2-skeletons, generalized maps, simplicial complexes and boundary matrices.

use super::super::GeneralizedMap;
use super::mesh::{HalfedgeMesh, NONE};
use crate::simplicial::{FrozenComplex, SimplicialComplex};
use coface_algebra::chains::{ChainComplex, TwoSkeleton};
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, Fault};
use coface_algebra::{RaggedArray, Sign};

impl HalfedgeMesh {
    /// The surface with these vertices, edges and faces, whose rims run counterclockwise. Cells may touch themselves.
    ///
    /// All cells keep their numbers: halfedge 2e goes along edge e and 2e + 1 against it, so a rim is the list of the
    /// halfedges of its face, and the first step the first halfedge. [`Self::two_skeleton`] is the way back. Boundary
    /// loops are filled with outer faces; vertices without an edge stay isolated.
    ///
    /// # Errors
    /// [`ErrorKind::NonManifold`] naming a face without sides, an edge in no face or on more than two sides of faces, a
    /// vertex with several fans of faces, or an edge that is run through twice in the same direction;
    /// [`ErrorKind::TooLarge`] from 2^30 edges on.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// A disk with a slit: its face runs along edge 1 both ways.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = TwoSkeleton::new(2, vec![0, 0, 0, 1], RaggedArray::from_lists([[0, 2, 3]]))?;
    /// let mesh = HalfedgeMesh::from_two_skeleton(&disk)?;
    /// assert_eq!((mesh.f_vector(), mesh.outer_face_count()), (vec![2, 2, 1], 1));
    /// assert_eq!(mesh.two_skeleton()?, disk);
    /// # Ok(()) }
    /// ```
    pub fn from_two_skeleton(skeleton: &TwoSkeleton) -> Result<Self, Error> {
        let count = 2 * skeleton.edge_count();
        super::mesh::check_limit(count)?;
        let (mut next, mut face) = (vec![NONE; count], vec![NONE; count]);
        let mut face_halfedge = Vec::with_capacity(skeleton.face_count());
        for (number, rim) in skeleton.faces().iter().enumerate() {
            let (Some(&first), Some(&last)) = (rim.first(), rim.last()) else {
                return Err(no_mesh(skeleton));
            };
            face_halfedge.push(first);
            let mut before = last;
            for &h in rim {
                if face[h as usize] != NONE {
                    return Err(no_mesh(skeleton));
                }
                face[h as usize] = number as u32;
                next[before as usize] = h;
                before = h;
            }
        }
        let outer: Vec<u32> = (0..).zip(&face).filter(|&(_, &face)| face == NONE).map(|(h, _)| h).collect();
        if outer.iter().any(|&h| face[(h ^ 1) as usize] == NONE) {
            return Err(no_mesh(skeleton));
        }
        Self::filled(
            skeleton.vertex_count(),
            next,
            skeleton.edge_ends().to_vec(),
            face,
            face_halfedge,
            &outer,
        )
        .map_err(|_| no_mesh(skeleton))
    }

    /// The surface of a simplicial complex of dimension 2, its triangles turned so that all agree.
    ///
    /// Vertices, edges and triangles have the numbers of [`FrozenComplex::simplex`], edges go from their smaller to their
    /// larger vertex, and the first triangle of each component runs in the rising order of its vertices. The first
    /// halfedge of each face leaves its smallest vertex. Isolated vertices are welcome.
    ///
    /// # Errors
    /// [`ErrorKind::NonManifold`] if the complex is no orientable surface: see [`GeneralizedMap::new`] and
    /// [`GeneralizedMap::halfedges`], and for a simplex of dimension 3.
    ///
    /// # Complexity
    /// Near-linear.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sphere = HalfedgeMesh::from_frozen_complex(&known_spaces::simplex_boundary(2)?.freeze())?;
    /// assert_eq!(sphere.f_vector(), [4, 6, 4]);
    /// let plane = known_spaces::projective_plane()?;
    /// assert!(HalfedgeMesh::from_simplicial_complex(&plane).is_err());
    /// # Ok(()) }
    /// ```
    pub fn from_frozen_complex(complex: &FrozenComplex) -> Result<Self, Error> {
        if complex.simplex_count(3) > 0 {
            return Err(Error::new(
                ErrorKind::NonManifold,
                format!("simplex {:?} has dimension 3; a surface has none", complex.simplex(3, 0)),
            )
            .with_cure("take the boundary or the 2-skeleton first"));
        }
        GeneralizedMap::new(complex.two_skeleton()?)?.halfedges()
    }

    /// The surface of a simplicial complex of dimension 2: that of [`SimplicialComplex::freeze`].
    ///
    /// # Errors
    /// As [`Self::from_frozen_complex`].
    pub fn from_simplicial_complex(complex: &SimplicialComplex) -> Result<Self, Error> {
        Self::from_frozen_complex(&complex.freeze())
    }

    /// The surface whose boundary matrices are those of a chain complex of dimension 2: vertices by edges, and edges by
    /// faces. Faces are turned so that all agree.
    ///
    /// Cells keep their numbers. Edges go from -1 to 1; the rim of a face follows the signs of its column, from its first
    /// edge on. Matrices do not show where a cell touches itself, as those entries cancel; such cells are refused as far
    /// as they can be told. A 2-skeleton has what is missing: [`Self::from_two_skeleton`].
    ///
    /// # Errors
    /// [`ErrorKind::NonManifold`] naming an edge that has not two ends, or a face whose edges are not one loop through
    /// distinct vertices; what [`GeneralizedMap::new`] and [`GeneralizedMap::halfedges`] name; and cells of degree 3.
    ///
    /// # Complexity
    /// Linear but for the sides of each face, which are sorted.
    ///
    /// # Examples
    /// Two disks on a circle of two edges:
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (0, 1, 1)])?;
    /// let faces = SparseMatrix::from_entries(2, 2, [(0, 0, 1), (1, 0, 1), (0, 1, 1), (1, 1, 1)])?;
    /// let sphere = HalfedgeMesh::from_chain_complex(&ChainComplex::new(vec![edges, faces])?)?;
    /// assert_eq!((sphere.f_vector(), sphere.genus()), (vec![2, 2, 2], 0));
    /// # Ok(()) }
    /// ```
    pub fn from_chain_complex(complex: &ChainComplex) -> Result<Self, Error> {
        GeneralizedMap::new(skeleton_of(complex)?)?.halfedges()
    }
}

impl GeneralizedMap {
    /// The surface as a halfedge mesh, with the faces turned over that have a minus in [`Self::orientation`]. All cells
    /// keep their numbers; a face that is turned starts at the same vertex.
    ///
    /// # Errors
    /// [`ErrorKind::NonManifold`] if a component is not orientable, naming an edge across which its faces cannot agree;
    /// [`ErrorKind::TooLarge`] from 2^30 edges on.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// use coface_complexes::surface::GeneralizedMap;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two disks on a circle, both in its direction: the second is turned.
    /// let disks = TwoSkeleton::new(1, vec![0, 0], RaggedArray::from_lists([[0], [0]]))?;
    /// let sphere = GeneralizedMap::new(disks)?.halfedges()?;
    /// assert_eq!(sphere.two_skeleton()?.faces().items(), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn halfedges(&self) -> Result<HalfedgeMesh, Error> {
        let orientation = self.orientation();
        if let Some(edge) = orientation.conflicts().iter().flatten().next() {
            let [a, b] = self.skeleton().edge(*edge);
            return Err(Error::new(
                ErrorKind::NonManifold,
                format!(
                    "the surface is not orientable: its faces cannot agree across edge {edge} = {{{a}, {b}}}"
                ),
            )
            .with_cure("keep it as a generalized map, cut it open, or take its orientation double cover"));
        }
        if orientation.signs().iter().all(|&sign| sign == Sign::Plus) {
            return HalfedgeMesh::from_two_skeleton(self.skeleton());
        }
        let mut rims = self.skeleton().faces().clone();
        for (face, _) in orientation.signs().iter().enumerate().filter(|(_, sign)| **sign == Sign::Minus) {
            let sides = rims.start(face)..rims.start(face + 1);
            let rim = &mut rims.items_mut()[sides];
            rim.reverse();
            rim.iter_mut().for_each(|step| *step ^= 1);
        }
        let turned =
            TwoSkeleton::new(self.skeleton().vertex_count(), self.skeleton().edge_ends().to_vec(), rims)
                .expect("a closed path backwards is a closed path");
        HalfedgeMesh::from_two_skeleton(&turned)
    }
}

/// Why a 2-skeleton is no halfedge mesh.
#[cold]
fn no_mesh(skeleton: &TwoSkeleton) -> Error {
    let map = match GeneralizedMap::new(skeleton.clone()) {
        Ok(map) => map,
        Err(error) => return error,
    };
    let side = map.sides().find(|&side| !map.agrees(side)).expect("the faces are no coherent surface");
    let mate = map.mate(side).expect("a side on the boundary agrees");
    let (edge, faces) = (map.edge(side), [map.face(side), map.face(mate)]);
    let [a, b] = skeleton.edge(edge);
    let both = if faces[0] == faces[1] {
        format!("face {} runs twice", faces[0])
    } else {
        format!("faces {} and {} both run", faces[0], faces[1])
    };
    Error::new(
        ErrorKind::NonManifold,
        format!(
            "{both} through edge {edge} = {{{a}, {b}}} in the same direction, so they do not agree there"
        ),
    )
    .with_fault(Fault::IncoherentFaces { edge: [a, b], faces })
    .with_cure("turn faces around so that all agree, as a generalized map does if it is orientable")
}

/// The 2-skeleton with these boundary matrices.
fn skeleton_of(complex: &ChainComplex) -> Result<TwoSkeleton, Error> {
    let refused = |message: String| {
        Error::new(ErrorKind::NonManifold, message).with_cure(
            "give the complex as a 2-skeleton or as permutations, which show how cells touch themselves",
        )
    };
    if complex.cell_count(3) > 0 {
        return Err(Error::new(
            ErrorKind::NonManifold,
            "the complex has cells of degree 3; a surface has none",
        )
        .with_cure("take its boundary first"));
    }
    let mut ends = Vec::with_capacity(2 * complex.cell_count(1));
    for (edge, column) in
        complex.boundary_matrix(1).into_iter().flat_map(|matrix| matrix.columns()).enumerate()
    {
        match (column.rows(), column.entries()) {
            (&[a, b], &[-1, 1]) => ends.extend([a, b]),
            (&[a, b], &[1, -1]) => ends.extend([b, a]),
            ([], _) => {
                return Err(refused(format!(
                    "edge {} has no ends left in its boundary, as a loop",
                    EdgeId::new(edge)
                )));
            }
            (_, entries) => {
                return Err(refused(format!(
                    "edge {} has the boundary entries {entries:?} instead of 1 and -1",
                    EdgeId::new(edge)
                )));
            }
        }
    }
    let mut rims = RaggedArray::new();
    let mut steps: Vec<(u32, u32)> = Vec::new();
    let mut rim = Vec::new();
    for (face, column) in
        complex.boundary_matrix(2).into_iter().flat_map(|matrix| matrix.columns()).enumerate()
    {
        let face = FaceId::new(face);
        // The steps of the face by the vertices that they leave.
        steps.clear();
        for (edge, entry) in column.iter() {
            let step = match entry {
                1 => 2 * edge as u32,
                -1 => 2 * edge as u32 + 1,
                _ => {
                    return Err(refused(format!(
                        "face {face} runs {} times through edge {}",
                        entry.unsigned_abs(),
                        EdgeId::new(edge)
                    )));
                }
            };
            steps.push((ends[step as usize], step));
        }
        let Some(&(start, first)) = steps.first() else {
            return Err(refused(format!("face {face} has no edge left in its boundary")));
        };
        steps.sort_unstable();
        if let Some(pair) = steps.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(refused(format!(
                "the boundary of face {face} passes vertex v{} several times, in an unknown order",
                pair[0].0
            )));
        }
        rim.clear();
        let mut step = first;
        loop {
            rim.push(step);
            let at = ends[(step ^ 1) as usize];
            if at == start {
                break;
            }
            let found = steps.binary_search_by_key(&at, |&(vertex, _)| vertex);
            step = steps[found.expect("a boundary leaves each vertex as often as it enters it")].1;
        }
        if rim.len() < steps.len() {
            return Err(refused(format!("the boundary of face {face} is several loops")));
        }
        rims.push(&rim);
    }
    TwoSkeleton::new(complex.cell_count(0), ends, rims)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::known_spaces;
    use coface_algebra::HalfedgeId;
    use proptest::prelude::*;

    /// Orientable surfaces from the table of known spaces, by their names.
    fn surfaces() -> Vec<(&'static str, SimplicialComplex)> {
        vec![
            ("sphere", known_spaces::simplex_boundary(2).unwrap()),
            ("sphere", known_spaces::cross_polytope_boundary(2).unwrap()),
            ("torus", known_spaces::cyclic_torus(2).unwrap()),
            ("torus", known_spaces::torus_grid(&[4, 5]).unwrap()),
            ("disk", known_spaces::simplex(2).unwrap()),
            ("annulus", known_spaces::triangle_strip(6).unwrap()),
        ]
    }

    #[test]
    fn simplicial_surfaces_are_turned_and_keep_their_numbers() {
        for (name, complex) in surfaces() {
            let frozen = complex.freeze();
            let mesh = HalfedgeMesh::from_simplicial_complex(&complex).unwrap();
            mesh.check().unwrap();
            assert_eq!(mesh.surface().unwrap().to_string(), name);
            for edge in (0..mesh.edge_count()).map(EdgeId::new) {
                let h = mesh.edge_halfedge(edge);
                let ends = [mesh.source(h), mesh.target(h)].map(|v| frozen.numbers(0, v.index())[0]);
                assert_eq!(ends, frozen.numbers(1, edge.index()));
            }
            for face in (0..mesh.face_count()).map(FaceId::new) {
                let mut around: Vec<u32> =
                    mesh.face_vertices(face).map(|v| frozen.numbers(0, v.index())[0]).collect();
                assert_eq!(around[0], frozen.numbers(2, face.index())[0]);
                around.sort_unstable();
                assert_eq!(around, frozen.numbers(2, face.index()));
            }
            // Through boundary matrices, and through the mesh's own.
            let again = HalfedgeMesh::from_chain_complex(&frozen.chain_complex().unwrap()).unwrap();
            assert_eq!(again.chain_complex().unwrap().f_vector(), mesh.f_vector());
            assert_eq!(again.surface(), mesh.surface());
            let own = HalfedgeMesh::from_chain_complex(&mesh.chain_complex().unwrap()).unwrap();
            own.check().unwrap();
            assert_eq!(own.chain_complex(), mesh.chain_complex());
        }
    }

    #[test]
    fn complexes_that_are_no_orientable_surface_are_refused() {
        let fault = |complex: SimplicialComplex| {
            HalfedgeMesh::from_simplicial_complex(&complex).unwrap_err().message().to_owned()
        };
        assert!(
            fault(known_spaces::projective_plane().unwrap()).starts_with("the surface is not orientable")
        );
        assert!(fault(known_spaces::triangle_strip(5).unwrap()).starts_with("the surface is not orientable"));
        assert!(fault(known_spaces::simplex(3).unwrap()).contains("has dimension 3"));
        assert!(fault(known_spaces::circle(4).unwrap()).ends_with("lies in no face"));
        assert!(fault(known_spaces::book(3).unwrap()).contains("is on 3 sides of faces"));
        let wedge = SimplicialComplex::from_facets([[0, 1, 2], [0, 3, 4]]).unwrap();
        assert_eq!(fault(wedge), "2 fans of faces meet at vertex v0 only: f0 | f1");
        let points = SimplicialComplex::from_facets([[3], [7]]).unwrap();
        assert_eq!(HalfedgeMesh::from_simplicial_complex(&points).unwrap().f_vector(), [2, 0, 0]);
        let empty = HalfedgeMesh::from_simplicial_complex(&SimplicialComplex::new()).unwrap();
        assert_eq!(empty.f_vector(), [0; 3]);
    }

    #[test]
    fn skeletons_that_are_no_mesh_are_refused_with_the_place() {
        let fault = |vertex_count, ends: &[u32], rims: &[&[u32]]| {
            let skeleton =
                TwoSkeleton::new(vertex_count, ends.to_vec(), RaggedArray::from_lists(rims)).unwrap();
            HalfedgeMesh::from_two_skeleton(&skeleton).unwrap_err().message().to_owned()
        };
        assert_eq!(
            fault(1, &[0, 0], &[&[0, 0]]),
            "face f0 runs twice through edge e0 = {v0, v0} in the same direction, so they do not agree there"
        );
        assert_eq!(
            fault(1, &[0, 0], &[&[0], &[0]]),
            "faces f0 and f1 both run through edge e0 = {v0, v0} in the same direction, so they do not agree there"
        );
        assert_eq!(
            fault(1, &[0, 0], &[&[0], &[1, 0]]),
            "edge e0 = {v0, v0} is on 3 sides of faces: f0, f1, f1"
        );
        assert_eq!(fault(1, &[0, 0], &[&[]]), "face f0 has no sides");
        assert_eq!(fault(2, &[0, 0, 0, 1], &[&[0]]), "edge e1 = {v0, v1} lies in no face");
        assert_eq!(fault(1, &[0, 0, 0, 0], &[&[0], &[2]]), "2 fans of faces meet at vertex v0 only: f0 | f1");
    }

    #[test]
    fn matrices_of_cells_that_touch_themselves_are_refused_with_the_cell() {
        let fault = |next: &[u32]| {
            let mesh = HalfedgeMesh::from_next(next.to_vec()).unwrap();
            HalfedgeMesh::from_chain_complex(&mesh.chain_complex().unwrap()).unwrap_err().message().to_owned()
        };
        assert_eq!(fault(&[0, 1]), "edge e0 has no ends left in its boundary, as a loop");
        assert_eq!(fault(&[1, 0]), "face f0 has no edge left in its boundary");
        // A square with two opposite corners at one vertex: the order around it is lost.
        let pinched = TwoSkeleton::new(
            3,
            vec![0, 1, 1, 0, 0, 2, 2, 0],
            RaggedArray::from_lists([&[0u32, 2, 4, 6][..]]),
        )
        .unwrap();
        let error = HalfedgeMesh::from_chain_complex(&pinched.chain_complex().unwrap()).unwrap_err();
        assert!(error.message().starts_with("the boundary of face f0 passes vertex v0 several times"));
        // An annulus as one face.
        let ring = TwoSkeleton::new(
            4,
            vec![0, 1, 1, 0, 2, 3, 3, 2, 0, 2],
            RaggedArray::from_lists([&[0u32, 2, 8, 4, 6, 9][..]]),
        )
        .unwrap();
        let error = HalfedgeMesh::from_chain_complex(&ring.chain_complex().unwrap()).unwrap_err();
        assert_eq!(error.message(), "the boundary of face f0 is several loops");
        // The skeleton itself is the ring, opened nowhere.
        assert_eq!(HalfedgeMesh::from_two_skeleton(&ring).unwrap().surface().unwrap().to_string(), "annulus");
    }

    proptest! {
        #[test]
        fn a_skeleton_and_its_mesh_are_the_same(
            next in Just((0u32..16).collect::<Vec<_>>()).prop_shuffle(),
            outer in 0usize..16,
        ) {
            let mesh = HalfedgeMesh::from_next(next).unwrap();
            let face = FaceId::new(outer % mesh.face_count());
            let mesh = mesh.clone().with_outer_faces(&[face]).unwrap_or(mesh);
            let skeleton = mesh.two_skeleton().unwrap();
            let again = HalfedgeMesh::from_two_skeleton(&skeleton).unwrap();
            again.check().unwrap();
            prop_assert_eq!(&again.two_skeleton().unwrap(), &skeleton);
            // Only first halfedges may differ: those of vertices, and of outer faces.
            prop_assert_eq!((&again.next, &again.source, &again.face), (&mesh.next, &mesh.source, &mesh.face));
            let map = GeneralizedMap::new(skeleton).unwrap();
            prop_assert_eq!(map.halfedges().unwrap(), again);
            let sides: Vec<HalfedgeId> = map.sides().map(|side| HalfedgeId::from_u32(map.step(side))).collect();
            prop_assert_eq!(sides.len(), mesh.halfedges().filter(|&h| !mesh.is_outer_halfedge(h)).count());
        }
    }
}
