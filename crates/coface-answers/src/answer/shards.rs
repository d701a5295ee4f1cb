//! The answers of `shard` and `reduce`.

use super::Remark;
use serde::{Deserialize, Serialize};

/// A complex cut into files.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ShardAnswer {
    /// The name of the input.
    pub file: String,
    /// The folder of the shards.
    pub output: String,
    /// The number of shards.
    pub parts: u32,
    /// How many neighbors are merged at once.
    pub fan_in: u32,
    /// The size of all shards, in bytes.
    pub bytes: u64,
    /// The size of the largest shard, in bytes.
    pub largest: u64,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// Shards that were reduced to their critical cells.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ReduceAnswer {
    /// One entry for each shard.
    pub reduced: Vec<ReducedShard>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// What is left of one shard.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ReducedShard {
    /// The file that was written.
    pub file: String,
    /// Whether it was there already, whole and made of this shard.
    pub skipped: bool,
    /// Its level; the shards are level 0.
    pub level: u32,
    /// Its number in the level.
    pub number: u32,
    /// The numbers of cells of each degree.
    pub cells: Vec<u64>,
    /// The number of strata.
    pub strata: u64,
    /// The numbers of critical cells of each degree.
    pub critical: Vec<u64>,
    /// The size of the file, in bytes.
    pub bytes: u64,
    /// The checksum of the file, in hexadecimal digits.
    pub checksum: String,
}
