//! AMF: meshes in XML, plain or in a ZIP archive, with constellations that place them.

use crate::Model;
use crate::decimal::{flush, push_f64};
use crate::print_objects::{PrintObjects, color, escaped, point};
use coface_algebra::Error;
use std::io::{Read, Write};

/// Reads all constellations that no other one names, with their objects where they place them, and the objects that none places as they
/// stand. An object with a name is a [`Group`](crate::Group) of polygons; volumes of an object are put together. Triangles are flat: normals
/// and edges that curve them are left out, which a remark says. The unit is that of the file.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for what is no XML or a number out of place;
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for an object that is not there, a constellation that contains itself,
/// or a triangle of a vertex that is not there;
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) for an archive without such a file.
///
/// # Complexity
/// Linear in the unpacked file and the placed meshes.
///
/// # References
/// ISO/ASTM 52915, *Specification for additive manufacturing file format (AMF)*, version 1.2.
///
/// # Examples
/// ```
/// # #[cfg(feature = "xml")]
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let point = |x, y| format!("<vertex><coordinates><x>{x}</x><y>{y}</y><z>0</z></coordinates></vertex>");
/// let text = format!(
///     "<amf><object id='1'><mesh><vertices>{}{}{}</vertices>\
///      <volume><triangle><v1>0</v1><v2>1</v2><v3>2</v3></triangle></volume></mesh></object></amf>",
///     point(0, 0), point(1, 0), point(0, 1)
/// );
/// assert_eq!(coface_io::amf::read(text.as_bytes())?.polygons().list(0), [0, 1, 2]);
/// # Ok(()) }
/// # #[cfg(not(feature = "xml"))]
/// # fn main() {}
/// ```
#[cfg(feature = "xml")]
pub fn read(input: impl Read) -> Result<Model, Error> {
    reading::read(input)
}

/// Refuses every file: this build lacks the feature `xml`.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat), always.
#[cfg(not(feature = "xml"))]
pub fn read(_input: impl Read) -> Result<Model, Error> {
    Err(crate::features::without_xml("AMF"))
}

/// Writes the polygons of a model in AMF, as triangles, in millimeters.
///
/// Coordinates are written so that they read back bit for bit; fewer than three are filled up with zeros. Parts that are connected by vertices
/// and lie whole in a [`Group`](crate::Group) of polygons are an object of its name, and all others are one object. A polygon of more than three vertices is cut into triangles
/// on its own vertices. Data `red`, `green` and `blue` on vertices, a byte each, are colors of vertices. [`losses`](crate::losses) says
/// what a model loses.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) if the model has lines, points, 3-cells, no positions or more than
/// three coordinates a vertex, or is an abstract structure; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for
/// coordinates that are not finite; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) if the stream fails.
///
/// # Complexity
/// $O(n \log n)$ in the corners.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = coface_io::obj::read("v 0 0 0\nv 1 0 0\nv 0 0.1 0\nf 1 2 3\n".as_bytes())?;
/// let mut written = Vec::new();
/// coface_io::amf::write(&triangle, &mut written)?;
/// assert!(String::from_utf8_lossy(&written).contains("<y>0.1</y>"));
/// # Ok(()) }
/// ```
pub fn write(model: &Model, mut output: impl Write) -> Result<(), Error> {
    let objects = PrintObjects::of(model, "AMF")?;
    let mut text =
        b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<amf unit=\"millimeter\" version=\"1.1\">\n".to_vec();
    let number = |text: &mut Vec<u8>, name: &str, value: f64| {
        text.extend_from_slice(format!("<{name}>").as_bytes());
        push_f64(text, value);
        text.extend_from_slice(format!("</{name}>").as_bytes());
    };
    for (id, object) in objects.objects.iter().enumerate() {
        text.extend_from_slice(format!("<object id=\"{}\">", id + 1).as_bytes());
        if !object.name.is_empty() {
            let name = escaped(&object.name);
            text.extend_from_slice(format!("<metadata type=\"name\">{name}</metadata>").as_bytes());
        }
        text.extend_from_slice(b"<mesh>\n<vertices>\n");
        for &vertex in &object.vertices {
            text.extend_from_slice(b"<vertex><coordinates>");
            for (axis, x) in ["x", "y", "z"].into_iter().zip(point(model, vertex)) {
                number(&mut text, axis, x);
            }
            text.extend_from_slice(b"</coordinates>");
            if let Some(color) = color(model, vertex) {
                text.extend_from_slice(b"<color>");
                for (part, byte) in ["r", "g", "b"].into_iter().zip(color) {
                    number(&mut text, part, f64::from(byte) / 255.0);
                }
                text.extend_from_slice(b"</color>");
            }
            text.extend_from_slice(b"</vertex>\n");
            flush(&mut text, &mut output)?;
        }
        text.extend_from_slice(b"</vertices>\n<volume>\n");
        for triangle in &object.triangles {
            text.extend_from_slice(b"<triangle>");
            for (corner, vertex) in ["v1", "v2", "v3"].into_iter().zip(triangle) {
                number(&mut text, corner, f64::from(*vertex));
            }
            text.extend_from_slice(b"</triangle>\n");
            flush(&mut text, &mut output)?;
        }
        text.extend_from_slice(b"</volume>\n</mesh></object>\n");
    }
    text.extend_from_slice(b"</amf>\n");
    output.write_all(&text)?;
    output.flush()?;
    Ok(())
}

