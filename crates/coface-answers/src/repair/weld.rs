//! Vertices that nearly coincide, merged.

use super::surface::merged_corners;
use crate::answer::{Remark, RemarkCode};
use crate::text;
use coface_algebra::{Error, ErrorKind, RaggedArray, VertexId};
use coface_arrange::congruence::{ClassRule, Representative, vertex_congruence};
use coface_geometry::Positions;
use coface_io::{Group, GroupKind, Model, ModelParts, Structure, placed};

/// What was done to merge vertices.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Weld {
    merged_count: usize,
    collapsed_count: usize,
    largest_movement: f64,
}

impl Weld {
    /// How many vertices became another one.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 1e-9\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 4 6 5\n";
    /// let model = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// assert_eq!(coface_answers::welded(&model, 1e-6)?.1.merged_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn merged_count(&self) -> usize {
        self.merged_count
    }

    /// How many polygons and lines had too few corners then, and were left out.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 1e-9\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 4 6 5\n";
    /// let model = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// assert_eq!(coface_answers::welded(&model, 1.0)?.1.collapsed_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn collapsed_count(&self) -> usize {
        self.collapsed_count
    }

    /// The longest way that a vertex went, in the unit of the positions: at most the radius.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0.125\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 4 6 5\n";
    /// let model = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// assert_eq!(coface_answers::welded(&model, 0.25)?.1.largest_movement(), 0.125);
    /// # Ok(()) }
    /// ```
    pub fn largest_movement(&self) -> f64 {
        self.largest_movement
    }

    /// What was merged, if anything moved.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0.125\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 4 6 5\n";
    /// let model = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let (_, done) = coface_answers::welded(&model, 0.25)?;
    /// let remark = done.remark().map(|remark| remark.message);
    /// assert_eq!(remark.as_deref(), Some("2 vertices merged with others, which moved them by at most 1.2e-1"));
    /// # Ok(()) }
    /// ```
    pub fn remark(&self) -> Option<Remark> {
        if self.merged_count == 0 {
            return None;
        }
        let mut message = format!("{} merged with others", text::count(self.merged_count, "vertex"));
        message += &match self.largest_movement {
            0.0 => ", in the same places".to_owned(),
            way => format!(", which moved them by at most {way:.1e}"),
        };
        if self.collapsed_count > 0 {
            let noun = if self.collapsed_count == 1 { "polygon or line" } else { "polygons and lines" };
            let count = text::grouped(self.collapsed_count);
            message += &format!("; {count} {noun} without enough corners then left out");
        }
        Some(Remark::new(RemarkCode::ModelRepaired, message).at(self.merged_count, []))
    }
}

/// The model with vertices merged that are at most `radius` apart, a length in the unit of the positions.
///
/// Vertices are gone through in the order of their coordinates, x first: each that is not merged yet takes all others that are
/// not merged yet within the radius of it. So no vertex moves farther than the radius, and the result does not depend on the
/// order of vertices in the file. A vertex stays where it is unless it is merged with another one.
///
/// Polygons lose repeated corners; those with fewer than three corners, and those that would pass a corner twice, are left out,
/// as are lines of one point. Groups and data follow. In drawings, and in models whose cells have properties, vertices move and
/// nothing is left out. A vertex with a coordinate that is not finite is merged with none.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] for a radius that is negative or not a number, or with which a 3-cell loses a vertex, naming the
/// cell; [`ErrorKind::UnsupportedFormat`] for structures such as chain complexes, whose cells are not lists of vertices.
///
/// # Complexity
/// $O(n \log n)$ for n vertices, where not many are within the radius of one.
///
/// # Examples
/// Two triangles on an edge that is written twice:
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 1e-9\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 4 6 5\n";
/// let model = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
/// let (welded, _) = coface_answers::welded(&model, 1e-6)?;
/// assert_eq!(welded.vertex_count(), 4);
/// assert_eq!(welded.polygons().list(1), [1, 3, 2]);
/// # Ok(()) }
/// ```
pub fn welded(model: &Model, radius: f64) -> Result<(Model, Weld), Error> {
    if model.is_empty() {
        return Ok((model.clone(), Weld::default()));
    }
    if model.structure().is_some() {
        return Err(refusal(model));
    }
    let class_of = classes_of(model, radius)?;
    let dimension = model.coordinate_count();
    let point = |vertex: u32| &model.coordinates()[vertex as usize * dimension..][..dimension];
    let mut done = Weld::default();
    for (vertex, &class) in (0u32..).zip(&class_of) {
        if vertex != class {
            done.merged_count += 1;
            let way = point(vertex).iter().zip(point(class)).map(|(x, y)| (x - y) * (x - y)).sum::<f64>();
            done.largest_movement = done.largest_movement.max(way.sqrt());
        }
    }
    if done.merged_count == 0 {
        return Ok((model.clone(), done));
    }
    if model.polygons().is_empty() && model.cells().is_empty() || !model.features().is_empty() {
        let flat = class_of.iter().flat_map(|&class| point(class)).copied().collect();
        return Ok((model.clone().with_coordinates(dimension, flat)?, done));
    }
    let reference = model.reference_system().cloned();
    let given = (dimension, model.coordinates());
    let (made, collapsed_count) = merged(model.clone().into_parts(), given, &class_of)?;
    done.collapsed_count = collapsed_count;
    Ok((made.with_reference_system(reference), done))
}

