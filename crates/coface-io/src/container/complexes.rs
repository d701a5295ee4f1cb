//! Chain complexes in containers.

use super::integers::{integers, push_integers};
use super::{Container, ContainerWriter, Kind, Role};
use crate::{Model, Structure, segments};
use coface_algebra::chains::{ChainComplex, WideComplex};
use coface_algebra::{Entry, SparseMatrix, WideMatrix};
use coface_algebra::{Error, ErrorKind};
use coface_complexes::cell_mesh::CellMesh;
use coface_complexes::simplicial::FrozenComplex;
use coface_complexes::surface::{HalfedgePermutations, PolygonMesh};
use coface_geometry::Positions;
use std::io::{Read, Write};

/// Reads a chain complex; with positions if the file has them.
///
/// # Errors
/// [`ErrorKind::Parse`] with the byte for any damage; [`ErrorKind::UnsupportedFormat`] for a container of something else or of a newer version;
/// those of [`ChainComplex::new`].
///
/// # Complexity
/// Linear; nothing is allocated that the file does not fill.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::{Format, container};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = io::read(&b"[[0, 1, 2], [1, 2, 3]]"[..], Format::Json)?;
/// let mut bytes = Vec::new();
/// container::write(&model, &mut bytes)?;
/// let again = container::read(&bytes[..])?;
/// assert!(matches!(again.structure(), Some(io::Structure::Chains(complex)) if complex.f_vector() == [4, 5, 2]));
/// bytes[200] ^= 1;
/// assert!(container::read(&bytes[..]).is_err());
/// # Ok(()) }
/// ```
pub fn read(mut input: impl Read) -> Result<Model, Error> {
    let mut bytes = Vec::new();
    input.read_to_end(&mut bytes)?;
    let container = Container::open(&bytes, Kind::Complex)?;
    let complex = to_complex(&container)?;
    if !container.has(Role::Positions, 0) {
        return Ok(Model::from_structure(Structure::Chains(complex)).with_remark_on_cells());
    }
    let coordinates = container.array::<f64>(Role::Positions, 0)?.into_owned();
    let dimension = container.array::<u64>(Role::Meta, 0)?;
    let [dimension @ 1..=255] = dimension[..] else {
        return Err(container.lie(Role::Meta, 0, "positions have 1 to 255 coordinates"));
    };
    let positions = Positions::from_flat(dimension as usize, coordinates)?;
    Ok(Model::from_chains(complex, positions)?.with_remark_on_cells())
}

/// Writes the chain complex of a model, with the positions of its vertices if it has them; groups and data are not written.
///
/// # Errors
/// Those of the structure that the model becomes; [`coface_algebra::ErrorKind::InvalidInput`] naming a coordinate that is not
/// finite; [`ErrorKind::Io`] from the output.
pub fn write(model: &Model, mut out: impl Write) -> Result<(), Error> {
    model.require_finite()?;
    let made;
    let complex = match model.structure() {
        Some(Structure::Chains(complex)) => complex,
        other => {
            made = complex_of(model, other)?;
            &made
        }
    };
    let mut writer = ContainerWriter::new(Kind::Complex);
    push_complex(&mut writer, complex);
    if model.positions().len() == complex.cell_count(0) && model.positions().dimension() > 0 {
        writer.push_owned(Role::Meta, 0, &[model.positions().dimension() as u64]);
        writer.push(Role::Positions, 0, model.positions().as_flat());
    }
    writer.write(&mut out)?;
    out.flush()?;
    Ok(())
}

fn complex_of(model: &Model, structure: Option<&Structure>) -> Result<ChainComplex, Error> {
    Ok(match structure {
        Some(Structure::Facets(facets)) => FrozenComplex::from_facets(facets)?.chain_complex()?,
        Some(Structure::Halfedges { next, twin, outer }) => {
            HalfedgePermutations::new(next.clone(), twin.clone(), outer.clone())?.mesh()?.chain_complex()?
        }
        Some(Structure::Chains(complex)) => complex.clone(),
        Some(Structure::Gluings(table)) => table.faces()?.chain_complex()?,
        Some(Structure::Volume(volume)) => volume.chain_complex()?,
        None => {
            let (count, segments) = (model.vertex_count(), segments(model.lines()));
            if model.cells().is_empty() {
                PolygonMesh::new(count, model.polygons().clone(), &segments)?.into_chain_complex()?
            } else {
                let (shapes, cells) = (model.shapes().to_vec(), model.cells().clone());
                CellMesh::new(count, shapes, cells, model.polygons(), &segments)?.into_chain_complex()?
            }
        }
    })
}

fn push_counts<'a, E: Entry>(writer: &mut ContainerWriter<'a>, complex: &'a ChainComplex<E>) {
    let counts: Vec<u64> = complex.f_vector().iter().map(|&count| count as u64).collect();
    writer.push_owned(Role::Counts, 0, &counts);
    for (degree, matrix) in (1..).zip(complex.boundary_matrices()) {
        writer.push(Role::Starts, degree, matrix.column_starts());
        writer.push(Role::Rows, degree, matrix.rows());
    }
}

