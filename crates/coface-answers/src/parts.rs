//! What of a model is one input: all of it, or its objects, groups, features or components.

use crate::answer::{Place, Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind, RaggedArray, UnionFind};
use coface_io::{GroupKind, GroupRole, Model};
use std::collections::BTreeMap;

/// So many names are listed in a message.
const MOST_NAMED: usize = 3;

/// What makes one input: a region of a drawing in the plane, a surface or solid in space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum RegionSource {
    /// All polygons or cells of a model are one input.
    #[default]
    Models,
    /// The polygons of a model with one name are an input, and so are those of each feature without a name: a whole
    /// `MultiPolygon`, an
    /// object of a city.
    Features,
    /// The polygons of an object are an input: `o` of OBJ, a named mesh of a scene, an object of a city.
    Objects,
    /// The polygons or cells of a group are an input: `g` of OBJ, a physical group of Gmsh, a reference number of
    /// MEDIT.
    Groups,
    /// The polygons or cells that are connected through vertices are an input.
    Components,
}

impl RegionSource {
    /// The word for such inputs, as it is given to `--inputs`.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::RegionSource::Objects.word(), "objects");
    /// ```
    pub const fn word(self) -> &'static str {
        match self {
            Self::Models => "files",
            Self::Features => "features",
            Self::Objects => "objects",
            Self::Groups => "groups",
            Self::Components => "components",
        }
    }

    /// The role of the groups that are inputs, if groups are.
    pub(crate) const fn role(self) -> Option<GroupRole> {
        match self {
            Self::Objects => Some(GroupRole::Object),
            Self::Groups => Some(GroupRole::Group),
            Self::Models | Self::Features | Self::Components => None,
        }
    }

    /// What else would be inputs of this model, as the end of a sentence; empty if nothing would.
    fn others(self, model: &Model) -> String {
        let has =
            [Self::Objects, Self::Groups].into_iter().filter(|&other| other != self).find_map(|other| {
                let role = other.role()?;
                let count = model.groups().iter().filter(|group| group.has_role(role)).count();
                (count > 0).then(|| format!("; it has {count} {}: --inputs {}", other.word(), other.word()))
            });
        has.unwrap_or_default()
    }

    /// The error about a model without any such inputs.
    pub(crate) fn missing(self, model: &Model) -> Error {
        let others = self.others(model);
        let cure = match others.strip_prefix("; ") {
            Some(others) => others.to_owned(),
            None => {
                "--inputs files takes it as one input, --inputs components its connected parts".to_owned()
            }
        };
        Error::new(ErrorKind::InvalidInput, format!("there are no {} that could be inputs", self.word()))
            .with_cure(cure)
    }
}

/// Some of the polygons or cells of a model, which are one input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Part {
    /// The name that the file gives it; `None` for what is in no object or group.
    pub(crate) name: Option<String>,
    /// Rising.
    pub(crate) members: Vec<u32>,
}

/// The parts of a model with these elements (polygons or cells by their vertices), and remarks about them. Only groups
/// of this kind are
/// asked.
pub(crate) fn parts_of(
    file: &str,
    model: &Model,
    source: RegionSource,
    (elements, kind): (&RaggedArray, GroupKind),
) -> Result<(Vec<Part>, Vec<Remark>), Error> {
    let mut remarks = Vec::new();
    let parts = match source {
        RegionSource::Models => vec![Part { name: None, members: (0..elements.len() as u32).collect() }],
        RegionSource::Components => components(elements, model.vertex_count()),
        RegionSource::Features => features(model, elements.len(), kind),
        RegionSource::Objects | RegionSource::Groups => {
            groups(file, model, source, (elements.len(), kind), &mut remarks)
        }
    };
    if parts.is_empty() {
        return Err(source.missing(model));
    }
    Ok((parts, remarks))
}

