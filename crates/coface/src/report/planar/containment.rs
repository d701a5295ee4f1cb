//! The regions that contain each face of an arrangement.

use super::drawing::{Filling, PlanarDrawing};
use super::sides::Sides;
use crate::algebra::RaggedArray;
use crate::arrangement::boolean::InsideRule;
use crate::arrangement::planar::PlanarArrangement;
use crate::{FaceId, HalfedgeId};
use std::collections::BTreeSet;

/// The regions around each face, and the rings that wind more than once around something or in both directions.
#[derive(Clone, Debug)]
pub(super) struct Containment {
    /// For each bounded face the regions that contain it, rising.
    pub(super) regions: RaggedArray,
    /// For each ring the least and the greatest winding number around a face.
    pub(super) windings: Vec<[i32; 2]>,
}

/// A face on the way from the unbounded one, with its walks.
struct Visit<'a> {
    /// The halfedge of this face across which it was entered.
    entered: Option<u32>,
    walks: Vec<&'a [u32]>,
    walk: usize,
    at: usize,
}

impl Visit<'_> {
    fn next(&mut self) -> Option<u32> {
        while let Some(walk) = self.walks.get(self.walk) {
            if let Some(&halfedge) = walk.get(self.at) {
                self.at += 1;
                return Some(halfedge);
            }
            self.walk += 1;
            self.at = 0;
        }
        None
    }
}

/// What the face that the search is in is inside of.
struct State<'a> {
    drawing: &'a PlanarDrawing,
    rule: Option<InsideRule>,
    winding: Vec<i32>,
    /// For each polygon: around how many holes and how often around the rest, or the sum of all winding numbers.
    holes: Vec<u32>,
    sums: Vec<i32>,
    polygons_of_region: Vec<u32>,
    inside: BTreeSet<u32>,
}

impl State<'_> {
    fn rule(&self) -> InsideRule {
        self.rule.unwrap_or_default()
    }

    fn has_polygon(&self, polygon: u32) -> bool {
        let sum = self.sums[polygon as usize];
        match self.filling(polygon) {
            Filling::OuterWithoutHoles => self.rule().is_inside(sum) && self.holes[polygon as usize] == 0,
            Filling::Stated(rule) => rule.is_inside(sum),
            Filling::Lines => InsideRule::Odd.is_inside(sum),
        }
    }

    /// What is inside of a polygon by the rule that was asked for.
    fn filling(&self, polygon: u32) -> Filling {
        match (self.drawing.polygons[polygon as usize].filling, self.rule) {
            (Filling::Stated(_), Some(rule)) => Filling::Stated(rule),
            // This rule asks for the directions as they are.
            (Filling::OuterWithoutHoles, Some(InsideRule::Positive)) => Filling::Stated(InsideRule::Positive),
            (filling, _) => filling,
        }
    }

    fn wind(&mut self, ring: u32, by: i32) {
        let drawing = self.drawing;
        let polygon = drawing.rings[ring as usize].polygon;
        let is_hole =
            drawing.rings[ring as usize].is_hole && self.filling(polygon) == Filling::OuterWithoutHoles;
        let was_in = self.has_polygon(polygon);
        let before = self.winding[ring as usize];
        self.winding[ring as usize] += by;
        if is_hole {
            let rule = self.rule();
            let [was, is] = [before, before + by].map(|winding| u32::from(rule.is_inside(winding)));
            self.holes[polygon as usize] = self.holes[polygon as usize] + is - was;
        } else {
            self.sums[polygon as usize] += by;
        }
        let region = drawing.polygons[polygon as usize].region;
        let is_in = self.has_polygon(polygon);
        let count = &mut self.polygons_of_region[region as usize];
        *count = *count + u32::from(is_in) - u32::from(was_in);
        if *count > 0 {
            self.inside.insert(region);
        } else {
            self.inside.remove(&region);
        }
    }
}

impl Containment {
    /// Walks over all faces from the unbounded one and back, and keeps the winding numbers on the way.
    ///
    /// A rule that is given holds for all rings; without one, drawings that state a rule keep it, and others wind when their number
    /// is not zero.
    pub(super) fn new(
        drawing: &PlanarDrawing,
        arrangement: &PlanarArrangement,
        sides: &Sides<'_>,
        rule: Option<InsideRule>,
    ) -> Self {
        let ring_count = drawing.rings.len();
        let mut state = State {
            drawing,
            rule,
            winding: vec![0; ring_count],
            holes: vec![0; drawing.polygons.len()],
            sums: vec![0; drawing.polygons.len()],
            polygons_of_region: vec![0; drawing.regions.len()],
            inside: BTreeSet::new(),
        };
        let mut windings = vec![[0i32; 2]; ring_count];
        let face_count = arrangement.face_count();
        let mut is_known = vec![false; face_count];
        // Lists in the order of the search, to be put in that of the faces.
        let (mut order, mut found) = (vec![0u32; face_count], RaggedArray::new());
        let visit = |face: Option<FaceId>, entered: Option<u32>| Visit {
            entered,
            walks: arrangement.walks(face).collect(),
            walk: 0,
            at: 0,
        };
        let mut path = vec![visit(None, None)];
        let mut list = Vec::new();
        while let Some(here) = path.last_mut() {
            let Some(halfedge) = here.next() else {
                if let Some(entered) = here.entered {
                    sides.across(entered, |ring, by| state.wind(ring, -by));
                }
                path.pop();
                continue;
            };
            let Some(face) = arrangement.face_of(HalfedgeId::from_u32(halfedge ^ 1)) else { continue };
            if std::mem::replace(&mut is_known[face.index()], true) {
                continue;
            }
            sides.across(halfedge ^ 1, |ring, by| state.wind(ring, by));
            sides.across(halfedge ^ 1, |ring, _| {
                let [least, most] = &mut windings[ring as usize];
                let winding = state.winding[ring as usize];
                (*least, *most) = ((*least).min(winding), (*most).max(winding));
            });
            order[face.index()] = found.len() as u32;
            list.clear();
            list.extend(state.inside.iter().copied());
            found.push(&list);
            path.push(visit(Some(face), Some(halfedge ^ 1)));
        }
        let regions = RaggedArray::from_lists(order.iter().map(|&at| found.list(at as usize)));
        Self { regions, windings }
    }
}
