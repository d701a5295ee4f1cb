//! Edges and vertices of the faces: which faces meet in them, and in how many pieces.

use super::CheckedFaces;
use super::rings::Points;
use coface_algebra::{ParityUnionFind, Sign, UnionFind};
use rayon::prelude::*;

/// A side of a face along an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Use {
    /// The nodes at the ends of the edge, the smaller first.
    pub(super) ends: [u32; 2],
    /// The corner where the side begins.
    pub(super) corner: u32,
    /// The corner where it ends.
    pub(super) next: u32,
    pub(super) face: u32,
}

/// The incidences of faces: by **nodes**, which are vertices that count as one, and **corners**, the positions in the
/// list of all rings.
pub(super) struct Incidence {
    pub(super) node_of_corner: Vec<u32>,
    pub(super) face_of_corner: Vec<u32>,
    pub(super) uses: Vec<Use>,
    /// The shell of each face, and how many there are.
    pub(super) shell_of_face: Vec<u32>,
    pub(super) shell_count: usize,
    /// The pieces of each shell that is given; one for each component.
    pub(super) pieces_of_shell: Vec<u32>,
    /// Whether the node is a vertex of the file, and not several that were joined.
    pub(super) is_joined: bool,
}

/// The face of each corner.
fn faces_of_corners(faces: &CheckedFaces) -> Vec<u32> {
    let mut face_of_corner = Vec::with_capacity(faces.rings().item_count());
    for face in 0..faces.face_count() {
        for ring in faces.rings_of_face(face) {
            face_of_corner.resize(face_of_corner.len() + faces.rings().list(ring).len(), face as u32);
        }
    }
    face_of_corner
}

impl Incidence {
    /// Of all faces but some that have no ring.
    ///
    /// In shells that are given, vertices at one place are one node. Else a vertex is a node, and only in components
    /// that are open vertices at one place are one: so what touches itself in a split vertex stays apart, and surfaces
    /// whose faces each have vertices of their own close.
    pub(super) fn new(points: &Points<'_>, faces: &CheckedFaces, without_ring: &[u32]) -> Self {
        let face_of_corner = faces_of_corners(faces);
        let items = faces.rings().items();
        let mut is_left_out = vec![false; faces.face_count()];
        without_ring.iter().for_each(|&face| is_left_out[face as usize] = true);
        if let Some(shell_of_face) = faces.shell_of_face() {
            let key = |corner: usize| {
                let shell = shell_of_face[face_of_corner[corner] as usize];
                (u64::from(shell) << 32) | u64::from(points.place[items[corner] as usize])
            };
            let mut keys: Vec<u64> = (0..items.len()).map(key).collect();
            keys.par_sort_unstable();
            keys.dedup();
            let node = |corner| keys.binary_search(&key(corner)).expect("each key is listed") as u32;
            let node_of_corner: Vec<u32> = (0..items.len()).map(node).collect();
            let uses = uses(faces, &node_of_corner, &face_of_corner, &is_left_out);
            let component = components(&uses, &face_of_corner, &node_of_corner, keys.len());
            let mut pairs: Vec<[u32; 2]> = (0..faces.face_count())
                .filter(|&face| !is_left_out[face])
                .map(|face| [shell_of_face[face], component[face]])
                .collect();
            pairs.sort_unstable();
            pairs.dedup();
            let shell_count = faces.solid_of_shell().len();
            let mut pieces_of_shell = vec![0; shell_count];
            pairs.iter().for_each(|pair| pieces_of_shell[pair[0] as usize] += 1);
            let shell_of_face = shell_of_face.to_vec();
            return Self {
                node_of_corner,
                face_of_corner,
                uses,
                shell_of_face,
                shell_count,
                pieces_of_shell,
                is_joined: true,
            };
        }
        let vertex_count = points.place.len();
        let mut node_of_corner = items.to_vec();
        let mut uses = uses(faces, &node_of_corner, &face_of_corner, &is_left_out);
        let mut component = components(&uses, &face_of_corner, &node_of_corner, vertex_count);
        let mut is_open = vec![false; faces.face_count()];
        edges(&uses).filter(|own| own.len() == 1).for_each(|own| {
            is_open[component[own[0].face as usize] as usize] = true;
        });
        let mut is_joined = false;
        for (corner, node) in node_of_corner.iter_mut().enumerate() {
            let face = face_of_corner[corner] as usize;
            let place = points.place[*node as usize];
            if place != *node && is_open[component[face] as usize] {
                is_joined = true;
            }
        }
        if is_joined {
            for (corner, node) in node_of_corner.iter_mut().enumerate() {
                if is_open[component[face_of_corner[corner] as usize] as usize] {
                    *node = vertex_count as u32 + points.place[*node as usize];
                }
            }
            uses = self::uses(faces, &node_of_corner, &face_of_corner, &is_left_out);
            component = components(&uses, &face_of_corner, &node_of_corner, 2 * vertex_count);
        }
        // Components are named by their first faces; shells are numbered.
        let mut number = vec![u32::MAX; faces.face_count()];
        let mut shell_count = 0;
        let mut shell_of_face = vec![u32::MAX; faces.face_count()];
        for face in (0..faces.face_count()).filter(|&face| !is_left_out[face]) {
            let own = &mut number[component[face] as usize];
            if *own == u32::MAX {
                *own = shell_count;
                shell_count += 1;
            }
            shell_of_face[face] = *own;
        }
        let pieces_of_shell = vec![1; shell_count as usize];
        Self {
            node_of_corner,
            face_of_corner,
            uses,
            shell_of_face,
            shell_count: shell_count as usize,
            pieces_of_shell,
            is_joined,
        }
    }

