//! The sweep along the parameter: which vertices change places when, and what follows for the cells.

use super::decomposition::{Decomposition, NONE};
use super::vine::{Motion, Stretch, Vine};
use crate::homology::Coefficients;
use crate::persistence::Filtration;
use crate::persistence::reduction::prime;
use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::stage;
use coface_algebra::{Binary, Error, Field, Odd, RaggedArray};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The vines of functions on the vertices: the paths of the points of the diagram of sublevel sets, as the first function becomes the second one, that the third
/// one, and so on, each vertex along a line. By rising degree, then in the order of the parameters where they begin.
///
/// At each given function the vines have the points of its diagram. A vine that begins between functions begins on the diagonal, and one that ends between them
/// ends there. Points of persistence 0 are left out.
///
/// # Errors
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if there is no function; those of [`Filtration::lower_star`] for each function, and of
/// [`persistence`](crate::persistence).
///
/// # Complexity
/// That of a diagram by boundary columns, with what they are sums of; then for each two vertices that change places the product of the numbers of cells that enter
/// with them, a transposition each, which adds at most two columns. Memory: the reduced boundaries, the sums and the vines, at worst quadratic in the number of
/// cells.
///
/// # References
/// D. Cohen-Steiner, H. Edelsbrunner, D. Morozov, *Vines and vineyards by updating persistence in linear time* (2006).
///
/// # Examples
/// A path of three vertices, whose valley at the end becomes flat.
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::{Coefficients, vineyard};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
/// let path = ChainComplex::new(vec![edges])?;
/// let vines = vineyard(&path, &[vec![0.0, 4.0, 2.0], vec![0.0, 4.0, 6.0]], Coefficients::Modulo(2))?;
/// assert_eq!((vines.len(), vines[1].degree(), vines[1].persistence()), (2, 0, 2.0));
/// // Half way vertex 2 is as high as vertex 1.
/// let points: Vec<_> = vines[1].points().iter().map(|at| (at.parameter(), at.birth(), at.death())).collect();
/// assert_eq!(points, [(0.0, 2.0, Some(4.0)), (0.5, 4.0, Some(4.0))]);
/// # Ok(()) }
/// ```
pub fn vineyard(
    complex: &ChainComplex,
    functions: &[Vec<f64>],
    coefficients: Coefficients,
) -> Result<Vec<Vine>, Error> {
    let prime = prime(coefficients)?;
    if functions.is_empty() {
        return Err(
            Error::invalid("there is no function").with_cure("give a value for each vertex, once or more")
        );
    }
    for function in functions {
        Filtration::lower_star(complex, function)?;
    }
    Ok(match prime {
        2 => Sweep::over(&Binary, complex, functions),
        _ => Sweep::over(&Odd::new(prime), complex, functions),
    })
}

/// The vertices of the cells of a degree, and where the cells that enter with a vertex begin.
struct Stars {
    vertices: RaggedArray,
    /// The last vertex of each cell.
    last: Vec<u32>,
    /// By ranks of vertices; one more than there are.
    starts: Vec<u32>,
}

struct Sweep<'a, F: Field> {
    motion: Motion<'a>,
    decomposition: Decomposition<'a, F>,
    stars: Vec<Stars>,
    /// The vertices in the order of their values, and the place of each.
    order: Vec<u32>,
    ranks: Vec<u32>,
    /// For each cell that makes a class the number of its path.
    paths: Vec<Vec<u32>>,
    stretches: Vec<(usize, Vec<Stretch>)>,
}

impl<'a, F: Field> Sweep<'a, F> {
    fn over(field: &'a F, complex: &ChainComplex, functions: &'a [Vec<f64>]) -> Vec<Vine> {
        let mut sweep = Self::begun(field, complex, functions);
        let steps = stage("moving the function", functions.len() - 1);
        for place in steps.each(0..functions.len() - 1) {
            sweep.run(place, || steps.advance(0));
        }
        let mut vines = Vec::new();
        for (degree, stretches) in &sweep.stretches {
            sweep.motion.vines(*degree, stretches, &mut vines);
        }
        vines.sort_by(|a, b| {
            let begins = |vine: &Vine| (vine.points[0].parameter, vine.points[0].birth);
            a.degree
                .cmp(&b.degree)
                .then(begins(a).0.total_cmp(&begins(b).0))
                .then(begins(a).1.total_cmp(&begins(b).1))
        });
        vines
    }

