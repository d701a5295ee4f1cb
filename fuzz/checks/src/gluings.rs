//! Gluing tables: spaces of a few simplices.

use crate::models::{check_model, check_round};
use arbitrary::{Arbitrary, Unstructured};
use coface::algebra::Permutation;
use coface::complexes::gluing::GluingTable;
use coface::io::{Format, Structure};
use coface::topology::gluing_manifold_verdict;
use coface::{Model, homology};

/// Simplices and the gluings that are tried on them.
#[derive(Arbitrary, Debug)]
struct Plan {
    dimension: u8,
    count: u8,
    gluings: Vec<(u8, u8, u8, [u8; 6])>,
    relabeling: [u8; 8],
}

/// Glues facets of simplices of dimension 1 to 4 as bytes say. Then:
///
/// * the table is written and read as JSON, and as a signature if it can be;
/// * with other numbers for simplices and vertices it has the same counts, groups, verdict and signature;
/// * its barycentric subdivision has the same groups.
pub fn glue_simplices(bytes: &[u8]) {
    let Ok(plan) = Plan::arbitrary(&mut Unstructured::new(bytes)) else { return };
    let dimension = 1 + usize::from(plan.dimension) % 4;
    let count = 1 + usize::from(plan.count) % [6, 5, 3, 1][dimension - 1];
    let mut table = GluingTable::unglued(dimension, count).expect("few simplices");
    for &(simplex, facet, neighbor, choices) in plan.gluings.iter().take(32) {
        let images = permutation(dimension + 1, &choices);
        let before = table.clone();
        let [simplex, facet] = [usize::from(simplex) % count, usize::from(facet) % (dimension + 1)];
        if table.glue(simplex, facet, usize::from(neighbor) % count, &images).is_err() {
            assert!(table == before, "what is refused changes nothing");
        }
        table.check().expect("gluing keeps the table sound");
    }
    let model = Model::from_structure(Structure::Gluings(table.clone()));
    check_model(&model);
    check_round(&model, Format::Json);
    let faces = table.faces().expect("few faces");
    let signature = table.isomorphism_signature();
    if let Ok(signature) = &signature {
        let again =
            GluingTable::from_isomorphism_signature(signature, dimension).expect("what is written is read");
        assert_eq!(again.isomorphism_signature().as_ref(), Ok(signature));
        assert_eq!(again.faces().expect("few faces").class_counts(), faces.class_counts());
    }
    let simplices = Permutation::from_images(permutation(count, &plan.relabeling)).expect("a permutation");
    let turned = permutation(dimension + 1, &plan.relabeling[2..]);
    let vertices = vec![Permutation::from_images(turned).expect("a permutation"); count];
    let relabeled = table.relabeled(&simplices, &vertices).expect("permutations of the right sizes");
    assert_eq!(
        relabeled.isomorphism_signature().ok(),
        signature.ok(),
        "a signature does not depend on numbers"
    );
    let relabeled_faces = relabeled.faces().expect("few faces");
    assert_eq!(relabeled_faces.class_counts(), faces.class_counts());
    let verdicts = [(&table, &faces), (&relabeled, &relabeled_faces)].map(|(table, faces)| {
        gluing_manifold_verdict(table, faces).map(|verdict| format!("{:?}", verdict.is_manifold()))
    });
    assert_eq!(verdicts[0].is_ok(), verdicts[1].is_ok());
    if let [Ok(first), Ok(second)] = &verdicts {
        assert_eq!(first, second, "the verdict does not depend on numbers");
    }
    let subdivision = faces.barycentric_subdivision().expect("few cells");
    let fine = homology(&subdivision.complex().chain_complex().expect("a complex"));
    if let Ok(complex) = faces.chain_complex() {
        let groups = homology(&complex);
        assert_eq!(groups.groups(), fine.groups(), "subdivision keeps homology");
        let relabeled = homology(&relabeled_faces.chain_complex().expect("a complex as before"));
        assert_eq!(groups.groups(), relabeled.groups(), "homology does not depend on numbers");
        assert_eq!(groups.euler_characteristic(), complex.euler_characteristic());
    }
}

/// The permutation that bytes choose by swaps.
fn permutation(count: usize, choices: &[u8]) -> Vec<u32> {
    let mut images: Vec<u32> = (0..count as u32).collect();
    for (i, &choice) in choices.iter().enumerate().take(count) {
        images.swap(i, i + usize::from(choice) % (count - i));
    }
    images
}
