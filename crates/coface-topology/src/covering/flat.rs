//! Flat layouts: torus, Klein bottle, annulus and Moebius band unrolled.

use super::domain::Domain;
use super::isometry::{Isometry, Point};
use super::springs::{Spring, Springs};
use super::universal_cover::UniversalCover;
use crate::groups::NormalForm;
use crate::hodge::{CholeskyFactor, MOST_FILL};
use coface_algebra::Error;
use coface_algebra::{ParityUnionFind, Sign};

/// The group of a surface of Euler characteristic 0 as isometries of the plane.
#[derive(Clone, Copy, Debug)]
enum FlatGroup {
    /// Exponents are coordinates of translations.
    Torus,
    /// $a^i t^j$: t is the glide reflection (x + 1, -y), a the translation (x, y + 1).
    KleinBottle,
    /// The translation by the exponent along x.
    Annulus,
    /// The same with a reflection in the x axis for odd exponents.
    MoebiusBand,
}

impl FlatGroup {
    fn isometry(self, element: &NormalForm) -> Isometry {
        let [i, j] = element.exponents().expect("groups of characteristic 0 have exponents");
        let parity = |exponent: i64| Sign::power_of_minus_one(exponent.unsigned_abs() as usize);
        match self {
            Self::Torus => Isometry::flat([i as f64, j as f64], Sign::Plus),
            Self::KleinBottle => Isometry::flat([j as f64, i as f64], parity(j)),
            Self::Annulus => Isometry::flat([i as f64, 0.0], Sign::Plus),
            Self::MoebiusBand => Isometry::flat([i as f64, 0.0], parity(i)),
        }
    }
}

/// The points of the vertices of a cover of a surface of Euler characteristic 0.
pub(super) fn points(cover: &UniversalCover, springs: &Springs) -> Result<Vec<[f64; 2]>, Error> {
    let domain = &cover.domain;
    let flat_group = match (domain.is_closed(), domain.is_orientable()) {
        (true, true) => FlatGroup::Torus,
        (true, false) => FlatGroup::KleinBottle,
        (false, true) => FlatGroup::Annulus,
        (false, false) => FlatGroup::MoebiusBand,
    };
    let prefixes: Vec<Isometry> =
        domain.prefix_words().map(|word| flat_group.isometry(&domain.group.normal_form(&word))).collect();
    // Where an isometry takes (0, 0), and what it does to each coordinate.
    let shift = |axis: usize| prefixes.iter().map(move |isometry| isometry.apply([0.0, 0.0, 1.0])[axis]);
    let factor = prefixes.iter().map(|isometry| isometry.apply([0.0, 1.0, 0.0])[1]);
    let x_axis = Axis { factors: vec![1.0; prefixes.len()], shifts: shift(0).collect() };
    let y_axis = Axis { factors: factor.collect(), shifts: shift(1).collect() };
    let mut pinned = vec![None; springs.vertex_count];
    pinned[0] = Some(0.0);
    let x = x_axis.solve(springs, &pinned)?;
    let y = match flat_group {
        FlatGroup::Torus => y_axis.solve(springs, &pinned)?,
        FlatGroup::KleinBottle => y_axis.solve(springs, &vec![None; springs.vertex_count])?,
        _ => y_axis.solve(springs, &heights(domain, springs, &y_axis))?,
    };
    let energy = |a: (&Axis, &[f64]), b: (&Axis, &[f64])| -> f64 {
        springs
            .springs
            .iter()
            .map(|spring| spring.weight * a.0.extent(spring, a.1) * b.0.extent(spring, b.1))
            .sum()
    };
    let (along_x, along_y) = ((&x_axis, &x[..]), (&y_axis, &y[..]));
    let mixed = if matches!(flat_group, FlatGroup::Torus) { energy(along_x, along_y) } else { 0.0 };
    let mut shape = isotropic(energy(along_x, along_x), mixed, energy(along_y, along_y));
    let place = |isometry: &Isometry, vertex: usize| isometry.apply([x[vertex], y[vertex], 1.0]);
    let corner = |position: usize| {
        place(&prefixes[domain.prefixes[position] as usize], springs.at_positions[position] as usize)
    };
    if twice_area((0..domain.sides.len()).map(corner)) < 0.0 {
        shape[1] = shape[1].map(|entry| -entry);
    }
    let copies: Vec<Isometry> =
        (0..cover.copy_count()).map(|copy| flat_group.isometry(cover.copy_element(copy))).collect();
    Ok(cover.points_of(
        &copies,
        &prefixes,
        |vertex| [x[vertex], y[vertex], 1.0],
        springs,
        |[x, y, _]| shape.map(|row| row[0] * x + row[1] * y),
    ))
}

