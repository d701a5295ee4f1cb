use super::{Filtration, PersistentCycle, persistence, persistent_cycles, torsion_primes};
use crate::Coefficients;
use coface_algebra::chains::{Chain, ChainComplex};
use coface_algebra::{CellId, Integer};
use coface_complexes::simplicial::SimplicialComplex;
use proptest::prelude::*;
use std::collections::BTreeMap;

/// That chains over F_p prove what they say of a class; cells are compared by value and then by the order of entrance.
pub(super) fn assert_proved(
    complex: &ChainComplex,
    filtration: &Filtration,
    prime: u32,
    found: &PersistentCycle,
) {
    let pair = found.pair();
    let degree = pair.degree();
    // The places of the cells of both degrees in the order of entrance.
    let places: Vec<Vec<u32>> =
        (0..degree + 2).map(|degree| super::reduction::numbers(filtration.entrance(degree))).collect();
    let order = |degree: usize, cell: CellId| (places[degree][cell.index()], cell);
    let is_zero = |x: &Integer| x.div_rem_floor(&Integer::from(i64::from(prime))).1 == Integer::ZERO;
    let last = |chain: &Chain<Integer>| {
        let cells = chain.support().map(|cell| order(chain.degree(), cell));
        cells
            .reduce(|a, b| if a.partial_cmp(&b) == Some(std::cmp::Ordering::Less) { b } else { a })
            .map(|(_, cell)| cell)
    };
    let cycle = found.cycle();
    assert_eq!(cycle.degree(), degree);
    // A cycle, whose last cell makes the class.
    let boundary = complex.boundary(cycle);
    assert!(degree == 0 || boundary.unwrap().terms().iter().all(|(_, x)| is_zero(x)));
    assert_eq!(last(cycle), Some(pair.birth_cell()));
    // The chain bounds it, and its last cell ends the class.
    assert_eq!(found.bounding_chain().is_some(), pair.death_cell().is_some());
    if let Some(chain) = found.bounding_chain() {
        let boundary = complex.boundary(chain).unwrap();
        let mut rest: Vec<Integer> = vec![Integer::ZERO; complex.cell_count(degree)];
        boundary.terms().iter().for_each(|(cell, x)| rest[cell.index()] += x);
        cycle.terms().iter().for_each(|(cell, x)| rest[cell.index()] += &-x);
        assert!(rest.iter().all(is_zero), "{boundary:?} {cycle:?}");
        assert_eq!(last(chain), pair.death_cell());
    }
    // The cocycle is closed on what enters before the death, and has the value 1 on the cycle.
    let cocycle = found.cocycle();
    let value = cocycle.pairing(cycle).unwrap();
    assert_eq!(value.map(|x| x.div_rem_floor(&Integer::from(i64::from(prime))).1), Some(Integer::ONE));
    for (cell, _) in cocycle.terms() {
        assert!(order(degree, *cell) >= order(degree, pair.birth_cell()));
    }
    for cell in (0..complex.cell_count(degree + 1)).map(CellId::new) {
        if pair.death_cell().is_none_or(|death| order(degree + 1, cell) < order(degree + 1, death)) {
            let whole = Chain::new(complex, degree + 1, [(cell, Integer::ONE)]).unwrap();
            let value = cocycle.pairing(&complex.boundary(&whole).unwrap()).unwrap();
            assert!(value.is_none_or(|x| is_zero(&x)), "the cocycle is not closed on {cell}");
        }
    }
}

/// That no boundary of a single cell makes the cycle shorter: of cells that enter no later than the class and before the cell that ends it, and whose
/// faces enter before the cell that makes it.
fn assert_short(complex: &ChainComplex, filtration: &Filtration, prime: u32, found: &PersistentCycle) {
    let (pair, degree) = (found.pair(), found.pair().degree());
    let sign = if filtration.is_falling() { -1.0 } else { 1.0 };
    let order = |degree: usize, cell: CellId| (sign * filtration.values(degree)[cell.index()], cell);
    let size = |x: i64| x.rem_euclid(i64::from(prime)).min((-x).rem_euclid(i64::from(prime)));
    let mut values = vec![0; complex.cell_count(degree)];
    for (cell, x) in found.cycle().terms() {
        values[cell.index()] = x.to_i64().unwrap();
    }
    for cell in (0..complex.cell_count(degree + 1)).map(CellId::new) {
        let faces = complex.boundary_matrix(degree + 1).unwrap().column(cell.index());
        let is_in_time = sign * filtration.values(degree + 1)[cell.index()] <= sign * pair.birth()
            && pair.death_cell().is_none_or(|death| order(degree + 1, cell) < order(degree + 1, death))
            && faces
                .iter()
                .all(|(face, _)| order(degree, CellId::new(face)) < order(degree, pair.birth_cell()));
        for factor in [1, -1].into_iter().filter(|_| is_in_time) {
            let change: i64 = faces
                .iter()
                .map(|(face, x)| size(values[face] + factor * i64::from(x)) - size(values[face]))
                .sum();
            assert!(change >= 0, "{cell} makes {:?} shorter", found.cycle());
        }
    }
}

