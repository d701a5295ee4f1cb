//! Faces that are pieces of one polygon put together again.

use super::PolygonalComplex;
use super::polygonal_complex::sign_of;
use coface_algebra::progress::Steps;
use coface_algebra::{ParityUnion, ParityUnionFind, RaggedArray, Sign};
use rayon::prelude::*;

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// A complex whose cells are sums of those of a finer one, with those sums.
#[derive(Clone, Debug)]
pub(super) struct Merged {
    pub(super) complex: PolygonalComplex,
    /// The fine vertex that each vertex is, rising.
    pub(super) vertices: Vec<u32>,
    /// The fine edges along each edge, in its direction, packed with 1 where they run against it.
    pub(super) edges: RaggedArray,
    /// The fine faces of each face, rising, packed with 1 for those with the other front. The first has the same front.
    pub(super) faces: RaggedArray,
    /// Whether a fine edge is on the inside of a face, and part of no edge.
    pub(super) is_inside_face: Vec<bool>,
}

/// What may be merged.
pub(super) trait MergeRules: Sync {
    /// Whether two faces on the two sides of an edge may become one, the second with a sign.
    fn may_merge(&self, faces: [u32; 2], sign: Sign) -> bool;

    /// Whether a vertex with two edges, which end at these other vertices, may be left out.
    fn may_dissolve(&self, vertex: u32, neighbors: [u32; 2]) -> bool;
}

/// Removes edges that have two sides, one of each of two faces that may be merged, and vertices that are left with
/// two edges and may be left out. `around` has the packed sides of faces around each edge.
///
/// A face is never closed to a surface without boundary, a closed line of vertices that may be left out stays as it is,
/// and so do vertices without which two edges would have the same ends. Each edge is a step. `None` when nothing is to
/// be done.
pub(super) fn merge(
    complex: &PolygonalComplex,
    around: &RaggedArray,
    rules: &impl MergeRules,
    steps: &Steps,
) -> Option<Merged> {
    let (is_inside_face, mut classes) = removable_edges(complex, around, rules, steps);
    let class_of: Vec<(u32, Sign)> =
        (0..complex.face_count() as u32).map(|face| classes.find(face)).collect();
    let (is_left_out, is_unused) = removable_vertices(complex, around, &is_inside_face, &class_of, rules);
    if !is_inside_face.iter().any(|&inside| inside) && !is_left_out.iter().chain(&is_unused).any(|&out| out) {
        return None;
    }
    let Chains { ends, edges, is_passed } = Chains::new(complex, &is_inside_face, &is_left_out);
    let mut number = vec![0; complex.vertex_count()];
    let mut vertices = Vec::new();
    for vertex in 0..complex.vertex_count() {
        if !is_passed[vertex] && !is_unused[vertex] {
            number[vertex] = vertices.len() as u32;
            vertices.push(vertex as u32);
        }
    }
    let ends: Vec<[u32; 2]> = ends.into_iter().map(|own| own.map(|vertex| number[vertex as usize])).collect();
    // One of the fine edges stands for the edge.
    let mut edge_of_first = vec![NONE; complex.edge_count()];
    for (edge, own) in (0u32..).zip(edges.iter()) {
        edge_of_first[(own[0] >> 1) as usize] = 2 * edge + (own[0] & 1);
    }
    let mut class_number = vec![NONE; complex.face_count()];
    let mut members: Vec<u32> = Vec::with_capacity(complex.face_count());
    let mut first_signs = Vec::new();
    let mut packed = Vec::with_capacity(complex.face_count());
    for face in 0..complex.face_count() as u32 {
        let (root, sign) = class_of[face as usize];
        if class_number[root as usize] == NONE {
            class_number[root as usize] = first_signs.len() as u32;
            first_signs.push(sign);
        }
        let class = class_number[root as usize];
        members.push(class);
        packed.push(2 * face + u32::from(sign != first_signs[class as usize]));
    }
    let mut faces = RaggedArray::grouped(first_signs.len(), members.iter().copied());
    faces.items_mut().iter_mut().for_each(|face| *face = packed[*face as usize]);
    let mut sides = RaggedArray::new();
    let mut list = Vec::new();
    for own in faces.iter() {
        list.clear();
        for &face in own {
            for &side in complex.packed_sides().list((face >> 1) as usize) {
                let edge = edge_of_first[(side >> 1) as usize];
                if edge != NONE {
                    list.push(edge ^ (side & 1) ^ (face & 1));
                }
            }
        }
        sides.push(&list);
    }
    let complex = PolygonalComplex::from_trusted_parts(vertices.len(), ends, sides);
    Some(Merged { complex, vertices, edges, faces, is_inside_face })
}

