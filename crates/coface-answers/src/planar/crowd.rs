//! Formulas of many regions that cover each other: what is decided by some of them is not cut along the others.

use super::containment::{Containment, Fillings};
use super::drawing::{NO_FEATURE, PlanarDrawing};
use super::outcome::Outcome;
use super::walks::{RingWalks, Walks};
use coface_algebra::{Error, RaggedArray};
use coface_arrange::boolean::{BooleanFormula, InsideRule, PartialValues};
use coface_arrange::planar::{
    PlanarOptions, PlanarOverlay, UndecidedRings, VertexSource, are_valid_polygons, is_simple_ring,
    turned_rings,
};
use rayon::prelude::*;

/// Whether parts of rings are left out where others decide.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Leaving {
    /// Where there are many polygons that cover each other, and the formula may be decided by some of them.
    #[default]
    Usual,
    /// Nowhere, as a second way to the same result.
    #[cfg(test)]
    Never,
    /// Wherever it can be done.
    #[cfg(test)]
    Always,
}

/// Fewer polygons are laid over each other as they are.
const FEW_POLYGONS: usize = 8;
/// So many polygons are looked at to see whether polygons cover each other.
const SAMPLES: usize = 64;
/// Polygons cover each other if there are so many boxes of polygons around the centers of such boxes in the mean.
const COVERED: usize = 3;

/// What a formula selects, with what is odd about polygons that are not valid.
pub(super) struct Crowd {
    pub(super) found: Outcome,
    pub(super) cell_counts: [usize; 3],
    /// The rings of polygons that are not valid, laid over each other, if there are any.
    pub(super) invalid: Option<(PlanarOverlay, Containment)>,
}

