//! Lists of lists in one flat array.

use crate::error::{Error, ErrorKind};
use crate::ids::narrow;
use crate::progress::stage_of_many;
use crate::threads;
use rayon::prelude::*;

/// A list of lists of 32-bit numbers, flat: all items in one array and where each list starts.
///
/// Lists of one common length (all triangles) need no starts, and none are stored.
///
/// # Examples
/// ```
/// use coface_algebra::RaggedArray;
/// let polygons = RaggedArray::from_lists([vec![0, 1, 2], vec![2, 1, 3, 4]]);
/// assert_eq!(polygons.len(), 2);
/// assert_eq!(polygons.list(1), [2, 1, 3, 4]);
/// ```
#[derive(Clone, Debug)]
pub struct RaggedArray {
    items: Vec<u32>,
    starts: Starts,
}

#[derive(Clone, Debug)]
enum Starts {
    /// All lists have this length, which is not zero.
    Uniform(usize),
    /// List `i` is `items[starts[i]..starts[i + 1]]`; one more start than lists.
    Listed(Vec<u32>),
}

impl Default for RaggedArray {
    fn default() -> Self {
        Self { items: Vec::new(), starts: Starts::Listed(vec![0]) }
    }
}

impl RaggedArray {
    /// No list at all.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::RaggedArray::new().len(), 0);
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// Lists of the length `width`, one after the other.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if `width` is zero or does not divide the number of items;
    /// [`ErrorKind::TooLarge`] beyond 2^32 - 1 items.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangles = RaggedArray::uniform(3, vec![0, 1, 2, 2, 1, 3])?;
    /// assert_eq!(triangles.list(1), [2, 1, 3]);
    /// # Ok(()) }
    /// ```
    pub fn uniform(width: usize, items: Vec<u32>) -> Result<Self, Error> {
        if width == 0 || !items.len().is_multiple_of(width) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} items cannot be cut into lists of length {width}", items.len()),
            ));
        }
        if u32::try_from(items.len()).is_err() {
            return Err(too_large(items.len()));
        }
        Ok(Self { items, starts: Starts::Uniform(width) })
    }

    /// Lists between consecutive starts: list `i` is `items[starts[i]..starts[i + 1]]`.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless the starts rise from 0 to the number of items;
    /// [`ErrorKind::TooLarge`] beyond 2^32 - 1 items.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let lists = RaggedArray::from_parts(vec![0, 2, 2, 3], vec![7, 8, 9])?;
    /// assert_eq!(lists, RaggedArray::from_lists([vec![7, 8], vec![], vec![9]]));
    /// # Ok(()) }
    /// ```
    pub fn from_parts(starts: Vec<u32>, items: Vec<u32>) -> Result<Self, Error> {
        let Ok(item_count) = u32::try_from(items.len()) else { return Err(too_large(items.len())) };
        if starts.first() != Some(&0) || starts.last() != Some(&item_count) || !starts.is_sorted() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("the starts of the lists must rise from 0 to the number of items, {item_count}"),
            ));
        }
        Ok(Self { items, starts: Starts::Listed(starts) })
    }

    /// The array with these lists.
    ///
    /// # Panics
    /// Beyond 2^32 - 1 items.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// assert_eq!(RaggedArray::from_lists([[0, 1], [1, 2]]).items(), [0, 1, 1, 2]);
    /// ```
    pub fn from_lists<L: AsRef<[u32]>>(lists: impl IntoIterator<Item = L>) -> Self {
        let mut array = Self::new();
        for list in lists {
            array.push(list.as_ref());
        }
        array
    }

    /// The positions of items by their keys below `key_count`: list k has those with key k, rising.
    ///
    /// # Panics
    /// If a key is not below `key_count`, or from 2^32 items on.
    ///
    /// # Complexity
    /// Linear: a counting sort.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// let places = RaggedArray::grouped(3, [2, 0, 2].into_iter());
    /// assert_eq!(places.list(2), [0, 2]);
    /// assert!(places.list(1).is_empty());
    /// ```
    pub fn grouped(key_count: usize, keys: impl Iterator<Item = u32> + Clone) -> Self {
        // List k begins at the start after the next one of it, until its items have moved that to where it ends.
        let mut starts = vec![0u32; key_count + 2];
        let mut count = 0u32;
        for key in keys.clone() {
            assert!((key as usize) < key_count, "a key is not below the number of keys");
            starts[key as usize + 2] += 1;
            count = count.checked_add(1).expect("fewer than 2^32 items");
        }
        for i in 2..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut items = vec![0; count as usize];
        let steps = stage_of_many("grouping", items.len());
        for (position, key) in steps.each(keys.enumerate()) {
            let place = &mut starts[key as usize + 1];
            items[*place as usize] = narrow(position);
            *place += 1;
        }
        starts.pop();
        Self { items, starts: Starts::Listed(starts) }
    }

    /// The lists that contain each item below `item_count`: list x has the positions of the lists that contain x,
    /// rising, each as often as it contains x.
    ///
    /// # Panics
    /// If an item is not below `item_count`.
    ///
    /// # Complexity
    /// Linear: a counting sort.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// let edges = RaggedArray::from_lists([[0, 2], [2, 1]]);
    /// assert_eq!(edges.transposed(4), RaggedArray::from_lists([vec![0], vec![1], vec![0, 1], vec![]]));
    /// ```
    #[must_use]
    pub fn transposed(&self, item_count: usize) -> Self {
        let mut starts = vec![0u32; item_count + 1];
        for &item in &self.items {
            starts[item as usize] += 1;
        }
        let mut total = 0;
        for start in &mut starts {
            total += *start;
            *start = total;
        }
        // From the end, so that each start comes down to its place and lists rise.
        let mut lists = vec![0; self.items.len()];
        for (position, list) in self.iter().enumerate().rev() {
            for &item in list {
                let next = &mut starts[item as usize];
                *next -= 1;
                lists[*next as usize] = narrow(position);
            }
        }
        Self { items: lists, starts: Starts::Listed(starts) }
    }

    /// The number of lists.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// assert_eq!(RaggedArray::from_lists([vec![0, 1], vec![]]).len(), 2);
    /// ```
    pub fn len(&self) -> usize {
        match &self.starts {
            Starts::Uniform(width) => self.items.len() / width,
            Starts::Listed(starts) => starts.len() - 1,
        }
    }

    /// Whether there is no list.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// assert!(RaggedArray::new().is_empty());
    /// ```
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The number of items in all lists.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// assert_eq!(RaggedArray::from_lists([vec![0, 1], vec![5]]).item_count(), 3);
    /// ```
    pub fn item_count(&self) -> usize {
        self.items.len()
    }

    /// The common length of all lists if they are stored that way.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(RaggedArray::uniform(2, vec![0, 1, 1, 2])?.uniform_width(), Some(2));
    /// # Ok(()) }
    /// ```
    pub fn uniform_width(&self) -> Option<usize> {
        match &self.starts {
            Starts::Uniform(width) => Some(*width),
            Starts::Listed(_) => None,
        }
    }

    /// Where list `i` starts among [`Self::items`]; `start(len())` is the number of items.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// let lists = RaggedArray::from_lists([vec![7, 8], vec![9]]);
    /// assert_eq!((lists.start(1), lists.start(2)), (2, 3));
    /// ```
    pub fn start(&self, i: usize) -> usize {
        match &self.starts {
            Starts::Uniform(width) => i * width,
            Starts::Listed(starts) => starts[i] as usize,
        }
    }

    /// The list at position `i`.
    ///
    /// # Panics
    /// If `i >= len()`.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// assert_eq!(RaggedArray::from_lists([vec![7, 8], vec![9]]).list(0), [7, 8]);
    /// ```
    pub fn list(&self, i: usize) -> &[u32] {
        &self.items[self.start(i)..self.start(i + 1)]
    }

    /// All lists in order.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// let polygons = RaggedArray::from_lists([vec![0, 1, 2], vec![0, 2, 3, 4]]);
    /// assert!(polygons.iter().map(<[u32]>::len).eq([3, 4]));
    /// ```
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> + DoubleEndedIterator {
        (0..self.len()).map(|i| self.list(i))
    }

    /// The items of all lists, one after the other.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// assert_eq!(RaggedArray::from_lists([vec![7, 8], vec![9]]).items(), [7, 8, 9]);
    /// ```
    pub fn items(&self) -> &[u32] {
        &self.items
    }

    /// The items of all lists, for changing them in place; the lengths stay.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// let mut lists = RaggedArray::from_lists([[0, 1], [1, 2]]);
    /// lists.items_mut().iter_mut().for_each(|item| *item += 10);
    /// assert_eq!(lists.list(1), [11, 12]);
    /// ```
    pub fn items_mut(&mut self) -> &mut [u32] {
        &mut self.items
    }

    /// Changes all lists in place and in parallel. The second argument of `change` is scratch space.
    #[doc(hidden)]
    pub fn change_lists<Scratch: Default + Send>(
        &mut self,
        change: impl Fn(&mut [u32], &mut Scratch) + Sync,
    ) {
        const AT_ONCE: usize = 1 << 10;
        let starts = match &self.starts {
            Starts::Uniform(width) if !threads::is_enough(self.items.len()) => {
                let mut scratch = Scratch::default();
                return self.items.chunks_mut(*width).for_each(|list| change(list, &mut scratch));
            }
            Starts::Uniform(width) => {
                let lists = self.items.par_chunks_mut(*width).with_min_len(AT_ONCE);
                return lists.for_each_init(Scratch::default, |scratch, list| change(list, scratch));
            }
            Starts::Listed(starts) => starts,
        };
        let mut parts = Vec::with_capacity(starts.len() / AT_ONCE + 1);
        let mut rest = &mut self.items[..];
        for first in (0..starts.len() - 1).step_by(AT_ONCE) {
            let own = &starts[first..(first + AT_ONCE + 1).min(starts.len())];
            let (part, after) = rest.split_at_mut((own[own.len() - 1] - own[0]) as usize);
            parts.push((own, part));
            rest = after;
        }
        let change_part = |scratch: &mut Scratch, (starts, mut rest): (&[u32], &mut [u32])| {
            for ends in starts.windows(2) {
                let (list, after) = std::mem::take(&mut rest).split_at_mut((ends[1] - ends[0]) as usize);
                change(list, scratch);
                rest = after;
            }
        };
        if !threads::is_enough(parts.iter().map(|(_, items)| items.len()).sum()) {
            let mut scratch = Scratch::default();
            return parts.into_iter().for_each(|part| change_part(&mut scratch, part));
        }
        parts.into_par_iter().for_each_init(Scratch::default, change_part);
    }

    /// The items of all lists as a vector.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// assert_eq!(RaggedArray::from_lists([[0, 1], [1, 2]]).into_items(), [0, 1, 1, 2]);
    /// ```
    pub fn into_items(self) -> Vec<u32> {
        self.items
    }

    /// Appends a list.
    ///
    /// # Panics
    /// Beyond 2^32 - 1 items.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// let mut polygons = RaggedArray::new();
    /// polygons.push(&[0, 1, 2]);
    /// assert_eq!(polygons.list(0), [0, 1, 2]);
    /// ```
    pub fn push(&mut self, list: &[u32]) {
        match &mut self.starts {
            Starts::Uniform(width) if *width == list.len() => {}
            Starts::Listed(starts) if starts.len() == 1 && !list.is_empty() => {
                self.starts = Starts::Uniform(list.len());
            }
            _ => self.listed_starts(list.len()),
        }
        self.items.extend_from_slice(list);
        assert!(u32::try_from(self.items.len()).is_ok(), "a ragged array holds fewer than 2^32 items");
    }

    /// Appends the lists of another array, each item with a number added.
    ///
    /// # Panics
    /// Beyond 2^32 - 1 items, or if an item leaves the range.
    #[doc(hidden)]
    pub fn append_moved(&mut self, other: &Self, by: u32) {
        let width =
            other.uniform_width().filter(|&width| self.is_empty() || self.uniform_width() == Some(width));
        let moved = |&item: &u32| item.checked_add(by).expect("items stay below 2^32");
        if let Some(width) = width {
            self.starts = Starts::Uniform(width);
            self.items.extend(other.items.iter().map(moved));
            assert!(u32::try_from(self.items.len()).is_ok(), "a ragged array holds fewer than 2^32 items");
            return;
        }
        let mut list = Vec::new();
        for own in other.iter() {
            list.clear();
            list.extend(own.iter().map(moved));
            self.push(&list);
        }
    }

    /// Stores the starts explicitly, and appends the one after a list of length `added`.
    fn listed_starts(&mut self, added: usize) {
        if let Starts::Uniform(width) = self.starts {
            let count = self.items.len() / width;
            self.starts = Starts::Listed((0..=count).map(|i| narrow(i * width)).collect());
        }
        if let Starts::Listed(starts) = &mut self.starts {
            starts.push(narrow(self.items.len() + added));
        }
    }
}

