//! Normal forms against other ways to decide the same.

use super::polygon_scheme::PolygonScheme;
use super::{Ball, SurfaceGroup};
use crate::groups::fundamental::Effort;
use crate::recognition::GroupName;
use coface_algebra::{Integer, Sign, UnionFind, Word};
use proptest::prelude::*;
use std::collections::HashSet;

fn word(letters: &[i32]) -> Word {
    Word::from_letters(letters.iter().copied())
}

/// Schemes of all closed surfaces with up to 4 generators, in different shapes, with their names.
const SCHEMES: [(&[i32], &str); 17] = [
    (&[1, 1], "Z/2"),
    (&[-1, -1], "Z/2"),
    (&[1, 2, -1, -2], "Z^2"),
    (&[-2, 1, 2, -1], "Z^2"),
    (&[1, 2, 1, -2], "Klein bottle group"),
    (&[1, 1, 2, 2], "Klein bottle group"),
    (&[2, 1, -2, 1], "Klein bottle group"),
    (&[1, -2, -2, 1], "Klein bottle group"),
    (&[1, 1, 2, 2, 3, 3], "non-orientable surface group of genus 3"),
    (&[1, 2, -1, -2, 3, 3], "non-orientable surface group of genus 3"),
    (&[1, 2, 3, -2, 1, -3], "non-orientable surface group of genus 3"),
    (&[1, 2, -1, -2, 3, 4, -3, -4], "orientable surface group of genus 2"),
    (&[1, 2, 3, 4, -1, -2, -3, -4], "orientable surface group of genus 2"),
    (&[3, 4, 1, 2, -1, -3, -2, -4], "orientable surface group of genus 2"),
    (&[1, 1, 2, 2, 3, 3, 4, 4], "non-orientable surface group of genus 4"),
    (&[1, 2, -1, -2, 3, 3, 4, 4], "non-orientable surface group of genus 4"),
    (&[3, 2, 3, 4, 1, -2, 1, -4], "non-orientable surface group of genus 4"),
];

fn groups() -> Vec<SurfaceGroup> {
    let closed = SCHEMES.iter().filter_map(|(letters, _)| SurfaceGroup::closed(&word(letters)).ok());
    closed.chain([SurfaceGroup::free(0), SurfaceGroup::free(1), SurfaceGroup::free(3)]).collect()
}

/// Letters of any group, from numbers.
fn letters(group: &SurfaceGroup, numbers: &[u32]) -> Word {
    let count = group.generator_count() as i32;
    if count == 0 {
        return Word::new();
    }
    let letter =
        |number: u32| (number as i32 / 2 % count + 1) * if number.is_multiple_of(2) { 1 } else { -1 };
    Word::from_letters(numbers.iter().map(|&number| letter(number)))
}

fn numbers(most: usize) -> impl Strategy<Value = Vec<u32>> {
    prop::collection::vec(0u32..840, 0..most)
}

/// A scheme with one vertex: sides glued at random, edges between different vertices contracted.
fn random_scheme(order: &[u32], flips: &[bool]) -> Word {
    let mut sides: Vec<(u32, i32)> =
        order.iter().enumerate().map(|(i, &key)| (key, (i as i32 / 2 + 1) * [1, -1][i % 2])).collect();
    for (side, &flip) in sides.iter_mut().zip(flips) {
        if flip {
            side.1 = -side.1;
        }
    }
    sides.sort_unstable();
    let mut letters: Vec<i32> = sides.into_iter().map(|(_, letter)| letter).collect();
    loop {
        let degree = letters.len();
        let mut corners = UnionFind::new(degree);
        let ends = |side: usize| {
            let ends = [side as u32, ((side + 1) % degree) as u32];
            if letters[side] > 0 { ends } else { [ends[1], ends[0]] }
        };
        for a in 0..degree {
            for b in 0..a {
                if letters[a].abs() == letters[b].abs() {
                    for (x, y) in ends(a).into_iter().zip(ends(b)) {
                        corners.unite(x, y);
                    }
                }
            }
        }
        let Some(side) = (0..degree).find(|&side| !corners.same(ends(side)[0], ends(side)[1])) else { break };
        let gone = letters[side].abs();
        letters.retain(|letter| letter.abs() != gone);
    }
    let mut names: Vec<i32> = letters.iter().map(|letter| letter.abs()).collect();
    names.sort_unstable();
    names.dedup();
    let name = |letter: i32| names.binary_search(&letter.abs()).unwrap() as i32 + 1;
    Word::from_letters(letters.iter().map(|&letter| name(letter) * letter.signum()))
}

