//! Drawings in the plane.

use super::{Point, minus, moved, number, quotient, turn};
use coface_algebra::{Rational, UnionFind};
use std::collections::{BTreeMap, BTreeSet};

/// A bounded face of a drawing.
pub(crate) struct Face {
    /// Vertices around it with the face on the left, the outer walk first.
    pub(crate) walks: Vec<Vec<usize>>,
    /// Twice the area.
    pub(crate) doubled: Rational,
    /// A point inside.
    pub(crate) inside: Point,
}

/// The bounded faces of edges that meet only in their ends.
pub(crate) fn bounded_faces(points: &[Point], edges: &[[usize; 2]]) -> Vec<Face> {
    let mut around: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    let mut components = UnionFind::new(points.len());
    for &[a, b] in edges {
        around.entry(a).or_default().push(b);
        around.entry(b).or_default().push(a);
        components.unite(a as u32, b as u32);
    }
    for (&from, neighbors) in &mut around {
        neighbors.sort_by(|&p, &q| {
            let [u, v] = [p, q].map(|to| minus(&points[to], &points[from]));
            let half = |d: &Point| (&d[1], &d[0]) < (&Rational::ZERO, &Rational::ZERO);
            half(&u).cmp(&half(&v)).then_with(|| Rational::ZERO.cmp(&turn(&u, &v)))
        });
    }
    let mut seen: BTreeSet<[usize; 2]> = BTreeSet::new();
    let (mut faces, mut holes) = (Vec::new(), Vec::new());
    for start in edges.iter().flat_map(|&[a, b]| [[a, b], [b, a]]) {
        let (mut at, mut walk, mut doubled) = (start, Vec::new(), Rational::ZERO);
        while seen.insert(at) {
            walk.push(at[0]);
            doubled += &turn(&points[at[0]], &points[at[1]]);
            let neighbors = &around[&at[1]];
            let place = neighbors.iter().position(|&to| to == at[0]).unwrap();
            at = [at[1], neighbors[(place + neighbors.len() - 1) % neighbors.len()]];
        }
        if doubled > Rational::ZERO {
            let inside = left_of(points, edges, [walk[0], walk[1 % walk.len()]]);
            faces.push((Face { walks: vec![walk], doubled: doubled.clone(), inside }, doubled));
        } else if !walk.is_empty() {
            holes.push((walk, doubled));
        }
    }
    // The outside of a component is a hole of the smallest face around it.
    for (walk, doubled) in holes {
        let first = walk[0];
        let around = faces.iter_mut().filter(|(face, _)| {
            let outer = &face.walks[0];
            !components.same(outer[0] as u32, first as u32)
                && winding(outer.iter().map(|&v| &points[v]), &points[first]).unwrap() != 0
        });
        if let Some((face, _)) = around.min_by(|x, y| x.1.cmp(&y.1)) {
            face.walks.push(walk);
            face.doubled += &doubled;
        }
    }
    faces.into_iter().map(|(face, _)| face).collect()
}

/// A point on the left of an edge, nearer to it than all other edges and vertices.
fn left_of(points: &[Point], edges: &[[usize; 2]], [a, b]: [usize; 2]) -> Point {
    let half = quotient(&Rational::ONE, &number(2));
    let [a, b] = [a, b].map(|v| &points[v]);
    let along = minus(b, a);
    let ray = [-&along[1], along[0].clone()];
    let start = moved(a, &half, &along);
    let mut nearest: Option<Rational> = None;
    // Vertices on their own are not hit either.
    for point in points {
        let offset = minus(point, &start);
        if turn(&offset, &ray).is_zero() {
            keep_nearest(&mut nearest, quotient(&super::dot(&offset, &ray), &super::dot(&ray, &ray)));
        }
    }
    for &[c, d] in edges {
        let [c, d] = [c, d].map(|v| &points[v]);
        let (edge, offset) = (minus(d, c), minus(c, &start));
        let Some(inverse) = turn(&ray, &edge).inverse() else { continue };
        let place = &turn(&offset, &ray) * &inverse;
        if place >= Rational::ZERO && place <= Rational::ONE {
            keep_nearest(&mut nearest, &turn(&offset, &edge) * &inverse);
        }
    }
    moved(&start, &(&nearest.expect("a bounded face ends somewhere") * &half), &ray)
}

fn keep_nearest(nearest: &mut Option<Rational>, t: Rational) {
    if t > Rational::ZERO && nearest.as_ref().is_none_or(|best| t < *best) {
        *nearest = Some(t);
    }
}

/// How often a closed walk winds around a point; `None` if the point is on it.
pub(crate) fn winding<'a>(walk: impl Iterator<Item = &'a Point>, p: &Point) -> Option<i64> {
    let walk: Vec<&Point> = walk.collect();
    let mut sum = 0;
    for i in 0..walk.len() {
        let (a, b) = (walk[i], walk[(i + 1) % walk.len()]);
        let side = turn(&minus(b, a), &minus(p, a));
        if side.is_zero()
            && (0..2).all(|i| a[i].clone().min(b[i].clone()) <= p[i])
            && (0..2).all(|i| a[i].clone().max(b[i].clone()) >= p[i])
        {
            return None;
        }
        if a[1] <= p[1] && b[1] > p[1] && side > Rational::ZERO {
            sum += 1;
        } else if a[1] > p[1] && b[1] <= p[1] && side < Rational::ZERO {
            sum -= 1;
        }
    }
    Some(sum)
}

/// The vertices and edges that segments are cut into.
pub(crate) fn cut(segments: &[[Point; 2]]) -> (Vec<Point>, Vec<[usize; 2]>) {
    let mut points: BTreeSet<Point> = segments.iter().flatten().cloned().collect();
    for (i, [a, b]) in segments.iter().enumerate() {
        for [c, d] in &segments[..i] {
            let (s, t) = (minus(b, a), minus(d, c));
            let Some(inverse) = turn(&s, &t).inverse() else { continue };
            let along = [&t, &s].map(|direction| &turn(&minus(c, a), direction) * &inverse);
            if along.iter().all(|x| *x >= Rational::ZERO && *x <= Rational::ONE) {
                points.insert(moved(a, &along[0], &s));
            }
        }
    }
    let points: Vec<Point> = points.into_iter().collect();
    let mut edges: BTreeSet<[usize; 2]> = BTreeSet::new();
    for [a, b] in segments {
        let (low, high) = (a.min(b), a.max(b));
        let on = |p: &Point| p >= low && p <= high && turn(&minus(b, a), &minus(p, a)).is_zero();
        let along: Vec<usize> = (0..points.len()).filter(|&i| on(&points[i])).collect();
        edges.extend(along.windows(2).map(|pair| [pair[0], pair[1]]));
    }
    (points, edges.into_iter().collect())
}
