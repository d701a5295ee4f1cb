//! The homology of arrangements and of selected cells is that of the space, whatever holes, voids and tunnels there are:
//! compared with voxels.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::spatial_arrangements::cuboid;
use coface::algebra::chains::{Cells, ChainComplex};
use coface::algebra::{FaceId, RaggedArray, Sign, UnionFind};
use coface::arrange::planar::PlanarArrangement;
use coface::arrange::spatial::{BallRules, SpatialArrangement, SpatialOptions, SpatialPolygons};
use coface::complexes::cubical::CubicalVolume;
use coface::geometry::Positions;
use coface::topology::homology;
use proptest::prelude::*;

/// The size of the lattice that boxes are in.
const SIZE: usize = 6;

type Corners = [[usize; 3]; 2];

/// Betti numbers without the zeros at the end, and whether there is torsion.
fn groups(complex: &ChainComplex) -> (Vec<usize>, bool) {
    let found = homology(complex);
    let mut betti = found.betti_numbers();
    while betti.last() == Some(&0) {
        betti.pop();
    }
    (betti, found.groups().iter().any(|group| !group.torsion().is_empty()))
}

/// The homology of closed voxels.
fn of_voxels(is_set: impl Fn([usize; 3]) -> bool) -> (Vec<usize>, bool) {
    let voxel = |voxel: &[u32]| is_set([0, 1, 2].map(|axis| voxel[axis] as usize));
    let volume = CubicalVolume::new(&[SIZE as u32; 3], &[false; 3], voxel).unwrap();
    groups(&volume.chain_complex().unwrap())
}

fn contains([low, high]: &Corners, voxel: [usize; 3]) -> bool {
    (0..3).all(|axis| low[axis] <= voxel[axis] && voxel[axis] < high[axis])
}

/// Cuboids with corners on a lattice, sheared so that no face is at right angles to an axis if `shear`.
fn arranged(boxes: &[Corners], shear: bool) -> SpatialArrangement {
    let inputs: Vec<SpatialPolygons> = boxes
        .iter()
        .map(|corners| {
            let [low, high] = corners.map(|corner| corner.map(|x| x as f64));
            let place = |[x, y, z]: [f64; 3]| {
                if shear { [x + y, y + 2.0 * z + x, z + x - y] } else { [x, y, z] }
            };
            cuboid(low, high, place)
        })
        .collect();
    SpatialArrangement::new(&SpatialPolygons::joined(&inputs).unwrap(), &SpatialOptions::default()).unwrap()
}

/// The parts that selected cells make up, all of them one part, and each a part.
fn check_selection(arrangement: &SpatialArrangement, is_in: &[bool], expected: &(Vec<usize>, bool)) {
    let mut count = 0;
    let each: Vec<Option<u32>> = is_in
        .iter()
        .map(|is_in| {
            is_in.then(|| {
                count += 1;
                count - 1
            })
        })
        .collect();
    let mut regions = UnionFind::new(is_in.len());
    for face in (0..arrangement.complex().face_count()).map(FaceId::new) {
        if let [Some(a), Some(b)] = [Sign::Plus, Sign::Minus].map(|side| arrangement.cell_at(face, side))
            && is_in[a.index()]
            && is_in[b.index()]
        {
            regions.unite(a.to_u32(), b.to_u32());
        }
    }
    let mut numbers = std::collections::BTreeMap::new();
    let whole: Vec<Option<u32>> = (0..is_in.len())
        .map(|cell| {
            is_in[cell].then(|| {
                let next = numbers.len() as u32;
                *numbers.entry(regions.find(cell as u32)).or_insert(next)
            })
        })
        .collect();
    for (name, parts) in [("cells", each), ("regions", whole)] {
        for triangles in [false, true] {
            let balls = arrangement.ball_complex_of(&parts, BallRules::new().triangles(triangles)).unwrap();
            assert_eq!(balls.parts_left(), [0u32; 0], "{name}");
            assert_eq!(groups(balls.complex()), *expected, "{name} {triangles}");
            balls.refinement().coarse(balls.complex()).unwrap();
        }
    }
}

