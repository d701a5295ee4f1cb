#![allow(clippy::unwrap_used, reason = "tests")]

use super::{AxisSet, CuboidGrid, GridCell};
use coface_algebra::chains::{Chain, ChainComplex, ProductComplex};
use coface_algebra::{CellId, ErrorKind, VertexId};
use coface_algebra::{Integer, SparseMatrix};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// A cell as it is seen: for each axis whether it extends, and its lower line.
type Seen = (Vec<bool>, Vec<u32>);

/// All faces of all top cells by dimension, in the order of the conventions; found by closing under facets.
fn seen_cells(lengths: &[Vec<f64>]) -> Vec<Vec<Seen>> {
    let whole: Vec<bool> = lengths.iter().map(|axis| !axis.is_empty()).collect();
    let mut tops = vec![Vec::new()];
    for axis in lengths {
        let places: Vec<u32> = if axis.is_empty() {
            vec![0]
        } else {
            (0..axis.len() as u32).filter(|&i| axis[i as usize] > 0.0).collect()
        };
        tops = tops
            .iter()
            .flat_map(|corner: &Vec<u32>| {
                places.iter().map(move |&place| corner.iter().copied().chain([place]).collect())
            })
            .collect();
    }
    if tops.is_empty() {
        return Vec::new();
    }
    let mut levels = vec![BTreeSet::from_iter(tops.into_iter().map(|corner| (whole.clone(), corner)))];
    while levels.last().unwrap().iter().any(|(extent, _)| extent.contains(&true)) {
        let below = levels.last().unwrap().iter().flat_map(|cell| seen_facets(cell).map(|(facet, _)| facet));
        levels.push(below.collect());
    }
    levels.into_iter().rev().map(|level| level.into_iter().collect()).collect()
}

/// The lower and upper facets across each axis with the signs of a product.
fn seen_facets((extent, corner): &Seen) -> impl Iterator<Item = (Seen, i32)> {
    let mut sign = -1;
    let mut facets = Vec::new();
    for axis in (0..extent.len()).filter(|&axis| extent[axis]) {
        let mut flat = extent.clone();
        flat[axis] = false;
        facets.push(((flat.clone(), corner.clone()), sign));
        let mut upper = corner.clone();
        upper[axis] += 1;
        facets.push(((flat, upper), -sign));
        sign = -sign;
    }
    facets.into_iter()
}

fn seen_vertices((extent, corner): &Seen) -> Vec<Vec<u32>> {
    let mut vertices = vec![Vec::new()];
    for axis in 0..extent.len() {
        let lines = corner[axis]..=corner[axis] + u32::from(extent[axis]);
        vertices = vertices
            .iter()
            .flat_map(|start: &Vec<u32>| {
                lines.clone().map(move |line| start.iter().copied().chain([line]).collect())
            })
            .collect();
    }
    vertices
}

fn grid_cell((extent, corner): &Seen) -> GridCell {
    GridCell::new((0..extent.len()).filter(|&axis| extent[axis]).collect(), corner.clone())
}

fn check_by_sight(grid: &CuboidGrid, lengths: &[Vec<f64>]) {
    let seen = seen_cells(lengths);
    assert_eq!(grid.f_vector(), seen.iter().map(Vec::len).collect::<Vec<_>>());
    let complex = grid.chain_complex().unwrap();
    assert_eq!(complex.f_vector(), grid.f_vector());
    let points: Vec<&Vec<u32>> = seen.iter().take(1).flatten().map(|(_, corner)| corner).collect();
    let positions = grid.positions().unwrap();
    for (v, corner) in points.iter().enumerate().filter(|_| !lengths.is_empty()) {
        let expected: Vec<f64> = lengths
            .iter()
            .zip(*corner)
            .map(|(axis, &line)| axis[..line as usize].iter().fold(0.0, |sum, length| sum + length.abs()))
            .collect();
        assert_eq!(positions.point(VertexId::new(v)), expected);
    }
    for (p, cells) in seen.iter().enumerate() {
        let lists = grid.cells(p).unwrap();
        let matrix = grid.boundary_matrix(p).unwrap();
        let above = grid.boundary_matrix(p + 1).unwrap().transpose();
        assert_eq!(lists.len(), cells.len());
        for (i, cell) in cells.iter().enumerate() {
            let id = CellId::new(i);
            assert_eq!(grid.cell(p, id), grid_cell(cell));
            assert_eq!(grid.number(&grid_cell(cell)), Some(id));
            let vertices: Vec<u32> = seen_vertices(cell)
                .iter()
                .map(|vertex| points.binary_search(&vertex).unwrap() as u32)
                .collect();
            assert_eq!(lists.list(i), vertices);
            assert_eq!(grid.vertices(p, id), vertices);
            let terms = |facets: Vec<(CellId, coface_algebra::Sign)>| {
                facets.into_iter().map(|(cell, sign)| (cell.index(), sign.to_i32())).collect::<Vec<_>>()
            };
            if p > 0 {
                let mut facets: Vec<(usize, i32)> = seen_facets(cell)
                    .map(|(facet, sign)| (seen[p - 1].binary_search(&facet).unwrap(), sign))
                    .collect();
                facets.sort_unstable();
                assert_eq!(matrix.column(i).iter().collect::<Vec<_>>(), facets);
                assert_eq!(terms(grid.facets(p, id)), facets);
            }
            assert_eq!(terms(grid.cofaces(p, id)), above.column(i).iter().collect::<Vec<_>>());
        }
    }
    if let Some(dimension) = grid.dimension().filter(|&dimension| dimension > 0) {
        let all = (0..grid.cell_count(dimension)).map(|i| (CellId::new(i), Integer::ONE));
        let boundary = complex.boundary(&Chain::new(&complex, dimension, all).unwrap()).unwrap();
        let found = grid.boundary_facets().into_iter();
        let found: Vec<_> = found.map(|(cell, sign)| (cell, Integer::from(sign.to_i32()))).collect();
        assert_eq!(boundary.terms(), found);
        let mut uses: BTreeMap<Seen, usize> = BTreeMap::new();
        for (facet, _) in seen[dimension].iter().flat_map(seen_facets) {
            *uses.entry(facet).or_default() += 1;
        }
        assert_eq!(found.len(), uses.values().filter(|&&count| count == 1).count());
    } else {
        assert!(grid.boundary_facets().is_empty());
    }
}

