//! Certificates of random complexes are accepted by the checker, which shares no code with what made them.

use coface_answers::{
    ArrangementRequest, BooleanRequest, DrawingArrangement, Growth, HomologyRequest, PersistenceRequest,
    PlanarDrawing, Producer, RegionBoolean, RegionSource, RelativeTo, Report, SceneArrangement, SolidBoolean,
    SolidRequest, SpatialRequest, VertexFunction,
};
use coface_arrange::boolean::{BooleanFormula, InsideRule};
use coface_topology::Coefficients;
use proptest::prelude::*;

fn model(bytes: &[u8]) -> coface_io::Model {
    coface_io::read(bytes, coface_io::Format::Json).expect("a facet list")
}

/// Facets of up to five of eight vertices.
fn facets() -> impl Strategy<Value = Vec<Vec<u32>>> {
    let facet = prop::collection::btree_set(0u32..8, 1..5).prop_map(|facet| facet.into_iter().collect());
    prop::collection::vec(facet, 1..14)
}

proptest! {
    /// Groups and generators over any ring, reduced or relative, are what the checker derives.
    #[test]
    fn groups_and_generators_are_proved(facets in facets(), n in 0u64..9, is_cohomology: bool, kind in 0..3) {
        let input = format!("{facets:?}").into_bytes();
        let coefficients = match n {
            0 => Coefficients::Integers,
            1 => Coefficients::Rationals,
            n => Coefficients::Modulo(n),
        };
        let request = HomologyRequest::new()
            .coefficients(coefficients)
            .cohomology(is_cohomology)
            .reduced(kind == 1)
            .relative((kind == 2).then_some(RelativeTo::Boundary))
            .generators(true)
            .certified(true);
        let found = request.found("in.json", model(&input)).expect("a model has homology");
        let certificate = found.certificate(&[("in.json", &input)]).expect("the checker accepts the proof");
        let verdict = coface_check::check(certificate.as_bytes(), &[&input]).expect("it has been checked");
        prop_assert!(verdict.unchecked().is_empty());
        prop_assert_eq!(verdict.proved().len(), found.groups().len() + 1);
    }

    /// Pairs relative to a part, and of the image of a part, are what the chains prove.
    #[test]
    fn diagrams_of_parts_are_proved(
        (facets, chosen) in (facets(), prop::collection::vec(0usize..14, 1..4)),
        values in prop::collection::vec(-2i8..3, 8),
        (prime, is_image, is_upper, is_file) in (prop::sample::select(vec![2u64, 3, 2_147_483_647]), any::<bool>(), any::<bool>(), any::<bool>()),
    ) {
        let input = format!("{facets:?}").into_bytes();
        let chosen: Vec<&Vec<u32>> = chosen.iter().map(|&at| &facets[at % facets.len()]).collect();
        // The facets themselves, or what is left of them without their first vertices.
        let cells = chosen.iter().map(|facet| if facet.len() > 1 { &facet[1..] } else { &facet[..] });
        let file = format!("{:?}", cells.collect::<Vec<_>>()).into_bytes();
        let producer = Producer::of(model(&input)).expect("a complex");
        let count = facets.iter().flatten().max().expect("facets have vertices") + 1;
        let values: Vec<f64> = values[..count as usize].iter().map(|&value| f64::from(value)).collect();
        let function = Some(VertexFunction::Values { place: "f.txt".to_owned(), values });
        let growth = if is_upper { Growth::Upper(function) } else { Growth::Lower(function) };
        let part = match is_file {
            true => RelativeTo::Part { name: "part.json".to_owned(), model: Box::new(model(&file)) },
            false => RelativeTo::Boundary,
        };
        let request = PersistenceRequest::new().coefficients(Coefficients::Modulo(prime)).growth(growth).min_persistence(-1.0);
        let request = match is_image {
            true => request.image_of(Some(part)),
            false => request.relative(Some(part)),
        };
        let mut inputs = vec![("in.json", &input[..])];
        if is_file {
            inputs.push(("part.json", &file));
        }
        let found = request.found("in.json", &producer).expect("values for all vertices");
        let certificate = found.certificate(&inputs).expect("the checker accepts the proof");
        let bytes: Vec<&[u8]> = inputs.iter().map(|input| input.1).collect();
        let verdict = coface_check_persistence::check(certificate.as_bytes(), &bytes).expect("it has been checked");
        prop_assert_eq!(verdict.unchecked(), ["function"]);
    }

    /// Pairs of any filtration over any field are what the chains prove.
    #[test]
    fn diagrams_are_proved(
        facets in facets(),
        values in prop::collection::vec(-2i8..3, 8),
        (prime, kind, least) in (prop::sample::select(vec![2u64, 3, 5, 4_294_967_291]), 0..4, -1..2i32),
    ) {
        let input = format!("{facets:?}").into_bytes();
        let producer = Producer::of(model(&input)).expect("a complex");
        let count = facets.iter().flatten().max().expect("facets have vertices") + 1;
        let values: Vec<f64> = values[..count as usize].iter().map(|&value| f64::from(value)).collect();
        let function = Some(VertexFunction::Values { place: "f.txt".to_owned(), values });
        let growth = match kind {
            0 => Growth::Lower(None),
            1 => Growth::Lower(function),
            2 => Growth::Upper(function),
            _ => {
                let listed = facets.iter().zip(0..).map(|(facet, value)| (facet.clone(), f64::from(value % 3)));
                Growth::Listed { place: "cells.json".to_owned(), values: listed.collect() }
            }
        };
        let request = PersistenceRequest::new()
            .coefficients(Coefficients::Modulo(prime))
            .growth(growth)
            .min_persistence(f64::from(least));
        // Values of cells that are faces of each other need not rise.
        if let Ok(found) = request.found("in.json", &producer) {
            let certificate = found.certificate(&[("in.json", &input)]).expect("the checker accepts the proof");
            let verdict = coface_check_plane::check(certificate.as_bytes(), &[&input]).expect("it has been checked");
            // The checker does not see the files of values.
            let unchecked: &[&str] = if kind == 0 { &[] } else { &["function"] };
            prop_assert_eq!(verdict.unchecked(), unchecked);
            prop_assert_eq!(verdict.proved().len(), 2 - unchecked.len() + found.answer().betti.len());
        }
    }

    /// Links, orientations, boundaries and components of reports are what the checker finds by itself.
    #[test]
    fn reports_are_proved(facets in facets()) {
        let input = format!("{facets:?}").into_bytes();
        let answer = Report::of(model(&input)).expect("a report").answer(3).of_file("in.json", "json");
        let certificate = answer.certificate(&[("in.json", &input)]).expect("the checker finds the same");
        let verdict = coface_check::check(certificate.as_bytes(), &[&input]).expect("it has been checked");
        prop_assert!(verdict.proved().len() >= 5 + answer.homology.len());
    }
}

