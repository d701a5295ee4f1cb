//! The pieces of polygons: triangles that fill each polygon without overlap.

use crate::point::{Plane, Point, turn};
use crate::solids::{Polygon, Solids};
use coface_check::Fault;
use coface_check::json::{field, index, list};
use serde_json::Value;
use std::collections::BTreeMap;

const STEP: &str = "pieces";

/// A triangle of the arrangement.
pub(crate) struct Piece {
    /// Its corners by their numbers; it is seen from its front where they turn counterclockwise.
    pub(crate) corners: [u32; 3],
    /// The inputs whose polygons it is a part of, with how many of these have the same front, less those that have the other.
    pub(crate) sources: Vec<(u32, i64)>,
}

/// All vertices, and the different pieces.
pub(crate) struct Pieces {
    pub(crate) vertices: Vec<Point>,
    pub(crate) pieces: Vec<Piece>,
}

impl Pieces {
    /// Reads a proof, and tests that the pieces fill the polygons.
    pub(crate) fn read(proof: &Value, solids: &Solids) -> Result<Self, Fault> {
        let listed = list(field(proof, "vertices", "vertices")?, "\"vertices\"", "vertices")?;
        let vertices = listed.iter().map(|vertex| Point::read(vertex, "vertices"));
        let vertices = vertices.collect::<Result<Vec<Point>, Fault>>()?;
        let polygons = list(field(proof, "polygons", STEP)?, "\"polygons\"", STEP)?;
        if polygons.len() != solids.polygons.len() {
            let [here, there] = [solids.polygons.len(), polygons.len()];
            return Err(Fault::new(
                STEP,
                format!("the inputs have {here} polygons, and the proof has {there}"),
            ));
        }
        let mut found: BTreeMap<[u32; 3], BTreeMap<u32, i64>> = BTreeMap::new();
        for (number, (polygon, said)) in solids.polygons.iter().zip(polygons).enumerate() {
            let fault = |message: &str| Fault::new(STEP, format!("polygon {number}: {message}"));
            for piece in pieces_of(polygon, said, &vertices).map_err(|message| fault(&message))? {
                let (key, sign) = sorted(piece);
                *found.entry(key).or_default().entry(polygon.input).or_default() += sign;
            }
        }
        let pieces = found
            .into_iter()
            .map(|(corners, sources)| Piece { corners, sources: sources.into_iter().collect() });
        let pieces = pieces.collect();
        Ok(Self { vertices, pieces })
    }

    /// The side behind a triangle, seen with its corners turning counterclockwise, that is a piece.
    pub(crate) fn side_behind(&self, corners: [u32; 3]) -> Option<u32> {
        let (key, sign) = sorted(corners);
        let place = self.pieces.binary_search_by_key(&key, |piece| piece.corners).ok()? as u32;
        Some(if sign > 0 { 2 * place + 1 } else { 2 * place })
    }

    /// The corners of a piece.
    pub(crate) fn points(&self, piece: &Piece) -> [&Point; 3] {
        piece.corners.map(|corner| &self.vertices[corner as usize])
    }
}

/// Three numbers in rising order, and 1 if that is a rotation, else -1.
fn sorted([a, b, c]: [u32; 3]) -> ([u32; 3], i64) {
    let mut key = [a, b, c];
    key.sort_unstable();
    let is_rotated = [[a, b, c], [b, c, a], [c, a, b]].contains(&key);
    (key, if is_rotated { 1 } else { -1 })
}

