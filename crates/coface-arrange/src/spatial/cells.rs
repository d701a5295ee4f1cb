//! The cells of space.

use super::PolygonalComplex;
use super::face_planes::FacePlanes;
use super::nesting::parents;
use super::polygonal_complex::sign_of;
use super::predicates::{GivenPoints, SpatialPredicates};
use super::radial_order::{RadialOrder, SidesAtEdges};
use super::shells::Shells;
use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::{Steps, stage};
use coface_algebra::{CellId, EdgeId, Error, FaceId};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use coface_geometry::{Positions, Scaled, Sum};
use rayon::prelude::*;
use std::sync::Arc;

/// The exterior, where cells are numbered.
const EXTERIOR: u32 = u32::MAX;

/// The cells that a conforming complex of flat faces cuts space into.
///
/// A **cell** is a bounded connected part of space without the faces; what is left is the **exterior**, which is no
/// cell. The boundary of a cell is one or more **shells**: the first is its outer one, the others are those of voids,
/// components of faces inside the cell. A face with the same cell on both sides (**dangling**) is in a shell of it
/// twice and in no boundary chain.
///
/// # Conventions
/// A face has coefficient 1 in the boundary of the cell behind it and -1 in that of the cell in front, so that
/// boundaries run outward. Cells are numbered by the lowest of the half-faces of their outer shells, the back of a face
/// before its front.
///
/// # Algorithm
/// The faces around each edge are sorted by signs of determinants alone; the two sides of each gap belong to one shell,
/// and union-find makes the shells. Components of faces that are joined by edges have one shell that is seen from far
/// away, found at the least vertex; exact rays tell within which cell it lies.
///
/// # References
/// A. Paoluzzi, V. Shapiro, A. DiCarlo, F. Furiani, G. Martella, G. Scorzelli, *Topological computing of arrangements
/// with (co)chains* (2020); Q. Zhou, E. Grinspun, D. Zorin, A. Jacobson, *Mesh arrangements for solid geometry* (2016),
/// section 4.
///
/// # Examples
/// Two tetrahedra on a common face, cut out of space by seven triangles:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let flat = vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 6., 0., 0., -12.];
/// let positions = Positions::from_flat(3, flat)?;
/// let faces = [[0, 1, 2], [0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 1, 4], [1, 2, 4], [2, 0, 4]];
/// let complex = PolygonalComplex::from_polygons(5, &RaggedArray::from_lists(faces))?;
/// let cells = SpatialCells::new(complex, &positions)?;
/// assert_eq!(cells.chain_complex()?.f_vector(), [5, 9, 7, 2]);
/// let mut volumes = cells.volumes(&positions)?;
/// volumes.sort_by(f64::total_cmp);
/// assert_eq!(volumes, [1.0, 2.0]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct SpatialCells {
    complex: Arc<PolygonalComplex>,
    order: RadialOrder,
    parts: CellParts,
}

/// A complex with the faces around its edges in their order: all that cells are found from.
pub(super) struct OrderedFaces {
    complex: Arc<PolygonalComplex>,
    planes: FacePlanes,
    order: RadialOrder,
}

/// The cells of a complex by their shells.
#[derive(Clone, Debug)]
pub(super) struct CellParts {
    shells: Shells,
    /// The cell of each shell, or the exterior.
    cell_of_shell: Vec<u32>,
    /// The shells of each cell, the outer one first.
    shells_of_cell: RaggedArray,
    exterior_shells: Vec<u32>,
    /// The half-faces of each shell, rising.
    half_faces: RaggedArray,
}

impl OrderedFaces {
    /// Sorts the faces around all edges.
    ///
    /// # Errors
    /// `InvalidInput` naming a face that is not flat or has no area, or an edge with two faces in the same direction.
    pub(super) fn new(
        complex: impl Into<Arc<PolygonalComplex>>,
        predicates: &impl SpatialPredicates,
        steps: &Steps,
    ) -> Result<Self, Error> {
        let complex = complex.into();
        let (planes, sides) =
            rayon::join(|| FacePlanes::new(&complex, predicates), || SidesAtEdges::new(&complex));
        let planes = planes?;
        let order = RadialOrder::new(&complex, predicates, &planes, sides, steps)?;
        Ok(Self { complex, planes, order })
    }

    /// The packed sides of faces around each edge.
    pub(super) fn around(&self) -> &RaggedArray {
        self.order.lists()
    }
}

