//! Where three sheets meet in one point inside all of them.

use super::meetings::{Cut, Meetings, Place};
use super::sheets::Sheets;
use coface_algebra::Error;
use coface_algebra::progress::stage;
use coface_geometry::predicates::SpatialPoint;
use coface_geometry::{AxisBox, BoxTree, boxes_meet};
use rayon::prelude::*;
use std::borrow::Cow;
use std::ops::Range;

/// The triples of sheets that meet in a point inside all three, rising.
///
/// A triple is found in its lowest sheet, where the cuts with the other two cross.
///
/// # Errors
/// What `check` says of the number of triples found so far.
pub(super) fn triples(
    sheets: &Sheets,
    meetings: &Meetings,
    points: &[SpatialPoint],
    check: impl Fn(usize) -> Result<(), Error>,
) -> Result<Vec<[u32; 3]>, Error> {
    let cuts = &meetings.cuts;
    // The position of each end among the places; corners are no places.
    let ends: Vec<[Option<u32>; 2]> = cuts
        .par_iter()
        .map(|cut| {
            cut.ends.map(|end| match end {
                Place::Corner(_) => None,
                _ => Some(meetings.places.binary_search(&end).expect("the ends of cuts are places") as u32),
            })
        })
        .collect();
    let crossing = Crossing { sheets, cuts, ends: &ends, points };
    let mut ranges = Vec::new();
    let mut start = 0;
    for own in cuts.chunk_by(|a, b| a.sheets[0] == b.sheets[0]) {
        ranges.push(start..start + own.len());
        start += own.len();
    }
    let (crowded, small): (Vec<_>, Vec<_>) = ranges.into_iter().partition(|range| range.len() > CROWDED);
    let mut found: Vec<[u32; 3]> = Vec::new();
    let steps = stage("finding points of three sheets", small.len() + crowded.len());
    for block in small.chunks(1 << 12) {
        steps.advance(block.len());
        let own: Vec<Vec<[u32; 3]>> = block.par_iter().map(|range| crossing.within(range)).collect();
        own.iter().for_each(|own| found.extend_from_slice(own));
        check(found.len())?;
    }
    for range in crowded {
        steps.advance(1);
        crossing.add_within_crowded(&range, &mut found, &check)?;
    }
    found.par_sort_unstable();
    Ok(found)
}

/// Sheets with more cuts get a tree of them.
const CROWDED: usize = 32;

struct Crossing<'a> {
    sheets: &'a Sheets,
    cuts: &'a [Cut],
    ends: &'a [[Option<u32>; 2]],
    points: &'a [SpatialPoint],
}

impl Crossing<'_> {
    /// The crossings of the cuts of one sheet.
    fn within(&self, range: &Range<usize>) -> Vec<[u32; 3]> {
        let mut found = Vec::new();
        if range.len() > 1 {
            let boxes: Vec<AxisBox> = range.clone().map(|cut| self.box_of(cut)).collect();
            for i in 0..range.len() {
                for j in (0..i).filter(|&j| boxes_meet(&boxes[i], &boxes[j])) {
                    found.extend(self.triple(range.start + i, range.start + j));
                }
            }
        }
        found
    }

    /// Adds the crossings of the many cuts of one sheet.
    fn add_within_crowded(
        &self,
        range: &Range<usize>,
        found: &mut Vec<[u32; 3]>,
        check: &impl Fn(usize) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let boxes: Vec<AxisBox> = range.clone().map(|cut| self.box_of(cut)).collect();
        let tree = BoxTree::new(&boxes);
        let at = |i: u32| range.start + i as usize;
        let groups: Vec<usize> = (0..tree.group_count()).collect();
        for block in groups.chunks(4) {
            let own: Vec<Vec<[u32; 3]>> = block
                .par_iter()
                .map(|&group| {
                    let mut own = Vec::new();
                    tree.pairs_of_group(group, |i, j| own.extend(self.triple(at(i), at(j))));
                    own
                })
                .collect();
            own.iter().for_each(|own| found.extend_from_slice(own));
            check(found.len())?;
        }
        Ok(())
    }

    fn end(&self, cut: usize, end: usize) -> Cow<'_, SpatialPoint> {
        match self.ends[cut][end] {
            Some(place) => Cow::Borrowed(&self.points[place as usize]),
            None => Cow::Owned(self.cuts[cut].ends[end].point(self.sheets)),
        }
    }

    /// The box around the rounded ends of a cut. Rounding is monotone: boxes of cuts that cross meet.
    fn box_of(&self, cut: usize) -> AxisBox {
        let [a, b] = [0, 1].map(|end| self.end(cut, end).rounded());
        [0, 1, 2].map(|axis| [a[axis].min(b[axis]), a[axis].max(b[axis])])
    }

    /// The three sheets of two cuts of one of them that cross inside both.
    fn triple(&self, i: usize, j: usize) -> Option<[u32; 3]> {
        let [[f, g], [_, h]] = [i, j].map(|cut| self.cuts[cut].sheets);
        let separates = |sheet: u32, cut: usize| {
            let plane = self.sheets.plane(sheet);
            let side = self.end(cut, 0).side_of(plane);
            side.is_ne() && self.end(cut, 1).side_of(plane) == side.reverse()
        };
        (separates(h, i) && separates(g, j)).then(|| [f, g.min(h), g.max(h)])
    }
}
