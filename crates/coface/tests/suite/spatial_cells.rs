//! Cells of space against known numbers, against grids with walls taken out, and against their homology.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::solids::{Faces, rod_through_cube, shifted_cubes};
use coface::algebra::chains::ChainComplex;
use coface::algebra::{RaggedArray, Sign, UnionFind};
use coface::arrange::spatial::{PolygonalComplex, SpatialCells, gift_wrapped_shells};
use coface::geometry::Positions;
use coface::topology::homology;
use coface::{CellId, EdgeId, FaceId};
use proptest::prelude::*;
use std::collections::BTreeMap;

/// Everything that holds for all cells.
fn check(cells: &SpatialCells, positions: &Positions) {
    let complex = cells.chain_complex().unwrap();
    let surface = cells.complex().chain_complex().unwrap();
    // Alexander duality: the bounded parts of the complement are counted by the second homology of the faces.
    let betti = homology(&surface).betti_numbers();
    assert_eq!(betti.get(2).copied().unwrap_or(0), cells.cell_count());
    let betti = homology(&complex).betti_numbers();
    assert_eq!(betti.get(2..).map_or(0, |high| high.iter().sum()), 0);
    // Each half-face is in one shell, each shell in one cell or outside.
    let face_count = cells.complex().face_count();
    let mut seen = vec![0; 2 * face_count];
    let mut shell_seen = vec![0; cells.shell_count()];
    for cell in (0..cells.cell_count()).map(|cell| Some(CellId::new(cell))).chain([None]) {
        for &shell in cells.shells(cell) {
            shell_seen[shell as usize] += 1;
            for (face, sign) in cells.shell_sides(shell) {
                seen[2 * face.index() + usize::from(sign == Sign::Minus)] += 1;
                assert_eq!(cells.shell_at(face, sign), shell);
                assert_eq!(cells.cell_at(face, sign), cell);
            }
        }
    }
    assert!(seen.iter().chain(&shell_seen).all(|&count| count == 1));
    // The second method has the same shells in the same order.
    let wrapped = gift_wrapped_shells(face_count, cells.radial_order()).unwrap();
    assert_eq!(wrapped.column_count(), cells.shell_count());
    for (shell, column) in wrapped.columns().enumerate() {
        let mut chain = BTreeMap::new();
        for (face, sign) in cells.shell_sides(shell as u32) {
            *chain.entry(face.index()).or_insert(0) += sign.to_i32();
        }
        chain.retain(|_, coefficient| *coefficient != 0);
        assert!(column.iter().eq(chain));
    }
    // All boundaries together cancel.
    let (bounded, exterior) = (cells.cell_boundaries().unwrap(), cells.exterior_boundary().unwrap());
    let mut sum = vec![0; face_count];
    for (face, sign) in bounded.columns().chain(exterior.columns()).flat_map(|column| column.iter()) {
        sum[face] += sign;
    }
    assert!(sum.iter().all(|&sum| sum == 0));
    // The first shell of a cell is its outer one.
    let shells = cells.shell_volumes(positions).unwrap();
    let volumes = cells.volumes(positions).unwrap();
    for (cell, &volume) in volumes.iter().enumerate() {
        let own = cells.shells(Some(CellId::new(cell)));
        assert!(volume > 0.0 && shells[own[0] as usize] > 0.0, "{cell} {volume}");
        assert!(own[1..].iter().all(|&shell| shells[shell as usize] <= 0.0));
    }
    let total: f64 = volumes.iter().sum();
    let outside: f64 = cells.shells(None).iter().map(|&shell| shells[shell as usize]).sum();
    assert!((total + outside).abs() <= 1e-9 * total, "{total} {outside}");
    // Faces around an edge are those with the edge as a side.
    for edge in (0..cells.complex().edge_count()).map(EdgeId::new) {
        let mut around: Vec<_> = cells.faces_around(edge).collect();
        around.sort_unstable();
        let faces = (0..face_count).map(FaceId::new);
        let sides =
            faces.flat_map(|face| cells.complex().sides(face).map(move |(e, sign)| (e, (face, sign))));
        if cells.complex().edge_count() < 100 {
            let mut expected: Vec<_> = sides.filter(|side| side.0 == edge).map(|side| side.1).collect();
            expected.sort_unstable();
            assert_eq!(around, expected);
        }
    }
}

