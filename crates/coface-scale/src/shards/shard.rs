//! Shards as bytes.

use super::grid::{GridShards, push_grid};
use super::names::Names;
use super::place::ShardPlace;
use coface_algebra::Error;
use coface_algebra::RaggedArray;
use coface_algebra::chains::Part;
use coface_io::container::{Container, ContainerWriter, Kind, Role, Written, push_complex, to_complex};
use std::io::Write;

/// An open shard.
pub(super) struct Shard<'a> {
    pub(super) place: ShardPlace,
    pub(super) checksum: u64,
    container: Container<'a>,
}

/// The shard with these cells, as bytes. Chains on them are written by `names`: for each degree the vertices of each cell, or by ids without.
///
/// # Errors
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) unless the part has the number of the place, and names for all of its cells.
///
/// # Complexity
/// Linear.
///
/// # Examples
/// ```
/// use coface_algebra::chains::{Partition, Parts};
/// use coface_scale::shards;
/// use coface_scale::shards::ShardPlace;
/// use coface_complexes::simplicial::SimplicialComplex;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let circle = SimplicialComplex::from_facets(&[[0, 1], [1, 2], [0, 2]])?.chain_complex()?;
/// let part = Partition::by_walk(&circle, 1)?.part(0)?;
/// let shard = shards::shard_of_part(ShardPlace::new(7, 1, 2, 0)?, &part, None)?;
/// assert_eq!(shards::part_of_shard(&shard)?, part);
/// let root = shards::reduce(&shard)?;
/// assert_eq!(shards::root_homology(&root)?.betti_numbers(), [1, 1]);
/// # Ok(()) }
/// ```
pub fn shard_of_part(
    place: ShardPlace,
    part: &Part,
    names: Option<&[RaggedArray]>,
) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    write_shard(place, part, names, &mut bytes)?;
    Ok(bytes)
}

/// Writes such a shard.
pub(super) fn write_shard(
    place: ShardPlace,
    part: &Part,
    names: Option<&[RaggedArray]>,
    out: &mut (impl Write + ?Sized),
) -> Result<Written, Error> {
    let degree_count = part.complex().degree_count();
    if part.number() != place.number || place.level != 0 {
        return Err(Error::invalid(format!("part {} is no shard of {}", part.number(), place.name())));
    }
    let are_named = |names: &[RaggedArray]| {
        names.len() == degree_count
            && names
                .iter()
                .enumerate()
                .all(|(degree, names)| names.len() == part.complex().cell_count(degree))
    };
    if names.is_some_and(|names| !are_named(names)) {
        return Err(Error::invalid(format!("some cells of {} have no names", place.name())));
    }
    let mut writer = ContainerWriter::new(Kind::Shard);
    writer.push_owned(Role::Meta, 0, &place.to_meta());
    push_part_lists(&mut writer, part);
    push_complex(&mut writer, part.complex());
    for (degree, names) in names.into_iter().flatten().enumerate() {
        push_lists(&mut writer, (Role::NameStarts, Role::NameItems), degree, names);
    }
    writer.write(out)
}

/// The shard of a box of a grid: its description, and its voxels if not all are set.
pub(super) fn write_grid_shard(
    place: ShardPlace,
    grid: &GridShards,
    words: Option<&[u64]>,
    out: &mut (impl Write + ?Sized),
) -> Result<Written, Error> {
    let mut writer = ContainerWriter::new(Kind::Shard);
    writer.push_owned(Role::Meta, 0, &place.to_meta());
    push_grid(&mut writer, grid, words);
    writer.write(out)
}

/// The part of a complex that a shard is.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) with the byte for any damage; those of [`Part::new`].
///
/// # Complexity
/// Linear.
///
/// # Examples
/// A circle of three edges in one shard.
/// ```
/// use coface_algebra::chains::{Partition, Parts};
/// use coface_complexes::simplicial::SimplicialComplex;
/// use coface_scale::shards;
/// use coface_scale::shards::ShardPlace;
/// let circle = SimplicialComplex::from_facets(&[[0, 1], [1, 2], [0, 2]])?.chain_complex()?;
/// let part = Partition::by_walk(&circle, 1)?.part(0)?;
/// let shard = shards::shard_of_part(ShardPlace::new(7, 1, 2, 0)?, &part, None)?;
/// assert_eq!(shards::part_of_shard(&shard)?, part);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn part_of_shard(shard: &[u8]) -> Result<Part, Error> {
    Shard::open(shard)?.part()
}

