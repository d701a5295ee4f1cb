//! How far two sets are apart, without a decision on how their curves cross.
//!
//! On a vertical line, the symmetric difference of two sets is where an odd number of boundary points lies below. So its area is an
//! integral of differences of sorted heights, whatever the curves do: it does not matter whether curves cross, touch or run along each
//! other, and nothing is lost below a resolution.

use super::YinSet;
use super::gaps::{NormalGaps, farthest, normal_gaps, turn_limits};
use crate::curve::{bernstein, gauss_legendre, monotone_breaks};
use coface_algebra::Error;
use coface_geometry::Sum;
use rayon::prelude::*;

/// How deep a strip is halved.
const DEEPEST: u32 = 44;

/// How far two sets are apart.
///
/// # Examples
/// Two unit squares, one moved by a millionth.
/// ```
/// use coface_yin::{Curve, YinSet};
/// let square = Curve::polyline(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]])?;
/// let moved = YinSet::new(&[square.translated([1e-6, 0.0])])?;
/// let found = YinSet::new(&[square])?.comparison(&moved)?;
/// assert!((found.area_xor() - 2e-6).abs() <= found.area_xor_error());
/// assert!(found.area_xor_error() < 1e-14 && found.area_signed().abs() <= found.area_signed_error());
/// assert!((found.hausdorff() - 1e-6).abs() < 1e-15);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparison {
    area_xor: f64,
    area_xor_error: f64,
    area_signed: f64,
    area_signed_error: f64,
    hausdorff: f64,
    hausdorff_error: f64,
    normals: NormalGaps,
}

impl Comparison {
    /// The area of the symmetric difference, in the square of the unit of the coordinates; infinite if one of the sets alone is bounded.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// let found = YinSet::plane(Order::CUBIC).comparison(&YinSet::empty(Order::CUBIC))?;
    /// assert_eq!(found.area_xor(), f64::INFINITY);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn area_xor(&self) -> f64 {
        self.area_xor
    }

    /// An estimate from above of how far [`Self::area_xor`] is off: the sum of what two rules of quadrature differ by, of what arcs that
    /// come near each other between places may hide, and of a bound on rounding.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// let found = YinSet::empty(Order::CUBIC).comparison(&YinSet::empty(Order::CUBIC))?;
    /// assert_eq!((found.area_xor(), found.area_xor_error()), (0.0, 0.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn area_xor_error(&self) -> f64 {
        self.area_xor_error
    }

    /// The area of the first set less that of the second; infinite if one of the sets alone is bounded.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// let found = YinSet::empty(Order::CUBIC).comparison(&YinSet::empty(Order::CUBIC))?;
    /// assert_eq!(found.area_signed(), 0.0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn area_signed(&self) -> f64 {
        self.area_signed
    }

    /// How far [`Self::area_signed`] is off at most by rounding.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// let found = YinSet::empty(Order::CUBIC).comparison(&YinSet::empty(Order::CUBIC))?;
    /// assert_eq!(found.area_signed_error(), 0.0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn area_signed_error(&self) -> f64 {
        self.area_signed_error
    }

    /// The Hausdorff distance of the boundaries: the greatest distance of a point of one of them from the other. It is the distance of
    /// a point that was found, by looking at 16 places of each piece and narrowing down the farthest; infinite if one set alone has a
    /// boundary.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// let found = YinSet::empty(Order::CUBIC).comparison(&YinSet::empty(Order::CUBIC))?;
    /// assert_eq!(found.hausdorff(), 0.0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn hausdorff(&self) -> f64 {
        self.hausdorff
    }

    /// An estimate from above of how far [`Self::hausdorff`] is off: what parabolas through places next to each other rise above all places,
    /// and a bound on rounding.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order, YinSet};
    /// let circle = Curve::circle([0.0, 0.0], 1.0, 64, Order::CUBIC)?;
    /// let moved = YinSet::new(&[circle.translated([1e-6, 0.0])])?;
    /// let found = YinSet::new(&[circle])?.comparison(&moved)?;
    /// assert!((found.hausdorff() - 1e-6).abs() <= found.hausdorff_error());
    /// assert!(found.hausdorff_error() < 1e-10);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn hausdorff_error(&self) -> f64 {
        self.hausdorff_error
    }

    /// The greatest distance of the second boundary from the first along the normals of the first: at 17 places of each piece of the first
    /// boundary, how far from there its normal line meets the second one, to either side, up to twice the Hausdorff distance. None where no
    /// normal line does.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order, YinSet};
    /// let disk = |radius: f64| YinSet::new(&[Curve::circle([0.0, 0.0], radius, 64, Order::CUBIC)?]);
    /// let found = disk(1.0)?.comparison(&disk(1.01)?)?;
    /// assert!(found.along_normals().is_some_and(|far| (far - 0.01).abs() < 1e-6));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn along_normals(&self) -> Option<f64> {
        self.normals.is_matched().then_some(self.normals.distance)
    }

    /// An estimate from above of how far [`Self::along_normals`] is off, as [`Self::hausdorff_error`].
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// let found = YinSet::empty(Order::CUBIC).comparison(&YinSet::empty(Order::CUBIC))?;
    /// assert_eq!((found.along_normals(), found.along_normals_error()), (None, 0.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn along_normals_error(&self) -> f64 {
        self.normals.distance_error
    }

    /// The part of the places of the first boundary about which [`Self::curvature`] says nothing: whose normal lines do not meet the second
    /// one within twice the Hausdorff distance, or meet it on the other side of a kink only.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order, YinSet};
    /// let disk = |radius: f64| YinSet::new(&[Curve::circle([0.0, 0.0], radius, 64, Order::CUBIC)?]);
    /// assert!(disk(1.0)?.comparison(&disk(1.01)?)?.normals_left_out() < 0.02);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn normals_left_out(&self) -> f64 {
        self.normals.left_out
    }

    /// The greatest difference of the curvatures of the two boundaries, taken where the normal lines of the first meet the second, in the
    /// inverse of the unit of the coordinates; curvature is positive where a boundary turns left. At kinks, where each side has a curvature of
    /// its own, and near them those of the same side are taken: where both boundaries go in one direction up to half the angle of the kink.
    /// None where no normal line does.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order, YinSet};
    /// let disk = |radius: f64| YinSet::new(&[Curve::circle([0.0, 0.0], radius, 256, Order::CUBIC)?]);
    /// let found = disk(1.0)?.comparison(&disk(2.0)?)?;
    /// assert!(found.curvature().is_some_and(|apart| (apart - 0.5).abs() < 1e-3));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn curvature(&self) -> Option<f64> {
        self.normals.has_curvature().then_some(self.normals.curvature)
    }

    /// An estimate from above of how far [`Self::curvature`] is off: as [`Self::hausdorff_error`], with what rounding of control points does to
    /// second derivatives.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// let found = YinSet::empty(Order::CUBIC).comparison(&YinSet::empty(Order::CUBIC))?;
    /// assert_eq!((found.curvature(), found.curvature_error()), (None, 0.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn curvature_error(&self) -> f64 {
        self.normals.curvature_error
    }
}

