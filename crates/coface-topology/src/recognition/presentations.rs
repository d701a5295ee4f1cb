//! Recognition of groups from their presentations: by proof, or not at all.

use crate::groups::{CosetTable, Effort, Presentation, Simplification};
use crate::recognition::finite_group::FiniteGroup;
use crate::recognition::group_name::GroupName;
use crate::recognition::metacyclic::inverted;
use crate::recognition::rewriting::Rewriting;
use coface_algebra::{UnionFind, Word};

impl Presentation {
    /// Which well-known group this is, if that can be proved with this effort; `None` says nothing about the group.
    ///
    /// The presentation is simplified first. Then it is a free product if the relators split into such that have no
    /// generator in common; free without relators; cyclic on one generator; a surface group if each generator occurs
    /// twice in its one relator; finite if coset enumeration of the trivial subgroup ends, with the name of a known
    /// group when it is a quotient of that one and has as many elements; abelian if rewriting of words (D. E. Knuth,
    /// P. B. Bendix) finds that all commutators of generators are the unit; a direct product with Z if a generator is
    /// found to be central and its exponents add up to 0 in each relator; a Heisenberg group if each of the two
    /// groups satisfies the relators of the other. Where one of two generators inverts the other, the order and the name
    /// follow from the exponents in the relators, whatever the order is; a large finite group is the product with a
    /// central cyclic subgroup whose order has no divisor in common with its index.
    ///
    /// # Complexity
    /// Bounded by `effort`; it is undecidable in general which group a presentation gives.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{Effort, Presentation};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let relators = [vec![1, 2, 1, -2, -1, -2], vec![1, 2, 2, 2, -1, -2, -2]].map(Word::from_letters);
    /// let quaternions = [vec![1, 1, -2, -2], vec![1, 2, 1, -2]].map(Word::from_letters);
    /// let name = |relators: &[Word]| -> Result<String, coface_algebra::Error> {
    ///     let name = Presentation::new(2, relators.to_vec())?.recognized(Effort::default());
    ///     Ok(name.map_or("unknown".to_owned(), |name| name.to_string()))
    /// };
    /// assert_eq!(name(&relators)?, "trivial");
    /// assert_eq!(name(&quaternions)?, "Q8");
    /// # Ok(()) }
    /// ```
    pub fn recognized(&self, effort: Effort) -> Option<GroupName> {
        recognize(Simplification::new(self, effort).presentation(), effort)
    }
}

/// The name of a group whose presentation is as simple as it gets.
fn recognize(group: &Presentation, effort: Effort) -> Option<GroupName> {
    recognize_to_depth(group, effort, 2)
}

/// The name, changing generators at most so often in search of central ones.
fn recognize_to_depth(group: &Presentation, effort: Effort, depth: usize) -> Option<GroupName> {
    let parts = free_factors(group);
    if parts.len() != 1 {
        let names: Option<Vec<GroupName>> =
            parts.iter().map(|part| recognize_to_depth(part, effort, depth)).collect();
        return names.map(GroupName::free_product);
    }
    if group.relators().is_empty() {
        return Some(GroupName::free(group.generator_count()));
    }
    if group.generator_count() == 1 {
        return Some(GroupName::Abelian(group.abelianization()));
    }
    let inverted = inverted(group);
    if let Some(name) = inverted.as_ref().filter(|name| !is_in_table(name)) {
        return Some(name.clone());
    }
    surface(group)
        .or_else(|| finite(group, effort))
        .map(|name| if name.is_complete() { name } else { inverted.clone().unwrap_or(name) })
        .or(inverted)
        .or_else(|| with_central_elements(group, effort, depth))
}

/// Whether a finite group is small enough to be named by its table.
fn is_in_table(name: &GroupName) -> bool {
    matches!(name, GroupName::Finite { order, .. } if *order <= FiniteGroup::LARGEST)
}

