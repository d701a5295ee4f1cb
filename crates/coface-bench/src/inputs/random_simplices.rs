//! Random simplices, the same on every machine.

use super::Mesh;
use coface::algebra::RaggedArray;
use std::collections::BTreeSet;

/// `count` simplices on `count / 10` vertices; each dimension from 0 to 5 is as likely as another, the vertices of one
/// simplex differ.
pub(super) fn random_simplices(count: usize) -> Mesh {
    let vertex_count = count / 10;
    let mut random = SplitMix64(0x5eed_c0fa_ce00_0001);
    let mut starts = vec![0u32];
    let mut members: Vec<u32> = Vec::new();
    for _ in 0..count {
        let start = members.len();
        let size = 1 + random.below(6);
        while members.len() < start + size {
            let vertex = random.below(vertex_count) as u32;
            if !members[start..].contains(&vertex) {
                members.push(vertex);
            }
        }
        starts.push(members.len() as u32);
    }
    let lists = RaggedArray::from_parts(starts, members).expect("the starts rise to the number of members");
    Mesh { vertex_count, coordinates: Vec::new(), lists }
}

/// A random 2-complex of N. Linial and R. Meshulam, *Homological connectivity of random 2-complexes* (2006): all edges on
/// some vertices, and `triangle_count` different triangles, each set of them as likely as another.
pub(super) fn random_2_complex(vertex_count: usize, triangle_count: usize) -> Mesh {
    let mut random = SplitMix64(0x5eed_c0fa_ce00_0002);
    let mut triangles = BTreeSet::new();
    while triangles.len() < triangle_count {
        let mut triangle = [0; 3].map(|_| random.below(vertex_count) as u32);
        triangle.sort_unstable();
        if triangle[0] < triangle[1] && triangle[1] < triangle[2] {
            triangles.insert(triangle);
        }
    }
    let mut lists = RaggedArray::new();
    for a in 0..vertex_count as u32 {
        (a + 1..vertex_count as u32).for_each(|b| lists.push(&[a, b]));
    }
    triangles.iter().for_each(|triangle| lists.push(triangle));
    Mesh { vertex_count, coordinates: Vec::new(), lists }
}

/// Numbers from 0 to 1, the same on every machine.
pub(crate) fn random_values(count: usize) -> Vec<f64> {
    let mut random = SplitMix64(0x5eed_c0fa_ce00_0003);
    (0..count).map(|_| random.below(1 << 53) as f64 / (1u64 << 53) as f64).collect()
}

/// The generator of G. L. Steele, D. Lea and C. H. Flood, *Fast splittable pseudorandom number generators* (2014).
struct SplitMix64(u64);

impl SplitMix64 {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `bound`, by the high half of a product (the bias, below 2^-40 here, is of no matter).
    fn below(&mut self, bound: usize) -> usize {
        ((u128::from(self.next()) * bound as u128) >> 64) as usize
    }
}
