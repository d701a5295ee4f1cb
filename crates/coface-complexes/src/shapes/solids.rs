//! Solids: boxes, balls, rods, tubes, shells and plates with holes.

use super::lattice::{Lattice, apart, check_count, check_length, check_less, check_size, upward};
use super::layers::layered;
use super::spheres::{SphereGrid, on_sphere, sphere};
use super::surfaces::{centered, disk_point, is_before_center};
use super::{CellKind, PlacedCells};
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_geometry::{Angle, Positions};

/// The simplex of this dimension: the origin and the unit vectors. A point lies on a line.
///
/// # Errors
/// [`coface_algebra::ErrorKind::TooLarge`] above dimension 20.
///
/// # Examples
/// ```
/// let tetrahedron = coface_complexes::shapes::simplex(3)?;
/// assert_eq!(tetrahedron.chain_complex()?.f_vector(), [4, 6, 4, 1]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn simplex(dimension: u32) -> Result<PlacedCells, Error> {
    if dimension > 20 {
        return Err(Error::new(ErrorKind::TooLarge, format!("a simplex of dimension {dimension}"))
            .with_cure("give a dimension of 20 or less"));
    }
    let space = dimension.max(1) as usize;
    let coordinate = |vertex: u32| (0..space).map(move |axis| f64::from(u8::from(axis as u32 + 1 == vertex)));
    let coordinates = (0..=dimension).flat_map(coordinate).collect();
    let cell: Vec<u32> = (0..=dimension).collect();
    let positions = Positions::from_flat(space, coordinates)?;
    PlacedCells::new(positions, CellKind::Simplex, dimension as usize, RaggedArray::from_lists([cell]))
}

/// The box from the origin to these sizes, of any dimension from 1 on, cut into `grid[a]` parts along axis a.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless there are as many numbers of parts as sizes, all positive;
/// [`coface_algebra::ErrorKind::TooLarge`] from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// let brick = coface_complexes::shapes::cuboid(&[3.0, 2.0, 1.0], &[3, 2, 1], CellKind::Cuboid)?;
/// assert_eq!(brick.chain_complex()?.f_vector(), [24, 46, 29, 6]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn cuboid(sizes: &[f64], grid: &[u32], kind: CellKind) -> Result<PlacedCells, Error> {
    if sizes.len() != grid.len() || sizes.is_empty() {
        return Err(Error::invalid(format!(
            "{} sizes and {} numbers of parts are no box",
            sizes.len(),
            grid.len()
        ))
        .with_cure("give one of each for each axis"));
    }
    sizes.iter().try_for_each(|&size| check_length("size", size))?;
    grid.iter().try_for_each(|&parts| check_count("parts", parts, 1))?;
    let place = |place: &[u32], out: &mut Vec<f64>| {
        out.extend((0..place.len()).map(|a| sizes[a] * (f64::from(place[a]) / f64::from(grid[a]))));
    };
    Lattice { shape: grid, space: grid.len(), glue: &apart, is_downward: &upward, place: &place }.cells(kind)
}

/// The ball of this radius about the origin: a cube of n by n by n cells whose cubes around the center become spheres, along rays.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless the radius is positive and there is a subdivision;
/// [`coface_algebra::ErrorKind::TooLarge`] from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// let ball = coface_complexes::shapes::ball(1.0, 2, CellKind::Simplex)?;
/// assert_eq!((ball.vertex_count(), ball.cell_count()), (27, 48));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn ball(radius: f64, subdivisions: u32, kind: CellKind) -> Result<PlacedCells, Error> {
    let n = subdivisions;
    check_length("radius", radius)?;
    check_count("subdivisions", n, 1)?;
    let place = |place: &[u32], out: &mut Vec<f64>| {
        let point = [0, 1, 2].map(|axis: usize| centered(place[axis], n));
        let size = point.iter().fold(0.0f64, |size, x| size.max(x.abs()));
        out.extend(if size == 0.0 { [0.0; 3] } else { on_sphere(radius * size, point) });
    };
    let inward = |_, i| is_before_center(i, n);
    Lattice { shape: &[n; 3], space: 3, glue: &apart, is_downward: &inward, place: &place }.cells(kind)
}

