//! Generators taken from the root down to cells.

use super::place::ShardPlace;
use super::reduced::{merged_part, open_children, open_root};
use super::shard::Shard;
use coface_algebra::Error;
use coface_algebra::Integer;
use coface_algebra::chains::{ChainById, sum_of_chains};
use coface_io::container::{Container, ContainerWriter, Kind, Role, integers, push_integers};
use coface_topology::reduced_generators;
use std::collections::BTreeMap;

/// Cycles that generate the homology of the whole, or pieces of them, on what is left of some level or on cells.
///
/// # Examples
/// The loop of a circle in two shards:
/// ```
/// use coface_algebra::chains::{Partition, Parts};
/// use coface_scale::shards;
/// use coface_scale::shards::{ShardChains, ShardPlace};
/// use coface_complexes::simplicial::SimplicialComplex;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let circle = SimplicialComplex::from_facets(&[[0, 1], [1, 2], [2, 3], [0, 3]])?.chain_complex()?;
/// let partition = Partition::by_walk(&circle, 2)?;
/// let place = |number| ShardPlace::new(7, 2, 2, number);
/// let shard = |number| shards::shard_of_part(place(number)?, &partition.part(number)?, None);
/// let all = [shard(0)?, shard(1)?];
/// let reduced = [shards::reduce(&all[0])?, shards::reduce(&all[1])?];
/// let root = shards::merge(place(0)?.at(1, 0), &reduced)?;
/// let between = shards::chains_below_merge(place(0)?.at(1, 0), &reduced, &shards::root_chains(&root)?)?;
/// let pieces = [shards::chains_on_cells(&all[0], &between)?, shards::chains_on_cells(&all[1], &between)?];
/// let cycles = ShardChains::from_bytes(&shards::sum_chains(&pieces)?)?;
/// assert_eq!(cycles.degrees[1][0].terms.len(), 4);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ShardChains {
    /// The complex, as in [`ShardPlace::complex`].
    pub complex: u64,
    /// The level on whose critical cells they are; `None` for the cells themselves.
    pub level: Option<u32>,
    /// For each degree the cycles.
    pub degrees: Vec<Vec<ShardChain>>,
}

/// A cycle by ids.
#[derive(Clone, Debug, PartialEq)]
pub struct ShardChain {
    /// The order of its class; `None` for infinite.
    pub order: Option<Integer>,
    /// Its cells, by rising ids.
    pub terms: Vec<ShardTerm>,
}

/// A cell of a cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct ShardTerm {
    /// The id.
    pub id: u64,
    /// How often it is in the cycle.
    pub coefficient: Integer,
    /// Its vertices, or its id where cells have none; empty above the cells.
    pub name: Vec<u64>,
}

/// Generators on what is left at the root.
///
/// # Errors
/// As of [`root_homology`](super::root_homology).
///
/// # Complexity
/// Smith transforms of what is left.
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
/// let chains = shards::root_chains(&shards::reduce(&shard)?)?;
/// assert_eq!(shards::ShardChains::from_bytes(&chains)?.degrees[1].len(), 1);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn root_chains(root: &[u8]) -> Result<Vec<u8>, Error> {
    let root = open_root(root)?;
    let degrees = reduced_generators(root.left.complex()).into_iter().enumerate().map(|(degree, found)| {
        let ids = root.left.ids(degree);
        let term = |(cell, coefficient): (u32, Integer)| ShardTerm {
            id: ids[cell as usize],
            coefficient,
            name: Vec::new(),
        };
        found
            .into_iter()
            .map(|(order, chain)| ShardChain { order, terms: chain.into_iter().map(term).collect() })
            .collect()
    });
    let level = Some(root.place.level);
    Ok(ShardChains { complex: root.place.complex, level, degrees: degrees.collect() }.to_bytes())
}

/// What a merge adds when chains on what is left of its level are taken down to the level of its children, which are given as to
/// [`merge`](super::merge).
///
/// # Errors
/// As of [`merge`](super::merge); [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for chains of another complex or level.
///
/// # Complexity
/// That of the merge, unless no cell of the chains is its own.
pub fn chains_below_merge<B: AsRef<[u8]>>(
    place: ShardPlace,
    children: &[B],
    chains: &[u8],
) -> Result<Vec<u8>, Error> {
    let chains = ShardChains::from_bytes(chains)?;
    let children = open_children(place, children)?;
    chains.check(place)?;
    let merged = merged_part(place, &children)?;
    let below = chains.taken_down(Some(place.level - 1), |degree, chains| merged.lifted(degree, chains))?;
    Ok(below.to_bytes())
}

