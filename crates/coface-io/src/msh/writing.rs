//! Writing, as text.

use super::elements::ElementType;
use crate::assembly::group_numbers;
use crate::decimal::{flush, push_f64, push_natural};
use crate::element_kind::Kind;
use crate::{CellData, Group, GroupKind, Model, limits};
use coface_algebra::Error;
use coface_algebra::ErrorKind;
use std::collections::BTreeMap;
use std::io::Write;

/// A version of the format to write.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Version {
    /// Version 2.2: an element has at most one physical group.
    TwoTwo,
    /// Version 4.1: an element has any number of physical groups, by the entity that it lies on.
    #[default]
    FourOne,
}

/// The tags of the physical groups that [`write()`] gives the groups of a model, in their order: a group keeps its
/// [number](Group::number), or the number that its name is; the others get tags that are free among groups of their kind.
///
/// # Examples
/// ```
/// use coface_io::msh;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 70 \"rim\"\n$EndPhysicalNames\n\
///     $Nodes\n2\n1 0 0 0\n2 1 0 0\n$EndNodes\n$Elements\n1\n1 1 2 70 1 1 2\n$EndElements\n";
/// assert_eq!(msh::physical_tags(&msh::read(text.as_bytes())?), [70]);
/// # Ok(()) }
/// ```
pub fn physical_tags(model: &Model) -> Vec<i32> {
    group_numbers(&model.groups)
}

/// Writes a Gmsh mesh as text: polylines become lines of two nodes, vertices of groups become points. Groups become physical groups with
/// the tags of [`physical_tags`]. In version 2.2 an element in several groups stays in the first one. Data follow as sections `$NodeData` and
/// `$ElementData`; rows of NaN are left out.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] for a polygon of more than four vertices, an abstract structure, and vertices without
/// positions or of more than three coordinates; [`ErrorKind::Io`] from the output.
///
/// # Examples
/// ```
/// use coface_io::{medit, msh};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = "MeshVersionFormatted 2 Dimension 3 Vertices 3 0 0 0 0 1 0 0 0 0 1 0 0 Triangles 1 1 2 3 8";
/// let model = medit::read(text.as_bytes())?;
/// let mut out = Vec::new();
/// msh::write(&model, &mut out, msh::Version::TwoTwo)?;
/// assert!(out.ends_with(b"$Elements\n1\n1 2 2 8 2 1 2 3\n$EndElements\n"));
/// assert_eq!(msh::read(&out[..])?, model);
/// # Ok(()) }
/// ```
pub fn write(model: &Model, mut out: impl Write, version: Version) -> Result<(), Error> {
    limits::require_volume_mesh(model, "MSH")?;
    limits::require_dimension(model, "MSH", 3)?;
    limits::require_small_polygons(model, "MSH")?;
    let numbers = group_numbers(&model.groups);
    let elements = Elements::new(model, &numbers);
    let mut text = Vec::new();
    let number = if version == Version::TwoTwo { "2.2" } else { "4.1" };
    text.extend_from_slice(format!("$MeshFormat\n{number} 0 8\n$EndMeshFormat\n").as_bytes());
    write_names(&mut text, model, &numbers);
    match version {
        Version::TwoTwo => {
            text.extend_from_slice(format!("$Nodes\n{}\n", model.vertex_count).as_bytes());
            for (tag, point) in (1..).zip(points(model)) {
                push_natural(&mut text, tag);
                text.push(b' ');
                push_point(&mut text, point);
                flush(&mut text, &mut out)?;
            }
            text.extend_from_slice(format!("$EndNodes\n$Elements\n{}\n", elements.count()).as_bytes());
            let mut tag = 0;
            elements.for_each(|element| {
                tag += 1;
                let physical =
                    elements.sets[element.dimension].groups(element.set).first().copied().unwrap_or(0);
                let header = [tag, element.number.into(), 2, physical as u64, u64::from(element.set) + 1];
                push_numbers(&mut text, header.into_iter().chain(tags(element.vertices)));
                flush(&mut text, &mut out)
            })?;
        }
        Version::FourOne => {
            let runs = elements.runs();
            let (dimension, set) = write_entities(&mut text, model, &elements, &runs);
            let count = model.vertex_count as u64;
            let bounds = [count.min(1), count, count.min(1), count];
            text.extend_from_slice(b"$Nodes\n");
            push_numbers(&mut text, bounds.into_iter());
            if count > 0 {
                push_numbers(&mut text, [dimension as u64, u64::from(set) + 1, 0, count].into_iter());
            }
            for tag in 1..=count {
                push_natural(&mut text, tag);
                text.push(b'\n');
                flush(&mut text, &mut out)?;
            }
            for point in points(model) {
                push_point(&mut text, point);
                flush(&mut text, &mut out)?;
            }
            text.extend_from_slice(b"$EndNodes\n$Elements\n");
            let count = elements.count();
            push_numbers(&mut text, [runs.len() as u64, count, count.min(1), count].into_iter());
            let (mut runs, mut left, mut tag) = (runs.into_iter(), 0, 0);
            elements.for_each(|element| {
                if left == 0 {
                    let run = runs.next().expect("every element is in a run");
                    left = run.count;
                    let header = [run.dimension as u64, u64::from(run.set) + 1, run.number.into(), run.count];
                    push_numbers(&mut text, header.into_iter());
                }
                left -= 1;
                tag += 1;
                push_numbers(&mut text, std::iter::once(tag).chain(tags(element.vertices)));
                flush(&mut text, &mut out)
            })?;
        }
    }
    text.extend_from_slice(b"$EndElements\n");
    for data in &model.data {
        write_data(&mut text, &elements, data, &mut out)?;
    }
    out.write_all(&text)?;
    out.flush()?;
    Ok(())
}