    fn begun(field: &'a F, complex: &ChainComplex, functions: &'a [Vec<f64>]) -> Self {
        let mut order: Vec<u32> = (0..functions[0].len() as u32).collect();
        order.sort_by(|&a, &b| functions[0][a as usize].total_cmp(&functions[0][b as usize]).then(a.cmp(&b)));
        let mut ranks = vec![0; order.len()];
        for (rank, &vertex) in order.iter().enumerate() {
            ranks[vertex as usize] = rank as u32;
        }
        let mut stars: Vec<Stars> = Vec::new();
        let mut orders = Vec::new();
        for degree in 0..complex.degree_count() {
            let vertices = vertices_of(complex, degree, stars.last().map(|below| &below.vertices));
            let last: Vec<u32> = vertices.iter().map(|cell| last_of(cell, &ranks)).collect();
            let mut cells: Vec<u32> = (0..last.len() as u32).collect();
            cells.sort_by_key(|&cell| ranks[last[cell as usize] as usize]);
            let mut starts = vec![0; order.len() + 1];
            for &vertex in &last {
                starts[ranks[vertex as usize] as usize + 1] += 1;
            }
            for rank in 0..order.len() {
                starts[rank + 1] += starts[rank];
            }
            stars.push(Stars { vertices, last, starts });
            orders.push(cells);
        }
        let decomposition = Decomposition::new(field, complex, orders);
        let mut sweep = Self {
            motion: Motion { functions },
            decomposition,
            paths: stars.iter().map(|star| vec![NONE; star.last.len()]).collect(),
            stars,
            order,
            ranks,
            stretches: Vec::new(),
        };
        for degree in 0..sweep.stars.len() {
            for cell in 0..sweep.paths[degree].len() {
                if sweep.decomposition.levels[degree].born[cell] == NONE {
                    sweep.paths[degree][cell] = sweep.stretches.len() as u32;
                    sweep.stretches.push((degree, vec![sweep.stretch(degree, cell as u32, 0.0)]));
                }
            }
        }
        sweep
    }

    /// The vertices that the birth and the death of the class of a cell have their values from.
    fn stretch(&self, degree: usize, cell: u32, from: f64) -> Stretch {
        let dead = self.decomposition.levels[degree].dead[cell as usize];
        let death = (dead != NONE).then(|| self.stars[degree + 1].last[dead as usize]);
        Stretch { from, birth: self.stars[degree].last[cell as usize], death }
    }

    /// From one function to the next.
    fn run(&mut self, place: usize, mut tick: impl FnMut()) {
        let functions = self.motion.functions;
        let (from, to) = (&functions[place], &functions[place + 1]);
        // When the first of two vertices passes the second one, if it is behind it in the end; the bits of numbers that are not negative have their order.
        let meeting = |a: u32, b: u32| {
            let (i, j) = (a as usize, b as usize);
            let is_turned = to[i].total_cmp(&to[j]).then(i.cmp(&j)).is_gt();
            let (before, behind) = (from[j] / 2.0 - from[i] / 2.0, to[i] / 2.0 - to[j] / 2.0);
            let total = before + behind;
            let part = if total > 0.0 { (before / total).clamp(0.0, 1.0) } else { 0.0 };
            is_turned.then_some(Reverse((part.to_bits(), a, b)))
        };
        let mut events: BinaryHeap<_> =
            self.order.windows(2).filter_map(|two| meeting(two[0], two[1])).collect();
        let mut now = 0.0;
        while let Some(Reverse((part, a, b))) = events.pop() {
            let rank = self.ranks[a as usize] as usize;
            if self.ranks[b as usize] as usize != rank + 1 {
                continue;
            }
            tick();
            now = f64::max(now, f64::from_bits(part));
            self.swap(rank, place as f64 + now);
            if rank > 0 {
                events.extend(meeting(self.order[rank - 1], b));
            }
            events.extend(self.order.get(rank + 2).and_then(|&next| meeting(a, next)));
        }
    }