/// What a shard adds when chains on what is left of the shards are taken down to cells.
///
/// # Errors
/// As of [`part_of_shard`](super::part_of_shard); [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for chains of another complex or level.
///
/// # Complexity
/// That of reducing the shard, unless no cell of the chains is its own.
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
/// let chains = shards::root_chains(&shards::reduce(&shard)?)?;
/// let cycles = shards::ShardChains::from_bytes(&shards::chains_on_cells(&shard, &chains)?)?;
/// assert_eq!(cycles.degrees[1][0].terms.len(), 3);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn chains_on_cells(shard: &[u8], chains: &[u8]) -> Result<Vec<u8>, Error> {
    let chains = ShardChains::from_bytes(chains)?;
    let shard = Shard::open(shard)?;
    chains.check(shard.place)?;
    let part = shard.part()?;
    let names = shard.names(&part)?;
    let mut cells = chains.taken_down(None, |degree, chains| part.lifted(degree, chains))?;
    for (degree, chains) in cells.degrees.iter_mut().enumerate() {
        for term in chains.iter_mut().flat_map(|chain| &mut chain.terms) {
            let cell =
                part.ids(degree).binary_search(&term.id).expect("lifted chains are on cells of the part");
            term.name = names.of(degree, cell, term.id);
        }
    }
    Ok(cells.to_bytes())
}

/// The sum of what all parts of a level add.
///
/// # Errors
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for no chains, and for chains that do not belong together.
///
/// # Complexity
/// $O(m \log m)$ for m terms.
pub fn sum_chains<B: AsRef<[u8]>>(pieces: &[B]) -> Result<Vec<u8>, Error> {
    let mut pieces = pieces.iter().map(|bytes| ShardChains::from_bytes(bytes.as_ref()));
    let Some(first) = pieces.next() else {
        return Err(
            Error::invalid("there are no chains to add").with_cure("give those of all parts of a level")
        );
    };
    let mut sum = first?;
    let mut names: BTreeMap<(usize, u64), Vec<u64>> = BTreeMap::new();
    sum.take_names(&mut names);
    for piece in pieces {
        let mut piece = piece?;
        let is_same =
            (piece.complex, piece.level) == (sum.complex, sum.level) && piece.orders().eq(sum.orders());
        if !is_same {
            return Err(Error::invalid("the chains to add are not of one complex and level")
                .with_cure("add what the parts of one level give for the same chains"));
        }
        piece.take_names(&mut names);
        let chains = sum.degrees.iter_mut().flatten().zip(piece.degrees.iter_mut().flatten());
        chains.for_each(|(sum, piece)| sum.terms.append(&mut piece.terms));
    }
    for (degree, chains) in sum.degrees.iter_mut().enumerate() {
        for chain in chains {
            let terms = std::mem::take(&mut chain.terms)
                .into_iter()
                .map(|term| (term.id, term.coefficient))
                .collect();
            let named = |(id, coefficient)| ShardTerm {
                id,
                coefficient,
                name: names.get(&(degree, id)).cloned().unwrap_or_default(),
            };
            chain.terms = sum_of_chains([terms]).into_iter().map(named).collect();
        }
    }
    Ok(sum.to_bytes())
}

impl ShardChains {
    fn orders(&self) -> impl Iterator<Item = (usize, &Option<Integer>)> {
        self.degrees
            .iter()
            .enumerate()
            .flat_map(|(degree, chains)| chains.iter().map(move |chain| (degree, &chain.order)))
    }

    fn take_names(&mut self, names: &mut BTreeMap<(usize, u64), Vec<u64>>) {
        for (degree, chains) in self.degrees.iter_mut().enumerate() {
            for term in
                chains.iter_mut().flat_map(|chain| &mut chain.terms).filter(|term| !term.name.is_empty())
            {
                names.entry((degree, term.id)).or_insert(std::mem::take(&mut term.name));
            }
        }
    }

    fn check(&self, place: ShardPlace) -> Result<(), Error> {
        if self.complex != place.complex || self.level != Some(place.level) {
            let level = self.level.map_or("the cells".to_owned(), |level| format!("level {level}"));
            return Err(Error::invalid(format!(
                "chains of {level} of some complex are no chains on {}",
                place.name()
            ))
            .with_cure("take the sum of a level down to the level below, from the root on"));
        }
        Ok(())
    }

    fn taken_down(
        &self,
        level: Option<u32>,
        lift: impl Fn(usize, &[ChainById]) -> Result<Vec<ChainById>, Error>,
    ) -> Result<Self, Error> {
        let degrees = self.degrees.iter().enumerate().map(|(degree, chains)| {
            let by_id: Vec<ChainById> = chains
                .iter()
                .map(|chain| chain.terms.iter().map(|term| (term.id, term.coefficient.clone())).collect())
                .collect();
            let lifted = lift(degree, &by_id)?.into_iter().zip(chains).map(|(terms, chain)| {
                let term = |(id, coefficient)| ShardTerm { id, coefficient, name: Vec::new() };
                ShardChain { order: chain.order.clone(), terms: terms.into_iter().map(term).collect() }
            });
            Ok(lifted.collect())
        });
        Ok(Self { complex: self.complex, level, degrees: degrees.collect::<Result<_, Error>>()? })
    }

