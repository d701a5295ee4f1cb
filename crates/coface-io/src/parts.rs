//! Parts of a mesh: the polygons of groups, such as the objects of an OBJ and the solids of an STL.

use crate::{Format, GroupKind, GroupRole, Model, readers};
use coface_algebra::{Error, RaggedArray, VertexId};
use std::collections::HashSet;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

/// More parts than this are none: rows for each would say nothing.
const MOST_PARTS: usize = 1 << 16;
/// Names are cut here.
const LONGEST_NAME: usize = 1 << 10;

/// The objects of an OBJ, or the solids of an STL as text, if there are several: what [`read_path`](crate::read_path) takes behind a
/// `#`. Names count once, and what has none is no part.
///
/// # Errors
/// As [`read_path`](crate::read_path), for what is wrong with the start of the file.
///
/// # Complexity
/// Linear, without making the mesh; memory is the list.
///
/// # Examples
/// ```
/// use coface_io as io;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = std::env::temp_dir().join("coface-parts-of-path.obj");
/// std::fs::write(&path, "v 0 0 0\nv 1 0 0\nv 0 1 0\no low\nf 1 2 3\no high\nf 3 2 1\n")?;
/// assert_eq!(io::parts_of_path(&path, None)?, ["low", "high"]);
/// # std::fs::remove_file(&path)?;
/// # Ok(()) }
/// ```
pub fn parts_of_path(path: impl AsRef<Path>, format: Option<Format>) -> Result<Vec<String>, Error> {
    let path = path.as_ref();
    let found = || {
        let opened = readers::opened(readers::counted(path)?, Some(path), format)?;
        let keyword: &[u8] = match opened.format {
            Format::Obj => b"o",
            Format::Stl => b"solid",
            _ => return Ok(Vec::new()),
        };
        names_behind(keyword, opened.bytes())
    };
    found().map_err(|error: Error| error.in_file(path.display().to_string()))
}

/// What stands behind a keyword that begins a line; nothing if there are fewer than two different names, or the file is no text.
fn names_behind(keyword: &[u8], input: impl Read) -> Result<Vec<String>, Error> {
    let mut input = BufReader::with_capacity(1 << 16, input);
    let (mut names, mut seen) = (Vec::new(), HashSet::new());
    // The line that is being read, up to what a name may have.
    let (mut line, most) = (Vec::new(), keyword.len() + LONGEST_NAME);
    loop {
        let piece = input.fill_buf()?;
        let end = memchr::memchr(b'\n', piece);
        let (text, is_last) = (&piece[..end.unwrap_or(piece.len())], piece.is_empty());
        line.extend_from_slice(&text[..text.len().min(most - line.len().min(most))]);
        let used = text.len() + usize::from(end.is_some());
        input.consume(used);
        if end.is_none() && !is_last {
            continue;
        }
        if line.contains(&0) || names.len() > MOST_PARTS {
            return Ok(Vec::new());
        }
        let words = line.trim_ascii_start();
        if let Some(rest) = words.strip_prefix(keyword)
            && rest.first().is_none_or(u8::is_ascii_whitespace)
            && !words.is_empty()
        {
            let name = String::from_utf8_lossy(rest.trim_ascii()).into_owned();
            let is_plain = !name.is_empty() && !name.chars().any(char::is_control);
            if is_plain && seen.insert(name.clone()) {
                names.push(name);
            }
        }
        if is_last {
            return Ok(if names.len() > 1 { names } else { Vec::new() });
        }
        line.clear();
    }
}

