//! The text files of TetGen and Triangle: `.node`, `.ele`, `.face`, `.edge` and `.poly`.
//!
//! A facet of a `.poly` in space is the part of a plane that its polygons enclose: polygons inside of others, or segments that close up, divide it,
//! and what holds a hole point is left out. A facet with holes is read as triangles, and its rings are [surfaces as stated](crate::StatedSurfaces).
//! Attributes of nodes and elements are left out.

use crate::assembly::Assembly;
use crate::element_kind::Kind;
use crate::files::Companions;
use crate::planar_facet::{Facet, Facets};
use crate::scanner::{parse_coordinate, parse_f64, parse_i64};
use crate::stated_surfaces::SurfaceCollector;
use crate::{GroupKind, Model};
use coface_algebra::{Error, ErrorKind};
use std::collections::HashMap;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::sync::Arc;

/// What a file lists, by its extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Nodes,
    /// Tetrahedra, or triangles of a plane.
    Elements,
    Faces,
    Edges,
    Poly,
}

impl Part {
    fn of_path(path: &Path) -> Self {
        let extension = path.extension().map(|extension| extension.to_ascii_lowercase());
        match extension.as_deref().and_then(|extension| extension.to_str()) {
            Some("ele") => Self::Elements,
            Some("face") => Self::Faces,
            Some("edge") => Self::Edges,
            Some("poly") => Self::Poly,
            _ => Self::Nodes,
        }
    }
}

/// Reads a stream of nodes, or of a piecewise linear complex that has nodes of its own.
///
/// # Errors
/// [`ErrorKind::Parse`] and [`ErrorKind::InvalidInput`] with the line: a word where a number should be, a node that is not there, a file that was
/// cut short; for elements, whose nodes are another file, which [`crate::read_path`] finds beside them.
///
/// # Complexity
/// Linear.
///
/// # References
/// H. Si, *TetGen, a Delaunay-based quality tetrahedral mesh generator* (2015), section "File formats".
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = coface_io::tetgen::read(&b"3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n"[..])?;
/// assert_eq!((model.vertex_count(), model.positions().dimension()), (3, 2));
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    read_beside(input, None, None)
}

/// Reads a file of this path: nodes that it lacks are those of the file beside it.
pub(crate) fn read_beside(
    input: impl Read,
    path: Option<&Path>,
    companions: Option<&Companions>,
) -> Result<Model, Error> {
    let part = path.map_or(Part::Nodes, Part::of_path);
    let mut file = Numbered::new(input);
    let mut mesh = Mesh::default();
    if matches!(part, Part::Nodes | Part::Poly) && !mesh.read_nodes(&mut file)?
        || !matches!(part, Part::Nodes | Part::Poly)
    {
        mesh.read_nodes_beside(path.zip(companions))?;
    }
    match part {
        // Behind the nodes of a stream, the facets of a complex may follow.
        Part::Nodes if path.is_some() || file.peek()?.is_none() => {}
        Part::Nodes | Part::Poly => mesh.read_facets(&mut file)?,
        Part::Elements => mesh.read_elements(&mut file, None)?,
        Part::Faces => mesh.read_elements(&mut file, Some(3))?,
        Part::Edges => mesh.read_elements(&mut file, Some(2))?,
    }
    let attributes = mesh.attributes;
    let polygon_count = mesh.assembly.count_of(GroupKind::Polygons);
    let mut model = mesh.assembly.finish()?;
    if !mesh.surfaces.is_empty() && model.polygons().len() == polygon_count {
        model.stated = Some(Arc::new(mesh.surfaces.finish(&model, 0)?));
    }
    if attributes > 0 {
        model.unread.push(("attributes of nodes", attributes));
    }
    Ok(model)
}

/// Lines of numbers; `#` starts a comment.
struct Numbered<R> {
    input: BufReader<R>,
    line: u64,
    /// The words of a line that was looked at.
    ahead: Option<Vec<String>>,
}

