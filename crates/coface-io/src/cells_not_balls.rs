//! Cells of a chain complex that are no balls.

use crate::remark::{Place, Remark, RemarkCode};
use coface_algebra::UnionFind;
use coface_algebra::chains::ChainComplex;

/// A remark on cells of degree 2 and 3 that cannot be balls, where edges have two ends: faces whose boundary is in several
/// parts, and 3-cells whose boundary is no single sphere.
///
/// # Complexity
/// $O(n \log n)$ for n corners of faces of cells.
///
/// # Examples
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// // Two circles of two edges each, and one face between them: a ring, not a disk.
/// let ends = [(0, 0), (1, 0), (0, 1), (1, 1), (2, 2), (3, 2), (2, 3), (3, 3)];
/// let ends = ends.into_iter().enumerate().map(|(i, (row, edge))| (row, edge, [-1, 1, 1, -1][i % 4]));
/// let edges = SparseMatrix::from_entries(4, 4, ends)?;
/// let faces = SparseMatrix::from_entries(4, 1, (0..4).map(|edge| (edge, 0, 1)))?;
/// let ring = ChainComplex::new(vec![edges, faces])?;
/// assert_eq!(coface_io::cells_not_balls(&ring).expect("its rim has two parts").count, 1);
/// # Ok(()) }
/// ```
pub fn cells_not_balls(complex: &ChainComplex) -> Option<Remark> {
    let edges = complex.boundary_matrix(1)?;
    if edges.columns().any(|ends| !matches!(ends.entries(), [1, -1] | [-1, 1])) {
        return None;
    }
    let faces = complex.boundary_matrix(2)?;
    let ends = |edge: u32| edges.column(edge as usize).rows();
    let parts_of = |own: &[u32]| {
        let mut vertices: Vec<u32> = own.iter().flat_map(|&edge| ends(edge)).copied().collect();
        vertices.sort_unstable();
        vertices.dedup();
        let place = |vertex: u32| vertices.partition_point(|&other| other < vertex) as u32;
        let mut joined = UnionFind::new(vertices.len());
        for &edge in own {
            if let &[a, b] = ends(edge) {
                joined.unite(place(a), place(b));
            }
        }
        joined.class_count()
    };
    let no_disk: Vec<u32> = (0..faces.column_count() as u32)
        .filter(|&face| parts_of(faces.column(face as usize).rows()) > 1)
        .collect();
    let cells = complex.boundary_matrix(3).map_or(0, |cells| cells.column_count() as u32);
    // Edges in no face may be bridges from one part of a boundary to another.
    let mut is_loose = vec![true; edges.column_count()];
    faces.rows().iter().for_each(|&edge| is_loose[edge as usize] = false);
    let bridges: Vec<[u32; 2]> = (0..edges.column_count())
        .filter(|&edge| is_loose[edge])
        .filter_map(|edge| ends(edge as u32).try_into().ok())
        .collect();
    let no_ball: Vec<u32> = (0..cells).filter(|&cell| !is_ball(complex, cell, &no_disk, &bridges)).collect();
    let said = match (no_disk.len(), no_ball.len()) {
        (0, 0) => return None,
        (disks, 0) => counted(disks, "face has a rim in several parts", "faces have rims in several parts"),
        (0, balls) => counted(balls, "cell has voids or tunnels", "cells have voids or tunnels"),
        (disks, balls) => format!(
            "{} and {}",
            counted(disks, "face has a rim in several parts", "faces have rims in several parts"),
            counted(balls, "cell has voids or tunnels", "cells have voids or tunnels")
        ),
    };
    let message = format!("{said}: the homology is that of the boundary matrices, not that of the space");
    let places = no_disk.iter().chain(&no_ball).map(|&cell| Place::cell(&[cell]));
    Some(Remark::new(RemarkCode::CellsNotBalls, message).at(no_disk.len() + no_ball.len(), places))
}

/// Whether the boundary of a 3-cell is spheres, connected by vertices and bridges, as far as it can be told: where it is no
/// surface, or has faces that are no disks, it counts as that if it is connected.
fn is_ball(complex: &ChainComplex, cell: u32, no_disk: &[u32], bridges: &[[u32; 2]]) -> bool {
    let (Some(edges), Some(faces), Some(cells)) =
        (complex.boundary_matrix(1), complex.boundary_matrix(2), complex.boundary_matrix(3))
    else {
        return true;
    };
    let own = cells.column(cell as usize).rows();
    // The corners of faces: vertex, edge, face.
    let mut corners: Vec<(u32, u32, u32)> = Vec::new();
    for (place, &face) in (0..).zip(own) {
        for &edge in faces.column(face as usize).rows() {
            corners.extend(edges.column(edge as usize).rows().iter().map(|&vertex| (vertex, edge, place)));
        }
    }
    corners.sort_unstable();
    let mut shells = UnionFind::new(own.len());
    let (mut vertices, mut sides) = (0i64, 0i64);
    let mut is_surface = own.iter().all(|face| no_disk.binary_search(face).is_err());
    for at in corners.chunk_by(|x, y| x.0 == y.0) {
        let mut around: Vec<u32> = at.iter().map(|corner| corner.2).collect();
        around.sort_unstable();
        around.dedup();
        let place = |face: u32| around.partition_point(|&other| other < face) as u32;
        let mut fans = UnionFind::new(around.len());
        for edge in at.chunk_by(|x, y| x.1 == y.1) {
            is_surface &= edge.len() == 2;
            sides += edge.len() as i64;
            edge.windows(2).for_each(|pair| {
                fans.unite(place(pair[0].2), place(pair[1].2));
            });
        }
        vertices += fans.class_count() as i64;
        around.windows(2).for_each(|pair| {
            shells.unite(pair[0], pair[1]);
        });
    }
    // Each edge was seen from both of its ends, with two faces.
    let characteristic = vertices - sides / 4 + own.len() as i64;
    let shell_of = |vertex: u32| {
        let at = corners.partition_point(|corner| corner.0 < vertex);
        corners.get(at).filter(|corner| corner.0 == vertex).map(|corner| corner.2)
    };
    let mut spheres = 1;
    if shells.class_count() > 1 {
        for &[a, b] in bridges {
            if let (Some(a), Some(b)) = (shell_of(a), shell_of(b))
                && shells.unite(a, b)
            {
                spheres += 1;
            }
        }
    }
    own.is_empty() || shells.class_count() == 1 && (!is_surface || characteristic == 2 * spheres)
}

fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
