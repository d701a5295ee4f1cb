//! Closed walks without positions.

use super::{Piece, ends, in_order, piece};
use coface_algebra::{Sign, SparseMatrix};

/// No position on the path.
const NONE: u32 = u32::MAX;

/// The edges of a cycle as closed walks that meet no vertex twice; `None` if one has not two ends.
///
/// A walk begins with the lowest edge that is left and goes on with the lowest edge out of where it arrives; when that
/// is a vertex it has met, the loop since then is a piece.
pub(super) fn closed_walks(edges: &SparseMatrix, copies: &[(u32, Sign)]) -> Option<Vec<Piece>> {
    let mut directed = Vec::with_capacity(copies.len());
    for &(edge, sign) in copies {
        let [tail, head] = ends(edges, edge)?;
        directed.push(if sign == Sign::Plus { [tail, head] } else { [head, tail] });
    }
    let mut vertices: Vec<u32> = directed.iter().map(|&[tail, _]| tail).collect();
    vertices.sort_unstable();
    vertices.dedup();
    // Vertices by their places; the edges out of each, lowest first.
    for end in directed.iter_mut().flatten() {
        *end = vertices.binary_search(end).ok()? as u32;
    }
    let mut out: Vec<(u32, u32)> = (0..).zip(&directed).map(|(copy, &[tail, _])| (tail, copy)).collect();
    out.sort_unstable();
    let mut next: Vec<usize> = (0..vertices.len())
        .map(|vertex| out.partition_point(|&(tail, _)| (tail as usize) < vertex))
        .collect();
    let mut place = vec![NONE; vertices.len()];
    let mut pieces = Vec::new();
    let mut path: Vec<u32> = Vec::new();
    for start in 0..directed.len() {
        // The tail of an edge that is left has it, or a lower one, as the next.
        let mut at = directed[start][0];
        if out.get(next[at as usize]) != Some(&(at, start as u32)) {
            continue;
        }
        place[at as usize] = 0;
        while let Some(&(tail, copy)) = out.get(next[at as usize]).filter(|(tail, _)| *tail == at) {
            next[tail as usize] += 1;
            path.push(copy);
            at = directed[copy as usize][1];
            if place[at as usize] == NONE {
                place[at as usize] = path.len() as u32;
                continue;
            }
            let walk = path.split_off(place[at as usize] as usize);
            walk.iter().for_each(|&copy| place[directed[copy as usize][0] as usize] = NONE);
            place[at as usize] = path.len() as u32;
            pieces.push(piece(copies, &walk));
        }
        place[at as usize] = NONE;
    }
    Some(in_order(pieces))
}
