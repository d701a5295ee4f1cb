//! Slicing: surfaces cut open along edges, with the way back.

use super::GeneralizedMap;
use coface_algebra::Sign;
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::{EdgeId, Error, ErrorKind, HalfedgeId, IdVec, VertexId};

/// A surface cut open along edges, and what its cells are copies of.
///
/// Each edge of the cut becomes two edges on the boundary, one on its **left** and one on its **right**; each vertex gets
/// a copy for each fan that its faces fall into. Faces and their sides stay as they are.
///
/// # Conventions
/// Of the two sides of a cut edge the one that runs along the edge keeps its number, and of two that run alike the first.
/// The other side gets a copy of the edge, which points as the edge does; copies are numbered on in the order of the
/// edges. Of the fans at a vertex the one with the first corner, in the order of the sides of faces, keeps the number of
/// the vertex; the others are numbered on in the order of their first corners.
///
/// Gluing each left side to its right side again gives the surface that was cut, with the same numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Slice<S> {
    surface: S,
    vertex_sources: IdVec<VertexId, VertexId>,
    edge_sources: IdVec<EdgeId, EdgeId>,
    left: Vec<HalfedgeId>,
    right: Vec<HalfedgeId>,
    path: Option<PathKind>,
}

/// What sort of edge path a surface was cut along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PathKind {
    /// It starts and ends at different vertices.
    Open,
    /// It is closed and has a left side all around.
    TwoSided,
    /// It is closed, and its left side comes back as its right side: a band around it is a Moebius band.
    OneSided,
}

impl<S> Slice<S> {
    /// The surface that was cut open.
    pub fn surface(&self) -> &S {
        &self.surface
    }

    /// The surface that was cut open, given away.
    pub fn into_surface(self) -> S {
        self.surface
    }

    /// For each vertex the vertex that it is, or is a copy of.
    pub fn vertex_sources(&self) -> &IdVec<VertexId, VertexId> {
        &self.vertex_sources
    }

    /// For each edge the edge that it is, or is a copy of.
    pub fn edge_sources(&self) -> &IdVec<EdgeId, EdgeId> {
        &self.edge_sources
    }

    /// The sides on the left of the cut, all of them on the boundary now: of a path, step by step; of a set of edges, those
    /// that keep the number of the edge, by rising edge. In a halfedge mesh: the halfedges with a face on their left.
    pub fn left(&self) -> &[HalfedgeId] {
        &self.left
    }

    /// The sides on the right of the cut, in the same order.
    pub fn right(&self) -> &[HalfedgeId] {
        &self.right
    }

    /// What sort of path the cut ran along; `None` for a set of edges.
    pub fn path_kind(&self) -> Option<PathKind> {
        self.path
    }

    /// The same slice of another form of the surface, with its names of the sides.
    pub(in crate::surface) fn map<T>(
        self,
        surface: impl FnOnce(S) -> T,
        side: impl Fn(&S, HalfedgeId) -> HalfedgeId,
    ) -> Slice<T> {
        let renamed = |sides: Vec<HalfedgeId>| sides.into_iter().map(|s| side(&self.surface, s)).collect();
        let (left, right) = (renamed(self.left), renamed(self.right));
        Slice {
            surface: surface(self.surface),
            vertex_sources: self.vertex_sources,
            edge_sources: self.edge_sources,
            left,
            right,
            path: self.path,
        }
    }
}

impl GeneralizedMap {
    /// The surface cut open along a set of edges. Edges on the boundary are open already and are passed over.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] naming an edge that does not exist; [`ErrorKind::TooLarge`] from 2^31 edges on.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// The square torus cut along both of its edges is the square.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?;
    /// let square = GeneralizedMap::new(torus)?.slice_edges(&[EdgeId::new(0), EdgeId::new(1)])?;
    /// assert_eq!(square.surface().f_vector(), [4, 4, 1]);
    /// assert_eq!(square.surface().surfaces()[0].to_string(), "disk");
    /// # Ok(()) }
    /// ```
    pub fn slice_edges(&self, edges: &[EdgeId]) -> Result<Slice<Self>, Error> {
        let mut is_cut = vec![false; self.skeleton().edge_count()];
        for &edge in edges {
            *is_cut.get_mut(edge.index()).ok_or_else(|| self.no_edge(edge))? = true;
        }
        self.slice_set(&is_cut)
    }

