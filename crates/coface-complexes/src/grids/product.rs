//! Products of cells with positions, and of models.

use super::CuboidGrid;
use crate::lar::LarModel;
use crate::shapes::{CellKind, PlacedCells};
use coface_algebra::RaggedArray;
use coface_algebra::chains::ProductNumbers;
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_geometry::Positions;
use std::borrow::Cow;

/// The product of cells of two kinds on the product of their positions; [`product`] makes it.
#[derive(Clone, Debug, PartialEq)]
pub struct ProductCells {
    positions: Positions,
    /// Kind and dimension of the cells of the two factors.
    factors: [(CellKind, usize); 2],
    cells: RaggedArray,
}

/// The product of cells with cells: a vertex for each pair of vertices, whose position are both positions one after the
/// other, and a cell for each pair of cells, with the pairs of their vertices. Vertex (a, b) is number
/// `a * second.vertex_count() + b`; cells and their vertices are in the same order, the second factor fastest.
///
/// # Errors
/// [`ErrorKind::TooLarge`] if vertices or lists go beyond 32 bits.
///
/// # Complexity
/// Linear in the result.
///
/// # Examples
/// Two segments in a row, times one:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::grids::{CuboidGrid, product};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let [row, one] = [CuboidGrid::new(&[2])?, CuboidGrid::new(&[1])?];
/// let squares = product(&row.placed_cells(1)?, &one.placed_cells(1)?)?;
/// assert!(squares.cells().iter().eq([[0, 1, 2, 3], [2, 3, 4, 5]]));
/// assert_eq!(squares.positions().as_flat()[8..], [2.0, 0.0, 2.0, 1.0]);
/// # Ok(()) }
/// ```
pub fn product(first: &PlacedCells, second: &PlacedCells) -> Result<ProductCells, Error> {
    let positions = product_positions(first.positions(), second.positions())?;
    let cells = product_lists(first.cells(), second.cells(), second.vertex_count())?;
    let factors = [first, second].map(|factor| (factor.kind(), factor.dimension()));
    Ok(ProductCells { positions, factors, cells })
}

fn product_positions(first: &Positions, second: &Positions) -> Result<Positions, Error> {
    let dimension = first.dimension() + second.dimension();
    let count = checked_count(first.len(), second.len())?;
    let mut coordinates = Vec::with_capacity(count * dimension);
    for a in (0..first.len()).map(VertexId::new) {
        for b in (0..second.len()).map(VertexId::new) {
            coordinates.extend_from_slice(first.point(a));
            coordinates.extend_from_slice(second.point(b));
        }
    }
    Positions::from_flat(dimension, coordinates)
}

fn checked_count(first: usize, second: usize) -> Result<usize, Error> {
    first.checked_mul(second).filter(|&count| u32::try_from(count).is_ok()).ok_or_else(|| {
        Error::new(
            ErrorKind::TooLarge,
            format!("the product of {first} and {second} vertices; the limit is 2^32 - 1"),
        )
    })
}

/// All pairs of vertices of all pairs of lists.
fn product_lists(
    first: &RaggedArray,
    second: &RaggedArray,
    second_vertex_count: usize,
) -> Result<RaggedArray, Error> {
    let total = first.item_count() as u64 * second.item_count() as u64;
    if u32::try_from(total).is_err() {
        return Err(Error::new(
            ErrorKind::TooLarge,
            format!("the products of cells have {total} vertices in all; the limit is 2^32 - 1"),
        ));
    }
    let mut items = Vec::with_capacity(total as usize);
    let mut append = |a: &[u32], b: &[u32]| {
        for &v in a {
            let base = v * second_vertex_count as u32;
            items.extend(b.iter().map(|w| base + w));
        }
    };
    if let (Some(m), Some(n)) = (first.uniform_width(), second.uniform_width()) {
        first.iter().for_each(|a| second.iter().for_each(|b| append(a, b)));
        return RaggedArray::uniform(m * n, items);
    }
    let mut starts = vec![0];
    let mut end = 0;
    for a in first.iter() {
        for b in second.iter() {
            append(a, b);
            end += (a.len() * b.len()) as u32;
            starts.push(end);
        }
    }
    RaggedArray::from_parts(starts, items)
}

impl ProductCells {
    /// The positions of the vertices.
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// The cells by their vertices.
    pub fn cells(&self) -> &RaggedArray {
        &self.cells
    }

