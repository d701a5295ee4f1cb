//! What is left of a block, or of several.

use super::cut::ImageBlocks;
use std::ops::Range;
use std::sync::Arc;

/// The first word of a part: parts of other versions begin with another one.
const FORM: u64 = 2 << 32;

/// A cell by the voxel that owns it and its code there.
pub(super) type Name = u64;

/// The name of what is outside, which vertices and top cells may flow to.
pub(super) const OUTSIDE_NAME: Name = u64::MAX;

/// The name of a cell. Codes are below 3^4.
pub(super) fn name(voxel: u64, code: u8) -> Name {
    voxel << 7 | u64::from(code)
}

/// The number of the voxel that owns a cell.
pub(super) fn owner(name: Name) -> u64 {
    name >> 7
}

/// Cells of one degree in the order in which they enter: by key, then by name.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Cells {
    pub(super) keys: Vec<u64>,
    pub(super) names: Vec<Name>,
}

impl Cells {
    pub(super) fn len(&self) -> usize {
        self.names.len()
    }

    pub(super) fn push(&mut self, key: u64, name: Name) {
        self.keys.push(key);
        self.names.push(name);
    }
}

/// Lists of numbers in one array.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Lists {
    starts: Vec<u64>,
    pub(super) items: Vec<u64>,
}

impl Default for Lists {
    fn default() -> Self {
        Self { starts: vec![0], items: Vec::new() }
    }
}

impl Lists {
    pub(super) fn len(&self) -> usize {
        self.starts.len() - 1
    }

    pub(super) fn span(&self, i: usize) -> Range<usize> {
        self.starts[i] as usize..self.starts[i + 1] as usize
    }

    pub(super) fn list(&self, i: usize) -> &[u64] {
        &self.items[self.span(i)]
    }

    pub(super) fn push(&mut self, list: impl IntoIterator<Item = u64>) {
        self.items.extend(list);
        self.starts.push(self.items.len() as u64);
    }
}

/// Sums of cells. Coefficients are from 1 to one below the prime.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Chains {
    names: Lists,
    /// The coefficients of all terms; nothing if all are 1.
    units: Vec<u64>,
}

impl Chains {
    pub(super) fn len(&self) -> usize {
        self.names.len()
    }

    pub(super) fn terms(&self, i: usize) -> impl Iterator<Item = (Name, u32)> + '_ {
        let unit = |place: usize| self.units.get(place).map_or(1, |&unit| unit as u32);
        self.names.span(i).map(move |place| (self.names.items[place], unit(place)))
    }

    pub(super) fn names(&self, i: usize) -> &[Name] {
        self.names.list(i)
    }

    /// The names of the terms of all of them.
    pub(super) fn all_names(&self) -> &[Name] {
        &self.names.items
    }

    /// Adds a sum over a field of so many elements.
    pub(super) fn push(&mut self, prime: u32, terms: impl IntoIterator<Item = (Name, u32)>) {
        let units = &mut self.units;
        self.names.push(terms.into_iter().map(|(name, unit)| {
            if prime > 2 {
                units.push(unit.into());
            }
            name
        }));
    }
}

/// What cells at a rim flow to.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Rules {
    pub(super) cells: Cells,
    /// The blocks that ask for each.
    pub(super) askers: Lists,
    pub(super) chains: Chains,
}

impl Rules {
    pub(super) fn push(
        &mut self,
        prime: u32,
        (key, name): (u64, Name),
        askers: impl IntoIterator<Item = u64>,
        terms: impl IntoIterator<Item = (Name, u32)>,
    ) {
        self.cells.push(key, name);
        self.askers.push(askers);
        self.chains.push(prime, terms);
    }
}

/// What is left of a block of an image, or of several that were merged: the pairs that no other block can change, and the other critical cells, with what
/// their boundaries flow down to.
///
/// # Examples
/// ```
/// use coface_topology::{ImageBlocks, ImagePart};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let blocks = ImageBlocks::new(&[4], &[2])?;
/// let parts = [blocks.part(0, [0.0, 5.0, 1.0])?, blocks.part(1, [5.0, 1.0, 2.0])?];
/// let whole = ImagePart::merged(&parts)?;
/// assert_eq!(whole.blocks(), 0..2);
/// assert_eq!(whole.diagram()?.betti_numbers(), [1, 0]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ImagePart {
    pub(super) cut: Arc<ImageBlocks>,
    pub(super) blocks: Range<u32>,
    /// The critical cells of each degree of the grid.
    pub(super) critical: Vec<Cells>,
    /// The two vertices that the ends of each critical edge flow to.
    pub(super) edges: Vec<[Name; 2]>,
    /// The two top cells that those beside each critical facet flow to; for images with two axes or more.
    pub(super) facets: Vec<[Name; 2]>,
    /// What the boundaries of the critical cells of a degree flow to, from degree 2 to one below the last.
    pub(super) boundaries: Vec<Chains>,
    /// What cells at the rim flow to: by degree, from 0 to two below the last. A critical cell flows to itself.
    pub(super) rules: Vec<Rules>,
    /// What top cells at the rim flow to.
    pub(super) top_rules: Rules,
    /// The voxels of other blocks at which paths end so far, each with its key.
    pub(super) layer: Vec<[u64; 2]>,
    /// The pairs that were found, by the degree of the cell that makes the class: the key and the voxel of that cell, then those of the one that ends it.
    /// Those that die as they are born are left out.
    pub(super) pairs: Vec<Vec<[u64; 4]>>,
}