impl YinSet {
    /// How far another set is from this one: the area of the symmetric difference with an estimate of its error, about 1e-14 of the box
    /// around both, the difference of the areas, the Hausdorff distance of the boundaries, and their distance and difference of curvature along
    /// the normals of this one. No resolution limits them: sets that are
    /// apart by 1e-10 of their size are right to five digits.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for coordinates whose differences are not finite.
    ///
    /// # Complexity
    /// $O(n \log n + k)$ for n pieces, of which k pairs are over each other and next to each other, times the depth to which strips with
    /// crossings are halved.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order, YinSet};
    /// let circle = Curve::circle([0.0, 0.0], 1.0, 32, Order::CUBIC)?;
    /// let moved = YinSet::new(&[circle.translated([1e-10, 0.0])])?;
    /// let found = YinSet::new(&[circle])?.comparison(&moved)?;
    /// assert!((found.area_xor() - 4e-10).abs() < 1e-14);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn comparison(&self, other: &Self) -> Result<Comparison, Error> {
        let sets = [self, other];
        let boxes: Vec<[[f64; 2]; 2]> = sets.iter().filter_map(|set| set.bounding_box()).collect();
        let Some([low, high]) = boxes.into_iter().reduce(|[a, b], [c, d]| {
            [[0, 1].map(|k| f64::min(a[k], c[k])), [0, 1].map(|k| f64::max(b[k], d[k]))]
        }) else {
            let area = if self.is_bounded() == other.is_bounded() { 0.0 } else { f64::INFINITY };
            let area_signed = if self.is_bounded() { -area } else { area };
            return Ok(Comparison {
                area_xor: area,
                area_xor_error: 0.0,
                area_signed,
                area_signed_error: 0.0,
                hausdorff: 0.0,
                hausdorff_error: 0.0,
                normals: NormalGaps::default(),
            });
        };
        let extent = [0, 1].map(|axis| high[axis] - low[axis]);
        if extent.iter().any(|extent| !extent.is_finite()) {
            return Err(Error::invalid("the sets are too far apart to be compared")
                .with_cure("scale both down by the same factor"));
        }
        // Coordinates are taken from the middle of the box, so that large ones do no harm.
        let center = [0, 1].map(|axis| low[axis] + 0.5 * extent[axis]);
        let curves = sets.map(|set| local_curves(set, center));
        let limits =
            curves.each_ref().map(|own| own.iter().flat_map(|own| turn_limits(own)).collect::<Vec<f64>>());
        let pieces = curves.map(|own| own.concat());
        let largest = extent[0].max(extent[1]);
        let (from, to) = (farthest(&pieces[0], &pieces[1]), farthest(&pieces[1], &pieces[0]));
        let hausdorff = from.most.max(to.most);
        let hausdorff_error = match hausdorff.is_finite() {
            true => (from.peak.max(to.peak) - hausdorff).max(0.0) + 8.0 * f64::EPSILON * largest,
            false => 0.0,
        };
        let normals = match hausdorff.is_finite() {
            true => normal_gaps(
                pieces.each_ref().map(Vec::as_slice),
                limits.each_ref().map(Vec::as_slice),
                2.0 * hausdorff + 8.0 * f64::EPSILON * largest,
            ),
            false => NormalGaps::default(),
        };
        let arcs: Vec<Arc> = pieces.iter().flatten().flat_map(|piece| arcs_of(piece)).collect();
        let signed = pieces.each_ref().map(|pieces| {
            let mut sum = Sum::default();
            pieces.iter().for_each(|piece| add_area(piece, &mut sum));
            sum.value()
        });
        let area_signed_error =
            16.0 * f64::EPSILON * largest * largest * (pieces[0].len() + pieces[1].len()) as f64;
        let same = self.is_bounded() == other.is_bounded();
        let [area_xor, area_xor_error] = if same { area_between(arcs, extent) } else { [f64::INFINITY, 0.0] };
        Ok(Comparison {
            area_xor,
            area_xor_error,
            area_signed: match same {
                true => signed[0] - signed[1],
                false if self.is_bounded() => f64::NEG_INFINITY,
                false => f64::INFINITY,
            },
            area_signed_error: area_signed_error.min(largest * largest * 64.0 * f64::EPSILON * 8.0),
            hausdorff,
            hausdorff_error,
            normals,
        })
    }
}

