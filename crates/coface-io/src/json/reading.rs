//! From a stream to a model.

use super::coboundaries::boundaries;
use super::document::{Choice, Content, Document, Root};
use super::faults::Faults;
use super::points::PointList;
use crate::yin::{BoundaryDrawing, model_of_drawing};
use crate::{Model, Remark, RemarkCode, Structure};
use coface_algebra::SparseMatrix;
use coface_algebra::chains::{ChainComplex, ChainRefinement};
use coface_algebra::{Error, ErrorKind, RaggedArray, VertexId};
use coface_complexes::cell_mesh::CellShape;
use coface_complexes::surface::HalfedgePermutations;
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
/// [`ChainComplex::new`]. All but the last name the line. Of several models the first is read, with a remark.
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

/// The only model of a file, or the first of several, with a remark.
fn first(document: Document) -> Result<(Content, Option<Remark>), Error> {
    match document {
        Document::List(choice) => {
            let names = choice.names.clone();
            let content = choice.into_chosen().swap_remove(0);
            let message = format!(
                "the file holds {} models, and the first is taken; choose one by its place or name after a #: {}",
                names.len(),
                listed(&names)
            );
            let remark = Remark::new(RemarkCode::SeveralModels, message).at(names.len(), []);
            Ok((content, (names.len() > 1).then_some(remark)))
        }
        Document::One(_, content) => Ok((content, None)),
    }
}

/// The curves of a file, or of the object of this name in a list.
///
/// # Errors
/// Those of [`read`] and [`read_entry`]; [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) for anything but curves.
pub(crate) fn read_boundary(input: impl Read, name: Option<&str>) -> Result<BoundaryDrawing, Error> {
    let document = parse(input, name)?;
    let (content, remark) = match name {
        None => first(document)?,
        Some(name) => (chosen(document, name)?, None),
    };
    let what = match content {
        Content::Boundary(mut drawing) => {
            remark.into_iter().for_each(|remark| drawing.remark(remark));
            return Ok(drawing);
        }
        Content::Facets(..) => "a list of facets",
        Content::Halfedges { .. } => "permutations of halfedges",
        Content::Boundaries { .. } | Content::Coboundaries { .. } => "a chain complex",
        Content::Gluings(_) => "a gluing table",
        Content::Interface(_) => {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                "this is an interface of regions, and not one set in the plane",
            )
            .with_cure("read it as an interface"));
        }
        content @ Content::Unknown { .. } => {
            return Err(to_model(content, None).expect_err("nothing is known of it"));
        }
    };
    Err(Error::new(ErrorKind::UnsupportedFormat, format!("this is {what}, not a set in the plane"))
        .with_cure("give curves or polygons: {\"order\": 2, \"curves\": [{\"points\": [[x, y], ..]}, ..]}"))
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

/// The model of a name, or at a place, in a list; of a file of one model, that one.
fn chosen(document: Document, wanted: &str) -> Result<Content, Error> {
    let choice = match document {
        Document::List(choice) => choice,
        Document::One(None, Content::Facets(..)) if wanted != "1" => {
            return Err(Error::invalid(format!("there is no entry {wanted}: the file is a list of facets"))
                .with_cure("leave the entry out"));
        }
        Document::One(_, Content::Interface(interface)) => {
            return Ok(Content::Boundary(interface.phase(wanted)?));
        }
        Document::One(name, content) => {
            let mut choice = Choice::new(Some(wanted));
            choice.add(name, content);
            choice
        }
    };
    let names = choice.names.clone();
    let mut chosen = choice.into_chosen();
    match (chosen.pop(), chosen.len()) {
        (Some(content), 0) => Ok(content),
        (Some(_), more) => Err(Error::invalid(format!("{} entries have the name {wanted}", more + 1))
            .with_cure("choose one by its place, or give them names of their own")),
        (None, _) => Err(Error::invalid(format!("there is no entry {wanted}"))
            .with_cure(format!("choose one of: {}", listed(&names)))),
    }
}

/// The value of a file, or the list of its values where it has several, such as one a line.
fn parse(input: impl Read, wanted: Option<&str>) -> Result<Document, Error> {
    let mut deserializer = serde_json::Deserializer::from_reader(BufReader::with_capacity(1 << 16, input));
    let faults = Faults::default();
    let first = Root { wanted, faults: &faults }.deserialize(&mut deserializer);
    let first = first.map_err(|error| located(error, faults.take()))?;
    // What stands behind a value is another, or no JSON.
    if deserializer.end().is_ok() {
        return Ok(first);
    }
    let mut choice = Choice::new(wanted);
    add_value(&mut choice, first)?;
    while deserializer.end().is_err() {
        let value = Root { wanted: None, faults: &faults }.deserialize(&mut deserializer);
        add_value(&mut choice, value.map_err(|error| located(error, faults.take()))?)?;
    }
    Ok(Document::List(choice))
}