/// Each vertex's three coordinates; those that the model does not have are zero.
fn points(model: &Model) -> impl Iterator<Item = [f64; 3]> {
    let dimension = model.coordinate_count();
    model.coordinates().chunks_exact(dimension.max(1)).map(move |point| {
        let mut full = [0.0; 3];
        full[..dimension].copy_from_slice(point);
        full
    })
}

fn tags(vertices: &[u32]) -> impl Iterator<Item = u64> {
    vertices.iter().map(|&vertex| u64::from(vertex) + 1)
}

/// A line of numbers.
fn push_numbers(text: &mut Vec<u8>, numbers: impl Iterator<Item = u64>) {
    for (i, number) in numbers.enumerate() {
        if i > 0 {
            text.push(b' ');
        }
        push_natural(text, number);
    }
    text.push(b'\n');
}

fn push_point(text: &mut Vec<u8>, point: [f64; 3]) {
    for (i, coordinate) in point.into_iter().enumerate() {
        if i > 0 {
            text.push(b' ');
        }
        push_f64(text, coordinate);
    }
    text.push(b'\n');
}

/// Names that are more than their number, and groups that no element names.
fn write_names(text: &mut Vec<u8>, model: &Model, numbers: &[i32]) {
    let named: Vec<(&Group, i32)> = model
        .groups
        .iter()
        .zip(numbers.iter().copied())
        .filter(|(group, number)| group.members().is_empty() || group.name() != number.to_string())
        .collect();
    if named.is_empty() {
        return;
    }
    text.extend_from_slice(format!("$PhysicalNames\n{}\n", named.len()).as_bytes());
    for (group, number) in named {
        let name = quotable(group.name());
        text.extend_from_slice(format!("{} {number} \"{name}\"\n", dimension(group.kind())).as_bytes());
    }
    text.extend_from_slice(b"$EndPhysicalNames\n");
}

/// A name that can stand between quotes on a line.
fn quotable(name: &str) -> String {
    let letter = |c: char| match c {
        '"' => '\'',
        c if c.is_control() => ' ',
        c => c,
    };
    name.chars().map(letter).collect()
}

