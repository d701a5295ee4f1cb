//! Complexes larger than memory: shards in a folder, reduced one by one and merged up a tree.
//!
//! # Words
//! * A **shard** is a part of a complex ([`coface_algebra::chains::Part`]) as bytes, or the description of one: a box of a grid, with its voxels if not
//!   all are set.
//! * A **reduced shard** is what is left of it: critical cells with their exact boundaries, the hashes of what cancelled in shared faces, and the
//!   checksum of what it was made from. Those of level 0 come from shards; one of level l + 1 comes from `fan_in` neighbors of level l. The last one, the
//!   **root**, has the homology of the whole.
//! * **Chains** of the root are taken down again level by level, to cycles on the cells.
//!
//! # Bytes and folders
//! [`reduce`], [`merge`], [`root_homology`], [`root_chains`], [`chains_below_merge`], [`chains_on_cells`] and [`sum_chains`] take bytes and give bytes, the same for
//! the same, so that any runner can call them on any storage. A [`ShardFolder`] keeps them as files: what is finished and made of what is there is not
//! made again. [`shard_model`] makes the shards of a model, [`shard_mesh_file`] those of a file that is not kept in memory, [`GridShards`] those of grids and
//! volumes.
//!
//! [`image_part`], [`merge_image_parts`] and [`image_diagram`] do the same for the persistence of an image: see [`ImageBlocks`](coface_topology::ImageBlocks). An
//! [`ImageFolder`] keeps its parts as files.
//!
//! # References
//! See [`coface_algebra::chains::Part`].

mod chains;
mod folder;
mod grid;
mod image_folder;
mod images;
mod manifest;
mod meshes;
mod models;
mod names;
mod owners;
mod place;
mod reduced;
mod scratch;
mod shard;
mod volume_folder;
mod volumes;

pub use chains::{
    ShardChain, ShardChains, ShardTerm, chains_below_merge, chains_on_cells, root_chains, sum_chains,
};
pub use folder::{FolderLevel, FolderSummary, ReducedStep, ShardFolder, reduce_file};
pub use grid::{GridShards, GridSort};
pub use image_folder::ImageFolder;
pub use images::{
    ImagePartSummary, image_diagram, image_part, image_part_summary, merge_image_parts, window_checksum,
};
pub use manifest::{ShardManifest, ShardSource};
pub use meshes::shard_mesh_file;
pub use models::{ShardRequest, shard_model};
pub use owners::Owners;
pub use place::ShardPlace;
pub use reduced::{ReducedSummary, merge, reduce, root_homology, summary};
pub use shard::{part_of_shard, shard_of_part};
pub use volume_folder::VolumeFolder;
pub use volumes::{shard_grid, shard_volume, shard_volume_file};
