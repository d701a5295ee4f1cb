//! What is drawn of the answers of the verbs: their keys that are lists of cells, chains, numbers.

use super::Layer;
use super::reading::{Entries, Found, ListVisitor, entries_from, keyed, scalars, within};
use coface_algebra::Error;
use coface_answers::answer::WholeNumber;
use serde::de::{self, Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use std::marker::PhantomData;

keyed! {
    /// An answer of any verb.
    struct Shown {
        needed: {}
        may: {
            /// For each degree generators of homology or cohomology.
            generators: Entries<Entries<Generator>>,
            /// Whether they are of cohomology.
            cohomology: Truth,
            components: Entries<Component>,
            /// The vertices that a cut has added to the model.
            refinement: Option<Refinement>,
            /// The edges of a tree-cotree decomposition.
            roles: Option<Roles>,
            trees: Option<Roles>,
            /// Closed walks, or cycles.
            loops: Entries<Walk>,
            /// Where each of the loops bounds: a handle loop or a tunnel loop.
            kinds: Entries<Words>,
            walks: Entries<Walk>,
            /// Short closed paths; classes of cycles have no vertices.
            cycles: Entries<Walk>,
            /// The handles of a surface in space.
            handles: Entries<Handle>,
            cocycles: Entries<Chain<Coefficient>>,
            harmonic: Entries<Harmonic>,
            /// A chain or cochain of the user's own.
            chain: Option<Chain<Number>>,
            /// The parts of a cochain.
            decomposition: Option<Decomposition>,
            /// The edges that the values of harmonic forms are on.
            edges: Entries<Vertices>,
            simplices: Entries<Vertices>,
            /// The faces of a mesh that the answer has itself, triangles or polygons.
            facets: Entries<Vertices>,
            polygons: Entries<Vertices>,
            /// The vertices of the model below those of the mesh.
            source: Vertices,
            /// For each face of a cover the copy that it is in.
            copy: Vertices,
            /// The words of the copies.
            words: Entries<Entries<Letter>>,
            /// The edges that letters cross.
            letters: Entries<Vertices>,
            positions: Entries<Entries<Number>>,
            layout: Words,
            /// The areas or volumes of cells; those beyond the range of numbers are null.
            measures: Entries<Option<Number>>,
            /// The inputs around each cell.
            inside: Entries<Vertices>,
            files: Entries<Input>,
            inputs: Entries<Input>,
            curves: Entries<Curve>,
            diagram: Entries<Pair>,
        }
    }
}

keyed! {
    struct Generator {
        needed: { chain: Chain<Coefficient>, }
        may: { order: Option<Whole>, length: Option<Whole>, }
    }
}

keyed! {
    /// A component of a surface or complex; some verbs have a number instead.
    struct Component {
        needed: {}
        may: { seams: Entries<Seam>, loops: Entries<Walk>, }
    }
}

keyed! {
    /// What a canonical cut has added to a surface.
    struct Refinement {
        needed: {}
        may: { vertices: Entries<AddedVertex>, }
    }
}

keyed! {
    /// A vertex in the middle of others, by weights.
    struct AddedVertex {
        needed: { vertex: Vertex, of: Vertices, }
        may: { weights: Entries<Number>, }
    }
}

keyed! {
    /// A handle of a surface in space; other answers have a number instead.
    struct Handle {
        needed: {}
        may: { handle: Option<Walk>, tunnel: Option<Walk>, }
    }
}

keyed! {
    struct Roles {
        needed: {}
        may: { tree: Entries<Vertices>, cotree: Entries<Vertices>, generators: Entries<Vertices>, }
    }
}

keyed! {
    struct Seam {
        needed: { vertices: Vertices, }
        may: { number: Option<Count>, kind: Words, edges: Option<Count>, }
    }
}

keyed! {
    struct HarmonicValues {
        needed: {}
        may: { values: Entries<Number>, }
    }
}

keyed! {
    struct HarmonicChain {
        needed: { chain: Chain<Number>, }
        may: {}
    }
}

keyed! {
    /// The parts that a cochain is the sum of.
    struct Decomposition {
        needed: { exact: Chain<Number>, coexact: Chain<Number>, harmonic: Chain<Number>, }
        may: {}
    }
}

keyed! {
    struct WalkObject {
        needed: {}
        may: { vertices: Vertices, }
    }
}

keyed! {
    struct Input {
        needed: {}
        may: { file: Words, }
    }
}

keyed! {
    struct Curve {
        needed: {}
        may: { parent: Option<Count>, sign: Option<Number>, }
    }
}

keyed! {
    /// A class of persistent homology.
    struct Pair {
        needed: { degree: Count, birth: Number, }
        may: { death: Option<Number>, }
    }
}

impl Shown {
    /// What can be drawn of an answer, or of a chain alone: a list of terms.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) with the place of the first entry that cannot be what it should.
    pub(super) fn of(name: &str, answer: serde_json::Value) -> Result<Self, Error> {
        let (answer, cure) = if answer.is_array() {
            let own = "write a chain as [[coefficient,[vertices..]],..]";
            (serde_json::json!({"chain": answer}), own)
        } else {
            (answer, "give the JSON as the verb of coface wrote it")
        };
        Self::deserialize(answer).map_err(|fault| {
            let fault = fault.to_string();
            Error::invalid(format!("{} in {name}", fault.strip_prefix('.').unwrap_or(&fault))).with_cure(cure)
        })
    }
}

/// A leaf of an answer: a number or a text, made from what stands at its place.
macro_rules! leaf {
    ($(#[$about:meta])* $name:ident($value:ty), $wanted:literal, $found:ident => $read:expr) => {
        $(#[$about])*
        #[derive(Clone)]
        pub(super) struct $name(pub(super) $value);

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
                let $found = Found::deserialize(source)?;
                let value: Option<$value> = $read;
                value.map(Self).ok_or_else(|| $found.fault($wanted))
            }
        }
    };
}

leaf!(Vertex(u32), "the number of a vertex", found => match &found {
    Found::Whole(number) => u32::try_from(*number).ok(),
    _ => None,
});
leaf!(Count(usize), "a count", found => match &found {
    Found::Whole(number) => usize::try_from(*number).ok(),
    _ => None,
});
leaf!(
    /// A letter of a word: i, counted from 1, or -i for its inverse.
    Letter(i64), "a letter", found => match &found {
        Found::Whole(number) => i64::try_from(*number).ok(),
        _ => None,
    }
);
leaf!(Number(f64), "a number", found => match &found {
    Found::Whole(number) => Some(*number as f64),
    Found::Real(number) => Some(*number),
    _ => None,
});
leaf!(Whole(WholeNumber), "a whole number", found => match &found {
    Found::Whole(number) => {
        let digits = || WholeNumber::Digits(number.to_string());
        Some(i64::try_from(*number).map_or_else(|_| digits(), WholeNumber::Number))
    }
    Found::Text(digits) => Some(WholeNumber::Digits(digits.clone())),
    _ => None,
});
leaf!(
    /// A coefficient of an exact chain, of which only the sign is drawn. Those beyond 64 bits, and fractions, are texts.
    Coefficient(coface_algebra::Sign), "a number", found => {
        let is_negative = match &found {
            Found::Whole(number) => Some(*number < 0),
            Found::Real(number) => Some(*number < 0.0),
            Found::Text(text) => {
                let digits = text.strip_prefix('-').unwrap_or(text);
                let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'/');
                is_number.then_some(digits.len() < text.len())
            }
            _ => None,
        };
        is_negative.map(|is| if is { coface_algebra::Sign::Minus } else { coface_algebra::Sign::Plus })
    }
);
leaf!(
    /// A truth value; anything else is none.
    #[derive(Default)]
    Truth(bool), "a truth value", found => Some(matches!(found, Found::Boolean(true)))
);
leaf!(
    /// A text; anything else is none.
    #[derive(Default)]
    Words(Option<String>), "a text", found => Some(match &found {
        Found::Text(text) => Some(text.clone()),
        _ => None,
    })
);