/// The solid cylinder of this radius about the third axis, from 0 to this height: a disk of n by n squares in layers, `grid` = [n,
/// layers].
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless the lengths are positive and there are subdivisions;
/// [`coface_algebra::ErrorKind::TooLarge`] from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// let rod = coface_complexes::shapes::rod(1.0, 5.0, [2, 5], CellKind::Cuboid)?;
/// assert_eq!((rod.vertex_count(), rod.cell_count()), (54, 20));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn rod(radius: f64, height: f64, grid: [u32; 2], kind: CellKind) -> Result<PlacedCells, Error> {
    let [n, layers] = grid;
    check_length("radius", radius)?;
    check_length("height", height)?;
    check_count("subdivisions", n, 1)?;
    check_count("layers", layers, 1)?;
    let place = |place: &[u32], out: &mut Vec<f64>| {
        let (x, y) = disk_point(centered(place[0], n), centered(place[1], n));
        out.extend([radius * x, radius * y, height * (f64::from(place[2]) / f64::from(layers))]);
    };
    let inward = |axis, i| axis < 2 && is_before_center(i, n);
    Lattice { shape: &[n, n, layers], space: 3, glue: &apart, is_downward: &inward, place: &place }
        .cells(kind)
}

/// The solid that a torus encloses: a disk of n by n squares led around the third axis, `grid` = [n, sectors].
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless $0 < r < R$ and there are a subdivision and 3 sectors or more;
/// [`coface_algebra::ErrorKind::TooLarge`] from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// let dough = coface_complexes::shapes::solid_torus(3.0, 1.0, [2, 12], CellKind::Cuboid)?;
/// assert_eq!((dough.vertex_count(), dough.cell_count()), (108, 48));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn solid_torus(
    major_radius: f64,
    minor_radius: f64,
    grid: [u32; 2],
    kind: CellKind,
) -> Result<PlacedCells, Error> {
    check_length("minor radius", minor_radius)?;
    check_less("minor radius", minor_radius, "major radius", major_radius)?;
    let [n, sectors] = grid;
    check_count("subdivisions", n, 1)?;
    check_count("sectors", sectors, 3)?;
    let glue = |place: &mut [u32]| place[1] %= sectors;
    // Outward, around and up are a right-handed frame in this order.
    let place = |place: &[u32], out: &mut Vec<f64>| {
        let (x, z) = disk_point(centered(place[0], n), centered(place[2], n));
        let (c, s) = Angle::turns(place[1].into(), sectors).cosine_and_sine();
        let r = major_radius + minor_radius * x;
        out.extend([r * c, r * s, minor_radius * z]);
    };
    let inward = |axis, i| axis != 1 && is_before_center(i, n);
    Lattice { shape: &[n, sectors, n], space: 3, glue: &glue, is_downward: &inward, place: &place }
        .cells(kind)
}

/// The solid between two cylinders about the third axis, from 0 to this height, `grid` = [shells, sectors, layers].
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless the inner radius is positive and less than the outer one, the height positive,
/// and there are a shell, 3 sectors and a layer; [`coface_algebra::ErrorKind::TooLarge`] from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// let pipe = coface_complexes::shapes::hollow_cylinder([1.0, 2.0], 3.0, [1, 8, 2], CellKind::Cuboid)?;
/// assert_eq!((pipe.vertex_count(), pipe.cell_count()), (48, 16));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn hollow_cylinder(
    [inner_radius, outer_radius]: [f64; 2],
    height: f64,
    grid: [u32; 3],
    kind: CellKind,
) -> Result<PlacedCells, Error> {
    check_length("inner radius", inner_radius)?;
    check_less("inner radius", inner_radius, "outer radius", outer_radius)?;
    check_length("height", height)?;
    let [shells, sectors, layers] = grid;
    check_count("shells", shells, 1)?;
    check_count("sectors", sectors, 3)?;
    check_count("layers", layers, 1)?;
    let glue = |place: &mut [u32]| place[1] %= sectors;
    let place = |place: &[u32], out: &mut Vec<f64>| {
        let r = inner_radius + (outer_radius - inner_radius) * (f64::from(place[0]) / f64::from(shells));
        let (c, s) = Angle::turns(place[1].into(), sectors).cosine_and_sine();
        out.extend([r * c, r * s, height * (f64::from(place[2]) / f64::from(layers))]);
    };
    Lattice { shape: &grid, space: 3, glue: &glue, is_downward: &upward, place: &place }.cells(kind)
}

