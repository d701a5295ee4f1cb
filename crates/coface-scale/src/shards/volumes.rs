//! Shards of grids, and of volume files while they are read.

use super::folder::ShardFolder;
use super::grid::{GridShards, GridSort};
use super::manifest::ShardSource;
use super::models::ShardRequest;
use coface_algebra::Error;
use coface_algebra::progress;
use coface_complexes::cubical::{CubicalVolume, VoxelBoxes};
use coface_io::container::hash_array;
use coface_io::{Format, Remark, VolumeReading, VolumeStream};
use std::fs::File;
use std::io::Read;
use std::path::Path;
use xxhash_rust::xxh3::Xxh3;

/// The boxes that a volume is cut into as a request says: at least as many as it asks for, as far as there are voxels.
fn grid_of(
    sort: GridSort,
    shape: &[u32],
    is_periodic: &[bool],
    request: &ShardRequest,
) -> Result<GridShards, Error> {
    let voxels = shape.iter().fold(1u64, |count, &length| count.saturating_mul(length.into()));
    let size = voxels.saturating_mul(size_of_voxel(sort, shape.len()));
    let count = match request.part_count_for(size) {
        // Blocks of some million cells.
        0 => size.div_ceil(1 << 23).min(1_000_000) as u32,
        count => count,
    };
    Ok(GridShards::new(sort, VoxelBoxes::at_least(shape, is_periodic, count.max(1))?, request.fan_in))
}

/// How many cells and incidences there are for each voxel of a large full grid.
fn size_of_voxel(sort: GridSort, axis_count: usize) -> u64 {
    // `onto[k]` maps of a set of as many as the step onto one of k: those of the carrier's axes to the steps of a chain.
    let mut size = 0;
    let mut onto = vec![1u64];
    let mut chosen = 1u64;
    for dimension in 0..=axis_count as u64 {
        size += chosen
            * match sort {
                GridSort::Cubes => 1 + 2 * dimension,
                GridSort::Simplices => {
                    (0u64..).zip(&onto).map(|(k, count)| count * if k == 0 { 1 } else { k + 2 }).sum()
                }
            };
        chosen = chosen * (axis_count as u64 - dimension) / (dimension + 1);
        let next = (0..=onto.len()).map(|k| {
            let before = |k: usize| onto.get(k).copied().unwrap_or(0);
            if k == 0 { 0 } else { k as u64 * (before(k) + before(k - 1)) }
        });
        onto = next.collect();
    }
    size
}

fn source(request: &ShardRequest, kind: &str) -> ShardSource {
    ShardSource { kind: kind.to_owned(), ..request.source.clone() }
}

/// Cuts a grid of voxels, all of them set, into shards: descriptions of a few hundred bytes each, whatever the grid.
///
/// # Errors
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) and [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) for a shape that no volume has; those of
/// [`ShardFolder::create`]; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io).
///
/// # Complexity
/// Linear in the number of shards.
///
/// # Examples
/// ```
/// use coface_scale::shards::{GridSort, ShardRequest, shard_grid};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let folder = std::env::temp_dir().join("coface-shard-grid");
/// let request = ShardRequest::new("a torus", 4);
/// let shards = shard_grid(GridSort::Simplices, &[4, 4], &[true, true], &folder, &request)?;
/// (0..4).try_for_each(|number| shards.reduce(number, false).map(|_| ()))?;
/// let found = shards.merge_all(false)?;
/// assert_eq!(found.cells(), [16, 48, 32]);
/// assert_eq!(found.homology().betti_numbers(), [1, 2, 1]);
/// # std::fs::remove_dir_all(&folder)?;
/// # Ok(()) }
/// ```
pub fn shard_grid(
    sort: GridSort,
    shape: &[u32],
    is_periodic: &[bool],
    folder: &Path,
    request: &ShardRequest,
) -> Result<ShardFolder, Error> {
    let grid = grid_of(sort, shape, is_periodic, request)?;
    grid.shard_full(folder, source(request, "grid"), request.replaces)
}

/// Cuts a volume in memory into shards.
///
/// # Errors
/// Those of [`ShardFolder::create`]; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io).
///
/// # Complexity
/// Linear in the voxels.
pub fn shard_volume(
    sort: GridSort,
    volume: &CubicalVolume,
    folder: &Path,
    request: &ShardRequest,
) -> Result<ShardFolder, Error> {
    let grid = grid_of(sort, volume.shape(), volume.is_periodic(), request)?;
    let mut hash = Xxh3::new();
    hash_array(&mut hash, volume.words());
    grid.shard_volume(volume, folder, source(request, "volume"), hash.digest(), request.replaces)
}