/// The complex of one axis without numbers of lines: points and full intervals.
fn axis_complex(lengths: &[f64]) -> ChainComplex {
    let full: Vec<u32> = (0..lengths.len() as u32).filter(|&i| lengths[i as usize] > 0.0).collect();
    let mut lines: Vec<u32> = full.iter().flat_map(|&i| [i, i + 1]).collect();
    lines.dedup();
    if full.is_empty() {
        return ChainComplex::of_points(1);
    }
    let ends = full.iter().enumerate().flat_map(|(j, i)| {
        let at = lines.binary_search(i).unwrap();
        [(at, j, -1), (at + 1, j, 1)]
    });
    ChainComplex::new(vec![SparseMatrix::from_entries(lines.len(), full.len(), ends).unwrap()]).unwrap()
}

fn lengths() -> impl Strategy<Value = Vec<Vec<f64>>> {
    let length = prop_oneof![3 => Just(1.0), 2 => Just(0.25), 2 => Just(-1.5)];
    prop::collection::vec(prop::collection::vec(length, 0..4), 0..4)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn grids_are_what_is_seen(lengths in lengths()) {
        check_by_sight(&CuboidGrid::with_lengths(&lengths).unwrap(), &lengths);
    }

    #[test]
    fn full_grids_are_what_is_seen(shape in prop::collection::vec(0u32..3, 0..5)) {
        let lengths: Vec<Vec<f64>> = shape.iter().map(|&count| vec![1.0; count as usize]).collect();
        let grid = CuboidGrid::new(&shape).unwrap();
        check_by_sight(&grid, &lengths);
        prop_assert_eq!(grid.chain_complex().unwrap().euler_characteristic(), 1);
    }

    #[test]
    fn grids_are_products_of_their_axes(lengths in lengths()) {
        let grid = CuboidGrid::with_lengths(&lengths).unwrap();
        prop_assume!(grid.dimension().is_some());
        // For each cell of the product so far: its extent and its place along each axis.
        let mut product = ChainComplex::of_points(1);
        let mut places: Vec<Vec<(AxisSet, Vec<usize>)>> = vec![vec![(AxisSet::default(), Vec::new())]];
        for (axis, lengths) in lengths.iter().enumerate() {
            let next = ProductComplex::new(&product, &axis_complex(lengths)).unwrap();
            places = (0..next.complex().degree_count()).map(|degree| {
                (0..next.complex().cell_count(degree)).map(|cell| {
                    let [(p, a), (q, b)] = next.factors(degree, CellId::new(cell));
                    let (mut extent, mut place) = places[p][a.index()].clone();
                    if q == 1 {
                        extent = extent.with(axis);
                    }
                    place.push(b.index());
                    (extent, place)
                }).collect()
            }).collect();
            product = next.into_complex();
        }
        // The two differ by the order of the cells only.
        let numbers: Vec<Vec<usize>> = places.iter().map(|cells| {
            let mut order: Vec<usize> = (0..cells.len()).collect();
            order.sort_by_key(|&i| &cells[i]);
            let mut numbers = vec![0; order.len()];
            order.iter().enumerate().for_each(|(new, &old)| numbers[old] = new);
            numbers
        }).collect();
        for degree in 1..=grid.dimension().unwrap() {
            let matrix = product.boundary_matrix(degree).unwrap();
            let renumbered = SparseMatrix::from_entries(
                matrix.row_count(),
                matrix.column_count(),
                matrix.columns().enumerate().flat_map(|(j, column)| {
                    let numbers = &numbers;
                    column.iter().map(move |(i, entry)| {
                        (numbers[degree - 1][i], numbers[degree][j], i64::from(entry))
                    })
                }),
            ).unwrap();
            prop_assert_eq!(renumbered, grid.boundary_matrix(degree).unwrap());
        }
    }
}

