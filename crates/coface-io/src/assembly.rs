//! A mesh as it is put together from typed elements.

use super::CellData;
use super::data::without_repeated_names;
use super::element_kind::Kind;
use super::group::Roles;
use super::lists::Lists;
use super::model::{Model, placed, repeated_vertex};
use super::oddities::{Oddities, Oddity, without_repetition, without_standing_still};
use super::scratch_mesh::ScratchMesh;
use super::{Group, GroupKind, GroupRole};
use crate::{Place, Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_complexes::cell_mesh::CellShape;
use std::collections::BTreeMap;
use std::sync::Arc;

/// A mesh that grows element by element. Groups have numbers, and names at the end.
#[derive(Debug, Default)]
pub(crate) struct Assembly {
    dimension: usize,
    coordinates: Vec<f64>,
    vertex_count: usize,
    points: Vec<VertexId>,
    lines: Lists,
    polygons: Lists,
    shapes: Vec<CellShape>,
    cells: Lists,
    groups: BTreeMap<(GroupKind, i64), Vec<u32>>,
    names: BTreeMap<(GroupKind, i64), String>,
    /// Names of groups whose kind the file does not say.
    names_of_numbers: BTreeMap<i64, String>,
    /// Whether a vertex is a corner of an element, once there are elements of higher order.
    is_corner: Vec<bool>,
    /// Whether a vertex lies inside an edge, face or cell of an element of higher order.
    is_inner: Vec<bool>,
    reduced_count: u64,
    data: Vec<CellData>,
    pub(crate) remarks: Vec<Remark>,
    /// Whether its groups are objects as well.
    pub(crate) has_objects: bool,
    pub(crate) oddities: Oddities,
    /// Where vertices and elements go instead of being kept.
    scratch: Option<ScratchMesh>,
}

impl Assembly {
    /// A mesh without anything, for points of so many coordinates.
    pub(crate) fn new(dimension: usize) -> Self {
        Self { dimension, ..Self::default() }
    }

    /// A mesh whose vertices and elements go to files, and whose groups are forgotten.
    pub(crate) fn streaming(dimension: usize, scratch: Option<ScratchMesh>) -> Self {
        Self { scratch, ..Self::new(dimension) }
    }

    /// The files that vertices and elements went to.
    pub(crate) fn into_scratch(self) -> Option<ScratchMesh> {
        self.scratch
    }

    pub(crate) fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// Adds a vertex; as many coordinates as the dimension, and they may be NaN or infinite.
    pub(crate) fn add_vertex(&mut self, coordinates: &[f64]) -> Result<(), Error> {
        self.add_vertex_on_line(coordinates, None)
    }

    /// Adds a vertex that stands on this line of a text.
    pub(crate) fn add_vertex_on_line(&mut self, coordinates: &[f64], line: Option<u64>) -> Result<(), Error> {
        if self.vertex_count == u32::MAX as usize {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^32 - 1 vertices"));
        }
        self.oddities.note_unplaced(coordinates, self.vertex_count as u64, line);
        self.vertex_count += 1;
        if let Some(scratch) = &mut self.scratch {
            return scratch.add_vertex(coordinates);
        }
        self.coordinates.extend_from_slice(coordinates);
        Ok(())
    }

    /// Adds an element with the given corners; what more `vertices` has lies inside its edges, faces or itself. Gives
    /// the member for a group: its position among the elements of its kind, or the vertex of a point; `None` if it repeats
    /// so many vertices that nothing is left of it.
    ///
    /// `number` is how the file numbers a vertex, for an error.
    pub(crate) fn add(
        &mut self,
        kind: Kind,
        corner_count: usize,
        vertices: &[u32],
        number: impl Fn(u32) -> u64,
    ) -> Result<Option<u32>, Error> {
        let name = || kind.name(corner_count);
        if let Some(&vertex) = vertices.iter().find(|&&vertex| vertex as usize >= self.vertex_count) {
            return Err(Error::invalid(format!(
                "a {} names vertex {}, but there are {} vertices, numbered from {}",
                name(),
                number(vertex),
                self.vertex_count,
                number(0)
            ))
            .with_cure("the file is damaged, or was written wrongly: write it again"));
        }
        let corners = &vertices[..corner_count];
        let repeated = match kind {
            Kind::Line => corners.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0]),
            _ => repeated_vertex(corners),
        };
        let Some(vertex) = repeated else {
            return self.add_sound(kind, corners, &vertices[corner_count..]).map(Some);
        };
        let distinct = match kind {
            Kind::Line => without_standing_still(corners),
            _ => without_repetition(corners),
        };
        let place = || Place::cell(corners);
        let (kind, corners) = match kind {
            Kind::Point | Kind::Line if distinct.len() > 1 => (kind, distinct.as_slice()),
            Kind::Polygon if distinct.len() > 2 => (kind, distinct.as_slice()),
            Kind::Cell(shape) if distinct.len() > 3 => {
                let Some((simpler, corners)) = simpler_cell(shape, corners) else {
                    return Err(Error::invalid(format!("a {} repeats vertex {}", name(), number(vertex)))
                        .with_cure(format!("remove the {}, or the repeated vertex", name())));
                };
                self.oddities.note(Oddity::CellIsSimpler, place);
                return self.add_sound(Kind::Cell(simpler), &corners, &[]).map(Some);
            }
            _ => {
                self.oddities.note(Oddity::Collapsed, place);
                return Ok(None);
            }
        };
        self.oddities.note(Oddity::Repeated, place);
        self.add_sound(kind, corners, &vertices[corner_count..]).map(Some)
    }

    /// Adds an element that repeats no corner; more vertices lie inside.
    fn add_sound(&mut self, kind: Kind, corners: &[u32], inner: &[u32]) -> Result<u32, Error> {
        if let Some(scratch) = &mut self.scratch {
            return scratch.add(kind, corners, corners.len() + inner.len()).map(|()| 0);
        }
        if !inner.is_empty() {
            self.reduced_count += 1;
            self.is_inner.resize(self.vertex_count, false);
            for &vertex in inner {
                self.is_inner[vertex as usize] = true;
            }
        }
        let position = match kind {
            Kind::Point => {
                self.points.push(VertexId::from_u32(corners[0]));
                return Ok(corners[0]);
            }
            Kind::Line => {
                self.lines.push(corners);
                self.lines.len() - 1
            }
            Kind::Polygon => {
                self.polygons.push(corners);
                self.polygons.len() - 1
            }
            Kind::Cell(shape) => {
                self.shapes.push(shape);
                self.cells.push(corners);
                self.cells.len() - 1
            }
        };
        u32::try_from(position).map_err(|_| {
            Error::new(
                ErrorKind::TooLarge,
                format!("more than 2^32 - 1 elements like a {}", kind.name(corners.len())),
            )
        })
    }

    /// The number of elements of a kind, or of vertices.
    pub(crate) fn count_of(&self, kind: GroupKind) -> usize {
        match kind {
            GroupKind::Vertices => self.vertex_count,
            GroupKind::Lines => self.lines.len(),
            GroupKind::Polygons => self.polygons.len(),
            GroupKind::Cells => self.cells.len(),
        }
    }

    /// Adds numbers on all vertices or elements of a kind as they are now.
    /// Where a vertex of three coordinates is.
    pub(crate) fn position(&self, vertex: u32) -> [f64; 3] {
        let at = 3 * vertex as usize;
        [self.coordinates[at], self.coordinates[at + 1], self.coordinates[at + 2]]
    }

    pub(crate) fn add_data(&mut self, data: CellData) {
        self.data.push(data);
    }

    /// Puts a vertex or an element into the group of this number.
    pub(crate) fn add_to_group(&mut self, kind: GroupKind, number: i64, member: u32) {
        if self.scratch.is_some() {
            return;
        }
        self.groups.entry((kind, number)).or_default().push(member);
    }

    /// The members of the group of this number.
    pub(crate) fn group_members(&self, kind: GroupKind, number: i64) -> &[u32] {
        self.groups.get(&(kind, number)).map_or(&[], Vec::as_slice)
    }

    /// Names a group, whether it has members or not.
    pub(crate) fn name_group(&mut self, kind: GroupKind, number: i64, name: String) {
        self.names.insert((kind, number), name);
        self.groups.entry((kind, number)).or_default();
    }

    /// The name of the groups of this number, of whatever kind they are.
    pub(crate) fn name_groups(&mut self, number: i64, name: String) {
        self.names_of_numbers.insert(number, name);
    }

    /// The mesh. Vertices that only lie inside elements of higher order are left out.
    pub(crate) fn finish(mut self) -> Result<Model, Error> {
        let oddities = std::mem::take(&mut self.oddities);
        self.remarks.extend(oddities.remarks());
        for key in self.groups.keys() {
            if let Some(name) = self.names_of_numbers.get(&key.1) {
                self.names.entry(*key).or_insert_with(|| name.clone());
            }
        }
        let renumbered = if self.reduced_count > 0 { self.drop_inner_vertices() } else { None };
        let (positions, partial_positions) = placed(self.dimension, self.coordinates)?;
        let mut model = Model {
            vertex_count: self.vertex_count,
            positions,
            partial_positions,
            polygons: self.polygons.into_ragged()?,
            shapes: self.shapes,
            cells: self.cells.into_ragged()?,
            lines: self.lines.into_ragged()?,
            points: self.points,
            remarks: self.remarks,
            oddities: renumbered.is_none().then(|| Arc::new(oddities)),
            ..Model::default()
        };
        if let Some(renumbered) = &renumbered {
            for data in self.data.iter_mut().filter(|data| data.kind() == GroupKind::Vertices) {
                *data = data.taken_from((0..renumbered.len()).filter(|&v| renumbered[v].is_some()));
            }
        }
        model.data = without_repeated_names(self.data, &mut model.remarks);
        for ((kind, number), mut members) in self.groups {
            if let (GroupKind::Vertices, Some(renumbered)) = (kind, &renumbered) {
                members = members.into_iter().filter_map(|v| renumbered[v as usize]).collect();
            }
            let name = self.names.remove(&(kind, number)).unwrap_or_else(|| number.to_string());
            let mut group = Group::new(name, kind, members);
            group.number = i32::try_from(number).ok();
            if self.has_objects {
                group.roles = group.roles.with(Roles::of(GroupRole::Object));
            }
            model.groups.push(group);
        }
        if let Some(renumbered) = renumbered {
            let new = |v: u32| renumbered[v as usize].expect("a corner is kept");
            for lists in [&mut model.polygons, &mut model.cells, &mut model.lines] {
                for vertex in lists.items_mut() {
                    *vertex = new(*vertex);
                }
            }
            for point in &mut model.points {
                *point = VertexId::from_u32(new(point.to_u32()));
            }
        }
        Ok(model)
    }

    /// Leaves the vertices out that are no corner and lie inside an element, and gives the new numbers of the others.
    fn drop_inner_vertices(&mut self) -> Option<Vec<Option<u32>>> {
        self.is_inner.resize(self.vertex_count, false);
        self.is_corner.resize(self.vertex_count, false);
        for lists in [&mut self.polygons, &mut self.cells, &mut self.lines] {
            for &vertex in lists.items_mut().iter() {
                self.is_corner[vertex as usize] = true;
            }
        }
        for point in &self.points {
            self.is_corner[point.index()] = true;
        }
        let mut kept = 0;
        let renumbered: Vec<Option<u32>> = (0..self.vertex_count)
            .map(|v| {
                let keep = self.is_corner[v] || !self.is_inner[v];
                kept += u32::from(keep);
                keep.then(|| kept - 1)
            })
            .collect();
        let dimension = self.dimension;
        for (old, new) in renumbered.iter().enumerate() {
            if let Some(new) = new {
                let new = *new as usize * dimension;
                self.coordinates.copy_within(old * dimension..(old + 1) * dimension, new);
            }
        }
        self.coordinates.truncate(kept as usize * dimension);
        self.remarks.push(Remark::new(RemarkCode::HigherOrder, format!(
            "{} elements of higher order were read by their corners; {} vertices inside their edges, faces and cells were left out",
            self.reduced_count,
            self.vertex_count - kept as usize
        )));
        self.vertex_count = kept as usize;
        Some(renumbered)
    }
}

