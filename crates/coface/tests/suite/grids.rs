//! Grids, prisms and products against homology, against each other and against files with known answers.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use coface::CellId;
use coface::algebra::chains::{ChainComplex, ProductComplex};
use coface::algebra::{Integer, RaggedArray, Sign};
use coface::complexes::grids::{AxisSet, CuboidGrid, GridCell, product};
use coface::complexes::known_spaces;
use coface::complexes::lar::LarModel;
use coface::complexes::simplicial::{FrozenComplex, Prism, SignedSimplices, SimplicialGrid, extrude, facets};
use coface::geometry::Positions;
use coface::io::read_path;
use coface::topology::homology;
use proptest::prelude::*;
use serde_json::Value;

fn betti(complex: &ChainComplex) -> Vec<usize> {
    let mut numbers = homology(complex).betti_numbers();
    while numbers.pop_if(|last| *last == 0).is_some() {}
    numbers
}

fn simplicial_betti(simplices: &RaggedArray) -> Vec<usize> {
    betti(&FrozenComplex::from_facets(simplices).unwrap().chain_complex().unwrap())
}

/// All faces of some cells of one dimension, by degree.
fn closure(grid: &CuboidGrid, dimension: usize, cells: Vec<CellId>) -> Vec<Vec<CellId>> {
    let mut levels = vec![cells];
    for degree in (1..=dimension).rev() {
        let last = levels.last().unwrap();
        let mut below: Vec<CellId> =
            last.iter().flat_map(|&cell| grid.facets(degree, cell)).map(|(facet, _)| facet).collect();
        below.sort_unstable();
        below.dedup();
        levels.push(below);
    }
    levels.reverse();
    levels
}

#[test]
fn the_boundary_of_a_grid_is_a_sphere() {
    for shape in [&[3][..], &[2, 3], &[3, 2, 2], &[2, 1, 2, 1], &[1, 1, 1, 1, 1]] {
        let grid = CuboidGrid::new(shape).unwrap();
        let complex = grid.chain_complex().unwrap();
        assert_eq!(betti(&complex), [1]);
        let facets = grid.boundary_facets().into_iter().map(|(facet, _)| facet).collect();
        let sphere = complex.subcomplex(&closure(&grid, shape.len() - 1, facets)).unwrap();
        let mut expected = vec![0; shape.len()];
        expected[0] += 1;
        expected[shape.len() - 1] += 1;
        assert_eq!(betti(&sphere), expected, "{shape:?}");
    }
}

#[test]
fn gaps_make_parts_and_missing_cells_make_holes() {
    for dimension in 1..=4 {
        let grid = CuboidGrid::with_lengths(&vec![vec![1.0, -1.0, 1.0]; dimension]).unwrap();
        assert_eq!(betti(&grid.chain_complex().unwrap()), [1 << dimension]);
        assert_eq!(grid.boundary_facets().len(), (2 * dimension) << dimension);
    }
    // A block without its inner cell, and a block without a row of cells through it.
    let grid = CuboidGrid::new(&[3, 3, 3]).unwrap();
    let complex = grid.chain_complex().unwrap();
    let without = |is_missing: &dyn Fn(&GridCell) -> bool| {
        let kept = (0..27).map(CellId::new).filter(|&cell| !is_missing(&grid.cell(3, cell))).collect();
        betti(&complex.subcomplex(&closure(&grid, 3, kept)).unwrap())
    };
    assert_eq!(without(&|cell| cell.corner() == [1, 1, 1]), [1, 0, 1]);
    assert_eq!(without(&|cell| cell.corner()[..2] == [1, 1]), [1, 1]);
    let crossing = |cell: &GridCell| cell.corner().iter().filter(|&&place| place == 1).count() >= 2;
    assert_eq!(without(&crossing), [1, 5]);
}

#[test]
fn the_walls_of_a_grid_bound_its_cells() {
    // The 2-skeleton of a block of cubes has a hollow for each cube.
    let grid = CuboidGrid::new(&[3, 2, 4]).unwrap();
    let complex = grid.chain_complex().unwrap();
    let walls = (0..grid.cell_count(2)).map(CellId::new).collect();
    let skeleton = complex.subcomplex(&closure(&grid, 2, walls)).unwrap();
    assert_eq!(betti(&skeleton), [1, 0, 24]);
    let corner = GridCell::new(AxisSet::from_iter([0, 1, 2]), vec![2, 1, 3]);
    assert_eq!(grid.number(&corner), Some(CellId::new(23)));
}

