//! Winding numbers of surfaces that need not be closed.

use coface_algebra::Error;
use coface_algebra::VertexId;
use coface_algebra::progress::stage;
use coface_geometry::{Positions, Sum, cross, determinant, dot};
use rayon::prelude::*;
use std::f64::consts::PI;

/// How often a surface of triangles winds around each of several points in space, in floating point.
///
/// The winding number around a point is the sum of the solid angles of the triangles seen from it, divided by $4 \pi$:
/// positive where a triangle runs clockwise seen from the point, so that surfaces whose triangles run counterclockwise
/// seen from outside wind once around what they enclose. For a closed surface it is an integer; for one with holes it
/// falls smoothly from about 1 to about 0 across them, and 1/2 is a fair place to call the border.
///
/// # Errors
/// [`coface_algebra::ErrorKind::Shape`] unless surface and points have three coordinates;
/// [`coface_algebra::ErrorKind::NotInComplex`] for a triangle with a vertex that is not there.
///
/// # Complexity
/// The number of points times that of triangles, parallel over points.
///
/// # References
/// A. Jacobson, L. Kavan, O. Sorkine-Hornung, *Robust inside-outside segmentation using generalized winding numbers*
/// (2013); A. van Oosterom, J. Strackee, *The solid angle of a plane triangle* (1983).
///
/// # Examples
/// A tetrahedron without its base, from near its top and from far away:
/// ```
/// use coface_arrange::boolean::generalized_winding_numbers;
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let flat = vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.];
/// let corners = Positions::from_flat(3, flat)?;
/// let points = Positions::from_flat(3, vec![0.05, 0.05, 0.8, 0.0, 0.0, 90.0])?;
/// let open = [[0, 1, 3], [1, 2, 3], [2, 0, 3]];
/// let around = generalized_winding_numbers(&corners, &open, &points)?;
/// assert!(around[0] > 0.9 && around[1].abs() < 0.01);
/// let closed = [[0, 1, 3], [1, 2, 3], [2, 0, 3], [2, 1, 0]];
/// let around = generalized_winding_numbers(&corners, &closed, &points)?;
/// assert!((around[0] - 1.0).abs() < 1e-12 && around[1].abs() < 1e-12);
/// # Ok(()) }
/// ```
pub fn generalized_winding_numbers(
    positions: &Positions,
    triangles: &[[u32; 3]],
    points: &Positions,
) -> Result<Vec<f64>, Error> {
    check_space(positions)?;
    check_space(points)?;
    if let Some(corner) = triangles.as_flattened().iter().find(|&&corner| corner as usize >= positions.len())
    {
        return Err(Error::new(
            coface_algebra::ErrorKind::NotInComplex,
            format!("there is no point v{corner}; there are {}", positions.len()),
        ));
    }
    let steps = stage("summing angles", points.len());
    let number = |i: usize| {
        steps.advance(1);
        let here = point(points, i as u32);
        let mut sum = Sum::default();
        for triangle in triangles {
            sum.add(solid_angle(triangle.map(|corner| direction(here, point(positions, corner)))));
        }
        sum.value() / (4.0 * PI)
    };
    Ok((0..points.len()).into_par_iter().map(number).collect())
}

