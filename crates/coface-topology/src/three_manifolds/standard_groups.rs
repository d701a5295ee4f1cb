//! Fundamental groups of spaces that have a name, in standard form.

use super::{SeifertSpace, SpaceName, TorusBundle};
use crate::homology::AbelianGroup;
use crate::recognition::{GroupName, name_of_cyclic_product, name_of_inversion_product};

impl SpaceName {
    /// The fundamental group of the space, in a form that depends on its name alone; `None` for pieces glued along tori.
    ///
    /// Finite groups of fibered spaces have their order and a name: over the sphere with multiplicities 2, 2, n a cyclic group that inverts
    /// another one, with 2, 3, 3 to 2, 3, 5 a binary polyhedral group, each times a cyclic group. Other fibered spaces have the presentation
    /// with a generator for each exceptional fiber, the loops of the base, and the regular fiber h; bundles of tori that of Z^2 with a
    /// generator t that acts by the monodromy; sums the free product.
    ///
    /// # References
    /// P. Orlik, *Seifert manifolds* (1972), chapters 5 and 6; P. Scott, *The geometries of 3-manifolds* (1983).
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// use coface_topology::named_space;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let group = |signature: &str| -> Result<Option<String>, coface_algebra::Error> {
    ///     let table = GluingTable::from_isomorphism_signature(signature, 3)?;
    ///     let space = named_space(&table, &table.faces()?, 60)?;
    ///     Ok(space.and_then(|space| space.name().fundamental_group()).map(|group| group.to_string()))
    /// };
    /// assert_eq!(group("cMcabbjqs")?.as_deref(), Some("Z/8"));
    /// // SFS [S2: (2,1) (3,1) (5,-2)].
    /// assert_eq!(group("gLLAQbcedfeftsqsqsj")?.as_deref(), Some("SL(2,5) x Z/13"));
    /// # Ok(()) }
    /// ```
    pub fn fundamental_group(&self) -> Option<GroupName> {
        let abelian = |rank, torsion: Option<u64>| {
            AbelianGroup::new(rank, torsion.into_iter().map(Into::into).collect())
        };
        Some(match self {
            Self::Sphere | Self::Ball => GroupName::Abelian(abelian(0, None)),
            Self::Lens { p, .. } => GroupName::Abelian(abelian(0, Some(*p))),
            Self::SphereBundle { .. } => GroupName::Abelian(abelian(1, None)),
            Self::ProjectivePlaneTimesCircle => GroupName::Abelian(abelian(1, Some(2))),
            Self::Seifert(space) => {
                spherical_group(space).unwrap_or_else(|| Standard::of_space(space).name())
            }
            Self::TorusBundle(bundle) => Standard::of_bundle(bundle).name(),
            Self::Graph(_) => return None,
            Self::Sum(summands) => {
                let groups = summands.iter().map(Self::fundamental_group).collect::<Option<Vec<_>>>()?;
                GroupName::free_product(groups)
            }
        })
    }
}

/// The group of a space over the sphere with three exceptional fibers, if it is finite.
fn spherical_group(space: &SeifertSpace) -> Option<GroupName> {
    let fibers = space.fibers();
    let &[(a, x), (b, y), (c, z)] = fibers else { return None };
    if !space.is_base_orientable() || space.base_genus() > 0 {
        return None;
    }
    let [a, b, c, x, y, z] = [a, b, c, x, y, z].map(i128::from);
    // The order of the first homology.
    let first = (x * b * c + y * a * c + z * a * b).unsigned_abs();
    if first == 0 {
        return None;
    }
    let mut multiplicities = [a.unsigned_abs(), b.unsigned_abs(), c.unsigned_abs()];
    multiplicities.sort_unstable();
    let (ratio, name) = match multiplicities {
        [2, 2, n] if !n.is_multiple_of(2) => (n, name_of_inversion_product(n, first)),
        [2, 2, 2] => (2, name_of_cyclic_product("Q8".to_owned(), first / 4)),
        [2, 2, n] => (n, name_of_cyclic_product(format!("dicyclic group of order {}", 4 * n), first / 4)),
        [2, 3, 3] => {
            let mut three = 1;
            while first.is_multiple_of(3 * three) {
                three *= 3;
            }
            let own = match three {
                3 => "SL(2,3)".to_owned(),
                _ => format!("semidirect product of Q8 by Z/{three}"),
            };
            (8, name_of_cyclic_product(own, first / three))
        }
        [2, 3, 4] => (24, name_of_cyclic_product("binary octahedral group".to_owned(), first / 2)),
        [2, 3, 5] => (120, name_of_cyclic_product("SL(2,5)".to_owned(), first)),
        _ => return None,
    };
    let order = usize::try_from(first.checked_mul(ratio)?).ok()?;
    Some(GroupName::Finite { order, name: Some(name) })
}