/// A square of four triangles around its middle, of which two are the group `lid` and one is `rim`.
const FAN: &str = "v 0 0 0\nv 2 0 1\nv 2 2 2\nv 0 2 3\nv 1 1 4\ng lid\nf 1 2 5\nf 2 3 5\ng rim edge\nusemtl red\nf 3 4 5\ng\nf 4 1 5\n";

#[test]
fn groups_of_a_mesh_are_proved_and_lies_about_them_are_refused() {
    let bytes = FAN.as_bytes();
    let model = coface_io::read(bytes, coface_io::Format::Obj).expect("a mesh");
    let producer = Producer::of(model.clone()).expect("a complex");
    let certificate = |word: &str, is_image: bool| -> serde_json::Value {
        let part = Some(RelativeTo::Groups(vec![word.to_owned()]));
        let request = PersistenceRequest::new().min_persistence(-1.0);
        let request = if is_image { request.image_of(part) } else { request.relative(part) };
        let found = request.found_in("fan.obj", &producer, Some(&model)).expect("a diagram");
        let text = found.certificate(&[("fan.obj", bytes)]).expect("the checker accepts the proof");
        serde_json::from_str(&text).expect("JSON")
    };
    let verdict =
        |value: &serde_json::Value| coface_check_persistence::check(value.to_string().as_bytes(), &[bytes]);
    for is_image in [false, true] {
        let key = if is_image { "image_of" } else { "relative_to" };
        // Names behind g are found in the file; that of a material, or a list of both, is not looked for.
        for word in ["lid", "edge", "lid,rim"] {
            let found = verdict(&certificate(word, is_image)).expect("it has been checked");
            assert!(found.unchecked().is_empty(), "{word}: {:?}", found.unchecked());
            assert!(found.proved().iter().any(|line| line.contains(word)), "{:?}", found.proved());
        }
        for word in ["red", "lid,red"] {
            let found = verdict(&certificate(word, is_image)).expect("it has been checked");
            assert_eq!(found.unchecked(), [key], "{word}");
        }
        let honest = certificate("lid", is_image);
        let refused = |change: &dyn Fn(&mut serde_json::Value), part: &str| {
            let mut lie = honest.clone();
            change(&mut lie);
            let fault = verdict(&lie).expect_err("a lie").to_string();
            assert!(fault.contains(part), "{fault}");
        };
        refused(&|lie| lie["answer"][key] = "rim".into(), "not those of");
        refused(&|lie| lie["part_cells"] = serde_json::json!([[0, 1, 4]]), "not those of");
        refused(&|lie| lie["part_cells"] = serde_json::json!([[0, 1, 2]]), "relative");
        refused(&|lie| lie["part_cells"] = serde_json::json!(7), "facet list");
        refused(
            &|lie| drop(lie.as_object_mut().expect("an object").remove("part_cells")),
            "not those of such a part",
        );
        refused(&|lie| lie["part"] = "boundary".into(), "not those of such a part");
        refused(&|lie| lie["part"] = "file".into(), "not those of such a part");
        refused(&|lie| drop(lie["answer"]["diagram"].as_array_mut().expect("pairs").pop()), "answer");
    }
}

