//! Few vertices that every cycle which cannot be contracted meets.

use super::shortest_paths::ShortestPaths;
use coface_algebra::{EdgeId, UnionFind};
use coface_complexes::surface::GeneralizedMap;

/// Vertices that every closed path on the surface meets which cannot be contracted: those of a short graph that leaves a disk of each
/// component, nearest to the base of the component first.
///
/// The graph is what a spanning tree of the faces does not cross, across the edges with the longest loops at the base; a boundary loop
/// counts as one vertex, so that arcs between boundaries take the place of the boundaries, and loose ends are pruned. A closed path that
/// meets no vertex of the graph lies in a disk.
///
/// References: J. Erickson, K. Whittlesey, *Greedy optimal homotopy and homology generators* (2005).
pub(super) fn cut_vertices(map: &GeneralizedMap, lengths: &[f64]) -> Vec<u32> {
    let ends = map.skeleton().edge_ends();
    let paths = ShortestPaths::new(map, None, lengths);
    let mut classes = UnionFind::new(map.skeleton().vertex_count());
    let mut is_hole = vec![false; map.skeleton().vertex_count()];
    // Edges with a face on either side, with whether they are in the tree of shortest paths, and the lengths of their loops.
    let mut inner: Vec<(bool, f64, u32)> = Vec::new();
    for edge in 0..map.skeleton().edge_count() as u32 {
        let [a, b] = [ends[2 * edge as usize], ends[2 * edge as usize + 1]];
        if map.mate(map.first_side(EdgeId::from_u32(edge))).is_none() {
            classes.unite(a, b);
            is_hole[a as usize] = true;
            is_hole[b as usize] = true;
            continue;
        }
        let is_in_tree = paths.steps[b as usize] == 2 * edge || paths.steps[a as usize] == 2 * edge + 1;
        let length = paths.distances[a as usize] + lengths[edge as usize] + paths.distances[b as usize];
        inner.push((is_in_tree, length, edge));
    }
    inner.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1)).then(a.2.cmp(&b.2)));
    let mut faces = UnionFind::new(map.face_count());
    let mut arcs: Vec<[u32; 2]> = Vec::new();
    for &(_, _, edge) in &inner {
        let side = map.first_side(EdgeId::from_u32(edge));
        let across = map.mate(side).map(|mate| map.face(mate).to_u32());
        if across.is_some_and(|face| faces.unite(map.face(side).to_u32(), face)) {
            continue;
        }
        arcs.push([ends[2 * edge as usize], ends[2 * edge as usize + 1]]);
    }
    let mut is_kept = vec![false; is_hole.len()];
    for [a, b] in unpruned(arcs, &mut classes, &is_hole) {
        is_kept[a as usize] = true;
        is_kept[b as usize] = true;
    }
    let mut kept: Vec<u32> = (0..is_kept.len() as u32).filter(|&v| is_kept[v as usize]).collect();
    kept.sort_by(|&a, &b| paths.distances[a as usize].total_cmp(&paths.distances[b as usize]));
    kept
}

/// The arcs that are left when loose ends, but holes, are removed again and again. Vertices of one class are one node.
fn unpruned(arcs: Vec<[u32; 2]>, classes: &mut UnionFind, is_hole: &[bool]) -> Vec<[u32; 2]> {
    let mut is_fixed = vec![false; is_hole.len()];
    for vertex in (0..is_hole.len() as u32).filter(|&v| is_hole[v as usize]) {
        is_fixed[classes.find(vertex) as usize] = true;
    }
    let mut degrees = vec![0u32; is_hole.len()];
    // The exclusive or of the arcs at each node: of a single one its number.
    let mut sums = vec![0u32; is_hole.len()];
    let nodes: Vec<[u32; 2]> = arcs.iter().map(|arc| arc.map(|vertex| classes.find(vertex))).collect();
    for (i, arc) in (0u32..).zip(&nodes) {
        for &node in arc {
            degrees[node as usize] += 1;
            sums[node as usize] ^= i;
        }
    }
    let is_loose = |degrees: &[u32], node: u32| degrees[node as usize] == 1 && !is_fixed[node as usize];
    let mut is_pruned = vec![false; arcs.len()];
    let mut stack: Vec<u32> = (0..is_hole.len() as u32).filter(|&node| is_loose(&degrees, node)).collect();
    while let Some(node) = stack.pop() {
        if !is_loose(&degrees, node) {
            continue;
        }
        let arc = sums[node as usize];
        is_pruned[arc as usize] = true;
        for other in nodes[arc as usize] {
            degrees[other as usize] -= 1;
            sums[other as usize] ^= arc;
            if is_loose(&degrees, other) {
                stack.push(other);
            }
        }
    }
    arcs.into_iter().zip(is_pruned).filter(|(_, pruned)| !pruned).map(|(arc, _)| arc).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_complexes::surface::samples::all_kinds;

    /// A cycle that meets none of the vertices can be contracted: the faces at the other vertices make disks, so the surface
    /// without the stars of the vertices has no homology of degree 1.
    #[test]
    fn what_is_left_beside_the_vertices_is_made_of_disks() {
        for (name, map) in all_kinds() {
            let unit = vec![1.0; map.skeleton().edge_count()];
            let kept = cut_vertices(&map, &unit);
            let ends = map.skeleton().edge_ends();
            // Edges between other vertices: each of their cycles is contractible.
            let trees = super::super::TreeCotree::new(&map);
            let homotopy = super::super::SurfaceHomotopy::new(&map, &trees).unwrap();
            let is_kept = |vertex: u32| kept.contains(&vertex);
            let mut partition = UnionFind::new(map.skeleton().vertex_count());
            let mut tree: Vec<u32> = Vec::new();
            let mut left: Vec<u32> = Vec::new();
            for edge in 0..map.skeleton().edge_count() as u32 {
                let [a, b] = [ends[2 * edge as usize], ends[2 * edge as usize + 1]];
                if is_kept(a) || is_kept(b) {
                    continue;
                }
                if partition.unite(a, b) { tree.push(edge) } else { left.push(edge) }
            }
            let path = |from: u32, to: u32| -> Vec<u32> {
                let mut stack = vec![(from, Vec::new())];
                let mut seen = vec![from];
                while let Some((at, steps)) = stack.pop() {
                    if at == to {
                        return steps;
                    }
                    for &edge in &tree {
                        for step in [2 * edge, 2 * edge + 1] {
                            let next = ends[(step ^ 1) as usize];
                            if ends[step as usize] == at && !seen.contains(&next) {
                                seen.push(next);
                                stack.push((next, [&steps[..], &[step]].concat()));
                            }
                        }
                    }
                }
                panic!("the ends of a closing edge are connected");
            };
            for edge in left {
                let mut steps = vec![2 * edge];
                steps.extend(path(ends[2 * edge as usize + 1], ends[2 * edge as usize]));
                let walk = super::super::ClosedWalk::new(map.skeleton(), steps).unwrap();
                assert!(homotopy.is_contractible(&walk).unwrap(), "{name}");
            }
        }
    }
}
