//! Signed lengths, areas and volumes of cells by their boundaries.

use super::exact::ExactPoints;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_algebra::{Integer, SparseMatrix};
use coface_geometry::Positions;
use rayon::prelude::*;

/// The boundary matrices below the cells that are measured, and where the vertices are.
pub(super) struct Frame<'a> {
    lower: &'a [SparseMatrix],
    positions: &'a Positions,
}

/// A rounded sum: what it is, the sum of the sizes of its terms, and their number.
#[derive(Clone, Copy, Debug, Default)]
struct Rounded {
    value: f64,
    size: f64,
    term_count: usize,
}

impl Rounded {
    fn add(&mut self, term: f64, size: f64) {
        self.value += term;
        self.size += size;
        self.term_count += 1;
    }

    /// The sign, if the error of rounding is smaller than the value. A term is a product of at most three differences and an
    /// earlier sum; each operation errs by half a unit in the last place of at most the size.
    fn sign(&self) -> Option<i32> {
        let bound = (self.term_count + 16) as f64 * f64::EPSILON * self.size;
        // Below that, products may have lost everything.
        let is_ordinary = self.size > 1e-250;
        (is_ordinary && self.value.abs() > bound).then_some(if self.value > 0.0 { 1 } else { -1 })
    }
}

impl<'a> Frame<'a> {
    /// # Errors
    /// [`ErrorKind::Shape`] unless each vertex has a position.
    pub(super) fn new(lower: &'a [SparseMatrix], positions: &'a Positions) -> Result<Self, Error> {
        let vertex_count = lower.first().map_or(0, SparseMatrix::row_count);
        if positions.len() < vertex_count {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} positions for {vertex_count} vertices", positions.len()),
            ));
        }
        Ok(Self { lower, positions })
    }

    /// The degree of the cells that are measured.
    pub(super) fn degree(&self) -> usize {
        self.lower.len() + 1
    }

    /// The start and the end of an edge; the same for one without boundary.
    fn ends(&self, edge: usize) -> (u32, u32) {
        let column = self.lower[0].column(edge);
        match (column.rows(), column.entries()) {
            (&[a, b], &[entry, _]) => {
                if entry < 0 {
                    (a, b)
                } else {
                    (b, a)
                }
            }
            _ => (0, 0),
        }
    }

    fn coordinate(&self, vertex: u32, axis: usize) -> f64 {
        self.positions.point(VertexId::from_u32(vertex))[axis]
    }

    /// A vertex of a cycle of facets of the measured degree; `None` for one without vertices.
    fn some_vertex(&self, facet: usize) -> Option<u32> {
        match self.degree() {
            1 => Some(facet as u32),
            2 => Some(self.ends(facet).0),
            _ => self.lower[1].column(facet).rows().first().map(|&edge| self.ends(edge as usize).0),
        }
    }

    /// The vertices of some facets, as often as they come.
    fn vertices<'t>(&'t self, facets: &'t [(usize, i32)]) -> Box<dyn Iterator<Item = u32> + 't> {
        let ends = |edge: usize| <[u32; 2]>::from(self.ends(edge));
        match self.degree() {
            1 => Box::new(facets.iter().map(|&(vertex, _)| vertex as u32)),
            2 => Box::new(facets.iter().flat_map(move |&(edge, _)| ends(edge))),
            _ => Box::new(facets.iter().flat_map(move |&(face, _)| {
                self.lower[1].column(face).rows().iter().flat_map(move |&edge| ends(edge as usize))
            })),
        }
    }

    /// The points of all vertices of some facets.
    pub(super) fn points(&self, facets: &[(usize, i32)]) -> ExactPoints {
        ExactPoints::new(self.positions, self.vertices(facets))
    }

    /// The measure of the cell with this boundary, times the factorial of its degree, exactly: a length or volume, or an
    /// area vector.
    pub(super) fn exact(&self, points: &ExactPoints, boundary: &[(usize, i32)]) -> Vec<Integer> {
        match self.degree() {
            1 => vec![points.length(boundary.iter().map(|&(vertex, sign)| (vertex as u32, sign)))],
            2 => points.area(boundary.iter().map(|&(edge, sign)| {
                let (tail, head) = self.ends(edge);
                (tail, head, sign)
            })),
            _ => {
                let mut sum = Integer::ZERO;
                for &(face, sign) in boundary {
                    let Some(apex) = self.some_vertex(face) else { continue };
                    let area = points.area(self.lower[1].column(face).iter().map(|(edge, entry)| {
                        let (tail, head) = self.ends(edge);
                        (tail, head, entry)
                    }));
                    sum += &(&points.cone(apex, &area) * &Integer::from(sign));
                }
                vec![sum]
            }
        }
    }

    /// The measure of a cell of full dimension times the factorial of its degree, rounded.
    fn rounded(&self, boundary: &[(usize, i32)]) -> Rounded {
        let mut sum = Rounded::default();
        let Some(origin) = boundary.first().and_then(|&(facet, _)| self.some_vertex(facet)) else {
            return sum;
        };
        let relative =
            |vertex: u32, axis: usize| self.coordinate(vertex, axis) - self.coordinate(origin, axis);
        match self.degree() {
            1 => {
                for &(vertex, sign) in boundary {
                    let x = relative(vertex as u32, 0) * f64::from(sign);
                    sum.add(x, x.abs());
                }
            }
            2 => {
                for &(edge, sign) in boundary {
                    let (a, b) = self.ends(edge);
                    let (p, q) = (relative(a, 0) * relative(b, 1), relative(a, 1) * relative(b, 0));
                    sum.add((p - q) * f64::from(sign), p.abs() + q.abs());
                }
            }
            _ => {
                for &(face, sign) in boundary {
                    let Some(apex) = self.some_vertex(face) else { continue };
                    let apex = [0, 1, 2].map(|axis| relative(apex, axis) * f64::from(sign));
                    // The edges from a vertex of the face: the area does not depend on it, and terms are smaller.
                    for (edge, entry) in self.lower[1].column(face).iter() {
                        let (a, b) = self.ends(edge);
                        let [a, b] = [a, b].map(|vertex| [0, 1, 2].map(|axis| relative(vertex, axis)));
                        for (axis, apex) in apex.into_iter().enumerate() {
                            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                            let (p, q) = (a[i] * b[j], a[j] * b[i]);
                            let factor = apex * f64::from(entry);
                            sum.add(factor * (p - q), factor.abs() * (p.abs() + q.abs()));
                        }
                    }
                }
            }
        }
        sum
    }

    /// The sign of the measure of a cell of full dimension: exact.
    pub(super) fn sign(&self, boundary: &[(usize, i32)]) -> i32 {
        self.rounded(boundary).sign().unwrap_or_else(|| {
            let points = self.points(boundary);
            self.exact(&points, boundary).first().map_or(0, Integer::signum)
        })
    }
}

