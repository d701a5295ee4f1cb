//! Orientation: the relative orientation of two simplices, and consistent orientations of all facets.
//!
//! An orientation of a simplex is an order of its vertices up to even permutations. Leaving out the vertex at position
//! i of $[v_0 \dots v_k]$ induces on that face the orientation $(-1)^i [v_0 \dots \hat v_i \dots v_k]$. Two k-simplices
//! with a common (k-1)-face **agree** when they induce opposite orientations on it: ijk agrees with jil, not with ijl.

use super::SimplicialComplex;
use crate::coherence::{Coherence, Obstruction, OddCycle};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, VertexId, narrow};
use coface_algebra::{Sign, SparseMatrix, UnionFind};
use std::collections::VecDeque;

/// The orientation of one oriented simplex relative to another, each given by an order of its vertices: plus when they
/// agree.
///
/// * The same vertices: plus for an even permutation.
/// * One vertex more on one side (a simplex and its facet, in any of the two orders): plus when the larger induces the
///   orientation of the smaller. So the edge ij agrees with j and disagrees with i.
/// * One vertex exchanged (a common facet): plus when the two induce opposite orientations on the common facet.
///
/// `None` when neither of these holds: the two are not comparable.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] if a vertex is repeated or a list is empty.
///
/// # Complexity
/// Quadratic in the number of vertices of one simplex.
///
/// # Examples
/// ```
/// use coface_algebra::Sign;
/// use coface_complexes::simplicial::relative_orientation;
/// let [i, j, k, l] = [0, 1, 2, 3].map(coface_algebra::VertexId::new);
/// assert_eq!(relative_orientation(&[i, j, k], &[j, k, i])?, Some(Sign::Plus));
/// assert_eq!(relative_orientation(&[i, j, k], &[j, i, l])?, Some(Sign::Plus));
/// assert_eq!(relative_orientation(&[i, j, k], &[i, j, l])?, Some(Sign::Minus));
/// assert_eq!(relative_orientation(&[i, j], &[i])?, Some(Sign::Minus));
/// assert_eq!(relative_orientation(&[i, j], &[k, l])?, None);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn relative_orientation(first: &[VertexId], second: &[VertexId]) -> Result<Option<Sign>, Error> {
    for simplex in [first, second] {
        if simplex.is_empty() {
            return Err(
                Error::invalid("an oriented simplex has no vertices").with_cure("give at least one vertex")
            );
        }
        if let Some((i, v)) = simplex.iter().enumerate().find(|&(i, v)| simplex[..i].contains(v)) {
            return Err(Error::invalid(format!(
                "the oriented simplex {simplex:?} repeats {v} at position {i}"
            )));
        }
    }
    let only = |of: &[VertexId], other: &[VertexId]| {
        let mut positions = (0..of.len()).filter(|&i| !other.contains(&of[i]));
        (positions.next(), positions.next().is_some())
    };
    let ((in_first, more_first), (in_second, more_second)) = (only(first, second), only(second, first));
    if more_first || more_second {
        return Ok(None);
    }
    let common = |of: &[VertexId], left_out: Option<usize>| -> Vec<VertexId> {
        of.iter().enumerate().filter(|&(i, _)| Some(i) != left_out).map(|(_, &v)| v).collect()
    };
    let permutation = permutation_sign(&common(first, in_first), &common(second, in_second));
    let induced = |left_out: Option<usize>| Sign::power_of_minus_one(left_out.unwrap_or(0));
    let product = permutation.times(induced(in_first)).times(induced(in_second));
    Ok(match (in_first, in_second) {
        // Opposite signs on the common facet agree; two vertices have no common facet.
        (Some(_), Some(_)) => (first.len() > 1).then(|| product.opposite()),
        _ => Some(product),
    })
}

/// The sign of the permutation that takes one order of the same things to the other.
fn permutation_sign(from: &[VertexId], to: &[VertexId]) -> Sign {
    let position = |v| to.iter().position(|&w| w == v).expect("both orders are of the same vertices");
    let images: Vec<usize> = from.iter().map(|&v| position(v)).collect();
    let inversions =
        (0..images.len()).map(|i| images[..i].iter().filter(|&&before| before > images[i]).count()).sum();
    Sign::power_of_minus_one(inversions)
}

