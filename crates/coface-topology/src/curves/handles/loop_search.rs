//! The search for short loops of both kinds.

use super::cover_search::cover_loops;
use super::linking_matrix::{Fingerprint, LinkingMatrix, negative, read, sum};
use super::{HandleKind, Linking};
use crate::curves::bits::Bits;
use crate::curves::cut_vertices::cut_vertices;
use crate::curves::root_search::{RootSearch, without_tail};
use crate::curves::{ClosedWalk, SurfaceHomology, SurfaceHomotopy, TreeCotree};
use coface_algebra::progress::stage;
use coface_algebra::{Error, VertexId, Word};
use coface_complexes::surface::GeneralizedMap;
use std::collections::BTreeMap;

/// The first searches find loops of about as many edges.
const FIRST_EDGES: f64 = 8.0;
/// At how many vertices of a long loop a shorter one is looked for, and at how many roots in a cover.
const ROOTS_OF_LOOP: usize = 8;
/// A walk of more loops than this is not written down.
const MOST_LETTERS: u64 = 1 << 20;

/// A loop that was chosen for a basis.
#[derive(Clone, Debug)]
pub(super) struct Chosen {
    pub(super) kind: HandleKind,
    pub(super) component: usize,
    pub(super) class: Vec<i64>,
    pub(super) steps: Vec<u32>,
    pub(super) length: f64,
}

/// The best loop known of one class.
pub(super) struct Found {
    /// The length with the way that was forth and back.
    pub(super) whole_length: f64,
    pub(super) length: f64,
    pub(super) steps: Vec<u32>,
}

/// The best loops known, by kind and fingerprint.
pub(super) type FoundLoops = BTreeMap<(HandleKind, u64), Found>;

/// Searches from many roots that share what they know.
pub(super) struct LoopSearch<'a> {
    map: &'a GeneralizedMap,
    lengths: &'a [f64],
    trees: &'a TreeCotree,
    homology: &'a SurfaceHomology<'a>,
    linking: LinkingMatrix,
    /// Of a step along each edge.
    prints: Vec<Fingerprint>,
    search: RootSearch<'a>,
    /// Of the path to each vertex that was reached.
    sums: Vec<Fingerprint>,
    found: FoundLoops,
    roots: Vec<u32>,
    reached: usize,
}

impl<'a> LoopSearch<'a> {
    pub(super) fn new(
        map: &'a GeneralizedMap,
        lengths: &'a [f64],
        trees: &'a TreeCotree,
        homology: &'a SurfaceHomology<'a>,
        linking: Linking<'_>,
    ) -> Result<Self, Error> {
        let steps = stage("finding linking numbers", 0);
        let linking = LinkingMatrix::new(map, trees, homology, linking)?;
        drop(steps);
        let has_handles = |&root: &u32| {
            let component = trees.component_of_vertex(VertexId::from_u32(root));
            component.is_some_and(|component| !trees.components()[component].generators().is_empty())
        };
        Ok(Self {
            map,
            lengths,
            trees,
            homology,
            prints: linking.fingerprints(map, homology),
            linking,
            search: RootSearch::new(map, lengths),
            sums: vec![[0; 3]; map.skeleton().vertex_count()],
            found: BTreeMap::new(),
            roots: cut_vertices(map, lengths).into_iter().filter(has_handles).collect(),
            reached: 0,
        })
    }

    pub(super) fn linking(&self) -> &LinkingMatrix {
        &self.linking
    }

    /// Looks for loops below a length from all roots, the far ones first, until about `most` vertices have been reached in all; whether that
    /// was enough.
    pub(super) fn look(&mut self, below: f64, most: usize) -> bool {
        let count = self.roots.len();
        let steps = stage("looking for short loops", count);
        // A stride without a common divisor spreads the roots that are taken.
        let mut stride = count * 618 / 1000 + 1;
        while count > 0 && greatest_common_divisor(stride, count) != 1 {
            stride += 1;
        }
        for i in 0..count {
            steps.advance(1);
            if self.reached >= most && i > 0 {
                return false;
            }
            self.look_from(self.roots[i * stride % count], below);
        }
        true
    }

