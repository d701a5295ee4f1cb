//! Random meshes for the round trips of formats.

use super::CellData;
use super::numbers::Numbers;
use super::{Group, GroupKind, Model};
use coface_algebra::RaggedArray;
use coface_algebra::VertexId;
use coface_complexes::cell_mesh::CellShape;
use coface_geometry::Positions;
use proptest::collection::vec;
use proptest::prelude::*;
use std::collections::BTreeMap;

/// What a format can hold.
#[derive(Clone, Copy)]
pub(super) struct Limits {
    pub(super) dimension: usize,
    pub(super) largest_polygon: usize,
    pub(super) longest_line: usize,
    pub(super) points: bool,
    pub(super) groups: bool,
}

/// Meshes within these limits: polygons sorted by size, cells by shape; groups named by numbers, each element in at most
/// one.
pub(super) fn meshes(limits: Limits) -> impl Strategy<Value = Model> {
    let coordinate =
        prop_oneof![any::<f64>().prop_filter("finite", |x| x.is_finite()), (-9..9i8).prop_map(f64::from)];
    let shape = prop::sample::select(CellShape::ALL.to_vec());
    let order = Just((0..12u32).collect::<Vec<_>>()).prop_shuffle();
    (
        vec(coordinate, 12 * limits.dimension),
        vec((3..=limits.largest_polygon, order.clone()), 0..6),
        vec((2..=limits.longest_line, order.clone()), 0..4),
        vec((shape, order), 0..6),
        vec(0..12usize, if limits.points { 0..4 } else { 0..1 }),
        vec(0..3i64, 12 + 6 + 4 + 6),
    )
        .prop_map(move |(coordinates, mut polygons, lines, mut cells, points, references)| {
            polygons.sort_by_key(|&(size, _)| size);
            cells.sort_by_key(|&(shape, _)| shape);
            let mut groups: BTreeMap<(GroupKind, i64), Vec<u32>> = BTreeMap::new();
            let mut references = references.into_iter();
            for (kind, count) in [
                (GroupKind::Vertices, 12),
                (GroupKind::Lines, lines.len()),
                (GroupKind::Polygons, polygons.len()),
                (GroupKind::Cells, cells.len()),
            ] {
                for (member, reference) in (0..count as u32).zip(references.by_ref()) {
                    if limits.groups && reference > 0 {
                        groups.entry((kind, reference)).or_default().push(member);
                    }
                }
            }
            let model = Model {
                vertex_count: 12,
                positions: Positions::from_flat(limits.dimension, coordinates).unwrap(),
                polygons: RaggedArray::from_lists(polygons.iter().map(|(size, order)| &order[..*size])),
                lines: RaggedArray::from_lists(lines.iter().map(|(size, order)| &order[..*size])),
                shapes: cells.iter().map(|&(shape, _)| shape).collect(),
                cells: RaggedArray::from_lists(
                    cells.iter().map(|(shape, order)| &order[..shape.vertex_count()]),
                ),
                points: if limits.points {
                    points.into_iter().map(VertexId::new).collect()
                } else {
                    Vec::new()
                },
                groups: groups
                    .into_iter()
                    .map(|((kind, number), members)| Group::new(number.to_string(), kind, members))
                    .collect(),
                ..Model::default()
            };
            model.check().unwrap();
            model
        })
}

/// Numbers of any type: rows of one to three for so many things.
fn numbers(count: usize) -> impl Strategy<Value = (usize, Numbers)> {
    let real = prop_oneof![any::<f64>(), Just(f64::NAN), Just(f64::INFINITY), Just(-0.0)];
    (1..4usize, 0..5usize, vec(real, 3 * count), vec(any::<i32>(), 3 * count)).prop_map(
        move |(components, width, reals, integers)| {
            let size = components * count;
            let numbers = match width {
                0 => Numbers::UInt8(integers[..size].iter().map(|&x| x as u8).collect()),
                1 => Numbers::Int32(integers[..size].to_vec()),
                // PLY has no more.
                2 => Numbers::Int64(integers[..size].iter().map(|&x| i64::from(x as u32)).collect()),
                3 => Numbers::Float32(reals[..size].iter().map(|&x| x as f32).collect()),
                _ => Numbers::Float64(reals[..size].to_vec()),
            };
            (components, numbers)
        },
    )
}

/// The models with up to two arrays on each of these kinds, each of another name.
pub(super) fn with_data(
    models: impl Strategy<Value = Model>,
    kinds: &'static [GroupKind],
) -> impl Strategy<Value = Model> {
    models.prop_flat_map(move |model| {
        let arrays: Vec<_> = kinds.iter().map(|&kind| vec(numbers(model.count_of(kind)), 0..3)).collect();
        (Just(model), arrays).prop_map(move |(mut model, arrays)| {
            for (&kind, arrays) in kinds.iter().zip(arrays) {
                for (i, (components, numbers)) in arrays.into_iter().enumerate() {
                    // Nothing is said of nothing: formats do not write it.
                    if model.count_of(kind) > 0 {
                        let name = ["of", "value%20"][i].to_owned() + &kind.to_string();
                        model.data.push(CellData::of_file(name, kind, components, numbers));
                    }
                }
            }
            model.check().unwrap();
            model
        })
    })
}
