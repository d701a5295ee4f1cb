//! Shortest paths from sources that move along the boundary of a surface.

use super::free_words::{FreeWords, NEUTRAL};
use super::weights::without_noise;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::RangeInclusive;

/// No node, no arc.
const NONE: u32 = u32::MAX;
/// Not reached.
const FAR: u128 = u128::MAX;

#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    pub(super) weight: u128,
    pub(super) to: u32,
    /// The class of the arc: paths with the same ends are homotopic if and only if the products of their labels are equal.
    pub(super) label: u32,
}

/// A directed graph on a surface.
#[derive(Debug)]
pub(super) struct Graph {
    /// Where the arcs out of each node start.
    pub(super) starts: Vec<u32>,
    pub(super) arcs: Vec<Arc>,
}

impl Graph {
    fn arcs_of(&self, node: u32) -> std::ops::Range<usize> {
        self.starts[node as usize] as usize..self.starts[node as usize + 1] as usize
    }

    fn node_count(&self) -> usize {
        self.starts.len() - 1
    }
}

/// A tree of shortest paths from one source.
#[derive(Debug)]
pub(super) struct Tree {
    distances: Vec<u128>,
    /// The node before each node, the arc from there, and the label of the path, with that of the way to the source before it.
    nodes: Vec<u32>,
    arcs: Vec<u32>,
    labels: Vec<u32>,
    /// The nodes that were reached, nearest first.
    reached: Vec<u32>,
    touched: Vec<u32>,
}

impl Tree {
    pub(super) fn new(node_count: usize) -> Self {
        Self {
            distances: vec![FAR; node_count],
            nodes: vec![NONE; node_count],
            arcs: vec![NONE; node_count],
            labels: vec![NEUTRAL; node_count],
            reached: Vec::new(),
            touched: Vec::new(),
        }
    }

    fn clear(&mut self) {
        for &node in &self.touched {
            self.distances[node as usize] = FAR;
            self.nodes[node as usize] = NONE;
            self.arcs[node as usize] = NONE;
            self.labels[node as usize] = NEUTRAL;
        }
        self.touched.clear();
        self.reached.clear();
    }

    /// The tree of all nodes nearer to the source than `radius`.
    pub(super) fn grow(
        &mut self,
        graph: &Graph,
        source: (u32, u32),
        radius: u128,
        words: &mut FreeWords,
        heap: &mut BinaryHeap<Reverse<(u128, u32)>>,
    ) {
        self.clear();
        let (root, label) = source;
        self.distances[root as usize] = 0;
        self.labels[root as usize] = label;
        self.touched.push(root);
        heap.push(Reverse((0, root)));
        while let Some(Reverse((distance, node))) = heap.pop() {
            if distance > self.distances[node as usize] {
                continue;
            }
            self.reached.push(node);
            for index in graph.arcs_of(node) {
                let arc = graph.arcs[index];
                let through = distance + arc.weight;
                let to = arc.to as usize;
                if through < self.distances[to] && through < radius {
                    if self.distances[to] == FAR {
                        self.touched.push(arc.to);
                    }
                    self.distances[to] = through;
                    self.nodes[to] = node;
                    self.arcs[to] = index as u32;
                    self.labels[to] = words.times(self.labels[node as usize], arc.label);
                    heap.push(Reverse((through, arc.to)));
                }
            }
        }
    }

    pub(super) fn reached_count(&self) -> usize {
        self.reached.len()
    }

    /// The length of the path to a node; none if it was not reached.
    pub(super) fn distance(&self, node: u32) -> Option<u128> {
        Some(self.distances[node as usize]).filter(|&distance| distance != FAR)
    }

    /// The arcs of the path to a node.
    pub(super) fn path_to(&self, node: u32) -> Vec<u32> {
        let mut arcs = Vec::new();
        let mut at = node;
        while self.arcs[at as usize] != NONE {
            arcs.push(self.arcs[at as usize]);
            at = self.nodes[at as usize];
        }
        arcs.reverse();
        arcs
    }
}

