//! Ideal vertices of gluing tables of tetrahedra, cut off.

use crate::gluing::faces::FaceClasses;
use crate::gluing::manifold::link_euler_characteristics;
use crate::gluing::table::GluingTable;
use coface_algebra::{CellId, Error};

/// The vertices of a tetrahedron.
const CORNERS: usize = 4;

/// The vertex of a piece that is the middle of the tetrahedron.
const MIDDLE: usize = 0;

/// A tetrahedron of the truncated table: the cone from the middle of an old tetrahedron over a triangle in its boundary.
///
/// Vertex 0 is that middle. Of the first two kinds vertex 1 is the middle of the facet.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Piece {
    /// Over an edge of a facet: vertices 2 and 3 are at its ends, rising.
    Edge { facet: usize, ends: (usize, usize) },
    /// Over the edge that a cut through a corner leaves in a facet: vertices 2 and 3 are on the edges from the corner to the two other
    /// corners of the facet, rising.
    Corner { facet: usize, corner: usize },
    /// Over the triangle of a cut: vertices 1, 2, 3 are on the edges from the corner to the others, rising.
    Cut { corner: usize },
}

/// A piece on the other side of a facet, and the images of the vertices there.
type Side = (usize, [u32; CORNERS]);

/// The two corners beside two others, rising.
fn others(a: usize, b: usize) -> (usize, usize) {
    let mut rest = (0..CORNERS).filter(|&corner| corner != a && corner != b);
    let mut next = || rest.next().expect("a tetrahedron has two corners beside two");
    (next(), next())
}

/// The vertex of the cut through a corner that is on the edge to another.
fn end(corner: usize, other: usize) -> usize {
    if other > corner { other } else { other + 1 }
}

fn rising(a: usize, b: usize) -> (usize, usize) {
    (a.min(b), a.max(b))
}

/// The pieces of a tetrahedron whose corners in this set are cut off.
fn pieces_of(cut: u32) -> Vec<Piece> {
    let corners = move || (0..CORNERS).filter(move |&corner| cut >> corner & 1 == 1);
    let mut pieces = Vec::with_capacity(28);
    for facet in 0..CORNERS {
        for a in (0..CORNERS).filter(|&a| a != facet) {
            for b in (a + 1..CORNERS).filter(|&b| b != facet) {
                pieces.push(Piece::Edge { facet, ends: (a, b) });
            }
        }
        pieces.extend(
            corners().filter(|&corner| corner != facet).map(|corner| Piece::Corner { facet, corner }),
        );
    }
    pieces.extend(corners().map(|corner| Piece::Cut { corner }));
    pieces
}

/// The pieces of all tetrahedra.
struct Pieces<'a> {
    table: &'a GluingTable,
    /// The corners of each tetrahedron that are cut off, as bits.
    cuts: Vec<u32>,
    /// The first piece of each tetrahedron.
    starts: Vec<usize>,
    /// The pieces for each set of corners.
    kinds: Vec<Vec<Piece>>,
}

impl<'a> Pieces<'a> {
    fn new(table: &'a GluingTable, cuts: Vec<u32>) -> Self {
        let kinds: Vec<Vec<Piece>> = (0..1 << CORNERS).map(pieces_of).collect();
        let mut starts = vec![0];
        for &cut in &cuts {
            starts.push(starts[starts.len() - 1] + kinds[cut as usize].len());
        }
        Self { table, cuts, starts, kinds }
    }

    fn of(&self, simplex: usize) -> &[Piece] {
        &self.kinds[self.cuts[simplex] as usize]
    }

    fn number(&self, simplex: usize, piece: Piece) -> usize {
        let place = self.of(simplex).iter().position(|&other| other == piece);
        self.starts[simplex] + place.expect("pieces beside each other have the same corners cut off")
    }

    /// What a facet of a piece is glued to, if it is no boundary.
    fn side(&self, simplex: usize, piece: Piece, facet: usize) -> Option<Side> {
        match facet {
            MIDDLE => self.outside(simplex, piece),
            _ => Some(self.inside(simplex, piece, facet)),
        }
    }

    /// Through the facet of the tetrahedron.
    fn outside(&self, simplex: usize, piece: Piece) -> Option<Side> {
        let (facet, ends) = match piece {
            Piece::Cut { .. } => return None,
            Piece::Edge { facet, ends } => (facet, ends),
            Piece::Corner { facet, corner } => (facet, others(facet, corner)),
        };
        let (next, images) = self.table.neighbor(simplex, facet)?;
        let image = |corner: usize| images[corner] as usize;
        let (a, b) = (image(ends.0), image(ends.1));
        let there = match piece {
            Piece::Corner { corner, .. } => Piece::Corner { facet: image(facet), corner: image(corner) },
            _ => Piece::Edge { facet: image(facet), ends: rising(a, b) },
        };
        Some((self.number(next, there), if a < b { [0, 1, 2, 3] } else { [0, 1, 3, 2] }))
    }

