//! Quotients against each other and against known numbers.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, ErrorKind};
use coface_algebra::{RaggedArray, Sign, SparseMatrix, UnionFind};
use coface_arrange::congruence::{
    BlockPolicy, CellClasses, ChainCongruence, ClassRule, Collisions, CongruenceMethod, CongruenceOptions,
    Representative, blocks_of, chain_congruence, check_blocks, stable_vertex_congruence, vertex_congruence,
};
use coface_complexes::simplicial::{FrozenComplex, SimplicialComplex};
use coface_complexes::surface::PolygonMesh;
use coface_geometry::Positions;
use proptest::prelude::*;
use std::collections::BTreeMap;

const LISTS: CongruenceOptions = CongruenceOptions::new();
/// The other methods, which agree.
const OTHERS: &[CongruenceMethod] = &[CongruenceMethod::Matrices];
const REWRAP: CongruenceOptions = LISTS.collisions(Collisions::Rewrap);
const REFUSE: CongruenceOptions = LISTS.collisions(Collisions::Refuse);

/// The squares of all cubes of a k x k x k grid, every one with vertices of its own that are off by up to 1e-8.
fn separate_squares(k: u32) -> (Positions, ChainComplex) {
    let mut state = 7u64;
    let mut noise = || {
        state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        ((state >> 11) as f64 / (1u64 << 53) as f64 - 0.5) * 2e-8
    };
    let (mut flat, mut polygons) = (Vec::new(), Vec::new());
    for cube in 0..k.pow(3) {
        let corner = [cube / (k * k), cube / k % k, cube % k];
        for axis in 0..3 {
            for side in 0..2 {
                let square = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[u, v]| {
                    let mut at = corner;
                    at[axis] += side;
                    at[(axis + 1) % 3] += u;
                    at[(axis + 2) % 3] += v;
                    at
                });
                let first = flat.len() as u32 / 3;
                polygons.push([0, 1, 2, 3].map(|i| first + i));
                for at in square {
                    flat.extend(at.map(|x| f64::from(x) + noise()));
                }
            }
        }
    }
    let count = flat.len() / 3;
    let mesh = PolygonMesh::new(count, RaggedArray::from_lists(&polygons), &[]).unwrap();
    (Positions::from_flat(3, flat).unwrap(), mesh.chain_complex().unwrap())
}

fn quotient(positions: &Positions, complex: &ChainComplex, tolerance: f64) -> ChainCongruence {
    let vertices =
        vertex_congruence(positions, tolerance, ClassRule::Transitive, Representative::Lowest).unwrap();
    let classes = CellClasses::unsigned(vertices.class_of().to_vec()).unwrap();
    let found = chain_congruence(complex, classes.clone(), None, LISTS).unwrap();
    for &method in OTHERS {
        let options = LISTS.method(method);
        assert_eq!(found, chain_congruence(complex, classes.clone(), None, options).unwrap());
    }
    #[cfg(feature = "graphblas-tests")]
    crate::graphblas::check(complex, &classes);
    found
}

#[test]
fn separate_cubes_become_a_grid() {
    for k in [1, 2, 4, 10] {
        let (positions, complex) = separate_squares(k);
        let found = quotient(&positions, &complex, 1e-6);
        let k = k as usize;
        let expected = [(k + 1).pow(3), 3 * k * (k + 1).pow(2), 3 * k * k * (k + 1)];
        assert_eq!(found.complex().f_vector(), expected);
        assert_eq!(found.complex().euler_characteristic(), 1 + k.pow(3) as i64);
        assert_eq!(found.collapsed_counts(), [0, 0, 0]);
        assert!(found.changed().iter().all(Vec::is_empty));
    }
}

