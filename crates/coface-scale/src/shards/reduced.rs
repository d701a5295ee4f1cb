//! What is left of shards: made, merged, asked.

use super::place::ShardPlace;
use super::shard::{Shard, lists, part_lists, place_of, push_lists, push_part_lists};
use coface_algebra::Error;
use coface_algebra::chains::{Part, ReducedPart};
use coface_algebra::{Entry, RaggedArray};
use coface_io::container::{Container, ContainerWriter, Kind, Role, push_wide_complex, to_wide_complex};
use coface_topology::{Homology, homology};

/// What is left of a shard or of several, with what its neighbors are compared with.
pub(super) struct ReducedShard {
    pub(super) place: ShardPlace,
    pub(super) left: ReducedPart,
    /// What cancelled in the shared faces of this level and of those below that not all parts have been compared in yet.
    walls: Vec<Wall>,
    /// How many cells of the complex are this part's own, in each degree.
    cells: Vec<u64>,
    /// How many strata were this part's own before it was reduced.
    strata: u64,
    /// The checksums of what it was made from.
    pub(super) sources: Vec<u64>,
    /// Whether it is the last one.
    pub(super) is_root: bool,
}

/// The faces that parts of a level share, by the numbers of the parts of that level.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Wall {
    level: u32,
    key: Vec<u32>,
    hash: u64,
}

/// Counts of a reduced shard. Those of all shards of a level add up to those of the whole.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ReducedSummary {
    pub(crate) place: ShardPlace,
    pub(crate) cells: Vec<u64>,
    pub(crate) strata: u64,
    pub(crate) critical: Vec<u64>,
    pub(crate) widest: usize,
    pub(crate) bytes: u64,
    pub(crate) is_root: bool,
    pub(crate) checksum: u64,
    pub(crate) sources: Vec<u64>,
}

impl ReducedSummary {
    /// Where it belongs.
    pub fn place(&self) -> ShardPlace {
        self.place
    }

    /// The cells of the complex that are its own, in each degree.
    pub fn cells(&self) -> &[u64] {
        &self.cells
    }

    /// The strata that are its own.
    pub fn strata(&self) -> u64 {
        self.strata
    }

    /// The critical cells that are its own, in each degree.
    pub fn critical(&self) -> &[u64] {
        &self.critical
    }

    /// The bits of the largest incidence.
    pub fn widest(&self) -> usize {
        self.widest
    }

    /// Its length.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Whether it is the root: nothing is left to merge.
    pub fn is_root(&self) -> bool {
        self.is_root
    }

    /// The checksum of the whole.
    pub fn checksum(&self) -> u64 {
        self.checksum
    }

    /// The checksums of what it was made from.
    pub fn sources(&self) -> &[u64] {
        &self.sources
    }
}

/// Reduces a shard.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) with the byte for any damage; [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) for a box of a grid with too many cells.
///
/// # Complexity
/// As of [`Part::reduced`].
///
/// # Examples
/// See [`shard_of_part`](super::shard_of_part).
pub fn reduce(shard: &[u8]) -> Result<Vec<u8>, Error> {
    let shard = Shard::open(shard)?;
    let part = shard.part()?;
    let cells = part.own_counts().into_iter().map(|count| count as u64).collect();
    let reduced = reduced(shard.place, &part, cells, Vec::new(), vec![shard.checksum], |_| false);
    Ok(reduced.to_bytes())
}

