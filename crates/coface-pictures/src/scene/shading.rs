//! Polygons as triangles, for the eye.

use coface_geometry::predicates::orientation;
use coface_geometry::triangulation::triangulate;

/// The triangles that a polygon is shaded with, as places in its corners, which are given walk after walk: around the polygon, and
/// around its holes the other way. A polygon that bends or is not simple when it is seen along its normal is drawn as a fan.
///
/// $O(n \log n)$ for n corners.
pub(super) fn shaded(corners: &[[f64; 3]], lengths: &[usize]) -> Vec<[u32; 3]> {
    let first = lengths.first().map_or(0, |&length| length as u32);
    let fan = || (2..first).map(|i| [0, i - 1, i]).collect();
    if corners.len() <= 3 {
        return fan();
    }
    let mut walks: Vec<Vec<u32>> = Vec::with_capacity(lengths.len());
    for &length in lengths {
        let start = walks.iter().map(Vec::len).sum::<usize>() as u32;
        walks.push((start..start + length as u32).collect());
    }
    // Newell's normal: the sum of cross products around.
    let mut normal = [0.0_f64; 3];
    let sides = walks.iter().flat_map(|walk| (0..walk.len()).map(|i| [walk[i], walk[(i + 1) % walk.len()]]));
    for side in sides {
        let [a, b] = side.map(|corner| corners[corner as usize]);
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
    let at = |i: u32| [corners[i as usize][u], corners[i as usize][v]];
    triangulated_walks(walks, &at).unwrap_or_else(fan)
}

/// The triangles between flat walks, with the inside to their left; none if they bound no polygon. Corners of one place are one.
pub(super) fn triangulated_walks(
    mut walks: Vec<Vec<u32>>,
    at: &impl Fn(u32) -> [f64; 2],
) -> Option<Vec<[u32; 3]>> {
    let compare = |a: u32, b: u32| at(a)[0].total_cmp(&at(b)[0]).then(at(a)[1].total_cmp(&at(b)[1]));
    if walks.len() > 1 {
        let mut sorted: Vec<u32> = walks.iter().flatten().copied().collect();
        sorted.sort_unstable_by(|&a, &b| compare(a, b).then(a.cmp(&b)));
        let same = |vertex: u32| sorted[sorted.partition_point(|&other| compare(other, vertex).is_lt())];
        walks.iter_mut().flatten().for_each(|vertex| *vertex = same(*vertex));
    }
    let turn = |a: u32, b: u32, c: u32| orientation(at(a), at(b), at(c));
    triangulate(&walks, compare, turn).ok()
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
        let triangles = shaded(&corners, &[6]);
        assert_eq!((triangles.len(), triangles.into_iter().map(area).sum::<f64>()), (4, 3.0));
    }

    #[test]
    fn a_hole_stays_open() {
        let square =
            |low: f64, high: f64| [[low, low, 2.], [high, low, 2.], [high, high, 2.], [low, high, 2.]];
        let mut corners = square(0.0, 4.0).to_vec();
        corners.extend(square(1.0, 2.0).iter().rev());
        let area = |[a, b, c]: [u32; 3]| {
            let [a, b, c] = [a, b, c].map(|i| corners[i as usize]);
            0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
        };
        let triangles = shaded(&corners, &[4, 4]);
        assert_eq!((triangles.len(), triangles.into_iter().map(area).sum::<f64>()), (8, 15.0));
    }

    #[test]
    fn a_polygon_that_crosses_itself_is_a_fan() {
        let bow_tie = [[0., 0., 0.], [1., 1., 0.], [1., 0., 0.], [0., 1., 0.]];
        assert_eq!(shaded(&bow_tie, &[4]), [[0, 1, 2], [0, 2, 3]]);
    }
}
