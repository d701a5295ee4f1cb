//! Layouts in the hyperbolic plane for closed surfaces of negative Euler characteristic.

use super::domain::Domain;
use super::isometry::{Isometry, Point, minkowski};
use super::springs::Springs;
use super::universal_cover::UniversalCover;
use crate::hodge::{CholeskyFactor, MOST_FILL};
use coface_algebra::Sign;
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind};
use std::f64::consts::PI;

/// The most steps of Newton's method.
const MOST_STEPS: usize = 200;

/// The most sides of the polygon: with more its corners are so far out that rounding moves them past each other.
const MOST_SIDES: usize = 240;

/// The part of the energy below which a decrease is nothing.
const SETTLED: f64 = 1e-12;

/// The group of a closed surface as isometries of the hyperbolic plane: the regular polygon with 2n sides and angles
/// $\pi / n$ around the origin, its sides paired as those of the fundamental domain.
struct RegularPolygon {
    /// The images of the elements of prefixes: each takes corner 0 to its own corner.
    prefixes: Vec<Isometry>,
    /// The images of the letters.
    letters: Vec<Isometry>,
    corner: Point,
}

impl RegularPolygon {
    fn new(domain: &Domain) -> Self {
        let word = domain.word();
        let count = word.len();
        let half_side = PI / count as f64;
        // Right triangles of center, corner and middle of a side have the angles pi/2n at the first two.
        let to_corner = half_side.tan().powi(-2).acosh();
        let to_side = half_side.tan().recip().acosh();
        let corner_angle = |corner: usize| 2.0 * half_side * corner as f64;
        let side_angle = |side: usize| corner_angle(side) + half_side;
        let from_origin =
            |corner: usize| Isometry::rotation(corner_angle(corner)).after(&Isometry::boost(to_corner));
        let to_origin =
            |corner: usize| Isometry::boost(-to_corner).after(&Isometry::rotation(-corner_angle(corner)));
        let mut prefixes = vec![Isometry::IDENTITY; count];
        // The polygons around corner 0 clockwise: each has one of its corners there.
        let around =
            domain.group.corners_around_vertex().expect("the group has a relator and 3 generators or more");
        for (step, (corner, sign)) in around.into_iter().enumerate() {
            let turn = Isometry::rotation(2.0 * half_side * step as f64);
            prefixes[corner as usize] = from_origin(corner as usize)
                .after(&Isometry::reflection(sign))
                .after(&turn)
                .after(&to_origin(0));
        }
        let pairing = |position: u32| {
            let side = domain.sides[position as usize];
            let mate = side.mate.expect("letters cross edges inside the surface") as usize;
            let [here, there] = [position as usize, mate].map(|at| domain.prefixes[at] as usize);
            let twist = if word[here] == word[there] { Sign::Minus } else { Sign::Plus };
            Isometry::rotation(side_angle(here))
                .after(&Isometry::boost(2.0 * to_side))
                .after(&Isometry::reflection(twist))
                .after(&Isometry::rotation(PI - side_angle(there)))
        };
        let letters = domain.letters.iter().map(|&position| pairing(position)).collect();
        Self { prefixes, letters, corner: from_origin(0).apply([0.0, 0.0, 1.0]) }
    }
}

