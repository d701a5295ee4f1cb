//! Iterators of the standard library with the methods of rayon.

use std::iter::{
    Cloned, Copied, Enumerate, Filter, FilterMap, FlatMap, Flatten, Map, Rev, Skip, StepBy, Sum, Take, Zip,
};

/// An iterator that has the methods of the parallel ones.
#[derive(Clone, Debug)]
pub struct Serial<I>(I);

impl<I: Iterator> IntoIterator for Serial<I> {
    type Item = I::Item;
    type IntoIter = I;

    fn into_iter(self) -> I {
        self.0
    }
}

/// What can be gone through.
pub trait IntoParallelIterator {
    /// What there is of it.
    type Item;
    /// The iterator of the standard library.
    type Iter: Iterator<Item = Self::Item>;

    /// Its items.
    fn into_par_iter(self) -> Serial<Self::Iter>;
}

impl<C: IntoIterator> IntoParallelIterator for C {
    type Item = C::Item;
    type Iter = C::IntoIter;

    fn into_par_iter(self) -> Serial<C::IntoIter> {
        Serial(self.into_iter())
    }
}

/// What can be gone through without being taken.
pub trait IntoParallelRefIterator<'a> {
    /// What there is of it.
    type Item: 'a;
    /// The iterator of the standard library.
    type Iter: Iterator<Item = Self::Item>;

    /// Its items.
    fn par_iter(&'a self) -> Serial<Self::Iter>;
}

impl<'a, C: ?Sized + 'a> IntoParallelRefIterator<'a> for C
where
    &'a C: IntoIterator,
{
    type Item = <&'a C as IntoIterator>::Item;
    type Iter = <&'a C as IntoIterator>::IntoIter;

    fn par_iter(&'a self) -> Serial<Self::Iter> {
        Serial(self.into_iter())
    }
}

/// What can be gone through and changed.
pub trait IntoParallelRefMutIterator<'a> {
    /// What there is of it.
    type Item: 'a;
    /// The iterator of the standard library.
    type Iter: Iterator<Item = Self::Item>;

    /// Its items.
    fn par_iter_mut(&'a mut self) -> Serial<Self::Iter>;
}

impl<'a, C: ?Sized + 'a> IntoParallelRefMutIterator<'a> for C
where
    &'a mut C: IntoIterator,
{
    type Item = <&'a mut C as IntoIterator>::Item;
    type Iter = <&'a mut C as IntoIterator>::IntoIter;

    fn par_iter_mut(&'a mut self) -> Serial<Self::Iter> {
        Serial(self.into_iter())
    }
}

/// What items are added to.
pub trait ParallelExtend<T> {
    /// Adds the items in their order.
    fn par_extend<C: IntoParallelIterator<Item = T>>(&mut self, items: C);
}

impl<T, E: Extend<T>> ParallelExtend<T> for E {
    fn par_extend<C: IntoParallelIterator<Item = T>>(&mut self, items: C) {
        self.extend(items.into_par_iter().0);
    }
}

impl<I: Iterator> Serial<I> {
    pub(super) fn new(items: I) -> Self {
        Self(items)
    }

    /// The same: nothing is divided.
    pub fn with_min_len(self, _: usize) -> Self {
        self
    }

    /// The same: nothing is divided.
    pub fn with_max_len(self, _: usize) -> Self {
        self
    }

    /// What a function makes of the items.
    pub fn map<R, F: FnMut(I::Item) -> R>(self, function: F) -> Serial<Map<I, F>> {
        Serial(self.0.map(function))
    }

    /// What a function makes of the items, with something that it may change from one to the next.
    pub fn map_init<S, R>(
        self,
        init: impl FnOnce() -> S,
        function: impl Fn(&mut S, I::Item) -> R,
    ) -> Serial<impl Iterator<Item = R>> {
        let mut state = init();
        Serial(self.0.map(move |item| function(&mut state, item)))
    }

    /// The items for which something holds.
    pub fn filter<F: FnMut(&I::Item) -> bool>(self, holds: F) -> Serial<Filter<I, F>> {
        Serial(self.0.filter(holds))
    }

    /// What a function makes of the items of which it makes something.
    pub fn filter_map<R, F: FnMut(I::Item) -> Option<R>>(self, function: F) -> Serial<FilterMap<I, F>> {
        Serial(self.0.filter_map(function))
    }

    /// All that a function makes of the items, one item after the other.
    pub fn flat_map<R: IntoParallelIterator>(
        self,
        mut function: impl FnMut(I::Item) -> R,
    ) -> Serial<impl Iterator<Item = R::Item>> {
        Serial(self.0.flat_map(move |item| function(item).into_par_iter()))
    }

    /// All that a function makes of the items, one item after the other.
    pub fn flat_map_iter<R: IntoIterator, F: FnMut(I::Item) -> R>(
        self,
        function: F,
    ) -> Serial<FlatMap<I, R, F>> {
        Serial(self.0.flat_map(function))
    }