/// The control points of a piece, from the middle of all.
pub(super) type Controls = Vec<[f64; 2]>;

/// The pieces of each curve of a set.
fn local_curves(set: &YinSet, center: [f64; 2]) -> Vec<Vec<Controls>> {
    let of_curve = |curve: usize| {
        let curve = set.curve(curve);
        let own = |piece: usize| -> Controls {
            let local = curve.piece(piece).iter().map(|point| [0, 1].map(|k| point[k] - center[k]));
            let local: Controls = local.collect();
            match bernstein::is_straight(curve.piece(piece)) {
                true => bernstein::straight_piece([local[0], local[local.len() - 1]], local.len()).to_vec(),
                false => local,
            }
        };
        (0..curve.piece_count()).map(own).collect()
    };
    (0..set.curve_count()).map(of_curve).collect()
}

/// Adds the area between a piece and the origin: half the integral of the cross product of points and derivatives.
fn add_area(piece: &[[f64; 2]], sum: &mut Sum) {
    let degree = piece.len() - 1;
    // Exact for the degree of the integrand, 2 d - 1 up to 13.
    let derivative = bernstein::derivative(piece);
    let rule = gauss_legendre();
    if degree == 1 || bernstein::is_straight(piece) {
        let [a, b] = [piece[0], piece[degree]];
        sum.add(0.5 * (a[0] * b[1]));
        sum.add(-0.5 * (a[1] * b[0]));
        return;
    }
    for [x, weight] in rule {
        let s = 0.5 + 0.5 * x;
        let (point, way) = (bernstein::value(piece, s), bernstein::value(&derivative, s));
        sum.add(0.25 * weight * (point[0] * way[1]));
        sum.add(-0.25 * weight * (point[1] * way[0]));
    }
}

/// A part of a piece over which x rises.
struct Arc {
    controls: bernstein::Piece,
    from: f64,
    to: f64,
}

