//! Where the boundary of a selection is no curve or surface.

use coface_algebra::CellId;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{RaggedArray, Sign, SparseMatrix, UnionFind};

const NONE: u32 = u32::MAX;

/// Where the boundary of a selection is pinched.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Pinches {
    /// Ridges with more than two facets, rising.
    pub(super) ridges: Vec<CellId>,
    /// Vertices with more than one fan of facets, rising.
    pub(super) vertices: Vec<CellId>,
}

impl Pinches {
    /// The pinches of a boundary with these facets, cells of one degree less than the complex has. A pair of `slits` is a
    /// facet and a ridge that it has on both sides, a pair of `points` a facet and a vertex inside of it that is in no ridge of
    /// it; both rise, as the facets do.
    ///
    /// # Complexity
    /// Linear but for the corners at pinched edges, and at vertices that a facet runs through twice: nearly linear in
    /// those.
    pub(super) fn new(
        complex: &ChainComplex,
        facets: &[(CellId, Sign)],
        slits: &[(u32, u32)],
        points: &[(u32, u32)],
    ) -> Self {
        let degree = complex.degree_count().saturating_sub(1);
        let Some(ridges) = degree.checked_sub(1).and_then(|below| complex.boundary_matrix(below)) else {
            return Self::default();
        };
        let mut around = RaggedArray::new();
        let mut list = Vec::new();
        for &(facet, _) in facets {
            let own = ridges.column(facet.index()).rows();
            let start = slits.partition_point(|slit| slit.0 < facet.to_u32());
            if slits.get(start).is_none_or(|slit| slit.0 != facet.to_u32()) {
                around.push(own);
                continue;
            }
            list.clear();
            list.extend(own);
            let inside = slits[start..].iter().take_while(|slit| slit.0 == facet.to_u32());
            inside.for_each(|&(_, ridge)| list.extend([ridge; 2]));
            around.push(&list);
        }
        let is_facet = |facet: u32| facets.binary_search_by_key(&facet, |own| own.0.to_u32()).is_ok();
        let mut points: Vec<u32> =
            points.iter().filter(|&&(facet, _)| is_facet(facet)).map(|&(_, vertex)| vertex).collect();
        points.sort_unstable();
        let pairs = Pairs::new(&around, ridges.row_count());
        let pinched: Vec<CellId> = pairs.crowded.iter().map(|&ridge| CellId::from_u32(ridge)).collect();
        match (degree, complex.boundary_matrix(1)) {
            (2, _) => Self { ridges: pinched.clone(), vertices: pinched },
            (3, Some(ends)) => {
                let split = split_vertices(&around, &pairs, ends, &points);
                Self { ridges: pinched, vertices: split.into_iter().map(CellId::new).collect() }
            }
            _ => Self { ridges: pinched, vertices: Vec::new() },
        }
    }
}

/// The slots of ridges: slot s is the ridge at position s of those around all facets, one facet after the other.
struct Pairs {
    /// The first two slots of each ridge.
    slots: Vec<[u32; 2]>,
    /// Ridges with more than two slots, rising.
    crowded: Vec<u32>,
}

impl Pairs {
    fn new(around: &RaggedArray, ridge_count: usize) -> Self {
        let mut pairs = Self { slots: vec![[NONE; 2]; ridge_count], crowded: Vec::new() };
        for (slot, &ridge) in (0..).zip(around.items()) {
            let known = &mut pairs.slots[ridge as usize];
            match known.iter_mut().find(|place| **place == NONE) {
                Some(place) => *place = slot,
                None => pairs.crowded.push(ridge),
            }
        }
        pairs.crowded.sort_unstable();
        pairs.crowded.dedup();
        pairs
    }
}

/// Which of two ends of an edge are known.
const BOTH: u8 = 0b11;

