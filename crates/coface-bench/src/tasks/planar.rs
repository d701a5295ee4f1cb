//! Arrangements and overlays in the plane.

use super::{Clock, Task, Work};
use crate::inputs::Mesh;
use coface::Error;
use coface::arrange::planar::{PlanarArrangement, PlanarOverlay};
use coface::geometry::Positions;
use std::path::Path;

pub(super) const SEGMENTS: Task = Task {
    name: "arrangement",
    about: "the planar arrangement of random segments, with faces and holes",
    extension: "raw3",
    inputs: &["seg_10000", "seg_20000", "seg_50000", "seg_100000"],
    work: Work::Inside(arranged),
};

pub(super) const LONG_SEGMENTS: Task = Task {
    name: "arrangement-long",
    about: "the planar arrangement of random segments of length 0.4, which cross in numbers that grow with the square",
    extension: "raw3",
    inputs: &["long_200", "long_400", "long_800", "long_1600", "long_3200"],
    work: Work::Inside(arranged),
};

pub(super) const SHORT_SEGMENTS: Task = Task {
    name: "arrangement-short",
    about: "the planar arrangement of random segments of length 0.1, which cross in numbers that grow with the square",
    extension: "raw3",
    inputs: &["short_1250", "short_2500", "short_5000", "short_10000"],
    work: Work::Inside(arranged),
};

pub(super) const INTERSECTION: Task = Task {
    name: "overlay-intersection",
    about: "the polygons that two regions in the plane have in common, from their rings",
    extension: "raw3",
    inputs: OVERLAYS,
    work: Work::Inside(|path, clock| overlaid(path, clock, |windings| windings.len() == 2)),
};

pub(super) const UNION: Task = Task {
    name: "overlay-union",
    about: "the polygons that two regions in the plane cover together, from their rings",
    extension: "raw3",
    inputs: OVERLAYS,
    work: Work::Inside(|path, clock| overlaid(path, clock, |windings| !windings.is_empty())),
};

const OVERLAYS: &[&str] = &[
    "coast_100000",
    "coast_1000000",
    "squares_100000",
    "squares_1000000",
    "star_10000",
    "star_100000",
    "random_100000",
    "gear_100000",
    "circle_1000000",
    "grid_1000000",
];

fn overlaid(path: &Path, clock: &mut Clock, condition: fn(&[(u32, i32)]) -> bool) -> Result<String, Error> {
    let (positions, mesh) = drawing(path)?;
    let regions: Vec<u32> =
        mesh.lists.iter().map(|ring| mesh.coordinates[3 * ring[0] as usize + 2] as u32).collect();
    let mut overlay = None;
    let [vertices, _, polygons, rings] = clock.time(mesh.vertex_count, || {
        let overlay = overlay.insert(PlanarOverlay::new(&positions, &mesh.lists, &regions)?);
        let found = overlay.select(condition)?;
        let [vertices, edges, polygons] = found.f_vector();
        Ok::<_, Error>([vertices, edges, polygons, found.rings().len()])
    })?;
    Ok(format!("polygons {polygons} rings {rings} vertices {vertices}"))
}

/// The points of a drawing, its lists, and the third coordinate of each list's first point.
pub(super) fn drawing(path: &Path) -> Result<(Positions, Mesh), Error> {
    let mesh = Mesh::read_raw3(path)?;
    let flat = mesh.coordinates.chunks_exact(3).flat_map(|p| [p[0], p[1]]).collect();
    Ok((Positions::from_flat(2, flat)?, mesh))
}

fn arranged(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let (positions, mesh) = drawing(path)?;
    let segments: Vec<[u32; 2]> = mesh.lists.iter().map(|ends| [ends[0], ends[1]]).collect();
    let found = clock.time(segments.len(), || PlanarArrangement::new(&positions, &segments))?;
    let (vertices, edges, faces) = (found.vertex_count(), found.edge_count(), found.face_count());
    Ok(format!("V {vertices} E {edges} F {faces}"))
}
