//! Where pieces are too near each other to tell them apart.

use super::Polynomial;
use super::polynomial::{cross, dot, minus, size};

/// Parameters of two pieces between which they may touch.
#[derive(Clone, Copy)]
pub(super) struct Contact {
    pub(super) ranges: [[f64; 2]; 2],
}

/// Contacts that are connected.
pub(super) struct Cluster {
    pub(super) ranges: [[f64; 2]; 2],
    /// The larger of the lengths of both chords.
    pub(super) length: f64,
    /// Whether the second piece runs against the first.
    pub(super) is_against: bool,
}

/// The clusters of contacts of two pieces, by rising parameters.
pub(super) fn clusters(contacts: &mut [Contact], a: &Polynomial, b: &Polynomial) -> Vec<Cluster> {
    contacts.sort_by(|x, y| {
        x.ranges[0][0].total_cmp(&y.ranges[0][0]).then(x.ranges[1][0].total_cmp(&y.ranges[1][0]))
    });
    let mut found: Vec<[[f64; 2]; 2]> = Vec::new();
    for contact in contacts.iter() {
        let mut own = contact.ranges;
        // Clusters that the contact hangs together with become one.
        found.retain(|known| {
            let meets = (0..2).all(|k| known[k][0] <= own[k][1] && own[k][0] <= known[k][1]);
            if meets {
                for k in 0..2 {
                    own[k] = [own[k][0].min(known[k][0]), own[k][1].max(known[k][1])];
                }
            }
            !meets
        });
        found.push(own);
    }
    found.sort_by(|x, y| x[0][0].total_cmp(&y[0][0]).then(x[1][0].total_cmp(&y[1][0])));
    found
        .into_iter()
        .map(|ranges| {
            let chords = [a.part(ranges[0]).chord(), b.part(ranges[1]).chord()];
            Cluster {
                ranges,
                length: size(chords[0]).max(size(chords[1])),
                is_against: dot(chords[0], chords[1]) < 0.0,
            }
        })
        .collect()
}

impl Cluster {
    /// Where the pieces are nearest: tangents parallel, and the way across along the normal; the middle where that is not found.
    ///
    /// Newton's iteration for $A'(t) \times B'(s) = 0$ and $(A(t) - B(s)) \cdot A'(t) = 0$.
    pub(super) fn nearest(&self, a: &Polynomial, b: &Polynomial) -> [f64; 2] {
        let middle = self.ranges.map(|range| 0.5 * (range[0] + range[1]));
        let clamp = |at: [f64; 2]| [0, 1].map(|k| at[k].clamp(self.ranges[k][0], self.ranges[k][1]));
        let mut at = middle;
        for _ in 0..12 {
            let [p, d, dd] = a.jet(at[0]);
            let [q, e, ee] = b.jet(at[1]);
            let gap = minus(p, q);
            let values = [cross(d, e), dot(gap, d)];
            let rows = [[cross(dd, e), cross(d, ee)], [dot(d, d) + dot(gap, dd), -dot(e, d)]];
            let turn = cross(rows[0], rows[1]);
            if turn.abs() <= f64::EPSILON * size(rows[0]) * size(rows[1]) {
                return middle;
            }
            let step = [
                cross(values, [rows[0][1], rows[1][1]]) / turn,
                cross([rows[0][0], rows[1][0]], values) / turn,
            ];
            let next = clamp([at[0] - step[0], at[1] - step[1]]);
            let moved = (next[0] - at[0]).abs().max((next[1] - at[1]).abs());
            at = next;
            if moved <= 1e-15 {
                break;
            }
        }
        at
    }
}
