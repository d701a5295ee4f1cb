//! Round trips and faults of boundaries, without sets.

use super::*;
use crate::{Format, ReadOptions, lines_text, read_boundary};
use coface_yin::{Curve, EndCondition, Order};
use proptest::prelude::*;

fn json(text: &str) -> Result<BoundaryDrawing, coface_algebra::Error> {
    read_boundary(text.as_bytes(), Format::Json, &ReadOptions::default())
}

#[test]
fn all_keys_of_json_are_kept() {
    let drawing = json(
        r#"{"name": "x", "next_vertex": 9, "order": 4, "more": {"a": [1]}, "curves": [{"kinks": [2, 0], "vertices": [8, 3],
        "points": [[0, 0], [1, 0], [0, 1]], "name": "a", "other": null}]}"#,
    )
    .unwrap();
    let curve = &drawing.curves()[0];
    assert_eq!(
        (curve.kinks(), curve.kink_names(), curve.name()),
        (&[2, 0][..], Some(&[8, 3][..]), Some("a"))
    );
    assert_eq!(
        (drawing.order(), drawing.next_kink_name(), drawing.groups().len()),
        (Order::CUBIC, Some(9), 1)
    );
    assert!(!curve.has_pieces());
    let with_controls = json(
        r#"{"order": 4, "curves": [{"knots": [0, 2, 3], "controls": [[0, 0], [1, -1], [2, -1], [3, 0], [2, 1], [1, 1]]}]}"#,
    )
    .unwrap();
    let curve = with_controls.curves()[0].curve(Order::CUBIC, &EndCondition::NotAKnot).unwrap();
    assert_eq!(curve.piece(1), [[3., 0.], [2., 1.], [1., 1.], [0., 0.]]);
    assert_eq!(curve.knots(), [0., 2., 3.]);
    assert!(json(r#"{"plane": true, "order": 4}"#).unwrap().is_plane());
    assert!(json(r#"{"curves": []}"#).unwrap().groups().is_empty());
}

#[test]
fn faults_of_json_have_line_and_cure() {
    for (text, message) in [
        (r#""vertices": [1]"#, "1 names for 0 kinks"),
        (r#""kinks": [0, 1], "vertices": [4, 4]"#, "two kinks have the name 4"),
        (r#""kinks": [0], "vertices": [7]"#, "\"next_vertex\" is 5"),
        (r#""kinks": [0.5]"#, "is 0.5"),
        (r#""knots": [0, 1]"#, "2 knots for 3 points"),
        (r#""controls": [[0, 0]]"#, "1 control points for 3 points"),
        (r#""controls": [[0, 0], [1, 0], [0, 2]]"#, "point 2 of curve 0 is not the control point 2"),
        (r#""points": 5"#, "expected a list"),
    ] {
        let text = format!(
            "{{\"next_vertex\": 5,\n\"curves\": [{{\"points\": [[0, 0], [1, 0], [0, 1]],\n {text}}}]}}"
        );
        let error = json(&text).unwrap_err();
        assert!(error.to_string().contains(message), "{message}: {error}");
        assert!(error.line().is_some() && error.cure().is_some(), "{error}");
    }
    let error = json(r#"{"facets": [[0, 1]], "curves": []}"#).unwrap_err();
    assert!(error.to_string().contains("more than one"), "{error}");
}

#[test]
fn keys_without_a_meaning_are_told() {
    let drawing =
        json(r#"{"Order": 4, "curves": [{"points": [[0, 0], [1, 0], [0, 1]], "kink": [0]}]}"#).unwrap();
    assert!(drawing.remarks()[0].message.contains("\"Order\""), "{:?}", drawing.remarks());
    assert!(drawing.remarks()[1].message.contains("\"kink\" of curve 0"), "{:?}", drawing.remarks());
    assert!(json(r#"{"plane": true, "oder": 4}"#).unwrap().remarks()[0].message.contains("\"oder\""));
    for (text, message) in [
        (
            r#"{"curves": [{"points": [[0, 0], [1, 0], [0, 1]], "name": 3}]}"#,
            "\"name\" of curve 0 is no text",
        ),
        (r#"{"curves": [{"points": [[0, 0], [1, "x"], [0, 1]]}]}"#, "point 1 of curve 0 is \"x\""),
        (r#"{"curves": [{"points": [[0, 0], [1, 0], [null, 1]]}]}"#, "point 2 of curve 0 is null"),
        (r#"{"curves": [{"points": [[0, 0], [1, NaN], [0, 1]]}]}"#, "no NaN"),
    ] {
        let error = json(text).unwrap_err();
        assert!(error.to_string().contains(message) && error.line() == Some(1), "{error}");
    }
}

/// What Boolean operations cut out of pieces is read with the pieces that it was cut out of, and left out with a remark where it is not
/// part of them.
#[test]
fn carriers_of_pieces_are_kept() {
    let set = |corners: &[[f64; 2]]| {
        coface_yin::YinSet::new(&[Curve::polyline(corners).unwrap().raised(Order::CUBIC).unwrap()]).unwrap()
    };
    let triangle = set(&[[0., 0.], [3., 1.], [1., 2.], [0., 0.]]);
    let half = triangle.meet(&set(&[[1., -1.], [9., -1.], [9., 9.], [1.7, 9.], [1., -1.]])).unwrap();
    let mut text = Vec::new();
    write_json(&half, &[], &mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    let drawing = json(&text).unwrap();
    let read = drawing.curves()[0].curve(Order::CUBIC, &EndCondition::NotAKnot).unwrap();
    assert!(drawing.remarks().is_empty() && half.curve(0).carriers().len() > 1);
    assert_eq!((read.carriers(), &read), (half.curve(0).carriers(), &half.curve(0)));
    for changed in [text.replace("\"growth\":", "\"growth\":-"), text.replace("\"piece\":0", "\"piece\":7")] {
        let drawing = json(&changed).unwrap();
        let read = drawing.curves()[0].curve(Order::CUBIC, &EndCondition::NotAKnot).unwrap();
        assert!(drawing.remarks()[0].message.contains("\"carriers\" of curve 0"), "{:?}", drawing.remarks());
        assert_eq!((read.carriers().len(), &read), (0, &half.curve(0)));
    }
    assert!(json(&text.replace("\"growth\":", "\"grows\":")).unwrap_err().cure().is_some());
}

/// Files that are cut off at any byte, or have any byte changed, are read or refused with a place.
#[test]
fn damaged_files_are_no_panic() {
    let circle = Curve::circle([0.25, 0.5], 0.125, 4, Order::CUBIC).unwrap();
    let set = coface_yin::YinSet::new(&[circle]).unwrap();
    let mut file = Vec::new();
    write_dat(&set, &mut file).unwrap();
    for length in 0..file.len() {
        let error = read_dat(&file[..length]).unwrap_err();
        assert_eq!(
            (error.kind(), error.cure().is_some()),
            (coface_algebra::ErrorKind::Parse, true),
            "{length}: {error}"
        );
        let said = error.to_string();
        assert!(said.contains(&format!("byte {length}")) || said.contains("are left"), "{length}: {said}");
    }
    assert!(read_dat(&[&file[..], b"x"].concat()[..]).unwrap_err().to_string().contains("goes on"));
    for at in 0..file.len() {
        for flip in [0x01, 0x80, 0xff] {
            let mut damaged = file.clone();
            damaged[at] ^= flip;
            if let Err(error) = read_dat(&damaged[..]) {
                assert!(error.cure().is_some(), "{at}: {error}");
            }
        }
    }
    let mut text = Vec::new();
    write_json(&set, &[Some("drop".to_owned())], &mut text).unwrap();
    let whole = text.trim_ascii_end().len();
    for length in 0..whole {
        let error = read_boundary(&text[..length], Format::Json, &ReadOptions::default()).unwrap_err();
        assert!(error.cure().is_some(), "{length}: {error}");
    }
    let lines = b"1e-9\nCircle 0.5 0.5 0.25 1 0.3\nOrientedJordanCurve 3 0 0 1 0 0 1 0 0 2\n";
    for length in 0..lines.len() {
        if let Err(error) = read_factories(&lines[..length]) {
            assert!(error.cure().is_some() && error.line().is_some(), "{length}: {error}");
        }
    }
}

#[test]
fn lines_become_rings_if_they_are_closed() {
    let read = |text: &str| drawing_of_model(&lines_text::read(text.as_bytes()).unwrap());
    // Two triangles with a common corner, in any order and direction.
    let text = "0,0,1,0\n0,1,0,0\n-1,0,0,0\n1,0,0,1\n0,0,-1,-1\n-1,-1,-1,0\n";
    let drawing = read(text).unwrap();
    let counts: usize = drawing.curves().iter().map(|curve| curve.points().len()).sum();
    assert_eq!((counts, drawing.curves().len()), (6, 2));
    assert_eq!(read("0,0,1,0\n1,0,1,1\n").unwrap_err().kind(), coface_algebra::ErrorKind::NotACycle);
    assert!(drawing_of_model(&crate::Model::default()).unwrap().curves().is_empty());
}

#[test]
fn paths_keep_their_curves() {
    let read = |inner: &str| {
        let text = format!("<svg xmlns='http://www.w3.org/2000/svg'>{inner}</svg>");
        read_boundary(text.as_bytes(), Format::Svg, &ReadOptions::default()).unwrap()
    };
    let curve = |drawing: &BoundaryDrawing| {
        drawing.curves()[0].curve(drawing.order(), &EndCondition::NotAKnot).unwrap()
    };
    let drawing = read("<path d='M0 0C1 -1 2 -1 3 0L3 3H0Z'/>");
    assert_eq!((drawing.order(), drawing.groups().len()), (Order::CUBIC, 1));
    let cubic = curve(&drawing);
    assert_eq!(cubic.piece_count(), 4);
    assert_eq!(cubic.piece(0), [[0., 0.], [1., -1.], [2., -1.], [3., 0.]]);
    assert_eq!(cubic.piece(1), [[3., 0.], [3., 1.], [3., 2.], [3., 3.]]);
    assert_eq!(cubic.piece(3), [[0., 3.], [0., 2.], [0., 1.], [0., 0.]]);
    // A quadratic is a cubic: two thirds of the way to its control point.
    let quadratic = curve(&read("<path transform='scale(3)' d='M0 0Q1 -1 2 0L1 1Z'/>"));
    assert_eq!(quadratic.piece(0), [[0., 0.], [2., -2.], [4., -2.], [6., 0.]]);
    // A loop in one cubic is divided in the middle; nothing has no length.
    let drop = curve(&read("<path d='M0 0L0 0C-4 4 4 4 0 0Z'/>"));
    assert_eq!((drop.piece_count(), drop.knot_point(1)), (2, [0., 3.]));
    // Lines alone have order 2.
    let square = read("<rect width='2' height='1'/>");
    assert_eq!((square.order(), square.curves()[0].points().len()), (Order::LINEAR, 4));
    assert!(square.curves()[0].kinks().is_empty());
    // Arcs are as near as is said, and exact at the ends of the axes.
    let disk = read("<circle cx='1' r='2'/>");
    let circle = curve(&disk);
    assert!(disk.remarks()[0].message.starts_with("arcs became cubics"));
    let quarter = circle.piece_count() / 4;
    assert_eq!(
        [0, 1, 2, 3].map(|i| circle.knot_point(i * quarter)),
        [[3., 0.], [1., 2.], [-1., 0.], [1., -2.]]
    );
    for corner in flattened(&circle, 1e-11).unwrap() {
        let off = (corner[0] - 1.0).hypot(corner[1]) - 2.0;
        assert!((-1e-15..2e-9).contains(&off), "{off}");
    }
    // What is not filled is passed over.
    assert_eq!(read("<path fill='none' d='M0 0L1 1'/><line x2='1'/>").curves().len(), 0);
    let passed_over = "<g fill='none'><path d='M0 0h1v1z'/><path fill='red' d='M5 5h1v1z'/></g>";
    assert_eq!((read(passed_over).curves().len(), read(passed_over).curves()[0].points()[0]), (1, [5., 5.]));
    // Where nothing is filled, closed outlines are what is drawn.
    let outlines = read("<path fill='none' d='M0 0h1v1z'/><path fill='none' d='M0 0L1 1'/>");
    assert_eq!(outlines.curves().len(), 1);
    let said = outlines.remarks().iter().map(|remark| &remark.message[..]).collect::<Vec<_>>().join("; ");
    assert!(
        said.contains("nothing is filled: 1 closed outline") && said.contains("1 element is not"),
        "{said}"
    );
}

#[test]
fn chords_are_as_near_as_asked() {
    let controls = vec![[0., 0.], [2., 4.], [5., -3.], [6., 1.]];
    let curve = Curve::from_controls(Order::CUBIC, controls.clone(), vec![0., 1.]).unwrap();
    let mut closed = controls.clone();
    closed.extend([[6., 1.], [0., 0.], [0., 0.]]);
    for tolerance in [1e-1, 1e-3, 1e-5] {
        let chords = flattened(&curve, tolerance).unwrap();
        let mut ends = chords.clone();
        ends.push([6., 1.]);
        // Points of the curve are within the tolerance of some chord.
        for i in 0..500 {
            let t = f64::from(i) / 499.0;
            let mut level = controls.clone();
            while level.len() > 1 {
                level = level
                    .windows(2)
                    .map(|p| [0, 1].map(|axis| p[0][axis] * (1. - t) + p[1][axis] * t))
                    .collect();
            }
            let [x, y] = level[0];
            let distance = ends
                .windows(2)
                .map(|p| {
                    let [dx, dy] = [p[1][0] - p[0][0], p[1][1] - p[0][1]];
                    let s = ((x - p[0][0]) * dx + (y - p[0][1]) * dy) / (dx * dx + dy * dy);
                    let s = s.clamp(0., 1.);
                    (p[0][0] + s * dx - x).hypot(p[0][1] + s * dy - y)
                })
                .fold(f64::INFINITY, f64::min);
            assert!(distance <= tolerance, "{distance} for {tolerance}");
        }
    }
    assert!(flattened(&curve, 0.0).is_err());
}

proptest! {
    #[test]
    fn bytes_make_no_panic(bytes in proptest::collection::vec(any::<u8>(), 0..200), count in 0..3i32, pieces in 0..4i32) {
        let mut file = count.to_le_bytes().to_vec();
        for word in [2, 4, pieces] {
            file.extend(i32::to_le_bytes(word));
        }
        file.extend(&bytes);
        let _ = read_dat(&file[..]);
        let _ = read_dat(&bytes[..]);
    }

    #[test]
    fn power_coefficients_come_back(controls in proptest::collection::vec([-9i32..9, -9..9], 6..40), order in 1..4usize) {
        let order = Order::new(2 * order).unwrap();
        let degree = order.degree();
        let count = controls.len() / degree;
        prop_assume!(count >= 2);
        let mut points: Vec<[f64; 2]> = controls[..count * degree].iter().map(|p| p.map(f64::from)).collect();
        points.push(points[0]);
        let knot_points: Vec<[f64; 2]> = points.iter().copied().step_by(degree).collect();
        prop_assume!(knot_points.windows(2).all(|pair| pair[0] != pair[1]));
        let knots: Vec<f64> = (0..=count).map(|i| i as f64 * 0.75 + (i * i) as f64 / 8.0).collect();
        let curve = Curve::from_controls(order, points.clone(), knots.clone()).unwrap();
        let mut bytes = Vec::new();
        dat::push_curve(&mut bytes, &curve).unwrap();
        let file = [&1i32.to_le_bytes()[..], &bytes].concat();
        let back = read_dat(&file[..]).unwrap();
        let back = back.curves()[0].curve(order, &EndCondition::NotAKnot).unwrap();
        prop_assert_eq!(back.knots(), &knots[..]);
        for (i, (a, b)) in back.controls().iter().zip(&points).enumerate() {
            let bound = if i % degree == 0 { 0.0 } else { 1e-13 };
            prop_assert!((a[0] - b[0]).abs() <= bound && (a[1] - b[1]).abs() <= bound, "{i}: {a:?} {b:?}");
        }
    }
}

/// Sets that have an arc in common get the same chords for it, though one has it in the other direction.
#[test]
fn chords_do_not_depend_on_the_direction() {
    let mut random = 12345u64;
    let mut number = || {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (random >> 40) as f64 / 1e5
    };
    for _ in 0..300 {
        let mut controls: Vec<[f64; 2]> = (0..7).map(|_| [number(), number()]).collect();
        controls[6] = controls[0];
        let curve = Curve::from_controls(Order::CUBIC, controls, vec![0., 1., 2.5]).unwrap();
        let mut back = flattened(&curve.reversed(), 1e-2).unwrap();
        back[1..].reverse();
        assert_eq!(flattened(&curve, 1e-2).unwrap(), back);
    }
}
