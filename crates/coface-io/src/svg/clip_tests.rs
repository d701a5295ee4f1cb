//! Tests of clip paths, masks and the boxes of inner drawings: areas by hand, and points one by one.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use super::tests::{parsed, svg};
use super::{read, read_flattened};
use crate::{GroupKind, Model, RemarkCode};
use coface_algebra::{ErrorKind, RaggedArray};
use coface_arrange::planar::PlanarOverlay;
use coface_geometry::Positions;
use coface_yin::EndCondition;
use proptest::prelude::*;
use std::f64::consts::PI;

fn column(model: &Model, name: &str) -> Vec<i64> {
    let Some(data) = model.data_named(name, GroupKind::Lines) else { return Vec::new() };
    (0..data.len()).flat_map(|i| data.integer_row(i).unwrap()).collect()
}

fn corners(model: &Model, line: usize) -> Vec<[f64; 2]> {
    let flat = model.positions().as_flat().as_chunks::<2>().0;
    model.lines().list(line).iter().map(|&vertex| flat[vertex as usize]).collect()
}

/// The signed area of the rings of a model.
fn area(model: &Model) -> f64 {
    let rules = column(model, "fill_rule");
    let rings = (0..model.lines().len()).filter(|&line| rules.get(line).is_some_and(|&rule| rule >= 0));
    let doubled = rings.flat_map(|line| {
        let corners = corners(model, line);
        corners.windows(2).map(|s| s[0][0] * s[1][1] - s[0][1] * s[1][0]).collect::<Vec<f64>>()
    });
    doubled.sum::<f64>() / 2.0
}

/// The area of a drawing of which everything is done.
fn clean_area(inner: &str) -> f64 {
    let model = parsed(inner);
    assert!(model.remarks().is_empty(), "{inner}: {:?}", model.remarks());
    area(&model)
}

const TEN: &str = "width='10' height='10'";

