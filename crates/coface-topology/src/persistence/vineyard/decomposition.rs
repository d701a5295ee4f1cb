//! The decomposition R = D V of boundary matrices, and how transpositions change it.

use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::stage;
use coface_algebra::{Field, SparseMatrix};
use std::cmp::Ordering;

/// No cell.
pub(super) const NONE: u32 = u32::MAX;

/// A column by the ids of its cells, rising.
type Column<U> = Vec<(u32, U)>;

/// The cells of a degree in their order, with reduced boundaries and the sums of columns that these are.
pub(super) struct Level<U> {
    /// The cells by their places.
    pub(super) order: Vec<u32>,
    /// The place of each cell.
    pub(super) places: Vec<u32>,
    /// For each cell its reduced boundary.
    reduced: Vec<Column<U>>,
    /// For each cell the columns that its reduced boundary is the sum of.
    sums: Vec<Column<U>>,
    /// For each cell that ends a class the one that made it, or [`NONE`].
    pub(super) born: Vec<u32>,
    /// For each cell that makes a class the one that ends it, or [`NONE`].
    pub(super) dead: Vec<u32>,
}

/// All degrees.
pub(super) struct Decomposition<'a, F: Field> {
    field: &'a F,
    pub(super) levels: Vec<Level<F::Unit>>,
}

/// The entry of a column at a cell.
fn entry<U: Copy>(column: &[(u32, U)], cell: u32) -> Option<U> {
    column.binary_search_by_key(&cell, |term| term.0).ok().map(|place| column[place].1)
}

/// Adds a multiple of a column to another one.
fn add<F: Field>(field: &F, to: &mut Column<F::Unit>, factor: F::Unit, column: &[(u32, F::Unit)]) {
    let old = std::mem::take(to);
    let (mut i, mut j) = (0, 0);
    while i < old.len() || j < column.len() {
        let order = match (old.get(i), column.get(j)) {
            (Some(a), Some(b)) => a.0.cmp(&b.0),
            (Some(_), None) => Ordering::Less,
            _ => Ordering::Greater,
        };
        match order {
            Ordering::Less => {
                to.push(old[i]);
                i += 1;
            }
            Ordering::Greater => {
                to.push((column[j].0, field.product(factor, column[j].1)));
                j += 1;
            }
            Ordering::Equal => {
                let sum = field.sum(old[i].1, field.product(factor, column[j].1));
                to.extend(sum.map(|sum| (old[i].0, sum)));
                i += 1;
                j += 1;
            }
        }
    }
}

impl<'a, F: Field> Decomposition<'a, F> {
    /// The decomposition of a complex whose cells have these orders.
    pub(super) fn new(field: &'a F, complex: &ChainComplex, orders: Vec<Vec<u32>>) -> Self {
        let mut levels: Vec<Level<F::Unit>> = Vec::with_capacity(orders.len());
        let one = field.unit(1).expect("1 is not 0 in a field");
        for (degree, order) in orders.into_iter().enumerate() {
            let count = order.len();
            let mut places = vec![0; count];
            for (place, &cell) in order.iter().enumerate() {
                places[cell as usize] = place as u32;
            }
            let boundary = |cell: usize| -> Column<F::Unit> {
                let matrix = degree.checked_sub(1).and_then(|_| complex.boundary_matrix(degree));
                let faces = |matrix: &SparseMatrix| {
                    let entries = matrix.column(cell).iter();
                    entries.filter_map(|(face, x)| Some((face as u32, field.unit(x)?))).collect()
                };
                matrix.map(faces).unwrap_or_default()
            };
            let mut reduced: Vec<_> = (0..count).map(boundary).collect();
            reduced.iter_mut().for_each(|column| column.sort_unstable());
            let sums = (0..count).map(|cell| vec![(cell as u32, one)]).collect();
            let [born, dead] = [(); 2].map(|()| vec![NONE; count]);
            levels.push(Level { order, places, reduced, sums, born, dead });
        }
        let mut decomposition = Self { field, levels };
        for degree in 1..decomposition.levels.len() {
            decomposition.reduce(degree);
        }
        decomposition
    }

    fn reduce(&mut self, degree: usize) {
        let order = self.levels[degree].order.clone();
        let steps = stage("pairing cells", order.len());
        for cell in steps.each(order) {
            while let Some(low) = self.low(degree, cell) {
                let owner = self.levels[degree - 1].dead[low as usize];
                if owner == NONE {
                    self.join(degree, low, cell);
                    break;
                }
                self.eliminate(degree, low, cell, owner);
            }
        }
    }

