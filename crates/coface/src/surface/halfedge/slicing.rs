//! Slicing and gluing of halfedge meshes.

use super::super::{GeneralizedMap, Glued, Slice};
use super::mesh::{HalfedgeMesh, NONE};
use crate::algebra::Sign;
use crate::{EdgeId, Error, HalfedgeId};

impl HalfedgeMesh {
    /// The mesh cut open along a set of edges. Edges on the boundary are open already and are passed over.
    ///
    /// The halfedge 2e of a cut edge e keeps its number, and so does the edge; the face of 2e + 1 gets a copy e' of the
    /// edge, which points as e does, and the halfedge 2e' + 1 for the one that it had. Outer faces are numbered by their
    /// smallest halfedges. [`Slice`] says the rest.
    ///
    /// # Errors
    /// [`crate::ErrorKind::NotInComplex`] naming an edge that does not exist; [`crate::ErrorKind::TooLarge`] from 2^31
    /// halfedges on.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// The square torus cut along both of its edges is the square.
    /// ```
    /// use coface::EdgeId;
    /// use coface::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// let square = torus.slice_edges(&[EdgeId::new(0), EdgeId::new(1)])?;
    /// assert_eq!(square.surface().f_vector(), [4, 4, 1]);
    /// assert_eq!(square.surface().surface().map(|s| s.to_string()).as_deref(), Some("disk"));
    /// assert!(square.vertex_sources().iter().all(|source| source.index() == 0));
    /// # Ok(()) }
    /// ```
    pub fn slice_edges(&self, edges: &[EdgeId]) -> Result<Slice<Self>, Error> {
        self.sliced(|map| map.slice_edges(edges))
    }

    /// The mesh cut open along a path of halfedges, each of which starts where the one before it ends. A path inside becomes
    /// a slit, one boundary loop; a closed path becomes two; where a path touches the boundary, its slit opens into that.
    ///
    /// [`Slice::left`] has the halfedges of the path, as they are numbered now, with the faces that were on its left;
    /// [`Slice::right`] has their former twins.
    ///
    /// # Errors
    /// Those of [`GeneralizedMap::slice_path`]; [`crate::ErrorKind::TooLarge`] from 2^31 halfedges on.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// A loop of the torus of two triangles: two loops on the boundary are left, each with one vertex.
    /// ```
    /// use coface::HalfedgeId;
    /// use coface::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 4, 5, 0, 1])?;
    /// let slice = torus.slice_path(&[HalfedgeId::new(0)])?;
    /// assert_eq!(slice.surface().surface().map(|s| s.to_string()).as_deref(), Some("annulus"));
    /// let again = slice.surface().glue(&[(slice.left()[0], slice.right()[0])])?;
    /// assert_eq!(again.into_surface(), torus);
    /// # Ok(()) }
    /// ```
    pub fn slice_path(&self, path: &[HalfedgeId]) -> Result<Slice<Self>, Error> {
        let steps: Vec<u32> = path.iter().map(|h| h.to_u32()).collect();
        self.sliced(|map| map.slice_path(&steps))
    }

    /// The mesh cut open along a closed path of halfedges, as [`Self::slice_path`] does it.
    ///
    /// # Errors
    /// Those of [`Self::slice_path`], and [`crate::ErrorKind::InvalidInput`] for a path that is not closed.
    ///
    /// # Complexity
    /// Linear.
    pub fn slice_cycle(&self, cycle: &[HalfedgeId]) -> Result<Slice<Self>, Error> {
        let steps: Vec<u32> = cycle.iter().map(|h| h.to_u32()).collect();
        self.sliced(|map| map.slice_cycle(&steps))
    }

