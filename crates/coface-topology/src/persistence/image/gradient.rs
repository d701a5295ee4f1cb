//! Matchings of the cells of an image.

use super::grid::{Code, FacetKind, Grid};
use coface_algebra::progress::stage;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU8, Ordering};

/// The rank of an absent vertex that has always been there.
pub(super) const OUTSIDE: u32 = 0;

/// The rank of an absent vertex that never enters.
pub(super) const NEVER: u32 = u32::MAX;

/// What became of a cell, by its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fate {
    /// There is no such cell.
    Absent,
    Critical,
    /// Matched with the cell that extends beyond it along this axis, on this side of its owner.
    Up(usize, i8),
    /// Matched with the facet that it extends beyond, so.
    Down(usize, i8),
}

const ABSENT: u8 = u8::MAX;
const CRITICAL: u8 = 16;
const DOWN: u8 = 8;

fn encoded((axis, side): (usize, i8)) -> u8 {
    (axis as u8) << 1 | u8::from(side > 0)
}

fn decoded(byte: u8) -> Fate {
    let (axis, side) = ((byte >> 1 & 3) as usize, if byte & 1 == 1 { 1 } else { -1 });
    match byte {
        ABSENT => Fate::Absent,
        CRITICAL => Fate::Critical,
        _ if byte < DOWN => Fate::Up(axis, side),
        _ => Fate::Down(axis, side),
    }
}

/// A cell by its owner's rank and its code; cells are compared as they enter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Cell(u64);

impl Cell {
    pub(super) fn new(rank: u32, code: Code) -> Self {
        Self(u64::from(rank) << 8 | u64::from(code))
    }

    pub(super) fn rank(self) -> u32 {
        (self.0 >> 8) as u32
    }

    pub(super) fn code(self) -> Code {
        (self.0 & 0xff) as Code
    }
}

/// An image whose cells are matched in lower stars.
pub(super) struct Gradient {
    pub(super) grid: Grid,
    /// The rank of each vertex.
    pub(super) ranks: Vec<u32>,
    /// The vertices by rank, that of rank 1 first.
    pub(super) vertices: Vec<u32>,
    fates: Vec<u8>,
    /// The critical cells of each degree as they enter.
    pub(super) critical: Vec<Vec<Cell>>,
    /// For each degree, for each run of [`RUN`] ranks, how many critical cells enter before it.
    starts: Vec<Vec<u32>>,
}

/// So many ranks are a run, in which a critical cell is looked for.
const RUN: usize = 16;

/// So many vertices are matched between two steps of the progress.
const BATCH: usize = 1 << 16;

impl Gradient {
    /// Matches the cells of the vertices that have a rank in the image and are its own. Vertices that are not have ranks alone: they lie in the layer
    /// around, and their stars are not seen whole.
    pub(super) fn new(
        grid: Grid,
        ranks: Vec<u32>,
        vertices: Vec<u32>,
        is_own: impl Fn(usize) -> bool + Sync,
    ) -> Self {
        let fates: Vec<AtomicU8> = (0..grid.cell_count()).map(|_| AtomicU8::new(ABSENT)).collect();
        let mut critical = vec![Vec::new(); grid.axes() + 1];
        let steps = stage("matching cells", ranks.len());
        for start in (0..ranks.len()).step_by(BATCH) {
            let batch = start..(start + BATCH).min(ranks.len());
            steps.advance(batch.len());
            let chunks: Vec<Vec<Cell>> = batch
                .into_par_iter()
                .with_min_len(BATCH / 16)
                .fold(Vec::new, |mut cells, vertex| {
                    if !matches!(ranks[vertex], OUTSIDE | NEVER) && is_own(vertex) {
                        match_star(&grid, &ranks, vertex, &fates, &mut cells);
                    }
                    cells
                })
                .collect();
            for cell in chunks.into_iter().flatten() {
                critical[grid.codes.degree(cell.code())].push(cell);
            }
        }
        drop(steps);
        let _steps = stage("sorting critical cells", 0);
        for cells in &mut critical {
            cells.par_sort_unstable();
        }
        let fates = fates.into_iter().map(AtomicU8::into_inner).collect();
        let runs = vertices.len() / RUN + 2;
        let starts = critical.iter().map(|cells| starts_of_runs(cells, runs)).collect();
        Self { grid, ranks, vertices, fates, critical, starts }
    }

    /// The place of a critical cell among those of its degree.
    pub(super) fn number(&self, degree: usize, cell: Cell) -> usize {
        let run = cell.rank() as usize / RUN;
        let [start, end] = [run, run + 1].map(|run| self.starts[degree][run] as usize);
        let place = self.critical[degree][start..end].binary_search(&cell);
        start + place.expect("a critical cell is in the list")
    }

    /// A cell by its vertices around a vertex, each with the code that the cell has there; `None` if all of them are outside.
    pub(super) fn owned(&self, vertex: usize, corners: &[(Code, Code)]) -> Option<Cell> {
        let star = self.grid.star(vertex);
        let rank = |corner: Code| self.ranks[Grid::opposite(star, vertex, corner)];
        let cells = corners.iter().map(|&(corner, code)| Cell::new(rank(corner), code));
        cells.max().filter(|cell| cell.rank() != OUTSIDE)
    }

