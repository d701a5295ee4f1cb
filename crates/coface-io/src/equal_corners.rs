//! Corners of lines at one place as one vertex.

use super::lists::number_by_firsts;
use rayon::prelude::*;

/// No vertex.
const NONE: u32 = u32::MAX;

/// What is equal of equal corners: the owner and the place. Zeros of both signs are equal.
type Key = (u32, [u64; 3]);

fn key(corners: &[[f64; 3]], owners: &[u32], corner: usize) -> Key {
    let bits = |x: f64| if x == 0.0 { 0 } else { x.to_bits() };
    let [x, y, z] = corners[corner];
    (owners[corner], [bits(x), bits(y), bits(z)])
}

/// The vertex of each corner, and the first corner of each vertex: corners with one owner and equal coordinates are one.
///
/// Linear in the corners, for almost all of them; $O(n \log n)$ for those that were chosen to make it slow.
pub(crate) fn weld(corners: &[[f64; 3]], owners: &[u32]) -> (Vec<u32>, Vec<u32>) {
    by_table(corners, owners).unwrap_or_else(|| by_order(corners, owners))
}

/// The same by a table of the places; `None` where many corners come to the same slots of it.
fn by_table(corners: &[[f64; 3]], owners: &[u32]) -> Option<(Vec<u32>, Vec<u32>)> {
    let count = corners.len();
    let bits = (count + count / 2).next_power_of_two().trailing_zeros().max(1);
    let mut slots = vec![NONE; 1 << bits];
    let (mut vertices, mut firsts) = (Vec::with_capacity(count), Vec::<u32>::with_capacity(count));
    let mut steps_left = 8 * count;
    for corner in 0..count {
        let own = key(corners, owners, corner);
        let mut slot = (hash(own) >> (64 - bits)) as usize;
        let vertex = loop {
            let known = slots[slot];
            if known == NONE {
                slots[slot] = firsts.len() as u32;
                firsts.push(corner as u32);
                break slots[slot];
            }
            if key(corners, owners, firsts[known as usize] as usize) == own {
                break known;
            }
            steps_left = steps_left.checked_sub(1)?;
            slot = (slot + 1) % slots.len();
        };
        vertices.push(vertex);
    }
    Some((vertices, firsts))
}

/// A number whose high bits depend on all bits of a key.
fn hash((owner, place): Key) -> u64 {
    place.iter().fold(u64::from(owner), |sum, &bits| {
        let product = u128::from(sum ^ bits ^ 0x9e37_79b9_7f4a_7c15) * 0xd1b5_4a32_d192_ed03;
        (product as u64) ^ (product >> 64) as u64
    })
}

/// The same by sorting.
fn by_order(corners: &[[f64; 3]], owners: &[u32]) -> (Vec<u32>, Vec<u32>) {
    let key = |corner: u32| key(corners, owners, corner as usize);
    let mut order: Vec<u32> = (0..corners.len() as u32).collect();
    order.par_sort_unstable_by_key(|&i| (key(i), i));
    let mut vertices = vec![0; corners.len()];
    for equal in order.chunk_by(|&a, &b| key(a) == key(b)) {
        for &corner in equal {
            vertices[corner as usize] = equal[0];
        }
    }
    let firsts = number_by_firsts(&mut vertices);
    (vertices, firsts)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn most_corners_come_to_slots_of_their_own() {
        let corner = |i: u32| [f64::from(i % 300), f64::from(i / 300) * 0.25, 0.0];
        let corners: Vec<[f64; 3]> = (0..90_000).map(corner).collect();
        let (vertices, firsts) = by_table(&corners, &vec![1; corners.len()]).unwrap();
        assert!(vertices.iter().copied().eq(0..90_000) && vertices == firsts);
    }

    proptest! {
        #[test]
        fn welding_agrees_with_comparing_all_pairs(corners in proptest::collection::vec((0..3u32, [-1..2i8, -1..2, 0..1]), 0..40)) {
            let owners: Vec<u32> = corners.iter().map(|&(owner, _)| owner).collect();
            let points: Vec<[f64; 3]> = corners.iter().map(|&(_, point)| point.map(f64::from)).collect();
            let (vertices, firsts) = weld(&points, &owners);
            let mut seen: Vec<usize> = Vec::new();
            for i in 0..points.len() {
                let equal = seen.iter().position(|&j| owners[j] == owners[i] && points[j] == points[i]);
                let vertex = equal.unwrap_or_else(|| { seen.push(i); seen.len() - 1 });
                prop_assert_eq!(vertices[i] as usize, vertex);
            }
            prop_assert!(firsts.iter().map(|&first| first as usize).eq(seen));
            prop_assert_eq!((vertices, firsts), by_order(&points, &owners));
        }
    }
}
