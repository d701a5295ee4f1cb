//! Clipped drawings against Boolean operations on the shape and its clip as files of their own.
#![allow(clippy::unwrap_used, reason = "tests")]

use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
use coface_arrange::boolean::BooleanFormula;
use coface_io::{Format, Model};
use proptest::prelude::*;

fn svg(inner: &str) -> Model {
    let text = format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{inner}</svg>");
    coface_io::read(text.as_bytes(), Format::Svg).unwrap()
}

fn combined(models: &[(&str, &Model)], formula: &str) -> RegionBoolean {
    let drawing = PlanarDrawing::new(models.iter().copied(), RegionSource::Models).unwrap();
    let formula = BooleanFormula::parse(formula, &[]).unwrap();
    RegionBoolean::new(drawing, &formula, &BooleanRequest::default()).unwrap()
}

#[derive(Clone, Debug)]
struct Polygon {
    points: String,
    rule: &'static str,
}

impl Polygon {
    fn text(&self, attributes: &str) -> String {
        let Self { points, rule } = self;
        format!("<polygon points='{points}' fill-rule='{rule}' clip-rule='{rule}' {attributes}/>")
    }
}

fn polygon() -> impl Strategy<Value = Polygon> {
    // Coarse, so that corners and sides coincide often, or fine.
    let coarse = proptest::collection::vec([0..9u32, 0..9u32], 3..8);
    let fine = proptest::collection::vec([0..80_000u32, 0..80_000u32], 3..12);
    let text = |corners: Vec<[u32; 2]>, scale: f64| {
        let pair = |[x, y]: [u32; 2]| format!("{},{} ", f64::from(x) * scale, f64::from(y) * scale);
        corners.into_iter().map(pair).collect::<String>()
    };
    let points = prop_oneof![
        coarse.prop_map(move |corners| text(corners, 1.0)),
        fine.prop_map(move |corners| text(corners, 1e-4)),
    ];
    (points, prop_oneof![Just("nonzero"), Just("evenodd")])
        .prop_map(|(points, rule)| Polygon { points, rule })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn what_is_read_is_the_intersection_of_shape_and_clip(
        shape in polygon(),
        first in polygon(),
        second in polygon(),
        around in polygon(),
    ) {
        let clipped = svg(&format!(
            "<clipPath id='c'>{}{}</clipPath><clipPath id='d'>{}</clipPath><g clip-path='url(#d)'>{}</g>",
            first.text(""), second.text(""), around.text(""), shape.text("clip-path='url(#c)'")
        ));
        let [shape, first, second, around] = [shape, first, second, around].map(|own| svg(&own.text("")));
        let models = [("a", &shape), ("b", &first), ("c", &second), ("d", &around)];
        let expected = combined(&models, "a & (b | c) & d").area();
        let found = combined(&[("a", &clipped)], "a");
        prop_assert!((found.area() - expected).abs() <= 1e-10, "{} for {}", found.area(), expected);
        // Nothing of it is outside, but for rounding.
        let models = [("a", &clipped), ("b", &shape), ("c", &around)];
        prop_assert!(combined(&models, "a - (b & c)").area() <= 1e-10);
    }
}

#[test]
fn neighbors_that_are_clipped_alike_still_share_their_side() {
    let inner = "<clipPath id='c'><path d='M1 0L8 3L3 9z'/></clipPath><g clip-path='url(#c)'>\
                 <path d='M0 0h10L0 7z'/><path d='M10 0v10h-10v-3z'/></g>";
    let both = combined(&[("both", &svg(inner))], "a");
    let whole = combined(&[("clip", &svg("<path d='M1 0L8 3L3 9z'/>"))], "a");
    assert!((both.area() - whole.area()).abs() < 1e-13);
    assert_eq!((both.f_vector()[2], both.hole_count()), (1, 0));
}
