//! Vertices around which sheets lie side by side, so that nothing needs to be decided about pairs of these.

use crate::spatial::axis_view::PlaneView;

/// What is known of the sheets at a vertex.
#[derive(Clone, Copy)]
struct Fan {
    /// The view that all sheets so far have, as a number; [`NO_VIEW`] before the first.
    view: u8,
    /// How many sheets the first direction to the right runs into, up to two.
    covered: u8,
    is_plain: bool,
}

const NO_VIEW: u8 = u8::MAX;

/// For each sheet a bit for each corner that is **plain**: each edge there has two sheets, which run through it both
/// ways, all sheets there have one view, and in the picture they go around the vertex once.
///
/// Then the corners of sheets there are sectors that fill the picture around the vertex without overlap, each sheet is
/// within its own sector, and two of them have nothing in common but the vertex or the edge between them. In the
/// picture a sheet turns by less than a half turn, and counterclockwise seen from its front; so how often all of them
/// go around is how many of them one direction runs into, and a sheet is run into when its first side there points down
/// and its last one up. Only coordinates are compared.
///
/// # Complexity
/// Linear.
pub(super) fn plain_corners(
    points: &[[f64; 3]],
    corners: &[[u32; 3]],
    views: &[PlaneView],
    edges: &[[u32; 2]],
    edges_of: &[[u32; 3]],
) -> Vec<u8> {
    let mut fans = vec![Fan { view: NO_VIEW, covered: 0, is_plain: true }; points.len()];
    // Bits for a sheet that runs through an edge one way, the other way, and for a second one.
    let mut uses = vec![0u8; edges.len()];
    for ((own, &view), own_edges) in corners.iter().zip(views).zip(edges_of) {
        let is_front = view.front.is_gt();
        let number = 2 * view.axis + u8::from(is_front);
        let seen = own.map(|vertex| view.seen(points[vertex as usize]));
        // Whether the side from each corner to the next points up; then it points down the other way.
        let points_up = [0, 1, 2].map(|i| {
            let ([x, y], [to_x, to_y]) = (seen[i], seen[(i + 1) % 3]);
            to_y > y || to_y == y && to_x > x
        });
        for i in 0..3 {
            let fan = &mut fans[own[i] as usize];
            fan.is_plain &= fan.view == NO_VIEW || fan.view == number;
            fan.view = number;
            // From the front the sector turns from the next corner to the one before.
            let (out, back) = (points_up[i], points_up[(i + 2) % 3]);
            let is_covered = if is_front { !out && !back } else { out && back };
            fan.covered = (fan.covered + u8::from(is_covered)).min(2);
            let used = &mut uses[own_edges[i] as usize];
            let way = 1 << u8::from(own[i] < own[(i + 1) % 3]);
            *used |= if *used & way == 0 { way } else { 4 };
        }
    }
    for (ends, _) in edges.iter().zip(&uses).filter(|&(_, &used)| used != 3) {
        ends.iter().for_each(|&end| fans[end as usize].is_plain = false);
    }
    let is_plain = |vertex: u32| {
        let fan = &fans[vertex as usize];
        fan.is_plain && fan.covered == 1
    };
    let bits = |own: &[u32; 3]| (0..3).map(|i| u8::from(is_plain(own[i])) << i).sum();
    corners.iter().map(bits).collect()
}

#[cfg(test)]
mod tests {
    use crate::spatial::cutting::sheets::Sheets;
    use coface_geometry::Positions;
    use proptest::prelude::*;

    fn plain(points: &[[f64; 3]], triangles: &[[u32; 3]]) -> Vec<u8> {
        let positions = Positions::from_flat(3, points.as_flattened().to_vec()).unwrap();
        Sheets::new(&positions, triangles).0.plain_corners
    }

    /// A wheel of triangles around the first point.
    fn wheel(count: u32) -> Vec<[u32; 3]> {
        (0..count).map(|i| [0, 1 + i, 1 + (i + 1) % count]).collect()
    }

