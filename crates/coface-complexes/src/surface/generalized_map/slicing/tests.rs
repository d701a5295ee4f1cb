use super::*;
use crate::surface::{HalfedgeMesh, PolygonMesh};
use coface_algebra::FaceId;
use coface_algebra::{RaggedArray, Sign, UnionFind};
use proptest::prelude::*;

/// Polygons of these sizes, sides glued in pairs in this order, every other one as it runs; some stay on the boundary.
fn random_maps() -> impl Strategy<Value = GeneralizedMap> {
    prop::collection::vec(1u32..6, 1..8)
        .prop_flat_map(|sizes| {
            let count: u32 = sizes.iter().sum();
            (Just(sizes), Just((0..count).collect::<Vec<_>>()).prop_shuffle(), 0..=count, any::<u64>())
        })
        .prop_map(|(sizes, order, open, turned)| {
            let count = order.len() as u32;
            let other_end = (0..2 * count).map(|flag| flag ^ 1).collect();
            let mut corner = vec![0; 2 * order.len()];
            let mut start = 0;
            for size in sizes {
                for i in 0..size {
                    let (end, next) = (2 * (start + i) + 1, 2 * (start + (i + 1) % size));
                    (corner[end as usize], corner[next as usize]) = (next, end);
                }
                start += size;
            }
            let mut mate: Vec<u32> = (0..2 * count).collect();
            for (i, pair) in order[..(count - open.min(count / 2)) as usize].chunks_exact(2).enumerate() {
                for end in [0, 1] {
                    let other = end ^ (turned >> (i % 64) & 1) as u32;
                    let (a, b) = (2 * pair[0] + end, 2 * pair[1] + other);
                    (mate[a as usize], mate[b as usize]) = (b, a);
                }
            }
            GeneralizedMap::from_involutions(&[other_end, corner, mate]).unwrap().0
        })
}

/// A path of edges inside through distinct vertices: a walk until it comes to a vertex again, then the part between, or
/// what is before it.
fn some_path(map: &GeneralizedMap, start: usize, choices: &[u8]) -> Vec<u32> {
    let steps_from = |vertex: u32| -> Vec<u32> {
        (0..2 * map.skeleton().edge_count() as u32)
            .filter(|&step| map.skeleton().edge_ends()[step as usize] == vertex)
            .filter(|&step| map.sides().any(|s| map.edge(s).to_u32() == step >> 1 && map.mate(s).is_some()))
            .collect()
    };
    let mut at = (start % map.skeleton().vertex_count().max(1)) as u32;
    let (mut path, mut visited) = (Vec::new(), vec![at]);
    for &choice in choices {
        let used = |step: &u32| path.iter().all(|other: &u32| other >> 1 != step >> 1);
        let steps: Vec<u32> = steps_from(at).into_iter().filter(used).collect();
        let Some(&step) = steps.get(choice as usize % steps.len().max(1)) else { break };
        path.push(step);
        at = map.skeleton().edge_ends()[(step ^ 1) as usize];
        if let Some(first) = visited.iter().position(|&vertex| vertex == at) {
            return path[first..].to_vec();
        }
        visited.push(at);
    }
    path
}

