//! Diagrams of points are what the cochains of their certificates prove, with apparent pairs and clearing or without; those of images what chains of all their cubes prove.

use coface_answers::{GreyImage, ImageRequest, PersistenceRequest, PointFiltration, RipsRequest};
use coface_io::{AlphaReading, CechReading, FlagReading, Format, NumberTable, TableForm, VolumeStream};
use coface_topology::{Coefficients, ImageConstruction};
use proptest::prelude::*;

fn text(points: &[Vec<i32>]) -> Vec<u8> {
    let row = |point: &Vec<i32>| point.iter().map(i32::to_string).collect::<Vec<_>>().join(" ") + "\n";
    points.iter().map(row).collect::<String>().into_bytes()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// On a lattice many distances are equal, and points repeat.
    #[test]
    fn diagrams_of_points_are_proved(
        points in prop::collection::vec(prop::collection::vec(0i32..4, 3), 1..14),
        (prime, dimension) in (prop::sample::select(vec![2u64, 3, 5, 2_147_483_647]), 0usize..4),
        threshold in prop::option::of(0i32..4),
        least in 0i32..2,
    ) {
        let input = text(&points);
        let distances = TableForm::Points.distances(&NumberTable::read(&input[..]).expect("numbers")).expect("points");
        let request = RipsRequest::new()
            .coefficients(Coefficients::Modulo(prime))
            .dimension(dimension)
            .threshold(threshold.map(f64::from))
            .min_persistence(f64::from(least));
        let found = request.found("in.csv", &distances).expect("points have a diagram");
        let certificate = found.certificate(&[("in.csv", &input)]).expect("the checker accepts the proof");
        let verdict = coface_check_walks::check(certificate.as_bytes(), &[&input]).expect("it has been checked");
        prop_assert!(verdict.unchecked().is_empty(), "{:?}", verdict);
        prop_assert_eq!(verdict.proved().len(), 3 + dimension + 1);
    }

    /// Complexes that are listed.
    #[test]
    fn diagrams_of_listed_simplices_are_proved(
        points in prop::collection::btree_set(prop::collection::vec(0i32..6, 2), 1..12),
        prime in prop::sample::select(vec![2u64, 3]),
    ) {
        let points: Vec<Vec<i32>> = points.into_iter().collect();
        let input = text(&points);
        let table = NumberTable::read(&input[..]).expect("numbers");
        let request = PersistenceRequest::new().coefficients(Coefficients::Modulo(prime));
        let alpha = PointFiltration::of_alpha(AlphaReading::default().points(&table).expect("points"), false);
        let cech = CechReading { dimension: Some(2), ..CechReading::default() };
        let cech = PointFiltration::of_cech(cech.points(&table).expect("points"));
        for (points, request, is_alpha) in [(alpha, request.clone(), true), (cech, request.up_to_degree(1), false)] {
            let found = request.growth(points.growth()).found("in.csv", points.producer()).expect("a diagram");
            let certificate = found.certificate_of_points(&[("in.csv", &input)]).expect("the checker accepts the proof");
            let verdict = coface_check_walks::check(certificate.as_bytes(), &[&input]).expect("it has been checked");
            // Of points on a line there are no triangles.
            let is_flat = found.answer().betti.len() < 3;
            prop_assert_eq!(verdict.unchecked().is_empty(), is_alpha && !is_flat, "{:?}", verdict);
        }
    }
}

/// An array of NumPy of doubles.
fn array(shape: &[usize], numbers: &[f64]) -> Vec<u8> {
    let shape: String = shape.iter().map(|length| format!("{length}, ")).collect();
    let mut header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({shape}), }}");
    while (header.len() + 11) % 64 != 0 {
        header.push(' ');
    }
    header.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    bytes
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    /// Of one to four axes, with equal values and voxels that are not there.
    #[test]
    fn diagrams_of_images_are_proved(
        shape in prop::collection::vec(1usize..5, 1..5),
        numbers in prop::collection::vec(-1i32..5, 256),
        (prime, are_vertices, is_superlevel) in (prop::sample::select(vec![2u64, 3]), prop::bool::ANY, prop::bool::ANY),
        least in 0i32..2,
    ) {
        let count: usize = shape.iter().product();
        let number = |&number: &i32| if number < 0 { f64::NAN } else { f64::from(number) };
        let mut numbers: Vec<f64> = numbers[..count].iter().map(number).collect();
        // One is there.
        numbers[0] = 2.0;
        let input = array(&shape, &numbers);
        let (image, _) = GreyImage::read(VolumeStream::new(&input[..], Format::Npy).expect("an array")).expect("numbers");
        let construction = if are_vertices { ImageConstruction::Vertices } else { ImageConstruction::TopCells };
        let request = ImageRequest::new()
            .coefficients(Coefficients::Modulo(prime))
            .construction(construction)
            .superlevel(is_superlevel)
            .min_persistence(f64::from(least));
        let found = request.found("in.npy", image).expect("an image has a diagram");
        let certificate = found.certificate(&[("in.npy", &input)]).expect("the checker accepts the proof");
        let verdict = coface_check_walks::check(certificate.as_bytes(), &[&input]).expect("it has been checked");
        prop_assert!(verdict.unchecked().is_empty(), "{:?}", verdict);
    }
}

#[test]
fn flag_complexes_list_their_simplices() {
    let input = &b"2 3\n3 5\n5 9\n9 2\n2 5 4\n"[..];
    let found = RipsRequest::new()
        .found_of_graph("graph.txt", &FlagReading::default().graph(input).expect("a graph"));
    let found = found.expect("a diagram");
    let inputs = [("graph.txt", input)];
    assert!(
        found
            .certificate(&inputs)
            .expect_err("it is no complex of points")
            .message()
            .contains("points of one input")
    );
    let (points, request) = found.with_simplices(Default::default()).expect("few simplices");
    let found = request.found("graph.txt", points.producer()).expect("a diagram");
    let certificate = found.certificate_of_points(&inputs).expect("the checker accepts the proof");
    let verdict = coface_check_walks::check(certificate.as_bytes(), &[input]).expect("it has been checked");
    assert_eq!(verdict.unchecked(), ["function", "threshold", "that these are the simplices of the input"]);
}