fn sorted(mut volumes: Vec<f64>) -> Vec<f64> {
    volumes.sort_by(f64::total_cmp);
    volumes
}

fn f_vector(complex: &ChainComplex) -> Vec<usize> {
    complex.f_vector().to_vec()
}

/// Checks cells of faces and of their images under all permutations and reflections of the axes.
fn expect(faces: &Faces, counts: [usize; 4], volumes: &[f64]) {
    for permutation in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        for signs in 0..8u8 {
            let motion = |p: [f64; 3]| {
                [0, 1, 2].map(|axis| p[permutation[axis]] * if signs >> axis & 1 == 1 { -1.0 } else { 1.0 })
            };
            let moved = faces.moved(motion);
            let cells = moved.cells();
            check(&cells, &moved.positions());
            assert_eq!(f_vector(&cells.chain_complex().unwrap()), counts, "{permutation:?} {signs}");
            let found = sorted(cells.volumes(&moved.positions()).unwrap());
            assert!(found.iter().zip(volumes).all(|(x, y)| (x - y).abs() <= 1e-12 * y), "{found:?}");
        }
    }
}

#[test]
fn cubes_that_touch_have_the_known_cells() {
    let cubes = |list: &[([f64; 3], f64)]| {
        let mut faces = Faces::default();
        list.iter().for_each(|&(low, side)| faces.add_cube(low, side));
        faces
    };
    let unit = ([0.0; 3], 1.0);
    // Here cells are the bounded ones: one less than with the exterior.
    expect(&cubes(&[unit]), [8, 12, 6, 1], &[1.0]);
    expect(&cubes(&[unit, unit]), [8, 12, 6, 1], &[1.0]);
    expect(&cubes(&[unit, ([1., 0., 0.], 1.)]), [12, 20, 11, 2], &[1.0, 1.0]);
    expect(&cubes(&[unit, ([1., 1., 0.], 1.)]), [14, 23, 12, 2], &[1.0, 1.0]);
    expect(&cubes(&[unit, ([1., 1., 1.], 1.)]), [15, 24, 12, 2], &[1.0, 1.0]);
    expect(&cubes(&[unit, ([3., 0., 0.], 1.)]), [16, 24, 12, 2], &[1.0, 1.0]);
    expect(&cubes(&[unit, ([0.25; 3], 0.5)]), [16, 24, 12, 2], &[0.125, 0.875]);
}

#[test]
fn faces_that_are_not_convex_and_faces_with_holes_have_cells() {
    expect(&shifted_cubes(), [22, 36, 18, 3], &[0.125, 0.875, 0.875]);
    expect(&rod_through_cube(), [24, 40, 22, 4], &[0.125, 0.125, 0.25, 0.75]);
}

#[test]
fn scale_does_not_matter() {
    let power = |exponent: i32| 2f64.powi(exponent);
    // So small and so large that products of coordinates leave the range of ordinary numbers.
    for exponent in [-300, 300] {
        let faces = rod_through_cube().moved(|p| p.map(|x| x * power(exponent)));
        let volume = power(3 * exponent);
        expect(&faces, [24, 40, 22, 4], &[0.125, 0.125, 0.25, 0.75].map(|part| part * volume));
    }
    // A small cube in a large one, another at its lower corner from outside.
    let mut faces = Faces::default();
    faces.add_cube([0.0; 3], power(20));
    faces.add_cube([1.0; 3], power(-30));
    faces.add_cube([-power(-30); 3], power(-30));
    expect(&faces, [23, 36, 18, 3], &[power(-90), power(-90), power(60)]);
}

