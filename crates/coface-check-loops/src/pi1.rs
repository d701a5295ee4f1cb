//! Certificates of fundamental groups.

use crate::abelian::abelianized;
use crate::cosets::order;
use crate::cut::vertices;
use crate::surface::Classes;
use crate::tietze::{Presentation, relators};
use crate::words::{Word, append, cyclic_form, cyclically_reduced, inverse};
use coface_check::claims::{Claims, count, equal, keys};
use coface_check::json::{field, index, list, optional};
use coface_check::{Complex, Fault, Verdict};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet, HashMap};

const COMPONENT_KEYS: [&str; 8] =
    ["base", "generators", "relators", "abelianization", "name", "lengths", "subgroups", "homomorphisms"];
/// What a finite group is called that is not known better.
const OF_ORDER: &str = "finite group of order";
/// The words of all edges have at most so many letters together.
const MOST_LETTERS: usize = 1 << 26;

/// Checks a certificate of fundamental groups.
pub(crate) fn check(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let (answer, proof) = (field(whole, "answer", "answer")?, field(whole, "proof", "proof")?);
    let complex = Complex::read(inputs[0])?;
    let paths = EdgePaths::read(&complex)?;
    let said = list(field(answer, "components", "answer")?, "\"components\"", "answer")?;
    let given = list(field(proof, "components", "proof")?, "\"components\"", "proof")?;
    let words = paths.words(&complex, proof, given)?;
    if said.len() != given.len() || said.len() != words.generators.len() {
        return Err(Fault::new("answer", "there is not a group of each component"));
    }
    let mut claims = Claims::of(answer);
    let mut is_met = BTreeSet::new();
    let mut forms = Vec::new();
    for (i, (said, given)) in said.iter().zip(given).enumerate() {
        keys(said, &COMPONENT_KEYS, "a component")?;
        let base = index(field(said, "base", "answer")?, "\"base\"", "answer")?;
        is_met.insert(paths.component_of_base(base, &words.generators[i], &is_met)?);
        let generators = words.generators[i].len();
        let start = relators(field(given, "relators", "relators")?, generators, "relators")?;
        forms.push(start.iter().map(|relator| cyclic_form(relator)).collect::<BTreeSet<Word>>());
        let mut presentation = Presentation::new(generators, start);
        let unsimplified = presentation.left();
        let moves = list(field(given, "moves", "moves")?, "\"moves\"", "moves")?;
        for step in moves {
            presentation.apply(step)?;
        }
        let simplified = presentation.left();
        let shown = if answer["simplified"] == json!(true) { &simplified } else { &unsimplified };
        equal(said, "generators", &json!(shown.0), "a component")?;
        let own = relators(field(said, "relators", "answer")?, shown.0, "answer")?;
        let mut own: Vec<Word> =
            own.iter().map(|relator| cyclic_form(relator)).filter(|form| !form.is_empty()).collect();
        own.sort_unstable();
        if own != shown.1 {
            return Err(Fault::new(
                "answer",
                format!("the relators of the component of vertex {base} are others"),
            ));
        }
        claims.prove(format!(
            "the group of a component has the presentation of the answer, {} and {}",
            count(shown.0, "generator", "generators"),
            count(own.len(), "relator", "relators")
        ));
        match (name(&simplified), optional(said, "name")) {
            (Some(found), Some(said)) if *said == json!(found) => {
                claims.prove(format!("this group is {found}"));
            }
            (Some(found), Some(said)) => {
                return Err(Fault::new("answer", format!("a group is {found}, and the answer says {said}")));
            }
            (None, Some(said)) => match order(&simplified) {
                Some(elements) => {
                    claims.prove(format!("this group has {}", count(elements, "element", "elements")));
                    match finite_name(&simplified, elements) {
                        Some(found) if *said == json!(found) => {
                            claims.prove(format!("this group is {found}"));
                        }
                        Some(found)
                            if !found.starts_with(OF_ORDER)
                                || said.as_str().is_none_or(|said| said.starts_with(OF_ORDER)) =>
                        {
                            let message = format!("a group is {found}, and the answer says {said}");
                            return Err(Fault::new("answer", message));
                        }
                        _ => claims.leave(true, "components.name"),
                    }
                }
                None => claims.leave(true, "components.name"),
            },
            (_, None) => {}
        }
        claims.leave(true, "components.base");
        if let Some(said) = optional(said, "abelianization") {
            match abelianized(&simplified) {
                Some((rank, torsion)) if *said == json!({"betti": rank, "torsion": torsion}) => {
                    claims.prove(format!("abelianized it has the rank {rank} and the torsion {torsion:?}"));
                }
                Some((rank, torsion)) => {
                    let message = format!(
                        "abelianized a group has the rank {rank} and the torsion {torsion:?}, and the answer says {said}"
                    );
                    return Err(Fault::new("answer", message));
                }
                None => claims.leave(true, "components.abelianization"),
            }
        }
        for key in ["lengths", "subgroups", "homomorphisms"] {
            claims.leave(optional(said, key).is_some(), &format!("components.{key}"));
        }
    }
    paths.faces_say(&complex, &words, &forms)?;
    if is_met.len() != paths.components {
        return Err(Fault::new("answer", "a component is missing"));
    }
    claims.know(&["file", "components", "simplified"]);
    claims.prove(format!("the input has {}", count(is_met.len(), "component", "components")));
    Ok(claims.verdict())
}

