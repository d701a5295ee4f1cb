//! From a model to a stream.

use crate::decimal::{flush, push_f64};
use crate::{Model, Structure, segments};
use coface_algebra::Error;
use coface_algebra::SparseMatrix;
use coface_algebra::chains::{ChainComplex, ChainRefinement};
use coface_arrange::planar::ExactSegments;
use coface_arrange::spatial::ExactPolygons;
use coface_complexes::cell_mesh::{CellMesh, CellShape};
use coface_complexes::gluing::GluingTable;
use coface_complexes::surface::PolygonMesh;
use coface_geometry::Positions;
use std::io::{BufWriter, Write};

/// Writes a structure as JSON, one point, facet, matrix or simplex a line; a chain complex with its positions.
///
/// A mesh of simplices becomes its list of facets, with the positions of its vertices: groups are not written, polylines become edges, isolated
/// vertices become facets of their own. Positions that are not all finite are left out. Any other mesh becomes its chain complex, with positions; which vertices a cell has is
/// given by the boundary matrices then.
///
/// # Errors
/// Those of [`CellMesh::new`] and [`PolygonMesh::new`] for a mesh that is not of simplices; [`coface_algebra::ErrorKind::Io`] from the
/// output.
///
/// # Examples
/// ```
/// use coface_io::json;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = json::read(&b"[[0, 1, 2], [1, 2, 3]]"[..])?;
/// let mut out = Vec::new();
/// json::write(&model, &mut out)?;
/// assert_eq!(out, b"{\"facets\":[\n[0,1,2],\n[1,2,3]\n]}\n");
/// # Ok(()) }
/// ```
pub fn write(model: &Model, out: impl Write) -> Result<(), Error> {
    let mut out = BufWriter::with_capacity(1 << 16, out);
    match model.structure() {
        Some(Structure::Facets(facets)) => write_facets(&mut out, model.positions(), facets.iter())?,
        Some(Structure::Halfedges { next, twin, outer }) => {
            out.write_all(b"{")?;
            if !model.positions().is_empty() {
                write_points(&mut out, model.positions())?;
            }
            write!(out, "\"next\":")?;
            write_list(&mut out, next)?;
            write!(out, ",\n\"twin\":")?;
            write_list(&mut out, twin)?;
            if !outer.is_empty() {
                write!(out, ",\n\"outer\":")?;
                write_list(&mut out, outer)?;
            }
            writeln!(out, "}}")?;
        }
        Some(Structure::Chains(complex)) => {
            write_chains(&mut out, complex, model.positions(), Beside::of(model))?;
        }
        Some(Structure::Gluings(table)) => write_gluings(&mut out, table)?,
        Some(Structure::Volume(volume)) => {
            write_chains(&mut out, &volume.chain_complex()?, model.positions(), Beside::default())?;
        }
        None => write_mesh(&mut out, model)?,
    }
    out.flush()?;
    Ok(())
}

/// The chain complex of the cells of a mesh.
fn mesh_complex(model: &Model) -> Result<ChainComplex, Error> {
    let (count, segments) = (model.vertex_count(), segments(model.lines()));
    if model.cells().is_empty() {
        return PolygonMesh::new(count, model.polygons().clone(), &segments)?.into_chain_complex();
    }
    let (shapes, cells) = (model.shapes().to_vec(), model.cells().clone());
    CellMesh::new(count, shapes, cells, model.polygons(), &segments)?.into_chain_complex()
}

/// A mesh of simplices: its cells, then the vertices that none of them has. Any other: its chain complex.
fn write_mesh(out: &mut impl Write, model: &Model) -> Result<(), Error> {
    let is_simplicial = model.polygons().iter().all(|polygon| polygon.len() == 3)
        && model.shapes().iter().all(|&shape| shape == CellShape::Tetrahedron);
    if !is_simplicial || model.exact_polygons().is_some() || model.exact_segments().is_some() {
        // JSON has no words for NaN and infinity.
        model.require_finite()?;
        return write_chains(out, &mesh_complex(model)?, model.positions(), Beside::of(model));
    }
    let mut isolated = vec![true; model.vertex_count()];
    for list in [model.cells(), model.polygons(), model.lines()] {
        for &vertex in list.items() {
            isolated[vertex as usize] = false;
        }
    }
    let isolated: Vec<u32> = (0..model.vertex_count() as u32).filter(|&v| isolated[v as usize]).collect();
    let edges = model.lines().iter().flat_map(|line| line.windows(2));
    let simplices = model.cells().iter().chain(model.polygons().iter()).chain(edges);
    write_facets(out, model.positions(), simplices.chain(isolated.chunks(1)))
}

