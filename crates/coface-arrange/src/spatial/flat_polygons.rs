//! Triangulates polygons and reports the ones that are not simple.

use super::axis_view::AxisView;
use super::cutting::{Crossings, crossings};
use super::polygons::SpatialPolygons;
use super::predicates::{GivenPoints, SpatialPredicates};
use coface_algebra::progress::stage;
use coface_algebra::{Error, VertexId};
use coface_algebra::{RaggedArray, Sign};
use coface_geometry::triangulation::{TriangulationFault, triangulate, triangulate_sides};
use coface_geometry::{Positions, Scaled, cross, dot};
use rayon::prelude::*;
use std::cmp::Ordering;

/// A deviation of at most so many units in the last place of the largest coordinate is rounding.
const ROUNDING_UNITS: f64 = 16.0;

/// Polygons with more sides are not looked at twice if their sides cross or touch.
const MOST_CLIPPED: usize = 1 << 10;

/// What becomes of polygons whose points are not exactly in one plane.
///
/// Whatever is split is put together again: a face is a part of a polygon, not of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum NonPlanar {
    /// An error that says how far a point is from the plane.
    Refuse,
    /// They are split where [rounding explains it](SplitPolygon::is_rounding), and an error otherwise.
    Rounded,
    /// They are split into triangles: quadrangles along the shorter diagonal, other polygons as seen along the axis that
    /// is nearest to their normal.
    #[default]
    Split,
}

/// A polygon that was split because its points are not in one plane.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SplitPolygon {
    /// The number of the polygon.
    pub polygon: u32,
    /// The largest distance of a point from the plane through the middle of all points, in the unit of the positions,
    /// rounded.
    pub deviation: f64,
    /// The deviation that rounding of coordinates explains: 16 units in the last place of the largest coordinate of the
    /// input that the polygon is of. The units are those of single precision if all coordinates of the input are
    /// numbers of single precision, and one of them needs more than 16 bits.
    pub rounding: f64,
}

impl SplitPolygon {
    /// Whether rounding of the coordinates explains that the polygon is not planar.
    ///
    /// # Examples
    /// A square with a corner that is lifted by as little as a number can be, and by a quarter:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// for (height, is_rounding) in [(1.0 + f64::EPSILON, true), (1.25, false)] {
    ///     let flat = vec![0., 0., 1., 1., 0., 1., 1., 1., height, 0., 1., 1.];
    ///     let positions = Positions::from_flat(3, flat)?;
    ///     let square = SpatialPolygons::from_polygons(positions, RaggedArray::from_lists([[0, 1, 2, 3]]))?;
    ///     let arrangement = SpatialArrangement::new(&square, &SpatialOptions::new())?;
    ///     assert_eq!(arrangement.split_polygons()[0].is_rounding(), is_rounding);
    ///     assert_eq!(arrangement.f_vector(), [4, 4, 1, 0]);
    /// }
    /// # Ok(()) }
    /// ```
    pub fn is_rounding(&self) -> bool {
        self.deviation <= self.rounding
    }
}

/// The triangles that polygons are made of.
#[derive(Clone, Debug, Default)]
pub(super) struct PolygonTriangles {
    /// Counterclockwise seen from the fronts of their polygons.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The polygon of each triangle, rising.
    pub(super) polygon_of_triangle: Vec<u32>,
    /// The polygons without area.
    pub(super) without_area: Vec<u32>,
    /// The polygons that are not planar, rising, each with a picture in which it is seen from its front.
    pub(super) split: Vec<(SplitPolygon, AxisView)>,
    /// The polygons, rising, whose triangles are not put together again: their sides cross or touch by as little as
    /// rounding explains.
    pub(super) apart: Vec<u32>,
}

/// What is found in a picture, and the picture.
type Seen<T> = (T, AxisView);

enum Outcome {
    WithoutArea,
    Triangles(Vec<[u32; 3]>),
    Split(Vec<[u32; 3]>, f64, AxisView),
    /// Triangles whose sum has the sides of the polygon, though some may lie on each other.
    Apart(Vec<[u32; 3]>),
}

impl Outcome {
    fn into_triangles(self) -> Vec<[u32; 3]> {
        match self {
            Self::WithoutArea => Vec::new(),
            Self::Triangles(own) | Self::Split(own, ..) | Self::Apart(own) => own,
        }
    }
}

impl SpatialPolygons {
    /// Checks that each polygon is simple, as an arrangement of them does.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput)
    /// which is not planar when that is refused.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{NonPlanar, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let bent = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 1., 1., 1., 0., 1., 0.])?;
    /// let polygons = SpatialPolygons::from_polygons(bent, RaggedArray::from_lists([[0, 1, 2, 3]]))?;
    /// assert!(polygons.check(NonPlanar::Refuse).is_err() && polygons.check(NonPlanar::Split).is_ok());
    /// # Ok(()) }
    /// ```
    pub fn check(&self, non_planar: NonPlanar) -> Result<(), Error> {
        PolygonTriangles::new(self, non_planar).map(drop)
    }

