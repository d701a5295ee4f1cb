//! Heights of drawings, which are carried along and decide nothing.

use super::drawing::PlanarDrawing;
use coface_algebra::{Error, RaggedArray};
use coface_arrange::planar::VertexSource;
use coface_geometry::Positions;

/// The heights of vertices of a result, by the heights of the drawing.
///
/// A vertex of an input keeps its height. Where two segments cross it is the mean of the heights along them, of those that have some.
/// What has no height so gets the one along another segment of the result that ends there, or that of the nearest vertex with a height.
pub(super) struct Heights<'a> {
    drawing: &'a PlanarDrawing,
}

impl<'a> Heights<'a> {
    /// `None` if no input has heights.
    pub(super) fn new(drawing: &'a PlanarDrawing) -> Option<Self> {
        (!drawing.heights.is_empty()).then_some(Self { drawing })
    }

    /// The positions of a result with heights, by the sources of its vertices, its edges, and the segments along these.
    pub(super) fn lift(
        &self,
        positions: &Positions,
        sources: &[VertexSource],
        edges: impl Iterator<Item = [u32; 2]>,
        segments_of_edge: &RaggedArray,
    ) -> Result<Positions, Error> {
        let places = positions.as_flat().as_chunks::<2>().0;
        let mut heights: Vec<f64> = places
            .iter()
            .zip(sources)
            .map(|(&place, source)| match *source {
                VertexSource::Given(vertex) => self.drawing.heights[vertex],
                VertexSource::Crossing(segments) => {
                    let [a, b] = segments.map(|segment| self.along(segment, place));
                    match (a.is_nan(), b.is_nan()) {
                        (false, false) => a * 0.5 + b * 0.5,
                        (true, _) => b,
                        _ => a,
                    }
                }
            })
            .collect();
        if heights.iter().any(|height| height.is_nan()) {
            for (edge, ends) in edges.enumerate() {
                for end in ends.map(|end| end as usize) {
                    if heights[end].is_nan() {
                        let segments = segments_of_edge.list(edge).iter();
                        let mut along = segments.map(|&segment| self.along(segment as usize, places[end]));
                        heights[end] = along.find(|height| !height.is_nan()).unwrap_or(f64::NAN);
                    }
                }
            }
        }
        if heights.iter().any(|height| height.is_nan()) {
            let nearest = NearestPlace::new(self.drawing);
            for (height, &place) in heights.iter_mut().zip(places).filter(|(height, _)| height.is_nan()) {
                *height = self.drawing.heights[nearest.find(place) as usize];
            }
        }
        let flat = places.iter().zip(heights).flat_map(|(&[x, y], height)| [x, y, height]).collect();
        Positions::from_flat(3, flat)
    }

    /// The height of a segment at a place on it; NaN if it has none.
    fn along(&self, segment: usize, place: [f64; 2]) -> f64 {
        let ends = self.drawing.segments[segment];
        let [low, high] = ends.map(|end| self.drawing.heights[end as usize]);
        if low.is_nan() || high.is_nan() || low == high {
            return if low.is_nan() { high } else { low };
        }
        let [[ax, ay], [bx, by]] = ends.map(|end| self.drawing.place(end));
        // Along the longer side, so that nothing is divided by a number that has lost its digits.
        let [from, to, at] =
            if (bx - ax).abs() >= (by - ay).abs() { [ax, bx, place[0]] } else { [ay, by, place[1]] };
        let part = if from == to { 0.0 } else { ((at - from) / (to - from)).clamp(0.0, 1.0) };
        low * (1.0 - part) + high * part
    }
}

/// The vertices with heights, sorted so that the nearest is found in a tree: the middle of each range divides it, by x and y in turn.
struct NearestPlace {
    places: Vec<([f64; 2], u32)>,
}

impl NearestPlace {
    fn new(drawing: &PlanarDrawing) -> Self {
        let with_heights = (0..).zip(&drawing.heights).filter(|(_, height)| !height.is_nan());
        let mut places: Vec<([f64; 2], u32)> =
            with_heights.map(|(vertex, _)| (drawing.place(vertex), vertex)).collect();
        sort(&mut places, 0);
        Self { places }
    }

    /// The nearest vertex, of equally near ones the first.
    ///
    /// # Panics
    /// If there is none.
    fn find(&self, place: [f64; 2]) -> u32 {
        let mut best = (f64::INFINITY, u32::MAX);
        search(&self.places, 0, place, &mut best);
        best.1
    }
}

fn sort(places: &mut [([f64; 2], u32)], axis: usize) {
    let middle = places.len() / 2;
    if places.len() < 2 {
        return;
    }
    places.select_nth_unstable_by(middle, |a, b| a.0[axis].total_cmp(&b.0[axis]).then(a.1.cmp(&b.1)));
    let (low, high) = places.split_at_mut(middle);
    sort(low, 1 - axis);
    sort(&mut high[1..], 1 - axis);
}