/// The heights of the boundary: 0 and 1 on an annulus, 1 and -1 on the two sides of a Moebius band.
fn heights(domain: &Domain, springs: &Springs, y_axis: &Axis) -> Vec<Option<f64>> {
    let mut classes = ParityUnionFind::new(springs.vertex_count);
    let mut is_outer = vec![false; springs.vertex_count];
    let mut first = None;
    for (position, _) in domain.sides.iter().enumerate().filter(|(_, side)| side.mate.is_none()) {
        let ends = [position, domain.after(position)];
        let [a, b] = ends.map(|end| springs.at_positions[end]);
        let sign: f64 = ends.iter().map(|&end| y_axis.factors[domain.prefixes[end] as usize]).product();
        classes.unite(a, b, if sign > 0.0 { Sign::Plus } else { Sign::Minus });
        (is_outer[a as usize], is_outer[b as usize]) = (true, true);
        first.get_or_insert(a);
    }
    let root = first.map(|vertex| classes.find(vertex).0);
    let height = |vertex: usize| {
        let (class, sign) = classes.find(vertex as u32);
        if domain.is_orientable() {
            if Some(class) == root { 0.0 } else { 1.0 }
        } else {
            f64::from(sign.to_i32())
        }
    };
    let mut height = height;
    (0..springs.vertex_count).map(|vertex| is_outer[vertex].then(|| height(vertex))).collect()
}

/// The linear map of determinant 1 that makes an energy the same in all directions: the inverse square root of its
/// matrix [[a, b], [b, c]].
fn isotropic(a: f64, b: f64, c: f64) -> [[f64; 2]; 2] {
    let root = (a * c - b * b).max(f64::MIN_POSITIVE).sqrt();
    // The square root of a symmetric matrix M is (M + root I) / trace; its inverse up to a factor is the adjugate.
    let scale = (root * (a + c + 2.0 * root)).sqrt();
    [[(c + root) / scale, -b / scale], [-b / scale, (a + root) / scale]]
}

/// Twice the signed area of a polygon.
fn twice_area(points: impl Iterator<Item = Point>) -> f64 {
    let points: Vec<Point> = points.collect();
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum()
}

/// What the elements of prefixes do to one coordinate: z becomes factor z + shift.
struct Axis {
    factors: Vec<f64>,
    shifts: Vec<f64>,
}

impl Axis {
    /// The difference of the coordinate between the ends of an edge.
    fn extent(&self, spring: &Spring, values: &[f64]) -> f64 {
        let at = |end: usize| {
            let prefix = spring.prefixes[end] as usize;
            self.factors[prefix] * values[spring.ends[end] as usize] + self.shifts[prefix]
        };
        at(0) - at(1)
    }

    /// The values of least energy with these ones fixed.
    fn solve(&self, springs: &Springs, fixed: &[Option<f64>]) -> Result<Vec<f64>, Error> {
        let mut count = 0;
        let mut values = vec![0.0; fixed.len()];
        let unknowns: Vec<Option<usize>> = fixed
            .iter()
            .zip(&mut values)
            .map(|(fixed, value)| match fixed {
                Some(fixed) => {
                    *value = *fixed;
                    None
                }
                None => {
                    count += 1;
                    Some(count - 1)
                }
            })
            .collect();
        if count == 0 {
            return Ok(values);
        }
        let mut entries = Vec::with_capacity(3 * springs.springs.len());
        let mut right = vec![0.0; count];
        for spring in &springs.springs {
            let extent = self.extent(spring, &values);
            let [a, b] = [0, 1].map(|end| {
                let sign = if end == 0 { 1.0 } else { -1.0 };
                (unknowns[spring.ends[end] as usize], sign * self.factors[spring.prefixes[end] as usize])
            });
            let terms =
                if spring.ends[0] == spring.ends[1] { [(a.0, a.1 + b.1), (None, 0.0)] } else { [a, b] };
            for (k, &(row, factor)) in terms.iter().enumerate() {
                let Some(row) = row else { continue };
                right[row] -= spring.weight * factor * extent;
                for &(column, other) in &terms[..=k] {
                    let Some(column) = column else { continue };
                    let (low, high) = (row.min(column), row.max(column));
                    entries.push((high, low, spring.weight * factor * other));
                }
            }
        }
        CholeskyFactor::new(count, entries, MOST_FILL)?.solve(&mut right);
        for (value, unknown) in values.iter_mut().zip(unknowns) {
            if let Some(unknown) = unknown {
                *value = right[unknown];
            }
        }
        Ok(values)
    }
}
