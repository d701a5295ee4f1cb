//! What a block leaves: its cells are matched, and what is critical flows down as far as the block sees.

use super::super::descent::Sum;
use super::super::forest::Forest;
use super::super::gradient::{Cell, Fate, Gradient, NEVER, OUTSIDE, lower_star};
use super::super::grid::{Code, Grid};
use super::cancelling::Numbered;
use super::cut::ImageBlocks;
use super::part::{Cells, Chains, ImagePart, Name, OUTSIDE_NAME, Rules, name};
use coface_algebra::progress::stage;
use coface_algebra::{Binary, Error, ErrorKind, Odd, memory};
use rayon::prelude::*;
use std::sync::Arc;

/// So many critical cells flow down at once.
const BATCH: usize = 4096;

/// A voxel that enters: key, number in the image, vertex of the grid.
type Entering = (u64, u64, u32);

impl ImageBlocks {
    /// What is left of a block, from the numbers of its window.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for another number of numbers than the window has voxels; [`ErrorKind::InvalidInput`] for a voxel at infinity where values
    /// come from; [`ErrorKind::TooLarge`] where the free memory would not do.
    ///
    /// # Panics
    /// If there is no such block.
    ///
    /// # Complexity
    /// Sorts the voxels of the window and matches their cells in linear time. Each critical cell, and each matched one at the rim that may be asked for, takes
    /// the time of what its boundary flows over. Memory: see [`Self::bytes`].
    ///
    /// # References
    /// Those of [`ImageFiltration::persistence`](crate::ImageFiltration::persistence); A. Gyulassy, V. Pascucci, T. Peterka, R. Ross, *The parallel
    /// computation of Morse-Smale complexes* (2012), who cut gradients at the sides of blocks, where ours go on.
    ///
    /// # Examples
    /// See [`ImageBlocks`].
    pub fn part(&self, number: u32, numbers: impl IntoIterator<Item = f64>) -> Result<ImagePart, Error> {
        memory::require(self.bytes(), || format!("block {number} of an image of shape {:?}", self.shape()))?;
        let window = self.window(number);
        let count: usize = window.iter().map(Vec::len).product();
        let numbers: Vec<f64> = numbers.into_iter().take(count.saturating_add(1)).collect();
        if numbers.len() != count {
            let shape: Vec<usize> = window.iter().map(Vec::len).collect();
            let given = if numbers.len() > count { "more".to_owned() } else { numbers.len().to_string() };
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{given} numbers for the window of block {number}, which has the shape {shape:?}"),
            )
            .with_cure("give one number for each voxel of the window"));
        }
        let block = self.block(number, &numbers)?;
        drop(numbers);
        let part = match self.prime() {
            2 => block.part(&Binary),
            prime => block.part(&Odd::new(prime)),
        };
        drop(block);
        part.cancelled()
    }

    /// The block with its cells matched.
    fn block(&self, number: u32, numbers: &[f64]) -> Result<Block<'_>, Error> {
        let long = self.long_axes();
        let along: Vec<Vec<Option<usize>>> = (0..self.shape().len())
            .map(|axis| {
                let along = self.along(number, axis);
                match long[..] == [axis] && self.shape()[axis] == 1 {
                    // A single voxel has a layer around it too.
                    true => [None].into_iter().chain(along).chain([None]).collect(),
                    false => along,
                }
            })
            .collect();
        let closes = |axis: usize| self.closes(axis);
        let shape: Vec<usize> =
            long.iter().map(|&axis| along[axis].len() - if closes(axis) { 0 } else { 2 }).collect();
        let is_closed: Vec<bool> = long.iter().map(|&axis| closes(axis)).collect();
        let grid = Grid::new(&shape, &is_closed);
        let absent = if self.is_dual() { OUTSIDE } else { NEVER };
        let _steps = stage("sorting voxels", 0);
        let from = if self.is_falling() { f64::INFINITY } else { f64::NEG_INFINITY };
        let mut entering: Vec<Entering> = Vec::new();
        // A vertex is own where it is in the layer of no axis.
        let (mut at, mut taken) = (vec![0; along.len()], 0);
        let mut is_own = Vec::with_capacity(grid.vertex_count());
        let mut is_near = Vec::with_capacity(grid.vertex_count());
        for vertex in 0..grid.vertex_count() {
            let mut voxel = Some(0u64);
            let (mut is_inner, mut is_beside) = (true, false);
            for (axis, &place) in at.iter().enumerate() {
                let length = self.shape()[axis] as u64;
                voxel = voxel.and_then(|voxel| Some(voxel * length + along[axis][place]? as u64));
                let is_layered = long.contains(&axis) && !closes(axis);
                is_inner &= !is_layered || (place > 0 && place + 1 < along[axis].len());
                is_beside |= is_layered && (place == 1 || place + 2 == along[axis].len());
            }
            is_own.push(is_inner);
            is_near.push(is_inner && is_beside);
            if let Some(voxel) = voxel {
                let value = numbers[taken];
                taken += 1;
                if value == from {
                    return Err(Error::invalid(format!(
                        "voxel {:?} is at {value}, so classes would be born at infinity",
                        self.voxel(voxel)
                    ))
                    .with_cure("write a finite number there, or NaN if the voxel is outside"));
                }
                if value.is_finite() {
                    entering.push((self.key(value), voxel, vertex as u32));
                }
            }
            for axis in (0..at.len()).rev() {
                at[axis] += 1;
                if at[axis] < along[axis].len() {
                    break;
                }
                at[axis] = 0;
            }
        }
        entering.par_sort_unstable();
        let mut ranks = vec![absent; grid.vertex_count()];
        for (rank, &(.., vertex)) in (1..).zip(&entering) {
            ranks[vertex as usize] = rank;
        }
        let vertices = entering.iter().map(|&(.., vertex)| vertex).collect();
        let gradient = Gradient::new(grid, ranks, vertices, |vertex| is_own[vertex]);
        let mut block = Block { cut: self, number, gradient, entering, is_own, rim: Vec::new() };
        block.rim = block.found_rim(&is_near);
        Ok(block)
    }

    /// The place of a voxel along each axis.
    fn voxel(&self, number: u64) -> Vec<usize> {
        let mut rest = number as usize;
        let mut voxel: Vec<usize> = self
            .shape()
            .iter()
            .rev()
            .map(|&length| {
                let at = rest % length;
                rest /= length;
                at
            })
            .collect();
        voxel.reverse();
        voxel
    }
}

