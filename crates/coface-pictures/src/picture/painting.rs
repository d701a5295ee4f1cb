//! An order to paint triangles in, so that those behind come first.

use super::raster::{NOTHING, Raster};
use super::scene_picture::Facet;
use super::sight::finer;
use coface_algebra::progress::stage;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// So often facets are cut, and at most into so many more.
const ROUNDS: usize = 6;
const MOST_PIECES: usize = 1 << 14;

/// The facets that are seen in a raster, those behind first. Facets that pierce each other are cut along each other's planes before; the raster
/// is drawn again then, and has the pieces.
///
/// In each pixel the facet that is seen has to come after all others there that are painted; these demands are sorted topologically, and
/// where nothing demands an order, by depth. Facets that go around in a circle, each partly before the next, have no order: then the
/// farthest comes first.
///
/// $O(p \log p)$ for p pixels that the facets cover, in the worst case; demands are noted once a run of pixels.
pub(super) fn painting_order(
    facets: &mut Vec<Facet>,
    raster: &mut Raster,
    factor: usize,
    draw: impl Fn(&[Facet]) -> Raster,
) -> Vec<u32> {
    let most = facets.len() + MOST_PIECES;
    let mut demands = demands(facets, raster, factor);
    for _ in 0..ROUNDS {
        let pierces = |&&(a, b): &&(u32, u32)| {
            let [one, other] = [a, b].map(|number| &facets[number as usize]);
            demands.binary_search(&(b, a)).is_ok() && straddles(one, other) && straddles(other, one)
        };
        let mut cuts: Vec<(u32, u32)> = demands.iter().filter(pierces).copied().collect();
        cuts.dedup_by_key(|cut| cut.0);
        if cuts.is_empty() || facets.len() + 2 * cuts.len() > most {
            break;
        }
        let pieces: Vec<[Facet; 3]> =
            cuts.iter().map(|&(a, b)| pieces(&facets[a as usize], &facets[b as usize])).collect();
        for ((number, _), [first, second, third]) in cuts.into_iter().zip(pieces) {
            facets[number as usize] = first;
            facets.extend([second, third]);
        }
        *raster = draw(facets);
        demands = self::demands(facets, raster, factor);
    }
    sorted(facets, &demands, &seen_in(facets, raster))
}

/// Which facets are seen somewhere.
fn seen_in(facets: &[Facet], raster: &Raster) -> Vec<bool> {
    let mut is_seen = vec![false; facets.len()];
    for &number in raster.seen.iter().filter(|&&number| number != NOTHING) {
        is_seen[number as usize] = true;
    }
    is_seen
}

/// The facets that are seen, in an order that the demands allow.
fn sorted(facets: &[Facet], demands: &[(u32, u32)], is_seen: &[bool]) -> Vec<u32> {
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

/// Which facet that is seen somewhere has to come before which other one, in order.
fn demands(facets: &[Facet], raster: &mut Raster, factor: usize) -> Vec<(u32, u32)> {
    let is_seen = seen_in(facets, raster);
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
    demands
}

/// How far the corners of a facet are in front of the plane of another one, in units without meaning; 0 near it.
fn sides(facet: &Facet, other: &Facet) -> [f64; 3] {
    let [a, b, c] = other.corners;
    let [u, v] = [b, c].map(|corner| [0, 1, 2].map(|axis| corner[axis] - a[axis]));
    let normal = [0, 1, 2].map(|axis| {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        u[next] * v[last] - u[last] * v[next]
    });
    let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    facet.corners.map(|corner| {
        let side: f64 = (0..3).map(|axis| normal[axis] * (corner[axis] - a[axis])).sum();
        // A hundredth of a pixel.
        if side.abs() > 1e-2 * length { side } else { 0.0 }
    })
}

fn straddles(facet: &Facet, other: &Facet) -> bool {
    let sides = sides(facet, other);
    sides.iter().any(|&side| side < 0.0) && sides.iter().any(|&side| side > 0.0)
}

/// The three pieces of a facet on both sides of the plane of one that it straddles.
fn pieces(facet: &Facet, other: &Facet) -> [Facet; 3] {
    let sides = sides(facet, other);
    // The corner that is alone on its side; one on the plane counts to the other side of it.
    let front = sides.iter().filter(|&&side| side > 0.0).count();
    let is_alone = |side: f64| if front == 1 { side > 0.0 } else { side < 0.0 };
    let alone = (0..3).find(|&i| is_alone(sides[i])).unwrap_or(0);
    let (next, last) = ((alone + 1) % 3, (alone + 2) % 3);
    let corners = facet.corners;
    let crossing = |to: usize| {
        let share = sides[alone] / (sides[alone] - sides[to]);
        [0, 1, 2].map(|axis| corners[alone][axis] + share * (corners[to][axis] - corners[alone][axis]))
    };
    let (p, q) = (crossing(next), crossing(last));
    [[corners[alone], p, q], [p, corners[next], corners[last]], [p, corners[last], q]]
        .map(|corners| Facet { corners, color: facet.color })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::raster::Ink;

    fn draw(facets: &[Facet]) -> Raster {
        let mut raster = Raster::new(40, 40, 0);
        for (number, facet) in (0..).zip(facets) {
            raster.triangle(facet.corners, Ink { color: number, number });
        }
        raster
    }

    #[test]
    fn a_large_facet_behind_a_small_one_comes_first_though_its_middle_is_nearer() {
        // A floor that comes forward to the left, and a chip a little above its far end.
        let floor = [[0.0, 0.0, -10.0], [40.0, 0.0, 10.0], [0.0, 40.0, -10.0]];
        let chip = [[30.0, 1.0, 4.0], [34.0, 1.0, 4.0], [30.0, 4.0, 4.0]];
        let mut facets = [floor, chip].map(|corners| Facet { corners, color: [0.0; 3] }).to_vec();
        let mut raster = draw(&facets);
        assert_eq!(painting_order(&mut facets, &mut raster, 1, draw), [0, 1]);
        assert_eq!(facets.len(), 2);
    }

    #[test]
    fn facets_that_pierce_each_other_are_cut() {
        // Two triangles that cross in the line x = 20: each is in front of the other on one side.
        let one = [[0.0, 0.0, 0.0], [40.0, 0.0, 20.0], [20.0, 40.0, 10.0]];
        let two = [[0.0, 0.0, 20.0], [40.0, 0.0, 0.0], [20.0, 40.0, 10.0]];
        let mut facets =
            [(one, 0.25), (two, 0.75)].map(|(corners, shade)| Facet { corners, color: [shade; 3] }).to_vec();
        let mut raster = draw(&facets);
        let color = |facets: &[Facet], number: u32| facets.get(number as usize).map(|facet| facet.color);
        let before: Vec<_> = raster.seen.iter().map(|&number| color(&facets, number)).collect();
        let order = painting_order(&mut facets, &mut raster, 1, draw);
        assert_eq!(facets.len(), 6);
        // Painted one over the other they are what is seen.
        let mut painted = vec![None; before.len()];
        for &number in &order {
            raster.visit(facets[number as usize].corners, |_, at, _| painted[at] = color(&facets, number));
        }
        let different = painted.iter().zip(&before).filter(|(a, b)| a != b).count();
        assert!(different <= 40, "{different} pixels, more than along the line");
    }
}
