//! From a stream to a model.

use super::coboundaries::boundaries;
use super::document::{Content, Document, Root};
use super::faults::Faults;
use super::points::PointList;
use crate::yin::{BoundaryDrawing, model_of_drawing};
use crate::{Model, Remark, RemarkCode, Structure};
use coface_algebra::SparseMatrix;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{Error, ErrorKind};
use coface_geometry::Positions;
use serde::de::DeserializeSeed;
use serde_json::error::Category;
use std::io::{BufReader, Read};

/// Names that an error lists at most.
const LISTED_NAMES: usize = 60;

/// Reads the structure that a JSON file describes: see [the forms](crate::json).
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for what is no JSON or none of the forms; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming the facet,
/// halfedge or entry that is wrong; [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) for numbers beyond 32 bits; the errors of
/// [`ChainComplex::new`]. All but the last name the line. Of a list of objects the first is read, with a remark.
///
/// # Complexity
/// Linear; memory is the model.
///
/// # Examples
/// ```
/// use coface_io::{Structure, json};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = json::read(&br#"{"facets": [[0, 1, 2], [4000000000]]}"#[..])?;
/// let Some(Structure::Facets(facets)) = model.structure() else { panic!("facets") };
/// assert_eq!(facets.list(1), [4_000_000_000]);
/// let error = json::read(&b"[[0, 1], [2, 3, 2]]"[..]).unwrap_err();
/// assert!(error.to_string().contains("facet 1 repeats vertex 2"));
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    read_with(input, None)
}

/// The same with chords that are within a tolerance of curves.
pub(crate) fn read_with(input: impl Read, tolerance: Option<f64>) -> Result<Model, Error> {
    let (content, remark) = first(parse(input, None)?)?;
    let mut model = to_model(content, tolerance)?;
    model.remarks.extend(remark);
    Ok(model)
}

/// The only object of a file, or the first of several, with a remark.
fn first(document: Document) -> Result<(Content, Option<Remark>), Error> {
    match document {
        Document::List { names, mut chosen } if !chosen.is_empty() => {
            let content = chosen.swap_remove(0);
            let message = format!(
                "the file is a list of {} objects, and the first is taken; choose one by its place or name after a #: {}",
                names.len(),
                listed(&names)
            );
            let remark = Remark::new(RemarkCode::SeveralModels, message).at(names.len(), []);
            Ok((content, (names.len() > 1).then_some(remark)))
        }
        document => one(document).map(|content| (content, None)),
    }
}

/// The names of the objects of a list, or their places; none if the file is no list of objects.
pub(crate) fn entries(input: impl Read) -> Result<Vec<String>, Error> {
    Ok(match parse(input, None)? {
        Document::One(_) => Vec::new(),
        Document::List { names, .. } => {
            let entry = |(i, name): (usize, Option<String>)| name.unwrap_or_else(|| (i + 1).to_string());
            names.into_iter().enumerate().map(entry).collect()
        }
    })
}

/// The curves of a file, or of the object of this name in a list.
///
/// # Errors
/// Those of [`read`] and [`read_entry`]; [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) for anything but curves.
pub(crate) fn read_boundary(input: impl Read, name: Option<&str>) -> Result<BoundaryDrawing, Error> {
    let document = parse(input, name)?;
    let content = match name {
        None => one(document)?,
        Some(name) => chosen(document, name)?,
    };
    let what = match content {
        Content::Boundary(drawing) => return Ok(drawing),
        Content::Facets(_) => "a list of facets",
        Content::Halfedges { .. } => "permutations of halfedges",
        Content::Boundaries { .. } | Content::Coboundaries { .. } => "a chain complex",
        Content::Gluings(_) => "a gluing table",
        content @ Content::Unknown(_) => {
            return Err(to_model(content, None).expect_err("nothing is known of it"));
        }
    };
    Err(Error::new(ErrorKind::UnsupportedFormat, format!("this is {what}, not a set in the plane"))
        .with_cure("give curves or polygons: {\"order\": 2, \"curves\": [{\"points\": [[x, y], ..]}, ..]}"))
}

/// The only object of a file.
fn one(document: Document) -> Result<Content, Error> {
    match document {
        Document::One(content) => Ok(content),
        Document::List { names, .. } => {
            Err(Error::invalid(format!("the file is a list of {} objects", names.len()))
                .with_cure(format!("choose one by its name after a #: {}", listed(&names))))
        }
    }
}

/// Reads the object of this name, or at this place from 1, from a list of objects, as [`read`] reads one alone.
///
/// # Errors
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) listing the names when there is none, or more than one, of this name; otherwise those of
/// [`read`], also for faults in other objects of the list.
///
/// # Complexity
/// Linear; memory is the largest object.
///
/// # Examples
/// ```
/// use coface_io::json;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let list = br#"[{"name": "a", "facets": [[0, 1]]}, {"name": "b", "facets": [[0, 1, 2]]}]"#;
/// assert_eq!(json::read_entry(&list[..], "b")?, json::read(&b"[[0, 1, 2]]"[..])?);
/// assert!(json::read_entry(&list[..], "c").unwrap_err().to_string().contains("a, b"));
/// # Ok(()) }
/// ```
pub fn read_entry(input: impl Read, name: &str) -> Result<Model, Error> {
    to_model(chosen(parse(input, Some(name))?, name)?, None)
}

/// The object of a name in a list.
fn chosen(document: Document, name: &str) -> Result<Content, Error> {
    let (names, mut chosen) = match document {
        Document::List { names, chosen } => (names, chosen),
        Document::One(_) => {
            return Err(Error::invalid(format!("there is no entry {name}: the file is a list of facets"))
                .with_cure("leave the entry out"));
        }
    };
    match (chosen.pop(), chosen.len()) {
        (Some(content), 0) => Ok(content),
        (Some(_), more) => Err(Error::invalid(format!("{} entries have the name {name}", more + 1))
            .with_cure("give them names of their own")),
        (None, _) => Err(Error::invalid(format!("there is no entry {name}"))
            .with_cure(format!("choose one of: {}", listed(&names)))),
    }
}