/// A block with its cells matched.
struct Block<'a> {
    cut: &'a ImageBlocks,
    number: u32,
    gradient: Gradient,
    /// The voxels of the window by rank.
    entering: Vec<Entering>,
    /// For each vertex whether it is of this block.
    is_own: Vec<bool>,
    /// The vertices of the block, by rank, that have voxels of other blocks beside them; of each a bit for the code of each of these.
    rim: Vec<(u32, u128)>,
}

impl Block<'_> {
    fn axes(&self) -> usize {
        self.gradient.grid.axes()
    }

    fn is_own_rank(&self, rank: u32) -> bool {
        self.is_own[self.gradient.vertex(rank)]
    }

    fn key(&self, rank: u32) -> u64 {
        self.entering[rank as usize - 1].0
    }

    fn name(&self, cell: Cell) -> Name {
        name(self.entering[cell.rank() as usize - 1].1, cell.code())
    }

    /// The block of the voxel of a rank that is not of this one.
    fn block_of(&self, rank: u32) -> u64 {
        self.cut.block_of(self.entering[rank as usize - 1].1).into()
    }

    fn part<F: Numbered>(&self, field: &F) -> ImagePart {
        let (axes, gradient) = (self.axes(), &self.gradient);
        let cells = |cells: &Vec<Cell>| Cells {
            keys: cells.iter().map(|cell| self.key(cell.rank())).collect(),
            names: cells.iter().map(|&cell| self.name(cell)).collect(),
        };
        let critical = gradient.critical.iter().map(cells).collect();
        let mut rules: Vec<Rules> = Vec::new();
        let mut edges = Vec::new();
        {
            let mut vertices = Vertices::new(self);
            edges.extend(gradient.critical[1].iter().map(|&edge| vertices.ends(edge)));
            rules.push(vertices.rules());
        }
        let (mut facets, mut top_rules) = (Vec::new(), Rules::default());
        if axes > 1 {
            let mut tops = TopCells::new(self);
            facets.extend(gradient.critical[axes - 1].iter().map(|&facet| tops.beside(facet)));
            top_rules = tops.rules();
        }
        let boundaries = (2..axes).map(|degree| self.boundaries(field, degree)).collect();
        rules.extend((1..axes.saturating_sub(1)).map(|degree| self.rules(field, degree)));
        ImagePart {
            cut: Arc::new(self.cut.clone()),
            blocks: self.number..self.number + 1,
            critical,
            edges,
            facets,
            boundaries,
            rules,
            top_rules,
            layer: self.layer(),
            pairs: vec![Vec::new(); axes],
        }
    }

    /// The voxels of other blocks in the window, each with its key.
    fn layer(&self) -> Vec<[u64; 2]> {
        let others = self.entering.iter().filter(|&&(.., vertex)| !self.is_own[vertex as usize]);
        let mut layer: Vec<[u64; 2]> = others.map(|&(key, voxel, _)| [voxel, key]).collect();
        layer.sort_unstable();
        layer.dedup();
        layer
    }

    /// Takes out what a sum flows down to in the block.
    fn descended<F: Numbered>(&self, sum: &mut Sum<'_, F>) -> Vec<(Name, u32)> {
        let mut terms = Vec::new();
        sum.descend(
            |rank| self.is_own_rank(rank),
            |cell, unit| terms.push((self.name(cell), F::number(unit))),
        );
        terms
    }

    /// What the boundaries of the critical cells of a degree flow to.
    fn boundaries<F: Numbered>(&self, field: &F, degree: usize) -> Chains {
        let cells = &self.gradient.critical[degree];
        let mut chains = Chains::default();
        let steps = stage("following boundaries", cells.len());
        for batch in cells.chunks(BATCH) {
            let start = || Sum::new(field, &self.gradient);
            let found: Vec<Vec<(Name, u32)>> = batch
                .par_iter()
                .map_init(start, |sum, &cell| {
                    sum.add_boundary(cell, sum.unit(false));
                    self.descended(sum)
                })
                .collect();
            found.into_iter().for_each(|terms| chains.push(self.cut.prime(), terms));
            steps.advance(batch.len());
        }
        chains
    }

    /// The rim, among vertices beside the layer.
    fn found_rim(&self, is_near: &[bool]) -> Vec<(u32, u128)> {
        let (gradient, grid) = (&self.gradient, &self.gradient.grid);
        let others = |(i, &(.., vertex)): (usize, &Entering)| {
            let vertex = vertex as usize;
            if !is_near[vertex] {
                return None;
            }
            let star = grid.star(vertex);
            let mut others = 0u128;
            for code in 1..grid.codes.count() {
                let other = Grid::opposite(star, vertex, code as Code);
                let is_other = !self.is_own[other] && !matches!(gradient.ranks[other], OUTSIDE | NEVER);
                others |= u128::from(is_other) << code;
            }
            (others != 0).then_some((i as u32 + 1, others))
        };
        self.entering.par_iter().enumerate().filter_map(others).collect()
    }

    /// What the cells of a degree at the rim flow to that are matched with a cell above or critical, and are facets of cells of other blocks.
    fn rules<F: Numbered>(&self, field: &F, degree: usize) -> Rules {
        let (gradient, grid) = (&self.gradient, &self.gradient.grid);
        let codes = &grid.codes;
        let mut asked: Vec<(Cell, Vec<u64>)> = Vec::new();
        for &(rank, _) in &self.rim {
            let vertex = gradient.vertex(rank);
            let star = grid.star(vertex);
            let owned = lower_star(grid, &gradient.ranks, vertex);
            let is_asked = |&code: &Code| owned >> code & 1 == 1 && codes.degree(code) == degree;
            for code in (1..codes.count() as Code).filter(is_asked) {
                if !matches!(gradient.fate(grid.place(star, vertex, code)), Fate::Up(..) | Fate::Critical) {
                    continue;
                }
                let mut askers: Vec<u64> = Vec::new();
                for axis in (0..self.axes()).filter(|&axis| codes.is_flat(code, axis)) {
                    for side in [1, -1] {
                        askers.extend(self.other_owner(rank, codes.extended(code, axis, side)));
                    }
                }
                askers.sort_unstable();
                askers.dedup();
                if !askers.is_empty() {
                    asked.push((Cell::new(rank, code), askers));
                }
            }
        }
        let mut rules = Rules::default();
        let steps = stage("following cells at the rim", asked.len());
        for batch in asked.chunks(BATCH) {
            let start = || Sum::new(field, gradient);
            let found: Vec<Vec<(Name, u32)>> = batch
                .par_iter()
                .map_init(start, |sum, &(cell, _)| {
                    sum.add(cell, sum.unit(false));
                    self.descended(sum)
                })
                .collect();
            for ((cell, askers), terms) in batch.iter().zip(found) {
                let entry = (self.key(cell.rank()), self.name(*cell));
                rules.push(self.cut.prime(), entry, askers.iter().copied(), terms);
            }
            steps.advance(batch.len());
        }
        rules
    }

    /// The other block that owns a cell of the star of a vertex, if one does.
    fn other_owner(&self, rank: u32, code: Code) -> Option<u64> {
        let (gradient, grid) = (&self.gradient, &self.gradient.grid);
        let vertex = gradient.vertex(rank);
        let star = grid.star(vertex);
        let corners = grid.codes.corners(code.into());
        let ranks = (0..grid.codes.count()).filter(|&corner| corners >> corner & 1 == 1);
        let ranks = ranks.map(|corner| gradient.ranks[Grid::opposite(star, vertex, corner as Code)]);
        let owner = ranks.max().filter(|&owner| owner > rank && owner != NEVER)?;
        (!self.is_own_rank(owner)).then(|| self.block_of(owner))
    }
}

