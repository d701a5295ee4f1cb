//! Generated inputs: each is named on the command line by a family and its size, and is the same on every machine.
//!
//! # Words
//! * `icoN`: the icosphere of level N, $20 \cdot 4^N$ triangles; new vertices are numbered level by level.
//! * `spheresN`: two icospheres of level N that overlap, one after the other.
//! * `genus10_M`: a flat plate of M by M quads, two-sided, with ten square holes, each quad cut into two triangles.
//! * `plateG_M`: such a plate with G holes in rows and columns.
//! * `st_KxM`: a solid torus, K by K by M cubes closed up in the last direction, six tetrahedra a cube.
//! * `t3_N`: the 3-torus, N by N by N cubes closed up in all directions, six tetrahedra a cube.
//! * `grid3_N`: the cube, N by N by N cubes, six tetrahedra a cube.
//! * `t4_N`, `grid4_N`: the 4-torus and the 4-dimensional cube, $N^4$ cubes, 24 simplices each.
//! * `lm_NxM`: all edges on N vertices and M random triangles.
//! * `sum_N`: the sum complex modulo N with the sums 0, 1, 3; its torsion grows exponentially.
//! * `soupN`: the icosphere of level N with three vertices for each triangle, each coordinate off by up to 1e-9.
//! * `cubes_sep_K`: K by K by K cubes, each of six squares with four vertices of their own, each coordinate off by up to 1e-8.
//! * `cuboid_edges_K`, `cuboid_faces_K`: the edges and the squares of the K by K by K cuboid grid, as lists of vertices.
//! * `simp_N`: N random simplices of dimension 0 to 5 on N/10 vertices.
//! * `seg_N`, `long_N`: N random segments in the plane; about eight crossings each, or all of length 0.4.
//! * `coast_N`, `star_N`, `squares_N`: two regions in the plane with N vertices each: two curves that cross a few times, two
//!   polygons of random radii, two grids of squares. Coordinates are integers below 2^28.
//! * `random_N`, `gear_N`, `circle_N`, `grid_N`: the same at random angles, with radii 0.9 and 1 in turns, regular, and squares that are not
//!   turned: their edges overlap.
//! * `flower_N`: two polygons with radii 0.8 and 1.2 in turns, through which smooth flowers go.
//! * `torus_NxP`: the 3-torus of N by N by N voxels, to be cut into P blocks; the file holds the name alone.
//! * `gyroid_N`, `box_N`: N by N by N voxels: one side of the gyroid with noise, and all.
//! * `boxrow_N`, `boxblock_N`, `dolls_N`: N boxes of twelve triangles, in a row, in a block, around each other.
//! * `turned_N`: N boxes around the middle, turned about two axes.
//! * `rooms_N`: N rooms in rows shifted like bricks, turned by 30 degrees.
//! * `nested_N`: N squares one around the other, turned by 0.3 radians, counterclockwise and clockwise in turns.

mod boxes;
mod cubes;
mod drawings;
mod mesh;
mod plate;
mod random_simplices;
mod soups;
mod sphere;
mod volumes;

pub(crate) use mesh::Mesh;
pub(crate) use random_simplices::random_values;
pub(crate) use volumes::torus;

use coface::Error;
use coface::complexes::known_spaces::sum_complex;
use std::path::Path;