    /// Where the polygons meet otherwise than in common corners and sides, split into triangles where they are not planar.
    /// Exact for the coordinates as they are. At most so many places are listed.
    ///
    /// # Errors
    /// As [`Self::check`], for polygons that are not simple.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n triangles that are near few others.
    ///
    /// # Examples
    /// Two triangles that cross along a segment:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::SpatialPolygons;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 1., 1., -1., 1., 1., 1., 9., 9., 0.];
    /// let lists = RaggedArray::from_lists([[0, 1, 2], [3, 4, 5]]);
    /// let polygons = SpatialPolygons::from_polygons(Positions::from_flat(3, points)?, lists)?;
    /// let found = polygons.crossings(10)?;
    /// assert_eq!((found.count, found.places), (1, vec![[2.0, 2.0, 0.0]]));
    /// # Ok(()) }
    /// ```
    pub fn crossings(&self, most_listed: usize) -> Result<Crossings, Error> {
        self.crossings_of_changed(|_| true, most_listed)
    }

    /// The same for polygons of which only these changed since the others were known to meet in common corners and sides
    /// alone.
    ///
    /// # Errors
    /// As [`Self::crossings`].
    ///
    /// # Complexity
    /// $O(n + k \log k)$ for n triangles, k of which changed or are near those that did.
    ///
    /// # Examples
    /// Two triangles that cross, which is known of the second:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::SpatialPolygons;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 1., 1., -1., 1., 1., 1., 9., 9., 0.];
    /// let lists = RaggedArray::from_lists([[0, 1, 2], [3, 4, 5]]);
    /// let polygons = SpatialPolygons::from_polygons(Positions::from_flat(3, points)?, lists)?;
    /// assert_eq!(polygons.crossings_of_changed(|polygon| polygon == 1, 10)?.count, 1);
    /// assert_eq!(polygons.crossings_of_changed(|_| false, 10)?.count, 0);
    /// # Ok(()) }
    /// ```
    pub fn crossings_of_changed(
        &self,
        is_changed: impl Fn(usize) -> bool + Sync,
        most_listed: usize,
    ) -> Result<Crossings, Error> {
        let made = PolygonTriangles::new(self, NonPlanar::Split)?;
        let is_changed = |triangle: usize| is_changed(made.polygon_of_triangle[triangle] as usize);
        let mut found = crossings(self.positions(), &made.triangles, is_changed, most_listed)?;
        for &polygon in &made.without_area {
            let walk = self.polygon_of_walk().partition_point(|&own| own < polygon);
            if let Some(&corner) = self.walks().list(walk).first() {
                let point = self.positions().point(VertexId::from_u32(corner));
                found.add([point[0], point[1], point[2]], most_listed);
            }
        }
        // Two polygons that have a triangle in common lie on each other there.
        let mut corners = made.triangles;
        corners.iter_mut().for_each(|own| own.sort_unstable());
        corners.par_sort_unstable();
        for pair in corners.windows(2).filter(|pair| pair[0] == pair[1]) {
            let point = self.positions().point(VertexId::from_u32(pair[0][0]));
            found.add([point[0], point[1], point[2]], most_listed);
        }
        Ok(found)
    }
}

impl PolygonTriangles {
    /// Cuts all polygons into triangles on their own points.
    ///
    /// # Errors
    /// `InvalidInput` naming the first polygon that is not planar, if those are refused, or whose sides cross or touch.
    pub(super) fn new(polygons: &SpatialPolygons, non_planar: NonPlanar) -> Result<Self, Error> {
        Self::cut(polygons, non_planar, None)
    }

    /// Cuts polygons into triangles whose points were moved; those whose sides cross now have the triangles of `before`, each by
    /// itself, but for triangles that lost their area.
    ///
    /// # Errors
    /// As [`Self::new`] for polygons that crossed themselves before.
    pub(super) fn of_moved(moved: &SpatialPolygons, before: &SpatialPolygons) -> Result<Self, Error> {
        Self::cut(moved, NonPlanar::Split, Some(before))
    }

