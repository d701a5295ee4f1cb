//! Which part each maximal cell goes to.

use coface_algebra::Error;
use coface_algebra::chains::{ChainComplex, Partition};
use coface_geometry::Positions;

/// How a complex is cut.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Owners {
    /// By positions if there are any, else by a walk.
    #[default]
    Automatic,
    /// By halving along the longest side of the box of centroids, over and over.
    Positions,
    /// By a walk through neighboring cells; see [`Partition::by_walk`].
    Walk,
    /// Each maximal cell for itself, by a hash of its number: the worst there is, for tests.
    Random,
    /// These numbers, for the cells that are a face of no other: by rising degree, then by number.
    Listed(Vec<u32>),
}

impl Owners {
    /// The partition of a complex into so many parts; `positions` of its vertices may be empty.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for [`Owners::Positions`] without any, and for lists of another length; those of [`Partition::new`].
    ///
    /// # Complexity
    /// $O(n \log p)$ for n cells and p parts.
    ///
    /// # Examples
    /// Four edges in a row, halved:
    /// ```
    /// use coface_algebra::chains::Parts;
    /// use coface_geometry::Positions;
    /// use coface_scale::shards::Owners;
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = SimplicialComplex::from_facets(&[[0, 1], [1, 2], [2, 3], [3, 4]])?.chain_complex()?;
    /// let positions = Positions::from_flat(1, vec![0.0, 1.0, 2.0, 3.0, 4.0])?;
    /// let halves = Owners::Positions.partition(&path, &positions, 2)?;
    /// assert_eq!(halves.part(1)?.ids(1), [2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn partition<'c>(
        &self,
        complex: &'c ChainComplex,
        positions: &Positions,
        part_count: u32,
    ) -> Result<Partition<'c>, Error> {
        let has_positions = positions.dimension() > 0 && positions.len() == complex.cell_count(0);
        let owners = match self {
            Self::Automatic | Self::Walk if *self == Self::Walk || !has_positions => {
                return Partition::by_walk(complex, part_count);
            }
            Self::Positions if !has_positions => {
                return Err(Error::invalid("the complex has no positions of its vertices to be cut by")
                    .with_cure("cut it by a walk"));
            }
            Self::Random => {
                return Partition::new(complex, part_count, |degree, cell| {
                    scattered(degree, cell, part_count)
                });
            }
            Self::Listed(owners) => listed(complex, owners)?,
            _ => bisected(complex, positions, part_count.max(1)),
        };
        Partition::new(complex, part_count, |degree, cell| owners[degree][cell as usize])
    }
}

/// The part of a cell by a hash of its number.
pub(super) fn scattered(degree: usize, cell: u32, part_count: u32) -> u32 {
    let hash = (u64::from(cell) + ((degree as u64) << 32) + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    ((hash >> 32) % u64::from(part_count.max(1))) as u32
}

/// For each degree the cells that are a face of no other.
fn maximal_cells(complex: &ChainComplex) -> Vec<Vec<u32>> {
    let maximal = (0..complex.degree_count()).map(|degree| {
        let mut is_face = vec![false; complex.cell_count(degree)];
        if let Some(matrix) = complex.boundary_matrix(degree + 1) {
            matrix.rows().iter().for_each(|&row| is_face[row as usize] = true);
        }
        (0..is_face.len() as u32).filter(|&cell| !is_face[cell as usize]).collect()
    });
    maximal.collect()
}

fn listed(complex: &ChainComplex, owners: &[u32]) -> Result<Vec<Vec<u32>>, Error> {
    let maximal = maximal_cells(complex);
    let count: usize = maximal.iter().map(Vec::len).sum();
    if owners.len() != count {
        return Err(Error::invalid(format!(
            "there are {} owners for {count} cells that are a face of no other",
            owners.len()
        ))
        .with_cure("give one number for each of them, by rising degree, then by number"));
    }
    let mut rest = owners.iter();
    let mut of_cell: Vec<Vec<u32>> = complex.f_vector().iter().map(|&count| vec![0; count]).collect();
    for (degree, cells) in maximal.into_iter().enumerate() {
        cells.into_iter().zip(&mut rest).for_each(|(cell, &owner)| of_cell[degree][cell as usize] = owner);
    }
    Ok(of_cell)
}

/// Owners by recursive bisection of centroids. The centroid of a cell is the mean of those of its faces.
fn bisected(complex: &ChainComplex, positions: &Positions, part_count: u32) -> Vec<Vec<u32>> {
    let dimension = positions.dimension();
    let maximal = maximal_cells(complex);
    let count: usize = maximal.iter().map(Vec::len).sum();
    let mut centers: Vec<f64> = Vec::with_capacity(count * dimension);
    let mut means = positions.as_flat().to_vec();
    for (degree, cells) in maximal.iter().enumerate() {
        if let Some(matrix) = complex.boundary_matrix(degree) {
            let below = std::mem::replace(&mut means, vec![0.0; complex.cell_count(degree) * dimension]);
            for (column, mean) in matrix.columns().zip(means.chunks_exact_mut(dimension)) {
                for &face in column.rows() {
                    let face = &below[face as usize * dimension..][..dimension];
                    mean.iter_mut().zip(face).for_each(|(sum, x)| *sum += x / column.rows().len() as f64);
                }
            }
        }
        centers.extend(cells.iter().flat_map(|&cell| &means[cell as usize * dimension..][..dimension]));
    }
    let owners = bisected_points(dimension, &centers, part_count);
    let mut owners = owners.into_iter();
    let mut of_cell: Vec<Vec<u32>> = complex.f_vector().iter().map(|&count| vec![0; count]).collect();
    for (degree, cells) in maximal.into_iter().enumerate() {
        cells
            .into_iter()
            .zip(owners.by_ref())
            .for_each(|(cell, owner)| of_cell[degree][cell as usize] = owner);
    }
    of_cell
}

/// Parts of points, nearly equal in number: halved along the longest side of their box, points at one place by their numbers, over and over.
pub(super) fn bisected_points(dimension: usize, points: &[f64], part_count: u32) -> Vec<u32> {
    let mut order: Vec<u32> = (0..(points.len() / dimension) as u32).collect();
    let mut owners = vec![0; order.len()];
    let mut pending = vec![(&mut order[..], 0, part_count)];
    while let Some((group, first_part, part_count)) = pending.pop() {
        if part_count == 1 || group.is_empty() {
            group.iter().for_each(|&point| owners[point as usize] = first_part);
            continue;
        }
        let coordinate = |point: u32, axis: usize| points[point as usize * dimension + axis];
        let extent = |axis: usize| {
            let bounds = group.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &point| {
                let x = coordinate(point, axis);
                [low.min(x), high.max(x)]
            });
            bounds[1] - bounds[0]
        };
        let extents: Vec<f64> = (0..dimension).map(extent).collect();
        let longest = extents.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let axis = extents.iter().position(|&x| x >= longest).unwrap_or(0);
        let lower_parts = part_count / 2;
        let at = (group.len() as u64 * u64::from(lower_parts) / u64::from(part_count)) as usize;
        group.select_nth_unstable_by(at, |&a, &b| {
            coordinate(a, axis).total_cmp(&coordinate(b, axis)).then(a.cmp(&b))
        });
        let (lower, upper) = group.split_at_mut(at);
        pending.push((lower, first_part, lower_parts));
        pending.push((upper, first_part + lower_parts, part_count - lower_parts));
    }
    owners
}