/// The pieces of a polygon: lists of three vertices behind a list of its corners, or the corners alone if they are a triangle that is whole.
/// No pieces are there of a polygon whose corners lie on a line.
fn pieces_of(polygon: &Polygon, said: &Value, vertices: &[Point]) -> Result<Vec<[u32; 3]>, String> {
    let numbers = |value: &Value| -> Result<Vec<u32>, String> {
        let listed = list(value, "a list of vertices", STEP).map_err(|fault| fault.to_string())?;
        let number = |value: &Value| {
            let number = index(value, "a vertex", STEP).map_err(|fault| fault.to_string())?;
            if (number as usize) < vertices.len() {
                Ok(number)
            } else {
                Err(format!("there is no vertex {number}"))
            }
        };
        listed.iter().map(number).collect()
    };
    let lists = list(said, "a polygon", STEP).map_err(|fault| fault.to_string())?;
    let is_whole = lists.iter().all(Value::is_u64);
    let corners = numbers(if is_whole { said } else { &lists[0] })?;
    let is_corner =
        |(place, &vertex): (&[f64; 3], &u32)| vertices[vertex as usize].compare(&Point::of(*place)).is_eq();
    if corners.len() != polygon.corners.len() || !polygon.corners.iter().zip(&corners).all(is_corner) {
        return Err("the corners are not those of the input".to_owned());
    }
    let at = |vertex: u32| &vertices[vertex as usize];
    let Some((plane, axis)) = plane_of(&corners, at)? else {
        return match is_whole || lists.len() == 1 {
            true => Ok(Vec::new()),
            false => Err("it has no area, and pieces".to_owned()),
        };
    };
    if is_whole {
        return <[u32; 3]>::try_from(corners)
            .map(|piece| vec![piece])
            .map_err(|_| "it is no triangle, and has no pieces".to_owned());
    }
    // Where the polygon has a front, the pieces have the same: all turn one way as seen along the axis.
    let mut pieces = Vec::new();
    let mut sides: BTreeMap<[u32; 2], i64> = BTreeMap::new();
    let mut front = None;
    for value in &lists[1..] {
        let piece = <[u32; 3]>::try_from(numbers(value)?).map_err(|_| "a piece is no triangle".to_owned())?;
        let own = turn(piece.map(at), axis);
        if own.is_eq() || front.is_some_and(|front| front != own) {
            return Err(format!("the pieces do not all turn one way: {piece:?}"));
        }
        front = Some(own);
        let is_known = |vertex: u32| corners.len() == 3 && corners.contains(&vertex);
        if let Some(vertex) =
            piece.into_iter().find(|&vertex| !is_known(vertex) && plane.side(at(vertex)).is_ne())
        {
            return Err(format!("vertex {vertex} is not in its plane"));
        }
        for [from, to] in [[piece[0], piece[1]], [piece[1], piece[2]], [piece[2], piece[0]]] {
            *sides.entry([from.min(to), from.max(to)]).or_default() += if from < to { 1 } else { -1 };
        }
        pieces.push(piece);
    }
    // What is left of the sides of the pieces is the boundary of the polygon, each side of it divided by the vertices along it.
    let mut ways: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for ([low, high], times) in sides {
        let (from, to) = if times > 0 { (low, high) } else { (high, low) };
        (0..times.abs()).for_each(|_| ways.entry(from).or_default().push(to));
    }
    for (&from, &to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        follow(from, to, &mut ways, at)?;
    }
    match ways.values().all(Vec::is_empty) {
        true => Ok(pieces),
        false => Err("the pieces have a boundary that is not its own".to_owned()),
    }
}

/// The plane of the corners of a polygon, with an axis along which it is seen as more than a line; none if all corners lie on a line.
///
/// # Errors
/// If they lie in no plane.
fn plane_of<'a>(corners: &[u32], at: impl Fn(u32) -> &'a Point) -> Result<Option<(Plane, usize)>, String> {
    let Some(&first) = corners.first() else { return Ok(None) };
    let Some(&second) = corners.iter().find(|&&corner| at(corner).compare(at(first)).is_ne()) else {
        return Ok(None);
    };
    for &third in corners {
        let three = [first, second, third].map(&at);
        if let Some(axis) = (0..3).find(|&axis| turn(three, axis).is_ne()) {
            let plane = Plane::of(three);
            let mut others = corners.iter().filter(|&&corner| ![first, second, third].contains(&corner));
            return match others.find(|&&corner| plane.side(at(corner)).is_ne()) {
                None => Ok(Some((plane, axis))),
                Some(corner) => {
                    Err(format!("its corners lie in no plane: {first}, {second}, {third} and {corner}"))
                }
            };
        }
    }
    Ok(None)
}

/// Takes the way from one corner of a polygon to the next out of what is left of the sides of its pieces: along the side, never back.
fn follow<'a>(
    from: u32,
    to: u32,
    ways: &mut BTreeMap<u32, Vec<u32>>,
    at: impl Fn(u32) -> &'a Point,
) -> Result<(), String> {
    let way = at(from).compare(at(to));
    let mut here = from;
    while here != to {
        let is_on = |next: u32| {
            next == to
                || (0..3).all(|axis| turn([at(from), at(to), at(next)], axis).is_eq())
                    && at(here).compare(at(next)) == way
                    && at(next).compare(at(to)) == way
        };
        let nexts = ways.entry(here).or_default();
        let place = nexts.iter().position(|&next| is_on(next));
        let place = place.ok_or_else(|| format!("its side from {from} to {to} is not covered"))?;
        here = nexts.swap_remove(place);
    }
    Ok(())
}
