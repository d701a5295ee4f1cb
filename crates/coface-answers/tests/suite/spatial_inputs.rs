//! Objects, groups and components of a file as inputs in space.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::Error;
use coface_answers::answer::RemarkCode;
use coface_answers::{
    PlanarDrawing, RegionSource, SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest, SpatialScene,
};
use coface_arrange::boolean::BooleanFormula;
use coface_io::{Format, Model};
use std::fmt::Write;

const SIDES: [[usize; 4]; 6] =
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/// Appends a box from one corner to another, as quadrangles that run counterclockwise seen from outside; the last
/// `left_out` are not there.
fn push_box(text: &mut String, low: [f64; 3], high: [f64; 3], first: usize, left_out: usize) {
    for corner in 0..8 {
        let at = |axis: usize| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] };
        writeln!(text, "v {:?} {:?} {:?}", at(0), at(1), at(2)).unwrap();
    }
    for side in &SIDES[..6 - left_out] {
        let [a, b, c, d] = side.map(|corner| first + corner + 1);
        writeln!(text, "f {a} {b} {c} {d}").unwrap();
    }
}

/// Boxes as one OBJ, each behind this statement with its number.
fn boxes(statement: &str, boxes: &[[[f64; 3]; 2]]) -> String {
    let mut text = String::new();
    for (number, &[low, high]) in boxes.iter().enumerate() {
        writeln!(text, "{statement} box_{number}").unwrap();
        push_box(&mut text, low, high, 8 * number, 0);
    }
    text
}

fn obj(text: &str) -> Model {
    coface_io::read(text.as_bytes(), Format::Obj).unwrap()
}

fn scene(text: &str, source: RegionSource) -> Result<SpatialScene, Error> {
    SpatialScene::with_inputs([("house.obj", &obj(text))], source, true)
}

fn arranged(text: &str, source: RegionSource) -> SceneArrangement {
    SceneArrangement::of_scene(scene(text, source).unwrap(), &SpatialRequest::default()).unwrap()
}

const PAIR: [[[f64; 3]; 2]; 2] = [[[0.0; 3], [2.0; 3]], [[1.0; 3], [3.0; 3]]];

#[test]
fn objects_of_one_file_are_inputs_like_files() {
    let one = |number: usize| {
        let mut text = String::new();
        push_box(&mut text, PAIR[number][0], PAIR[number][1], 0, 0);
        obj(&text)
    };
    let files = SceneArrangement::of([("a", &one(0)), ("b", &one(1))], &SpatialRequest::default()).unwrap();
    let expected = files.answer(Default::default()).unwrap();
    for (statement, source) in
        [("o", RegionSource::Objects), ("g", RegionSource::Groups), ("#", RegionSource::Components)]
    {
        let found = arranged(&boxes(statement, &PAIR), source).answer(Default::default()).unwrap();
        assert_eq!((&found.measures, &found.inside), (&expected.measures, &expected.inside), "{statement}");
        let names = match source {
            RegionSource::Components => ["house.obj#0", "house.obj#1"],
            _ => ["box_0", "box_1"],
        };
        assert_eq!(found.regions, names);
        assert_eq!(found.files[1].name.as_deref(), Some(names[1]));
        assert_eq!(found.files[1].file, "house.obj");
        let inputs = found.inputs_of_faces.unwrap();
        assert_eq!(inputs.len(), found.f_vector[2]);
        // Each box has 3 faces outside of the other one, which are cut, and 3 whole ones.
        assert_eq!([0, 1].map(|input| inputs.iter().filter(|list| **list == [input]).count()), [9, 9]);
        assert!(found.remarks.is_empty());
    }
}

#[test]
fn a_formula_combines_objects() {
    let formula = |text: &str| SolidRequest::of(BooleanFormula::parse(text, &[]).unwrap());
    let scene = arranged(&boxes("o", &PAIR), RegionSource::Objects);
    for (text, volume) in [("a & b", 1.0), ("a - b", 7.0), ("a | b", 15.0), ("a ^ b", 14.0)] {
        let result = SolidBoolean::of(&scene, &formula(text)).unwrap();
        assert_eq!(result.volume(), Some(volume), "{text}");
        let names: Vec<String> =
            result.to_mesh().unwrap().groups().iter().map(|group| group.name().to_owned()).collect();
        assert_eq!(names, ["box_0", "box_1"]);
    }
}

