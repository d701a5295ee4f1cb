//! Arcs of circles in drawings, which become chords.

use super::drawing::Place;
use coface_algebra::{Error, ErrorKind};
use coface_geometry::predicates::orientation;
use std::cmp::Ordering;
use std::f64::consts::{PI, TAU};

/// The angle of a chord where no distance is asked for: 32 chords for a quarter of a circle, as `ST_CurveToLine` of PostGIS makes them.
const STEP: f64 = PI / 64.0;
/// The most chords that half of an arc becomes.
const MOST: f64 = 65_536.0;

/// Chords of an arc.
pub(super) struct Chords {
    /// The places behind the first one, up to the end.
    pub(super) places: Vec<Place>,
    /// How far the arc is from its chords at most.
    pub(super) distance: f64,
}

/// The chords of the arc that begins at a place and goes through a second one to a third, whose ends and middle are the given places. If the
/// ends are equal it is a whole circle, of which the middle is the opposite place; places on one line are joined by straight sides.
/// Arcs are the same in both directions, so that features which share one still share it.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] if the circle is beyond the range of numbers; [`ErrorKind::TooLarge`] if the distance asks for more than
/// 131,072 chords.
pub(super) fn chords([from, middle, to]: [Place; 3], distance: Option<f64>) -> Result<Chords, Error> {
    let key = |place: Place| (place.x, place.y, place.z);
    if key(to) < key(from) {
        let mut found = chords([to, middle, from], distance)?;
        found.places.pop();
        found.places.reverse();
        found.places.push(to);
        return Ok(found);
    }
    let flat = |place: Place| [place.x, place.y];
    let turn = orientation(flat(from), flat(middle), flat(to));
    let is_circle = flat(from) == flat(to) && flat(from) != flat(middle);
    if turn.is_eq() && !is_circle {
        return Ok(Chords { places: vec![middle, to], distance: 0.0 });
    }
    let origin = flat(from);
    let own = |place: Place| [place.x - origin[0], place.y - origin[1]];
    let center = if is_circle { own(middle).map(|x| x / 2.0) } else { center(own(middle), own(to)) };
    let radius = center[0].hypot(center[1]);
    if !radius.is_finite() || radius == 0.0 {
        let message = format!(
            "the circle through ({}, {}), ({}, {}) and ({}, {}) is beyond the range of numbers",
            from.x, from.y, middle.x, middle.y, to.x, to.y
        );
        return Err(Error::invalid(message).with_cure("write a straight side there"));
    }
    let angle = |place: [f64; 2]| (place[1] - center[1]).atan2(place[0] - center[0]);
    let sign = if turn == Ordering::Less { -1.0 } else { 1.0 };
    let step = match distance {
        Some(distance) => 2.0 * (1.0 - (distance / radius).min(1.0)).acos(),
        None => STEP,
    };
    let mut found = Chords { places: Vec::new(), distance: 0.0 };
    for [a, b] in [[from, middle], [middle, to]] {
        let start = angle(own(a));
        let sweep = (sign * (angle(own(b)) - start)).rem_euclid(TAU);
        let count = (sweep / step).ceil().max(1.0);
        if count > MOST {
            let message = format!("an arc of radius {radius} has more than {MOST} chords at this distance");
            return Err(
                Error::new(ErrorKind::TooLarge, message).with_cure("give a larger distance of chords")
            );
        }
        found.distance = found.distance.max(radius * (1.0 - (sweep / count / 2.0).cos()));
        for i in 1..count as u32 {
            let part = f64::from(i) / count;
            let (sin, cos) = (start + sign * sweep * part).sin_cos();
            let height = |low: f64, high: f64| low * (1.0 - part) + high * part;
            found.places.push(Place {
                x: origin[0] + (center[0] + radius * cos),
                y: origin[1] + (center[1] + radius * sin),
                z: a.z.zip(b.z).map(|(low, high)| height(low, high)),
            });
        }
        found.places.push(b);
    }
    Ok(found)
}

/// The center of the circle through the origin and two places.
fn center([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    let (first, second) = (a * a + b * b, c * c + d * d);
    let double = 2.0 * (a * d - b * c);
    [(d * first - b * second) / double, (a * second - c * first) / double]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn place([x, y]: [f64; 2]) -> Place {
        Place { x, y, z: None }
    }

    #[test]
    fn half_a_circle_has_64_chords() {
        let found = chords([[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]].map(place), None).unwrap();
        assert_eq!(found.places.len(), 64);
        assert_eq!((found.places[31], found.places[63]), (place([0.0, 1.0]), place([-1.0, 0.0])));
        assert!(found.places.iter().all(|p| (p.x.hypot(p.y) - 1.0).abs() < 1e-15 && p.y >= 0.0));
        assert!((found.distance - (1.0 - (PI / 128.0).cos())).abs() < 1e-15);
        // The other way round the lower half.
        let low = chords([[1.0, 0.0], [0.0, -1.0], [-1.0, 0.0]].map(place), Some(0.5)).unwrap();
        assert_eq!(low.places.len(), 2);
        let circle = chords([[1.0, 0.0], [-1.0, 0.0], [1.0, 0.0]].map(place), None).unwrap();
        assert_eq!((circle.places.len(), circle.places[127]), (128, place([1.0, 0.0])));
        let straight = chords([[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]].map(place), None).unwrap();
        assert_eq!((straight.places.len(), straight.distance), (2, 0.0));
        assert!(chords([[0.0, 0.0], [1e200, 1.0], [3.0, 3e200]].map(place), None).is_err());
        assert!(chords([[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]].map(place), Some(1e-12)).is_err());
    }

    proptest! {
        #[test]
        fn arcs_are_on_their_circles_and_the_same_both_ways(
            ends in prop::array::uniform3(prop::array::uniform2(-50..50i32)),
            offset in 0..1_000_000i32,
            tolerance in 1..1000u32,
        ) {
            let [a, b, c] = ends.map(|end| end.map(|x| f64::from(x + offset)));
            prop_assume!(a != b && b != c && orientation(a, b, c).is_ne());
            let tolerance = f64::from(tolerance) / 1e4;
            let there = chords([a, b, c].map(place), Some(tolerance)).unwrap();
            prop_assert!(there.distance <= tolerance * (1.0 + 1e-9));
            let mut back = chords([c, b, a].map(place), Some(tolerance)).unwrap().places;
            back.reverse();
            prop_assert_eq!(&back[1..], &there.places[..there.places.len() - 1]);
            prop_assert_eq!(there.places.last(), Some(&place(c)));
            prop_assert!(there.places.contains(&place(b)));
            let [m, e] = [b, c].map(|end| [end[0] - a[0], end[1] - a[1]]);
            let [x, y] = center(m, e);
            let radius = x.hypot(y);
            let mut last = a;
            for p in &there.places {
                let own = [p.x - a[0] - x, p.y - a[1] - y];
                prop_assert!((own[0].hypot(own[1]) - radius).abs() < 1e-9 * (1.0 + radius));
                // All chords turn the way of the arc.
                prop_assert!(orientation([a[0] + x, a[1] + y], last, [p.x, p.y]) == orientation(a, b, c));
                last = [p.x, p.y];
            }
        }
    }
}
