//! Short loops from breadth-first trees in the place of the generators of degree 1.

use crate::homology::basis::{HomologyBasis, length, to_vector};
use coface_algebra::progress::stage;
use coface_algebra::{Integer, SparseMatrix, SparseVector, WideMatrix};

/// Exchanges generators of degree 1 against shorter loops, as long as the 1-skeleton is a graph.
///
/// A breadth-first tree from a vertex of the longest generator gives, with each edge that is not in it, the loop that
/// the edge closes, without the common tail of its two sides. The dual cocycles, as annotations of the edges, tell its
/// class. It takes the place of a longer generator on which its coefficient is 1 or -1: then they remain a basis. The
/// number of trees falls with the size of the graph, and so does that of exchanges with the number of generators.
///
/// # References
/// J. Erickson and K. Whittlesey, *Greedy optimal homotopy and homology generators* (2005), for loops of shortest-path
/// trees; O. Busaryev, S. Cabello, C. Chen, T. Dey and Y. Wang, *Annotating simplices with a homology basis and its
/// applications* (2012).
pub(super) fn exchange_loops(basis: &mut HomologyBasis<'_>) {
    /// Vertices and edges that all trees together may visit.
    const WORK: usize = 12_000_000;
    const MOST_TREES: usize = 16;
    /// Trees in a row without any gain, after which no more are grown.
    const MOST_VAIN_TREES: usize = 2;
    /// Terms that all changes of basis together may touch.
    const MOST_TERMS: usize = 40_000_000;
    let Some(graph) = basis.complex().boundary_matrix(1).and_then(Graph::new) else { return };
    let annotations = basis.annotations(1);
    let Some(marks) = Marks::new(basis, &annotations) else { return };
    let mut exchanges = Exchanges::new(basis);
    let mut is_used = vec![false; graph.starts.len() - 1];
    let tree_count = (WORK / (graph.arcs.len() + is_used.len()).max(1)).clamp(1, MOST_TREES);
    let mut vain_count = 0;
    let steps = stage("comparing loops", tree_count);
    for _ in 0..tree_count {
        steps.advance(1);
        let Some(root) = exchanges.next_root(basis, &graph, &mut is_used) else { break };
        let tree = Tree::new(&graph, root, &marks);
        let mut is_shorter = false;
        for candidate in tree.loops(&graph, &marks) {
            if exchanges.longest() <= candidate.len() as u64 || exchanges.term_count > MOST_TERMS {
                break;
            }
            let class = exchanges.in_present_basis(&annotations, &candidate, basis);
            is_shorter |= exchanges.offer(basis, &class, candidate);
        }
        vain_count = if is_shorter { 0 } else { vain_count + 1 };
        if vain_count == MOST_VAIN_TREES {
            break;
        }
    }
}

/// The 1-skeleton: at each vertex its edges with the vertices at their other ends.
struct Graph<'m> {
    matrix: &'m SparseMatrix,
    starts: Vec<u32>,
    arcs: Vec<(u32, u32)>,
}

