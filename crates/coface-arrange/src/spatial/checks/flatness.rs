//! How far a face is from a plane.

use coface_geometry::{cross, dot};

/// The plane that fits a face, and how far its points are from it. All of it is rounded.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flatness {
    /// The unit normal; zero for a face without area.
    pub(super) normal: [f64; 3],
    /// The greatest distance of a point from the plane.
    pub(super) distance: f64,
    /// The point at that distance, by its position among the points of all rings.
    pub(super) farthest: usize,
    /// The diagonal of the box around the face.
    pub(super) diameter: f64,
}

impl Flatness {
    /// Of a face by the points of its rings; the outer ring, the first, gives the normal, and the plane runs through
    /// the center of all points.
    ///
    /// The normal is half the sum of the cross products of neighbors (M. E. Newell), which is that of the least squares
    /// for a flat ring and needs no elimination.
    pub(super) fn of(rings: &[Vec<[f64; 3]>]) -> Self {
        let points = || rings.iter().flatten().copied();
        let low = points().fold([f64::INFINITY; 3], |low, p| [0, 1, 2].map(|i| low[i].min(p[i])));
        let high = points().fold([f64::NEG_INFINITY; 3], |high, p| [0, 1, 2].map(|i| high[i].max(p[i])));
        let extent = (0..3).map(|i| high[i] / 2.0 - low[i] / 2.0).fold(0.0, f64::max);
        let scale = if extent > 0.0 { extent } else { 1.0 };
        // In units of the box, so that no product leaves the range.
        let local = |p: [f64; 3]| [0, 1, 2].map(|i| (p[i] / 2.0 - low[i] / 2.0) / scale);
        let outer: Vec<[f64; 3]> = rings.first().into_iter().flatten().map(|&p| local(p)).collect();
        let mut sum = [0.0; 3];
        for (i, &p) in outer.iter().enumerate() {
            let turn = cross(p, outer[(i + 1) % outer.len()]);
            sum = [0, 1, 2].map(|axis| sum[axis] + turn[axis]);
        }
        let length = dot(sum, sum).sqrt();
        let normal = if length > 0.0 { sum.map(|x| x / length) } else { [0.0; 3] };
        let count = points().count().max(1) as f64;
        let center = points().map(local).fold([0.0; 3], |c, p| [0, 1, 2].map(|i| c[i] + p[i] / count));
        let (mut distance, mut farthest) = (0.0, 0);
        for (position, point) in points().map(local).enumerate() {
            let off = dot(normal, [0, 1, 2].map(|i| point[i] - center[i])).abs();
            if off > distance {
                (distance, farthest) = (off, position);
            }
        }
        let diagonal = (0..3).map(|i| ((high[i] / 2.0 - low[i] / 2.0) / scale).powi(2)).sum::<f64>().sqrt();
        Self { normal, distance: distance * 2.0 * scale, farthest, diameter: diagonal * 2.0 * scale }
    }

    /// The axis that is nearest to the normal.
    pub(super) fn axis(&self) -> usize {
        (0..3).max_by(|&a, &b| self.normal[a].abs().total_cmp(&self.normal[b].abs())).unwrap_or(2)
    }
}

/// The cosine of the angle between the normal of a triangle and a unit vector; `None` without area.
pub(super) fn tilt(triangle: [[f64; 3]; 3], normal: [f64; 3]) -> Option<f64> {
    let [a, b, c] = triangle;
    let extent = (0..3).map(|i| (b[i] - a[i]).abs().max((c[i] - a[i]).abs())).fold(0.0, f64::max);
    let [u, v] = [b, c].map(|p| [0, 1, 2].map(|i| (p[i] - a[i]) / extent));
    let own = cross(u, v);
    let length = dot(own, own).sqrt();
    (length > 0.0).then(|| dot(own, normal) / length)
}