/// The edges that faces are merged across, and the classes of merged faces with their signs.
fn removable_edges(
    complex: &PolygonalComplex,
    around: &RaggedArray,
    rules: &impl MergeRules,
    steps: &Steps,
) -> (Vec<bool>, ParityUnionFind) {
    let pair = |edge: usize| match *around.list(edge) {
        [s, t] => {
            // With this sign the two sides cancel.
            let sign = if s & 1 == t & 1 { Sign::Minus } else { Sign::Plus };
            Some(([s >> 1, t >> 1], sign))
        }
        _ => None,
    };
    let mut is_removed: Vec<bool> = (0..around.len())
        .into_par_iter()
        .map(|edge| {
            steps.pass(edge);
            pair(edge).is_some_and(|(faces, sign)| faces[0] == faces[1] || rules.may_merge(faces, sign))
        })
        .collect();
    loop {
        let mut classes = ParityUnionFind::new(complex.face_count());
        if !is_removed.iter().any(|&removed| removed) {
            return (is_removed, classes);
        }
        for (edge, removed) in is_removed.iter_mut().enumerate() {
            if let (true, Some(([f, g], sign))) = (*removed, pair(edge))
                && classes.unite(f, g, sign) == ParityUnion::Contradicts
            {
                *removed = false;
            }
        }
        // What has no boundary left is not merged.
        let mut has_boundary = vec![false; complex.face_count()];
        for (edge, _) in is_removed.iter().enumerate().filter(|(_, removed)| !**removed) {
            for &side in around.list(edge) {
                has_boundary[classes.find(side >> 1).0 as usize] = true;
            }
        }
        let mut is_closed = |face: u32| !has_boundary[classes.find(face).0 as usize];
        let mut is_changed = false;
        for (edge, removed) in is_removed.iter_mut().enumerate() {
            if *removed && around.list(edge).first().is_some_and(|&side| is_closed(side >> 1)) {
                (*removed, is_changed) = (false, true);
            }
        }
        if !is_changed {
            return (is_removed, classes);
        }
    }
}

/// The vertices that may be left out, and those that no edge is left at. Where a polygon is folded, an edge may be on it
/// up to the fold and go on without it: then the vertex at the fold stays.
fn removable_vertices(
    complex: &PolygonalComplex,
    around: &RaggedArray,
    is_removed: &[bool],
    class_of: &[(u32, Sign)],
    rules: &impl MergeRules,
) -> (Vec<bool>, Vec<bool>) {
    // The first two edges, packed with 1 for those that end at the vertex, and the number of edges up to three.
    let mut edges = vec![[NONE; 2]; complex.vertex_count()];
    let mut count = vec![0u8; complex.vertex_count()];
    for (edge, ends) in complex.edges().iter().enumerate().filter(|&(edge, _)| !is_removed[edge]) {
        for (packed, &vertex) in (2 * edge as u32..).zip(ends) {
            let degree = &mut count[vertex as usize];
            if let Some(place) = edges[vertex as usize].get_mut(usize::from(*degree)) {
                *place = packed;
            }
            *degree = (*degree + 1).min(3);
        }
    }
    // The faces at an edge, each with the direction in which it runs along the edge away from the vertex.
    let faces_at = |packed: u32, is_turned: bool| {
        let sides = around.list((packed >> 1) as usize).iter();
        let mut faces: Vec<(u32, u32)> = sides
            .map(|&side| {
                let (class, sign) = class_of[(side >> 1) as usize];
                let against = (side & 1) ^ (packed & 1) ^ u32::from(sign == Sign::Minus);
                (class, against ^ u32::from(is_turned))
            })
            .collect();
        faces.sort_unstable();
        faces
    };
    let is_left_out = (0..complex.vertex_count())
        .into_par_iter()
        .map(|vertex| {
            let own = edges[vertex];
            let other_end = |packed: u32| complex.edges()[(packed >> 1) as usize][(packed & 1 ^ 1) as usize];
            count[vertex] == 2
                && rules.may_dissolve(vertex as u32, own.map(other_end))
                && faces_at(own[0], false) == faces_at(own[1], true)
        })
        .collect();
    (is_left_out, count.into_iter().map(|count| count == 0).collect())
}

/// Edges strung together at the vertices that are left out.
struct Chains {
    /// The first and the last vertex of each, the lower first; chains are sorted by them.
    ends: Vec<[u32; 2]>,
    /// The packed edges of each.
    edges: RaggedArray,
    /// Whether a vertex is on the inside of a chain.
    is_passed: Vec<bool>,
}

