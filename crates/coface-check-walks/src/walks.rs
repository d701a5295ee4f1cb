//! Certificates of closed walks.

use crate::group::Group;
use coface_check::claims::{Claims, count, equal, keys};
use coface_check::json::{field, index, list};
use coface_check::{Complex, Fault, Verdict, sha256};
use coface_check_loops::words::{Word, append, cyclic_form, cyclically_reduced, inverse, read};
use coface_check_loops::{EdgePaths, Words, vertices};
use serde_json::{Value, json};
use std::collections::BTreeSet;

const COMPONENT_KEYS: [&str; 3] = ["base", "generators", "relators"];
const WALK_KEYS: [&str; 6] = ["steps", "component", "contractible", "bounds", "word", "homology"];
const PAIR_KEYS: [&str; 4] = ["walks", "homotopic", "freely_homotopic", "homologous"];
/// All words together have at most so many letters.
const MOST_LETTERS: usize = 1 << 26;
/// All pairs of walks have at most so many letters together.
const MOST_WORK: u64 = 1 << 34;
/// So many letters are looked at to find out which words are conjugate.
const MOST_CONJUGATES: u64 = 1 << 28;

/// Checks a certificate of closed walks.
pub(crate) fn check(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let (answer, proof) = (field(whole, "answer", "answer")?, field(whole, "proof", "proof")?);
    let complex = Complex::read(inputs[0])?;
    let paths = EdgePaths::read(&complex)?;
    let said = list(field(answer, "components", "answer")?, "\"components\"", "answer")?;
    let given = list(field(proof, "components", "proof")?, "\"components\"", "proof")?;
    let words = paths.words(&complex, proof, given)?;
    if said.len() != given.len() || said.len() != paths.components {
        return Err(Fault::new("answer", "there is not a group of each component"));
    }
    let mut claims = Claims::of(answer);
    let (mut met, mut components, mut forms) = (BTreeSet::new(), Vec::new(), Vec::new());
    let mut letters = 0;
    for (i, (said, given)) in said.iter().zip(given).enumerate() {
        keys(said, &COMPONENT_KEYS, "a component")?;
        let base = index(field(said, "base", "answer")?, "\"base\"", "answer")?;
        let number = paths.component_of_base(base, &words.generators[i], &met)?;
        met.insert(number);
        let component = Component::read(number, words.generators[i].len(), said, given, &mut letters)?;
        forms.push(component.relators.iter().map(|relator| cyclic_form(relator)).collect());
        let relators = count(component.relators.len(), "relator", "relators");
        let generators = count(component.loops.len(), "generator", "generators");
        claims.prove(format!("a component has the group of the answer, of {generators} and {relators}"));
        components.push(component);
    }
    paths.faces_say(&complex, &words, &forms)?;
    claims.leave(!said.is_empty(), "components.base");
    let walks = walks(whole, answer, &paths, &words, &components)?;
    say_walks(&whole["walks"], &walks, &mut claims);
    let pairs = list(field(answer, "pairs", "answer")?, "\"pairs\"", "answer")?;
    check_pairs(pairs, &walks, &components, &mut claims)?;
    claims.know(&["file", "components", "walks", "pairs"]);
    Ok(claims.verdict())
}

/// The group of a component.
struct Component {
    /// The component of its vertices.
    number: u32,
    relators: Vec<Word>,
    group: Group,
    /// The group of the answer, which is isomorphic, and its generators as words.
    own: Group,
    loops: Vec<Word>,
}

impl Component {
    /// The group with the relators of the proof, and that of the answer with an isomorphism from it.
    fn read(
        number: u32,
        generators: usize,
        said: &Value,
        given: &Value,
        letters: &mut usize,
    ) -> Result<Self, Fault> {
        let words = |value: &Value, key: &str, generators: usize| -> Result<Vec<Word>, Fault> {
            let words = list(field(value, key, "words")?, key, "words")?.iter();
            words.map(|word| read(word, generators, "words")).collect()
        };
        let relators: Vec<Word> = words(given, "relators", generators)?;
        let relators: Vec<Word> = relators.iter().map(|word| cyclically_reduced(word)).collect();
        let unknown = || Fault::new("relators", "the relators are not those of a surface with one vertex");
        let group = Group::of(generators, &relators).ok_or_else(unknown)?;
        equal(said, "generators", &json!(generators), "a component")?;
        let own_relators = words(said, "relators", generators)?;
        let own = Group::of(generators, &own_relators).filter(|own| own.is_like(&group));
        let own = own.ok_or_else(|| {
            Fault::new("answer", "the relators of a component are those of another surface")
        })?;
        // Generators of the answer go to words such that its relator goes to the one around the faces: a homomorphism.
        let [loops, images] = ["loops", "images"].map(|key| words(given, key, generators));
        let (loops, images) = (loops?, images?);
        if loops.len() != generators || images.len() != generators {
            return Err(Fault::new("words", "there is not a word for each generator"));
        }
        for (own, relator) in own_relators.iter().zip(&relators) {
            if cyclic_form(&substituted(own, &loops, letters)?) != cyclic_form(relator) {
                return Err(Fault::new("words", "the relator of the answer is another one"));
            }
        }
        // It is onto, and so it is an isomorphism, for both are groups of the same surface.
        for (image, letter) in images.iter().zip(1..) {
            let mut word = substituted(image, &loops, letters)?;
            append(&mut word, [-letter]);
            if !group.is_unit(&word) {
                return Err(Fault::new("words", "a generator is another word of those of the answer"));
            }
        }
        Ok(Self { number, relators, group, own, loops })
    }
}

