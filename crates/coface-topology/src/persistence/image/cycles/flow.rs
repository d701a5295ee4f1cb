//! Chains and cochains of critical cells as those of all cells, along the gradient.

use super::super::descent::Sum;
use super::super::gradient::{Cell, Fate, Gradient, NEVER, OUTSIDE};
use super::super::grid::{Code, FacetKind, Grid};
use coface_algebra::Field;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A sum of cells of one degree.
pub(super) type Terms<U> = Vec<(Cell, U)>;

/// A sum of cells of one degree by their places in the grid, each once.
pub(super) type Places<U> = Vec<(usize, U)>;

/// No limit for cochains: all ranks are lower.
pub(super) const NO_END: u32 = NEVER;

/// Work space to grow chains and cochains.
pub(super) struct Flow<'a, F: Field> {
    field: &'a F,
    gradient: &'a Gradient,
    down: Sum<'a, F>,
    up: Rise<'a, F>,
    /// For each vertex what is found there, counted from 1, or 0; empty until it is needed.
    marks: Vec<u32>,
}

impl<'a, F: Field> Flow<'a, F> {
    pub(super) fn new(field: &'a F, gradient: &'a Gradient) -> Self {
        let (down, up) = (Sum::new(field, gradient), Rise::new(field, gradient));
        Self { field, gradient, down, up, marks: Vec::new() }
    }

    /// The chain that one of critical cells stands for: the cells that matched faces are matched with are added, so that none is left in the boundary. Only faces
    /// whose ranks are above the limit are looked at. The boundary is given if there is a place for it.
    pub(super) fn chain(
        &mut self,
        degree: usize,
        critical: Terms<F::Unit>,
        limit: u32,
        boundary: Option<&mut Terms<F::Unit>>,
    ) -> Places<F::Unit> {
        if degree == self.gradient.grid.axes() {
            let found = self.top_cells(&critical, limit);
            if let Some(boundary) = boundary {
                self.boundary_of_top_cells(&found, boundary);
            }
            let grid = &self.gradient.grid;
            return found.into_iter().map(|(base, unit)| (grid.top_place(base), unit)).collect();
        }
        let mut chain = critical;
        if degree > 0 {
            chain.iter().for_each(|&(cell, unit)| self.down.add_boundary(cell, unit));
            let mut left = boundary;
            self.down.grow(
                limit,
                |cell, factor| chain.push((cell, factor)),
                |cell, unit| left.iter_mut().for_each(|left| left.push((cell, unit))),
            );
        }
        self.placed(chain)
    }

    /// The cochain that one of critical cells stands for: faces that the cells of the coboundary are matched with are added, so that none of these is left. Only cells
    /// whose ranks are below the limit are looked at. The coboundary is given if there is a place for it.
    pub(super) fn cochain(
        &mut self,
        degree: usize,
        critical: Terms<F::Unit>,
        limit: u32,
        coboundary: Option<&mut Terms<F::Unit>>,
    ) -> Places<F::Unit> {
        let axes = self.gradient.grid.axes();
        if degree == 0 {
            let found = self.vertices(&critical, limit);
            if let Some(coboundary) = coboundary {
                self.coboundary_of_vertices(&found, coboundary);
            }
            return found.into_iter().map(|(vertex, unit)| (vertex << axes, unit)).collect();
        }
        let mut cochain = critical;
        if degree < axes {
            cochain.iter().for_each(|&(cell, unit)| self.up.add_coboundary(cell, unit));
            let mut left = coboundary;
            self.up.grow(
                limit,
                |cell, factor| cochain.push((cell, factor)),
                |cell, unit| left.iter_mut().for_each(|left| left.push((cell, unit))),
            );
        }
        self.placed(cochain)
    }

    /// Cells by their places; those of one cell are added up.
    pub(super) fn placed(&self, mut terms: Terms<F::Unit>) -> Places<F::Unit> {
        add_up(self.field, &mut terms);
        terms.into_iter().map(|(cell, unit)| (self.gradient.place(cell), unit)).collect()
    }

    /// The vertices that flow to critical ones over vertices of lower ranks than the limit.
    fn vertices(&self, critical: &[(Cell, F::Unit)], limit: u32) -> Vec<(usize, F::Unit)> {
        let (gradient, grid) = (self.gradient, &self.gradient.grid);
        let sides = sides(grid);
        let mut found: Vec<(usize, F::Unit)> = Vec::new();
        for &(root, unit) in critical {
            // What is found is followed in its turn.
            let mut place = found.len();
            found.push((gradient.vertex(root.rank()), unit));
            while let Some(&(vertex, _)) = found.get(place) {
                place += 1;
                let star = grid.star(vertex);
                for &(axis, side, code) in &sides {
                    let next = Grid::opposite(star, vertex, code);
                    if gradient.fate(next << grid.axes()) == Fate::Up(axis, -side)
                        && gradient.ranks[next] < limit
                    {
                        found.push((next, unit));
                    }
                }
            }
        }
        found
    }

