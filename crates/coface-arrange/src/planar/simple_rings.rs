//! Rings around sets of faces.

use super::faces::{NONE, Orbits};

/// The walks along the halfedges that have a set on their left and not on their right, cut where they come to a vertex
/// again: the halfedges of one ring after those of another, and where each begins. No ring passes a vertex twice.
/// `ends` are the ends of the edges.
///
/// What is on both sides of an edge stays connected: a walk turns around vertices across such edges.
pub(super) fn simple_rings(
    orbits: &Orbits,
    ends: &[[u32; 2]],
    is_boundary: &[bool],
) -> (Vec<u32>, Vec<usize>) {
    let (mut rings, mut starts) = (Vec::new(), vec![0]);
    let mut is_done = vec![false; is_boundary.len()];
    // The place of a vertex on the walk that is under way.
    let mut place = vec![NONE; orbits.rotation.len()];
    let tail = |halfedge: u32| ends[halfedge as usize / 2][halfedge as usize % 2] as usize;
    let mut walk: Vec<u32> = Vec::new();
    for first in 0..is_boundary.len() as u32 {
        if !is_boundary[first as usize] || is_done[first as usize] {
            continue;
        }
        let mut at = first;
        loop {
            let from = place[tail(at)];
            if from != NONE {
                // The end of the walk is a ring.
                walk[from as usize..].iter().for_each(|&halfedge| place[tail(halfedge)] = NONE);
                rings.extend(walk.drain(from as usize..));
                starts.push(rings.len());
            }
            if is_done[at as usize] {
                break;
            }
            place[tail(at)] = walk.len() as u32;
            walk.push(at);
            is_done[at as usize] = true;
            at = orbits.next[at as usize];
            while !is_boundary[at as usize] {
                at = orbits.next[(at ^ 1) as usize];
            }
        }
    }
    (rings, starts)
}