    /// The mesh with pairs of halfedges on the boundary glued, each so that the second runs against the first. They are the
    /// halfedges with a face on their left, not the outer ones. [`Glued`] says how cells are numbered; outer faces are
    /// numbered by their smallest halfedges.
    ///
    /// # Errors
    /// [`crate::ErrorKind::InvalidInput`] naming a halfedge that is not on the boundary, has the outer face on its left, is
    /// glued to itself or is in two pairs; [`crate::ErrorKind::NotInComplex`] for one that does not exist.
    ///
    /// # Complexity
    /// Nearly linear.
    ///
    /// # Examples
    /// The two loops of an annulus:
    /// ```
    /// use coface::HalfedgeId;
    /// use coface::algebra::RaggedArray;
    /// use coface::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface::Error> {
    /// let ring = [[0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]];
    /// let annulus = HalfedgeMesh::from_polygons(6, &RaggedArray::from_lists(ring))?;
    /// let [inner, outer] = [0, 1].map(|i| annulus.boundary_loop(annulus.outer_faces().nth(i).expect("two loops")));
    /// let inner: Vec<HalfedgeId> = inner.collect();
    /// let outer: Vec<HalfedgeId> = outer.collect();
    /// let torus = annulus.glue_arcs(inner[0], outer[0], 3)?;
    /// assert_eq!(torus.surface().f_vector(), [3, 6, 3]);
    /// assert_eq!(torus.surface().genus(), 1);
    /// # Ok(()) }
    /// ```
    pub fn glue(&self, pairs: &[(HalfedgeId, HalfedgeId)]) -> Result<Glued<Self>, Error> {
        let map = self.generalized_map();
        let sides = map.sides_of_steps();
        let side_of = |h: HalfedgeId| match sides.get(h.index()) {
            None => Err(Error::new(
                crate::ErrorKind::NotInComplex,
                format!("there is no halfedge {h}; the mesh has {}", self.halfedge_count()),
            )),
            Some(&NONE) => Err(Error::invalid(format!(
                "halfedge {h} has outer face {} on its left, and nothing to be glued there",
                self.face(h)
            ))
            .with_cure(format!("name its twin {}", self.twin(h)))),
            Some(_) if !self.is_boundary_edge(self.edge(h)) => Err(Error::invalid(format!(
                "halfedge {h} is not on the boundary: its twin has face {}",
                self.face(self.twin(h))
            ))
            .with_cure("name halfedges on the boundary, or cut along the edge first")),
            Some(&side) => Ok(HalfedgeId::from_u32(side)),
        };
        let mut is_named = vec![false; self.halfedge_count()];
        let mut glued = Vec::with_capacity(pairs.len());
        for &(first, second) in pairs {
            glued.push((side_of(first)?, side_of(second)?, Sign::Minus));
            for h in [first, second] {
                if std::mem::replace(&mut is_named[h.index()], true) {
                    let fault = if first == second { "is to be glued to itself" } else { "is in two pairs" };
                    return Err(Error::invalid(format!("halfedge {h} {fault}"))
                        .with_cure("glue each halfedge to one other halfedge"));
                }
            }
        }
        Ok(map.glue(&glued)?.map(|map| Self::of_coherent(&map)))
    }

    /// The mesh with two arcs of its boundary glued: `length` halfedges from `first` on along the boundary, in their direction,
    /// to as many from `second` on backwards, so that the source of `first` becomes the target of `second`. Two whole
    /// loops of one length are arcs too.
    ///
    /// # Errors
    /// Those of [`Self::glue`]; an arc that is longer than its loop, and arcs with a halfedge in common, name a
    /// halfedge twice.
    ///
    /// # Complexity
    /// Nearly linear.
    ///
    /// # Examples
    /// A square zipped up from a corner on: two edges remain, the sphere.
    /// ```
    /// use coface::HalfedgeId;
    /// use coface::algebra::RaggedArray;
    /// use coface::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface::Error> {
    /// let square = HalfedgeMesh::from_polygons(4, &RaggedArray::from_lists([[0, 1, 2, 3]]))?;
    /// let sphere = square.glue_arcs(HalfedgeId::new(0), HalfedgeId::new(6), 2)?;
    /// assert_eq!(sphere.surface().f_vector(), [3, 2, 1]);
    /// assert!(sphere.surface().is_closed());
    /// # Ok(()) }
    /// ```
    pub fn glue_arcs(
        &self,
        first: HalfedgeId,
        second: HalfedgeId,
        length: usize,
    ) -> Result<Glued<Self>, Error> {
        let mut pairs = Vec::new();
        let is_side = |h: HalfedgeId| {
            h.index() < self.halfedge_count()
                && self.is_outer_halfedge(self.twin(h))
                && !self.is_outer_halfedge(h)
        };
        let (mut forward, mut backward) = (first, second);
        for i in 0..length {
            pairs.push((forward, backward));
            // What is no side of the boundary, or comes round again, is refused below.
            if !is_side(forward) || !is_side(backward) || i > self.halfedge_count() {
                break;
            }
            forward = self.twin(self.previous(self.twin(forward)));
            backward = self.twin(self.next(self.twin(backward)));
        }
        self.glue(&pairs)
    }

    /// Cuts the mesh in the form of a generalized map.
    fn sliced(
        &self,
        slice: impl FnOnce(&GeneralizedMap) -> Result<Slice<GeneralizedMap>, Error>,
    ) -> Result<Slice<Self>, Error> {
        let slice = slice(&self.generalized_map())?;
        super::mesh::check_limit(2 * slice.edge_sources().len())?;
        Ok(slice.map(|map| Self::of_coherent(&map), |map, side| HalfedgeId::from_u32(map.step(side))))
    }

    /// The same surface as polygons glued at their sides; outer faces are left out. The step of a side is its halfedge.
    fn generalized_map(&self) -> GeneralizedMap {
        GeneralizedMap::new(self.two_skeleton()).expect("a halfedge mesh is a surface")
    }

    /// The mesh of a map whose faces agree.
    fn of_coherent(map: &GeneralizedMap) -> Self {
        Self::from_two_skeleton(map.skeleton()).expect("the map is a surface whose faces agree")
    }
}
