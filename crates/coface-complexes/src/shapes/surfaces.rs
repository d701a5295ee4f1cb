//! Surfaces that are images of rectangles: disks, rings, tubes, tori, bands and bottles.

use super::curves::{check_winding, turned_steps};
use super::lattice::{Lattice, apart, check_count, check_length, check_less, upward};
use super::{CellKind, PlacedCells};
use coface_algebra::{Error, ErrorKind};
use coface_geometry::Angle;

/// How a disk is cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DiskGrid {
    /// Rings of sectors around the center; triangles only, because sectors at the center have three corners.
    Polar {
        /// The number of rings, 1 or more.
        rings: u32,
        /// The number of sectors, 3 or more.
        sectors: u32,
    },
    /// The image of a square grid whose squares around the center become circles.
    Square {
        /// The number of squares along a side, 1 or more.
        subdivisions: u32,
    },
}

/// Cells with a pole have three corners there.
pub(super) fn refuse_cuboids(kind: CellKind, what: &str, cure: &str) -> Result<(), Error> {
    if kind == CellKind::Simplex {
        return Ok(());
    }
    Err(Error::new(
        ErrorKind::InvalidInput,
        format!("{what} cannot be cut into quadrangles: those at the pole have three corners"),
    )
    .with_cure(cure))
}

/// The point of the disk of radius 1 that a point of the square from -1 to 1 goes to: squares around the center become circles,
/// along rays.
pub(super) fn disk_point(x: f64, y: f64) -> (f64, f64) {
    let factor = match x.hypot(y) {
        0.0 => 0.0,
        length => x.abs().max(y.abs()) / length,
    };
    (factor * x, factor * y)
}

/// The number from -1 to 1 at step i of n.
pub(super) fn centered(i: u32, n: u32) -> f64 {
    (2.0 * f64::from(i) - f64::from(n)) / f64::from(n)
}

/// Whether the simplices of a cell at step i of n walk down, so that they walk away from the center of an axis.
pub(super) fn is_before_center(i: u32, n: u32) -> bool {
    2 * u64::from(i) + 1 < u64::from(n)
}

fn turn(i: u32, n: u32) -> (f64, f64) {
    Angle::turns(i.into(), n).cosine_and_sine()
}

fn part(i: u32, n: u32) -> f64 {
    f64::from(i) / f64::from(n)
}

/// The disk of this radius about the origin of the plane.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] unless the radius is positive and there are enough subdivisions, and for quadrangles around a
/// pole; [`ErrorKind::TooLarge`] from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// use coface_complexes::shapes::{DiskGrid, disk};
/// let hexagon = disk(1.0, DiskGrid::Polar { rings: 1, sectors: 6 }, CellKind::Simplex)?;
/// assert_eq!((hexagon.vertex_count(), hexagon.cell_count()), (7, 6));
/// let quadrangles = disk(1.0, DiskGrid::Square { subdivisions: 2 }, CellKind::Cuboid)?;
/// assert_eq!((quadrangles.vertex_count(), quadrangles.cell_count()), (9, 4));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn disk(radius: f64, grid: DiskGrid, kind: CellKind) -> Result<PlacedCells, Error> {
    check_length("radius", radius)?;
    match grid {
        DiskGrid::Polar { rings, sectors } => {
            refuse_cuboids(kind, "a polar disk", "take triangles, or the grid of a square")?;
            check_count("rings", rings, 1)?;
            check_count("sectors", sectors, 3)?;
            let glue = |place: &mut [u32]| place[1] = if place[0] == 0 { 0 } else { place[1] % sectors };
            let place = |place: &[u32], out: &mut Vec<f64>| {
                let (c, s) = turn(place[1], sectors);
                let r = radius * part(place[0], rings);
                out.extend([r * c, r * s]);
            };
            Lattice { shape: &[rings, sectors], space: 2, glue: &glue, is_downward: &upward, place: &place }
                .cells(kind)
        }
        DiskGrid::Square { subdivisions: n } => {
            check_count("subdivisions", n, 1)?;
            let place = |place: &[u32], out: &mut Vec<f64>| {
                let (x, y) = disk_point(centered(place[0], n), centered(place[1], n));
                out.extend([radius * x, radius * y]);
            };
            let inward = |_, i| is_before_center(i, n);
            Lattice { shape: &[n, n], space: 2, glue: &apart, is_downward: &inward, place: &place }
                .cells(kind)
        }
    }
}