/// The name of a group that its presentation shows.
fn name((generators, relators): &(usize, Vec<Word>)) -> Option<String> {
    let commutator = |a: i64, b: i64| cyclic_form(&[a, b, -a, -b]);
    match (*generators, &relators[..]) {
        (0, _) => return Some("trivial".to_owned()),
        (1, []) => return Some("Z".to_owned()),
        (rank, []) => return Some(format!("Free({rank})")),
        (1, [relator]) => {
            return Some(if relator.len() == 1 {
                "trivial".to_owned()
            } else {
                format!("Z/{}", relator.len())
            });
        }
        _ => {}
    }
    let rank = *generators as i64;
    let mut all: Vec<Word> = (1..=rank).flat_map(|b| (1..b).map(move |a| commutator(a, b))).collect();
    all.sort_unstable();
    (all == *relators).then(|| format!("Z^{rank}"))
}

/// The name of a group with so many elements: of an abelian one its cyclic factors, for it has as many elements as they have.
fn finite_name(presentation: &(usize, Vec<Word>), elements: usize) -> Option<String> {
    let (rank, torsion) = abelianized(presentation)?;
    let product = torsion.iter().try_fold(1u64, |product, factor| product.checked_mul(*factor))?;
    Some(match (rank, torsion.is_empty()) {
        (0, true) if elements == 1 => "trivial".to_owned(),
        (0, false) if product == elements as u64 => {
            torsion.iter().map(|factor| format!("Z/{factor}")).collect::<Vec<_>>().join(" x ")
        }
        _ => format!("{OF_ORDER} {elements}"),
    })
}

/// The vertices, edges and faces of a complex, for paths along edges.
#[derive(Debug)]
pub struct EdgePaths {
    /// The ends of each edge, by its vertices in the file.
    pub edges: Vec<[u32; 2]>,
    by_ends: HashMap<[u32; 2], u32>,
    /// For each face the edges around it, and whether they are passed along the complex.
    rims: Vec<Vec<(u32, bool)>>,
    by_vertices: HashMap<Vec<u32>, u32>,
    /// For each vertex of the file its component.
    component_of: BTreeMap<u32, u32>,
    /// The number of components.
    pub components: usize,
}

/// The word of each edge, in generators counted over all components.
#[derive(Debug)]
pub struct Words {
    /// The words of edges.
    pub of_edge: Vec<Word>,
    /// For each component of the certificate its generators.
    pub generators: Vec<Vec<u32>>,
    /// For each generator, counted over all components, the component of the certificate and its number there.
    pub places: Vec<(usize, i64)>,
}

