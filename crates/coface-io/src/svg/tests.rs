//! Tests of both directions.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use super::{read, read_flattened, write};
use crate::{GroupKind, Model, RemarkCode};
use coface_algebra::ErrorKind;
use coface_algebra::RaggedArray;

pub(super) fn svg(inner: &str) -> String {
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{inner}</svg>")
}

pub(super) fn parsed(inner: &str) -> Model {
    let model = read(svg(inner).as_bytes()).unwrap();
    model.check().unwrap();
    model
}

fn column(model: &Model, name: &str) -> Vec<i64> {
    let data = model.data_named(name, GroupKind::Lines).unwrap();
    (0..data.len()).flat_map(|i| data.integer_row(i).unwrap()).collect()
}

/// The signed area of the rings of a model.
fn area(model: &Model) -> f64 {
    let flat = model.positions().as_flat();
    let at = |v: u32| [flat[2 * v as usize], flat[2 * v as usize + 1]];
    let sides = model.lines().iter().flat_map(|line| line.windows(2));
    sides.map(|s| (at(s[0]), at(s[1]))).map(|(p, q)| (p[0] * q[1] - p[1] * q[0]) / 2.0).sum()
}

#[test]
fn commands_are_read_absolute_and_relative() {
    let square = parsed("<path d='M1 1 L3 1 L3 3 L1 3 Z'/>");
    for data in [
        "M1,1 3,1 3,3 1,3z",
        "m1 1 2 0 0 2-2 0z",
        "M1 1H3V3H1Z",
        "m1 1h2v2h-2z",
        "M1 1H3V3H1V1",
        "  M\n1e0\t+1.L3.0.1e1 3 3,1 3 Z ",
        "M0 0M1 1H3V3H1Z M5 5",
    ] {
        let model = parsed(&format!("<path d='{data}'/>"));
        assert_eq!((model.lines(), model.positions()), (square.lines(), square.positions()), "{data}");
        assert_eq!(column(&model, "polygon"), [0]);
    }
    let shapes = ["<polygon points='1 1,3 1 3,3,1 3'/>", "<rect x='1' y='1px' width='2' height='2'/>"];
    for shape in shapes {
        assert_eq!(parsed(shape), square, "{shape}");
    }
    // After Z the pen is where the subpath began.
    let two = parsed("<path d='M1 1h2v2h-2z l-1 0 0-1z'/>");
    assert_eq!(column(&two, "polygon"), [0, 0]);
    assert_eq!(column(&two, "ring"), [0, 1]);
    assert_eq!(two.positions().as_flat()[8..], [1., 1., 0., 1., 0., 0.]);
}

#[test]
fn lines_names_and_rules_are_read() {
    let model = parsed(
        "<defs><path d='M0 0h1'/></defs><text>no</text><g fill-rule='evenodd'><path id='p' d='M0 0h9v9zM1 1h1v1z M5 5h1'/>\
         <path style='fill: red; fill-rule: nonzero' d='M0 0h9v9z'/></g><polyline fill='none' points='0 0 1 0 1 1 0 0'/>\
         <g display='none'><line x2='7'/></g>",
    );
    assert_eq!(column(&model, "polygon"), [0, 0, -1, 1, -1]);
    assert_eq!(column(&model, "ring"), [0, 1, -1, 0, -1]);
    assert_eq!(column(&model, "fill_rule"), [1, 1, -1, 0, -1]);
    assert_eq!((model.groups()[0].name(), model.groups()[0].members()), ("p", &[0, 1, 2][..]));
    assert_eq!(model.remarks().len(), 1);
    assert!(model.remarks()[0].message.starts_with("1 element is"));
    let lines = parsed("<line x1='1' y1='2' x2='3' y2='4'/><line x1='3' y1='4'/>");
    assert_eq!(*lines.lines(), RaggedArray::from_lists([[0, 1], [1, 2]]));
    assert!(lines.data().is_empty());
}