#[cfg(feature = "xml")]
mod reading {
    use crate::scanner::quoted;
    use crate::scene::{LooseMesh, Placement, Scene};
    use crate::xml_text::document;
    use crate::{Model, Place, Remark, RemarkCode};
    use coface_algebra::Error;
    use roxmltree::Node;
    use std::collections::{BTreeMap, HashSet};
    use std::io::Read;

    pub(super) fn read(mut input: impl Read) -> Result<Model, Error> {
        let mut bytes = Vec::new();
        input.read_to_end(&mut bytes)?;
        if bytes.starts_with(b"PK") {
            bytes = unpacked(bytes)?;
        }
        let text = String::from_utf8(bytes).map_err(|error| {
            Error::parse("the file is no text in UTF-8")
                .at_byte(error.utf8_error().valid_up_to() as u64)
                .with_cure("write it again in UTF-8")
        })?;
        let document = document(&text)?;
        let mut curves = Curves::default();
        let mut things = BTreeMap::new();
        let mut order = Vec::new();
        for node in document.root_element().children() {
            let thing = match node.tag_name().name() {
                "object" => Thing::Object(name(node), mesh(node, &mut curves)?),
                "constellation" => Thing::Constellation(instances(node)?),
                _ => continue,
            };
            let id = node.attribute("id").unwrap_or_default();
            order.push(id);
            if things.insert(id, thing).is_some() {
                let message = format!("two things have the id {}", quoted(id.as_bytes()));
                return Err(
                    at(node, message).with_cure("give each object and constellation an id of its own")
                );
            }
        }
        let named: HashSet<&str> = things
            .values()
            .flat_map(|thing| match thing {
                Thing::Constellation(instances) => instances.as_slice(),
                Thing::Object(..) => &[],
            })
            .map(|&(id, _)| id)
            .collect();
        let mut scene = Scene::of_size(text.len());
        let mut placed = HashSet::new();
        for id in order.iter().copied().filter(|id| !named.contains(id)) {
            place(&things, id, Placement::IDENTITY, 0, &mut scene, &mut placed)?;
        }
        // What is named and still not placed is named in a circle, and the way along that ends in an error.
        for id in order {
            if !placed.contains(id) {
                place(&things, id, Placement::IDENTITY, 0, &mut scene, &mut placed)?;
            }
        }
        let mut model = scene.finish()?;
        model.remarks.extend(curves.remark());
        Ok(model)
    }

    /// What curves triangles: they are read by their corners.
    #[derive(Default)]
    struct Curves {
        edges: usize,
        normals: usize,
        /// Where the first of them is.
        first: Option<u64>,
    }

    impl Curves {
        /// Notes an edge with tangents or a normal.
        fn note(&mut self, node: Node<'_, '_>) {
            let is_edge = node.tag_name().name() == "edge";
            *if is_edge { &mut self.edges } else { &mut self.normals } += 1;
            let line = line(node);
            self.first = Some(self.first.map_or(line, |first| first.min(line)));
        }

        fn remark(&self) -> Option<Remark> {
            let first = self.first?;
            let counted = |count: usize, one: &str, several: &str| match count {
                0 => None,
                1 => Some(format!("1 {one}")),
                _ => Some(format!("{count} {several}")),
            };
            let what = [
                counted(self.edges, "edge with tangents", "edges with tangents"),
                counted(self.normals, "normal at a vertex", "normals at vertices"),
            ];
            let what = what.into_iter().flatten().collect::<Vec<_>>().join(" and ");
            let count = self.edges + self.normals;
            let (curves, is) = if count == 1 { ("curves", "is") } else { ("curve", "are") };
            let message = format!(
                "{what}, which {curves} triangles, {is} left out: triangles are flat here, with straight edges; the first is on \
                 line {first}"
            );
            Some(Remark::new(RemarkCode::HigherOrder, message).at(count, [Place::line(first)]))
        }
    }

