//! Closed curves with kinks: boundaries of sets in the plane.

use super::faults::Faults;
use crate::scanner::quoted;
use crate::yin::{BoundaryCurve, BoundaryDrawing, Filling};
use crate::{Remark, RemarkCode};
use coface_algebra::Error;
use coface_yin::{Carrier, Curve, Order};
use serde::Deserialize;
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::Value;
use std::fmt;

/// What an object says about curves, before its order is known.
#[derive(Default)]
pub(super) struct CurveKeys {
    pub(super) order: Option<Value>,
    pub(super) plane: Option<Value>,
    pub(super) curves: Option<Vec<RawCurve>>,
    pub(super) next_vertex: Option<Value>,
    /// Keys beside these that say nothing about curves.
    pub(super) others: Vec<String>,
}

/// The keys of a curve.
const CURVE_KEYS: &str = "points, kinks, vertices, name, knots, controls, carriers";
/// So many keys without a meaning are named.
const LISTED_KEYS: usize = 4;

/// A curve with all that stands in its object.
#[derive(Default)]
pub(super) struct RawCurve {
    points: Option<Vec<[f64; 2]>>,
    kinks: Vec<u32>,
    vertices: Option<Vec<u32>>,
    name: Option<Value>,
    knots: Option<Vec<f64>>,
    controls: Option<Vec<[f64; 2]>>,
    carriers: Vec<RawCarrier>,
    /// A key that says nothing.
    other: Option<String>,
}

/// What a piece is a part of.
#[derive(Deserialize)]
struct RawCarrier {
    piece: u32,
    range: [f64; 2],
    growth: f64,
    controls: Vec<[f64; 2]>,
}

impl CurveKeys {
    /// Whether one of the keys is there that make an object one of curves.
    pub(super) fn is_some(&self) -> bool {
        self.curves.is_some() || self.plane.is_some()
    }

    /// The drawing.
    pub(super) fn into_drawing(self) -> Result<BoundaryDrawing, Error> {
        let order = match &self.order {
            None => Order::LINEAR,
            Some(value) => {
                let number = value.as_u64().and_then(|order| usize::try_from(order).ok());
                Order::new(number.unwrap_or(0)).map_err(|error| match number {
                    Some(_) => error,
                    None => Error::invalid("\"order\" is no natural number")
                        .with_cure("give order 2 for polylines, or 4, 6 or 8 for splines"),
                })?
            }
        };
        let is_plane = match &self.plane {
            None | Some(Value::Bool(false)) => false,
            Some(Value::Bool(true)) => true,
            Some(_) => {
                return Err(
                    Error::invalid("\"plane\" is neither true nor false").with_cure("give true or false")
                );
            }
        };
        let curves = self.curves.unwrap_or_default();
        if is_plane {
            if !curves.is_empty() {
                let message = format!("\"plane\" is true, but there are {} curves", curves.len());
                return Err(Error::invalid(message).with_cure("keep to one of them"));
            }
            let mut drawing = BoundaryDrawing::plane(order);
            remark_unknown_keys(&mut drawing, &self.others);
            return Ok(drawing);
        }
        let mut drawing = BoundaryDrawing::new(order);
        remark_unknown_keys(&mut drawing, &self.others);
        let mut unknown = curves.iter().enumerate().filter_map(|(n, curve)| Some((n, curve.other.as_ref()?)));
        if let Some((number, key)) = unknown.next() {
            let more = match unknown.count() {
                0 => String::new(),
                count => format!(" (and other curves too: {count})"),
            };
            drawing.remark(Remark::new(
                RemarkCode::UnknownKey,
                format!(
                    "the key {} of curve {number} says nothing{more}: known are {CURVE_KEYS}",
                    quoted(key.as_bytes())
                ),
            ));
        }
        if let Some(next) = self.next_vertex {
            let next = next.as_u64().and_then(|next| u32::try_from(next).ok());
            let next = next.ok_or_else(|| {
                Error::invalid("\"next_vertex\" is no number of a vertex")
                    .with_cure("give a natural number below 2^32")
            })?;
            drawing.set_next_kink_name(Some(next));
        }
        let mut made: Vec<BoundaryCurve> = Vec::with_capacity(curves.len());
        for (number, mut curve) in curves.into_iter().enumerate() {
            let carriers = std::mem::take(&mut curve.carriers);
            let repeated = curve.drop_repetitions();
            if repeated > 0 {
                let (noun, verb) = if repeated == 1 { ("point", "repeats") } else { ("points", "repeat") };
                let message =
                    format!("{repeated} {noun} of curve {number} {verb} the one before, and count once");
                drawing.remark(Remark::new(RemarkCode::RepeatedVertex, message).at(repeated, []));
            }
            let mut curve = curve.into_curve(number, order)?;
            if !carriers.is_empty() {
                let carriers = carriers
                    .into_iter()
                    .map(|own| Carrier::new(own.piece, &own.controls, own.range, own.growth))
                    .collect::<Result<Vec<_>, _>>();
                if let Err(error) = carriers.and_then(|carriers| curve.set_carriers(carriers, order)) {
                    drawing.remark(Remark::new(
                        RemarkCode::InputReading,
                        format!("the \"carriers\" of curve {number} were left out: {}", error.message()),
                    ));
                }
            }
            made.push(curve);
        }
        let curves = made;
        if !curves.is_empty() {
            drawing.push(Filling::Left, curves);
        }
        drawing.check()?;
        Ok(drawing)
    }
}