/// The parts of a presentation that have no generator in common; generators without relators are one part.
fn free_factors(group: &Presentation) -> Vec<Presentation> {
    let mut classes = UnionFind::new(group.generator_count());
    let index = |letter: i32| letter.unsigned_abs() - 1;
    let mut is_free = vec![true; group.generator_count()];
    for relator in group.relators() {
        for &letter in relator.letters() {
            classes.unite(index(relator.letters()[0]), index(letter));
            is_free[index(letter) as usize] = false;
        }
    }
    let rank = is_free.iter().filter(|&&free| free).count();
    let mut parts = Vec::new();
    if rank > 0 {
        parts.push(Presentation::new(rank, Vec::new()).expect("there is no relator"));
    }
    let mut number = vec![0i32; group.generator_count()];
    let mut members: Vec<Vec<usize>> = Vec::new();
    let mut class_of_root = vec![None; group.generator_count()];
    for generator in (0..group.generator_count()).filter(|&generator| !is_free[generator]) {
        let class = *class_of_root[classes.find(generator as u32) as usize].get_or_insert_with(|| {
            members.push(Vec::new());
            members.len() - 1
        });
        members[class].push(generator);
        number[generator] = members[class].len() as i32;
    }
    let mut relators = vec![Vec::new(); members.len()];
    for relator in group.relators().iter().filter(|relator| !relator.is_empty()) {
        let root = classes.find(index(relator.letters()[0])) as usize;
        let class = class_of_root[root].expect("generators of relators have a class");
        let renamed =
            relator.letters().iter().map(|&letter| number[index(letter) as usize] * letter.signum());
        relators[class].push(Word::from_letters(renamed));
    }
    let presented = members.iter().zip(relators).map(|(members, relators)| {
        Presentation::new(members.len(), relators).expect("letters are numbered in their class")
    });
    parts.extend(presented);
    parts
}

/// One relator in which each generator occurs twice: a polygon whose sides are glued in pairs, a closed surface. All
/// its corners are one vertex of the complex; if they are several of the surface, identifying them makes free
/// generators.
///
/// Source: H. Seifert, W. Threlfall, *Lehrbuch der Topologie* (1934), sections 37 to 39.
fn surface(group: &Presentation) -> Option<GroupName> {
    let [relator] = group.relators() else { return None };
    let letters = relator.letters();
    let mut sides: Vec<Vec<usize>> = vec![Vec::new(); group.generator_count()];
    for (side, letter) in letters.iter().enumerate() {
        sides[letter.unsigned_abs() as usize - 1].push(side);
    }
    // Side i runs from corner i to corner i + 1.
    let mut corners = UnionFind::new(letters.len());
    let mut is_orientable = true;
    for pair in &sides {
        let &[a, b] = pair.as_slice() else { return None };
        let ends = |side: usize| {
            let ends = [side as u32, ((side + 1) % letters.len()) as u32];
            if letters[side] > 0 { ends } else { [ends[1], ends[0]] }
        };
        is_orientable &= letters[a] != letters[b];
        for (x, y) in ends(a).into_iter().zip(ends(b)) {
            corners.unite(x, y);
        }
    }
    let vertices = corners.class_count();
    let characteristic = vertices as i64 - group.generator_count() as i64 + 1;
    let genus = (2 - characteristic) as usize / if is_orientable { 2 } else { 1 };
    Some(GroupName::free_product(vec![
        GroupName::surface(is_orientable, genus),
        GroupName::free(vertices - 1),
    ]))
}

/// A finite group, by its elements.
fn finite(group: &Presentation, effort: Effort) -> Option<GroupName> {
    let abelianization = group.abelianization();
    if abelianization.betti() > 0 {
        return None;
    }
    let limit = (effort.steps / 500).clamp(10, 200_000) as usize;
    let elements = CosetTable::new(group, &[], limit)?;
    let generators = 1..=group.generator_count() as i32;
    let commute = |a: i32, b: i32| {
        let commutator = Word::from_letters([a]).commutator(&Word::from_letters([b]));
        elements.image_by(0, &commutator) == 0
    };
    if generators.clone().all(|a| generators.clone().all(|b| commute(a, b))) {
        return Some(GroupName::Abelian(abelianization));
    }
    let name = match FiniteGroup::new(&elements) {
        Some(table) => table.name(),
        None => name_with_central_factor(group, &elements, effort),
    };
    Some(GroupName::Finite { order: elements.index(), name })
}

