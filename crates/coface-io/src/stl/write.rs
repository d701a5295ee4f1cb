//! Writing STL.

use super::Encoding;
use crate::decimal::flush;
use crate::limits::{require_dimension, require_mesh};
use crate::losses::single_precision_remark;
use crate::triangles::{Triangles, triangulated_remark};
use crate::{GroupKind, Model, Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind, VertexId};
use std::io::Write;

/// Writes the polygons of a model in STL, as triangles, in single precision.
///
/// What STL is not made for is lost: digits beyond single precision, vertices that no polygon uses, and, in binary,
/// groups. In text each polygon stands in a solid of the name of its first group. A polygon of more than three vertices is cut into triangles on
/// its own vertices. [`losses`](crate::losses) says what a model loses.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] naming formats that serve if the model has lines,
/// points, 3-cells, vertices and no polygon, no positions, more than three coordinates a vertex or one that single precision cannot hold, or is
/// an abstract structure; [`ErrorKind::TooLarge`] beyond 2^32 - 1 triangles in binary; [`ErrorKind::Io`] if the stream
/// fails.
///
/// # Examples
/// ```
/// use coface_io::{obj, stl};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = obj::read("v 0 0 0\nv 1 0 0\nv 0 0.5 0\nf 1 2 3\n".as_bytes())?;
/// let mut written = Vec::new();
/// stl::write(&triangle, &mut written, stl::Encoding::Binary)?;
/// assert_eq!(written.len(), 84 + 50);
/// assert_eq!(stl::read(&written[..])?, triangle);
/// # Ok(()) }
/// ```
pub fn write(model: &Model, mut output: impl Write, encoding: Encoding) -> Result<(), Error> {
    require_mesh(model, "STL", "MEDIT, MSH or VTK")?;
    require_dimension(model, "STL", 3)?;
    let triangles = Triangles::of(model, "STL")?;
    let coordinates = single(model)?;
    let corner = |vertex: u32| -> [f32; 3] {
        let at = 3 * vertex as usize;
        [coordinates[at], coordinates[at + 1], coordinates[at + 2]]
    };
    match encoding {
        Encoding::Binary => write_binary(&triangles, corner, &mut output)?,
        Encoding::Ascii => write_text(model, &triangles, corner, &mut output)?,
    }
    output.flush()?;
    Ok(())
}

/// What a file of the model does not keep: nothing for a model that is refused.
pub(crate) fn losses(model: &Model) -> Vec<Remark> {
    let is_held = require_mesh(model, "STL", "").and_then(|()| require_dimension(model, "STL", 3));
    let (Ok(()), Ok(triangles), Ok(single)) = (is_held, Triangles::of(model, "STL"), single(model)) else {
        return Vec::new();
    };
    let dimension = model.coordinate_count();
    let point = |numbers: &[f64]| -> [f64; 3] {
        std::array::from_fn(|axis| numbers.get(axis).copied().unwrap_or(0.0))
    };
    let points = model.coordinates().chunks_exact(dimension.max(1)).zip(single.as_chunks::<3>().0);
    let rounding = single_precision_remark(points.map(|(own, rounded)| [point(own), rounded.map(f64::from)]));
    let mut remarks: Vec<Remark> = triangulated_remark(model).into_iter().chain(rounding).collect();
    let mut add = |code: RemarkCode, count: usize, message: String| {
        if count > 0 {
            remarks.push(Remark::new(code, message).at(count, []));
        }
    };
    let [is, are] = ["is", "are"].map(str::to_owned);
    let vertices =
        |count: usize| if count == 1 { "1 vertex".to_owned() } else { format!("{count} vertices") };
    let mut used: Vec<u32> = triangles.corners.to_vec();
    used.sort_unstable();
    used.dedup();
    // Zeros of both signs are equal.
    let place = |vertex: u32| -> [u32; 3] {
        std::array::from_fn(|axis| (single[3 * vertex as usize + axis] + 0.0).to_bits())
    };
    let exact = |vertex: u32| -> [u64; 3] {
        let at = vertex as usize * dimension;
        std::array::from_fn(|axis| {
            if axis < dimension { (model.coordinates()[at + axis] + 0.0).to_bits() } else { 0 }
        })
    };
    let different = |keys: &mut Vec<[u64; 3]>| {
        keys.sort_unstable();
        keys.dedup();
        keys.len()
    };
    let apart = different(&mut used.iter().map(|&vertex| exact(vertex)).collect());
    let left = different(&mut used.iter().map(|&vertex| place(vertex).map(u64::from)).collect());
    let is_collapsed = |triangle: &&[u32]| {
        let [a, b, c] = [0, 1, 2].map(|corner| place(triangle[corner]));
        a == b || b == c || c == a
    };
    let collapsed = triangles.iter().filter(is_collapsed).count();
    let merged = apart - left;
    let triangles_collapse = match collapsed {
        1 => "1 triangle collapses".to_owned(),
        _ => format!("{collapsed} triangles collapse"),
    };
    add(
        RemarkCode::RoundedInvalid,
        merged,
        format!(
            "single precision makes vertices one that are apart: {} {} lost and {triangles_collapse}, so the surface that is read is another one",
            vertices(merged),
            if merged == 1 { &is } else { &are }
        ),
    );
    let twins = used.len() - apart;
    add(
        RemarkCode::FormatKeepsLess,
        twins,
        match twins {
            1 => "1 vertex is at the place of another: they are one in STL".to_owned(),
            _ => format!("{twins} vertices are at the places of others: they are one in STL"),
        },
    );
    let loose = model.vertex_count - used.len();
    add(
        RemarkCode::FormatKeepsLess,
        loose,
        format!(
            "{} {} in no triangle and {} left out",
            vertices(loose),
            if loose == 1 { &is } else { &are },
            if loose == 1 { &is } else { &are }
        ),
    );
    remarks
}