    /// The surface cut open along an edge path, given by its steps: 2e along edge e, 2e + 1 against it. A path inside
    /// becomes a slit; a closed path becomes two boundary loops if it has two sides and one if it is one-sided, see
    /// [`Slice::path_kind`]; where a path touches the boundary, its slit opens into that.
    ///
    /// The left side of a step is the side that runs as the step does, its face turned as [`super::FaceOrientation::signs`]
    /// says. On a component that is not orientable the left is so told at the first step, by the first side of its edge,
    /// and carried along the path.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] when the steps are no path, or one of them lies on the boundary, or an edge is there
    /// twice, or a vertex that is not both the start and the end; [`ErrorKind::NotInComplex`] for an edge that does
    /// not exist. Each names the step. A set of edges that is no such path can be cut by [`Self::slice_edges`].
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// The line of the projective plane is one-sided, and cutting along it leaves a disk.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// use coface_complexes::surface::{GeneralizedMap, PathKind};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let digon = TwoSkeleton::new(1, vec![0, 0], RaggedArray::from_lists([[0, 0]]))?;
    /// let plane = GeneralizedMap::new(digon)?;
    /// let disk = plane.slice_path(&[0])?;
    /// assert_eq!(disk.path_kind(), Some(PathKind::OneSided));
    /// assert_eq!(disk.surface().surfaces()[0].to_string(), "disk");
    /// assert!(plane.slice_cycle(&[0]).unwrap_err().message().contains("one-sided"));
    /// # Ok(()) }
    /// ```
    pub fn slice_path(&self, steps: &[u32]) -> Result<Slice<Self>, Error> {
        let is_closed = self.check_path(steps)?;
        let left = self.left_sides(steps, is_closed);
        let kind = match is_closed {
            false => PathKind::Open,
            true if left.last() == left.first() => PathKind::TwoSided,
            true => PathKind::OneSided,
        };
        let mut is_cut = vec![false; self.skeleton().edge_count()];
        for &step in steps {
            is_cut[(step >> 1) as usize] = true;
        }
        let mut slice = self.slice_set(&is_cut)?;
        slice.left = left[..steps.len()].to_vec();
        slice.right =
            slice.left.iter().map(|&side| self.mate(side).expect("a path to cut lies inside")).collect();
        slice.path = Some(kind);
        Ok(slice)
    }

    /// The surface cut open along a closed path with two sides, as [`Self::slice_path`] does it: a cycle that does not touch
    /// the boundary becomes two boundary loops.
    ///
    /// # Errors
    /// Those of [`Self::slice_path`], and [`ErrorKind::InvalidInput`] for a path that is not closed or is one-sided.
    ///
    /// # Complexity
    /// Linear.
    pub fn slice_cycle(&self, steps: &[u32]) -> Result<Slice<Self>, Error> {
        let slice = self.slice_path(steps)?;
        let ends = self.skeleton().edge_ends();
        let start = VertexId::from_u32(ends[steps[0] as usize]);
        match slice.path {
            Some(PathKind::TwoSided) => Ok(slice),
            Some(PathKind::OneSided) => Err(Error::invalid(format!(
                "the closed path of {} steps from {start} by {} is one-sided: its left side comes back as its right side, so cutting along it opens one boundary loop and not two",
                steps.len(),
                VertexId::from_u32(ends[(steps[0] ^ 1) as usize])
            ))
            .with_cure("cut along it as a path, or take a two-sided cycle")),
            _ => {
                let end = VertexId::from_u32(ends[(steps[steps.len() - 1] ^ 1) as usize]);
                Err(Error::invalid(format!("the path starts at {start} and ends at {end}, so it is no cycle"))
                    .with_cure("close it, or cut along it as a path"))
            }
        }
    }