fn check(boxes: &[Corners], shear: bool) {
    let arrangement = arranged(boxes, shear);
    let inside = arrangement.inside(Default::default()).unwrap();
    // The union of all faces and bounded cells.
    let all = arrangement.ball_complex().unwrap();
    assert_eq!(all.parts_left(), [0u32; 0]);
    let union = |voxel| boxes.iter().any(|own| contains(own, voxel));
    // Bounded cells outside of all boxes are filled.
    let filled = {
        let everything = vec![true; inside.len()];
        let betti = groups(all.complex());
        check_selection(&arrangement, &everything, &betti);
        betti
    };
    let coarse = all.refinement().coarse(all.complex()).unwrap();
    assert_eq!(coarse.f_vector(), arrangement.f_vector());
    assert!(filled.0.get(2).is_none_or(|&voids| voids == 0), "{filled:?}");
    let select = |rule: &dyn Fn(&[usize]) -> bool| inside.iter().map(|own| rule(own)).collect::<Vec<bool>>();
    check_selection(&arrangement, &select(&|own| !own.is_empty()), &of_voxels(union));
    let odd = |voxel| boxes.iter().filter(|own| contains(own, voxel)).count() % 2 == 1;
    check_selection(&arrangement, &select(&|own| own.len() % 2 == 1), &of_voxels(odd));
    let first = |voxel| contains(&boxes[0], voxel) && !boxes[1..].iter().any(|own| contains(own, voxel));
    check_selection(&arrangement, &select(&|own| own == [0]), &of_voxels(first));
}

#[test]
fn tunnels_voids_and_touching_solids() {
    let cube = [[0; 3], [5; 3]];
    let rod = |axis: usize, at: [usize; 2], width: usize| {
        let (mut low, mut high) = ([at[0]; 3], [at[0] + width; 3]);
        (low[(axis + 1) % 3], high[(axis + 1) % 3]) = (at[1], at[1] + width);
        (low[axis], high[axis]) = (0, 6);
        [low, high]
    };
    let scenes: [&[Corners]; 11] = [
        &[cube],
        &[cube, [[1; 3], [2; 3]]],
        &[cube, rod(2, [2, 2], 1)],
        &[cube, rod(2, [1, 1], 1), rod(2, [3, 3], 1)],
        &[cube, rod(0, [2, 2], 1), rod(1, [2, 2], 1), rod(2, [2, 2], 1)],
        // Boxes in a box, in a corner of each other, and one void that touches another in an edge.
        &[cube, [[1; 3], [2; 3]], [[2; 3], [3; 3]], [[1, 1, 3], [2, 2, 4]]],
        // A ring of four beams within a cube, and a beam through it that does not touch.
        &[
            cube,
            [[1, 1, 1], [4, 2, 2]],
            [[1, 3, 1], [4, 4, 2]],
            [[1, 1, 1], [2, 4, 2]],
            [[3, 1, 1], [4, 4, 2]],
        ],
        // Two boxes at a vertex, and a third that closes a ring of vertices.
        &[[[0; 3], [2; 3]], [[2; 3], [4; 3]], [[4, 4, 2], [6, 6, 4]]],
        &[[[0; 3], [2; 3]], [[2; 3], [4; 3]], [[2, 0, 4], [4, 2, 6]], [[0, 0, 2], [2, 2, 4]]],
        // A cut through a vertex lies on faces between boxes that are put together.
        &[[[0, 2, 2], [3, 4, 5]], [[0, 2, 1], [3, 5, 4]], [[3, 4, 3], [4, 5, 5]], [[3, 3, 4], [4, 5, 5]]],
        // Boxes that overlap in parts of their faces, edges and vertices.
        &[[[2, 4, 0], [4, 5, 1]], [[3, 1, 1], [5, 4, 2]], [[3, 3, 1], [6, 4, 2]], [[4, 2, 0], [6, 5, 3]]],
    ];
    for scene in scenes {
        check(scene, false);
        check(scene, true);
    }
}

