//! A model as objects of triangles, each by itself: what 3MF and AMF hold.

use crate::limits::{require_dimension, require_mesh};
use crate::triangles::{Triangles, triangulated_remark};
use crate::{Format, GroupKind, GroupRole, Model, Remark, RemarkCode};
use coface_algebra::{Error, UnionFind};
use std::collections::BTreeMap;

/// Triangles that are an object.
pub(crate) struct PrintObject {
    /// The group that it is, without a name if it is none.
    pub(crate) name: String,
    /// The numbers of its vertices in the model, in their order.
    pub(crate) vertices: Vec<u32>,
    /// The triangles by the places of their corners among its vertices.
    pub(crate) triangles: Vec<[u32; 3]>,
}

impl PrintObject {
    /// Whether each side of a triangle is the side of exactly one other, which runs along it the other way.
    pub(crate) fn is_closed(&self) -> bool {
        let around = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]];
        let mut sides: Vec<[u32; 2]> = self.triangles.iter().flat_map(around).collect();
        sides.sort_unstable();
        let is_once = sides.windows(2).all(|pair| pair[0] != pair[1]);
        is_once && sides.iter().all(|&[a, b]| sides.binary_search(&[b, a]).is_ok())
    }
}

/// A model as objects.
pub(crate) struct PrintObjects {
    pub(crate) objects: Vec<PrintObject>,
    /// How many groups are no object.
    lost_groups: usize,
    /// How many triangles have a corner twice, and are left out.
    degenerate: usize,
    /// How many vertices are in no triangle, and are left out.
    loose: usize,
}

impl PrintObjects {
    /// The objects of a model that a format of this title is to hold: what is connected by vertices stays together. Parts that
    /// lie whole in a group of polygons are an object of its name, and all others are one object without a name.
    ///
    /// # Errors
    /// [`UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) for what is no surface of triangles and polygons in space or the plane;
    /// [`InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for coordinates that are not finite.
    pub(crate) fn of(model: &Model, title: &str) -> Result<Self, Error> {
        require_mesh(model, title, "MEDIT, MSH or VTK")?;
        require_dimension(model, title, 3)?;
        model.require_finite()?;
        let triangles = Triangles::of(model, title)?;
        let parts = Parts::of(model);
        let (labels, lost_groups) = labels(model, &parts);
        let mut objects: Vec<(PrintObject, Vec<[u32; 3]>)> = Vec::new();
        let mut places: BTreeMap<Option<usize>, usize> = BTreeMap::new();
        let mut degenerate = 0;
        for (i, corners) in triangles.iter().enumerate() {
            let corners = [corners[0], corners[1], corners[2]];
            if corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0] {
                degenerate += 1;
                continue;
            }
            let label = labels[parts.of_polygon[triangles.polygon(i)]];
            let place = *places.entry(label).or_insert_with(|| {
                let name = label.map_or_else(String::new, |group| model.groups[group].name().to_owned());
                objects.push((PrintObject { name, vertices: Vec::new(), triangles: Vec::new() }, Vec::new()));
                objects.len() - 1
            });
            objects[place].1.push(corners);
        }
        let mut used = 0;
        let objects: Vec<PrintObject> = objects
            .into_iter()
            .map(|(mut object, triangles)| {
                object.vertices = triangles.as_flattened().to_vec();
                object.vertices.sort_unstable();
                object.vertices.dedup();
                used += object.vertices.len();
                let own = |vertex| object.vertices.partition_point(|&other| other < vertex) as u32;
                object.triangles = triangles.iter().map(|corners| corners.map(own)).collect();
                object
            })
            .collect();
        // No vertex is in two objects.
        Ok(Self { objects, lost_groups, degenerate, loose: model.vertex_count - used })
    }
}

/// The parts that are connected by vertices.
struct Parts {
    of_polygon: Vec<usize>,
    /// How many polygons each has.
    sizes: Vec<usize>,
}

impl Parts {
    fn of(model: &Model) -> Self {
        let mut vertices = UnionFind::new(model.vertex_count);
        for polygon in model.polygons.iter() {
            polygon.windows(2).for_each(|pair| {
                vertices.unite(pair[0], pair[1]);
            });
        }
        let mut part_of_class = vec![None; vertices.class_count()];
        let classes = vertices.class_numbers();
        let mut parts = Self { of_polygon: Vec::with_capacity(model.polygons.len()), sizes: Vec::new() };
        for polygon in model.polygons.iter() {
            let part = *part_of_class[classes[polygon[0] as usize] as usize].get_or_insert(parts.sizes.len());
            if part == parts.sizes.len() {
                parts.sizes.push(0);
            }
            parts.sizes[part] += 1;
            parts.of_polygon.push(part);
        }
        parts
    }
}

/// The group whose object each part is in, objects before other groups; and how many groups are no object as a whole.
fn labels(model: &Model, parts: &Parts) -> (Vec<Option<usize>>, usize) {
    let mut labels = vec![None; parts.sizes.len()];
    let mut order: Vec<usize> = (0..model.groups.len()).collect();
    order.sort_by_key(|&group| !model.groups[group].has_role(GroupRole::Object));
    let mut lost = 0;
    for index in order {
        let group = &model.groups[index];
        let mut taken = 0;
        if group.kind() == GroupKind::Polygons {
            let mut counts: BTreeMap<usize, usize> = BTreeMap::new();
            for &polygon in group.members() {
                *counts.entry(parts.of_polygon[polygon as usize]).or_default() += 1;
            }
            for (part, count) in counts {
                if count == parts.sizes[part] && labels[part].is_none() {
                    labels[part] = Some(index);
                    taken += count;
                }
            }
        }
        lost += usize::from(taken < group.members().len() || taken == 0);
    }
    (labels, lost)
}

/// What a file of objects of triangles does not keep of a model.
pub(crate) fn losses(model: &Model, format: Format) -> Vec<Remark> {
    let Ok(objects) = PrintObjects::of(model, format.title()) else { return Vec::new() };
    let mut remarks = Vec::from_iter(triangulated_remark(model));
    let mut add = |count: usize, one: &str, several: &str| {
        if count > 0 {
            let message = if count == 1 { one.to_owned() } else { format!("{count} {several}") };
            remarks.push(Remark::new(RemarkCode::FormatKeepsLess, message).at(count, []));
        }
    };
    add(
        objects.lost_groups,
        "1 group is no object by itself: its name is left out",
        "groups are no objects by themselves: their names are left out",
    );
    add(
        objects.degenerate,
        "1 triangle has a corner twice and is left out",
        "triangles have a corner twice and are left out",
    );
    add(
        objects.loose,
        "1 vertex is in no triangle and is left out",
        "vertices are in no triangle and are left out",
    );
    remarks
}

/// The position of a vertex, filled up with zeros to three coordinates.
pub(crate) fn point(model: &Model, vertex: u32) -> [f64; 3] {
    let dimension = model.coordinate_count();
    let at = vertex as usize * dimension;
    std::array::from_fn(|axis| if axis < dimension { model.coordinates()[at + axis] } else { 0.0 })
}

/// The color of a vertex, where the vertices of a model have colors.
pub(crate) fn color(model: &Model, vertex: u32) -> Option<[u8; 3]> {
    let parts = model.vertex_colors()?;
    Some(parts.map(|part| part.numbers().real(vertex as usize) as u8))
}

/// Text that can stand in XML; control characters, which XML forbids, become blanks.
pub(crate) fn escaped(text: &str) -> String {
    let text: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
