//! What a model draws as geometries of well-known text and binary, and the surfaces of its faces.

use crate::drawing::{Features, Shape, features_of_shapes, names_of, shapes};
use crate::{GroupKind, Model};
use coface_algebra::UnionFind;

/// What a model draws as the geometries of well-known text or binary: the shapes of each stand together.
///
/// In space, faces are one surface where they are connected or in one group; without groups all of them are. A surface that is read has vertices of its
/// own, so that faces with a vertex in common must not be of two.
pub(super) struct Geometries {
    pub(super) shapes: Vec<(Shape, Option<usize>)>,
    /// The shape behind the last of each geometry.
    ends: Vec<usize>,
}

impl Geometries {
    pub(super) fn of(model: &Model, dimension: usize) -> Self {
        let mut shapes = shapes(model);
        let features = Features::new(model);
        let surfaces = if dimension == 3 { surface_of_faces(model) } else { Vec::new() };
        let surface = |shape: &Shape| match shape {
            Shape::Face(face) => surfaces.get(*face).copied(),
            _ => None,
        };
        // Faces follow each other.
        let is_face = |(shape, _): &(Shape, Option<usize>)| matches!(shape, Shape::Face(_));
        let first = shapes.iter().position(is_face).unwrap_or(shapes.len());
        shapes[first..first + model.polygons.len()].sort_by_key(|(shape, _)| surface(shape));
        // What the file tells to be one feature stands together, in its order; the others come behind.
        let described = features_of_shapes(model, &shapes);
        let mut shapes: Vec<_> = shapes.into_iter().zip(described).collect();
        shapes.sort_by_key(|(_, feature)| feature.unwrap_or(usize::MAX));
        type Described = ((Shape, Option<usize>), Option<usize>);
        let are_one = |((a, group), own): &Described, ((b, other), feature): &Described| {
            if own.is_some() || feature.is_some() {
                return own == feature;
            }
            match (surface(a), surface(b)) {
                (Some(a), Some(b)) => a == b,
                _ => group == other && features.are_one(a, b),
            }
        };
        let mut ends: Vec<usize> = Vec::new();
        for geometry in shapes.chunk_by(are_one) {
            ends.push(ends.last().copied().unwrap_or(0) + geometry.len());
        }
        Self { shapes: shapes.into_iter().map(|(shape, _)| shape).collect(), ends }
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &[(Shape, Option<usize>)]> {
        let mut start = 0;
        self.ends.iter().map(move |&end| &self.shapes[std::mem::replace(&mut start, end)..end])
    }
}

/// The surface that each polygon of a mesh is of, numbered by their first ones: polygons with a vertex in common are of one, and those whose first
/// group is the same.
pub(super) fn surface_of_faces(model: &Model) -> Vec<u32> {
    let names = names_of(model, GroupKind::Polygons);
    let count = model.vertex_count;
    // Vertices, groups, and one more for what is in none.
    let mut partition = UnionFind::new(count + model.groups.len() + 1);
    for (polygon, name) in model.polygons.iter().zip(&names) {
        let group = (count + name.unwrap_or(model.groups.len())) as u32;
        polygon.iter().for_each(|&vertex| {
            partition.unite(group, vertex);
        });
    }
    let classes = partition.class_numbers();
    let mut number = vec![None; partition.class_count()];
    let mut next = 0;
    let surface = |polygon: &[u32]| {
        *number[classes[polygon[0] as usize] as usize].get_or_insert_with(|| {
            next += 1;
            next - 1
        })
    };
    model.polygons.iter().map(surface).collect()
}
