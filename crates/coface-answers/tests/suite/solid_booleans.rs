//! Boolean combinations of models in space: cubes with known volumes, volume meshes, open and inside-out surfaces, files with
//! published results.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stderr, reason = "a test that is skipped says so")]

use coface_algebra::RaggedArray;
use coface_algebra::{CellId, ErrorKind};
use coface_answers::answer::{BoundaryVerdict, InsideMethod, RemarkCode};
use coface_answers::{
    InputState, SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest, SpatialScene, welded,
};
use coface_arrange::boolean::{BooleanFormula, InsideRule};
use coface_arrange::spatial::NonPlanar;
use coface_complexes::cell_mesh::CellShape;
use coface_geometry::Positions;
use coface_io as io;
use coface_io::{Format, Model};
use coface_topology::homology;
use proptest::prelude::*;

const SQUARES: [[u32; 4]; 6] =
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

fn corners(low: [f64; 3], high: [f64; 3]) -> Positions {
    let corner = |i: usize| (0..3).map(move |axis| if i >> axis & 1 == 0 { low[axis] } else { high[axis] });
    Positions::from_flat(3, (0..8).flat_map(corner).collect()).unwrap()
}

/// A box with squares that run counterclockwise seen from outside.
fn cuboid(low: [f64; 3], high: [f64; 3]) -> Model {
    Model::from_polygons(corners(low, high), RaggedArray::from_lists(SQUARES)).unwrap()
}

fn cube(low: [f64; 3], side: f64) -> Model {
    cuboid(low, low.map(|x| x + side))
}

fn arranged(models: &[Model]) -> SceneArrangement {
    let names: Vec<String> = (0..models.len()).map(|i| format!("model {i}")).collect();
    let named = names.iter().map(String::as_str).zip(models);
    SceneArrangement::of(named, &SpatialRequest::default()).unwrap()
}

fn request(text: &str) -> SolidRequest {
    SolidRequest::of(BooleanFormula::parse(text, &[]).unwrap())
}

fn combined<'a>(scene: &'a SceneArrangement, text: &str) -> SolidBoolean<'a> {
    SolidBoolean::of(scene, &request(text)).unwrap()
}

#[test]
fn shifted_cubes_combine() {
    let scene = arranged(&[cube([0.0; 3], 1.0), cube([0.5; 3], 1.0)]);
    for (text, volume, f_vector, area) in [
        ("a | b", 1.875, [20, 30, 12], 10.5),
        ("a & b", 0.125, [8, 12, 6], 1.5),
        ("a - b", 0.875, [14, 21, 9], 6.0),
        ("b - a", 0.875, [14, 21, 9], 6.0),
        ("a ^ b", 1.75, [22, 36, 18], 12.0),
        ("a - a", 0.0, [0, 0, 0], 0.0),
    ] {
        let result = combined(&scene, text);
        assert_eq!((result.volume(), result.f_vector()), (Some(volume), f_vector), "{text}");
        let object = result.answer().unwrap();
        assert_eq!(object.area, Some(area), "{text}");
        assert!(object.closed);
        let pinched = text == "a ^ b";
        assert_eq!(object.manifold.verdict, BoundaryVerdict::of(!pinched));
        assert_eq!(object.pinches.edge_count, if pinched { 6 } else { 0 });
        // The result is the union of itself.
        if let Ok(model) = result.to_mesh()
            && !pinched
            && volume > 0.0
        {
            let again = arranged(&[model]);
            assert_eq!(combined(&again, "a").f_vector(), f_vector, "{text}");
        }
    }
    // The exterior is no cell, but its surface is that of the rest.
    let outside = combined(&scene, "!(a | b)");
    assert_eq!((outside.volume(), outside.f_vector()), (None, [20, 30, 12]));
    assert_eq!(outside.to_chains().unwrap_err().kind(), ErrorKind::UnsupportedFormat);
    assert!(SolidBoolean::of(&scene, &request("a | c")).is_err());
}