#[test]
fn shapes_are_clipped_by_the_paths_they_name() {
    let rect = "<rect width='10' height='10'";
    let two = "<clipPath id='c'><rect width='2' height='9'/></clipPath>";
    for (inner, expected) in [
        (format!("{two}{rect} clip-path='url(#c)'/>"), 18.0),
        (format!("{two}{rect} clip-path='url( \"#c\" )'/>"), 18.0),
        (format!("{two}{rect} style=\"clip-path: url('#c')\"/>"), 18.0),
        (format!("<style>.k{{clip-path:url(#c)}}</style>{two}{rect} class='k'/>"), 18.0),
        (format!("<style>.k{{clip-path:url(#c)}}</style>{two}{rect} class='k' style='clip-path:none'/>"), 100.0),
        (format!("{two}<g clip-path='url(#c)'>{rect}/>{rect} x='1'/></g>"), 18.0 + 9.0),
        // In the coordinates of the element.
        (format!("{two}{rect} clip-path='url(#c)' transform='translate(5 5) scale(2)'/>"), 4.0 * 18.0),
        (format!("{two}<g transform='scale(2)'>{rect} clip-path='url(#c)'/></g>"), 4.0 * 18.0),
        // A `use` has its place in its coordinates.
        (format!("{two}<defs>{rect} id='r'/></defs><use href='#r' x='50' clip-path='url(#c)'/>"), 18.0),
        // Two shapes that overlap are one clip.
        (
            format!("<clipPath id='c'><rect width='4' height='4'/><rect x='2' y='2' width='4' height='4'/></clipPath>{rect} clip-path='url(#c)'/>"),
            28.0,
        ),
        // Half of the square is below the diagonal.
        (format!("<clipPath id='c'><path d='M0 0L10 10H0'/></clipPath>{rect} clip-path='url(#c)'/>"), 50.0),
        (
            format!("<clipPath id='c' transform='scale(2)'><rect width='1' height='1' transform='translate(1)'/></clipPath>{rect} clip-path='url(#c)'/>"),
            4.0,
        ),
        (
            format!("<clipPath id='c'><path clip-rule='evenodd' d='M0 0h8v8h-8z M2 2h4v4h-4z'/></clipPath>{rect} clip-path='url(#c)'/>"),
            48.0,
        ),
        (
            format!("<g clip-rule='evenodd'><clipPath id='c'><path d='M0 0h8v8h-8z M2 2h4v4h-4z'/></clipPath></g>{rect} clip-path='url(#c)'/>"),
            48.0,
        ),
        (
            format!("<clipPath id='c'><path fill-rule='evenodd' d='M0 0h8v8h-8z M2 2h4v4h-4z'/></clipPath>{rect} clip-path='url(#c)'/>"),
            64.0,
        ),
        // What fills a shape in a clip path does not matter, but whether it is there.
        (
            format!("<clipPath id='c'><rect fill='none' width='1' height='1'/><rect display='none' width='9' height='9'/><rect visibility='hidden' width='8' height='8'/></clipPath>{rect} clip-path='url(#c)'/>"),
            1.0,
        ),
        // One clip in another, on a group, on a clip path, and on a shape of it.
        (
            format!("{two}<clipPath id='d'><rect y='8' width='9' height='9'/></clipPath><g clip-path='url(#d)'>{rect} clip-path='url(#c)'/></g>"),
            2.0,
        ),
        (
            format!("{two}<clipPath id='d' clip-path='url(#c)'><rect y='8' width='9' height='9'/></clipPath>{rect} clip-path='url(#d)'/>"),
            2.0,
        ),
        (
            format!("{two}<clipPath id='d'><rect y='8' width='9' height='9' clip-path='url(#c)'/><rect x='9' width='1' height='1'/></clipPath>{rect} clip-path='url(#d)'/>"),
            3.0,
        ),
        (
            format!("<defs><rect id='s' width='3' height='1'/><g id='g'/></defs><clipPath id='c'><use href='#s' x='9'/><use href='#s' y='5'/><use href='#g'/><g><rect width='9' height='9'/></g></clipPath>{rect} clip-path='url(#c)'/>"),
            1.0 + 3.0,
        ),
        // In units of the box of what is clipped.
        (
            "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='.5'/></clipPath><rect x='10' y='10' width='4' height='6' clip-path='url(#c)'/>".to_owned(),
            6.0,
        ),
        (
            "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect x='.25' width='.5' height='1'/></clipPath><g transform='translate(7 7)' clip-path='url(#c)'><rect width='2' height='2'/><rect transform='translate(6 6)' width='2' height='2'/></g>".to_owned(),
            0.0,
        ),
        (
            "<clipPath id='c' clipPathUnits='objectBoundingBox'><circle cx='.5' cy='.5' r='8'/></clipPath><rect width='4' height='6' clip-path='url(#c)'/>".to_owned(),
            24.0,
        ),
        // Nothing is seen through nothing.
        (format!("<clipPath id='c'/>{rect} clip-path='url(#c)'/>"), 0.0),
        (format!("<clipPath id='c'><rect x='20' width='2' height='2'/></clipPath>{rect} clip-path='url(#c)'/>"), 0.0),
        // A shape that crosses itself.
        (
            "<clipPath id='c'><rect width='5' height='10'/></clipPath><path fill-rule='evenodd' d='M0 0h10v10h-10zM2 2h6v6h-6z' clip-path='url(#c)'/>".to_owned(),
            50.0 - 18.0,
        ),
    ] {
        let found = clean_area(&inner);
        assert!((found - expected).abs() < 1e-12, "{inner}: {found} for {expected}");
    }
    // The circle as chords: within a thousandth of what is drawn.
    let round =
        format!("<clipPath id='c'><circle cx='5' cy='5' r='2'/></clipPath><rect {TEN} clip-path='url(#c)'/>");
    let model = parsed(&round);
    assert_eq!(
        model.remarks().iter().map(|remark| remark.code).collect::<Vec<_>>(),
        [RemarkCode::CurvesFlattened]
    );
    let size = 4.0 * 2f64.sqrt();
    assert!((area(&model) - 4.0 * PI).abs() < 4.0 * PI * 1e-3 * size, "{}", area(&model));
    let model = read_flattened(svg(&round).as_bytes(), 1e-6).unwrap();
    assert!((area(&model) - 4.0 * PI).abs() < 4.0 * PI * 1e-6, "{}", area(&model));
}

