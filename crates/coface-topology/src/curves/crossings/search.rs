//! Shortest cycles by cuts that they cross at most once.

use super::free_words::{FreeWords, NEUTRAL};
use super::moving_source::{Arc, Graph, Limits, Local, NearestPair, Tree};
use super::piece::{Opened, Piece, some_vertex};
use super::weights::Weights;
use crate::curves::root_search::without_tail;
use crate::curves::shortest_cycle::{Known, loop_at, with_holes_filled};
use crate::curves::{ClosedWalk, CutSurface, CycleKind, ShortestCycle, TreeCotree};
use coface_algebra::progress::stage;
use coface_algebra::{EdgeId, Error, RaggedArray};
use coface_complexes::surface::GeneralizedMap;
use std::collections::BinaryHeap;

/// No hole.
const NONE: u32 = u32::MAX;

/// A shortest cycle and a lower bound, as far as the search went.
pub(in crate::curves) struct Found {
    pub(in crate::curves) cycle: Option<ShortestCycle>,
    pub(in crate::curves) lower_bound: f64,
    pub(in crate::curves) reached: usize,
}

/// The shortest cycle of a kind by cuts that it crosses at most once; see the [section](super). On a surface with holes that kind is not
/// [`CycleKind::NonSeparating`]. What is known may be nothing.
pub(in crate::curves) fn search(
    map: &GeneralizedMap,
    lengths: &[f64],
    kind: CycleKind,
    known: Known,
    most: usize,
    is_over: &dyn Fn() -> bool,
) -> Result<Found, Error> {
    let weights = Weights::new(lengths);
    let limits = Limits { is_over, is_stopped: false, reached: known.reached, most };
    let mut search = Search { map, lengths, weights, kind, limits, best: known.cycle, open: u128::MAX };
    let edges: Vec<u32> = (0..map.skeleton().edge_count() as u32).collect();
    let mut pieces = Piece::components(map, &edges)?;
    drop(edges);
    if search.best.is_none() {
        for piece in &pieces {
            search.look_for_first(piece)?;
        }
    }
    let steps = stage("searching for a shortest cycle", 0);
    while let Some(piece) = pieces.pop() {
        steps.advance(1);
        if search.is_at_end() {
            break;
        }
        pieces.extend(search.cut(&piece)?);
    }
    let lower_bound = match &search.best {
        None => f64::INFINITY,
        Some(best) if search.open == u128::MAX => best.length(),
        Some(best) => search.weights.length_below(search.open).min(best.length()),
    };
    Ok(Found { cycle: search.best, lower_bound, reached: search.limits.reached })
}

struct Search<'a> {
    map: &'a GeneralizedMap,
    lengths: &'a [f64],
    weights: Weights,
    kind: CycleKind,
    limits: Limits<'a>,
    best: Option<ShortestCycle>,
    /// No cycle that was not searched for is shorter than this.
    open: u128,
}

