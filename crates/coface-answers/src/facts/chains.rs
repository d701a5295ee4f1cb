//! The report on a chain complex without any more structure.

use super::report::{Answer, Report};
use coface_algebra::chains::ChainComplex;
use coface_io::cells_not_balls;
use coface_topology::homology;

/// The report on boundary matrices: what homology says. Their cells have no vertices, so a cell that stands in no
/// boundary may be a top cell of lower dimension or one that is glued to itself: the other questions stay open.
pub(crate) fn report(complex: &ChainComplex) -> Report {
    let groups = homology(complex).groups().to_vec();
    let counts = complex.f_vector();
    let dimension_count = complex.dimension().map_or(0, |dimension| dimension + 1);
    Report {
        f_vector: counts[..dimension_count].to_vec(),
        pure: None,
        components: groups.first().map_or(0, |group| group.betti()),
        euler_characteristic: complex.euler_characteristic(),
        manifold: Answer::Unknown,
        closed: None,
        homology: groups[..dimension_count].to_vec(),
        remarks: cells_not_balls(complex).into_iter().collect(),
        ..Report::of_nothing()
    }
}
