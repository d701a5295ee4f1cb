//! Closed parts of a surface that look outwards.

use coface_algebra::{FaceId, RaggedArray, UnionFind, VertexId};
use coface_complexes::surface::PolygonMesh;
use coface_geometry::{AxisBox, BoxTree, Positions, enclosed_volume};

/// The faces to be turned so that closed parts of an oriented surface in space look outwards: those of parts whose signed volume is negative.
/// A part whose box lies in that of another closed part turns as that one does, so that voids stay voids.
///
/// Parts are connected through edges in two faces; those that are open, or whose faces do not agree, stay as they are.
///
/// # Complexity
/// $O(n \log n)$ for parts whose boxes lie in few others.
pub(super) fn faces_to_turn(mesh: &PolygonMesh, positions: &Positions) -> Vec<FaceId> {
    if positions.dimension() != 3 || mesh.vertex_count() > positions.len() {
        return Vec::new();
    }
    let mut partition = UnionFind::new(mesh.face_count());
    let edges = |face: usize| mesh.face_edges(FaceId::new(face));
    for face in 0..mesh.face_count() {
        for (edge, _) in edges(face).filter(|&(edge, _)| mesh.face_count_at(edge) == 2) {
            mesh.faces_of_edge(edge).for_each(|(other, _)| {
                partition.unite(face as u32, other.to_u32());
            });
        }
    }
    let classes = partition.class_numbers();
    let mut is_closed = vec![true; mesh.face_count()];
    for face in 0..mesh.face_count() {
        let agrees = edges(face).all(|(edge, sign)| {
            let at = |(other, at_other): (FaceId, _)| other.index() == face || at_other != sign;
            mesh.face_count_at(edge) == 2 && mesh.faces_of_edge(edge).all(at)
        });
        is_closed[classes[face] as usize] &= agrees;
    }
    let mut members: Vec<Vec<usize>> = vec![Vec::new(); partition.class_count()];
    (0..mesh.face_count()).for_each(|face| members[classes[face] as usize].push(face));
    let box_of = |faces: &Vec<usize>| -> AxisBox {
        let mut own = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        for &vertex in faces.iter().flat_map(|&face| mesh.face(FaceId::new(face))) {
            let point = positions.point(VertexId::from_u32(vertex));
            for (range, &x) in own.iter_mut().zip(point) {
                *range = [range[0].min(x), range[1].max(x)];
            }
        }
        own
    };
    let is_closed = members.into_iter().zip(is_closed).filter(|(_, is_closed)| *is_closed);
    let mut closed: Vec<(AxisBox, Vec<usize>)> =
        is_closed.map(|(faces, _)| (box_of(&faces), faces)).collect();
    // Larger boxes first: what a box lies in has been decided before it.
    let extent = |own: &AxisBox| own.iter().map(|[low, high]| high - low).sum::<f64>();
    closed.sort_by(|(a, _), (b, _)| extent(b).total_cmp(&extent(a)));
    let boxes: Vec<AxisBox> = closed.iter().map(|(own, _)| *own).collect();
    let tree = BoxTree::new(&boxes);
    let mut is_turned = vec![false; closed.len()];
    for part in 0..closed.len() {
        let own = boxes[part];
        let corner = own.map(|[low, _]| [low, low]);
        let mut container = None;
        tree.visit(&corner, |other| {
            let around = boxes[other as usize];
            let contains =
                around.iter().zip(own).all(|(around, own)| around[0] <= own[0] && own[1] <= around[1]);
            if (other as usize) < part && contains {
                container = container.max(Some(other as usize));
            }
        });
        is_turned[part] = match container {
            Some(container) => is_turned[container],
            None => is_inside_out(mesh, positions, &closed[part].1),
        };
    }
    let turned = closed.iter().zip(is_turned).filter(|(_, is_turned)| *is_turned);
    let mut faces: Vec<FaceId> =
        turned.flat_map(|((_, faces), _)| faces).map(|&face| FaceId::new(face)).collect();
    faces.sort_unstable();
    faces
}

/// Whether these faces enclose a volume below 0; $O(n \log n)$ for their n corners, however large the mesh is.
fn is_inside_out(mesh: &PolygonMesh, positions: &Positions, faces: &[usize]) -> bool {
    let corners = || faces.iter().map(|&face| mesh.face(FaceId::new(face)));
    let mut used: Vec<u32> = corners().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    let flat = used.iter().flat_map(|&vertex| positions.point(VertexId::from_u32(vertex))).copied().collect();
    let Ok(own) = Positions::from_flat(3, flat) else { return false };
    let number = |vertex: &u32| used.partition_point(|other| other < vertex) as u32;
    let polygons =
        RaggedArray::from_lists(corners().map(|face| face.iter().map(number).collect::<Vec<u32>>()));
    enclosed_volume(&own, &polygons).is_some_and(|volume| volume < 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Boxes from corner to corner; those that are marked look inwards.
    fn turned(boxes: &[([f64; 3], [f64; 3], bool)]) -> Vec<bool> {
        let (mut coordinates, mut polygons) = (Vec::new(), Vec::new());
        for (number, &(low, high, is_inverted)) in boxes.iter().enumerate() {
            for corner in 0..8 {
                coordinates
                    .extend((0..3).map(|axis| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] }));
            }
            for side in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
                let mut side = side.map(|corner| 8 * number as u32 + corner).to_vec();
                if is_inverted {
                    side.reverse();
                }
                polygons.push(side);
            }
        }
        let mesh = PolygonMesh::new(coordinates.len() / 3, RaggedArray::from_lists(polygons), &[]).unwrap();
        let faces = faces_to_turn(&mesh, &Positions::from_flat(3, coordinates).unwrap());
        (0..boxes.len())
            .map(|number| {
                let own: Vec<bool> =
                    (0..6).map(|side| faces.contains(&FaceId::new(6 * number + side))).collect();
                assert!(own.iter().all(|&is_turned| is_turned == own[0]));
                own[0]
            })
            .collect()
    }

    #[test]
    fn outermost_parts_look_outwards_and_voids_stay_voids() {
        let (outer, inner, other) = (([0.0; 3], [9.0; 3]), ([1.0; 3], [2.0; 3]), ([20.0; 3], [21.0; 3]));
        let all = |flags: [bool; 3]| {
            turned(&[
                (outer.0, outer.1, flags[0]),
                (inner.0, inner.1, flags[1]),
                (other.0, other.1, flags[2]),
            ])
        };
        assert_eq!(all([false, true, false]), [false, false, false]);
        assert_eq!(all([true, false, true]), [true, true, true]);
        assert_eq!(all([false, false, true]), [false, false, true]);
        // The smaller one first.
        assert_eq!(turned(&[(inner.0, inner.1, false), (outer.0, outer.1, true)]), [true, true]);
    }

    #[test]
    fn open_surfaces_stay() {
        let positions =
            Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., -1.]).unwrap();
        let open = PolygonMesh::new(4, RaggedArray::from_lists([[0, 2, 1], [0, 1, 3]]), &[]).unwrap();
        assert!(faces_to_turn(&open, &positions).is_empty());
        let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
        let inwards = PolygonMesh::new(4, RaggedArray::from_lists(faces), &[]).unwrap();
        assert_eq!(faces_to_turn(&inwards, &positions).len(), 4);
        assert!(faces_to_turn(&inwards, &Positions::default()).is_empty());
    }
}