/// Where the vertices of a block flow to.
struct Vertices<'a> {
    block: &'a Block<'a>,
    forest: Forest,
}

impl<'a> Vertices<'a> {
    fn new(block: &'a Block<'a>) -> Self {
        let (gradient, grid) = (&block.gradient, &block.gradient.grid);
        let parent = |rank: u32| {
            if rank == OUTSIDE || !block.is_own_rank(rank) {
                return rank;
            }
            let vertex = gradient.vertex(rank);
            match gradient.fate(vertex << grid.axes()) {
                Fate::Up(axis, side) => {
                    let edge = grid.codes.extended(0, axis, side);
                    gradient.ranks[Grid::opposite(grid.star(vertex), vertex, edge)]
                }
                _ => rank,
            }
        };
        let ranks = (0..gradient.vertices.len() as u32 + 1).into_par_iter();
        Self { block, forest: Forest::new(ranks.map(parent).collect()) }
    }

    /// Where a vertex flows to.
    fn end(&mut self, rank: u32) -> Name {
        match self.forest.root(rank) {
            OUTSIDE => OUTSIDE_NAME,
            rank => self.block.name(Cell::new(rank, 0)),
        }
    }

    fn ends(&mut self, edge: Cell) -> [Name; 2] {
        let (gradient, grid) = (&self.block.gradient, &self.block.gradient.grid);
        let vertex = gradient.vertex(edge.rank());
        let other = gradient.ranks[Grid::opposite(grid.star(vertex), vertex, edge.code())];
        [self.end(edge.rank()), self.end(other)]
    }

