//! Structured, rectilinear and uniform grids: their cells follow from three counts of points.

use super::reader::{Grid, GridKind, Reader};
use crate::element_kind::Kind;
use coface_algebra::{Error, ErrorKind};
use std::io::Read;

/// Uniform and rectilinear grids may have so many points: they are not in the file, so it cannot vouch for them.
const MOST_POINTS: u64 = 1 << 24;
/// A grid has at most so many points and eight for each byte of the file.
const FREE_POINTS: u64 = 1 << 18;

/// Reads what follows one of the keywords of a grid.
pub(super) fn read_line<R: Read>(reader: &mut Reader<R>, keyword: &[u8]) -> Result<(), Error> {
    if reader.grid.kind.is_none() {
        return Err(reader
            .values
            .error("the data set is no grid")
            .with_cure("check the kind of the data set"));
    }
    let scanner = &mut reader.values.scanner;
    match keyword {
        b"DIMENSIONS" => {
            let mut dimensions = [0; 3];
            for dimension in &mut dimensions {
                *dimension = scanner.expect_u64("a count of points along an axis")?;
            }
            reader.grid.dimensions = Some(dimensions);
        }
        b"ORIGIN" => {
            for coordinate in &mut reader.grid.origin {
                *coordinate = scanner.expect_f64("the origin")?;
            }
        }
        b"SPACING" | b"ASPECT_RATIO" => {
            let mut spacing = [0.0; 3];
            for step in &mut spacing {
                *step = scanner.expect_f64("the spacing")?;
            }
            reader.grid.spacing = Some(spacing);
        }
        _ => {
            let count = scanner.expect_u64("a count of coordinates")?;
            let number = reader.read_type()?;
            reader.values.end_line()?;
            let mut axis = Vec::new();
            for _ in 0..count {
                axis.push(reader.values.float(number, "a coordinate")?);
            }
            reader.grid.axes[usize::from(keyword[0] - b'X')] = Some(axis);
        }
    }
    Ok(())
}

/// Makes the points, unless they are in the file, and the cells.
pub(super) fn finish<R: Read>(reader: &mut Reader<R>) -> Result<(), Error> {
    let grid = std::mem::take(&mut reader.grid);
    let Some(dimensions) = grid.dimensions else {
        return Err(
            Error::parse("the file ends before DIMENSIONS").with_cure("it was cut short: write it again")
        );
    };
    let point_count = dimensions.iter().try_fold(1u64, |product, &count| product.checked_mul(count));
    let point_count = point_count.unwrap_or(u64::MAX);
    if grid.kind == Some(GridKind::Curved) {
        if point_count != reader.elements.assembly.vertex_count() as u64 {
            return Err(Error::invalid(format!(
                "the dimensions {} x {} x {} do not fit the {} points",
                dimensions[0],
                dimensions[1],
                dimensions[2],
                reader.elements.assembly.vertex_count()
            ))
            .with_cure("the product of the dimensions is the count of points"));
        }
    } else {
        // Eight points a byte: a grid with values, packed as tightly as bits, has room for more.
        let byte_count = reader.values.scanner.byte_offset();
        if point_count > FREE_POINTS + 8 * byte_count {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!(
                    "the grid has {} x {} x {} points, but the file has only {byte_count} bytes",
                    dimensions[0], dimensions[1], dimensions[2]
                ),
            )
            .with_cure("check the dimensions, or give the grid the values at its points"));
        }
        if point_count > MOST_POINTS {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!(
                    "the grid has {} x {} x {} points; the limit is {MOST_POINTS}",
                    dimensions[0], dimensions[1], dimensions[2]
                ),
            )
            .with_cure("cut it down to the part that matters"));
        }
        add_points(reader, &grid, dimensions)?;
    }
    add_cells(reader, dimensions)
}

fn add_points<R: Read>(reader: &mut Reader<R>, grid: &Grid, dimensions: [u64; 3]) -> Result<(), Error> {
    let mut axes: [Vec<f64>; 3] = [const { Vec::new() }; 3];
    for (i, axis) in axes.iter_mut().enumerate() {
        let count = dimensions[i];
        if grid.kind == Some(GridKind::Uniform) {
            let step = grid.spacing.map_or(1.0, |spacing| spacing[i]);
            // An axis may be long while another has no point at all.
            let count = if dimensions.contains(&0) { 0 } else { count };
            axis.extend((0..count).map(|k| grid.origin[i] + k as f64 * step));
        } else {
            let name = ["X", "Y", "Z"][i];
            match &grid.axes[i] {
                Some(given) if given.len() as u64 == count => axis.extend_from_slice(given),
                given => {
                    let found = given.as_ref().map_or(0, Vec::len);
                    return Err(Error::invalid(format!(
                        "{name}_COORDINATES has {found} coordinates, but the dimension is {count}"
                    ))
                    .with_cure("give as many coordinates as the dimension says"));
                }
            }
        }
        if let Some(bad) = axis.iter().find(|coordinate| !coordinate.is_finite()) {
            return Err(
                Error::invalid(format!("the grid has the coordinate {bad}")).with_cure("check the spacing")
            );
        }
    }
    for &z in &axes[2] {
        for &y in &axes[1] {
            for &x in &axes[0] {
                reader.elements.assembly.add_vertex(&[x, y, z])?;
            }
        }
    }
    Ok(())
}

/// Hexahedra, quadrangles, lines or one point, by the number of axes with more than one point.
fn add_cells<R: Read>(reader: &mut Reader<R>, dimensions: [u64; 3]) -> Result<(), Error> {
    if dimensions.contains(&0) {
        return Ok(());
    }
    let strides = [1, dimensions[0], dimensions[0] * dimensions[1]];
    let long: Vec<usize> = (0..3).filter(|&i| dimensions[i] > 1).collect();
    let (kind, corners): (Kind, &[[u64; 3]]) = match long.len() {
        3 => (
            Kind::HEXAHEDRON,
            &[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]],
        ),
        2 => (Kind::Polygon, &[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]),
        1 => (Kind::Line, &[[0, 0, 0], [1, 0, 0]]),
        _ => (Kind::Point, &[[0, 0, 0]]),
    };
    // The counts of cells along the axes that are long, and the strides along them.
    let along = |i: usize| long.get(i).map_or((1, 0), |&axis| (dimensions[axis] - 1, strides[axis]));
    let [(nx, dx), (ny, dy), (nz, dz)] = [along(0), along(1), along(2)];
    let mut vertices = [0; 8];
    for z in 0..nz {
        for y in 0..ny {
            for x in 0..nx {
                for (vertex, corner) in vertices.iter_mut().zip(corners) {
                    let at = (x + corner[0]) * dx + (y + corner[1]) * dy + (z + corner[2]) * dz;
                    *vertex = u32::try_from(at).expect("the points were counted in 32 bits");
                }
                let cell = reader.elements.assembly.add(
                    kind,
                    corners.len(),
                    &vertices[..corners.len()],
                    u64::from,
                )?;
                match (kind, cell) {
                    (Kind::Point, _) | (_, None) => reader.elements.cells.add(0, None, 0, 0),
                    (kind, Some(cell)) => reader.elements.cells.add(0, Some(kind.group_kind()), cell, 1),
                }
            }
        }
    }
    Ok(())
}
