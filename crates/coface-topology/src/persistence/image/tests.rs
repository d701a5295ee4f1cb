//! Persistence of images against the reduction of the whole complex, and dualities.

use super::*;
use crate::homology::Coefficients;
use crate::persistence::{Filtration, persistence};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{ErrorKind, SparseMatrix};
use proptest::prelude::*;

#[derive(Clone, Debug)]
pub(super) struct Image {
    pub(super) shape: Vec<usize>,
    pub(super) is_periodic: Vec<bool>,
    pub(super) numbers: Vec<f64>,
}

impl Image {
    pub(super) fn filtration(&self) -> ImageFiltration {
        let image = ImageFiltration::new(&self.shape, self.numbers.iter().copied()).unwrap();
        image.periodic(&self.is_periodic).unwrap()
    }
}

/// Points off the diagonal, as text that can be sorted.
type Points = Vec<(usize, String)>;

fn points(diagram: &ImageDiagram) -> Points {
    let point = |pair: &ImagePair| (pair.degree(), format!("{:?} {:?}", pair.birth(), pair.death()));
    let mut points: Points = diagram.pairs().iter().map(point).collect();
    points.sort();
    points
}

/// The second method: all cells in doubled coordinates, with the extreme value of the voxels in them or around them, reduced as any complex.
fn by_the_whole_complex(image: &Image, is_v: bool, p: u64) -> Points {
    let axes = image.shape.len();
    let lengths: Vec<usize> = image
        .shape
        .iter()
        .zip(&image.is_periodic)
        .map(|(&length, &is_periodic)| match (is_periodic, is_v) {
            (true, _) => 2 * length,
            (false, true) => 2 * length - 1,
            (false, false) => 2 * length + 1,
        })
        .collect();
    let total: usize = lengths.iter().product();
    let at = |mut index: usize| -> Vec<usize> {
        let digits = lengths.iter().map(|&length| {
            let digit = index % length;
            index /= length;
            digit
        });
        digits.collect()
    };
    let index =
        |cell: &[usize]| cell.iter().zip(&lengths).rev().fold(0, |index, (&x, &length)| index * length + x);
    // The voxels that a cell has to do with, along an axis.
    let beside = |axis: usize, x: usize| -> Vec<usize> {
        let length = image.shape[axis];
        let voxels: Vec<usize> = match (is_v, x.is_multiple_of(2)) {
            (true, true) => vec![x / 2],
            (true, false) => vec![x / 2, x / 2 + 1],
            (false, false) => vec![x / 2],
            (false, true) => vec![(x / 2).wrapping_sub(1), x / 2],
        };
        let is_periodic = image.is_periodic[axis];
        let wrapped = voxels.into_iter().map(|x| match x {
            usize::MAX if is_periodic => length - 1,
            x if is_periodic => x % length,
            x => x,
        });
        wrapped.filter(|&x| x < length).collect()
    };
    let value = |cell: &[usize]| -> f64 {
        let mut voxels = vec![0];
        for (axis, &x) in cell.iter().enumerate() {
            let along = beside(axis, x);
            voxels =
                voxels.iter().flat_map(|&v| along.iter().map(move |&x| v * image.shape[axis] + x)).collect();
        }
        let numbers = voxels.iter().map(|&voxel| image.numbers[voxel]);
        let numbers = numbers.map(|x| if x.is_nan() { f64::INFINITY } else { x });
        if is_v { numbers.fold(f64::NEG_INFINITY, f64::max) } else { numbers.fold(f64::INFINITY, f64::min) }
    };
    let mut numbers = vec![usize::MAX; total];
    let mut levels: Vec<Vec<Vec<usize>>> = vec![Vec::new(); axes + 1];
    for (place, number) in numbers.iter_mut().enumerate() {
        let cell = at(place);
        if value(&cell).is_finite() {
            let degree = cell.iter().filter(|&&x| x % 2 == 1).count();
            *number = levels[degree].len();
            levels[degree].push(cell);
        }
    }
    if levels[0].is_empty() {
        return Vec::new();
    }
    while levels.len() > 1 && levels.last().unwrap().is_empty() {
        levels.pop();
    }
    let matrices = levels.windows(2).map(|two| {
        let entries = two[1].iter().enumerate().flat_map(|(column, cell)| {
            let along: Vec<usize> = (0..axes).filter(|&axis| cell[axis] % 2 == 1).collect();
            let mut entries = Vec::new();
            for (place, &axis) in along.iter().enumerate() {
                for (x, sign) in [(cell[axis] - 1, -1i64), ((cell[axis] + 1) % lengths[axis], 1)] {
                    let mut face = cell.clone();
                    face[axis] = x;
                    entries.push((numbers[index(&face)], column, if place % 2 == 0 { sign } else { -sign }));
                }
            }
            entries
        });
        SparseMatrix::from_entries(two[0].len(), two[1].len(), entries).unwrap()
    });
    let matrices: Vec<SparseMatrix> = matrices.collect();
    let complex = if matrices.is_empty() {
        ChainComplex::of_points(levels[0].len())
    } else {
        ChainComplex::new(matrices).unwrap()
    };
    let values = levels.iter().map(|level| level.iter().map(|cell| value(cell)).collect()).collect();
    let filtration = Filtration::new(&complex, values).unwrap();
    let diagram = persistence(&complex, &filtration, Coefficients::Modulo(p)).unwrap().longer_than(0.0);
    let point = |pair: &crate::persistence::PersistencePair| {
        (pair.degree(), format!("{:?} {:?}", pair.birth(), pair.death()))
    };
    let mut found: Points = diagram.pairs().iter().map(point).collect();
    found.sort();
    found
}