impl ImagePart {
    /// The number of axes of the grid.
    pub(super) fn axes(&self) -> usize {
        self.critical.len() - 1
    }

    /// The blocks that it is of.
    ///
    /// # Examples
    /// See [`ImagePart`].
    pub fn blocks(&self) -> Range<u32> {
        self.blocks.clone()
    }

    /// How the image is cut.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::ImageBlocks;
    /// let part = ImageBlocks::new(&[4], &[4])?.part(0, [0.0, 5.0, 1.0, 2.0])?;
    /// assert_eq!(part.cut().shape(), [4]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn cut(&self) -> &ImageBlocks {
        &self.cut
    }

    /// The number of critical cells in each degree that are not paired yet. In the T-construction degrees are counted from the other end: see
    /// [`ImageConstruction`](crate::ImageConstruction).
    ///
    /// # Examples
    /// Two valleys and the pass between them, of which nothing outside can be a part. The deeper valley stays.
    /// ```
    /// use coface_topology::{ImageBlocks, ImageConstruction};
    /// let blocks = ImageBlocks::new(&[4], &[4])?.construction(ImageConstruction::Vertices);
    /// let part = blocks.part(0, [0.0, 5.0, 1.0, 2.0])?;
    /// assert_eq!((part.critical_counts(), part.pair_count()), (vec![1, 0], 1));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn critical_counts(&self) -> Vec<usize> {
        self.critical.iter().map(Cells::len).collect()
    }

    /// The number of pairs that were found, but for those that die as they are born.
    ///
    /// # Examples
    /// A shallow valley whose ways to other blocks are higher than the pass to the deep one is paired in its block; where one is lower, another pass may lie
    /// outside.
    /// ```
    /// use coface_topology::{ImageBlocks, ImageConstruction};
    /// let blocks = ImageBlocks::new(&[6], &[4])?.construction(ImageConstruction::Vertices);
    /// assert_eq!(blocks.part(0, [0.0, 5.0, 1.0, 9.0, 3.0])?.pair_count(), 1);
    /// assert_eq!(blocks.part(0, [0.0, 5.0, 1.0, 2.0, 3.0])?.pair_count(), 0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn pair_count(&self) -> usize {
        self.pairs.iter().map(Vec::len).sum()
    }

    /// The number of cells at the rim that other blocks ask for.
    ///
    /// # Examples
    /// A row that falls over the end of its first block, in which voxel 1 flows to voxel 2.
    /// ```
    /// use coface_topology::{ImageBlocks, ImageConstruction};
    /// let blocks = ImageBlocks::new(&[4], &[2])?.construction(ImageConstruction::Vertices);
    /// assert_eq!(blocks.part(0, [3.0, 2.0, 1.0])?.rule_count(), 0);
    /// assert_eq!(blocks.part(1, [2.0, 1.0, 0.0])?.rule_count(), 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn rule_count(&self) -> usize {
        self.rules.iter().chain([&self.top_rules]).map(|rules| rules.cells.len()).sum()
    }

    /// Takes the pairs out, as numbers.
    #[doc(hidden)]
    pub fn take_pairs(&mut self) -> Vec<u64> {
        let mut words = Vec::with_capacity(4 * self.pair_count() + self.pairs.len());
        for pairs in &mut self.pairs {
            words.push(4 * pairs.len() as u64);
            words.extend_from_slice(std::mem::take(pairs).as_flattened());
        }
        words
    }

    /// Adds the pairs that [`Self::take_pairs`] has taken out of another part of the same image; whether they are such.
    #[doc(hidden)]
    #[must_use]
    pub fn add_pairs(&mut self, words: &[u64]) -> bool {
        let mut reader = Reader { words };
        self.pairs.iter_mut().all(|pairs| reader.quadruples().map(|more| pairs.extend(more)).is_some())
            && reader.words.is_empty()
    }

    /// All of it as numbers.
    #[doc(hidden)]
    pub fn to_words(&self) -> Vec<u64> {
        let mut words = vec![FORM];
        words.extend(self.cut.to_words());
        words.extend([self.blocks.start, self.blocks.end].map(u64::from));
        let mut put = |list: &[u64]| {
            words.push(list.len() as u64);
            words.extend_from_slice(list);
        };
        for cells in &self.critical {
            put_cells(&mut put, cells);
        }
        put(self.edges.as_flattened());
        put(self.facets.as_flattened());
        for chains in &self.boundaries {
            put_chains(&mut put, chains);
        }
        for rules in self.rules.iter().chain([&self.top_rules]) {
            put_cells(&mut put, &rules.cells);
            put_lists(&mut put, &rules.askers);
            put_chains(&mut put, &rules.chains);
        }
        put(self.layer.as_flattened());
        for pairs in &self.pairs {
            put(pairs.as_flattened());
        }
        words
    }

    /// What [`Self::to_words`] has made numbers of.
    #[doc(hidden)]
    pub fn of_words(mut words: &[u64]) -> Option<Self> {
        words = words.split_first().filter(|(form, _)| **form == FORM)?.1;
        let cut = ImageBlocks::of_words(&mut words)?;
        let (&[start, end], rest) = words.split_first_chunk()?;
        let blocks = u32::try_from(start).ok()?..u32::try_from(end).ok()?;
        if blocks.is_empty() || blocks.end > cut.count() {
            return None;
        }
        let axes = cut.long_axes().len();
        let mut reader = Reader { words: rest };
        // Vertices and top cells flow to one cell each, with the coefficient 1.
        let prime_of = |degree: usize| if degree == 0 { 2 } else { cut.prime() };
        let critical = (0..=axes).map(|_| reader.cells()).collect::<Option<Vec<_>>>()?;
        let (edges, facets) = (reader.couples()?, reader.couples()?);
        let boundaries =
            (2..axes).map(|degree| reader.chains(prime_of(degree))).collect::<Option<Vec<_>>>()?;
        let rules = (0..axes.saturating_sub(1).max(1)).map(|degree| reader.rules(prime_of(degree)));
        let rules = rules.collect::<Option<Vec<_>>>()?;
        let top_rules = reader.rules(prime_of(0))?;
        let layer = reader.couples()?;
        let pairs = (0..axes).map(|_| reader.quadruples()).collect::<Option<Vec<_>>>()?;
        let facet_count = if axes > 1 { critical[axes - 1].len() } else { 0 };
        let is_whole = reader.words.is_empty()
            && layer.is_sorted_by(|[a, _], [b, _]| a < b)
            && edges.len() == critical[1].len()
            && facets.len() == facet_count
            && boundaries.iter().zip(&critical[2..]).all(|(chains, cells)| chains.len() == cells.len());
        is_whole.then(|| Self {
            cut: Arc::new(cut),
            blocks,
            critical,
            edges,
            facets,
            boundaries,
            rules,
            top_rules,
            layer,
            pairs,
        })
    }
}