/// A graph with the sources of an interval and the target that belongs to each.
#[derive(Debug)]
pub(super) struct Local {
    pub(super) graph: Graph,
    pub(super) sources: Vec<u32>,
    /// A node and the length of the way on from there; none for a target that is too far away.
    pub(super) targets: Vec<Option<(u32, u128)>>,
}

/// What contraction needs for each node; cleared after each.
#[derive(Debug)]
struct Scratch {
    is_source: Vec<bool>,
    /// The node that each node is contracted into; `NONE` for nodes that are dropped.
    kept_as: Vec<u32>,
    numbers: Vec<u32>,
    /// Lists of the nodes that are contracted into each node.
    first: Vec<u32>,
    next: Vec<u32>,
    /// For each new node: the new node whose arcs were made last, and the arc to it.
    stamps: Vec<u32>,
    slots: Vec<u32>,
}

impl Scratch {
    fn new(node_count: usize) -> Self {
        Self {
            is_source: vec![false; node_count],
            kept_as: vec![NONE; node_count],
            numbers: vec![NONE; node_count],
            first: vec![NONE; node_count],
            next: vec![NONE; node_count],
            stamps: vec![NONE; node_count],
            slots: vec![NONE; node_count],
        }
    }

    /// The graph for the sources of `range`, with the trees from its two ends: nodes that are `limit` or farther from one of the two are
    /// dropped; what has the same last arc and homotopic paths in both trees is contracted into the node before it.
    fn contracted(
        &mut self,
        words: &mut FreeWords,
        local: &Local,
        trees: [&Tree; 2],
        range: RangeInclusive<usize>,
        limit: u128,
    ) -> (Local, [Tree; 2]) {
        let [a, b] = trees;
        for &source in &local.sources[range.clone()] {
            self.is_source[source as usize] = true;
        }
        let is_near = |node: u32| a.distances[node as usize] < limit && b.distances[node as usize] < limit;
        let near: Vec<u32> = a.reached.iter().copied().filter(|&node| is_near(node)).collect();
        let mut kept = Vec::new();
        for &node in &near {
            let at = node as usize;
            let is_stable = !self.is_source[at]
                && a.arcs[at] != NONE
                && a.arcs[at] == b.arcs[at]
                && a.labels[at] == b.labels[at];
            if is_stable {
                // Nearer to both, so it is not dropped, and it comes before.
                self.kept_as[at] = self.kept_as[a.nodes[at] as usize];
            } else {
                self.kept_as[at] = node;
                self.numbers[at] = kept.len() as u32;
                kept.push(node);
            }
        }
        for &node in near.iter().rev() {
            let kept_as = self.kept_as[node as usize] as usize;
            self.next[node as usize] = self.first[kept_as];
            self.first[kept_as] = node;
        }
        let offset = |node: u32, kept: u32| a.distances[node as usize] - a.distances[kept as usize];
        let mut graph = Graph { starts: Vec::with_capacity(kept.len() + 1), arcs: Vec::new() };
        graph.starts.push(0);
        let mut below = [Tree::new(kept.len()), Tree::new(kept.len())];
        let mut expected = vec![[None; 2]; kept.len()];
        for (number, &from) in (0u32..).zip(&kept) {
            let mut node = self.first[from as usize];
            while node != NONE {
                let along = offset(node, from);
                let label = match (a.labels[from as usize], a.labels[node as usize]) {
                    (x, y) if x == y => NEUTRAL,
                    (x, y) => {
                        let back = words.inverse(x);
                        words.times(back, y)
                    }
                };
                for index in local.graph.arcs_of(node) {
                    let arc = local.graph.arcs[index];
                    let to = self.numbers[arc.to as usize];
                    if to == NONE || to == number {
                        continue;
                    }
                    let made = Arc { weight: along + arc.weight, to, label: words.times(label, arc.label) };
                    if self.stamps[to as usize] != number {
                        self.stamps[to as usize] = number;
                        self.slots[to as usize] = graph.arcs.len() as u32;
                        graph.arcs.push(made);
                    } else if made.weight < graph.arcs[self.slots[to as usize] as usize].weight {
                        graph.arcs[self.slots[to as usize] as usize] = made;
                    }
                    for (which, tree) in trees.iter().enumerate() {
                        if tree.arcs[arc.to as usize] == index as u32 {
                            below[which].nodes[to as usize] = number;
                            below[which].arcs[to as usize] = self.slots[to as usize];
                            expected[to as usize][which] = Some((made.weight, made.label));
                        }
                    }
                }
                node = self.next[node as usize];
            }
            graph.starts.push(graph.arcs.len() as u32);
        }
        for (which, (tree, above)) in below.iter_mut().zip(trees).enumerate() {
            for (number, &node) in kept.iter().enumerate() {
                tree.distances[number] = above.distances[node as usize];
                tree.labels[number] = above.labels[node as usize];
                // Of arcs between the same nodes the shortest is kept; a tree whose arc has an equal is not to be trusted there.
                let is_kept = expected[number][which].is_some_and(|(weight, label)| {
                    let arc = graph.arcs[tree.arcs[number] as usize];
                    arc.weight == weight && arc.label == label
                });
                if !is_kept {
                    tree.arcs[number] = NONE;
                }
            }
            let numbers = above.reached.iter().map(|&node| self.numbers[node as usize]);
            tree.reached = numbers.filter(|&number| number != NONE).collect();
        }
        let sources = &local.sources[range.clone()];
        let targets = local.targets[range].iter().map(|target| {
            let (node, on) = (*target)?;
            let kept_as = Some(self.kept_as[node as usize]).filter(|&kept| kept != NONE)?;
            Some((self.numbers[kept_as as usize], on + offset(node, kept_as)))
        });
        let made = Local {
            graph,
            sources: sources.iter().map(|&source| self.numbers[source as usize]).collect(),
            targets: targets.collect(),
        };
        for &source in sources {
            self.is_source[source as usize] = false;
        }
        for &node in &near {
            self.kept_as[node as usize] = NONE;
            self.numbers[node as usize] = NONE;
            self.first[node as usize] = NONE;
        }
        self.stamps[..kept.len()].fill(NONE);
        (made, below)
    }
}

