//! Alpha complexes: the Delaunay triangulation of points, and the values of its simplices, in integers.

use crate::points::rows;
use coface_check::{Complex, Fault};
use dashu_int::IBig;
use std::collections::BTreeSet;

const STEP: &str = "alpha";
/// So many points are compared with spheres.
const MOST_TESTS: usize = 1 << 24;

/// The points in integers: the coordinates of the file are these times a power of two.
struct Points {
    places: Vec<Vec<IBig>>,
    exponent: i32,
}

/// A simplex from one of its points: the vectors to the others, their products with each other, and the adjugate and the determinant of these products.
struct Frame {
    origin: usize,
    vectors: Vec<Vec<IBig>>,
    squares: Vec<IBig>,
    adjugate: Vec<Vec<IBig>>,
    determinant: IBig,
}

/// Whether a complex is the Delaunay triangulation of the points in the file, and its values are those of the alpha complex; and what is proved then.
pub(crate) fn check(
    complex: &Complex,
    values: &[Vec<f64>],
    input: &[u8],
    layout: &str,
) -> Result<String, Fault> {
    let fault = |message: &str| Fault::new(STEP, message);
    let rows = rows(input, layout)?;
    let dimension = rows.first().map_or(0, Vec::len);
    let is_regular = (1..=3).contains(&dimension) && rows.iter().all(|row| row.len() == dimension);
    if !is_regular || complex.counts().len() != dimension + 1 {
        return Err(fault("the simplices do not fill a part of the space of the points"));
    }
    if complex.counts()[dimension].saturating_mul(rows.len()) > MOST_TESTS {
        return Err(fault("there are too many points to compare all of them with all spheres"));
    }
    let points = Points::of(&rows);
    let mut cells: Vec<Vec<Vec<usize>>> = Vec::new();
    for (degree, &count) in complex.counts().iter().enumerate() {
        let names =
            |cell: usize| Some(complex.vertices(degree, cell)?.iter().map(|&point| point as usize).collect());
        let own: Option<Vec<Vec<usize>>> = (0..count).map(names).collect();
        let own = own.filter(|own| own.iter().flatten().all(|point| *point < rows.len()));
        cells.push(own.ok_or_else(|| fault("a simplex has a point that is not there"))?);
    }
    // Points that are no vertices are the same as one that is.
    let places: BTreeSet<&Vec<IBig>> = cells[0].iter().map(|cell| &points.places[cell[0]]).collect();
    if places.len() != cells[0].len() || points.places.iter().any(|place| !places.contains(place)) {
        return Err(fault("a point is no vertex, or two vertices are at one place"));
    }
    check_triangulation(complex, &cells, &points, dimension)?;
    check_values(complex, &cells, &points, values)?;
    let count = rows.len();
    Ok(format!(
        "the simplices are a Delaunay triangulation of {count} points with {dimension} coordinates, and their values are those of the alpha complex, squared radii rounded to the nearest doubles"
    ))
}

/// For each cell of a degree those above it.
fn cofaces(complex: &Complex, degree: usize) -> Vec<Vec<usize>> {
    let mut found = vec![Vec::new(); complex.counts()[degree]];
    for cell in 0..complex.counts().get(degree + 1).copied().unwrap_or(0) {
        complex.boundary(degree + 1, cell).iter().for_each(|(face, _)| found[*face as usize].push(cell));
    }
    found
}