    fn cut(
        polygons: &SpatialPolygons,
        non_planar: NonPlanar,
        before: Option<&SpatialPolygons>,
    ) -> Result<Self, Error> {
        let points = GivenPoints::new(polygons.positions())?;
        let is_mesh = polygons.exact().is_empty()
            && polygons.walks().uniform_width() == Some(3)
            && (0..).zip(polygons.polygon_of_walk()).all(|(walk, &polygon): (u32, _)| walk == polygon);
        if is_mesh {
            return Ok(Self::of_triangles(&points, polygons.walks()));
        }
        let first_equal = first_equal_points(polygons.positions());
        let walks_of_polygon =
            RaggedArray::grouped(polygons.polygon_count(), polygons.polygon_of_walk().iter().copied());
        let scaled = Scaled::new(polygons.positions());
        let rounding = explained_deviations(polygons);
        let cutter = Cutter { points: &points, positions: polygons.positions(), scaled, non_planar };
        let points_before = before.map(|own| GivenPoints::new(own.positions())).transpose()?;
        let cutter_before = before.zip(points_before.as_ref()).map(|(own, points)| {
            let (positions, scaled) = (own.positions(), Scaled::new(own.positions()));
            (Cutter { points, positions, scaled, non_planar }, first_equal_points(positions))
        });
        let sides_of = |polygon: usize, first_equal: &[u32], sides: &mut Vec<[u32; 2]>| {
            sides.clear();
            for &walk in walks_of_polygon.list(polygon) {
                let walk = polygons.walks().list(walk as usize);
                let next = walk.iter().cycle().skip(1);
                let ends = walk.iter().zip(next).map(|(&a, &b)| [a, b].map(|v| first_equal[v as usize]));
                sides.extend(ends.filter(|[a, b]| a != b));
            }
        };
        let steps = stage("triangulating polygons", polygons.polygon_count());
        let found: Vec<Result<Outcome, Error>> = (0..polygons.polygon_count())
            .into_par_iter()
            .map_init(Vec::new, |sides, polygon| {
                steps.advance(1);
                if polygons.is_exact(polygon as u32) {
                    // Its triangles are known.
                    return Ok(Outcome::Triangles(Vec::new()));
                }
                sides_of(polygon, &first_equal, sides);
                let rounding = rounding[polygons.input_of_polygon()[polygon] as usize];
                match (cutter.cut(polygon, sides, rounding), &cutter_before) {
                    (Err(_), Some((before, equal_before))) => {
                        sides_of(polygon, equal_before, sides);
                        let mut own = before.cut(polygon, sides, rounding)?.into_triangles();
                        own.iter_mut().flatten().for_each(|corner| *corner = first_equal[*corner as usize]);
                        own.retain(|&own| (0..3).any(|axis| points.normal_sign(axis, own).is_ne()));
                        Ok(if own.is_empty() { Outcome::WithoutArea } else { Outcome::Apart(own) })
                    }
                    (found, _) => found,
                }
            })
            .collect();
        let mut all = Self::default();
        for (polygon, outcome) in (0..).zip(found) {
            let own = match outcome? {
                Outcome::WithoutArea => {
                    all.without_area.push(polygon);
                    continue;
                }
                Outcome::Triangles(own) => own,
                Outcome::Apart(own) => {
                    all.apart.push(polygon);
                    own
                }
                Outcome::Split(own, deviation, view) => {
                    let rounding = rounding[polygons.input_of_polygon()[polygon as usize] as usize];
                    all.split.push((SplitPolygon { polygon, deviation, rounding }, view));
                    own
                }
            };
            all.polygon_of_triangle.extend(own.iter().map(|_| polygon));
            all.triangles.extend(own);
        }
        Ok(all)
    }

    fn of_triangles(points: &GivenPoints<'_>, walks: &RaggedArray) -> Self {
        let lists = walks.items().as_chunks::<3>().0;
        let has_area: Vec<bool> =
            lists.par_iter().map(|&own| (0..3).any(|axis| points.normal_sign(axis, own).is_ne())).collect();
        if !has_area.contains(&false) {
            let polygon_of_triangle = (0..lists.len() as u32).collect();
            return Self { triangles: lists.to_vec(), polygon_of_triangle, ..Self::default() };
        }
        let mut all = Self::default();
        for ((polygon, &own), has_area) in (0..).zip(lists).zip(has_area) {
            if has_area {
                all.triangles.push(own);
                all.polygon_of_triangle.push(polygon);
            } else {
                all.without_area.push(polygon);
            }
        }
        all
    }
}

/// For each input how far its points may be off a plane because its coordinates are rounded.
pub(super) fn explained_deviations(polygons: &SpatialPolygons) -> Vec<f64> {
    let mut largest = vec![0.0f64; polygons.input_count()];
    let mut is_single = vec![true; polygons.input_count()];
    let mut is_long = vec![false; polygons.input_count()];
    for (walk, &polygon) in polygons.walks().iter().zip(polygons.polygon_of_walk()) {
        let input = polygons.input_of_polygon()[polygon as usize] as usize;
        for &x in walk.iter().flat_map(|&vertex| polygons.positions().point(VertexId::from_u32(vertex))) {
            largest[input] = largest[input].max(x.abs());
            let single = x as f32;
            is_single[input] &= f64::from(single) == x;
            // The last 8 of 24 bits.
            is_long[input] |= single.to_bits() & 0xff != 0;
        }
    }
    let unit = |input: usize| {
        if is_single[input] && is_long[input] { f64::from(f32::EPSILON) } else { f64::EPSILON }
    };
    largest.iter().enumerate().map(|(input, &largest)| ROUNDING_UNITS * unit(input) * largest).collect()
}