#[test]
fn short_edges_and_small_faces_collapse() {
    // A quadrangle with a short edge becomes a triangle; a tiny triangle becomes a point.
    let positions =
        Positions::from_flat(2, vec![0., 0., 4., 0., 4., 0.1, 0., 4., 9., 9., 9.1, 9., 9., 9.1]).unwrap();
    let faces = RaggedArray::from_lists([vec![0, 1, 2, 3], vec![4, 5, 6]]);
    let complex = PolygonMesh::new(7, faces, &[]).unwrap().chain_complex().unwrap();
    let found = quotient(&positions, &complex, 0.5);
    assert_eq!(found.complex().f_vector(), [4, 3, 1]);
    assert_eq!(found.collapsed_counts(), [0, 4, 1]);
    assert_eq!(found.changed()[2], [0]);
    assert_eq!(found.classes()[2].class(CellId::new(1)), None);
    let vertices = CellClasses::unsigned(vec![0, 1, 1, 2, 3, 3, 3]).unwrap();
    let error = chain_congruence(&complex, vertices, None, REFUSE).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::InvalidInput);
    assert!(error.message().starts_with("cell 2 of degree 1 collapses"), "{error}");
}

#[test]
fn opposite_edges_are_one_with_opposite_signs() {
    // Two squares on an edge, which one lists upwards and the other downwards, each with edges of its own.
    let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
    let ends = edges.iter().enumerate().flat_map(|(e, &[a, b])| [(a, e, -1), (b, e, 1)]);
    let faces = (0..8).map(|e| (e, e / 4, 1));
    let matrix = |rows, columns, entries: Vec<(usize, usize, i64)>| {
        SparseMatrix::from_entries(rows, columns, entries).unwrap()
    };
    let complex =
        ChainComplex::new(vec![matrix(8, 8, ends.collect()), matrix(8, 2, faces.collect())]).unwrap();
    let positions =
        Positions::from_flat(2, vec![0., 0., 1., 0., 1., 1., 0., 1., 1., 0., 2., 0., 2., 1., 1., 1.])
            .unwrap();
    let found = quotient(&positions, &complex, 0.01);
    assert_eq!(found.complex().f_vector(), [6, 7, 2]);
    assert_eq!(found.classes()[1].class(CellId::new(7)), Some((1, Sign::Minus)));
    assert_eq!(found.complex().boundary_matrix(2).unwrap().entry(1, 0), 1);
    assert_eq!(found.complex().boundary_matrix(2).unwrap().entry(1, 1), -1);
}

/// Real block-diagonal complexes with the numbers that an independent program found at several tolerances.
#[test]
fn real_complexes_have_the_recorded_quotients() {
    let Some(data) = std::env::var_os("COFACE_DATA").map(std::path::PathBuf::from) else {
        println!("skipped: COFACE_DATA names no folder");
        return;
    };
    for example in 1..=3 {
        let text =
            std::fs::read_to_string(data.join(format!("congruence/congruence_ex{example}.json"))).unwrap();
        let record: serde_json::Value = serde_json::from_str(&text).unwrap();
        let flat: Vec<Vec<f64>> = serde_json::from_value(record["vertices"].clone()).unwrap();
        let positions = Positions::from_flat(3, flat.concat()).unwrap();
        // Rows of the file are cells of the higher degree: the transposes of boundary matrices.
        let matrix = |key: &str| {
            let matrix = &record[key];
            let [rows, columns] = ["rows", "cols"].map(|count| matrix[count].as_u64().unwrap() as usize);
            let entries: Vec<(usize, usize, i64)> = serde_json::from_value(matrix["coo"].clone()).unwrap();
            let entries = entries.into_iter().map(|(row, column, entry)| (column, row, entry));
            SparseMatrix::from_entries(columns, rows, entries).unwrap()
        };
        let complex = ChainComplex::new(vec![matrix("d0"), matrix("d1")]).unwrap();
        for (tolerance, expected) in record["expected"].as_object().unwrap() {
            let found = quotient(&positions, &complex, tolerance.parse().unwrap());
            let counts = ["V", "E", "F"].map(|key| expected[key].as_u64().unwrap() as usize);
            assert_eq!(found.complex().f_vector(), counts, "example {example} at {tolerance}");
            let collapsed =
                ["collapsed_edges", "collapsed_faces"].map(|key| expected[key].as_u64().unwrap() as usize);
            assert_eq!(found.collapsed_counts()[1..], collapsed);
        }
    }
}

