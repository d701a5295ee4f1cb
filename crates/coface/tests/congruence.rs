//! Quotients against each other and against known numbers.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use coface::algebra::{RaggedArray, Sign, SparseMatrix, UnionFind};
use coface::arrangement::congruence::{
    CellClasses, ChainCongruence, ClassRule, Collisions, CongruenceMethod, CongruenceOptions, Representative,
    chain_congruence, vertex_congruence,
};
use coface::chains::ChainComplex;
use coface::geometry::Positions;
use coface::simplicial::{FrozenComplex, SimplicialComplex};
use coface::surface::PolygonMesh;
use coface::{CellId, ErrorKind};
use proptest::prelude::*;

const LISTS: CongruenceOptions =
    CongruenceOptions { method: CongruenceMethod::Lists, collisions: Collisions::Keep };
const MATRICES: CongruenceOptions = CongruenceOptions { method: CongruenceMethod::Matrices, ..LISTS };
const REFUSE: CongruenceOptions = CongruenceOptions { collisions: Collisions::Refuse, ..LISTS };

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
    (Positions::from_flat(3, flat).unwrap(), mesh.chain_complex())
}

fn quotient(positions: &Positions, complex: &ChainComplex, tolerance: f64) -> ChainCongruence {
    let vertices =
        vertex_congruence(positions, tolerance, ClassRule::Transitive, Representative::Lowest).unwrap();
    let classes = CellClasses::unsigned(vertices.class_of().to_vec()).unwrap();
    let found = chain_congruence(complex, classes.clone(), None, LISTS).unwrap();
    assert_eq!(found, chain_congruence(complex, classes, None, MATRICES).unwrap());
    found
}

#[test]
fn separate_cubes_become_a_grid() {
    for k in [1, 2, 4] {
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
    let complex = PolygonMesh::new(7, faces, &[]).unwrap().chain_complex();
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
        prop_assert_eq!(&found, &chain_congruence(&complex, classes, None, MATRICES).unwrap());
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