/// The ring of the plane between two circles about the origin, `grid` = [rings, sectors].
///
/// # Errors
/// [`ErrorKind::InvalidInput`] unless the inner radius is positive and less than the outer one, and there are a ring and 3
/// sectors; [`ErrorKind::TooLarge`] from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// let ring = coface_complexes::shapes::ring(1.0, 2.0, [1, 8], CellKind::Cuboid)?;
/// assert_eq!((ring.vertex_count(), ring.cell_count()), (16, 8));
/// assert_eq!(ring.boundary()?.cell_count(), 16);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn ring(
    inner_radius: f64,
    outer_radius: f64,
    grid: [u32; 2],
    kind: CellKind,
) -> Result<PlacedCells, Error> {
    check_length("inner radius", inner_radius)?;
    check_less("inner radius", inner_radius, "outer radius", outer_radius)?;
    let [rings, sectors] = grid;
    check_count("rings", rings, 1)?;
    check_count("sectors", sectors, 3)?;
    let glue = |place: &mut [u32]| place[1] %= sectors;
    let place = |place: &[u32], out: &mut Vec<f64>| {
        let (c, s) = turn(place[1], sectors);
        let r = inner_radius + (outer_radius - inner_radius) * part(place[0], rings);
        out.extend([r * c, r * s]);
    };
    Lattice { shape: &grid, space: 2, glue: &glue, is_downward: &upward, place: &place }.cells(kind)
}

/// The helicoid $(\rho \cos t, \rho \sin t, p\, t / 2 \pi)$ for $\rho$ between two radii and t through so many turns, `grid` = [steps outward,
/// steps along]. The inner radius may be 0: then its edge is the axis.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] unless the inner radius is not negative and less than the outer one, pitch and turns are
/// finite and not zero, and there are steps; [`ErrorKind::TooLarge`] from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// let ramp = coface_complexes::shapes::helicoid(0.0, 1.0, [2.0, 3.0], [1, 36], CellKind::Cuboid)?;
/// assert_eq!((ramp.vertex_count(), ramp.cell_count()), (74, 36));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn helicoid(
    inner_radius: f64,
    outer_radius: f64,
    [pitch, turns]: [f64; 2],
    grid: [u32; 2],
    kind: CellKind,
) -> Result<PlacedCells, Error> {
    if inner_radius != 0.0 {
        check_length("inner radius", inner_radius)?;
    }
    check_less("inner radius", inner_radius, "outer radius", outer_radius)?;
    check_winding(pitch, turns)?;
    if pitch == 0.0 {
        return Err(Error::invalid("the pitch is 0: the turns of the helicoid lie on each other")
            .with_cure("give a pitch that is not zero, or make a ring"));
    }
    check_count("steps outward", grid[0], 1)?;
    check_count("steps along", grid[1], 1)?;
    let steps = turned_steps(turns, grid[1])?;
    let place = |place: &[u32], out: &mut Vec<f64>| {
        let (c, s) = steps[place[1] as usize];
        let r = inner_radius + (outer_radius - inner_radius) * part(place[0], grid[0]);
        out.extend([r * c, r * s, pitch * (turns * part(place[1], grid[1]))]);
    };
    Lattice { shape: &grid, space: 3, glue: &apart, is_downward: &upward, place: &place }.cells(kind)
}

/// The side of the cylinder of this radius about the third axis, from 0 to this height, `grid` = [sectors, layers]; the normal looks
/// outward. The solid is [`super::rod`].
///
/// # Errors
/// [`ErrorKind::InvalidInput`] unless the lengths are positive and there are 3 sectors and a layer;
/// [`ErrorKind::TooLarge`] from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// let tube = coface_complexes::shapes::cylinder(1.0, 2.0, [6, 1], CellKind::Cuboid)?;
/// assert_eq!((tube.vertex_count(), tube.cell_count()), (12, 6));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn cylinder(radius: f64, height: f64, grid: [u32; 2], kind: CellKind) -> Result<PlacedCells, Error> {
    check_length("radius", radius)?;
    check_length("height", height)?;
    let [sectors, layers] = grid;
    check_count("sectors", sectors, 3)?;
    check_count("layers", layers, 1)?;
    let glue = |place: &mut [u32]| place[0] %= sectors;
    let place = |place: &[u32], out: &mut Vec<f64>| {
        let (c, s) = turn(place[0], sectors);
        out.extend([radius * c, radius * s, height * part(place[1], layers)]);
    };
    Lattice { shape: &grid, space: 3, glue: &glue, is_downward: &upward, place: &place }.cells(kind)
}

