//! Lists of lists in one piece of memory.

/// Lists one after the other.
#[derive(Clone, Debug)]
pub(crate) struct Lists<T> {
    /// Where each list ends.
    ends: Vec<usize>,
    items: Vec<T>,
}

impl<T: Clone> Lists<T> {
    pub(crate) fn push(&mut self, list: impl IntoIterator<Item = T>) {
        self.items.extend(list);
        self.ends.push(self.items.len());
    }

    pub(crate) fn len(&self) -> usize {
        self.ends.len()
    }

    pub(crate) fn get(&self, list: usize) -> &[T] {
        &self.items[list.checked_sub(1).map_or(0, |before| self.ends[before])..self.ends[list]]
    }

    /// The items of all lists.
    pub(crate) fn items(&self) -> &[T] {
        &self.items
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &[T]> + Clone {
        (0..self.len()).map(|list| self.get(list))
    }
}

impl<T: Clone, L: IntoIterator<Item = T>> FromIterator<L> for Lists<T> {
    fn from_iter<I: IntoIterator<Item = L>>(lists: I) -> Self {
        let mut all = Self { ends: Vec::new(), items: Vec::new() };
        lists.into_iter().for_each(|list| all.push(list));
        all
    }
}
