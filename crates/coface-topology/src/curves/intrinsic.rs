//! Intrinsic Delaunay triangulations: the same surface with edges flipped until no angles opposite to an edge exceed two right ones.

use super::shortest_paths::checked_lengths;
use coface_algebra::{Error, FaceId, Sign};
use coface_complexes::surface::GeneralizedMap;
use std::collections::VecDeque;

const NONE: u32 = u32::MAX;

/// Cotangents below this are flipped away: rounding would flip an edge between two right angles for ever.
const TOLERANCE: f64 = 1e-9;

/// An orientable surface of triangles that know their sides' lengths only. Side 3 t + i is the i-th of triangle t.
#[derive(Clone, Debug)]
pub(super) struct IntrinsicTriangulation {
    /// The vertex where each side starts.
    sources: Vec<u32>,
    lengths: Vec<f64>,
    /// The side that each is glued to, or [`NONE`].
    mates: Vec<u32>,
}

impl IntrinsicTriangulation {
    /// A surface of triangles with these lengths of edges. Lengths that make no triangles are made a little longer, all by the same.
    ///
    /// # Errors
    /// Unless there is a finite length, 0 at least, for each edge; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a face
    /// that is no triangle, and for surfaces that are not orientable.
    ///
    /// # References
    /// N. Sharp, K. Crane, *A Laplacian for nonmanifold triangle meshes* (2020), section 4.5, for the lengths.
    pub(super) fn new(map: &GeneralizedMap, lengths: &[f64]) -> Result<Self, Error> {
        let lengths = checked_lengths(map, Some(lengths))?;
        let orientation = map.orientation();
        if orientation.conflicts().iter().any(Option::is_some) {
            return Err(Error::invalid("the surface is not orientable"));
        }
        let mut found = Self { sources: Vec::new(), lengths: Vec::new(), mates: Vec::new() };
        let mut first_at = vec![NONE; map.edge_count()];
        for face in (0..map.face_count()).map(FaceId::new) {
            let mut steps: Vec<u32> = map.sides_of(face).map(|side| map.step(side)).collect();
            if steps.len() != 3 {
                return Err(Error::invalid(format!("face {face} has {} sides, not 3", steps.len())));
            }
            if orientation.signs()[face.index()] == Sign::Minus {
                steps.reverse();
                steps.iter_mut().for_each(|step| *step ^= 1);
            }
            for step in steps {
                let (side, edge) = (found.sources.len() as u32, (step >> 1) as usize);
                found.sources.push(map.skeleton().edge_ends()[step as usize]);
                found.lengths.push(lengths[edge]);
                found.mates.push(first_at[edge]);
                match first_at[edge] {
                    NONE => first_at[edge] = side,
                    other => found.mates[other as usize] = side,
                }
            }
        }
        let count = lengths.len().max(1) as f64;
        let least = TOLERANCE * lengths.iter().sum::<f64>() / count;
        let missing = |triangle: &[f64]| {
            let sum: f64 = triangle.iter().sum();
            triangle.iter().map(|&side| 2.0 * side - sum + least).fold(0.0, f64::max)
        };
        let longer = found.lengths.chunks_exact(3).map(missing).fold(0.0, f64::max);
        found.lengths.iter_mut().for_each(|length| *length += longer);
        Ok(found)
    }

    fn after(side: u32) -> u32 {
        if side % 3 == 2 { side - 2 } else { side + 1 }
    }

    fn before(side: u32) -> u32 {
        if side.is_multiple_of(3) { side + 2 } else { side - 1 }
    }

    /// The lengths of a side, the next and the one before.
    fn around(&self, side: u32) -> [f64; 3] {
        [side, Self::after(side), Self::before(side)].map(|side| self.lengths[side as usize])
    }

