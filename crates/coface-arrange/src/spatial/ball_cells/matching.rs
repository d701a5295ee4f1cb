//! The cells of an arrangement found again in one with cuts.

use super::NONE;
use crate::spatial::SpatialArrangement;
use coface_algebra::{FaceId, Sign, UnionFind, VertexId};
use rayon::prelude::*;

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
    let mut cells: Vec<(u32, [u32; 2], [u32; 2])> =
        Vec::with_capacity(old_complex.packed_sides().item_count());
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
            cells.push((sheet(before, face), ends, sides));
        }
    }
    cells.par_sort_unstable();
    let count = after.fine().cell_count();
    let node = |cell: u32| if cell == NONE { count as u32 } else { cell };
    let mut joined = UnionFind::new(count + 1);
    let mut known = vec![None; count + 1];
    for face in 0..new_complex.face_count() as u32 {
        let own = [Sign::Plus, Sign::Minus].map(|sign| node(cell(after, face, sign)));
        let is_new_cut = after.fine_face_is_from(face, before.polygon_count());
        if is_new_cut {
            joined.unite(own[0], own[1]);
            continue;
        }
        for &side in new_complex.packed_sides().list(face as usize) {
            let key = (sheet(after, face), new_complex.side_ends(side));
            let at = cells.partition_point(|known| (known.0, known.1) < key);
            if let Some(&(.., sides)) = cells.get(at).filter(|known| (known.0, known.1) == key) {
                known[own[0] as usize] = Some(sides[0]);
                known[own[1] as usize] = Some(sides[1]);
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
    let mut found: Vec<([u64; 3], u32)> = (0..new.complex().vertex_count() as u32)
        .into_par_iter()
        .map(|vertex| (place(new.point(VertexId::from_u32(vertex)).rounded()), vertex))
        .collect();
    found.par_sort_unstable();
    let number = |vertex: u32| {
        let point = old.point(VertexId::from_u32(vertex));
        let rounded = place(point.rounded());
        let start = found.partition_point(|known| known.0 < rounded);
        let mut known = found[start..].iter().take_while(|known| known.0 == rounded);
        known
            .find(|known| new.point(VertexId::from_u32(known.1)).compare(&point).is_eq())
            .map(|known| known.1)
    };
    let count = old.complex().vertex_count() as u32;
    (0..count).into_par_iter().map(|vertex| number(vertex).unwrap_or(NONE)).collect()
}
