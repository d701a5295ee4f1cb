//! The meetings of all pieces.

use super::arc_tree::ArcTree;
use super::carriers::Carriers;
use super::meeting::Found;
use super::piece_pair::PairSolver;
use super::polynomial::is_apart;
use super::refinement::refine;
use super::{Meeting, Overlap, Pieces};
use crate::curve::bernstein::is_straight;
use coface_algebra::Error;
use coface_algebra::progress::stage;
use rayon::prelude::*;
use std::ops::ControlFlow;
use std::sync::atomic::AtomicUsize;
use std::sync::atomic::Ordering::Relaxed;

/// Parts are crowded if the bounds of more than so many others meet those of each, on average: boxes, which cost little, and strips.
const CROWDED: [usize; 2] = [32, 6];

/// The bounds of crowded parts are narrowed so often at most.
const DEEPEST: u32 = 5;

/// All common points and arcs of the pieces of arenas, sorted by pieces and parameters.
///
/// The common end of neighbors on a curve is not listed unless they meet there otherwise. An end of an overlap is not listed as a
/// meeting of the same two pieces.
pub(crate) struct Meetings {
    pub(crate) points: Vec<Meeting>,
    pub(crate) overlaps: Vec<Overlap>,
    /// Pieces that run so near to each other for so long that it was given up to find all that they have in common.
    pub(crate) exhausted: Vec<[u32; 2]>,
    /// The depth of the [`ArcTree`] in which few arcs are near each other: 0 if boxes tell most of them apart.
    pub(crate) depth: u32,
}

/// Puts a meeting inside of a segment along an axis on its line, which rounding may have moved it from.
fn put_on_axes(carriers: &Carriers, meeting: &mut Meeting) {
    if meeting.at.iter().any(|&t| t == 0.0 || t == 1.0) {
        return;
    }
    for controls in meeting.pieces.map(|carrier| carriers.controls(carrier)) {
        let last = controls[controls.len() - 1];
        for axis in 0..2 {
            if controls[0][axis] == last[axis] && is_straight(controls) {
                meeting.point[axis] = last[axis];
            }
        }
    }
}

/// The pairs of parts that are near each other, with their pieces first; nothing if the bounds of more than that meet, counted by arcs.
fn candidates(pieces: &Pieces<'_>, depth: u32, most: usize) -> Option<Vec<[u32; 4]>> {
    let parts = pieces.parts();
    let resolution = pieces.frame.resolution;
    let tree = ArcTree::new(parts.len(), |part| pieces.part_points(part as usize), depth, resolution);
    let tasks = tree.tasks();
    let steps = stage("finding pieces that are near", tasks.len());
    let count = AtomicUsize::new(0);
    let found: Vec<Vec<[u32; 4]>> = tasks
        .par_iter()
        .map(|&task| {
            steps.advance(1);
            let mut near = Vec::new();
            let mut own_count = 0;
            let _ = tree.search(task, |i, j| {
                own_count += 1;
                // Added now and then, so that threads do not wait for each other.
                if own_count == 1024 && count.fetch_add(std::mem::take(&mut own_count), Relaxed) > most {
                    return ControlFlow::Break(());
                }
                let [a, b] = [i, j].map(|part| pieces.part_points(part as usize));
                if !is_apart(a, b, resolution) {
                    near.push([parts[i as usize].piece, parts[j as usize].piece, i, j]);
                }
                ControlFlow::Continue(())
            });
            count.fetch_add(own_count, Relaxed);
            near
        })
        .collect();
    (count.into_inner() <= most).then(|| found.concat())
}

impl Meetings {
    /// The meetings of pieces at so many times the usual resolution, with local parameters on their carriers.
    ///
    /// Each pair of carriers is met once, and its pieces have what is within their spans.
    ///
    /// # Errors
    /// As [`Pieces::of`].
    ///
    /// # Complexity
    /// $O(n \log n + k)$ for n pieces of which k pairs of monotone parts have boxes that meet; constant work for each pair that
    /// crosses, and $O(1)$ cells for each halving down to the resolution where pieces touch. In parallel; the result does not depend
    /// on the number of threads.
    pub(crate) fn of(carriers: &Carriers, coarseness: f64) -> Result<Self, Error> {
        let pieces = Pieces::of(carriers, coarseness)?;
        let mut found = Self::of_pieces(&pieces);
        let resolution = pieces.frame.world_length(pieces.frame.resolution);
        found.points.retain_mut(|meeting| refine(carriers, meeting, resolution));
        found.points.iter_mut().for_each(|meeting| put_on_axes(carriers, meeting));
        Ok(found.distributed(carriers, resolution))
    }

    /// The meetings of carriers.
    pub(super) fn of_pieces(pieces: &Pieces<'_>) -> Self {
        // Where parts are crowded their arcs are looked at, shorter and shorter, in ever thinner strips.
        let most = |depth: u32| CROWDED[usize::from(depth > 0)] * pieces.parts().len() + 1024;
        let (depth, candidates) = (0..DEEPEST)
            .find_map(|depth| Some((depth, candidates(pieces, depth, most(depth))?)))
            .unwrap_or_else(|| (DEEPEST, candidates(pieces, DEEPEST, usize::MAX).unwrap_or_default()));
        Self { depth, ..Self::among(pieces, candidates) }
    }

    /// The meetings of carriers among pairs of their parts, with the carriers first; pairs that do not meet change nothing.
    pub(super) fn among(pieces: &Pieces<'_>, mut candidates: Vec<[u32; 4]>) -> Self {
        candidates.par_sort_unstable();
        candidates.dedup();
        let mut starts: Vec<usize> = (0..candidates.len())
            .filter(|&i| i == 0 || candidates[i - 1][..2] != candidates[i][..2])
            .collect();
        starts.push(candidates.len());
        let found: Vec<Found> = starts
            .par_windows(2)
            .with_min_len(64)
            .fold(
                || (Found::default(), PairSolver::new(pieces), Vec::new()),
                |(mut found, mut solver, mut own), range| {
                    own.clear();
                    let group = &candidates[range[0]..range[1]];
                    own.extend(group.iter().map(|&[_, _, i, j]| [i, j]));
                    solver.meet([group[0][0], group[0][1]], &own, &mut found);
                    (found, solver, own)
                },
            )
            .map(|(found, ..)| found)
            .collect();
        let mut points: Vec<Meeting> = Vec::with_capacity(found.iter().map(|own| own.points.len()).sum());
        let (mut overlaps, mut exhausted) = (Vec::new(), Vec::new());
        for own in found {
            points.extend(own.points);
            overlaps.extend(own.overlaps);
            exhausted.extend(own.exhausted);
        }
        points.sort_by(|x, y| {
            let by_place = x.at[0].total_cmp(&y.at[0]).then(x.at[1].total_cmp(&y.at[1]));
            x.pieces.cmp(&y.pieces).then(by_place)
        });
        Self { points, overlaps, exhausted, depth: 0 }
    }
}