    /// The facets of a cell that are there, each with whether its coefficient is -1.
    pub(super) fn facets(&self, cell: Cell) -> impl Iterator<Item = (Cell, bool)> + '_ {
        let vertex = self.vertex(cell.rank());
        self.grid.codes.facets(cell.code()).iter().filter_map(move |facet| {
            let found = match &facet.kind {
                FacetKind::Near(code) => Some(Cell::new(cell.rank(), *code)),
                FacetKind::Far(corners) => self.owned(vertex, corners),
            };
            Some((found?, facet.is_negative))
        })
    }

    /// The cells that are there and have a cell as a facet, each with whether the coefficient of it is -1.
    pub(super) fn cofacets(&self, cell: Cell) -> impl Iterator<Item = (Cell, bool)> + '_ {
        let vertex = self.vertex(cell.rank());
        let star = self.grid.star(vertex);
        self.grid.codes.cofacets(cell.code()).iter().filter_map(move |cofacet| {
            let mut owned = Cell::new(cell.rank(), cofacet.code);
            for &(corner, code) in &cofacet.far {
                owned = owned.max(Cell::new(self.ranks[Grid::opposite(star, vertex, corner)], code));
            }
            (owned.rank() != NEVER).then_some((owned, cofacet.is_negative))
        })
    }

    /// The cell at a place, which is there.
    pub(super) fn cell(&self, place: usize) -> Cell {
        let (base, extents) = self.grid.first_vertex(place);
        let mut code = 0;
        for axis in (0..self.grid.axes()).filter(|axis| extents >> axis & 1 == 1) {
            code = self.grid.codes.extended(code, axis, 1);
        }
        // From its first vertex all others are behind.
        let star = self.grid.star(base);
        let first = Cell::new(self.ranks[base], code);
        let seen =
            |&(corner, code): &(Code, Code)| Cell::new(self.ranks[Grid::opposite(star, base, corner)], code);
        self.grid.codes.seen(code).iter().map(seen).fold(first, Cell::max)
    }

    /// The place of a cell.
    pub(super) fn place(&self, cell: Cell) -> usize {
        let vertex = self.vertex(cell.rank());
        self.grid.place(self.grid.star(vertex), vertex, cell.code())
    }

    pub(super) fn fate(&self, place: usize) -> Fate {
        decoded(self.fates[place])
    }

    /// The vertex of a rank that is in the image.
    pub(super) fn vertex(&self, rank: u32) -> usize {
        self.vertices[rank as usize - 1] as usize
    }
}

fn starts_of_runs(cells: &[Cell], runs: usize) -> Vec<u32> {
    let mut starts = vec![0; runs + 1];
    for cell in cells {
        starts[cell.rank() as usize / RUN + 1] += 1;
    }
    for run in 0..runs {
        starts[run + 1] += starts[run];
    }
    starts
}

/// The cells that a vertex owns, a bit for each code.
pub(super) fn lower_star(grid: &Grid, ranks: &[u32], vertex: usize) -> u128 {
    let (codes, star, rank) = (&grid.codes, grid.star(vertex), ranks[vertex]);
    let mut lower = 0u128;
    for code in 1..codes.count() {
        let is_lower = ranks[Grid::opposite(star, vertex, code as Code)] < rank;
        lower |= u128::from(is_lower) << code;
    }
    let mut owned = 1u128;
    if lower != 0 {
        for code in 1..codes.count() {
            let corners = codes.corners(code);
            owned |= u128::from(lower & corners == corners) << code;
        }
    }
    owned
}

/// Matches the cells of a lower star; adds those that are left to a list.
fn match_star(grid: &Grid, ranks: &[u32], vertex: usize, fates: &[AtomicU8], critical: &mut Vec<Cell>) {
    let (codes, star, rank) = (&grid.codes, grid.star(vertex), ranks[vertex]);
    let mut left = lower_star(grid, ranks, vertex);
    let set = |code: u32, byte: u8| {
        fates[grid.place(star, vertex, code as Code)].store(byte, Ordering::Relaxed);
    };
    while left != 0 {
        // Cells with one facet left are matched with it, as long as there are some.
        let mut is_stuck = true;
        let mut rest = left & (left - 1);
        while rest != 0 {
            let cell = rest.trailing_zeros();
            rest &= rest - 1;
            let facets = codes.near_facets(cell as usize) & left;
            if left >> cell & 1 == 1 && facets.is_power_of_two() {
                let facet = facets.trailing_zeros();
                let direction = encoded(codes.direction(facet as Code, cell as Code));
                set(facet, direction);
                set(cell, DOWN | direction);
                left &= !(1 << cell | facets);
                is_stuck = false;
            }
        }
        if is_stuck {
            let cell = left.trailing_zeros();
            left &= left - 1;
            set(cell, CRITICAL);
            critical.push(Cell::new(rank, cell as Code));
        }
    }
}
