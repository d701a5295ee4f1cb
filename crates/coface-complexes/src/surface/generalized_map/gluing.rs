//! Gluing: surfaces closed along sides of their boundary.

use super::GeneralizedMap;
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::{EdgeId, Error, ErrorKind, HalfedgeId, IdVec, VertexId};
use coface_algebra::{Sign, UnionFind};

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// A surface with sides of its boundary glued in pairs, and what its cells became.
///
/// Of cells that become one the smallest keeps its number among those that stay; the numbers close up in order. An edge
/// points as the one with the smaller number did. Faces and their sides stay as they are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Glued<S> {
    surface: S,
    vertex_images: IdVec<VertexId, VertexId>,
    edge_images: IdVec<EdgeId, (EdgeId, Sign)>,
}

impl<S> Glued<S> {
    /// The surface after gluing.
    pub fn surface(&self) -> &S {
        &self.surface
    }

    /// The surface after gluing, given away.
    pub fn into_surface(self) -> S {
        self.surface
    }

    /// For each vertex before what it is now.
    pub fn vertex_images(&self) -> &IdVec<VertexId, VertexId> {
        &self.vertex_images
    }

    /// For each edge before what it is now, with minus if that points the other way.
    pub fn edge_images(&self) -> &IdVec<EdgeId, (EdgeId, Sign)> {
        &self.edge_images
    }

    /// The same in another form of the surface.
    pub(in crate::surface) fn map<T>(self, surface: impl FnOnce(S) -> T) -> Glued<T> {
        let Self { vertex_images, edge_images, .. } = self;
        Glued { surface: surface(self.surface), vertex_images, edge_images }
    }
}

impl GeneralizedMap {
    /// The surface with these sides of its boundary glued. With [`Sign::Minus`] the second side runs against the first: the
    /// start of one is the end of the other, and their faces agree there. With [`Sign::Plus`] the two run alike.
    ///
    /// The result is always a surface: gluing joins fans at their ends.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming a side that is not on the boundary, is glued to itself or is in two pairs;
    /// [`ErrorKind::NotInComplex`] for a side that does not exist.
    ///
    /// # Complexity
    /// Nearly linear, by union-find on the vertices.
    ///
    /// # Examples
    /// A square with two opposite sides glued: a Moebius band if they run alike, else an annulus.
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_algebra::{RaggedArray, Sign};
    /// use coface_complexes::surface::{GeneralizedMap, PolygonMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// let square = GeneralizedMap::new(square.two_skeleton()?)?;
    /// let name = |sign| {
    ///     let glued = square.glue(&[(HalfedgeId::new(0), HalfedgeId::new(2), sign)])?;
    ///     Ok::<_, coface_algebra::Error>(glued.surface().surfaces()[0].to_string())
    /// };
    /// assert_eq!(name(Sign::Plus)?, "Moebius band");
    /// assert_eq!(name(Sign::Minus)?, "annulus");
    /// # Ok(()) }
    /// ```
    pub fn glue(&self, pairs: &[(HalfedgeId, HalfedgeId, Sign)]) -> Result<Glued<Self>, Error> {
        self.check_pairs(pairs)?;
        let skeleton = self.skeleton();
        let (vertex_count, edge_count) = (skeleton.vertex_count(), skeleton.edge_count());
        let mut vertices = UnionFind::new(vertex_count);
        // For each edge the edge that it becomes, in the old numbers, and the sign.
        let mut becomes: Vec<(u32, Sign)> = (0..edge_count as u32).map(|edge| (edge, Sign::Plus)).collect();
        for &(first, second, sign) in pairs {
            let (start, end) = match sign {
                Sign::Plus => (self.source(second), self.target(second)),
                Sign::Minus => (self.target(second), self.source(second)),
            };
            vertices.unite(self.source(first).to_u32(), start.to_u32());
            vertices.unite(self.target(first).to_u32(), end.to_u32());
            let steps = [self.step(first), self.step(second)];
            let relative = Sign::power_of_minus_one(((steps[0] ^ steps[1]) & 1) as usize).times(sign);
            let (kept, gone) = (steps[0].min(steps[1]) >> 1, steps[0].max(steps[1]) >> 1);
            becomes[gone as usize] = (kept, relative);
        }
        let mut numbers = vec![0; edge_count];
        let mut ends = Vec::with_capacity(2 * edge_count);
        let class = vertices.class_numbers();
        for edge in 0..edge_count {
            if becomes[edge].0 as usize == edge {
                numbers[edge] = (ends.len() / 2) as u32;
                ends.extend(skeleton.edge(EdgeId::new(edge)).map(|end| class[end.index()]));
            }
        }
        let edge_images: IdVec<EdgeId, (EdgeId, Sign)> =
            becomes.iter().map(|&(edge, sign)| (EdgeId::from_u32(numbers[edge as usize]), sign)).collect();
        let mut faces = skeleton.faces().clone();
        for step in faces.items_mut() {
            let (edge, sign) = edge_images[EdgeId::from_u32(*step >> 1)];
            *step = edge.to_u32() << 1 | ((*step & 1) ^ u32::from(sign == Sign::Minus));
        }
        let skeleton = TwoSkeleton::new(vertices.class_count(), ends, faces)
            .expect("sides that are glued have their ends in common, so faces keep closed paths");
        Ok(Glued {
            surface: Self::new(skeleton).expect("gluing joins fans at their ends"),
            vertex_images: class.into_iter().map(VertexId::from_u32).collect(),
            edge_images,
        })
    }

    /// The side of each step, `NONE` where no side has it. All faces agree.
    pub(in crate::surface) fn sides_of_steps(&self) -> Vec<u32> {
        let mut sides = vec![NONE; 2 * self.skeleton().edge_count()];
        for side in self.sides() {
            sides[self.step(side) as usize] = side.to_u32();
        }
        sides
    }

    /// Checks that each pair is two sides on the boundary that no other pair has.
    fn check_pairs(&self, pairs: &[(HalfedgeId, HalfedgeId, Sign)]) -> Result<(), Error> {
        let mut is_named = vec![false; self.side_count()];
        for &(first, second, _) in pairs {
            for side in [first, second] {
                let Some(named) = is_named.get_mut(side.index()) else {
                    return Err(Error::new(
                        ErrorKind::NotInComplex,
                        format!("there is no side {side}; the faces have {} sides", self.side_count()),
                    ));
                };
                if let Some(mate) = self.mate(side) {
                    return Err(Error::invalid(format!(
                        "side {side} of face {} is not on the boundary: along edge {} it is glued to side {mate}",
                        self.face(side),
                        self.edge(side)
                    ))
                    .with_cure("name sides on the boundary, or cut along the edge first"));
                }
                if std::mem::replace(named, true) {
                    let fault = if first == second { "is to be glued to itself" } else { "is in two pairs" };
                    return Err(Error::invalid(format!("side {side} {fault}"))
                        .with_cure("glue each side to one other side"));
                }
            }
        }
        Ok(())
    }
}