#[test]
fn inner_drawings_end_at_their_boxes() {
    for (inner, expected) in [
        ("<svg width='4' height='4'><rect width='8' height='8'/></svg>", 16.0),
        ("<svg x='1' y='2' width='4' height='4'><rect width='8' height='8'/></svg>", 16.0),
        ("<svg width='4' height='4' overflow='visible'><rect width='8' height='8'/></svg>", 64.0),
        ("<svg width='4' height='4' style='overflow: auto'><rect width='8' height='8'/></svg>", 64.0),
        (
            "<svg width='40' height='20' viewBox='0 0 1 1' preserveAspectRatio='xMidYMid slice'><rect width='1' height='1'/></svg>",
            800.0,
        ),
        (
            "<svg width='4' height='4'><svg x='3' width='4' height='4'><rect width='8' height='8'/></svg></svg>",
            4.0,
        ),
        (
            "<symbol id='s' viewBox='0 0 2 2'><rect width='8' height='8'/></symbol><use href='#s' width='3' height='3'/>",
            9.0,
        ),
        ("<svg width='4' height='4' transform='rotate(45)'><rect x='2' width='8' height='8'/></svg>", 8.0),
        (
            "<svg width='4' height='4'><g transform='rotate(45)'><rect x='-9' y='-9' width='18' height='9'/></g></svg>",
            8.0,
        ),
    ] {
        let found = clean_area(inner);
        assert!((found - expected).abs() < 1e-12, "{inner}: {found} for {expected}");
    }
    // What fills its box has no corners more, though the last digits of both differ.
    let turned = "<symbol id='s' viewBox='0 0 0.3 0.7' preserveAspectRatio='none'><rect width='.3' height='.7'/></symbol>\
                  <use href='#s' width='3.3' height='0.9' transform='translate(100.1 7) rotate(31)'/>";
    let model = parsed(turned);
    assert_eq!((model.lines().len(), model.vertex_count()), (1, 4));
}

#[test]
fn parts_of_a_clipped_shape_are_polygons_with_holes() {
    let comb = "<clipPath id='c'><rect width='2' height='9'/><rect x='4' width='2' height='9'/></clipPath>";
    let model =
        parsed(&format!("{comb}<rect id='r' {TEN} clip-path='url(#c)'/><rect x='50' width='1' height='1'/>"));
    assert_eq!(column(&model, "polygon"), [0, 1, 2]);
    assert_eq!((model.groups()[0].name(), model.groups()[0].members()), ("r", &[0, 1][..]));
    let model = parsed(&format!("{comb}<rect {TEN} clip-path='url(#c)'/>"));
    assert_eq!(column(&model, "feature"), [0, 0]);
    let ring = format!(
        "<clipPath id='c'><path clip-rule='evenodd' d='M0 0h8v8h-8zM2 2h4v4h-4z'/></clipPath><rect {TEN} clip-path='url(#c)'/>"
    );
    let model = parsed(&ring);
    assert_eq!((column(&model, "polygon"), column(&model, "ring")), (vec![0, 0], vec![0, 1]));
    assert_eq!(column(&model, "fill_rule"), [0, 0]);
    // What is wholly inside stays as it is drawn.
    let inside = format!(
        "<clipPath id='c'><rect {TEN}/></clipPath><path fill-rule='evenodd' d='M1 1v8h8v-8z' clip-path='url(#c)'/>"
    );
    let model = parsed(&inside);
    assert_eq!((column(&model, "fill_rule"), corners(&model, 0)[1]), (vec![1], [1.0, 9.0]));
    // Where nothing is filled, closed outlines are shapes, and clipped as such; not so where the filled ones are not seen.
    let outline = format!("{comb}<rect {TEN} fill='none' clip-path='url(#c)'/>");
    assert_eq!(column(&parsed(&outline), "polygon"), [0, 1]);
    let hidden = format!("<rect x='50' {TEN} clip-path='url(#c)'/>");
    assert_eq!(column(&parsed(&format!("{outline}{hidden}")), "polygon"), [0i64; 0]);
}

