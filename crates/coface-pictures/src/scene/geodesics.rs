//! Lines of the hyperbolic plane in the disk of Poincare: arcs of circles that meet the unit circle at right angles.

/// Chords may be so far from their arcs, in radii of the disk.
const BEND: f64 = 1e-3;

/// No line is halved more often.
const MOST_HALVINGS: u32 = 8;

/// Points of a disk, to which those between the given ones are added.
pub(super) struct Disk<'a> {
    pub(super) positions: &'a mut Vec<[f64; 2]>,
}

impl Disk<'_> {
    /// The line between two points as a walk along chords that cannot be told from it.
    pub(super) fn line(&mut self, a: u32, b: u32) -> Vec<u32> {
        let mut walk = vec![a];
        self.extend(&mut walk, a, b, MOST_HALVINGS);
        walk
    }

    fn extend(&mut self, walk: &mut Vec<u32>, a: u32, b: u32, halvings: u32) {
        match self.middle_of_bent(a, b).filter(|_| halvings > 0) {
            Some(middle) => {
                let middle = self.add(middle);
                self.extend(walk, a, middle, halvings - 1);
                self.extend(walk, middle, b, halvings - 1);
            }
            None => walk.push(b),
        }
    }

    /// Triangles that fill the one between three lines. Sides are cut where [`line`](Self::line) cuts them, so neighbors fit.
    pub(super) fn triangle(&mut self, corners: [u32; 3], triangles: &mut Vec<[u32; 3]>) {
        self.divide(corners, triangles, MOST_HALVINGS);
    }

    fn divide(&mut self, [a, b, c]: [u32; 3], triangles: &mut Vec<[u32; 3]>, halvings: u32) {
        let mut middle = |a, b| {
            let middle = self.middle_of_bent(a, b).filter(|_| halvings > 0);
            middle.map(|middle| self.add(middle))
        };
        let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
        let next = |corners| self.divide(corners, triangles, halvings.saturating_sub(1));
        match [ab, bc, ca] {
            [None, None, None] => triangles.push([a, b, c]),
            [Some(p), Some(q), Some(r)] => {
                [[a, p, r], [p, b, q], [r, q, c], [p, q, r]].into_iter().for_each(next);
            }
            [Some(p), None, None] => [[a, p, c], [p, b, c]].into_iter().for_each(next),
            [None, Some(q), None] => [[b, q, a], [q, c, a]].into_iter().for_each(next),
            [None, None, Some(r)] => [[c, r, b], [r, a, b]].into_iter().for_each(next),
            [Some(p), Some(q), None] => [[p, b, q], [a, p, q], [a, q, c]].into_iter().for_each(next),
            [None, Some(q), Some(r)] => [[q, c, r], [b, q, r], [b, r, a]].into_iter().for_each(next),
            [Some(p), None, Some(r)] => [[r, a, p], [c, r, p], [c, p, b]].into_iter().for_each(next),
        }
    }

    fn add(&mut self, point: [f64; 2]) -> u32 {
        self.positions.push(point);
        self.positions.len() as u32 - 1
    }

    /// The middle of the line between two points, if it is not on their chord as far as can be seen.
    fn middle_of_bent(&self, a: u32, b: u32) -> Option<[f64; 2]> {
        let [p, q] = [a, b].map(|point| self.positions[point as usize]);
        let middle = middle(p, q)?;
        let chord = [0, 1].map(|axis| f64::midpoint(p[axis], q[axis]));
        // The middle of the line need not lie over that of the chord: what counts is how far it is from the chord.
        let along = [q[0] - p[0], q[1] - p[1]];
        let away = along[0] * (middle[1] - chord[1]) - along[1] * (middle[0] - chord[0]);
        let length = along[0].hypot(along[1]);
        (length > 0.0 && away.abs() > BEND * length).then_some(middle)
    }
}

