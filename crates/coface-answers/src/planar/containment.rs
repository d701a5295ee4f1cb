//! The regions and the features that contain each face.

use super::drawing::{Filling, NO_FEATURE, PlanarDrawing};
use crate::answer::{Remark, RemarkCode};
use coface_algebra::RaggedArray;
use coface_arrange::boolean::InsideRule;

/// The regions around each face, and what is odd about rings.
#[derive(Clone, Debug)]
pub(super) struct Containment {
    /// For each bounded face the regions that contain it, rising.
    pub(super) regions: RaggedArray,
    /// For each bounded face the features with properties that contain it, rising; empty if there are none.
    pub(super) features: RaggedArray,
    /// For each ring the least and the greatest winding number around a face.
    pub(super) windings: Vec<[i32; 2]>,
    /// The holes that are not inside of the outer rings of their polygons, rising.
    pub(super) stray_holes: Vec<u32>,
}

/// Warnings of one kind that are listed one by one.
const LISTED: usize = 8;

impl Containment {
    /// What is odd about rings, each with the name of a model.
    pub(super) fn warnings(&self, drawing: &PlanarDrawing) -> Vec<String> {
        let mut warnings: Vec<String> = (self.stray_holes.iter().take(LISTED))
            .map(|&ring| {
                let (model, name) = (drawing.model_of_ring(ring), drawing.ring_name(ring));
                format!("{model}: {name} is not inside of its outer ring; what is outside counts as empty")
            })
            .collect();
        if self.stray_holes.len() > LISTED {
            warnings.push(format!(
                "{} more holes are not inside of their outer rings",
                self.stray_holes.len() - LISTED
            ));
        }
        warnings
    }

    /// The same in one remark, or in none.
    pub(super) fn remarks(&self, drawing: &PlanarDrawing) -> Vec<Remark> {
        let warnings = self.warnings(drawing);
        let Some(first) = warnings.first() else { return Vec::new() };
        let message = match self.stray_holes.len() {
            1 => first.clone(),
            count => format!("{first}; {} more holes are not inside of their outer rings", count - 1),
        };
        vec![Remark::new(RemarkCode::DrawingAssumption, message).at(self.stray_holes.len(), [])]
    }
}

/// What winding numbers of rings mean.
///
/// A rule that is given holds for all rings; without one, drawings that state a rule keep it, and others wind when their number
/// is not zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fillings<'a> {
    drawing: &'a PlanarDrawing,
    rule: Option<InsideRule>,
}

impl<'a> Fillings<'a> {
    pub(super) fn new(drawing: &'a PlanarDrawing, rule: Option<InsideRule>) -> Self {
        Self { drawing, rule }
    }

    fn rule(&self) -> InsideRule {
        self.rule.unwrap_or_default()
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

    /// Whether what a ring winds around is taken out of its polygon.
    fn is_hole(&self, ring: u32) -> bool {
        let ring = self.drawing.rings[ring as usize];
        ring.is_hole && self.filling(ring.polygon) == Filling::OuterWithoutHoles
    }

    /// Whether a point is inside of the rings of a polygon that are no holes, by how often these wind around it in sum.
    pub(super) fn is_within(&self, polygon: u32, sum: i32) -> bool {
        let rule = match self.filling(polygon) {
            Filling::OuterWithoutHoles => self.rule(),
            Filling::Stated(rule) => rule,
            Filling::Lines => InsideRule::Odd,
        };
        rule.is_inside(sum)
    }

    /// Whether a point is inside of a polygon, by the winding numbers of its rings that are not zero.
    pub(super) fn is_inside(&self, polygon: u32, windings: &[(u32, i32)]) -> bool {
        let mut sum = 0;
        for &(ring, winding) in windings {
            if !self.is_hole(ring) {
                sum += winding;
            } else if self.rule().is_inside(winding) {
                return false;
            }
        }
        self.is_within(polygon, sum)
    }
}

/// What the face that a tour is in is inside of.
pub(super) struct ContainmentSearch<'a> {
    drawing: &'a PlanarDrawing,
    fillings: Fillings<'a>,
    winding: Vec<i32>,
    /// For each polygon: around how many holes and how often around the rest, or the sum of all winding numbers.
    holes: Vec<u32>,
    sums: Vec<i32>,
    regions: Around,
    features: Around,
    /// The holes that the tour is in, rising.
    holes_around: Vec<u32>,
    /// The rings that were crossed on the way to the next face.
    crossed: Vec<u32>,
    /// The place of each face in the order of the tour, and the number of those that have been entered.
    order: Vec<u32>,
    entered: u32,
    windings: Vec<[i32; 2]>,
    is_stray: Vec<bool>,
}

