//! The boundary of a selection in space as a mesh.

use coface_algebra::{CellId, Error, ErrorKind};
use coface_algebra::{RaggedArray, Sign, UnionFind};
use coface_geometry::Positions;

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// The boundary of a selection of cells of space as a mesh of polygons, each with the facet of the arrangement that it
/// is part of.
///
/// # Conventions
/// Polygons run counterclockwise seen from outside the selection. The vertices are those of the arrangement that
/// polygons have, in their order there; copies that [`Self::split_pinches`] makes come after them.
///
/// # Examples
/// One of two tetrahedra on a common face:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::boolean::{CellSelection, SelectionMesh};
/// use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
/// use coface_geometry::Positions;
/// use coface_algebra::CellId;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let flat = vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 6., 0., 0., -12.];
/// let positions = Positions::from_flat(3, flat)?;
/// let faces = [[0, 1, 2], [0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 1, 4], [1, 2, 4], [2, 0, 4]];
/// let complex = PolygonalComplex::from_polygons(5, &RaggedArray::from_lists(faces))?;
/// let cells = SpatialCells::new(complex, &positions)?;
/// let lower = (0..2).map(|cell| cells.volumes(&positions).map(|volumes| volumes[cell] == 2.0));
/// let selection = CellSelection::new(lower.collect::<Result<_, _>>()?, false);
/// let boundary = selection.boundary(&cells.chain_complex()?)?;
/// let mesh = SelectionMesh::new(boundary.facets(), |facet, add| add(&faces[facet.index()]));
/// assert_eq!(mesh.polygons().len(), 4);
/// assert_eq!(mesh.vertex_sources(), [0, 1, 2, 4].map(CellId::new));
/// // The front of the common face is outside the lower tetrahedron.
/// assert_eq!(mesh.polygons().list(0), [0, 1, 2]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SelectionMesh {
    polygons: RaggedArray,
    facets: Vec<(CellId, Sign)>,
    vertex_sources: Vec<CellId>,
}

/// A side of a polygon: its ends, the smaller first, and the corner that it begins at.
type Side = ([u32; 2], u32);

impl SelectionMesh {
    /// The mesh of these facets, plus where the selection is behind. `pieces` gives the polygons that make up a facet,
    /// vertices of the arrangement in the direction of the facet.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Panics
    /// From 2^32 corners on.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, Sign};
    /// use coface_arrange::boolean::SelectionMesh;
    /// // A triangle on the vertices 4, 6 and 9 of an arrangement, seen from behind.
    /// let facets = [(CellId::new(2), Sign::Minus)];
    /// let mesh = SelectionMesh::new(&facets, |_, add| add(&[4, 6, 9]));
    /// assert_eq!(mesh.polygons().len(), 1);
    /// ```
    pub fn new(facets: &[(CellId, Sign)], pieces: impl Fn(CellId, &mut dyn FnMut(&[u32]))) -> Self {
        let mut mesh = Self { polygons: RaggedArray::new(), facets: Vec::new(), vertex_sources: Vec::new() };
        mesh.facets.reserve(facets.len());
        for &facet in facets {
            pieces(facet.0, &mut |polygon| mesh.push(facet, polygon));
        }
        mesh.number_vertices();
        mesh
    }

