//! Directed edges as closed walks.

use coface_algebra::RaggedArray;
use std::collections::BTreeMap;

/// Directed edges that close up, as walks that pass no vertex twice; those that do not are left out. The edges are sorted.
///
/// # Complexity
/// $O(n \log n)$ for n edges.
///
/// # Examples
/// Two triangles with a common vertex, and an edge that goes nowhere.
/// ```
/// use coface_arrange::spatial::closed_walks;
/// let walks = closed_walks(&mut [[2, 3], [0, 1], [1, 2], [2, 0], [3, 4], [4, 2], [4, 5]]);
/// assert_eq!(walks.len(), 2);
/// assert!(walks.iter().all(|walk| walk.len() == 3));
/// ```
pub fn closed_walks(sides: &mut [[u32; 2]]) -> RaggedArray {
    sides.sort_unstable();
    let mut is_used = vec![false; sides.len()];
    let mut walks = RaggedArray::new();
    let mut path: Vec<u32> = Vec::new();
    let mut places: BTreeMap<u32, usize> = BTreeMap::new();
    for first in 0..sides.len() {
        let mut here = sides[first][0];
        while let Some(side) = (sides.partition_point(|side| side[0] < here)..sides.len())
            .take_while(|&i| sides[i][0] == here)
            .find(|&i| !is_used[i])
        {
            is_used[side] = true;
            places.insert(here, path.len());
            path.push(here);
            here = sides[side][1];
            if let Some(&at) = places.get(&here) {
                walks.push(&path[at..]);
                for vertex in path.drain(at..) {
                    places.remove(&vertex);
                }
            }
        }
        // What is left does not close up.
        path.clear();
        places.clear();
    }
    walks
}
