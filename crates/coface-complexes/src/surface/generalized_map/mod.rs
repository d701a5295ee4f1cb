//! Generalized maps: surfaces with or without orientation, as polygons whose sides are glued in pairs.

mod double_cover;
mod gluing;
mod involutions;
mod slicing;

pub use double_cover::OrientationDoubleCover;
pub use gluing::Glued;
pub use slicing::{PathKind, Slice};

use super::{SurfaceComponent, SurfaceType};
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::progress::stage_of_many;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, Fault, HalfedgeId, VertexId};
use coface_algebra::{Sign, UnionFind};

/// A compact surface made of polygons whose sides are glued in pairs: orientable or not, with boundary or without,
/// connected or not.
///
/// It holds what a [`super::HalfedgeMesh`] cannot: the Moebius band, the Klein bottle, the projective plane. A **side**
/// is a halfedge of one face, named by a [`HalfedgeId`]; it runs along its edge or against it, as the rim of the face
/// does. Two sides on one edge are **mates**; a side on the boundary has none. Mates that run in opposite directions
/// **agree**. Cells may touch themselves. Vertices without edges are isolated points beside the surface.
///
/// # Conventions
/// The sides of a face are consecutive: side i is item i of `skeleton().faces()`. A **flag** is an end of a side: flag 2s
/// is the start of side s, flag 2s + 1 its end. The involutions of the generalized map, [`Self::alpha`], go to the other
/// end (0), to the neighboring side of the face at the same corner (1), and to the mate at the same vertex (2).
///
/// # References
/// P. Lienhardt, *Topological models for boundary representation: a comparison with n-dimensional generalized maps* (1991).
///
/// # Examples
/// The projective plane: a digon whose two sides are glued.
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_algebra::chains::TwoSkeleton;
/// use coface_complexes::surface::GeneralizedMap;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let digon = TwoSkeleton::new(1, vec![0, 0], RaggedArray::from_lists([[0, 0]]))?;
/// let plane = GeneralizedMap::new(digon)?;
/// assert_eq!(plane.surfaces()[0].to_string(), "projective plane");
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GeneralizedMap {
    skeleton: TwoSkeleton,
    face_of: Vec<u32>,
    /// The mate of each side; the side itself on the boundary.
    mates: Vec<u32>,
    /// The first side of each edge.
    first_sides: Vec<u32>,
}

/// How the faces of a surface can be turned.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FaceOrientation {
    signs: Vec<Sign>,
    components: Vec<u32>,
    conflicts: Vec<Option<EdgeId>>,
}

impl FaceOrientation {
    /// The sign of each face: minus if it is to be turned over so that it agrees with the first face of its component. In
    /// a component without orientation the signs agree along a spanning tree of its faces.
    pub fn signs(&self) -> &[Sign] {
        &self.signs
    }

    /// The number of the component that a face is in; components are numbered by their first faces.
    pub fn component(&self, face: FaceId) -> usize {
        self.components[face.index()] as usize
    }

    /// For each component an edge across which its faces cannot agree, if it is not orientable.
    pub fn conflicts(&self) -> &[Option<EdgeId>] {
        &self.conflicts
    }
}