impl Chains {
    fn new(complex: &PolygonalComplex, is_removed: &[bool], is_left_out: &[bool]) -> Self {
        let edge_count = complex.edge_count();
        let kept = |edge: &usize| !is_removed[*edge];
        let mut at_vertex = vec![[NONE; 2]; complex.vertex_count()];
        for edge in (0..edge_count).filter(kept) {
            for vertex in complex.edges()[edge] {
                if is_left_out[vertex as usize] {
                    let place = &mut at_vertex[vertex as usize];
                    place[usize::from(place[0] != NONE)] = edge as u32;
                }
            }
        }
        // The side that goes on from the end of a side.
        let next = |side: u32| -> Option<u32> {
            let [_, end] = complex.side_ends(side);
            is_left_out[end as usize].then(|| {
                let [e, f] = at_vertex[end as usize];
                let other = if e == side >> 1 { f } else { e };
                2 * other + u32::from(complex.edges()[other as usize][0] != end)
            })
        };
        // Strings of more than one edge, and single edges.
        let mut strings: Vec<Vec<u32>> = Vec::new();
        let mut singles: Vec<u32> = Vec::new();
        let mut is_strung = vec![false; edge_count];
        for edge in (0..edge_count).filter(kept) {
            if is_strung[edge] {
                continue;
            }
            let forth = 2 * edge as u32;
            if next(forth).is_none() && next(forth ^ 1).is_none() {
                singles.push(forth);
                continue;
            }
            // Back to the first vertex that stays, or once around.
            let mut start = forth ^ 1;
            while let Some(side) = next(start)
                && side >> 1 != forth >> 1
            {
                start = side;
            }
            let is_loop = next(start).is_some();
            let first = start ^ 1;
            let mut string = vec![first];
            while let Some(side) = next(string[string.len() - 1])
                && side != first
            {
                string.push(side);
            }
            string.iter().for_each(|&side| is_strung[(side >> 1) as usize] = true);
            let [from, to] = ends_of(complex, &string);
            if is_loop || from == to {
                singles.extend(string);
            } else {
                if from > to {
                    string.reverse();
                    string.iter_mut().for_each(|side| *side ^= 1);
                }
                strings.push(string);
            }
        }
        // From the lower to the higher end.
        let mut chains: Vec<([u32; 2], u32)> = Vec::with_capacity(strings.len() + singles.len());
        let add_single = |chains: &mut Vec<([u32; 2], u32)>, side: u32| {
            let [a, b] = complex.side_ends(side);
            chains.push(if a < b { ([a, b], side) } else { ([b, a], side ^ 1) });
        };
        singles.into_iter().for_each(|side| add_single(&mut chains, side));
        // Above all sides: strings by their numbers.
        let first_string = 2 * edge_count as u32;
        chains.extend((first_string..).zip(&strings).map(|(number, own)| (ends_of(complex, own), number)));
        chains.sort_unstable();
        // A string that is not the only one with its ends falls apart.
        let mut apart = Vec::new();
        for own in chains.chunk_by(|x, y| x.0 == y.0).filter(|own| own.len() > 1) {
            apart.extend(own.iter().map(|chain| chain.1).filter(|&number| number >= first_string));
        }
        if !apart.is_empty() {
            apart.sort_unstable();
            chains.retain(|chain| apart.binary_search(&chain.1).is_err());
            for &number in &apart {
                let own = &strings[(number - first_string) as usize];
                own.iter().for_each(|&side| add_single(&mut chains, side));
            }
            chains.sort_unstable();
        }
        let mut is_passed = vec![false; complex.vertex_count()];
        let mut edges = RaggedArray::new();
        for &(_, number) in &chains {
            if number < first_string {
                edges.push(&[number]);
                continue;
            }
            let own = &strings[(number - first_string) as usize];
            own[1..].iter().for_each(|&side| is_passed[complex.side_ends(side)[0] as usize] = true);
            edges.push(own);
        }
        Self { ends: chains.into_iter().map(|chain| chain.0).collect(), edges, is_passed }
    }
}

/// Where sides one after the other begin and end.
fn ends_of(complex: &PolygonalComplex, sides: &[u32]) -> [u32; 2] {
    [complex.side_ends(sides[0])[0], complex.side_ends(sides[sides.len() - 1])[1]]
}

impl Merged {
    /// The fine vertices along a packed side of the merged complex, from its first to its last.
    pub(super) fn path(&self, fine: &PolygonalComplex, side: u32) -> Vec<u32> {
        let own = self.edges.list((side >> 1) as usize);
        let mut path = vec![fine.side_ends(own[0])[0]];
        path.extend(own.iter().map(|&part| fine.side_ends(part)[1]));
        if sign_of(side) == Sign::Minus {
            path.reverse();
        }
        path
    }
}
