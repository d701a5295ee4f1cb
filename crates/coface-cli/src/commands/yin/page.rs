//! A set as a page of facts.

use coface::answers::answer::{YinCurve, YinEventAnswer, YinKinkPoint, YinSetAnswer};
use coface::answers::text;

/// So many curves and kinks are listed.
const LISTED: usize = 12;

/// So many events are listed.
pub(super) const LISTED_EVENTS: usize = 100;

/// The page of a set, with these kinks and events one by one.
pub(super) fn of(
    title: &str,
    set: &YinSetAnswer,
    kink_points: &[YinKinkPoint],
    events: Option<&[YinEventAnswer]>,
) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    let kind = match (set.empty, set.plane, set.bounded) {
        (true, ..) => "the empty set",
        (_, true, _) => "the whole plane",
        (_, _, true) => "bounded",
        _ => "unbounded",
    };
    fact("set", kind.to_owned(), "");
    let gloss = match set.order {
        2 => "polylines".to_owned(),
        4 => "cubic splines".to_owned(),
        order => format!("splines of degree {}", order - 1),
    };
    fact("order", set.order.to_string(), &gloss);
    match set.area {
        Some(area) => fact("area", text::number(area), ""),
        None if set.bounded => {
            fact("area", "too large".to_owned(), "beyond the range of numbers");
        }
        None => fact("area", "infinite".to_owned(), ""),
    }
    fact("perimeter", too_large_or(set.perimeter), "");
    let (open, closed) = (set.betti_open, set.betti_closed);
    fact(
        "components",
        text::grouped(open[0]),
        "of the open set: parts that touch in points only are different ones",
    );
    fact("holes", text::grouped(open[1]), "of the open set: its first Betti number");
    if open != closed {
        let value = format!("{}, {}", text::grouped(closed[0]), text::grouped(closed[1]));
        fact("closure", value, "components and holes of the closed set");
    }
    let positive = set.curves.iter().filter(|curve| curve.sign == 1).count();
    let negative = set.curves.len() - positive;
    let value = format!("{} positive, {} negative", text::grouped(positive), text::grouped(negative));
    fact("curves", value, "");
    fact("knots", text::grouped(set.curves.iter().map(|curve| curve.knots).sum()), "");
    fact("kinks", text::grouped(set.kinks), "");
    for (number, curve) in set.curves.iter().enumerate().take(LISTED) {
        let label = if number == 0 { "curve by curve" } else { "" };
        let (value, gloss) = line_of(number, curve);
        fact(label, value, &gloss);
    }
    if set.curves.len() > LISTED {
        fact("", format!("and {} more", text::grouped(set.curves.len() - LISTED)), "");
    }
    for (number, kink) in kink_points.iter().enumerate().take(LISTED) {
        let label = if number == 0 { "kink by kink" } else { "" };
        let [x, y] = kink.point.map(text::number);
        let gloss = format!("knot {} of curve {}", kink.knot, kink.curve);
        fact(label, format!("v{}: ({x}, {y})", kink.vertex), &gloss);
    }
    if let Some(events) = events {
        fact("events", text::grouped(events.len()), "changes of the topology and contacts");
        for event in events.iter().take(LISTED_EVENTS) {
            let [x, y] = event.place.map(text::number);
            let counts = [event.before, event.after].map(|counts| {
                let components = text::count(counts.components, "component");
                format!("{components}, {}", text::count(counts.holes, "hole"))
            });
            let gloss = format!("near ({x}, {y}): {} -> {}", counts[0], counts[1]);
            fact("", format!("at time {} {}", text::number(event.time), event.words), &gloss);
        }
        if events.len() > LISTED_EVENTS {
            fact("", format!("and {} more", text::grouped(events.len() - LISTED_EVENTS)), "");
        }
    }
    text::facts(title, &facts)
}

/// What is said of one curve.
fn line_of(number: usize, curve: &YinCurve) -> (String, String) {
    let name = curve.name.as_ref().map_or(String::new(), |name| format!(" \"{name}\""));
    let place = match curve.parent {
        Some(parent) => format!("in curve {parent}"),
        None => "in no other".to_owned(),
    };
    let gloss =
        format!("{place}; {}, {}", text::count(curve.knots, "knot"), text::count(curve.kinks.len(), "kink"));
    (format!("{number}{name}: area {}", too_large_or(curve.area)), gloss)
}

fn too_large_or(number: Option<f64>) -> String {
    number.map_or("too large".to_owned(), text::number)
}
