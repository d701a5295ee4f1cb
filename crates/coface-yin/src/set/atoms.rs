//! The connected parts of a Yin set, and its Betti numbers.

use super::YinSet;
use coface_algebra::Error;
use coface_algebra::{RaggedArray, UnionFind};

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// What sort of region an atom has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AtomKind {
    /// One positive curve with what is cut out of it.
    Plus,
    /// The plane without what negative curves cut out of it.
    Minus,
}

/// An atom spadjor: the curves around one connected component of a Yin set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Atom {
    kind: AtomKind,
    curves: Vec<u32>,
}

impl Atom {
    /// Whether the region is bounded or reaches to infinity.
    pub fn kind(&self) -> AtomKind {
        self.kind
    }

    /// The curves; the positive one comes first, if there is one.
    pub fn curves(&self) -> impl ExactSizeIterator<Item = usize> + '_ {
        self.curves.iter().map(|&curve| curve as usize)
    }

    /// The number of negative curves.
    pub fn hole_count(&self) -> usize {
        self.curves.len() - usize::from(self.kind == AtomKind::Plus)
    }
}

impl YinSet {
    /// Whether a curve runs counterclockwise: by its depth in the forest and whether the set is bounded.
    ///
    /// # Panics
    /// If there is no such curve.
    pub fn is_positive(&self, curve: usize) -> bool {
        self.forest().depth(curve).is_multiple_of(2) == self.is_bounded()
    }

    /// The atoms of the realizable spadjor of the set: one for each connected component. The one that reaches to infinity comes
    /// first, the others in the order of their positive curves. The empty set has none; neither has the plane, which has no curves.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{AtomKind, Curve, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let hole = Curve::polyline(&[[0., 0.], [0., 4.], [4., 4.], [4., 0.], [0., 0.]])?;
    /// let island = Curve::polyline(&[[1., 1.], [2., 1.], [2., 2.], [1., 2.], [1., 1.]])?;
    /// let set = YinSet::new(&[hole, island])?;
    /// let atoms = set.atoms();
    /// assert_eq!((atoms[0].kind(), atoms[1].kind()), (AtomKind::Minus, AtomKind::Plus));
    /// # Ok(()) }
    /// ```
    pub fn atoms(&self) -> Vec<Atom> {
        let numbers = self.atom_of_curves();
        let count = numbers.iter().max().map_or(0, |&last| last as usize + 1);
        let lists = RaggedArray::grouped(count, numbers.iter().copied());
        let mut atoms: Vec<Atom> = lists
            .iter()
            .map(|list| {
                let mut curves = list.to_vec();
                let outer = curves.iter().position(|&curve| self.is_positive(curve as usize));
                if let Some(at) = outer {
                    curves[..=at].rotate_right(1);
                }
                Atom { kind: if outer.is_some() { AtomKind::Plus } else { AtomKind::Minus }, curves }
            })
            .collect();
        atoms.sort_by_key(|atom| (atom.kind == AtomKind::Plus).then(|| atom.curves[0]));
        atoms
    }

    /// For each curve the number of the atom that it bounds.
    fn atom_of_curves(&self) -> Vec<u32> {
        let mut number_of_outer = vec![NONE; self.curve_count()];
        let first = u32::from(!self.is_bounded());
        for (number, curve) in (first..).zip((0..self.curve_count()).filter(|&c| self.is_positive(c))) {
            number_of_outer[curve] = number;
        }
        (0..self.curve_count())
            .map(|curve| {
                if self.is_positive(curve) {
                    number_of_outer[curve]
                } else {
                    self.forest().parent(curve).map_or(0, |parent| number_of_outer[parent])
                }
            })
            .collect()
    }

