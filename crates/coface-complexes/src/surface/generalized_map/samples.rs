//! Surfaces for tests, of this crate and of those above it (feature `samples`).
#![allow(clippy::unwrap_used, reason = "a sample that cannot be made is a failing test")]

use crate::known_spaces;
use crate::simplicial::SimplicialComplex;
use crate::surface::{GeneralizedMap, HalfedgeMesh, PolygonMesh};
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::{EdgeId, Error};
use coface_algebra::{RaggedArray, Sign};
use coface_geometry::Positions;

/// Where the vertices of a surface lie.
pub type Places = Positions;

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

pub fn map_of(space: Result<SimplicialComplex, Error>) -> GeneralizedMap {
    GeneralizedMap::new(space.unwrap().freeze().two_skeleton().unwrap()).unwrap()
}

/// One polygon with these letters on its sides; letter -i is side i backwards. A letter that stands alone is on the
/// boundary.
pub fn polygon(letters: &[i32]) -> GeneralizedMap {
    let sides = letters.len() as u32;
    let flags = 2 * sides;
    let other_end = (0..flags).map(|flag| flag ^ 1).collect();
    let corner =
        (0..flags).map(|flag| if flag % 2 == 0 { (flag + flags - 1) % flags } else { (flag + 1) % flags });
    let mate = (0..flags).map(|flag| {
        let letter = letters[flag as usize / 2];
        let found = (0..sides).find(|&s| s != flag / 2 && letters[s as usize].abs() == letter.abs());
        found.map_or(flag, |s| 2 * s + ((flag & 1) ^ u32::from(letters[s as usize] != letter)))
    });
    GeneralizedMap::from_involutions(&[other_end, corner.collect(), mate.collect()]).unwrap().0
}

/// The closed oriented surface of a permutation of halfedges.
pub fn of_next(next: Vec<u32>) -> GeneralizedMap {
    GeneralizedMap::new(HalfedgeMesh::from_next(next).unwrap().two_skeleton().unwrap()).unwrap()
}

/// The closed oriented surface of this genus, a sum of grids of tori.
pub fn genus(genus: usize) -> GeneralizedMap {
    let torus = || known_spaces::torus_grid(&[4, 4]).unwrap();
    let sum =
        (1..genus).fold(torus(), |sum, _| known_spaces::oriented_sum(&sum, &torus(), Sign::Plus).unwrap());
    map_of(Ok(sum))
}

/// The same surface with some faces turned over; bit f of `turned` is for face f.
pub fn with_faces_turned(map: &GeneralizedMap, turned: u64) -> GeneralizedMap {
    let skeleton = map.skeleton();
    let faces = skeleton.faces().iter().enumerate().map(|(face, rim)| {
        if turned >> (face % 64) & 1 == 0 {
            rim.to_vec()
        } else {
            rim.iter().rev().map(|step| step ^ 1).collect()
        }
    });
    let faces = RaggedArray::from_lists(faces);
    let skeleton = TwoSkeleton::new(skeleton.vertex_count(), skeleton.edge_ends().to_vec(), faces).unwrap();
    GeneralizedMap::new(skeleton).unwrap()
}

/// The same surface without some faces, and without edges that no face is left at. What is left may have vertices of
/// several fans, in which case nothing is given.
pub fn without_faces(map: &GeneralizedMap, gone: &[usize]) -> Option<GeneralizedMap> {
    let skeleton = map.skeleton();
    let rims =
        skeleton.faces().iter().enumerate().filter(|(face, _)| !gone.contains(face)).map(|(_, rim)| rim);
    let mut faces = RaggedArray::from_lists(rims);
    let mut number = vec![NONE; skeleton.edge_count()];
    let mut ends = Vec::new();
    for step in faces.items_mut() {
        let edge = EdgeId::from_u32(*step >> 1);
        if number[edge.index()] == NONE {
            number[edge.index()] = ends.len() as u32 / 2;
            ends.extend(skeleton.edge(edge).map(|vertex| vertex.to_u32()));
        }
        *step = 2 * number[edge.index()] + (*step & 1);
    }
    let skeleton = TwoSkeleton::new(skeleton.vertex_count(), ends, faces).unwrap();
    GeneralizedMap::new(skeleton).ok()
}

/// The same surface without the faces that have a bit in `removed`; see [`without_faces`].
pub fn with_holes(map: &GeneralizedMap, removed: u64) -> Option<GeneralizedMap> {
    let gone = (0..map.f_vector()[2]).filter(|face| removed >> (face % 64) & 1 == 1);
    without_faces(map, &gone.collect::<Vec<_>>())
}

/// Surfaces of all kinds, with their names.
pub fn all_kinds() -> Vec<(&'static str, GeneralizedMap)> {
    vec![
        ("torus of 7 vertices", map_of(known_spaces::cyclic_torus(2))),
        ("sphere", map_of(known_spaces::simplex_boundary(2))),
        ("octahedron", map_of(known_spaces::cross_polytope_boundary(2))),
        ("Klein bottle", map_of(known_spaces::small_klein_bottle())),
        ("projective plane", map_of(known_spaces::projective_plane())),
        ("Moebius band", map_of(known_spaces::triangle_strip(5))),
        ("annulus", map_of(known_spaces::triangle_strip(6))),
        ("disk", map_of(known_spaces::simplex(2))),
        ("double torus", genus(2)),
        ("three crosscaps", polygon(&[1, 1, 2, 2, 3, 3])),
        ("four crosscaps", polygon(&[1, 2, -1, 2, 3, 3, 4, 4])),
        ("square Klein bottle", polygon(&[1, 2, -1, 2])),
        ("square torus", polygon(&[1, 2, -1, -2])),
        ("projective digon", polygon(&[1, 1])),
        ("Moebius square", polygon(&[1, 2, 1, 3])),
        ("pair of pants", polygon(&[1, 2, -1, 3, 4, -3, 5])),
        ("torus with a hole", polygon(&[1, 2, -1, -2, 3])),
        ("two crosscaps with a hole", polygon(&[1, 1, 2, 2, 3])),
        ("two squares glued", of_next(vec![2, 3, 1, 0, 4, 5])),
    ]
}