/// Merges the reduced shards of one level that make a place, in the order of their numbers, and reduces what they make.
///
/// # Errors
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for others than those that belong there, naming the first, and where neighbors disagree, naming two and their wall;
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) with the byte for any damage.
///
/// # Complexity
/// $O(m \log m)$ for m entries, beside the reduction.
///
/// # Examples
/// ```
/// use coface_algebra::chains::{Partition, Parts};
/// use coface_scale::shards;
/// use coface_scale::shards::ShardPlace;
/// use coface_complexes::known_spaces::klein_grid;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let bottle = klein_grid(6, 6)?.chain_complex()?;
/// let partition = Partition::by_walk(&bottle, 3)?;
/// let mut reduced = Vec::new();
/// for number in 0..3 {
///     let place = ShardPlace::new(7, 3, 4, number)?;
///     reduced.push(shards::reduce(&shards::shard_of_part(place, &partition.part(number)?, None)?)?);
/// }
/// let root = shards::merge(ShardPlace::new(7, 3, 4, 0)?.at(1, 0), &reduced)?;
/// assert_eq!(shards::root_homology(&root)?.groups()[1].to_string(), "Z + Z/2");
/// # Ok(()) }
/// ```
pub fn merge<B: AsRef<[u8]>>(place: ShardPlace, children: &[B]) -> Result<Vec<u8>, Error> {
    let children = open_children(place, children)?;
    let walls = compared_walls(place, &children)?;
    let merged = merged_part(place, &children)?;
    let degree_count = children.iter().map(|child| child.cells.len()).max().unwrap_or(0);
    let mut cells = vec![0u64; degree_count];
    children
        .iter()
        .flat_map(|child| child.cells.iter().enumerate())
        .for_each(|(degree, count)| cells[degree] += count);
    let sources = children.iter().map(|child| child.checksum).collect();
    let only = match &children[..] {
        [only] => Some(only.shard.left.complex().f_vector().to_vec()),
        _ => None,
    };
    let is_stuck = |left: &ReducedPart| only.as_deref() == Some(left.complex().f_vector());
    Ok(reduced(place, &merged, cells, walls, sources, is_stuck).to_bytes())
}

/// The homology of the whole, from the root.
///
/// # Errors
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for what is no root; [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) with the byte for any damage.
///
/// # Complexity
/// Smith normal forms of what is left.
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
/// assert_eq!(shards::root_homology(&shards::reduce(&shard)?)?.betti_numbers(), [1, 1]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn root_homology(root: &[u8]) -> Result<Homology, Error> {
    Ok(homology(open_root(root)?.left.complex()))
}

/// The counts of a reduced shard.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) with the byte for any damage.
///
/// # Complexity
/// Linear.
///
/// # Examples
/// ```
/// use coface_algebra::chains::{Partition, Parts};
/// use coface_scale::shards;
/// use coface_scale::shards::ShardPlace;
/// use coface_complexes::known_spaces::klein_grid;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let bottle = klein_grid(6, 6)?.chain_complex()?;
/// let part = Partition::by_walk(&bottle, 1)?.part(0)?;
/// let shard = shards::shard_of_part(ShardPlace::new(7, 1, 2, 0)?, &part, None)?;
/// let summary = shards::summary(&shards::reduce(&shard)?)?;
/// assert_eq!((summary.cells(), summary.critical(), summary.strata()), (&[36, 108, 72][..], &[1, 2, 1][..], 1));
/// # Ok(()) }
/// ```
pub fn summary(reduced: &[u8]) -> Result<ReducedSummary, Error> {
    let (shard, checksum) = ReducedShard::open(reduced)?;
    let entries = shard.left.complex().boundary_matrices().iter().flat_map(|matrix| matrix.entries());
    Ok(ReducedSummary {
        place: shard.place,
        strata: shard.strata,
        critical: shard.left.own_counts().into_iter().map(|count| count as u64).collect(),
        widest: entries.map(|x| x.bit_length()).max().unwrap_or(0),
        bytes: reduced.len() as u64,
        is_root: shard.is_root,
        checksum,
        cells: shard.cells,
        sources: shard.sources,
    })
}

/// The root, opened.
pub(super) fn open_root(root: &[u8]) -> Result<ReducedShard, Error> {
    let (root, _) = ReducedShard::open(root)?;
    if !root.is_root {
        return Err(Error::invalid(format!("{} is not the root: it has to be merged", root.place.name()))
            .with_cure("merge level after level until one is left that says so"));
    }
    Ok(root)
}