    /// The cotangent of the angle opposite to a side.
    fn cotangent(&self, side: u32) -> f64 {
        let [own, left, right] = self.around(side);
        let factors = [own + left + right, left + right - own, own + right - left, own + left - right];
        let area = factors.iter().map(|factor| factor.max(f64::MIN_POSITIVE).sqrt()).product::<f64>() / 4.0;
        (left * left + right * right - own * own) / (4.0 * area)
    }

    /// The weight of the edge of a side: half the sum of the cotangents opposite to it.
    fn weight(&self, side: u32) -> f64 {
        let mate = self.mates[side as usize];
        let other = if mate == NONE { 0.0 } else { self.cotangent(mate) };
        f64::midpoint(self.cotangent(side), other)
    }

    /// Flips edges between angles of more than two right ones, the first first. It ends after so many flips at the latest.
    ///
    /// # Complexity
    /// As a rule linear; quadratic at worst.
    ///
    /// # References
    /// A. Bobenko, B. Springborn, *A discrete Laplace-Beltrami operator for simplicial surfaces* (2007).
    pub(super) fn make_delaunay(&mut self, most: usize) {
        let mut queue: VecDeque<u32> = (0..self.sources.len() as u32).collect();
        let mut is_waiting = vec![true; self.sources.len()];
        let mut flips = 0;
        while let Some(side) = queue.pop_front() {
            is_waiting[side as usize] = false;
            let mate = self.mates[side as usize];
            let is_one_triangle = mate != NONE && side / 3 == mate / 3;
            if mate == NONE || is_one_triangle || self.weight(side) >= -TOLERANCE || flips == most {
                continue;
            }
            flips += 1;
            for touched in self.flip(side, mate) {
                if !std::mem::replace(&mut is_waiting[touched as usize], true) {
                    queue.push_back(touched);
                }
            }
        }
    }

    /// Puts the other diagonal of two triangles in; the four sides around them.
    fn flip(&mut self, side: u32, mate: u32) -> [u32; 4] {
        let diagonal = self.other_diagonal(side, mate);
        // In the order of the new triangles: the apex of the first, along its last side; then the second likewise.
        let outer = [Self::before(side), Self::after(mate), Self::before(mate), Self::after(side)];
        let [first, second] = [3 * (side / 3), 3 * (mate / 3)];
        let places = [first, first + 1, second, second + 1];
        let kept = outer.map(|side| {
            let i = side as usize;
            (self.sources[i], self.lengths[i], self.mates[i])
        });
        let moved = |old: u32| outer.iter().position(|&side| side == old).map_or(old, |i| places[i]);
        for (i, &(source, length, mate)) in kept.iter().enumerate() {
            let place = places[i] as usize;
            let mate = if mate == NONE { NONE } else { moved(mate) };
            (self.sources[place], self.lengths[place], self.mates[place]) = (source, length, mate);
            if mate != NONE {
                self.mates[mate as usize] = places[i];
            }
        }
        let [apex, other] = [kept[0].0, kept[2].0];
        for (place, source, mate) in [(first + 2, other, second + 2), (second + 2, apex, first + 2)] {
            let i = place as usize;
            (self.sources[i], self.lengths[i], self.mates[i]) = (source, diagonal, mate);
        }
        places
    }

    /// The distance of the corners opposite to an edge when its two triangles are laid into the plane.
    fn other_diagonal(&self, side: u32, mate: u32) -> f64 {
        let corner = |[own, left, right]: [f64; 3]| {
            // `right` starts at the source of the side.
            let along = (own * own + right * right - left * left) / (2.0 * own);
            [along, (right * right - along * along).max(0.0).sqrt()]
        };
        let own = self.lengths[side as usize];
        let [near, height] = corner(self.around(side));
        let [far, depth] = corner(self.around(mate));
        (near - (own - far)).hypot(height + depth)
    }