/// Two arrays are equal when their lists are; how the starts are stored does not matter.
impl PartialEq for RaggedArray {
    fn eq(&self, other: &Self) -> bool {
        self.items == other.items
            && self.len() == other.len()
            && (0..self.len()).all(|i| self.start(i) == other.start(i))
    }
}

impl Eq for RaggedArray {}

fn too_large(count: usize) -> Error {
    Error::new(ErrorKind::TooLarge, format!("{count} items in one list of lists; the limit is 2^32 - 1"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn uniform_and_listed_starts_agree() {
        let mut grown = RaggedArray::new();
        for triangle in [[0, 1, 2], [2, 1, 3]] {
            grown.push(&triangle);
        }
        assert_eq!(grown.uniform_width(), Some(3));
        assert_eq!(grown, RaggedArray::from_parts(vec![0, 3, 6], vec![0, 1, 2, 2, 1, 3]).unwrap());
        grown.push(&[5, 6]);
        grown.push(&[]);
        assert_eq!(grown.uniform_width(), None);
        assert_eq!(grown.iter().map(<[u32]>::len).collect::<Vec<_>>(), [3, 3, 2, 0]);
    }

    #[test]
    fn an_empty_first_list_counts() {
        let mut lists = RaggedArray::new();
        lists.push(&[]);
        lists.push(&[7]);
        assert_eq!((lists.len(), lists.list(0).len(), lists.list(1)), (2, 0, &[7][..]));
    }

    #[test]
    fn shapes_are_checked() {
        assert_eq!(RaggedArray::uniform(3, vec![1, 2]).unwrap_err().kind(), ErrorKind::Shape);
        assert_eq!(RaggedArray::uniform(0, vec![]).unwrap_err().kind(), ErrorKind::Shape);
        assert!(RaggedArray::from_parts(vec![0, 2, 1, 3], vec![0; 3]).is_err());
        assert!(RaggedArray::from_parts(vec![], vec![]).is_err());
    }
}