impl CellParts {
    /// Closes the sides of faces up to shells, and finds the cells that these bound.
    ///
    /// # Errors
    /// `InvalidInput` naming faces that cross.
    pub(super) fn new(
        ordered: &OrderedFaces,
        predicates: &impl SpatialPredicates,
        steps: &Steps,
    ) -> Result<Self, Error> {
        let OrderedFaces { complex, planes, order } = ordered;
        let shells = Shells::new(complex, predicates, planes, order);
        let parents = parents(complex, predicates, planes, &shells, steps)?;
        let mut cell_of_shell = vec![EXTERIOR; shells.shell_count];
        let mut own_shells = Vec::new();
        for (shell, cell) in cell_of_shell.iter_mut().enumerate() {
            if shells.outer[shells.component_of_shell[shell] as usize] as usize != shell {
                *cell = own_shells.len() as u32;
                own_shells.push(vec![shell as u32]);
            }
        }
        let mut exterior_shells = Vec::new();
        for (&outer, parent) in shells.outer.iter().zip(parents) {
            match parent {
                None => exterior_shells.push(outer),
                Some(parent) => {
                    let cell = cell_of_shell[parent as usize];
                    cell_of_shell[outer as usize] = cell;
                    own_shells[cell as usize].push(outer);
                }
            }
        }
        let half_faces = RaggedArray::grouped(shells.shell_count, shells.shell_of.iter().copied());
        let shells_of_cell = RaggedArray::from_lists(&own_shells);
        Ok(Self { shells, cell_of_shell, shells_of_cell, exterior_shells, half_faces })
    }
}