fn groups(
    file: &str,
    model: &Model,
    source: RegionSource,
    (count, kind): (usize, GroupKind),
    remarks: &mut Vec<Remark>,
) -> Vec<Part> {
    let own = |group: &&coface_io::Group| {
        group.kind() == kind && source.role().is_some_and(|role| group.has_role(role))
    };
    let mut is_in_one = vec![false; count];
    let mut parts: Vec<Part> = Vec::new();
    for group in model.groups().iter().filter(own) {
        let mut members = group.members().to_vec();
        members.sort_unstable();
        members.dedup();
        members.iter().for_each(|&member| is_in_one[member as usize] = true);
        parts.push(Part { name: Some(group.name().to_owned()), members });
    }
    if parts.iter().all(|part| part.members.is_empty()) {
        return Vec::new();
    }
    let empty: Vec<&str> =
        parts.iter().filter(|part| part.members.is_empty()).filter_map(|part| part.name.as_deref()).collect();
    if !empty.is_empty() {
        let listed: Vec<String> =
            empty.iter().take(MOST_NAMED).map(|name| format!("\"{}\"", name.escape_debug())).collect();
        let more = if empty.len() > MOST_NAMED { ", .." } else { "" };
        let (what, verb) = match empty.len() {
            1 => (source.word().trim_end_matches('s').to_owned(), "has no {kind} and is empty"),
            many => (format!("{many} {}", source.word()), "have no {kind} and are empty"),
        };
        let message = format!(
            "{file}: {what} {}{more} {}",
            listed.join(", "),
            verb.replace("{kind}", &kind.to_string())
        );
        remarks.push(Remark::new(RemarkCode::EmptyInput, message).at(empty.len(), [Place::file(file)]));
    }
    let rest: Vec<u32> = (0..count as u32).filter(|&member| !is_in_one[member as usize]).collect();
    if !rest.is_empty() {
        let message = format!(
            "{file}: {} of {count} {kind} are in no {}; together they are one more input, named by the file",
            rest.len(),
            source.word().trim_end_matches('s')
        );
        remarks.push(Remark::new(RemarkCode::UnnamedInput, message).at(rest.len(), [Place::file(file)]));
        parts.push(Part { name: None, members: rest });
    }
    parts
}

/// Polygons with one name, and those of each feature without a name.
fn features(model: &Model, count: usize, kind: GroupKind) -> Vec<Part> {
    let mut names = vec![None; count];
    for group in model.groups().iter().rev().filter(|group| group.kind() == kind) {
        group.members().iter().for_each(|&member| names[member as usize] = Some(group.name()));
    }
    let mut parts: Vec<Part> = Vec::new();
    let mut of_name: BTreeMap<String, usize> = BTreeMap::new();
    let mut is_named = false;
    for (member, name) in names.into_iter().enumerate() {
        let feature = (kind == GroupKind::Polygons).then(|| model.features().of_polygon(member)).flatten();
        let name = match feature.and_then(|feature| model.features().id(feature)) {
            Some(id) => id.trim_matches('"').to_owned(),
            None => name.unwrap_or_default().to_owned(),
        };
        is_named |= !name.is_empty();
        let at = *of_name.entry(name.clone()).or_insert(parts.len());
        if at == parts.len() {
            parts.push(Part { name: Some(name).filter(|name| !name.is_empty()), members: Vec::new() });
        }
        parts[at].members.push(member as u32);
    }
    if is_named { parts } else { Vec::new() }
}

/// The number of objects of a model of polygons, if there are several and each is closed: an even number of its
/// polygons has each of its
/// edges.
pub(crate) fn closed_objects(model: &Model) -> Option<usize> {
    if !model.cells().is_empty() {
        return None;
    }
    let objects: Vec<&[u32]> = model
        .groups()
        .iter()
        .filter(|group| group.kind() == GroupKind::Polygons && group.has_role(GroupRole::Object))
        .map(coface_io::Group::members)
        .filter(|members| !members.is_empty())
        .collect();
    let is_closed = |members: &&[u32]| {
        let mut edges: Vec<[u32; 2]> = Vec::new();
        for &polygon in *members {
            let corners = model.polygons().list(polygon as usize);
            let next = corners.iter().skip(1).chain(corners.first());
            edges.extend(corners.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)]));
        }
        edges.sort_unstable();
        edges.chunk_by(|a, b| a == b).all(|same| same.len() % 2 == 0)
    };
    (objects.len() > 1 && objects.iter().all(is_closed)).then_some(objects.len())
}

/// Elements that are connected through vertices; a part has no name.
fn components(elements: &RaggedArray, vertex_count: usize) -> Vec<Part> {
    let mut vertices = UnionFind::new(vertex_count);
    for element in elements.iter() {
        element.windows(2).for_each(|pair| {
            vertices.unite(pair[0], pair[1]);
        });
    }
    let classes = vertices.class_numbers();
    let mut number_of_class: BTreeMap<u32, usize> = BTreeMap::new();
    let mut parts: Vec<Part> = Vec::new();
    for (member, element) in elements.iter().enumerate() {
        let Some(&vertex) = element.first() else { continue };
        let at = *number_of_class.entry(classes[vertex as usize]).or_insert(parts.len());
        if at == parts.len() {
            parts.push(Part { name: None, members: Vec::new() });
        }
        parts[at].members.push(member as u32);
    }
    parts
}