#[test]
fn transformations_are_applied() {
    for (transform, expected) in [
        ("translate(1 2)", [2., 2., 1., 3.]),
        ("translate(1)", [2., 0., 1., 1.]),
        ("scale(2,3)", [2., 0., 0., 3.]),
        ("rotate(90)", [0., 1., -1., 0.]),
        ("rotate(-180 1 1)", [1., 2., 2., 1.]),
        ("matrix(1 2 3 4 5 6)", [6., 8., 8., 10.]),
        ("translate(1,0) , scale(2)", [3., 0., 1., 2.]),
        ("skewX(0) skewY(0)", [1., 0., 0., 1.]),
    ] {
        let model = parsed(&format!("<g transform='{transform}'><line x1='1' y2='1'/></g>"));
        assert_eq!(model.positions().as_flat(), expected, "{transform}");
    }
    let nested = parsed("<g transform='translate(1 0)'><line transform='scale(2)' x1='1' y2='1'/></g>");
    assert_eq!(nested.positions().as_flat(), [3., 0., 1., 2.]);
}

#[test]
fn curves_are_as_near_as_asked() {
    use std::f64::consts::PI;
    for (shape, truth) in [
        ("<circle cx='5' cy='6' r='2'/>", 4.0 * PI),
        ("<ellipse cx='5' rx='2' ry='1'/>", 2.0 * PI),
        ("<circle r='1' transform='rotate(30) scale(3 2)'/>", 6.0 * PI),
        ("<rect width='4' height='3' rx='1'/>", 12.0 - (4.0 - PI)),
        ("<path d='M2 0A2 2 0 0 1 -2 0A2 2 0 0 1 2 0Z'/>", 4.0 * PI),
        ("<path d='M2 0a2 2 0 112-2z'/>", 3.0 * PI + 2.0),
        ("<path d='M0 0A1 1 0 0 0 4 0Z'/>", -2.0 * PI),
        // Areas under parabolas: two thirds of the box of the control points' height.
        ("<path d='M0 0Q1 2 2 0Z'/>", -4.0 / 3.0),
        ("<path d='M0 0C0 2 2 2 2 0Z'/>", -2.4),
        ("<path d='M0 0Q1 2 2 0T4 0Z'/>", 0.0),
        ("<path d='M0 0c0 2 2 2 2 0s2-2 2 0z'/>", 0.0),
    ] {
        let mut last = f64::INFINITY;
        for tolerance in [1e-2, 1e-4, 1e-6] {
            let model = read_flattened(svg(shape).as_bytes(), tolerance).unwrap();
            let off = (area(&model) - truth).abs();
            // Not farther off than the length of the curve, at most 40, times the tolerance.
            assert!(
                off <= 40.0 * tolerance && off <= last + 1e-12,
                "{shape} {tolerance}: {} for {truth}",
                area(&model)
            );
            last = off;
        }
        // Where nothing is said chords are within a thousandth of the size of the drawing.
        let model = read(svg(shape).as_bytes()).unwrap();
        let remark = &model.remarks()[0];
        assert_eq!((remark.code, remark.count), (RemarkCode::CurvesFlattened, 1));
        assert!(remark.message.contains("--flatten"), "{}", remark.message);
        let (low, high) = model
            .positions()
            .as_flat()
            .as_chunks::<2>()
            .0
            .iter()
            .fold(([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]), |(low, high), p| {
                ([0, 1].map(|i| low[i].min(p[i])), [0, 1].map(|i| high[i].max(p[i])))
            });
        let size = (high[0] - low[0]).hypot(high[1] - low[1]);
        assert!((area(&model) - truth).abs() <= 40.0 * 1.002e-3 * size, "{shape}: {}", area(&model));
        let strict = crate::ReadOptions::new().format(crate::Format::Svg).strict(true);
        let error = crate::read_with(svg(shape).as_bytes(), &strict).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::InvalidInput, "{error}");
    }
    // The box of the circle has the diagonal 2 sqrt(2): chords within 2.83e-3.
    let circle = read(svg("<circle r='1'/>").as_bytes()).unwrap();
    assert!(circle.remarks()[0].message.contains("within 2.828e-3 of them"), "{:?}", circle.remarks());
    assert_eq!(
        circle.positions(),
        read_flattened(svg("<circle r='1'/>").as_bytes(), 2.8284271247e-3).unwrap().positions()
    );
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(read_flattened(svg("").as_bytes(), bad).is_err());
    }
    let error = read_flattened(svg("<circle r='1e9'/>").as_bytes(), 1e-9).unwrap_err();
    assert!(error.to_string().contains("chords"), "{error}");
}

