//! Layered solid tori: tetrahedra layered one on the other, around a Moebius band of one triangle.
//!
//! A torus of two triangles has labels 0, 1, 2 at the corners of both, such that edge ij of one is edge ij of the other, turned by half a
//! turn: seen as a parallelogram, the corners of the first are A, D, B and those of the second C, B, D. A tetrahedron is **layered** on edge ij
//! when two of its facets are the two triangles and meet in that edge; its two other facets are a torus again. Inside the innermost
//! tetrahedron both facets are glued by a **fold** along an edge: it fixes the corner across and exchanges the ends of the edge.
//!
//! Source: W. Jaco, J. H. Rubinstein, *Layered-triangulations of 3-manifolds* (2006).

use coface_complexes::gluing::GluingTable;

/// A vector in the homology of a torus, by edges 01 and 02 of its first triangle.
pub(super) type Slope = [i64; 2];

/// A facet of a tetrahedron with labels 0, 1, 2 at its corners; label 3 is the vertex across.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Corners {
    pub(super) tetrahedron: usize,
    pub(super) labels: [u8; 4],
}

impl Corners {
    /// The same corners in the tetrahedron on the other side.
    pub(super) fn partner(&self, table: &GluingTable) -> Option<Self> {
        let (tetrahedron, images) = table.neighbor(self.tetrahedron, usize::from(self.labels[3]))?;
        Some(Self { tetrahedron, labels: self.labels.map(|label| images[usize::from(label)]) })
    }

    /// Whether the two are one facet.
    pub(super) fn is_facet_of(&self, other: &Self) -> bool {
        (self.tetrahedron, self.labels[3]) == (other.tetrahedron, other.labels[3])
    }
}

/// A torus of two triangles, seen in the tetrahedra on one of its sides.
pub(super) type Torus = [Corners; 2];

/// A layered solid torus.
#[derive(Clone, Debug)]
pub(super) struct SolidTorus {
    /// Its boundary, seen from inside.
    pub(super) boundary: Torus,
    /// The boundary of its meridian disk.
    pub(super) meridian: Slope,
    /// Its tetrahedra, the outermost first.
    pub(super) tetrahedra: Vec<usize>,
}

/// The labels i, j of the edge in which the two triangles of a torus meet in one tetrahedron, and the third label.
pub(super) fn layered_edge(torus: &Torus) -> Option<[usize; 3]> {
    let [one, two] = torus;
    if one.tetrahedron != two.tetrahedron || one.labels[3] == two.labels[3] {
        return None;
    }
    let fits = |&[i, j, k]: &[usize; 3]| {
        one.labels[i] == two.labels[j]
            && one.labels[j] == two.labels[i]
            && one.labels[3] == two.labels[k]
            && two.labels[3] == one.labels[k]
    };
    [[1, 2, 0], [0, 2, 1], [0, 1, 2]].into_iter().find(fits)
}

/// The two other facets of a tetrahedron that is layered on edge ij, as a torus.
pub(super) fn across(torus: &Torus, [i, j, k]: [usize; 3]) -> Torus {
    let [one, two] = torus;
    let (a, b) = (one.labels, two.labels);
    let corners = |labels: [u8; 4]| Corners { tetrahedron: one.tetrahedron, labels };
    [corners([a[i], a[k], b[k], a[j]]), corners([a[j], b[k], a[k], a[i]])]
}

/// The edge labels i, j of the fold that glues the two triangles of a torus to each other, and the third label.
pub(super) fn fold(table: &GluingTable, torus: &Torus) -> Option<[usize; 3]> {
    let image = torus[0].partner(table)?;
    if !image.is_facet_of(&torus[1]) {
        return None;
    }
    let goes = |from: usize, to: usize| image.labels[from] == torus[1].labels[to];
    [[1, 2, 0], [0, 2, 1], [0, 1, 2]].into_iter().find(|&[i, j, k]| goes(i, j) && goes(j, i) && goes(k, k))
}

/// The vector from corner i to corner j, where the first edges are given.
pub(super) fn step(edges: &[Slope; 2], i: usize, j: usize) -> Slope {
    let place = |corner: usize| if corner == 0 { [0, 0] } else { edges[corner - 1] };
    let (from, to) = (place(i), place(j));
    [to[0] - from[0], to[1] - from[1]]
}

/// What a fold along edge ij makes zero: the side from k to i goes to that from k to j of the other triangle, which is turned.
pub(super) fn folded_slope(edges: &[Slope; 2], [i, j, k]: [usize; 3]) -> Slope {
    let (one, two) = (step(edges, k, i), step(edges, k, j));
    [one[0] + two[0], one[1] + two[1]]
}

impl SolidTorus {
    /// The layered solid torus inside of this torus, if there is one.
    pub(super) fn inside(table: &GluingTable, boundary: Torus) -> Option<Self> {
        let mut torus = boundary;
        let mut edges = [[1, 0], [0, 1]];
        let mut tetrahedra = Vec::new();
        loop {
            let own = torus[0].tetrahedron;
            let edge @ [i, j, k] = layered_edge(&torus)?;
            if tetrahedra.contains(&own) {
                return None;
            }
            tetrahedra.push(own);
            let inner = across(&torus, edge);
            edges = [step(&edges, i, k), step(&edges, k, j)];
            if let Some(edge) = fold(table, &inner) {
                // A fold along the edge in which the facets meet makes no torus.
                if edge[2] == 0 {
                    return None;
                }
                return Some(Self { boundary, meridian: folded_slope(&edges, edge), tetrahedra });
            }
            torus = [inner[0].partner(table)?, inner[1].partner(table)?];
        }
    }