    /// Looks for loops below a length that are an edge closed up along shortest paths from a root.
    fn look_from(&mut self, root: u32, below: f64) {
        self.search.run(root, below / 2.0);
        self.reached += self.search.reached().len();
        let ends = self.map.skeleton().edge_ends();
        for &vertex in self.search.reached() {
            self.sums[vertex as usize] = match self.search.step_to(vertex) {
                None => [0; 3],
                Some(step) => sum(self.sums[ends[step as usize] as usize], print_of(&self.prints, step)),
            };
        }
        for closing in self.search.closings(below) {
            let step = 2 * closing.edge;
            let [source, target] = [step, step + 1].map(|step| self.sums[ends[step as usize] as usize]);
            let Some(key) = read(sum(sum(source, print_of(&self.prints, step)), negative(target))) else {
                continue;
            };
            if self.found.get(&key).is_some_and(|known| known.whole_length <= closing.length) {
                continue;
            }
            let steps = without_tail(self.search.loop_through(closing.edge));
            insert(&mut self.found, key, closing.length, steps, self.lengths);
        }
    }

    /// The shortest independent loops of each kind among those that were found.
    pub(super) fn chosen(&self) -> Result<Vec<Chosen>, Error> {
        let mut found: Vec<(HandleKind, &Found)> =
            self.found.iter().map(|((kind, _), found)| (*kind, found)).collect();
        found.sort_by(|a, b| a.1.length.total_cmp(&b.1.length));
        let ranges = self.linking.ranges();
        let mut missing: usize = ranges.iter().map(|range| range.len()).sum();
        let mut rows: BTreeMap<(HandleKind, usize), Vec<(usize, Bits)>> = BTreeMap::new();
        let mut chosen = Vec::new();
        for (kind, found) in found {
            if missing == 0 {
                break;
            }
            let walk = ClosedWalk::new(self.map.skeleton(), found.steps.clone())?;
            let class = self.homology.class_of_walk(&walk)?;
            if self.linking.kind(&class) != Some(kind) {
                continue;
            }
            let is_own = |range: &std::ops::Range<usize>| class[range.clone()].iter().any(|&x| x != 0);
            let component = ranges.iter().position(is_own).expect("a class of a kind is not zero");
            let mut row = Bits::zero(ranges[component].len());
            for (i, _) in class[ranges[component].clone()].iter().enumerate().filter(|(_, x)| **x % 2 != 0) {
                row.flip(i);
            }
            let known = rows.entry((kind, component)).or_default();
            for (pivot, other) in known.iter() {
                if row.has(*pivot) {
                    row.add(other);
                }
            }
            if let Some(pivot) = row.first_one() {
                known.push((pivot, row));
                missing -= 1;
                chosen.push(Chosen {
                    kind,
                    component,
                    class,
                    steps: found.steps.clone(),
                    length: found.length,
                });
            }
        }
        Ok(chosen)
    }

    /// Short loops of each kind that are a basis.
    pub(super) fn basis(&mut self, most: usize) -> Result<Vec<Chosen>, Error> {
        let wanted: usize = self.linking.ranges().iter().map(|range| range.len()).sum();
        let total: f64 = self.lengths.iter().sum();
        let mut below = FIRST_EDGES * total / self.lengths.len().max(1) as f64;
        if below <= 0.0 {
            below = 1.0;
        }
        let mut chosen = Vec::new();
        let mut complete_below = 0.0;
        while wanted > 0 && complete_below < total {
            let before = self.reached;
            if !self.look(below, most) {
                break;
            }
            complete_below = below;
            chosen = self.chosen()?;
            if chosen.len() == wanted || self.reached + 4 * (self.reached - before) > most {
                break;
            }
            below *= 2.0;
        }
        if chosen.len() < wanted {
            self.look_far(most);
            chosen = self.chosen()?;
        }
        if chosen.len() < wanted {
            self.look_in_covers(&chosen, most);
            chosen = self.chosen()?;
        }
        if chosen.len() < wanted {
            self.add_bases(&chosen)?;
            chosen = self.chosen()?;
        }
        self.shorten(&chosen, complete_below);
        self.chosen()
    }

    /// Looks for loops of any length at some roots, one at least on each component.
    fn look_far(&mut self, most: usize) {
        let per_root = self.map.skeleton().vertex_count().max(1);
        let count = (most.saturating_sub(self.reached) / per_root).clamp(ROOTS_OF_LOOP, 64);
        for component in 0..self.trees.components().len() {
            for root in self.roots_of(component, count) {
                self.look_from(root, f64::INFINITY);
            }
        }
    }