impl GeneralizedMap {
    /// The surface with these vertices, edges and faces.
    ///
    /// # Errors
    /// [`ErrorKind::NonManifold`] for a face without sides, an edge in no face or on more than two sides of faces, and
    /// a vertex around which the faces are not one fan; the message names them. Of several faults the first in this
    /// order is named. [`ErrorKind::TooLarge`] from 2^31 sides on.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let map = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// assert_eq!(map.side_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn new(skeleton: TwoSkeleton) -> Result<Self, Error> {
        let count = skeleton.faces().item_count();
        if count >= 1 << 31 {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("{count} sides of faces; the limit is 2^31 - 1"),
            ));
        }
        let mut face_of = Vec::with_capacity(count);
        let steps = stage_of_many("walking around faces", skeleton.faces().len());
        for (face, rim) in steps.each(skeleton.faces().iter().enumerate()) {
            if rim.is_empty() {
                return Err(Error::new(
                    ErrorKind::NonManifold,
                    format!("face {} has no sides", FaceId::new(face)),
                )
                .with_cure("attach it along a closed path of edges"));
            }
            face_of.resize(face_of.len() + rim.len(), face as u32);
        }
        let (mates, first_sides) = mates(&skeleton, &face_of)?;
        let map = Self { skeleton, face_of, mates, first_sides };
        map.check_fans()?;
        Ok(map)
    }

    /// The vertices, edges and faces with their rims.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let map = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// assert_eq!(map.skeleton().edge_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn skeleton(&self) -> &TwoSkeleton {
        &self.skeleton
    }

    /// The number of vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let map = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// assert_eq!(map.vertex_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn vertex_count(&self) -> usize {
        self.skeleton.vertex_count()
    }

    /// The number of edges.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let map = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// assert_eq!(map.edge_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn edge_count(&self) -> usize {
        self.skeleton.edge_count()
    }

    /// The number of faces.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let map = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// assert_eq!(map.face_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn face_count(&self) -> usize {
        self.skeleton.face_count()
    }

    /// The numbers of vertices, edges and faces.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let map = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// assert_eq!(map.f_vector(), [1, 2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        self.skeleton.f_vector()
    }

    /// The number of sides of faces.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let map = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// assert_eq!(map.side_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn side_count(&self) -> usize {
        self.mates.len()
    }

    /// All sides.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let map = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// assert_eq!(map.sides().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn sides(&self) -> impl DoubleEndedIterator<Item = HalfedgeId> + ExactSizeIterator + Clone + use<> {
        (0..self.mates.len() as u32).map(HalfedgeId::from_u32)
    }

    /// The sides of a face in the order of its rim.
    ///
    /// # Panics
    /// If there is no such face. Likewise the functions that follow panic where there is no such side or flag.
    pub fn sides_of(
        &self,
        face: FaceId,
    ) -> impl DoubleEndedIterator<Item = HalfedgeId> + ExactSizeIterator + Clone + use<> {
        let faces = self.skeleton.faces();
        let start = faces.start(face.index()) as u32;
        (start..start + faces.list(face.index()).len() as u32).map(HalfedgeId::from_u32)
    }

    /// The face of a side.
    pub fn face(&self, side: HalfedgeId) -> FaceId {
        FaceId::from_u32(self.face_of[side.index()])
    }

    /// The step of a side: 2e if it runs along edge e, 2e + 1 if against it.
    pub fn step(&self, side: HalfedgeId) -> u32 {
        self.skeleton.faces().items()[side.index()]
    }

    /// The edge of a side.
    pub fn edge(&self, side: HalfedgeId) -> EdgeId {
        EdgeId::from_u32(self.step(side) >> 1)
    }

    /// The vertex where a side starts.
    pub fn source(&self, side: HalfedgeId) -> VertexId {
        VertexId::from_u32(self.skeleton.edge_ends()[self.step(side) as usize])
    }

    /// The vertex where a side ends.
    pub fn target(&self, side: HalfedgeId) -> VertexId {
        VertexId::from_u32(self.skeleton.edge_ends()[(self.step(side) ^ 1) as usize])
    }

    /// The side after this one on the rim of its face.
    pub fn next(&self, side: HalfedgeId) -> HalfedgeId {
        let (face, after) = (self.face_of[side.index()], side.index() + 1);
        if self.face_of.get(after) == Some(&face) {
            return HalfedgeId::new(after);
        }
        HalfedgeId::new(self.skeleton.faces().start(face as usize))
    }

    /// The side before this one on the rim of its face.
    pub fn previous(&self, side: HalfedgeId) -> HalfedgeId {
        let face = self.face_of[side.index()] as usize;
        let faces = self.skeleton.faces();
        let start = faces.start(face);
        HalfedgeId::new(if side.index() > start {
            side.index() - 1
        } else {
            start + faces.list(face).len() - 1
        })
    }

    /// The other side on the same edge; `None` on the boundary.
    pub fn mate(&self, side: HalfedgeId) -> Option<HalfedgeId> {
        let mate = self.mates[side.index()];
        (mate != side.to_u32()).then_some(HalfedgeId::from_u32(mate))
    }

    /// The first side of an edge; the second one, if there is one, is its mate.
    pub fn first_side(&self, edge: EdgeId) -> HalfedgeId {
        HalfedgeId::from_u32(self.first_sides[edge.index()])
    }

    /// Whether a side and its mate run in opposite directions, so that their faces agree there. A side on the boundary
    /// agrees.
    pub fn agrees(&self, side: HalfedgeId) -> bool {
        let mate = self.mates[side.index()];
        mate == side.to_u32() || (self.step(side) ^ self.step(HalfedgeId::from_u32(mate))) & 1 == 1
    }

    /// Involution `index` of the generalized map: 0 goes to the other end of the side, 1 to the neighboring side at the
    /// same corner of the face, 2 to the mate at the same vertex (and stays on the boundary).
    ///
    /// # Panics
    /// If `index` is above 2 or there is no such flag.
    pub fn alpha(&self, index: usize, flag: u32) -> u32 {
        let (side, end) = (HalfedgeId::from_u32(flag >> 1), flag & 1);
        match index {
            0 => flag ^ 1,
            1 if end == 0 => self.previous(side).to_u32() << 1 | 1,
            1 => self.next(side).to_u32() << 1,
            2 => match self.mate(side) {
                None => flag,
                Some(mate) => mate.to_u32() << 1 | (end ^ u32::from(self.agrees(side))),
            },
            _ => panic!("a surface has the involutions 0, 1 and 2, not {index}"),
        }
    }

    /// The vertex of a flag.
    pub fn flag_vertex(&self, flag: u32) -> VertexId {
        let side = HalfedgeId::from_u32(flag >> 1);
        if flag & 1 == 0 { self.source(side) } else { self.target(side) }
    }

    /// The flags around a vertex, one fan after the other side by side: flag, its image under 1, the image of that under 2,
    /// and so on. On the boundary they start there; a closed fan starts with the flag that is given.
    pub fn fan(&self, flag: u32) -> Vec<u32> {
        let mut first = flag;
        // Walk back to the boundary, or all around.
        loop {
            let across = self.alpha(2, first);
            if across == first {
                break;
            }
            first = self.alpha(1, across);
            if first == flag {
                break;
            }
        }
        let mut flags = Vec::new();
        let mut at = first;
        loop {
            let turned = self.alpha(1, at);
            flags.extend([at, turned]);
            let across = self.alpha(2, turned);
            if across == turned || across == first {
                return flags;
            }
            at = across;
        }
    }

    /// Visits the flags of the fan that a flag is in, each once: first one way around its vertex, then, if the fan is not
    /// closed, the other way. Fans end at the boundary and at sides where `is_wall` holds.
    fn walk_fan(&self, flag: u32, is_wall: impl Fn(HalfedgeId) -> bool, mut visit: impl FnMut(u32)) {
        visit(flag);
        for first in [1, 2] {
            let (mut at, mut index) = (flag, first);
            loop {
                let after = self.alpha(index, at);
                if after == at || (index == 2 && is_wall(HalfedgeId::from_u32(at >> 1))) {
                    break;
                }
                if after == flag {
                    return;
                }
                visit(after);
                (at, index) = (after, 3 - index);
            }
        }
    }

    /// Which faces must be turned over so that all agree, and where that cannot be.
    ///
    /// # Complexity
    /// Linear: breadth-first search over the faces.
    pub fn orientation(&self) -> FaceOrientation {
        const UNSEEN: u32 = u32::MAX;
        let face_count = self.skeleton.face_count();
        let mut signs = vec![Sign::Plus; face_count];
        let mut components = vec![UNSEEN; face_count];
        let mut conflicts = Vec::new();
        let mut queue = Vec::new();
        for first in 0..face_count {
            if components[first] != UNSEEN {
                continue;
            }
            let component = conflicts.len() as u32;
            conflicts.push(None);
            components[first] = component;
            queue.push(first as u32);
            let mut at = 0;
            while at < queue.len() {
                let face = queue[at] as usize;
                at += 1;
                for side in self.sides_of(FaceId::new(face)) {
                    let Some(mate) = self.mate(side) else { continue };
                    let relative = if self.agrees(side) { Sign::Plus } else { Sign::Minus };
                    let (other, sign) = (self.face(mate).index(), signs[face].times(relative));
                    if components[other] == UNSEEN {
                        components[other] = component;
                        signs[other] = sign;
                        queue.push(other as u32);
                    } else if signs[other] != sign {
                        conflicts[component as usize].get_or_insert(self.edge(side));
                    }
                }
            }
            queue.clear();
        }
        FaceOrientation { signs, components, conflicts }
    }

    /// The loops of boundary sides, each in the order of a walk around its hole; the walk starts with the smallest side
    /// and in its direction. A side whose direction is against the walk has the sign minus.
    ///
    /// # Complexity
    /// Linear in the corners at the boundary.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let map = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// assert!(map.boundary_loops().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn boundary_loops(&self) -> Vec<Vec<(HalfedgeId, Sign)>> {
        let mut seen = vec![false; self.side_count()];
        let mut loops = Vec::new();
        for side in self.sides() {
            if self.mate(side).is_some() || seen[side.index()] {
                continue;
            }
            let mut walk = Vec::new();
            let mut flag = side.to_u32() << 1;
            loop {
                let (at, sign) =
                    (HalfedgeId::from_u32(flag >> 1), Sign::power_of_minus_one((flag & 1) as usize));
                if std::mem::replace(&mut seen[at.index()], true) {
                    break;
                }
                walk.push((at, sign));
                // From the far end of the side through the fan to the next side of the boundary.
                flag = *self.fan(flag ^ 1).last().expect("a fan has flags");
            }
            loops.push(walk);
        }
        loops
    }

    /// Which surface each component is, in the order of the first faces. Isolated vertices are no components here.
    ///
    /// # Complexity
    /// Near-linear.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let map = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// assert_eq!(map.surfaces()[0].genus(), 1);
    /// # Ok(()) }
    /// ```
    pub fn surfaces(&self) -> Vec<SurfaceType> {
        let components = self.surface_components().into_iter();
        components.map(|component| component.surface().expect("a map is a surface")).collect()
    }

    /// The components with their counts, in the order of the first faces. Isolated vertices are no components here.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let map = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// assert_eq!(map.surface_components()[0].euler_characteristic(), 0);
    /// # Ok(()) }
    /// ```
    pub fn surface_components(&self) -> Vec<SurfaceComponent> {
        let orientation = self.orientation();
        let count = orientation.conflicts.len();
        let (mut f_vectors, mut holes) = (vec![[0; 3]; count], vec![0; count]);
        for &component in &orientation.components {
            f_vectors[component as usize][2] += 1;
        }
        for &side in &self.first_sides {
            f_vectors[orientation.component(self.face(HalfedgeId::from_u32(side)))][1] += 1;
        }
        let mut seen = vec![false; self.skeleton.vertex_count()];
        for side in self.sides() {
            let is_new = !std::mem::replace(&mut seen[self.source(side).index()], true);
            f_vectors[orientation.component(self.face(side))][0] += usize::from(is_new);
        }
        for hole in self.boundary_loops() {
            holes[orientation.component(self.face(hole[0].0))] += 1;
        }
        (0..count)
            .map(|i| SurfaceComponent::of_surface(f_vectors[i], holes[i], orientation.conflicts[i].is_none()))
            .collect()
    }

    /// The arc of the dual graph that crosses an edge: the faces on its first and on its second side, which can be the same
    /// face. `None` on the boundary.
    pub fn dual_arc(&self, edge: EdgeId) -> Option<[FaceId; 2]> {
        let side = self.first_side(edge);
        Some([self.face(side), self.face(self.mate(side)?)])
    }

    /// The number of components; each isolated vertex is one.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let map = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// assert_eq!(map.component_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn component_count(&self) -> usize {
        let mut partition = UnionFind::new(self.skeleton.vertex_count());
        for &[a, b] in self.skeleton.edge_ends().as_chunks::<2>().0 {
            partition.unite(a, b);
        }
        partition.class_count()
    }

    /// Checks that the faces at each vertex are one fan.
    fn check_fans(&self) -> Result<(), Error> {
        let mut seen = vec![false; 2 * self.side_count()];
        let mut has_fan = vec![false; self.skeleton.vertex_count()];
        for flag in 0..2 * self.side_count() as u32 {
            if seen[flag as usize] {
                continue;
            }
            let vertex = self.flag_vertex(flag);
            if std::mem::replace(&mut has_fan[vertex.index()], true) {
                return Err(self.several_fans(vertex));
            }
            self.walk_fan(flag, |_| false, |member| seen[member as usize] = true);
        }
        Ok(())
    }

    fn several_fans(&self, vertex: VertexId) -> Error {
        let mut seen = vec![false; 2 * self.side_count()];
        let (mut fans, mut named): (Vec<Vec<FaceId>>, Vec<String>) = (Vec::new(), Vec::new());
        for flag in 0..2 * self.side_count() as u32 {
            if seen[flag as usize] || self.flag_vertex(flag) != vertex {
                continue;
            }
            let fan = self.fan(flag);
            for &member in &fan {
                seen[member as usize] = true;
            }
            let faces: Vec<FaceId> =
                fan.iter().step_by(2).map(|&f| self.face(HalfedgeId::from_u32(f >> 1))).collect();
            let more = if faces.len() > 8 { " .." } else { "" };
            let names: Vec<String> = faces.iter().take(8).map(FaceId::to_string).collect();
            named.push(format!("{}{more}", names.join(" ")));
            fans.push(faces);
        }
        Error::new(
            ErrorKind::NonManifold,
            format!("{} fans of faces meet at vertex {vertex} only: {}", fans.len(), named.join(" | ")),
        )
        .with_cells([[vertex.to_u32()]])
        .with_fault(Fault::VertexWithFans { vertex, fans })
        .with_cure("split the vertex first")
    }
}

