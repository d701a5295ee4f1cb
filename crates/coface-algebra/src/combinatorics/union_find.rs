//! Union-find: partitions that only grow coarser, with and without a sign between members.

use crate::Sign;
use crate::ids::narrow;

/// A partition of `0..n` into classes that can be united.
///
/// # Complexity
/// Union by size with path halving: nearly constant time an operation (R. E. Tarjan, *Efficiency of a good but not
/// linear set union algorithm*, 1975).
///
/// # Examples
/// ```
/// use coface_algebra::UnionFind;
/// let mut partition = UnionFind::new(4);
/// assert!(partition.unite(0, 3));
/// assert!(!partition.unite(3, 0));
/// assert_eq!(partition.class_count(), 3);
/// ```
#[derive(Clone, Debug)]
pub struct UnionFind {
    /// The parent of each member, or, for a root, the complement of the size of its class.
    parent: Vec<u32>,
    class_count: usize,
}

const ROOT: u32 = 1 << 31;

impl UnionFind {
    /// The partition of `0..count` into single members.
    ///
    /// # Panics
    /// From 2^31 members on.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::UnionFind::new(3).class_count(), 3);
    /// ```
    pub fn new(count: usize) -> Self {
        assert!(count < ROOT as usize, "a union-find holds fewer than 2^31 members");
        Self { parent: vec![ROOT | 1; count], class_count: count }
    }

    /// The number of members.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::UnionFind::new(3).len(), 3);
    /// ```
    pub fn len(&self) -> usize {
        self.parent.len()
    }

    /// Whether there is no member.
    ///
    /// # Examples
    /// ```
    /// assert!(coface_algebra::UnionFind::new(0).is_empty());
    /// ```
    pub fn is_empty(&self) -> bool {
        self.parent.is_empty()
    }

    /// The number of classes.
    ///
    /// # Examples
    /// ```
    /// let mut partition = coface_algebra::UnionFind::new(3);
    /// partition.unite(0, 2);
    /// assert_eq!(partition.class_count(), 2);
    /// ```
    pub fn class_count(&self) -> usize {
        self.class_count
    }

    /// The representative of the class of `member`; it changes only when the class is united with another.
    ///
    /// # Examples
    /// ```
    /// let mut partition = coface_algebra::UnionFind::new(3);
    /// partition.unite(0, 2);
    /// assert_eq!(partition.find(0), partition.find(2));
    /// ```
    pub fn find(&mut self, member: u32) -> u32 {
        let mut at = member;
        loop {
            let parent = self.parent[at as usize];
            if parent & ROOT != 0 {
                return at;
            }
            let grandparent = self.parent[parent as usize];
            if grandparent & ROOT != 0 {
                return parent;
            }
            self.parent[at as usize] = grandparent;
            at = grandparent;
        }
    }

    /// Unites the classes of two members; false if they were one class already.
    ///
    /// # Examples
    /// ```
    /// let mut partition = coface_algebra::UnionFind::new(2);
    /// assert!(partition.unite(0, 1));
    /// assert!(!partition.unite(0, 1));
    /// ```
    pub fn unite(&mut self, a: u32, b: u32) -> bool {
        let (mut a, mut b) = (self.find(a), self.find(b));
        if a == b {
            return false;
        }
        let (size_a, size_b) = (self.parent[a as usize] & !ROOT, self.parent[b as usize] & !ROOT);
        if size_a < size_b {
            std::mem::swap(&mut a, &mut b);
        }
        self.parent[b as usize] = a;
        self.parent[a as usize] = ROOT | (size_a + size_b);
        self.class_count -= 1;
        true
    }

    /// Whether two members are in one class.
    ///
    /// # Examples
    /// ```
    /// let mut partition = coface_algebra::UnionFind::new(3);
    /// partition.unite(0, 2);
    /// assert!(partition.same(2, 0) && !partition.same(0, 1));
    /// ```
    pub fn same(&mut self, a: u32, b: u32) -> bool {
        self.find(a) == self.find(b)
    }

