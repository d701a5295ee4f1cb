//! Guide 2: simplicial complexes, their neighborhoods, and verdicts with witnesses.
//!
//! Run with `cargo run -p coface --example 02_simplicial_complexes`.

use coface::complexes::simplicial::{Simplex, SimplicialComplex};
use coface::topology::homology;

fn main() -> Result<(), coface::Error> {
    // The Moebius band with five vertices: triangles i, i+1, i+2 modulo 5.
    let mut band = SimplicialComplex::from_facets([[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]])?;
    assert_eq!(band.f_vector(), [5, 10, 5]);

    // Star, closure and link of a vertex: the link is a path, since each vertex is on the boundary.
    let center = Simplex::from([2]);
    assert_eq!(band.star(&center)?.f_vector(), [1, 4, 3]);
    assert_eq!(band.link(&center)?.f_vector(), [4, 3]);

    // It is a manifold, but no orientation of its triangles agrees: the witness is an odd cycle of facets.
    assert_eq!(band.manifold_verdict()?.to_bool(), Some(true));
    let found = band.orientability()?;
    assert_eq!(found.is_orientable(), Some(false));
    assert_eq!(found.odd_cycle().map(|cycle| cycle.cells().len()), Some(5));

    // Erasing a triangle cuts the band open: what is left contracts to a point.
    let groups = |complex: &SimplicialComplex| -> Result<Vec<String>, coface::Error> {
        let homology = homology(&complex.chain_complex()?);
        Ok(homology.groups().iter().map(ToString::to_string).collect())
    };
    assert_eq!(groups(&band)?, ["Z", "Z", "0"]);
    band.erase(&Simplex::from([0, 1, 2]));
    band.erase(&Simplex::from([0, 2]));
    assert_eq!(band.f_vector(), [5, 9, 4]);

    // The suspension raises the degree of homology by one: that of a circle is a sphere.
    let circle = SimplicialComplex::from_facets([[0, 1], [1, 2], [2, 0]])?;
    let (sphere, _poles) = circle.suspension()?;
    assert_eq!(groups(&sphere)?, ["Z", "0", "Z"]);
    Ok(())
}
