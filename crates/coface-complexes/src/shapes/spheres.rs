//! Spheres, cut in three ways.

use super::lattice::{Lattice, check_count, check_length, check_size, upward};
use super::surfaces::{centered, is_before_center, refuse_cuboids};
use super::{CellKind, PlacedCells, turn_cell};
use coface_algebra::Error;
use coface_algebra::RaggedArray;
use coface_geometry::{Angle, Positions};

/// How a sphere is cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SphereGrid {
    /// An icosahedron with its edges cut into equal parts, lifted to the sphere: $10 n^2 + 2$ vertices, triangles only.
    Icosahedron {
        /// The number of parts of an edge, 1 or more.
        subdivisions: u32,
    },
    /// Circles of latitude and longitude; triangles only, because there are three corners at the poles.
    Latitude {
        /// The number of meridians, 3 or more.
        meridians: u32,
        /// The number of bands between the poles, 2 or more.
        bands: u32,
    },
    /// A cube with faces of n by n squares, lifted to the sphere: $6 n^2 + 2$ vertices.
    Cube {
        /// The number of squares along an edge, 1 or more.
        subdivisions: u32,
    },
}

/// The sphere of this radius about the origin; the normal looks outward. All vertices lie on the sphere.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless the radius is positive and there are enough subdivisions, and for quadrangles
/// where only triangles are possible; [`coface_algebra::ErrorKind::TooLarge`] beyond $2^{31}$ points.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// use coface_complexes::shapes::{SphereGrid, sphere};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ball = sphere(1.0, SphereGrid::Icosahedron { subdivisions: 1 }, CellKind::Simplex)?;
/// assert_eq!(ball.chain_complex()?.f_vector(), [12, 30, 20]);
/// let globe = sphere(1.0, SphereGrid::Latitude { meridians: 4, bands: 2 }, CellKind::Simplex)?;
/// assert_eq!(globe.chain_complex()?.f_vector(), [6, 12, 8]);
/// let cube = sphere(1.0, SphereGrid::Cube { subdivisions: 1 }, CellKind::Cuboid)?;
/// assert_eq!(cube.chain_complex()?.f_vector(), [8, 12, 6]);
/// # Ok(()) }
/// ```
pub fn sphere(radius: f64, grid: SphereGrid, kind: CellKind) -> Result<PlacedCells, Error> {
    check_length("radius", radius)?;
    match grid {
        SphereGrid::Icosahedron { subdivisions } => {
            refuse_cuboids(kind, "an icosahedron", "take triangles, or the grid of a cube")?;
            check_count("subdivisions", subdivisions, 1)?;
            icosahedral_sphere(radius, subdivisions)
        }
        SphereGrid::Latitude { meridians, bands } => {
            refuse_cuboids(kind, "a sphere with poles", "take triangles, or the grid of a cube")?;
            check_count("meridians", meridians, 3)?;
            check_count("bands", bands, 2)?;
            latitude_sphere(radius, meridians, bands)
        }
        SphereGrid::Cube { subdivisions } => {
            check_count("subdivisions", subdivisions, 1)?;
            cubical_sphere(radius, subdivisions, kind)
        }
    }
}

fn latitude_sphere(radius: f64, meridians: u32, bands: u32) -> Result<PlacedCells, Error> {
    let glue = |place: &mut [u32]| {
        place[0] = if place[1] == 0 || place[1] == bands { 0 } else { place[0] % meridians };
    };
    let place = |place: &[u32], out: &mut Vec<f64>| {
        let (c, s) = Angle::turns(place[0].into(), meridians).cosine_and_sine();
        let up = Angle::turns(2 * i64::from(place[1]) - i64::from(bands), bands.saturating_mul(4));
        let (flat, high) = up.cosine_and_sine();
        out.extend([radius * (flat * c), radius * (flat * s), radius * high]);
    };
    Lattice { shape: &[meridians, bands], space: 3, glue: &glue, is_downward: &upward, place: &place }
        .cells(CellKind::Simplex)
}

/// A point on the sphere of this radius, on the ray through a point that is not the origin.
pub(super) fn on_sphere(radius: f64, point: [f64; 3]) -> [f64; 3] {
    let length = point.iter().map(|x| x * x).sum::<f64>().sqrt();
    point.map(|x| radius * (x / length))
}

/// The surface of a cube of n³ cells, its points pushed out along rays; numbered in their lexicographic order.
fn cubical_sphere(radius: f64, n: u32, kind: CellKind) -> Result<PlacedCells, Error> {
    check_size(&[6, n, n], kind)?;
    let side = u64::from(n) + 1;
    let code = |place: [u32; 3]| place.iter().fold(0u64, |sum, &i| sum * side + u64::from(i));
    let mut codes = Vec::new();
    for i in 0..=n {
        for j in 0..=n {
            let step = if i % n == 0 || j % n == 0 { 1 } else { n };
            codes.extend((0..=n).step_by(step as usize).map(|k| code([i, j, k])));
        }
    }
    let mut coordinates = Vec::with_capacity(3 * codes.len());
    for &code in &codes {
        let digit = |power: u64| centered((code / power % side) as u32, n);
        coordinates.extend(on_sphere(radius, [digit(side * side), digit(side), digit(1)]));
    }
    let number = |place: [u32; 3]| codes.binary_search(&code(place)).expect("a point of the surface") as u32;
    let mut items = Vec::new();
    for axis in 0..3 {
        // The other two in the cyclic order: seen from the upper side they run counterclockwise.
        let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
        for level in [0, n] {
            for i in 0..n {
                for j in 0..n {
                    let corner = |di: u32, dj: u32| {
                        let mut place = [level; 3];
                        (place[first], place[second]) = (i + di, j + dj);
                        number(place)
                    };
                    let [a, b, c, d] = [corner(0, 0), corner(0, 1), corner(1, 0), corner(1, 1)];
                    let start = items.len();
                    match kind {
                        CellKind::Cuboid => items.extend([a, b, c, d]),
                        // The diagonal that points away from the middle of the face.
                        CellKind::Simplex if is_before_center(i, n) == is_before_center(j, n) => {
                            items.extend([a, c, d, a, d, b]);
                        }
                        CellKind::Simplex => items.extend([a, c, b, c, d, b]),
                    }
                    if level == 0 {
                        let width = if kind == CellKind::Cuboid { 4 } else { 3 };
                        items[start..].chunks_mut(width).for_each(|cell| turn_cell(kind, cell));
                    }
                }
            }
        }
    }
    let width = if kind == CellKind::Cuboid { 4 } else { 3 };
    let cells = RaggedArray::uniform(width, items)?;
    Ok(PlacedCells::from_trusted(Positions::from_flat(3, coordinates)?, kind, 2, cells))
}