#[test]
fn faults_have_a_line_and_a_cure() {
    for (inner, message) in [
        ("<path d='L1 1'/>", "begin with M"),
        ("<path d='M1 1 2'/>", "number is missing"),
        ("<path d='M1 1 X2'/>", "'X' is not a command"),
        ("<path d='M1 1 L2 2 Z 3'/>", "behind Z"),
        ("<path d='M1 1A1 1 0 2 0 1 1'/>", "flag"),
        ("<path d='M1 nan'/>", "number is missing"),
        ("<path d='M1 1e999'/>", "number is missing"),
        ("<polygon points='1 1 2'/>", "number is missing"),
        ("<rect width='5%' height='1'/>", "\"5%\" is of the size of the drawing"),
        ("<g transform='turn(5)'/>", "not a transformation"),
        ("<g transform='scale(1'/>", "not closed"),
        ("<g transform='scale(x)'/>", "not all numbers"),
        ("<line x1='1e308' transform='scale(1e9)'/>", "not finite"),
        ("<g>", "expected"),
        ("&nothing;", "nothing"),
    ] {
        let error = read(svg(&format!("\n{inner}")).as_bytes()).unwrap_err();
        assert!(
            error.to_string().to_lowercase().contains(message.to_lowercase().as_str()),
            "{inner}: {error}"
        );
        assert!(error.line().is_some() && error.cure().is_some(), "{error}");
    }
    let error = read(&b"<html xmlns='a'></html>"[..]).unwrap_err().to_string();
    assert!(error.contains("<html>, not <svg>"), "{error}");
    let deep = "<g>".repeat(100_000);
    assert!(read(svg(&deep).as_bytes()).is_err());
    let nested = format!("{}{}", "<g>".repeat(300), "</g>".repeat(300));
    assert_eq!(read(svg(&nested).as_bytes()).unwrap_err().kind(), ErrorKind::TooLarge);
}

#[test]
fn what_is_written_reads_back() {
    for inner in [
        "<path d='M0 0h9v9zM1 .5h1v1z'/><path fill-rule='evenodd' d='M0 0h9v9z'/><polyline points='0 0 1 0.1 1e-9 1 0 0'/>",
        "<path fill-rule='evenodd' d='M0 0h9v9zM1 .5h1v1z'/><line x2='-5e300'/>",
        "",
        "<polyline points='3 3 3 3'/>",
    ] {
        let model = parsed(inner);
        let mut text = Vec::new();
        write(&model, &mut text).unwrap();
        assert_eq!(read(&text[..]).unwrap(), model, "{}", String::from_utf8_lossy(&text));
    }
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 0\nf 1 2 3\n";
    let model = crate::obj::read(text.as_bytes()).unwrap();
    let mut written = Vec::new();
    write(&model, &mut written).unwrap();
    let back = read(&written[..]).unwrap();
    assert_eq!((back.lines().list(0), back.points().len()), (&[0, 1, 2, 0][..], 1));
    let steep = crate::obj::read(&b"v 0 0 1\nv 1 0 0\nl 1 2\n"[..]).unwrap();
    assert_eq!(write(&steep, &mut Vec::new()).unwrap_err().kind(), ErrorKind::UnsupportedFormat);
}