fn schemes(most: usize) -> impl Strategy<Value = Word> {
    (1..most).prop_flat_map(|count| {
        (
            prop::collection::vec(any::<u32>(), 2 * count),
            prop::collection::vec(prop::bool::weighted(0.2), 2 * count),
        )
            .prop_map(|(order, flips)| random_scheme(&order, &flips))
    })
}

#[test]
fn groups_are_named_as_recognition_names_them() {
    for (letters, name) in SCHEMES {
        let group = SurfaceGroup::closed(&word(letters)).unwrap();
        assert_eq!(group.name().to_string(), name, "{letters:?}");
        assert_eq!(group.presentation().recognized(Effort::default()), Some(group.name()), "{letters:?}");
    }
    assert_eq!(SurfaceGroup::free(0).name().to_string(), "trivial");
    assert!(matches!(SurfaceGroup::free(3).name(), GroupName::Free(3)));
}

proptest! {
    #[test]
    fn normal_forms_multiply(a in numbers(24), b in numbers(24), c in numbers(5)) {
        for group in groups() {
            let [a, b, c] = [&a, &b, &c].map(|numbers| letters(&group, numbers));
            let product = group.product(&group.normal_form(&a), &group.normal_form(&b));
            prop_assert_eq!(&product, &group.normal_form(&a.times(&b)));
            prop_assert_eq!(group.times_word(&group.normal_form(&a), &b), product.clone());
            prop_assert_eq!(group.inverse(&product), group.normal_form(&a.times(&b).inverse()));
            let back = group.word(&product);
            prop_assert_eq!(group.normal_form(&back), product);
            prop_assert!(back.len() <= 2 * (a.len() + b.len()) || group.generator_count() < 3);
            // A conjugate of the relator anywhere in between changes nothing.
            if let Some(relator) = group.relator() {
                let conjugate = c.times(relator).times(&c.inverse());
                prop_assert!(group.is_trivial(&conjugate));
                prop_assert!(group.are_equal(&a.times(&conjugate).times(&b), &a.times(&b)));
            }
        }
    }

    #[test]
    fn trivial_words_are_those_that_dehn_reduces(
        scheme in schemes(8),
        numbers_of_word in numbers(40),
        conjugates in prop::collection::vec((numbers(6), any::<bool>()), 0..6),
    ) {
        let Ok(group) = SurfaceGroup::closed(&scheme) else { panic!("{scheme}") };
        if group.generator_count() < 3 {
            return Ok(());
        }
        let polygon = PolygonScheme::new(group.generator_count(), &scheme).unwrap();
        let random = letters(&group, &numbers_of_word);
        prop_assert_eq!(group.is_trivial(&random), polygon.dehn_reduced(&random).is_empty());
        let mut trivial = Word::new();
        for (conjugator, is_inverse) in &conjugates {
            let conjugator = letters(&group, conjugator);
            let relator = if *is_inverse { scheme.inverse() } else { scheme.clone() };
            trivial = trivial.times(&conjugator.times(&relator).times(&conjugator.inverse()));
        }
        prop_assert!(group.is_trivial(&trivial));
        prop_assert!(polygon.dehn_reduced(&trivial).is_empty());
        // Near the unit, where mistakes would show.
        let near = trivial.times(&random.power(if conjugates.len() % 2 == 0 { 0 } else { 1 }));
        let near = Word::from_letters(near.letters().iter().copied().skip(1));
        prop_assert_eq!(group.is_trivial(&near), polygon.dehn_reduced(&near).is_empty());
        prop_assert_eq!(group.normal_form(&near), group.normal_form(&polygon.dehn_reduced(&near)));
    }

    #[test]
    fn conjugate_words_have_one_class(a in numbers(20), b in numbers(20), c in numbers(3)) {
        for group in groups() {
            let [a, b, c] = [&a, &b, &c].map(|numbers| letters(&group, numbers));
            let conjugate = b.times(&a).times(&b.inverse());
            prop_assert!(group.are_conjugate(&a, &conjugate), "{a} and {b} in {}", group.presentation());
            for (a, b) in [(a.power(3), conjugate.power(3)), (a.times(&b), b.times(&a))] {
                prop_assert!(group.are_conjugate(&a, &b), "{a} and {b} in {}", group.presentation());
            }
            prop_assert_eq!(group.are_conjugate(&a, &Word::new()), group.is_trivial(&a));
            // What differs in homology or in orientation is not conjugate.
            let sums = |word: &Word| {
                let presentation = group.presentation();
                let relators = presentation.relators().iter().cloned().chain([word.clone()]).collect();
                crate::groups::fundamental::Presentation::new(group.generator_count(), relators).unwrap().abelianization()
            };
            if group.are_conjugate(&a, &c) {
                prop_assert_eq!(sums(&a), sums(&c));
                prop_assert_eq!(group.orientation_character(&a), group.orientation_character(&c));
            }
        }
    }

    #[test]
    fn random_schemes_have_canonical_systems(scheme in schemes(14), numbers_of_word in numbers(20)) {
        let group = SurfaceGroup::closed(&scheme).unwrap();
        let Some(system) = group.canonical_system() else { return Ok(()) };
        let product = system.relator().image(system.generators());
        prop_assert_eq!(&product, &scheme);
        prop_assert_eq!(system.is_orientable(), group.is_orientable());
        let canonical = SurfaceGroup::closed(&system.relator()).unwrap();
        prop_assert_eq!(canonical.name(), group.name());
        for (letter, (there, back)) in (1..).zip(system.generators().iter().zip(system.images())) {
            prop_assert!(group.are_equal(&back.image(system.generators()), &word(&[letter])));
            prop_assert!(canonical.are_equal(&there.image(system.images()), &word(&[letter])));
        }
        prop_assert!(canonical.is_trivial(&scheme.image(system.images())));
        let random = letters(&group, &numbers_of_word);
        prop_assert_eq!(group.is_trivial(&random), canonical.is_trivial(&random.image(system.images())));
        let image = random.image(system.images());
        prop_assert_eq!(group.orientation_character(&random), canonical.orientation_character(&image));
    }
}