impl<'a> Shard<'a> {
    pub(super) fn open(bytes: &'a [u8]) -> Result<Self, Error> {
        let container = Container::open(bytes, Kind::Shard)?;
        let place = place_of(&container)?;
        if place.level != 0 {
            return Err(container.lie(Role::Meta, 0, "a shard stands on level 0"));
        }
        Ok(Self { place, checksum: container.checksum(), container })
    }

    pub(super) fn part(&self) -> Result<Part, Error> {
        if self.container.has(Role::Grid, 0) {
            let (grid, words) = GridShards::of(&self.container, self.place)?;
            return grid.part(self.place.number, words);
        }
        let complex = to_complex(&self.container)?;
        let (ids, sets, keys) = part_lists(&self.container, complex.degree_count())?;
        Part::new(self.place.number, complex, ids, &sets, keys)
    }

    /// How the cells of the part are named, which has so many degrees.
    pub(super) fn names(&self, part: &Part) -> Result<Names, Error> {
        let degree_count = part.complex().degree_count();
        if self.container.has(Role::Grid, 0) {
            return Ok(Names::Grid(GridShards::of(&self.container, self.place)?.0));
        }
        if !self.container.has(Role::NameStarts, 0) {
            return Ok(Names::Ids);
        }
        let lists = (0..degree_count).map(|degree| {
            let names = lists(&self.container, (Role::NameStarts, Role::NameItems), degree)?;
            match names.len() == part.complex().cell_count(degree) {
                true => Ok(names),
                false => {
                    Err(self.container.lie(Role::NameStarts, degree, "there are not as many names as cells"))
                }
            }
        });
        Ok(Names::Vertices(lists.collect::<Result<_, Error>>()?))
    }
}

/// The place that the first five numbers about a container say.
pub(super) fn place_of(container: &Container<'_>) -> Result<ShardPlace, Error> {
    let meta = container.array::<u64>(Role::Meta, 0)?;
    let place = meta.get(..5).and_then(ShardPlace::from_meta);
    place.ok_or_else(|| container.lie(Role::Meta, 0, "this is no place in a tree of parts"))
}

/// Appends the ids and keys of a part.
pub(super) fn push_part_lists<'a, E: coface_algebra::Entry>(
    writer: &mut ContainerWriter<'a>,
    part: &'a Part<E>,
) {
    let (sets, keys) = part.keys();
    push_lists(writer, (Role::SetStarts, Role::SetItems), 0, sets);
    for (degree, keys) in keys.iter().enumerate() {
        writer.push(Role::Ids, degree, part.ids(degree));
        writer.push(Role::Keys, degree, keys);
    }
}

/// The ids, key sets and keys of a part of so many degrees.
#[expect(clippy::type_complexity, reason = "the three lists that parts are made from")]
pub(super) fn part_lists(
    container: &Container<'_>,
    degree_count: usize,
) -> Result<(Vec<Vec<u64>>, RaggedArray, Vec<Vec<u32>>), Error> {
    let sets = lists(container, (Role::SetStarts, Role::SetItems), 0)?;
    let ids = (0..degree_count).map(|degree| Ok(container.array(Role::Ids, degree)?.into_owned()));
    let keys = (0..degree_count).map(|degree| Ok(container.array(Role::Keys, degree)?.into_owned()));
    Ok((ids.collect::<Result<_, Error>>()?, sets, keys.collect::<Result<_, Error>>()?))
}

/// Appends a list of lists.
pub(super) fn push_lists<'a>(
    writer: &mut ContainerWriter<'a>,
    (starts, items): (Role, Role),
    index: usize,
    lists: &'a RaggedArray,
) {
    let all_starts: Vec<u32> = (0..=lists.len()).map(|i| lists.start(i) as u32).collect();
    writer.push_owned(starts, index, &all_starts);
    writer.push(items, index, lists.items());
}

/// A list of lists.
pub(super) fn lists(
    container: &Container<'_>,
    (starts, items): (Role, Role),
    index: usize,
) -> Result<RaggedArray, Error> {
    let all_starts = container.array::<u32>(starts, index)?.into_owned();
    let all_items = container.array::<u32>(items, index)?.into_owned();
    RaggedArray::from_parts(all_starts, all_items)
        .map_err(|error| container.lie(starts, index, error.message()))
}