#[test]
fn lengths_have_units_and_percentages() {
    let sized = |attributes: &str, inner: &str| {
        read(format!("<svg xmlns='http://www.w3.org/2000/svg' {attributes}>{inner}</svg>").as_bytes())
    };
    for (attributes, inner, expected) in [
        ("viewBox='0 0 20 10'", "<rect width='50%' height='100%'/>", 100.0),
        ("width='40' height='1in'", "<rect width='50%' height='50%'/>", 20.0 * 48.0),
        ("", "<rect width='1in' height='25.4mm'/>", 96.0 * 96.0),
        ("", "<rect width='2.54cm' height='72pt'/>", 96.0 * 96.0),
        ("", "<rect width='1e1px' height='1em'/>", 160.0),
        ("", "<g font-size='10'><g style='font-size: 50%'><rect width='1em' height='2ex'/></g></g>", 25.0),
        ("viewBox='0 0 3 4'", "<rect width='100vw' height='100vh'/>", 12.0),
        // A background of a drawing whose size is that of the page has its box.
        ("width='100%' height='100%' viewBox='0 0 8 8'", "<rect width='100%' height='100%'/>", 64.0),
    ] {
        let found = area(&sized(attributes, inner).unwrap());
        assert!((found - expected).abs() < 1e-9, "{attributes} {inner}: {found}");
    }
    let error = sized("", "<rect width='50%' height='1'/>").unwrap_err();
    assert!(error.to_string().contains("neither viewBox nor width and height"), "{error}");
    let error = sized("", "<rect width='5furlongs' height='1'/>").unwrap_err();
    assert!(error.to_string().contains("width=\"5furlongs\" is no length"), "{error}");
}

#[test]
fn copies_and_drawings_inside_are_at_their_places() {
    let square = "<defs><rect id='r' width='2' height='2'/></defs>";
    let twice = parsed(&format!("{square}<use href='#r' x='5'/><use href='#r' transform='scale(2)'/>"));
    assert_eq!((area(&twice), twice.lines().len(), twice.remarks().len()), (20.0, 2, 0));
    let of_group = parsed("<g id='g'><rect width='1' height='1'/></g><use href='#g' y='3'/>");
    assert_eq!(area(&of_group), 2.0);
    let inner = parsed(
        "<svg x='10' y='20' width='20' height='20' viewBox='0 0 10 10'><rect width='5' height='5'/></svg>",
    );
    assert_eq!((area(&inner), &inner.positions().as_flat()[..2]), (100.0, &[10.0, 20.0][..]));
    // The box is wider than what is in it, which stands in the middle, or is cut, or is stretched.
    let placed = |how: &str| {
        let text = format!(
            "<svg width='40' height='20' viewBox='0 0 1 1' preserveAspectRatio='{how}'><rect width='1' height='1'/></svg>"
        );
        let model = parsed(&text);
        let flat = model.positions().as_flat();
        [flat[0], flat[1], area(&model)]
    };
    assert_eq!(placed("xMidYMid"), [10.0, 0.0, 400.0]);
    assert_eq!(placed("xMaxYMin meet"), [20.0, 0.0, 400.0]);
    assert_eq!(placed("xMidYMid slice' overflow='visible"), [0.0, -10.0, 1600.0]);
    assert_eq!(placed("none"), [0.0, 0.0, 800.0]);
    let symbol = parsed(
        "<symbol id='s' viewBox='0 0 1 1'><rect width='1' height='1'/></symbol><use href='#s' width='3' height='3'/>",
    );
    assert_eq!(area(&symbol), 9.0);
    let turned = parsed(
        "<symbol id='s' viewBox='0 0 1 1' transform='scale(2)'><rect width='1' height='1'/></symbol>\
         <symbol id='h' display='none'><rect width='9' height='9'/></symbol>\
         <use href='#s' width='3' height='3'/><use href='#h'/>",
    );
    assert_eq!(area(&turned), 36.0);
    let elsewhere = parsed("<rect width='1' height='1'/><use href='other.svg#s'/><use href='#nothing'/>");
    assert_eq!((area(&elsewhere), elsewhere.remarks()[0].code), (1.0, RemarkCode::ElementsLeftOut));
}