/// The vertices of a cell or a walk.
#[derive(Default)]
pub(super) struct Vertices(pub(super) Vec<u32>);

impl<'de> Deserialize<'de> for Vertices {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        let visitor = ListVisitor::<Vertex> { wanted: Some("a list of vertices"), entry: PhantomData };
        let found = source.deserialize_any(visitor)?.unwrap_or_default();
        Ok(Self(found.into_iter().map(|vertex| vertex.0).collect()))
    }
}

/// Terms of a coefficient and a cell.
pub(super) struct Chain<C>(pub(super) Vec<Term<C>>);

impl<'de, C: Deserialize<'de>> Deserialize<'de> for Chain<C> {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        let visitor = ListVisitor { wanted: Some("a list of terms"), entry: PhantomData };
        source.deserialize_any(visitor).map(|found| Self(found.unwrap_or_default()))
    }
}

impl Chain<Coefficient> {
    /// Draws the cells; edges run backwards where the coefficient is negative.
    pub(super) fn push_onto(&self, layer: &mut Layer) {
        for term in &self.0 {
            layer.push_term(&term.cell, term.coefficient.0 == coface_algebra::Sign::Minus);
        }
    }
}

pub(super) struct Term<C> {
    pub(super) coefficient: C,
    pub(super) cell: Vec<u32>,
}