    /// The dimension of the cells, the sum of those of the factors.
    pub fn dimension(&self) -> usize {
        self.factors.iter().map(|factor| factor.1).sum()
    }

    /// The kind and the dimension of the cells of each factor.
    pub fn factors(&self) -> [(CellKind, usize); 2] {
        self.factors
    }

    /// The cells as cuboids, or as simplices where one factor is points.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if they are neither: points and segments count as both, other simplices do not make
    /// cuboids.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::{CuboidGrid, product};
    /// use coface_complexes::shapes::CellKind;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let segments = CuboidGrid::new(&[3])?.placed_simplices()?;
    /// let squares = product(&segments, &segments)?.into_placed_cells()?;
    /// assert_eq!((squares.kind(), squares.dimension(), squares.cell_count()), (CellKind::Cuboid, 2, 9));
    /// # Ok(()) }
    /// ```
    pub fn into_placed_cells(self) -> Result<PlacedCells, Error> {
        let is = |kind: CellKind, factor: (CellKind, usize)| factor.0 == kind || factor.1 < 2;
        let dimension = self.dimension();
        let kind = if self.factors.iter().all(|&factor| is(CellKind::Cuboid, factor)) {
            CellKind::Cuboid
        } else if self.factors.iter().all(|&factor| is(CellKind::Simplex, factor))
            && self.factors.iter().any(|factor| factor.1 == 0)
        {
            CellKind::Simplex
        } else {
            let [first, second] = self.factors.map(|(kind, d)| format!("{} of dimension {d}", kind.plural()));
            return Err(Error::invalid(format!("products of {first} and {second} are no cuboids"))
                .with_cure("take them as cells by their vertices, or triangulate the product"));
        };
        PlacedCells::new(self.positions, kind, dimension, self.cells)
    }
}

impl LarModel {
    /// The product of two models: a cell for each pair of cells. Vertex (a, b) is number
    /// `a * other.vertex_count() + b`; the cells of a degree are in the order of
    /// [`ProductComplex`](coface_algebra::chains::ProductComplex), so by the degree of the first factor, then by its cell, then by the
    /// second's. So chain complexes of the factors multiply to one of the product,
    /// $\partial(a \times b) = \partial a \times b + (-1)^{\dim a} \, a \times \partial b$.
    ///
    /// Where the facets of the factors are given, or proved by their vertices, the product has its facets given.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if vertices, cells or lists go beyond 32 bits.
    ///
    /// # Complexity
    /// Linear in the result, and what the facets of the factors take.
    ///
    /// # Examples
    /// A triangle times a segment is a wedge of two triangles and three squares:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = RaggedArray::from_lists([[0, 1], [0, 2], [1, 2]]);
    /// let triangle = LarModel::new(3, vec![edges, RaggedArray::from_lists([[0, 1, 2]])])?;
    /// let segment = LarModel::new(2, vec![RaggedArray::from_lists([[0, 1]])])?;
    /// let wedge = triangle.product(&segment)?;
    /// assert_eq!(wedge.f_vector(), [6, 9, 5, 1]);
    /// assert_eq!(wedge.cells(2).list(0), [0, 1, 2, 3]);
    /// assert_eq!(wedge.facets(3)?.list(0).len(), 5);
    /// # Ok(()) }
    /// ```
    pub fn product(&self, other: &Self) -> Result<Self, Error> {
        let vertex_count = checked_count(self.vertex_count(), other.vertex_count())?;
        let numbers = ProductNumbers::new(&self.f_vector(), &other.f_vector())?;
        let mut cells = Vec::new();
        for degree in 1..numbers.degree_count() {
            let mut lists: Option<RaggedArray> = None;
            for p in numbers.first_degrees(degree) {
                let [first, second] = [self.lists(p)?, other.lists(degree - p)?];
                let own = product_lists(&first, &second, other.vertex_count())?;
                match &mut lists {
                    None => lists = Some(own),
                    Some(lists) => append_lists(lists, &own)?,
                }
            }
            cells.push(lists.unwrap_or_default());
        }
        let mut model = Self::new(vertex_count, cells)?;
        let facets_of = |model: &Self| -> Vec<Option<RaggedArray>> {
            let degrees = 1..=model.dimension().unwrap_or(0);
            degrees.map(|degree| model.facets(degree).ok().map(Cow::into_owned)).collect()
        };
        let (first, second) = (facets_of(self), facets_of(other));
        for degree in 2..numbers.degree_count() {
            let parts = numbers.first_degrees(degree).map(|p| (p, degree - p));
            let known = |facets: &[Option<RaggedArray>], k: usize| {
                k == 0 || facets.get(k - 1).is_some_and(Option::is_some)
            };
            if !parts.clone().all(|(p, q)| known(&first, p) && known(&second, q)) {
                continue;
            }
            let mut facets = RaggedArray::new();
            let mut own = Vec::new();
            for (p, q) in parts {
                let of_first = p.checked_sub(1).and_then(|k| first[k].as_ref());
                let of_second = q.checked_sub(1).and_then(|k| second[k].as_ref());
                for a in 0..self.cell_count(p) as u32 {
                    for b in 0..other.cell_count(q) as u32 {
                        own.clear();
                        for &face in of_first.map_or(&[][..], |facets| facets.list(a as usize)) {
                            own.push(numbers.number(p - 1, face, q, b));
                        }
                        for &face in of_second.map_or(&[][..], |facets| facets.list(b as usize)) {
                            own.push(numbers.number(p, a, q - 1, face));
                        }
                        facets.push(&own);
                    }
                }
            }
            model = model.with_facets(degree, facets)?;
        }
        Ok(model)
    }