    /// The number of the class of each member; classes are numbered in the order of their first members.
    ///
    /// # Examples
    /// ```
    /// let mut partition = coface_algebra::UnionFind::new(4);
    /// partition.unite(0, 2);
    /// assert_eq!(partition.class_numbers(), [0, 1, 0, 2]);
    /// ```
    pub fn class_numbers(&mut self) -> Vec<u32> {
        // Numbers are below 2^31, so this one is free.
        const UNNUMBERED: u32 = u32::MAX;
        let mut number_of_root = vec![UNNUMBERED; self.len()];
        let mut next = 0;
        (0..narrow(self.len()))
            .map(|member| {
                let number = &mut number_of_root[self.find(member) as usize];
                if *number == UNNUMBERED {
                    *number = next;
                    next += 1;
                }
                *number
            })
            .collect()
    }
}

/// A partition of `0..n` in which each member also has a sign relative to its class.
///
/// Uniting two members with a relative sign either joins two classes, agrees with what is known, or contradicts it:
/// the test for a consistent orientation.
///
/// # Examples
/// Three members that all are to differ from each other in sign contradict each other:
/// ```
/// use coface_algebra::{ParityUnion, ParityUnionFind, Sign};
/// let mut partition = ParityUnionFind::new(3);
/// assert_eq!(partition.unite(0, 1, Sign::Minus), ParityUnion::Joined);
/// assert_eq!(partition.unite(1, 2, Sign::Minus), ParityUnion::Joined);
/// assert_eq!(partition.unite(2, 0, Sign::Minus), ParityUnion::Contradicts);
/// ```
#[derive(Clone, Debug)]
pub struct ParityUnionFind {
    /// The parent shifted left by one, and in the lowest bit the parity to it; a root is its own parent.
    link: Vec<u32>,
    rank: Vec<u8>,
    class_count: usize,
}

/// What [`ParityUnionFind::unite`] found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParityUnion {
    /// Two classes became one.
    Joined,
    /// The members were in one class with this relative sign.
    Agrees,
    /// The members were in one class with the other relative sign.
    Contradicts,
}

impl ParityUnionFind {
    /// The partition of `0..count` into single members of sign plus.
    ///
    /// # Panics
    /// From 2^31 members on.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::ParityUnionFind::new(3).class_count(), 3);
    /// ```
    pub fn new(count: usize) -> Self {
        assert!(count < ROOT as usize, "a union-find holds fewer than 2^31 members");
        Self { link: (0..narrow(count)).map(|i| i << 1).collect(), rank: vec![0; count], class_count: count }
    }

    /// The number of classes.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{ParityUnionFind, Sign};
    /// let mut partition = ParityUnionFind::new(3);
    /// partition.unite(0, 1, Sign::Minus);
    /// assert_eq!(partition.class_count(), 2);
    /// ```
    pub fn class_count(&self) -> usize {
        self.class_count
    }

    /// The representative of the class of `member` and the sign of `member` relative to it.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{ParityUnionFind, Sign};
    /// let mut partition = ParityUnionFind::new(2);
    /// partition.unite(0, 1, Sign::Minus);
    /// let ((root, sign), (other, opposite)) = (partition.find(0), partition.find(1));
    /// assert_eq!((root, sign), (other, opposite.opposite()));
    /// ```
    pub fn find(&mut self, member: u32) -> (u32, Sign) {
        let (root, parity) = self.find_parity(member);
        (root, Sign::power_of_minus_one(parity as usize))
    }

    fn find_parity(&mut self, member: u32) -> (u32, u32) {
        let (mut at, mut parity) = (member, 0);
        loop {
            let link = self.link[at as usize];
            let parent = link >> 1;
            if parent == at {
                return (at, parity);
            }
            let above = self.link[parent as usize];
            // Halving: hang the member below its grandparent; for a root `above` is the root itself with parity 0.
            self.link[at as usize] = above ^ (link & 1);
            parity ^= link & 1;
            parity ^= above & 1;
            at = above >> 1;
        }
    }

