//! Scenes as glTF, for programs that show models.

use super::palette::{Color, LIGHT, color_of_bytes};
use super::scene_picture::{lines_of, shown};
use crate::Scene;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use coface_algebra::{Error, ErrorKind};
use coface_io::{Remark, single_precision_remark};
use serde_json::{Value, json};

/// The two forms of glTF files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GltfForm {
    /// `.glb`: one binary file.
    Binary,
    /// `.gltf`: JSON, with the numbers in it as base64.
    Json,
}

/// What the numbers of a primitive are, as glTF names it.
#[derive(Clone, Copy)]
enum Mode {
    Points = 0,
    Lines = 1,
    Triangles = 4,
}

/// A scene as glTF 2.0: its triangles (without those between two 3-cells), seen from both sides and shaded flat, lines and points that lie on no polygon, and a node for each layer
/// that is shown, in its color. [Texture coordinates](coface_io::Model::texture_coordinates) of the model are kept. Colors of vertices take the place of the color of the surface; they are red, green and blue as in style sheets.
///
/// Positions have 32 bits around the middle of the scene, which is the translation of its nodes.
///
/// # Errors
/// [`ErrorKind::Shape`] unless there is a color for each vertex; [`ErrorKind::TooLarge`] beyond 4 gigabytes.
///
/// # Complexity
/// $O(n \log n)$ in the cells.
///
/// # References
/// Khronos Group, *glTF 2.0 Specification* (ISO/IEC 12113:2022).
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_pictures::{GltfForm, Scene, gltf};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
/// let bytes = gltf(&Scene::of("triangle", &triangle)?, None, GltfForm::Binary)?;
/// assert!(bytes.starts_with(b"glTF") && bytes.len().is_multiple_of(4));
/// # Ok(()) }
/// ```
pub fn gltf(scene: &Scene, colors: Option<&[[u8; 3]]>, form: GltfForm) -> Result<Vec<u8>, Error> {
    if let Some(colors) = colors
        && colors.len() != scene.positions().len()
    {
        let message = format!("there are {} colors for {} vertices", colors.len(), scene.positions().len());
        return Err(Error::new(ErrorKind::Shape, message).with_cure("give each vertex one color"));
    }
    let mut file = Builder { middle: middle(scene.positions()), ..Builder::default() };
    let (_, wires, dots) = lines_of(scene);
    let positions = file.positions(scene.positions());
    let mut shading: Vec<(&str, usize)> = Vec::new();
    shading.extend(colors.map(|colors| ("COLOR_0", file.colors(colors))));
    if !scene.texture().is_empty() {
        shading.push(("TEXCOORD_0", file.texture(scene.texture())));
    }
    let surface = file.material(if colors.is_some() { [1.0; 3] } else { LIGHT.surface });
    let outer;
    let triangles = if scene.has_cells() {
        outer = outer_triangles(scene);
        &outer[..]
    } else {
        scene.triangles()
    };
    let mut parts = Vec::new();
    for (mode, indices) in [
        (Mode::Triangles, triangles.as_flattened()),
        (Mode::Lines, wires.as_flattened()),
        (Mode::Points, &dots[..]),
    ] {
        let material = match (mode, colors) {
            (Mode::Triangles, _) | (_, Some(_)) => surface,
            _ => file.material(LIGHT.ink),
        };
        file.primitive(mode, positions, &shading, indices, material, &mut parts);
    }
    file.node(scene.title(), &parts);
    for (layer, color) in shown(scene) {
        let positions = match &layer.positions {
            Some(own) => file.positions(own),
            None => positions,
        };
        let material = file.material(color);
        let lines: Vec<u32> =
            layer.lines.iter().flat_map(|line| line.windows(2)).flatten().copied().collect();
        let mut parts = Vec::new();
        for (mode, indices) in [
            (Mode::Triangles, layer.triangles.as_flattened()),
            (Mode::Lines, &lines[..]),
            (Mode::Points, &layer.points[..]),
        ] {
            file.primitive(mode, positions, &[], indices, material, &mut parts);
        }
        file.node(&layer.name, &parts);
    }
    file.finish(form)
}