fn check_slice(map: &GeneralizedMap, slice: &Slice<GeneralizedMap>) {
    let cut = slice.surface();
    assert_eq!(cut.side_count(), map.side_count());
    for side in map.sides() {
        assert_eq!(cut.face(side), map.face(side));
        assert_eq!(slice.edge_sources()[cut.edge(side)], map.edge(side));
        assert_eq!(cut.step(side) & 1, map.step(side) & 1);
        assert_eq!(slice.vertex_sources()[cut.source(side)], map.source(side));
        assert_eq!(slice.vertex_sources()[cut.target(side)], map.target(side));
    }
    for (&left, &right) in slice.left().iter().zip(slice.right()) {
        assert_eq!(map.mate(left), Some(right));
        assert!(cut.mate(left).is_none() && cut.mate(right).is_none());
    }
    // Nothing but the cut has changed.
    let (v, e, f) = (cut.vertex_count(), cut.edge_count(), cut.face_count());
    assert_eq!((v, e), (slice.vertex_sources().len(), slice.edge_sources().len()));
    assert_eq!((e, f), (map.f_vector()[1] + slice.left().len(), map.f_vector()[2]));
    for (i, &source) in slice.vertex_sources().iter().enumerate().take(map.f_vector()[0]) {
        assert_eq!(source.index(), i);
    }
    let pairs: Vec<(HalfedgeId, HalfedgeId, Sign)> = slice
        .left()
        .iter()
        .zip(slice.right())
        .map(|(&left, &right)| (left, right, if map.agrees(left) { Sign::Minus } else { Sign::Plus }))
        .collect();
    let glued = cut.glue(&pairs).unwrap();
    assert_eq!(glued.surface(), map);
    for (copy, &source) in slice.vertex_sources().iter().enumerate() {
        assert_eq!(glued.vertex_images()[VertexId::new(copy)], source);
    }
    for (copy, &source) in slice.edge_sources().iter().enumerate() {
        assert_eq!(glued.edge_images()[EdgeId::new(copy)], (source, Sign::Plus));
    }
}

fn euler_characteristic(map: &GeneralizedMap) -> i64 {
    let (v, e, f) = (map.vertex_count(), map.edge_count(), map.face_count());
    v as i64 - e as i64 + f as i64
}

