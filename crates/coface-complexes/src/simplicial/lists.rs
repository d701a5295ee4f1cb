//! Vertex lists, and the walk through all their faces in which equal faces of different lists meet.
//!
//! Below a face the lists that contain it are looked at together: each gives the vertices after that face, these are
//! sorted, and equal ones are the next face. Each pair of a list and a face of it is sorted once, in a short array.

use super::simplex::repeated;
use super::tree::CALL_LIMIT;
use coface_algebra::{Error, ErrorKind, memory};

/// Ends each list of [`Lists`]; the numbers before it are smaller.
pub(super) const END: u32 = u32::MAX;

/// Vertex lists made ready for building: sorted, checked, with the vertices renumbered without gaps.
pub(super) struct Lists {
    /// The original numbers of the vertices, rising.
    pub(super) names: Vec<u32>,
    /// The lists one after the other as ranks in `names`, each rising and followed by [`END`].
    pub(super) ranks: Vec<u32>,
    /// The greatest number of vertices in a list.
    pub(super) longest: usize,
    /// Upper bound of the number of faces of all lists.
    pub(super) face_bound: u64,
}

impl Lists {
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for an empty list or a repeated vertex; [`ErrorKind::TooLarge`] for a list with
    /// more faces than one call may add, and for 2^32 vertices in all.
    pub(super) fn new<L: AsRef<[u32]>>(lists: impl IntoIterator<Item = L>) -> Result<Self, Error> {
        let (mut items, mut ends): (Vec<u32>, Vec<u32>) = (Vec::new(), Vec::new());
        let (mut longest, mut face_bound, mut greatest) = (0, 0u64, 0);
        for (position, list) in lists.into_iter().enumerate() {
            let list = list.as_ref();
            let start = items.len();
            items.extend_from_slice(list);
            let own = &mut items[start..];
            if !own.is_sorted_by(|a, b| a < b) {
                own.sort_unstable();
                if let Some(pair) = own.windows(2).find(|pair| pair[0] == pair[1]) {
                    return Err(in_list(&repeated(pair[0], list), position));
                }
            }
            let Some(&last) = own.last() else {
                return Err(Error::invalid(format!("list {position} has no vertex"))
                    .with_cure("name at least one vertex in each simplex"));
            };
            if list.len() > LARGE {
                check_face_count(list.len(), list.len())?;
            }
            greatest = greatest.max(last);
            longest = longest.max(list.len());
            face_bound = face_bound.saturating_add((1 << list.len()) - 1);
            ends.push(items.len() as u32);
            items.push(END);
        }
        if u32::try_from(items.len()).is_err() {
            return Err(Error::new(
                ErrorKind::TooLarge,
                "the lists have 2^32 vertices or more in all, too many for one call",
            )
            .with_cure("insert them in several calls"));
        }
        let names = renumber(&mut items, &ends, greatest);
        Ok(Self { names, ranks: items, longest, face_bound })
    }

    /// Where each vertex occurs: the positions in `ranks` of vertex r are `positions[starts[r]..starts[r + 1]]`.
    pub(super) fn occurrences(&self) -> (Vec<u32>, Vec<u32>) {
        let mut starts = vec![0u32; self.names.len() + 2];
        for &rank in self.ranks.iter().filter(|&&rank| rank != END) {
            starts[rank as usize + 2] += 1;
        }
        for i in 2..starts.len() {
            starts[i] += starts[i - 1];
        }
        let total = starts.last().map_or(0, |&total| total as usize);
        let mut positions = vec![0u32; total];
        for (at, &rank) in self.ranks.iter().enumerate().filter(|&(_, &rank)| rank != END) {
            let next = &mut starts[rank as usize + 1];
            positions[*next as usize] = at as u32;
            *next += 1;
        }
        starts.pop();
        (starts, positions)
    }

    /// The lists of ranks.
    pub(super) fn iter(&self) -> impl Iterator<Item = &[u32]> {
        self.ranks.split(|&rank| rank == END).filter(|list| !list.is_empty())
    }

