//! Slicing of halfedge meshes.

use super::super::{GeneralizedMap, Slice};
use super::mesh::HalfedgeMesh;
use coface_algebra::{EdgeId, Error, HalfedgeId};

impl HalfedgeMesh {
    /// The mesh cut open along a set of edges. Edges on the boundary are open already and are passed over.
    ///
    /// The halfedge 2e of a cut edge e keeps its number, and so does the edge; the face of 2e + 1 gets a copy e' of the
    /// edge, which points as e does, and the halfedge 2e' + 1 for the one that it had. Outer faces are numbered by their
    /// smallest halfedges. [`Slice`] says the rest.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::NotInComplex`] naming an edge that does not exist; [`coface_algebra::ErrorKind::TooLarge`] from 2^31
    /// halfedges on.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// The square torus cut along both of its edges is the square.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
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
    /// Those of [`GeneralizedMap::slice_path`]; [`coface_algebra::ErrorKind::TooLarge`] from 2^31 halfedges on.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// A loop of the torus of two triangles: two loops on the boundary are left, each with one vertex.
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
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
    /// Those of [`Self::slice_path`], and [`coface_algebra::ErrorKind::InvalidInput`] for a path that is not closed.
    ///
    /// # Complexity
    /// Linear.
    pub fn slice_cycle(&self, cycle: &[HalfedgeId]) -> Result<Slice<Self>, Error> {
        let steps: Vec<u32> = cycle.iter().map(|h| h.to_u32()).collect();
        self.sliced(|map| map.slice_cycle(&steps))
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
    pub(super) fn generalized_map(&self) -> GeneralizedMap {
        self.two_skeleton().and_then(GeneralizedMap::new).expect("a halfedge mesh is a surface")
    }

    /// The mesh of a map whose faces agree.
    pub(super) fn of_coherent(map: &GeneralizedMap) -> Self {
        Self::from_two_skeleton(map.skeleton()).expect("the map is a surface whose faces agree")
    }
}
