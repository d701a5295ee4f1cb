//! A set as a page of facts.

use coface::answers::text;
use serde_json::Value;

/// So many curves and kinks are listed.
const LISTED: usize = 12;

/// The page of what [`coface::answers::PlanarSet::to_json`] says.
pub(super) fn of(title: &str, object: &Value) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    let whole = |value: &Value| value.as_u64().unwrap_or(0) as usize;
    let pair = |key: &str| [whole(&object[key][0]), whole(&object[key][1])];
    let kind = match (&object["empty"], &object["plane"], &object["bounded"]) {
        (Value::Bool(true), ..) => "the empty set",
        (_, Value::Bool(true), _) => "the whole plane",
        (_, _, Value::Bool(true)) => "bounded",
        _ => "unbounded",
    };
    fact("set", kind.to_owned(), "");
    let gloss = match object["order"].as_u64() {
        Some(2) => "polylines".to_owned(),
        Some(4) => "cubic splines".to_owned(),
        order => format!("splines of degree {}", order.unwrap_or(1) - 1),
    };
    fact("order", object["order"].to_string(), &gloss);
    match object["area"].as_f64() {
        Some(area) => fact("area", text::number(area), ""),
        None if object["bounded"] == true => {
            fact("area", "too large".to_owned(), "beyond the range of numbers: scale the set down");
        }
        None => fact("area", "infinite".to_owned(), ""),
    }
    fact("perimeter", text::number(object["perimeter"].as_f64().unwrap_or(0.0)), "");
    let (open, closed) = (pair("betti_open"), pair("betti_closed"));
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
    let curves = object["curves"].as_array().map_or(&[][..], Vec::as_slice);
    let positive = curves.iter().filter(|curve| curve["sign"] == 1).count();
    let value =
        format!("{} positive, {} negative", text::grouped(positive), text::grouped(curves.len() - positive));
    fact("curves", value, "");
    let knots: usize = curves.iter().map(|curve| whole(&curve["knots"])).sum();
    fact("knots", text::grouped(knots), "");
    fact("kinks", text::grouped(whole(&object["kinks"])), "");
    for (number, curve) in curves.iter().enumerate().take(LISTED) {
        let label = if number == 0 { "curve by curve" } else { "" };
        let name = curve["name"].as_str().map_or(String::new(), |name| format!(" \"{name}\""));
        let area = curve["area"].as_f64().map_or("too large".to_owned(), text::number);
        let value = format!("{number}{name}: area {area}");
        let place = match curve["parent"].as_u64() {
            Some(parent) => format!("in curve {parent}"),
            None => "in no other".to_owned(),
        };
        let kinks = curve["kinks"].as_array().map_or(0, Vec::len);
        let gloss = format!(
            "{place}; {}, {}",
            text::count(whole(&curve["knots"]), "knot"),
            text::count(kinks, "kink")
        );
        fact(label, value, &gloss);
    }
    if curves.len() > LISTED {
        fact("", format!("and {} more", text::grouped(curves.len() - LISTED)), "");
    }
    for (number, kink) in object["kink_points"].as_array().into_iter().flatten().enumerate().take(LISTED) {
        let label = if number == 0 { "kink by kink" } else { "" };
        let [x, y] = [0, 1].map(|axis| text::number(kink["point"][axis].as_f64().unwrap_or(0.0)));
        let gloss = format!("knot {} of curve {}", kink["knot"], kink["curve"]);
        fact(label, format!("v{}: ({x}, {y})", kink["vertex"]), &gloss);
    }
    text::facts(title, &facts)
}
