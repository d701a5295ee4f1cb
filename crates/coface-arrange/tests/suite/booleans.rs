//! Boolean combinations of boxes on conforming grids, against sets of unit cubes.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::solids::{rod_through_cube, shifted_cubes};
use coface_algebra::SparseMatrix;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, ErrorKind};
use coface_arrange::boolean::{BooleanFormula, CellSelection, InsideRule, WindingNumbers};
use coface_arrange::spatial::SpatialCells;
use coface_complexes::grids::CuboidGrid;
use proptest::prelude::*;

/// The boundaries of chains of cells.
fn boundaries(complex: &ChainComplex, chains: &[Vec<i64>]) -> SparseMatrix {
    let matrix = complex.boundary_matrix(complex.degree_count() - 1).unwrap();
    let terms = chains.iter().enumerate().flat_map(|(input, chain)| {
        chain.iter().enumerate().flat_map(move |(cell, &coefficient)| {
            matrix
                .column(cell)
                .iter()
                .map(move |(facet, entry)| (facet, input, coefficient * i64::from(entry)))
        })
    });
    SparseMatrix::from_entries(matrix.row_count(), chains.len(), terms).unwrap()
}

#[test]
fn shifted_cubes_combine() {
    let faces = shifted_cubes();
    let cells = faces.cells();
    let complex = cells.chain_complex().unwrap();
    let volumes = cells.volumes(&faces.positions()).unwrap();
    // The common part is behind the face of the first cube that is inside the second, and in front of that of the second.
    let common = volumes.iter().position(|&volume| volume < 0.5).unwrap();
    let first = cells.cell_at(coface_algebra::FaceId::new(0), coface_algebra::Sign::Plus);
    let first =
        first.or(cells.cell_at(coface_algebra::FaceId::new(0), coface_algebra::Sign::Minus)).unwrap().index();
    let chain = |cells: [usize; 2]| (0..3).map(|cell| i64::from(cells.contains(&cell))).collect::<Vec<_>>();
    let second = 3 - common - first;
    let inputs = boundaries(&complex, &[chain([common, first]), chain([common, second])]);
    let winding = WindingNumbers::new(&complex, &inputs).unwrap();
    assert_eq!(winding.of_cell(CellId::new(common)), [1, 1]);
    assert_eq!(winding.inputs_around(CellId::new(second), InsideRule::Nonzero).collect::<Vec<_>>(), [1]);
    for (text, volume, facet_count, wall_count) in
        [("a | b", 1.875, 12, 6), ("a & b", 0.125, 6, 0), ("a - b", 0.875, 9, 0), ("a ^ b", 1.75, 18, 0)]
    {
        let formula = BooleanFormula::parse(text, &[]).unwrap();
        let selection = CellSelection::by_formula(&winding, &formula, InsideRule::Nonzero).unwrap();
        let sum: f64 = selection.cells().map(|cell| volumes[cell.index()]).sum();
        let boundary = selection.boundary(&complex).unwrap();
        assert_eq!(sum, volume, "{text}");
        assert_eq!((boundary.facets().len(), boundary.walls().len()), (facet_count, wall_count), "{text}");
        // The two parts of the symmetric difference touch along the edges where the surfaces cross.
        assert_eq!(boundary.is_manifold(), text != "a ^ b");
    }
    let outside = BooleanFormula::parse("!(a | b)", &[]).unwrap();
    let selection = CellSelection::by_formula(&winding, &outside, InsideRule::Odd).unwrap();
    assert!(selection.has_exterior() && selection.cells().next().is_none());
    assert_eq!(selection.boundary(&complex).unwrap().facets().len(), 12);
    let missing = BooleanFormula::parse("a | c", &[]).unwrap();
    assert!(CellSelection::by_formula(&winding, &missing, InsideRule::Odd).is_err());
}

#[test]
fn open_inputs_are_named_with_their_rim() {
    let faces = rod_through_cube();
    let cells: SpatialCells = faces.cells();
    let complex = cells.chain_complex().unwrap();
    // A face with a hole: a walk around one of its two rims.
    let open = SparseMatrix::from_entries(22, 1, [(0, 0, 1)]).unwrap();
    let error = WindingNumbers::new(&complex, &open).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::NotACycle);
    let rim: Vec<usize> = error.message().split(" e").skip(1).map(|number| number.parse().unwrap()).collect();
    assert_eq!(rim.len(), 4, "{error}");
    let ends = |edge: usize| complex.boundary_matrix(1).unwrap().column(edge).rows().to_vec();
    for i in 0..4 {
        let (here, next) = (ends(rim[i]), ends(rim[(i + 1) % 4]));
        assert!(here.iter().any(|vertex| next.contains(vertex)), "{error}");
    }
    // All cells missing: a closed input bounds nothing.
    let closed = boundaries(&complex, &[vec![1, 0, 0, 0]]);
    let hollow = ChainComplex::new(vec![
        complex.boundary_matrix(1).unwrap().clone(),
        complex.boundary_matrix(2).unwrap().clone(),
        SparseMatrix::zero(22, 0).unwrap(),
    ]);
    assert_eq!(WindingNumbers::new(&hollow.unwrap(), &closed).unwrap_err().kind(), ErrorKind::Shape);
}