fn refusal(model: &Model) -> Error {
    let what = match model.structure() {
        Some(Structure::Chains(_)) => "a chain complex",
        Some(Structure::Facets(_)) => "a facet list",
        Some(Structure::Halfedges { .. }) => "halfedges",
        Some(Structure::Gluings(_)) => "a gluing table",
        Some(Structure::Volume(_)) => "a voxel volume",
        None => "the model",
    };
    Error::new(ErrorKind::UnsupportedFormat, format!("the vertices of {what} cannot be welded"))
        .with_cure("give a mesh or a drawing, without --weld for the others")
}

/// For each vertex the one that it is merged with: the first in the order of coordinates that is within the radius, and
/// that is merged with none itself.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] for a radius that is negative or not a number.
pub(crate) fn classes_of(model: &Model, radius: f64) -> Result<Vec<u32>, Error> {
    let count = model.vertex_count() as u32;
    let dimension = model.coordinate_count();
    let coordinates = model.coordinates();
    let mut class_of: Vec<u32> = (0..count).collect();
    let is_finite = |vertex: &u32| {
        let own = &coordinates[*vertex as usize * dimension..][..dimension];
        own.iter().all(|x| x.is_finite())
    };
    let vertices: Vec<u32> = match dimension {
        0 => Vec::new(),
        _ => (0..count).filter(is_finite).collect(),
    };
    let point = |vertex: u32| &coordinates[vertex as usize * dimension..][..dimension];
    for [vertex, class] in near_vertices(vertices, dimension, point, radius)? {
        class_of[vertex as usize] = class;
    }
    Ok(class_of)
}

/// Pairs of a vertex and the one that it is merged with, for those that are merged.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] for a radius that is negative or not a number.
pub(crate) fn near_vertices<'a>(
    mut vertices: Vec<u32>,
    dimension: usize,
    point: impl Fn(u32) -> &'a [f64],
    radius: f64,
) -> Result<Vec<[u32; 2]>, Error> {
    vertices.sort_by(|&a, &b| {
        let axes = point(a).iter().zip(point(b)).map(|(x, y)| (x + 0.0).total_cmp(&(y + 0.0)));
        axes.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then).then(a.cmp(&b))
    });
    let flat = vertices.iter().flat_map(|&vertex| point(vertex)).copied().collect();
    let positions = Positions::from_flat(dimension, flat)?;
    let classes = vertex_congruence(&positions, radius, ClassRule::Greedy, Representative::Lowest)?;
    let first = |class: u32| vertices[classes.members().list(class as usize)[0] as usize];
    let pairs = vertices.iter().zip(classes.class_of()).map(|(&vertex, &class)| [vertex, first(class)]);
    Ok(pairs.filter(|[vertex, class]| vertex != class).collect())
}

