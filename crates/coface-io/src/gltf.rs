//! glTF 2.0 (`.gltf` and `.glb`): the meshes of its scene. It is written by the pictures, not as a model.

use crate::Model;
use coface_algebra::Error;
use std::io::Read;

/// Reads all meshes of a glTF or GLB file, each where its node places it; without nodes, all meshes as they stand. Points of a mesh at one place
/// are one, for the format splits them where normals or textures differ. The mesh of a node with a name is a [`Group`](crate::Group) of
/// polygons. Skins are at rest, and targets of morphing are left out.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for what is no glTF; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput)
/// for numbers outside their buffer or a buffer that is another file, which [`crate::read_path`] reads if it lies in the same folder or below;
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) for meshes that are compressed.
///
/// # Complexity
/// Linear in the file and the placed meshes.
///
/// # References
/// Khronos Group, *glTF 2.0 specification* (2021).
///
/// # Examples
/// ```
/// assert!(coface_io::gltf::read(&b"{}"[..]).is_err());
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    read_in(input, None)
}

/// Refuses every file: this build lacks the feature `gltf`.
#[cfg(not(feature = "gltf"))]
pub(crate) fn read_in(
    _input: impl Read,
    _companions: Option<&crate::files::Companions>,
) -> Result<Model, Error> {
    Err(crate::features::without_feature("glTF", "gltf"))
}

#[cfg(feature = "gltf")]
pub(crate) use reading::read_in;

#[cfg(feature = "gltf")]
mod reading {
    use crate::files::Companions;
    use crate::scene::{LooseMesh, Placement, Scene};
    use crate::{Model, Remark, RemarkCode};
    use base64::Engine;
    use coface_algebra::{Error, ErrorKind};
    use gltf::accessor::{DataType, Dimensions};
    use gltf::buffer::Source;
    use gltf::mesh::Mode;
    use serde_json::Value;
    use std::collections::HashSet;
    use std::io::Read;
    use std::path::Path;

    /// Beyond so many, all primitives together may have `RATIO` numbers for each byte of the buffers: they may share them.
    const FREE: usize = 1 << 22;
    const RATIO: usize = 64;

