//! Manifold verdicts of reports: every fault with its places, and what is proved above dimension 3.

use coface_algebra::RaggedArray;
use coface_answers::{Answer, ProblemKind, Report, ReportRequest};
use coface_complexes::known_spaces::{self, Solid, glued_solid};
use coface_complexes::simplicial::SimplicialComplex;
use coface_io::{Model, Structure};

fn report(facets: &[Vec<u32>]) -> Report {
    Report::of(Model::from_structure(Structure::Facets(RaggedArray::from_lists(facets))))
        .expect("facets have a report")
}

fn of_complex(complex: &SimplicialComplex) -> Report {
    report(&complex.facets().iter().map(|facet| facet.numbers().to_vec()).collect::<Vec<_>>())
}

fn counts(report: &Report) -> Vec<(ProblemKind, usize)> {
    report.problems().iter().map(|problem| (problem.kind(), problem.count())).collect()
}

/// A facet of lower dimension makes a complex impure, and an impure complex is no manifold.
#[test]
fn impure_complexes_are_no_manifolds() {
    for (facets, cells, rest) in [
        (vec![vec![0, 1, 2], vec![5]], vec![5], "without that facet it is a manifold"),
        (vec![vec![0, 1], vec![1, 2], vec![7], vec![8]], vec![7], "without such facets it is a manifold"),
        (vec![vec![0, 1, 2], vec![2, 5]], vec![2, 5], "without that facet it is a manifold"),
        (vec![vec![0, 1, 2, 3], vec![9]], vec![9], "without such simplices it is a manifold"),
        (vec![vec![0, 1, 2, 3], vec![3, 4, 5]], vec![3, 4, 5], "without such simplices it is a manifold"),
    ] {
        let report = report(&facets);
        let witness = report.witness().expect("no has a witness");
        assert_eq!((report.is_pure(), report.manifold()), (Some(false), Answer::No), "{facets:?}");
        assert_eq!((witness.kind(), &witness.cells()[0]), ("not_pure", &cells), "{facets:?}");
        assert!(witness.message().contains(rest), "{}", witness.message());
    }
}

#[test]
fn every_fault_has_its_places_in_every_dimension() {
    let report = report(&[
        vec![0, 1, 2, 3],
        vec![0, 1, 2, 4],
        vec![0, 1, 2, 5],
        vec![3, 10, 11, 12],
        vec![10, 11, 13, 14],
        vec![20, 21],
        vec![30],
    ]);
    assert_eq!(
        counts(&report),
        [
            (ProblemKind::LooseCell, 1),
            (ProblemKind::NonManifoldRidge, 1),
            (ProblemKind::NonManifoldEdge, 1),
            (ProblemKind::NonManifoldVertex, 3),
            (ProblemKind::IsolatedVertex, 1),
        ]
    );
    let places: Vec<&[u32]> = report.problems().iter().map(|problem| problem.cells().list(0)).collect();
    assert_eq!(places, [&[20, 21][..], &[0, 1, 2], &[10, 11], &[3], &[30]]);
}

/// The link of an apex over the Poincare sphere has the homology of a sphere and another group.
#[test]
fn cones_and_suspensions_of_the_poincare_sphere_are_no_manifolds() {
    let poincare = glued_solid(Solid::Dodecahedron, 2).unwrap();
    assert_eq!(of_complex(&poincare).manifold(), Answer::Yes);
    for complex in [poincare.cone().unwrap().0, poincare.suspension().unwrap().0] {
        let report = of_complex(&complex);
        assert_eq!(report.manifold(), Answer::No);
        assert_eq!(report.witness().unwrap().kind(), "link_not_simply_connected");
    }
}

#[test]
fn products_and_joins_of_spheres_are_manifolds_by_proof() {
    for complex in [
        known_spaces::complex_projective_plane().unwrap(),
        known_spaces::cross_polytope_boundary(6).unwrap(),
        known_spaces::simplex(17).unwrap(),
    ] {
        assert_eq!(of_complex(&complex).manifold(), Answer::Yes);
    }
}

#[test]
fn a_full_verdict_is_that_of_the_usual_effort_on_small_complexes() {
    let facets = RaggedArray::from_lists([[0, 1, 2, 3, 4], [1, 2, 3, 4, 5]]);
    let model = || Model::from_structure(Structure::Facets(facets.clone()));
    let full = Report::answering(model(), &ReportRequest::new().full_verdict(true)).unwrap();
    assert_eq!(full.manifold(), Report::of(model()).unwrap().manifold());
}

/// A surface split at its seams has vertices at one place: they are counted, by the positions of the boundary alone.
#[test]
fn open_seams_are_told() {
    use coface_io::{Format, RemarkCode, read};
    let seams = |text: &str| {
        let report =
            Report::of(read(text.as_bytes(), Format::Off).expect("it is a mesh")).expect("it has a report");
        let counts: Vec<u64> = report
            .remarks()
            .iter()
            .filter(|remark| remark.code == RemarkCode::CoincidentVertices)
            .map(|remark| remark.count)
            .collect();
        counts
    };
    let halves = "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n1 1 0\n-0.0 1 0\n3 0 1 2\n3 3 4 5\n";
    assert_eq!(seams(halves), [2]);
    assert!(
        seams(&halves.replace("-0.0 1 0", "1e-300 1 0").replace("\n1 0 0\n1 1", "\n1.5 0 0\n1 1")).is_empty()
    );
    let joined = "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n";
    assert!(seams(joined).is_empty());
    // Closed surfaces that touch at a vertex have no seam.
    let faces = |at: u32| {
        format!(
            "3 {at} {} {}\n3 {at} {} {}\n3 {} {} {}\n3 {} {at} {}\n",
            at + 2,
            at + 1,
            at + 1,
            at + 3,
            at + 1,
            at + 2,
            at + 3,
            at + 2,
            at + 3
        )
    };
    let touching = format!(
        "OFF\n8 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 0\n-1 0 0\n0 -1 0\n0 0 -1\n{}{}",
        faces(0),
        faces(4)
    );
    assert!(seams(&touching).is_empty());
}
