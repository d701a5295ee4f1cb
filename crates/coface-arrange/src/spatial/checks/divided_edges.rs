//! Vertices inside edges of other faces.

use super::edges::{Incidence, Use};
use super::faults::Collector;
use super::rings::Points;
use super::{CheckedFaces, CheckedPrimitive, FaultCode, FaultPlace, FaultScope};
use crate::spatial::SpatialPredicates;
use coface_geometry::{AxisBox, BoxTree};

/// Names the vertices at the boundary of faces that lie inside of an edge of one face: the neighbors of that face divide
/// the edge, and the face does not. Exact. Faces of different solids that are given have nothing to do with each other.
pub(super) fn vertices_inside_edges(
    points: &Points<'_>,
    faces: &CheckedFaces,
    incidence: &Incidence,
    faults: &mut Collector,
) {
    let is_checked = |own: &&[Use]| {
        let shell = incidence.shell_of_face[own[0].face as usize] as usize;
        own.len() == 1 && faces.primitive_of_shell(shell) != CheckedPrimitive::MultiSurface
    };
    let rim: Vec<Use> = incidence.edges().filter(is_checked).map(|own| own[0]).collect();
    let items = faces.rings().items();
    let vertex_at = |corner: u32| items[corner as usize];
    let place_at = |corner: u32| points.place[vertex_at(corner) as usize];
    let solid = |face: u32| {
        let shell = incidence.shell_of_face[face as usize] as usize;
        faces.solid_of_shell().get(shell).copied()
    };
    let ends = rim.iter().flat_map(|side| [side.corner, side.next].map(|corner| (corner, side.face)));
    let mut corners: Vec<(u32, Option<u32>, u32, u32)> =
        ends.map(|(corner, face)| (place_at(corner), solid(face), face, vertex_at(corner))).collect();
    corners.sort_unstable();
    corners.dedup_by_key(|own| (own.0, own.1));
    if corners.is_empty() {
        return;
    }
    let around = |side: &Use| -> AxisBox {
        let [a, b] = [side.corner, side.next].map(|corner| points.point(place_at(corner)));
        [0, 1, 2].map(|axis| [a[axis].min(b[axis]), a[axis].max(b[axis])])
    };
    let tree = BoxTree::new(&rim.iter().map(around).collect::<Vec<_>>());
    for (place, own_solid, face, vertex) in corners {
        let mut found = Vec::new();
        tree.visit(&points.point(place).map(|x| [x; 2]), |number| {
            let side = rim[number as usize];
            let [a, b] = [side.corner, side.next].map(place_at);
            let is_on = || (0..3).all(|axis| points.predicates.normal_sign(axis, [a, place, b]).is_eq());
            if place != a && place != b && solid(side.face) == own_solid && is_on() {
                found.push(side);
            }
        });
        found.sort_unstable();
        for side in found {
            faults.add_with(FaultCode::VertexInsideEdge, FaultScope::Surface, || FaultPlace {
                faces: vec![side.face, face],
                vertices: vec![vertex, vertex_at(side.corner), vertex_at(side.next)],
                point: Some(points.point(place)),
                ..FaultPlace::default()
            });
        }
    }
}