#[test]
fn lines_are_clipped_too() {
    let lines = |inner: &str| {
        let model = parsed(inner);
        assert!(model.remarks().is_empty(), "{inner}: {:?}", model.remarks());
        (0..model.lines().len()).map(|line| corners(&model, line)).collect::<Vec<_>>()
    };
    let comb = "<clipPath id='c'><rect x='1' width='2' height='9'/><rect x='4' width='2' height='9'/><rect x='5' width='2' height='9'/></clipPath>";
    let found = lines(&format!("{comb}<line x1='10' y1='1' y2='1' clip-path='url(#c)'/>"));
    assert_eq!(found, [[[7.0, 1.0], [4.0, 1.0]], [[3.0, 1.0], [1.0, 1.0]]]);
    let found =
        lines(&format!("{comb}<polyline fill='none' points='2 20 2 2 5 2 5 3 0 3' clip-path='url(#c)'/>"));
    let first: &[[f64; 2]] = &[[2., 9.], [2., 2.], [3., 2.]];
    assert_eq!(found, [first, &[[4., 2.], [5., 2.], [5., 3.], [4., 3.]], &[[3., 3.], [1., 3.]]]);
    // A closed outline is one piece where it begins.
    let window = "<clipPath id='c'><rect x='-1' y='-1' width='3' height='20'/></clipPath><rect x='50' width='1' height='1'/>";
    let found = lines(&format!("{window}<rect {TEN} fill='none' clip-path='url(#c)'/>"));
    assert_eq!(found[1], [[2., 10.], [0., 10.], [0., 0.], [2., 0.]]);
    // Along the rim it is seen.
    let found = lines(&format!("{comb}<polyline fill='none' points='1 5 1 8' clip-path='url(#c)'/>"));
    assert_eq!(found, [[[1., 5.], [1., 8.]]]);
    assert!(lines(&format!("{comb}<polyline fill='none' points='0 0 0 8' clip-path='url(#c)'/>")).is_empty());
    let found = lines("<svg width='4' height='4'><line x1='-1' y1='-1' x2='9' y2='9'/></svg>");
    assert_eq!(found, [[[0., 0.], [4., 4.]]]);
}

#[test]
fn masks_of_white_and_black_are_clips() {
    let rect = format!("<rect {TEN} mask='url(#m)'/>");
    for (mask, expected) in [
        ("<mask id='m'><rect width='4' height='4' fill='white'/></mask>", 16.0),
        (
            "<mask id='m'><g fill='#FFF'><rect width='9' height='9'/><rect x='3' y='3' width='2' height='2' fill='#000'/></g></mask>",
            77.0,
        ),
        // Later shapes are above.
        (
            "<mask id='m' fill='white'><rect width='9' height='9'/><rect width='5' height='5' fill='black'/><rect width='1' height='1'/></mask>",
            57.0,
        ),
        (
            "<mask id='m' style='mask-type:alpha' maskUnits='userSpaceOnUse' x='0' y='0' width='3' height='20'><rect width='9' height='9' fill='#D9D9D9'/></mask>",
            27.0,
        ),
        (
            "<mask id='m' maskContentUnits='objectBoundingBox'><rect width='.5' height='.5' fill='white'/></mask>",
            25.0,
        ),
        (
            "<mask id='m' x='0' y='0' width='.5' height='50%'><rect width='9' height='9' fill='white'/></mask>",
            25.0,
        ),
        ("<mask id='m'><rect width='9' height='9'/></mask>", 0.0),
        (
            "<defs><rect id='r' width='2' height='2'/></defs><mask id='m' fill='white'><use href='#r' x='1'/><rect fill='none' width='8' height='8'/></mask>",
            4.0,
        ),
    ] {
        let found = clean_area(&format!("{mask}{rect}"));
        assert!((found - expected).abs() < 1e-12, "{mask}: {found} for {expected}");
    }
    for mask in [
        "<mask id='m'><rect width='4' height='4' fill='grey'/></mask>",
        "<mask id='m'><rect width='4' height='4' fill='white' opacity='.5'/></mask>",
        "<linearGradient id='g'/><mask id='m'><rect width='4' height='4' fill='url(#g)'/></mask>",
        "<mask id='m'><rect width='4' height='4' fill='white' stroke='white'/></mask>",
        "<mask id='m'><text fill='white'>a</text></mask>",
        "<mask id='m' mask='url(#m)'/>",
        "",
    ] {
        let model = parsed(&format!("{mask}{rect}"));
        assert_eq!((area(&model), model.remarks().len()), (100.0, 1), "{mask}");
        assert!(model.remarks()[0].message.ends_with("none of these: 1 mask"), "{:?}", model.remarks());
    }
}