/// A tunnel so small that planes through few of the vertices miss it.
#[test]
fn a_narrow_tunnel_among_many_vertices() {
    let large = cuboid([0.0; 3], [100.0; 3], |p| p);
    let tunnel = cuboid([61.3, 47.9, 0.0], [61.301, 47.901, 100.0], |p| p);
    let voids = (0..40).map(|i| {
        let low = [1, 7, 11].map(|step| 1.0 + f64::from(i * step % 43) * 2.0);
        cuboid(low, low.map(|x| x + 1.0), |p| p)
    });
    let inputs: Vec<SpatialPolygons> = [large, tunnel].into_iter().chain(voids).collect();
    let arrangement =
        SpatialArrangement::new(&SpatialPolygons::joined(&inputs).unwrap(), &SpatialOptions::default())
            .unwrap();
    assert_eq!(arrangement.fine().cell_count(), 42);
    let parts: Vec<Option<u32>> =
        arrangement.volumes().unwrap().iter().map(|&volume| (volume > 1e5).then_some(0)).collect();
    let balls = arrangement.ball_complex_of(&parts, BallRules::new()).unwrap();
    assert_eq!(balls.parts_left(), [0u32; 0]);
    assert_eq!(groups(balls.complex()), (vec![1, 1, 40], false));
}

/// Planes across the axes cut the wall of a slanted tube in rings, or take off its tip.
#[test]
fn the_wall_of_a_slanted_tube_is_a_solid_torus() {
    const SIDES: u32 = 24;
    let [along, u, v] = [[1.0, 2.0, 3.0], [2.0, -1.0, 0.0], [0.6, 1.2, -1.0]];
    let corner = |side: u32, radius: f64, length: f64| {
        let (sine, cosine) = (f64::from(side) * std::f64::consts::TAU / f64::from(SIDES)).sin_cos();
        [0, 1, 2].map(|i| length * along[i] + radius * (cosine * u[i] + sine * v[i]))
    };
    // Rings of corners: inside and outside at one end, outside and inside at the other.
    let rings = [(0.95, 0.0), (1.0, 0.0), (1.0, 9.0), (0.95, 9.0)];
    let points: Vec<f64> = rings
        .iter()
        .flat_map(|&(radius, length)| (0..SIDES).flat_map(move |side| corner(side, radius, length)))
        .collect();
    let triangles = RaggedArray::from_lists((0..4 * SIDES).flat_map(|place| {
        let (ring, side) = (place / SIDES, place % SIDES);
        let at = |ring: u32, side: u32| ring % 4 * SIDES + side % SIDES;
        let [a, b] = [at(ring, side), at(ring, side + 1)];
        let [c, d] = [at(ring + 1, side + 1), at(ring + 1, side)];
        [[a, b, c], [a, c, d]]
    }));
    let polygons: Vec<u32> = (0..8 * SIDES).collect();
    let tube = SpatialPolygons::new(Positions::from_flat(3, points).unwrap(), triangles, polygons).unwrap();
    let arrangement = SpatialArrangement::new(&tube, &SpatialOptions::default()).unwrap();
    assert_eq!(arrangement.f_vector()[3], 1);
    let found = arrangement.ball_complex().unwrap();
    assert_eq!(found.parts_left(), [0u32; 0]);
    assert_eq!(groups(found.complex()), (vec![1, 1], false));
    // Cut along it in two.
    assert_eq!(found.complex().f_vector()[3], 2);
}

