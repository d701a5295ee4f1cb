//! Extrusion: simplices swept through layers, some of them empty.

use super::prism::{fill_windows, window_sign};
use super::{FrozenComplex, SignedSimplices};
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_algebra::{RaggedArray, Sign};
use coface_geometry::Positions;
use rayon::prelude::*;

/// What [`extrude`] makes of a list of simplices: simplices of one dimension more on copies of the vertices, one copy a
/// **level**. Vertex v at level k is number `v + k * base_vertex_count`. Between neighboring levels is a **layer**.
///
/// # Examples
/// The middle one of three layers is empty:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::simplicial::extrude;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]]);
/// let towers = extrude(4, &square, &[1.0, -1.0, 1.0])?;
/// assert_eq!((towers.vertex_count(), towers.simplices().len()), (16, 12));
/// assert_eq!(towers.simplices().lists().list(6), [8, 9, 10, 12]);
/// assert_eq!(towers.source(6), (2, 0));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Extrusion {
    base_vertex_count: u32,
    heights: Vec<f64>,
    full_layers: Vec<u32>,
    /// Simplices over base simplex i are those from `starts[i]` to `starts[i + 1]` of each full layer.
    starts: Vec<u32>,
    simplices: SignedSimplices,
}

/// Sweeps simplices through layers of these heights, from height 0 on; a negative height makes an empty layer, which has
/// its vertices but no simplices.
///
/// Each full layer has for each d-simplex its prism, the d + 1 windows of d + 2 vertices on its rising vertices at the
/// lower and then at the upper level. They come layer by layer, in each by base simplex, then by window. Signs are those of
/// the product with the layer, so if the given simplices are positive or coherently oriented, in the order of their vertices,
/// then so are the new ones, with the height as last coordinate. Since windows go over rising vertices, prisms over simplices
/// with a common face meet in the prism over that face, however the simplices are ordered.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] for a list without a vertex, with a repeated one, or with one that is not below
/// `vertex_count`, and for a height that is zero, not finite, or lost when it is added to the ones before;
/// [`ErrorKind::TooLarge`] if vertices or lists go beyond 32 bits.
///
/// # Complexity
/// Linear in the result, in parallel where all simplices are of one dimension.
///
/// # References
/// The windows: see [`prism`](super::prism()). Layers with signs: the operator of A. Paoluzzi and others in *LinearAlgebraicRepresentation.jl*.
///
/// # Examples
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::simplicial::extrude;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]]);
/// let cube = extrude(4, &square, &[1.0])?;
/// let tetrahedra =
///     [[0, 1, 2, 4], [1, 2, 4, 5], [2, 4, 5, 6], [1, 2, 3, 5], [2, 3, 5, 6], [3, 5, 6, 7]];
/// assert!(cube.simplices().lists().iter().eq(tetrahedra));
/// # Ok(()) }
/// ```
pub fn extrude(vertex_count: usize, simplices: &RaggedArray, heights: &[f64]) -> Result<Extrusion, Error> {
    let level_count = heights.len() as u64 + 1;
    let base_vertex_count = u32::try_from(vertex_count)
        .ok()
        .filter(|&count| u64::from(count).checked_mul(level_count).is_some_and(|n| u32::try_from(n).is_ok()))
        .ok_or_else(|| {
            Error::new(
                ErrorKind::TooLarge,
                format!("{level_count} levels of {vertex_count} vertices; the limit is 2^32 - 1 vertices"),
            )
        })?;
    let base = SignedSimplices::new(simplices)?;
    if let Some(i) = base.lists().iter().position(|list| list.last().is_some_and(|&v| v >= base_vertex_count))
    {
        let message = format!("list {i} names a vertex that is not below the vertex count {vertex_count}");
        return Err(Error::invalid(message).with_cure("number the vertices from 0"));
    }
    let (levels, full_layers) = levels(heights)?;
    let mut starts = Vec::with_capacity(base.len() + 1);
    let (mut start, mut item_count) = (0u64, 0u64);
    starts.push(0);
    for list in base.lists().iter() {
        start += list.len() as u64;
        item_count += list.len() as u64 * (list.len() as u64 + 1);
        starts.push(start as u32);
    }
    item_count *= full_layers.len() as u64;
    if u32::try_from(item_count).is_err() {
        return Err(Error::new(
            ErrorKind::TooLarge,
            format!("the simplices of all layers have {item_count} vertices; the limit is 2^32 - 1"),
        )
        .with_cure("extrude fewer layers at a time"));
    }
    let mut items = vec![0u32; item_count as usize];
    let at_layer = |layer: u32| (layer * base_vertex_count, (layer + 1) * base_vertex_count);
    let lists = if let Some(width) = base.lists().uniform_width().filter(|_| !base.is_empty()) {
        let prism_size = width * (width + 1);
        items.par_chunks_mut(prism_size).with_min_len(1 << 9).enumerate().for_each(|(prism, own)| {
            let (lower, upper) = at_layer(full_layers[prism / base.len()]);
            fill_windows(base.lists().list(prism % base.len()), lower, upper, own);
        });
        RaggedArray::uniform(width + 1, items)?
    } else {
        let mut rest = items.as_mut_slice();
        let mut list_starts = vec![0u32];
        let mut end = 0;
        for &layer in &full_layers {
            let (lower, upper) = at_layer(layer);
            for list in base.lists().iter() {
                let (own, after) = std::mem::take(&mut rest).split_at_mut(list.len() * (list.len() + 1));
                fill_windows(list, lower, upper, own);
                rest = after;
                for _ in list {
                    end += list.len() as u32 + 1;
                    list_starts.push(end);
                }
            }
        }
        RaggedArray::from_parts(list_starts, items)?
    };
    let prism_signs = base.lists().iter().zip(base.signs()).flat_map(|(list, &sign)| {
        let dimension = list.len() - 1;
        (0..list.len()).map(move |window| window_sign(window, dimension).times(sign))
    });
    let layer_signs: Vec<Sign> = prism_signs.collect();
    let signs = layer_signs.repeat(full_layers.len());
    let simplices = SignedSimplices::from_trusted(lists, signs);
    Ok(Extrusion { base_vertex_count, heights: levels, full_layers, starts, simplices })
}

