//! Čech complexes: simplices with the radii of smallest balls.

use super::flag::{FlagLimit, bytes_of_simplex, most_simplices};
use super::{FilteredComplex, WeightedGraph};
use crate::simplicial::{FrozenComplex, FrozenLevels};
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_geometry::{Positions, distance};
use rayon::prelude::*;

impl FilteredComplex {
    /// The Čech complex of points of any dimension up to a radius and a dimension: a simplex for each set of points in a ball of this radius, which enters at the
    /// radius of the smallest such ball, as in GUDHI's `Cech_complex`.
    ///
    /// At a value it is the nerve of the balls of this radius around the points, and has the homotopy type of their union. Radii are computed with rounding: each
    /// is that of the smallest ball of a facet if it holds the point that is left, and else that of the sphere through all, which is kept between the
    /// radii of the facets and those of their balls blown up to hold the point that is left. So the relative error is about the rounding of squared distances, 1e-15, times the
    /// number of points, also where points are nearly dependent. No simplex enters before its faces.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a radius that is negative or no number. [`ErrorKind::TooLarge`] as for [`Self::flag`].
    ///
    /// # Complexity
    /// $O(k^3 + k d)$ for each set of $k + 1$ points in dimension d whose facets are in the complex.
    ///
    /// # References
    /// H. Edelsbrunner, J. Harer, *Computational Topology* (2010), section III.2.
    ///
    /// # Examples
    /// A triangle with the sides 6, 8 and 10, and the center of its circle.
    /// ```
    /// use coface_complexes::filtered::FilteredComplex;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 6., 0., 0., 8.])?;
    /// let cech = FilteredComplex::cech(&corners, 5.0, 2)?;
    /// assert_eq!((cech.values(1), cech.values(2)), (&[3., 4., 5.][..], &[5.][..]));
    /// assert_eq!(FilteredComplex::cech(&corners, 4.0, 2)?.complex().f_vector(), [3, 2]);
    /// # Ok(()) }
    /// ```
    pub fn cech(points: &Positions, radius: f64, dimension: usize) -> Result<Self, Error> {
        if radius.is_nan() || radius < 0.0 {
            return Err(Error::invalid(format!("the radius is {radius}, and radii are not negative"))
                .with_cure("give a radius of 0 or more"));
        }
        // With its smallest ball.
        let most = most_simplices(bytes_of_simplex(dimension) + 150 + 8 * points.dimension() as u64);
        let points: Vec<&[f64]> = (0..points.len()).map(|id| points.point(VertexId::new(id))).collect();
        let steps = stage("finding smallest balls", dimension);
        let mut levels = vec![Level::of_points(&points)];
        let mut count = points.len();
        for _ in steps.each(0..dimension) {
            let last = levels.last().expect("the points");
            let foretold = last.foretold_cofacets(&points, radius);
            if foretold > 2.0 * most as f64 {
                return Err(too_many(&points, radius, dimension, most, Some(foretold)));
            }
            let next = last.cofacets(&points, radius, most.saturating_sub(count));
            let Some(next) = next.filter(|_| count <= most) else {
                return Err(too_many(&points, radius, dimension, most, None));
            };
            if next.values.is_empty() {
                break;
            }
            count += next.values.len();
            levels.last_mut().expect("the points").centers = Vec::new();
            levels.push(next);
        }
        Ok(assembled(levels))
    }
}

/// A radius from which on balls around all points have a common point, so that nothing changes in the Čech complex: the smallest radius of a ball that holds all
/// points, or little more.
///
/// # Complexity
/// $O(n d)$ for n points in dimension d.
///
/// # References
/// M. Bădoiu, K. Clarkson, *Smaller core-sets for balls* (2003).
///
/// # Examples
/// ```
/// use coface_complexes::filtered::enclosing_ball_radius;
/// use coface_geometry::Positions;
/// let ends = Positions::from_flat(1, vec![0.0, 6.0]).expect("two points");
/// assert!((3.0..3.1).contains(&enclosing_ball_radius(&ends)));
/// ```
pub fn enclosing_ball_radius(points: &Positions) -> f64 {
    let points: Vec<&[f64]> = (0..points.len()).map(|id| points.point(VertexId::new(id))).collect();
    let Some(&first) = points.first() else { return 0.0 };
    let mut center = first.to_vec();
    let mut least = f64::INFINITY;
    for step in 1..=200 {
        let distances = points.iter().map(|point| (distance(point, &center), *point));
        let (far, point) = distances.max_by(|a, b| a.0.total_cmp(&b.0)).expect("there are points");
        least = least.min(far);
        for (coordinate, &other) in center.iter_mut().zip(point) {
            *coordinate += (other - *coordinate) / f64::from(step + 1);
        }
    }
    // Enough for rounding.
    least * (1.0 + 1e-12)
}

/// So many simplices of a degree are looked at to find about how many the next one has.
const SAMPLE: usize = 200;

/// The simplices of a degree in lexicographic order.
struct Level {
    degree: usize,
    tuples: Vec<u32>,
    /// Radii.
    values: Vec<f64>,
    /// Centers of the smallest balls, one after the other.
    centers: Vec<f64>,
    /// Where simplices with each first vertex begin.
    starts: Vec<usize>,
}

