//! Winding numbers: which regions contain which faces.

use crate::drawing::Drawing;
use crate::faces::{Faces, OUTSIDE};
use crate::formula::Rule;
use crate::subdivision::Subdivision;
use coface_check::Fault;
use serde_json::Value;

/// How often each ring winds around the face that a tour is in.
struct Tour<'a> {
    drawing: &'a Drawing,
    rule: Rule,
    windings: Vec<i64>,
    /// For each polygon the sum of its rings that are no holes, and how many of its holes contain the face.
    sums: Vec<i64>,
    holes: Vec<u32>,
    /// For each region how many of its polygons contain the face.
    polygons: Vec<u32>,
}

impl Tour<'_> {
    fn contains(&self, polygon: usize) -> bool {
        let rule = if self.drawing.polygons[polygon].is_of_lines { Rule::Odd } else { self.rule };
        self.holes[polygon] == 0 && rule.holds(self.sums[polygon])
    }

    /// A ring winds this much more around the next face.
    fn wind(&mut self, ring: u32, by: i64) {
        let drawing = self.drawing;
        let ring_of = drawing.rings[ring as usize];
        let polygon = ring_of.polygon as usize;
        let before = self.contains(polygon);
        // The rule of what is positive takes directions as they are.
        if ring_of.is_hole && self.rule != Rule::Positive {
            let winding = &mut self.windings[ring as usize];
            self.holes[polygon] -= u32::from(self.rule.holds(*winding));
            *winding += by;
            self.holes[polygon] += u32::from(self.rule.holds(*winding));
        } else {
            self.sums[polygon] += by;
        }
        let count = &mut self.polygons[drawing.polygons[polygon].region as usize];
        *count -= u32::from(before);
        self.polygons[drawing.polygons[polygon].region as usize] += u32::from(self.contains(polygon));
    }
}

/// For each face the regions that contain it, rising, by the rule of a certificate. A tour crosses edges from the unbounded face on, which
/// no ring winds around: what is on the left of a ring winds once more than what is on its right.
pub(crate) fn regions(
    whole: &Value,
    drawing: &Drawing,
    plane: &Subdivision,
    faces: &Faces,
) -> Result<Vec<Vec<u32>>, Fault> {
    let rule = Rule::of(whole)?;
    let mut tour = Tour {
        drawing,
        rule,
        windings: vec![0; drawing.rings.len()],
        sums: vec![0; drawing.polygons.len()],
        holes: vec![0; drawing.polygons.len()],
        polygons: vec![0; drawing.region_count],
    };
    let around = faces.halfedges();
    let mut found: Vec<Option<Vec<u32>>> = vec![None; faces.count];
    found[OUTSIDE as usize] = Some(Vec::new());
    // The halfedges that were crossed, from their left to their right, and the place in the list of the face behind each.
    let mut way = vec![(None, OUTSIDE, 0usize)];
    while let Some((crossed, face, place)) = way.last_mut() {
        let Some(&halfedge) = around[*face as usize].get(*place) else {
            if let Some(back) = *crossed {
                cross(&mut tour, plane, back ^ 1);
            }
            way.pop();
            continue;
        };
        *place += 1;
        let other = faces.of[(halfedge ^ 1) as usize];
        if found[other as usize].is_none() {
            cross(&mut tour, plane, halfedge);
            let inside = (0u32..).zip(&tour.polygons).filter(|(_, count)| **count > 0);
            found[other as usize] = Some(inside.map(|(region, _)| region).collect());
            way.push((Some(halfedge), other, 0));
        }
    }
    // Each face is reached: those that are not would be a part of the plane that no edge separates from the rest.
    let missing = || Fault::new("faces", "a face cannot be reached");
    found.into_iter().map(|regions| regions.ok_or_else(missing)).collect()
}

/// From the left of a halfedge to its right.
fn cross(tour: &mut Tour<'_>, plane: &Subdivision, halfedge: u32) {
    let sign = if halfedge.is_multiple_of(2) { -1 } else { 1 };
    for &(ring, by) in &plane.rings[halfedge as usize / 2] {
        tour.wind(ring, sign * by);
    }
}