impl<'a> ContainmentSearch<'a> {
    /// In the unbounded face.
    pub(super) fn new(drawing: &'a PlanarDrawing, rule: Option<InsideRule>, face_count: usize) -> Self {
        let ring_count = drawing.rings.len();
        Self {
            drawing,
            fillings: Fillings::new(drawing, rule),
            winding: vec![0; ring_count],
            holes: vec![0; drawing.polygons.len()],
            sums: vec![0; drawing.polygons.len()],
            regions: Around::new(drawing.regions.len()),
            features: Around::new(drawing.feature_count()),
            holes_around: Vec::new(),
            crossed: Vec::new(),
            order: vec![0; face_count],
            entered: 0,
            windings: vec![[0; 2]; ring_count],
            is_stray: vec![false; ring_count],
        }
    }

    /// Whether the face is inside of the rings of a polygon that are no holes.
    fn is_within(&self, polygon: u32) -> bool {
        self.fillings.is_within(polygon, self.sums[polygon as usize])
    }

    fn has_polygon(&self, polygon: u32) -> bool {
        self.is_within(polygon) && self.holes[polygon as usize] == 0
    }

    /// The tour crosses a ring. Segments of no ring have numbers beyond the last.
    pub(super) fn wind(&mut self, ring: u32, by: i32) {
        let Some(&before) = self.winding.get(ring as usize) else { return };
        let drawing = self.drawing;
        let polygon = drawing.rings[ring as usize].polygon;
        self.crossed.push(ring);
        let was_in = self.has_polygon(polygon);
        self.winding[ring as usize] += by;
        if self.fillings.is_hole(ring) {
            let rule = self.fillings.rule();
            let [was, is] = [before, before + by].map(|winding| rule.is_inside(winding));
            self.holes[polygon as usize] += u32::from(is);
            self.holes[polygon as usize] -= u32::from(was);
            if was != is {
                toggle(&mut self.holes_around, ring);
            }
        } else {
            self.sums[polygon as usize] += by;
        }
        let is_in = self.has_polygon(polygon);
        let polygon = drawing.polygons[polygon as usize];
        self.regions.step(polygon.region, was_in, is_in);
        if polygon.feature != NO_FEATURE {
            self.features.step(polygon.feature, was_in, is_in);
        }
    }

    /// The tour is in a face for the first time.
    pub(super) fn enter(&mut self, face: u32) {
        for &ring in &self.crossed {
            let [least, most] = &mut self.windings[ring as usize];
            let winding = self.winding[ring as usize];
            (*least, *most) = ((*least).min(winding), (*most).max(winding));
            let polygon = self.drawing.rings[ring as usize].polygon;
            if self.holes[polygon as usize] > 0 && !self.is_within(polygon) {
                let holes = self.holes_around.iter().copied();
                holes
                    .filter(|&hole| self.drawing.rings[hole as usize].polygon == polygon)
                    .for_each(|hole| self.is_stray[hole as usize] = true);
            }
        }
        self.crossed.clear();
        self.order[face as usize] = self.entered;
        self.entered += 1;
        self.regions.note();
        if self.drawing.feature_count() > 0 {
            self.features.note();
        }
    }

    /// What was found, after the tour.
    pub(super) fn finish(self) -> Containment {
        let [regions, features] = [&self.regions, &self.features].map(|around| around.by_face(&self.order));
        let stray_holes = (0..).zip(&self.is_stray).filter(|(_, is_stray)| **is_stray).map(|(ring, _)| ring);
        Containment { regions, features, windings: self.windings, stray_holes: stray_holes.collect() }
    }
}

/// Unions of polygons, by their numbers, that contain the face that a tour is in.
struct Around {
    /// How many polygons of each contain it.
    counts: Vec<u32>,
    /// Those that contain it, rising.
    inside: Vec<u32>,
    /// The lists of the faces in the order of the tour.
    lists: RaggedArray,
}

impl Around {
    fn new(count: usize) -> Self {
        Self { counts: vec![0; count], inside: Vec::new(), lists: RaggedArray::new() }
    }

    /// The tour leaves or enters a polygon of this union, or neither.
    fn step(&mut self, union: u32, was_in: bool, is_in: bool) {
        let count = &mut self.counts[union as usize];
        let was_inside = *count > 0;
        *count = *count + u32::from(is_in) - u32::from(was_in);
        if was_inside != (*count > 0) {
            toggle(&mut self.inside, union);
        }
    }

    /// The tour is in the next face.
    fn note(&mut self) {
        self.lists.push(&self.inside);
    }

    /// The lists in the order of the faces, whose places in the tour these are; none if none were noted.
    fn by_face(&self, places: &[u32]) -> RaggedArray {
        if self.lists.is_empty() {
            return RaggedArray::new();
        }
        RaggedArray::from_lists(places.iter().map(|&place| self.lists.list(place as usize)))
    }
}

/// Takes a number out of a rising list, or puts it in.
fn toggle(list: &mut Vec<u32>, number: u32) {
    match list.binary_search(&number) {
        Ok(at) => drop(list.remove(at)),
        Err(at) => list.insert(at, number),
    }
}