/// A ball that holds points.
struct Ball {
    center: Vec<f64>,
    radius: f64,
}

impl Level {
    fn of_points(points: &[&[f64]]) -> Self {
        let tuples = (0..points.len() as u32).collect();
        let centers = points.concat();
        Self::new(0, points.len(), tuples, vec![0.0; points.len()], centers)
    }

    fn new(degree: usize, point_count: usize, tuples: Vec<u32>, values: Vec<f64>, centers: Vec<f64>) -> Self {
        let mut starts = vec![0; point_count + 1];
        for tuple in tuples.chunks_exact(degree + 1) {
            starts[tuple[0] as usize + 1] += 1;
        }
        for point in 0..point_count {
            starts[point + 1] += starts[point];
        }
        Self { degree, tuples, values, centers, starts }
    }

    fn tuple(&self, i: usize) -> &[u32] {
        &self.tuples[i * (self.degree + 1)..][..=self.degree]
    }

    fn center(&self, i: usize, dimension: usize) -> &[f64] {
        &self.centers[i * dimension..][..dimension]
    }

    /// The place of a simplex.
    fn place(&self, tuple: &[u32]) -> Option<usize> {
        let (start, end) = (self.starts[tuple[0] as usize], self.starts[tuple[0] as usize + 1]);
        let (mut low, mut high) = (start, end);
        while low < high {
            let middle = low.midpoint(high);
            if self.tuple(middle) < tuple {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        (low < end && self.tuple(low) == tuple).then_some(low)
    }

    /// About how many simplices the next degree has up to a radius, as some spread evenly show.
    fn foretold_cofacets(&self, points: &[&[f64]], radius: f64) -> f64 {
        let count = self.values.len();
        let step = count.div_ceil(SAMPLE).max(1);
        let sample: Vec<usize> = (0..count).step_by(step).collect();
        let found: usize = sample.par_iter().map(|&i| self.cofacets_of(i, points, radius).count()).sum();
        found as f64 / sample.len().max(1) as f64 * count as f64
    }

    /// The simplices of the next degree up to a radius; `None` if there are more than `most`.
    fn cofacets(&self, points: &[&[f64]], radius: f64, most: usize) -> Option<Self> {
        let count = self.values.len();
        let found: Vec<(Vec<u32>, Ball)> = (0..count)
            .into_par_iter()
            .flat_map_iter(|i| self.cofacets_of(i, points, radius))
            .take_any(most.saturating_add(1))
            .collect();
        if found.len() > most {
            return None;
        }
        let (mut tuples, mut values, mut centers) = (Vec::new(), Vec::new(), Vec::new());
        for (tuple, ball) in found {
            tuples.extend(tuple);
            values.push(ball.radius);
            centers.extend(ball.center);
        }
        Some(Self::new(self.degree + 1, points.len(), tuples, values, centers))
    }

    /// The simplices that add a last vertex to simplex i: those whose facets are all there.
    fn cofacets_of<'a>(
        &'a self,
        i: usize,
        points: &'a [&'a [f64]],
        radius: f64,
    ) -> impl Iterator<Item = (Vec<u32>, Ball)> + 'a {
        let siblings = self.siblings(i, points.len());
        siblings.filter_map(move |last| {
            let mut tuple = self.tuple(i).to_vec();
            tuple.push(last);
            let ball = self.ball(&tuple, i, points)?;
            (ball.radius <= radius).then_some((tuple, ball))
        })
    }

    /// The vertices that may come behind simplex i: those behind its first vertices.
    fn siblings(&self, i: usize, point_count: usize) -> impl Iterator<Item = u32> + '_ {
        let tuple = self.tuple(i);
        let is_point = self.degree == 0;
        let behind = if is_point { tuple[0] + 1..point_count as u32 } else { 0..0 };
        let first = &tuple[..self.degree];
        let rest = (i + 1..self.values.len())
            .take_while(move |&other| !is_point && self.tuple(other)[..self.degree] == *first);
        behind.chain(rest.map(|other| self.tuple(other)[self.degree]))
    }

    /// The smallest ball of a simplex, whose facet without the last vertex has the place `first`; `None` if a facet is not there.
    fn ball(&self, tuple: &[u32], first: usize, points: &[&[f64]]) -> Option<Ball> {
        let dimension = points.first().map_or(0, |point| point.len());
        let mut below = 0.0f64;
        let mut above = (f64::INFINITY, 0);
        let mut facet = Vec::with_capacity(tuple.len());
        for left in 0..tuple.len() {
            let place = if left + 1 == tuple.len() {
                first
            } else {
                facet.clear();
                facet.extend(
                    tuple.iter().enumerate().filter(|&(at, _)| at != left).map(|(_, &vertex)| vertex),
                );
                self.place(&facet)?
            };
            let own = self.values[place];
            below = below.max(own);
            let reach = distance(points[tuple[left] as usize], self.center(place, dimension)).max(own);
            if reach < above.0 {
                above = (reach, place);
            }
        }
        let blown = || Ball { center: self.center(above.1, dimension).to_vec(), radius: above.0.max(below) };
        if above.0 <= below * (1.0 + 1e-15) {
            return Some(Ball { radius: below, ..blown() });
        }
        let corners: Vec<&[f64]> = tuple.iter().map(|&vertex| points[vertex as usize]).collect();
        match circumsphere(&corners) {
            Some(ball) if ball.radius <= above.0 => Some(Ball { radius: ball.radius.max(below), ..ball }),
            _ => Some(blown()),
        }
    }
}