#[test]
fn spheres_have_the_sizes_of_the_formula() {
    for group in groups() {
        let radius = if group.generator_count() < 3 { 6 } else { 3 };
        let ball = Ball::new(&group, radius, 10_000).unwrap();
        let listed: Vec<Integer> =
            ball.sphere_sizes().iter().map(|&size| Integer::from(size as i64)).collect();
        let formula: Vec<Integer> =
            group.sphere_sizes(radius).into_iter().filter(|size| !size.is_zero()).collect();
        assert_eq!(listed, formula, "{}", group.presentation());
        for (number, element) in ball.elements().iter().enumerate() {
            let shortest = ball.word(number);
            assert_eq!(shortest.len(), ball.length(number));
            assert_eq!(&group.normal_form(&shortest), element);
            assert_eq!(ball.number(element), Some(number));
            for letter in 1..=group.generator_count() as i32 {
                let next = ball.neighbor(number, letter);
                let product = group.times_word(element, &word(&[letter]));
                assert_eq!(next, ball.number(&product));
                assert!(next.is_none_or(|next| ball.neighbor(next, -letter) == Some(number)));
            }
        }
    }
}

#[test]
fn spheres_of_higher_genus_match_a_search_by_the_algorithm_of_dehn() {
    let genus_3 = word(&[1, 2, -1, -2, 3, 4, -3, -4, 5, 6, -5, -6]);
    let crosscaps_3 = word(&[1, 1, 2, 2, 3, 3]);
    for (scheme, radius, expected) in
        [(genus_3, 3usize, vec![1, 12, 132, 1452]), (crosscaps_3, 4, vec![1, 6, 30, 144, 690])]
    {
        let group = SurfaceGroup::closed(&scheme).unwrap();
        let polygon = PolygonScheme::new(group.generator_count(), &scheme).unwrap();
        // Elements of a sphere are told apart by the triviality of quotients; classes by homology keep pairs few.
        let mut spheres = vec![vec![Word::new()]];
        for r in 0..radius {
            let mut found: Vec<Word> = Vec::new();
            let mut by_sums: std::collections::HashMap<Vec<i64>, Vec<Word>> = Default::default();
            let sums = |word: &Word| {
                let mut sums = word.exponent_sums(group.generator_count());
                if !group.is_orientable() {
                    // The sum of all squares is 0.
                    let last = sums[sums.len() - 1].div_euclid(2);
                    sums.iter_mut().for_each(|sum| *sum -= 2 * last);
                }
                sums
            };
            for old in spheres.iter().skip(r.saturating_sub(1)).flatten() {
                by_sums.entry(sums(old)).or_default().push(old.clone());
            }
            for old in &spheres[r] {
                for column in 0..2 * group.generator_count() as i32 {
                    let letter = (column / 2 + 1) * [1, -1][column as usize % 2];
                    let next = old.times(&word(&[letter]));
                    let rivals = by_sums.entry(sums(&next)).or_default();
                    let is_known =
                        |rival: &Word| polygon.dehn_reduced(&rival.inverse().times(&next)).is_empty();
                    if !rivals.iter().any(is_known) {
                        rivals.push(next.clone());
                        found.push(next);
                    }
                }
            }
            spheres.push(found);
        }
        let sizes: Vec<usize> = spheres.iter().map(Vec::len).collect();
        assert_eq!(sizes, expected, "{scheme}");
        let formula: Vec<i64> =
            group.sphere_sizes(radius).iter().map(|size| size.to_i64().unwrap()).collect();
        assert_eq!(formula, expected.iter().map(|&size| size as i64).collect::<Vec<_>>());
    }
}