/// Appends the matrices of a complex.
///
/// # Examples
/// ```
/// use coface_algebra::chains::ChainComplex;
/// use coface_io::container::{Container, ContainerWriter, Kind, push_complex, to_complex};
/// let points = ChainComplex::of_points(3);
/// let mut writer = ContainerWriter::new(Kind::Complex);
/// push_complex(&mut writer, &points);
/// let mut bytes = Vec::new();
/// writer.write(&mut bytes)?;
/// assert_eq!(to_complex(&Container::open(&bytes, Kind::Complex)?)?, points);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn push_complex<'a>(writer: &mut ContainerWriter<'a>, complex: &'a ChainComplex) {
    push_counts(writer, complex);
    for (degree, matrix) in (1..).zip(complex.boundary_matrices()) {
        let short: Option<Vec<i8>> = matrix.entries().iter().map(|&x| i8::try_from(x).ok()).collect();
        match short {
            Some(short) => writer.push_owned(Role::Entries, degree, &short),
            None => writer.push(Role::Entries, degree, matrix.entries()),
        }
    }
}

/// Appends the matrices of a complex with entries of any size.
pub fn push_wide_complex<'a>(writer: &mut ContainerWriter<'a>, complex: &'a WideComplex) {
    push_counts(writer, complex);
    for (degree, matrix) in (1..).zip(complex.boundary_matrices()) {
        push_integers(writer, (Role::Entries, Role::WideEntries), degree, matrix.entries().iter());
    }
}

/// The numbers of cells and the matrices, with the entries that `entries` finds.
fn matrices<E: Entry>(
    container: &Container<'_>,
    entries: impl Fn(usize) -> Result<Vec<E>, Error>,
) -> Result<(usize, Vec<SparseMatrix<E>>), Error> {
    let counts = container.array::<u64>(Role::Counts, 0)?;
    let mut matrices = Vec::new();
    for (degree, pair) in (1..).zip(counts.windows(2)) {
        let starts = container.array::<u32>(Role::Starts, degree)?.into_owned();
        let rows = container.array::<u32>(Role::Rows, degree)?.into_owned();
        if Some(starts.len() as u64) != pair[1].checked_add(1) {
            return Err(container.lie(Role::Starts, degree, "there are not as many columns as cells"));
        }
        // A count of rows that does not fit is refused by the matrix.
        let row_count = usize::try_from(pair[0]).unwrap_or(usize::MAX);
        let matrix = SparseMatrix::checked(row_count, starts, rows, entries(degree)?);
        matrices.push(matrix.map_err(|error| {
            container.lie(
                Role::Starts,
                degree,
                &format!("the boundary matrix of degree {degree} is none: {}", error.message()),
            )
        })?);
    }
    let vertex_count = counts.first().copied().unwrap_or(0);
    match u32::try_from(vertex_count) {
        Ok(count) => Ok((count as usize, matrices)),
        Err(_) => Err(Error::new(
            ErrorKind::TooLarge,
            format!("there are {vertex_count} vertices; the limit is 2^32 - 1"),
        )),
    }
}

/// The complex in a container.
///
/// # Errors
/// [`ErrorKind::Parse`] where sections are missing or do not fit together; [`ErrorKind::BoundaryOfBoundary`].
///
/// # Examples
/// ```
/// use coface_algebra::chains::ChainComplex;
/// use coface_io::container::{Container, ContainerWriter, Kind, push_complex, to_complex};
/// let points = ChainComplex::of_points(3);
/// let mut writer = ContainerWriter::new(Kind::Complex);
/// push_complex(&mut writer, &points);
/// let mut bytes = Vec::new();
/// writer.write(&mut bytes)?;
/// assert_eq!(to_complex(&Container::open(&bytes, Kind::Complex)?)?, points);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn to_complex(container: &Container<'_>) -> Result<ChainComplex, Error> {
    let (vertex_count, matrices) = matrices(container, |degree| {
        Ok(match container.width(Role::Entries, degree)? {
            1 => container.array::<i8>(Role::Entries, degree)?.iter().map(|&x| i32::from(x)).collect(),
            _ => container.array::<i32>(Role::Entries, degree)?.into_owned(),
        })
    })?;
    match matrices.is_empty() {
        true => Ok(ChainComplex::of_points(vertex_count)),
        false => ChainComplex::new(matrices),
    }
}

/// The complex with entries of any size in a container.
///
/// # Errors
/// As of [`to_complex`].
pub fn to_wide_complex(container: &Container<'_>) -> Result<WideComplex, Error> {
    let (vertex_count, matrices): (usize, Vec<WideMatrix>) =
        matrices(container, |degree| integers(container, (Role::Entries, Role::WideEntries), degree))?;
    WideComplex::of_wide(vertex_count, matrices)
}