    /// The file in an archive.
    #[cfg(feature = "archives")]
    fn unpacked(bytes: Vec<u8>) -> Result<Vec<u8>, Error> {
        use coface_algebra::ErrorKind;
        let most = crate::unpacking::most_unpacked(bytes.len() as u64);
        let damaged = |error: zip::result::ZipError| {
            Error::parse(format!("the ZIP archive is damaged: {error}")).with_cure("write it again")
        };
        let mut archive = zip::ZipArchive::new(std::io::Cursor::new(bytes)).map_err(damaged)?;
        let name = archive.file_names().find(|name| name.to_ascii_lowercase().ends_with(".amf"));
        let Some(name) = name.map(str::to_owned) else {
            let message = "this is a ZIP archive without an AMF file in it";
            return Err(Error::new(ErrorKind::UnsupportedFormat, message)
                .with_cure("unpack it and name the file of the model"));
        };
        let mut text = Vec::new();
        archive.by_name(&name).map_err(damaged)?.take(most + 1).read_to_end(&mut text).map_err(|error| {
            Error::parse(format!("the part {} cannot be read: {error}", name.escape_debug()))
                .with_cure("write the file again")
        })?;
        if text.len() as u64 > most {
            return Err(Error::new(ErrorKind::TooLarge, "the file is far larger than its archive")
                .with_cure("the file is no model: check where it comes from"));
        }
        Ok(text)
    }

    #[cfg(not(feature = "archives"))]
    fn unpacked(_bytes: Vec<u8>) -> Result<Vec<u8>, Error> {
        Err(crate::features::without_feature("AMF in an archive", "archives"))
    }

    enum Thing<'t> {
        Object(String, LooseMesh),
        Constellation(Vec<(&'t str, Placement)>),
    }

    /// The elements of this name right below one.
    fn parts<'a, 'i>(node: Node<'a, 'i>, name: &'static str) -> impl Iterator<Item = Node<'a, 'i>> {
        node.children().filter(move |part| part.tag_name().name() == name)
    }

    /// What the metadata call an object.
    fn name(node: Node<'_, '_>) -> String {
        let name = parts(node, "metadata").find(|part| part.attribute("type") == Some("name"));
        name.and_then(|part| part.text()).unwrap_or_default().trim().to_owned()
    }

    /// The number in the first part of this name, if there is one.
    fn number(node: Node<'_, '_>, name: &'static str) -> Result<Option<f64>, Error> {
        let Some(part) = parts(node, name).next() else { return Ok(None) };
        let word = part.text().unwrap_or_default().trim();
        match word.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(Some(number)),
            _ => Err(at(part, format!("{} is no finite number, as {name} must be", quoted(word.as_bytes())))
                .with_cure("write the file again")),
        }
    }

    fn line(node: Node<'_, '_>) -> u64 {
        u64::from(node.document().text_pos_at(node.range().start).row)
    }

    fn at(node: Node<'_, '_>, message: String) -> Error {
        Error::parse(message).at_line(line(node))
    }

    fn missing(node: Node<'_, '_>, name: &str) -> Error {
        at(node, format!("a {} without {name}", node.tag_name().name())).with_cure("write the file again")
    }

    fn mesh(object: Node<'_, '_>, curves: &mut Curves) -> Result<LooseMesh, Error> {
        let mut mesh = LooseMesh::default();
        let meshes: Vec<Node<'_, '_>> = parts(object, "mesh").collect();
        let all = |list: &'static str, item: &'static str| {
            meshes.iter().flat_map(move |&mesh| parts(mesh, list)).flat_map(move |list| parts(list, item))
        };
        for vertex in all("vertices", "vertex") {
            let place = parts(vertex, "coordinates").next().ok_or_else(|| missing(vertex, "coordinates"))?;
            let mut point = [0.0; 3];
            for (axis, x) in ["x", "y", "z"].into_iter().zip(&mut point) {
                *x = number(place, axis)?.ok_or_else(|| missing(place, axis))?;
            }
            mesh.points.push(point);
            parts(vertex, "normal").for_each(|normal| curves.note(normal));
        }
        all("vertices", "edge").for_each(|edge| curves.note(edge));
        let count = mesh.points.len();
        for triangle in all("volume", "triangle") {
            let mut corners = Vec::with_capacity(3);
            for corner in ["v1", "v2", "v3"] {
                let vertex = number(triangle, corner)?.ok_or_else(|| missing(triangle, corner))?;
                if !(vertex >= 0.0 && vertex < count as f64 && vertex.fract() == 0.0) {
                    return Err(Error::invalid(format!(
                        "a triangle names vertex {vertex}, but its object has {count} vertices, numbered from 0"
                    ))
                    .at_line(line(triangle))
                    .with_cure("correct the index"));
                }
                corners.push(vertex as u32);
            }
            mesh.polygons.push(corners);
        }
        Ok(mesh)
    }