    /// The ranks after a position in its list.
    pub(super) fn rest(&self, position: u32) -> &[u32] {
        let rest = &self.ranks[position as usize + 1..];
        let count = rest.iter().take_while(|&&rank| rank != END).count();
        &rest[..count]
    }
}

/// Replaces the numbers by their ranks and gives the numbers in use, rising. The places of `ends` stay.
fn renumber(items: &mut [u32], ends: &[u32], greatest: u32) -> Vec<u32> {
    if items.is_empty() {
        return Vec::new();
    }
    if greatest < END && greatest as usize <= 4 * items.len() {
        let mut ranks = vec![END; greatest as usize + 1];
        for &item in items.iter().filter(|&&item| item != END) {
            ranks[item as usize] = 0;
        }
        let names: Vec<u32> = (0..=greatest).filter(|&number| ranks[number as usize] != END).collect();
        if names.len() < ranks.len() {
            for (rank, &name) in names.iter().enumerate() {
                ranks[name as usize] = rank as u32;
            }
            for item in items.iter_mut().filter(|item| **item != END) {
                *item = ranks[*item as usize];
            }
        }
        return names;
    }
    // END is also a possible number of a vertex here, so the lists are taken one by one.
    let mut names = Vec::with_capacity(items.len() - ends.len());
    let mut start = 0;
    for &end in ends {
        names.extend_from_slice(&items[start..end as usize]);
        start = end as usize + 1;
    }
    names.sort_unstable();
    names.dedup();
    start = 0;
    for &end in ends {
        for item in &mut items[start..end as usize] {
            *item = names.partition_point(|name| name < item) as u32;
        }
        start = end as usize + 1;
    }
    names
}

pub(super) fn in_list(error: &Error, position: usize) -> Error {
    let cure = error.cure().unwrap_or_default().to_owned();
    Error::new(error.kind(), format!("list {position}: {}", error.message())).with_cure(cure)
}

/// The number of faces of a simplex that have at most `limit` vertices.
///
/// # Errors
/// [`ErrorKind::TooLarge`] if they are more than one call may add, or than memory holds.
pub(super) fn check_face_count(vertex_count: usize, limit: usize) -> Result<usize, Error> {
    let (mut total, mut binomial) = (0u128, 1u128);
    for k in 1..=limit.min(vertex_count) {
        binomial = binomial * (vertex_count + 1 - k) as u128 / k as u128;
        total += binomial;
        if total > CALL_LIMIT as u128 {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!(
                    "a simplex of dimension {} has more than 2^28 faces of dimension up to {}",
                    vertex_count - 1,
                    limit.min(vertex_count) - 1
                ),
            )
            .with_cure("take a skeleton of it: coface skeleton INPUT --dimension K -o OUT.json"));
        }
    }
    let what = || format!("a simplex of dimension {}, which has {total} faces,", vertex_count - 1);
    memory::require(total as u64 * FACE_BYTES, what)?;
    Ok(total as usize)
}

/// Simplices of more vertices have so many faces that memory may not suffice for one.
const LARGE: usize = 20;

/// What a face takes while a complex and its boundary matrices are made, measured on single simplices of 18 to 22 vertices.
const FACE_BYTES: u64 = 145;

/// Lists that are looked at together are freed of repetitions when they are more than this.
const CROWD: usize = 64;

/// What grows when the faces of lists are walked through.
pub(super) trait Growth {
    /// Adds the faces that continue the face `parent` by one of these vertices each; their numbers are consecutive and
    /// the first is given. `depth` is their dimension; each parent is told once, after all parents before it.
    fn add_children(
        &mut self,
        parent: u32,
        depth: usize,
        ranks: impl ExactSizeIterator<Item = u32> + Clone,
    ) -> u32;

    /// Makes room for `more` faces of dimension 1 and up.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if there is none.
    fn reserve(&mut self, more: usize) -> Result<(), Error>;
}