impl<'m> Graph<'m> {
    /// `None` unless each edge has two ends, one of each sign, or none (a loop).
    fn new(matrix: &'m SparseMatrix) -> Option<Self> {
        let mut starts = vec![0u32; matrix.row_count() + 1];
        for column in matrix.columns() {
            match column.entries() {
                [] => {}
                [-1, 1] | [1, -1] => {
                    for &vertex in column.rows() {
                        starts[vertex as usize + 1] += 1;
                    }
                }
                _ => return None,
            }
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let mut arcs = vec![(0, 0); starts.last().map_or(0, |&end| end as usize)];
        for (edge, column) in matrix.columns().enumerate() {
            if let &[a, b] = column.rows() {
                for (from, to) in [(a, b), (b, a)] {
                    arcs[next[from as usize] as usize] = (edge as u32, to);
                    next[from as usize] += 1;
                }
            }
        }
        Some(Self { matrix, starts, arcs })
    }

    fn arcs(&self, vertex: u32) -> &[(u32, u32)] {
        &self.arcs[self.starts[vertex as usize] as usize..self.starts[vertex as usize + 1] as usize]
    }

    /// 1 if walking along the edge towards this vertex is its direction, else -1.
    fn sign_towards(&self, edge: u32, vertex: u32) -> i64 {
        i64::from(self.matrix.entry(vertex as usize, edge as usize))
    }
}

/// One number an edge that tells most classes apart: a random combination of the free annotations modulo 2^64 and,
/// exact, those of a few generators of finite order. Only where it is zero is a loop passed over.
struct Marks {
    free: Vec<u64>,
    /// The values modulo the order, with the order.
    torsion: Vec<(Vec<i64>, i64)>,
}

impl Marks {
    fn new(basis: &HomologyBasis<'_>, annotations: &WideMatrix) -> Option<Self> {
        const MOST_TORSION: usize = 4;
        let generators = basis.generators(1);
        let orders: Vec<Option<i64>> = generators
            .iter()
            .map(|generator| generator.order().map(|order| order.to_i64().unwrap_or(0)))
            .collect();
        let torsion_numbers: Vec<usize> = (0..orders.len())
            .filter(|&i| orders[i].is_some_and(|order| order > 1 && order < 1 << 31))
            .take(MOST_TORSION)
            .collect();
        let mut free = vec![0u64; annotations.column_count()];
        let mut torsion: Vec<(Vec<i64>, i64)> = torsion_numbers
            .iter()
            .map(|&i| (vec![0; annotations.column_count()], orders[i].unwrap_or(1)))
            .collect();
        for (edge, column) in annotations.columns().enumerate() {
            for (generator, value) in column.terms() {
                match orders[generator] {
                    None => {
                        let value = value.to_i64()? as u64;
                        free[edge] = free[edge].wrapping_add(value.wrapping_mul(mixed(generator as u64)));
                    }
                    Some(_) => {
                        if let Some(at) = torsion_numbers.iter().position(|&i| i == generator) {
                            let order = torsion[at].1;
                            let rest = value.div_rem_floor(&Integer::from(order)).1;
                            torsion[at].0[edge] = rest.to_i64().unwrap_or_default();
                        }
                    }
                }
            }
        }
        Some(Self { free, torsion })
    }
}

/// A fixed odd number for each number, by the finalizer of splitmix64.
fn mixed(number: u64) -> u64 {
    let mut x = number.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (x ^ (x >> 31)) | 1
}

/// A breadth-first tree of one component, with the marks summed up from the root.
struct Tree {
    nodes: Vec<Node>,
    torsion: Vec<Vec<i64>>,
}

/// A vertex of the tree.
#[derive(Clone, Copy)]
struct Node {
    /// The edge and the vertex towards the root; [`NONE`] for the root and for vertices not reached.
    edge: u32,
    parent: u32,
    /// [`NONE`] for vertices not reached.
    depth: u32,
    free: u64,
}

const NONE: u32 = u32::MAX;

/// A loop: its edges with signs, by rising edges.
type Loop = SparseVector;

impl Tree {
    fn new(graph: &Graph<'_>, root: u32, marks: &Marks) -> Self {
        let count = graph.starts.len() - 1;
        let mut tree = Self {
            nodes: vec![Node { edge: NONE, parent: NONE, depth: NONE, free: 0 }; count],
            torsion: vec![vec![0; count]; marks.torsion.len()],
        };
        tree.nodes[root as usize].depth = 0;
        let mut queue = vec![root];
        let mut at = 0;
        while let Some(&vertex) = queue.get(at) {
            at += 1;
            let Node { depth, free, .. } = tree.nodes[vertex as usize];
            for &(edge, to) in graph.arcs(vertex) {
                let node = &mut tree.nodes[to as usize];
                if node.depth != NONE {
                    continue;
                }
                let sign = graph.sign_towards(edge, to);
                let step = marks.free[edge as usize].wrapping_mul(sign as u64);
                *node = Node { edge, parent: vertex, depth: depth + 1, free: free.wrapping_add(step) };
                for (sums, (values, order)) in tree.torsion.iter_mut().zip(&marks.torsion) {
                    sums[to as usize] =
                        (sums[vertex as usize] + sign * values[edge as usize]).rem_euclid(*order);
                }
                queue.push(to);
            }
        }
        tree
    }