    /// Cuts all these edges; those on the boundary are passed over.
    fn slice_set(&self, is_cut: &[bool]) -> Result<Slice<Self>, Error> {
        let skeleton = self.skeleton();
        let (vertex_count, edge_count) = (skeleton.vertex_count(), skeleton.edge_count());
        // The side that keeps the number of a cut edge, and that which gets a copy, by rising edge.
        let mut pairs: Vec<(EdgeId, HalfedgeId, HalfedgeId)> = Vec::new();
        for edge in (0..edge_count).filter(|&edge| is_cut[edge]).map(EdgeId::new) {
            let side = self.first_side(edge);
            let Some(mate) = self.mate(side) else { continue };
            let runs_against = |side| self.step(side) & 1 == 1;
            let mate_keeps = runs_against(side) && !runs_against(mate);
            pairs.push(if mate_keeps { (edge, mate, side) } else { (edge, side, mate) });
        }
        if edge_count + pairs.len() >= 1 << 31 {
            return Err(Error::new(ErrorKind::TooLarge, "a surface has fewer than 2^31 edges"));
        }
        let mut edge_sources: IdVec<EdgeId, EdgeId> = (0..edge_count).map(EdgeId::new).collect();
        let mut faces = skeleton.faces().clone();
        for &(edge, _, right) in &pairs {
            let copy = edge_sources.push(edge);
            faces.items_mut()[right.index()] = 2 * copy.to_u32() + (self.step(right) & 1);
        }
        let (copies, sources) = self.fans_between(is_cut);
        let mut vertex_sources: IdVec<VertexId, VertexId> = (0..vertex_count).map(VertexId::new).collect();
        for source in sources {
            vertex_sources.push(source);
        }
        let mut ends = skeleton.edge_ends().to_vec();
        ends.resize(2 * edge_sources.len(), 0);
        for (flag, &copy) in copies.iter().enumerate() {
            let step = faces.items()[flag >> 1];
            ends[step as usize ^ (flag & 1)] = copy;
        }
        let skeleton = TwoSkeleton::new(vertex_sources.len(), ends, faces)
            .expect("the sides of a face meet in one fan, so they stay a closed path");
        Ok(Slice {
            surface: Self::new(skeleton).expect("each copy of a vertex has one fan"),
            vertex_sources,
            edge_sources,
            left: pairs.iter().map(|pair| pair.1).collect(),
            right: pairs.iter().map(|pair| pair.2).collect(),
            path: None,
        })
    }

    /// The vertex of each flag when vertices are split into the fans between the cut edges, and what those beyond the old
    /// ones are copies of.
    fn fans_between(&self, is_cut: &[bool]) -> (Vec<u32>, Vec<VertexId>) {
        const UNSEEN: u32 = u32::MAX;
        let vertex_count = self.skeleton().vertex_count();
        let mut copies = vec![UNSEEN; 2 * self.side_count()];
        let mut is_kept = vec![false; vertex_count];
        let mut sources = Vec::new();
        for flag in 0..copies.len() as u32 {
            if copies[flag as usize] != UNSEEN {
                continue;
            }
            let vertex = self.flag_vertex(flag);
            let mut copy = vertex.to_u32();
            if std::mem::replace(&mut is_kept[vertex.index()], true) {
                copy = (vertex_count + sources.len()) as u32;
                sources.push(vertex);
            }
            let is_wall = |side| is_cut[self.edge(side).index()];
            self.walk_fan(flag, is_wall, |member| copies[member as usize] = copy);
        }
        (copies, sources)
    }