/// The simplices of the highest degree have no point inside of their spheres, meet in facets from both sides, and are a convex set.
fn check_triangulation(
    complex: &Complex,
    cells: &[Vec<Vec<usize>>],
    points: &Points,
    dimension: usize,
) -> Result<(), Fault> {
    let fault = |message: &str| Err(Fault::new(STEP, message));
    let zero = IBig::ZERO;
    for cell in &cells[dimension] {
        let frame = Frame::of(points, cell);
        if frame.determinant == zero {
            return fault("a simplex is flat");
        }
        let others = (0..points.places.len()).filter(|point| !cell.contains(point));
        if others.into_iter().any(|point| frame.has_inside(points, point)) {
            return fault("a point is inside of the sphere of a simplex");
        }
    }
    for degree in 0..dimension {
        if cofaces(complex, degree).iter().any(Vec::is_empty) {
            return fault("a simplex is no face of one of the highest degree");
        }
    }
    for (facet, above) in cells[dimension - 1].iter().zip(cofaces(complex, dimension - 1)) {
        let apex = |cell: usize| {
            cells[dimension][cell].iter().copied().find(|point| !facet.contains(point)).unwrap_or(0)
        };
        let side = |point: usize| points.orientation(facet, &points.places[point]);
        let is_right = match above[..] {
            [one, other] => side(apex(one)) * side(apex(other)) < zero,
            [one] => {
                let own = side(apex(one));
                (0..points.places.len()).all(|point| &own * side(point) >= zero)
            }
            _ => false,
        };
        if !is_right {
            return fault(
                "simplices do not meet in a facet from both sides, or one on the boundary has a point in front of it",
            );
        }
    }
    // The middle of the first simplex, times the number of its points, is in no other one.
    let first = &cells[dimension][0];
    let middle: Vec<IBig> =
        (0..dimension).map(|axis| first.iter().map(|&point| &points.places[point][axis]).sum()).collect();
    let scale = IBig::from(first.len());
    let scaled = Points {
        places: points.places.iter().map(|place| place.iter().map(|x| x * &scale).collect()).collect(),
        exponent: 0,
    };
    let around = cells[dimension].iter().filter(|cell| {
        (0..cell.len()).all(|i| {
            let facet: Vec<usize> = cell.iter().copied().filter(|point| *point != cell[i]).collect();
            scaled.orientation(&facet, &middle) * scaled.orientation(&facet, &scaled.places[cell[i]]) >= zero
        })
    });
    match around.count() {
        1 => Ok(()),
        _ => fault("simplices overlap"),
    }
}

/// The value of a simplex is the squared radius of its least sphere if no point of a simplex above is inside, and else the least value of those above.
fn check_values(
    complex: &Complex,
    cells: &[Vec<Vec<usize>>],
    points: &Points,
    values: &[Vec<f64>],
) -> Result<(), Fault> {
    for degree in 0..cells.len() {
        for (cell, (vertices, above)) in cells[degree].iter().zip(cofaces(complex, degree)).enumerate() {
            let (own, frame) = (values[degree][cell], Frame::of(points, vertices));
            let apexes = above.iter().flat_map(|&next| cells[degree + 1][next].iter().copied());
            let mut apexes = apexes.filter(|point| !vertices.contains(point));
            let is_right = match apexes.any(|point| frame.has_inside(points, point)) {
                true => above.iter().map(|&next| values[degree + 1][next]).reduce(f64::min) == Some(own),
                false => frame.has_squared_radius(own, points.exponent),
            };
            if !is_right {
                return Err(Fault::new(STEP, format!("the value of the simplex {vertices:?} is not {own}")));
            }
        }
    }
    Ok(())
}

impl Points {
    fn of(rows: &[Vec<f64>]) -> Self {
        let exponents = rows.iter().flatten().filter(|x| **x != 0.0).map(|x| parts(*x).1);
        let exponent = exponents.min().unwrap_or(0);
        let integer = |x: &f64| {
            let (mantissa, own) = parts(*x);
            IBig::from(mantissa) << if mantissa == 0 { 0 } else { (own - exponent) as usize }
        };
        Self { places: rows.iter().map(|row| row.iter().map(integer).collect()).collect(), exponent }
    }

    fn vector(&self, from: usize, to: &[IBig]) -> Vec<IBig> {
        self.places[from].iter().zip(to).map(|(a, b)| b - a).collect()
    }

