//! Gluing of halfedge meshes along their boundary.

use super::super::Glued;
use super::mesh::{HalfedgeMesh, NONE};
use coface_algebra::Sign;
use coface_algebra::{Error, ErrorKind, HalfedgeId};

impl HalfedgeMesh {
    /// The mesh with pairs of halfedges on the boundary glued, each so that the second runs against the first. They are the
    /// halfedges with a face on their left, not the outer ones. [`Glued`] says how cells are numbered; outer faces are
    /// numbered by their smallest halfedges.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming a halfedge that is not on the boundary, has the outer face on its left, is
    /// glued to itself or is in two pairs; [`ErrorKind::NotInComplex`] for one that does not exist.
    ///
    /// # Complexity
    /// Nearly linear.
    ///
    /// # Examples
    /// Two opposite sides of a square:
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = HalfedgeMesh::from_polygons(4, &RaggedArray::from_lists([[0, 1, 2, 3]]))?;
    /// let annulus = square.glue(&[(HalfedgeId::new(0), HalfedgeId::new(4))])?;
    /// assert_eq!(annulus.surface().f_vector(), [2, 3, 1]);
    /// assert_eq!(annulus.surface().outer_face_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn glue(&self, pairs: &[(HalfedgeId, HalfedgeId)]) -> Result<Glued<Self>, Error> {
        let map = self.generalized_map();
        let sides = map.sides_of_steps();
        let side_of = |h: HalfedgeId| match sides.get(h.index()) {
            None => Err(Error::new(
                ErrorKind::NotInComplex,
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
    /// use coface_algebra::HalfedgeId;
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
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
        let (mut forward, mut backward) = (first, second);
        for i in 0..length {
            pairs.push((forward, backward));
            // What is no side of the boundary, or comes round again, is refused below.
            if !self.is_boundary_side(forward)
                || !self.is_boundary_side(backward)
                || i > self.halfedge_count()
            {
                break;
            }
            forward = self.twin(self.previous(self.twin(forward)));
            backward = self.twin(self.next(self.twin(backward)));
        }
        self.glue(&pairs)
    }

    /// The mesh with two loops of its boundary glued all around, so that the source of `first` becomes the target of
    /// `second`.
    ///
    /// # Errors
    /// Those of [`Self::glue`], and [`ErrorKind::InvalidInput`] when the two are on the same loop, or on loops of different
    /// lengths.
    ///
    /// # Complexity
    /// Nearly linear.
    ///
    /// # Examples
    /// The two loops of an annulus:
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let ring = [[0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]];
    /// let annulus = HalfedgeMesh::from_polygons(6, &RaggedArray::from_lists(ring))?;
    /// let sides: Vec<HalfedgeId> =
    ///     annulus.outer_faces().flat_map(|outer| annulus.boundary_loop(outer).next()).collect();
    /// let torus = annulus.glue_loops(sides[0], sides[1])?;
    /// assert_eq!(torus.surface().f_vector(), [3, 6, 3]);
    /// assert_eq!(torus.surface().genus(), 1);
    /// # Ok(()) }
    /// ```
    pub fn glue_loops(&self, first: HalfedgeId, second: HalfedgeId) -> Result<Glued<Self>, Error> {
        if !self.is_boundary_side(first) || !self.is_boundary_side(second) {
            return self.glue(&[(first, second)]);
        }
        let [outer, other] = [first, second].map(|h| self.face(self.twin(h)));
        if outer == other {
            return Err(Error::invalid(format!(
                "{first} and {second} are on the same boundary loop, around {outer}"
            ))
            .with_cure("name two loops, or glue arcs of the loop"));
        }
        let [length, other_length] = [outer, other].map(|face| self.boundary_loop(face).count());
        if length != other_length {
            return Err(Error::invalid(format!(
                "the boundary loop of {first} has {length} edges and that of {second} has {other_length}"
            ))
            .with_cure("split edges until they are as many, or glue arcs"));
        }
        self.glue_arcs(first, second, length)
    }

    /// Whether this is a halfedge on the boundary with a face on its left.
    fn is_boundary_side(&self, h: HalfedgeId) -> bool {
        h.index() < self.halfedge_count()
            && self.is_outer_halfedge(self.twin(h))
            && !self.is_outer_halfedge(h)
    }
}