impl<R: Read> Numbered<R> {
    fn new(input: R) -> Self {
        Self { input: BufReader::new(input), line: 0, ahead: None }
    }

    /// The words of the next line that has some.
    fn next(&mut self) -> Result<Option<Vec<String>>, Error> {
        if let Some(ahead) = self.ahead.take() {
            return Ok(Some(ahead));
        }
        loop {
            let mut bytes = Vec::new();
            let count =
                (&mut self.input).take(crate::scanner::LONGEST as u64).read_until(b'\n', &mut bytes)?;
            if count == 0 {
                return Ok(None);
            }
            self.line += 1;
            let text = String::from_utf8_lossy(&bytes);
            let text = text.split('#').next().unwrap_or_default();
            let words: Vec<String> = text
                .split([' ', '\t', '\r', '\n', ','])
                .filter(|w| !w.is_empty())
                .map(str::to_owned)
                .collect();
            if !words.is_empty() {
                return Ok(Some(words));
            }
        }
    }

    fn peek(&mut self) -> Result<Option<&[String]>, Error> {
        self.ahead = self.next()?;
        Ok(self.ahead.as_deref())
    }

    /// The next line, which must be there.
    fn expect(&mut self, what: &str) -> Result<Vec<String>, Error> {
        match self.next()? {
            Some(words) => Ok(words),
            None => Err(Error::parse(format!("the file ends where {what} should be"))
                .at_line(self.line)
                .with_cure("it was cut short: write it again")),
        }
    }

    fn integer(&self, words: &[String], place: usize, what: &str) -> Result<i64, Error> {
        let Some(word) = words.get(place) else {
            return Err(Error::parse(format!("a line ends where {what} should be")).at_line(self.line));
        };
        parse_i64(word.as_bytes(), what).map_err(|error| error.at_line(self.line))
    }

    fn count(&self, words: &[String], place: usize, what: &str) -> Result<u64, Error> {
        let count = self.integer(words, place, what)?;
        u64::try_from(count)
            .map_err(|_| Error::parse(format!("{what} is {count}; it cannot be negative")).at_line(self.line))
    }
}

#[derive(Default)]
struct Mesh {
    assembly: Assembly,
    dimension: usize,
    /// The attributes of nodes and elements, which are not read.
    attributes: usize,
    /// The vertices by the numbers of the file.
    vertices: HashMap<i64, u32>,
    /// The surfaces of facets, where one has rings inside of others.
    surfaces: SurfaceCollector,
}

impl Mesh {
    /// Reads nodes; false if the file says that they are elsewhere.
    fn read_nodes<R: Read>(&mut self, file: &mut Numbered<R>) -> Result<bool, Error> {
        let head = file.expect("the count of nodes")?;
        let count = file.count(&head, 0, "the count of nodes")?;
        if count == 0 {
            return Ok(false);
        }
        let dimension = if head.len() > 1 { file.count(&head, 1, "the dimension")? } else { 3 };
        let attributes = if head.len() > 2 { file.count(&head, 2, "the count of attributes")? } else { 0 };
        let has_markers = head.len() > 3 && file.count(&head, 3, "the count of markers")? > 0;
        self.dimension = match dimension {
            2 | 3 => dimension as usize,
            _ => {
                let message = format!("the dimension is {dimension}; TetGen has 2 and 3");
                return Err(Error::new(ErrorKind::UnsupportedFormat, message).at_line(file.line));
            }
        };
        self.assembly = Assembly::new(self.dimension);
        self.attributes += attributes.saturating_mul(count) as usize;
        for _ in 0..count {
            let words = file.expect("a node")?;
            let number = file.integer(&words, 0, "the number of a node")?;
            let mut point = [0.0; 3];
            for (axis, x) in point[..self.dimension].iter_mut().enumerate() {
                let Some(word) = words.get(axis + 1) else {
                    return Err(Error::parse(format!(
                        "a node with {axis} coordinates; it needs {dimension}"
                    ))
                    .at_line(file.line));
                };
                let value = parse_coordinate(word.as_bytes(), "a coordinate");
                *x = value.map_err(|error| error.at_line(file.line))?;
            }
            let vertex = self.assembly.vertex_count() as u32;
            self.assembly.add_vertex_on_line(&point[..self.dimension], Some(file.line))?;
            if self.vertices.insert(number, vertex).is_some() {
                return Err(Error::invalid(format!("node {number} stands twice")).at_line(file.line));
            }
            let marker = self.dimension + 1 + attributes as usize;
            if has_markers && marker < words.len() {
                self.mark(file, &words, marker, GroupKind::Vertices, vertex)?;
            }
        }
        Ok(true)
    }