/// The cell of another shape that a cell is whose edges or faces have collapsed: the one with the faces that are left.
fn simpler_cell(shape: CellShape, corners: &[u32]) -> Option<(CellShape, Vec<u32>)> {
    let collapsed = |face: &&[usize]| -> Vec<u32> {
        let mut face: Vec<u32> = face.iter().map(|&corner| corners[corner]).collect();
        face.dedup();
        while face.len() > 1 && face.first() == face.last() {
            face.pop();
        }
        face
    };
    let faces: Vec<Vec<u32>> = shape.faces().iter().map(collapsed).filter(|face| face.len() > 2).collect();
    if faces.iter().any(|face| repeated_vertex(face).is_some()) {
        return None;
    }
    let distinct = without_repetition(corners);
    [CellShape::Tetrahedron, CellShape::Pyramid, CellShape::Wedge].into_iter().find_map(|simpler| {
        if simpler.vertex_count() != distinct.len() || simpler.faces().len() != faces.len() {
            return None;
        }
        let first = simpler.faces()[0];
        let bases = faces.iter().filter(|face| face.len() == first.len());
        let turned = bases.flat_map(|face| (0..face.len()).map(move |turn| (face, turn)));
        turned.into_iter().find_map(|(face, turn)| {
            let mut cell: Vec<Option<u32>> = vec![None; simpler.vertex_count()];
            for (i, &corner) in first.iter().enumerate() {
                cell[corner] = Some(face[(i + turn) % face.len()]);
            }
            // Each other corner has the one neighbor that the faces give it.
            let others: Vec<u32> = distinct.iter().copied().filter(|vertex| !face.contains(vertex)).collect();
            let open: Vec<usize> = (0..cell.len()).filter(|&corner| cell[corner].is_none()).collect();
            orders(&others).into_iter().find_map(|order| {
                let mut cell = cell.clone();
                for (&corner, &vertex) in open.iter().zip(&order) {
                    cell[corner] = Some(vertex);
                }
                let cell: Vec<u32> = cell.into_iter().collect::<Option<_>>()?;
                let has = |wanted: &[usize]| {
                    let wanted: Vec<u32> = wanted.iter().map(|&corner| cell[corner]).collect();
                    faces.iter().any(|face| is_turned(face, &wanted))
                };
                simpler.faces().iter().all(|face| has(face)).then_some((simpler, cell))
            })
        })
    })
}