    /// Where numbers come from, and how many may still be read.
    struct Numbers<'b> {
        buffers: &'b [Vec<u8>],
        left: usize,
    }

    /// Reads a file whose other files lie in this folder or below.
    pub(crate) fn read_in(mut input: impl Read, companions: Option<&Companions>) -> Result<Model, Error> {
        let mut bytes = Vec::new();
        input.read_to_end(&mut bytes)?;
        let (text, blob) = chunks(&bytes)?;
        let text = essential(text)?;
        check_accessors(&text)?;
        let file = gltf::Gltf::from_slice(&text).map_err(|error| {
            let message: String =
                error.to_string().chars().take(200).flat_map(char::escape_default).collect();
            Error::parse(format!("this is no sound glTF: {message}")).with_cure("export the file again")
        })?;
        let document = &file.document;
        let mut buffers = Vec::new();
        for buffer in document.buffers() {
            buffers.push(match buffer.source() {
                Source::Bin => blob.map(<[u8]>::to_vec).unwrap_or_default(),
                Source::Uri(uri) if uri.starts_with(ZEROS) => zeros(uri)?,
                Source::Uri(uri) => bytes_of(uri, companions)?,
            });
        }
        let size: usize = buffers.iter().map(Vec::len).sum();
        let mut source = Numbers { buffers: &buffers, left: FREE.max(size.saturating_mul(RATIO)) };
        let mut meshes = Vec::new();
        for mesh in document.meshes() {
            meshes.push(loose_mesh(&mesh, &mut source)?.welded());
        }
        let mut scene = Scene::of_size(bytes.len().saturating_add(size));
        match document.default_scene().or_else(|| document.scenes().next()) {
            Some(start) => {
                for node in start.nodes() {
                    place(&node, Placement::IDENTITY, 0, &meshes, &mut scene)?;
                }
            }
            None => {
                for mesh in document.meshes() {
                    let name = mesh.name().unwrap_or_default();
                    scene.place(&meshes[mesh.index()], Placement::IDENTITY, name)?;
                }
            }
        }
        let mut model = scene.finish()?;
        if document.meshes().next().is_none() {
            let message = "the file has no mesh, so there is nothing to read";
            model.remarks.push(Remark::new(RemarkCode::EmptyInput, message));
        }
        Ok(model)
    }

    /// The bytes before the first chunk of a GLB, and those before the data of a chunk.
    const HEADER: usize = 12;
    const CHUNK: usize = 8;

    /// The JSON and the numbers of a file: all of a `.gltf`, or the first chunks of a GLB. What is behind these is left out.
    fn chunks(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), Error> {
        if !bytes.starts_with(b"glTF") {
            return Ok((bytes, None));
        }
        let cut = |what: &str| {
            Error::parse(format!("the file ends in {what}"))
                .at_byte(bytes.len() as u64)
                .with_cure("it was cut short: export it again")
        };
        let number = |at: usize| -> Option<usize> {
            let four = bytes.get(at..at + 4)?;
            usize::try_from(u32::from_le_bytes(four.try_into().ok()?)).ok()
        };
        let (Some(version), Some(length)) = (number(4), number(8)) else {
            return Err(cut("its header of 12 bytes"));
        };
        if version != 2 {
            let message = format!("this is version {version} of the binary form of glTF; 2 is read");
            return Err(Error::new(ErrorKind::UnsupportedFormat, message).with_cure("convert it to glTF 2.0"));
        }
        if length < HEADER + CHUNK {
            let message = format!("the header says that the file has {length} bytes, which is too few");
            return Err(Error::parse(message).at_byte(8).with_cure("export the file again"));
        }
        if length > bytes.len() {
            return Err(cut(&format!("the middle: its header says {length} bytes")));
        }
        let chunk = |start: usize| -> Option<(&[u8], &[u8], usize)> {
            let data = start.checked_add(CHUNK)?;
            let end = data.checked_add(number(start)?)?;
            let kind = bytes.get(start + 4..data)?;
            Some((kind, bytes.get(data..end.min(length))?, end)).filter(|_| end <= length)
        };
        let Some((b"JSON", text, end)) = chunk(HEADER) else {
            return Err(Error::parse("the first chunk is no JSON, or ends behind the file")
                .at_byte(HEADER as u64)
                .with_cure("export the file again"));
        };
        if end == length {
            return Ok((text, None));
        }
        match chunk(end) {
            Some((b"BIN\0", numbers, _)) => Ok((text, Some(numbers))),
            Some(_) => Ok((text, None)),
            None => Err(cut("its second chunk")),
        }
    }

    /// Refuses primitives whose positions are an accessor that is not there: the parser takes it to be there before it looks. What is no JSON is
    /// left to the parser.
    fn check_accessors(text: &[u8]) -> Result<(), Error> {
        let Ok(root) = gltf::json::deserialize::from_slice::<gltf::json::Root>(text) else { return Ok(()) };
        let count = root.accessors.len();
        let primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives);
        let mut accessors = primitives.flat_map(|primitive| primitive.attributes.values());
        match accessors.find(|accessor| accessor.value() >= count) {
            Some(accessor) => Err(Error::invalid(format!(
                "a mesh names accessor {}, but there are {count}, numbered from 0",
                accessor.value()
            ))
            .with_cure("export the file again")),
            None => Ok(()),
        }
    }

    /// Extensions without which there are no positions or corners to read.
    const COMPRESSIONS: [&str; 3] =
        ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"];

    /// The URI of a buffer of so many zeros begins with this: no file has it.
    const ZEROS: &str = "coface:zeros/";
    const MOST_ZEROS: u64 = (FREE * 8) as u64;

    fn zeros(uri: &str) -> Result<Vec<u8>, Error> {
        let count: Option<usize> = uri.strip_prefix(ZEROS).and_then(|count| count.parse().ok());
        match count {
            Some(count) if count as u64 <= MOST_ZEROS => Ok(vec![0; count]),
            _ => Err(Error::new(ErrorKind::TooLarge, "a mesh has far more numbers than its file")
                .with_cure("export the file again, with its positions")),
        }
    }

    /// What of the JSON says where meshes are, and nothing else: materials, animations, skins, `extras` and the like may be as they want. Lists of nodes that
    /// scenes lack and bounds of positions are added, whole numbers that are written as fractions are whole, and an accessor without a view has one of zeros.
    ///
    /// # Errors
    /// `Parse` for what is no JSON; `UnsupportedFormat` for glTF 1.0, and for meshes that are compressed.
    fn essential(text: &[u8]) -> Result<Vec<u8>, Error> {
        let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
        let mut root: Value = serde_json::from_slice(text.trim_ascii_end()).map_err(|error| {
            let message: String =
                error.to_string().chars().take(200).flat_map(char::escape_default).collect();
            Error::parse(format!("this is no sound glTF: {message}")).with_cure("export the file again")
        })?;
        let unsupported = |message: String, cure: &str| {
            Err(Error::new(ErrorKind::UnsupportedFormat, message).with_cure(cure))
        };
        // There meshes, nodes and the like are objects by name, not lists.
        if root.get("meshes").is_some_and(Value::is_object) {
            return unsupported("this is glTF 1.0, which is not read".to_owned(), "convert it to glTF 2.0");
        }
        let names = |list: &str| -> Vec<String> {
            let names = root.get(list).and_then(Value::as_array).into_iter().flatten();
            names.filter_map(Value::as_str).map(str::to_owned).collect()
        };
        if let Some(name) =
            names("extensionsRequired").iter().find(|name| COMPRESSIONS.contains(&name.as_str()))
        {
            let message = format!("the meshes are compressed ({name}), which is not read");
            return unsupported(message, "export the file without compression of meshes");
        }
        let is_compressed = names("extensionsUsed").iter().any(|name| COMPRESSIONS.contains(&name.as_str()));
        keep(
            &mut root,
            &[
                "asset",
                "scene",
                "scenes",
                "nodes",
                "meshes",
                "accessors",
                "bufferViews",
                "buffers",
                "extensionsRequired",
            ],
        );
        whole_numbers(&mut root);
        if let Some(required) = root.get_mut("extensionsRequired").and_then(Value::as_array_mut) {
            let is_of_paint = |name: &str| {
                ["_material", "_texture", "_technique", "_lights", "_animation"]
                    .iter()
                    .any(|word| name.contains(word))
            };
            // Coordinates that are whole numbers are read anyway.
            let is_known = |name: &str| is_of_paint(name) || name == "KHR_mesh_quantization";
            required.retain(|name| !name.as_str().is_some_and(is_known));
        }
        if let Some(asset) = root.get_mut("asset") {
            keep(asset, &["version", "minVersion"]);
        }
        for scene in objects(&mut root, "scenes") {
            scene.retain(|name, _| matches!(name.as_str(), "nodes" | "name"));
            scene.entry("nodes").or_insert_with(|| Value::Array(Vec::new()));
        }
        for node in objects(&mut root, "nodes") {
            let is_kept = |name: &str| {
                matches!(name, "mesh" | "children" | "matrix" | "translation" | "rotation" | "scale" | "name")
            };
            node.retain(|name, _| is_kept(name));
        }
        let mut positions = HashSet::new();
        for mesh in objects(&mut root, "meshes") {
            mesh.retain(|name, _| matches!(name.as_str(), "primitives" | "name"));
            let primitives = mesh.get_mut("primitives").and_then(Value::as_array_mut);
            for primitive in primitives.into_iter().flatten() {
                keep(primitive, &["attributes", "indices", "mode"]);
                // Of the attributes only positions are read, and others may have any names.
                if let Some(attributes) = primitive.get_mut("attributes") {
                    keep(attributes, &["POSITION"]);
                    positions.extend(attributes["POSITION"].as_u64());
                }
            }
        }
        for list in ["bufferViews", "buffers"] {
            for part in objects(&mut root, list) {
                part.retain(|name, _| {
                    matches!(name.as_str(), "buffer" | "byteOffset" | "byteLength" | "byteStride" | "uri")
                });
            }
        }
        let mut empty = Vec::new();
        for (number, accessor) in (0..).zip(objects(&mut root, "accessors")) {
            accessor.retain(|name, _| !matches!(name.as_str(), "extras" | "extensions" | "name"));
            if positions.contains(&number) {
                for bound in ["min", "max"] {
                    accessor.entry(bound).or_insert_with(|| serde_json::json!([0.0, 0.0, 0.0]));
                }
            }
            if !accessor.contains_key("bufferView") && !accessor.contains_key("sparse") {
                empty.push(number as usize);
            }
        }
        if is_compressed && !empty.is_empty() {
            let message = "a mesh has no positions in its buffers, as where meshes are compressed";
            return unsupported(message.to_owned(), "export the file without compression of meshes");
        }
        for number in empty {
            add_zeros(&mut root, number);
        }
        serde_json::to_vec(&root).map_err(|error| Error::parse(error.to_string()))
    }

    /// Gives an accessor a view of zeros.
    fn add_zeros(root: &mut Value, number: usize) {
        let accessor = &root["accessors"][number];
        let size = match accessor["componentType"].as_u64() {
            Some(5120 | 5121) => 1,
            Some(5122 | 5123) => 2,
            _ => 4,
        };
        let components = if accessor["type"] == "SCALAR" { 1 } else { 16 };
        let count = accessor["count"].as_u64().unwrap_or(0).saturating_mul(size * components).max(1);
        let mut push = |list: &str, item: Value| -> usize {
            if !root[list].is_array() {
                root[list] = Value::Array(Vec::new());
            }
            let Some(items) = root[list].as_array_mut() else { return 0 };
            items.push(item);
            items.len() - 1
        };
        let buffer =
            push("buffers", serde_json::json!({ "byteLength": count, "uri": format!("{ZEROS}{count}") }));
        let view = push("bufferViews", serde_json::json!({ "buffer": buffer, "byteLength": count }));
        root["accessors"][number]["bufferView"] = view.into();
    }

    /// Keeps these members of an object.
    fn keep(object: &mut Value, names: &[&str]) {
        if let Some(object) = object.as_object_mut() {
            object.retain(|name, _| names.contains(&name.as_str()));
        }
    }

    /// Whole numbers as such: `1.0` is 1.
    fn whole_numbers(value: &mut Value) {
        match value {
            Value::Number(number) => {
                if let Some(real) = number.as_f64().filter(|_| number.is_f64())
                    && real.fract() == 0.0
                    && real.abs() < 9e15
                {
                    *value = (real as i64).into();
                }
            }
            Value::Array(items) => items.iter_mut().for_each(whole_numbers),
            Value::Object(members) => members.values_mut().for_each(whole_numbers),
            _ => {}
        }
    }

    /// The objects in a list of the root.
    fn objects<'a>(
        root: &'a mut Value,
        list: &str,
    ) -> impl Iterator<Item = &'a mut serde_json::Map<String, Value>> {
        root.get_mut(list)
            .and_then(Value::as_array_mut)
            .into_iter()
            .flatten()
            .filter_map(Value::as_object_mut)
    }

    fn place(
        node: &gltf::Node<'_>,
        outer: Placement,
        depth: usize,
        meshes: &[LooseMesh],
        scene: &mut Scene,
    ) -> Result<(), Error> {
        scene.step(depth)?;
        let columns = node.transform().matrix().map(|column| column.map(f64::from));
        let placement = outer.after(Placement::from_columns(columns));
        if let Some(mesh) = node.mesh() {
            let name = node.name().or(mesh.name()).unwrap_or_default();
            scene.place(&meshes[mesh.index()], placement, name)?;
        }
        for child in node.children() {
            place(&child, placement, depth + 1, meshes, scene)?;
        }
        Ok(())
    }

    /// The bytes that a URI names: in itself, or a regular file in the folder or below.
    fn bytes_of(uri: &str, companions: Option<&Companions>) -> Result<Vec<u8>, Error> {
        let shown: String = uri.chars().take(60).flat_map(char::escape_default).collect();
        if let Some(data) = uri.strip_prefix("data:") {
            let coded = data.split_once(";base64,").map(|(_, coded)| coded.trim());
            let bytes = coded.and_then(|coded| base64::engine::general_purpose::STANDARD.decode(coded).ok());
            return bytes.ok_or_else(|| {
                Error::parse("a buffer that stands in the file is not in base64")
                    .with_cure("export the file again")
            });
        }
        let refused = |why: &str| {
            Err(Error::invalid(format!("the buffer {shown} {why}"))
                .with_cure("put it into the folder of the file, or export the model as one file (.glb)"))
        };
        let Some(companions) = companions else {
            return refused("is another file, and the place of this one is not known");
        };
        let name = percent_decoded(uri);
        if name.contains("://") {
            return refused("is no file of this machine");
        }
        let mut bytes = Vec::new();
        let read = companions.open(Path::new(&name)).and_then(|mut file| Ok(file.read_to_end(&mut bytes)?));
        read.map_err(|error| {
            let message = format!("the buffer {shown}: {}", error.message());
            Error::new(error.kind(), message)
                .with_cure(error.cure().unwrap_or("export the model as one file (.glb)").to_owned())
        })?;
        Ok(bytes)
    }

    /// The text with `%20` replaced by a blank, and so on.
    fn percent_decoded(text: &str) -> String {
        let mut bytes = Vec::with_capacity(text.len());
        let mut rest = text.as_bytes();
        while let [first, tail @ ..] = rest {
            let digits =
                tail.get(..2).filter(|_| *first == b'%').and_then(|two| std::str::from_utf8(two).ok());
            if let Some(byte) = digits.and_then(|digits| u8::from_str_radix(digits, 16).ok()) {
                bytes.push(byte);
                rest = &tail[2..];
            } else {
                bytes.push(*first);
                rest = tail;
            }
        }
        String::from_utf8_lossy(&bytes).into_owned()
    }

    fn loose_mesh(mesh: &gltf::Mesh<'_>, source: &mut Numbers<'_>) -> Result<LooseMesh, Error> {
        let mut loose = LooseMesh::default();
        for primitive in mesh.primitives() {
            let first = loose.points.len() as u32;
            if let Some(positions) = primitive.get(&gltf::Semantic::Positions) {
                let numbers = numbers(&positions, 3, source)?;
                loose.points.extend(numbers.chunks_exact(3).map(|point| [point[0], point[1], point[2]]));
            }
            let count = loose.points.len() as u32 - first;
            let corners: Vec<u32> = match primitive.indices() {
                Some(indices) => {
                    numbers(&indices, 1, source)?.into_iter().map(|index| index as u32).collect()
                }
                None => (0..count).collect(),
            };
            if let Some(index) = corners.iter().find(|&&index| index >= count) {
                return Err(Error::invalid(format!("an index is {index}, but there are {count} positions"))
                    .with_cure("export the file again, without compression of meshes"));
            }
            let corners: Vec<u32> = corners.into_iter().map(|index| first + index).collect();
            let strip = |i: usize, c: &[u32]| vec![c[i % 2], c[1 - i % 2], c[2]];
            match primitive.mode() {
                Mode::Points => loose.singles.extend(corners),
                Mode::Lines => loose.lines.extend(corners.chunks_exact(2).map(<[u32]>::to_vec)),
                Mode::LineLoop if corners.len() > 1 => {
                    let closed = corners.iter().copied().chain([corners[0]]).collect();
                    loose.lines.push(closed);
                }
                Mode::LineStrip if corners.len() > 1 => loose.lines.push(corners),
                Mode::LineLoop | Mode::LineStrip => {}
                Mode::Triangles => loose.polygons.extend(corners.chunks_exact(3).map(<[u32]>::to_vec)),
                Mode::TriangleStrip => {
                    // Triangles that repeat a vertex only join strips.
                    let triangles = corners.windows(3).enumerate().map(|(i, c)| strip(i, c));
                    loose.polygons.extend(triangles.filter(|t| t[0] != t[1] && t[1] != t[2] && t[2] != t[0]));
                }
                Mode::TriangleFan => {
                    loose
                        .polygons
                        .extend(corners.windows(2).skip(1).map(|pair| vec![corners[0], pair[0], pair[1]]));
                }
            }
        }
        Ok(loose)
    }

    /// The numbers of an accessor, each row of so many.
    fn numbers(
        accessor: &gltf::Accessor<'_>,
        components: usize,
        source: &mut Numbers<'_>,
    ) -> Result<Vec<f64>, Error> {
        let buffers = source.buffers;
        let expected = if components == 3 { Dimensions::Vec3 } else { Dimensions::Scalar };
        if accessor.dimensions() != expected {
            return Err(Error::invalid("an accessor has another number of components than its use asks for")
                .with_cure("export the file again"));
        }
        let (kind, count) = (accessor.data_type(), accessor.count());
        source.left = source.left.checked_sub(count.saturating_mul(components)).ok_or_else(|| {
            Error::new(ErrorKind::TooLarge, "the meshes have far more numbers than the buffers")
                .with_cure("export the file again, with fewer primitives that share their positions")
        })?;
        let mut values = match accessor.view() {
            Some(view) => {
                let row = components * kind.size();
                let stride = view.stride().unwrap_or(row).max(row);
                rows(&view, accessor.offset(), stride, row, count, buffers)?
                    .flat_map(|bytes| bytes.chunks_exact(kind.size()).map(|bytes| value(kind, bytes)))
                    .collect()
            }
            // All zeros, but for sparse values.
            None => vec![0.0; count * components],
        };
        if let Some(sparse) = accessor.sparse() {
            let (indices, replacing) = (sparse.indices(), sparse.values());
            let size = match indices.index_type() {
                gltf::accessor::sparse::IndexType::U8 => DataType::U8,
                gltf::accessor::sparse::IndexType::U16 => DataType::U16,
                gltf::accessor::sparse::IndexType::U32 => DataType::U32,
            };
            let row = components * kind.size();
            let some = sparse.count();
            let (index_view, value_view) = (indices.view(), replacing.view());
            let at = rows(&index_view, indices.offset(), size.size(), size.size(), some, buffers)?;
            let new = rows(&value_view, replacing.offset(), row, row, some, buffers)?;
            for (at, new) in at.zip(new) {
                let start = value(size, at) as usize * components;
                let Some(place) = values.get_mut(start..start + components) else {
                    return Err(
                        Error::invalid("a sparse value is outside its accessor").with_cure("export it again")
                    );
                };
                for (place, bytes) in place.iter_mut().zip(new.chunks_exact(kind.size())) {
                    *place = value(kind, bytes);
                }
            }
        }
        if accessor.normalized() {
            let largest = match kind {
                DataType::I8 => 127.0,
                DataType::U8 => 255.0,
                DataType::I16 => 32767.0,
                DataType::U16 => 65535.0,
                DataType::U32 | DataType::F32 => 1.0,
            };
            values.iter_mut().for_each(|value| *value = (*value / largest).max(-1.0));
        }
        Ok(values)
    }

    /// So many rows of bytes, each checked to be in its buffer.
    fn rows<'b>(
        view: &gltf::buffer::View<'_>,
        offset: usize,
        stride: usize,
        length: usize,
        count: usize,
        buffers: &'b [Vec<u8>],
    ) -> Result<impl Iterator<Item = &'b [u8]> + use<'b>, Error> {
        let buffer = buffers.get(view.buffer().index()).map(Vec::as_slice).unwrap_or_default();
        let end = view.offset().checked_add(view.length()).filter(|&end| end <= buffer.len());
        let bytes = end.and_then(|end| buffer.get(view.offset()..end)?.get(offset..));
        let needed = match count {
            0 => Some(0),
            _ => (count - 1).checked_mul(stride).and_then(|before| before.checked_add(length)),
        };
        match (bytes, needed) {
            (Some(bytes), Some(needed)) if needed <= bytes.len() => {
                Ok((0..count).map(move |i| &bytes[i * stride..i * stride + length]))
            }
            _ => Err(Error::invalid("numbers of a mesh are outside their buffer")
                .with_cure("the file is cut short: export it again")),
        }
    }

    fn value(kind: DataType, bytes: &[u8]) -> f64 {
        match (kind, bytes) {
            (DataType::I8, &[a]) => f64::from(a as i8),
            (DataType::U8, &[a]) => f64::from(a),
            (DataType::I16, &[a, b]) => f64::from(i16::from_le_bytes([a, b])),
            (DataType::U16, &[a, b]) => f64::from(u16::from_le_bytes([a, b])),
            (DataType::U32, &[a, b, c, d]) => f64::from(u32::from_le_bytes([a, b, c, d])),
            (DataType::F32, &[a, b, c, d]) => f64::from(f32::from_le_bytes([a, b, c, d])),
            _ => f64::NAN,
        }
    }
}

