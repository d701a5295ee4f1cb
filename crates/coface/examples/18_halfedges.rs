//! Guide 18: halfedges: walks around faces and vertices, edits that can be undone, cutting and gluing.
//!
//! Run with `cargo run -p coface --example 18_halfedges`.

use coface::algebra::RaggedArray;
use coface::complexes::surface::HalfedgeMesh;
use coface::{EdgeId, FaceId, HalfedgeId, VertexId, homology};

fn main() -> Result<(), coface::Error> {
    // A square of two triangles. The rim is a face too, an outer one, so that each halfedge has a twin.
    let mut square = HalfedgeMesh::from_polygons(4, &RaggedArray::from_lists([[0, 1, 2], [0, 2, 3]]))?;
    assert_eq!((square.f_vector(), square.outer_face_count()), (vec![4, 5, 2], 1));
    assert_eq!(square.halfedge_count(), 10);
    for number in 0..square.halfedge_count() {
        // The laws of the data structure: twin undoes itself, previous undoes next, and both run from vertex to vertex.
        let halfedge = HalfedgeId::new(number);
        assert_eq!(square.twin(square.twin(halfedge)), halfedge);
        assert_ne!(square.twin(halfedge), halfedge);
        assert_eq!(square.previous(square.next(halfedge)), halfedge);
        assert_eq!(square.source(square.next(halfedge)), square.target(halfedge));
        assert_eq!(square.source(square.twin(halfedge)), square.target(halfedge));
    }
    // Around a face by next.
    let first = square.face_halfedge(FaceId::new(0));
    let around = [first, square.next(first), square.next(square.next(first))];
    assert_eq!(square.next(around[2]), first);
    assert_eq!(around.map(|halfedge| square.face(halfedge)), [FaceId::new(0); 3]);
    assert_eq!([0, 1, 2, 3].map(|v| square.degree(VertexId::new(v))), [3, 2, 3, 2]);

    // A flip turns the diagonal; flipping back brings back what was there, with the same numbers.
    let given = square.clone();
    let diagonal =
        (0..5).map(EdgeId::new).find(|&edge| !square.is_boundary_edge(edge)).expect("there is one");
    square.flip_edge(diagonal)?;
    assert_eq!([0, 1, 2, 3].map(|v| square.degree(VertexId::new(v))), [2, 3, 2, 3]);
    square.flip_edge_back(diagonal)?;
    assert_eq!(square.edge_ends(), given.edge_ends());

    // Euler operators come in pairs. Each keeps V - E + F: a vertex on an edge, an edge across a face, a vertex within a face.
    let split = square.split_edge(diagonal)?;
    assert_eq!(square.f_vector(), [5, 6, 2]);
    square.remove_vertex(split.vertex())?;
    assert_eq!(square.f_vector(), given.f_vector());
    square.poke_face(FaceId::new(0))?;
    assert_eq!((square.f_vector(), square.euler_characteristic()), (vec![5, 8, 4], 1));
    square.check()?;

    // A collapse that would change the topology is refused with its reason. No edge of a tetrahedron can be shrunk to a vertex: two triangles with
    // the same corners would be left.
    let sides = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let mut tetrahedron = HalfedgeMesh::from_polygons(4, &RaggedArray::from_lists(sides))?;
    assert!(tetrahedron.collapse_obstacle(EdgeId::new(0)).is_some());
    assert!(tetrahedron.collapse_edge_simplicially(EdgeId::new(0)).is_err());
    assert_eq!((tetrahedron.f_vector(), tetrahedron.genus()), (vec![4, 6, 4], 0));

    // Cutting: the torus of one square, cut along both of its edges, is the square again.
    let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    assert_eq!(homology(&torus.chain_complex()?).betti_numbers(), [1, 2, 1]);
    let cut = torus.slice_edges(&[EdgeId::new(0), EdgeId::new(1)])?;
    assert_eq!(cut.surface().f_vector(), [4, 4, 1]);
    assert!(cut.vertex_sources().iter().all(|source| source.index() == 0));

    // Gluing: two opposite sides of a square make an annulus, with two outer faces.
    let square = HalfedgeMesh::from_polygons(4, &RaggedArray::from_lists([[0, 1, 2, 3]]))?;
    let annulus = square.glue(&[(HalfedgeId::new(0), HalfedgeId::new(4))])?;
    assert_eq!((annulus.surface().f_vector(), annulus.surface().outer_face_count()), (vec![2, 3, 1], 2));
    assert_eq!(annulus.surface().surface().map(|surface| surface.to_string()).as_deref(), Some("annulus"));
    Ok(())
}
