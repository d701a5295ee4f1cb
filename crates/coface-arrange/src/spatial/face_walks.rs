//! The walks around a face, from its sides.

use super::axis_view::AxisView;
use super::predicates::SpatialPredicates;
use coface_algebra::{RaggedArray, Sign};
use std::cmp::Ordering;

/// The way along one side of a face: its vertices from the first to the last.
pub(super) type Path = Vec<u32>;

/// Strings the sides of a face, as paths of vertices, to walks that have the face to their left and turn left wherever
/// walks meet: the inside of each walk is in one piece. The outer walk comes first; paths are named by their numbers.
///
/// The face is seen in a picture with its front towards the eye.
pub(super) fn face_walks(
    paths: &[Path],
    view: AxisView,
    predicates: &impl SpatialPredicates,
) -> Vec<Vec<u32>> {
    let next = next_paths(paths, view, predicates);
    let mut is_strung = vec![false; paths.len()];
    let mut walks: Vec<Vec<u32>> = Vec::new();
    for first in 0..paths.len() {
        let mut walk = Vec::new();
        let mut path = first;
        while !is_strung[path] {
            is_strung[path] = true;
            walk.push(path as u32);
            path = next[path] as usize;
        }
        if !walk.is_empty() {
            walks.push(walk);
        }
    }
    if walks.len() > 1 {
        // At its least vertex a face lies within a half turn, so that is on its outer walk.
        let compare = |a: &u32, b: &u32| view.compare(predicates, *a, *b);
        let least = |walk: &Vec<u32>| {
            walk.iter().flat_map(|&path| &paths[path as usize]).copied().min_by(|a, b| compare(a, b))
        };
        let outer = (0..walks.len()).min_by(|&i, &j| match (least(&walks[i]), least(&walks[j])) {
            (Some(a), Some(b)) => compare(&a, &b),
            _ => Ordering::Equal,
        });
        walks[..=outer.unwrap_or(0)].rotate_right(1);
    }
    walks
}

/// The path that goes on from the end of each.
fn next_paths(paths: &[Path], view: AxisView, predicates: &impl SpatialPredicates) -> Vec<u32> {
    let mut ends: Vec<(u32, Sign, u32)> = Vec::with_capacity(2 * paths.len());
    for (path, vertices) in (0..).zip(paths) {
        ends.push((vertices[0], Sign::Plus, path));
        ends.push((vertices[vertices.len() - 1], Sign::Minus, path));
    }
    ends.sort_unstable();
    let mut next = vec![0; paths.len()];
    for at in ends.chunk_by_mut(|x, y| x.0 == y.0) {
        let vertex = at[0].0;
        if let [(_, Sign::Plus, leaving), (_, Sign::Minus, coming)] = *at {
            next[coming as usize] = leaving;
            continue;
        }
        // The vertex next to this one on a path, and whether it is in the half of the picture that is swept last.
        let beside = |&(_, sign, path): &(u32, Sign, u32)| {
            let vertices = &paths[path as usize];
            vertices[if sign == Sign::Plus { 1 } else { vertices.len() - 2 }]
        };
        let is_after = |other: u32| view.compare(predicates, vertex, other).is_gt();
        at.sort_by(|x, y| {
            let [a, b] = [beside(x), beside(y)];
            let turn = || view.turn(predicates, [vertex, a, b]).reverse();
            // Of two in one direction, as at a slit, the one that comes is first.
            is_after(a)
                .cmp(&is_after(b))
                .then_with(turn)
                .then_with(|| (x.1 == Sign::Plus).cmp(&(y.1 == Sign::Plus)))
        });
        // The inside is clockwise of a path that comes.
        let count = at.len();
        for i in 0..count {
            if at[i].1 == Sign::Minus {
                let leaving =
                    (1..=count).map(|step| at[(i + count - step) % count]).find(|end| end.1 == Sign::Plus);
                next[at[i].2 as usize] = leaving.map_or(at[i].2, |end| end.2);
            }
        }
    }
    next
}

/// Walks as lists of vertices, the last vertex of each path left out.
pub(super) fn vertices_of_walks(
    paths: &[Path],
    walks: &[Vec<u32>],
    mut keeps: impl FnMut(u32) -> bool,
) -> RaggedArray {
    RaggedArray::from_lists(walks.iter().map(|walk| {
        let along = walk.iter().flat_map(|&path| {
            let vertices = &paths[path as usize];
            vertices[..vertices.len() - 1].iter().copied()
        });
        along.filter(|&vertex| keeps(vertex)).collect::<Vec<u32>>()
    }))
}