/// Whether two cycles of vertices are one, turned.
fn is_turned(one: &[u32], other: &[u32]) -> bool {
    one.len() == other.len()
        && (0..one.len()).any(|turn| (0..one.len()).all(|i| one[(i + turn) % one.len()] == other[i]))
}

/// All orders of at most three vertices.
fn orders(vertices: &[u32]) -> Vec<Vec<u32>> {
    if vertices.len() < 2 || vertices.len() > 3 {
        return vec![vertices.to_vec()];
    }
    let mut all = Vec::new();
    for i in 0..vertices.len() {
        let mut rest = vertices.to_vec();
        let first = rest.remove(i);
        for tail in orders(&rest) {
            all.push(std::iter::once(first).chain(tail).collect());
        }
    }
    all
}

/// A number for each group, distinct among groups of one kind: the name if it is a number, otherwise the lowest that is
/// free.
pub(crate) fn group_numbers(groups: &[Group]) -> Vec<i32> {
    let mut taken: BTreeMap<GroupKind, Vec<i32>> = BTreeMap::new();
    let mut numbers = vec![0; groups.len()];
    // Its own number comes before that of its name.
    for own in [Group::number, number_of_name] {
        for (group, number) in groups.iter().zip(&mut numbers).filter(|(_, number)| **number == 0) {
            let taken = taken.entry(group.kind()).or_default();
            if let Some(value) = own(group).filter(|&value| value > 0 && !taken.contains(&value)) {
                taken.push(value);
                *number = value;
            }
        }
    }
    for taken in taken.values_mut() {
        taken.sort_unstable();
    }
    let mut next: BTreeMap<GroupKind, i32> = BTreeMap::new();
    for (group, number) in groups.iter().zip(&mut numbers) {
        if *number == 0 {
            let next = next.entry(group.kind()).or_default();
            let taken = &taken[&group.kind()];
            *next += 1;
            while taken.binary_search(next).is_ok() {
                *next += 1;
            }
            *number = *next;
        }
    }
    numbers
}