impl Crowd {
    /// What a formula selects; `None` where it is as good to lay all rings over each other.
    pub(super) fn new(
        drawing: &PlanarDrawing,
        walks: &Walks<'_>,
        formula: &BooleanFormula,
        rule: Option<InsideRule>,
        options: &PlanarOptions,
        leaving: Leaving,
    ) -> Result<Option<Self>, Error> {
        let condition = Condition::new(drawing, formula, rule);
        // A region of several polygons may be decided by one of them.
        let depends_on_all =
            condition.values.depends_on_all() && drawing.regions.len() == drawing.polygons.len();
        let is_wanted = match leaving {
            Leaving::Usual => !depends_on_all && is_crowded(drawing),
            #[cfg(test)]
            Leaving::Never => false,
            #[cfg(test)]
            Leaving::Always => true,
        };
        if !is_wanted {
            return Ok(None);
        }
        let rings = walks.along_rings(|_| true);
        let polygons = Plainness::of_all(drawing, &rings, rule)?;
        let polygon_of = |ring: u32| drawing.rings[ring as usize].polygon;
        let is_kept = |ring: &u32| polygons[polygon_of(*ring) as usize] == Plainness::Kept;
        let kept: Vec<u32> = (0..drawing.rings.len() as u32).filter(is_kept).collect();
        let conditions = || {
            let mut own = condition.clone();
            move |known: &[(u32, i32)], unknown: &[u32]| own.value(known, unknown)
        };
        let undecided =
            UndecidedRings::new(&drawing.positions, &rings.corners, &rings.rings, &kept, conditions);
        let Some(undecided) = undecided else { return Ok(None) };
        let is_smaller = 3 * undecided.side_count() < 2 * rings.segments.len();
        if leaving == Leaving::Usual && !is_smaller {
            return Ok(None);
        }
        let overlay = undecided.overlay(&drawing.positions, options)?;
        let Some(selection) = undecided.selection(&overlay, conditions) else { return Ok(None) };
        let is_inside = &selection.is_inside;
        // Each polygon with a face that it contains some of.
        let mut inside: Vec<[u32; 2]> = Vec::new();
        for (face, windings) in &selection.windings {
            inside.extend(condition.polygons(windings).map(|polygon| [*face, polygon]));
        }
        // A simple ring with sides within the selection has some of it inside.
        for edge in 0..overlay.cells().edges().ends().len() as u32 {
            let [left, right] = [2 * edge, 2 * edge + 1].map(|halfedge| overlay.cells().face(halfedge));
            let is_selected = |face: u32| is_inside.get(face as usize).is_some_and(|is_inside| *is_inside);
            if is_selected(left) && is_selected(right) {
                let around = overlay.edge_numbers(edge).map(polygon_of);
                let plain = around.filter(|&polygon| polygons[polygon as usize] == Plainness::Plain);
                inside.extend(plain.map(|polygon| [left, polygon]));
            }
        }
        let left_out: Vec<u32> = (undecided.left_out().iter().copied())
            .filter(|&walk| polygons[polygon_of(rings.rings[walk as usize]) as usize] == Plainness::Plain)
            .collect();
        let corners: Vec<[f64; 2]> =
            left_out.iter().map(|&walk| drawing.place(rings.corners.list(walk as usize)[0])).collect();
        for (&walk, face) in left_out.iter().zip(overlay.faces_at(&corners)) {
            if let Some(face) = face.filter(|&face| is_inside[face as usize]) {
                inside.push([face, polygon_of(rings.rings[walk as usize])]);
            }
        }
        inside.par_sort_unstable();
        inside.dedup();
        let of_faces = |of_polygon: &dyn Fn(u32) -> u32| {
            let mut pairs: Vec<[u32; 2]> = (inside.iter())
                .map(|&[face, polygon]| [face, of_polygon(polygon)])
                .filter(|pair| pair[1] != NO_FEATURE)
                .collect();
            pairs.sort_unstable();
            pairs.dedup();
            let mut lists = RaggedArray::grouped(overlay.face_count(), pairs.iter().map(|pair| pair[0]));
            lists.items_mut().iter_mut().for_each(|item| *item = pairs[*item as usize][1]);
            lists
        };
        let regions = of_faces(&|polygon| drawing.polygons[polygon as usize].region);
        let features = of_faces(&|polygon| drawing.polygons[polygon as usize].feature);
        let segment = |side: usize| undecided.place(side).map(|place| rings.segments[place]);
        let source = |source: VertexSource| match source {
            VertexSource::Given(_) => source,
            VertexSource::Crossing(sides) => VertexSource::Crossing(
                sides
                    .map(|side| segment(side).expect("a boundary has no crossings of chords alone") as usize),
            ),
        };
        let found = Outcome::new(&overlay, is_inside, false, source, segment, [&regions, &features])?;
        let invalid = if kept.is_empty() {
            None
        } else {
            let kept = walks.along_rings(|ring| kept.binary_search(&ring).is_ok());
            let options = PlanarOptions::default();
            let own =
                PlanarOverlay::without_windings(&drawing.positions, &kept.corners, &kept.rings, &options)?;
            let containment = super::boolean::containment(drawing, &own, rule);
            Some((own, containment))
        };
        Ok(Some(Self { found, cell_counts: overlay.f_vector(), invalid }))
    }
}

/// Whether many polygons cover each other.
fn is_crowded(drawing: &PlanarDrawing) -> bool {
    let count = drawing.polygons.len();
    if count < FEW_POLYGONS {
        return false;
    }
    let mut boxes: Vec<[[f64; 2]; 2]> = vec![[[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]]; count];
    for (segment, &ring) in drawing.segments.iter().zip(&drawing.ring_of_segment) {
        if let Some(ring) = drawing.rings.get(ring as usize) {
            let [low, high] = &mut boxes[ring.polygon as usize];
            let point = drawing.place(segment[0]);
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
    }
    let step = count.div_ceil(SAMPLES);
    let center = |[low, high]: &[[f64; 2]; 2]| [0, 1].map(|axis| low[axis] * 0.5 + high[axis] * 0.5);
    let around = |center: [f64; 2]| {
        let is_in = |[low, high]: &&[[f64; 2]; 2]| {
            (0..2).all(|axis| low[axis] < center[axis] && center[axis] < high[axis])
        };
        boxes.iter().filter(is_in).count()
    };
    let samples: Vec<usize> = boxes.iter().step_by(step).map(center).map(around).collect();
    samples.iter().sum::<usize>() >= COVERED * samples.len()
}

/// What is known of a polygon by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Plainness {
    /// It is valid: next to each of its sides some of its inside lies.
    Plain,
    /// It is valid, and nothing is inside by the rule.
    Empty,
    /// What is inside is not that simple: all its sides are kept.
    Kept,
}