impl OddCycle<CellId, CellId> {
    /// Whether the closure of an odd cycle of faces of this 2-complex is an embedded Moebius band: a surface of Euler
    /// characteristic 0 with one boundary circle. `None` for a complex of another dimension.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let band = known_spaces::triangle_strip(5)?;
    /// let found = band.orientability()?;
    /// let cycle = found.odd_cycle().expect("a Moebius band is not orientable");
    /// assert_eq!(cycle.is_embedded_moebius_band(&band.chain_complex()?), Some(true));
    /// # Ok(()) }
    /// ```
    pub fn is_embedded_moebius_band(&self, complex: &ChainComplex) -> Option<bool> {
        let (Some(2), Some(faces), Some(edges)) =
            (complex.dimension(), complex.boundary_matrix(2), complex.boundary_matrix(1))
        else {
            return None;
        };
        let band: Vec<u32> = self.cells.iter().map(|&cell| narrow(cell.index())).collect();
        Some(is_one_band(faces, edges, &band))
    }
}

impl SimplicialComplex {
    /// Whether the facets can be oriented consistently: with a sign for each facet relative to the rising order of its
    /// vertices, or with an odd cycle of facets as a witness.
    ///
    /// # Complexity
    /// Linear in the number of simplices, beyond the making of the chain complex.
    ///
    /// # Errors
    /// As the chain complex of the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let found = known_spaces::triangle_strip(5)?.orientability()?;
    /// assert_eq!(found.is_orientable(), Some(false));
    /// assert_eq!(found.odd_cycle().map(|cycle| cycle.cells().len()), Some(5));
    /// # Ok(()) }
    /// ```
    pub fn orientability(&self) -> Result<Coherence<CellId, CellId>, Error> {
        Ok(orientability(&self.chain_complex()?))
    }
}

/// Whether the cells of the top dimension of a regular cell complex can be oriented consistently. Each row of the last
/// boundary matrix that is in one column is boundary, each in two is to cancel; the entries are units. Cells and facets are
/// given by their places among the cells of their dimension; the lowest cell of each strongly connected component has the
/// sign plus. In an odd cycle two cells share a facet only when they are neighbors in it.
///
/// Breadth first over the facets from the lowest of each component. A neighbor met again with the wrong sign closes an
/// odd cycle through the tree, which is then cut short along every ridge that joins two of its facets.
///
/// # Complexity
/// Linear in the entries; the cut of an odd cycle is linear in its length for each facet it loses, at worst.
///
/// # Examples
/// The sphere as a complex with two cells in each dimension.
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// use coface_complexes::simplicial::orientability;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let sphere = ChainComplex::new(vec![
///     SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?,
///     SparseMatrix::from_entries(2, 2, [(0, 0, 1), (1, 0, -1), (0, 1, 1), (1, 1, -1)])?,
/// ])?;
/// assert_eq!(orientability(&sphere).is_orientable(), Some(true));
/// # Ok(()) }
/// ```
pub fn orientability(complex: &ChainComplex) -> Coherence<CellId, CellId> {
    let Some(dimension) = complex.dimension() else { return refused(Obstruction::NoFacets) };
    if let Some((dimension, cells)) = maximal_below_top(complex) {
        return refused(Obstruction::NotPure { dimension, cell: CellId::new(cells[0]) });
    }
    complex.boundary_matrix(dimension).map_or_else(|| refused(Obstruction::NoFacets), orient_columns)
}

/// The cells of the lowest dimension below the top in which some are a face of no other cell; none if the complex is pure.
pub(super) fn maximal_below_top(complex: &ChainComplex) -> Option<(usize, Vec<usize>)> {
    (0..complex.dimension()?).find_map(|degree| {
        let mut covered = vec![false; complex.cell_count(degree)];
        for &face in complex.boundary_matrix(degree + 1)?.rows() {
            covered[face as usize] = true;
        }
        let maximal: Vec<usize> = (0..covered.len()).filter(|&cell| !covered[cell]).collect();
        (!maximal.is_empty()).then_some((degree, maximal))
    })
}

