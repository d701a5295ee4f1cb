//! Moves on triangulated 3-manifolds: other tetrahedra in a ball with the same boundary.
//!
//! A move takes tetrahedra out and puts others in their place; the space stays the same up to homeomorphism. Tetrahedra that stay keep
//! their vertices; those behind removed ones move up, and new ones come last.

use coface_algebra::{CellId, Error, UnionFind};
use coface_complexes::gluing::{FaceClasses, GluingTable};
use std::fmt;

/// The number of vertices of a tetrahedron.
const CORNERS: usize = 4;

/// A move on a table of tetrahedra.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum GluingMove {
    /// Two different tetrahedra that are glued at this facet of the first give way to three around a new edge.
    TwoToThree {
        /// A tetrahedron.
        tetrahedron: usize,
        /// Its facet.
        facet: usize,
    },
    /// Three different tetrahedra around an edge give way to two.
    ThreeToTwo {
        /// The class of the edge.
        edge: usize,
    },
    /// Two different tetrahedra around an edge of degree 2 are flattened.
    TwoToZero {
        /// The class of the edge.
        edge: usize,
    },
    /// Four different tetrahedra around a vertex give way to one.
    FourToOne {
        /// The class of the vertex.
        vertex: usize,
    },
    /// An edge inside, with two different ends and different tetrahedra around it, shrinks to a point; these tetrahedra are flattened. One end at least
    /// is neither in the boundary nor ideal.
    Collapse {
        /// The class of the edge.
        edge: usize,
    },
}

impl fmt::Display for GluingMove {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TwoToThree { tetrahedron, facet } => {
                write!(f, "2-3 at facet {facet} of tetrahedron {tetrahedron}")
            }
            Self::ThreeToTwo { edge } => write!(f, "3-2 at edge {edge}"),
            Self::TwoToZero { edge } => write!(f, "2-0 at edge {edge}"),
            Self::FourToOne { vertex } => write!(f, "4-1 at vertex {vertex}"),
            Self::Collapse { edge } => write!(f, "collapse of edge {edge}"),
        }
    }
}

/// A facet of a tetrahedron with its vertices in an order; the last is the one across.
type Facet = (usize, [usize; CORNERS]);

/// The table after a move; `None` where the move cannot be made, and for tables of other dimensions than 3.
///
/// # Errors
/// Those of [`GluingTable::faces`].
///
/// # Complexity
/// Linear.
///
/// # References
/// U. Pachner, *P.L. homeomorphic manifolds are equivalent by elementary shellings* (1991); S. Matveev, *Transformations of special spines
/// and the Zeeman conjecture* (1987).
///
/// # Examples
/// A move and the one that undoes it.
/// ```
/// use coface_complexes::gluing::GluingTable;
/// use coface_topology::{GluingMove, moved};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let lens = GluingTable::from_isomorphism_signature("cMcabbjxr", 3)?;
/// let forth = GluingMove::TwoToThree { tetrahedron: 0, facet: 0 };
/// let Some(larger) = moved(&lens, forth)? else { return Ok(()) };
/// assert_eq!(larger.simplex_count(), 3);
/// let back = |edge: usize| moved(&larger, GluingMove::ThreeToTwo { edge });
/// let smaller: Result<Vec<Option<GluingTable>>, _> = (0..larger.faces()?.class_counts()[1]).map(back).collect();
/// assert!(smaller?.iter().flatten().any(|table| table.isomorphism(&lens).is_some()));
/// # Ok(()) }
/// ```
pub fn moved(table: &GluingTable, step: GluingMove) -> Result<Option<GluingTable>, Error> {
    let faces = table.faces()?;
    let ideal = table.ideal_vertices(&faces)?;
    moved_with(table, (&faces, &ideal), step)
}

