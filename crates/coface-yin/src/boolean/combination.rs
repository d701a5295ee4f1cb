//! What a Boolean combination gives: the set, and where its boundary comes from.

use crate::YinSet;
use crate::curve::distance;

/// The part of an operand that a piece of a result is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PieceSource {
    /// The operand, counted from 0.
    pub operand: u32,
    /// The curve of the operand.
    pub curve: u32,
    /// The piece of that curve.
    pub piece: u32,
    /// The parameters in `[0, 1]` on that piece at which the piece of the result begins and ends. They fall where the result runs
    /// against its source. A piece of the result that runs along several pieces in a row has the range on one of them.
    pub range: [f64; 2],
}

/// What was taken to be equal without proof.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Assumption {
    /// Two points are one.
    SamePoint,
    /// Two arcs are one.
    SameArc,
    /// Two arcs leave a point in this order.
    ArcOrder,
    /// A curve is smaller than the resolution and is a point.
    SmallCurve,
}

/// A decision below the resolution of curves of order 4 and more.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UncertifiedDecision {
    pub(crate) point: [f64; 2],
    pub(crate) pieces: [PieceSource; 2],
    pub(crate) assumption: Assumption,
    /// The area that curves are off by where their ends were moved.
    pub(crate) misplaced: f64,
}

impl UncertifiedDecision {
    /// Where.
    pub fn point(&self) -> [f64; 2] {
        self.point
    }

    /// The pieces that are so close, with the parts that the decision is about.
    pub fn pieces(&self) -> [PieceSource; 2] {
        self.pieces
    }

    /// What was taken to be so.
    pub fn assumption(&self) -> Assumption {
        self.assumption
    }
}

/// A Boolean combination of Yin sets.
#[derive(Clone, Debug)]
pub struct Combination {
    pub(crate) set: YinSet,
    /// For the pieces of all curves of the result, one after the other.
    pub(crate) sources: Vec<PieceSource>,
    /// Further sources of pieces, by rising pieces.
    pub(crate) other_sources: Vec<(u32, PieceSource)>,
    pub(crate) collapsed_count: usize,
    pub(crate) repair_count: usize,
    pub(crate) resolution: f64,
    pub(crate) report: Vec<UncertifiedDecision>,
    pub(crate) area_error: f64,
}

/// The length of control polygons, which is at least that of the curves.
fn polygon_length(controls: &[[f64; 2]]) -> f64 {
    controls.windows(2).map(|pair| distance(pair[0], pair[1])).sum()
}

/// How far the area of a set is off at most by rounding of the coordinates of its curves, and of what is computed from them.
fn rounding_of_area(set: &YinSet) -> f64 {
    let Some([low, high]) = set.bounding_box() else { return 0.0 };
    let extent = (high[0] - low[0]).max(high[1] - low[1]);
    let largest = [low, high].as_flattened().iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let length: f64 = (0..set.curve_count()).map(|curve| polygon_length(set.curve(curve).controls())).sum();
    f64::EPSILON * length * (16.0 * extent + 8.0 * largest)
}

impl PieceSource {
    /// The source in what another piece came from, of a part of which this is the source.
    fn within(&self, source: &Self) -> Self {
        let [from, to] = source.range;
        let at = |t: f64| if t == 1.0 { to } else { from + t * (to - from) };
        Self { range: self.range.map(at), ..*source }
    }
}

impl Combination {
    /// The same with a bound on the error of its area, for a combination of these sets.
    pub(super) fn with_area_error(mut self, sets: &[&YinSet]) -> Self {
        /// What is taken for one is so many times the resolution apart at most.
        const APART: f64 = 8.0;
        /// Short arcs that are taken for one are so many times the resolution long at most.
        const SHORT: f64 = 4096.0;
        let length_of = |source: &PieceSource| {
            let curve = sets[source.operand as usize].curve(source.curve as usize);
            let part = (source.range[1] - source.range[0]).abs().min(1.0);
            // The parameter need not grow evenly: the whole piece is too long at most.
            if part == 0.0 { 0.0 } else { polygon_length(curve.piece(source.piece as usize)) }
        };
        let moved: f64 = self.report.iter().map(|decision| decision.misplaced).sum();
        let misplaced: f64 = self
            .report
            .iter()
            .map(|decision| {
                let [a, b] = &decision.pieces;
                match decision.assumption {
                    Assumption::SamePoint => SHORT * self.resolution,
                    Assumption::SameArc | Assumption::ArcOrder => length_of(a).max(length_of(b)),
                    Assumption::SmallCurve => {
                        polygon_length(sets[a.operand as usize].curve(a.curve as usize).controls())
                    }
                }
            })
            .sum();
        self.area_error += rounding_of_area(&self.set) + moved + APART * self.resolution * misplaced;
        self
    }