/// The families, as a person writes them.
pub(crate) const FAMILIES: &[(&str, &str)] = &[
    ("icoN", "icosphere of level N, 20 * 4^N triangles (ico8: 1,310,720)"),
    ("spheresN", "two overlapping icospheres of level N, 40 * 4^N triangles (spheres6: 163,840)"),
    ("genus10_M", "closed surface of genus 10 (genus10_160: 100,480 triangles, genus10_510: 1,010,880)"),
    (
        "plateG_M",
        "closed surface of genus G, an M by M plate with G holes (plate32_255: about 250,000 triangles)",
    ),
    ("st_KxM", "solid torus of 6 K K M tetrahedra (st_16x65: 99,840, st_32x163: 1,001,472)"),
    ("t3_N", "3-torus of 6 N N N tetrahedra (t3_26: 105,456, t3_55: 998,250)"),
    ("grid3_N", "cube of 6 N N N tetrahedra (grid3_26: 105,456, grid3_55: 998,250)"),
    ("t4_N", "4-torus of 24 N^4 simplices (t4_8: 98,304, t4_14: 921,984)"),
    ("grid4_N", "4-dimensional cube of 24 N^4 simplices (grid4_8: 98,304, grid4_14: 921,984)"),
    ("lm_NxM", "random 2-complex: all edges on N vertices, M triangles (lm_200x10000)"),
    ("sum_N", "sum complex modulo N with the sums 0, 1, 3: large torsion (sum_50)"),
    (
        "soupN",
        "icosphere of level N, each triangle with vertices of its own, 60 * 4^N points (soup7: 983,040)",
    ),
    (
        "cubes_sep_K",
        "K by K by K cubes of six separate squares (cubes_sep_50: 750,000 squares, 3,000,000 points)",
    ),
    ("cuboid_edges_K", "edges of the K by K by K cuboid grid (cuboid_edges_100: 3,060,300)"),
    ("cuboid_faces_K", "squares of the K by K by K cuboid grid (cuboid_faces_100: 3,030,000)"),
    ("seg_N", "N random segments in the plane with about 8 crossings each (seg_100000)"),
    ("long_N", "N random segments of length 0.4 from points of the unit square (long_800)"),
    ("short_N", "N random segments of length 0.1 from points of the unit square (short_10000)"),
    ("coast_N", "two closed curves of N vertices that cross a few dozen times (coast_1000000)"),
    ("star_N", "two polygons of N vertices with random radii, turned by half a step (star_10000)"),
    ("squares_N", "a grid of N/4 squares and the same turned by half a radian (squares_100000)"),
    ("random_N", "two polygons of N vertices with random radii and angles (random_100000)"),
    (
        "flower_N",
        "two polygons of N vertices with radii 0.8 and 1.2 in turns, the knots of flowers (flower_2000)",
    ),
    ("gear_N", "two polygons of N vertices with radii 0.9 and 1 in turns (gear_100000)"),
    ("circle_N", "two regular polygons of N vertices that cross twice (circle_1000000)"),
    ("grid_N", "a grid of N/4 squares and the same moved along, with overlapping edges (grid_1000000)"),
    ("nested_N", "N squares one around the other, their directions in turns (nested_32000)"),
    ("boxrow_N", "N cubes in a row that do not touch, 12 N triangles (boxrow_100000)"),
    ("boxblock_N", "N cubes in a block that do not touch (boxblock_100000)"),
    ("dolls_N", "N cubes around each other (dolls_4000)"),
    ("turned_N", "N boxes around the middle, turned about two axes (turned_100)"),
    ("rooms_N", "N rooms of a building in rows shifted like bricks, turned by 30 degrees (rooms_1000)"),
    ("simp_N", "N random simplices of dimension 0 to 5 on N/10 vertices"),
    ("torus_NxP", "the 3-torus of N N N voxels in P blocks, of which only the name is stored (torus_256x64)"),
    ("gyroid_N", "N N N voxels of one side of the gyroid, one in sixteen turned over (gyroid_128)"),
    ("box_N", "N N N voxels, all set (box_128)"),
];

/// Writes the input of this name to a file.
///
/// # Errors
/// As [`generate`], and if the file cannot be written.
pub(crate) fn write(name: &str, path: &Path) -> Result<(), Error> {
    volumes::write(name, path).unwrap_or_else(|| generate(name)?.write(path))
}