/// A strip of triangles whose edges along the path 0, 1, .., n come first: the loop that the edge from 0 to n closes runs along the path, and is cut short by
/// the triangles.
#[test]
fn loops_take_the_triangles_that_are_there() {
    for n in [4usize, 20, 100] {
        let end = n as u32;
        let facets = (0..end - 1).map(|i| vec![i, i + 1, i + 2]).chain([vec![0, end]]);
        let complex = SimplicialComplex::from_facets(facets).unwrap().chain_complex().unwrap();
        let mut values: Vec<Vec<f64>> =
            (0..3).map(|degree| vec![2.0 * f64::from(degree > 1); complex.cell_count(degree)]).collect();
        for (edge, column) in complex.boundary_matrix(1).unwrap().columns().enumerate() {
            let ends: Vec<usize> = column.iter().map(|(vertex, _)| vertex).collect();
            values[1][edge] = match ends[1].abs_diff(ends[0]) {
                1 => 0.0,
                2 => 1.0,
                _ => 3.0,
            };
        }
        let filtration = Filtration::new(&complex, values).unwrap();
        for prime in [2, 3] {
            let diagram = persistence(&complex, &filtration, Coefficients::Modulo(prime.into())).unwrap();
            let found = persistent_cycles(&complex, &filtration, &diagram, 5.0).unwrap();
            let hole = found.iter().find(|one| one.pair().degree() == 1).unwrap();
            assert_eq!((hole.pair().birth(), hole.cycle().terms().len()), (3.0, n / 2 + 1));
            assert_proved(&complex, &filtration, prime, hole);
            assert_short(&complex, &filtration, prime, hole);
        }
    }
}

proptest! {
    /// Invariant 112.
    #[test]
    fn cycles_are_born_and_die_when_they_say(
        facets in prop::collection::vec(prop::collection::btree_set(0..9u32, 1..5), 1..16),
        heights in prop::collection::vec(-3..4i32, 9),
        is_falling: bool,
        prime in prop_oneof![Just(2u32), Just(3), Just(7)],
    ) {
        let facets = facets.iter().map(|facet| facet.iter().copied().collect::<Vec<_>>());
        let complex = SimplicialComplex::from_facets(facets).unwrap().chain_complex().unwrap();
        let values: Vec<f64> = heights.iter().take(complex.cell_count(0)).map(|&x| f64::from(x)).collect();
        let star = if is_falling { Filtration::upper_star } else { Filtration::lower_star };
        let filtration = star(&complex, &values).unwrap();
        let diagram = persistence(&complex, &filtration, Coefficients::Modulo(prime.into())).unwrap();
        let all = persistent_cycles(&complex, &filtration, &diagram, -1.0).unwrap();
        prop_assert_eq!(all.len(), diagram.pairs().len());
        for (found, pair) in all.iter().zip(diagram.pairs()) {
            prop_assert_eq!(found.pair(), pair);
            assert_proved(&complex, &filtration, prime, found);
            assert_short(&complex, &filtration, prime, found);
        }
        // Those of long classes are the same when they alone are asked for.
        let long = persistent_cycles(&complex, &filtration, &diagram, 1.0).unwrap();
        let expected: Vec<&PersistentCycle> = all.iter().filter(|one| one.pair().persistence() > 1.0).collect();
        prop_assert_eq!(long.iter().collect::<Vec<_>>(), expected);
        // Up to a degree nothing else is needed.
        for degree in 0..complex.degree_count() {
            let part = diagram.clone().up_to_degree(degree);
            let found = persistent_cycles(&complex, &filtration, &part, -1.0).unwrap();
            prop_assert_eq!(&found[..], &all[..part.pairs().len()]);
        }
        let some = diagram.longer_than(0.0);
        if some.pairs().len() < diagram.pairs().len() {
            prop_assert!(persistent_cycles(&complex, &filtration, &some, 1.0).is_err());
        }
    }
}