    /// Reads the nodes of the file of the same name that ends in `.node`.
    fn read_nodes_beside(&mut self, beside: Option<(&Path, &Companions)>) -> Result<(), Error> {
        let Some((path, companions)) = beside else {
            return Err(Error::invalid(
                "the nodes are in another file, and the place of this one is not known",
            )
            .with_cure("give the path of the file"));
        };
        let path = path.with_extension("node");
        let file = companions.open(Path::new(path.file_name().unwrap_or_default())).map_err(|error| {
            let cure = error.cure().unwrap_or("put it beside the file").to_owned();
            let message = format!("the nodes are in {}: {}", path.display(), error.message());
            Error::new(error.kind(), message).with_cure(cure)
        })?;
        self.read_nodes(&mut Numbered::new(file))
            .map_err(|error| error.in_file(path.display().to_string()))?;
        Ok(())
    }

    fn vertex<R: Read>(&self, file: &Numbered<R>, words: &[String], place: usize) -> Result<u32, Error> {
        let number = file.integer(words, place, "a node")?;
        self.vertices.get(&number).copied().ok_or_else(|| {
            Error::invalid(format!("node {number} is not among the nodes"))
                .at_line(file.line)
                .with_cure("the file is damaged, or was written wrongly: write it again")
        })
    }

    /// Puts a member into the group of a marker that is not 0.
    fn mark<R: Read>(
        &mut self,
        file: &Numbered<R>,
        words: &[String],
        place: usize,
        kind: GroupKind,
        member: u32,
    ) -> Result<(), Error> {
        let word = words[place].as_bytes();
        let marker = match parse_i64(word, "a marker") {
            Ok(marker) => marker,
            Err(fault) => match parse_f64(word, "a marker") {
                Ok(marker) if marker.fract() == 0.0 && marker.abs() < 9e15 => marker as i64,
                _ => return Err(fault.at_line(file.line)),
            },
        };
        if marker != 0 {
            self.assembly.add_to_group(kind, marker, member);
        }
        Ok(())
    }

    fn add(
        &mut self,
        line: u64,
        kind: Kind,
        corner_count: usize,
        vertices: &[u32],
    ) -> Result<Option<u32>, Error> {
        self.assembly.add(kind, corner_count, vertices, u64::from).map_err(|fault| fault.at_line(line))
    }

    /// Reads elements of so many nodes: without that number, their count stands in the head.
    fn read_elements<R: Read>(&mut self, file: &mut Numbered<R>, size: Option<usize>) -> Result<(), Error> {
        let head = file.expect("the count of elements")?;
        let count = file.count(&head, 0, "the count of elements")?;
        let stated = match size {
            Some(size) => size as u64,
            None if head.len() > 1 => file.count(&head, 1, "the count of nodes of an element")?,
            None => self.dimension as u64 + 1,
        };
        let (kind, corners) = match (self.dimension, stated) {
            (_, 2) => (Kind::Line, 2),
            (3, 4 | 10) => (Kind::TETRAHEDRON, 4),
            (_, 3 | 6) => (Kind::Polygon, 3),
            _ => {
                let message = format!("elements of {stated} nodes are not known here");
                return Err(Error::new(ErrorKind::UnsupportedFormat, message).at_line(file.line));
            }
        };
        let size = stated as usize;
        for _ in 0..count {
            let words = file.expect("an element")?;
            let vertices: Result<Vec<u32>, Error> =
                (0..size).map(|i| self.vertex(file, &words, i + 1)).collect();
            let vertices = vertices?;
            let member = self.add(file.line, kind, corners, &vertices)?;
            if let (Some(member), true) = (member, words.len() > size + 1) {
                self.mark(file, &words, size + 1, kind.group_kind(), member)?;
            }
        }
        Ok(())
    }