impl Plainness {
    fn of_all(
        drawing: &PlanarDrawing,
        walks: &RingWalks,
        rule: Option<InsideRule>,
    ) -> Result<Vec<Self>, Error> {
        let mut walks_of: Vec<Vec<u32>> = vec![Vec::new(); drawing.polygons.len()];
        for (walk, &ring) in (0..).zip(&walks.rings) {
            walks_of[drawing.rings[ring as usize].polygon as usize].push(walk);
        }
        let fillings = Fillings::new(drawing, rule);
        let polygons: Vec<(u32, Vec<u32>)> = (0..).zip(walks_of).collect();
        let plainness = |(polygon, own): &(u32, Vec<u32>)| {
            if own.is_empty() {
                return Ok(Self::Kept);
            }
            let rings = RaggedArray::from_lists(own.iter().map(|&walk| walks.corners.list(walk as usize)));
            let all: Vec<u32> = (0..own.len() as u32).collect();
            let one = RaggedArray::from_lists([&all[..]]);
            let is_valid = match own.len() {
                1 => is_simple_ring(&drawing.positions, rings.list(0)),
                _ => are_valid_polygons(&drawing.positions, &rings, &one, false)?,
            };
            if !is_valid {
                return Ok(Self::Kept);
            }
            let winding = if turned_rings(&drawing.positions, &rings, &one)[0] { -1 } else { 1 };
            Ok(if fillings.is_within(*polygon, winding) { Self::Plain } else { Self::Empty })
        };
        polygons.par_iter().with_min_len(4).map(plainness).collect()
    }
}

/// Whether a formula of regions holds, by winding numbers of rings.
#[derive(Clone)]
struct Condition<'a> {
    drawing: &'a PlanarDrawing,
    fillings: Fillings<'a>,
    values: PartialValues,
    inside: Vec<u32>,
    unknown: Vec<u32>,
}

impl<'a> Condition<'a> {
    fn new(drawing: &'a PlanarDrawing, formula: &BooleanFormula, rule: Option<InsideRule>) -> Self {
        Self {
            drawing,
            fillings: Fillings::new(drawing, rule),
            values: PartialValues::new(formula),
            inside: Vec::new(),
            unknown: Vec::new(),
        }
    }

    fn polygon(&self, ring: u32) -> u32 {
        self.drawing.rings[ring as usize].polygon
    }

    /// The polygons that these winding numbers are inside of, rising.
    fn polygons<'b>(&'b self, windings: &'b [(u32, i32)]) -> impl Iterator<Item = u32> + 'b {
        windings
            .chunk_by(|a, b| self.polygon(a.0) == self.polygon(b.0))
            .map(|own| (self.polygon(own[0].0), own))
            .filter(|(polygon, own)| self.fillings.is_inside(*polygon, own))
            .map(|(polygon, _)| polygon)
    }