/// The polygons, lines and points of the groups of this name, or of the group at this place among those of polygons from 1, with their
/// vertices. Groups of lines and points alone come behind those of polygons.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] naming the groups that there are.
pub(crate) fn part(model: Model, entry: &str) -> Result<Model, Error> {
    let mut names: Vec<&str> = Vec::new();
    let mut known = HashSet::new();
    for kind in [GroupKind::Polygons, GroupKind::Lines, GroupKind::Vertices] {
        for group in model.groups().iter().filter(|group| group.kind() == kind) {
            if known.insert(group.name()) {
                names.push(group.name());
            }
        }
    }
    let place = entry.parse::<usize>().ok().and_then(|place| place.checked_sub(1));
    // An object whose name other elements have too has its keyword in front.
    let of_object = format!("o:{entry}");
    let found = [&of_object[..], entry].into_iter().find(|name| known.contains(name));
    let Some(name) = found.or(place.and_then(|place| names.get(place).copied())) else {
        let names: Vec<String> = names
            .iter()
            .take(20)
            .map(|name| name.chars().take(60).flat_map(char::escape_debug).collect())
            .collect();
        return Err(Error::invalid(format!("there is no part {}", entry.escape_debug())).with_cure(
            if names.is_empty() {
                "leave the part out: the file has no groups".to_owned()
            } else {
                format!("choose one of: {}", names.join(", "))
            },
        ));
    };
    // The members of that name; where the name has the keyword in front for one kind of element, it may have none for the others.
    let of_kind = |kind: GroupKind| {
        let named =
            |name: &str| model.groups().iter().find(|group| group.kind() == kind && group.name() == name);
        let plain = name.strip_prefix("o:").filter(|_| name == of_object);
        let object = plain.and_then(named).filter(|group| group.has_role(GroupRole::Object));
        named(name).or(object).map_or(&[][..], |group| group.members())
    };
    let mut new = vec![u32::MAX; model.vertex_count()];
    let mut vertices = Vec::new();
    let mut taken = |old: &[u32]| -> Vec<u32> {
        let number = |&vertex: &u32| {
            let place = &mut new[vertex as usize];
            if *place == u32::MAX {
                *place = vertices.len() as u32;
                vertices.push(vertex);
            }
            *place
        };
        old.iter().map(number).collect()
    };
    let (mut polygons, mut lines) = (RaggedArray::new(), RaggedArray::new());
    let kept = [GroupKind::Polygons, GroupKind::Lines].map(|kind| (kind, of_kind(kind).to_vec()));
    for &polygon in of_kind(GroupKind::Polygons) {
        polygons.push(&taken(model.polygons().list(polygon as usize)));
    }
    for &line in of_kind(GroupKind::Lines) {
        lines.push(&taken(model.lines().list(line as usize)));
    }
    let points = taken(of_kind(GroupKind::Vertices)).into_iter().map(VertexId::from_u32).collect();
    let (dimension, flat) = (model.coordinate_count(), model.coordinates());
    let coordinates = vertices.iter().flat_map(|&vertex| {
        let start = vertex as usize * dimension;
        flat[start..start + dimension].iter().copied()
    });
    let (positions, partial_positions) = crate::model::placed(dimension, coordinates.collect())?;
    let places = |kind: GroupKind| -> Option<Vec<usize>> {
        let members = match kind {
            GroupKind::Vertices => &vertices,
            kind => &kept.iter().find(|(own, _)| *own == kind)?.1,
        };
        Some(members.iter().map(|&member| member as usize).collect())
    };
    // With them, closed lines are the rings of polygons as before.
    let data = model.data().iter().filter_map(|data| Some(data.taken_from(places(data.kind())?))).collect();
    let part = Model {
        data,
        reference: model.reference.clone(),
        vertex_count: vertices.len(),
        positions,
        partial_positions,
        polygons,
        lines,
        points,
        ..Model::default()
    };
    part.check()?;
    let format = model.format().unwrap_or(Format::Obj);
    let mut remarks = model.remarks;
    if let Some(oddities) = &model.oddities {
        let of_all = oddities.remarks();
        let at = remarks.iter().position(|own| of_all.contains(own)).unwrap_or(remarks.len());
        remarks.retain(|own| !of_all.contains(own));
        let number = |vertex: u32| new.get(vertex as usize).copied().filter(|&own| own != u32::MAX);
        remarks.splice(at..at, oddities.of_part(number).remarks());
    }
    Ok(Model { remarks, ..part }.with_format(format))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_have_their_own_faults_alone() {
        let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nv 2 1 1\no good\nf 1 2 3\no bad\nf 4 5 5 6\nf 4 5 4\nf 4 5 6\n";
        let remarks = |entry: &str| part(crate::obj::read(text.as_bytes()).unwrap(), entry).unwrap().remarks;
        assert_eq!(remarks("good"), []);
        let bad = remarks("bad");
        assert_eq!(bad.len(), 2);
        assert_eq!(bad[0].places[0].cell, Some(vec![0, 1, 1, 2]), "by the numbers of the part");
    }

    #[test]
    fn parts_have_the_lines_and_points_of_their_name() {
        let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no face\nf 1 2 3\no wire\nl 1 2 3 1\nl 3 4\no dust\np 2 4\no both\nf 1 2 4\nl 2 3\n\
                    g wire\nf 2 3 4\n";
        let model = || crate::obj::read(text.as_bytes()).unwrap();
        let counts = |entry: &str| {
            let part = part(model(), entry).unwrap();
            (part.vertex_count(), part.polygons().len(), part.lines().len(), part.points().len())
        };
        assert_eq!(counts("face"), (3, 1, 0, 0));
        assert_eq!(counts("wire"), (4, 1, 2, 0), "a group and an object of one name");
        assert_eq!(counts("dust"), (2, 0, 0, 2));
        assert_eq!(counts("both"), (4, 2, 1, 0));
        assert_eq!((counts("1"), counts("4")), (counts("face"), counts("dust")));
        let error = part(model(), "rope").unwrap_err().to_string();
        assert!(error.contains("face, both, wire, dust"), "{error}");
        // The rings of a drawing stay rings.
        let text = r#"{"type": "FeatureCollection", "features": [
            {"type": "Feature", "properties": {"name": "a"}, "geometry": {"type": "Polygon", "coordinates": [[[0,0],[1,0],[1,1],[0,0]]]}},
            {"type": "Feature", "properties": {"name": "b"}, "geometry": {"type": "Polygon", "coordinates": [[[0,0],[9,0],[9,9],[0,0]], [[5,1],[6,1],[6,2],[5,1]]]}}]}"#;
        let drawn = part(crate::geojson::read(text.as_bytes()).unwrap(), "b").unwrap();
        let shapes: Vec<_> = crate::shapes(&drawn).into_iter().map(|(shape, _)| shape).collect();
        assert_eq!(shapes, [crate::Shape::Rings(0..2)]);
        // An object comes before a group of its name.
        let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\ng a\nf 1 2 3\nf 1 3 2\ng\no a\nf 3 2 1\n";
        assert_eq!(part(crate::obj::read(text.as_bytes()).unwrap(), "a").unwrap().polygons().len(), 1);
    }
}