#[test]
fn basic_shapes_of_css_are_clips() {
    let rect = |style: &str| format!("<rect x='3' y='4' width='8' height='4' style='clip-path: {style}'/>");
    for (style, expected) in [
        ("inset(1px)", 12.0),
        ("inset(25% 0 0 50%)", 12.0),
        ("inset(3px)", 0.0),
        ("polygon(0 0, 100% 0, 0 100%)", 16.0),
        (
            "polygon(evenodd, 0 0, 8px 0, 8px 4px, 0 4px, 0 0, 1px 1px, 3px 1px, 3px 3px, 1px 3px, 1px 1px)",
            28.0,
        ),
    ] {
        assert_eq!(clean_area(&rect(style)), expected, "{style}");
    }
    for (style, expected) in [
        ("circle()", 4.0 * PI),
        ("circle(1px at right top)", PI / 4.0),
        ("circle(9px at 0 50%)", 32.0),
        // Of a circle of radius 4 what is within 2 of its middle line.
        ("circle(farthest-side) content-box", 16.0 * PI / 3.0 + 8.0 * 3f64.sqrt()),
        ("ellipse(50% 25% at center)", 4.0 * PI),
        ("ellipse() fill-box", 8.0 * PI),
    ] {
        let model = read_flattened(svg(&rect(style)).as_bytes(), 1e-5).unwrap();
        assert!(
            (area(&model) - expected).abs() < 1e-3 && model.remarks().is_empty(),
            "{style}: {}",
            area(&model)
        );
    }
    for style in
        ["path(\"M0 0h1v1z\")", "inset(1px round 2px)", "polygon(calc(1px) 0)", "circle(2px) view-box"]
    {
        let model = parsed(&rect(style));
        assert_eq!((area(&model), model.remarks().len()), (32.0, 1), "{style}");
    }
    // The box around an outline is not known.
    assert_eq!(parsed(&format!("<g stroke='red'>{}</g>", rect("inset(1px)"))).remarks().len(), 1);
}

#[test]
fn curves_are_clipped_as_curves() {
    let set_area = |inner: &str| {
        let drawing = super::read_regions(svg(inner).as_bytes()).unwrap();
        drawing.check().unwrap();
        let curves = drawing.curves().iter();
        let areas =
            curves.map(|curve| curve.curve(drawing.order(), &EndCondition::NotAKnot).unwrap().signed_area());
        (drawing.curves().len(), areas.sum::<f64>())
    };
    for (inner, count, expected) in [
        (
            "<clipPath id='c'><rect width='9' height='9'/></clipPath><circle id='o' r='2' clip-path='url(#c)'/>",
            1,
            PI,
        ),
        (
            "<clipPath id='c'><circle r='2'/></clipPath><rect width='9' height='9' clip-path='url(#c)'/>",
            1,
            PI,
        ),
        (
            "<clipPath id='c'><circle r='2'/><circle cx='9' r='2'/></clipPath><rect x='-9' width='50' height='9' clip-path='url(#c)'/>",
            2,
            4.0 * PI,
        ),
        (
            "<mask id='m'><rect width='9' height='9' fill='white'/><circle cx='4' cy='4' r='2'/></mask><rect width='9' height='9' mask='url(#m)'/>",
            2,
            81.0 - 4.0 * PI,
        ),
        (
            "<clipPath id='c'><rect width='3' height='9'/></clipPath><rect width='9' height='9' clip-path='url(#c)'/>",
            1,
            27.0,
        ),
        (
            "<clipPath id='c'><rect width='3' height='9'/></clipPath><rect x='5' width='9' height='9' clip-path='url(#c)'/><circle r='1'/>",
            1,
            PI,
        ),
        ("<svg width='2' height='2'><circle r='2'/><circle cx='9' r='2'/></svg>", 1, PI),
    ] {
        let (curves, found) = set_area(inner);
        assert_eq!(curves, count, "{inner}");
        assert!((found - expected).abs() < 1e-7, "{inner}: {found} for {expected}");
    }
}