fn shapes() -> impl Strategy<Value = Vec<usize>> {
    prop_oneof![
        prop::collection::vec(1usize..30, 1),
        prop::collection::vec(1usize..9, 2),
        prop::collection::vec(1usize..6, 3),
        prop::collection::vec(1usize..4, 4),
    ]
}

/// Small images with many ties, some voxels outside, some axes periodic.
pub(super) fn images() -> impl Strategy<Value = Image> {
    (
        shapes(),
        any::<[bool; 4]>(),
        prop::sample::select(vec![2i32, 9, 1000]),
        prop::sample::select(vec![0u8, 30, 120]),
    )
        .prop_flat_map(|(shape, periodic, most, missing)| {
            let count: usize = shape.iter().product();
            let is_periodic: Vec<bool> = periodic.into_iter().take(shape.len()).collect();
            prop::collection::vec((0..most, any::<u8>()), count).prop_map(move |numbers| {
                let number = |(x, lot): (i32, u8)| if lot < missing { f64::NAN } else { f64::from(x) - 3.0 };
                let numbers = numbers.into_iter().map(number).collect();
                Image { shape: shape.clone(), is_periodic: is_periodic.clone(), numbers }
            })
        })
}

pub(super) fn modulo(p: u64) -> Coefficients {
    Coefficients::Modulo(p)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    #[test]
    fn pairs_are_those_of_the_whole_complex(image in images(), p in prop::sample::select(vec![2u64, 3, 5])) {
        for construction in [ImageConstruction::Vertices, ImageConstruction::TopCells] {
            let diagram = image.filtration().construction(construction).persistence(modulo(p)).unwrap();
            let is_v = construction == ImageConstruction::Vertices;
            prop_assert_eq!(points(&diagram), by_the_whole_complex(&image, is_v, p), "{}", construction);
            for pair in diagram.pairs() {
                prop_assert_eq!(pair.birth(), image.numbers[pair.birth_voxel()]);
                prop_assert_eq!(pair.death(), pair.death_voxel().map(|voxel| image.numbers[voxel]));
            }
        }
    }

    #[test]
    fn superlevel_sets_are_sublevel_sets_of_the_opposite(image in images()) {
        let opposite = Image { numbers: image.numbers.iter().map(|x| -x).collect(), ..image.clone() };
        for construction in [ImageConstruction::Vertices, ImageConstruction::TopCells] {
            let falling = image.filtration().superlevel(true).construction(construction).persistence(modulo(2)).unwrap();
            let rising = opposite.filtration().construction(construction).persistence(modulo(2)).unwrap();
            prop_assert_eq!(falling.pairs().len(), rising.pairs().len());
            for (a, b) in falling.pairs().iter().zip(rising.pairs()) {
                prop_assert_eq!((a.degree(), -a.birth(), a.death().map(|x| -x)), (b.degree(), b.birth(), b.death()));
            }
        }
    }

    /// A. Garin et al., *Duality in persistent homology of images*: on a closed manifold, a torus, the finite classes of the T-construction of
    /// superlevel sets are those of the V-construction of sublevel sets, turned around, with degrees counted from the top.
    #[test]
    fn constructions_are_dual_on_a_torus(shape in shapes(), seed in any::<u64>()) {
        let shape: Vec<usize> = shape.iter().map(|&length| length.max(2)).collect();
        let count: usize = shape.iter().product();
        let numbers: Vec<f64> = (0..count as u64).map(|i| ((i + 1).wrapping_mul(seed | 1) >> 40) as f64).collect();
        let image = Image { is_periodic: vec![true; shape.len()], shape, numbers };
        let finite = |diagram: &ImageDiagram, is_turned: bool| {
            let finite = diagram.pairs().iter().filter_map(|pair| Some((pair.degree(), pair.birth(), pair.death()?)));
            let mut points: Vec<_> = finite
                .map(|(degree, birth, death)| match is_turned {
                    true => (image.shape.len() - 1 - degree, death.to_bits(), birth.to_bits()),
                    false => (degree, birth.to_bits(), death.to_bits()),
                })
                .collect();
            points.sort_unstable();
            points
        };
        let v = image.filtration().construction(ImageConstruction::Vertices).persistence(modulo(2)).unwrap();
        let t = image.filtration().superlevel(true).persistence(modulo(2)).unwrap();
        prop_assert_eq!(finite(&v, false), finite(&t, true));
        prop_assert_eq!(v.betti_numbers(), t.betti_numbers());
    }
}