/// The points in the unit disk of the vertices of a cover of a closed surface of negative Euler characteristic.
pub(super) fn points(cover: &UniversalCover, springs: &Springs) -> Result<Vec<[f64; 2]>, Error> {
    let sides = cover.domain.word().len();
    if sides > MOST_SIDES {
        return Err(Error::new(
            ErrorKind::TooLarge,
            format!("the regular polygon of this surface has {sides} sides; layouts in the disk have at most {MOST_SIDES}"),
        )
        .with_cure("floating point cannot draw it: use the cover without a layout"));
    }
    let polygon = RegularPolygon::new(&cover.domain);
    let places = relaxed(springs, &polygon)?;
    let copies: Vec<Isometry> = (0..cover.copy_count())
        .map(|copy| {
            let word = cover.copy_word(copy);
            word.letters().iter().fold(Isometry::IDENTITY, |product, &letter| {
                let own = &polygon.letters[letter.unsigned_abs() as usize - 1];
                if letter > 0 { product.after(own) } else { product.after(&own.hyperbolic_inverse()) }
            })
        })
        .collect();
    Ok(cover.points_of(
        &copies,
        &polygon.prefixes,
        |vertex| places[vertex],
        springs,
        |[x, y, _]| {
            // The time coordinate is made anew, so that the point is in the disk whatever the rounding.
            let t = x.hypot(y).hypot(1.0);
            let modulus = x.hypot(y) / (1.0 + t);
            let inside = if modulus < 1.0 { 1.0 } else { (1.0 - f64::EPSILON) / modulus };
            [x / (1.0 + t) * inside, y / (1.0 + t) * inside]
        },
    ))
}

/// An orthonormal basis of the tangent plane of the hyperboloid.
fn frame([x, y, t]: Point) -> [Point; 2] {
    let share = 1.0 / (1.0 + t);
    [[1.0 + x * x * share, x * y * share, x], [x * y * share, 1.0 + y * y * share, y]]
}

/// The point that a tangent vector, in coordinates of the frame, leads to.
fn exponential(point: Point, step: [f64; 2]) -> Point {
    let length = step[0].hypot(step[1]);
    if length == 0.0 {
        return point;
    }
    let [e, f] = frame(point);
    let share = length.sinh() / length;
    let mut moved = [0, 1, 2].map(|i| length.cosh() * point[i] + share * (step[0] * e[i] + step[1] * f[i]));
    moved[2] = moved[0].hypot(moved[1]).hypot(1.0);
    moved
}

/// The places of the vertices where the weighted sum of the hyperbolic cosines of all edge lengths is least.
///
/// Each vertex is then inside the convex hull of its neighbors, so that the edges as geodesics embed the surface when
/// it is simplicial, whatever the positive weights (Y. Colin de Verdiere, *Comment rendre geodesique une
/// triangulation d'une surface*, 1991). The sum is a convex function along geodesics; Newton's method with halved
/// steps finds its minimum.
fn relaxed(springs: &Springs, polygon: &RegularPolygon) -> Result<Vec<Point>, Error> {
    let mut places = vec![polygon.corner; springs.vertex_count];
    let energy = |places: &[Point]| -> f64 {
        let terms = springs.springs.iter().map(|spring| {
            let [p, q] = [0, 1].map(|end| {
                polygon.prefixes[spring.prefixes[end] as usize].apply(places[spring.ends[end] as usize])
            });
            spring.weight * minkowski(p, q)
        });
        terms.sum()
    };
    let mut current = energy(&places);
    let steps = stage("laying a cover out", MOST_STEPS);
    for _ in 0..MOST_STEPS {
        steps.advance(1);
        let (step, decrease) = newton_step(springs, polygon, &places)?;
        let longest = step.chunks_exact(2).map(|step| step[0].hypot(step[1])).fold(0.0, f64::max);
        let moved = |share: f64| -> Vec<Point> {
            let steps = places.iter().zip(step.chunks_exact(2));
            steps.map(|(&place, step)| exponential(place, [share * step[0], share * step[1]])).collect()
        };
        // What is still to be gained is below the rounding of the sum: one more step squares the distance that is left.
        if decrease <= SETTLED * current {
            return Ok(moved(1.0));
        }
        // Steps longer than the scale of the curvature leave the region where the quadratic model is good.
        let mut share = 1.0 / longest.max(1.0);
        let next = loop {
            let next = moved(share);
            let reached = energy(&next);
            if reached <= current - 0.25 * share * decrease {
                current = reached;
                break Some(next);
            }
            share /= 2.0;
            if share < 1e-9 {
                break None;
            }
        };
        let Some(next) = next else { break };
        places = next;
    }
    Err(Error::new(ErrorKind::TooLarge, "the layout does not settle in floating point")
        .with_cure("take weights that are nearer to each other, or a coarser mesh"))
}

