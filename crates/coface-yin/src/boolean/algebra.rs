//! Complement, meet and join of Yin sets, and what is made of them.

use super::Combination;
use super::curved::{Regions, combine_curved};
use super::linear::{Membership, combine_linear, linear_overlay};
use crate::{Order, YinSet};
use coface_algebra::Error;
use coface_arrange::boolean::BooleanFormula;

impl YinSet {
    /// A Boolean combination of sets, with where its boundary comes from. Operand i of the formula is set i: `a & b` is the meet,
    /// `a | b` the join, `!a` the complement, `a - b` the difference, `a ^ b` the symmetric difference.
    ///
    /// On sets of order 2 the combinatorial result is exact: which curves there are, how they lie and touch. Coordinates of crossings
    /// are rounded once, each to the nearest floating-point number. Rounding may make a result touch or cross itself by the last
    /// digit: [`Self::validate`] detects it, and [`Self::normalized`] repairs it.
    ///
    /// The result is in [canonical form](Self::canonical). A knot of it is a kink where pieces of different curves come together, or
    /// pieces of one that are no neighbors on it, and where an operand has a kink.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if the formula names a set that is not there;
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) beyond 2^31 pieces.
    ///
    /// # Complexity
    /// $O(n + k \log k)$ for n pieces that meet k times, and the search for pairs of pieces that come near each other; and the length
    /// of the formula times the number of faces.
    ///
    /// # References
    /// Q. Zhang, Z. Li, *Boolean algebra of two-dimensional continua with arbitrarily complex topology* (2020), for the algebra and
    /// for cutting and pasting; the overlay is our own.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// use coface_yin::{Curve, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = |x: f64| {
    ///     YinSet::new(&[Curve::polyline(&[[x, 0.], [x + 2., 0.], [x + 2., 2.], [x, 2.], [x, 0.]])?])
    /// };
    /// let (a, b) = (square(0.0)?, square(1.0)?);
    /// let either = YinSet::combine(&[&a, &b], &BooleanFormula::parse("a ^ b", &[])?)?;
    /// assert_eq!((either.set().curve_counts(), either.set().area()), ([2, 0], Some(4.0)));
    /// // The first piece is the part of the lower side of a that b does not share.
    /// let first = either.sources()[0];
    /// assert_eq!((first.operand, first.piece, first.range), (0, 0, [0.0, 0.5]));
    /// # Ok(()) }
    /// ```
    pub fn combine(sets: &[&Self], formula: &BooleanFormula) -> Result<Combination, Error> {
        if formula.input_count() > sets.len() {
            return Err(Error::invalid(format!(
                "the formula names set {}; there are {}",
                formula.input_count() - 1,
                sets.len()
            ))
            .with_cure("give all sets that the formula names, counted from 0"));
        }
        let membership = Membership::new(sets);
        select(sets, |windings| formula.evaluate(|set| membership.is_inside(set, windings)))
    }

    /// The regularized complement: the exterior of the set.
    ///
    /// Curves are reversed, and where they touch cut and pasted.
    ///
    /// # Errors
    /// As [`Self::combine`].
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert!(YinSet::empty(Order::LINEAR).complement()?.is_plane());
    /// # Ok(()) }
    /// ```
    pub fn complement(&self) -> Result<Self, Error> {
        let sets = [self];
        let membership = Membership::new(&sets);
        select(&sets, |windings| !membership.is_inside(0, windings)).map(Combination::into_set)
    }

    /// The intersection.
    ///
    /// # Errors
    /// As [`Self::combine`].
    ///
    /// # Examples
    /// Two squares of side 2 that share half of their area.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// let (a, b) = (YinSet::new(&[square.translated([1.0, 0.0])])?, YinSet::new(&[square])?);
    /// assert_eq!(a.meet(&b)?.area(), Some(2.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn meet(&self, other: &Self) -> Result<Self, Error> {
        Self::meet_all(&[self, other])
    }

    /// The regularized union: the inside of the closure of both together.
    ///
    /// # Errors
    /// As [`Self::combine`].
    ///
    /// # Examples
    /// Two squares of side 2 that share half of their area.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// let (a, b) = (YinSet::new(&[square.translated([1.0, 0.0])])?, YinSet::new(&[square])?);
    /// assert_eq!(a.join(&b)?.area(), Some(6.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn join(&self, other: &Self) -> Result<Self, Error> {
        Self::join_all(&[self, other])
    }

    /// What is in this set and outside of the other.
    ///
    /// # Errors
    /// As [`Self::combine`].
    ///
    /// # Examples
    /// Two squares of side 2 that share half of their area.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// let (a, b) = (YinSet::new(&[square.translated([1.0, 0.0])])?, YinSet::new(&[square])?);
    /// assert_eq!(a.difference(&b)?.area(), Some(2.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn difference(&self, other: &Self) -> Result<Self, Error> {
        Self::combine(&[self, other], &BooleanFormula::difference(2)).map(Combination::into_set)
    }

    /// What is in one set and outside of the other.
    ///
    /// # Errors
    /// As [`Self::combine`].
    ///
    /// # Examples
    /// Two squares of side 2 that share half of their area.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// let (a, b) = (YinSet::new(&[square.translated([1.0, 0.0])])?, YinSet::new(&[square])?);
    /// assert_eq!(a.symmetric_difference(&b)?.area(), Some(4.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn symmetric_difference(&self, other: &Self) -> Result<Self, Error> {
        Self::combine(&[self, other], &BooleanFormula::xor(2)).map(Combination::into_set)
    }

    /// The intersection of many sets; of none the plane.
    ///
    /// # Errors
    /// As [`Self::combine`].
    ///
    /// # Complexity
    /// As [`Self::combine`], but faces cost only as much as curves wind around them.
    ///
    /// # Examples
    /// Two squares of side 2 that share half of their area.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// let (a, b) = (YinSet::new(&[square.translated([1.0, 0.0])])?, YinSet::new(&[square])?);
    /// assert_eq!(YinSet::meet_all(&[&a, &b])?.area(), Some(2.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn meet_all(sets: &[&Self]) -> Result<Self, Error> {
        let membership = Membership::new(sets);
        let unbounded = sets.iter().filter(|set| !set.is_bounded()).count();
        select(sets, |windings| membership.count(unbounded, windings) == sets.len())
            .map(Combination::into_set)
    }

    /// The regularized union of many sets; of none the empty set.
    ///
    /// # Errors
    /// As [`Self::combine`].
    ///
    /// # Complexity
    /// As [`Self::meet_all`].
    ///
    /// # Examples
    /// Two squares of side 2 that share half of their area.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// let (a, b) = (YinSet::new(&[square.translated([1.0, 0.0])])?, YinSet::new(&[square])?);
    /// assert_eq!(YinSet::join_all(&[&a, &b])?.area(), Some(6.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn join_all(sets: &[&Self]) -> Result<Self, Error> {
        let membership = Membership::new(sets);
        let unbounded = sets.iter().filter(|set| !set.is_bounded()).count();
        select(sets, |windings| membership.count(unbounded, windings) > 0).map(Combination::into_set)
    }

    /// Whether all points of this set are in another. Of sets of order 2 that is decided exactly.
    ///
    /// # Errors
    /// As [`Self::combine`].
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let [empty, plane] = [YinSet::empty(Order::LINEAR), YinSet::plane(Order::LINEAR)];
    /// assert!(empty.is_subset_of(&plane)? && !plane.is_subset_of(&empty)?);
    /// # Ok(()) }
    /// ```
    pub fn is_subset_of(&self, other: &Self) -> Result<bool, Error> {
        Ok(!Self::has_points(&[self, other], |inside| inside(0) && !inside(1))?)
    }

    /// Whether both sets have the same points, whatever their knots are.
    ///
    /// # Errors
    /// As [`Self::combine`].
    ///
    /// # Examples
    /// Two squares of side 2 that share half of their area.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// let (a, b) = (YinSet::new(&[square.translated([1.0, 0.0])])?, YinSet::new(&[square])?);
    /// assert!(a.join(&b)?.has_points_of(&b.join(&a)?)? && !a.has_points_of(&b)?);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn has_points_of(&self, other: &Self) -> Result<bool, Error> {
        Ok(!Self::has_points(&[self, other], |inside| inside(0) != inside(1))?)
    }

    /// Whether some points lie in sets that satisfy a condition.
    fn has_points(sets: &[&Self], condition: impl Fn(&dyn Fn(usize) -> bool) -> bool) -> Result<bool, Error> {
        let membership = Membership::new(sets);
        let is_wanted = |windings: &[(u32, i32)]| condition(&|set| membership.is_inside(set, windings));
        if order_of(sets) == Order::LINEAR {
            let arenas: Vec<_> = sets.iter().map(|set| set.arena()).collect();
            return Ok(linear_overlay(&arenas)?.has_face_where(is_wanted));
        }
        Ok(!select(sets, is_wanted)?.set().is_empty())
    }

    /// The set with curves that are its exact boundary, for sets whose curves touch or cross by rounding.
    ///
    /// Where [`Self::validate`] finds a fault, the curves are laid over each other, and what they wind around is selected and rounded
    /// again, until there is no fault. Coordinates of knots that stay do not change.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if that does not come to an end within a hundred rounds.
    ///
    /// # Complexity
    /// That of an overlay for each round; most sets need one, which finds nothing to do.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// assert_eq!(square.normalized()?.round_count(), 0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn normalized(&self) -> Result<Normalized, Error> {
        const MOST_ROUNDS: usize = 100;
        let mut set = self.clone();
        for round_count in 0..=MOST_ROUNDS {
            if set.validate()?.is_none() {
                return Ok(Normalized { set, round_count });
            }
            set = Self::join_all(&[&set])?;
        }
        Err(Error::invalid(format!(
            "rounding makes curves meet again and again: {MOST_ROUNDS} rounds are not enough"
        ))
        .with_cure("scale the set up, or remove curves that nearly coincide"))
    }
}

/// A set whose curves are its exact boundary.
#[derive(Clone, Debug)]
pub struct Normalized {
    set: YinSet,
    round_count: usize,
}

impl Normalized {
    /// The set.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// assert_eq!(square.normalized()?.set(), &square);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn set(&self) -> &YinSet {
        &self.set
    }

    /// The set alone.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// assert_eq!(square.normalized()?.into_set(), square);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn into_set(self) -> YinSet {
        self.set
    }

    /// How often curves were cut and rounded; 0 for sets that were valid.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// assert_eq!(square.normalized()?.round_count(), 0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn round_count(&self) -> usize {
        self.round_count
    }
}

fn order_of(sets: &[&YinSet]) -> Order {
    sets.iter().map(|set| set.order()).max().unwrap_or(Order::LINEAR)
}

/// The set of all points around which the curves of sets wind in a way that satisfies a condition.
fn select(sets: &[&YinSet], condition: impl Fn(&[(u32, i32)]) -> bool) -> Result<Combination, Error> {
    match order_of(sets) {
        Order::LINEAR => combine_linear(sets, condition).map(|found| found.with_area_error(sets)),
        _ => combine_curved(sets, Regions::Sets, condition),
    }
}
