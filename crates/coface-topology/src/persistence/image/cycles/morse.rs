//! The critical cells of an image as a chain complex that grows.

use super::super::descent::Sum;
use super::super::filtration::ImageFiltration;
use super::super::gradient::{Cell, Gradient};
use super::super::grid::Grid;
use super::flow::{highest, lowest};
use crate::persistence::Filtration;
use crate::persistence::torsion::Small;
use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error, ErrorKind, SparseMatrix};
use rayon::prelude::*;

/// So many critical cells flow down in one go.
const BATCH: usize = 256;

/// An entry of a boundary matrix: face, cell, coefficient.
type Entry = (usize, usize, i64);

/// The critical cells as the cells of a complex, with integral boundaries. Of a dual image they are the dual cells: degrees are counted from the other end, and
/// they enter in the opposite order.
pub(super) struct Morse<'a> {
    gradient: &'a Gradient,
    is_dual: bool,
    pub(super) complex: ChainComplex,
    pub(super) filtration: Filtration,
}

impl<'a> Morse<'a> {
    pub(super) fn new(image: &ImageFiltration, gradient: &'a Gradient) -> Result<Self, Error> {
        let (axes, is_dual) = (gradient.grid.axes(), image.is_dual());
        let mut matrices = Vec::with_capacity(axes);
        for degree in 1..=axes {
            let entries = if degree == 1 {
                edges(gradient)
            } else if degree == axes {
                facets(gradient)
            } else {
                boundaries(gradient, degree)?
            };
            let (cells, faces) = (gradient.critical[degree].len(), gradient.critical[degree - 1].len());
            matrices.push(match is_dual {
                false => SparseMatrix::from_entries(faces, cells, entries)?,
                true => {
                    // Cells are numbered as the dual ones enter.
                    let turned =
                        entries.into_iter().map(|(face, cell, x)| (cells - 1 - cell, faces - 1 - face, x));
                    SparseMatrix::from_entries(cells, faces, turned)?
                }
            });
        }
        let value = |cell: &Cell| image.value(gradient.grid.voxel_of_vertex(gradient.vertex(cell.rank())));
        let mut values: Vec<Vec<f64>> =
            gradient.critical.iter().map(|cells| cells.iter().map(value).collect()).collect();
        if is_dual {
            matrices.reverse();
            values.reverse();
            values.iter_mut().for_each(|values| values.reverse());
        }
        let order = values.iter().map(|values| (0..values.len() as u32).collect()).collect();
        let complex = ChainComplex::from_trusted_boundaries(matrices);
        let filtration = match image.is_falling() {
            true => Filtration::falling_in_order(&complex, values, order)?,
            false => Filtration::in_order(&complex, values, order)?,
        };
        Ok(Self { gradient, is_dual, complex, filtration })
    }

    /// The degree in the grid of the cells of a degree.
    pub(super) fn grid_degree(&self, degree: usize) -> usize {
        if self.is_dual { self.gradient.grid.axes() - degree } else { degree }
    }

    /// A cell of the complex as that of the grid.
    pub(super) fn cell(&self, degree: usize, cell: CellId) -> Cell {
        let cells = &self.gradient.critical[self.grid_degree(degree)];
        cells[if self.is_dual { cells.len() - 1 - cell.index() } else { cell.index() }]
    }
}

/// The boundaries of critical edges: each end flows to one vertex.
fn edges(gradient: &Gradient) -> Vec<Entry> {
    let grid = &gradient.grid;
    let cells = gradient.critical[1].par_iter().enumerate();
    let ends = |(number, edge): (usize, &Cell)| {
        let vertex = gradient.vertex(edge.rank());
        let other = Grid::opposite(grid.star(vertex), vertex, edge.code());
        // The edge runs from the vertex where it extends behind it.
        let (_, side) = grid.codes.direction(0, edge.code());
        let ends = [(vertex, -i64::from(side)), (other, i64::from(side))];
        ends.into_iter()
            .filter_map(move |(end, x)| Some((gradient.number(0, lowest(gradient, end)?), number, x)))
            .collect::<Vec<_>>()
    };
    cells.flat_map_iter(ends).collect()
}

/// The boundaries of critical top cells, from their facets: the cell on each side of one flows to a single top cell, along facets that cancel.
fn facets(gradient: &Gradient) -> Vec<Entry> {
    let (grid, degree) = (&gradient.grid, gradient.grid.axes());
    let cells = gradient.critical[degree - 1].par_iter().enumerate();
    let beside = |(number, facet): (usize, &Cell)| {
        let vertex = gradient.vertex(facet.rank());
        let axis = grid.codes.flat_axis(facet.code()).expect("a facet is flat along an axis");
        let star = grid.star(vertex);
        // The facet is the end before of the cell behind it.
        let sign = if axis % 2 == 1 { -1 } else { 1 };
        let sides = [(1, -sign), (-1, sign)];
        sides
            .into_iter()
            .filter_map(move |(side, x)| {
                let base = Grid::base(star, vertex, grid.codes.extended(facet.code(), axis, side));
                Some((number, gradient.number(degree, highest(gradient, base)?), x))
            })
            .collect::<Vec<_>>()
    };
    cells.flat_map_iter(beside).collect()
}

/// The boundaries of critical cells of any other degree.
fn boundaries(gradient: &Gradient, degree: usize) -> Result<Vec<Entry>, Error> {
    let cells = &gradient.critical[degree];
    let steps = stage("following boundaries", cells.len());
    let batches: Vec<Option<Vec<Entry>>> = cells
        .par_chunks(BATCH)
        .enumerate()
        .map(|(batch, cells)| {
            let integers = Small::default();
            let mut sum = Sum::new(&integers, gradient);
            let mut entries = Vec::new();
            for (number, &cell) in (batch * BATCH..).zip(cells) {
                sum.add_boundary(cell, 1);
                sum.descend(
                    |_| true,
                    |face, x| entries.push((gradient.number(degree - 1, face), number, i64::from(x))),
                );
            }
            steps.advance(cells.len());
            (!integers.is_left()).then_some(entries)
        })
        .collect();
    let mut entries = Vec::new();
    for batch in batches {
        entries.extend(batch.ok_or_else(|| {
            Error::new(ErrorKind::TooLarge, "a boundary along the gradient has coefficients beyond 32 bits")
                .with_cure("ask for the diagram without cycles")
        })?);
    }
    Ok(entries)
}