#[test]
fn a_polygon_may_be_in_several_groups_and_in_none() {
    // A wall that two groups have, and one polygon behind an empty `g`.
    let mut text = String::from("g left whole\n");
    push_box(&mut text, [0.0; 3], [1.0; 3], 0, 0);
    text += "g right whole\n";
    push_box(&mut text, [1.0, 0.0, 0.0], [2.0, 1.0, 1.0], 8, 0);
    text += "g\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 17 18 19\n";
    let scene = scene(&text, RegionSource::Groups).unwrap();
    assert_eq!(scene.names(), ["left", "whole", "right", "house.obj"]);
    assert_eq!(scene.polygon_count(), 6 + 12 + 6 + 1);
    assert_eq!(scene.remarks().len(), 1);
    assert_eq!(scene.remarks()[0].code, RemarkCode::UnnamedInput);
    let answer = SceneArrangement::of_scene(scene, &SpatialRequest::default()).unwrap();
    let answer = answer.answer(Default::default()).unwrap();
    assert_eq!((answer.measures, answer.inside), (vec![1.0; 2], vec![vec![0, 1], vec![1, 2]]));
    assert_eq!(answer.files.iter().map(|file| file.closed).collect::<Vec<_>>(), [true, true, true, false]);
}

#[test]
fn wrong_inputs_are_named() {
    let mut text = boxes("o", &PAIR);
    text += "o nothing\n";
    let empty = scene(&text, RegionSource::Objects).unwrap();
    assert_eq!(empty.names().len(), 3);
    assert_eq!(empty.remarks()[0].code, RemarkCode::EmptyInput);
    assert_eq!(empty.remarks()[0].message, "house.obj: object \"nothing\" has no polygons and is empty");
    let error = scene(&text, RegionSource::Groups).unwrap_err().to_string();
    assert!(error.contains("no groups") && error.contains("--inputs objects"), "{error}");
    let bare = boxes("#", &PAIR);
    let error = scene(&bare, RegionSource::Objects).unwrap_err().to_string();
    assert!(error.starts_with("house.obj") && error.contains("--inputs components"), "{error}");
    // An open object among closed ones.
    text += "o shed\n";
    push_box(&mut text, [9.0; 3], [10.0; 3], 16, 1);
    let open = arranged(&text, RegionSource::Objects);
    let request = SolidRequest::of(BooleanFormula::union(4));
    let error = SolidBoolean::of(&open, &request).unwrap_err().to_string();
    assert!(error.contains("house.obj: object \"shed\"") && error.contains("open along 4 edges"), "{error}");
}

#[test]
fn objects_are_inputs_where_a_file_is_too_few() {
    let text = obj(&boxes("o", &PAIR));
    let scene = |count| SpatialScene::of_at_least(count, [("two.obj", &text)], true).unwrap();
    assert_eq!([0, 1, 2, 3].map(|count| scene(count).names().len()), [1, 1, 2, 1]);
    assert!(scene(2).remarks()[0].message.contains("each of its 2 objects is an input"));
    assert!(scene(1).remarks()[0].message.contains("--inputs objects"));
    assert!(!scene(1).remarks()[0].code.is_assumption());
    let single = obj(&boxes("o", &PAIR[..1]));
    assert!(SpatialScene::of_at_least(1, [("one.obj", &single)], true).unwrap().remarks().is_empty());
}