    /// The chains as a container.
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
    /// let chains = shards::root_chains(&shards::reduce(&shard)?)?;
    /// let chains = shards::ShardChains::from_bytes(&chains)?;
    /// assert_eq!(shards::ShardChains::from_bytes(&chains.to_bytes())?, chains);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut writer = ContainerWriter::new(Kind::Chains);
        let level = self.level.map_or(0, |level| u64::from(level) + 1);
        writer.push_owned(Role::Meta, 0, &[self.complex, level, self.degrees.len() as u64]);
        for (degree, chains) in self.degrees.iter().enumerate() {
            let orders: Vec<Integer> =
                chains.iter().map(|chain| chain.order.clone().unwrap_or_default()).collect();
            push_integers(&mut writer, (Role::Orders, Role::WideOrders), degree, orders.iter());
            let terms = || chains.iter().flat_map(|chain| &chain.terms);
            let ids: Vec<u64> = terms().map(|term| term.id).collect();
            writer.push_owned(Role::Ids, degree, &ids);
            let coefficients = terms().map(|term| &term.coefficient);
            push_integers(&mut writer, (Role::Entries, Role::WideEntries), degree, coefficients);
            writer.push_owned(
                Role::TermStarts,
                degree,
                &starts(chains.iter().map(|chain| chain.terms.len())),
            );
            writer.push_owned(Role::NameStarts, degree, &starts(terms().map(|term| term.name.len())));
            let names: Vec<u64> = terms().flat_map(|term| &term.name).copied().collect();
            writer.push_owned(Role::NameItems, degree, &names);
        }
        writer.into_bytes()
    }

    /// The chains of a container.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) with the byte for any damage.
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
    /// let chains = shards::root_chains(&shards::reduce(&shard)?)?;
    /// assert_eq!(shards::ShardChains::from_bytes(&chains)?.level, Some(0));
    /// assert!(shards::ShardChains::from_bytes(&shard).is_err());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Error> {
        let container = Container::open(bytes, Kind::Chains)?;
        let lie = |role, degree, message| container.lie(role, degree, message);
        let &[complex, level @ 0..=0xffff_ffff, degree_count @ 0..=0xffff] =
            &container.array::<u64>(Role::Meta, 0)?[..]
        else {
            return Err(lie(Role::Meta, 0, "these are no numbers about chains"));
        };
        let mut degrees = Vec::new();
        for degree in 0..degree_count as usize {
            let orders = integers(&container, (Role::Orders, Role::WideOrders), degree)?;
            let ids = container.array::<u64>(Role::Ids, degree)?;
            let coefficients = integers(&container, (Role::Entries, Role::WideEntries), degree)?;
            let names = container.array::<u64>(Role::NameItems, degree)?;
            let name_starts = container.array::<u64>(Role::NameStarts, degree)?;
            let term_starts = container.array::<u64>(Role::TermStarts, degree)?;
            if coefficients.len() != ids.len()
                || !are_starts(&name_starts, ids.len(), names.len())
                || !are_starts(&term_starts, orders.len(), ids.len())
            {
                return Err(lie(Role::TermStarts, degree, "the lists of the chains do not fit together"));
            }
            let mut coefficients = coefficients.into_iter();
            let mut chains = Vec::with_capacity(orders.len());
            for (order, range) in orders.into_iter().zip(term_starts.windows(2)) {
                let terms = (range[0] as usize..range[1] as usize).zip(coefficients.by_ref()).map(
                    |(i, coefficient)| ShardTerm {
                        id: ids[i],
                        coefficient,
                        name: names[name_starts[i] as usize..name_starts[i + 1] as usize].to_vec(),
                    },
                );
                chains.push(ShardChain {
                    order: Some(order).filter(|order| !order.is_zero()),
                    terms: terms.collect(),
                });
            }
            degrees.push(chains);
        }
        Ok(Self { complex, level: level.checked_sub(1).map(|level| level as u32), degrees })
    }
}

fn starts(lengths: impl Iterator<Item = usize>) -> Vec<u64> {
    let mut end = 0;
    let ends = lengths.map(|length| {
        end += length as u64;
        end
    });
    std::iter::once(0).chain(ends.collect::<Vec<_>>()).collect()
}

/// Whether these rise from 0 to the number of items, one more than there are lists.
fn are_starts(starts: &[u64], list_count: usize, item_count: usize) -> bool {
    starts.len() == list_count + 1
        && starts.first() == Some(&0)
        && starts.last() == Some(&(item_count as u64))
        && starts.is_sorted()
}
