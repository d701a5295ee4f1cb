//! Faces in space with holes, as triangles.

use coface_geometry::predicates::orientation;
use coface_geometry::triangulation::{triangulate, triangulate_sides};
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// The triangles of a surface with holes, which run as its outer ring does; `None` if the rings cross. Directions of
/// holes are corrected, and sides run through the vertices of other rings on them.
pub(crate) fn triangulated(rings: &mut [Vec<u32>], point: impl Fn(u32) -> [f64; 3]) -> Option<Vec<[u32; 3]>> {
    // The normal of the outer ring, by the formula of M. E. Newell.
    let normal_along = |ring: &[u32], axis: usize| {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let origin = point(ring[0]);
        let relative = |vertex: u32| {
            let point = point(vertex);
            [point[u] - origin[u], point[v] - origin[v]]
        };
        let next = ring.iter().skip(1).chain(ring.first());
        let sides = ring.iter().zip(next).map(|(&a, &b)| [relative(a), relative(b)]);
        sides.map(|[a, b]| a[0] * b[1] - a[1] * b[0]).sum::<f64>()
    };
    let normal = [0, 1, 2].map(|axis| normal_along(&rings[0], axis));
    let axis = (0..3).max_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs()))?;
    let is_turned = normal[axis] < 0.0;
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let (u, v) = if is_turned { (v, u) } else { (u, v) };
    for hole in &mut rings[1..] {
        if (normal_along(hole, axis) < 0.0) == is_turned {
            hole.reverse();
        }
    }
    let flat = |vertex: u32| {
        let point = point(vertex);
        [point[u], point[v]]
    };
    let compare = |a: u32, b: u32| {
        // Zeros of both signs are equal.
        let [[a, b], [c, d]] = [flat(a), flat(b)].map(|point| point.map(|x| x + 0.0));
        a.total_cmp(&c).then(b.total_cmp(&d))
    };
    let turn = |a: u32, b: u32, c: u32| -> Ordering { orientation(flat(a), flat(b), flat(c)) };
    if let Ok(triangles) = triangulate(rings, compare, turn) {
        return Some(triangles);
    }
    let is_on = |vertex: u32, [a, b]: [u32; 2]| {
        let is_between = compare(a, vertex) != compare(b, vertex)
            && compare(a, vertex).is_ne()
            && compare(b, vertex).is_ne();
        is_between && turn(a, b, vertex).is_eq()
    };
    let mut through = rings.to_vec();
    let vertices: Vec<u32> = rings.concat();
    for ring in &mut through {
        let mut longer = Vec::new();
        for (i, &from) in ring.iter().enumerate() {
            let to = ring[(i + 1) % ring.len()];
            let mut on: Vec<u32> =
                vertices.iter().copied().filter(|&vertex| is_on(vertex, [from, to])).collect();
            on.sort_by(|&a, &b| if compare(from, to).is_lt() { compare(a, b) } else { compare(b, a) });
            on.dedup();
            longer.push(from);
            longer.extend(on);
        }
        *ring = longer;
    }
    // A hole that runs along its face, or two that run along each other, has sides that bound nothing there.
    let sides_of = |ring: &[u32]| -> Vec<[u32; 2]> {
        ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| [a, b]).collect()
    };
    let all: Vec<Vec<[u32; 2]>> = through.iter().map(|ring| sides_of(ring)).collect();
    let mut runs: BTreeMap<[u32; 2], usize> = BTreeMap::new();
    for (ring, sides) in all.iter().enumerate() {
        runs.extend(sides.iter().map(|&side| (side, ring)));
    }
    let is_bound = |ring: usize, &[a, b]: &[u32; 2]| runs.get(&[b, a]).is_none_or(|&other| other == ring);
    let sides: Vec<[u32; 2]> = all
        .iter()
        .enumerate()
        .flat_map(|(ring, sides)| sides.iter().copied().filter(move |side| is_bound(ring, side)))
        .collect();
    triangulate_sides(&sides, compare, turn).ok()
}