impl Search<'_> {
    /// Whether there is nothing to be found, or no more time.
    fn is_at_end(&mut self) -> bool {
        match &self.best {
            None => return true,
            Some(best) if best.length() <= 0.0 => return true,
            Some(_) => {}
        }
        if self.limits.stops() {
            self.open = 0;
        }
        self.limits.is_stopped || self.limits.reached > self.limits.most
    }

    /// Looks for some cycle of the kind.
    fn look_for_first(&mut self, piece: &Piece) -> Result<(), Error> {
        let lengths = self.lengths_of(piece);
        if let Some(walk) = self.loop_at(&piece.map, &lengths, some_vertex(&piece.map))? {
            self.offer(walk.iter().map(|&step| below(piece, step)).collect())?;
        }
        Ok(())
    }

    fn lengths_of(&self, piece: &Piece) -> Vec<f64> {
        piece.edges.iter().map(|&edge| self.lengths[edge as usize]).collect()
    }

    fn loop_at(
        &mut self,
        map: &GeneralizedMap,
        lengths: &[f64],
        root: u32,
    ) -> Result<Option<Vec<u32>>, Error> {
        self.limits.reached += map.skeleton().vertex_count();
        Ok(loop_at(map, lengths, self.kind, root)?.map(|cycle| cycle.walk().steps().to_vec()))
    }

    /// Keeps a walk if it is the shortest one up to now.
    fn offer(&mut self, steps: Vec<u32>) -> Result<(), Error> {
        let cycle = ShortestCycle::new(ClosedWalk::new(self.map.skeleton(), steps)?, self.lengths);
        if self.best.as_ref().is_none_or(|best| cycle.length() < best.length()) {
            self.best = Some(cycle);
        }
        Ok(())
    }

    /// Cuts a piece so that a shortest cycle of the kind on it crosses the cut once, and is found, or lies on one of the pieces that are
    /// left.
    fn cut(&mut self, piece: &Piece) -> Result<Vec<Piece>, Error> {
        let (holes, hole_count) = piece.holes();
        if hole_count > 1 {
            let path = piece.path_between_holes(&holes, &self.weights);
            return self.cut_along(piece, &path, &path);
        }
        if piece.filled_characteristic(hole_count) == 2 {
            return Ok(Vec::new());
        }
        if hole_count == 1 && self.kind == CycleKind::NonContractible {
            // Cycles that are homotopic to the boundary, and others.
            let cover = piece.double_cover()?;
            let (holes, _) = cover.holes();
            let path = cover.path_between_holes(&holes, &self.weights);
            drop(self.cut_along(&cover, &path, &path)?);
            if self.is_at_end() {
                return Ok(Vec::new());
            }
        }
        let Some(arc) = self.shortest_arc(piece, &holes, hole_count)? else { return Ok(Vec::new()) };
        let crossed = without_tail(arc.clone());
        self.cut_along(piece, &arc, &crossed)
    }

    /// The shortest loop of the kind at some vertex of a closed piece, or the shortest path from the hole to itself which makes a loop of
    /// the kind when the hole is a point.
    fn shortest_arc(
        &mut self,
        piece: &Piece,
        holes: &[u32],
        hole_count: usize,
    ) -> Result<Option<Vec<u32>>, Error> {
        let mut lengths = self.lengths_of(piece);
        if hole_count == 0 {
            let mut root = some_vertex(&piece.map);
            let mut best: Option<Vec<u32>> = None;
            // A loop at the far end of the last one may be much shorter.
            for _ in 0..4 {
                let Some(arc) = self.loop_at(&piece.map, &lengths, root)? else { break };
                let length =
                    |arc: &[u32]| -> f64 { arc.iter().map(|&step| lengths[(step >> 1) as usize]).sum() };
                if best.as_ref().is_some_and(|best| length(&arc) >= 0.9 * length(best)) {
                    break;
                }
                self.offer(arc.iter().map(|&step| below(piece, step)).collect())?;
                root = piece.map.skeleton().edge_ends()[arc[arc.len() / 2] as usize];
                best = Some(without_tail(arc));
            }
            return Ok(best);
        }
        // Only vertices of the hole are at the distance 0, so that the loop leaves it once and comes back once.
        for length in &mut lengths {
            *length = length.max(f64::MIN_POSITIVE);
        }
        for side in piece.map.sides().filter(|&side| piece.map.mate(side).is_none()) {
            lengths[piece.map.edge(side).index()] = 0.0;
        }
        let filled = with_holes_filled(&piece.map);
        let root = (0u32..).zip(holes).find(|(_, hole)| **hole != NONE).map_or(0, |(vertex, _)| vertex);
        let Some(walk) = self.loop_at(&filled, &lengths, root)? else { return Ok(None) };
        Ok(Some(off_the_hole(&piece.map, &walk)))
    }

    /// Looks for cycles that cross a path or cycle once, and gives the pieces that are left.
    fn cut_along(&mut self, piece: &Piece, cut: &[u32], crossed: &[u32]) -> Result<Vec<Piece>, Error> {
        let opened = Opened::new(piece, cut, crossed)?;
        if opened.is_connected() {
            self.cross(&opened)?;
        }
        Piece::components(&opened.piece.map, &opened.piece.edges)
    }

    /// Looks for the shortest path from one side of a cut to the same place on the other side.
    fn cross(&mut self, opened: &Opened) -> Result<(), Error> {
        let Some(best) = &self.best else { return Ok(()) };
        let best: u128 = best.walk().steps().iter().map(|&step| self.weights.of(step >> 1)).sum();
        let piece = &opened.piece;
        let ends = piece.map.skeleton().edge_ends();
        let (labels, words) = labels(&piece.map);
        let steps_at = RaggedArray::grouped(piece.map.skeleton().vertex_count(), ends.iter().copied());
        let arc = |step: u32| Arc {
            weight: self.weights.of(piece.edges[(step >> 1) as usize]),
            to: ends[(step ^ 1) as usize],
            label: labels[step as usize],
        };
        let mut graph = Graph { starts: vec![0], arcs: Vec::with_capacity(ends.len()) };
        for vertex in 0..piece.map.skeleton().vertex_count() {
            graph.arcs.extend(steps_at.list(vertex).iter().map(|&step| arc(step)));
            graph.starts.push(graph.arcs.len() as u32);
        }
        let along: Vec<Arc> = opened.along.iter().map(|&step| arc(step)).collect();
        let targets = opened.sides[1].iter().map(|&vertex| Some((vertex, 0))).collect();
        let local = Local { graph, sources: opened.sides[0].clone(), targets };
        let nearest = NearestPair::find(&mut self.limits, words, &local, &along, best);
        self.open = self.open.min(nearest.open);
        let Some((source, distance)) = nearest.pair else { return Ok(()) };
        let mut tree = Tree::new(piece.map.skeleton().vertex_count());
        let root = (opened.sides[0][source], NEUTRAL);
        let (mut words, mut heap) = (FreeWords::new(), BinaryHeap::new());
        let mut graph = local.graph;
        graph.arcs.iter_mut().for_each(|arc| arc.label = NEUTRAL);
        tree.grow(&graph, root, distance + 1, &mut words, &mut heap);
        let steps: Vec<u32> = steps_at.iter().flatten().copied().collect();
        let path = tree.path_to(opened.sides[1][source]);
        self.offer(path.into_iter().map(|arc| below(piece, steps[arc as usize])).collect())
    }
}