/// A polygon of WKT with an outer ring and perhaps a hole, of corners on a coarse grid or of any numbers: both cross themselves and each
/// other, and have edges in common.
fn polygon() -> impl Strategy<Value = String> {
    let coarse = (0i32..5, 0i32..5).prop_map(|(x, y)| format!("{x} {y}"));
    let fine = (-1.0f64..4.0, -1.0f64..4.0).prop_map(|(x, y)| format!("{x} {y}"));
    let ring = prop_oneof![prop::collection::vec(coarse, 3..7), prop::collection::vec(fine, 3..6)];
    let ring = ring.prop_map(|ring| format!("({}, {})", ring.join(", "), ring[0]));
    prop::collection::vec(ring, 1..3).prop_map(|rings| format!("POLYGON ({})", rings.join(", ")))
}

fn rule() -> impl Strategy<Value = Option<InsideRule>> {
    prop::option::of(prop::sample::select(vec![InsideRule::Nonzero, InsideRule::Odd, InsideRule::Positive]))
}

fn drawing(texts: &[String]) -> PlanarDrawing {
    let models = texts.iter().map(|text| coface_io::read(text.as_bytes(), coface_io::Format::Wkt));
    let models = models.collect::<Result<Vec<_>, _>>().expect("polygons");
    PlanarDrawing::new(models.iter().map(|model| ("in.wkt", model)), RegionSource::Models).expect("a drawing")
}

proptest! {
    /// Cells of the plane, what contains them and their areas, are what the checker finds by a sweep of its own.
    #[test]
    fn arrangements_are_proved(mut texts in prop::collection::vec(polygon(), 1..5), line in polygon(), rule in rule()) {
        texts.push(line.replace("POLYGON (", "MULTILINESTRING ("));
        let inputs: Vec<(&str, &[u8])> = texts.iter().map(|text| ("in.wkt", text.as_bytes())).collect();
        let mut request = ArrangementRequest::default();
        (request.rule, request.exact) = (rule, true);
        let found = DrawingArrangement::new(drawing(&texts), &request).expect("an arrangement");
        let certificate = found.certificate(&inputs).expect("the checker finds the same");
        let bytes: Vec<&[u8]> = inputs.iter().map(|input| input.1).collect();
        let verdict = coface_check_plane::check(certificate.as_bytes(), &bytes).expect("it has been checked");
        for key in ["f_vector", "inside", "measures", "holes", "components", "bridges", "dangling_edges"] {
            prop_assert!(!verdict.unchecked().iter().any(|unchecked| unchecked == key), "{}", key);
        }
    }

    /// Booleans by any formula and rule, many of which leave out what is inside, are faces of the arrangement of all segments.
    #[test]
    fn booleans_are_proved(
        texts in prop::collection::vec(polygon(), 3..6),
        formula in prop::sample::select(vec!["a | b | c", "a & b", "a - b - c", "a ^ b ^ c", "(a ^ b) & !c", "a - (b & c)"]),
        rule in rule(),
    ) {
        let inputs: Vec<(&str, &[u8])> = texts.iter().map(|text| ("in.wkt", text.as_bytes())).collect();
        let mut request = BooleanRequest::default();
        (request.rule, request.exact) = (rule, true);
        let formula = BooleanFormula::parse(formula, &[]).expect("a formula");
        let found = RegionBoolean::new(drawing(&texts), &formula, &request).expect("a Boolean");
        let certificate = found.certificate(&inputs).expect("the checker finds the same");
        let bytes: Vec<&[u8]> = inputs.iter().map(|input| input.1).collect();
        let verdict = coface_check_plane::check(certificate.as_bytes(), &bytes).expect("it has been checked");
        for key in ["measure", "measures", "components", "pinches"] {
            prop_assert!(!verdict.unchecked().iter().any(|unchecked| unchecked == key), "{}", key);
        }
    }
}