/// A product of powers of generators, which count from 0.
type Product = Vec<(usize, i64)>;

/// A presentation in standard form.
struct Standard {
    names: Vec<String>,
    relators: Vec<Product>,
    /// The generator that commutes with all others.
    central: Option<usize>,
}

impl Standard {
    fn of_space(space: &SeifertSpace) -> Self {
        let genus = space.base_genus();
        let mut names = Vec::new();
        let numbered = |letter: &str, at: usize, count: usize| match count {
            1 => letter.to_owned(),
            _ => format!("{letter}{at}"),
        };
        let mut base = Product::new();
        for handle in 1..=genus {
            let next = names.len();
            if space.is_base_orientable() {
                names.extend(["a", "b"].map(|letter| numbered(letter, handle, genus)));
                base.extend([(next, 1), (next + 1, 1), (next, -1), (next + 1, -1)]);
            } else {
                names.push(numbered("v", handle, genus));
                base.push((next, 2));
            }
        }
        let loops = names.len();
        let exceptional = || space.fibers().iter().filter(|fiber| fiber.0 > 1);
        let count = space.exceptional_count();
        names.extend((1..=count).map(|fiber| numbered("x", fiber, count)));
        names.push("h".to_owned());
        let h = names.len() - 1;
        let mut relators = Vec::new();
        if !space.is_base_orientable() {
            relators.extend((0..loops).map(|v| vec![(v, 1), (h, 1), (v, -1), (h, 1)]));
            relators.extend((loops..h).map(|x| vec![(x, 1), (h, 1), (x, -1), (h, -1)]));
        }
        relators.extend(exceptional().zip(loops..).map(|(&(alpha, beta), x)| vec![(x, alpha), (h, beta)]));
        // A section around a fiber of multiplicity 1 is a power of the regular fiber.
        let plain = space.fibers().iter().filter(|fiber| fiber.0 == 1).map(|fiber| -fiber.1).sum();
        let sections = (loops..h).map(|x| (x, 1));
        relators.push(sections.chain(base).chain([(h, plain)]).collect());
        relators.iter_mut().for_each(|relator| relator.retain(|&(_, exponent)| exponent != 0));
        relators.retain(|relator| !relator.is_empty());
        Self { names, relators, central: space.is_base_orientable().then_some(h) }
    }

    fn of_bundle(bundle: &TorusBundle) -> Self {
        let (a, b, t) = (0, 1, 2);
        let moved = |letter: usize, [x, y]: [i64; 2]| {
            let mut relator = vec![(t, 1), (letter, 1), (t, -1), (b, -y), (a, -x)];
            relator.retain(|&(_, exponent)| exponent != 0);
            relator
        };
        let [one, two] = bundle.monodromy();
        let relators = vec![vec![(a, 1), (b, 1), (a, -1), (b, -1)], moved(a, one), moved(b, two)];
        Self { names: ["a", "b", "t"].map(str::to_owned).to_vec(), relators, central: None }
    }