/// The triangles around a closed curve in space, with circles of `corners` points at `places` values of its parameter.
pub fn tube(
    curve: impl Fn(f64) -> [f64; 3],
    [places, corners]: [u32; 2],
    radius: f64,
) -> (GeneralizedMap, Positions) {
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
    };
    let unit = |a: [f64; 3]| {
        let length = a.iter().map(|x| x * x).sum::<f64>().sqrt();
        a.map(|x| x / length)
    };
    let mut points = Vec::new();
    for i in 0..places {
        let at = std::f64::consts::TAU * f64::from(i) / f64::from(places);
        let (before, after, middle) = (curve(at - 1e-4), curve(at + 1e-4), curve(at));
        let along = unit([0, 1, 2].map(|axis| after[axis] - before[axis]));
        let across = unit(cross(along, if along[2].abs() < 0.9 { [0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0] }));
        let third = cross(along, across);
        for j in 0..corners {
            let (sine, cosine) = (std::f64::consts::TAU * f64::from(j) / f64::from(corners)).sin_cos();
            points.extend(
                [0, 1, 2].map(|axis| middle[axis] + radius * (cosine * across[axis] + sine * third[axis])),
            );
        }
    }
    let vertex = |i: u32, j: u32| (i % places) * corners + j % corners;
    let squares = (0..places).flat_map(|i| (0..corners).map(move |j| (i, j)));
    let triangles: Vec<[u32; 3]> = squares
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    placed_map(&triangles, points)
}

/// The trefoil knot.
pub fn trefoil(t: f64) -> [f64; 3] {
    [t.sin() + 2.0 * (2.0 * t).sin(), t.cos() - 2.0 * (2.0 * t).cos(), -(3.0 * t).sin()]
}

/// The boundary of some unit cubes, each by its lowest corner, as triangles; the cubes touch each other in faces alone. The diagonals of squares
/// depend on `turned`.
pub fn cubes(cells: &[[i32; 3]], turned: u64) -> (GeneralizedMap, Positions) {
    let mut numbers: std::collections::BTreeMap<[i32; 3], u32> = std::collections::BTreeMap::new();
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    // Not `cell[axis] += by`: Rust 1.95 compiles that wrongly with the optimizations of the profile of development.
    let moved = |cell: [i32; 3], axis: usize, by: i32| -> [i32; 3] {
        std::array::from_fn(|i| cell[i] + if i == axis { by } else { 0 })
    };
    for &cell in cells {
        for axis in 0..3 {
            for side in [0, 1] {
                if cells.contains(&moved(cell, axis, 2 * side - 1)) {
                    continue;
                }
                let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
                let corner = moved(cell, axis, side);
                let mut square =
                    [corner, moved(corner, j, 1), moved(moved(corner, j, 1), k, 1), moved(corner, k, 1)];
                if side == 0 {
                    square.reverse();
                }
                let first = (turned >> (triangles.len() / 2 % 64) & 1) as usize;
                let square = [0, 1, 2, 3].map(|i| {
                    let next = numbers.len() as u32;
                    *numbers.entry(square[(i + first) % 4]).or_insert(next)
                });
                triangles.push([square[0], square[1], square[2]]);
                triangles.push([square[0], square[2], square[3]]);
            }
        }
    }
    let mut points = vec![0.0; 3 * numbers.len()];
    for (place, number) in numbers {
        points[3 * number as usize..][..3].copy_from_slice(&place.map(f64::from));
    }
    placed_map(&triangles, points)
}

/// A cube of five by five by five unit cubes with straight tunnels: bits 0 to 3 along the first axis, and so on.
pub fn drilled_cube(tunnels: u32) -> Vec<[i32; 3]> {
    let all = (0..125).map(|i| [i / 25, i / 5 % 5, i % 5]);
    let is_kept = |cell: &[i32; 3]| {
        !(0..3).any(|axis| {
            let (j, k) = (cell[(axis + 1) % 3], cell[(axis + 2) % 3]);
            j % 2 == 1 && k % 2 == 1 && tunnels >> (4 * axis as i32 + j / 2 * 2 + k / 2) & 1 == 1
        })
    };
    all.filter(is_kept).collect()
}

fn placed_map(triangles: &[[u32; 3]], points: Vec<f64>) -> (GeneralizedMap, Positions) {
    let positions = Positions::from_flat(3, points).expect("three coordinates a point");
    let mesh = PolygonMesh::new(positions.len(), RaggedArray::from_lists(triangles), &[])
        .expect("triangles of vertices");
    let skeleton = mesh.two_skeleton().expect("a small mesh");
    (GeneralizedMap::new(skeleton).expect("a surface"), positions)
}