    fn value(&mut self, known: &[(u32, i32)], unknown: &[u32]) -> Option<bool> {
        let region = |polygon: u32| self.drawing.polygons[polygon as usize].region;
        let (mut inside, mut may_be) = (std::mem::take(&mut self.inside), std::mem::take(&mut self.unknown));
        inside.clear();
        may_be.clear();
        // The numbers of rings rise with those of their polygons.
        let is_unknown =
            |polygon: &u32| unknown.binary_search_by_key(polygon, |&ring| self.polygon(ring)).is_ok();
        inside.extend(self.polygons(known).filter(|polygon| !is_unknown(polygon)).map(region));
        inside.sort_unstable();
        inside.dedup();
        may_be.extend(unknown.iter().map(|&ring| region(self.polygon(ring))));
        may_be.sort_unstable();
        may_be.dedup();
        may_be.retain(|region| inside.binary_search(region).is_err());
        let value = self.values.value(inside.iter().copied(), may_be.iter().copied());
        (self.inside, self.unknown) = (inside, may_be);
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BooleanRequest, RegionBoolean, RegionSource};
    use coface_io::{Format, Model};
    use proptest::prelude::*;

    fn drawing(texts: &[String]) -> PlanarDrawing {
        let models: Vec<Model> =
            texts.iter().map(|text| coface_io::read(text.as_bytes(), Format::Wkt).unwrap()).collect();
        // Closed lines of a file of segments are a region.
        let models: Vec<Model> = models.into_iter().map(|model| model.with_format(Format::Lines)).collect();
        PlanarDrawing::new(models.iter().map(|model| ("drawn", model)), RegionSource::Models).unwrap()
    }

    fn written(result: &RegionBoolean) -> String {
        let mut text = Vec::new();
        result.write(&mut text, Format::Wkt).unwrap();
        String::from_utf8(text).unwrap()
    }

    /// Compares what is left where parts of rings are left out with the overlay of all rings.
    fn compare(texts: &[String], formula: &BooleanFormula, request: &BooleanRequest) {
        let combined =
            |leaving| RegionBoolean::leaving_out(drawing(texts), formula, request, leaving).unwrap();
        let [all, some] = [Leaving::Never, Leaving::Always].map(combined);
        let about = format!("{formula:?} {request:?} of\n{}", texts.join("\n"));
        assert_eq!(written(&some), written(&all), "{about}");
        let [answer, expected] = [&some, &all].map(|result| {
            let mut answer = result.answer();
            answer.arrangement = [0; 3];
            // The places where a ring crosses itself are listed in another order where other rings run through them.
            answer.remarks.iter_mut().for_each(|remark| {
                remark.message.clear();
                remark.places.clear();
            });
            answer
        });
        assert_eq!(format!("{answer:?}"), format!("{expected:?}"), "{about}");
        let [found, expected] = [&some, &all].map(RegionBoolean::provenance);
        assert_eq!(found.polygons, expected.polygons, "{about}");
        assert_eq!(format!("{:?}", found.edges), format!("{:?}", expected.edges), "{about}");
        assert_eq!(found.vertices.len(), expected.vertices.len(), "{about}");
    }

    fn ring(corners: &[[f64; 2]]) -> String {
        let points = corners.iter().chain(corners.first()).map(|[x, y]| format!("{x} {y}"));
        format!("({})", points.collect::<Vec<_>>().join(", "))
    }

    fn polygon(corners: &[[f64; 2]]) -> String {
        format!("POLYGON ({})", ring(corners))
    }

    /// A star with corners near and far in turn.
    fn star(center: [f64; 2], radii: &[f64]) -> Vec<[f64; 2]> {
        let corner = |(i, radius): (usize, &f64)| {
            let (sine, cosine) = (std::f64::consts::TAU * i as f64 / radii.len() as f64).sin_cos();
            [center[0] + radius * cosine, center[1] + radius * sine]
        };
        radii.iter().enumerate().map(corner).collect()
    }

    fn formulas(count: usize) -> impl Strategy<Value = BooleanFormula> {
        let last = count - 1;
        prop_oneof![
            4 => Just(BooleanFormula::union(count)),
            1 => Just(BooleanFormula::intersection(count)),
            1 => Just(BooleanFormula::difference(count)),
            1 => Just(BooleanFormula::xor(count)),
            2 => Just(BooleanFormula::parse(&format!("(0 | 1 | 2 | {last}) - (1 & {last})"), &[]).unwrap()),
        ]
    }