/// The step below a step of a piece.
fn below(piece: &Piece, step: u32) -> u32 {
    2 * piece.edges[(step >> 1) as usize] + (step & 1)
}

/// The part of a loop at a hole without the ways along the hole before and after it.
fn off_the_hole(map: &GeneralizedMap, walk: &[u32]) -> Vec<u32> {
    let is_inner = |step: &u32| map.mate(map.first_side(EdgeId::from_u32(step >> 1))).is_some();
    let from = walk.iter().position(is_inner).unwrap_or(0);
    let to = walk.iter().rposition(is_inner).map_or(0, |last| last + 1);
    walk[from..to].to_vec()
}

/// For each step of a surface with boundary an element of the fundamental group, such that closed walks can be contracted if and only if
/// the product of theirs is neutral.
fn labels(map: &GeneralizedMap) -> (Vec<u32>, FreeWords) {
    let trees = TreeCotree::new(map);
    let cut = CutSurface::new(map, &trees);
    let mut words = FreeWords::new();
    let mut labels = vec![NEUTRAL; 2 * map.skeleton().edge_count()];
    for edge in (0..map.skeleton().edge_count()).map(EdgeId::new) {
        let side = map.first_side(edge);
        let word = cut.side_word(map, side);
        if !word.is_empty() {
            let number = words.number(word.letters());
            let step = map.step(side);
            labels[step as usize] = number;
            labels[(step ^ 1) as usize] = words.inverse(number);
        }
    }
    (labels, words)
}