    /// The same with the sources that the operand has, which is the set of another combination.
    pub(super) fn after(self, first: &Self) -> Self {
        let place = |source: &PieceSource| {
            first.set.arena().first_piece(source.curve as usize) + source.piece as usize
        };
        let mut sources = Vec::with_capacity(self.sources.len());
        let mut other_sources = Vec::with_capacity(self.other_sources.len());
        for (number, own) in self.sources.iter().enumerate() {
            sources.push(own.within(&first.sources[place(own)]));
            let all = self.sources_of(number).flat_map(|own| {
                first.sources_of(place(own)).map(move |source| (number as u32, own.within(source)))
            });
            other_sources.extend(all.skip(1));
        }
        Self {
            sources,
            other_sources,
            collapsed_count: self.collapsed_count + first.collapsed_count,
            repair_count: first.repair_count + 1,
            area_error: self.area_error + first.area_error,
            ..self
        }
    }

    /// The set.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let same = YinSet::combine(&[&square], &BooleanFormula::parse("a", &[])?)?;
    /// assert_eq!(same.set().area(), Some(4.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn set(&self) -> &YinSet {
        &self.set
    }

    /// The set alone.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let same = YinSet::combine(&[&square], &BooleanFormula::parse("a", &[])?)?;
    /// assert_eq!(same.into_set().area(), Some(4.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn into_set(self) -> YinSet {
        self.set
    }

    /// Where the pieces of the boundary come from, those of one curve after those of another.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let same = YinSet::combine(&[&square], &BooleanFormula::parse("a", &[])?)?;
    /// assert_eq!((same.sources().len(), same.sources()[0].operand), (4, 0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn sources(&self) -> &[PieceSource] {
        &self.sources
    }

    /// All that a piece of the boundary runs along, counted over all curves.
    ///
    /// # Panics
    /// If there is no such piece.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let same = YinSet::combine(&[&square], &BooleanFormula::parse("a", &[])?)?;
    /// assert_eq!(same.sources_of(0).count(), 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn sources_of(&self, piece: usize) -> impl Iterator<Item = &PieceSource> + '_ {
        let from = self.other_sources.partition_point(|&(own, _)| (own as usize) < piece);
        let others = self.other_sources[from..].iter().take_while(move |&&(own, _)| own as usize == piece);
        std::iter::once(&self.sources[piece]).chain(others.map(|(_, source)| source))
    }

    /// The number of curves that were so small that rounding left less than three different knots of them. They are not part of the
    /// set.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let same = YinSet::combine(&[&square], &BooleanFormula::parse("a", &[])?)?;
    /// assert_eq!(same.collapsed_curve_count(), 0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn collapsed_curve_count(&self) -> usize {
        self.collapsed_count
    }

    /// How often curves of order 2 were laid over each other once more because rounding of their corners had made them meet; 0 if it
    /// had not. Then parts that are thinner than rounding may be gone, and corners moved by a little more.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let same = YinSet::combine(&[&square], &BooleanFormula::parse("a", &[])?)?;
    /// assert_eq!(same.repair_count(), 0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn repair_count(&self) -> usize {
        self.repair_count
    }

    /// What was nearer together than this, in the unit of the input, may have been taken for one, and [`Self::report`] lists the places; 0
    /// for sets of order 2.
    ///
    /// For curves it is 2^-40 of the largest extent of all operands, or 2^-48 of the largest coordinate if that is more. Where that leaves
    /// something open it is 2^-45 of the extent; and 64 or 4096 times the first where curves run so near to each other over and over that
    /// neither tells how they lie.
    pub fn resolution(&self) -> f64 {
        self.resolution
    }

    /// How far the area of the set is off at most: by rounding of coordinates, and by arcs within the resolution of each other that were
    /// taken for one.
    ///
    /// # Examples
    /// A circle against the same moved by 1e-11: the area of the difference is 4e-11.
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// use coface_yin::{Curve, Order, YinSet};
    /// let circle = Curve::circle([0.0, 0.0], 1.0, 32, Order::CUBIC)?;
    /// let [a, b] = [circle.translated([1e-11, 0.0]), circle].map(|curve| YinSet::new(&[curve]));
    /// let found = YinSet::combine(&[&a?, &b?], &BooleanFormula::parse("a ^ b", &[])?)?;
    /// let area = found.set().area().unwrap_or(f64::INFINITY);
    /// assert!((area - 4e-11).abs() < found.area_error() && found.area_error() < 1e-11);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn area_error(&self) -> f64 {
        self.area_error
    }

    /// What was decided without proof: points and arcs of boundaries within the resolution of each other that were taken for one, and
    /// orders of arcs around points. Nothing for sets of order 2.
    ///
    /// Proven, and not listed here, are: crossings; all about segments; curved pieces that touch segments, pass them or cross them
    /// twice, which exact arithmetic decides to about 2^-45 of the extent; pieces that are equal; and everything that is farther apart
    /// than the resolution. Two curved pieces that
    /// touch elsewhere than in a common knot, or run along each other without being equal, are listed.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let same = YinSet::combine(&[&square], &BooleanFormula::parse("a", &[])?)?;
    /// assert!(same.report().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn report(&self) -> &[UncertifiedDecision] {
        &self.report
    }
}