fn random_complex(facets: &[Vec<u32>]) -> FrozenComplex {
    SimplicialComplex::from_facets(facets.iter().map(Vec::as_slice)).unwrap().freeze()
}

proptest! {
    /// Any classes of vertices of any complex: both methods agree, and classes are a chain map onto the quotient.
    #[test]
    fn quotients_are_complexes_and_classes_chain_maps(
        facets in prop::collection::vec(prop::collection::btree_set(0u32..9, 1..5), 1..9),
        merged in prop::collection::vec((0usize..9, 0usize..9), 0..6),
    ) {
        let facets: Vec<Vec<u32>> = facets.into_iter().map(|facet| facet.into_iter().collect()).collect();
        let complex = random_complex(&facets).chain_complex().unwrap();
        let count = complex.cell_count(0);
        let mut partition = UnionFind::new(count);
        for (a, b) in merged {
            partition.unite((a % count) as u32, (b % count) as u32);
        }
        let classes = CellClasses::unsigned(partition.class_numbers()).unwrap();
        let found = chain_congruence(&complex, classes.clone(), None, LISTS).unwrap();
        for &method in OTHERS {
            let options = LISTS.method(method);
            prop_assert_eq!(&found, &chain_congruence(&complex, classes.clone(), None, options).unwrap());
        }
        #[cfg(feature = "graphblas-tests")]
        crate::graphblas::check(&complex, &classes);
        for (degree, matrix) in (1..).zip(complex.boundary_matrices()) {
            let [lower, own] = [degree - 1, degree].map(|k| found.classes()[k].matrix().unwrap());
            let quotient = found.complex().boundary_matrix(degree).unwrap();
            prop_assert_eq!(lower.product(matrix).unwrap(), quotient.product(&own).unwrap());
        }
        // Once more nothing happens.
        let identity = CellClasses::unsigned((0..found.complex().cell_count(0) as u32).collect()).unwrap();
        let again = chain_congruence(found.complex(), identity, None, LISTS).unwrap();
        prop_assert_eq!(again.complex(), found.complex());
    }
}

/// Polygons that share nothing, with corners at ten places, off by up to 1e-6.
#[derive(Clone, Debug)]
struct Soup {
    polygons: Vec<Vec<(usize, f64)>>,
}

const PLACES: [[f64; 3]; 10] = [
    [0.13, 0.77, 0.31],
    [0.92, 0.18, 0.44],
    [0.35, 0.29, 0.83],
    [0.61, 0.95, 0.07],
    [0.48, 0.52, 0.59],
    [0.04, 0.11, 0.16],
    [0.79, 0.66, 0.98],
    [0.23, 0.41, 0.02],
    [0.87, 0.83, 0.25],
    [0.57, 0.06, 0.71],
];

fn soups() -> impl Strategy<Value = Soup> {
    let corner = (0usize..10, -1e-6f64..1e-6);
    prop::collection::vec(prop::collection::vec(corner, 3..9), 1..10).prop_map(|polygons| Soup { polygons })
}

impl Soup {
    fn points(&self) -> Vec<[f64; 3]> {
        let corners = self.polygons.iter().flatten();
        corners.map(|&(place, off)| PLACES[place].map(|x| x + off / 2.0)).collect()
    }

    /// The boundaries of edges and faces, as lists of terms.
    fn boundaries(&self) -> [Vec<Vec<(usize, i64)>>; 2] {
        let (mut edges, mut faces) = (Vec::new(), Vec::new());
        for polygon in &self.polygons {
            let (first, count) = (edges.len(), polygon.len());
            edges.extend((0..count).map(|i| vec![(first + i, -1), (first + (i + 1) % count, 1)]));
            faces.push((first..first + count).map(|edge| (edge, 1)).collect());
        }
        [edges, faces]
    }

    fn positions(&self) -> Positions {
        Positions::from_flat(3, self.points().concat()).unwrap()
    }