/// What [`gltf`] rounds of the positions of a scene: how many vertices move, and how far. None where all are kept as they are.
///
/// # Complexity
/// Linear in the vertices.
///
/// # Examples
/// The vertices 0, 1 and 2^-60 have the middle one half, and near it 2^-60 is 0 in 32 bits.
/// ```
/// use coface_io::Format;
/// use coface_pictures::{Scene, gltf_rounding};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let scene = |x: f64| {
///     let text = format!("v 0 0 0\nv 1 0 0\nv {x} 1 0\nf 1 2 3\n");
///     Scene::of("triangle", &coface_io::read(text.as_bytes(), Format::Obj)?)
/// };
/// assert!(gltf_rounding(&scene(0.25)?).is_none());
/// let remark = gltf_rounding(&scene(0.5f64.powi(60))?).expect("a vertex moves");
/// assert_eq!(remark.count, 1);
/// # Ok(()) }
/// ```
pub fn gltf_rounding(scene: &Scene) -> Option<Remark> {
    let middle = middle(scene.positions());
    single_precision_remark(scene.positions().iter().map(|&point| {
        let near = near(point, middle);
        [point, [0, 1, 2].map(|axis| middle[axis] + f64::from(near[axis]))]
    }))
}

/// A position around the middle in 32 bits.
fn near(point: [f64; 3], middle: [f64; 3]) -> [f32; 3] {
    [0, 1, 2].map(|axis| (point[axis] - middle[axis]) as f32)
}

/// The triangles that are not between two 3-cells.
fn outer_triangles(scene: &Scene) -> Vec<[u32; 3]> {
    let sorted = |mut triangle: [u32; 3]| {
        triangle.sort_unstable();
        triangle
    };
    let mut keys: Vec<[u32; 3]> = scene.triangles().iter().map(|&triangle| sorted(triangle)).collect();
    keys.sort_unstable();
    let is_outer = |triangle: &&[u32; 3]| {
        let key = sorted(**triangle);
        let first = keys.partition_point(|other| *other < key);
        keys.get(first + 1) != Some(&key)
    };
    scene.triangles().iter().filter(is_outer).copied().collect()
}

#[derive(Default)]
struct Builder {
    middle: [f64; 3],
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    materials: Vec<Value>,
    meshes: Vec<Value>,
    nodes: Vec<Value>,
}