#[test]
fn pinches_are_split_on_request() {
    for (second, counts, components) in [
        ([0.5; 3], [28, 42, 18], 2),
        ([1.0; 3], [16, 24, 12], 2),
        ([1.0, 1.0, 0.0], [16, 24, 12], 2),
        // The edge is common in half its length only.
        ([1.0, 1.0, 0.5], [18, 26, 12], 2),
    ] {
        let scene = arranged(&[cube([0.0; 3], 1.0), cube(second, 1.0)]);
        for triangles in [false, true] {
            let mut request = request("a ^ b");
            request.triangles = triangles;
            assert!(!SolidBoolean::of(&scene, &request).unwrap().mesh().manifold_verdict().is_manifold());
            request.split_pinches = true;
            let result = SolidBoolean::of(&scene, &request).unwrap();
            let object = result.answer().unwrap();
            assert_eq!(object.manifold.verdict, BoundaryVerdict::Yes, "{second:?}");
            assert_eq!((object.components, object.solids), (components, components));
            assert!(result.copy_count() > 0);
            if !triangles {
                assert_eq!(result.f_vector(), counts, "{second:?}");
            }
            let [vertices, edges, faces] = result.f_vector().map(|count| count as i64);
            assert_eq!(vertices - edges + faces, 4);
        }
    }
}

#[test]
fn walls_and_cells_are_kept_on_request() {
    let scene = arranged(&[cube([0.0; 3], 1.0), cube([0.5; 3], 1.0)]);
    let mut request = request("a | b");
    for (keep_walls, f_vector) in [(false, [20, 30, 12, 1]), (true, [22, 36, 18, 3])] {
        request.keep_walls = keep_walls;
        let result = SolidBoolean::of(&scene, &request).unwrap();
        let chains = result.to_chains().unwrap();
        let Some(io::Structure::Chains(complex)) = chains.structure() else { panic!() };
        assert_eq!(complex.f_vector(), f_vector);
        let mesh = result.to_mesh().unwrap();
        assert_eq!(mesh.polygons().len(), f_vector[2]);
        // What is written is an input again, with the same inside.
        let again = arranged(&[chains]);
        assert_eq!(again.input_state(0), InputState::Closed);
        let union = combined(&again, "a");
        assert_eq!((union.volume(), again.complex().f_vector()), (Some(1.875), &f_vector[..]));
        request.triangles = keep_walls;
    }
    let mesh = SolidBoolean::of(&scene, &request).unwrap().to_mesh().unwrap();
    assert!(mesh.polygons().iter().all(|polygon| polygon.len() == 3));
    assert!(mesh.data_named("cell_front", io::GroupKind::Polygons).is_some());
    request.split_pinches = true;
    assert!(SolidBoolean::of(&scene, &request).is_err());
}

#[test]
fn faces_with_holes_count_once() {
    let rod = cuboid([0.25, 0.25, -0.5], [0.75, 0.75, 1.5]);
    let scene = arranged(&[cube([0.0; 3], 1.0), rod]);
    assert_eq!(
        (scene.complex().f_vector(), scene.answer(Default::default()).unwrap().holes),
        (&[24, 40, 22, 4][..], 2)
    );
    let drilled = combined(&scene, "a - b");
    assert_eq!((drilled.volume(), drilled.f_vector(), drilled.faces_cut()), (Some(0.75), [16, 24, 10], 2));
    let object = drilled.answer().unwrap();
    assert_eq!((object.genus, object.manifold.verdict), (Some(1), BoundaryVerdict::Yes));
    let chains = drilled.to_chains().unwrap();
    let coarse = chains.coarse().unwrap().unwrap();
    let Some(io::Structure::Chains(complex)) = coarse.structure() else { panic!() };
    assert_eq!(complex.f_vector(), [16, 24, 10, 1]);
    // A solid torus, whatever it is cut into.
    let Some(io::Structure::Chains(complex)) = chains.structure() else { panic!() };
    assert_eq!(homology(complex).betti_numbers(), [1, 1, 0, 0]);
    // Faces with holes are read back as such.
    let again = arranged(&[chains]);
    assert_eq!(combined(&again, "a").f_vector(), [16, 24, 10]);
}

#[test]
fn nested_cubes_have_a_void() {
    let scene = arranged(&[cube([0.0; 3], 1.0), cube([0.25; 3], 0.5)]);
    let object = scene.answer(Default::default()).unwrap();
    assert_eq!((object.voids, object.components), (1, 2));
    let shell = combined(&scene, "a - b");
    assert_eq!((shell.volume(), shell.part_counts()), (Some(0.875), [1, 1]));
    let object = shell.answer().unwrap();
    assert_eq!((object.components, object.solids), (2, 1));
    let chains = shell.to_chains().unwrap();
    let Some(io::Structure::Chains(complex)) = chains.structure() else { panic!() };
    assert_eq!(homology(complex).betti_numbers(), [1, 0, 1, 0]);
    assert_eq!(combined(&arranged(&[chains]), "a").volume(), Some(0.875));
}

