//! 3MF: meshes in XML in a ZIP archive, with components and build items that place them.

use crate::Model;
use coface_algebra::Error;
use std::io::{Read, Write};

/// Reads all build items of a 3MF file, each at its place; without build items, all objects that are meshes. An object with a name is a
/// [`Group`](crate::Group) of polygons. Beams are lines.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for what is no ZIP archive or no XML;
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) for a file that requires an extension that is not known here;
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for an object that is not there or contains itself, or a triangle
/// of a vertex that is not there.
///
/// # Complexity
/// Linear in the unpacked file and the placed meshes.
///
/// # References
/// 3MF Consortium, *3D Manufacturing Format, core specification*, version 1.3.
///
/// # Examples
/// ```
/// assert!(coface_io::three_mf::read(&b"no archive"[..]).is_err());
/// ```
#[cfg(feature = "archives")]
pub fn read(input: impl Read) -> Result<Model, Error> {
    reading::read(input)
}

/// Refuses every file: this build lacks the feature `archives`.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat), always.
#[cfg(not(feature = "archives"))]
pub fn read(_input: impl Read) -> Result<Model, Error> {
    Err(crate::features::without_feature("3MF", "archives"))
}

/// Writes the polygons of a model in 3MF, as triangles, in millimeters.
///
/// Coordinates are written so that they read back bit for bit; fewer than three are filled up with zeros. Parts that are connected by vertices
/// and lie whole in a [`Group`](crate::Group) of polygons are an object of its name, and all others are one object. Objects that are closed and coherently oriented are
/// of the type `model`, others of the type `surface`. A polygon of more than three vertices is cut into triangles on its own vertices. Data
/// `red`, `green` and `blue` on vertices, a byte each, are a group of colors. [`losses`](crate::losses) says what a model loses.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) if the model has lines, points, 3-cells, no positions or more than
/// three coordinates a vertex, or is an abstract structure, and in a build without the feature `archives`;
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for coordinates that are not finite;
/// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) if the stream fails.
///
/// # Complexity
/// $O(n \log n)$ in the corners. The archive is in memory until it is whole.
///
/// # References
/// 3MF Consortium, *3D Manufacturing Format, core specification*, version 1.3, and *materials and properties extension*, version 1.2.1.
///
/// # Examples
/// ```
/// # #[cfg(feature = "archives")]
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = coface_io::obj::read("v 0 0 0\nv 1 0 0\nv 0 0.1 0\nf 1 2 3\n".as_bytes())?;
/// let mut written = Vec::new();
/// coface_io::three_mf::write(&triangle, &mut written)?;
/// assert_eq!(coface_io::three_mf::read(&written[..])?, triangle);
/// # Ok(()) }
/// # #[cfg(not(feature = "archives"))]
/// # fn main() {}
/// ```
#[cfg(feature = "archives")]
pub fn write(model: &Model, output: impl Write) -> Result<(), Error> {
    writing::write(model, output)
}

/// Refuses every model: this build lacks the feature `archives`.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat), always.
#[cfg(not(feature = "archives"))]
pub fn write(_model: &Model, _output: impl Write) -> Result<(), Error> {
    Err(crate::features::without_feature("3MF", "archives"))
}

#[cfg(feature = "archives")]
mod writing {
    use crate::Model;
    use crate::decimal::{flush, push_f64};
    use crate::print_objects::{PrintObjects, color, escaped, point};
    use coface_algebra::Error;
    use std::collections::BTreeMap;
    use std::io::{Cursor, Write};
    use zip::ZipWriter;
    use zip::write::SimpleFileOptions;

    const TYPES: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
        <Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\
        <Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\
        <Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\
        </Types>\n";
    const RELATIONS: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
        <Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\
        <Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" \
        Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";
    const OPEN: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
        <model unit=\"millimeter\" xml:lang=\"en-US\" \
        xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" \
        xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">\n<resources>\n";