    /// Each edge inside by its ends, with its cotangent weight, which is not negative on a Delaunay triangulation but for rounding.
    pub(super) fn weights(&self) -> impl Iterator<Item = ([u32; 2], f64)> + '_ {
        let is_first = |&side: &u32| (side + 1..NONE).contains(&self.mates[side as usize]);
        (0..self.sources.len() as u32).filter(is_first).map(|side| {
            let ends = [side, Self::after(side)].map(|side| self.sources[side as usize]);
            (ends, self.weight(side))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::RaggedArray;
    use coface_complexes::surface::PolygonMesh;
    use proptest::prelude::*;

    /// A mesh of triangles in the plane with the lengths of its edges.
    fn mesh(points: &[[f64; 2]], triangles: Vec<[u32; 3]>) -> (GeneralizedMap, Vec<f64>) {
        let mesh = PolygonMesh::new(points.len(), RaggedArray::from_lists(triangles), &[]).unwrap();
        let map = GeneralizedMap::new(mesh.two_skeleton().unwrap()).unwrap();
        let distance = |ends: &[u32]| {
            let [p, q] = [points[ends[0] as usize], points[ends[1] as usize]];
            (p[0] - q[0]).hypot(p[1] - q[1])
        };
        let lengths = map.skeleton().edge_ends().chunks_exact(2).map(distance).collect();
        (map, lengths)
    }

    #[test]
    fn the_long_diagonal_of_a_kite_is_flipped() {
        let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 0.5], [2.0, -0.5]];
        let (map, lengths) = mesh(&points, vec![[0, 1, 2], [1, 0, 3]]);
        let mut kite = IntrinsicTriangulation::new(&map, &lengths).unwrap();
        kite.make_delaunay(100);
        let edges: Vec<([u32; 2], f64)> = kite.weights().collect();
        let mut ends = edges[0].0;
        ends.sort_unstable();
        assert_eq!((edges.len(), ends), (1, [2, 3]));
        // The angles opposite to it at 0 and 1: twice the arc tangent of 1/4, whose cotangent is 15/8.
        assert!((edges[0].1 - 15.0 / 8.0).abs() < 1e-9, "{edges:?}");
    }

    proptest! {
        /// In the plane the flipped triangulation is Delaunay: the sum of the weights around a vertex inside, times the vectors to the
        /// neighbors, is zero before and after, for linear functions are harmonic.
        #[test]
        fn linear_functions_are_harmonic_after_flips(moves in prop::collection::vec((-0.45..0.45, -0.1..0.1), 36)) {
            let at = |i: usize, j: usize| (6 * i + j) as u32;
            let points: Vec<[f64; 2]> = (0..36).map(|k| {
                let (i, j) = (k / 6, k % 6);
                let is_inside = (1..5).contains(&i) && (1..5).contains(&j);
                let (dx, dy) = if is_inside { moves[k] } else { (0.0, 0.0) };
                [3.0 * i as f64 + dx, j as f64 + dy]
            }).collect();
            let triangles = (0..25).flat_map(|k| {
                let (i, j) = (k / 5, k % 5);
                [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
            }).collect();
            let (map, lengths) = mesh(&points, triangles);
            let mut intrinsic = IntrinsicTriangulation::new(&map, &lengths).unwrap();
            intrinsic.make_delaunay(1_000_000);
            let mut sums = vec![[0.0; 2]; 36];
            for (ends, weight) in intrinsic.weights() {
                prop_assert!(weight > -1e-6);
                for [from, to] in [ends, [ends[1], ends[0]]] {
                    let [p, q] = [points[from as usize], points[to as usize]];
                    (0..2).for_each(|axis| sums[from as usize][axis] += weight * (q[axis] - p[axis]));
                }
            }
            for (k, sum) in sums.iter().enumerate() {
                if (1..5).contains(&(k / 6)) && (1..5).contains(&(k % 6)) {
                    prop_assert!(sum[0].abs() < 1e-6 && sum[1].abs() < 1e-6, "{k}: {sum:?}");
                }
            }
        }
    }
}
