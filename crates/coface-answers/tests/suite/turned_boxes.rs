//! Turned boxes, and what chains of operations on them have in common.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::RaggedArray;
use coface_answers::{SceneArrangement, SpatialRequest};
use coface_geometry::Positions;
use coface_io::{self as io, Format, Model};
use proptest::prelude::*;
use std::ops::Range;

const SQUARES: [[u32; 4]; 6] =
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/// A box around a middle, turned around the third axis and then around the first, of squares or of triangles: faces of
/// all such boxes meet in lines along the first axis.
pub(crate) fn cuboid(middle: [f64; 3], half: [f64; 3], turns: [f64; 2], triangles: bool) -> Model {
    let mut flat = Vec::new();
    for corner in 0..8 {
        let [x, y, z] = [0, 1, 2].map(|axis| if corner >> axis & 1 == 0 { -half[axis] } else { half[axis] });
        let ((s, c), (t, d)) = (turns[0].sin_cos(), turns[1].sin_cos());
        let [x, y] = [c * x - s * y, s * x + c * y];
        let [y, z] = [d * y - t * z, t * y + d * z];
        flat.extend([x + middle[0], y + middle[1], z + middle[2]]);
    }
    // Turned squares are not quite flat.
    let lists: Vec<Vec<u32>> = match triangles {
        true => SQUARES.iter().flat_map(|&[a, b, c, d]| [vec![a, b, c], vec![a, c, d]]).collect(),
        false => SQUARES.iter().map(|square| square.to_vec()).collect(),
    };
    Model::from_polygons(Positions::from_flat(3, flat).unwrap(), RaggedArray::from_lists(lists)).unwrap()
}

pub(crate) fn arranged(models: &[&Model], request: &SpatialRequest) -> SceneArrangement {
    let names: Vec<String> = (0..models.len()).map(|i| format!("model {i}")).collect();
    SceneArrangement::of(names.iter().map(String::as_str).zip(models.iter().copied()), request).unwrap()
}

/// A model as a file of it is read.
pub(crate) fn through_file(model: &Model, format: Format) -> Model {
    let mut bytes = Vec::new();
    io::write(model, &mut bytes, format).unwrap();
    io::read(&bytes[..], format).unwrap()
}

/// The middle of a box, halves of its sides, and its turns.
pub(crate) type TurnedBox = ([f64; 3], [f64; 3], [f64; 2]);

/// Boxes of which most overlap, so many.
pub(crate) fn boxes(count: Range<usize>) -> impl Strategy<Value = Vec<TurnedBox>> {
    let middle = prop::array::uniform3(-1.0..1.0);
    prop::collection::vec((middle, prop::array::uniform3(0.3..0.9), prop::array::uniform2(0.0..6.3)), count)
}

/// Of the operations of a chain, unions are the most.
pub(crate) fn operation() -> impl Strategy<Value = char> {
    prop::sample::select(vec!['|', '-', '|', '^', '&'])
}
