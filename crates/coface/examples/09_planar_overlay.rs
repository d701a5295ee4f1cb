//! Guide 9: overlay of polygons in the plane: Booleans, areas as exact fractions, and where each vertex and edge comes from.
//!
//! Run with `cargo run -p coface --example 09_planar_overlay`.

use coface::algebra::RaggedArray;
use coface::arrange::boolean::{BooleanFormula, InsideRule};
use coface::arrange::planar::{PlanarArrangement, PlanarOverlay, PlanarRegions, VertexSource};
use coface::{EdgeId, Positions, VertexId};

fn main() -> Result<(), coface::Error> {
    // Two triangles on the base from (0, 0) to (2, 0), with the apexes (0, 1) and (2, 2). Their slanted sides y = 1 - x / 2 and y = x cross
    // at (2/3, 2/3), which no floating-point number can hold.
    let points = Positions::from_flat(2, vec![0.0, 0.0, 2.0, 0.0, 0.0, 1.0, 2.0, 2.0])?;
    let rings = RaggedArray::from_lists([[0, 1, 2], [0, 1, 3]]);
    let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    assert_eq!(overlay.f_vector(), [5, 7, 3]);

    // The areas are exact all the same: 1 and 2 for the triangles, 2/3 for what they share.
    let area = |text: &str| -> Result<String, coface::Error> {
        let formula = BooleanFormula::parse(text, &[])?;
        Ok(overlay.boolean(&formula, InsideRule::Nonzero)?.exact_area().to_string())
    };
    assert_eq!((area("a")?, area("b")?, area("a & b")?), ("1".into(), "2".into(), "2/3".into()));
    assert_eq!((area("a | b")?, area("a - b")?, area("b - a")?), ("7/3".into(), "1/3".into(), "4/3".into()));

    // Provenance: the vertices of the intersection are given points, but for the one where two sides cross.
    let both = overlay.boolean(&BooleanFormula::parse("a & b", &[])?, InsideRule::Nonzero)?;
    assert_eq!(both.f_vector(), [3, 3, 1]);
    let sources: Vec<VertexSource> = (0..3).map(|v| both.source(VertexId::new(v))).collect();
    assert!(sources.contains(&VertexSource::Given(0)) && sources.contains(&VertexSource::Given(1)));
    assert_eq!(sources.iter().filter(|source| matches!(source, VertexSource::Crossing(_))).count(), 1);
    // Sides are numbered ring by ring. The base is a side of both triangles, 0 and 3, and one edge of the result comes from both.
    let of_edges: Vec<Vec<usize>> =
        (0..3).map(|edge| both.sides_of_edge(EdgeId::new(edge)).collect()).collect();
    assert!(of_edges.contains(&vec![0, 3]));
    // Coordinates are rounded once, at the end; the crossing is not exactly where it is written.
    assert!(!both.is_exactly_rounded());

    // What is inside? A region whose boundary runs twice around the square in the middle: for the nonzero rule that is inside, for even-odd it is a
    // hole. The areas of the squares are 36 and 4.
    let corners = |low: f64, high: f64| vec![low, low, high, low, high, high, low, high];
    let squares = Positions::from_flat(2, [corners(0.0, 6.0), corners(2.0, 4.0)].concat())?;
    let twice = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    let region = PlanarOverlay::new(&squares, &twice, &[0, 0])?;
    let only = BooleanFormula::parse("a", &[])?;
    assert_eq!(region.boolean(&only, InsideRule::Nonzero)?.area(), 36.0);
    let odd = region.boolean(&only, InsideRule::Odd)?;
    assert_eq!((odd.area(), odd.hole_count()), (32.0, 1));

    // All faces with their winding numbers, for questions that no formula asks: how much is covered at least twice?
    let regions = PlanarRegions::new(&squares, &twice, &[0, 1])?;
    let areas = regions.arrangement().areas();
    let covered_twice = regions.faces_where(|winding| winding.len() >= 2);
    assert_eq!(covered_twice.iter().map(|face| areas[face.index()]).sum::<f64>(), 4.0);

    // Segments need no polygons: the two diagonals of a square cut it into four triangles, and their middle is a new vertex.
    let square = Positions::from_flat(2, corners(0.0, 1.0))?;
    let cut = PlanarArrangement::new(&square, &[[0, 1], [1, 2], [2, 3], [3, 0], [0, 2], [1, 3]])?;
    assert_eq!((cut.f_vector(), cut.areas()), (vec![5, 8, 4], vec![0.25; 4]));
    Ok(())
}