#[test]
fn copies_of_copies_end() {
    let mut text = "<g id='g0'><rect width='1' height='1'/></g>".to_owned();
    for level in 1..40 {
        let below = level - 1;
        text += &format!("<g id='g{level}'><use href='#g{below}'/><use href='#g{below}'/></g>");
    }
    let error = read(svg(&text).as_bytes()).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::TooLarge, "{error}");
    let of_itself = parsed("<g id='g'><rect width='1' height='1'/><use href='#g'/></g>");
    assert_eq!((area(&of_itself), of_itself.remarks()[0].count), (1.0, 1));
    let of_each_other =
        "<g id='a'><rect width='1' height='1'/><use href='#b'/></g><g id='b'><use href='#a'/></g>";
    let of_each_other = parsed(of_each_other);
    // The use in b draws a, where the one of b is in a circle, and the one in a draws b, where the one of a is.
    assert_eq!((of_each_other.lines().len(), of_each_other.remarks()[0].count), (2, 2));
    assert!(of_each_other.remarks()[0].message.ends_with("2 uses of what they are in"));
}

/// SVG 2, section 13.2: a paint server that is not there is its fallback, or else none; the context of what a `use` draws is how that is painted.
#[test]
fn paints_that_are_not_there_paint_nothing() {
    let square =
        |attributes: &str| parsed(&format!("<pattern id='p'/><rect width='1' height='1' {attributes}/>"));
    for (attributes, is_filled, missing) in [
        ("fill='url(#p)'", true, 0),
        ("fill='url(#nothing)'", false, 1),
        ("fill='url(\"#nothing\") none'", false, 0),
        ("fill='url(#nothing) red'", true, 0),
        ("fill='red' stroke='url(#nothing)'", true, 1),
        ("style='fill:url(#nothing) #00000000; stroke: red'", false, 0),
        ("fill='context-fill'", false, 0),
    ] {
        let model = square(attributes);
        let own = rules(&format!(
            "<pattern id='p'/><path d='M0 0h9v9z'/><rect width='1' height='1' {attributes}/>"
        ));
        assert_eq!(own, [0, if is_filled { 0 } else { -1 }], "{attributes}");
        let said = model.remarks().iter().filter(|remark| remark.code == RemarkCode::DrawingAssumption);
        let said: Vec<u64> = said
            .filter(|said| said.message.starts_with("these paint nothing"))
            .map(|said| said.count)
            .collect();
        assert_eq!(said, if missing > 0 { vec![missing] } else { vec![] }, "{attributes}");
    }
    for (paint, of_use, is_filled) in [
        ("context-fill", "fill='red'", true),
        ("context-fill", "fill='none'", false),
        ("context-fill", "", true),
        ("context-stroke", "fill='none' stroke='red'", true),
        ("context-stroke", "fill='red'", false),
    ] {
        let text = format!(
            "<path d='M0 0h9v9z'/><defs><rect id='r' width='1' height='1' fill='{paint}'/></defs><use href='#r' {of_use}/>"
        );
        assert_eq!(rules(&text), [0, if is_filled { 0 } else { -1 }], "{paint} {of_use}");
    }
}

/// The rule of each line, -1 for one that is no ring.
fn rules(inner: &str) -> Vec<i64> {
    let model = parsed(inner);
    match model.data_named("fill_rule", GroupKind::Lines) {
        Some(_) => column(&model, "fill_rule"),
        None => vec![-1; model.lines().len()],
    }
}