    fn complex(&self) -> ChainComplex {
        let mut rows = self.points().len();
        let matrices = self.boundaries().map(|columns| {
            let entries = columns.iter().enumerate();
            let entries = entries.flat_map(|(j, column)| column.iter().map(move |&(i, entry)| (i, j, entry)));
            let matrix = SparseMatrix::from_entries(rows, columns.len(), entries).unwrap();
            rows = columns.len();
            matrix
        });
        ChainComplex::new(matrices.to_vec()).unwrap()
    }

    fn quotient(&self, options: CongruenceOptions) -> Result<ChainCongruence, coface_algebra::Error> {
        let vertices =
            vertex_congruence(&self.positions(), 1e-3, ClassRule::Transitive, Representative::Lowest)
                .unwrap();
        let classes = CellClasses::unsigned(vertices.class_of().to_vec()).unwrap();
        chain_congruence(&self.complex(), classes, Some(vertices.positions()), options)
    }
}

/// What a cell is in a quotient: its lowest equal and the sign against it, nothing when it vanishes; and whether its
/// boundary lost terms.
type Fate = (Option<(usize, i64)>, bool);

/// The quotient from its definition: all distances, and maps of terms.
fn quotient_by_definition(soup: &Soup) -> [Vec<Fate>; 3] {
    let points = soup.points();
    let mut labels: Vec<usize> = (0..points.len()).collect();
    for _ in 0..points.len() {
        for (i, p) in points.iter().enumerate() {
            for (j, q) in points.iter().enumerate() {
                let square: f64 = p.iter().zip(q).map(|(x, y)| (x - y).powi(2)).sum();
                if square.sqrt() <= 1e-3 {
                    labels[i] = labels[i].min(labels[j]);
                }
            }
        }
    }
    let mut fates: [Vec<Fate>; 3] =
        [labels.into_iter().map(|label| (Some((label, 1)), false)).collect(), vec![], vec![]];
    for (k, columns) in (1..).zip(soup.boundaries()) {
        let mut seen: Vec<(BTreeMap<usize, i64>, usize)> = Vec::new();
        for (cell, column) in columns.iter().enumerate() {
            let mut own: BTreeMap<usize, i64> = BTreeMap::new();
            for &(facet, entry) in column {
                if let Some((class, sign)) = fates[k - 1][facet].0 {
                    *own.entry(class).or_default() += sign * entry;
                }
            }
            own.retain(|_, entry| *entry != 0);
            let opposite: BTreeMap<usize, i64> = own.iter().map(|(&class, &entry)| (class, -entry)).collect();
            let lowest = match seen.iter().find(|(other, _)| *other == own || *other == opposite) {
                Some((other, first)) => (*first, if *other == own { 1 } else { -1 }),
                None => (cell, 1),
            };
            let has_changed = !own.is_empty() && own.len() < column.len();
            fates[k].push((if own.is_empty() { None } else { Some(lowest) }, has_changed));
            seen.push((own, cell));
        }
    }
    fates
}

/// The same from the library.
fn fates(found: &ChainCongruence) -> [Vec<Fate>; 3] {
    [0, 1, 2].map(|degree| {
        let classes = &found.classes()[degree];
        let fate = |cell: usize| {
            let image = classes.class(CellId::new(cell));
            let lowest = image
                .map(|(class, sign)| (classes.members().list(class)[0] as usize, i64::from(sign.to_i32())));
            (lowest, found.changed()[degree].contains(&(cell as u32)))
        };
        (0..classes.cell_count()).map(fate).collect()
    })
}