/// Whether some faces of a 2-complex, known to be connected and not orientable, with edges in one or two of them, are a
/// surface with one boundary circle and Euler characteristic 0.
fn is_one_band(faces: &SparseMatrix, edges: &SparseMatrix, band: &[u32]) -> bool {
    let mut edges_of_band: Vec<u32> =
        band.iter().flat_map(|&f| faces.column(f as usize).rows()).copied().collect();
    edges_of_band.sort_unstable();
    let rim: Vec<u32> =
        edges_of_band.chunk_by(|a, b| a == b).filter(|e| e.len() == 1).map(|e| e[0]).collect();
    edges_of_band.dedup();
    let ends = |edge: u32| edges.column(edge as usize).rows();
    let mut vertices: Vec<u32> = edges_of_band.iter().flat_map(|&e| ends(e)).copied().collect();
    vertices.sort_unstable();
    vertices.dedup();
    if vertices.len() + band.len() != edges_of_band.len() {
        return false;
    }
    // With Euler characteristic 0 and no orientation, a surface with boundary is a band. It is a surface if each vertex
    // has one fan of faces: corners united over edges are as many classes as vertices.
    let mut corners: Vec<(u32, u32)> = Vec::new();
    for (i, &f) in band.iter().enumerate() {
        let of_face = faces.column(f as usize).rows().iter().flat_map(|&e| ends(e));
        corners.extend(of_face.map(|&v| (i as u32, v)));
    }
    corners.sort_unstable();
    corners.dedup();
    let mut fans = UnionFind::new(corners.len());
    let mut sides: Vec<(u32, u32)> = Vec::new();
    for (i, &f) in band.iter().enumerate() {
        sides.extend(faces.column(f as usize).rows().iter().map(|&e| (e, i as u32)));
    }
    sides.sort_unstable();
    for pair in sides.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        for &v in ends(pair[0].0) {
            let corner =
                |face| corners.binary_search(&(face, v)).expect("an end of an edge is a corner of its face");
            fans.unite(corner(pair[0].1) as u32, corner(pair[1].1) as u32);
        }
    }
    // The rim is one circle: as many vertices as edges, hanging together.
    let mut rim_vertices: Vec<u32> = rim.iter().flat_map(|&e| ends(e)).copied().collect();
    rim_vertices.sort_unstable();
    rim_vertices.dedup();
    let mut circles = UnionFind::new(rim_vertices.len());
    let place = |v: u32| rim_vertices.binary_search(&v).expect("ends of rim edges are rim vertices") as u32;
    for &e in &rim {
        if let &[a, b] = ends(e) {
            circles.unite(place(a), place(b));
        }
    }
    fans.class_count() == vertices.len() && rim_vertices.len() == rim.len() && circles.class_count() == 1
}

/// Orients the columns of a boundary matrix so that every row in two of them is cancelled.
fn orient_columns(boundary: &SparseMatrix) -> Coherence<CellId, CellId> {
    let cofaces = boundary.transpose();
    if let Some(ridge) = cofaces.columns().position(|facets| facets.rows().len() > 2) {
        let cells = cofaces.column(ridge).rows().iter().map(|&f| CellId::from_u32(f)).collect();
        return refused(Obstruction::CrowdedFacet { facet: CellId::new(ridge), cells });
    }
    let conflicting =
        |&ridge: &usize| matches!(cofaces.column(ridge).entries(), [a, b] if a.signum() == b.signum());
    let conflicts = (0..cofaces.column_count()).filter(conflicting).map(CellId::new).collect();
    let count = boundary.column_count();
    let mut search =
        Search { boundary, cofaces: &cofaces, signs: vec![None; count], parents: vec![None; count] };
    let mut found = Coherence { obstruction: None, conflicts, signs: Vec::new(), odd_cycle: None };
    for root in 0..narrow(count) {
        if search.signs[root as usize].is_none()
            && let Err(closing) = search.component(root)
        {
            found.odd_cycle = Some(search.odd_cycle(closing));
            return found;
        }
    }
    found.signs = search.signs.into_iter().map(|sign| sign.expect("every facet was met")).collect();
    found
}

/// The result where the question has no answer.
fn refused(obstruction: Obstruction<CellId, CellId>) -> Coherence<CellId, CellId> {
    Coherence { obstruction: Some(obstruction), conflicts: Vec::new(), signs: Vec::new(), odd_cycle: None }
}

