//! Pairs of critical cells.

use super::forest::Forest;
use super::gradient::{Cell, Fate, Gradient, OUTSIDE};
use super::grid::{Code, FacetKind, Grid};
use coface_algebra::Field;
use coface_algebra::progress::stage;
use rayon::prelude::*;
use std::collections::BinaryHeap;

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
        self.owned(base, grid.codes.top_corners()).expect("a top cell has vertices in the image")
    }

    /// A cell by its vertices around a vertex, each with the code that the cell has there; `None` if all of them are outside.
    fn owned(&self, vertex: usize, corners: &[(Code, Code)]) -> Option<Cell> {
        let star = self.gradient.grid.star(vertex);
        let rank = |corner: Code| self.gradient.ranks[Grid::opposite(star, vertex, corner)];
        let cells = corners.iter().map(|&(corner, code)| Cell::new(rank(corner), code));
        cells.max().filter(|cell| cell.rank() != OUTSIDE)
    }

    /// Pairs the cells of this degree with those of the degree below, by reducing the boundaries of those that are free.
    fn reduce(&mut self, degree: usize) {
        let gradient = self.gradient;
        let cells = &gradient.critical[degree];
        let mut killer = vec![NONE; gradient.critical[degree - 1].len()];
        let mut columns = Columns { starts: vec![0], terms: Vec::new() };
        let mut sum = Sum { pairing: self, heap: BinaryHeap::new(), group: Vec::new() };
        let mut found = Vec::new();
        let steps = stage("pairing critical cells", cells.len());
        for (number, &cell) in steps.each(cells.iter().enumerate()) {
            if self.is_paired[degree][number] {
                continue;
            }
            sum.heap.clear();
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

/// A sum of cells of one degree whose terms are only added up when they are taken out.
struct Sum<'p, 'a, F: Field> {
    pairing: &'p Pairing<'a, F>,
    heap: BinaryHeap<(Cell, F::Unit)>,
    /// The terms of the last star, while they are at hand.
    group: Vec<(Code, F::Unit)>,
}

impl<F: Field> Sum<'_, '_, F> {
    /// One, or minus one.
    fn unit(&self, is_negative: bool) -> F::Unit {
        let number = if is_negative { -1 } else { 1 };
        self.pairing.field.unit(number).expect("1 and -1 are not 0 in a field")
    }

    fn add_boundary(&mut self, cell: Cell, factor: F::Unit) {
        let (gradient, field) = (self.pairing.gradient, self.pairing.field);
        let vertex = gradient.vertex(cell.rank());
        for facet in gradient.grid.codes.facets(cell.code()) {
            let unit = field.product(factor, self.unit(facet.is_negative));
            match &facet.kind {
                FacetKind::Near(code) => self.heap.push((Cell::new(cell.rank(), *code), unit)),
                FacetKind::Far(corners) => {
                    self.heap.extend(self.pairing.owned(vertex, corners).map(|cell| (cell, unit)));
                }
            }
        }
    }

    /// Adds the multiple of a column that removes what leads it from this sum, from which that has been taken out.
    fn add_column(&mut self, unit: F::Unit, column: &[(Cell, F::Unit)]) {
        let field = self.pairing.field;
        let factor = field.eliminator(unit, column[0].1);
        self.heap.extend(column[1..].iter().map(|&(cell, x)| (cell, field.product(factor, x))));
    }

    /// Takes out the last critical cell that is free, by its number, with its coefficient. Matched cells behind it are replaced or dropped.
    fn lead(&mut self, degree: usize, is_paired: &[bool]) -> Option<(usize, F::Unit)> {
        loop {
            let rank = self.take_star()?;
            self.replace_matched(rank);
            let gradient = self.pairing.gradient;
            let (vertex, mut lead) = (gradient.vertex(rank), None);
            let star = gradient.grid.star(vertex);
            self.group.sort_unstable();
            while let Some((code, unit)) = self.group.pop() {
                let cell = Cell::new(rank, code);
                if gradient.fate(gradient.grid.place(star, vertex, code)) != Fate::Critical {
                    continue;
                }
                if lead.is_some() {
                    self.heap.push((cell, unit));
                    continue;
                }
                let number = gradient.number(degree, cell);
                if !is_paired[number] {
                    lead = Some((number, unit));
                }
            }
            if lead.is_some() {
                return lead;
            }
        }
    }

    /// Takes the terms of the last star into the group; gives the rank of its vertex.
    fn take_star(&mut self) -> Option<u32> {
        self.group.clear();
        let rank = self.heap.peek()?.0.rank();
        while let Some(&(cell, unit)) = self.heap.peek()
            && cell.rank() == rank
        {
            self.heap.pop();
            self.add_to_group(cell.code(), unit);
        }
        Some(rank)
    }

    fn add_to_group(&mut self, code: Code, unit: F::Unit) {
        match self.group.iter().position(|&(other, _)| other == code) {
            None => self.group.push((code, unit)),
            Some(place) => match self.pairing.field.sum(self.group[place].1, unit) {
                Some(sum) => self.group[place].1 = sum,
                None => {
                    self.group.swap_remove(place);
                }
            },
        }
    }

    /// Adds boundaries to the group, until no cell of it is matched with a cell above.
    fn replace_matched(&mut self, rank: u32) {
        let (gradient, field) = (self.pairing.gradient, self.pairing.field);
        let grid = &gradient.grid;
        let vertex = gradient.vertex(rank);
        let star = grid.star(vertex);
        let upper = |code: Code| match gradient.fate(grid.place(star, vertex, code)) {
            Fate::Up(axis, side) => Some(grid.codes.extended(code, axis, side)),
            _ => None,
        };
        let mut place = 0;
        while place < self.group.len() {
            let (code, unit) = self.group[place];
            let Some(cell) = upper(code) else {
                place += 1;
                continue;
            };
            let facets = grid.codes.facets(cell);
            let own =
                facets.iter().find(|facet| matches!(facet.kind, FacetKind::Near(other) if other == code));
            let own = own.expect("a cell is a facet of the one it is matched with");
            let factor = field.eliminator(unit, self.unit(own.is_negative));
            for facet in facets {
                let unit = field.product(factor, self.unit(facet.is_negative));
                match &facet.kind {
                    FacetKind::Near(code) => self.add_to_group(*code, unit),
                    FacetKind::Far(corners) => {
                        self.heap.extend(self.pairing.owned(vertex, corners).map(|cell| (cell, unit)));
                    }
                }
            }
            place = 0;
        }
    }

    /// Takes all terms out.
    fn drain(&mut self, terms: &mut Vec<(Cell, F::Unit)>) {
        let mut all = std::mem::take(&mut self.heap).into_vec();
        all.sort_unstable();
        for run in all.chunk_by(|a, b| a.0 == b.0) {
            let mut total = Some(run[0].1);
            for &(_, x) in &run[1..] {
                total = match total {
                    Some(sum) => self.pairing.field.sum(sum, x),
                    None => Some(x),
                };
            }
            terms.extend(total.map(|total| (run[0].0, total)));
        }
        all.clear();
        self.heap = all.into();
    }
}
