//! The faces of a subdivision.

use crate::subdivision::Subdivision;

/// The unbounded face.
pub(crate) const OUTSIDE: u32 = 0;

/// The faces that edges leave of the plane. Face 0 is unbounded.
pub(crate) struct Faces {
    /// The face on the left of each halfedge.
    pub(crate) of: Vec<u32>,
    /// How many there are with the unbounded one.
    pub(crate) count: usize,
    /// The connected components of vertices and edges.
    pub(crate) components: usize,
    /// Those with edges that lie in a bounded face.
    pub(crate) holes: usize,
}

impl Faces {
    /// Walks around all faces. The walk around the outside of a component passes its lowest vertex; it is in the face above the edge next
    /// below that vertex.
    pub(crate) fn new(plane: &Subdivision) -> Self {
        let mut next = vec![0u32; 2 * plane.edges.len()];
        for around in &plane.around {
            for (i, &halfedge) in around.iter().enumerate() {
                // Who arrives against this one turns into the one before it, clockwise, to keep its face on the left.
                next[(halfedge ^ 1) as usize] = around[(i + around.len() - 1) % around.len()];
            }
        }
        let mut walks = vec![u32::MAX; next.len()];
        let mut walk_count = 0;
        for start in 0..next.len() {
            let mut at = start;
            while walks[at] == u32::MAX {
                walks[at] = walk_count;
                at = next[at] as usize;
            }
            walk_count += u32::from(walks[start] == walk_count);
        }
        let (mut components, mut holes) = (0, 0);
        let mut face_of_walk = vec![u32::MAX; walk_count as usize];
        let mut is_reached = vec![false; plane.vertices.len()];
        let mut outer = Vec::new();
        for vertex in 0..plane.vertices.len() {
            if is_reached[vertex] {
                continue;
            }
            components += 1;
            let mut waiting = vec![vertex];
            while let Some(at) = waiting.pop() {
                if !std::mem::replace(&mut is_reached[at], true) {
                    let ends = |halfedge: u32| plane.edges[halfedge as usize / 2];
                    waiting.extend(plane.around[at].iter().flat_map(|&h| ends(h)).map(|end| end as usize));
                }
            }
            // All edges leave the lowest vertex of a component upwards; left of the last one is the outside.
            let Some(&last) = plane.around[vertex].last() else { continue };
            outer.push((walks[last as usize], plane.below[vertex]));
            face_of_walk[walks[last as usize] as usize] = OUTSIDE;
        }
        let mut count = OUTSIDE + 1;
        for face in face_of_walk.iter_mut().filter(|face| **face != OUTSIDE) {
            *face = count;
            count += 1;
        }
        // What is below has been reached before.
        for (walk, below) in outer {
            let face = below.map_or(OUTSIDE, |edge| face_of_walk[walks[2 * edge as usize] as usize]);
            face_of_walk[walk as usize] = face;
            holes += usize::from(face != OUTSIDE);
        }
        let of = walks.iter().map(|&walk| face_of_walk[walk as usize]).collect();
        Self { of, count: count as usize, components, holes }
    }

    /// The halfedges around each face.
    pub(crate) fn halfedges(&self) -> Vec<Vec<u32>> {
        let mut lists = vec![Vec::new(); self.count];
        (0u32..).zip(&self.of).for_each(|(halfedge, &face)| lists[face as usize].push(halfedge));
        lists
    }
}
