//! Volumes of voxels: their cells by name, and what is said of them.

use super::report::{Answer, Kind, Report};
use coface_algebra::chains::{ChainComplex, Part, Parts};
use coface_algebra::{Error, ErrorKind};
use coface_complexes::cubical::{CubicalBlocks, CubicalVolume};
use coface_geometry::Positions;
use coface_topology::{Homology, homology_of_parts};
use std::sync::{Mutex, OnceLock, PoisonError};

/// The cells of a volume, numbered as in its chain complex.
#[derive(Debug)]
pub(crate) struct VolumeCells {
    volume: CubicalVolume,
    /// The places of the cells of each dimension, once they are asked for.
    ids: OnceLock<Vec<Vec<u64>>>,
}

impl VolumeCells {
    pub(crate) fn new(volume: CubicalVolume) -> Self {
        Self { volume, ids: OnceLock::new() }
    }

    pub(crate) fn volume(&self) -> &CubicalVolume {
        &self.volume
    }

    pub(crate) fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.volume.chain_complex().map_err(|error| match error.kind() {
            ErrorKind::TooLarge => Error::new(
                ErrorKind::TooLarge,
                format!("the volume of shape {:?} is too large for one complex", self.volume.shape()),
            )
            .with_cure("take it in parts: coface homology --parts N"),
            _ => error,
        })
    }

    /// The corners of a cell, by their numbers: of an edge from its start to its end, of a square around, otherwise by rising places but
    /// for periodic axes, where the upper end is counted as if it were behind the lower one.
    pub(crate) fn vertices(&self, degree: usize, cell: usize) -> Vec<u32> {
        // A complex is at hand, so there are not too many cells.
        let ids = self.ids.get_or_init(|| self.volume.cell_ids().unwrap_or_default());
        let lengths = self.lengths();
        let mut place = vec![0; lengths.len()];
        let mut rest = ids[degree][cell];
        for (place, &length) in place.iter_mut().zip(&lengths).rev() {
            *place = rest % length;
            rest /= length;
        }
        let odd: Vec<usize> = (0..place.len()).filter(|&axis| place[axis] % 2 == 1).collect();
        let corner = |upper: usize| {
            let mut corner = place.clone();
            for (rank, &axis) in odd.iter().enumerate() {
                let is_upper = upper >> (odd.len() - 1 - rank) & 1 == 1;
                corner[axis] = if is_upper { (place[axis] + 1) % lengths[axis] } else { place[axis] - 1 };
            }
            let id = corner.iter().zip(&lengths).fold(0, |id, (&at, &length)| id * length + at);
            ids[0].binary_search(&id).expect("the corners of a cell are cells") as u32
        };
        let around = if odd.len() == 2 { vec![0, 2, 3, 1] } else { (0..1 << odd.len()).collect() };
        around.into_iter().map(corner).collect()
    }

    /// Whether no two cells have the same corners, as they may have around short periodic axes.
    pub(crate) fn are_told_by_vertices(&self) -> bool {
        let mut axes = self.volume.shape().iter().zip(self.volume.is_periodic());
        axes.all(|(&length, &periodic)| !periodic || length > 2)
    }

    /// The positions of the corners, a unit from each to the next, up to three axes; none where an axis is periodic.
    pub(crate) fn positions(&self) -> Result<Positions, Error> {
        if self.volume.shape().len() > 3 || self.volume.is_periodic().contains(&true) {
            return Ok(Positions::default());
        }
        let lengths = self.lengths();
        let ids = self.volume.cell_ids()?;
        let mut flat = Vec::with_capacity(ids[0].len() * lengths.len());
        for &id in &ids[0] {
            let start = flat.len();
            let mut rest = id;
            for &length in lengths.iter().rev() {
                flat.push((rest % length / 2) as f64);
                rest /= length;
            }
            flat[start..].reverse();
        }
        Positions::from_flat(lengths.len(), flat)
    }

    /// How many places there are along each axis.
    fn lengths(&self) -> Vec<u64> {
        let axes = self.volume.shape().iter().zip(self.volume.is_periodic());
        axes.map(|(&length, periodic)| 2 * u64::from(length) + u64::from(!periodic)).collect()
    }
}