/// For each point the first one at the same place.
pub(super) fn first_equal_points(positions: &Positions) -> Vec<u32> {
    // Both zeros are one.
    let bits: Vec<[u64; 3]> = positions
        .as_flat()
        .as_chunks::<3>()
        .0
        .iter()
        .map(|point| point.map(|x| (x + 0.0).to_bits()))
        .collect();
    let mut order: Vec<u32> = (0..bits.len() as u32).collect();
    order.par_sort_unstable_by_key(|&point| (bits[point as usize], point));
    let mut first = vec![0; bits.len()];
    for own in order.chunk_by(|&a, &b| bits[a as usize] == bits[b as usize]) {
        own.iter().for_each(|&point| first[point as usize] = own[0]);
    }
    first
}

struct Cutter<'a> {
    points: &'a GivenPoints<'a>,
    positions: &'a Positions,
    scaled: Scaled<'a>,
    non_planar: NonPlanar,
}

impl Cutter<'_> {
    fn cut(&self, polygon: usize, sides: &mut Vec<[u32; 2]>, rounding: f64) -> Result<Outcome, Error> {
        if let [[a, _], [b, _], [c, _]] = sides[..]
            && (0..3).any(|axis| self.points.normal_sign(axis, [a, b, c]).is_ne())
        {
            return Ok(Outcome::Triangles(vec![[a, b, c]]));
        }
        drop_opposite_sides(sides);
        let Some(corners) = self.corners(sides) else {
            return Ok(Outcome::WithoutArea);
        };
        let [p, q, r] = corners;
        let is_off = |vertex: u32| self.points.orientation([p, q, r, vertex]).is_ne();
        let off = sides.iter().map(|side| side[0]).find(|&vertex| is_off(vertex));
        let (normal, middle) = self.normal(sides);
        let mut axes = [0, 1, 2];
        axes.sort_by(|&i: &usize, &j| normal[j].abs().total_cmp(&normal[i].abs()));
        let Some(off) = off else {
            let is_edge_on = |axis: usize| self.points.normal_sign(axis, corners).is_eq();
            let axis = axes.into_iter().find(|&axis| !is_edge_on(axis)).unwrap_or(axes[0]);
            loop {
                match self.triangles(sides, axis) {
                    Ok((own, _)) => return Ok(Outcome::Triangles(own)),
                    // A hole may touch a side from within.
                    Err((TriangulationFault::OnSide { vertex, side }, _))
                        if split_side(sides, side, vertex) => {}
                    Err((fault, view)) => return self.clipped_or(polygon, sides, rounding, fault, view),
                }
                if sides.is_empty() {
                    return Ok(Outcome::WithoutArea);
                }
            }
        };
        let deviation = self.deviation(sides, normal, middle);
        let is_refused = match self.non_planar {
            NonPlanar::Refuse => true,
            NonPlanar::Rounded => deviation > rounding,
            NonPlanar::Split => false,
        };
        if is_refused {
            return Err(Error::invalid(format!(
                "polygon {polygon} is not planar: v{off} is not in the plane of v{p}, v{q} and v{r}; points are up to \
                 {deviation:e} away from a plane"
            ))
            .with_cure("let such polygons be split (--non-planar split), or give triangles"));
        }
        let (own, view) = match self.quadrangle(sides, axes[0]) {
            Some(found) => found,
            None => match self.triangles(sides, axes[0]) {
                Ok(found) => found,
                Err((fault, view)) => return self.clipped_or(polygon, sides, rounding, fault, view),
            },
        };
        Ok(Outcome::Split(own, deviation, view))
    }

    /// Three points that are not on one line.
    fn corners(&self, sides: &[[u32; 2]]) -> Option<[u32; 3]> {
        let &[p, q] = sides.first()?;
        let is_corner = |r: u32| (0..3).any(|axis| self.points.normal_sign(axis, [p, q, r]).is_ne());
        sides.iter().map(|side| side[0]).find(|&r| is_corner(r)).map(|r| [p, q, r])
    }

    /// The vector of twice the area, scaled, and the middle of the points.
    fn normal(&self, sides: &[[u32; 2]]) -> ([f64; 3], [f64; 3]) {
        let origin = self.scaled.origin_at(sides[0][0]);
        let (mut normal, mut middle) = ([0.0; 3], [0.0; 3]);
        for side in sides {
            let [a, b] = side.map(|vertex| self.scaled.relative(vertex, origin));
            let part = cross(a, b);
            for axis in 0..3 {
                normal[axis] += part[axis];
                middle[axis] += a[axis] / sides.len() as f64;
            }
        }
        ([0, 1, 2].map(|axis| normal[axis]), [0, 1, 2].map(|axis| origin[axis] + middle[axis]))
    }

    fn deviation(&self, sides: &[[u32; 2]], normal: [f64; 3], middle: [f64; 3]) -> f64 {
        // Divided first, so that the square of a small normal does not vanish.
        let largest = normal.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let normal = if largest > 0.0 { normal.map(|x| x / largest) } else { [0.0, 0.0, 1.0] };
        let length = dot(normal, normal).sqrt();
        let distance = |side: &[u32; 2]| (dot(self.scaled.relative(side[0], middle), normal) / length).abs();
        self.scaled.unscaled(sides.iter().map(distance).fold(0.0, f64::max), 1)
    }

    /// The triangles of the polygon as seen along an axis, and the picture with the front towards the eye.
    fn triangles(
        &self,
        sides: &[[u32; 2]],
        axis: usize,
    ) -> Result<Seen<Vec<[u32; 3]>>, Seen<TriangulationFault>> {
        let mut view = AxisView { axis: axis as u8, from: Sign::Plus };
        if self.is_clockwise(sides, view) {
            view = view.behind();
        }
        let compare = |a: u32, b: u32| view.compare(self.points, a, b);
        let turn = |a: u32, b: u32, c: u32| view.turn(self.points, [a, b, c]);
        let is_walk =
            sides.len() < 5 && sides.iter().zip(sides.iter().cycle().skip(1)).all(|(s, t)| s[1] == t[0]);
        let found = if is_walk {
            let walk: Vec<u32> = sides.iter().map(|side| side[0]).collect();
            triangulate(&[walk], compare, turn)
        } else {
            triangulate_sides(sides, compare, turn)
        };
        match found {
            Ok(own) => Ok((own, view)),
            Err(fault) => Err((fault, view)),
        }
    }

    /// The polygon as [`Self::clipped`] has it, or the fault.
    fn clipped_or(
        &self,
        polygon: usize,
        sides: &[[u32; 2]],
        rounding: f64,
        fault: TriangulationFault,
        view: AxisView,
    ) -> Result<Outcome, Error> {
        let is_wrong = matches!(fault, TriangulationFault::RepeatedSide(_) | TriangulationFault::WrongWay(_));
        if is_wrong || sides.len() > MOST_CLIPPED || loops(sides).len() > 1 {
            return Err(self.fault(polygon, fault, view));
        }
        match self.clipped(sides, rounding, view) {
            Some(own) if own.is_empty() => Ok(Outcome::WithoutArea),
            Some(own) => Ok(Outcome::Apart(own)),
            None => Err(self.fault(polygon, fault, view)),
        }
    }

    /// Triangles that have these sides together, for sides that cross or touch by as little as rounding explains: ears are
    /// cut off as seen in the picture, and thin corners, be they ears or not, where there is no other. `None` if a
    /// corner that is not thin would have to go.
    ///
    /// # References
    /// G. H. Meisters, *Polygons have ears* (1975).
    fn clipped(&self, sides: &[[u32; 2]], rounding: f64, view: AxisView) -> Option<Vec<[u32; 3]>> {
        let turn = |triangle: [u32; 3]| view.turn(self.points, triangle);
        let is_thin = |triangle: [u32; 3]| self.height(triangle) <= rounding;
        let mut own = Vec::new();
        for mut ring in loops(sides) {
            let front = if self.area_in(&ring, view) < 0.0 { Ordering::Less } else { Ordering::Greater };
            while ring.len() > 2 {
                let count = ring.len();
                let corner = |i: usize| [ring[(i + count - 1) % count], ring[i], ring[(i + 1) % count]];
                let is_in = |vertex: u32, [a, b, c]: [u32; 3]| {
                    let turns = [[a, b, vertex], [b, c, vertex], [c, a, vertex]].map(turn);
                    turns.iter().all(|&turn| turn == front || turn.is_eq())
                };
                let is_ear = |own: [u32; 3]| {
                    turn(own) == front
                        && !is_thin(own)
                        && ring.iter().all(|&vertex| own.contains(&vertex) || !is_in(vertex, own))
                };
                let ear = (0..count).find(|&i| is_ear(corner(i)));
                let at = ear.or_else(|| (0..count).find(|&i| is_thin(corner(i))))?;
                let triangle = corner(at);
                if (0..3).any(|axis| self.points.normal_sign(axis, triangle).is_ne()) {
                    own.push(triangle);
                }
                ring.remove(at);
            }
        }
        Some(own)
    }

    /// Twice the area of a walk in the picture, rounded.
    fn area_in(&self, walk: &[u32], view: AxisView) -> f64 {
        let axis = usize::from(view.axis);
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        let origin = self.scaled.origin_at(walk[0]);
        let sum: f64 = walk
            .iter()
            .zip(walk.iter().cycle().skip(1))
            .map(|(&a, &b)| {
                let (a, b) = (self.scaled.relative(a, origin), self.scaled.relative(b, origin));
                a[i] * b[j] - a[j] * b[i]
            })
            .sum();
        if view.from == Sign::Plus { sum } else { -sum }
    }

    /// The least height of a triangle, rounded, in the unit of the positions.
    fn height(&self, [a, b, c]: [u32; 3]) -> f64 {
        let origin = self.scaled.origin_at(a);
        let [u, v] = [b, c].map(|vertex| self.scaled.relative(vertex, origin));
        let w = [0, 1, 2].map(|i| v[i] - u[i]);
        let longest = [u, v, w].into_iter().map(|side| dot(side, side)).fold(0.0, f64::max).sqrt();
        let normal = cross(u, v);
        let height = if longest > 0.0 { dot(normal, normal).sqrt() / longest } else { 0.0 };
        self.scaled.unscaled(height, 1)
    }

    /// The two triangles on the sides of the shorter diagonal of a quadrangle, or of the one that is inside of it. The
    /// choice depends on the places of the corners alone, so that a quadrangle that is there twice is split once.
    fn quadrangle(&self, sides: &[[u32; 2]], axis: usize) -> Option<Seen<Vec<[u32; 3]>>> {
        let &[[a, _], [b, _], [c, _], [d, _]] = sides else { return None };
        if !sides.iter().zip(sides.iter().cycle().skip(1)).all(|(side, next)| side[1] == next[0]) {
            return None;
        }
        let mut view = AxisView { axis: axis as u8, from: Sign::Plus };
        if self.is_clockwise(sides, view) {
            view = view.behind();
        }
        let length = |a: u32, b: u32| {
            let (a, b) = (self.point(a), self.point(b));
            dot([0, 1, 2].map(|i| a[i] - b[i]), [0, 1, 2].map(|i| a[i] - b[i]))
        };
        let first = [a, b, c, d].into_iter().min_by(|&x, &y| {
            self.point(x)
                .iter()
                .zip(&self.point(y))
                .map(|(x, y)| x.total_cmp(y))
                .find(|order| order.is_ne())
                .unwrap_or(Ordering::Equal)
        })?;
        let order = length(a, c).total_cmp(&length(b, d));
        let takes_first =
            order.then(if first == a || first == c { Ordering::Less } else { Ordering::Greater }).is_le();
        let mut splits = [vec![[a, b, c], [a, c, d]], vec![[a, b, d], [b, c, d]]];
        if !takes_first {
            splits.reverse();
        }
        let is_inside =
            |split: &Vec<[u32; 3]>| split.iter().all(|&own| view.turn(self.points, own) == Ordering::Greater);
        splits.into_iter().find(is_inside).map(|own| (own, view))
    }

    /// Whether the outermost two sides at the lexicographically least vertex run clockwise.
    fn is_clockwise(&self, sides: &[[u32; 2]], view: AxisView) -> bool {
        let ends = sides.iter().map(|side| side[0]);
        let Some(lowest) = ends.min_by(|&a, &b| view.compare(self.points, a, b)) else { return false };
        let mut around: Vec<(u32, bool)> = Vec::new();
        for &[a, b] in sides {
            if a == lowest {
                around.push((b, true));
            } else if b == lowest {
                around.push((a, false));
            }
        }
        let turn = |x: &(u32, bool), y: &(u32, bool)| view.turn(self.points, [lowest, x.0, y.0]);
        around.iter().min_by(|x, y| turn(x, y).reverse()).is_some_and(|first| !first.1)
    }

    /// What is wrong with a polygon, and where.
    fn fault(&self, polygon: usize, fault: TriangulationFault, view: AxisView) -> Error {
        let place = match fault {
            TriangulationFault::Crossing(sides) => self.crossing(sides, view),
            TriangulationFault::OnSide { vertex, .. } | TriangulationFault::WrongWay(vertex) => {
                self.point(vertex)
            }
            TriangulationFault::SamePlace([vertex, _])
            | TriangulationFault::RepeatedSide([vertex, _])
            | TriangulationFault::NoLength(vertex) => self.point(vertex),
        };
        let [x, y, z] = place;
        Error::invalid(format!("polygon {polygon} is not simple at ({x}, {y}, {z}): {fault}"))
            .with_cure(fault.cure())
    }

    fn point(&self, vertex: u32) -> [f64; 3] {
        let point = self.positions.point(VertexId::from_u32(vertex));
        [point[0], point[1], point[2]]
    }

    /// Where the first side meets the second in the picture, nearly.
    fn crossing(&self, [s, t]: [[u32; 2]; 2], view: AxisView) -> [f64; 3] {
        let origin = self.scaled.origin_at(t[0]);
        let [a, b] = s.map(|vertex| self.scaled.relative(vertex, origin));
        let direction = self.scaled.relative(t[1], origin);
        let (i, j) = ((usize::from(view.axis) + 1) % 3, (usize::from(view.axis) + 2) % 3);
        let side = |point: [f64; 3]| direction[i] * point[j] - direction[j] * point[i];
        let (from, to) = (side(a), side(b));
        let part = if from == to { 0.0 } else { (from / (from - to)).clamp(0.0, 1.0) };
        let [a, b] = s.map(|vertex| self.point(vertex));
        [0, 1, 2].map(|axis| a[axis] * (1.0 - part) + b[axis] * part)
    }
}

