//! Pieces of a surface that is cut again and again.

use super::weights::Weights;
use crate::curves::{SurfaceHomology, TreeCotree};
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::{EdgeId, Error, FaceId, RaggedArray, UnionFind};
use coface_complexes::surface::GeneralizedMap;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// No number.
const NONE: u32 = u32::MAX;

/// A connected surface each of whose edges lies over one of the surface that it was cut from, and runs as that does.
#[derive(Debug)]
pub(super) struct Piece {
    pub(super) map: GeneralizedMap,
    pub(super) edges: Vec<u32>,
}

impl Piece {
    /// The components of a surface. Vertices without edges are left out.
    pub(super) fn components(map: &GeneralizedMap, edges: &[u32]) -> Result<Vec<Self>, Error> {
        let skeleton = map.skeleton();
        let mut faces = UnionFind::new(skeleton.face_count());
        for edge in (0..skeleton.edge_count()).map(EdgeId::new) {
            let side = map.first_side(edge);
            if let Some(mate) = map.mate(side) {
                faces.unite(map.face(side).to_u32(), map.face(mate).to_u32());
            }
        }
        let classes = faces.class_numbers();
        let count = faces.class_count();
        let mut rims = vec![RaggedArray::new(); count];
        let mut ends = vec![Vec::new(); count];
        let mut below: Vec<Vec<u32>> = vec![Vec::new(); count];
        let mut vertex_counts = vec![0u32; count];
        let mut edge_numbers = vec![NONE; skeleton.edge_count()];
        let mut vertex_numbers = vec![NONE; skeleton.vertex_count()];
        for (face, rim) in skeleton.faces().iter().enumerate() {
            let class = classes[face] as usize;
            let rim: Vec<u32> = rim
                .iter()
                .map(|&step| {
                    let edge = (step >> 1) as usize;
                    if edge_numbers[edge] == NONE {
                        edge_numbers[edge] = below[class].len() as u32;
                        below[class].push(edges[edge]);
                        for &vertex in &skeleton.edge_ends()[2 * edge..2 * edge + 2] {
                            let number = &mut vertex_numbers[vertex as usize];
                            if *number == NONE {
                                *number = vertex_counts[class];
                                vertex_counts[class] += 1;
                            }
                            ends[class].push(*number);
                        }
                    }
                    2 * edge_numbers[edge] + (step & 1)
                })
                .collect();
            rims[class].push(&rim);
        }
        let mut pieces = Vec::with_capacity(count);
        for (((rims, ends), edges), vertex_count) in rims.into_iter().zip(ends).zip(below).zip(vertex_counts)
        {
            let skeleton = TwoSkeleton::new(vertex_count as usize, ends, rims)?;
            pieces.push(Self { map: GeneralizedMap::new(skeleton)?, edges });
        }
        Ok(pieces)
    }

    /// Its Euler characteristic when its holes are filled.
    pub(super) fn filled_characteristic(&self, hole_count: usize) -> i64 {
        let skeleton = self.map.skeleton();
        skeleton.vertex_count() as i64 - skeleton.edge_count() as i64
            + skeleton.face_count() as i64
            + hole_count as i64
    }

    /// The hole at each vertex, or `NONE`, and the number of holes.
    pub(super) fn holes(&self) -> (Vec<u32>, usize) {
        let mut holes = vec![NONE; self.map.skeleton().vertex_count()];
        let loops = self.map.boundary_loops();
        for (number, hole) in (0u32..).zip(&loops) {
            for &(side, _) in hole {
                holes[self.map.source(side).index()] = number;
                holes[self.map.target(side).index()] = number;
            }
        }
        (holes, loops.len())
    }

    /// The steps of the shortest path from the first hole to any other one.
    pub(super) fn path_between_holes(&self, holes: &[u32], weights: &Weights) -> Vec<u32> {
        let ends = self.map.skeleton().edge_ends();
        let steps_at = RaggedArray::grouped(holes.len(), ends.iter().copied());
        let mut distances = vec![u128::MAX; holes.len()];
        let mut steps = vec![NONE; holes.len()];
        let mut heap = BinaryHeap::new();
        for (vertex, _) in holes.iter().enumerate().filter(|(_, hole)| **hole == 0) {
            distances[vertex] = 0;
            heap.push(Reverse((0u128, vertex as u32)));
        }
        while let Some(Reverse((distance, vertex))) = heap.pop() {
            if distance > distances[vertex as usize] {
                continue;
            }
            if holes[vertex as usize] != 0 && holes[vertex as usize] != NONE {
                let mut path = Vec::new();
                let mut at = vertex;
                while steps[at as usize] != NONE {
                    path.push(steps[at as usize]);
                    at = ends[steps[at as usize] as usize];
                }
                path.reverse();
                return path;
            }
            for &step in steps_at.list(vertex as usize) {
                let next = ends[(step ^ 1) as usize];
                let through = distance + weights.of(self.edges[(step >> 1) as usize]);
                if through < distances[next as usize] {
                    distances[next as usize] = through;
                    steps[next as usize] = step;
                    heap.push(Reverse((through, next)));
                }
            }
        }
        Vec::new()
    }

