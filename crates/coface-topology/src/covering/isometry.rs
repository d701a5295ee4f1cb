//! Isometries of the plane and of the hyperbolic plane as matrices.

use coface_algebra::Sign;

/// A point: (x, y, 1) in the plane; (x, y, t) with $t^2 - x^2 - y^2 = 1$, $t > 0$ on the hyperboloid.
pub(super) type Point = [f64; 3];

/// A linear map of points that is an isometry of the plane or of the hyperboloid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Isometry([Point; 3]);

impl Isometry {
    pub(super) const IDENTITY: Self = Self([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);

    /// (x, y) to (x + dx, y + dy), or to (x + dx, dy - y) if the sign is minus.
    pub(super) fn flat(translation: [f64; 2], sign: Sign) -> Self {
        let [dx, dy] = translation;
        Self([[1.0, 0.0, dx], [0.0, f64::from(sign.to_i32()), dy], [0.0, 0.0, 1.0]])
    }

    /// The rotation about (0, 0), of either plane.
    pub(super) fn rotation(angle: f64) -> Self {
        let (s, c) = angle.sin_cos();
        Self([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    }

    /// The reflection in the x axis, or the identity if the sign is plus.
    pub(super) fn reflection(sign: Sign) -> Self {
        Self::flat([0.0; 2], sign)
    }

    /// The hyperbolic translation along the x axis that takes the origin to the point at this signed distance.
    pub(super) fn boost(distance: f64) -> Self {
        let (s, c) = (distance.sinh(), distance.cosh());
        Self([[c, 0.0, s], [0.0, 1.0, 0.0], [s, 0.0, c]])
    }

    /// The product: the other one first, then this one.
    pub(super) fn after(&self, other: &Self) -> Self {
        let mut product = [[0.0; 3]; 3];
        for (row, own) in product.iter_mut().zip(&self.0) {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = own.iter().zip(&other.0).map(|(a, b)| a * b[j]).sum();
            }
        }
        Self(product)
    }

    /// The image of a point, or of a tangent vector of the hyperboloid.
    pub(super) fn apply(&self, point: Point) -> Point {
        self.0.map(|row| row.iter().zip(point).map(|(a, x)| a * x).sum())
    }

    /// The inverse of an isometry of the hyperboloid: the adjoint with respect to the form of Minkowski.
    pub(super) fn hyperbolic_inverse(&self) -> Self {
        let sign = |i: usize| if i == 2 { -1.0 } else { 1.0 };
        let mut inverse = [[0.0; 3]; 3];
        for (i, row) in inverse.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = sign(i) * sign(j) * self.0[j][i];
            }
        }
        Self(inverse)
    }
}

/// $t t' - x x' - y y'$: for two points of the hyperboloid the hyperbolic cosine of their distance.
pub(super) fn minkowski(a: Point, b: Point) -> f64 {
    a[2] * b[2] - a[0] * b[0] - a[1] * b[1]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn isometries_keep_distances() {
        let turn =
            Isometry::rotation(0.7).after(&Isometry::boost(1.3)).after(&Isometry::reflection(Sign::Minus));
        let origin = [0.0, 0.0, 1.0];
        let moved = turn.apply(origin);
        assert!((minkowski(origin, moved) - 1.3f64.cosh()).abs() < 1e-12);
        let back = turn.hyperbolic_inverse().apply(moved);
        assert!(back.iter().zip(origin).all(|(a, b)| (a - b).abs() < 1e-12));
        let glide = Isometry::flat([1.0, 2.0], Sign::Minus);
        assert_eq!(glide.after(&glide).apply([3.0, 4.0, 1.0]), [5.0, 4.0, 1.0]);
    }
}