#[test]
fn what_is_filled_is_rings() {
    const SQUARE: &str = "<rect x='2' y='2' width='3' height='3'/>";
    for (inner, expected) in [
        ("<rect width='9' height='9' fill='none'/>", vec![-1, 0]),
        ("<rect width='9' height='9' style='fill: none'/>", vec![-1, 0]),
        ("<rect width='9' height='9' style='fill: none !important; fill: red'/>", vec![-1, 0]),
        ("<rect width='9' height='9' fill='transparent'/>", vec![-1, 0]),
        (
            "<rect width='9' height='9' fill='#0f00'/><rect width='9' height='9' fill='#0F0F0F00'/>",
            vec![-1, -1, 0],
        ),
        (
            "<rect width='9' height='9' fill='rgba(0, 0, 0, 0)'/><rect width='9' height='9' fill='rgb(0 0 0 / 0%)'/>",
            vec![-1, -1, 0],
        ),
        (
            "<rect width='9' height='9' fill='hsla(0, 0%, 0%, 0.1)'/><rect width='9' height='9' fill='#0008'/>",
            vec![0, 0, 0],
        ),
        (
            "<g fill='none'><rect width='9' height='9'/><rect width='1' height='1' fill='red'/></g>",
            vec![-1, 0, 0],
        ),
        ("<g fill-opacity='0'><rect width='9' height='9'/></g>", vec![-1, 0]),
        ("<rect width='9' height='9' visibility='hidden'/>", vec![0]),
        (
            "<g visibility='hidden'><rect width='9' height='9'/><rect visibility='visible' width='1' height='1'/></g>",
            vec![0, 0],
        ),
        ("<rect width='9' height='9' style='display:none'/>", vec![0]),
        ("<path d='M0 0h4v4'/>", vec![0, 0]),
        ("<polyline points='0 0 4 0 4 3'/>", vec![0, 0]),
        ("<path fill='none' d='M0 0h4v4z'/>", vec![-1, 0]),
        ("<path d='M0 0h4'/><line x2='5'/>", vec![-1, -1, 0]),
        ("<style>.a{fill:none}</style><rect class='x a' width='9' height='9' fill='red'/>", vec![-1, 0]),
        (
            "<style>/* .a{fill:none} */ rect{fill:none} .b{fill:red}</style><rect class='b' width='9' height='9'/>",
            vec![0, -1],
        ),
        (
            "<style>rect.b{fill-rule:evenodd} rect{fill-rule:nonzero}</style><rect class='b' width='9' height='9'/>",
            vec![1, 0],
        ),
        (
            "<style>#i{fill:red} .a{fill:none}</style><rect id='i' class='a' width='9' height='9'/>",
            vec![0, 0],
        ),
        ("<style>#i{fill:none}</style><rect id='i' style='fill:red' width='9' height='9'/>", vec![0, 0]),
        (
            "<style>.a{fill:none!important}</style><rect class='a' style='fill:red' width='9' height='9'/>",
            vec![-1, 0],
        ),
        (
            "<style>g .a, .q > .b{fill:none} .q>.c{fill:none}</style><g><g class='q'><rect class='a' width='9' height='9'/>\
          <rect class='b' width='8' height='8'/></g><rect class='c' width='7' height='7'/></g>",
            vec![-1, -1, 0, 0],
        ),
        ("<style>.a{fill:none} .a{fill:red}</style><rect class='a' width='9' height='9'/>", vec![0, 0]),
        ("<style>.h{display:none}</style><rect class='h' width='9' height='9'/>", vec![0]),
        ("<style>@media print{rect{display:none}} rect:hover{fill:none}</style>", vec![0]),
    ] {
        assert_eq!(rules(&format!("{inner}{SQUARE}")), expected, "{inner}");
    }
    // Where nothing is filled, closed outlines are.
    let strokes = "<g fill='none'><rect width='9' height='9'/><path d='M0 0h4v4'/><polyline points='0 0 1 0 1 1 0 0'/></g>";
    assert_eq!(rules(strokes), [0, -1, -1]);
    assert_eq!(parsed(strokes).remarks()[0].code, RemarkCode::DrawingAssumption);
}