#[test]
fn published_growth_of_genus_2() {
    let group = SurfaceGroup::closed(&word(&[1, 2, -1, -2, 3, 4, -3, -4])).unwrap();
    let sizes: Vec<i64> = group.sphere_sizes(7).iter().map(|size| size.to_i64().unwrap()).collect();
    assert_eq!(sizes, [1, 8, 56, 392, 2736, 19096, 133_288, 930_328]);
    assert_eq!(Ball::new(&group, 4, 4000).unwrap().sphere_sizes(), [1, 8, 56, 392, 2736]);
}

/// Conjugacy among the elements of a ball by trying all conjugators of a larger ball.
#[test]
fn classes_of_short_elements_match_trying_conjugators() {
    for (letters, _) in SCHEMES {
        let group = SurfaceGroup::closed(&word(letters)).unwrap();
        let (inner, outer) = if group.generator_count() < 4 { (3, 3) } else { (2, 2) };
        let ball = Ball::new(&group, inner, 1000).unwrap();
        let conjugators = Ball::new(&group, outer, 1000).unwrap();
        let mut classes = UnionFind::new(ball.len());
        for number in 0..ball.len() {
            let element = ball.word(number);
            for conjugator in 0..conjugators.len() {
                let conjugator = conjugators.word(conjugator);
                let conjugate = conjugator.times(&element).times(&conjugator.inverse());
                if let Some(other) = ball.number(&group.normal_form(&conjugate)) {
                    classes.unite(number as u32, other as u32);
                }
            }
        }
        let forms: HashSet<_> =
            (0..ball.len()).map(|number| group.conjugacy_form(&ball.word(number))).collect();
        for number in 0..ball.len() {
            let root = classes.find(number as u32) as usize;
            assert!(group.are_conjugate(&ball.word(number), &ball.word(root)));
        }
        assert_eq!(forms.len(), classes.class_count(), "{letters:?}");
    }
}

#[test]
fn one_sided_curves_are_not_their_inverses_on_hyperbolic_surfaces() {
    let group = SurfaceGroup::closed(&word(&[1, 1, 2, 2, 3, 3])).unwrap();
    let c = word(&[1]);
    assert_eq!(group.orientation_character(&c), Sign::Minus);
    assert!(!group.are_conjugate(&c, &c.inverse()));
    assert!(!group.are_conjugate(&c, &word(&[2])));
    assert!(group.are_conjugate(&c.power(2), &word(&[3, 2, 2, 3]).inverse()));
}

#[test]
fn long_words_take_linear_time() {
    let group = SurfaceGroup::closed(&word(&[1, 2, -1, -2, 3, 4, -3, -4])).unwrap();
    let commutator = word(&[1, 2, -1, -2]);
    let other = word(&[4, 3, -4, -3]);
    let long = commutator.power(40_000);
    assert!(group.are_equal(&long, &other.power(40_000)));
    assert!(group.are_conjugate(&long, &word(&[2, -1, -2, 1]).power(40_000)));
    assert!(!group.are_conjugate(&long, &other.power(39_999)));
}