#[test]
fn groups_of_cells_and_names_of_several_files_are_told_apart() {
    // Two tetrahedra on a common face, each a physical group.
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 1 \"up\"\n3 2 \"down\"\n$EndPhysicalNames\n\
        $Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 6\n5 0 0 -12\n$EndNodes\n\
        $Elements\n2\n1 4 2 1 1 1 2 3 4\n2 4 2 2 2 1 3 2 5\n$EndElements\n";
    let mesh = coface_io::read(text.as_bytes(), Format::Msh).unwrap();
    for source in [RegionSource::Groups, RegionSource::Components] {
        let scene = SpatialScene::with_inputs([("m.msh", &mesh)], source, true).unwrap();
        let answer = SceneArrangement::of_scene(scene, &SpatialRequest::default()).unwrap();
        let answer = answer.answer(Default::default()).unwrap();
        let mut volumes = answer.measures.clone();
        volumes.sort_by(f64::total_cmp);
        assert_eq!(volumes, [1.0, 2.0]);
        match source {
            RegionSource::Groups => {
                assert_eq!(answer.regions, ["up", "down"]);
                assert!(answer.inside.iter().all(|inside| inside.len() == 1));
            }
            _ => assert_eq!((answer.regions.len(), &answer.inside[..]), (1, &[vec![0], vec![0]][..])),
        }
    }
    let scene = SpatialScene::with_inputs([("m", &mesh), ("n", &mesh)], RegionSource::Groups, true).unwrap();
    assert_eq!(scene.names(), ["m#up", "m#down", "n#up", "n#down"]);
    // What is written is read again, and its components are the cells that do not touch.
    let far = [PAIR[0], [[9.0; 3], [10.0; 3]]];
    let chains = arranged(&boxes("o", &far), RegionSource::Objects).to_chains(false).unwrap();
    let again = SpatialScene::with_inputs([("c.json", &chains)], RegionSource::Components, true).unwrap();
    let answer = SceneArrangement::of_scene(again, &SpatialRequest::default()).unwrap();
    let answer = answer.answer(Default::default()).unwrap();
    assert_eq!(answer.regions, ["c.json#0", "c.json#1"]);
    assert_eq!(answer.inside, [[0], [1]]);
}

#[test]
fn groups_and_components_are_regions_of_the_plane() {
    let square = |x: f64, first: usize| {
        let [a, b, c, d] = [1, 2, 3, 4].map(|corner| corner + first);
        let z = x + 2.0;
        format!("v {x} 0 0\nv {z} 0 0\nv {z} 2 0\nv {x} 2 0\nf {a} {b} {c} {d}\n")
    };
    let text = format!("o left\n{}o right\n{}", square(0.0, 0), square(1.0, 4));
    let model = obj(&text);
    let names = |source| {
        let drawing = PlanarDrawing::new([("f", &model)], source)?;
        Ok::<_, Error>(drawing.region_names().into_iter().map(str::to_owned).collect::<Vec<_>>())
    };
    assert_eq!(names(RegionSource::Objects).unwrap(), ["left", "right"]);
    assert_eq!(names(RegionSource::Components).unwrap(), ["f#0", "f#1"]);
    assert!(names(RegionSource::Groups).unwrap_err().to_string().contains("--inputs objects"));
}

/// Walls of a grid of rooms: each overlaps those that it crosses.
fn walls(count: usize) -> String {
    let of = |i: usize| {
        let at = (i / 2) as f64 * 10.0 + 0.3;
        match i % 2 {
            0 => [[at, at - 3.0, 0.0], [at + 0.2, at + 12.0, 2.5]],
            _ => [[at - 3.0, at, 0.0], [at + 12.0, at + 0.2, 2.5]],
        }
    };
    boxes("o", &(0..count).map(of).collect::<Vec<_>>())
}

#[test]
fn walls_of_one_file_are_inputs() {
    let answer = arranged(&walls(500), RegionSource::Objects).answer(Default::default()).unwrap();
    assert_eq!(answer.regions.len(), 500);
    assert!(answer.inside.iter().any(|inside| inside.len() == 2), "walls cross");
}