#[test]
fn solids_inside_out_are_told_and_count() {
    let mut turned = SQUARES;
    turned.iter_mut().for_each(|square| square.reverse());
    let turned = Model::from_polygons(corners([0.5; 3], [1.5; 3]), RaggedArray::from_lists(turned)).unwrap();
    let scene = arranged(&[cube([0.0; 3], 1.0), turned]);
    assert_eq!(combined(&scene, "a | b").volume(), Some(1.875));
    let mut positive = request("a | b");
    positive.rule = InsideRule::Positive;
    assert_eq!(SolidBoolean::of(&scene, &positive).unwrap().volume(), Some(1.0));
    let object = scene.answer(Default::default()).unwrap();
    assert_eq!(object.files[1].reversed_cells, 2);
    assert_eq!(object.inside.len(), 3);
}

#[test]
fn open_surfaces_are_refused_with_their_rim_or_have_their_mouths_closed() {
    let lidless =
        Model::from_polygons(corners([0.0; 3], [1.0; 3]), RaggedArray::from_lists(&SQUARES[..5])).unwrap();
    let scene = arranged(&[lidless, cube([0.25, 0.25, 0.25], 0.5)]);
    assert_eq!(scene.input_state(0), InputState::Open { edges: 4 });
    let error = SolidBoolean::of(&scene, &request("a - b")).unwrap_err();
    assert_eq!((error.kind(), error.file()), (ErrorKind::NotACycle, Some("model 0")));
    for corner in ["(1, 0, 0)", "(1, 1, 0)", "(1, 1, 1)", "(1, 0, 1)", "4 edges"] {
        assert!(error.to_string().contains(corner), "{error}");
    }
    assert_eq!(scene.answer(Default::default()).unwrap().inside, [[1]]);
    let mut scene = scene.scene().clone();
    scene.close_mouths().unwrap();
    let closed = SceneArrangement::of_scene(scene, &SpatialRequest::default()).unwrap();
    let volume = |formula: &str| SolidBoolean::of(&closed, &request(formula)).unwrap().volume();
    let volumes = ["a", "a & b", "a | b", "a - b"].map(volume);
    assert_eq!(volumes, [Some(1.0), Some(0.125), Some(1.0), Some(0.875)]);
    let answer = SolidBoolean::of(&closed, &request("a - b")).unwrap().answer().unwrap();
    let file = &answer.files[0];
    assert_eq!((file.inside_by, file.closed, file.rim_edges), (Some(InsideMethod::ClosedMouths), false, 4));
    assert_eq!(answer.remarks.len(), 1);
    let said = &answer.remarks[0].message;
    assert_eq!(said, "model 0 is open: 1 mouth with 4 edges closed by patches of area 1");
}

/// A square of 4 x 4 corners on a side of a cube, without some of its triangles, another side whole where a neighbor is
/// divided: mouths in a plane are closed in it, and sides that end on others are no mouths.
#[test]
fn mouths_in_a_plane_are_closed_in_it() {
    let mut flat = corners([0.0; 3], [3.0; 3]).as_flat().to_vec();
    let first = (flat.len() / 3) as u32;
    flat.extend((0..16).flat_map(|i| [f64::from(i % 4), f64::from(i / 4), 0.0]));
    let others = SQUARES[1..].iter().map(|square| square.to_vec());
    let triangles = (0..9).flat_map(|i| {
        let low = first + i / 3 * 4 + i % 3;
        [vec![low, low + 4, low + 1], vec![low + 1, low + 4, low + 5]]
    });
    let triangles: Vec<Vec<u32>> = triangles.collect();
    for (gone, mouths) in [(&[][..], 0), (&[8, 9], 1), (&[0, 9, 17], 3), (&[0, 1, 2, 3, 4, 5], 1)] {
        let kept =
            triangles.iter().enumerate().filter(|(i, _)| !gone.contains(i)).map(|(_, own)| own.clone());
        let polygons = RaggedArray::from_lists(others.clone().chain(kept));
        let positions = Positions::from_flat(3, flat.clone()).unwrap();
        let model = Model::from_polygons(positions, polygons).unwrap();
        let mut scene = SpatialScene::of([("box", &model)], true).unwrap();
        scene.close_mouths().unwrap();
        let counts: Vec<u64> = scene.remarks().iter().map(|remark| remark.count).collect();
        assert_eq!(counts, if mouths == 0 { vec![] } else { vec![mouths] });
        let arranged = SceneArrangement::of_scene(scene, &SpatialRequest::default()).unwrap();
        assert_eq!(arranged.volumes(), [27.0], "{gone:?}");
        assert_eq!(SolidBoolean::of(&arranged, &request("a")).unwrap().volume(), Some(27.0));
    }
}

