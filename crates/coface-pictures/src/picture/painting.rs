//! An order to paint triangles in, so that those behind come first.

use super::raster::{NOTHING, Raster};
use super::scene_picture::Facet;
use super::sight::finer;
use coface_algebra::progress::stage;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The facets that are seen in a raster, those behind first.
///
/// In each pixel the facet that is seen has to come after all others there that are painted; these demands are sorted topologically, and
/// where nothing demands an order, by depth. Facets that go around in a circle, each partly before the next, have no order: then the
/// farthest comes first.
///
/// $O(p \log p)$ for p pixels that the facets cover, in the worst case; demands are noted once a run of pixels.
pub(super) fn painting_order(facets: &[Facet], raster: &mut Raster, factor: usize) -> Vec<u32> {
    let mut is_seen = vec![false; facets.len()];
    for &number in raster.seen.iter().filter(|&&number| number != NOTHING) {
        is_seen[number as usize] = true;
    }
    let mut demands: Vec<(u32, u32)> = Vec::new();
    let steps = stage("finding what is before what", facets.len());
    for (number, facet) in steps.each((0..).zip(facets)).filter(|(number, _)| is_seen[*number as usize]) {
        let mut last = NOTHING;
        raster.visit(facet.corners.map(|corner| finer(corner, factor)), |raster, at, depth| {
            let front = raster.seen[at];
            if front != number && front != last && depth > raster.depths[at] {
                last = front;
                demands.push((number, front));
            }
        });
    }
    demands.sort_unstable();
    demands.dedup();
    let mut waiting = vec![0u32; facets.len()];
    demands.iter().for_each(|&(_, front)| waiting[front as usize] += 1);
    // Bits of a float of one sign rise with it; depths are compared as whole numbers of a fixed step.
    let key = |number: u32| {
        let depth: f64 = facets[number as usize].corners.iter().map(|corner| corner[2]).sum();
        let bits = depth.to_bits() as i64;
        (bits ^ (((bits >> 63) as u64) >> 1) as i64, Reverse(number))
    };
    let seen = || (0..facets.len() as u32).filter(|&number| is_seen[number as usize]);
    let mut ready: BinaryHeap<(i64, Reverse<u32>)> =
        seen().filter(|&number| waiting[number as usize] == 0).map(key).collect();
    let mut rest: BinaryHeap<(i64, Reverse<u32>)> =
        seen().filter(|&number| waiting[number as usize] > 0).map(key).collect();
    let mut is_done = vec![false; facets.len()];
    let mut order = Vec::new();
    while let Some((_, Reverse(number))) = ready.pop().or_else(|| rest.pop()) {
        if std::mem::replace(&mut is_done[number as usize], true) {
            continue;
        }
        order.push(number);
        let first = demands.partition_point(|&(behind, _)| behind < number);
        for &(_, front) in demands[first..].iter().take_while(|(behind, _)| *behind == number) {
            let count = &mut waiting[front as usize];
            *count = count.saturating_sub(1);
            if *count == 0 && !is_done[front as usize] {
                ready.push(key(front));
            }
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::raster::Ink;

    #[test]
    fn a_large_facet_behind_a_small_one_comes_first_though_its_middle_is_nearer() {
        // A floor that comes forward to the left, and a chip a little above its far end.
        let floor = [[0.0, 0.0, -10.0], [40.0, 0.0, 10.0], [0.0, 40.0, -10.0]];
        let chip = [[30.0, 1.0, 4.0], [34.0, 1.0, 4.0], [30.0, 4.0, 4.0]];
        let facets = [floor, chip].map(|corners| Facet { corners, color: [0.0; 3] });
        let mut raster = Raster::new(40, 40, 0);
        for (number, facet) in (0..).zip(&facets) {
            raster.triangle(facet.corners, Ink { color: number, number });
        }
        assert_eq!(painting_order(&facets, &mut raster, 1), [0, 1]);
    }
}