proptest! {
    #[test]
    fn slices_along_sets_glue_back(map in random_maps(), chosen in any::<u64>()) {
        let edges: Vec<EdgeId> =
            (0..map.skeleton().edge_count()).filter(|&e| chosen >> (e % 64) & 1 == 1).map(EdgeId::new).collect();
        let slice = map.slice_edges(&edges).unwrap();
        check_slice(&map, &slice);
        prop_assert_eq!(slice.path_kind(), None);
        // Again along the same edges: they are on the boundary now.
        let again = slice.surface().slice_edges(&edges).unwrap().into_surface();
        prop_assert_eq!(&again, slice.surface());
    }

    /// What a spanning forest of the faces does not cross is a cut graph: the rest is disks.
    #[test]
    fn cut_graphs_leave_disks(map in random_maps()) {
        let mut forest = UnionFind::new(map.f_vector()[2]);
        let mut crossed = Vec::new();
        for side in map.sides() {
            if let Some(mate) = map.mate(side)
                && forest.unite(map.face(side).to_u32(), map.face(mate).to_u32())
            {
                crossed.push(map.edge(side));
            }
        }
        let edges: Vec<EdgeId> =
            (0..map.skeleton().edge_count()).map(EdgeId::new).filter(|e| !crossed.contains(e)).collect();
        let slice = map.slice_edges(&edges).unwrap();
        check_slice(&map, &slice);
        let domains = slice.surface().surfaces();
        prop_assert_eq!(domains.len(), map.surfaces().len());
        // A sphere with one vertex has nothing to be cut.
        prop_assert!(domains.iter().all(|domain| ["disk", "sphere"].contains(&&*domain.to_string())));
    }

    #[test]
    fn paths_open_as_many_loops_as_they_should(
        map in random_maps(), start in any::<usize>(), choices in prop::collection::vec(any::<u8>(), 1..8),
    ) {
        let path = some_path(&map, start, &choices);
        if path.is_empty() {
            return Ok(());
        }
        let slice = map.slice_path(&path).unwrap();
        check_slice(&map, &slice);
        let cut = slice.surface();
        let edges: Vec<EdgeId> = path.iter().map(|&step| EdgeId::from_u32(step >> 1)).collect();
        let by_set = map.slice_edges(&edges).unwrap().into_surface();
        prop_assert_eq!(&by_set, cut);
        prop_assert_eq!(slice.left().iter().map(|&side| map.edge(side)).collect::<Vec<_>>(), edges);
        let orientation = map.orientation();
        for (&side, &step) in slice.left().iter().zip(&path) {
            let is_plus = orientation.signs()[map.face(side).index()] == Sign::Plus;
            let is_oriented = orientation.conflicts()[orientation.component(map.face(side))].is_none();
            prop_assert!(!is_oriented || (map.step(side) == step) == is_plus);
        }
        prop_assert_eq!(map.slice_cycle(&path).is_ok(), slice.path_kind() == Some(PathKind::TwoSided));
        let is_boundary = |vertex: u32| map.sides().any(|side| {
            map.mate(side).is_none() && [map.source(side), map.target(side)].iter().any(|v| v.to_u32() == vertex)
        });
        let ends = map.skeleton().edge_ends();
        if path.iter().any(|&step| is_boundary(ends[step as usize]) || is_boundary(ends[(step ^ 1) as usize])) {
            return Ok(());
        }
        let opened = cut.boundary_loops().len() - map.boundary_loops().len();
        let change = euler_characteristic(cut) - euler_characteristic(&map);
        let expected = match slice.path_kind().unwrap() {
            PathKind::Open => (1, -1),
            PathKind::TwoSided => (2, 0),
            PathKind::OneSided => (1, 0),
        };
        prop_assert_eq!((opened, change), expected);
        // The left sides follow one another, and so do the right ones.
        for sides in [slice.left(), slice.right()] {
            for (i, pair) in sides.windows(2).enumerate() {
                let end = if map.step(pair[0]) == path[i] { cut.target(pair[0]) } else { cut.source(pair[0]) };
                let start = if map.step(pair[1]) == path[i + 1] { cut.source(pair[1]) } else { cut.target(pair[1]) };
                prop_assert_eq!(end, start);
            }
        }
    }

    #[test]
    fn halfedge_meshes_are_sliced_and_glued(
        next in (1u32..12).prop_flat_map(|edges| Just((0..2 * edges).collect::<Vec<_>>()).prop_shuffle()),
        start in any::<usize>(),
        choices in prop::collection::vec(any::<u8>(), 1..8),
        (chosen, hole) in any::<(u32, usize)>(),
    ) {
        let mut mesh = HalfedgeMesh::from_next(next).unwrap();
        let hole = FaceId::new(hole % (2 * mesh.face_count()));
        // Where one face may be outer it is; then it is numbered anew as after every cut.
        mesh = mesh.clone().with_outer_faces(&[hole]).unwrap_or(mesh);
        mesh = HalfedgeMesh::from_two_skeleton(&mesh.two_skeleton().unwrap()).unwrap();
        let map = GeneralizedMap::new(mesh.two_skeleton().unwrap()).unwrap();
        let edges: Vec<EdgeId> = (0..mesh.edge_count()).filter(|&e| chosen >> e & 1 == 1).map(EdgeId::new).collect();
        let path: Vec<HalfedgeId> =
            some_path(&map, start, &choices).into_iter().map(HalfedgeId::from_u32).collect();
        let mut slices = vec![mesh.slice_edges(&edges).unwrap()];
        if !path.is_empty() {
            slices.push(mesh.slice_path(&path).unwrap());
        }
        for slice in slices {
            let cut = slice.surface();
            cut.check().unwrap();
            for (&left, &right) in slice.left().iter().zip(slice.right()) {
                prop_assert!(cut.is_outer_halfedge(cut.twin(left)) && cut.is_outer_halfedge(cut.twin(right)));
                prop_assert!(slice.path_kind().is_some() || left.to_u32() % 2 == 0);
            }
            if slice.path_kind().is_some() {
                let sources = slice.edge_sources();
                for (&left, &h) in slice.left().iter().zip(&path) {
                    prop_assert_eq!((sources[cut.edge(left)], left.to_u32() % 2), (mesh.edge(h), h.to_u32() % 2));
                    prop_assert_eq!(cut.face(left), mesh.face(h));
                }
                if mesh.is_closed() {
                    let zipped = cut.glue_arcs(slice.left()[0], slice.right()[0], path.len()).unwrap();
                    prop_assert_eq!(zipped.surface(), &mesh);
                }
                prop_assert_eq!(slice.path_kind() == Some(PathKind::TwoSided), mesh.slice_cycle(&path).is_ok());
                prop_assert!(slice.path_kind() != Some(PathKind::OneSided));
            }
            let pairs: Vec<_> = slice.left().iter().copied().zip(slice.right().iter().copied()).collect();
            let glued = cut.glue(&pairs).unwrap();
            glued.surface().check().unwrap();
            prop_assert_eq!(glued.surface(), &mesh);
        }
    }
}

