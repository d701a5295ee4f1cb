use super::*;
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::{EdgeId, FaceId, RaggedArray, Sign, VertexId};
use coface_complexes::known_spaces;
use coface_complexes::surface::GeneralizedMap;
use coface_complexes::surface::samples::{
    all_kinds, genus, map_of, of_next, polygon, with_faces_turned, without_faces,
};
use proptest::prelude::*;

/// The canonical word of a surface.
fn canonical_word(component: &CanonicalComponent) -> Vec<i32> {
    let surface = component.surface();
    let (genus, holes) = (surface.genus() as i32, surface.boundary_count() as i32);
    if surface.euler_characteristic() == 2 {
        return vec![1, -1];
    }
    if surface.is_orientable() && genus == 0 && holes == 1 {
        return vec![1];
    }
    let (mut word, loops) = if surface.is_orientable() {
        ((0..genus).flat_map(|i| [2 * i + 1, 2 * i + 2, -2 * i - 1, -2 * i - 2]).collect(), 2 * genus)
    } else {
        ((1..=genus).flat_map(|c| [c, c]).collect::<Vec<i32>>(), genus)
    };
    word.extend((1..=holes).flat_map(|i| [loops + i, loops + holes + i, -loops - i]));
    word
}

/// The vertices where the steps start.
fn starts(map: &GeneralizedMap, steps: &[u32]) -> Vec<u32> {
    steps.iter().map(|&step| map.skeleton().edge_ends()[step as usize]).collect()
}

fn end(map: &GeneralizedMap, steps: &[u32]) -> u32 {
    map.skeleton().edge_ends()[(steps[steps.len() - 1] ^ 1) as usize]
}

/// Curves are walks, simple, and meet at the base only.
fn check_curves(cut: &CanonicalCut) {
    let map = cut.refinement().map();
    let mut times = vec![0; map.vertex_count()];
    for component in cut.components() {
        for curve in component.curves() {
            let at = starts(map, curve.steps());
            for (i, &step) in curve.steps().iter().enumerate() {
                let after = at.get(i + 1).copied().unwrap_or_else(|| end(map, curve.steps()));
                assert_eq!(map.skeleton().edge_ends()[(step ^ 1) as usize], after);
            }
            let is_closed = end(map, curve.steps()) == at[0];
            let is_path = matches!(curve.kind(), CurveKind::Join | CurveKind::Slit);
            assert_eq!(is_closed, !is_path, "{}", curve.name());
            if curve.kind() != CurveKind::Boundary {
                assert_eq!(Some(VertexId::from_u32(at[0])), component.base());
                at[1..].iter().for_each(|&vertex| times[vertex as usize] += 1);
            } else {
                assert!(
                    curve
                        .steps()
                        .iter()
                        .all(|step| map.mate(map.first_side(EdgeId::from_u32(step >> 1))).is_none())
                );
                at.iter().for_each(|&vertex| times[vertex as usize] += 1);
            }
        }
        assert!(component.base().is_none_or(|base| times[base.index()] == 0));
    }
    assert!(times.iter().all(|&count| count <= 1), "curves are simple and disjoint");
}