/// That cells of this degree fill their space, of dimension 1, 2 or 3.
pub(super) fn check_full(degree: usize, positions: &Positions) -> Result<(), Error> {
    if positions.dimension() == degree && (1..=3).contains(&degree) {
        return Ok(());
    }
    Err(Error::new(
        ErrorKind::Shape,
        format!("cells of degree {degree} with {} coordinates have no signed measure", positions.dimension()),
    )
    .with_cure("lengths are signed on the line, areas in the plane and volumes in space"))
}

/// The signed measures of the cells of highest degree by their boundaries: lengths on the line, areas in the plane, volumes in
/// space, in the unit of the positions to the power of the degree.
///
/// An area is positive when the boundary runs counterclockwise, a volume when it runs so seen from outside, holes and voids
/// the other way round. The measure is linear in the boundary. A face in space that is not flat counts as the cone from the
/// first vertex of its lowest edge over its rim, for both cells at it.
///
/// # Errors
/// [`ErrorKind::Shape`] unless the dimension of the complex is that of the positions, 1, 2 or 3, and each vertex has a position.
///
/// # Complexity
/// Linear in the boundaries of facets; in parallel over cells.
///
/// # Examples
/// A square of side 2:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::lar::signed_measures;
/// use coface_geometry::Positions;
/// use coface_complexes::surface::PolygonMesh;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?.chain_complex()?;
/// let positions = Positions::from_flat(2, vec![0.0, 0.0, 2.0, 0.0, 2.0, 2.0, 0.0, 2.0])?;
/// assert_eq!(signed_measures(&square, &positions)?, [4.0]);
/// # Ok(()) }
/// ```
pub fn signed_measures(complex: &ChainComplex, positions: &Positions) -> Result<Vec<f64>, Error> {
    let matrices = complex.boundary_matrices();
    let Some((top, lower)) = matrices.split_last() else { return Ok(Vec::new()) };
    check_full(matrices.len(), positions)?;
    if positions.len() < complex.cell_count(0) {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("{} positions for {} vertices", positions.len(), complex.cell_count(0)),
        ));
    }
    let frame = Frame::new(lower, positions)?;
    let factorial = [1.0, 1.0, 2.0, 6.0][matrices.len()];
    Ok((0..top.column_count())
        .into_par_iter()
        .with_min_len(1 << 8)
        .map_init(Vec::new, |boundary, cell| {
            boundary.clear();
            boundary.extend(top.column(cell).iter());
            frame.rounded(boundary).value / factorial
        })
        .collect())
}