    /// Some roots on a component, spread evenly.
    fn roots_of(&self, component: usize, count: usize) -> Vec<u32> {
        let is_own =
            |&&root: &&u32| self.trees.component_of_vertex(VertexId::from_u32(root)) == Some(component);
        let own: Vec<u32> = self.roots.iter().filter(is_own).copied().collect();
        own.iter().step_by(own.len().div_ceil(count).max(1)).copied().collect()
    }

    /// The kinds and components that have too few loops, with the number of those that are missing.
    fn missing(&self, chosen: &[Chosen]) -> Vec<(HandleKind, usize, usize)> {
        let mut missing = Vec::new();
        for (component, range) in self.linking.ranges().iter().enumerate() {
            for kind in [HandleKind::Handle, HandleKind::Tunnel] {
                let is_own = |chosen: &&Chosen| chosen.component == component && chosen.kind == kind;
                let count = range.len() / 2 - chosen.iter().filter(is_own).count();
                if count > 0 {
                    missing.push((kind, component, count));
                }
            }
        }
        missing
    }

    /// Looks for the missing loops in covers where all loops are of one kind.
    fn look_in_covers(&mut self, chosen: &[Chosen], most: usize) {
        let steps = stage("looking for loops in covers", 0);
        for (kind, component, count) in self.missing(chosen) {
            let roots = self.roots_of(component, ROOTS_OF_LOOP);
            for &root in &roots {
                let most = most / (4 * roots.len());
                cover_loops(self.map, self.lengths, &self.prints, root, kind, count, most, &mut self.found);
            }
        }
        drop(steps);
    }

    /// Adds walks of all classes of a basis where loops are missing still.
    fn add_bases(&mut self, chosen: &[Chosen]) -> Result<(), Error> {
        let homotopy = SurfaceHomotopy::new(self.map, self.trees)?;
        for (kind, component, _) in self.missing(chosen) {
            let range = self.linking.ranges()[component].clone();
            for class in self.linking.basis(component, kind)? {
                let own = &class[range.clone()];
                if own.iter().map(|x| x.unsigned_abs()).fold(0, u64::saturating_add) > MOST_LETTERS {
                    return Err(Error::new(
                        coface_algebra::ErrorKind::TooLarge,
                        "a handle loop or tunnel loop of the surface runs through too many loops to be written down",
                    )
                    .with_cure("simplify the surface first"));
                }
                let letters = (1i32..).zip(own).flat_map(|(letter, &times)| {
                    std::iter::repeat_n(letter * times.signum() as i32, times.unsigned_abs() as usize)
                });
                let walk = homotopy.walk_of_word(component, &Word::from_letters(letters));
                let steps = without_tail(walk.steps().to_vec());
                let print =
                    steps.iter().fold([0; 3], |print, &step| sum(print, print_of(&self.prints, step)));
                if let Some(key) = read(print) {
                    insert(&mut self.found, key, f64::INFINITY, steps, self.lengths);
                }
            }
        }
        Ok(())
    }

    /// Looks for shorter loops at vertices of the long ones.
    fn shorten(&mut self, chosen: &[Chosen], complete_below: f64) {
        let ends = self.map.skeleton().edge_ends();
        for chosen in chosen.iter().filter(|chosen| chosen.length > complete_below) {
            let stride = chosen.steps.len().div_ceil(ROOTS_OF_LOOP).max(1);
            for &step in chosen.steps.iter().step_by(stride) {
                self.look_from(ends[step as usize], chosen.length);
            }
        }
    }
}

/// The fingerprint of a step.
pub(super) fn print_of(prints: &[Fingerprint], step: u32) -> Fingerprint {
    let print = prints[(step >> 1) as usize];
    if step & 1 == 0 { print } else { negative(print) }
}

/// Keeps a loop if it is the shortest one of its class.
pub(super) fn insert(
    found: &mut FoundLoops,
    key: (HandleKind, u64),
    whole_length: f64,
    steps: Vec<u32>,
    lengths: &[f64],
) {
    let length = steps.iter().map(|&step| lengths[(step >> 1) as usize]).sum();
    match found.get_mut(&key) {
        None => {
            found.insert(key, Found { whole_length, length, steps });
        }
        Some(known) => {
            known.whole_length = known.whole_length.min(whole_length);
            if length < known.length {
                (known.length, known.steps) = (length, steps);
            }
        }
    }
}

fn greatest_common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