    pub(super) fn write(model: &Model, mut output: impl Write) -> Result<(), Error> {
        let objects = PrintObjects::of(model, "3MF")?;
        let failed = |error: zip::result::ZipError| Error::from(std::io::Error::other(error));
        // The same model is the same file: parts have no time.
        let options = SimpleFileOptions::default()
            .last_modified_time(zip::DateTime::default())
            .large_file(model.polygons.items().len() > 1 << 24);
        let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
        for (name, text) in [("[Content_Types].xml", TYPES), ("_rels/.rels", RELATIONS)] {
            archive.start_file(name, options).map_err(failed)?;
            archive.write_all(text.as_bytes())?;
        }
        archive.start_file("3D/3dmodel.model", options).map_err(failed)?;
        write_model(model, &objects, &mut archive)?;
        let whole = archive.finish().map_err(failed)?.into_inner();
        output.write_all(&whole)?;
        output.flush()?;
        Ok(())
    }

    fn write_model(model: &Model, objects: &PrintObjects, output: &mut impl Write) -> Result<(), Error> {
        let mut text = OPEN.as_bytes().to_vec();
        let colors = Colors::of(model, objects);
        if !colors.places.is_empty() {
            text.extend_from_slice(b"<m:colorgroup id=\"1\">\n");
            for [red, green, blue] in colors.places.keys() {
                text.extend_from_slice(
                    format!("<m:color color=\"#{red:02X}{green:02X}{blue:02X}\"/>\n").as_bytes(),
                );
                flush(&mut text, output)?;
            }
            text.extend_from_slice(b"</m:colorgroup>\n");
        }
        for (number, object) in objects.objects.iter().enumerate() {
            let kind = if object.is_closed() { "model" } else { "surface" };
            text.extend_from_slice(format!("<object id=\"{}\" type=\"{kind}\"", number + 2).as_bytes());
            if !object.name.is_empty() {
                text.extend_from_slice(format!(" name=\"{}\"", escaped(&object.name)).as_bytes());
            }
            if !colors.places.is_empty() {
                text.extend_from_slice(b" pid=\"1\" pindex=\"0\"");
            }
            text.extend_from_slice(b"><mesh>\n<vertices>\n");
            for &vertex in &object.vertices {
                text.extend_from_slice(b"<vertex");
                for (axis, x) in ["x", "y", "z"].into_iter().zip(point(model, vertex)) {
                    text.extend_from_slice(format!(" {axis}=\"").as_bytes());
                    push_f64(&mut text, x);
                    text.push(b'"');
                }
                text.extend_from_slice(b"/>\n");
                flush(&mut text, output)?;
            }
            text.extend_from_slice(b"</vertices>\n<triangles>\n");
            for triangle in &object.triangles {
                let [a, b, c] = triangle;
                text.extend_from_slice(format!("<triangle v1=\"{a}\" v2=\"{b}\" v3=\"{c}\"").as_bytes());
                if !colors.places.is_empty() {
                    let [a, b, c] = triangle.map(|corner| colors.place(object.vertices[corner as usize]));
                    text.extend_from_slice(format!(" pid=\"1\" p1=\"{a}\" p2=\"{b}\" p3=\"{c}\"").as_bytes());
                }
                text.extend_from_slice(b"/>\n");
                flush(&mut text, output)?;
            }
            text.extend_from_slice(b"</triangles>\n</mesh></object>\n");
        }
        text.extend_from_slice(b"</resources>\n<build>\n");
        for number in 0..objects.objects.len() {
            text.extend_from_slice(format!("<item objectid=\"{}\"/>\n", number + 2).as_bytes());
        }
        text.extend_from_slice(b"</build>\n</model>\n");
        output.write_all(&text)?;
        Ok(())
    }

    /// The different colors of vertices, with their places in the list of all.
    struct Colors<'a> {
        model: &'a Model,
        places: BTreeMap<[u8; 3], usize>,
    }

    impl<'a> Colors<'a> {
        fn of(model: &'a Model, objects: &PrintObjects) -> Self {
            let used = objects.objects.iter().flat_map(|object| &object.vertices);
            let colors = used.filter_map(|&vertex| Some((color(model, vertex)?, 0)));
            let mut places: BTreeMap<[u8; 3], usize> = colors.collect();
            for (place, own) in places.values_mut().enumerate() {
                *own = place;
            }
            Self { model, places }
        }

        fn place(&self, vertex: u32) -> usize {
            color(self.model, vertex).map_or(0, |color| self.places[&color])
        }
    }
}