#[test]
fn shells_nest_to_any_depth() {
    let mut faces = Faces::default();
    // Four in one another, the innermost two side by side; and one beside all, level with them.
    for (low, side) in [(0.0, 64.0), (8.0, 48.0), (16.0, 32.0)] {
        faces.add_cube([low; 3], side);
    }
    faces.add_cube([20., 20., 20.], 8.0);
    faces.add_cube([36., 20., 20.], 8.0);
    faces.add_cube([-40., 20., 20.], 8.0);
    let inner: f64 = 512.0;
    let sides: [f64; 3] = [64.0, 48.0, 32.0];
    let [a, b, c] = sides.map(|side| side.powi(3));
    expect(&faces, [48, 72, 36, 6], &sorted(vec![inner, inner, inner, c - 2.0 * inner, b - c, a - b]));
    let cells = faces.cells();
    assert_eq!(cells.component_count(), 6);
    let mut shells: Vec<usize> = (0..6).map(|cell| cells.shells(Some(CellId::new(cell))).len()).collect();
    shells.sort_unstable();
    assert_eq!((shells, cells.shells(None).len()), (vec![1, 1, 1, 2, 2, 3], 2));
}

#[test]
fn components_that_touch_in_vertices_nest() {
    let scaled = |t: [[f64; 3]; 4], factor: f64| t.map(|p| p.map(|x| factor * x));
    let large = [[0., 0., 0.], [16., 1., 1.], [1., 16., 1.], [1., 1., 16.]];
    let small = [[0., 0., 0.], [4., 3., 3.], [3., 4., 3.], [3., 3., 4.]];
    let volume = |[a, b, c, d]: [[f64; 3]; 4]| {
        let e = |p: [f64; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
        let ([x, y, z], [u, v, w], [r, s, t]) = (e(b), e(c), e(d));
        (x * (v * t - w * s) + y * (w * r - u * t) + z * (u * s - v * r)).abs() / 6.0
    };
    // Three tetrahedra in one another with one common vertex, the tip of all.
    let mut faces = Faces::default();
    faces.add_tetrahedron(large);
    faces.add_tetrahedron(small);
    faces.add_tetrahedron(
        [[0., 0., 0.], [8., 7., 7.], [7., 8., 7.], [7., 7., 8.]].map(|p| p.map(|x| x / 8.0)),
    );
    let third = 22.0 / 6.0 / 512.0;
    expect(
        &faces,
        [10, 18, 12, 3],
        &sorted(vec![third, volume(small) - third, volume(large) - volume(small)]),
    );
    // A tetrahedron whose tip is inside a face of a cube, once within and once outside.
    for factor in [0.125, -0.125] {
        let mut faces = Faces::default();
        faces.add_cube([0., -1., -1.], 2.0);
        let tip = scaled([[0., 0., 0.], [4., 1., 1.], [4., -2., 1.], [4., 0., -2.]], factor);
        faces.add_tetrahedron(tip);
        let cube = if factor > 0.0 { 8.0 - volume(tip) } else { 8.0 };
        expect(&faces, [12, 18, 10, 2], &[volume(tip), cube]);
    }
}

#[test]
fn cells_need_not_be_balls() {
    let ring = |keep: &dyn Fn(i32, i32, i32) -> bool| -> Vec<[i32; 3]> {
        let cubes = (-8..9).flat_map(|x| (-8..9).flat_map(move |y| (-8..9).map(move |z| [x, y, z])));
        cubes.filter(|&[x, y, z]| keep(x, y, z)).collect()
    };
    // A torus in a torus in a torus.
    let mut faces = Faces::default();
    for width in [0, 1, 2] {
        faces.add_cubes(&ring(&|x, y, z| (x.abs().max(y.abs()) - 4).abs() <= width && z.abs() <= width));
    }
    let cells = faces.cells();
    check(&cells, &faces.positions());
    let count = |width: i32| {
        let side = |half: i32| (2 * half + 1) * (2 * half + 1);
        f64::from((side(4 + width) - side(3 - width)) * (2 * width + 1))
    };
    assert_eq!(
        sorted(cells.volumes(&faces.positions()).unwrap()),
        sorted(vec![count(0), count(1) - count(0), count(2) - count(1)])
    );
    // Linked rings: neither is within the other.
    let mut faces = Faces::default();
    faces.add_cubes(&ring(&|x, y, z| x.abs().max(y.abs()) == 2 && z == 0));
    faces.add_cubes(&ring(&|x, y, z| (x - 2).abs().max(z.abs()) == 2 && y == 0));
    let cells = faces.cells();
    check(&cells, &faces.positions());
    assert_eq!(cells.volumes(&faces.positions()).unwrap(), [16.0, 16.0]);
    assert_eq!((cells.component_count(), cells.shells(None).len()), (2, 2));
    let betti = homology(&cells.complex().chain_complex().unwrap()).betti_numbers();
    assert_eq!(betti, [2, 4, 2]);
}

#[test]
fn dangling_faces_and_slits_are_kept() {
    // A fin on an edge of a cube, a fin on its top that ends inside the face, a loose triangle inside, a loose edge.
    let flat = vec![
        0., 0., 0., 4., 0., 0., 4., 4., 0., 0., 4., 0., 0., 0., 4., 4., 0., 4., 4., 4., 4., 0., 4.,
        4., // cube
        -1., -1., 2., // 8: tip of the fin on the edge 0 4
        1., 1., 4., 2., 2., 4., 2., 2., 6., // 9, 10: a slit in the top; 11: above it
        1., 1., 1., 2., 1., 1., 1., 2., 1., // 12, 13, 14: loose triangle
        9., 9., 9., // 15: end of a loose edge
    ];
    let walks = RaggedArray::from_lists([
        vec![0, 3, 2, 1],
        vec![4, 5, 6, 7],
        vec![9, 10],
        vec![0, 1, 5, 4],
        vec![1, 2, 6, 5],
        vec![2, 3, 7, 6],
        vec![3, 0, 4, 7],
        vec![0, 4, 8],
        vec![9, 10, 11],
        vec![12, 13, 14],
    ]);
    let faces = [0, 1, 1, 2, 3, 4, 5, 6, 7, 8];
    let complex = PolygonalComplex::from_walks(16, &walks, &faces, &[[6, 15]]).unwrap();
    let positions = Positions::from_flat(3, flat).unwrap();
    let cells = SpatialCells::new(complex, &positions).unwrap();
    check(&cells, &positions);
    assert_eq!(f_vector(&cells.chain_complex().unwrap()), [16, 21, 9, 1]);
    assert_eq!(cells.volumes(&positions).unwrap(), [64.0]);
    assert_eq!(cells.dangling_faces().collect::<Vec<_>>(), [6, 7, 8].map(FaceId::new));
    assert_eq!(cells.cell_at(FaceId::new(8), Sign::Plus), Some(CellId::new(0)));
    assert_eq!(cells.cell_at(FaceId::new(7), Sign::Plus), None);
    // Around the slit: the fin, and the top on both sides.
    let slit = cells.complex().edges().iter().position(|&ends| ends == [9, 10]).unwrap();
    assert_eq!(cells.faces_around(EdgeId::new(slit)).len(), 3);
}

#[test]
fn input_that_is_not_conforming_is_named() {
    let message = |faces: &Faces| {
        SpatialCells::new(faces.complex(), &faces.positions()).unwrap_err().message().to_owned()
    };
    // Two coplanar triangles that overlap along an edge.
    let mut overlap = Faces::default();
    overlap.add(&[&[[0., 0., 0.], [4., 0., 0.], [0., 4., 0.]]]);
    overlap.add(&[&[[0., 0., 0.], [4., 0., 0.], [4., 4., 0.]]]);
    assert!(message(&overlap).starts_with("faces f0 and f1 leave edge e0 in the same direction"));
    let mut crooked = Faces::default();
    crooked.add(&[&[[0., 0., 0.], [4., 0., 0.], [4., 4., 1e-300], [0., 4., 0.]]]);
    assert_eq!(message(&crooked), "face f0 is not flat: v2 is not in the plane of v0, v1, v3");
    let mut thin = Faces::default();
    thin.add(&[&[[0., 0., 0.], [0.1, 0.1, 0.1], [0.7, 0.7, 0.7]]]);
    assert!(message(&thin).starts_with("face f0 has no area"));
    let planar = Positions::from_flat(2, vec![0.0; 6]).unwrap();
    let triangle = PolygonalComplex::from_polygons(3, &RaggedArray::from_lists([[0, 1, 2]])).unwrap();
    assert!(SpatialCells::new(triangle, &planar).is_err());
    // Two cubes that cross, the least vertex of the second on a face of the first.
    let mut crossing = Faces::default();
    crossing.add_cube([0.; 3], 2.0);
    crossing.add(&[&[[2., 1., 1.], [2., 1.5, 1.], [2., 1., 1.5]]]);
    assert!(message(&crossing).contains("cross face f"), "{}", message(&crossing));
}

#[test]
fn nothing_has_no_cells() {
    let complex = PolygonalComplex::from_walks(2, &RaggedArray::new(), &[], &[[0, 1]]).unwrap();
    let positions = Positions::from_flat(3, vec![0., 0., 0., 1., 1., 1.]).unwrap();
    let cells = SpatialCells::new(complex, &positions).unwrap();
    check(&cells, &positions);
    assert_eq!((cells.cell_count(), cells.component_count()), (0, 0));
}

/// The walls of a grid of k x k x k cubes, by axis and by their lower corners, and the two cubes at each: behind and in front along
/// the axis, the number of cubes standing for the exterior.
fn walls(k: u32) -> Vec<(usize, [u32; 3], [u32; 2])> {
    let cube = |place: [i64; 3]| {
        let inside = place.iter().all(|&x| (0..i64::from(k)).contains(&x));
        if inside { place.iter().fold(0, |number, &x| number * k + x as u32) } else { k * k * k }
    };
    let mut walls = Vec::new();
    for axis in 0..3 {
        for i in 0..(k + 1).pow(3) {
            let corner = [i / (k + 1) / (k + 1), i / (k + 1) % (k + 1), i % (k + 1)];
            if (0..3).any(|other| other != axis && corner[other] == k) {
                continue;
            }
            let front = corner.map(i64::from);
            let mut back = front;
            back[axis] -= 1;
            walls.push((axis, corner, [cube(back), cube(front)]));
        }
    }
    walls
}

/// Which walls stand, which are turned around, and how vertices are moved.
#[derive(Clone, Debug)]
struct WallSample {
    size: u32,
    walls: Vec<(usize, [u32; 3], [u32; 2])>,
    turned: Vec<bool>,
}

fn wall_samples() -> impl Strategy<Value = WallSample> {
    (1u32..4, 1u32..9).prop_flat_map(|(size, density)| {
        let all = walls(size);
        let keep = prop::collection::vec((0u32..8, any::<bool>()), all.len());
        keep.prop_map(move |keep| {
            let kept = all.iter().zip(&keep).filter(|(_, (number, _))| *number < density);
            let (walls, turned) = kept.map(|(&wall, &(_, turned))| (wall, turned)).unzip();
            WallSample { size, walls, turned }
        })
    })
}

/// The second method: cubes united where no wall stands. Compares the parts behind and in front of each face, and volumes.
fn compare(sample: &WallSample, cells: &SpatialCells, faces_per_wall: usize, mirrored: bool) -> Vec<f64> {
    let count = sample.size.pow(3);
    let mut parts = UnionFind::new(count as usize + 1);
    for (axis, corner, sides) in walls(sample.size) {
        if !sample.walls.iter().any(|wall| (wall.0, wall.1) == (axis, corner)) {
            parts.unite(sides[0], sides[1]);
        }
    }
    let numbers = parts.class_numbers();
    let exterior = numbers[count as usize];
    let mut part_of_cell = BTreeMap::new();
    for (i, (wall, &turned)) in sample.walls.iter().zip(&sample.turned).enumerate() {
        let [behind, before] = if turned != mirrored { [wall.2[1], wall.2[0]] } else { wall.2 };
        for face in (faces_per_wall * i..faces_per_wall * (i + 1)).map(FaceId::new) {
            for (cube, sign) in [(behind, Sign::Plus), (before, Sign::Minus)] {
                let part = numbers[cube as usize];
                let cell = cells.cell_at(face, sign);
                assert_eq!(cell.is_none(), part == exterior);
                assert_eq!(*part_of_cell.entry(cell).or_insert(part), part);
            }
        }
    }
    assert_eq!(cells.cell_count() + 1, parts.class_count());
    let mut sizes = vec![0.0; cells.cell_count()];
    for (cell, part) in part_of_cell {
        if let Some(cell) = cell {
            sizes[cell.index()] = numbers[..count as usize].iter().filter(|&&n| n == part).count() as f64;
        }
    }
    sizes
}

/// The corners of a wall, counterclockwise seen from the far end of its axis unless it is turned.
fn corners(wall: &(usize, [u32; 3], [u32; 2]), turned: bool) -> [[u32; 3]; 4] {
    let (axis, corner, _) = *wall;
    let mut square = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[u, v]| {
        let mut place = corner;
        place[(axis + 1) % 3] += u;
        place[(axis + 2) % 3] += v;
        place
    });
    if turned {
        square.reverse();
    }
    square
}