/// Adds one of several values of a file.
fn add_value(choice: &mut Choice, value: Document) -> Result<(), Error> {
    match value {
        Document::One(name, content) => {
            choice.add(name, content);
            Ok(())
        }
        Document::List(_) => {
            let place = choice.names.len() + 1;
            Err(Error::parse(format!("value {place} of the file is itself a list of models"))
                .with_cure("write one list, or one model a line"))
        }
    }
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
        Content::Facets(facets, points) => match points.and_then(PointList::into_list) {
            Some(positions) => return facets_at(facets, positions),
            None => Structure::Facets(facets),
        },
        Content::Halfedges { next, twin, outer, points } => {
            return halfedges(next, twin, outer, positions(points)?);
        }
        Content::Boundaries { matrices, points, pieces, exact, segments } => {
            let mut model = chains(matrices, positions(points)?)?;
            if let Some(exact) = exact {
                model = model.with_exact_polygons(exact.into_polygons()?.into());
            }
            if let Some(segments) = segments {
                model = model.with_exact_segments(segments.into_segments()?.into());
            }
            return match pieces {
                None => Ok(model),
                Some(pieces) => model.with_refinement(ChainRefinement::new(pieces)).map_err(|error| {
                    error.with_cure(
                        "give an entry or null for each cell under \"pieces_of\", or leave the key out",
                    )
                }),
            };
        }
        Content::Coboundaries { matrices, points } => {
            let positions = positions(points)?;
            let count = positions.as_ref().map(Positions::len);
            return chains(boundaries(matrices, count)?, positions);
        }
        Content::Gluings(table) => Structure::Gluings(table),
        Content::Boundary(drawing) => return model_of_drawing(&drawing, tolerance),
        Content::Interface(interface) => return model_of_drawing(&interface.phases()?, tolerance),
        Content::Unknown { is_answer: true, .. } => {
            return Err(Error::parse("this is an answer of coface, and not a model")
                .with_cure("give the model that it is about; coface view MODEL --with ANSWER shows both"));
        }
        Content::Unknown { keys, .. } if keys.is_empty() => {
            return Err(Error::parse(
                "the object has none of the keys \"facets\", \"next\", \"boundaries\", \"d0\", \"gluings\", \"curves\"",
            )
            .with_cure("give one of them"));
        }
        Content::Unknown { keys, .. } => {
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

/// A surface of halfedges; those without a twin lie on the boundary.
fn halfedges(
    next: Vec<u32>,
    twin: Option<Vec<Option<u32>>>,
    outer: Vec<u32>,
    positions: Option<Positions>,
) -> Result<Model, Error> {
    check_permutation("next", &next, next.len())?;
    let twin = twin.unwrap_or_else(|| (0..next.len() as u32).map(|h| Some(h ^ 1)).collect());
    let is_bare = |(h, twin): (usize, &Option<u32>)| twin.is_none_or(|twin| twin as usize == h);
    let permutations = if twin.iter().enumerate().any(is_bare) {
        let closed = HalfedgePermutations::with_boundary(&next, &twin)?;
        if outer.is_empty() {
            closed
        } else {
            let (next, twin, mut all) = closed.into_parts();
            all.extend(outer);
            HalfedgePermutations::new(next, twin, all)?
        }
    } else {
        let twin: Vec<u32> = twin.into_iter().flatten().collect();
        check_permutation("twin", &twin, next.len())?;
        if outer.is_empty() && positions.is_none() {
            return Ok(Model::from_structure(Structure::Halfedges { next, twin, outer }));
        }
        HalfedgePermutations::new(next, twin, outer)?
    };
    Model::from_halfedges(permutations, positions.unwrap_or_default())
}

fn positions(points: Option<PointList>) -> Result<Option<Positions>, Error> {
    points.map(PointList::into_positions).transpose()
}

/// The mesh of facets on these points, where all have at most four vertices, four in space only; otherwise the points are left out.
fn facets_at(facets: RaggedArray, positions: Positions) -> Result<Model, Error> {
    let (count, largest) = (positions.len(), if positions.dimension() == 3 { 4 } else { 3 });
    let beyond = |facet: &[u32]| facet.iter().copied().find(|&vertex| vertex as usize >= count);
    if let Some((place, vertex)) =
        facets.iter().enumerate().find_map(|(place, facet)| Some((place, beyond(facet)?)))
    {
        let message =
            format!("facet {place} has the vertex {vertex}, and there are {count} vertices, from 0");
        return Err(Error::invalid(message).with_cure("give a point for each, or leave the points out"));
    }
    let large = facets.iter().position(|facet| facet.len() > largest);
    if let Some(place) = large {
        let message = format!(
            "the positions of {count} vertices are left out: here they go with facets of up to {largest} vertices, and facet {place} has {}",
            facets.list(place).len()
        );
        let mut model = Model::from_structure(Structure::Facets(facets));
        model.remarks.push(Remark::new(RemarkCode::DataLeftOut, message));
        return Ok(model);
    }
    let mut of_length: [RaggedArray; 5] = std::array::from_fn(|_| RaggedArray::new());
    facets.iter().for_each(|facet| of_length[facet.len()].push(facet));
    let [_, points, lines, triangles, tetrahedra] = of_length;
    let points = points.items().iter().map(|&vertex| VertexId::from_u32(vertex)).collect();
    let shapes = vec![CellShape::Tetrahedron; tetrahedra.len()];
    Model::from_parts(count, positions, triangles, (shapes, tetrahedra), lines, points)
}

/// A chain complex, on positions if there are some.
fn chains(matrices: Vec<SparseMatrix>, positions: Option<Positions>) -> Result<Model, Error> {
    let complex = match matrices.is_empty() {
        true => ChainComplex::of_points(positions.as_ref().map_or(0, Positions::len)),
        false => ChainComplex::new(matrices)?,
    };
    let model = match positions {
        Some(positions) => Model::from_chains(complex, positions)?,
        None => Model::from_structure(Structure::Chains(complex)),
    };
    Ok(model.with_remark_on_cells())
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
        (0, _) => format!("they have no names, so a number from 1 to {}", names.len()),
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