    /// The edges, each with the sides along it.
    pub(super) fn edges(&self) -> impl Iterator<Item = &[Use]> {
        edges(&self.uses)
    }

    /// The nodes around which faces form several fans, rising, each with a corner of it.
    pub(super) fn pinched_nodes(&self, faces: &CheckedFaces) -> Vec<[u32; 2]> {
        let mut fans = UnionFind::new(self.node_of_corner.len());
        for own in self.edges() {
            for pair in own.windows(2) {
                // The corners of both sides at each of the two ends.
                let ends = pair.iter().map(|side| self.corners_at_ends(side));
                let [first, second] = [ends.clone().next(), ends.clone().nth(1)];
                if let (Some(first), Some(second)) = (first, second) {
                    fans.unite(first[0], second[0]);
                    fans.unite(first[1], second[1]);
                }
            }
        }
        // A corner of a side is also that of the side before it; corners in a run at one node are one.
        for ring in 0..faces.rings().len() {
            let (start, length) = (faces.rings().start(ring), faces.rings().list(ring).len());
            for i in 0..length {
                let (corner, next) = (start + i, start + (i + 1) % length);
                if self.node_of_corner[corner] == self.node_of_corner[next] && corner != next {
                    fans.unite(corner as u32, next as u32);
                }
            }
        }
        let mut is_used = vec![false; self.node_of_corner.len()];
        for side in &self.uses {
            is_used[side.corner as usize] = true;
            is_used[side.next as usize] = true;
        }
        let mut roots: Vec<[u32; 2]> = (0..self.node_of_corner.len() as u32)
            .filter(|&corner| is_used[corner as usize])
            .map(|corner| [self.node_of_corner[corner as usize], fans.find(corner)])
            .collect();
        roots.par_sort_unstable();
        roots.dedup();
        let mut pinched: Vec<[u32; 2]> =
            roots.windows(2).filter(|pair| pair[0][0] == pair[1][0]).map(|pair| pair[0]).collect();
        pinched.dedup_by_key(|pair| pair[0]);
        pinched
    }

    /// The corners of a side at the smaller and the larger node.
    fn corners_at_ends(&self, side: &Use) -> [u32; 2] {
        if self.node_of_corner[side.corner as usize] == side.ends[0] {
            [side.corner, side.next]
        } else {
            [side.next, side.corner]
        }
    }

    /// Whether a side runs from the smaller node to the larger.
    pub(super) fn runs_up(&self, side: &Use) -> bool {
        self.node_of_corner[side.corner as usize] == side.ends[0]
    }