/// A solid comes back to itself from above in a vertex, where its face below has a corner of three quarters of a turn.
#[test]
fn what_touches_in_a_corner_of_more_than_a_half_turn_is_cut_there() {
    let outline = [[0., 0.], [4., 0.], [4., 2.], [2., 2.], [2., 4.], [0., 4.]];
    let points: Vec<f64> =
        [0.0, 1.0].iter().flat_map(|&z| outline.iter().flat_map(move |&[x, y]| [x, y, z])).collect();
    let walls = (0..6).map(|i| vec![i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6]);
    let walks: Vec<Vec<u32>> = walls.chain([vec![5, 4, 3, 2, 1, 0], vec![6, 7, 8, 9, 10, 11]]).collect();
    let corner = SpatialPolygons::from_polygons(
        Positions::from_flat(3, points).unwrap(),
        RaggedArray::from_lists(walks),
    );
    let column = cuboid([0.0, 0.0, 0.5], [1.0, 1.0, 5.0], |p| p);
    let plate = cuboid([0.0, 0.0, 4.0], [4.0, 4.0, 5.0], |p| p);
    let pyramid = [[2., 2., 1.], [1.5, 1.5, 4.5], [2.5, 1.5, 4.5], [2.5, 2.5, 4.5], [1.5, 2.5, 4.5]];
    let sides = RaggedArray::from_lists([&[0, 2, 1][..], &[0, 3, 2], &[0, 4, 3], &[0, 1, 4], &[1, 2, 3, 4]]);
    let pyramid = SpatialPolygons::from_polygons(Positions::from_flat(3, pyramid.concat()).unwrap(), sides);
    let all = SpatialPolygons::joined(&[corner.unwrap(), column, plate, pyramid.unwrap()]).unwrap();
    let arrangement = SpatialArrangement::new(&all, &SpatialOptions::default()).unwrap();
    let parts = vec![Some(0); arrangement.fine().cell_count()];
    let found = arrangement.ball_complex_of(&parts, BallRules::new()).unwrap();
    assert_eq!(groups(found.complex()), (vec![1, 1], false));
    assert_eq!(found.parts_left(), [0u32; 0]);
}

#[test]
fn an_apex_and_a_ridge_inside_a_face_touch_it() {
    // A pyramid on its apex, and a roof on its ridge, each on the top of a cube.
    let cube = || cuboid([0.0; 3], [4.0, 4.0, 4.0], |point| point);
    let pyramid = [[1., 1., 4.], [0., 0., 6.], [3., 0., 6.], [0., 3., 6.]];
    let roof = [[1., 2., 4.], [3., 2., 4.], [1., 1., 6.], [3., 1., 6.], [1., 3., 6.], [3., 3., 6.]];
    let pyramid = SpatialPolygons::from_polygons(
        Positions::from_flat(3, pyramid.concat()).unwrap(),
        RaggedArray::from_lists([[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]]),
    );
    let roof = SpatialPolygons::from_polygons(
        Positions::from_flat(3, roof.concat()).unwrap(),
        RaggedArray::from_lists([&[0, 1, 3, 2][..], &[1, 0, 4, 5], &[2, 3, 5, 4], &[0, 2, 4], &[1, 5, 3]]),
    );
    for other in [pyramid.unwrap(), roof.unwrap()] {
        let both = SpatialPolygons::joined(&[cube(), other]).unwrap();
        let arrangement = SpatialArrangement::new(&both, &SpatialOptions::default()).unwrap();
        assert_eq!(groups(&arrangement.chain_complex().unwrap()), (vec![1], false));
        assert_eq!(arrangement.ball_complex().unwrap().parts_left(), [0u32; 0]);
    }
}

