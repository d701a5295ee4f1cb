//! Shortest bases of the first homology over Z/2.

use super::bits::Bits;
use super::cut_vertices::cut_vertices;
use super::root_search::{RootSearch, without_tail};
use super::shortest_paths::checked_lengths;
use super::{ClosedWalk, ShortestCycle, SurfaceHomology, TreeCotree};
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_complexes::surface::GeneralizedMap;

/// Closed walks whose classes are a basis of the first homology over Z/2 and whose lengths have the least sum.
///
/// At each vertex the loops of the edges that a tree of shortest paths and a cotree of longest loops leave over are
/// candidates; of all of them the shortest independent ones are kept, distinguished by the classes of edges. On an
/// orientable surface, closed or not, and on every surface with boundary they need not be a basis over Z. `lengths` has
/// a length for each edge; without it, each edge has the length 1. Searches may reach `most` vertices in all, each
/// counted as often as it is reached; they start from the vertices of a short graph that leaves a disk of each component, and go only as far
/// as half the length of the longest loop of the basis known.
///
/// # Errors
/// [`ErrorKind::Shape`] and [`ErrorKind::InvalidInput`] for lengths that are not one for each edge, finite and not
/// negative; [`ErrorKind::TooLarge`] when more vertices than `most` are reached.
///
/// # Complexity
/// $O(m (n \log n + k^3))$ for n edges, k loops and m vertices on the graph.
///
/// # References
/// J. Erickson, K. Whittlesey, *Greedy optimal homotopy and homology generators* (2005); O. Busaryev, S. Cabello, C.
/// Chen, T. K. Dey, Y. Wang, *Annotating simplices with a homology basis and its applications* (2012).
///
/// # Examples
/// On a torus of 4 by 6 squares, each cut in two, the shortest loops have 4 and 6 edges.
/// ```
/// use coface_complexes::known_spaces;
/// use coface_complexes::surface::GeneralizedMap;
/// use coface_topology::shortest_homology_basis;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(known_spaces::torus_grid(&[4, 6])?.freeze().two_skeleton()?)?;
/// let basis = shortest_homology_basis(&torus, None, 10_000)?;
/// assert_eq!(basis.iter().map(|cycle| cycle.length()).collect::<Vec<_>>(), [4.0, 6.0]);
/// # Ok(()) }
/// ```
pub fn shortest_homology_basis(
    map: &GeneralizedMap,
    lengths: Option<&[f64]>,
    most: usize,
) -> Result<Vec<ShortestCycle>, Error> {
    let lengths = checked_lengths(map, lengths)?;
    let trees = TreeCotree::new(map);
    let homology = SurfaceHomology::new(map, &trees);
    let mut basis: Vec<BasisOfComponent> = Vec::new();
    let mut first = 0;
    for component in trees.components() {
        let count = component.generators().len();
        let edges = component.generators().iter().enumerate();
        let loops = edges.map(|(i, &edge)| {
            let steps = trees.simple_loop(map, edge);
            let length = steps.iter().map(|step| lengths[(step >> 1) as usize]).sum();
            Member { steps, length, row: Bits::unit(count, i) }
        });
        basis.push(BasisOfComponent { first, members: loops.collect() });
        first += count;
    }
    let mut search = RootSearch::new(map, &lengths);
    let mut classes: Vec<Bits> = vec![Bits::default(); map.skeleton().vertex_count()];
    let ends = map.skeleton().edge_ends();
    let mut reached = 0usize;
    // A cycle of a shortest basis cannot be contracted, and its class is a sum of loops at any vertex of it which are not longer.
    let roots = cut_vertices(map, &lengths);
    let steps = stage("searching for a shortest basis", roots.len());
    for root in roots {
        steps.advance(1);
        let Some(component) = trees.component_of_vertex(VertexId::from_u32(root)) else { continue };
        let basis = &mut basis[component];
        let (first, count) = (basis.first, basis.members.len());
        let Some(bound) = basis.members.iter().map(|member| member.length).max_by(f64::total_cmp) else {
            continue;
        };
        search.run(root, bound / 2.0);
        reached += search.reached().len();
        if reached > most {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("the search for a shortest basis reaches more than {most} vertices"),
            )
            .with_cure("raise the limit, take the shortest loops at one vertex, or coarsen the surface"));
        }
        let candidates = search.local_dual(bound).leftover();
        if candidates.is_empty() {
            continue;
        }
        let add_edge = |class: &mut Bits, edge: u32| {
            for generator in homology.odd_crossings(edge) {
                class.flip(generator as usize - first);
            }
        };
        // The classes of the paths from the root, modulo 2.
        for &vertex in search.reached() {
            let mut class = match search.step_to(vertex) {
                None => Bits::zero(count),
                Some(step) => {
                    let mut class = classes[ends[step as usize] as usize].clone();
                    add_edge(&mut class, step >> 1);
                    class
                }
            };
            std::mem::swap(&mut classes[vertex as usize], &mut class);
        }
        for closing in candidates {
            let mut class = classes[ends[2 * closing.edge as usize] as usize].clone();
            class.add(&classes[ends[2 * closing.edge as usize + 1] as usize]);
            add_edge(&mut class, closing.edge);
            if let Some(place) = exchange(&basis.members, &class, closing.length) {
                basis.replace(place, &class, search.loop_through(closing.edge), closing.length);
            }
        }
    }
    let mut found = Vec::new();
    for member in basis.into_iter().flat_map(|basis| basis.members) {
        let walk = ClosedWalk::new(map.skeleton(), without_tail(member.steps))?;
        found.push(ShortestCycle::new(walk, &lengths));
    }
    found.sort_by(|a, b| a.length().total_cmp(&b.length()));
    Ok(found)
}