/// The projective plane has a loop that never dies over F_2, and dies over F_3.
#[test]
fn loops_of_torsion_depend_on_the_field() {
    let plane = [
        [0, 1, 2],
        [0, 2, 3],
        [0, 3, 4],
        [0, 4, 5],
        [0, 5, 1],
        [1, 2, 4],
        [2, 3, 5],
        [3, 4, 1],
        [4, 5, 2],
        [5, 1, 3],
    ];
    let complex = SimplicialComplex::from_facets(plane).unwrap().chain_complex().unwrap();
    let filtration = Filtration::lower_star(&complex, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0]).unwrap();
    assert_eq!(torsion_primes(&complex, &filtration).unwrap(), [2]);
    for (prime, counts) in [(2, [1, 1, 1]), (3, [1, 0, 0])] {
        let diagram = persistence(&complex, &filtration, Coefficients::Modulo(prime.into())).unwrap();
        assert_eq!(diagram.betti_numbers(), counts);
        for found in persistent_cycles(&complex, &filtration, &diagram, -1.0).unwrap() {
            assert_proved(&complex, &filtration, prime, &found);
        }
    }
}

/// A lens space of cells, and moments along the way: which primes matter depends on the order.
#[test]
fn primes_are_those_at_which_diagrams_differ() {
    use coface_algebra::SparseMatrix;
    for order in [1, 2, 6, 15, 97] {
        let complex = ChainComplex::new(vec![
            SparseMatrix::zero(1, 1).unwrap(),
            SparseMatrix::from_entries(1, 1, [(0, 0, order)]).unwrap(),
            SparseMatrix::zero(1, 1).unwrap(),
        ])
        .unwrap();
        let filtration = Filtration::new(&complex, vec![vec![0.0], vec![1.0], vec![2.0], vec![3.0]]).unwrap();
        let expected: Vec<u32> = [2, 3, 5, 97].into_iter().filter(|&p| order % i64::from(p) == 0).collect();
        assert_eq!(torsion_primes(&complex, &filtration).unwrap(), expected);
    }
}

proptest! {
    /// Against diagrams over some fields: those over primes that are not named are those over a large one.
    #[test]
    fn primes_that_are_not_named_do_not_matter(
        facets in prop::collection::vec(prop::collection::btree_set(0..8u32, 3..4), 1..20),
        heights in prop::collection::vec(-3..4i32, 8),
    ) {
        let facets = facets.iter().map(|facet| facet.iter().copied().collect::<Vec<_>>());
        let complex = SimplicialComplex::from_facets(facets).unwrap().chain_complex().unwrap();
        let values: Vec<f64> = heights.iter().take(complex.cell_count(0)).map(|&x| f64::from(x)).collect();
        let filtration = Filtration::lower_star(&complex, &values).unwrap();
        let named = torsion_primes(&complex, &filtration).unwrap();
        let pairs = |prime: u64| {
            persistence(&complex, &filtration, Coefficients::Modulo(prime)).unwrap().pairs().to_vec()
        };
        let large = pairs(1_000_003);
        for prime in [2u32, 3, 5, 7] {
            prop_assert_eq!(pairs(prime.into()) != large, named.contains(&prime), "{} {:?}", prime, named);
        }
    }
}

/// A column by its rows, residues that are not zero.
type Dense = BTreeMap<usize, i64>;

/// The columns reduced in their order by those before them, and for each the combination of columns that it is: the textbook's way.
fn reduced_in_order(columns: Vec<Dense>, prime: i64) -> Vec<(Dense, Dense)> {
    let add = |to: &mut Dense, factor: i64, other: &Dense| {
        for (&row, &x) in other {
            let sum = (to.get(&row).unwrap_or(&0) + factor * x).rem_euclid(prime);
            if sum == 0 {
                to.remove(&row)
            } else {
                to.insert(row, sum)
            };
        }
    };
    let mut owners: BTreeMap<usize, usize> = BTreeMap::new();
    let mut done: Vec<(Dense, Dense)> = Vec::new();
    for (j, mut column) in columns.into_iter().enumerate() {
        let mut combination = Dense::from([(j, 1)]);
        while let Some((&row, &x)) = column.last_key_value() {
            let Some(&owner) = owners.get(&row) else {
                owners.insert(row, j);
                break;
            };
            let (other, sum) = &done[owner];
            let lead = other[&row];
            let factor = (1..prime).find(|factor| (x + factor * lead) % prime == 0).expect("a field");
            add(&mut column, factor, other);
            add(&mut combination, factor, sum);
        }
        done.push((column, combination));
    }
    done
}