#[test]
fn what_is_not_done_has_one_remark() {
    let said = |inner: &str| {
        let model = parsed(&format!("{inner}<rect width='1' height='1'/>"));
        let remarks: Vec<_> =
            model.remarks().iter().map(|remark| (remark.count, remark.message.clone())).collect();
        remarks
    };
    for (inner, count, word) in [
        (
            "<g mask='url(#m)'><rect width='5' height='5'/></g><g clip-path='url(#c)'/>",
            2,
            "1 clip-path, 1 mask",
        ),
        ("<rect width='4' height='4' style='transform: scale(2)'/>", 1, "in its style"),
        (
            "<style>rect:nth-child(2){fill:none} [x]{fill:none} @media screen{rect{fill:none}}</style>",
            3,
            "3 rules",
        ),
        ("<style>@import url(other.css); @font-face{font-family:a}</style>", 1, "1 rule"),
    ] {
        let said = said(inner);
        assert_eq!((said.len(), said[0].0), (1, count), "{inner}: {said:?}");
        assert!(said[0].1.contains(word), "{said:?}");
    }
    for whole in [
        "<svg width='8' height='8'><rect width='8' height='8'/></svg>",
        "<svg width='4' height='4'><rect width='8' height='8'/></svg>",
        "<svg width='4' height='4' overflow='visible'><rect width='8' height='8'/></svg>",
        "<g clip-path='none'><rect width='8' height='8'/></g>",
    ] {
        assert!(said(whole).is_empty(), "{whole}");
    }
}

#[test]
fn paths_that_come_back_within_rounding_are_closed() {
    // Tenths added up: the last command ends next to where the path began.
    let data = "M.1 .1h.7v.7h-.7v-.3v-.4";
    let model = parsed(&format!("<path d='{data}'/>"));
    assert_eq!((model.lines().len(), model.vertex_count()), (1, 5));
    assert!(model.remarks.is_empty(), "{:?}", model.remarks);
    // A chevron of arcs and lines, as drawing programs write it; Z finds the pen where it began.
    let chevron = "M1.646 4.646a.5.5 0 0 1 .708 0L8 10.293l5.646-5.647a.5.5 0 0 1 .708.708l-6 6a.5.5 0 0 1-.708 0l-6-6a.5.5 0 0 1 0-.708";
    for end in ["", "z"] {
        let text = svg(&format!("<path fill-rule='evenodd' d='{chevron}{end}'/>"));
        let drawing =
            crate::read_boundary(text.as_bytes(), crate::Format::Svg, &crate::ReadOptions::default())
                .unwrap();
        drawing.check().unwrap();
        let [curve] = drawing.curves() else { panic!("{drawing:?}") };
        let ends = coface_yin::EndCondition::NotAKnot;
        let area = curve.curve(drawing.order(), &ends).unwrap().signed_area();
        // Two bars of width 1/sqrt(2) with round ends, by chords of 1e-6.
        let flat = read_flattened(text.as_bytes(), 1e-6).unwrap();
        assert!((area.abs() - self::area(&flat).abs()).abs() < 1e-4, "{area}");
        assert!(drawing.remarks().iter().all(|remark| remark.code != RemarkCode::UnclosedRing));
    }
    // What is farther away than rounding stays apart.
    let open = parsed("<path d='M.1 .1h.7v.7h-.7v-.6999999'/>");
    assert_eq!(open.vertex_count(), 5);
    assert_eq!(open.remarks()[0].code, RemarkCode::UnclosedRing);
}

#[test]
fn sides_without_a_length_that_counts_are_left_out() {
    // Between two curves a line of a unit in the last place, and a curve that is no longer.
    let x = 10.0f64.next_up();
    for between in [format!("L{x} 10"), format!("C10 10 {x} 10 {x} 10")] {
        let text = svg(&format!("<path d='M0 0C5 -1 10 5 10 10{between}C9 11 1 9 0 10Z'/>"));
        let drawing =
            crate::read_boundary(text.as_bytes(), crate::Format::Svg, &crate::ReadOptions::default())
                .unwrap();
        drawing.check().unwrap();
        let [curve] = drawing.curves() else { panic!("{drawing:?}") };
        assert_eq!(curve.points(), [[0., 0.], [10., 10.], [0., 10.]]);
        assert!(curve.curve(drawing.order(), &coface_yin::EndCondition::NotAKnot).is_ok());
    }
}