/// A step over a ridge from one facet to another.
#[derive(Clone, Copy)]
struct Step {
    from: u32,
    ridge: u32,
    to: u32,
}

struct Search<'a> {
    boundary: &'a SparseMatrix,
    cofaces: &'a SparseMatrix,
    /// The sign of each facet that was met.
    signs: Vec<Option<Sign>>,
    /// For each facet met but the roots: the facet and the ridge it was met over.
    parents: Vec<Option<(u32, u32)>>,
}

impl Search<'_> {
    /// The facet beyond a ridge and whether crossing keeps the sign.
    fn across(&self, facet: u32, ridge: u32) -> Option<(u32, Sign)> {
        let column = self.cofaces.column(ridge as usize);
        let &[a, b] = column.rows() else { return None };
        let product = Sign::power_of_minus_one(usize::from(
            column.entries()[0].signum() == column.entries()[1].signum(),
        ));
        Some((if a == facet { b } else { a }, product))
    }

    fn component(&mut self, root: u32) -> Result<(), Step> {
        self.signs[root as usize] = Some(Sign::Plus);
        let mut queue = VecDeque::from([(root, Sign::Plus)]);
        while let Some((facet, here)) = queue.pop_front() {
            for &ridge in self.boundary.column(facet as usize).rows() {
                let Some((other, crossing)) = self.across(facet, ridge) else { continue };
                let sign = here.times(crossing);
                match self.signs[other as usize] {
                    None => {
                        self.signs[other as usize] = Some(sign);
                        self.parents[other as usize] = Some((facet, ridge));
                        queue.push_back((other, sign));
                    }
                    Some(known) if known != sign => return Err(Step { from: facet, ridge, to: other }),
                    Some(_) => {}
                }
            }
        }
        Ok(())
    }

    /// The tree path between the two ends of a closing step, closed by it, made chordless.
    fn odd_cycle(&self, closing: Step) -> OddCycle<CellId, CellId> {
        let to_root = |mut facet: u32| {
            // Each facet with the ridge to the next one; the root has none.
            let mut path = Vec::new();
            while let Some((parent, ridge)) = self.parents[facet as usize] {
                path.push((facet, ridge));
                facet = parent;
            }
            (path, facet)
        };
        let ((mut up, mut meeting), (mut down, _)) = (to_root(closing.to), to_root(closing.from));
        while let (Some(&(a, _)), Some(&(b, _))) = (up.last(), down.last())
            && a == b
        {
            meeting = a;
            up.pop();
            down.pop();
        }
        // closing.to ... meeting, then down from the meeting to closing.from; each entry holds the ridge to the next.
        let mut facets: Vec<u32> = up.iter().map(|&(facet, _)| facet).collect();
        let mut ridges: Vec<u32> = up.iter().map(|&(_, ridge)| ridge).collect();
        facets.push(meeting);
        for &(facet, ridge) in down.iter().rev() {
            ridges.push(ridge);
            facets.push(facet);
        }
        ridges.push(closing.ridge);
        self.without_chords(facets, ridges)
    }

    /// Cuts an odd cycle along ridges between facets that are no neighbors in it, and keeps the odd part.
    fn without_chords(&self, mut facets: Vec<u32>, mut ridges: Vec<u32>) -> OddCycle<CellId, CellId> {
        'cut: loop {
            let n = facets.len();
            let mut places: Vec<(u32, usize)> = facets.iter().enumerate().map(|(i, &f)| (f, i)).collect();
            places.sort_unstable();
            for i in 0..n {
                for &ridge in self.boundary.column(facets[i] as usize).rows() {
                    if ridge == ridges[i] || ridge == ridges[(i + n - 1) % n] {
                        continue;
                    }
                    let Some((other, _)) = self.across(facets[i], ridge) else { continue };
                    let Ok(found) = places.binary_search_by_key(&other, |&(f, _)| f) else { continue };
                    let j = places[found].1;
                    let (low, high) = (i.min(j), i.max(j));
                    // low ... high closed by the chord, or the rest closed by it.
                    let inner_ridges: Vec<u32> = ridges[low..high].iter().copied().chain([ridge]).collect();
                    let inner_facets = facets[low..=high].to_vec();
                    (facets, ridges) = if self.is_odd(&inner_facets, &inner_ridges) {
                        (inner_facets, inner_ridges)
                    } else {
                        (
                            facets[..=low].iter().chain(&facets[high..]).copied().collect(),
                            ridges[..low]
                                .iter()
                                .copied()
                                .chain([ridge])
                                .chain(ridges[high..].iter().copied())
                                .collect(),
                        )
                    };
                    continue 'cut;
                }
            }
            let ids = |numbers: Vec<u32>| numbers.into_iter().map(CellId::from_u32).collect();
            return OddCycle { cells: ids(facets), facets: ids(ridges) };
        }
    }

    fn is_odd(&self, facets: &[u32], ridges: &[u32]) -> bool {
        let crossing = |(&facet, &ridge): (&u32, &u32)| {
            self.across(facet, ridge).map_or(Sign::Plus, |(_, crossing)| crossing)
        };
        facets.iter().zip(ridges).map(crossing).fold(Sign::Plus, Sign::times) == Sign::Minus
    }
}

