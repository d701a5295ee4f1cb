//! Random simplices, the same on every machine.

use super::Mesh;
use coface::algebra::RaggedArray;

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