fn search(places: &[([f64; 2], u32)], axis: usize, at: [f64; 2], best: &mut (f64, u32)) {
    let middle = places.len() / 2;
    let Some(&(place, vertex)) = places.get(middle) else { return };
    let distance = (place[0] - at[0]).hypot(place[1] - at[1]);
    if distance < best.0 || distance == best.0 && vertex < best.1 || best.1 == u32::MAX {
        *best = (distance, vertex);
    }
    let way = at[axis] - place[axis];
    let (low, high) = (&places[..middle], &places[middle + 1..]);
    let [near, far] = if way < 0.0 { [low, high] } else { [high, low] };
    search(near, 1 - axis, at, best);
    if way.abs() <= best.0 {
        search(far, 1 - axis, at, best);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ArrangementRequest, BooleanRequest, DrawingArrangement, RegionBoolean, RegionSource};
    use coface_arrange::boolean::BooleanFormula;
    use coface_io::{Format, Model};
    use proptest::prelude::*;

    fn drawing(texts: &[&str]) -> PlanarDrawing {
        let models: Vec<Model> =
            texts.iter().map(|text| coface_io::read(text.as_bytes(), Format::Wkt).unwrap()).collect();
        PlanarDrawing::new(models.iter().map(|model| ("drawn", model)), RegionSource::Models).unwrap()
    }

    fn combined(texts: &[&str], formula: &str) -> String {
        let formula = BooleanFormula::parse(formula, &[]).unwrap();
        let result = RegionBoolean::new(drawing(texts), &formula, &BooleanRequest::default()).unwrap();
        let mut text = Vec::new();
        result.write(&mut text, Format::Wkt).unwrap();
        String::from_utf8(text).unwrap()
    }

    const LOW: &str = "POLYGON Z ((0 0 1, 4 0 1, 4 4 3, 0 4 3, 0 0 1))";

    #[test]
    fn vertices_keep_their_heights_and_crossings_have_the_mean() {
        let high = "POLYGON Z ((2 2 10, 6 2 10, 6 6 10, 2 6 10, 2 2 10))";
        // At (4, 2) one side is at 2, the other at 10; at (2, 4) at 3 and at 10.
        let expected = "POLYGON Z ((2 2 10, 4 2 6, 4 4 3, 2 4 6.5, 2 2 10))\n";
        assert_eq!(combined(&[LOW, high], "0 & 1"), expected);
        // One without heights gets them along the sides of the other, and inside from the nearest vertex.
        let flat = "POLYGON ((2 1, 6 1, 6 6, 2 6, 2 1))";
        assert_eq!(combined(&[LOW, flat], "0 & 1"), "POLYGON Z ((2 1 1, 4 1 1.5, 4 4 3, 2 4 3, 2 1 1))\n");
        let touching = "POLYGON ((4 1, 6 1, 6 3, 4 3, 4 1))";
        assert_eq!(
            combined(&[LOW, touching], "1"),
            "POLYGON Z ((4 1 1.5, 6 1 1, 6 3 3, 4 3 2.5, 4 1 1.5))\n"
        );
        // Heights that are all zero are heights.
        let zero = "POLYGON Z ((0 0 0, 1 0 0, 0 1 0, 0 0 0))";
        assert_eq!(combined(&[zero], "0"), format!("{zero}\n"));
        assert_eq!(combined(&["POLYGON ((0 0, 1 0, 0 1, 0 0))"], "0"), "POLYGON ((0 0, 1 0, 0 1, 0 0))\n");
    }

    #[test]
    fn arrangements_have_heights_and_may_leave_them_out() {
        let line = "LINESTRING Z (-1 2 7, 2 2 7, 2 -1 7)\nPOINT Z (9 9 9)";
        let write = |drawing: PlanarDrawing| {
            let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default()).unwrap();
            let mut text = Vec::new();
            arranged.write(&mut text, Format::Wkt).unwrap();
            (String::from_utf8(text).unwrap(), arranged.answer().unwrap())
        };
        let (text, _) = write(drawing(&[LOW, line]));
        for part in ["2 2 7", "0 2 4.5", "2 0 4", "9 9 9", "LINESTRING Z"] {
            assert!(text.contains(part), "{part}: {text}");
        }
        let (flat, answer) = write(drawing(&[LOW, line]).without_heights());
        assert!(!flat.contains('Z'), "{flat}");
        assert!(answer.remarks.iter().any(|remark| remark.code == crate::answer::RemarkCode::HeightsLeftOut));
        assert_eq!(answer.f_vector, write(drawing(&[LOW, line])).1.f_vector);
    }

    #[test]
    fn polygons_without_area_are_remarked() {
        let wall = "POLYGON Z ((0 0 0, 1 0 0, 1 0 1, 0 0 1, 0 0 0))";
        let spike = "POLYGON ((7 7, 9 9, 8 8, 7 7))";
        for (texts, count) in [(&[wall][..], 1), (&[spike], 1), (&[wall, spike, LOW], 2), (&[LOW], 0)] {
            let drawn = drawing(texts);
            let formula = BooleanFormula::union(texts.len());
            let result = RegionBoolean::new(drawn, &formula, &BooleanRequest::default()).unwrap();
            let answer = result.answer();
            let of_area: Vec<_> =
                answer.remarks.iter().filter(|remark| remark.message.contains("no area")).collect();
            assert_eq!(
                of_area.iter().map(|remark| remark.count).sum::<u64>(),
                count,
                "{texts:?}: {of_area:?}"
            );
            assert_eq!(answer.measure, if texts.contains(&LOW) { 16.0 } else { 0.0 });
        }
    }

    proptest! {
        #[test]
        fn the_nearest_place_is_the_first_of_the_nearest(
            places in prop::collection::vec((-4..5i8, -4..5i8), 1..40),
            at in (-6..7i8, -6..7i8),
        ) {
            let points: Vec<String> = places.iter().map(|(x, y)| format!("POINT Z ({x} {y} 1)")).collect();
            let drawn = drawing(&[&points.join("\n")]);
            let at = [f64::from(at.0), f64::from(at.1)];
            let distance = |vertex: u32| {
                let [x, y] = drawn.place(vertex);
                (x - at[0]).hypot(y - at[1])
            };
            let all = 0..drawn.heights.len() as u32;
            let expected = all.min_by(|&a, &b| distance(a).total_cmp(&distance(b)).then(a.cmp(&b)));
            prop_assert_eq!(Some(NearestPlace::new(&drawn).find(at)), expected);
        }
    }
}
