//! Certificates of random complexes are accepted by the checker, which shares no code with what made them.

use coface_answers::{HomologyRequest, RelativeTo, Report};
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