/// The walk through the faces of some lists.
pub(super) struct FaceWalk<'a, G> {
    lists: &'a Lists,
    growth: G,
    /// Groups of (vertex, position in the lists), one dimension upon the other.
    stack: Vec<u64>,
    /// The vertices that continue a face.
    ranks: Vec<u32>,
}

impl<'a, G: Growth> FaceWalk<'a, G> {
    pub(super) fn new(lists: &'a Lists, growth: G) -> Self {
        Self { lists, growth, stack: Vec::new(), ranks: Vec::new() }
    }

    pub(super) fn into_growth(self) -> G {
        self.growth
    }

    /// Grows all faces of dimension 1 and up whose least vertex is `rank`, found at these positions of the lists.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] as [`Growth::reserve`].
    pub(super) fn grow_from_vertex(&mut self, rank: u32, positions: &[u32]) -> Result<(), Error> {
        self.stack.clear();
        self.stack.extend(positions.iter().map(|&position| u64::from(position)));
        self.grow(rank, 0, 1)
    }

    /// Grows the faces that continue `parent`, which ends at the positions from `begin` on in the stack.
    fn grow(&mut self, parent: u32, begin: usize, depth: usize) -> Result<(), Error> {
        let lists = self.lists;
        if let [only] = self.stack[begin..] {
            let rest = lists.rest(only as u32);
            self.growth.reserve((1 << rest.len()) - 1)?;
            self.grow_all(parent, rest, depth);
            return Ok(());
        }
        if self.stack.len() - begin > CROWD {
            self.thin_out(begin);
        }
        let end = self.stack.len();
        for i in begin..end {
            let position = self.stack[i] as u32;
            self.stack.extend(
                lists
                    .rest(position)
                    .iter()
                    .zip(position + 1..)
                    .map(|(&rank, at)| u64::from(rank) << 32 | u64::from(at)),
            );
        }
        let below = self.stack.len();
        if below == end {
            return Ok(());
        }
        self.stack[end..].sort_unstable();
        self.ranks.clear();
        self.ranks.extend(
            self.stack[end..].chunk_by(|a, b| a >> 32 == b >> 32).map(|group| (group[0] >> 32) as u32),
        );
        self.growth.reserve(self.ranks.len())?;
        let mut child = self.growth.add_children(parent, depth, self.ranks.iter().copied());
        let mut at = end;
        while at < below {
            let rank = self.stack[at] >> 32;
            while at < below && self.stack[at] >> 32 == rank {
                self.stack.push(self.stack[at]);
                at += 1;
            }
            self.grow(child, below, depth + 1)?;
            self.stack.truncate(below);
            child += 1;
        }
        self.stack.truncate(end);
        Ok(())
    }

    /// All faces of one list that continue `parent`.
    fn grow_all(&mut self, parent: u32, rest: &[u32], depth: usize) {
        if rest.is_empty() {
            return;
        }
        let first = self.growth.add_children(parent, depth, rest.iter().copied());
        for i in 1..rest.len() {
            self.grow_all(first + i as u32 - 1, &rest[i..], depth + 1);
        }
    }

    /// Takes out of the group from `begin` on the lists whose rest repeats or begins another's.
    fn thin_out(&mut self, begin: usize) {
        let lists = self.lists;
        self.stack[begin..].sort_by(|&a, &b| lists.rest(a as u32).cmp(lists.rest(b as u32)));
        let mut kept = begin;
        for i in begin..self.stack.len() {
            let own = lists.rest(self.stack[i] as u32);
            if self.stack.get(i + 1).is_none_or(|&next| !lists.rest(next as u32).starts_with(own)) {
                self.stack[kept] = self.stack[i];
                kept += 1;
            }
        }
        self.stack.truncate(kept);
    }
}

/// The fault of lists with more faces than one call may add.
pub(super) fn too_many_faces() -> Error {
    Error::new(ErrorKind::TooLarge, "the simplices have more than 2^28 faces, too many for one call")
        .with_cure("insert them in several calls, or their skeletons of lower dimension")
}