impl EdgePaths {
    /// The cells of a complex whose cells have vertices.
    ///
    /// # Errors
    /// A [`Fault`] where they have none.
    pub fn read(complex: &Complex) -> Result<Self, Fault> {
        let unnamed = || Fault::new("input", "the cells have no vertices");
        let counts = complex.counts();
        let count = |degree: usize| counts.get(degree).copied().unwrap_or(0);
        let mut names = BTreeMap::new();
        for vertex in 0..count(0) {
            names.insert(complex.vertices(0, vertex).ok_or_else(unnamed)?[0], vertex as u32);
        }
        let (mut edges, mut by_ends) = (Vec::new(), HashMap::new());
        let mut classes = Classes::new(count(0));
        for edge in 0..count(1) {
            let Some(&[a, b]) = complex.vertices(1, edge) else { return Err(unnamed()) };
            edges.push([a, b]);
            by_ends.insert([a.min(b), a.max(b)], edge as u32);
            let (Some(&from), Some(&to)) = (names.get(&a), names.get(&b)) else { return Err(unnamed()) };
            classes.join(from, to);
        }
        let (mut rims, mut by_vertices) = (Vec::new(), HashMap::new());
        for face in 0..count(2) {
            let vertices = complex.vertices(2, face).ok_or_else(unnamed)?;
            let step = |i: usize| {
                let [a, b] = [vertices[i], vertices[(i + 1) % vertices.len()]];
                let edge = *by_ends.get(&[a.min(b), a.max(b)])?;
                Some((edge, edges[edge as usize] == [a, b]))
            };
            rims.push((0..vertices.len()).map(step).collect::<Option<Vec<_>>>().ok_or_else(unnamed)?);
            let mut vertices = vertices.to_vec();
            vertices.sort_unstable();
            by_vertices.insert(vertices, face as u32);
        }
        let component_of: BTreeMap<u32, u32> =
            names.iter().map(|(&name, &vertex)| (name, classes.of(vertex))).collect();
        let components = component_of.values().collect::<BTreeSet<_>>().len();
        Ok(Self { edges, by_ends, rims, by_vertices, component_of, components })
    }

    /// The component of a vertex.
    pub fn component(&self, vertex: u32) -> Option<u32> {
        self.component_of.get(&vertex).copied()
    }

    /// The component of a base, which has not been met, and has all these generators.
    ///
    /// # Errors
    /// A [`Fault`] where this is not so.
    pub fn component_of_base(
        &self,
        base: u32,
        generators: &[u32],
        is_met: &BTreeSet<u32>,
    ) -> Result<u32, Fault> {
        let component = self.component(base).filter(|component| !is_met.contains(component));
        let component = component
            .ok_or_else(|| Fault::new("answer", format!("vertex {base} is in no other component")))?;
        let is_there = |edge: &u32| self.component(self.edges[*edge as usize][0]) == Some(component);
        match generators.iter().all(is_there) {
            true => Ok(component),
            false => {
                let message = format!("a generator is not in the component of vertex {base}");
                Err(Fault::new("generators", message))
            }
        }
    }

    /// The edge from one vertex to another, and whether the complex has it in this direction.
    pub fn edge_from(&self, ends: [u32; 2]) -> Option<(u32, bool)> {
        let edge = *self.by_ends.get(&[ends[0].min(ends[1]), ends[0].max(ends[1])])?;
        Some((edge, self.edges[edge as usize] == ends))
    }

    /// An edge by its vertices, and whether they are in the order of the complex.
    fn edge(&self, ends: &Value, step: &str) -> Result<(u32, bool), Fault> {
        let found = match vertices(ends, "an edge", step)?[..] {
            [a, b] => self.edge_from([a, b]),
            _ => None,
        };
        found.ok_or_else(|| Fault::new(step, "there is no such edge"))
    }

    /// The words of all edges: none of the edges of a spanning forest, a letter of each generator, and then one after the other by a face
    /// whose other edges have words.
    ///
    /// # Errors
    /// A [`Fault`] where this is not so.
    pub fn words(&self, complex: &Complex, proof: &Value, components: &[Value]) -> Result<Words, Fault> {
        let mut of_edge: Vec<Option<Word>> = vec![None; self.edges.len()];
        let places: BTreeMap<u32, u32> = self.component_of.keys().copied().zip(0..).collect();
        let mut trees = Classes::new(places.len());
        let tree = list(field(proof, "tree", "tree")?, "\"tree\"", "tree")?;
        for ends in tree {
            let edge = self.edge(ends, "tree")?.0;
            let [a, b] = self.edges[edge as usize].map(|end| places[&end]);
            if !trees.join(a, b) {
                return Err(Fault::new("tree", "the edges of the tree have a cycle"));
            }
            of_edge[edge as usize] = Some(Word::new());
        }
        if tree.len() + self.components != complex.counts()[0] {
            return Err(Fault::new("tree", "the tree does not reach all vertices"));
        }
        let (mut generators, mut of_letter) = (Vec::new(), Vec::new());
        for (i, component) in components.iter().enumerate() {
            let mut own = Vec::new();
            for ends in list(field(component, "generators", "generators")?, "\"generators\"", "generators")? {
                let (edge, is_along) = self.edge(ends, "generators")?;
                if of_edge[edge as usize].is_some() {
                    return Err(Fault::new("generators", "an edge is twice there, or in the tree"));
                }
                own.push(edge);
                of_letter.push((i, own.len() as i64));
                let letter = of_letter.len() as i64;
                of_edge[edge as usize] = Some(vec![if is_along { letter } else { -letter }]);
            }
            generators.push(own);
        }
        let mut letters = 0;
        for face in list(field(proof, "faces", "faces")?, "\"faces\"", "faces")? {
            let face = self.face(face, "faces")?;
            let rim = &self.rims[face as usize];
            let mut unknown = (0..rim.len()).filter(|&i| of_edge[rim[i].0 as usize].is_none());
            let (Some(at), None) = (unknown.next(), unknown.next()) else {
                return Err(Fault::new("faces", "a face has not one edge without a word"));
            };
            // The edge times the others around the face is the unit.
            let mut rest = Word::new();
            for &(edge, is_along) in rim[at + 1..].iter().chain(&rim[..at]) {
                let word = of_edge[edge as usize].as_deref().unwrap_or_default();
                append(&mut rest, if is_along { word.to_vec() } else { inverse(word) });
            }
            letters += rest.len();
            if letters > MOST_LETTERS {
                return Err(Fault::new("faces", "the words of edges have too many letters"));
            }
            let (edge, is_along) = rim[at];
            of_edge[edge as usize] = Some(if is_along { inverse(&rest) } else { rest });
        }
        let of_edge: Option<Vec<Word>> = of_edge.into_iter().collect();
        let of_edge = of_edge.ok_or_else(|| Fault::new("faces", "an edge has no word"))?;
        Ok(Words { of_edge, generators, places: of_letter })
    }