/// Cuts the volume in a file into shards while it is read: the shard of a box is written as soon as its last slab has come. Gives the warnings
/// of the reader too.
///
/// # Errors
/// Those of [`VolumeStream::open`] and [`VolumeStream::for_each_window`], and of [`ShardFolder::create`]; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io).
///
/// # Complexity
/// Linear in the file, which is unpacked once; the windows that one slab meets are held, a bit a voxel.
pub fn shard_volume_file(
    sort: GridSort,
    path: &Path,
    format: Format,
    how: &VolumeReading,
    folder: &Path,
    request: &ShardRequest,
) -> Result<(ShardFolder, Vec<Remark>), Error> {
    let stream = VolumeStream::open_with(path, format, request.allow_outside)?;
    let is_periodic = how.periodic_axes(stream.shape().len())?;
    let grid = grid_of(sort, stream.shape(), &is_periodic, request)?;
    let content = content_of(&stream, how)?;
    let shards = grid.create(folder, source(request, "volume"), content, request.replaces)?;
    let mut remarks = Vec::new();
    let shards = shards.finished(|shards| {
        let steps = progress::stage("writing shards", shards.boxes().count() as usize);
        let boxes = shards.boxes().clone();
        let read = stream.for_each_window(how.rule, &boxes, |number, window| {
            steps.advance(1);
            shards.write(number, &window)
        });
        remarks = read.map_err(|error| error.in_file(path.display().to_string()))?;
        Ok(())
    })?;
    Ok((shards, remarks))
}

/// A hash of the bytes of the files, packed as they are, and of the rule.
fn content_of(stream: &VolumeStream<'_>, how: &VolumeReading) -> Result<u64, Error> {
    let mut hash = Xxh3::new();
    hash.update(how.rule.to_string().as_bytes());
    let mut buffer = vec![0; 1 << 18];
    for path in stream.files() {
        let _steps = progress::stage("looking at the file", 0);
        let mut file =
            File::open(path).map_err(|error| Error::from(error).in_file(path.display().to_string()))?;
        loop {
            let count = file.read(&mut buffer)?;
            if count == 0 {
                break;
            }
            hash.update(&buffer[..count]);
        }
    }
    Ok(hash.digest())
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_complexes::cubical::{CubicalBlocks, FullVoxels, SimplicialBlocks};
    use coface_io::volume::write_npy;

    #[test]
    fn sizes_of_voxels_are_those_of_tori() {
        for axis_count in 1..5 {
            let (shape, periodic) = (vec![3; axis_count], vec![true; axis_count]);
            let torus = FullVoxels::new(&shape, &periodic).unwrap();
            let one = vec![1; axis_count];
            for (sort, part) in [
                (GridSort::Cubes, CubicalBlocks::new(&torus, &one).unwrap().block(0).unwrap()),
                (GridSort::Simplices, SimplicialBlocks::new(&torus, &one).unwrap().block(0).unwrap()),
            ] {
                let complex = part.complex();
                let entries = complex.boundary_matrices().iter().map(|matrix| matrix.entry_count());
                let size = complex.f_vector().iter().copied().chain(entries).sum::<usize>() as u64;
                assert_eq!(
                    size,
                    size_of_voxel(sort, axis_count) * 3u64.pow(axis_count as u32),
                    "{sort:?} {axis_count}"
                );
            }
        }
    }

    /// A file and the volume in it, cut by number and by memory.
    #[test]
    fn files_have_the_shards_of_their_volumes() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("ball.npy");
        let ball =
            CubicalVolume::new(&[12, 10, 11], &[false, true, false], |v| (v[0] * v[2] + v[1]) % 5 != 0)
                .unwrap();
        write_npy(&ball, File::create(&path).unwrap()).unwrap();
        let mut how = VolumeReading::default();
        how.periodic[1] = true;
        for sort in [GridSort::Cubes, GridSort::Simplices] {
            let request = ShardRequest::new("ball", 9);
            let [a, b] = ["a", "b"].map(|name| folder.path().join(format!("{name} {sort:?}")));
            let (from_file, remarks) =
                shard_volume_file(sort, &path, Format::Npy, &how, &a, &request).unwrap();
            assert!(remarks.is_empty());
            let from_memory = shard_volume(sort, &ball, &b, &request).unwrap();
            assert_eq!(from_file.manifest().part_count, 16);
            let found = [from_file, from_memory].map(|shards| {
                (0..16).for_each(|number| assert!(shards.reduce(number, false).unwrap().is_new));
                shards.merge_all(false).unwrap()
            });
            assert_eq!(found[0].homology, found[1].homology);
            assert_eq!(found[0].levels, found[1].levels);
            let complex = match sort {
                GridSort::Cubes => ball.chain_complex().unwrap(),
                GridSort::Simplices => ball.simplicial_chain_complex().unwrap(),
            };
            assert_eq!(found[0].homology, coface_topology::homology(&complex));
            let counts: Vec<u64> = complex.f_vector().iter().map(|&count| count as u64).collect();
            assert_eq!(found[0].cells, counts);
        }
        let mut request = ShardRequest::new("large", 0);
        request.part_memory = Some(64 << 20);
        let shards =
            shard_grid(GridSort::Cubes, &[100, 100, 100], &[true; 3], &folder.path().join("c"), &request)
                .unwrap();
        assert!(shards.manifest().part_count > 64, "{}", shards.manifest().part_count);
    }
}
