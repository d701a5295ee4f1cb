//! Folders that the shards of a grid of voxels are written to, in any order.

use super::folder::ShardFolder;
use super::grid::GridShards;
use super::manifest::{ShardManifest, ShardSource};
use super::shard::write_grid_shard;
use coface_algebra::Error;
use coface_algebra::progress;
use coface_complexes::cubical::{VoxelBoxes, VoxelWindow, Voxels};
use coface_io::container::hash_array;
use std::path::Path;
use xxhash_rust::xxh3::Xxh3;

/// A folder that the shards of a volume are written to, in any order.
#[derive(Debug)]
pub struct VolumeFolder {
    grid: GridShards,
    folder: ShardFolder,
}

impl GridShards {
    /// Begins to write the shards of a volume of this shape. `content` is a number that this volume has and others have not, such as a hash of
    /// its file; shards of another one in the folder are refused unless they are to be replaced.
    ///
    /// # Errors
    /// Those of [`ShardFolder::create`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::VoxelBoxes;
    /// use coface_scale::shards::{GridShards, GridSort, ShardSource};
    /// let boxes = VoxelBoxes::at_least(&[4, 4], &[true; 2], 2)?;
    /// let grid = GridShards::new(GridSort::Cubes, boxes, 8);
    /// let folder = std::env::temp_dir().join("coface-grid-create");
    /// let shards = grid.create(&folder, ShardSource::default(), 0, false)?;
    /// assert_eq!(shards.boxes().count(), 2);
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn create(
        &self,
        folder: &Path,
        source: ShardSource,
        content: u64,
        replaces: bool,
    ) -> Result<VolumeFolder, Error> {
        let mut hash = Xxh3::new();
        hash_array(&mut hash, &self.to_numbers());
        hash_array(&mut hash, &[u64::from(self.fan_in), content]);
        let manifest = ShardManifest::new(hash.digest(), self.boxes().count(), self.fan_in, source);
        let folder = ShardFolder::create(folder, manifest, replaces)?;
        Ok(VolumeFolder { grid: self.clone(), folder })
    }

    /// Writes the shards of the grid with every voxel set.
    ///
    /// # Errors
    /// Those of [`ShardFolder::create`]; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io).
    ///
    /// # Complexity
    /// A few hundred bytes a shard.
    ///
    /// # Examples
    /// A torus of 4 x 4 squares.
    /// ```
    /// use coface_complexes::cubical::VoxelBoxes;
    /// use coface_scale::shards::{GridShards, GridSort, ShardSource};
    /// let boxes = VoxelBoxes::at_least(&[4, 4], &[true; 2], 2)?;
    /// let grid = GridShards::new(GridSort::Cubes, boxes, 8);
    /// let folder = std::env::temp_dir().join("coface-shard-full");
    /// let shards = grid.shard_full(&folder, ShardSource::default(), false)?;
    /// assert!(shards.shard_path(1).exists());
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn shard_full(
        &self,
        folder: &Path,
        source: ShardSource,
        replaces: bool,
    ) -> Result<ShardFolder, Error> {
        let shards = self.create(folder, source, 0, replaces)?;
        shards.finished(|shards| {
            let steps = progress::stage("writing shards", self.boxes().count() as usize);
            for number in 0..self.boxes().count() {
                let place = shards.folder.place(0, number);
                shards
                    .folder
                    .write_shard(number, |out| write_grid_shard(place, self, None, out).map(|_| ()))?;
                steps.advance(1);
            }
            Ok(())
        })
    }

    /// Writes the shards of a volume, window by window; `content` as in [`create`](Self::create).
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a volume of another shape; those of [`Voxels::window`] and [`ShardFolder::create`];
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io).
    pub fn shard_volume(
        &self,
        volume: &(impl Voxels + ?Sized),
        folder: &Path,
        source: ShardSource,
        content: u64,
        replaces: bool,
    ) -> Result<ShardFolder, Error> {
        let shards = self.create(folder, source, content, replaces)?;
        shards.finished(|shards| {
            let steps = progress::stage("writing shards", self.boxes().count() as usize);
            for number in 0..self.boxes().count() {
                shards.write(number, &volume.window(&self.boxes().voxels(number))?)?;
                steps.advance(1);
            }
            Ok(())
        })
    }
}

impl VolumeFolder {
    /// The boxes, which are the parts.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::VoxelBoxes;
    /// use coface_scale::shards::{GridShards, GridSort, ShardSource};
    /// let boxes = VoxelBoxes::at_least(&[4, 4], &[true; 2], 2)?;
    /// let grid = GridShards::new(GridSort::Cubes, boxes, 8);
    /// let folder = std::env::temp_dir().join("coface-grid-boxes");
    /// let shards = grid.create(&folder, ShardSource::default(), 0, false)?;
    /// assert_eq!(shards.boxes().count(), 2);
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn boxes(&self) -> &VoxelBoxes {
        self.grid.boxes()
    }

    /// Writes the shard of a box from its window.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for the window of another box; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io).
    ///
    /// # Panics
    /// If there is no such box.
    pub fn write(&self, number: u32, window: &VoxelWindow) -> Result<(), Error> {
        let boxes = self.boxes();
        let is_own = window.shape() == boxes.shape()
            && window.is_periodic() == boxes.is_periodic()
            && *window.inner() == boxes.voxels(number);
        if !is_own {
            return Err(Error::invalid(format!("a window of other voxels was given for part {number}"))
                .with_cure("take the windows of the boxes"));
        }
        let place = self.folder.place(0, number);
        let words = Some(window.words());
        self.folder.write_shard(number, |out| write_grid_shard(place, &self.grid, words, out).map(|_| ()))
    }

    /// Says that all shards are written.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming a shard that is not; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io).
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::VoxelBoxes;
    /// use coface_scale::shards::{GridShards, GridSort, ShardSource};
    /// let boxes = VoxelBoxes::at_least(&[4, 4], &[true; 2], 2)?;
    /// let grid = GridShards::new(GridSort::Cubes, boxes, 8);
    /// let folder = std::env::temp_dir().join("coface-grid-finish");
    /// let shards = grid.create(&folder, ShardSource::default(), 0, false)?;
    /// // No shard was written; the folder that was made for them goes again.
    /// assert!(shards.finish().is_err() && !folder.exists());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn finish(self) -> Result<ShardFolder, Error> {
        let missing = (0..self.boxes().count()).find(|&number| !self.folder.shard_path(number).exists());
        if let Some(number) = missing {
            return Err(Error::invalid(format!("the shard of box {number} was not written")));
        }
        self.folder.finish()?;
        Ok(self.folder)
    }

    /// Has all shards written by a function that knows which; when that fails, those that were written are removed.
    pub(super) fn finished(
        self,
        write: impl FnOnce(&Self) -> Result<(), Error>,
    ) -> Result<ShardFolder, Error> {
        let folder = self.folder.clone();
        folder.finished(|_| write(&self))
    }
}