    /// Reads the facets of a solid, or the segments of a plane. Holes and regions of the volume are points, which make no difference here.
    fn read_facets<R: Read>(&mut self, file: &mut Numbered<R>) -> Result<(), Error> {
        let head = file.expect("the count of facets")?;
        let count = file.count(&head, 0, "the count of facets")?;
        let has_markers = head.len() > 1 && file.count(&head, 1, "the count of markers")? > 0;
        let mut facets = Facets::default();
        let mut has_rings = false;
        for _ in 0..count {
            let words = file.expect("a facet")?;
            if self.dimension == 2 {
                let ends = [self.vertex(file, &words, 1)?, self.vertex(file, &words, 2)?];
                let member = self.add(file.line, Kind::Line, 2, &ends)?;
                if let (Some(member), true) = (member, words.len() > 3) {
                    self.mark(file, &words, 3, GroupKind::Lines, member)?;
                }
                continue;
            }
            let mut facet = self.read_facet(file, &words)?;
            facets.divide(&mut facet, |vertex| self.assembly.position(vertex));
            has_rings |= facet.surfaces.iter().any(|rings| rings.len() > 1);
            for (place, (line, polygon)) in facet.polygons.iter().enumerate() {
                let kind = match polygon.len() {
                    0 => continue,
                    1 => Kind::Point,
                    2 => Kind::Line,
                    _ => Kind::Polygon,
                };
                let first = self.assembly.count_of(GroupKind::Polygons);
                let member = self.add(*line, kind, polygon.len(), polygon)?;
                let rings = match facet.surfaces.get(place) {
                    None => std::slice::from_ref(polygon),
                    Some(rings) => &rings[..],
                };
                if !rings.is_empty() && self.assembly.count_of(GroupKind::Polygons) > first {
                    self.surfaces.add(rings, first);
                }
                if let (Some(member), true) = (member, has_markers && words.len() > 2) {
                    self.mark(file, &words, 2, kind.group_kind(), member)?;
                }
            }
        }
        self.assembly.remarks.extend(facets.into_remarks());
        if !has_rings {
            self.surfaces = SurfaceCollector::default();
        }
        Ok(())
    }