/// The step of Newton's method, two coordinates for each vertex, and the decrease that it promises: minus its product
/// with the gradient.
fn newton_step(
    springs: &Springs,
    polygon: &RegularPolygon,
    places: &[Point],
) -> Result<(Vec<f64>, f64), Error> {
    let count = 2 * springs.vertex_count;
    let mut entries = Vec::with_capacity(11 * springs.springs.len());
    let mut gradient = vec![0.0; count];
    let frames: Vec<[Point; 2]> = places.iter().map(|&place| frame(place)).collect();
    for spring in &springs.springs {
        let [a, b] = [0, 1].map(|end| {
            let (vertex, isometry) =
                (spring.ends[end] as usize, &polygon.prefixes[spring.prefixes[end] as usize]);
            (vertex, isometry.apply(places[vertex]), frames[vertex].map(|vector| isometry.apply(vector)))
        });
        let weight = spring.weight;
        let cosh = weight * minkowski(a.1, b.1);
        for ((vertex, _, frame), other) in [(a, b.1), (b, a.1)] {
            for i in 0..2 {
                gradient[2 * vertex + i] += weight * minkowski(frame[i], other);
                entries.push((2 * vertex + i, 2 * vertex + i, cosh));
            }
        }
        for i in 0..2 {
            for j in 0..2 {
                let (row, column) = (2 * a.0 + i, 2 * b.0 + j);
                let value = weight * minkowski(a.2[i], b.2[j]);
                if row == column {
                    entries.push((row, row, 2.0 * value));
                } else {
                    entries.push((row.max(column), row.min(column), value));
                }
            }
        }
    }
    let mut step: Vec<f64> = gradient.iter().map(|slope| -slope).collect();
    CholeskyFactor::new(count, entries, MOST_FILL)?.solve(&mut step);
    let decrease = -step.iter().zip(&gradient).map(|(step, slope)| step * slope).sum::<f64>();
    Ok((step, decrease))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::covering::tests::{polygon, subdivided};
    use crate::curves::{CutSurface, TreeCotree};

    /// The crossing g of a side from corner a to corner b of the copy there has P(a) = g P(b), as isometries too.
    #[test]
    fn side_pairings_and_corners_are_one_group() {
        let schemes: [&[i32]; 6] = [
            &[1, 2, -1, -2, 3, 4, -3, -4],
            &[1, 2, 3, 4, -1, -2, -3, -4],
            &[1, 1, 2, 2, 3, 3],
            &[1, 2, -1, -2, 3, 3],
            &[1, 2, 3, -2, 1, -3],
            &[3, 2, 3, 4, 1, -2, 1, -4],
        ];
        let maps = schemes.into_iter().flat_map(|scheme| [polygon(scheme), subdivided(scheme)]);
        for map in maps {
            let domain = Domain::new(&map, &CutSurface::new(&map, &TreeCotree::new(&map)), 0).unwrap();
            let model = RegularPolygon::new(&domain);
            for (letter, &position) in model.letters.iter().zip(&domain.letters) {
                let here = position as usize;
                let there = domain.sides[here].mate.unwrap() as usize;
                let corners = domain.mate_corners(here, there);
                for (here, there) in [here, domain.after(here)].into_iter().zip(corners) {
                    let [a, b] = [here, there].map(|at| &model.prefixes[domain.prefixes[at] as usize]);
                    let product = letter.after(b);
                    for probe in [[0.0, 0.0, 1.0], model.corner, [1.0, 1.0, 3f64.sqrt()]] {
                        let [p, q] = [a.apply(probe), product.apply(probe)];
                        assert!(minkowski(p, q) < 1.0 + 1e-9, "{:?}: {p:?} {q:?}", domain.word());
                    }
                }
            }
        }
    }
}