#[test]
fn counts_follow_the_formula() {
    for (shape, expected) in [
        (&[1, 1, 1][..], &[8, 12, 6, 1][..]),
        (&[2, 1, 1], &[12, 20, 11, 2]),
        (&[3, 2, 1], &[24, 46, 29, 6]),
        (&[2, 2], &[9, 12, 4]),
        (&[1, 1, 1, 1, 1], &[32, 80, 80, 40, 10, 1]),
        (&[100, 100, 100], &[1_030_301, 3_060_300, 3_030_000, 1_000_000]),
    ] {
        assert_eq!(CuboidGrid::new(shape).unwrap().f_vector(), expected);
    }
}

#[test]
fn the_cube_has_its_faces_in_order() {
    let cube = CuboidGrid::new(&[1, 1, 1]).unwrap();
    let faces = cube.cells(2).unwrap();
    let expected = [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 4, 5], [2, 3, 6, 7], [0, 2, 4, 6], [1, 3, 5, 7]];
    assert!(faces.iter().eq(expected));
    assert_eq!(cube.cells(3).unwrap().items(), [0, 1, 2, 3, 4, 5, 6, 7]);
    assert!(cube.cells(4).unwrap().is_empty());
    assert!(cube.cells(64).unwrap().is_empty());
}

#[test]
fn grids_that_do_not_fit_are_refused() {
    let kind = |shape: &[u32]| CuboidGrid::new(shape).map(|_| ()).map_err(|error| error.kind());
    assert_eq!(kind(&[u32::MAX]), Err(ErrorKind::TooLarge));
    assert_eq!(kind(&[u32::MAX - 1]), Ok(()));
    assert_eq!(kind(&[2000, 2000, 2000]), Err(ErrorKind::TooLarge));
    assert_eq!(kind(&[1; 21]), Ok(()));
    assert_eq!(kind(&[1; 22]), Err(ErrorKind::TooLarge));
    assert_eq!(kind(&[0; 32]), Ok(()));
    assert_eq!(kind(&[0; 33]), Err(ErrorKind::TooLarge));
    let line = CuboidGrid::new(&[u32::MAX - 1]).unwrap();
    assert_eq!(line.cells(1).unwrap_err().kind(), ErrorKind::TooLarge);
    assert_eq!(line.boundary_matrix(1).unwrap_err().kind(), ErrorKind::TooLarge);
    assert_eq!(line.vertices(1, CellId::from_u32(u32::MAX - 2)), [u32::MAX - 2, u32::MAX - 1]);
}

#[test]
fn lengths_must_lead_on() {
    for bad in [&[1.0, 0.0][..], &[f64::NAN], &[1.0, f64::INFINITY], &[1e300, 1.0], &[f64::MAX, f64::MAX]] {
        let error = CuboidGrid::with_lengths(&[vec![1.0], bad.to_vec()]).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::InvalidInput);
        assert!(error.message().contains("axis 1"), "{error}");
    }
    assert_eq!(CuboidGrid::with_lengths(&[[-1.0, -2.0]]).unwrap().dimension(), None);
}

#[test]
fn places_that_are_no_cells_have_no_number() {
    let grid = CuboidGrid::with_lengths(&[vec![1.0, -1.0, -1.0, 1.0], vec![1.0]]).unwrap();
    let number = |axes: &[usize], corner: &[u32]| {
        grid.number(&GridCell::new(axes.iter().copied().collect(), corner.to_vec()))
    };
    assert!(number(&[0, 1], &[0, 0]).is_some());
    assert_eq!(number(&[0, 1], &[1, 0]), None);
    assert_eq!(number(&[1], &[2, 0]), None, "the line between two empty intervals carries no cell");
    assert!(number(&[1], &[3, 0]).is_some());
    assert_eq!(number(&[1], &[3, 1]), None);
    assert_eq!(number(&[1], &[3]), None);
    assert_eq!(number(&[2], &[3, 0]), None);
}
