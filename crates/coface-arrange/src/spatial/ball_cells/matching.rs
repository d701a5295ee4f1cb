//! The cells of an arrangement found again in one with cuts.

use super::NONE;
use crate::spatial::SpatialArrangement;
use coface_algebra::{FaceId, Sign, UnionFind, VertexId};
use std::collections::HashMap;

/// For each bounded cell of an arrangement that was made once more with cuts the cell that it is part of, no number for
/// what is part of the exterior. `None` if a cell cannot be told, since cuts divide all edges of it.
///
/// Two half-faces at one vertex, along one edge to a second vertex, on one triangle of the input are in one cell, whatever
/// cuts there are elsewhere.
pub(super) fn cells_of_cut(before: &SpatialArrangement, after: &SpatialArrangement) -> Option<Vec<u32>> {
    let vertices = vertices_of_cut(before, after);
    let (old, new) = (before.fine_triangles(), after.fine_triangles());
    let (old_complex, new_complex) = (old.complex(), new.complex());
    // The half-faces of the arrangement before by their sides.
    let mut cells: HashMap<(u32, [u32; 2]), (u32, u32)> = HashMap::new();
    let cell = |arrangement: &SpatialArrangement, face: u32, sign: Sign| {
        arrangement.fine().cell_at(FaceId::from_u32(face), sign).map_or(NONE, coface_algebra::CellId::to_u32)
    };
    let sheet = |arrangement: &SpatialArrangement, face: u32| {
        arrangement.fine_triangles().sheet_of_face(FaceId::from_u32(face))
    };
    for face in 0..old_complex.face_count() as u32 {
        let sides = [Sign::Plus, Sign::Minus].map(|sign| cell(before, face, sign));
        for &side in old_complex.packed_sides().list(face as usize) {
            let ends = old_complex.side_ends(side).map(|vertex| vertices[vertex as usize]);
            cells.insert((sheet(before, face), ends), (sides[0], sides[1]));
        }
    }
    let count = after.fine().cell_count();
    let node = |cell: u32| if cell == NONE { count as u32 } else { cell };
    let mut joined = UnionFind::new(count + 1);
    let mut known = vec![None; count + 1];
    for face in 0..new_complex.face_count() as u32 {
        let own = [Sign::Plus, Sign::Minus].map(|sign| node(cell(after, face, sign)));
        let of_input = after.fine_face_is_from(face, before.polygon_count());
        if of_input {
            joined.unite(own[0], own[1]);
            continue;
        }
        for &side in new_complex.packed_sides().list(face as usize) {
            if let Some(&(behind, front)) = cells.get(&(sheet(after, face), new_complex.side_ends(side))) {
                known[own[0] as usize] = Some(behind);
                known[own[1] as usize] = Some(front);
            }
        }
    }
    let mut of_class: Vec<Option<u32>> = vec![None; count + 1];
    of_class[joined.find(count as u32) as usize] = Some(NONE);
    for (own, known) in (0..).zip(known) {
        if let Some(known) = known {
            of_class[joined.find(own) as usize] = Some(known);
        }
    }
    (0..count as u32).map(|own| of_class[joined.find(own) as usize]).collect()
}

/// The vertex of the arrangement with cuts in the place of each fine vertex.
pub(super) fn vertices_of_cut(before: &SpatialArrangement, after: &SpatialArrangement) -> Vec<u32> {
    let (old, new) = (before.fine_triangles(), after.fine_triangles());
    let place = |[x, y, z]: [f64; 3]| [x + 0.0, y + 0.0, z + 0.0].map(f64::to_bits);
    let mut found: HashMap<[u64; 3], Vec<u32>> = HashMap::new();
    for vertex in 0..new.complex().vertex_count() as u32 {
        let rounded = new.point(VertexId::from_u32(vertex)).rounded();
        found.entry(place(rounded)).or_default().push(vertex);
    }
    let number = |vertex: u32| {
        let point = old.point(VertexId::from_u32(vertex));
        let known = found.get(&place(point.rounded()))?;
        let same = |&&other: &&u32| new.point(VertexId::from_u32(other)).compare(&point).is_eq();
        known.iter().find(same).copied()
    };
    (0..old.complex().vertex_count() as u32).map(|vertex| number(vertex).unwrap_or(NONE)).collect()
}
