//! Cycles of images against their own cubes: boundaries, births, deaths and cocycles are looked up in doubled places.

use super::super::tests::{Image, images, modulo};
use super::super::{ImageConstruction, ImageFiltration};
use super::{CubeTerms, ImageCycles};
use proptest::prelude::*;
use std::collections::BTreeMap;

/// All cubes in doubled places with the extreme value of the voxels in them or around them, for the second method.
struct Whole<'a> {
    image: &'a Image,
    is_v: bool,
    is_falling: bool,
    lengths: Vec<usize>,
    p: i64,
}

type Sum = BTreeMap<u64, i64>;

impl Whole<'_> {
    fn place(&self, cube: u64) -> Vec<usize> {
        let mut rest = cube as usize;
        let mut place: Vec<usize> = self
            .lengths
            .iter()
            .rev()
            .map(|&length| {
                let at = rest % length;
                rest /= length;
                at
            })
            .collect();
        place.reverse();
        place
    }

    fn cube(&self, place: &[usize]) -> u64 {
        place.iter().zip(&self.lengths).fold(0, |cube, (&x, &length)| cube * length + x) as u64
    }

    fn degree(&self, cube: u64) -> usize {
        self.place(cube).iter().filter(|&&x| x % 2 == 1).count()
    }

    /// When a cube enters: its value, by the direction of growth.
    fn entrance(&self, cube: u64) -> f64 {
        let never = f64::INFINITY;
        let place = self.place(cube);
        let mut found: Vec<usize> = vec![0];
        for (axis, &x) in place.iter().enumerate() {
            let length = self.image.shape[axis] as isize;
            let half = (x / 2) as isize;
            let along = match (self.is_v, x % 2) {
                (true, 0) | (false, 1) => vec![half],
                (true, _) => vec![half, half + 1],
                (false, _) => vec![half - 1, half],
            };
            let along = along.into_iter().map(|at| match self.image.is_periodic[axis] {
                true => at.rem_euclid(length),
                false => at,
            });
            let along: Vec<usize> =
                along.filter(|at| (0..length).contains(at)).map(isize::cast_unsigned).collect();
            found = found.iter().flat_map(|v| along.iter().map(move |x| v * length as usize + x)).collect();
        }
        let values = found.into_iter().map(|voxel| match self.image.numbers[voxel] {
            x if x.is_nan() => never,
            x if self.is_falling => -x,
            x => x,
        });
        if self.is_v { values.fold(-never, f64::max) } else { values.fold(never, f64::min) }
    }

    fn reduced(&self, sum: Sum) -> Sum {
        let reduced = sum.into_iter().map(|(cube, x)| (cube, x.rem_euclid(self.p)));
        reduced.filter(|&(_, x)| x != 0).collect()
    }

    fn boundary(&self, terms: &[(u64, i64)]) -> Sum {
        let mut sum = Sum::new();
        for &(cube, x) in terms {
            let place = self.place(cube);
            let odd: Vec<usize> = (0..place.len()).filter(|&axis| place[axis] % 2 == 1).collect();
            for (number, &axis) in odd.iter().enumerate() {
                let sign = if number % 2 == 0 { x } else { -x };
                let mut face = place.clone();
                face[axis] = (place[axis] + 1) % self.lengths[axis];
                *sum.entry(self.cube(&face)).or_default() += sign;
                face[axis] = place[axis] - 1;
                *sum.entry(self.cube(&face)).or_default() -= sign;
            }
        }
        self.reduced(sum)
    }

    /// The value of a cocycle on a chain.
    fn value(&self, cocycle: &[(u64, i64)], chain: &Sum) -> i64 {
        let value = |&(cube, x): &(u64, i64)| x * chain.get(&cube).copied().unwrap_or(0);
        cocycle.iter().map(value).sum::<i64>().rem_euclid(self.p)
    }

    fn sum(&self, terms: &[(u64, i64)]) -> Sum {
        self.reduced(terms.iter().copied().collect())
    }

    fn check(&self, found: &ImageCycles) {
        let turned = |value: f64| if self.is_falling { -value } else { value };
        let least = self.p / 2;
        let all: u64 = self.lengths.iter().product::<usize>() as u64;
        for class in found.classes() {
            let (pair, degree) = (class.pair(), class.pair().degree());
            let (birth, death) = (turned(pair.birth()), pair.death().map_or(f64::INFINITY, turned));
            let lists = [Some(class.cycle()), class.bounding_chain(), Some(class.cocycle())];
            for terms in lists.into_iter().flatten() {
                assert!(terms.is_sorted_by(|a, b| a.0 < b.0), "each cube once: {terms:?}");
                assert!(terms.iter().all(|&(_, x)| x != 0 && x.abs() <= least.max(1)));
            }
            let of_degree =
                |terms: &[(u64, i64)], degree| terms.iter().all(|&(cube, _)| self.degree(cube) == degree);
            assert!(of_degree(class.cycle(), degree) && of_degree(class.cocycle(), degree));
            assert_eq!(self.entrance(class.birth_cube()), birth);
            let last =
                class.cycle().iter().map(|&(cube, _)| self.entrance(cube)).fold(-f64::INFINITY, f64::max);
            assert_eq!(last, birth, "the cycle is there at its birth and no sooner");
            let one = class.cycle().iter().find(|term| term.0 == class.birth_cube());
            assert_eq!(one.map(|term| term.1), Some(1), "{class:?}");
            assert!(self.boundary(class.cycle()).is_empty(), "{class:?}");
            match class.bounding_chain() {
                None => assert!(pair.death().is_none()),
                Some(chain) => {
                    assert!(of_degree(chain, degree + 1));
                    assert_eq!(self.boundary(chain), self.sum(class.cycle()), "{class:?}");
                    let last =
                        chain.iter().map(|&(cube, _)| self.entrance(cube)).fold(-f64::INFINITY, f64::max);
                    assert_eq!(last, death);
                    let cube = class.death_cube().expect("it dies");
                    assert_eq!(self.entrance(cube), death);
                    assert!(chain.iter().any(|term| term.0 == cube));
                }
            }
            assert!(class.cocycle().iter().all(|&(cube, _)| self.entrance(cube) >= birth));
            assert_eq!(self.value(class.cocycle(), &self.sum(class.cycle())), 1, "{class:?}");
            for cube in (0..all).filter(|&cube| self.degree(cube) == degree + 1) {
                if self.entrance(cube) < death {
                    let value = self.value(class.cocycle(), &self.boundary(&[(cube, 1)]));
                    assert_eq!(value, 0, "on the boundary of {:?}: {class:?}", self.place(cube));
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(250))]
    #[test]
    fn cycles_are_cycles_and_are_born_and_die_when_they_say(
        image in images(), p in prop::sample::select(vec![2u64, 3, 5]), is_falling in any::<bool>(),
    ) {
        for construction in [ImageConstruction::Vertices, ImageConstruction::TopCells] {
            let filtration = image.filtration().superlevel(is_falling).construction(construction);
            let found = filtration.persistent_cycles(modulo(p), 0.0).unwrap();
            let diagram = filtration.persistence(modulo(p)).unwrap();
            prop_assert_eq!(found.diagram(), &diagram);
            prop_assert!(found.classes().iter().map(super::ImageCycle::pair).eq(diagram.pairs()));
            let lengths: Vec<usize> = found.doubled_shape().iter().map(|&length| length as usize).collect();
            let is_v = construction == ImageConstruction::Vertices;
            // A cube around an axis of one or two voxels has an end twice: boundaries are added up all the same.
            Whole { image: &image, is_v, is_falling, lengths, p: p as i64 }.check(&found);
            let long = filtration.persistent_cycles(modulo(p), 1.0).unwrap();
            prop_assert!(long.classes().iter().map(super::ImageCycle::pair).eq(diagram.longer_than(1.0).pairs()));
        }
    }
}

/// A ring in the plane of three voxels: the cycle is a shortest one, as nothing lies within its reach.
#[test]
fn cycles_are_made_shorter() {
    // A plane of zeros with a high pixel in the middle, whose ring enters at once; the rest is there too.
    let numbers = (0..81).map(|i| if i == 40 { 9.0 } else { 0.0 });
    let image = ImageFiltration::new(&[9, 9], numbers).unwrap();
    let found = image.persistent_cycles(modulo(2), 0.0).unwrap();
    let rim = &found.classes()[1];
    assert_eq!((rim.pair().birth(), rim.pair().death()), (0.0, Some(9.0)));
    // The cube that makes the class stays, and with it a way to it.
    assert!(rim.cycle().len() <= 12, "{:?}", rim.cycle());
}

/// Torsion along the way: a band with half a twist in a box of voxels whose rim enters first.
#[test]
fn torsion_is_told() {
    // A Moebius band of voxels, thickened by nothing, around the middle of a box: its rim comes first.
    let band = moebius();
    let found = band.persistent_cycles(modulo(2), 0.0).unwrap();
    assert_eq!(found.torsion_primes(), [2]);
    let plane = ImageFiltration::new(&[3, 3], (0..9).map(f64::from)).unwrap();
    assert!(plane.persistent_cycles(modulo(2), 0.0).unwrap().torsion_primes().is_empty());
}

/// A band of voxels that turns over on its way around, rim before middle, everything else later.
fn moebius() -> ImageFiltration {
    let (length, height) = (21_i32, 13_i32);
    let mut numbers = vec![3.0; (length * length * height) as usize];
    let mut set = |x: f64, y: f64, z: f64, value: f64| {
        let at = [x, y, z].map(|x| x.round() as i32);
        let place = ((at[0] * length + at[1]) * height + at[2]) as usize;
        if numbers[place] > value {
            numbers[place] = value;
        }
    };
    for step in 0..2000 {
        let angle = f64::from(step) / 2000.0 * std::f64::consts::TAU;
        for across in -40..=40 {
            let w = f64::from(across) / 10.0;
            let (c, s) = ((angle / 2.0).cos(), (angle / 2.0).sin());
            let radius = 6.0 + w * c;
            let value = if w.abs() > 3.0 { 1.0 } else { 2.0 };
            set(10.0 + radius * angle.cos(), 10.0 + radius * angle.sin(), 6.0 + w * s, value);
        }
    }
    ImageFiltration::new(&[length as usize, length as usize, height as usize], numbers).unwrap()
}

#[test]
fn nothing_enters() {
    let none = ImageFiltration::new(&[2], [f64::NAN; 2]).unwrap();
    assert!(none.persistent_cycles(modulo(2), 0.0).unwrap().classes().is_empty());
    let point = ImageFiltration::new(&[1, 1], [7.0]).unwrap().construction(ImageConstruction::Vertices);
    let found = point.persistent_cycles(modulo(2), 0.0).unwrap();
    let terms: CubeTerms = vec![(0, 1)];
    assert_eq!((found.classes()[0].cycle(), found.classes()[0].cocycle()), (&terms[..], &terms[..]));
    assert_eq!(found.doubled_shape(), [1, 1]);
    assert!(point.persistent_cycles(modulo(4), 0.0).is_err());
}