/// A lid that is one unit of the last place above a cube: the refusal names the radius that closes the gap.
#[test]
fn cracks_are_closed_by_the_radius_that_the_refusal_names() {
    let mut flat = corners([0.0; 3], [1.0; 3]).as_flat().to_vec();
    for [x, y] in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
        flat.extend([x, y, 1.0 + f64::EPSILON]);
    }
    let mut squares = SQUARES;
    squares[1] = [8, 9, 10, 11];
    let positions = Positions::from_flat(3, flat).unwrap();
    let scene = [Model::from_polygons(positions, RaggedArray::from_lists(squares)).unwrap()];
    let error = SolidBoolean::of(&arranged(&scene), &request("a")).unwrap_err();
    let cure = error.cure().unwrap();
    assert!(cure.contains("--weld 2.23e-16") && cure.contains("--open close"), "{error}");
    // The next shorter radius does not close it, and this one does.
    let weld = |radius: f64| vec![welded(&scene[0], radius).unwrap().0];
    assert!(SolidBoolean::of(&arranged(&weld(2.2e-16)), &request("a")).is_err());
    let merged = arranged(&weld(2.23e-16));
    assert_eq!(merged.complex().f_vector(), [8, 12, 6, 1]);
    assert_eq!(SolidBoolean::of(&merged, &request("a")).unwrap().volume(), Some(1.0));
    let mut within = SpatialRequest::default();
    within.tolerance = Some(2e-15);
    let closed = SceneArrangement::of([("crack", &scene[0])], &within).unwrap();
    assert_eq!(closed.complex().f_vector(), [8, 12, 6, 1]);
    assert!((SolidBoolean::of(&closed, &request("a")).unwrap().volume().unwrap() - 1.0).abs() < 1e-15);
    // Patches close it too, with walls of the height of the crack.
    let mut patched = SpatialScene::of([("crack", &scene[0])], true).unwrap();
    patched.close_mouths().unwrap();
    let patched = SceneArrangement::of_scene(patched, &SpatialRequest::default()).unwrap();
    let volume = SolidBoolean::of(&patched, &request("a")).unwrap().volume().unwrap();
    assert!((volume - 1.0).abs() < 1e-15, "{volume}");
}

#[test]
fn directions_that_disagree_are_told_apart_from_holes() {
    let mut squares = SQUARES;
    squares[5].reverse();
    let model =
        || Model::from_polygons(corners([0.0; 3], [1.0; 3]), RaggedArray::from_lists(squares)).unwrap();
    let scene = arranged(&[model(), cube([0.5; 3], 1.0)]);
    assert_eq!(scene.input_state(0), InputState::Incoherent { edges: 6 });
    let error = SolidBoolean::of(&scene, &request("a | b")).unwrap_err();
    assert!(error.to_string().contains("do not agree in direction"), "{error}");
    let mut odd = request("a | b");
    odd.rule = InsideRule::Odd;
    let result = SolidBoolean::of(&scene, &odd).unwrap();
    assert_eq!(result.volume(), Some(1.875));
    assert_eq!(result.answer().unwrap().files[0].inside_by, Some(InsideMethod::Parity));
}