impl RawCurve {
    /// Leaves out points that are at the place of the one before, the first again at the end among them, if nothing but kinks depends on their
    /// numbers: how many these were.
    fn drop_repetitions(&mut self) -> usize {
        let (Some(points), None, None) = (&mut self.points, &self.controls, &self.knots) else { return 0 };
        let count = points.len();
        let mut kept: Vec<[f64; 2]> = Vec::with_capacity(count);
        let mut number_of = Vec::with_capacity(count);
        for &point in points.iter() {
            if kept.last() != Some(&point) {
                kept.push(point);
            }
            number_of.push(kept.len() as u32 - 1);
        }
        while kept.len() > 1 && kept.last() == kept.first() {
            kept.pop();
        }
        let names = self.vertices.as_ref().map_or(self.kinks.len(), Vec::len);
        let is_clear = self.kinks.iter().all(|&kink| (kink as usize) < count) && names == self.kinks.len();
        if kept.len() == count || kept.len() < 3 || !is_clear {
            return 0;
        }
        let left = kept.len() as u32;
        let mut kinks: Vec<u32> = Vec::with_capacity(self.kinks.len());
        let mut vertices: Vec<u32> = Vec::new();
        for (at, &kink) in self.kinks.iter().enumerate() {
            let kink = number_of[kink as usize] % left;
            // A kink at both of two equal points is one.
            if !kinks.contains(&kink) {
                kinks.push(kink);
                vertices.extend(self.vertices.as_ref().map(|names| names[at]));
            }
        }
        *points = kept;
        self.kinks = kinks;
        self.vertices = self.vertices.is_some().then_some(vertices);
        count - left as usize
    }

    fn into_curve(self, number: usize, order: Order) -> Result<BoundaryCurve, Error> {
        let named = |error: Error| {
            let renamed = Error::new(error.kind(), format!("curve {number}: {}", error.message()));
            match error.cure() {
                Some(cure) => renamed.with_cure(cure),
                None => renamed,
            }
        };
        let degree = order.degree();
        let points = match (&self.points, &self.controls) {
            (Some(points), _) => points.clone(),
            (None, Some(controls)) => controls.iter().step_by(degree).copied().collect(),
            (None, None) => {
                return Err(Error::invalid(format!("curve {number} has no \"points\""))
                    .with_cure("give the points of each curve"));
            }
        };
        let count = points.len();
        // A curve by its pieces may be one arc that comes back to where it began.
        if count < if self.controls.is_some() && degree > 1 { 1 } else { 2 } {
            return Err(Error::invalid(format!("curve {number} has {count} points, and bounds nothing"))
                .with_cure("give a closed curve at least three points"));
        }
        if count > 2 && points[0] == points[count - 1] {
            return Err(Error::invalid(format!("curve {number} has its first point again at its end"))
                .with_cure("leave it out: curves are closed by themselves"));
        }
        let mut curve = BoundaryCurve::new(points);
        curve.set_kinks(self.kinks);
        if let Some(names) = self.vertices {
            curve.set_kink_names(names);
        }
        curve.set_name(match self.name {
            None | Some(Value::Null) => None,
            Some(Value::String(name)) => Some(name),
            Some(_) => {
                return Err(Error::invalid(format!("the \"name\" of curve {number} is no text"))
                    .with_cure("write names in quotation marks, or leave them out"));
            }
        });
        if let Some(mut controls) = self.controls {
            if controls.len() != count * degree {
                return Err(Error::invalid(format!(
                    "curve {number} has {} control points for {count} points of order {order}",
                    controls.len()
                ))
                .with_cure(format!("give {degree} for each point: those of its piece but the last")));
            }
            if let Some(at) = (0..count).find(|&at| controls[at * degree] != curve.points()[at]) {
                return Err(Error::invalid(format!(
                    "point {at} of curve {number} is not the control point {} that is at its place",
                    at * degree
                ))
                .with_cure("make them equal, or leave the points out"));
            }
            controls.push(controls[0]);
            let knots = match self.knots {
                Some(knots) => knots,
                // One arc that comes back has no chord.
                None if count == 1 => vec![0.0, 1.0],
                None => {
                    let mut closed = curve.points().to_vec();
                    closed.push(closed[0]);
                    Curve::polyline(&closed).map_err(named)?.knots().to_vec()
                }
            };
            if knots.len() != count + 1 {
                return Err(Error::invalid(format!(
                    "curve {number} has {} knots for {count} points",
                    knots.len()
                ))
                .with_cure("give one knot for each point, and one for the first again"));
            }
            curve.set_curve(Curve::from_controls(order, controls, knots).map_err(named)?);
        } else if let Some(knots) = self.knots {
            if order > Order::LINEAR {
                return Err(Error::invalid(format!("curve {number} has \"knots\" but no \"controls\""))
                    .with_cure("give both or neither: curves are fitted by the lengths of chords"));
            }
            curve.set_knots(knots);
        }
        Ok(curve)
    }
}