/// A point inside a cell whose boundary is these triangles, counterclockwise seen from outside, in floating point: from
/// the middle of the triangle with the largest area halfway to where a line straight inward leaves the cell. `None` if
/// rounding finds none, as in cells that are thinner than coordinates tell apart.
///
/// # Panics
/// If a triangle has a vertex without three coordinates.
///
/// # Complexity
/// Linear in the triangles, for each of the few largest that are tried.
///
/// # Examples
/// ```
/// use coface_arrange::boolean::point_inside;
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let corners = Positions::from_flat(3, vec![0., 0., 0., 3., 0., 0., 0., 3., 0., 0., 0., 3.])?;
/// let tetrahedron = [[0, 1, 3], [1, 2, 3], [2, 0, 3], [2, 1, 0]];
/// let inside = point_inside(&corners, &tetrahedron).expect("a fat tetrahedron");
/// assert!(inside.iter().all(|&x| x > 0.0) && inside.iter().sum::<f64>() < 3.0);
/// # Ok(()) }
/// ```
pub fn point_inside(positions: &Positions, triangles: &[[u32; 3]]) -> Option<[f64; 3]> {
    const TRIES: usize = 8;
    // All in units of the box of the cell, so that products stay in the range of numbers.
    let corners = || triangles.as_flattened().iter().map(|&corner| point(positions, corner));
    let first = corners().next()?;
    let largest = |size: f64, p: [f64; 3]| {
        (0..3).map(|axis| (p[axis] / 2.0 - first[axis] / 2.0).abs()).fold(size, f64::max)
    };
    let size = corners().fold(0.0, largest);
    if size == 0.0 {
        return None;
    }
    let local = |corner: u32| {
        let p = point(positions, corner);
        [0, 1, 2].map(|axis| (p[axis] / 2.0 - first[axis] / 2.0) / size)
    };
    let local: Vec<[[f64; 3]; 3]> = triangles.iter().map(|triangle| triangle.map(local)).collect();
    let normal = |[a, b, c]: [[f64; 3]; 3]| cross(minus(b, a), minus(c, a));
    let mut order: Vec<(f64, usize)> =
        local.iter().enumerate().map(|(i, &triangle)| (norm(normal(triangle)), i)).collect();
    order.sort_by(|x, y| y.0.total_cmp(&x.0).then(x.1.cmp(&y.1)));
    for &(area, i) in order.iter().take(TRIES).filter(|(area, _)| *area > 0.0) {
        let [a, b, c] = local[i];
        let start = [0, 1, 2].map(|axis| (a[axis] + b[axis] + c[axis]) / 3.0);
        let inward = normal(local[i]).map(|x| -x / area);
        let nearest = (0..local.len())
            .filter(|&other| other != i)
            .filter_map(|other| distance(start, inward, local[other]))
            .min_by(f64::total_cmp);
        if let Some(length) = nearest.filter(|&length| length > 0.0) {
            let middle = [0, 1, 2].map(|axis| {
                let at = start[axis] + inward[axis] * length / 2.0;
                (first[axis] / 2.0 + at * size) * 2.0
            });
            return middle.iter().all(|x| x.is_finite()).then_some(middle);
        }
    }
    None
}

/// How far along a direction of length 1 a triangle is hit.
fn distance(start: [f64; 3], direction: [f64; 3], [a, b, c]: [[f64; 3]; 3]) -> Option<f64> {
    let [a, b, c] = [a, b, c].map(|corner| minus(corner, start));
    // Volumes with the edges: all of one sign where the line runs through the triangle.
    let volumes = [determinant(direction, b, c), determinant(direction, c, a), determinant(direction, a, b)];
    let is_through = volumes.iter().all(|&x| x >= 0.0) || volumes.iter().all(|&x| x <= 0.0);
    let sum: f64 = volumes.iter().sum();
    if !is_through || sum == 0.0 {
        return None;
    }
    let along = [dot(direction, a), dot(direction, b), dot(direction, c)];
    let length = (0..3).map(|i| volumes[i] / sum * along[i]).sum::<f64>();
    (length > 0.0).then_some(length)
}

/// The signed solid angle of the triangle between three directions of length 1.
fn solid_angle(corners: [Option<[f64; 3]>; 3]) -> f64 {
    let [Some(a), Some(b), Some(c)] = corners else { return 0.0 };
    2.0 * determinant(a, b, c).atan2(1.0 + dot(a, b) + dot(b, c) + dot(c, a))
}

/// The direction from one point to another; `None` if they are one.
fn direction(from: [f64; 3], to: [f64; 3]) -> Option<[f64; 3]> {
    let halves = [0, 1, 2].map(|axis| to[axis] / 2.0 - from[axis] / 2.0);
    let size = halves.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    if size == 0.0 {
        return None;
    }
    let scaled = halves.map(|x| x / size);
    let length = norm(scaled);
    Some(scaled.map(|x| x / length))
}

fn point(positions: &Positions, vertex: u32) -> [f64; 3] {
    let point = positions.point(VertexId::from_u32(vertex));
    [point[0], point[1], point[2]]
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| a[axis] - b[axis])
}

fn norm(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

fn check_space(positions: &Positions) -> Result<(), Error> {
    if positions.dimension() == 3 || positions.is_empty() {
        return Ok(());
    }
    Err(Error::new(
        coface_algebra::ErrorKind::Shape,
        format!("points with {} coordinates are not points in space", positions.dimension()),
    )
    .with_cure("give three coordinates a point"))
}