    /// The numbers of positive and of negative curves, where the plane outside of all counts as one more positive curve: what the
    /// literature on Yin sets gives as Betti numbers. They are those of the set if no curves of one component touch.
    ///
    /// # References
    /// Q. Zhang, Z. Li, *Boolean algebra of two-dimensional continua with arbitrarily complex topology* (2020).
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert_eq!(ring.curve_counts(), [1, 1]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn curve_counts(&self) -> [usize; 2] {
        let positive = (0..self.curve_count()).filter(|&curve| self.is_positive(curve)).count();
        [positive + usize::from(!self.is_bounded()), self.curve_count() - positive]
    }

    /// The number of connected components of the set: parts that touch in points only are different ones.
    ///
    /// # Errors
    /// If the curves cannot be laid over each other.
    ///
    /// # Complexity
    /// That of an overlay of the curves.
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert_eq!(ring.component_count()?, 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn component_count(&self) -> Result<usize, Error> {
        Ok(self.betti_open()?[0])
    }

    /// Whether the set is connected; the empty set is not.
    ///
    /// # Errors
    /// If the curves cannot be laid over each other.
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert!(ring.is_connected()?);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn is_connected(&self) -> Result<bool, Error> {
        Ok(self.component_count()? == 1)
    }

    /// The Betti numbers of degree 0 and 1 of the set, which is open.
    ///
    /// Let curves of one atom be joined where they touch. What lies outside of an atom is then, up to homotopy, the graph of its curves and
    /// of the points in which they touch. By Alexander duality an atom with an outer curve has one independent cycle less than the graph has
    /// components, and one without has as many; and the atom falls into one part more than the graph has independent cycles.
    ///
    /// # Errors
    /// If the curves cannot be laid over each other.
    ///
    /// # Complexity
    /// That of an overlay of the curves.
    ///
    /// # Examples
    /// A triangle that touches the square it is cut out of: around the hole no way leads.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = Curve::polyline(&[[0., 0.], [4., 0.], [4., 4.], [0., 4.], [0., 0.]])?;
    /// let hole = Curve::polyline(&[[2., 0.], [1., 1.], [3., 1.], [2., 0.]])?;
    /// let set = YinSet::new(&[square, hole])?;
    /// assert_eq!((set.curve_counts(), set.betti_open()?, set.betti_closed()?), ([1, 1], [1, 0], [1, 1]));
    /// # Ok(()) }
    /// ```
    pub fn betti_open(&self) -> Result<[usize; 2], Error> {
        let atoms = self.atom_of_curves();
        let mut classes = UnionFind::new(self.curve_count());
        let mut circle_count = 0;
        for curves in self.touching_curves()?.iter() {
            // Curves of several atoms may touch in one point.
            for (at, &curve) in curves.iter().enumerate() {
                let other =
                    curves[..at].iter().find(|&&other| atoms[other as usize] == atoms[curve as usize]);
                if let Some(&other) = other {
                    // Curves that are joined already close a circle in this point.
                    circle_count += usize::from(!classes.unite(curve, other));
                }
            }
        }
        let [atom_count, negative] = self.curve_counts();
        // Each class but that of an outer curve has an independent cycle.
        Ok([atom_count + circle_count, negative + classes.class_count() - self.curve_count()])
    }

    /// The Betti numbers of degree 0 and 1 of the closure of the set.
    ///
    /// Atoms that touch are one component; by Alexander duality there are as many independent cycles as the complement has bounded
    /// components.
    ///
    /// # Errors
    /// If the curves cannot be laid over each other.
    ///
    /// # Complexity
    /// That of some overlays of the curves.
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert_eq!(ring.betti_closed()?, [1, 1]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn betti_closed(&self) -> Result<[usize; 2], Error> {
        let [atom_count, _] = self.curve_counts();
        let atoms = self.atom_of_curves();
        let mut classes = UnionFind::new(atom_count);
        for curves in self.touching_curves()?.iter() {
            curves.windows(2).for_each(|pair| {
                classes.unite(atoms[pair[0] as usize], atoms[pair[1] as usize]);
            });
        }
        let outside = self.complement()?;
        let bounded = outside.component_count()? - usize::from(!outside.is_bounded());
        Ok([classes.class_count(), bounded])
    }

    /// The curves that come to one point, for each point that several come to.
    ///
    /// # Errors
    /// If the curves are no boundary, which rounding can bring about.
    fn touching_curves(&self) -> Result<RaggedArray, Error> {
        if self.curve_count() < 2 {
            return Ok(RaggedArray::new());
        }
        match super::construction::lying(self.arena())? {
            Ok(lying) => Ok(lying.touching),
            Err(fault) => Err(fault.into_error().with_cure("normalize the set first")),
        }
    }
}