/// Says which keys beside the curves have no meaning: a word that is spelt wrong would else be passed over unseen.
fn remark_unknown_keys(drawing: &mut BoundaryDrawing, keys: &[String]) {
    if keys.is_empty() {
        return;
    }
    let named: Vec<String> = keys.iter().take(LISTED_KEYS).map(|key| quoted(key.as_bytes())).collect();
    let (noun, verb) = if keys.len() == 1 { ("key", "says") } else { ("keys", "say") };
    let dots = if keys.len() > LISTED_KEYS { ", .." } else { "" };
    drawing.remark(Remark::new(RemarkCode::UnknownKey, format!(
        "the {noun} {}{dots} beside the curves {verb} nothing: known are order, plane, curves, next_vertex, name",
        named.join(", ")
    )));
}

/// The list of curves.
pub(super) struct CurveList<'a>(pub(super) &'a Faults);

impl<'de> DeserializeSeed<'de> for CurveList<'_> {
    type Value = Vec<RawCurve>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for CurveList<'_> {
    type Value = Vec<RawCurve>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of curves")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let mut curves = Vec::new();
        while let Some(curve) = list.next_element_seed(OneCurve { number: curves.len(), faults: self.0 })? {
            curves.push(curve);
        }
        Ok(curves)
    }
}

/// The object of one curve.
struct OneCurve<'a> {
    number: usize,
    faults: &'a Faults,
}

impl<'de> DeserializeSeed<'de> for OneCurve<'_> {
    type Value = RawCurve;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<RawCurve, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for OneCurve<'_> {
    type Value = RawCurve;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "an object with the \"points\" of curve {}", self.number)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<RawCurve, A::Error> {
        let mut curve = RawCurve::default();
        let list = |what: &'static str| List { what, curve: self.number, faults: self.faults };
        while let Some(key) = map.next_key::<String>()? {
            match key.as_str() {
                "points" => curve.points = Some(map.next_value_seed(Points(list("point")))?),
                "controls" => curve.controls = Some(map.next_value_seed(Points(list("control point")))?),
                "kinks" => curve.kinks = map.next_value_seed(Indices(list("kink")))?,
                "vertices" => curve.vertices = Some(map.next_value_seed(Indices(list("vertex")))?),
                "carriers" => curve.carriers = map.next_value()?,
                "knots" => curve.knots = Some(map.next_value_seed(Numbers(list("knot")))?),
                "name" => curve.name = Some(map.next_value()?),
                _ => {
                    map.next_value::<IgnoredAny>()?;
                    curve.other.get_or_insert(key);
                }
            }
        }
        Ok(curve)
    }
}

/// What a list holds, and of which curve.
#[derive(Clone, Copy)]
struct List<'a> {
    what: &'static str,
    curve: usize,
    faults: &'a Faults,
}

impl List<'_> {
    fn expecting(&self, f: &mut fmt::Formatter<'_>, shape: &str) -> fmt::Result {
        write!(f, "{shape} of each {} of curve {}", self.what, self.curve)
    }
}

/// A list of points.
struct Points<'a>(List<'a>);

/// One point.
#[derive(Clone, Copy)]
struct Point<'a> {
    list: List<'a>,
    number: usize,
}