/// A box, turned and moved by multiples of an eighth, or a pyramid on a square, as OFF.
fn solid() -> impl Strategy<Value = String> {
    let turns = prop::sample::select(vec![[1.0, 0.0], [0.6, 0.8], [0.0, 1.0], [-0.28, 0.96]]);
    (turns, [-6i32..6, -6..6, -6..6], [1i32..8, 1..8, 1..8], any::<bool>()).prop_map(
        |([c, s], low, extent, is_box)| {
            let at = |i: usize| {
                let [x, y, z] =
                    [0, 1, 2].map(|axis| f64::from(low[axis] + extent[axis] * (i >> axis & 1) as i32) / 8.0);
                format!("{} {} {z}\n", c * x - s * y, s * x + c * y)
            };
            let faces = if is_box {
                "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n"
            } else {
                "4 0 2 3 1\n3 0 1 4\n3 1 3 4\n3 3 2 4\n3 2 0 4\n"
            };
            let count = if is_box { 8 } else { 5 };
            format!(
                "OFF\n{count} {} 0\n{}{faces}",
                faces.lines().count(),
                (0..count).map(at).collect::<String>()
            )
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    /// Solids with common planes, edges and corners, by any formula and rule: the checker finds the same volume by rays.
    #[test]
    fn booleans_of_solids_are_proved(
        texts in prop::collection::vec(solid(), 3),
        formula in prop::sample::select(vec!["a | b | c", "a & b", "a - b - c", "a ^ b ^ c", "(a ^ b) & !c", "a - (b & c)"]),
        rule in rule(),
    ) {
        let inputs: Vec<(&str, &[u8])> = texts.iter().map(|text| ("in.off", text.as_bytes())).collect();
        let models = texts.iter().map(|text| coface_io::read(text.as_bytes(), coface_io::Format::Off));
        let models = models.collect::<Result<Vec<_>, _>>().expect("solids");
        let named = models.iter().map(|model| ("in.off", model));
        let arranged = SceneArrangement::of(named, &SpatialRequest::default()).expect("an arrangement");
        let mut request = SolidRequest::of(BooleanFormula::parse(formula, &[]).expect("a formula"));
        request.rule = rule.unwrap_or_default();
        let found = SolidBoolean::of(&arranged, &request).expect("a Boolean");
        let bytes: Vec<&[u8]> = inputs.iter().map(|input| input.1).collect();
        if let Ok(certificate) = arranged.certificate(request.rule, &inputs) {
            let verdict = coface_check_space::check(certificate.as_bytes(), &bytes).expect("it has been checked");
            for key in ["measures", "inside", "voids"] {
                prop_assert!(!verdict.unchecked().iter().any(|unchecked| unchecked == key), "{}", key);
            }
        }
        match found.certificate(&inputs) {
            Ok(certificate) => {
                let verdict = coface_check_space::check(certificate.as_bytes(), &bytes).expect("it has been checked");
                prop_assert!(!verdict.unchecked().iter().any(|unchecked| unchecked == "measure"));
            }
            // Turned boxes have sides that are not flat in doubles, which are split; the checker takes none of these.
            Err(error) => prop_assert!(error.message().contains("lie in no plane"), "{error}"),
        }
    }
}
