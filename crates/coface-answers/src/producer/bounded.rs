//! Ideal triangulations as manifolds with boundary.

use coface_algebra::Error;
use coface_complexes::gluing::GluingTable;
use coface_io::{Remark, RemarkCode};

/// The table with its ideal vertices cut off, and a remark that says so; nothing where there are none.
///
/// # Errors
/// Those of [`GluingTable::truncated`].
pub(super) fn bounded(table: &GluingTable) -> Result<Option<(GluingTable, Remark)>, Error> {
    let faces = table.faces()?;
    let ideal = table.ideal_vertices(&faces)?;
    let Some(first) = ideal.first() else { return Ok(None) };
    let bounded = table.truncated(&faces)?;
    let (which, cut) = match ideal.len() {
        1 => (format!("vertex {} is ideal: its link is", first.index()), "it is"),
        count => (
            format!("{count} vertices are ideal, the first is {}: their links are", first.index()),
            "they are",
        ),
    };
    let message = format!(
        "{which} no sphere; the answer is about the manifold with boundary that is left when {cut} cut off, of {} tetrahedra, which \
         coface convert --truncate writes; --pseudomanifold takes ideal vertices as points",
        bounded.simplex_count()
    );
    Ok(Some((bounded, Remark::new(RemarkCode::IdealVerticesCut, message).at(ideal.len(), []))))
}