/// The member of a basis that a class can take the place of, longest first, if that is longer than it.
fn exchange(members: &[Member], class: &Bits, length: f64) -> Option<usize> {
    let places = (0..members.len()).filter(|&i| members[i].row.is_odd_on(class));
    let place = places.max_by(|&i, &j| members[i].length.total_cmp(&members[j].length))?;
    (members[place].length > length).then_some(place)
}

struct BasisOfComponent {
    /// The number of the first generator of the component.
    first: usize,
    members: Vec<Member>,
}

/// A loop of the basis, and the row that says of a class, in generators, whether this loop is in it.
struct Member {
    steps: Vec<u32>,
    length: f64,
    row: Bits,
}

impl BasisOfComponent {
    fn replace(&mut self, place: usize, class: &Bits, steps: Vec<u32>, length: f64) {
        let pivot = self.members[place].row.clone();
        for (i, member) in self.members.iter_mut().enumerate() {
            if i != place && member.row.is_odd_on(class) {
                member.row.add(&pivot);
            }
        }
        self.members[place].steps = steps;
        self.members[place].length = length;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_complexes::known_spaces;
    use coface_complexes::surface::samples::{all_kinds, genus, map_of, of_next, with_holes};
    use proptest::prelude::*;

    /// The shortest basis among the loops of all edges at all roots, and of all pairs of paths: greedy, by elimination.
    fn brute_force(map: &GeneralizedMap, lengths: &[f64]) -> Vec<f64> {
        let trees = TreeCotree::new(map);
        let homology = SurfaceHomology::new(map, &trees);
        let count = homology.generators().len();
        let mut candidates = Vec::new();
        let mut search = RootSearch::new(map, lengths);
        for root in 0..map.skeleton().vertex_count() as u32 {
            search.run(root, f64::INFINITY);
            for (closing, _) in search.local_dual(f64::INFINITY).arcs {
                let walk = ClosedWalk::new(map.skeleton(), search.loop_through(closing.edge)).unwrap();
                candidates.push((closing.length, homology.class_of_walk(&walk).unwrap()));
            }
        }
        candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut rows: Vec<(usize, Vec<bool>)> = Vec::new();
        let mut lengths = Vec::new();
        for (length, class) in candidates {
            let mut row: Vec<bool> = class.iter().map(|x| x % 2 != 0).collect();
            for (pivot, other) in &rows {
                if row[*pivot] {
                    row.iter_mut().zip(other).for_each(|(a, b)| *a ^= b);
                }
            }
            if let Some(pivot) = row.iter().position(|&x| x) {
                rows.push((pivot, row));
                lengths.push(length);
            }
        }
        assert_eq!(rows.len(), count);
        lengths
    }

    fn check(name: &str, map: &GeneralizedMap, lengths: &[f64]) {
        let found = shortest_homology_basis(map, Some(lengths), usize::MAX).unwrap();
        let expected = brute_force(map, lengths);
        let sum: f64 = found.iter().map(ShortestCycle::length).sum();
        assert!((sum - expected.iter().sum::<f64>()).abs() < 1e-9, "{name}: {sum} {expected:?}");
        // They are a basis.
        let trees = TreeCotree::new(map);
        let homology = SurfaceHomology::new(map, &trees);
        let mut rows: Vec<Vec<i64>> =
            found.iter().map(|cycle| homology.class_of_walk(cycle.walk()).unwrap()).collect();
        for i in 0..rows.len() {
            let pivot = rows[i].iter().position(|x| x % 2 != 0).expect(name);
            let row = rows[i].clone();
            for other in &mut rows[i + 1..] {
                if other[pivot] % 2 != 0 {
                    other.iter_mut().zip(&row).for_each(|(a, b)| *a += b);
                }
            }
        }
    }

    #[test]
    fn bases_are_the_shortest() {
        for (name, map) in all_kinds() {
            check(name, &map, &vec![1.0; map.skeleton().edge_count()]);
        }
        let error = shortest_homology_basis(&genus(2), None, 10).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::TooLarge);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        #[test]
        fn bases_of_permutations_are_the_shortest(
            next in Just((0u32..20).collect::<Vec<_>>()).prop_shuffle(),
            lengths in prop::collection::vec(0u8..9, 10),
        ) {
            let lengths: Vec<f64> = lengths.into_iter().map(f64::from).collect();
            check("permutation", &of_next(next), &lengths);
        }

        #[test]
        fn bases_of_surfaces_with_holes_are_the_shortest(
            removed in any::<u64>(), more in any::<u64>(), lengths in prop::collection::vec(1u8..9, 75),
        ) {
            for closed in [known_spaces::torus_grid(&[4, 4]), known_spaces::klein_grid(5, 5)] {
                if let Some(map) = with_holes(&map_of(closed), removed & more) {
                    let count = map.skeleton().edge_count();
                    let lengths: Vec<f64> = lengths[..count].iter().map(|&x| f64::from(x)).collect();
                    check("with holes", &map, &lengths);
                }
            }
        }
    }
}