    /// Through a facet at the middle of the tetrahedron, which is opposite to this vertex of the piece.
    fn inside(&self, simplex: usize, piece: Piece, vertex: usize) -> Side {
        let mut images = [0; CORNERS];
        let there = match (piece, vertex) {
            // Across the edge of the tetrahedron.
            (Piece::Edge { facet, ends }, 1) => {
                let (c, d) = others(ends.0, ends.1);
                images = [0, 1, 2, 3];
                Piece::Edge { facet: if c == facet { d } else { c }, ends }
            }
            // From a facet to the cut.
            (Piece::Corner { facet, corner }, 1) => {
                let (a, b) = others(facet, corner);
                images = [0, end(corner, facet), end(corner, a), end(corner, b)].map(|image| image as u32);
                Piece::Cut { corner }
            }
            // Along a facet, at one end of an edge.
            (Piece::Edge { facet, ends }, _) => {
                let (at, left) = if vertex == 3 { (2, ends.1) } else { (3, ends.0) };
                let corner = if at == 2 { ends.0 } else { ends.1 };
                let (a, b) = others(facet, corner);
                let next = if a == left { b } else { a };
                images[1] = 1;
                let is_cut = self.cuts[simplex] >> corner & 1 == 1;
                // At an end that is cut off the piece beside is that of the corner, and begins on this edge.
                let is_first = if is_cut { left < next } else { corner < next };
                (images[at], images[vertex]) = if is_first { (2, 3) } else { (3, 2) };
                match is_cut {
                    true => Piece::Corner { facet, corner },
                    false => Piece::Edge { facet, ends: rising(corner, next) },
                }
            }
            // Along a facet, from a corner that is cut off to an edge.
            (Piece::Corner { facet, corner }, _) => {
                let at = 5 - vertex;
                let (a, b) = others(facet, corner);
                let other = if at == 2 { a } else { b };
                images[1] = 1;
                (images[at], images[vertex]) = if corner < other { (2, 3) } else { (3, 2) };
                Piece::Edge { facet, ends: rising(corner, other) }
            }
            // From the cut to a facet.
            (Piece::Cut { corner }, _) => {
                let mut beside = (0..CORNERS).filter(|&other| other != corner);
                let facet = beside
                    .find(|&other| end(corner, other) == vertex)
                    .expect("vertices 1 to 3 of a cut are on the three edges");
                let (a, b) = others(facet, corner);
                images[vertex] = 1;
                images[end(corner, a)] = 2;
                images[end(corner, b)] = 3;
                Piece::Corner { facet, corner }
            }
        };
        (self.number(simplex, there), images)
    }
}

impl GluingTable {
    /// The **ideal** vertices of a table of tetrahedra, rising: those whose link is a closed surface other than a sphere. Tables of other
    /// dimensions, and those with a folded edge, have none. `faces` are the face classes of the table.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`](coface_algebra::ErrorKind::Shape) for the face classes of another table.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// The complement of the figure-eight knot has a cusp; the lens space L(3, 1) has none.
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let knot = GluingTable::from_isomorphism_signature("cPcbbbiht", 3)?;
    /// assert_eq!(knot.ideal_vertices(&knot.faces()?)?, [CellId::new(0)]);
    /// let lens = GluingTable::from_isomorphism_signature("cMcabbgqw", 3)?;
    /// assert!(lens.ideal_vertices(&lens.faces()?)?.is_empty());
    /// # Ok(()) }
    /// ```
    pub fn ideal_vertices(&self, faces: &FaceClasses) -> Result<Vec<CellId>, Error> {
        self.check_faces(faces)?;
        if self.dimension() != 3 || faces.has_folds() {
            return Ok(Vec::new());
        }
        let found = link_euler_characteristics(faces);
        let is_ideal = |&vertex: &CellId| !faces.is_boundary(0, vertex) && found[vertex.index()] != 2;
        Ok((0..found.len()).map(CellId::new).filter(is_ideal).collect())
    }

    /// The table with its [ideal vertices](Self::ideal_vertices) cut off: where all others are spheres or disks, a manifold whose boundary
    /// has the links of the ideal vertices as further components. Without ideal vertices it is the table itself.
    ///
    /// Each tetrahedron becomes 12 tetrahedra, and 4 more for each corner that is cut off: cones from its middle over its facets, which are
    /// cones from theirs, and over the triangles of the cuts.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`](coface_algebra::ErrorKind::Shape) for the face classes of another table; [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) as [`Self::unglued`].
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # References
    /// W. P. Thurston, *Three-dimensional geometry and topology* (1997), section 3.2.
    ///
    /// # Examples
    /// The complement of the figure-eight knot has a torus as its boundary.
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let knot = GluingTable::from_isomorphism_signature("cPcbbbiht", 3)?;
    /// let bounded = knot.truncated(&knot.faces()?)?;
    /// assert_eq!(bounded.simplex_count(), 2 * (12 + 4 * 4));
    /// assert_eq!(bounded.boundary_table()?.0.faces()?.alternating_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn truncated(&self, faces: &FaceClasses) -> Result<Self, Error> {
        let ideal = self.ideal_vertices(faces)?;
        if ideal.is_empty() {
            return Ok(self.clone());
        }
        let is_cut = |simplex: usize, corner: usize| {
            let class = CellId::new(faces.of_face(simplex, 1 << corner).0);
            ideal.binary_search(&class).is_ok()
        };
        let cut_of = |simplex: usize| {
            (0..CORNERS).filter(|&corner| is_cut(simplex, corner)).map(|corner| 1_u32 << corner).sum()
        };
        let pieces = Pieces::new(self, (0..self.simplex_count()).map(cut_of).collect());
        let mut table = Self::unglued(self.dimension(), pieces.starts[self.simplex_count()])?;
        for simplex in 0..self.simplex_count() {
            for (place, &piece) in pieces.of(simplex).iter().enumerate() {
                let own = pieces.starts[simplex] + place;
                for facet in 0..CORNERS {
                    if table.neighbor(own, facet).is_none()
                        && let Some((other, images)) = pieces.side(simplex, piece, facet)
                    {
                        table.glue(own, facet, other, &images)?;
                    }
                }
            }
        }
        Ok(table)
    }
}