/// The solid between two spheres about the origin, in so many shells.
///
/// # Errors
/// Those of [`sphere`]; [`coface_algebra::ErrorKind::InvalidInput`] unless the inner radius is positive and less than the outer
/// one and there is a shell.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// use coface_complexes::shapes::{SphereGrid, hollow_ball};
/// let shell = hollow_ball([1.0, 2.0], SphereGrid::Cube { subdivisions: 1 }, 1, CellKind::Cuboid)?;
/// assert_eq!(shell.chain_complex()?.f_vector(), [16, 32, 24, 6]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn hollow_ball(
    [inner_radius, outer_radius]: [f64; 2],
    grid: SphereGrid,
    shells: u32,
    kind: CellKind,
) -> Result<PlacedCells, Error> {
    check_length("inner radius", inner_radius)?;
    check_less("inner radius", inner_radius, "outer radius", outer_radius)?;
    check_count("shells", shells, 1)?;
    let unit = sphere(1.0, grid, kind)?;
    layered(&unit, shells, 3, &|point, layer, out| {
        let r = inner_radius + (outer_radius - inner_radius) * (f64::from(layer) / f64::from(shells));
        out.extend(point.iter().map(|x| r * x));
    })
}

/// A plate with so many square holes in a row, of unit cubes each cut into n by n by n cells: from the origin to 2 g + 1, 3 and 1, with
/// the cubes at (1, 1), (3, 1), ... left out. A handlebody of genus g; its boundary is the closed surface of genus g.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] without subdivisions; [`coface_algebra::ErrorKind::TooLarge`] from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// let plate = coface_complexes::shapes::plate_with_holes(2, 1, CellKind::Cuboid)?;
/// assert_eq!(plate.cell_count(), 13);
/// assert_eq!(plate.boundary()?.chain_complex()?.euler_characteristic(), -2);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn plate_with_holes(holes: u32, subdivisions: u32, kind: CellKind) -> Result<PlacedCells, Error> {
    let n = subdivisions;
    check_count("subdivisions", n, 1)?;
    let grid =
        [u64::from(holes) * 2 + 1, 3, 1].map(|cubes| u32::try_from(cubes * u64::from(n)).unwrap_or(u32::MAX));
    check_size(&grid, kind)?;
    let place = |place: &[u32], out: &mut Vec<f64>| {
        out.extend(place.iter().map(|&i| f64::from(i) / f64::from(n)));
    };
    let plate =
        Lattice { shape: &grid, space: 3, glue: &apart, is_downward: &upward, place: &place }.cells(kind)?;
    // A cell lies in the cube that the mean of its vertices lies in.
    let is_kept = |cell: &[u32]| {
        let mean = |axis: usize| -> f64 {
            let sum: f64 = cell.iter().map(|&v| plate.positions().point(VertexId::from_u32(v))[axis]).sum();
            sum / cell.len() as f64
        };
        mean(0).floor() % 2.0 == 0.0 || mean(1).floor() != 1.0
    };
    let kept = RaggedArray::from_lists(plate.cells().iter().filter(|cell| is_kept(cell)));
    Ok(PlacedCells::from_trusted(plate.positions().clone(), kind, 3, kept).compacted())
}