/// The vertices and edges of the boundary of a set of unit cubes or squares where it is pinched, by looking at what is around them:
/// for an edge the four cubes, for a vertex the eight, their number of parts and that of the rest.
fn slow_pinches(grid: &CuboidGrid, size: i32, inside: &[bool]) -> (Vec<usize>, Vec<usize>) {
    let at = |place: [i32; 3]| {
        let is_place = place.iter().all(|x| (0..size).contains(x));
        is_place && inside[place.iter().fold(0, |number, &x| number * size as usize + x as usize)]
    };
    let edges = (0..grid.cell_count(1)).filter(|&edge| {
        let cell = grid.cell(1, CellId::new(edge));
        let axis = (0..3).find(|&axis| cell.extent().contains(axis)).unwrap();
        let corner = [0, 1, 2].map(|i| cell.corner()[i] as i32);
        let around = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[u, v]| {
            let mut place = corner;
            place[(axis + 1) % 3] -= u;
            place[(axis + 2) % 3] -= v;
            at(place)
        });
        around[0] == around[2] && around[1] == around[3] && around[0] != around[1]
    });
    let vertices = (0..grid.cell_count(0)).filter(|&vertex| {
        let cell = grid.cell(0, CellId::new(vertex));
        let corner = [0, 1, 2].map(|i| cell.corner()[i] as i32);
        let octant = |i: usize| at([0, 1, 2].map(|axis| corner[axis] - (i >> axis & 1) as i32));
        // Quarter faces between neighboring octants that differ; two are joined if they have a half edge in common.
        let quarters: Vec<[usize; 2]> = (0..8)
            .flat_map(|i| (0..3).map(move |axis| [i, i ^ 1 << axis]))
            .filter(|&[i, j]| i < j && octant(i) != octant(j))
            .collect();
        let axis = |[i, j]: [usize; 2]| (i ^ j).trailing_zeros() as usize;
        let joined = |p: [usize; 2], q: [usize; 2]| {
            // The half edge along a third axis, on the same side of the vertex.
            (0..3).any(|k| k != axis(p) && k != axis(q) && p[0] >> k & 1 == q[0] >> k & 1)
        };
        let mut seen = vec![false; quarters.len()];
        let mut stack: Vec<usize> = quarters.first().map(|_| 0).into_iter().collect();
        while let Some(i) = stack.pop() {
            if !std::mem::replace(&mut seen[i], true) {
                stack.extend((0..quarters.len()).filter(|&j| joined(quarters[i], quarters[j])));
            }
        }
        seen.contains(&false)
    });
    (edges.collect(), vertices.collect())
}

proptest! {
    /// Inputs are chains of cubes with multiplicities; formulas on sets of cubes are the second method.
    #[test]
    fn formulas_on_grids_are_those_on_cubes(
        chains in prop::collection::vec(prop::collection::vec(-2i64..3, 27), 3),
        rule in prop::sample::select(vec![InsideRule::Nonzero, InsideRule::Positive, InsideRule::Odd]),
        text in prop::sample::select(vec!["a|b|c", "a&b", "a-b-c", "a^b^c", "(a|b)-c&a", "!a", "!(a&!b)"]),
    ) {
        let grid = CuboidGrid::new(&[3, 3, 3]).unwrap();
        let complex = grid.chain_complex().unwrap();
        let winding = WindingNumbers::new(&complex, &boundaries(&complex, &chains)).unwrap();
        for cell in 0..27 {
            let expected: Vec<i64> = chains.iter().map(|chain| chain[cell]).collect();
            let found = winding.of_cell(CellId::new(cell)).into_iter().map(i64::from);
            prop_assert!(found.eq(expected));
        }
        let formula = BooleanFormula::parse(text, &[]).unwrap();
        let selection = CellSelection::by_formula(&winding, &formula, rule).unwrap();
        let inside: Vec<bool> = (0..27)
            .map(|cell| formula.evaluate(|input| rule.is_inside(chains[input][cell] as i32)))
            .collect();
        prop_assert!((0..27).all(|cell| selection.contains(CellId::new(cell)) == inside[cell]));
        // The boundary of the selection without the exterior is that of its cells.
        let bounded = CellSelection::new(inside.clone(), false);
        let boundary = bounded.boundary(&complex).unwrap();
        let chain = vec![inside.iter().map(|&is_in| i64::from(is_in)).collect::<Vec<_>>()];
        let expected = boundaries(&complex, &chain);
        let found = boundary.facets().iter().map(|&(facet, sign)| (facet.index(), sign.to_i32()));
        prop_assert!(found.eq(expected.column(0).iter()));
        let both = |facet: usize| {
            let cofaces = grid.cofaces(2, CellId::new(facet));
            cofaces.len() == 2 && cofaces.iter().all(|(cell, _)| inside[cell.index()])
        };
        let walls: Vec<CellId> = (0..grid.cell_count(2)).filter(|&facet| both(facet)).map(CellId::new).collect();
        prop_assert_eq!(boundary.walls(), walls);
        let (edges, vertices) = slow_pinches(&grid, 3, &inside);
        let numbers = |cells: &[CellId]| cells.iter().map(|cell| cell.index()).collect::<Vec<_>>();
        prop_assert_eq!(numbers(boundary.pinched_ridges()), edges);
        prop_assert_eq!(numbers(boundary.pinched_vertices()), vertices);
        // The complement has the same boundary, the other way around.
        let rest = CellSelection::new(inside.iter().map(|&is_in| !is_in).collect(), true);
        let opposite = rest.boundary(&complex).unwrap();
        prop_assert!(opposite.facets().iter().zip(boundary.facets()).all(|(x, y)| x.0 == y.0 && x.1 != y.1));
    }
}
