//! Cycles of images against the diagram without them, and against the boundary.

use coface_algebra::CellId;
use coface_answers::{GreyImage, ImageRequest};
use coface_io::VolumeReading;
use coface_topology::{Coefficients, ImageConstruction};
use proptest::prelude::*;

#[derive(Clone, Debug)]
struct Case {
    shape: Vec<usize>,
    numbers: Vec<f64>,
    is_periodic: Vec<bool>,
    is_v: bool,
    is_superlevel: bool,
    prime: u64,
}

fn cases() -> impl Strategy<Value = Case> {
    let shape = prop_oneof![
        prop::collection::vec(1..6_usize, 1..=2),
        prop::collection::vec(1..4_usize, 3),
        Just(vec![2, 2, 3, 2]),
    ];
    let rest = |shape: Vec<usize>| {
        let count = shape.iter().product::<usize>();
        let number = prop_oneof![8 => (-3..4_i32).prop_map(f64::from), 1 => Just(f64::NAN)];
        let periodic = prop::collection::vec(any::<bool>(), shape.len());
        let numbers = prop::collection::vec(number, count);
        (Just(shape), numbers, periodic, any::<bool>(), any::<bool>(), prop_oneof![Just(2_u64), Just(3)])
    };
    shape.prop_flat_map(rest).prop_map(|(shape, numbers, periodic, is_v, is_superlevel, prime)| {
        // A cube around an axis of two voxels has an end twice.
        let is_periodic = shape.iter().zip(periodic).map(|(&length, wanted)| wanted && length != 2).collect();
        Case { shape, numbers, is_periodic, is_v, is_superlevel, prime }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn classes_are_the_same_and_cycles_are_born_and_die_when_they_say(case in cases()) {
        let image = GreyImage::new(&case.shape, case.numbers.iter().copied()).unwrap();
        let mut reading = VolumeReading::default();
        reading.periodic[..case.shape.len()].copy_from_slice(&case.is_periodic);
        let construction =
            if case.is_v { ImageConstruction::Vertices } else { ImageConstruction::TopCells };
        let request = ImageRequest::new()
            .coefficients(Coefficients::Modulo(case.prime))
            .construction(construction)
            .superlevel(case.is_superlevel)
            .periodic(reading);
        let plain = request.found("image", image.clone()).unwrap().answer();
        let cells = request.cells("image", image).unwrap();
        let (complex, filtration) = cells.complex().unwrap();
        let found = cells.found().unwrap();
        let told = found.answer();
        let classes = |answer: &coface_answers::answer::PersistenceAnswer| -> Vec<_> {
            let row = |pair: &coface_answers::answer::PersistencePairAnswer| {
                (pair.degree, pair.birth, pair.death, pair.birth_cell.clone(), pair.death_cell.clone())
            };
            answer.diagram.iter().map(row).collect()
        };
        prop_assert_eq!(classes(&plain), classes(&told));
        let rank = |degree: usize, cell: CellId| cells.cell(degree, cell).unwrap().1;
        let p = case.prime as i64;
        let is_zero = |x: &coface_algebra::Integer| x.to_i64().unwrap() % p == 0;
        for (class, told) in found.cycles().iter().zip(&told.diagram) {
            let (pair, degree) = (class.pair(), class.pair().degree());
            let cycle = cells.chain(degree, degree, class.cycle()).unwrap();
            prop_assert!(complex.boundary(&cycle).unwrap().terms().iter().all(|(_, x)| is_zero(x)));
            let latest = cycle.terms().iter().map(|&(cell, _)| rank(degree, cell)).max().unwrap();
            let values = filtration.values(degree);
            let born = cycle.terms().iter().find(|&&(cell, _)| rank(degree, cell) == latest).unwrap().0;
            prop_assert_eq!(values[born.index()], pair.birth());
            // The answer has the vertices of the cells.
            let vertices = |degree: usize, terms: &[(CellId, coface_algebra::Integer)]| -> Vec<(i64, Vec<u64>)> {
                let of_cell = |cell: CellId| cells.cell(degree, cell).unwrap().0.into_iter().map(u64::from).collect();
                let mut terms: Vec<_> = terms.iter().map(|(cell, x)| (x.to_i64().unwrap(), of_cell(*cell))).collect();
                terms.sort();
                terms
            };
            let plain = |terms: &Option<Vec<coface_answers::answer::ChainTerm>>| -> Vec<(i64, Vec<u64>)> {
                let number = |x: &coface_answers::answer::WholeNumber| match x {
                    coface_answers::answer::WholeNumber::Number(x) => *x,
                    coface_answers::answer::WholeNumber::Digits(_) => panic!("small coefficients"),
                };
                let mut terms: Vec<_> = terms.iter().flatten().map(|(x, vertices)| (number(x), vertices.clone())).collect();
                terms.sort();
                terms
            };
            prop_assert_eq!(plain(&told.cycle), vertices(degree, cycle.terms()));
            let cocycle = cells.chain(degree, degree, class.cocycle()).unwrap();
            prop_assert_eq!(plain(&told.cocycle), vertices(degree, cocycle.terms()));
            let Some(filling) = class.bounding_chain() else {
                prop_assert!(pair.death().is_none());
                continue;
            };
            let filling = cells.chain(degree, degree + 1, filling).unwrap();
            prop_assert_eq!(plain(&told.bounding_chain), vertices(degree + 1, filling.terms()));
            let rest = complex.boundary(&filling).unwrap().minus(&cycle).unwrap();
            prop_assert!(rest.terms().iter().all(|(_, x)| is_zero(x)));
        }
        prop_assert_eq!(found.torsion_primes(), coface_topology::torsion_primes(&complex, &filtration).unwrap());
    }
}

/// An image whose first axis runs fastest has its axes the other way round in the library: boundaries are right all the same, over three elements too.
#[test]
fn cubes_of_a_file_whose_first_axis_runs_fastest_are_turned() {
    use coface_io::{Format, VolumeStream};
    let numbers: Vec<String> = (0..60_u32).map(|i| (i * 37 % 23).to_string()).collect();
    let text = format!(
        "NRRD0004\ntype: double\ndimension: 3\nsizes: 3 4 5\nencoding: ascii\n\n{}",
        numbers.join(" ")
    );
    for construction in [ImageConstruction::Vertices, ImageConstruction::TopCells] {
        let image = GreyImage::read(VolumeStream::new(text.as_bytes(), Format::Nrrd).unwrap()).unwrap().0;
        let request = ImageRequest::new().coefficients(Coefficients::Modulo(3)).construction(construction);
        let cells = request.cells("image", image).unwrap();
        let (complex, _) = cells.complex().unwrap();
        let found = cells.found().unwrap();
        for class in found.cycles() {
            let degree = class.pair().degree();
            let cycle = cells.chain(degree, degree, class.cycle()).unwrap();
            let is_zero = |x: &coface_algebra::Integer| x.to_i64().unwrap() % 3 == 0;
            assert!(
                complex.boundary(&cycle).unwrap().terms().iter().all(|(_, x)| is_zero(x)),
                "{construction}"
            );
            if let Some(filling) = class.bounding_chain() {
                let filling = cells.chain(degree, degree + 1, filling).unwrap();
                let rest = complex.boundary(&filling).unwrap().minus(&cycle).unwrap();
                assert!(rest.terms().iter().all(|(_, x)| is_zero(x)), "{construction}, degree {degree}");
            }
        }
    }
}

/// A ring around a hole whose pixels lie in the order of the file that runs first along its first axis.
#[test]
fn a_file_whose_first_axis_runs_fastest_keeps_its_axes() {
    use coface_io::{Format, VolumeStream};
    let header = "NRRD0004\ntype: double\ndimension: 3\nsizes: 3 3 1\nspacings: 2 3 5\nencoding: ascii\n\n";
    let text = format!("{header}1 1 1 1 9 1 1 1 1");
    let read = || GreyImage::read(VolumeStream::new(text.as_bytes(), Format::Nrrd).unwrap()).unwrap().0;
    let cells = ImageRequest::new().cells("ring", read()).unwrap();
    let flat = cells.producer().unwrap().positions().as_flat();
    let high = [0, 1, 2].map(|axis| flat.iter().skip(axis).step_by(3).copied().fold(0.0, f64::max));
    assert_eq!(high, [6.0, 9.0, 5.0], "three voxels of 2 x 3 x 5");
    let cells = ImageRequest::new().construction(ImageConstruction::Vertices).cells("ring", read()).unwrap();
    let positions = cells.producer().unwrap().positions().as_flat();
    assert_eq!(&positions[..3], [1.0, 1.5, 2.5], "the center of the first voxel");
    assert_eq!(positions.len(), 27, "a vertex for each voxel");
}

/// Where voxels are the vertices they have the numbers of vertices, also along axes of one voxel.
#[test]
fn vertices_are_voxels() {
    for shape in [&[4, 1][..], &[1, 4], &[1, 1], &[2, 1, 3], &[1, 2, 1, 2]] {
        let count = shape.iter().product::<usize>();
        let image = GreyImage::new(shape, (0..count).map(|number| number as f64)).unwrap();
        let cells =
            ImageRequest::new().construction(ImageConstruction::Vertices).cells("image", image).unwrap();
        let (complex, filtration) = cells.complex().unwrap();
        assert_eq!(complex.cell_count(0), count, "{shape:?}");
        for vertex in 0..count {
            assert_eq!(cells.cell(0, CellId::new(vertex)).unwrap().0, [vertex as u32]);
            assert_eq!(filtration.values(0)[vertex], vertex as f64);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// The picture that is made of the cubes of chains alone is that of the volume with all its cubes.
    #[test]
    fn pictures_are_those_of_all_cubes(case in cases()) {
        let numbers = case.numbers.iter().map(|x| if x.is_nan() { 0.0 } else { *x });
        let image = GreyImage::new(&case.shape, numbers).unwrap();
        let construction =
            if case.is_v { ImageConstruction::Vertices } else { ImageConstruction::TopCells };
        let request = ImageRequest::new().construction(construction).superlevel(case.is_superlevel);
        let cells = request.coefficients(Coefficients::Modulo(case.prime)).cells("image", image).unwrap();
        let found = cells.found().unwrap();
        let mut chains = Vec::new();
        for class in found.cycles() {
            let degree = class.pair().degree();
            let chain = |of: usize, terms: &[(u64, i64)]| cells.chain(degree, of, terms).unwrap();
            chains.push((degree.to_string(), chain(degree, class.cycle())));
            if let Some(filling) = class.bounding_chain() {
                chains.push(("filling".to_owned(), chain(degree + 1, filling)));
            }
        }
        let is_single = case.is_v && case.shape.iter().all(|&length| length == 1);
        match (found.cycles_model(), cells.producer().unwrap().picture(&chains)) {
            (Ok(model), Ok(whole)) => {
                prop_assert_eq!(model.positions(), whole.positions());
                prop_assert_eq!(model.lines(), whole.lines());
                prop_assert_eq!(model.polygons(), whole.polygons());
                prop_assert_eq!(model.cells(), whole.cells());
                let members = |model: &coface_io::Model| -> Vec<Vec<u32>> {
                    model.groups().iter().map(|group| group.members().to_vec()).collect()
                };
                prop_assert_eq!(members(&model), members(&whole));
            }
            (model, whole) => prop_assert!(is_single || model.is_err() && whole.is_err()),
        }
    }
}

/// A cavity is bounded by voxels, which are hexahedra around their bottoms and tops.
#[test]
fn cavities_are_drawn_as_hexahedra() {
    let numbers = |side: usize| {
        let last = side - 1;
        (0..side * side * side).map(move |place| {
            let at = [place / (side * side), place / side % side, place % side];
            let inside = at.iter().all(|&x| 0 < x && x < last);
            if inside { 9.0 } else { 1.0 }
        })
    };
    for (construction, side, volume) in
        [(ImageConstruction::TopCells, 4, 8.0), (ImageConstruction::Vertices, 4, 27.0)]
    {
        let image = GreyImage::new(&[side; 3], numbers(side)).unwrap();
        let cells = ImageRequest::new().construction(construction).cells("box", image).unwrap();
        let model = cells.found().unwrap().cycles_model().unwrap();
        assert!(model.groups().iter().any(|group| group.name() == "filling_H2_0"), "{:?}", model.groups());
        // Each voxel is turned as its corners say: volumes add up.
        let total: f64 = model
            .cells()
            .iter()
            .map(|cell| {
                let at = |corner: usize| {
                    model.positions().point(coface_algebra::VertexId::new(cell[corner] as usize))
                };
                let edge = |to: usize| [0, 1, 2].map(|axis| at(to)[axis] - at(0)[axis]);
                let [a, b, c] = [edge(1), edge(3), edge(4)];
                a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                    + a[2] * (b[0] * c[1] - b[1] * c[0])
            })
            .sum();
        assert!(total >= volume && total <= f64::from(side as u32).powi(3), "{total}");
        let used = model.cells().items().iter().chain(model.polygons().items()).max().copied();
        assert!(used < Some(model.vertex_count() as u32), "no vertex is there that nothing uses");
    }
}