#[test]
fn what_is_no_path_to_cut_names_the_step() {
    // A strip of two squares: vertices 0 1 2 above 3 4 5; edge 4 = {1, 4} is the only one inside.
    let strip = PolygonMesh::new(6, RaggedArray::from_lists([[0, 1, 4, 3], [1, 2, 5, 4]]), &[]).unwrap();
    let edge = |a, b| strip.edge_between(VertexId::new(a), VertexId::new(b)).unwrap().to_u32();
    let inside = edge(1, 4);
    let map = GeneralizedMap::new(strip.two_skeleton().unwrap()).unwrap();
    let fault = |steps: &[u32]| map.slice_path(steps).unwrap_err().message().to_owned();
    let [top, other] = [(0, 1), (1, 2)].map(|(a, b)| edge(a, b));
    assert_eq!(fault(&[]), "a path to cut along needs an edge, and this one has no step");
    assert_eq!(
        fault(&[2 * top, 2 * other, 2 * inside]),
        "the steps are no path: step 3 starts at v1, but step 2 ends at v2"
    );
    assert_eq!(
        fault(&[2 * inside, 2 * inside + 1]),
        "steps 1 and 2 run along the same edge, which joins v1 and v4"
    );
    assert_eq!(
        fault(&[2 * top, 2 * inside]),
        "step 1 from v0 to v1 runs along the boundary: there is nothing to cut"
    );
    assert_eq!(fault(&[2 * inside, 99]), "there is no edge e49; the surface has 7 edges");
    assert_eq!(map.slice_edges(&[EdgeId::new(7)]).unwrap_err().kind(), ErrorKind::NotInComplex);
    let cut = map.slice_path(&[2 * inside]).unwrap();
    assert_eq!(cut.surface().surfaces().len(), 2, "from boundary to boundary: two pieces");
    assert!(map.slice_cycle(&[2 * inside]).unwrap_err().message().contains("starts at v1 and ends at v4"));
}

#[test]
fn a_path_that_meets_itself_is_refused() {
    // A loop at each of the ends of an edge, and the edge twice on one disk: a figure like spectacles.
    let spectacles = TwoSkeleton::new(
        2,
        vec![0, 0, 0, 1, 1, 1],
        RaggedArray::from_lists([vec![0, 2, 4, 3], vec![1], vec![5]]),
    )
    .unwrap();
    let map = GeneralizedMap::new(spectacles).unwrap();
    assert_eq!(
        map.slice_path(&[0, 2]).unwrap_err().message(),
        "the path comes through v0 twice, before step 1 and after step 1"
    );
    assert_eq!(map.slice_path(&[4]).unwrap().path_kind(), Some(PathKind::TwoSided));
    assert_eq!(map.slice_edges(&[0, 1, 2].map(EdgeId::new)).unwrap().surface().surfaces().len(), 3);
}

#[test]
fn one_sided_cycles_are_told() {
    let triangles = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];
    let band = PolygonMesh::new(5, RaggedArray::from_lists(triangles), &[]).unwrap();
    let map = GeneralizedMap::new(band.two_skeleton().unwrap()).unwrap();
    // The inner edges 12, 23, 34, 40, 01 in order; all vertices lie on the boundary.
    let steps: Vec<u32> = [(1, 2), (2, 3), (3, 4), (4, 0), (0, 1)]
        .iter()
        .map(|&(a, b)| {
            2 * band.edge_between(VertexId::new(a), VertexId::new(b)).unwrap().to_u32() + u32::from(a > b)
        })
        .collect();
    let slice = map.slice_path(&steps).unwrap();
    assert_eq!(slice.path_kind(), Some(PathKind::OneSided));
    check_slice(&map, &slice);
    let error = map.slice_cycle(&steps).unwrap_err();
    assert_eq!(
        error.message(),
        "the closed path of 5 steps from v1 by v2 is one-sided: its left side comes back as its right side, so cutting along it opens one boundary loop and not two"
    );
}