/// The vertices at which facets fall apart into fans, facets that follow each other across edges, rising.
///
/// A fan is walked around its vertex from edge to edge. Where that is not possible, since an edge has not two facets or
/// a facet more than two edges at the vertex, fans are put together by union-find.
fn split_vertices(around: &RaggedArray, pairs: &Pairs, ends: &SparseMatrix, points: &[u32]) -> Vec<usize> {
    let mut facet_of_slot = Vec::with_capacity(around.item_count());
    for facet in 0..around.len() {
        facet_of_slot.resize(around.start(facet + 1), facet as u32);
    }
    let ends_of = |slot: u32| ends.column(around.items()[slot as usize] as usize).rows();
    // The only other slot of the same facet with an end at the vertex.
    let turned = |slot: u32, vertex: u32| {
        let facet = facet_of_slot[slot as usize] as usize;
        let own = around.start(facet) as u32..around.start(facet + 1) as u32;
        let mut others = own.filter(|&other| other != slot && ends_of(other).contains(&vertex));
        others.next().filter(|_| others.next().is_none())
    };
    let crossed = |slot: u32| {
        let ridge = around.items()[slot as usize];
        let [a, b] = pairs.slots[ridge as usize];
        (b != NONE && pairs.crowded.binary_search(&ridge).is_err()).then_some(if a == slot { b } else { a })
    };
    let mut is_passed = vec![0u8; around.item_count()];
    // The number of fans at each vertex up to two, and three for those that have to be looked at otherwise.
    let mut fans = vec![0u8; ends.row_count()];
    for first in 0..around.item_count() as u32 {
        for end in 0..2 {
            if is_passed[first as usize] >> end & 1 != 0 {
                continue;
            }
            let Some(&vertex) = ends_of(first).get(end) else { continue };
            let mut pass = |slot: u32| {
                let place = ends_of(slot).iter().position(|&other| other == vertex);
                is_passed[slot as usize] |= place.map_or(BOTH, |place| 1 << place);
            };
            let mut slot = first;
            let is_closed = loop {
                pass(slot);
                let Some(other) = turned(slot, vertex) else { break false };
                pass(other);
                let Some(next) = crossed(other) else { break false };
                if next == first {
                    break true;
                }
                slot = next;
            };
            let count = &mut fans[vertex as usize];
            *count = if is_closed && *count < 3 { (*count + 1).min(2) } else { 3 };
        }
    }
    let is_used: Vec<bool> = points.iter().map(|&vertex| fans[vertex as usize] > 0).collect();
    if fans.contains(&3) {
        for vertex in united_fans(around, pairs, ends, |vertex| fans[vertex as usize] == 3) {
            fans[vertex as usize] = 2;
        }
    }
    // Around a point inside of it a facet is a fan of its own.
    let mut own = points.iter().zip(is_used).peekable();
    while let Some((&vertex, is_used)) = own.next() {
        if is_used || own.peek().is_some_and(|&(&next, _)| next == vertex) {
            fans[vertex as usize] = 2;
        }
    }
    (0..fans.len()).filter(|&vertex| fans[vertex] == 2).collect()
}

/// The same for some vertices, by union-find on the corners that facets have there.
fn united_fans(
    around: &RaggedArray,
    pairs: &Pairs,
    ends: &SparseMatrix,
    is_wanted: impl Fn(u32) -> bool,
) -> Vec<u32> {
    let mut corners = RaggedArray::new();
    let mut list = Vec::new();
    for edges in around.iter() {
        list.clear();
        list.extend(edges.iter().flat_map(|&edge| ends.column(edge as usize).rows()));
        list.retain(|&vertex| is_wanted(vertex));
        list.sort_unstable();
        list.dedup();
        corners.push(&list);
    }
    let corner = |facet: u32, vertex: u32| {
        let place = corners.list(facet as usize).binary_search(&vertex).expect("sides have corners");
        (corners.start(facet as usize) + place) as u32
    };
    let mut fans = UnionFind::new(corners.item_count());
    // The facet that each edge was met in first.
    let mut first_facet = vec![NONE; pairs.slots.len()];
    for (facet, edges) in (0..).zip(around.iter()) {
        for &edge in edges {
            let first = &mut first_facet[edge as usize];
            if *first == NONE {
                *first = facet;
                continue;
            }
            for &vertex in ends.column(edge as usize).rows().iter().filter(|&&vertex| is_wanted(vertex)) {
                fans.unite(corner(*first, vertex), corner(facet, vertex));
            }
        }
    }
    let mut first_corner: Vec<(u32, u32)> = corners.items().iter().copied().zip(0..).collect();
    first_corner.sort_unstable();
    let at_vertices = first_corner.chunk_by(|a, b| a.0 == b.0);
    let split = at_vertices.filter(|at| at.iter().any(|&(_, corner)| !fans.same(at[0].1, corner)));
    split.map(|at| at[0].0).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    proptest! {
        /// Walks from edge to edge find what union-find finds, whatever triangles and squares meet.
        #[test]
        fn fans_are_those_of_union_find(
            polygons in prop::collection::vec(prop::sample::subsequence((0u32..8).collect::<Vec<_>>(), 3..5), 0..24),
        ) {
            let polygons: BTreeSet<Vec<u32>> = polygons.into_iter().collect();
            let sides = |polygon: &Vec<u32>| {
                let next = polygon.iter().copied().cycle().skip(1);
                let sides = polygon.iter().copied().zip(next).take(polygon.len());
                sides.map(|(a, b)| [a.min(b), a.max(b)]).collect::<Vec<_>>()
            };
            let edges: BTreeSet<[u32; 2]> = polygons.iter().flat_map(sides).collect();
            let edges: Vec<[u32; 2]> = edges.into_iter().collect();
            let around = RaggedArray::from_lists(polygons.iter().map(|polygon| {
                let number = |side: [u32; 2]| edges.binary_search(&side).unwrap() as u32;
                sides(polygon).into_iter().map(number).collect::<Vec<_>>()
            }));
            let entries = edges.iter().enumerate().flat_map(|(e, &[a, b])| [(a as usize, e, -1), (b as usize, e, 1)]);
            let ends = SparseMatrix::from_entries(8, edges.len(), entries).unwrap();
            let pairs = Pairs::new(&around, edges.len());
            let expected = united_fans(&around, &pairs, &ends, |_| true);
            let found: Vec<u32> =
                split_vertices(&around, &pairs, &ends, &[]).into_iter().map(|vertex| vertex as u32).collect();
            prop_assert_eq!(found, expected);
            let degree = |edge: u32| around.items().iter().filter(|&&other| other == edge).count();
            let crowded: Vec<u32> = (0..edges.len() as u32).filter(|&edge| degree(edge) > 2).collect();
            prop_assert_eq!(pairs.crowded, crowded);
        }
    }
}