/// The side of the cone with this radius at height 0 and its apex on the third axis, `grid` = [sectors, layers], of triangles; the
/// normal looks outward.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] unless the lengths are positive and there are 3 sectors and a layer;
/// [`ErrorKind::TooLarge`] from $2^{31}$ points on.
///
/// # Examples
/// ```
/// let pyramid = coface_complexes::shapes::cone(1.0, 2.0, [4, 1])?;
/// assert_eq!((pyramid.vertex_count(), pyramid.cell_count()), (5, 4));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn cone(radius: f64, height: f64, grid: [u32; 2]) -> Result<PlacedCells, Error> {
    check_length("radius", radius)?;
    check_length("height", height)?;
    let [sectors, layers] = grid;
    check_count("sectors", sectors, 3)?;
    check_count("layers", layers, 1)?;
    let glue = |place: &mut [u32]| place[0] = if place[1] == layers { 0 } else { place[0] % sectors };
    let place = |place: &[u32], out: &mut Vec<f64>| {
        let (c, s) = turn(place[0], sectors);
        let r = radius * part(layers - place[1], layers);
        out.extend([r * c, r * s, height * part(place[1], layers)]);
    };
    Lattice { shape: &grid, space: 3, glue: &glue, is_downward: &upward, place: &place }
        .cells(CellKind::Simplex)
}

/// The torus $((R + r \cos v) \cos u, (R + r \cos v) \sin u, r \sin v)$, `grid` = [columns along u, rows along v]; the normal looks
/// outward.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] unless $0 < r < R$ and there are 3 columns and 3 rows or more; [`ErrorKind::TooLarge`]
/// from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// let torus = coface_complexes::shapes::torus(3.0, 1.0, [12, 6], CellKind::Simplex)?;
/// assert_eq!(torus.chain_complex()?.f_vector(), [72, 216, 144]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn torus(
    major_radius: f64,
    minor_radius: f64,
    grid: [u32; 2],
    kind: CellKind,
) -> Result<PlacedCells, Error> {
    check_length("minor radius", minor_radius)?;
    check_less("minor radius", minor_radius, "major radius", major_radius)?;
    let [columns, rows] = grid;
    check_count("columns", columns, 3)?;
    check_count("rows", rows, 3)?;
    let glue = |place: &mut [u32]| (place[0], place[1]) = (place[0] % columns, place[1] % rows);
    let place = |place: &[u32], out: &mut Vec<f64>| {
        out.extend(torus_point(major_radius, minor_radius, turn(place[0], columns), turn(place[1], rows)));
    };
    Lattice { shape: &grid, space: 3, glue: &glue, is_downward: &upward, place: &place }.cells(kind)
}

fn torus_point(major: f64, minor: f64, (cu, su): (f64, f64), (cv, sv): (f64, f64)) -> [f64; 3] {
    let r = major + minor * cv;
    [r * cu, r * su, minor * sv]
}

/// The outer half of a torus, where $\cos v \geq 0$, `grid` = [columns, rows]; the normal looks outward.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] unless $0 < r < R$ and there are 3 columns and a row or more; [`ErrorKind::TooLarge`]
/// from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// let crown = coface_complexes::shapes::crown(3.0, 1.0, [12, 6], CellKind::Cuboid)?;
/// assert_eq!((crown.vertex_count(), crown.cell_count()), (84, 72));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn crown(
    major_radius: f64,
    minor_radius: f64,
    grid: [u32; 2],
    kind: CellKind,
) -> Result<PlacedCells, Error> {
    check_length("minor radius", minor_radius)?;
    check_less("minor radius", minor_radius, "major radius", major_radius)?;
    let [columns, rows] = grid;
    check_count("columns", columns, 3)?;
    check_count("rows", rows, 1)?;
    let glue = |place: &mut [u32]| place[0] %= columns;
    let place = |place: &[u32], out: &mut Vec<f64>| {
        // From a quarter turn down to a quarter turn up, in steps of half a turn over the number of rows.
        let v =
            Angle::turns(2 * i64::from(place[1]) - i64::from(rows), rows.saturating_mul(4)).cosine_and_sine();
        out.extend(torus_point(major_radius, minor_radius, turn(place[0], columns), v));
    };
    Lattice { shape: &grid, space: 3, glue: &glue, is_downward: &upward, place: &place }.cells(kind)
}

/// The Moebius band $((R + s \cos \frac u 2) \cos u, (R + s \cos \frac u 2) \sin u, s \sin \frac u 2)$ for s from minus to plus half of the
/// width, `grid` = [columns, rows]: the last column is glued to the first upside down.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] unless half of the width is positive and less than the radius and there are 3 columns and a
/// row or more; [`ErrorKind::TooLarge`] from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// let band = coface_complexes::shapes::moebius(2.0, 1.0, [12, 2], CellKind::Cuboid)?;
/// assert_eq!(band.chain_complex()?.f_vector(), [36, 60, 24]);
/// assert_eq!(band.boundary()?.cell_count(), 24);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn moebius(radius: f64, width: f64, grid: [u32; 2], kind: CellKind) -> Result<PlacedCells, Error> {
    check_length("width", width)?;
    check_less("half width", width / 2.0, "radius", radius)?;
    let [columns, rows] = grid;
    check_count("columns", columns, 3)?;
    check_count("rows", rows, 1)?;
    let glue = |place: &mut [u32]| {
        if place[0] == columns {
            (place[0], place[1]) = (0, rows - place[1]);
        }
    };
    let place = |place: &[u32], out: &mut Vec<f64>| {
        let ((c, s), (half_c, half_s)) = (turn(place[0], columns), turn(place[0], columns.saturating_mul(2)));
        let across = width / 2.0 * centered(place[1], rows);
        let r = radius + across * half_c;
        out.extend([r * c, r * s, across * half_s]);
    };
    Lattice { shape: &grid, space: 3, glue: &glue, is_downward: &upward, place: &place }.cells(kind)
}

