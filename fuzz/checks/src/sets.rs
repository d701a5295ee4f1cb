//! Sets in the plane with spline boundaries.

use arbitrary::{Arbitrary, Unstructured};
use coface::YinSet;
use coface::answers::{PlanarSet, SetRequest};
use coface::arrange::boolean::{BooleanFormula, InsideRule};
use coface::io::{Format, ReadOptions, read_boundary, read_boundary_with};
use coface::yin::{Curve, Order, SetLocation};

/// The reader of binary curves: a set is written and read again with as many curves.
pub fn read_yin_dat(bytes: &[u8]) {
    let Ok(drawing) = read_boundary(bytes, Format::Dat, &ReadOptions::default()) else { return };
    if let Ok(set) = PlanarSet::of(&drawing, &SetRequest::default()) {
        let mut written = Vec::new();
        set.write(&mut written, Format::Dat, None).expect("what was read is written");
        let read = read_boundary(&written[..], Format::Dat, &ReadOptions::default());
        assert_eq!(read.map_or(usize::MAX, |read| read.curves().len()), drawing.curves().len());
    }
}

/// The reader of curves as JSON: a set is written so that the same text comes again.
pub fn read_yin_json(bytes: &[u8]) {
    check_set(bytes, Some(Format::Json));
}

/// Curves as text: lists of factories, or any other format that holds sets. A set is written so that the same text comes again.
pub fn read_factories(bytes: &[u8]) {
    check_set(bytes, None);
}

fn check_set(bytes: &[u8], format: Option<Format>) {
    let read = |bytes: &[u8], format: Option<Format>| {
        let drawing = read_boundary_with(bytes, &ReadOptions::default().format(format)).ok()?;
        PlanarSet::of(&drawing, &SetRequest::default()).ok()
    };
    let Some(set) = read(bytes, format) else { return };
    let mut written = Vec::new();
    set.write(&mut written, Format::Json, None).expect("every set is written");
    // Of a set at the limit of what can be told apart, the same is refused.
    let Some(again) = read(&written, Some(Format::Json)) else {
        let drawing = read_boundary(&written[..], Format::Json, &ReadOptions::default());
        let drawing = drawing.expect("what is written is read");
        let error = PlanarSet::of(&drawing, &SetRequest::default()).expect_err("it was refused before");
        assert!(error.to_string().contains("cannot be decided"), "{error}");
        return;
    };
    let mut twice = Vec::new();
    again.write(&mut twice, Format::Json, None).expect("every set is written");
    assert_eq!(written, twice);
}

/// Two sets: rings of small integers by a rule, or circles and ellipses.
#[derive(Arbitrary, Debug)]
struct Sets {
    first: Drawn,
    second: Drawn,
    rule: u8,
}

#[derive(Arbitrary, Debug)]
enum Drawn {
    Rings(Vec<Vec<(u8, u8)>>),
    Circle { center: (u8, u8), radius: u8, pieces: u8, is_cubic: bool },
    Ellipse { center: (u8, u8), axes: (u8, u8), pieces: u8 },
    Fitted(Vec<(u8, u8)>),
}

/// The points of the raster along each axis.
const RASTER: u32 = 12;
/// Points as near as this to a boundary are left out, in the unit of the drawing, whose width is 16.
const NEAR: f64 = 1e-5;

/// Meets, joins, differences and complements of two sets agree with a raster: a point is in the result if it is in the operands as the
/// operation says. Points at a boundary are left out.
pub fn boolean_yin(bytes: &[u8]) {
    let Ok(sets) = Sets::arbitrary(&mut Unstructured::new(bytes)) else { return };
    let rule = [InsideRule::Nonzero, InsideRule::Positive, InsideRule::Odd][usize::from(sets.rule) % 3];
    let (Some(first), Some(second)) = (set_of(&sets.first, rule), set_of(&sets.second, rule)) else { return };
    let xor = BooleanFormula::xor(2);
    let results = [
        first.meet(&second),
        first.join(&second),
        first.difference(&second),
        first.complement(),
        YinSet::combine(&[&first, &second], &xor).map(|combination| combination.into_set()),
    ];
    let expected: [fn(bool, bool) -> bool; 5] =
        [|a, b| a && b, |a, b| a || b, |a, b| a && !b, |a, _| !a, |a, b| a != b];
    for (i, (result, expected)) in results.into_iter().zip(expected).enumerate() {
        // Curves that come too near each other to be told apart are refused with a place.
        let Ok(result) = result else { continue };
        // Corners are rounded, and where they have come to meet the set is repaired.
        assert_eq!(result.validate().expect("a set is looked at"), None, "operation {i} gives no set");
        for row in 0..RASTER {
            for column in 0..RASTER {
                let point =
                    [f64::from(column), f64::from(row)].map(|x| (x + 0.137) * 16.0 / f64::from(RASTER));
                let [a, b, found] = [&first, &second, &result].map(|set| surely(set, point));
                if let (Some(a), Some(b), Some(found)) = (a, b, found) {
                    assert_eq!(found, expected(a, b), "operation {i} at {point:?}");
                }
            }
        }
        if let (Some(area), Some(exact)) = (result.area(), result.exact_area()) {
            let exact = exact.to_f64();
            assert!((area - exact).abs() <= 1e-9 * exact.abs().max(1.0));
        }
    }
}

/// Whether a point is in a set, if the points around it agree.
fn surely(set: &YinSet, [x, y]: [f64; 2]) -> Option<bool> {
    let around = [[x, y], [x - NEAR, y], [x + NEAR, y], [x, y - NEAR], [x, y + NEAR]];
    let found = set.locate_all(&around).ok()?;
    let first = found[0];
    let is_inside = match first {
        SetLocation::Inside => true,
        SetLocation::Outside => false,
        SetLocation::Boundary { .. } => return None,
    };
    found.iter().all(|place| *place == first).then_some(is_inside)
}

fn set_of(drawn: &Drawn, rule: InsideRule) -> Option<YinSet> {
    let point = |&(x, y): &(u8, u8)| [f64::from(x % 17), f64::from(y % 17)];
    let curve = match drawn {
        Drawn::Rings(rings) => {
            let rings: Vec<Vec<[f64; 2]>> =
                rings.iter().take(4).map(|ring| ring.iter().take(8).map(point).collect()).collect();
            return YinSet::from_rings(&rings, rule).ok();
        }
        Drawn::Circle { center, radius, pieces, is_cubic } => {
            let order = if *is_cubic { Order::CUBIC } else { Order::LINEAR };
            Curve::circle(point(center), f64::from(radius % 8) + 0.5, 4 + usize::from(pieces % 8), order)
        }
        Drawn::Ellipse { center, axes: (a, b), pieces } => {
            let axes = [f64::from(a % 8) + 0.25, f64::from(b % 8) + 0.25];
            Curve::ellipse(point(center), axes, 4 + usize::from(pieces % 8), Order::CUBIC)
        }
        Drawn::Fitted(points) => {
            let mut points: Vec<[f64; 2]> = points.iter().take(10).map(point).collect();
            points.push(*points.first()?);
            Curve::fit(&points, Order::CUBIC, &coface::yin::EndCondition::Periodic)
        }
    };
    YinSet::new(&[curve.ok()?]).ok()
}