/// As [`moved`], with the face classes of the table and its ideal vertices, rising.
pub(super) fn moved_with(
    table: &GluingTable,
    (faces, ideal): (&FaceClasses, &[CellId]),
    step: GluingMove,
) -> Result<Option<GluingTable>, Error> {
    if table.dimension() != 3 {
        return Ok(None);
    }
    let moving = Moving { table };
    match step {
        GluingMove::TwoToThree { tetrahedron, facet } => moving.two_to_three(tetrahedron, facet),
        GluingMove::ThreeToTwo { edge } => moving.three_to_two(faces, edge),
        GluingMove::TwoToZero { edge } => moving.two_to_zero(faces, edge),
        GluingMove::FourToOne { vertex } => moving.four_to_one(faces, vertex),
        GluingMove::Collapse { edge } => moving.collapse(faces, ideal, edge),
    }
}

/// Whether these pairs of classes, as edges of a graph in which all outer classes are one node, close a circle: made one, they would close up
/// a space of its own.
fn is_closing(pairs: &[[usize; 2]], is_outer: impl Fn(usize) -> bool) -> bool {
    let mut nodes = pairs.as_flattened().to_vec();
    nodes.sort_unstable();
    nodes.dedup();
    // Node 0 is the boundary.
    let place = |class: usize| match nodes.binary_search(&class) {
        Ok(place) if !is_outer(class) => place as u32 + 1,
        _ => 0,
    };
    let mut partition = UnionFind::new(nodes.len() + 1);
    pairs.iter().any(|&[x, y]| !partition.unite(place(x), place(y)))
}

/// A table whose tetrahedra are replaced.
struct Moving<'a> {
    table: &'a GluingTable,
}