impl Builder {
    /// Adds numbers of four bytes each; gives the place of their accessor.
    fn numbers(&mut self, bytes: &[u8], target: u32, mut accessor: Value) -> usize {
        self.views.push(json!({
            "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len(), "target": target,
        }));
        self.bytes.extend_from_slice(bytes);
        accessor["bufferView"] = (self.views.len() - 1).into();
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    /// Adds positions; none if there are none.
    fn positions(&mut self, positions: &[[f64; 3]]) -> Option<usize> {
        let near: Vec<[f32; 3]> = positions.iter().map(|&point| near(point, self.middle)).collect();
        let extreme = |pick: fn(f32, f32) -> f32| {
            near.iter().copied().reduce(|a, b| [0, 1, 2].map(|axis| pick(a[axis], b[axis])))
        };
        let (low, high) = (extreme(f32::min)?, extreme(f32::max)?);
        let bytes: Vec<u8> = near.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
        let accessor = json!({
            "componentType": 5126, "count": near.len(), "type": "VEC3", "min": low, "max": high,
        });
        Some(self.numbers(&bytes, 34962, accessor))
    }

    fn colors(&mut self, colors: &[[u8; 3]]) -> usize {
        let linear = colors.iter().flat_map(|&bytes| color_of_bytes(bytes).map(linear));
        let bytes: Vec<u8> = linear.flat_map(f32::to_le_bytes).collect();
        let accessor = json!({ "componentType": 5126, "count": colors.len(), "type": "VEC3" });
        self.numbers(&bytes, 34962, accessor)
    }

    /// Adds texture coordinates; in glTF the second one counts from the top.
    fn texture(&mut self, pairs: &[[f64; 2]]) -> usize {
        let bytes: Vec<u8> =
            pairs.iter().flat_map(|&[s, t]| [s, 1.0 - t]).flat_map(|x| (x as f32).to_le_bytes()).collect();
        let accessor = json!({ "componentType": 5126, "count": pairs.len(), "type": "VEC2" });
        self.numbers(&bytes, 34962, accessor)
    }

    fn material(&mut self, color: Color) -> usize {
        let [red, green, blue] = color.map(linear);
        let material = json!({
            "pbrMetallicRoughness": {
                "baseColorFactor": [red, green, blue, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.9,
            },
            "doubleSided": true,
        });
        match self.materials.iter().position(|other| *other == material) {
            Some(place) => place,
            None => {
                self.materials.push(material);
                self.materials.len() - 1
            }
        }
    }

    fn primitive(
        &mut self,
        mode: Mode,
        positions: Option<usize>,
        shading: &[(&str, usize)],
        indices: &[u32],
        material: usize,
        parts: &mut Vec<Value>,
    ) {
        let Some(positions) = positions.filter(|_| !indices.is_empty()) else { return };
        let bytes: Vec<u8> = indices.iter().flat_map(|index| index.to_le_bytes()).collect();
        let accessor = json!({ "componentType": 5125, "count": indices.len(), "type": "SCALAR" });
        let indices = self.numbers(&bytes, 34963, accessor);
        let mut attributes = json!({ "POSITION": positions });
        for (name, accessor) in shading {
            attributes[*name] = (*accessor).into();
        }
        parts.push(json!({
            "attributes": attributes, "indices": indices, "material": material, "mode": mode as u32,
        }));
    }

    fn node(&mut self, name: &str, parts: &[Value]) {
        if parts.is_empty() {
            return;
        }
        self.meshes.push(json!({ "name": name, "primitives": parts }));
        self.nodes.push(json!({
            "name": name, "mesh": self.meshes.len() - 1, "translation": self.middle,
        }));
    }

    fn finish(self, form: GltfForm) -> Result<Vec<u8>, Error> {
        let mut document = json!({
            "asset": { "version": "2.0", "generator": "coface" },
            "scene": 0,
            "scenes": [{}],
        });
        let nodes: Vec<usize> = (0..self.nodes.len()).collect();
        if !nodes.is_empty() {
            document["scenes"][0]["nodes"] = nodes.into();
        }
        // A list in glTF has at least one entry.
        for (key, list) in [
            ("nodes", self.nodes),
            ("meshes", self.meshes),
            ("materials", self.materials),
            ("accessors", self.accessors),
            ("bufferViews", self.views),
        ] {
            if !list.is_empty() {
                document[key] = list.into();
            }
        }
        let length = self.bytes.len();
        if length > 0 {
            document["buffers"] = json!([{ "byteLength": length }]);
        }
        if form == GltfForm::Json {
            if length > 0 {
                let text = STANDARD.encode(&self.bytes);
                document["buffers"][0]["uri"] = format!("data:application/octet-stream;base64,{text}").into();
            }
            return Ok(format!("{document}\n").into_bytes());
        }
        let mut text = document.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let has_bytes = length > 0;
        let total = 12 + 8 + text.len() + if has_bytes { 8 + length } else { 0 };
        let too_large = || {
            Error::new(ErrorKind::TooLarge, format!("a .glb of {total} bytes; it holds 2^32 - 1"))
                .with_cure("write .ply or .vtu")
        };
        let total_32 = u32::try_from(total).map_err(|_| too_large())?;
        let mut file = Vec::with_capacity(total);
        file.extend_from_slice(b"glTF");
        file.extend(2u32.to_le_bytes());
        file.extend(total_32.to_le_bytes());
        file.extend((text.len() as u32).to_le_bytes());
        file.extend_from_slice(b"JSON");
        file.extend(text);
        if has_bytes {
            file.extend((length as u32).to_le_bytes());
            file.extend_from_slice(b"BIN\0");
            file.extend(self.bytes);
        }
        Ok(file)
    }
}

/// The part of a color as a share of light: glTF mixes light, style sheets have the steps of eyes (IEC 61966-2-1).
fn linear(part: f32) -> f32 {
    if part <= 0.04045 { part / 12.92 } else { ((part + 0.055) / 1.055).powf(2.4) }
}

/// The middle of the box around points; the origin without points.
fn middle(positions: &[[f64; 3]]) -> [f64; 3] {
    [0, 1, 2].map(|axis| {
        let (low, high) = positions
            .iter()
            .map(|point| point[axis])
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        if low <= high { 0.5 * low + 0.5 * high } else { 0.0 }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_io::{Format, read};

    fn scene() -> Scene {
        let text = b"v 10 0 0\nv 11 0 0\nv 10 1 0\nv 10 0 3\nv 9 9 9\nf 1 2 3\nl 3 4\n";
        Scene::of("t", &read(&text[..], Format::Obj).unwrap()).unwrap()
    }

    #[test]
    fn the_rules_of_the_format_are_kept() {
        let mut scene = scene();
        let result = json!({"generators": [[], [{"order": 0, "chain": [[1, [0, 1]], [1, [1, 2]]]}]]});
        scene.add_result("r", &result).unwrap();
        let bytes = gltf(&scene, Some(&[[255, 0, 0]; 5]), GltfForm::Binary).unwrap();
        let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!((number(4), number(8)), (2, bytes.len()));
        let text = number(12);
        assert!(text.is_multiple_of(4) && &bytes[16..20] == b"JSON");
        let document: Value = serde_json::from_slice(&bytes[20..20 + text]).unwrap();
        let binary = &bytes[20 + text + 8..];
        assert_eq!((number(20 + text), &bytes[24 + text..28 + text]), (binary.len(), &b"BIN\0"[..]));
        let mut end = 0;
        for view in document["bufferViews"].as_array().unwrap() {
            let start = view["byteOffset"].as_u64().unwrap();
            assert!(start == end && start.is_multiple_of(4));
            end += view["byteLength"].as_u64().unwrap();
        }
        assert_eq!(end as usize, binary.len());
        // Triangles, a line and a point, then the generator.
        let modes = |mesh: usize| -> Vec<u64> {
            let parts = document["meshes"][mesh]["primitives"].as_array().unwrap();
            parts.iter().map(|part| part["mode"].as_u64().unwrap()).collect()
        };
        assert_eq!((modes(0), modes(1)), (vec![4, 1, 0], vec![1]));
        let positions = &document["accessors"][0];
        assert_eq!(
            (&positions["min"], &positions["max"]),
            (&json!([-1., -4.5, -4.5]), &json!([1., 4.5, 4.5]))
        );
        assert_eq!(document["nodes"][0]["translation"], json!([10., 4.5, 4.5]));
        assert!(gltf(&scene, Some(&[[0; 3]]), GltfForm::Json).is_err());
    }

    #[test]
    fn nothing_is_a_whole_file() {
        let empty = Scene::of("t", &read(&b"OFF 0 0 0\n"[..], Format::Off).unwrap()).unwrap();
        let text = gltf(&empty, None, GltfForm::Json).unwrap();
        let document: Value = serde_json::from_slice(&text).unwrap();
        assert!(document.get("buffers").is_none() && document.get("nodes").is_none());
        assert!(gltf(&empty, None, GltfForm::Binary).unwrap().len().is_multiple_of(4));
    }
}