/// A void whose apex or ridge is inside of a face of the solid, from within, and the same with a shaft from the bottom into the void.
#[test]
fn voids_that_touch_a_face_from_within() {
    let polygons = |points: &[[f64; 3]], lists: &[&[u32]]| {
        let positions = Positions::from_flat(3, points.concat()).unwrap();
        SpatialPolygons::from_polygons(positions, RaggedArray::from_lists(lists)).unwrap()
    };
    let base = [[1., 1., 2.], [3., 1., 2.], [3., 3., 2.], [1., 3., 2.]];
    let pyramid = polygons(
        &[&base[..], &[[2., 2., 4.]]].concat(),
        &[&[3, 2, 1, 0], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]],
    );
    let roof = polygons(
        &[&base[..], &[[1., 2., 4.], [3., 2., 4.]]].concat(),
        &[&[3, 2, 1, 0], &[0, 1, 5, 4], &[2, 3, 4, 5], &[1, 2, 5], &[3, 0, 4]],
    );
    let cube = cuboid([0.0; 3], [4.0; 3], |point| point);
    let shaft = cuboid([1.5, 1.5, 0.0], [2.5, 2.5, 2.5], |point| point);
    for (void, touches_along) in [(pyramid, 0), (roof, 1)] {
        for has_shaft in [false, true] {
            let mut inputs = vec![cube.clone(), void.clone()];
            inputs.extend(has_shaft.then(|| shaft.clone()));
            let all = SpatialPolygons::joined(&inputs).unwrap();
            let arrangement = SpatialArrangement::new(&all, &SpatialOptions::default()).unwrap();
            let inside = arrangement.inside(Default::default()).unwrap();
            let parts: Vec<Option<u32>> = inside.iter().map(|own| (own[..] == [0]).then_some(0)).collect();
            for triangles in [false, true] {
                let rules = BallRules::new().triangles(triangles);
                let balls = arrangement.ball_complex_of(&parts, rules).unwrap();
                assert_eq!(balls.parts_left(), [0u32; 0], "{touches_along} {has_shaft} {triangles}");
                let expected = if has_shaft { vec![1] } else { vec![1, 0, 1] };
                assert_eq!(
                    groups(balls.complex()),
                    (expected, false),
                    "{touches_along} {has_shaft} {triangles}"
                );
            }
        }
    }
}

#[test]
fn faces_of_the_plane_with_holes_and_islands() {
    let square = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]];
    let points = [
        &square(0., 9.)[..],
        &square(1., 2.),
        &square(3., 8.),
        &square(4., 5.),
        &[[6., 6.], [7., 7.], [1.5, 5.]],
    ];
    let positions = Positions::from_flat(2, points.concat().concat()).unwrap();
    let mut segments: Vec<[u32; 2]> =
        (0..16u32).map(|i| [i, if i % 4 == 3 { i - 3 } else { i + 1 }]).collect();
    // A loose edge inside the third square; the last point is used by nothing.
    segments.push([16, 17]);
    let nested = PlanarArrangement::new(&positions, &segments).unwrap();
    let (complex, refinement) = nested.ball_complex().unwrap();
    assert_eq!(groups(&complex), (vec![1], false));
    assert_eq!(refinement.coarse(&complex).unwrap(), nested.coarse_complex().unwrap());
    // The boundary of each disk is one walk.
    assert!(Cells::two_skeleton(&nested).is_ok());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn random_boxes_agree_with_voxels(
        corners in prop::collection::vec(([0usize..5, 0usize..5, 0usize..5], [1usize..4, 1usize..4, 1usize..4]), 1..7),
        shear in any::<bool>(),
    ) {
        let end = |low: usize, size: usize| (low + size).min(SIZE);
        let boxes: Vec<Corners> =
            corners.iter().map(|(low, size)| [*low, [0, 1, 2].map(|axis| end(low[axis], size[axis]))]).collect();
        check(&boxes, shear);
    }

    #[test]
    fn random_drawings_are_as_connected_as_they_are(
        ends in prop::collection::vec([0i32..12, 0i32..12, 0i32..12, 0i32..12], 1..14),
    ) {
        let segments: Vec<[i32; 4]> = ends.into_iter().filter(|[a, b, c, d]| (a, b) != (c, d)).collect();
        let flat = segments.iter().flatten().map(|&x| f64::from(x)).collect();
        let pairs: Vec<[u32; 2]> = (0..segments.len() as u32).map(|i| [2 * i, 2 * i + 1]).collect();
        let found = PlanarArrangement::new(&Positions::from_flat(2, flat).unwrap(), &pairs).unwrap();
        let (complex, refinement) = found.ball_complex().unwrap();
        // All bounded faces are filled: nothing is left but the parts that no face lies around.
        let parts = (0..found.component_count()).filter(|&part| found.face_around_component(part).is_none()).count();
        let expected = if parts == 0 { vec![] } else { vec![parts] };
        prop_assert_eq!(groups(&complex), (expected, false));
        prop_assert_eq!(refinement.coarse(&complex).unwrap(), found.coarse_complex().unwrap());
        prop_assert!(Cells::two_skeleton(&found).is_ok());
    }
}
