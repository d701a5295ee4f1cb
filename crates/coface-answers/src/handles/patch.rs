//! Triangles that fill a closed polygon in space.

use std::collections::BTreeSet;

/// Polygons with more corners than this are not filled.
pub(super) const MOST_CORNERS: usize = 640;

/// The triangles of least total area on a closed polygon, by the places of their corners, rising: none of those that are `forbidden`, and no diagonal
/// that is not free. `None` if there are none.
///
/// G. Barequet, M. Sharir, *Filling gaps in the boundary of a polyhedron* (1995).
pub(super) fn least_area(
    polygon: &[[f64; 3]],
    is_free: &[Vec<bool>],
    forbidden: &BTreeSet<[usize; 3]>,
) -> Option<Vec<[usize; 3]>> {
    let count = polygon.len();
    // best[i][j]: the least area on the chain from i to j, with the corner of its triangle at the chord.
    let mut best = vec![vec![(0.0f64, 0usize); count]; count];
    for length in 2..count {
        for i in 0..count - length {
            let j = i + length;
            best[i][j] = (f64::INFINITY, i);
            if (i, j) != (0, count - 1) && !is_free[i][j] {
                continue;
            }
            let mut least = (f64::INFINITY, i);
            for k in i + 1..j {
                let rest = best[i][k].0 + best[k][j].0;
                if rest >= least.0 {
                    continue;
                }
                let sum = rest + area(polygon[i], polygon[k], polygon[j]);
                if sum < least.0 && !forbidden.contains(&[i, k, j]) {
                    least = (sum, k);
                }
            }
            best[i][j] = least;
        }
    }
    if !best[0][count - 1].0.is_finite() {
        return None;
    }
    let mut triangles = Vec::with_capacity(count - 2);
    let mut chains = vec![(0, count - 1)];
    while let Some((i, j)) = chains.pop() {
        if j - i >= 2 {
            let k = best[i][j].1;
            triangles.push([i, k, j]);
            chains.extend([(i, k), (k, j)]);
        }
    }
    Some(triangles)
}

fn area(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    let [u, v] = [b, c].map(|p| [0, 1, 2].map(|axis| p[axis] - a[axis]));
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    cross.iter().map(|x| x * x).sum::<f64>().sqrt() / 2.0
}