/// One array as a section of rows on nodes or elements; a polyline has its row on each of its edges.
fn write_data(
    text: &mut Vec<u8>,
    elements: &Elements<'_>,
    data: &CellData,
    out: &mut impl Write,
) -> Result<(), Error> {
    let row = |member: usize| -> Option<Vec<String>> {
        if let Some(row) = data.integer_row(member) {
            return Some(row.iter().map(i64::to_string).collect());
        }
        let row = data.real_row(member);
        row.iter().any(|x| !x.is_nan()).then(|| row.iter().map(|x| format!("{x:?}")).collect())
    };
    let rows: Vec<(u64, Vec<String>)> =
        elements.tags_of(data.kind()).filter_map(|(tag, member)| Some((tag, row(member)?))).collect();
    let section = if data.kind() == GroupKind::Vertices { "NodeData" } else { "ElementData" };
    let (name, components) = (quotable(data.name()), data.components());
    text.extend_from_slice(
        format!("${section}\n1\n\"{name}\"\n1\n0\n3\n0\n{components}\n{}\n", rows.len()).as_bytes(),
    );
    for (tag, row) in rows {
        push_natural(text, tag);
        for word in row {
            text.push(b' ');
            text.extend_from_slice(word.as_bytes());
        }
        text.push(b'\n');
        flush(text, out)?;
    }
    text.extend_from_slice(format!("$End{section}\n").as_bytes());
    Ok(())
}

/// One entity for each dimension and set of groups that occurs. Gives the one that the nodes lie on: the last.
fn write_entities(text: &mut Vec<u8>, model: &Model, elements: &Elements<'_>, runs: &[Run]) -> (usize, u32) {
    let mut entities: Vec<(usize, u32)> = runs.iter().map(|run| (run.dimension, run.set)).collect();
    entities.sort_unstable();
    entities.dedup();
    if entities.is_empty() && model.vertex_count > 0 {
        entities.push((0, 0));
    }
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for point in points(model).filter(|point| point.iter().all(|x| x.is_finite())) {
        for i in 0..3 {
            low[i] = low[i].min(point[i]);
            high[i] = high[i].max(point[i]);
        }
    }
    if model.partial_positions.is_some() && low[0] > high[0] {
        // No vertex has a position.
        (low, high) = ([0.0; 3], [0.0; 3]);
    }
    text.extend_from_slice(b"$Entities\n");
    push_numbers(
        text,
        (0..4).map(|d| entities.iter().filter(|&&(dimension, _)| dimension == d).count() as u64),
    );
    for &(dimension, set) in &entities {
        push_natural(text, u64::from(set) + 1);
        let corners = if dimension == 0 { &[low][..] } else { &[low, high][..] };
        for &coordinate in corners.iter().flatten() {
            text.push(b' ');
            push_f64(text, coordinate);
        }
        let groups = elements.sets[dimension].groups(set);
        text.extend_from_slice(format!(" {}", groups.len()).as_bytes());
        for group in groups {
            text.extend_from_slice(format!(" {group}").as_bytes());
        }
        text.extend_from_slice(if dimension == 0 { b"\n" } else { b" 0\n" });
    }
    text.extend_from_slice(b"$EndEntities\n");
    entities.last().copied().unwrap_or((0, 0))
}

/// The dimension of a group in the file.
fn dimension(kind: GroupKind) -> usize {
    match kind {
        GroupKind::Vertices => 0,
        GroupKind::Lines => 1,
        GroupKind::Polygons => 2,
        GroupKind::Cells => 3,
    }
}

/// Which set of groups each member of one kind is in.
struct Sets {
    /// The set of each member; 0 is the empty set.
    of_member: Vec<u32>,
    /// The numbers of the groups of each set.
    sets: Vec<Vec<i32>>,
}

impl Sets {
    fn new(groups: &[Group], numbers: &[i32], kind: GroupKind, count: usize) -> Self {
        let (mut of_member, mut sets) = (vec![0; count], vec![Vec::new()]);
        for (group, &number) in groups.iter().zip(numbers).filter(|(group, _)| group.kind() == kind) {
            // The set that each set becomes with this group in it.
            let mut larger = BTreeMap::new();
            for &member in group.members() {
                let Some(set) = of_member.get_mut(member as usize) else { continue };
                if sets[*set as usize].last() == Some(&number) {
                    continue;
                }
                *set = *larger.entry(*set).or_insert_with(|| {
                    let mut joined: Vec<i32> = sets[*set as usize].clone();
                    joined.push(number);
                    sets.push(joined);
                    (sets.len() - 1) as u32
                });
            }
        }
        Self { of_member, sets }
    }

    fn groups(&self, set: u32) -> &[i32] {
        &self.sets[set as usize]
    }
}

