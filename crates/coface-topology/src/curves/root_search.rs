//! Short loops at one vertex: shortest paths up to a radius, and the edges that close them up.

use coface_algebra::RaggedArray;
use coface_algebra::progress::stage;
use coface_algebra::{EdgeId, FaceId, HalfedgeId};
use coface_complexes::surface::GeneralizedMap;
use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

const NONE: u32 = u32::MAX;

/// A search that is done again and again from different roots; its arrays are cleared by what was touched.
#[derive(Debug)]
pub(super) struct RootSearch<'a> {
    map: &'a GeneralizedMap,
    lengths: &'a [f64],
    steps_at: RaggedArray,
    distances: Vec<f64>,
    /// The last step of the shortest path to each vertex that was reached.
    steps: Vec<u32>,
    /// The vertices that are settled, nearest first.
    reached: Vec<u32>,
    heap: BinaryHeap<Reverse<Reached>>,
    touched: Vec<u32>,
    is_settled: Vec<bool>,
    /// The local number of each face that has only settled vertices, from 1 on.
    locals: Vec<u32>,
}

#[derive(Debug, PartialEq)]
struct Reached(f64, u32);

impl Eq for Reached {}

impl Ord for Reached {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0).then(self.1.cmp(&other.1))
    }
}

impl PartialOrd for Reached {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// An edge that closes up two shortest paths, and the length of the loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Closing {
    pub(super) length: f64,
    pub(super) edge: u32,
}

impl Closing {
    pub(super) fn order(&self, other: &Self) -> Ordering {
        self.length.total_cmp(&other.length).then(self.edge.cmp(&other.edge))
    }
}

/// The dual graph near the root: faces with all vertices reached as nodes from 1 on; node 0 is everything else, holes
/// included. Its arcs are the closing edges.
pub(super) struct LocalDual {
    pub(super) node_count: usize,
    /// By rising length.
    pub(super) arcs: Vec<(Closing, [u32; 2])>,
}

impl<'a> RootSearch<'a> {
    pub(super) fn new(map: &'a GeneralizedMap, lengths: &'a [f64]) -> Self {
        let (vertex_count, face_count) = (map.vertex_count(), map.face_count());
        Self {
            map,
            lengths,
            steps_at: RaggedArray::grouped(vertex_count, map.skeleton().edge_ends().iter().copied()),
            distances: vec![f64::INFINITY; vertex_count],
            steps: vec![NONE; vertex_count],
            reached: Vec::new(),
            heap: BinaryHeap::new(),
            touched: Vec::new(),
            is_settled: vec![false; vertex_count],
            locals: vec![0; face_count],
        }
    }

    /// The vertices that the last search reached, nearest first.
    pub(super) fn reached(&self) -> &[u32] {
        &self.reached
    }

    /// The length of the path to a vertex that was reached.
    pub(super) fn distance(&self, vertex: u32) -> f64 {
        self.distances[vertex as usize]
    }

    /// The last step of the path to a vertex; none for the root.
    pub(super) fn step_to(&self, vertex: u32) -> Option<u32> {
        Some(self.steps[vertex as usize]).filter(|&step| step != NONE)
    }

    /// Reaches all vertices nearer to the root than `radius`, the root in any case.
    pub(super) fn run(&mut self, root: u32, radius: f64) {
        for vertex in self.touched.drain(..) {
            self.distances[vertex as usize] = f64::INFINITY;
            self.steps[vertex as usize] = NONE;
            self.is_settled[vertex as usize] = false;
        }
        self.reached.clear();
        let ends = self.map.skeleton().edge_ends();
        self.distances[root as usize] = 0.0;
        self.touched.push(root);
        self.heap.push(Reverse(Reached(0.0, root)));
        // Whoever starts the searches reports their progress.
        let is_long = self.steps.len() > 1 << 14;
        let steps = is_long.then(|| stage("finding shortest paths", 0));
        while let Some(Reverse(Reached(distance, vertex))) = self.heap.pop() {
            if std::mem::replace(&mut self.is_settled[vertex as usize], true) {
                continue;
            }
            self.reached.push(vertex);
            if let Some(steps) = &steps {
                steps.pass(self.reached.len());
            }
            for &step in self.steps_at.list(vertex as usize) {
                let next = ends[(step ^ 1) as usize];
                let through = distance + self.lengths[(step >> 1) as usize];
                let known = &mut self.distances[next as usize];
                if through < *known && through < radius {
                    if known.is_infinite() {
                        self.touched.push(next);
                    }
                    *known = through;
                    self.steps[next as usize] = step;
                    self.heap.push(Reverse(Reached(through, next)));
                }
            }
        }
    }

