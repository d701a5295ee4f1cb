//! Shortest loops at one vertex that generate the fundamental group.

use super::root_search::RootSearch;
use super::shortest_paths::checked_lengths;
use super::{ClosedWalk, ShortestCycle};
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_complexes::surface::GeneralizedMap;

/// Loops at a vertex that generate the fundamental group of its component, as short as can be: their lengths, in rising
/// order, are not above those of any other system of generators. There are $2 - \chi$ on a closed component; on one
/// with boundary there are $1 - \chi$, and they generate freely.
///
/// They are the edges that a tree of shortest paths from the vertex and a cotree of longest loops leave over, closed up
/// along the tree. In a component with boundary the cotree, unlike that of a [`TreeCotree`](super::TreeCotree), may
/// reach the outside through any number of edges, so cutting along the loops and the tree need not leave one disk.
/// `lengths` has a length for each edge; without it, each edge has the length 1.
///
/// # Errors
/// [`ErrorKind::Shape`] and [`ErrorKind::InvalidInput`] for lengths that are not one for each edge, finite and not
/// negative; [`ErrorKind::NotInComplex`] for a vertex that is not there.
///
/// # Complexity
/// $O(n \log n)$, and the lengths of the loops.
///
/// # References
/// J. Erickson, K. Whittlesey, *Greedy optimal homotopy and homology generators* (2005), for closed surfaces. With a
/// boundary the same exchange of edges gives a shortest basis of homology over Z/2 at the vertex, which no system of
/// generators falls short of.
///
/// # Examples
/// On a torus of 4 by 6 squares, each cut in two: loops of 4 and 6 edges at every vertex.
/// ```
/// use coface_algebra::VertexId;
/// use coface_complexes::known_spaces;
/// use coface_complexes::surface::GeneralizedMap;
/// use coface_topology::shortest_loops;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(known_spaces::torus_grid(&[4, 6])?.freeze().two_skeleton()?)?;
/// let loops = shortest_loops(&torus, VertexId::new(5), None)?;
/// assert_eq!(loops.iter().map(|cycle| cycle.length()).collect::<Vec<_>>(), [4.0, 6.0]);
/// assert!(loops.iter().all(|cycle| cycle.walk().start() == VertexId::new(5)));
/// # Ok(()) }
/// ```
pub fn shortest_loops(
    map: &GeneralizedMap,
    vertex: VertexId,
    lengths: Option<&[f64]>,
) -> Result<Vec<ShortestCycle>, Error> {
    if vertex.index() >= map.skeleton().vertex_count() {
        return Err(Error::new(
            ErrorKind::NotInComplex,
            format!("there is no vertex {vertex}; the surface has {}", map.skeleton().vertex_count()),
        ));
    }
    let lengths = checked_lengths(map, lengths)?;
    let mut search = RootSearch::new(map, &lengths);
    search.run(vertex.to_u32(), f64::INFINITY);
    let closings = search.local_dual(f64::INFINITY).leftover();
    let cycle = |edge: u32| {
        let walk = ClosedWalk::new(map.skeleton(), search.loop_through(edge))?;
        Ok(ShortestCycle::new(walk, &lengths))
    };
    closings.into_iter().map(|closing| cycle(closing.edge)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::surface_homology::SurfaceHomology;
    use crate::curves::surface_homotopy::SurfaceHomotopy;
    use crate::curves::tree_cotree::TreeCotree;
    use crate::groups::Presentation;
    use crate::homology::AbelianGroup;
    use coface_algebra::Word;
    use coface_complexes::known_spaces;
    use coface_complexes::surface::samples::{all_kinds, map_of, of_next, with_holes};
    use proptest::prelude::*;

    fn check(name: &str, map: &GeneralizedMap, lengths: &[f64]) {
        let trees = TreeCotree::new(map);
        let homotopy = SurfaceHomotopy::new(map, &trees).unwrap();
        let homology = SurfaceHomology::new(map, &trees);
        let mut first = 0;
        for (group, component) in homotopy.groups().iter().zip(trees.components()) {
            let loops = shortest_loops(map, component.base(), Some(lengths)).unwrap();
            let count = component.generators().len();
            assert_eq!(loops.len(), count, "{name}");
            let words: Vec<Word> = loops.iter().map(|cycle| homotopy.word(cycle.walk()).unwrap()).collect();
            // Nothing is left of the group when they are made trivial: they generate it normally, and its homology.
            let relators = words.iter().cloned().chain(group.relator().cloned());
            let quotient = Presentation::new(count, relators.collect()).unwrap();
            assert_eq!(quotient.abelianization(), AbelianGroup::new(0, Vec::new()), "{name}");
            // Not longer than a greedy choice among the loops of all edges, by classes over Z/2.
            let mut search = RootSearch::new(map, lengths);
            search.run(component.base().to_u32(), f64::INFINITY);
            let mut rows: Vec<(usize, Vec<bool>)> = Vec::new();
            let mut expected = Vec::new();
            for (closing, _) in search.local_dual(f64::INFINITY).arcs {
                let walk = ClosedWalk::new(map.skeleton(), search.loop_through(closing.edge)).unwrap();
                let class = homology.class_of_walk(&walk).unwrap();
                let mut row: Vec<bool> = class[first..first + count].iter().map(|x| x % 2 != 0).collect();
                for (pivot, other) in &rows {
                    if row[*pivot] {
                        row.iter_mut().zip(other).for_each(|(a, b)| *a ^= b);
                    }
                }
                if let Some(pivot) = row.iter().position(|&x| x) {
                    rows.push((pivot, row));
                    expected.push(closing.length);
                }
            }
            assert_eq!(loops.iter().map(ShortestCycle::length).collect::<Vec<_>>(), expected, "{name}");
            // On closed surfaces these are the lengths of the greedy trees as well.
            if !component.has_boundary() && count > 0 {
                let trees = TreeCotree::greedy(map, Some(component.base()), Some(lengths)).unwrap();
                let mut greedy: Vec<f64> = trees.components()[0]
                    .generators()
                    .iter()
                    .map(|&e| trees.based_loop(map, e).iter().map(|s| lengths[(s >> 1) as usize]).sum())
                    .collect();
                greedy.sort_by(f64::total_cmp);
                assert_eq!(greedy, expected, "{name}");
            }
            first += count;
        }
    }

    #[test]
    fn loops_generate_and_are_short() {
        for (name, map) in all_kinds() {
            check(name, &map, &vec![1.0; map.skeleton().edge_count()]);
        }
        let torus = map_of(known_spaces::cyclic_torus(2));
        assert_eq!(
            shortest_loops(&torus, VertexId::new(9), None).unwrap_err().kind(),
            ErrorKind::NotInComplex
        );
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]

        #[test]
        fn loops_of_all_surfaces_generate_and_are_short(
            next in Just((0u32..20).collect::<Vec<_>>()).prop_shuffle(),
            removed in any::<u64>(), more in any::<u64>(), lengths in prop::collection::vec(1u8..9, 75),
        ) {
            let lengths: Vec<f64> = lengths.into_iter().map(f64::from).collect();
            check("permutation", &of_next(next), &lengths[..10]);
            for closed in [known_spaces::torus_grid(&[4, 4]), known_spaces::klein_grid(5, 5)] {
                if let Some(map) = with_holes(&map_of(closed), removed & more) {
                    let count = map.skeleton().edge_count();
                    check("with holes", &map, &lengths[..count]);
                }
            }
        }
    }
}