#[test]
fn volume_meshes_are_the_union_of_their_cells() {
    // A box of two hexahedra, the second listed inside out, and a tetrahedron.
    let flat: Vec<f64> =
        (0..12).flat_map(|i| [f64::from(i / 4), f64::from(i / 2 % 2), f64::from(i % 2)]).collect();
    let hexahedra = RaggedArray::from_lists([[0, 4, 6, 2, 1, 5, 7, 3], [5, 9, 11, 7, 4, 8, 10, 6]]);
    let grid =
        Model::from_cells(Positions::from_flat(3, flat).unwrap(), vec![CellShape::Hexahedron; 2], hexahedra)
            .unwrap();
    let flat = vec![0.5, 0.25, 0.25, 1.5, 0.25, 0.25, 0.5, 0.75, 0.25, 0.5, 0.25, 0.75];
    let tetrahedron = Model::from_cells(
        Positions::from_flat(3, flat).unwrap(),
        vec![CellShape::Tetrahedron],
        RaggedArray::from_lists([[0, 1, 2, 3]]),
    )
    .unwrap();
    let scene = arranged(&[grid, tetrahedron]);
    assert_eq!((scene.input_state(0), scene.input_state(1)), (InputState::Closed, InputState::Closed));
    assert_eq!(scene.complex().cell_count(3), 4);
    let difference = combined(&scene, "a - b");
    assert!((difference.volume().unwrap() - (2.0 - 1.0 / 24.0)).abs() < 1e-15);
    // One solid with a void. The wall between the hexahedra goes, but for its trace on the surface.
    assert_eq!((difference.part_counts(), difference.boundary().walls().len()), ([1, 1], 1));
    assert_eq!(combined(&scene, "b - a").volume(), Some(0.0));
    let sources = difference.provenance().unwrap();
    assert!(sources.polygons.iter().all(|list| {
        let expected = if list[0][0] == 0 { 1 } else { -1 };
        list[0][2] == expected
    }));
}

proptest! {
    /// Boxes with small integer corners: volumes are those of unit cubes, whatever faces, edges and corners they share.
    #[test]
    fn boxes_combine_like_sets_of_unit_cubes(
        places in prop::collection::vec(((0i32..4), (0i32..4), (0i32..4), (1i32..4), (1i32..4), (1i32..4)), 1..5),
        text in prop::sample::select(vec!["a|b|c|d", "a&b", "a-b-c-d", "a^b^c^d", "(a|b)-c&d", "(a^b)&(c|d)"]),
    ) {
        let boxes: Vec<[[i32; 3]; 2]> =
            places.iter().map(|&(x, y, z, u, v, w)| [[x, y, z], [x + u, y + v, z + w]]).collect();
        let models: Vec<Model> =
            (0..4).map(|i| boxes[i % boxes.len()].map(|p| p.map(f64::from))).map(|[low, high]| cuboid(low, high)).collect();
        let scene = arranged(&models);
        let formula = BooleanFormula::parse(text, &[]).unwrap();
        let mut volume = 0.0;
        for i in 0..343 {
            let place = [i / 49, i / 7 % 7, i % 7];
            let is_in = |input: usize| {
                let [low, high] = boxes[input % boxes.len()];
                (0..3).all(|axis| low[axis] <= place[axis] && place[axis] < high[axis])
            };
            volume += f64::from(u8::from(formula.evaluate(is_in)));
        }
        let result = combined(&scene, text);
        // Faces are made of triangles whose sides may cross at thirds, which are rounded: the last bits may be off.
        let slack = 4.0 * f64::EPSILON * volume;
        prop_assert!(result.volume().is_some_and(|found| (found - volume).abs() <= slack), "{:?} {volume}", result.volume());
        prop_assert!(scene.products_are_zero().unwrap());
        let object = result.answer().unwrap();
        prop_assert!(object.closed);
        let is_pinched = object.pinches.edge_count != 0 || object.pinches.vertex_count != 0;
        prop_assert_eq!(object.manifold.verdict, BoundaryVerdict::of(!is_pinched));
        // By the theorem of Gauss the surface encloses the same volume.
        let mesh = result.to_mesh().unwrap();
        let enclosed = coface_geometry::enclosed_volume(mesh.positions(), mesh.polygons());
        prop_assert!((enclosed.unwrap_or(0.0) - volume).abs() < 1e-9);
        // The complement of the complement, and De Morgan.
        for (same, other) in [("a|b", "!(!a&!b)"), ("a-b", "a&!b"), ("a", "(a-b)|(a&b)"), ("(a^b)^c", "a^(b^c)")] {
            let [same, other] = [same, other].map(|text| combined(&scene, text).selection().clone());
            prop_assert_eq!(same, other);
        }
    }
}

/// The models of a folder of real data; the test is skipped without it.
fn data(names: &[&str]) -> Option<Vec<Model>> {
    let Some(folder) = std::env::var_os("COFACE_DATA") else {
        eprintln!("skipped: COFACE_DATA is not set");
        return None;
    };
    let read = |name: &&str| io::read_path(std::path::Path::new(&folder).join(name), None).unwrap();
    Some(names.iter().map(read).collect())
}