proptest! {
    /// Under linear maps with integers faces stay flat, and angles are any.
    #[test]
    fn grids_with_walls_taken_out_are_parts_of_cubes(
        sample in wall_samples(), entries in prop::array::uniform9(-3i32..4),
    ) {
        let m = entries;
        let determinant = m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6])
            + m[2] * (m[3] * m[7] - m[4] * m[6]);
        prop_assume!(determinant != 0);
        let mut faces = Faces::default();
        for (wall, &turned) in sample.walls.iter().zip(&sample.turned) {
            let square = corners(wall, turned).map(|place| {
                let p = place.map(|x| x as i32);
                [0, 3, 6].map(|row| f64::from(m[row] * p[0] + m[row + 1] * p[1] + m[row + 2] * p[2]))
            });
            faces.add(&[&square]);
        }
        let cells = faces.cells();
        check(&cells, &faces.positions());
        let sizes = compare(&sample, &cells, 1, determinant < 0);
        for (found, size) in cells.volumes(&faces.positions()).unwrap().iter().zip(sizes) {
            let volume = size * f64::from(determinant.abs());
            prop_assert!((found - volume).abs() < 1e-9 * volume);
        }
    }

    /// Vertices moved by less than walls can bear, walls as two triangles each.
    #[test]
    fn crooked_grids_are_parts_of_cubes(
        sample in wall_samples(), shifts in prop::collection::vec(-0.1f64..0.1, 192), turn in 0.0f64..6.0,
    ) {
        let (sine, cosine) = turn.sin_cos();
        let place = |p: [u32; 3]| {
            let number = p.iter().fold(0, |number, &x| 4 * number + x as usize);
            let [x, y, z] = [0, 1, 2].map(|axis| f64::from(p[axis]) + shifts[3 * number + axis]);
            [cosine * x - sine * y, sine * x + cosine * y, z]
        };
        let mut faces = Faces::default();
        for (wall, &turned) in sample.walls.iter().zip(&sample.turned) {
            let [a, b, c, d] = corners(wall, turned).map(place);
            faces.add(&[&[a, b, c]]);
            faces.add(&[&[a, c, d]]);
        }
        let cells = faces.cells();
        check(&cells, &faces.positions());
        compare(&sample, &cells, 2, false);
    }
}