#[test]
fn three_ways_to_fill_a_block_agree() {
    for shape in [&[4][..], &[3, 2], &[2, 3, 2], &[1, 2, 1, 2]] {
        let cells = CuboidGrid::new(shape).unwrap();
        let kuhn = cells.simplices().unwrap();
        let grid = SimplicialGrid::new(shape).unwrap();
        let swept = grid.simplices().unwrap();
        assert_eq!(kuhn.len(), swept.len(), "{shape:?}");
        assert_eq!(simplicial_betti(kuhn.lists()), [1]);
        assert_eq!(simplicial_betti(swept.lists()), [1]);
        let outside =
            |simplices: &SignedSimplices| facets(&simplices.to_oriented()).unwrap().boundary_facets();
        assert_eq!(outside(&kuhn).len(), outside(&swept).len());
        assert_eq!(outside(&swept).len(), grid.boundary_facets().unwrap().len());
    }
}

#[test]
fn prisms_over_known_spaces() {
    for space in [
        known_spaces::circle(5),
        known_spaces::torus_grid(&[3, 3]),
        known_spaces::klein_grid(4, 3),
        known_spaces::projective_plane(),
        known_spaces::dunce_hat(),
        known_spaces::simplex_boundary(4),
        known_spaces::moore_space(3),
    ] {
        let base = space.unwrap().freeze();
        let (prism, own) = (Prism::new(&base).unwrap(), base.chain_complex().unwrap());
        let (around, expected) = (homology(&prism.chain_complex().unwrap()), homology(&own));
        let count = expected.betti_numbers().len();
        assert_eq!(around.betti_numbers()[..count], expected.betti_numbers());
        assert_eq!(around.torsion()[..count], expected.torsion());
        // The operator in matrices: boundary of the prism, less the prism over the boundary, is top less bottom up to sign.
        for degree in 0..own.degree_count() {
            let matrix = prism.matrix(degree).unwrap();
            let chains = prism.chain_complex().unwrap();
            let boundary = chains.boundary_matrix(degree + 1).unwrap();
            let around = boundary.product(matrix).unwrap().into_wide();
            let sides = match own.boundary_matrix(degree) {
                Some(boundary) => {
                    let sides = prism.matrix(degree - 1).unwrap().product(boundary).unwrap().into_wide();
                    around.difference(&sides).unwrap().into_wide()
                }
                None => around,
            };
            let [top, bottom] = [prism.top(), prism.bottom()].map(|map| map.matrix(degree).unwrap());
            let ends = if degree % 2 == 0 { top.difference(bottom) } else { bottom.difference(top) };
            assert_eq!(sides, ends.unwrap().into_wide());
        }
    }
}