    fn name(&self) -> GroupName {
        let power = |&(letter, exponent): &(usize, i64)| match exponent {
            1 => self.names[letter].clone(),
            _ => format!("{}^{exponent}", self.names[letter]),
        };
        let product = |relator: &Product| relator.iter().map(power).collect::<Vec<_>>().join(" ");
        let central = self.central.map(|letter| format!("{} central", self.names[letter]));
        let relators: Vec<String> = central.into_iter().chain(self.relators.iter().map(product)).collect();
        GroupName::Presented(format!("<{} | {}>", self.names.join(", "), relators.join(", ")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::groups::{CosetTable, EdgePathGroups, Effort, PermutationGroup, Presentation};
    use crate::three_manifolds::named_space;
    use coface_algebra::Word;
    use coface_complexes::gluing::GluingTable;

    impl Standard {
        fn presentation(&self) -> Presentation {
            let count = self.names.len();
            let commutes = |h: usize| {
                let others = (0..count).filter(move |&x| x != h);
                others.map(move |x| vec![(x, 1), (h, 1), (x, -1), (h, -1)])
            };
            let relators = self.relators.iter().cloned().chain(self.central.into_iter().flat_map(commutes));
            let word = |relator: Product| {
                let power = |(letter, exponent): (usize, i64)| {
                    let letter = (letter as i32 + 1) * exponent.signum() as i32;
                    vec![letter; exponent.unsigned_abs() as usize]
                };
                Word::from_letters(relator.into_iter().flat_map(power))
            };
            Presentation::new(count, relators.map(word).collect()).unwrap()
        }
    }

    fn space(fibers: &[(i64, i64)]) -> SeifertSpace {
        SeifertSpace::new(true, 0, fibers).unwrap()
    }

    #[test]
    fn finite_groups_have_as_many_elements_as_their_names_say() {
        let mut found = Vec::new();
        for fibers in [
            [(2, 1), (2, 1), (2, 1)],
            [(2, 1), (2, 1), (3, 1)],
            [(2, 1), (2, 1), (3, 2)],
            [(2, 1), (2, 1), (4, 3)],
            [(2, 1), (2, 1), (5, -2)],
            [(2, 1), (3, 1), (3, 1)],
            [(2, 1), (3, 1), (3, -1)],
            [(2, 1), (3, 1), (3, 2)],
            [(2, 1), (3, 1), (3, 7)],
            [(2, 1), (3, 1), (4, 1)],
            [(2, 1), (3, 2), (4, -1)],
            [(2, 1), (3, 1), (5, -4)],
            [(2, 1), (3, 1), (5, -3)],
        ] {
            let space = space(&fibers);
            let standard = Standard::of_space(&space).presentation();
            let name = SpaceName::Seifert(space.clone()).fundamental_group().unwrap();
            let elements = CosetTable::new(&standard, &[], 20_000).unwrap().index();
            assert_eq!(name.order(), Some(elements.to_string()), "{space}: {name}");
            // What is named by the table of the group has that name.
            if let Some(GroupName::Finite { name: Some(other), .. }) = standard.recognized(Effort::default())
            {
                assert_eq!(name.to_string(), other, "{space}");
                found.push(other);
            }
        }
        assert!(found.len() > 8, "{found:?}");
    }

    #[test]
    fn standard_groups_are_those_of_the_triangulations() {
        let (mut finite, mut presented) = (0, 0);
        // Over all bases, finite and infinite, among them one of order 3848; the last is a bundle of tori.
        for signature in [
            "kLAMzMzkbccdefghijjemkihhqqhxj",
            "gLLAQbcedfeftsqsqsj",
            "eLAkbccddemken",
            "eLPkbcdddhrrnk",
            "gLALQbccefffemkbemi",
            "gLALQbccefffemkbtli",
            "gLALQbcceffflpkktua",
            "gvLQQedfedffrwawrhh",
            "jLALLAQcbceghgiiiuijjiocatd",
            "jLLLLQQbcgfhiihihtsmgwnkbsf",
            "hvLPQkcedfgfggnnkqqeiw",
        ] {
            let table = GluingTable::from_isomorphism_signature(signature, 3).unwrap();
            let faces = table.faces().unwrap();
            let space = named_space(&table, &faces, 60).unwrap().unwrap();
            let name = space.name().fundamental_group().unwrap();
            let paths = EdgePathGroups::new(&faces.two_skeleton().unwrap());
            let group = paths.presentation(0);
            let standard = match space.name() {
                SpaceName::Seifert(space) => Standard::of_space(space),
                SpaceName::TorusBundle(bundle) => Standard::of_bundle(bundle),
                other => panic!("{signature} is {other}"),
            };
            let standard = standard.presentation();
            assert_eq!(standard.abelianization(), group.abelianization(), "{signature}");
            let effort = Effort::default();
            for target in [
                PermutationGroup::Symmetric(3),
                PermutationGroup::Symmetric(4),
                PermutationGroup::Alternating(5),
            ] {
                let counts = [&standard, group].map(|group| {
                    let small = crate::groups::Simplification::new(group, effort);
                    small.presentation().homomorphisms_to(target, effort).map(|count| [count.all, count.onto])
                });
                assert_eq!(counts[0], counts[1], "{signature}: {name} to {target}");
            }
            if name.order().is_some() { finite += 1 } else { presented += 1 }
        }
        assert_eq!([finite, presented], [4, 7]);
    }

    #[test]
    fn forms_are_the_same_whatever_the_triangulation_is() {
        let name = |space: SeifertSpace| SpaceName::Seifert(space).fundamental_group().unwrap().to_string();
        assert_eq!(
            name(space(&[(2, 1), (2, 1), (37, -11)])),
            "(semidirect product of Z/37 by Z/8, acting by inversion) x Z/13"
        );
        assert_eq!(
            name(space(&[(2, 1), (3, 1), (7, 1)])),
            "<x1, x2, x3, h | h central, x1^2 h, x2^3 h, x3^7 h, x1 x2 x3>"
        );
        let torus = SeifertSpace::new(true, 1, &[(2, 1)]).unwrap();
        assert_eq!(name(torus), "<a, b, x, h | h central, x^2 h^-1, x a b a^-1 b^-1>");
        let klein = SeifertSpace::new(false, 2, &[(1, 1)]).unwrap();
        assert_eq!(name(klein), "<v1, v2, h | v1 h v1^-1 h, v2 h v2^-1 h, v1^2 v2^2 h>");
    }
}