/// The refined surface lies in the one before, with all faces the right way round.
fn check_refinement(map: &GeneralizedMap, refined: &Refinement) {
    assert_eq!(refined.map().surfaces(), map.surfaces());
    for vertex in (0..refined.map().vertex_count()).map(VertexId::new) {
        let weights = refined.weights(vertex);
        let sum: f64 = weights.iter().map(|&(_, weight)| weight).sum();
        assert!((sum - 1.0).abs() < 1e-12 && weights.iter().all(|&(_, weight)| weight > 0.0));
        match refined.vertex_carriers()[vertex] {
            Carrier::Vertex(before) => assert_eq!((before, weights), (vertex, &[(vertex, 1.0)][..])),
            Carrier::Edge(edge) => {
                let ends = map.skeleton().edge(edge);
                assert!(weights.iter().all(|(under, _)| ends.contains(under)));
            }
            Carrier::Face(face) => {
                let corners: Vec<VertexId> = map.sides_of(face).map(|side| map.source(side)).collect();
                assert!(weights.iter().all(|(under, _)| corners.contains(under)));
            }
        }
    }
    // Shares of the areas of triangles with three different corners.
    let mut shares = vec![0.0; map.face_count()];
    for face in (0..refined.map().face_count()).map(FaceId::new) {
        let source = refined.face_sources()[face];
        let corners: Vec<VertexId> = map.sides_of(source).map(|side| map.source(side)).collect();
        let mut sorted = corners.clone();
        sorted.sort_unstable();
        sorted.dedup();
        if sorted.len() != 3 || corners.len() != 3 {
            continue;
        }
        let points: Vec<[f64; 3]> = (refined.map().sides_of(face))
            .map(|side| {
                let weights = refined.weights(refined.map().source(side));
                let share = |corner: &VertexId| {
                    weights.iter().find(|(under, _)| under == corner).map_or(0.0, |w| w.1)
                };
                [share(&corners[0]), share(&corners[1]), share(&corners[2])]
            })
            .collect();
        assert_eq!(points.len(), 3, "what triangles become is triangulated");
        let [p, q, r] = [points[0], points[1], points[2]];
        let area = p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0])
            + p[2] * (q[0] * r[1] - q[1] * r[0]);
        assert!(area > 1e-12, "no face is turned over or flat");
        shares[source.index()] += area;
    }
    assert!(
        shares.iter().all(|&share| share == 0.0 || (share - 1.0_f64).abs() < 1e-9),
        "faces are covered once"
    );
}

fn check(map: &GeneralizedMap, base: Option<VertexId>) -> CanonicalCut {
    let cut = CanonicalCut::new(map, base).unwrap();
    check_refinement(map, cut.refinement());
    check_curves(&cut);
    for component in cut.components() {
        assert_eq!(component.word(), canonical_word(component));
    }
    let slice = cut.slice();
    let disks = slice.surface().surfaces();
    assert_eq!(disks.len(), map.surfaces().len());
    assert!(disks.iter().all(|disk| disk.to_string() == "disk"), "{disks:?}");
    cut
}

/// Two copies beside each other.
fn twice(map: &GeneralizedMap) -> GeneralizedMap {
    let skeleton = map.skeleton();
    let (vertices, edges) = (skeleton.vertex_count() as u32, skeleton.edge_count() as u32);
    let ends = skeleton.edge_ends();
    let mut faces = skeleton.faces().clone();
    faces.append_moved(skeleton.faces(), 2 * edges);
    let ends = ends.iter().copied().chain(ends.iter().map(|end| end + vertices)).collect();
    GeneralizedMap::new(TwoSkeleton::new(2 * vertices as usize, ends, faces).unwrap()).unwrap()
}

#[test]
fn known_surfaces_have_their_words() {
    for g in 1..5 {
        check(&genus(g), None);
    }
    for (_, map) in all_kinds() {
        check(&map, None);
    }
    check(&polygon(&[1, 1, 2, 3, -2, -3]), None);
    check(&polygon(&[1, 2, 3, 1, 2, 3]), None);
    check(&polygon(&[1, 2, 3, 4, -1, -2, -3, -4]), None);
    check(&polygon(&[1, 2, -1, -2, 3]), None);
    check(&polygon(&[1, 1, 2, 3, 4]), None);
    check(&polygon(&[1, 2, -1, 3]), None);
    check(&polygon(&[1, -1]), None);
    check(&twice(&genus(2)), None);
}

/// How many triangles of a drawn cut are flat, or turned otherwise than most of their component.
fn turned(cut: &CanonicalCut, plane: PolygonPlane, lengths: Option<&[f64]>) -> usize {
    let slice = cut.slice();
    let open = slice.surface();
    let points = cut.layout(&slice, plane, lengths).unwrap();
    let orientation = open.orientation();
    let mut counts = vec![[0; 2]; cut.components().len()];
    for face in (0..open.face_count()).map(FaceId::new) {
        let at: Vec<[f64; 2]> = open.sides_of(face).map(|side| points[open.source(side).index()]).collect();
        assert_eq!(at.len(), 3);
        let [p, q, r] = [at[0], at[1], at[2]];
        let area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
        if area == 0.0 {
            continue;
        }
        let is_left = (area > 0.0) == (orientation.signs()[face.index()] == Sign::Plus);
        counts[orientation.component(face)][usize::from(is_left)] += 1;
    }
    open.face_count() - counts.iter().map(|[right, left]| *right.max(left)).sum::<usize>()
}

