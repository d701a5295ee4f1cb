//! Pairs of critical cells.

use super::descent::Sum;
use super::forest::Forest;
use super::gradient::{Cell, Fate, Gradient, OUTSIDE};
use super::grid::{Code, Grid};
use coface_algebra::Field;
use coface_algebra::progress::stage;
use rayon::prelude::*;

/// A class of the grid: the critical cell that makes it and the one that ends it, if any.
pub(super) type Class = (Cell, Option<Cell>);

/// No cell: of a place that is free.
const NONE: u32 = u32::MAX;

/// The critical cells while they are paired.
pub(super) struct Pairing<'a, F> {
    field: &'a F,
    gradient: &'a Gradient,
    /// For each degree, for each critical cell, whether it has a partner.
    is_paired: Vec<Vec<bool>>,
    /// The classes of each degree.
    classes: Vec<Vec<Class>>,
}

impl<'a, F: Field> Pairing<'a, F> {
    /// The classes of each degree.
    pub(super) fn classes(field: &'a F, gradient: &'a Gradient) -> Vec<Vec<Class>> {
        let axes = gradient.grid.axes();
        let is_paired = gradient.critical.iter().map(|cells| vec![false; cells.len()]).collect();
        let mut pairing = Self { field, gradient, is_paired, classes: vec![Vec::new(); axes + 1] };
        pairing.join_vertices();
        if axes > 1 {
            pairing.join_top_cells();
        }
        for degree in (2..axes).rev() {
            pairing.reduce(degree);
        }
        for (degree, cells) in gradient.critical.iter().enumerate() {
            let left = cells.iter().zip(&pairing.is_paired[degree]).filter(|&(_, &is_paired)| !is_paired);
            pairing.classes[degree].extend(left.map(|(&cell, _)| (cell, None)));
        }
        pairing.classes
    }

    fn pair(&mut self, degree: usize, birth: usize, death: usize) {
        self.is_paired[degree][birth] = true;
        self.is_paired[degree + 1][death] = true;
        let critical = &self.gradient.critical;
        self.classes[degree].push((critical[degree][birth], Some(critical[degree + 1][death])));
    }

    /// Pairs vertices with edges: an edge that joins two trees ends the younger one.
    fn join_vertices(&mut self) {
        let gradient = self.gradient;
        let grid = &gradient.grid;
        let other_end =
            |vertex: usize, code: Code| gradient.ranks[Grid::opposite(grid.star(vertex), vertex, code)];
        // Each vertex hangs under the other end of the edge that it is matched with, which is older.
        let parent = |rank: u32| {
            if rank == OUTSIDE {
                return OUTSIDE;
            }
            let vertex = gradient.vertex(rank);
            match gradient.fate(vertex << grid.axes()) {
                Fate::Up(axis, side) => other_end(vertex, grid.codes.extended(0, axis, side)),
                _ => rank,
            }
        };
        let mut forest =
            Forest::new((0..gradient.vertices.len() as u32 + 1).into_par_iter().map(parent).collect());
        let edges = &gradient.critical[1];
        let steps = stage("joining components", edges.len());
        for (number, edge) in steps.each(edges.iter().enumerate()) {
            let a = forest.root(edge.rank());
            let b = forest.root(other_end(gradient.vertex(edge.rank()), edge.code()));
            if a != b {
                let (old, young) = (a.min(b), a.max(b));
                forest.hang(young, old);
                let birth = gradient.number(0, Cell::new(young, 0));
                self.pair(0, birth, number);
            }
        }
    }

    /// Pairs top cells with their facets, from the last one to enter on: a facet that joins two trees makes the class that the younger one, which
    /// enters first, ends. What lies outside is older than all.
    fn join_top_cells(&mut self) {
        let gradient = self.gradient;
        let grid = &gradient.grid;
        let degree = grid.axes();
        let outside = grid.vertex_count() as u32;
        let or_outside = |base: usize| match gradient.fate(grid.top_place(base)) {
            Fate::Absent => outside,
            _ => base as u32,
        };
        let parent = |base: u32| {
            if base == outside {
                return outside;
            }
            match gradient.fate(grid.top_place(base as usize)) {
                Fate::Down(axis, side) => or_outside(grid.next(base as usize, axis, -side)),
                _ => base,
            }
        };
        let mut forest = Forest::new((0..outside + 1).into_par_iter().map(parent).collect());
        let facets = &gradient.critical[degree - 1];
        let steps = stage("joining cavities", facets.len());
        for (number, &facet) in steps.each(facets.iter().enumerate().rev()) {
            let vertex = gradient.vertex(facet.rank());
            let axis = grid.codes.flat_axis(facet.code()).expect("a facet is flat along an axis");
            let star = grid.star(vertex);
            let behind = Grid::base(star, vertex, grid.codes.extended(facet.code(), axis, 1));
            let before = Grid::base(star, vertex, grid.codes.extended(facet.code(), axis, -1));
            let (a, b) = (forest.root(or_outside(behind)), forest.root(or_outside(before)));
            if a == b {
                continue;
            }
            let [first, second] = [a, b].map(|root| (root != outside).then(|| self.top_cell(root as usize)));
            let (young, old, cell) = match (first, second) {
                (Some(x), Some(y)) if x < y => (a, b, x),
                (Some(x), None) => (a, b, x),
                (_, Some(y)) => (b, a, y),
                (None, None) => continue,
            };
            forest.hang(young, old);
            let death = gradient.number(degree, cell);
            self.pair(degree - 1, number, death);
        }
    }

    /// The cell that extends behind a vertex along all axes.
    fn top_cell(&self, base: usize) -> Cell {
        let grid = &self.gradient.grid;
        self.gradient.owned(base, grid.codes.top_corners()).expect("a top cell has vertices in the image")
    }

    /// Pairs the cells of this degree with those of the degree below, by reducing the boundaries of those that are free.
    fn reduce(&mut self, degree: usize) {
        let gradient = self.gradient;
        let cells = &gradient.critical[degree];
        let mut killer = vec![NONE; gradient.critical[degree - 1].len()];
        let mut columns = Columns { starts: vec![0], terms: Vec::new() };
        let mut sum = Sum::new(self.field, gradient);
        let mut found = Vec::new();
        let steps = stage("pairing critical cells", cells.len());
        for (number, &cell) in steps.each(cells.iter().enumerate()) {
            if self.is_paired[degree][number] {
                continue;
            }
            sum.clear();
            sum.add_boundary(cell, sum.unit(false));
            while let Some((pivot, unit)) = sum.lead(degree - 1, &self.is_paired[degree - 1]) {
                // One column may take long.
                steps.advance(0);
                match killer[pivot] {
                    NONE => {
                        killer[pivot] = (columns.starts.len() - 1) as u32;
                        columns.terms.push((gradient.critical[degree - 1][pivot], unit));
                        sum.drain(&mut columns.terms);
                        columns.starts.push(columns.terms.len());
                        found.push((pivot, number));
                        break;
                    }
                    column => sum.add_column(unit, columns.column(column as usize)),
                }
            }
        }
        for (birth, death) in found {
            self.pair(degree - 1, birth, death);
        }
    }
}

/// Sparse columns in one array; the cell that leads a column is its first.
struct Columns<U> {
    starts: Vec<usize>,
    terms: Vec<(Cell, U)>,
}

impl<U> Columns<U> {
    fn column(&self, j: usize) -> &[(Cell, U)] {
        &self.terms[self.starts[j]..self.starts[j + 1]]
    }
}