/// The mate of each side, the side itself where there is none; and the first side of each edge.
fn mates(skeleton: &TwoSkeleton, face_of: &[u32]) -> Result<(Vec<u32>, Vec<u32>), Error> {
    const NONE: u32 = u32::MAX;
    let steps = skeleton.faces().items();
    let mut first = vec![NONE; skeleton.edge_count()];
    let mut mates: Vec<u32> = (0..steps.len() as u32).collect();
    let mut branching = None;
    for (side, &step) in steps.iter().enumerate() {
        let earlier = &mut first[(step >> 1) as usize];
        if *earlier == NONE {
            *earlier = side as u32;
        } else if mates[*earlier as usize] == *earlier {
            mates[side] = *earlier;
            mates[*earlier as usize] = side as u32;
        } else {
            branching = branching.or(Some(step >> 1));
        }
    }
    // Loose edges are named first: what removes them also splits the others.
    match (first.iter().position(|&side| side == NONE), branching) {
        (None, None) => Ok((mates, first)),
        (None, Some(edge)) => Err(many_faces(skeleton, face_of, edge)),
        (Some(edge), _) => {
            let [a, b] = skeleton.edge(EdgeId::new(edge));
            Err(Error::new(
                ErrorKind::NonManifold,
                format!("edge {} = {{{a}, {b}}} lies in no face", EdgeId::new(edge)),
            )
            .with_cells([[a.to_u32(), b.to_u32()]])
            .with_fault(Fault::EdgeInFaces { edge: [a, b], faces: Vec::new() })
            .with_cure("remove the loose edge"))
        }
    }
}

fn many_faces(skeleton: &TwoSkeleton, face_of: &[u32], edge: u32) -> Error {
    let sides = skeleton.faces().items().iter().enumerate().filter(|&(_, &step)| step >> 1 == edge);
    let faces: Vec<FaceId> = sides.map(|(side, _)| FaceId::from_u32(face_of[side])).collect();
    let names: Vec<String> = faces.iter().take(8).map(FaceId::to_string).collect();
    let edge = EdgeId::from_u32(edge);
    let [a, b] = skeleton.edge(edge);
    let more = if faces.len() > 8 { ", .." } else { "" };
    Error::new(
        ErrorKind::NonManifold,
        format!(
            "edge {edge} = {{{a}, {b}}} is on {} sides of faces: {}{more}",
            faces.len(),
            names.join(", ")
        ),
    )
    .with_cells([[a.to_u32(), b.to_u32()]])
    .with_fault(Fault::EdgeInFaces { edge: [a, b], faces })
    .with_cure("a surface has at most two there; split the edge first")
}

#[cfg(any(test, feature = "samples"))]
#[doc(hidden)]
pub mod samples;
#[cfg(test)]
mod tests;