/// An opened child of a merge.
pub(super) struct Child {
    shard: ReducedShard,
    checksum: u64,
    cells: Vec<u64>,
}

/// Opens what is merged to a place.
pub(super) fn open_children<B: AsRef<[u8]>>(place: ShardPlace, children: &[B]) -> Result<Vec<Child>, Error> {
    let expected = place.children();
    if place.level == 0 || place.number >= place.width(place.level) || children.len() != expected.len() {
        return Err(Error::invalid(format!(
            "{} is not made of {} reduced shards",
            place.name(),
            children.len()
        ))
        .with_cure(format!(
            "merge those with the numbers {} to {}",
            expected.start,
            expected.end.saturating_sub(1)
        )));
    }
    let open = |(number, bytes): (u32, &B)| {
        let (shard, checksum) = ReducedShard::open(bytes.as_ref())?;
        let wanted = place.at(place.level - 1, number);
        if shard.place.complex != wanted.complex {
            return Err(Error::invalid(format!(
                "{} is of another complex than the others",
                shard.place.name()
            ))
            .with_cure("merge shards that were made together, by one call of coface shard"));
        }
        if shard.place != wanted {
            return Err(Error::invalid(format!(
                "{} stands in the place of {}",
                shard.place.name(),
                wanted.name()
            ))
            .with_cure("give the reduced shards in the order of their numbers, all of one tree"));
        }
        if shard.is_root {
            return Err(Error::invalid(format!("{} is the root: nothing is left to merge", wanted.name()))
                .with_cure("ask it for its homology"));
        }
        Ok(Child { cells: shard.cells.clone(), shard, checksum })
    };
    expected.zip(children).map(open).collect()
}

/// The children joined.
pub(super) fn merged_part(place: ShardPlace, children: &[Child]) -> Result<ReducedPart, Error> {
    let parts = children.iter().map(|child| &child.shard.left);
    ReducedPart::merged(place.number, parts, |part| part / place.fan_in)
}

/// Compares what the children found in the faces that they share, and gives those that others still share.
fn compared_walls(place: ShardPlace, children: &[Child]) -> Result<Vec<Wall>, Error> {
    let mut all: Vec<(&Wall, u32)> = children
        .iter()
        .flat_map(|child| child.shard.walls.iter().map(|wall| (wall, child.shard.place.number)))
        .collect();
    all.sort_unstable_by(|a, b| (a.0.level, &a.0.key, a.1).cmp(&(b.0.level, &b.0.key, b.1)));
    let differ = |wall: &Wall, one: u32, other: u32| {
        let level = if wall.level == 0 { String::new() } else { format!(" of level {}", wall.level) };
        let names = [one, other].map(|number| place.at(place.level - 1, number).name());
        Error::invalid(format!(
            "{} and {} disagree on what cancels in the faces shared by the parts {:?}{level}",
            names[0], names[1], wall.key
        ))
        .with_cure("reduce all parts of one complex again, by the same version of the program")
    };
    let mut kept = Vec::new();
    for group in all.chunk_by(|a, b| (a.0.level, &a.0.key) == (b.0.level, &b.0.key)) {
        let (wall, first) = group[0];
        if let Some(&(_, other)) = group.iter().find(|(other, _)| other.hash != wall.hash) {
            return Err(differ(wall, first, other));
        }
        // Who has the wall, by numbers of the children's level and of this one.
        let up = |levels: u32| {
            let ancestor = move |part: u32| (0..levels.min(32)).fold(part, |part, _| part / place.fan_in);
            wall.key.iter().map(move |&part| ancestor(part))
        };
        let mut here: Vec<u32> =
            up(place.level - 1 - wall.level).filter(|child| place.children().contains(child)).collect();
        here.dedup();
        if let Some(&absent) = here.iter().find(|child| group.iter().all(|(_, other)| other != *child)) {
            return Err(differ(wall, first, absent));
        }
        if up(place.level - wall.level).any(|parent| parent != place.number) {
            kept.push(wall.clone());
        }
    }
    Ok(kept)
}