    /// The last cell of a reduced boundary.
    fn low(&self, degree: usize, cell: u32) -> Option<u32> {
        let places = &self.levels[degree.checked_sub(1)?].places;
        let cells = self.levels[degree].reduced[cell as usize].iter().map(|term| term.0);
        cells.max_by_key(|&face| places[face as usize])
    }

    /// Pairs the cell that makes a class with the one that ends it, or says that it ends none.
    fn join(&mut self, degree: usize, low: u32, cell: u32) {
        self.levels[degree].born[cell as usize] = low;
        if low != NONE {
            self.levels[degree - 1].dead[low as usize] = cell;
        }
    }

    /// Adds the column of another cell, so that the reduced boundary of the first one has no entry at a face.
    fn eliminate(&mut self, degree: usize, face: u32, cell: u32, other: u32) {
        let level = &mut self.levels[degree];
        let (cell, other) = (cell as usize, other as usize);
        let [x, y] = [cell, other].map(|column| entry(&level.reduced[column], face));
        let (Some(x), Some(y)) = (x, y) else { return };
        self.combine(degree, cell, self.field.eliminator(x, y), other);
    }

    /// Adds a multiple of a column to another one, in the reduced boundaries and in the sums.
    fn combine(&mut self, degree: usize, cell: usize, factor: F::Unit, other: usize) {
        let level = &mut self.levels[degree];
        for columns in [&mut level.reduced, &mut level.sums] {
            let column = std::mem::take(&mut columns[other]);
            add(self.field, &mut columns[cell], factor, &column);
            columns[other] = column;
        }
    }

    /// Lets the cell of a degree at `place` and the next one change places. Whether pairs changed: then the two cells have each other's partners.
    pub(super) fn transpose(&mut self, degree: usize, place: usize) -> bool {
        let level = &mut self.levels[degree];
        let (a, b) = (level.order[place], level.order[place + 1]);
        let is_summed = entry(&level.sums[b as usize], a);
        if let Some(x) = is_summed {
            // The sum of b may not have a cell that is behind it then.
            let y = entry(&level.sums[a as usize], a).expect("a cell is in its own sum");
            self.combine(degree, b as usize, self.field.eliminator(x, y), a as usize);
        }
        let level = &mut self.levels[degree];
        level.order.swap(place, place + 1);
        level.places.swap(a as usize, b as usize);
        match (level.born[a as usize], level.born[b as usize]) {
            (NONE, NONE) => self.transpose_births(degree, a, b),
            (NONE, _) | (_, NONE) if is_summed.is_none() => false,
            // The sum of b, which bounded nothing, has the boundary of a.
            (low, NONE) => {
                self.eliminate(degree, low, a, b);
                self.join(degree, low, b);
                self.levels[degree].born[a as usize] = NONE;
                // The class of b is that of a, with what ends it.
                let dead = std::mem::replace(&mut self.levels[degree].dead[b as usize], NONE);
                self.levels[degree].dead[a as usize] = dead;
                if dead != NONE {
                    self.join(degree + 1, a, dead);
                }
                true
            }
            (NONE, _) => false,
            (low_a, low_b) => {
                let places = &self.levels[degree - 1].places;
                let is_changed = is_summed.is_some() && places[low_a as usize] > places[low_b as usize];
                if is_changed {
                    self.eliminate(degree, low_a, a, b);
                    self.join(degree, low_a, b);
                    self.join(degree, low_b, a);
                }
                is_changed
            }
        }
    }

    /// Of two cells that make classes: which are ended by which.
    fn transpose_births(&mut self, degree: usize, a: u32, b: u32) -> bool {
        let level = &self.levels[degree];
        let (k, l) = (level.dead[a as usize], level.dead[b as usize]);
        // Behind b, a is the last cell of a boundary that has both.
        if l == NONE || entry(&self.levels[degree + 1].reduced[l as usize], a).is_none() {
            return false;
        }
        if k == NONE {
            self.levels[degree].dead[b as usize] = NONE;
            self.join(degree + 1, a, l);
            return true;
        }
        let places = &self.levels[degree + 1].places;
        if places[k as usize] < places[l as usize] {
            self.eliminate(degree + 1, a, l, k);
            return false;
        }
        self.eliminate(degree + 1, a, k, l);
        self.join(degree + 1, a, l);
        self.join(degree + 1, b, k);
        true
    }
}