/// The number that the name of a group is.
fn number_of_name(group: &Group) -> Option<i32> {
    group.name().parse().ok().filter(|value: &i32| value.to_string() == group.name())
}

/// For each of `count` members of this kind the number of the first group that it is in; 0 for none.
pub(crate) fn first_numbers(groups: &[Group], numbers: &[i32], kind: GroupKind, count: usize) -> Vec<i32> {
    let mut first = vec![0; count];
    for (group, &number) in groups.iter().zip(numbers).filter(|(group, _)| group.kind() == kind) {
        for &member in group.members() {
            if let Some(first) = first.get_mut(member as usize)
                && *first == 0
            {
                *first = number;
            }
        }
    }
    first
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inner_vertices_are_left_out_and_the_rest_renumbered() {
        let mut assembly = Assembly::new(1);
        for x in 0..7 {
            assembly.add_vertex(&[f64::from(x)]).unwrap();
        }
        let number = |v| u64::from(v) + 1;
        // Corners 6 4 2 with 5 3 1 between them; vertex 0 is isolated, 3 is a point of its own.
        assembly.add(Kind::Polygon, 3, &[6, 4, 2, 5, 3, 1], number).unwrap();
        assert_eq!(assembly.add(Kind::Point, 1, &[3], number).unwrap(), Some(3));
        for vertex in [3, 5] {
            assembly.add_to_group(GroupKind::Vertices, 9, vertex);
        }
        let model = assembly.finish().unwrap();
        assert_eq!(model.positions.as_flat(), [0.0, 2.0, 3.0, 4.0, 6.0]);
        assert_eq!(model.polygons.list(0), [4, 3, 1]);
        assert_eq!(model.points, [VertexId::new(2)]);
        assert_eq!(model.groups, [Group::new("9", GroupKind::Vertices, vec![2])]);
        assert!(
            model.remarks[0].message.starts_with("1 elements of higher order")
                && model.remarks[0].message.contains("2 vertices")
        );
        model.check().unwrap();
    }

    #[test]
    fn faults_name_the_vertex_as_the_file_does() {
        let mut assembly = Assembly::new(0);
        assembly.add_vertex(&[]).unwrap();
        assembly.add_vertex(&[]).unwrap();
        let mut fault = |kind, vertices: &[u32]| {
            assembly.add(kind, vertices.len(), vertices, |v| u64::from(v) + 1).unwrap_err().to_string()
        };
        assert!(
            fault(Kind::Polygon, &[0, 1, 2])
                .contains("a triangle names vertex 3, but there are 2 vertices, numbered from 1")
        );
    }

    #[test]
    fn elements_that_repeat_a_vertex_are_what_is_left_of_them() {
        let mut assembly = Assembly::new(3);
        for v in 0..8usize {
            // The cube of side 1, in the order of a hexahedron.
            let [x, y, z] = [[0u8, 1, 1, 0][v % 4], (v % 4 / 2) as u8, (v / 4) as u8];
            assembly.add_vertex(&[x, y, z].map(f64::from)).unwrap();
        }
        let number = |v| u64::from(v);
        let mut add = |kind, vertices: &[u32]| assembly.add(kind, vertices.len(), vertices, number).unwrap();
        assert_eq!(add(Kind::Line, &[1, 1]), None);
        assert_eq!(add(Kind::Line, &[1, 1, 2]), Some(0));
        assert_eq!(add(Kind::Polygon, &[0, 1, 1]), None);
        assert_eq!(add(Kind::Polygon, &[0, 1, 1, 2]), Some(0));
        assert_eq!(add(Kind::TETRAHEDRON, &[0, 1, 1, 4]), None);
        // A hexahedron with a collapsed edge pair is a wedge, one with a collapsed face a pyramid.
        assert_eq!(add(Kind::HEXAHEDRON, &[0, 1, 2, 2, 4, 5, 6, 6]), Some(0));
        assert_eq!(add(Kind::HEXAHEDRON, &[0, 1, 2, 3, 4, 4, 4, 4]), Some(1));
        assert_eq!(add(Kind::WEDGE, &[0, 1, 2, 5, 5, 5]), Some(2));
        let model = assembly.finish().unwrap();
        model.check().unwrap();
        assert_eq!(model.shapes, [CellShape::Wedge, CellShape::Pyramid, CellShape::Tetrahedron]);
        let volumes =
            coface_complexes::cell_mesh::cell_volumes(&model.positions, &model.shapes, &model.cells);
        assert!((volumes.unwrap().signed() - (0.5 + 1.0 / 3.0 + 1.0 / 6.0)).abs() < 1e-15);
        let codes: Vec<_> = model.remarks.iter().map(|remark| (remark.code, remark.count)).collect();
        let collapsed = RemarkCode::CollapsedCell;
        assert_eq!(codes, [(RemarkCode::RepeatedVertex, 2), (collapsed, 3), (collapsed, 3)]);
    }

    #[test]
    fn group_numbers_are_distinct_and_keep_numeric_names() {
        let group = |name: &str, kind| Group::new(name, kind, vec![0, 2]);
        let groups = [
            group("a", GroupKind::Lines),
            group("1", GroupKind::Lines),
            group("1", GroupKind::Cells),
            group("02", GroupKind::Lines),
            group("-3", GroupKind::Cells),
        ];
        let numbers = group_numbers(&groups);
        assert_eq!(numbers, [2, 1, 1, 3, 2]);
        assert_eq!(first_numbers(&groups, &numbers, GroupKind::Lines, 3), [2, 0, 2]);
        let tagged = groups.map(|group| if group.name() == "a" { group.with_number(1) } else { group });
        assert_eq!(group_numbers(&tagged), [1, 2, 1, 3, 2], "its own number comes first");
    }
}