/// Turns sides inside of a face until each triangle has its corners away from the circles of its neighbors, so that
/// thin triangles are left only where the face is thin: they have no normal to speak of. Seen along the normal, and rounded:
/// it stops after as many rounds as there are triangles.
///
/// C. L. Lawson, *Software for C1 surface interpolation* (1977).
pub(super) fn make_round(
    triangles: &mut [[u32; 3]],
    is_side: impl Fn(u32, u32) -> bool,
    point: impl Fn(u32) -> [f64; 3],
    normal: [f64; 3],
) {
    // The sine of the sum of the angles at the two corners that are opposite to a side.
    let flattens = |[a, b, c, d]: [[f64; 3]; 4]| {
        let minus = |x: [f64; 3], y: [f64; 3]| [0, 1, 2].map(|i| x[i] - y[i]);
        let turn =
            |from: [f64; 3], p: [f64; 3], q: [f64; 3]| dot(cross(minus(p, from), minus(q, from)), normal);
        let along = |from: [f64; 3], p: [f64; 3], q: [f64; 3]| {
            dot(minus(p, from), minus(q, from)) - dot(minus(p, from), normal) * dot(minus(q, from), normal)
        };
        let (sine, cosine) = (turn(c, a, b), along(c, a, b));
        let (other_sine, other_cosine) = (turn(d, b, a), along(d, b, a));
        let size = (sine.hypot(cosine) * other_sine.hypot(other_cosine)).max(f64::MIN_POSITIVE);
        let is_convex = turn(a, d, c) > 0.0 && turn(b, c, d) > 0.0;
        is_convex && (sine * other_cosine + cosine * other_sine) / size < -1e-12
    };
    for _ in 0..triangles.len() {
        let mut sides: Vec<([u32; 2], usize)> = triangles
            .iter()
            .enumerate()
            .flat_map(|(t, own)| (0..3).map(move |i| (own[i], own[(i + 1) % 3], t)))
            .filter(|&(a, b, _)| !is_side(a, b))
            .map(|(a, b, t)| ([a.min(b), a.max(b)], t))
            .collect();
        sides.sort_unstable();
        let mut has_turned = vec![false; triangles.len()];
        for pair in sides.chunk_by(|x, y| x.0 == y.0).filter(|pair| pair.len() == 2) {
            let [t, u] = [pair[0].1, pair[1].1];
            if has_turned[t] || has_turned[u] {
                continue;
            }
            let at = |own: [u32; 3]| (0..3).find(|&i| !pair[0].0.contains(&own[i]));
            let (Some(i), Some(j)) = (at(triangles[t]), at(triangles[u])) else { continue };
            let [c, a, b] = [0, 1, 2].map(|k| triangles[t][(i + k) % 3]);
            let d = triangles[u][j];
            if flattens([a, b, c, d].map(&point)) {
                (triangles[t], triangles[u]) = ([c, a, d], [d, b, c]);
                (has_turned[t], has_turned[u]) = (true, true);
            }
        }
        if !has_turned.contains(&true) {
            break;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_raised_corner_is_a_quarter_of_its_height_off_the_plane() {
        let square = vec![[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
        let flat = Flatness::of(std::slice::from_ref(&square));
        assert_eq!((flat.distance, flat.normal, flat.axis()), (0.0, [0., 0., 1.], 2));
        let mut raised = square;
        raised[2][2] = 0.4;
        let found = Flatness::of(&[raised.clone()]);
        // The plane z = (x + y - 1) h + h / 2 with h = 0.2 is 0.1 from each corner along z.
        let along_normal = 0.1 / (1.0f64 + 2.0 * 0.2 * 0.2).sqrt();
        assert!((found.distance - along_normal).abs() < 1e-15, "{found:?}");
        // Sizes near the ends of the range change nothing.
        for scale in [1e-300, 1e300] {
            let scaled = Flatness::of(&[raised.iter().map(|p| p.map(|x| x * scale)).collect()]);
            assert!((scaled.distance / scale - found.distance).abs() < 1e-15, "{scaled:?}");
        }
    }

    #[test]
    fn thin_triangles_are_turned_away() {
        // A square with a point close below the middle of its upper side, which is a corner of the face.
        let points =
            [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0.5, 0.999, 0.], [0., 1., 0.], [0.5, 1.001, 0.]];
        let sides = |ring: &'static [u32]| {
            move |a: u32, b: u32| {
                (0..ring.len()).any(|i| [[a, b], [b, a]].contains(&[ring[i], ring[(i + 1) % ring.len()]]))
            }
        };
        let point = |i: u32| points[i as usize];
        let mut thin = [[2, 5, 4], [0, 1, 2], [0, 2, 4]];
        make_round(&mut thin, sides(&[0, 1, 2, 5, 4]), point, [0., 0., 1.]);
        assert!(!thin.iter().any(|own| [2, 5, 4].iter().all(|corner| own.contains(corner))), "{thin:?}");
        // What cannot be turned stays.
        let mut dented = [[0, 1, 3], [1, 2, 3], [0, 3, 4]];
        make_round(&mut dented, sides(&[0, 1, 2, 3, 4]), point, [0., 0., 1.]);
        assert_eq!(dented, [[0, 1, 3], [1, 2, 3], [0, 3, 4]]);
    }
}