    #[test]
    fn a_wheel_is_plain_around_its_hub_if_it_goes_around_once() {
        let rim = |turns: f64| {
            let corner = |i: u32| {
                let angle = turns * f64::from(i) * std::f64::consts::TAU / 7.0 + 0.1;
                [angle.cos(), angle.sin(), 0.3 * f64::from(i % 2)]
            };
            std::iter::once([0.0; 3]).chain((0..7).map(corner)).collect::<Vec<_>>()
        };
        assert_eq!(plain(&rim(1.0), &wheel(7)), [1; 7]);
        let backwards: Vec<[u32; 3]> = wheel(7).into_iter().map(|[a, b, c]| [c, b, a]).collect();
        assert_eq!(plain(&rim(1.0), &backwards), [4; 7]);
        // Twice around, the triangles overlap.
        assert_eq!(plain(&rim(2.0), &wheel(7)), [0; 7]);
        // One is missing, one is turned, one more stands on a spoke.
        assert_eq!(plain(&rim(1.0), &wheel(7)[1..]), [0; 6]);
        let mut turned = wheel(7);
        turned[3].swap(1, 2);
        assert_eq!(plain(&rim(1.0), &turned), [0; 7]);
        let (mut points, mut more) = (rim(1.0), wheel(7));
        points.push([0.5, 0.5, 5.0]);
        more.push([0, 2, 8]);
        assert_eq!(plain(&points, &more), [0; 8]);
    }

    proptest! {
        /// Two sheets at a plain corner are in sectors without a common inside: in the picture neither has a corner
        /// inside the sector of the other.
        #[test]
        fn sectors_at_plain_corners_are_apart(
            heights in prop::collection::vec([-3i32..4, -3..4, -1..2], 8),
            triangles in prop::collection::btree_set(prop::sample::subsequence((0u32..8).collect::<Vec<_>>(), 3), 0..14),
            turns in prop::collection::vec(any::<bool>(), 14),
            hub in 3u32..8,
        ) {
            let points: Vec<[f64; 3]> = heights.iter().map(|point| point.map(f64::from)).collect();
            let soup = triangles.iter().zip(&turns).map(|(own, &turned)| {
                if turned { [own[0], own[2], own[1]] } else { [own[0], own[1], own[2]] }
            });
            for triangles in [soup.collect::<Vec<_>>(), wheel(hub - 1)] {
                let positions = Positions::from_flat(3, points.as_flattened().to_vec()).unwrap();
                let (sheets, _) = Sheets::new(&positions, &triangles);
                for f in 0..sheets.count() as u32 {
                    for g in (0..sheets.count() as u32).filter(|&g| g != f && sheets.are_beside(f, g)) {
                        let view = sheets.views[f as usize];
                        let corner = sheets.corners[f as usize].iter().zip(0..3).find(|&(corner, i)| {
                            sheets.plain_corners[f as usize] >> i & 1 == 1 && sheets.corners[g as usize].contains(corner)
                        });
                        let hub = *corner.unwrap().0;
                        let seen = |vertex: u32| {
                            let [x, y] = view.seen(sheets.point(vertex));
                            if view.front.is_gt() { [x, y] } else { [y, x] }
                        };
                        // The sides of the sector, counterclockwise.
                        let sector = |sheet: u32| {
                            let own = sheets.corners[sheet as usize];
                            let i = own.iter().position(|&vertex| vertex == hub).unwrap();
                            [own[(i + 1) % 3], own[(i + 2) % 3]].map(|vertex| {
                                let ([x, y], [a, b]) = (seen(vertex), seen(hub));
                                [x - a, y - b]
                            })
                        };
                        let cross = |u: [f64; 2], v: [f64; 2]| u[0] * v[1] - u[1] * v[0];
                        let ([a, b], [c, d]) = (sector(f), sector(g));
                        for middle in [[c[0] + d[0], c[1] + d[1]], c, d] {
                            prop_assert!(!(cross(a, middle) > 0.0 && cross(middle, b) > 0.0));
                        }
                    }
                }
            }
        }
    }
}