#[test]
fn what_clips_itself_or_nothing_is_said() {
    let rect = format!("<rect {TEN} clip-path='url(#c)'/>");
    for (clip, count) in [
        ("", 1),
        ("<rect id='c' width='2' height='2'/>", 1),
        ("<clipPath id='c'><text>a</text></clipPath>", 1),
        // The inner reference is the one that is passed over.
        ("<clipPath id='c' clip-path='url(#c)'><rect width='20' height='20'/></clipPath>", 1),
        ("<clipPath id='c'><rect width='20' height='20' clip-path='url(#c)'/></clipPath>", 1),
    ] {
        let model = parsed(&format!("<defs>{clip}</defs>{rect}"));
        assert_eq!((area(&model), model.remarks().len()), (100.0, 1), "{clip}");
        assert_eq!(model.remarks()[0].count, count, "{clip}");
        assert!(model.remarks()[0].message.contains("1 clip-path"), "{:?}", model.remarks());
    }
    let other = parsed(&format!("<rect {TEN} clip-path='url(other.svg#c)'/>"));
    assert_eq!((area(&other), other.remarks().len()), (100.0, 1));
}

#[test]
fn clips_of_clips_end() {
    // Each clip path names the next one twice: a tree of 2^40 clips.
    let mut text = "<clipPath id='c0'><rect width='2' height='2'/></clipPath>".to_owned();
    for level in 1..30 {
        let below = level - 1;
        text += &format!(
            "<clipPath id='c{level}'><rect width='9' height='9' clip-path='url(#c{below})'/><rect x='1' width='9' height='9' clip-path='url(#c{below})'/></clipPath>"
        );
    }
    assert_eq!(clean_area(&format!("{text}<rect {TEN} clip-path='url(#c29)'/>")), 4.0);
    let mut deep = "<clipPath id='c0'/>".to_owned();
    for level in 1..50 {
        let below = level - 1;
        deep += &format!("<clipPath id='c{level}' clip-path='url(#c{below})'><rect {TEN}/></clipPath>");
    }
    let error = read(svg(&format!("{deep}<rect {TEN} clip-path='url(#c49)'/>")).as_bytes()).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::TooLarge, "{error}");
    let many = format!("<rect {TEN} transform='rotate(2)' clip-path='url(#c)'/>").repeat(40_000);
    assert_eq!(parsed(&format!("<clipPath id='c'><rect {TEN}/></clipPath>{many}")).lines().len(), 40_000);
}

#[test]
fn combs_across_combs_are_refused() {
    let comb = |turn: bool| {
        let teeth = (0..3000).map(|i| {
            let [x, y] = [f64::from(i), if i % 2 == 0 { 0.0 } else { 3000.0 }];
            if turn { format!("{y},{x} ") } else { format!("{x},{y} ") }
        });
        teeth.collect::<String>()
    };
    let clip = format!("<clipPath id='c'><polygon points='{}'/></clipPath>", comb(false));
    for shape in ["<polygon clip-path='url(#c)'", "<polyline fill='none' clip-path='url(#c)'"] {
        let text = format!("{clip}<rect x='-9' width='1' height='1'/>{shape} points='{}'/>", comb(true));
        let error = read(svg(&text).as_bytes()).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::TooLarge, "{error}");
        assert!(error.to_string().contains("cross too often") && error.line().is_some(), "{error}");
    }
}

/// How often rings wind around a point, in floating point.
fn winding<'a>(rings: impl Iterator<Item = &'a [[f64; 2]]>, [x, y]: [f64; 2]) -> i64 {
    let sides = rings.flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
    let crossing = |([a, b], [c, d]): ([f64; 2], [f64; 2])| {
        let side = (c - a) * (y - b) - (x - a) * (d - b);
        match (b <= y, d <= y) {
            (true, false) if side > 0.0 => 1,
            (false, true) if side < 0.0 => -1,
            _ => 0,
        }
    };
    sides.map(|(&p, &q)| crossing((p, q))).sum()
}