proptest! {
    /// Separate polygons against the definition of the quotient.
    #[test]
    fn soups_agree_with_the_definition(soup in soups()) {
        let expected = quotient_by_definition(&soup);
        let found = soup.quotient(LISTS).unwrap();
        for &method in OTHERS {
            prop_assert_eq!(&found, &soup.quotient(LISTS.method(method)).unwrap());
        }
        #[cfg(feature = "graphblas-tests")]
        crate::graphblas::check(&soup.complex(), &found.classes()[0]);
        prop_assert_eq!(&fates(&found), &expected);
        // Refused is what loses its shape, and the first of it is named.
        let lost = (1..3).find_map(|degree| {
            let is_lost = |fate: &Fate| fate.0.is_none() || fate.1;
            expected[degree].iter().position(is_lost).map(|cell| format!("cell {cell} of degree {degree} "))
        });
        match (soup.quotient(REFUSE), lost) {
            (Ok(refusing), None) => prop_assert_eq!(&refusing, &found),
            (Err(error), Some(place)) => prop_assert!(error.message().starts_with(&place), "{}", error),
            (found, expected) => prop_assert!(false, "{:?} where {:?} is lost", found.is_ok(), expected),
        }
        // Cells that keep their shapes become what they become otherwise.
        let rewrapped = soup.quotient(REWRAP).unwrap();
        for (cell, fate) in expected[2].iter().enumerate().filter(|(_, fate)| !fate.1) {
            let count = rewrapped.classes()[2].image(CellId::new(cell)).len();
            prop_assert!(count >= usize::from(fate.0.is_some()));
        }
        prop_assert_eq!(&rewrapped.classes()[1], &found.classes()[1]);
    }

    /// The order of the polygons of a soup, and so of all cells, changes no more than the numbers.
    #[test]
    fn quotients_do_not_depend_on_the_order(soup in soups(), seed: u64) {
        let mut order: Vec<usize> = (0..soup.polygons.len()).collect();
        order.sort_by_key(|&i| (i as u64 + 1).wrapping_mul(seed | 1).rotate_left(17));
        let other = Soup { polygons: order.iter().map(|&i| soup.polygons[i].clone()).collect() };
        // Where the cells of each polygon begin, in degrees 0 to 2.
        let starts = |soup: &Soup| -> Vec<usize> {
            soup.polygons.iter().scan(0, |sum, p| { *sum += p.len(); Some(*sum - p.len()) }).collect()
        };
        let (before, after) = (starts(&soup), starts(&other));
        let mut moved = vec![0; soup.points().len()];
        let mut moved_faces = vec![0; order.len()];
        for (new, &old) in order.iter().enumerate() {
            moved_faces[old] = new;
            (0..soup.polygons[old].len()).for_each(|i| moved[before[old] + i] = after[new] + i);
        }
        for options in [LISTS, REWRAP] {
            let [found, again] = [&soup, &other].map(|soup| soup.quotient(options).unwrap());
            prop_assert_eq!(found.complex().f_vector(), again.complex().f_vector());
            for (degree, moved) in [&moved, &moved, &moved_faces].into_iter().enumerate() {
                let [own, others] = [&found, &again].map(|found| &found.classes()[degree]);
                for a in 0..own.cell_count() {
                    let image = |classes: &CellClasses, cell: usize| classes.image(CellId::new(cell)).collect::<Vec<_>>();
                    let first = [image(own, a), image(others, moved[a])];
                    prop_assert_eq!(first[0].len(), first[1].len());
                    for (b, &moved) in moved.iter().enumerate().take(a) {
                        let second = [image(own, b), image(others, moved)];
                        let relative = |pair: usize| match (&first[pair][..], &second[pair][..]) {
                            (&[(x, s)], &[(y, t)]) => (x == y).then(|| s.times(t)),
                            // Several classes: whether one is of both.
                            (x, y) => x.iter().any(|(x, _)| y.iter().any(|(y, _)| x == y)).then_some(Sign::Plus),
                        };
                        prop_assert_eq!(relative(0), relative(1));
                    }
                }
            }
        }
        prop_assert_eq!(soup.quotient(REFUSE).is_ok(), other.quotient(REFUSE).is_ok());
    }

    /// Classes of a result are single: at once for lowest members, after repetition for means and medians.
    #[test]
    fn classes_of_classes_are_single(
        flat in prop::collection::vec(0.0f64..8.0, 0..200), tolerance in 0.0f64..1.0, greedy: bool, seed: u64,
    ) {
        let points: Vec<[f64; 2]> = flat.as_chunks::<2>().0.to_vec();
        let positions = Positions::from_flat(2, points.concat()).unwrap();
        let rule = if greedy { ClassRule::Greedy } else { ClassRule::Transitive };
        let once = vertex_congruence(&positions, tolerance, rule, Representative::Lowest).unwrap();
        let again = vertex_congruence(once.positions(), tolerance, rule, Representative::Lowest).unwrap();
        prop_assert_eq!(again.class_count(), once.class_count());
        prop_assert_eq!(again.positions(), once.positions());
        for representative in [Representative::Lowest, Representative::Mean, Representative::Median] {
            let stable = stable_vertex_congruence(&positions, tolerance, rule, representative).unwrap();
            let again = stable_vertex_congruence(stable.positions(), tolerance, rule, representative).unwrap();
            prop_assert_eq!(again.class_count(), stable.class_count());
            prop_assert_eq!(again.positions(), stable.positions());
            // It is no finer than without repetition.
            for class in once.members().iter().filter(|_| !greedy) {
                prop_assert!(class.iter().all(|&v| stable.class_of()[v as usize] == stable.class_of()[class[0] as usize]));
            }
            if greedy {
                continue;
            }
            let mut order: Vec<usize> = (0..points.len()).collect();
            order.sort_by_key(|&i| (i as u64 + 1).wrapping_mul(seed | 1).rotate_left(17));
            let shuffled = Positions::from_flat(2, order.iter().flat_map(|&i| points[i]).collect()).unwrap();
            let other = stable_vertex_congruence(&shuffled, tolerance, rule, representative).unwrap();
            let mut partition: Vec<Vec<usize>> = other.members().iter().map(|class| {
                let mut class: Vec<usize> = class.iter().map(|&v| order[v as usize]).collect();
                class.sort_unstable();
                class
            }).collect();
            partition.sort();
            let expected: Vec<Vec<usize>> =
                stable.members().iter().map(|class| class.iter().map(|&v| v as usize).collect()).collect();
            prop_assert_eq!(partition, expected);
        }
    }

    /// Vertices of one block in one class, against all pairs; the polygons of a soup are its blocks.
    #[test]
    fn merges_within_blocks_are_found(soup in soups()) {
        let (positions, points) = (soup.positions(), soup.points());
        let blocks = blocks_of(&soup.complex());
        let of_polygons = soup.polygons.iter().enumerate().flat_map(|(i, p)| vec![i as u32; p.len()]);
        prop_assert!(of_polygons.eq(blocks.iter().copied()));
        let classes = vertex_congruence(&positions, 1e-3, ClassRule::Transitive, Representative::Lowest).unwrap();
        let mut expected: BTreeMap<(usize, u32), (Vec<u32>, f64)> = BTreeMap::new();
        for b in 0..points.len() {
            for a in 0..b {
                let class = classes.class_of()[a];
                if blocks[a] == blocks[b] && class == classes.class_of()[b] {
                    let distance = positions.distances(&[a as u32, b as u32]).unwrap()[0];
                    let (vertices, nearest) =
                        expected.entry((class as usize, blocks[a])).or_insert((Vec::new(), f64::INFINITY));
                    vertices.extend([a as u32, b as u32]);
                    vertices.sort_unstable();
                    vertices.dedup();
                    *nearest = nearest.min(distance);
                }
            }
        }
        let found = check_blocks(&classes, &positions, &blocks, BlockPolicy::Warn).unwrap();
        let found: BTreeMap<(usize, u32), (Vec<u32>, f64)> =
            found.into_iter().map(|merge| ((merge.class, merge.block), (merge.vertices, merge.distance))).collect();
        prop_assert_eq!(&found, &expected);
        let strict = check_blocks(&classes, &positions, &blocks, BlockPolicy::Forbid);
        prop_assert_eq!(strict.is_ok(), expected.is_empty());
        prop_assert!(check_blocks(&classes, &positions, &blocks, BlockPolicy::Allow).unwrap().is_empty());
    }
}
