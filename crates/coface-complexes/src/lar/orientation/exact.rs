//! Coordinates as integers: floating-point numbers times one power of two.

use coface_algebra::Integer;
use coface_algebra::VertexId;
use coface_geometry::Positions;

/// The coordinates of some vertices, exactly, in a unit that all of them share.
pub(super) struct ExactPoints {
    /// The vertices, rising.
    vertices: Vec<u32>,
    dimension: usize,
    coordinates: Vec<Integer>,
}

impl ExactPoints {
    /// The points of these vertices, in any order and as often as they come.
    pub(super) fn new(positions: &Positions, vertices: impl Iterator<Item = u32>) -> Self {
        let mut vertices: Vec<u32> = vertices.collect();
        vertices.sort_unstable();
        vertices.dedup();
        let parts: Vec<(i64, i32)> = vertices
            .iter()
            .flat_map(|&vertex| positions.point(VertexId::from_u32(vertex)))
            .map(|&x| mantissa_and_exponent(x))
            .collect();
        let unit = parts.iter().filter(|part| part.0 != 0).map(|part| part.1).min().unwrap_or(0);
        let coordinates =
            parts.iter().map(|&(mantissa, exponent)| shifted(mantissa, exponent.max(unit) - unit));
        Self { coordinates: coordinates.collect(), dimension: positions.dimension(), vertices }
    }

    fn point(&self, vertex: u32) -> &[Integer] {
        let at = self.vertices.binary_search(&vertex).expect("the points of all vertices were asked for");
        &self.coordinates[at * self.dimension..(at + 1) * self.dimension]
    }

    /// The sum of coordinates on the first axis: the length of a segment from its ends with signs.
    pub(super) fn length(&self, vertices: impl Iterator<Item = (u32, i32)>) -> Integer {
        let mut sum = Integer::ZERO;
        for (vertex, sign) in vertices {
            sum += &(&self.point(vertex)[0] * &Integer::from(sign));
        }
        sum
    }

    /// Twice the area vector of a cycle of edges, given as (tail, head, coefficient): the component of axes i < j is the sum
    /// of $a_i b_j - a_j b_i$, in the order 01, 02, 12, 03, ...
    pub(super) fn area(&self, edges: impl Iterator<Item = (u32, u32, i32)>) -> Vec<Integer> {
        let mut area = vec![Integer::ZERO; self.dimension * self.dimension.saturating_sub(1) / 2];
        for (tail, head, coefficient) in edges {
            let (a, b) = (self.point(tail), self.point(head));
            let mut component = area.iter_mut();
            for j in 0..self.dimension {
                for i in 0..j {
                    let minor = &(&a[i] * &b[j]) - &(&a[j] * &b[i]);
                    if let Some(sum) = component.next() {
                        *sum += &(&minor * &Integer::from(coefficient));
                    }
                }
            }
        }
        area
    }

    /// Six times the volume of the cone from the origin over a flat face with this doubled area vector through a vertex.
    pub(super) fn cone(&self, vertex: u32, area: &[Integer]) -> Integer {
        let point = self.point(vertex);
        let ([x, y, z], [xy, xz, yz]) = (point, area) else { return Integer::ZERO };
        &(&(x * yz) - &(y * xz)) + &(z * xy)
    }
}

/// A finite number as mantissa times a power of two, the mantissa odd or 0.
fn mantissa_and_exponent(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff) as i32, (bits & ((1 << 52) - 1)) as i64);
    let (mantissa, exponent) =
        if exponent == 0 { (fraction, -1074) } else { (fraction | 1 << 52, exponent - 1075) };
    if mantissa == 0 {
        return (0, 0);
    }
    let zeros = mantissa.trailing_zeros();
    let mantissa = mantissa >> zeros;
    (if x < 0.0 { -mantissa } else { mantissa }, exponent + zeros as i32)
}

/// The mantissa times two to the power of the shift.
fn shifted(mantissa: i64, mut shift: i32) -> Integer {
    const STEP: i32 = 60;
    let mut value = Integer::from(mantissa);
    if mantissa == 0 {
        return value;
    }
    while shift > 0 {
        value = &value * &Integer::from(1i64 << shift.min(STEP));
        shift -= STEP;
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn mantissas_give_the_number_back(x in prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO) {
            let (mantissa, exponent) = mantissa_and_exponent(x);
            // In two steps: the power of two alone may be too small for a number.
            let half = exponent / 2;
            prop_assert_eq!(mantissa as f64 * 2f64.powi(half) * 2f64.powi(exponent - half), x);
            prop_assert!(mantissa == 0 || mantissa % 2 != 0);
        }
    }

    #[test]
    fn the_largest_and_the_smallest_number_have_a_common_unit() {
        let positions = Positions::from_flat(1, vec![f64::MAX, -f64::from_bits(1), 0.0]).unwrap();
        let points = ExactPoints::new(&positions, [2, 0, 1, 1].into_iter());
        let length = points.length([(0, 1), (1, -1)].into_iter());
        assert_eq!(length.bit_length(), 2098);
        assert_eq!(points.length([(1, 1)].into_iter()), Integer::from(-1));
    }
}