/// Closed walks along all of these sides.
fn loops(sides: &[[u32; 2]]) -> Vec<Vec<u32>> {
    let mut is_used = vec![false; sides.len()];
    let mut loops = Vec::new();
    for first in 0..sides.len() {
        let (mut walk, mut at) = (Vec::new(), Some(first).filter(|&side| !is_used[side]));
        while let Some(side) = at {
            is_used[side] = true;
            walk.push(sides[side][0]);
            // The sides of one walk mostly follow each other.
            let order = (side + 1..sides.len()).chain(0..side);
            at = order.filter(|&next| !is_used[next]).find(|&next| sides[next][0] == sides[side][1]);
        }
        if !walk.is_empty() {
            loops.push(walk);
        }
    }
    loops
}

/// Puts a vertex on a side, in whichever directions that is there. Whether it is there at all.
fn split_side(sides: &mut Vec<[u32; 2]>, [a, b]: [u32; 2], vertex: u32) -> bool {
    let count = sides.len();
    for i in 0..count {
        let [from, to] = sides[i];
        if [from, to] == [a, b] || [from, to] == [b, a] {
            sides[i] = [from, vertex];
            sides.push([vertex, to]);
        }
    }
    let is_there = sides.len() > count;
    drop_opposite_sides(sides);
    is_there
}