#[cfg(test)]
mod tests {
    use super::super::Simplex;
    use super::*;
    use crate::known_spaces;
    use proptest::prelude::*;

    fn order(numbers: &[u32]) -> Vec<VertexId> {
        numbers.iter().map(|&v| VertexId::from_u32(v)).collect()
    }

    fn relative(a: &[u32], b: &[u32]) -> Option<Sign> {
        relative_orientation(&order(a), &order(b)).unwrap()
    }

    #[test]
    fn conventions_of_the_source() {
        assert_eq!(relative(&[0, 1, 2], &[1, 0, 3]), Some(Sign::Plus));
        assert_eq!(relative(&[0, 1, 2], &[0, 1, 3]), Some(Sign::Minus));
        assert_eq!(relative(&[0, 1], &[1, 2]), Some(Sign::Plus));
        assert_eq!(relative(&[0, 1], &[2, 1]), Some(Sign::Minus));
        // The edge ij agrees with j and disagrees with i.
        assert_eq!(relative(&[0, 1], &[1]), Some(Sign::Plus));
        assert_eq!(relative(&[0], &[0, 1]), Some(Sign::Minus));
        assert_eq!(relative(&[4], &[4]), Some(Sign::Plus));
        assert_eq!(relative(&[4], &[5]), None);
        assert_eq!(relative(&[0, 1, 2], &[0, 3, 4]), None);
        assert_eq!(relative(&[0, 1, 2, 3], &[0, 1]), None);
        assert!(relative_orientation(&order(&[1, 1]), &order(&[1, 2])).is_err());
        assert!(relative_orientation(&[], &order(&[1])).is_err());
    }

    proptest! {
        #[test]
        fn relative_orientation_agrees_with_incidences(
            first in Just(vec![0u32, 1, 2, 3]).prop_shuffle(),
            second in Just(vec![0u32, 1, 2, 4]).prop_shuffle(),
        ) {
            // The sign that an order induces on the rising order of the face {0, 1, 2}.
            let induced = |list: &[u32]| {
                let simplex = Simplex::from_numbers(list).unwrap();
                simplex.sign_of(list).unwrap().times(simplex.incidence(&Simplex::from([0, 1, 2])).unwrap())
            };
            let agree = induced(&first) != induced(&second);
            prop_assert_eq!(relative(&first, &second) == Some(Sign::Plus), agree);
            prop_assert_eq!(relative(&first, &second), relative(&second, &first));
            let mut reversed = first.clone();
            reversed.swap(0, 1);
            prop_assert_eq!(relative(&reversed, &second), relative(&first, &second).map(Sign::opposite));
            prop_assert_eq!(relative(&first, &[0, 1, 2]), Some(induced(&first)));
            prop_assert_eq!(relative(&reversed, &first), Some(Sign::Minus));
        }

        /// Strips of triangles with random gluings: the search agrees with trying all signs.
        #[test]
        fn the_search_agrees_with_trying_all_signs(
            facets in prop::collection::btree_set(prop::collection::btree_set(0u32..6, 3..=3), 1..10)
        ) {
            let facets: Vec<Vec<u32>> = facets.into_iter().map(|f| f.into_iter().collect()).collect();
            let complex = SimplicialComplex::from_facets(&facets).unwrap();
            let chains = complex.chain_complex().unwrap();
            let matrix = chains.boundary_matrix(2).unwrap();
            let rows = matrix.transpose();
            let sums = |signs: &dyn Fn(usize) -> i32| {
                rows.columns().all(|row| row.rows().len() < 2 || row.iter().map(|(f, x)| signs(f) * x).sum::<i32>() == 0)
            };
            let found = complex.orientability().unwrap();
            match (found.obstruction(), found.odd_cycle()) {
                (None, None) => {
                    prop_assert!(sums(&|f| found.sign(CellId::new(f)).to_i32()));
                    let as_listed = found.is_coherent() == Some(true);
                    prop_assert_eq!(as_listed, sums(&|_| 1));
                    prop_assert_eq!(as_listed, (0..facets.len()).all(|f| found.sign(CellId::new(f)) == Sign::Plus));
                }
                (None, Some(cycle)) => {
                    let sign = |mask: u32, f: usize| Sign::power_of_minus_one((mask >> f & 1) as usize).to_i32();
                    let none_works = (0u32..1 << facets.len()).all(|mask| !sums(&|f| sign(mask, f)));
                    prop_assert!(none_works);
                    check_cycle(matrix, cycle);
                }
                (Some(Obstruction::CrowdedFacet { facet, cells }), None) => {
                    prop_assert_eq!(rows.column(facet.index()).rows().len(), cells.len());
                    prop_assert!(cells.len() > 2);
                }
                other => prop_assert!(false, "{other:?}"),
            }
        }
    }