fn put_cells(put: &mut impl FnMut(&[u64]), cells: &Cells) {
    put(&cells.keys);
    put(&cells.names);
}

fn put_lists(put: &mut impl FnMut(&[u64]), lists: &Lists) {
    put(&lists.starts);
    put(&lists.items);
}

fn put_chains(put: &mut impl FnMut(&[u64]), chains: &Chains) {
    put_lists(put, &chains.names);
    put(&chains.units);
}

/// Numbers that are taken from the front.
struct Reader<'a> {
    words: &'a [u64],
}

impl Reader<'_> {
    fn list(&mut self) -> Option<Vec<u64>> {
        let (&length, rest) = self.words.split_first()?;
        let (list, rest) = rest.split_at_checked(usize::try_from(length).ok()?)?;
        self.words = rest;
        Some(list.to_vec())
    }

    fn couples(&mut self) -> Option<Vec<[u64; 2]>> {
        let list = self.list()?;
        let (couples, rest) = list.as_chunks::<2>();
        rest.is_empty().then(|| couples.to_vec())
    }

    fn quadruples(&mut self) -> Option<Vec<[u64; 4]>> {
        let list = self.list()?;
        let (quadruples, rest) = list.as_chunks::<4>();
        rest.is_empty().then(|| quadruples.to_vec())
    }

    fn cells(&mut self) -> Option<Cells> {
        let cells = Cells { keys: self.list()?, names: self.list()? };
        let pairs = |i: usize| (cells.keys[i], cells.names[i]);
        let is_sorted = cells.keys.len() == cells.len() && (1..cells.len()).all(|i| pairs(i - 1) < pairs(i));
        is_sorted.then_some(cells)
    }

    fn lists(&mut self) -> Option<Lists> {
        let lists = Lists { starts: self.list()?, items: self.list()? };
        let is_whole = lists.starts.first() == Some(&0)
            && lists.starts.is_sorted()
            && lists.starts.last() == Some(&(lists.items.len() as u64));
        is_whole.then_some(lists)
    }

    fn chains(&mut self, prime: u32) -> Option<Chains> {
        let chains = Chains { names: self.lists()?, units: self.list()? };
        let units = if prime == 2 { 0 } else { chains.names.items.len() };
        let is_whole =
            chains.units.len() == units && chains.units.iter().all(|&unit| 0 < unit && unit < prime.into());
        is_whole.then_some(chains)
    }

    fn rules(&mut self, prime: u32) -> Option<Rules> {
        let rules = Rules { cells: self.cells()?, askers: self.lists()?, chains: self.chains(prime)? };
        let count = rules.cells.len();
        (rules.askers.len() == count && rules.chains.len() == count).then_some(rules)
    }
}