#[test]
fn three_cubes_in_one_file_have_seven_cells() {
    let Some(models) = data(&["surfaces/three_cubes.stl"]) else { return };
    let scene = arranged(&models);
    assert_eq!(scene.complex().cell_count(3), 7);
    let numbers: f64 = scene.volumes().iter().sum();
    let union = combined(&scene, "a");
    assert_eq!(union.volume(), Some(numbers));
    assert_eq!(union.answer().unwrap().components, 1);
    assert!((0..7).all(|cell| union.selection().contains(CellId::new(cell))));
    assert!(scene.answer(Default::default()).unwrap().files[0].overlapping_cells > 0);
}

/// Counts and volumes as libigl's exact Booleans find them, with a box that reaches to 3.4e38.
#[test]
fn a_box_of_the_size_of_the_largest_single_precision_number_cuts_a_small_solid() {
    let Some(models) = data(&["surfaces/Cray_left.obj", "surfaces/Cray_right.obj"]) else { return };
    let scene = arranged(&models);
    for (text, volume, area, f_vector, components) in [
        ("a & b", 974446020000.0, 7859152560.0, [214, 636, 424], 1),
        ("a - b", 982418629000.0, 7923164750.0, [262, 780, 520], 1),
        ("a | b", 1.57607997e116, 1.85267321e78, [270, 798, 532], 2),
    ] {
        let mut request = request(text);
        request.triangles = true;
        let result = SolidBoolean::of(&scene, &request).unwrap();
        let object = result.answer().unwrap();
        assert_eq!(result.f_vector(), f_vector, "{text}");
        assert_eq!((object.components, object.manifold.verdict), (components, BoundaryVerdict::Yes));
        for (found, expected) in [(object.measure, volume), (object.area, area)] {
            let found = found.unwrap();
            assert!((found / expected - 1.0).abs() < 1e-8, "{text}: {found} for {expected}");
        }
    }
}