    /// For each face its direction against that of the first face of its shell, across edges of two faces; and for each
    /// shell whether no edge contradicts that.
    pub(super) fn directions(&self, face_count: usize) -> (Vec<Sign>, Vec<bool>) {
        let mut parts = ParityUnionFind::new(face_count);
        let mut is_two_sided = vec![true; self.shell_count];
        for own in self.edges() {
            if let [a, b] = own
                && a.face != b.face
            {
                let relative = if self.runs_up(a) == self.runs_up(b) { Sign::Minus } else { Sign::Plus };
                if parts.unite(a.face, b.face, relative) == coface_algebra::ParityUnion::Contradicts {
                    is_two_sided[self.shell_of_face[a.face as usize] as usize] = false;
                }
            }
        }
        ((0..face_count as u32).map(|face| parts.find(face).1).collect(), is_two_sided)
    }
}

fn edges(uses: &[Use]) -> impl Iterator<Item = &[Use]> {
    uses.chunk_by(|a, b| a.ends == b.ends)
}

/// The sides of all faces, edge after edge. Sides of one face that lie on each other, as those of a bridge to a hole,
/// cancel.
fn uses(
    faces: &CheckedFaces,
    node_of_corner: &[u32],
    face_of_corner: &[u32],
    is_left_out: &[bool],
) -> Vec<Use> {
    let mut uses: Vec<Use> = Vec::with_capacity(node_of_corner.len());
    for ring in 0..faces.rings().len() {
        let (start, length) = (faces.rings().start(ring), faces.rings().list(ring).len());
        for i in 0..length {
            let (corner, next) = (start + i, start + (i + 1) % length);
            let face = face_of_corner[corner];
            let [a, b] = [corner, next].map(|corner| node_of_corner[corner]);
            if a != b && !is_left_out[face as usize] {
                let ends = [a.min(b), a.max(b)];
                uses.push(Use { ends, corner: corner as u32, next: next as u32, face });
            }
        }
    }
    uses.par_sort_unstable();
    let runs_up = |side: &Use| node_of_corner[side.corner as usize] == side.ends[0];
    let is_doubled = |own: &[Use]| {
        own.len() > 1 && (1..own.len()).any(|i| own[..i].iter().any(|other| other.face == own[i].face))
    };
    if edges(&uses).any(is_doubled) {
        let mut kept = Vec::with_capacity(uses.len());
        for own in edges(&uses) {
            let mut rest: Vec<Use> = Vec::new();
            for side in own {
                let opposite = |other: &Use| other.face == side.face && runs_up(other) != runs_up(side);
                match rest.iter().position(opposite) {
                    Some(at) => drop(rest.remove(at)),
                    None => rest.push(*side),
                }
            }
            kept.append(&mut rest);
        }
        uses = kept;
    }
    uses
}

/// The component of each face, by a face of it; faces are connected by common nodes.
fn components(uses: &[Use], face_of_corner: &[u32], node_of_corner: &[u32], node_count: usize) -> Vec<u32> {
    let face_count = face_of_corner.last().map_or(0, |&last| last as usize + 1);
    let mut parts = UnionFind::new(node_count);
    let mut first_node = vec![u32::MAX; face_count];
    for side in uses {
        parts.unite(side.ends[0], side.ends[1]);
    }
    for (corner, &face) in face_of_corner.iter().enumerate() {
        let first = &mut first_node[face as usize];
        if *first == u32::MAX {
            *first = node_of_corner[corner];
        } else {
            // The holes of a face belong to it.
            parts.unite(*first, node_of_corner[corner]);
        }
    }
    let mut first_face = vec![u32::MAX; node_count];
    let mut component = Vec::with_capacity(face_count);
    for (face, &node) in first_node.iter().enumerate() {
        if node == u32::MAX {
            component.push(face as u32);
            continue;
        }
        let first = &mut first_face[parts.find(node) as usize];
        if *first == u32::MAX {
            *first = face as u32;
        }
        component.push(*first);
    }
    component
}