impl Moving<'_> {
    fn two_to_three(&self, one: usize, facet: usize) -> Result<Option<GluingTable>, Error> {
        if one >= self.table.simplex_count() || facet >= CORNERS {
            return Ok(None);
        }
        let Some((two, images)) = self.table.neighbor(one, facet).filter(|&(two, _)| two != one) else {
            return Ok(None);
        };
        let shared: Vec<usize> = (0..CORNERS).filter(|&vertex| vertex != facet).collect();
        let image = |vertex: usize| usize::from(images[vertex]);
        let (top, bottom) = (facet, image(facet));
        // New tetrahedron i has the vertices top, bottom and the two shared ones but i, in this order.
        let mut pairs = Vec::new();
        let mut inner = Vec::new();
        for i in 0..3 {
            let [a, b] = [shared[(i + 1) % 3], shared[(i + 2) % 3]];
            // Across the bottom vertex lies the outer facet of the upper tetrahedron, which is across the shared vertex i.
            pairs.push(((one, [top, a, b, shared[i]]), (i, [0, 2, 3, 1])));
            pairs.push(((two, [bottom, image(a), image(b), image(shared[i])]), (i, [1, 2, 3, 0])));
            // Next to new tetrahedron i + 1 lies the facet across a, with b the first shared vertex there.
            inner.push(((i, [0, 1, 3, 2]), ((i + 1) % 3, [0, 1, 2, 3])));
        }
        self.replaced(&[one, two], 3, &pairs, &inner)
    }

    /// The tetrahedra around an edge that lies inside, in order: each with the ends of the edge, the vertex across the facet that is entered, and
    /// the one across the facet that is left. `None` if one of them is met twice, or more than so many.
    fn around(&self, faces: &FaceClasses, edge: usize, most: usize) -> Option<Vec<Facet>> {
        if edge >= *faces.class_counts().get(1)? || faces.is_boundary(1, CellId::new(edge)) {
            return None;
        }
        let (start, ends) = faces.representative(1, CellId::new(edge));
        let beside: Vec<usize> = (0..CORNERS).filter(|vertex| !ends.contains(vertex)).collect();
        let first = (start, [ends[0], ends[1], beside[0], beside[1]]);
        let mut found = vec![first];
        loop {
            let (tetrahedron, [a, b, enter, leave]) = *found.last()?;
            // Through the facet across `leave`.
            let (next, images) = self.table.neighbor(tetrahedron, leave)?;
            let image = |vertex: usize| usize::from(images[vertex]);
            let step = (next, [image(a), image(b), image(leave), image(enter)]);
            if step == first {
                return Some(found);
            }
            if found.len() == most || found.iter().any(|&(known, _)| known == next) {
                return None;
            }
            found.push(step);
        }
    }

    fn three_to_two(&self, faces: &FaceClasses, edge: usize) -> Result<Option<GluingTable>, Error> {
        let Some(ring) = self.around(faces, edge, 3).filter(|ring| ring.len() == 3) else { return Ok(None) };
        let removed: Vec<usize> = ring.iter().map(|&(tetrahedron, _)| tetrahedron).collect();
        // The vertex across the facet that tetrahedron i leaves is the one that i + 1 enters across. New tetrahedra have an end of the edge as vertex
        // 0; vertex 1 + i is the one that tetrahedra i and i + 1 do not ... share with i + 2.
        let mut pairs = Vec::new();
        for (i, &(tetrahedron, [a, b, enter, leave])) in ring.iter().enumerate() {
            // In tetrahedron i the vertex beside the edge that tetrahedron i + 1 has too is `enter`: the facet across `leave` is left.
            let (own, next) = (1 + i, 1 + (i + 2) % 3);
            let across = 1 + (i + 1) % 3;
            pairs.push(((tetrahedron, [a, enter, leave, b]), (0, [0, own, next, across])));
            pairs.push(((tetrahedron, [b, enter, leave, a]), (1, [0, own, next, across])));
        }
        self.replaced(&removed, 2, &pairs, &[((0, [1, 2, 3, 0]), (1, [1, 2, 3, 0]))])
    }

    fn four_to_one(&self, faces: &FaceClasses, vertex: usize) -> Result<Option<GluingTable>, Error> {
        let count = faces.class_counts().first().copied().unwrap_or(0);
        if vertex >= count || faces.is_boundary(0, CellId::new(vertex)) {
            return Ok(None);
        }
        let corners: Vec<(usize, usize)> = (0..self.table.simplex_count())
            .flat_map(|tetrahedron| (0..CORNERS).map(move |corner| (tetrahedron, corner)))
            .filter(|&(tetrahedron, corner)| faces.of_face(tetrahedron, 1 << corner).0 == vertex)
            .collect();
        let removed: Vec<usize> = corners.iter().map(|&(tetrahedron, _)| tetrahedron).collect();
        if corners.len() != 4 || removed.windows(2).any(|pair| pair[0] == pair[1]) {
            return Ok(None);
        }
        // The names 0 to 3 of the outer vertices: the first tetrahedron has 1, 2, 3, and its neighbors 0 in the place of one of them.
        let (first, top) = corners[0];
        let base: Vec<usize> = (0..CORNERS).filter(|&corner| corner != top).collect();
        let mut pairs: Vec<(Facet, Facet)> =
            vec![((first, [base[0], base[1], base[2], top]), (0, [1, 2, 3, 0]))];
        for (i, &corner) in base.iter().enumerate() {
            let Some((next, images)) = self.table.neighbor(first, corner) else { return Ok(None) };
            let image = |vertex: usize| usize::from(images[vertex]);
            if !removed[1..].contains(&next) || pairs.iter().any(|&((known, _), _)| known == next) {
                return Ok(None);
            }
            let [j, k] = [(i + 1) % 3, (i + 2) % 3];
            // The corner across is the outer vertex 0; the facet across the top is the outer one.
            let facet = (next, [image(corner), image(base[j]), image(base[k]), image(top)]);
            pairs.push((facet, (0, [0, 1 + j, 1 + k, 1 + i])));
        }
        // The other tetrahedra are glued to each other along the facets at the top, or it is another ball.
        for (&((tetrahedron, corners), (_, names)), at) in pairs[1..].iter().zip(1..) {
            for place in 1..3 {
                let Some((next, images)) = self.table.neighbor(tetrahedron, corners[place]) else {
                    return Ok(None);
                };
                let Some(&((_, theirs), (_, their_names))) =
                    pairs[1..].iter().find(|&&((known, _), _)| known == next)
                else {
                    return Ok(None);
                };
                // Vertices with one name are one, and the top is the top.
                let name = |corner: usize| {
                    corners
                        .iter()
                        .position(|&own| own == corner)
                        .map(|at| if at == 3 { 4 } else { names[at] })
                };
                let their = |corner: usize| {
                    theirs
                        .iter()
                        .position(|&own| own == corner)
                        .map(|at| if at == 3 { 4 } else { their_names[at] })
                };
                let agree = (0..CORNERS)
                    .filter(|&corner| corner != corners[place])
                    .all(|corner| name(corner) == their(usize::from(images[corner])));
                if !agree || next == tetrahedron || at > 3 {
                    return Ok(None);
                }
            }
        }
        self.replaced(&removed, 1, &pairs, &[])
    }

    fn two_to_zero(&self, faces: &FaceClasses, edge: usize) -> Result<Option<GluingTable>, Error> {
        let Some(ring) = self.around(faces, edge, 2).filter(|ring| ring.len() == 2) else { return Ok(None) };
        let [(one, [a, b, c, d]), (two, [a2, b2, d2, c2])] = [ring[0], ring[1]];
        // The edges across the one that goes become one: they are different, and not both in the boundary.
        let across = |tetrahedron: usize, x: usize, y: usize| faces.of_face(tetrahedron, 1 << x | 1 << y).0;
        let (first, second) = (across(one, c, d), across(two, c2, d2));
        let is_outer = |edge: usize| faces.is_boundary(1, CellId::new(edge));
        if first == second || is_outer(first) && is_outer(second) {
            return Ok(None);
        }
        // Each outer facet of the first is glued to the one of the second with the same end of the edge.
        let mut pairs = Vec::new();
        for (own, other, gone, gone2) in [(a, a2, b, b2), (b, b2, a, a2)] {
            pairs.push(((one, [own, c, d, gone]), (two, [other, c2, d2, gone2])));
        }
        let triangle = |(tetrahedron, corners): Facet| {
            faces.of_face(tetrahedron, corners[..3].iter().fold(0, |set, &corner| set | 1 << corner)).0
        };
        let classes: Vec<[usize; 2]> = pairs.iter().map(|&(x, y)| [triangle(x), triangle(y)]).collect();
        let is_open = |class: usize| faces.is_boundary(2, CellId::new(class));
        // No facet becomes its own partner, and no ball between two pairs closes up to a space of its own.
        let is_closing = classes.iter().any(|&[x, y]| x == y || is_open(x) && is_open(y))
            || classes[0].iter().all(|class| classes[1].contains(class))
            || classes[0].iter().filter(|&&class| is_open(class)).count()
                + classes[1].iter().filter(|&&class| is_open(class)).count()
                > 1
                && classes[0].iter().any(|class| classes[1].contains(class));
        if is_closing {
            return Ok(None);
        }
        self.flattened(&[one, two], &pairs)
    }

    fn collapse(
        &self,
        faces: &FaceClasses,
        ideal: &[CellId],
        edge: usize,
    ) -> Result<Option<GluingTable>, Error> {
        let Some(ring) = self.around(faces, edge, self.table.simplex_count()) else { return Ok(None) };
        let class = |tetrahedron: usize, corners: &[usize]| {
            faces.of_face(tetrahedron, corners.iter().fold(0, |set, &corner| set | 1 << corner)).0
        };
        let (first, [a, b, ..]) = ring[0];
        let ends = [class(first, &[a]), class(first, &[b])];
        let is_outer = |degree: usize, class: usize| faces.is_boundary(degree, CellId::new(class));
        // Two components of the boundary, a cut ideal vertex among them, would become one.
        let ends_in_boundary =
            |&end: &usize| is_outer(0, end) || ideal.binary_search(&CellId::new(end)).is_ok();
        if ends[0] == ends[1] || ends.iter().all(ends_in_boundary) {
            return Ok(None);
        }
        // A triangle at the edge becomes an edge, a tetrahedron a triangle: its two other edges, and facets, become one.
        let edges: Vec<[usize; 2]> = ring
            .iter()
            .map(|&(tetrahedron, [a, b, enter, _])| {
                [class(tetrahedron, &[a, enter]), class(tetrahedron, &[b, enter])]
            })
            .collect();
        let triangles: Vec<[usize; 2]> = ring
            .iter()
            .map(|&(tetrahedron, [a, b, c, d])| {
                [class(tetrahedron, &[a, c, d]), class(tetrahedron, &[b, c, d])]
            })
            .collect();
        if edges.as_flattened().contains(&edge)
            || is_closing(&edges, |class| is_outer(1, class))
            || is_closing(&triangles, |class| is_outer(2, class))
        {
            return Ok(None);
        }
        let pairs: Vec<(Facet, Facet)> = ring
            .iter()
            .map(|&(tetrahedron, [a, b, c, d])| ((tetrahedron, [a, c, d, b]), (tetrahedron, [b, c, d, a])))
            .collect();
        let removed: Vec<usize> = ring.iter().map(|&(tetrahedron, _)| tetrahedron).collect();
        self.flattened(&removed, &pairs)
    }

    /// Where the vertices of a facet go that is to be glued anew: through pairs of removed facets until a facet that stays.
    fn outside(&self, removed: &[usize], pairs: &[(Facet, Facet)], from: Facet) -> Option<Option<Facet>> {
        let mut at = from;
        for _ in 0..=2 * pairs.len() {
            let Some((next, images)) = self.table.neighbor(at.0, at.1[3]) else { return Some(None) };
            let landed: Facet = (next, at.1.map(|vertex| usize::from(images[vertex])));
            if !removed.contains(&next) {
                return Some(Some(landed));
            }
            // On into the partner of that facet, vertex by vertex.
            let through = pairs.iter().flat_map(|&(x, y)| [(x, y), (y, x)]).find_map(|(x, y)| {
                if (x.0, x.1[3]) != (landed.0, landed.1[3]) {
                    return None;
                }
                let place = |vertex: usize| x.1.iter().position(|&own| own == vertex);
                let moved = landed.1.map(|vertex| place(vertex).map(|place| y.1[place]));
                let [a, b, c, d] = moved;
                Some((y.0, [a?, b?, c?, d?]))
            })?;
            at = through;
        }
        None
    }

    /// The table without these tetrahedra, their outer facets glued in pairs through which the space is flattened.
    fn flattened(&self, removed: &[usize], pairs: &[(Facet, Facet)]) -> Result<Option<GluingTable>, Error> {
        let (mut table, new_number) = self.without(removed, 0)?;
        for &(x, y) in pairs {
            let (Some(one), Some(two)) = (self.outside(removed, pairs, x), self.outside(removed, pairs, y))
            else {
                return Ok(None);
            };
            let (Some(one), Some(two)) = (one, two) else { continue };
            let mut images = [0; CORNERS];
            for (from, to) in one.1.into_iter().zip(two.1) {
                images[from] = to as u32;
            }
            if table.neighbor(new_number(one.0), one.1[3]).is_none() {
                if (one.0, one.1[3]) == (two.0, two.1[3]) {
                    return Ok(None);
                }
                table.glue(new_number(one.0), one.1[3], new_number(two.0), &images)?;
            }
        }
        Ok(Some(table))
    }

    /// The table with tetrahedra replaced: each outer facet of a removed one is a facet of a new one, vertex by vertex, and new ones are
    /// glued to each other inside.
    fn replaced(
        &self,
        removed: &[usize],
        added: usize,
        pairs: &[(Facet, Facet)],
        inner: &[(Facet, Facet)],
    ) -> Result<Option<GluingTable>, Error> {
        let (mut table, new_number) = self.without(removed, added)?;
        let base = self.table.simplex_count() - removed.len();
        let glue = |table: &mut GluingTable, (one, ours): Facet, (two, theirs): Facet| {
            let mut images = [0; CORNERS];
            for (from, to) in ours.into_iter().zip(theirs) {
                images[from] = to as u32;
            }
            table.glue(one, ours[3], two, &images)
        };
        for &((one, ours), (two, theirs)) in inner {
            glue(&mut table, (base + one, ours), (base + two, theirs))?;
        }
        for &((old, outer), (new, own)) in pairs {
            if table.neighbor(base + new, own[3]).is_some() {
                continue;
            }
            let Some((next, images)) = self.table.neighbor(old, outer[3]) else { continue };
            let landed = outer.map(|vertex| usize::from(images[vertex]));
            if !removed.contains(&next) {
                glue(&mut table, (base + new, own), (new_number(next), landed))?;
                continue;
            }
            // To another outer facet of what was removed.
            let Some(&((_, theirs), (other, names))) =
                pairs.iter().find(|&&((known, corners), _)| (known, corners[3]) == (next, landed[3]))
            else {
                return Ok(None);
            };
            let named =
                landed.map(|vertex| theirs.iter().position(|&own| own == vertex).map(|place| names[place]));
            let [Some(a), Some(b), Some(c), Some(d)] = named else { return Ok(None) };
            if (new, own[3]) == (other, d) {
                return Ok(None);
            }
            glue(&mut table, (base + new, own), (base + other, [a, b, c, d]))?;
        }
        Ok(Some(table))
    }

    /// The table of the tetrahedra that stay, with so many new ones behind them, and the new numbers.
    fn without<'a>(
        &self,
        removed: &'a [usize],
        added: usize,
    ) -> Result<(GluingTable, impl Fn(usize) -> usize + use<'a>), Error> {
        let new_number = move |old: usize| old - removed.iter().filter(|&&gone| gone < old).count();
        let mut table = GluingTable::unglued(3, self.table.simplex_count() - removed.len() + added)?;
        for tetrahedron in
            (0..self.table.simplex_count()).filter(|tetrahedron| !removed.contains(tetrahedron))
        {
            for facet in 0..CORNERS {
                let Some((next, images)) = self.table.neighbor(tetrahedron, facet) else { continue };
                if removed.contains(&next) || table.neighbor(new_number(tetrahedron), facet).is_some() {
                    continue;
                }
                let images: Vec<u32> = images.iter().map(|&image| u32::from(image)).collect();
                table.glue(new_number(tetrahedron), facet, new_number(next), &images)?;
            }
        }
        Ok((table, new_number))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::homology::homology;
    use proptest::prelude::*;

    /// A table with more vertices: tetrahedra are replaced by four each, around a new vertex.
    fn finer(table: &GluingTable, places: &[usize]) -> GluingTable {
        let mut table = table.clone();
        for place in places {
            let tetrahedron = place % table.simplex_count();
            let mut other = GluingTable::unglued(3, table.simplex_count() + 3).unwrap();
            // Facet k of the old one is facet k of part k; part 0 keeps the number.
            let last = table.simplex_count();
            let part = |facet: usize| if facet == 0 { tetrahedron } else { last + facet - 1 };
            let own = |at: usize, facet: usize| if at == tetrahedron { part(facet) } else { at };
            for at in 0..last {
                for facet in 0..4 {
                    let (next, images) = table.neighbor(at, facet).unwrap();
                    let across = usize::from(images[facet]);
                    if other.neighbor(own(at, facet), facet).is_none() {
                        let images: Vec<u32> = images.iter().map(|&image| u32::from(image)).collect();
                        other.glue(own(at, facet), facet, own(next, across), &images).unwrap();
                    }
                }
            }
            // Parts i and j are glued across each other's facets: in part i vertex i is the new one.
            for (i, j) in (0..4_usize).flat_map(|j| (0..j).map(move |i| (i, j))) {
                let mut images = [0, 1, 2, 3];
                images.swap(i, j);
                other.glue(part(i), j, part(j), &images).unwrap();
            }
            table = other;
        }
        table
    }

    proptest! {
        /// A collapse keeps the homology, and a manifold one; the vertices become fewer by one.
        #[test]
        fn collapses_keep_the_space(
            which in 0..4_usize,
            places in prop::collection::vec(0..1000_usize, 1..5),
            choices in prop::collection::vec(0..1000_usize, 12),
        ) {
            let signature = ["cMcabbgqw", "cMcabbjaj", "eLAkbccddemken", "gvLQQedfedffrwawrhh"][which];
            let mut table = finer(&GluingTable::from_isomorphism_signature(signature, 3).unwrap(), &places);
            let expected = homology(&table.faces().unwrap().chain_complex().unwrap());
            for choice in choices {
                let faces = table.faces().unwrap();
                let counts = faces.class_counts();
                let step = GluingMove::Collapse { edge: choice % counts[1] };
                let Some(next) = moved_with(&table, (&faces, &[]), step).unwrap() else { continue };
                let next_faces = next.faces().unwrap();
                prop_assert_eq!(next_faces.class_counts()[0] + 1, counts[0]);
                prop_assert_eq!(next.manifold_verdict(&next_faces).unwrap().to_bool(), Some(true));
                prop_assert_eq!(&homology(&next_faces.chain_complex().unwrap()), &expected);
                table = next;
            }
        }
    }

    /// Ideal vertices stay apart, and what is left without them keeps its homology.
    #[test]
    fn ideal_vertices_are_not_brought_together() {
        // A manifold with two cusps, gluings with two and three ideal vertices, and one with a boundary beside them.
        for signature in ["eLMkbcddddedde", "gLLAQbceefefmoamapn", "cPcbbbiht"] {
            for places in [&[][..], &[0, 3], &[1, 4, 2]] {
                let table = finer(&GluingTable::from_isomorphism_signature(signature, 3).unwrap(), places);
                let of = |table: &GluingTable| {
                    let faces = table.faces().unwrap();
                    let bounded = table.truncated(&faces).unwrap();
                    let groups = homology(&bounded.faces().unwrap().chain_complex().unwrap());
                    (table.ideal_vertices(&faces).unwrap().len(), groups)
                };
                let small = crate::three_manifolds::simplified(&table, 20).unwrap();
                assert_eq!(of(small.table()), of(&table), "{signature} {places:?}");
            }
        }
    }

    /// Of the two tetrahedra of a suspension the edge between the poles is none, and an edge with one end twice stays.
    #[test]
    fn what_would_close_up_does_not_collapse() {
        // A sphere of two tetrahedra, glued facet by facet: every edge has degree 2, and its collapse would close a triangle.
        let mut sphere = GluingTable::unglued(3, 2).unwrap();
        for facet in 0..4 {
            sphere.glue(0, facet, 1, &[0, 1, 2, 3]).unwrap();
        }
        let collapsed = |edge: usize| moved(&sphere, GluingMove::Collapse { edge }).unwrap();
        for edge in 0..6 {
            assert_eq!(collapsed(edge), None, "edge {edge}");
        }
        assert_eq!(collapsed(6), None);
        let lens = GluingTable::from_isomorphism_signature("cMcabbgqw", 3).unwrap();
        for edge in 0..lens.faces().unwrap().class_counts()[1] {
            assert_eq!(moved(&lens, GluingMove::Collapse { edge }).unwrap(), None);
        }
    }
}
