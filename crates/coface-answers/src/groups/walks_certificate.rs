//! Certificates of closed walks on a surface.

use super::surface::surface_trees;
use super::{FoundGroups, GroupsRequest, SurfaceLoops};
use crate::Producer;
use crate::answer::HomotopicAnswer;
use crate::homology::certificate::{Input, checked, refused};
use coface_algebra::{CellId, Error, FaceId, Word};
use coface_complexes::surface::GeneralizedMap;
use coface_topology::{EdgeRole, SurfaceHomotopy, TreeCotree};
use serde::Serialize;

/// A certificate of walks, as `docs/certificates.md` describes it.
#[derive(Serialize)]
struct Certificate<'a> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    walks: &'a [Vec<u32>],
    answer: HomotopicAnswer,
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

/// The group of a component; without generators of an isolated vertex.
#[derive(Default, Serialize)]
struct Component {
    /// The edges of the generators, in their directions.
    generators: Vec<[u32; 2]>,
    /// The word around the faces of a closed component, if it has generators.
    relators: Vec<Vec<i32>>,
    /// The generators of the answer in those of the edges, and the other way round.
    loops: Vec<Vec<i32>>,
    images: Vec<Vec<i32>>,
}

impl GroupsRequest {
    /// A certificate of walks that were compared.
    pub(super) fn walks_certificate(
        &self,
        walks: &[Vec<u32>],
        found: &FoundGroups,
        producer: &Producer,
        inputs: &[(&str, &[u8])],
    ) -> Result<String, Error> {
        let name = inputs.first().map_or("", |(name, _)| name);
        let answer = found.homotopic_answer(name);
        let answer =
            answer.ok_or_else(|| Error::invalid("a certificate of walks is of walks that were compared"))?;
        let map = GeneralizedMap::new(producer.two_skeleton()?)?;
        let numbers: Vec<u32> =
            (0..map.vertex_count()).map(|vertex| producer.cell_vertices(0, CellId::new(vertex))[0]).collect();
        let trees = surface_trees(self, &map, &numbers, None)?;
        let homotopy = SurfaceHomotopy::new(&map, &trees)?;
        let mut components: Vec<Component> = (0..trees.components().len())
            .map(|component| self.component(&map, &trees, &homotopy, component, &numbers))
            .collect();
        // Isolated vertices come last.
        components.resize_with(answer.components.len(), Component::default);
        let number = |end: u32| numbers[end as usize];
        let ends = map.skeleton().edge_ends();
        let roles = ends.chunks_exact(2).zip(trees.roles());
        let tree = roles
            .filter(|(_, role)| **role == EdgeRole::Tree)
            .map(|(ends, _)| [number(ends[0]), number(ends[1])]);
        let around = |face: FaceId| {
            map.skeleton()
                .faces()
                .list(face.index())
                .iter()
                .map(|&step| number(ends[step as usize]))
                .collect()
        };
        let certificate = Certificate {
            coface_certificate: coface_check::VERSION,
            coface: env!("CARGO_PKG_VERSION"),
            kind: "walks",
            inputs: Input::list(inputs),
            walks,
            answer,
            proof: Proof {
                tree: tree.collect(),
                faces: from_the_leaves(&map, &trees).into_iter().map(around).collect(),
                components,
            },
        };
        checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
    }

    fn component(
        &self,
        map: &GeneralizedMap,
        trees: &TreeCotree,
        homotopy: &SurfaceHomotopy<'_>,
        component: usize,
        numbers: &[u32],
    ) -> Component {
        let (edges, group) = (trees.components()[component].generators(), &homotopy.groups()[component]);
        let ends = map.skeleton().edge_ends();
        let edge = |edge: usize| [2 * edge, 2 * edge + 1].map(|end| numbers[ends[end] as usize]);
        let words = |words: &[Word]| words.iter().map(|word| word.letters().to_vec()).collect();
        let (loops, images) = match group.canonical_system() {
            Some(system) if self.surface_loops == SurfaceLoops::Canonical => {
                (words(system.generators()), words(system.images()))
            }
            _ => {
                let letters: Vec<Vec<i32>> = (1..=edges.len() as i32).map(|letter| vec![letter]).collect();
                (letters.clone(), letters)
            }
        };
        Component {
            generators: edges.iter().map(|generator| edge(generator.index())).collect(),
            relators: group.relator().into_iter().map(|relator| relator.letters().to_vec()).collect(),
            loops,
            images,
        }
    }
}

/// The faces that the cotree leaves by a side, each after those that enter it: then this side is the only one whose word is not known.
fn from_the_leaves(map: &GeneralizedMap, trees: &TreeCotree) -> Vec<FaceId> {
    let above = |face: FaceId| trees.exit(face).and_then(|side| map.mate(side)).map(|mate| map.face(mate));
    let faces = (0..map.face_count()).map(FaceId::new);
    let mut entering = vec![0u32; map.face_count()];
    faces.clone().filter_map(above).for_each(|face| entering[face.index()] += 1);
    let mut ready: Vec<FaceId> = faces.filter(|face| entering[face.index()] == 0).collect();
    let mut order = Vec::with_capacity(map.face_count());
    while let Some(face) = ready.pop() {
        if trees.exit(face).is_some() {
            order.push(face);
        }
        if let Some(above) = above(face) {
            entering[above.index()] -= 1;
            if entering[above.index()] == 0 {
                ready.push(above);
            }
        }
    }
    order
}