    /// The edges between vertices and others.
    fn coboundary_of_vertices(&mut self, found: &[(usize, F::Unit)], coboundary: &mut Terms<F::Unit>) {
        self.mark(found);
        let (gradient, grid) = (self.gradient, &self.gradient.grid);
        for &(vertex, unit) in found {
            let (rank, star) = (gradient.ranks[vertex], grid.star(vertex));
            for cofacet in grid.codes.cofacets(0) {
                let (corner, code) = cofacet.far[0];
                let other = Grid::opposite(star, vertex, corner);
                if gradient.ranks[other] == NEVER || self.found_at(found, other) == Some(unit) {
                    continue;
                }
                let edge = Cell::new(rank, cofacet.code).max(Cell::new(gradient.ranks[other], code));
                coboundary.push((edge, self.field.product(unit, self.down.unit(cofacet.is_negative))));
            }
        }
        self.unmark(found);
        add_up(self.field, coboundary);
    }

    /// The top cells that flow to critical ones over facets of higher ranks than the limit, by their first vertices.
    fn top_cells(&self, critical: &[(Cell, F::Unit)], limit: u32) -> Vec<(usize, F::Unit)> {
        let (gradient, grid) = (self.gradient, &self.gradient.grid);
        let sides = sides(grid);
        // A facet that cells are matched with has the rank of the cell.
        let is_above = |base: usize| {
            let star = grid.star(base);
            let corners = grid.codes.top_corners().iter();
            limit == OUTSIDE
                || corners
                    .map(|&(corner, _)| gradient.ranks[Grid::opposite(star, base, corner)])
                    .any(|rank| rank > limit)
        };
        let mut found: Vec<(usize, F::Unit)> = Vec::new();
        for &(root, unit) in critical {
            let mut place = found.len();
            found.push((grid.first_vertex(gradient.place(root)).0, unit));
            while let Some(&(base, _)) = found.get(place) {
                place += 1;
                let star = grid.star(base);
                for &(axis, side, code) in &sides {
                    let next = Grid::opposite(star, base, code);
                    if next < grid.vertex_count()
                        && gradient.fate(grid.top_place(next)) == Fate::Down(axis, side)
                        && is_above(next)
                    {
                        found.push((next, unit));
                    }
                }
            }
        }
        found
    }

    /// The facets between top cells and others.
    fn boundary_of_top_cells(&mut self, found: &[(usize, F::Unit)], boundary: &mut Terms<F::Unit>) {
        self.mark(found);
        let (gradient, grid) = (self.gradient, &self.gradient.grid);
        for &(base, unit) in found {
            let cell = gradient.owned(base, grid.codes.top_corners());
            let cell = cell.expect("a cell that is there has an owner");
            let vertex = gradient.vertex(cell.rank());
            let mut across = (0, 1);
            for facet in grid.codes.facets(cell.code()) {
                let (own, next) = match &facet.kind {
                    FacetKind::Near(code) => {
                        across = grid.codes.direction(*code, cell.code());
                        (Some(Cell::new(cell.rank(), *code)), grid.next(base, across.0, -across.1))
                    }
                    // The facet on the other side of the same axis.
                    FacetKind::Far(corners) => {
                        (gradient.owned(vertex, corners), grid.next(base, across.0, across.1))
                    }
                };
                if let Some(own) = own
                    && self.found_at(found, next) != Some(unit)
                {
                    boundary.push((own, self.field.product(unit, self.down.unit(facet.is_negative))));
                }
            }
        }
        self.unmark(found);
        add_up(self.field, boundary);
    }

    fn mark(&mut self, found: &[(usize, F::Unit)]) {
        self.marks.resize(self.gradient.grid.vertex_count(), 0);
        for (number, &(at, _)) in (1..).zip(found) {
            self.marks[at] = number;
        }
    }

    /// What is found at a vertex.
    fn found_at(&self, found: &[(usize, F::Unit)], vertex: usize) -> Option<F::Unit> {
        let number = self.marks.get(vertex).copied().unwrap_or(0);
        Some(found[number.checked_sub(1)? as usize].1)
    }

    fn unmark(&mut self, found: &[(usize, F::Unit)]) {
        found.iter().for_each(|&(at, _)| self.marks[at] = 0);
    }
}

/// Both ways along each axis, with the code of the edge that leads there.
fn sides(grid: &Grid) -> Vec<(usize, i8, Code)> {
    let both = (0..grid.axes()).flat_map(|axis| [(axis, 1), (axis, -1)]);
    both.map(|(axis, side)| (axis, side, grid.codes.extended(0, axis, side))).collect()
}

/// Sorts terms, of cells or of their places, and adds those of one cell up.
pub(super) fn add_up<F: Field, C: Copy + Ord>(field: &F, terms: &mut Vec<(C, F::Unit)>) {
    terms.sort_unstable();
    let mut sums: Vec<(C, F::Unit)> = Vec::with_capacity(terms.len());
    for &(cell, unit) in terms.iter() {
        match sums.last_mut() {
            Some(sum) if sum.0 == cell => match field.sum(sum.1, unit) {
                Some(total) => sum.1 = total,
                None => {
                    sums.pop();
                }
            },
            _ => sums.push((cell, unit)),
        }
    }
    *terms = sums;
}