    /// The mesh of these polygons, each with its facet and in the direction of the facet, the facets one after the
    /// other.
    #[doc(hidden)]
    pub fn of_pieces<'a>(pieces: impl Iterator<Item = ((CellId, Sign), &'a [u32])>) -> Self {
        let mut mesh = Self { polygons: RaggedArray::new(), facets: Vec::new(), vertex_sources: Vec::new() };
        pieces.for_each(|(facet, polygon)| mesh.push(facet, polygon));
        mesh.number_vertices();
        mesh
    }

    /// The same surface with other triangles on its vertices, each with the number of a polygon of before, whose facet is its
    /// own.
    #[doc(hidden)]
    pub fn with_triangles(&self, triangles: impl Iterator<Item = ([u32; 3], u32)>) -> Self {
        let mut mesh = Self { polygons: RaggedArray::new(), facets: Vec::new(), vertex_sources: Vec::new() };
        for (triangle, polygon) in triangles {
            mesh.polygons.push(&triangle);
            mesh.facets.push(self.facets[polygon as usize]);
        }
        mesh.number_vertices();
        for source in &mut mesh.vertex_sources {
            *source = self.vertex_sources[source.index()];
        }
        mesh
    }

    fn push(&mut self, facet: (CellId, Sign), polygon: &[u32]) {
        let start = self.polygons.item_count();
        self.polygons.push(polygon);
        if facet.1 == Sign::Minus {
            self.polygons.items_mut()[start..].reverse();
        }
        self.facets.push(facet);
    }

    /// Numbers the vertices of the arrangement that polygons have.
    fn number_vertices(&mut self) {
        let count = self.polygons.items().iter().max().map_or(0, |&last| last as usize + 1);
        let mut numbers = vec![NONE; count];
        self.polygons.items().iter().for_each(|&vertex| numbers[vertex as usize] = 0);
        for (vertex, number) in numbers.iter_mut().enumerate().filter(|(_, number)| **number == 0) {
            *number = self.vertex_sources.len() as u32;
            self.vertex_sources.push(CellId::new(vertex));
        }
        self.polygons.items_mut().iter_mut().for_each(|vertex| *vertex = numbers[*vertex as usize]);
    }

    /// The polygons, counterclockwise seen from outside the selection.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, Sign};
    /// use coface_arrange::boolean::SelectionMesh;
    /// // A triangle on the vertices 4, 6 and 9 of an arrangement, seen from behind.
    /// let facets = [(CellId::new(2), Sign::Minus)];
    /// let mesh = SelectionMesh::new(&facets, |_, add| add(&[4, 6, 9]));
    /// assert_eq!(mesh.polygons().list(0).len(), 3);
    /// ```
    pub fn polygons(&self) -> &RaggedArray {
        &self.polygons
    }

    /// The facet that each polygon is part of, plus where the selection is behind it: where the polygon has its
    /// direction.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, Sign};
    /// use coface_arrange::boolean::SelectionMesh;
    /// // A triangle on the vertices 4, 6 and 9 of an arrangement, seen from behind.
    /// let facets = [(CellId::new(2), Sign::Minus)];
    /// let mesh = SelectionMesh::new(&facets, |_, add| add(&[4, 6, 9]));
    /// assert_eq!(mesh.facets(), facets);
    /// ```
    pub fn facets(&self) -> &[(CellId, Sign)] {
        &self.facets
    }

    /// The vertex of the arrangement that each vertex is, or is a copy of.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, Sign};
    /// use coface_arrange::boolean::SelectionMesh;
    /// // A triangle on the vertices 4, 6 and 9 of an arrangement, seen from behind.
    /// let facets = [(CellId::new(2), Sign::Minus)];
    /// let mesh = SelectionMesh::new(&facets, |_, add| add(&[4, 6, 9]));
    /// assert_eq!(mesh.vertex_sources(), [4, 6, 9].map(CellId::new));
    /// ```
    pub fn vertex_sources(&self) -> &[CellId] {
        &self.vertex_sources
    }

    /// Where the vertices are, given the vertices of the arrangement.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if there are fewer positions than vertices of the arrangement.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, Sign};
    /// use coface_arrange::boolean::SelectionMesh;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle on the vertices 4, 6 and 9 of an arrangement, seen from behind.
    /// let facets = [(CellId::new(2), Sign::Minus)];
    /// let mesh = SelectionMesh::new(&facets, |_, add| add(&[4, 6, 9]));
    /// let all = Positions::from_flat(1, (0..10).map(f64::from).collect())?;
    /// assert_eq!(mesh.positions(&all)?.as_flat(), [4.0, 6.0, 9.0]);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self, positions: &Positions) -> Result<Positions, Error> {
        if let Some(last) = self.vertex_sources.iter().find(|source| source.index() >= positions.len()) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("there is no position for v{}; there are {}", last.index(), positions.len()),
            ));
        }
        let flat = self
            .vertex_sources
            .iter()
            .flat_map(|source| positions.point(coface_algebra::VertexId::from_u32(source.to_u32())))
            .copied()
            .collect();
        Positions::from_flat(positions.dimension(), flat)
    }

    /// Splits the vertices at which the mesh is pinched, so that solids which touch in a vertex or an edge come apart:
    /// each fan of polygons gets a copy of its own, and the first fan keeps the vertex. At an edge with more than two
    /// polygons those stay together that have one part of the selection between them.
    ///
    /// `around` lists the facets of the arrangement around the edge between two vertices of it, counterclockwise seen
    /// from the second of them, with minus where the facet runs from the second to the first along its side. Returns
    /// the number of copies.
    ///
    /// What is left is a closed surface but for edges whose ends are both joined around the pinch: they lie in four or
    /// more polygons still, since an edge is known by its ends.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] when copies do not fit in 32 bits; [`ErrorKind::Shape`] if `around` does not list the
    /// facets of the mesh at an edge.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n corners.
    pub fn split_pinches(
        &mut self,
        around: impl Fn([CellId; 2]) -> Vec<(CellId, Sign)>,
    ) -> Result<usize, Error> {
        let sides = self.sides();
        let mut fans = self.fans(&sides, &[], &around)?;
        // Where the selection goes around an edge, as around a slit in a face, that does not take the sides apart: then those stay
        // together that have the outside between them.
        let mut turned: Vec<[u32; 2]> = Vec::new();
        for group in sides.chunk_by(|x, y| x.0 == y.0).filter(|group| group.len() > 2) {
            let mut own: Vec<[u32; 2]> =
                group.iter().map(|side| self.ends(side).map(|end| fans.find(end))).collect();
            own.sort_unstable();
            if own.chunk_by(|x, y| x == y).any(|same| same.len() > 2) {
                turned.push(group[0].0);
            }
        }
        if !turned.is_empty() {
            fans = self.fans(&sides, &turned, &around)?;
        }
        // The copy of each fan, by its root.
        let mut copies = vec![NONE; self.polygons.item_count()];
        let mut is_taken = vec![false; self.vertex_sources.len()];
        let before = self.vertex_sources.len();
        for corner in 0..self.polygons.item_count() as u32 {
            let vertex = self.polygons.items()[corner as usize];
            let copy = &mut copies[fans.find(corner) as usize];
            if *copy == NONE {
                *copy = if std::mem::replace(&mut is_taken[vertex as usize], true) {
                    self.vertex_sources.push(self.vertex_sources[vertex as usize]);
                    u32::try_from(self.vertex_sources.len() - 1)
                        .map_err(|_| Error::new(ErrorKind::TooLarge, "2^32 or more copies of vertices"))?
                } else {
                    vertex
                };
            }
        }
        for corner in 0..copies.len() as u32 {
            let copy = copies[fans.find(corner) as usize];
            self.polygons.items_mut()[corner as usize] = copy;
        }
        Ok(self.vertex_sources.len() - before)
    }

    /// All sides, sorted by their ends.
    fn sides(&self) -> Vec<Side> {
        let mut sides: Vec<Side> = Vec::with_capacity(self.polygons.item_count());
        for (i, polygon) in self.polygons.iter().enumerate() {
            let start = self.polygons.start(i);
            for (k, &from) in polygon.iter().enumerate() {
                let to = polygon[(k + 1) % polygon.len()];
                sides.push(([from.min(to), from.max(to)], (start + k) as u32));
            }
        }
        sides.sort_unstable();
        sides
    }

    /// The polygon of a corner, and the next corner around it.
    fn next(&self, corner: u32) -> (usize, u32) {
        let polygon = self.polygon_at(corner);
        let start = self.polygons.start(polygon);
        let within = corner as usize - start;
        (polygon, (start + (within + 1) % self.polygons.list(polygon).len()) as u32)
    }

    fn polygon_at(&self, corner: u32) -> usize {
        let (mut low, mut high) = (0, self.polygons.len());
        while high - low > 1 {
            let middle = usize::midpoint(low, high);
            if self.polygons.start(middle) <= corner as usize {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }

    /// Whether a side runs from the smaller of its ends to the larger.
    fn rises(&self, side: &Side) -> bool {
        self.polygons.items()[side.1 as usize] == side.0[0]
    }

    /// The corners that stay together, at pinched edges with the selection between them; with the outside at those that are `turned`,
    /// rising.
    fn fans(
        &self,
        sides: &[Side],
        turned: &[[u32; 2]],
        around: impl Fn([CellId; 2]) -> Vec<(CellId, Sign)>,
    ) -> Result<UnionFind, Error> {
        let mut fans = UnionFind::new(self.polygons.item_count());
        for group in sides.chunk_by(|x, y| x.0 == y.0) {
            match group {
                [side, other] => self.join(&mut fans, side, other),
                _ => {
                    let is_turned = turned.binary_search(&group[0].0).is_ok();
                    for [side, other] in self.pairs(group, is_turned, &around)? {
                        self.join(&mut fans, side, other);
                    }
                }
            }
        }
        Ok(fans)
    }

    /// The corners at the lower and the higher end of a side.
    fn ends(&self, side: &Side) -> [u32; 2] {
        let (from, to) = (side.1, self.next(side.1).1);
        if self.rises(side) { [from, to] } else { [to, from] }
    }

    /// Puts the corners of two sides at both ends of an edge together.
    fn join(&self, fans: &mut UnionFind, side: &Side, other: &Side) {
        let (mine, theirs) = (self.ends(side), self.ends(other));
        fans.unite(mine[0], theirs[0]);
        fans.unite(mine[1], theirs[1]);
    }

    /// The sides at an edge in pairs with the selection between them, or the outside if they are turned.
    fn pairs<'a>(
        &self,
        group: &'a [Side],
        is_turned: bool,
        around: impl Fn([CellId; 2]) -> Vec<(CellId, Sign)>,
    ) -> Result<Vec<[&'a Side; 2]>, Error> {
        let ends = group[0].0.map(|vertex| self.vertex_sources[vertex as usize]);
        // A side of a facet is known by the facet and by its direction in it.
        let mut known: Vec<((CellId, Sign), &Side, bool)> = group
            .iter()
            .map(|side| {
                let (facet, sign) = self.facets[self.polygon_at(side.1)];
                let run = Sign::power_of_minus_one(usize::from(!self.rises(side)));
                let own = run.times(sign);
                // Counterclockwise after a side that runs along the edge comes the front of its facet, else the back;
                // the selection is behind facets with plus.
                ((facet, own), side, own != sign)
            })
            .collect();
        known.sort_unstable_by_key(|&(key, ..)| key);
        let circle: Vec<(&Side, bool)> = around(ends)
            .into_iter()
            .filter_map(|key| known.binary_search_by_key(&key, |&(key, ..)| key).ok())
            .map(|at| (known[at].1, known[at].2))
            .collect();
        if circle.len() != group.len() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "{} of the {} facets at the edge between v{} and v{} are listed",
                    circle.len(),
                    group.len(),
                    ends[0].index(),
                    ends[1].index()
                ),
            ));
        }
        let next = |i: usize| circle[(i + 1) % circle.len()].0;
        Ok((0..circle.len()).filter(|&i| circle[i].1 != is_turned).map(|i| [circle[i].0, next(i)]).collect())
    }
}