    /// A connected cover of two sheets of a piece with one hole, which the cover has twice.
    pub(super) fn double_cover(&self) -> Result<Self, Error> {
        let trees = TreeCotree::new(&self.map);
        let homology = SurfaceHomology::new(&self.map, &trees);
        let skeleton = self.map.skeleton();
        let (vertex_count, edge_count) = (skeleton.vertex_count() as u32, skeleton.edge_count() as u32);
        let changes: Vec<u32> = (0..edge_count)
            .map(|edge| u32::from(homology.odd_crossings(edge).any(|generator| generator == 0)))
            .collect();
        let mut ends = Vec::with_capacity(4 * edge_count as usize);
        for sheet in 0..2 {
            for (edge, change) in changes.iter().enumerate() {
                let [a, b] = [skeleton.edge_ends()[2 * edge], skeleton.edge_ends()[2 * edge + 1]];
                ends.extend([a + sheet * vertex_count, b + (sheet ^ change) * vertex_count]);
            }
        }
        let mut rims = RaggedArray::new();
        for sheet in 0..2 {
            for rim in skeleton.faces().iter() {
                let mut at = sheet;
                let lift = |&step: &u32| {
                    let change = changes[(step >> 1) as usize];
                    // An edge is in the sheet of its start.
                    let edge_sheet = if step & 1 == 0 { at } else { at ^ change };
                    at ^= change;
                    step + 2 * edge_sheet * edge_count
                };
                let lifted: Vec<u32> = rim.iter().map(lift).collect();
                rims.push(&lifted);
            }
        }
        let skeleton = TwoSkeleton::new(2 * vertex_count as usize, ends, rims)?;
        Ok(Self { map: GeneralizedMap::new(skeleton)?, edges: self.edges.repeat(2) })
    }
}

/// A piece cut open along edges, with the two sides of a path or cycle among them.
pub(super) struct Opened {
    pub(super) piece: Piece,
    /// The vertices on either side, one more than edges, and the steps that run along the first side.
    pub(super) sides: [Vec<u32>; 2],
    pub(super) along: Vec<u32>,
}

impl Opened {
    /// Cuts a piece along edges. `crossed` are steps along edges among them that make a path or cycle, on both sides of which no other
    /// edge among them ends between the first vertex and the last. The result may have two components.
    pub(super) fn new(piece: &Piece, cut: &[u32], crossed: &[u32]) -> Result<Self, Error> {
        let edges: Vec<EdgeId> = cut.iter().map(|&step| EdgeId::from_u32(step >> 1)).collect();
        let slice = piece.map.slice_edges(&edges)?;
        let old_count = piece.map.skeleton().edge_count();
        let mut copies = vec![NONE; old_count];
        let sources = slice.edge_sources();
        for edge in (old_count..sources.len()).map(EdgeId::new) {
            copies[sources[edge].index()] = edge.to_u32();
        }
        let below = sources.iter().map(|source| piece.edges[source.index()]).collect();
        let map = slice.into_surface();
        let ends = map.skeleton().edge_ends();
        let mut sides = [Vec::with_capacity(crossed.len() + 1), Vec::with_capacity(crossed.len() + 1)];
        let mut along = Vec::with_capacity(crossed.len());
        for &step in crossed {
            let mut pair = [step, 2 * copies[(step >> 1) as usize] + (step & 1)];
            match sides[0].last() {
                None => {
                    for (side, step) in sides.iter_mut().zip(pair) {
                        side.push(ends[step as usize]);
                    }
                }
                Some(&at) => {
                    if ends[pair[0] as usize] != at {
                        pair.swap(0, 1);
                    }
                }
            }
            debug_assert!(
                sides.iter().zip(pair).all(|(side, step)| side.last() == Some(&ends[step as usize]))
            );
            along.push(pair[0]);
            for (side, step) in sides.iter_mut().zip(pair) {
                side.push(ends[(step ^ 1) as usize]);
            }
        }
        Ok(Self { piece: Piece { map, edges: below }, sides, along })
    }

    /// Whether both sides are in one component.
    pub(super) fn is_connected(&self) -> bool {
        let map = &self.piece.map;
        let mut vertices = UnionFind::new(map.skeleton().vertex_count());
        for &[a, b] in map.skeleton().edge_ends().as_chunks::<2>().0 {
            vertices.unite(a, b);
        }
        vertices.same(self.sides[0][0], self.sides[1][0])
    }
}

/// A vertex of a face.
pub(super) fn some_vertex(map: &GeneralizedMap) -> u32 {
    map.sides_of(FaceId::new(0)).next().map_or(0, |side| map.source(side).to_u32())
}
