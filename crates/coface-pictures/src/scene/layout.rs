//! Positions for complexes that have none.

use coface_algebra::UnionFind;

/// How often neighbors are averaged at most, and at least.
const ROUNDS: [usize; 2] = [300, 10];
/// How many pairs of neighbors are averaged for an axis: what is beyond a few seconds would not be looked at either.
const WORK: usize = 30_000_000;

/// Positions in space for the vertices of a graph: each component by the three slowest waves on it, components side by side.
///
/// The waves are eigenvectors of the lazy random walk, found by iteration from fixed starts: the same graph has the same
/// picture. $O(E)$ a round for E edges, in 300 rounds, or fewer for more than 100,000 edges.
pub(super) fn laid_out(vertex_count: usize, edges: &[[u32; 2]]) -> Vec<[f64; 3]> {
    let mut components = UnionFind::new(vertex_count);
    let mut degrees = vec![0.0f64; vertex_count];
    for &[a, b] in edges {
        components.unite(a, b);
        degrees[a as usize] += 1.0;
        degrees[b as usize] += 1.0;
    }
    let component_of = components.class_numbers();
    let count = components.class_count();
    let mut sizes = vec![0.0f64; count];
    let mut weights = vec![0.0f64; count];
    for (vertex, &component) in component_of.iter().enumerate() {
        sizes[component as usize] += 1.0;
        weights[component as usize] += degrees[vertex];
    }
    // Some number in [-1, 1] for each vertex and axis, always the same.
    let start = |vertex: usize, axis: usize| {
        let mixed = (vertex as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(17 * axis as u32 + 5);
        (mixed.wrapping_mul(0xBF58_476D_1CE4_E5B9) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    let rounds = (WORK / edges.len().max(1)).clamp(ROUNDS[1], ROUNDS[0]);
    let mut waves: Vec<Vec<f64>> = Vec::new();
    for axis in 0..3 {
        let mut wave: Vec<f64> = (0..vertex_count).map(|vertex| start(vertex, axis)).collect();
        for _ in 0..rounds {
            let mut sums = vec![0.0; vertex_count];
            for &[a, b] in edges {
                sums[a as usize] += wave[b as usize];
                sums[b as usize] += wave[a as usize];
            }
            for (vertex, sum) in sums.iter().enumerate() {
                let average = if degrees[vertex] > 0.0 { sum / degrees[vertex] } else { 0.0 };
                wave[vertex] = 0.5 * (wave[vertex] + average);
            }
            purify(&mut wave, &waves, &component_of, &degrees, &weights);
        }
        waves.push(wave);
    }
    // Each component in a cube whose content grows with its size.
    let mut offsets = vec![0.0; count];
    let mut end = 0.0;
    for (offset, size) in offsets.iter_mut().zip(&sizes) {
        let width = size.cbrt();
        *offset = end + width;
        end += 2.5 * width;
    }
    (0..vertex_count)
        .map(|vertex| {
            let component = component_of[vertex] as usize;
            let scale = sizes[component].cbrt();
            let [x, y, z] = [0, 1, 2].map(|axis| scale * waves[axis][vertex]);
            [offsets[component] + x, y, z]
        })
        .collect()
}

/// Takes the constant and earlier waves out of a wave on each component, and scales it to 1.
fn purify(wave: &mut [f64], earlier: &[Vec<f64>], component_of: &[u32], degrees: &[f64], weights: &[f64]) {
    let count = weights.len();
    let mut means = vec![0.0; count];
    for (vertex, &component) in component_of.iter().enumerate() {
        means[component as usize] += degrees[vertex] * wave[vertex];
    }
    for (vertex, &component) in component_of.iter().enumerate() {
        let weight = weights[component as usize];
        wave[vertex] -= if weight > 0.0 { means[component as usize] / weight } else { wave[vertex] };
    }
    for other in earlier {
        let (mut products, mut norms) = (vec![0.0; count], vec![0.0; count]);
        for (vertex, &component) in component_of.iter().enumerate() {
            products[component as usize] += degrees[vertex] * wave[vertex] * other[vertex];
            norms[component as usize] += degrees[vertex] * other[vertex] * other[vertex];
        }
        for (vertex, &component) in component_of.iter().enumerate() {
            let norm = norms[component as usize];
            if norm > 0.0 {
                wave[vertex] -= products[component as usize] / norm * other[vertex];
            }
        }
    }
    let mut highest = vec![0.0f64; count];
    for (value, &component) in wave.iter().zip(component_of) {
        highest[component as usize] = highest[component as usize].max(value.abs());
    }
    for (value, &component) in wave.iter_mut().zip(component_of) {
        // What is left of a wave that does not exist is rounding.
        *value = if highest[component as usize] > 1e-12 { *value / highest[component as usize] } else { 0.0 };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_is_round() {
        let edges: Vec<[u32; 2]> = (0..12).map(|i| [i, (i + 1) % 12]).collect();
        let positions = laid_out(12, &edges);
        let distance = |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt();
        let near = distance(positions[0], positions[1]);
        let far = distance(positions[0], positions[6]);
        assert!(far > 2.0 * near, "{near} {far}");
    }

    #[test]
    fn components_are_apart_and_lonely_vertices_have_a_place() {
        let positions = laid_out(5, &[[0, 1], [2, 3]]);
        assert!(positions.iter().flatten().all(|x| x.is_finite()));
        let right = |vertices: &[usize]| vertices.iter().map(|&v| positions[v][0]).fold(f64::MIN, f64::max);
        let left = |vertices: &[usize]| vertices.iter().map(|&v| positions[v][0]).fold(f64::MAX, f64::min);
        assert!(right(&[0, 1]) < left(&[2, 3]) && right(&[2, 3]) < left(&[4]));
    }
}