/// The numbers of cells of a volume and its integral homology, found block by block, so that no complex of the whole is made.
///
/// # Errors
/// [`ErrorKind::TooLarge`] for voxels that cannot be cut into blocks small enough.
///
/// # Complexity
/// Linear in the voxels and cells, in parallel; the cells of a block for each thread are held, and what blocks share. Classes are counted and forgotten.
///
/// # Examples
/// ```
/// use coface_complexes::cubical::CubicalVolume;
/// use coface_answers::homology_of_volume;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = CubicalVolume::full(&[20, 20, 20], &[true; 3])?;
/// let (counts, homology) = homology_of_volume(&torus)?;
/// assert_eq!(counts, [8000, 24000, 24000, 8000]);
/// assert_eq!(homology.betti_numbers(), [1, 3, 3, 1]);
/// # Ok(()) }
/// ```
pub fn homology_of_volume(volume: &CubicalVolume) -> Result<(Vec<usize>, Homology), Error> {
    /// Cells of a block are counted when it is made.
    struct Counted<'v> {
        blocks: CubicalBlocks<'v>,
        counts: Mutex<Vec<usize>>,
    }
    impl Parts for Counted<'_> {
        fn part_count(&self) -> u32 {
            self.blocks.part_count()
        }
        fn part(&self, number: u32) -> Result<Part, Error> {
            let part = self.blocks.part(number)?;
            let mut counts = self.counts.lock().unwrap_or_else(PoisonError::into_inner);
            part.own_counts().iter().zip(counts.iter_mut()).for_each(|(own, count)| *count += own);
            Ok(part)
        }
    }
    /// How many places for cells a block has, 2^n for each voxel: it is held for each thread, with some 40 bytes a cell. Small blocks stay in the caches.
    const PLACES_OF_BLOCK: usize = 1 << 16;
    let axis_count = volume.shape().len();
    let block_count = (volume.voxel_count() << axis_count).div_ceil(PLACES_OF_BLOCK).min(1 << 24);
    let parts = Counted {
        blocks: CubicalBlocks::at_least(volume, block_count as u32)?,
        counts: Mutex::new(vec![0; axis_count + 1]),
    };
    // Every part is made once.
    let found = homology_of_parts(&parts, 8)?;
    Ok((parts.counts.into_inner().unwrap_or_else(PoisonError::into_inner), found))
}

/// The report on a volume: its cells are those of the voxels that are set.
pub(crate) fn report(volume: &CubicalVolume) -> Result<Report, Error> {
    let (counts, homology) = homology_of_volume(volume)?;
    let dimension_count = counts.iter().rposition(|&count| count > 0).map_or(0, |top| top + 1);
    let groups = homology.groups();
    let shapes = match volume.set_count() {
        0 => Vec::new(),
        count => vec![("voxel", count)],
    };
    Ok(Report {
        kind: Kind::Volume,
        f_vector: counts[..dimension_count].to_vec(),
        shapes,
        pure: Some(true),
        components: groups.first().map_or(0, |group| group.betti()),
        euler_characteristic: counts
            .iter()
            .enumerate()
            .map(|(degree, &count)| if degree % 2 == 0 { count as i64 } else { -(count as i64) })
            .sum(),
        manifold: Answer::Unknown,
        closed: None,
        homology: groups[..dimension_count.min(groups.len())].to_vec(),
        ..Report::of_nothing()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Producer;
    use coface_algebra::CellId;
    use coface_io::{Model, Structure};

    #[test]
    fn cells_are_named_by_their_corners() {
        let volume = CubicalVolume::new(&[2, 2], &[false; 2], |voxel| voxel != [1, 1]).unwrap();
        let producer = Producer::of(Model::from_structure(Structure::Volume(volume))).unwrap();
        let complex = producer.chain_complex().unwrap();
        assert_eq!(complex.f_vector(), [8, 10, 3]);
        assert_eq!(producer.positions().len(), 8);
        for degree in 1..3 {
            let matrix = complex.boundary_matrix(degree).unwrap();
            for cell in 0..complex.cell_count(degree) {
                let mut vertices = producer.cell_vertices(degree, CellId::new(cell));
                if degree == 1 {
                    let ends =
                        [matrix.entry(vertices[0] as usize, cell), matrix.entry(vertices[1] as usize, cell)];
                    assert_eq!(ends, [-1, 1]);
                }
                if degree == 2 {
                    // Around: neighbors differ along one axis.
                    for i in 0..4 {
                        let [a, b] = [vertices[i], vertices[(i + 1) % 4]].map(|v| {
                            producer.positions().point(coface_algebra::VertexId::from_u32(v)).to_vec()
                        });
                        assert_eq!(a.iter().zip(&b).filter(|(x, y)| x != y).count(), 1);
                    }
                }
                vertices.sort_unstable();
                let mut of_faces: Vec<u32> = matrix
                    .column(cell)
                    .rows()
                    .iter()
                    .flat_map(|&face| producer.cell_vertices(degree - 1, CellId::from_u32(face)))
                    .collect();
                of_faces.sort_unstable();
                of_faces.dedup();
                assert_eq!(vertices, of_faces);
            }
        }
    }

    #[test]
    fn reports_on_volumes() {
        let ball = CubicalVolume::new(&[9, 9, 9], &[false; 3], |voxel| voxel != [4, 4, 4]).unwrap();
        let complex = ball.chain_complex().unwrap();
        let report = Report::of(Model::from_structure(Structure::Volume(ball))).unwrap();
        assert_eq!(report.f_vector(), complex.f_vector());
        assert_eq!(report.kind(), Kind::Volume);
        assert_eq!(report.homology().iter().map(|group| group.betti()).collect::<Vec<_>>(), [1, 0, 1, 0]);
        assert_eq!(report.euler_characteristic(), 2);
        let nothing = CubicalVolume::new(&[3, 3], &[true; 2], |_| false).unwrap();
        let report = Report::of(Model::from_structure(Structure::Volume(nothing))).unwrap();
        assert!(report.f_vector().is_empty() && report.homology().is_empty());
        assert_eq!((report.components(), report.euler_characteristic()), (0, 0));
    }
}
