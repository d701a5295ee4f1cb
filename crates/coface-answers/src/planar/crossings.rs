//! Rings that cross themselves.

use super::drawing::{Filling, PlanarDrawing};
use crate::answer::{Place, Remark, RemarkCode};
use coface_algebra::Error;
use coface_arrange::boolean::InsideRule;

/// So many points of rings that cross themselves are found.
pub(super) const MOST_PLACES: usize = 5;

/// The rings that wind around something more than once, or in both directions, rising: each crosses itself, or runs around its
/// inside more than once. `windings` has the least and the greatest winding number of each ring around a face.
pub(super) fn crossed_rings(drawing: &PlanarDrawing, windings: &[[i32; 2]]) -> Vec<u32> {
    let filling = |ring: u32| drawing.polygons[drawing.rings[ring as usize].polygon as usize].filling;
    (0..)
        .zip(windings)
        .filter(|&(ring, [least, most])| most - least > 1 && filling(ring) != Filling::Lines)
        .map(|(ring, _)| ring)
        .collect()
}

/// The remark on these rings; `places` are points where a ring meets itself.
pub(super) fn crossing_remark(
    drawing: &PlanarDrawing,
    rings: &[u32],
    places: impl Fn(u32) -> Vec<[f64; 2]>,
) -> Option<Remark> {
    let &first = rings.first()?;
    let mut found = Vec::new();
    for &ring in rings {
        if found.len() >= MOST_PLACES {
            break;
        }
        found.extend(places(ring).into_iter().map(|point| (ring, point)));
    }
    let subject =
        fault(drawing, first, found.first().filter(|(ring, _)| *ring == first).map(|(_, point)| *point));
    let others = match rings.len() {
        1 => String::new(),
        2 => "; 1 more ring does".to_owned(),
        count => format!("; {} more rings do", count - 1),
    };
    let rule = match drawing.polygons[drawing.rings[first as usize].polygon as usize].filling {
        Filling::Stated(InsideRule::Odd) => {
            "what it winds around an odd number of times, as the drawing says"
        }
        Filling::Stated(_) => "what it winds around, as the drawing says",
        _ => "what it winds around",
    };
    let message = format!(
        "{}: {subject}{others}; inside of such a ring is {rule}, unless --rule says otherwise",
        drawing.model_of_ring(first)
    );
    let places = found.into_iter().map(|(ring, point)| {
        let mut place = Place::point(&point);
        place.file = Some(drawing.model_of_ring(ring).to_owned());
        place
    });
    Some(Remark::new(RemarkCode::SelfCrossingRing, message).at(rings.len(), places))
}

/// `InvalidInput` naming the first of these rings for which the drawing states no rule, with the place.
pub(super) fn refuse_crossings(
    drawing: &PlanarDrawing,
    rings: &[u32],
    places: impl Fn(u32) -> Vec<[f64; 2]>,
) -> Result<(), Error> {
    let is_open = |ring: &&u32| {
        let polygon = drawing.rings[**ring as usize].polygon as usize;
        drawing.polygons[polygon].filling == Filling::OuterWithoutHoles
    };
    let Some(&ring) = rings.iter().find(is_open) else { return Ok(()) };
    Err(Error::invalid(fault(drawing, ring, places(ring).first().copied()))
        .with_cure("say what is inside of it: --rule evenodd or --rule nonzero")
        .in_file(drawing.model_of_ring(ring)))
}

fn fault(drawing: &PlanarDrawing, ring: u32, place: Option<[f64; 2]>) -> String {
    let name = drawing.ring_name(ring);
    match place {
        Some([x, y]) => format!("{name} crosses itself at ({x}, {y})"),
        None => format!("{name} runs around its inside more than once"),
    }
}