/// A mesh with classes for vertices, and how many polygons and lines it lost.
fn merged(
    parts: ModelParts,
    (dimension, given): (usize, &[f64]),
    class_of: &[u32],
) -> Result<(Model, usize), Error> {
    let kept: Vec<u32> =
        (0..).zip(class_of).filter(|(vertex, class)| vertex == *class).map(|(v, _)| v).collect();
    let mut number_of = vec![0; class_of.len()];
    (0u32..).zip(&kept).for_each(|(number, &vertex)| number_of[vertex as usize] = number);
    let number = |vertex: u32| number_of[class_of[vertex as usize] as usize];
    let renumbered =
        |corners: &[u32]| -> Vec<u32> { corners.iter().map(|&v| number_of[v as usize]).collect() };
    for (cell, corners) in parts.cells.iter().enumerate() {
        let mut own: Vec<u32> = corners.iter().map(|&vertex| class_of[vertex as usize]).collect();
        own.sort_unstable();
        if own.windows(2).any(|pair| pair[0] == pair[1]) {
            return Err(Error::invalid(format!("3-cell {cell} loses a vertex"))
                .with_cells([corners.to_vec()])
                .with_cure("give a shorter --weld"));
        }
    }
    let mut polygons: Vec<(usize, Vec<u32>)> = Vec::with_capacity(parts.polygons.len());
    for (place, polygon) in parts.polygons.iter().enumerate() {
        polygons.extend(merged_corners(polygon, class_of).map(|corners| (place, renumbered(&corners))));
    }
    let mut lines: Vec<(usize, Vec<u32>)> = Vec::with_capacity(parts.lines.len());
    for (place, line) in parts.lines.iter().enumerate() {
        let mut corners: Vec<u32> = line.iter().map(|&vertex| number(vertex)).collect();
        corners.dedup();
        if corners.len() > 1 {
            lines.push((place, corners));
        }
    }
    let collapsed = parts.polygons.len() + parts.lines.len() - polygons.len() - lines.len();
    let places_of = |kind: GroupKind| -> Vec<usize> {
        match kind {
            GroupKind::Vertices => kept.iter().map(|&vertex| vertex as usize).collect(),
            GroupKind::Polygons => polygons.iter().map(|(place, _)| *place).collect(),
            GroupKind::Lines => lines.iter().map(|(place, _)| *place).collect(),
            GroupKind::Cells => (0..parts.cells.len()).collect(),
        }
    };
    let group = |group: &Group| {
        let mut members: Vec<u32> = match group.kind() {
            GroupKind::Vertices => group.members().iter().map(|&member| number(member)).collect(),
            kind => {
                let places = places_of(kind);
                let found = |&member: &u32| places.binary_search(&(member as usize)).ok();
                group.members().iter().filter_map(found).map(|place| place as u32).collect()
            }
        };
        members.sort_unstable();
        members.dedup();
        group.with_members(members)
    };
    let coordinates = kept.iter().flat_map(|&vertex| &given[vertex as usize * dimension..][..dimension]);
    let (positions, partial_positions) = placed(dimension, coordinates.copied().collect())?;
    let mut points: Vec<VertexId> =
        parts.points.iter().map(|point| VertexId::from_u32(number(point.to_u32()))).collect();
    points.sort_unstable();
    points.dedup();
    let model = ModelParts {
        vertex_count: kept.len(),
        positions,
        partial_positions,
        polygons: RaggedArray::from_lists(polygons.iter().map(|(_, corners)| corners)),
        lines: RaggedArray::from_lists(lines.iter().map(|(_, corners)| corners)),
        cells: RaggedArray::from_lists(
            parts.cells.iter().map(|cell| cell.iter().map(|&vertex| number(vertex)).collect::<Vec<_>>()),
        ),
        points,
        groups: parts.groups.iter().map(group).collect(),
        data: parts.data.iter().map(|data| data.taken_from(places_of(data.kind()))).collect(),
        ..parts
    }
    .into_model();
    Ok((model, collapsed))
}
