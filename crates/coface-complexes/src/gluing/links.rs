//! Vertex links and the boundary of a gluing table, as gluing tables of one dimension less.

use crate::gluing::faces::FaceClasses;
use crate::gluing::table::GluingTable;
use coface_algebra::{CellId, Error, ErrorKind, VertexId};

/// The link of a vertex class: the boundary of a small neighborhood of the vertex.
///
/// It has a simplex for each **corner**, a simplex of the table with one of its vertices in the class: the part of the
/// link that cuts this corner off. Its vertices are the other vertices of the simplex, in rising order.
///
/// # Examples
/// The link of the one vertex of a torus of two triangles is a circle of six segments.
/// ```
/// use coface_complexes::gluing::GluingTable;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mut torus = GluingTable::unglued(2, 2)?;
/// torus.glue(0, 0, 1, &[2, 0, 1])?;
/// torus.glue(0, 1, 1, &[0, 1, 2])?;
/// torus.glue(0, 2, 1, &[1, 2, 0])?;
/// let faces = torus.faces()?;
/// let links = torus.vertex_links(&faces)?;
/// assert_eq!((links.len(), links[0].table().simplex_count()), (1, 6));
/// assert!(links[0].table().is_closed());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VertexLink {
    table: GluingTable,
    corners: Vec<(u32, u32)>,
}

impl VertexLink {
    /// The link as a gluing table.
    pub fn table(&self) -> &GluingTable {
        &self.table
    }

    /// For each simplex of the link the corner that it cuts off: a simplex of the table and its vertex.
    pub fn corners(&self) -> &[(u32, u32)] {
        &self.corners
    }
}

/// The place of a vertex among those of 0 to n without one that is left out.
fn squeezed(vertex: usize, left_out: usize) -> usize {
    if vertex > left_out { vertex - 1 } else { vertex }
}

/// The vertex at a place among those of 0 to n without one.
fn spread(place: usize, left_out: usize) -> usize {
    if place >= left_out { place + 1 } else { place }
}

impl GluingTable {
    /// The links of all vertex classes, in their order. `faces` are the face classes of this table.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] for dimension 1, where links are points; [`ErrorKind::Shape`] for the face classes
    /// of another table.
    ///
    /// # Complexity
    /// $O(n^3)$ for each n-simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = GluingTable::unglued(2, 1)?;
    /// let links = triangle.vertex_links(&triangle.faces()?)?;
    /// assert_eq!(links.len(), 3);
    /// assert_eq!(links[2].corners(), [(0, 2)]);
    /// # Ok(()) }
    /// ```
    pub fn vertex_links(&self, faces: &FaceClasses) -> Result<Vec<VertexLink>, Error> {
        let width = self.dimension() + 1;
        self.check_faces(faces)?;
        self.check_codimension_one()?;
        let mut corners: Vec<Vec<(u32, u32)>> =
            vec![Vec::new(); faces.class_counts().first().copied().unwrap_or(0)];
        let mut places = vec![0_u32; self.simplex_count() * width];
        for i in 0..self.simplex_count() {
            for v in 0..width {
                let class = &mut corners[faces.of_face(i, 1 << v).0];
                places[i * width + v] = class.len() as u32;
                class.push((i as u32, v as u32));
            }
        }
        corners.into_iter().map(|corners| self.link_of(corners, &places)).collect()
    }

    /// Refuses face classes that cannot be those of this table.
    pub(super) fn check_faces(&self, faces: &FaceClasses) -> Result<(), Error> {
        let counts = faces.class_counts();
        let is_own = match counts.last() {
            Some(&count) => counts.len() == self.dimension() + 1 && count == self.simplex_count(),
            None => self.simplex_count() == 0,
        };
        if is_own {
            return Ok(());
        }
        Err(Error::new(ErrorKind::Shape, "the face classes are of another gluing table")
            .with_cure("take those that the table itself gives"))
    }

    fn check_codimension_one(&self) -> Result<(), Error> {
        if self.dimension() >= 2 {
            return Ok(());
        }
        Err(Error::new(
            ErrorKind::UnsupportedFormat,
            "links and boundary of a gluing table of dimension 1 are points, which no gluing table holds",
        )
        .with_cure("count the boundary facets"))
    }