    /// Lets the vertex of a rank and the next one change places, and the cells that enter with them.
    fn swap(&mut self, rank: usize, parameter: f64) {
        let (u, v) = (self.order[rank], self.order[rank + 1]);
        for degree in 0..self.stars.len() {
            let [start, middle, end] = [0, 1, 2].map(|next| self.stars[degree].starts[rank + next] as usize);
            let mut target = start;
            for place in middle..end {
                let cell = self.decomposition.levels[degree].order[place] as usize;
                if self.stars[degree].vertices.list(cell).binary_search(&u).is_ok() {
                    self.stars[degree].last[cell] = u;
                    continue;
                }
                for at in (target..place).rev() {
                    self.transpose(degree, at);
                }
                target += 1;
            }
            self.stars[degree].starts[rank + 1] = target as u32;
        }
        self.order.swap(rank, rank + 1);
        self.ranks.swap(u as usize, v as usize);
        for degree in 0..self.stars.len() {
            let [start, end] = [0, 2].map(|next| self.stars[degree].starts[rank + next] as usize);
            for place in start..end {
                let cell = self.decomposition.levels[degree].order[place];
                match self.decomposition.levels[degree].born[cell as usize] {
                    NONE => self.follow(degree, cell, parameter),
                    born => self.follow(degree - 1, born, parameter),
                }
            }
        }
    }

    fn transpose(&mut self, degree: usize, place: usize) {
        let level = &self.decomposition.levels[degree];
        let [a, b] = [level.order[place] as usize, level.order[place + 1] as usize];
        if !self.decomposition.transpose(degree, place) {
            return;
        }
        // The classes stay what they are, and have other cells.
        let level = &self.decomposition.levels[degree];
        if level.born[a] == NONE {
            self.paths[degree].swap(a, b);
        }
    }

    /// Notes on which vertices the birth and the death of the class of a cell depend from now on.
    fn follow(&mut self, degree: usize, cell: u32, parameter: f64) {
        let next = self.stretch(degree, cell, parameter);
        let path = self.paths[degree][cell as usize] as usize;
        let stretches = &mut self.stretches[path].1;
        let is_same = |last: Option<&Stretch>| {
            last.is_some_and(|last| (last.birth, last.death) == (next.birth, next.death))
        };
        if is_same(stretches.last()) {
            return;
        }
        // Of vertices that meet at one parameter the last word counts.
        if stretches.last().is_some_and(|last| last.from == parameter) {
            stretches.pop();
        }
        if !is_same(stretches.last()) {
            stretches.push(next);
        }
    }
}

fn last_of(cell: &[u32], ranks: &[u32]) -> u32 {
    let last = cell.iter().copied().max_by_key(|&vertex| ranks[vertex as usize]);
    last.expect("a lower star has vertices for each cell")
}

/// The vertices of the cells of a degree, rising, from those of the degree below.
fn vertices_of(complex: &ChainComplex, degree: usize, below: Option<&RaggedArray>) -> RaggedArray {
    let mut all = RaggedArray::new();
    let mut vertices = Vec::new();
    for cell in 0..complex.cell_count(degree) {
        vertices.clear();
        match (below, complex.boundary_matrix(degree)) {
            (Some(below), Some(matrix)) if degree > 0 => {
                for &face in matrix.column(cell).rows() {
                    vertices.extend_from_slice(below.list(face as usize));
                }
            }
            _ => vertices.push(cell as u32),
        }
        vertices.sort_unstable();
        vertices.dedup();
        all.push(&vertices);
    }
    all
}