struct TermVisitor<C>(PhantomData<C>);

impl<C> TermVisitor<C> {
    const WANTED: &'static str = "a coefficient with a cell";

    fn other<E: de::Error>(_: Self, found: &Found) -> Result<Term<C>, E> {
        Err(found.fault(Self::WANTED))
    }
}

impl<'de, C: Deserialize<'de>> Visitor<'de> for TermVisitor<C> {
    type Value = Term<C>;
    scalars!();
    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Term<C>, A::Error> {
        let wrong = || Found::List.fault(Self::WANTED);
        let coefficient = list.next_element().map_err(|fault| within("[0]", &fault))?.ok_or_else(wrong)?;
        let cell: Option<Vertices> = list.next_element().map_err(|fault| within("[1]", &fault))?;
        let cell = cell.ok_or_else(wrong)?.0;
        if list.next_element::<de::IgnoredAny>()?.is_some() {
            return Err(wrong());
        }
        Ok(Term { coefficient, cell })
    }
    fn visit_map<A: MapAccess<'de>>(self, _: A) -> Result<Term<C>, A::Error> {
        Self::other(self, &Found::Object)
    }
}

impl<'de, C: Deserialize<'de>> Deserialize<'de> for Term<C> {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        source.deserialize_any(TermVisitor(PhantomData))
    }
}

/// A closed walk along vertices, or a cycle; what is only known by its word has no vertices.
pub(super) enum Walk {
    Vertices(Vec<u32>),
    Cycle(Chain<Coefficient>),
}

/// What a walk begins with.
enum Step {
    Vertex(u32),
    Term(Term<Coefficient>),
}

struct StepVisitor;

impl StepVisitor {
    fn other<E: de::Error>(_: Self, found: &Found) -> Result<Step, E> {
        match found {
            Found::Whole(number) => u32::try_from(*number).ok().map(Step::Vertex),
            _ => None,
        }
        .ok_or_else(|| found.fault("the number of a vertex"))
    }
}

impl<'de> Visitor<'de> for StepVisitor {
    type Value = Step;
    scalars!();
    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Step, A::Error> {
        TermVisitor(PhantomData).visit_seq(list).map(Step::Term)
    }
    fn visit_map<A: MapAccess<'de>>(self, _: A) -> Result<Step, A::Error> {
        Self::other(self, &Found::Object)
    }
}

impl<'de> Deserialize<'de> for Step {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        source.deserialize_any(StepVisitor)
    }
}

struct WalkVisitor;

impl WalkVisitor {
    fn other<E: de::Error>(_: Self, found: &Found) -> Result<Walk, E> {
        Err(found.fault("a list of vertices"))
    }
}

impl<'de> Visitor<'de> for WalkVisitor {
    type Value = Walk;
    scalars!();
    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Walk, A::Error> {
        let first = list.next_element().map_err(|fault| within("[0]", &fault))?;
        Ok(match first {
            None => Walk::Vertices(Vec::new()),
            Some(Step::Vertex(first)) => {
                let mut walk = vec![Vertex(first)];
                entries_from(&mut list, &mut walk)?;
                Walk::Vertices(walk.into_iter().map(|vertex| vertex.0).collect())
            }
            Some(Step::Term(first)) => {
                let mut terms = vec![first];
                entries_from(&mut list, &mut terms)?;
                Walk::Cycle(Chain(terms))
            }
        })
    }
    fn visit_map<A: MapAccess<'de>>(self, object: A) -> Result<Walk, A::Error> {
        let walk = WalkObject::deserialize(de::value::MapAccessDeserializer::new(object))?;
        Ok(Walk::Vertices(walk.vertices.0))
    }
}

impl<'de> Deserialize<'de> for Walk {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        source.deserialize_any(WalkVisitor)
    }
}

/// A harmonic form by its values on all edges, or the forms of one degree by their terms.
pub(super) enum Harmonic {
    Values(HarmonicValues),
    Degree(Vec<HarmonicChain>),
}

struct HarmonicVisitor;

impl HarmonicVisitor {
    fn other<E: de::Error>(_: Self, found: &Found) -> Result<Harmonic, E> {
        Err(found.fault("a harmonic form"))
    }
}

impl<'de> Visitor<'de> for HarmonicVisitor {
    type Value = Harmonic;
    scalars!();
    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Harmonic, A::Error> {
        let mut forms = Vec::new();
        entries_from(&mut list, &mut forms)?;
        Ok(Harmonic::Degree(forms))
    }
    fn visit_map<A: MapAccess<'de>>(self, object: A) -> Result<Harmonic, A::Error> {
        HarmonicValues::deserialize(de::value::MapAccessDeserializer::new(object)).map(Harmonic::Values)
    }
}