fn parse(input: impl Read, wanted: Option<&str>) -> Result<Document, Error> {
    let mut deserializer = serde_json::Deserializer::from_reader(BufReader::with_capacity(1 << 16, input));
    let faults = Faults::default();
    Root { wanted, faults: &faults }
        .deserialize(&mut deserializer)
        .and_then(|document| deserializer.end().map(|()| document))
        .map_err(|error| located(error, faults.take()))
}

/// The fault that was raised, or the parser's own, with the place.
fn located(error: serde_json::Error, fault: Option<Error>) -> Error {
    let line = error.line() as u64;
    if let Some(fault) = fault {
        return fault.at_line(line);
    }
    let (category, column) = (error.classify(), error.column());
    if category == Category::Io {
        return std::io::Error::from(error).into();
    }
    let text = error.to_string();
    let place = format!(" at line {line} column {column}");
    let message = format!("{} (column {column})", text.strip_suffix(&place).unwrap_or(&text));
    Error::parse(message).at_line(line).with_cure(match category {
        Category::Eof => "the file was cut short: write it again",
        Category::Data => {
            "give facets, halfedges, boundary or coboundary matrices, gluings or curves as the documentation of the format says"
        }
        _ if text.starts_with("expected value") => "the file must be JSON, which has no NaN and no Infinity",
        _ => "the file must be JSON",
    })
}

fn to_model(content: Content, tolerance: Option<f64>) -> Result<Model, Error> {
    let structure = match content {
        Content::Facets(facets) => Structure::Facets(facets),
        Content::Halfedges { next, twin } => {
            let twin = twin.unwrap_or_else(|| (0..next.len() as u32).map(|h| h ^ 1).collect());
            check_permutation("next", &next, next.len())?;
            check_permutation("twin", &twin, next.len())?;
            Structure::Halfedges { next, twin }
        }
        Content::Boundaries { matrices, points } => return chains(matrices, positions(points)?),
        Content::Coboundaries { matrices, points } => {
            let positions = positions(points)?;
            let count = positions.as_ref().map(Positions::len);
            return chains(boundaries(matrices, count)?, positions);
        }
        Content::Gluings(table) => Structure::Gluings(table),
        Content::Boundary(drawing) => return model_of_drawing(&drawing, tolerance),
        Content::Unknown(keys) if keys.is_empty() => {
            return Err(Error::parse(
                "the object has none of the keys \"facets\", \"next\", \"boundaries\", \"d0\", \"gluings\", \"curves\"",
            )
            .with_cure("give one of them"));
        }
        Content::Unknown(keys) => {
            let keys: Vec<String> = keys.iter().map(|key| format!("\"{}\"", shortened(key))).collect();
            return Err(Error::parse(format!(
                "the object has the keys {}, but none of \"facets\", \"next\", \"boundaries\", \"d0\", \"gluings\", \"curves\"",
                keys.join(", ")
            ))
            .with_cure("give one of them, or check that the file is the one meant"));
        }
    };
    Ok(Model::from_structure(structure))
}

fn positions(points: Option<PointList>) -> Result<Option<Positions>, Error> {
    points.map(PointList::into_positions).transpose()
}

/// A chain complex, on positions if there are some.
fn chains(matrices: Vec<SparseMatrix>, positions: Option<Positions>) -> Result<Model, Error> {
    let complex = match matrices.is_empty() {
        true => ChainComplex::of_points(positions.as_ref().map_or(0, Positions::len)),
        false => ChainComplex::new(matrices)?,
    };
    match positions {
        Some(positions) => Model::from_chains(complex, positions),
        None => Ok(Model::from_structure(Structure::Chains(complex))),
    }
}

/// Verifies that the list is a permutation of the halfedges `0..count`.
fn check_permutation(name: &str, images: &[u32], count: usize) -> Result<(), Error> {
    if images.len() != count {
        return Err(Error::invalid(format!(
            "\"{name}\" has {} halfedges, but \"next\" has {count}",
            images.len()
        ))
        .with_cure("give each halfedge a next and a twin"));
    }
    let mut seen = vec![false; count];
    for (halfedge, &image) in images.iter().enumerate() {
        let fault = match seen.get_mut(image as usize) {
            Some(seen) if !*seen => {
                *seen = true;
                continue;
            }
            Some(_) => format!("is {image}, as is that of an earlier one"),
            None => format!("is {image}, but there are {count} halfedges, numbered from 0"),
        };
        return Err(Error::invalid(format!("\"{name}\" of halfedge {halfedge} {fault}"))
            .with_cure(format!("make \"{name}\" a permutation of the halfedges")));
    }
    Ok(())
}

/// The names of the objects for an error message.
fn listed(names: &[Option<String>]) -> String {
    let shown: Vec<String> = names.iter().flatten().take(LISTED_NAMES).map(|name| shortened(name)).collect();
    match (shown.len(), names.len()) {
        (0, _) => "none has a name, so give them names".to_owned(),
        (shown_count, count) if shown_count < count => {
            format!("{} and {} more", shown.join(", "), count - shown_count)
        }
        _ => shown.join(", "),
    }
}

/// A text from the file, safe and short enough for an error message.
fn shortened(text: &str) -> String {
    let start: String = text.chars().take(60).collect();
    let dots = if start.len() < text.len() { "..." } else { "" };
    format!("{}{dots}", start.escape_debug())
}