fn polygon() -> impl Strategy<Value = Vec<[f64; 2]>> {
    proptest::collection::vec([0..13u8, 0..13u8], 3..9)
        .prop_map(|corners| corners.into_iter().map(|corner| corner.map(f64::from)).collect())
}

fn points_text(corners: &[[f64; 2]]) -> String {
    corners.iter().map(|[x, y]| format!("{x},{y} ")).collect()
}

/// The area of a combination of drawings that are files of their own, each of one shape.
fn combined_area(drawings: &[Model], formula: impl Fn(&[bool]) -> bool) -> f64 {
    let (mut flat, mut rings, mut regions) = (Vec::new(), RaggedArray::new(), Vec::new());
    for (drawing, number) in drawings.iter().zip(0..) {
        for line in 0..drawing.lines().len() {
            let ring = corners(drawing, line);
            let start = flat.len() as u32 / 2;
            flat.extend_from_slice(ring[1..].as_flattened());
            rings.push(&(start..flat.len() as u32 / 2).collect::<Vec<u32>>());
            regions.push(number);
        }
    }
    let rules: Vec<bool> =
        drawings.iter().map(|drawing| column(drawing, "fill_rule").first() == Some(&1)).collect();
    let overlay = PlanarOverlay::new(&Positions::from_flat(2, flat).unwrap(), &rings, &regions).unwrap();
    let found = overlay.select(|windings| {
        let mut is_in = vec![false; drawings.len()];
        for &(region, winding) in windings {
            is_in[region as usize] = !rules[region as usize] || winding % 2 != 0;
        }
        formula(&is_in)
    });
    found.unwrap().area()
}

/// Corners on a grid, so that they and their sides often coincide, or anywhere.
fn any_polygon() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let fine = proptest::collection::vec([0..130_000u32, 0..130_000u32], 3..12);
    let fine = fine.prop_map(|corners| {
        corners.into_iter().map(|corner| corner.map(|x| f64::from(x) * 1e-4)).collect::<Vec<[f64; 2]>>()
    });
    prop_oneof![polygon(), fine]
}

#[test]
fn neighbors_that_are_clipped_alike_still_share_their_side() {
    let clip = "M1 0L8 3L3 9z";
    let halves = ["M0 0h10L0 7z", "M10 0v10h-10v-3z"].map(|half| {
        parsed(&format!(
            "<clipPath id='c'><path d='{clip}'/></clipPath><path d='{half}' clip-path='url(#c)'/>"
        ))
    });
    let whole = parsed(&format!("<path d='{clip}'/>"));
    let both = combined_area(&halves, |is_in| is_in[0] || is_in[1]);
    assert!((both - area(&whole)).abs() < 1e-13);
    assert_eq!(combined_area(&halves, |is_in| is_in[0] && is_in[1]), 0.0);
}