impl Arc {
    /// The height at a place.
    fn height(&self, x: f64) -> f64 {
        let [first, last] = [self.controls[0], self.controls[self.controls.len() - 1]];
        if bernstein::is_straight(&self.controls) {
            let part = ((x - first[0]) / (last[0] - first[0])).clamp(0.0, 1.0);
            return if part < 0.5 {
                first[1] + part * (last[1] - first[1])
            } else {
                last[1] + (last[0] - x) / (last[0] - first[0]) * (first[1] - last[1])
            };
        }
        let slopes = bernstein::derivative(&self.controls);
        let [mut low, mut high] = [0.0f64, 1.0f64];
        let mut s = ((x - first[0]) / (last[0] - first[0])).clamp(0.0, 1.0);
        // Newton's iteration, held between bounds that halve where it does not converge.
        for _ in 0..64 {
            let miss = bernstein::value(&self.controls, s)[0] - x;
            if miss == 0.0 {
                break;
            }
            if miss > 0.0 {
                high = s;
            } else {
                low = s;
            }
            let step = s - miss / bernstein::value(&slopes, s)[0];
            let next = if low < step && step < high { step } else { 0.5 * (low + high) };
            if (next - s).abs() <= 0.25 * f64::EPSILON || next <= low || next >= high {
                break;
            }
            s = next;
        }
        bernstein::value(&self.controls, s)[1]
    }
}

/// The parts of a piece over which x rises or falls, turned so that it rises; those that are upright are none.
fn arcs_of(piece: &[[f64; 2]]) -> Vec<Arc> {
    let breaks = if bernstein::is_straight(piece) { Vec::new() } else { monotone_breaks(piece) };
    let ends: Vec<f64> = [0.0].into_iter().chain(breaks).chain([1.0]).collect();
    let points: Vec<[f64; 2]> = ends.iter().map(|&s| bernstein::value(piece, s)).collect();
    let parts = ends.windows(2).zip(points.windows(2));
    let arc = |(range, points): (&[f64], &[[f64; 2]])| {
        let ends = [points[0], points[1]];
        let part = bernstein::sub_range_between(piece, [range[0], range[1]], ends);
        let controls = if ends[0][0] < ends[1][0] { part } else { part.reversed() };
        let [from, to] = [ends[0][0].min(ends[1][0]), ends[0][0].max(ends[1][0])];
        (from < to).then_some(Arc { controls, from, to })
    };
    parts.filter_map(arc).collect()
}

/// The area where an odd number of arcs lies below, and a bound on its error.
fn area_between(mut arcs: Vec<Arc>, extent: [f64; 2]) -> [f64; 2] {
    arcs.sort_by(|a, b| a.from.total_cmp(&b.from).then(a.to.total_cmp(&b.to)));
    let mut places: Vec<f64> = arcs.iter().flat_map(|arc| [arc.from, arc.to]).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    // The arcs over each strip.
    let mut strips: Vec<(f64, f64, Vec<u32>)> = Vec::with_capacity(places.len());
    let (mut active, mut next): (Vec<u32>, usize) = (Vec::new(), 0);
    for pair in places.windows(2) {
        active.retain(|&arc| arcs[arc as usize].to > pair[0]);
        while arcs.get(next).is_some_and(|arc| arc.from <= pair[0]) {
            active.push(next as u32);
            next += 1;
        }
        if !active.is_empty() {
            strips.push((pair[0], pair[1], active.clone()));
        }
    }
    let rule = gauss_legendre();
    let rounding = 4.0 * f64::EPSILON * (extent[0] + extent[1]);
    let found: Vec<[f64; 2]> = strips
        .par_iter()
        .map(|(from, to, own)| {
            let own: Vec<&Arc> = own.iter().map(|&arc| &arcs[arc as usize]).collect();
            Strip { arcs: own, from: *from, to: *to, rounding }.area(&rule)
        })
        .collect();
    let mut sums = [Sum::default(), Sum::default()];
    for [area, error] in found {
        sums[0].add(area);
        sums[1].add(error);
    }
    sums.map(Sum::value)
}

/// Arcs over an interval.
struct Strip<'a> {
    arcs: Vec<&'a Arc>,
    from: f64,
    to: f64,
    /// How far heights are off at most.
    rounding: f64,
}