/// A word with words in place of letters.
fn substituted(word: &[i64], by: &[Word], letters: &mut usize) -> Result<Word, Fault> {
    let mut found = Word::new();
    for letter in word {
        let own = &by[letter.unsigned_abs() as usize - 1];
        add(&mut found, own, *letter > 0, letters)?;
    }
    Ok(found)
}

/// Appends a word or its inverse, and counts its letters.
fn add(word: &mut Word, next: &[i64], is_along: bool, letters: &mut usize) -> Result<(), Fault> {
    *letters += next.len() + 1;
    if *letters > MOST_LETTERS {
        return Err(Fault::new("words", "the words have too many letters"));
    }
    match is_along {
        true => append(word, next.iter().copied()),
        false => append(word, inverse(next)),
    }
    Ok(())
}

/// A closed walk.
struct Walk {
    start: u32,
    /// The number of its component in the certificate; none where no edge is.
    component: Option<usize>,
    /// Its word, moved along the tree to the base.
    word: Word,
    sums: Vec<i64>,
    is_contractible: bool,
    bounds: bool,
}

fn walks(
    whole: &Value,
    answer: &Value,
    paths: &EdgePaths,
    words: &Words,
    components: &[Component],
) -> Result<Vec<Walk>, Fault> {
    let step = "walks";
    let given = list(field(whole, "walks", step)?, "\"walks\"", step)?;
    let said = list(field(answer, "walks", "answer")?, "\"walks\"", "answer")?;
    if given.len() != said.len() {
        return Err(Fault::new("answer", "the answer does not tell each walk"));
    }
    let with_edges: BTreeSet<u32> = paths.edges.iter().flatten().copied().collect();
    let mut letters = 0;
    let mut walks = Vec::new();
    for (given, said) in given.iter().zip(said) {
        let along = vertices(given, "a walk", step)?;
        let start = *along.first().ok_or_else(|| Fault::new(step, "a walk has no vertices"))?;
        let number = paths.component(start);
        let place = components.iter().position(|component| Some(component.number) == number);
        let place = place.ok_or_else(|| Fault::new(step, format!("there is no vertex {start}")))?;
        if along.last() != Some(&start) {
            return Err(Fault::new(step, "a walk is not closed"));
        }
        let mut word = Word::new();
        for ends in along.windows(2) {
            let found = paths.edge_from([ends[0], ends[1]]);
            let none = || Fault::new(step, format!("no edge joins vertices {} and {}", ends[0], ends[1]));
            let (edge, is_along) = found.ok_or_else(none)?;
            add(&mut word, &words.of_edge[edge as usize], is_along, &mut letters)?;
        }
        let own = |letter: &i64| letter.signum() * words.places[letter.unsigned_abs() as usize - 1].1;
        let word: Word = word.iter().map(own).collect();
        let Component { group, own, loops, .. } = &components[place];
        let is_isolated = !with_edges.contains(&start);
        keys(said, &WALK_KEYS, "a walk")?;
        equal(said, "steps", &json!(along.len() - 1), "a walk")?;
        equal(said, "component", &if is_isolated { Value::Null } else { json!(place) }, "a walk")?;
        let sums = group.sums(&word);
        let (is_contractible, bounds) = (group.is_unit(&word), group.is_boundary(&sums));
        equal(said, "contractible", &json!(is_contractible), "a walk")?;
        equal(said, "bounds", &json!(bounds), "a walk")?;
        // The word of the answer, in generators of the answer, is the same element, and has the same homology.
        let claimed = read(field(said, "word", "answer")?, loops.len(), "answer")?;
        let mut difference = substituted(&claimed, loops, &mut letters)?;
        append(&mut difference, inverse(&word));
        if !group.is_unit(&difference) {
            return Err(Fault::new("answer", "the word of a walk is another one"));
        }
        let class = list(field(said, "homology", "answer")?, "\"homology\"", "answer")?;
        let class = class.iter().map(Value::as_i64).collect::<Option<Vec<i64>>>();
        let is_class = class.is_some_and(|class| {
            let less = |(a, b): (&i64, &i64)| a.checked_sub(*b);
            let difference: Option<Vec<i64>> = own.sums(&claimed).iter().zip(&class).map(less).collect();
            class.len() == loops.len() && difference.is_some_and(|difference| own.is_boundary(&difference))
        });
        if !is_class {
            return Err(Fault::new("answer", "the homology of a walk is another one"));
        }
        let (word, component) = (group.reduced(&word), (!is_isolated).then_some(place));
        walks.push(Walk { start, component, word, sums, is_contractible, bounds });
    }
    match (letters as u64).checked_mul(walks.len() as u64).is_none_or(|work| work > MOST_WORK) {
        true => Err(Fault::new(step, "there are too many walks to compare")),
        false => Ok(walks),
    }
}