/// The faces between cells are in the groups of both, in one direction: each group is a solid still, and what a formula does not
/// name may be open.
#[test]
fn groups_of_cells_are_solids_in_any_direction() {
    let mut text = boxes("o", &PAIR);
    text += "o shed\n";
    push_box(&mut text, [9.0; 3], [10.0; 3], 16, 1);
    let rooms = arranged(&text, RegionSource::Objects);
    let mesh = rooms.to_mesh(false, true).unwrap();
    let cells = SpatialScene::with_inputs([("cells.obj", &mesh)], RegionSource::Groups, true).unwrap();
    assert_eq!(&cells.names()[..3], ["cell_0", "cell_1", "cell_2"]);
    let again = SceneArrangement::of_scene(cells, &SpatialRequest::default()).unwrap();
    for (cell, volume) in rooms.volumes().iter().enumerate() {
        let formula = BooleanFormula::parse(&cell.to_string(), &[]).unwrap();
        let result = SolidBoolean::of(&again, &SolidRequest::of(formula)).unwrap();
        assert_eq!(result.volume(), Some(*volume), "cell {cell}");
        let answer = result.answer().unwrap();
        let is_parity = |file: &coface_answers::answer::SpatialInput| {
            file.inside_by == Some(coface_answers::answer::InsideMethod::Parity)
        };
        let by_parity = answer.files.iter().filter(|file| is_parity(file)).count();
        let said = answer.remarks.iter().filter(|remark| remark.code == RemarkCode::ReversedInput).count();
        assert!(by_parity > 0 && said > 0, "{by_parity} {said}");
    }
}

/// Faces that are there in both directions enclose nothing, which is said.
#[test]
fn what_cancels_is_said() {
    let mut text = String::new();
    push_box(&mut text, [0.0; 3], [1.0; 3], 0, 0);
    let reversed: Vec<String> = SIDES
        .iter()
        .map(|side| {
            let [a, b, c, d] = side.map(|corner| corner + 1);
            format!("f {d} {c} {b} {a}\n")
        })
        .collect();
    text += &reversed.concat();
    let scene = arranged(&text, RegionSource::Models);
    let request = SolidRequest::of(BooleanFormula::union(1));
    let answer = SolidBoolean::of(&scene, &request).unwrap().answer().unwrap();
    assert_eq!(answer.measure, Some(0.0));
    assert_eq!(answer.remarks[0].code, RemarkCode::EmptyInput);
    assert!(answer.remarks[0].message.contains("encloses nothing"), "{}", answer.remarks[0].message);
}

/// A ball whose triangles have vertices of their own, moved a little: the radius within which they are merged is named, however many
/// there are, and patches are no cure.
#[test]
fn loose_triangles_are_to_be_merged() {
    for count in [6usize, 24] {
        let point = |i: usize, j: usize| {
            let (a, b) = (i as f64 / count as f64, j as f64 / count as f64);
            let (a, b) = (a * std::f64::consts::PI, 2.0 * b * std::f64::consts::PI);
            match i {
                0 => [0.0, 0.0, 1.0],
                _ if i == count => [0.0, 0.0, -1.0],
                _ => [a.sin() * b.cos(), a.sin() * b.sin(), a.cos()],
            }
        };
        let (mut text, mut corners) = (String::new(), 0usize);
        let mut push = |own: [[f64; 3]; 3]| {
            for (k, point) in own.into_iter().enumerate() {
                let moved = 1e-7 * ((corners + k) % 7) as f64 / 7.0;
                writeln!(text, "v {:?} {:?} {:?}", point[0] + moved, point[1] - moved, point[2]).unwrap();
            }
            writeln!(text, "f {} {} {}", corners + 1, corners + 2, corners + 3).unwrap();
            corners += 3;
        };
        for i in 0..count {
            for j in 0..count {
                let next = (j + 1) % count;
                if i > 0 {
                    push([point(i, j), point(i + 1, j), point(i, next)]);
                }
                if i + 1 < count {
                    push([point(i, next), point(i + 1, j), point(i + 1, next)]);
                }
            }
        }
        let model = obj(&text);
        let arranged = SceneArrangement::of([("ball", &model)], &SpatialRequest::default()).unwrap();
        let error = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::union(1))).unwrap_err();
        let message = error.to_string();
        let radius = message.split("--weld ").nth(1).and_then(|rest| rest.split(')').next()).unwrap();
        let radius: f64 = radius.parse().unwrap();
        assert!(radius > 1e-8 && radius < 1e-6, "{message}");
        let mut scene = SpatialScene::of([("ball", &model)], true).unwrap();
        let refused = scene.close_mouths().unwrap_err().to_string();
        assert!(refused.contains("enclose nothing") && refused.contains("--weld"), "{refused}");
    }
}