    /// A closed chain of different facets that is odd and has no chords.
    fn check_cycle(matrix: &SparseMatrix, cycle: &OddCycle<CellId, CellId>) {
        let (cells, facets) = (cycle.cells(), cycle.facets());
        let n = cells.len();
        assert_eq!(n, facets.len());
        let mut product = 1;
        for i in 0..n {
            let (here, next, ridge) = (cells[i], cells[(i + 1) % n], facets[i].index());
            let signs = [here, next].map(|f| matrix.entry(ridge, f.index()));
            assert!(here != next && signs.iter().all(|&s| s != 0));
            product *= -signs[0] * signs[1];
            for (j, far) in cells.iter().enumerate().skip(i + 2) {
                if (i, j) != (0, n - 1) {
                    let other = matrix.column(far.index());
                    assert!(matrix.column(here.index()).rows().iter().all(|r| !other.rows().contains(r)));
                }
            }
        }
        assert_eq!(product, -1);
    }

    #[test]
    fn odd_cycles_of_surfaces_are_short() {
        for (surface, longest) in [
            (known_spaces::triangle_strip(5).unwrap(), 5),
            (known_spaces::triangle_strip(31).unwrap(), 31),
            (known_spaces::projective_plane().unwrap(), 9),
            (known_spaces::klein_grid(30, 8).unwrap(), 70),
        ] {
            let (found, chains) = (surface.orientability().unwrap(), surface.chain_complex().unwrap());
            let cycle = found.odd_cycle().expect("one-sided");
            check_cycle(chains.boundary_matrix(2).unwrap(), cycle);
            assert!(cycle.cells().len() <= longest, "{}", cycle.cells().len());
            assert!(cycle.is_embedded_moebius_band(&chains).is_some());
        }
    }

    #[test]
    fn questions_without_sense() {
        let complex = |facets: &[&[u32]]| {
            SimplicialComplex::from_facets(facets)
                .unwrap()
                .orientability()
                .unwrap()
                .obstruction()
                .cloned()
                .unwrap()
        };
        assert_eq!(complex(&[]), Obstruction::NoFacets);
        assert_eq!(complex(&[&[0], &[1]]), Obstruction::NoFacets);
        assert_eq!(
            complex(&[&[0, 1, 2], &[2, 3]]),
            Obstruction::NotPure { dimension: 1, cell: CellId::new(3) }
        );
        let book = complex(&[&[0, 1, 2], &[0, 1, 3], &[0, 1, 4]]);
        let (facet, cells) = (CellId::new(0), [0, 1, 2].map(CellId::new).to_vec());
        assert_eq!(book, Obstruction::CrowdedFacet { facet, cells });
    }
}