/// The smallest sphere through points; `None` if they are dependent.
fn circumsphere(points: &[&[f64]]) -> Option<Ball> {
    let (&first, rest) = points.split_first()?;
    let count = rest.len();
    let mut edges: Vec<Vec<f64>> =
        rest.iter().map(|point| point.iter().zip(first).map(|(x, y)| x - y).collect()).collect();
    // Fourth powers of lengths are compared: far from 1 they are none of a number.
    let longest = edges.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    let scale = 2f64.powi(match longest {
        0.0..1e-70 => 600,
        1e-70..1e70 => 0,
        _ => -600,
    });
    edges.iter_mut().flatten().for_each(|x| *x *= scale);
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    // The center is first + sum of x_i edge_i with 2 <edge_i, edge_j> x_j = <edge_i, edge_i>.
    let mut rows: Vec<Vec<f64>> = (0..count)
        .map(|i| {
            let products = (0..count).map(|j| 2.0 * dot(&edges[i], &edges[j]));
            products.chain([dot(&edges[i], &edges[i])]).collect()
        })
        .collect();
    for column in 0..count {
        let pivot =
            (column..count).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()))?;
        rows.swap(column, pivot);
        if rows[column][column] == 0.0 {
            return None;
        }
        let (above, below) = rows.split_at_mut(column + 1);
        let pivot = &above[column];
        for row in below {
            let factor = row[column] / pivot[column];
            row.iter_mut().zip(pivot).skip(column).for_each(|(entry, part)| *entry -= factor * part);
        }
    }
    let mut solution = vec![0.0; count];
    for row in (0..count).rev() {
        let known: f64 = (row + 1..count).map(|at| rows[row][at] * solution[at]).sum();
        solution[row] = (rows[row][count] - known) / rows[row][row];
    }
    let mut center = first.to_vec();
    for (edge, &x) in edges.iter().zip(&solution) {
        center.iter_mut().zip(edge).for_each(|(coordinate, along)| *coordinate += x * along / scale);
    }
    // Of all distances the largest: the ball holds all points.
    let radius = points.iter().map(|point| distance(point, &center)).fold(0.0, f64::max);
    radius.is_finite().then_some(Ball { center, radius })
}

fn assembled(levels: Vec<Level>) -> FilteredComplex {
    let mut all = FrozenLevels::default();
    let mut places: Vec<usize> = vec![0; levels.len()];
    // Depth first: a simplex, then those that begin with it.
    let mut path: Vec<u32> = Vec::new();
    loop {
        // The simplex of the next degree if it begins with the path, else back.
        let degree = path.len();
        let next = levels.get(degree).filter(|level| places[degree] < level.values.len());
        match next.map(|level| level.tuple(places[degree])).filter(|tuple| tuple[..degree] == path[..]) {
            Some(tuple) => {
                all.push(tuple);
                places[degree] += 1;
                path.push(tuple[degree]);
            }
            None if path.is_empty() => break,
            None => {
                path.pop();
            }
        }
    }
    let values = levels.into_iter().map(|level| level.values).filter(|values| !values.is_empty()).collect();
    FilteredComplex::from_trusted_parts(FrozenComplex::from_levels(all), values)
}

/// The error of more simplices than there may be, or than are foretold. Twice a radius up to which the Vietoris-Rips complex fits is enough.
fn too_many(points: &[&[f64]], radius: f64, dimension: usize, most: usize, foretold: Option<f64>) -> Error {
    let count = foretold.map_or(format!("more than {most}"), |foretold| format!("about {foretold:.0}"));
    let message = format!(
        "the Čech complex of {} points up to dimension {dimension} has {count} simplices at the radius {radius}, and there is room for {most}",
        points.len()
    );
    let error = Error::new(ErrorKind::TooLarge, message);
    let mut edges = Vec::new();
    for i in 0..points.len() {
        for j in 0..i {
            let length = distance(points[i], points[j]);
            if length <= 2.0 * radius {
                edges.push((i as u32, j as u32, length));
            }
        }
    }
    let graph = WeightedGraph::from_trusted_parts(vec![0.0; points.len()], edges);
    match FlagLimit::of(&graph, dimension, most) {
        Some(limit) => {
            let fitting = limit.threshold / 2.0;
            error.with_cure(format!(
                "ask for a radius of {fitting} or less (--threshold {fitting}), with at most {} simplices, for a lower dimension, or allow more memory",
                limit.count
            ))
        }
        None => error.with_cure("ask for a lower dimension, take fewer points, or allow more memory"),
    }
}
