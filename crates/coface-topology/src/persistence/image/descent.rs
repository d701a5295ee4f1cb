//! Sums of cells that flow down along a gradient.

use super::gradient::{Cell, Fate, Gradient};
use super::grid::{Code, FacetKind};
use coface_algebra::Field;
use std::collections::BinaryHeap;

/// A sum of cells of one degree whose terms are only added up when they are taken out.
pub(super) struct Sum<'a, F: Field> {
    field: &'a F,
    gradient: &'a Gradient,
    heap: BinaryHeap<(Cell, F::Unit)>,
    /// The terms of the last star, while they are at hand.
    group: Vec<(Code, F::Unit)>,
}

impl<'a, F: Field> Sum<'a, F> {
    pub(super) fn new(field: &'a F, gradient: &'a Gradient) -> Self {
        Self { field, gradient, heap: BinaryHeap::new(), group: Vec::new() }
    }

    pub(super) fn clear(&mut self) {
        self.heap.clear();
    }

    pub(super) fn add(&mut self, cell: Cell, factor: F::Unit) {
        self.heap.push((cell, factor));
    }

    /// One, or minus one.
    pub(super) fn unit(&self, is_negative: bool) -> F::Unit {
        let number = if is_negative { -1 } else { 1 };
        self.field.unit(number).expect("1 and -1 are not 0 in a field")
    }

    pub(super) fn add_boundary(&mut self, cell: Cell, factor: F::Unit) {
        let (gradient, field) = (self.gradient, self.field);
        let vertex = gradient.vertex(cell.rank());
        for facet in gradient.grid.codes.facets(cell.code()) {
            let unit = field.product(factor, self.unit(facet.is_negative));
            match &facet.kind {
                FacetKind::Near(code) => self.heap.push((Cell::new(cell.rank(), *code), unit)),
                FacetKind::Far(corners) => {
                    self.heap.extend(gradient.owned(vertex, corners).map(|cell| (cell, unit)));
                }
            }
        }
    }

    /// Adds the multiple of a column that removes what leads it from this sum, from which that has been taken out.
    pub(super) fn add_column(&mut self, unit: F::Unit, column: &[(Cell, F::Unit)]) {
        let field = self.field;
        let factor = field.eliminator(unit, column[0].1);
        self.heap.extend(column[1..].iter().map(|&(cell, x)| (cell, field.product(factor, x))));
    }

    /// Takes out the last critical cell that is free, by its number, with its coefficient. Matched cells behind it are replaced or dropped.
    pub(super) fn lead(&mut self, degree: usize, is_paired: &[bool]) -> Option<(usize, F::Unit)> {
        loop {
            let rank = self.take_star()?;
            self.replace_matched(rank, |_, _| ());
            let gradient = self.gradient;
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

    /// Takes all terms out, with matched cells replaced or dropped: what is left is critical, or owned by vertices that `is_own` denies, whose cells
    /// nothing is known of. Terms come by falling ranks.
    pub(super) fn descend(&mut self, is_own: impl Fn(u32) -> bool, mut found: impl FnMut(Cell, F::Unit)) {
        while let Some(rank) = self.take_star() {
            let gradient = self.gradient;
            if is_own(rank) {
                self.replace_matched(rank, |_, _| ());
                let vertex = gradient.vertex(rank);
                let star = gradient.grid.star(vertex);
                self.group.retain(|&(code, _)| {
                    gradient.fate(gradient.grid.place(star, vertex, code)) == Fate::Critical
                });
            }
            self.group.sort_unstable();
            for &(code, unit) in &self.group {
                found(Cell::new(rank, code), unit);
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
            Some(place) => match self.field.sum(self.group[place].1, unit) {
                Some(sum) => self.group[place].1 = sum,
                None => {
                    self.group.swap_remove(place);
                }
            },
        }
    }

    /// Takes the terms of ranks above a limit out. Cells that are matched with a cell above are replaced by the rest of the boundary of that, which is told
    /// with the factor; those that are left are told as the second list, as are the terms of other ranks. A cell above may be told several times.
    pub(super) fn grow(
        &mut self,
        limit: u32,
        mut added: impl FnMut(Cell, F::Unit),
        mut left: impl FnMut(Cell, F::Unit),
    ) {
        while self.heap.peek().is_some_and(|(cell, _)| cell.rank() > limit)
            && let Some(rank) = self.take_star()
        {
            self.replace_matched(rank, |code, factor| added(Cell::new(rank, code), factor));
            self.group.iter().for_each(|&(code, unit)| left(Cell::new(rank, code), unit));
        }
        let mut rest = Vec::new();
        self.drain(&mut rest);
        rest.into_iter().for_each(|(cell, unit)| left(cell, unit));
    }

    /// Adds boundaries to the group, until no cell of it is matched with a cell above. Those cells are told with their factors.
    fn replace_matched(&mut self, rank: u32, mut added: impl FnMut(Code, F::Unit)) {
        let (gradient, field) = (self.gradient, self.field);
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
            added(cell, factor);
            for facet in facets {
                let unit = field.product(factor, self.unit(facet.is_negative));
                match &facet.kind {
                    FacetKind::Near(code) => self.add_to_group(*code, unit),
                    FacetKind::Far(corners) => {
                        self.heap.extend(gradient.owned(vertex, corners).map(|cell| (cell, unit)));
                    }
                }
            }
            place = 0;
        }
    }

    /// Takes all terms out.
    pub(super) fn drain(&mut self, terms: &mut Vec<(Cell, F::Unit)>) {
        let mut all = std::mem::take(&mut self.heap).into_vec();
        all.sort_unstable();
        for run in all.chunk_by(|a, b| a.0 == b.0) {
            let mut total = Some(run[0].1);
            for &(_, x) in &run[1..] {
                total = match total {
                    Some(sum) => self.field.sum(sum, x),
                    None => Some(x),
                };
            }
            terms.extend(total.map(|total| (run[0].0, total)));
        }
        all.clear();
        self.heap = all.into();
    }
}