/// What has been found of each walk.
fn say_walks(given: &Value, walks: &[Walk], claims: &mut Claims<'_>) {
    let numbers = |is: &dyn Fn(&Walk) -> bool| -> Vec<usize> {
        walks.iter().enumerate().filter(|(_, walk)| is(walk)).map(|(i, _)| i).collect()
    };
    // Of many only a hash is said.
    let (many, text) = (count(walks.len(), "walk", "walks"), given.to_string());
    claims.prove(match text.len() <= 400 {
        true => format!("the walks are {text}"),
        false => format!(
            "the walks are those of the certificate, with the SHA-256 {} as JSON",
            sha256(text.as_bytes())
        ),
    });
    let contracted = numbers(&|walk| walk.is_contractible);
    claims.prove(format!("of {many}, numbered from 0, those that can be contracted are {contracted:?}"));
    claims.prove(format!("of {many}, those that bound are {:?}", numbers(&|walk| walk.bounds)));
    claims.prove("the words and the homology classes of the walks are those of the answer".to_owned());
}

/// All pairs of walks.
fn check_pairs(
    pairs: &[Value],
    walks: &[Walk],
    components: &[Component],
    claims: &mut Claims<'_>,
) -> Result<(), Fault> {
    let mut pairs = pairs.iter();
    let mut budget = MOST_CONJUGATES;
    let mut found: [Vec<[usize; 2]>; 3] = Default::default();
    let mut unknown = 0;
    for (i, a) in walks.iter().enumerate() {
        for (j, b) in walks.iter().enumerate().skip(i + 1) {
            let said = pairs.next().ok_or_else(|| Fault::new("answer", "a pair of walks is missing"))?;
            keys(said, &PAIR_KEYS, "a pair of walks")?;
            equal(said, "walks", &json!([i, j]), "a pair")?;
            // Walks at one vertex that no edge has are the same.
            let together = match (a.component, b.component) {
                (Some(a), Some(b)) => (a == b).then(|| &components[a]),
                _ => None,
            };
            let same = a.start == b.start;
            let are_equal = together.map_or(same, |component| {
                let mut word = a.word.clone();
                append(&mut word, inverse(&b.word));
                component.group.is_unit(&word)
            });
            equal(said, "homotopic", &if same { json!(are_equal) } else { Value::Null }, "a pair")?;
            let are_homologous = together.map_or(a.bounds && b.bounds, |component| {
                let sums: Vec<i64> = a.sums.iter().zip(&b.sums).map(|(a, b)| a - b).collect();
                component.group.is_boundary(&sums)
            });
            equal(said, "homologous", &json!(are_homologous), "a pair")?;
            let are_freely = match together {
                None => Some(same && are_equal),
                Some(_) if are_equal => Some(true),
                Some(component) => component.group.are_conjugate(&a.word, &b.word, &mut budget),
            };
            match are_freely {
                Some(are_freely) => equal(said, "freely_homotopic", &json!(are_freely), "a pair")?,
                None => unknown += 1,
            }
            let holds = [same && are_equal, are_freely == Some(true), are_homologous];
            (0..3).filter(|k| holds[*k]).for_each(|k| found[k].push([i, j]));
        }
    }
    if pairs.next().is_some() {
        return Err(Fault::new("answer", "a pair of walks is there twice"));
    }
    claims.leave(unknown > 0, "pairs.freely_homotopic");
    for (kind, found) in ["homotopic with the base fixed", "freely homotopic", "homologous"].iter().zip(found)
    {
        let but = match (*kind == "freely homotopic" && unknown > 0, unknown) {
            (true, unknown) => {
                format!(", where {} that would take long are left out", count(unknown, "pair", "pairs"))
            }
            _ => String::new(),
        };
        claims.prove(format!("the pairs of walks that are {kind} are {found:?}{but}"));
    }
    Ok(())
}