    fn link_of(&self, corners: Vec<(u32, u32)>, places: &[u32]) -> Result<VertexLink, Error> {
        let width = self.dimension() + 1;
        let mut table = Self::unglued(self.dimension() - 1, corners.len())?;
        let mut moved = vec![0; width - 1];
        for (at, &(i, v)) in corners.iter().enumerate() {
            let v = v as usize;
            for place in 0..width - 1 {
                let Some((j, images)) = self.neighbor(i as usize, spread(place, v)) else { continue };
                let w = images[v] as usize;
                for (k, slot) in moved.iter_mut().enumerate() {
                    *slot = squeezed(images[spread(k, v)] as usize, w) as u32;
                }
                let other = places[j * width + w] as usize;
                if table.neighbor(at, place).is_none() {
                    table.glue(at, place, other, &moved)?;
                }
            }
        }
        Ok(VertexLink { table, corners })
    }

    /// The boundary: a table with a simplex for each facet without gluing, in their order, whose vertices are those of
    /// the facet, rising; and these facets.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] for dimension 1, where the boundary consists of points.
    ///
    /// # Complexity
    /// $O(n)$ for each simplex around each face of codimension 2 of the boundary.
    ///
    /// # Examples
    /// The boundary of a tetrahedron is the sphere of four triangles.
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (sphere, facets) = GluingTable::unglued(3, 1)?.boundary_table()?;
    /// assert_eq!(sphere.faces()?.class_counts(), [4, 6, 4]);
    /// assert_eq!(facets[2], (0, 2));
    /// # Ok(()) }
    /// ```
    pub fn boundary_table(&self) -> Result<(Self, Vec<(usize, usize)>), Error> {
        self.check_codimension_one()?;
        let width = self.dimension() + 1;
        let facets: Vec<(usize, usize)> = self.boundary_facets().collect();
        let mut table = Self::unglued(self.dimension() - 1, facets.len())?;
        for (at, &(simplex, facet)) in facets.iter().enumerate() {
            for place in 0..width - 1 {
                if table.neighbor(at, place).is_some() {
                    continue;
                }
                // Around the face without the vertices `here` and `there`, crossing the facets opposite to `there`.
                let (mut i, mut here, mut there) = (simplex, facet, spread(place, facet));
                let mut images: Vec<usize> = (0..width).collect();
                while let Some((j, step)) = self.neighbor(i, there) {
                    images.iter_mut().for_each(|image| *image = step[*image] as usize);
                    (i, here, there) = (j, step[there] as usize, step[here] as usize);
                }
                // Now `there` is opposite to the boundary facet met, and the face misses `here` of its vertices. The
                // first boundary facet missed `facet`; its vertex opposite to the face goes to `here`.
                let first_apex = spread(place, facet);
                let moved: Vec<u32> = (0..width - 1)
                    .map(|k| {
                        let vertex = spread(k, facet);
                        let image = if vertex == first_apex { here } else { images[vertex] };
                        squeezed(image, there) as u32
                    })
                    .collect();
                let other =
                    facets.binary_search(&(i, there)).expect("a facet without gluing is on the boundary");
                table.glue(at, place, other, &moved)?;
            }
        }
        Ok((table, facets))
    }
}

impl FaceClasses {
    /// The cells of [`Self::chain_complex`] that lie in the boundary, by degree: the boundary classes, or with folds the
    /// simplices of the barycentric subdivision that they carry.
    ///
    /// # Errors
    /// As [`Self::barycentric_subdivision`].
    ///
    /// # Complexity
    /// Linear in the classes; with folds, in the subdivision.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut band = GluingTable::unglued(2, 1)?;
    /// band.glue(0, 2, 0, &[1, 2, 0])?;
    /// let counts: Vec<usize> = band.faces()?.boundary_cells()?.iter().map(Vec::len).collect();
    /// assert_eq!(counts, [1, 1, 0]);
    /// # Ok(()) }
    /// ```
    pub fn boundary_cells(&self) -> Result<Vec<Vec<CellId>>, Error> {
        let degrees = 0..self.class_counts().len();
        if !self.has_folds() {
            let counts = self.class_counts();
            let of_degree =
                |k| (0..counts[k]).map(CellId::new).filter(|&class| self.is_boundary(k, class)).collect();
            return Ok(degrees.map(of_degree).collect());
        }
        let fine = self.barycentric_subdivision()?;
        let is_boundary = |degree: usize, cell: usize| {
            // The last vertex of a chain is the barycenter of its carrier.
            let last = VertexId::new(fine.complex().back_face(degree, CellId::new(cell), 0).index());
            let (degree, class) = fine.carriers()[last];
            self.is_boundary(degree, class)
        };
        let of_degree = |k| {
            let cells = 0..fine.complex().simplex_count(k);
            cells.filter(|&cell| is_boundary(k, cell)).map(CellId::new).collect()
        };
        Ok(degrees.map(of_degree).collect())
    }
}