/// The Klein bottle as a figure eight that turns over once on its way around, immersed in space: it crosses itself along the circle
/// of the major radius. `grid` = [columns around, rows along the eight].
///
/// With $\rho = R + r (\cos \frac u 2 \sin v - \sin \frac u 2 \sin 2v)$ it is $(\rho \cos u, \rho \sin u, r (\sin \frac u 2 \sin v + \cos
/// \frac u 2 \sin 2v))$. With an even number of rows two different vertices of each column lie in one place, so a format that
/// tells vertices by their positions (STL) does not hold it.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] unless r is positive and less than half of R and there are 3 columns and 3 rows or more;
/// [`ErrorKind::TooLarge`] from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// let bottle = coface_complexes::shapes::klein_bottle(3.0, 1.0, [12, 9], CellKind::Cuboid)?;
/// assert_eq!(bottle.chain_complex()?.f_vector(), [108, 216, 108]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn klein_bottle(
    major_radius: f64,
    minor_radius: f64,
    grid: [u32; 2],
    kind: CellKind,
) -> Result<PlacedCells, Error> {
    check_length("minor radius", minor_radius)?;
    check_less("double minor radius", 2.0 * minor_radius, "major radius", major_radius)?;
    let place = |place: &[u32], out: &mut Vec<f64>| {
        let ((c, s), (half_c, half_s)) = (turn(place[0], grid[0]), turn(place[0], grid[0].saturating_mul(2)));
        let once = turn(place[1], grid[1]).1;
        let twice = Angle::turns(2 * i64::from(place[1]), grid[1]).cosine_and_sine().1;
        let r = major_radius + minor_radius * (half_c * once - half_s * twice);
        out.extend([r * c, r * s, minor_radius * (half_s * once + half_c * twice)]);
    };
    klein(grid, 3, &place, kind)
}

/// The Klein bottle embedded in the space of dimension 4: $((R + r \cos v) \cos u, (R + r \cos v) \sin u, r \sin v \cos \frac u 2, r \sin v
/// \sin \frac u 2)$, `grid` = [columns along u, rows along v].
///
/// # Errors
/// [`ErrorKind::InvalidInput`] unless $0 < r < R$ and there are 3 columns and 3 rows or more; [`ErrorKind::TooLarge`]
/// from $2^{31}$ points on.
///
/// # Examples
/// ```
/// use coface_complexes::shapes::CellKind;
/// let bottle = coface_complexes::shapes::klein_bottle_in_4d(3.0, 1.0, [12, 6], CellKind::Cuboid)?;
/// assert_eq!((bottle.positions().dimension(), bottle.vertex_count()), (4, 72));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn klein_bottle_in_4d(
    major_radius: f64,
    minor_radius: f64,
    grid: [u32; 2],
    kind: CellKind,
) -> Result<PlacedCells, Error> {
    check_length("minor radius", minor_radius)?;
    check_less("minor radius", minor_radius, "major radius", major_radius)?;
    let place = |place: &[u32], out: &mut Vec<f64>| {
        let (u, v) = (turn(place[0], grid[0]), turn(place[1], grid[1]));
        let [x, y, z] = torus_point(major_radius, minor_radius, u, v);
        let (half_c, half_s) = turn(place[0], grid[0].saturating_mul(2));
        out.extend([x, y, z * half_c, z * half_s]);
    };
    klein(grid, 4, &place, kind)
}

fn klein(
    grid: [u32; 2],
    space: usize,
    place: &dyn Fn(&[u32], &mut Vec<f64>),
    kind: CellKind,
) -> Result<PlacedCells, Error> {
    let [columns, rows] = grid;
    check_count("columns", columns, 3)?;
    check_count("rows", rows, 3)?;
    let glue = |place: &mut [u32]| {
        place[1] %= rows;
        if place[0] == columns {
            (place[0], place[1]) = (0, (rows - place[1]) % rows);
        }
    };
    Lattice { shape: &grid, space, glue: &glue, is_downward: &upward, place }.cells(kind)
}