    fn with_formulas(
        texts: impl Strategy<Value = Vec<String>>,
    ) -> impl Strategy<Value = (Vec<String>, BooleanFormula)> {
        texts.prop_flat_map(|texts| {
            let count = texts.len();
            (Just(texts), formulas(count))
        })
    }

    fn requests() -> impl Strategy<Value = BooleanRequest> {
        let rule = prop_oneof![
            3 => Just(None),
            1 => Just(Some(InsideRule::Nonzero)),
            1 => Just(Some(InsideRule::Odd)),
            2 => Just(Some(InsideRule::Positive)),
        ];
        rule.prop_map(|rule| BooleanRequest { rule, ..BooleanRequest::default() })
    }

    /// Polygons on a small grid, so that corners, sides and crossings coincide: some cross themselves, some have holes,
    /// some are closed lines.
    fn coincident() -> impl Strategy<Value = Vec<String>> {
        let corner = (0i8..9, 0i8..9).prop_map(|(x, y)| [f64::from(x), f64::from(y)]);
        let tangled = prop::collection::vec(corner.clone(), 3..7).prop_map(|corners| polygon(&corners));
        let rectangle =
            (corner.clone(), 1i8..6, 1i8..6, any::<bool>()).prop_map(|([x, y], width, height, turned)| {
                let [right, top] = [x + f64::from(width), y + f64::from(height)];
                let mut corners = vec![[x, y], [right, y], [right, top], [x, top]];
                if turned {
                    corners.reverse();
                }
                corners
            });
        let plain = rectangle.clone().prop_map(|corners| polygon(&corners));
        let framed = (rectangle.clone(), rectangle)
            .prop_map(|(outer, inner)| format!("POLYGON ({}, {})", ring(&outer), ring(&inner)));
        let lines =
            prop::collection::vec(corner, 3..5).prop_map(|corners| format!("LINESTRING {}", ring(&corners)));
        let one = prop_oneof![2 => tangled, 5 => plain, 2 => framed, 1 => lines];
        prop::collection::vec(one, 4..16)
    }

