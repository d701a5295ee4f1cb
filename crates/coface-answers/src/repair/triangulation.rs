//! Gluing tables and halfedge permutations as simplicial complexes.

use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind};
use coface_complexes::simplicial::Carrier;
use coface_complexes::surface::HalfedgePermutations;
use coface_io::{Model, Structure};

/// A gluing table or a surface of halfedges as a facet list: its first barycentric subdivision if that tells simplices apart by
/// their vertices, else its second; halfedges that are a simplicial complex as they stand are not subdivided. For each
/// vertex of the result the face class, or the cell of the surface (dimension and number) that it lies in the interior of.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] for other models; [`ErrorKind::InvalidInput`] for halfedges that are no permutations; [`ErrorKind::TooLarge`] beyond 32 bits.
///
/// # Examples
/// ```
/// use coface_io::{Model, Structure};
/// use coface_answers::triangulated;
/// use coface_complexes::gluing::GluingTable;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let table = GluingTable::from_isomorphism_signature("cMcabbgqw", 3)?;
/// let (model, carriers) = triangulated(&Model::from_structure(Structure::Gluings(table)))?;
/// let Some(Structure::Facets(facets)) = model.structure() else { panic!() };
/// // Two tetrahedra, subdivided twice: 2 times 24 times 24.
/// assert_eq!(facets.len(), 1152);
/// assert_eq!(carriers.iter().filter(|carrier| carrier.0 == 0).count(), 1, "the one vertex of the table");
/// # Ok(()) }
/// ```
pub fn triangulated(model: &Model) -> Result<(Model, Vec<Carrier>), Error> {
    let (complex, carriers) = match model.structure() {
        Some(Structure::Gluings(table)) => table.faces()?.barycentric_subdivision()?.triangulation()?,
        Some(Structure::Halfedges { next, twin, outer }) => {
            HalfedgePermutations::new(next.clone(), twin.clone(), outer.clone())?.mesh()?.triangulation()?
        }
        _ => {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                "only gluing tables and halfedge permutations are subdivided",
            )
            .with_cure("convert the model without --triangulate"));
        }
    };
    let frozen = complex.freeze();
    let top = frozen.dimension().unwrap_or(0);
    let facets = (0..frozen.simplex_count(top)).map(|i| frozen.numbers(top, i));
    let carriers = carriers.iter().copied().collect();
    Ok((Model::from_structure(Structure::Facets(RaggedArray::from_lists(facets))), carriers))
}

/// A gluing table of tetrahedra with its ideal vertices cut off: a manifold with boundary where all other links are spheres or disks.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] for other models; [`ErrorKind::InvalidInput`] where no vertex is ideal; those of
/// [`coface_complexes::gluing::GluingTable::truncated`].
///
/// # Complexity
/// Linear.
///
/// # Examples
/// The complement of the figure-eight knot.
/// ```
/// use coface_answers::{Report, truncated};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let knot = coface_io::isosig::read(&b"cPcbbbiht"[..])?;
/// let report = Report::of(truncated(&knot)?)?;
/// assert_eq!(report.homology()[1].to_string(), "Z");
/// assert_eq!(report.skin().and_then(|skin| skin.name().map(str::to_owned)).as_deref(), Some("torus"));
/// # Ok(()) }
/// ```
pub fn truncated(model: &Model) -> Result<Model, Error> {
    let refused =
        |kind, message| Err(Error::new(kind, message).with_cure("convert the model without --truncate"));
    let Some(Structure::Gluings(table)) = model.structure() else {
        return refused(
            ErrorKind::UnsupportedFormat,
            "only gluing tables and isomorphism signatures have ideal vertices",
        );
    };
    let faces = table.faces()?;
    if table.ideal_vertices(&faces)?.is_empty() {
        return refused(
            ErrorKind::InvalidInput,
            "no vertex is ideal: the link of each is a sphere, or meets the boundary",
        );
    }
    Ok(Model::from_structure(Structure::Gluings(table.truncated(&faces)?)))
}