/// The name of a large group as a product with a cyclic group of coprime order in the center: a central Hall subgroup is a
/// direct factor (I. Schur, H. Zassenhaus), and the other factor is the quotient by it.
fn name_with_central_factor(group: &Presentation, elements: &CosetTable, effort: Effort) -> Option<String> {
    let order = elements.index();
    let letters = 1..=group.generator_count() as i32;
    let words = elements.representatives();
    let is_central = |&x: &usize| {
        letters.clone().all(|letter| {
            elements.image(x, letter) == elements.image_by(elements.image(0, letter), &words[x])
        })
    };
    let order_of = |x: usize| {
        let powers = std::iter::successors(Some(x), |&power| Some(elements.image_by(power, &words[x])));
        powers.take_while(|&power| power != 0).count() + 1
    };
    let gcd = |mut a: usize, mut b: usize| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    let (cyclic, x) = (1..order)
        .filter(is_central)
        .map(|x| (order_of(x), x))
        .filter(|&(own, _)| gcd(own, order / own) == 1)
        .max_by_key(|&(own, x)| (own, std::cmp::Reverse(x)))?;
    let relators = group.relators().iter().cloned().chain([words[x].clone()]).collect();
    let quotient = Presentation::new(group.generator_count(), relators).expect("letters are generators");
    match recognize(Simplification::new(&quotient, effort).presentation(), effort)? {
        GroupName::Finite { order: rest, name: Some(name) } if rest == order / cyclic => {
            Some(format!("{name} x Z/{cyclic}"))
        }
        _ => None,
    }
}

/// How many rules of rewriting are made.
const MOST_RULES: usize = 500;

/// An infinite group with central elements: abelian, a direct product with Z, or a Heisenberg group. Generators are
/// also tried that are products of two, with `depth` such changes one after the other.
fn with_central_elements(group: &Presentation, effort: Effort, depth: usize) -> Option<GroupName> {
    let count = group.generator_count();
    if group.abelianization().betti() == 0 || count > 8 || group.length() > 400 {
        return None;
    }
    let rules = Rewriting::new(group, MOST_RULES, effort.steps / 20);
    let letter = |i: usize| Word::from_letters([i as i32]);
    let is_central = |word: &Word| (1..=count).all(|i| rules.proves_commute(word, &letter(i)));
    let central: Vec<usize> = (1..=count).filter(|&i| is_central(&letter(i))).collect();
    if central.len() == count {
        return Some(GroupName::Abelian(group.abelianization()));
    }
    if let Some(name) = heisenberg(group, &rules, &central) {
        return Some(name);
    }
    for &factor in &central {
        if let Some(name) = split_off(group, factor, effort, depth) {
            return Some(name);
        }
    }
    // A product of two generators may be central, or one with a power of a central generator may split off.
    for i in (1..=count).filter(|_| depth > 0) {
        for other in (1..=count as i32).flat_map(|j| [j, -j]).filter(|j| j.unsigned_abs() as usize != i) {
            if !is_central(&Word::from_letters([i as i32, other])) || central.contains(&i) {
                continue;
            }
            let images: Vec<Word> = (1..=count)
                .map(|j| if j == i { Word::from_letters([i as i32, -other]) } else { letter(j) })
                .collect();
            let relators = group.relators().iter().map(|relator| relator.image(&images)).collect();
            let changed = Presentation::new(count, relators).expect("generators stay");
            if let Some(name) = with_central_elements(&changed, effort, depth - 1) {
                return Some(name);
            }
        }
    }
    None
}

