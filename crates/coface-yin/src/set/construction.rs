//! Yin sets from curves, with the check that they are its boundary.

use super::{CurveArena, HasseForest, YinFault, YinSet};
use crate::boolean::{combine_rings, curved_jordan_rings, linear_overlay};
use crate::{Curve, Order};
use coface_algebra::Error;
use coface_algebra::RaggedArray;
use coface_arrange::boolean::InsideRule;
use coface_arrange::planar::{JordanFault, JordanRings};

/// How the curves of a valid set lie.
pub(crate) struct Lying {
    pub(crate) parents: Vec<Option<u32>>,
    pub(crate) is_positive: Vec<bool>,
    /// The curves through each point that more than one comes to.
    pub(crate) touching: RaggedArray,
}

impl YinSet {
    /// The set that closed curves bound, the set on their left. Curves keep their order and the knots they begin at; those of lower
    /// orders are raised to the highest.
    ///
    /// The curves have to be Jordan curves and almost disjoint; positive and negative ones have to alternate by depth, and those in no
    /// other have to have one sign. Of polylines that is decided exactly.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) with the witness that [`Self::fault`] gives, or if there are no
    /// curves.
    ///
    /// # Complexity
    /// That of an overlay of the curves.
    ///
    /// # Examples
    /// A square with a hole.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let outer = Curve::polyline(&[[0., 0.], [4., 0.], [4., 4.], [0., 4.], [0., 0.]])?;
    /// let hole = Curve::polyline(&[[1., 1.], [1., 2.], [2., 2.], [2., 1.], [1., 1.]])?;
    /// let set = YinSet::new(&[outer, hole])?;
    /// assert_eq!(set.forest().parent(1), Some(0));
    /// assert_eq!(set.area(), Some(15.0));
    /// # Ok(()) }
    /// ```
    pub fn new(curves: &[Curve<'_>]) -> Result<Self, Error> {
        let arena = some_arena_of(curves)?;
        match lying(&arena)? {
            Ok(lying) => {
                let is_unbounded = !lying.is_positive[root(&lying.parents)];
                Ok(Self::from_parts(arena, is_unbounded, lying.parents, Vec::new()))
            }
            Err(fault) => Err(fault.into_error()),
        }
    }

    /// The bounded set that closed curves bound whatever way they run: a curve in no other is turned counterclockwise, and one in
    /// others against the one around it. Curves keep their order and the knots they begin at.
    ///
    /// # Errors
    /// As [`Self::new`], but for the ways that curves run.
    ///
    /// # Complexity
    /// As [`Self::new`].
    ///
    /// # Examples
    /// A square with a hole; both curves run clockwise.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let outer = Curve::polyline(&[[0., 0.], [0., 4.], [4., 4.], [4., 0.], [0., 0.]])?;
    /// let hole = Curve::polyline(&[[1., 1.], [1., 2.], [2., 2.], [2., 1.], [1., 1.]])?;
    /// assert_eq!(YinSet::oriented(&[outer, hole])?.area(), Some(15.0));
    /// # Ok(()) }
    /// ```
    pub fn oriented(curves: &[Curve<'_>]) -> Result<Self, Error> {
        let arena = some_arena_of(curves)?;
        let Lying { parents, is_positive, .. } = match lying_apart(&arena)? {
            Ok(lying) => lying,
            Err(fault) => return Err(fault.into_error()),
        };
        let forest = HasseForest::new(parents.clone());
        let turned: Vec<Curve<'static>> = curves
            .iter()
            .enumerate()
            .map(|(at, curve)| match is_positive[at] == forest.depth(at).is_multiple_of(2) {
                true => curve.clone().into_owned(),
                false => curve.reversed(),
            })
            .collect();
        // Which way curves run changes nothing of how they lie.
        Ok(Self::from_parts(some_arena_of(&turned)?, false, parents, Vec::new()))
    }

    /// Why curves are not the boundary of a Yin set; none if they are.
    ///
    /// # Errors
    /// If the curves cannot be laid over each other.
    ///
    /// # Complexity
    /// As [`Self::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let bow = Curve::polyline(&[[0., 0.], [2., 2.], [2., 0.], [0., 2.], [0., 0.]])?;
    /// assert!(YinSet::fault(&[bow])?.is_some());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn fault(curves: &[Curve<'_>]) -> Result<Option<YinFault>, Error> {
        Ok(match arena_of(curves)? {
            Ok(arena) => lying(&arena)?.err(),
            Err(fault) => Some(fault),
        })
    }

    /// Whether the curves of the set are its boundary, exactly as they are: a fault if they are not. Rounding of a crossing can make
    /// the result of a Boolean combination touch or cross itself by the last digit; [`Self::normalized`] repairs that.
    ///
    /// # Errors
    /// If the curves cannot be laid over each other.
    ///
    /// # Complexity
    /// As [`Self::new`].
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert!(ring.validate()?.is_none());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn validate(&self) -> Result<Option<YinFault>, Error> {
        if self.curve_count() == 0 {
            return Ok(None);
        }
        if let Some(fault) = first_degenerate(self.arena()) {
            return Ok(Some(fault));
        }
        Ok(match lying(self.arena())? {
            Err(fault) => Some(fault),
            Ok(lying) => {
                let first = root(&lying.parents);
                debug_assert!(lying.parents.len() == self.curve_count());
                // A set that is bounded has positive roots.
                (lying.is_positive[first] != self.is_bounded())
                    .then_some(YinFault::MixedRoots { curves: [first; 2] })
            }
        })
    }

    /// The set that closed rings of points bound by a fill rule: what they wind around that often is inside. Rings may cross and touch
    /// themselves and each other and overlap; the first point of a ring may come again as its last. Corners where the boundary of
    /// the set passes from one side of the rings to another are kinks.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for coordinates that are not finite.
    ///
    /// # Complexity
    /// That of an overlay of the rings.
    ///
    /// # Examples
    /// A pentagram: what it winds around twice is inside by one rule and outside by the other.
    /// ```
    /// use coface_arrange::boolean::InsideRule;
    /// use coface_yin::YinSet;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let star = [[0., 3.], [2., -3.], [-3., 1.], [3., 1.], [-2., -3.]];
    /// assert_eq!(YinSet::from_rings(&[star], InsideRule::Nonzero)?.curve_counts(), [1, 0]);
    /// assert_eq!(YinSet::from_rings(&[star], InsideRule::Odd)?.curve_counts(), [5, 0]);
    /// # Ok(()) }
    /// ```
    pub fn from_rings<R: AsRef<[[f64; 2]]>>(rings: &[R], rule: InsideRule) -> Result<Self, Error> {
        for (ring, points) in rings.iter().enumerate() {
            let points = points.as_ref();
            if let Some(at) = points.iter().position(|point| point.iter().any(|x| !x.is_finite())) {
                return Err(Error::invalid(format!("point {at} of ring {ring} is not finite"))
                    .with_cure("give finite coordinates"));
            }
        }
        let mut flat = Vec::new();
        let mut starts = vec![0u32];
        for ring in rings {
            flat.extend_from_slice(ring.as_ref().as_flattened());
            starts.push((flat.len() / 2) as u32);
        }
        let lists = RaggedArray::from_parts(starts, (0..flat.len() as u32 / 2).collect())?;
        combine_rings(flat, &lists, rule)
    }
}

/// A curve that lies in no other.
fn root(parents: &[Option<u32>]) -> usize {
    parents.iter().position(Option::is_none).expect("one of finitely many curves lies in no other")
}

/// The curves of one order.
///
/// # Errors
/// If there is none, or one bounds nothing.
fn some_arena_of(curves: &[Curve<'_>]) -> Result<CurveArena, Error> {
    if curves.is_empty() {
        return Err(Error::invalid("no curves: the empty set and the plane both have none")
            .with_cure("take the empty set or the plane"));
    }
    arena_of(curves)?.map_err(YinFault::into_error)
}

/// The curves of one order, or what is wrong with one of them.
fn arena_of(curves: &[Curve<'_>]) -> Result<Result<CurveArena, YinFault>, Error> {
    let order = curves.iter().map(Curve::order).max().unwrap_or(Order::LINEAR);
    if let Some(curve) = curves.iter().position(|curve| !curve.is_closed()) {
        return Ok(Err(YinFault::Open { curve }));
    }
    let mut arena = CurveArena::new(order);
    for curve in curves {
        arena.push(&curve.raised(order)?);
    }
    Ok(first_degenerate(&arena).map_or(Ok(arena), Err))
}

/// The first curve that bounds nothing, or piece without length.
fn first_degenerate(arena: &CurveArena) -> Option<YinFault> {
    let degree = arena.order().degree();
    arena.iter().enumerate().find_map(|(number, curve)| {
        let is_point =
            |piece: &usize| curve.piece(*piece).iter().all(|point| *point == curve.piece(*piece)[0]);
        match (0..curve.piece_count()).find(is_point) {
            Some(piece) => Some(YinFault::ZeroLength { curve: number, piece }),
            None if degree == 1 && curve.piece_count() < 3 => Some(YinFault::TooFewPieces { curve: number }),
            None => None,
        }
    })
}

/// How closed curves without degenerate pieces lie, or why they bound no Yin set.
pub(crate) fn lying(arena: &CurveArena) -> Result<Result<Lying, YinFault>, Error> {
    Ok(lying_apart(arena)?.and_then(|found| match alternation(&found.parents, &found.is_positive) {
        None => Ok(found),
        Some(fault) => Err(fault),
    }))
}

/// How closed curves without degenerate pieces lie, whatever way they run, or why they are not almost disjoint Jordan curves.
fn lying_apart(arena: &CurveArena) -> Result<Result<Lying, YinFault>, Error> {
    let rings = match arena.order() {
        Order::LINEAR => linear_overlay(&[arena])?.jordan_rings(),
        _ => curved_jordan_rings(arena)?,
    };
    let lying = |rings: JordanRings| {
        let (parents, is_positive, touching) = rings.into_parts();
        Lying { parents, is_positive, touching }
    };
    Ok(rings.map(lying).map_err(named))
}

/// Where positive and negative curves do not alternate.
pub(crate) fn alternation(parents: &[Option<u32>], is_positive: &[bool]) -> Option<YinFault> {
    let first = parents.iter().position(Option::is_none)?;
    (0..parents.len()).find_map(|curve| match parents[curve].map(|parent| parent as usize) {
        Some(parent) => {
            (is_positive[parent] == is_positive[curve]).then_some(YinFault::Orientation { curve, parent })
        }
        None => (is_positive[first] != is_positive[curve])
            .then_some(YinFault::MixedRoots { curves: [first, curve] }),
    })
}

fn named(fault: JordanFault) -> YinFault {
    match fault {
        JordanFault::Overlap { rings, ends } => {
            YinFault::Overlap { curves: rings.map(|ring| ring as usize), ends }
        }
        JordanFault::SelfMeeting { ring, point } => YinFault::SelfMeeting { curve: ring as usize, point },
        JordanFault::Crossing { rings, point } => {
            YinFault::Crossing { curves: rings.map(|ring| ring as usize), point }
        }
    }
}