#[cfg(feature = "archives")]
mod reading {
    use crate::scene::{LooseMesh, Placement, Scene};
    use crate::unpacking::most_unpacked;
    use crate::xml_text::{document, numbers};
    use crate::{Model, Remark, RemarkCode};
    use coface_algebra::{Error, ErrorKind};
    use roxmltree::Node;
    use std::collections::BTreeMap;
    use std::io::{Cursor, Read};

    pub(super) fn read(mut input: impl Read) -> Result<Model, Error> {
        let mut bytes = Vec::new();
        input.read_to_end(&mut bytes)?;
        // Of all parts together: parts may share their bytes in the archive.
        let mut left = most_unpacked(bytes.len() as u64);
        let damaged = |error: zip::result::ZipError| {
            Error::parse(format!("the ZIP archive is damaged: {error}")).with_cure("write it again")
        };
        let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).map_err(damaged)?;
        let names: Vec<String> = archive.file_names().map(str::to_owned).collect();
        let mut parts: BTreeMap<String, String> = BTreeMap::new();
        for name in names.iter().filter(|name| name.to_ascii_lowercase().ends_with(".model")) {
            let part = archive.by_name(name).map_err(damaged)?;
            let mut text = String::new();
            part.take(left + 1).read_to_string(&mut text).map_err(|error| {
                Error::parse(format!("the part {} cannot be read: {error}", name.escape_debug()))
                    .with_cure("write the file again")
            })?;
            left = left.checked_sub(text.len() as u64).ok_or_else(|| {
                Error::new(ErrorKind::TooLarge, "the parts are far larger than the archive")
                    .with_cure("the file is no model: check where it comes from")
            })?;
            parts.insert(name.trim_start_matches('/').to_owned(), text);
        }
        let root =
            parts.keys().find(|name| name.eq_ignore_ascii_case("3D/3dmodel.model")).or(parts.keys().next());
        let Some(root) = root.cloned() else {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                "this is a ZIP archive without a 3D model in it",
            )
            .with_cure("unpack it and name the file of the model"));
        };
        let mut objects = BTreeMap::new();
        let mut items = Vec::new();
        let mut beams = 0;
        for (name, text) in &parts {
            let document = document(text)?;
            refuse_unknown_extensions(document.root_element())?;
            for node in document.descendants().filter(|node| node.is_element()) {
                match node.tag_name().name() {
                    "object" => {
                        let id = node.attribute("id").unwrap_or_default().to_owned();
                        let object = object(node, name)?;
                        beams += object.mesh.lines.len();
                        objects.insert((name.clone(), id), object);
                    }
                    "item" if *name == root => items.push(reference(node, name)?),
                    _ => {}
                }
            }
        }
        if items.is_empty() {
            let is_mesh = |object: &Object| !object.mesh.polygons.is_empty() || !object.mesh.lines.is_empty();
            let meshes = objects.iter().filter(|(_, object)| is_mesh(object));
            items = meshes.map(|(key, _)| (key.clone(), Placement::IDENTITY)).collect();
        }
        let mut scene = Scene::of_size(parts.values().map(String::len).sum());
        for (key, placement) in &items {
            place(&objects, key, *placement, 0, &mut scene)?;
        }
        let mut model = scene.finish()?;
        if beams > 0 {
            let message = match beams {
                1 => "1 beam is read as a line, without its radius".to_owned(),
                count => format!("{count} beams are read as lines, without their radii"),
            };
            model.remarks.push(Remark::new(RemarkCode::DataLeftOut, message));
        }
        Ok(model)
    }

    /// Extensions that say nothing of shapes, or that are read: the parts of their namespaces that name them.
    const EXTENSIONS: [&str; 6] =
        ["/core/", "/material/", "/production/", "/beamlattice/", "/slice/", "/trianglesets/"];

    /// Refuses a part that may not be read without an extension that is not known here.
    fn refuse_unknown_extensions(root: Node<'_, '_>) -> Result<(), Error> {
        for prefix in root.attribute("requiredextensions").unwrap_or_default().split_whitespace() {
            let namespace = root.lookup_namespace_uri(Some(prefix)).unwrap_or(prefix);
            if !EXTENSIONS.iter().any(|known| namespace.contains(known)) {
                let name: String = namespace.chars().take(100).flat_map(char::escape_default).collect();
                return Err(Error::new(
                    ErrorKind::UnsupportedFormat,
                    format!("the file may not be read without the extension {name}, which is not known here"),
                )
                .with_cure("export it without that extension"));
            }
        }
        Ok(())
    }

    type Key = (String, String);

    struct Object {
        name: String,
        mesh: LooseMesh,
        components: Vec<(Key, Placement)>,
    }

    fn object(node: Node<'_, '_>, part: &str) -> Result<Object, Error> {
        let mut mesh = LooseMesh::default();
        let mut components = Vec::new();
        for node in node.descendants().filter(|node| node.is_element()) {
            match node.tag_name().name() {
                "vertex" => {
                    let mut point = [0.0; 3];
                    for (axis, x) in ["x", "y", "z"].into_iter().zip(&mut point) {
                        *x = number(node, axis)?;
                    }
                    mesh.points.push(point);
                }
                name @ ("triangle" | "beam") => {
                    let corners: &[&str] = if name == "beam" { &["v1", "v2"] } else { &["v1", "v2", "v3"] };
                    let mut vertices = Vec::with_capacity(3);
                    for corner in corners {
                        let vertex = number(node, corner)?;
                        if !(vertex >= 0.0 && vertex < mesh.points.len() as f64 && vertex.fract() == 0.0) {
                            return Err(Error::invalid(format!(
                                "a {name} names vertex {vertex}, but its mesh has {} vertices, numbered from 0",
                                mesh.points.len()
                            ))
                            .with_cure("write the file again"));
                        }
                        vertices.push(vertex as u32);
                    }
                    if name == "beam" { mesh.lines.push(vertices) } else { mesh.polygons.push(vertices) }
                }
                "component" => components.push(reference(node, part)?),
                _ => {}
            }
        }
        let name = node.attribute("name").unwrap_or_default().to_owned();
        Ok(Object { name, mesh, components })
    }

    /// The object that an item or a component places, and where.
    fn reference(node: Node<'_, '_>, part: &str) -> Result<(Key, Placement), Error> {
        let id = node.attribute("objectid").unwrap_or_default().to_owned();
        // The production extension names the part that the object is in.
        let path = node.attributes().find(|attribute| attribute.name() == "path").map(|path| path.value());
        let part = path.map_or(part, |path| path.trim_start_matches('/')).to_owned();
        let placement = match node.attribute("transform") {
            None => Placement::IDENTITY,
            Some(text) => {
                let numbers = numbers(text)?;
                let Ok(m) = <[f64; 12]>::try_from(numbers) else {
                    return Err(
                        Error::parse("a transform needs 12 numbers").with_cure("write the file again")
                    );
                };
                // Points are rows there: the last row is the translation.
                Placement(std::array::from_fn(|row| std::array::from_fn(|column| m[3 * column + row])))
            }
        };
        Ok(((part, id), placement))
    }

    fn number(node: Node<'_, '_>, name: &str) -> Result<f64, Error> {
        let value = node.attribute(name).and_then(|text| text.trim().parse::<f64>().ok());
        value.filter(|value| value.is_finite()).ok_or_else(|| {
            Error::parse(format!("the attribute {name} of a {} is no finite number", node.tag_name().name()))
                .with_cure("write the file again")
        })
    }

    fn place(
        objects: &BTreeMap<Key, Object>,
        key: &Key,
        placement: Placement,
        depth: usize,
        scene: &mut Scene,
    ) -> Result<(), Error> {
        let Some(object) = objects.get(key) else {
            return Err(Error::invalid(format!("the object {} is not there", key.1.escape_debug()))
                .with_cure("write the file again"));
        };
        scene.step(depth)?;
        if !object.mesh.points.is_empty() || object.components.is_empty() {
            scene.place(&object.mesh, placement, &object.name)?;
        }
        for (component, inner) in &object.components {
            place(objects, component, placement.after(*inner), depth + 1, scene)?;
        }
        Ok(())
    }
}