    /// The layered solid tori of a table that cannot be continued outwards, none twice.
    pub(super) fn maximal(table: &GluingTable) -> Vec<Self> {
        let mut found: Vec<Self> = Vec::new();
        for tetrahedron in 0..table.simplex_count() {
            for (a, b) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
                if found.iter().any(|torus| torus.tetrahedra.contains(&tetrahedron)) {
                    continue;
                }
                let [c, d] = others(a, b);
                // Facets a and b are glued to each other; the boundary is facets c and d.
                let corners = |labels| Corners { tetrahedron, labels };
                let boundary = [corners([c, a, b, d]), corners([d, b, a, c])];
                found.extend(
                    Self::inside(table, boundary)
                        .filter(|torus| torus.tetrahedra.len() == 1)
                        .map(|torus| torus.continued(table)),
                );
            }
        }
        found
    }

    /// With all tetrahedra that are layered on it.
    fn continued(mut self, table: &GluingTable) -> Self {
        while let [Some(one), Some(two)] = self.boundary.map(|corners| corners.partner(table)) {
            let front = [one, two];
            let Some(edge) = layered_edge(&front) else { break };
            if self.tetrahedra.contains(&one.tetrahedron) {
                break;
            }
            let Some(longer) = Self::inside(table, across(&front, edge)) else { break };
            self = longer;
        }
        self
    }
}

/// The two vertices beside a and b.
fn others(a: u8, b: u8) -> [u8; 2] {
    let mut left = (0..4).filter(|&vertex| vertex != a && vertex != b);
    [left.next().unwrap_or(0), left.next().unwrap_or(0)]
}

/// The numbers p and q of the lens space that a closed layered triangulation is, p = 0 for a bundle of spheres: its two solid tori have
/// meridians m and $p\, l + q\, m$, where l meets m once.
pub(super) fn lens(table: &GluingTable) -> Option<(u64, u64)> {
    let torus = SolidTorus::maximal(table)
        .into_iter()
        .find(|torus| torus.tetrahedra.len() == table.simplex_count())?;
    let edge = fold(table, &torus.boundary)?;
    lens_of(torus.meridian, folded_slope(&[[1, 0], [0, 1]], edge))
}

/// The lens space of two solid tori with these meridians.
fn lens_of(one: Slope, two: Slope) -> Option<(u64, u64)> {
    // A slope that meets the first once.
    let (gcd, x, y) = bezout(one[0], one[1]);
    if gcd != 1 {
        return None;
    }
    let longitude = [-y, x];
    let p = one[0] * two[1] - one[1] * two[0];
    // two = p longitude + q one.
    let rest = [two[0] - p * longitude[0], two[1] - p * longitude[1]];
    let q = if one[0] != 0 { rest[0] / one[0] } else { rest[1] / one[1] };
    Some(normal(p.unsigned_abs(), q))
}

/// The least q of the same lens space, orientations aside: q is as good as -q and their inverses modulo p.
pub(super) fn normal(p: u64, q: i64) -> (u64, u64) {
    if p < 2 {
        return (p, 1 - p);
    }
    let modulus = i64::try_from(p).unwrap_or(i64::MAX);
    let inverse = bezout(q.rem_euclid(modulus), modulus).1;
    let all = [q, -q, inverse, -inverse].map(|q| q.rem_euclid(modulus).unsigned_abs());
    (p, all.into_iter().min().unwrap_or(0))
}

/// The greatest common divisor of a and b, at least 0, and x, y with $x a + y b$ equal to it.
pub(super) fn bezout(a: i64, b: i64) -> (i64, i64, i64) {
    let (mut one, mut two) = ((a, 1, 0), (b, 0, 1));
    while two.0 != 0 {
        let times = one.0.div_euclid(two.0);
        (one, two) = (two, (one.0 - times * two.0, one.1 - times * two.1, one.2 - times * two.2));
    }
    if one.0 < 0 { (-one.0, -one.1, -one.2) } else { one }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(signature: &str) -> Option<(u64, u64)> {
        lens(&GluingTable::from_isomorphism_signature(signature, 3).unwrap())
    }

    /// Names of Regina's census.
    #[test]
    fn layered_lens_spaces_have_their_numbers() {
        for (signature, p, q) in [
            ("bkaagb", 1, 0),
            ("bkaagj", 1, 0),
            ("bkaajj", 4, 1),
            ("bkaajn", 5, 2),
            ("cMcabbgaj", 3, 1),
            ("cMcabbgqw", 2, 1),
            ("cMcabbjak", 3, 1),
            ("cMcabbjxr", 5, 1),
        ] {
            if let Some(found) = found(signature) {
                assert_eq!(found, (p, q), "{signature}");
            }
        }
        assert!(found("bkaajn").is_some());
    }
}
