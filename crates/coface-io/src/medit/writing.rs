//! Writing, as text.

use super::sections::all_marks;
use crate::assembly::{first_numbers, group_numbers};
use crate::decimal::{flush, push_f64, push_natural};
use crate::{Group, GroupKind};
use crate::{Model, limits};
use coface_algebra::{Error, ErrorKind};
use coface_complexes::cell_mesh::CellShape;
use std::io::Write;

/// Writes a MEDIT mesh as text, section by section: polylines become edges, and cells are sorted by their shape, otherwise
/// the order stays. A vertex or element in several groups gets the number of the first one; a group whose name is not a
/// number gets a number that is free. Points of their own are not written.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] for a polygon of more than four vertices, an abstract structure, and vertices without
/// positions or of a dimension other than 2 and 3; [`ErrorKind::Io`] from the output.
///
/// # Examples
/// ```
/// use coface_io::medit;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = "MeshVersionFormatted 2\nDimension 2\nVertices\n2\n0 0 0\n1 0.5 0\nEdges\n1\n1 2 8\nEnd\n";
/// let mut out = Vec::new();
/// medit::write(&medit::read(text.as_bytes())?, &mut out)?;
/// assert_eq!(out, text.as_bytes());
/// # Ok(()) }
/// ```
pub fn write(model: &Model, mut out: impl Write) -> Result<(), Error> {
    limits::require_volume_mesh(model, "MEDIT")?;
    let dimension = match model.coordinate_count() {
        0 => 3,
        dimension @ 2..=3 => dimension,
        dimension => {
            let message = format!("MEDIT holds points of 2 or 3 coordinates, and the model has {dimension}");
            return Err(
                Error::new(ErrorKind::UnsupportedFormat, message).with_cure("write OFF, which holds any")
            );
        }
    };
    limits::require_small_polygons(model, "MEDIT")?;
    let is_mark =
        |group: &Group| all_marks().any(|marks| marks.name == group.name() && marks.kind == group.kind());
    let groups: Vec<Group> = model.groups.iter().filter(|group| !is_mark(group)).cloned().collect();
    let numbers = group_numbers(&groups);
    let references = |kind, count| first_numbers(&groups, &numbers, kind, count);

    let mut text =
        format!("MeshVersionFormatted 2\nDimension {dimension}\nVertices\n{}\n", model.vertex_count)
            .into_bytes();
    let vertex_references = references(GroupKind::Vertices, model.vertex_count);
    for (point, reference) in model.coordinates().chunks_exact(dimension).zip(vertex_references) {
        for &coordinate in point {
            push_f64(&mut text, coordinate);
            text.push(b' ');
        }
        push_natural(&mut text, reference as u64);
        text.push(b'\n');
        flush(&mut text, &mut out)?;
    }
    let line_references = references(GroupKind::Lines, model.lines.len());
    let edges = model.lines.iter().zip(&line_references);
    let edges = edges.flat_map(|(line, &reference)| line.windows(2).map(move |edge| (edge, reference)));
    let edge_count = model.lines.item_count() - model.lines.len();
    write_section(&mut text, &mut out, "Edges", edge_count, edges)?;
    let polygon_references = references(GroupKind::Polygons, model.polygons.len());
    for (keyword, size) in [("Triangles", 3), ("Quadrilaterals", 4)] {
        let count = model.polygons.iter().filter(|polygon| polygon.len() == size).count();
        let polygons = model.polygons.iter().zip(polygon_references.iter().copied());
        let polygons = polygons.filter(|(polygon, _)| polygon.len() == size);
        write_section(&mut text, &mut out, keyword, count, polygons)?;
    }
    let cell_references = references(GroupKind::Cells, model.cells.len());
    for (keyword, shape) in [
        ("Tetrahedra", CellShape::Tetrahedron),
        ("Hexahedra", CellShape::Hexahedron),
        ("Prisms", CellShape::Wedge),
        ("Pyramids", CellShape::Pyramid),
    ] {
        let cells = model.cells.iter().zip(cell_references.iter().copied()).zip(&model.shapes);
        let cells = cells.filter(|&(_, &s)| s == shape).map(|(cell, _)| cell);
        let count = model.shapes.iter().filter(|&&s| s == shape).count();
        write_section(&mut text, &mut out, keyword, count, cells)?;
    }
    write_marks(&mut text, model);
    text.extend_from_slice(b"End\n");
    out.write_all(&text)?;
    out.flush()?;
    Ok(())
}

/// One section of elements with their references; none if there are no elements.
fn write_section<'a>(
    text: &mut Vec<u8>,
    out: &mut impl Write,
    keyword: &str,
    count: usize,
    elements: impl Iterator<Item = (&'a [u32], i32)>,
) -> Result<(), Error> {
    if count == 0 {
        return Ok(());
    }
    text.extend_from_slice(format!("{keyword}\n{count}\n").as_bytes());
    for (vertices, reference) in elements {
        for &vertex in vertices {
            push_natural(text, u64::from(vertex) + 1);
            text.push(b' ');
        }
        push_natural(text, reference as u64);
        text.push(b'\n');
        flush(text, out)?;
    }
    Ok(())
}

/// The sections of marked vertices and elements. Their members are numbered within their own section, so polygons are
/// counted by size and polylines by edges.
fn write_marks(text: &mut Vec<u8>, model: &Model) {
    for marks in all_marks() {
        let group = |group: &&Group| group.name() == marks.name && group.kind() == marks.kind;
        let Some(group) = model.groups.iter().find(group) else { continue };
        let mut number = 0u64;
        let sizes: Vec<u64> = match marks.kind {
            GroupKind::Vertices => vec![1; model.vertex_count],
            GroupKind::Lines => model.lines.iter().map(|line| line.len() as u64 - 1).collect(),
            _ => model.polygons.iter().map(|p| u64::from(p.len() == marks.corner_count)).collect(),
        };
        let firsts: Vec<u64> = sizes
            .iter()
            .map(|size| {
                number += size;
                number - size
            })
            .collect();
        let members = group.members().iter().map(|&member| member as usize).filter(|&m| m < sizes.len());
        let marked: Vec<u64> =
            members.flat_map(|member| firsts[member]..firsts[member] + sizes[member]).collect();
        text.extend_from_slice(format!("{}\n{}\n", marks.name, marked.len()).as_bytes());
        for number in marked {
            push_natural(text, number + 1);
            text.push(b'\n');
        }
    }
}