fn write_facets<'a>(
    out: &mut impl Write,
    positions: &Positions,
    facets: impl Iterator<Item = &'a [u32]>,
) -> Result<(), Error> {
    out.write_all(b"{")?;
    if !positions.is_empty() {
        write_points(out, positions)?;
    }
    write!(out, "\"facets\":[")?;
    for (i, facet) in facets.enumerate() {
        out.write_all(if i == 0 { b"\n" } else { b",\n" })?;
        write_list(out, facet)?;
    }
    writeln!(out, "\n]}}")?;
    Ok(())
}

fn write_list(out: &mut impl Write, list: &[u32]) -> Result<(), Error> {
    out.write_all(b"[")?;
    for (i, number) in list.iter().enumerate() {
        if i > 0 {
            out.write_all(b",")?;
        }
        write!(out, "{number}")?;
    }
    out.write_all(b"]")?;
    Ok(())
}

/// One simplex a line.
fn write_gluings(out: &mut impl Write, table: &GluingTable) -> Result<(), Error> {
    write!(out, "{{\"gluings\":[")?;
    for (i, row) in table.rows().enumerate() {
        out.write_all(if i == 0 { b"\n[" } else { b",\n[" })?;
        for (facet, gluing) in row.iter().enumerate() {
            out.write_all(if facet == 0 { b"" } else { b"," })?;
            match gluing {
                Some((neighbor, images)) => {
                    write!(out, "[{neighbor},")?;
                    write_list(out, images)?;
                    out.write_all(b"]")?;
                }
                None => out.write_all(b"null")?,
            }
        }
        out.write_all(b"]")?;
    }
    writeln!(out, "\n]}}")?;
    Ok(())
}

fn write_points(out: &mut impl Write, positions: &Positions) -> Result<(), Error> {
    let mut text = b"\"vertices\":[".to_vec();
    for (i, point) in positions.as_flat().chunks_exact(positions.dimension()).enumerate() {
        text.extend_from_slice(if i == 0 { b"\n[" } else { b",\n[" });
        for (axis, &coordinate) in point.iter().enumerate() {
            if axis > 0 {
                text.push(b',');
            }
            push_f64(&mut text, coordinate);
        }
        text.push(b']');
        flush(&mut text, out)?;
    }
    text.extend_from_slice(b"\n],\n");
    out.write_all(&text)?;
    Ok(())
}

/// What is written beside the matrices of a chain complex.
#[derive(Clone, Copy, Default)]
struct Beside<'a> {
    refinement: Option<&'a ChainRefinement>,
    exact: Option<&'a ExactPolygons>,
    segments: Option<&'a ExactSegments>,
}

impl<'a> Beside<'a> {
    fn of(model: &'a Model) -> Self {
        Self {
            refinement: model.refinement(),
            exact: model.exact_polygons().map(|exact| &**exact),
            segments: model.exact_segments().map(|exact| &**exact),
        }
    }
}

/// A complex of points alone, without positions, is written as one matrix without columns. Positions come first, one point a line, and
/// what cells are pieces of last.
fn write_chains(
    out: &mut impl Write,
    complex: &ChainComplex,
    positions: &Positions,
    beside: Beside<'_>,
) -> Result<(), Error> {
    out.write_all(b"{")?;
    if !positions.is_empty() {
        write_points(out, positions)?;
    }
    write!(out, "\"boundaries\":[")?;
    let points = match complex.boundary_matrices() {
        // Positions tell their number.
        [] if positions.is_empty() && complex.degree_count() > 0 => {
            Some(SparseMatrix::zero(complex.cell_count(0), 0)?)
        }
        _ => None,
    };
    for (i, matrix) in complex.boundary_matrices().iter().chain(&points).enumerate() {
        out.write_all(if i == 0 { b"\n" } else { b",\n" })?;
        write!(out, "{{\"rows\":{},\"cols\":{},\"entries\":[", matrix.row_count(), matrix.column_count())?;
        let mut first = true;
        for (j, column) in matrix.columns().enumerate() {
            for (row, entry) in column.iter() {
                out.write_all(if first { b"" } else { b"," })?;
                first = false;
                write!(out, "[{row},{j},{entry}]")?;
            }
        }
        out.write_all(b"]}")?;
    }
    write!(out, "\n]")?;
    if let Some(refinement) = beside.refinement {
        write!(out, ",\n\"pieces_of\":[")?;
        for degree in 0..refinement.degree_count() {
            out.write_all(if degree == 0 { b"\n[" } else { b",\n[" })?;
            for (i, piece) in refinement.pieces(degree).enumerate() {
                out.write_all(if i == 0 { b"" } else { b"," })?;
                match piece {
                    Some(cell) => write!(out, "{cell}")?,
                    None => out.write_all(b"null")?,
                }
            }
            out.write_all(b"]")?;
        }
        write!(out, "\n]")?;
    }
    if let Some(exact) = beside.exact {
        writeln!(out, ",")?;
        super::exact::write(out, exact)?;
    }
    if let Some(segments) = beside.segments {
        writeln!(out, ",")?;
        super::exact_segments::write(out, segments)?;
    }
    writeln!(out, "}}")?;
    Ok(())
}