    /// The objects that a constellation places, and where: turned about x, y and z, then moved.
    fn instances<'t>(node: Node<'t, '_>) -> Result<Vec<(&'t str, Placement)>, Error> {
        let mut instances = Vec::new();
        for instance in parts(node, "instance") {
            let of = |name| Ok::<f64, Error>(number(instance, name)?.unwrap_or(0.0));
            let mut placement = Placement::IDENTITY;
            for (name, axis) in [("rx", 0), ("ry", 1), ("rz", 2)] {
                placement = turn(axis, of(name)?).after(placement);
            }
            for (row, name) in ["deltax", "deltay", "deltaz"].into_iter().enumerate() {
                placement.0[row][3] = of(name)?;
            }
            let id = instance.attribute("objectid").ok_or_else(|| missing(instance, "objectid"))?;
            instances.push((id, placement));
        }
        Ok(instances)
    }

    /// The turn about an axis by so many degrees; quarters of a turn are exact.
    fn turn(axis: usize, degrees: f64) -> Placement {
        let (sine, cosine) = match degrees.rem_euclid(360.0) {
            0.0 => (0.0, 1.0),
            90.0 => (1.0, 0.0),
            180.0 => (0.0, -1.0),
            270.0 => (-1.0, 0.0),
            _ => degrees.to_radians().sin_cos(),
        };
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut turn = Placement::IDENTITY;
        turn.0[next][next] = cosine;
        turn.0[next][last] = -sine;
        turn.0[last][next] = sine;
        turn.0[last][last] = cosine;
        turn
    }

    fn place<'t>(
        things: &BTreeMap<&str, Thing<'t>>,
        id: &'t str,
        placement: Placement,
        depth: usize,
        scene: &mut Scene,
        placed: &mut HashSet<&'t str>,
    ) -> Result<(), Error> {
        scene.step(depth)?;
        placed.insert(id);
        match things.get(id) {
            Some(Thing::Object(name, mesh)) => scene.place(mesh, placement, name),
            Some(Thing::Constellation(instances)) => instances.iter().try_for_each(|&(inner, at)| {
                place(things, inner, placement.after(at), depth + 1, scene, placed)
            }),
            None => Err(Error::invalid(format!("the object {} is not there", quoted(id.as_bytes())))
                .with_cure("write the file again")),
        }
    }
}

#[cfg(all(test, feature = "xml"))]
mod tests {
    use crate::RemarkCode;

    fn triangle(normals: [&str; 3], edges: &str) -> String {
        let points = [(0, 0), (1, 0), (0, 1)].iter().zip(normals).map(|((x, y), normal)| {
            format!("<vertex><coordinates><x>{x}</x><y>{y}</y><z>0</z></coordinates>{normal}</vertex>\n")
        });
        let points = points.collect::<String>();
        format!(
            "<amf><object id='1'><mesh><vertices>\n{points}{edges}</vertices>\
             <volume><triangle><v1>0</v1><v2>1</v2><v3>2</v3></triangle></volume></mesh></object></amf>"
        )
    }

    #[test]
    fn curved_triangles_are_flat_and_told() {
        let normal = "<normal><nx>0</nx><ny>0.6</ny><nz>0.8</nz></normal>";
        let edge = "<edge><v1>0</v1><dx1>1</dx1><dy1>1</dy1><dz1>0</dz1>\
             <v2>1</v2><dx2>1</dx2><dy2>-1</dy2><dz2>0</dz2></edge>";
        let of = |normals, edges| super::read(triangle(normals, edges).as_bytes()).unwrap();
        assert_eq!(of([""; 3], "").remarks().len(), 0);
        for (normals, edges, count, message) in [
            (
                ["", normal, normal],
                edge,
                3,
                "1 edge with tangents and 2 normals at vertices, which curve triangles, are",
            ),
            ([""; 3], edge, 1, "1 edge with tangents, which curves triangles, is left out"),
            ([""; 3], &edge.repeat(2), 2, "2 edges with tangents, which curve triangles, are left out"),
            (["", normal, ""], "", 1, "1 normal at a vertex, which curves triangles, is left out"),
        ] {
            let model = of(normals, edges);
            assert_eq!((model.vertex_count(), model.polygons().list(0)), (3, &[0, 1, 2][..]));
            let [remark] = model.remarks() else { panic!("{:?}", model.remarks()) };
            assert_eq!((remark.code, remark.count), (RemarkCode::HigherOrder, count));
            assert!(remark.message.starts_with(message), "{}", remark.message);
            let line = if normals[1].is_empty() { 5 } else { 3 };
            assert!(remark.message.ends_with(&format!("the first is on line {line}")), "{}", remark.message);
        }
    }
}