    /// Loops closed by edges outside of the tree whose marks do not cancel: for each mark the one nearest to the root,
    /// the shorter ones first. Their number is bounded.
    fn loops(&self, graph: &Graph<'_>, marks: &Marks) -> Vec<Loop> {
        const MOST_LOOPS: usize = 4096;
        let mut candidates: Vec<(u64, Vec<i64>, u32, u32)> = Vec::new();
        for (edge, column) in graph.matrix.columns().enumerate() {
            let (mut mark, mut residues, reach) = match *column.rows() {
                [a, b] => {
                    let (from, to) = if column.entries() == [-1, 1] { (a, b) } else { (b, a) };
                    let (start, end) = (self.nodes[from as usize], self.nodes[to as usize]);
                    let is_in_tree = start.edge == edge as u32 || end.edge == edge as u32;
                    if is_in_tree || start.depth == NONE {
                        continue;
                    }
                    let mark = start.free.wrapping_add(marks.free[edge]).wrapping_sub(end.free);
                    let residue = |(sums, (values, order)): (&Vec<i64>, &(Vec<i64>, i64))| {
                        (sums[from as usize] + values[edge] - sums[to as usize]).rem_euclid(*order)
                    };
                    let residues: Vec<i64> = self.torsion.iter().zip(&marks.torsion).map(residue).collect();
                    (mark, residues, start.depth + end.depth + 1)
                }
                _ => (marks.free[edge], marks.torsion.iter().map(|(values, _)| values[edge]).collect(), 1),
            };
            if mark == 0 && residues.iter().all(|&residue| residue == 0) {
                continue;
            }
            // A loop and its reverse are one.
            let opposite: Vec<i64> =
                residues.iter().zip(&marks.torsion).map(|(x, (_, order))| (-x).rem_euclid(*order)).collect();
            if (mark.wrapping_neg(), &opposite) < (mark, &residues) {
                (mark, residues) = (mark.wrapping_neg(), opposite);
            }
            candidates.push((mark, residues, reach, edge as u32));
        }
        candidates.sort_unstable();
        candidates.dedup_by(|next, kept| (next.0, &next.1) == (kept.0, &kept.1));
        candidates.sort_unstable_by_key(|&(.., reach, edge)| (reach, edge));
        candidates.truncate(MOST_LOOPS);
        let mut loops: Vec<Loop> = candidates.iter().map(|&(.., edge)| self.close(graph, edge)).collect();
        loops.sort_by_key(Vec::len);
        loops
    }

    /// The loop that an edge closes, without the path that both sides share.
    fn close(&self, graph: &Graph<'_>, edge: u32) -> Loop {
        let mut terms = vec![(edge, Integer::ONE)];
        if let [a, b] = *graph.matrix.column(edge as usize).rows() {
            let (mut back, mut ahead) = match graph.sign_towards(edge, b) {
                1 => (a, b),
                _ => (b, a),
            };
            while back != ahead {
                let (behind, before) = (self.nodes[back as usize], self.nodes[ahead as usize]);
                if behind.depth > before.depth {
                    let Node { edge, parent, .. } = behind;
                    terms.push((edge, graph.sign_towards(edge, back).into()));
                    back = parent;
                } else {
                    let Node { edge, parent, .. } = before;
                    terms.push((edge, graph.sign_towards(edge, parent).into()));
                    ahead = parent;
                }
            }
        }
        terms.sort_unstable_by_key(|&(edge, _)| edge);
        terms
    }
}

/// What was exchanged so far.
struct Exchanges {
    /// Terms touched so far, a measure of time that is the same on every machine.
    term_count: usize,
    /// (generator, coefficients of its new cycle in the basis before).
    done: Vec<(usize, SparseVector)>,
    /// The present lengths; `None` for cycles with coefficients beyond 64 bits, which stay.
    lengths: Vec<Option<u64>>,
}

impl Exchanges {
    fn new(basis: &HomologyBasis<'_>) -> Self {
        let generators = basis.generators(1).iter();
        let lengths = generators.map(|generator| length(&to_vector(generator.chain()))).collect();
        Self { term_count: 0, done: Vec::new(), lengths }
    }