    fn face(&self, value: &Value, step: &str) -> Result<u32, Fault> {
        let mut vertices = vertices(value, "a face", step)?;
        vertices.sort_unstable();
        let found = self.by_vertices.get(&vertices).copied();
        found.ok_or_else(|| Fault::new(step, format!("there is no face {vertices:?}")))
    }

    /// The relators are the words around faces, but for faces that solids say.
    ///
    /// # Errors
    /// A [`Fault`] where they are not.
    pub fn faces_say(
        &self,
        complex: &Complex,
        words: &Words,
        relators: &[BTreeSet<Word>],
    ) -> Result<(), Fault> {
        let mut said: Vec<BTreeSet<Word>> = vec![BTreeSet::new(); relators.len()];
        let mut left_out = Vec::new();
        for (face, rim) in self.rims.iter().enumerate() {
            let mut word = Word::new();
            for &(edge, is_along) in rim {
                let own = &words.of_edge[edge as usize];
                append(&mut word, if is_along { own.clone() } else { inverse(own) });
            }
            let word = cyclically_reduced(&word);
            let Some(first) = word.first() else { continue };
            let component = words.places[first.unsigned_abs() as usize - 1].0;
            let local = |letter: &i64| {
                let (of, number) = words.places[letter.unsigned_abs() as usize - 1];
                (of == component).then_some(number * letter.signum())
            };
            let local: Option<Word> = word.iter().map(local).collect();
            let form = cyclic_form(
                &local.ok_or_else(|| Fault::new("relators", "a face has generators of two components"))?,
            );
            match relators[component].contains(&form) {
                true => drop(said[component].insert(form)),
                false => left_out.push(face as u32),
            }
        }
        for (said, relators) in said.iter().zip(relators) {
            if relators.iter().any(|relator| !relator.is_empty() && !said.contains(relator)) {
                return Err(Fault::new("relators", "a relator is the word of no face"));
            }
        }
        self.check_left_out(complex, &left_out)
    }

    /// Faces that are left out join solids, or a solid and the outside, without a cycle. At an end of this forest a solid has one such face, whose
    /// word is a product of conjugates of those of its other faces; then the next one.
    fn check_left_out(&self, complex: &Complex, left_out: &[u32]) -> Result<(), Fault> {
        let fault =
            || Err(Fault::new("relators", "the word of a face is no relator, and solids do not say it"));
        if left_out.is_empty() {
            return Ok(());
        }
        let Some(&solids) = complex.counts().get(3) else { return fault() };
        let mut sides: Vec<Vec<u32>> = vec![Vec::new(); self.rims.len()];
        for solid in 0..solids {
            for (face, _) in complex.boundary(3, solid) {
                sides[*face as usize].push(solid as u32);
            }
        }
        let mut trees = Classes::new(solids + 1);
        for &face in left_out {
            let joined = match sides[face as usize][..] {
                [solid] => trees.join(solid, solids as u32),
                [a, b] => trees.join(a, b),
                _ => false,
            };
            if !joined {
                return fault();
            }
        }
        Ok(())
    }
}