/// The corners of an icosahedron: (0, ±1, ±φ) and its cyclic shifts.
fn icosahedron() -> ([[f64; 3]; 12], Vec<[usize; 3]>) {
    let golden = f64::midpoint(1.0, 5f64.sqrt());
    let mut corners = [[0.0; 3]; 12];
    for (i, corner) in corners.iter_mut().enumerate() {
        let sign = |bit: usize| if i >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let shift = i / 4;
        corner[(shift + 1) % 3] = sign(0);
        corner[(shift + 2) % 3] = sign(1) * golden;
    }
    let minus = |a: usize, b: usize| [0, 1, 2].map(|k| corners[a][k] - corners[b][k]);
    // Edges have length 2, all other distances are over 3.
    let is_edge = |a: usize, b: usize| minus(a, b).iter().map(|x| x * x).sum::<f64>() < 5.0;
    let mut faces = Vec::new();
    for (a, w) in corners.iter().enumerate() {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if is_edge(a, b) && is_edge(b, c) && is_edge(a, c) {
                    let (u, v) = (minus(b, a), minus(c, a));
                    let outward = (u[1] * v[2] - u[2] * v[1]) * w[0]
                        + (u[2] * v[0] - u[0] * v[2]) * w[1]
                        + (u[0] * v[1] - u[1] * v[0]) * w[2];
                    faces.push(if outward > 0.0 { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    (corners, faces)
}

fn icosahedral_sphere(radius: f64, n: u32) -> Result<PlacedCells, Error> {
    check_size(&[20, n, n], CellKind::Simplex)?;
    let (corners, faces) = icosahedron();
    let mut edges: Vec<[usize; 2]> =
        faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).filter(|[a, b]| a < b).collect();
    edges.sort_unstable();
    // Vertices: the corners, then the inner points of edges from the lesser end, then those of faces.
    let mut coordinates: Vec<f64> = corners.iter().flat_map(|&corner| on_sphere(radius, corner)).collect();
    let mix = |weights: &[(usize, u32)]| {
        let sum =
            |k: usize| weights.iter().map(|&(corner, weight)| f64::from(weight) * corners[corner][k]).sum();
        on_sphere(radius, [0, 1, 2].map(sum))
    };
    for &[a, b] in &edges {
        coordinates.extend((1..n).flat_map(|i| mix(&[(a, n - i), (b, i)])));
    }
    for &[a, b, c] in &faces {
        for i in 1..n {
            coordinates.extend((1..n - i).flat_map(|j| mix(&[(a, n - i - j), (b, i), (c, j)])));
        }
    }
    let inner = u64::from(n - 1);
    let face_start = 12 + edges.len() as u64 * inner;
    let face_size = inner * inner.saturating_sub(1) / 2;
    let on_edge = |from: usize, to: usize, i: u32| -> u32 {
        let ([a, b], i) = if from < to { ([from, to], i) } else { ([to, from], n - i) };
        let edge = edges.binary_search(&[a, b]).expect("an edge of the icosahedron") as u64;
        (12 + edge * inner + u64::from(i) - 1) as u32
    };
    let mut items = Vec::new();
    for (face, &[a, b, c]) in faces.iter().enumerate() {
        // The point i steps towards b and j steps towards c.
        let vertex = |i: u32, j: u32| -> u32 {
            match (i, j) {
                (0, 0) => a as u32,
                (i, 0) if i == n => b as u32,
                (0, j) if j == n => c as u32,
                (i, 0) => on_edge(a, b, i),
                (0, j) => on_edge(a, c, j),
                (i, j) if i + j == n => on_edge(b, c, j),
                (i, j) => {
                    // Rows 1, 2, ... have n - 2, n - 3, ... inner points.
                    let row = u64::from(i - 1);
                    let before = row * inner.saturating_sub(1) - row * row.saturating_sub(1) / 2;
                    (face_start + face as u64 * face_size + before + u64::from(j) - 1) as u32
                }
            }
        };
        for i in 0..n {
            for j in 0..n - i {
                items.extend([vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)]);
                if i + j + 1 < n {
                    items.extend([vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)]);
                }
            }
        }
    }
    let positions = Positions::from_flat(3, coordinates)?;
    Ok(PlacedCells::from_trusted(positions, CellKind::Simplex, 2, RaggedArray::uniform(3, items)?))
}