proptest! {
    /// Against the reduction of all boundaries and all coboundaries, each in its order: cocycles are the same, and cycles differ by boundaries of cells that
    /// are there at the birth.
    #[test]
    fn cycles_are_those_of_whole_reductions(
        facets in prop::collection::vec(prop::collection::btree_set(0..8u32, 1..5), 1..14),
        heights in prop::collection::vec(-3..4i32, 8),
        prime in prop_oneof![Just(2u32), Just(3), Just(5)],
    ) {
        let facets = facets.iter().map(|facet| facet.iter().copied().collect::<Vec<_>>());
        let complex = SimplicialComplex::from_facets(facets).unwrap().chain_complex().unwrap();
        let values: Vec<f64> = heights.iter().take(complex.cell_count(0)).map(|&x| f64::from(x)).collect();
        let filtration = Filtration::lower_star(&complex, &values).unwrap();
        let diagram = persistence(&complex, &filtration, Coefficients::Modulo(prime.into())).unwrap();
        let order = |degree: usize| {
            let mut cells: Vec<usize> = (0..complex.cell_count(degree)).collect();
            cells.sort_by(|&a, &b| filtration.values(degree)[a].total_cmp(&filtration.values(degree)[b]));
            cells
        };
        let modulus = i64::from(prime);
        for found in persistent_cycles(&complex, &filtration, &diagram, -1.0).unwrap() {
            let (pair, degree) = (found.pair(), found.pair().degree());
            let (faces, cells) = (order(degree), order(degree + 1));
            let place = |cells: &[usize], cell: usize| cells.iter().position(|&one| one == cell).unwrap();
            let mut boundaries = vec![Dense::new(); cells.len()];
            let mut coboundaries = vec![Dense::new(); faces.len()];
            for (j, &cell) in cells.iter().enumerate() {
                for (face, x) in complex.boundary_matrix(degree + 1).unwrap().column(cell).iter() {
                    let (i, x) = (place(&faces, face), i64::from(x).rem_euclid(modulus));
                    boundaries[j].insert(i, x);
                    coboundaries[faces.len() - 1 - i].insert(cells.len() - 1 - j, x);
                }
            }
            let residues = |cells: &[usize], terms: &[(CellId, Integer)]| -> Dense {
                let residue = |x: &Integer| x.to_i64().unwrap().rem_euclid(modulus);
                terms.iter().map(|(cell, x)| (place(cells, cell.index()), residue(x))).collect()
            };
            let birth = place(&faces, pair.birth_cell().index());
            let cocycle = &reduced_in_order(coboundaries, modulus)[faces.len() - 1 - birth].1;
            let cocycle: Dense = cocycle.iter().map(|(&i, &x)| (faces.len() - 1 - i, x)).collect();
            prop_assert_eq!(residues(&faces, found.cocycle().terms()), cocycle);
            let Some(death) = pair.death_cell() else { continue };
            let death = place(&cells, death.index());
            let (column, combination) = &reduced_in_order(boundaries, modulus)[death];
            prop_assert_eq!(column.last_key_value().map(|(&i, _)| i), Some(birth));
            // The factor that makes the coefficient of the birth 1 is that of the death in the bounding chain.
            let bounding = residues(&cells, found.bounding_chain().unwrap().terms());
            prop_assert_eq!(bounding[&death] * column[&birth] % modulus, 1);
            for (j, &cell) in cells.iter().enumerate() {
                let expected = combination.get(&j).unwrap_or(&0) * bounding[&death] % modulus;
                let is_there = filtration.values(degree + 1)[cell] <= pair.birth();
                prop_assert!(is_there || *bounding.get(&j).unwrap_or(&0) == expected);
            }
        }
    }
}

/// Surfaces and a solid that can be oriented, and some that cannot: whatever the order, primes are found where they are.
#[test]
fn primes_of_manifolds_are_those_of_their_torsion() {
    use coface_complexes::known_spaces::{
        klein_grid, lens_space, projective_plane, real_projective_space, torus_grid,
    };
    let spaces = [
        (torus_grid(&[4, 5]), vec![]),
        (torus_grid(&[3, 4, 3]), vec![]),
        (klein_grid(4, 5), vec![2]),
        (projective_plane(), vec![2]),
        (real_projective_space(3), vec![2]),
        (lens_space(3, 1), vec![3]),
    ];
    for (space, torsion) in spaces {
        let complex = space.unwrap().chain_complex().unwrap();
        let count = complex.cell_count(0);
        for step in [1, 2, 3] {
            let values: Vec<f64> = (0..count).map(|i| (i * (2 * step + 1) % (count + 1)) as f64).collect();
            let filtration = Filtration::lower_star(&complex, &values).unwrap();
            let named = torsion_primes(&complex, &filtration).unwrap();
            assert!(torsion.iter().all(|prime| named.contains(prime)), "{named:?} {torsion:?}");
            let pairs = |prime: u64| {
                persistence(&complex, &filtration, Coefficients::Modulo(prime)).unwrap().pairs().to_vec()
            };
            let large = pairs(1_000_003);
            for prime in [2u32, 3, 5] {
                assert_eq!(pairs(prime.into()) != large, named.contains(&prime), "{prime} {named:?}");
            }
        }
    }
}
