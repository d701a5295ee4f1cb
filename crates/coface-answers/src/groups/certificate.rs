//! Certificates of fundamental groups.

use super::{FoundGroups, GroupsRequest, SurfaceLoops};
use crate::Producer;
use crate::answer::Pi1Answer;
use crate::homology::certificate::{Input, checked, refused};
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::{CellId, Error, FaceId, VertexId, Word};
use coface_topology::{EdgePathGroups, Effort, Simplification, TietzeMove};
use serde::Serialize;
use serde_json::{Value, json};

/// A certificate of fundamental groups, as `docs/certificates.md` describes it.
#[derive(Serialize)]
struct Certificate {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    answer: Pi1Answer,
    proof: Proof,
}

#[derive(Serialize)]
struct Proof {
    /// The edges of a spanning forest.
    tree: Vec<[u32; 2]>,
    /// The faces that give an edge its word, in their order.
    faces: Vec<Vec<u32>>,
    components: Vec<Component>,
}

#[derive(Serialize)]
struct Component {
    /// The edges of the generators, in their directions.
    generators: Vec<[u32; 2]>,
    relators: Vec<Vec<i32>>,
    moves: Vec<Value>,
}

impl GroupsRequest {
    /// A certificate of groups that were found, from the name and the bytes of the file that the model was read from: their presentations by paths along
    /// edges, the Tietze moves that simplify them, and names where the last presentation shows them; or of walks on a surface that were compared: the words of edges.
    /// [`coface_check_walks::check`] follows that without any code of this library, as `docs/certificates.md` says. It has been checked.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::UnsupportedFormat`] if the checker does not read the file as this library does: it reads facet lists, and plain OFF and
    /// OBJ. [`coface_algebra::ErrorKind::InvalidInput`] if the request is about loops on a surface that are not given as walks.
    ///
    /// # Complexity
    /// That of [`GroupsRequest::found`], whose work is done again.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GroupsRequest, Producer};
    /// let input = &b"[[0,1],[1,2],[0,2]]"[..];
    /// let rim = Producer::of(coface_io::read(input, coface_io::Format::Json)?)?;
    /// let request = GroupsRequest::new();
    /// let certificate = request.certificate(&request.found(&rim)?, &rim, &[("rim.json", input)])?;
    /// let verdict = coface_check_walks::check(certificate.as_bytes(), &[input]).expect("the proof holds");
    /// assert!(verdict.proved().contains(&"this group is Z".to_owned()));
    /// # Ok(()) }
    /// ```
    pub fn certificate(
        &self,
        found: &FoundGroups,
        producer: &Producer,
        inputs: &[(&str, &[u8])],
    ) -> Result<String, Error> {
        let [(name, _)] = inputs else {
            return Err(Error::invalid("a certificate of groups is of one input"));
        };
        if let (Some(walks), None) = (&self.walks, &self.short) {
            return self.walks_certificate(&walks.walks, found, producer, inputs);
        }
        if self.surface_loops != SurfaceLoops::Any || self.short.is_some() {
            return Err(Error::invalid("loops on a surface have no certificate")
                .with_cure("ask for the groups alone"));
        }
        let skeleton = producer.two_skeleton()?;
        let groups = self.edge_paths(producer, &skeleton)?;
        let certificate = Certificate {
            coface_certificate: coface_check::VERSION,
            coface: env!("CARGO_PKG_VERSION"),
            kind: "pi1",
            inputs: Input::list(inputs),
            answer: found.answer(name),
            proof: self.proof(&groups, &skeleton, producer)?,
        };
        checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
    }

    fn proof(
        &self,
        groups: &EdgePathGroups,
        skeleton: &TwoSkeleton,
        producer: &Producer,
    ) -> Result<Proof, Error> {
        let ends = skeleton.edge_ends();
        let number = |vertex: u32| producer.cell_vertices(0, CellId::new(vertex as usize))[0];
        let edge = |edge: usize| [2 * edge, 2 * edge + 1].map(|end| number(ends[end]));
        let around = |face: FaceId| {
            skeleton.faces().list(face.index()).iter().map(|&step| number(ends[step as usize])).collect()
        };
        let last =
            |vertex: usize| groups.path_to(VertexId::new(vertex)).last().map(|&(step, _)| edge(step.index()));
        let effort = Effort::new().time_limit(self.time_limit);
        let component = |i: usize| {
            let presentation = groups.presentation(i);
            let simpler = Simplification::new(presentation, effort);
            let moves = simpler.moves().iter().map(in_words);
            Ok(Component {
                generators: groups
                    .generator_edges(i)
                    .iter()
                    .map(|generator| edge(generator.index()))
                    .collect(),
                relators: presentation.relators().iter().map(Word::letters).map(<[i32]>::to_vec).collect(),
                moves: moves.collect::<Result<_, Error>>()?,
            })
        };
        Ok(Proof {
            tree: (0..skeleton.vertex_count()).filter_map(last).collect(),
            faces: groups.determining_faces().iter().map(|&face| around(face)).collect(),
            components: (0..groups.component_count()).map(component).collect::<Result<_, Error>>()?,
        })
    }
}

/// A move as the checker reads it.
fn in_words(step: &TietzeMove) -> Result<Value, Error> {
    Ok(match *step {
        TietzeMove::Duplicate { relator, like } => {
            json!({"move": "duplicate", "relator": relator, "like": like})
        }
        TietzeMove::Rewrite { relator, at, by, inverted, from, length } => json!({
            "move": "rewrite", "relator": relator, "at": at, "by": by, "inverted": inverted, "from": from, "length": length
        }),
        TietzeMove::Eliminate { generator, relator } => {
            json!({"move": "eliminate", "generator": generator, "relator": relator})
        }
        TietzeMove::Multiply { generator, letter, on_right } => {
            json!({"move": "multiply", "generator": generator, "letter": letter, "on_right": on_right})
        }
        _ => return Err(refused("a move has no rule")),
    })
}