/// Numbers of 64 bits are not rounded, and there is one zero.
#[test]
fn numbers_are_kept() {
    let third = 1.0 / 3.0;
    let image = ImageFiltration::new(&[4], [0.0, third, -0.0, 1e300]).unwrap();
    let diagram = image.persistence(modulo(2)).unwrap();
    assert_eq!(points(&diagram), [(0, "0.0 None".to_owned()), (0, format!("0.0 Some({third:?})"))]);
}

#[test]
fn degenerate_images() {
    let of = |shape: &[usize], numbers: &[f64]| {
        ImageFiltration::new(shape, numbers.iter().copied()).unwrap().persistence(modulo(2)).unwrap()
    };
    assert!(of(&[0, 3], &[]).pairs().is_empty());
    assert!(of(&[2], &[f64::NAN, f64::INFINITY]).pairs().is_empty());
    assert_eq!(of(&[1, 1, 1, 1, 1], &[7.0]).betti_numbers(), [1, 0, 0, 0, 0, 0]);
    assert_eq!(of(&[1, 3], &[2.0, 4.0, 1.0]).pairs()[1].death_voxel(), Some(1));
}

#[test]
fn faults_are_named() {
    let kind = |result: Result<ImageFiltration, coface_algebra::Error>| result.unwrap_err().kind();
    assert_eq!(kind(ImageFiltration::new(&[2, 2], [1.0])), ErrorKind::Shape);
    assert_eq!(kind(ImageFiltration::new(&[2; 5], [1.0; 32])), ErrorKind::Shape);
    assert_eq!(kind(ImageFiltration::new(&[], [1.0])), ErrorKind::Shape);
    let row = ImageFiltration::new(&[3, 1], [1.0, f64::NEG_INFINITY, 0.0]).unwrap();
    assert_eq!(kind(row.clone().periodic(&[true])), ErrorKind::Shape);
    assert_eq!(kind(row.clone().mask([true])), ErrorKind::Shape);
    let error = row.persistence(modulo(2)).unwrap_err();
    assert!(error.message().contains("voxel [1, 0] is at -inf"), "{error}");
    assert!(row.clone().superlevel(true).persistence(modulo(2)).is_ok());
    assert_eq!(row.superlevel(true).persistence(modulo(4)).unwrap_err().kind(), ErrorKind::Coefficient);
}