    /// The k-cells by their vertices; the vertices as lists of one for k = 0.
    fn lists(&self, degree: usize) -> Result<Cow<'_, RaggedArray>, Error> {
        if degree > 0 {
            return Ok(self.cells(degree));
        }
        RaggedArray::uniform(1, (0..self.vertex_count() as u32).collect()).map(Cow::Owned)
    }
}

/// Appends lists to lists.
fn append_lists(lists: &mut RaggedArray, more: &RaggedArray) -> Result<(), Error> {
    let total = lists.item_count() as u64 + more.item_count() as u64;
    if u32::try_from(total).is_err() {
        return Err(Error::new(
            ErrorKind::TooLarge,
            format!("the products of cells have {total} vertices in all; the limit is 2^32 - 1"),
        ));
    }
    more.iter().for_each(|list| lists.push(list));
    Ok(())
}

impl CuboidGrid {
    /// The grid as a model of cells by their vertices, with its facets.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if the lists go beyond 32 bits.
    ///
    /// # Complexity
    /// Linear in the result.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::CuboidGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let cube = CuboidGrid::new(&[1, 1, 1])?.lar_model()?;
    /// assert_eq!(cube.f_vector(), [8, 12, 6, 1]);
    /// assert_eq!(cube.facets(2)?.list(0), [0, 1, 4, 5]);
    /// # Ok(()) }
    /// ```
    pub fn lar_model(&self) -> Result<LarModel, Error> {
        let degrees = 1..=self.dimension().unwrap_or(0);
        let cells = degrees.clone().map(|degree| self.cells(degree));
        let mut model = LarModel::new(self.cell_count(0), cells.collect::<Result<_, _>>()?)?;
        for degree in degrees.skip(1) {
            let rows = self.boundary_matrix(degree)?.rows().to_vec();
            model = model.with_facets(degree, RaggedArray::uniform(2 * degree, rows)?)?;
        }
        Ok(model)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lar::Operator;
    use crate::simplicial::{FrozenComplex, SimplicialGrid};
    use coface_algebra::CellId;
    use coface_algebra::SparseMatrix;
    use coface_algebra::chains::{ChainComplex, ProductComplex};
    use proptest::prelude::*;

    /// All simplices of some random facets, as a model and as a chain complex.
    fn random_models() -> impl Strategy<Value = (LarModel, ChainComplex)> {
        prop::collection::vec(prop::collection::btree_set(0u32..6, 1..4), 1..5).prop_map(|lists| {
            // Numbers without gaps, as a model counts its vertices.
            let mut used: Vec<u32> = lists.iter().flatten().copied().collect();
            used.sort_unstable();
            used.dedup();
            let renumbered = lists.iter().map(|list| -> Vec<u32> {
                list.iter().map(|v| used.binary_search(v).unwrap() as u32).collect()
            });
            let complex = FrozenComplex::from_facets(&RaggedArray::from_lists(renumbered)).unwrap();
            let cells = (1..=complex.dimension().unwrap_or(0))
                .map(|k| RaggedArray::uniform(k + 1, complex.flat(k).to_vec()).unwrap());
            let model = LarModel::new(complex.simplex_count(0), cells.collect()).unwrap();
            (model, complex.chain_complex().unwrap())
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        #[test]
        fn models_multiply_as_their_complexes((first, c1) in random_models(), (second, c2) in random_models()) {
            let model = first.product(&second).unwrap();
            let product = ProductComplex::new(&c1, &c2).unwrap();
            prop_assert_eq!(model.f_vector(), product.complex().f_vector());
            for degree in 1..product.complex().degree_count() {
                let cells = model.cells(degree);
                for cell in 0..cells.len() {
                    let [(p, a), (q, b)] = product.factors(degree, CellId::new(cell));
                    let vertices = |model: &LarModel, k: usize, cell: CellId| -> Vec<u32> {
                        if k == 0 { vec![cell.to_u32()] } else { model.cells(k).list(cell.index()).to_vec() }
                    };
                    let (a, b) = (vertices(&first, p, a), vertices(&second, q, b));
                    let pairs = a.iter().flat_map(|v| b.iter().map(move |w| (v, w)));
                    let expected: Vec<u32> = pairs.map(|(v, w)| v * second.vertex_count() as u32 + w).collect();
                    prop_assert_eq!(cells.list(cell), expected);
                    let mut facets = model.facets(degree).unwrap().list(cell).to_vec();
                    if degree > 1 {
                        prop_assert!(model.given_facets(degree).is_some());
                    }
                    facets.sort_unstable();
                    let matrix = product.complex().boundary_matrix(degree).unwrap();
                    prop_assert_eq!(matrix.column(cell).rows(), facets);
                }
            }
        }

        #[test]
        fn grids_multiply_to_grids(first in prop::collection::vec(1u32..3, 1..3), second in prop::collection::vec(1u32..4, 1..3)) {
            let grid = |shape: &[u32]| CuboidGrid::new(shape).unwrap();
            let whole = grid(&[&first[..], &second[..]].concat());
            let [a, b] = [&first, &second].map(|shape| grid(shape).placed_cells(shape.len()).unwrap());
            let cells = product(&a, &b).unwrap().into_placed_cells().unwrap();
            prop_assert_eq!(cells, whole.placed_cells(first.len() + second.len()).unwrap());
        }

        #[test]
        fn models_of_grids_have_the_facets_that_vertices_prove(shape in prop::collection::vec(1u32..3, 1..4)) {
            let grid = CuboidGrid::new(&shape).unwrap();
            let model = grid.lar_model().unwrap();
            prop_assert_eq!(model.f_vector(), grid.f_vector());
            for degree in 2..=shape.len().min(3) {
                prop_assert_eq!(&model.facets_by_vertices(degree).unwrap(), model.given_facets(degree).unwrap());
            }
            let counts = model.shared_vertices(Operator::new(shape.len(), 0)).unwrap();
            prop_assert_eq!(counts.entry_count(), grid.cell_count(shape.len()) << shape.len());
        }
    }

    #[test]
    fn products_of_simplices_stay_lists() {
        let triangles = SimplicialGrid::new(&[1, 1]).unwrap().placed_cells().unwrap();
        let segments = CuboidGrid::new(&[1]).unwrap().placed_cells(1).unwrap();
        let wedges = product(&triangles, &segments).unwrap();
        assert_eq!((wedges.dimension(), wedges.cells().len(), wedges.cells().list(0).len()), (3, 2, 6));
        assert_eq!(wedges.positions().dimension(), 3);
        assert_eq!(wedges.into_placed_cells().unwrap_err().kind(), ErrorKind::InvalidInput);
        let points = CuboidGrid::new(&[2]).unwrap().placed_cells(0).unwrap();
        let layers = product(&triangles, &points).unwrap().into_placed_cells().unwrap();
        assert_eq!((layers.kind(), layers.dimension(), layers.cell_count()), (CellKind::Simplex, 2, 6));
    }

    #[test]
    fn products_that_do_not_fit_are_refused() {
        let many = LarModel::new(1 << 20, vec![]).unwrap();
        assert_eq!(many.product(&many).unwrap_err().kind(), ErrorKind::TooLarge);
        let none = LarModel::new(0, vec![]).unwrap();
        assert_eq!(none.product(&many).unwrap().vertex_count(), 0);
        let line = CuboidGrid::new(&[1 << 17]).unwrap().placed_cells(1).unwrap();
        assert_eq!(product(&line, &line).unwrap_err().kind(), ErrorKind::TooLarge);
        let matrix = SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)]).unwrap();
        let segment = ChainComplex::new(vec![matrix]).unwrap();
        assert_eq!(CuboidGrid::new(&[1]).unwrap().chain_complex().unwrap(), segment);
    }
}
