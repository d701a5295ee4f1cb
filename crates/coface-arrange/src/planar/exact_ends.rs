//! Arrangements of segments whose ends are known exactly.
//!
//! The search for what is near and the order of what is found are those of segments between rounded ends: rounding is monotone, so
//! boxes around rounded pieces meet where the pieces do. Decisions are made with the supports of pieces and with exact ends.

use super::crossings::{Crossing, Meetings, Soup};
use super::{ExactSegments, PlanarArrangement, PlanarOptions};
use coface_algebra::{Error, ErrorKind};
use coface_geometry::Positions;
use coface_geometry::predicates::{PlanarLine, PlanarPoint, orientation};
use rayon::prelude::*;
use std::cmp::Ordering;
use std::sync::Arc;

/// Exact segments among the points and segments of a drawing: vertex i is point `first_point + i`, piece i is segment
/// `first_segment + i`.
///
/// # Examples
/// ```
/// use coface_arrange::planar::ExactPlace;
/// let place = ExactPlace { first_point: 0, first_segment: 0, segments: Default::default() };
/// assert!(place.segments.pieces().is_empty());
/// ```
#[derive(Clone, Debug)]
pub struct ExactPlace {
    /// The number of its first point.
    pub first_point: usize,
    /// The number of its first segment.
    pub first_segment: usize,
    /// What is there.
    pub segments: Arc<ExactSegments>,
}

/// The exact ends of all segments.
#[derive(Debug)]
pub(super) struct ExactEnds {
    points: Vec<PlanarPoint>,
    /// The support of each segment.
    lines: Vec<PlanarLine>,
    /// Whether each segment runs from its lower to its upper end.
    rises: Vec<bool>,
}

impl PlanarArrangement {
    /// The arrangement of segments some of which are known exactly, as [`Self::with_options`] else. `positions` and `segments` have them
    /// with rounded ends.
    ///
    /// # Errors
    /// As [`Self::with_options`], and [`ErrorKind::Shape`] unless the points and segments of the places are there, one place after the
    /// other.
    ///
    /// # Complexity
    /// As [`Self::with_options`].
    ///
    /// # Examples
    /// Three lines that nearly meet in one point: what two of them became is cut by the third as they themselves are.
    /// ```
    /// use coface_arrange::planar::{ExactPiece, ExactPlace, ExactSegments, ExactVertex, PlanarArrangement};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = vec![[0., 0.], [2., 2.], [0., 2.], [2., 0.]];
    /// let vertices = (0..4).map(ExactVertex::Point).chain([ExactVertex::Crossing([0, 1])]).collect();
    /// let pieces = [[0, 0, 4], [0, 4, 1], [1, 2, 4], [1, 4, 3]];
    /// let pieces = pieces.map(|[support, from, to]| ExactPiece { support, ends: [from, to] }).to_vec();
    /// let segments = ExactSegments::new(points, vec![[0, 1], [2, 3]], vertices, pieces, vec![])?;
    /// let flat = vec![0., 0., 2., 2., 0., 2., 2., 0., 1., 1., 0., 1., 4., 1. + f64::EPSILON];
    /// let ends = [[0, 4], [4, 1], [2, 4], [4, 3], [5, 6]];
    /// let place = ExactPlace { first_point: 0, first_segment: 0, segments: segments.into() };
    /// let positions = Positions::from_flat(2, flat)?;
    /// let arrangement = PlanarArrangement::with_exact(&positions, &ends, &[place], &Default::default())?;
    /// assert_eq!(arrangement.f_vector(), [9, 9, 1]);
    /// # Ok(()) }
    /// ```
    pub fn with_exact(
        positions: &Positions,
        segments: &[[u32; 2]],
        exact: &[ExactPlace],
        options: &PlanarOptions,
    ) -> Result<Self, Error> {
        if exact.is_empty() {
            return Self::with_options(positions, segments, options);
        }
        let (mut point_end, mut segment_end) = (0, 0);
        for place in exact {
            let is_after = point_end <= place.first_point && segment_end <= place.first_segment;
            point_end = place.first_point + place.segments.vertices().len();
            segment_end = place.first_segment + place.segments.pieces().len();
            if !is_after || point_end > positions.len() || segment_end > segments.len() {
                return Err(Error::new(
                    ErrorKind::Shape,
                    format!(
                        "exact segments have points up to {point_end} and segments up to {segment_end}; there are {} and {}",
                        positions.len(),
                        segments.len()
                    ),
                ));
            }
        }
        Self::check_ends(positions, segments)?;
        let mut points: Vec<PlanarPoint> =
            positions.as_flat().as_chunks::<2>().0.iter().map(|&point| PlanarPoint::given(point)).collect();
        let at = |point: u32| points[point as usize].rounded();
        let mut lines: Vec<PlanarLine> = segments.iter().map(|ends| ends.map(at)).collect();
        for place in exact {
            let own = place.segments.vertex_points();
            points[place.first_point..place.first_point + own.len()].copy_from_slice(&own);
            for (line, piece) in lines[place.first_segment..].iter_mut().zip(place.segments.pieces()) {
                *line = place.segments.line(piece.support);
            }
        }
        let rises = |&[a, b]: &[u32; 2]| points[a as usize].compare(&points[b as usize]).is_lt();
        let rises = segments.par_iter().with_min_len(1024).map(rises).collect();
        let rounded = Positions::from_flat(2, points.iter().flat_map(PlanarPoint::rounded).collect())?;
        Self::arranged(&rounded, segments, Some(Arc::new(ExactEnds { points, lines, rises })), options)
    }