/// The middle of two points of the hyperbolic plane; none where a point is on the circle at infinity as far as numbers can tell.
///
/// On the hyperboloid $z^2 - x^2 - y^2 = 1$, which the disk is a picture of, it is the sum of both, scaled.
fn middle(p: [f64; 2], q: [f64; 2]) -> Option<[f64; 2]> {
    let lift = |[x, y]: [f64; 2]| {
        let rest = 1.0 - x * x - y * y;
        (rest > 1e-12).then(|| [2.0 * x / rest, 2.0 * y / rest, (2.0 - rest) / rest])
    };
    let (p, q) = (lift(p)?, lift(q)?);
    let [x, y, z] = [0, 1, 2].map(|axis| p[axis] + q[axis]);
    let length = (z * z - x * x - y * y).sqrt();
    let middle = [x / (length + z), y / (length + z)];
    middle.iter().all(|x| x.is_finite()).then_some(middle)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The center and the radius of the circle through two points that meets the unit circle at right angles: $c . p = (1 + p . p) / 2$.
    fn circle(p: [f64; 2], q: [f64; 2]) -> ([f64; 2], f64) {
        let [u, v] = [p, q].map(|[x, y]| (1.0 + x * x + y * y) / 2.0);
        let determinant = p[0] * q[1] - p[1] * q[0];
        let center = [(u * q[1] - v * p[1]) / determinant, (v * p[0] - u * q[0]) / determinant];
        (center, (center[0] * center[0] + center[1] * center[1] - 1.0).sqrt())
    }

    #[test]
    fn lines_are_arcs_at_right_angles_to_the_circle() {
        for (p, q) in [([0.8, 0.1], [-0.1, 0.9]), ([0.99, 0.0], [0.0, -0.99]), ([0.5, 0.5], [-0.4, 0.6])] {
            let mut positions = vec![p, q];
            let walk = Disk { positions: &mut positions }.line(0, 1);
            assert!(walk.len() > 2 && walk[0] == 0 && walk.last() == Some(&1));
            let (center, radius) = circle(p, q);
            let away = |[x, y]: [f64; 2]| ((x - center[0]).hypot(y - center[1]) - radius).abs();
            for pair in walk.windows(2) {
                let [a, b] = [pair[0], pair[1]].map(|point| positions[point as usize]);
                assert!(away(b) < 1e-9, "{b:?}");
                let chord = [0, 1].map(|axis| f64::midpoint(a[axis], b[axis]));
                assert!(away(chord) < 2.0 * BEND, "{chord:?}");
            }
        }
    }

    #[test]
    fn lines_through_the_middle_and_short_ones_are_straight() {
        let mut positions = vec![[0.6, 0.3], [-0.8, -0.4], [0.61, 0.3], [1.0, 0.0], [0.0, 1.0]];
        let mut disk = Disk { positions: &mut positions };
        assert_eq!([disk.line(0, 1), disk.line(0, 2), disk.line(3, 4)], [[0, 1], [0, 2], [3, 4]]);
    }

    #[test]
    fn triangles_are_filled_up_to_their_sides() {
        let mut positions = vec![[0.9, 0.0], [-0.3, 0.8], [-0.5, -0.7]];
        let mut disk = Disk { positions: &mut positions };
        let mut triangles = Vec::new();
        disk.triangle([0, 1, 2], &mut triangles);
        let rim: Vec<u32> = [(0, 1), (1, 2), (2, 0)].into_iter().flat_map(|(a, b)| disk.line(a, b)).collect();
        let area = |walk: &[u32]| -> f64 {
            let at = |i: usize| positions[walk[i % walk.len()] as usize];
            (0..walk.len()).map(|i| (at(i)[0] * at(i + 1)[1] - at(i)[1] * at(i + 1)[0]) / 2.0).sum()
        };
        assert!(triangles.len() > 10 && triangles.iter().all(|triangle| area(triangle) > 0.0));
        let filled: f64 = triangles.iter().map(|triangle| area(triangle)).sum();
        assert!((filled - area(&rim)).abs() < 1e-12, "{filled} {}", area(&rim));
    }
}