    /// States that `a` has the sign `relative` to `b`.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{ParityUnion, ParityUnionFind, Sign};
    /// let mut partition = ParityUnionFind::new(2);
    /// assert_eq!(partition.unite(0, 1, Sign::Minus), ParityUnion::Joined);
    /// assert_eq!(partition.unite(1, 0, Sign::Minus), ParityUnion::Agrees);
    /// assert_eq!(partition.unite(1, 0, Sign::Plus), ParityUnion::Contradicts);
    /// ```
    pub fn unite(&mut self, a: u32, b: u32, relative: Sign) -> ParityUnion {
        let ((mut root_a, parity_a), (mut root_b, parity_b)) = (self.find_parity(a), self.find_parity(b));
        let parity = parity_a ^ parity_b ^ u32::from(relative == Sign::Minus);
        if root_a == root_b {
            return if parity == 0 { ParityUnion::Agrees } else { ParityUnion::Contradicts };
        }
        if self.rank[root_a as usize] < self.rank[root_b as usize] {
            std::mem::swap(&mut root_a, &mut root_b);
        }
        if self.rank[root_a as usize] == self.rank[root_b as usize] {
            self.rank[root_a as usize] += 1;
        }
        self.link[root_b as usize] = (root_a << 1) | parity;
        self.class_count -= 1;
        ParityUnion::Joined
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn an_odd_cycle_contradicts() {
        let mut signs = ParityUnionFind::new(3);
        assert_eq!(signs.unite(0, 1, Sign::Minus), ParityUnion::Joined);
        assert_eq!(signs.unite(1, 2, Sign::Minus), ParityUnion::Joined);
        assert_eq!(signs.unite(0, 2, Sign::Plus), ParityUnion::Agrees);
        assert_eq!(signs.unite(0, 2, Sign::Minus), ParityUnion::Contradicts);
        assert_eq!(signs.class_count(), 1);
    }

    proptest! {
        #[test]
        fn classes_are_the_components(edges in prop::collection::vec((0u32..30, 0u32..30), 0..40)) {
            let mut partition = UnionFind::new(30);
            // The second method: relaxing labels until nothing changes.
            let mut label: Vec<u32> = (0..30).collect();
            for &(a, b) in &edges {
                partition.unite(a, b);
            }
            for _ in 0..30 {
                for &(a, b) in &edges {
                    let least = label[a as usize].min(label[b as usize]);
                    label[a as usize] = least;
                    label[b as usize] = least;
                }
            }
            let mut distinct = label.clone();
            distinct.sort_unstable();
            distinct.dedup();
            prop_assert_eq!(partition.class_count(), distinct.len());
            let numbers = partition.class_numbers();
            for a in 0..30 {
                for b in 0..30 {
                    prop_assert_eq!(numbers[a] == numbers[b], label[a] == label[b]);
                }
            }
        }

        #[test]
        fn parities_follow_a_two_coloring(
            colors in prop::collection::vec(any::<bool>(), 20),
            edges in prop::collection::vec((0u32..20, 0u32..20), 0..40),
        ) {
            let mut signs = ParityUnionFind::new(20);
            for &(a, b) in &edges {
                let relative = if colors[a as usize] == colors[b as usize] { Sign::Plus } else { Sign::Minus };
                prop_assert_ne!(signs.unite(a, b, relative), ParityUnion::Contradicts);
            }
            for &(a, b) in &edges {
                let ((root_a, sign_a), (root_b, sign_b)) = (signs.find(a), signs.find(b));
                prop_assert_eq!(root_a, root_b);
                prop_assert_eq!(sign_a == sign_b, colors[a as usize] == colors[b as usize]);
            }
        }
    }
}
