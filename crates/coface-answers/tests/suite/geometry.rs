//! What reports say about faces in space.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_answers::answer::RemarkCode;
use coface_answers::{GeometryCheck, GeometryFacts, GeometryUnchecked, Report, ReportRequest, text};
use coface_io::Format;

fn off(points: &[[f64; 3]], faces: &[&[u32]]) -> String {
    let mut text = format!("OFF\n{} {} 0\n", points.len(), faces.len());
    for [x, y, z] in points {
        text += &format!("{x} {y} {z}\n");
    }
    for face in faces {
        let list: Vec<String> = face.iter().map(u32::to_string).collect();
        text += &format!("{} {}\n", face.len(), list.join(" "));
    }
    text
}

fn report(file: &str) -> Report {
    Report::of(coface_io::read(file.as_bytes(), Format::Off).unwrap()).unwrap()
}

fn page(report: &Report) -> String {
    text::report("f.off", "OFF", report, 5)
}

const CUBE: [[f64; 3]; 8] = [
    [0., 0., 0.],
    [1., 0., 0.],
    [0., 1., 0.],
    [1., 1., 0.],
    [0., 0., 1.],
    [1., 0., 1.],
    [0., 1., 1.],
    [1., 1., 1.],
];
const SIDES: [&[u32]; 6] =
    [&[0, 2, 3, 1], &[4, 5, 7, 6], &[0, 1, 5, 4], &[2, 6, 7, 3], &[0, 4, 6, 2], &[1, 3, 7, 5]];

/// A cube with a roof whose tip is at this height.
fn house(tip: f64) -> String {
    let points: Vec<[f64; 3]> = CUBE.into_iter().chain([[0.5, 0.5, tip]]).collect();
    let roof: [&[u32]; 4] = [&[4, 5, 8], &[5, 7, 8], &[7, 6, 8], &[6, 4, 8]];
    let faces: Vec<&[u32]> =
        SIDES.iter().enumerate().filter(|side| side.0 != 1).map(|side| *side.1).chain(roof).collect();
    off(&points, &faces)
}

#[test]
fn a_sound_solid_has_no_problems() {
    let found = report(&house(1.5));
    let answer = found.answer(10).geometry.unwrap();
    assert_eq!((answer.checked, answer.sound_surface, answer.valid_solid), (true, Some(true), Some(true)));
    assert!(page(&found).contains("No problems found."), "{}", page(&found));
}

#[test]
fn faces_that_cross_are_a_problem_with_places() {
    let found = report(&house(-0.5));
    let answer = found.answer(10);
    let problem = &answer.problems[0];
    assert_eq!((&problem.kind[..], problem.count, problem.points.len()), ("faces_cross", 4, 4));
    let geometry = answer.geometry.unwrap();
    let fault = &geometry.faults[0];
    assert_eq!((fault.code, &fault.name[..], &fault.of[..], fault.count), (306, "faces_cross", "surface", 4));
    // The floor, face 0, and each side of the roof.
    assert!(fault.places.iter().all(|place| place.faces[0] == 0), "{fault:?}");
    assert!(fault.places.iter().all(|place| place.point.is_some_and(|point| point[2].abs() < 1e-12)));
    assert_eq!((geometry.sound_surface, geometry.valid_solid), (Some(false), Some(false)));
    let remark = answer.remarks.iter().find(|remark| remark.code == RemarkCode::GeometryFault).unwrap();
    assert_eq!((remark.count, &remark.message[..]), (4, "4 pairs of faces cross (ISO 19107 code 306)"));
    let page = page(&found);
    assert!(page.contains("code 306") && page.contains("f0"), "{page}");
    assert!(!page.contains("No problems found"), "{page}");
}

/// What only keeps a surface from bounding a solid is no remark, and no praise either.
#[test]
fn an_open_surface_is_sound_and_no_solid() {
    let found = report(&off(&CUBE, &SIDES[..5]));
    assert!(found.answer(10).problems.is_empty());
    let geometry = found.answer(10).geometry.unwrap();
    assert_eq!((geometry.sound_surface, geometry.valid_solid), (Some(true), Some(false)));
    assert_eq!((geometry.faults[0].code, &geometry.faults[0].of[..]), (302, "solid"));
    assert!(found.remarks().is_empty() && found.warnings().is_empty());
    let page = page(&found);
    assert!(page.contains("The surface has no faults.") && page.contains("code 302"), "{page}");
    assert!(!page.contains("No problems found"), "{page}");
}

#[test]
fn what_is_not_checked_says_so() {
    let read = || coface_io::read(house(-0.5).as_bytes(), Format::Off).unwrap();
    let found = Report::answering(read(), &ReportRequest::new().geometry(GeometryCheck::Never)).unwrap();
    assert_eq!(found.geometry(), Some(&GeometryFacts::Unchecked(GeometryUnchecked::NotWanted)));
    let own = page(&found);
    assert!(own.contains("The geometry is not checked") && own.contains("--check geometry"), "{own}");
    assert!(!own.contains("No problems found"), "{own}");
    let four = "4OFF\n3 1 0\n0 0 0 0\n1 0 0 0\n0 1 0 1\n3 0 1 2\n";
    let found = report(four);
    assert_eq!(found.geometry(), Some(&GeometryFacts::Unchecked(GeometryUnchecked::Coordinates(4))));
    assert!(page(&found).contains("the points have 4 coordinates"), "{}", page(&found));
}

/// The reader corrects rings; what it corrected is a fault of the file all the same.
#[test]
fn what_the_reader_corrects_has_its_code() {
    let twice = house(1.5).replace("4 0 2 3 1", "5 0 2 2 3 1");
    let geometry = report(&twice).answer(10).geometry.unwrap();
    assert_eq!(geometry.faults.iter().map(|fault| fault.code).collect::<Vec<_>>(), [102]);
    let mut sides = SIDES;
    sides[1] = &[4, 7, 4];
    let geometry = report(&off(&CUBE, &sides)).answer(10).geometry.unwrap();
    assert_eq!(geometry.faults.iter().map(|fault| fault.code).collect::<Vec<_>>(), [101, 302]);
}

/// A face that is there twice is counted once, and named.
#[test]
fn a_repeated_face_overlaps_itself() {
    let sides: Vec<&[u32]> = SIDES.iter().copied().chain([SIDES[0]]).collect();
    let fault = &report(&off(&CUBE, &sides)).answer(10).geometry.unwrap().faults[0];
    assert_eq!((&fault.name[..], fault.count, &fault.places[0].faces[..]), ("faces_overlap", 1, &[0, 6][..]));
}
