//! Typed ids: dense 32-bit numbers that cannot be mixed up, and vectors indexed by one kind of them.
//!
//! A cell of a complex is its position `0..count` in its own list. The five kinds below keep a vertex number from
//! being used where a face is meant; [`CellId`] is for cells whose degree is only known at run time.

use std::fmt;
use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

/// A dense id: a position in the list of all things of one kind.
pub trait Id: Copy + Eq + Ord + fmt::Debug {
    /// The id at this position.
    ///
    /// # Panics
    /// If `index` does not fit in 32 bits.
    fn new(index: usize) -> Self;
    /// The position, for indexing dense arrays.
    fn index(self) -> usize;
}

/// The position in a list as a 32-bit number.
///
/// The constructors of lists, matrices and complexes refuse $2^{32}$ and more items, so that positions in them fit;
/// debug builds check it again.
#[doc(hidden)]
#[inline]
#[allow(clippy::cast_possible_truncation, reason = "lists of 2^32 items are refused when they are made")]
pub fn narrow(position: usize) -> u32 {
    debug_assert!(u32::try_from(position).is_ok(), "a list has fewer than 2^32 items");
    position as u32
}

macro_rules! id {
    ($(#[$doc:meta])* $name:ident, $letter:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(u32);

        impl $name {
            /// The id at this position.
            ///
            /// # Panics
            /// If `index` does not fit in 32 bits.
            ///
            /// # Examples
            /// ```
            /// let vertex = coface_algebra::VertexId::new(12);
            /// assert_eq!(vertex.to_string(), "v12");
            /// ```
            pub fn new(index: usize) -> Self {
                Self(u32::try_from(index).expect("an id fits in 32 bits"))
            }

            /// The id with this 32-bit number.
            ///
            /// # Examples
            /// ```
            /// use coface_algebra::FaceId;
            /// assert_eq!(FaceId::from_u32(7), FaceId::new(7));
            /// ```
            pub const fn from_u32(number: u32) -> Self {
                Self(number)
            }

            /// The position, for indexing dense arrays.
            ///
            /// # Examples
            /// ```
            /// let names = ["a", "b"];
            /// assert_eq!(names[coface_algebra::CellId::new(1).index()], "b");
            /// ```
            pub const fn index(self) -> usize {
                self.0 as usize
            }

            /// The position as a 32-bit number.
            ///
            /// # Examples
            /// ```
            /// assert_eq!(coface_algebra::EdgeId::new(3).to_u32(), 3);
            /// ```
            pub const fn to_u32(self) -> u32 {
                self.0
            }
        }

        impl Id for $name {
            fn new(index: usize) -> Self {
                $name::new(index)
            }
            fn index(self) -> usize {
                self.index()
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, concat!($letter, "{}"), self.0)
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Debug::fmt(self, f)
            }
        }
    };
}

id!(
    /// A vertex of one complex or surface. Printed as `v12`.
    VertexId, "v"
);
id!(
    /// An edge of one complex or surface. Printed as `e3`.
    EdgeId, "e"
);
id!(
    /// A halfedge of one surface. Printed as `h7`.
    HalfedgeId, "h"
);
id!(
    /// A face of one surface or complex. Printed as `f0`.
    FaceId, "f"
);
id!(
    /// A cell whose degree is known at run time only. Printed as `c5`.
    CellId, "c"
);

/// A vector indexed by one kind of id, and by nothing else.
///
/// # Examples
/// ```
/// use coface_algebra::{IdVec, VertexId};
/// let mut degrees: IdVec<VertexId, usize> = IdVec::from_vec(vec![2, 3]);
/// degrees[VertexId::new(1)] += 1;
/// assert_eq!(degrees[VertexId::new(1)], 4);
/// ```
#[derive(Clone, PartialEq, Eq)]
pub struct IdVec<I, T> {
    items: Vec<T>,
    kind: PhantomData<fn(I)>,
}

impl<I: Id, T> IdVec<I, T> {
    /// The vector without entries.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{IdVec, VertexId};
    /// assert!(IdVec::<VertexId, f64>::new().is_empty());
    /// ```
    pub const fn new() -> Self {
        Self { items: Vec::new(), kind: PhantomData }
    }

    /// The vector whose entry at position `i` belongs to the id `i`.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, IdVec};
    /// let areas: IdVec<FaceId, f64> = IdVec::from_vec(vec![0.5, 2.0]);
    /// assert_eq!(areas[FaceId::new(1)], 2.0);
    /// ```
    pub const fn from_vec(items: Vec<T>) -> Self {
        Self { items, kind: PhantomData }
    }