    /// Reads the polygons and the hole points of a facet whose first line has these words.
    fn read_facet<R: Read>(&self, file: &mut Numbered<R>, words: &[String]) -> Result<Facet, Error> {
        let polygons = file.count(words, 0, "the count of polygons of a facet")?;
        let holes = if words.len() > 1 { file.count(words, 1, "the count of holes of a facet")? } else { 0 };
        let mut facet = Facet { line: file.line, ..Facet::default() };
        for _ in 0..polygons {
            let line = file.expect("a polygon of a facet")?;
            let mut corners = file.count(&line, 0, "the count of corners of a polygon")?;
            let mut vertices = Vec::new();
            let (mut line, mut place) = (line, 1);
            while corners > 0 {
                if place == line.len() {
                    (line, place) = (file.expect("a corner of a polygon")?, 0);
                }
                vertices.push(self.vertex(file, &line, place)?);
                (place, corners) = (place + 1, corners - 1);
            }
            facet.polygons.push((file.line, vertices));
        }
        for _ in 0..holes {
            let words = file.expect("a hole of a facet")?;
            let mut hole = [0.0; 3];
            for (axis, x) in hole.iter_mut().enumerate() {
                let Some(word) = words.get(axis + 1) else {
                    return Err(Error::parse(format!(
                        "a hole of a facet with {axis} coordinates; it needs 3"
                    ))
                    .at_line(file.line));
                };
                *x = parse_coordinate(word.as_bytes(), "a coordinate")
                    .map_err(|error| error.at_line(file.line))?;
            }
            facet.holes.push(hole);
        }
        Ok(facet)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solid_of_facets_is_read() {
        let text = "# a tetrahedron\n4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n4 1\n1 0 7\n3 1 2 3\n1 0 7\n3 1 2\n4\n\
                    1\n3 2 3 4\n1\n3 1 3 4\n0\n0\n";
        let model = read_beside(text.as_bytes(), Some(Path::new("a.poly")), None).unwrap();
        assert_eq!((model.vertex_count(), model.polygons().len(), model.lines().len()), (4, 4, 0));
        assert_eq!((model.groups()[0].name(), model.groups()[0].members()), ("7", &[0, 1][..]));
        let plane = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n";
        let model = read_beside(plane.as_bytes(), Some(Path::new("a.poly")), None).unwrap();
        assert_eq!((model.lines().len(), model.positions().dimension()), (3, 2));
        let error = read_beside(&b"4 3 0 0\n1 0 0 0\n"[..], Some(Path::new("a.node")), None).unwrap_err();
        assert!(error.to_string().contains("line 2: the file ends where a node should be"), "{error}");
    }

    #[test]
    fn facets_with_holes_make_a_tunnel() {
        // A box of side 4 with a square tunnel of side 2 through it: a torus of area 2 (16 - 4) + 16 * 4 + 8 * 4.
        let mut text = "16 3 0 0\n".to_owned();
        for (i, [x, y]) in [[0, 0], [4, 0], [4, 4], [0, 4], [1, 1], [3, 1], [3, 3], [1, 3]].iter().enumerate()
        {
            text += &format!("{} {x} {y} 0\n{} {x} {y} 4\n", 2 * i + 1, 2 * i + 2);
        }
        text += "10 1\n2 1 5\n4 1 7 5 3\n4 9 11 13 15\n1 2 2 0\n2 1 5\n4 2 4 6 8\n4 10 16 14 12\n1 2 2 4\n";
        for side in [
            "1 3 4 2",
            "3 5 6 4",
            "5 7 8 6",
            "7 1 2 8",
            "11 9 10 12",
            "13 11 12 14",
            "15 13 14 16",
            "9 15 16 10",
        ] {
            text += &format!("1 0 1\n4 {side}\n");
        }
        let model = read_beside(format!("{text}0\n0\n").as_bytes(), Some(Path::new("a.poly")), None).unwrap();
        assert_eq!((model.vertex_count(), model.polygons().len()), (16, 2 * 8 + 8));
        assert_eq!(model.groups()[1].members().len(), 16, "the triangles have the marker of their facet");
        let area = coface_geometry::polygon_area(model.positions(), model.polygons());
        assert_eq!(area, Some(120.0));
        assert_eq!(model.remarks()[0].message, "2 facets have polygons inside of others: read as triangles");
        let stated = model.stated_surfaces().unwrap().faces();
        assert_eq!((stated.face_count(), stated.rings().len()), (10, 12));
    }

    #[test]
    fn elements_find_their_nodes_beside_them() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        std::fs::write(path("a.node"), "4 3 0 1\n0 0 0 0 0\n1 1 0 0 0\n2 0 1 0 5\n3 0 0 1 0\n").unwrap();
        std::fs::write(path("a.ele"), "1 4 1\n0 0 1 2 3 9.0\n").unwrap();
        std::fs::write(path("a.face"), "1 1\n0 0 1 2 -1\n").unwrap();
        let model = crate::read_path(path("a.ele"), None).unwrap();
        assert_eq!((model.cells().len(), model.groups().len()), (1, 2));
        let model = crate::read_path(path("a.face"), None).unwrap();
        assert_eq!((model.polygons().len(), model.groups()[1].name()), (1, "-1"));
        std::fs::rename(path("a.node"), path("b.node")).unwrap();
        assert!(crate::read_path(path("a.ele"), None).unwrap_err().to_string().contains("a.node"));
    }
}