/// How far a search may go, and how far it went.
pub(super) struct Limits<'a> {
    pub(super) is_over: &'a dyn Fn() -> bool,
    pub(super) is_stopped: bool,
    pub(super) reached: usize,
    pub(super) most: usize,
}

impl Limits<'_> {
    /// Whether the search is to end.
    pub(super) fn stops(&mut self) -> bool {
        self.is_stopped = self.is_stopped || (self.is_over)();
        self.is_stopped
    }
}

/// The search for the nearest pair of a source and its target.
pub(super) struct NearestPair<'a, 'b> {
    pub(super) limits: &'a mut Limits<'b>,
    words: FreeWords,
    heap: BinaryHeap<Reverse<(u128, u32)>>,
    scratch: Scratch,
    /// The length of the boundary from the first source to each, and its label.
    positions: Vec<u128>,
    labels: Vec<u32>,
    /// The distance of each source that was asked for from its target, or a number that it does not fall below.
    values: Vec<u128>,
    best: u128,
    best_source: Option<usize>,
    /// No pair that was not searched for is nearer than this.
    open: u128,
}

/// What was found.
pub(super) struct Nearest {
    /// The source and the distance of the nearest pair, if it is nearer than what was known.
    pub(super) pair: Option<(usize, u128)>,
    /// No pair that was not searched for is nearer than this.
    pub(super) open: u128,
}