    /// The number of entries.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, IdVec};
    /// assert_eq!(IdVec::<FaceId, _>::from_vec(vec!['a', 'b']).len(), 2);
    /// ```
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Whether there is no entry.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, IdVec};
    /// assert!(!IdVec::<FaceId, _>::from_vec(vec!['a']).is_empty());
    /// ```
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// Appends an entry and gives its id.
    ///
    /// # Panics
    /// If there are 2^32 entries already.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, IdVec};
    /// let mut colors = IdVec::new();
    /// let red: FaceId = colors.push("red");
    /// assert_eq!((red, colors[red]), (FaceId::new(0), "red"));
    /// ```
    pub fn push(&mut self, item: T) -> I {
        let id = I::new(self.items.len());
        self.items.push(item);
        id
    }

    /// The entry of `id`, or `None` if there is none.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, IdVec};
    /// let colors = IdVec::from_vec(vec!["red"]);
    /// assert_eq!(colors.try_at(FaceId::new(0)), Some(&"red"));
    /// assert_eq!(colors.try_at(FaceId::new(1)), None);
    /// ```
    pub fn try_at(&self, id: I) -> Option<&T> {
        self.items.get(id.index())
    }

    /// All ids in order.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{IdVec, VertexId};
    /// let heights: IdVec<VertexId, f64> = IdVec::from_vec(vec![1.5, 0.5]);
    /// assert!(heights.ids().eq([VertexId::new(0), VertexId::new(1)]));
    /// ```
    pub fn ids(&self) -> impl ExactSizeIterator<Item = I> + use<I, T> {
        (0..self.items.len()).map(I::new)
    }

    /// All entries in the order of their ids.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{IdVec, VertexId};
    /// let degrees: IdVec<VertexId, usize> = IdVec::from_vec(vec![2, 3]);
    /// assert_eq!(degrees.iter().sum::<usize>(), 5);
    /// ```
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.items.iter()
    }

    /// The entries as a plain slice, in the order of their ids.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{IdVec, VertexId};
    /// assert_eq!(IdVec::<VertexId, _>::from_vec(vec![2, 3]).as_slice(), [2, 3]);
    /// ```
    pub fn as_slice(&self) -> &[T] {
        &self.items
    }

    /// The entries as a plain vector, in the order of their ids.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{IdVec, VertexId};
    /// assert_eq!(IdVec::<VertexId, _>::from_vec(vec![2, 3]).into_vec(), [2, 3]);
    /// ```
    pub fn into_vec(self) -> Vec<T> {
        self.items
    }
}

impl<I: Id, T> Default for IdVec<I, T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<I: Id, T> Index<I> for IdVec<I, T> {
    type Output = T;
    fn index(&self, id: I) -> &T {
        &self.items[id.index()]
    }
}

impl<I: Id, T> IndexMut<I> for IdVec<I, T> {
    fn index_mut(&mut self, id: I) -> &mut T {
        &mut self.items[id.index()]
    }
}

impl<I: Id, T> FromIterator<T> for IdVec<I, T> {
    fn from_iter<S: IntoIterator<Item = T>>(items: S) -> Self {
        Self::from_vec(items.into_iter().collect())
    }
}

impl<'a, I: Id, T> IntoIterator for &'a IdVec<I, T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;
    fn into_iter(self) -> Self::IntoIter {
        self.items.iter()
    }
}

impl<I: Id, T: fmt::Debug> fmt::Debug for IdVec<I, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_map().entries(self.ids().zip(&self.items)).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_print_like_the_drawing() {
        assert_eq!(
            format!("{:?} {} {:?}", VertexId::new(12), EdgeId::new(3), HalfedgeId::new(7)),
            "v12 e3 h7"
        );
        let faces: IdVec<FaceId, u8> = [5, 6].into_iter().collect();
        assert_eq!(format!("{faces:?}"), "{f0: 5, f1: 6}");
    }

    #[test]
    fn push_gives_the_next_id() {
        let mut cells: IdVec<CellId, char> = IdVec::new();
        assert!(cells.is_empty());
        let a = cells.push('a');
        let b = cells.push('b');
        assert_eq!((a.index(), b.index(), cells[b], cells.len()), (0, 1, 'b', 2));
        assert_eq!(cells.try_at(CellId::new(2)), None);
    }

    #[test]
    #[should_panic(expected = "32 bits")]
    fn an_id_beyond_32_bits_is_a_broken_contract() {
        VertexId::new(1 << 32);
    }
}