    /// The closing edges whose loops are shorter than `bound`.
    pub(super) fn closings(&self, bound: f64) -> impl Iterator<Item = Closing> + '_ {
        let ends = self.map.skeleton().edge_ends();
        let steps = self.reached.iter().flat_map(|&vertex| self.steps_at.list(vertex as usize));
        // Each edge once.
        let edges = steps.filter(|&&step| step & 1 == 0).map(|&step| step >> 1);
        edges.filter_map(move |edge| {
            let [source, target] = [2 * edge, 2 * edge + 1].map(|step| ends[step as usize] as usize);
            if !self.is_settled[target] || self.is_on_path(edge) {
                return None;
            }
            let length = self.distances[source] + self.distances[target] + self.lengths[edge as usize];
            (length < bound).then_some(Closing { length, edge })
        })
    }

    /// The closing edges whose loops are shorter than `bound`, with the dual graph that they are arcs of. Arcs of
    /// longer loops are contracted.
    pub(super) fn local_dual(&mut self, bound: f64) -> LocalDual {
        let (map, ends) = (self.map, self.map.skeleton().edge_ends());
        let mut arcs = Vec::new();
        let mut faces: Vec<u32> = Vec::new();
        for i in 0..self.reached.len() {
            let vertex = self.reached[i] as usize;
            for at in 0..self.steps_at.list(vertex).len() {
                let step = self.steps_at.list(vertex)[at];
                let [source, target] = [step, step ^ 1].map(|step| ends[step as usize]);
                // Each edge once.
                if step & 1 == 1 || !self.is_settled[target as usize] || self.is_on_path(step >> 1) {
                    continue;
                }
                let edge = step >> 1;
                let length = self.distances[source as usize]
                    + self.distances[target as usize]
                    + self.lengths[edge as usize];
                let first = map.first_side(EdgeId::from_u32(edge));
                let sides = [Some(first), map.mate(first)];
                let mut nodes = [0; 2];
                for (node, side) in nodes.iter_mut().zip(sides) {
                    if let Some(side) = side {
                        *node = self.local(side, &mut faces);
                    }
                }
                arcs.push((Closing { length, edge }, nodes));
            }
        }
        for &face in &faces {
            self.locals[face as usize] = 0;
        }
        arcs.sort_unstable_by(|(a, _), (b, _)| a.order(b));
        let keep = arcs.partition_point(|(closing, _)| closing.length < bound);
        let mut partition = coface_algebra::UnionFind::new(faces.len() + 1);
        for (_, [a, b]) in arcs.drain(keep..) {
            partition.unite(a, b);
        }
        // Node 0 keeps its number.
        let mut classes = partition.class_numbers();
        let zero = classes[0];
        for class in &mut classes {
            *class = match *class {
                class if class == zero => 0,
                class if class < zero => class + 1,
                class => class,
            };
        }
        for (_, nodes) in &mut arcs {
            *nodes = nodes.map(|node| classes[node as usize]);
        }
        LocalDual { node_count: partition.class_count(), arcs }
    }

    fn is_on_path(&self, edge: u32) -> bool {
        let ends = self.map.skeleton().edge_ends();
        [0, 1].into_iter().any(|end| {
            let step = 2 * edge + end;
            self.steps[ends[(step ^ 1) as usize] as usize] == step
        })
    }

    /// The local node of the face of a side.
    fn local(&mut self, side: HalfedgeId, faces: &mut Vec<u32>) -> u32 {
        let face: FaceId = self.map.face(side);
        if self.locals[face.index()] == 0 {
            if !self.map.sides_of(face).all(|side| self.is_settled[self.map.source(side).index()]) {
                return 0;
            }
            faces.push(face.to_u32());
            self.locals[face.index()] = faces.len() as u32;
        }
        self.locals[face.index()]
    }

    /// The loop at the root through an edge.
    pub(super) fn loop_through(&self, edge: u32) -> Vec<u32> {
        let ends = self.map.skeleton().edge_ends();
        let way_up = |vertex: u32| {
            let mut way = Vec::new();
            let mut at = vertex;
            while let Some(step) = self.step_to(at) {
                way.push(step);
                at = ends[step as usize];
            }
            way
        };
        let [source, target] = [2 * edge, 2 * edge + 1].map(|step| ends[step as usize]);
        let mut steps = way_up(source);
        steps.reverse();
        steps.push(2 * edge);
        steps.extend(way_up(target).into_iter().map(|step| step ^ 1));
        steps
    }
}

/// The steps of a loop without the way that it goes forth and back.
pub(super) fn without_tail(steps: Vec<u32>) -> Vec<u32> {
    let tail = steps.iter().zip(steps.iter().rev()).take_while(|(a, b)| **a == **b ^ 1).count();
    // A loop is not nothing but a way forth and back.
    if 2 * tail < steps.len() { steps[tail..steps.len() - tail].to_vec() } else { steps }
}

impl LocalDual {
    /// The arcs that are left when nodes with a single arc, but node 0, are removed with it, again and again. The
    /// loops of the others bound disks.
    pub(super) fn pruned(&self) -> Vec<Closing> {
        let mut degrees = vec![0u32; self.node_count];
        // The exclusive or of the arcs at each node: of a single one its number.
        let mut sums = vec![0u32; self.node_count];
        for (i, (_, nodes)) in (0u32..).zip(&self.arcs) {
            for &node in nodes {
                degrees[node as usize] += 1;
                sums[node as usize] ^= i;
            }
        }
        let mut is_pruned = vec![false; self.arcs.len()];
        let mut stack: Vec<u32> = (1..self.node_count as u32).filter(|&n| degrees[n as usize] == 1).collect();
        while let Some(node) = stack.pop() {
            if degrees[node as usize] != 1 {
                continue;
            }
            let arc = sums[node as usize];
            is_pruned[arc as usize] = true;
            for other in self.arcs[arc as usize].1 {
                degrees[other as usize] -= 1;
                sums[other as usize] ^= arc;
                if other != 0 && degrees[other as usize] == 1 {
                    stack.push(other);
                }
            }
        }
        self.arcs
            .iter()
            .zip(is_pruned)
            .filter(|(_, pruned)| !pruned)
            .map(|((closing, _), _)| *closing)
            .collect()
    }

    /// The arcs that are left beside a spanning tree of the longest ones, shortest first.
    pub(super) fn leftover(&self) -> Vec<Closing> {
        let mut partition = coface_algebra::UnionFind::new(self.node_count);
        let mut left = Vec::new();
        for (closing, [a, b]) in self.arcs.iter().rev() {
            if !partition.unite(*a, *b) {
                left.push(*closing);
            }
        }
        left.reverse();
        left
    }
}
