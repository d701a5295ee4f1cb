//! Shards of models.

use super::folder::ShardFolder;
use super::manifest::{ShardManifest, ShardSource};
use super::owners::Owners;
use super::place::ShardPlace;
use super::shard::write_shard;
use coface_algebra::chains::{ChainComplex, Part, Partition, Parts};
use coface_algebra::progress;
use coface_algebra::{CellId, Error, RaggedArray};
use coface_answers::Producer;
use coface_io::Model;
use coface_io::container::hash_array;
use std::path::Path;
use xxhash_rust::xxh3::Xxh3;

/// How a complex is cut into shards.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ShardRequest {
    /// What is cut, for people.
    pub source: ShardSource,
    /// The number of shards; 0 for as many as [`Self::part_memory`] asks for.
    pub part_count: u32,
    /// The bytes of memory that reducing a shard may take, as far as that can be estimated; decides the number of shards if none is given.
    pub part_memory: Option<u64>,
    /// How many neighbors are merged at once.
    pub fan_in: u32,
    /// Which part each maximal cell goes to.
    pub owners: Owners,
    /// Whether shards of another complex in the folder are replaced.
    pub replaces: bool,
    /// Whether files that the input names may lie outside of its folder.
    pub allow_outside: bool,
}

/// What a program takes before it has read a shard, in bytes.
const FIXED: u64 = 48 << 20;
/// What reducing a shard takes for each cell and each incidence, in bytes, with room for shared faces and for parts of unequal size.
const PER_CELL: u64 = 96;

impl ShardRequest {
    /// The number of shards for so many cells and incidences together.
    pub(super) fn part_count_for(&self, size: u64) -> u32 {
        let (0, Some(memory)) = (self.part_count, self.part_memory) else { return self.part_count };
        let room = memory.saturating_sub(FIXED).max(FIXED / 4);
        size.saturating_mul(PER_CELL).div_ceil(room).clamp(1, 1_000_000) as u32
    }

    /// So many shards of something with this name, merged by eights, cut by positions or by a walk.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::shards::ShardRequest;
    /// let request = ShardRequest::new("sphere", 3);
    /// assert_eq!((request.part_count, request.fan_in, request.replaces), (3, 8, false));
    /// ```
    pub fn new(name: impl Into<String>, part_count: u32) -> Self {
        let source = ShardSource { name: name.into(), kind: "model".to_owned(), ..ShardSource::default() };
        Self {
            source,
            part_count,
            part_memory: None,
            fan_in: 8,
            owners: Owners::default(),
            replaces: false,
            allow_outside: false,
        }
    }

    /// Merges so many neighbors at once: 2 at least.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::shards::ShardRequest;
    /// assert_eq!(ShardRequest::new("torus", 9).fan_in(3).fan_in, 3);
    /// ```
    #[must_use]
    pub fn fan_in(mut self, count: u32) -> Self {
        self.fan_in = count;
        self
    }

    /// Says which part each maximal cell goes to.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::shards::{Owners, ShardRequest};
    /// assert_eq!(ShardRequest::new("torus", 9).owners(Owners::Walk).owners, Owners::Walk);
    /// ```
    #[must_use]
    pub fn owners(mut self, owners: Owners) -> Self {
        self.owners = owners;
        self
    }

    /// Replaces shards of another complex in the folder, or refuses to.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::shards::ShardRequest;
    /// assert!(ShardRequest::new("torus", 9).replaces(true).replaces);
    /// ```
    #[must_use]
    pub fn replaces(mut self, replaces: bool) -> Self {
        self.replaces = replaces;
        self
    }

    /// The same, with leave for the input to name files outside of its folder, as
    /// [`coface_io::ReadOptions::allow_outside`] gives it.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::shards::ShardRequest;
    /// assert!(ShardRequest::new("brain", 2).allow_outside(true).allow_outside);
    /// ```
    #[must_use]
    pub fn allow_outside(mut self, is_allowed: bool) -> Self {
        self.allow_outside = is_allowed;
        self
    }
}

/// Cuts a model into shards in a folder. Any model that has a chain complex is cut; its cells are named by their vertices as in
/// [`Producer::cell_vertices`].
///
/// # Errors
/// Those of [`Producer::of`], [`Owners::partition`] and [`ShardFolder::create`]; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io).
///
/// # Complexity
/// That of the chain complex and the partition; one shard at a time is in memory beside them.
///
/// # Examples
/// See [`ShardFolder`].
pub fn shard_model(model: Model, folder: &Path, request: &ShardRequest) -> Result<ShardFolder, Error> {
    let producer = Producer::of(model)?;
    let complex = producer.chain_complex()?;
    let entries = complex.boundary_matrices().iter().map(|matrix| matrix.entry_count());
    let size = complex.f_vector().iter().copied().chain(entries).sum::<usize>() as u64;
    let part_count = request.part_count_for(size);
    let place = ShardPlace::new(0, part_count, request.fan_in, 0)?;
    if request.owners == Owners::Positions {
        producer.require_finite()?;
    }
    let partition = {
        let _steps = progress::stage("cutting into parts", 0);
        request.owners.partition(&complex, producer.positions(), part_count)?
    };
    let are_named = producer.names_cells_by_vertices();
    let names = |degree: usize, cell: usize| producer.cell_vertices(degree, CellId::new(cell));
    let complex_number = number_of(&complex, &partition, place);
    let mut source = request.source.clone();
    source.remarks.extend_from_slice(producer.remarks());
    let manifest = ShardManifest::new(complex_number, part_count, request.fan_in, source);
    ShardFolder::create(folder, manifest, request.replaces)?.finished(|folder| {
        let steps = progress::stage("writing shards", part_count as usize);
        for number in 0..part_count {
            let part = partition.part(number)?;
            let names = are_named.then(|| names_of(&part, names));
            let place = folder.place(0, number);
            folder.write_shard(number, |out| write_shard(place, &part, names.as_deref(), out).map(|_| ()))?;
            steps.advance(1);
        }
        Ok(())
    })
}

fn names_of(part: &Part, names: impl Fn(usize, usize) -> Vec<u32>) -> Vec<RaggedArray> {
    let of_degree =
        |degree| RaggedArray::from_lists(part.ids(degree).iter().map(|&id| names(degree, id as usize)));
    (0..part.complex().degree_count()).map(of_degree).collect()
}

/// A number that the complex has, cut in this way.
fn number_of(complex: &ChainComplex, partition: &Partition<'_>, place: ShardPlace) -> u64 {
    let mut hash = Xxh3::new();
    hash_array(&mut hash, &[place.part_count, place.fan_in]);
    for (degree, &count) in complex.f_vector().iter().enumerate() {
        hash_array(&mut hash, &[count as u64]);
        if let Some(matrix) = complex.boundary_matrix(degree) {
            hash_array(&mut hash, matrix.column_starts());
            hash_array(&mut hash, matrix.rows());
            hash_array(&mut hash, matrix.entries());
        }
        (0..place.part_count).for_each(|number| hash_array(&mut hash, partition.cells(degree, number)));
    }
    hash.digest()
}
