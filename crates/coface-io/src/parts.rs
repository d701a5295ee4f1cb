//! Parts of a mesh: the polygons of groups, such as the objects of an OBJ and the solids of an STL.

use crate::{Format, GroupKind, Model, readers};
use coface_algebra::{Error, RaggedArray};
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

/// The polygons of the group of this name, or at this place among the groups of polygons from 1, with their vertices.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] naming the groups that there are.
pub(crate) fn part(model: Model, entry: &str) -> Result<Model, Error> {
    let groups: Vec<_> = model.groups().iter().filter(|group| group.kind() == GroupKind::Polygons).collect();
    let place = entry.parse::<usize>().ok().and_then(|place| place.checked_sub(1));
    // An object whose name other polygons have too has its keyword in front.
    let named = |name: &str| groups.iter().find(|group| group.name() == name);
    let found =
        named(&format!("o {entry}")).or_else(|| named(entry)).or(place.and_then(|place| groups.get(place)));
    let Some(group) = found else {
        let names: Vec<String> = groups
            .iter()
            .take(20)
            .map(|group| group.name().chars().take(60).flat_map(char::escape_debug).collect())
            .collect();
        return Err(Error::invalid(format!("there is no part {}", entry.escape_debug())).with_cure(
            if names.is_empty() {
                "leave the part out: the file has no groups of polygons".to_owned()
            } else {
                format!("choose one of: {}", names.join(", "))
            },
        ));
    };
    let mut new = vec![u32::MAX; model.vertex_count()];
    let (mut vertices, mut polygons) = (Vec::new(), RaggedArray::new());
    for &polygon in group.members() {
        let corners: Vec<u32> = model
            .polygons()
            .list(polygon as usize)
            .iter()
            .map(|&vertex| {
                let place = &mut new[vertex as usize];
                if *place == u32::MAX {
                    *place = vertices.len() as u32;
                    vertices.push(vertex);
                }
                *place
            })
            .collect();
        polygons.push(&corners);
    }
    let (dimension, flat) = (model.coordinate_count(), model.coordinates());
    let coordinates = vertices.iter().flat_map(|&vertex| {
        let start = vertex as usize * dimension;
        flat[start..start + dimension].iter().copied()
    });
    let (positions, partial_positions) = crate::model::placed(dimension, coordinates.collect())?;
    let part =
        Model { vertex_count: vertices.len(), positions, partial_positions, polygons, ..Model::default() };
    part.check()?;
    let format = model.format().unwrap_or(Format::Obj);
    Ok(Model { remarks: model.remarks, ..part }.with_format(format))
}