impl<'de> Deserialize<'de> for Harmonic {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        source.deserialize_any(HarmonicVisitor)
    }
}

#[cfg(test)]
mod tests {
    use super::Shown;
    use coface_answers::answer::{HomologyAnswer, SimplicesAnswer};
    use serde_json::json;

    #[test]
    fn what_is_no_number_is_named_with_its_place() {
        for (result, message) in [
            (
                json!({"simplices": [[0, 1], [2, "x"]]}),
                "simplices[1][1] is \"x\", not the number of a vertex in r",
            ),
            (json!({"simplices": [[0, -1]]}), "simplices[0][1] is -1"),
            (json!({"simplices": [7]}), "simplices[0] is 7, not a list of vertices"),
            (json!({"source": [0, 1.5]}), "source[1] is 1.5"),
            (json!({"loops": [[0, null]]}), "loops[0][1] is null"),
            (json!({"loops": [[0, [1, [0, 1]]]]}), "loops[0][1] is a list, not the number of a vertex"),
            (json!({"walks": [[[1, [0, 4_294_967_296_u64]]]]}), "walks[0][0][1][1] is 4294967296"),
            (
                json!({"components": [{"seams": [{"vertices": [true]}]}]}),
                "components[0].seams[0].vertices[0] is true",
            ),
            (
                json!({"generators": [[], [{"chain": [[1, 5]]}]]}),
                "generators[1][0].chain[0][1] is 5, not a list of vertices",
            ),
            (
                json!({"generators": [[], [{"chain": [[1, [5], 0]]}]]}),
                "generators[1][0].chain[0] is a list, not a coefficient",
            ),
            (
                json!({"generators": [[], [{"chain": [["1x", [0, 1]]]}]]}),
                "generators[1][0].chain[0][0] is \"1x\", not a number",
            ),
            (json!({"cocycles": [[[1, [0, "1"]]]]}), "cocycles[0][0][1][1] is \"1\""),
            (json!({"harmonic": [{"values": [1, {}]}]}), "harmonic[0].values[1] is an object"),
            (json!([[1, [0, 1]], ["x", [1, 2]]]), "chain[1][0] is \"x\", not a number"),
            (json!({"decomposition": {"exact": []}}), "decomposition has no \"coexact\""),
            (json!({"diagram": [{"degree": 0, "birth": "now"}]}), "diagram[0].birth is \"now\""),
            // A key that is misspelled is not passed over where nothing could be drawn without it.
            (json!({"generators": [[{"order": 0, "chian": []}]]}), "generators[0][0] has no \"chain\""),
            (json!({"diagram": [{"degree": 0, "bith": 1}]}), "diagram[0] has no \"birth\""),
            (
                json!({"components": [{"seams": [{"vertexes": []}]}]}),
                "components[0].seams[0] has no \"vertices\"",
            ),
        ] {
            let Err(error) = Shown::of("r", result) else { panic!("{message}") };
            assert!(error.message().contains(message) && error.cure().is_some(), "{error}");
        }
        let sound = json!({"simplices": [[0]], "loops": 3, "facets": 2, "generators": [[{"chain": [["-99999999999999999999", [0, 1]]]}]],
            "components": [{"loops": [{"vertices": [0, 1, 0]}, [[1, [0, 1]]]]}], "diagram": [{"degree": 0, "birth": 0.5, "death": null}]});
        Shown::of("r", sound).unwrap();
    }

    /// The keys that are read are those that the answers have.
    #[test]
    fn typed_answers_are_read() {
        let simplices: SimplicesAnswer =
            serde_json::from_value(json!({"file": "a", "simplices": [[0, 1], [2]], "f_vector": [1, 1],
            "is_complex": false, "remarks": []}))
            .unwrap();
        let shown = Shown::of("a", serde_json::to_value(&simplices).unwrap()).unwrap();
        assert_eq!(shown.simplices.list().iter().map(|cell| cell.0.len()).collect::<Vec<_>>(), [2, 1]);
        let mut homology: HomologyAnswer = serde_json::from_value(
            json!({"file": "a", "coefficients": "Z", "cohomology": true, "homology": [], "remarks": []}),
        )
        .unwrap();
        homology.generators =
            serde_json::from_value(json!([[{"order": 0, "length": 1, "chain": [[-1, [0]]]}]])).unwrap();
        let shown = Shown::of("a", serde_json::to_value(&homology).unwrap()).unwrap();
        assert!(shown.cohomology.0 && shown.generators.list()[0].list()[0].chain.0.len() == 1);
    }
}