    /// Whether a segment runs from its lexicographically lower end to the upper one.
    #[doc(hidden)]
    pub fn rises(&self, segment: usize) -> bool {
        match &self.exact {
            Some(exact) => exact.rises[segment],
            None => {
                let [a, b] = self.segments[segment].map(|point| self.points[point as usize]);
                (a[0], a[1]) < (b[0], b[1])
            }
        }
    }

    /// The ends of the segment of the input that a segment is a part of.
    #[doc(hidden)]
    pub fn support(&self, segment: usize) -> PlanarLine {
        match &self.exact {
            Some(exact) => exact.lines[segment],
            None => self.segments[segment].map(|point| self.points[point as usize]),
        }
    }
}

impl Soup {
    /// The exact place of a point.
    pub(super) fn point(&self, point: u32) -> PlanarPoint {
        match &self.exact {
            Some(exact) => exact.points[point as usize],
            None => PlanarPoint::given(self.points[point as usize]),
        }
    }

    /// The ends of the support of a segment.
    pub(super) fn support(&self, segment: u32) -> PlanarLine {
        let known = self.exact.as_ref().and_then(|exact| exact.lines.get(segment as usize));
        known.copied().unwrap_or_else(|| self.line(segment))
    }

    /// The exact ends of a segment, the lower first.
    pub(super) fn rising_ends(&self, segment: u32) -> [PlanarPoint; 2] {
        let [a, b] = self.segments[segment as usize].map(|end| self.point(end));
        let rises = |exact: &ExactEnds| exact.rises.get(segment as usize).is_none_or(|&rises| rises);
        if self.exact.as_deref().is_none_or(rises) { [a, b] } else { [b, a] }
    }

    /// The side of a line on which a point is. Those at the ends of its segment are on it.
    fn side(&self, line: PlanarLine, ends: [u32; 2], point: u32) -> Ordering {
        if ends.contains(&point) {
            return Ordering::Equal;
        }
        let place = self.point(point);
        if place.residues() == [Some(Ordering::Equal); 2] {
            return orientation(line[0], line[1], place.rounded());
        }
        place.side_of(line)
    }
}

impl Meetings {
    /// As [`Self::meet`], for segments with exact ends.
    pub(super) fn meet_exactly(&mut self, soup: &Soup, pair: [u32; 2]) {
        let [s, t] = pair;
        let [ends_s, ends_t] = pair.map(|segment| soup.segments[segment as usize]);
        let lines = pair.map(|segment| soup.support(segment));
        let of_t = ends_t.map(|end| soup.side(lines[0], ends_s, end));
        if of_t[0] == of_t[1] && of_t[0].is_ne() {
            return;
        }
        let of_s = ends_s.map(|end| soup.side(lines[1], ends_t, end));
        if of_s[0] == of_s[1] && of_s[0].is_ne() {
            return;
        }
        if of_s.iter().chain(&of_t).all(|side| side.is_ne()) {
            let point =
                PlanarPoint::crossing(lines[0], lines[1]).expect("segments that cross are not parallel");
            self.crossings.push(Crossing {
                segments: pair,
                rounded: point.rounded(),
                residues: point.residues(),
            });
            return;
        }
        for (on, ends, sides, numbers) in [(s, ends_s, of_t, ends_t), (t, ends_t, of_s, ends_s)] {
            for (number, side) in numbers.into_iter().zip(sides) {
                if side.is_eq() && !ends.contains(&number) {
                    let [low, high] = soup.rising_ends(on);
                    let point = soup.point(number);
                    if low.compare(&point).is_le() && point.compare(&high).is_le() {
                        self.touches.push([on, number]);
                    }
                }
            }
        }
    }
}