impl<'a, 'b> NearestPair<'a, 'b> {
    /// The nearest pair among those nearer than `best`. `local` has the whole graph; its sources are a path on the boundary, and
    /// `along` has its arcs.
    ///
    /// Trees are grown from the ends of intervals of at most half of `best`, and from the middles of what is between, in
    /// the graph that the trees from the ends of each interval leave.
    pub(super) fn find(
        limits: &'a mut Limits<'b>,
        words: FreeWords,
        local: &Local,
        along: &[Arc],
        best: u128,
    ) -> Nearest {
        let node_count = local.graph.node_count();
        let mut search = Self {
            limits,
            words,
            heap: BinaryHeap::new(),
            scratch: Scratch::new(node_count),
            positions: vec![0],
            labels: vec![NEUTRAL],
            values: vec![0; local.sources.len()],
            best,
            best_source: None,
            open: FAR,
        };
        for (i, arc) in along.iter().enumerate() {
            search.positions.push(search.positions[i] + arc.weight);
            let label = search.words.times(search.labels[i], arc.label);
            search.labels.push(label);
        }
        search.run(local);
        Nearest { pair: search.best_source.map(|source| (source, search.best)), open: search.open }
    }

    fn run(&mut self, local: &Local) {
        let node_count = local.graph.node_count();
        let mut ends = vec![0];
        let last = local.sources.len() - 1;
        while let Some(&from) = ends.last().filter(|&&from| from < last) {
            let limit = self.positions[from] + self.best / 2;
            let to = self.positions.partition_point(|&position| position <= limit) - 1;
            ends.push(to.clamp(from + 1, last));
        }
        let span = |i: usize| {
            let length = |j: usize| self.positions[ends[j + 1]] - self.positions[ends[j]];
            let before = if i == 0 { 0 } else { length(i - 1) };
            before.max(if i + 1 == ends.len() { 0 } else { length(i) })
        };
        let spans: Vec<u128> = (0..ends.len()).map(span).collect();
        let mut trees = [Tree::new(node_count), Tree::new(node_count)];
        for (i, &end) in ends.iter().enumerate() {
            if self.limits.stops() {
                // What is before the last end is counted already.
                let before = if i == 0 { 0 } else { self.values[ends[i - 1]] };
                let rest = self.positions[last] - self.positions[ends[i.max(1) - 1]];
                self.open = self.open.min(before.saturating_sub(2 * rest));
                return;
            }
            trees.swap(0, 1);
            self.grow(&mut trees[1], local, end, end, spans[i]);
            if i > 0 {
                self.enter(local, [&trees[0], &trees[1]], 0, ends[i - 1]..=end);
            }
        }
    }

    /// Grows the tree from a source, which is at `index` among those of the graph, and notes how far its target is.
    fn grow(&mut self, tree: &mut Tree, local: &Local, source: usize, index: usize, span: u128) {
        let radius = self.best + span;
        let root = (local.sources[index], self.labels[source]);
        tree.grow(&local.graph, root, radius, &mut self.words, &mut self.heap);
        self.limits.reached += tree.reached_count();
        let reached = local.targets[index].and_then(|(node, on)| Some(tree.distance(node)? + on));
        // What is farther than what is known is as good as that.
        let value = reached.unwrap_or(self.best);
        self.values[source] = value;
        if value < self.best {
            self.best = value;
            self.best_source = Some(source);
        }
    }

    /// Contracts the graph for an interval of sources and searches it; the first source of the graph is number `first`.
    fn enter(&mut self, local: &Local, trees: [&Tree; 2], first: usize, range: RangeInclusive<usize>) {
        let (from, to) = (*range.start(), *range.end());
        if to < from + 2 || self.limits.reached > self.limits.most {
            return;
        }
        let span = self.positions[to] - self.positions[from];
        // The value changes by at most twice the way between two sources.
        let bound = ((self.values[from] + self.values[to]) / 2).saturating_sub(span);
        if without_noise(bound) >= without_noise(self.best) {
            return;
        }
        if self.limits.stops() {
            self.open = self.open.min(bound);
            return;
        }
        let (local, trees) = self.scratch.contracted(
            &mut self.words,
            local,
            trees,
            from - first..=to - first,
            self.best + span,
        );
        let middle = usize::midpoint(from, to);
        let mut tree = Tree::new(local.graph.node_count());
        self.grow(&mut tree, &local, middle, middle - from, span);
        self.enter(&local, [&trees[0], &tree], from, from..=middle);
        self.enter(&local, [&tree, &trees[1]], from, middle..=to);
    }
}