    fn longest(&self) -> u64 {
        self.lengths.iter().flatten().copied().max().unwrap_or(0)
    }

    /// A vertex of the longest generator that has not been a root yet.
    fn next_root(&self, basis: &HomologyBasis<'_>, graph: &Graph<'_>, is_used: &mut [bool]) -> Option<u32> {
        let mut order: Vec<usize> = (0..self.lengths.len()).filter(|&i| self.lengths[i].is_some()).collect();
        order.sort_by_key(|&i| std::cmp::Reverse(self.lengths[i]));
        let terms = order.into_iter().flat_map(|i| basis.generators(1)[i].chain().terms());
        let mut vertices = terms.flat_map(|(edge, _)| graph.matrix.column(edge.index()).rows());
        vertices.find(|&&vertex| !std::mem::replace(&mut is_used[vertex as usize], true)).copied()
    }

    /// The class of a loop in the basis as it is now.
    fn in_present_basis(
        &mut self,
        annotations: &WideMatrix,
        candidate: &[(u32, Integer)],
        basis: &HomologyBasis<'_>,
    ) -> Vec<Integer> {
        let generators = basis.generators(1);
        let mut class = vec![Integer::ZERO; generators.len()];
        for (edge, sign) in candidate {
            for (generator, value) in annotations.column(*edge as usize).terms() {
                class[generator] += &(sign * value);
            }
        }
        self.term_count += self.done.len() + class.len();
        for (at, coefficients) in &self.done {
            if class[*at].is_zero() {
                continue;
            }
            self.term_count += coefficients.len();
            let own = coefficients.iter().find(|(i, _)| *i as usize == *at).map(|(_, x)| x);
            let new = &class[*at] * own.expect("the coefficient of the generator replaced is a unit");
            for (i, x) in coefficients {
                let i = *i as usize;
                if i == *at {
                    class[i] = new.clone();
                } else {
                    class[i] -= &(&new * x);
                }
            }
        }
        for (x, generator) in class.iter_mut().zip(generators) {
            if let Some(order) = generator.order() {
                *x = x.div_rem_nearest(order).1;
            }
        }
        class
    }

    /// Lets a loop take the place of the longest generator that it may replace, if that is longer.
    fn offer(&mut self, basis: &mut HomologyBasis<'_>, class: &[Integer], candidate: Loop) -> bool {
        let generators = basis.generators(1);
        let is_torsion_only = class.iter().zip(generators).all(|(x, g)| x.is_zero() || g.order().is_some());
        if is_torsion_only && class.iter().filter(|x| !x.is_zero()).count() != 1 {
            return false;
        }
        let replaced = (0..class.len())
            .filter(|&i| class[i].is_unit() && (is_torsion_only || generators[i].order().is_none()))
            .filter_map(|i| Some((self.lengths[i]?, i)))
            .max();
        let Some((_, at)) = replaced.filter(|&(present, _)| present > candidate.len() as u64) else {
            return false;
        };
        let sparse = class.iter().enumerate().filter(|(_, x)| !x.is_zero());
        let sparse: SparseVector = sparse.map(|(i, x)| (i as u32, x.clone())).collect();
        // Each dual that changes is as long as the basis, at worst.
        self.term_count += sparse.len() * class.len();
        self.done.push((at, sparse));
        self.lengths[at] = Some(candidate.len() as u64);
        basis.exchange(1, at, class, candidate);
        true
    }
}