    /// Checks that steps are a path of distinct edges inside the surface through distinct vertices; whether it is closed.
    fn check_path(&self, steps: &[u32]) -> Result<bool, Error> {
        let skeleton = self.skeleton();
        let ends = skeleton.edge_ends();
        let Some(&last) = steps.last() else {
            return Err(Error::invalid("a path to cut along needs an edge, and this one has no step"));
        };
        let edge_of = |step: u32| EdgeId::from_u32(step >> 1);
        let mut first_at: Vec<(u32, usize)> = Vec::with_capacity(steps.len());
        let mut at = None;
        for (i, &step) in steps.iter().enumerate() {
            let Some(&start) = ends.get(step as usize) else { return Err(self.no_edge(edge_of(step))) };
            if let Some(at) = at.filter(|&at| at != start) {
                let [at, start] = [at, start].map(VertexId::from_u32);
                return Err(Error::invalid(format!(
                    "the steps are no path: step {} starts at {start}, but step {i} ends at {at}",
                    i + 1
                ))
                .with_cure("give edges that follow one another, or cut along them as a set"));
            }
            at = Some(ends[(step ^ 1) as usize]);
            first_at.push((start, i));
        }
        let mut edges: Vec<(u32, usize)> =
            steps.iter().enumerate().map(|(i, &step)| (step >> 1, i)).collect();
        edges.sort_unstable();
        if let Some(pair) = edges.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            let [a, b] = self.skeleton().edge(EdgeId::from_u32(pair[0].0));
            return Err(Error::invalid(format!(
                "steps {} and {} run along the same edge, which joins {a} and {b}",
                pair[0].1 + 1,
                pair[1].1 + 1
            ))
            .with_cure("name each edge once, or cut along them as a set"));
        }
        let end = ends[(last ^ 1) as usize];
        let is_closed = end == first_at[0].0;
        if !is_closed {
            first_at.push((end, steps.len()));
        }
        first_at.sort_unstable();
        if let Some(pair) = first_at.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(Error::invalid(format!(
                "the path comes through {} twice, before step {} and after step {}",
                VertexId::from_u32(pair[0].0),
                pair[0].1 + 1,
                pair[1].1
            ))
            .with_cure("cut along the edges as a set"));
        }
        let is_boundary = |edge: u32| self.mate(self.first_side(EdgeId::from_u32(edge))).is_none();
        let boundary = edges.iter().filter(|&&(edge, _)| is_boundary(edge)).min_by_key(|pair| pair.1);
        if let Some(&(edge, i)) = boundary {
            let [a, b] = self.skeleton().edge(EdgeId::from_u32(edge));
            return Err(Error::invalid(format!(
                "step {} from {a} to {b} runs along the boundary: there is nothing to cut",
                i + 1
            ))
            .with_cure("leave the step out"));
        }
        Ok(is_closed)
    }

    /// The side on the left of each step of a path that was checked; of a closed one also what is left of the first step
    /// after the last one.
    fn left_sides(&self, steps: &[u32], is_closed: bool) -> Vec<HalfedgeId> {
        let mate = |side: HalfedgeId| self.mate(side).expect("a path to cut lies inside");
        let first = self.first_side(EdgeId::from_u32(steps[0] >> 1));
        let sign = self.orientation().signs()[self.face(first).index()];
        let is_left = (self.step(first) == steps[0]) == (sign == Sign::Plus);
        let mut left = vec![if is_left { first } else { mate(first) }];
        let turns = steps.windows(2).map(|pair| (pair[0], pair[1]));
        let closing = is_closed.then(|| (steps[steps.len() - 1], steps[0]));
        for (from, to) in turns.chain(closing) {
            let side = left[left.len() - 1];
            let next = self.turn(side, from, to).unwrap_or_else(|| {
                // The boundary is between them on this side, so it is not on the other.
                mate(self.turn(mate(side), from, to).expect("the boundary is in one gap of the fan"))
            });
            left.push(next);
        }
        left
    }

    /// The side of the step `to` that the fan leads to from a side of the step `from`, away from its edge.
    fn turn(&self, side: HalfedgeId, from: u32, to: u32) -> Option<HalfedgeId> {
        let mut flag = side.to_u32() << 1 | (1 ^ (self.step(side) ^ from) & 1);
        loop {
            flag = self.alpha(1, flag);
            let reached = HalfedgeId::from_u32(flag >> 1);
            let step = self.step(reached);
            if step >> 1 == to >> 1 && flag & 1 == (step ^ to) & 1 {
                return Some(reached);
            }
            let across = self.alpha(2, flag);
            if across == flag {
                return None;
            }
            flag = across;
        }
    }

    fn no_edge(&self, edge: EdgeId) -> Error {
        Error::new(
            ErrorKind::NotInComplex,
            format!("there is no edge {edge}; the surface has {} edges", self.skeleton().edge_count()),
        )
    }
}

#[cfg(test)]
mod tests;