#[test]
fn products_of_models_have_the_homology_of_products() {
    // A hexagon times a square, both hollow: a torus of quadrangles. Times a triangle: a solid torus of wedges.
    let cycle = |n: u32| {
        let edges = RaggedArray::from_lists((0..n).map(|i| [i, (i + 1) % n]));
        LarModel::new(n as usize, vec![edges]).unwrap()
    };
    let torus = cycle(6).product(&cycle(4)).unwrap();
    assert_eq!(torus.f_vector(), [24, 48, 24]);
    let triangle =
        LarModel::new(3, vec![cycle(3).cells(1).into_owned(), RaggedArray::from_lists([[0, 1, 2]])]).unwrap();
    let solid = cycle(6).product(&triangle).unwrap();
    assert_eq!(solid.f_vector(), [18, 36, 24, 6]);
    assert!(solid.facets(3).unwrap().iter().all(|facets| facets.len() == 5));
    let circle = |n: u32| {
        let ends = (0..n as usize).flat_map(|i| [(i, i, -1), ((i + 1) % n as usize, i, 1)]);
        let matrix = coface::algebra::SparseMatrix::from_entries(n as usize, n as usize, ends).unwrap();
        ChainComplex::new(vec![matrix]).unwrap()
    };
    let complex = ProductComplex::new(&circle(6), &circle(4)).unwrap().into_complex();
    assert_eq!(complex.f_vector(), torus.f_vector());
    assert_eq!(betti(&complex), [1, 2, 1]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// The volume of a product of boxes is the product, and cells with positions keep it.
    #[test]
    fn products_keep_lengths(a in prop::collection::vec(0.25f64..3.0, 1..4), b in prop::collection::vec(0.25f64..3.0, 1..4)) {
        let line = |lengths: &[f64]| CuboidGrid::with_lengths(&[lengths]).unwrap().placed_cells(1).unwrap();
        let plane = product(&line(&a), &line(&b)).unwrap();
        let area = |cell: &[u32]| {
            let point = |v: u32| plane.positions().point(coface::VertexId::from_u32(v));
            let (low, high) = (point(cell[0]), point(cell[3]));
            (high[0] - low[0]) * (high[1] - low[1])
        };
        let total: f64 = plane.cells().iter().map(area).sum();
        let expected = a.iter().sum::<f64>() * b.iter().sum::<f64>();
        prop_assert!((total - expected).abs() < 1e-12 * expected);
    }
}

/// The small triangle meshes of the data, with their records.
fn triangle_meshes() -> Vec<(Value, Positions, RaggedArray)> {
    let Some(data) = std::env::var_os("COFACE_DATA").map(std::path::PathBuf::from) else {
        println!("skipped: COFACE_DATA names no folder");
        return Vec::new();
    };
    let manifest = std::fs::read_to_string(data.join("MANIFEST.json")).expect("the data has a manifest");
    let manifest: Value = serde_json::from_str(&manifest).expect("the manifest is JSON");
    let mut found = Vec::new();
    for record in manifest["files"].as_array().expect("the manifest lists files") {
        let file = record["file"].as_str().expect("a record names its file");
        let is_small = record["faces"].as_u64().is_some_and(|faces| (1..1300).contains(&faces));
        let is_whole = ["isolated_vertices", "duplicate_faces", "degenerate_index_faces"]
            .iter()
            .all(|key| record[*key].as_u64() == Some(0));
        let is_triangles = record["face_sizes"].as_object().is_some_and(|sizes| sizes.keys().eq(["3"]));
        if file.starts_with("surfaces/") && is_small && is_whole && is_triangles {
            let model = read_path(data.join(file), None).unwrap_or_else(|error| panic!("{error}"));
            found.push((record.clone(), model.positions().clone(), model.polygons().clone()));
        }
    }
    assert!(found.len() >= 5, "the data has small triangle meshes");
    found
}

#[test]
fn extruded_meshes_keep_their_homology() {
    for (record, positions, triangles) in triangle_meshes() {
        let file = &record["file"];
        let count = positions.len();
        let slab = extrude(count, &triangles, &[0.5]).unwrap();
        assert_eq!(slab.vertex_count(), 2 * count, "{file}");
        assert_eq!(slab.simplices().len(), 3 * triangles.len(), "{file}");
        let placed = slab.placed_cells(&positions).unwrap();
        assert_eq!(placed.positions().dimension(), positions.dimension() + 1, "{file}");
        let expected: Vec<usize> =
            record["betti"].as_array().unwrap().iter().map(|b| b.as_u64().unwrap() as usize).collect();
        let trimmed = |betti: &[usize]| {
            let end = betti.iter().rposition(|&b| b > 0).map_or(0, |last| last + 1);
            betti[..end].to_vec()
        };
        assert_eq!(simplicial_betti(slab.simplices().lists()), trimmed(&expected), "{file}");
        // The outside: both ends, and two triangles over each edge of only one triangle.
        let rim = facets(&triangles).unwrap().boundary_facets().len();
        let table = facets(placed.cells()).unwrap();
        let outside = table.boundary_facets();
        assert_eq!(outside.len(), 2 * triangles.len() + 2 * rim, "{file}");
        if record["coherently_oriented"] == true {
            // In the sum of all tetrahedra the inner facets cancel.
            let complex = ChainComplex::new(vec![table.boundary_matrix().clone()]).unwrap();
            let all = (0..placed.cell_count()).map(|i| (CellId::new(i), Integer::ONE));
            let chain = coface::algebra::chains::Chain::new(&complex, 1, all).unwrap();
            let boundary = complex.boundary(&chain).unwrap();
            let signs = boundary
                .terms()
                .iter()
                .map(|(_, x)| if *x == Integer::ONE { Sign::Plus } else { Sign::Minus });
            assert!(signs.eq(outside.signs().iter().copied()), "{file}");
            let on_outside = boundary.terms().iter().map(|(facet, _)| table.facets().list(facet.index()));
            assert!(on_outside.eq(outside.lists().iter()), "{file}");
        }
        let towers = extrude(count, &triangles, &[1.0, -1.0, 2.0, 0.5]).unwrap();
        let doubled: Vec<usize> = trimmed(&expected).iter().map(|b| 2 * b).collect();
        if triangles.len() < 100 {
            assert_eq!(simplicial_betti(towers.simplices().lists()), doubled, "{file}");
        }
        assert_eq!(towers.simplices().len(), 9 * triangles.len(), "{file}");
    }
}