#[test]
fn what_cannot_be_glued_is_named() {
    let square = HalfedgeMesh::from_polygons(4, &RaggedArray::from_lists([[0, 1, 2], [0, 2, 3]])).unwrap();
    let fault = |first: usize, second: usize| {
        square.glue(&[(HalfedgeId::new(first), HalfedgeId::new(second))]).unwrap_err().message().to_owned()
    };
    assert_eq!(fault(0, 1), "halfedge h1 has outer face f2 on its left, and nothing to be glued there");
    assert_eq!(fault(0, 4), "halfedge h4 is not on the boundary: its twin has face f1");
    assert_eq!(fault(0, 0), "halfedge h0 is to be glued to itself");
    assert_eq!(fault(0, 90), "there is no halfedge h90; the mesh has 10");
    let [a, b] = [0, 2].map(HalfedgeId::new);
    assert!(square.glue_arcs(a, b, 3).unwrap_err().message().contains("is in two pairs"));
    assert!(square.glue_arcs(a, b, 1 << 40).unwrap_err().message().contains("is in two pairs"));
    assert!(square.glue_arcs(a, HalfedgeId::new(3), 2).unwrap_err().message().contains("outer face"));
    assert_eq!(square.glue_arcs(a, b, 0).unwrap().into_surface(), square);
    assert!(square.glue_loops(a, b).unwrap_err().message().contains("on the same boundary loop, around f2"));
    assert!(square.glue_loops(a, HalfedgeId::new(4)).unwrap_err().message().contains("not on the boundary"));
    let apart = RaggedArray::from_lists([vec![0, 1, 2], vec![3, 4, 5, 6]]);
    let pieces = HalfedgeMesh::from_polygons(7, &apart).unwrap();
    assert_eq!(
        pieces.glue_loops(a, HalfedgeId::new(6)).unwrap_err().message(),
        "the boundary loop of h0 has 3 edges and that of h6 has 4"
    );
    let map = GeneralizedMap::new(square.two_skeleton().unwrap()).unwrap();
    let fault = |first: usize, second: usize| {
        let pair = (HalfedgeId::new(first), HalfedgeId::new(second), Sign::Plus);
        map.glue(&[pair]).unwrap_err().message().to_owned()
    };
    assert_eq!(
        fault(2, 0),
        "side h2 of face f0 is not on the boundary: along edge e2 it is glued to side h3"
    );
    assert_eq!(fault(0, 0), "side h0 is to be glued to itself");
    assert_eq!(fault(0, 6), "there is no side h6; the faces have 6 sides");
}

#[test]
fn two_tetrahedra_without_a_face_make_a_bipyramid() {
    let cap = |first: u32| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| first + i);
        [[a, b, d], [b, c, d], [c, a, d]]
    };
    let caps = HalfedgeMesh::from_polygons(8, &RaggedArray::from_lists([cap(0), cap(4)].concat())).unwrap();
    let sides: Vec<HalfedgeId> = caps.outer_faces().flat_map(|outer| caps.boundary_loop(outer)).collect();
    for &second in &sides[3..] {
        let glued = caps.glue_loops(sides[0], second).unwrap();
        glued.surface().check().unwrap();
        assert_eq!((glued.surface().f_vector(), glued.surface().genus()), (vec![5, 9, 6], 0));
        assert!(glued.surface().is_closed());
        let images = glued.vertex_images();
        assert_eq!(images[caps.source(sides[0])], images[caps.target(second)]);
    }
}