fn reduced<E: Entry>(
    place: ShardPlace,
    part: &Part<E>,
    cells: Vec<u64>,
    mut walls: Vec<Wall>,
    sources: Vec<u64>,
    is_stuck: impl Fn(&ReducedPart) -> bool,
) -> ReducedShard {
    let matching = part.matching();
    let own = part.stratum_hashes(&matching);
    walls.extend(own.iter().map(|stratum| Wall {
        level: place.level,
        key: stratum.key().to_vec(),
        hash: stratum.hash(),
    }));
    let strata = part.own_stratum_count() as u64;
    let left = part.reduced_by(matching);
    let is_root = place.width(place.level) == 1 && (!left.has_units() || is_stuck(&left));
    ReducedShard { place, left, walls, cells, strata, sources, is_root }
}

impl ReducedShard {
    fn to_bytes(&self) -> Vec<u8> {
        let mut meta = self.place.to_meta().to_vec();
        meta.extend([self.strata, u64::from(self.is_root)]);
        let mut writer = ContainerWriter::new(Kind::Reduced);
        writer.push_owned(Role::Meta, 0, &meta);
        writer.push(Role::OwnCounts, 0, &self.cells);
        writer.push(Role::Sources, 0, &self.sources);
        push_part_lists(&mut writer, &self.left);
        push_wide_complex(&mut writer, self.left.complex());
        let keys = RaggedArray::from_lists(self.walls.iter().map(|wall| &wall.key));
        push_lists(&mut writer, (Role::WallStarts, Role::WallItems), 0, &keys);
        let hashes: Vec<u64> = self.walls.iter().map(|wall| wall.hash).collect();
        let levels: Vec<u64> = self.walls.iter().map(|wall| u64::from(wall.level)).collect();
        writer.push_owned(Role::WallHashes, 0, &hashes);
        writer.push_owned(Role::WallHashes, 1, &levels);
        writer.into_bytes()
    }

    /// Opens one; with the checksum of the whole.
    pub(super) fn open(bytes: &[u8]) -> Result<(Self, u64), Error> {
        let container = Container::open(bytes, Kind::Reduced)?;
        let place = place_of(&container)?;
        let &[.., strata, is_root @ (0 | 1)] = &container.array::<u64>(Role::Meta, 0)?[..] else {
            return Err(container.lie(Role::Meta, 0, "it is not said whether this is the root"));
        };
        let complex = to_wide_complex(&container)?;
        let (ids, sets, keys) = part_lists(&container, complex.degree_count())?;
        let left = Part::new(place.number, complex, ids, &sets, keys)?;
        let keys = lists(&container, (Role::WallStarts, Role::WallItems), 0)?;
        let hashes = container.array::<u64>(Role::WallHashes, 0)?;
        let levels = container.array::<u64>(Role::WallHashes, 1)?;
        let is_level = |level: &u64| *level <= u64::from(place.level);
        if hashes.len() != keys.len() || levels.len() != keys.len() || !levels.iter().all(is_level) {
            return Err(container.lie(Role::WallHashes, 0, "the shared faces have no hash or level"));
        }
        let walls = keys.iter().zip(hashes.iter().zip(levels.iter()));
        let walls = walls.map(|(key, (&hash, &level))| Wall { level: level as u32, key: key.to_vec(), hash });
        let reduced = Self {
            place,
            left,
            walls: walls.collect(),
            cells: container.array(Role::OwnCounts, 0)?.into_owned(),
            strata,
            sources: container.array(Role::Sources, 0)?.into_owned(),
            is_root: is_root == 1,
        };
        Ok((reduced, container.checksum()))
    }
}