/// A sum of cells of one degree that flows up along a gradient.
struct Rise<'a, F: Field> {
    field: &'a F,
    gradient: &'a Gradient,
    heap: BinaryHeap<Reverse<(Cell, F::Unit)>>,
    /// The terms of the first star, while they are at hand.
    group: Vec<(Code, F::Unit)>,
}

impl<'a, F: Field> Rise<'a, F> {
    fn new(field: &'a F, gradient: &'a Gradient) -> Self {
        Self { field, gradient, heap: BinaryHeap::new(), group: Vec::new() }
    }

    fn unit(&self, is_negative: bool) -> F::Unit {
        let number = if is_negative { -1 } else { 1 };
        self.field.unit(number).expect("1 and -1 are not 0 in a field")
    }

    fn add_coboundary(&mut self, cell: Cell, factor: F::Unit) {
        let gradient = self.gradient;
        for (cofacet, is_negative) in gradient.cofacets(cell) {
            let unit = self.field.product(factor, self.unit(is_negative));
            self.heap.push(Reverse((cofacet, unit)));
        }
    }

    /// Takes the terms of ranks below a limit out. Cells that are matched with a facet are removed by the coboundary of that, which is told with the factor;
    /// those that are left are told as the second list, as are the terms of other ranks. A facet may be told several times.
    fn grow(
        &mut self,
        limit: u32,
        mut added: impl FnMut(Cell, F::Unit),
        mut left: impl FnMut(Cell, F::Unit),
    ) {
        let (gradient, field) = (self.gradient, self.field);
        let grid = &gradient.grid;
        while let Some(&Reverse((first, _))) = self.heap.peek()
            && first.rank() < limit
        {
            let rank = first.rank();
            self.group.clear();
            while let Some(&Reverse((cell, unit))) = self.heap.peek()
                && cell.rank() == rank
            {
                self.heap.pop();
                self.add_to_group(cell.code(), unit);
            }
            let vertex = gradient.vertex(rank);
            let star = grid.star(vertex);
            let mut place = 0;
            while place < self.group.len() {
                let (code, unit) = self.group[place];
                let Fate::Down(axis, _) = gradient.fate(grid.place(star, vertex, code)) else {
                    place += 1;
                    continue;
                };
                let facet = Cell::new(rank, grid.codes.flattened(code, axis));
                let lowered = gradient.cofacets(facet).find(|&(cell, _)| cell == Cell::new(rank, code));
                let (_, is_negative) = lowered.expect("a cell is above the facet it is matched with");
                let factor = field.eliminator(unit, self.unit(is_negative));
                added(facet, factor);
                for (cofacet, is_negative) in gradient.cofacets(facet) {
                    let unit = field.product(factor, self.unit(is_negative));
                    if cofacet.rank() == rank {
                        self.add_to_group(cofacet.code(), unit);
                    } else {
                        self.heap.push(Reverse((cofacet, unit)));
                    }
                }
                place = 0;
            }
            self.group.iter().for_each(|&(code, unit)| left(Cell::new(rank, code), unit));
        }
        let mut rest: Terms<F::Unit> = self.heap.drain().map(|Reverse(term)| term).collect();
        add_up(field, &mut rest);
        rest.into_iter().for_each(|(cell, unit)| left(cell, unit));
    }

    fn add_to_group(&mut self, code: Code, unit: F::Unit) {
        match self.group.iter().position(|&(other, _)| other == code) {
            None => self.group.push((code, unit)),
            Some(place) => match self.field.sum(self.group[place].1, unit) {
                Some(sum) => self.group[place].1 = sum,
                None => {
                    self.group.swap_remove(place);
                }
            },
        }
    }
}

/// The critical vertex that a vertex flows to; `None` for what is outside.
pub(super) fn lowest(gradient: &Gradient, vertex: usize) -> Option<Cell> {
    let (grid, mut at) = (&gradient.grid, vertex);
    while gradient.ranks[at] != OUTSIDE {
        match gradient.fate(at << grid.axes()) {
            Fate::Up(axis, side) => at = grid.next(at, axis, side),
            _ => return Some(Cell::new(gradient.ranks[at], 0)),
        }
    }
    None
}

/// The critical top cell that one flows to, by its first vertex; `None` for what is outside.
pub(super) fn highest(gradient: &Gradient, base: usize) -> Option<Cell> {
    let (grid, mut at) = (&gradient.grid, base);
    loop {
        match gradient.fate(grid.top_place(at)) {
            Fate::Down(axis, side) => at = grid.next(at, axis, -side),
            Fate::Absent => return None,
            _ => return gradient.owned(at, grid.codes.top_corners()),
        }
    }
}