/// One element as it is written.
struct Element<'a> {
    dimension: usize,
    number: u8,
    set: u32,
    vertices: &'a [u32],
}

/// Elements one after the other with one type and one set of groups.
struct Run {
    dimension: usize,
    number: u8,
    set: u32,
    count: u64,
}

/// All elements in the order in which they are written.
struct Elements<'a> {
    model: &'a Model,
    /// The vertices that are written as points.
    points: Vec<u32>,
    /// By dimension.
    sets: [Sets; 4],
}

impl<'a> Elements<'a> {
    fn new(model: &'a Model, numbers: &[i32]) -> Self {
        let sets = |kind, count| Sets::new(&model.groups, numbers, kind, count);
        let sets = [
            sets(GroupKind::Vertices, model.vertex_count),
            sets(GroupKind::Lines, model.lines.len()),
            sets(GroupKind::Polygons, model.polygons.len()),
            sets(GroupKind::Cells, model.cells.len()),
        ];
        let mut points: Vec<u32> = model.points.iter().map(|point| point.to_u32()).collect();
        let mut listed = vec![false; model.vertex_count];
        for &point in &points {
            listed[point as usize] = true;
        }
        points.extend(
            (0..model.vertex_count as u32)
                .filter(|&v| sets[0].of_member[v as usize] != 0 && !listed[v as usize]),
        );
        Self { model, points, sets }
    }

    fn count(&self) -> u64 {
        let edges = self.model.lines.item_count() - self.model.lines.len();
        (self.points.len() + edges + self.model.polygons.len() + self.model.cells.len()) as u64
    }

    /// The tags of the nodes or elements of a kind, each with the member that it is of.
    fn tags_of(&self, kind: GroupKind) -> Box<dyn Iterator<Item = (u64, usize)> + '_> {
        let model = self.model;
        let points = self.points.len() as u64;
        let polygons = points + (model.lines.item_count() - model.lines.len()) as u64;
        let cells = polygons + model.polygons.len() as u64;
        match kind {
            GroupKind::Vertices => Box::new((1..).zip(0..model.vertex_count)),
            GroupKind::Lines => {
                let edges = model.lines.iter().enumerate();
                let edges = edges.flat_map(|(i, line)| std::iter::repeat_n(i, line.len() - 1));
                Box::new((points + 1..).zip(edges))
            }
            GroupKind::Polygons => Box::new((polygons + 1..).zip(0..model.polygons.len())),
            GroupKind::Cells => Box::new((cells + 1..).zip(0..model.cells.len())),
        }
    }

    fn for_each(&self, mut take: impl FnMut(Element<'_>) -> Result<(), Error>) -> Result<(), Error> {
        let mut give = |kind: Kind, dimension: usize, member: usize, vertices: &[u32]| {
            let number = ElementType::number_of(kind, vertices.len()).ok_or_else(|| {
                let message = format!("MSH has no element of {} vertices for this", vertices.len());
                Error::new(ErrorKind::UnsupportedFormat, message)
            })?;
            take(Element { dimension, number, set: self.sets[dimension].of_member[member], vertices })
        };
        for point in self.points.chunks(1) {
            give(Kind::Point, 0, point[0] as usize, point)?;
        }
        for (i, line) in self.model.lines.iter().enumerate() {
            for edge in line.windows(2) {
                give(Kind::Line, 1, i, edge)?;
            }
        }
        for (i, polygon) in self.model.polygons.iter().enumerate() {
            give(Kind::Polygon, 2, i, polygon)?;
        }
        for (i, (cell, &shape)) in self.model.cells.iter().zip(&self.model.shapes).enumerate() {
            give(Kind::Cell(shape), 3, i, cell)?;
        }
        Ok(())
    }

    fn runs(&self) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        let gathered = self.for_each(|Element { dimension, number, set, .. }| {
            match runs.last_mut() {
                Some(run) if (run.dimension, run.number, run.set) == (dimension, number, set) => {
                    run.count += 1;
                }
                _ => runs.push(Run { dimension, number, set, count: 1 }),
            }
            Ok(())
        });
        gathered.expect("the polygons were checked to have a type");
        runs
    }
}