/// The heights of the levels, and the full layers.
fn levels(heights: &[f64]) -> Result<(Vec<f64>, Vec<u32>), Error> {
    let (mut levels, mut full) = (vec![0.0], Vec::new());
    let mut end = 0.0f64;
    for (i, &height) in heights.iter().enumerate() {
        let start = end;
        end += height.abs();
        if !end.is_finite() || end <= start {
            return Err(Error::invalid(format!(
                "height {i} is {height}, which does not lead from {start} to a greater finite number"
            ))
            .with_cure("give a positive height for a full layer, a negative one for an empty layer"));
        }
        levels.push(end);
        if height > 0.0 {
            full.push(i as u32);
        }
    }
    Ok((levels, full))
}

impl Extrusion {
    /// The simplices with all their faces and all vertices.
    ///
    /// # Errors
    /// Those of [`FrozenComplex::from_facets`].
    ///
    /// # Examples
    /// A segment becomes a square of two triangles:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::extrude;
    /// let square = extrude(2, &RaggedArray::from_lists([[0, 1]]), &[1.0])?;
    /// assert_eq!(square.to_frozen()?.f_vector(), [4, 5, 2]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn to_frozen(&self) -> Result<FrozenComplex, Error> {
        let mut lists = self.simplices.lists().clone();
        (0..self.vertex_count() as u32).for_each(|vertex| lists.push(&[vertex]));
        FrozenComplex::from_facets(&lists)
    }

    /// The number of vertices of all levels.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::extrude;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = extrude(2, &RaggedArray::from_lists([[0, 1]]), &[1.0])?;
    /// assert_eq!(square.vertex_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn vertex_count(&self) -> usize {
        self.base_vertex_count as usize * self.heights.len()
    }

    /// The number of vertices of one level.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::extrude;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = extrude(2, &RaggedArray::from_lists([[0, 1]]), &[1.0])?;
    /// assert_eq!(square.base_vertex_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn base_vertex_count(&self) -> usize {
        self.base_vertex_count as usize
    }

    /// The height of each level; the first is 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::extrude;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = extrude(2, &RaggedArray::from_lists([[0, 1]]), &[1.0])?;
    /// assert_eq!(square.heights(), [0.0, 1.0]);
    /// # Ok(()) }
    /// ```
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// The simplices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::extrude;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = extrude(2, &RaggedArray::from_lists([[0, 1]]), &[1.0])?;
    /// assert_eq!(square.simplices().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn simplices(&self) -> &SignedSimplices {
        &self.simplices
    }

    /// The simplices by themselves.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::extrude;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = extrude(2, &RaggedArray::from_lists([[0, 1]]), &[1.0])?;
    /// assert_eq!(square.into_simplices().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn into_simplices(self) -> SignedSimplices {
        self.simplices
    }

    /// The layer that a simplex lies in, counting all layers from 0, and the base simplex that it lies over.
    ///
    /// # Panics
    /// If there is no such simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::extrude;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = extrude(2, &RaggedArray::from_lists([[0, 1]]), &[1.0])?;
    /// assert_eq!(square.source(1), (0, 0));
    /// # Ok(()) }
    /// ```
    pub fn source(&self, simplex: usize) -> (usize, usize) {
        assert!(
            simplex < self.simplices.len(),
            "there are {} simplices, so no {simplex}",
            self.simplices.len()
        );
        let layer_size = self.simplices.len() / self.full_layers.len();
        let within = (simplex % layer_size) as u32;
        let base = self.starts.partition_point(|&start| start <= within) - 1;
        (self.full_layers[simplex / layer_size] as usize, base)
    }

    /// The positions of the vertices: those of the base, with the height as one more coordinate. A base without
    /// positions (dimension 0) gives heights alone.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if there is not one position for each vertex of the base.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_geometry::Positions;
    /// use coface_complexes::simplicial::extrude;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = Positions::from_flat(1, vec![0.0, 3.0])?;
    /// let extrusion = extrude(2, &RaggedArray::from_lists([[0, 1]]), &[0.5])?;
    /// assert_eq!(extrusion.positions(&edge)?.as_flat(), [0.0, 0.0, 3.0, 0.0, 0.0, 0.5, 3.0, 0.5]);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self, base: &Positions) -> Result<Positions, Error> {
        let count = self.base_vertex_count();
        if base.dimension() > 0 && base.len() != count {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} positions for the {count} vertices of the base", base.len()),
            ));
        }
        let mut coordinates = Vec::with_capacity(self.vertex_count() * (base.dimension() + 1));
        for &height in &self.heights {
            for v in 0..count {
                if base.dimension() > 0 {
                    coordinates.extend_from_slice(base.point(VertexId::new(v)));
                }
                coordinates.push(height);
            }
        }
        Positions::from_flat(base.dimension() + 1, coordinates)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simplicial::{FrozenComplex, facets};
    use proptest::prelude::*;

    #[test]
    fn a_square_becomes_a_cube() {
        let cube = extrude(4, &RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]]), &[1.0]).unwrap();
        let table = facets(cube.simplices().lists()).unwrap();
        assert_eq!((table.facets().len(), table.boundary_facets().len()), (18, 12));
    }

    #[test]
    fn a_patch_in_many_layers() {
        let patch = [[0, 1, 3], [1, 2, 4], [1, 3, 4], [2, 4, 5], [3, 4, 6], [4, 5, 7]];
        let pattern = [1.0, 2.0, -3.0].repeat(4);
        let towers = extrude(9, &RaggedArray::from_lists(patch), &pattern).unwrap();
        assert_eq!((towers.vertex_count(), towers.simplices().len()), (117, 144));
        let flat = Positions::from_flat(2, (0..18).map(f64::from).collect()).unwrap();
        let positions = towers.positions(&flat).unwrap();
        assert_eq!((positions.dimension(), positions.len()), (3, 117));
        assert_eq!(positions.point(VertexId::new(116)), [16.0, 17.0, 24.0]);
        assert_eq!(towers.source(143), (10, 5));
    }

    #[test]
    fn requests_that_cannot_be_served_say_why() {
        let kind = |count, lists: &[&[u32]], heights: &[f64]| {
            extrude(count, &RaggedArray::from_lists(lists), heights).map(|_| ()).map_err(|error| error.kind())
        };
        assert_eq!(kind(2, &[&[0, 1]], &[0.0]), Err(ErrorKind::InvalidInput));
        assert_eq!(kind(2, &[&[0, 1]], &[f64::NAN]), Err(ErrorKind::InvalidInput));
        assert_eq!(kind(2, &[&[0, 2]], &[1.0]), Err(ErrorKind::InvalidInput));
        assert_eq!(kind(2, &[&[0, 0]], &[1.0]), Err(ErrorKind::InvalidInput));
        assert_eq!(kind(1 << 31, &[&[0, 2]], &[1.0]), Err(ErrorKind::TooLarge));
        assert_eq!(kind(1 << 33, &[], &[]), Err(ErrorKind::TooLarge));
        assert_eq!(kind(2, &[&[0, 1]], &[]), Ok(()));
        assert_eq!(kind(0, &[], &[1.0]), Ok(()));
        let few = extrude(2, &RaggedArray::from_lists([[0, 1]]), &[1.0]).unwrap();
        let positions = Positions::from_flat(1, vec![0.0; 3]).unwrap();
        assert_eq!(few.positions(&positions).unwrap_err().kind(), ErrorKind::Shape);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        #[test]
        fn prisms_fit_together_whatever_the_order(
            lists in prop::collection::vec((1usize..5).prop_flat_map(|n| {
                prop::sample::subsequence((0u32..7).collect::<Vec<_>>(), n).prop_shuffle()
            }), 0..6),
            heights in prop::collection::vec(prop_oneof![Just(1.0), Just(-0.5)], 0..4),
        ) {
            let base = RaggedArray::from_lists(lists.iter());
            let whole = FrozenComplex::from_facets(&base).unwrap();
            let extrusion = extrude(7, &base, &heights).unwrap();
            let swept = FrozenComplex::from_facets(extrusion.simplices().lists()).unwrap();
            // The product of the base with an interval has its Euler characteristic; neighboring full layers share a level.
            let runs = heights.chunk_by(|a, b| a == b).filter(|run| run[0] > 0.0).count() as i64;
            let euler = |complex: &FrozenComplex| complex.chain_complex().unwrap().euler_characteristic();
            prop_assert_eq!(euler(&swept), runs * euler(&whole));
            let full: Vec<usize> = (0..heights.len()).filter(|&i| heights[i] > 0.0).collect();
            let sources: Vec<(usize, usize)> = full.iter().flat_map(|&layer| {
                lists.iter().enumerate().flat_map(move |(i, list)| vec![(layer, i); list.len()])
            }).collect();
            prop_assert_eq!(extrusion.simplices().len(), sources.len());
            for (i, source) in sources.into_iter().enumerate() {
                prop_assert_eq!(extrusion.source(i), source);
                let list = extrusion.simplices().lists().list(i);
                let mut below: Vec<u32> = list.iter().map(|v| v % 7).collect();
                below.sort_unstable();
                below.dedup();
                let mut base = lists[source.1].clone();
                base.sort_unstable();
                prop_assert_eq!(below, base);
                prop_assert!(list.iter().all(|v| [source.0, source.0 + 1].contains(&(*v as usize / 7))));
            }
        }
    }
}
