//! Polygons of an overlay in an order that does not depend on the order of the input.

use super::outline::Outline;
use coface_algebra::RaggedArray;
use coface_algebra::{EdgeId, VertexId};
use coface_arrange::planar::PlanarPolygons;
use rayon::prelude::*;

/// Polygons with vertices in lexicographic order of their exact positions, rings from their lowest vertices on, and polygons and
/// holes in the order of their rings.
pub(super) struct Canonical<'a> {
    found: &'a PlanarPolygons<'a>,
    pub(super) outline: Outline,
    /// The vertex of the overlay's polygons at each place, and the place of each.
    pub(super) order: Vec<u32>,
    number_of: Vec<u32>,
    /// The polygon of the overlay at each place, and the place of each.
    pub(super) polygons: Vec<u32>,
    polygon_numbers: Vec<u32>,
}

/// Runs that are so long in the mean are found and merged.
const LONG_RUN: usize = 512;

/// What vertices are sorted by.
struct Place {
    rounded: [f64; 2],
    is_exact: bool,
    vertex: u32,
}

impl<'a> Canonical<'a> {
    pub(super) fn new(found: &'a PlanarPolygons<'a>) -> Self {
        let order = order(found);
        let number_of = inverse(&order);
        let rings = RaggedArray::from_lists(found.rings().iter().map(|ring| {
            let mut ring: Vec<u32> = ring.iter().map(|&vertex| number_of[vertex as usize]).collect();
            let lowest = (0..ring.len()).min_by_key(|&i| ring[i]).unwrap_or(0);
            ring.rotate_left(lowest);
            ring
        }));
        let ring = |number: u32| rings.list(number as usize);
        let mut lists: Vec<(u32, Vec<u32>)> = (0..)
            .zip(found.polygons().iter())
            .map(|(polygon, list)| {
                let mut list = list.to_vec();
                list[1..].sort_unstable_by_key(|&number| ring(number));
                (polygon, list)
            })
            .collect();
        lists.par_sort_unstable_by_key(|(_, list)| ring(list[0]));
        let mut numbers = 0u32..;
        let outline = Outline {
            rings: RaggedArray::from_lists(lists.iter().flat_map(|(_, list)| list.iter().map(|&r| ring(r)))),
            polygons: RaggedArray::from_lists(
                lists.iter().map(|(_, list)| numbers.by_ref().take(list.len()).collect::<Vec<_>>()),
            ),
        };
        let polygons: Vec<u32> = lists.iter().map(|&(polygon, _)| polygon).collect();
        let polygon_numbers = inverse(&polygons);
        Self { found, outline, order, number_of, polygons, polygon_numbers }
    }

    /// The edges by their vertices, the lower first, rising, each once; and for each the sources of the sides along it, rising.
    pub(super) fn edges<I: IntoIterator<Item = u32>>(
        &self,
        sources_of_side: impl Fn(usize) -> I,
    ) -> (Vec<[u32; 2]>, RaggedArray) {
        let mut pairs: Vec<[u32; 2]> = Vec::with_capacity(self.found.rings().item_count());
        for ring in self.found.rings().iter() {
            for (i, &from) in ring.iter().enumerate() {
                let to = ring[if i + 1 == ring.len() { 0 } else { i + 1 }];
                let [a, b] = [from, to].map(|vertex| self.number_of[vertex as usize]);
                pairs.push([a.min(b), a.max(b)]);
            }
        }
        // Few sides of rings have the same lower vertex.
        let mut by_lower = RaggedArray::grouped(self.number_of.len(), pairs.iter().map(|pair| pair[0]));
        by_lower.change_lists(|sides, _: &mut ()| {
            if sides.len() > 1 {
                sides.sort_unstable_by_key(|&side| (pairs[side as usize][1], side));
            }
        });
        let (mut edges, mut sources) = (Vec::with_capacity(pairs.len()), RaggedArray::new());
        let mut list = Vec::new();
        for same in by_lower.items().chunk_by(|&a, &b| pairs[a as usize] == pairs[b as usize]) {
            edges.push(pairs[same[0] as usize]);
            list.clear();
            list.extend(
                same.iter()
                    .flat_map(|&side| self.found.sides_of_edge(EdgeId::from_u32(side)))
                    .flat_map(&sources_of_side),
            );
            if list.len() > 1 {
                list.sort_unstable();
                list.dedup();
            }
            sources.push(&list);
        }
        (edges, sources)
    }

    /// For each polygon the regions, or features, that contain some of its faces, rising, from those of each face.
    pub(super) fn regions(&self, of_face: &RaggedArray) -> RaggedArray {
        let mut pairs: Vec<[u32; 2]> = Vec::new();
        for (face, regions) in of_face.iter().enumerate() {
            let Some(polygon) = self.found.polygon_of_face(face) else { continue };
            pairs.extend(regions.iter().map(|&region| [self.polygon_numbers[polygon], region]));
        }
        pairs.par_sort_unstable();
        pairs.dedup();
        let mut lists = RaggedArray::grouped(self.polygons.len(), pairs.iter().map(|pair| pair[0]));
        lists.items_mut().iter_mut().for_each(|item| *item = pairs[*item as usize][1]);
        lists
    }
}

/// The vertices in lexicographic order of their exact positions.
fn order(found: &PlanarPolygons<'_>) -> Vec<u32> {
    let coordinates = found.positions().as_flat().as_chunks::<2>().0;
    let mut places: Vec<Place> = coordinates
        .par_iter()
        .enumerate()
        .map(|(vertex, rounded)| Place {
            // Zeros of both signs are equal.
            rounded: rounded.map(|x| x + 0.0),
            is_exact: found.is_exactly_rounded_at(VertexId::new(vertex)),
            vertex: vertex as u32,
        })
        .collect();
    let compare = |a: &Place, b: &Place| {
        let by_axis = |axis: usize| a.rounded[axis].total_cmp(&b.rounded[axis]);
        by_axis(0).then_with(|| {
            if a.is_exact && b.is_exact {
                by_axis(1)
            } else {
                let [p, q] = [a, b].map(|place| found.point(VertexId::from_u32(place.vertex)));
                p.compare(&q)
            }
        })
    };
    // Long curves rise and fall in long runs.
    let rises = |pair: &[Place]| pair[0].rounded[0] < pair[1].rounded[0];
    let turns = places.windows(3).filter(|three| rises(&three[..2]) != rises(&three[1..])).count();
    if turns < places.len() / LONG_RUN {
        places.sort_by(compare);
    } else {
        places.par_sort_unstable_by(compare);
    }
    places.into_iter().map(|place| place.vertex).collect()
}

/// The place of each number in a list of all numbers.
fn inverse(order: &[u32]) -> Vec<u32> {
    let mut places = vec![0; order.len()];
    order.iter().zip(0..).for_each(|(&number, place)| places[number as usize] = place);
    places
}