/// A box turned about an axis through the origin, then moved.
fn turned_cuboid(axis: [f64; 3], angle: f64, by: [f64; 3], sides: [f64; 3]) -> Model {
    let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
    let [x, y, z] = axis.map(|x| x / length);
    let (s, c) = angle.sin_cos();
    let t = 1.0 - c;
    let rows = [
        [t * x * x + c, t * x * y - s * z, t * x * z + s * y],
        [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
        [t * x * z - s * y, t * y * z + s * x, t * z * z + c],
    ];
    let flat = corners([0.0; 3], sides)
        .as_flat()
        .as_chunks::<3>()
        .0
        .iter()
        .flat_map(|p| [0, 1, 2].map(|i| rows[i][0] * p[0] + rows[i][1] * p[1] + rows[i][2] * p[2] + by[i]))
        .collect();
    let positions = Positions::from_flat(3, flat).unwrap();
    Model::from_polygons(positions, RaggedArray::from_lists(SQUARES)).unwrap()
}

fn is_near(x: f64, y: f64) -> bool {
    (x - y).abs() < 1e-12
}

#[test]
fn a_turned_box_is_arranged_without_being_asked_in_every_format() {
    let turned = turned_cuboid([1.0, 2.0, -0.7], 0.3, [0.1, 10.2, 0.3], [1.0, 2.0, 0.5]);
    for format in ["obj", "off", "ply", "vtk", "vtp", "mesh", "msh"] {
        let format = io::Format::from_name(format).unwrap();
        let mut bytes = Vec::new();
        io::write(&turned, &mut bytes, format).unwrap();
        let read = io::read(&bytes[..], format).unwrap();
        let scene = arranged(&[read]);
        assert_eq!(scene.complex().f_vector(), [8, 12, 6, 1], "{format:?}");
        let answer = scene.answer(InsideRule::Nonzero).unwrap();
        assert!(answer.split_polygons.count > 0 && answer.remarks.is_empty(), "{:?}", answer.remarks);
        assert!(is_near(answer.measures[0], 1.0));
    }
    // Coordinates of single precision are off by more, and that is rounding too.
    let single = turned.positions().as_flat().iter().map(|&x| f64::from(x as f32)).collect();
    let single = Positions::from_flat(3, single).unwrap();
    let single = Model::from_polygons(single, RaggedArray::from_lists(SQUARES)).unwrap();
    let answer = arranged(&[single]).answer(InsideRule::Nonzero).unwrap();
    assert!(answer.split_polygons.largest_deviation > 1e-9 && answer.remarks.is_empty());
}

#[test]
fn warped_quadrangles_are_split_along_the_shorter_diagonal() {
    // A box with a corner of its lid lifted: the diagonal of the lid through that corner is the longer one.
    let mut flat = corners([0.0; 3], [1.0; 3]).as_flat().to_vec();
    flat[23] = 1.5;
    let lifted =
        Model::from_polygons(Positions::from_flat(3, flat).unwrap(), RaggedArray::from_lists(SQUARES))
            .unwrap();
    let scene = arranged(std::slice::from_ref(&lifted));
    let answer = scene.answer(InsideRule::Nonzero).unwrap();
    assert_eq!(answer.f_vector, [8, 12, 6, 1]);
    // Half of the lid is lifted to the triangle above three corners: a tetrahedron of volume 1/2 * 1/2 / 3.
    assert!(is_near(answer.measures[0], 1.0 + 1.0 / 12.0), "{:?}", answer.measures);
    let remark = &answer.remarks[0];
    assert_eq!((remark.code, remark.count), (RemarkCode::FacesSplit, 1));
    assert_eq!(remark.places[0].cell.as_deref(), Some(&[4, 5, 7, 6][..]));
    assert_eq!(remark.places[0].file.as_deref(), Some("model 0"));
    // Where it is only accepted as rounding, or not at all, it is refused by name.
    for non_planar in [NonPlanar::Rounded, NonPlanar::Refuse] {
        let mut request = SpatialRequest::default();
        request.non_planar = non_planar;
        let error = SceneArrangement::of([("lifted.obj", &lifted)], &request).unwrap_err().to_string();
        assert!(error.contains("lifted.obj: polygon 1 is not planar"), "{error}");
    }
    // The same quadrangle the other way round, from another corner, is split in the same way: nothing lies between.
    let mut reversed = SQUARES;
    reversed.iter_mut().for_each(|square| {
        square.reverse();
        square.rotate_left(1);
    });
    let other = Model::from_polygons(lifted.positions().clone(), RaggedArray::from_lists(reversed)).unwrap();
    assert_eq!(arranged(&[lifted, other]).complex().f_vector(), [8, 12, 6, 1]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Results of Booleans of turned boxes are inputs of the next Boolean, and the laws hold by volume.
    #[test]
    fn turned_boxes_keep_the_laws_of_sets(
        first in (prop::array::uniform3(-1.0f64..1.0), 0.0f64..6.3, prop::array::uniform3(-0.4f64..0.4)),
        second in (prop::array::uniform3(-1.0f64..1.0), 0.0f64..6.3, prop::array::uniform3(-0.4f64..0.4)),
        sides in prop::array::uniform3(0.5f64..2.0),
    ) {
        prop_assume!([first.0, second.0].iter().all(|axis| axis.iter().map(|x| x * x).sum::<f64>() > 0.01));
        let a = turned_cuboid(first.0, first.1, first.2, sides);
        let b = turned_cuboid(second.0, second.1, second.2, [1.0; 3]);
        let scene = arranged(&[a.clone(), b.clone()]);
        // Nothing but that faces cross once their corners are rounded, which `snapped` mends.
        let answer = scene.answer(InsideRule::Nonzero).unwrap();
        prop_assert!(answer.remarks.iter().all(|remark| remark.code == RemarkCode::RoundedInvalid));
        prop_assert_eq!(answer.remarks.is_empty(), answer.rounding.valid);
        let volume = |text: &str| combined(&scene, text).volume().unwrap();
        let volumes = ["a", "b", "a & b", "a - b", "a | b"].map(volume);
        prop_assert!(is_near(volumes[0], sides.iter().product()));
        prop_assert!(is_near(volumes[0] + volumes[1], volumes[2] + volumes[4]));
        // Written, read, and used again, twice.
        let again = |text: &str| {
            let mut bytes = Vec::new();
            io::write(&combined(&scene, text).to_mesh().unwrap(), &mut bytes, io::Format::Obj).unwrap();
            io::read(&bytes[..], io::Format::Obj).unwrap()
        };
        if volumes[2] > 1e-6 {
            let (meet, rest) = (again("a & b"), again("a - b"));
            // A sliver of a result may cross itself once its corners are rounded; that is refused by name, not answered wrongly.
            let is_input = |model: &Model| {
                SceneArrangement::of([("model", model)], &SpatialRequest::default())
                    .map_err(|error| assert!(error.message().contains("is not simple"), "{error}"))
                    .is_ok()
            };
            prop_assume!(is_input(&meet) && is_input(&rest));
            let next = arranged(&[a, meet.clone()]);
            let twice = combined(&next, "a & b");
            prop_assert!(is_near(twice.volume().unwrap(), volumes[2]));
            let joined = arranged(&[meet, rest]);
            prop_assert!(is_near(combined(&joined, "a | b").volume().unwrap(), volumes[0]));
            let twice = twice.to_mesh().unwrap();
            prop_assume!(is_input(&twice));
            let third = arranged(&[twice, b]);
            prop_assert!(is_near(combined(&third, "a & b").volume().unwrap(), volumes[2]));
            prop_assert!(combined(&third, "a - b").volume().unwrap() < 1e-12);
        }
    }
}

/// What is written of solids with quadrangles that are not flat has the volume that was measured, in all formats.
#[test]
fn bent_quadrangles_that_are_cut_keep_the_volume() {
    // A ball of quadrangles, each moved along its radius.
    let count = 8usize;
    let mut text = String::new();
    let mut state = 7u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        0.9 + 0.2 * (state >> 11) as f64 / (1u64 << 53) as f64
    };
    for i in 1..count {
        for j in 0..2 * count {
            let [a, b] = [i, j].map(|k| std::f64::consts::PI * k as f64 / count as f64);
            let r = next();
            let [x, y, z] = [r * a.sin() * b.cos(), r * a.sin() * b.sin(), r * a.cos()];
            text += &format!("v {x:?} {y:?} {z:?}\n");
        }
    }
    text += "v 0 0 1\nv 0 0 -1\n";
    let (around, poles) = (2 * count, 2 * count * (count - 1));
    for j in 0..around {
        let next = (j + 1) % around;
        for i in 0..count - 2 {
            let [a, b] = [i * around, (i + 1) * around];
            text += &format!("f {} {} {} {}\n", a + j + 1, b + j + 1, b + next + 1, a + next + 1);
        }
        let last = (count - 2) * around;
        text += &format!("f {} {} {}\n", poles + 1, j + 1, next + 1);
        text += &format!("f {} {} {}\n", poles + 2, last + next + 1, last + j + 1);
    }
    let ball = coface_io::read(text.as_bytes(), Format::Obj).unwrap();
    let cube = "v -.3 -.2 -2\nv .55 -.2 -2\nv .55 .61 -2\nv -.3 .61 -2\nv -.3 -.2 2\nv .55 -.2 2\nv .55 .61 2\nv -.3 .61 2\n\
        f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    let cube = coface_io::read(cube.as_bytes(), Format::Obj).unwrap();
    let volume = |model: &Model| {
        let scene = SceneArrangement::of([("a", model)], &SpatialRequest::default()).unwrap();
        SolidBoolean::of(&scene, &SolidRequest::of(BooleanFormula::union(1))).unwrap().volume().unwrap()
    };
    let mut request = SpatialRequest::default();
    request.snap = true;
    let both = SceneArrangement::of([("ball", &ball), ("cube", &cube)], &request).unwrap();
    for formula in ["a - b", "b - a", "a & b", "a | b"] {
        for triangles in [false, true] {
            let mut request = SolidRequest::of(BooleanFormula::parse(formula, &[]).unwrap());
            request.triangles = triangles;
            let result = SolidBoolean::of(&both, &request).unwrap();
            let expected = result.volume().unwrap();
            for model in [result.to_mesh().unwrap(), result.to_chains().unwrap()] {
                for format in [Format::Off, Format::Json] {
                    // Meshes are facet lists in JSON, without positions.
                    if (format == Format::Off) == model.structure().is_some() {
                        continue;
                    }
                    let mut bytes = Vec::new();
                    coface_io::write(&model, &mut bytes, format).unwrap();
                    let found = volume(&coface_io::read(&bytes[..], format).unwrap());
                    assert!(
                        (found - expected).abs() < 1e-12 * 10.0,
                        "{formula} {triangles} {format:?}: {found} {expected}"
                    );
                }
            }
        }
    }
    // What is not cut stays a quadrangle.
    let whole = SceneArrangement::of([("ball", &ball)], &SpatialRequest::default()).unwrap();
    assert_eq!(whole.complex().cell_count(2), ball.polygons().len());
}
