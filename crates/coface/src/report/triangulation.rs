//! Gluing tables as simplicial complexes.

use crate::algebra::RaggedArray;
use crate::io::{Model, Structure};
use crate::simplicial::Carrier;
use crate::{Error, ErrorKind};

/// A gluing table as a facet list: its first barycentric subdivision if that tells simplices apart by their vertices, else
/// its second. For each vertex of the result the face class (dimension and number) that it lies in the interior of.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] for models that are no gluing tables; [`ErrorKind::TooLarge`] beyond 32 bits.
///
/// # Examples
/// ```
/// use coface::io::{Model, Structure};
/// use coface::report::triangulated;
/// use coface::simplicial::GluingTable;
/// # fn main() -> Result<(), coface::Error> {
/// let table = GluingTable::from_isomorphism_signature("cMcabbgqw", 3)?;
/// let (model, carriers) = triangulated(&Model::from_structure(Structure::Gluings(table)))?;
/// let Some(Structure::Facets(facets)) = model.structure() else { panic!() };
/// // Two tetrahedra, subdivided twice: 2 times 24 times 24.
/// assert_eq!(facets.len(), 1152);
/// assert_eq!(carriers.iter().filter(|carrier| carrier.0 == 0).count(), 1, "the one vertex of the table");
/// # Ok(()) }
/// ```
pub fn triangulated(model: &Model) -> Result<(Model, Vec<Carrier>), Error> {
    let Some(Structure::Gluings(table)) = model.structure() else {
        return Err(Error::new(ErrorKind::UnsupportedFormat, "only gluing tables are subdivided")
            .with_cure("convert the model without --triangulate"));
    };
    let (complex, carriers) = table.faces()?.barycentric_subdivision()?.triangulation()?;
    let frozen = complex.freeze();
    let top = frozen.dimension().unwrap_or(0);
    let facets = (0..frozen.simplex_count(top)).map(|i| frozen.numbers(top, i));
    let carriers = carriers.iter().copied().collect();
    Ok((Model::from_structure(Structure::Facets(RaggedArray::from_lists(facets))), carriers))
}
