//! Fundamental groups: spaces of the literature, tables of other programs, random presentations.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a skipped test says so")]

use coface_algebra::{EdgeId, FaceId, VertexId};
use coface_algebra::{Sign, Word};
use coface_answers::Producer;
use coface_complexes::known_spaces;
use coface_complexes::known_spaces::{Solid, glued_solid};
use coface_complexes::simplicial::{Simplex, SimplicialComplex};
use coface_complexes::surface::HalfedgeMesh;
use coface_io as io;
use coface_topology::{
    AbelianGroup, CosetTable, EdgePathGroups, Effort, PermutationGroup, Presentation, Simplification,
    homology,
};
use proptest::prelude::*;
use serde_json::Value;

fn sum(a: &SimplicialComplex, b: &SimplicialComplex) -> SimplicialComplex {
    let order = |facet: Simplex| facet.vertices().collect::<Vec<VertexId>>();
    let top = a.dimension().unwrap();
    let (first, last) = (a.simplices(top).next().unwrap(), b.simplices(top).last().unwrap());
    a.connected_sum(&order(first), b, &order(last)).unwrap().into_complex()
}

/// The names of the groups of the components, after comparing the first homology.
fn names(complex: &SimplicialComplex) -> Vec<String> {
    let frozen = complex.freeze();
    let groups = EdgePathGroups::new(&frozen.two_skeleton().unwrap());
    let homology = homology(&frozen.chain_complex().unwrap());
    let expected = homology.groups().get(1).cloned().unwrap_or_default();
    assert_eq!(groups.first_homology(), expected);
    (0..groups.component_count())
        .map(|i| {
            let group = groups.presentation(i);
            let simple = Simplification::new(group, Effort::default());
            assert_eq!(simple.presentation().abelianization(), group.abelianization());
            assert_eq!(&simple.replay(group).unwrap(), simple.presentation());
            let name = simple.presentation().recognized(Effort::default());
            name.map_or_else(|| "unknown".to_owned(), |name| name.to_string())
        })
        .collect()
}