/// The input of this name.
///
/// # Errors
/// If the name is of no family, or the size is out of the family's range.
pub(crate) fn generate(name: &str) -> Result<Mesh, Error> {
    let unknown = || {
        Error::invalid(format!("{name:?} names no input"))
            .with_cure("see `coface-bench list` for the families; a size follows the name, as in ico6")
    };
    let number = |text: &str, least: usize, most: usize| -> Result<usize, Error> {
        let value: usize = text.parse().map_err(|_| unknown())?;
        if !(least..=most).contains(&value) {
            return Err(Error::invalid(format!("the size in {name:?} must be from {least} to {most}")));
        }
        Ok(value)
    };
    if let Some(level) = name.strip_prefix("ico") {
        return Ok(sphere::icosphere(number(level, 0, 10)?));
    }
    if let Some(level) = name.strip_prefix("spheres") {
        return Ok(sphere::overlapping_icospheres(number(level, 0, 9)?));
    }
    if let Some(level) = name.strip_prefix("soup") {
        return Ok(soups::exploded_icosphere(number(level, 0, 9)?));
    }
    if let Some(side) = name.strip_prefix("cubes_sep_") {
        return Ok(soups::separate_cubes(number(side, 1, 200)?));
    }
    for (family, dimension) in [("cuboid_edges_", 1), ("cuboid_faces_", 2)] {
        if let Some(side) = name.strip_prefix(family) {
            return cubes::cuboid_cells(number(side, 1, 300)?, dimension);
        }
    }
    if let Some((genus, side)) = name.strip_prefix("plate").and_then(|rest| rest.split_once('_')) {
        let genus = number(genus, 1, 10_000)?;
        return Ok(plate::plate_of_genus(genus, number(side, 4 * genus.isqrt() + 8, 4000)?));
    }
    match name.split_once('_').ok_or_else(unknown)? {
        ("genus10", side) => Ok(plate::plate_of_genus_10(number(side, 32, 4000)?)),
        ("st", size) => {
            let (across, along) = size.split_once('x').ok_or_else(unknown)?;
            let across = number(across, 1, 500)?;
            Ok(cubes::kuhn_cubes([across, across, number(along, 3, 100_000)?], [false, false, true]))
        }
        ("t3", side) => Ok(cubes::kuhn_cubes([number(side, 3, 400)?; 3], [true; 3])),
        ("grid3", side) => Ok(cubes::kuhn_cubes([number(side, 1, 400)?; 3], [false; 3])),
        ("t4", side) => Ok(cubes::kuhn_grid(4, number(side, 3, 40)?, true)),
        ("grid4", side) => Ok(cubes::kuhn_grid(4, number(side, 1, 40)?, false)),
        ("lm", size) => {
            let (vertices, triangles) = size.split_once('x').ok_or_else(unknown)?;
            let vertices = number(vertices, 3, 5000)?;
            let all = vertices * (vertices - 1) * (vertices - 2) / 6;
            // Beyond half of all triangles, drawing until enough differ takes long.
            let triangles = number(triangles, 0, (all / 2).max(1))?;
            Ok(random_simplices::random_2_complex(vertices, triangles))
        }
        ("sum", modulus) => Mesh::of_complex(&sum_complex(number(modulus, 4, 200)? as u32, &[0, 1, 3])?),
        ("seg", count) => Ok(drawings::random_segments(number(count, 1, 10_000_000)?, None)),
        ("long", count) => Ok(drawings::random_segments(number(count, 1, 100_000)?, Some(0.4))),
        ("short", count) => Ok(drawings::random_segments(number(count, 1, 1_000_000)?, Some(0.1))),
        ("coast", count) => Ok(drawings::coastlines(number(count, 3, 10_000_000)?)),
        ("star", count) => Ok(drawings::stars(number(count, 3, 10_000_000)?)),
        ("squares", count) => Ok(drawings::squares(number(count, 4, 10_000_000)?)),
        ("random", count) => Ok(drawings::random_stars(number(count, 3, 10_000_000)?)),
        ("gear", count) => Ok(drawings::gears(2 * (number(count, 4, 10_000_000)? / 2))),
        ("flower", count) => Ok(drawings::flowers(2 * (number(count, 6, 10_000_000)? / 2))),
        ("circle", count) => Ok(drawings::circles(number(count, 3, 10_000_000)?)),
        ("grid", count) => Ok(drawings::grids(number(count, 4, 10_000_000)?)),
        ("nested", count) => Ok(drawings::nested_squares(number(count, 1, 1_000_000)?)),
        ("boxrow", count) => Ok(boxes::row(number(count, 1, 1_000_000)?)),
        ("boxblock", count) => Ok(boxes::block(number(count, 1, 1_000_000)?)),
        ("dolls", count) => Ok(boxes::dolls(number(count, 1, 1_000_000)?)),
        ("turned", count) => Ok(boxes::turned(number(count, 1, 1_000_000)?)),
        ("rooms", count) => Ok(boxes::rooms(number(count, 1, 1_000_000)?)),
        ("simp", count) => Ok(random_simplices::random_simplices(number(count, 100, 100_000_000)?)),
        _ => Err(unknown()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    /// The numbers of faces of all dimensions, by listing them.
    fn f_vector(mesh: &Mesh) -> Vec<usize> {
        let mut faces: Vec<BTreeSet<Vec<u32>>> = vec![BTreeSet::new(); 6];
        for simplex in mesh.lists.iter() {
            for subset in 1u32..1 << simplex.len() {
                let mut face: Vec<u32> =
                    (0..simplex.len()).filter(|i| subset >> i & 1 == 1).map(|i| simplex[i]).collect();
                face.sort_unstable();
                faces[face.len() - 1].insert(face);
            }
        }
        while faces.last().is_some_and(BTreeSet::is_empty) {
            faces.pop();
        }
        faces.iter().map(BTreeSet::len).collect()
    }

    fn counts(name: &str) -> Vec<usize> {
        f_vector(&generate(name).unwrap())
    }

    #[test]
    fn small_members_of_each_family_have_the_counts_of_their_spaces() {
        assert_eq!(counts("ico0"), [12, 30, 20]);
        assert_eq!(counts("ico2"), [162, 480, 320]);
        assert_eq!(counts("spheres1"), [84, 240, 160]);
        assert_eq!(counts("t3_3"), [27, 189, 324, 162]);
        assert_eq!(counts("grid3_1"), [8, 19, 18, 6]);
        assert_eq!(counts("grid3_2"), [27, 98, 120, 48]);
        assert_eq!(counts("t4_3"), [81, 81 * 15, 81 * 50, 81 * 60, 81 * 24]);
        assert_eq!(counts("grid4_1"), [16, 65, 110, 84, 24]);
        assert_eq!(counts("sum_11"), [11, 55, 45]);
        assert_eq!(counts("soup1"), [240, 240, 80]);
        let edges = generate("cuboid_edges_2").unwrap();
        assert_eq!((edges.vertex_count, edges.lists.len()), (27, 54));
        assert_eq!(generate("cuboid_faces_2").unwrap().lists.len(), 36);
        let cubes = generate("cubes_sep_2").unwrap();
        assert_eq!((cubes.vertex_count, cubes.coordinates.len(), cubes.lists.len()), (192, 576, 48));
    }

    #[test]
    fn the_plate_is_a_closed_surface_of_genus_10_coherently_oriented() {
        let mesh = generate("genus10_64").unwrap();
        let f = f_vector(&mesh);
        assert_eq!(f[0] as i64 - f[1] as i64 + f[2] as i64, 2 - 2 * 10);
        let mut halfedges: Vec<(u32, u32)> =
            mesh.lists.iter().flat_map(|t| [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])]).collect();
        halfedges.sort_unstable();
        assert!(halfedges.is_sorted_by(|a, b| a < b), "each edge is run once in each direction");
        assert!(halfedges.iter().all(|&(a, b)| halfedges.binary_search(&(b, a)).is_ok()));
    }

    #[test]
    fn plates_have_as_many_holes_as_they_say() {
        for genus in [1, 2, 5, 9, 10] {
            let f = counts(&format!("plate{genus}_30"));
            assert_eq!(f[0] as i64 - f[1] as i64 + f[2] as i64, 2 - 2 * genus);
        }
    }

    #[test]
    fn a_solid_torus_has_euler_characteristic_0() {
        assert_eq!(counts("st_2x5").iter().zip([1, -1, 1, -1]).map(|(&n, s)| n as i64 * s).sum::<i64>(), 0);
    }

    #[test]
    fn random_simplices_repeat_no_vertex_and_do_not_change() {
        let mesh = generate("simp_1000").unwrap();
        assert_eq!(mesh.lists.len(), 1000);
        for simplex in mesh.lists.iter() {
            assert!((1..=6).contains(&simplex.len()) && simplex.iter().all(|&v| v < 100));
            assert_eq!(simplex.iter().collect::<BTreeSet<_>>().len(), simplex.len());
        }
        assert_eq!(mesh, generate("simp_1000").unwrap());
    }

    #[test]
    fn random_2_complexes_have_all_edges_and_do_not_change() {
        assert_eq!(counts("lm_12x70"), [12, 66, 70]);
        assert_eq!(counts("lm_9x0"), [9, 36]);
        assert_eq!(generate("lm_30x200").unwrap(), generate("lm_30x200").unwrap());
    }

    #[test]
    fn names_that_are_none_are_refused() {
        for name in [
            "", "ico", "ico-1", "plate4_9", "ico99", "t3_2", "st_4", "cube_7", "genus10_", "lm_5", "lm_5x9",
            "t4_2", "sum_3",
        ] {
            assert!(generate(name).is_err(), "{name}");
        }
    }
}