/// The direct product with Z, if the exponents of a central generator add up to 0 in every relator: then it can be
/// moved out of all of them, and what is left presents the other factor.
fn split_off(group: &Presentation, central: usize, effort: Effort, depth: usize) -> Option<GroupName> {
    let is_own = |letter: &i32| letter.unsigned_abs() as usize == central;
    let is_balanced = |relator: &Word| {
        relator.letters().iter().filter(|letter| is_own(letter)).map(|letter| letter.signum()).sum::<i32>()
            == 0
    };
    if !group.relators().iter().all(is_balanced) {
        return None;
    }
    let renamed = |letter: i32| {
        if letter.unsigned_abs() as usize > central { letter - letter.signum() } else { letter }
    };
    let relators = group.relators().iter().map(|relator| {
        Word::from_letters(
            relator.letters().iter().filter(|letter| !is_own(letter)).map(|&letter| renamed(letter)),
        )
    });
    let factor =
        Presentation::new(group.generator_count() - 1, relators.collect()).expect("letters are renamed");
    let factor = Simplification::new(&factor, effort);
    recognize_to_depth(factor.presentation(), effort, depth).map(GroupName::times_integers)
}

/// The group $\langle a, b, c \mid c \text{ central}, [a, b] = c^k \rangle$ on its generators, c left out if it is the
/// commutator: the group of the presentation satisfies these relators, and this group satisfies those of the
/// presentation. So the identity of the generators is an isomorphism.
fn heisenberg(group: &Presentation, rules: &Rewriting, central: &[usize]) -> Option<GroupName> {
    let letter = |i: usize| Word::from_letters([i as i32]);
    let (a, b, c) = match (group.generator_count(), central) {
        (2, []) => (1, 2, None),
        (3, &[c]) => (if c == 1 { 2 } else { 1 }, if c == 3 { 2 } else { 3 }, Some(c)),
        _ => return None,
    };
    let commutator = letter(a).commutator(&letter(b));
    let exponent = match c {
        None => {
            let is_central = [a, b].iter().all(|&x| rules.proves_commute(&commutator, &letter(x)));
            is_central.then_some(1)
        }
        Some(c) => (1..=30)
            .flat_map(|k| [k, -k])
            .find(|&k| rules.proves_unit(&commutator.times(&letter(c).power(-k)))),
    }?;
    let holds = group.relators().iter().all(|relator| vanishes_in_heisenberg(relator, [a, b], exponent));
    holds.then_some(GroupName::Heisenberg(u64::from(exponent.unsigned_abs())))
}

/// Whether a word is the unit of the group in which the commutator of a and b is the k-th power of the third generator,
/// which is central: $c^z b^y a^x$ is the normal form, and $a b = c^k b a$.
fn vanishes_in_heisenberg(word: &Word, [a, b]: [usize; 2], k: i32) -> bool {
    let (mut x, mut y, mut z) = (0i64, 0i64, 0i64);
    for &letter in word.letters() {
        let (generator, sign) = (letter.unsigned_abs() as usize, i64::from(letter.signum()));
        if generator == a {
            x += sign;
        } else if generator == b {
            z += i64::from(k) * x * sign;
            y += sign;
        } else {
            z += sign;
        }
    }
    (x, y, z) == (0, 0, 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(count: usize, relators: &[&[i32]]) -> Option<String> {
        let words = relators.iter().map(|word| Word::from_letters(word.iter().copied())).collect();
        Presentation::new(count, words).unwrap().recognized(Effort::default()).map(|name| name.to_string())
    }

    #[test]
    fn products_of_more_than_a_thousand_elements_have_names() {
        // The closed 3-manifold gLLAQbcedfeftsqsqsj of the census.
        let relators: [&[i32]; 3] = [&[-1, 3, 3], &[-2, 3, -2, 3, -2, 1, 3], &[-2, -2, 1, -2, -2, -2, 1]];
        assert_eq!(name(3, &relators).as_deref(), Some("SL(2,5) x Z/13"));
    }

    #[test]
    fn the_sum_of_two_projective_spaces_has_its_free_product() {
        assert_eq!(name(2, &[&[1, 2, 1, 2], &[2, 2]]).as_deref(), Some("Z/2 * Z/2"));
        assert_eq!(name(2, &[&[1, 1], &[2, 2]]).as_deref(), Some("Z/2 * Z/2"));
    }
}