/// Takes pairs of sides in opposite directions away: bridges to holes, and spikes.
fn drop_opposite_sides(sides: &mut Vec<[u32; 2]>) {
    let mut order: Vec<([u32; 2], bool, u32)> =
        (0..).zip(sides.iter()).map(|(i, &[a, b])| ([a.min(b), a.max(b)], a > b, i)).collect();
    order.sort_unstable();
    let mut dropped = Vec::new();
    for own in order.chunk_by(|x, y| x.0 == y.0) {
        let forward = own.partition_point(|side| !side.1);
        for (x, y) in own[..forward].iter().zip(&own[forward..]) {
            dropped.extend([x.2, y.2]);
        }
    }
    if dropped.is_empty() {
        return;
    }
    dropped.sort_unstable();
    let mut next = 0;
    sides.retain(|_| {
        next += 1;
        dropped.binary_search(&(next - 1)).is_err()
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygons(flat: &[f64], lists: &[&[u32]], polygon_of_walk: &[u32]) -> SpatialPolygons {
        let positions = Positions::from_flat(3, flat.to_vec()).unwrap();
        SpatialPolygons::new(positions, RaggedArray::from_lists(lists), polygon_of_walk.to_vec()).unwrap()
    }

    /// A square with a smaller one inside, in the plane x = 2.
    const SQUARES: [f64; 24] =
        [2., 0., 0., 2., 4., 0., 2., 4., 4., 2., 0., 4., 2., 1., 1., 2., 3., 1., 2., 3., 3., 2., 1., 3.];

    /// An edge of the square has two vertices that are one in the picture, and a spike that comes back one unit beside itself.
    #[test]
    fn sides_that_cross_by_rounding_are_taken_apart() {
        let unit = f64::EPSILON;
        let flat = [
            0.,
            0.,
            1.,
            1.,
            0.,
            1.,
            1.,
            0.5,
            1.,
            1.,
            0.5,
            1. + unit,
            1.,
            1.,
            1.,
            0.5,
            1.,
            1.,
            0.75,
            1. - unit,
            1.,
            0.5,
            1. + unit,
            1.,
            0.,
            1.,
            1.,
        ];
        let own = polygons(&flat, &[&[0, 1, 2, 3, 4, 5, 6, 7, 8]], &[0]);
        let found = PolygonTriangles::new(&own, NonPlanar::Split).unwrap();
        assert_eq!(found.apart, [0]);
        // Together they have the sides of the polygon, but for those that lie on each other.
        let point = |v: u32| &flat[3 * v as usize..][..3];
        let area: f64 = found
            .triangles
            .iter()
            .map(|t| t.map(point))
            .map(|[a, b, c]| ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2.0)
            .sum();
        assert!((area - 1.0).abs() < 4.0 * unit, "{area}");
        // The same by a thousand units is no rounding.
        let far = flat.map(|x| if (x - 1.0).abs() < 2.0 * unit { 1.0 + 1000.0 * (x - 1.0) } else { x });
        let message =
            PolygonTriangles::new(&polygons(&far, &[&[0, 1, 2, 3, 4, 5, 6, 7, 8]], &[0]), NonPlanar::Split);
        assert!(message.unwrap_err().to_string().contains("polygon 0 is not simple"));
    }

    #[test]
    fn holes_may_be_walks_or_bridged() {
        for fronts in [false, true] {
            let turned = |mut list: Vec<u32>| {
                if fronts {
                    list.reverse();
                }
                list
            };
            let (outer, hole) = (turned(vec![0, 1, 2, 3]), turned(vec![7, 6, 5, 4]));
            let bridged = turned(vec![0, 1, 2, 3, 0, 4, 7, 6, 5, 4]);
            for (walks, owners) in [(vec![&outer[..], &hole], vec![0, 0]), (vec![&bridged[..]], vec![0])] {
                let own = polygons(&SQUARES, &walks, &owners);
                let found = PolygonTriangles::new(&own, NonPlanar::Refuse).unwrap();
                assert_eq!(found.triangles.len(), 8);
                // All of them have the normal of the outer walk.
                let points = GivenPoints::new(own.positions()).unwrap();
                let normal = if fronts { Ordering::Less } else { Ordering::Greater };
                assert!(found.triangles.iter().all(|&own| points.normal_sign(0, own) == normal));
            }
        }
    }

    #[test]
    fn faults_name_polygon_place_and_sides() {
        let refused = |flat: &[f64], lists: &[&[u32]], owners: &[u32], non_planar| {
            PolygonTriangles::new(&polygons(flat, lists, owners), non_planar).unwrap_err().to_string()
        };
        assert_eq!(
            refused(&SQUARES, &[&[4, 5, 6], &[0, 1, 3, 2]], &[0, 1], NonPlanar::Split),
            "polygon 1 is not simple at (2, 2, 2): the side of v0 and v2 crosses the side of v3 and v1; cut the \
             polygon where its sides cross"
        );
        assert!(
            refused(&SQUARES, &[&[0, 1, 2, 3], &[4, 5, 6, 7]], &[0, 0], NonPlanar::Refuse)
                .ends_with("let outer walks run counterclockwise and holes clockwise")
        );
        let mut bent = SQUARES;
        bent[6] = 2.5;
        let message = refused(&bent, &[&[4, 5, 6, 7], &[0, 1, 2, 3]], &[0, 1], NonPlanar::Refuse);
        assert!(message.starts_with("polygon 1 is not planar: v"), "{message}");
        let split = PolygonTriangles::new(
            &polygons(&bent, &[&[4, 5, 6, 7], &[0, 1, 2, 3]], &[0, 1]),
            NonPlanar::Split,
        )
        .unwrap();
        assert_eq!(split.polygon_of_triangle, [0, 0, 1, 1]);
        let deviation = split.split[0].0.deviation;
        assert_eq!(split.split[0].0.polygon, 1);
        assert!(deviation > 0.1 && deviation < 0.2, "{deviation}");
    }

    #[test]
    fn holes_may_touch_sides_and_spikes_go() {
        // A triangle that touches two sides of the square from within, and a spike along a third side and beyond.
        let mut flat = SQUARES.to_vec();
        flat.extend([2., 0., 2., 2., 2., 0., 2., 4., -3.]);
        let own = polygons(&flat, &[&[0, 1, 10, 1, 2, 3], &[8, 5, 9]], &[0, 0]);
        let found = PolygonTriangles::new(&own, NonPlanar::Refuse).unwrap();
        assert_eq!(found.triangles.len(), 5);
        let area: f64 = found
            .triangles
            .iter()
            .map(|&[a, b, c]| {
                let [a, b, c] = [a, b, c].map(|v| own.positions().point(VertexId::from_u32(v)));
                (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])
            })
            .sum();
        // Twice the square, without twice the triangle (0, 2), (3, 1), (2, 0).
        assert_eq!(area, 32.0 - 4.0);
    }

    #[test]
    fn polygons_without_area_are_told() {
        let flat = [0., 0., 0., 1., 1., 1., 2., 2., 2., 0., 0., 0.];
        let found = PolygonTriangles::new(
            &polygons(&flat, &[&[0, 1], &[0, 1, 2], &[0, 1, 2, 1], &[0, 3, 0], &[1]], &[0, 1, 2, 3, 4]),
            NonPlanar::Refuse,
        )
        .unwrap();
        assert_eq!(found.without_area, [0, 1, 2, 3, 4]);
        assert!(found.triangles.is_empty());
        let triangles = polygons(&flat, &[&[0, 1, 2]], &[0]);
        assert_eq!(PolygonTriangles::new(&triangles, NonPlanar::Refuse).unwrap().without_area, [0]);
    }
}