/// The positions in single precision, filled up with zeros to three coordinates.
fn single(model: &Model) -> Result<Vec<f32>, Error> {
    let dimension = model.coordinate_count();
    let mut coordinates = Vec::with_capacity(3 * model.vertex_count);
    for (i, point) in model.coordinates().chunks_exact(dimension.max(1)).enumerate() {
        for axis in 0..3 {
            let value = point.get(axis).copied().unwrap_or(0.0);
            // What is not finite in the model is not in the file either.
            if value.is_finite() && !(value as f32).is_finite() {
                return Err(Error::new(
                    ErrorKind::UnsupportedFormat,
                    format!("the coordinate {value:e} of {} is too large for STL", VertexId::new(i)),
                )
                .with_cure("scale the model down, or write OBJ, PLY or OFF"));
            }
            coordinates.push(value as f32);
        }
    }
    Ok(coordinates)
}

/// The unit normal of a triangle whose corners run counterclockwise seen from its tip; zero if they are collinear.
fn normal([a, b, c]: [[f32; 3]; 3]) -> [f32; 3] {
    let difference = |p: [f32; 3]| std::array::from_fn::<f64, 3, _>(|i| f64::from(p[i]) - f64::from(a[i]));
    let (u, v) = (difference(b), difference(c));
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length > 0.0 && length.is_finite() { cross.map(|x| (x / length) as f32) } else { [0.0; 3] }
}

fn write_binary(
    triangles: &Triangles<'_>,
    corner: impl Fn(u32) -> [f32; 3],
    output: &mut impl Write,
) -> Result<(), Error> {
    let count = u32::try_from(triangles.len())
        .map_err(|_| Error::new(ErrorKind::TooLarge, "more than 2^32 - 1 triangles"))?;
    let mut bytes = vec![b' '; 80];
    let title = b"binary STL";
    bytes[..title.len()].copy_from_slice(title);
    bytes.extend_from_slice(&count.to_le_bytes());
    for triangle in triangles.iter() {
        let corners = [corner(triangle[0]), corner(triangle[1]), corner(triangle[2])];
        for value in [normal(corners), corners[0], corners[1], corners[2]].iter().flatten() {
            bytes.extend_from_slice(&value.to_le_bytes());
        }
        bytes.extend_from_slice(&[0, 0]);
        flush(&mut bytes, output)?;
    }
    output.write_all(&bytes)?;
    Ok(())
}

fn write_text(
    model: &Model,
    triangles: &Triangles<'_>,
    corner: impl Fn(u32) -> [f32; 3],
    output: &mut impl Write,
) -> Result<(), Error> {
    let solids = first_groups(model);
    let name = |i: usize| solids.get(i).copied().flatten().map_or("", |group| model.groups[group].name());
    let mut text = Vec::new();
    let mut current = name(0);
    push_line(&mut text, "solid", current);
    for (i, triangle) in triangles.iter().enumerate() {
        let i = triangles.polygon(i);
        if name(i) != current {
            push_line(&mut text, "endsolid", current);
            current = name(i);
            push_line(&mut text, "solid", current);
        }
        let corners = [corner(triangle[0]), corner(triangle[1]), corner(triangle[2])];
        push_numbers(&mut text, "  facet normal", normal(corners));
        text.extend_from_slice(b"    outer loop\n");
        for corner in corners {
            push_numbers(&mut text, "      vertex", corner);
        }
        text.extend_from_slice(b"    endloop\n  endfacet\n");
        flush(&mut text, output)?;
    }
    push_line(&mut text, "endsolid", current);
    output.write_all(&text)?;
    Ok(())
}

/// The first group of each polygon; empty if there are no groups.
fn first_groups(model: &Model) -> Vec<Option<usize>> {
    let mut first = Vec::new();
    for (i, group) in model.groups.iter().enumerate().filter(|(_, group)| group.kind() == GroupKind::Polygons)
    {
        first.resize(model.polygons.len(), None);
        for &member in group.members() {
            if let Some(slot) = first.get_mut(member as usize) {
                slot.get_or_insert(i);
            }
        }
    }
    first
}

/// A keyword and a name, in which blanks stand for control characters, which would end the line.
fn push_line(text: &mut Vec<u8>, keyword: &str, name: &str) {
    let name: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    text.extend_from_slice(format!("{keyword} {name}").trim_end().as_bytes());
    text.push(b'\n');
}

fn push_numbers(text: &mut Vec<u8>, keyword: &str, values: [f32; 3]) {
    text.extend_from_slice(keyword.as_bytes());
    for value in values {
        let size = value.abs();
        let written = if size == 0.0 || (1e-5..1e7).contains(&size) {
            write!(text, " {value}")
        } else {
            write!(text, " {value:e}")
        };
        written.expect("writing to memory does not fail");
    }
    text.push(b'\n');
}