/// Whether all components have regular polygons in the hyperbolic plane.
fn is_hyperbolic(map: &GeneralizedMap) -> bool {
    map.surfaces().iter().all(|surface| surface.euler_characteristic() < 0 && surface.boundary_count() == 0)
}

/// Draws a surface in both planes.
fn check_layout(name: &str, map: &GeneralizedMap) {
    let cut = CanonicalCut::new(map, None).unwrap();
    let drawn = cut.straightened().unwrap();
    assert_eq!(drawn.refinement().map().surfaces(), map.surfaces());
    check_curves(&drawn);
    for (before, after) in cut.components().iter().zip(drawn.components()) {
        assert_eq!(before.word(), after.word(), "{name}");
    }
    assert_eq!(turned(&drawn, PolygonPlane::Euclidean, None), 0, "{name}");
    let klein = drawn.layout(&drawn.slice(), PolygonPlane::Klein, None);
    assert_eq!(klein.is_ok(), is_hyperbolic(map), "{name}");
    if klein.is_ok() {
        assert_eq!(turned(&drawn, PolygonPlane::Klein, None), 0, "{name}");
    }
    // Edges of one length have equilateral triangles, which are Delaunay: cotangents are all alike, but for the rim.
    let ones = vec![1.0; drawn.refinement().map().edge_count()];
    assert_eq!(turned(&drawn, PolygonPlane::Euclidean, Some(&ones)), 0, "{name}");
}

#[test]
fn polygons_are_drawn_without_turning_triangles_over() {
    for (name, map) in
        all_kinds().into_iter().chain([("two double tori", twice(&genus(2))), ("genus 4", genus(4))])
    {
        check_layout(name, &map);
    }
    for word in [&[1, 1, 2, 3, -2, -3][..], &[1, 2, 3, 1, 2, 3], &[1, 2, -1, -2, 3], &[1, -1], &[1, 1]] {
        check_layout(&format!("{word:?}"), &polygon(word));
    }
    check_layout("square torus", &of_next(vec![2, 3, 1, 0]));
}

#[test]
fn intrinsic_delaunay_weights_are_not_negative() {
    // A flat torus, sheared: the long diagonals are flipped, and uniform lengths of a lattice of squares come back.
    let torus =
        GeneralizedMap::new(known_spaces::torus_grid(&[6, 6]).unwrap().freeze().two_skeleton().unwrap())
            .unwrap();
    let cut = CanonicalCut::new(&torus, None).unwrap().straightened().unwrap();
    let map = cut.refinement().map();
    let lengths: Vec<f64> =
        (0..map.edge_count()).map(|edge| 1.0 + 5.0 * ((edge * 7919 % 101) as f64 / 101.0)).collect();
    let points = cut.layout(&cut.slice(), PolygonPlane::Euclidean, Some(&lengths)).unwrap();
    assert!(points.iter().all(|[x, y]| x.abs() + y.abs() < 1.0 + 1e-9));
    assert!(cut.layout(&cut.slice(), PolygonPlane::Euclidean, Some(&lengths[1..])).is_err());
}

