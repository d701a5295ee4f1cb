//! Guide 10: persistence of a function, of points and of an image.
//!
//! Run with `cargo run -p coface --example 10_persistence`.

use coface::complexes::alpha::AlphaComplex;
use coface::complexes::filtered::Distances;
use coface::topology::{
    Filtration, ImageConstruction, ImageDiagram, ImageFiltration, RipsFiltration, persistence,
    persistent_cycles,
};
use coface::{Coefficients, Positions, SimplicialComplex};

fn main() -> Result<(), coface::Error> {
    let field = Coefficients::Modulo(2);

    // A function: heights along a path. Two valleys at 0 and 1 are separated by a pass at 3. Of two components that meet, the younger one dies.
    let path = SimplicialComplex::from_facets([[0, 1], [1, 2]])?.chain_complex()?;
    let heights = Filtration::lower_star(&path, &[0.0, 3.0, 1.0])?;
    let diagram = persistence(&path, &heights, field)?;
    let classes: Vec<_> =
        diagram.longer_than(0.0).pairs().iter().map(|pair| (pair.birth(), pair.death())).collect();
    assert_eq!(classes, [(0.0, None), (1.0, Some(3.0))]);

    // Two diagrams are as far apart as the farthest point must move. Half a unit more at the pass is a distance of one half.
    let higher = persistence(&path, &Filtration::lower_star(&path, &[0.0, 3.5, 1.0])?, field)?;
    assert_eq!(diagram.barcode(0).bottleneck_matching(&higher.barcode(0)).distance(), 0.5);

    // Points: balls around the corners of a rectangle of 6 by 8. Alpha values are squared radii: the loop closes at 4^2, when the long sides are
    // covered, and is filled at 5^2, half the diagonal.
    let corners = Positions::from_flat(2, vec![0.0, 0.0, 6.0, 0.0, 6.0, 8.0, 0.0, 8.0])?;
    let alpha = AlphaComplex::new(&corners, None)?;
    let complex = alpha.complex().chain_complex()?;
    let values = (0..=2).map(|degree| alpha.values(degree).to_vec()).collect();
    let filtration = Filtration::new(&complex, values)?;
    let diagram = persistence(&complex, &filtration, field)?;
    let holes = diagram.longer_than(0.0);
    let hole = &holes.pairs_of_degree(1)[0];
    assert_eq!((hole.birth(), hole.death()), (16.0, Some(25.0)));
    // The class has a cycle: all four sides, and the chain that it bounds when it dies, both triangles.
    let cycles = persistent_cycles(&complex, &filtration, &diagram, 1.0)?;
    let cycle = cycles.iter().find(|cycle| cycle.pair().degree() == 1).expect("there is one");
    assert_eq!(cycle.cycle().terms().len(), 4);
    assert_eq!(cycle.bounding_chain().map(|chain| chain.terms().len()), Some(2));

    // Distances alone, without positions: in the Vietoris-Rips complex the loop is born at the side 8 and dies at the diagonal 10.
    let distances = Distances::from_lower_triangle(4, vec![6.0, 10.0, 8.0, 8.0, 10.0, 6.0])?;
    let rips = RipsFiltration::new(&distances, None)?.persistence(1, field)?;
    let hole = &rips.pairs_of_degree(1)[0];
    assert_eq!((hole.birth(), hole.death()), (8.0, Some(10.0)));

    // An image: a dark ring of eight pixels around a bright one. The ring is there at 0, and its hole is filled at 5.
    let ring = [0.0, 0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 0.0];
    let diagram = ImageFiltration::new(&[3, 3], ring)?.persistence(field)?.longer_than(0.0);
    let hole = &diagram.pairs_of_degree(1)[0];
    assert_eq!((hole.birth(), hole.death(), hole.death_voxel()), (0.0, Some(5.0), Some(4)));

    // Do pixels that share a corner touch? As squares they do; as vertices of a grid they do not. Two dark pixels on a diagonal are one component,
    // or two that meet at 1.
    let diagonal = ImageFiltration::new(&[2, 2], [0.0, 1.0, 1.0, 0.0])?;
    let count = |diagram: ImageDiagram| diagram.longer_than(0.0).pairs_of_degree(0).len();
    let as_vertices = diagonal.clone().construction(ImageConstruction::Vertices);
    assert_eq!(count(diagonal.construction(ImageConstruction::TopCells).persistence(field)?), 1);
    assert_eq!(count(as_vertices.persistence(field)?), 2);
    Ok(())
}
