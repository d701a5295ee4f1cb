//! What polygons that are not valid enclose by their lines alone.

use super::super::boolean::RegionBoolean;
use super::super::drawing::Filling;
use super::layer::{Rings, drawing_of};
use coface_algebra::Error;
use coface_arrange::planar::PlanarOverlay;

/// The faces behind an odd number of lines, as GEOS repairs polygons by their linework: its bounded faces all together, without
/// their common border, then what is bounded by the lines that are left, and so on, each added to or taken from the rest. So a face
/// is as many lines away from the outside as there are on the way that crosses the fewest.
pub(super) fn by_linework(polygons: &[Rings]) -> Result<RegionBoolean, Error> {
    RegionBoolean::of_faces(drawing_of([(polygons, Filling::OuterWithoutHoles)])?, odd_faces)
}

fn odd_faces(overlay: &PlanarOverlay) -> Vec<bool> {
    let cells = overlay.cells();
    let outside = overlay.face_count();
    let face = |halfedge: u32| (cells.face(halfedge) as usize).min(outside);
    let edge_count = cells.edges().ends().len() as u32;
    let mut neighbors: Vec<[usize; 2]> = (0..edge_count)
        .map(|edge| [2 * edge, 2 * edge + 1].map(face))
        .filter(|[a, b]| a != b)
        .flat_map(|[a, b]| [[a, b], [b, a]])
        .collect();
    neighbors.sort_unstable();
    neighbors.dedup();
    let mut distances = vec![usize::MAX; outside + 1];
    distances[outside] = 0;
    let mut front = vec![outside];
    while !front.is_empty() {
        let mut next = Vec::new();
        for &from in &front {
            let first = neighbors.partition_point(|pair| pair[0] < from);
            for &[_, to] in neighbors[first..].iter().take_while(|pair| pair[0] == from) {
                if distances[to] == usize::MAX {
                    distances[to] = distances[from] + 1;
                    next.push(to);
                }
            }
        }
        front = next;
    }
    distances.into_iter().map(|distance| distance != usize::MAX && distance % 2 == 1).collect()
}