#[test]
fn known_spaces_have_the_groups_of_the_literature() {
    let circle = known_spaces::circle(3).unwrap();
    let torus = known_spaces::cyclic_torus(2).unwrap();
    let plane = known_spaces::projective_plane().unwrap();
    let klein = known_spaces::klein_grid(5, 5).unwrap();
    let sphere = |n| known_spaces::simplex_boundary(n).unwrap();
    let rp3 = known_spaces::real_projective_space(3).unwrap();
    let product = |a: &SimplicialComplex| a.product(&circle).unwrap().0;
    let poincare = glued_solid(Solid::Dodecahedron, 2).unwrap();
    let genus_2 = sum(&torus, &torus);
    let v = VertexId::new(0);
    let table = [
        (known_spaces::simplex(0).unwrap(), "trivial"),
        (sphere(0), "trivial, trivial"),
        (circle.clone(), "Z"),
        (sphere(2), "trivial"),
        (known_spaces::triangle_strip(5).unwrap(), "Z"),
        (known_spaces::triangle_strip(6).unwrap(), "Z"),
        (torus.clone(), "Z^2"),
        (klein.clone(), "Klein bottle group"),
        (plane.clone(), "Z/2"),
        (genus_2.clone(), "orientable surface group of genus 2"),
        (sum(&genus_2, &torus), "orientable surface group of genus 3"),
        (sum(&sum(&plane, &plane), &plane), "non-orientable surface group of genus 3"),
        (sum(&torus, &plane), "non-orientable surface group of genus 3"),
        (torus.wedge(v, &circle, v).unwrap().into_complex(), "Z^2 * Z"),
        (torus.disjoint_union(&plane).unwrap().into_complex(), "Z^2, Z/2"),
        (known_spaces::pinched_torus_grid(6, 6).unwrap(), "Z^2 * Z"),
        (known_spaces::cyclic_torus(3).unwrap(), "Z^3"),
        (known_spaces::cyclic_torus(4).unwrap(), "Z^4"),
        (known_spaces::torus_grid(&[5, 4, 6]).unwrap(), "Z^3"),
        (rp3.clone(), "Z/2"),
        (sum(&rp3, &rp3), "Z/2 * Z/2"),
        (known_spaces::lens_space(5, 2).unwrap(), "Z/5"),
        (known_spaces::lens_space(10, 3).unwrap(), "Z/10"),
        (known_spaces::moore_space(4).unwrap(), "Z/4"),
        (known_spaces::dunce_hat().unwrap(), "trivial"),
        (known_spaces::house_with_two_rooms().unwrap(), "trivial"),
        (glued_solid(Solid::Cube, 1).unwrap(), "Q8"),
        (glued_solid(Solid::Octahedron, 1).unwrap(), "SL(2,3)"),
        (known_spaces::truncated_cube_space().unwrap(), "binary octahedral group"),
        (known_spaces::prism_manifold(3).unwrap(), "dicyclic group of order 12"),
        (poincare.clone(), "SL(2,5)"),
        (poincare.suspension().unwrap().0, "trivial"),
        (product(&plane), "Z x Z/2"),
        (product(&klein), "Klein bottle group x Z"),
        (product(&genus_2), "orientable surface group of genus 2 x Z"),
        (known_spaces::torus_bundle([[1, 1], [0, 1]]).unwrap(), "Heisenberg group"),
        (known_spaces::torus_bundle([[1, 2], [0, 1]]).unwrap(), "<a, b, c | c central, [a, b] = c^2>"),
        (known_spaces::chessboard(3, 3).unwrap(), "Free(4)"),
        (known_spaces::chessboard(3, 4).unwrap(), "Z^2"),
        (known_spaces::chessboard(5, 5).unwrap(), "trivial"),
        (known_spaces::matching_complex(6).unwrap(), "Free(16)"),
        (known_spaces::matching_complex(7).unwrap(), "Z/3"),
        (known_spaces::complex_projective_plane().unwrap(), "trivial"),
        (known_spaces::k3_surface().unwrap(), "trivial"),
        // Hyperbolic: no rule proves a name.
        (glued_solid(Solid::Dodecahedron, 1).unwrap(), "unknown"),
    ];
    let mut faults = Vec::new();
    for (i, (complex, expected)) in table.iter().enumerate() {
        let found = names(complex).join(", ");
        if found != *expected {
            faults.push(format!("{i}: {found} instead of {expected}"));
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn surfaces_of_halfedges_have_their_groups() {
    let table: [(&[u32], &str); 4] =
        [(&[2, 3, 4, 5, 0, 1], "Z^2"), (&[2, 3, 1, 0], "Z^2"), (&[0, 1], "trivial"), (&[1, 0], "trivial")];
    for (next, expected) in table {
        let mesh = HalfedgeMesh::from_next(next.to_vec()).unwrap();
        let groups = EdgePathGroups::new(&mesh.two_skeleton().unwrap());
        let name = groups.presentation(0).recognized(Effort::default()).unwrap();
        assert_eq!(name.to_string(), expected, "{next:?}");
    }
}

/// A path of steps chosen by numbers, closed by itself backwards or along the tree.
fn walk(
    skeleton: &coface_algebra::chains::TwoSkeleton,
    start: VertexId,
    picks: &[usize],
) -> (Vec<(EdgeId, Sign)>, VertexId) {
    let (mut at, mut path) = (start, Vec::new());
    for &pick in picks {
        let steps: Vec<(EdgeId, Sign, VertexId)> = (0..skeleton.edge_count())
            .map(EdgeId::new)
            .flat_map(|edge| {
                let [a, b] = skeleton.edge(edge);
                [(edge, Sign::Plus, a, b), (edge, Sign::Minus, b, a)]
            })
            .filter(|step| step.2 == at)
            .map(|(edge, sign, _, to)| (edge, sign, to))
            .collect();
        let (edge, sign, to) = steps[pick % steps.len()];
        path.push((edge, sign));
        at = to;
    }
    (path, at)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// A product of loops has the product of their words; faces, and loops that go there and back, are the unit of the
    /// quaternion group.
    #[test]
    fn loops_have_words(picks in prop::collection::vec(0usize..1000, 0..30), more in prop::collection::vec(0usize..1000, 0..30)) {
        let skeleton = glued_solid(Solid::Cube, 1).unwrap().freeze().two_skeleton().unwrap();
        let groups = EdgePathGroups::new(&skeleton);
        let group = groups.presentation(0);
        let elements = CosetTable::new(group, &[], 1000).unwrap();
        prop_assert_eq!(elements.index(), 8);
        for face in (0..skeleton.face_count()).map(FaceId::new) {
            let rim: Vec<(EdgeId, Sign)> = skeleton.face(face).collect();
            let word = groups.word_of_path(&rim).unwrap();
            prop_assert_eq!(elements.image_by(0, &word), 0);
        }
        let base = groups.base(0);
        let close = |picks: &[usize]| {
            let (mut path, end) = walk(&skeleton, base, picks);
            let back = skeleton_path_back(&groups, end);
            path.extend(back);
            path
        };
        let (a, b) = (close(&picks), close(&more));
        let product = [a.clone(), b.clone()].concat();
        let words = groups.word_of_path(&a).unwrap().times(&groups.word_of_path(&b).unwrap());
        prop_assert_eq!(groups.word_of_path(&product).unwrap(), words);
        // The loop of a word has that word again.
        let word = groups.word_of_path(&a).unwrap();
        prop_assert_eq!(&groups.word_of_path(&groups.loop_of_word(0, &word)).unwrap(), &word);
        // Shut at another place, a loop is a conjugate: the same element up to conjugation, so of the same order.
        if !a.is_empty() {
            let mut turned = a;
            turned.rotate_left(1);
            let other = groups.word_of_path(&turned).unwrap();
            let order = |word: &Word| (1..=8).find(|&n| elements.image_by(0, &word.power(n)) == 0);
            prop_assert_eq!(order(&other), order(&word));
        }
    }
}

/// A path from a vertex to the base of its component.
fn skeleton_path_back(groups: &EdgePathGroups, from: VertexId) -> Vec<(EdgeId, Sign)> {
    let mut path = groups.path_to(from);
    path.reverse();
    path.into_iter().map(|(edge, sign)| (edge, sign.opposite())).collect()
}

fn presentations() -> impl Strategy<Value = Presentation> {
    let letter = (1..4i32, any::<bool>()).prop_map(|(i, negative)| if negative { -i } else { i });
    let word = prop::collection::vec(letter, 1..9).prop_map(Word::from_letters);
    prop::collection::vec(word, 0..6).prop_map(|relators| Presentation::new(3, relators).unwrap())
}

proptest! {
    /// Simplifying keeps the group: invariants agree, the moves can be done again, and the two maps undo each other in
    /// every quotient that is looked at.
    #[test]
    fn simplifying_keeps_the_group(group in presentations()) {
        let simple = Simplification::new(&group, Effort::new().max_steps(1_000_000));
        let (new, effort) = (simple.presentation(), Effort::default());
        prop_assert!(new.generator_count() <= group.generator_count());
        prop_assert_eq!(new.abelianization(), group.abelianization());
        prop_assert_eq!(&simple.replay(&group).unwrap(), new);
        for target in [PermutationGroup::Symmetric(3), PermutationGroup::Symmetric(4)] {
            prop_assert_eq!(group.homomorphisms_to(target, effort), new.homomorphisms_to(target, effort));
        }
        let letters = |count: usize| (1..=count as i32).map(|letter| Word::from_letters([letter]));
        for letter in letters(new.generator_count()) {
            prop_assert_eq!(simple.to_simplified(&simple.to_original(&letter)), letter);
        }
        // There and back is the same element: adding that as a relator changes nothing.
        let classes = group.subgroups_up_to(4, effort).unwrap();
        for letter in letters(group.generator_count()) {
            let back = simple.to_original(&simple.to_simplified(&letter));
            let difference = back.times(&letter.inverse());
            for class in &classes {
                for coset in 0..class.index() {
                    prop_assert_eq!(class.table().image_by(coset, &difference), coset);
                }
            }
        }
        for relator in group.relators() {
            let image = simple.to_simplified(relator);
            for class in new.subgroups_up_to(4, effort).unwrap() {
                prop_assert!((0..class.index()).all(|coset| class.table().image_by(coset, &image) == coset));
            }
        }
    }

    /// The complex of a presentation has its group.
    #[test]
    fn presentation_complexes_have_their_groups(relators in prop::collection::vec(
        prop::collection::vec(prop::sample::select(vec![1, -1, 2, -2]), 1..7), 1..4)) {
        let words: Vec<Word> = relators.iter().map(|letters| Word::from_letters(letters.iter().copied())).collect();
        let group = Presentation::new(2, words).unwrap();
        let complex = known_spaces::presentation_complex(2, &relators).unwrap();
        let groups = EdgePathGroups::new(&complex.freeze().two_skeleton().unwrap());
        let found = groups.presentation(0);
        prop_assert_eq!(found.abelianization(), group.abelianization());
        let simple = Simplification::new(found, Effort::default());
        for target in [PermutationGroup::Symmetric(3), PermutationGroup::Alternating(4)] {
            let count = simple.presentation().homomorphisms_to(target, Effort::default());
            prop_assert_eq!(count, group.homomorphisms_to(target, Effort::default()));
        }
    }
}

/// The records of a file of the data folder, if there is one.
fn records(file: &str) -> Vec<Value> {
    let Some(folder) = std::env::var_os("COFACE_DATA") else {
        println!("COFACE_DATA is not set: {file} is skipped");
        return Vec::new();
    };
    let text = std::fs::read_to_string(std::path::Path::new(&folder).join("complexes").join(file)).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn producer(json: &Value) -> Producer {
    Producer::of(io::read_unknown(json.to_string().as_bytes()).unwrap()).unwrap()
}

fn abelian(record: &Value) -> AbelianGroup {
    let torsion = record["torsion"].as_array().unwrap().iter().map(|order| order.as_i64().unwrap().into());
    AbelianGroup::new(record["rank"].as_u64().unwrap() as usize, torsion.collect())
}

#[test]
fn facet_lists_of_other_programs_have_their_groups() {
    let named = [
        ("Moebius Strip", "Z"),
        ("K^2 (VT)", "Klein bottle group"),
        ("RP^2 (VT)", "Z/2"),
        ("T^2 (VT)", "Z^2"),
        ("(T^2)#5", "orientable surface group of genus 5"),
        ("RP^3", "Z/2"),
        ("L_5_2", "Z/5"),
        ("T^3", "Z^3"),
        ("Poincare_sphere", "SL(2,5)"),
        ("KxS^1", "Klein bottle group x Z"),
        ("K3_16", "trivial"),
        ("S^2xS^2", "trivial"),
        ("(S^2xS^1)#2", "Free(2)"),
    ];
    for record in records("facet_lists.json") {
        let groups = EdgePathGroups::new(&producer(&record["facets"]).two_skeleton().unwrap());
        if let Some(homology) = record["integral_homology"].as_array() {
            assert_eq!(groups.first_homology(), abelian(&homology[1]), "{}", record["name"]);
        }
        let name = groups.presentation(0).recognized(Effort::default()).map(|name| name.to_string());
        if let Some((_, expected)) = named.iter().find(|(known, _)| record["name"] == *known) {
            assert_eq!(name.as_deref(), Some(*expected), "{}", record["name"]);
        }
    }
}

#[test]
fn gluing_tables_of_other_programs_have_their_groups() {
    for record in records("three_manifolds.json") {
        let table = serde_json::json!({ "gluings": record["gluings"] });
        let groups = EdgePathGroups::new(&producer(&table).two_skeleton().unwrap());
        let expected = abelian(&record["H1"]);
        assert_eq!(groups.first_homology(), expected, "{}", record["name"]);
        let simple = Simplification::new(groups.presentation(0), Effort::default());
        assert_eq!(simple.presentation().abelianization(), expected);
        let name = simple.presentation().recognized(Effort::new().max_steps(5_000_000));
        let is_lens_space = record["name"].as_str().unwrap().starts_with("L(");
        if is_lens_space {
            assert_eq!(name.map(|name| name.to_string()), Some(expected.to_string()), "{}", record["name"]);
        } else if record["hyperbolic_volume"].is_number() {
            // Groups of hyperbolic manifolds are infinite and not abelian.
            assert_eq!(name, None, "{}", record["name"]);
        }
        if let Some(count) = record["pi1"]["generators"].as_u64() {
            println!(
                "{}: {} generators, {count} elsewhere",
                record["name"],
                simple.presentation().generator_count()
            );
        }
    }
}
