//! No piece runs through the inside of another.

use crate::pieces::{Piece, Pieces};
use crate::point::{Plane, Point, turn};
use crate::tree::{Bounds, Tree};
use coface_check::Fault;
use dashu_int::IBig;
use std::cmp::Ordering;

/// The bounds of a piece.
pub(crate) fn bounds(all: &Pieces, piece: &Piece) -> Bounds {
    let [a, b, c] = all.points(piece).map(Point::bounds);
    [0, 1, 2].map(|axis| {
        let of = |end: usize| [a[axis][end], b[axis][end], c[axis][end]];
        [of(0).into_iter().fold(f64::INFINITY, f64::min), of(1).into_iter().fold(f64::NEG_INFINITY, f64::max)]
    })
}

/// Tests that no piece meets the inside of another in more than a point.
pub(crate) fn apart(all: &Pieces, tree: &Tree, planes: &[Plane]) -> Result<(), Fault> {
    for (p, piece) in all.pieces.iter().enumerate() {
        let mut found = None;
        tree.each(&bounds(all, piece), |q| {
            if q as usize != p && cuts(all, planes, [p, q as usize]) {
                found = Some(q as usize);
            }
            found.is_some()
        });
        if let Some(q) = found {
            let other = &all.pieces[q];
            let message = format!(
                "the triangle {:?} meets the inside of the triangle {:?}",
                other.corners, piece.corners
            );
            return Err(Fault::new("pieces", message));
        }
    }
    Ok(())
}

/// Tests that vertices are different points, and that none lies on an edge that it is no end of: then edges that have more than a point in common
/// are one, and all pieces around a part of an edge have that edge.
pub(crate) fn edge_to_edge(all: &Pieces) -> Result<(), Fault> {
    let mut edges: Vec<[u32; 2]> = all
        .pieces
        .iter()
        .flat_map(|piece| {
            // Corners rise.
            let [a, b, c] = piece.corners;
            [[a, b], [b, c], [a, c]]
        })
        .collect();
    edges.sort_unstable();
    edges.dedup();
    let mut used: Vec<u32> = edges.as_flattened().to_vec();
    used.sort_unstable();
    used.dedup();
    let at = |vertex: u32| &all.vertices[vertex as usize];
    let tree = Tree::new(edges.iter().map(|ends| {
        let [a, b] = ends.map(|end| at(end).bounds());
        [0, 1, 2].map(|axis| [a[axis][0].min(b[axis][0]), a[axis][1].max(b[axis][1])])
    }));
    for vertex in used {
        let mut found = None;
        tree.each(&at(vertex).bounds(), |number| {
            let [a, b] = edges[number as usize];
            let is_on = a != vertex
                && b != vertex
                && (0..3).all(|axis| turn([at(a), at(b), at(vertex)], axis).is_eq())
                && at(a).compare(at(vertex)) != at(b).compare(at(vertex));
            found = found.or(is_on.then_some([a, b]));
            found.is_some()
        });
        if let Some(ends) = found {
            return Err(Fault::new("pieces", format!("vertex {vertex} lies on the edge between {ends:?}")));
        }
    }
    Ok(())
}

/// The sides of the corners of one piece that the plane of another has; corners of both lie on it.
fn sides(all: &Pieces, plane: &Plane, of: &Piece, other: &Piece) -> [Ordering; 3] {
    of.corners.map(|corner| match other.corners.contains(&corner) {
        true => Ordering::Equal,
        false => plane.side(&all.vertices[corner as usize]),
    })
}

/// Whether the second piece meets the inside of the first in more than a point.
fn cuts(all: &Pieces, planes: &[Plane], [p, q]: [usize; 2]) -> bool {
    let [own, other] = [&all.pieces[p], &all.pieces[q]];
    let has = |sides: &[Ordering; 3], wanted: Ordering| sides.contains(&wanted);
    let own_sides = sides(all, &planes[q], own, other);
    if own_sides == [Ordering::Equal; 3] {
        return overlap(all, &planes[p], own, other);
    }
    // The plane of the second goes through the inside of the first only if corners lie on both sides of it.
    if !has(&own_sides, Ordering::Less) || !has(&own_sides, Ordering::Greater) {
        return false;
    }
    let other_sides = sides(all, &planes[p], other, own);
    // In one corner the second may touch the first.
    let on = other_sides.iter().filter(|side| side.is_eq()).count();
    let is_through = has(&other_sides, Ordering::Less) && has(&other_sides, Ordering::Greater);
    if !is_through && on < 2 {
        return false;
    }
    let (Some(a), Some(b)) = (section(all, own, &planes[q]), section(all, other, &planes[p])) else {
        return false;
    };
    // Both lie on the line of the two planes, where points rise or fall in their order.
    let low = if a[0].compare(&b[0]).is_ge() { &a[0] } else { &b[0] };
    let high = if a[1].compare(&b[1]).is_le() { &a[1] } else { &b[1] };
    low.compare(high).is_lt()
}

/// The ends of the segment that a plane has in common with a piece that is not in it, in their order.
fn section(all: &Pieces, piece: &Piece, plane: &Plane) -> Option<[Point; 2]> {
    let points = all.points(piece);
    let values = points.map(|point| plane.value(point));
    let mut ends: Vec<Point> = Vec::with_capacity(3);
    for i in 0..3 {
        let j = (i + 1) % 3;
        if values[i] == IBig::ZERO {
            ends.push(points[i].clone());
        } else if values[j] != IBig::ZERO && (values[i] < IBig::ZERO) != (values[j] < IBig::ZERO) {
            // The value is linear, and zero at this combination of the two, whose w is made positive.
            let sign = if values[j] < IBig::ZERO { -IBig::ONE } else { IBig::ONE };
            let part =
                |k: usize| (&points[i].exact[k] * &values[j] - &points[j].exact[k] * &values[i]) * &sign;
            ends.push(Point::new([part(0), part(1), part(2), part(3)]));
        }
    }
    ends.sort_by(Point::compare);
    Some([ends.first()?.clone(), ends.last()?.clone()])
}

/// Whether two pieces in one plane have common inside: no side of either has the other on its outer side.
fn overlap(all: &Pieces, plane: &Plane, own: &Piece, other: &Piece) -> bool {
    let normal = plane.normal();
    let axis = (0..3).find(|&axis| *normal[axis] != IBig::ZERO).unwrap_or(0);
    let is_apart = |[of, from]: [&Piece; 2]| {
        let [a, b, c] = all.points(of);
        let front = turn([a, b, c], axis);
        [[a, b], [b, c], [c, a]].into_iter().any(|[start, end]| {
            all.points(from).into_iter().all(|point| turn([start, end, point], axis) != front)
        })
    };
    !is_apart([own, other]) && !is_apart([other, own])
}
