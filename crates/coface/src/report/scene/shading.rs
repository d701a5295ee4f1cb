//! Polygons as triangles, for the eye.

use crate::geometry::predicates::orientation;
use crate::geometry::triangulation::triangulate;

/// The triangles that a polygon is shaded with, as places on its walk. A polygon that bends or is not simple when it is seen along its normal is
/// drawn as a fan.
///
/// $O(n \log n)$ for n corners.
pub(super) fn shaded(corners: &[[f64; 3]]) -> Vec<[u32; 3]> {
    let fan = || (2..corners.len() as u32).map(|i| [0, i - 1, i]).collect();
    if corners.len() <= 3 {
        return fan();
    }
    // Newell's normal: the sum of cross products around.
    let mut normal = [0.0_f64; 3];
    for (i, a) in corners.iter().enumerate() {
        let b = corners[(i + 1) % corners.len()];
        for (axis, sum) in normal.iter_mut().enumerate() {
            let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
            *sum += (a[u] - corners[0][u]) * (b[v] - corners[0][v])
                - (a[v] - corners[0][v]) * (b[u] - corners[0][u]);
        }
    }
    let axis = (0..3).fold(0, |best, axis| if normal[axis].abs() > normal[best].abs() { axis } else { best });
    let [mut u, mut v] = [(axis + 1) % 3, (axis + 2) % 3];
    if normal[axis] < 0.0 {
        (u, v) = (v, u);
    }
    let flat: Vec<[f64; 2]> = corners.iter().map(|corner| [corner[u], corner[v]]).collect();
    let at = |i: u32| flat[i as usize];
    let compare = |a: u32, b: u32| at(a)[0].total_cmp(&at(b)[0]).then(at(a)[1].total_cmp(&at(b)[1]));
    let turn = |a: u32, b: u32, c: u32| orientation(at(a), at(b), at(c));
    let walk: Vec<u32> = (0..corners.len() as u32).collect();
    triangulate(&[walk], compare, turn).unwrap_or_else(|_| fan())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_notch_stays_open() {
        // An L in the plane x = 1, seen from behind.
        let corners: [[f64; 3]; 6] =
            [[1., 0., 0.], [1., 0., 2.], [1., 1., 2.], [1., 1., 1.], [1., 2., 1.], [1., 2., 0.]];
        let area = |[a, b, c]: [u32; 3]| {
            let [a, b, c] = [a, b, c].map(|i| corners[i as usize]);
            0.5 * ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])).abs()
        };
        let triangles = shaded(&corners);
        assert_eq!((triangles.len(), triangles.into_iter().map(area).sum::<f64>()), (4, 3.0));
    }

    #[test]
    fn a_polygon_that_crosses_itself_is_a_fan() {
        let bow_tie = [[0., 0., 0.], [1., 1., 0.], [1., 0., 0.], [0., 1., 0.]];
        assert_eq!(shaded(&bow_tie), [[0, 1, 2], [0, 2, 3]]);
    }
}