#[test]
fn glued_sides_are_congruent() {
    // Isometries of the hyperbolic plane keep cross ratios: distances along a side from its start and back from its end agree.
    let cut = CanonicalCut::new(&genus(2), None).unwrap().straightened().unwrap();
    let slice = cut.slice();
    let points = cut.layout(&slice, PolygonPlane::Klein, None).unwrap();
    let corner = 1.0 / (std::f64::consts::PI / 8.0).tan().powi(2);
    let radius = (1.0 - corner.powi(-2)).sqrt();
    let largest = points.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
    assert!((largest - radius).abs() < 1e-12);
    let distance = |p: [f64; 2], q: [f64; 2]| {
        let dot = 1.0 - p[0] * q[0] - p[1] * q[1];
        let room = |p: [f64; 2]| 1.0 - p[0] * p[0] - p[1] * p[1];
        (dot / (room(p) * room(q)).sqrt()).max(1.0).acosh()
    };
    let mut lengths: Vec<Vec<f64>> = vec![Vec::new(); cut.refinement().map().edge_count()];
    for side in slice.surface().sides().filter(|&side| slice.surface().mate(side).is_none()) {
        let [from, to] =
            [slice.surface().source(side), slice.surface().target(side)].map(|end| points[end.index()]);
        lengths[cut.refinement().map().edge(side).index()].push(distance(from, to));
    }
    for pair in lengths.iter().filter(|pair| !pair.is_empty()) {
        assert!(pair.len() == 2 && (pair[0] - pair[1]).abs() < 1e-6, "{pair:?}");
    }
}

#[test]
fn any_inner_vertex_can_be_the_base() {
    let double = genus(2);
    for vertex in (0..double.vertex_count()).map(VertexId::new) {
        assert_eq!(check(&double, Some(vertex)).components()[0].base(), Some(vertex));
    }
    let holed = without_faces(&double, &[0, 20]).unwrap();
    let outer = holed.source(holed.sides().find(|&side| holed.mate(side).is_none()).unwrap());
    let error = CanonicalCut::new(&holed, Some(outer)).unwrap_err();
    assert!(error.message().contains("on the boundary"), "{error}");
    assert!(CanonicalCut::new(&holed, Some(VertexId::new(1000))).is_err());
}

#[test]
fn curves_do_not_grow_with_the_genus() {
    // Crossings of an edge by one loop, at most, and of all edges together for each unit of genus and cell.
    for g in [4, 8, 16] {
        let map = genus(g);
        let cut = check(&map, None);
        let longest = cut.components()[0].curves().iter().map(|curve| curve.steps().len()).max().unwrap();
        assert!(longest < 8 * map.face_count(), "{longest} steps at genus {g}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn canonical_cuts_are_disks_with_canonical_words(
        letters in (1_i32..9, any::<u64>()).prop_flat_map(|(n, turned)| {
            let letters: Vec<i32> = (1..=n).flat_map(|i| [i, if turned >> i & 1 == 0 { -i } else { i }]).collect();
            Just(letters).prop_shuffle()
        }),
        holes in 0_usize..4,
        turned in any::<u64>(),
    ) {
        // A polygon with some sides left on the boundary, as it is and subdivided.
        let mut letters = letters;
        for hole in 0..holes {
            letters.insert((turned >> (8 * hole)) as usize % letters.len(), 100 + hole as i32);
        }
        let map = polygon(&letters);
        check(&map, None);
        let faces: Vec<FaceId> = (0..map.face_count()).map(FaceId::new).collect();
        let once = refinement::Refinement::poked(&map, &faces);
        let faces: Vec<FaceId> = (0..once.map().face_count()).map(FaceId::new).collect();
        let poked = refinement::Refinement::poked(once.map(), &faces);
        check(&with_faces_turned(poked.map(), turned), None);
    }

    #[test]
    fn canonical_cuts_of_halfedge_permutations(next in Just((0..24_u32).collect::<Vec<u32>>()).prop_shuffle()) {
        check(&of_next(next), None);
    }

    #[test]
    fn canonical_cuts_of_holed_surfaces(gone in proptest::collection::vec(0_usize..64, 0..12), turned in any::<u64>()) {
        for whole in [genus(2), map_of(known_spaces::klein_grid(6, 6))] {
            if let Some(map) = without_faces(&whole, &gone) {
                check(&with_faces_turned(&map, turned), None);
            }
        }
    }
}

#[test]
fn subdivision_along_nothing_changes_nothing() {
    let map = genus(1);
    let empty = RaggedArray::from_lists(vec![Vec::<u32>::new(); map.edge_count()]);
    let (refined, steps) = refinement::Refinement::along(&map, &empty, &[]);
    assert!(steps.is_empty());
    assert_eq!(refined.map(), &map);
    assert_eq!(map.orientation().signs()[0], Sign::Plus);
}