    fn stars() -> impl Strategy<Value = Vec<String>> {
        let one = (0.0..4.0f64, 0.0..4.0f64, prop::collection::vec(0.3..1.4f64, 5..24))
            .prop_map(|(x, y, radii)| polygon(&star([x, y], &radii)));
        prop::collection::vec(one, 4..40)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(128))]

        #[test]
        fn coincident_polygons_combine_as_if_all_were_cut(
            (texts, formula) in with_formulas(coincident()),
            request in requests(),
        ) {
            compare(&texts, &formula, &request);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        #[test]
        fn stars_combine_as_if_all_were_cut(
            (texts, formula) in with_formulas(stars()),
            request in requests(),
        ) {
            compare(&texts, &formula, &request);
        }
    }

    /// The union of many stars is cut along few sides, the same with one thread and with several.
    #[test]
    fn most_sides_within_a_union_are_not_cut() {
        let mut seed = 1u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        let texts: Vec<String> = (0..300)
            .map(|_| {
                let center = [6.0 * random(), 6.0 * random()];
                polygon(&star(center, &(0..20).map(|_| 0.5 + random()).collect::<Vec<f64>>()))
            })
            .collect();
        let union = BooleanFormula::union(300);
        let combined = || RegionBoolean::new(drawing(&texts), &union, &BooleanRequest::default()).unwrap();
        let whole =
            RegionBoolean::leaving_out(drawing(&texts), &union, &BooleanRequest::default(), Leaving::Never)
                .unwrap();
        let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let [one, three] = [1, 3].map(|threads| pool(threads).install(combined));
        assert_eq!(written(&one), written(&whole));
        assert_eq!(
            format!("{:?} {:?}", one.answer(), one.provenance()),
            format!("{:?} {:?}", three.answer(), three.provenance())
        );
        let [cut, all] = [&one, &whole].map(|result| result.answer().arrangement[0]);
        assert!(20 * cut < all, "{cut} of {all} vertices");
    }

    /// Boxes along sides that lie on each other stay few: each cut would make twice as many.
    #[test]
    fn sides_that_lie_on_each_other_are_not_cut_without_end() {
        let texts: Vec<String> = (1..=12)
            .map(f64::from)
            .map(|i| polygon(&[[0.0, 0.0], [7.0, 3.0], [7.0 - 0.3 * i, 3.0 + 0.7 * i], [-0.3 * i, 0.7 * i]]))
            .collect();
        compare(&texts, &BooleanFormula::union(12), &BooleanRequest::default());
    }

    /// Closed lines are regions as well: what lies within others is not cut.
    #[test]
    fn most_sides_within_a_union_of_closed_lines_are_not_cut() {
        let radii =
            |i: u32| (0..24).map(|k| if (i + k).is_multiple_of(3) { 0.7 } else { 1.4 }).collect::<Vec<f64>>();
        let texts: Vec<String> = (0..100u32)
            .map(|i| polygon(&star([f64::from(i % 10) * 0.61, f64::from(i / 10) * 0.57], &radii(i))))
            .map(|text| text.replace("POLYGON ((", "LINESTRING (").replace("))", ")"))
            .collect();
        let union = BooleanFormula::union(100);
        let [all, some] = [Leaving::Never, Leaving::Usual].map(|leaving| {
            RegionBoolean::leaving_out(drawing(&texts), &union, &BooleanRequest::default(), leaving).unwrap()
        });
        assert_eq!(written(&some), written(&all));
        let [cut, all] = [&some, &all].map(|result| result.answer().arrangement[0]);
        assert!(10 * cut < all, "{cut} of {all} vertices");
    }

    /// Properties of features and names of regions come from all polygons that contain some of the result.
    #[test]
    fn features_within_a_union_keep_their_properties() {
        // Squares in four rows that cover each other, and one far away within a large one.
        let square = |x: f64, y: f64, size: f64| {
            format!("[[[{x},{y}],[{0},{y}],[{0},{1}],[{x},{1}],[{x},{y}]]]", x + size, y + size)
        };
        let mut squares: Vec<String> =
            (0..40).map(|i| square(f64::from(i % 10), f64::from(i / 10), 3.5)).collect();
        squares.push(square(100.0, 0.0, 50.0));
        squares.push(square(110.0, 10.0, 2.0));
        let features = squares.iter().enumerate().map(|(i, square)| {
            format!(
                r#"{{"type":"Feature","properties":{{"plot":{i}}},
                "geometry":{{"type":"Polygon","coordinates":{square}}}}}"#
            )
        });
        let features: Vec<String> = features.collect();
        let text = format!(r#"{{"type":"FeatureCollection","features":[{}]}}"#, features.join(","));
        let model = coface_io::read(text.as_bytes(), Format::GeoJson).unwrap();
        let [all, some] = [Leaving::Never, Leaving::Always].map(|leaving| {
            let drawing = PlanarDrawing::new([("plots", &model)], RegionSource::Features).unwrap();
            let union = BooleanFormula::union(drawing.region_names().len());
            let result =
                RegionBoolean::leaving_out(drawing, &union, &BooleanRequest::default(), leaving).unwrap();
            let mut text = Vec::new();
            result.write(&mut text, Format::GeoJson).unwrap();
            (String::from_utf8(text).unwrap(), result.answer().arrangement[0])
        });
        assert_eq!(some.0, all.0);
        assert!(some.0.contains("[40,41]") && some.1 < all.1, "{} {} {}", some.0, some.1, all.1);
    }
}