    /// All that there is in the items.
    pub fn flatten(self) -> Serial<Flatten<I>>
    where
        I::Item: IntoIterator,
    {
        Serial(self.0.flatten())
    }

    /// All that there is in the items.
    pub fn flatten_iter(self) -> Serial<Flatten<I>>
    where
        I::Item: IntoIterator,
    {
        Serial(self.0.flatten())
    }

    /// The items with those of another in the same place.
    pub fn zip<C: IntoParallelIterator>(self, other: C) -> Serial<Zip<I, C::Iter>> {
        Serial(self.0.zip(other.into_par_iter().0))
    }

    /// The items with their places.
    pub fn enumerate(self) -> Serial<Enumerate<I>> {
        Serial(self.0.enumerate())
    }

    /// All but the first items.
    pub fn skip(self, count: usize) -> Serial<Skip<I>> {
        Serial(self.0.skip(count))
    }

    /// The first items.
    pub fn take(self, count: usize) -> Serial<Take<I>> {
        Serial(self.0.take(count))
    }

    /// So many items: the first.
    pub fn take_any(self, count: usize) -> Serial<Take<I>> {
        self.take(count)
    }

    /// The first item, and those that follow it at a distance.
    pub fn step_by(self, step: usize) -> Serial<StepBy<I>> {
        Serial(self.0.step_by(step))
    }

    /// The items from the last to the first.
    pub fn rev(self) -> Serial<Rev<I>>
    where
        I: DoubleEndedIterator,
    {
        Serial(self.0.rev())
    }

    /// Calls a function with each item.
    pub fn for_each(self, function: impl FnMut(I::Item)) {
        self.0.for_each(function);
    }

    /// Calls a function with each item, and something that it may change from one to the next.
    pub fn for_each_init<S>(self, init: impl FnOnce() -> S, function: impl Fn(&mut S, I::Item)) {
        let mut state = init();
        self.0.for_each(|item| function(&mut state, item));
    }

    /// Calls a function with each item until it fails.
    ///
    /// # Errors
    /// The first of the function.
    pub fn try_for_each<E>(mut self, function: impl FnMut(I::Item) -> Result<(), E>) -> Result<(), E> {
        self.0.try_for_each(function)
    }

    /// The items put together, two at a time.
    pub fn reduce(
        self,
        identity: impl FnOnce() -> I::Item,
        put_together: impl FnMut(I::Item, I::Item) -> I::Item,
    ) -> I::Item {
        self.0.fold(identity(), put_together)
    }

    /// One item: what all were added to.
    pub fn fold<S>(
        self,
        identity: impl FnOnce() -> S,
        add: impl FnMut(S, I::Item) -> S,
    ) -> Serial<std::iter::Once<S>> {
        Serial(std::iter::once(self.0.fold(identity(), add)))
    }

    /// The sum of the items.
    pub fn sum<S: Sum<I::Item>>(self) -> S {
        self.0.sum()
    }

    /// The number of items.
    pub fn count(self) -> usize {
        self.0.count()
    }

    /// The greatest item.
    pub fn max(self) -> Option<I::Item>
    where
        I::Item: Ord,
    {
        self.0.max()
    }

    /// The least item.
    pub fn min(self) -> Option<I::Item>
    where
        I::Item: Ord,
    {
        self.0.min()
    }

    /// Whether something holds for all items.
    pub fn all(mut self, holds: impl FnMut(I::Item) -> bool) -> bool {
        self.0.all(holds)
    }

    /// Whether something holds for an item.
    pub fn any(mut self, holds: impl FnMut(I::Item) -> bool) -> bool {
        self.0.any(holds)
    }

    /// The first item for which something holds.
    pub fn find_first(mut self, holds: impl Fn(&I::Item) -> bool) -> Option<I::Item> {
        self.0.find(holds)
    }

    /// The first thing that a function makes of an item.
    pub fn find_map_first<R>(mut self, function: impl Fn(I::Item) -> Option<R>) -> Option<R> {
        self.0.find_map(function)
    }

    /// The items as a collection.
    pub fn collect<C: FromIterator<I::Item>>(self) -> C {
        self.0.collect()
    }

    /// The first parts of pairs, and the second.
    pub fn unzip<A, B, FromA, FromB>(self) -> (FromA, FromB)
    where
        I: Iterator<Item = (A, B)>,
        FromA: Default + Extend<A>,
        FromB: Default + Extend<B>,
    {
        self.0.unzip()
    }
}

impl<I: ExactSizeIterator> Serial<I> {
    /// The number of items.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there is no item.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl<'a, T: 'a, I: Iterator<Item = &'a T>> Serial<I> {
    /// Copies of the items.
    pub fn copied(self) -> Serial<Copied<I>>
    where
        T: Copy,
    {
        Serial(self.0.copied())
    }

    /// Clones of the items.
    pub fn cloned(self) -> Serial<Cloned<I>>
    where
        T: Clone,
    {
        Serial(self.0.cloned())
    }
}