impl Strip<'_> {
    /// What of the line at a place is over an odd number of arcs.
    fn measure(&self, x: f64, heights: &mut Vec<f64>) -> f64 {
        heights.clear();
        heights.extend(self.arcs.iter().map(|arc| arc.height(x)));
        heights.sort_by(f64::total_cmp);
        heights.chunks_exact(2).map(|pair| pair[1] - pair[0]).sum()
    }

    /// The integral, and a bound on its error.
    ///
    /// With $x = m + h (3 u - u^3) / 2$ square roots at the ends, where arcs are upright, are smooth.
    fn area(&self, rule: &[[f64; 2]; 8]) -> [f64; 2] {
        let (middle, half) = (0.5 * (self.from + self.to), 0.5 * (self.to - self.from));
        let count = self.arcs.len();
        let mut heights = Vec::with_capacity(count);
        // The integral over an interval, and the heights at all places of it.
        let mut integral = |low: f64, high: f64| {
            let (center, reach) = (0.5 * (low + high), 0.5 * (high - low));
            let mut sum = 0.0;
            let mut samples = Vec::with_capacity(rule.len());
            // The rule has its places falling.
            for [x, weight] in rule.iter().rev() {
                let u = center + reach * x;
                let at = (middle + half * (0.5 * u * (3.0 - u * u))).clamp(self.from, self.to);
                sum += weight * 1.5 * (1.0 - u * u) * self.measure(at, &mut heights);
                samples.push((u, heights.clone()));
            }
            Integral { value: half * reach * sum, samples }
        };
        // Places are rounded as heights are: where arcs are steep that counts more.
        let rise = |arc: &&Arc| (arc.height(self.to) - arc.height(self.from)).abs();
        let rises: f64 = self.arcs.iter().map(rise).sum();
        let floor = self.rounding * (half * self.arcs.len() as f64 + 0.25 * rises);
        let [mut area, mut error] = [Sum::default(), Sum::default()];
        error.add(2.0 * floor);
        let mut waiting = vec![(-1.0, 1.0, integral(-1.0, 1.0).value, 0)];
        while let Some((low, high, whole, depth)) = waiting.pop() {
            let center = 0.5 * (low + high);
            let halves = [integral(low, center), integral(center, high)];
            let found = halves[0].value + halves[1].value;
            let miss = (found - whole).abs();
            let hidden = hidden_area(&halves, [low, high], count) * half;
            let is_done = miss <= floor * (1.0 / 64.0 + 0.5 * (high - low)) && hidden <= floor / 64.0;
            if is_done || depth >= DEEPEST {
                area.add(found);
                error.add(miss + hidden);
            } else {
                waiting.push((center, high, halves[1].value, depth + 1));
                waiting.push((low, center, halves[0].value, depth + 1));
            }
        }
        [area.value(), error.value()]
    }
}

/// An integral with all heights that it is made of.
struct Integral {
    value: f64,
    samples: Vec<(f64, Vec<f64>)>,
}

/// How large a part between two arcs that cross twice between places may be: where the parabola through three gaps next to each other
/// falls well below all of them.
fn hidden_area(halves: &[Integral; 2], [low, high]: [f64; 2], count: usize) -> f64 {
    let samples: Vec<&(f64, Vec<f64>)> = halves.iter().flat_map(|half| &half.samples).collect();
    let mut most = 0.0f64;
    for k in 1..count {
        let gap = |at: usize| samples[at].1[k] - samples[at].1[k - 1];
        for at in 1..samples.len() - 1 {
            let [p, q, r] = [at - 1, at, at + 1];
            let is_lowest = gap(q) <= gap(p) && gap(q) <= gap(r);
            let is_end = (p == 0 && gap(p) < gap(q)) || (r + 1 == samples.len() && gap(r) < gap(q));
            if !is_lowest && !is_end {
                continue;
            }
            let [u, v, w] = [p, q, r].map(|at| samples[at].0);
            let first = (gap(q) - gap(p)) / (v - u);
            let second = ((gap(r) - gap(q)) / (w - v) - first) / (w - u);
            let parabola = |x: f64| gap(p) + (x - u) * (first + (x - v) * second);
            let least = gap(p).min(gap(q)).min(gap(r));
            // What is beyond the outermost places.
            let ends = [(p == 0).then_some((low, u)), (r + 1 == samples.len()).then_some((high, w))];
            for (end, place) in ends.into_iter().flatten() {
                if parabola(end) < 0.0 {
                    most = most.max((least - parabola(end)) * (end - place).abs());
                }
            }
            let lowest = 0.5 * (u + v - first / second);
            if second > 0.0 && (low..=high).contains(&lowest) && parabola(lowest) < 0.25 * least {
                most = most.max((least - parabola(lowest)) * (high - low));
            }
        }
    }
    most
}