    fn rules(&mut self) -> Rules {
        let block = self.block;
        let (gradient, grid) = (&block.gradient, &block.gradient.grid);
        let mut rules = Rules::default();
        for &(rank, others) in &block.rim {
            let vertex = gradient.vertex(rank);
            if !matches!(gradient.fate(vertex << grid.axes()), Fate::Up(..) | Fate::Critical) {
                continue;
            }
            // Edges are owned by the end that enters later.
            let edges = (1..grid.codes.count() as Code)
                .filter(|&code| others >> code & 1 == 1 && grid.codes.degree(code) == 1);
            let mut askers: Vec<u64> = edges.filter_map(|edge| block.other_owner(rank, edge)).collect();
            askers.sort_unstable();
            askers.dedup();
            if !askers.is_empty() {
                let entry = (block.key(rank), block.name(Cell::new(rank, 0)));
                rules.push(2, entry, askers, [(self.end(rank), 1)]);
            }
        }
        rules
    }
}

/// Where the top cells of a block flow to, through their facets.
struct TopCells<'a> {
    block: &'a Block<'a>,
    forest: Forest,
}

impl<'a> TopCells<'a> {
    fn new(block: &'a Block<'a>) -> Self {
        let (gradient, grid) = (&block.gradient, &block.gradient.grid);
        let parent = |base: u32| match gradient.fate(grid.top_place(base as usize)) {
            Fate::Down(axis, side) => grid.next(base as usize, axis, -side) as u32,
            _ => base,
        };
        let bases = (0..grid.vertex_count() as u32).into_par_iter();
        Self { block, forest: Forest::new(bases.map(parent).collect()) }
    }