    /// Positive or negative for points on the one or the other side of a facet, zero in its plane.
    fn orientation(&self, facet: &[usize], point: &[IBig]) -> IBig {
        let mut vectors: Vec<Vec<IBig>> =
            facet[1..].iter().map(|&other| self.vector(facet[0], &self.places[other])).collect();
        vectors.push(self.vector(facet[0], point));
        determinant(&vectors)
    }
}

/// A double as an integer times a power of two.
fn parts(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff) as i32, (bits & ((1 << 52) - 1)) as i64);
    let mantissa = if exponent == 0 { fraction } else { fraction | 1 << 52 };
    (if x < 0.0 { -mantissa } else { mantissa }, exponent.max(1) - 1075)
}

fn product(a: &[IBig], b: &[IBig]) -> IBig {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn without(matrix: &[Vec<IBig>], row: usize, column: usize) -> Vec<Vec<IBig>> {
    let rows = matrix.iter().enumerate().filter(|(i, _)| *i != row);
    rows.map(|(_, own)| {
        own.iter().enumerate().filter(|(j, _)| *j != column).map(|(_, x)| x.clone()).collect()
    })
    .collect()
}

/// By the first row; matrices have at most three.
fn determinant(matrix: &[Vec<IBig>]) -> IBig {
    let Some(first) = matrix.first() else { return IBig::ONE };
    let term =
        |(j, x): (usize, &IBig)| x * determinant(&without(matrix, 0, j)) * if j % 2 == 0 { 1 } else { -1 };
    first.iter().enumerate().map(term).sum()
}

impl Frame {
    fn of(points: &Points, simplex: &[usize]) -> Self {
        let origin = simplex[0];
        let vectors: Vec<Vec<IBig>> =
            simplex[1..].iter().map(|&other| points.vector(origin, &points.places[other])).collect();
        let products: Vec<Vec<IBig>> =
            vectors.iter().map(|a| vectors.iter().map(|b| product(a, b)).collect()).collect();
        let cofactor = |i: usize, j: usize| {
            determinant(&without(&products, i, j)) * if (i + j).is_multiple_of(2) { 1 } else { -1 }
        };
        let count = vectors.len();
        let adjugate = (0..count).map(|i| (0..count).map(|j| cofactor(i, j)).collect()).collect();
        let squares = (0..count).map(|i| products[i][i].clone()).collect();
        Self { origin, squares, adjugate, determinant: determinant(&products), vectors }
    }

    /// Twice the product with the vector from the origin to the center of the least sphere, times the determinant, of a vector with these products with the sides.
    fn times_center(&self, products: &[IBig]) -> IBig {
        let rows: Vec<IBig> = self.adjugate.iter().map(|row| product(row, products)).collect();
        product(&self.squares, &rows)
    }

    /// Whether a point is inside of the least sphere through the points of the simplex.
    fn has_inside(&self, points: &Points, point: usize) -> bool {
        let to = points.vector(self.origin, &points.places[point]);
        let products: Vec<IBig> = self.vectors.iter().map(|side| product(side, &to)).collect();
        // q is inside if q q < 2 q c, for the center c.
        product(&to, &to) * &self.determinant < self.times_center(&products)
    }

    /// Whether this double is the nearest one to the squared radius, which is a quarter of [`Self::times_center`] of the squares by the determinant.
    fn has_squared_radius(&self, value: f64, exponent: i32) -> bool {
        if value.is_nan() || value < 0.0 || value.next_up().is_infinite() {
            return false;
        }
        // Doubles are integers in units of 2^-1074. Twice the radius is compared with sums of two neighbors.
        let units = |x: f64| {
            let (mantissa, own) = parts(x);
            IBig::from(mantissa) << (own + 1074) as usize
        };
        let radius = self.times_center(&self.squares);
        let shift = 2 * exponent + 1074 - 1;
        let (left, right) = ((shift.max(0)) as usize, (-shift).max(0) as usize);
        let twice = radius << left;
        let of = |sum: IBig| (sum * &self.determinant) << right;
        of(units(value.next_down()) + units(value)) <= twice
            && twice <= of(units(value) + units(value.next_up()))
    }
}
