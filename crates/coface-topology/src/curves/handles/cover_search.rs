//! Loops of one kind, found as loops in a cover of the surface.

use super::HandleKind;
use super::linking_matrix::{Fingerprint, negative, read, sum};
use super::loop_search::{FoundLoops, insert, print_of};
use crate::curves::root_search::without_tail;
use coface_algebra::RaggedArray;
use coface_complexes::surface::GeneralizedMap;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

/// A vertex of the cover: a vertex of the surface, and what tells its copies apart.
type Place = (u32, u64);

/// What is known of a vertex of the cover.
struct Reached {
    distance: f64,
    place: Place,
    print: Fingerprint,
    /// The step of the shortest path to it, and the vertex that this starts from.
    from: Option<(u32, usize)>,
    is_settled: bool,
}

/// Adds loops of a kind through a root: the shortest ones in the cover whose loops are all of that kind or bound, by Dijkstra's algorithm from one
/// vertex over the root, until `count` classes are known and no shorter loop can be there, or `most` vertices are reached.
#[allow(clippy::too_many_arguments, reason = "the parts of a search that calls this once")]
pub(super) fn cover_loops(
    map: &GeneralizedMap,
    lengths: &[f64],
    prints: &[Fingerprint],
    root: u32,
    kind: HandleKind,
    count: usize,
    most: usize,
    found: &mut FoundLoops,
) {
    // The part of a fingerprint that vanishes on loops of this kind.
    let sheet = |print: Fingerprint| match kind {
        HandleKind::Handle => print[0],
        HandleKind::Tunnel => print[1],
    };
    let ends = map.skeleton().edge_ends();
    let steps_at = RaggedArray::grouped(map.skeleton().vertex_count(), ends.iter().copied());
    let mut reached =
        vec![Reached { distance: 0.0, place: (root, 0), print: [0; 3], from: None, is_settled: false }];
    let mut numbers: BTreeMap<Place, usize> = BTreeMap::from([((root, 0), 0)]);
    let mut heap = BinaryHeap::from([Reverse((Distance(0.0), 0usize))]);
    let mut known: BTreeMap<u64, f64> = BTreeMap::new();
    let mut enough = f64::INFINITY;
    while let Some(Reverse((Distance(distance), at))) = heap.pop() {
        if 2.0 * distance >= enough || reached.len() > most {
            return;
        }
        if std::mem::replace(&mut reached[at].is_settled, true) {
            continue;
        }
        for &step in steps_at.list(reached[at].place.0 as usize) {
            let print = sum(reached[at].print, print_of(prints, step));
            let place = (ends[(step ^ 1) as usize], sheet(print));
            let length = distance + lengths[(step >> 1) as usize];
            let Some(&next) = numbers.get(&place) else {
                numbers.insert(place, reached.len());
                heap.push(Reverse((Distance(length), reached.len())));
                reached.push(Reached {
                    distance: length,
                    place,
                    print,
                    from: Some((step, at)),
                    is_settled: false,
                });
                continue;
            };
            if !reached[next].is_settled {
                if length < reached[next].distance {
                    (reached[next].distance, reached[next].print) = (length, print);
                    reached[next].from = Some((step, at));
                    heap.push(Reverse((Distance(length), next)));
                }
                continue;
            }
            let Some(key) = read(sum(print, negative(reached[next].print))) else { continue };
            let whole = length + reached[next].distance;
            if known.get(&key.1).is_some_and(|&known| known <= whole) {
                continue;
            }
            known.insert(key.1, whole);
            let mut steps = way_up(&reached, at);
            steps.reverse();
            steps.push(step);
            steps.extend(way_up(&reached, next).into_iter().map(|step| step ^ 1));
            insert(found, key, whole, without_tail(steps), lengths);
            if known.len() >= count {
                let mut lengths: Vec<f64> = known.values().copied().collect();
                lengths.sort_by(f64::total_cmp);
                enough = lengths[count - 1];
            }
        }
    }
}

/// The steps of the path to a vertex, the last one first.
fn way_up(reached: &[Reached], mut at: usize) -> Vec<u32> {
    let mut steps = Vec::new();
    while let Some((step, from)) = reached[at].from {
        steps.push(step);
        at = from;
    }
    steps
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Distance(f64);

impl Eq for Distance {}

impl Ord for Distance {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

impl PartialOrd for Distance {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