impl SpatialCells {
    /// The cells of a complex whose vertices are at these positions.
    ///
    /// The faces must meet only in common edges and vertices. What shows otherwise while cells are made is an error;
    /// faces that cross each other unnoticed make cells that mean nothing.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::Shape`] unless there are three coordinates for each vertex;
    /// [`coface_algebra::ErrorKind::InvalidInput`] naming a face that is not flat or has no area, an edge with two
    /// faces in the same direction, or faces that cross.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n sides and few components; each component adds a ray through the faces above and below it.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// assert_eq!(cells.cell_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn new(complex: PolygonalComplex, positions: &Positions) -> Result<Self, Error> {
        let points = GivenPoints::new(positions)?;
        complex.check_positions(positions)?;
        Self::with_predicates(complex, &points)
    }

    /// The same with points that are known by exact decisions only.
    ///
    /// # Errors
    /// As [`Self::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{GivenPoints, PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::with_predicates(complex, &GivenPoints::new(&corners)?)?;
    /// assert_eq!(cells.cell_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn with_predicates(
        complex: impl Into<Arc<PolygonalComplex>>,
        predicates: &impl SpatialPredicates,
    ) -> Result<Self, Error> {
        let complex = complex.into();
        let steps = stage("sorting faces around edges", complex.edge_count());
        let ordered = OrderedFaces::new(complex, predicates, &steps)?;
        drop(steps);
        let parts = CellParts::new(&ordered, predicates, &stage("finding cells", 0))?;
        Ok(Self::from_parts(ordered, parts))
    }

    /// What was found for a complex, together with it.
    pub(super) fn from_parts(ordered: OrderedFaces, parts: CellParts) -> Self {
        let OrderedFaces { complex, order, .. } = ordered;
        Self { complex, order, parts }
    }

    /// The vertices, edges and faces.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// assert_eq!(cells.complex().f_vector(), [4, 6, 4]);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &PolygonalComplex {
        &self.complex
    }

    /// The number of cells; the exterior does not count.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// assert_eq!(cells.cell_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn cell_count(&self) -> usize {
        self.parts.shells_of_cell.len()
    }

    /// The number of components of faces that are joined by edges. Components may touch in vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// assert_eq!(cells.component_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn component_count(&self) -> usize {
        self.parts.shells.outer.len()
    }

    /// The number of shells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// // The inside and the outside.
    /// assert_eq!(cells.shell_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn shell_count(&self) -> usize {
        self.parts.shells.shell_count
    }

    /// The shells of a cell by their numbers, the outer one first, then those of voids; of the exterior for `None`.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, RaggedArray};
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// assert_eq!(cells.shells(Some(CellId::new(0))).len(), 1);
    /// assert_eq!(cells.shells(None).len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn shells(&self, cell: Option<CellId>) -> &[u32] {
        cell.map_or(&self.parts.exterior_shells, |cell| self.parts.shells_of_cell.list(cell.index()))
    }

    /// The sides of faces that make up a shell: plus for the back of a face, which has the cell behind it, minus for
    /// the front. By rising face.
    ///
    /// # Panics
    /// If there is no such shell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, FaceId, RaggedArray, Sign};
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// let inner = cells.shells(Some(CellId::new(0)))[0];
    /// // The tetrahedron is behind all four faces.
    /// assert!(cells.shell_sides(inner).eq((0..4).map(|face| (FaceId::new(face), Sign::Plus))));
    /// # Ok(()) }
    /// ```
    pub fn shell_sides(&self, shell: u32) -> impl ExactSizeIterator<Item = (FaceId, Sign)> + '_ {
        self.parts
            .half_faces
            .list(shell as usize)
            .iter()
            .map(|&half| (FaceId::from_u32(half >> 1), sign_of(half)))
    }

    /// The shell on the back of a face (plus) or on its front (minus).
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray, Sign};
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// let [back, front] = [Sign::Plus, Sign::Minus].map(|side| cells.shell_at(FaceId::new(0), side));
    /// assert_ne!(back, front);
    /// # Ok(()) }
    /// ```
    pub fn shell_at(&self, face: FaceId, side: Sign) -> u32 {
        self.parts.shells.shell_of[2 * face.index() + usize::from(side == Sign::Minus)]
    }

    /// The cell at the back of a face (plus) or at its front (minus); `None` for the exterior.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, FaceId, RaggedArray, Sign};
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// assert_eq!(cells.cell_at(FaceId::new(0), Sign::Plus), Some(CellId::new(0)));
    /// assert_eq!(cells.cell_at(FaceId::new(0), Sign::Minus), None);
    /// # Ok(()) }
    /// ```
    pub fn cell_at(&self, face: FaceId, side: Sign) -> Option<CellId> {
        let cell = self.parts.cell_of_shell[self.shell_at(face, side) as usize];
        (cell != EXTERIOR).then(|| CellId::from_u32(cell))
    }

    /// The faces with the same cell, or the exterior, on both sides, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// assert_eq!(cells.dangling_faces().count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn dangling_faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        (0..self.complex.face_count())
            .map(FaceId::new)
            .filter(|&face| self.cell_at(face, Sign::Plus) == self.cell_at(face, Sign::Minus))
    }

    /// The faces around an edge, counterclockwise seen from its second end, with minus where their sides run against
    /// the edge.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{EdgeId, RaggedArray};
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// assert_eq!(cells.faces_around(EdgeId::new(0)).len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn faces_around(&self, edge: EdgeId) -> impl ExactSizeIterator<Item = (FaceId, Sign)> + '_ {
        self.order.at(edge.index()).iter().map(|&side| (FaceId::from_u32(side >> 1), sign_of(side)))
    }

    /// The packed sides of faces around each edge, in the order of [`Self::faces_around`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// // Two sides at each of six edges.
    /// assert_eq!(cells.radial_order().item_count(), 12);
    /// # Ok(()) }
    /// ```
    pub fn radial_order(&self) -> &RaggedArray {
        self.order.lists()
    }

    /// The boundary matrix of the cells: rows are faces, columns cells.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] beyond 2^32 - 1 entries.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// assert_eq!(cells.cell_boundaries()?.column(0).entries(), [1; 4]);
    /// # Ok(()) }
    /// ```
    pub fn cell_boundaries(&self) -> Result<SparseMatrix, Error> {
        let count = self.cell_count();
        self.boundaries(count, |cell| (cell != EXTERIOR).then_some(cell as usize))
    }

    /// The boundary of the exterior as a matrix of one column: minus the sum of the boundaries of all cells.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] beyond 2^32 - 1 entries.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// assert_eq!(cells.exterior_boundary()?.column(0).entries(), [-1; 4]);
    /// # Ok(()) }
    /// ```
    pub fn exterior_boundary(&self) -> Result<SparseMatrix, Error> {
        self.boundaries(1, |cell| (cell == EXTERIOR).then_some(0))
    }

    fn boundaries(&self, count: usize, column: impl Fn(u32) -> Option<usize>) -> Result<SparseMatrix, Error> {
        let sides = |face: usize| {
            [2 * face, 2 * face + 1]
                .map(|half| self.parts.cell_of_shell[self.parts.shells.shell_of[half] as usize])
        };
        let mut starts = vec![0u32; count + 1];
        let mut terms = Vec::new();
        for face in 0..self.complex.face_count() {
            let [back, front] = sides(face);
            if back == front {
                continue;
            }
            for (cell, sign) in [(back, 1), (front, -1)] {
                if let Some(column) = column(cell) {
                    terms.push((column, face as u32, sign));
                    starts[column + 1] += 1;
                }
            }
        }
        for i in 0..count {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let (mut rows, mut entries) = (vec![0; terms.len()], vec![0; terms.len()]);
        for (column, face, sign) in terms {
            let place = next[column] as usize;
            (rows[place], entries[place]) = (face, sign);
            next[column] += 1;
        }
        SparseMatrix::from_trusted_parts(self.complex.face_count(), starts, rows, entries)
    }

    /// The chain complex of vertices, edges, faces and cells, without the exterior.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] beyond 2^32 - 1 entries in a matrix.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// assert_eq!(cells.chain_complex()?.f_vector(), [4, 6, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        // The sides of a shell follow each other around each edge, so that shells are cycles.
        Ok(ChainComplex::from_trusted_boundaries(vec![
            self.complex.edge_boundaries()?,
            self.complex.face_boundaries()?,
            self.cell_boundaries()?,
        ]))
    }

    /// The volume that each shell encloses, in the cube of the unit of the positions, rounded: positive for outer
    /// shells of cells, negative for those of voids and of the exterior.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::Shape`] unless there are three coordinates for each vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// let volumes = cells.shell_volumes(&corners)?;
    /// assert!((volumes[0] + volumes[1]).abs() < 1e-15);
    /// # Ok(()) }
    /// ```
    pub fn shell_volumes(&self, positions: &Positions) -> Result<Vec<f64>, Error> {
        let shells: Vec<u32> = (0..self.shell_count() as u32).collect();
        self.volumes_of_shells(positions, &shells)
    }

    fn volumes_of_shells(&self, positions: &Positions, shells: &[u32]) -> Result<Vec<f64>, Error> {
        self.complex.check_positions(positions)?;
        let scaled = Scaled::new(positions);
        let tail = |half: u32| {
            let first = self.complex.packed_sides().list((half >> 1) as usize)[0];
            self.complex.side_ends(first)[0]
        };
        let volume = |&shell: &u32| {
            let half_faces = self.parts.half_faces.list(shell as usize);
            // An apex on the shell: no volume that cancels is larger than the shell itself.
            let origin = half_faces.first().map_or([0.0; 3], |&half| scaled.origin_at(tail(half)));
            let sum = Sum::of(half_faces.len(), |i| {
                let (half, apex) = (half_faces[i], tail(half_faces[i]));
                let mut cone = Sum::default();
                for &side in self.complex.packed_sides().list((half >> 1) as usize) {
                    let [a, b] = self.complex.side_ends(side);
                    // Sides at the apex span nothing with it.
                    if a != apex && b != apex {
                        let [top, a, b] = [apex, a, b].map(|vertex| scaled.relative(vertex, origin));
                        cone.add(determinant(top, a, b));
                    }
                }
                f64::from(sign_of(half).to_i32()) * cone.value()
            });
            scaled.unscaled(sum / 6.0, 3)
        };
        Ok(shells.par_iter().map(volume).collect())
    }

    /// The volume of each cell, without its voids, in the cube of the unit of the positions, rounded.
    ///
    /// # Errors
    /// As [`Self::shell_volumes`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let complex = PolygonalComplex::from_polygons(4, &sides)?;
    /// let cells = SpatialCells::new(complex, &corners)?;
    /// assert!((cells.volumes(&corners)?[0] - 1.0 / 6.0).abs() < 1e-15);
    /// # Ok(()) }
    /// ```
    pub fn volumes(&self, positions: &Positions) -> Result<Vec<f64>, Error> {
        let cells: Vec<CellId> = (0..self.cell_count()).map(CellId::new).collect();
        self.volumes_of(positions, &cells)
    }

    /// The same for some cells, in their order.
    ///
    /// # Errors
    /// As [`Self::shell_volumes`].
    ///
    /// # Panics
    /// If there is no such cell.
    #[doc(hidden)]
    pub fn volumes_of(&self, positions: &Positions, cells: &[CellId]) -> Result<Vec<f64>, Error> {
        let own = cells.iter().map(|cell| self.parts.shells_of_cell.list(cell.index()));
        let shells: Vec<u32> = own.clone().flatten().copied().collect();
        let volumes = self.volumes_of_shells(positions, &shells)?;
        let mut rest = volumes.into_iter();
        let sums = own.map(|own| {
            let mut sum = Sum::default();
            rest.by_ref().take(own.len()).for_each(|volume| sum.add(volume));
            sum.value()
        });
        Ok(sums.collect())
    }
}

fn determinant(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}