    /// Where a top cell, by its first vertex, flows to.
    fn end(&mut self, base: usize) -> Name {
        let gradient = &self.block.gradient;
        let base = self.forest.root(base as u32) as usize;
        let owned = gradient.owned(base, gradient.grid.codes.top_corners());
        match owned.filter(|cell| cell.rank() != NEVER) {
            Some(cell) => self.block.name(cell),
            None => OUTSIDE_NAME,
        }
    }

    fn beside(&mut self, facet: Cell) -> [Name; 2] {
        let (gradient, grid) = (&self.block.gradient, &self.block.gradient.grid);
        let vertex = gradient.vertex(facet.rank());
        let axis = grid.codes.flat_axis(facet.code()).expect("a facet is flat along an axis");
        let star = grid.star(vertex);
        [1, -1].map(|side| self.end(Grid::base(star, vertex, grid.codes.extended(facet.code(), axis, side))))
    }

    fn rules(&mut self) -> Rules {
        let block = self.block;
        let (gradient, grid) = (&block.gradient, &block.gradient.grid);
        let mut rules = Rules::default();
        for &(rank, others) in &block.rim {
            let vertex = gradient.vertex(rank);
            let star = grid.star(vertex);
            let owned = lower_star(grid, &gradient.ranks, vertex);
            let is_asked = |&code: &Code| owned >> code & 1 == 1 && grid.codes.degree(code) == grid.axes();
            for code in (1..grid.codes.count() as Code).filter(is_asked) {
                if !matches!(gradient.fate(grid.place(star, vertex, code)), Fate::Down(..) | Fate::Critical) {
                    continue;
                }
                let corners = grid.codes.corners(code.into()) & others;
                let corners = (0..grid.codes.count()).filter(|&corner| corners >> corner & 1 == 1);
                let rank_of = |corner: usize| gradient.ranks[Grid::opposite(star, vertex, corner as Code)];
                let mut askers: Vec<u64> = corners.map(|corner| block.block_of(rank_of(corner))).collect();
                askers.sort_unstable();
                askers.dedup();
                if !askers.is_empty() {
                    let entry = (block.key(rank), block.name(Cell::new(rank, code)));
                    rules.push(2, entry, askers, [(self.end(Grid::base(star, vertex, code)), 1)]);
                }
            }
        }
        rules
    }
}