#[test]
fn other_formats_have_the_clipped_shapes() {
    let comb = "<clipPath id='c'><rect width='2' height='9'/><rect x='4' width='2' height='9'/></clipPath>";
    let model = parsed(&format!("{comb}<rect {TEN} clip-path='url(#c)'/>"));
    let mut text = Vec::new();
    crate::wkt::write(&model, &mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    assert!(text.starts_with("MULTIPOLYGON (((") && text.lines().count() == 1, "{text}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn what_is_read_is_the_intersection_of_shape_and_clips(
        polygons in proptest::array::uniform4(any_polygon()),
        rules in proptest::array::uniform4(any::<bool>()),
    ) {
        let word = |i: usize| if rules[i] { "evenodd" } else { "nonzero" };
        let shape = |i: usize, attributes: &str| {
            let (points, rule) = (points_text(&polygons[i]), word(i));
            format!("<polygon points='{points}' fill-rule='{rule}' clip-rule='{rule}' {attributes}/>")
        };
        let clipped = parsed(&format!(
            "<clipPath id='c'>{}{}</clipPath><clipPath id='d'>{}</clipPath><g clip-path='url(#d)'>{}</g>",
            shape(0, ""), shape(1, ""), shape(2, ""), shape(3, "clip-path='url(#c)'")
        ));
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| parsed(&shape(i, "")));
        let mut files = vec![a, b, c, d];
        let formula = |is_in: &[bool]| (is_in[0] || is_in[1]) && is_in[2] && is_in[3];
        let expected = combined_area(&files, formula);
        let found = combined_area(std::slice::from_ref(&clipped), |is_in| is_in[0]);
        prop_assert!((found - expected).abs() <= 1e-11, "{} for {}", found, expected);
        // Nothing of it is elsewhere, but for rounding.
        files.push(clipped);
        let elsewhere = combined_area(&files, |is_in| is_in[4] && !formula(is_in));
        prop_assert!(elsewhere <= 1e-11, "{} is elsewhere", elsewhere);
    }

    #[test]
    fn a_point_is_seen_where_it_is_in_the_shape_and_in_its_clips(
        shape in polygon(),
        clips in [polygon(), polygon(), polygon()],
        rules in proptest::array::uniform4(any::<bool>()),
        points in proptest::collection::vec([0.0..13.0f64, 0.0..13.0], 40),
    ) {
        let word = |rule: bool| if rule { "evenodd" } else { "nonzero" };
        let [a, b, c] = [0, 1, 2].map(|i| {
            format!("<polygon clip-rule='{}' points='{}'/>", word(rules[i]), points_text(&clips[i]))
        });
        let text = format!(
            "<clipPath id='u'>{a}{b}</clipPath><clipPath id='v'>{c}</clipPath>\
             <g clip-path='url(#v)'><polygon clip-path='url(#u)' fill-rule='{}' points='{}'/></g>",
            word(rules[3]), points_text(&shape)
        );
        let model = parsed(&text);
        let lines: Vec<Vec<[f64; 2]>> = (0..model.lines().len()).map(|line| corners(&model, line)).collect();
        let own = column(&model, "fill_rule");
        let is_odd = own.first() == Some(&1);
        for point in points {
            let is_in = |ring: &[[f64; 2]], rule: bool| {
                let winding = winding([ring].into_iter(), point);
                if rule { winding % 2 != 0 } else { winding != 0 }
            };
            let expected = is_in(&shape, rules[3])
                && is_in(&clips[2], rules[2])
                && (is_in(&clips[0], rules[0]) || is_in(&clips[1], rules[1]));
            let found = winding(lines.iter().map(|line| &line[..line.len() - 1]), point);
            let found = if is_odd { found % 2 != 0 } else { found != 0 };
            prop_assert_eq!(found, expected, "{:?} of {}", point, text);
        }
    }

    #[test]
    fn a_line_is_cut_where_its_points_are_not_seen(line in polygon(), clip in polygon(), rule: bool) {
        let text = format!(
            "<clipPath id='c'><polygon clip-rule='{}' points='{}'/></clipPath><rect x='99' width='1' height='1'/>\
             <polyline fill='none' clip-path='url(#c)' points='{}'/>",
            if rule { "evenodd" } else { "nonzero" }, points_text(&clip), points_text(&line)
        );
        let model = parsed(&text);
        let length = |ends: &[[f64; 2]]| (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]);
        let found: f64 = (1..model.lines().len())
            .flat_map(|line| corners(&model, line).windows(2).map(length).collect::<Vec<f64>>())
            .sum();
        // By many points: each stands for a piece of its side.
        let expected: f64 = line
            .windows(2)
            .map(|ends| {
                let inside = (0..1000).filter(|i| {
                    let t = (f64::from(*i) + 0.5) / 1000.0;
                    // A little beside it, so that it is on no side.
                    [1e-7, -1e-7].iter().any(|off| {
                        let point = [0, 1].map(|axis| {
                            let along = ends[0][axis] * (1.0 - t) + ends[1][axis] * t;
                            let across = [ends[0][1] - ends[1][1], ends[1][0] - ends[0][0]][axis];
                            along + across * off
                        });
                        let winding = winding([&clip[..]].into_iter(), point);
                        if rule { winding % 2 != 0 } else { winding != 0 }
                    })
                });
                inside.count() as f64 / 1000.0 * length(ends)
            })
            .sum();
        prop_assert!((found - expected).abs() < 0.2, "{} for {} of {}", found, expected, text);
    }
}