#[cfg(all(test, feature = "gltf"))]
mod tests {
    use super::read;

    const TRIANGLE: &str = r#""buffers": [{"byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36.0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0.0, "_HEAT": 7}, "extras": 3}]}],
        "nodes": [{"mesh": 0, "camera": 9}], "scenes": [{"nodes": [0]}]"#;

    fn binary(text: &str) -> Vec<u8> {
        let mut text = text.as_bytes().to_vec();
        text.resize(text.len().next_multiple_of(4), b' ');
        let numbers: Vec<u8> =
            [0f32, 0., 0., 1., 0., 0., 0., 1., 0.].iter().flat_map(|x| x.to_le_bytes()).collect();
        let mut bytes = b"glTF\x02\0\0\0".to_vec();
        bytes.extend((12 + 8 + text.len() as u32 + 8 + 36).to_le_bytes());
        bytes.extend((text.len() as u32).to_le_bytes());
        bytes.extend(b"JSON");
        bytes.extend(text);
        bytes.extend(36u32.to_le_bytes());
        bytes.extend(b"BIN\0");
        bytes.extend(numbers);
        bytes
    }

    fn whole() -> Vec<u8> {
        binary(&format!(
            r#"{{"asset": {{"version": "2.0", "extras": []}}, "accessors": [{{"bufferView": 0, "componentType": 5126.0, "count": 3.0, "type": "VEC3"}}],
            "animations": [{{"channels": [{{"sampler": 0, "target": {{"path": "pointer"}}}}], "samplers": []}}], {TRIANGLE}}}"#
        ))
    }

    #[test]
    fn what_is_no_mesh_may_be_as_it_wants() {
        let model = read(&whole()[..]).unwrap();
        assert_eq!((model.vertex_count(), model.polygons().len()), (3, 1));
        let longer = [&whole()[..], b"more"].concat();
        assert_eq!(read(&longer[..]).unwrap(), model);
        let zeros = binary(&format!(
            r#"{{"asset": {{"version": "2.0"}}, "accessors": [{{"componentType": 5126, "count": 3, "type": "VEC3"}}], {TRIANGLE}}}"#
        ));
        assert_eq!(read(&zeros[..]).unwrap().vertex_count(), 1, "all at the origin");
        let nothing = r#"{"asset": {"version": "2.0"}, "nodes": [{"name": "lamp"}]}"#;
        assert!(read(nothing.as_bytes()).unwrap().remarks()[0].message.contains("no mesh"));
    }

    #[test]
    fn headers_that_lie_are_refused() {
        let whole = whole();
        for length in 0..whole.len() as u32 {
            let mut bytes = whole.clone();
            bytes[8..12].copy_from_slice(&length.to_le_bytes());
            assert!(read(&bytes[..]).is_err(), "{length}");
            assert!(read(&whole[..length as usize]).is_err(), "{length}");
        }
        let mut first = whole;
        first[4] = 1;
        assert!(read(&first[..]).unwrap_err().to_string().contains("version 1"));
    }
}