/// A list of numbers.
struct Numbers<'a>(List<'a>);

/// A list of natural numbers.
struct Indices<'a>(List<'a>);

/// A natural number.
struct Index<'a> {
    list: List<'a>,
    number: usize,
}

impl<'de> DeserializeSeed<'de> for Points<'_> {
    type Value = Vec<[f64; 2]>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Points<'_> {
    type Value = Vec<[f64; 2]>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.expecting(f, "a list with two coordinates")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let mut points = Vec::new();
        while let Some(point) = list.next_element_seed(Point { list: self.0, number: points.len() })? {
            points.push(point);
        }
        Ok(points)
    }
}

impl<'de> DeserializeSeed<'de> for Point<'_> {
    type Value = [f64; 2];

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<[f64; 2], D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Point<'_> {
    type Value = [f64; 2];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the two coordinates of {} {} of curve {}", self.list.what, self.number, self.list.curve)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<[f64; 2], A::Error> {
        let mut point = [0.0; 2];
        let mut count = 0;
        while let Some(coordinate) = list.next_element_seed(Coordinate(self))? {
            if let Some(place) = point.get_mut(count) {
                *place = coordinate;
            }
            count += 1;
        }
        if count == 2 {
            return Ok(point);
        }
        let List { what, curve, faults } = self.list;
        Err(faults.raise(
            Error::invalid(format!(
                "{what} {} of curve {curve} has {count} coordinates, and the plane has two",
                self.number
            ))
            .with_cure("give two coordinates for each point"),
        ))
    }
}

/// A coordinate of a point.
struct Coordinate<'a>(Point<'a>);

impl Coordinate<'_> {
    fn fault<E: serde::de::Error>(&self, value: &dyn fmt::Display) -> E {
        let Point { list: List { what, curve, faults }, number } = self.0;
        faults.raise(
            Error::invalid(format!(
                "a coordinate of {what} {number} of curve {curve} is {value}, not a finite number"
            ))
            .with_cure("remove the point, or give it finite coordinates"),
        )
    }
}

impl<'de> DeserializeSeed<'de> for Coordinate<'_> {
    type Value = f64;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<f64, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl Visitor<'_> for Coordinate<'_> {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Point { list, number } = self.0;
        write!(f, "a coordinate of {} {number} of curve {}", list.what, list.curve)
    }

    fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<f64, E> {
        if value.is_finite() { Ok(value) } else { Err(self.fault(&value)) }
    }

    fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<f64, E> {
        Ok(value as f64)
    }

    fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<f64, E> {
        Ok(value as f64)
    }

    fn visit_unit<E: serde::de::Error>(self) -> Result<f64, E> {
        Err(self.fault(&"null"))
    }

    fn visit_str<E: serde::de::Error>(self, value: &str) -> Result<f64, E> {
        Err(self.fault(&quoted(value.as_bytes())))
    }
}

impl<'de> DeserializeSeed<'de> for Numbers<'_> {
    type Value = Vec<f64>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Numbers<'_> {
    type Value = Vec<f64>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.expecting(f, "a list with the number")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let mut numbers = Vec::new();
        while let Some(number) = list.next_element()? {
            numbers.push(number);
        }
        Ok(numbers)
    }
}

impl<'de> DeserializeSeed<'de> for Indices<'_> {
    type Value = Vec<u32>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Indices<'_> {
    type Value = Vec<u32>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.expecting(f, "a list with the natural number")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let mut indices = Vec::new();
        while let Some(index) = list.next_element_seed(Index { list: self.0, number: indices.len() })? {
            indices.push(index);
        }
        Ok(indices)
    }
}

impl<'de> DeserializeSeed<'de> for Index<'_> {
    type Value = u32;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<u32, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl Index<'_> {
    fn fault<E: serde::de::Error>(&self, value: &dyn fmt::Display) -> E {
        let List { what, curve, faults } = self.list;
        faults.raise(
            Error::invalid(format!("{what} {} in the list of curve {curve} is {value}", self.number))
                .with_cure("give natural numbers: points are numbered from 0"),
        )
    }
}

impl Visitor<'_> for Index<'_> {
    type Value = u32;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a natural number: {} {} of curve {}", self.list.what, self.number, self.list.curve)
    }

    fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<u32, E> {
        u32::try_from(value).map_err(|_| self.fault(&value))
    }

    fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<u32, E> {
        Err(self.fault(&value))
    }

    fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<u32, E> {
        Err(self.fault(&value))
    }
}
